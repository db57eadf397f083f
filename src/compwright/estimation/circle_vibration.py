"""Search for a vibration of constant frequency in a circular test.

A vibration repeats in time; a cyclic error repeats with the position of an axis. The feed along the
path turns the commanded angles into times. Each run is searched by its periodogram (Scargle,
Astrophysical Journal 263, 1982), relative to the mean power of the neighbouring frequencies. A
vibration faster than half the sample rate appears at a lower frequency.

A vibration of one axis moves the bar in proportion to cosθ or sinθ. The readings then have two
frequencies, one turn of the circle above and below that of the vibration, and readings times cosθ
or sinθ have the vibration itself. All three are searched.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_fit import CircleProblem
from compwright.estimation.circle_model import AXES, UM, CauseColumn, CircleSamples, travelled_share
from compwright.records.axis import FloatArray

#: One search in a thousand finds a vibration where there is none.
_FALSE_ALARM: Final = 1e-3
_OVERSAMPLING: Final = 4
#: Slower oscillations, in periods per radian of the arc, belong to the shape of the path.
_SLOWEST: Final = 2.0
#: Frequencies on either side from which the power without a vibration is taken, in steps of one
#: over the duration.
_AROUND: Final = 40
#: What readings are multiplied by to show the vibration of the bar (None) or of an axis.
_DIRECTIONS: Final[Mapping[str | None, Callable[[FloatArray], FloatArray]]] = {
    None: np.ones_like,
    "first": np.cos,
    "second": np.sin,
}
#: Prior of an amplitude, um.
_WIDTH: Final = 5.0


@dataclass(frozen=True, slots=True)
class Vibration:
    """The strongest vibration in a circular test: its frequency, and the largest amplitude that the
    search can miss.

    ``frequency``: Hz; None without a clear vibration. ``axis``: the axis that vibrates, None if the
    bar vibrates along its length. ``hidden``: amplitude, um, that may be
    undetected. ``least``: a vibration is reported if its sum of squared amplitudes, in units of
    their variances, reaches this value.
    """

    frequency: float | None
    hidden: float
    least: float = 0.0
    axis: str | None = None


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
    frequencies = np.arange(_OVERSAMPLING * size // 2 + 1) / (_OVERSAMPLING * duration)
    if frequencies.size <= _AROUND * _OVERSAMPLING:
        return Vibration(None, float("nan"))
    keep = (frequencies * duration >= _SLOWEST * samples.arc[1]) & (
        frequencies <= 0.98 * 0.5 * size / duration
    )
    if not np.any(keep):
        return Vibration(None, float("nan"))
    threshold = _threshold(3.0 * int(np.sum(keep)) / _OVERSAMPLING * 2.0, len(runs))
    even = (np.arange(size) + 0.5) * duration / size - 0.5 * duration
    taper = np.sin(np.pi * (np.arange(size) + 0.5) / size)
    best, found, hidden = threshold, Vibration(None, float("nan")), float("nan")
    for axis, share in _DIRECTIONS.items():
        power = np.zeros(frequencies.size)
        seen = residual * share(samples.theta)
        for run in runs:
            order = np.argsort(seconds[run])
            values = np.interp(even, seconds[run][order], seen[run][order])
            spectrum = np.fft.rfft(values * taper, _OVERSAMPLING * size)
            power += np.abs(spectrum) ** 2 / np.sum(taper**2)
        floor = _floor(power, len(runs))
        ratio = np.where(keep, power / np.maximum(floor, 1e-300), 0.0)
        place = int(np.argmax(ratio))
        if axis is None:
            # Power of an amplitude a with this taper: 0.2 a² n for each run.
            level = float(np.median(floor[keep]))
            hidden = float(np.sqrt(level * threshold / len(runs) / (0.2 * size)) / UM)
        if ratio[place] > best:
            best, peak = float(ratio[place]), float(_peak(frequencies, power, place))
            found = Vibration(peak, hidden, 2.0 * len(runs) * threshold, axis)
    return replace(found, hidden=hidden)


def _floor(power: FloatArray, runs: int) -> FloatArray:
    """Return the power of the noise at each frequency (f,): a running median of the ``power`` that
    was summed over ``runs`` runs.
    """
    wide = _AROUND * _OVERSAMPLING
    windows = np.lib.stride_tricks.sliding_window_view(
        np.pad(power, wide, mode="reflect"), 2 * wide + 1
    )
    # The median of a sum of exponential powers lies below its mean by about a third of one of them.
    floor: FloatArray = np.median(windows[:, ::_OVERSAMPLING], axis=1) / (1.0 - 0.31 / runs)
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
    """Return two model columns for every run: cosine and sine of the vibration ``found``, um.

    A vibration of one axis has as its size that of a vibration along the bar with the same root
    mean square of the readings over a full circle: its own amplitude by sqrt(2).
    """
    phase = 2.0 * np.pi * (found.frequency or 0.0) * times(samples)
    x, y = (
        (np.cos(samples.theta), np.sin(samples.theta))
        if found.axis is None
        else (np.sqrt(2.0) * (found.axis == axis) * np.ones_like(samples.theta) for axis in AXES)
    )
    columns = []
    for number in np.unique(samples.run):
        for part, wave in (("cos", np.cos(phase)), ("sin", np.sin(phase))):
            shape = UM * wave * (samples.run == number)
            name = f"_vibration_{part}_{int(number)}"
            columns.append(CauseColumn(name, shape * x, shape * y, _WIDTH))
    return columns
