"""Solving: OSQP for the quadratic problem, refined to machine accuracy by its active set; cvxpy for the smallest range.

A solver that was cut off or calls its result inaccurate has failed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from compwright.fitting.certify import certificate, range_gap
from compwright.fitting.problem import QuadraticProblem
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import FloatArray

#: A solution whose certificate misses by more than this (mm or deg: 1 nm, 0.0036 arcsec) does not count.
CERTIFIED: Final = 1e-6
_ACTIVE_SET_ROUNDS: Final = 60
_SOLVED: Final = "solved"


@dataclass(frozen=True, slots=True)
class Solution:
    """Unknowns ``x``, multipliers ``y`` of the limits, and the certificate."""

    x: FloatArray
    y: FloatArray
    certificate: dict[str, float]


def solve_quadratic(problem: QuadraticProblem) -> Solution:
    """Return the certified optimum. Raises CapacityError where there is none or the certificate fails."""
    if not np.any((problem.lower < problem.upper) & (np.isfinite(problem.lower) | np.isfinite(problem.upper))):
        start = np.zeros(problem.lower.size)
    else:
        start = _osqp_multipliers(problem)
    x, y = _refined(problem, start)
    proof = certificate(problem, x, y)
    worst = max(proof, key=lambda name: proof[name])
    if not proof[worst] <= CERTIFIED:
        raise _no_solution("the solution does not pass its certificate", f"{worst} missed by {proof[worst]:.3g}")
    return Solution(x=x, y=y, certificate=proof)


def _no_solution(message: str, found: str) -> CapacityError:
    return CapacityError(Fault(message=f"no certified solution: {message}", expected="an exact optimum", found=found))


def _osqp_multipliers(problem: QuadraticProblem) -> FloatArray:
    """Return OSQP's multipliers; they name the limits in touch.

    Scaled to a wanted correction of size 1 and a stiffness of size 1, so that OSQP's absolute tolerances mean something.
    """
    import osqp
    from scipy import sparse

    stiffness = float(np.mean(np.diag(problem.P)))
    size = max(float(np.max(np.abs(problem.q))) / stiffness, 1e-9)
    solver: Any = osqp.OSQP()
    solver.setup(
        sparse.csc_matrix(np.triu(problem.P / stiffness)),
        problem.q / (stiffness * size),
        sparse.csc_matrix(problem.A),
        problem.lower / size,
        problem.upper / size,
        verbose=False,
        eps_abs=1e-7,
        eps_rel=1e-7,
        max_iter=50_000,
        polishing=True,
    )
    result = solver.solve(raise_error=False)
    if result.info.status != _SOLVED:
        raise _no_solution("the solver gave up", str(result.info.status))
    multipliers: FloatArray = np.asarray(result.y, dtype=np.float64) * stiffness * size
    return multipliers


def _refined(problem: QuadraticProblem, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the optimum by Newton's method on the active set (Hintermüller, Ito and Kunisch, SIAM J. Optim. 13, 2002).

    The limits in touch are taken as equations; a limit that pulls is let go, a limit that is broken is taken in.
    """
    equal = problem.lower == problem.upper
    stiffness = float(np.mean(np.diag(problem.P)))
    small = 1e-9 * max(float(np.max(np.abs(y), initial=0.0)), 1e-300)
    upper, lower = (y > small) & ~equal, (y < -small) & ~equal
    for _ in range(_ACTIVE_SET_ROUNDS):
        bound = np.where(upper, problem.upper, problem.lower)
        x, y = _with_equations(problem, equal | upper | lower, bound)
        held = problem.A @ x
        new_upper = (y + stiffness * (held - problem.upper) > stiffness * 1e-12) & ~equal
        new_lower = (y + stiffness * (held - problem.lower) < -stiffness * 1e-12) & ~equal
        if np.array_equal(new_upper, upper) and np.array_equal(new_lower, lower):
            break
        upper, lower = new_upper, new_lower
    return x, y


def _with_equations(problem: QuadraticProblem, active: Any, bound: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the optimum with the ``active`` limits as equations, and the multipliers (0 for the rest)."""
    rows = problem.A[active]
    n, c = problem.q.size, rows.shape[0]
    matrix = np.zeros((n + c, n + c))
    matrix[:n, :n] = problem.P
    # Rows in the size of P: the equations are the same and the matrix is better scaled.
    scale = float(np.mean(np.diag(problem.P)))
    matrix[:n, n:] = scale * rows.T
    matrix[n:, :n] = scale * rows
    right = np.concatenate([-problem.q, scale * bound[active]])
    try:
        both = np.linalg.solve(matrix, right)
        if not np.allclose(matrix @ both, right, rtol=0.0, atol=1e-9 * max(float(np.max(np.abs(right))), 1e-300)):
            raise np.linalg.LinAlgError
        both += np.linalg.solve(matrix, right - matrix @ both)
    except np.linalg.LinAlgError:
        both = np.linalg.lstsq(matrix, right, rcond=None)[0]  # limits that say the same twice
    y = np.zeros(problem.lower.size)
    y[active] = scale * both[n:]
    return both[:n], y


@dataclass(frozen=True, slots=True, kw_only=True)
class RangeProblem:
    """Minimise the range (largest minus smallest) of Dx - d over its rows, under the limits of ``limits``; mm or deg."""

    D: FloatArray
    d: FloatArray
    limits: QuadraticProblem


def solve_range(problem: RangeProblem, *, slack: float) -> tuple[FloatArray, dict[str, float]]:
    """Return unknowns of least range, and the certificate. Raises CapacityError where none is certified.

    Among all unknowns within ``slack`` (mm or deg) of the least range, those of least mean square are taken. The certificate's ``gap``
    is the distance to a lower bound that holds whatever the solver did.
    """
    size = max(float(np.max(np.abs(problem.d))), 10.0 * slack)
    cost, G, h = _linear_program(problem, size)
    first, multipliers = _cvxpy(cost, G, h, None, problem.limits.q.size)
    least = float(cost @ first)
    P = problem.limits.P
    scale = float(np.mean(np.diag(P)))
    G2 = np.vstack([G, cost])
    h2 = np.concatenate([h, [least + 0.5 * slack / size]])
    second, _ = _cvxpy(np.concatenate([problem.limits.q / (scale * size), [0.0, 0.0]]), G2, h2, P / scale, problem.limits.q.size)
    x = second[:-2] * size
    deviation = problem.D @ x - problem.d
    reached = float(np.ptp(deviation))
    held = problem.limits.A @ x
    primal = float(np.max(np.concatenate([[0.0], held - problem.limits.upper, problem.limits.lower - held])))
    # A least-range table stays within the range of what is wanted about zero: ten times that is ample.
    gap = size * range_gap(cost, G, h, multipliers, reached / size, 10.0)
    proof = {"primal": primal, "gap": gap}
    if not (primal <= CERTIFIED and gap <= slack + CERTIFIED):
        raise _no_solution("the least range does not pass its certificate", f"gap {gap:.3g}, limits broken by {primal:.3g}")
    return x, proof


def _linear_program(problem: RangeProblem, size: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return c, G, h of: minimise c'z subject to Gz <= h, z = (x, top, bottom) in units of ``size``."""
    limits = problem.limits
    n, rows = limits.q.size, problem.D.shape[0]
    one, none = np.ones((rows, 1)), np.zeros((rows, 1))
    up, down = np.isfinite(limits.upper), np.isfinite(limits.lower)
    pad = np.zeros((limits.A.shape[0], 2))
    A = np.hstack([limits.A, pad])
    G = np.vstack([np.hstack([problem.D, -one, none]), np.hstack([-problem.D, none, one]), A[up], -A[down]])
    h = np.concatenate([problem.d, -problem.d, limits.upper[up], -limits.lower[down]]) / size
    return np.concatenate([np.zeros(n), [1.0, -1.0]]), G, h


def _cvxpy(
    cost: FloatArray, G: FloatArray, h: FloatArray, P: FloatArray | None, n: int
) -> tuple[FloatArray, FloatArray]:
    import cvxpy as cp
    from scipy import sparse

    z: Any = cp.Variable(cost.size)
    objective = cost @ z
    if P is not None:
        objective = objective + 0.5 * cp.quad_form(z[:n], cp.psd_wrap(0.5 * (P + P.T)))
    limits = [sparse.csr_matrix(G) @ z <= h]
    statement: Any = cp.Problem(cp.Minimize(objective), limits)
    try:
        statement.solve(solver=cp.CLARABEL)
    except cp.error.SolverError as error:
        raise _no_solution("the solver gave up", str(error)) from error
    if statement.status != cp.OPTIMAL:
        raise _no_solution("the solver gave up", str(statement.status))
    return np.asarray(z.value, dtype=np.float64), np.asarray(limits[0].dual_value, dtype=np.float64)
