"""The readings of a test minus their means, reduced to their information about traverse shifts.

A cell is a target approached in one direction. Its mean contains the error of the axis and has a
flat prior. Thus nothing here depends on the error curve. The differences between the readings of a
cell remain (Harville, "Bayesian inference for variance components using only error contrasts",
Biometrika 61, 1974). They depend linearly on offset and tilt of every traverse.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import FloatArray
from compwright.records.positioning import PositioningTest

#: Directions of the traverses that the readings say nothing of: eigenvalues below this share of
#: the largest are rounding.
_RANK: float = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class CellReadings:
    """The readings of a test as an array ``values`` (c, n): a row per target and direction, a
    column per run; mm or deg.

    The first half of the c = 2 * m rows is for the direction +, the other half for -. ``there`` (c,
    n): which readings exist; other values are 0. ``u`` (c,): position, from -1 at the first to 1 at
    the last target. ``centre``, ``half``: middle and half length of the range of the targets, mm or
    deg.
    """

    values: FloatArray
    there: NDArray[np.bool_]
    u: FloatArray
    centre: float
    half: float

    @property
    def runs(self) -> int:
        """The number of runs per direction."""
        return int(self.values.shape[1])

    @property
    def dof(self) -> int:
        """The degrees of freedom: the number of readings minus one for each target and direction
        (JCGM 100:2008, 4.2.4).
        """
        return int(np.sum(self.there) - np.count_nonzero(np.any(self.there, axis=1)))

    @property
    def farthest(self) -> float:
        """The largest distance of a reading from the median at its target and direction."""
        values = np.where(self.there, self.values, np.nan)[np.any(self.there, axis=1)]
        middle = np.nanmedian(values, axis=1, keepdims=True)
        return float(np.nanmax(np.abs(values - middle), initial=0.0))

    @property
    def powers(self) -> FloatArray:
        """The shapes (2, c) of offset and tilt of a traverse: 1 and the position u (-1 to 1)."""
        return np.stack([np.ones_like(self.u), self.u])


@dataclass(frozen=True, slots=True, kw_only=True)
class ReducedReadings:
    """The information that the readings contain about the k shifts of the traverses, computed for a
    reading variance of 1.

    ``root`` (k, r): root of the information matrix, which is root @ root.T. ``scores`` (r,): root.T
    @ shifts + noise of variance 1. ``rest``: sum of squares that no shift explains. ``means``,
    ``weights`` (c,): weighted mean and total weight for each target and direction. ``shares`` (c,
    k): change of this mean per unit of each shift.
    """

    root: FloatArray
    scores: FloatArray
    rest: float
    means: FloatArray
    weights: FloatArray
    shares: FloatArray


def cell_readings(test: PositioningTest) -> CellReadings:
    """Return the readings of ``test`` as an array by target, direction and run."""
    m = test.targets.size
    runs = max(test.positive.shape[1], test.negative.shape[1])
    values = np.full((2 * m, runs), np.nan)
    values[:m, : test.positive.shape[1]] = test.positive
    values[m:, : test.negative.shape[1]] = test.negative
    there = np.isfinite(values)
    low, high = float(np.min(test.targets)), float(np.max(test.targets))
    centre, half = 0.5 * (low + high), max(0.5 * (high - low), 1e-300)
    return CellReadings(
        values=np.where(there, values, 0.0),
        there=there,
        u=np.tile((test.targets - centre) / half, 2),
        centre=centre,
        half=half,
    )


def traverse_effects(readings: CellReadings, effects: FloatArray) -> FloatArray:
    """Return the change of the readings (c, n) by offset and tilt ``effects`` (4 n,) of the
    traverses.
    """
    parts = effects.reshape(2, 2, readings.runs)
    m = readings.u.size // 2
    u = readings.u[:m, np.newaxis]
    return np.concatenate([offset + u * tilt for offset, tilt in parts])


def reduce_readings(
    readings: CellReadings, values: FloatArray, weights: FloatArray
) -> ReducedReadings:
    """Return the Fisher information of the readings ``values`` (c, n) with ``weights`` (c, n) about
    the offset and tilt of each traverse.

    The mean of each target and direction is also unknown, and is eliminated (Harville 1974; normal
    equations by blocks: Björck, Numerical Methods for Least Squares Problems, 1996, section 6.3).
    """
    n, m = readings.runs, readings.u.size // 2
    total = weights.sum(axis=1)
    inverse = np.where(total > 0.0, 1.0 / np.maximum(total, 1e-300), 0.0)
    means = inverse * np.sum(weights * values, axis=1)
    left = weights * (values - means[:, np.newaxis])
    powers = readings.powers
    information = np.zeros((4 * n, 4 * n))
    moment = np.empty((2, 2, n))
    shares = np.zeros((2 * m, 4 * n))
    for way, rows in enumerate((slice(0, m), slice(m, 2 * m))):
        share = weights[rows] * inverse[rows, np.newaxis]
        for a in range(2):
            own = slice((2 * way + a) * n, (2 * way + a + 1) * n)
            shares[rows, own] = powers[a, rows, np.newaxis] * share
            moment[way, a] = powers[a, rows] @ left[rows]
            for b in range(2):
                shape = (powers[a, rows] * powers[b, rows])[:, np.newaxis]
                block = -(shape * share).T @ weights[rows]
                block[np.arange(n), np.arange(n)] += np.sum(shape * weights[rows], axis=0)
                other = slice((2 * way + b) * n, (2 * way + b + 1) * n)
                information[own, other] = block
    size, axes = np.linalg.eigh(information)
    kept = size > _RANK * max(float(size[-1]), 1e-300)
    length = np.sqrt(size[kept])
    scores = (axes[:, kept].T @ moment.ravel()) / length
    squares = float(np.sum(left * (values - means[:, np.newaxis])))
    return ReducedReadings(
        root=axes[:, kept] * length,
        scores=scores,
        rest=max(squares - float(scores @ scores), 0.0),
        means=means,
        weights=total,
        shares=shares,
    )


def without_traverse_lines(readings: CellReadings, residuals: FloatArray) -> FloatArray:
    """Return ``residuals`` (c, n) less the straight line of each traverse (least squares); 0 where
    there is no reading.
    """
    m = readings.u.size // 2
    left = np.zeros(residuals.shape)
    for rows in (slice(0, m), slice(m, 2 * m)):
        for run in range(readings.runs):
            there = readings.there[rows, run]
            if np.count_nonzero(there) < 3:
                continue
            columns = np.column_stack([np.ones(there.sum()), readings.u[rows][there]])
            values = residuals[rows, run][there]
            line = np.linalg.lstsq(columns, values, rcond=None)[0]
            left[rows, run][there] = values - columns @ line
    return left
