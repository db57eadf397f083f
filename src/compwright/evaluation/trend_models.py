"""Linear models of a parameter over the years, each with its evidence: level, rate, jumps, season.

`trends` describes the model and averages over these models.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: Standard deviations of the priors: rate per year, season, jumps (three sizes), certain jumps; in
#: µm, arcsec or µm/m.
_RATE: Final = 20.0
_SEASON: Final = 5.0
_JUMPS: Final = (0.7, 5.0, 35.0)
_CERTAIN: Final = 100.0
_LEVEL: Final = 1e4
#: Shares of the growth since the first test that a set-back may take away. More than all: wear
#: from before the first test goes too.
_SHARES: Final = (0.6, 0.8, 1.0, 1.2)
#: Prior probability of a season, and the tests and years that it takes to see one.
_SEASON_PRIOR: Final = 0.2
_SEASON_TESTS: Final = 6
_SEASON_YEARS: Final = 1.0
_SCATTERS: Final = 13
#: A stated uncertainty is worth so many readings: a scatter far below it is less likely.
_STATED_DOF: Final = 3.0


class TrendTests:
    """The tests of one parameter, with the standard deviations between tests that are tried.

    The arguments are those of `trends.trend_of`: ``years`` (n,) ascending; ``values``, ``errors``,
    ``stated`` (n,) in the unit of the parameter; ``odds`` (n - 1,): probabilities of a jump.
    """

    def __init__(
        self,
        years: FloatArray,
        values: FloatArray,
        errors: FloatArray,
        stated: FloatArray,
        odds: FloatArray,
        set_backs: float,
    ) -> None:
        self.count = len(years)
        self.years = years - years[-1]
        self.middle = float(np.median(values))
        self.values = values - self.middle
        odds = np.clip(odds, 1e-6, 1.0 - 1e-6)
        self.log_odds = np.log(odds / (1.0 - odds))
        self.set_backs = set_backs
        differences = np.abs(np.diff(values))
        usual = float(np.median(errors)) or float(np.median(differences)) / 2.0
        usual = max(usual, 1e-3 * float(np.max(np.abs(values))), 1e-6)
        ratio = np.geomspace(0.05, 30.0, _SCATTERS)
        scatter = ratio[:, None] * np.hypot(usual, stated)
        dof = _STATED_DOF if np.any(stated) else 1.0
        self.scatter_prior = dof * np.log(ratio) - (dof + 1.0) / 2.0 * np.log1p(dof * ratio**2)
        self.scatter_prior -= np.logaddexp.reduce(self.scatter_prior)
        self.weights = 1.0 / (errors**2 + scatter**2)
        self.solved: dict[tuple[object, ...], TrendSolution] = {}
        self.set_back: dict[tuple[int, ...], SetBacks] = {}
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

    def models(
        self, jumps: Sequence[int], certain: frozenset[int], *, same: bool = False
    ) -> Iterator[tuple[float, bool, float]]:
        """Yield prior size of uncertain jumps, season, and log prior of the models with ``jumps``
        of any size. ``same``: only one size, because the model has no uncertain jumps.
        """
        sizes = _JUMPS[:1] if same else _JUMPS
        free = [place for place in jumps if place not in certain]
        prior = float((self.log_odds[free] + math.log(1.0 - self.set_backs)).sum())
        for season in self.seasons:
            chance = _SEASON_PRIOR if season else 1.0 - _SEASON_PRIOR
            seasonal = math.log(chance if len(self.seasons) > 1 else 1.0)
            for size in sizes:
                yield size, season, prior + seasonal - math.log(len(sizes))


@dataclass(frozen=True, slots=True)
class TrendSolution:
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


def _fitted(
    tests: TrendTests, designs: FloatArray, widths: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return coefficients (m, s, p), covariance (m, s, p, p) and log evidence (m, s) of models with
    the matrices ``designs`` (m, n, p) and the prior standard deviations ``widths`` (p,).
    """
    weights = tests.weights
    m, n, p = designs.shape
    products = (designs[:, :, :, None] * designs[:, :, None, :]).reshape(m, n, p * p)
    inverse = (weights @ products).reshape(m, -1, p, p) + np.diag(widths**-2.0)
    covariance = np.asarray(np.linalg.inv(inverse), dtype=np.float64)
    right = (weights * tests.values) @ designs
    coefficients: FloatArray = (covariance @ right[..., None])[..., 0]
    left = weights @ tests.values**2 - (coefficients * right).sum(axis=2)
    evidence: FloatArray = 0.5 * (
        np.log(weights).sum(axis=1)
        - np.linalg.slogdet(inverse)[1]
        - 2.0 * np.log(widths).sum()
        - left
    )
    return coefficients, covariance, evidence


def _solved(tests: TrendTests, design: FloatArray, widths: FloatArray) -> TrendSolution:
    fitted = _fitted(tests, design[None], widths)
    coefficients, covariance, evidence = (each[0] for each in fitted)
    weights = tests.weights
    across = tests.steps.T @ (weights[:, :, None] * design)
    loading = across @ covariance
    precision = weights @ tests.steps - (loading * across).sum(axis=2)
    off = tests.values - coefficients @ design.T
    residual = (weights * off) @ tests.steps
    return TrendSolution(coefficients, covariance, evidence, precision, residual, loading)


def further(
    tests: TrendTests, solution: TrendSolution, size: float
) -> tuple[FloatArray, FloatArray]:
    """Return how much a further jump at each place increases the log weight, and the precision (1 /
    variance) of the size of this jump. ``size``: prior standard deviation of a jump.
    """
    precision = np.maximum(solution.precision, 0.0) + size**-2.0
    gain = 0.5 * (solution.residual**2 / precision - np.log(precision)) - math.log(size)
    return gain + tests.log_odds + math.log(1.0 - tests.set_backs), precision


def variants(
    tests: TrendTests, jumps: Sequence[int], certain: frozenset[int]
) -> list[tuple[float, float, TrendSolution]]:
    """Return the models with the ``jumps``. Each model is given by the prior size of uncertain
    jumps, the log prior of the model, and the solution of the model.
    """
    found = []
    sized = not certain.issuperset(jumps)
    for size, season, prior in tests.models(jumps, certain):
        key = (*jumps, size if sized else None, season)
        if key not in tests.solved:  # without free jumps the same for each size
            columns, widths = tests.design(jumps, certain, size, season=season)
            tests.solved[key] = _solved(tests, columns, widths)
        found.append((size, prior, tests.solved[key]))
    return found


@dataclass(frozen=True, slots=True)
class SetBacks:
    """Models that have one set-back at any of ``places``, each in k versions: share, season, size
    of other jumps, scatter.

    ``log`` (places, k): log weight. ``ends``: values of `ends_of`, each (places, k). ``years``
    (places, k): years of growth that the set-back takes away.
    """

    places: list[int]
    log: FloatArray
    ends: tuple[FloatArray, ...]
    years: FloatArray


def set_backs_of(tests: TrendTests, jumps: Sequence[int], certain: frozenset[int]) -> SetBacks:
    """Return the models with one set-back in addition to the ``jumps``.

    Such a model has the coefficients of the model without it. The rate multiplies the years of
    growth, which are fewer by the set-back.
    """
    key = tuple(jumps)
    if key in tests.set_back:
        return tests.set_back[key]
    places = [place for place in range(tests.count - 1) if tests.set_backs and place not in jumps]
    count = len(places)
    if not places:
        nothing = np.empty((0, 0))
        return SetBacks([], nothing, (nothing,) * 5, nothing)
    grown = 0.5 * (tests.years[1:] + tests.years[:-1])[places] - tests.years[0]
    taken = grown[:, None] * np.array(_SHARES)
    before = 1.0 - tests.steps[:, places].T
    worn = (tests.years + taken[:, :, None] * before[:, None]).reshape(-1, tests.count)
    chance = math.log(tests.set_backs / len(_SHARES))
    logs, ends = [], []
    for size, season, prior in tests.models(jumps, certain, same=certain.issuperset(jumps)):
        columns, widths = tests.design(jumps, certain, size, season=season)
        designs = np.repeat(columns[None], len(worn), axis=0)
        designs[:, :, 1] = worn
        coefficients, covariance, evidence = _fitted(tests, designs, widths)
        log = prior + tests.scatter_prior + evidence
        logs.append(log.reshape(count, -1) + tests.log_odds[places, None] + chance)
        found = ends_of(jumps, coefficients, covariance)
        ends.append(tuple(each.reshape(count, -1) for each in found))
    tests.set_back[key] = SetBacks(
        places,
        np.concatenate(logs, axis=1),
        tuple(np.concatenate(each, axis=1) for each in zip(*ends, strict=True)),
        np.tile(np.repeat(taken, _SCATTERS, axis=1), len(logs)),
    )
    return tests.set_back[key]


def set_back_at(
    tests: TrendTests, jumps: Sequence[int], certain: frozenset[int], place: int
) -> tuple[FloatArray, tuple[FloatArray, ...], FloatArray]:
    """Return log weights, ends and years of the models in which the jump at ``place`` is a
    set-back.
    """
    found = set_backs_of(tests, [each for each in jumps if each != place], certain)
    if not found.places:
        return np.empty(0), (np.empty(0),) * 5, np.empty(0)
    at = found.places.index(place)
    return found.log[at], tuple(each[at] for each in found.ends), found.years[at]


def _functional(jumps: Sequence[int], width: int) -> FloatArray:
    """Return the matrix (p, 2) with which the p = ``width`` coefficients of a model with these
    ``jumps`` give the level at the last test and the rate.
    """
    found = np.zeros((width, 2))
    found[0, 0] = 1.0
    found[1, 1] = 1.0
    found[2 : 2 + len(jumps), 0] = 1.0
    return found


def ends_of(
    jumps: Sequence[int], coefficients: FloatArray, covariance: FloatArray
) -> tuple[FloatArray, ...]:
    """Return level, rate, their variances and their covariance, for each tried scatter between
    tests.
    """
    functional = _functional(jumps, coefficients.shape[-1])
    means = coefficients @ functional
    spread = functional.T @ covariance @ functional
    level, rate = means[..., 0], means[..., 1]
    return level, rate, spread[..., 0, 0], spread[..., 1, 1], spread[..., 0, 1]


def ends_with_jump(
    jumps: Sequence[int],
    solution: TrendSolution,
    precision: FloatArray,
    ends: tuple[FloatArray, ...],
    others: Sequence[int],
) -> tuple[FloatArray, ...]:
    """Return the values of `ends_of` for models with one jump in addition to ``jumps``: one model
    for each of the ``others`` as the additional jump, whose size has the ``precision`` (1 /
    variance).
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
