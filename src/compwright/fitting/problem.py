"""The fit of a table as a quadratic problem (Boyd and Vandenberghe, Convex Optimization, 2004,
section 4.4).

The problem is made from the control's interpolation, the wanted correction, and the control's
limits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from compwright.fitting.sparse_matrices import (
    IntArray,
    SparseMatrix,
    differences,
    identity,
    stack_rows,
    sum_of,
)
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import Beyond, Interpolation
from compwright.records.estimate import WantedCorrection

Shape = Literal["single", "bidirectional"]
BOTH: Final = (Direction.POSITIVE, Direction.NEGATIVE)
#: Weight of the differences of neighbouring values against the fit: decides only points that no
#: part of the travel sees.
TIE: Final = 1e-10


@dataclass(frozen=True, slots=True)
class Rows:
    """The control's interpolation between table points: ``lower * value[left] + upper * value[left
    + 1]`` at each position, arrays (p,).
    """

    left: IntArray
    lower: FloatArray
    upper: FloatArray


def rows_at(
    positions: FloatArray,
    points: FloatArray,
    *,
    below: Beyond,
    above: Beyond,
    interpolation: Interpolation = "linear",
) -> Rows:
    """Return the interpolation weights at ``positions`` (p,) between ascending table points
    ``points`` (k,), k >= 2. ``below``, ``above``: whether the correction beyond this end of the
    table keeps the end value or is zero.

    ``interpolation`` ``linear``: straight lines (de Boor, A Practical Guide to Splines, 1978,
    chapter III). ``step``: the value of the nearest point. Exactly in the middle between two
    points, the value of the upper point applies, as in the record `AxisCompensation`.
    """
    right = np.clip(np.searchsorted(points, positions, side="right"), 1, points.size - 1)
    if interpolation == "step":
        share = np.where(positions >= 0.5 * (points[right - 1] + points[right]), 1.0, 0.0)
    else:
        share = np.clip(
            (positions - points[right - 1]) / (points[right] - points[right - 1]), 0.0, 1.0
        )
    outside = np.zeros(positions.shape, dtype=bool)
    if below == "zero":
        outside |= positions < points[0]
    if above == "zero":
        outside |= positions > points[-1]
    return Rows(
        left=right - 1,
        lower=np.where(outside, 0.0, 1.0 - share),
        upper=np.where(outside, 0.0, share),
    )


def hat_matrix(
    positions: FloatArray,
    points: FloatArray,
    *,
    below: Beyond,
    above: Beyond,
    interpolation: Interpolation = "linear",
) -> SparseMatrix:
    """Return the matrix (p, k) from table values at ``points`` (k,) to the control's correction at
    ``positions`` (p,), made of hat functions (de Boor 1978, chapter III). ``below``, ``above``:
    whether the correction beyond this end of the table keeps the end value or is zero.
    """
    rows = rows_at(positions, points, below=below, above=above, interpolation=interpolation)
    value = np.column_stack([rows.lower, rows.upper]).ravel()
    kept = value != 0.0
    return SparseMatrix(
        shape=(positions.size, points.size),
        row=np.repeat(np.arange(positions.size), 2)[kept],
        column=np.column_stack([rows.left, rows.left + 1]).ravel()[kept],
        value=value[kept],
    )


def bends(points: FloatArray, interpolation: Interpolation) -> FloatArray:
    """Return the positions where the control's curve through points ``points`` (k,) bends or jumps.

    With linear interpolation these are the table points (k,). With steps they are the midpoints and
    the two ends (k + 1,).
    """
    if interpolation == "linear":
        return points
    return np.concatenate([points[:1], 0.5 * (points[1:] + points[:-1]), points[-1:]])


def quadrature(
    positions: FloatArray, points: FloatArray, interpolation: Interpolation = "linear"
) -> tuple[FloatArray, FloatArray]:
    """Return points (q,) and weights (q,) with sum 1 that compute the mean over the travel, from
    the first to the last of ``positions``.

    Each piece between neighbouring positions or bends has two Gauss points, middle +- half /
    sqrt(3) (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, table 25.4). They are
    exact for the squared difference of two piecewise straight curves.
    """
    breaks = bends(points, interpolation)
    inside = breaks[(breaks > positions[0]) & (breaks < positions[-1])]
    ends = np.union1d(positions, inside)
    middle, half = 0.5 * (ends[1:] + ends[:-1]), 0.5 * np.diff(ends)
    offset = half / np.sqrt(3.0)
    samples = np.column_stack([middle - offset, middle + offset]).ravel()
    return samples, np.repeat(half, 2) / float(ends[-1] - ends[0])


@dataclass(frozen=True, slots=True, kw_only=True)
class UnknownsLayout:
    """The order of the unknowns: the table values of the reference-return direction, then the table
    values of the other direction or one constant difference.

    ``points`` (k,): table points, mm or deg. ``home``: the reference-return direction.
    ``reversal``: how the control can hold the constant difference: ``free`` (two tables),
    ``backlash`` (backlash value), or ``none``.
    """

    points: FloatArray
    shape: Shape
    reversal: Literal["free", "backlash", "none"]
    home: Direction

    @property
    def size(self) -> int:
        """The number of unknowns of the optimisation."""
        if self.shape == "bidirectional":
            return 2 * self.points.size
        return self.points.size + (0 if self.reversal == "none" else 1)

    def columns(self, matrix: SparseMatrix, direction: Direction) -> SparseMatrix:
        """Return the matrix (p, size) that computes the correction in ``direction`` from all
        unknowns.
        """
        k, shape = self.points.size, (matrix.shape[0], self.size)
        if self.shape == "bidirectional":
            return matrix.placed(shape, column=0 if direction is self.home else k)
        own = matrix.placed(shape)
        if self.reversal == "none" or direction is self.home:
            return own
        # A second table holds the constant only where a table is active; backlash compensation is
        # active everywhere.
        points = np.arange(matrix.shape[0], dtype=np.int64)
        constant_part = matrix @ np.ones(k) if self.reversal == "free" else np.ones(points.size)
        constant = SparseMatrix(
            shape=shape, row=points, column=np.full(points.size, k), value=constant_part
        )
        return sum_of([own, constant])


@dataclass(frozen=True, slots=True, kw_only=True)
class QuadraticProblem:
    """A quadratic problem: minimise x'Px/2 + q'x + constant subject to lower <= Ax <= upper.

    The shapes are x (n,), P (n, n), A (c, n); x is in mm or deg. The objective is the mean square
    of table minus wanted correction over the travel and both directions. Rows of A with ``lower``
    equal to ``upper`` are equalities: the zero state, and equal ends of an endless axis. Source:
    Boyd and Vandenberghe 2004, section 4.4.
    """

    P: SparseMatrix
    q: FloatArray
    constant: float
    A: SparseMatrix
    lower: FloatArray
    upper: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class SampledCorrection:
    """The wanted correction at weighted sample points, and the control's interpolation there."""

    samples: FloatArray
    weights: FloatArray
    matrix: SparseMatrix
    wanted: Mapping[Direction, FloatArray]

    def mean_square(self, layout: UnknownsLayout, x: FloatArray) -> float:
        """Return the mean square difference between table and wanted correction over points and
        directions, mm² or deg².

        ``x`` (layout.size,): the unknowns, mm or deg.
        """
        return 0.5 * float(
            sum(
                self.weights
                @ (layout.columns(self.matrix, direction) @ x - self.wanted[direction]) ** 2
                for direction in BOTH
            )
        )


def sample_correction(
    wanted: WantedCorrection, points: FloatArray, capacity: Capacity
) -> SampledCorrection:
    """Return ``wanted`` at the quadrature points of the travel (`quadrature`), mm or deg."""
    samples, weights = quadrature(wanted.positions, points, capacity.interpolation)
    return SampledCorrection(
        samples=samples,
        weights=weights,
        matrix=hat_matrix(
            samples,
            points,
            below=capacity.below,
            above=capacity.above,
            interpolation=capacity.interpolation,
        ),
        wanted={
            direction: np.interp(samples, wanted.positions, wanted.total(direction))
            for direction in BOTH
        },
    )


def limited_range(capacity: Capacity) -> tuple[float, float]:
    """Return the lowest and the highest value that a table point can have, mm or deg: the control's
    value range, rounded inward to whole multiples of the resolution.
    """
    quantum = capacity.quantum
    low, high = capacity.value_range
    return (
        float(np.ceil(low / quantum - 1e-9)) * quantum,
        float(np.floor(high / quantum + 1e-9)) * quantum,
    )


def build_problem(
    data: SampledCorrection,
    layout: UnknownsLayout,
    capacity: Capacity,
    reference: float,
    *,
    without: tuple[str, ...] = (),
) -> QuadraticProblem:
    """Return the quadratic problem of a table that is zero at the position ``reference``. The
    groups of limits named in ``without`` are left out, to find the cost of these limits.
    """
    P, q, constant = _objective(data, layout)
    blocks = [
        block
        for block in _limits(layout, capacity, reference)
        if block[0] not in without and block[1].shape[0]
    ]
    return QuadraticProblem(
        P=P,
        q=q,
        constant=constant,
        A=stack_rows([rows for _, rows, _, _ in blocks], layout.size),
        lower=np.concatenate(
            [np.empty(0), *(np.full(rows.shape[0], low) for _, rows, low, _ in blocks)]
        ),
        upper=np.concatenate(
            [np.empty(0), *(np.full(rows.shape[0], high) for _, rows, _, high in blocks)]
        ),
    )


def _objective(
    data: SampledCorrection, layout: UnknownsLayout
) -> tuple[SparseMatrix, FloatArray, float]:
    k = layout.points.size
    square = (layout.size, layout.size)
    tie = differences(k).gram(np.full(k - 1, TIE / k))
    parts = [tie.placed(square)]
    if layout.shape == "bidirectional":
        parts.append(tie.placed(square, k, k))
    q, constant = np.zeros(layout.size), 0.0
    for direction in BOTH:
        columns = layout.columns(data.matrix, direction)
        parts.append(columns.gram(data.weights))
        q -= columns.transposed_times(data.weights * data.wanted[direction])
        constant += 0.5 * float(data.weights @ data.wanted[direction] ** 2)
    return sum_of(parts), q, constant


def _limits(
    layout: UnknownsLayout, capacity: Capacity, reference: float
) -> list[tuple[str, SparseMatrix, float, float]]:
    """Return each group of limits as name, matrix, lower and upper bound: ``reference`` and
    ``period`` (equalities), ``value range``, ``backlash range``.
    """
    k = layout.points.size
    at_reference = hat_matrix(
        np.array([reference]),
        layout.points,
        below=capacity.below,
        above=capacity.above,
        interpolation=capacity.interpolation,
    )
    zero = layout.columns(at_reference, layout.home)
    blocks = [("reference", zero.taken(np.full(1, zero.row.size > 0)), 0.0, 0.0)]
    two_curves = layout.shape == "bidirectional" or layout.reversal == "free"
    curves = [layout.columns(identity(k), layout.home)]
    if two_curves:
        curves.append(layout.columns(identity(k), layout.home.opposite))
    if capacity.period is not None:
        closing = curves if layout.shape == "bidirectional" else curves[:1]
        closed = [_first_less_last(curve) for curve in closing]
        blocks.append(("period", stack_rows(closed, layout.size), 0.0, 0.0))
    low, high = limited_range(capacity)
    if np.isfinite(low) or np.isfinite(high):
        blocks.append(("value range", stack_rows(curves, layout.size), low, high))
    if two_curves and capacity.zero is not None:
        plus, minus = (layout.columns(at_reference, direction) for direction in BOTH)
        blocks.append(
            ("backlash range", sum_of([plus, minus.times(-1.0)]), *capacity.backlash_range)
        )
    if layout.shape == "single" and layout.reversal == "backlash":
        # from the correction in the other direction to the backlash
        row = identity(1).times(layout.home.opposite.sign).placed((1, layout.size), column=k)
        blocks.append(("backlash range", row, *capacity.backlash_range))
    return blocks


def _first_less_last(curve: SparseMatrix) -> SparseMatrix:
    row = np.arange(curve.shape[0])
    return sum_of([curve.taken(row == 0), curve.taken(row == row[-1]).times(-1.0)])
