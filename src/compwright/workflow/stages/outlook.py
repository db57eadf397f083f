"""What the next test will show, and whether a table is worth loading."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.prediction.positioning import decide_prediction, dithered_targets, predict_test
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.job import Acceptance, AxisJob, Job
from compwright.records.prediction import AcceptDecision, Quantiles, TestPrediction
from compwright.records.result import PositioningResult
from compwright.workflow.stages.planning import MeasuredError

DRAWS = 2000
#: Newly dithered targets stay this far from the ends of the travel: mm, and for rotary axes deg.
END_MARGIN = {AxisKind.LINEAR: 4.0, AxisKind.ROTARY: 0.0}

#: A correction by position (mm or deg, any shape) and approach direction.
Correction = Callable[[FloatArray, Direction], FloatArray]


@dataclass(frozen=True, slots=True)
class Change:
    """New correction minus the one that acted during the test from which the posterior comes."""

    new: Correction
    active: Correction

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the change at ``positions``, mm or deg."""
        return self.new(positions, direction) - self.active(positions, direction)


def predict(
    result: PositioningResult, posterior: MeasuredError, change: Change, axis: Axis
) -> TestPrediction:
    """Return what a fresh test like ``result`` will show with the changed correction, at its
    targets and at new ones.
    """
    return TestPrediction(
        name=result.test.name,
        before=result,
        predicted=_predict_at(result, posterior, change, result.test.targets, axis),
        predicted_new_targets=predict_new_targets(result, posterior, change, axis),
    )


def predict_new_targets(
    result: PositioningResult, posterior: MeasuredError, change: Change, axis: Axis
) -> Mapping[str, Quantiles]:
    """Return what a fresh test like ``result`` will show with the changed correction at newly
    dithered targets.
    """
    test = result.test
    new_targets = dithered_targets(
        axis.travel,
        test.targets.size,
        _generator(axis.name, test.name, "targets"),
        END_MARGIN[axis.kind],
    )
    return _predict_at(result, posterior, change, new_targets, axis)


def why_not_better(
    before: PositioningResult,
    after: PositioningResult,
    old: Mapping[str, Quantiles],
    new: Mapping[str, Quantiles],
) -> str:
    """Return why a table would not improve the axis, or an empty text when it does.

    ``before``, ``after``: the measured test re-evaluated with what the control does now and with
    what the new files give; ``old``, ``new``: what newly dithered targets will show, from the same
    draws. Judged by the first of A, E, ... that the test has.
    """
    name = _yardstick(before)
    if name is None:
        return ""
    factor = outside_factor(before.test.kind.unit)
    unit = shown_unit(before.test.kind.unit)
    was, becomes = before.parameters[name], after.parameters[name]
    if was is not None and becomes is not None and abs(becomes) >= abs(was):
        return (
            f"the measured test re-evaluated with the table gives {name} {becomes * factor:.2f}"
            f" {unit}, without it {was * factor:.2f} {unit}"
        )
    if name in new and name in old and abs(new[name].median) >= abs(old[name].median):
        return (
            f"at new targets {name} is expected to be {new[name].median * factor:.2f} {unit} with"
            f" the table, {old[name].median * factor:.2f} {unit} without it"
        )
    return ""


def accept_decisions(
    entry: AxisJob,
    predictions: tuple[TestPrediction, ...],
    rule: Literal["simple", "guarded"],
    *,
    folded: bool = False,
) -> Mapping[str, AcceptDecision]:
    """Return the decision about each tolerance of the job from the predicted values (limits in µm
    or arcsec).

    ``guarded``: with the uncertainty of the measured test as guard band; undecided where it has
    none. ``folded``: the targets show a known period as a longer wave, which the table follows:
    nothing is accepted, because no test at these targets shows it.
    """
    accept = entry.accept
    if accept is None:
        return {}
    prediction = predictions[accepted_index(accept, tuple(item.name for item in predictions))]
    factor = outside_factor(entry.axis.kind.unit)
    decisions = {}
    for name, limit in accept.limits.items():
        quantiles = magnitude(prediction.predicted[name])
        stated = (prediction.before.uncertainty or {}).get(name) if rule == "guarded" else None
        lacking = rule == "guarded" and stated is None
        decision = (
            "undecided"
            if lacking
            else decide_prediction(quantiles, limit / factor, 0.0 if stated is None else stated.U)
        )
        if folded and decision == "accept":
            decision = "undecided"
        U = None if stated is None else stated.U * factor
        decisions[name] = AcceptDecision(
            limit=limit, decision=decision, U=U, test=accept.test, rule=rule
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


def _predict_at(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Change,
    targets: FloatArray,
    axis: Axis,
) -> Mapping[str, Quantiles]:
    rng = _generator(axis.name, result.test.name, "draws")
    draws = posterior.draw(targets, DRAWS, rng)
    same = targets is result.test.targets
    runs: dict[Direction, int | FloatArray] = {
        direction: (
            result.test.readings(direction)
            if same
            else int(np.max(result.test.readings(direction), initial=0.0))
        )
        for direction in Direction
    }
    predicted = predict_test(
        draws.positive,
        draws.negative,
        draws.noise,
        runs_positive=runs[Direction.POSITIVE],
        runs_negative=runs[Direction.NEGATIVE],
        change_positive=change.at(targets, Direction.POSITIVE),
        change_negative=change.at(targets, Direction.NEGATIVE),
        coverage=result.coverage,
        rng=rng,
        vdi=result.standard == "vdi3441",
    )
    return {
        name: value for name, value in predicted.items() if result.parameters.get(name) is not None
    }


def _yardstick(result: PositioningResult) -> str | None:
    names = ("A", "E", "A_positive", "A_negative", "E_positive", "E_negative", "P", "R", "B_mean")
    return next((name for name in names if result.parameters.get(name) is not None), None)


def _generator(*names: str) -> np.random.Generator:
    """Return a generator that depends on the names only: the same job predicts the same numbers."""
    digest = hashlib.sha256("\x1f".join(names).encode("utf-8", "surrogatepass")).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "big"))
