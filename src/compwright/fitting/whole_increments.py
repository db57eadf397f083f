"""Fit of the best table for a control that stores whole increments, with the error that rounding
adds and the reason for the chosen magnification (dynamic programming: Bellman, 1957).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np

from compwright.fitting.certify import lattice_certificate, rounded_proof
from compwright.fitting.chain import (
    ChainTarget,
    CurveChain,
    build_chain,
    closing_multipliers,
    relax,
)
from compwright.fitting.datum import zero_in_the_zero_state
from compwright.fitting.lattice import LatticeSolution, best_totals, relaxed_bound
from compwright.fitting.lattice_part import LatticePart
from compwright.fitting.problem import Rows, Shape, quadrature, rows_at
from compwright.fitting.table_findings import (
    added_rms,
    display_unit,
    edge_findings,
    loss_findings,
    reportable_costs,
)
from compwright.fitting.unresolved_periods import HeldGrid
from compwright.foundations.errors import CapacityError, Fault
from compwright.foundations.findings import Finding
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, Goal, Limit
from compwright.words.sentences import Amount, say

_HAIR: Final = 1e-6
#: Less than this (µm or arcsec) is arithmetic.
_NOTHING: Final = 1e-6
_ANY: Final = (-(10**9), 10**9)
#: The finding that a goal is not followed.
GOAL_LEFT: Final = "CW-F010"


@dataclass(frozen=True, slots=True, kw_only=True)
class WholeIncrementFit:
    """The data of a fit of whole increments: the wanted correction ``aim``, table points
    ``points``.

    ``aim``: totals, zero in the zero state, mm or deg. ``samples``, ``weights`` (q,): points and
    weights of the mean over the travel. ``rows``: the control's interpolation at ``samples``.
    """

    aim: WantedCorrection
    points: FloatArray
    shape: Shape
    capacity: Capacity
    lattice: Lattice
    samples: FloatArray
    weights: FloatArray
    rows: Rows

    @property
    def anchor(self) -> int:
        """The index of the table point at the reference."""
        return int(np.argmin(np.abs(self.points - self.aim.reference)))

    @property
    def fixed(self) -> tuple[int, ...]:
        """Indices of table points where the curve of the reference-return direction is zero."""
        return (self.anchor,) if self.capacity.period is None else (0, self.points.size - 1)

    def wish(self, direction: Direction, *, constant: bool = False) -> ChainTarget:
        """Return the wanted correction in one direction at the sample points. ``constant``: the fit
        adds a constant in this direction.
        """
        aims = np.interp(self.samples, self.aim.positions, self.aim.total(direction))
        return ChainTarget(rows=self.rows, weights=self.weights, aims=aims, constant=constant)

    def single(self, *, reversal: bool) -> CurveChain:
        """Return one curve for both directions. With ``reversal``, a constant is added to the curve
        in the direction opposite to the reference return.
        """
        home = self.aim.reference_return
        wishes = (self.wish(home), self.wish(home.opposite, constant=reversal))
        return build_chain(wishes, self.points.size, fixed=self.fixed, kept=(), closed=False)

    def home_curve(self) -> CurveChain:
        """Return the curve of the reference-return direction alone."""
        return build_chain(
            (self.wish(self.aim.reference_return),),
            self.points.size,
            fixed=self.fixed,
            kept=(),
            closed=False,
        )

    def other_curve(self, *, free: bool) -> CurveChain:
        """Return the curve of the direction opposite to the reference return. Its value at the
        reference is zero unless ``free``.
        """
        wishes = (self.wish(self.aim.reference_return.opposite),)
        endless = self.capacity.period is not None
        if not free:
            return build_chain(wishes, self.points.size, fixed=self.fixed, kept=(), closed=False)
        return build_chain(wishes, self.points.size, fixed=(), kept=(self.anchor,), closed=endless)

    def parts(self) -> tuple[LatticePart, ...]:
        """Return the one or two curves of the table with the control's limits."""
        if self.shape == "single":
            constant = self._constant()
            return (
                replace(self._part(self.single(reversal=constant is not None)), constant=constant),
            )
        other = self._part(self.other_curve(free=self.lattice.offset_range is not None))
        return (
            self._part(self.home_curve()),
            replace(
                other, offsets=self.lattice.offset_range, magnified=self.lattice.offset_magnified
            ),
        )

    def _part(self, chain: CurveChain) -> LatticePart:
        low, high = self.capacity.value_range
        return LatticePart(
            chain=chain, low=low, high=high, anchor=int(np.searchsorted(chain.kept, self.anchor))
        )

    def _constant(self) -> tuple[float, int, int] | None:
        quantum = self.capacity.backlash_quantum
        if quantum is None:
            return None
        low, high = self.capacity.backlash_range
        sign = self.aim.reference_return.opposite.sign
        return (
            sign * quantum,
            int(np.ceil(low / quantum - _HAIR)),
            int(np.floor(high / quantum + _HAIR)),
        )

    def free_bounds(self) -> dict[str, float]:
        """Return the mean square (mm² or deg²) of each possible kind of table, without limits and
        with real-number values.
        """
        two = replace(self, aim=zero_in_the_zero_state(self.aim, self.points, self.capacity)[0])
        free = _free(two.home_curve()) + _free(two.other_curve(free=True))
        with_constant = _free(self.single(reversal=True))
        own = free
        if self.shape == "single":
            own = (
                with_constant
                if self.capacity.backlash_quantum is not None
                else _free(self.single(reversal=False))
            )
        elif self.lattice.offset_range is None:
            own = _free(self.home_curve()) + _free(self.other_curve(free=False))
        return {"two tables": free, "one table": with_constant, "own": own}


def _free(chain: CurveChain) -> float:
    return relax(chain, closing_multipliers(chain)).base


def fit_whole_increments(
    grid: HeldGrid,
    aim: WantedCorrection,
    shape: Shape,
    capacity: Capacity,
    lattice: Lattice,
    *,
    address: str,
) -> tuple[AxisCompensation, dict[str, float], tuple[Limit, ...], tuple[Finding, ...]]:
    """Return the best table of whole increments for the correction ``aim``, with its certificate,
    the error that each limit adds, and the finding about the magnification.

    ``aim``: wanted totals, zero in the zero state, mm or deg. ``shape``: one curve, or one for each
    direction. The certificate consists of the numbers that prove that the table is optimal. The
    errors are rms, mm or deg. The table is the exact optimum of the mean square over the travel and
    both directions. Raises CapacityError if the limits allow no table at all.
    """
    samples, weights = quadrature(aim.positions, grid.points, capacity.interpolation)
    rows = rows_at(
        samples,
        grid.points,
        below=capacity.below,
        above=capacity.above,
        interpolation=capacity.interpolation,
    )
    fit = WholeIncrementFit(
        aim=aim,
        points=grid.points,
        shape=shape,
        capacity=capacity,
        lattice=lattice,
        samples=samples,
        weights=weights,
        rows=rows,
    )
    parts = fit.parts()
    solution = best_totals(
        parts,
        unit=lattice.unit,
        increments=lattice.increments,
        magnifications=lattice.magnifications,
    )
    if solution is None:
        raise CapacityError(
            Fault(
                message="no table stays within the increment limits of the control",
                place="table",
                expected="increment limits with 0 between them",
                found=f"{lattice.increments[0]} to {lattice.increments[1]}",
                hint="correct the option `increment_limit` of the control",
            )
        )
    table = _table(fit, parts, solution, address)
    proof = lattice_certificate(
        table, aim, capacity, solution.magnification, (solution.objective, solution.bound)
    )
    return (
        table,
        proof,
        _limits(fit, parts, solution, grid),
        _magnification_finding(solution, lattice, aim),
    )


def _table(
    fit: WholeIncrementFit, parts: tuple[LatticePart, ...], solution: LatticeSolution, address: str
) -> AxisCompensation:
    step = solution.magnification * fit.lattice.unit
    curves = [
        part.chain.expanded(found.totals).astype(np.float64) * step + found.shift + 0.0
        for part, found in zip(parts, solution.parts, strict=True)
    ]
    own, other = curves[0], curves[-1]
    home = fit.aim.reference_return
    quantum = fit.capacity.backlash_quantum
    positive, negative = (own, other) if home is Direction.POSITIVE else (other, own)
    return AxisCompensation(
        address=address,
        kind=fit.aim.kind,
        positions=fit.points,
        positive=positive,
        negative=negative,
        backlash=(
            solution.parts[0].count * quantum + 0.0
            if fit.shape == "single" and quantum is not None
            else 0.0
        ),
        reference_return=home,
        below=fit.capacity.below,
        above=fit.capacity.above,
        interpolation=fit.capacity.interpolation,
        period=fit.capacity.period,
    )


def _limits(
    fit: WholeIncrementFit,
    parts: tuple[LatticePart, ...],
    solution: LatticeSolution,
    grid: HeldGrid,
) -> tuple[Limit, ...]:
    """Return the cost of each limit of the control: the root of the difference between the mean
    squares with and without this limit.
    """
    unit, magnification = fit.lattice.unit, solution.magnification
    free = {name: float(np.sqrt(max(0.0, value))) for name, value in fit.free_bounds().items()}
    bound, reached = np.sqrt(max(0.0, solution.bound)), np.sqrt(solution.objective)
    costs = [
        ("spacing too wide for the period", grid.left_out),
        ("number of points" if grid.points_loss else "spacing of the points", free["two tables"]),
    ]
    if fit.shape == "single":
        costs.append(
            ("one table for both directions", added_rms(free["one table"], free["two tables"]))
        )
        costs.append(("no backlash value", added_rms(free["own"], free["one table"])))
    if bound > free["own"] * (1.0 + _HAIR):
        ranged = np.sqrt(
            max(0.0, relaxed_bound(parts, unit=unit, increments=_ANY, magnification=magnification))
        )
        costs.append(("value range", added_rms(ranged, free["own"])))
        costs.append(("largest increment", added_rms(bound, ranged)))
    costs.append(("quantum", added_rms(reached, bound)))
    return reportable_costs(costs, unit * magnification)


def _magnification_finding(
    solution: LatticeSolution, lattice: Lattice, aim: WantedCorrection
) -> tuple[Finding, ...]:
    if len(lattice.magnifications) < 2:
        return ()
    factor, unit = display_unit(aim.kind)
    chosen, least, largest = solution.magnification, *lattice.increments
    left = float(np.sqrt(solution.objective)) * factor
    span = say("increments", least=least, largest=largest, symmetric=least == -largest)
    rest = Amount(left, unit, "2sig") if left > _NOTHING else None
    if solution.before is None:
        return (
            Finding.of(
                "CW-F009.smallest",
                "info",
                magnification=chosen,
                increments=span,
                step=Amount(lattice.unit * factor, unit, ".4g"),
                left=rest,
            ),
        )
    before, bound = solution.before
    return (
        Finding.of(
            "CW-F009.compared",
            "info",
            magnification=chosen,
            before=before,
            increments=span,
            step=Amount(before * lattice.unit * factor, unit, ".4g"),
            at_least=Amount(float(np.sqrt(max(0.0, bound))) * factor, unit, "2sig"),
            left=rest,
        ),
    )


def goal_finding(goal: Goal, why: Literal["slope", "increments", "no_gain"]) -> tuple[Finding, ...]:
    """Return the finding that the fit minimised the mean square instead of the parameter ``goal``,
    such as A or E, for the reason ``why``; an empty tuple if the job has no such goal.

    The reasons are: ``slope``, the control has only one slope; ``increments``, the control has
    whole increments; ``no_gain``, nothing is gained after rounding.
    """
    if goal == "expected":
        return ()
    return (Finding.of("CW-F010", "info", goal=goal, why=why),)


def whole_increment_table(
    grid: HeldGrid,
    aim: WantedCorrection,
    mode: tuple[Shape, str],
    capacity: Capacity,
    lattice: Lattice,
    *,
    address: str,
) -> FittedTable:
    """Return the fitted table of whole increments with all its findings. ``mode``: the kind of
    table, and the reason for it.
    """
    table, proof, limits, findings = fit_whole_increments(
        grid, aim, mode[0], capacity, lattice, address=address
    )
    return FittedTable(
        compensation=table,
        mode=mode[0],
        mode_reason=mode[1],
        certificate=rounded_proof(proof),
        limits=limits,
        findings=(
            *grid.findings,
            *findings,
            *edge_findings(table, aim, kept=grid.kept),
            *loss_findings(limits, aim),
        ),
        keeps_grid=grid.kept,
    )
