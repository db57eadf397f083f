"""Fit the table of an endless axis to the control's modulo range, and check that the turns agree.

The table covers one turn and starts where the modulo range begins.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from compwright.formats.families.grid.axis_values import GridAxisValues
from compwright.formats.families.grid.tables import GridTable
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE, Notes
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import AxisCompensation

#: The quantity by which a control says where its modulo range begins.
RANGE_QUANTITY = "modulo_start"
#: A point counts as lying on the beginning of the range when it misses it by less than this part of
#: a spacing.
_SAME_POINT = 1e-6
#: Rows beyond whole sections: the first one, and one that begins beyond each end of the travel.
_EXTRA_ROWS = 2
#: Fewer sections show nothing of a turn.
_LEAST_SECTIONS = 3
#: Places of points that were repeated are rounded to this, deg.
_DECIMALS = 9


def in_modulo_range(
    compensation: AxisCompensation, start: float, name: str, faults: list[Fault]
) -> AxisCompensation:
    """Return a repeating table with its points reordered so that it begins at ``start`` (deg); each
    angle keeps its correction. ``name``: the axis in messages; ``faults``: the list that gets a
    fault.

    The table must begin there, because it is not known whether the control applies a table with
    another start. If no point is at ``start``, a fault is added that names a possible spacing.
    """
    period, positions = compensation.period, compensation.positions
    if period is None or positions.size < 2:
        return compensation
    step = float(positions[-1] - positions[0]) / (positions.size - 1)
    ahead = float(np.mod(start - positions[0], period)) / step
    shift = round(ahead)
    if abs(ahead - shift) > _SAME_POINT:
        common = _common(period, float(np.mod(positions[0] - start, period)))
        faults.append(
            Fault(
                message=(
                    f"axis {name}: the table must have a point at {start:g} deg, where the "
                    "control's modulo range begins (MD30340), but its points are counted from "
                    f"the reference position, {positions[0]:g} deg"
                ),
                expected=f"a `spacing` that divides {common:g} deg",
                found=f"{step:g} deg",
                hint=f"set a `table: {{spacing: ...}}` that divides {common:g} deg",
            )
        )
        return compensation
    if shift % (positions.size - 1) == 0 and abs(float(positions[0]) - start) <= _SAME_POINT * step:
        return compensation
    points = start + step * np.arange(positions.size)
    return replace(
        compensation,
        positions=np.asarray(np.round(points, 9), dtype=np.float64),
        positive=_rolled(compensation.positive, shift),
        negative=_rolled(compensation.negative, shift),
    )


def _rolled(curve: FloatArray, shift: int) -> FloatArray:
    turn = np.roll(curve[:-1], -shift)
    return np.append(turn, turn[0])


def _common(period: float, offset: float) -> float:
    """Return the greatest common divisor of two angles, deg."""
    one, other = (Fraction(round(value * 1e6), 10**6) for value in (period, offset))
    while other:
        one, other = other, one % other
    return float(one)


def over_travel(compensation: AxisCompensation, axis: Axis) -> AxisCompensation:
    """Repeat the table of one turn over the whole travel, for an axis whose positions count on from
    turn to turn.
    """
    turn, positions = compensation.period, compensation.positions
    if not axis.counts_turns or turn is None or positions.size < 2:
        return compensation
    low, high = axis.travel
    first = int(np.floor((low - positions[0]) / turn))
    last = int(np.ceil((high - positions[0]) / turn))
    where = np.concatenate(
        [
            *(positions[:-1] + turn * count for count in range(first, last)),
            [positions[0] + turn * last],
        ]
    )
    start = int(np.searchsorted(where, low, side="right")) - 1
    end = int(np.searchsorted(where, high, side="left"))
    places = np.arange(max(start, 0), min(end, where.size - 1) + 1)
    index = places % (positions.size - 1)
    return replace(
        compensation,
        positions=np.round(where[places], _DECIMALS),
        positive=compensation.positive[index],
        negative=compensation.negative[index],
        period=None,
    )


def most_points_of_turn(axis: Axis, rows: int) -> int:
    """Return how many points one turn can have if one table of at most ``rows`` points has to
    contain all turns of the travel.

    The points at both ends of the turn are counted. Raises CapacityError if a turn would have fewer
    than three sections.
    """
    low, high = axis.travel
    sections = int((rows - _EXTRA_ROWS) * float(axis.modulo or 0.0) / (high - low))
    if sections < _LEAST_SECTIONS:
        raise CapacityError(
            Fault(
                message=(
                    f"axis {axis.name}: the control's table of {rows} rows leaves fewer than"
                    f" {_LEAST_SECTIONS} sections per turn"
                ),
                expected=(
                    f"a travel of at most {(rows - _EXTRA_ROWS) * 360 // _LEAST_SECTIONS:g} deg"
                ),
                found=f"{low:g} to {high:g} deg",
                hint="shorten `travel` of the axis in the job",
            )
        )
    return sections + 1


def spacings_from(
    reference: float, start: float, period: float, quantum: float
) -> tuple[float, ...] | None:
    """Return the spacings (deg) of tables that have one point at the ``reference`` and one at the
    ``start`` of the modulo range; None if every spacing that divides the turn is possible.
    ``quantum``: the smallest step of a position.
    """
    offset = float(np.mod(reference - start, period))
    if min(offset, period - offset) <= quantum / 2:
        return None
    count = round(_common(period, offset) / quantum)
    small = [one for one in range(1, int(np.sqrt(count)) + 1) if count % one == 0]
    return tuple(one * quantum for one in sorted({*small, *(count // one for one in small)}))


def check_modulo(values: GridAxisValues, axis: Axis | None) -> None:
    """Check that job and control agree on whether the axis is endless, and on its modulo range."""
    found = values.single("modulo", quiet=False)
    if found is None:
        return
    word = values.stated_word("modulo")
    if axis is None:
        return
    if word == "yes" and axis.kind is AxisKind.ROTARY:
        _check_range(values, axis, found)
    if word == "no" and axis.modulo is not None:
        values.notes.faults.append(
            Fault(
                message=(
                    f"{values.label}: the job makes the axis endless, but the control's files "
                    "give it ends"
                ),
                file=found.occurrence.file,
                place=found.occurrence.place,
                expected=f"modulo {axis.modulo:g}",
                found=found.text,
                hint=(
                    "remove `modulo` of the axis from the job, or give the files of this machine"
                ),
            )
        )


def _check_range(values: GridAxisValues, axis: Axis, found: FoundValue) -> None:
    """Check that the modulo range of the axis is the same in the job and in the control. ``found``:
    the line in the files that makes the axis endless.

    An axis with ends in the job is a fault too: its table would leave out the rest of the turn.
    """
    length = values.single("modulo_range")
    turn = float(length.text) if length is not None else None
    if axis.modulo is None:
        values.notes.refuse(
            values.label,
            "the axis is endless in the control's files (MD30310), but has ends in the job",
            found,
            expected=f"`modulo: {turn or 360.0:g}` in the job",
            found="no key `modulo`",
            hint=f"set `modulo: {turn or 360.0:g}` for the axis in the job",
        )
    elif turn is not None and abs(turn - axis.modulo) > SAME_TURN:
        message = "the modulo of the job is not the modulo range of the control (MD30330)"
        expected, shown = f"modulo: {turn:g}", f"{axis.modulo:g}"
        values.notes.refuse(
            values.label,
            message,
            length,
            expected=expected,
            found=shown,
            hint=f"set `modulo: {turn:g}` for the axis in the job",
        )


def period_of(
    values: GridAxisValues, axis: Axis | None, rows: Sequence[FoundValue], table: GridTable
) -> float:
    """Return the period of a repeating table, checking that its first and last values are equal.
    ``rows``: the lines of the table in the files.
    """
    if table.positive[0] != table.positive[-1] or table.negative[0] != table.negative[-1]:
        first, last = rows[0].occurrence, rows[-1].occurrence
        values.notes.faults.append(
            Fault(
                message=(
                    f"{values.label}: the table repeats, but its two ends differ: the axis would"
                    " jump once a turn"
                ),
                file=first.file,
                place=f"{first.place} to {last.line}",
                expected="the same value at both ends",
                found=f"{table.positive[0]:g} and {table.positive[-1]:g} (corrections)",
                hint=(
                    "correct the table in the control so that both ends are equal, measure "
                    "again, and export it again"
                ),
            )
        )
    if axis is not None and "modulo_start" in values.definition.bindings:
        _check_beginning(values, table)
    return float(table.positions[-1] - table.positions[0])


def _check_beginning(values: GridAxisValues, table: GridTable) -> None:
    """Check that a repeating table begins where the control's modulo range begins."""
    found = values.single("modulo_start")
    start = float(found.text) if found is not None else 0.0
    if abs(float(table.positions[0]) - start) > SAME_TURN:
        values.notes.refuse(
            values.label,
            "its table repeats and does not begin where the modulo range of the control begins"
            " (MD30340): it is unknown whether the control uses the part of the table before"
            " this position",
            values.single("table_start"),
            expected=(
                f"MIN = {start:g}"
                if found is not None
                else "MIN = 0, or the file that contains MD30340"
            ),
            hint=CORRECT_VALUE if found is not None else ADD_FILE,
        )


def check_turn(axis: Axis, compensation: AxisCompensation, notes: Notes) -> None:
    """Check that the axis of the job and its tables in the files have the same turn."""
    for table in (compensation, *compensation.others):
        if table.positions.size == 0:
            continue
        label = f"axis {table.address}"
        if axis.modulo is None and table.period is not None:
            notes.find("CW-S033.repeats", "warning", label, label=label, period=table.period)
        elif axis.modulo is not None and table.period is None and not axis.counts_turns:
            notes.find("CW-S033.ends", "warning", label, label=label)
        elif (
            axis.modulo is not None
            and table.period is not None
            and abs(table.period - axis.modulo) > SAME_TURN
        ):
            notes.faults.append(
                Fault(
                    message=f"{label}: the period of its table is not the modulo of the job",
                    expected=f"{axis.modulo:g}",
                    found=f"{table.period:g}",
                    hint=(
                        f"set `modulo: {table.period:g}` for the axis in the job, or give "
                        "the files "
                        "of this machine"
                    ),
                )
            )
