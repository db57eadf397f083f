"""Point records of the array that all axes share: which lines are pitch data, and what number holds what."""

from __future__ import annotations

import re
from collections.abc import Iterable

from compwright.formats.gathering import Found, Gathered, same_value
from compwright.formats.notes import Notes
from compwright.formats.schema import Definition
from compwright.foundations.errors import Fault

#: Point data stand under their number plus this.
POINTS_FROM = 10000
#: Without a mark, a line from here on is a parameter of the control: no series comes near so many points.
_PARAMETERS_FROM = 2000
_BITS = re.compile("[01]{8}")


def point_rows(definition: Definition, gathered: Gathered) -> list[Found]:
    """Return the lines that hold pitch data, in the order of the files.

    Controls have parameters above 10000 too. Q0 marks pitch data; a line without Q is taken for it unless it holds bits or its
    number is far above all points; a line with Q1, the mark of parameters, only where no other one is pitch data.
    """
    forms = definition.statements["point"]
    marks = [form.split("}", 1)[1].split("P", 1)[0].strip() for form in (forms.form, *forms.also_read)]
    rows = [(row, marks[row.occurrence.form]) for rows in gathered.file_rows.values() for row in rows]
    certain = [row for row, mark in rows if mark == "Q0" or (mark == "" and _may_be_point(row))]
    highest = definition.limit_number("max_number") or 0
    return certain or [row for row, mark in rows if mark == "Q1" and _may_be_point(row) and point_number(row) <= highest]


def point_number(row: Found) -> int:
    """Return the number of a point, from 0."""
    return int(row.occurrence.tokens["number"].text) - POINTS_FROM


def _may_be_point(row: Found) -> bool:
    return point_number(row) < _PARAMETERS_FROM and not _BITS.fullmatch(row.occurrence.tokens["value"].text)


def points_by_number(definition: Definition, gathered: Gathered, notes: Notes) -> dict[int, Found]:
    """Return the point records by number. The same number twice must say the same, and the control must have it."""
    highest = definition.limit_number("max_number") or 0
    points: dict[int, Found] = {}
    for row in point_rows(definition, gathered):
        number = point_number(row)
        text = row.occurrence.tokens["value"].text
        if number > highest:
            message = f"point number {number} does not exist in this control"
            notes.faults.append(fault_at(row, message, f"0 .. {highest}", str(number)))
            continue
        first = points.setdefault(number, row)
        if not same_value(text, first.occurrence.tokens["value"].text):
            message = f"point {number} contradicts {first.where}"
            notes.faults.append(fault_at(row, message, first.occurrence.tokens["value"].text, text))
    return points


def fault_at(found: Found, message: str, expected: str = "", what: str = "") -> Fault:
    """Return a fault at the line of a value."""
    return Fault(message=message, file=found.occurrence.file, place=found.occurrence.place, expected=expected, found=what)


def number_list(numbers: Iterable[int]) -> str:
    """Return numbers with commas; long lists end in dots."""
    chosen = list(numbers)
    return ", ".join(map(str, chosen[:8])) + (" .." if len(chosen) > 8 else "")
