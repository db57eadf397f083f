"""Readings less the median of their target, and the robust scale of a reading."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest

#: Factors that make the median absolute deviation of n normal readings unbiased, beside 1.4826
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


def pooled(test: PositioningTest) -> tuple[list[FloatArray], float]:
    """Return the residuals (m, n) from the target's median in + and −, and the robust scale of a
    reading, common to both.
    """
    residuals = [
        test.deviations(direction) - row_medians(test.deviations(direction)) for direction in _BOTH
    ]
    return residuals, robust_scale(residuals, test)


def row_medians(values: FloatArray) -> FloatArray:
    """Return the medians (m, 1) of the readings there are; NaN without one."""
    medians = [
        np.median(row[np.isfinite(row)]) if np.any(np.isfinite(row)) else np.nan for row in values
    ]
    return np.array(medians, dtype=np.float64).reshape(-1, 1)


def run_medians(residual: FloatArray) -> FloatArray:
    """Return the medians (1, n) over the targets of the residuals (m, n) of each run."""
    return row_medians(residual.T).T


def robust_scale(residuals: list[FloatArray], test: PositioningTest) -> float:
    """Return the robust standard deviation of a reading: the mean over targets of the unbiased
    median absolute residual.

    Not smaller than the resolution of the readings (the smallest step between two of them), so that
    coarse readings which mostly repeat exactly do not make every last digit suspect. Targets with
    fewer than three readings do not count.
    """
    estimates = []
    for row in (row for residual in residuals for row in residual):
        values = np.abs(row[np.isfinite(row)])
        if values.size >= 3:
            factor = _MAD_FACTORS.get(values.size, values.size / (values.size - 0.8))
            estimates.append(1.4826 * factor * float(np.median(values)))
    if not estimates:
        return 0.0
    return max(float(np.mean(estimates)), _resolution(test))


def _resolution(test: PositioningTest) -> float:
    """Return the smallest step between two different readings; 0 where all are equal."""
    values = np.concatenate([test.positive.ravel(), test.negative.ravel()])
    steps = np.diff(np.unique(values[np.isfinite(values)]))
    steps = steps[steps > 1e-12]  # below a picometre: rounding of binary numbers
    return float(steps.min()) if steps.size else 0.0
