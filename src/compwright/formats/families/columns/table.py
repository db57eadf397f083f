"""A table as a control exports it: columns, rows and cells, with their places in the file."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Literal

from compwright.formats.definition.statements import Token
from compwright.formats.text.patching import BytesChange
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
    """One row of an exported table: its cells by column, and its place in the file.

    ``line``: line number, from 1. ``start``, ``end``: the bytes of the row in the file.
    """

    line: int
    start: int
    end: int
    cells: Mapping[str, Token]

    @property
    def place(self) -> str:
        """The row's line number as text for messages, such as "line 12"."""
        return f"line {self.line}"


@dataclass(frozen=True, slots=True)
class Described:
    """The description of one column: its width in characters, decimals, and range of values.

    ``width``: without the ``blanks`` that follow the column. ``decimals``: number of digits after
    the point. ``least``, ``most``: smallest and largest value. None: not described.
    """

    width: int | None = None
    blanks: int = 0
    decimals: int | None = None
    least: Decimal | None = None
    most: Decimal | None = None
    read_only: bool = False
    inch: bool = False

    def refuses(self, text: str) -> str:
        """Return the reason why a cell of this column cannot contain ``text``; empty if it can."""
        if self.read_only:
            return "is read only by the table's own description"
        if self.width is not None and len(text) > self.width:
            return f"is {self.width} characters wide by the table's own description"
        if not is_number(text):
            return ""
        number = Decimal(text)
        if self.decimals is not None and number != round(number, self.decimals):
            return f"holds {self.decimals} decimals by the table's own description"
        if (self.least is not None and number < self.least) or (
            self.most is not None and number > self.most
        ):
            low = "" if self.least is None else f"{self.least:f}"
            high = "" if self.most is None else f"{self.most:f}"
            return f"takes {low} .. {high} by the table's own description"
        return ""


@dataclass(frozen=True, slots=True)
class TableColumn:
    """A column of a table, with the range of character positions in a line that its cells may
    occupy.

    Cells may be at the characters from ``low`` up to, not including, ``high`` (None: to the end of
    the line). ``flush``: cells are aligned ``left`` or ``right``, or ``free``: only blanks separate
    them. ``edge``: the character at which left-aligned cells begin, or after which right-aligned
    cells end. ``described``: the description of the column in the table.
    """

    name: str
    low: int
    high: int | None
    flush: Literal["left", "right", "free"]
    edge: int
    described: Described | None = None

    def check(self, text: str, file: str) -> None:
        """Raise NotHeld if a cell of this column cannot contain ``text``."""
        why = (
            self.described.refuses(text)
            if self.described is not None and self.name != ROW_NUMBER
            else ""
        )
        if why:
            raise NotHeld(f"{text} does not fit the column {self.name} of {file}, which {why}")


@dataclass(frozen=True, slots=True)
class UserTable:
    """A table as written in a file: compensation values, or the assignment of such tables to axes.

    ``head``: the fields of its first line, among them ``name`` and ``unit``.
    """

    file: str
    kind: Kind
    head: Mapping[str, Token]
    columns: tuple[TableColumn, ...]
    rows: tuple[Row, ...]

    @property
    def name(self) -> str:
        """The name of the table in its first line, without the file ending."""
        return self.head["name"].text

    def column(self, name: str) -> TableColumn | None:
        """Return the column with this name; None if the table has no such column."""
        return next((column for column in self.columns if column.name == name), None)

    def others(self, *names: str) -> tuple[str, ...]:
        """Return the names of columns with nonzero values, except the row number column and the
        columns ``names``.
        """
        return tuple(
            column.name
            for column in self.columns
            if column.name not in (ROW_NUMBER, *names) and self.fills(column.name)
        )

    def fills(self, name: str) -> bool:
        """Return whether a column has a value that is not zero."""
        texts = [row.cells[name].text for row in self.rows if name in row.cells]
        return any(not (is_number(text) and Decimal(text) == 0) for text in texts)


def is_number(text: str) -> bool:
    """Return whether a cell contains a decimal number."""
    return _NUMBER.fullmatch(text) is not None


def set_cell(table: UserTable, line: str, name: str, text: str) -> str:
    """Return a table line with new text in one column; other columns keep their characters.

    Raises NotHeld if the text does not fit the width of the column.
    """
    column = table.column(name)
    if column is None:
        raise NotHeld(f"{table.file} has no column {name}")
    column.check(text, table.file)
    if column.flush == "free":
        raise NotHeld(
            f"{table.file}: the cells of the column {name} are not in columns of fixed width"
        )
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


def cell_changes(
    table: UserTable, row: Row, line: str, cells: Mapping[str, str]
) -> list[BytesChange]:
    """Return the byte changes that put the texts ``cells`` (by column) into a row with the text
    ``line``.

    Raises NotHeld if a text does not fit its column.
    """
    columns = [column for name in cells if (column := table.column(name)) is not None]
    if any(column.flush == "free" for column in columns):
        for column in columns:
            column.check(cells[column.name], table.file)
        return [
            BytesChange(row.cells[name].start, row.cells[name].end, cells[name].encode("ascii"))
            for name in cells
        ]
    changed = line
    for name, text in cells.items():
        changed = set_cell(table, changed, name, text)
    return [BytesChange(row.start, row.end, changed.encode("latin-1"))] if changed != line else []


def with_sign(old: str, new: str) -> str:
    """Return the new number; if the old number begins with a plus sign, the new one does too."""
    return f"+{new}" if old.startswith("+") and not new.startswith("-") else new
