"""The entry of one test in a record (µm or arcsec), from the document of its evaluation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

#: The instrument of simulated ballbar files.
_BALLBAR = "virtual ballbar"
#: Parameters of a test that a record contains; the others are in the evaluation.
PARAMETERS = ("A", "E", "M", "R", "B", "B_mean")
CIRCLE_PARAMETERS = ("G_bidirectional", "G_ccw", "G_cw")

#: From the document of a positioning result to standard errors by parameter: value in its unit,
#: and degrees of freedom.
Errors = Callable[[Mapping[str, Any]], Mapping[str, tuple[float, float]]]


def measured_test(
    result: Mapping[str, Any], taken: str, measured_in: Mapping[str, str], errors: Errors
) -> dict[str, Any]:
    """Return a record's entry of one test, made from the test's entry in an evaluation document.
    ``taken``: whether the test was made ``before`` or ``after`` loading.

    ``measured_in``: name of the control's state by ``axis test``, or by the name of a circular
    test. ``errors``: the function that returns the standard errors of a positioning result. In the
    entry, ``date`` is the date in the file, empty without one. ``s`` is the pooled standard
    deviation of a reading.
    """
    header = {str(key).lower(): str(value) for key, value in result.get("header", {}).items()}
    common = {
        "kind": result["kind"],
        "name": result["name"],
        "taken": taken,
        "date": header.get("date", ""),
        "instrument": header.get("instrument", ""),
        "simulated": "simulated" in header or header.get("instrument") == _BALLBAR,
        "standard": result["standard"],
        "unit": result["unit"],
        "sources": [source["sha256"] for source in result["sources"]],
    }
    if result["kind"] == "circular":
        return {**common, **_circle(result), "measured_in": measured_in.get(result["name"], "")}
    place = f"{result['axis']} {result['name']}"
    return {**common, **_axis(result, errors), "measured_in": measured_in.get(place, "")}


def _axis(result: Mapping[str, Any], errors: Errors) -> dict[str, Any]:
    stated = result["uncertainty"] or {}
    return {
        "axis": result["axis"],
        "axis_kind": result["axis_kind"],
        "targets": [target["position"] for target in result["targets"]],
        "mean_positive": _means(result, "mean_positive"),
        "mean_negative": _means(result, "mean_negative"),
        "n_runs": dict(result["n_runs"]),
        "parameters": {
            **{
                name: result["parameters"][name]
                for name in PARAMETERS
                if name in result["parameters"]
            },
            **_slope(result),
        },
        "uncertainty": {
            **{name: stated[name] for name in PARAMETERS if name in stated},
            **(_common_slope(result) if stated else {}),
        },
        "s": pooled(result["targets"]),
        "std_error": {
            name: {"value": round(error, 9), "dof": round(dof, 3)}
            for name, (error, dof) in errors(result).items()
        },
    }


def _means(result: Mapping[str, Any], key: str) -> list[float]:
    """Return the mean deviations of all targets in a direction; empty if the mean of a target is
    missing.
    """
    means = [target.get(key) for target in result["targets"]]
    return [] if None in means else [round(mean, 9) for mean in means]


def _slope(result: Mapping[str, Any]) -> dict[str, float]:
    """Return the least-squares slope of the mean deviation of a linear axis, in µm/m."""
    found = []
    for target in result["targets"]:
        means = (target.get(name) for name in ("mean", "mean_positive", "mean_negative"))
        found += [(target["position"], mean) for mean in means if mean is not None][:1]
    if result["axis_kind"] != "linear" or len({position for position, _ in found}) < 2:
        return {}
    positions, means = np.array(found, dtype=np.float64).T
    centred = positions - positions.mean()
    return {"slope": round(1000.0 * float(centred @ means / (centred @ centred)), 9)}


def _common_slope(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the expanded uncertainty of the slope of a linear axis that all tests with the same
    instrument share, in µm/m: that of the instrument and of the expansion coefficient.
    """
    budget = result.get("budget")
    if result["axis_kind"] != "linear" or budget is None or budget["length"] <= 0.0:
        return {}
    shared = [
        one["standard"]
        for one in budget["contributions"]
        if one["source"] == "device" or one["source"].startswith("U_alpha")
    ]
    coverage = budget["coverage"]
    U = round(1000.0 * coverage * math.hypot(*shared) / budget["length"], 9)
    return {"slope": {"U": U, "coverage": coverage}}


def _circle(result: Mapping[str, Any]) -> dict[str, Any]:
    squareness = (result.get("diagnosis") or {}).get("squareness")
    return {
        "plane": result["plane"],
        "axes": list(result["axes"]),
        "parameters": {
            name: result["parameters"][name]
            for name in CIRCLE_PARAMETERS
            if name in result["parameters"]
        },
        "squareness": (
            None
            if squareness is None or squareness["value"] is None
            else {key: squareness[key] for key in ("value", "std_error", "unit")}
        ),
    }


def pooled(targets: Iterable[Mapping[str, Any]]) -> float | None:
    """Return the pooled standard deviation of readings; None if no target has repeated readings."""
    total, dof = 0.0, 0
    for target in targets:
        for direction in ("positive", "negative"):
            s, n = target[f"s_{direction}"], target[f"n_{direction}"]
            if s is not None and n > 1:
                total += (n - 1) * s * s
                dof += n - 1
    return round(math.sqrt(total / dof), 9) if dof else None
