"""Scatter that differs between the two directions or along the travel."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.estimation.noise_readings import CellReadings
from compwright.records.axis import FloatArray
from compwright.records.noise import waves

#: Half waves along the travel: the shortest place that can stand out is a sixth of it.
_WAVES: Final = 6
#: Prior probability that the scatter does not depend on the direction, on each of the waves; else
#: its logarithm changes by as much as an exponential prior of this mean says, either way.
_NOTHING: Final = np.array([0.9, 0.92, 0.93, 0.95, 0.96, 0.97, 0.97])
_USUAL: Final = 0.5
_GRID: Final = 0.15 * np.arange(-13, 14)
_THERE: Final = _GRID != 0.0
_ZERO: Final = int(np.argmin(_THERE))


def spread_shapes(readings: CellReadings) -> FloatArray:
    """Return the patterns (parts, c) by which log scatter can vary: between directions, or in waves
    along the travel.
    """
    m = readings.u.size // 2
    return np.vstack([np.repeat([0.5, -0.5], m), waves(readings.u, _WAVES)])


def precision_powers(shapes: FloatArray) -> FloatArray:
    """Return the factors (parts, values, c) by which each pattern of scatter, at each tried size,
    multiplies the precision of the readings.
    """
    powers: FloatArray = np.exp(-2.0 * _GRID[:, np.newaxis] * shapes[:, np.newaxis])
    return powers


def draw_spread(
    spread: FloatArray,
    shapes: FloatArray,
    powers: FloatArray,
    squares: FloatArray,
    dof: FloatArray,
    rng: np.random.Generator,
) -> FloatArray:
    """Draw the sizes ``spread`` (parts,) of the patterns of scatter in place, and return the
    probability (parts,) that each size is zero.

    Each size is drawn given the others. ``squares`` (c,): sums of squares of the readings about the
    mean of each target and direction, with ``dof`` (c,) degrees of freedom. ``shapes``: the
    patterns. ``powers``: `precision_powers` of the ``shapes``. The common scale is integrated out
    under its prior 1/sigma (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section 3.2). The
    draws are exact conditional draws from a grid (Ritter and Tanner, J. Am. Stat. Assoc. 87, 1992).
    """
    absent = np.ones(spread.size)
    total = float(np.sum(dof))
    moved = shapes @ dof
    steps = rng.uniform(-0.5, 0.5, spread.size) * (_GRID[1] - _GRID[0])
    chance = rng.random(spread.size)
    values = np.where(_THERE, _GRID + steps[:, np.newaxis], 0.0)
    prior = np.exp(-np.abs(values) / _USUAL) * _THERE
    prior *= ((1.0 - _NOTHING) / prior.sum(axis=1))[:, np.newaxis]
    prior[:, _ZERO] = _NOTHING
    logs_of_scale = spread @ shapes
    for part in np.flatnonzero(np.ptp(shapes[:, dof > 0.0], axis=1) > 0.0):
        others = logs_of_scale - spread[part] * shapes[part]
        known = squares * np.exp(-2.0 * others)
        scaled = powers[part] @ (known * np.exp(-2.0 * steps[part] * shapes[part]))
        scaled[_ZERO] = known.sum()
        logs = -0.5 * total * np.log(scaled) - moved[part] * values[part]
        chances = np.exp(logs - logs.max()) * prior[part]
        cumulative = chances.cumsum()
        drawn = int(cumulative.searchsorted(chance[part] * cumulative[-1]))
        spread[part] = values[part, min(drawn, _GRID.size - 1)]
        absent[part] = chances[_ZERO] / cumulative[-1]
        logs_of_scale = others + spread[part] * shapes[part]
    return absent
