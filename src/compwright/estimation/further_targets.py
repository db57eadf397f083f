"""Choose the fewest further targets that show whether a possible period of the error exists.

A wave of period p adds a cos + b sin to the deviations. It can be overlooked, or taken for a wave
of another period q. Further targets are added one by one. Each time, the target is added that most
reduces this risk, averaged over all pairs of periods with their probabilities.

- V: covariance of the means at the targets, from the noise, from the smooth and the irregular part
  of the error, and from a straight line.
- W: cosines and sines of all periods at the targets. G = W' V^-1 W is the information about them
  (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, section 2.7).
- A further target adds u u' / v to G. u are its cosines and sines, and v is its variance, both
  given the other targets (block inverse, eq. A.11).
- I = G_pp - G_pq (G_qq + 1 / A²)^-1 G_qp is the information that a wave of period p exists and none
  of period q. A is the prior standard deviation of cosine and sine.
- det(1 + A² I)^(-1/2) measures the risk (coefficient of Bhattacharyya, in the choice between
  models: Chaloner and Verdinelli, Bayesian experimental design, Statistical Science 10, 1995).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.axis import AxisPosterior
from compwright.estimation.hidden_periods import AMPLITUDE
from compwright.estimation.period_candidates import PEAK
from compwright.estimation.period_likelihood import SEEN
from compwright.estimation.period_means import bidirectional_means
from compwright.records.axis import FloatArray

#: Places that are compared, and how they follow each other (the golden section: at no period).
_PLACES: Final = 120
_STEP: Final = 0.5 * (np.sqrt(5.0) - 1.0)
#: Most targets that are added; fewest in all, for a search; periods that count.
_MOST: Final = 8
_FEWEST: Final = 8
_PERIODS: Final = 40
#: With more targets no few ones help.
_MANY: Final = 60
#: The amplitude that is named is seen for periods of this share of the probability.
_SHARE: Final = 0.9
#: Standard deviation of what the readings alone decide, in that of all else.
_VAGUE: Final = 1e3
#: Information, in that before the data, below which no amplitude is seen.
_UNSEEN: Final = 1e-3
#: A target is rounded to this part of the shortest period, or less.
_ROUNDED: Final = 0.05


@dataclass(frozen=True, slots=True)
class FurtherTargets:
    """Proposed further ``targets`` (k,), ascending, and the smallest ``amplitude`` of a periodic
    error that old and new targets together show; mm or deg.
    """

    targets: FloatArray
    amplitude: float


def further_targets(posterior: AxisPosterior) -> FurtherTargets | None:
    """Return the fewest further targets that show the periods hidden from the present targets. None
    if no targets help or none are needed.

    Targets are added until at least `_FEWEST` old and new targets show a wave of amplitude
    `AMPLITUDE`, the width of its prior. At most `_MOST` targets are added.
    """
    found = posterior.hidden.periods[:_PERIODS]
    targets = posterior.cells.targets
    if not found or targets.size > _MANY:
        return None
    periods, shares = np.array(found).T
    design = _Design.of(posterior, _places(targets, periods), periods, shares)
    wanted = float(AMPLITUDE[posterior.kind])
    chosen: list[int] = []
    while len(chosen) < _MOST and (design.least() > wanted or targets.size + len(chosen) < _FEWEST):
        chosen.append(design.add_best())
    if not chosen or not np.isfinite(design.least()):
        return None
    return FurtherTargets(np.sort(design.places[chosen]), design.least())


def _places(targets: FloatArray, periods: FloatArray) -> FloatArray:
    """Return positions between the ``targets`` (m,) that are candidates for further targets.

    They are rounded to decimals that are small relative to the shortest of the ``periods``.
    """
    parts = np.mod(_STEP * np.arange(1, _PLACES + 1), 1.0)
    digits = int(np.ceil(-np.log10(_ROUNDED * float(np.min(periods)))))
    places = np.unique(np.round(targets[0] + parts * np.ptp(targets), max(digits, 0)))
    inside = places[(places >= targets[0]) & (places <= targets[-1])]
    return np.setdiff1d(inside, targets)


@dataclass(slots=True)
class _Design:
    """A choice of further targets: the candidate positions, and the information that the readings
    at the present and the added targets give about each possible period of the error.

    ``places`` (c,): candidate targets. ``covariance`` (c, c): covariance of the error at them,
    given the present and added targets. ``waves`` (c, 2 * p): cosines and sines of the p periods at
    them, given these targets. ``gram`` (2 * p, 2 * p): information about the waves; all cosines,
    then all sines. ``noise``: variance of a mean at a candidate target. ``size``: standard
    deviation of an amplitude. ``pairs`` (p, p + 1): weight of the decision between each period and
    each other period; in the last column, between the period and none.
    """

    places: FloatArray
    covariance: FloatArray
    waves: FloatArray
    gram: FloatArray
    noise: float
    size: float
    pairs: FloatArray

    @classmethod
    def of(
        cls,
        posterior: AxisPosterior,
        places: FloatArray,
        periods: FloatArray,
        shares: FloatArray,
    ) -> _Design:
        """Return the design before any target is added, with the information of the readings at the
        present targets. ``places``: candidate targets. ``shares``: probability of each of the
        possible ``periods``.
        """
        bidirectional = bidirectional_means(posterior.cells, endless=False)
        m, every = bidirectional.targets.size, np.concatenate([bidirectional.targets, places])
        length = float(np.ptp(bidirectional.targets))
        smooth, local = _smooth_covariance(posterior, every)
        variances = bidirectional.variances + local
        known = np.array([one.period for one in posterior.periods if one.named])
        free = np.column_stack([np.ones_like(every), (every - every[0]) / length])
        free = np.hstack([free, _waves(every, known)])
        vague = _VAGUE**2 * (float(np.max(np.diag(smooth))) + float(np.max(variances)))
        whole = smooth + vague * free @ free.T
        root = np.linalg.cholesky(whole[:m, :m] + np.diag(variances))
        waves = _waves(every, periods)
        across = np.linalg.solve(root, whole[:m, m:])
        seen = np.linalg.solve(root, waves[:m])
        apart = np.abs(1.0 / periods[:, np.newaxis] - 1.0 / periods) > PEAK / length
        return cls(
            places,
            whole[m:, m:] - across.T @ across,
            waves[m:] - across.T @ seen,
            seen.T @ seen,
            float(np.median(variances)),
            float(AMPLITUDE[posterior.kind]),
            shares[:, np.newaxis] * np.column_stack([apart * shares, np.ones_like(shares)]),
        )

    def least(self) -> float:
        """Return the smallest amplitude of a wave whose period the present and the added targets
        show.

        The amplitude is valid for any phase, and for most of the periods: the share `_SHARE` of
        their probability.
        """
        one, across, two = self._information(self.gram)
        smallest = 0.5 * (one + two - np.hypot(one - two, 2.0 * across))
        worst = np.min(np.where(self.pairs > 0.0, smallest, np.inf), axis=1)
        order = np.argsort(-np.round(worst * self.size**2, 6), kind="stable")
        shares = self.pairs[order, -1]
        last = int(np.searchsorted(np.round(np.cumsum(shares) / np.sum(shares), 9), _SHARE))
        found = float(worst[order[min(last, order.size - 1)]])
        return SEEN / float(np.sqrt(found)) if found * self.size**2 > _UNSEEN else float(np.inf)

    def add_best(self) -> int:
        """Add the candidate target that best separates the periods, and return its index."""
        variances = np.diag(self.covariance) + self.noise
        scaled = self.waves / np.sqrt(variances)[:, np.newaxis]
        grams = self.gram + scaled[:, :, np.newaxis] * scaled[:, np.newaxis]
        one, across, two = (self.size**2 * part for part in self._information(grams))
        determinant = np.maximum((1.0 + one) * (1.0 + two) - across**2, 1.0)
        open_ = np.sum(self.pairs / np.sqrt(determinant), axis=(1, 2))
        best = int(np.argmin(np.round(open_ / np.sum(self.pairs), 9)))
        row = self.covariance[best] / variances[best]
        self.gram = grams[best]
        self.waves = self.waves - np.outer(row, self.waves[best])
        self.covariance = self.covariance - variances[best] * np.outer(row, row)
        return best

    def _information(self, gram: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return the information, from the matrix ``gram`` (..., 2 p, 2 p), that separates the wave
        of each period from the wave of each other period and, in the last column, from no wave.
        Three arrays (..., p, p + 1): about the cosine, about both together (cross term), and about
        the sine.
        """
        p = len(self.pairs)
        (cc, cs), (sc, ss) = (
            (gram[..., rows, :p], gram[..., rows, p:]) for rows in (slice(p), slice(p, None))
        )
        own = [np.diagonal(part, axis1=-2, axis2=-1) for part in (cc, cs, ss)]
        a, b, c = own[0] + self.size**-2, own[1], own[2] + self.size**-2
        whole = a * c - b * b
        a, b, c = ((part / whole)[..., np.newaxis, :] for part in (a, b, c))
        taken = (
            cc * (c * cc - b * cs) + cs * (a * cs - b * cc),
            cc * (c * sc - b * ss) + cs * (a * ss - b * sc),
            sc * (c * sc - b * ss) + ss * (a * ss - b * sc),
        )
        one, both, two = (
            np.concatenate(
                [mine[..., np.newaxis] - less, mine[..., np.newaxis]],
                axis=-1,
            )
            for mine, less in zip(own, taken, strict=True)
        )
        return one, both, two


def _waves(places: FloatArray, periods: FloatArray) -> FloatArray:
    """Return the cosines, then the sines (k, 2 p) of the ``periods`` (p,) at ``places`` (k,)."""
    angle = 2.0 * np.pi * np.divide.outer(places - places[0], periods)
    return np.hstack([np.cos(angle), np.sin(angle)])


def _smooth_covariance(posterior: AxisPosterior, places: FloatArray) -> tuple[FloatArray, float]:
    """Return two prior variances of the error, mm² or deg², averaged over the parameters: the
    covariance (k, k) of the smooth part, and the variance of the part that is independent from
    target to target.
    """
    part = posterior.parts[0]
    sines = slice(2, 2 + part.basis.sines)
    logs = np.array([part.evidence.log_variances(h)[0][sines] for h in part.values])
    local = float(np.mean([part.evidence.variances(h)[1] for h in part.values]))
    columns = part.basis.halves(places)[0][:, sines]
    square = posterior.cells.data.scale**2
    return square * (columns * np.mean(np.exp(logs), axis=0)) @ columns.T, square * local
