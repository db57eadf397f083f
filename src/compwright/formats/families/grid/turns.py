"""The table of an endless axis over the control's own modulo range: the same turn, told from where
that range begins.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np

from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation

#: The quantity by which a control says where its modulo range begins.
RANGE_QUANTITY = "modulo_start"
#: A node counts as lying on the beginning of the range when it misses it by less than this part of
#: a spacing.
_SAME_NODE = 1e-6


def in_range_of(
    compensation: AxisCompensation, start: float, name: str, faults: list[Fault]
) -> AxisCompensation:
    """Return a table that repeats, told from ``start`` (deg): every node keeps its place on the
    circle and its values.

    Whether the control would find its way into a table that lies elsewhere is not known. Where no
    node lies on ``start`` that is a fault, which names a spacing that would do.
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
    """Return the largest angle of which both are multiples, deg."""
    one, other = (Fraction(round(value * 1e6), 10**6) for value in (period, offset))
    while other:
        one, other = other, one % other
    return float(one)


def spacings_from(
    reference: float, start: float, period: float, quantum: float
) -> tuple[float, ...] | None:
    """Return the spacings (deg) with which nodes lie on the reference and on the beginning of the
    range; None: any that divides.
    """
    offset = float(np.mod(reference - start, period))
    if min(offset, period - offset) <= quantum / 2:
        return None
    count = round(_common(period, offset) / quantum)
    small = [one for one in range(1, int(np.sqrt(count)) + 1) if count % one == 0]
    return tuple(one * quantum for one in sorted({*small, *(count // one for one in small)}))
