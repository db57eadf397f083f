"""What limits an axis: a bar for each cause in the report, one line at the terminal. Computes
nothing but the length of the bars.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from compwright.reporting.numbers import number, plain, symbol, unit_text

Document = Mapping[str, Any]

#: The causes in plain words; one that is not here is shown by its own name.
_WORDS: Final = {
    "noise": "readings scatter: the same position does not come back the same (repeatability)",
    "single outliers": "single outliers",
    "shifts between traverses": "whole traverses that are shifted",
    "drift": "drift: the axis changes while it is measured",
    "temperature within its uncertainty": "temperature: a slope within what the job declares"
    " uncertain",
    "error that the test leaves open": "error that the test did not tell: between targets, and"
    " hidden in the scatter",
    "steps that the control never applies": "steps of the correction (reversal) that the control"
    " never applies, because of its acceleration and servo period",
    "no table is written": "error that was measured, and that no table takes away",
    "spacing too wide for the period": "periodic error: the points are too far apart for it",
    "spacing of the points": "what bends between the points of the table",
    "number of points": "what bends between the points: the control has too few of them",
    "one table for both directions": "reversal that changes along the travel: one table and one"
    " reversal value cannot hold it",
    "no backlash value": "reversal: the control has no value for it",
    "quantum": "resolution of the table's values",
    "value range": "largest value that the control takes",
    "backlash range": "largest reversal value that the control takes",
    "largest increment": "largest step from point to point that the control takes",
    "a straight line instead of a table": "what bends: the control holds a straight line, no table",
}
#: Width of a bar's picture, in its own units.
_WIDTH: Final = 200.0
#: Below this (µm, arcsec) a cause is not worth a word at the terminal.
_LEAST_SHOWN: Final = 0.005


def limits_block(predicted: Document, unit: object) -> dict[str, Any] | None:
    """Return the picture of ``limits`` of an axis of the prediction document: a row for each cause,
    its bar as long as its part of the parameter; None where there is nothing to show.
    """
    causes, limited = predicted.get("limits") or [], predicted.get("limited")
    if not causes or not limited:
        return None
    name, small = symbol(limited["parameter"]), unit_text(unit)
    whole = max([limited["then"], *(cause["value"] for cause in causes)])
    rows = [
        {
            "words": _WORDS.get(cause["cause"], plain(cause["cause"])),
            "value": number(cause["value"]),
            "width": _bar(cause["value"], whole),
            "rms": number(cause.get("rms"), 3) if cause.get("rms") is not None else "",
        }
        for cause in causes
    ]
    return {
        "parameter": name,
        "unit": small,
        "before": number(limited["now"]),
        "then": number(limited["then"]),
        "least": number(limited["least"]),
        "width": _bar(limited["then"], whole),
        "rows": rows,
    }


def _bar(value: float, whole: float) -> float:
    return round(_WIDTH * max(0.0, value) / whole, 1) if whole > 0.0 else 0.0


def limits_line(axis: Document) -> str:
    """Return what limits an axis of the prediction document in one line; empty where nothing is
    known.
    """
    limited = axis.get("limited")
    if not limited:
        return ""
    unit = unit_text(axis["unit"])
    causes = [
        f"{plain(cause['cause'])} {number(cause['value'])}"
        for cause in axis["limits"]
        if cause["value"] >= _LEAST_SHOWN
    ]
    name = symbol(limited["parameter"])
    told = f"{', '.join(causes)} {unit} (each alone; they do not add up)" if causes else "nothing"
    return f"What limits {name} ({number(limited['then'])} {unit} at new targets): {told}."
