"""From the optimum to what the control can hold: every value a multiple of the quantum. The error
of rounding is at most half a quantum and about quantum / sqrt(12) rms (Bennett, Bell System
Technical Journal 27, 1948).
"""

from __future__ import annotations

import numpy as np

from compwright.records.axis import FloatArray


def to_quanta(values: FloatArray, quantum: float) -> FloatArray:
    """Return the nearest whole numbers of quanta for ``values`` (k,). Halves are rounded up, so
    that equal steps stay equal wherever they start.
    """
    # The tiny shift keeps a half that arithmetic left a hair below one from falling to the other
    # side than its neighbours.
    counted: FloatArray = np.floor(values / quantum + 0.5 + 1e-9)
    return counted


def round_curve(
    values: FloatArray, quantum: float, *, value_range: tuple[float, float]
) -> FloatArray:
    """Return ``values`` (k,) on the lattice of ``quantum``, within half a quantum, the range kept.

    Totals are rounded, not increments: rounding increments one by one drifts. Limits are whole
    quanta already, so that rounding cannot break them but by arithmetic dust.
    """
    low, high = np.ceil(value_range[0] / quantum - 1e-6), np.floor(value_range[1] / quantum + 1e-6)
    counts = np.clip(to_quanta(values, quantum), low, high)
    rounded: FloatArray = counts * quantum + 0.0  # + 0.0: no negative zero in a file
    return rounded
