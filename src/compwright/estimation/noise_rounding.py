"""Readings of a coarse instrument: the step between its numbers, and where the true values may
lie.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.estimation.noise_readings import Readings
from compwright.records.axis import FloatArray
from compwright.records.positioning import SAME_READING

#: A step below this part of the scatter changes nothing (variance of rounding: step² / 12).
_COARSE: Final = 0.4
#: Differences are whole steps if they are so to this part of a step.
_WHOLE: Final = 0.02
_PARTS: Final = 8


def step_of(readings: Readings, scatter: float) -> float:
    """Return the step of the readings, mm or deg, where it is coarse against their ``scatter``; 0
    where it is not, or where differences within cells are no whole steps.
    """
    there = readings.there
    first = np.argmax(there, axis=1)
    away = readings.values - readings.values[np.arange(first.size), first][:, np.newaxis]
    sizes = np.abs(away[there])
    sizes = sizes[sizes > SAME_READING]
    if not sizes.size:
        return 0.0
    step = float(np.min(sizes))
    counts = sizes / step
    whole = np.abs(counts - np.round(counts)) <= _WHOLE * np.maximum(1.0, 0.02 * counts)
    return step if step > _COARSE * scatter and bool(np.all(whole)) else 0.0


def draw_unrounded(
    readings: Readings,
    step: float,
    middle: FloatArray,
    scale: FloatArray,
    rng: np.random.Generator,
) -> FloatArray:
    """Draw the values (c, n) before rounding to ``step``: normal about ``middle`` with ``scale``
    (c, n), within half a step of what was read (Heitjan and Rubin, J. Am. Stat. Assoc. 85, 1990).
    """
    inside = (np.arange(_PARTS) + 0.5) / _PARTS - 0.5
    candidates = readings.values[:, :, np.newaxis] + step * inside
    logs = -0.5 * ((candidates - middle[:, :, np.newaxis]) / scale[:, :, np.newaxis]) ** 2
    chances = np.cumsum(np.exp(logs - np.max(logs, axis=2, keepdims=True)), axis=2)
    drawn = rng.random(readings.values.shape) * chances[:, :, -1]
    part = np.sum(chances < drawn[:, :, np.newaxis], axis=2)
    within = (np.minimum(part, _PARTS - 1) + rng.random(part.shape)) / _PARTS - 0.5
    values: FloatArray = np.where(readings.there, readings.values + step * within, 0.0)
    return values
