"""Search for a cyclic error of unknown pitch in the residuals of a fitted circular test.

A cyclic error of an axis (ISO 230-4:1996, B.2.3) repeats with the position x = R cosθ of the axis,
not with the angle. Its frequency therefore changes along the path (a chirp). One Fourier transform
of the weighted residuals over x, on an even grid, tests all frequencies approximately (Press and
Rybicki, Astrophysical Journal 338, 1989). The best frequencies are then tested exactly, together
with all other causes in the model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_equations import CircleProblem
from compwright.estimation.circle_fit import CircleFit
from compwright.estimation.circle_model import (
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
#: How much of a cyclic error a slow instrument may lose.
_MOST_FADING: Final = 0.3


@dataclass(frozen=True, slots=True)
class CyclicSearch:
    """The result of a search for cyclic errors: ``axis`` and ``frequency``, 1/mm, of the likeliest
    cyclic error. ``axis`` is None if no frequency could be searched. ``hidden``: the largest
    amplitude, µm, that the search can miss, by axis.

    ``gain``: by how much the cyclic error reduces the weighted sum of squares. ``threshold``: what
    noise hardly reaches. ``places``: number of independent frequencies of all axes.
    """

    axis: str | None
    frequency: float
    hidden: Mapping[str, float]
    gain: float
    threshold: float
    places: float

    @property
    def clear(self) -> bool:
        """Whether noise hardly makes such a cyclic error."""
        return self.gain > self.threshold


def search_cyclic(problem: CircleProblem, fitted: CircleFit, axes: Sequence[str]) -> CyclicSearch:
    """Return the likeliest cyclic error of the ``axes`` in the residuals of ``fitted``.

    At most one axis has an error in the result, because a strong cyclic error of one axis has side
    lobes among the frequencies of the other. A cyclic error is clear if it reduces the weighted
    sum of squares by more than a threshold. Noise alone exceeds this threshold, at any of the
    frequencies, once in a thousand searches (chi-square of two degrees of freedom: Scargle,
    Astrophysical Journal 263, 1982).
    """
    found = CyclicSearch(None, 0.0, {}, 0.0, 1.0, 0.0)
    places, hidden = 0.0, {}
    for axis in axes:
        frequencies, gains, least = _screen(problem, fitted, axis)
        if not frequencies.size:
            continue
        threshold = 2.0 * float(np.log(frequencies.size / _OVERSAMPLING * 4.0 / _FALSE_ALARM))
        places += 2.0 * frequencies.size / _OVERSAMPLING
        # The longest pitch is the hardest to tell from straightness and from what no cause
        # explains.
        longest = np.linalg.eigvalsh(_weighed(problem, fitted, axis, float(frequencies[0]))[1])[0]
        hidden[axis] = float(np.sqrt(threshold / max(min(float(longest), least), 1e-300)))
        exact = [
            (_gain(problem, fitted, axis, frequencies[index]), float(frequencies[index]))
            for index in _peaks(gains)
        ]
        best = max(exact, default=(0.0, 0.0))
        if best[0] / threshold > found.gain / found.threshold:
            found = CyclicSearch(axis, best[1], {}, best[0], threshold, 0.0)
    return replace(found, hidden=hidden, places=places)


def mean_position(samples: CircleSamples, axis: str) -> float:
    """Return the mean position, mm, of an axis over all samples; 0 is the centre of the circle."""
    along = np.cos(samples.theta) if axis == "first" else np.sin(samples.theta)
    return float(samples.radius * np.mean(along))


def cyclic_columns(
    samples: CircleSamples,
    axis: str,
    frequency: float,
    amplitudes: tuple[float, float],
    late: float = 0.0,
) -> tuple[CauseColumn, ...]:
    """Return the model columns for an axis' cyclic error of ``frequency`` 1/mm and ``amplitudes``
    (µm, of cosine and sine): its cosine, its sine, and columns for small changes of its frequency,
    delay and attenuation. ``late``: delay of the axis, mm.

    The cyclic error (ISO 230-4:1996, B.2.3) is a cos(2πfx) - b sin(2πfx) for ``amplitudes`` (a, b).
    The column of the frequency is per 1/mm. It leaves the phase at the `mean_position` unchanged,
    and thus the amplitude. The column of the delay is per mm of delay at full speed. The column of
    the attenuation is for the loss in an instrument of limited bandwidth. A first-order filter with
    time constant T loses the share (2π f v T)² / 2. This share falls with the square of the axis
    speed, so that the error is largest near the reversals.
    """
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    zero = np.zeros_like(samples.theta)
    along, behind = (cos, samples.sense * sin) if axis == "first" else (sin, -samples.sense * cos)
    place = samples.radius * along + late * behind
    phase = 2.0 * np.pi * frequency * place
    cosine, sine = UM * np.cos(phase), -UM * np.sin(phase)
    slope = 2.0 * np.pi * (amplitudes[0] * sine - amplitudes[1] * cosine)
    faded = -(behind**2) * (amplitudes[0] * cosine + amplitudes[1] * sine)
    spacing = sample_spacing(samples)
    sooner = float(np.hypot(samples.lag_std * samples.radius, spacing))
    lost = 0.5 * (2.0 * np.pi * frequency) ** 2 * (spacing**2 + (RESPONSE * samples.speed) ** 2)
    named = [
        (f"_cyclic_cos_{axis}", cosine, PRIORS["_cyclic"]),
        (f"_cyclic_sin_{axis}", sine, PRIORS["_cyclic"]),
        # A frequency off by the inverse of the travel would be another peak of the search.
        (
            f"_frequency_{axis}",
            slope * (place - mean_position(samples, axis)),
            0.5 / samples.radius,
        ),
        (f"_late_{axis}", slope * frequency * behind, sooner),
        (f"_fading_{axis}", faded, min(lost, _MOST_FADING)),
    ]
    return tuple(
        CauseColumn(name, *((field, zero) if axis == "first" else (zero, field)), width)
        for name, field, width in named
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


def _screen(
    problem: CircleProblem, fitted: CircleFit, axis: str
) -> tuple[FloatArray, FloatArray, float]:
    """Return candidate frequencies (f,), 1/mm, the approximate improvement of the fit by a cyclic
    error of each frequency, and the least information (1 / variance), 1/µm², that the samples give
    about the amplitude.
    """
    samples, grid = problem.samples, problem.grid
    shared = fitted.rest[0] / fitted.spectra[0].density
    index = grid.index[0][0]
    turn = np.cos(samples.theta[index]) if axis == "first" else np.sin(samples.theta[index])
    speed = np.sqrt(np.maximum(1.0 - turn**2, 0.0))
    radius = samples.radius
    step = shortest_pitch(samples) / 6.0
    cells = int(np.ceil(2.0 * radius / step)) + 2
    place = (turn + 1.0) * radius / step
    low = place.astype(np.intp)
    share = place - low
    values = inverse_cosine_transform(shared) * turn
    binned = (
        np.bincount(low, values * (1.0 - share), cells)
        + np.bincount(low + 1, values * share, cells)[:cells]
    )
    padded = max(int(np.ceil(_OVERSAMPLING * radius / step)), cells)
    score = np.fft.rfft(binned, padded)
    frequencies = np.arange(score.size) / (padded * step)
    keep = (frequencies * longest_pitch(samples) >= 1.0) & (
        frequencies * shortest_pitch(samples) <= 1.0
    )
    frequencies, score = frequencies[keep], score[keep]
    # A chirp is seen against the noise at its own local frequency: here its order in the cosine
    # transform.
    thin = slice(None, None, max(turn.size // 128, 1))
    per_order = 4.0 * radius * samples.arc[1] / (2.0 * np.pi) * speed[thin]
    orders = np.minimum(np.outer(frequencies, np.pi * per_order).astype(np.intp), grid.size - 1)
    weight = 0.5 * turn.size * np.mean(turn[thin] ** 2 / fitted.spectra[0].density[orders], axis=1)
    runs = len(grid.index) * grid.index[0].shape[0]
    least = float(np.min(weight, initial=np.inf)) * runs * UM**2
    return frequencies, np.abs(score) ** 2 / np.maximum(weight, 1e-300), least


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


def _gain(problem: CircleProblem, fitted: CircleFit, axis: str, frequency: float) -> float:
    """Return how much a cyclic error of this frequency, 1/mm, reduces the weighted sum of squares.

    The formula is the one for columns added to a least-squares fit (Seber and Lee, Linear
    Regression Analysis, 2nd ed. 2003, section 3.7).
    """
    right, left = _weighed(problem, fitted, axis, frequency)
    return float(right @ np.linalg.solve(left, right))


def _weighed(
    problem: CircleProblem, fitted: CircleFit, axis: str, frequency: float
) -> tuple[FloatArray, FloatArray]:
    """Return the right side (2,) and matrix (2, 2) of the normal equations for cosine and sine of a
    cyclic error, 1/µm². All other causes are fitted again.
    """
    samples = problem.samples
    columns = cyclic_columns(samples, axis, frequency, (0.0, 0.0))[:2]
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
