"""The plain CSV forms (positioning, circular, stand-still) without what is somebody's: columns that
are read stay, of all others neither the name nor a cell.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from io import StringIO
from typing import Final

from compwright.foundations.redaction import Cuts
from compwright.instruments.csv_table import COLUMNS, column_name, header_names, traverse_of
from compwright.instruments.redaction.key_lines import redacted_comment
from compwright.instruments.redaction.words import is_axis, is_one_number

_OTHER_COLUMNS: Final = frozenset({"axis", "angle_deg", "radius_mm", "time_min"})
_DIRECTIONS: Final = frozenset({"+", "-", "ccw", "cw"})


def redacted_plain(lines: Sequence[str], cuts: Cuts) -> list[str]:
    """Return the lines of a plain CSV file, as many, without what is somebody's."""
    result: list[str] = []
    columns: list[str] | None = None
    delimiter = ","
    for line in lines:
        comment = redacted_comment(line, cuts)
        if comment is not None or not line.strip(" \t,;"):
            result.append(comment if comment is not None else line)
        elif columns is None:
            delimiter, _, _ = header_names(line)
            names = cells_of(line, delimiter)
            columns = [column_name(name) for name in names]
            result.append(joined([_header(name, cuts) for name in names], delimiter))
        else:
            cells = cells_of(line, delimiter)
            kept = [_cell(cell, _at(columns, at), cuts) for at, cell in enumerate(cells)]
            result.append(joined(kept, delimiter))
    return result


def cells_of(line: str, delimiter: str) -> list[str]:
    """Return the cells of a line; a line with a quote that is not closed is one cell."""
    if line.count('"') % 2:
        return [line]
    return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])


def joined(cells: Sequence[str], delimiter: str) -> str:
    """Return cells as a line, in quotes where they need them."""
    out = StringIO()
    csv.writer(out, delimiter=delimiter, lineterminator="").writerow(cells)
    return out.getvalue()


def is_read(column: str) -> bool:
    """Whether a column, as `column_name` gives it, is one of the plain forms."""
    return column in COLUMNS or column in _OTHER_COLUMNS or traverse_of(column) is not None


def _at(columns: Sequence[str], place: int) -> str:
    return columns[place] if place < len(columns) else ""


def _header(name: str, cuts: Cuts) -> str:
    return name if is_read(column_name(name)) else cuts.name(name, "column")


def _cell(cell: str, column: str, cuts: Cuts) -> str:
    text = cell.strip()
    if is_read(column) and (is_one_number(text) or text.lower() in _DIRECTIONS):
        return cell
    if column == "axis":
        return cell if is_axis(text) else cuts.name(cell)
    return cuts.remark(cell, "cell")
