"""The page of a history: values over time, changes, and when a limit will be reached."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any, Final

from compwright.foundations.extras import need
from compwright.foundations.utf8 import visible
from compwright.reporting.history_words import (
    change_line,
    limit_lines,
    parameter_name,
    possible_lines,
    trend_lines,
)
from compwright.reporting.numbers import MISSING, number, unit_text
from compwright.reporting.page import render_page
from compwright.reporting.sections import Document

#: Whose course is drawn: the first that has a limit or a rate, else the first that is there.
_DRAWN: Final = ("B_mean", "A", "B", "E", "R", "slope", "squareness", "G_bidirectional", "G_ccw")
_WIDTH, _HEIGHT, _EDGE = 150.0, 30.0, 4.0


def history_page(document: Document) -> bytes:
    """Return the page of a history document (``compwright/history/1``).

    Raises UsageError if the extra ``report`` is not installed.
    """
    machines: list[dict[str, Any]] = [
        {
            "title": " · ".join(filter(None, (machine["name"], machine["serial"])))
            or "machine without a name",
            "rows": [
                _row(f"{word} {name}", one)
                for word, kind in (("axis", "axes"), ("plane", "planes"))
                for name, one in machine[kind].items()
            ],
        }
        for machine in document["machines"]
    ]
    rows = [row for machine in machines for row in machine["rows"]]
    return render_page(
        "history.html",
        {
            "page_title": "Machines over the years",
            "tone": "undecided",  # growth that is not clear is possible on every axis
            "verdict": _headline(rows),
            "machines": machines,
            "notes": document["notes"],
        },
    )


def _headline(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return how many axes and planes changed, and how many have too few tests; "None" changed is
    stated only if a rate of one of them is known.
    """
    changing, unknown = (sum(row[key] for row in rows) for key in ("changing", "unknown"))
    if unknown == len(rows) and not changing:
        return f"None of {unknown} axes and planes has enough tests for a rate"
    found = f"{changing or 'None'} of {len(rows)} axes and planes changed beyond the uncertainty"
    return f"{found}; {unknown} have too few tests for a rate" if unknown else found


def _row(name: str, one: Mapping[str, Any]) -> dict[str, Any]:
    tests, trends = one["tests"], one["trends"]
    lines, limits = list(trend_lines(one)), list(limit_lines(one))
    lines += [change_line(each, tests) for each in one["changes"] if each["table"] != "changed"]
    shown = _shown(one)
    days = [test["day"][:7] for test in tests if test["day"]]
    values = [test[shown] for test in tests if test.get(shown) is not None]
    unit = unit_text("um/m" if shown in ("squareness", "slope") else tests[-1]["unit"])
    return {
        "name": visible(name),
        "count": len(tests),
        "first": min(days, default=MISSING),
        "last": max(days, default=MISSING),
        "value": f"{parameter_name(shown)} {number(values[-1])} {unit}" if values else MISSING,
        "course": _course(tests, shown),
        "lines": [*lines, *possible_lines(one)],
        "changing": bool(lines),
        "unknown": not trends,
        "limits": limits or [MISSING],
        "mark": (
            {"tone": "bad", "text": "limit"}
            if limits
            else {"tone": "open", "text": "changes"}
            if lines
            else {"tone": "none", "text": "not clear"}
            if trends
            else {"tone": "none", "text": "too few tests"}
        ),
    }


def _shown(one: Mapping[str, Any]) -> str:
    """Return the name of the parameter to draw: the first with a clear trend, or, if none has one,
    the first with values.
    """
    trends = one["trends"]
    changing = [name for name in _DRAWN if name in trends and trends[name]["clear"]]
    there = [name for name in _DRAWN if any(test.get(name) is not None for test in one["tests"])]
    return (changing or there or _DRAWN)[0]


def _course(tests: Sequence[Mapping[str, Any]], name: str) -> Any:
    """Return a small figure that shows the values of a parameter over the dates of its tests."""
    found = [
        (datetime.fromisoformat(test["day"]).timestamp(), float(test[name]))
        for test in tests
        if test["day"] and test.get(name) is not None
    ]
    if len(found) < 2:
        return MISSING
    points = [
        (across, up)
        for across, up in zip(
            _scaled([day for day, _ in found], _EDGE, _WIDTH - _EDGE),
            _scaled([value for _, value in found], _HEIGHT - _EDGE, _EDGE),
            strict=True,
        )
    ]
    line = " ".join(f"{across:.1f},{up:.1f}" for across, up in points)
    dots = "".join(
        f'<circle cx="{across:.1f}" cy="{up:.1f}" r="1.8" fill="#0b4a82"/>' for across, up in points
    )
    text = f"{parameter_name(name)} from {number(found[0][1])} to {number(found[-1][1])}"
    return need("markupsafe").Markup(
        f'<svg viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" width="{_WIDTH:g}" height="{_HEIGHT:g}"'
        f' role="img" aria-label="{text}"><polyline points="{line}" fill="none" stroke="#0b4a82"'
        f' stroke-width="1"/>{dots}</svg>'
    )


def _scaled(values: Sequence[float], low: float, high: float) -> list[float]:
    """Return the ``values`` as coordinates: the smallest at ``low``, the largest at ``high``. If
    all values are equal, they are in the middle.
    """
    least, span = min(values), max(values) - min(values)
    if span == 0.0:
        return [0.5 * (low + high)] * len(values)
    return [low + (high - low) * (value - least) / span for value in values]
