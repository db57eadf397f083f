"""Proof of optimality in numpy alone: whatever a solver says, only these numbers count.

Conditions of Karush, Kuhn and Tucker for: minimise x'Px/2 + q'x subject to lower <= Ax <= upper, with multipliers
y > 0 at the upper and y < 0 at the lower bound (Boyd and Vandenberghe, Convex Optimization, section 5.5.3).
"""

from __future__ import annotations

import numpy as np

from compwright.fitting.problem import QuadraticProblem
from compwright.records.axis import FloatArray


def certificate(problem: QuadraticProblem, x: FloatArray, y: FloatArray) -> dict[str, float]:
    """Return by how much each condition is missed, in mm or deg.

    ``primal``: the worst violated limit. ``stationarity``: the gradient against the stiffness of each unknown, that is
    how far a value would move. ``dual``: a multiplier of the wrong sign on a limit that has only one side, likewise.
    ``complementarity``: the largest distance from a limit that pushes, where only limits in touch may push.
    """
    stiffness = np.maximum(np.abs(np.diag(problem.P)), 1e-300)
    gradient = problem.P @ x + problem.q + problem.A.T @ y
    held = problem.A @ x
    force = _in_lengths(problem, y, stiffness)
    above, below = problem.upper - held, held - problem.lower
    slack = np.where(y > 0.0, above, below)
    one_sided = np.where(y > 0.0, ~np.isfinite(problem.upper), ~np.isfinite(problem.lower)) & (y != 0.0)
    pushing = np.where(np.isfinite(slack), np.minimum(np.abs(slack), np.abs(force)), 0.0)
    return {
        "primal": _worst(np.maximum(-above, -below)),
        "stationarity": _worst(np.abs(gradient) / stiffness),
        "dual": _worst(np.where(one_sided, np.abs(force), 0.0)),
        "complementarity": _worst(np.where(y != 0.0, pushing, 0.0)),
    }


def _in_lengths(problem: QuadraticProblem, y: FloatArray, stiffness: FloatArray) -> FloatArray:
    """Return multipliers as the shift of the unknowns that they cause (c,): mm or deg."""
    if not y.size:
        return y
    pull: FloatArray = np.max(np.abs(problem.A) / stiffness, axis=1) * y
    return pull


def _worst(values: FloatArray) -> float:
    return max(0.0, float(np.max(values))) if values.size else 0.0


def range_gap(cost: FloatArray, G: FloatArray, h: FloatArray, multipliers: FloatArray, reached: float, box: float) -> float:
    """Return by how much ``reached`` may lie above the least value of c'x subject to Gx <= h, for all x within ``box``.

    Weak duality: for multipliers y >= 0, c'x >= -h'y + (c + G'y)'x; the last term is at least -box |c + G'y|_1.
    """
    y = np.maximum(multipliers, 0.0)
    left = float(np.sum(np.abs(cost + G.T @ y)))
    bound = -float(h @ y) - box * left
    return max(0.0, reached - bound)
