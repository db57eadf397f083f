"""Tests of one axis in different motions (at cutting feed, at rapid traverse), for which a control
may use different backlash values.

A table is made for the motion of the first test (``Axis.motion``). A new table changes both
backlash values by the same amount. So their difference is active, before and after loading, in
every test at the other motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from compwright.foundations.errors import Fault
from compwright.prediction.active_corrections import Correction, sum_of_corrections
from compwright.records.axis import Axis, Direction, FloatArray, Motion
from compwright.records.correction import ControlState
from compwright.records.job import AS_FOUND, Job
from compwright.records.plan import PlannedTest


def backlash_more(axis: Axis, motion: Motion, state: ControlState | None) -> float:
    """Return the backlash value for ``motion`` minus the value for the usual motion of the axis
    (cutting feed or rapid traverse), mm or deg; 0 if unknown.
    """
    if state is None or motion == axis.motion:
        return 0.0
    more = state.facts_of(axis.address).rapid_more or 0.0
    return more if motion == "rapid" else -more


def with_motion(correction: Correction, axis: Axis, more: float) -> Correction:
    """Return a correction with backlash larger by ``more``, mm or deg, opposite to the reference
    return.
    """

    def shift(positions: FloatArray, direction: Direction) -> FloatArray:
        compensated = direction is not axis.reference_return
        return np.full(np.shape(positions), direction.sign * more if compensated else 0.0)

    return correction if more == 0.0 else sum_of_corrections(correction, shift)


def with_backlash(
    tests: tuple[PlannedTest, ...], axis: Axis, states: Mapping[str, ControlState]
) -> tuple[PlannedTest, ...]:
    """Return the tests, each with its backlash value minus the backlash value for the usual motion
    of the axis (cutting feed or rapid traverse).

    The values are those of the control's present state or, if that is unknown, of the state of the
    test.
    """
    return tuple(
        replace(
            test,
            backlash_more=backlash_more(
                axis, test.motion, states.get(AS_FOUND, states.get(test.measured_in))
            ),
        )
        for test in tests
    )


def unknown_motions(job: Job, states: Mapping[str, ControlState]) -> Iterator[Fault]:
    """Yield a fault for each test in another motion (cutting feed or rapid traverse) than the first
    test, if the control's files do not state the backlash value for this motion.
    """
    for name, entry in job.axes.items():
        for request in entry.before:
            state = states.get(request.measured_in)
            if state is None or request.motion == entry.axis.motion:
                continue
            if state.facts_of(entry.axis.address).rapid_more is None:
                yield Fault(
                    message=(
                        f"axis {name}: one test was measured at cutting feed, another at rapid "
                        "traverse, and no given file shows whether the control uses "
                        "a different backlash compensation at rapid traverse"
                    ),
                    file=job.file,
                    place=f"axes.{name}.before, test {request.name}, motion",
                    expected="the control's whole parameter file, or all tests at the same feed",
                    found=f"motion: {request.motion} of test {request.name}",
                    hint=(
                        "add the control's whole parameter file to its files (`states` or "
                        "`--state`), or keep only the tests at cutting feed or only those at "
                        "rapid traverse"
                    ),
                )
