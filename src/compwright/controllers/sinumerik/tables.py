"""Tables by index of a SINUMERIK: a value at each point MIN + N * STEP up to MAX, linear in
between.

Source: manual pages 237-249. Leadscrew tables and CEC (sag) tables have the same four parameters,
and the same contradictions can occur in them.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.controllers.sinumerik.text import VariableAssignment
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray
from compwright.records.correction import Assumption

#: MIN + k * STEP meets MAX to this part of a step: rounding of printed digits.
_WHOLE_STEPS = 1e-6
#: To this part of a step it was meant to: loader programs print steps of four decimals (19.7436 for
#: 770 / 39). Counted as met, and reported.
_MEANT_STEPS = 1e-3
#: No control divides a millimetre or a degree further; below it positions and steps leave double
#: precision.
_LEAST_STEP = 1e-9


@dataclass(frozen=True, slots=True)
class CompensationTable:
    """A table with values (k + 1,) at ``lowest`` + i * ``step``, mm or deg.

    ``highest``: position of the last value. ``modulo``: the table repeats after ``highest`` -
    ``lowest``.
    """

    lowest: float
    highest: float
    step: float
    modulo: bool
    values: FloatArray

    def positions(self) -> FloatArray:
        """Return the positions (k + 1,) of the points."""
        points = np.asarray(self.lowest + self.step * np.arange(self.values.size), dtype=np.float64)
        points[-1] = self.highest
        return points

    def value(self, positions: FloatArray) -> FloatArray:
        """Return the table's value at ``positions`` (any shape). Outside the table the end values
        apply.
        """
        x = (
            self.lowest + np.mod(positions - self.lowest, self.highest - self.lowest)
            if self.modulo
            else positions
        )
        if self.values.size == 1:
            return np.full(x.shape, self.values[0])
        steps = np.clip((x - self.lowest) / self.step, 0.0, float(self.values.size - 1))
        left = np.minimum(np.floor(steps), self.values.size - 2).astype(np.intp)
        part = steps - left
        value = (1.0 - part) * self.values[left] + part * self.values[left + 1]
        return np.asarray(np.where(x >= self.highest, self.values[-1], value), dtype=np.float64)


@dataclass(slots=True)
class Remarks:
    """The assumptions, notes and faults found while the virtual control is built from its files."""

    assumed: list[Assumption] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def last_value(entries: Sequence[VariableAssignment], name: str) -> float | None:
    """Return the last value assigned to a variable; None if no value is assigned."""
    return next((entry.value for entry in reversed(entries) if entry.name == name), None)


def single(
    entries: Sequence[VariableAssignment], name: str, faults: list[Fault]
) -> VariableAssignment | None:
    """Return the assignment of a variable that should occur once; repetitions must agree."""
    given = [entry for entry in entries if entry.name == name]
    _agree(given, faults)
    return given[0] if given else None


def is_default(entries: Sequence[VariableAssignment], prefix: str) -> bool:
    """Return whether all numbers of a table are 0, as in a control without such a table."""
    grid = [
        entry
        for entry in entries
        if entry.name in {f"{prefix}_STEP", f"{prefix}_MIN", f"{prefix}_MAX"}
    ]
    values = [entry for entry in entries if entry.name == prefix]
    return len({entry.name for entry in grid}) == 3 and not any(
        entry.value for entry in (*grid, *values)
    )


def build_table(
    entries: Sequence[VariableAssignment],
    prefix: str,
    label: str,
    owner: str,
    remarks: Remarks,
    *,
    stranger: bool = False,
) -> CompensationTable | None:
    """Return the table that its assignments define. None if it is invalid, with faults in
    ``remarks``, or with a note if the axis is not part of the job (``stranger``).

    ``prefix``: name of the variable that contains the values. ``label``: name of the table in
    messages. ``owner``: name of the axis or table in the assumption that IS_MODULO is 0, if the
    files do not state it.
    """
    faults: list[Fault] = []
    first = entries[0]
    given = {
        key: single(entries, f"{prefix}_{key}", faults)
        for key in ("STEP", "MIN", "MAX", "IS_MODULO")
    }
    values = _values([entry for entry in entries if entry.name == prefix], faults)
    missing = [f"${prefix}_{key}" for key in ("STEP", "MIN", "MAX") if given[key] is None]
    if missing:
        faults.append(first.fault(f"{label} is incomplete", expected=", ".join(missing)))
    step, low, high = (
        entry.value if (entry := given[key]) is not None else 0.0 for key in ("STEP", "MIN", "MAX")
    )
    ends = None if faults else _ends(first, label, (step, low, high), faults)
    column = None if ends is None else _column(first, label, values, ends, faults)
    if ends is not None and column is not None:
        count = ends.count
        beyond = sorted(point for point in values if point >= count)
        if beyond:
            remarks.notes.append(
                f"{label}: points {beyond[0]} to {beyond[-1]} lie above MAX and are not used"
            )
        modulo = given["IS_MODULO"]
        if modulo is None:
            remarks.assumed.append(
                Assumption(f"${prefix}_IS_MODULO of {owner}", "0", "not in the files")
            )
        table = CompensationTable(
            low, ends.highest, step, modulo is not None and modulo.value == 1.0, column
        )
        odd = _impossible(first, label, table)
        if ends.split and (table.modulo or values.get(count, 0.0) != column[-1]):
            odd = [*odd, _split(first, label, prefix, (step, low, high))]
        if ends.meant:
            fact = f"${prefix}_STEP of {owner}, {step!r}"
            remarks.assumed.append(
                Assumption(fact, f"{count} points up to MAX", "MIN + k * STEP nearly meets MAX")
            )
        faults += odd
        if not faults:
            return table
    if stranger:
        remarks.notes += [f"{fault.message}: left alone" for fault in faults]
    else:
        remarks.faults += faults
    return None


def too_few_points(
    reserved: Sequence[VariableAssignment], table: CompensationTable, label: str
) -> list[Fault]:
    """Return a fault for each assignment in ``reserved`` (machine data) that reserves fewer points
    than the table needs, so that the control cuts the table.
    """
    return [
        entry.fault(
            f"{label} reserves fewer points than the table needs",
            expected=f"at least {table.values.size}",
            found=f"{entry.value:g}",
        )
        for entry in reserved
        if entry.value < table.values.size
    ]


def _impossible(first: VariableAssignment, label: str, table: CompensationTable) -> list[Fault]:
    """Return the faults of a table that is complete but cannot be evaluated; they show the place of
    its assignment ``first``.
    """
    if np.any(np.diff(table.positions()) <= 0.0):
        return [
            first.fault(
                f"STEP of the {label} is too small to change a position as large as MIN",
                found=f"STEP {table.step!r}, MIN {table.lowest!r}",
            )
        ]
    if table.modulo and table.values.size < 2:
        return [
            first.fault(
                f"{label} repeats (IS_MODULO = 1) but has a single point", expected="MAX above MIN"
            )
        ]
    jump = float(table.values[0] - table.values[-1])
    if table.modulo and jump != 0.0:
        return [
            first.fault(
                f"{label} repeats (IS_MODULO = 1) and jumps by {jump:.9g} at every turn",
                expected=f"the last value equal to the first, {table.values[0]:g}",
                found=f"{table.values[-1]:g}",
            )
        ]
    return []


@dataclass(frozen=True, slots=True)
class _Ends:
    """The end of a table: ``count`` points up to ``highest``.

    ``meant``: STEP divides the range only approximately, and MAX counts as a point. ``split``: STEP
    does not divide the range, so MAX is between two points.
    """

    count: int
    highest: float
    meant: bool = False
    split: bool = False


def _ends(
    first: VariableAssignment, label: str, grid: tuple[float, float, float], faults: list[Fault]
) -> _Ends | None:
    """Return the number of points and the end of a table, from MIN, MAX and STEP; None, with a
    fault at the assignment ``first``, if these are invalid.
    """
    step, low, high = grid
    if step <= 0.0 or high < low:
        faults.append(
            first.fault(
                f"grid of the {label}",
                expected="STEP > 0 and MAX >= MIN",
                found=f"STEP {step:g}, MIN {low:g}, MAX {high:g}",
            )
        )
        return None
    steps = (high - low) / step
    if step < _LEAST_STEP or not steps < 1e6:
        faults.append(
            first.fault(
                f"STEP of the {label} is too small",
                expected=f"{_LEAST_STEP:g} or more",
                found=f"{step!r}",
            )
        )
        return None
    off = abs(steps - round(steps))
    if off <= _MEANT_STEPS:
        return _Ends(round(steps) + 1, high, meant=off > _WHOLE_STEPS)
    whole = math.floor(steps)
    return _Ends(whole + 1, low + whole * step, split=True)


def _split(
    first: VariableAssignment, label: str, prefix: str, grid: tuple[float, float, float]
) -> Fault:
    """Return the fault, at the assignment ``first``, of a table whose end MAX is between two points
    with different values.
    """
    step, low, high = grid
    return first.fault(
        f"(MAX - MIN) / STEP of the {label} is not a whole number of steps, and its last point"
        f" below MAX and the first one beyond differ (${prefix}_STEP)",
        found=f"({high!r} - {low!r}) / {step!r} = {(high - low) / step!r}",
    )


def _column(
    first: VariableAssignment,
    label: str,
    values: dict[int, float],
    ends: _Ends,
    faults: list[Fault],
) -> FloatArray | None:
    """Return the values (count,) of points 0 to count-1, where ``ends`` states the count; None,
    with a fault at the assignment ``first``, if one is missing.

    ``values``: value by point number. Values of points above MAX are ignored (FB2 09/2009,
    6FC5397-1BP20-0BA0, p. 362 and p. 370).
    """
    count = ends.count
    # one of the first len(values) + 5 points is absent, or none: the grid may be far larger than
    # the file
    absent = [point for point in range(min(count, len(values) + 6)) if point not in values]
    if absent:
        faults.append(
            first.fault(
                f"{label} has missing points (a file cut short?)",
                expected=f"points 0 to {count - 1}",
                found="no point "
                + ", ".join(map(str, absent[:5]))
                + (" ..." if len(absent) > 5 else ""),
            )
        )
        return None
    return np.array([values[point] for point in range(count)], dtype=np.float64)


def _values(entries: Sequence[VariableAssignment], faults: list[Fault]) -> dict[int, float]:
    """Return the value of each point; a repeated point must have the same value."""
    points: dict[int, list[VariableAssignment]] = defaultdict(list)
    for entry in entries:
        if entry.point is not None:
            points[entry.point].append(entry)
    for same in points.values():
        _agree(same, faults)
    return {point: same[0].value for point, same in points.items()}


def _agree(same: Sequence[VariableAssignment], faults: list[Fault]) -> None:
    faults += [
        entry.fault(
            f"{entry.variable} contradicts {same[0].file}, line {same[0].line}",
            expected=same[0].names or f"{same[0].value:g}",
            found=entry.names or f"{entry.value:g}",
        )
        for entry in same[1:]
        if entry.comparable != same[0].comparable
    ]
