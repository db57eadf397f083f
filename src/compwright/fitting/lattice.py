"""Whole increments: the exact optimum over the lattice, by dynamic programming within windows that
are proved wide enough.

The unknowns are whole totals T[i] (magnification * unit each) with increments and values within the
control's limits. Dynamic programming: Bellman, Dynamic Programming (1957). Windows from a bound of
the quadratic form: Fincke and Pohst, Mathematics of Computation 44 (1985). Leaving out what cannot
be better: Land and Doig, Econometrica 28 (1960).

Why nothing better lies outside the windows. A `Relaxation` says f(v) >= g + (v - x)'H(v - x)/2 for
every v within the limits. With any solution of value U at hand, a better one has (v - x)'H(v - x)
<= 2 (U - g), and by Cauchy and Schwarz (v[i] - x[i])^2 <= (H^-1)[i, i] (v - x)'H(v - x). So node i
need only be searched within sqrt(2 (U - g) (H^-1)[i, i]) of x[i], and where the neighbours' windows
reach. The value U is that of a solution which keeps all limits; it lies in every window. A poor U
or a poor bound makes windows wide, never wrong; where the bound says nothing they end at the
control's own limits.

What need not be searched. H - share * diag(H) is positive semidefinite, so that f(v) >= g + share *
sum(H[i, i] (distance from x[i] to the lattice)^2) / 2. A magnification, a reversal value or a shift
of the second table whose bound lies above U is left out.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.fitting.chain import (
    Chain,
    Limits,
    Push,
    Relaxation,
    limiting_push,
    no_push,
    priced,
    relax,
)
from compwright.fitting.sparse import IntArray
from compwright.fitting.windows import cheapest, closed_lanes, reachable
from compwright.records.axis import FloatArray

#: Magnifications whose objectives differ by less than this share count as equal: the smallest is
#: taken.
EQUAL: Final = 1e-9
#: Errors of this share of the unit do not count, whatever the objective.
_NOTHING: Final = 1e-6
#: Half widths (in steps) in which a first solution is sought; then the whole range.
_FIRST_WINDOWS: Final = (1.0, 4.0, 16.0, 64.0, 1024.0, np.inf)
#: Slack of windows against rounding errors, in steps and as a share of U.
_DUST: Final = 1e-6
_DUST_SHARE: Final = 1e-10
_LANES: Final = 16
#: More variants than this are not looked at one by one for a bound.
_MANY: Final = 200


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """One curve of the table.

    ``constant``: the reversal value is ``sign * step * B`` with whole B between the limits: (sign *
    step, least, largest); None: there is none. ``anchor``: index in the chain of the reference;
    ``offsets``: least and largest value there in units, of a second table; None: the value there is
    zero. ``magnified``: the offset counts in magnified units.
    """

    chain: Chain
    low: float
    high: float
    constant: tuple[float, int, int] | None = None
    anchor: int = 0
    offsets: tuple[int, int] | None = None
    magnified: bool = False

    def limits(self, unit: float, magnification: int, increments: tuple[int, int]) -> Limits:
        """Return the limits at one magnification."""
        low, high = (np.full(self.chain.diagonal.size, end) for end in (self.low, self.high))
        if self.offsets is not None:
            one = unit * (magnification if self.magnified else 1)
            low[self.anchor] = max(self.low, self.offsets[0] * one)
            high[self.anchor] = min(self.high, self.offsets[1] * one)
        return Limits(step=unit * magnification, increments=increments, low=low, high=high)

    def shifts(self, unit: float, magnification: int) -> FloatArray:
        """Return by how much the second table's values may stand off multiples of magnification
        times unit (n,), mm or deg.
        """
        if self.offsets is None or self.magnified:
            return np.zeros(1)
        return unit * np.arange(magnification, dtype=np.float64)

    def constant_range(self) -> tuple[float, float]:
        """Return least and largest reversal value, mm or deg."""
        if self.constant is None:
            return 0.0, 0.0
        step, least, largest = self.constant
        return min(step * least, step * largest), max(step * least, step * largest)


@dataclass(frozen=True, slots=True)
class Variants:
    """Ways to go through one part: reversal value ``count`` (n,), its distance from the optimum,
    the shift, a lower bound.
    """

    count: IntArray
    distance: FloatArray
    shift: FloatArray
    bound: FloatArray

    def take(self, chosen: IntArray | slice) -> Variants:
        """Return some of them."""
        return Variants(
            self.count[chosen], self.distance[chosen], self.shift[chosen], self.bound[chosen]
        )


@dataclass(frozen=True, slots=True)
class Found:
    """Values of one part: whole ``totals`` (m,), the ``shift`` (mm or deg), the reversal's whole
    ``count``; ``objective`` f.
    """

    totals: IntArray
    shift: float
    count: int
    objective: float


@dataclass(frozen=True, slots=True)
class Solution:
    """The best table: its parts, ``magnification``, ``objective`` (mean square), ``bound`` of it
    without whole numbers.

    ``before``: the next smaller magnification and a lower bound of its objective; None where there
    is none.
    """

    parts: tuple[Found, ...]
    magnification: int
    objective: float
    bound: float
    before: tuple[int, float] | None


def best_totals(
    parts: tuple[Part, ...],
    *,
    unit: float,
    increments: tuple[int, int],
    magnifications: tuple[int, ...],
) -> Solution | None:
    """Return the exact optimum over whole totals, reversal values and magnifications; None: the
    limits allow no table.

    ``unit`` mm or deg; ``magnifications`` ascending. Of those that are equal within `EQUAL` the
    smallest is taken. Best bound first (branch and bound; Land and Doig, Econometrica 28, 1960).
    """
    search = _Search(parts, unit, increments)
    best: Solution | None = None
    ceiling = search.first_ceiling(magnifications)
    bounds = [
        (-np.inf, one) for one in magnifications
    ]  # a heap: the least bound first, of equal ones the smallest magnification
    while bounds:
        bound, chosen = bounds[0]
        known = search.bound(chosen, ceiling)
        if known > bound:
            heapq.heapreplace(bounds, (known, chosen))
        elif not _worth_a_look(chosen, known, ceiling, best, unit):
            heapq.heappop(bounds)
        elif not search.sharpen(chosen):
            heapq.heappop(bounds)
            found = search.solve(chosen, ceiling)
            if found is not None and _better(found, best, unit):
                best = found
                ceiling = min(ceiling, found.objective + _tolerance(found.objective, unit))
    if best is None:
        return None
    before = max((one for one in magnifications if one < best.magnification), default=None)
    return replace(
        best, before=None if before is None else (before, search.without_whole_numbers(before))
    )


def relaxed_bound(
    parts: tuple[Part, ...], *, unit: float, increments: tuple[int, int], magnification: int
) -> float:
    """Return a lower bound of the objective under the limits, without whole numbers: the least
    value but for OSQP's accuracy (weak duality; Boyd and Vandenberghe, Convex Optimization, 2004,
    section 5.2.2). Square of mm or deg.
    """
    return _Search(parts, unit, increments).without_whole_numbers(magnification)


def _tolerance(objective: float, unit: float) -> float:
    return EQUAL * objective + (_NOTHING * unit) ** 2


def _worth_a_look(
    magnification: int, bound: float, ceiling: float, best: Solution | None, unit: float
) -> bool:
    """Return whether a magnification may be better than the best one so far; a larger one must be
    so by more than the tolerance.
    """
    if best is None or magnification < best.magnification:
        return bound <= ceiling
    return bound < best.objective - _tolerance(best.objective, unit)


def _better(new: Solution, best: Solution | None, unit: float) -> bool:
    if best is None:
        return True
    tolerance = _tolerance(best.objective, unit)
    if new.magnification < best.magnification:
        return new.objective <= best.objective + tolerance
    return new.objective < best.objective - tolerance


@dataclass(frozen=True, slots=True)
class _Relaxed:
    """The best lower bound of a part by so many ``pushes``, and its ``least`` over all reversal
    values.
    """

    relaxation: Relaxation
    least: float
    pushes: int


@dataclass(frozen=True, slots=True)
class _Whole:
    """The least bound with whole numbers among those within ``room``, from a ``relaxation``."""

    bound: float
    room: float
    relaxation: Relaxation


class _Search:
    """Bounds and solutions of all parts. ``pushes`` grow as magnifications are looked at; each
    serves all magnifications.
    """

    def __init__(self, parts: tuple[Part, ...], unit: float, increments: tuple[int, int]) -> None:
        self.parts, self.unit, self.increments = parts, unit, increments
        self.pushes: list[list[tuple[Push, Relaxation]]] = [[] for _ in parts]
        self.sharpened: set[int] = set()
        self.best: dict[tuple[int, int], _Relaxed] = {}
        self.wholes: dict[tuple[int, int], _Whole] = {}
        for index, part in enumerate(parts):
            self._add(index, no_push(part.chain))

    def _add(self, index: int, push: Push) -> None:
        self.pushes[index].append((push, relax(self.parts[index].chain, push)))

    def limits(self, part: Part, magnification: int) -> Limits:
        return part.limits(self.unit, magnification, self.increments)

    def relaxed(self, index: int, magnification: int) -> _Relaxed:
        """Return the best lower bound that the multipliers so far give."""
        part, pushes = self.parts[index], self.pushes[index]
        best = self.best.get((index, magnification))
        if best is None or best.pushes < len(pushes):
            limits = self.limits(part, magnification)
            for push, relaxation in pushes[0 if best is None else best.pushes :]:
                one = priced(relaxation, push, part.chain, limits)
                least = _continuous(part, one)
                if best is None or least > best.least:
                    best = _Relaxed(one, least, 0)
            if best is None:
                raise ValueError("no multipliers")
            best = self.best[index, magnification] = replace(best, pushes=len(pushes))
        return best

    def first_ceiling(self, magnifications: tuple[int, ...]) -> float:
        """Return the value of some solution: the best of rounding at a few magnifications, each
        about twice the one before.
        """
        ceiling, last = np.inf, 0
        for one in magnifications:
            if one < 2 * last and one != magnifications[-1]:
                continue
            last = one
            binds = self.sharpen(one)
            found = [self.first_solution(index, one) for index in range(len(self.parts))]
            if all(one is not None for one in found):
                value = sum(one.objective for one in found if one is not None)
                ceiling = min(ceiling, value + _tolerance(value, self.unit))
            if not binds:  # where nothing binds, a larger step only rounds more coarsely
                break
        return ceiling

    def sharpen(self, magnification: int) -> bool:
        """Return whether limits bind at ``magnification`` and better multipliers were sought for
        the first time.
        """
        if magnification in self.sharpened:
            return False
        self.sharpened.add(magnification)
        binds = False
        for index, part in enumerate(self.parts):
            limits = self.limits(part, magnification)
            if _binding(part, self.relaxed(index, magnification).relaxation, limits):
                self._add(index, limiting_push(part.chain, limits, part.constant_range()))
                binds = True
        return binds

    def bound(self, magnification: int, ceiling: float) -> float:
        """Return a lower bound of the objective at one magnification; any number above ``ceiling``
        where it lies above.
        """
        least = [self.relaxed(index, magnification).least for index in range(len(self.parts))]
        total = sum(least)
        for index, one in enumerate(least):
            total += self._whole(index, magnification, ceiling - sum(least) + one) - one
        return total

    def _whole(self, index: int, magnification: int, room: float) -> float:
        """Return the least bound of one part with whole numbers that is not above ``room``;
        infinite where all are.

        Known from a larger room it is known for a smaller one.
        """
        part, relaxed = self.parts[index], self.relaxed(index, magnification)
        relaxation = relaxed.relaxation
        known = self.wholes.get((index, magnification))
        if known is None or known.relaxation is not relaxation or known.room < room:
            counts = _counts(part, relaxation, room)
            shifts = self.shifts(part, magnification)
            if counts.size * shifts.size > _MANY:
                return relaxed.least  # too rough a ceiling yet: without whole numbers will do
            limits = self.limits(part, magnification)
            variants = _variants(part, relaxation, limits, shifts, room)
            bound = float(np.min(variants.bound, initial=np.inf))
            known = self.wholes[index, magnification] = _Whole(bound, room, relaxation)
        return known.bound if known.bound <= _roomy(room) else np.inf

    def without_whole_numbers(self, magnification: int) -> float:
        """Return a lower bound of the objective from the limits alone."""
        self.sharpen(magnification)
        return sum(self.relaxed(index, magnification).least for index in range(len(self.parts)))

    def shifts(self, part: Part, magnification: int) -> FloatArray:
        return part.shifts(self.unit, magnification)

    def first_solution(self, index: int, magnification: int) -> Found | None:
        """Return some solution of one part: the relaxed one rounded, or the best near it."""
        part, limits = self.parts[index], self.limits(self.parts[index], magnification)
        relaxation = self.relaxed(index, magnification).relaxation
        variants = _variants(part, relaxation, limits, self.shifts(part, magnification), np.inf)
        return _first(part, relaxation, limits, variants.take(slice(0, 1)))

    def solve(self, magnification: int, ceiling: float) -> Solution | None:
        """Return the best solution at one magnification; None: there is none of value ``ceiling``
        or less.
        """
        relaxed = [self.relaxed(index, magnification) for index in range(len(self.parts))]
        least = [one.least for one in relaxed]
        found: list[Found] = []
        for index, part in enumerate(self.parts):
            others = sum(one.objective for one in found) + sum(least[index + 1 :])
            one = _solve_part(
                part,
                relaxed[index].relaxation,
                self.limits(part, magnification),
                self.shifts(part, magnification),
                ceiling - others,
            )
            if one is None:
                return None
            found.append(one)
        return Solution(
            tuple(found), magnification, sum(one.objective for one in found), sum(least), None
        )


def _continuous(part: Part, relaxation: Relaxation) -> float:
    """Return the lower bound without whole numbers: the least over all reversal values."""
    return float(relaxation.bound(np.array([_best_distance(part, relaxation)]))[0])


def _best_distance(part: Part, relaxation: Relaxation) -> float:
    """Return the reversal value of the least bound, less that of the chain's optimum."""
    if part.constant is None:
        return 0.0
    low, high = part.constant_range()
    here = part.chain.constant
    return float(min(max(relaxation.tilt / relaxation.curve, low - here), high - here))


def _binding(part: Part, relaxation: Relaxation, limits: Limits) -> bool:
    values = relaxation.centres(np.array([_best_distance(part, relaxation)]))[0]
    steps, dust = np.diff(values) / (limits.step * part.chain.span), 1e-4
    climbs = np.any(steps > limits.increments[1] + dust) or np.any(
        steps < limits.increments[0] - dust
    )
    free = ~part.chain.fixed
    outside = np.maximum(values - limits.high, limits.low - values)[free] > dust * limits.step
    return bool(climbs or np.any(outside))


def _counts(part: Part, relaxation: Relaxation, room: float) -> IntArray:
    """Return the whole reversal values whose bound may lie within ``room``; for infinite room those
    next to the best one.
    """
    if part.constant is None:
        return np.zeros(1, dtype=np.int64)
    step, least, largest = part.constant
    middle, reach = part.chain.constant + _best_distance(part, relaxation), abs(step)
    if np.isfinite(room):
        # The bound is a parabola in the reversal value: what is too high at its ends stays so
        # beyond them.
        top = relaxation.tilt / relaxation.curve
        spare = max(0.0, _roomy(room) - float(relaxation.bound(np.array([top]))[0]))
        middle, reach = (
            part.chain.constant + top,
            np.sqrt(2.0 * spare / relaxation.curve) + _DUST * abs(step),
        )
    ends = sorted(((middle - reach) / step, (middle + reach) / step))
    low, high = np.clip(np.array([np.ceil(ends[0]), np.floor(ends[1])]), least - 1, largest + 1)
    return np.arange(max(least, int(low)), min(largest, int(high)) + 1, dtype=np.int64)


def _variants(
    part: Part, relaxation: Relaxation, limits: Limits, shifts: FloatArray, room: float
) -> Variants:
    """Return what is to be tried where no solution may exceed ``room``, the most promising
    first.
    """
    counts = _counts(part, relaxation, room)
    step = part.constant[0] if part.constant else 0.0
    distance = counts.astype(np.float64) * step - part.chain.constant
    bounds = relaxation.bound(distance)
    centres = relaxation.centres(distance)
    whole = np.concatenate(
        [bounds + _whole(part.chain, centres, shift, limits.step) for shift in shifts]
    )
    every = Variants(
        np.tile(counts, shifts.size),
        np.tile(distance, shifts.size),
        np.repeat(shifts, counts.size),
        whole,
    )
    kept = np.flatnonzero(whole <= _roomy(room))
    return every.take(kept[np.argsort(whole[kept], kind="stable")])


def _roomy(room: float) -> float:
    return room + _DUST_SHARE * abs(room)


def _whole(chain: Chain, centres: FloatArray, shift: float, step: float) -> FloatArray:
    """Return what whole numbers cost at least (n,): see the module docstring."""
    counted = (centres - shift) / step
    distance = np.where(chain.fixed, 0.0, (counted - np.round(counted)) * step)
    cost: FloatArray = 0.5 * chain.share * (distance**2 @ chain.diagonal)
    return cost


def _solve_part(
    part: Part, relaxation: Relaxation, limits: Limits, shifts: FloatArray, ceiling: float
) -> Found | None:
    """Return the best solution of one part with value ``ceiling`` or less."""
    nearest = _variants(part, relaxation, limits, shifts, np.inf).take(slice(0, 1))
    best = _first(part, relaxation, limits, nearest)
    ceiling = ceiling if best is None else min(ceiling, best.objective)
    variants = _variants(part, relaxation, limits, shifts, ceiling)
    for start in range(0, variants.count.size, _LANES):
        some = variants.take(slice(start, start + _LANES))
        some = some.take(np.flatnonzero(some.bound <= _roomy(ceiling)))
        found = _within(part, relaxation, limits, some, ceiling)
        if found is not None and (best is None or found.objective < best.objective):
            best = found
            ceiling = min(ceiling, found.objective)
    return best


def _first(part: Part, relaxation: Relaxation, limits: Limits, variant: Variants) -> Found | None:
    """Return a solution for one variant: its relaxed values rounded and swept into the limits, else
    the best near them.
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
        return Found(totals.astype(np.int64), shift, int(variant.count[0]), objective)
    for half in _FIRST_WINDOWS:
        near_low = np.maximum(low, np.floor(counted - half)) if np.isfinite(half) else low
        near_high = np.minimum(high, np.ceil(counted + half)) if np.isfinite(half) else high
        found = _search_windows(part, limits, variant, near_low, near_high)
        if found is not None:
            return found
    return None


def _allowed(
    chain: Chain, limits: Limits, totals: FloatArray, low: FloatArray, high: FloatArray
) -> bool:
    steps = np.diff(totals)
    climbs = (steps >= limits.increments[0] * chain.span) & (
        steps <= limits.increments[1] * chain.span
    )
    closes = not chain.closed or totals[0] == totals[-1]
    return bool(closes and np.all(climbs) and np.all((totals >= low) & (totals <= high)))


def _swept(chain: Chain, limits: Limits, totals: FloatArray, anchor: int) -> FloatArray:
    """Return ``totals`` (m,) with every increment within its limits, from the reference outward;
    what is within them stays.
    """
    totals = totals.copy()
    if chain.closed:
        totals[-1] = totals[0]
    least, largest = (end * chain.span for end in limits.increments)
    if np.all((np.diff(totals) >= least) & (np.diff(totals) <= largest)):
        return totals
    for node in range(anchor + 1, totals.size):
        before = totals[node - 1]
        totals[node] = min(max(totals[node], before + least[node - 1]), before + largest[node - 1])
    for node in range(anchor - 1, -1, -1):
        after = totals[node + 1]
        totals[node] = min(max(totals[node], after - largest[node]), after - least[node])
    return totals


def _ends(chain: Chain, limits: Limits, shift: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return least and largest totals (n, m) by the value range; zero where the value is fixed."""
    low = np.ceil((limits.low - shift[:, np.newaxis]) / limits.step - _DUST)
    high = np.floor((limits.high - shift[:, np.newaxis]) / limits.step + _DUST)
    return np.where(chain.fixed, 0.0, low), np.where(chain.fixed, 0.0, high)


def _within(
    part: Part, relaxation: Relaxation, limits: Limits, variants: Variants, ceiling: float
) -> Found | None:
    """Return the best solution of ``variants`` with value ``ceiling`` or less, from windows that
    hold every such one (Fincke and Pohst 1985).
    """
    chain = part.chain
    spare = np.maximum(0.0, _roomy(ceiling) - relaxation.bound(variants.distance))
    radius = np.sqrt(2.0 * np.outer(spare, chain.inverse)) + _DUST * limits.step
    centres = relaxation.centres(variants.distance) - variants.shift[:, np.newaxis]
    low, high = _ends(chain, limits, variants.shift)
    if np.isfinite(ceiling):
        low = np.maximum(low, np.ceil((centres - radius) / limits.step))
        high = np.minimum(high, np.floor((centres + radius) / limits.step))
    return _search_windows(part, limits, variants, low, high)


def _search_windows(
    part: Part, limits: Limits, variants: Variants, low: FloatArray, high: FloatArray
) -> Found | None:
    """Return the best solution with totals between ``low`` and ``high`` (n, m), one lane for each
    variant.
    """
    chain = part.chain
    low, high = reachable(chain, limits, low, high)
    lanes = np.flatnonzero(np.all(low <= high, axis=1))
    if chain.closed:
        lanes, low, high = closed_lanes(lanes, low, high)
    else:
        low, high = low[lanes], high[lanes]
    best: Found | None = None
    for start in range(0, lanes.size, _LANES):
        some = lanes[start : start + _LANES]
        distance, shift = variants.distance[some], variants.shift[some]
        targets = (
            chain.optimum - np.outer(distance, chain.solve(chain.coupling)) - shift[:, np.newaxis]
        ) / limits.step
        batch = slice(start, start + _LANES)
        costs, totals = cheapest(
            chain, limits, targets, low[batch].astype(np.int64), high[batch].astype(np.int64)
        )
        left = 0.5 * chain.left if chain.stiffness else 0.0
        values = chain.least + left * distance**2 + limits.step**2 * costs
        lane = int(np.argmin(values))
        if np.isfinite(values[lane]) and (best is None or values[lane] < best.objective):
            best = Found(
                totals[lane],
                float(shift[lane]),
                int(variants.count[some[lane]]),
                float(values[lane]),
            )
    return best
