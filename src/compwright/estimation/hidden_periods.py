"""Possible periods of the error that the readings cannot show.

The readings cannot show a period if the targets are too few for a search, or meet the wave always
at the same phase. They also cannot show it if the wave looks like a longer wave at the targets. The
smooth part of the model then follows this longer wave.

Each usual period, and some between, is one hypothesis. A hypothesis contains a straight line, the
known periods, a smooth error and one wave (`period_likelihood`). If the targets cannot show the
wave, its posterior equals its prior. If they show it, its posterior is narrow. Between the targets,
the wave differs from the smooth part that follows it at the targets. A test at new targets then
shows this difference (aliasing: Bretthorst, Bayesian Spectrum Analysis and Parameter Estimation,
1988, chapter 6; mixture of hypotheses: Hoeting et al., Statistical Science 14, 1999).

A wave that looks like a long wave at the targets cannot be distinguished from a smooth error of
this shape. The hypothesis therefore contains both waves and divides the observed values between
them. The prior of the long wave has the rms of the values.

Prior of a period: as in the search (`periods`), with one exception. Only one axis in four is
assumed to have a position loop that is closed by a scale along it, and thus no periods (a
judgement, from no document). The search is for axes in general. Here a limit is accepted for one
axis that is not known to have a scale.

Prior of the amplitude: half-normal of width `AMPLITUDE`. ISO 3408-3 (2006) lets the lead of a
ground screw vary by 6 to 8 µm within one turn (grades 3 and 5). The axial run-out of its seat adds
up to 5 µm (DIN ISO 3408-3, E 8.2, diameters to 50 mm, by the tables of makers). Together this is an
amplitude of 6.5 µm, which one axis in a hundred exceeds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.basis import ALIASED, Basis
from compwright.estimation.period_candidates import PEAK, PeriodOdds
from compwright.estimation.period_likelihood import (
    CHUNK,
    BidirectionalMeans,
    PeriodLikelihood,
    log_gains,
    log_smooth,
    log_sums,
)
from compwright.estimation.period_models import PeriodSearch, log_sum
from compwright.estimation.periods import FURTHER, LEAST_REPEATS, LEFT, SHORTEST, wave_columns
from compwright.estimation.spectral_window import SpectralWindow, wave_similarity
from compwright.estimation.usual_periods import usual_periods
from compwright.records.axis import AxisKind, FloatArray

#: What is expected before the data where no period is known.
_FIRST: Final = PeriodOdds(none=0.25, usual=0.57)
#: Standard deviation of the normal law of which the amplitude is one half: 2.5 µm, 2.5 arcsec.
AMPLITUDE: Final = {AxisKind.LINEAR: 2.5e-3, AxisKind.ROTARY: 2.5 / 3600.0}
#: That law as waves of normal cosine and sine: widths of equal probability, in its own (a square
#: of one degree of freedom is that of two times a number of the arcsine law).
_WIDTHS: Final = np.sin(0.5 * np.pi * (np.arange(5) + 0.5) / 5.0)
#: Periods other than the usual ones that stand for all of them; drawn from frequencies of which so
#: many lie in 1 / length, at most this number over that of the targets.
_OTHERS: Final = 64
_STEPS: Final = 8.0
_MOST: Final = 400_000
_NOTHING: Final = 1e-300
#: Equally likely draws of a hypothesis that are kept.
_KEPT: Final = 96
#: Standard deviation of what the readings alone decide, in those of their noise.
_VAGUE: Final = 1e4
#: Hypotheses that are less probable are not worked out.
_LEAST: Final = 0.01


@dataclass(frozen=True, slots=True)
class CurveColumns:
    """The functions of the error of an axis with given ``targets``: offset, slope, ``known``
    periods, and the smooth functions ``basis``; mm or deg.
    """

    basis: Basis
    targets: FloatArray
    known: tuple[float, ...]

    def columns(self, positions: FloatArray) -> FloatArray:
        """Return the functions of the error (k, j) at ``positions`` (k,), mm or deg."""
        first, span = self.targets[0], float(np.ptp(self.targets))
        line = [np.ones_like(positions)]
        if self.basis.turn is None:
            line.append((positions - first) / span)
        from_first = np.append(first, positions)
        waves = [wave[1:] for one in self.known for wave in wave_columns(from_first, 1.0 / one)]
        sines = self.basis.design(positions)[0][:, 2 : 2 + self.basis.sines]
        return np.column_stack([*line, *waves, sines])

    def wave(self, frequency: float, positions: FloatArray, phase: float = 0.0) -> FloatArray:
        """Return cosine and sine (k, 2) of a wave of a ``frequency`` (1 / mm or 1 / deg) at
        ``positions`` (k,), mm or deg. ``phase``: angle of the wave at the first target, rad.
        """
        angle = 2.0 * np.pi * frequency * (positions - self.targets[0]) + phase
        return np.column_stack([np.cos(angle), np.sin(angle)])


@dataclass(frozen=True, slots=True)
class WaveDraw:
    """One possible periodic error, and the longer wave that has the same values at the targets.

    The sum of both waves has cosine and sine with mean ``mean`` (2,) and covariance ``root``
    ``root``' (2, 2), normally distributed. The wave of ``period`` (mm or deg) is the ``share`` of
    this sum, plus an independent part of standard deviation ``apart``. The rest of the sum is the
    long wave, with frequency ``long`` (1 / mm or 1 / deg) and phase ``phase`` (rad). ``curve``
    (j,): change of the weights of the other columns. ``followed`` (j, 2): change of these weights
    per unit of cosine and sine.
    """

    period: float
    mean: FloatArray
    root: FloatArray
    share: float
    apart: float
    long: float
    phase: float
    curve: FloatArray
    followed: FloatArray


@dataclass(frozen=True, slots=True)
class WaveHypotheses:
    """Equally likely possible periodic errors (``waves``). With the probability ``probability`` one
    of these waves exists; else the error consists only of the functions ``curve``.
    """

    probability: float
    waves: tuple[WaveDraw, ...]
    curve: CurveColumns

    def drawn(self, targets: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return random draws (count, m) of the part of the error that the possible waves cause at
        ``targets``, (m,) or (count, m). This part is zero in draws without a wave.
        """
        unique, back = np.unique(targets, return_inverse=True)
        places = np.broadcast_to(back.reshape(targets.shape), (count, targets.shape[-1]))
        added = np.zeros(places.shape)
        there = np.flatnonzero(rng.uniform(size=count) < self.probability)
        owner = rng.permutation(np.arange(there.size) % max(len(self.waves), 1))
        columns = self.curve.columns(unique)
        for number, wave in enumerate(self.waves):
            mine = there[owner == number]
            both = wave.mean + rng.standard_normal((mine.size, 2)) @ wave.root.T
            own = wave.share * both + wave.apart * rng.standard_normal((mine.size, 2))
            for rows, sizes in (
                (columns, wave.curve + both @ wave.followed.T),
                (self.curve.wave(1.0 / wave.period, unique), own),
                (self.curve.wave(wave.long, unique, wave.phase), both - own),
            ):
                added[mine] += np.einsum("skj,sj->sk", rows[places[mine]], sizes)
        return added


@dataclass(frozen=True, slots=True)
class HiddenPeriods:
    """Possible periods of the error that the readings of an axis cannot show. Known and found
    periods are excluded.
    """

    hypotheses: tuple[WaveHypotheses, ...]

    @property
    def probability(self) -> float:
        """The probability that the error has a period that the readings cannot show."""
        return sum(each.probability for each in self.hypotheses)

    @property
    def periods(self) -> tuple[tuple[float, float], ...]:
        """The periods, mm or deg, each with its probability, the most probable first."""
        found: dict[float, float] = {}
        for each in self.hypotheses:
            for wave in each.waves:
                part = each.probability / len(each.waves)
                found[wave.period] = found.get(wave.period, 0.0) + part
        return tuple(sorted(found.items(), key=lambda pair: (-round(pair[1], 9), pair[0])))

    def waves(self, targets: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return random draws (count, m) of the part of the error that possible periods cause at
        ``targets``, mm or deg. Targets are (m,), or (count, m) for different targets in each draw.
        """
        added = np.zeros((count, targets.shape[-1]))
        for each in self.hypotheses:
            added += each.drawn(targets, count, rng)
        return added


def hidden_periods(
    bidirectional: BidirectionalMeans,
    basis: Basis,
    kind: AxisKind,
    search: PeriodSearch,
    known: Sequence[float],
    suggested: Sequence[float] = (),
) -> HiddenPeriods:
    """Return possible periods of the error that are neither ``known`` nor found by the ``search``.
    ``suggested``: known periods that the targets do not show.

    ``bidirectional``: mean of both directions at each target. ``basis``: functions of the smooth
    part. ``known``: periods (mm or deg) that are in the estimate.
    """
    found = [model for model in search.models if model.periods]
    without = sum(model.probability for model in search.models if not model.periods)
    cases = [(without, FURTHER if known else _FIRST, tuple(known))]
    if found:
        cases.append((1.0 - without, FURTHER, (*known, *found[0].periods)))
    taken = {period for model in found for period in model.periods}
    expected = _ExpectedPeriods(kind, tuple(suggested), frozenset(taken.union(known)))
    return HiddenPeriods(
        tuple(
            _hypotheses(part, bidirectional, basis, odds, present, expected)
            for part, odds, present in cases
            if part >= _LEAST
        )
    )


@dataclass(frozen=True, slots=True)
class _ExpectedPeriods:
    """The periods, mm or deg, that are expected of an axis of this ``kind`` before it is measured:
    the usual periods, the ``suggested`` periods, and any other period. ``taken``: periods that are
    already in the estimate.
    """

    kind: AxisKind
    suggested: tuple[float, ...]
    taken: frozenset[float]

    def periods(
        self, likelihood: PeriodLikelihood, odds: PeriodOdds
    ) -> tuple[FloatArray, FloatArray]:
        """Return possible periods (p,), mm or deg, and for each the log odds (p,) that the error
        has this period against no period. ``odds``: prior probabilities of no period and of the
        usual periods.

        The result contains the usual periods, and `_OTHERS` periods that represent all others. One
        half of these is drawn where the readings suggest a wave, the other half anywhere (defensive
        importance sampling: Hesterberg, Technometrics 37, 1995).
        """
        usual = usual_periods(self.kind, self.suggested)
        sizes, weights = np.array([(each.size, each.weight) for each in usual]).T
        shortest, longest = SHORTEST[self.kind], float(np.max(sizes))
        targets = likelihood.targets
        steps = _STEPS * float(np.ptp(targets)) * (1.0 / shortest - 1.0 / longest)
        count = int(np.clip(steps, _OTHERS, _MOST // targets.size))
        frequencies = np.linspace(1.0 / longest, 1.0 / shortest, count)
        even = np.where(self._there(frequencies, targets), 1.0 / frequencies, 0.0)
        even = even / max(float(np.sum(even)), _NOTHING)
        logs = likelihood.log_odds(frequencies, likelihood.coarse(), harmonics=1)[0]
        by_likelihood = even * np.exp(logs - np.max(logs))
        drawn = 0.5 * even + 0.5 * by_likelihood / max(float(np.sum(by_likelihood)), _NOTHING)
        places = _evenly(drawn, _OTHERS)
        other = 1.0 - odds.none - odds.usual
        prior = np.concatenate(
            [
                odds.usual * weights / np.sum(weights) * self._there(1.0 / sizes, targets),
                other * even[places] / np.maximum(_OTHERS * drawn[places], _NOTHING),
            ]
        )
        periods = np.concatenate([sizes, 1.0 / frequencies[places]])
        return periods, np.log(np.maximum(prior, _NOTHING) / odds.none)

    def _there(
        self, frequencies: FloatArray, targets: FloatArray
    ) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
        """Return a mask (f,) of the ``frequencies`` (f,): True for a frequency that the ``targets``
        (m,) can separate from the periods in the estimate.
        """
        near = PEAK / float(np.ptp(targets))
        free = np.ones(frequencies.size, dtype=np.bool_)
        for each in sorted(self.taken):
            for frequency in (1.0 / each, 2.0 / each):
                free &= np.abs(frequencies - frequency) > near
            free &= wave_similarity(targets, frequencies, 1.0 / each) < ALIASED
        return free


def _hypotheses(
    part: float,
    bidirectional: BidirectionalMeans,
    basis: Basis,
    odds: PeriodOdds,
    present: tuple[float, ...],
    expected: _ExpectedPeriods,
) -> WaveHypotheses:
    """Return the possible waves with one of the ``expected`` periods, in addition to the periods
    ``present`` of a model whose probability is ``part``. ``odds``: prior probabilities of no period
    and of the usual periods.
    """
    room = bidirectional.targets.size - LEFT - bidirectional.free.shape[1]
    curve = CurveColumns(basis, bidirectional.targets, present[: max(room // 4, 0)])
    waves = [w for one in curve.known for w in wave_columns(curve.targets, 1.0 / one)]
    free = np.column_stack([bidirectional.free, *waves])
    likelihood = PeriodLikelihood(replace(bidirectional, free=free), basis)
    periods, log_odds = expected.periods(likelihood, odds)
    long, phases = _long_waves(1.0 / periods, bidirectional.targets)
    width = (AMPLITUDE[expected.kind] * _WIDTHS / likelihood.unit) ** 2
    width = width[:, np.newaxis, np.newaxis]
    gram, moment = likelihood.moments(1.0 / periods, likelihood.everything(), harmonics=1)
    smooth = np.where(np.isfinite(long), likelihood.roughness**2, 0.0)
    each = _gains(gram, moment, width + smooth)
    logs = np.concatenate([node.log for node in likelihood.nodes])
    logs = logs - log_sum(logs)
    (without,) = _gains(gram, moment, smooth[np.newaxis, np.newaxis])
    each += logs[:, np.newaxis]
    each -= log_sums(logs[:, np.newaxis] + without)
    each += log_odds
    each -= np.log(width.size)
    together = log_sum(each.ravel())
    sines = curve.columns(bidirectional.targets)[:, -basis.sines :]
    fit = _SmoothFit(likelihood, bidirectional, np.hstack([free, sines]), curve)
    nodes = _evenly(np.exp(logs), _KEPT // 4)
    usual = np.mean([fit.followed(int(node))[0] for node in nodes], axis=0)
    kept = []
    shares = each - together
    for place in _evenly(np.exp(shares, out=shares).ravel(), _KEPT):
        level, node, number = (int(one) for one in np.unravel_index(place, each.shape))
        own, other = float(width[level, 0, 0]), float(smooth[number])
        squares = [[gram[max(i, j), min(i, j)][node, number] for i in (0, 1)] for j in (0, 1)]
        covariance = np.linalg.inv(np.array(squares) + np.eye(2) / (own + other))
        mean = covariance @ np.array([moment[i][node, number] for i in (0, 1)])
        mine, followed = fit.followed(node, float(periods[number]))
        kept.append(
            WaveDraw(
                float(periods[number]),
                likelihood.unit * mean,
                likelihood.unit * np.linalg.cholesky(covariance),
                own / (own + other),
                likelihood.unit * float(np.sqrt(own * other / (own + other))),
                float(long[number]) if other else 0.0,
                float(phases[number]),
                mine - usual,
                followed,
            )
        )
    return WaveHypotheses(part / (1.0 + float(np.exp(-together))), tuple(kept), curve)


def _gains(
    gram: Mapping[tuple[int, int], FloatArray], moment: Sequence[FloatArray], variance: FloatArray
) -> FloatArray:
    """Return by how much a wave with one harmonic increases the log likelihood (a, n, p), for each
    ``variance`` (a, 1, p) of its amplitude and each of n grid points of the parameters. ``gram``
    and ``moment``: matrix and right side of its normal equations.
    """
    step = max(1, CHUNK // variance.size)
    parts = [
        log_gains(
            {key: value[first : first + step] for key, value in gram.items()},
            [each[first : first + step] for each in moment],
            variance,
        )[0]
        for first in range(0, len(moment[0]), step)
    ]
    return np.concatenate(parts, axis=1)


def _long_waves(frequencies: FloatArray, targets: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the frequencies (f,) and phases (f,), rad, of the longer waves with the same values at
    the targets as waves of the ``frequencies`` (f,), 1 / mm or 1 / deg.

    A frequency is nan if its wave does not look like a longer wave at the ``targets`` (m,).
    """
    length = float(np.ptp(targets))
    window = SpectralWindow(targets, float(np.max(frequencies)) + LEAST_REPEATS / length)
    near = window.peaks[np.argmin(np.abs(frequencies[:, np.newaxis] - window.peaks), axis=1)]
    turns = np.exp(2j * np.pi * near[:, np.newaxis] * (targets - targets[0]))
    slow = window.slow(frequencies, LEAST_REPEATS / length)
    return np.where(slow, frequencies - near, np.nan), np.angle(np.mean(turns, axis=1))


@dataclass(frozen=True, slots=True)
class _SmoothFit:
    """Fits of the smooth error to the means at targets, for each grid point of parameters.

    ``columns`` (m, k): the functions that are fitted: offset, slope, known periods and smooth part.
    """

    likelihood: PeriodLikelihood
    bidirectional: BidirectionalMeans
    columns: FloatArray
    curve: CurveColumns

    def followed(self, node: int, period: float | None = None) -> tuple[FloatArray, FloatArray]:
        """Return the coefficients (j,), mm or deg, fitted at the grid point ``node``, and their
        change (j, 2) if the cosine or the sine of a ``period`` (amplitude 1) is subtracted from the
        readings.
        """
        likelihood, basis = self.likelihood, self.curve.basis
        place = node
        for nodes in likelihood.nodes:
            if place < nodes.log.size:
                break
            place -= nodes.log.size
        density = log_smooth(basis.frequencies, nodes.length, nodes.smoothness)
        deviations = np.concatenate(
            [
                np.full(self.columns.shape[1] - basis.sines, _VAGUE),
                float(nodes.smooth[place]) * np.exp(0.5 * density),
            ]
        )
        noise = np.sqrt(float(nodes.white[place])) * likelihood.root
        rows = noise[:, np.newaxis] * self.columns * deviations
        sides = [self.bidirectional.values[:, np.newaxis]]
        if period is not None:
            sides.append(-self.curve.wave(1.0 / period, self.bidirectional.targets))
        matrix = rows.T @ rows
        matrix.flat[:: matrix.shape[0] + 1] += 1.0
        found = np.linalg.solve(matrix, rows.T @ (noise[:, np.newaxis] * np.hstack(sides)))
        found = deviations[:, np.newaxis] * found
        # Datum and slope of single tests, and a missing direction, are not of the axis.
        line = 1 if basis.turn is not None else 2
        alone = self.bidirectional.free.shape[1]
        found = np.delete(found, np.arange(line, alone), axis=0)
        return found[:, 0], found[:, 1:]


def _evenly(shares: FloatArray, count: int) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """Return ``count`` indices, each about as often as its share in ``shares`` (n,), by systematic
    sampling.
    """
    ends = np.round(np.cumsum(shares), 9)
    points = (np.arange(count) + 0.5) / count * ends[-1]
    return np.asarray(np.searchsorted(ends, points), dtype=np.intp)
