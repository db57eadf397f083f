"""Hand-made documents for the tests of `reporting`, and the printed tables of the standards with their printed parameters."""

from __future__ import annotations

import csv
import math
import random
import statistics
from collections.abc import Sequence
from typing import Any

from places import STANDARD_TABLES

Readings = Sequence[Sequence[float | None]]


def positioning(
    positions: Sequence[float],
    positive: Readings | None,
    negative: Readings | None,
    parameters: dict[str, float | None],
    *,
    unit: str = "um",
    coverage: float = 2.0,
    standard: str = "iso230-2:2014",
    name: str = "x_before",
    axis: str = "X",
) -> dict[str, Any]:
    """An entry of an evaluation document; per-target statistics crudely from the readings, parameters as given."""
    targets = []
    for index, position in enumerate(positions):
        entry: dict[str, Any] = {"position": position}
        for key, readings in (("positive", positive), ("negative", negative)):
            values = [value for value in (readings[index] if readings else []) if value is not None]
            entry[f"n_{key}"] = len(values)
            entry[f"mean_{key}"] = statistics.fmean(values) if values else None
            entry[f"s_{key}"] = statistics.stdev(values) if len(values) > 1 else None
            entry[f"R_{key}"] = 2 * coverage * entry[f"s_{key}"] if len(values) > 1 else None
            entry[f"deviations_{key}"] = list(readings[index]) if readings else []
        both = positive is not None and negative is not None
        entry["reversal"] = entry["mean_positive"] - entry["mean_negative"] if both else None
        entry["mean"] = (entry["mean_positive"] + entry["mean_negative"]) / 2 if both else None
        entry["R"] = None
        targets.append(entry)
    return {
        "kind": "positioning",
        "name": name,
        "sources": [{"file": f"runs/{name}.csv", "sha256": "a3f1" * 16}],
        "axis": axis,
        "axis_kind": "linear" if unit == "um" else "rotary",
        "standard": standard,
        "cycle": "standard",
        "position_unit": "mm" if unit == "um" else "deg",
        "unit": unit,
        "coverage": coverage,
        "n_targets": len(positions),
        "n_runs": {"positive": len(positive[0]) if positive else 0, "negative": len(negative[0]) if negative else 0},
        "parameters": parameters,
        "at": {"R": 1408.462, "B": 175.077} if parameters.get("R") is not None else {},
        "uncertainty": None,
        "targets": targets,
        "not_applicable": {key: "one approach per direction (clause 5.2)" for key, value in parameters.items() if value is None},
        "findings": [],
    }


def printed_table(year: int) -> dict[str, Any]:
    """Table 2 of ISO 230-2:1988 or 1997 with the parameters that the document prints (µm)."""
    with (STANDARD_TABLES / f"iso-230-2-{year}-table-2.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    positions = sorted({float(row["target_mm"]) for row in rows})
    sides = {
        sign: [[float(r["deviation_um"]) for r in rows if float(r["target_mm"]) == p and r["direction"] == sign] for p in positions]
        for sign in "+-"
    }
    printed: dict[int, dict[str, float | None]] = {
        1988: {"A": 18.03, "R": 13.49, "R_positive": 11.84, "R_negative": 9.9, "B_mean": -1.53, "E": None, "M": None, "B": None},
        1997: {
            "A": 9.6, "A_positive": 6.1, "A_negative": 5.7, "E": 7.7, "E_positive": 3.9, "E_negative": 4.0, "M": 4.0,
            "R": 6.5, "R_positive": 2.9, "R_negative": 2.5, "B": 4.1, "B_mean": -3.7,
        },
    }  # fmt: skip
    return positioning(
        positions, sides["+"], sides["-"], printed[year],
        coverage=3.0 if year == 1988 else 2.0, standard=f"iso230-2:{year}", name=f"table_2_{year}",
    )  # fmt: skip


def made_up(amplitude: float = 12.0, reversal: float = -6.0, *, seed: int = 4, **more: Any) -> dict[str, Any]:
    """A screw axis from -850 to 0 mm, n = 5, with lost motion. The parameters are round numbers put in by hand."""
    generator = random.Random(seed)  # noqa: S311  not for secrets
    positions = [round(-835.0 + 81.7 * index + generator.uniform(-8, 8), 3) for index in range(11)]

    def readings(offset: float) -> list[list[float]]:
        return [
            [round(amplitude * math.sin(p / 260) + 0.012 * p + offset + generator.gauss(0, 0.7), 2) for _ in range(5)]
            for p in positions
        ]

    parameters: dict[str, float | None] = {
        "A": 31.42, "A_positive": 25.9, "A_negative": 26.1, "E": 28.77, "E_positive": 23.4, "E_negative": 23.6, "M": 22.8,
        "R": 9.31, "R_positive": 3.61, "R_negative": 3.27, "B": 6.84, "B_mean": -6.02,
    }  # fmt: skip
    parameters.update(more.pop("parameters", {}))
    return positioning(positions, readings(reversal / 2), readings(-reversal / 2), parameters, **more)


def quantiles(median: float, low: float, high: float) -> dict[str, float]:
    return {"median": median, "p05": low, "p95": high}
