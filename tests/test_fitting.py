"""The fit against independent solutions, its limits, its certificate, and the tables that come out. Lengths in mm."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import cvxpy as cp
import numpy as np
import pytest

from compwright.fitting.certify import certificate
from compwright.fitting.fit import fit_table
from compwright.fitting.problem import QuadraticProblem
from compwright.fitting.solve import solve_quadratic
from compwright.foundations.errors import CapacityError
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted import FittedTable, TableRequest

UM = 1e-3
WHERE = np.linspace(0.0, 800.0, 401)

ONE_CURVE = Capacity(
    format="one",
    curves=1,
    spacing="equidistant",
    quantum=1e-6,
    position_quantum=1e-6,
    value_range=(-10.0, 10.0),
    backlash_quantum=1e-6,
    backlash_range=(-10.0, 10.0),
    below="zero",
    above="hold",
)
TWO_CURVES = replace(ONE_CURVE, format="two", curves=2, spacing="free", quantum=1e-7, backlash_quantum=None, below="hold")


def wanted(reversal: FloatArray | float = 5 * UM, reference: float = 0.0, home: Direction = Direction.POSITIVE) -> WantedCorrection:
    """A slope with a bow; ``reversal`` is the correction against the home direction, less the curve, with the sign of that way."""
    curve = -25e-6 * WHERE + 6 * UM * np.sin(WHERE / 110.0 + 0.3)
    curve = curve - np.interp(reference, WHERE, curve)
    other = curve + home.opposite.sign * reversal
    positive, negative = (curve, other) if home is Direction.POSITIVE else (other, curve)
    return WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=WHERE,
        positive=positive,
        negative=negative,
        reference=reference,
        reference_return=home,
        noise=0.5 * UM,
    )


def held(table: AxisCompensation, direction: Direction) -> FloatArray:
    """What the control does at WHERE, written out again: straight lines, ends, backlash against the home direction."""
    curve = table.positive if direction is Direction.POSITIVE else table.negative
    value = np.interp(WHERE, table.positions, curve)
    if table.below == "zero":
        value = np.where(table.positions[0] > WHERE, 0.0, value)
    return value + (0.0 if direction is table.reference_return else direction.sign * table.backlash)


def mean_square(table: AxisCompensation, wish: WantedCorrection) -> float:
    """Mean over the travel (trapezoids) and both directions of (held - wanted)²; mm²."""
    squares = [np.trapezoid((held(table, direction) - wish.total(direction)) ** 2, WHERE) / 800.0 for direction in Direction]
    return float(np.mean(squares))


def fit(wish: WantedCorrection, capacity: Capacity = ONE_CURVE, **request: Any) -> FittedTable:
    return fit_table(wish, capacity, TableRequest(**request), address="X")


def by_another_solver(wish: WantedCorrection, nodes: FloatArray, *, limit: float = 10.0, step: float = 10.0) -> float:
    """The least mean square (mm²) of one curve and a backlash under limits of value and increment, by an interior-point solver."""
    hats = np.array([np.interp(WHERE, nodes, row) for row in np.eye(nodes.size)]).T
    weights = np.full(WHERE.size, 2.0)
    weights[[0, -1]] = 1.0
    root = np.sqrt(weights / weights.sum())
    curve: Any = cp.Variable(nodes.size)  # in µm
    backlash: Any = cp.Variable()
    errors = (hats @ curve - wish.positive / UM, hats @ curve - backlash - wish.negative / UM)
    objective = 0.5 * sum(cp.sum_squares(cp.multiply(root, error)) for error in errors)
    limits = [curve[0] == 0, cp.abs(curve) <= limit / UM, cp.abs(cp.diff(curve)) <= step / UM]
    problem: Any = cp.Problem(cp.Minimize(objective), limits)
    problem.solve(solver=cp.CLARABEL)
    assert problem.status == cp.OPTIMAL
    return float(problem.value) * UM**2


@pytest.mark.parametrize("limits", [{}, {"limit": 9 * UM}, {"step": 0.7 * UM}, {"limit": 8 * UM, "step": 0.9 * UM}])
def test_the_fit_is_as_good_as_another_solver_finds(limits: dict[str, float]) -> None:
    wish = wanted()
    capacity = replace(
        ONE_CURVE,
        value_range=(-limits.get("limit", 10.0), limits.get("limit", 10.0)),
        max_increment=limits.get("step"),
    )
    table = fit(wish, capacity, spacing=40.0).compensation
    least = by_another_solver(wish, table.positions, **limits)
    # The quadrature of the fit and the trapezoids here differ by parts in a thousand; the quantum adds 1e-13 mm².
    assert mean_square(table, wish) <= least * 1.003 + 1e-12
    values = table.positive
    assert np.all(np.abs(values) <= limits.get("limit", 10.0) + 1e-12)
    assert np.all(np.abs(np.diff(values)) <= limits.get("step", 10.0) + 1e-12)


def test_one_curve_and_backlash_recover_a_constant_reversal() -> None:
    for home in Direction:
        table = fit(wanted(home=home), spacing=20.0).compensation
        assert table.backlash == pytest.approx(5 * UM, abs=0.02 * UM)  # the straight lines between nodes miss the bow by that
        assert table.reference_return is home


def test_a_varying_reversal_needs_two_curves() -> None:
    varying = 5 * UM + 4 * UM * np.cos(WHERE / 90.0)
    wish = replace(wanted(varying), reversal_log_odds=30.0)
    two, one = fit(wish, TWO_CURVES), fit(wish, ONE_CURVE)
    assert (two.mode, one.mode) == ("bidirectional", "single")
    assert np.sqrt(mean_square(two.compensation, wish)) < 0.1 * UM
    # What one curve must leave: half of the varying part in each direction, 4 / (2 √2) µm rms.
    assert np.sqrt(mean_square(one.compensation, wish)) == pytest.approx(np.std(varying) / 2, rel=0.05)
    assert {limit.cause for limit in one.limits} >= {"one table for both directions"}
    with pytest.raises(CapacityError, match="one table for both directions"):
        fit(wish, ONE_CURVE, mode="bidirectional")


def test_without_strong_evidence_two_curves_differ_by_a_constant() -> None:
    wish = replace(wanted(5 * UM + 0.2 * UM * np.cos(WHERE / 90.0)), reversal_log_odds=0.5)
    table = fit(wish, TWO_CURVES)
    assert table.mode == "single"
    difference = table.compensation.negative - table.compensation.positive
    assert np.ptp(difference) <= 1.01e-7  # one quantum
    assert fit(wish, TWO_CURVES, mode="bidirectional").mode == "bidirectional"


@pytest.mark.parametrize("reference", [0.0, 400.0, 137.0, 800.0])
@pytest.mark.parametrize("home", list(Direction))
def test_the_correction_is_zero_in_the_zero_state(reference: float, home: Direction) -> None:
    for capacity in (ONE_CURVE, TWO_CURVES):
        table = fit(wanted(reference=reference, home=home), capacity).compensation
        curve = table.curve(home)
        # Half a quantum where the reference lies between two nodes, each rounded; exact at a node.
        assert abs(np.interp(reference, table.positions, curve)) <= 0.51 * capacity.quantum


def test_a_reference_outside_the_table_is_zero_where_the_control_holds_the_end_value() -> None:
    wish = replace(wanted(), reference=900.0)
    table = fit(wish)
    assert table.compensation.positive[-1] == 0.0
    assert "CW-F03" in {finding.code for finding in table.findings}


def test_rounding_moves_no_value_by_more_than_half_a_quantum() -> None:
    for quantum in (1e-3, 1e-4, 1e-6):
        table = fit(wanted(), replace(ONE_CURVE, quantum=quantum), spacing=20.0)
        assert table.certificate["rounding"] <= 0.5 * quantum + 1e-12
        counts = table.compensation.positive / quantum
        assert np.allclose(counts, np.round(counts), atol=1e-6)


def test_steps_that_the_control_cannot_hold_are_refused_with_what_would_fit() -> None:
    for spacing, says in ((33.33333333, "multiple of 1e-06"), (27.0, "not a whole number")):
        with pytest.raises(CapacityError, match=says) as caught:
            fit(wanted(), spacing=spacing)
        near = caught.value.faults[0].expected
        below, above = (float(word) for word in near.split(" mm")[0].split(" or "))
        assert below < spacing < above
        for step in (below, above):
            assert 800.0 / step == pytest.approx(round(800.0 / step), abs=1e-9)
            fit(wanted(), spacing=step)


def test_points_are_limited() -> None:
    few = replace(ONE_CURVE, max_points=21)
    with pytest.raises(CapacityError, match="at most 21 points"):
        fit(wanted(), few, spacing=20.0)
    assert fit(wanted(), few, spacing=40.0).compensation.positions.size == 21
    poor = fit(wanted(), replace(ONE_CURVE, max_points=4))
    assert poor.compensation.positions.size <= 4
    assert {limit.cause for limit in poor.limits} >= {"number of points"}


def test_the_automatic_grid_loses_less_than_a_tenth_of_the_noise() -> None:
    wish = wanted()
    for capacity in (ONE_CURVE, TWO_CURVES):
        table = fit(wish, capacity).compensation
        assert table.positions[0] <= 0.0
        assert table.positions[-1] >= 800.0
        assert np.sqrt(mean_square(table, wish)) <= 0.1 * wish.noise


def test_a_period_is_held_only_by_a_grid_that_can() -> None:
    ripple = 2 * UM * np.sin(2 * np.pi * WHERE / 20.0)
    wish = replace(wanted(), positive=wanted().positive + ripple, negative=wanted().negative + ripple, periods=(20.0,))
    fine = fit(wish, spacing=5.0)
    assert np.sqrt(mean_square(fine.compensation, wish)) < 0.3 * 2 * UM / np.sqrt(2)
    coarse = fit(wish, spacing=20.0)
    assert "CW-F02" in {finding.code for finding in coarse.findings}
    # The ripple left out, the coarse table follows the smooth curve: sampled at one phase it would be off by up to 2 µm.
    assert np.sqrt(mean_square(coarse.compensation, wanted())) < 0.15 * UM


@pytest.mark.parametrize("goal", ["E", "A", "M"])
def test_a_goal_of_range_is_better_in_its_own_measure(goal: Any) -> None:
    wish = wanted(5 * UM + 3 * UM * np.cos(WHERE / 90.0))

    def left(table: AxisCompensation) -> float:
        both = [held(table, direction) - wish.total(direction) for direction in Direction]
        return float(np.ptp(np.mean(both, axis=0) if goal == "M" else np.concatenate(both)))

    asked = fit(wish, goal=goal, spacing=100.0)
    assert left(asked.compensation) < 0.98 * left(fit(wish, spacing=100.0).compensation)
    assert asked.certificate["gap"] <= 1e-6


def problem_of(rng: np.random.Generator) -> QuadraticProblem:
    root = rng.standard_normal((12, 12))
    rows = rng.standard_normal((20, 12))
    lower = -np.abs(rng.standard_normal(20)) * 0.05
    return QuadraticProblem(
        P=root @ root.T + 0.1 * np.eye(12),
        q=rng.standard_normal(12),
        constant=0.0,
        A=rows,
        lower=np.where(rng.random(20) < 0.2, -np.inf, lower),
        upper=np.abs(rng.standard_normal(20)) * 0.05,
        groups={},
    )


def test_random_problems_pass_the_certificate_and_wrong_answers_do_not() -> None:
    rng = np.random.default_rng(5)
    for _ in range(40):
        problem = problem_of(rng)
        solution = solve_quadratic(problem)
        assert max(solution.certificate.values()) <= 1e-9
        moved = certificate(problem, solution.x + 1e-3, solution.y)
        assert max(moved.values()) > 1e-5
        turned = certificate(problem, solution.x, -solution.y)
        if np.any(solution.y != 0.0):
            assert max(turned.values()) > 1e-7


def test_an_unfinished_solver_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    import osqp

    real = osqp.OSQP.solve

    def cut_off(self: Any, **words: Any) -> Any:
        result = real(self, **words)
        return SimpleNamespace(info=SimpleNamespace(status="maximum iterations reached"), y=result.y, x=result.x)

    monkeypatch.setattr(osqp.OSQP, "solve", cut_off)
    with pytest.raises(CapacityError, match="no certified solution"):
        fit(wanted(), replace(ONE_CURVE, value_range=(-8 * UM, 8 * UM)), spacing=40.0)
