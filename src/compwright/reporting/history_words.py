"""What a history says of rates and jumps, in words: at the terminal and on the page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from compwright.reporting.numbers import number, symbol, unit_text

_NAMES = {
    "squareness": "Squareness",
    "slope": "Slope",
    "s": "Scatter s",
    "G_bidirectional": "G(b)",
}


def parameter_name(parameter: str) -> str:
    """Return how a parameter of a history is called."""
    return _NAMES.get(parameter) or symbol(parameter)


def trend_lines(one: Mapping[str, Any]) -> Iterator[str]:
    """Yield the rates of an axis or plane that exceed three standard errors, and its jumps."""
    tests = one["tests"]
    for parameter, trend in one["trends"].items():
        name, unit = parameter_name(parameter), unit_text(trend["unit"])
        if trend["clear"]:
            yield (
                f"{name} {_signed(trend['rate_per_year'])} ± {number(trend['std_error'])} {unit}"
                f" per year ({trend['n_tests']} tests, {_month(trend['first_day'])} to"
                f" {_month(trend['last_day'])})"
            )
        for jump in trend["jumps"]:
            between = " and ".join(_month(tests[jump[end]]["day"]) for end in ("before", "after"))
            yield (
                f"{name} jumped by {_signed(jump['size'])} ± {number(jump['std_error'])} {unit}"
                f" between {between}: look for a repair, a collision or another instrument"
            )


def limit_lines(one: Mapping[str, Any]) -> Iterator[str]:
    """Yield which limits of an axis or plane will be reached, and when."""
    for parameter, trend in one["trends"].items():
        if trend["crosses"] is not None:
            limit = f"{number(trend['limit'])} {unit_text(trend['unit'])}"
            yield f"{parameter_name(parameter)} reaches its limit {limit} {_when(trend['crosses'])}"


def _when(crosses: Mapping[str, str]) -> str:
    """Return median and interval, by month."""
    late = _month(crosses["latest"]) if crosses["latest"] else "later than in 30 years"
    if not crosses["day"]:
        return f"not before {_month(crosses['earliest'])}"
    return f"about {_month(crosses['day'])} ({_month(crosses['earliest'])} to {late})"


def _month(day: str) -> str:
    return day[:7]


def _signed(value: float) -> str:
    return f"+{number(value)}" if value > 0 else number(value)
