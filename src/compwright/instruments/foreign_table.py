"""Rows and columns of a table that another program wrote: any delimiter, with or without header
row, with text above the table.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from compwright.foundations.input_sizes import MOST_COLUMNS
from compwright.instruments.comments import comment_text
from compwright.instruments.csv_table import GatheredRows, row_cells
from compwright.instruments.fault_list import FaultList, shown

#: Delimiters by their names in a profile; blanks: any number of them.
DELIMITERS: Final = {"semicolon": ";", "tab": "\t", "comma": ",", "bar": "|", "blanks": " "}


@dataclass(frozen=True, slots=True)
class ForeignTable:
    """A table of another program: columns, cells, line numbers, and the lines above its header.

    The table is stored by column. ``lines``: the line number of each row. ``cells``: for each
    column the texts of its cells.
    """

    columns: tuple[str, ...] = ()
    lines: Sequence[int] = ()
    cells: tuple[Sequence[str], ...] = ()
    before: tuple[str, ...] = ()

    def of(self, column: str) -> Sequence[str]:
        """Return the cells of a column by its name."""
        return self.cells[self.columns.index(column)]


def cells_of(line: str, delimiter: str) -> list[str] | None:
    """Return the cells of one line without blanks at their ends, or None if a quote is not closed.

    ``delimiter``: the character between the cells; a blank means any number of blanks.
    """
    if delimiter == " ":
        return line.split()
    cells = row_cells(line, delimiter)
    return None if cells is None else [" ".join(cell.split()) for cell in cells]


def named_columns(cells: Sequence[str]) -> tuple[str, ...]:
    """Return a unique name for each cell of a header row.

    The name is the text of the cell, ``column 3`` if the cell is empty, or the text with ``(column
    3)`` if two cells have the same text.
    """
    times = Counter(cells)
    return tuple(
        f"column {number}" if not cell else f"{cell} (column {number})" if times[cell] > 1 else cell
        for number, cell in enumerate(cells, start=1)
    )


def foreign_table(
    text: Sequence[str], delimiter: str, header_line: int, faults: FaultList
) -> ForeignTable:
    """Return the table whose header row is the line ``header_line``; 0 means that the table has no
    header row.

    Empty cells are added to short rows. Comment lines (``#``) and blank lines are left out. Faults:
    the file does not have this line, a quote is not closed, a row has more cells than the header
    row.
    """
    if header_line > len(text):
        faults.add(
            "is beyond the end of the file, so it cannot be the header row",
            place=f"line {header_line}",
            expected=f"header_line of at most {len(text)}",
            hint="correct `header_line` in the profile",
        )
        return ForeignTable()
    body = [
        (number, line)
        for number, line in enumerate(text[header_line:], start=header_line + 1)
        if line.strip(" \t,;|") and comment_text(line) is None
    ]
    header = cells_of(text[header_line - 1], delimiter) if header_line else None
    if header_line and not header:
        faults.add("the header row cannot be read", place=f"line {header_line}")
        return ForeignTable()
    width = (
        len(header)
        if header
        else max((len(cells_of(line, delimiter) or ()) for _, line in body), default=0)
    )
    if width > MOST_COLUMNS:
        faults.add(
            "has more columns than any table of readings",
            place=f"line {header_line or body[0][0]}",
            expected=f"at most {MOST_COLUMNS}",
            found=str(width),
            hint="give a file with the readings of one test",
        )
        return ForeignTable()
    rows = GatheredRows(width)
    for number, line in body:
        cells = cells_of(line, delimiter)
        if cells is None:
            faults.add("a quote is not closed on its line", place=f"line {number}")
            continue
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if len(cells) > width:
            faults.add(
                "the row has more cells than the header row",
                place=f"line {number}",
                expected=f"{width} cells",
                found=f"{len(cells)}: {shown(line)}",
                hint=(
                    "remove the surplus cells of this row, or correct `header_line` and `delimiter`"
                    " in the profile"
                ),
            )
            continue
        rows.add(number, cells + [""] * (width - len(cells)))
    return ForeignTable(
        named_columns(header or [""] * width),
        rows.lines,
        rows.columns(),
        tuple(line.strip() for line in text[: max(header_line - 1, 0)] if line.strip(" \t,;|")),
    )
