"""Search for two axes that show the same error, because possibly one axis was measured twice.

The mean readings at common targets are compared. Means of one axis differ only by noise. Means of
two axes differ also by a smooth curve that is as large as their errors. The two explanations are
compared by their marginal likelihoods (Rasmussen and Williams, Gaussian Processes for Machine
Learning, 2006, eq. 5.8). The zero of each instrument is unknown, so a constant difference does not
count.
"""

from __future__ import annotations

import math
from itertools import combinations, product
from typing import Final

import numpy as np

from compwright.evaluation.pooled_scatter import pooled_scatter
from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.foundations.findings import Finding
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import SAME_READING, PositioningTest

#: Odds from which two axes are doubted: errors of two axes are alike to the noise very rarely, and
#: a job has up to ten pairs of axes.
_DOUBTED: Final = 1000.0
#: Largest odds that are reported: beyond, what the model leaves out decides.
_MOST: Final = 1e6
_FEWEST: Final = 5
#: Length over which errors of axes change, as a share of the common range.
_LENGTH: Final = 0.4


def same_error_findings(tests: dict[str, list[PositioningTest]]) -> list[Finding]:
    """Return the finding CW-T037 for each pair of axes that show the same error. ``tests`` are by
    axis name.
    """
    found = []
    for one, other in combinations(tests, 2):
        odds = max(
            (same_error_odds(a, b) for a, b in product(tests[one], tests[other])), default=0.0
        )
        if odds < _DOUBTED:
            continue
        found.append(
            Finding.of(
                "CW-T037",
                "warning",
                axes=(one, other),
                one=one,
                other=other,
                odds=odds,
            )
        )
    return found


def same_error_odds(one: PositioningTest, other: PositioningTest) -> float:
    """Return the odds that two tests show one common error rather than two different errors; 0 with
    too few common targets.
    """
    if one.kind is not other.kind:
        return 0.0
    gap, mine, theirs, variance, places, side = _common(one, other)
    if np.unique(places).size < _FEWEST:
        return 0.0
    size = float(np.var(mine) + np.var(theirs))
    span = _LENGTH * float(np.ptp(places))
    apart = places[:, np.newaxis] - places
    curve = np.exp(-0.5 * (apart / span) ** 2)
    free = 100.0 * (size + float(np.mean(variance)))
    noise = np.diag(variance) + free
    # What two axes differ in: a curve common to both directions, and their reversal.
    two = noise + size * (curve + 0.25 * np.multiply.outer(side, side))
    log_odds = _log_density(gap, noise) - _log_density(gap, two)
    return math.exp(min(max(log_odds, -50.0), math.log(_MOST)))


def _log_density(values: FloatArray, covariance: FloatArray) -> float:
    sign, log_determinant = np.linalg.slogdet(covariance)
    del sign  # positive: a sum of a diagonal and squares
    return float(-0.5 * (values @ np.linalg.solve(covariance, values) + log_determinant))


def _common(one: PositioningTest, other: PositioningTest) -> tuple[FloatArray, ...]:
    """Return the means of two tests at their common targets and directions, with further data to
    compare these means.

    Six arrays (k,) of equal length: difference of the means, both means, variance of the
    difference, position, and direction (+1, -1). They are empty if no direction was measured in
    both tests.
    """
    _, first, second = np.intersect1d(
        np.round(one.targets / SAME_READING),
        np.round(other.targets / SAME_READING),
        return_indices=True,
    )
    s = [pooled_scatter(test) for test in (one, other)]
    variances = [max(each[0], SAME_READING) ** 2 for each in s]
    parts: list[list[FloatArray]] = [[], [], [], [], []]
    for direction in Direction:
        blocks = one.deviations(direction)[first], other.deviations(direction)[second]
        if 0 in (blocks[0].shape[1], blocks[1].shape[1]):
            continue
        means = [mean_deviation(block) for block in blocks]
        counts = [np.maximum(count_readings(block), 1.0) for block in blocks]
        spread = variances[0] / counts[0] + variances[1] / counts[1]
        known = np.isfinite(means[0]) & np.isfinite(means[1])
        sign = np.full(known.size, float(direction.sign))
        for into, values in zip(parts, (*means, spread, one.targets[first], sign), strict=True):
            into.append(values[known])
    if not parts[0]:
        return tuple(np.empty(0) for _ in range(6))
    mine, theirs, spread, places, side = (np.concatenate(part) for part in parts)
    return mine - theirs, mine, theirs, spread, places, side
