"""The JSON of ``evaluate``: deviations in µm or arcsec, positions in mm or deg."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict, replace
from typing import Any, Final

import numpy as np

from compwright.documents.findings import finding_documents
from compwright.foundations.errors import Fault
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import FloatArray
from compwright.records.positioning import PositioningTest
from compwright.records.result import ExpandedUncertainty, Extreme, PositioningResult

SCHEMA = "compwright/evaluation/1"
#: Digits after the decimal point of deviations in µm or arcsec: takes away the noise of binary
#: numbers, keeps every real digit.
_DIGITS = 9
#: Coverage factor of expanded uncertainties.
COVERAGE: Final = 2.0


def evaluation_document(
    results: Iterable[PositioningResult], errors: Iterable[Fault] = ()
) -> dict[str, Any]:
    """Return the JSON document with all evaluated tests, and with ``errors``, the faults of files
    that could not be evaluated.
    """
    return {
        "schema": SCHEMA,
        "results": [result_document(result) for result in results],
        "errors": [
            {"file": fault.file, "message": str(replace(fault, file=""))} for fault in errors
        ],
    }


def result_document(result: PositioningResult) -> dict[str, Any]:
    """Return one positioning result for JSON; null for undefined parameters, with the reason.

    Some of its keys:

    - ``name``: name of the test. ``coverage``: coverage factor k. ``spread``: std or range.
      ``header``: what the file states about the test.
    - ``deviations_positive`` and ``deviations_negative`` of each target: the readings in the order
      of the runs, null where missing.
    - ``expansion_removed`` of each target: the expansion subtracted from its readings, if they were
      reduced to 20 °C. ``removed_positive`` and ``removed_negative``: the expansion of each
      reading, if an environment record states it.
    - ``thermal``: coefficients (µm/(m K)), temperatures (°C) and fixed point (mm) of this
      reduction.
    - ``extremes``: highest and lowest value for A, E, M and R.
    - ``budget``: contributions to ``uncertainty``.
    """
    test = result.test
    factor = outside_factor(test.kind.unit)
    return {
        "kind": "positioning",
        "name": test.name,
        "sources": [{"file": source.file, "sha256": source.sha256} for source in test.sources],
        "axis": test.axis,
        "axis_kind": str(test.kind),
        "standard": result.standard,
        "coverage": result.coverage,
        "spread": result.spread,
        "cycle": test.cycle,
        "position_unit": test.kind.unit,
        "unit": outside_unit(test.kind.unit),
        "n_targets": int(test.targets.size),
        "n_runs": {"positive": _traverses(test.positive), "negative": _traverses(test.negative)},
        "parameters": {name: _outside(value, factor) for name, value in result.parameters.items()},
        "at": dict(result.at),
        "extremes": {
            name: [_extreme(entry, factor) for entry in ends]
            for name, ends in result.extremes.items()
        },
        "uncertainty": uncertainty_document(result.uncertainty, factor),
        "budget": _budget(result),
        "thermal": None if test.thermal is None else asdict(test.thermal),
        "targets": _targets(result, factor),
        "not_applicable": dict(result.not_applicable),
        "header": dict(test.header),
        "findings": finding_documents(result.findings),
    }


#: What an entry holds of single readings, and what was derived from them for pictures.
_AT_LENGTH = frozenset(
    {
        *("targets", "header", "runs", "fitted", "minimum_zone", "readings"),
        *("correlation", "correlation_names", "vendor"),
    }
)


def in_short(entry: Mapping[str, Any]) -> dict[str, Any]:
    """Return the JSON entry of a test without its long parts (targets, readings, header), for
    summaries of many tests.

    The parts left out are those whose size depends on the number of readings, and texts of the
    file.
    """
    return {key: value for key, value in entry.items() if key not in _AT_LENGTH}


def _outside(value: float | None, factor: float) -> float | None:
    """Return a deviation in the unit of the JSON, or None if it is missing."""
    if value is None or not np.isfinite(value):
        return None
    return round(float(value) * factor, _DIGITS) + 0.0  # no minus zero


def _traverses(deviations: FloatArray) -> int:
    return int(np.isfinite(deviations).any(axis=0).sum())


def uncertainty_document(
    stated: Mapping[str, ExpandedUncertainty] | None, factor: float
) -> dict[str, Any] | None:
    """Return the expanded uncertainty U and the coverage factor of each parameter for JSON; U is
    multiplied by ``factor``.
    """
    if stated is None:
        return None
    return {
        name: {"U": _outside(entry.U, factor), "coverage": entry.coverage}
        for name, entry in stated.items()
    }


def _extreme(extreme: Extreme, factor: float) -> dict[str, Any]:
    return {
        "value": _outside(extreme.value, factor),
        "position": extreme.position,
        "direction": None if extreme.direction is None else extreme.direction.value,
    }


def _budget(result: PositioningResult) -> dict[str, Any] | None:
    """Return the uncertainty budget: contributors and their sum over the whole measured length."""
    if not result.budget:
        return None
    combined = math.hypot(*(one.standard for one in result.budget))
    return {
        "length": float(result.test.targets[-1] - result.test.targets[0]),
        "contributions": [
            {
                **asdict(one),
                "divisor": round(one.divisor, _DIGITS),
                "sensitivity": round(one.sensitivity, _DIGITS),
                "standard": round(one.standard, _DIGITS),
            }
            for one in result.budget
        ],
        "standard": round(combined, _DIGITS),
        "U": round(COVERAGE * combined, _DIGITS),
        "coverage": COVERAGE,
    }


def _targets(result: PositioningResult, factor: float) -> list[dict[str, Any]]:
    test, columns = result.test, result.targets
    values = {
        "mean_positive": columns.mean_positive,
        "mean_negative": columns.mean_negative,
        "s_positive": columns.s_positive,
        "s_negative": columns.s_negative,
        "reversal": columns.reversal,
        "mean": columns.mean,
        "R_positive": columns.repeatability_positive,
        "R_negative": columns.repeatability_negative,
        "R": columns.repeatability,
    }
    return [
        {
            "position": float(test.targets[i]),
            "n_positive": _count(test, i)[0],
            "n_negative": _count(test, i)[1],
            **{name: _outside(column[i], factor) for name, column in values.items()},
            **_expansion(test, i, factor),
            "deviations_positive": [_outside(value, factor) for value in test.positive[i]],
            "deviations_negative": [_outside(value, factor) for value in test.negative[i]],
        }
        for i in range(test.targets.size)
    ]


def _expansion(test: PositioningTest, i: int, factor: float) -> dict[str, Any]:
    """Return the JSON entry of the thermal expansion subtracted at target ``i`` (one value, or one
    per reading), multiplied by ``factor``; empty if none was subtracted.
    """
    if test.removed is not None:
        return {
            f"removed_{name}": [_outside(value, factor) for value in block[i]]
            for name, block in zip(("positive", "negative"), test.removed, strict=True)
        }
    if test.thermal is None:
        return {}
    removed = (float(test.targets[i]) - test.thermal.x_fix) * test.thermal.slope
    return {"expansion_removed": _outside(removed, factor)}


def _count(test: PositioningTest, i: int) -> tuple[int, int]:
    return int(np.isfinite(test.positive[i]).sum()), int(np.isfinite(test.negative[i]).sum())
