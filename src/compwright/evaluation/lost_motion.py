"""Test whether lost motion is constant, as backlash compensation assumes, or depends on the
distance or speed of a move.

If moves are repeated, an F test compares the differences between moves with the scatter of equal
moves. Otherwise the test is the rank test for a trend by Mann (Econometrica 13 (1945) 245) and
Kendall (Rank Correlation Methods, 1975), with the variance for ties.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.change_significance import CLEAR, score_of_ratio
from compwright.foundations.findings import Finding
from compwright.foundations.units import shown_unit
from compwright.records.axis import FloatArray
from compwright.records.drift import LostMotionTest
from compwright.words.sentences import Amount

#: Repeated readings, beyond one for each move, from which their scatter is used.
_REPEATS: Final = 3
#: Moves without repeats below which no order of the values is as rare as `CLEAR`.
_FEWEST: Final = 8
_UM: Final = shown_unit("mm")


@dataclass(frozen=True, slots=True)
class LostMotionResult:
    """The best constant for the lost motion and the largest error that it leaves (µm). ``depends``
    is True if the lost motion is not constant.
    """

    constant: float
    left: float
    depends: bool
    findings: tuple[Finding, ...]


def lost_motion_result(test: LostMotionTest) -> LostMotionResult:
    """Return the best constant for the lost motion, from the mean of each move, and whether the
    lost motion is constant.

    The best constant is the middle between the largest and the smallest mean. The finding is
    CW-T040 if the lost motion depends on the move. It is CW-T041 if the readings show no such
    dependence.
    """
    moves, group = np.unique(test.moves, return_inverse=True)
    values = 1000.0 * test.lost_motion
    means = np.bincount(group, values) / np.bincount(group)
    constant = float(means.max() + means.min()) / 2.0
    left = float(np.ptp(means)) / 2.0
    repeats = values.size - moves.size
    repeated = repeats >= _REPEATS
    score = _between(values, means, group) if repeated else _trend(means)
    depends = score > CLEAR
    low, high = sorted((int(np.argmin(means)), int(np.argmax(means))))
    unit = "mm" if test.over == "distance" else "mm/min"
    best, most = Amount(constant, _UM), Amount(left, _UM)
    if depends:
        found = Finding.of(
            "CW-T040",
            "warning",
            file=test.source.file,
            over=test.over,
            constant=best,
            left=most,
            first=Amount(float(means[low]), _UM),
            last=Amount(float(means[high]), _UM),
            first_move=Amount(float(moves[low]), unit, ".4g"),
            last_move=Amount(float(moves[high]), unit, ".4g"),
        )
    else:
        found = Finding.of(
            "CW-T041",
            "info",
            file=test.source.file,
            over=test.over,
            constant=best,
            left=most,
            few=not repeated and moves.size < _FEWEST,
        )
    return LostMotionResult(constant, left, depends, (found,))


def _between(values: FloatArray, means: FloatArray, group: NDArray[np.intp]) -> float:
    """Return a standard normal score for differences between the means of groups, relative to the
    scatter within groups.
    """
    dof, within = means.size - 1.0, float(values.size - means.size)
    inner = float(np.sum((values - means[group]) ** 2)) / within
    outer = float(np.sum((means[group] - values.mean()) ** 2)) / dof
    if inner <= 0.0:
        return math.inf if outer > 0.0 else 0.0
    return score_of_ratio(outer / inner, dof, within)


def _trend(means: FloatArray) -> float:
    """Return a standard normal score for a rise or fall of the ``means`` in their order."""
    n = means.size
    rise = float(sum(np.sign(later - earlier) for earlier, later in combinations(means, 2)))
    ties = np.unique(means, return_counts=True)[1].astype(np.float64)
    variance = n * (n - 1.0) * (2.0 * n + 5.0) - float(
        np.sum(ties * (ties - 1.0) * (2.0 * ties + 5.0))
    )
    return max(abs(rise) - 1.0, 0.0) / math.sqrt(variance / 18.0) if variance > 0.0 else 0.0
