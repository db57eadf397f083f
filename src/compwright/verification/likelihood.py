"""The likelihood of the mean readings of a test under assumed curves of the deviation.

    mean of cell i = deviation before + change of the correction + datum (+ slope) + noise

The deviation before loading has a normal distribution (`ErrorBelief`). The noise is a mixture of
equally probable draws (`AfterMeans`). The datum of an axis is common to both directions and has a
flat prior; values of a circular test have none.
All other unknowns have normal priors and are integrated (Rasmussen and Williams, Gaussian Processes
for Machine Learning, 2006, section 2.7).

A covariance is the sum of blocks for both directions at one target and of a matrix of low rank
(Woodbury; Golub and Van Loan, Matrix Computations, 4th ed. 2013, section 2.1.4). Therefore time and
memory grow in proportion to the number of targets. All lengths are in mm or deg.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.noise import infer_noise
from compwright.estimation.observed_test import traverse_columns
from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import NoiseDraws
from compwright.records.positioning import PositioningTest

#: Most directions in which a belief hangs together over the travel; the rest is left to each
#: target.
_RANK: Final = 60
#: Most numbers that the draws of a belief may hold.
_NUMBERS: Final = 4_000_000
_MOST_DRAWS: Final = 2000
#: Repeated readings that are all equal show the instrument's resolution, not a perfect axis.
_LEAST_NOISE: Final = {AxisKind.LINEAR: 1e-5, AxisKind.ROTARY: 1e-6}
#: Draws of the noise beyond which nothing changes, and where there are many targets.
_DRAWS: Final = 16
_FEW: Final = 6
_MANY_CELLS: Final = 800


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorBelief:
    """The expected deviation at m targets, as a normal distribution in both directions.

    ``mean`` (2, m): in + and -. The covariance is ``root`` root', with ``root`` (2, m, r), plus
    ``blocks`` (m, 2, 2), one of both directions for each target.
    """

    mean: FloatArray
    root: FloatArray
    blocks: FloatArray

    def turned(self) -> ErrorBelief:
        """Return the expected deviation with + and − exchanged."""
        return ErrorBelief(
            mean=self.mean[::-1], root=self.root[::-1], blocks=self.blocks[:, ::-1, ::-1]
        )

    def scaled(self, factor: float) -> ErrorBelief:
        """Return the expected deviation multiplied by ``factor``."""
        return ErrorBelief(
            mean=factor * self.mean, root=factor * self.root, blocks=factor**2 * self.blocks
        )


def draws_for(targets: int) -> int:
    """Return the number of random draws that is used for this number of ``targets``."""
    return int(np.clip(_NUMBERS // max(2 * targets, 1), 400, _MOST_DRAWS))


def belief_of(positive: FloatArray, negative: FloatArray) -> ErrorBelief:
    """Return the normal distribution of the deviation, from random draws (n, m) in + and in −."""
    both = np.hstack([positive, negative])
    mean = both.mean(axis=0)
    left = (both - mean) / math.sqrt(max(both.shape[0] - 1, 1))
    narrow = both.shape[1] <= both.shape[0]
    values, vectors = np.linalg.eigh(left.T @ left if narrow else left @ left.T)
    largest = np.argsort(values)[::-1][: min(_RANK, both.shape[1])]
    largest = largest[values[largest] > 1e-12 * max(float(values.max()), 1e-300)]
    size = np.sqrt(values[largest])
    # of the covariance itself, or from the products of the draws
    root = vectors[:, largest] * size if narrow else left.T @ vectors[:, largest]
    rest = left - (left @ (root / size**2)) @ root.T
    up, down = np.split(rest, 2, axis=1)
    m = positive.shape[1]
    blocks = np.empty((m, 2, 2))
    blocks[:, 0, 0], blocks[:, 1, 1] = np.sum(up**2, axis=0), np.sum(down**2, axis=0)
    blocks[:, 0, 1] = blocks[:, 1, 0] = np.sum(up * down, axis=0)
    return ErrorBelief(
        mean=mean.reshape(2, m), root=root.reshape(2, m, largest.size), blocks=blocks
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class AfterMeans:
    """The mean readings of a test at m targets, under each of J equally probable draws of its
    noise.

    - ``mean``, ``precision`` (J, 2, m): weighted means and their inverse variances, 0 if there is
      no reading.
    - ``columns`` (J, 2, m, q): q patterns of noise that the means have in common, each of unit
      variance.
    - ``plain`` (2, m): the means as defined in the standard, NaN if there is none.
    - ``sigma``: standard deviation of one reading. ``readings``: their mean number per target and
      direction. ``targets`` (m,). ``datum``: whether an unknown constant is in all means.
    """

    targets: FloatArray
    kind: AxisKind
    plain: FloatArray
    mean: FloatArray
    precision: FloatArray
    columns: FloatArray
    sigma: float
    readings: float
    datum: bool = True

    @property
    def used(self) -> FloatArray:
        """A mask (2, m): 1 where there is a mean reading, else 0."""
        return np.isfinite(self.plain).astype(np.float64)

    @property
    def count(self) -> int:
        """The number of mean readings, counting each target in each measured direction."""
        return int(np.sum(np.isfinite(self.plain)))

    @property
    def std_error(self) -> float:
        """The standard error of the difference of two mean readings, s √(2/n), mm or deg."""
        return self.sigma * math.sqrt(2.0 / self.readings)


def after_means(test: PositioningTest, fallback: NoiseDraws) -> AfterMeans:
    """Return the mean readings of a ``test``, with its noise estimated from its own readings if
    these are enough, else with the noise ``fallback`` of another test of the axis.
    """
    blocks = (test.positive, test.negative)
    plain = np.stack([_means(block) for block in blocks])
    counts = np.stack([count_readings(block) for block in blocks])
    own = infer_noise(test)
    if own is None:
        return _as_before(test, plain, counts, fallback)
    m, floor = test.targets.size, _LEAST_NOISE[test.kind]
    taken = _evenly(own.mean.shape[0], m)
    return AfterMeans(
        targets=test.targets,
        kind=test.kind,
        plain=plain,
        mean=own.mean[taken].reshape(taken.size, 2, m),
        precision=np.minimum(own.precision[taken].reshape(taken.size, 2, m), counts / floor**2),
        columns=own.columns[taken].reshape(taken.size, 2, m, -1),
        sigma=max(own.sigma, floor),
        readings=float(counts[counts > 0].mean()),
    )


def _evenly(count: int, targets: int) -> NDArray[np.intp]:
    """Return the indices of evenly spaced draws out of ``count`` draws; with more ``targets`` fewer
    draws are used.
    """
    most = _FEW if 2 * targets > _MANY_CELLS else _DRAWS
    return np.unique(np.linspace(0, count - 1, min(most, count)).astype(np.intp))


def _means(block: FloatArray) -> FloatArray:
    return mean_deviation(block) if block.size else np.full(block.shape[0], np.nan)


def _as_before(
    test: PositioningTest, plain: FloatArray, counts: FloatArray, noise: NoiseDraws
) -> AfterMeans:
    """Return the mean readings ``plain`` (2, m) of a ``test``, each made of ``counts`` (2, m)
    readings, with the ``noise`` that was estimated from an earlier test of the same axis.
    """
    m = test.targets.size
    taken = noise.taken(_evenly(noise.count, m))
    floor = _LEAST_NOISE[test.kind]
    # Student's law has the variance dof / (dof - 2); below three degrees that of three is taken
    dof = np.maximum(taken.dof, 3.0)
    tails = np.divide(dof, dof - 2.0, out=np.ones_like(dof), where=np.isfinite(dof))
    core = taken.core**2
    far = taken.outlier_size**2 - np.where(taken.outlier_fixed, 0.0, core)
    tails = tails + core - 1.0 + taken.outlier_share * far
    scale = np.maximum(taken.scale_at(test.targets), floor)
    variance = scale**2 * tails[:, np.newaxis, np.newaxis]
    signs = np.repeat([1.0, -1.0], m)
    columns = traverse_columns(taken, np.tile(test.targets, 2), signs)
    runs = float(counts[counts > 0].mean()) if np.any(counts > 0) else 1.0
    return AfterMeans(
        targets=test.targets,
        kind=test.kind,
        plain=plain,
        mean=np.broadcast_to(np.where(np.isfinite(plain), plain, 0.0), (taken.count, 2, m)),
        precision=counts / variance,
        columns=columns.reshape(taken.count, 2, m, -1) / math.sqrt(runs),
        sigma=float(np.exp(np.mean(np.log(np.sqrt(np.mean(variance, axis=(1, 2))))))),
        readings=runs,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Curves:
    """H curves of the deviation that a test may show, each as the difference from the expected
    deviation, mm or deg.

    ``change`` (2, m, H): the correction minus the one that the expected deviation contains.
    ``free``: for the number of a curve, a pattern (2, m) that is added with an unknown standard
    normal factor. ``slack`` (H,): standard deviation of the factor on the change.
    """

    change: FloatArray
    free: Mapping[int, FloatArray]
    slack: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class Fits:
    """How well each of H curves fits a test: its log likelihood, its residual, the fitted slope,
    and the fitted unknown amount (such as an unknown factor on the table).

    ``log_likelihood`` (H,): that of the means, integrated over all unknowns. ``score`` (H,): the
    size of the residual, as the standard normal value that is equally improbable. ``slope`` (H, 2):
    slope of the test relative to the curve, with its standard error, mm/mm. ``amount`` (H, 2): the
    unknown amount with its standard error, both 0 if there is none.
    """

    log_likelihood: FloatArray
    score: FloatArray
    slope: FloatArray
    amount: FloatArray


def fits_of(
    after: AfterMeans,
    belief: ErrorBelief,
    curves: Curves,
    declared_slope: float,
    more: Sequence[float] = (0.0,),
) -> Fits:
    """Return how well ``belief`` plus each of the H ``curves`` fits the test ``after``, for each of
    the standard deviations ``more`` of an additional slope: all curves with the first one, then all
    with the next.

    ``declared_slope``: standard deviation of the slope, mm/mm, by which every test may differ.
    """
    draws = [
        _one_noise(after, belief, curves, declared_slope, more, j) for j in range(len(after.mean))
    ]
    log = np.stack([each.log_likelihood for each in draws])
    top = log.max(axis=0)
    weights = np.exp(log - top)
    total = weights.sum(axis=0)
    weights = weights / total
    slope = np.sum(weights[..., np.newaxis] * np.stack([each.slope for each in draws]), axis=0)
    amount = np.sum(weights[..., np.newaxis] * np.stack([each.amount for each in draws]), axis=0)
    return Fits(
        log_likelihood=top + np.log(total / len(draws)),
        score=np.sum(weights * np.stack([each.score for each in draws]), axis=0),
        slope=slope,
        amount=amount,
    )


def _one_noise(
    after: AfterMeans,
    belief: ErrorBelief,
    curves: Curves,
    declared_slope: float,
    more: Sequence[float],
    j: int,
) -> Fits:
    """Return how well each curve fits the test under the noise draw with index ``j``, for each of
    the standard deviations ``more`` of an additional slope, as `fits_of` does for all draws.
    """
    used = after.used
    along = np.broadcast_to(_along(after), used.shape)
    columns = np.concatenate(
        [belief.root, after.columns[j], declared_slope * along[..., np.newaxis]], axis=2
    )
    white = _Whitener.of(after.precision[j], used, belief.blocks, columns)
    datum = white(np.ones((*used.shape, 1)))[:, : int(after.datum)]
    length = float(np.sum(datum**2)) if after.datum else 1.0
    unit = datum / math.sqrt(length)

    def seen(values: FloatArray) -> FloatArray:
        whitened = white(values)
        whitened -= unit @ (unit.T @ whitened)
        return whitened

    change = seen(curves.change)
    left = seen((after.mean[j] - belief.mean)[..., np.newaxis]) - change
    slope = seen(along[..., np.newaxis])[:, 0]
    numbers = list(curves.free)
    free = seen(np.stack([curves.free[each] for each in numbers], axis=2)) if numbers else None
    score, inner = _products(change, left, slope, free, numbers)
    square = np.einsum("nh,nh->h", left, left)
    logs, scores = [], []
    dof = float(max(after.count - int(after.datum), 1))
    for std in more:
        scale = np.column_stack([curves.slack, np.ones(square.size), np.full(square.size, std)])
        scaled = inner * scale[:, :, np.newaxis] * scale[:, np.newaxis, :] + np.eye(3)
        own = score * scale
        chi2 = square - np.sum(own * np.linalg.solve(scaled, own[..., np.newaxis])[..., 0], axis=1)
        logs.append(-0.5 * (chi2 + np.linalg.slogdet(scaled)[1] + white.log_det + math.log(length)))
        scores.append(_score(chi2, dof))
    times = (len(more), 1)
    return Fits(
        log_likelihood=np.concatenate(logs),
        score=np.concatenate(scores),
        slope=np.tile(_estimate(slope, score[:, 2], declared_slope), times),
        amount=np.tile(_amounts(score[:, 1], inner[:, 1, 1]), times),
    )


def _products(
    change: FloatArray,
    left: FloatArray,
    slope: FloatArray,
    free: FloatArray | None,
    numbers: Sequence[int],
) -> tuple[FloatArray, FloatArray]:
    """Return the right-hand side and the matrix of the normal equations of a least-squares fit to
    the residuals ``left`` (n, H). Its three unknowns: the factor on ``change``, the amount of
    ``free``, and the factor on ``slope``.

    The right-hand side (H, 3) holds the products of the residuals with the three whitened curves,
    the matrix (H, 3, 3) those of the curves with each other. ``free`` (n, f): the curves with a
    free amount of the hypotheses ``numbers``.
    """
    count = change.shape[1]
    score, inner = np.zeros((count, 3)), np.zeros((count, 3, 3))
    score[:, 0] = np.einsum("nh,nh->h", change, left)
    score[:, 2] = slope @ left
    inner[:, 0, 0] = np.einsum("nh,nh->h", change, change)
    inner[:, 2, 2] = slope @ slope
    inner[:, 0, 2] = inner[:, 2, 0] = slope @ change
    if free is not None:
        score[numbers, 1] = np.sum(free * left[:, numbers], axis=0)
        inner[numbers, 1, 1] = np.sum(free**2, axis=0)
        inner[numbers, 0, 1] = inner[numbers, 1, 0] = np.sum(free * change[:, numbers], axis=0)
        inner[numbers, 1, 2] = inner[numbers, 2, 1] = slope @ free
    return score, inner


def _along(after: AfterMeans) -> FloatArray:
    """Return the target positions (m,) relative to their mean."""
    along: FloatArray = after.targets - after.targets.mean()
    return along


def _estimate(slope: FloatArray, score: FloatArray, declared: float) -> FloatArray:
    """Return the least-squares slope of each curve with its standard error, (H, 2), as if the
    uncertainty ``declared`` for the slope, which the noise model already includes, were unknown.
    ``score`` (H,): the products of ``slope`` with the residuals.

    a'V a = g / (1 + g s²) where V holds s² already (Sherman and Morrison).
    """
    square = float(slope @ slope)
    if square <= 0.0:
        return np.zeros((score.size, 2))
    own = 1.0 / square - declared**2
    error = math.sqrt(max(own, 1e-12 / square))
    return np.column_stack([score / square, np.full(score.size, error)])


def _amounts(score: FloatArray, square: FloatArray) -> FloatArray:
    """Return the least-squares amount of each hypothesis's free curve (such as a factor on the
    table) with its standard error, (H, 2), from the normal equations: amount = ``score`` /
    ``square``. Both are 0 for a hypothesis without a free curve.
    """
    there = square > 0.0
    safe = np.where(there, square, 1.0)
    value = np.where(there, score / safe, 0.0)
    return np.column_stack([value, np.where(there, 1.0 / np.sqrt(safe), 0.0)])


def _score(chi2: FloatArray, dof: float) -> FloatArray:
    """Return the standard normal value that is as improbable as the value ``chi2`` of chi-square.

    The cube root of chi-square is nearly normal (Wilson and Hilferty, Proc. Natl. Acad. Sci. 17,
    1931, 684).
    """
    spread = 2.0 / (9.0 * dof)
    score: FloatArray = (np.cbrt(np.maximum(chi2, 0.0) / dof) - 1.0 + spread) / math.sqrt(spread)
    return score


@dataclass(frozen=True, slots=True)
class _Whitener:
    """The inverse root of a covariance matrix, which turns correlated values into independent ones.

    The matrix is the sum of blocks and of a matrix of low rank. ``low`` (m, 3): Cholesky factors of
    the 2 x 2 blocks. ``base`` (2m, r): orthonormal. ``shrink`` (r,): the factors in these
    directions. ``log_det``: logarithm of the determinant.
    """

    low: FloatArray
    used: FloatArray
    base: FloatArray
    shrink: FloatArray
    log_det: float

    @classmethod
    def of(
        cls, precision: FloatArray, used: FloatArray, blocks: FloatArray, columns: FloatArray
    ) -> _Whitener:
        """Return the whitener of the covariance matrix ``blocks`` + 1 / ``precision`` + C C' with C
        = ``columns``, only for the means marked in ``used`` (2, m).
        """
        noise = np.where(used > 0.0, 1.0 / np.where(used > 0.0, precision, 1.0), 0.0)
        up, down = used
        first = np.where(up > 0.0, blocks[:, 0, 0] + noise[0], 1.0)
        second = np.where(down > 0.0, blocks[:, 1, 1] + noise[1], 1.0)
        between = blocks[:, 0, 1] * up * down
        l11 = np.sqrt(first)
        l21 = between / l11
        l22 = np.sqrt(second - l21**2)
        plain = cls(np.stack([l11, l21, l22]), used, np.zeros((2 * l11.size, 0)), np.zeros(0), 0.0)
        spread = plain(columns)
        values, vectors = np.linalg.eigh(spread.T @ spread)
        kept = values > 1e-12 * max(float(values.max(initial=0.0)), 1e-300)
        values = values[kept]
        base = spread @ (vectors[:, kept] / np.sqrt(values))
        log_det = 2.0 * float(np.sum(np.log(l11) + np.log(l22))) + float(np.sum(np.log1p(values)))
        return replace(plain, base=base, shrink=1.0 / np.sqrt(1.0 + values) - 1.0, log_det=log_det)

    def __call__(self, values: FloatArray) -> FloatArray:
        """Return ``values`` (2, m, c) as independent values (2m, c) of unit variance."""
        l11, l21, l22 = self.low[:, :, np.newaxis]
        up = self.used[0][:, np.newaxis] * values[0] / l11
        down = (self.used[1][:, np.newaxis] * values[1] - l21 * up) / l22
        flat = np.concatenate([up, down * self.used[1][:, np.newaxis]])
        whitened: FloatArray = flat + self.base @ (
            self.shrink[:, np.newaxis] * (self.base.T @ flat)
        )
        return whitened
