"""Steps of a correction that a control never applies, because they are in a dead zone.

Such a control changes its correction in a ramp. When the ramp is at rest, a small step is applied
within one servo period, and a large step starts the ramp. A step between these two sizes
(`Axis.unapplied_steps`) does neither. The old correction then stays until the table itself has
changed so much that the difference is outside the dead zone. The control's format states the limits
of the zone.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation

#: Between the old correction and the new one, mm or deg: a table takes no two values at one place.
_EDGE = 1e-6
#: Traverses there and back until they repeat.
_CYCLES = 4
#: Places over the travel at which a reversal is looked at.
_PLACES = 501


def applied_compensation(compensation: AxisCompensation, axis: Axis) -> AxisCompensation:
    """Return the compensation that the control really applies when the axis runs over the whole
    travel and back: without the steps that are in the control's dead zone.
    """
    if axis.unapplied_steps is None or compensation.positions.size == 0:
        return compensation
    low, high = axis.travel
    own = compensation.positions
    points = np.unique(np.concatenate([[low, high], own[(own > low) & (own < high)]]))
    tables = {side: compensation.at(points, side) for side in Direction}
    up = points, tables[Direction.POSITIVE]
    for _ in range(_CYCLES):
        down = _traversed(points[::-1], tables[Direction.NEGATIVE][::-1], up[1][-1], axis)
        up = _traversed(points, tables[Direction.POSITIVE], down[1][-1], axis)
    if up[0].size == down[0].size == points.size:
        return compensation
    inside = np.unique(np.concatenate([points, up[0], down[0]]))
    beyond = own[(own < low) | (own > high)]
    where = np.sort(np.concatenate([inside, beyond]))
    curves = {
        side: np.where(
            (where < low) | (where > high),
            compensation.at(where, side),
            np.interp(where, np.sort(x), c[np.argsort(x)]),
        )
        for side, (x, c) in ((Direction.POSITIVE, up), (Direction.NEGATIVE, down))
    }
    return replace(
        compensation,
        positions=where,
        positive=curves[Direction.POSITIVE],
        negative=curves[Direction.NEGATIVE],
        backlash=0.0,
        slope=0.0,
        others=(),
    )


def unapplied_range(compensation: AxisCompensation, axis: Axis) -> tuple[float, float] | None:
    """Return the smallest and the largest correction step at a reversal (mm or deg) that the
    control leaves out because the step is in its dead zone; None if no step is left out.
    """
    if axis.unapplied_steps is None or compensation.positions.size == 0:
        return None
    least, most = axis.unapplied_steps
    where = np.concatenate([np.linspace(*axis.travel, _PLACES), compensation.positions])
    where = where[(where >= axis.travel[0]) & (where <= axis.travel[1])]
    steps = np.abs(
        compensation.at(where, Direction.POSITIVE) - compensation.at(where, Direction.NEGATIVE)
    )
    stuck = steps[(steps > least) & (steps <= most)]
    return (float(stuck.min()), float(stuck.max())) if stuck.size else None


def _traversed(
    points: FloatArray, table: FloatArray, before: float, axis: Axis
) -> tuple[FloatArray, FloatArray]:
    """Return the positions of one traverse in the order of motion, and the compensation that the
    control applies at each. ``before``: the compensation that it applied at the turn.

    If the control applies the whole table at once, the positions are the table points alone.
    """
    if axis.unapplied_steps is None:
        raise TypeError("every step is applied")
    least, most = axis.unapplied_steps
    gap = table - before
    size, sign = np.abs(gap), np.sign(gap[0])
    if not least < size[0] <= most:
        return points, table
    off = ~((least < gap * sign) & (gap * sign <= most))
    if not off.any():
        # one more place than the points tells that something stays
        middle = 0.5 * (points[0] + points[1])
        return np.insert(points, 1, middle), np.full(points.size + 1, before)
    last = int(np.argmax(off))
    limit = least if gap[last] * sign <= least else most
    part = (limit - gap[last - 1] * sign) / ((gap[last] - gap[last - 1]) * sign)
    edge = points[last - 1] + part * (points[last] - points[last - 1])
    behind = edge + np.clip(
        np.sign(points[-1] - points[0]) * _EDGE, -abs(points[last] - edge), abs(points[last] - edge)
    )
    along, values = (points, table) if points[0] < points[-1] else (points[::-1], table[::-1])
    return (
        np.concatenate([points[:last], [edge, behind], points[last:]]),
        np.concatenate(
            [
                np.full(last + 1, before),
                [float(np.interp(behind, along, values))],
                table[last:],
            ]
        ),
    )
