"""A history at the terminal: the results of each test of a machine, and the changes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from rich.console import RenderableType
from rich.rule import Rule
from rich.table import Table

from compwright.reporting.history_words import (
    CHANGED_MARK,
    change_line,
    limit_lines,
    possible_lines,
    trend_lines,
)
from compwright.reporting.numbers import MISSING, number, symbol, unit_text
from compwright.reporting.safe_text import Text

_AXIS: Final = ("A", "E", "R", "B", "B_mean", "s")
_PLANE: Final = ("squareness", "G_bidirectional", "G_ccw", "G_cw")
_HEADINGS: Final = {"squareness": "squareness, µm/m", "G_bidirectional": "G(b)"}
#: Shown only where no test has the value that holds both directions (ISO 230-4:1996).
_SINGLE: Final = frozenset({"G_ccw", "G_cw"})
_STYLES: Final = {"good": "green", "loaded": "green", "bad": "red", "not_active": "red"}


def history_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return a history (JSON document ``compwright/history/1``) as terminal output."""
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
        *(Text(line) for line in possible_lines(one)),
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
    return Text(f"{text}{CHANGED_MARK}", style="bold yellow") if marked else Text(f"{text} ")


def _word(word: str) -> Text:
    return Text(word.replace("_", " "), style=_STYLES.get(word, ""))


def _remarks(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the lines about result folders: first the files that were changed after a command had
    written them, then the notes.
    """
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
