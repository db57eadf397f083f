"""Mean readings and their precision for given noise of a test. The offset of a whole traverse is an
error common to several means.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.noise_chain import NoiseState
from compwright.estimation.noise_patterns import OFFSET
from compwright.estimation.noise_readings import CellReadings, traverse_effects
from compwright.estimation.noise_rounding import common_std, rounded_std
from compwright.estimation.noise_tails import KINDS, LIGHT, NORMAL, TAILS, Tail
from compwright.records.axis import FloatArray

#: Places along the travel whose cells separate the effects that are common to the means.
_PLACES: Final = (0.0, 1.0, 0.5, 0.25)
#: The mean of a cell is looked for about its readings, at so many of them, at these distances in
#: scales of a reading.
_ABOUT: Final = 6
_AWAY: Final = np.linspace(-3.0, 3.0, 13)
#: Densities that are worked out at once: 4 MB.
_AT_ONCE: Final = 500_000


@dataclass(frozen=True, slots=True)
class CellMeans:
    """Mean readings (c,) and their precisions (1 / variance; 0 without a reading), mm or deg.

    ``columns`` (c, q): errors common to several means, as columns of unit variance.
    """

    mean: FloatArray
    precision: FloatArray
    columns: FloatArray


def cell_means(
    draw: NoiseState, readings: CellReadings, shapes: FloatArray, step: float
) -> CellMeans:
    """Return the mean readings and their precisions under one ``draw`` of the noise. ``shapes``:
    patterns of the scatter along the travel; ``step``: resolution of the instrument, mm or deg, 0
    where it is negligible.

    The prior of the means is flat. The shifts of traverses are normally distributed effects
    (Searle, Casella and McCulloch, Variance Components, 1992, section 7.4). Heavy tails and
    outliers are integrated out, whichever readings the sampler classified as outliers
    (Rao-Blackwell: Gelfand and Smith, J. Am. Stat. Assoc. 85, 1990). The mean of rounded readings
    keeps an error that repetition does not reduce.
    """
    data = draw.data
    there = data.weights > 0.0
    columns, rest = _columns(draw)
    sigma = rounded_std(draw.sigma, step) if step else draw.sigma
    if step:
        rest = rest + common_std(float(np.hypot(draw.sigma, draw.size[OFFSET])), step) ** 2
    mean = data.means - data.shares @ draw.effects
    square = sigma**2 / np.maximum(data.weights, 1e-300)
    if KINDS[draw.tail] != NORMAL:
        scale = sigma * np.exp(draw.spread @ shapes)
        values = readings.values - traverse_effects(readings, draw.effects)
        if KINDS[draw.tail] == LIGHT:
            count = np.maximum(np.sum(readings.there, axis=1), 1)
            mean, square = np.sum(values * readings.there, axis=1) / count, scale**2 / count
        else:
            mean[there], square[there] = cell_locations(
                TAILS[draw.tail], values[there], readings.there[there], scale[there]
            )
    return CellMeans(
        mean=np.where(there, mean, 0.0),
        precision=np.where(there, 1.0 / (square + rest), 0.0),
        columns=columns,
    )


def means_of_all_runs(
    cells: CellMeans,
    draw: NoiseState,
    shapes: FloatArray,
    readings: CellReadings,
    every: CellReadings,
) -> CellMeans:
    """Return the means of ``every`` run under a noise that was inferred from the ``readings`` of
    only some runs.

    The variances of the means are divided by the ratio of the numbers of readings. The shifts of
    the other runs are unknown. They remain an error common to several means.
    """
    there = np.any(every.there, axis=1)
    count = np.maximum(np.sum(every.there, axis=1), 1)
    more = np.maximum(count / np.maximum(np.sum(readings.there, axis=1), 1), 1.0)
    mean = np.sum(every.values, axis=1) / count
    if KINDS[draw.tail] not in (NORMAL, LIGHT):
        scale = draw.sigma * np.exp(draw.spread @ shapes)
        mean[there] = cell_locations(
            TAILS[draw.tail], every.values[there], every.there[there], scale[there]
        )[0]
    return CellMeans(
        mean=np.where(there, mean, 0.0),
        precision=cells.precision * more,
        columns=cells.columns / np.sqrt(more)[:, np.newaxis],
    )


def cell_locations(
    tail: Tail, values: FloatArray, there: NDArray[np.bool_], scale: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return mean and variance (c,) of the expected reading at each target and direction, from
    readings ``values`` (c, n) marked as existing in ``there``, whose errors are distributed as
    ``tail`` times ``scale``. `_located` computes them in parts, to save memory.
    """
    at_once = max(1, _AT_ONCE // (min(_ABOUT, values.shape[1]) * _AWAY.size * values.shape[1]))
    parts = [
        _located(tail, values[part], there[part], scale[part])
        for part in (slice(k, k + at_once) for k in range(0, scale.size, at_once))
    ]
    return np.concatenate([mean for mean, _ in parts]), np.concatenate([one for _, one in parts])


def _located(
    tail: Tail, values: FloatArray, there: NDArray[np.bool_], scale: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return mean and variance (c,) of the expected reading at each target and direction, from
    readings ``values`` (c, n) marked as existing in ``there``, whose errors are distributed as
    ``tail`` times ``scale``.

    The prior is flat. The integral is computed by the trapezoidal rule over positions around the
    readings.
    """
    known = np.sort(np.where(there, values, np.inf), axis=1)
    last = np.count_nonzero(there, axis=1) - 1
    about = np.round(np.outer(last, np.linspace(0.0, 1.0, min(_ABOUT, values.shape[1])))).astype(
        int
    )
    chosen = np.take_along_axis(known, about, axis=1) / scale[:, np.newaxis]
    places = np.sort((chosen[:, :, np.newaxis] + _AWAY).reshape(scale.size, -1), axis=1)
    z = (values / scale[:, np.newaxis])[:, :, np.newaxis] - places[:, np.newaxis]
    logs = np.sum(np.where(there[:, :, np.newaxis], tail.log_density(z), 0.0), axis=1)
    gaps = np.diff(places, axis=1)
    width = np.zeros_like(places)
    width[:, 1:] += 0.5 * gaps
    width[:, :-1] += 0.5 * gaps
    mass = width * np.exp(logs - np.max(logs, axis=1, keepdims=True))
    mass /= np.sum(mass, axis=1, keepdims=True)
    mean = np.sum(mass * places, axis=1)
    square = np.sum(mass * (places - mean[:, np.newaxis]) ** 2, axis=1)
    return mean * scale, square * scale**2


def _columns(draw: NoiseState) -> tuple[FloatArray, FloatArray]:
    """Return columns (c, q) that approximate the covariance of the means, and the rest of the
    variances (c,), which the columns do not cover.

    The columns are a partial Cholesky factor, whose pivots are fixed cells of each direction (Golub
    and Van Loan, Matrix Computations, 4th ed. 2013, section 4.2.8).
    """
    shares, there = draw.data.shares, draw.data.weights > 0.0
    carried = shares @ draw.covariance
    rest = np.sum(carried * shares, axis=1)
    columns = np.zeros((there.size, 2 * len(_PLACES)))
    least = 1e-9 * float(np.max(rest))
    half = there.size // 2
    rows = np.flatnonzero(there[:half]), half + np.flatnonzero(there[half:])
    chosen = [
        int(row[round(place * (row.size - 1))]) for row in rows if row.size for place in _PLACES
    ]
    for index, cell in enumerate(dict.fromkeys(chosen)):
        if rest[cell] > least:
            column = carried @ shares[cell] - columns @ columns[cell]
            columns[:, index] = column / np.sqrt(rest[cell])
            rest = rest - columns[:, index] ** 2
    return columns, np.maximum(rest, 0.0)
