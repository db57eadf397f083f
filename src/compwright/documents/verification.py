"""The file ``verification.json``: results before loading, predicted results, and results after
loading.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Final, Literal

from compwright.documents.findings import finding_documents
from compwright.documents.prediction import (
    acknowledged_outside,
    circle_quantiles,
    circle_values,
    parameters_outside,
    quantiles_outside,
)
from compwright.foundations.findings import Finding, doubts_of
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularResult
from compwright.records.correction_need import NEGLIGIBLE, most_uncertain
from compwright.records.job import Acknowledged
from compwright.records.prediction import AcceptDecision, CirclePrediction, Decision, Quantiles
from compwright.records.result import ExpandedUncertainty, PositioningResult
from compwright.words.sentences import SentenceText, say

SCHEMA = "compwright/verification/1"
#: A loading fault of a squareness is named if U is below this part of the correction: the nearest
#: faults (not active, opposite sign) are a whole correction apart.
_CLEAR: Final = 0.25


@dataclass(frozen=True, slots=True, kw_only=True)
class ExpectedMeans:
    """The expected mean deviations (m,) after loading (mm or deg); ``s``: scatter of a reading."""

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifiedAxis:
    """The results of ``verify`` for one axis: tests before and after loading, prediction, and
    whether the table is active.

    - ``loading``: the verdict on the loaded table, with the keys of the JSON.
    - ``accept``: decision on each limit, with values in µm or arcsec.
    - ``acknowledged``: doubts that the job acknowledges.
    - ``guard``: uncertainty U of the prediction, if decisions are guarded and U is known.
    """

    before: PositioningResult
    predicted: Mapping[str, Quantiles]
    expected: ExpectedMeans
    after: PositioningResult
    loading: Mapping[str, Any]
    accept: Mapping[str, AcceptDecision] = field(default_factory=dict)
    acknowledged: tuple[Acknowledged, ...] = ()
    guard: Mapping[str, ExpandedUncertainty] | None = None
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True, slots=True)
class SquarenessCheck:
    """The squareness (µm/m) after loading compared with the prediction.

    ``before``: before loading, under the corrections that the control had as found; the plan
    changes it from there to ``expected``. ``U`` (k = 2): of the difference between ``value`` and
    ``expected``, from the noise of the two tests. It does not hold the set-up of the instrument.
    """

    value: float | None
    expected: float
    U: float
    before: float

    @property
    def factor(self) -> float | None:
        """The part of the planned correction that is active; None if the tests do not show it."""
        planned = self.before - self.expected
        if self.value is None or _CLEAR * abs(planned) <= self.U:
            return None
        return (self.before - self.value) / planned

    @property
    def verdict(self) -> Literal["loaded", "not_active", "inverted", "scaled", "undecided"]:
        """The name of the loading verdict to which ``factor`` belongs, as of an axis."""
        if self.factor is None:
            return "loaded" if self.decision == "accept" else "undecided"
        planned = abs(self.before - self.expected)
        near = max(self.U, min(NEGLIGIBLE, _CLEAR * planned)) / planned
        if abs(self.factor - 1.0) <= near:
            return "loaded"
        if abs(self.factor) <= near:
            return "not_active"
        if abs(self.factor + 1.0) <= near:
            return "inverted"
        return "scaled" if self.factor > 0.0 else "undecided"

    @property
    def active(self) -> bool:
        """Whether the correction is active as planned, so that a further one may be added."""
        return self.decision == "accept" or self.verdict == "loaded"

    @property
    def decision(self) -> Decision:
        """The decision on squareness.

        Accept if it differs from the prediction by no more than U, and U is small enough for a
        correction. Accept if a negligible squareness is left by a correction of which more than
        half is active.
        """
        if self.value is None:
            return "undecided"
        off, planned = abs(self.value - self.expected), abs(self.before - self.expected)
        if off <= self.U:
            return "accept" if most_uncertain(planned) > self.U else "undecided"
        negligible = abs(self.value) + self.U < NEGLIGIBLE and off + self.U < 0.5 * planned
        return "accept" if negligible else "reject"


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifiedCircle:
    """The results of ``verify`` for one circular test: before loading, as predicted, after loading,
    and the decisions on limits.

    ``squareness``: only if the squareness of its plane was corrected from circular tests.
    ``accept``, ``acknowledged``: see `VerifiedAxis`. ``findings``: open doubts, because of which
    its limits stay undecided.
    """

    prediction: CirclePrediction
    after: CircularResult
    squareness: SquarenessCheck | None = None
    accept: Mapping[str, AcceptDecision] = field(default_factory=dict)
    acknowledged: tuple[Acknowledged, ...] = ()
    findings: tuple[Finding, ...] = ()


def verification_document(
    format_id: str,
    axes: Mapping[str, VerifiedAxis],
    verdict: Literal["good", "bad", "undecided"],
    circles: Mapping[str, VerifiedCircle] | None = None,
    findings: Iterable[Finding] = (),
) -> dict[str, Any]:
    """Return a verification as JSON. ``findings``: those about no single axis."""
    general, tests = tuple(findings), circles or {}
    every: list[VerifiedAxis | VerifiedCircle] = [*axes.values(), *tests.values()]
    of_tests = [
        *(
            replace(finding, sentence=say("of_axis", axis=name, finding=finding.sentence))
            for name, axis in axes.items()
            for finding in axis.findings
        ),
        *(
            replace(finding, sentence=say("of_circle", circle=name, finding=finding.sentence))
            for name, circle in tests.items()
            for finding in circle.findings
        ),
    ]
    return {
        "schema": SCHEMA,
        "format": format_id,
        "doubts": finding_documents(doubts_of([*general, *of_tests])),
        "acknowledged": acknowledged_outside(each for one in every for each in one.acknowledged),
        "axes": {name: _axis(axis) for name, axis in axes.items()},
        "circles": {name: _circle(circle) for name, circle in tests.items()},
        "findings": finding_documents(general),
        "verdict": verdict,
        "headline": _headline(axes, tests, verdict),
    }


def _headline(
    axes: Mapping[str, VerifiedAxis],
    circles: Mapping[str, VerifiedCircle],
    verdict: Literal["good", "bad", "undecided"],
) -> str:
    """Return the verdict as a sentence; limits are mentioned only if the job has limits."""
    if verdict == "bad":
        decisions = [entry.decision for one in circles.values() for entry in one.accept.values()]
        decisions += [one.squareness.decision for one in circles.values() if one.squareness]
        return SentenceText(say("headline.bad", circles="reject" in decisions or not axes))
    if verdict == "undecided":
        return SentenceText(say("headline.undecided"))
    without = [name for name, axis in axes.items() if not axis.accept]
    if len(without) == len(axes) and not any(circle.accept for circle in circles.values()):
        return SentenceText(say("headline.active", tables=len(axes)))
    return SentenceText(say("headline.good", without=without))


def _axis(axis: VerifiedAxis) -> dict[str, Any]:
    kind = axis.after.test.kind
    factor = outside_factor(kind.unit)
    after = parameters_outside(axis.after)
    predicted = quantiles_outside(axis.predicted, kind)
    guard = {name: entry.U * factor for name, entry in (axis.guard or {}).items()}
    return {
        "unit": outside_unit(kind.unit),
        "test": axis.before.test.name,
        "before": parameters_outside(axis.before),
        "predicted": predicted,
        **({} if axis.guard is None else {"predicted_U": guard}),
        "after": after,
        "expected": {
            "positions": axis.expected.positions.tolist(),
            "positive": (axis.expected.positive * factor).tolist(),
            "negative": (axis.expected.negative * factor).tolist(),
            "s": axis.expected.s * factor,
        },
        "within_prediction": {
            name: _within(after.get(name), band, guard.get(name, 0.0))
            for name, band in predicted.items()
        },
        "loading": dict(axis.loading),
        "accept": _accept(axis.accept),
        "findings": finding_documents(axis.findings),
    }


def _accept(accept: Mapping[str, AcceptDecision]) -> dict[str, Any]:
    return {
        name: {
            "limit": entry.limit,
            "value": entry.value,
            "U": entry.U,
            "decision": entry.decision,
            **({"rule": entry.rule} if entry.rule == "guarded" else {}),
        }
        for name, entry in accept.items()
    }


def _circle(circle: VerifiedCircle) -> dict[str, Any]:
    """Return a verified circular test for JSON: parameters in µm, error causes in their units."""
    after, predicted = circle_values(circle.after), circle_quantiles(circle.prediction)
    check = circle.squareness
    return {
        "before": circle_values(circle.prediction.before),
        "predicted": predicted,
        "after": after,
        "within_prediction": {
            name: _within(after.get(name), band) for name, band in predicted.items()
        },
        "squareness": (
            None
            if check is None
            else {
                "value": check.value,
                "expected": check.expected,
                "U": check.U,
                "unit": "um/m",
                "decision": check.decision,
                "verdict": check.verdict,
                "factor": check.factor,
                "active": check.active,
            }
        ),
        "accept": _accept(
            {name: replace(entry, value=after[name]) for name, entry in circle.accept.items()}
        ),
        "findings": finding_documents(
            (
                *circle.findings,
                *circle.after.findings,
                *(circle.after.diagnosis.findings if circle.after.diagnosis else ()),
            )
        ),
    }


def _within(
    value: float | None, band: Mapping[str, float] | None, guard: float = 0.0
) -> bool | None:
    """Return whether a value is in the predicted 90 % interval, widened by ``guard``; None without
    a value or a prediction.
    """
    if value is None or band is None:
        return None
    return band["p05"] - guard <= value <= band["p95"] + guard
