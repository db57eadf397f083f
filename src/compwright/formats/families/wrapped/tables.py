"""Convert a correction to the table entries of one motor.

The motor has a table for both directions, and a backlash that is subtracted from it towards
decreasing counts.

Entry i is at i * length / (number of entries) from motor zero, and the table repeats after its
length. The length is more than the whole travel, so no entry is used at two places of the axis.
Between the end of the travel and its beginning one length further there is an unused gap. For
`HELD` spacings beyond each end of the travel, the table keeps the value at that end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.families.wrapped.counts import Counts
from compwright.formats.text.scale import EXACTNESS, NotHeld
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.stored_table import StoredTable

#: Spacings beyond the travel for which the end values are held: an axis that runs a little further
#: than its job states meets no jump.
HELD = 3


@dataclass(frozen=True, slots=True)
class MotorTable:
    """The table and backlash entries of a motor, as whole numbers of 1/16 encoder count.

    ``length``: in counts. ``lost``: the entries of the backlash table, which are added to the
    backlash ``constant``. ``gap``: the axis positions, mm or deg, at which the table ends and at
    which its repetition begins; None for an endless axis.
    """

    motor: int
    length: int
    entries: tuple[int, ...]
    lost: tuple[int, ...]
    constant: int
    gap: tuple[float, float] | None

    @property
    def varies(self) -> bool:
        """Whether the backlash depends on the position."""
        return any(self.lost)

    @property
    def takes_up(self) -> bool:
        """Whether the motor has backlash compensation."""
        return self.varies or self.constant != 0


@dataclass(frozen=True, slots=True)
class _Points:
    """The points of a table, numbered from the reference.

    ``first``, ``last``: the numbers of the first and last point of the correction. ``low``,
    ``high``: those of the whole table. ``step``: the distance of two points, mm or deg.
    """

    step: float
    first: int
    last: int
    low: int
    high: int


def over_travel(ring: Sequence[float], axis: Axis) -> tuple[float, ...]:
    """Return the points of a repeating table that are needed for an axis' travel and its reference
    position.

    ``ring``: the points of one period, with both ends, from below the travel. If one period is too
    short for the travel, all of them are returned.
    """
    if len(ring) < 2:
        return ()
    step = (ring[-1] - ring[0]) / (len(ring) - 1)
    low, high = min(axis.travel[0], axis.reference), max(axis.travel[1], axis.reference)
    first = int(np.floor((low - ring[0]) / step + EXACTNESS))
    last = int(np.ceil((high - ring[0]) / step - EXACTNESS))
    if last - first > len(ring) - 2:
        return tuple(ring)
    return tuple(ring[0] + number * step for number in range(first, last + 1))


def motor_table(
    axis: Axis,
    compensation: AxisCompensation,
    counts: Counts,
    faults: list[Fault],
    *,
    ring: Sequence[float] = (),
) -> MotorTable | None:
    """Return the table entries that correct an axis; None, with reasons in ``faults``, if
    impossible. ``ring``: the points of one period of the existing table, with both ends (empty: no
    table).

    If the existing table has the same spacing and is long enough, the new one has its length and
    its number of entries.
    """
    label = f"axis {axis.name} ({compensation.address})"
    points, wrong = _points(axis, compensation, label, ring)
    if points is None:
        faults.extend(wrong)
        return None
    length = points.step * (points.high - points.low + 1) * abs(counts.per_unit)
    if abs(length - round(length)) > EXACTNESS:
        faults.append(
            Fault(
                message=f"{label}: the length of the table is not a whole number of counts",
                expected=f"a spacing that is a multiple of {counts.count:.9g} {axis.kind.unit}",
                found=f"{points.step:.10g} {axis.kind.unit}, {length:.6f} counts",
                hint="set `table: {spacing: ...}` to such a multiple",
            )
        )
        return None
    try:
        entries, lost, constant = _numbers(compensation, points, counts, label)
    except NotHeld as error:
        faults.append(
            Fault(
                message=f"the table cannot be written: {error}",
                hint="correct `table` of this axis in the job",
            )
        )
        return None
    ends = (axis.reference + points.high * points.step, axis.reference + points.low * points.step)
    gap = None if compensation.period is not None else ends
    return MotorTable(int(compensation.address), round(length), entries, lost, constant, gap)


def stored_entries(
    axis: Axis, compensation: AxisCompensation, counts: Counts, *, ring: Sequence[float] = ()
) -> StoredTable:
    """Return the table of an axis over one period from motor zero, with its entries as rows.
    ``ring``: as for `motor_table`.
    """
    points = None
    if compensation.positions.size > 1:
        points, _ = _points(axis, compensation, "", ring)
    if points is None:
        return StoredTable.by_point(compensation)
    size = points.high - points.low + 1
    along = np.arange(size + 1)
    order, zero = along[1:], 0
    if counts.forward is Direction.NEGATIVE:
        order, zero = along[-2::-1], size
    positions: FloatArray = np.round(axis.reference + along * points.step, 9)
    curves = {d: np.zeros(size + 1) for d in Direction}
    for direction, curve in curves.items():
        curve[order] = _entries_of(compensation.curve(direction), points, counts)
        curve[zero] = curve[order[-1]]
    table = replace(
        compensation,
        positions=positions,
        positive=curves[Direction.POSITIVE],
        negative=curves[Direction.NEGATIVE],
        period=size * points.step,
    )
    # one entry of 1, as the correction of this axis
    unit = float(counts.added("value_positive", np.ones(1))[0])
    return StoredTable(compensation=table, order=order, zero=zero, ahead=counts.forward, unit=unit)


def _numbers(
    compensation: AxisCompensation, points: _Points, counts: Counts, label: str
) -> tuple[tuple[int, ...], tuple[int, ...], int]:
    """Return the entries of correction table and backlash table, and the constant backlash."""
    ahead, against = (
        _entries_of(compensation.curve(direction), points, counts)
        for direction in (counts.forward, counts.forward.opposite)
    )
    if abs(ahead[-1]) > EXACTNESS * counts.quantum:
        raise NotHeld(
            f"{label}: the correction at the reference, arriving in {counts.forward}, is not 0 but"
            f" {ahead[-1]:.9g} {compensation.kind.unit}; this control holds none at motor zero"
        )
    entries = counts.entries("value_positive", ahead, f"{label}: the table")
    zero = against[-1] - ahead[-1]
    constant = counts.entries("backlash", np.array([zero]), f"{label}: backlash at motor zero")
    lost = against - ahead - zero
    return (
        tuple(entries),
        tuple(counts.entries("value_negative", lost, f"{label}: the table of backlash")),
        constant[0],
    )


def _points(
    axis: Axis, compensation: AxisCompensation, label: str, ring: Sequence[float]
) -> tuple[_Points | None, list[Fault]]:
    positions, unit = compensation.positions, axis.kind.unit
    faults = _beyond_shape(compensation, label)
    steps = np.diff(positions)
    step = float(positions[-1] - positions[0]) / steps.size
    slack = EXACTNESS * step
    if np.ptp(steps) > slack:
        found = f"{np.min(steps):.10g} to {np.max(steps):.10g} {unit}"
        return None, [
            *faults,
            Fault(
                message=f"{label}: the points are not equally spaced",
                expected="equal distances between the points",
                found=found,
                hint="give `table: {spacing: ...}` for this axis",
            ),
        ]
    begin = (float(positions[0]) - axis.reference) / step
    first = round(begin)
    last = first + steps.size
    if abs(begin - first) > EXACTNESS or not first <= 0 <= last:
        expected = f"points at {axis.reference:.10g} {unit} plus whole spacings of {step:.10g}"
        found = f"from {positions[0]:.10g} to {positions[-1]:.10g} {unit}"
        return None, [
            *faults,
            Fault(
                message=f"{label}: the table must have a point at the reference position and "
                "whole spacings from there",
                expected=expected,
                found=found,
                hint="set `table: {start, end, spacing}` of this axis so that a point lies "
                "at the reference position",
            ),
        ]
    if compensation.period is not None:
        return (None if faults else _Points(step, first, last - 1, first, last - 1)), faults
    low = min(first, int(np.floor((axis.travel[0] - axis.reference) / step + EXACTNESS))) - HELD
    high = max(last, int(np.ceil((axis.travel[1] - axis.reference) / step - EXACTNESS))) + HELD
    size = len(ring) - 1
    if size > last - first and abs(ring[-1] - ring[0] - size * step) <= slack:
        # the gap is what the table that is there leaves of it, as much on either side
        low = first - (size - (last - first + 1)) // 2
        high = low + size - 1
    return (None if faults else _Points(step, first, last, low, high)), faults


def _beyond_shape(compensation: AxisCompensation, label: str) -> list[Fault]:
    """Return a fault if a compensation has a property that tables with straight lines lack, such as
    a slope or a backlash value.
    """
    more = compensation.others or compensation.slope or compensation.backlash
    if compensation.interpolation == "linear" and not more:
        return []
    return [
        Fault(
            message=f"{label}: the control has only a table for each direction, with straight "
            "lines between its points, and the planned compensation needs more",
            hint="make the plan again with `compwright run`: one table for each direction, "
            "without a line or a backlash value",
        )
    ]


def _entries_of(curve: FloatArray, points: _Points, counts: Counts) -> FloatArray:
    """Return the correction (size,), mm or deg, at the positions of the table entries 1 to size.

    The last entry is at motor zero. Beyond the ends of ``curve`` the correction at the nearer end
    is used.
    """
    size = points.high - points.low + 1
    along = np.arange(1, size + 1) * (1 if counts.forward is Direction.POSITIVE else -1)
    places = points.low + np.mod(along - points.low, size)
    held: FloatArray = curve[np.clip(places, points.first, points.last) - points.first]
    return held
