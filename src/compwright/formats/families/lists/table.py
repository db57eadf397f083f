"""Read the table in the list of an axis as corrections by position."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from compwright.formats.families.lists.statements import AxisStatements
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import CORRECT_VALUE
from compwright.formats.text.scale import NumberScale, in_range
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray
from compwright.records.options import DETECTION_UNIT
from compwright.words.sentences import control_text

#: What a whole number counts where the list does not count in increments, mm or deg.
TENTH = 0.0001
#: What such a count and an increment are called, as people read it.
COUNTS = {
    "tenths": control_text("0.1 µm (rotary 0.0001 deg)"),
    "increments": control_text("encoder increments (kw.ssfk.unit 0)"),
}
#: Type of a value -> the largest number that it holds.
VALUE_TYPES = {"sgn16": 32767, "sgn32": 2147483647}
#: The columns of a table.
COLUMNS = ("setpoint", "positive", "negative")


def counted(
    definition_scale: NumberScale, options: Mapping[str, object], increment: float
) -> NumberScale:
    """Return the scale that converts whole numbers in an axis' value list to mm or deg and back;
    each number counts multiples of ``increment`` (mm or deg).
    """
    return NumberScale(
        definition_scale.definition,
        definition_scale.kind,
        {**options, DETECTION_UNIT: increment},
        {},
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ListTable:
    """A table: ``positions`` (k,) ascending, corrections ``positive`` and ``negative`` (k,), mm or
    deg.

    ``period``: the length after which the table repeats, deg; None if it does not repeat.
    """

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    two: bool = False
    period: float | None = None


class TableReader:
    """Reads the table of one axis from its list; faults are added to the axis' notes."""

    def __init__(self, of: AxisStatements) -> None:
        self.of = of

    def read(self) -> ListTable | None:
        """Return the table in the list, active or not; None if the list contains no table that can
        be read.
        """
        of, before = self.of, len(self.of.notes.faults)
        rows = {column: of.rows(column) for column in COLUMNS}
        names = ("count", "unit", "interval", "start", "bilateral", "modulo", "manual")
        if not any(rows.values()) and not any(of.lists.places(of.address, n) for n in names):
            return None
        self._note_limits()
        count_at = of.needed("count", of.any_place())
        count = int(count_at.text) if count_at is not None else 0
        if count_at is not None and count == 0 and not any(rows.values()):
            return None
        unit, two = (
            self._needed_word("table_form", count_at),
            self._needed_word("bidirectional", count_at),
        )
        interval = of.needed("interval", count_at)
        self._check_count(count, count_at)
        for column in ("positive", "negative"):
            needed = column == "positive" or two == "yes"
            of.complete(rows[column], count, column, count_at, needed=needed)
        scale = self.scale(unit, of.one("unit"))
        if len(of.notes.faults) > before or interval is None:
            return None
        places = self._places(rows["setpoint"], count, interval, count_at)
        if len(of.notes.faults) > before or scale is None:
            return None
        if two == "no":
            self._one_column(rows)
            rows["negative"] = rows["positive"]
        table = self._corrections(scale, places, rows, two=two == "yes")
        return None if len(of.notes.faults) > before else table

    def _note_limits(self) -> None:
        """Record the unit of the list and the number of entries that the control reserves, because
        a new table has to keep to both.
        """
        if self.of.one("unit") is not None and (word := self.of.word("table_form")) is not None:
            self.of.stated["table_form"] = word
        self.of.room("max_points", 0)

    def _needed_word(self, quantity: str, given: FoundValue | None) -> str | None:
        """Return the meaning of a setting with a few possible values; if the list lacks the
        setting, add a fault at the line of ``given``.
        """
        statement = self.of.definition.bindings[quantity].statement
        return None if self.of.needed(statement, given) is None else self.of.word(quantity)

    def _corrections(
        self,
        scale: NumberScale,
        places: Sequence[Decimal],
        rows: Mapping[str, Mapping[int, FoundValue]],
        *,
        two: bool,
    ) -> ListTable:
        positive, negative = (
            [
                self._value(scale, f"value_{column}", rows[column][index])
                for index in range(len(places))
            ]
            for column in ("positive", "negative")
        )
        positions = [scale.read("node_position", str(place)) for place in places]
        count = float(scale.factor("node_position"))
        return ListTable(
            positions=np.array([float(place) for place in positions]),
            positive=np.array([float(value) for value in positive]),
            negative=np.array([float(value) for value in negative]),
            two=two,
            period=self._period(positions, (positive, negative), count),
        )

    def scale(self, word: str | None, place: FoundValue | None) -> NumberScale | None:
        """Return unit, sign and resolution of a table's numbers; ``word`` is the unit that the list
        states.

        If the unit is increments of unknown length, a question is added and None is returned.
        """
        increment: object = TENTH
        if word == "increments":
            increment = self.of.options.get("encoder_increment")
            if not isinstance(increment, (int, float)) or increment <= 0:
                self.of.notes.ask(
                    Fault(
                        message=(
                            f"{self.of.label}: its list counts in encoder increments "
                            f"({self.of.lists.name('unit')} 0), whose length is unknown"
                        ),
                        file=place.occurrence.file if place is not None else "",
                        place=place.occurrence.place if place is not None else "",
                        expected="option encoder_increment: mm or deg per increment, more than 0",
                        found="nothing" if increment is None else str(increment),
                        hint=(
                            "give `encoder_increment` in the options of the axis (without a job: "
                            "`--option encoder_increment=0.001`)"
                        ),
                    )
                )
                return None
        elif word is None:
            return None
        base = NumberScale(self.of.definition, self.of.kind, self.of.options, {})
        return counted(base, self.of.options, float(str(increment)))

    def _check_count(self, count: int, place: FoundValue | None) -> None:
        room = self.of.room("max_points", int(self.of.values.absent("max_points", tell=False) or 0))
        if count >= room:
            name = self.of.lists.name("count")
            message = f"{name} must be less than {self.of.lists.name('max_points')}"
            self.of.notes.refuse(
                self.of.label, message, place, expected=f"at most {room - 1}", hint=CORRECT_VALUE
            )
        elif count == 0:
            message = f"{self.of.lists.name('count')} is 0, but the list contains entries"
            self.of.notes.refuse(
                self.of.label, message, place, expected="their number", hint=CORRECT_VALUE
            )

    def _places(
        self,
        setpoints: Mapping[int, FoundValue],
        count: int,
        interval: FoundValue | None,
        place: FoundValue | None,
    ) -> list[Decimal]:
        """Return the entries' positions in the list's unit; a position out of order is a fault.
        ``setpoints``: the stated positions by index; ``interval``: the line with the interval;
        ``place``: the line with the number of entries.
        """
        if interval is None:
            return []
        step = Decimal(interval.text)
        result = (
            self._even(setpoints, count, step, interval)
            if step
            else self._listed(setpoints, count, place)
        )
        self.of.check_ascending(result, setpoints, interval)
        low, high = self.of.definition.measure("node_position").range
        for value in (result[0], result[-1]) if result else ():
            if not low <= value <= high:
                self.of.notes.refuse(
                    self.of.label,
                    "a position is beyond the range of the control",
                    place,
                    expected="32 bits",
                    found=str(value),
                    hint=CORRECT_VALUE,
                )
        return result

    def _listed(
        self, setpoints: Mapping[int, FoundValue], count: int, place: FoundValue | None
    ) -> list[Decimal]:
        """Return the positions written for the entries, each of which must have one."""
        self.of.complete(setpoints, count, "setpoint", place)
        result = [Decimal(setpoints[index].text) for index in range(count) if index in setpoints]
        start = self.of.one("start")
        if start is not None and result and Decimal(start.text) != result[0]:
            message = f"{self.of.lists.name('start')} is not the first setpoint"
            self.of.notes.refuse(
                self.of.label, message, start, expected=str(result[0]), hint=CORRECT_VALUE
            )
        return result

    def _even(
        self, setpoints: Mapping[int, FoundValue], count: int, step: Decimal, interval: FoundValue
    ) -> list[Decimal]:
        """Return equally spaced positions by the interval; positions in the list must agree with
        them.
        """
        start = self.of.needed("start", interval)
        if start is None:
            return []
        result = [Decimal(start.text) + index * step for index in range(count)]
        self.of.complete(setpoints, count, "setpoint", interval, needed=False)
        for index, found in setpoints.items():
            if index < count and Decimal(found.text) != result[index]:
                message = "a setpoint does not lie where start and interval put it"
                self.of.notes.refuse(
                    self.of.label, message, found, expected=str(result[index]), hint=CORRECT_VALUE
                )
        return result

    def _one_column(self, rows: Mapping[str, Mapping[int, FoundValue]]) -> None:
        """Check that the column for -, if the list contains one, equals the column for +."""
        for index, found in rows["negative"].items():
            first = rows["positive"].get(index)
            if first is not None and not same_value(first.text, found.text):
                message = "bilateral is 0, but the column for - contains another value"
                self.of.notes.refuse(
                    self.of.label, message, found, expected=first.text, hint=CORRECT_VALUE
                )

    def _value(self, scale: NumberScale, quantity: str, found: FoundValue) -> Decimal:
        self._check_type(found)
        value = scale.read(quantity, found.text)
        if not in_range(self.of.definition.measure(quantity), scale, value):
            message = "a value is beyond the range of the control"
            self.of.notes.refuse(
                self.of.label, message, found, expected="32 bits", hint=CORRECT_VALUE
            )
        return value

    def _check_type(self, found: FoundValue) -> None:
        """Check that a value fits the number type that the option ``value_type`` states."""
        kind = str(self.of.options.get("value_type"))
        most = VALUE_TYPES.get(kind)
        number = Decimal(found.text)
        if most is not None and (abs(number) > most or number != int(number)):
            self.of.notes.refuse(
                self.of.label,
                f"a value does not fit the type {kind} (option value_type)",
                found,
                expected=f"a whole number, {-most} to {most}",
                hint="set the option `value_type` to the type of the values in the control",
            )

    def _period(
        self, positions: Sequence[Decimal], curves: Sequence[Sequence[Decimal]], count: float
    ) -> float | None:
        """Return the turn of a repeating table, whose first and last entries must have equal
        values.
        """
        place = self.of.one("modulo")
        if self.of.word("repeats") != "yes" or place is None:
            return None
        span = float(positions[-1] - positions[0])
        if any(curve[0] != curve[-1] for curve in curves) or not span:
            message = "the table repeats, so first and last entry must be equal"
            expected = "two entries or more, the same values at both ends"
            self.of.notes.refuse(
                self.of.label, message, place, expected=expected, hint=CORRECT_VALUE
            )
        turn = self.of.axis.modulo if self.of.axis is not None else None
        if turn is not None and abs(turn - span) > 1.01 * count:
            message = "the table repeats, but not after the modulo of the job"
            self.of.notes.refuse(
                self.of.label,
                message,
                place,
                expected=f"{turn:g}",
                found=f"{span:g}",
                hint=f"set `modulo: {span:g}` for the axis in the job, if the control is right",
            )
        return span
