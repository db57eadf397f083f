"""The sections of an axis' table: their point numbers and their length, from the files."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.increment_facts import IncrementFacts
from compwright.formats.families.increments.job_checks import SAME_PLACE
from compwright.formats.families.increments.numbering import section_numbers
from compwright.formats.text.notes import ADD_FILE, Notes
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.stored_table import StoredTable

_DISORDER = "the numbers are not in order"
#: Quantities that say where an axis' table lies.
GRID = ("reference_number", "first_number", "last_number", "magnification", "table_spacing")


@dataclass(frozen=True, slots=True)
class IncrementSections:
    """The sections of an axis' table: point numbers of the reference, the first and the last
    section; the interval and the magnification.

    ``negative``: the first point number of the data set for travel towards -; None if one set is
    used for both directions.
    """

    reference: int
    first: int
    last: int
    interval: float
    magnification: int
    negative: int | None

    @property
    def numbers(self) -> range:
        """The point numbers of the sections, without the second set for travel towards -."""
        return range(self.first, self.last + 1)

    @property
    def second(self) -> range | None:
        """The point numbers of the second set, for travel towards -."""
        negative = self.negative
        return None if negative is None else range(negative, negative + len(self.numbers))

    def points(self, zero: float, *, round_turn: bool) -> FloatArray:
        """Return the section ends, mm or deg, with the reference at ``zero``. ``round_turn``: the
        sections cover one turn that begins at the reference.
        """
        begin = self.reference if round_turn else self.first - 1
        steps = np.arange(begin, self.last + 1) - self.reference
        places: FloatArray = np.round(zero + steps * self.interval, 9)
        return places

    def spans_turn(self, turn: float) -> bool:
        """Return whether the sections cover exactly one turn (deg), beginning at the reference."""
        return abs((self.last - self.reference) * self.interval - turn) < SAME_PLACE


def read_sections(values: IncrementAxisValues, kind: AxisKind) -> IncrementSections | None:
    """Return the sections of the axis' table; None if the files contain no table, or if its
    parameters have faults.
    """
    if values.yes("compensation_off"):
        _note_switched_off(values)
        return None
    present = {name: values.found(name) for name in GRID}
    if not any(present.values()):
        ends = f"{values.name('reference_number')} to {values.name('table_spacing')}"
        why = f"unconfirmed: no file that was given contains its parameters {ends}"
        values.notes.assume(f"{values.label}: table", "none", why)
        values.notes.no_table(values.label)
        return None
    if values.integer("magnification") == 0:
        number = values.name("magnification")
        values.notes.switched_off(values.label, f"{number} = 0")
        return None
    missing = [values.name(name) for name, found in present.items() if found is None]
    if missing:
        values.wrong(
            next(name for name, found in present.items() if found is not None),
            "the other parameters of this table are missing",
            ", ".join(missing),
            "no such line in the files",
            hint="give the file with these parameters with the control's other files",
        )
        return None
    return _checked(values, kind)


def _note_switched_off(values: IncrementAxisValues) -> None:
    """Report that stored pitch error compensation is off, so that no table can be active."""
    number = values.name("compensation_off")
    values.notes.switched_off(values.label, f"{number}#0 = 1")
    if values.axis is not None:
        values.wrong(
            "compensation_off",
            f"stored pitch error compensation is off on this control ({number}#0), so a table"
            " would not be active",
            f"{number}#0 = 0 (it needs the option), then a power cycle and a new measurement",
            f"{number}#0 = 1",
            hint=(
                f"set {number}#0 to 0 in the control, switch the control off and on, measure the"
                " axis again and export its files again"
            ),
        )


def order(values: IncrementAxisValues) -> str:
    """Return as text the order that the control requires of the table's point numbers, as
    parameters: "3621 <= 3620 <= 3622".
    """
    names = ("first_number", "reference_number", "last_number")
    return " <= ".join(values.name(name) for name in names)


def repeats(values: IncrementAxisValues, kind: AxisKind, sections: IncrementSections) -> bool:
    """Return whether the table repeats: the job has an endless axis, or the sections span a turn.

    A table of a rotary axis with ends (1006#1) never repeats, nor does one with two data sets.
    """
    ends = values.wraps() is False or sections.negative is not None
    if kind is not AxisKind.ROTARY or ends:
        return False
    if values.axis is not None and values.axis.modulo is not None:
        return True
    from_reference = sections.first - sections.reference in (0, 1)
    return from_reference and sections.spans_turn(values.turn(kind))


def idle_points(values: IncrementAxisValues, kind: AxisKind) -> tuple[float, ...]:
    """Return the section ends (mm or deg) of an inactive table (3623 = 0); empty if unknown.

    They are unknown if the parameters do not describe a table, or if there is no job that states
    the reference position.
    """
    values = replace(values, notes=Notes())
    numbers = [values.integer(name) for name in GRID[:-1]]
    interval = values.length("table_spacing", kind)
    reference, first, last, magnification = (number or 0 for number in numbers)
    whole = None not in numbers and first < last and first - 1 <= reference <= last
    if values.axis is None or magnification or not whole or not interval or interval < 0:
        return ()
    sections = IncrementSections(reference, first, last, float(interval), 0, None)
    points = sections.points(values.axis.reference, round_turn=repeats(values, kind, sections))
    return tuple(float(point) for point in points)


def _checked(values: IncrementAxisValues, kind: AxisKind) -> IncrementSections | None:
    reference, first, last, magnification = (int(values.integer(name) or 0) for name in GRID[:-1])
    highest = values.definition.limit_number("max_number") or 0
    most = values.definition.limit_number("max_magnification") or 100
    before = len(values.notes.faults)
    round_from_next = kind is AxisKind.ROTARY and first == reference + 1 and first < last
    if not first <= reference <= last and not round_from_next:
        values.wrong("first_number", _DISORDER, order(values), f"{first}, {reference}, {last}")
    if last > highest:
        values.wrong(
            "last_number",
            "the point number is beyond those of the control",
            f"at most {highest}",
            str(last),
        )
    if not 0 <= magnification <= most:
        values.wrong(
            "magnification", "the magnification does not exist", f"0 .. {most}", str(magnification)
        )
    if first == last and len(values.notes.faults) == before:
        same = f"{values.name('first_number')} = {values.name('last_number')} = {first}"
        values.notes.switched_off(values.label, same)
        return None
    interval = values.length("table_spacing", kind)
    if interval is not None and interval <= 0:
        values.wrong("table_spacing", "the interval is not positive", "more than 0", str(interval))
    negative = _negative_first(values, range(first, last + 1), highest)
    if len(values.notes.faults) > before or interval is None:
        return None
    sections = IncrementSections(reference, first, last, float(interval), magnification, negative)
    return _next_to_reference(values, kind, sections) if round_from_next else sections


def _next_to_reference(
    values: IncrementAxisValues, kind: AxisKind, sections: IncrementSections
) -> IncrementSections | None:
    """Return sections whose first point number is one above the reference's, with a warning, if
    they cover exactly one turn.

    Real controls use such numbers, although the manual requires 3621 = 3620. Any other order of the
    numbers is a fault, and None is returned.
    """
    first, reference, last = sections.first, sections.reference, sections.last
    turn = values.turn(kind)
    if not sections.spans_turn(turn) or sections.negative is not None:
        expected = f"{order(values)}, or a full turn of {turn:g} deg"
        values.wrong("first_number", _DISORDER, expected, f"{first}, {reference}, {last}")
        return None
    own, zero = values.name("first_number"), values.name("reference_number")
    values.notes.find(
        "CW-S041",
        "warning",
        label=values.label,
        own=own,
        first=first,
        zero=zero,
        last=last,
        reference=reference,
    )
    return sections


def _negative_first(values: IncrementAxisValues, own: range, highest: int) -> int | None:
    """Return the first point number of the set for travel towards -; None without a second set.
    ``own``: the point numbers of the first set; ``highest``: the control's last point number.
    """
    if not values.yes("bidirectional"):
        return None
    negative = values.integer("negative_first")
    if negative is None:
        message = "bidirectional compensation is on (3605#0), but 3626 is missing"
        values.wrong("bidirectional", message, "3626", hint=ADD_FILE)
        return None
    end = negative + own[-1] - own[0]
    found = f"{negative} .. {end}"
    if negative < 0 or end > highest:
        message = "the set for travel in - leaves the control's numbers"
        values.wrong("negative_first", message, f"0 .. {highest}", found)
    elif negative <= own[-1] and own[0] <= end:
        expected = f"clear of {own[0]} .. {own[-1]}"
        values.wrong("negative_first", "the two sets overlap", expected, found)
    return negative


def stored_sections(
    axis: Axis, compensation: AxisCompensation, facts: IncrementFacts
) -> StoredTable:
    """Return the table of an axis with a row for each section, and for the reference's own number
    where that has none. ``facts``: what the files state about its table.
    """
    points = compensation.positions
    if points.size < 2:
        return StoredTable.by_point(compensation)
    interval = float(points[-1] - points[0]) / (points.size - 1)
    low, high = (round(float(end - axis.reference) / interval) for end in points[[0, -1]])
    if axis.modulo is not None:
        rows = np.arange(points.size - 1)
        if facts.reference_number is None or facts.first_number == facts.reference_number:
            rows = np.insert(rows, 0, rows[-1])
        return StoredTable(compensation=compensation, order=rows, steps=True, zero=-low)
    first, last = section_numbers(low, high)
    if None not in (facts.reference_number, facts.last_number):
        kept = int(facts.last_number or 0) - int(facts.reference_number or 0)
        last = high if high == kept else last
    numbers = np.arange(first - 1, last + 1)
    positions: FloatArray = np.round(axis.reference + numbers * interval, 9)
    held = np.clip(numbers - low, 0, points.size - 1)
    table = replace(
        compensation,
        positions=positions,
        positive=compensation.positive[held],
        negative=compensation.negative[held],
    )
    order = np.arange(numbers.size - 1)
    return StoredTable(compensation=table, order=order, steps=True, zero=1 - first)
