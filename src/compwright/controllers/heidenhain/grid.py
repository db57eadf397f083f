"""HEIDENHAIN tables as blocks of lines, and their cells by column heading.

The form of the classic tables is not confirmed by a manual page. So a table is read only where it
is unambiguous; everything else is refused. A cell belongs to the column whose heading is above it.
A table without its end line was cut short, which is a fault.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.heidenhain.description import described
from compwright.controllers.heidenhain.elements import LinePlace, number
from compwright.foundations.errors import Fault, InputError
from compwright.records.axis import FloatArray

_WORD = re.compile(r"\S+")
_WHOLE = re.compile(r"[0-9]{1,6}")
#: What newer controls add to the first line of a table.
_EDITION = re.compile(r"\s+VERSION:\s*'[^']*'(?=\s|$)|\s+U\s*$", re.IGNORECASE)
#: More columns than any such table has; bounds the work on a line of rubbish.
_MOST_COLUMNS = 64


@dataclass(frozen=True, slots=True)
class TableBlock:
    """The lines of a table from BEGIN to its end line.

    ``name``: name of the table. ``kind``: COM or CMA. ``inch``: its lengths are in inches.
    ``rest``: the text after the unit in the BEGIN line.
    """

    name: str
    kind: str
    inch: bool
    rest: str
    lines: list[tuple[LinePlace, str]]
    place: LinePlace


@dataclass(frozen=True, slots=True)
class CellGrid:
    """The cells of a table by column name (None: blank), without the column of row numbers."""

    names: tuple[str, ...]
    rows: tuple[tuple[str | None, ...], ...]
    places: tuple[LinePlace, ...]

    def column(self, name: str) -> list[str | None]:
        """Return the cells of the column with this name, one per row."""
        index = self.names.index(name)
        return [row[index] for row in self.rows]


def split_tables(
    lines: list[tuple[LinePlace, str]], faults: list[Fault]
) -> tuple[list[TableBlock], list[tuple[LinePlace, str]]]:
    """Split the lines of a file into tables and other lines; errors are added to ``faults``."""
    blocks: list[TableBlock] = []
    outside: list[tuple[LinePlace, str]] = []
    opened: TableBlock | None = None
    for place, line in lines:
        words = line.upper().split(maxsplit=3)
        first = words[0] if words else ""
        if first == "BEGIN":
            _cut_short(opened, faults)
            opened = _opened(line, place, faults)
            blocks += [opened] if opened else []
        elif first in {"END", "[END]"} and opened is not None:
            ends = first == "[END]" or _table_name(line.upper().split()[1:])[:2] == (
                opened.name.upper(),
                opened.kind,
            )
            if not ends:
                faults.append(
                    place.fault(
                        "this line is the end of another table",
                        expected=f"END {opened.name} .{opened.kind}",
                        found=repr(line.strip()[:80]),
                    )
                )
            opened = None
        elif opened is not None:
            opened.lines.append((place, line))
        else:
            outside.append((place, line))
    _cut_short(opened, faults)
    return blocks, outside


def _cut_short(opened: TableBlock | None, faults: list[Fault]) -> None:
    if opened is not None:
        faults.append(
            opened.place.fault(
                "the table has no end line (cut off?)",
                expected=f"END {opened.name} .{opened.kind}",
            )
        )


def _table_name(words: list[str]) -> tuple[str, str, list[str]]:
    """Return name and kind (COM, CMA or empty) of a table from its BEGIN line, with the words that
    follow.
    """
    if words and words[0][-4:].upper() in {".COM", ".CMA"} and len(words[0]) > 4:
        return words[0][:-4], words[0][-3:].upper(), words[1:]
    if len(words) > 1 and words[1].upper() in {".COM", ".CMA"}:
        return words[0], words[1][1:].upper(), words[2:]
    return "", "", words


def _opened(line: str, place: LinePlace, faults: list[Fault]) -> TableBlock | None:
    name, kind, words = _table_name(_EDITION.sub("", line).split()[1:])
    unit = words[0].upper() if words else ""
    if not kind or (kind == "COM" and unit not in {"MM", "INCH"}):
        faults.append(
            place.fault(
                "the head of the table cannot be read",
                expected="BEGIN X .COM MM or BEGIN NAME .CMA MM",
                found=repr(line[:80]),
            )
        )
        return None
    return TableBlock(
        name=name, kind=kind, inch=unit == "INCH", rest=" ".join(words[1:]), lines=[], place=place
    )


def read_grid(block: TableBlock) -> CellGrid:
    """Return the cells of a table. Raises InputError with each row whose columns are unclear."""
    description, lines = described(block.lines)
    filled = [(place, line) for place, line in lines if line.strip()]
    heading = (
        [(match.group().upper(), match.span()) for match in _WORD.finditer(filled[0][1])]
        if filled
        else []
    )
    if not heading or heading[0][0] != description.first or len(heading) > _MOST_COLUMNS:
        place = filled[0][0] if filled else block.place
        raise InputError(
            place.fault(
                "the line of column headings is missing",
                expected=f"{description.first} and the columns",
                found=repr(filled[0][1][:80] if filled else ""),
            )
        )
    names = tuple(match.group() for match in _WORD.finditer(filled[0][1]))[1:]
    faults = [
        filled[0][0].fault("two columns have the same name", found=name)
        for name in dict.fromkeys(names)
        if names.count(name) > 1
    ]
    starts = [start for _, (start, _) in heading]
    fixed = starts if description.cells([*(name for name, _ in heading)], starts) else None
    rows: list[tuple[str | None, ...]] = []
    for wanted, (place, line) in enumerate(filled[1:]):
        row = _row(line, [span for _, span in heading], place, wanted, fixed)
        if isinstance(row, Fault):
            faults.append(row)
        else:
            rows.append(row)
    if faults:
        raise InputError(*faults)
    return CellGrid(names, tuple(rows), tuple(place for place, _ in filled[1:]))


def _row(
    line: str,
    spans: Sequence[tuple[int, int]],
    place: LinePlace,
    wanted: int,
    starts: Sequence[int] | None,
) -> tuple[str | None, ...] | Fault:
    """Return the cells of a table line, or a fault if it is unclear to which columns they belong.

    - ``wanted``: the row number with which the line must begin.
    - ``spans``: index of the start and of the end of each column name.
    - ``starts``: index of the first character of each column, if the table describes its columns;
      else None. With ``starts``, a cell reaches from the start of its column to the start of the
      next column.

    Without ``starts``, blanks separate the columns if every cell is filled. With fewer cells, each
    cell must be below exactly one heading.
    """
    words = [(match.group(), match.span()) for match in _WORD.finditer(line)]
    if not _WHOLE.fullmatch(words[0][0]) or int(words[0][0]) != wanted:
        return place.fault(
            "row number (a line lost?)", expected=str(wanted), found=repr(words[0][0][:40])
        )
    if starts is not None and "\t" not in line:
        ends = [*starts[1:], len(line)]
        cut = [line[start:end].strip() for start, end in zip(starts, ends, strict=True)]
        if all(len(cell.split()) < 2 for cell in cut):
            return tuple(cell or None for cell in cut[1:])
        return place.fault("a cell of the table contains two words", found=repr(line.strip()[:80]))
    if len(words) == len(spans):
        return tuple(word for word, _ in words[1:])
    cells: list[str | None] = [None] * (len(spans) - 1)
    for word, (start, end) in words[1:]:
        under = [index for index, (left, right) in enumerate(spans) if start < right and left < end]
        if len(under) != 1 or under[0] == 0 or cells[under[0] - 1] is not None or "\t" in line:
            return place.fault(
                "it is ambiguous to which column a cell belongs",
                expected="each cell below its own heading",
                found=repr(word[:40]),
            )
        cells[under[0] - 1] = word
    return tuple(cells)


def numbers(
    cells: Sequence[str | None], places: Sequence[LinePlace], label: str, faults: list[Fault]
) -> FloatArray:
    """Return the cells of a column as numbers, NaN where a cell is blank; any other text is a
    fault, with the message ``label``.
    """
    values = np.full(len(cells), np.nan)
    for index, (cell, place) in enumerate(zip(cells, places, strict=True)):
        parsed = None if cell is None else number(cell)
        if cell is not None and parsed is None:
            faults.append(
                place.fault(label, expected="a number with a decimal point", found=repr(cell[:40]))
            )
        elif parsed is not None:
            values[index] = parsed
    return values
