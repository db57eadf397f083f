"""The figure of a history: one row for each axis and plane, over the dates of its tests."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any, Final

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.extras import need
from compwright.foundations.utf8 import visible
from compwright.reporting.charts import Document
from compwright.reporting.numbers import symbol, unit_text
from compwright.reporting.panels import known_format, new_figure, render, style

_ROW_HEIGHT: Final = 2.1  # inches
_COLUMNS: Final = {"axes": ("A", "B_mean", "s"), "planes": ("squareness", "G_bidirectional")}
_WORDS: Final = {
    "A": "Accuracy A",
    "B_mean": "Mean reversal value",
    "s": "Scatter s of a reading",
    "squareness": "Squareness",
    "G_bidirectional": "Circular deviation G(b)",
}
_SYMBOLS: Final = {"squareness": "β", "G_bidirectional": "G(b)"}
_COLOUR: Final = "#0b4a82"
_CHANGED: Final = "#b3202c"
#: A different table was active: the difference was to be expected.
_COMPENSATED: Final = "#3a7d44"
#: Tests whose places can still be distinguished on an axis; further labels are left out.
_MOST_LABELS: Final = 12


def history_plot(document: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return the figure of a history: values before and after loading, ± two standard errors.

    ``document``: ``compwright/history/1``. A value is red if it changed beyond its uncertainty, and
    green if it did so with another table active. Raises UsageError if there is nothing to draw, for
    an unknown format, and if the extra ``report`` is not installed.
    """
    kind = known_format(format)
    rows = list(_rows(document))
    if not rows:
        raise UsageError(
            Fault(
                message="there is no test to plot",
                expected="a folder with a test",
                hint="give a folder that `compwright run` or `verify` wrote",
            )
        )
    with style():
        figure = new_figure(_ROW_HEIGHT * len(rows) + 0.5)
        panels = figure.subplots(len(rows), 3, squeeze=False)
        for line, (title, kind_of, one) in zip(panels, rows, strict=True):
            _draw_row(line, title, kind_of, one)
        _legend(figure)
        return render(figure, kind)


def _rows(document: Document) -> Any:
    for machine in document["machines"]:
        name = visible(machine["serial"] or machine["name"] or "")
        for kind in ("axes", "planes"):
            for what, one in machine[kind].items():
                word = "axis" if kind == "axes" else "plane"
                yield f"{word} {visible(what)}{f' · {name}' if name else ''}", kind, one


def _draw_row(line: Any, title: str, kind: str, one: Mapping[str, Any]) -> None:
    tests = one["tests"]
    places, dated = _places(tests)
    names = _COLUMNS[kind]
    for index, panel in enumerate(line):
        if index >= len(names):
            panel.set_visible(False)
            continue
        name = names[index]
        _draw(panel, places, tests, name, [c for c in one["changes"] if c["parameter"] == name])
        panel.set_title(_WORDS[name], loc="right" if index == 0 else "left", fontsize=8.0)
        if index == 0:
            panel.set_title(title, fontweight="bold")
        unit = "µm/m" if name == "squareness" else unit_text(tests[-1]["unit"])
        panel.set_ylabel(f"{_SYMBOLS.get(name) or symbol(name)}, {unit}")
        _label(panel, places, tests, dated=dated)


def _places(tests: Sequence[Mapping[str, Any]]) -> tuple[list[float], bool]:
    """Return the x coordinates of tests in a plot. The second value is True if these are dates,
    False if they only count the tests.

    Dates are used if all tests have one and at least two of the dates differ; else the coordinates
    are 0, 1, 2, ...
    """
    days = [test["day"] for test in tests]
    if not all(days) or len(set(days)) < 2:
        return [float(place) for place in range(len(tests))], False
    to_number = need("matplotlib.dates").date2num
    return [float(to_number(datetime.fromisoformat(day))) for day in days], True


def _draw(
    panel: Any,
    places: Sequence[float],
    tests: Sequence[Mapping[str, Any]],
    name: str,
    changes: Sequence[Mapping[str, Any]],
) -> None:
    shown = [place for place, test in enumerate(tests) if test.get(name) is not None]
    values = {place: float(tests[place][name]) for place in shown}
    panel.plot(
        [places[place] for place in shown], [values[place] for place in shown],
        color=_COLOUR, linewidth=0.9, alpha=0.6, zorder=1,
    )  # fmt: skip
    for change in changes:
        ends = (change["before"], change["after"])
        panel.plot(
            [places[end] for end in ends], [values[end] for end in ends],
            color=_colour(change), linewidth=1.6, zorder=2,
        )  # fmt: skip
    colours = {change["after"]: _colour(change) for change in changes}
    for place in shown:
        colour = colours.get(place, _COLOUR)
        error = tests[place]["std_error"].get(name) or 0.0
        panel.errorbar(
            [places[place]], [values[place]], yerr=[2.0 * error] if math.isfinite(error) else None,
            marker="o" if tests[place]["taken"] == "after" else "s", markersize=4.6,
            markerfacecolor=colour if tests[place]["taken"] == "after" else "white",
            markeredgecolor=colour, ecolor=colour, elinewidth=0.8, capsize=2.0,
            linestyle="none", zorder=3,
        )  # fmt: skip
    if name in ("B_mean", "squareness"):
        panel.axhline(0.0, color="#888888", linewidth=0.6, zorder=0)
    else:
        panel.set_ylim(bottom=0.0)


def _colour(change: Mapping[str, Any]) -> str:
    return _COMPENSATED if change["table"] == "changed" else _CHANGED


def _legend(figure: Any) -> None:
    line = need("matplotlib.lines").Line2D
    marks = {"linestyle": "none", "markersize": 4.6, "markeredgecolor": _COLOUR}
    handles = [
        line([], [], marker="s", markerfacecolor="white", label="before loading", **marks),
        line([], [], marker="o", markerfacecolor=_COLOUR, label="after loading", **marks),
        line([], [], color=_CHANGED, linewidth=1.6, label="changed beyond the uncertainty"),
        line([], [], color=_COMPENSATED, linewidth=1.6, label="the same, with another table"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles))


def _label(
    panel: Any, places: Sequence[float], tests: Sequence[Mapping[str, Any]], *, dated: bool
) -> None:
    if dated:
        dates = need("matplotlib.dates")
        locator = dates.AutoDateLocator(minticks=2, maxticks=5)
        panel.xaxis.set_major_locator(locator)
        panel.xaxis.set_major_formatter(dates.ConciseDateFormatter(locator))
    else:
        step = max(1, math.ceil(len(tests) / _MOST_LABELS))
        panel.set_xticks(
            list(places[::step]),
            [_short(test) for test in tests[::step]],
            rotation=30,
            ha="right",
        )
    room = 0.06 * (max(places) - min(places)) or 0.5
    panel.set_xlim(min(places) - room, max(places) + room)


def _short(test: Mapping[str, Any]) -> str:
    """Return the label of a test without a date: the end of its folder's name."""
    name = visible(str(test["folder"])).replace("\\", "/").rpartition("/")[2]
    return f"{name[-14:]} {test['taken']}"
