"""Rounding of readings by a coarse instrument: the resolution step, and the possible unrounded
values.
"""

from __future__ import annotations

from math import erf
from typing import Final

import numpy as np

from compwright.estimation.noise_readings import CellReadings
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.positioning import SAME_READING

#: Coarsest step of an instrument that tests an axis, mm and deg: 20 µm, 18 arcsec.
COARSEST: Final = {AxisKind.LINEAR: 0.02, AxisKind.ROTARY: 0.005}
#: A step below this part of the scatter changes nothing (variance of rounding: step² / 12).
_COARSE: Final = 0.4
#: Differences are whole steps if they are so to this part of a step.
_WHOLE: Final = 0.02
#: Different readings along the traverses that show no step yet: any two differ by a whole one.
_FEWEST: Final = 2
#: Scatter that is believed at least: of the differences between traverses, of the largest reading
#: (the digits that a number has), of the scatter in the other direction.
_LEAST_SHARE: Final = 0.01
_LEAST_PART: Final = 1e-9
_LEAST_SIDE: Final = 0.2
_PARTS: Final = 16
#: Values before rounding are drawn from so many scales on either side of their middle.
_REACH: Final = 4.0
_PHASES: Final = 12
#: Readings scatter by this part of a step at least, even where all of a cell are the same number.
_LEAST_ROUNDED: Final = 0.01
#: Scatter that is tried, in steps: from hardly any on.
_QUIET: Final = 0.03
_TRIED: Final = 16
#: Logarithms of scatter between which a straight line is as good as the sum itself.
_APART: Final = 0.08
#: Terms of the series of the mean error of rounding.
_ORDERS: Final = 100


def reading_step(
    readings: CellReadings, residuals: FloatArray, scatter: float, coarsest: float
) -> float:
    """Return the resolution step of the readings, mm or deg, or 0 if it is small relative to their
    ``scatter`` or above ``coarsest``.

    All readings are multiples of the step. After a table was subtracted, this is true only for the
    differences between readings at one target. ``residuals`` (c, n): readings without the effects
    of targets and traverses. If they are all zero, only whole traverses are shifted. Then the
    readings along the traverses must show the step.
    """
    there, values = readings.there, readings.values
    moved = np.any(np.abs(residuals) > SAME_READING)
    first = np.argmax(there, axis=1)
    away = np.abs(values - values[np.arange(first.size), first][:, np.newaxis])[there]
    along = np.abs(values - np.where(there, values, np.inf).min(axis=0))[there]
    if not moved and _distinct(along).size <= _FEWEST:
        return 0.0
    tried = (values[there], np.append(0.0, away)) if moved else (values[there],)
    for each in tried:
        step = _common_step(np.diff(_distinct(each)), _COARSE * scatter)
        if _COARSE * scatter < step <= coarsest:
            return step
    return 0.0


def _distinct(values: FloatArray) -> FloatArray:
    """Return ``values`` (n,) without duplicates, ascending."""
    ordered = np.sort(values)
    distinct: FloatArray = ordered[np.diff(ordered, prepend=-np.inf) > SAME_READING]
    return distinct


def _common_step(gaps: FloatArray, least: float) -> float:
    """Return the largest step that divides all ``gaps`` (n,), by Euclid's algorithm; 0 without
    gaps, or if the step is not larger than ``least``.
    """
    step = float(np.min(gaps, initial=np.inf)) if gaps.size else 0.0
    while step > least:
        rest = np.abs(gaps - step * np.round(gaps / step))
        rest = rest[rest > _WHOLE * step]
        if not rest.size:
            return step
        step = float(np.min(rest))
    return 0.0


def with_least_scatter(
    readings: CellReadings, residuals: FloatArray, least: float, rng: np.random.Generator
) -> FloatArray:
    """Return the readings (c, n), with random scatter added where a direction has almost none, such
    as less than ``least`` (mm or deg).

    ``residuals`` (c, n): readings minus the effects of targets and traverses. The scatter of a
    direction must reach the largest of four values: ``least``, `_LEAST_SHARE` of the differences
    between traverses, `_LEAST_PART` of the largest reading, and `_LEAST_SIDE` of the scatter in the
    other direction. If it does not, scatter of this size is added. The scatter must not be zero,
    because the other sizes of the noise are multiples of it.
    """
    there, half = readings.there, readings.there.shape[0] // 2
    counts = np.maximum(np.sum(there, axis=1, keepdims=True), 1)
    means = np.sum(readings.values, axis=1, keepdims=True) / counts
    moved = readings.values - means - residuals
    most = float(np.max(np.abs(readings.values), initial=0.0))
    floor = max(least, _LEAST_SHARE * _rms(moved[there]), _LEAST_PART * most)
    values = readings.values
    for own, other in ((slice(0, half), slice(half, None)), (slice(half, None), slice(0, half))):
        near = np.abs(residuals[other][there[other]])
        usual = 1.5 * float(np.median(near)) if near.size else 0.0  # outliers do not count
        wanted = max(floor, _LEAST_SIDE * usual)
        if np.any(there[own]) and _rms(residuals[own][there[own]]) < wanted:
            added = np.zeros(there.shape)
            added[own] = wanted * rng.standard_normal(there[own].shape)
            values = values + np.where(there, added, 0.0)
    return values


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def rounded_std(sigma: float, step: float) -> float:
    """Return the standard deviation of readings that scatter by ``sigma`` and are then rounded to
    ``step``.

    It is the root of the variance averaged over all positions of the mean between two steps. For
    wide scatter the variance is sigma² + step²/12 (JCGM 100:2008, F.2.2.1). If most readings of a
    cell are the same number, it is less than sigma².
    """
    phases = (np.arange(_PHASES) + 0.5) / _PHASES
    reach = int(np.ceil(6.0 * sigma / step)) + 1
    numbers = np.arange(-reach, reach + 2, dtype=np.float64)
    limits = (numbers[:-1] + 0.5 - phases[:, np.newaxis]) * (step / (sigma * np.sqrt(2.0)))
    below = 0.5 * (1.0 + np.array([[erf(limit) for limit in row] for row in limits]))
    edges = np.zeros((_PHASES, 1)), np.ones((_PHASES, 1))
    chances = np.diff(np.hstack([edges[0], below, edges[1]]), axis=1)
    means = chances @ numbers
    square = float(np.mean(chances @ numbers**2 - means**2))
    return step * float(np.sqrt(max(square, _LEAST_ROUNDED**2)))


def rounded_stds(sigmas: FloatArray, step: float) -> FloatArray:
    """Return `rounded_std` for each of the ``sigmas`` (n,), accurate to a thousandth."""
    logs = np.log(sigmas)
    low, high = float(np.min(logs)), float(np.max(logs))
    places = np.linspace(low, high, int(np.ceil((high - low) / _APART)) + 2)
    found: FloatArray = np.interp(
        logs, places, [rounded_std(float(np.exp(place)), step) for place in places]
    )
    return found


def common_std(sigma: float, step: float) -> float:
    """Return the standard deviation of the rounding error common to all readings of a target that
    scatter by ``sigma`` and are then rounded to ``step``.

    It is for one target in one direction. The mean of rounded readings minus the true mean is a
    Fourier series in the position of the true mean between two steps. Without scatter, its mean
    square is step² / 12. For a scatter of half a step or more it is practically zero (Widrow and
    Kollár, Quantization Noise, 2008, chapter 4).
    """
    orders = np.arange(1, _ORDERS + 1)
    damping = np.exp(-((2.0 * np.pi * orders * sigma / step) ** 2))
    return step * float(np.sqrt(0.5 * np.sum(damping / orders**2))) / float(np.pi)


def initial_unrounded(
    readings: CellReadings, step: float, seen: float, rng: np.random.Generator
) -> FloatArray:
    """Return a first guess of the readings (c, n) before the instrument rounded them to ``step``.
    After rounding, the guessed values have the observed scatter ``seen``.
    """
    sizes = step * np.geomspace(_QUIET, 1.0, _TRIED)
    scatter = np.array([rounded_std(float(size), step) for size in sizes])
    sigma = float(sizes[np.argmin(np.abs(scatter - seen))])
    known = zip(readings.values, readings.there, strict=True)
    usual = np.array([np.median(row[there]) if np.any(there) else 0.0 for row, there in known])
    off = readings.values - usual[:, np.newaxis]
    near = readings.there & (np.abs(off) < 1.5 * step)
    lean = np.sign(np.round(np.sum(off * near, axis=1) / step, 1))  # to the next number
    place = np.where(lean == 0.0, rng.uniform(-0.5, 0.5, usual.size), 0.5 * lean)
    middle = usual + step * place
    wanted = middle[:, np.newaxis] + sigma * rng.standard_normal(readings.values.shape)
    half = 0.5 * step
    within = np.clip(wanted, readings.values - half, readings.values + half)
    values: FloatArray = np.where(readings.there, within, 0.0)
    return values


def draw_unrounded(
    readings: CellReadings,
    step: float,
    middle: FloatArray,
    scale: FloatArray,
    rng: np.random.Generator,
) -> FloatArray:
    """Draw the readings (c, n) before they were rounded to ``step``, each within half a step of its
    displayed value, from normal distributions with means ``middle`` (c, n) and standard deviations
    ``scale`` (c, n) (Heitjan and Rubin, J. Am. Stat. Assoc. 85, 1990).
    """
    wide = np.minimum(step, 2.0 * _REACH * scale)
    low = np.clip(
        middle - _REACH * scale, readings.values - 0.5 * step, readings.values + 0.5 * step - wide
    )
    inside = (np.arange(_PARTS) + 0.5) / _PARTS
    candidates = low[:, :, np.newaxis] + wide[:, :, np.newaxis] * inside
    logs = -0.5 * ((candidates - middle[:, :, np.newaxis]) / scale[:, :, np.newaxis]) ** 2
    chances = np.cumsum(np.exp(logs - np.max(logs, axis=2, keepdims=True)), axis=2)
    drawn = rng.random(readings.values.shape) * chances[:, :, -1]
    part = np.sum(chances < drawn[:, :, np.newaxis], axis=2)
    within = (np.minimum(part, _PARTS - 1) + rng.random(part.shape)) / _PARTS
    values: FloatArray = np.where(readings.there, low + wide * within, 0.0)
    return values
