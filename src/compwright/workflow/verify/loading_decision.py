"""Decide from a test after loading how the planned table was loaded, such as not at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.controls.control import Control
from compwright.estimation.observed_test import ObservedTest
from compwright.planning.motions import with_motion
from compwright.planning.temperature_slopes import relative_to_first, slope_after
from compwright.planning.wanted_correction import (
    MeasuredError,
    axis_compensation,
    measured_error,
    observed_tests,
)
from compwright.prediction.active_corrections import no_correction
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import ControlState, no_compensation
from compwright.records.job import Job
from compwright.records.noise import NoiseDraws
from compwright.records.plan import PlannedAxis
from compwright.records.positioning import PositioningTest
from compwright.records.verification import LoadingVerdict
from compwright.verification.hypothesis import Loading
from compwright.verification.likelihood import after_means, belief_of, draws_for
from compwright.verification.loading import judge_loading
from compwright.verification.loading_hypotheses import loading_hypotheses
from compwright.verification.measurement_cases import (
    UNLIKE,
    MeasurementCase,
    measurement_cases,
    other_axis_case,
    unit_cases,
)
from compwright.words.sentences import say


def judged_loading(
    job: Job,
    control: Control,
    planned: PlannedAxis,
    test: PositioningTest,
    place: int,
    observed: Sequence[ObservedTest],
    posterior: MeasuredError,
    stored: ControlState,
    others: Mapping[str, PlannedAxis],
    *,
    read_back: bool,
) -> LoadingVerdict:
    """Return the verdict on how the table was loaded, from a ``test`` after loading that repeats
    the test with the index ``place`` in the plan. ``others``: the other axes of the plan, whose
    tables can be loaded in place of this one; ``control``: in the state of its files before.

    ``observed``, ``posterior``: the tests before and the error estimated from them. ``stored``: the
    contents of the control before, with its tables switched on. ``read_back``: whether the table
    read back from the control is that of the plan.
    """
    if planned.fitted is None:
        return LoadingVerdict(
            verdict="undecided",
            margin=0.0,
            sentence=say("loading.no_table"),
        )
    error = _judged_against(planned, observed, posterior)
    view, noise = _view(control, planned, test, place, error, stored, others, read_back=read_back)
    after = after_means(test, noise)
    slope = slope_after(job, planned.tests, test) if test.kind is AxisKind.LINEAR else None
    views = [
        view,
        *measurement_cases(view, both=test.bidirectional),
    ]

    louder = after.sigma / error.noise
    units = unit_cases(view, louder)
    if not 1.0 / UNLIKE < louder < UNLIKE:
        views += units

    def further() -> list[MeasurementCase]:
        return [
            *units,
            *(
                other_axis_case(
                    name, _view(control, other, test, 0, _error_of(other), stored, {})[0]
                )
                for name, other in others.items()
                if other.tests and other.fitted is not None and other.axis.kind is test.kind
            ),
        ]

    return judge_loading(after, views, declared_slope=slope, further=further, read_back=read_back)


def _view(
    control: Control,
    planned: PlannedAxis,
    test: PositioningTest,
    place: int,
    error: MeasuredError,
    stored: ControlState,
    others: Mapping[str, PlannedAxis],
    *,
    read_back: bool = False,
) -> tuple[MeasurementCase, NoiseDraws]:
    axis, fitted = planned.axis, planned.fitted
    draws = error.draw(test.targets, draws_for(test.targets.size), np.random.default_rng(0), place)
    none = no_compensation(axis.address, axis.kind, axis.reference_return)
    loading = Loading(
        new=control.format.stored_table(
            axis, none if fitted is None else applied_compensation(fitted.compensation, axis)
        ),
        old=axis_compensation(stored, axis),
        active_before=none if planned.active is None else planned.active,
        others={
            name: control.format.stored_table(other.axis, other.fitted.compensation)
            for name, other in others.items()
            if other.fitted is not None
        },
        reference=axis.reference,
        always=_motion(planned, place, test.targets),
        read_back=read_back,
    )
    view = MeasurementCase(
        belief=belief_of(draws.positive, draws.negative),
        hypotheses=loading_hypotheses(loading, test.targets),
    )
    return view, draws.noise


def _motion(planned: PlannedAxis, place: int, targets: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the reversal correction, in + and −, that the control makes at the feed of the
    repeated test in addition to that at the axis's usual feed. ``place``: the index of the repeated
    test in the plan.
    """
    more = with_motion(no_correction, planned.axis, planned.tests[place].backlash_more)
    return more(targets, Direction.POSITIVE), more(targets, Direction.NEGATIVE)


def _error_of(planned: PlannedAxis) -> MeasuredError:
    observed = observed_tests(planned.tests, planned.active)
    return measured_error(planned.tests, observed, planned.axis, planned.active)


def _judged_against(
    planned: PlannedAxis, observed: Sequence[ObservedTest], posterior: MeasuredError
) -> MeasuredError:
    """Return the error of the axis, estimated again so that the uncertain slope of each earlier
    test is relative to the slope of the first test; the given ``posterior`` if that changes
    nothing.

    The difference of slope between the first test and the test after loading is then a single
    unknown.
    """
    relative = relative_to_first(planned.tests)
    if all(one.slope_std == each.slope_std for one, each in zip(relative, observed, strict=True)):
        return posterior
    sloped = [
        replace(each, slope_std=one.slope_std) for one, each in zip(relative, observed, strict=True)
    ]
    return measured_error(relative, sloped, planned.axis, planned.active)
