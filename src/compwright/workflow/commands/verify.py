"""``verify``: the test after loading against the plan: before, predicted and after side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from compwright.documents.decode import finding_documents
from compwright.documents.json_text import to_json
from compwright.documents.plan import read_plan
from compwright.documents.verification import (
    ExpectedMeans,
    VerifiedAxis,
    VerifiedCircle,
    verification_document,
)
from compwright.estimation.cells import folded_findings
from compwright.evaluation.decision import decide
from compwright.evaluation.standards import evaluate
from compwright.evaluation.uncertainty import temperature_between
from compwright.foundations import storage
from compwright.foundations.errors import (
    CompwrightError,
    Fault,
    InputError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Direction
from compwright.records.correction import no_compensation
from compwright.records.job import Job, TestRequest
from compwright.records.plan import Plan, PlannedAxis
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import AcceptDecision
from compwright.records.result import PositioningResult
from compwright.records.verification import LoadingVerdict
from compwright.verification.acceptance import overall_verdict
from compwright.verification.loading import judge_loading
from compwright.verification.measurement import NamedFault, measurement_fault, proof_lacking
from compwright.workflow.showing.view import evaluations, verify_view
from compwright.workflow.stages.control import (
    Control,
    DecodedState,
    Origin,
    decode,
    judged,
    named_axes,
    open_control,
    probe_positions,
    read_files,
    settled_by_files,
)
from compwright.workflow.stages.inputs import read_measurement, read_test
from compwright.workflow.stages.outlook import DRAWS, Change, accepted_index, lacking_guard, predict
from compwright.workflow.stages.planning import MeasuredError, measured_error
from compwright.workflow.stages.verify_circles import (
    split_after,
    squareness_decisions,
    verify_circles,
)
from compwright.workflow.stages.verify_proof import (
    AfterTest,
    changed_limits,
    copies,
    doubted,
    not_measured,
    old_circles,
    stale,
    stale_plan,
)
from compwright.workflow.stages.work import AS_FOUND

#: Findings of an axis that say what its test does not prove: the verdict is undecided.
_LACKING = frozenset({"CW-V020", "CW-V021", "CW-V024", "CW-E010"})


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifyOutcome:
    """What ``verify`` found and wrote. ``exit_code`` is 0 only for the verdict ``good``."""

    exit_code: int
    document: Mapping[str, Any]
    files: tuple[Path, ...]
    notes: tuple[str, ...] = ()


def plan_path(given: Path | None, default: Path) -> Path:
    """Return the plan file: ``given`` (a file or the folder of a run) or that of the default
    folder.
    """
    chosen = default if given is None else given
    is_file = storage.is_there(chosen) and not storage.is_folder(chosen)
    return chosen if is_file or chosen.suffix.lower() == ".json" else chosen / "plan.json"


def verify_job(
    job: Job,
    after: Sequence[str],
    *,
    plan_file: Path,
    out: Path,
    loaded: Sequence[Path] = (),
    force: bool = False,
    json_path: Path | None = None,
) -> VerifyOutcome:
    """Judge the tests after loading and write ``verification.json`` and ``verification.html`` into
    ``out``.

    ``after``: ``FILE`` or ``TEST=FILE``, relative to the working directory; ``loaded``:
    what was read back from the control; ``json_path``: the verification once more. Raises
    UsageError (2), InputError (3) and StorageError (5); nothing is written then.
    """
    plan = read_plan(storage.read_bytes(plan_file), str(plan_file))
    control = open_control(plan.format, plan.options, Origin(str(plan_file), "format", "options."))
    raise_all(InputError, _other_format(job, plan, str(plan_file)))
    job, _ = named_axes(job, control)
    known = [entry.axis for entry in plan.axes.values()]
    states = {
        name: decode(control, files, known, active=plan.active.get(name))
        for name, files in plan.states.items()
    }
    job = settled_by_files(job, states, AS_FOUND)
    raise_all(InputError, stale_plan(job, plan, str(plan_file)))
    others, circle_files = split_after(plan, after)
    tests = _after_tests(job, plan, others) if others or not circle_files else []
    as_found = states.get(AS_FOUND) or decode(control, (), known)
    read_back = (
        decode(control, read_files(loaded), [entry.axis for entry in plan.axes.values()])
        if loaded
        else None
    )
    twice = copies(tests)
    axes = {
        test.axis: _verify_axis(
            job, plan.axes[test.axis], test, as_found, read_back, twice.get(test.axis)
        )
        for test in tests
    }
    circles = verify_circles(plan, circle_files, as_found, states)
    squareness = squareness_decisions(circles)
    # Without a positioning test only squareness says whether the tables act.
    loadings = [axis.loading["verdict"] for axis in axes.values()] or ["loaded" for _ in squareness]
    general = [
        *changed_limits(job, plan),
        *not_measured(job, plan, axes, circles),
        *old_circles(plan, circles),
    ]
    lacking = [
        finding for axis in axes.values() for finding in axis.findings if finding.code in _LACKING
    ]
    verdict = overall_verdict(
        [
            *(entry.decision for axis in axes.values() for entry in axis.accept.values()),
            *squareness,
        ],
        loadings,
        still_open=bool(general or lacking),
    )
    if any(finding.severity == "error" for axis in axes.values() for finding in axis.findings):
        verdict = "bad"
    document = verification_document(plan.format, axes, verdict, circles, general)
    files, notes = _files(job, control, axes, circles, document)
    elsewhere = {} if json_path is None else {json_path: files["verification.json"]}
    written = storage.write_files(out, files, force=force, elsewhere=elsewhere)
    return VerifyOutcome(
        exit_code=0 if verdict == "good" else 1,
        document=document,
        files=tuple(written),
        notes=notes,
    )


def _other_format(job: Job, plan: Plan, file: str) -> list[Fault]:
    return [stale("format", job.format, plan.format, file)] if job.format != plan.format else []


def _after_tests(job: Job, plan: Plan, specs: Sequence[str]) -> list[AfterTest]:
    """Read the after tests; several files of one test become one. Raises with every fault at
    once.
    """
    errors: list[CompwrightError] = []
    wanted: dict[tuple[str, str], list[str]] = {}
    for spec in specs:
        try:
            key, path = _assign(job, spec)
            wanted.setdefault(key, []).append(path)
        except CompwrightError as error:
            errors.append(error)
    found = []
    for (axis, name), paths in wanted.items():
        entry = job.axes[axis]
        request = next(item for item in entry.before if item.name == name)
        try:
            test = read_test(job, entry, replace(request, files=tuple(paths)), Path())
        except CompwrightError as error:
            errors.append(error)
            continue
        found.append(AfterTest(axis=axis, test=replace(test, name=name), repeats=name))
    if errors:
        raise max((type(error) for error in errors), key=lambda kind: kind.exit_code)(
            *collect(errors)
        )
    axes = [item.axis for item in found]
    raise_all(
        UsageError,
        [
            Fault(
                message=f"two tests of axis {axis} were given; verify judges one test per axis",
                place="--after",
            )
            for axis in dict.fromkeys(axes)
            if axes.count(axis) > 1
        ]
        + [
            Fault(
                message=f"the plan holds no axis {axis}",
                place="--after",
                expected=", ".join(plan.axes),
            )
            for axis in dict.fromkeys(axes)
            if axis not in plan.axes
        ],
    )
    if not found:
        raise UsageError(
            Fault(
                message="no test to verify",
                place="--after",
                expected="the tests made after loading",
            )
        )
    return found


def _assign(job: Job, spec: str) -> tuple[tuple[str, str], str]:
    """Return (axis, test name) and the path of an ``--after`` value: ``TEST=FILE``, else by the
    file's axis.
    """
    names = {request.name: axis for axis, entry in job.axes.items() for request in entry.before}
    head, mark, tail = spec.partition("=")
    if not spec or (mark and not tail):
        raise UsageError(
            Fault(
                message="names no file",
                place="--after",
                expected="FILE or TEST=FILE",
                found=repr(spec),
            )
        )
    if mark and head in names:
        return (_axis_of_name(job, head, tail), head), tail
    if mark and not storage.is_there(Path(spec)):
        known = " or ".join(names)
        raise UsageError(
            Fault(
                message="is no test of the job",
                place="--after",
                expected=f"{known} before the =",
                found=repr(spec),
            )
        )
    test = read_measurement(Path(spec))
    if test.axis:
        axis = next((name for name in job.axes if name.upper() == test.axis.upper()), None)
        if axis is None:
            raise UsageError(
                Fault(
                    message=f"is a test of axis {test.axis}, which the job does not have",
                    file=spec,
                    expected=", ".join(job.axes),
                )
            )
    elif len(job.axes) == 1:
        axis = next(iter(job.axes))
    else:
        raise UsageError(
            Fault(
                message="does not say which axis it measured",
                file=spec,
                place="--after",
                expected=f"TEST=FILE with TEST one of {', '.join(names)}",
            )
        )
    return (axis, _first(job, axis).name), spec


def _axis_of_name(job: Job, name: str, path: str) -> str:
    """Return the axis of a test name; where several axes use the name, the file says which one it
    is.
    """
    axes = [
        axis
        for axis, entry in job.axes.items()
        if any(request.name == name for request in entry.before)
    ]
    if len(axes) == 1:
        return axes[0]
    measured = read_measurement(Path(path)).axis.upper()
    for axis in axes:
        if axis.upper() == measured:
            return axis
    raise UsageError(
        Fault(
            message=f"several axes have a test {name}",
            file=path,
            place="key axis",
            expected=" or ".join(axes),
            found=measured,
        )
    )


def _first(job: Job, axis: str) -> TestRequest:
    return job.axes[axis].before[0]


def _verify_axis(
    job: Job,
    planned: PlannedAxis,
    after: AfterTest,
    as_found: DecodedState,
    read_back: DecodedState | None,
    twice: NamedFault | None,
) -> VerifiedAxis:
    axis = planned.axis
    before_test = next(
        (entry.test for entry in planned.tests if entry.test.name == after.repeats),
        planned.tests[0].test,
    )
    before, result = (
        evaluate(
            test,
            job.standard,
            travel=axis.travel,
            periods=axis.screw_pitch,
            budget=job.budget(axis.kind),
            thermal=job.thermal,
        )
        for test in (before_test, after.test)
    )
    posterior = measured_error(planned.tests[0].test, axis, planned.active)
    active = planned.active or no_compensation(axis.address, axis.kind, axis.reference_return)

    def unchanged(positions: Any, direction: Direction) -> Any:
        return judged(as_found, axis.address, positions, direction)

    new = unchanged if planned.fitted is None else planned.fitted.compensation.at
    change = Change(new, active.at)
    fault = twice or measurement_fault(after.test, before_test, axis.travel)
    if fault is not None:
        loading = LoadingVerdict(
            verdict="measurement", of=fault.of, margin=0.0, message=fault.message
        )
    else:
        loading = _judge(job, after.test, posterior, change, Change(unchanged, active.at))
    if planned.fitted is None and fault is None:
        loading = replace(
            loading,
            verdict="undecided",
            message="The plan holds no table for this axis: nothing was to be loaded.",
        )
    proof = (
        ()
        if fault
        else (
            *proof_lacking(after.test, before_test),
            *doubted(result, before, guarded=_guarded(job)),
        )
    )
    waves = folded_findings(after.test.targets, axis.screw_pitch, axis.kind.unit)
    accept = _accept(
        job, planned, result, believed=loading.verdict != "measurement", folded=bool(waves)
    )
    lacking = [name for name, entry in accept.items() if _guarded(job) and entry.U is None]
    guard = lacking_guard(axis, result.standard, lacking)
    findings = (
        *loading.findings,
        *_named(loading),
        *proof,
        *waves,
        *guard,
        *_compare_loaded(planned, read_back),
    )
    return VerifiedAxis(
        before=before,
        predicted=predict(result, posterior, change, axis).predicted,
        expected=_expected(result, posterior, change),
        after=result,
        loading={
            "verdict": loading.verdict,
            **({"of": loading.of} if loading.of is not None else {}),
            "equivalent": list(loading.equivalent),
            "factor": loading.factor,
            "shift_nodes": loading.shift_nodes,
            "margin": loading.margin,
            "message": loading.message,
        },
        accept=accept,
        findings=findings,
    )


def _expected(result: PositioningResult, posterior: MeasuredError, change: Change) -> ExpectedMeans:
    targets = result.test.targets
    estimate = posterior.summary(targets)
    positive, negative = (
        (
            estimate.mean(direction) + change.at(targets, direction)
            if result.test.readings(direction).any()
            else np.empty(0)
        )
        for direction in Direction
    )
    return ExpectedMeans(positions=targets, positive=positive, negative=negative, s=estimate.noise)


def _judge(
    job: Job, test: PositioningTest, posterior: MeasuredError, loaded: Change, inactive: Change
) -> LoadingVerdict:
    draws = posterior.draw(test.targets, DRAWS, np.random.default_rng(0))
    estimate = posterior.summary(test.targets)
    expected = {
        direction: (
            estimate.mean(direction) + loaded.at(test.targets, direction),
            estimate.mean(direction) + inactive.at(test.targets, direction),
        )
        for direction in Direction
    }
    return judge_loading(
        test.positive,
        test.negative,
        expected[Direction.POSITIVE][0],
        expected[Direction.NEGATIVE][0],
        expected[Direction.POSITIVE][1],
        expected[Direction.NEGATIVE][1],
        np.cov(np.hstack([draws.positive, draws.negative]), rowvar=False)
        + temperature_between(test, job.budget(test.kind), job.thermal),
        posterior.noise,
        noise_dof=posterior.noise_dof,
        positions=test.targets,
        unit=test.kind.unit,
    )


def _guarded(job: Job) -> bool:
    return job.decision_rule == "guarded"


def _named(loading: LoadingVerdict) -> tuple[Finding, ...]:
    """Return the finding of a fault of measurement (CW-V026)."""
    return (
        (Finding("CW-V026", "warning", loading.message),)
        if loading.verdict == "measurement"
        else ()
    )


def _accept(
    job: Job, planned: PlannedAxis, result: PositioningResult, *, believed: bool, folded: bool
) -> dict[str, AcceptDecision]:
    """Decide about each tolerance of the job from the after test; a guarded decision needs the
    budget of the job.

    Of readings that are not ``believed`` nothing is decided, and nothing is accepted where a known
    period is ``folded``: these targets show it as a longer wave, which the table follows.
    """
    entry = job.axes[planned.axis.name]
    if entry.accept is None:
        return {}
    names = tuple(request.name for request in entry.before)
    if names[accepted_index(entry.accept, names)] != result.test.name:
        return {}
    factor = outside_factor(planned.axis.kind.unit)
    decisions = {}
    for name, limit in entry.accept.limits.items():
        value = result.parameters.get(name)
        uncertainty = result.uncertainty.get(name) if result.uncertainty else None
        U = uncertainty.U * factor if uncertainty else None
        outside = None if value is None else value * factor
        decision = (
            "undecided"
            if outside is None or not believed or (_guarded(job) and U is None)
            else decide(abs(outside), limit, U, job.decision_rule)
        )
        if folded and decision == "accept":
            decision = "undecided"
        decisions[name] = AcceptDecision(limit=limit, value=outside, U=U, decision=decision)
    return decisions


def _compare_loaded(planned: PlannedAxis, read_back: DecodedState | None) -> tuple[Finding, ...]:
    """Compare what was read back from the control with the plan's table, by its correction over the
    travel.
    """
    if read_back is None or planned.fitted is None:
        return ()
    axis, table = planned.axis, planned.fitted.compensation
    where = probe_positions(table.positions)
    worst = max(
        float(
            np.max(
                np.abs(
                    table.at(where, direction) - judged(read_back, axis.address, where, direction)
                )
            )
        )
        for direction in Direction
    )
    factor = outside_factor(axis.kind.unit)
    unit = shown_unit(axis.kind.unit)
    if worst * factor <= 1e-3:
        return (
            Finding(
                "CW-V010",
                "info",
                f"Axis {axis.name}: what was read back from the control is the plan's table.",
            ),
        )
    return (
        Finding(
            "CW-V011",
            "error",
            f"Axis {axis.name}: what was read back from the control differs from the plan by up to"
            f" {worst * factor:.2f} {unit}.",
        ),
    )


def _files(
    job: Job,
    control: Control,
    axes: Mapping[str, VerifiedAxis],
    circles: Mapping[str, VerifiedCircle],
    document: Mapping[str, Any],
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    files = {"verification.json": to_json(document).encode()}
    try:
        from compwright.reporting.report import verify_report

        view = verify_view(
            job,
            control,
            document["axes"],
            verification=document,
            evaluation_before=evaluations(
                [axis.before for axis in axes.values()],
                [circle.prediction.before for circle in circles.values()],
            ),
            evaluation_after=evaluations(
                [axis.after for axis in axes.values()],
                [circle.after for circle in circles.values()],
            ),
            findings=[
                *document["findings"],
                *finding_documents(finding for axis in axes.values() for finding in axis.findings),
            ],
        )
        files["verification.html"] = verify_report(view)
    except UsageError as error:
        return files, (f"verification.html is not written: {error}",)
    return files, ()
