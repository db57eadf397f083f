"""Refuse measurements that cannot belong to their axis, before a table is made from them.

`evaluation.plausibility` judges a single test. This module needs the job, because it compares the
test with the travel of the axis and with the axis' other tests.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations

import numpy as np

from compwright.evaluation.duplicate_measurements import NamedTest, same_measurement
from compwright.evaluation.plausibility import certain_fault, wrong_target_unit
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, FloatArray
from compwright.records.job import Job
from compwright.records.plan import PlannedTest


def impossible_tests(job: Job, tests: Mapping[str, Sequence[PlannedTest]]) -> list[Fault]:
    """Return the faults of tests whose readings or targets contradict the stated unit or the
    travel, and of measurements between axes whose positions are outside the travel.
    """
    faults = [
        fault
        for axis, planned in tests.items()
        for index, entry in enumerate(planned)
        for fault in _faults(job, axis, index, entry)
    ]
    for index, request in enumerate(job.cross):
        if request.input in job.axes:
            where, place = np.array(request.positions), f"cross[{index}].positions"
            hint = "correct the positions, or `travel` of the axis"
            axis_given = job.axes[request.input].axis
            faults += _outside(axis_given, where, "positions", job.file, place, hint)
    return faults


def _faults(job: Job, axis: str, index: int, planned: PlannedTest) -> Iterator[Fault]:
    test = planned.test
    file = test.sources[0].file if test.sources else test.name
    why = certain_fault(test)
    if why:
        yield Fault(
            message=f"the file is not a measurement of a machine: {why}",
            file=file,
            expected="deviations, measured minus target, in the unit that the file states",
            hint="give the file of the measurement",
        )
    travel = job.axes[axis].axis.travel
    unit = wrong_target_unit(test, travel) if index == 0 else ""
    if unit:
        span = (
            f"{test.targets[-1] - test.targets[0]:.6g} mm of {travel[1] - travel[0]:.6g} mm of"
            " travel"
        )
        yield Fault(
            message=(
                f"the targets are in {unit}: read in mm they span {span}, read in {unit} "
                "they fit the travel"
            ),
            file=file,
            place="targets",
            expected="target positions in mm",
            hint="correct the unit of the targets",
        )
    else:
        hint = "set `position_map: {sense: 1, offset: ...}` of the test, or correct `travel`"
        yield from _outside(job.axes[axis].axis, test.targets, "targets", file, "targets", hint)


def _outside(
    axis: Axis, positions: FloatArray, what: str, file: str, place: str, hint: str
) -> Iterator[Fault]:
    """Yield a fault for ``positions`` (n,), ascending, outside the travel of the axis. ``what``:
    their name in the message.

    They may lie outside by half an interval (or a tenth of the travel), because the travel may be
    rounded; this is a doubt (CW-T007, CW-P170). An endless axis has no position outside.
    """
    low, high = axis.travel
    if axis.endless:
        return
    first, last = float(positions[0]), float(positions[-1])
    interval = (last - first) / max(positions.size - 1, 1)
    if max(low - first, last - high) <= min(0.5 * interval, 0.1 * (high - low)):
        return
    unit = axis.kind.unit
    yield Fault(
        message=f"the {what} are outside the travel of the axis, {low:.10g} to {high:.10g} {unit}",
        file=file,
        place=place,
        expected=f"{what} within the travel, in machine coordinates",
        found=f"{first:.10g} to {last:.10g} {unit}",
        hint=hint,
    )


def given_twice(named: Iterable[NamedTest]) -> list[Fault]:
    """Return a fault for each test that contains a file twice, and for each pair of tests that are
    the same measurement.

    Two tests are the same measurement if their files are equal byte for byte, or if their readings
    scatter and are equal to the last digit.
    """
    every = tuple(named)
    faults = []
    for entry in every:
        seen: dict[str, str] = {}
        for source in entry.sources:
            if source.sha256 in seen:
                faults.append(
                    Fault(
                        message=(
                            f"the file is the same measurement as {seen[source.sha256]}, so "
                            f"{entry.words} contains it twice"
                        ),
                        file=source.file,
                        expected="a file of its own for each measurement",
                        hint="remove one of the two files",
                    )
                )
            seen.setdefault(source.sha256, source.file)
    for one, other in combinations(every, 2):
        if same_measurement(one, other):
            file = other.sources[0].file if other.sources else other.words
            faults.append(
                Fault(
                    message=f"{one.words} and {other.words} come from the same measurement",
                    file=file,
                    expected="a measurement of its own for each",
                    found="the same readings twice",
                    hint="remove one of the two tests",
                )
            )
    return faults


def named_tests(tests: Mapping[str, Sequence[PlannedTest]]) -> list[NamedTest]:
    """Return every positioning test of a job with its name."""
    return [
        NamedTest(f"test {entry.test.name} of axis {axis}", entry.test.sources, entry.test)
        for axis, planned in tests.items()
        for entry in planned
    ]
