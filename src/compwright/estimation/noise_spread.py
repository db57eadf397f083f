"""Where readings scatter more: in one direction, towards one end of the travel, in its middle."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.estimation.noise_readings import Readings
from compwright.records.axis import FloatArray

WAY, GROWTH, BULGE = range(3)
#: Prior probability that the scatter does not depend on it; else its logarithm changes by as much
#: as an exponential prior of this mean says, either way.
_NOTHING: Final = 0.85
_USUAL: Final = 0.5
_GRID: Final = 0.08 * np.arange(-24, 25)


def shapes_of(readings: Readings) -> FloatArray:
    """Return by how much the logarithm of the scale in each cell (3, c) follows direction (half of
    +1 or -1), growth (u) and bulge (u² - 1/3).
    """
    m = readings.u.size // 2
    way = np.repeat([0.5, -0.5], m)
    return np.stack([way, readings.u, readings.u**2 - 1.0 / 3.0])


def draw_spread(
    spread: FloatArray,
    shapes: FloatArray,
    squares: FloatArray,
    dof: FloatArray,
    rng: np.random.Generator,
) -> FloatArray:
    """Draw ``spread`` (3,) anew, each part given the others, from ``squares`` (c,) of the readings
    about their cells' means with ``dof`` (c,); returns how probable each is nothing.

    The common scale is integrated out under its prior 1/sigma (Gelman et al., Bayesian Data
    Analysis, 3rd ed. 2013, section 3.2). Exact conditional draws from a grid: Ritter and Tanner, J.
    Am. Stat. Assoc. 87, 1992.
    """
    absent = np.ones(3)
    total = float(np.sum(dof))
    for part in range(3):
        moved = float(shapes[part] @ dof)
        if np.ptp(shapes[part][dof > 0.0]) == 0.0:
            continue
        step = rng.uniform(-0.5, 0.5) * (_GRID[1] - _GRID[0])
        values = np.where(_GRID == 0.0, 0.0, _GRID + step)
        prior = np.exp(-np.abs(values) / _USUAL) * (_GRID != 0.0)
        prior *= (1.0 - _NOTHING) / np.sum(prior)
        prior[_GRID == 0.0] = _NOTHING
        others = spread @ shapes - spread[part] * shapes[part]
        scaled = np.exp(-2.0 * np.outer(values, shapes[part])) @ (squares * np.exp(-2.0 * others))
        logs = -0.5 * total * np.log(scaled) - moved * values
        chances = np.exp(logs - np.max(logs)) * prior
        cumulative = np.cumsum(chances)
        drawn = int(np.searchsorted(cumulative, rng.random() * cumulative[-1]))
        spread[part] = values[min(drawn, values.size - 1)]
        absent[part] = chances[_GRID == 0.0][0] / cumulative[-1]
    return absent
