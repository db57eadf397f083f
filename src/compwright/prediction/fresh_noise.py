"""Fresh readings of the noise of a test: what a new test adds to the error of the axis."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import RUNS, WALK, NoiseDraws, progress, slackening, traverse_order

_PLUS, _MINUS = range(2)
#: Below this many degrees of freedom Student's law has readings without measure.
_LEAST_DOF: Final = 1.0


def fresh_noise(
    draws: NoiseDraws,
    targets: FloatArray,
    positive: int,
    negative: int,
    rng: np.random.Generator,
) -> tuple[FloatArray, FloatArray]:
    """Return one fresh test for each of the draws: what its readings at ``targets`` (m,) add to the
    error of the axis, (count, m, positive) and (count, m, negative), mm or deg.

    Scatter, tails, offsets and tilts of the traverses are drawn anew; the drift is that of the
    draw. Runs go up and down in turn (ISO 230-2, standard test cycle).
    """
    u = (targets - draws.centre) / draws.half
    offsets = _traverse_effects(draws, draws.offset, positive, negative, rng)
    tilts = _traverse_effects(draws, draws.tilt, positive, negative, rng)
    scale = draws.scale_at(targets)
    both = positive > 0 and negative > 0
    slack = slackening(max(positive, negative), draws.drift_rate, u, returns=both)
    blocks = []
    for way, runs in ((_PLUS, positive), (_MINUS, negative)):
        drifted = slack[way][:, :, np.newaxis] * _drift(draws, u, runs)
        whole = offsets[way][:, np.newaxis] + u[:, np.newaxis] * tilts[way][:, np.newaxis]
        errors = _errors(draws, (draws.count, targets.size, runs), rng)
        blocks.append(drifted + whole + scale[:, way, :, np.newaxis] * errors)
    return blocks[_PLUS], blocks[_MINUS]


def _drift(draws: NoiseDraws, u: FloatArray, runs: int) -> FloatArray:
    """Return what the drift adds, (count, m, runs), about its mean over the runs."""
    way = progress(runs, draws.drift_rate)
    way = way - way.mean(axis=1, keepdims=True) if runs else way
    size = draws.drift[:, np.newaxis] + np.outer(draws.drift_tilt, u)
    drifted: FloatArray = size[:, :, np.newaxis] * way[:, np.newaxis]
    return drifted


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
