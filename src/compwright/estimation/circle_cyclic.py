"""Search for a cyclic error of unknown pitch in the residuals of a fitted circular test.

A cyclic error of an axis (ISO 230-4:1996, B.2.3) repeats with the position x = R cosθ of the axis,
not with the angle. Its frequency therefore changes along the path (a chirp). One Fourier transform
of the weighted residuals over x, on an even grid, tests all frequencies approximately (Press and
Rybicki, Astrophysical Journal 338, 1989). The best frequencies are then tested exactly, together
with all other causes in the model.

An axis that follows late is not at its commanded position. With a lag of 40 ms at 3 000 mm/min it
is 2 mm behind, in one direction and in the other: more than many pitches. Therefore all delays are
tried with all frequencies.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_equations import CircleProblem
from compwright.estimation.circle_fit import CircleFit
from compwright.estimation.circle_lag import most_lag
from compwright.estimation.circle_model import (
    AXES,
    PRIORS,
    RESPONSE,
    UM,
    CauseColumn,
    CircleSamples,
    sample_spacing,
)
from compwright.estimation.circle_noise import inverse_cosine_transform, sum_and_difference
from compwright.records.axis import FloatArray

#: One search in a thousand finds a cyclic error where there is none.
_FALSE_ALARM: Final = 1e-3
_CANDIDATES: Final = 3
#: The longest pitch sought, in radii: four periods over the circle; longer ones are straightness
#: and scale.
_LONGEST: Final = 0.5
#: Phase from sample to sample, in half turns, up to which a pitch is sought where the axis is
#: fastest.
_STEEPEST: Final = 0.7
_OVERSAMPLING: Final = 8.0  # search steps within one period over the radius
#: Step of the delays that are tried, by the shortest pitch: at its ends a sixth of a turn is wrong.
_DELAYS: Final = 1.0 / 3.0
#: Places along the travel at which the weight of a frequency is computed, and delays, in pitches.
_PLACES: Final = 128
_LATEST: Final = 2.0
#: Periods over the radius by which the frequencies of two cyclic errors of one axis differ at
#: least. What is nearer is one error whose amplitude or pitch changes along the axis.
_NEAR: Final = 3.0
#: By how much a further cyclic error of an axis must exceed the threshold of the first: one of a
#: pitch too short for the samples looks like several small ones.
_FURTHER: Final = 2.0
#: How much of a cyclic error a slow instrument may lose.
_MOST_FADING: Final = 0.3


@dataclass(frozen=True, slots=True)
class CyclicSearch:
    """The result of a search for cyclic errors: ``axis``, ``frequency``, 1/mm, and delay ``late``,
    mm, of the likeliest cyclic error. ``axis`` is None if no frequency could be searched.
    ``hidden``: the largest amplitude, µm, that the search can miss, by axis. ``doubt``: standard
    deviation of the delay, mm, over all delays.

    ``gain``: by how much the cyclic error reduces the weighted sum of squares. ``threshold``: what
    noise hardly reaches. ``places``: number of independent frequencies of all axes.
    """

    axis: str | None
    frequency: float
    late: float
    hidden: Mapping[str, float]
    gain: float
    threshold: float
    places: float
    doubt: float = 0.0

    @property
    def clear(self) -> bool:
        """Whether noise hardly makes such a cyclic error."""
        return self.gain > self.threshold


def search_cyclic(
    problem: CircleProblem, fitted: CircleFit, waves: Mapping[str, float]
) -> CyclicSearch:
    """Return the likeliest cyclic error of either axis in the residuals of ``fitted``, away from
    the frequencies of those that are already in the model: ``waves``, 1/mm, by name.

    At most one axis has an error in the result, because a strong cyclic error of one axis has side
    lobes among the frequencies of the other. A cyclic error is clear if it reduces the weighted
    sum of squares by more than a threshold. Noise alone exceeds this threshold, at any of the
    frequencies and delays, once in a thousand searches (chi-square of two degrees of freedom:
    Scargle, Astrophysical Journal 263, 1982).
    """
    found = CyclicSearch(None, 0.0, 0.0, {}, 0.0, 1.0, 0.0)
    places, hidden = 0.0, {}
    delays = _delays(problem.samples, shortest_pitch(problem.samples))
    for axis in AXES:
        frequencies, gains, behind, least = _screen(problem, fitted, axis, delays)
        if not frequencies.size:
            continue
        for name, frequency in waves.items():
            if axis_of(name) == axis:
                near = np.abs(frequencies - frequency) * problem.samples.radius < _NEAR
                gains = np.where(near, 0.0, gains)
        tried = frequencies.size / _OVERSAMPLING * delays.size
        threshold = 2.0 * float(np.log(tried * 4.0 / _FALSE_ALARM))
        places += 2.0 * frequencies.size / _OVERSAMPLING
        # The longest pitch is the hardest to tell from straightness and from what no cause
        # explains.
        longest = np.linalg.eigvalsh(_weighed(problem, fitted, axis, float(frequencies[0]))[1])[0]
        hidden[axis] = float(np.sqrt(threshold / max(min(float(longest), least), 1e-300)))
        if axis in {axis_of(name) for name in waves}:
            threshold *= _FURTHER
        for index in _peaks(gains):
            frequency, late = float(frequencies[index]), float(behind[index])
            gain = _gain(problem, fitted, axis, frequency, late)
            if gain / threshold > found.gain / found.threshold:
                found = CyclicSearch(axis, frequency, late, {}, gain, threshold, 0.0)
    if found.axis is not None and found.clear:
        place = found.axis, found.frequency
        late, doubt = likeliest_delay(problem, fitted, *place, found.late)
        gain = _gain(problem, fitted, *place, late)
        found = replace(found, late=late, doubt=doubt, gain=max(gain, found.gain))
    return replace(found, hidden=hidden, places=places)


def _delays(samples: CircleSamples, pitch: float) -> FloatArray:
    """Return delays (l,), mm, of an axis that are to be tried with cyclic errors of a ``pitch``,
    mm, or longer. They are relative to the lag that is already subtracted from the angles, which is
    one of them.
    """
    step = _DELAYS * pitch
    first, last = -samples.lag, most_lag(samples) - samples.lag
    delays: FloatArray = step * np.arange(
        np.ceil(first * samples.radius / step), max(last * samples.radius / step, 0.0) + 1.0
    )
    return delays


def likeliest_delay(
    problem: CircleProblem, fitted: CircleFit, axis: str, frequency: float, late: float = 0.0
) -> tuple[float, float]:
    """Return the most probable delay, mm, of a cyclic error of this ``frequency``, 1/mm, and its
    standard deviation over all delays. ``late``: a delay to try too.

    The prior is the lag that the reversals show, or any lag, once in a thousand.
    """
    samples = problem.samples
    delays = np.append(_delays(samples, 0.25 / frequency), late)
    log = np.array([_gain(problem, fitted, axis, frequency, each) for each in delays.tolist()])
    width = max(samples.lag_std * samples.radius, sample_spacing(samples))
    log = 0.5 * (log - np.minimum((delays / width) ** 2, -2.0 * np.log(_FALSE_ALARM)))
    chance = np.exp(log - np.max(log))
    mean = float(chance @ delays) / float(np.sum(chance))
    spread = float(chance @ (delays - mean) ** 2) / float(np.sum(chance))
    return float(delays[np.argmax(log)]), float(np.sqrt(spread))


def wave_names(axis: str) -> Iterator[str]:
    """Yield names for the cyclic errors of an axis: ``first``, ``first_2``, ``first_3`` ..."""
    yield axis
    yield from (f"{axis}_{number}" for number in itertools.count(2))


def axis_of(wave: str) -> str:
    """Return the axis of a cyclic error with this name (`wave_names`)."""
    return wave.partition("_")[0]


def mean_position(samples: CircleSamples, axis: str) -> float:
    """Return the mean position, mm, of an axis over all samples; 0 is the centre of the circle."""
    along = np.cos(samples.theta) if axis == "first" else np.sin(samples.theta)
    return float(samples.radius * np.mean(along))


def cyclic_columns(
    samples: CircleSamples,
    name: str,
    frequency: float,
    amplitudes: tuple[float, float],
    late: float = 0.0,
) -> tuple[CauseColumn, ...]:
    """Return the model columns for the cyclic error ``name`` (`wave_names`) of ``frequency`` 1/mm
    and ``amplitudes`` (µm, of cosine and sine): its cosine, its sine, and columns for small changes
    of its frequency, delay and attenuation. ``late``: delay of the axis, mm.

    The cyclic error (ISO 230-4:1996, B.2.3) is a cos(2πfx) - b sin(2πfx) for ``amplitudes`` (a, b).
    The column of the frequency is per 1/mm. It leaves the phase at the `mean_position` unchanged,
    and thus the amplitude. The column of the delay is per mm of delay at full speed. The column of
    the attenuation is for the loss in an instrument of limited bandwidth. A first-order filter with
    time constant T loses the share (2π f v T)² / 2. This share falls with the square of the axis
    speed, so that the error is largest near the reversals.
    """
    axis, zero = axis_of(name), np.zeros_like(samples.theta)
    place, behind = _actual(samples, axis, late)
    phase = 2.0 * np.pi * frequency * place
    cosine, sine = UM * np.cos(phase), -UM * np.sin(phase)
    slope = 2.0 * np.pi * (amplitudes[0] * sine - amplitudes[1] * cosine)
    faded = -(behind**2) * (amplitudes[0] * cosine + amplitudes[1] * sine)
    spacing = sample_spacing(samples)
    sooner = float(np.hypot(samples.lag_std * samples.radius, spacing))
    lost = 0.5 * (2.0 * np.pi * frequency) ** 2 * (spacing**2 + (RESPONSE * samples.speed) ** 2)
    named = [
        (f"_cyclic_cos_{name}", cosine, PRIORS["_cyclic"]),
        (f"_cyclic_sin_{name}", sine, PRIORS["_cyclic"]),
        # A frequency off by the inverse of the travel would be another peak of the search.
        (
            f"_frequency_{name}",
            slope * (place - mean_position(samples, axis)),
            0.5 / samples.radius,
        ),
        (f"_late_{name}", slope * frequency * behind, sooner),
        (f"_fading_{name}", faded, min(lost, _MOST_FADING)),
    ]
    return tuple(
        CauseColumn(column, *((field, zero) if axis == "first" else (zero, field)), width)
        for column, field, width in named
    )


def shortest_pitch(samples: CircleSamples) -> float:
    """Return the shortest pitch, mm, of a cyclic error that the samples of a run can show.

    At this pitch the phase of the error changes by `_STEEPEST` half turns from sample to sample
    where the axis is fastest. One half turn is Nyquist's limit.
    """
    per_run = samples.theta.size / max(np.unique(samples.run).size, 1)
    return float(2.0 * samples.radius * samples.arc[1] / per_run / _STEEPEST)


def longest_pitch(samples: CircleSamples) -> float:
    """Return the longest pitch, mm, that can be distinguished from the other causes."""
    return _LONGEST * samples.radius


def _actual(samples: CircleSamples, axis: str, late: float) -> tuple[FloatArray, FloatArray]:
    """Return the actual position (n,) of an axis that is ``late`` mm behind its command at full
    speed, mm from the centre of the circle, and its change (n,) per mm of further delay.
    """
    theta = samples.theta - samples.sense * (late / samples.radius)
    cos, sin = np.cos(theta), np.sin(theta)
    if axis == "first":
        return samples.radius * cos, samples.sense * sin
    return samples.radius * sin, -samples.sense * cos


def _screen(
    problem: CircleProblem, fitted: CircleFit, axis: str, delays: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, float]:
    """Return candidate frequencies (f,), 1/mm, the approximate improvement (f,) of the fit by a
    cyclic error of each frequency, with the best of the ``delays`` (l,), mm, this delay (f,), and
    the least information (1 / variance), 1/µm², that the samples give about the amplitude.
    """
    samples, grid = problem.samples, problem.grid
    halves = [
        inverse_cosine_transform(rest / spectrum.density)
        for rest, spectrum in zip(fitted.rest, fitted.spectra, strict=True)
    ]
    if len(halves) == 2:
        halves = [(halves[0] + sign * halves[1]) / np.sqrt(2.0) for sign in (1.0, -1.0)]
    index = np.concatenate([each[0] for each in grid.index])
    own = replace(samples, theta=samples.theta[index], sense=samples.sense[index])
    turn = np.cos(own.theta) if axis == "first" else np.sin(own.theta)
    values = np.concatenate(halves) * turn
    radius = samples.radius
    step = shortest_pitch(samples) / 6.0
    cells = int(np.ceil(2.0 * radius / step)) + 2
    padded = max(int(np.ceil(_OVERSAMPLING * radius / step)), cells)
    frequencies = np.arange(padded // 2 + 1) / (padded * step)
    keep = (frequencies * longest_pitch(samples) >= 1.0) & (
        frequencies * shortest_pitch(samples) <= 1.0
    )
    frequencies = frequencies[keep]
    # A chirp is seen against the noise at its own local frequency: here its order in the cosine
    # transform.
    thin = turn[:: max(turn.size // _PLACES, 1)]
    speed = np.sqrt(np.maximum(1.0 - thin**2, 0.0))
    per_order = 4.0 * radius * samples.arc[1] / (2.0 * np.pi) * speed
    orders = np.minimum(np.outer(frequencies, np.pi * per_order).astype(np.intp), grid.size - 1)
    seen = [np.mean(thin**2 / spectrum.density[orders], axis=1) for spectrum in fitted.spectra]
    # A delay moves a cyclic error from the sum of the directions into their difference.
    late = np.linspace(0.0, _LATEST, _PLACES)
    moved = np.sin(2.0 * np.pi * np.outer(late, speed)) ** 2 @ thin**2 / np.sum(thin**2)
    best, found = np.zeros((2, frequencies.size))
    least = np.inf
    for delay in delays:
        place = (_actual(own, axis, delay)[0] + radius) / step
        low = place.astype(np.intp)
        share = place - low
        binned = (
            np.bincount(low, values * (1.0 - share), cells)
            + np.bincount(low + 1, values * share, cells)[:cells]
        )
        score = np.abs(np.fft.rfft(binned, padded)[keep]) ** 2
        part = np.interp(np.abs(delay) * frequencies, late, moved)
        weight = 0.5 * turn.size * ((1.0 - part) * seen[0] + part * seen[-1])
        least = min(least, float(np.min(weight, initial=np.inf)))
        gains = score / np.maximum(weight, 1e-300)
        found = np.where(gains > best, delay, found)
        best = np.maximum(gains, best)
    return frequencies, best, found, least * grid.index[0].shape[0] * UM**2


def _peaks(gains: FloatArray) -> FloatArray:
    inner = np.flatnonzero((gains[1:-1] >= gains[:-2]) & (gains[1:-1] > gains[2:])) + 1
    ends = [
        index
        for index, neighbour in ((0, 1), (gains.size - 1, gains.size - 2))
        if gains.size > 1 and gains[index] > gains[neighbour]
    ]
    every = np.concatenate([inner, np.array(ends, dtype=inner.dtype)])
    best: FloatArray = every[np.argsort(gains[every])[::-1][:_CANDIDATES]]
    return best


def _gain(
    problem: CircleProblem, fitted: CircleFit, axis: str, frequency: float, late: float
) -> float:
    """Return how much a cyclic error of this ``frequency``, 1/mm, of an axis that is ``late`` mm
    behind, reduces the weighted sum of squares.

    The formula is the one for columns added to a least-squares fit (Seber and Lee, Linear
    Regression Analysis, 2nd ed. 2003, section 3.7).
    """
    right, left = _weighed(problem, fitted, axis, frequency, late)
    return float(right @ np.linalg.solve(left, right))


def _weighed(
    problem: CircleProblem, fitted: CircleFit, axis: str, frequency: float, late: float = 0.0
) -> tuple[FloatArray, FloatArray]:
    """Return the right side (2,) and matrix (2, 2) of the normal equations for cosine and sine of a
    cyclic error, 1/µm². All other causes are fitted again.
    """
    samples = problem.samples
    columns = cyclic_columns(samples, axis, frequency, (0.0, 0.0), late)[:2]
    slopes = np.column_stack(
        [column.x * problem.towards_x + column.y * problem.towards_y for column in columns]
    )
    right = np.zeros(2)
    inner = np.zeros((2, 2))
    shared = np.zeros((2, fitted.values.size))
    for half, rows, rest, spectrum in zip(
        sum_and_difference(problem.grid, slopes),
        fitted.rows,
        fitted.rest,
        fitted.spectra,
        strict=True,
    ):
        weighted = half / spectrum.density[:, np.newaxis]
        right += weighted.T @ rest
        inner += weighted.T @ half
        shared += weighted.T @ rows
    # A column that the others can imitate gains nothing and must not gain by rounding.
    return right, inner - shared @ fitted.covariance @ shared.T + 1e-6 * np.diag(np.diag(inner))
