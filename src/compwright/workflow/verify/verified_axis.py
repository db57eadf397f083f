"""Compare the test of an axis after loading with the prediction of the plan."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np

from compwright.controls.control import Control, decode
from compwright.controls.decoded_state import DecodedState, SingleReader
from compwright.controls.differences import compared_side, differences
from compwright.controls.gantries import with_partners
from compwright.controls.judged_corrections import applied_correction, judged_correction
from compwright.controls.read_back import (
    assumed_instead,
    newly_coupled,
    pairs_not_read_back,
    typed_corrections,
)
from compwright.controls.reader_comparison import SINGLE_PRECISION, table_positions
from compwright.documents.verification import ExpectedMeans, VerifiedAxis
from compwright.estimation.cells import alias_findings
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import evaluate_test
from compwright.planning.guard_bands import guard_bands
from compwright.planning.header_statements import after_test_doubts
from compwright.planning.limit_decisions import lacking_guard, measured_decisions, unguarded
from compwright.planning.motions import with_motion
from compwright.planning.predicted_gain import predict_same_targets
from compwright.planning.simulated_repeat_tests import RepeatConditions
from compwright.planning.temperature_slopes import fresh_slope
from compwright.planning.wanted_correction import MeasuredError, measured_error, observed_tests
from compwright.prediction.active_corrections import Correction, difference, no_correction
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Axis, AxisKind, Direction, partner_of
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.fitted_table import FittedTable
from compwright.records.job import Acknowledged, Job
from compwright.records.plan import Plan, PlannedAxis, PlannedCross, PlannedTest
from compwright.records.prediction import AcceptDecision
from compwright.records.result import PositioningResult
from compwright.records.rounding import LOGARITHM, rounded_number
from compwright.records.verification import LoadingName, LoadingVerdict
from compwright.verification.loading_hypotheses import OF_VALUES
from compwright.verification.measurement_faults import NamedFault, measurement_fault, proof_findings
from compwright.verification.proof import AfterTest, doubt_warnings, doubts_after
from compwright.workflow.verify.loading_decision import judged_loading


def verified_axis(
    job: Job,
    control: Control,
    planned: PlannedAxis,
    after: AfterTest,
    as_found: DecodedState,
    stored: ControlState,
    read_back: DecodedState | None,
    twice: NamedFault | None,
    others: Mapping[str, PlannedAxis],
    *,
    ours: bool,
) -> VerifiedAxis:
    """Compare the test of an axis after loading with the prediction of the plan. ``twice``: the
    fault that the test is a copy of another one, if any; ``ours``: whether ``read_back`` is only
    what ``run`` wrote, which is no evidence about the control.

    ``as_found``: contents of the control before. ``stored``: the same with its tables switched on.
    ``read_back``: contents read back since, if any. ``others``: the other axes of the plan.
    """
    axis = planned.axis
    names = [entry.test.name for entry in planned.tests]
    place = names.index(after.repeats) if after.repeats in names else 0
    repeated = planned.tests[place]
    before, result = (evaluate_test(job, axis, test) for test in (repeated.test, after.test))
    result = after_test_doubts(result, () if planned.fitted is None else (axis.name,))
    observed = observed_tests(planned.tests, planned.active)
    posterior = measured_error(planned.tests, observed, axis, planned.active)
    change = _change(planned, as_found, repeated)
    fault = twice or measurement_fault(after.test, repeated.test, axis.travel)
    compared = _compare_loaded(control, planned, as_found, read_back)
    if ours:
        compared = tuple(finding for finding in compared if finding.code != "CW-V010")
    as_planned = any(finding.code == "CW-V010" for finding in compared)
    loading = (
        judged_loading(
            job,
            control.in_state(as_found.state),
            planned,
            after.test,
            place,
            observed,
            posterior,
            stored,
            others,
            read_back=as_planned,
        )
        if fault is None
        else LoadingVerdict(verdict="measurement", of=fault.of, margin=0.0, sentence=fault.sentence)
    )
    result = _without_explained_doubt(before, result, loading)
    exchange = () if as_planned else _exchange(axis.name, loading, others)
    given = read_back.state.findings if read_back is not None and not ours else ()
    files = tuple(each for each in given if each.is_doubt and not each.axes)
    accept, findings, acknowledged = _judged(job, axis, before, result, loading, fault, files)
    like = RepeatConditions(place, fresh_slope(job.decision_rule, repeated))
    guarded = job.decision_rule == "guarded"
    return VerifiedAxis(
        before=before,
        predicted=predict_same_targets(result, posterior, change, axis, like),
        expected=_expected(result, posterior, change),
        after=result,
        loading=_loading_document(loading, _sentences(control, planned), read_back=as_planned),
        accept=accept,
        acknowledged=acknowledged,
        guard=guard_bands(job, planned, place, before, posterior, change) if guarded else None,
        findings=(*loading.findings, *_named(loading), *exchange, *findings, *compared),
    )


#: Faults by which more lost motion than there is can be compensated.
_OVERCOMPENSATED: Final = {"backlash", "on_top", "one_direction", "state", "wrong_axis"}


def _without_explained_doubt(
    before: PositioningResult, after: PositioningResult, loading: LoadingVerdict
) -> PositioningResult:
    """Return the result ``after`` loading without the doubt about a mean reversal above zero
    (CW-T032), if a fault of the table explains it: one that overcompensates lost motion.

    The verdict compared the test with exchanged directions and a reversed sign too. Where the test
    ``before`` had the doubt already, both may be wrong.
    """
    too_much = loading.verdict == "scaled" and loading.factor > 1
    explained = too_much or loading.verdict in _OVERCOMPENSATED
    if not explained or any(one.code == "CW-T032" for one in before.findings):
        return after
    return replace(after, findings=tuple(one for one in after.findings if one.code != "CW-T032"))


def _change(planned: PlannedAxis, as_found: DecodedState, repeated: PlannedTest) -> Correction:
    """Return the difference between the correction after loading and the correction that was active
    in the test that is repeated.
    """
    active = no_correction if planned.active is None else planned.active.at
    table = (
        None
        if planned.fitted is None
        else applied_compensation(planned.fitted.compensation, planned.axis).at
    )
    wanted = table or applied_correction(as_found, planned.axis)
    return difference(with_motion(wanted, planned.axis, repeated.backlash_more), active)


def _judged(
    job: Job,
    axis: Axis,
    before: PositioningResult,
    result: PositioningResult,
    loading: LoadingVerdict,
    fault: NamedFault | None,
    files: Sequence[Finding],
) -> tuple[dict[str, AcceptDecision], tuple[Finding, ...], tuple[Acknowledged, ...]]:
    """Return the decisions on the limits of an axis, the doubts that are open, and the doubts that
    the job acknowledges. ``fault``: a fault that the measurement certainly has, if any; ``files``:
    the doubts about the files read back.

    With a ``fault``, nothing else about the readings is a doubt.
    """
    guarded = job.decision_rule == "guarded"
    waves = alias_findings(result.test.targets, axis.screw_pitch, axis.kind.unit)
    readings = () if fault else doubts_after(result)
    by = {each: job.acknowledgement(each.code, axis.name) for each in (*readings, *waves, *files)}
    acknowledged = {each: given for each, given in by.items() if given is not None}
    still = tuple(each for each in (*waves, *files) if each not in acknowledged)
    lacking = (
        *(() if fault else proof_findings(result.test, before.test, job.machine.get("serial", ""))),
        *(() if fault else doubt_warnings(result, before, acknowledged, guarded=guarded)),
        *still,
    )
    accept = measured_decisions(
        job.axes[axis.name],
        result,
        job.decision_rule,
        believed=loading.verdict != "measurement"
        and not still
        and all(each in acknowledged for each in readings),
        proven=not lacking,
    )
    return (
        accept,
        (*lacking, *lacking_guard(axis, result.standard, unguarded(accept))),
        tuple(Acknowledged(each, given) for each, given in acknowledged.items()),
    )


def _sentences(control: Control, planned: PlannedAxis) -> Mapping[LoadingName, tuple[str, ...]]:
    """Return, for each possible loading verdict, what the user should check on the control."""
    if planned.fitted is None:
        return {}
    return control.look_at(planned.axis, planned.fitted.compensation)


def _looks(
    loading: LoadingVerdict, sentences: Mapping[LoadingName, tuple[str, ...]], *, read_back: bool
) -> list[str]:
    """Return what to check on the control for a verdict, or for all possible verdicts if undecided.
    ``read_back``: whether the values read back from the control are the plan's.

    For a loaded table, only the checks that distinguish it from its equivalents; none where the
    values that were ``read_back`` (the plan's) have decided it.
    """
    names: list[LoadingName] = [loading.verdict]
    if loading.verdict == "undecided":
        names = [each.verdict for each in loading.candidates if each.verdict != "loaded"]
    elif loading.verdict == "loaded":
        decided = OF_VALUES if read_back else frozenset[LoadingName]()
        names = names if set(loading.equivalent) - decided else []
    return list(dict.fromkeys(text for name in names for text in sentences.get(name, ())))


def _loading_document(
    loading: LoadingVerdict, sentences: Mapping[LoadingName, tuple[str, ...]], *, read_back: bool
) -> dict[str, Any]:
    """Return the verdict about the loading as plain data for the JSON document. ``read_back``:
    whether the values read back from the control are the plan's.
    """
    return {
        "verdict": loading.verdict,
        **({"of": loading.of} if loading.of is not None else {}),
        "equivalent": list(loading.equivalent),
        "near": list(loading.near),
        "factor": rounded_number(loading.factor),
        "shift_nodes": loading.shift_nodes,
        "margin": rounded_number(loading.margin, LOGARITHM),
        "detail": str(loading.detail or ""),
        "candidates": [
            {
                "verdict": each.verdict,
                "probability": rounded_number(each.probability, LOGARITHM),
                "detail": str(each.detail or ""),
            }
            for each in loading.candidates
        ],
        **({"slope": _slope_document(*loading.slope)} if loading.slope is not None else {}),
        "message": loading.message,
        "look_at": _looks(loading, sentences, read_back=read_back),
    }


def _slope_document(slope: float, error: float) -> dict[str, Any]:
    value, std_error = (rounded_number(one * 1e6, LOGARITHM) for one in (slope, error))
    return {"value": value, "std_error": std_error, "unit": "um/m"}


def _expected(
    result: PositioningResult, posterior: MeasuredError, change: Correction
) -> ExpectedMeans:
    targets = result.test.targets
    estimate = posterior.summary(targets)
    positive, negative = (
        (
            estimate.mean(direction) + change(targets, direction)
            if result.test.readings(direction).any()
            else np.empty(0)
        )
        for direction in Direction
    )
    return ExpectedMeans(positions=targets, positive=positive, negative=negative, s=estimate.noise)


def _named(loading: LoadingVerdict) -> tuple[Finding, ...]:
    """Return a tuple with the finding CW-V026 if the verdict is that the measurement is faulty,
    else an empty tuple.
    """
    return (
        (Finding("CW-V026", "warning", loading.sentence),)
        if loading.verdict == "measurement"
        else ()
    )


def _exchange(
    axis: str, loading: LoadingVerdict, others: Mapping[str, PlannedAxis]
) -> tuple[Finding, ...]:
    """Return a tuple with the finding CW-V012 if the test cannot show whether the tables of two
    axes are exchanged, else an empty tuple.
    """
    hidden = loading.verdict == "loaded" and "wrong_axis" in {*loading.near, *loading.equivalent}
    names = [name for name, other in others.items() if other.fitted is not None]
    return (Finding.of("CW-V012", "warning", axis=axis, others=names),) if hidden else ()


def _compare_loaded(
    control: Control, planned: PlannedAxis, as_found: DecodedState, read_back: DecodedState | None
) -> tuple[Finding, ...]:
    """Return the findings about the comparison of the values read back from the control with the
    plan's table, for a gantry on both of its axes; none if nothing was read back.
    """
    if read_back is None or planned.fitted is None:
        return ()
    every = with_partners(control.in_state(as_found.state), _tables(planned), as_found)
    found = tuple(_compared(axis, table.compensation, read_back) for axis, table in every)
    return tuple(one for one in found if one.code == "CW-V011") or found[:1]


def differing_tables(
    control: Control,
    planned: Iterable[PlannedAxis],
    as_found: DecodedState,
    read_back: DecodedState | None,
) -> Iterator[Finding]:
    """Yield the finding CW-V011 for each ``planned`` axis whose table that was read back differs
    from the plan.
    """
    for entry in planned:
        found = _compare_loaded(control, entry, as_found, read_back)
        yield from (each for each in found if each.code == "CW-V011")


def _tables(planned: PlannedAxis) -> list[tuple[Axis, FittedTable]]:
    """Return the axis with its planned table; for a gantry also the slave axis with the same table,
    unless the slave only gets the same change.
    """
    axis, fitted = planned.axis, planned.fitted
    if fitted is None:
        return []
    own = [(axis, fitted)]
    if axis.gantry is not None and axis.gantry_table != "change":
        own.append((partner_of(axis, axis.gantry), fitted))
    return own


def _compared(axis: Axis, table: AxisCompensation, read_back: DecodedState) -> Finding:
    where = table_positions(table.positions, axis.travel)
    off = difference(table.at, judged_correction(read_back, axis))
    worst = max(float(np.max(np.abs(off(where, direction)))) for direction in Direction)
    largest = max(float(np.max(np.abs(table.at(where, direction)))) for direction in Direction)
    return differs_from_plan(axis.name, worst, largest, axis.kind) or Finding.of(
        "CW-V010", "info", axis=axis.name
    )


def differs_from_plan(axis: str, off: float, largest: float, kind: AxisKind) -> Finding | None:
    """Return the finding that a table read back differs from the plan's table by up to ``off`` (mm
    or deg), or None if that is no more than rounding. ``largest``: the largest value of the plan's
    table.
    """
    factor, unit = outside_factor(kind.unit), shown_unit(kind.unit)
    if off <= 1e-3 / factor + SINGLE_PRECISION * largest:
        return None
    return Finding.of("CW-V011", "error", axis=axis, difference=off * factor, unit=unit)


def between_axes(
    control: Control,
    plan: Plan,
    planned: Sequence[ControlFile],
    as_found: DecodedState,
    read_back: DecodedState | None,
) -> Iterator[tuple[PlannedCross | None, Finding]]:
    """Yield a finding for each table between axes that is missing in the files read back or has
    other values there (with its entry in the plan), and findings of no such table.

    ``planned``: the files that the plan loads. ``as_found``: contents of the control before.
    """
    if read_back is None:
        return
    for each in typed_corrections(plan.cross, as_found.state, read_back.state):
        output, kind = each.entry.output, each.entry.added.output_kind
        off = 0.0 if each.change is None else abs(each.change.most)
        found = each.not_read_back or differs_from_plan(output, off, each.largest, kind)
        if found is not None:
            yield each.entry, found
    cross = [entry for entry in plan.cross if entry.written]
    if not cross:
        return
    wanted, back = SingleReader(decode(control, planned).state), SingleReader(read_back.state)
    sides = (
        compared_side(control, planned, "the plan", read_back.files),
        compared_side(control, read_back.files, "read back", planned),
    )
    whole = differences(control, *sides)
    missing = pairs_not_read_back(cross, whole, sides[1])
    for finding in (
        *newly_coupled(cross, plan.every_axis, *sides),
        *assumed_instead(whole, *sides),
    ):
        yield None, finding
    for entry in cross:
        if entry.addresses in missing and entry.addresses not in back.state.pairs:
            yield entry, missing[entry.addresses]
            continue
        planned_values, held_values = (
            [
                one.cross_correction(*entry.addresses, entry.added.positions, way)
                for way in Direction
            ]
            for one in (wanted, back)
        )
        off = float(np.max(np.abs(np.subtract(planned_values, held_values))))
        largest = float(np.max(np.abs(planned_values)))
        found = differs_from_plan(entry.output, off, largest, entry.added.output_kind)
        if found is not None or entry.addresses in missing:
            yield entry, found or missing[entry.addresses]
