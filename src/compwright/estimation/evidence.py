"""Marginal likelihood of the hyperparameters, its gradient, and the weights given the
hyperparameters.

Everything here is in units of ``CellData.scale``. The hyperparameters are logarithms, in this
order: noise of a reading (of tests whose repetition does not tell it), local (target to target)
part, standard deviation and length of the smooth part, the same two of the reversal, amplitude of
each period.

Rasmussen and Williams, Gaussian Processes for Machine Learning (2006): marginal likelihood, eq.
5.8; weights and their covariance, eq. 2.8; inverse and determinant of a sum of low rank, eq. A.9
and A.10. Readings of one cell enter by mean and sum of squares, which are sufficient (Gelman et
al., Bayesian Data Analysis, 3rd ed. 2013, section 3.2).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import Basis, log_density
from compwright.records.axis import FloatArray

NOISE, LOCAL, SMOOTH, LENGTH, REVERSAL, REVERSAL_LENGTH, PERIODIC = range(7)
#: Standard deviation of offset, slope and constant reversal, which the data alone shall decide, in
#: units of the scale.
VAGUE: Final = 1e2


@dataclass(frozen=True, slots=True, kw_only=True)
class CellData:
    """Means of the readings in the c cells (target and direction of one test) that have any,
    without their straight line, in units of ``scale`` (mm or deg).

    Cells stand in the order of their targets: ``seats`` (c,) is the index of each cell's target,
    ``starts`` (m,) the first cell of each target, ``signs`` (c,) its direction. ``values``,
    ``precision`` (n, c) and ``columns`` (n, c, q), by draw of the noise: the means, their inverse
    variances, and what is common to them as columns of unit variance. ``counts`` (c,): readings
    of the cells whose noise is inferred with the curve (0: it is known, draw by draw);
    ``squares`` is the sum of squares of these readings about their own means with ``dof`` degrees
    of freedom. ``extra`` (c, e): columns with standard deviations ``extra_std`` (e,), the datum and
    the slope of single tests. ``floor``: noise below which nothing is claimed.
    """

    seats: NDArray[np.intp]
    starts: NDArray[np.intp]
    signs: FloatArray
    values: FloatArray
    precision: FloatArray
    columns: FloatArray
    counts: FloatArray
    squares: float
    dof: float
    extra: FloatArray
    extra_std: FloatArray
    floor: float
    scale: float

    @property
    def draws(self) -> int:
        """Number of draws of the noise."""
        return len(self.values)

    def typical(self) -> int:
        """Return the draw of the noise whose mean log variance of a cell is the median of all."""
        known = self.counts == 0
        if not np.any(known):
            return 0
        variance = 1.0 / self.precision[:, known] + np.sum(self.columns[:, known] ** 2, axis=2)
        level = np.mean(np.log(variance), axis=1)
        return int(np.argsort(level, kind="stable")[self.draws // 2])


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
    """Posterior of the weights: ``mean`` (j,), ``root`` (j, j) with covariance root @ root.T, those
    of the basis first; variances ``noise`` (of a reading, where it is inferred) and ``local``;
    ``draw`` of the noise.
    """

    mean: FloatArray
    root: FloatArray
    noise: float
    local: float
    draw: int


def design_rows(basis: Basis, targets: FloatArray, data: CellData, draw: int) -> FloatArray:
    """Return the columns (c, j) of all weights at the cells under a draw of the noise: those of the
    basis, of single tests, and what is common to means.
    """
    return np.hstack([_own_rows(basis, targets, data), data.columns[draw]])


def _own_rows(basis: Basis, targets: FloatArray, data: CellData) -> FloatArray:
    positive, negative = basis.design(targets)
    own = np.where((data.signs > 0)[:, np.newaxis], positive[data.seats], negative[data.seats])
    return np.hstack([own, data.extra])


class Evidence:
    """The marginal likelihood of the tests of an axis under one basis.

    ``values`` (c,): the means under the typical noise. Where a method takes a ``draw`` of the noise
    and is given none, it is the typical one.
    """

    def __init__(self, basis: Basis, targets: FloatArray, data: CellData, prior: Prior) -> None:
        self.basis, self.data, self.prior = basis, data, prior
        self.rows = _own_rows(basis, targets, data)
        self.typical = data.typical()
        self.values = data.values[self.typical]

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
        """Return the variance of one reading, where it is inferred, and of the local part, in units
        of the scale squared.
        """
        return float(np.exp(2.0 * h[NOISE]) + self.data.floor**2), float(np.exp(2.0 * h[LOCAL]))

    def weights(self, h: FloatArray, draw: int | None = None) -> Weights:
        """Return the posterior of the weights given the hyperparameters ``h`` and a draw of the
        noise (Rasmussen and Williams 2006, eq. 2.8).
        """
        solved = self._solve(h, draw)
        root = solved.deviations[:, np.newaxis] * solved.inverse_factor.T
        return Weights(
            mean=solved.deviations * solved.mean,
            root=root,
            noise=solved.noise,
            local=solved.local,
            draw=self.typical if draw is None else draw,
        )

    def log_posterior(self, h: FloatArray, draw: int | None = None) -> float:
        """Return log marginal likelihood plus log prior of the hyperparameters (Rasmussen and
        Williams 2006, eq. 5.8), up to a constant that neither they nor the noise move.
        """
        return self._log_posterior(h, self._solve(h, draw))

    def with_gradient(self, h: FloatArray) -> tuple[float, FloatArray]:
        """Return the log posterior and its gradient (h,) under the typical noise; that of a fixed
        hyperparameter is 0.

        By Fisher's identity: the gradient of the marginal likelihood is the expected gradient of
        the complete one (Louis, J. R. Stat. Soc. B 44, 1982).
        """
        solved = self._solve(h, None)
        size = self.basis.size
        second_moment = solved.mean[:size] ** 2 + np.sum(solved.inverse_factor[:, :size] ** 2, 0)
        gradient = 0.5 * solved.slopes @ (second_moment - 1.0)
        by_noise, by_local = self._by_variances(solved)
        gradient[NOISE] += by_noise * 2.0 * np.exp(2.0 * h[NOISE])
        gradient[LOCAL] += by_local * 2.0 * solved.local
        gradient -= (h - self.prior.centre) / self.prior.width**2
        return self._log_posterior(h, solved), np.where(self.prior.free, gradient, 0.0)

    def precision_times(self, h: FloatArray, columns: FloatArray) -> FloatArray:
        """Return the inverse covariance of the means at the hyperparameters ``h``, under the
        typical noise, times ``columns`` (c, k): local part, noise and every function of the basis
        (Rasmussen and Williams 2006, eq. A.9).
        """
        solved = self._solve(h, None)
        bare = self._without_local(solved, columns)
        inside = solved.inverse_factor @ (solved.weighted.T @ columns)
        product: FloatArray = bare - solved.weighted @ (solved.inverse_factor.T @ inside)
        return product

    def _solve(self, h: FloatArray, draw: int | None) -> _Solved:
        data = self.data
        index = self.typical if draw is None else draw
        noise, local = self.variances(h)
        logs, slopes = self.log_variances(h)
        deviations = np.concatenate(
            [np.exp(0.5 * logs), data.extra_std, np.ones(data.columns.shape[2])]
        )
        precision = np.where(data.counts > 0, data.counts / noise, data.precision[index])
        total = np.add.reduceat(precision, data.starts)
        gain = local / (1.0 + local * total)
        rows = np.hstack([self.rows, data.columns[index]]) * deviations
        weighted = _local_removed(precision, gain, data, rows)
        matrix = rows.T @ weighted
        matrix.flat[:: matrix.shape[0] + 1] += 1.0
        factor = np.asarray(np.linalg.cholesky(matrix), dtype=np.float64)
        inverse = np.asarray(np.linalg.inv(factor), dtype=np.float64)
        values = data.values[index]
        moment = inverse @ (weighted.T @ values)
        return _Solved(
            noise=noise,
            local=local,
            deviations=deviations,
            slopes=slopes,
            precision=precision,
            total=total,
            gain=gain,
            values=values,
            rows=rows,
            weighted=weighted,
            factor=factor,
            inverse_factor=inverse,
            moment=moment,
            mean=inverse.T @ moment,
        )

    def _without_local(self, solved: _Solved, columns: FloatArray) -> FloatArray:
        return _local_removed(solved.precision, solved.gain, self.data, columns)

    def _log_posterior(self, h: FloatArray, solved: _Solved) -> float:
        data, y = self.data, solved.values
        log_determinant = float(
            -np.sum(np.log(solved.precision))
            + np.sum(np.log1p(solved.local * solved.total))
            + 2.0 * np.sum(np.log(np.diag(solved.factor)))
        )
        fit = float(y @ self._without_local(solved, y) - solved.moment @ solved.moment)
        spread = data.dof * np.log(solved.noise) + data.squares / solved.noise
        return float(-0.5 * (log_determinant + fit + spread)) + self.prior.log(h)

    def _by_variances(self, solved: _Solved) -> tuple[float, float]:
        """Return the derivatives of the log likelihood by the variance of a reading, where it is
        inferred, and by that of the local part: for V' the derivative of the covariance V of the
        means about the curve, half of E[r' P V' P r] - tr(P V') with P the inverse of V and r the
        residuals (Rasmussen and Williams 2006, eq. 5.9).
        """
        data, free = self.data, self.prior.free
        by_noise = by_local = 0.0
        if not (free[NOISE] or free[LOCAL]):
            return by_noise, by_local
        residual = self._without_local(solved, solved.values - solved.rows @ solved.mean)
        spread = solved.inverse_factor @ solved.weighted.T
        if free[LOCAL]:
            seen = np.add.reduceat(spread, data.starts, axis=1)
            square = np.add.reduceat(residual, data.starts) ** 2 + np.sum(seen**2, axis=0)
            kept = solved.total / (1.0 + solved.local * solved.total)
            by_local = 0.5 * float(np.sum(square) - np.sum(kept))
        if free[NOISE]:
            per_reading = np.divide(
                1.0, data.counts, out=np.zeros_like(data.counts), where=data.counts > 0
            )
            own = solved.precision - solved.gain[data.seats] * solved.precision**2
            square = residual**2 + np.sum(spread**2, axis=0)
            by_noise = 0.5 * float(np.sum(per_reading * (square - own)))
            by_noise += -0.5 * data.dof / solved.noise + 0.5 * data.squares / solved.noise**2
        return by_noise, by_local


@dataclass(frozen=True, slots=True, kw_only=True)
class _Solved:
    """What one evaluation shares: variances, precision per cell and summed per target, whitened
    rows, factor of the posterior, whitened mean.
    """

    noise: float
    local: float
    deviations: FloatArray
    slopes: FloatArray
    precision: FloatArray
    total: FloatArray
    gain: FloatArray
    values: FloatArray
    rows: FloatArray
    weighted: FloatArray
    factor: FloatArray
    inverse_factor: FloatArray
    moment: FloatArray
    mean: FloatArray


def _local_removed(
    precision: FloatArray, gain: FloatArray, data: CellData, columns: FloatArray
) -> FloatArray:
    """Return the inverse of noise + local part times ``columns`` (c,) or (c, k): cells of one
    target share the local part. By the formula of Sherman and Morrison (Rasmussen and Williams
    2006, eq. A.9) with ``gain`` (m,) = local / (1 + local sum of the target's precisions).
    """
    by_cell = precision if columns.ndim == 1 else precision[:, np.newaxis]
    by_target = gain if columns.ndim == 1 else gain[:, np.newaxis]
    scaled = by_cell * columns
    common = by_target * np.add.reduceat(scaled, data.starts, axis=0)
    product: FloatArray = scaled - by_cell * common[data.seats]
    return product
