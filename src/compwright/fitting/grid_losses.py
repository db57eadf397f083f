"""The interpolation error of table points, and whether the control's increments are large enough.

The error is computed from the wanted correction, not estimated. It grows with the square of the
spacing times the curvature (de Boor, A Practical Guide to Splines, 1978, chapter III).
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.fitting.problem import BOTH, rows_at
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import Interpolation
from compwright.records.estimate import WantedCorrection

#: The grid may lose this share of the noise of a reading (rms), or one quantum.
NOISE_SHARE: Final = 0.1


def good_enough(points: FloatArray, wanted: WantedCorrection, capacity: Capacity) -> bool:
    """Return whether table points are close enough: the interpolation error is at most the
    control's resolution or a share of the noise, and the control's increments can follow the
    correction.

    The error is rms, and the share is `NOISE_SHARE`. If the control interpolates in steps, the
    resolution is divided by sqrt(12). The increments are those at the smallest magnification.
    """
    # Steps are cheap to make finer, and their loss is a range as wide as a step: no more than
    # rounding costs anyway.
    resolution = (
        capacity.quantum / np.sqrt(12.0) if capacity.interpolation == "step" else capacity.quantum
    )
    tolerance = max(resolution, NOISE_SHARE * wanted.noise)
    return grid_loss(points, wanted, capacity.interpolation) <= tolerance and _climbs(
        points, wanted, capacity
    )


def _climbs(points: FloatArray, wanted: WantedCorrection, capacity: Capacity) -> bool:
    """Return whether the control's increments at the smallest magnification can follow the wanted
    correction.
    """
    lattice = capacity.lattice
    return (
        lattice is None
        or magnification_needed(points, wanted, lattice) <= lattice.magnifications[0]
    )


def magnification_needed(points: FloatArray, wanted: WantedCorrection, lattice: Lattice) -> float:
    """Return the smallest magnification (a real number) at which the increments are large enough
    for each change of the wanted correction between neighbouring table points.
    """
    least, largest = (limit * lattice.unit for limit in lattice.increments)
    steps = np.concatenate(
        [
            np.diff(np.interp(points, wanted.positions, wanted.total(direction)))
            for direction in BOTH
        ]
    )
    up, down = float(np.max(steps, initial=0.0)), float(np.min(steps, initial=0.0))
    nothing_up, nothing_down = (np.inf if up > 0.0 else 0.0), (np.inf if down < 0.0 else 0.0)
    return max(
        up / largest if largest > 0.0 else nothing_up, down / least if least < 0.0 else nothing_down
    )


def grid_loss(points: FloatArray, wanted: WantedCorrection, interpolation: Interpolation) -> float:
    """Return the rms interpolation error between table points over both directions, mm or deg.

    The error is the wanted correction minus its interpolation between the points (de Boor 1978,
    chapter III).
    """
    where = wanted.positions
    rows = rows_at(where, points, below="hold", above="hold", interpolation=interpolation)
    square = []
    for curve in (wanted.total(direction) for direction in BOTH):
        values = np.interp(points, where, curve)
        held = rows.lower * values[rows.left] + rows.upper * values[rows.left + 1]
        square.append(np.mean((held - curve) ** 2))
    return float(np.sqrt(np.mean(square)))
