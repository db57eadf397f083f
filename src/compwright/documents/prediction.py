"""The file ``prediction.json``: deviations in µm or arcsec, positions in mm or deg."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from compwright.documents.findings import finding_documents
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE, outside_factor, outside_unit
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.circular import CircularResult
from compwright.records.correction import AxisCompensation, CrossCompensation, Judged
from compwright.records.estimate import PeriodEvidence
from compwright.records.job import Acknowledged
from compwright.records.limits import LimitingCauses, PointCountOption
from compwright.records.prediction import (
    AcceptDecision,
    AxisPrediction,
    CirclePrediction,
    Quantiles,
    TestPrediction,
)
from compwright.records.result import PositioningResult
from compwright.records.rounding import OUTSIDE, rounded_number

SCHEMA = "compwright/prediction/1"


def prediction_document(
    format_id: str,
    axes: Mapping[str, AxisPrediction],
    cross: Iterable[CrossCompensation] = (),
    circles: Mapping[str, CirclePrediction] | None = None,
    doubts: Iterable[Finding] = (),
    acknowledged: Iterable[Acknowledged] = (),
    *,
    judged: Judged,
) -> dict[str, Any]:
    """Return the prediction of a run as JSON. ``cross``: corrections of an axis by another axis;
    ``judged``: whether two independent programs read the written files back, or one alone.

    ``axes``, ``circles``: predictions by name of the axis or of the circular test. ``doubts``:
    questions to be resolved before the tables are loaded. ``acknowledged``: the doubts that the job
    acknowledges.
    """
    return {
        "schema": SCHEMA,
        "format": format_id,
        "doubts": finding_documents(doubts),
        "acknowledged": acknowledged_outside(acknowledged),
        "axes": {name: _axis(axis, judged) for name, axis in axes.items()},
        "cross": [cross_outside(entry) for entry in cross],
        "circles": {name: circle_outside(circle) for name, circle in (circles or {}).items()},
    }


def acknowledged_outside(acknowledged: Iterable[Acknowledged]) -> list[dict[str, Any]]:
    """Return for JSON the doubts that a job acknowledges, each with the reason given in the job."""
    return [
        {**finding_documents([each.finding])[0], "reason": each.by.reason} for each in acknowledged
    ]


def cross_outside(entry: CrossCompensation) -> dict[str, Any]:
    """Return the correction of one axis by another for JSON, in µm or arcsec.

    ``correction`` applies to both directions. If they differ, it is the correction for +, and both
    are given in ``correction_positive`` and ``correction_negative``.
    """
    factor = outside_factor(entry.output_kind.unit)
    positive, negative = ((curve * factor).tolist() for curve in (entry.positive, entry.negative))
    both = (
        {}
        if positive == negative
        else {"correction_positive": positive, "correction_negative": negative}
    )
    return {
        "input": entry.input,
        "output": entry.output,
        "positions": entry.positions.tolist(),
        "correction": positive,
        **both,
        "unit": outside_unit(entry.output_kind.unit),
    }


def circle_outside(circle: CirclePrediction) -> dict[str, Any]:
    """Return a circular test for JSON: its parameters (µm) and error causes as measured and as
    predicted. If nothing is predicted, ``not_applicable`` gives the reason.
    """
    reason = circle.before.not_applicable.get("diagnosis", "")
    return {
        "axes": list(circle.before.test.axes),
        "before": circle_values(circle.before),
        "predicted": circle_quantiles(circle),
        **({} if circle.predicted else {"not_applicable": {"predicted": reason}}),
        "accept": _accept(circle.accept),
    }


def circle_values(result: CircularResult) -> dict[str, float | None]:
    """Return the parameters (µm) and error causes (each in its own unit) of a circular test, by
    JSON name.
    """
    values = {
        name: None if value is None else rounded_number(value * MICROMETRES_PER_MILLIMETRE, OUTSIDE)
        for name, value in result.parameters.items()
    }
    if result.diagnosis is None:
        return values
    not_given = result.diagnosis.not_given
    causes = {
        name: None if name in not_given else rounded_number(effect.value, OUTSIDE)
        for name, effect in result.diagnosis.effects.items()
    }
    return {**values, **causes}


def circle_quantiles(circle: CirclePrediction) -> dict[str, dict[str, float] | None]:
    """Return the predicted quantiles of the parameters and error causes of a circular test, by JSON
    name: None for each measured parameter if nothing is predicted.
    """
    if not circle.predicted:
        given = circle.before.parameters.items()
        return {name: None for name, value in given if value is not None}
    return {
        **quantiles_outside(circle.predicted, AxisKind.LINEAR),
        **{
            name: {
                "median": rounded_number(value.median, OUTSIDE),
                "p05": rounded_number(value.p05, OUTSIDE),
                "p95": rounded_number(value.p95, OUTSIDE),
            }
            for name, value in circle.causes.items()
        },
    }


def parameters_outside(result: PositioningResult) -> dict[str, float | None]:
    """Return the parameters of an evaluation in µm or arcsec."""
    factor = outside_factor(result.test.kind.unit)
    return {
        name: None if value is None else value * factor for name, value in result.parameters.items()
    }


def quantiles_outside(
    quantiles: Mapping[str, Quantiles], kind: AxisKind
) -> dict[str, dict[str, float]]:
    """Return predicted parameters in µm or arcsec."""
    factor = outside_factor(kind.unit)
    return {
        name: {
            "median": value.median * factor,
            "p05": value.p05 * factor,
            "p95": value.p95 * factor,
        }
        for name, value in quantiles.items()
    }


def compensation_outside(table: AxisCompensation) -> dict[str, Any]:
    """Return a table for JSON: correction including backlash per direction, µm or arcsec."""
    factor = outside_factor(table.kind.unit)
    return table_outside(
        table.positions,
        table.total(Direction.POSITIVE) * factor,
        table.total(Direction.NEGATIVE) * factor,
        table.kind,
    )


def table_outside(
    positions: FloatArray, positive: FloatArray, negative: FloatArray, kind: AxisKind
) -> dict[str, Any]:
    """Return a table for JSON; ``positions`` are in mm or deg, the corrections already in µm or
    arcsec.
    """
    return {
        "positions": positions.tolist(),
        "correction_positive": positive.tolist(),
        "correction_negative": negative.tolist(),
        "unit": outside_unit(kind.unit),
    }


def _test(test: TestPrediction) -> dict[str, Any]:
    kind = test.before.test.kind
    return {
        "name": test.name,
        "before": parameters_outside(test.before),
        "predicted": quantiles_outside(test.predicted, kind),
        "predicted_new_targets": quantiles_outside(test.predicted_new_targets, kind),
    }


def _causes(limits: LimitingCauses, factor: float, unit: str) -> list[dict[str, Any]]:
    return [
        {
            "cause": cause.cause,
            "value": cause.value * factor,
            "unit": unit,
            **({} if cause.rms is None else {"rms": cause.rms * factor}),
        }
        for cause in limits.causes
    ]


def _limited(limits: LimitingCauses, factor: float) -> dict[str, Any]:
    return {
        "parameter": limits.parameter,
        "now": limits.now * factor,
        "then": limits.then * factor,
        "least": limits.least * factor,
    }


def _worth(worth: PointCountOption, factor: float) -> dict[str, Any]:
    return {
        "points": worth.points,
        "spacing": worth.spacing,
        "median": worth.median * factor,
        "p05": worth.p05 * factor,
        "p95": worth.p95 * factor,
        "written": worth.written,
        "there": worth.there,
    }


def _axis(axis: AxisPrediction, judged: Judged) -> dict[str, Any]:
    tests = [_test(test) for test in axis.tests]
    kind = axis.tests[0].before.test.kind
    factor = outside_factor(kind.unit)
    unit = outside_unit(kind.unit)
    return {
        "tests": tests,
        "unit": unit,
        "before": tests[0]["before"],
        "predicted": tests[0]["predicted"],
        "predicted_new_targets": tests[0]["predicted_new_targets"],
        "table": compensation_outside(axis.table) if axis.table is not None else None,
        "judged": judged,
        "quantum": axis.quantum * factor if axis.quantum is not None else None,
        "limits": [] if axis.limits is None else _causes(axis.limits, factor, unit),
        "limited": None if axis.limits is None else _limited(axis.limits, factor),
        "points_worth": [_worth(one, factor) for one in axis.worth],
        "accept": _accept(axis.accept),
        "periods": [asdict(period) for period in axis.periods],
        "period_search": None if axis.evidence is None else _evidence(axis.evidence, factor),
        "findings": finding_documents(axis.findings),
    }


def _accept(accept: Mapping[str, AcceptDecision]) -> dict[str, Any]:
    return {
        name: {
            "limit": entry.limit,
            "decision": entry.decision,
            **({"test": entry.test} if entry.test is not None else {}),
            **({"U": entry.U, "rule": entry.rule} if entry.rule == "guarded" else {}),
        }
        for name, entry in accept.items()
    }


def _evidence(evidence: PeriodEvidence, factor: float) -> dict[str, Any]:
    """Return the evidence for periodic errors and the least detectable amplitudes, for JSON.

    ``factor``: from mm or deg to the unit of the JSON (µm or arcsec). An amplitude is null if no
    amplitude can be detected.
    """
    return {
        "periods": evidence.periods.tolist(),
        "log_odds": evidence.log_odds.tolist(),
        "detectable": [
            round(each * factor, 4) if math.isfinite(each) else None
            for each in evidence.detectable.tolist()
        ],
        "alike": [list(group) for group in evidence.alike],
    }
