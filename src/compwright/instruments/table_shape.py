"""Find a table of numbers in a text: its delimiter and its header row."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Final

from compwright.instruments.fault_list import shown
from compwright.instruments.foreign_table import DELIMITERS, cells_of
from compwright.instruments.header_words import is_unit
from compwright.instruments.numbers import parse_number

#: Rows that are looked at for the shape of the table.
_LOOKED_AT: Final = 400


def has_table(text: Sequence[str]) -> bool:
    """Return whether the lines contain a table of numbers."""
    return shape_of(text) is not None


def shape_of(text: Sequence[str]) -> tuple[str, int] | None:
    """Return the largest table's delimiter (such as "comma") and the number of its header line (0
    if it has none); None if there is no table.
    """
    best: tuple[int, int, str, int] | None = None
    lines = text[:_LOOKED_AT]
    for name, delimiter in DELIMITERS.items():
        counts = [_numbers_in(line, delimiter) for line in lines]
        rows = [index for index, (numbers, _) in enumerate(counts) if numbers >= 2]
        if len(rows) < 2:
            continue
        width = Counter(counts[index][1] for index in rows).most_common(1)[0][0]
        first = next(index for index in rows if counts[index][1] == width)
        score = sum(counts[index][0] for index in rows if counts[index][1] == width)
        # in a table with decimal commas the comma splits every number in two
        if name == "comma" and best is not None and best[1] > 0:
            continue
        header = (
            first + 1
            if _names_in(lines, first, delimiter)
            else _header_line(lines, first, delimiter, width)
        )
        if best is None or score > best[0]:
            best = (score, len(rows), name, header)
    return None if best is None else (best[2], best[3])


def _numbers_in(line: str, delimiter: str) -> tuple[int, int]:
    """Return the number of numeric cells in a line, and the number of all its cells."""
    cells = cells_of(line, delimiter) or []
    return sum(number_in(cell, None) is not None for cell in cells), len(cells)


def _names_in(lines: Sequence[str], first: int, delimiter: str) -> bool:
    """Return whether the row with index ``first``, which contains numbers or names such as ``+1``,
    is the header row.

    It is the header row if at least one of its cells is a word where the next row has a number.
    """
    if first + 1 >= len(lines):
        return False
    here, below = (cells_of(line, delimiter) or [] for line in lines[first : first + 2])
    return any(
        one and number_in(one, None) is None and number_in(other, None) is not None
        for one, other in zip(here, below, strict=False)
    )


def _header_line(lines: Sequence[str], first: int, delimiter: str, width: int) -> int:
    """Return the number (from 1) of the header line above the first row of numbers, or 0 if there
    is no header.
    """
    for index in range(first - 1, max(first - 4, -1), -1):
        cells = cells_of(lines[index], delimiter) or []
        texts = [cell for cell in cells if cell and number_in(cell, None) is None]
        if len(cells) >= width - 1 and len(texts) >= 2 and not all(map(is_unit, texts)):
            return index + 1
    return 0


def number_in(text: str, decimal: str | None) -> float | None:
    """Return the number in a cell, or None for other text. ``decimal``: the decimal mark, None if
    both are allowed.
    """
    if decimal is not None and {".": ",", ",": "."}[decimal] in text:
        return None
    try:
        return parse_number(text)
    except ValueError:
        return None


def thousands_in(text: Sequence[str]) -> str:
    """Return, as text for a message, the first number with thousands marks (which are not allowed
    in a table), or "" if there is none.
    """
    for line in text[:_LOOKED_AT]:
        for delimiter in DELIMITERS.values():
            for cell in cells_of(line, delimiter) or []:
                try:
                    parse_number(cell)
                except ValueError as reason:
                    if "thousands" in str(reason):
                        return f"numbers with thousands marks, such as {shown(cell)}"
    return ""
