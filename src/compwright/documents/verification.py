"""The file ``verification.json``: results before loading, predicted results, and results after
loading.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

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
from compwright.records.job import Acknowledged
from compwright.records.prediction import AcceptDecision, CirclePrediction, Quantiles
from compwright.records.result import ExpandedUncertainty, PositioningResult
from compwright.records.rounding import LOGARITHM, rounded_number
from compwright.records.verification import Candidate, LoadingName, ScaleAfter, SquarenessAfter
from compwright.words.sentences import SentenceText, say

SCHEMA = "compwright/verification/1"


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


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifiedCircle:
    """The results of ``verify`` for one circular test: before loading, as predicted, after loading,
    and the decisions on limits.

    ``squareness``: only if the squareness of its plane was corrected from circular tests.
    ``accept``, ``acknowledged``: see `VerifiedAxis`. ``findings``: open doubts, because of which
    its limits stay undecided. ``comparable``: whether radius, feed and arc are those of the test
    before, so that the predicted values are those of this circle. ``scales``: by axis, each scale
    correction of which it shows whether it is active.
    """

    prediction: CirclePrediction
    after: CircularResult
    squareness: SquarenessAfter | None = None
    comparable: bool = True
    scales: Mapping[str, ScaleAfter] = field(default_factory=dict)
    accept: Mapping[str, AcceptDecision] = field(default_factory=dict)
    acknowledged: tuple[Acknowledged, ...] = ()
    findings: tuple[Finding, ...] = ()

    @property
    def scale_loading(self) -> list[LoadingName]:
        """The loading verdict of each scale that is not known from what was read back."""
        verdicts = (scale.verdict for scale in self.scales.values())
        return [verdict for verdict in verdicts if verdict != "read_back"]


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
        scales = [scale for one in circles.values() for scale in one.scales.values()]
        faulty = any(scale.verdict != "loaded" for scale in scales)
        of_circles = "reject" in decisions or faulty or not axes
        return SentenceText(say("headline.bad", circles=of_circles))
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
    return {
        "axes": list(circle.prediction.before.test.axes),
        "before": circle_values(circle.prediction.before),
        "predicted": predicted,
        "after": after,
        "within_prediction": {
            name: _within(after.get(name), band) if circle.comparable else None
            for name, band in predicted.items()
        },
        "squareness": None if circle.squareness is None else _squareness(circle.squareness),
        "scales": {
            name: {
                "value": scale.value,
                "expected": scale.expected,
                "U": scale.U,
                "unit": "um/m",
                "verdict": scale.verdict,
                "candidates": _candidates(scale.candidates),
            }
            for name, scale in circle.scales.items()
        },
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


def _squareness(found: SquarenessAfter) -> dict[str, Any]:
    return {
        "value": found.value,
        "expected": found.expected,
        "U": found.U,
        "unit": "um/m",
        "decision": found.decision,
        "verdict": found.verdict,
        "factor": found.factor,
        "active": found.active,
        "candidates": _candidates(found.candidates),
    }


def _candidates(found: Iterable[Candidate]) -> list[dict[str, Any]]:
    return [
        {
            "verdict": each.verdict,
            "probability": rounded_number(each.probability, LOGARITHM),
            "detail": str(each.detail or ""),
        }
        for each in found
    ]


def _within(
    value: float | None, band: Mapping[str, float] | None, guard: float = 0.0
) -> bool | None:
    """Return whether a value is in the predicted 90 % interval, widened by ``guard``; None without
    a value or a prediction.
    """
    if value is None or band is None:
        return None
    return band["p05"] - guard <= value <= band["p95"] + guard
