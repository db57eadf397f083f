"""Search for a vibration of constant frequency in a circular test.

A vibration repeats in time; a cyclic error repeats with the position of an axis. The feed along the
path turns the commanded angles into times. Each run is searched by its periodogram (Scargle,
Astrophysical Journal 263, 1982), relative to the mean power of the neighbouring frequencies. A
vibration faster than half the sample rate appears at a lower frequency.

A vibration of one axis moves the bar in proportion to cosθ or sinθ. The readings then have two
frequencies, one turn of the circle above and below that of the vibration, and readings times cosθ
or sinθ have the vibration itself. All three are searched.

The causes of a long run are fitted to means of neighbouring samples. Vibrations that the means
cannot show are searched in the samples themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_equations import CircleProblem
from compwright.estimation.circle_model import AXES, UM, CauseColumn, CircleSamples
from compwright.estimation.circle_noise import IndexArray
from compwright.records.axis import FloatArray

#: One search in a thousand finds a vibration where there is none.
_FALSE_ALARM: Final = 1e-3
_OVERSAMPLING: Final = 4
#: Slower oscillations, in periods per radian of the arc, belong to the shape of the path.
_SLOWEST: Final = 2.0
#: Frequencies on either side from which the power without a vibration is taken, in steps of one
#: over the duration.
_AROUND: Final = 40
#: The highest frequency of a search as a share of half the sample rate.
_FASTEST: Final = 0.98
#: What readings are multiplied by to show the vibration of the bar (None) or of an axis.
_DIRECTIONS: Final[Mapping[str | None, Callable[[FloatArray], FloatArray]]] = {
    None: np.ones_like,
    "first": np.cos,
    "second": np.sin,
}
#: Means between two reversal points below which their path is not interpolated.
_FEWEST: Final = 4
#: Prior of an amplitude, um.
_WIDTH: Final = 5.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Vibration:
    """The strongest vibration in a circular test, and the largest amplitudes, um, that the search
    can miss. An amplitude is a root mean square over runs and angles.

    ``frequency``: Hz; None without a clear vibration. ``axis``: the axis that vibrates, None if the
    bar vibrates along its length. ``hidden``: amplitude that may be undetected, by axis (None:
    along the bar). ``strength``: power, mm². ``places``: number of independent frequencies, along
    the bar and of both axes, among which it was found. ``density``: noise variance, mm², at this
    frequency. ``step``: time between samples, s.

    ``amplitude`` and ``std_error``, um: those of a vibration that was fitted to the samples
    themselves, not to their means.
    """

    frequency: float | None = None
    hidden: Mapping[str | None, float] = field(default_factory=dict)
    places: float = 1.0
    axis: str | None = None
    strength: float = 0.0
    density: float = 0.0
    step: float = 0.0
    amplitude: float | None = None
    std_error: float = 0.0

    def or_stronger(self, other: Vibration) -> Vibration:
        """Return the stronger of two vibrations, found in different ranges of frequency. Both
        ranges hide what one of them hides.
        """
        most = {
            axis: max(each.hidden.get(axis, 0.0) for each in (self, other))
            for axis in {**self.hidden, **other.hidden}
        }
        stronger = max(self, other, key=lambda each: (bool(each.frequency), each.strength))
        return replace(stronger, hidden=most)


def times(samples: CircleSamples) -> FloatArray:
    """Return the time of each sample, s (n,), from the middle of the arc."""
    middle = samples.arc[0] + 0.5 * samples.arc[1]
    seconds: FloatArray = (
        samples.sense * (samples.commanded - middle) * samples.radius / samples.speed
    )
    return seconds


def search_vibration(
    samples: CircleSamples, residual: FloatArray, *, above: float | None = None
) -> Vibration:
    """Return the strongest vibration in the residuals (n,), mm, of a fit.

    ``above``: least frequency, Hz (None: faster than the shape of the path).

    The powers of several runs are added. The threshold is the power that noise exceeds once in a
    thousand searches, if the ordinates are independent and exponentially distributed (Scargle
    1982).
    """
    seconds, runs = times(samples), _runs(samples)
    step = _time_step(seconds, runs)
    size = max(round(np.ptp(seconds[run]) / step) + 1 for run in runs)
    length = _transform_length(_OVERSAMPLING * size)
    frequencies = np.arange(length // 2 + 1) / (length * step)
    if above is None:
        above = _SLOWEST * samples.speed / samples.radius
    keep = (frequencies >= above) & (frequencies <= _FASTEST * 0.5 / step)
    if frequencies.size <= _AROUND * _OVERSAMPLING or not np.any(keep):
        return Vibration()
    places = float(len(_DIRECTIONS) * np.sum(keep) / _OVERSAMPLING)
    threshold = _threshold(2.0 * places, len(runs))
    shown = mean_share(frequencies[keep], step, samples.averaged)
    found, hidden, density = Vibration(), {}, np.zeros(0)
    tapered = [_tapered(samples, seconds[run], residual, run, step) for run in runs]
    for axis, turned in _DIRECTIONS.items():
        power, gain, weight, weights = np.zeros(frequencies.size), 0.0, 0.0, 0.0
        for theta, taper, values in tapered:
            share = turned(theta)
            power += np.abs(np.fft.rfft(values * share, length)) ** 2
            moved = float(taper @ share**2) * _unit(samples, axis)
            gain += (0.5 * UM * moved) ** 2 / float(np.sum(taper**2))
            weight, weights = weight + moved, weights + float(np.sum(taper))
        floor = _floor(power, len(runs))
        if axis is None:
            density = floor / len(runs)
        # Vibrations are compared by power alone: a strong one raises the floor around it.
        powers = np.where(keep & (power > threshold * floor), power, 0.0)
        place = int(np.argmax(powers))
        # The taper weighs the middle of the arc, where one axis may move the bar more.
        seen_there = weight / weights / _unit(samples, axis)
        strength = float(powers[place] / seen_there) * samples.averaged
        hidden[axis] = float(np.sqrt(np.max(floor[keep] / shown**2) * threshold / gain))
        if strength > found.strength:
            found = Vibration(
                frequency=_peak(frequencies, power, place),
                places=places,
                axis=axis,
                strength=strength,
                density=float(density[place]),
                step=step / samples.averaged,
            )
    return replace(found, hidden=hidden)


def _tapered(
    samples: CircleSamples, seconds: FloatArray, residual: FloatArray, run: IndexArray, step: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the angles, rad, of a run at times ``step`` apart, a taper, and the residuals, mm,
    times the taper over its norm: each (m,). ``seconds``: time of each sample of the ``run``.
    """
    order = np.argsort(seconds)
    seconds, order = seconds[order], run[order]
    even = seconds[0] + step * np.arange(round((seconds[-1] - seconds[0]) / step) + 1)
    taper = np.sin(np.pi * (np.arange(even.size) + 0.5) / even.size)
    theta, values = (np.interp(even, seconds, each[order]) for each in (samples.theta, residual))
    return theta, taper, values * taper / np.sqrt(np.sum(taper**2))


def search_between_means(
    every: CircleSamples, problem: CircleProblem, residual: FloatArray
) -> tuple[Vibration, FloatArray]:
    """Return the strongest vibration that is too fast for means of neighbouring samples, and its
    part in the means, mm (m,).

    ``every``: the n samples. ``problem``, ``residual`` (m,): equations and residuals, mm, of a fit
    to means of neighbouring samples. A vibration faster than half the rate of the means
    appears in them smaller and at another frequency. It is fitted to the samples themselves, with
    the noise at its own frequency.
    """
    means = problem.samples
    rest = _residuals(every, means, means.deviations - residual)
    step = _time_step(times(means), _runs(means))
    found = search_vibration(rest, rest.deviations, above=_FASTEST * 0.5 / step)
    if found.frequency is None:
        return found, np.zeros(means.theta.size)
    columns = vibration_columns(rest, found)
    waves = np.column_stack([c.x * np.cos(rest.theta) + c.y * np.sin(rest.theta) for c in columns])
    inverse = np.linalg.inv(waves.T @ waves)
    sizes = inverse @ (waves.T @ rest.deviations)
    variance, runs = found.density * np.diag(inverse), len(_runs(rest))
    power = float(np.sum(sizes**2)) / runs
    found = replace(
        found,
        amplitude=float(np.sqrt(max(power - 0.5 * float(np.sum(variance)) / runs, 0.0))),
        std_error=float(np.sqrt(np.sum(variance * sizes**2) / max(power, 1e-24))) / runs,
    )
    return found, problem.seen(vibration_columns(means, found)) @ sizes


def _residuals(every: CircleSamples, means: CircleSamples, path: FloatArray) -> CircleSamples:
    """Return the samples with their deviations minus the ``path`` (m,), mm, that was fitted to the
    ``means``. The path is interpolated between two reversal points of the axes. Samples within one
    or two means of a reversal point are left out.
    """
    theta, rest = every.theta - every.sense * means.lag, np.full(every.theta.size, np.nan)
    quarters = np.floor(theta / (0.5 * np.pi)), np.floor(means.theta / (0.5 * np.pi))
    for number in np.unique(means.run):
        for quarter in np.unique(quarters[1][means.run == number]):
            here, there = (
                np.flatnonzero((each.run == number) & (places == quarter))
                for each, places in zip((every, means), quarters, strict=True)
            )
            order = there[np.argsort(means.theta[there])]
            place = np.interp(theta[here], means.theta[order], np.arange(order.size, dtype=float))
            inside = (place >= 1.0) & (place <= order.size - 2.0) & (order.size >= _FEWEST)
            rest[here[inside]] = _cubic(place[inside], path[order])
    rest = every.deviations - rest
    kept = np.isfinite(rest)
    return replace(
        every,
        theta=every.theta[kept],
        sense=every.sense[kept],
        deviations=rest[kept],
        run=every.run[kept],
    )


def _cubic(place: FloatArray, values: FloatArray) -> FloatArray:
    """Return ``values`` (m,) between their indices at ``place`` (n,), by cubic convolution (Keys,
    IEEE Trans. Acoustics, Speech, and Signal Processing 29, 1981). 1 <= ``place`` <= m - 2.
    """
    at = np.clip(place.astype(np.intp), 1, values.size - 3)
    s = place - at
    a, b, c, d = (values[at + k] for k in range(-1, 3))
    bend = 2.0 * a - 5.0 * b + 4.0 * c - d + s * (3.0 * (b - c) + d - a)
    between: FloatArray = b + 0.5 * s * (c - a + s * bend)
    return between


def _runs(samples: CircleSamples) -> list[IndexArray]:
    return [np.flatnonzero(samples.run == number) for number in np.unique(samples.run)]


def _time_step(seconds: FloatArray, runs: list[IndexArray]) -> float:
    """Return the time, s, between neighbouring samples, without the gaps at the reversal points."""
    steps = np.concatenate([np.diff(np.sort(seconds[run])) for run in runs])
    usual = max(float(np.median(steps)), 0.5 * float(np.mean(steps)))
    return float(np.mean(steps[steps < 1.5 * usual]))


def _transform_length(least: int) -> int:
    """Return the smallest length of at least ``least`` for which a Fourier transform is fast: a
    power of two times 1, 3, 5 or 9.
    """
    return min(m << int(np.ceil(np.log2(least / m))) for m in (1, 3, 5, 9))


def mean_share(frequencies: FloatArray, step: float, averaged: int) -> FloatArray:
    """Return the share of a wave of each of the ``frequencies`` (f,), Hz, that the mean of
    ``averaged`` samples keeps. ``step``: time between two means, s.
    """
    share: FloatArray = np.sinc(frequencies * step) / np.sinc(frequencies * step / averaged)
    return share


def radial_share(samples: CircleSamples, axis: str | None) -> FloatArray:
    """Return the readings (n,) of a vibration of an ``axis`` (None: along the bar) with a root mean
    square of 1: cosθ or sinθ, scaled.
    """
    return _DIRECTIONS[axis](samples.theta) * _unit(samples, axis)


def _unit(samples: CircleSamples, axis: str | None) -> float:
    """Return the amplitude whose readings have a root mean square of 1."""
    return float(1.0 / np.sqrt(np.mean(_DIRECTIONS[axis](samples.theta) ** 2)))


def _floor(power: FloatArray, runs: int) -> FloatArray:
    """Return the power of the noise at each frequency (f,): a running median of the ``power`` that
    was summed over ``runs`` runs.
    """
    wide = _AROUND * _OVERSAMPLING
    windows = np.lib.stride_tricks.sliding_window_view(
        np.pad(power, wide, mode="reflect"), 2 * wide + 1
    )
    places = np.append(np.arange(0, power.size, _AROUND), power.size - 1)
    # The median of a sum of exponential powers lies below its mean by about a third of one of them.
    medians = np.median(windows[places, ::_OVERSAMPLING], axis=1) / (1.0 - 0.31 / runs)
    floor: FloatArray = np.interp(np.arange(power.size), places, medians)
    return floor


def _threshold(count: float, runs: int) -> float:
    """Return the power, as a multiple of the mean power of noise, that noise exceeds with
    probability `_FALSE_ALARM` at one or more of ``count`` independent frequencies.

    The power at a frequency is a sum of ``runs`` exponentially distributed terms (Erlang
    distribution). The equation is solved by iteration.
    """
    chance = np.log(count / _FALSE_ALARM)
    value = chance
    for _ in range(30):
        terms = sum(value**k / float(np.prod(np.arange(1, k + 1))) for k in range(runs))
        value = chance + np.log(terms)
    return float(value / runs)


def _peak(frequencies: FloatArray, power: FloatArray, best: int) -> float:
    if not 0 < best < power.size - 1:
        return float(frequencies[best])
    low, middle, high = np.log(np.maximum(power[best - 1 : best + 2], 1e-300))
    bend = low - 2.0 * middle + high
    shift = 0.5 * (low - high) / bend if bend < 0.0 else 0.0
    return float(frequencies[best] + shift * (frequencies[1] - frequencies[0]))


def vibration_columns(samples: CircleSamples, found: Vibration) -> list[CauseColumn]:
    """Return two model columns for every run: cosine and sine of the vibration ``found``, um. A
    vibration of an axis has two more, for the other axis.

    The size of a vibration of an axis is the root mean square of its readings, as for a vibration
    along the bar: its own amplitude times that of cosθ or sinθ.
    """
    frequency, seconds = found.frequency or 0.0, times(samples)
    step = _time_step(seconds, _runs(samples))
    scale = UM * float(mean_share(np.array([frequency]), step, samples.averaged)[0])
    columns = []
    for axis in (None,) if found.axis is None else AXES:
        x, y = (
            (np.cos(samples.theta), np.sin(samples.theta))
            if axis is None
            else (np.full(seconds.size, float(axis == each)) for each in AXES)
        )
        for number in np.unique(samples.run):
            for part, wave in (("cos", np.cos), ("sin", np.sin)):
                shape = scale * _unit(samples, axis) * wave(2.0 * np.pi * frequency * seconds)
                shape *= samples.run == number
                name = f"_vibration_{part}_{int(number)}_{axis}"
                columns.append(CauseColumn(name, shape * x, shape * y, _WIDTH))
    return columns
