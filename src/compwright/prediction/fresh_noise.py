"""Fresh readings of the noise of a test: what a new test adds to the error of the axis."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import (
    RUNS,
    WALK,
    NoiseDraws,
    progress,
    slackening,
    traverse_order,
    within_run,
)

_PLUS, _MINUS = range(2)
#: Below this many degrees of freedom Student's law has readings without measure.
_LEAST_DOF: Final = 1.0
#: How probable a fresh test drifts as the first one did: one test does not tell. What warms an axis
#: up is mostly its own motion, which the cycle repeats; a hall, or an axis that was warm already,
#: is another one next time (ISO 230-2:1997, clause 3.3, wants neither in a test).
_AGAIN: Final = 0.8


def fresh_noise(
    draws: NoiseDraws,
    targets: FloatArray,
    positive: int,
    negative: int,
    rng: np.random.Generator,
) -> tuple[FloatArray, FloatArray]:
    """Return one fresh test for each of the draws: what its readings at ``targets`` (m,) add to the
    error of the axis, (count, m, positive) and (count, m, negative), mm or deg.

    Scatter, tails, offsets and tilts of the traverses are drawn anew. Four tests in five drift as
    the first one did, the fifth anew, of the same size either way, and its means differ by what
    drifts within a run. Runs go up and down in turn (ISO 230-2, standard test cycle).
    """
    u = (targets - draws.centre) / draws.half
    offsets = _traverse_effects(draws, draws.offset, positive, negative, rng)
    tilts = _traverse_effects(draws, draws.tilt, positive, negative, rng)
    scale = draws.scale_at(targets)
    moved = np.flatnonzero((draws.offset != 0.0) | (draws.tilt != 0.0))
    blocks = []
    for way, runs in ((_PLUS, positive), (_MINUS, negative)):
        readings = _errors(draws, (draws.count, targets.size, runs), rng)
        readings *= scale[:, way, :, np.newaxis]
        turned = u[:, np.newaxis] * tilts[way][moved, np.newaxis]
        readings[moved] += offsets[way][moved, np.newaxis] + turned
        blocks.append(readings)
    share = _fresh_share(draws.count, rng)
    drifting = np.flatnonzero((draws.drift != 0.0) | (draws.drift_tilt != 0.0))
    drifts = _drifts(draws.taken(drifting), share[drifting], u, positive, negative)
    for block, drift in zip(blocks, drifts, strict=True):
        block[drifting] += drift
    return blocks[_PLUS], blocks[_MINUS]


def _drifts(
    draws: NoiseDraws, share: FloatArray, u: FloatArray, positive: int, negative: int
) -> tuple[FloatArray, FloatArray]:
    """Return what drifts in readings (count, m, positive) and (count, m, negative) at ``u`` (m,),
    -1 to 1, of fresh tests that drift by ``share`` (count,) as the first one did.
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


def _fresh_share(count: int, rng: np.random.Generator) -> FloatArray:
    """Return by how much of the drift of its draw each fresh test drifts (count,): 1, or drawn anew
    with a mean square of 1.
    """
    again = rng.random(count) < _AGAIN
    return np.where(again, 1.0, rng.standard_normal(count))


def _traverse_effects(
    draws: NoiseDraws,
    std: FloatArray,
    positive: int,
    negative: int,
    rng: np.random.Generator,
) -> tuple[FloatArray, FloatArray]:
    """Return an effect of standard deviation ``std`` (count,) for each traverse in + (count,
    positive) and in -, by the pattern of each draw.
    """
    order = traverse_order(positive, negative)
    unit = rng.standard_normal((draws.count, positive + negative))
    walked, steps = np.cumsum(unit, axis=1), draws.pattern[:, np.newaxis]
    walked = walked - walked[:, [unit.shape[1] // 2]]  # set to nothing in the middle of the test
    blocks = []
    for place, runs in zip(order, (positive, negative), strict=True):
        chosen = np.where(steps == WALK, walked[:, place], unit[:, place])
        common = unit[:, :runs]
        blocks.append(std[:, np.newaxis] * np.where(steps == RUNS, common, chosen))
    return blocks[_PLUS], blocks[_MINUS]


def _errors(draws: NoiseDraws, shape: tuple[int, int, int], rng: np.random.Generator) -> FloatArray:
    """Return errors of single readings ``shape`` (count, m, n) of unit scale: normal, Student's (a
    normal one over the root of a mean square; Gelman et al., Bayesian Data Analysis, 3rd ed. 2013,
    section 17.2), or of a mixture with outliers (Tukey 1960).
    """
    errors = rng.standard_normal(shape)
    heavy = np.flatnonzero(np.isfinite(draws.dof))
    if heavy.size:
        dof = np.maximum(draws.dof[heavy], _LEAST_DOF)[:, np.newaxis, np.newaxis]
        errors[heavy] /= np.sqrt(rng.chisquare(dof, (heavy.size, *shape[1:])) / dof)
    spoilt = np.flatnonzero(draws.outlier_share > 0.0)
    if spoilt.size:
        share = draws.outlier_share[spoilt, np.newaxis, np.newaxis]
        size = draws.outlier_size[spoilt, np.newaxis, np.newaxis]
        fixed = draws.outlier_fixed[spoilt, np.newaxis, np.newaxis]
        chance = rng.random((spoilt.size, *shape[1:]))
        side = np.where(chance < 0.5 * share, -size, size)
        beside = np.where(fixed, errors[spoilt] + side, size * errors[spoilt])
        errors[spoilt] = np.where(chance < share, beside, errors[spoilt])
    return errors
