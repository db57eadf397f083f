"""Fit of the table of one axis: its points, the best values within the control's limits, their
rounding, and the rms error that each limit costs.

The fit minimises the expected squared deviation. Under a square loss, the best answer is the mean
of the distribution of the wanted correction (Rasmussen and Williams, Gaussian Processes for Machine
Learning, 2006, section 2.4). The least mean square is found by a quadratic program, the least range
by a linear program (Boyd and Vandenberghe, Convex Optimization, 2004, sections 4.4 and 6.1.1).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np

from compwright.fitting.certify import rounded_proof
from compwright.fitting.datum import with_datum
from compwright.fitting.endless_axis import over_one_period
from compwright.fitting.goals import Range, as_wanted, mean_over, optimise_goal
from compwright.fitting.grid import choose_grid
from compwright.fitting.grid_losses import NOISE_SHARE
from compwright.fitting.problem import (
    BOTH,
    QuadraticProblem,
    SampledCorrection,
    Shape,
    UnknownsLayout,
    build_problem,
    limited_range,
    sample_correction,
)
from compwright.fitting.rounding import round_curve, to_quanta
from compwright.fitting.solve import solve_quadratic
from compwright.fitting.straight_line import fit_line
from compwright.fitting.table_findings import (
    added_rms,
    edge_findings,
    loss_findings,
    reportable_costs,
)
from compwright.fitting.unresolved_periods import HeldGrid
from compwright.fitting.whole_increments import goal_finding, whole_increment_table
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, Goal, Limit, TableRequest
from compwright.words.sentences import Amount, Sentence, SentenceText, say

#: Natural logarithm of the evidence from which on two tables are worth it ("strong": 20 to 1; Kass
#: and Raftery, J. Am. Stat. Assoc. 90, 1995, section 3.2).
STRONG: Final = 3.0


def fit_table(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    *,
    address: str,
    costs: bool = True,
) -> FittedTable:
    """Return the best table for ``wanted`` (totals, mm or deg) within the control's limits and the
    job's ``request``. With ``costs``, the table states what each limit costs.

    Goal ``expected`` is the least mean square of table minus wanted correction over the travel and
    both directions. This is the expected squared deviation plus a constant that no table changes
    (Rasmussen and Williams 2006, section 2.4). Goals ``A``, ``E``, ``M`` are the least mean of that
    parameter over the tests in ``wanted.scenarios`` (ISO 230-2:1997, 2.20, 2.21, 2.23). Without
    scenarios they are the least range of the wanted correction.

    The correction is zero in the zero state. A single slope is always fitted with goal
    ``expected``. Whole increments are fitted with goal ``expected`` if rounding cancels the gain of
    the job's goal. In both cases a finding reports it. Raises CapacityError if the control cannot
    hold the requested table or no certified solution was found.
    """
    _refuse(capacity, request)
    if capacity.line is not None:
        line = fit_line(wanted, capacity, request, capacity.line, address=address)
        return replace(
            line,
            findings=(
                *line.findings,
                *goal_finding(request.goal, "slope"),
            ),
        )
    if capacity.zero is not None:
        wanted = replace(wanted, reference_return=capacity.zero)
    if capacity.period is not None:
        wanted = over_one_period(wanted, capacity.period)
    shape, why = _shape(wanted, capacity, request)
    reason = SentenceText(why)
    grid = choose_grid(wanted, capacity, request)
    layout = _layout(grid.points, shape, capacity, wanted.reference_return)
    aim, datum_findings = with_datum(grid.wanted, layout, capacity)
    if capacity.lattice is not None:
        fitted = whole_increment_table(
            grid, aim, (shape, reason), capacity, capacity.lattice, address=address
        )
        if request.goal != "expected":
            fitted = _whole_goal(request.goal, fitted, wanted, grid, layout, capacity, aim)
        return replace(fitted, findings=(*datum_findings, *fitted.findings))
    fit = _Fit(sample_correction(aim, grid.points, capacity), layout, capacity, aim)
    usual = fit.expected()
    best = fit.best(request.goal, wanted if wanted.scenarios else aim, usual)
    table = _rounded(best.x, fit, address, aim)
    limits = _limits(fit, usual, best, table, grid) if costs else ()
    edges, losses = edge_findings(table, wanted, kept=grid.kept), loss_findings(limits, wanted)
    findings = (*grid.findings, *datum_findings, *edges, *losses)
    worst = _rounding_error(table, best.x, layout)
    return FittedTable(
        compensation=table,
        mode=shape,
        mode_reason=reason,
        certificate=rounded_proof({**best.certificate, "rounding": worst}),
        limits=limits,
        findings=findings,
        keeps_grid=grid.kept,
    )


def _refuse(capacity: Capacity, request: TableRequest) -> None:
    faults = []
    if request.mode == "bidirectional" and capacity.curves == 1:
        faults.append(
            Fault(
                message=f"{capacity.format} has one table for both directions of this axis",
                place="table.mode",
                expected="`mode: single` or `mode: auto`",
                found="`mode: bidirectional`",
                hint="set `table: {mode: single}`, or leave `mode` out",
            )
        )
    low, high = limited_range(capacity)
    if not low <= 0.0 <= high:
        faults.append(
            Fault(
                message=(
                    "the correction is zero at the reference position, and the control cannot "
                    "store zero"
                ),
                place="value range",
                expected="a range that contains 0",
                found=f"{capacity.value_range[0]:g} to {capacity.value_range[1]:g}",
                hint=f"correct the `range` of the table values in the definition {capacity.format}",
            )
        )
    if faults:
        raise CapacityError(*faults)


def _shape(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest
) -> tuple[Shape, Sentence]:
    odds = wanted.reversal_log_odds
    if request.mode == "bidirectional":
        return "bidirectional", say("mode.two_asked")
    if request.mode == "single":
        return "single", say("mode.one_asked")
    if capacity.curves == 1:
        return "single", say("mode.one_held")
    if capacity.second_curve == "asked":
        return "single", say("mode.one_unless_asked")
    if odds > STRONG:
        return "bidirectional", say("mode.two_vary", odds=odds, strong=STRONG)
    # What is wanted of the reversal is what the control did already plus what the test says. Both
    # may vary: the table of an earlier visit, or a variation that the evidence favours without
    # being strong.
    cost = 0.5 * float(np.std(wanted.positive - wanted.negative))
    if cost > max(capacity.quantum, NOISE_SHARE * wanted.noise):
        factor, small = (1e3, "µm") if wanted.kind.unit == "mm" else (3600.0, "arcsec")
        return "bidirectional", say("mode.two_cost", cost=Amount(cost * factor, small, "2sig"))
    return "single", say("mode.one_constant", odds=odds, strong=STRONG)


def _layout(
    points: FloatArray, shape: Shape, capacity: Capacity, home: Direction
) -> UnknownsLayout:
    if capacity.curves == 2 and (shape == "bidirectional" or capacity.second_curve == "chosen"):
        return UnknownsLayout(points=points, shape=shape, reversal="free", home=home)
    if capacity.backlash_quantum is None:
        return UnknownsLayout(points=points, shape=shape, reversal="none", home=home)
    return UnknownsLayout(points=points, shape=shape, reversal="backlash", home=home)


def _whole_goal(
    goal: Range,
    usual: FittedTable,
    wanted: WantedCorrection,
    grid: HeldGrid,
    layout: UnknownsLayout,
    capacity: Capacity,
    aim: WantedCorrection,
) -> FittedTable:
    """Return the table of whole increments that is closest to the best table for the ``goal``.

    ``wanted``: the wanted correction. ``aim``: the part of it that the points of ``grid`` can
    follow, zero in the zero state. The table ``usual`` has the least mean square. It is returned if
    simulated tests show no gain.
    """
    scenarios = wanted.scenarios
    if scenarios is None or capacity.lattice is None:
        return replace(
            usual,
            findings=(
                *usual.findings,
                *goal_finding(goal, "increments"),
            ),
        )
    free = replace(capacity, lattice=None)
    fit = _Fit(sample_correction(aim, grid.points, free), layout, free, aim)
    wish = as_wanted(fit.best(goal, wanted, fit.expected()).x, layout, free, aim)
    mode = (usual.mode, usual.mode_reason)
    address = usual.compensation.address
    whole = whole_increment_table(grid, wish, mode, capacity, capacity.lattice, address=address)
    with_it, without = (
        mean_over(goal, one.compensation, wanted, scenarios) for one in (whole, usual)
    )
    if with_it < without:
        return replace(usual, compensation=whole.compensation, certificate=whole.certificate)
    finding = goal_finding(goal, "no_gain")
    return replace(usual, findings=(*usual.findings, *finding))


@dataclass(frozen=True, slots=True)
class _Best:
    """The best table values before rounding, and the numbers that prove that they are optimal
    (certificate). ``free``: the values reach no limit of the control.
    """

    x: FloatArray
    certificate: dict[str, float]
    free: bool = False


@dataclass(frozen=True, slots=True)
class _Fit:
    """The data of one fit: sampled wanted correction, order of the unknowns, and limits."""

    data: SampledCorrection
    layout: UnknownsLayout
    capacity: Capacity
    aim: WantedCorrection

    def problem(self, without: tuple[str, ...] = ()) -> QuadraticProblem:
        return build_problem(
            self.data, self.layout, self.capacity, self.aim.reference, without=without
        )

    def expected(self, without: tuple[str, ...] = ()) -> _Best:
        problem = self.problem(without)
        solution = solve_quadratic(problem)
        pushed = np.any(solution.y[problem.lower < problem.upper] != 0.0)
        return _Best(solution.x, solution.certificate, free=not pushed)

    def best(self, goal: Goal, wanted: WantedCorrection, usual: _Best) -> _Best:
        """Return the best table values for the ``goal``, before rounding. ``usual``: the values of
        least mean square.

        ``wanted``: the wanted correction, including short periods that the table points cannot
        follow.
        """
        if goal == "expected":
            return usual
        x, proof = optimise_goal(goal, wanted, self.layout, self.capacity, self.problem(), usual.x)
        return _Best(x, proof)

    def rms(self, x: FloatArray) -> float:
        return float(np.sqrt(self.data.mean_square(self.layout, x)))

    def unlimited(
        self, *, shape: Shape | None = None, reversal: Literal["free"] | None = None
    ) -> float:
        """Return the rms error (mm or deg) that the best table without limits leaves. ``shape``,
        ``reversal``: kind of the table and of its reversal value, if other than in this fit.
        """
        layout = replace(
            self.layout, shape=shape or self.layout.shape, reversal=reversal or self.layout.reversal
        )
        aim, _ = with_datum(self.aim, layout, self.capacity)
        data = sample_correction(aim, layout.points, self.capacity)
        other = replace(self, data=data, layout=layout, aim=aim)
        return other.rms(other.expected(_BOUNDS).x)


_BOUNDS: Final = ("value range", "backlash range")


def _rounded(x: FloatArray, fit: _Fit, address: str, wanted: WantedCorrection) -> AxisCompensation:
    layout, capacity = fit.layout, fit.capacity
    k, home = layout.points.size, layout.home
    low, high = limited_range(capacity)
    if capacity.period is not None:  # equal but for dust: so that both are rounded the same way
        x = x.copy()
        for start in range(0, k + 1, k) if layout.shape == "bidirectional" else (0,):
            x[start + k - 1] = x[start]
    backlash = constant = 0.0
    if layout.shape == "single" and layout.reversal == "free":
        constant = float(to_quanta(x[k:], capacity.quantum)[0]) * capacity.quantum
    elif (
        layout.shape == "single"
        and layout.reversal == "backlash"
        and capacity.backlash_quantum is not None
    ):
        value = home.opposite.sign * x[k:]
        backlash = float(
            round_curve(value, capacity.backlash_quantum, value_range=capacity.backlash_range)[0]
        )
    # Both curves keep the range: the constant between them narrows it.
    narrowed = (max(low, low - constant), min(high, high - constant))
    own = round_curve(x[:k], capacity.quantum, value_range=narrowed)
    other = own + constant
    if layout.shape == "bidirectional":
        other = round_curve(x[k:], capacity.quantum, value_range=(low, high))
    elif constant:
        other = to_quanta(other, capacity.quantum) * capacity.quantum
    positive, negative = (own, other) if home is Direction.POSITIVE else (other, own)
    return AxisCompensation(
        address=address,
        kind=wanted.kind,
        positions=layout.points,
        positive=positive,
        negative=negative,
        backlash=backlash,
        reference_return=home,
        below=capacity.below,
        above=capacity.above,
        interpolation=capacity.interpolation,
        period=capacity.period,
    )


def _as_unknowns(table: AxisCompensation, layout: UnknownsLayout) -> FloatArray:
    """Return the rounded table values in the order of the unknowns."""
    own, other = table.curve(layout.home), table.curve(layout.home.opposite)
    if layout.shape == "bidirectional":
        return np.concatenate([own, other])
    if layout.reversal == "none":
        return own
    constant = (
        other[0] - own[0] if layout.reversal == "free" else table.backlash_at(layout.home.opposite)
    )
    return np.append(own, constant)


def _limits(
    fit: _Fit, usual: _Best, best: _Best, table: AxisCompensation, grid: HeldGrid
) -> tuple[Limit, ...]:
    """Return the rms error (mm or deg) that each limit of the control adds over the travel, as
    computed from ``usual``, the table of least mean square.

    Each rms error is the root of the difference of two mean squares, with and without the limit.
    The errors therefore add as squares.
    """
    capacity, layout = fit.capacity, fit.layout
    costs: list[tuple[str, float]] = [("spacing too wide for the period", grid.left_out)]
    held = fit.rms(usual.x)
    this_shape = held if usual.free else fit.unlimited()
    two_tables = layout.shape == "bidirectional"
    all_shapes = this_shape if two_tables else fit.unlimited(shape="bidirectional")
    costs.append(("number of points" if grid.points_loss else "spacing of the points", all_shapes))
    if layout.shape == "single" and layout.reversal != "free":
        with_constant = fit.unlimited(reversal="free")
        costs.append(("one table for both directions", added_rms(with_constant, all_shapes)))
        costs.append(("no backlash value", added_rms(this_shape, with_constant)))
    if capacity.zero is not None and not usual.free:
        any_reversal = fit.rms(fit.expected(("backlash range",)).x)
        costs.append(("backlash range", added_rms(held, any_reversal)))
        held = any_reversal
    costs.append(("value range", added_rms(held, this_shape)))
    shift = _as_unknowns(table, layout) - best.x
    zero = replace(
        fit.data, wanted={direction: np.zeros_like(fit.data.samples) for direction in BOTH}
    )
    costs.append(("quantum", float(np.sqrt(zero.mean_square(layout, shift)))))
    return reportable_costs(costs, capacity.quantum)


def _rounding_error(table: AxisCompensation, x: FloatArray, layout: UnknownsLayout) -> float:
    """Return the largest change of a table value (not of the backlash) by rounding, mm or deg."""
    k = layout.points.size
    values = 2 * k if layout.shape == "bidirectional" else k
    return float(np.max(np.abs(_as_unknowns(table, layout)[:values] - x[:values])))
