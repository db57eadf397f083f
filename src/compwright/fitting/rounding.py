"""From the optimum to what the control can hold: every value a multiple of the quantum."""

from __future__ import annotations

import numpy as np

from compwright.records.axis import FloatArray


def to_quanta(values: FloatArray, quantum: float) -> FloatArray:
    """Return the nearest whole numbers of quanta; halves go up, so that equal steps stay equal
    wherever they start.
    """
    # The tiny shift keeps a half that arithmetic left a hair below one from falling to the other
    # side than its neighbours.
    counted: FloatArray = np.floor(values / quantum + 0.5 + 1e-9)
    return counted


def round_curve(
    values: FloatArray,
    quantum: float,
    *,
    value_range: tuple[float, float],
    max_increment: float | None,
    anchor: int,
) -> FloatArray:
    """Return ``values`` (k,) on the lattice of ``quantum``, within half a quantum, range and
    increments kept.

    Totals are rounded, not increments: rounding increments one by one drifts. Limits are whole
    quanta already, so that rounding cannot break them but by arithmetic dust; that is swept out
    from the node ``anchor``, which stays.
    """
    low, high = np.ceil(value_range[0] / quantum - 1e-6), np.floor(value_range[1] / quantum + 1e-6)
    counts = np.clip(to_quanta(values, quantum), low, high)
    if max_increment is not None:
        step = np.floor(max_increment / quantum + 1e-6)
        for index in range(anchor + 1, counts.size):
            counts[index] = np.clip(
                counts[index], counts[index - 1] - step, counts[index - 1] + step
            )
        for index in range(anchor - 1, -1, -1):
            counts[index] = np.clip(
                counts[index], counts[index + 1] - step, counts[index + 1] + step
            )
    rounded: FloatArray = counts * quantum + 0.0  # + 0.0: no negative zero in a file
    return rounded
