"""Removal of readings that do not show the axis: missing traverses shown as zeros, and outliers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.evaluation.residuals import pooled_residuals, robust_scale, row_medians, run_medians
from compwright.evaluation.statistics import standard_deviation
from compwright.records.axis import Direction
from compwright.records.positioning import PositioningTest

#: Rows of exact zeros that scattering readings show less often than this are no measurement.
BY_CHANCE: Final = 1e-5
#: A reading is suspect when it exceeds so many robust standard deviations against its target and
#: its traverse; below 0.1 % of sound tests with five runs.
READING_LIMIT: Final = 8.0
#: Scatter below this is rounding of binary numbers, not a measurement: 1 pm, 1e-9 deg.
_ROUNDING: Final = 1e-9
_BOTH: Final = (Direction.POSITIVE, Direction.NEGATIVE)


def valid_part(test: PositioningTest) -> PositioningTest:
    """Return ``test`` without traverses of zeros (`zero_traverses`) and outliers (CW-T014)."""
    made = without_traverses(test, zero_traverses(test))
    return without_readings(made, outlying_readings(made)[0])


def zero_traverses(test: PositioningTest) -> list[tuple[Direction, int]]:
    """Return direction and column of each traverse of two targets or more whose readings are all
    exactly zero.

    A traverse is returned only if the other readings scatter so much that its zeros cannot be
    chance.
    """
    chance = chance_of_zero(test)
    found = []
    for direction in _BOTH:
        for column, values in enumerate(test.deviations(direction).T):
            known = values[np.isfinite(values)]
            by_chance = known.size * chance**known.size >= BY_CHANCE
            if known.size > 1 and not np.any(known) and not by_chance:
                found.append((direction, column))
    return found


def without_traverses(
    test: PositioningTest, traverses: Sequence[tuple[Direction, int]]
) -> PositioningTest:
    """Return ``test`` without the ``traverses``, which are given by direction and column."""
    for direction in _BOTH:
        keep = np.ones(test.deviations(direction).shape, dtype=bool)
        keep[:, [column for where, column in traverses if where is direction]] = False
        if not np.all(keep):
            test = keep_readings(test, direction, keep)
    return test


def outlying_readings(
    test: PositioningTest,
) -> tuple[list[tuple[float, Direction, int, int]], float]:
    """Return outliers, largest first, and the robust standard deviation of a reading, mm or deg.

    Each outlier is given by its distance from the other readings (with sign, mm or deg), its
    direction, the index of its target, and the column of its run.
    """
    found: list[tuple[float, Direction, int, int]] = []
    inner = [residual - run_medians(residual) for residual in pooled_residuals(test)[0]]
    inner = [residual - row_medians(residual) for residual in inner]
    scale = robust_scale(inner, test)
    for direction, residual in zip(_BOTH, inner, strict=True):
        if residual.shape[1] < 4 or scale == 0.0:
            continue
        far = np.argwhere(np.abs(np.nan_to_num(residual)) > READING_LIMIT * scale)
        found.extend((float(residual[i, j]), direction, int(i), int(j)) for i, j in far)
    return sorted(found, key=lambda entry: -abs(entry[0])), scale


def without_readings(
    test: PositioningTest, found: Sequence[tuple[float, Direction, int, int]]
) -> PositioningTest:
    """Return ``test`` without the outlying readings ``found``."""
    for direction in _BOTH:
        keep = np.ones(test.deviations(direction).shape, dtype=bool)
        for _, where, i, j in found:
            if where is direction:
                keep[i, j] = False
        test = keep_readings(test, direction, keep)
    return test


def chance_of_zero(test: PositioningTest) -> float:
    """Return the probability that a reading is exactly zero by chance: resolution step divided by
    width of the scatter.

    The scatter is the median of s over the targets whose readings differ. The zeros themselves
    therefore do not count.
    """
    s = np.concatenate([standard_deviation(test.deviations(direction)) for direction in _BOTH])
    s = s[np.isfinite(s) & (s > _ROUNDING)]
    if not test.step or not s.size:
        return 1.0
    scatter = float(row_medians(s[np.newaxis])[0, 0])  # np.median loads numpy.ma
    return min(test.step / (scatter * math.sqrt(2.0 * math.pi)), 1.0)


def keep_readings(
    test: PositioningTest,
    direction: Direction,
    keep: np.ndarray[tuple[int, ...], np.dtype[np.bool_]],
) -> PositioningTest:
    """Return ``test`` with only the readings of a ``direction`` marked in ``keep`` (m, n)."""
    changed = np.where(keep, test.deviations(direction), np.nan)
    return (
        replace(test, positive=changed)
        if direction is Direction.POSITIVE
        else replace(test, negative=changed)
    )
