"""Proof that a solution is optimal, computed with numpy alone, so that no solver has to be trusted.

The problem is: minimise x'Px/2 + q'x subject to lower <= Ax <= upper. A multiplier y is positive at
an upper bound and negative at a lower bound. The proof checks the conditions of Karush, Kuhn and
Tucker (Boyd and Vandenberghe, Convex Optimization, 2004, section 5.5.3). A table of whole
increments is checked from the table itself: its values, its limits, and the error that it leaves.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.fitting.problem import QuadraticProblem, quadrature
from compwright.fitting.sparse_matrices import SparseMatrix
from compwright.foundations.errors import CapacityError, Fault
from compwright.foundations.own_faults import SEND_JOB
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.rounding import RESIDUE, rounded_number

#: A table of whole increments must keep every limit to this share of the unit: arithmetic dust.
WHOLE: Final = 1e-6


def certificate(problem: QuadraticProblem, x: FloatArray, y: FloatArray) -> dict[str, float]:
    """Return the amount by which a solution violates each optimality condition, mm or deg.

    ``x`` (n,): solution; ``y`` (c,): multipliers of the limits. The conditions are those of Karush,
    Kuhn and Tucker (Boyd and Vandenberghe 2004, section 5.5.3).

    - ``primal``: the largest violation of a limit.
    - ``stationarity``: the largest derivative of the Lagrange function by an unknown, divided by
      the stiffness of this unknown (diagonal of P), which gives a length.
    - ``dual``: the largest multiplier with the sign of a limit that does not exist, as a length.
    - ``complementarity``: the largest distance from a limit whose multiplier is not zero.
    """
    stiffness = np.maximum(np.abs(problem.P.diagonal()), 1e-300)
    gradient = problem.P @ x + problem.q + problem.A.transposed_times(y)
    held = problem.A @ x
    force = _in_lengths(problem, y, stiffness)
    above, below = problem.upper - held, held - problem.lower
    slack = np.where(y > 0.0, above, below)
    one_sided = np.where(y > 0.0, ~np.isfinite(problem.upper), ~np.isfinite(problem.lower)) & (
        y != 0.0
    )
    pushing = np.where(np.isfinite(slack), np.minimum(np.abs(slack), np.abs(force)), 0.0)
    return {
        "primal": _worst(np.maximum(-above, -below)),
        "stationarity": _worst(np.abs(gradient) / stiffness),
        "dual": _worst(np.where(one_sided, np.abs(force), 0.0)),
        "complementarity": _worst(np.where(y != 0.0, pushing, 0.0)),
    }


def rounded_proof(proof: Mapping[str, float]) -> dict[str, float]:
    """Return the numbers that prove optimality (the certificate), rounded so that they are equal on
    every processor (rounding errors: Higham 2002, chapter 3).
    """
    return {name: rounded_number(value, RESIDUE) for name, value in proof.items()}


def _in_lengths(problem: QuadraticProblem, y: FloatArray, stiffness: FloatArray) -> FloatArray:
    """Return each multiplier ``y`` (c,) as the change of a table value that it causes, mm or deg.
    ``stiffness`` (n,): diagonal of the matrix P of the problem.
    """
    if not y.size:
        return y
    return problem.A.largest_in_rows(stiffness) * y


def _worst(values: FloatArray) -> float:
    return max(0.0, float(np.max(values))) if values.size else 0.0


def range_gap(
    cost: FloatArray,
    G: SparseMatrix,
    h: FloatArray,
    multipliers: FloatArray,
    reached: float,
    box: float,
) -> float:
    """Return an upper bound of how far the objective ``reached`` exceeds the minimum of a linear
    program.

    The program minimises c'x over all x with Gx <= h and absolute values up to ``box``. ``cost``
    (n,) is c; ``G`` (r, n) and ``h`` (r,) are the limits; ``multipliers`` (r,) are y. By weak
    duality (Boyd and Vandenberghe 2004, section 5.2.2), c'x >= -h'y + (c + G'y)'x for all y >= 0.
    The last term is at least -box |c + G'y|_1.
    """
    y = np.maximum(multipliers, 0.0)
    left = float(np.sum(np.abs(cost + G.transposed_times(y))))
    bound = -float(h @ y) - box * left
    return max(0.0, reached - bound)


def lattice_certificate(
    table: AxisCompensation,
    aim: WantedCorrection,
    capacity: Capacity,
    magnification: int,
    claimed: tuple[float, float],
) -> dict[str, float]:
    """Return the numbers that prove a table of whole increments (its certificate), by name.
    ``claimed``: mean square and its lower bound according to the search, mm² or deg².

    - ``primal``: the largest violation of a limit, mm or deg.
    - ``objective``: the rms error of the table, mm or deg, computed here from the table (exact:
      `quadrature`, two Gauss points).
    - ``lower_bound``: a lower bound of this error, the square root of the claimed one.
    - ``recomputed``: the difference between ``objective`` and the claimed rms error.
    - ``magnification``: the magnification of the table.

    Raises CapacityError if a limit is violated, if the claimed mean square is wrong, or if the mean
    square is below its lower bound (weak duality: Boyd and Vandenberghe 2004, section 5.2.2).
    Raises TypeError for a control without whole increments.
    """
    lattice = capacity.lattice
    if lattice is None:
        raise TypeError("the control has no lattice")
    primal = _broken(table, aim, capacity, magnification)
    points, weights = quadrature(aim.positions, table.positions, table.interpolation)
    left = [
        table.at(points, direction) - np.interp(points, aim.positions, aim.total(direction))
        for direction in Direction
    ]
    mean_square = 0.5 * float(sum(weights @ one**2 for one in left))
    dust = 1e-7 * mean_square + (WHOLE * lattice.unit) ** 2
    proof = {
        "primal": primal,
        "objective": float(np.sqrt(mean_square)),
        "lower_bound": float(np.sqrt(max(0.0, claimed[1]))),
        "recomputed": abs(float(np.sqrt(mean_square) - np.sqrt(claimed[0]))),
        "magnification": float(magnification),
    }
    if (
        primal > WHOLE * lattice.unit
        or abs(mean_square - claimed[0]) > dust
        or mean_square < claimed[1] - dust
    ):
        found = ", ".join(f"{name} {value:.6g}" for name, value in proof.items())
        raise CapacityError(
            Fault(
                message="no certified solution: the check whether the table is the best "
                "possible one failed",
                found=found,
                hint=f"try another `table: {{spacing: ...}}`, and {SEND_JOB}",
            )
        )
    return proof


def _broken(
    table: AxisCompensation, aim: WantedCorrection, capacity: Capacity, magnification: int
) -> float:
    """Return the amount of the largest violation of a limit, mm or deg."""
    lattice = capacity.lattice
    if lattice is None:
        raise TypeError("the control has no lattice")
    step, home = magnification * lattice.unit, table.reference_return
    anchor = int(np.argmin(np.abs(table.positions - aim.reference)))
    missed = [abs(float(table.curve(home)[anchor]))]
    for direction in Direction:
        curve = table.curve(direction)
        counts = np.diff(curve) / step
        limits = np.clip(np.round(counts), *lattice.increments)
        missed.append(step * _worst(np.abs(counts - limits)))
        missed.append(
            _worst(np.maximum(curve - capacity.value_range[1], capacity.value_range[0] - curve))
        )
        if table.period is not None:
            missed.append(abs(float(curve[-1] - curve[0])))
    if not np.array_equal(table.positive, table.negative):
        one = lattice.unit * (magnification if lattice.offset_magnified else 1)
        offset = float(table.curve(home.opposite)[anchor]) / one
        missed.append(
            one * abs(offset - float(np.clip(np.round(offset), *(lattice.offset_range or (0, 0)))))
        )
    if table.backlash and capacity.backlash_quantum is not None:
        count = table.backlash / capacity.backlash_quantum
        missed.append(capacity.backlash_quantum * abs(count - round(count)))
        low, high = capacity.backlash_range
        missed.append(max(0.0, table.backlash - high, low - table.backlash))
    return max(missed)
