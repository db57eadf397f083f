"""Propose target positions at which a test shows periodic errors."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.words.sentences import Sentence, say

#: Random part of a target, in intervals: what `run` predicts new targets with.
DITHER: Final = 0.3
_TRIES: Final = 24
_SEED: Final = 42  # the same travel and count give the same targets


def proposed_targets(low: float, high: float, count: int) -> FloatArray:
    """Return ``count`` ascending targets from ``low`` to ``high`` that show periodic errors.

    The intervals are equal, with a random part of up to 0.3 of an interval added to each target
    (ISO 230-2:2014, 4.2). Targets are rounded to a tenth of a mm or deg, or finer if the intervals
    are short. Of several random draws, the result is the one in which the two most similar waves
    differ most.
    """
    interval = (high - low) / count
    digits = max(1, int(np.ceil(2.0 - np.log10(interval))))
    rng = np.random.default_rng(_SEED)
    frequencies = np.arange(4, 10 * 4 + 1) / (4.0 * interval)
    best, least = np.zeros(0), np.inf
    for _ in range(_TRIES):
        steps = np.arange(count) + 0.5 + rng.uniform(-DITHER, DITHER, count)
        targets = np.round(low + steps * interval, digits)
        angle = 2.0 * np.pi * np.outer(frequencies, targets)
        size = float(np.max(np.hypot(np.cos(angle).mean(axis=1), np.sin(angle).mean(axis=1))))
        if round(size, 9) < least:
            best, least = targets, round(size, 9)
    return best


@lru_cache(maxsize=64)  # tests of one machine have the same targets
def targets_text(low: float, high: float, count: int, unit: str) -> Sentence:
    """Return a sentence that proposes from 12 to 30 targets (``count``, if it is in this range)."""
    targets = proposed_targets(low, high, int(np.clip(count, 12, 30)))
    return say("better_targets", targets=targets, unit=unit)
