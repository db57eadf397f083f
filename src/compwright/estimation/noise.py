"""The noise of a test, from what its readings scatter about the means of their cells.

    reading = mean of its cell + offset and tilt of its traverse + drift with the runs + error

Errors are normal, Student's, or have outliers; their scale may differ by direction and along the
travel. Traverses move each on its own, by runs, or in a random walk. Every part may be nothing, and
most of the prior probability says so; what the readings show decides how far it is believed. Drawn
by Gibbs sampling (Geman and Geman, IEEE Trans. Pattern Anal. 6, 1984), with everything normal
integrated out where its size is drawn.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.cells import LEAST_NOISE
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.noise_readings import Readings, at_traverses, readings_of, reduced
from compwright.estimation.noise_rounding import draw_unrounded, step_of
from compwright.estimation.noise_spread import draw_spread, shapes_of
from compwright.estimation.noise_tails import TAILS, Latent, chances_of, draw_latent
from compwright.estimation.noise_traverses import RATES, Sizes, Traverses, patterns_of
from compwright.records.axis import FloatArray
from compwright.records.noise import NoiseDraws
from compwright.records.positioning import PositioningTest

#: Below this many contrasts the noise is left to the estimate of the curve.
LEAST_DOF: Final = 10
_SEED: Final = 3
_SETTLING: Final = 32  # sweeps that are thrown away
_DRAWS: Final = 48
_BETWEEN: Final = 3  # sweeps from one draw to the next
#: Standard deviation of a number rounded to whole steps, in steps (JCGM 100:2008, F.2.2.1).
_ROUNDED: Final = 12.0**-0.5
#: By how much the scale of a reading may change where its distribution is drawn.
_STEP: Final = 0.08
_FACTORS: Final = np.exp(_STEP * np.arange(-4, 5))
#: Cells at which what is common to the means is told apart: places along the travel.
_PLACES: Final = (0.0, 1.0, 0.5, 0.25)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Draw:
    """One state of the sampler, and what the readings then say of the cells."""

    sigma: float
    spread: FloatArray
    tail: int
    pattern: int
    size: FloatArray
    drift: FloatArray
    rate: int
    mean: FloatArray
    precision: FloatArray
    columns: FloatArray


def noise_of(test: PositioningTest) -> NoisePosterior | None:
    """Return the posterior of the noise of ``test``; None where it has fewer than `LEAST_DOF`
    contrasts.

    The same test gives the same posterior. Model and sources: module docstring.
    """
    readings = readings_of(test)
    if readings.dof < LEAST_DOF:
        return None
    chain = _Chain(test, readings, np.random.default_rng(_SEED))
    for _ in range(_SETTLING):
        chain.sweep()
    draws = []
    for _ in range(_DRAWS):
        for _ in range(_BETWEEN - 1):
            chain.sweep()
        draws.append(chain.sweep())
    return _posterior(readings, draws)


class _Chain:
    """The Gibbs sampler and its present state."""

    def __init__(self, test: PositioningTest, readings: Readings, rng: np.random.Generator) -> None:
        self.readings, self.rng = readings, rng
        self.runs = test.positive.shape[1], test.negative.shape[1]
        self.patterns = patterns_of(readings, test.cycle, self.runs)
        self.shapes = shapes_of(readings)
        self.floor = LEAST_NOISE[test.kind]
        self.dof = np.maximum(np.sum(readings.there, axis=1) - 1.0, 0.0)
        self.sizes, self.spread, self.tail = Sizes(), np.zeros(len(self.shapes)), 0
        self.values = readings.values
        never = np.zeros(readings.there.shape)
        self.latent = Latent(readings.there.astype(np.float64), never, readings.there & False)
        self.sigma, residuals = self._start()
        self.step = step_of(readings, self.sigma)
        if self.step:
            within = rng.uniform(-0.5, 0.5, self.values.shape)
            self.values = np.where(readings.there, self.values + self.step * within, 0.0)
            self.sigma, residuals = self._start()
        self._take_tail(residuals / self.sigma)

    def _start(self) -> tuple[float, FloatArray]:
        """Return a robust scale of a reading, and the readings less what their cells and traverses
        have in common: medians (Tukey, Exploratory Data Analysis, 1977, chapter 11).
        """
        left = np.where(self.readings.there, self.values, np.nan)
        half = left.shape[0] // 2
        for _ in range(2):
            left = left - _medians(left)
            for rows in (slice(0, half), slice(half, None)):
                left[rows] = left[rows] - _medians(left[rows].T).T
        rest = np.nan_to_num(left)
        there = self.readings.there & (self.dof > 0)[:, np.newaxis]
        lost = float(np.sum(there)) / float(self.readings.dof)
        scale = 1.4826 * float(np.median(np.abs(rest[there]))) * np.sqrt(lost)
        spread = float(np.sqrt(np.sum(rest**2) / self.readings.dof))
        return max(scale, 0.3 * spread, self.floor), rest

    def sweep(self) -> _Draw:
        """Draw everything anew once; returns the state with the cells as they were weighed."""
        rng, there = self.rng, self.readings.there
        scale = np.exp(self.spread @ self.shapes)[:, np.newaxis]
        weights = there * self.latent.weights / scale**2
        values = self.values - self.latent.shift * self.sigma * scale
        data = reduced(self.readings, values, weights)
        traverses = Traverses(self.patterns, data, int(np.sum(self.dof)), self.floor)
        traverses.draw_sizes(self.sizes, rng)
        variance = traverses.draw_variance(self.sizes, rng)
        drift = traverses.draw_drift(self.sizes, variance, rng)
        mean, covariance = traverses.effects(self.sizes, drift)
        drifting = self.patterns.columns(self.sizes.rate) @ drift
        common = data.shares @ covariance @ data.shares.T * variance
        columns, rest = self._columns(common, data.weights > 0.0)
        own = np.where(
            data.weights > 0.0, variance / np.maximum(data.weights, 1e-300) + rest, np.inf
        )
        draw = _Draw(
            sigma=float(np.hypot(np.sqrt(variance), self.step * _ROUNDED)),
            spread=self.spread.copy(),
            tail=self.tail,
            pattern=self.sizes.pattern,
            size=self.sizes.size * np.sqrt(variance),
            drift=drift,
            rate=self.sizes.rate,
            mean=np.where(data.weights > 0.0, data.means - data.shares @ (mean + drifting), 0.0),
            precision=1.0 / own,
            columns=columns,
        )
        effects = mean + np.sqrt(variance) * (_root(covariance) @ rng.standard_normal(mean.size))
        self._draw_readings(values, at_traverses(self.readings, effects + drifting))
        return draw

    def _draw_readings(self, values: FloatArray, moved: FloatArray) -> None:
        """Draw where the readings scatter more, their scale, means, tails and latent weights."""
        rng, there = self.rng, self.readings.there
        weights = there * self.latent.weights
        total = np.maximum(np.sum(weights, axis=1), 1e-300)
        left = values - moved
        means = np.sum(weights * left, axis=1) / total
        squares = np.sum(weights * (left - means[:, np.newaxis]) ** 2, axis=1)
        squares = squares + self.floor**2 / squares.size
        self.absent_spread = draw_spread(self.spread, self.shapes, squares, self.dof, rng)
        scale = np.exp(self.spread @ self.shapes)
        square = float(np.sum(squares / scale**2))
        self.sigma = float(np.sqrt(square / rng.chisquare(np.sum(self.dof))))
        scale = self.sigma * scale
        means = means + scale / np.sqrt(total) * rng.standard_normal(means.size)
        middle = moved + means[:, np.newaxis]
        scales = np.broadcast_to(scale[:, np.newaxis], moved.shape)
        self._take_tail(np.where(there, (self.values - middle) / scales, 0.0))
        if self.step:
            scales = self.sigma * np.exp(self.spread @ self.shapes)[:, np.newaxis]
            reach = scales / np.sqrt(self.latent.weights)
            shifted = middle + self.latent.shift * scales
            self.values = draw_unrounded(self.readings, self.step, shifted, reach, rng)

    def _take_tail(self, z: FloatArray) -> None:
        """Draw the distribution of the errors together with their scale, from errors (c, n) in
        present scales; then what each reading was under it. What moves traverses stays as large.
        """
        counted = self.readings.there & (self.dof > 0)[:, np.newaxis]
        factors = _FACTORS * np.exp(self.rng.uniform(-0.5, 0.5) * _STEP)
        chances = chances_of(z[counted], factors)
        self.tail_chances = chances.sum(axis=1)
        cumulative = np.cumsum(chances)
        drawn = int(np.searchsorted(cumulative, self.rng.random() * cumulative[-1]))
        self.tail, place = divmod(min(drawn, chances.size - 1), factors.size)
        self.sigma *= float(factors[place])
        self.sizes.size /= factors[place]
        self.latent = draw_latent(TAILS[self.tail], z / factors[place], self.rng)

    def _columns(
        self, common: FloatArray, there: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
    ) -> tuple[FloatArray, FloatArray]:
        """Return columns (c, q) with ``common`` (c, c) = columns columns' + what is left on the
        diagonal (c,): partial Cholesky factor at fixed cells of each direction (Golub and Van
        Loan, Matrix Computations, 4th ed. 2013, section 4.2.8).
        """
        half = there.size // 2
        chosen = []
        for rows in (np.flatnonzero(there[:half]), half + np.flatnonzero(there[half:])):
            if rows.size:
                chosen += [int(rows[round(place * (rows.size - 1))]) for place in _PLACES]
        columns = np.zeros((there.size, 2 * len(_PLACES)))
        least = 1e-9 * float(np.max(np.diagonal(common)))
        rest = common.copy()
        for index, cell in enumerate(dict.fromkeys(chosen)):
            if rest[cell, cell] > least:
                columns[:, index] = rest[:, cell] / np.sqrt(rest[cell, cell])
                rest = rest - np.outer(columns[:, index], columns[:, index])
        return columns, np.maximum(np.diagonal(rest), 0.0)


def _medians(values: FloatArray) -> FloatArray:
    """Return the medians (m, 1) of the rows, of the readings there are; 0 without one."""
    found = [
        np.median(row[np.isfinite(row)]) if np.any(np.isfinite(row)) else 0.0 for row in values
    ]
    return np.array(found, dtype=np.float64)[:, np.newaxis]


def _root(covariance: FloatArray) -> FloatArray:
    """Return the Cholesky factor of a covariance that may be singular."""
    size = float(np.max(np.diagonal(covariance), initial=0.0))
    if size <= 0.0:
        return np.zeros_like(covariance)
    even = 0.5 * (covariance + covariance.T)
    even.flat[:: even.shape[0] + 1] += 1e-9 * size
    return np.asarray(np.linalg.cholesky(even), dtype=np.float64)


def _posterior(readings: Readings, draws: list[_Draw]) -> NoisePosterior:
    tails = [TAILS[draw.tail] for draw in draws]
    spread = np.array([draw.spread for draw in draws])
    sigma = np.array([draw.sigma for draw in draws])
    sizes = np.array([draw.size for draw in draws])
    drift = np.array([draw.drift for draw in draws])
    noise = NoiseDraws(
        centre=readings.centre,
        half=readings.half,
        sigma=sigma[:, np.newaxis] * np.exp(np.outer(spread[:, 0], [0.5, -0.5])),
        growth=spread[:, 1:],
        dof=np.array([tail.dof for tail in tails]),
        outlier_share=np.array([tail.share for tail in tails]),
        outlier_size=np.array([tail.size for tail in tails]),
        outlier_fixed=np.array([tail.fixed for tail in tails]),
        pattern=np.array([draw.pattern for draw in draws]),
        offset=sizes[:, 0],
        tilt=sizes[:, 1],
        drift=drift[:, 0],
        drift_tilt=drift[:, 1],
        drift_rate=RATES[[draw.rate for draw in draws]],
    )
    logs = np.log(sigma)
    return NoisePosterior(
        draws=noise,
        mean=np.array([draw.mean for draw in draws]),
        precision=np.array([draw.precision for draw in draws]),
        columns=np.array([draw.columns for draw in draws]),
        sigma=float(np.exp(np.mean(logs))),
        dof=float(readings.dof),
    )
