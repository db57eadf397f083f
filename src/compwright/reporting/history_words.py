"""Sentences about rates and jumps in a history, for the terminal and the page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from compwright.reporting.numbers import number, symbol, unit_text

#: Behind a value that differs from the one before it beyond the uncertainty.
CHANGED_MARK: Final = "*"
_TABLES: Final = {
    "same": "The same table was active in both tests.",
    "changed": "Different tables were active in the two tests.",
    "unknown": "The files do not state whether the same table was active in both tests.",
}
_NAMES = {
    "squareness": "Squareness",
    "slope": "Slope",
    "s": "Scatter s",
    "G_bidirectional": "G(b)",
}
#: Parameters that show wear first.
_WEAR: Final = ("B_mean", "slope", "squareness")


def parameter_name(parameter: str) -> str:
    """Return the printed name of a parameter in a history."""
    return _NAMES.get(parameter) or symbol(parameter)


def trend_lines(one: Mapping[str, Any]) -> Iterator[str]:
    """Yield as text the significant rates of change (``clear``) and the jumps of all parameters of
    ``one`` axis or plane in a history.
    """
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


def possible_lines(one: Mapping[str, Any]) -> Iterator[str]:
    """Yield as text the rates that remain possible where no growth is clear: of the parameters that
    show wear first, or of the first parameter if ``one`` axis or plane has none of these.
    """
    trends = one["trends"]
    for parameter in [name for name in _WEAR if name in trends] or list(trends)[:1]:
        trend = trends[parameter]
        if not trend["clear"]:
            low, high = map(_signed, trend["interval"])
            yield (
                f"{parameter_name(parameter)}: growth is not clear, {low} to {high}"
                f" {unit_text(trend['unit'])} per year is possible (95 %)"
            )


def limit_lines(one: Mapping[str, Any]) -> Iterator[str]:
    """Yield sentences on when a parameter of ``one`` axis or plane will probably reach its limit,
    for each parameter with a trend towards its limit.
    """
    for parameter, trend in one["trends"].items():
        if trend["crosses"] is not None:
            limit = f"{number(trend['limit'])} {unit_text(trend['unit'])}"
            yield f"{parameter_name(parameter)} reaches its limit {limit} {_when(trend['crosses'])}"


def _when(crosses: Mapping[str, str]) -> str:
    """Return the month in which a limit is probably reached, with its interval, as text."""
    late = _month(crosses["latest"]) if crosses["latest"] else "later than in 30 years"
    if not crosses["day"]:
        return f"not before {_month(crosses['earliest'])}"
    return f"about {_month(crosses['day'])} ({_month(crosses['earliest'])} to {late})"


def _month(day: str) -> str:
    return day[:7]


def _signed(value: float) -> str:
    return f"+{number(value)}" if value > 0 else number(value)


def change_line(change: Mapping[str, Any], tests: Sequence[Mapping[str, Any]]) -> str:
    """Return a change between two tests as text, with the probability that it appears although the
    machine has not changed.
    """
    before, after = (tests[change[which]] for which in ("before", "after"))
    name = change["parameter"]
    unit = "µm/m" if name == "squareness" else unit_text(change["unit"])
    size = change["size"]
    many = change["standard_errors"]
    errors = f", {abs(many):.0f} standard errors" if many is not None else ""
    slope = (
        " with the slope of 1 K of steel allowed for (no uncertainty is declared)"
        if change["undeclared"]
        else ""
    )
    return (
        f"{CHANGED_MARK} {parameter_name(name)} changed from {number(change['value_before'])} to"
        f" {number(change['value_after'])} {unit} between {_date(before)} and"
        f" {_date(after)}: {_signed(size)} {unit}{errors}{slope}."
        f" {_SHOWN.get(name, 'An unchanged machine shows such a change')}"
        f" {_odds(change['chance'])}."
        f" {_TABLES[change['table']]}"
    )


#: Scatter tells of the hall and the instrument as well.
_SHOWN: Final = {"s": "The same machine, instrument and hall without drift show such a change"}


def _date(test: Mapping[str, Any]) -> str:
    return str(test["day"].partition(" ")[0] or f"{test['folder']} ({test['taken']})")


def _odds(chance: float) -> str:
    """Return a small probability as text, such as "once in 300"."""
    if chance < 1e-6:
        return "less than once in a million comparisons"
    return f"once in {float(f'{1.0 / chance:.1g}'):,.0f} comparisons".replace(",", " ")
