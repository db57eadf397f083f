"""A table that a control exports, as it stands in its file: columns, rows, cells in fixed widths,
every cell with its place; and what a cell may become.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Literal

from compwright.formats.definition.statements import Token
from compwright.formats.text.patching import Change
from compwright.formats.text.scale import NotHeld

#: The statements of a definition that open a table of values and a table of assignments.
VALUES, ASSIGNMENTS = "values_begin", "assignments_begin"
ROW_NUMBER, POSITION, SECOND, ACTIVE = "NR", "AXISPOS", "BACKLASH", ("ACTIVE", "STATUS")
#: Columns that belong to no axis.
RESERVED = (ROW_NUMBER, POSITION, SECOND, *ACTIVE)
_NUMBER = re.compile(r"[+-]?(?:[0-9]{1,9}(?:\.[0-9]{0,9})?|\.[0-9]{1,9})")

Kind = Literal["values", "assignments"]


@dataclass(frozen=True, slots=True)
class Row:
    """One row. ``line`` counts from 1; ``start`` and ``end`` are the bytes of its text."""

    line: int
    start: int
    end: int
    cells: Mapping[str, Token]

    @property
    def place(self) -> str:
        """The line, for messages."""
        return f"line {self.line}"


@dataclass(frozen=True, slots=True)
class Column:
    """A column. Cells stand from ``low`` up to ``high`` (characters of the line; None: to its end),
    flush with one of them.

    ``edge``: the character at which cells begin (``flush`` left) or behind which they end (right);
    ``flush`` "free": blanks alone separate the cells.
    """

    name: str
    low: int
    high: int | None
    flush: Literal["left", "right", "free"]
    edge: int


@dataclass(frozen=True, slots=True)
class UserTable:
    """A table as it stands in a file. ``head``: the fields of its first line, with ``name`` and
    ``unit``.
    """

    file: str
    kind: Kind
    head: Mapping[str, Token]
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]

    @property
    def name(self) -> str:
        """The table's name in its first line, without the ending."""
        return self.head["name"].text

    def column(self, name: str) -> Column | None:
        """Return a column by name, None where the table has none."""
        return next((column for column in self.columns if column.name == name), None)

    def others(self, *names: str) -> tuple[str, ...]:
        """Return the names of the columns that hold something other than zero, apart from ``names``
        and the row numbers.
        """
        return tuple(
            column.name
            for column in self.columns
            if column.name not in (ROW_NUMBER, *names)
            and any(self._filled(row, column.name) for row in self.rows)
        )

    def _filled(self, row: Row, name: str) -> bool:
        cell = row.cells.get(name)
        return cell is not None and not (is_number(cell.text) and Decimal(cell.text) == 0)


def is_number(text: str) -> bool:
    """Return whether a cell holds a decimal number."""
    return _NUMBER.fullmatch(text) is not None


def set_cell(table: UserTable, line: str, name: str, text: str) -> str:
    """Return a line of the table with ``text`` in a column: every other column keeps its place and
    its characters.

    Raises NotHeld when the text does not fit the width of the column.
    """
    column = table.column(name)
    if column is None:
        raise NotHeld(f"{table.file} has no column {name}")
    if column.flush == "free":
        raise NotHeld(f"{table.file}: the cells of the column {name} do not stand in fixed widths")
    start = column.edge if column.flush == "left" else column.edge - len(text)
    end = start + len(text)
    # One blank stays between neighbours: behind cells that begin flush, before cells that end flush
    # with the column.
    low = column.low + (
        1 if column.flush == "right" and column.high == column.edge and column.low else 0
    )
    high = None if column.high is None else column.high - (1 if column.flush == "left" else 0)
    if start < low or (high is not None and end > high):
        width = column.edge - low if column.flush == "right" else (high or 0) - column.edge
        raise NotHeld(
            f"{text} does not fit the column {name} of {table.file}, which is {width} characters"
            " wide"
        )
    stop = len(line) if column.high is None else min(len(line), column.high)
    region = " " * (start - column.low) + text
    return (
        line[: column.low].ljust(column.low) + region.ljust(max(0, stop - column.low)) + line[stop:]
    )


def cell_changes(table: UserTable, row: Row, line: str, cells: Mapping[str, str]) -> list[Change]:
    """Return the changes that put texts into cells of a row, by column name; ``line`` is the row's
    text as it stands.

    Raises NotHeld when a text does not fit its column.
    """
    free = [
        name
        for name in cells
        if (column := table.column(name)) is not None and column.flush == "free"
    ]
    if free:
        return [
            Change(row.cells[name].start, row.cells[name].end, cells[name].encode("ascii"))
            for name in cells
        ]
    changed = line
    for name, text in cells.items():
        changed = set_cell(table, changed, name, text)
    return [Change(row.start, row.end, changed.encode("latin-1"))] if changed != line else []


def with_sign(old: str, new: str) -> str:
    """Return a number with a plus sign where the old one has one."""
    return f"+{new}" if old.startswith("+") and not new.startswith("-") else new
