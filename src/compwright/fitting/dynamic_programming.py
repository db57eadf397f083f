"""Search for the best whole-number table values of a curve by dynamic programming.

Each table value is a whole number of steps within a given window. All values are in these steps.
Several cases ("lanes") are solved at once. A lane is one reversal value, one shift, or one start
value of a closed curve. The method is that of Bellman, Dynamic Programming (1957). The decisions
are stored and traced back as in Viterbi's algorithm (Forney, Proceedings of the IEEE 61, 1973).
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from compwright.fitting.chain import ChainLimits, CurveChain
from compwright.fitting.sparse_matrices import IntArray
from compwright.records.axis import FloatArray


def reachable_windows(
    chain: CurveChain, limits: ChainLimits, low: FloatArray, high: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return ranges of values, in steps, narrowed to those that the allowed increments reach from
    the neighbouring points.

    ``low``, ``high`` (n, m): smallest and largest value of each of m points for each of n cases.
    """
    along = np.append(0.0, np.cumsum(chain.span.astype(np.float64)))
    down, up = limits.increments[0] * along, limits.increments[1] * along
    low = np.maximum.accumulate(low - down, axis=1) + down
    high = np.minimum.accumulate(high - up, axis=1) + up
    low = np.maximum.accumulate((low - up)[:, ::-1], axis=1)[:, ::-1] + up
    high = np.minimum.accumulate((high - down)[:, ::-1], axis=1)[:, ::-1] + down
    return low, high


def closed_lanes(
    lanes: IntArray, low: FloatArray, high: FloatArray
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Return ranges of values for closed curves, whose ends have the same value. Each range is
    repeated for every value that both its ends allow, with both ends fixed at this value.

    ``lanes``: the rows of ``low`` and ``high`` to use. Returns three arrays: the row from which
    each copy was made, and the smallest and the largest values of the copies (copies, m), in steps.
    """
    owners: list[int] = []
    starts: list[float] = []
    for lane in lanes:
        first, last = max(low[lane, 0], low[lane, -1]), min(high[lane, 0], high[lane, -1])
        values = np.arange(first, last + 1)
        owners += [int(lane)] * values.size
        starts += values.tolist()
    chosen = np.array(owners, dtype=np.int64)
    low, high = low[chosen].copy(), high[chosen].copy()
    for column in (0, -1):
        low[:, column] = high[:, column] = starts
    return chosen, low, high


def cheapest_totals(
    chain: CurveChain, limits: ChainLimits, targets: FloatArray, low: IntArray, high: IntArray
) -> tuple[FloatArray, IntArray]:
    """Return the smallest objective (n,) over whole-number table values (n, m) from ``low`` to
    ``high``, and these values. ``targets`` (n, m): table values of the optimum over real numbers,
    in steps.

    The objective is (T - target)'H(T - target)/2 for the table values T. Forward over the table
    points, the smallest cost of each possible value is computed (Bellman 1957). Backward, the
    values that gave this cost are traced (Forney 1973). All n cases use the widest window of each
    point. Outside its own window the cost of a case is infinite.
    """
    first, last = np.min(low, axis=0), np.max(high, axis=0)
    costs = np.empty((targets.shape[0], 0))
    came: list[IntArray] = []
    for point in range(targets.shape[1]):
        totals = np.arange(first[point], last[point] + 1)
        here = totals - targets[:, point, np.newaxis]
        own = 0.5 * chain.diagonal[point] * here**2
        own[(totals < low[:, point, np.newaxis]) | (totals > high[:, point, np.newaxis])] = np.inf
        if point:
            arriving, steps = _arrive(
                chain,
                limits,
                point,
                (int(first[point - 1]), int(first[point]), totals.size),
                costs,
                here,
                targets,
            )
            came.append(steps)
            own += arriving
        costs = own
    lane = np.arange(targets.shape[0])
    index = np.argmin(costs, axis=1)
    least = costs[lane, index]
    found = np.empty(targets.shape, dtype=np.int64)
    found[:, -1] = first[-1] + index
    for point in range(targets.shape[1] - 1, 0, -1):
        found[:, point - 1] = (
            found[:, point] - came[point - 1][lane, found[:, point] - first[point]]
        )
    return least, found


def _arrive(
    chain: CurveChain,
    limits: ChainLimits,
    point: int,
    window: tuple[int, int, int],
    costs: FloatArray,
    here: FloatArray,
    targets: FloatArray,
) -> tuple[FloatArray, IntArray]:
    """Return the smallest cost (n, w) of each value at the point ``point``, and the increment from
    the previous point that leads to it.

    ``window``: first value at the previous point, first value at this point, number w of values at
    this point. ``costs``: costs of the values at the previous point. ``here``: values at this point
    minus the optimum ``targets``. Let e be the deviation from the target at this point, and d the
    increment. The deviation at the previous point is e + target here - target there - d. The
    coupling term is therefore linear in d.
    """
    before, now, count = window
    span = int(chain.span[point - 1])
    least = max(limits.increments[0] * span, now - (before + costs.shape[1] - 1))
    largest = min(limits.increments[1] * span, now + count - 1 - before)
    number = largest - least + 1
    start = (
        now - largest - before
    )  # place of the total before for the first total here and the largest increment
    length = count + number - 1
    padded = np.full((costs.shape[0], length), np.inf)
    inner = slice(max(0, start), min(costs.shape[1], start + length))
    padded[:, inner.start - start : inner.stop - start] = costs[:, inner]
    ways = sliding_window_view(padded, number, axis=1)
    off = chain.off[point - 1]
    rise = off * here
    if off != 0.0:  # steps couple nothing
        ways = ways - rise[:, :, np.newaxis] * np.arange(largest, least - 1, -1)
    index = np.argmin(ways, axis=2)
    arriving = np.take_along_axis(ways, index[:, :, np.newaxis], axis=2)[:, :, 0]
    if off != 0.0:
        arriving = arriving + rise * (
            here + (targets[:, point] - targets[:, point - 1])[:, np.newaxis]
        )
    return arriving, largest - index
