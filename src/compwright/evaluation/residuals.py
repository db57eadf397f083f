"""Readings minus the median at their target, and the robust standard deviation of a reading."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest

#: Factors, on top of 1.4826, for an unbiased median absolute deviation of n normal readings
#: (Croux and Rousseeuw, 1992).
_MAD_FACTORS: Final = {
    2: 1.196,
    3: 1.495,
    4: 1.363,
    5: 1.206,
    6: 1.200,
    7: 1.140,
    8: 1.129,
    9: 1.107,
}
_BOTH: Final = (Direction.POSITIVE, Direction.NEGATIVE)


def pooled_residuals(test: PositioningTest) -> tuple[list[FloatArray], float]:
    """Return the readings (m, n) minus the median at their target in + and −, and their common
    robust standard deviation.
    """
    residuals = [
        test.deviations(direction) - row_medians(test.deviations(direction)) for direction in _BOTH
    ]
    return residuals, robust_scale(residuals, test)


def row_medians(values: FloatArray) -> FloatArray:
    """Return the median (m, 1) of the existing readings of each target; NaN without readings."""
    ordered = np.sort(np.where(np.isfinite(values), values, np.nan), axis=1)  # NaN stands last
    count = np.count_nonzero(np.isfinite(ordered), axis=1)
    if not ordered.size:
        return np.full((len(values), 1), np.nan)
    rows = np.arange(len(values))
    low, high = np.maximum(count - 1, 0) // 2, np.minimum(count // 2, ordered.shape[1] - 1)
    medians: FloatArray = 0.5 * (ordered[rows, low] + ordered[rows, high])
    return medians.reshape(-1, 1)


def run_medians(residual: FloatArray) -> FloatArray:
    """Return the median (1, n) of the residuals (m, n) of each run, over all targets."""
    return row_medians(residual.T).T


def robust_scale(residuals: list[FloatArray], test: PositioningTest) -> float:
    """Return the robust standard deviation of a reading, mm or deg.

    It is the mean over targets of the unbiased median absolute residual. ``residuals``: for each
    direction, readings (m, n) minus the median of their target. Targets with fewer than three
    readings do not count. The result is at least the resolution (smallest difference between two
    readings). Otherwise coarse readings that mostly repeat exactly would make each last digit an
    outlier.
    """
    estimates = [_unbiased_medians(residual) for residual in residuals]
    found = np.concatenate(estimates) if estimates else np.empty(0)
    if not found.size:
        return 0.0
    return max(float(np.mean(found)), test.step)


def _unbiased_medians(residual: FloatArray) -> FloatArray:
    """Return the unbiased median absolute residual at each target with three readings or more."""
    number = np.count_nonzero(np.isfinite(residual), axis=1)
    enough = number >= 3
    factors = np.array([_MAD_FACTORS.get(int(n), n / (n - 0.8)) for n in number[enough]])
    return 1.4826 * factors * row_medians(np.abs(residual[enough])).ravel()
