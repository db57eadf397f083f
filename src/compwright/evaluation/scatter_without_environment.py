"""Random draws of the readings that a test would have shown without environmental variation.

A reading is the position of the axis plus environmental variation of known size. The variation
increases the scatter. It also increases the parameters, because a maximum over many targets picks
the largest variation. Empirical Bayes (Efron, Large-Scale Inference, 2010, chapter 1) removes it.
The scatter about the mean of a target is divided between axis and environment. The means are moved
towards a smooth curve as far as the environment explains their roughness. The repeatability of the
axis remains. The draws cover all scatters of the axis that are compatible with the readings.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest

#: Variances that are tried, in units of the environmental variation's own.
_TRIED: Final = np.concatenate([[0.0], 4.0 ** np.arange(-3.0, 9.0)])
#: How far the variance of the axis' own scatter may differ from target to target: standard
#: deviation of its natural logarithm.
_SPREADS: Final = (0.0, 0.7, 1.4)
#: Prior weight of an axis without any scatter of its own, against all that are tried.
_STILL: Final = 0.1
#: Powers of the frequency with which the variance of a smooth curve falls: random walk, integrated
#: random walk.
_POWERS: Final = (2.0, 4.0)


def without_environment(
    test: PositioningTest, sigma: float, count: int, rng: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """Return ``count`` random draws of the readings without the environmental variation, in +
    (count, m, n) and in −; mm or deg.

    ``sigma``: standard deviation of the environmental variation, mm or deg. The variation of each
    reading is drawn separately. Missing readings are NaN.
    """
    blocks = (test.positive, test.negative)
    if sigma <= 0.0:
        still = [np.broadcast_to(block, (count, *block.shape)) for block in blocks]
        return still[0], still[1]
    m = test.targets.size
    squares, number = (
        np.concatenate([of(block) for block in blocks]) for of in (_squares, count_readings)
    )
    own = _own_variance(squares, number, sigma, count, rng)
    repeated = number > 1.0
    least = float(np.median(own[:, repeated].mean(axis=1))) if repeated.any() else None
    means = _means(test, least, sigma, count, rng)
    scatter = (
        _scatter(block, own[:, first : first + m], sigma, rng)
        for block, first in zip(blocks, (0, m), strict=True)
    )
    positive, negative = (
        mean[:, :, np.newaxis] + off for mean, off in zip(means, scatter, strict=True)
    )
    return positive, negative


def _squares(block: FloatArray) -> FloatArray:
    """Return the sum of squares (m,) of the readings about the mean at each target."""
    return np.asarray(np.nansum((block - mean_deviation(block)[:, np.newaxis]) ** 2, axis=1))


def _own_variance(
    squares: FloatArray, number: FloatArray, sigma: float, count: int, rng: np.random.Generator
) -> FloatArray:
    """Return random draws (count, k) of the variance of the axis' own scatter in each of k cells. A
    cell is one target in one direction.

    ``squares`` (k,): sum of squares of the readings about their mean. ``number`` (k,): number of
    readings. ``sigma``: standard deviation of the environmental variation. All cells share a level
    of the variance and a spread about this level. Both are drawn by their likelihood. In each cell,
    the sum of squares is chi-square times (own variance + sigma²).
    """
    tried = _TRIED * sigma**2
    total = tried + sigma**2
    degrees = np.maximum(number - 1.0, 0.0)[:, np.newaxis]
    like = -0.5 * (degrees * np.log(total) + squares[:, np.newaxis] / total)
    like = np.exp(like - like.max(axis=1, keepdims=True))
    shares = _populations()
    cells = shares[:, np.newaxis, :] * like
    evidence = np.log(np.maximum(cells.sum(axis=2), np.finfo(float).tiny)).sum(axis=1)
    evidence[0] += np.log(_STILL * (shares.shape[0] - 1))
    steps = np.cumsum(cells, axis=2)
    steps /= np.maximum(steps[:, :, -1:], np.finfo(float).tiny)
    below = steps[_drawn(evidence, count, rng)] < rng.random((count, squares.size, 1))
    return np.asarray(tried[np.minimum(below.sum(axis=2), tried.size - 1)])


def _populations() -> FloatArray:
    """Return the prior weights (h, t) of t possible variances of the axis' own scatter. Each row
    assumes one mean level of the scatter and one variation of it between targets; the first row
    assumes no scatter.
    """
    level = np.log(4.0) * np.arange(_TRIED.size)
    off = level[:, np.newaxis] - level
    shares = [np.eye(_TRIED.size)] + [np.exp(-0.5 * (off / s) ** 2) for s in _SPREADS if s > 0.0]
    stacked = np.concatenate(shares)
    return np.asarray(stacked / stacked.sum(axis=1, keepdims=True))


def _drawn(evidence: FloatArray, count: int, rng: np.random.Generator) -> NDArray[np.intp]:
    """Return ``count`` indices, drawn with probabilities in proportion to exp(``evidence``)."""
    steps = np.cumsum(np.exp(evidence - evidence.max()))
    return np.searchsorted(steps[:-1] / steps[-1], rng.random(count))


def _scatter(
    block: FloatArray, own: FloatArray, sigma: float, rng: np.random.Generator
) -> FloatArray:
    """Return random draws (count, m, n) of the scatter of the axis alone.

    ``block`` (m, n): readings, which also contain the environmental variation. ``own`` (count, m):
    draws of the variance of the axis' own scatter. ``sigma``: standard deviation of the
    environmental variation. Both scatters are taken as normal. The share own / (own + sigma²) of a
    residual then belongs to the axis. The uncertainty of this part has the variance sigma² times
    that share.
    """
    share = (own / (own + sigma**2))[:, :, np.newaxis]
    fresh = np.where(np.isfinite(block), rng.standard_normal((own.shape[0], *block.shape)), np.nan)
    fresh -= mean_deviation(fresh)[:, :, np.newaxis]
    residual = block - mean_deviation(block)[:, np.newaxis]
    return np.asarray(share * residual + sigma * np.sqrt(share) * fresh)


def _means(
    test: PositioningTest, own: float | None, sigma: float, count: int, rng: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """Return random draws (count, m) of the means in + and in − without environmental variation,
    whose standard deviation is ``sigma``. ``own``: variance of the axis' own scatter, None where no
    reading is repeated.
    """
    up, down = mean_deviation(test.positive), mean_deviation(test.negative)
    readings = np.concatenate([test.readings(direction) for direction in Direction])
    number = float(np.mean(readings[readings > 0]))

    def drawn(curve: FloatArray, share: float) -> FloatArray:
        least = None if own is None else share * own / number
        return _curve(test.targets, curve, share * sigma**2 / number, least, count, rng)

    if not test.bidirectional:
        return drawn(up, 1.0), drawn(down, 1.0)
    middle, half = drawn(0.5 * (up + down), 0.5), drawn(0.5 * (up - down), 0.5)
    return middle + half, middle - half


def _curve(
    targets: FloatArray,
    values: FloatArray,
    noise: float,
    own: float | None,
    count: int,
    rng: np.random.Generator,
) -> FloatArray:
    """Return random draws (count, m) of a mean curve without its environmental variation.

    ``values`` (m,): the mean at each of ``targets`` (m,). ``noise``: variance of the environmental
    variation of a mean. ``own``: variance of the axis' own scatter, which always remains; None if
    unknown. A straight line is subtracted first. The rest is the sum of a smooth and a rough part.
    The variance of its cosine coefficients, in the order of the targets, is a / frequency^p + w.
    The values of a, p and w are weighted by their evidence. Fewer than four values are returned
    unchanged.
    """
    drawn = np.repeat(values[np.newaxis], count, axis=0)
    known = np.isfinite(values)
    if np.count_nonzero(known) < 4:  # a straight line would leave too few to judge
        return drawn
    along = targets[known] - targets[known].mean()
    line = values[known].mean() + along * (along @ values[known]) / (along @ along)
    waves = _cosines(along.size)
    size = waves @ (values[known] - line)
    variance, prior = _curves_tried(along.size, own_known=own is not None)
    variance = (own or 0.0) + variance * noise
    total = variance + noise
    evidence = prior - 0.5 * (np.log(total) + size**2 / total).sum(axis=1)
    share = (variance / total)[_drawn(evidence, count, rng)]
    fresh = np.sqrt(noise * share) * rng.standard_normal(share.shape)
    drawn[:, known] = line + (share * size + fresh) @ waves
    return drawn


def _curves_tried(m: int, *, own_known: bool) -> tuple[FloatArray, FloatArray]:
    """Return h possible variances (h, m - 1) of the cosine coefficients of a curve, relative to the
    noise, and their log prior weights (h,).

    Each of the h models adds a smooth and a rough part (`_curve`); either part may be zero. The
    models without a smooth part have the same total weight as the models with one. The models
    without a rough part have the same total weight as the models with one if ``own_known``: the
    scatter of the axis is counted already. Otherwise they have the same total weight as the models
    with one particular size of the rough part.
    """
    frequency = 2.0 * np.sin(0.5 * np.pi * np.arange(1, m) / m)
    shapes = [frequency**-power for power in _POWERS]
    smooth = [size * shape / shape.mean() for shape in shapes for size in _TRIED[1:]]
    parts = [np.zeros(m - 1), *smooth]
    weights = [1.0, *([1.0 / len(smooth)] * len(smooth))]
    others = [1.0 / (_TRIED.size - 1)] * (_TRIED.size - 1)
    rough = [1.0 if own_known else others[0], *others]
    variance = [part + more for part in parts for more in _TRIED]
    return np.array(variance), np.log(np.outer(weights, rough)).ravel()


def _cosines(m: int) -> FloatArray:
    """Return the orthonormal cosine functions (m - 1, m) over m targets, except the constant."""
    order, target = np.arange(1, m)[:, np.newaxis], np.arange(m)
    return np.asarray(np.sqrt(2.0 / m) * np.cos(np.pi * order * (target + 0.5) / m))
