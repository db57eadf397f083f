"""Find the pitch error data in the files: points by number, in an array that all axes share."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.text.gathering import FoundValue, Gathered, same_value
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Point data stand under their number plus this.
POINTS_FROM = 10000
#: A line with its number: block or parameter, whatever follows.
NUMBERED = re.compile(r"[ \t]*N[ \t]*0*([0-9]{1,6})(?![0-9])(.*)", re.IGNORECASE)
_RECORD = re.compile(r"[ \t]*P[ \t]*-?[0-9]{1,4}[ \t]*")


def point_rows(
    definition: Definition, gathered: Gathered, files: Sequence[ControlFile]
) -> list[FoundValue]:
    """Return the lines with pitch error data, in the order of the files.

    Q0 marks pitch data and Q1 marks parameters; a control also has some parameters with numbers
    above 10000. In a file of pitch data alone, lines without Q are pitch data. In a file with
    parameters and pitch data, lines without Q are used only if no other line is pitch data, and
    under two conditions. Every line from number 10000 on must have the form of pitch data. These
    lines must also contain all point numbers of the table of some axis.
    """
    forms = definition.statements["point"]
    marks = [
        form.split("}", 1)[1].split("P", 1)[0].strip() for form in (forms.form, *forms.also_read)
    ]
    whole = {number for number, file in enumerate(files) if _unmarked(file, with_parameters=False)}
    rows = [
        (row, marks[row.occurrence.form]) for rows in gathered.file_rows.values() for row in rows
    ]
    certain = [row for row, mark in rows if mark == "Q0" or (mark == "" and row.number in whole)]
    if certain:
        return certain
    mixed = {number for number, file in enumerate(files) if _unmarked(file, with_parameters=True)}
    with_parameters = [row for row, mark in rows if mark == "" and row.number in mixed]
    held = {point_number(row) for row in with_parameters}
    return with_parameters if any(held.issuperset(numbers) for numbers in _claims(gathered)) else []


def _unmarked(file: ControlFile, *, with_parameters: bool) -> bool:
    """Return whether a file without Q addresses contains pitch error data: numbered lines for
    points, and no numbered line of another form. ``with_parameters``: lines with parameter numbers
    are allowed as well.
    """
    found = False
    for line in file.content.decode("latin-1").replace("\r", "\n").split("\n"):
        match = NUMBERED.match(line)
        if match is None or (int(match[1]) < POINTS_FROM and with_parameters):
            continue
        if int(match[1]) < POINTS_FROM or not _RECORD.fullmatch(match[2]):
            return False
        found = True
    return found


def _claims(gathered: Gathered) -> Iterator[range]:
    """Yield the range of point numbers from 3621 to 3622 of each axis, where both are readable."""
    for singles in gathered.singles.values():
        ends = [
            singles[name][-1].text for name in ("first_number", "last_number") if singles.get(name)
        ]
        if (
            len(ends) == 2
            and all(re.fullmatch("[0-9]{1,6}", end) for end in ends)
            and int(ends[0]) < int(ends[1])
        ):
            yield range(int(ends[0]), int(ends[1]) + 1)


def point_number(row: FoundValue) -> int:
    """Return the point number, from 0, in a line of pitch error data."""
    return int(row.occurrence.tokens["number"].text) - POINTS_FROM


def points_by_number(
    definition: Definition, gathered: Gathered, files: Sequence[ControlFile], notes: Notes
) -> dict[int, FoundValue]:
    """Return the pitch error data by point number, from 0.

    If a number is repeated with another value, or does not exist on the control, a fault is added.
    """
    highest = definition.limit_number("max_number") or 0
    points: dict[int, FoundValue] = {}
    beyond: list[FoundValue] = []
    for row in point_rows(definition, gathered, files):
        number = point_number(row)
        text = row.occurrence.tokens["value"].text
        if number > highest:
            beyond.append(row)
            continue
        first = points.setdefault(number, row)
        if not same_value(text, first.occurrence.tokens["value"].text):
            message = f"point {number} contradicts {first.where}"
            notes.faults.append(_fault(row, message, first.occurrence.tokens["value"].text, text))
    if beyond:
        numbers = sorted({point_number(row) for row in beyond})
        message = f"{len(numbers)} point numbers of this file do not exist in {definition.id}"
        fault = _fault(beyond[0], message, f"0 .. {highest}", f"{numbers[0]} .. {numbers[-1]}")
        hint = f"is this control another one? Then correct `format`; else {fault.hint}"
        notes.faults.append(replace(fault, hint=hint))
    return points


def _fault(found: FoundValue, message: str, expected: str, what: str) -> Fault:
    return Fault(
        message=message,
        file=found.occurrence.file,
        place=found.occurrence.place,
        expected=expected,
        found=what,
        hint=(
            "correct this line in a copy of the file, or export the pitch data from "
            "the control again"
        ),
    )
