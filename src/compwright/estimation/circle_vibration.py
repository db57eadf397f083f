"""Search for a vibration of constant frequency in a circular test.

A vibration repeats in time; a cyclic error repeats with the position of an axis. The feed along the
path turns the commanded angles into times. Each run is searched by its periodogram (Scargle,
Astrophysical Journal 263, 1982), relative to the mean power of the neighbouring frequencies. A
vibration faster than half the sample rate appears at a lower frequency.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.circle_fit import CircleProblem
from compwright.estimation.circle_model import UM, CauseColumn, CircleSamples, travelled_share
from compwright.records.axis import FloatArray

#: One search in a thousand finds a vibration where there is none.
_FALSE_ALARM: Final = 1e-3
_OVERSAMPLING: Final = 4
#: Slower oscillations, in periods per radian of the arc, belong to the shape of the path.
_SLOWEST: Final = 2.0
#: Frequencies on either side from which the power without a vibration is taken, in steps of one
#: over the duration.
_AROUND: Final = 40
#: Prior of an amplitude, um.
_WIDTH: Final = 5.0


@dataclass(frozen=True, slots=True)
class Vibration:
    """The strongest vibration in a circular test: its frequency, and the largest amplitude that the
    search can miss.

    ``frequency``: Hz; None without a clear vibration. ``hidden``: amplitude, um, that may be
    undetected. ``least``: a vibration is reported if its sum of squared amplitudes, in units of
    their variances, reaches this value.
    """

    frequency: float | None
    hidden: float
    least: float = 0.0


def times(samples: CircleSamples) -> FloatArray:
    """Return the time of each sample relative to the middle of its run, s (n,)."""
    seconds: FloatArray = travelled_share(samples) * samples.arc[1] * samples.radius / samples.speed
    return seconds


def search_vibration(problem: CircleProblem, residual: FloatArray) -> Vibration:
    """Return the strongest vibration in the residuals (n,), mm, of a fit.

    The powers of several runs are added. The threshold is the power that noise exceeds once in a
    thousand searches, if the ordinates are independent and exponentially distributed (Scargle
    1982).
    """
    samples = problem.samples
    seconds = times(samples)
    runs = [np.flatnonzero(samples.run == number) for number in np.unique(samples.run)]
    size = min(run.size for run in runs)
    duration = samples.arc[1] * samples.radius / samples.speed
    padded = _OVERSAMPLING * size
    power = np.zeros(padded // 2 + 1)
    for run in runs:
        even = (np.arange(size) + 0.5) * duration / size - 0.5 * duration
        order = np.argsort(seconds[run])
        values = np.interp(even, seconds[run][order], residual[run][order])
        taper = np.sin(np.pi * (np.arange(size) + 0.5) / size)
        spectrum = np.fft.rfft(values * taper, padded)
        power += np.abs(spectrum) ** 2 / np.sum(taper**2)
    frequencies = np.arange(power.size) / (_OVERSAMPLING * duration)
    wide = _AROUND * _OVERSAMPLING
    padded_power = np.pad(power, wide, mode="reflect") if power.size > wide else power
    if padded_power.size == power.size:
        return Vibration(None, float("nan"))
    windows = np.lib.stride_tricks.sliding_window_view(padded_power, 2 * wide + 1)
    # The median of a sum of exponential powers lies below its mean by about a third of one of them.
    floor = np.median(windows[:, ::_OVERSAMPLING], axis=1) / (1.0 - 0.31 / len(runs))
    keep = (frequencies * duration >= _SLOWEST * samples.arc[1]) & (
        frequencies <= 0.98 * 0.5 * size / duration
    )
    if not np.any(keep):
        return Vibration(None, float("nan"))
    threshold = _threshold(int(np.sum(keep)) / _OVERSAMPLING * 2.0, len(runs))
    ratio = np.where(keep, power / np.maximum(floor, 1e-300), 0.0)
    best = int(np.argmax(ratio))
    # Power of an amplitude a with this taper: 0.2 a² n for each run.
    level = float(np.median(floor[keep]))
    hidden = float(np.sqrt(level * threshold / len(runs) / (0.2 * size)) / UM)
    if ratio[best] <= threshold:
        return Vibration(None, hidden)
    found = float(_peak(frequencies, power, best))
    return Vibration(found, hidden, 2.0 * len(runs) * threshold)


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


def vibration_columns(samples: CircleSamples, frequency: float) -> list[CauseColumn]:
    """Return two model columns for every run: cosine and sine of a radial vibration of
    ``frequency`` Hz, um.
    """
    phase = 2.0 * np.pi * frequency * times(samples)
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    found = []
    for number in np.unique(samples.run):
        for part, wave in (("cos", np.cos(phase)), ("sin", np.sin(phase))):
            shape = UM * wave * (samples.run == number)
            name = f"_vibration_{part}_{int(number)}"
            found.append(CauseColumn(name, shape * cos, shape * sin, _WIDTH))
    return found
