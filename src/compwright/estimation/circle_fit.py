"""Weighted least squares of a circular test, with a choice of its model columns.

The weights are the inverse of the noise spectra of the residuals. The covariance and the evidence
of a fit follow from its normal equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.estimation.circle_equations import CircleProblem, scaled_inverse
from compwright.estimation.circle_noise import IndexArray, ResidualSpectrum, estimate_spectrum
from compwright.estimation.circle_products import turned
from compwright.records.axis import FloatArray


@dataclass(frozen=True, slots=True)
class WeightedProblem:
    """The normal equations of a circular test, weighted by the noise spectra of its residuals:
    matrix ``gram`` (k, k), without the priors of the causes, and right side ``right`` (k,).
    """

    problem: CircleProblem
    spectra: tuple[ResidualSpectrum, ...]
    gram: FloatArray
    right: FloatArray

    def posterior(self, active: IndexArray, precision: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return mean (a,) and covariance (a, a) of the sizes of the ``active`` causes, if all
        other causes are 0. ``precision`` (k,): prior precisions of all columns.
        """
        normal = self.gram[np.ix_(active, active)] + np.diag(precision[active])
        covariance = scaled_inverse(normal)
        return covariance @ self.right[active], covariance


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleFit:
    """The least-squares solution of a circular test for one choice of spike shapes.

    ``values`` (a,): sizes of the ``active`` columns (a,), with ``covariance`` (a, a).
    ``information`` (a,): information about each column alone. Three attributes have one entry for
    the sum and one for the difference of the directions: the columns ``rows`` (size, a), the
    residuals ``rest`` (size,), mm, and the noise ``spectra``.
    """

    active: IndexArray
    values: FloatArray
    covariance: FloatArray
    information: FloatArray
    rows: tuple[FloatArray, ...]
    rest: tuple[FloatArray, ...]
    spectra: tuple[ResidualSpectrum, ...]


def fit_causes(weighted: WeightedProblem, active: IndexArray, precision: FloatArray) -> CircleFit:
    """Return the least-squares solution with the ``active`` causes only. ``precision`` (k,): prior
    precisions of all causes.
    """
    values, covariance = weighted.posterior(active, precision)
    problem = weighted.problem
    rows = problem.rows_of(active)
    return CircleFit(
        active=active,
        values=values,
        covariance=covariance,
        information=np.diag(weighted.gram)[active],
        rows=rows,
        rest=tuple(aim - half @ values for aim, half in zip(problem.aims, rows, strict=True)),
        spectra=weighted.spectra,
    )


def fit_evidence(found: CircleFit, precision: FloatArray) -> float:
    """Return the log probability of the readings under a fit, averaged over sizes of the causes.

    Sizes are integrated under normal priors with ``precision`` (k,); the noise spectra are fixed
    (Whittle 1953; MacKay, Neural Computation 4, 1992).
    """
    prior = precision[found.active]
    unit = np.sqrt(prior)
    volume = np.linalg.slogdet(found.covariance * np.outer(unit, unit))[1]
    noise = sum(
        float(np.sum(np.log(spectrum.density) + rest**2 / spectrum.density))
        for rest, spectrum in zip(found.rest, found.spectra, strict=True)
    )
    return float(0.5 * volume - 0.5 * np.sum(prior * found.values**2) - 0.5 * noise)


def weighted_problem(
    problem: CircleProblem, spectra: tuple[ResidualSpectrum, ...], only: IndexArray | None = None
) -> WeightedProblem:
    """Return the weighted normal equations. They are zero for columns not in ``only``, if given."""
    if only is not None:
        gram, right = np.zeros((problem.widths.size,) * 2), np.zeros(problem.widths.size)
        gram[np.ix_(only, only)], right[only] = normal_equations(
            problem, spectra, problem.rows_of(only)
        )
        return WeightedProblem(problem, spectra, gram, right)
    halves = [
        _normal(problem, half, problem.products.weights(spectrum.density))
        for half, spectrum in enumerate(spectra)
    ]
    return _of_halves(problem, spectra, halves)


def normal_equations(
    problem: CircleProblem,
    spectra: tuple[ResidualSpectrum, ...],
    columns: Sequence[FloatArray],
) -> tuple[FloatArray, FloatArray]:
    """Return the weighted normal equations (a, a) and (a,) of the ``columns`` (size, a) of the sum
    and the difference of the directions.
    """
    gram, right = np.zeros((columns[0].shape[1],) * 2), np.zeros(columns[0].shape[1])
    for half, aim, spectrum in zip(columns, problem.aims, spectra, strict=True):
        root = 1.0 / np.sqrt(spectrum.density)
        rows = half * root[:, np.newaxis]
        gram += rows.T @ rows
        right += rows.T @ (aim * root)
    return gram, right


def _normal(
    problem: CircleProblem, half: int, weights: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the normal equations (k, k) and (k,) of the sum (``half`` 0) or the difference (1) of
    the directions, in the curves of `CircleProblem`.
    """
    aim = problem.aims[half] * weights
    columns = (problem.rows[half], *turned(problem.curves)[half])
    return problem.products.gram(half, weights), np.concatenate([c.T @ aim for c in columns])


def _of_halves(
    problem: CircleProblem,
    spectra: tuple[ResidualSpectrum, ...],
    halves: Sequence[tuple[FloatArray, FloatArray]],
) -> WeightedProblem:
    gram, right = (np.sum(parts, axis=0) for parts in zip(*halves, strict=True))
    spiked = problem.spiked
    return WeightedProblem(problem, spectra, spiked(spiked(gram).T), spiked(right))


def white_problems(problem: CircleProblem) -> Iterator[WeightedProblem]:
    """Yield the equations for several levels of white noise in the samples: the starts of the fit.
    The standard deviations are 1 µm, that of the upper half of the transform's orders, and the
    geometric mean of both.
    """
    loud = np.full(len(problem.aims), 1e-6)
    upper = [aim[aim.size // 2 :] ** 2 for aim in problem.aims]
    # The median of a chi-square of one degree of freedom is 0.455.
    quiet = np.clip([np.median(power) / 0.455 for power in upper], 1e-14, 1e-6)
    halves = [_normal(problem, i, np.ones(aim.size)) for i, aim in enumerate(problem.aims)]
    for level in (loud, np.sqrt(loud * quiet), quiet):
        spectra = tuple(ResidualSpectrum(np.full(problem.grid.size, v), 1.0) for v in level)
        weighted = [(g / v, r / v) for (g, r), v in zip(halves, level, strict=True)]
        yield _of_halves(problem, spectra, weighted)


def residual_spectra(found: CircleFit) -> tuple[ResidualSpectrum, ...]:
    """Return the noise spectra from the residuals of a fit. The leverage of each order of the
    transform is its diagonal element of the hat matrix (Belsley, Kuh and Welsch, Regression
    Diagnostics, 1980, chapter 2).
    """
    spectra = []
    for rows, rest, spectrum in zip(found.rows, found.rest, found.spectra, strict=True):
        leverage = np.sum(found.covariance @ rows.T * rows.T, axis=0) / spectrum.density
        spectra.append(estimate_spectrum(rest, leverage))
    return tuple(spectra)


def fitted_path(problem: CircleProblem, fitted: CircleFit) -> FloatArray:
    """Return the deviation of each sample that the causes of a fit explain, mm (n,)."""
    sizes = np.zeros((1, problem.widths.size))
    sizes[0, fitted.active] = fitted.values
    path: FloatArray = fitted_paths(problem, sizes)[0]
    return path


def fitted_paths(problem: CircleProblem, sizes: FloatArray) -> FloatArray:
    """Return the deviations, mm (s, n), that causes of ``sizes`` (s, k) explain."""
    count = len(problem.names)
    paths: FloatArray = sizes[:, :count] @ problem.slopes.T
    shape = len(sizes), -1, len(problem.reversals), problem.mixture.shape[1]
    signs: tuple[float | FloatArray, ...] = (1.0, problem.samples.sense)
    if problem.mixture.size:
        halves = np.swapaxes(sizes[:, count:].reshape(shape), 0, 1)
        for sign, half in zip(signs, halves, strict=False):
            paths += sign * problem.spike_curves(half)
    return paths
