"""The description of a table's columns in NCK controls, between first line and column headings.

Two forms occur in public tables of these controls. None of these tables is a .COM; for .COM and
.CMA tables both forms are unconfirmed:

- ``#STRUCTBEGIN`` to ``#STRUCTEND`` with lines ``NAME =`` and ``WIDTH =``.
- ``TableDescription (`` up to the bracket that closes it, with ``key:="X"``, ``width:=8``,
  ``unitIsInch:=TRUE`` and ``primaryKey:="NR"``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from compwright.controllers.heidenhain.elements import LinePlace
from compwright.foundations.errors import InputError

Line = tuple[LinePlace, str]

_QUOTED = re.compile(r'"[^"]*"')
_DESCRIPTION = re.compile(r"\s*TableDescription\s*\(", re.IGNORECASE)
_ENTRY = re.compile(r'\s*(key|width|unitIsInch|primaryKey)\s*:=\s*"?([^",]*)"?,?\s*', re.IGNORECASE)
_STRUCT = re.compile(r"\s*(NAME|WIDTH)\s*=\s*(\S+)\s*", re.IGNORECASE)


@dataclass(slots=True)
class ColumnWidths:
    """The widths (characters) of a table's columns, as the head of the table describes the widths.

    ``widths``: width by column name. ``first``: the column with the row numbers.
    """

    widths: dict[str, int] = field(default_factory=dict)
    first: str = "NR"

    def cells(self, names: Sequence[str], starts: Sequence[int]) -> bool:
        """Return whether the described widths agree with the positions of the column names.

        If they agree, a cell belongs to the column whose name begins at the same character.
        ``names``: the column names in order. ``starts``: index of the first character of each name.
        A column may be followed by one blank.
        """
        next_start = dict(zip(names, starts[1:], strict=False))
        places = [
            next_start[name] - start - self.widths[name]
            for name, start in zip(names, starts, strict=True)
            if name in self.widths and name in next_start
        ]
        described = {name for name in names[1:] if name in self.widths}
        return bool(places) and set(places) <= {0, 1} and described == set(names[1:])


def described(lines: Sequence[Line]) -> tuple[ColumnWidths, list[Line]]:
    """Return the description of a table's columns, and the remaining lines of the table.

    Raises InputError for a description without its end, and for a column described as inches.
    """
    filled = [index for index, (_, line) in enumerate(lines) if line.strip()]
    begin = filled[0] if filled else len(lines)
    first = lines[begin][1] if filled else ""
    if first.strip().upper() == "#STRUCTBEGIN":
        end = next(
            (n for n, (_, line) in enumerate(lines) if line.strip().upper() == "#STRUCTEND"), None
        )
    elif _DESCRIPTION.match(first):
        end = _closing(lines, begin)
    else:
        return ColumnWidths(), list(lines)
    if end is None:
        raise InputError(
            lines[begin][0].fault(
                "the description of the table has no end",
                expected="#STRUCTEND, or the bracket that closes TableDescription",
            )
        )
    return _read(lines[begin : end + 1]), list(lines[end + 1 :])


def _closing(lines: Sequence[Line], begin: int) -> int | None:
    """Return the index of the line that closes the bracket opened in line ``begin``; None if no
    line closes it.
    """
    depth = 0
    for index in range(begin, len(lines)):
        code = _QUOTED.sub("", lines[index][1])
        depth += code.count("(") - code.count(")")
        if depth <= 0:
            return index
    return None


def _read(lines: Sequence[Line]) -> ColumnWidths:
    found = ColumnWidths()
    column = ""
    for place, line in lines:
        match = _ENTRY.fullmatch(line) or _STRUCT.fullmatch(line)
        if match is None:
            continue
        key, text = match[1].upper(), match[2].strip()
        if key in {"KEY", "NAME"}:
            column = text.upper()
        elif key == "PRIMARYKEY":
            found.first = text.upper()
        elif key == "UNITISINCH" and text.upper() == "TRUE":
            raise InputError(place.fault(f"column {column} is in inch of its own (unitIsInch)"))
        elif key == "WIDTH" and text.isascii() and text.isdigit():
            found.widths[column] = int(text[:6])
    return found
