"""Split a file into tests: by the sheets of a workbook, or by the axes in a column."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from compwright.instruments.csv_table import first_row, header_names, split_lines
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.foreign_table import cells_of
from compwright.instruments.sections import axis_name

#: The column of a plain CSV file that may say which axis a row is of.
AXIS_COLUMN = "axis"


@dataclass(frozen=True, slots=True)
class TestPart:
    """The lines of one test in a file. Lines of other tests are replaced by blank lines, so that
    line numbers stay right.

    ``axis``: the axis in the column of axis names; empty if there is no such column. ``sheet``: the
    name of the sheet of a workbook; empty for other files.
    """

    text: Sequence[str]
    axis: str = ""
    sheet: str = ""


def plain_parts(text: Sequence[str], faults: FaultList) -> tuple[TestPart, ...]:
    """Return the lines of each test in a plain CSV file: one per axis in the column ``axis``."""
    first = first_row(text)
    if first is None:
        return (TestPart(text),)
    number, header = first
    delimiter, names, _ = header_names(header)
    if AXIS_COLUMN not in names:
        return (TestPart(text),)
    rows = split_lines(text)[1].numbers[1:]
    return parts_by_axis(text, delimiter, (number, names.index(AXIS_COLUMN)), rows, faults)


def parts_by_axis(
    text: Sequence[str],
    delimiter: str,
    header: tuple[int, int],
    rows: Sequence[int],
    faults: FaultList,
) -> tuple[TestPart, ...]:
    """Return one part of the file for each axis, with the lines of that axis. ``header``: line
    number of the header row, and index of the column with the axis names; ``rows``: the line
    numbers of the data rows.

    A row with contents but without an axis name is a fault.
    """
    _, column = header
    by_axis: dict[str, set[int]] = {}
    for line in rows:
        cells = cells_of(text[line - 1], delimiter) or []
        written = cells[column] if column < len(cells) else ""
        name = axis_name(written)
        if name:
            by_axis.setdefault(name, set()).add(line)
        elif any(cells):
            faults.add(
                "the row names no axis",
                place=f"line {line}",
                expected="X, Y, Z1, ..",
                found=shown(written) if written else "an empty cell",
                hint="write the axis into this row",
            )
    taken = set(rows)
    return tuple(
        TestPart(
            [
                "" if line in taken and line not in own else content
                for line, content in enumerate(text, start=1)
            ],
            axis,
        )
        for axis, own in by_axis.items()
    ) or (TestPart(text),)
