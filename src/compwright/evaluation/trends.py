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
changed, a jump is certain. A jump may also be a set-back: an adjustment takes back a share of what
has grown since the first test. Its size then follows from the rate. Growth with set-backs looks
like a saw tooth, and without this model like no growth with a large scatter. The season is a sine
with a period of one year. Models with and without each jump and the season are averaged by their
evidence (Kass and Raftery, J. Am. Stat. Assoc. 90 (1995) 773).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.trend_models import (
    TrendTests,
    ends_of,
    ends_with_jump,
    further,
    set_back_at,
    set_backs_of,
    variants,
)
from compwright.records.axis import FloatArray

#: Tests, and years between first and last, below which a rate is not estimated.
LEAST_TESTS: Final = 3
LEAST_YEARS: Final = 0.1
#: A jump with this probability is reported.
_CLEAR_JUMP: Final = 0.9
_MOST_JUMPS: Final = 8
#: Prior probability from which jumps are also looked for all together.
_LIKELY: Final = 0.1
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

    ``interval``: the ends of the rate's 95 % interval. ``std_error``: its half width divided by
    1.96. ``clear``: whether the rate is significant.
    """

    rate: float
    interval: tuple[float, float]
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
    set_backs: float = 0.0,
) -> Trend | None:
    """Return the rate of change of a parameter, or None for fewer than three tests or less than 0.1
    years.

    ``years`` (n,): times of the tests, ascending. ``values`` (n,): the parameter, in any unit.
    ``errors`` (n,): standard error of each value by its readings. ``stated`` (n,): standard
    uncertainty of each value by other contributions, 0 where none is stated. ``jump_odds`` (n -
    1,): prior probability of a jump after each test, 1 where it is certain. ``opposite``: a
    rate is clear if the opposite sign is less probable than this. ``set_backs``: probability that a
    jump which is not certain is a set-back.
    """
    if len(years) < LEAST_TESTS or years[-1] - years[0] < LEAST_YEARS:
        return None
    odds = np.asarray(jump_odds, dtype=np.float64)
    tests = TrendTests(years, values, errors, stated, odds, set_backs)
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
        interval=(low, high),
        std_error=(high - low) / (2.0 * _NORMAL_95),
        clear=mixture.less_likely_sign() < opposite,
        jumps=tuple(jump for jump in jumps if jump.probability > _CLEAR_JUMP),
        _mixture=mixture,
    )


def _found_jumps(
    tests: TrendTests, certain: Sequence[int], start: Sequence[int]
) -> tuple[list[int], float]:
    """Return the jumps whose probability exceeds one half, in addition to the ``certain`` jumps,
    and the log evidence with all these jumps. The search begins with the jumps ``start``.

    Each step of the search makes the best change: one jump more or one jump less.
    """
    found = list(start)
    held = frozenset(certain)
    while True:
        added = []
        for size, prior, solution in variants(tests, [*certain, *found], held):
            base = prior + tests.scatter_prior + solution.evidence
            added.append(base[:, None] + further(tests, solution, size)[0])
        score = np.logaddexp.reduce(np.concatenate(added), axis=0)
        one_more = set_backs_of(tests, [*certain, *found], held)
        tied = np.logaddexp.reduce(one_more.log, axis=1)
        score[one_more.places] = np.logaddexp(score[one_more.places], tied)
        score[[*certain, *found]] = -math.inf
        best = int(np.argmax(score))
        now = _evidence(tests, [*certain, *found], held)
        less = {
            place: _evidence(tests, [*certain, *(each for each in found if each != place)], held)
            for place in found
        }
        worst = max(less, key=lambda place: less[place], default=None)
        if worst is not None and less[worst] > max(now, score[best]):
            found.remove(worst)
        elif score[best] > now and len(found) < min(_MOST_JUMPS, tests.count - 2):
            found.append(best)
        else:
            return found, now


def _evidence(tests: TrendTests, jumps: Sequence[int], certain: frozenset[int]) -> float:
    """Return the log evidence of the ``jumps``, one of which may be a set-back."""
    logs = [
        prior + tests.scatter_prior + solution.evidence
        for _, prior, solution in variants(tests, jumps, certain)
    ]
    free = (place for place in jumps if place not in certain)
    logs += [set_back_at(tests, jumps, certain, place)[0] for place in free]
    return float(np.logaddexp.reduce(np.concatenate(logs)))


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


def _averaged(tests: TrendTests, chosen: Sequence[int], certain: frozenset[int]) -> _Mixture:
    """Return the average over three kinds of models: with the ``chosen`` jumps, without one of
    these jumps, and with one more jump.
    """
    parts: list[tuple[FloatArray, ...]] = []
    logs: list[FloatArray] = []
    lacks: list[tuple[int | None, int]] = []
    free = [place for place in chosen if place not in certain]
    others = [place for place in range(tests.count - 1) if place not in chosen]

    def add(lacking: int | None, log: FloatArray, ends: tuple[FloatArray, ...]) -> None:
        logs.append(log.ravel())
        parts.append(tuple(each.ravel() for each in ends))
        lacks.append((lacking, log.size))

    for lacking in (None, *free):
        jumps = [place for place in chosen if place != lacking]
        for size, prior, solution in variants(tests, jumps, certain):
            base = prior + tests.scatter_prior + solution.evidence
            ends = ends_of(jumps, solution.coefficients, solution.covariance)
            add(lacking, base, ends)
            if lacking is None and others:
                gain, precision = further(tests, solution, size)
                one_more = ends_with_jump(jumps, solution, precision, ends, others)
                add(None, (base[:, None] + gain)[:, others], one_more)
        more = set_backs_of(tests, jumps, certain)
        for at, set_back in enumerate(more.places):
            absent = None if set_back == lacking else lacking
            add(absent, more.log[at], tuple(each[at] for each in more.ends))
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


def _jump(tests: TrendTests, mixture: _Mixture, chosen: Sequence[int], place: int) -> TrendJump:
    """Return the chosen jump after the test with index ``place``, with its size averaged over the
    models that contain the jump.
    """
    certain = frozenset(each for each in chosen if each not in mixture.lacking)
    at = 2 + list(chosen).index(place)
    logs, means, variances = [], [], []
    for _, prior, solution in variants(tests, chosen, certain):
        logs.append(prior + tests.scatter_prior + solution.evidence)
        means.append(solution.coefficients[:, at])
        variances.append(solution.covariance[:, at, at])
    log, ends, years = set_back_at(tests, chosen, certain, place)
    logs.append(log)
    means.append(-years * ends[1])
    variances.append(years**2 * ends[3])
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
