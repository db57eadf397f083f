"""Many tests at the terminal: one line each, and a summary.

This module loads rich. A module for a command that may not print tables must import it inside a
function.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Any, Final

from rich.cells import cell_len, set_cell_size
from rich.console import ConsoleOptions, RenderableType
from rich.measure import Measurement
from rich.rule import Rule

from compwright.foundations.findings import DOUBTS
from compwright.foundations.utf8 import visible
from compwright.reporting.causes import ranked_causes
from compwright.reporting.numbers import number, standard_text, symbol, unit_text
from compwright.reporting.safe_text import Text

_Result = Mapping[str, Any]
#: Parameters with a column of their own, by kind of test and edition.
_ISO: Final = ("A", "E", "M", "R", "B")
_VDI: Final = ("P", "Pa", "Ps_max", "Ps_mean", "U_max")
_STAND_STILL: Final = ("E_VE",)
_CIRCLE: Final = ("G_ccw", "G_cw", "G_bidirectional")
_CIRCLE_1996: Final = ("G_ccw", "G_cw", "H")
_SYMBOLS: Final = {"G_ccw": "G ccw", "G_cw": "G cw", "G_bidirectional": "G both", "H": "H"}
_STYLES: Final = {"info": "dim", "warning": "yellow", "error": "red"}
#: The column of files is at least so wide; it gets what the others leave.
_NARROWEST: Final = 16
_GAP: Final = 2


def evaluation_list(
    document: Mapping[str, Any], summary: Mapping[str, Any]
) -> list[RenderableType]:
    """Return the terminal output of many tests: a table for each kind and standard, then the
    summary.
    """
    folder = _common_folder(
        source["file"] for result in document["results"] for source in result["sources"]
    )
    shown: list[RenderableType] = []
    for (kind, standard), some in _apart(document["results"]).items():
        where = f" · {visible(folder)}" if folder else ""
        title = Text(f"{_tests(len(some), kind)} · {standard_text(standard)}{where}", style="bold")
        shown += [
            Rule(title, align="left", characters="─"),
            _circles(some, folder) if kind == "circular" else _axes(some, folder),
            Text(),
        ]
    return [*shown, *_summary(summary, folder)]


def _apart(results: Iterable[_Result]) -> dict[tuple[str, str], list[_Result]]:
    """Group the results by kind of test and by standard; the groups of positioning tests come
    first.
    """
    parts: dict[tuple[str, str], list[_Result]] = {}
    for result in sorted(results, key=lambda result: bool(result["kind"] == "circular")):
        parts.setdefault((result["kind"], result["standard"]), []).append(result)
    return parts


@dataclass(frozen=True, slots=True)
class _ListCell:
    text: str
    style: str = ""


@dataclass(frozen=True, slots=True)
class _ListColumn:
    """A column of a list. ``right``: align right (numbers); ``cut``: use the width that is left."""

    head: str
    cells: Sequence[_ListCell]
    right: bool = False
    cut: bool = False

    @property
    def width(self) -> int:
        return max(map(cell_len, (self.head, *(cell.text for cell in self.cells))))


@dataclass(frozen=True, slots=True)
class _ListColumns:
    """A table that is printed as plain lines of text, because a table of the library rich takes ten
    times longer.
    """

    columns: Sequence[_ListColumn]

    def __rich_measure__(self, console: object, options: object) -> Measurement:
        whole = sum(_GAP + column.width for column in self.columns)
        return Measurement(whole, whole)

    def __rich_console__(self, console: object, options: ConsoleOptions) -> Iterable[Text]:
        fixed = sum(_GAP + column.width for column in self.columns if not column.cut)
        room = max(options.max_width - fixed, _NARROWEST)
        widths = [min(c.width, room) if c.cut else c.width for c in self.columns]
        heads = [_ListCell(column.head, "bold") for column in self.columns]
        rows = [column.cells for column in self.columns]
        for row in (heads, *zip(*rows, strict=True)):
            line = Text(no_wrap=True, overflow="ellipsis")
            for cell, column, width in zip(row, self.columns, widths, strict=True):
                line.append(" " * _GAP if line else "")
                line.append(_fitted(cell.text, width, right=column.right), cell.style)
            line.rstrip()
            yield line


def _fitted(text: str, width: int, *, right: bool) -> str:
    """Return a text padded to ``width`` terminal columns, or shortened in its middle."""
    size = cell_len(text)
    if size > width:
        tail = (width - 1) * 2 // 3
        start = len(text)
        while cell_len(text[start - 1 :]) <= tail:
            start -= 1
        end = text[start:]
        return f"{set_cell_size(text, width - 1 - cell_len(end))}…{end}"
    return " " * (width - size) + text if right else text + " " * (width - size)


def _axes(results: Sequence[_Result], folder: str) -> _ListColumns:
    names = next(
        (names for names in (_VDI, _STAND_STILL) if names[0] in results[0]["parameters"]), _ISO
    )
    return _ListColumns(
        [
            _files(results, folder),
            _ListColumn("Axis", [_ListCell(visible(result["axis"]) or "?") for result in results]),
            *_parameters(results, names),
            _warnings(results),
        ]
    )


def _circles(results: Sequence[_Result], folder: str) -> _ListColumns:
    old = any(result["parameters"].get("H") is not None for result in results)
    causes = [ranked_causes(result) for result in results]
    return _ListColumns(
        [
            _files(results, folder),
            _ListColumn("Plane", [_ListCell(visible(result["plane"])) for result in results]),
            *_parameters(results, _CIRCLE_1996 if old else _CIRCLE),
            _ListColumn("Largest cause", [_ListCell(_largest(one)) for one in causes]),
            _warnings(results),
        ]
    )


def _files(results: Sequence[_Result], folder: str) -> _ListColumn:
    return _ListColumn("File", [_ListCell(_named(result, folder)) for result in results], cut=True)


def _named(result: _Result, folder: str) -> str:
    """Return the file name of a test. If the test has further files, their number is added, such as
    "x.csv +1".
    """
    first, *more = [source["file"] for source in result["sources"]] or [result["name"]]
    return f"{_shown(first, folder)}{f' +{len(more)}' if more else ''}"


def _parameters(results: Sequence[_Result], names: Sequence[str]) -> list[_ListColumn]:
    columns = [
        _ListColumn(
            _SYMBOLS.get(name) or symbol(name),
            [_ListCell(number(result["parameters"].get(name))) for result in results],
            right=True,
        )
        for name in names
    ]
    return [*columns, _ListColumn("", [_ListCell(unit_text(result["unit"])) for result in results])]


def _warnings(results: Sequence[_Result]) -> _ListColumn:
    return _ListColumn("Warning", [_gravest(result["findings"]) for result in results])


def _gravest(findings: Sequence[Mapping[str, str]]) -> _ListCell:
    """Return the code of the most severe finding of a result; errors are more severe than doubts,
    and doubts more than warnings.

    Of several warnings it is the first on the page of the test. A finding of the kind info is never
    returned.
    """
    grave = [one for one in findings if one["severity"] != "info"]
    if not grave:
        return _ListCell("")
    first = min(grave, key=lambda one: (one["severity"] != "error", one["code"] not in DOUBTS))
    return _ListCell(first["code"], _STYLES[first["severity"]])


def _largest(causes: Sequence[Any]) -> str:
    return next((str(cause.words) for cause in causes if cause.shown and cause.significant), "")


def _summary(summary: Mapping[str, Any], folder: str) -> list[RenderableType]:
    unread = summary["unread"]
    counts = f"{summary['tests']} tests from {summary['files']} files"
    errors = f"{unread} file{'s' * (unread != 1)} with errors, listed below"
    refused = f"; {errors}" if unread else ""
    shown: list[RenderableType] = [
        Rule(Text("Summary", style="bold"), align="left", characters="─"),
        Text(f"{counts}{refused}", style="" if not unread else "red"),
    ]
    if summary["groups"]:
        shown += [Text(), _sizes(summary["groups"], folder)]
    if summary["findings"]:
        shown += [
            Text(),
            _findings(summary["findings"], folder),
            Text(),
            Text("Evaluate one of these files alone to read what its findings say.", style="dim"),
        ]
    return shown


def _sizes(groups: Sequence[Mapping[str, Any]], folder: str) -> _ListColumns:
    rows = [(group, name, size) for group in groups for name, size in group["sizes"].items()]

    def numbers(key: str) -> _ListColumn:
        return _ListColumn(key, [_ListCell(number(size[key])) for _, _, size in rows], right=True)

    return _ListColumns(
        [
            _ListColumn("", [_ListCell(_of(group)) for group, _, _ in rows]),
            _ListColumn("", [_ListCell(_SYMBOLS.get(name) or symbol(name)) for _, name, _ in rows]),
            _ListColumn(
                "tests", [_ListCell(str(size["tests"])) for _, _, size in rows], right=True
            ),
            *map(numbers, ("smallest", "median", "largest")),
            _ListColumn("", [_ListCell(unit_text(group["unit"])) for group, _, _ in rows]),
            _ListColumn(
                "largest in",
                [_ListCell(_shown(size["file"], folder)) for *_, size in rows],
                cut=True,
            ),
        ]
    )


def _of(group: Mapping[str, Any]) -> str:
    kind = "circle" if group["kind"] == "circular" else "axis"
    return f"{kind} {visible(group['axis']) or 'not named'}"


def _findings(findings: Sequence[Mapping[str, Any]], folder: str) -> _ListColumns:
    return _ListColumns(
        [
            _ListColumn(
                "Finding",
                [_ListCell(one["severity"], _STYLES[one["severity"]]) for one in findings],
            ),
            _ListColumn("", [_ListCell(one["code"]) for one in findings]),
            _ListColumn("tests", [_ListCell(str(one["tests"])) for one in findings], right=True),
            _ListColumn(
                "first in", [_ListCell(_shown(one["file"], folder)) for one in findings], cut=True
            ),
        ]
    )


def _tests(count: int, kind: str) -> str:
    word = {"environment": "drift", "lost_motion": "lost motion"}.get(kind, kind)
    return f"{count} {word} test{'s' * (count != 1)}"


def _common_folder(files: Iterable[str]) -> str:
    """Return the folder that contains all files, or "" if they have no common one."""
    folders = [PurePath(file).parent for file in files]
    common = folders[0] if folders else PurePath()
    for folder in folders:
        while not folder.is_relative_to(common):
            common = common.parent
            if common == common.parent:  # the root, or where the command was called
                return ""
    return "" if common == PurePath() else str(common)


def _name(file: str, folder: str) -> str:
    return str(PurePath(file).relative_to(folder)) if folder else file


def _shown(file: str, folder: str) -> str:
    return visible(_name(file, folder))
