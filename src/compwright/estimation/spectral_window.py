"""Waves with the same values at all targets, which readings cannot distinguish (spectral window:
Deeming, Astrophysics and Space Science 36, 1975).
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import ALIASED
from compwright.records.axis import FloatArray

#: Points of the table per 1 / length.
_POINTS: Final = 8
_BLOCK: Final = 64


def wave_similarity(targets: FloatArray, frequencies: FloatArray, other: float) -> FloatArray:
    """Return how similar waves of the ``frequencies`` (f,) are to a wave of frequency ``other`` at
    the ``targets`` (m,), from 0 to 1 (equal).
    """
    at = 2.0 * np.pi * (targets - targets[0])
    sizes = []
    for sign in (1.0, -1.0):
        angle = np.outer(frequencies - sign * other, at)
        sizes.append(np.hypot(np.cos(angle).mean(axis=1), np.sin(angle).mean(axis=1)))
    return np.asarray(np.maximum(*sizes))


class SpectralWindow:
    """The similarity of waves at the ``targets`` (m,), mm or deg, as a table over the difference of
    their frequencies.
    """

    def __init__(self, targets: FloatArray, highest: float) -> None:
        self.step = 1.0 / (_POINTS * float(np.ptp(targets)))
        blocks = int(np.ceil(highest / self.step / _BLOCK)) + 1
        at = 2j * np.pi * self.step * (targets - targets[0])
        first = np.exp(np.outer(np.arange(_BLOCK), at))
        jumps = np.exp(np.outer(_BLOCK * np.arange(blocks), at))
        self.sizes: FloatArray = np.abs(jumps @ first.T).ravel() / targets.size
        self.places: FloatArray = self.step * np.arange(self.sizes.size)
        self.peaks = self.places[self.sizes >= ALIASED]

    def at(self, differences: FloatArray) -> FloatArray:
        """Return the similarity of two waves for each of the ``differences`` in frequency."""
        return np.asarray(np.interp(np.abs(differences), self.places, self.sizes))

    def alike(self, frequencies: FloatArray, other: float) -> FloatArray:
        """Return `wave_similarity` from the table, to about 1 %."""
        return np.asarray(np.maximum(self.at(frequencies - other), self.at(frequencies + other)))

    def slow(self, frequencies: FloatArray, lowest: float) -> NDArray[np.bool_]:
        """Return a mask of the ``frequencies``: True for a frequency that appears at the targets as
        a wave with a frequency far below ``lowest``.
        """
        right = np.searchsorted(self.peaks, frequencies).clip(0, self.peaks.size - 1)
        left = (right - 1).clip(0)
        away = np.minimum(
            np.abs(self.peaks[right] - frequencies), np.abs(self.peaks[left] - frequencies)
        )
        return np.asarray(away < lowest - 0.5 * _POINTS * self.step)
