"""Fit of one curve of whole increments: lower bounds of its mean square, and the exact optimum.

The optimum comes from dynamic programming (Bellman, Dynamic Programming, 1957) within windows of
table values. These windows are proved wide enough (Fincke and Pohst, Mathematics of Computation 44,
1985).

Why the windows contain the optimum: f is the mean square of the table values v, and H its matrix
(`chain`). A `Relaxation` has a minimum g at the table values x. Then f(v) >= g + (v - x)'H(v - x)/2
for every v within the limits. Let U be the mean square of a known table within the limits. A better
v has (v - x)'H(v - x) <= 2 (U - g). By Cauchy and Schwarz, (v[i] - x[i])^2 <= (H^-1)[i, i] (v -
x)'H(v - x). Table point i is therefore searched within sqrt(2 (U - g) (H^-1)[i, i]) of x[i], and
only where its neighbours' windows reach. The known table is in every window. A large U or a low g
makes the windows wider, never wrong. At most they extend to the control's limits.

Which cases are skipped: H - share * diag(H) is positive semidefinite. Therefore f(v) >= g + share *
sum(H[i, i] (distance from x[i] to the nearest whole step)^2) / 2. This is a lower bound for each
magnification, reversal value, and shift of the second table. A case whose lower bound exceeds U is
skipped.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.fitting.chain import (
    ChainLimits,
    CurveChain,
    Relaxation,
)
from compwright.fitting.dynamic_programming import cheapest_totals, closed_lanes, reachable_windows
from compwright.fitting.sparse_matrices import IntArray
from compwright.records.axis import FloatArray

#: Slack of windows against rounding errors, in steps and as a share of U.
_DUST: Final = 1e-6
_DUST_SHARE: Final = 1e-10
#: Half widths (in steps) in which a first solution is sought; then the whole range.
_FIRST_WINDOWS: Final = (1.0, 4.0, 16.0, 64.0, 1024.0, np.inf)
_LANES: Final = 16


@dataclass(frozen=True, slots=True, kw_only=True)
class LatticePart:
    """One curve of a table of whole increments.

    ``low``, ``high``: the value range, mm or deg. ``constant``: three values (sign * step, least,
    largest), or None without a reversal value. The reversal value is sign * step * B, with a whole
    number B from least to largest. ``anchor``: index of the table point at the reference.
    ``offsets``: smallest and largest value of a second table at this point, in units of one
    increment; None: this value is zero. ``magnified``: these units are multiplied by the
    magnification.
    """

    chain: CurveChain
    low: float
    high: float
    constant: tuple[float, int, int] | None = None
    anchor: int = 0
    offsets: tuple[int, int] | None = None
    magnified: bool = False

    def limits(self, unit: float, magnification: int, increments: tuple[int, int]) -> ChainLimits:
        """Return the limits of the curve at one magnification."""
        low, high = (np.full(self.chain.diagonal.size, end) for end in (self.low, self.high))
        if self.offsets is not None:
            one = unit * (magnification if self.magnified else 1)
            low[self.anchor] = max(self.low, self.offsets[0] * one)
            high[self.anchor] = min(self.high, self.offsets[1] * one)
        return ChainLimits(step=unit * magnification, increments=increments, low=low, high=high)

    def shifts(self, unit: float, magnification: int) -> FloatArray:
        """Return the offsets (n,) to try, mm or deg, by which all values of the curve differ from
        whole multiples of their step.
        """
        if self.offsets is None or self.magnified:
            return np.zeros(1)
        return unit * np.arange(magnification, dtype=np.float64)

    def constant_range(self) -> tuple[float, float]:
        """Return the smallest and the largest reversal value that the control allows, mm or deg."""
        if self.constant is None:
            return 0.0, 0.0
        step, least, largest = self.constant
        return min(step * least, step * largest), max(step * least, step * largest)


@dataclass(frozen=True, slots=True)
class Variants:
    """Combinations of reversal value and offset to try for one curve, as arrays (n,).

    ``count``: reversal value in whole steps. ``distance``: reversal value minus its optimum, mm or
    deg. ``shift``: offset, mm or deg. ``bound``: a lower bound of the objective.
    """

    count: IntArray
    distance: FloatArray
    shift: FloatArray
    bound: FloatArray

    def take(self, chosen: IntArray | slice) -> Variants:
        """Return the combinations with the indices ``chosen``."""
        return Variants(
            self.count[chosen], self.distance[chosen], self.shift[chosen], self.bound[chosen]
        )


@dataclass(frozen=True, slots=True)
class LatticeValues:
    """The solution of one curve: whole-number ``totals`` (m,), offset ``shift`` (mm or deg),
    whole-number reversal value ``count``, and ``objective``.
    """

    totals: IntArray
    shift: float
    count: int
    objective: float


def continuous_bound(part: LatticePart, relaxation: Relaxation) -> float:
    """Return the lower bound of the objective over real values, at the best reversal value."""
    return float(relaxation.bound(np.array([_best_distance(part, relaxation)]))[0])


def _best_distance(part: LatticePart, relaxation: Relaxation) -> float:
    """Return the reversal value with the smallest lower bound, relative to the curve's optimum."""
    if part.constant is None:
        return 0.0
    low, high = part.constant_range()
    here = part.chain.constant
    return float(min(max(relaxation.tilt / relaxation.curve, low - here), high - here))


def binding(part: LatticePart, relaxation: Relaxation, limits: ChainLimits) -> bool:
    """Return whether the real-number values that give the lower bound violate one of the
    ``limits``.
    """
    values = relaxation.centres(np.array([_best_distance(part, relaxation)]))[0]
    steps, dust = np.diff(values) / (limits.step * part.chain.span), 1e-4
    climbs = np.any(steps > limits.increments[1] + dust) or np.any(
        steps < limits.increments[0] - dust
    )
    free = ~part.chain.fixed
    outside = np.maximum(values - limits.high, limits.low - values)[free] > dust * limits.step
    return bool(climbs or np.any(outside))


def counts_within(part: LatticePart, relaxation: Relaxation, room: float) -> IntArray:
    """Return the whole-number reversal values to try for an objective up to ``room``. If ``room``
    is infinite, return the whole numbers next to the best real value.
    """
    if part.constant is None:
        return np.zeros(1, dtype=np.int64)
    step, least, largest = part.constant
    middle, reach = part.chain.constant + _best_distance(part, relaxation), abs(step)
    if np.isfinite(room):
        # The bound is a parabola in the reversal value: what is too high at its ends stays so
        # beyond them.
        top = relaxation.tilt / relaxation.curve
        spare = max(0.0, with_slack(room) - float(relaxation.bound(np.array([top]))[0]))
        middle, reach = (
            part.chain.constant + top,
            np.sqrt(2.0 * spare / relaxation.curve) + _DUST * abs(step),
        )
    ends = sorted(((middle - reach) / step, (middle + reach) / step))
    low, high = np.clip(np.array([np.ceil(ends[0]), np.floor(ends[1])]), least - 1, largest + 1)
    return np.arange(max(least, int(low)), min(largest, int(high)) + 1, dtype=np.int64)


def variants_within(
    part: LatticePart, relaxation: Relaxation, limits: ChainLimits, shifts: FloatArray, room: float
) -> Variants:
    """Return the combinations of reversal value and offset to try for an objective up to ``room``,
    the smallest lower bound first.
    """
    counts = counts_within(part, relaxation, room)
    distance, whole = whole_bounds(part, relaxation, limits, shifts, counts)
    every = Variants(
        np.tile(counts, shifts.size),
        np.tile(distance, shifts.size),
        np.repeat(shifts, counts.size),
        whole,
    )
    kept = np.flatnonzero(whole <= with_slack(room))
    return every.take(kept[np.argsort(whole[kept], kind="stable")])


def whole_bounds(
    part: LatticePart,
    relaxation: Relaxation,
    limits: ChainLimits,
    shifts: FloatArray,
    counts: IntArray,
) -> tuple[FloatArray, FloatArray]:
    """Return lower bounds of the objective over whole numbers, and the distance of each reversal
    value from its optimum.

    ``counts`` (n,): reversal values in whole steps; the distances (n,), mm or deg, come first in
    the result. ``shifts``: offsets, mm or deg. There is one bound for each offset and reversal
    value, (number of shifts × n,). The bounds are ordered by offset: first all reversal values with
    the first offset, then with the next.
    """
    step = part.constant[0] if part.constant else 0.0
    distance = counts.astype(np.float64) * step - part.chain.constant
    bounds = relaxation.bound(distance)
    centres = relaxation.centres(distance)
    whole = np.concatenate(
        [bounds + _whole(part.chain, centres, shift, limits.step) for shift in shifts]
    )
    return distance, whole


def with_slack(room: float) -> float:
    """Return the upper limit ``room`` with a margin for rounding errors."""
    return room + _DUST_SHARE * abs(room)


def _whole(chain: CurveChain, centres: FloatArray, shift: float, step: float) -> FloatArray:
    """Return a lower bound (n,) of what rounding to whole numbers adds to the mean square."""
    counted = (centres - shift) / step
    distance = np.where(chain.fixed, 0.0, (counted - np.round(counted)) * step)
    cost: FloatArray = 0.5 * chain.share * (distance**2 @ chain.diagonal)
    return cost


def best_of_part(
    part: LatticePart,
    relaxation: Relaxation,
    limits: ChainLimits,
    shifts: FloatArray,
    ceiling: float,
) -> LatticeValues | None:
    """Return the best solution of one curve with an objective up to ``ceiling``, or None if there
    is none.
    """
    nearest = variants_within(part, relaxation, limits, shifts, np.inf).take(slice(0, 1))
    best = first_of_part(part, relaxation, limits, nearest)
    ceiling = ceiling if best is None else min(ceiling, best.objective)
    variants = variants_within(part, relaxation, limits, shifts, ceiling)
    for start in range(0, variants.count.size, _LANES):
        some = variants.take(slice(start, start + _LANES))
        some = some.take(np.flatnonzero(some.bound <= with_slack(ceiling)))
        found = _within(part, relaxation, limits, some, ceiling)
        if found is not None and (best is None or found.objective < best.objective):
            best = found
            ceiling = min(ceiling, found.objective)
    return best


def first_of_part(
    part: LatticePart, relaxation: Relaxation, limits: ChainLimits, variant: Variants
) -> LatticeValues | None:
    """Return a valid solution for one combination of reversal value and offset: the real-number
    optimum, rounded and moved into the limits. If that is not valid, return the best solution near
    it, or None if there is none.
    """
    if not variant.count.size:
        return None
    chain = part.chain
    values = relaxation.centres(variant.distance)
    counted = (values - variant.shift[:, np.newaxis]) / limits.step
    # Halves go one way throughout: steps within whole limits stay within them.
    totals = np.floor(counted[0] + 0.5 + 1e-9)
    low, high = _ends(chain, limits, variant.shift)
    totals = _swept(chain, limits, np.clip(totals, low[0], high[0]), part.anchor)
    if _allowed(chain, limits, totals, low[0], high[0]):
        shift = float(variant.shift[0])
        objective = chain.value(
            totals * limits.step + shift, chain.constant + float(variant.distance[0])
        )
        return LatticeValues(totals.astype(np.int64), shift, int(variant.count[0]), objective)
    for half in _FIRST_WINDOWS:
        near_low = np.maximum(low, np.floor(counted - half)) if np.isfinite(half) else low
        near_high = np.minimum(high, np.ceil(counted + half)) if np.isfinite(half) else high
        found = _search_windows(part, limits, variant, near_low, near_high)
        if found is not None:
            return found
    return None


def _allowed(
    chain: CurveChain, limits: ChainLimits, totals: FloatArray, low: FloatArray, high: FloatArray
) -> bool:
    steps = np.diff(totals)
    climbs = (steps >= limits.increments[0] * chain.span) & (
        steps <= limits.increments[1] * chain.span
    )
    closes = not chain.closed or totals[0] == totals[-1]
    return bool(closes and np.all(climbs) and np.all((totals >= low) & (totals <= high)))


def _swept(chain: CurveChain, limits: ChainLimits, totals: FloatArray, anchor: int) -> FloatArray:
    """Return ``totals`` (m,) with each increment moved into its limits, from the reference on."""
    totals = totals.copy()
    if chain.closed:
        totals[-1] = totals[0]
    least, largest = (end * chain.span for end in limits.increments)
    if np.all((np.diff(totals) >= least) & (np.diff(totals) <= largest)):
        return totals
    for point in range(anchor + 1, totals.size):
        before = totals[point - 1]
        totals[point] = min(
            max(totals[point], before + least[point - 1]), before + largest[point - 1]
        )
    for point in range(anchor - 1, -1, -1):
        after = totals[point + 1]
        totals[point] = min(max(totals[point], after - largest[point]), after - least[point])
    return totals


def _ends(
    chain: CurveChain, limits: ChainLimits, shift: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the smallest and largest totals (n, m) in the value range; fixed values are 0."""
    low = np.ceil((limits.low - shift[:, np.newaxis]) / limits.step - _DUST)
    high = np.floor((limits.high - shift[:, np.newaxis]) / limits.step + _DUST)
    return np.where(chain.fixed, 0.0, low), np.where(chain.fixed, 0.0, high)


def _within(
    part: LatticePart,
    relaxation: Relaxation,
    limits: ChainLimits,
    variants: Variants,
    ceiling: float,
) -> LatticeValues | None:
    """Return the best solution among the ``variants`` with an objective up to ``ceiling``, or None
    if there is none.

    The searched windows contain every such solution (Fincke and Pohst 1985).
    """
    chain = part.chain
    spare = np.maximum(0.0, with_slack(ceiling) - relaxation.bound(variants.distance))
    radius = np.sqrt(2.0 * np.outer(spare, chain.inverse)) + _DUST * limits.step
    centres = relaxation.centres(variants.distance) - variants.shift[:, np.newaxis]
    low, high = _ends(chain, limits, variants.shift)
    if np.isfinite(ceiling):
        low = np.maximum(low, np.ceil((centres - radius) / limits.step))
        high = np.minimum(high, np.floor((centres + radius) / limits.step))
    return _search_windows(part, limits, variants, low, high)


def _search_windows(
    part: LatticePart, limits: ChainLimits, variants: Variants, low: FloatArray, high: FloatArray
) -> LatticeValues | None:
    """Return the best solution with totals from ``low`` to ``high`` (n, m). Each row belongs to one
    of the ``variants``, combinations of reversal value and offset. None if there is no solution.
    """
    chain = part.chain
    low, high = reachable_windows(chain, limits, low, high)
    lanes = np.flatnonzero(np.all(low <= high, axis=1))
    if chain.closed:
        lanes, low, high = closed_lanes(lanes, low, high)
    else:
        low, high = low[lanes], high[lanes]
    best: LatticeValues | None = None
    for start in range(0, lanes.size, _LANES):
        some = lanes[start : start + _LANES]
        distance, shift = variants.distance[some], variants.shift[some]
        targets = (
            chain.optimum - np.outer(distance, chain.solve(chain.coupling)) - shift[:, np.newaxis]
        ) / limits.step
        batch = slice(start, start + _LANES)
        costs, totals = cheapest_totals(
            chain, limits, targets, low[batch].astype(np.int64), high[batch].astype(np.int64)
        )
        left = 0.5 * chain.left if chain.stiffness else 0.0
        values = chain.least + left * distance**2 + limits.step**2 * costs
        lane = int(np.argmin(values))
        if np.isfinite(values[lane]) and (best is None or values[lane] < best.objective):
            best = LatticeValues(
                totals[lane],
                float(shift[lane]),
                int(variants.count[some[lane]]),
                float(values[lane]),
            )
    return best
