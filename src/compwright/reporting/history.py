"""A history at the terminal: what each test of a machine showed, and what changed. Computes
nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from rich.console import RenderableType
from rich.rule import Rule
from rich.table import Table

from compwright.reporting.history_words import limit_lines, parameter_name, trend_lines
from compwright.reporting.numbers import MISSING, number, symbol, unit_text
from compwright.reporting.shown import Text

_AXIS: Final = ("A", "E", "R", "B", "B_mean", "s")
_PLANE: Final = ("squareness", "G_bidirectional", "G_ccw", "G_cw")
_HEADINGS: Final = {"squareness": "squareness, µm/m", "G_bidirectional": "G(b)"}
#: Shown only where no test has the value that holds both directions (ISO 230-4:1996).
_SINGLE: Final = frozenset({"G_ccw", "G_cw"})
_STYLES: Final = {"good": "green", "loaded": "green", "bad": "red", "not_active": "red"}
#: Behind a value that differs from the one before it beyond the uncertainty.
_MARK: Final = "*"
_TABLES: Final = {
    "same": "The same table was active in both.",
    "changed": "A different table was active.",
    "unknown": "The files do not state whether the same table was active.",
}


def history_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the renderables of a ``compwright/history/1`` document."""
    shown: list[RenderableType] = []
    for machine in document["machines"]:
        title = " · ".join(filter(None, (machine["name"], machine["serial"]))) or "no name given"
        shown += [Text(title, style="bold"), Text()]
        for name, one in machine["axes"].items():
            shown += _series(f"axis {name}", one, _AXIS)
        for name, one in machine["planes"].items():
            shown += _series(f"plane {name}", one, _PLANE)
    return [*shown, *_remarks(document)]


def _series(title: str, one: Mapping[str, Any], values: Sequence[str]) -> list[RenderableType]:
    tests, changes = one["tests"], one["changes"]
    there = [name for name in values if any(test.get(name) is not None for test in tests)]
    held = [name for name in there if not ("G_bidirectional" in there and name in _SINGLE)]
    ordered = sorted(changes, key=lambda change: change["table"] == "changed")
    return [
        Rule(
            Text(f"{title}, {unit_text(tests[-1]['unit'])}", style="bold"),
            align="left",
            characters="─",
        ),
        _table(tests, changes, held),
        *(
            Text(
                change_line(change, tests),
                style="dim" if change["table"] == "changed" else "yellow",
            )
            for change in ordered
        ),
        *(Text(line, style="yellow") for line in (*trend_lines(one), *limit_lines(one))),
        Text(),
    ]


def _table(
    tests: Sequence[Mapping[str, Any]],
    changes: Sequence[Mapping[str, Any]],
    values: Sequence[str],
) -> Table:
    marked = {(change["after"], change["parameter"]) for change in changes}
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold")
    table.add_column("date", no_wrap=True)
    table.add_column("folder", overflow="fold", min_width=12)
    table.add_column("test", no_wrap=True)
    for name in values:
        table.add_column(_HEADINGS.get(name) or symbol(name), justify="right", no_wrap=True)
    for heading in ("table", "verdict"):
        table.add_column(heading, no_wrap=True)
    for place, test in enumerate(tests):
        table.add_row(
            test["day"].partition(" ")[0] or test["date"] or MISSING,
            test["folder"],
            f"{test['test']} {test['taken']}",
            *(_value(test, name, marked=(place, name) in marked) for name in values),
            _word(test["table"]),
            _word(test["verdict"]),
        )
    return table


def _value(test: Mapping[str, Any], name: str, *, marked: bool) -> Text:
    value = test.get(name)
    if value is None:
        return Text(MISSING)
    stated = test["uncertainty"].get(name)
    within = f" ± {number(stated['U'])}" if stated else ""
    text = f"{number(value)}{within}"
    return Text(f"{text}{_MARK}", style="bold yellow") if marked else Text(f"{text} ")


def _word(word: str) -> Text:
    return Text(word.replace("_", " "), style=_STYLES.get(word, ""))


def change_line(change: Mapping[str, Any], tests: Sequence[Mapping[str, Any]]) -> str:
    """Return a change, its tests, and how seldom an unchanged machine shows it."""
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
        f"{_MARK} {parameter_name(name)} from {number(change['value_before'])} to"
        f" {number(change['value_after'])} {unit} between {_when(before)} and"
        f" {_when(after)}: {'+' if size > 0 else ''}{number(size)} {unit}{errors}{slope},"
        f" {_SHOWN.get(name, 'an unchanged machine shows that')} {_odds(change['chance'])}."
        f" {_TABLES[change['table']]}"
    )


#: Scatter tells of the hall and the instrument as well.
_SHOWN: Final = {"s": "the same machine, instrument and hall without drift show that"}


def _when(test: Mapping[str, Any]) -> str:
    return str(test["day"].partition(" ")[0] or f"{test['folder']} ({test['taken']})")


def _odds(chance: float) -> str:
    """Return how seldom, in round words."""
    if chance < 1e-6:
        return "less than once in a million"
    return f"once in {float(f'{1.0 / chance:.1g}'):,.0f}".replace(",", " ")


def _remarks(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return what has to be said of folders: what is not as it was written first."""
    lines = [
        Text(f"{folder['folder']}/{file['file']}: {_STATES[file['state']]}", "yellow")
        for folder in document["folders"]
        for file in folder["files"]
    ]
    lines += [
        Text(f"{folder['folder']}: {note}")
        for folder in document["folders"]
        for note in folder["notes"]
    ]
    return [*lines, *(Text(note) for note in document["notes"])]


_STATES: Final = {
    "changed": "is not as it was written (its hash differs)",
    "missing": "is not there any more",
    "unreadable": "cannot be read",
}
