"""Work on one axis in stages, as functions of one argument that another process can run.

Arguments and results are records of this package and of packages below it. They need neither
commands nor formats, so that such a process starts quickly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from compwright.planning.axis_work import (
    AxisWork,
    predict_axis,
    repeats_of_first,
    start_axis,
    why_no_gain,
)
from compwright.planning.drift_doubts import drift_or_reversal
from compwright.planning.goal_findings import goal_findings
from compwright.planning.limiting_causes import what_limits
from compwright.planning.point_count_tradeoff import point_count_tradeoff
from compwright.planning.second_test import second_test_findings
from compwright.planning.shortfalls import unheld_period
from compwright.planning.table_verdict import no_table_finding, verdict
from compwright.planning.unapplied_steps import unapplied_step_findings
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.job import AxisJob, Job
from compwright.records.plan import PlannedTest
from compwright.records.prediction import AxisPrediction
from compwright.words.sentences import Sentence


def start_task(
    task: tuple[Job, AxisJob, tuple[PlannedTest, ...], Mapping[str, ControlState]],
) -> AxisWork:
    """Return the result of `start_axis`. ``task``: the arguments of that function except the
    present correction, which is taken as zero.
    """
    return start_axis(*task, no_correction)


def gain_task(task: tuple[AxisWork, Correction]) -> Sentence | None:
    """Return the result of `why_no_gain`. ``task``: the arguments of that function."""
    return why_no_gain(*task)


def predict_task(
    task: tuple[AxisWork, Correction, AxisCompensation | None, Job],
) -> AxisPrediction:
    """Return the prediction of new tests of an axis, its limiting causes, and whether a table
    helps. ``task``: the arguments of `predict_axis`.
    """
    work, new, _, job = task
    fitted = work.planned.fitted
    fresh = repeats_of_first(work, job.decision_rule)
    axis, prediction = work.planned.axis, predict_axis(*task, fresh)
    findings = (
        *prediction.findings,
        *goal_findings(work, new, fresh),
        *drift_or_reversal(work, fresh),
        *second_test_findings(work, new, fresh),
        *(
            ()
            if fitted is None
            else unapplied_step_findings(work.planned.axis, fitted.compensation)
        ),
    )
    limits = what_limits(work, new, fresh)
    if limits is None:
        return replace(prediction, findings=findings)
    planned, capacity = work.planned, work.capacity
    tabled = planned.fitted is not None
    if not tabled and planned.wanted is not None and capacity is not None:
        short = unheld_period(planned.wanted, capacity, planned.request)
        findings = (*findings, *((short[1],) if short else ()))
    # Of a table that was fitted, not of an axis whose tests contradict its files.
    refused = bool(work.refused) and work.capacity is not None
    verdicts = (
        (no_table_finding(axis, limits),)
        if work.stops
        else tuple(verdict(axis, limits, tabled=tabled, refused=refused))
    )
    return replace(
        prediction,
        limits=limits,
        worth=point_count_tradeoff(work, new, fresh, limits.parameter),
        findings=(*findings, *verdicts),
    )
