"""The limits of a job: whether its tests have them, and the decision about each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal

from compwright.evaluation.decision import decide
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor
from compwright.prediction.positioning import decide_prediction
from compwright.records.axis import Axis, AxisKind
from compwright.records.job import Acceptance, AxisJob, Job
from compwright.records.prediction import AcceptDecision, Quantiles, TestPrediction
from compwright.records.result import PositioningResult


def accept_decisions(
    entry: AxisJob,
    predictions: tuple[TestPrediction, ...],
    rule: Literal["simple", "guarded"],
    at_new_targets: Mapping[str, Quantiles] | None = None,
) -> Mapping[str, AcceptDecision]:
    """Return the decision about each tolerance of the job from the predicted values (limits in µm
    or arcsec).

    Accepted is what keeps its limit at the same targets and at new ones (``at_new_targets``: with
    the periods that the test cannot show; None: as predicted). ``guarded``: with the uncertainty of
    the predicted test as guard band; undecided where it has none.
    """
    accept = entry.accept
    if accept is None:
        return {}
    prediction = predictions[accepted_index(accept, tuple(item.name for item in predictions))]
    factor = outside_factor(entry.axis.kind.unit)
    decisions = {}
    for name, limit in accept.limits.items():
        quantiles = magnitude(prediction.predicted[name])
        stated = (prediction.uncertainty or {}).get(name) if rule == "guarded" else None
        lacking = rule == "guarded" and stated is None
        decision = (
            "undecided"
            if lacking
            else decide_prediction(quantiles, limit / factor, 0.0 if stated is None else stated.U)
        )
        new = (at_new_targets or prediction.predicted_new_targets).get(name)
        guard = 0.0 if stated is None else stated.U
        if decision == "accept" and new and magnitude(new).p95 + guard > limit / factor:
            decision = "undecided"
        U = None if stated is None else stated.U * factor
        decisions[name] = AcceptDecision(
            limit=limit, decision=decision, U=U, test=accept.test, rule=rule
        )
    return decisions


def measured_decisions(
    entry: AxisJob,
    result: PositioningResult,
    rule: Literal["simple", "guarded"],
    *,
    believed: bool,
    proven: bool,
) -> dict[str, AcceptDecision]:
    """Return the decision about each tolerance of the job from the test after loading (limits in µm
    or arcsec); a guarded decision needs the uncertainty of this test, and no more: what the tests
    before have put into the table acts in the machine, and is measured with it.

    Of readings that are not ``believed`` nothing is decided, and nothing is accepted of a test that
    is not ``proven``: it shows less than the one that it repeats.
    """
    if entry.accept is None:
        return {}
    names = tuple(request.name for request in entry.before)
    if names[accepted_index(entry.accept, names)] != result.test.name:
        return {}
    factor = outside_factor(entry.axis.kind.unit)
    decisions = {}
    for name, limit in entry.accept.limits.items():
        value = result.parameters.get(name)
        uncertainty = result.uncertainty.get(name) if result.uncertainty else None
        U = uncertainty.U * factor if uncertainty else None
        outside = None if value is None else value * factor
        decision = (
            "undecided"
            if outside is None or not believed or (rule == "guarded" and U is None)
            else decide(abs(outside), limit, U, rule)
        )
        if not proven and decision == "accept":
            decision = "undecided"
        decisions[name] = AcceptDecision(
            limit=limit, value=outside, U=U, decision=decision, rule=rule
        )
    return decisions


def lacking_guard(axis: Axis, standard: str, names: Iterable[str]) -> tuple[Finding, ...]:
    """Return what to give for guarded decisions about the parameters ``names``, which have no
    uncertainty (CW-P132).
    """
    lacking = ", ".join(names)
    if not lacking:
        return ()
    if standard == "vdi3441":
        give = (
            "no uncertainty is stated for VDI/DGQ 3441; give decision_rule: simple, or another"
            " standard"
        )
    elif axis.kind is AxisKind.ROTARY:
        give = (
            "give uncertainty.rotary in the job (U of the instrument in arcsec, setup, E_VE), or"
            " decision_rule: simple"
        )
    else:
        give = (
            "give uncertainty in the job (device.U in µm and what else is known), or decision_rule:"
            " simple"
        )
    message = (
        f"Axis {axis.name}: no uncertainty U of {lacking} is known, and the decision is guarded:"
        f" undecided; {give}."
    )
    return (Finding("CW-P132", "warning", message),)


def magnitude(quantiles: Quantiles) -> Quantiles:
    """Return the quantiles of the size of a parameter: a tolerance bounds the size, and the mean
    reversal value has a sign.
    """
    low, high = sorted((abs(quantiles.p05), abs(quantiles.p95)))
    spans_zero = quantiles.p05 < 0.0 < quantiles.p95
    return Quantiles(median=abs(quantiles.median), p05=0.0 if spans_zero else low, p95=high)


def check_limits(job: Job, entry: AxisJob, results: tuple[PositioningResult, ...]) -> None:
    """Raise UsageError for every tolerance on a parameter that the test does not have, and for a
    guard band of nothing.
    """
    accept = entry.accept
    if accept is None:
        return
    result = results[accepted_index(accept, tuple(item.test.name for item in results))]
    faults = [
        Fault(
            message=f"the test {result.test.name} has no {name} under {result.standard}",
            file=job.file,
            place=f"axes.{entry.axis.name}.accept.{name}",
            expected=", ".join(
                key for key, value in result.parameters.items() if value is not None
            ),
            found=result.not_applicable.get(name, ""),
        )
        for name in accept.limits
        if result.parameters.get(name) is None
    ]
    if job.decision_rule == "guarded" and job.uncertainty is None:
        faults.append(
            Fault(
                message="the guarded decision needs the measurement uncertainty",
                file=job.file,
                place="decision_rule",
                expected="the key uncertainty, or decision_rule: simple",
                found="guarded without an uncertainty",
            )
        )
    raise_all(UsageError, faults)


def accepted_index(accept: Acceptance, names: tuple[str, ...]) -> int:
    """Return the place of the test that the tolerances are meant for: the first, or the one
    named.
    """
    return 0 if accept.test is None else names.index(accept.test)
