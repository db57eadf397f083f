"""SINUMERIK 840D sl: leadscrew error compensation (EEC, ``$AA_ENC_COMP``) and backlash (MD32450).

Stated from the manuals, apart from the definition that writes the files:

- The table's value is added to the actual value, so a positive value moves the axis towards minus: the shift of the axis is
  minus the value (Function Manual Extended Functions 03/2013, p. 238; 808D Function Manual 01/2017, p. 106).
- Linear between points (p. 237). Below MIN nothing acts, above MAX the last value stays (p. 240). A modulo table
  repeats with the period MAX - MIN (p. 242).
- MD32700 must be 1 for the table to act (p. 237); a load sequence counts by its last value.
- MD32450 positive: the encoder leads the machine part, plain lost motion (808D ADVANCED parameter manual p. 241). Nothing in
  the direction of referencing, on reversal the whole value in the direction of motion: shift = sgn(d) * MD32450 * MD32452.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.request import Request, by_address, unknown_axis
from compwright.controllers.sinumerik_text import Assignment, read_file
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile

#: MIN + k * STEP must meet MAX to this part of a step, else the control and the file count different points.
_WHOLE_STEPS = 1e-6


@dataclass(frozen=True, slots=True)
class _Table:
    """Values (k + 1,) in mm or deg at ``lowest`` + i * ``step``; they are errors, not corrections."""

    lowest: float
    highest: float
    step: float
    modulo: bool
    values: FloatArray

    def positions(self) -> FloatArray:
        nodes = np.asarray(self.lowest + self.step * np.arange(self.values.size), dtype=np.float64)
        nodes[-1] = self.highest
        return nodes

    def shift(self, positions: FloatArray) -> FloatArray:
        """Return how far the table moves the axis at ``positions`` (any shape)."""
        x = self.lowest + np.mod(positions - self.lowest, self.highest - self.lowest) if self.modulo else positions
        if self.values.size == 1:
            value = np.full(x.shape, self.values[0])
        else:
            steps = (x - self.lowest) / self.step
            left = np.clip(np.floor(steps), 0, self.values.size - 2).astype(np.intp)
            part = steps - left
            value = (1.0 - part) * self.values[left] + part * self.values[left + 1]
        value = np.where(x >= self.highest, self.values[-1], value)
        value = np.where(x < self.lowest, 0.0, value)
        return np.asarray(0.0 - value, dtype=np.float64)


@dataclass(frozen=True, slots=True)
class _Axis:
    table: _Table | None
    enabled: bool
    backlash: float
    reference_return: Direction


@dataclass(frozen=True, slots=True)
class SinumerikControl:
    """A SINUMERIK 840D sl with files loaded, all axes referenced. See ``controllers.virtual.VirtualControl``."""

    axes: dict[str, _Axis]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the machine axes that the files speak of, in order of appearance."""
        return tuple(self.axes)

    def nodes(self, address: str) -> FloatArray:
        """Return the positions (k,) of the table, whether it is switched on or not."""
        table = self._axis(address).table
        return np.empty(0) if table is None else table.positions()

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the shift of the axis at ``positions`` (any shape) arriving in ``direction``, mm or deg."""
        axis = self._axis(address)
        x = np.asarray(positions, dtype=np.float64)
        total = axis.table.shift(x) if axis.table is not None and axis.enabled else np.zeros(x.shape)
        if direction is not axis.reference_return:
            total = total + direction.sign * axis.backlash
        return total

    def _axis(self, address: str) -> _Axis:
        axis = by_address(self.axes, address)
        if axis is None:
            raise unknown_axis(address, self.addresses())
        return axis


def sinumerik_control(files: Sequence[ControlFile], request: Request) -> SinumerikControl:
    """Return the control with ``files`` loaded (table files, machine data, whole text archives, in any order).

    The active measuring system is ``request.encoder``; where it is not given, the only one with a table, and this is listed
    in ``assumed``. Raises InputError for what the control would not take or what contradicts itself: every fault with
    file and line. UsageError for a measuring system other than 1 or 2.
    """
    contents = [read_file(file) for file in files]
    faults = [fault for content in contents for fault in content.faults]
    assignments = [entry for content in contents for entry in content.assignments]
    if not assignments and not faults:
        names = ", ".join(file.name for file in files)
        faults.append(Fault(message="no compensation data found", file=names, expected="$AA_ENC_COMP or $MA_BACKLASH"))
    faults += [fault for entry in assignments if (fault := _out_of_range(entry)) is not None]
    raise_all(InputError, faults)
    by_axis: dict[str, list[Assignment]] = defaultdict(list)
    for entry in assignments:
        by_axis[entry.axis.upper()].append(entry)
    loader = _Loader(request)
    axes = {entries[0].axis: loader.axis(entries) for entries in by_axis.values()}
    raise_all(InputError, loader.faults)
    notes = [note for content in contents for note in content.notes] + loader.notes
    return SinumerikControl(axes=axes, assumed=tuple(loader.assumed), notes=tuple(notes))


def _out_of_range(entry: Assignment) -> Fault | None:
    """Return the fault of a value that no SINUMERIK takes, None for a good one."""
    if not math.isfinite(entry.value):
        return entry.fault(f"value of ${entry.name} is not a finite number", found=str(entry.value))
    if entry.name.endswith(("_ENABLE", "_IS_MODULO")) and entry.value not in {0.0, 1.0}:
        return entry.fault(f"value of ${entry.name}", expected="0 or 1", found=f"{entry.value:g}")
    if entry.name == "MA_BACKLASH_FACTOR":
        return (
            None
            if 0.01 <= entry.value <= 100.0
            else entry.fault("backlash factor", expected="0.01 to 100", found=f"{entry.value:g}")
        )
    if entry.system not in {0, 1}:
        return entry.fault("index of the measuring system", expected="0 or 1", found=str(entry.system))
    return None


class _Loader:
    """Builds the axes from their assignments and gathers what is assumed, worth a note, or wrong."""

    def __init__(self, request: Request) -> None:
        self.request = request
        self.assumed: list[Assumption] = []
        self.notes: list[str] = []
        self.faults: list[Fault] = []

    def axis(self, entries: list[Assignment]) -> _Axis:
        """Return one axis from its assignments in the order of the files."""
        name = entries[0].axis
        tables = {system: self._table([e for e in entries if e.system == system and e.name.startswith("AA_")]) for system in (0, 1)}
        system = self._system(name, entries, tables)
        self._check_points(entries, tables)
        for other, table in tables.items():
            if table is not None and other != system:
                self.notes.append(
                    f"{name}: the table of measuring system {other + 1} does not act; system {system + 1} is the active one"
                )
        table = tables[system]
        enabled = _last(entries, "MA_ENC_COMP_ENABLE", system)
        if table is not None and enabled is None:
            self.assumed.append(Assumption(f"MD32700 $MA_ENC_COMP_ENABLE of {name}", "1", "not in the files: counted as active"))
        elif table is not None and enabled == 0.0:
            self.notes.append(f"{name}: MD32700 $MA_ENC_COMP_ENABLE[{system}] ends as 0: the table does not act")
        backlash = _last(entries, "MA_BACKLASH", system) or 0.0
        returning, assumption = self.request.returning(name)
        if assumption is not None:
            self.assumed.append(assumption)
        return _Axis(
            table=table,
            enabled=enabled != 0.0,
            backlash=backlash * self._factor(name, entries),
            reference_return=returning,
        )

    def _factor(self, name: str, entries: list[Assignment]) -> float:
        """Return MD32452 of the first parameter set, 1 when the files do not hold it."""
        if any(e.name == "MA_BACKLASH_DYN" and e.value != 0.0 for e in entries):
            self.assumed.append(Assumption(f"dynamic backlash MD32456 of {name}", "off", "switched on by the PLC only"))
        factors = {e.system: e.value for e in entries if e.name == "MA_BACKLASH_FACTOR"}
        if len(set(factors.values())) > 1:
            self.assumed.append(Assumption(f"parameter set of {name} (MD32452)", "0", "default"))
        return factors.get(0, 1.0)

    def _system(self, name: str, entries: list[Assignment], tables: dict[int, _Table | None]) -> int:
        """Return the index of the active measuring system."""
        given = by_address(self.request.encoder, name)
        if given is not None:
            if given not in {1, 2}:
                raise UsageError(Fault(message=f"measuring system of {name}", expected="1 or 2", found=repr(given)))
            return given - 1
        holding = [system for system, table in tables.items() if table is not None]
        switched_on = [system for system in holding if _last(entries, "MA_ENC_COMP_ENABLE", system) != 0.0]
        play = [system for system in tables if _last(entries, "MA_BACKLASH", system)]
        rules = (
            (holding, "the only one with a table"),
            (switched_on, "the only one whose table is switched on"),
            (play if not holding else [], "the only one with a backlash value"),
        )
        system, why = next(((found[0], why) for found, why in rules if len(found) == 1), (0, "default"))
        self.assumed.append(Assumption(f"active measuring system of {name}", str(system + 1), why))
        return system

    def _check_points(self, entries: list[Assignment], tables: dict[int, _Table | None]) -> None:
        """MD38000 below the number of points: the control would shorten the table."""
        for entry in entries:
            table = tables.get(entry.system)
            if entry.name == "MA_MM_ENC_COMP_MAX_POINTS" and table is not None and entry.value < table.values.size:
                self.faults.append(
                    entry.fault(
                        f"MD38000 of {entry.axis} reserves fewer points than the table needs",
                        expected=f"at least {table.values.size}",
                        found=f"{entry.value:g}",
                    )
                )

    def _table(self, entries: list[Assignment]) -> _Table | None:
        """Return the table of one axis and measuring system; None without one, or when it is wrong (then there are faults)."""
        if not entries:
            return None
        before = len(self.faults)
        grid = {key: self._single(entries, f"AA_ENC_COMP_{key}") for key in ("STEP", "MIN", "MAX", "IS_MODULO")}
        values = self._values(entries)
        first = entries[0]
        label = f"table of {first.axis}, measuring system {first.system + 1}"
        missing = [f"$AA_ENC_COMP_{key}" for key in ("STEP", "MIN", "MAX") if grid[key] is None]
        if missing:
            self.faults.append(first.fault(f"{label} is incomplete", expected=", ".join(missing)))
        if len(self.faults) > before:
            return None
        step, low, high = (grid[key] or 0.0 for key in ("STEP", "MIN", "MAX"))
        if step == low == high == 0.0 and not any(values.values()):
            self.notes.append(f"{label}: all zero, the control's own default for no table")
            return None
        count = self._count(first, label, step, low, high)
        if count is None:
            return None
        modulo = grid["IS_MODULO"]
        if modulo is None:
            self.assumed.append(Assumption(f"$AA_ENC_COMP_IS_MODULO of {first.axis}", "0", "not in the files"))
        if modulo and count < 2:
            self.faults.append(first.fault(f"{label} repeats (IS_MODULO = 1) but has a single point", expected="MAX above MIN"))
            return None
        column = self._column(first, label, values, count)
        return None if column is None else _Table(low, high, step, bool(modulo), column)

    def _count(self, first: Assignment, label: str, step: float, low: float, high: float) -> int | None:
        """Return the number of points k + 1, k = (MAX - MIN) / STEP; None with a fault when it is no whole number."""
        if step <= 0.0 or high < low:
            self.faults.append(
                first.fault(
                    f"grid of the {label}", expected="STEP > 0 and MAX >= MIN", found=f"STEP {step:g}, MIN {low:g}, MAX {high:g}"
                )
            )
            return None
        steps = (high - low) / step
        if not steps < 1e6 or abs(steps - round(steps)) > _WHOLE_STEPS:
            self.faults.append(
                first.fault(
                    f"(MAX - MIN) / STEP of the {label} is no whole number of steps",
                    found=f"({high!r} - {low!r}) / {step!r} = {steps!r}",
                )
            )
            return None
        return round(steps) + 1

    def _column(self, first: Assignment, label: str, values: dict[int, float], count: int) -> FloatArray | None:
        """Return the values (count,) of points 0..count-1; None with a fault when they do not fill the grid."""
        absent = [point for point in range(count) if point not in values]
        if absent:
            self.faults.append(
                first.fault(
                    f"{label} has missing points (a file cut short?)",
                    expected=f"points 0 to {count - 1}",
                    found="no point " + ", ".join(map(str, absent[:5])) + (" ..." if len(absent) > 5 else ""),
                )
            )
            return None
        beyond = {point: value for point, value in values.items() if point >= count}
        if any(beyond.values()):
            self.faults.append(
                first.fault(f"{label} has points above MAX", expected=f"points 0 to {count - 1}", found=f"point {max(beyond)}")
            )
            return None
        if beyond:
            self.notes.append(f"{label}: points {min(beyond)} to {max(beyond)} lie above MAX and are not used (all zero)")
        return np.array([values[point] for point in range(count)], dtype=np.float64)

    def _single(self, entries: list[Assignment], name: str) -> float | None:
        """Return the value of a variable that may be given once; a repetition must agree."""
        given = [entry for entry in entries if entry.name == name]
        self._agree(given)
        return given[0].value if given else None

    def _values(self, entries: list[Assignment]) -> dict[int, float]:
        """Return point -> value."""
        points: dict[int, list[Assignment]] = defaultdict(list)
        for entry in entries:
            if entry.point is not None:
                points[entry.point].append(entry)
        for same in points.values():
            self._agree(same)
        return {point: same[0].value for point, same in points.items()}

    def _agree(self, same: list[Assignment]) -> None:
        for entry in same[1:]:
            if entry.value != same[0].value:
                where = f"{same[0].file}, line {same[0].line}"
                self.faults.append(
                    entry.fault(
                        f"${entry.name} of {entry.axis} contradicts {where}",
                        expected=f"{same[0].value:g}",
                        found=f"{entry.value:g}",
                    )
                )


def _last(entries: list[Assignment], name: str, system: int) -> float | None:
    """Return the last value assigned to a variable of one measuring system, None without one."""
    return next((entry.value for entry in reversed(entries) if entry.name == name and entry.system == system), None)
