"""Fit of one curve in which each table value is coupled only with its neighbours (a chain): its
optimum without whole-number values, and lower bounds.

The mean square of table minus wanted correction is a quadratic function. Its matrix H is
tridiagonal (linear interpolation) or diagonal (steps). Let v0 be the table values at the minimum. A
constant c, the reversal value, is added to the curve; c0 is its value at the minimum. The vector r
couples it with the table values:

    f(v, c) = least + (v - v0)'H(v - v0)/2 + (c - c0) r'(v - v0) + stiffness (c - c0)^2 / 2

All values are in mm or deg, f in mm² or deg². Mean squares of straight lines between table points:
de Boor, A Practical Guide to Splines (1978), chapter III. Lower bounds by multipliers: Boyd and
Vandenberghe, Convex Optimization (2004), section 5.1.3.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from compwright.fitting.problem import Rows
from compwright.fitting.sparse_matrices import IntArray
from compwright.records.axis import FloatArray

BoolArray = NDArray[np.bool_]
#: A point that the travel sees less than this (against the one that it sees most) counts as not
#: seen.
_UNSEEN: Final = 1e-12
#: Keeps the least eigenvalue on the safe side of its rounding error.
_SAFE: Final = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class CurveChain:
    """The m table values of one curve, and the quadratic objective that they minimise.

    ``size``: number of points of the table. ``kept`` (m,): indices of the m optimised points:
    points within the travel and points with a limit. ``span`` (m-1,): number of sections between
    neighbours. ``diagonal`` (m,), ``off`` (m-1,): diagonal and off-diagonal of H. ``optimum`` (m,),
    ``constant``, ``coupling`` (m,): v0, c0 and r of the objective. ``fixed`` (m,): the value is
    zero. ``closed``: the last value equals the first. ``inverse`` (m,): diagonal of H^-1.
    ``share``: H - share * diag(H) is positive semidefinite.
    """

    size: int
    kept: IntArray
    span: IntArray
    diagonal: FloatArray
    off: FloatArray
    fixed: BoolArray
    closed: bool
    optimum: FloatArray
    constant: float
    coupling: FloatArray
    stiffness: float
    least: float
    inverse: FloatArray
    share: float

    @property
    def left(self) -> float:
        """The second derivative of the objective by the constant (reversal value), with the table
        values optimised again for each value of the constant.
        """
        return self.stiffness - float(self.coupling @ self.solve(self.coupling))

    def solve(self, right: FloatArray) -> FloatArray:
        """Return H^-1 ``right``, (m,) or (m, n), by the Cholesky factors of a band matrix (Golub
        and Van Loan, Matrix Computations, 4th ed. 2013, section 4.3).
        """
        from scipy.linalg import solveh_banded

        if not self.off.size:
            return right / self.diagonal
        bands = np.vstack([np.append(0.0, self.off), self.diagonal])
        solution: FloatArray = solveh_banded(bands, right)
        return solution

    def excess(self, e: FloatArray) -> float:
        """Return how much the objective exceeds its minimum, e'He/2, for table values that differ
        by e (m,) from the optimum; mm² or deg².
        """
        return float(0.5 * self.diagonal @ e**2 + self.off @ (e[1:] * e[:-1]))

    def value(self, v: FloatArray, constant: float) -> float:
        """Return the objective, mm² or deg², for table values ``v`` (m,) and the reversal value
        ``constant``.
        """
        e, c = v - self.optimum, constant - self.constant
        return (
            self.least
            + self.excess(e)
            + c * float(self.coupling @ e)
            + 0.5 * self.stiffness * c * c
        )

    def expanded(self, totals: IntArray) -> IntArray:
        """Return whole-number values (size,) at all table points, interpolated from the values
        ``totals`` (m,) at the optimised points.

        Between optimised points the values change in equal steps, rounded to whole numbers. Beyond
        them the values are constant.
        """
        full = np.empty(self.size, dtype=np.int64)
        full[: self.kept[0]], full[self.kept[-1] :] = totals[0], totals[-1]
        for index, span in enumerate(self.span):
            step = np.arange(int(span), dtype=np.int64)
            # Whole numbers throughout: the steps are then the mean step rounded up or down, which
            # the limits hold.
            full[self.kept[index] + step] = totals[index] + (
                2 * (totals[index + 1] - totals[index]) * step + span
            ) // (2 * span)
        return full


@dataclass(frozen=True, slots=True, kw_only=True)
class ChainTarget:
    """The wanted curve at sample points: interpolation ``rows``, ``weights`` (p,) and wanted values
    ``aims`` (p,), mm or deg.

    ``constant``: whether the reversal value is added at these points.
    """

    rows: Rows
    weights: FloatArray
    aims: FloatArray
    constant: bool = False


def build_chain(
    wishes: tuple[ChainTarget, ...],
    size: int,
    *,
    fixed: tuple[int, ...],
    kept: tuple[int, ...],
    closed: bool,
) -> CurveChain:
    """Return the objective of a curve with ``size`` table points: half the weighted sum of squared
    differences between this curve and the wanted curves ``wishes``. ``fixed``: points with the
    value zero; ``kept``: points outside the travel that are optimised too; ``closed``: both ends
    have the same value.

    Its coefficients are those of the normal equations of hat functions. These couple only
    neighbouring points (de Boor 1978, chapter III).
    """
    diagonal, off, linear, coupling = (
        np.zeros(size),
        np.zeros(size - 1),
        np.zeros(size),
        np.zeros(size),
    )
    stiffness = pull = 0.0
    for wish in wishes:
        left, lower, upper, weights = wish.rows.left, wish.rows.lower, wish.rows.upper, wish.weights
        for index, share in ((left, lower), (left + 1, upper)):
            diagonal += np.bincount(index, weights * share**2, size)
            linear -= np.bincount(index, weights * share * wish.aims, size)
            if wish.constant:
                coupling += np.bincount(index, weights * share, size)
        off += np.bincount(left, weights * lower * upper, size - 1)
        if wish.constant:
            stiffness += float(np.sum(weights))
            pull -= float(weights @ wish.aims)
    seen = diagonal > _UNSEEN * np.max(diagonal)
    seen[[*fixed, *kept]] = True
    if closed:
        seen[[0, -1]] = True
    points = np.flatnonzero(seen)
    is_fixed = np.isin(points, fixed)
    span = np.diff(points)
    chain = CurveChain(
        size=size,
        kept=points,
        span=span,
        # A kept point that no part of the travel sees pulls at nothing: any small stiffness makes
        # it follow its neighbours' limits.
        diagonal=np.where(
            is_fixed, np.max(diagonal), np.maximum(diagonal[points], _UNSEEN * np.max(diagonal))
        ),
        off=np.where(is_fixed[1:] | is_fixed[:-1] | (span > 1), 0.0, off[points[:-1]]),
        fixed=is_fixed,
        closed=closed,
        optimum=np.where(is_fixed, 0.0, linear[points]),
        constant=pull,
        coupling=np.where(is_fixed, 0.0, coupling[points]),
        stiffness=stiffness,
        least=0.0,
        inverse=diagonal[points],
        share=1.0,
    )
    return _solved(chain, wishes)


def _solved(chain: CurveChain, wishes: tuple[ChainTarget, ...]) -> CurveChain:
    """Return the chain with its optimal values filled in.

    In the given chain, ``optimum`` and ``constant`` contain the linear terms of the objective
    instead.
    """
    linear, pull = chain.optimum, chain.constant
    constant = 0.0
    if chain.stiffness:
        constant = (float(chain.coupling @ chain.solve(linear)) - pull) / chain.left
    optimum = -chain.solve(linear + constant * chain.coupling)
    full = np.zeros(chain.size)
    full[chain.kept] = optimum
    least = 0.0
    for wish in wishes:
        rows = wish.rows
        held = (
            rows.lower * full[rows.left]
            + rows.upper * full[rows.left + 1]
            + (constant if wish.constant else 0.0)
        )
        least += 0.5 * float(wish.weights @ (held - wish.aims) ** 2)
    return replace(
        chain,
        optimum=optimum,
        constant=constant,
        least=least,
        inverse=_inverse_diagonal(chain),
        share=_diagonal_share(chain),
    )


def _inverse_diagonal(chain: CurveChain) -> FloatArray:
    """Return the diagonal of the inverse of the matrix H, without computing the inverse.

    Its elements are 1 / (forward + backward - H_ii). Here forward and backward are the pivots of
    the elimination that begins at the first and at the last row (Meurant, SIAM J. Matrix Anal.
    Appl. 13, 1992).
    """
    forward, backward = chain.diagonal.copy(), chain.diagonal.copy()
    for index, off in enumerate(chain.off):
        forward[index + 1] -= off * off / forward[index]
    for index in range(chain.off.size - 1, -1, -1):
        backward[index] -= chain.off[index] ** 2 / backward[index + 1]
    inverse: FloatArray = 1.0 / (forward + backward - chain.diagonal)
    return inverse


def _diagonal_share(chain: CurveChain) -> float:
    """Return the smallest eigenvalue of H after its diagonal is scaled to 1. It bounds H from below
    by its diagonal.

    The scaled matrix is D^-1/2 H D^-1/2 with D = diag(H). If share is its smallest eigenvalue, H -
    share D has no negative eigenvalue (Horn and Johnson, Matrix Analysis, 2nd ed. 2013, section
    4.2).
    """
    from scipy.linalg import eigvalsh_tridiagonal

    if chain.diagonal.size == 1:
        return 1.0
    scaled = chain.off / np.sqrt(chain.diagonal[1:] * chain.diagonal[:-1])
    least = eigvalsh_tridiagonal(
        np.ones(chain.diagonal.size), scaled, select="i", select_range=(0, 0)
    )[0]
    return max(0.0, float(least) - _SAFE)


# --- limits and lower bounds
# ------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, kw_only=True)
class ChainLimits:
    """The limits of the values of a curve: whole multiples of ``step`` (mm or deg) plus a shift.

    ``increments``: smallest and largest change between neighbouring table points, in steps.
    ``low``, ``high`` (m,): the value range, mm or deg.
    """

    step: float
    increments: tuple[int, int]
    low: FloatArray
    high: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitMultipliers:
    """Lagrange multipliers of the limits of a curve. Any multipliers give a valid lower bound (weak
    duality; Boyd and Vandenberghe 2004, section 5.2.2).

    ``climb`` (m-1,) belongs to the increments, ``bound`` (m,) to the value range. A multiplier is
    positive at an upper limit and negative at a lower limit. ``close`` belongs to the condition
    that the last value equals the first.
    """

    climb: FloatArray
    bound: FloatArray
    close: float = 0.0

    def force(self, chain: CurveChain) -> FloatArray:
        """Return A'y (m,): how the limits' term of the Lagrange function changes with each table
        value. It is 0 at fixed values.
        """
        force = self.bound.copy()
        force[1:] += self.climb
        force[:-1] -= self.climb
        force[0] += self.close
        force[-1] -= self.close
        force[chain.fixed] = 0.0
        return force

    def price(self, chain: CurveChain, limits: ChainLimits) -> float:
        """Return the sum of multiplier times limit, the contribution of the limits to the Lagrange
        function (Boyd and Vandenberghe 2004, section 5.1.1).
        """
        least, largest = limits.increments
        climb = (
            np.where(self.climb > 0.0, self.climb * largest, self.climb * least)
            * chain.span
            * limits.step
        )
        reach = np.where(self.bound > 0.0, limits.high, limits.low)
        return float(np.sum(climb) + self.bound @ np.where(self.bound == 0.0, 0.0, reach))


@dataclass(frozen=True, slots=True, kw_only=True)
class Relaxation:
    """A lower bound of the objective over real table values, as a function of the reversal value c.

    The bound is the dual function (Boyd and Vandenberghe 2004, section 5.1.2). The Lagrange
    function is L(v, c) = f + y'(Av - limits) <= f. Its minimum over v is ``base - tilt (c - c0) +
    curve (c - c0)^2 / 2``, at v = ``centre - (c - c0) follow``. For every v within the limits, f >=
    that minimum + (v - minimum point)'H(v - minimum point)/2.
    """

    base: float
    tilt: float
    curve: float
    centre: FloatArray
    follow: FloatArray

    def bound(self, shift: FloatArray) -> FloatArray:
        """Return the lower bound for reversal values that differ by ``shift`` (n,) from the
        optimum.
        """
        bounds: FloatArray = self.base - self.tilt * shift + 0.5 * self.curve * shift**2
        return bounds

    def centres(self, shift: FloatArray) -> FloatArray:
        """Return the optimal table values (n, m), mm or deg, for reversal values that differ by
        ``shift`` (n,) from the optimum.
        """
        centres: FloatArray = self.centre - shift[:, np.newaxis] * self.follow
        return centres


def closing_multipliers(chain: CurveChain) -> LimitMultipliers:
    """Return Lagrange multipliers that make both ends of a closed curve equal and ignore other
    limits.
    """
    close = 0.0
    if chain.closed:
        ends = np.zeros(chain.diagonal.size)
        ends[0], ends[-1] = 1.0, -1.0
        close = float((chain.optimum[0] - chain.optimum[-1]) / (ends @ chain.solve(ends)))
    return LimitMultipliers(
        climb=np.zeros(chain.span.size), bound=np.zeros(chain.diagonal.size), close=close
    )


def relax(chain: CurveChain, push: LimitMultipliers) -> Relaxation:
    """Return the lower bound for the Lagrange multipliers ``push``, without the constant term of
    the limits (`priced` subtracts it).

    The bound is the minimum of a quadratic Lagrange function (Boyd and Vandenberghe 2004, section
    5.2.4).
    """
    force = push.force(chain)
    moved, follow = chain.solve(force), chain.solve(chain.coupling)
    return Relaxation(
        base=chain.least + float(force @ chain.optimum) - 0.5 * float(force @ moved),
        tilt=float(chain.coupling @ moved),
        curve=chain.left if chain.stiffness else 0.0,
        centre=chain.optimum - moved,
        follow=follow,
    )


def priced(
    relaxation: Relaxation, push: LimitMultipliers, chain: CurveChain, limits: ChainLimits
) -> Relaxation:
    """Return the lower bound with the constant term of the ``limits`` subtracted."""
    return replace(relaxation, base=relaxation.base - push.price(chain, limits))


def limit_multipliers(
    chain: CurveChain, limits: ChainLimits, constant_range: tuple[float, float]
) -> LimitMultipliers:
    """Return nearly optimal multipliers for limits of table values and for the range
    ``constant_range`` of the reversal value, from the solver OSQP (Stellato et al., Mathematical
    Programming Computation 12, 2020). Inexact multipliers still give a valid bound.
    """
    import osqp
    from scipy import sparse

    if not chain.span.size:
        return closing_multipliers(chain)  # one value: its range shows in the windows
    m, scale, step = chain.diagonal.size, float(np.max(chain.diagonal)), limits.step
    has_constant = 1 if chain.stiffness else 0
    upper = [sparse.diags([chain.diagonal, chain.off], [0, 1])]
    P = sparse.csc_matrix(upper[0])
    if has_constant:
        P = sparse.bmat(
            [[P, chain.coupling[:, np.newaxis]], [None, np.array([[chain.stiffness]])]],
            format="csc",
        )
    centre = np.append(chain.optimum, [chain.constant] * has_constant) / step
    whole = P + sparse.triu(P, 1).T
    rows = [
        sparse.diags([-np.ones(m - 1), np.ones(m - 1)], [0, 1], shape=(m - 1, m + has_constant)),
        sparse.eye(m + has_constant),
    ]
    low = [limits.increments[0] * chain.span, np.where(chain.fixed, 0.0, limits.low / step)]
    high = [limits.increments[1] * chain.span, np.where(chain.fixed, 0.0, limits.high / step)]
    if has_constant:
        low.append(np.array([constant_range[0] / step]))
        high.append(np.array([constant_range[1] / step]))
    if chain.closed:
        ends = sparse.csc_matrix(
            (np.array([1.0, -1.0]), (np.array([0, 0]), np.array([0, m - 1]))),
            shape=(1, m + has_constant),
        )
        rows.append(ends)
        low.append(np.zeros(1))
        high.append(np.zeros(1))
    solver: Any = osqp.OSQP()
    solver.setup(
        P / scale,
        -(whole @ centre) / scale,
        sparse.csc_matrix(sparse.vstack(rows)),
        np.concatenate(low),
        np.concatenate(high),
        verbose=False,
        eps_abs=1e-5,
        eps_rel=1e-5,
        max_iter=10_000,
        polishing=True,
    )
    result = solver.solve(raise_error=False)
    y = np.asarray(result.y, dtype=np.float64) * scale * step
    if not np.all(np.isfinite(y)):
        return closing_multipliers(chain)
    bound = y[m - 1 : 2 * m - 1]
    unbounded = ~np.isfinite(np.where(bound > 0.0, limits.high, limits.low))
    return LimitMultipliers(
        climb=y[: m - 1],
        bound=np.where(chain.fixed | unbounded, 0.0, bound),
        close=float(y[-1]) if chain.closed else 0.0,
    )
