"""The table of an endless axis over the control's modulo range: the same turn, starting where that
range begins.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np

from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import Axis, FloatArray
from compwright.records.correction import AxisCompensation

#: The quantity by which a control says where its modulo range begins.
RANGE_QUANTITY = "modulo_start"
#: A node counts as lying on the beginning of the range when it misses it by less than this part of
#: a spacing.
_SAME_NODE = 1e-6
#: Rows beyond whole sections: the first one, and one that begins beyond each end of the travel.
_EXTRA_ROWS = 2
#: Fewer sections show nothing of a turn.
_LEAST_SECTIONS = 3
#: Places of nodes that were repeated are rounded to this, deg.
_DECIMALS = 9


def in_range_of(
    compensation: AxisCompensation, start: float, name: str, faults: list[Fault]
) -> AxisCompensation:
    """Return a table that repeats, starting at ``start`` (deg): every node keeps its place on the
    circle and its values.

    It is not known whether the control would find a table with another start. If no node is at
    ``start``, that is a fault, which names a possible spacing.
    """
    period, positions = compensation.period, compensation.positions
    if period is None or positions.size < 2:
        return compensation
    step = float(positions[-1] - positions[0]) / (positions.size - 1)
    ahead = float(np.mod(start - positions[0], period)) / step
    shift = round(ahead)
    if abs(ahead - shift) > _SAME_NODE:
        common = _common(period, float(np.mod(positions[0] - start, period)))
        faults.append(
            Fault(
                message=(
                    f"axis {name}: its table must begin at {start:g} deg, where the modulo range of"
                    " the control begins (MD30340), and no node lies there: the reference at"
                    f" {positions[0]:g} deg is one"
                ),
                expected=f"a table.spacing that divides {common:g} deg",
                found=f"{step:g} deg",
                hint=f"set a `table: {{spacing: ...}}` that divides {common:g} deg",
            )
        )
        return compensation
    if shift % (positions.size - 1) == 0 and abs(float(positions[0]) - start) <= _SAME_NODE * step:
        return compensation
    nodes = start + step * np.arange(positions.size)
    return replace(
        compensation,
        positions=np.asarray(np.round(nodes, 9), dtype=np.float64),
        positive=_rolled(compensation.positive, shift),
        negative=_rolled(compensation.negative, shift),
    )


def _rolled(curve: FloatArray, shift: int) -> FloatArray:
    turn = np.roll(curve[:-1], -shift)
    return np.append(turn, turn[0])


def _common(period: float, offset: float) -> float:
    """Return the largest common divisor of two angles, deg."""
    one, other = (Fraction(round(value * 1e6), 10**6) for value in (period, offset))
    while other:
        one, other = other, one % other
    return float(one)


def over_travel(compensation: AxisCompensation, axis: Axis) -> AxisCompensation:
    """Return the table of one turn, repeated over the travel of an axis that counts its turns."""
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
    """Return how many points one turn may have, both ends counted, so that ``rows`` cover the whole
    travel. Raises CapacityError if two points do not fit.
    """
    low, high = axis.travel
    sections = int((rows - _EXTRA_ROWS) * float(axis.modulo or 0.0) / (high - low))
    if sections < _LEAST_SECTIONS:
        raise CapacityError(
            Fault(
                message=(
                    f"axis {axis.name}: the control's table of {rows} rows leaves less than"
                    f" {_LEAST_SECTIONS} sections for each turn"
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
    """Return the spacings (deg) for which nodes lie on the reference and on the start of the range;
    None: any that divides the turn.
    """
    offset = float(np.mod(reference - start, period))
    if min(offset, period - offset) <= quantum / 2:
        return None
    count = round(_common(period, offset) / quantum)
    small = [one for one in range(1, int(np.sqrt(count)) + 1) if count % one == 0]
    return tuple(one * quantum for one in sorted({*small, *(count // one for one in small)}))
