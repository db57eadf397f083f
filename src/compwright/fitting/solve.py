"""Solution of the quadratic problem with OSQP, refined to machine accuracy by an active-set method.

If OSQP stops early or reports its result as inaccurate, there is no solution. OSQP: Stellato et
al., Mathematical Programming Computation 12 (2020).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from compwright.fitting.certify import certificate
from compwright.fitting.problem import TIE, QuadraticProblem
from compwright.fitting.sparse_matrices import (
    BoolArray,
    SparseMatrix,
    differences,
    identity,
    sum_of,
)
from compwright.foundations.errors import CapacityError, Fault
from compwright.foundations.own_faults import SEND_JOB
from compwright.records.axis import FloatArray

#: A solution whose certificate misses by more than this (mm or deg) does not count: a thousandth of
#: a nanometre.
CERTIFIED: Final = 1e-9
_ACTIVE_SET_ROUNDS: Final = 20
_DUAL_SHIFT: Final = 1e-9  # keeps the equations solvable where limits repeat each other
_REFINEMENTS: Final = 3
_EVERYWHERE: Final = 32  # coupled with more unknowns than these: no neighbours
_SOLVED: Final = "solved"


@dataclass(frozen=True, slots=True)
class SolvedUnknowns:
    """The solution ``x`` of a quadratic problem, the Lagrange multipliers ``y`` of its limits, and
    the numbers that prove that ``x`` is optimal (certificate).
    """

    x: FloatArray
    y: FloatArray
    certificate: dict[str, float]


def solve_quadratic(problem: QuadraticProblem) -> SolvedUnknowns:
    """Return the optimum of a quadratic problem, with the numbers that prove that it is optimal.

    Raises CapacityError if there is no optimum or the certificate fails. Optimality conditions:
    Boyd and Vandenberghe, Convex Optimization, 2004, section 5.5.3.
    """
    limited = (problem.lower < problem.upper) & (
        np.isfinite(problem.lower) | np.isfinite(problem.upper)
    )
    if not np.any(limited):
        return _certified(problem, *_with_equations(problem, np.ones_like(limited), problem.lower))
    x, y = _with_equations(problem, *_active_set(problem, _osqp_multipliers(problem)))
    if max(certificate(problem, x, y).values()) > CERTIFIED:
        x, y = _with_equations(problem, *_least_distance_set(problem))
    return _certified(problem, x, y)


def load_solver() -> None:
    """Load the solver in advance, because loading takes a while."""
    import osqp  # noqa: F401


def _certified(problem: QuadraticProblem, x: FloatArray, y: FloatArray) -> SolvedUnknowns:
    proof = certificate(problem, x, y)
    worst = max(proof, key=lambda name: proof[name])
    if not proof[worst] <= CERTIFIED:
        raise no_solution(
            "the solution does not pass its certificate", f"{worst} missed by {proof[worst]:.3g}"
        )
    return SolvedUnknowns(x=x, y=y, certificate=proof)


def no_solution(message: str, found: str) -> CapacityError:
    """Return the error to raise if no solution is proven to be optimal. ``found``: the solver's
    result.
    """
    return CapacityError(
        Fault(
            message=f"no certified solution: the solver found no optimal table ({message})",
            expected="a proven optimum",
            found=found,
            hint=f"try another `table: {{spacing: ...}}`, and {SEND_JOB}",
        )
    )


def _osqp_multipliers(problem: QuadraticProblem) -> FloatArray:
    """Return the Lagrange multipliers (c,) of the limits from OSQP, which show the limits that the
    solution reaches.

    The wanted correction and the stiffness are scaled to size 1, because OSQP's tolerances are
    absolute.
    """
    import osqp

    stiffness = float(np.mean(problem.P.diagonal()))
    size = max(float(np.max(np.abs(problem.q))) / stiffness, 1e-9)
    solver: Any = osqp.OSQP()
    solver.setup(
        by_columns(problem.P.times(1.0 / stiffness).upper()),
        problem.q / (stiffness * size),
        by_columns(problem.A),
        problem.lower / size,
        problem.upper / size,
        verbose=False,
        eps_abs=1e-7,
        eps_rel=1e-7,
        max_iter=50_000,
        polishing=False,  # done here, exactly
    )
    result = solver.solve(raise_error=False)
    if result.info.status != _SOLVED:
        raise no_solution("the solver gave up", str(result.info.status))
    multipliers: FloatArray = np.asarray(result.y, dtype=np.float64) * stiffness * size
    return multipliers


def _active_set(problem: QuadraticProblem, y: FloatArray) -> tuple[BoolArray, FloatArray]:
    """Return a mask (c,) of the limits that the solution reaches, and the value (c,) of each limit:
    the upper one if the solution reaches it, else the lower one.

    Newton steps start from the multipliers ``y`` (c,). In each step, the limits that are reached
    become equations. A limit whose multiplier has the wrong sign is released, and a violated limit
    is added (Hintermüller, Ito and Kunisch, SIAM J. Optim. 13, 2002).
    """
    equal = problem.lower == problem.upper
    stiffness = float(np.mean(problem.P.diagonal()))
    small = 1e-7 * max(float(np.max(np.abs(y), initial=0.0)), 1e-300)
    upper, lower = (y > small) & ~equal, (y < -small) & ~equal
    for _ in range(_ACTIVE_SET_ROUNDS):
        x, y = _with_equations(
            problem, equal | upper | lower, np.where(upper, problem.upper, problem.lower)
        )
        held = problem.A @ x
        new_upper = (y + stiffness * (held - problem.upper) > stiffness * 1e-12) & ~equal
        new_lower = (y + stiffness * (held - problem.lower) < -stiffness * 1e-12) & ~equal
        if np.array_equal(new_upper, upper) and np.array_equal(new_lower, lower):
            break
        upper, lower = new_upper, new_lower
    return equal | upper | lower, np.where(upper, problem.upper, problem.lower)


def _least_distance_set(problem: QuadraticProblem) -> tuple[BoolArray, FloatArray]:
    """Return the limits that the solution reaches, as in `_active_set`, by a slower method that
    always ends.

    Limits are whole resolution steps, so several are often reached at one point. The multipliers
    are then not unique, and the Newton steps of `_active_set` may repeat. Here a least-distance
    problem is solved by non-negative least squares. This adds one independent limit at a time
    (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23, algorithms NNLS and LDP).
    """
    from scipy.optimize import nnls

    up, down = np.isfinite(problem.upper), np.isfinite(problem.lower)
    root, A = np.linalg.cholesky(problem.P.dense()), problem.A.dense()
    G = np.linalg.solve(root, np.vstack([-A[up], A[down]]).T).T
    centre = np.linalg.solve(root, -problem.q)
    h = np.concatenate([-problem.upper[up], problem.lower[down]]) - G @ centre
    size = max(float(np.max(np.abs(h))), 1e-300)
    try:
        push, _ = nnls(
            np.vstack([G.T, h / size]), np.append(np.zeros(centre.size), 1.0), maxiter=50 * h.size
        )
    except RuntimeError as error:
        raise no_solution("the solver gave up", str(error)) from error
    pushing = push > 0.0
    upper, lower = np.zeros_like(up), np.zeros_like(down)
    upper[up], lower[down] = pushing[: np.count_nonzero(up)], pushing[np.count_nonzero(up) :]
    equal = problem.lower == problem.upper
    return equal | upper | lower, np.where(upper, problem.upper, problem.lower)


def _with_equations(
    problem: QuadraticProblem, active: BoolArray, bound: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the optimum with the ``active`` limits as equations (right sides ``bound``), and the
    multipliers (c,).

    The conditions are those of Boyd and Vandenberghe 2004, section 10.1.1. They are solved with
    iterative refinement (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002,
    chapter 12).
    """
    rows = problem.A.taken(active)
    n, c = problem.q.size, rows.shape[0]
    # Rows in the size of P: the equations are the same and the matrix is better scaled.
    scale = float(np.mean(problem.P.diagonal()))
    square, scaled = (n + c, n + c), rows.times(scale)
    matrix = sum_of(
        [problem.P.placed(square), scaled.placed(square, n), scaled.transposed.placed(square, 0, n)]
    )
    right = np.concatenate([-problem.q, scale * bound[active]])
    shift = identity(c).times(-scale * _DUAL_SHIFT).placed(square, n, n)
    solve = _factored(sum_of([matrix, shift]))
    both = solve(right)
    # against the exact matrix: the shift only decides between limits that say the same
    for _ in range(_REFINEMENTS):
        both = both + solve(right - matrix @ both)
    y = np.zeros(problem.lower.size)
    y[active] = scale * both[n:]
    return both[:n], y


def _factored(matrix: SparseMatrix) -> Callable[[FloatArray], FloatArray]:
    """Return a function that solves ``matrix`` x = right, for a problem with equality conditions.

    The caller has subtracted a small number on the diagonal of the equations. The matrix is
    therefore quasi-definite and has triangular factors in any order, without row exchanges
    (Vanderbei, SIAM J. Optim. 5, 1995). The order puts table points next to their limits, which
    keeps the band narrow (Cuthill and McKee, Proc. 24th National Conference ACM, 1969). The
    constant between the directions comes last, because it is coupled with nearly all points.
    """
    from scipy.sparse.csgraph import reverse_cuthill_mckee
    from scipy.sparse.linalg import splu

    everywhere = np.bincount(matrix.row, minlength=matrix.shape[0]) > _EVERYWHERE
    near = matrix.taken(~everywhere).transposed.taken(~everywhere)
    band = reverse_cuthill_mckee(by_columns(near).tocsr(), symmetric_mode=True)
    order = np.concatenate([np.flatnonzero(~everywhere)[band], np.flatnonzero(everywhere)])
    factors: Any = splu(
        by_columns(matrix)[order][:, order], permc_spec="NATURAL", diag_pivot_thresh=0.0
    )
    back = np.argsort(order)

    def solve(right: FloatArray) -> FloatArray:
        solution: FloatArray = factors.solve(right[order])[back]
        return solution

    return solve


def least_squares(matrix: SparseMatrix, weights: FloatArray, values: FloatArray) -> FloatArray:
    """Return the unknowns (n,) that minimise the sum of ``weights`` times (``matrix`` x -
    ``values``)².

    The normal equations are solved (Golub and Van Loan, Matrix Computations, 4th ed. 2013, section
    5.3). Unknowns that the values do not determine become equal to their neighbours.
    """
    from scipy.sparse.linalg import splu

    unknowns = matrix.shape[1]
    tie = differences(unknowns).gram(np.full(unknowns - 1, TIE / unknowns))
    normal = sum_of([matrix.gram(weights), tie])
    solution: FloatArray = splu(by_columns(normal)).solve(matrix.transposed_times(weights * values))
    return solution


def by_columns(matrix: SparseMatrix) -> Any:
    """Return the matrix as a `scipy.sparse.csc_matrix`, the form that the solvers require."""
    from scipy.sparse import csc_matrix

    return csc_matrix((matrix.value, (matrix.row, matrix.column)), shape=matrix.shape)
