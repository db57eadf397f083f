"""``run``: evaluate, estimate, fit, export, read back, predict, report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from compwright import __version__
from compwright.documents.decode import assumed_documents, finding_documents
from compwright.documents.json_text import to_json
from compwright.documents.plan import listed_files, plan_document
from compwright.documents.prediction import prediction_document
from compwright.evaluation.repeats import Named
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding, doubts_of
from compwright.foundations.provenance import fingerprint
from compwright.foundations.utf8 import encoded
from compwright.jobs.idle_keys import idle_keys
from compwright.records.axis import Axis
from compwright.records.circular import CircularTest
from compwright.records.correction import Assumption, ControlFile
from compwright.records.fitted import FittedTable
from compwright.records.job import Job
from compwright.records.plan import Plan, PlannedAxis
from compwright.records.prediction import AxisPrediction, CirclePrediction
from compwright.workflow.showing.card import card_document, changes_csv
from compwright.workflow.showing.view import evaluations, run_view
from compwright.workflow.stages.circle_checks import Checks
from compwright.workflow.stages.circle_scale import scale_steps, scaled_axes
from compwright.workflow.stages.circle_work import (
    Acting,
    CircleWork,
    acting,
    checked_axes,
    predict,
    read_circles,
    start_circles,
    worse_circles,
)
from compwright.workflow.stages.control import (
    Control,
    DecodedState,
    decode,
    named_axes,
    open_control,
    origin_of,
    settled_by_files,
)
from compwright.workflow.stages.cross import plan_cross
from compwright.workflow.stages.cross_tables import CrossOutcome, write_planned
from compwright.workflow.stages.inputs import JobInputs, read_job_inputs
from compwright.workflow.stages.own_output import refuse_own_output
from compwright.workflow.stages.plausible import given_twice, impossible_tests, named_tests
from compwright.workflow.stages.work import (
    AS_FOUND,
    AxisWork,
    correction_of,
    export,
    fit_all,
    predict_axis,
    start_axis,
    write_fitted,
)

NO_STATE = (
    "no table is written: the job does not say what is active in the control; "
    "add states: {as_found: none} or states: {as_found: [files of the control]}"
)
NO_STATE_OPTION = (
    "--state: no table is written without the state of the control; add --state none, or --state"
    " with each of its files"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class RunOutcome:
    """What a run found and wrote. ``no_tables`` and ``refused`` (by axis) say why a table is
    missing.
    """

    exit_code: int
    evaluation: Mapping[str, Any]
    prediction: Mapping[str, Any]
    assumed: tuple[Mapping[str, str], ...]
    findings: tuple[Mapping[str, str], ...]
    files: tuple[Path, ...]
    no_tables: str = ""
    refused: Mapping[str, str]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Finished:
    """Everything that the files of a run are made from."""

    job: Job
    control: Control
    inputs: JobInputs
    works: Mapping[str, AxisWork]
    predictions: Mapping[str, AxisPrediction]
    tables: tuple[ControlFile, ...]
    loaded: DecodedState | None
    assumed: tuple[Assumption, ...]
    circles: tuple[CircleWork, ...]
    circle_predictions: Mapping[str, CirclePrediction]
    cross: CrossOutcome
    scales: Mapping[str, PlannedAxis]
    findings: tuple[Finding, ...]

    @property
    def stated(self) -> bool:
        return AS_FOUND in self.inputs.states


def run_job(
    job: Job,
    folder: Path,
    out: Path,
    *,
    force: bool = False,
    accept_worse: bool = False,
    json_path: Path | None = None,
) -> RunOutcome:
    """Do a whole job and write its files below ``out`` (and the prediction to ``json_path`` too),
    all of them or none.

    ``folder``: what the job's paths are relative to. Raises UsageError (2), InputError (3),
    CapacityError (4) and StorageError (5); nothing is written then. Without a state of the control,
    evaluation, prediction and report are written but no table (exit 2).
    """
    finished = _work_through(job, folder, out, accept_worse=accept_worse)
    tests = [result for work in finished.works.values() for result in work.results]
    evaluation = evaluations(tests, [work.result for work in finished.circles])
    prediction = prediction_document(
        job.format,
        finished.predictions,
        finished.cross.totals,
        finished.circle_predictions,
        _doubts(finished),
    )
    files, notes = _files(finished, evaluation, prediction)
    elsewhere = {} if json_path is None else {json_path: files["prediction.json"]}
    sets = [f"{name}/{job.format}" for name in ("tables", "rollback")]
    known = _known_results(out)
    written = storage.write_files(
        out, files, force=force, elsewhere=elsewhere, whole=sets, renewed=["card"], known=known
    )
    return RunOutcome(
        exit_code=_exit_code(finished),
        evaluation=evaluation,
        prediction=prediction,
        assumed=tuple(assumed_documents(finished.assumed)),
        findings=tuple(finding_documents(_findings(finished))),
        files=tuple(written),
        no_tables=(
            "" if finished.stated else f"{job.file}: {NO_STATE}" if job.file else NO_STATE_OPTION
        ),
        refused={name: work.refused for name, work in finished.works.items() if work.refused},
        notes=notes,
    )


def _work_through(job: Job, folder: Path, out: Path, *, accept_worse: bool) -> _Finished:
    control = open_control(job.format, job.options, origin_of(job))
    job, renamed = named_axes(job, control)
    idle = idle_keys(job, systems=control.format.counts_systems, numbers=control.format.counts_axes)
    inputs, tests = _inputs(job, control, folder)
    job = settled_by_files(job, inputs.states, AS_FOUND)
    axes = {name: entry.axis for name, entry in job.axes.items()}
    measured = [
        (test, request.measured_in) for test, request in zip(tests, job.circles, strict=True)
    ]
    refuse_own_output(job, inputs, measured, folder, out)
    works = {
        name: start_axis(job, entry, inputs) for name, entry in job.axes.items() if entry.before
    }
    circles = start_circles(job, tests, axes)
    tables: tuple[ControlFile, ...] = ()
    loaded: DecodedState | None = None
    by_scale: dict[str, PlannedAxis] = {}
    cross = CrossOutcome(files=())
    findings = idle
    findings += [
        finding for work in circles for finding in (*work.findings, *checked_axes(work, axes))
    ]
    checks = Checks(
        job, works, {name: acting(decoded, axes) for name, decoded in inputs.states.items()}
    )
    findings += checks.findings(circles)
    works, taken = checks.with_circle_backlash(circles)
    findings += taken
    if AS_FOUND in inputs.states:
        as_found = inputs.states[AS_FOUND]
        control = control.in_state(as_found.state)
        works = fit_all(works, control, job.file)
        works, tables, loaded = export(works, control, as_found, accept_worse=accept_worse)
        scaled = scaled_axes(job, circles, checks, control, as_found.state)
        findings += [entry.finding for entry in scaled]
        by_scale = {entry.name: entry.planned for entry in scaled if entry.planned is not None}
        if by_scale:
            tables, loaded = write_fitted(control, _fitted(works, by_scale), as_found)
        plan = plan_cross(job, circles, inputs.states, as_found)
        tabled = [
            axis.name
            for axis, fitted in _fitted(works, by_scale)
            if fitted.compensation.positions.size
        ]
        cross = write_planned(control, plan.planned, tables, as_found, axes, tabled)
        findings += [*plan.findings, *cross.findings]
        cross = replace(cross, steps=(*scale_steps(scaled), *cross.steps))
        if cross.written:
            tables = cross.files
            loaded = decode(control, tables, [axis for axis, _ in _fitted(works, by_scale)])
    states = [decoded.state for decoded in inputs.states.values()]
    capacities = [work.capacity for work in works.values() if work.capacity is not None]
    assumed = (
        *control.assumed(*states),
        *renamed,
        *(entry for state in states for entry in state.assumed),
        *(entry for capacity in capacities for entry in capacity.assumed),
    )
    return _Finished(
        job=job,
        control=control,
        inputs=inputs,
        works=works,
        predictions={
            name: predict_axis(work, loaded, job.decision_rule) for name, work in works.items()
        },
        tables=tables,
        loaded=loaded,
        assumed=assumed,
        circles=circles,
        circle_predictions=_predicted_circles(
            axes, inputs, _fitted(works, by_scale), circles, loaded, cross
        ),
        scales=by_scale,
        cross=cross,
        findings=tuple(findings),
    )


def _fitted(
    works: Mapping[str, AxisWork], scales: Mapping[str, PlannedAxis]
) -> list[tuple[Axis, FittedTable]]:
    """Return every axis that gets a table, those of tests before those of circles."""
    planned = (*(work.planned for work in works.values()), *scales.values())
    return [(entry.axis, entry.fitted) for entry in planned if entry.fitted is not None]


def _inputs(job: Job, control: Control, folder: Path) -> tuple[JobInputs, tuple[CircularTest, ...]]:
    """Read the files of a job. Raises InputError with the faults of all of them."""
    tests: tuple[CircularTest, ...] = ()
    faults: tuple[Fault, ...] = ()
    try:
        tests = read_circles(job, folder)
    except InputError as error:
        faults = error.faults
    try:
        inputs = read_job_inputs(job, control, folder)
    except InputError as error:
        raise InputError(*error.faults, *faults) from error
    raise_all(InputError, list(faults))
    circles = [Named(f"circle {test.name}", test.sources) for test in tests]
    raise_all(
        InputError,
        [
            *impossible_tests(job, inputs.tests),
            *given_twice([*named_tests(inputs.tests), *circles]),
        ],
    )
    return inputs, tests


def _predicted_circles(
    axes: Mapping[str, Axis],
    inputs: JobInputs,
    fitted: Sequence[tuple[Axis, FittedTable]],
    circles: Sequence[CircleWork],
    loaded: DecodedState | None,
    cross: CrossOutcome,
) -> dict[str, CirclePrediction]:
    """Predict every circle from the state it was measured in to what acts after loading."""
    if not circles:
        return {}
    now = acting(inputs.states.get(AS_FOUND), axes)
    along = {axis.name: correction_of(loaded, axis) for axis, _ in fitted}
    then = Acting(
        {**now.along, **along},
        now.across if cross.after is None else acting(cross.after, axes).across,
    )
    return {
        work.name: predict(work, acting(inputs.states.get(work.planned.measured_in), axes), then)
        for work in circles
    }


def _files(
    finished: _Finished, evaluation: Mapping[str, Any], prediction: Mapping[str, Any]
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Return every file of the run by its relative name, and what the user should know about
    missing ones.
    """
    format_id = finished.control.id
    files = {
        "evaluation.json": to_json(evaluation).encode(),
        "prediction.json": to_json(prediction).encode(),
    }
    notes: list[str] = []
    card: Mapping[str, Any] | None = None
    if finished.stated:
        files["plan.json"] = (
            b""  # its place in the order; it is made last, because it lists the others
        )
        files |= {f"tables/{format_id}/{file.name}": file.content for file in finished.tables}
        as_found = finished.inputs.states[AS_FOUND].files
        files |= {f"rollback/{format_id}/{file.name}": file.content for file in as_found}
    if finished.tables or finished.cross.steps:
        card = card_document(
            finished.job,
            finished.control,
            finished.works,
            finished.loaded,
            finished.inputs,
            finished.assumed,
        )
        card = {
            **card,
            "steps": [*card["steps"], *finished.cross.steps],
            "doubts": prediction["doubts"],
            "limits": prediction["axes"],
        }
        from compwright.reporting.card import card_markdown

        files["card/card.md"] = encoded(card_markdown(dict(card)))
        if card["changes"] is not None:
            files["card/changes.csv"] = changes_csv(card["changes"])
        files |= {
            f"card/{file.name}": file.content
            for file in (*_second_forms(finished), *finished.cross.sheets)
        }
    try:
        from compwright.reporting.card import card_html
        from compwright.reporting.report import run_report

        if card is not None:
            files["card/card.html"] = card_html(dict(card))
        view = run_view(
            finished.job,
            finished.control,
            finished.works,
            finished.loaded,
            evaluation=evaluation,
            prediction=prediction,
            assumed=assumed_documents(finished.assumed),
            findings=finding_documents(_findings(finished)),
            files=[*files, "report.html"],
            changes=None if card is None else card["changes"],
            no_tables=None if finished.stated else NO_STATE,
            stated=finished.stated,
            state_files=(
                [file.name for file in finished.inputs.states[AS_FOUND].files]
                if finished.stated
                else []
            ),
        )
        files["report.html"] = run_report(view)
    except UsageError as error:
        notes.append(f"report.html is not written: {error}")
    if finished.stated:
        results = {
            encoded(name).decode(): fingerprint(content)
            for name, content in files.items()
            if name != "plan.json"
        }
        files["plan.json"] = to_json(
            plan_document(replace(_plan(finished), results=results))
        ).encode()
    return files, tuple(notes)


def _known_results(out: Path) -> storage.Known:
    """Return what tells the results of an earlier run in ``out`` from what the user has put or
    changed below it.
    """
    listed = listed_files(storage.earlier_bytes(out / "plan.json"))
    return lambda name, content: (
        "/" not in name or listed.get(encoded(name).decode()) == fingerprint(content)
    )


def _second_forms(finished: _Finished) -> tuple[ControlFile, ...]:
    planned = [work.planned for work in finished.works.values() if work.planned.fitted is not None]
    return finished.control.format.sheets(
        [entry.fitted.compensation for entry in planned if entry.fitted is not None],
        [entry.axis for entry in planned],
    )


def _plan(finished: _Finished) -> Plan:
    job = finished.job
    return Plan(
        version=__version__,
        format=job.format,
        options=finished.control.options,
        standard=job.standard,
        decision_rule=job.decision_rule,
        axes={**{name: work.planned for name, work in finished.works.items()}, **finished.scales},
        states={name: decoded.files for name, decoded in finished.inputs.states.items()},
        active={name: job.active[name] for name in finished.inputs.states if name in job.active},
        machine=job.machine,
        sources=(
            *(
                source
                for tests in finished.inputs.tests.values()
                for planned in tests
                for source in planned.test.sources
            ),
            *(source for work in finished.circles for source in work.planned.test.sources),
        ),
        assumed=finished.assumed,
        cross=finished.cross.planned,
        circles={work.name: work.planned for work in finished.circles},
    )


def _findings(finished: _Finished) -> tuple[Finding, ...]:
    state = [
        finding for decoded in finished.inputs.states.values() for finding in decoded.state.findings
    ]
    axes = (
        finding for prediction in finished.predictions.values() for finding in prediction.findings
    )
    worse = worse_circles(finished.circle_predictions)
    return (*finished.job.findings, *state, *axes, *finished.findings, *worse)


def _doubts(finished: _Finished) -> tuple[Finding, ...]:
    """Return what has to be settled before the table is loaded; findings of tests say which test
    they are of.
    """
    tests = [
        replace(finding, message=f"Axis {name}, test {result.test.name}: {finding.message}")
        for name, work in finished.works.items()
        for result in work.results
        for finding in result.findings
    ]
    return doubts_of([*_findings(finished), *tests])


def _exit_code(finished: _Finished) -> int:
    if not finished.stated:
        return UsageError.exit_code
    # a table refused, a correction not made, a circle that gets worse
    failed = any(
        finding.severity == "error" or finding.code == "CW-P131" for finding in _findings(finished)
    )
    decisions = [
        entry.decision for axis in finished.predictions.values() for entry in axis.accept.values()
    ]
    return 1 if failed or any(decision != "accept" for decision in decisions) else 0
