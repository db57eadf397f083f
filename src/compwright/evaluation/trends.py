"""Trends of a parameter over the years: rate of change and jumps.

Model of the tests k at times t_k (years) of one parameter:

    y_k = a + r t_k + sum of jumps before k + season(t_k) + e_k

e_k is normal. Its variance is that of the readings plus that of a scatter from test to test. This
scatter is drawn from a half-Cauchy law (Gelman, Bayesian Analysis 1 (2006) 515, section 3.2): its
variance has the F law with 1 and 1 degrees of freedom. If tests state a standard uncertainty, such
as that of the temperature, the scatter is measured in multiples of it. The variance then has the F
law with 3 and 1 degrees of freedom. A part of the uncertainty that is common to all tests changes
no rate. The tests themselves show how large the rest is.

A jump may lie between any two tests (repair, collision, another instrument). If the table was
changed, a jump is certain. The season is a sine with a period of one year. Models with and without
each jump and the season are averaged by their evidence (Kass and Raftery, J. Am. Stat. Assoc. 90
(1995) 773).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: Tests, and years between first and last, below which a rate is not estimated.
LEAST_TESTS: Final = 3
LEAST_YEARS: Final = 0.1
#: Standard deviations of the priors: rate per year, season, jumps (three sizes), certain jumps; in
#: µm, arcsec or µm/m.
_RATE: Final = 20.0
_SEASON: Final = 5.0
_JUMPS: Final = (0.7, 5.0, 35.0)
_CERTAIN: Final = 100.0
_LEVEL: Final = 1e4
#: Prior probability of a season, and the tests and years that it takes to see one.
_SEASON_PRIOR: Final = 0.2
_SEASON_TESTS: Final = 6
_SEASON_YEARS: Final = 1.0
#: A jump with this probability is reported.
_CLEAR_JUMP: Final = 0.9
_MOST_JUMPS: Final = 8
#: Prior probability from which jumps are also looked for all together.
_LIKELY: Final = 0.1
_SCATTERS: Final = 13
#: A stated uncertainty is worth so many readings: a scatter far below it is less likely.
_STATED_DOF: Final = 3.0
#: Two-sided 95 % of the normal law, for a standard error whose multiples mean what they say.
_NORMAL_95: Final = 1.959964
#: Share of the weight of all models that is kept, the weightiest first.
_KEPT: Final = 0.99995
_DRAWS: Final = 4000
_NEWTON_STEPS: Final = 60
_ROOT_2_PI: Final = math.sqrt(2.0 * math.pi)


@dataclass(frozen=True, slots=True, kw_only=True)
class TrendJump:
    """A step of a parameter between the tests with index ``before`` and ``before + 1``, and its
    ``probability``.
    """

    before: int
    size: float
    std_error: float
    probability: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Trend:
    """A rate of change per year with its standard error.

    ``std_error``: the half width of the rate's 95 % interval divided by 1.96. ``clear``: whether
    the rate is significant.
    """

    rate: float
    std_error: float
    clear: bool
    jumps: tuple[TrendJump, ...]
    _mixture: _Mixture

    def lines(self, random: np.random.Generator, ahead: float = 0.0) -> FloatArray:
        """Return draws (2, n) from the generator ``random``: level at ``ahead`` years after the
        last test, and rate per year.

        A rate that is not clear is zero in all draws. A clear rate has the weight 1 / rate, the
        prior of a size whose order of magnitude is unknown: of equal rates, those that were
        measured too large are clear more often.
        """
        level, rate = self._mixture.lines(random, grows=self.clear)
        if self.clear:
            share = 1.0 / np.maximum(np.abs(rate), self.std_error)
            kept = random.choice(_DRAWS, size=_DRAWS, p=share / share.sum())
            level, rate = level[kept], rate[kept]
        return np.stack([level + rate * ahead, rate])


def trend_of(
    years: FloatArray,
    values: FloatArray,
    errors: FloatArray,
    stated: FloatArray,
    jump_odds: Sequence[float],
    opposite: float,
) -> Trend | None:
    """Return the rate of change of a parameter, or None for fewer than three tests or less than 0.1
    years.

    ``years`` (n,): times of the tests, ascending. ``values`` (n,): the parameter, in any unit.
    ``errors`` (n,): standard error of each value by its readings. ``stated`` (n,): standard
    uncertainty of each value by other contributions, 0 where none is stated. ``jump_odds`` (n -
    1,): prior probability of a jump after each test, 1 where it is certain. ``opposite``: a
    rate is clear if the opposite sign is less probable than this.
    """
    if len(years) < LEAST_TESTS or years[-1] - years[0] < LEAST_YEARS:
        return None
    tests = _Tests(years, values, errors, stated, np.asarray(jump_odds, dtype=np.float64))
    certain = [place for place, odds in enumerate(jump_odds) if odds >= 1.0]
    likely = [place for place, odds in enumerate(jump_odds) if _LIKELY <= odds < 1.0]
    starts = [[], likely] if 0 < len(likely) <= tests.count // 3 else [[]]
    begun = [_found_jumps(tests, certain, start) for start in starts]
    chosen = certain + max(begun, key=lambda found: found[1])[0]
    mixture = _averaged(tests, chosen, frozenset(certain))
    rate = mixture.mean_rate()
    low, high = mixture.interval()
    jumps = [_jump(tests, mixture, chosen, place) for place in chosen if place not in set(certain)]
    return Trend(
        rate=rate,
        std_error=(high - low) / (2.0 * _NORMAL_95),
        clear=mixture.less_likely_sign() < opposite,
        jumps=tuple(jump for jump in jumps if jump.probability > _CLEAR_JUMP),
        _mixture=mixture,
    )


class _Tests:
    """The tests of one parameter, with the standard deviations between tests that are tried."""

    def __init__(
        self,
        years: FloatArray,
        values: FloatArray,
        errors: FloatArray,
        stated: FloatArray,
        odds: FloatArray,
    ) -> None:
        self.count = len(years)
        self.years = years - years[-1]
        self.middle = float(np.median(values))
        self.values = values - self.middle
        self.odds = np.clip(odds, 1e-6, 1.0 - 1e-6)
        differences = np.abs(np.diff(values))
        usual = float(np.median(errors)) or float(np.median(differences)) / 2.0
        usual = max(usual, 1e-3 * float(np.max(np.abs(values))), 1e-6)
        ratio = np.geomspace(0.05, 30.0, _SCATTERS)
        scatter = ratio[:, None] * np.hypot(usual, stated)
        dof = _STATED_DOF if np.any(stated) else 1.0
        self.scatter_prior = dof * np.log(ratio) - (dof + 1.0) / 2.0 * np.log1p(dof * ratio**2)
        self.scatter_prior -= np.logaddexp.reduce(self.scatter_prior)
        self.weights = 1.0 / (errors**2 + scatter**2)
        self.solved: dict[tuple[object, ...], _Solution] = {}
        self.steps = np.tri(self.count, self.count - 1, -1)
        enough = self.count >= _SEASON_TESTS and years[-1] - years[0] >= _SEASON_YEARS
        self.seasons = (False, True) if enough else (False,)

    def design(
        self, jumps: Sequence[int], certain: frozenset[int], size: float, *, season: bool
    ) -> tuple[FloatArray, FloatArray]:
        """Return the matrix columns (n, p) for level, rate, jumps and season, and the prior
        standard deviation of each coefficient: ``size`` for the jumps that are not ``certain``.
        """
        columns = [np.ones(self.count), self.years, *(self.steps[:, place] for place in jumps)]
        widths = [_LEVEL, _RATE, *(_CERTAIN if place in certain else size for place in jumps)]
        if season:
            angle = 2.0 * math.pi * self.years
            columns += [np.sin(angle), np.cos(angle)]
            widths += [_SEASON, _SEASON]
        return np.stack(columns, axis=1), np.array(widths)


@dataclass(frozen=True, slots=True)
class _Solution:
    """A linear model of a trend, solved for each of s possible standard deviations between tests.

    ``coefficients`` (s, p), ``covariance`` (s, p, p); ``evidence`` (s,): logarithm of the evidence.
    The other fields (s, n - 1, ...) show what one further jump after each test adds.
    """

    coefficients: FloatArray
    covariance: FloatArray
    evidence: FloatArray
    precision: FloatArray  # of a further jump's column, the others given
    residual: FloatArray
    loading: FloatArray  # (s, n - 1, p)


def _solved(tests: _Tests, design: FloatArray, widths: FloatArray) -> _Solution:
    weights = tests.weights
    weighted = weights[:, :, None] * design
    inverse = np.einsum("np,snq->spq", design, weighted) + np.diag(widths**-2.0)
    covariance = np.linalg.inv(inverse)
    right = tests.values @ weighted
    coefficients = (covariance @ right[:, :, None])[:, :, 0]
    left = weights @ tests.values**2 - (coefficients * right).sum(axis=1)
    evidence = 0.5 * (
        np.log(weights).sum(axis=1)
        - np.linalg.slogdet(inverse)[1]
        - 2.0 * np.log(widths).sum()
        - left
    )
    across = tests.steps.T @ weighted
    loading = across @ covariance
    precision = weights @ tests.steps - (loading * across).sum(axis=2)
    off = tests.values - coefficients @ design.T
    residual = (weights * off) @ tests.steps
    return _Solution(coefficients, covariance, evidence, precision, residual, loading)


def _further(solution: _Solution, size: float) -> tuple[FloatArray, FloatArray]:
    """Return how much a further jump at each place increases the log evidence, and the precision (1
    / variance) of the size of this jump. ``size``: prior standard deviation of a jump.
    """
    precision = np.maximum(solution.precision, 0.0) + size**-2.0
    gain = 0.5 * (solution.residual**2 / precision - np.log(precision)) - math.log(size)
    return gain, precision


def _variants(
    tests: _Tests, jumps: Sequence[int], certain: frozenset[int]
) -> list[tuple[float, float, _Solution]]:
    """Return the models with the ``jumps``. Each model is given by the prior size of uncertain
    jumps, the log prior of the model, and the solution of the model.
    """
    found = []
    free = [place for place in jumps if place not in certain]
    odds = np.log(tests.odds[free] / (1.0 - tests.odds[free])).sum()
    for season in tests.seasons:
        chance = _SEASON_PRIOR if season else 1.0 - _SEASON_PRIOR
        prior = math.log(chance if len(tests.seasons) > 1 else 1.0) - math.log(len(_JUMPS))
        for size in _JUMPS:
            key = (*jumps, size if free else None, season)
            if key not in tests.solved:  # without free jumps the same for each size
                columns, widths = tests.design(jumps, certain, size, season=season)
                tests.solved[key] = _solved(tests, columns, widths)
            found.append((size, prior + float(odds), tests.solved[key]))
    return found


def _found_jumps(
    tests: _Tests, certain: Sequence[int], start: Sequence[int]
) -> tuple[list[int], float]:
    """Return the jumps whose probability exceeds one half, in addition to the ``certain`` jumps,
    and the log evidence with all these jumps. The search begins with the jumps ``start``.

    Each step of the search makes the best change: one jump more or one jump less.
    """
    found = list(start)
    log_odds = np.log(tests.odds / (1.0 - tests.odds))
    while True:
        without, added = [], []
        for size, prior, solution in _variants(tests, [*certain, *found], frozenset(certain)):
            base = prior + tests.scatter_prior + solution.evidence
            without.append(base)
            added.append(base[:, None] + _further(solution, size)[0])
        now = float(np.logaddexp.reduce(np.concatenate(without)))
        score = np.logaddexp.reduce(np.concatenate(added), axis=0) + log_odds
        score[[*certain, *found]] = -math.inf
        best = int(np.argmax(score))
        less = {place: _evidence(tests, certain, found, place) for place in found}
        worst = max(less, key=lambda place: less[place], default=None)
        if worst is not None and less[worst] > max(now, score[best]):
            found.remove(worst)
        elif score[best] > now and len(found) < min(_MOST_JUMPS, tests.count - 2):
            found.append(best)
        else:
            return found, now


def _evidence(tests: _Tests, certain: Sequence[int], found: Sequence[int], lacking: int) -> float:
    """Return the log evidence of the ``found`` jumps without the jump ``lacking``."""
    jumps = [*certain, *(place for place in found if place != lacking)]
    return float(
        np.logaddexp.reduce(
            np.concatenate(
                [
                    prior + tests.scatter_prior + solution.evidence
                    for _, prior, solution in _variants(tests, jumps, frozenset(certain))
                ]
            )
        )
    )


@dataclass(frozen=True, slots=True)
class _Mixture:
    """Weighted normal distributions of the level at the last test and the rate, one for each model
    and each scatter between tests.

    ``middle`` is added to the level. ``lacking``: for each jump that is not certain, the weight of
    all models without it.
    """

    weight: FloatArray
    level: FloatArray
    rate: FloatArray
    level_variance: FloatArray
    rate_variance: FloatArray
    covariance: FloatArray
    middle: float
    lacking: dict[int, float]

    def mean_rate(self) -> float:
        return float(self.weight @ self.rate)

    def less_likely_sign(self) -> float:
        """Return the probability of the less likely sign of the rate."""
        below = float(_normal_law(-self.rate / np.sqrt(self.rate_variance)) @ self.weight)
        return min(below, 1.0 - below)

    def interval(self) -> tuple[float, float]:
        """Return the ends of the 95 % interval of the rate, by Newton's method between bounds."""
        deviation = np.sqrt(self.rate_variance)
        low = np.full(2, float(np.min(self.rate - 9.0 * deviation)))
        high = np.full(2, float(np.max(self.rate + 9.0 * deviation)))
        wanted = np.array([0.025, 0.975])
        off = self.rate - self.mean_rate()
        spread = math.sqrt(float(self.weight @ (self.rate_variance + off**2)))
        ends = self.mean_rate() + np.array([-_NORMAL_95, _NORMAL_95]) * spread
        for _ in range(_NEWTON_STEPS):
            score = (ends[:, None] - self.rate) / deviation
            lacking = wanted - _normal_law(score) @ self.weight
            low, high = np.where(lacking > 0.0, ends, low), np.where(lacking > 0.0, high, ends)
            density = np.exp(-0.5 * score**2) @ (self.weight / deviation) / _ROOT_2_PI
            best = ends + lacking / np.maximum(density, 1e-12 / spread)
            best = np.where((low < best) & (best < high), best, 0.5 * (low + high))
            moved = float(np.max(np.abs(best - ends)))
            ends = best
            if moved < 1e-8 * spread:
                break
        return float(ends[0]), float(ends[1])

    def lines(self, random: np.random.Generator, *, grows: bool) -> tuple[FloatArray, FloatArray]:
        """Return draws (n,) of the parameter's level at the last test and of its rate per year,
        from the generator ``random``. The rate is 0 in all draws unless ``grows``.
        """
        which = random.choice(len(self.weight), size=_DRAWS, p=self.weight)
        by_rate, own = random.standard_normal((2, _DRAWS))
        deviation = np.sqrt(self.rate_variance[which])
        if not grows:
            by_rate = -self.rate[which] / deviation
        common = self.covariance[which] / deviation
        rest = np.sqrt(np.maximum(self.level_variance[which] - common**2, 0.0))
        level = self.middle + self.level[which] + common * by_rate + rest * own
        return level, self.rate[which] + deviation * by_rate


def _averaged(tests: _Tests, chosen: Sequence[int], certain: frozenset[int]) -> _Mixture:
    """Return the average over three kinds of models: with the ``chosen`` jumps, without one of
    these jumps, and with one more jump.
    """
    parts: list[tuple[FloatArray, ...]] = []
    logs: list[FloatArray] = []
    lacks: list[tuple[int | None, int]] = []
    free = [place for place in chosen if place not in certain]
    log_odds = np.log(tests.odds / (1.0 - tests.odds))
    others = [place for place in range(tests.count - 1) if place not in chosen]
    for lacking in (None, *free):
        jumps = [place for place in chosen if place != lacking]
        for size, prior, solution in _variants(tests, jumps, certain):
            base = prior + tests.scatter_prior + solution.evidence
            ends = _ends(jumps, solution)
            parts.append(ends)
            logs.append(base)
            lacks.append((lacking, len(base)))
            if lacking is None and others:
                gain, precision = _further(solution, size)
                logs.append((base[:, None] + gain + log_odds)[:, others].ravel())
                parts.append(_moved(jumps, solution, precision, ends, others))
                lacks.append((None, len(logs[-1])))
    log = np.concatenate(logs)
    weight = np.exp(log - np.logaddexp.reduce(log))
    joined = [np.concatenate(columns) for columns in zip(*parts, strict=True)]
    shares: dict[int, float] = {}
    at = 0
    for place, count in lacks:
        if place is not None:
            shares[place] = shares.get(place, 0.0) + float(weight[at : at + count].sum())
        at += count
    order = np.argsort(-weight)
    kept = order[: 1 + int(np.searchsorted(np.cumsum(weight[order]), _KEPT))]
    weight = weight[kept] / weight[kept].sum()
    level, rate, level_variance, rate_variance, covariance = (each[kept] for each in joined)
    return _Mixture(
        weight, level, rate, level_variance, rate_variance, covariance, tests.middle, shares
    )


def _functional(jumps: Sequence[int], width: int) -> FloatArray:
    """Return the matrix (p, 2) with which the p = ``width`` coefficients of a model with these
    ``jumps`` give the level at the last test and the rate.
    """
    found = np.zeros((width, 2))
    found[0, 0] = 1.0
    found[1, 1] = 1.0
    found[2 : 2 + len(jumps), 0] = 1.0
    return found


def _ends(jumps: Sequence[int], solution: _Solution) -> tuple[FloatArray, ...]:
    """Return level, rate, their variances and their covariance, for each tried scatter between
    tests.
    """
    functional = _functional(jumps, solution.coefficients.shape[1])
    means = solution.coefficients @ functional
    spread = functional.T @ solution.covariance @ functional
    return means[:, 0], means[:, 1], spread[:, 0, 0], spread[:, 1, 1], spread[:, 0, 1]


def _moved(
    jumps: Sequence[int],
    solution: _Solution,
    precision: FloatArray,
    ends: tuple[FloatArray, ...],
    others: Sequence[int],
) -> tuple[FloatArray, ...]:
    """Return the values of `_ends` for models with one jump in addition to ``jumps``: one model for
    each of the ``others`` as the additional jump, whose size has the ``precision`` (1 / variance).
    """
    functional = _functional(jumps, solution.coefficients.shape[1])
    change = np.array([1.0, 0.0]) - solution.loading[:, others] @ functional
    size = (solution.residual / precision)[:, others]
    rest = 1.0 / precision[:, others]
    level, rate, level_variance, rate_variance, covariance = (each[:, None] for each in ends)
    by_level, by_rate = change[..., 0], change[..., 1]
    found = (
        level + by_level * size,
        rate + by_rate * size,
        level_variance + by_level**2 * rest,
        rate_variance + by_rate**2 * rest,
        covariance + by_level * by_rate * rest,
    )
    return tuple(each.ravel() for each in found)


def _jump(tests: _Tests, mixture: _Mixture, chosen: Sequence[int], place: int) -> TrendJump:
    """Return the chosen jump after the test with index ``place``, with its size averaged over the
    models that contain the jump.
    """
    certain = frozenset(each for each in chosen if each not in mixture.lacking)
    at = 2 + list(chosen).index(place)
    logs, means, variances = [], [], []
    for _, prior, solution in _variants(tests, chosen, certain):
        logs.append(prior + tests.scatter_prior + solution.evidence)
        means.append(solution.coefficients[:, at])
        variances.append(solution.covariance[:, at, at])
    log = np.concatenate(logs)
    weight = np.exp(log - np.logaddexp.reduce(log))
    mean = np.concatenate(means)
    size = float(weight @ mean)
    variance = float(weight @ (np.concatenate(variances) + (mean - size) ** 2))
    return TrendJump(
        before=place,
        size=size,
        std_error=math.sqrt(variance),
        probability=1.0 - mixture.lacking[place],
    )


def _normal_law(score: FloatArray) -> FloatArray:
    """Return the cumulative normal distribution, accurate to 1e-7 (Abramowitz, Stegun 7.1.26)."""
    size = np.abs(score) / math.sqrt(2.0)
    step = 1.0 / (1.0 + 0.3275911 * size)
    factors = (0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429)
    tail = step * np.polyval(factors[::-1], step) * np.exp(-(size**2))
    return np.where(score > 0.0, 1.0 - 0.5 * tail, 0.5 * tail)
