"""Rounding of table values to whole multiples of the control's resolution.

The rounding error is at most half a resolution step, and about step / sqrt(12) rms (Bennett, Bell
System Technical Journal 27, 1948).
"""

from __future__ import annotations

import numpy as np

from compwright.records.axis import FloatArray


def to_quanta(values: FloatArray, quantum: float) -> FloatArray:
    """Return ``values`` (k,) as whole numbers of resolution steps. Halves are rounded up, so that
    equal steps stay equal.
    """
    # The tiny shift keeps a half that arithmetic left a hair below one from falling to the other
    # side than its neighbours.
    counted: FloatArray = np.floor(values / quantum + 0.5 + 1e-9)
    return counted


def round_curve(
    values: FloatArray, quantum: float, *, value_range: tuple[float, float]
) -> FloatArray:
    """Return ``values`` (k,) rounded to whole multiples of ``quantum`` within the value range.

    The values are totals. Rounding increments instead would add up the rounding errors. The limits
    are rounded inward to whole multiples of ``quantum``, so that rounding cannot violate them.
    """
    low, high = np.ceil(value_range[0] / quantum - 1e-6), np.floor(value_range[1] / quantum + 1e-6)
    counts = np.clip(to_quanta(values, quantum), low, high)
    rounded: FloatArray = counts * quantum + 0.0  # + 0.0: no negative zero in a file
    return rounded
