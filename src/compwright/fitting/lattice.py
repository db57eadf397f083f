"""Search for the best table of whole increments over all magnifications, by branch and bound.

The unknowns are whole numbers T[i]. The table values are T[i] times magnification times unit. Their
increments and values are within the control's limits. Magnifications whose lower bound exceeds the
best table found so far are skipped (Land and Doig, Econometrica 28, 1960). `lattice_part` solves
the problem at one magnification.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.fitting.chain import (
    ChainLimits,
    LimitMultipliers,
    Relaxation,
    closing_multipliers,
    limit_multipliers,
    priced,
    relax,
)
from compwright.fitting.lattice_part import (
    LatticePart,
    LatticeValues,
    best_of_part,
    binding,
    continuous_bound,
    counts_within,
    first_of_part,
    variants_within,
    whole_bounds,
    with_slack,
)
from compwright.records.axis import FloatArray

#: Magnifications whose objectives differ by less than this share count as equal: the smallest is
#: taken.
EQUAL: Final = 1e-9
#: Errors of this share of the unit do not count, whatever the objective.
_NOTHING: Final = 1e-6
#: More variants than this are not looked at one by one for a bound.
_MANY: Final = 200


@dataclass(frozen=True, slots=True)
class LatticeSolution:
    """The best table of whole increments: its curves, ``magnification`` and ``objective`` (mean
    square). ``bound``: a lower bound of the objective for real-number values.

    ``before``: the next smaller magnification and a lower bound of its objective; None if there is
    no smaller one.
    """

    parts: tuple[LatticeValues, ...]
    magnification: int
    objective: float
    bound: float
    before: tuple[int, float] | None


def best_totals(
    parts: tuple[LatticePart, ...],
    *,
    unit: float,
    increments: tuple[int, int],
    magnifications: tuple[int, ...],
) -> LatticeSolution | None:
    """Return the best whole-number table values, reversal values and magnification, or None if the
    limits allow no table. ``unit``: size of one increment at magnification 1, mm or deg. Of equally
    good ``magnifications`` (ascending) the smallest is taken.

    The magnification with the least lower bound is searched first (branch and bound; Land and Doig,
    Econometrica 28, 1960).
    """
    search = _LatticeSearch(parts, unit, increments)
    best: LatticeSolution | None = None
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
    parts: tuple[LatticePart, ...], *, unit: float, increments: tuple[int, int], magnification: int
) -> float:
    """Return a lower bound of the mean square over real numbers within the limits, mm² or deg².

    The bound is below the minimum only by the accuracy of OSQP (weak duality; Boyd and
    Vandenberghe, Convex Optimization, 2004, section 5.2.2).
    """
    return _LatticeSearch(parts, unit, increments).without_whole_numbers(magnification)


def _tolerance(objective: float, unit: float) -> float:
    return EQUAL * objective + (_NOTHING * unit) ** 2


def _worth_a_look(
    magnification: int, bound: float, ceiling: float, best: LatticeSolution | None, unit: float
) -> bool:
    """Return whether a magnification can give a better table than the ``best`` table so far.
    ``bound``: a lower bound of its objective; ``ceiling``: the largest objective of interest.

    A magnification larger than that of ``best`` must be better by more than `EQUAL`.
    """
    if best is None or magnification < best.magnification:
        return bound <= ceiling
    return bound < best.objective - _tolerance(best.objective, unit)


def _better(new: LatticeSolution, best: LatticeSolution | None, unit: float) -> bool:
    if best is None:
        return True
    tolerance = _tolerance(best.objective, unit)
    if new.magnification < best.magnification:
        return new.objective <= best.objective + tolerance
    return new.objective < best.objective - tolerance


@dataclass(frozen=True, slots=True)
class _Relaxed:
    """The best lower bound of one curve so far, as a function of the reversal value.

    ``least``: the smallest value of this bound over all reversal values. ``pushes``: number of sets
    of Lagrange multipliers that were tried.
    """

    relaxation: Relaxation
    least: float
    pushes: int


@dataclass(frozen=True, slots=True)
class _Whole:
    """A lower bound of the objective of one curve over whole-number values; infinite if it is above
    ``room``, the largest objective of interest.
    """

    bound: float
    room: float
    relaxation: Relaxation


class _LatticeSearch:
    """Search state with lower bounds and solutions of all curves of a table.

    ``pushes``: for each curve, the Lagrange multipliers found so far. Each set of multipliers gives
    a lower bound at every magnification.
    """

    def __init__(
        self, parts: tuple[LatticePart, ...], unit: float, increments: tuple[int, int]
    ) -> None:
        self.parts, self.unit, self.increments = parts, unit, increments
        self.pushes: list[list[tuple[LimitMultipliers, Relaxation]]] = [[] for _ in parts]
        self.sharpened: set[int] = set()
        self.best: dict[tuple[int, int], _Relaxed] = {}
        self.wholes: dict[tuple[int, int], _Whole] = {}
        for index, part in enumerate(parts):
            self._add(index, closing_multipliers(part.chain))

    def _add(self, index: int, push: LimitMultipliers) -> None:
        self.pushes[index].append((push, relax(self.parts[index].chain, push)))

    def limits(self, part: LatticePart, magnification: int) -> ChainLimits:
        return part.limits(self.unit, magnification, self.increments)

    def relaxed(self, index: int, magnification: int) -> _Relaxed:
        """Return the best lower bound of the curve with this ``index``, from all multipliers found
        so far.
        """
        part, pushes = self.parts[index], self.pushes[index]
        best = self.best.get((index, magnification))
        if best is None or best.pushes < len(pushes):
            limits = self.limits(part, magnification)
            for push, relaxation in pushes[0 if best is None else best.pushes :]:
                one = priced(relaxation, push, part.chain, limits)
                least = continuous_bound(part, one)
                if best is None or least > best.least:
                    best = _Relaxed(one, least, 0)
            if best is None:
                raise ValueError("no multipliers")
            best = self.best[index, magnification] = replace(best, pushes=len(pushes))
        return best

    def first_ceiling(self, magnifications: tuple[int, ...]) -> float:
        """Return the objective of some valid table, which is an upper bound of the optimum.

        Rounded tables are tried at a few magnifications, each about twice the one before. The best
        of them counts.
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
        """Search better multipliers at ``magnification`` once. Return whether any curve reaches a
        limit at this magnification.
        """
        if magnification in self.sharpened:
            return False
        self.sharpened.add(magnification)
        binds = False
        for index, part in enumerate(self.parts):
            limits = self.limits(part, magnification)
            if binding(part, self.relaxed(index, magnification).relaxation, limits):
                self._add(index, limit_multipliers(part.chain, limits, part.constant_range()))
                binds = True
        return binds

    def bound(self, magnification: int, ceiling: float) -> float:
        """Return a lower bound of the objective at one magnification. A result above ``ceiling``
        states only that the objective is above ``ceiling``.
        """
        least = [self.relaxed(index, magnification).least for index in range(len(self.parts))]
        total = sum(least)
        for index, one in enumerate(least):
            total += self._whole(index, magnification, ceiling - sum(least) + one) - one
        return total

    def _whole(self, index: int, magnification: int, room: float) -> float:
        """Return a lower bound of the objective of the curve with this ``index`` over whole-number
        values; infinite if it is above ``room``, the largest objective of interest.

        A result that was computed for a larger ``room`` is used again for a smaller one.
        """
        part, relaxed = self.parts[index], self.relaxed(index, magnification)
        relaxation = relaxed.relaxation
        known = self.wholes.get((index, magnification))
        if known is None or known.relaxation is not relaxation or known.room < room:
            counts = counts_within(part, relaxation, room)
            shifts = self.shifts(part, magnification)
            if counts.size * shifts.size > _MANY:
                return relaxed.least  # too rough a ceiling yet: without whole numbers will do
            limits = self.limits(part, magnification)
            _, bounds = whole_bounds(part, relaxation, limits, shifts, counts)
            bound = float(np.min(bounds[bounds <= with_slack(room)], initial=np.inf))
            known = self.wholes[index, magnification] = _Whole(bound, room, relaxation)
        return known.bound if known.bound <= with_slack(room) else np.inf

    def without_whole_numbers(self, magnification: int) -> float:
        """Return a lower bound of the objective for real-number values within the limits."""
        self.sharpen(magnification)
        return sum(self.relaxed(index, magnification).least for index in range(len(self.parts)))

    def shifts(self, part: LatticePart, magnification: int) -> FloatArray:
        return part.shifts(self.unit, magnification)

    def first_solution(self, index: int, magnification: int) -> LatticeValues | None:
        """Return valid values of the curve with this ``index``: the rounded real-number optimum, or
        else the best valid values near this optimum. None if there are none.
        """
        part, limits = self.parts[index], self.limits(self.parts[index], magnification)
        relaxation = self.relaxed(index, magnification).relaxation
        variants = variants_within(
            part, relaxation, limits, self.shifts(part, magnification), np.inf
        )
        return first_of_part(part, relaxation, limits, variants.take(slice(0, 1)))

    def solve(self, magnification: int, ceiling: float) -> LatticeSolution | None:
        """Return the best solution at one magnification, or None if none has an objective up to
        ``ceiling``.
        """
        relaxed = [self.relaxed(index, magnification) for index in range(len(self.parts))]
        least = [one.least for one in relaxed]
        found: list[LatticeValues] = []
        for index, part in enumerate(self.parts):
            others = sum(one.objective for one in found) + sum(least[index + 1 :])
            one = best_of_part(
                part,
                relaxed[index].relaxation,
                self.limits(part, magnification),
                self.shifts(part, magnification),
                ceiling - others,
            )
            if one is None:
                return None
            found.append(one)
        return LatticeSolution(
            tuple(found), magnification, sum(one.objective for one in found), sum(least), None
        )
