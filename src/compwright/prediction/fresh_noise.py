"""Simulated noise of the readings in a repeated test."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import (
    RUNS,
    WALK,
    WAVE,
    IndexArray,
    NoiseDraws,
    progress,
    slackening,
    traverse_order,
    wave_effects,
    within_run,
)

_PLUS, _MINUS = range(2)
#: Runs at which a wave is drawn at most: none is shorter than a tenth of the test.
_MOST_WAVED: Final = 40
#: Below this many degrees of freedom Student's law has readings without measure.
_LEAST_DOF: Final = 1.0
#: Added to the unit variances of what a wave does, so that it has a root.
_LEAST: Final = 1e-9
#: By which part of it a fresh test drifts otherwise than the first one (standard deviation). Mostly
#: an axis warms up by its own motion, and the same cycle brings the same heat; what differs is the
#: temperature at which it starts and how freely it runs. A judgement, for which no source gives a
#: figure: a start 1 K from the last one, where 15 K would be the way to the steady state. Another
#: drift altogether is no part of it: ISO 230-2:1997, clause 3.3, wants none in a test.
_DIFFERS: Final = 0.07


def fresh_noise(
    draws: NoiseDraws,
    targets: FloatArray,
    positive: int,
    negative: int,
    rng: np.random.Generator,
) -> tuple[FloatArray, FloatArray]:
    """Return the noise (mm or deg) of simulated tests at ``targets`` (m,), one test for each of the
    s ``draws``, with ``positive`` runs in + and ``negative`` runs in −: arrays (s, m, positive) and
    (s, m, negative).

    Scatter, tails, and the offsets and tilts of the traverses are drawn anew. The drift of the
    first test is repeated except for a part `_DIFFERS`, and this part also changes the means of the
    simulated test. Runs go up and down in turn (ISO 230-2, standard test cycle).
    """
    u = (targets - draws.centre) / draws.half
    offsets, tilts = _traverses(draws, positive, negative, rng)
    scale = draws.scale_at(targets)
    moved = np.flatnonzero((draws.offset != 0.0) | (draws.tilt != 0.0))
    blocks = []
    for way, runs in ((_PLUS, positive), (_MINUS, negative)):
        readings = _errors(draws, scale[:, way], way, runs, rng)
        readings *= scale[:, way, :, np.newaxis]
        turned = u[:, np.newaxis] * tilts[way][moved, np.newaxis]
        readings[moved] += offsets[way][moved, np.newaxis] + turned
        blocks.append(readings)
    share = 1.0 + _DIFFERS * rng.standard_normal(draws.count)
    drifting = np.flatnonzero((draws.drift != 0.0) | (draws.drift_tilt != 0.0))
    if not drifting.size:
        return blocks[_PLUS], blocks[_MINUS]
    drifts = _drifts(draws.taken(drifting), share[drifting], u, positive, negative)
    for block, drift in zip(blocks, drifts, strict=True):
        block[drifting] += drift
    return blocks[_PLUS], blocks[_MINUS]


def _drifts(
    draws: NoiseDraws, share: FloatArray, u: FloatArray, positive: int, negative: int
) -> tuple[FloatArray, FloatArray]:
    """Return the drift of the readings in simulated tests, (s, m, positive) in + and (s, m,
    negative) in −. ``share`` (s,): the drift of each test as a multiple of the first test's; ``u``
    (m,): the targets, scaled to −1 to 1.
    """
    both, most = positive > 0 and negative > 0, max(positive, negative)
    slack = slackening(most, draws.drift_rate, u, returns=both)
    within = within_run(most, draws.drift_rate, u, returns=both)
    size = (draws.drift[:, np.newaxis] + np.outer(draws.drift_tilt, u))[:, :, np.newaxis]
    fresh = share[:, np.newaxis, np.newaxis]
    found = []
    for way, runs in ((_PLUS, positive), (_MINUS, negative)):
        if not runs:
            found.append(np.zeros((draws.count, u.size, 0)))
            continue
        pace = progress(runs, draws.drift_rate)
        pace = (pace - pace.mean(axis=1, keepdims=True))[:, np.newaxis]
        drifted = fresh * slack[way][:, :, np.newaxis] * pace
        other = (fresh - 1.0) * within[way][:, :, np.newaxis]
        found.append(size * (drifted + other))
    return found[_PLUS], found[_MINUS]


def _traverses(
    draws: NoiseDraws, positive: int, negative: int, rng: np.random.Generator
) -> tuple[tuple[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]:
    """Return the random offsets and the random tilts of all simulated traverses. Each is a pair of
    arrays: one for the ``positive`` runs in +, (s, positive), one for the ``negative`` runs in −,
    (s, negative).
    """
    shape = draws.count, positive + negative
    units = rng.standard_normal(shape) * (rng.random(shape) < draws.moved[:, np.newaxis])
    order = traverse_order(positive, negative)
    offsets = _moved(draws, draws.offset, units, order)
    tilts = _moved(draws, draws.tilt, rng.standard_normal(shape), order)
    waving = draws.pattern == WAVE
    pairs = zip(draws.pace[waving].tolist(), draws.cycles[waving].tolist(), strict=True)
    for pace, cycles in sorted(set(pairs)):
        waved = np.flatnonzero(waving & (draws.pace == pace) & (draws.cycles == cycles))
        root = _wave_root(positive, negative, pace, cycles)
        waves = rng.standard_normal((waved.size, root.shape[0])) @ root.T
        offset, tilt = _at_all(draws.offset[waved, np.newaxis] * waves, positive, negative)
        for way, part in ((_PLUS, slice(0, positive)), (_MINUS, slice(positive, None))):
            offsets[way][waved] = offset[:, part]
            tilts[way][waved] += tilt[:, part]
    return offsets, tilts


def _few(positive: int, negative: int) -> tuple[int, int]:
    """Return the number of traverses in + and in − for which a slow disturbance is simulated: all
    of them, or a few of many. For the other traverses the disturbance is interpolated.
    """
    return min(positive, _MOST_WAVED), min(negative, _MOST_WAVED)


@functools.lru_cache(maxsize=32)
def _wave_root(positive: int, negative: int, pace: float, cycles: float) -> FloatArray:
    """Return the Cholesky factor of the covariance matrix of the traverses' offsets and tilts that
    a slow disturbance causes. ``pace``: the correlation time of the disturbance, as a fraction of
    the duration of the test, in which it has ``cycles`` oscillations.
    """
    few = _few(positive, negative)
    signs = np.repeat([1.0, -1.0], few)
    unit = wave_effects(np.concatenate(traverse_order(*few)), signs, sum(few), pace, cycles)
    unit = unit.reshape(2 * signs.size, -1)
    unit.flat[:: unit.shape[0] + 1] += _LEAST  # a short traverse hardly has a tilt of its own
    return np.asarray(np.linalg.cholesky(unit), dtype=np.float64)


def _at_all(waves: FloatArray, positive: int, negative: int) -> tuple[FloatArray, FloatArray]:
    """Return the offset and the tilt of every traverse (``positive`` in +, ``negative`` in −),
    interpolated between the traverses that were simulated as ``waves``.

    Both results have the shape (count, positive + negative), with + first. ``waves`` (count, 2 k):
    k offsets, then k tilts. The more traverses a test has, the smaller the tilt of each one.
    """
    offset, tilt = np.split(waves, 2, axis=1)
    few = _few(positive, negative)
    if few == (positive, negative):
        return offset, tilt
    blocks: list[FloatArray] = []
    turned: list[FloatArray] = []
    for runs, drawn, first in zip((positive, negative), few, (0, few[0]), strict=True):
        if not runs:
            continue
        place = np.linspace(0.0, drawn - 1.0, runs)
        left = np.minimum(place.astype(int), max(drawn - 2, 0))
        right, share = np.minimum(left + 1, drawn - 1), place - left
        for values, into, part in ((offset, blocks, 1.0), (tilt, turned, drawn / runs)):
            own = values[:, first : first + drawn]
            into.append(part * (own[:, left] * (1.0 - share) + own[:, right] * share))
    return np.hstack(blocks), np.hstack(turned)


def _moved(
    draws: NoiseDraws, std: FloatArray, unit: FloatArray, order: tuple[IndexArray, IndexArray]
) -> tuple[FloatArray, FloatArray]:
    """Return a random shift of each traverse, in + and in −, with the standard deviation ``std``
    (s,) in each draw. ``unit``: the random numbers of unit variance from which it is made;
    ``order``: when each traverse in + and in − takes place.

    ``unit`` has the shape (s, positive + negative). The shifts follow the pattern of each draw,
    such as a random walk.
    """
    walked, steps = np.cumsum(unit, axis=1), draws.pattern[:, np.newaxis]
    walked = walked - walked[:, [unit.shape[1] // 2]]  # set to nothing in the middle of the test
    blocks = []
    for place in order:
        chosen = np.where(steps == WALK, walked[:, place], unit[:, place])
        common = unit[:, : place.size]
        blocks.append(std[:, np.newaxis] * np.where(steps == RUNS, common, chosen))
    return blocks[_PLUS], blocks[_MINUS]


def _errors(
    draws: NoiseDraws, scale: FloatArray, way: int, runs: int, rng: np.random.Generator
) -> FloatArray:
    """Return random errors of single readings (s, m, runs) in units of the scatter ``scale`` (s, m)
    at each target. ``way``: the index of the direction of approach.

    The distribution follows the draw. It is normal, or Student's (a normal number divided by the
    root of a mean square; Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section 17.2), or a
    mixture of normal readings with outliers (Tukey 1960).
    """
    shape = *scale.shape, runs
    errors = rng.standard_normal(shape)
    heavy = np.flatnonzero(np.isfinite(draws.dof))
    if heavy.size:
        dof = np.maximum(draws.dof[heavy], _LEAST_DOF)[:, np.newaxis, np.newaxis]
        errors[heavy] /= np.sqrt(rng.chisquare(dof, (heavy.size, *shape[1:])) / dof)
    spoilt = np.flatnonzero(draws.outlier_share > 0.0)
    if spoilt.size:
        errors[spoilt] *= draws.core[spoilt, np.newaxis, np.newaxis]
        share = draws.outlier_share[spoilt, np.newaxis, np.newaxis]
        size = draws.taken(spoilt).outlier_size_at(scale[spoilt], way)[:, :, np.newaxis]
        fixed = draws.outlier_fixed[spoilt, np.newaxis, np.newaxis]
        chance = rng.random((spoilt.size, *shape[1:]))
        side = np.where(chance < 0.5 * share, -size, size)
        outliers = np.where(fixed, errors[spoilt] + side, size * errors[spoilt])
        errors[spoilt] = np.where(chance < share, outliers, errors[spoilt])
    return errors
