"""How whole traverses move: offsets and tilts by pattern, and what drifts with the runs.

Effects of the traverses, given the variance of a reading, are normal with a covariance that is a
sum of known patterns with unknown sizes. Sizes are drawn on a grid by their exact conditional
probability, effects and variance of a reading integrated out (griddy Gibbs sampler: Ritter and
Tanner, J. Am. Stat. Assoc. 87, 1992; linear mixed model: Searle, Casella and McCulloch, Variance
Components, 1992, chapter 6). Each size may be nothing at all (Mitchell and Beauchamp, J. Am. Stat.
Assoc. 83, 1988); else its prior is half-Cauchy (Gelman, Bayesian Analysis 1, 2006), in units of the
standard deviation of a reading.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from compwright.estimation.noise_readings import Readings, Reduced
from compwright.records.axis import FloatArray
from compwright.records.noise import WALK, progress, slackening, traverse_order
from compwright.records.positioning import Cycle

OFFSET, TILT, DRIFT, DRIFT_TILT = range(4)
#: Prior probability that there is none of it.
_NOTHING: Final = (0.85, 0.9, 0.85, 0.93)
#: Scale of the half-Cauchy prior, in standard deviations of a reading.
_USUAL: Final = (0.7, 0.7, 2.0, 2.0)
#: Sizes from 0.03 to 360 standard deviations of a reading, by the root of 2.
_GRID: Final = 0.03 * 2.0 ** (0.5 * np.arange(28))
#: Prior of the patterns `INDEPENDENT`, `RUNS`, `WALK`.
_PATTERNS: Final = np.array([0.55, 0.2, 0.25])
#: Time constants of warming up, in parts of the test: none (even drift), a half, a fifth.
RATES: Final = np.array([0.0, 2.0, 5.0])
_PACES: Final = np.array([0.6, 0.2, 0.2])
#: Natural logarithm of the evidence from which on the sampler begins with a drift (1000 to 1).
_CLEARLY: Final = 7.0


@dataclass(slots=True)
class Sizes:
    """Present state of the sampler: ``size`` (4,) of offset, tilt, drift, drift of the tilt, in
    standard deviations of a reading; ``pattern`` and ``rate`` as in the record of the noise;
    ``absent`` (4,): how probable it was, when last drawn, that there is none.
    """

    pattern: int = 0
    rate: int = 0
    size: FloatArray = field(default_factory=lambda: np.zeros(4))
    absent: FloatArray = field(default_factory=lambda: np.ones(4))


@dataclass(frozen=True, slots=True, kw_only=True)
class Patterns:
    """Covariances of the effects (k,) of unit size: ``offset``, ``tilt`` (patterns, k, k), the two
    drifts as columns ``drift``, ``drift_tilt`` (rates, k). ``walks``: time passes from run to run.
    """

    offset: FloatArray
    tilt: FloatArray
    drift: FloatArray
    drift_tilt: FloatArray
    walks: bool

    def covariance(self, sizes: Sizes) -> FloatArray:
        """Return that of offsets and tilts (k, k), in variances of a reading."""
        total: FloatArray = (
            sizes.size[OFFSET] ** 2 * self.offset[sizes.pattern]
            + sizes.size[TILT] ** 2 * self.tilt[sizes.pattern]
        )
        return total

    def columns(self, rate: int) -> FloatArray:
        """Return what the two drifts do to the effects (k, 2), from the first run to the last."""
        return np.column_stack([self.drift[rate], self.drift_tilt[rate]])


def patterns_of(readings: Readings, cycle: Cycle, runs: tuple[int, int]) -> Patterns:
    """Return the patterns of a test with ``runs`` in + and in -.

    In a step cycle the approaches to a target follow each other at once: there is nothing that
    drifts from run to run, and no walk.
    """
    n = readings.runs
    order = np.full((2, n), 2 * n)  # a traverse that was not made stands last
    for row, place in zip(order, traverse_order(*runs), strict=True):
        row[: place.size] = place
    # A random walk that is nothing in the middle of the test, as the record has it.
    time = order.ravel() - float(sum(runs) // 2)
    size = np.abs(time)
    walk = 0.5 * (size[:, np.newaxis] + size - np.abs(np.subtract.outer(time, time)))
    same = np.tile(np.eye(n), (2, 2))
    blocks = np.stack([np.eye(2 * n), same, walk])
    offset, tilt = np.zeros((2, len(blocks), 2, 2, n, 2, 2, n))
    parts = blocks.reshape(-1, 2, n, 2, n)
    offset[:, :, 0, :, :, 0] = parts
    tilt[:, :, 1, :, :, 1] = parts
    way = progress(n, RATES)
    way = way - way.mean(axis=1, keepdims=True)
    ends = slackening(n, RATES, np.array([-1.0, 1.0]), returns=min(runs) > 0)
    drift, drift_tilt = np.zeros((2, len(RATES), 2, 2, n))
    for direction, end in enumerate(ends):
        # A straight line between the ends of the travel: the tilt that slackening adds.
        even, uneven = end.mean(axis=1), 0.5 * (end[:, 1] - end[:, 0])
        drift[:, direction, 0] = even[:, np.newaxis] * way
        drift[:, direction, 1] = uneven[:, np.newaxis] * way
        drift_tilt[:, direction, 1] = even[:, np.newaxis] * way
    flat = (len(blocks), 4 * n, 4 * n)
    return Patterns(
        offset=offset.reshape(flat),
        tilt=tilt.reshape(flat),
        drift=drift.reshape(-1, 4 * n),
        drift_tilt=drift_tilt.reshape(-1, 4 * n),
        walks=cycle == "standard" and n > 1,
    )


@dataclass(frozen=True, slots=True)
class _Spectrum:
    """Scores along the axes of one covariance of unit size in the metric of all others: ``base``
    (forms,), the log determinant of those; ``stretch``, ``along`` (forms, r).
    """

    base: FloatArray
    stretch: FloatArray
    along: FloatArray


class Traverses:
    """What reduced readings with ``dof`` contrasts say of the sizes; all draws are from exact
    conditional distributions.
    """

    def __init__(self, patterns: Patterns, data: Reduced, dof: int, floor: float) -> None:
        root = data.root
        self.patterns, self.data, self.dof = patterns, data, dof
        self.rest = data.rest + floor**2
        self.offset = root.T @ patterns.offset @ root
        self.tilt = root.T @ patterns.tilt @ root
        self.drift = patterns.drift @ root
        self.drift_tilt = patterns.drift_tilt @ root
        self.known = len(_PATTERNS) if patterns.walks else WALK
        # By kind, beside nothing else: most of the time there is nothing else.
        self.alone: dict[int, _Spectrum] = {}

    def begin(self, sizes: Sizes) -> None:
        """Set ``sizes``, present state nothing, to those of drifts and of what moves beside them
        where the readings favour that clearly over traverses that move each on its own.

        One size after the other, the sampler seldom leaves large offsets for the drift that they
        imitate.
        """
        if not self.patterns.walks:
            return
        moving, drifting = Sizes(), Sizes()
        for kind in (OFFSET, TILT):
            without = self._climb(moving, kind)
        for kind in (DRIFT, DRIFT_TILT, OFFSET, TILT, DRIFT, DRIFT_TILT):
            with_drift = self._climb(drifting, kind)
        if with_drift > without + _CLEARLY:
            sizes.size, sizes.pattern, sizes.rate = drifting.size, drifting.pattern, drifting.rate

    def draw_sizes(self, sizes: Sizes, rng: np.random.Generator) -> None:
        """Draw every size of ``sizes`` anew, each given the others; pattern and rate with them."""
        for kind in (OFFSET, TILT):
            sizes.pattern = self._draw(sizes, kind, _PATTERNS[: self.known], rng)
        if not self.patterns.walks:
            return
        for kind in (DRIFT, DRIFT_TILT):
            sizes.rate = self._draw(sizes, kind, _PACES, rng)

    def draw_variance(self, sizes: Sizes, rng: np.random.Generator) -> float:
        """Draw the variance of a reading, all effects integrated out: scaled inverse chi-square
        (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section 3.2).
        """
        matrix = np.eye(self.data.scores.size) + self._moving(sizes) + self._drifting(sizes)
        scores = self.data.scores
        square = self.rest + float(scores @ np.linalg.solve(matrix, scores))
        return square / float(rng.chisquare(self.dof))

    def draw_drift(self, sizes: Sizes, variance: float, rng: np.random.Generator) -> FloatArray:
        """Draw the two drifts (2,) from first to last run, offsets and tilts integrated out."""
        drift = np.zeros(2)
        there = np.flatnonzero(sizes.size[DRIFT:] > 0.0)
        if there.size:
            columns = np.column_stack([self.drift[sizes.rate], self.drift_tilt[sizes.rate]])
            columns = columns[:, there]
            solved = np.linalg.solve(
                np.eye(columns.shape[0]) + self._moving(sizes),
                np.column_stack([columns, self.data.scores]),
            )
            precision = columns.T @ solved[:, :-1] + np.diag(sizes.size[DRIFT:][there] ** -2.0)
            covariance = np.linalg.inv(precision)
            mean = covariance @ (columns.T @ solved[:, -1])
            root = np.linalg.cholesky(0.5 * variance * (covariance + covariance.T))
            drift[there] = mean + root @ rng.standard_normal(there.size)
        return drift

    def effects(self, sizes: Sizes, drift: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return mean (k,) and covariance (k, k), in variances of a reading, of offsets and tilts
        given the ``drift`` (2,) (Searle, Casella and McCulloch 1992, section 7.4).
        """
        prior = self.patterns.covariance(sizes)
        carried = prior @ self.data.root
        scores = self.data.scores - drift @ np.stack(
            [self.drift[sizes.rate], self.drift_tilt[sizes.rate]]
        )
        gain = np.linalg.solve(np.eye(scores.size) + self.data.root.T @ carried, carried.T).T
        return gain @ scores, prior - gain @ carried.T

    def _moving(self, sizes: Sizes) -> FloatArray:
        total: FloatArray = (
            sizes.size[OFFSET] ** 2 * self.offset[sizes.pattern]
            + sizes.size[TILT] ** 2 * self.tilt[sizes.pattern]
        )
        return total

    def _drifting(self, sizes: Sizes) -> FloatArray:
        """Return the covariance (r, r) of the drifts in the scores, for the present rate."""
        total: FloatArray = sizes.size[DRIFT] ** 2 * np.outer(
            self.drift[sizes.rate], self.drift[sizes.rate]
        ) + sizes.size[DRIFT_TILT] ** 2 * np.outer(
            self.drift_tilt[sizes.rate], self.drift_tilt[sizes.rate]
        )
        return total

    def _draw(
        self,
        sizes: Sizes,
        kind: int,
        forms: FloatArray,
        rng: np.random.Generator,
    ) -> int:
        """Draw the size of ``kind`` into ``sizes`` and return which of the ``forms`` (prior
        probabilities) it has; the grid is shifted at random, so that sizes are continuous.
        """
        grid = _GRID * 2.0 ** rng.uniform(-0.25, 0.25)
        usual = grid / (grid**2 + _USUAL[kind] ** 2)
        prior = np.concatenate([[_NOTHING[kind]], (1.0 - _NOTHING[kind]) * usual / np.sum(usual)])
        logs = self._scan(self._spectrum(sizes, kind), np.concatenate([[0.0], grid]))
        chances = np.exp(logs - np.max(logs)) * np.outer(forms, prior)
        cumulative = np.cumsum(chances)
        drawn = int(np.searchsorted(cumulative, rng.random() * cumulative[-1]))
        form, place = divmod(min(drawn, chances.size - 1), prior.size)
        sizes.size[kind] = grid[place - 1] if place else 0.0
        sizes.absent[kind] = np.sum(chances[:, 0]) / cumulative[-1]
        return form

    def _climb(self, sizes: Sizes, kind: int) -> float:
        """Set the size of ``kind`` and its form to the most likely ones beside the others; returns
        their log evidence.
        """
        grid = np.concatenate([[0.0], _GRID])
        logs = self._scan(self._spectrum(sizes, kind), grid)
        form, place = np.unravel_index(int(np.argmax(np.round(logs, 6))), logs.shape)
        sizes.size[kind] = grid[place]
        if kind in (OFFSET, TILT):
            sizes.pattern = int(form)
        else:
            sizes.rate = int(form)
        return float(logs[form, place])

    def _spectrum(self, sizes: Sizes, kind: int) -> _Spectrum:
        """Return that of the covariances of ``kind`` beside all others (Golub and Van Loan, Matrix
        Computations, 4th ed. 2013, section 8.7: simultaneous diagonalisation).
        """
        alone = not np.any(np.delete(sizes.size, kind))
        if alone and kind in self.alone:
            return self.alone[kind]
        beside, mine = self._beside(sizes, kind)
        lower = np.linalg.cholesky(beside)
        right = np.linalg.solve(lower, mine)
        inner = np.linalg.solve(lower, np.swapaxes(right, 1, 2))
        stretch, axes = np.linalg.eigh(0.5 * (inner + np.swapaxes(inner, 1, 2)))
        white = np.linalg.solve(lower, self.data.scores[np.newaxis, :, np.newaxis])
        found = _Spectrum(
            base=2.0 * np.sum(np.log(np.diagonal(lower, axis1=1, axis2=2)), axis=1),
            stretch=np.maximum(stretch, 0.0),
            along=np.squeeze(np.swapaxes(axes, 1, 2) @ white, -1),
        )
        if alone:
            self.alone[kind] = found
        return found

    def _beside(self, sizes: Sizes, kind: int) -> tuple[FloatArray, FloatArray]:
        """Return, for each form of ``kind``, the covariance (forms, r, r) of all others, that of a
        reading included, and that of ``kind`` of unit size.
        """
        unit = np.eye(self.data.scores.size)
        if kind in (OFFSET, TILT):
            mine, other = (self.offset, self.tilt) if kind == OFFSET else (self.tilt, self.offset)
            rest = sizes.size[TILT - kind] ** 2 * other[: self.known]
            return unit + self._drifting(sizes) + rest, mine[: self.known]
        column, beside = (
            (self.drift, self.drift_tilt) if kind == DRIFT else (self.drift_tilt, self.drift)
        )
        rest = sizes.size[DRIFT + DRIFT_TILT - kind] ** 2 * _outer(beside)
        return unit + self._moving(sizes) + rest, _outer(column)

    def _scan(self, spectrum: _Spectrum, grid: FloatArray) -> FloatArray:
        """Return log evidence (forms, sizes) of covariances times the squares of ``grid``."""
        spread = 1.0 + grid[:, np.newaxis] ** 2 * spectrum.stretch[:, np.newaxis]
        square = self.rest + np.sum(spectrum.along[:, np.newaxis] ** 2 / spread, axis=2)
        log_evidence: FloatArray = -0.5 * (
            spectrum.base[:, np.newaxis]
            + np.sum(np.log(spread), axis=2)
            + self.dof * np.log(square)
        )
        return log_evidence


def _outer(columns: FloatArray) -> FloatArray:
    products: FloatArray = columns[:, :, np.newaxis] * columns[:, np.newaxis]
    return products
