"""Standard errors of the parameters of a positioning test: the differences to expect if the test is
repeated at once.

The standard errors are computed from the scatter of the test's own readings.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from compwright.records.axis import FloatArray

#: The choice of the largest cell must not depend on the last bits.
_DIGITS = 9


@dataclass(frozen=True, slots=True)
class StandardError:
    """The standard error of a parameter, in its unit, and its degrees of freedom."""

    value: float
    dof: float


def standard_errors(
    positive: FloatArray, negative: FloatArray, coverage: float
) -> dict[str, StandardError]:
    """Return the standard errors of A, B and B_mean (ISO 230-2:2014) and of ``s``, the pooled
    standard deviation. The result is empty without repeated readings.

    ``positive``, ``negative`` (m, n): readings in + and − in one unit, a column per run. Missing
    readings are NaN; a direction that was not measured has width 0. ``coverage``: the factor k of
    A. A shift of a whole traverse is the same at all its targets. If runs differ more than the
    scatter of single readings explains, the variance of the differences between runs is used. A
    follows from the two targets that determine it, each with its mean and k standard deviations
    (variance of s: s²/2ν). Combination and degrees of freedom: GUM (JCGM 100:2008) 5.1.2 and G.4.1
    (Welch-Satterthwaite).
    """
    blocks = [block for block in (positive, negative) if block.size and np.isfinite(block).any()]
    scatter = _scatter(blocks)
    if scatter is None:
        return {}
    s, own = scatter
    errors = {"s": own}
    ends = _ends(blocks, coverage)
    if ends is not None:
        upper, lower = ends
        spread = coverage**2 * s**2 / 2.0 * sum(1.0 / _dof(cell) for cell in (upper, lower))
        errors["A"] = _combined([_difference(upper, lower, s, own.dof), (spread, own.dof)])
    if len(blocks) == 2:
        errors |= _reversal(blocks[0], blocks[1], s, own.dof)
    return errors


def slope_error(
    positions: FloatArray, positive: FloatArray, negative: FloatArray
) -> StandardError | None:
    """Return the standard error of the slope of the mean deviation over ``positions`` (m,), per
    unit of position. None if no target has repeated readings that scatter.

    It is computed from the scatter of single readings, or from the slopes of the runs if these
    differ more.
    """
    blocks = [block for block in (positive, negative) if block.size and np.isfinite(block).any()]
    scatter = _scatter(blocks)
    centred = positions - positions.mean()
    square = float(centred @ centred)
    if scatter is None or square <= 0.0:
        return None
    s, own = scatter
    width = min(block.shape[1] for block in blocks)
    runs = np.mean([block[:, :width] for block in blocks], axis=0)
    whole = np.isfinite(runs).all(axis=0)
    pooled = s**2 / (len(blocks) * width * square)
    return _combined([_larger(pooled, own.dof, centred @ runs[:, whole] / square)])


def _scatter(blocks: list[FloatArray]) -> tuple[float, StandardError] | None:
    """Return the pooled standard deviation of a reading and its standard error, or None if no
    target has repeated readings that scatter. ``blocks``: the readings (m, n) of each direction.

    The relative variance of s² is 2/ν for normal readings of equal variance, with ν degrees of
    freedom. It is larger if targets or runs differ in their variance.
    """
    cells = [row[np.isfinite(row)] for block in blocks for row in block]
    repeated = [cell for cell in cells if cell.size > 1]
    if not repeated:
        return None
    dofs = np.array([cell.size - 1.0 for cell in repeated])
    variances = np.array([np.var(cell, ddof=1) for cell in repeated])
    weights = dofs / dofs.sum()
    pooled = float(weights @ variances)
    if pooled <= 0.0:
        return None
    relative = [2.0 / float(dofs.sum())]
    if len(repeated) > 2:
        count = len(repeated)
        between = count / (count - 1.0) * float(weights**2 @ (variances - pooled) ** 2)
        relative.append(between / pooled**2)
    relative += _between_runs(blocks)
    dof = 2.0 / max(relative)
    s = math.sqrt(pooled)
    return s, StandardError(s / math.sqrt(2.0 * dof), dof)


def _between_runs(blocks: list[FloatArray]) -> list[float]:
    """Return estimates of the relative variance of s²: one from the differences between traverses,
    one from the differences between runs. ``blocks``: the readings (m, n) of each direction.

    An estimate needs at least three traverses or runs. The mean of n readings at a target takes one
    degree of freedom from them. The estimates allow for this.
    """
    residuals = [
        block - np.nanmean(block, axis=1, keepdims=True)
        for block in (each[np.isfinite(each).any(axis=1)] for each in blocks)
    ]
    width = max(block.shape[1] for block in residuals)
    traverses = [column for block in residuals for column in block.T]
    runs = [
        np.concatenate([block[:, run] for block in residuals if run < block.shape[1]])
        for run in range(width)
    ]
    if width < 2:
        return []
    found = [_relative_variance(parts) for parts in (traverses, runs)]
    return [each * width / (width - 1.0) for each in found if each is not None]


def _relative_variance(parts: Iterable[FloatArray]) -> float | None:
    """Return the relative variance of the average of the mean squares of all ``parts``, or None for
    fewer than three parts.
    """
    found = (part[np.isfinite(part)] for part in parts)
    squares = [float(part @ part) / part.size for part in found if part.size]
    mean = float(np.mean(squares)) if squares else 0.0
    if len(squares) < 3 or mean <= 0.0:
        return None
    return float(np.var(squares, ddof=1)) / len(squares) / mean**2


def _dof(cell: FloatArray) -> int:
    return int(np.isfinite(cell).sum()) - 1


def _ends(blocks: list[FloatArray], coverage: float) -> tuple[FloatArray, FloatArray] | None:
    """Return the readings at the two targets that determine A: the target with the highest mean + k
    s, and the target with the lowest mean - k s. ``coverage``: the factor k.

    The result is None without repeated readings.
    """
    cells = [row for block in blocks for row in block if _dof(row) > 0]
    if not cells:
        return None
    means = np.array([np.nanmean(cell) for cell in cells])
    deviations = np.array([np.nanstd(cell, ddof=1) for cell in cells])
    upper = int(np.argmax(np.round(means + coverage * deviations, _DIGITS)))
    lower = int(np.argmin(np.round(means - coverage * deviations, _DIGITS)))
    return cells[upper], cells[lower]


def _difference(one: FloatArray, other: FloatArray, s: float, dof: float) -> tuple[float, float]:
    """Return the variance of the difference of the means of two sets of readings, and its degrees
    of freedom. ``s``: standard deviation of a reading, with ``dof`` degrees of freedom.
    """
    counts = [int(np.isfinite(cell).sum()) for cell in (one, other)]
    pooled = s**2 * sum(1.0 / count for count in counts)
    width = min(one.size, other.size)
    return _larger(pooled, dof, one[:width] - other[:width])


def _larger(pooled: float, dof: float, by_run: FloatArray) -> tuple[float, float]:
    """Return the variance of a mean and its degrees of freedom: ``pooled`` with ``dof``, or the
    variance from the values ``by_run`` if that variance is larger.
    """
    found = by_run[np.isfinite(by_run)]
    if found.size > 2:
        shown = float(np.var(found, ddof=1)) / found.size
        if shown > pooled:
            return shown, found.size - 1.0
    return pooled, dof


def _reversal(
    positive: FloatArray, negative: FloatArray, s: float, dof: float
) -> dict[str, StandardError]:
    """Return the standard errors of B, at the target with the largest reversal error, and of the
    mean reversal error.
    """
    both = np.isfinite(positive).any(axis=1) & np.isfinite(negative).any(axis=1)
    up, down = positive[both], negative[both]
    if not up.size:
        return {}
    reversal = np.abs(np.nanmean(up, axis=1) - np.nanmean(down, axis=1))
    worst = int(np.argmax(np.round(reversal, _DIGITS)))
    counts = [np.isfinite(block).sum(axis=1) for block in (up, down)]
    pooled = s**2 * float(sum(np.sum(1.0 / count) for count in counts)) / len(up) ** 2
    width = min(up.shape[1], down.shape[1])
    whole = np.isfinite(up[:, :width]).all(axis=0) & np.isfinite(down[:, :width]).all(axis=0)
    by_run = (up[:, :width] - down[:, :width])[:, whole].mean(axis=0)
    return {
        "B": _combined([_difference(up[worst], down[worst], s, dof)]),
        "B_mean": _combined([_larger(pooled, dof, by_run)]),
    }


def _combined(parts: Iterable[tuple[float, float]]) -> StandardError:
    """Return the standard error of a sum of independent ``parts``, each with variance and degrees
    of freedom.
    """
    parts = [part for part in parts if part[0] > 0.0]
    total = sum(variance for variance, _ in parts)
    dof = total**2 / sum(variance**2 / dof for variance, dof in parts)
    return StandardError(math.sqrt(total), dof)
