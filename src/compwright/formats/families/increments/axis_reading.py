"""Read the parameters and pitch error data of one FANUC axis as its compensation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.families.increments import parameter_checks
from compwright.formats.families.increments.axis_facts import note_lead
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.backlash import active_backlash, smooth_backlash
from compwright.formats.families.increments.detection_unit import detection_unit, two_systems
from compwright.formats.families.increments.inclination_and_cyclic import counted
from compwright.formats.families.increments.job_checks import (
    check_diameter,
    check_reference,
    check_return,
    check_travel_limits,
    check_wrapping,
)
from compwright.formats.families.increments.neighbour_functions import functions, left_alone, stays
from compwright.formats.families.increments.points import POINTS_FROM
from compwright.formats.families.increments.sections import (
    IncrementSections,
    read_sections,
    repeats,
)
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE, NOT_COUNTED
from compwright.formats.text.scale import NumberScale
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.options import REFERENCE, REFERENCE_RETURN
from compwright.words.sentences import control_text, unconfirmed

_NO_POINTS = np.empty(0)
LIMIT = "increment_limit"


@dataclass(frozen=True, slots=True)
class IncrementReader:
    """Reads the compensation of one axis of a FANUC control.

    ``points``: the pitch data of all axes by point number. ``options``: the options of the axis.
    ``checks_travel``: compare the axis' software limits with the job's travel.
    """

    values: IncrementAxisValues
    points: Mapping[int, FoundValue]
    options: Mapping[str, object]
    checks_travel: bool = True

    def read(self) -> AxisCompensation | None:
        """Return the active compensation of the axis; None if its data cannot be read (the notes
        then contain the faults).
        """
        values = self.values
        kind = values.kind()
        self._check_neighbours(kind)
        check_wrapping(values, kind)
        if self.checks_travel:
            check_travel_limits(values, kind)
        note_lead(values, kind)
        backlash = self._backlash(kind)
        sections = read_sections(values, kind)
        unanswered = sections is not None and self.options.get("points_from") != "reference"
        check_reference(values, kind, self._reference(), unanswered=unanswered)
        check_return(values, two=sections is not None and sections.negative is not None)
        check_diameter(values, kind)
        if sections is None:
            curves = (_NO_POINTS, _NO_POINTS, _NO_POINTS)
            return self._with_counted(kind, None, self._compensation(kind, curves, backlash))
        for numbers in filter(None, (sections.numbers, sections.second)):
            values.notes.faults.extend(parameter_checks.meets(values.own, numbers))
        own = self._increments(sections.numbers)
        other = own if sections.second is None else self._increments(sections.second)
        if own is None or other is None:
            return None
        if repeats(values, kind, sections):
            turning = self._endless(kind, sections, own, backlash)
            return None if turning is None else self._with_counted(kind, sections, turning)
        positions = sections.points(self._reference(), round_turn=False)
        scale = float(self._unit(kind)) * sections.magnification * self._sign("pitch_sign")
        positive, negative = (totals(each, sections) * scale for each in (own, other))
        if sections.negative is not None:
            shift = self._offset(sections, kind)
            if self._returning() is Direction.POSITIVE:
                negative = negative + shift
            else:
                positive = positive + shift
        table = self._compensation(kind, (positions, positive, negative), backlash)
        return self._with_counted(kind, sections, table)

    def _with_counted(
        self, kind: AxisKind, sections: IncrementSections | None, table: AxisCompensation
    ) -> AxisCompensation:
        """Return the table; if the options include inclination compensation and the cyclic table,
        these are among its ``others``.
        """
        functions = counted(self.values, kind, self.options, self._increments)
        unit = float(self._unit(kind)) * self._sign("pitch_sign")
        points = table.positions
        others = []
        for places, sums, period in functions.curves(sections, points, self._reference(), unit):
            if table.period is not None and period is None and sums[0] != sums[-1]:
                self.values.wrong(
                    "last_number",
                    "the inclination compensation is not the same at both ends of the turn",
                    "5871 to 5874 with the same amount at both ends of the turn",
                    hint=NOT_COUNTED,
                )
            others.append(
                replace(
                    table,
                    positions=places,
                    positive=sums + 0.0,
                    negative=sums + 0.0,
                    backlash=0.0,
                    period=period or table.period,
                )
            )
        return replace(table, others=tuple(others))

    def _check_neighbours(self, kind: AxisKind) -> None:
        """Check the parameters and functions that affect the axis in addition to its table: add
        faults, and report functions that stay unchanged.
        """
        values, own, notes = self.values, self.values.own, self.values.notes
        notes.faults.extend((*own.contradictions(), *parameter_checks.refusals(own)))
        if values.axis is not None or values.does_anything():
            notes.faults.extend(parameter_checks.unread_bits(own, kind))
            notes.faults.extend(parameter_checks.unclear_path(own, kind))
        parameter_checks.note_unconfirmed_bits(own, notes)
        for function in left_alone(functions(own), self.options):
            notes.find("CW-S048", "warning", label=values.label, function=stays(function))
        near = smooth_backlash(own)
        if near is not None:
            unit = detection_unit(own, kind)
            size = float(self._unit(kind)) if unit is None else unit.size
            near.note(values.label, kind, size, notes)
        systems = two_systems(own)
        if systems:
            notes.find("CW-S043", "warning", values.label, label=values.label, systems=systems)

    def _compensation(
        self,
        kind: AxisKind,
        curves: tuple[FloatArray, FloatArray, FloatArray],
        backlash: float,
        period: float | None = None,
    ) -> AxisCompensation:
        """Return the compensation from ``curves``: positions and corrections (+, -), (n,) each, mm
        or deg.
        """
        positions, positive, negative = curves
        return AxisCompensation(
            address=self.values.own.address,
            kind=kind,
            positions=positions,
            positive=positive + 0.0,
            negative=negative + 0.0,
            backlash=backlash,
            reference_return=self._returning(),
            interpolation="linear" if self.options.get("output") == "ramp" else "step",
            period=period,
        )

    def _unit(self, kind: AxisKind) -> Decimal:
        return NumberScale(self.values.definition, kind, self.options, {}).factor("value")

    def _sign(self, option: str) -> int:
        return -1 if self.options.get(option) == "-" else 1

    def _reference(self) -> float:
        axis = self.values.axis
        return axis.reference if axis else float(str(self.options[REFERENCE]))

    def _returning(self) -> Direction:
        axis = self.values.axis
        return axis.reference_return if axis else Direction(str(self.options[REFERENCE_RETURN]))

    def _backlash(self, kind: AxisKind) -> float:
        values = self.values
        found = values.found("backlash")
        if found is None:
            values.absent("backlash", "backlash")
            return 0.0
        low, high = values.definition.measure("backlash").range
        value = int(Decimal(found.text))
        if not low <= value <= high:
            message = "a backlash that the control cannot store"
            values.notes.refuse(
                values.label, message, found, expected=f"{low:g} .. {high:g}", hint=CORRECT_VALUE
            )
        return float(active_backlash(values, value) * self._unit(kind))

    def rapid_more(self) -> float | None:
        """Return backlash at rapid traverse minus backlash at cutting feed, mm or deg; None if
        unknown.
        """
        rapid, separate = self.values.integer("backlash_rapid"), self.values.separate_rapid()
        more = 0 if rapid is None else rapid - (self.values.integer("backlash") or 0)
        if separate is None and more:
            return None
        return float(more * self._unit(self.values.kind(quiet=True))) if separate else 0.0

    def _increments(self, numbers: range) -> FloatArray | None:
        """Return the increments (k,) at the point ``numbers``; None, with a fault, if one of them
        is missing or too large.
        """
        notes, label = self.values.notes, self.values.label
        missing = [number for number in numbers if number not in self.points]
        if missing:
            what = f"{numbers.start} to {numbers.stop - 1}, without {number_list(missing)}"
            message = (
                f"point data are missing ({len(missing)} of {len(numbers)}); missing is not zero"
                if self.points
                else "its table is on, and no file that was given contains pitch data; the"
                " control saves them apart from its parameters"
            )
            where = self.values.found("last_number")
            expected = f"the pitch data N{POINTS_FROM + missing[0]} and so on"
            notes.refuse(label, message, where, expected=expected, found=what, hint=ADD_FILE)
            return None
        limit = increment_limit(self.options)
        rows = [self.points[number] for number in numbers]
        counts = [int(row.occurrence.tokens["value"].text) for row in rows]
        for row, count in zip(rows, counts, strict=True):
            if abs(count) > limit:
                message = "an increment that the control cannot store (option increment_limit)"
                notes.refuse(
                    label,
                    message,
                    row,
                    expected=f"-{limit} .. {limit}",
                    found=str(count),
                    hint=f"{self._way_on(abs(count))}; else {CORRECT_VALUE}",
                )
                return None
        return np.array(counts, dtype=np.float64)

    def _way_on(self, size: int) -> str:
        """Return the next step for the user if an increment of this ``size`` is larger than the
        control accepts.
        """
        fitting = [one for one in self.values.definition.options[LIMIT].choices if int(one) >= size]
        if fitting:
            return f"if the control accepts it, set the option `{LIMIT}` to `{fitting[0]}`"
        return "if the control shows another value there, export its pitch data again"

    def _offset(self, sections: IncrementSections, kind: AxisKind) -> float:
        """Return parameter 3627 in mm or deg: the correction at the reference position if the axis
        comes from the direction opposite to the reference return.
        """
        values = self.values
        count = values.integer("negative_offset")
        if count is None:
            message = "bidirectional compensation is on (3605#0), but 3627 is missing"
            values.notes.refuse(
                values.label,
                message,
                values.found("bidirectional"),
                expected="3627",
                found="",
                hint=ADD_FILE,
            )
        values.notes.assume(
            control_text("{label}: bidirectional compensation", label=values.label),
            control_text("as 3605#0, 3626 and 3627 are understood"),
            unconfirmed(control_text("no manual page")),
        )
        magnified = self.options.get("offset_magnified") == "yes"
        magnification = sections.magnification if magnified else 1
        return float((count or 0) * magnification * self._unit(kind)) * self._sign("offset_sign")

    def _endless(
        self, kind: AxisKind, sections: IncrementSections, counts: FloatArray, backlash: float
    ) -> AxisCompensation | None:
        values = self.values
        turn, where = values.turn(kind), values.found("last_number")
        spans = sections.last - sections.reference
        # The number of the reference itself owns no section of its own.
        skipped = 1 - (sections.first - sections.reference)
        if skipped not in (0, 1) or not sections.spans_turn(turn):
            message = (
                "the table of an endless axis must span one turn (3622 = 3620 + turn / interval)"
            )
            expected = f"{turn:g} deg in whole sections"
            found = f"{spans} sections of {sections.interval:g} deg"
            values.notes.refuse(
                values.label, message, where, expected=expected, found=found, hint=CORRECT_VALUE
            )
            return None
        creep = float(np.sum(counts[skipped:]))
        if creep != 0:
            message = (
                "the increments of one turn do not add up to zero: the correction creeps each turn"
            )
            values.notes.refuse(
                values.label,
                message,
                where,
                expected="sum 0",
                found=f"{creep:g}",
                hint=CORRECT_VALUE,
            )
            return None
        if skipped and counts[0] != counts[-1]:
            values.notes.find(
                "CW-S016",
                "warning",
                label=values.label,
                first=sections.reference,
                last=sections.last,
                value=counts[-1],
            )
        sums = np.concatenate([[0.0], np.cumsum(counts[skipped:])])
        unit = float(self._unit(kind)) * sections.magnification
        curve = sums * unit * self._sign("pitch_sign")
        positions = sections.points(self._reference(), round_turn=True)
        return self._compensation(kind, (positions, curve, curve), backlash, turn)


def totals(counts: FloatArray, sections: IncrementSections) -> FloatArray:
    """Return the correction (k + 1,) at the ends of the sections, zero at the reference: the sum of
    the increments ``counts`` (k,) from there.
    """
    sums = np.concatenate([[0.0], np.cumsum(counts)])
    zero: FloatArray = sums - sums[sections.reference - sections.first + 1]
    return zero


def increment_limit(options: Mapping[str, object]) -> int:
    """Return the largest increment that the control accepts for one point."""
    return int(str(options[LIMIT]))


def number_list(numbers: list[int]) -> str:
    """Return numbers as text with commas, such as "1, 2, 3"; from the ninth on cut to ".."."""
    return ", ".join(map(str, numbers[:8])) + (" .." if len(numbers) > 8 else "")
