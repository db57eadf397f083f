"""Last stage of a job: what the next tests will show."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from compwright.foundations.side_by_side import Each, in_turn
from compwright.planning.axes import AxisWork, fresh_like_first, predict_axis
from compwright.planning.circles import CircleWork, predicted_circle
from compwright.planning.drifting import drift_or_reversal
from compwright.planning.goals import goal_told
from compwright.planning.limiting import what_limits
from compwright.planning.verdict import stopped, verdict
from compwright.planning.worth import worth_of_points
from compwright.prediction.acting import IDLE, Acting, Correction
from compwright.records.correction import AxisCompensation
from compwright.records.job import AS_FOUND
from compwright.records.prediction import AxisPrediction, CirclePrediction
from compwright.workflow.stages.acting import acting, correction_of
from compwright.workflow.stages.control import DecodedState
from compwright.workflow.stages.fitted import Fitted
from compwright.workflow.stages.measured import Measured
from compwright.workflow.stages.wanted import Wanted
from compwright.workflow.stages.written import Written, tables_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Predicted:
    """What fresh tests of the axes and circles will show, by their names."""

    axes: Mapping[str, AxisPrediction]
    circles: Mapping[str, CirclePrediction]


def predicted(
    measured: Measured, wanted: Wanted, fitted: Fitted, written: Written, each: Each = in_turn
) -> Predicted:
    """Return what fresh tests will show with the tables as read back, or with what is in the
    control now where there are none.
    """
    loaded, rule = written.loaded, measured.job.decision_rule
    tasks = []
    for work in written.works.values():
        planned = work.planned
        has = planned.fitted is not None and loaded is not None
        table = loaded.state.axes[planned.axis.address] if has and loaded is not None else None
        tasks.append((work, after_loading(work, loaded), table, rule))
    axes = dict(zip(written.works, each(_predicted, tasks), strict=True))
    then = _acting_then(measured, fitted, written) if wanted.circles else IDLE
    return Predicted(
        axes=axes, circles={work.name: _circle(work, measured, then) for work in wanted.circles}
    )


def _predicted(
    task: tuple[AxisWork, Correction, AxisCompensation | None, Literal["simple", "guarded"]],
) -> AxisPrediction:
    """Return what fresh tests of an axis will show, what keeps it where it is, and whether a table
    helps.
    """
    work, new, _, rule = task
    fresh = fresh_like_first(work, rule)
    axis, prediction = work.planned.axis, predict_axis(*task, fresh)
    findings = (
        *prediction.findings,
        *goal_told(work, new, fresh),
        *drift_or_reversal(work, fresh),
    )
    limits = what_limits(work, new, fresh)
    if limits is None:
        return replace(prediction, findings=findings)
    tabled = work.planned.fitted is not None
    # Of a table that was fitted, not of an axis whose tests contradict its files.
    refused = bool(work.refused) and work.capacity is not None
    said = (
        (stopped(axis, limits),)
        if work.stops
        else tuple(verdict(axis, limits, tabled=tabled, refused=refused))
    )
    return replace(
        prediction,
        limits=limits,
        worth=worth_of_points(work, new, fresh, limits.parameter),
        findings=(*findings, *said),
    )


def after_loading(work: AxisWork, loaded: DecodedState | None) -> Correction:
    """Return what acts on an axis after loading: its table as read back, or what acts now."""
    return (
        work.as_found if work.planned.fitted is None else correction_of(loaded, work.planned.axis)
    )


def _circle(work: CircleWork, measured: Measured, then: Acting) -> CirclePrediction:
    """Predict a circle from the state it was measured in to what acts after loading."""
    during = measured.acting.get(work.planned.measured_in, IDLE)
    return predicted_circle(work.result, work.planned, during, then)


def _acting_then(measured: Measured, fitted: Fitted, written: Written) -> Acting:
    """Return what acts after loading, on the axes and between them."""
    now, after = measured.acting.get(AS_FOUND, IDLE), written.cross.after
    along = {
        axis.name: correction_of(written.loaded, axis)
        for axis, _ in tables_of(written.works, fitted.scales)
    }
    return Acting(
        {**now.along, **along},
        now.across if after is None else acting(after, measured.axes).across,
    )
