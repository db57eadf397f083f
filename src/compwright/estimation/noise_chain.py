"""Random sampling of the noise of a test by a Gibbs sampler, which draws each part of the noise
given all other parts (Geman and Geman, IEEE Trans. Pattern Anal. 6, 1984).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.cells import LEAST_NOISE
from compwright.estimation.noise_move_selection import draw_share
from compwright.estimation.noise_patterns import OFFSET, Sizes, build_patterns
from compwright.estimation.noise_readings import (
    CellReadings,
    ReducedReadings,
    reduce_readings,
    traverse_effects,
    without_traverse_lines,
)
from compwright.estimation.noise_rounding import (
    COARSEST,
    draw_unrounded,
    initial_unrounded,
    reading_step,
    with_least_scatter,
)
from compwright.estimation.noise_spread import draw_spread, precision_powers, spread_shapes
from compwright.estimation.noise_tails import (
    KINDS,
    LIGHT,
    TAILS,
    Latent,
    draw_latent,
    tail_probabilities,
)
from compwright.estimation.noise_traverses import ReducedTraverses
from compwright.records.axis import FloatArray
from compwright.records.noise import WAVE, BoolArray
from compwright.records.positioning import PositioningTest

#: By how much the scale of a reading may change where its distribution is drawn.
_STEP: Final = 0.08
_FACTORS: Final = np.exp(_STEP * np.arange(-4, 5))
#: Draws of means and tails in one sweep: they hold each other (a mean that was drawn under heavy
#: tails makes them look heavy), traverses hardly enter.
_TURNS: Final = 3
#: Distributions of the errors, with their scales, that are taken from one sweep.
WAYS: Final = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseState:
    """One state of the random sampler of the noise, mm or deg.

    Errors of readings. ``sigma``: their scale before rounding. ``spread``: coefficients of the log
    scale over direction and position. ``tail``: index of their distribution in `TAILS`. ``tails``,
    ``sigmas`` (`WAYS`,): equally likely alternatives for ``tail`` and ``sigma``. ``outlier`` (c,
    n): which readings are outliers.

    Shifts of traverses. ``size`` (4,), ``pattern``, ``wave``, ``moved`` (q,), ``rate``: as in
    `Sizes`, but sizes in mm or deg. ``share``: share of traverses with an offset. ``drift`` (2,):
    drift of offset and of tilt. ``again`` (2,): standard deviations of offset and tilt in a
    repeated test, at least as large as in this test. ``effects`` (k,): mean shifts of the
    traverses, with the drift, given the reduced readings ``data``. ``covariance`` (k, k):
    covariance of these shifts. ``variance``: variance of a reading.

    Probabilities. ``absent``, ``absent_spread``: that each part is zero. ``tail_chances``: of each
    distribution.
    """

    sigma: float
    spread: FloatArray
    tail: int
    tails: NDArray[np.intp]
    sigmas: FloatArray
    pattern: int
    wave: tuple[float, float]
    moved: BoolArray
    share: float
    size: FloatArray
    again: FloatArray
    drift: FloatArray
    rate: int
    effects: FloatArray
    covariance: FloatArray
    variance: float
    data: ReducedReadings
    absent: FloatArray
    absent_spread: FloatArray
    tail_chances: FloatArray
    outlier: NDArray[np.bool_]


class GibbsChain:
    """The Gibbs sampler of the noise of a test, with its present state."""

    def __init__(
        self, test: PositioningTest, readings: CellReadings, rng: np.random.Generator
    ) -> None:
        self.readings, self.rng = readings, rng
        self.runs = test.positive.shape[1], test.negative.shape[1]
        self.patterns = build_patterns(readings, test.cycle, self.runs)
        m = readings.there.shape[0] // 2
        self.made = np.any(readings.there.reshape(2, m, -1), axis=1)
        self.shapes = spread_shapes(readings)
        self.powers = precision_powers(self.shapes)
        self.floor = LEAST_NOISE[test.kind]
        self.dof = np.maximum(np.sum(readings.there, axis=1) - 1.0, 0.0)
        self.contrasts = int(np.sum(self.dof))
        self.counted = readings.there & (self.dof > 0)[:, np.newaxis]
        moves = np.ones(2 * readings.runs, dtype=np.bool_)
        self.sizes, self.spread, self.tail = Sizes(moves), np.zeros(len(self.shapes)), 0
        self.absent_spread = np.ones(len(self.shapes))
        self.values = readings.values
        self.begun = False
        self.reduced: tuple[FloatArray, FloatArray, ReducedTraverses] | None = None
        never = np.zeros(readings.there.shape)
        self.latent = Latent(readings.there.astype(np.float64), never, readings.there & False)
        self.sigma, residuals = self._start()
        left = without_traverse_lines(readings, residuals)
        self.step = reading_step(readings, left, self.sigma, COARSEST[test.kind])
        self.values = (
            initial_unrounded(readings, self.step, self.sigma, rng)
            if self.step
            else with_least_scatter(readings, left, self.floor, rng)
        )
        if self.values is not readings.values:
            self.sigma, residuals = self._start()
        self.tail_chances = np.zeros(len(TAILS))
        self._take_tail(residuals / self.sigma)

    def _start(self) -> tuple[float, FloatArray]:
        """Return a robust standard deviation of a reading, and the readings minus the medians of
        targets and traverses (Tukey, Exploratory Data Analysis, 1977, chapter 11).
        """
        left = np.where(self.readings.there, self.values, np.nan)
        half = left.shape[0] // 2
        for _ in range(2):
            left = left - _medians(left)
            for rows in (slice(0, half), slice(half, None)):
                left[rows] = left[rows] - _medians(left[rows].T).T
        rest = np.nan_to_num(left)
        lost = float(np.sum(self.counted)) / float(self.readings.dof)
        scale = 1.4826 * float(np.median(np.abs(rest[self.counted]))) * np.sqrt(lost)
        spread = float(np.sqrt(np.sum(rest**2) / self.readings.dof))
        return max(scale, 0.3 * spread, self.floor), rest

    def sweep(self) -> NoiseState:
        """Draw every part of the noise once. Return the parts that were used in the last step,
        which draws the means.
        """
        rng, there = self.rng, self.readings.there
        scale = np.exp(self.spread @ self.shapes)[:, np.newaxis]
        weights = there * self.latent.weights / scale**2
        values = self.values - self.latent.shift * self.sigma * scale
        traverses = self._traverses(values, weights)
        data = traverses.data
        if not self.begun:
            traverses.begin(self.sizes)
            self.begun = True
        traverses.draw_sizes(self.sizes, rng)
        variance = traverses.draw_variance(self.sizes, rng)
        drift = traverses.draw_drift(self.sizes, variance, rng)
        mean, covariance = traverses.effects(self.sizes, drift)
        drifting = self.patterns.columns(self.sizes.rate) @ drift
        share = self._share()
        draw = NoiseState(
            sigma=float(np.sqrt(variance)),
            spread=self.spread.copy(),
            tail=self.tail,
            tails=self.tails,
            sigmas=self.sigmas,
            pattern=self.sizes.pattern,
            wave=self.sizes.wave,
            moved=self.sizes.moved,
            share=share,
            size=self.sizes.size * np.sqrt(variance),
            again=self.patterns.at_least(self.sizes, mean, variance, share, self.made),
            drift=drift,
            rate=self.sizes.rate,
            effects=mean + drifting,
            covariance=variance * covariance,
            variance=variance,
            data=self._as_read(data, weights, self.values - values),
            absent=self.sizes.absent.copy(),
            absent_spread=self.absent_spread,
            tail_chances=self.tail_chances,
            outlier=self.latent.outlier,
        )
        effects = mean + np.sqrt(variance) * (
            covariance_root(covariance) @ rng.standard_normal(mean.size)
        )
        self._draw_readings(values, traverse_effects(self.readings, effects + drifting))
        return draw

    def _share(self) -> float:
        """Draw the share of traverses that have an offset; it is 1 if offsets are absent or follow
        a wave.
        """
        if self.sizes.size[OFFSET] == 0.0 or self.sizes.pattern == WAVE:
            return 1.0
        return draw_share(self.sizes.moved, self.rng)

    def _as_read(
        self, data: ReducedReadings, weights: FloatArray, shift: FloatArray
    ) -> ReducedReadings:
        """Return ``data`` with means of the displayed (rounded) readings instead of the unrounded
        values drawn for them. The unrounded values are random and would change the mean of their
        target at random.
        """
        if self.values is self.readings.values:
            return data
        total = np.maximum(data.weights, 1e-300)
        return replace(data, means=np.sum(weights * (self.readings.values - shift), axis=1) / total)

    def _traverses(self, values: FloatArray, weights: FloatArray) -> ReducedTraverses:
        """Return the sampler of traverse shifts, given readings ``values`` (c, n) with ``weights``
        (c, n). The sampler is computed again only if the readings or weights have changed.
        """
        if not (
            self.reduced is not None
            and np.array_equal(self.reduced[0], values)
            and np.array_equal(self.reduced[1], weights)
        ):
            data = reduce_readings(self.readings, values, weights)
            known = ReducedTraverses(self.patterns, data, self.contrasts, self.floor)
            self.reduced = values, weights, known
        return self.reduced[2]

    def _draw_readings(self, values: FloatArray, moved: FloatArray) -> None:
        """Draw the error distribution of single readings ``values`` (c, n), less the shifts
        ``moved`` (c, n) of traverses: its scale, type and variation over the travel, the means at
        the targets, and the weights of the readings. The ``values`` do not contain the shifts of
        outliers.
        """
        squares = self._about_means(values - moved)[1]
        self.absent_spread = draw_spread(
            self.spread, self.shapes, self.powers, squares, self.dof, self.rng
        )
        scale = np.exp(self.spread @ self.shapes)[:, np.newaxis]
        for _ in range(_TURNS):
            middle = moved + self._draw_means(values - moved, scale)
            z = (self.values - middle) / (self.sigma * scale)
            self._take_tail(np.where(self.readings.there, z, 0.0))
            shift = self.latent.shift * self.sigma * scale
            values = self.values - shift
        if self.step:
            reach = self.sigma * scale / np.sqrt(self.latent.weights)
            self.values = draw_unrounded(self.readings, self.step, middle + shift, reach, self.rng)

    def _draw_means(self, left: FloatArray, scale: FloatArray) -> FloatArray:
        """Draw the standard deviation of a reading and return one draw of the means (c, 1) of
        targets and directions. ``left`` (c, n): readings without shifts of traverses and outliers.

        The standard deviation of a reading at each target and direction is the drawn one times
        ``scale`` (c, 1).
        """
        means, squares, total = self._about_means(left)
        square = float((squares / scale[:, 0] ** 2).sum())
        self.sigma = float(np.sqrt(square / self.rng.chisquare(self.contrasts)))
        spread = self.sigma * scale[:, 0] / np.sqrt(total)
        drawn: FloatArray = means + spread * self.rng.standard_normal(means.size)
        return drawn[:, np.newaxis]

    def _about_means(self, left: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return weighted means (c,) of the readings ``left`` (c, n), the weighted sums of squares
        about these means, and the sums of weights.
        """
        weights = self.readings.there * self.latent.weights
        total = np.maximum(weights.sum(axis=1), 1e-300)
        means = (weights * left).sum(axis=1) / total
        squares = (weights * (left - means[:, np.newaxis]) ** 2).sum(axis=1)
        return means, squares + self.floor**2 / squares.size, total

    def _take_tail(self, z: FloatArray) -> None:
        """Draw the type and the scale of the error distribution, then the weight of each reading.
        ``z`` (c, n): errors of the readings, divided by the present scale.

        The offsets of traverses keep their size in mm or deg. The type changes more than other
        parts from sweep to sweep. Therefore equally likely alternatives are drawn from the same
        distribution and stored (systematic sampling: Cochran, Sampling Techniques, 3rd ed. 1977,
        chapter 8).
        """
        factors = _FACTORS * np.exp(self.rng.uniform(-0.5, 0.5) * _STEP)
        chances = tail_probabilities(z[self.counted], factors)
        if self.step:  # what is rounded looks evenly spread
            chances[KINDS == LIGHT] = 0.0
            chances /= chances.sum()
        self.tail_chances = chances.sum(axis=1)
        cumulative = chances.cumsum()
        steps = (self.rng.random() + np.arange(WAYS) / WAYS) % 1.0
        drawn = np.minimum(cumulative.searchsorted(steps * cumulative[-1]), chances.size - 1)
        self.tails, places = np.divmod(drawn, factors.size)
        self.sigmas = self.sigma * factors[places]
        self.tail, factor = int(self.tails[0]), float(factors[places[0]])
        self.sigma *= factor
        self.sizes.size /= factor
        self.latent = draw_latent(TAILS[self.tail], z / factor, self.rng)


def _medians(values: FloatArray) -> FloatArray:
    """Return the median (m, 1) of the existing readings of each row, 0 without readings."""
    found = [
        np.median(row[np.isfinite(row)]) if np.any(np.isfinite(row)) else 0.0 for row in values
    ]
    return np.array(found, dtype=np.float64)[:, np.newaxis]


def covariance_root(covariance: FloatArray) -> FloatArray:
    """Return the Cholesky factor of a covariance that may be singular."""
    size = float(np.max(np.diagonal(covariance), initial=0.0))
    if size <= 0.0:
        return np.zeros_like(covariance)
    even = 0.5 * (covariance + covariance.T)
    even.flat[:: even.shape[0] + 1] += 1e-9 * size
    return np.asarray(np.linalg.cholesky(even), dtype=np.float64)
