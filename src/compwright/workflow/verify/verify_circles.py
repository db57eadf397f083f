"""Compare circular tests after loading with the prediction of the plan."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from compwright.controls.decoded_state import DecodedState
from compwright.controls.judged_corrections import active_corrections
from compwright.documents.verification import VerifiedCircle
from compwright.evaluation.decision import Decision
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
from compwright.foundations.input_sizes import MEASUREMENT
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.instruments.circular_reading import read_circular
from compwright.instruments.other_files import is_circular
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.planning.circles import (
    CIRCULAR_STANDARD,
    WORSE,
    effect_of,
    in_job_names,
    predicted_circle,
    with_uncertainty,
)
from compwright.planning.header_statements import after_test_doubts
from compwright.planning.limit_decisions import lacking_circle_guard, measured_circle_decisions
from compwright.planning.value_with_error import SIGNIFICANT
from compwright.prediction.active_corrections import ActiveCorrections
from compwright.records.axis import Axis
from compwright.records.circular import CircularResult, CircularTest
from compwright.records.job import Acceptance, Acknowledged, Job
from compwright.records.plan import Plan, PlannedCircle
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import AcceptDecision, CirclePrediction
from compwright.records.verification import ScaleAfter
from compwright.verification.circle_after_loading import (
    DEVIATIONS,
    OF_SCALES,
    noise_findings,
    shown_scales,
    turned_findings,
    unexpected_findings,
)
from compwright.verification.circle_loading import ShownValue
from compwright.verification.proof import (
    SAME_RADIUS,
    doubt_warnings,
    doubts_after,
    other_circle,
    unproven_circle,
)
from compwright.verification.squareness import SquarenessCheck, correction_finding
from compwright.workflow.inputs.circles import read_circle
from compwright.workflow.verify.circle_decision import TablesOnControl, table_in_circle


def split_after(
    session: Session, plan: Plan, specs: Sequence[str | PositioningTest | CircularTest]
) -> tuple[list[str | PositioningTest], dict[str, list[Path | CircularTest]]]:
    """Return the values of ``--after`` in two groups: the positioning tests, and the circular tests
    by the name of the circle that they repeat.

    ``TEST=FILE`` names the circle, in whose plane the file must be; else the plane decides, and of
    several circles of one plane radius and feed. Raises UsageError where the plan holds no such
    circle, InputError for circular files that cannot be read.
    """
    others: list[str | PositioningTest] = []
    circles: dict[str, list[Path | CircularTest]] = {}
    errors: list[CompwrightError] = []
    for spec in specs:
        if isinstance(spec, PositioningTest):
            others.append(spec)
            continue
        try:
            found = _circle(session, plan, spec)
        except CompwrightError as error:
            errors.append(error)
            continue
        if found is not None:
            circles.setdefault(found[0], []).append(found[1])
        elif isinstance(spec, str):
            others.append(spec)
    if errors:
        raise max((type(error) for error in errors), key=lambda kind: kind.exit_code)(
            *collect(errors)
        )
    return others, circles


def _circle(
    session: Session, plan: Plan, spec: str | CircularTest
) -> tuple[str, Path | CircularTest] | None:
    if isinstance(spec, CircularTest):
        return _repeated(plan.circles, spec, spec.name), spec
    head, mark, tail = spec.partition("=")
    named = bool(mark and tail) and head in plan.circles
    path = Path(tail if named else spec)
    if not storage.is_there(session, path) or storage.is_folder(path):
        return (head, path) if named else None
    content = storage.read_bytes(session, path, MEASUREMENT)
    file = shown_path(path)
    if not is_circular(content, file):
        return None
    among = {head: plan.circles[head]} if named else plan.circles
    return _repeated(among, read_circular(content, file), spec), path


def _repeated(circles: Mapping[str, PlannedCircle], test: CircularTest, spec: str) -> str:
    """Return the name of the planned circle that a test repeats: of those in the same plane, the
    one with the nearest radius, and of those with the same radius the one with the nearest feed.
    """

    def apart(name: str) -> tuple[float, float]:
        first = circles[name].test
        off = abs(first.nominal_radius - test.nominal_radius)
        same = off <= SAME_RADIUS * first.nominal_radius
        return 0.0 if same else off, abs(first.feed - test.feed)

    axes = [name.upper() for name in test.axes]
    known = [
        name
        for name, circle in circles.items()
        if [axis.upper() for axis in circle.test.axes] == axes
    ]
    if not known:
        planes = (
            ", ".join(f"{name} ({circle.test.plane})" for name, circle in circles.items())
            or "no circle"
        )
        raise UsageError(
            Fault(
                message=(
                    f"the file is a circular test of {' and '.join(test.axes)}, but the plan"
                    " contains none with these axes in this order"
                ),
                file=spec,
                place="--after",
                expected=planes,
                hint=(
                    "measure or export the circle with the axes in this order, or leave the file"
                    " out"
                ),
            )
        )
    return min(known, key=apart)


def verify_circles(
    session: Session,
    job: Job,
    plan: Plan,
    files: Mapping[str, Sequence[Path | CircularTest]],
    on_control: TablesOnControl,
    states: Mapping[str, DecodedState],
) -> dict[str, VerifiedCircle]:
    """Evaluate the circular tests after loading (``files``: their files by the name of the circle),
    and return their comparison with the plan by the name of the circle. Raises InputError.
    """
    axes = plan.every_axis
    then = _planned(plan, on_control.as_found, axes)
    errors: list[CompwrightError] = []
    verified: dict[str, VerifiedCircle] = {}
    for name, paths in files.items():
        try:
            test = in_job_names(read_circle(session, paths, name), plan.circles[name].test.axes)
            during = states.get(plan.circles[name].measured_in)
            verified[name] = _verified(
                job, plan, plan.circles[name], test, during, then, on_control
            )
        except InputError as error:
            errors.append(error)
    raise_all(InputError, collect(errors))
    return verified


def _verified(
    job: Job,
    plan: Plan,
    circle: PlannedCircle,
    after: CircularTest,
    during: DecodedState | None,
    then: ActiveCorrections,
    on_control: TablesOnControl,
) -> VerifiedCircle:
    before, result = (
        with_uncertainty(diagnose_circle(test, CIRCULAR_STANDARD), budget, job.thermal)
        for test, budget in (
            (circle.test, circle.budget),
            (replace(after, name=circle.test.name), job.uncertainty_circular),
        )
    )
    result = after_test_doubts(result, _loaded(plan, circle.test.axes))
    was = active_corrections(during, plan.every_axis)
    prediction = predicted_circle(before, circle, was, then)
    serial, name = job.machine.get("serial", ""), circle.test.name
    unproven = any(unproven_circle(circle.test, after, serial, name))
    limits = next((one.accept for one in job.circles if one.name == name), None)
    other = tuple(other_circle(circle.test, after, name, limited=limits is not None))
    turned = () if other else tuple(turned_findings(prediction, result, WORSE))
    unproven = unproven or bool(turned)
    between = None if other else (result.test, prediction.expected.test)
    check = None
    if not unproven:
        check = _squareness_check(circle, result, prediction, during, on_control, between)
    comparable = not (unproven or other)
    scales = (
        list(_scale_checks(circle, result, prediction, during, on_control)) if comparable else []
    )
    of_scales = [finding for _, _, finding in scales if finding is not None]
    found = () if check is None else check.findings
    judged = (
        *(() if check is None else ("squareness",)),
        *(DEVIATIONS if found else ()),
        *(OF_SCALES if of_scales else ()),
    )
    doubted = (
        *turned,
        *noise_findings(before, result),
        *(unexpected_findings(prediction, result, WORSE, judged) if comparable else ()),
    )
    accept, lacking, acknowledged = _judged(
        job,
        limits,
        before,
        result,
        (*of_scales, *doubted),
        corrected=check is not None,
        unproven=unproven or bool(other),
    )
    return VerifiedCircle(
        prediction=prediction,
        after=result,
        squareness=None if check is None else check.result,
        accept=accept,
        acknowledged=acknowledged,
        comparable=not other,
        scales={name: check for name, check, _ in scales},
        findings=(
            *(each for each in other if each.severity == "info"),
            *lacking,
            *found,
        ),
    )


def _squareness_check(
    circle: PlannedCircle,
    result: CircularResult,
    prediction: CirclePrediction,
    during: DecodedState | None,
    on_control: TablesOnControl,
    compared: tuple[CircularTest, CircularTest] | None,
) -> SquarenessCheck | None:
    """Return the comparison of the squareness with the prediction; None if it was not corrected
    from circles, or is not predicted. ``compared``: the test after loading and the predicted one,
    if they are the same circle.
    """
    pair = frozenset(circle.test.axes)
    removed = [
        entry
        for entry in on_control.plan.cross
        if entry.delivered and entry.source == "circle" and entry.pair == pair
    ]
    expected, now = (effect_of(each, "squareness") for each in (prediction.expected, result))
    if not removed or expected is None:
        return None
    error = expected.std_error
    error = error if now is None else float(np.hypot(error, now.std_error))
    check = SquarenessCheck(
        value=None if now is None else now.value,
        expected=expected.value,
        U=SIGNIFICANT * error,
        before=expected.value + 1e6 * sum(entry.squareness for entry in removed),
        as_planned=on_control.read_back.get(pair),
    )
    if now is None or len(removed) > 1:
        return check
    table = table_in_circle(circle, removed[0].input, removed[0].output)
    between = None if compared is None else table.between_directions(*compared)
    shown = ShownValue(now.value, expected.value, check.before, error, between)
    return replace(check, fault=on_control.judged_squareness(table, removed[0], shown, during))


def _scale_checks(
    circle: PlannedCircle,
    result: CircularResult,
    prediction: CirclePrediction,
    during: DecodedState | None,
    on_control: TablesOnControl,
) -> Iterator[tuple[str, ScaleAfter, Finding | None]]:
    """Yield each axis whose scale correction the circle shows, with its scale error after loading,
    and the finding CW-V035 if this is not as predicted.
    """
    for name, mean, as_predicted in shown_scales(prediction, result, WORSE):
        planned = on_control.plan.axes.get(name)
        if planned is None or planned.fitted is None or planned.tests:
            continue
        U = SIGNIFICANT * mean.std_error
        as_planned = on_control.read_back.get(frozenset({name}))
        check = ScaleAfter(value=mean.value, expected=mean.expected, U=U)
        finding = None
        if not as_predicted:
            table = table_in_circle(circle, name, name)
            between = table.between_directions(result.test, prediction.expected.test)
            shown = replace(mean, between=between)
            fault = on_control.judged_scale(table, name, shown, during)
            check = replace(check, verdict=fault.verdict, candidates=fault.candidates)
            finding = correction_finding(
                mean.value,
                mean.expected,
                U,
                "read_back" if as_planned is False else fault.verdict,
                fault,
                as_planned=as_planned is True,
                axis=name,
            )
        yield name, replace(check, verdict="read_back") if as_planned is False else check, finding


def _loaded(plan: Plan, axes: Sequence[str]) -> list[str]:
    """Return those axes of a circular test whose motion the loaded tables change."""
    bent = {cross.output for cross in plan.cross if cross.delivered and cross.input in axes}
    return [
        name
        for name in axes
        if name in bent or (name in plan.axes and plan.axes[name].fitted is not None)
    ]


def _judged(
    job: Job,
    limits: Acceptance | None,
    before: CircularResult,
    result: CircularResult,
    doubted: tuple[Finding, ...],
    *,
    corrected: bool,
    unproven: bool,
) -> tuple[dict[str, AcceptDecision], tuple[Finding, ...], tuple[Acknowledged, ...]]:
    """Return the decisions on the limits of a circle, the doubts that are open, and the doubts that
    the job acknowledges; only what is ``doubted`` beside the first test for a circle without limits
    whose squareness was not ``corrected``. Nothing is decided by an ``unproven`` test.
    """
    name, rule = result.test.name, job.decision_rule
    if limits is None and not corrected:
        return {}, doubted, ()
    readings = doubts_after(result)
    by = {
        each: given
        for each in readings
        for axis in result.test.axes
        if (given := job.acknowledgement(each.code, axis)) is not None
    }
    lacking = (*doubted, *doubt_warnings(result, before, by, guarded=rule == "guarded"))
    accept = (
        measured_circle_decisions(
            limits,
            result,
            rule,
            believed=all(each in by for each in readings) and not unproven,
            proven=not lacking,
        )
        if limits is not None
        else {}
    )
    return (
        accept,
        (*lacking, *lacking_circle_guard(name, accept)),
        tuple(Acknowledged(each, given) for each, given in by.items()),
    )


def squareness_decisions(circles: Mapping[str, VerifiedCircle]) -> list[Decision]:
    """Return the decisions on squareness, from those circles whose plane was corrected."""
    return [
        circle.squareness.decision for circle in circles.values() if circle.squareness is not None
    ]


def _planned(plan: Plan, as_found: DecodedState, axes: Mapping[str, Axis]) -> ActiveCorrections:
    """Return the corrections that the control makes after the plan's tables are loaded."""
    now = active_corrections(as_found, axes)
    along = {
        name: entry.fitted.compensation.at
        for name, entry in plan.axes.items()
        if entry.fitted is not None
    }
    delivered = (entry for entry in plan.cross if entry.delivered)
    return ActiveCorrections({**now.along, **along}, now.across).with_added(delivered)
