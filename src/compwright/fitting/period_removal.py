"""Removal of known periods from the wanted correction, for table points too far apart for them.

Cosine and sine at known frequencies are fitted by least squares (Bloomfield, Fourier Analysis of
Time Series, 2nd ed. 2000, chapter 2). A piecewise straight curve is fitted at the same time (de
Boor, A Practical Guide to Splines, 1978, chapter III).
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.fitting.problem import hat_matrix
from compwright.records.axis import FloatArray
from compwright.records.estimate import WantedCorrection

_HARMONICS: Final = (1, 2)
#: Fewest points per cycle at which a harmonic can be distinguished from the curve beneath it.
_POINTS_PER_CYCLE: Final = 2.5


def without_periods(
    wanted: WantedCorrection, periods: Sequence[float]
) -> tuple[WantedCorrection, float]:
    """Return ``wanted`` without the first two harmonics of ``periods``, and the rms (mm or deg) of
    the removed part.

    The harmonics are fitted to the mean of both directions, together with a piecewise straight
    curve. The bends of this curve are further apart than the longest period. A smooth error is
    therefore not mistaken for a periodic one (Bloomfield 2000, chapter 2).
    """
    middle = 0.5 * (wanted.positive + wanted.negative)
    periodic = _periodic_part(wanted.positions.tobytes(), middle.tobytes(), tuple(periods))
    if periodic is None:
        return wanted, 0.0
    smooth = replace(
        wanted, positive=wanted.positive - periodic, negative=wanted.negative - periodic
    )
    return smooth, float(np.sqrt(np.mean(periodic**2)))


@functools.lru_cache(maxsize=4)
def _periodic_part(positions: bytes, values: bytes, periods: Sequence[float]) -> FloatArray | None:
    """Return the harmonics of ``periods`` in the ``values`` (g,) at ``positions`` (g,).

    The result is None if the positions are too far apart to show any period. Positions and values
    are given as the bytes of the arrays, so that results can be cached.
    """
    where, middle = np.frombuffer(positions), np.frombuffer(values)
    waves = _waves(where, periods)
    if not waves.shape[1]:
        return None
    span = float(where[-1] - where[0])
    pieces = int(np.clip(span / (2.0 * max(periods)), 1, 60))
    beneath = hat_matrix(
        where, np.linspace(where[0], where[-1], pieces + 1), below="hold", above="hold"
    ).dense()
    solution = np.linalg.lstsq(np.hstack([beneath, waves]), middle, rcond=None)[0]
    periodic: FloatArray = waves @ solution[beneath.shape[1] :]
    periodic.flags.writeable = False
    return periodic


def _waves(where: FloatArray, periods: Sequence[float]) -> FloatArray:
    step = float(np.max(np.diff(where)))
    columns: list[FloatArray] = []
    for period in periods:
        for harmonic in _HARMONICS:
            cycle = period / harmonic
            if cycle >= _POINTS_PER_CYCLE * step:
                angle = 2.0 * np.pi * (where - where[0]) / cycle
                columns += [np.cos(angle), np.sin(angle)]
    return np.column_stack(columns) if columns else np.empty((where.size, 0))
