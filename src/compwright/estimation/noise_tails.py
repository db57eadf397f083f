"""The distribution of single readings: normal, Student's, normal with outliers, or light-tailed.

The standardised residuals are counted in bins. The probability of these counts under each
distribution of a list decides which distribution applies. This distribution then gives a weight to
every reading (Student's distribution as a mixture of normal distributions: Gelman et al., Bayesian
Data Analysis, 3rd ed. 2013, section 17.2; outliers of inflated or shifted scale: Box and Tiao,
Biometrika 55, 1968).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, lgamma, log, pi
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import FloatArray

#: Prior probabilities of the kinds.
_NORMAL, _LIGHT, _STUDENT, _SPREAD, _FIXED, _GROSS = 0.888, 0.03, 0.05, 0.015, 0.015, 0.002
_DOFS: Final = (2.5, 3.0, 3.5, 4.0, 5.0, 7.0, 15.0)
#: Of Student's: how probable degrees of freedom about each are, flat in their logarithm from 2 to
#: 25 (Jeffreys, Theory of Probability, 3rd ed. 1961, section 3.1); beyond nothing tells them from a
#: normal law.
_DOF_SHARES: Final = (0.126, 0.066, 0.057, 0.072, 0.114, 0.202, 0.363)
_SHARES: Final = (0.006, 0.0125, 0.025, 0.05, 0.1)
#: Sizes of outliers in scales of a reading. Chips and air put a reading off by any amount (spread);
#: a loose screw, a grain that comes and goes by about the same one each time (fixed, on either
#: side), give or take a tenth: nothing that is loose comes to rest more exactly than that.
_SIZES: Final = tuple(3.0 * 1.25**k for k in range(16))
_FIXED_SIZES: Final = tuple(3.0 * 1.2**k for k in range(19))
_FIXED_SPREAD: Final = 0.1
#: Gross errors, by any amount: a beam that was cut, a reading typed wrongly.
_GROSS_SIZES: Final = tuple(100.0 * 2.0**k for k in range(6))
#: Prior of the sizes: outliers that the instrument itself does not report.
_USUAL_SIZE: Final = 6.0
_SIZE_WIDTH: Final = 0.6
#: Light tails of unit standard deviation: shares of the variance that rests make at which an axis
#: stops on either side (share 1), or there and in the middle alike (2/3: nearly an even spread).
_RESTS: Final = {1.0: (0.35, 0.5, 0.65, 0.8, 0.9), 2.0 / 3.0: (0.6, 0.75, 0.87)}
#: Sizes of residuals that are counted together: 0.03 apart at nothing, 3 % apart far out.
_EDGES: Final = np.sinh(np.linspace(0.0, np.arcsinh(6000.0), 314))
_MIDDLES: Final = 0.5 * (_EDGES[1:] + _EDGES[:-1])


@dataclass(frozen=True, slots=True)
class Tail:
    """One possible error distribution of single readings, of unit scale.

    ``prior``: its prior probability. ``dof``: degrees of freedom of Student's distribution (inf:
    normal). ``share``: share of outliers among the readings. ``size``: their size. ``fixed``:
    whether outliers are shifted by this size to either side. ``core``: scale of the readings about
    each of these positions; below 1 for light tails.
    """

    prior: float
    dof: float = np.inf
    share: float = 0.0
    size: float = 1.0
    fixed: bool = False
    core: float = 1.0

    def log_density(self, z: FloatArray) -> FloatArray:
        """Return the log density of the distribution at ``z``."""
        if np.isfinite(self.dof):
            constant = lgamma(0.5 * (self.dof + 1.0)) - lgamma(0.5 * self.dof)
            heavy: FloatArray = (
                constant
                - 0.5 * log(self.dof * pi)
                - 0.5 * (self.dof + 1.0) * np.log1p(z**2 / self.dof)
            )
            return heavy
        together: FloatArray = np.logaddexp.reduce(self.log_parts(z), axis=0)
        return together

    def log_parts(self, z: FloatArray) -> FloatArray:
        """Return log(proportion) + log(probability density at ``z``) for low outliers, high
        outliers and normal readings, as an array (3, ...).
        """
        usual = -0.5 * (z / self.core) ** 2 - 0.5 * log(2.0 * pi) - log(self.core)
        rest = log(1.0 - self.share) if self.share < 1.0 else -inf
        off = self.log_outlier(z) if self.share > 0.0 else np.full((2, *z.shape), -inf)
        return np.concatenate([off, usual[np.newaxis] + rest])

    def log_outlier(self, z: FloatArray) -> FloatArray:
        """Return, for low and for high outliers, the logarithm of their proportion times their
        probability density at ``z`` (...), as an array (2, ...).
        """
        side = np.array([-1.0, 1.0]).reshape(2, *np.ones(z.ndim, dtype=int))
        scale = self.scale
        away = (z - side * self.size) / scale if self.fixed else np.stack([z, z]) / scale
        logs: FloatArray = log(0.5 * self.share) - 0.5 * away**2 - log(scale) - 0.5 * log(2 * pi)
        return logs

    @property
    def reach(self) -> float:
        """The root mean square of the errors within the central 99 % of the distribution."""
        density = np.exp(self.log_density(_MIDDLES)) * np.diff(_EDGES)
        inner = np.cumsum(density) <= 0.99 * np.sum(density)
        return float(np.sqrt(np.sum((density * _MIDDLES**2)[inner]) / np.sum(density[inner])))

    @property
    def scale(self) -> float:
        """The standard deviation of an outlier about its centre."""
        if self.core < 1.0:
            return self.core
        return float(np.hypot(1.0, _FIXED_SPREAD * self.size)) if self.fixed else self.size


def _outliers(kind: float, sizes: tuple[float, ...], *, fixed: bool) -> Iterator[Tail]:
    """Yield distributions with outliers of several proportions and ``sizes``. Their prior
    probabilities sum to ``kind``; ``fixed``: the outliers of a distribution are all shifted by the
    same size.
    """
    usual = np.exp(-0.5 * (np.log(np.array(sizes) / _USUAL_SIZE) / _SIZE_WIDTH) ** 2)
    usual *= kind / (len(_SHARES) * np.sum(usual))
    for share in _SHARES:
        for size, prior in zip(sizes, usual, strict=True):
            yield Tail(float(prior), share=share, size=size, fixed=fixed)


def _tails() -> tuple[Tail, ...]:
    return (
        Tail(_NORMAL),
        *(Tail(_STUDENT * share, dof=dof) for dof, share in zip(_DOFS, _DOF_SHARES, strict=True)),
        *_outliers(_SPREAD, _SIZES, fixed=False),
        *_outliers(_FIXED, _FIXED_SIZES, fixed=True),
        *(
            Tail(_GROSS / (len(_SHARES) * len(_GROSS_SIZES)), share=share, size=size)
            for share in _SHARES
            for size in _GROSS_SIZES
        ),
        *_light(),
    )


def _light() -> Iterator[Tail]:
    """Yield the distributions with light tails, all of equal prior probability."""
    count = sum(map(len, _RESTS.values()))
    for share, variances in _RESTS.items():
        for variance in variances:
            size, core = np.sqrt([variance / share, 1.0 - variance]).tolist()
            yield Tail(_LIGHT / count, share=share, size=size, fixed=True, core=core)


TAILS: Final = _tails()
_TABLE: Final = np.stack([tail.log_density(_MIDDLES) for tail in TAILS])
_LOG_PRIOR: Final = np.log([tail.prior for tail in TAILS])
#: How far the errors of each reach.
REACH: Final = np.array([tail.reach for tail in TAILS])
NORMAL, STUDENT, OUTLIERS, LIGHT = range(4)


def _kind(tail: Tail) -> int:
    if np.isfinite(tail.dof):
        return STUDENT
    if tail.share == 0.0:
        return NORMAL
    return LIGHT if tail.core < 1.0 else OUTLIERS


#: Which of them each member is.
KINDS: Final = np.array([_kind(tail) for tail in TAILS])


@dataclass(frozen=True, slots=True)
class Latent:
    """The hidden state of each reading in the sampler, as arrays (c, n): ``weights``, whether it is
    an ``outlier``, and the ``shift`` of an outlier, as a multiple of the scale.
    """

    weights: FloatArray
    shift: FloatArray
    outlier: NDArray[np.bool_]


def tail_probabilities(z: FloatArray, factors: FloatArray) -> FloatArray:
    """Return the posterior probability (tails, f) of each error distribution and each of the scale
    ``factors`` (f,), from the errors ``z`` (k,) divided by the present scale. The prior of the
    scale is 1/sigma (Gelman et al. 2013, section 3.2).
    """
    smallest = float(factors.min())
    ordered = np.minimum(np.abs(z), _MIDDLES[-1] * smallest)
    ordered.sort()
    # Above the largest error every bin is empty.
    last = int(_EDGES.searchsorted(ordered[-1:].sum() / smallest, "right")) + 1
    last = min(last, _MIDDLES.size)
    below = np.zeros((last + 1, factors.size))
    below[1:-1] = ordered.searchsorted(np.outer(_EDGES[1:last], factors))
    below[-1] = z.size
    counts = below[1:] - below[:-1]
    logs = _TABLE[:, :last] @ counts + _LOG_PRIOR[:, np.newaxis] - z.size * np.log(factors)
    chances = np.exp(logs - logs.max())
    whole: FloatArray = chances / chances.sum()
    return whole


def draw_latent(tail: Tail, z: FloatArray, rng: np.random.Generator) -> Latent:
    """Draw for each reading ``z`` (c, n) whether it is an outlier, and its weight. Source: Gelman
    et al. 2013, section 17.2.
    """
    nothing = np.zeros(z.shape)
    never = np.zeros(z.shape, dtype=np.bool_)
    if np.isfinite(tail.dof):
        drawn = rng.standard_gamma(0.5 * (tail.dof + 1.0), z.shape)
        return Latent(drawn / (0.5 * (tail.dof + z**2)), nothing, never)
    if tail.share == 0.0:
        return Latent(np.ones(z.shape), nothing, never)
    logs = tail.log_parts(z)
    lower, upper, none = np.exp(logs - np.max(logs, axis=0))
    chance = rng.random(z.shape) * (none + lower + upper)
    below, off = chance < lower, chance < lower + upper
    shift = np.where(off, np.where(below, -tail.size, tail.size), 0.0) * tail.fixed
    weights = np.where(off, tail.scale**-2.0, tail.core**-2.0)
    return Latent(weights, shift, off if tail.core == 1.0 else never)
