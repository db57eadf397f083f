"""Minimisation of the mean range of simulated tests by a linear program, with numbers that prove
the optimum (a certificate).

The program is solved with cvxpy (Diamond and Boyd, J. Machine Learning Research 17, 2016). If the
solver stops early or reports its result as inaccurate, there is no solution.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from compwright.fitting.certify import range_gap
from compwright.fitting.problem import QuadraticProblem
from compwright.fitting.solve import by_columns, no_solution
from compwright.fitting.sparse_matrices import (
    IntArray,
    SparseMatrix,
    from_dense,
    from_entries,
    stack_rows,
    sum_of,
)
from compwright.foundations.errors import CapacityError
from compwright.foundations.one_thread import warnings_ignored
from compwright.records.axis import FloatArray
from compwright.records.rounding import rounded_number

#: A solution whose certificate misses by more than this (mm or deg) does not count, one nanometre:
#: it rests on an interior-point solver.
CERTIFIED_RANGE: Final = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Deviations:
    """The deviations of simulated tests, D x + ``base`` (r,), as a function of the table values x;
    mm or deg.

    ``half`` (r,): half width of the band about each deviation (k s for goal A, else 0). ``test``
    (r,): number of the test to which each row belongs, from 0.
    """

    D: SparseMatrix
    base: FloatArray
    half: FloatArray
    test: IntArray

    @property
    def tests(self) -> int:
        """The number of simulated tests."""
        return int(np.max(self.test)) + 1

    def of(self, chosen: IntArray) -> Deviations:
        """Return the deviations of the ``chosen`` tests, renumbered from 0."""
        number = np.full(self.tests, -1)
        number[chosen] = np.arange(chosen.size)
        kept = number[self.test] >= 0
        return Deviations(
            D=self.D.taken(kept),
            base=self.base[kept],
            half=self.half[kept],
            test=number[self.test][kept],
        )

    def mean_range(self, x: FloatArray) -> float:
        """Return the mean over the tests of the largest minus the smallest deviation, mm or deg."""
        left = self.D @ x + self.base
        top, bottom = np.full(self.tests, -np.inf), np.full(self.tests, np.inf)
        np.maximum.at(top, self.test, left + self.half)
        np.minimum.at(bottom, self.test, left - self.half)
        return float(np.mean(top - bottom))


def product(one: SparseMatrix, other: SparseMatrix) -> SparseMatrix:
    """Return the product of two sparse matrices."""
    found = (by_columns(one) @ by_columns(other)).tocoo()
    return from_entries(
        found.shape,
        found.row.astype(np.int64),
        found.col.astype(np.int64),
        np.asarray(found.data, dtype=np.float64),
    )


def solve_ranges(
    shown: Deviations, limits: QuadraticProblem, *, slack: float
) -> tuple[FloatArray, dict[str, float]]:
    """Return the table values under ``limits`` with the smallest mean range of the deviations
    ``shown``, and the numbers that prove this optimum (certificate). A range that is larger by
    ``slack`` (mm or deg) counts as equal.

    Of all values within ``slack`` of the smallest mean range, those of least mean square are
    returned. If the solver does not find these, the values of the smallest range are returned. The
    same certificate applies to both. Its ``gap`` is the distance to a lower bound that is valid
    whatever the solver did (weak duality; Boyd and Vandenberghe 2004, section 5.2.2). Source of the
    linear program: section 6.1.1 of the same book. Raises CapacityError if no solution is
    certified.
    """
    n = limits.q.size
    size = max(float(np.max(np.abs(shown.base))), 10.0 * slack)
    cost, G, h = _linear_program(shown, limits, size)
    first, multipliers = _cvxpy(cost, G, h, None, n)
    least = float(cost @ first)
    scale = float(np.mean(limits.P.diagonal()))
    try:
        taken, _ = _cvxpy(
            np.concatenate([limits.q / (scale * size), np.zeros(cost.size - n)]),
            stack_rows([G, from_dense(cost[np.newaxis])], cost.size),
            np.concatenate([h, [least + 0.5 * slack / size]]),
            limits.P.times(1.0 / scale),
            n,
        )
    except CapacityError:
        taken = first
    x = taken[:n] * size
    held = limits.A @ x
    primal = float(np.max(np.concatenate([[0.0], held - limits.upper, limits.lower - held])))
    # A least-range table stays within the range of what is wanted about zero: ten times that is
    # ample.
    gap = size * range_gap(cost, G, h, multipliers, shown.mean_range(x) / size, 10.0)
    proof = {"primal": rounded_number(primal), "gap": rounded_number(gap)}
    if not (primal <= CERTIFIED_RANGE and gap <= slack + CERTIFIED_RANGE):
        raise no_solution(
            "the least range does not pass its certificate",
            f"gap {gap:.3g}, limits broken by {primal:.3g}",
        )
    return x, proof


def _linear_program(
    shown: Deviations, limits: QuadraticProblem, size: float
) -> tuple[FloatArray, SparseMatrix, FloatArray]:
    """Return the arrays c, G, h of the linear program for the smallest mean range of the deviations
    ``shown``: minimise c'z subject to Gz <= h.

    z contains the table values, then the largest deviation of each test, then the smallest. All are
    in units of ``size``.
    """
    n, tests, rows = limits.q.size, shown.tests, shown.D.shape[0]
    wide = (rows, n + 2 * tests)
    every = np.arange(rows, dtype=np.int64)
    own = SparseMatrix(shape=(rows, tests), row=every, column=shown.test, value=np.ones(rows))
    below_top = sum_of([shown.D.placed(wide), own.times(-1.0).placed(wide, column=n)])
    above_bottom = sum_of([shown.D.times(-1.0).placed(wide), own.placed(wide, column=n + tests)])
    up, down = np.isfinite(limits.upper), np.isfinite(limits.lower)
    A = limits.A.placed((limits.A.shape[0], wide[1]))
    G = stack_rows([below_top, above_bottom, A.taken(up), A.taken(down).times(-1.0)], wide[1])
    h = np.concatenate(
        [
            -shown.base - shown.half,
            shown.base - shown.half,
            limits.upper[up],
            -limits.lower[down],
        ]
    )
    share = np.full(tests, 1.0 / tests)
    return np.concatenate([np.zeros(n), share, -share]), G, h / size


def _cvxpy(
    cost: FloatArray, G: SparseMatrix, h: FloatArray, P: SparseMatrix | None, n: int
) -> tuple[FloatArray, FloatArray]:
    import cvxpy as cp

    z: Any = cp.Variable(cost.size)
    objective = cost @ z
    if P is not None:
        objective = objective + 0.5 * cp.quad_form(z[:n], cp.psd_wrap(by_columns(P)))
    limits = [by_columns(G) @ z <= h]
    statement: Any = cp.Problem(cp.Minimize(objective), limits)
    try:
        with warnings_ignored("Solution may be inaccurate"):  # such a result has failed, below
            statement.solve(solver=cp.CLARABEL)
    except cp.error.SolverError as error:
        raise no_solution("the solver gave up", str(error)) from error
    if statement.status != cp.OPTIMAL:
        raise no_solution("the solver gave up", str(statement.status))
    return np.asarray(z.value, dtype=np.float64), np.asarray(limits[0].dual_value, dtype=np.float64)
