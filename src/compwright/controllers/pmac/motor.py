"""Corrections of a motor by its tables and its backlash, in counts of the motor.

The control takes the uncorrected position of the source motor modulo the length of the table. It
interpolates linearly between two entries and adds the result to the target motor, in both
directions of motion. Backlash (Ixx86 and the backlash table) is subtracted while the last commanded
direction of the motor is negative. It is active only with a take-up rate Ixx85 above 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.pmac.script import (
    ENABLE,
    LARGEST,
    SIZE,
    TAKE_UP,
    Card,
    CardTable,
    ScriptPlace,
    VariableSetting,
)
from compwright.controllers.request import Request, by_address, finite_number
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray
from compwright.records.correction import Assumption

#: Entries and Ixx86 count 1/16 count.
PER_COUNT = 16.0


@dataclass(frozen=True, slots=True)
class MotorScale:
    """The encoder counts of a motor per mm or deg of its axis, negative if the two run opposite.

    ``zero``: machine coordinate of motor zero, mm or deg.
    """

    counts: float
    zero: float

    def motor(self, x: FloatArray) -> FloatArray:
        """Return motor positions (counts) for machine coordinates ``x`` (mm or deg, any shape)."""
        return (x - self.zero) * self.counts

    def points(self, tables: Sequence[CardTable]) -> FloatArray:
        """Return the machine coordinates of all entries of ``tables`` and of motor zero, ascending.

        Each table contributes the entries of one length; its repetitions are left out.
        """
        places = [
            table.length * np.arange(table.announced + 1) / table.announced for table in tables
        ]
        motor = np.unique(np.concatenate(places)) if places else np.empty(0)
        return np.sort(self.zero + motor / self.counts)


@dataclass(frozen=True, slots=True)
class Motor:
    """One motor with its tables and its backlash.

    - ``own``: tables that correct the motor by its own position.
    - ``varying``: its backlash table, None without one.
    - ``constant``: backlash Ixx86, 1/16 count.
    - ``tables_active``, ``backlash_active``: whether tables and backlash are switched on.
    """

    own: tuple[CardTable, ...]
    varying: CardTable | None
    constant: float
    tables_active: bool
    backlash_active: bool

    @property
    def tables(self) -> tuple[CardTable, ...]:
        """All tables that correct the motor by its own position, active or not."""
        return (*self.own, *(() if self.varying is None else (self.varying,)))

    @property
    def idle(self) -> bool:
        """Return whether the correction is 0 everywhere, whatever the counts per unit are."""
        return not self.tables and not (self.constant and self.backlash_active)

    def added(self, position: FloatArray, *, negative: bool) -> FloatArray:
        """Return the correction (counts) at the motor position ``position`` (counts, any shape).
        ``negative``: the motor was last commanded in negative direction.
        """
        total = np.zeros(position.shape)
        for table in self.own if self.tables_active else ():
            total = total + looked_up(table, position)
        if negative and self.backlash_active:
            total = total - self.constant / PER_COUNT
            if self.varying is not None and self.tables_active:
                total = total - looked_up(self.varying, position)
        return total


def looked_up(table: CardTable, position: FloatArray) -> FloatArray:
    """Return a table's value (target counts) at ``position`` of its source motor (counts)."""
    points = table.length * np.arange(table.announced + 1) / table.announced
    values = np.array([0, *table.entries], dtype=np.float64) / PER_COUNT
    return np.asarray(np.interp(np.mod(position, table.length), points, values), dtype=np.float64)


class Judged:
    """Reads the active compensation of each motor; collects assumptions and faults by motor."""

    def __init__(self, card: Card, request: Request, assumed: list[Assumption]) -> None:
        self.card = card
        self.request = request
        self.assumed = assumed
        self.faults: list[tuple[int, Fault]] = []
        self.enabled = self._enabled()

    def motors(self) -> dict[int, Motor]:
        """Return every motor that has a table or whose backlash a script sets, by motor number."""
        numbers = {table.target for table in self.card.tables.values() if table.kind != "TCOMP"}
        numbers |= {number // 100 for number in self.card.variables if number != ENABLE}
        return {number: self._motor(number) for number in sorted(numbers)}

    def crossing(self) -> dict[tuple[int, int], list[CardTable]]:
        """Return the tables between two motors, by (source motor, target motor)."""
        found: dict[tuple[int, int], list[CardTable]] = {}
        for table in self.card.tables.values():
            if table.kind == "COMP" and not table.plane and table.source != table.target:
                self._closed(table)
                found.setdefault((table.source, table.target), []).append(table)
        return found

    def _enabled(self) -> bool:
        """Return whether the last value of the variable I51 is 1; if none is set, tables are
        active.
        """
        setting = self.card.variables.get(ENABLE)
        if setting is not None and setting.value not in (0.0, 1.0):
            self._wrong(0, setting, "I51", "0 or 1")
        value = None if setting is None else setting.value
        active = self.request.is_active([value])
        if (value is None or self.request.active is not None) and self.card.tables:
            why = "not in the files" if self.request.active is None else "as the job says"
            self.assumed.append(Assumption("I51", str(int(active)), why))
        return active

    def _wrong(self, motor: int, setting: VariableSetting, name: str, expected: str) -> None:
        fault = setting.place.fault(name, expected=expected, found=repr(setting.text))
        self.faults.append((motor, fault))

    def _motor(self, number: int) -> Motor:
        for name in (ENABLE, 100 * number + TAKE_UP, 100 * number + SIZE):
            if name in self.card.later:
                message = f"a program sets I{name} when it runs: what is active then is unknown"
                self.faults.append((number, self.card.later[name].fault(message)))
        own = []
        for table in self.card.tables.values():
            if table.target == number and table.kind == "COMP" and table.plane:
                self._plane(table)
            elif table.target == table.source == number and table.kind == "COMP":
                self._closed(table)
                own.append(table)
        varying = self.card.tables.get(("BLCOMP", number))
        if varying is not None:
            self._closed(varying)
        size = self._size(number, varying, has_table=bool(own))
        amount = size != 0.0 or (varying is not None and any(varying.entries))
        backlash = amount and self._taken_up(number, varying)
        return Motor(tuple(own), varying, size, self.enabled, backlash)

    def _closed(self, table: CardTable) -> None:
        """Check that the last entry of a table, which is at motor zero, is 0."""
        if table.entries and table.entries[-1] != 0:
            message = (
                f"the last entry of DEFINE {table.kind} of motor {table.motor} is the place of"
                " motor zero too, where nothing is corrected"
            )
            fault = table.place.fault(message, expected="0", found=str(table.entries[-1]))
            self.faults.append((table.target, fault))
        self._turn(table)

    def _turn(self, table: CardTable) -> None:
        """Check that one turn of an endless axis is a whole number of repetitions of its table."""
        turn = by_address(self.request.modulo, str(table.source))
        options = self.request.options_of(str(table.source))
        counts = abs(finite_number(options.get("counts_per_unit")) or 0.0) * (turn or 0.0)
        # half a count: a turn need not be a whole number of counts
        if counts and abs(counts - round(counts / table.length) * table.length) > 0.5:
            message = f"the table repeats after {table.length} counts, the axis after its turn"
            expected = f"{counts:.12g} counts, or a whole part of it"
            self.faults.append((table.target, table.place.fault(message, expected=expected)))

    def _plane(self, table: CardTable) -> None:
        if any(table.entries):
            message = f"a table over two motors corrects motor {table.target}: not read"
            fault = table.place.fault(message, expected="entries 0, or none")
            self.faults.append((table.target, fault))

    def _register(self, number: int) -> float | None:
        """Return the value of a backlash variable; None if no script sets the variable or, with a
        fault, if the value is invalid.
        """
        setting = self.card.variables.get(number)
        if setting is None:
            return None
        value = setting.value
        if value is None or value != value // 1 or not 0.0 <= value <= LARGEST:
            self._wrong(number // 100, setting, f"I{number}", f"a whole number, 0 to {LARGEST}")
            return None
        return value

    def _size(self, number: int, varying: CardTable | None, *, has_table: bool) -> float:
        """Return the constant backlash of a motor (variable Ixx86, 1/16 count). If no script sets
        it, it is 0: with a fault if the motor has a backlash table (``varying``), which would add
        to it.
        """
        name = 100 * number + SIZE
        value = self._register(name)
        if value is None and name not in self.card.variables:
            if varying is not None:
                self._missing(number, name, varying.place, "the backlash table adds to it")
            elif has_table:
                self.assumed.append(Assumption(f"I{name}", "0", "not in the files"))
        return value or 0.0

    def _taken_up(self, number: int, varying: CardTable | None) -> bool:
        """Return whether backlash compensation is active, because its take-up rate is not 0.
        ``varying``: the motor's backlash table, or None.
        """
        name = 100 * number + TAKE_UP
        value = self._register(name)
        if value is None and name not in self.card.variables and self.request.active is None:
            setting = self.card.variables.get(100 * number + SIZE)
            if setting is not None:
                place = setting.place
            else:
                place = varying.place if varying is not None else ScriptPlace("", 0)
            self._missing(number, name, place, "0, its default, switches backlash off")
            return False
        active = self.request.is_active([value])
        if not active:
            self.card.notes.append(f"backlash of motor {number} is off (I{name})")
        return active

    def _missing(self, motor: int, name: int, place: ScriptPlace, why: str) -> None:
        fault = place.fault(f"I{name} is not in the files: {why}", expected=f"a line I{name}=...")
        self.faults.append((motor, fault))
