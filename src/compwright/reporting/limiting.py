"""The causes that limit an axis: a bar for each cause in the report, one line at the terminal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from compwright.reporting.numbers import number, symbol, unit_text
from compwright.words.sentences import say

Document = Mapping[str, Any]

#: Width of a bar's picture, in its own units.
_WIDTH: Final = 200.0
#: Below this (µm, arcsec) a cause is not worth a word at the terminal.
_LEAST_SHOWN: Final = 0.005


def limits_block(predicted: Document, unit: object) -> dict[str, Any] | None:
    """Return rows with a bar for each cause that limits an axis, or None if no causes are known.

    The causes are those in ``limits`` of an axis of the prediction document. The length of a bar is
    the cause's part of the parameter.
    """
    causes, limited = predicted.get("limits") or [], predicted.get("limited")
    if not causes or not limited:
        return None
    name, small = symbol(limited["parameter"]), unit_text(unit)
    whole = max([limited["then"], *(cause["value"] for cause in causes)])
    rows = [
        {
            "words": say("limits.cause", cause=cause["cause"]),
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
    """Return the sentence on the causes that limit an axis, or "" if no causes are known."""
    limited = axis.get("limited")
    if not limited:
        return ""
    unit = unit_text(axis["unit"])
    causes = [
        f"{say('limits.name', cause=cause['cause'])} {number(cause['value'])}"
        for cause in axis["limits"]
        if cause["value"] >= _LEAST_SHOWN
    ]
    name = symbol(limited["parameter"])
    listed = f"{', '.join(causes)} {unit}" if causes else "nothing"
    if len(causes) > 1:
        listed += " (effect of each cause alone; do not add the values)"
    return f"What limits {name} ({number(limited['then'])} {unit} at new targets): {listed}."
