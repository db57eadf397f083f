"""Smooth error curves over the travel: random from a seed, or through given points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Protocol

import numpy as np

from compwright.records.axis import FloatArray

_WAVES: Final = 64  # enough cosines for their sum to look like a Gaussian process
_GRID: Final = 2001  # points over the travel on which the amplitude is set


class DeviationCurve(Protocol):
    """A function that gives the deviation at a position, mm or deg."""

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the deviation, mm or deg, at each of the ``positions`` (any shape)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RandomCurve:
    """A random smooth error curve of a given amplitude and length of its waves. The same ``seed``,
    amplitude, length and travel always give the same curve.

    It is a sum of cosines with normally distributed wave numbers of standard deviation
    1/``length``. Values up to about ``length`` (mm or deg) apart are similar; values farther apart
    are not. Over ``travel`` its minimum is -``amplitude`` and its maximum +``amplitude`` (mm or
    deg).
    """

    amplitude: float
    length: float
    seed: tuple[int, ...]
    travel: tuple[float, float]

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the deviation, mm or deg, at each of the ``positions`` (any shape)."""
        where = np.asarray(positions, dtype=np.float64)
        if self.amplitude == 0.0:
            return np.zeros(where.shape)
        over_travel = self._waves(np.linspace(*self.travel, _GRID))
        low, high = float(over_travel.min()), float(over_travel.max())
        scaled: FloatArray = (self._waves(where) - 0.5 * (low + high)) * (
            2.0 * self.amplitude / (high - low)
        )
        return scaled

    def _waves(self, positions: FloatArray) -> FloatArray:
        rng = np.random.default_rng(self.seed)
        wave_numbers = rng.standard_normal(_WAVES) / self.length
        phases = rng.uniform(0.0, 2.0 * np.pi, _WAVES)
        total: FloatArray = np.cos(
            (positions[..., None] - self.travel[0]) * wave_numbers + phases
        ).sum(axis=-1)
        return total


@dataclass(frozen=True, slots=True)
class PointCurve:
    """An error curve of straight lines through ``values`` at ascending ``positions`` (mm or deg),
    constant beyond its ends.
    """

    positions: tuple[float, ...]
    values: tuple[float, ...]

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the deviation, mm or deg, at each of the ``positions`` (any shape)."""
        through: FloatArray = np.interp(positions, self.positions, self.values)
        return through


#: No error at all.
FLAT: Final = PointCurve((0.0,), (0.0,))
