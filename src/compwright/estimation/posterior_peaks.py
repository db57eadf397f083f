"""Maxima of the posterior probability of the model's parameters, with the width of each.

The same scatter about a straight line may have several explanations: a smooth error of short
length, an error that is independent from target to target, or a wave. The posterior then has a peak
for each (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, section 5.4.1,
figure 5.5). The peak that a search reaches depends on its start point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.evidence import Evidence
from compwright.records.axis import FloatArray

_ITERATIONS: Final = 60
_STEP_LIMIT: Final = 1.5  # largest change of a logarithm in one step
_DECIMALS: Final = 3  # of logarithms, to which peaks are rounded
_DIFFERENCE: Final = 1e-3  # of a logarithm, for the curvature from gradients
#: Peaks nearer than this, in widths of the prior, are one: on a flat ridge climbs stop apart.
_SAME: Final = 0.3
#: A peak whose mass is smaller than that of the largest by this logarithm gets no draws: of the 48
#: draws that are kept it would own one in five hundred cases.
_LOST: Final = 10.0


@dataclass(frozen=True, slots=True)
class Peak:
    """A maximum of the posterior probability at the parameters ``place`` (h,), with its width and
    weight.

    ``root`` (f, f): root of the covariance of the f free parameters at the maximum. ``log_mass``:
    logarithm of the height times the width of the peak.
    """

    place: FloatArray
    root: FloatArray
    log_mass: float


def find_peaks(evidence: Evidence, starts: Sequence[FloatArray]) -> tuple[Peak, ...]:
    """Return the different maxima of the posterior probability reached from ``starts``. Maxima of
    negligible weight are left out.

    ``starts``: arrays (k, h) of start points. One search begins at the best point of each array.
    Centre and root of a peak are rounded. Draws about a rounded peak are as good, and are then the
    same on every processor.
    """
    free = np.array(evidence.prior.free)
    found: list[Peak] = []
    for some in starts:
        place, height = maximise(evidence, _best(evidence, some))
        place = np.round(place, _DECIMALS)
        apart = [np.abs(place - peak.place)[free] / evidence.prior.width[free] for peak in found]
        if any(float(np.max(each)) < _SAME for each in apart):
            continue
        root = _rounded_rows(_spread(evidence, place))
        found.append(Peak(place, root, height + float(np.linalg.slogdet(root)[1])))
    least = max(peak.log_mass for peak in found) - _LOST
    return tuple(peak for peak in found if peak.log_mass >= least)


def _best(evidence: Evidence, starts: FloatArray) -> FloatArray:
    if len(starts) == 1:
        return np.asarray(starts[0])
    heights = np.round([evidence.log_posterior(start) for start in starts], 6)
    return np.asarray(starts[int(np.argmax(heights))])


def maximise(evidence: Evidence, start: FloatArray) -> tuple[FloatArray, float]:
    """Return the parameters (h,) at the maximum of the posterior density reached from ``start``,
    and the log of that density.

    The method is BFGS with a backtracking step of sufficient increase (Nocedal and Wright,
    Numerical Optimization, 2nd ed. 2006, algorithms 6.1 and 3.1, eq. 3.4).
    """
    free = np.array(evidence.prior.free)
    here = start.copy()
    value, gradient = evidence.with_gradient(here)
    inverse = np.diag(np.where(free, 0.25, 0.0))
    for _ in range(_ITERATIONS):
        step = inverse @ gradient
        step *= min(1.0, _STEP_LIMIT / max(float(np.abs(step).max()), 1e-300))
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
            inverse = _bfgs_update(inverse, step, change, curvature)
        here, value, gradient = here + step, new_value, new_gradient
    return here, value


def _bfgs_update(
    inverse: FloatArray, step: FloatArray, change: FloatArray, curvature: float
) -> FloatArray:
    """Return the inverse curvature matrix after one optimisation step (BFGS: Nocedal and Wright
    2006, eq. 6.17).
    """
    moved = inverse @ change
    outer = np.outer(step, moved)
    updated: FloatArray = (
        inverse
        + (1.0 + float(change @ moved) / curvature) / curvature * np.outer(step, step)
        - (outer + outer.T) / curvature
    )
    return updated


def _spread(evidence: Evidence, peak: FloatArray) -> FloatArray:
    """Return a root (f, f) of the covariance of the free parameters at a maximum, no wider than
    their prior.
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


def _rounded_rows(root: FloatArray) -> FloatArray:
    """Return a root (f, f) of a covariance with rounded rows, so that results are equal on every
    processor.

    Each row is rounded to about a thousandth of its diagonal entry, which remains positive.
    """
    step = np.exp2(np.floor(np.log2(np.diag(root))) - 10.0)[:, np.newaxis]
    rounded: FloatArray = np.round(root / step) * step
    return rounded
