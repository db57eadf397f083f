"""Draw the parameters of the error model from their probability distribution (posterior) around its
peaks.

Laplace's approximation (MacKay, Information Theory, Inference, and Learning Algorithms, 2003,
chapter 27) is a normal distribution about a peak. It is wrong where the data determine a parameter
poorly, for example a length or the variance of a reversal that may be constant. Draws from a
similar distribution with heavier tails are therefore weighted with the true posterior. The mean
weight is the evidence of the model (importance sampling: Geweke, Econometrica 57, 1989). If the
posterior has several peaks, the draws come from all of them. Each draw is weighted relative to the
density of the whole mixture (Owen and Zhou, Safe and effective importance sampling, J. Am. Stat.
Assoc. 95, 2000).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.evidence import Evidence
from compwright.estimation.posterior_peaks import Peak, find_peaks
from compwright.records.axis import FloatArray

_TAIL_DOF: Final = 5.0  # of the Student distribution that proposes draws
_DECIMALS: Final = 9  # of logarithms, to which the points are rounded
_SEED: Final = 231  # by it draws of the noise are paired with hyperparameters


@dataclass(frozen=True, slots=True)
class HyperparameterDraws:
    """Equally likely draws ``values`` (d, h) of the model's parameters, and the natural logarithm
    of the model's evidence.
    """

    values: FloatArray
    log_evidence: float


def draw_hyperparameters(
    evidence: Evidence,
    starts: Sequence[FloatArray],
    *,
    proposals: int,
    draws: int,
    rng: np.random.Generator,
) -> HyperparameterDraws:
    """Return equally likely draws (draws, h) of the parameters of a model, and its log evidence.
    Both are computed from about ``proposals`` random points near the most probable parameters.

    Both come from importance sampling (Geweke, Econometrica 57, 1989), averaged over the draws of
    the noise. A posterior with one peak gets ``proposals`` points. Each further peak adds half as
    many. ``starts``: the start points of `find_peaks`. A point becomes a draw where the cumulative
    weights cross one of ``draws`` evenly spaced steps (Kitagawa, J. Comput. Graph. Stat. 5, 1996).
    """
    peaks = find_peaks(evidence, starts)
    each = (proposals + proposals * (len(peaks) - 1) // 2) // len(peaks)
    free = np.flatnonzero(evidence.prior.free)
    points = np.vstack([_points(peak, free, each, rng) for peak in peaks])
    densities = [_log_density(peak, points[:, free] - peak.place[free]) for peak in peaks]
    log_proposal = np.logaddexp.reduce(np.array(densities), axis=0) - np.log(len(peaks))
    log_weights = _log_posteriors(evidence, peaks, points) - log_proposal
    top = float(np.max(log_weights))
    weights = np.exp(log_weights - top)
    ladder = (np.arange(draws) + 0.5) / draws
    chosen = np.searchsorted(np.cumsum(weights) / np.sum(weights), ladder)
    return HyperparameterDraws(
        values=points[np.minimum(chosen, len(points) - 1)],
        log_evidence=top + float(np.log(np.mean(weights))),
    )


def _points(peak: Peak, free: NDArray[np.intp], count: int, rng: np.random.Generator) -> FloatArray:
    """Return random points (count, h) about a peak, in pairs that mirror each other at the peak.

    They follow Student's distribution. In a mean over such a pair, odd functions of the distance
    from the peak cancel (antithetic variates: Hammersley and Handscomb, Monte Carlo Methods, 1964,
    section 5.6).
    """
    normal = rng.standard_normal((count, free.size))
    normal[count // 2 :] = -normal[: count - count // 2]
    stretch = np.sqrt(_TAIL_DOF / rng.chisquare(_TAIL_DOF, count))
    points = np.tile(peak.place, (count, 1))
    scaled = normal * stretch[:, np.newaxis]
    points[:, free] = np.round(points[:, free] + scaled @ peak.root.T, _DECIMALS)
    return points


def _log_density(peak: Peak, away: FloatArray) -> FloatArray:
    """Return the log probability density (n,) with which points are drawn at the offsets ``away``
    (n, f) from a peak.
    """
    scaled = np.asarray(np.linalg.solve(peak.root, away.T).T, dtype=np.float64)
    density: FloatArray = _log_student(scaled) - np.linalg.slogdet(peak.root)[1]
    return density


def _log_posteriors(evidence: Evidence, peaks: Sequence[Peak], points: FloatArray) -> FloatArray:
    """Return the log posterior density (n,) at the ``points`` (n, h). The first of the ``peaks``
    has the first points; each peak has the same number of points.

    Each point is evaluated under one draw of the noise. Some draws of the noise make the means at
    the peaks more likely than the average draw does. This difference is subtracted, because the
    means must not change the distribution of the noise (cut posterior: Plummer, Statistics and
    Computing 25, 2015). Otherwise only a few draws of the noise would remain, by chance. A point
    and its mirror image have the same draw. All draws are used equally often, as far as the numbers
    allow.
    """
    each = points.shape[0] // len(peaks)
    half = max(each // 2, 1)
    count = evidence.data.draws
    places = np.arange(half) * count // half if half < count else np.arange(half) % count
    shuffled = np.random.default_rng(_SEED).permutation(places)
    noise = [int(draw) for draw in shuffled[np.arange(points.shape[0]) % each % half]]
    values = np.array(
        [evidence.log_posterior(point, draw) for point, draw in zip(points, noise, strict=True)]
    )
    used = sorted(set(noise))
    if len(used) == 1:
        return values
    levels = {draw: _level(evidence, peaks, draw) for draw in used}
    average = float(np.mean([levels[draw] for draw in noise]))
    cut: FloatArray = values - np.array([levels[draw] for draw in noise]) + average
    return cut


def _level(evidence: Evidence, peaks: Sequence[Peak], draw: int) -> float:
    """Return the log probability of the mean readings under one draw of the noise, summed over
    peaks (Laplace's approximation).
    """
    heights = [
        evidence.log_posterior(peak.place, draw) + np.linalg.slogdet(peak.root)[1] for peak in peaks
    ]
    return float(np.logaddexp.reduce(heights))


def _log_student(scaled: FloatArray) -> FloatArray:
    """Return the log density (n,) of a Student distribution of several dimensions at ``scaled`` (n,
    f) (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, appendix A).
    """
    from math import lgamma

    size = scaled.shape[1]
    constant = (
        lgamma(0.5 * (_TAIL_DOF + size))
        - lgamma(0.5 * _TAIL_DOF)
        - 0.5 * size * np.log(_TAIL_DOF * np.pi)
    )
    density: FloatArray = constant - 0.5 * (_TAIL_DOF + size) * np.log1p(
        np.sum(scaled**2, axis=1) / _TAIL_DOF
    )
    return density
