"""The test after loading against two expectations: how much of their difference it shows, and what
is left beside it. Numbers only; what they mean is decided in `verification.loading`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.statistics import count_readings, mean_deviation, standard_deviation
from compwright.records.axis import FloatArray

#: Share of a squared length that is rounding.
_NOTHING: Final = 1e-18
_OWN_NOISE_DOF: Final = (
    5.0  # from here on the after test's own scatter is better known than that of the before test
)
# mm or deg: repeated readings that are all equal show the instrument's resolution, not a perfect
# axis
_LEAST_NOISE: Final = 1e-5


@dataclass(frozen=True, slots=True)
class Comparison:
    """After-test means (k,) against both expectations, the datum removed, and where it is asked for
    a slope over the positions.

    ``residual_loaded``, ``residual_inactive`` (k,): measured minus expected, mm or deg. ``effect``:
    length of loaded minus inactive in standard errors. ``factor``: measured part of it, 1 loaded, 0
    not active, with standard error 1 / effect. ``chi2``: squared length of the residuals when that
    part is taken out. ``noise`` (mm or deg) of a reading with ``dof`` degrees of freedom; ``size``:
    rms of loaded minus inactive, mm or deg. ``removed``: how many columns were; ``slope`` of
    measured minus loaded and its standard error, mm/mm.
    """

    residual_loaded: FloatArray
    residual_inactive: FloatArray
    effect: float
    factor: float
    chi2: float
    dof: float
    noise: float
    size: float
    removed: int = 1
    slope: tuple[float, float] = (0.0, math.inf)

    @property
    def count(self) -> int:
        """How many means are compared."""
        return int(self.residual_loaded.size)

    def log_likelihood(self, factor: float) -> float:
        """Return the log-likelihood of a table that acts by ``factor``, up to a constant; of the t
        law where noise is estimated.
        """
        chi2 = self.chi2 + (self.effect * (self.factor - factor)) ** 2
        if math.isinf(self.dof):
            return -0.5 * chi2
        return -0.5 * (self.dof + self.count - self.removed) * math.log1p(chi2 / self.dof)


def compare_readings(
    positive: FloatArray,
    negative: FloatArray,
    loaded: FloatArray,
    inactive: FloatArray,
    covariance: FloatArray,
    sigma: float,
    dof: float,
    along: FloatArray | None = None,
) -> Comparison:
    """Compare readings (m, n) of both directions with both expectations (2m,) where all three
    exist; ``along`` (2m,): with a slope over these positions removed.
    """
    means = np.concatenate([mean_deviation(positive), mean_deviation(negative)])
    readings = np.concatenate([count_readings(positive), count_readings(negative)])
    used = np.isfinite(means) & np.isfinite(loaded) & np.isfinite(inactive)
    spread = covariance[np.ix_(used, used)] + np.diag(sigma**2 / readings[used])
    places = None if along is None else along[used]
    return _compare(means[used], loaded[used], inactive[used], spread, sigma, dof, places)


def after_noise(
    positive: FloatArray, negative: FloatArray, noise: float, noise_dof: float
) -> tuple[float, float]:
    """Return the standard deviation of a single reading of the after test and its degrees of
    freedom.
    """
    squares, dof = 0.0, 0.0
    for block in (positive, negative):
        s = standard_deviation(block)
        degrees = np.where(np.isfinite(s), count_readings(block) - 1.0, 0.0)
        squares += float(np.sum(degrees * np.where(np.isfinite(s), s, 0.0) ** 2))
        dof += float(degrees.sum())
    if dof >= _OWN_NOISE_DOF:
        return max(math.sqrt(squares / dof), _LEAST_NOISE), dof
    return max(noise, _LEAST_NOISE), noise_dof


def _compare(
    means: FloatArray,
    loaded: FloatArray,
    inactive: FloatArray,
    covariance: FloatArray,
    sigma: float,
    dof: float,
    along: FloatArray | None,
) -> Comparison:
    """Whiten by the covariance (k, k), remove the datum (and the slope ``along`` (k,) positions),
    and measure lengths.
    """
    root = np.linalg.cholesky(0.5 * (covariance + covariance.T))
    columns = np.ones((means.size, 1))
    if along is not None:
        columns = np.column_stack([columns, along - along.mean()])
    both = np.column_stack([means - inactive, loaded - inactive])
    white, white_columns = (np.linalg.solve(root, each) for each in (both, columns))
    # generalised least squares of each on what is removed
    inverse = np.linalg.inv(white_columns.T @ white_columns)
    shift = inverse @ (white_columns.T @ white)
    residual, step = (white - white_columns @ shift).T
    effect2 = float(step @ step)
    # a step that is nothing but what was removed leaves rounding alone
    seen = effect2 > _NOTHING * float(np.sum(white[:, 1] ** 2))
    factor = float(step @ residual) / effect2 if seen else 0.0
    beside = shift[:, 0] - shift[:, 1]
    return Comparison(
        residual_loaded=means - loaded - columns @ beside,
        residual_inactive=means - inactive - columns @ shift[:, 0],
        effect=math.sqrt(effect2) if seen else 0.0,
        factor=factor,
        chi2=float(np.sum((residual - factor * step) ** 2)),
        dof=dof,
        noise=sigma,
        size=float(np.std(loaded - inactive)),
        removed=columns.shape[1],
        slope=(float(beside[-1]), math.sqrt(float(inverse[-1, -1]))),
    )
