"""The probability of readings for given model parameters (marginal likelihood) and its gradient.

All values are in units of ``CellData.scale``. The hyperparameters are logarithms, in this order:

- noise of a reading, for tests whose repeated readings do not determine it
- part of the error that is independent from target to target (local part)
- standard deviation, length, and smoothness above the least one, of the smooth part
- standard deviation and length of the reversal
- amplitude of each period

Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006): marginal likelihood,
eq. 5.8; weights and their covariance, eq. 2.8; inverse and determinant of a sum of low rank, eq.
A.9 and A.10. The readings of a cell enter as their mean and sum of squares, which contain all their
information (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section 3.2).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import Basis, log_density, smooth_density
from compwright.estimation.cholesky import cholesky_factor, factor_and_solve, inverse_triangle
from compwright.records.axis import FloatArray

NOISE, LOCAL, SMOOTH, LENGTH, EXCESS, REVERSAL, REVERSAL_LENGTH, PERIODIC = range(8)
#: Standard deviation of offset, slope and constant reversal, which the data alone shall decide, in
#: units of the scale: their least squares values are taken out before.
VAGUE: Final = 10.0
#: Widths of its prior by which the amplitude of a period may exceed the middle, and how hard that
#: limit is: two targets next to each other that differ would otherwise make a wave of any
#: amplitude likely.
_FARTHEST: Final = 3.0
_HARD: Final = 50.0
#: Largest variance of a cell over its smallest noise up to which the covariance of the cells keeps
#: six digits of the density.
_CONDITION: Final = 1e10
_LOG_TURN: Final = np.log(2.0 * np.pi)


@dataclass(frozen=True, slots=True, kw_only=True)
class CellData:
    """The mean readings of an axis minus a straight line, as multiples of ``scale`` (mm or deg).

    A cell is a target and direction of one test. The c cells are sorted by target: ``target_index``
    (c,) is the index of each cell's target, ``starts`` (m,) the first cell of each target,
    ``signs`` (c,) the direction of each cell.

    The noise is given by n random draws. ``values`` (n, c): the means. ``precision`` (n, c): their
    inverse variances. ``columns`` (n, c, q): errors common to several means, as columns of unit
    variance. ``extra`` (c, e): offset and slope of single tests, as columns with standard
    deviations ``extra_std`` (e,). ``floor``: lower bound of the noise.

    Some tests do not determine their noise, and it is estimated together with the curve. ``counts``
    (c,): number of readings of each of their cells; 0 for other cells. ``squares``: sum of squares
    of these readings about their own means, with ``dof`` degrees of freedom.
    """

    target_index: NDArray[np.intp]
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
        """The number of random draws of the noise."""
        return len(self.values)

    def typical(self) -> int:
        """Return the index of the draw of the noise whose mean log variance is the median of all
        draws.
        """
        known = self.counts == 0
        if not np.any(known):
            return 0
        variance = 1.0 / self.precision[:, known] + np.sum(self.columns[:, known] ** 2, axis=2)
        level = np.mean(np.log(variance), axis=1)
        return int(np.argsort(level, kind="stable")[self.draws // 2])


@dataclass(frozen=True)
class Prior:
    """Normal priors of the model's parameters (h,): ``centre`` and ``width``. A parameter with
    ``free`` False is fixed.
    """

    centre: FloatArray
    width: FloatArray
    free: tuple[bool, ...]

    @cached_property
    def _free(self) -> NDArray[np.bool_]:
        return np.array(self.free)

    @cached_property
    def _widths(self) -> float:
        """The sum of the log prior standard deviations of the free parameters."""
        return float(np.sum(np.log(self.width[self._free])))

    def log(self, values: FloatArray) -> float:
        """Return the log prior density of the free parameters at ``values`` (h,).

        The priors are independent and normal (Rasmussen and Williams 2006, eq. A.5).
        """
        z = ((values - self.centre) / self.width)[self._free]
        log = float(-0.5 * z @ z - self._widths - 0.5 * z.size * _LOG_TURN)
        if values.size == PERIODIC:
            return log
        return log - _HARD * float(np.sum(self._beyond(values) ** 2))

    def gradient(self, values: FloatArray) -> FloatArray:
        """Return the gradient (h,) of the log prior density at ``values`` (h,)."""
        gradient: FloatArray = (self.centre - values) / self.width**2
        if values.size > PERIODIC:
            gradient[PERIODIC:] -= 2.0 * _HARD * self._beyond(values) / self.width[PERIODIC:]
        return gradient

    def _beyond(self, values: FloatArray) -> FloatArray:
        z = (values - self.centre)[PERIODIC:] / self.width[PERIODIC:]
        return np.maximum(z - _FARTHEST, 0.0)


@dataclass(frozen=True, slots=True)
class WeightPosterior:
    """Probability distribution of the weights of the functions of position, given the readings.

    ``mean`` (j,): mean of the weights; the first weights are those of the basis. ``root`` (j, j):
    root of their covariance, which is root @ root.T. ``noise``: variance of a reading, if it is
    estimated. ``local``: variance of the part of the error that is independent from target to
    target. ``draw``: index of the random draw of the noise that was used.
    """

    mean: FloatArray
    root: FloatArray
    noise: float
    local: float
    draw: int


def _own_rows(basis: Basis, targets: FloatArray, data: CellData) -> FloatArray:
    positive, negative = basis.design(targets)
    own = np.where(
        (data.signs > 0)[:, np.newaxis], positive[data.target_index], negative[data.target_index]
    )
    return np.hstack([own, data.extra])


class Evidence:
    """Calculator of the marginal likelihood of the readings of an axis, for an error that is a
    weighted sum of the functions ``basis``.

    ``values`` (c,): the means of the typical draw of the noise. Methods with a parameter ``draw``
    use the typical draw of the noise if it is None.
    """

    def __init__(self, basis: Basis, targets: FloatArray, data: CellData, prior: Prior) -> None:
        self.basis, self.data, self.prior = basis, data, prior
        self.rows = _own_rows(basis, targets, data)
        self.typical = data.typical()
        self.values = data.values[self.typical]
        self.typical_rows = np.hstack([self.rows, data.columns[self.typical]])
        self.free = np.array(prior.free)
        self.inferred = bool(np.any(data.counts > 0))
        self.others = np.concatenate([data.extra_std, np.ones(data.columns.shape[2])])
        self.together = np.flatnonzero(data.target_index[:, np.newaxis] == data.target_index)
        self.frequencies, self.reversal_frequencies = basis.frequencies, basis.reversal_frequencies
        waves = [(i, n) for i, some in enumerate(basis.harmonics) for n in some for _ in range(2)]
        self.wave_of = np.array([PERIODIC + index for index, _ in waves], dtype=np.intp)
        self.falls = np.log([harmonic for _, harmonic in waves])
        self.smooth = slice(2, 2 + basis.sines)
        self.waves = slice(self.smooth.stop, self.smooth.stop + len(waves))
        self.varying = slice(self.waves.stop + 2, basis.size)
        # What no hyperparameter changes of the slopes of the log variances.
        self.slopes = np.zeros((prior.centre.size, basis.size))
        self.slopes[SMOOTH, self.smooth] = 2.0
        self.slopes[self.wave_of, np.arange(self.waves.start, self.waves.stop)] = 2.0
        self.slopes[REVERSAL, self.waves.stop + 1 :] = 2.0

    def rows_under(self, draw: int) -> FloatArray:
        """Return the matrix (c, j) from weights to mean readings, under one ``draw`` of noise."""
        if draw == self.typical:
            return self.typical_rows
        return np.hstack([self.rows, self.data.columns[draw]])

    def log_variances(self, h: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the log prior variances (j,) of the weights and their derivatives (h, j) by the
        parameters.

        The variance of a sine is the spectral density at its frequency (Solin and Särkkä,
        Statistics and Computing 30, 2020). For the waves of a period it falls with 1 / harmonic^2.
        """
        smooth, varying = self.smooth, self.varying
        slopes = self.slopes.copy()
        logs = np.full(slopes.shape[1], 2.0 * np.log(VAGUE))
        logs[smooth], slopes[LENGTH, smooth], slopes[EXCESS, smooth] = smooth_density(
            self.frequencies, h[LENGTH], h[EXCESS]
        )
        logs[smooth] += 2.0 * h[SMOOTH]
        logs[self.waves] = 2.0 * (h[self.wave_of] - self.falls)
        if self.basis.bidirectional:
            logs[varying.start - 1] = 2.0 * h[REVERSAL]
            logs[varying], slopes[REVERSAL_LENGTH, varying] = log_density(
                self.reversal_frequencies, h[REVERSAL_LENGTH]
            )
            logs[varying] += 2.0 * h[REVERSAL]
        return logs, slopes

    def variances(self, h: FloatArray) -> tuple[float, float]:
        """Return the variance of one reading (if the noise is estimated), and the variance of that
        part of the error which is independent from target to target. Both are relative to the
        squared scale.
        """
        return float(np.exp(2.0 * h[NOISE]) + self.data.floor**2), float(np.exp(2.0 * h[LOCAL]))

    def weights(self, h: FloatArray, draw: int | None = None) -> WeightPosterior:
        """Return the distribution of the weights for parameters ``h`` and one ``draw`` of the noise
        (Rasmussen and Williams 2006, eq. 2.8).
        """
        scaled = self._scaled(h, draw)
        matrix, moment = _normal(scaled, scaled.removed(scaled.rows))
        inverse = inverse_triangle(cholesky_factor(matrix)[1])
        return WeightPosterior(
            mean=scaled.deviations * (inverse.T @ (inverse @ moment)),
            root=scaled.deviations[:, np.newaxis] * inverse.T,
            noise=scaled.noise,
            local=scaled.local,
            draw=self.typical if draw is None else draw,
        )

    def log_posterior(self, h: FloatArray, draw: int | None = None) -> float:
        """Return the log posterior density of the parameters ``h``, up to a constant, under one
        ``draw`` of the noise (None: the typical draw).

        It is the log marginal likelihood plus the log prior (Rasmussen and Williams 2006, eq. 5.8).
        The constant depends neither on the parameters nor on the noise.
        """
        return self._marginal(h, draw, derivatives=False)[2] + self.prior.log(h)

    def with_gradient(self, h: FloatArray) -> tuple[float, FloatArray]:
        """Return the log posterior density at ``h`` and its gradient (h,), under the typical draw
        of the noise. The gradient by a fixed parameter is 0.

        V is the covariance of the means y, V' its derivative by a parameter, and P the inverse of
        V. The derivative of the log density is half of y' P V' P y - tr(P V') (Rasmussen and
        Williams 2006, eq. 5.9).
        """
        scaled, marginal, log = self._marginal(h, None, derivatives=True)
        data = self.data
        gradient = 0.5 * scaled.slopes @ marginal.by_weight[: self.basis.size]
        seen = np.add.reduceat(marginal.residual, data.starts)
        by_local = 0.5 * float(seen @ seen - marginal.by_target.sum())
        gradient[LOCAL] += by_local * 2.0 * scaled.local
        if self.inferred:
            inferred = data.counts > 0
            square = marginal.residual[inferred] ** 2 - marginal.by_cell[inferred]
            by_noise = 0.5 * float(np.sum(square / data.counts[inferred]))
            by_noise += -0.5 * data.dof / scaled.noise + 0.5 * data.squares / scaled.noise**2
            gradient[NOISE] += by_noise * 2.0 * np.exp(2.0 * h[NOISE])
        gradient += self.prior.gradient(h)
        value = log + self.prior.log(h)
        return value, np.where(self.free, gradient, 0.0)

    def _scaled(self, h: FloatArray, draw: int | None) -> _Scaled:
        data = self.data
        index = self.typical if draw is None else draw
        noise, local = self.variances(h)
        logs, slopes = self.log_variances(h)
        deviations = np.concatenate([np.exp(0.5 * logs), self.others])
        precision = data.precision[index]
        if self.inferred:
            precision = np.where(data.counts > 0, data.counts / noise, precision)
        return _Scaled(
            noise=noise,
            local=local,
            deviations=deviations,
            slopes=slopes,
            precision=precision,
            values=data.values[index],
            rows=self.rows_under(index) * deviations,
            data=data,
            together=self.together,
        )

    def _marginal(
        self, h: FloatArray, draw: int | None, *, derivatives: bool
    ) -> tuple[_Scaled, _Marginal, float]:
        """Return the scaled model, the log density of the mean readings (with terms of its
        derivatives if ``derivatives``), and the log density of all readings, means and scatter. The
        covariance of the mean readings is used if they are fewer than the weights and the noise is
        large enough, else the covariance of the weights.
        """
        scaled = self._scaled(h, draw)
        cells, weights = scaled.rows.shape
        largest = max(float(scaled.deviations.max()) ** 2, scaled.local)
        few = cells < weights and largest * cells * scaled.precision.max() < _CONDITION
        marginal = (_by_cells if few else _by_weights)(scaled, derivatives=derivatives)
        spread = self.data.dof * np.log(scaled.noise) + self.data.squares / scaled.noise
        return scaled, marginal, marginal.log - 0.5 * float(spread)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Scaled:
    """The linear model of the mean readings for given parameters, with weights of unit variance.

    ``precision``, ``values`` (c,): inverse variance and value of each mean. ``rows`` (c, j): the
    matrix from weights to means. ``noise``, ``local``: variances of a reading and of the local
    part. ``deviations`` (j,): prior standard deviations of the weights. ``slopes``: derivatives of
    their log variances. ``together``: pairs of cells with the same target, as flat indices in a
    matrix (c, c).
    """

    noise: float
    local: float
    deviations: FloatArray
    slopes: FloatArray
    precision: FloatArray
    values: FloatArray
    rows: FloatArray
    data: CellData
    together: NDArray[np.intp]

    @property
    def total(self) -> FloatArray:
        """The total precision (1 / variance) of the mean readings at each target (m,)."""
        return np.add.reduceat(self.precision, self.data.starts)

    def removed(self, columns: FloatArray) -> FloatArray:
        """Return ``columns`` (c,) or (c, k) multiplied by the inverse covariance matrix of the
        noise together with that part of the error which is independent from target to target.

        Cells of one target have this part in common. The inverse is that of Sherman and Morrison
        (Rasmussen and Williams 2006, eq. A.9).
        """
        gain = self.local / (1.0 + self.local * self.total)
        precision = self.precision
        if columns.ndim > 1:
            gain, precision = gain[:, np.newaxis], precision[:, np.newaxis]
        scaled = precision * columns
        common = gain * np.add.reduceat(scaled, self.data.starts, axis=0)
        product: FloatArray = scaled - precision * common[self.data.target_index]
        return product


@dataclass(frozen=True, slots=True, kw_only=True)
class _Marginal:
    """The log density of the mean readings y with covariance V, and terms of its derivatives.

    P is the inverse of V; r is the column of a weight of unit variance. ``residual`` (c,): P y.
    ``by_weight`` (j,): (r' P y)² - r' P r. ``by_target`` (m,): sum of P over the cells of a target.
    ``by_cell`` (c,): diagonal of P.
    """

    log: float
    residual: FloatArray
    by_weight: FloatArray
    by_target: FloatArray
    by_cell: FloatArray


_NONE: Final = np.zeros(0)


def _by_cells(scaled: _Scaled, *, derivatives: bool) -> _Marginal:
    """Return the log density of the mean readings, computed from their covariance matrix (c, c),
    with terms of its derivatives if ``derivatives``.
    """
    data, y = scaled.data, scaled.values
    covariance = scaled.rows @ scaled.rows.T
    covariance.reshape(-1)[scaled.together] += scaled.local
    covariance.flat[:: y.size + 1] += 1.0 / scaled.precision
    # The covariance is larger than that of the noise alone, its inverse smaller.
    factor, z = factor_and_solve(covariance, y, float(scaled.precision @ y**2))
    log = -float(np.log(factor.diagonal()).sum()) - 0.5 * float(z @ z)
    if not derivatives:
        return _Marginal(log=log, residual=_NONE, by_weight=_NONE, by_target=_NONE, by_cell=_NONE)
    inverse = inverse_triangle(factor)
    whitened = inverse @ scaled.rows
    seen = np.add.reduceat(inverse, data.starts, axis=1)
    return _Marginal(
        log=log,
        residual=inverse.T @ z,
        by_weight=(z @ whitened) ** 2 - (whitened**2).sum(axis=0),
        by_target=(seen**2).sum(axis=0),
        by_cell=(inverse**2).sum(axis=0),
    )


def _by_weights(scaled: _Scaled, *, derivatives: bool) -> _Marginal:
    """Return the log density of the mean readings, computed from the covariance matrix (j, j) of
    the j weights of the functions, with terms of its derivatives if ``derivatives``.

    The covariance of the cells is a sum of the noise, the local part and a matrix of low rank
    (Rasmussen and Williams 2006, eq. A.9 and A.10).
    """
    data, y = scaled.data, scaled.values
    weighted = scaled.removed(scaled.rows)
    matrix, moment = _normal(scaled, weighted)
    matrix, factor = cholesky_factor(matrix)
    total, local = scaled.total, scaled.local
    log_determinant = (
        -float(np.sum(np.log(scaled.precision)))
        + float(np.sum(np.log1p(local * total)))
        + 2.0 * float(np.sum(np.log(np.diag(factor))))
    )
    mean = np.linalg.solve(matrix, moment)
    log = -0.5 * (log_determinant + float(y @ scaled.removed(y) - moment @ mean))
    if not derivatives:
        return _Marginal(log=log, residual=_NONE, by_weight=_NONE, by_target=_NONE, by_cell=_NONE)
    inverse = inverse_triangle(factor)
    spread = inverse @ weighted.T
    seen = np.add.reduceat(spread, data.starts, axis=1)
    gain = local / (1.0 + local * total)
    own = scaled.precision - gain[data.target_index] * scaled.precision**2
    return _Marginal(
        log=log,
        residual=scaled.removed(y - scaled.rows @ mean),
        by_weight=mean**2 + np.sum(inverse**2, axis=0) - 1.0,
        by_target=total / (1.0 + local * total) - np.sum(seen**2, axis=0),
        by_cell=own - np.sum(spread**2, axis=0),
    )


def _normal(scaled: _Scaled, weighted: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the precision matrix (j, j) and right side (j,) of the normal equations for the
    weights, which have unit prior variance. ``weighted``: the model matrix times the inverse
    covariance of noise and local part.
    """
    matrix = scaled.rows.T @ weighted
    matrix.flat[:: matrix.shape[0] + 1] += 1.0
    return matrix, weighted.T @ scaled.values
