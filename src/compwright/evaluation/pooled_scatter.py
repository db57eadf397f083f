"""The scatter and the range of the readings of a test."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.evaluation.statistics import count_readings, standard_deviation
from compwright.records.axis import Direction
from compwright.records.positioning import PositioningTest

_DIRECTIONS: Final = (Direction.POSITIVE, Direction.NEGATIVE)


def pooled_scatter(test: PositioningTest) -> tuple[float, float]:
    """Return the pooled standard deviation of a reading (mm or deg) and its degrees of freedom."""
    squares, dof = 0.0, 0.0
    for direction in _DIRECTIONS:
        block = test.deviations(direction)
        s = standard_deviation(block)
        known = np.isfinite(s)
        degrees = np.where(known, count_readings(block) - 1.0, 0.0)
        squares += float(np.sum(degrees * np.where(known, s, 0.0) ** 2))
        dof += float(degrees.sum())
    return (float(np.sqrt(squares / dof)) if dof else 0.0), dof


def reading_range(test: PositioningTest) -> float:
    """Return the largest minus the smallest reading of a test, mm or deg."""
    values = np.concatenate([test.positive.ravel(), test.negative.ravel()])
    made = values[np.isfinite(values)]
    return float(np.ptp(made)) if made.size else 0.0
