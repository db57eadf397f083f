"""Evidence for steps of the error between neighbouring targets, and for outliers at single targets.

Whole sets of steps and outliers are compared, because two steps hide each other if only one is
tried.

The model of the means is a straight line, a smooth error, an error that is independent from target
to target, and noise. Each member of a set, a step or an outlier, adds a term of normally
distributed size. All sizes and lengths are averaged over (Kass and Raftery, Bayes Factors, J. Am.
Stat. Assoc. 90, 1995).

Members are added in closed form, one after the other (sweep operator: Goodnight, A Tutorial on the
SWEEP Operator, American Statistician 33, 1979; Rasmussen and Williams, Gaussian Processes for
Machine Learning, 2006, sections 2.7 and 5.2). One or two members are added, or one is removed, as
long as the set becomes more probable (Miller, Subset Selection in Regression, 2nd ed. 2002, chapter
3).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import BoolArray

#: Steps and outliers of an axis before the data, a judgement: one of each in a hundred axes.
_AXES: Final = 1.0 / 100.0
#: Odds from which on a step stays in the set, as far as it is likely.
COUNTED: Final = 0.05
_LENGTHS: Final = 2.0 ** np.arange(6)  # of the smooth part, in mean distances of the targets
_LEAST: Final = 1e-4
_SMALLEST: Final = 1e-12  # mm (deg): means without any scatter on a straight line have some noise
_SIZES: Final = 6
_LOCAL: Final = 4
_STEPS: Final = 2
#: Members of a set: one for so many targets.
_TARGETS_EACH: Final = 4
#: Sizes and lengths that are less probable than the best by this (logarithm), with any set.
_NEGLIGIBLE: Final = 14.0
_ROUNDED: Final = 6  # decimals of logarithms that are compared


@dataclass(frozen=True, slots=True)
class FoundStep:
    """A step of the error between the target with index ``gap`` and the next one: its ``size``,
    standard deviation ``std``, and ``odds`` that it exists.
    """

    gap: int
    size: float
    std: float
    odds: float


class StepEvidence:
    """Calculator of the evidence for steps in means ``y`` (k,) at ascending positions ``x`` (k,).

    ``stds`` (k,): standard deviations of the noise of the means. ``gaps``: number of intervals
    between targets of the whole axis. The possible members of a set are numbered. First are the
    steps, one for each interval; then the outliers, one for each inner target. An outlier at an end
    target is the same as a step.
    """

    def __init__(self, x: FloatArray, y: FloatArray, stds: FloatArray, gaps: int) -> None:
        self.steps = x.size - 1
        self.most = x.size // _TARGETS_EACH
        self.prior = float(np.log(_AXES / gaps))
        straight = np.column_stack([np.ones_like(x), (x - x.mean()) / np.ptp(x)])
        rough = y - straight @ np.linalg.lstsq(straight, y, rcond=None)[0]
        # Below a ten-thousandth of what is there the covariance would not be positive any more.
        stds = np.maximum(stds, max(_LEAST * float(np.ptp(rough)), _SMALLEST))
        noise = float(np.sqrt(np.mean(stds**2)))
        largest = max(float(np.ptp(rough)), 2.0 * noise)
        free = (10.0 * largest) ** 2 * (straight @ straight.T) + np.diag(stds**2)
        smooth = _smooth(x, np.geomspace(0.1 * noise, 3.0 * largest, _SIZES)) + free
        behind = np.subtract.outer(np.arange(x.size), np.arange(self.steps)) > 0
        sides = np.column_stack([rough, behind - 0.5, np.eye(x.size)[:, 1:-1]])
        plain, products = [], []
        for std in np.append(0.0, np.geomspace(noise, largest, _LOCAL)):
            factor = np.linalg.cholesky(smooth + std**2 * np.eye(x.size))
            white = np.linalg.solve(factor, np.broadcast_to(sides, (len(factor), *sides.shape)))
            plain.append(-np.sum(np.log(np.diagonal(factor, axis1=1, axis2=2)), axis=1))
            products.append(np.swapaxes(white, 1, 2) @ white)
        variances = np.geomspace(3.0 * noise, 3.0 * largest, _STEPS) ** 2
        self._keep(np.concatenate(plain), np.concatenate(products), variances)

    def _keep(self, volumes: FloatArray, products: FloatArray, variances: FloatArray) -> None:
        """Keep only the sizes and lengths of the smooth error that are reasonably probable,
        combined with each of the ``variances`` of steps.
        """
        plain = volumes - 0.5 * products[:, 0, 0]
        kept = volumes > np.max(plain) - _NEGLIGIBLE
        self.variances = np.tile(variances, int(np.sum(kept)))
        self.plain = np.repeat(plain[kept], variances.size)
        self.products = np.repeat(products[kept], variances.size, axis=0)

    def found(self) -> list[FoundStep]:
        """Return the probable steps, each with the index of its gap between targets."""
        every = np.ones(self.products.shape[1] - 1, dtype=np.bool_)
        best = self._best((), every)
        while True:
            steps = [one for one in best if one < self.steps]
            odds = {one: self._odds(best, one) for one in steps}
            weakest = min(steps, key=lambda one: odds[one], default=None)
            if weakest is None or odds[weakest] >= COUNTED:
                return self._sized(best, odds)
            best = tuple(one for one in best if one != weakest)

    def _odds(self, members: tuple[int, ...], one: int) -> float:
        """Return the odds of the set ``members`` against the best set that lacks ``one``."""
        others = np.arange(self.products.shape[1] - 1) != one
        without = tuple(each for each in members if each != one)
        rivals = (without, self._best((), others))
        log = self._log(members) - max(self._log(rival) for rival in rivals)
        return float(np.exp(min(log, 100.0)))

    def _log(self, members: tuple[int, ...]) -> float:
        """Return the log probability of a set of steps and outliers, up to a constant."""
        weights = self._swept(tuple(range(len(members))), self._of(members))[0]
        log = float(_total(weights)) + self.prior * len(members)
        return round(log, _ROUNDED)

    def _best(self, members: tuple[int, ...], allowed: BoolArray) -> tuple[int, ...]:
        """Return the most probable set of steps and outliers that can be reached from ``members``
        by single changes; only those marked in ``allowed`` (e,) are added.

        Here each member of a set adds -log `COUNTED` to its log probability, so that members of low
        odds are found too.
        """
        bonus = -float(np.log(COUNTED))
        score = self._log(members) + bonus * len(members)
        while True:
            moves = [self._more(members, allowed)]
            moves += [tuple(one for one in members if one != each) for each in members]
            rated = [(self._log(each) + bonus * len(each), each) for each in moves]
            top, move = max(rated)
            if top <= score:
                return members
            members, score = move, top

    def _more(self, members: tuple[int, ...], allowed: BoolArray) -> tuple[int, ...]:
        """Return ``members`` with the one or two most probable further steps or outliers marked in
        ``allowed``.
        """
        room = self.most - len(members)
        free = np.flatnonzero(allowed)
        free = free[~np.isin(free, members)]
        if room < 1 or not free.size:
            return members
        weights, left = self._swept(members, self.products)
        along = left[:, 0, 1:][:, free]
        own = np.diagonal(left, axis1=1, axis2=2)[:, 1:][:, free] + 1.0 / self.variances[:, None]
        gains = _gain(along, own, self.variances[:, None])
        single = _total(weights[:, None] + gains)
        best = int(np.argmax(np.round(single, _ROUNDED)))
        more = (*members, int(free[best]))
        if room < 2 or free.size < 2:
            return tuple(sorted(more))
        one, two = np.triu_indices(free.size, 1)
        shared = left[:, 1 + free[one], 1 + free[two]] / own[:, one]
        along_two = along[:, two] - shared * along[:, one]
        own_two = own[:, two] - shared**2 * own[:, one]
        both = gains[:, one] + _gain(along_two, own_two, self.variances[:, None])
        pairs = _total(weights[:, None] + both)
        pair = int(np.argmax(np.round(pairs, _ROUNDED)))
        if pairs[pair] + self.prior - np.log(COUNTED) > single[best]:
            more = (*members, int(free[one[pair]]), int(free[two[pair]]))
        return tuple(sorted(more))

    def _swept(
        self, members: tuple[int, ...], products: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return the log evidence for the steps ``members``, and the scalar ``products`` after
        these steps are eliminated from them. Both are given for every size and length of the smooth
        error.
        """
        weights, left = self.plain, products
        for one in members:
            row = left[:, 1 + one]
            own = row[:, 1 + one] + 1.0 / self.variances
            weights = weights + _gain(row[:, 0], own, self.variances)
            left = left - row[:, :, None] * row[:, None, :] / own[:, None, None]
        return weights, left

    def _of(self, members: tuple[int, ...]) -> FloatArray:
        """Return the scalar products between the means and the columns of the set ``members``."""
        own = (0, *(1 + one for one in members))
        return self.products[:, own][:, :, own]

    def _sized(self, members: tuple[int, ...], odds: dict[int, float]) -> list[FoundStep]:
        """Return the steps of a set with their sizes, averaged over all variances and lengths."""
        steps = []
        for one, mine in odds.items():
            others = tuple(each for each in members if each != one)
            weights, left = self._swept(tuple(range(len(others))), self._of((*others, one)))
            own = left[:, -1, -1] + 1.0 / self.variances
            along = left[:, 0, -1]
            logs = weights + _gain(along, own, self.variances)
            shares = np.exp(logs - np.max(logs))
            shares = shares / np.sum(shares)
            mean = float(shares @ (along / own))
            variance = float(shares @ (1.0 / own + (along / own) ** 2)) - mean**2
            steps.append(FoundStep(one, mean, float(np.sqrt(max(variance, 0.0))), mine))
        return steps


def _gain(along: FloatArray, own: FloatArray, variances: FloatArray) -> FloatArray:
    """Return how much one further step or outlier of each of the ``variances`` increases the log
    probability of the means. ``along`` and ``own``: its products with the means and with itself.
    """
    return np.asarray(0.5 * along**2 / own - 0.5 * np.log(variances * own))


def _total(logs: FloatArray) -> FloatArray:
    """Return the logarithm of the sum over the first axis of values given as logarithms."""
    top = np.max(logs, axis=0)
    return np.asarray(top + np.log(np.sum(np.exp(logs - top), axis=0)))


def _smooth(x: FloatArray, stds: FloatArray) -> FloatArray:
    """Return the covariances (n, k, k) at positions ``x`` (k,) of smooth errors of every tried
    length and each standard deviation ``stds``.
    """
    apart = np.abs(np.subtract.outer(x, x)) / (np.ptp(x) / (x.size - 1))
    scaled = apart / _LENGTHS[:, np.newaxis, np.newaxis]
    near = np.sqrt(3.0) * scaled
    shapes = np.concatenate([(1.0 + near) * np.exp(-near), np.exp(-0.5 * scaled**2)])
    every: FloatArray = stds[:, np.newaxis, np.newaxis, np.newaxis] ** 2 * shapes
    return every.reshape(-1, x.size, x.size)
