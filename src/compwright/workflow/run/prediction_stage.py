"""Last stage of a run: predict the next tests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from compwright.controls.decoded_state import DecodedState
from compwright.controls.gantries import skew_findings
from compwright.controls.judged_corrections import active_corrections, applied_correction
from compwright.foundations.findings import Finding
from compwright.foundations.parallel_work import Each, in_turn
from compwright.planning import axis_tasks
from compwright.planning.axis_work import AxisWork
from compwright.planning.circles import CircleWork, predicted_circle
from compwright.planning.limit_decisions import circle_decisions
from compwright.planning.predicted_gain import judged_parameter
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections, Correction
from compwright.records.job import AS_FOUND
from compwright.records.prediction import AxisPrediction, CirclePrediction, TestPrediction
from compwright.workflow.run.estimate_stage import Wanted
from compwright.workflow.run.export_stage import Written, tables_of
from compwright.workflow.run.input_stage import Measured
from compwright.workflow.run.table_stage import Fitted


@dataclass(frozen=True, slots=True, kw_only=True)
class Predicted:
    """The predictions for axes and circles, and findings on gantries whose two axes have different
    tables.
    """

    axes: Mapping[str, AxisPrediction]
    circles: Mapping[str, CirclePrediction]
    findings: tuple[Finding, ...] = ()


def predicted(
    measured: Measured, wanted: Wanted, fitted: Fitted, written: Written, each: Each = in_turn
) -> Predicted:
    """Predict new tests of all axes and circles. An axis with a new table is predicted with the
    table as read from the written files, an axis without one with its present correction.
    """
    loaded, job = written.loaded, measured.job
    tasks = []
    for work in written.works.values():
        planned = work.planned
        has = planned.fitted is not None and loaded is not None
        table = loaded.state.axes[planned.axis.address] if has and loaded is not None else None
        tasks.append((work, after_loading(work, loaded), table, job))
    axes = dict(zip(written.works, each(axis_tasks.predict_task, tasks), strict=True))
    then = _active_after(measured, fitted, written) if wanted.circles else NO_CORRECTIONS
    skews: tuple[Finding, ...] = ()
    if measured.as_found is not None:
        tabled = [axis for axis, _ in tables_of(written.works, fitted.scales)]
        gains = {name: _gain(prediction.tests[0]) for name, prediction in axes.items()}
        skews = tuple(skew_findings(tabled, measured.as_found, loaded, gains))
    return Predicted(
        axes=axes,
        circles={work.name: _circle(work, measured, then) for work in wanted.circles},
        findings=skews,
    )


def _gain(test: TestPrediction) -> float:
    """Return by how much (mm or deg) the new table reduces the main parameter, such as A or E."""
    name = judged_parameter(test.before)
    was = None if name is None else test.before.parameters[name]
    if name is None or was is None:
        return 0.0
    return abs(was) - abs(test.predicted[name].median)


def after_loading(work: AxisWork, loaded: DecodedState | None) -> Correction:
    """Return the correction of an axis after loading: that of its new table or, if it gets none,
    its present correction.
    """
    return (
        work.as_found
        if work.planned.fitted is None
        else applied_correction(loaded, work.planned.axis)
    )


def _circle(work: CircleWork, measured: Measured, then: ActiveCorrections) -> CirclePrediction:
    """Predict a circular test after loading, from the test before loading and the change of the
    active corrections. ``then``: the corrections that are active after loading.
    """
    during = measured.active.get(work.planned.measured_in, NO_CORRECTIONS)
    prediction = predicted_circle(work.result, work.planned, during, then)
    rule = measured.job.decision_rule
    return replace(prediction, accept=circle_decisions(work.planned.accept, prediction, rule))


def _active_after(measured: Measured, fitted: Fitted, written: Written) -> ActiveCorrections:
    """Return the corrections that are active after loading, along axes and between axes."""
    now, after = measured.active.get(AS_FOUND, NO_CORRECTIONS), written.cross.after
    along = {
        axis.name: applied_correction(written.loaded, axis)
        for axis, _ in tables_of(written.works, fitted.scales)
    }
    across = now.across if after is None else active_corrections(after, measured.axes).across
    typed = (entry for entry in written.cross.planned if entry.typed)
    return ActiveCorrections({**now.along, **along}, across).with_added(typed)
