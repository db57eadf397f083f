"""The limits of a job: whether the tests yield the limited parameters, and whether each limit is
met.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Literal

from compwright.evaluation.decision import decide
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE, outside_factor
from compwright.prediction.positioning import decide_prediction
from compwright.records.axis import Axis
from compwright.records.circular import CircularResult
from compwright.records.job import Acceptance, AxisJob, Job
from compwright.records.prediction import (
    AcceptDecision,
    CirclePrediction,
    Decision,
    Quantiles,
    TestPrediction,
)
from compwright.records.result import ExpandedUncertainty, PositioningResult


def accept_decisions(
    entry: AxisJob,
    predictions: tuple[TestPrediction, ...],
    rule: Literal["simple", "guarded"],
) -> Mapping[str, AcceptDecision]:
    """Return the decision about each limit of an axis (µm or arcsec) from the predicted values: by
    the values alone (``rule`` ``simple``) or with their uncertainty as guard band (``guarded``).

    A limit is accepted if it is met both at the same targets and at new ones, where the prediction
    includes the periods that the test cannot show.
    """
    accept = entry.accept
    if accept is None:
        return {}
    prediction = predictions[accepted_index(accept, tuple(item.name for item in predictions))]
    return _predicted(
        accept,
        prediction.predicted,
        prediction.uncertainty,
        rule,
        outside_factor(entry.axis.kind.unit),
        prediction.predicted_new_targets,
    )


def circle_decisions(
    accept: Acceptance | None, circle: CirclePrediction, rule: Literal["simple", "guarded"]
) -> Mapping[str, AcceptDecision]:
    """Return the decision about each limit of a circular test (µm) from the predicted values: by
    the values alone (``rule`` ``simple``) or with their uncertainty as guard band (``guarded``).

    The decision follows the rule of `accept_decisions`. U is that of the measured circle, because
    the tables hardly change it. The decision is undecided if the causes in the circle are not known
    (CW-P134).
    """
    if accept is None:
        return {}
    decisions = _predicted(
        accept, circle.predicted, circle.before.uncertainty, rule, MICROMETRES_PER_MILLIMETRE
    )
    if circle.before.diagnosis is not None:
        return decisions
    return {name: replace(entry, decision="undecided") for name, entry in decisions.items()}


def _predicted(
    accept: Acceptance,
    predicted: Mapping[str, Quantiles],
    uncertainty: Mapping[str, ExpandedUncertainty] | None,
    rule: Literal["simple", "guarded"],
    factor: float,
    elsewhere: Mapping[str, Quantiles] | None = None,
) -> dict[str, AcceptDecision]:
    """Return decisions about limits from predicted values. ``factor`` converts them to the unit of
    the limits; ``elsewhere`` is the prediction at new targets.
    """
    decisions = {}
    for name, limit in accept.limits.items():
        stated = (uncertainty or {}).get(name) if rule == "guarded" else None
        guard = 0.0 if stated is None else stated.U
        decision: Decision = "undecided"
        if name in predicted and (rule == "simple" or stated is not None):
            decision = decide_prediction(magnitude(predicted[name]), limit / factor, guard)
        new = (elsewhere or {}).get(name)
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
    """Return the decision about each limit of an axis (µm or arcsec) from the test after loading:
    undecided if its readings are not ``believed``, and never accept if the test is not ``proven``
    to show as much as the test that it repeats.

    A guarded decision uses the uncertainty of this test only. The errors of the earlier tests are
    in the table, so this test measures them.
    """
    if entry.accept is None:
        return {}
    names = tuple(request.name for request in entry.before)
    if names[accepted_index(entry.accept, names)] != result.test.name:
        return {}
    factor = outside_factor(entry.axis.kind.unit)
    return _measured(entry.accept, result, rule, factor, believed=believed, proven=proven)


def measured_circle_decisions(
    accept: Acceptance | None,
    result: CircularResult,
    rule: Literal["simple", "guarded"],
    *,
    believed: bool,
    proven: bool,
) -> dict[str, AcceptDecision]:
    """Return the decision about each limit of a circular test (µm) from its repetition after
    loading: undecided if its readings are not ``believed``, and never accept if it is not
    ``proven`` to show as much as the test that it repeats.
    """
    if accept is None:
        return {}
    factor = MICROMETRES_PER_MILLIMETRE
    return _measured(accept, result, rule, factor, believed=believed, proven=proven)


def _measured(
    accept: Acceptance,
    result: PositioningResult | CircularResult,
    rule: Literal["simple", "guarded"],
    factor: float,
    *,
    believed: bool,
    proven: bool,
) -> dict[str, AcceptDecision]:
    decisions = {}
    for name, limit in accept.limits.items():
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


def unguarded(accept: Mapping[str, AcceptDecision]) -> list[str]:
    """Return the parameters whose decision requires a guard band for uncertainty, but whose
    uncertainty is unknown.
    """
    return [name for name, entry in accept.items() if entry.rule == "guarded" and entry.U is None]


def lacking_guard(axis: Axis, standard: str, names: Iterable[str]) -> tuple[Finding, ...]:
    """Return the finding CW-P132: which uncertainties the job must state so that decisions about
    the parameters ``names`` of an axis can allow for uncertainty (guard band).
    """
    test = "vdi3441" if standard == "vdi3441" else axis.kind.value
    return _without_guard(test, axis.name, names)


def lacking_circle_guard(name: str, accept: Mapping[str, AcceptDecision]) -> tuple[Finding, ...]:
    """Return the finding CW-P132 for a circular test: which uncertainties the job must state so
    that decisions can allow for uncertainty (guard band).
    """
    return _without_guard("circular", name, unguarded(accept))


def _without_guard(test: str, name: str, names: Iterable[str]) -> tuple[Finding, ...]:
    lacking = tuple(names)
    if not lacking:
        return ()
    return (Finding.of("CW-P132", "warning", test=test, name=name, lacking=lacking),)


def magnitude(quantiles: Quantiles) -> Quantiles:
    """Return the quantiles of the absolute value of a parameter. A limit bounds the size, but
    parameters such as the mean reversal error have a sign.
    """
    low, high = sorted((abs(quantiles.p05), abs(quantiles.p95)))
    spans_zero = quantiles.p05 < 0.0 < quantiles.p95
    return Quantiles(median=abs(quantiles.median), p05=0.0 if spans_zero else low, p95=high)


def check_limits(job: Job, entry: AxisJob, results: tuple[PositioningResult, ...]) -> None:
    """Raise UsageError for every limit on a parameter that the tests do not yield, and for every
    decision that requires a guard band although the uncertainty is unknown.
    """
    accept = entry.accept
    if accept is None:
        return
    result = results[accepted_index(accept, tuple(item.test.name for item in results))]
    raise_all(UsageError, limit_faults(job, accept, result, f"axes.{entry.axis.name}"))


def limit_faults(
    job: Job, accept: Acceptance, result: PositioningResult | CircularResult, place: str
) -> list[Fault]:
    """Return a fault for each limit on a parameter that ``result`` does not contain, and for a
    guarded decision without uncertainty. ``place``: the section of the job that the fault names,
    such as ``axes.X``.
    """
    faults = [
        Fault(
            message=f"{result.standard} gives no value of {name} for the test {result.test.name}",
            file=job.file,
            place=f"{place}.accept.{name}",
            expected="one of "
            + ", ".join(key for key, value in result.parameters.items() if value is not None),
            found=result.not_applicable.get(name, ""),
            hint=(f"remove `{name}` from `accept`, or choose a standard that defines it"),
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
                hint="add `uncertainty` to the job, or set `decision_rule: simple`",
            )
        )
    return faults


def accepted_index(accept: Acceptance, names: tuple[str, ...]) -> int:
    """Return the index of the test to which the limits apply: the one named in the job, or the
    first.
    """
    return 0 if accept.test is None else names.index(accept.test)
