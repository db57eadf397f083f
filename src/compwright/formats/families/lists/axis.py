"""What the lists of one axis do to it: its table, its backlash, and what else in them would act."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation

import numpy as np

from compwright.formats.definition.options import DETECTION_UNIT
from compwright.formats.families.activity import Activity
from compwright.formats.families.lists.files import Lists, entries
from compwright.formats.text.gathering import Found, same_value
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale, in_range
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.facts import Fact

#: What a whole number counts where the list does not count in increments, mm or deg.
TENTH = 0.0001
#: What such a count and an increment are called, as people read it.
COUNTS = {
    "tenths": "0.1 µm (rotary 0.0001 deg)",
    "increments": "encoder increments (kw.ssfk.unit 0)",
}
#: Type of a value -> the largest number that it holds.
VALUE_TYPES = {"sgn16": 32767, "sgn32": 2147483647}
_SIGNED_16 = 32767


def counted(definition_scale: Scale, options: Mapping[str, object], increment: float) -> Scale:
    """Return a scale in which one count is ``increment`` mm or deg."""
    return Scale(
        definition_scale.definition,
        definition_scale.kind,
        {**options, DETECTION_UNIT: increment},
        {},
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ListTable:
    """A table in mm or deg: ``positions`` (k,) ascending, ``positive``, ``negative`` (k,)
    corrections, ``period`` of one that repeats.
    """

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    two: bool = False
    period: float | None = None


class AxisLists:
    """Reads one axis; what is wrong goes to ``notes``. ``axis``: that of a job, None without
    one.
    """

    def __init__(
        self,
        lists: Lists,
        address: str,
        axis: Axis | None,
        options: Mapping[str, object],
        notes: Notes,
        activity: Activity,
    ) -> None:
        self.lists = lists
        self.definition = lists.definition
        self.address = address
        self.axis = axis
        self.options = options
        self.notes = notes
        self.activity = activity
        self.label = f"axis {address}"
        self.kind = axis.kind if axis is not None else AxisKind.LINEAR
        self.returns = (
            axis.reference_return
            if axis is not None
            else Direction(str(options["reference_return"]))
        )
        self.values = Values(self.definition, self.label, notes)
        self.said: dict[str, Fact] = {}
        self.enabled: bool | None = None

    # --- single statements

    def one(self, statement: str) -> Found | None:
        """Return what a statement says; said twice with two values it is a fault."""
        return self._agreed(statement, self.lists.places(self.address, statement))

    def _agreed(self, what: str, places: Sequence[Found]) -> Found | None:
        for place in places[1:]:
            if not same_value(place.text, places[0].text):
                message = f"{self.lists.name(what)} contradicts {places[0].where}"
                self.notes.refuse(self.label, message, place, expected=places[0].text)
                return None
        return places[0] if places else None

    def needed(self, statement: str, beside: Found | None) -> Found | None:
        """Return what a statement says; it must be there, because ``beside`` is."""
        found = self.one(statement)
        if found is None and not self.lists.places(self.address, statement):
            name = self.lists.name(statement)
            message = f"{name} is missing; missing is not zero"
            self.notes.refuse(self.label, message, beside, expected=name, found="none")
        return found

    def word(self, quantity: str) -> str | None:
        """Return the neutral word of a choice, with what counts where the lists do not say it."""
        found = self.one(self.definition.bindings[quantity].statement)
        return self.values.word(quantity, found) if found else self.values.absent(quantity)

    def acts(self, switch: str, manual: str, *, zero: bool, label: str) -> bool:
        """Return whether a table acts by the switch of the axis and its own manual activation.

        A switch in no list counts as on; one that is off is asked about where readings hang on
        the answer. ``zero``: it holds nothing but zeros.
        """
        on, by_hand = self.one(switch), self.one(manual)
        off = [
            place
            for place, means_off in ((on, "0"), (by_hand, "1"))
            if place is not None and same_value(place.text, means_off)
        ]
        for said_at in (on, by_hand):
            if said_at is not None and said_at.text.strip("0") not in ("", "1"):
                message = "a switch has a value that is not known"
                self.notes.refuse(self.label, message, said_at, expected="0 or 1")
        if off and zero:
            return False
        word = "no" if off else "yes" if on is not None else None
        if word is not None or self.activity.said is not None:
            place = off[0] if off else on
            by_switch = not off or off[0] is on
            name = self.lists.name(switch) if by_switch else f"{self.lists.name(manual)} not"
            said = self.activity.settle(label, name, word, place, self.notes)
            if said is None:
                self.notes.switched_off(label, f"it is switched off in the lists ({name} = 0)")
            elif not said:
                self.notes.switched_off(label, "it did not act, as the job says")
            return bool(said)
        name = self.lists.name(switch)
        self.notes.assume(f"{label}: {name}", "1", "unconfirmed: in no list that was given")
        return True

    # --- the table

    def read(self) -> AxisCompensation:
        """Return what acts on the axis itself."""
        table = self._table()
        zero = table is None or not (np.any(table.positive) or np.any(table.negative))
        acting = False
        if table is not None:
            acting = self.acts("table_switch", "manual", zero=zero, label=self.label)
            self.enabled = acting
        elif not self.lists.places(self.address, "count"):
            self.notes.assume(f"{self.label}: table", "none", "unconfirmed: in no list given")
            self.notes.no_table(self.label)
        backlash = self._backlash(two=acting and table is not None and table.two)
        empty = np.empty(0)
        shown = (
            table
            if table is not None and acting
            else ListTable(positions=empty, positive=empty, negative=empty)
        )
        return AxisCompensation(
            address=self.address,
            kind=self.kind,
            positions=shown.positions,
            positive=shown.positive,
            negative=shown.negative,
            backlash=backlash,
            reference_return=self.returns,
            below=self.definition.layout.below,
            above=self.definition.layout.above,
            period=shown.period,
        )

    def scale(self, word: str | None, place: Found | None) -> Scale | None:
        """Return how the numbers of a table are read, by the word of its unit; None where nobody
        says how long an increment is, which is asked.
        """
        increment: object = TENTH
        if word == "increments":
            increment = self.options.get("encoder_increment")
            if not isinstance(increment, (int, float)) or increment <= 0:
                self.notes.ask(
                    Fault(
                        message=(
                            f"{self.label}: its list counts in encoder increments"
                            f" ({self.lists.name('unit')} 0): how long is one?"
                        ),
                        file=place.occurrence.file if place is not None else "",
                        place=place.occurrence.place if place is not None else "",
                        expected="option encoder_increment: mm or deg per increment, more than 0",
                        found="nothing" if increment is None else str(increment),
                    )
                )
                return None
        elif word is None:
            return None
        base = Scale(self.definition, self.kind, self.options, {})
        return counted(base, self.options, float(str(increment)))

    def _table(self) -> ListTable | None:
        """Return the table of the list, whether it acts or not; None where there is none, or
        where it cannot be read.
        """
        before = len(self.notes.faults)
        count_at = self.one("count")
        rows = {column: self.rows(column) for column in ("setpoint", "positive", "negative")}
        spoken = any(
            self.lists.places(self.address, statement)
            for statement in ("unit", "interval", "start", "bilateral", "modulo", "manual")
        )
        if count_at is None and not any(rows.values()) and not spoken:
            return None
        count_at = self.needed("count", self._any_place())
        count = int(count_at.text) if count_at is not None else 0
        if count_at is not None and count == 0 and not any(rows.values()):
            return None
        unit_at = self.needed("unit", count_at)
        interval = self.needed("interval", count_at)
        bilateral_at = self.needed("bilateral", count_at)
        unit = self.word("table_form") if unit_at is not None else None
        two = self.word("bidirectional") if bilateral_at is not None else None
        self._check_count(count, count_at)
        if unit is not None:
            self.said["table_form"] = unit
        for column in ("positive", "negative"):
            self.complete(
                rows[column], count, column, count_at, needed=column == "positive" or two == "yes"
            )
        places = self._places(rows["setpoint"], count, interval, count_at)
        scale = self.scale(unit, unit_at)
        if len(self.notes.faults) > before or scale is None or two is None:
            return None
        if two == "no":
            self._one_column(rows)
        columns = {"positive": rows["positive"]}
        columns["negative"] = rows["negative"] if two == "yes" else rows["positive"]
        curves = {
            name: [self._value(scale, f"value_{name}", column[index]) for index in range(count)]
            for name, column in columns.items()
        }
        positions = [scale.read("node_position", str(place)) for place in places]
        table = ListTable(
            positions=np.array([float(place) for place in positions]),
            positive=np.array([float(value) for value in curves["positive"]]),
            negative=np.array([float(value) for value in curves["negative"]]),
            two=two == "yes",
            period=self._period(positions, curves, float(scale.factor("node_position"))),
        )
        return None if len(self.notes.faults) > before else table

    def _any_place(self) -> Found | None:
        said = self.lists.said.get(self.address, {})
        return next((found for places in said.values() for found in places), None)

    def rows(self, column: str) -> dict[int, Found]:
        """Return the entries of one column by index; two that differ are a fault."""
        by_index: dict[int, list[Found]] = {}
        for index, found in entries(self.lists.places(self.address, column)):
            by_index.setdefault(index, []).append(found)
        agreed = {index: self._agreed(column, found) for index, found in by_index.items()}
        return {index: found for index, found in agreed.items() if found is not None}

    def _check_count(self, count: int, place: Found | None) -> None:
        room = self.room("max_points", int(self.values.absent("max_points", tell=False) or 0))
        if count >= room:
            name = self.lists.name("count")
            message = f"{name} must be less than {self.lists.name('max_points')}"
            self.notes.refuse(self.label, message, place, expected=f"at most {room - 1}")
        elif count == 0:
            message = f"{self.lists.name('count')} is 0, but the list holds entries"
            self.notes.refuse(self.label, message, place, expected="their number")

    def room(self, statement: str, default: int) -> int:
        """Return how many entries there is room for; 0 means the default."""
        found = self.one(statement)
        said = int(found.text) if found is not None else 0
        if said:
            self.said[statement] = said
        return said or default

    def complete(
        self,
        rows: Mapping[int, Found],
        count: int,
        column: str,
        place: Found | None,
        *,
        needed: bool = True,
    ) -> None:
        """Every entry must be there, and none beyond the last one."""
        name = self.lists.name(column)
        missing = [index for index in range(count) if index not in rows] if needed else []
        if missing:
            message = (
                f"{name.replace('..', str(missing[0]))} is missing ({len(missing)} of {count});"
            )
            message += " missing is not zero"
            self.notes.refuse(self.label, message, place, expected=f"indices 0 to {count - 1}")
        beyond = [index for index in sorted(rows) if index >= count]
        if beyond and count:
            message = f"{name.replace('..', str(beyond[0]))} lies beyond the last entry"
            expected = f"indices 0 to {count - 1}, or {self.lists.name('count')} as it should be"
            self.notes.refuse(self.label, message, rows[beyond[0]], expected=expected)

    def _places(
        self,
        setpoints: Mapping[int, Found],
        count: int,
        interval: Found | None,
        place: Found | None,
    ) -> list[Decimal]:
        """Return the positions of the entries, as counts; they must ascend."""
        if interval is None:
            return []
        step = Decimal(interval.text)
        result = (
            self._even(setpoints, count, step, interval)
            if step
            else self._listed(setpoints, count, place)
        )
        self.check_ascending(result, setpoints, interval)
        low, high = self.definition.measure("node_position").range
        for value in (result[0], result[-1]) if result else ():
            if not low <= value <= high:
                message = "a position is beyond the range of the control"
                self.notes.refuse(self.label, message, place, expected="32 bits", found=str(value))
        return result

    def _listed(
        self, setpoints: Mapping[int, Found], count: int, place: Found | None
    ) -> list[Decimal]:
        """Return the positions where every entry has its setpoint."""
        self.complete(setpoints, count, "setpoint", place)
        result = [Decimal(setpoints[index].text) for index in range(count) if index in setpoints]
        start = self.one("start")
        if start is not None and result and Decimal(start.text) != result[0]:
            message = f"{self.lists.name('start')} is not the first setpoint"
            self.notes.refuse(self.label, message, start, expected=str(result[0]))
        return result

    def _even(
        self, setpoints: Mapping[int, Found], count: int, step: Decimal, interval: Found
    ) -> list[Decimal]:
        """Return the positions at equal spacing; setpoints beside it must say the same."""
        start = self.needed("start", interval)
        if start is None:
            return []
        result = [Decimal(start.text) + index * step for index in range(count)]
        self.complete(setpoints, count, "setpoint", interval, needed=False)
        for index, found in setpoints.items():
            if index < count and Decimal(found.text) != result[index]:
                message = "a setpoint does not lie where start and interval put it"
                self.notes.refuse(self.label, message, found, expected=str(result[index]))
        return result

    def check_ascending(
        self, places: Sequence[Decimal], setpoints: Mapping[int, Found], otherwise: Found
    ) -> None:
        """Refuse the first of some positions that does not lie above the one before it."""
        for index in range(1, len(places)):
            if places[index] <= places[index - 1]:
                message = f"the positions do not ascend at entry {index}"
                at, found = setpoints.get(index, otherwise), str(places[index])
                expected = f"more than {places[index - 1]}"
                self.notes.refuse(self.label, message, at, expected=expected, found=found)
                return

    def _one_column(self, rows: Mapping[str, Mapping[int, Found]]) -> None:
        """A table for both directions uses the column of +; another one beside it must be the
        same.
        """
        for index, found in rows["negative"].items():
            first = rows["positive"].get(index)
            if first is not None and not same_value(first.text, found.text):
                message = "bilateral is 0, but the column for - holds another value"
                self.notes.refuse(self.label, message, found, expected=first.text)

    def _value(self, scale: Scale, quantity: str, found: Found) -> Decimal:
        self._check_type(found)
        value = scale.read(quantity, found.text)
        if not in_range(self.definition.measure(quantity), scale, value):
            message = "a value is beyond the range of the control"
            self.notes.refuse(self.label, message, found, expected="32 bits")
        return value

    def _check_type(self, found: Found) -> None:
        """Hold a number against the type of the values, where somebody says it."""
        kind = str(self.options.get("value_type"))
        most = VALUE_TYPES.get(kind)
        number = Decimal(found.text)
        if most is not None and (abs(number) > most or number != int(number)):
            message = f"a value does not fit the type {kind} (option value_type)"
            expected = f"a whole number, {-most} to {most}"
            self.notes.refuse(self.label, message, found, expected=expected)

    def _period(
        self, positions: Sequence[Decimal], curves: Mapping[str, Sequence[Decimal]], count: float
    ) -> float | None:
        """Return the turn of a table that repeats: first and last entry are one place."""
        place = self.one("modulo")
        if self.word("repeats") != "yes" or place is None:
            return None
        span = float(positions[-1] - positions[0])
        if any(curve[0] != curve[-1] for curve in curves.values()) or not span:
            message = "the table repeats, so first and last entry must be equal"
            expected = "two entries or more, the same values at both ends"
            self.notes.refuse(self.label, message, place, expected=expected)
        turn = self.axis.modulo if self.axis is not None else None
        if turn is not None and abs(turn - span) > 1.5 * count:
            message = "the table repeats, but not after the modulo of the job"
            self.notes.refuse(self.label, message, place, expected=f"{turn:g}", found=f"{span:g}")
        return span

    # --- backlash

    def _backlash(self, *, two: bool) -> float:
        """Return the backlash, mm or deg; ``two``: a table with two columns acts."""
        switch = self.one("backlash_switch")
        gears = self.rows("backlash")
        lose = gears.get(0)
        on = switch is not None and not same_value(switch.text, "0")
        if switch is not None and switch.text.strip("0") not in ("", "1", "2"):
            message = "the switch of the backlash has a value that is not known"
            self.notes.refuse(self.label, message, switch, expected="0, 1 or 2")
        if lose is None:
            if switch is not None and on:
                message = f"the backlash is switched on, but {self._lose()} is missing"
                expected = "the axis parameter list with it too"
                self.notes.refuse(self.label, message, switch, expected=expected)
            else:
                value = self.values.absent("backlash", tell=False)
                evidence = "unconfirmed: in no list that was given"
                self.notes.assume(f"{self.label}: {self._lose()}", str(value), evidence)
        for gear, found in gears.items():
            if (
                gear
                and Decimal(found.text)
                and (lose is None or not same_value(found.text, lose.text))
            ):
                message = f"gear {gear} has another backlash than gear 0"
                self.notes.refuse(self.label, message, found, expected="the same, or 0")
        if lose is None or Decimal(lose.text) == 0:
            return 0.0
        if switch is None:
            message = f"{self._lose()} is not 0, but no list says whether it acts"
            expected = f"{self.lists.name('backlash_switch')} in the lists too"
            self.notes.refuse(self.label, message, lose, expected=expected)
        return self._acting_backlash(Decimal(lose.text), lose, two=two) if on else 0.0

    def _lose(self) -> str:
        return self.lists.name("backlash").replace("..", "0")

    def _acting_backlash(self, number: Decimal, place: Found, *, two: bool) -> float:
        if number != int(number) or abs(number) > _SIGNED_16:
            expected = f"a whole number, {-_SIGNED_16} to {_SIGNED_16}"
            self.notes.refuse(self.label, "a backlash must be whole", place, expected=expected)
        elif number < 0:
            message = "a backlash less than 0 (play before the measuring system) is not understood"
            self.notes.refuse(self.label, message, place, expected="0 or more, or switched off")
        elif two:
            message = "a backlash acts beside a table with two columns, which holds the reversal"
            self.notes.refuse(self.label, message, place, expected="0, or switched off")
        other = "-" if self.returns is Direction.POSITIVE else "+"
        self.notes.assume(
            f"{self.label}: direction in which {self._lose()} acts",
            f"arriving in {other}",
            "unconfirmed: no page says which direction gets the backlash",
        )
        return float(number * Decimal(str(TENTH)))

    # --- what else would act

    def check_others(self) -> None:
        """Refuse, by name, what would act on the axis beside table, backlash and one table from
        another axis.
        """
        for found in self.lists.places(self.address, "other"):
            if not _is_zero(found.text):
                name = found.occurrence.tokens["name"].text
                message = f"kw.{name} is not known, and whether it acts neither"
                self.notes.refuse(self.label, message, found, expected="0, or a list without it")
        switch = self.one("plane_switch")
        if switch is not None and same_value(switch.text, "0"):
            return
        for found in self.lists.places(self.address, "plane"):
            if not _is_zero(found.text):
                message = (
                    "a compensation over two other axes (kw.crosscomp2) acts, which is not read"
                )
                expected = f"{self.lists.name('plane_switch')} 0, or values of 0"
                self.notes.refuse(self.label, message, found, expected=expected)


def _is_zero(text: str) -> bool:
    try:
        return Decimal(text) == 0
    except InvalidOperation:
        return False
