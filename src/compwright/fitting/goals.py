"""Fit of a table for goal A, E or M (ISO 230-2): least mean of that parameter over simulated tests.

Each parameter is a range (largest minus smallest value). The range of the mean error curve alone
could be minimised too (Chebyshev approximation: Boyd and Vandenberghe, Convex Optimization, 2004,
section 6.1.1). Such a table follows the noise of the test, so a new test shows a larger range.
Instead, a linear program minimises the mean range over simulated new tests (sample average
approximation: Shapiro, Dentcheva and Ruszczynski, Lectures on Stochastic Programming, 2nd ed. 2014,
chapter 5). Other simulated tests decide how far the table moves from the least mean square towards
this solution.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final, Literal

import numpy as np

from compwright.fitting.mean_range import Deviations, product, solve_ranges
from compwright.fitting.problem import BOTH, QuadraticProblem, UnknownsLayout, bends, hat_matrix
from compwright.fitting.sparse_matrices import (
    IntArray,
    SparseMatrix,
    from_dense,
    identity,
    stack_rows,
    sum_of,
)
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import Scenarios, WantedCorrection

#: How far to follow the program.
_SHARES: Final = np.linspace(0.0, 1.0, 6)
#: Within this share of the least mean range the table of least mean square is taken.
_SLACK: Final = 0.002
#: Straight pieces by which a curve is changed have so many knots, at most.
_KNOTS: Final = 24

Range = Literal["A", "E", "M"]


def optimise_goal(
    goal: Range,
    wanted: WantedCorrection,
    layout: UnknownsLayout,
    capacity: Capacity,
    limits: QuadraticProblem,
    start: FloatArray,
) -> tuple[FloatArray, dict[str, float]]:
    """Return the table values (n,) with the least mean of the parameter ``goal`` over simulated
    tests, and the numbers that prove this optimum (certificate). ``start`` (n,): the table values
    of least mean square under the same ``limits``.

    The result is on the straight line from ``start`` to the optimum of the linear program. All
    points of this line keep the limits, which are convex. Without ``wanted.scenarios`` the range of
    the mean error curve is minimised. Raises CapacityError if no solution is certified.
    """
    if wanted.scenarios is None:
        deviations = _of_the_mean(goal, wanted, layout, capacity)
        return solve_ranges(deviations, limits, slack=0.01 * capacity.quantum)
    deviations = _of_scenarios(goal, wanted, wanted.scenarios, layout, capacity)
    fitted, held_out = map(deviations.of, _halves(wanted.scenarios))
    bends_by = _smooth_changes(layout)
    moved = Deviations(
        D=product(fitted.D, bends_by),
        base=fitted.base + fitted.D @ start,
        half=fitted.half,
        test=fitted.test,
    )
    slack = _SLACK * fitted.mean_range(start)
    change, proof = solve_ranges(moved, _of_changes(limits, start, bends_by), slack=slack)
    tables = [start + share * (bends_by @ change) for share in _SHARES]
    values = [held_out.mean_range(x) for x in tables]
    best = int(np.argmin(np.round(values, 9)))
    return tables[best], {**proof, "followed": float(_SHARES[best])}


def _halves(scenarios: Scenarios) -> tuple[IntArray, IntArray]:
    """Return the indices of two halves of the simulated tests: one for the optimisation, one to
    judge its result.

    No target belongs to both halves. A table can be wrong between targets, and a test at the same
    targets would not show it.
    """
    targets = scenarios.positions.reshape(scenarios.count, -1)
    others = np.any(targets[1:] != targets[:-1], axis=1)
    place = np.concatenate([[0], np.cumsum(others)])
    return np.flatnonzero(place % 2 == 0), np.flatnonzero(place % 2 == 1)


def _smooth_changes(layout: UnknownsLayout) -> SparseMatrix:
    """Return a matrix (n, j) that interpolates changes at j positions to all n table values.

    Between these positions the changes follow straight lines. Single table points cannot change
    alone, because the simulated tests may not limit such a change. There may be no simulated target
    near the point, or only targets where a large change of the point has little effect.
    """
    points = layout.points
    k = points.size
    few = min(k, _KNOTS)
    curve = (
        identity(k)
        if few == k
        else hat_matrix(points, np.linspace(points[0], points[-1], few), below="hold", above="hold")
    )
    blocks = [curve]
    if layout.shape == "bidirectional":
        blocks.append(curve)
    elif layout.reversal != "none":
        blocks.append(identity(1))
    shape = (layout.size, sum(block.shape[1] for block in blocks))
    placed, row, column = [], 0, 0
    for block in blocks:
        placed.append(block.placed(shape, row, column))
        row, column = row + block.shape[0], column + block.shape[1]
    return sum_of(placed)


def _of_changes(
    limits: QuadraticProblem, start: FloatArray, bends_by: SparseMatrix
) -> QuadraticProblem:
    """Return the quadratic problem for changes c (j,), where the table values are ``start`` + B c
    and B is ``bends_by``.
    """
    held = limits.A @ start
    return QuadraticProblem(
        P=product(bends_by.transposed, product(limits.P, bends_by)),
        q=bends_by.transposed_times(limits.P @ start + limits.q),
        constant=limits.constant,
        A=product(limits.A, bends_by),
        lower=limits.lower - held,
        upper=limits.upper - held,
    )


def mean_over(
    goal: Range, table: AxisCompensation, wanted: WantedCorrection, scenarios: Scenarios
) -> float:
    """Return the mean of parameter ``goal`` over the simulated tests with a ``table``, mm or deg.

    Only the tests that the optimisation did not use are included.
    """
    where = scenarios.positions
    nothing = np.zeros(where.size)
    tests = np.repeat(np.arange(scenarios.count), where.size // scenarios.count)
    shown = [
        Deviations(
            D=from_dense(nothing[:, np.newaxis]),
            base=beyond + table.at(where, way) - _wanted_at(wanted, where, way, table.period),
            half=half if goal == "A" else nothing,
            test=tests,
        )
        for way, beyond, half in _measured(scenarios)
    ]
    together = _together(shown, 1, middle=goal == "M")
    _, held_out = _halves(scenarios)
    return together.of(held_out).mean_range(np.zeros(1))


def as_wanted(
    x: FloatArray, layout: UnknownsLayout, capacity: Capacity, wanted: WantedCorrection
) -> WantedCorrection:
    """Return the correction that the table values ``x`` (n,) give, in the form of a
    `WantedCorrection`.

    The form allows a table of whole increments to be fitted to this correction.
    """
    points, where = layout.points, wanted.positions
    inside = points[(points > where[0]) & (points < where[-1])]
    samples = np.union1d(where, inside)
    table = hat_matrix(
        samples,
        points,
        below=capacity.below,
        above=capacity.above,
        interpolation=capacity.interpolation,
    )
    positive, negative = (layout.columns(table, way) @ x for way in BOTH)
    return replace(wanted, positions=samples, positive=positive, negative=negative)


def _measured(
    scenarios: Scenarios,
) -> list[tuple[Direction, FloatArray, FloatArray]]:
    """Return for each measured direction: the direction, the deviations minus the estimated error,
    and the half-widths k s (coverage factor times standard deviation).
    """
    both = (
        (Direction.POSITIVE, scenarios.positive, scenarios.half_positive),
        (Direction.NEGATIVE, scenarios.negative, scenarios.half_negative),
    )
    return [entry for entry in both if entry[1].size]


def _wanted_at(
    wanted: WantedCorrection, where: FloatArray, way: Direction, period: float | None
) -> FloatArray:
    """Return the wanted correction at any positions. With a ``period`` the correction repeats."""
    if period is not None:
        where = wanted.reference + np.mod(where - wanted.reference, period)
    return np.interp(where, wanted.positions, wanted.total(way))


def _of_scenarios(
    goal: Range,
    wanted: WantedCorrection,
    scenarios: Scenarios,
    layout: UnknownsLayout,
    capacity: Capacity,
) -> Deviations:
    where = scenarios.positions
    folded = where
    if capacity.period is not None:
        folded = wanted.reference + np.mod(where - wanted.reference, capacity.period)
    table = hat_matrix(
        folded,
        layout.points,
        below=capacity.below,
        above=capacity.above,
        interpolation=capacity.interpolation,
    )
    tests = np.repeat(np.arange(scenarios.count), where.size // scenarios.count)
    parts = [
        Deviations(
            D=layout.columns(table, way),
            base=beyond - _wanted_at(wanted, where, way, capacity.period),
            half=half if goal == "A" else np.zeros(where.size),
            test=tests,
        )
        for way, beyond, half in _measured(scenarios)
    ]
    return _together(parts, layout.size, middle=goal == "M")


def _of_the_mean(
    goal: Range, wanted: WantedCorrection, layout: UnknownsLayout, capacity: Capacity
) -> Deviations:
    """Return the expected error that a table leaves, arranged like the deviations of one simulated
    test without scatter.

    Where the control's correction has a step, the values on both sides of the step count.
    """
    points, where, rule = layout.points, wanted.positions, capacity.interpolation
    inside = points[(points >= where[0]) & (points <= where[-1])]
    samples = np.union1d(where, inside)
    if rule == "step":
        midpoints = bends(points, rule)[1:-1]
        within = midpoints[(midpoints > where[0]) & (midpoints < where[-1])]
        samples = np.union1d(samples, np.concatenate([within, np.nextafter(within, -np.inf)]))
    table = hat_matrix(
        samples, points, below=capacity.below, above=capacity.above, interpolation=rule
    )
    nothing = np.zeros(samples.size)
    parts = [
        Deviations(
            D=layout.columns(table, way),
            base=-np.interp(samples, where, wanted.total(way)),
            half=nothing,
            test=np.zeros(samples.size, dtype=np.int64),
        )
        for way in BOTH
    ]
    return _together(parts, layout.size, middle=goal == "M")


def _together(parts: Sequence[Deviations], size: int, *, middle: bool) -> Deviations:
    """Return the deviations ``parts`` of the directions as one set with ``size`` table values or,
    with ``middle``, the mean of both directions.
    """
    first, last = parts[0], parts[-1]
    if middle and len(parts) > 1:
        return Deviations(
            D=sum_of([first.D, last.D]).times(0.5),
            base=0.5 * (first.base + last.base),
            half=first.half,
            test=first.test,
        )
    return Deviations(
        D=stack_rows([part.D for part in parts], size),
        base=np.concatenate([part.base for part in parts]),
        half=np.concatenate([part.half for part in parts]),
        test=np.concatenate([part.test for part in parts]),
    )
