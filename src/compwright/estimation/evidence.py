"""Marginal likelihood of the hyperparameters, its gradient, and the weights given the
hyperparameters.

Everything here is in units of ``CellData.scale``. The hyperparameters are logarithms, in this
order: noise of a reading, local (target to target) part, standard deviation and length of the
smooth part, the same two of the reversal, amplitude of each period.

Rasmussen and Williams, Gaussian Processes for Machine Learning (2006): marginal likelihood, eq.
5.8; weights and their covariance, eq. 2.8; inverse and determinant of a sum of low rank, eq. A.9
and A.10. Readings of one cell enter by mean and sum of squares, which are sufficient (Gelman et
al., Bayesian Data Analysis, 3rd ed. 2013, section 3.2).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.basis import Basis, log_density
from compwright.records.axis import FloatArray

NOISE, LOCAL, SMOOTH, LENGTH, REVERSAL, REVERSAL_LENGTH, PERIODIC = range(7)
#: Standard deviation of offset, slope and constant reversal, which the data alone shall decide, in
#: units of the scale.
VAGUE: Final = 1e2


@dataclass(frozen=True, slots=True)
class CellData:
    """Means of the readings at each target and direction, without their straight line, in units of
    ``scale`` (mm or deg).

    ``positive``, ``negative`` (m,) with ``count_*`` (m,) readings (0: none, the mean is 0 then);
    ``squares`` is the sum of squares of the readings about their own means with ``dof`` degrees of
    freedom. ``floor``: noise below which nothing is claimed.
    """

    positive: FloatArray
    negative: FloatArray
    count_positive: FloatArray
    count_negative: FloatArray
    squares: float
    dof: float
    floor: float
    scale: float


@dataclass(frozen=True, slots=True)
class Prior:
    """Normal priors of the hyperparameters (h,): ``centre`` and ``width``. A fixed hyperparameter
    has ``free`` False.
    """

    centre: FloatArray
    width: FloatArray
    free: tuple[bool, ...]

    def log(self, values: FloatArray) -> float:
        """Return the logarithm of the prior density over the free hyperparameters: independent
        normal ones (Rasmussen and Williams 2006, eq. A.5). ``values`` (h,).
        """
        free = np.array(self.free)
        z = ((values - self.centre) / self.width)[free]
        return float(
            -0.5 * z @ z - np.sum(np.log(self.width[free])) - 0.5 * z.size * np.log(2.0 * np.pi)
        )


@dataclass(frozen=True, slots=True)
class Weights:
    """Posterior of the weights: ``mean`` (j,), ``root`` (j, j) with covariance root @ root.T;
    variances ``noise``, ``local``.
    """

    mean: FloatArray
    root: FloatArray
    noise: float
    local: float


class Evidence:
    """The marginal likelihood of one test under one basis."""

    def __init__(self, basis: Basis, targets: FloatArray, data: CellData, prior: Prior) -> None:
        self.basis, self.data, self.prior = basis, data, prior
        self.rows = np.vstack(basis.design(targets))
        self.values = np.concatenate([data.positive, data.negative])
        self.counts = np.concatenate([data.count_positive, data.count_negative])
        self.inverse_counts = np.where(self.counts > 0, 1.0 / np.maximum(self.counts, 1.0), 0.0)

    def log_variances(self, h: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return log prior variances (j,) of the weights and their derivatives (hyperparameters,
        j): the spectral density at each sine (Solin and Särkkä, Statistics and Computing 30, 2020),
        1 / harmonic^2 for those of a period.
        """
        basis = self.basis
        logs = np.full(basis.size, 2.0 * np.log(VAGUE))
        slopes = np.zeros((h.size, basis.size))
        smooth = slice(2, 2 + basis.sines)
        logs[smooth], slopes[LENGTH, smooth] = log_density(basis.frequencies, h[LENGTH])
        logs[smooth] += 2.0 * h[SMOOTH]
        slopes[SMOOTH, smooth] = 2.0
        start = smooth.stop
        for index, harmonics in enumerate(basis.harmonics):
            for harmonic in harmonics:
                pair = slice(start, start + 2)
                logs[pair] = 2.0 * (h[PERIODIC + index] - np.log(harmonic))
                slopes[PERIODIC + index, pair] = 2.0
                start += 2
        if basis.bidirectional:
            logs[start + 1] = 2.0 * h[REVERSAL]
            varying = slice(start + 2, basis.size)
            logs[varying], slopes[REVERSAL_LENGTH, varying] = log_density(
                basis.reversal_frequencies, h[REVERSAL_LENGTH]
            )
            logs[varying] += 2.0 * h[REVERSAL]
            slopes[REVERSAL, start + 1 :] = 2.0
        return logs, slopes

    def variances(self, h: FloatArray) -> tuple[float, float]:
        """Return the variance of one reading and of the local part, in units of the scale
        squared."""
        return float(np.exp(2.0 * h[NOISE]) + self.data.floor**2), float(np.exp(2.0 * h[LOCAL]))

    def weights(self, h: FloatArray) -> Weights:
        """Return the posterior of the weights given the hyperparameters ``h`` (Rasmussen and
        Williams 2006, eq. 2.8).
        """
        solved = self._solve(h)
        root = solved.deviations[:, np.newaxis] * solved.inverse_factor.T
        return Weights(
            mean=solved.deviations * solved.mean, root=root, noise=solved.noise, local=solved.local
        )

    def log_posterior(self, h: FloatArray) -> float:
        """Return log marginal likelihood plus log prior of the hyperparameters (Rasmussen and
        Williams 2006, eq. 5.8), up to a constant that no hyperparameter moves.
        """
        return self._log_posterior(h, self._solve(h))

    def with_gradient(self, h: FloatArray) -> tuple[float, FloatArray]:
        """Return the log posterior and its gradient (h,); that of a fixed hyperparameter is 0.

        By Fisher's identity: the gradient of the marginal likelihood is the expected gradient of
        the complete one (Louis, J. R. Stat. Soc. B 44, 1982).
        """
        solved = self._solve(h)
        second_moment = solved.mean**2 + np.sum(solved.inverse_factor**2, axis=0)
        gradient = 0.5 * solved.slopes @ (second_moment - 1.0)
        by_noise, by_local = self._by_variances(solved)
        data = self.data
        by_noise += -0.5 * data.dof / solved.noise + 0.5 * data.squares / solved.noise**2
        gradient[NOISE] += by_noise * 2.0 * np.exp(2.0 * h[NOISE])
        gradient[LOCAL] += by_local * 2.0 * solved.local
        gradient -= (h - self.prior.centre) / self.prior.width**2
        return self._log_posterior(h, solved), np.where(self.prior.free, gradient, 0.0)

    def _solve(self, h: FloatArray) -> _Solved:
        noise, local = self.variances(h)
        logs, slopes = self.log_variances(h)
        deviations = np.exp(0.5 * logs)
        precision = self.counts / noise
        own, cross, shared = _cell_precision(precision, local)
        rows = self.rows * deviations
        weighted = own[:, np.newaxis] * rows + cross[:, np.newaxis] * np.roll(
            rows, rows.shape[0] // 2, axis=0
        )
        matrix = rows.T @ weighted
        matrix.flat[:: matrix.shape[0] + 1] += 1.0
        factor = np.asarray(np.linalg.cholesky(matrix), dtype=np.float64)
        inverse = np.asarray(np.linalg.inv(factor), dtype=np.float64)
        moment = inverse @ (weighted.T @ self.values)
        return _Solved(
            noise,
            local,
            deviations,
            slopes,
            own,
            cross,
            shared,
            rows,
            weighted,
            factor,
            inverse,
            moment,
            inverse.T @ moment,
        )

    def _log_posterior(self, h: FloatArray, solved: _Solved) -> float:
        data, y = self.data, self.values
        precise = solved.own * y + solved.cross * np.roll(y, y.size // 2)
        measured = self.counts > 0
        log_determinant = float(
            np.sum(np.log(solved.noise * self.inverse_counts[measured]))
            + np.sum(np.log(solved.shared))
            + 2.0 * np.sum(np.log(np.diag(solved.factor)))
        )
        fit = float(y @ precise - solved.moment @ solved.moment)
        spread = data.dof * np.log(solved.noise) + data.squares / solved.noise
        return float(-0.5 * (log_determinant + fit + spread)) + self.prior.log(h)

    def _by_variances(self, solved: _Solved) -> tuple[float, float]:
        """Return the derivatives of the log likelihood of the means by the noise and the local
        variance.
        """
        half = self.values.size // 2
        residual = self.values - solved.rows @ solved.mean
        spread = solved.inverse_factor @ solved.rows.T
        square = residual**2 + np.sum(spread**2, axis=0)
        product = residual * np.roll(residual, half) + np.sum(
            spread * np.roll(spread, half, axis=1), axis=0
        )
        own, cross = solved.own, solved.cross
        other_own = np.roll(own, half)
        # Per target, the 2 x 2 blocks of P (d cov / d variance) P against those of the expected
        # residual square.
        other_counts = np.roll(self.inverse_counts, half)
        pdp_own = own**2 * self.inverse_counts + cross**2 * other_counts
        pdp_cross = own * cross * self.inverse_counts + cross * other_own * other_counts
        by_noise = -0.5 * np.sum(own * self.inverse_counts) + 0.5 * np.sum(
            pdp_own * square + pdp_cross * product
        )
        row_sum = own + cross
        other_sum = np.roll(row_sum, half)
        by_local = -0.5 * np.sum(row_sum) + 0.5 * np.sum(
            row_sum**2 * square + row_sum * other_sum * product
        )
        return float(by_noise), float(by_local)


@dataclass(frozen=True, slots=True)
class _Solved:
    """What one evaluation shares: variances, whitened rows, precision per cell, factor of the
    posterior, whitened mean.
    """

    noise: float
    local: float
    deviations: FloatArray
    slopes: FloatArray
    own: FloatArray
    cross: FloatArray
    shared: FloatArray
    rows: FloatArray
    weighted: FloatArray
    factor: FloatArray
    inverse_factor: FloatArray
    moment: FloatArray
    mean: FloatArray


def _cell_precision(
    precision: FloatArray, local: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the inverse of noise/n + local for the two directions of each target: diagonal (2m,),
    off-diagonal (2m,), and the determinant's extra factor (m,). A cell without readings has
    precision 0. By the formula of Sherman and Morrison (Rasmussen and Williams 2006, eq. A.9,
    A.10).
    """
    half = precision.size // 2
    both = precision[:half] + precision[half:]
    shared = 1.0 + local * both
    gain = np.tile(local / shared, 2)
    own = precision - gain * precision**2
    cross = -gain * precision * np.roll(precision, half)
    return own, cross, shared
