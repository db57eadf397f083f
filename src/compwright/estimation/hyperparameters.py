"""Posterior of the hyperparameters: its peak, its width there, and draws corrected by their true
density.

Laplace's approximation (MacKay, Information Theory, Inference, and Learning Algorithms, 2003,
chapter 27) alone is lopsided where the data say little (a length scale, the variance of a reversal
that may be constant). Draws from a heavier-tailed version of it are therefore weighted with the
true posterior; the mean weight is the evidence of the model (importance sampling: Geweke,
Econometrica 57, 1989).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.evidence import Evidence
from compwright.records.axis import FloatArray

_ITERATIONS: Final = 60
_STEP_LIMIT: Final = 1.5  # largest change of a logarithm in one step
_TAIL_DOF: Final = 5.0  # of the Student distribution that proposes draws
_DECIMALS: Final = 3  # of logarithms, to which the proposal is rounded
_DIFFERENCE: Final = 1e-3  # of a logarithm, for the curvature from gradients
_SEED: Final = 231  # by it draws of the noise are paired with hyperparameters


@dataclass(frozen=True, slots=True)
class HyperparameterDraws:
    """``values`` (d, h) equally likely draws, and the natural logarithm of the model's evidence."""

    values: FloatArray
    log_evidence: float


def maximise(evidence: Evidence, start: FloatArray) -> tuple[FloatArray, float]:
    """Return the hyperparameters (h,) of highest posterior density and its logarithm there, from
    ``start`` uphill: BFGS with a backtracking step of sufficient increase (Nocedal and Wright,
    Numerical Optimization, 2nd ed. 2006, algorithms 6.1 and 3.1, eq. 3.4).
    """
    free = np.array(evidence.prior.free)
    here = start.copy()
    value, gradient = evidence.with_gradient(here)
    inverse = np.diag(np.where(free, 0.25, 0.0))
    for _ in range(_ITERATIONS):
        step = inverse @ gradient
        step *= min(1.0, _STEP_LIMIT / max(float(np.max(np.abs(step))), 1e-300))
        gain = float(step @ gradient)
        if gain < 1e-5:
            break
        for _ in range(12):
            new_value, new_gradient = evidence.with_gradient(here + step)
            if new_value >= value + 1e-4 * gain:
                break
            step, gain = 0.4 * step, 0.4 * gain
        else:
            break
        change = gradient - new_gradient
        curvature = float(step @ change)
        if curvature > 1e-10:
            inverse = _updated(inverse, step, change, curvature)
        here, value, gradient = here + step, new_value, new_gradient
    return here, value


def _updated(
    inverse: FloatArray, step: FloatArray, change: FloatArray, curvature: float
) -> FloatArray:
    """Return the inverse of BFGS after one step (Nocedal and Wright 2006, eq. 6.17)."""
    moved = inverse @ change
    outer = np.outer(step, moved)
    updated: FloatArray = (
        inverse
        + (1.0 + float(change @ moved) / curvature) / curvature * np.outer(step, step)
        - (outer + outer.T) / curvature
    )
    return updated


def _spread(evidence: Evidence, peak: FloatArray) -> FloatArray:
    """Return a root (f, f) of the covariance of the free hyperparameters at the peak; no wider than
    the prior.
    """
    free = np.flatnonzero(evidence.prior.free)
    hessian = np.empty((free.size, free.size))
    for row, index in enumerate(free):
        shift = np.zeros_like(peak)
        shift[index] = _DIFFERENCE
        up, down = evidence.with_gradient(peak + shift)[1], evidence.with_gradient(peak - shift)[1]
        hessian[row] = (down - up)[free] / (2.0 * _DIFFERENCE)
    width = evidence.prior.width[free]
    values, vectors = np.linalg.eigh(0.5 * (hessian + hessian.T) * np.outer(width, width))
    covariance = (vectors / np.maximum(values, 1.0)) @ vectors.T
    # The root of Cholesky is the only one with a positive diagonal: eigenvectors come in the order
    # and with the sign that the machine's own linear algebra chose.
    root: FloatArray = width[:, np.newaxis] * np.linalg.cholesky(covariance)
    return root


def draw_hyperparameters(
    evidence: Evidence, start: FloatArray, *, proposals: int, draws: int, rng: np.random.Generator
) -> HyperparameterDraws:
    """Return ``draws`` equally likely hyperparameters (draws, h) from ``start`` (h,), and the
    evidence by importance sampling with ``proposals`` points (Geweke, Econometrica 57, 1989).

    Equally likely: taken where the cumulative weights cross evenly spaced steps (Kitagawa, J.
    Comput. Graph. Stat. 5, 1996). Proposals come in mirrored pairs (antithetic variates: Hammersley
    and Handscomb, Monte Carlo Methods, 1964, section 5.6). The draws of the noise are averaged
    over.
    """
    # Any centre and any root propose; rounded they are the same on every processor, and so are the
    # draws.
    peak = np.round(maximise(evidence, start)[0], _DECIMALS)
    root = _rounded_rows(_spread(evidence, peak))
    free = np.flatnonzero(evidence.prior.free)
    normal = rng.standard_normal((proposals, free.size))
    # The second half mirrors the first: what is odd about the peak cancels, and the evidence
    # scatters less.
    normal[proposals // 2 :] = -normal[: proposals - proposals // 2]
    stretch = np.sqrt(_TAIL_DOF / rng.chisquare(_TAIL_DOF, proposals))
    points = np.tile(peak, (proposals, 1))
    scaled = normal * stretch[:, np.newaxis]
    points[:, free] = np.round(points[:, free] + scaled @ root.T, 3 * _DECIMALS)
    log_proposal = _log_student(scaled) - np.linalg.slogdet(root)[1]
    log_weights = _log_posteriors(evidence, peak, points) - log_proposal
    top = float(np.max(log_weights))
    weights = np.exp(log_weights - top)
    ladder = (np.arange(draws) + 0.5) / draws
    chosen = np.searchsorted(np.cumsum(weights) / np.sum(weights), ladder)
    return HyperparameterDraws(
        values=points[np.minimum(chosen, proposals - 1)],
        log_evidence=top + float(np.log(np.mean(weights))),
    )


def _rounded_rows(root: FloatArray) -> FloatArray:
    """Return a root (f, f), each row to about a thousandth of its diagonal entry, which is positive
    and stays so.
    """
    step = np.exp2(np.floor(np.log2(np.diag(root))) - 10.0)[:, np.newaxis]
    rounded: FloatArray = np.round(root / step) * step
    return rounded


def _log_posteriors(evidence: Evidence, peak: FloatArray, points: FloatArray) -> FloatArray:
    """Return the log posterior (n,) at ``points`` (n, h), each under a draw of the noise, less how
    likely that draw makes the means at the peak, beside the average of all draws.

    What the means say of the noise is cut off (Plummer, Statistics and Computing 25, 2015): of the
    few draws it would leave a handful, picked by the chance that moved their means. A point and
    its mirror have the same draw, and every draw as many points as any other as far as the numbers
    allow.
    """
    half = max(points.shape[0] // 2, 1)
    count = evidence.data.draws
    places = np.arange(half) * count // half if half < count else np.arange(half) % count
    shuffled = np.random.default_rng(_SEED).permutation(places)
    noise = [int(draw) for draw in shuffled[np.arange(points.shape[0]) % half]]
    values = np.array(
        [evidence.log_posterior(point, draw) for point, draw in zip(points, noise, strict=True)]
    )
    used = sorted(set(noise))
    if len(used) == 1:
        return values
    levels = {draw: evidence.log_posterior(peak, draw) for draw in used}
    average = float(np.mean([levels[draw] for draw in noise]))
    cut: FloatArray = values - np.array([levels[draw] for draw in noise]) + average
    return cut


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
