"""The fitted table against brute force, optimality conditions and the limits of a control."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from compwright.fitting import solve
from compwright.fitting.certify import certificate, range_gap
from compwright.fitting.fit import fit_table
from compwright.fitting.period_removal import without_periods
from compwright.fitting.problem import QuadraticProblem, hat_matrix, quadrature
from compwright.fitting.rounding import round_curve
from compwright.fitting.solve import solve_quadratic
from compwright.fitting.sparse_matrices import from_dense, identity
from compwright.foundations.errors import CapacityError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest

Array = NDArray[np.float64]
UM = 1e-3
X = np.linspace(-800.0, 0.0, 401)
POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE

FINE = Capacity(  # a quantum of 0.1 nm: nothing of the control shows
    format="fine",
    curves=1,
    spacing="equidistant",
    quantum=1e-7,
    position_quantum=1e-3,
    value_range=(-10.0, 10.0),
    backlash_quantum=1e-7,
    backlash_range=(-1.0, 1.0),
)
COARSE = replace(FINE, format="coarse", quantum=1 * UM, backlash_quantum=1 * UM, max_points=128)
TWO_CURVES = replace(FINE, curves=2, backlash_quantum=None)


def wavy(x: Array) -> Array:
    return 10 * UM * np.sin(x / 120.0) + 3e-5 * x


def wish(positive: Array, negative: Array, **more: Any) -> WantedCorrection:
    values: dict[str, Any] = {
        "reference": 0.0,
        "reference_return": POSITIVE,
        "noise": 1 * UM,
        "positions": X,
        **more,
    }
    return WantedCorrection(kind=AxisKind.LINEAR, positive=positive, negative=negative, **values)


SMOOTH = wish(wavy(X), wavy(X) + 4 * UM)
VARYING = wish(wavy(X), wavy(X) + 4 * UM + 8e-6 * X, reversal_log_odds=9.0)


def fit(wanted: WantedCorrection, capacity: Capacity, **request: Any) -> FittedTable:
    return fit_table(wanted, capacity, TableRequest(**request), address="1")


def held(table: AxisCompensation, where: Array, direction: Direction) -> Array:
    """What the control does, written out once more: straight between nodes, ends by rule, backlash
    against the return.
    """
    curve = table.positive if direction is POSITIVE else table.negative
    total = np.interp(where, table.positions, curve)
    total = np.where((where < table.positions[0]) & (table.below == "zero"), 0.0, total)
    total = np.where((where > table.positions[-1]) & (table.above == "zero"), 0.0, total)
    if direction is table.reference_return:
        return total
    return total + (table.backlash if direction is POSITIVE else -table.backlash)


def left(result: FittedTable, wanted: WantedCorrection, where: Array = X) -> tuple[Array, Array]:
    """What remains in both directions (g,): held minus wanted."""
    return (
        held(result.compensation, where, POSITIVE) - np.interp(where, X, wanted.positive),
        held(result.compensation, where, NEGATIVE) - np.interp(where, X, wanted.negative),
    )


def rms(result: FittedTable, wanted: WantedCorrection) -> float:
    fine = np.linspace(X[0], X[-1], 20001)
    return float(np.sqrt(np.mean(np.square(left(result, wanted, fine)))))


def with_own_datum(wanted: WantedCorrection, *, held: float | None = None) -> WantedCorrection:
    """The wish moved so that one curve, which lies half of the ``held`` reversal (None: the mean
    one) beside the mean of both directions, is zero at the reference at 0.
    """
    reversal = wanted.positive - wanted.negative
    mean = float(np.trapezoid(reversal, X) / np.ptp(X)) if held is None else held
    move = 0.5 * (float(reversal[-1]) - mean)  # the return direction is +
    return replace(wanted, positive=wanted.positive + move, negative=wanted.negative + move)


def causes(result: FittedTable) -> dict[str, float]:
    return {limit.cause: limit.value for limit in result.limits}


def codes(result: FittedTable) -> set[str]:
    return {finding.code for finding in result.findings}


# --- the pieces
# --------------------------------------------------------------------------------------------------


def test_hat_matrix_by_hand() -> None:
    nodes, where = np.array([0.0, 10.0, 30.0]), np.array([-5.0, 0.0, 2.5, 10.0, 25.0, 30.0, 31.0])
    expected = [
        [0, 0, 0],
        [1, 0, 0],
        [0.75, 0.25, 0],
        [0, 1, 0],
        [0, 0.25, 0.75],
        [0, 0, 1],
        [0, 0, 1],
    ]
    assert hat_matrix(where, nodes, below="zero", above="hold").dense().tolist() == expected
    ends = hat_matrix(where, nodes, below="hold", above="zero").dense()
    assert ends[0].tolist() == [1, 0, 0]
    assert ends[-1].tolist() == [0, 0, 0]


def test_quadrature_is_exact_for_squares_of_straight_pieces() -> None:
    points, weights = quadrature(np.array([0.0, 1.0, 4.0]), np.array([-1.0, 0.5, 3.0, 9.0]))
    assert np.sum(weights) == pytest.approx(1.0, abs=1e-14)
    assert weights @ points**3 == pytest.approx(
        4.0**4 / 4 / 4, rel=1e-13
    )  # the mean of x^3 over 0..4


@given(st.lists(st.integers(-3000, 3000), min_size=2, max_size=40))
def test_rounding_keeps_half_a_quantum_and_the_range(steps: list[int]) -> None:
    quantum = 0.001
    values = np.clip(np.cumsum(np.array(steps) / 100.0 * quantum), -0.05, 0.04)
    rounded = round_curve(values, quantum, value_range=(-0.05, 0.04))
    dust = 1e-9
    assert np.all(np.abs(rounded - values) <= quantum / 2 + dust)
    assert rounded.min() >= -0.05 - dust
    assert rounded.max() <= 0.04 + dust
    assert np.allclose(rounded / quantum, np.round(rounded / quantum), atol=1e-9)


def random_problem(rng: np.random.Generator, n: int, c: int) -> QuadraticProblem:
    root = rng.standard_normal((n, n))
    A = rng.standard_normal((c, n))
    return QuadraticProblem(
        P=from_dense(root @ root.T + 0.5 * np.eye(n)),
        q=3 * rng.standard_normal(n),
        constant=0.0,
        A=from_dense(A),
        lower=-rng.uniform(0.01, 0.5, c),
        upper=rng.uniform(0.01, 0.5, c),
    )


def test_random_quadratic_problems_are_optimal_against_scipy() -> None:
    from scipy.optimize import minimize

    rng = np.random.default_rng(0)
    for _ in range(30):
        problem = random_problem(rng, 6, 9)
        solution = solve_quadratic(problem)

        def value(x: Array, p: QuadraticProblem = problem) -> float:
            return float(0.5 * x @ (p.P @ x) + p.q @ x)

        limits = [
            {"type": "ineq", "fun": lambda x, p=problem: p.upper - p.A @ x},
            {"type": "ineq", "fun": lambda x, p=problem: p.A @ x - p.lower},
        ]
        other = minimize(
            value,
            np.zeros(6),
            constraints=limits,
            method="SLSQP",
            options={"ftol": 1e-14, "maxiter": 500},
        )
        assert value(solution.x) <= other.fun + 1e-9
        assert np.all(problem.A @ solution.x <= problem.upper + 1e-9)
        assert np.all(problem.A @ solution.x >= problem.lower - 1e-9)
        assert max(solution.certificate.values()) <= 1e-9


def test_the_fallback_finds_the_same_optimum(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = random_problem(np.random.default_rng(1), 8, 12)
    usual = solve_quadratic(problem).x
    nothing = np.zeros(12, dtype=bool)
    monkeypatch.setattr(solve, "_active_set", lambda problem, *_: (nothing, problem.upper))
    assert solve_quadratic(problem).x == pytest.approx(usual, abs=1e-10)


def test_the_certificate_sees_every_kind_of_fault() -> None:
    # Minimise (x-3)^2/2 for x <= 1: optimum 1, multiplier 2.
    problem = QuadraticProblem(
        P=identity(1),
        q=np.array([-3.0]),
        constant=4.5,
        A=identity(1),
        lower=np.array([-np.inf]),
        upper=np.array([1.0]),
    )

    def proof(x: float, y: float) -> dict[str, float]:
        return certificate(problem, np.array([x]), np.array([y]))

    assert max(proof(1.0, 2.0).values()) == 0.0
    assert proof(1.5, 1.5)["primal"] == 0.5
    assert proof(1.0, 1.0)["stationarity"] == 1.0
    assert proof(4.0, -1.0)["dual"] == 1.0
    assert proof(0.5, 2.5)["complementarity"] == 0.5


def test_the_gap_is_a_bound() -> None:
    # Minimise x for x >= 2, written -x <= -2: the least value is 2, multiplier 1.
    cost, G, h = np.array([1.0]), identity(1).times(-1.0), np.array([-2.0])
    assert range_gap(cost, G, h, np.array([1.0]), 2.0, 10.0) == 0.0
    assert range_gap(cost, G, h, np.array([1.0]), 2.5, 10.0) == pytest.approx(0.5)
    assert range_gap(cost, G, h, np.array([0.0]), 2.0, 10.0) == pytest.approx(
        12.0
    )  # no multiplier proves nothing


def test_a_period_is_taken_out_of_the_wish_and_nothing_else() -> None:
    wave = 2 * UM * np.cos(2 * np.pi * X / 10.0 + 1.0) + 0.7 * UM * np.sin(2 * np.pi * X / 5.0)
    smooth, taken = without_periods(
        replace(SMOOTH, positive=SMOOTH.positive + wave, negative=SMOOTH.negative + wave), [10.0]
    )
    assert taken == pytest.approx(np.sqrt(2.0**2 / 2 + 0.7**2 / 2) * UM, rel=0.02)
    assert smooth.positive == pytest.approx(SMOOTH.positive, abs=0.05 * UM)


# --- the fit
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("home", [POSITIVE, NEGATIVE])
def test_single_table_equals_brute_force(home: Direction) -> None:
    """Least squares over 40 001 points, the node at the reference fixed to zero, backlash as its
    own column.
    """
    shift = 4 * UM if home is NEGATIVE else 0.0
    wanted = replace(
        SMOOTH,
        positive=SMOOTH.positive - shift,
        negative=SMOOTH.negative - shift,
        reference_return=home,
    )
    result = fit(wanted, FINE, spacing=100.0)
    fine = np.linspace(X[0], X[-1], 40001)
    nodes = np.linspace(-800.0, 0.0, 9)
    hats = np.column_stack([np.interp(fine, nodes, one) for one in np.eye(9)])[
        :, :-1
    ]  # the last node is the reference
    zero, one = np.zeros((fine.size, 1)), np.ones((fine.size, 1))
    plus, minus = (zero, -one) if home is POSITIVE else (one, zero)
    matrix = np.vstack([np.hstack([hats, plus]), np.hstack([hats, minus])])
    aims = np.concatenate(
        [np.interp(fine, X, wanted.positive), np.interp(fine, X, wanted.negative)]
    )
    expected = np.linalg.lstsq(matrix, aims, rcond=None)[0]
    # Brute force sums over points instead of integrating: 0.02 mm steps leave well under a
    # nanometre.
    assert result.compensation.positive[:-1] == pytest.approx(expected[:-1], abs=1e-3 * UM)
    assert result.compensation.positive[-1] == 0.0
    assert result.compensation.backlash == pytest.approx(expected[-1], abs=1e-3 * UM)
    # The node held at zero bends the first section; the reversal value takes a few nanometres of
    # that.
    assert result.compensation.backlash == pytest.approx(-4 * UM, abs=0.05 * UM)
    assert result.mode == "single"
    assert np.array_equal(result.compensation.positive, result.compensation.negative)


def test_two_tables_equal_brute_force_each() -> None:
    result = fit(VARYING, TWO_CURVES, spacing=100.0)
    assert result.mode == "bidirectional"
    assert "varies" in result.mode_reason
    fine = np.linspace(X[0], X[-1], 40001)
    hats = np.column_stack([np.interp(fine, np.linspace(-800.0, 0.0, 9), one) for one in np.eye(9)])
    free = np.linalg.lstsq(hats, np.interp(fine, X, VARYING.negative), rcond=None)[0]
    fixed = np.linalg.lstsq(hats[:, :-1], np.interp(fine, X, VARYING.positive), rcond=None)[0]
    assert result.compensation.negative == pytest.approx(free, abs=1e-3 * UM)
    assert result.compensation.positive[:-1] == pytest.approx(fixed, abs=1e-3 * UM)
    assert result.compensation.positive[-1] == 0.0  # the zero state: the reference, arriving in +
    assert result.compensation.backlash == 0.0
    assert (
        max(
            result.certificate[name]
            for name in ("primal", "stationarity", "dual", "complementarity")
        )
        <= 1e-9
    )


def test_single_on_two_tables_differs_by_a_constant() -> None:
    result = fit(VARYING, replace(TWO_CURVES, quantum=1 * UM), spacing=100.0, mode="single")
    difference = result.compensation.negative - result.compensation.positive
    assert np.ptp(difference) == pytest.approx(0.0, abs=1e-12)
    assert difference[0] == pytest.approx(
        1 * UM, abs=1e-9
    )  # 4 µm at the end 0, 4 - 6.4 µm at -800: 0.8 µm on the mean
    assert result.compensation.backlash == 0.0
    assert (
        fit(SMOOTH, TWO_CURVES, spacing=100.0).mode == "single"
    )  # no evidence that the reversal varies


def test_more_freedom_is_never_worse_and_limits_say_what_they_cost() -> None:
    two = fit(VARYING, TWO_CURVES, spacing=100.0)
    one = fit(VARYING, FINE, spacing=100.0)
    none = fit(VARYING, replace(FINE, backlash_quantum=None), spacing=100.0)
    sizes = [
        rms(two, VARYING),
        rms(one, with_own_datum(VARYING)),
        rms(none, with_own_datum(VARYING, held=0.0)),
    ]
    assert sizes == sorted(sizes)
    # The reversal changes by 6.4 µm end to end; half of its scatter, 0.92 µm, stays in each
    # direction. Without backlash half of the mean reversal stays too.
    assert causes(one)["one table for both directions"] == pytest.approx(
        np.sqrt(sizes[1] ** 2 - sizes[0] ** 2), rel=1e-3
    )
    assert 0.9 * UM < causes(one)["one table for both directions"] < 1.3 * UM
    assert causes(none)["no backlash value"] == pytest.approx(
        np.sqrt(sizes[2] ** 2 - sizes[1] ** 2), rel=1e-3
    )
    assert "CW-F005" in codes(none)
    assert none.compensation.backlash == 0.0
    assert causes(two)["spacing of the points"] == pytest.approx(sizes[0], rel=1e-3)


@pytest.mark.parametrize("home", [POSITIVE, NEGATIVE])
@pytest.mark.parametrize("reversal", ["backlash", "none"])
def test_one_table_is_pinned_to_its_own_zero_not_to_that_of_one_direction(
    home: Direction, reversal: str
) -> None:
    """The reversal at the reference is not the mean one: which constant lies between table and
    wish is free, and the table is the least-squares one with a constant of its own.
    """
    wanted = wish(wavy(X), wavy(X) + 3 * UM + 40e-6 * X, reference=-150.0, reference_return=home)
    capacity = FINE if reversal == "backlash" else replace(FINE, backlash_quantum=None)
    table = fit(wanted, capacity, spacing=50.0)
    nodes, fine = np.linspace(-800.0, 0.0, 17), np.linspace(-800.0, 0.0, 32001)
    hats = np.column_stack([np.interp(fine, nodes, one) for one in np.eye(17)])
    none, one = np.zeros((fine.size, 1)), np.ones((fine.size, 1))
    columns = [np.vstack([hats, hats])]
    if reversal == "backlash":
        columns.append(np.vstack([none, one]))
    matrix = np.hstack(columns)
    aims = np.concatenate([np.interp(fine, X, wanted.total(way)) for way in (POSITIVE, NEGATIVE)])
    best = np.linalg.lstsq(matrix, aims, rcond=None)[0][:17]
    # but for a constant; what bends between the nodes next to the reference is no reason to move
    # it: 0.2 µm. With the wish of the return direction zero there the node lies 2 µm and more off.
    assert np.ptp(table.compensation.positive - best) < 0.2 * UM
    assert held(table.compensation, np.array([-150.0]), home)[0] == pytest.approx(0.0, abs=1e-12)


def test_value_range_binds() -> None:
    ranged = fit(SMOOTH, replace(COARSE, value_range=(-9.4 * UM, 100 * UM)), spacing=20.0)
    assert ranged.compensation.positive.min() == pytest.approx(
        -9 * UM, abs=1e-9
    )  # whole quanta inside the range
    assert causes(ranged)["value range"] > 1 * UM
    assert "CW-F007" in codes(ranged)
    assert ranged.compensation.positive[-1] == 0.0
    assert rms(ranged, SMOOTH) > rms(fit(SMOOTH, COARSE, spacing=20.0), SMOOTH)


@pytest.mark.parametrize("reversal", [30.0, -30.0])
def test_backlash_range_binds_in_its_own_sign(reversal: float) -> None:
    wanted = wish(wavy(X), wavy(X) + reversal * UM)
    result = fit(wanted, replace(COARSE, backlash_range=(-5 * UM, 7 * UM)), spacing=50.0)
    assert result.compensation.backlash == pytest.approx(
        -5 * UM if reversal > 0 else 7 * UM, abs=1e-12
    )
    assert causes(result)["value range"] > 5 * UM


def test_both_curves_keep_the_range_when_they_differ_by_a_constant() -> None:
    narrow = replace(TWO_CURVES, quantum=1 * UM, value_range=(-20 * UM, 6 * UM))
    result = fit(SMOOTH, narrow, spacing=20.0, mode="single")
    for curve in (result.compensation.positive, result.compensation.negative):
        assert curve.max() <= 6 * UM + 1e-12
        assert curve.min() >= -20 * UM - 1e-12


def test_rounding_both_curves_up_does_not_leave_the_range() -> None:
    # Curve 3.5 and constant 2.5 quanta reach the limit of 6 exactly; each rounded up by itself
    # would make 7.
    plateau = np.interp(X, [-800.0, -700.0, -100.0, 0.0], [3.5 * UM, 3.5 * UM, 3.5 * UM, 0.0])
    capacity = replace(TWO_CURVES, quantum=1 * UM, value_range=(-50 * UM, 6 * UM))
    result = fit(wish(plateau, plateau + 2.5 * UM), capacity, spacing=100.0, mode="single")
    assert result.compensation.positive[0] == pytest.approx(3 * UM, abs=1e-9)
    assert result.compensation.negative.max() == pytest.approx(6 * UM, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 10_000),
    curves=st.sampled_from([1, 2]),
    reach=st.integers(2, 60),
    reference=st.sampled_from([0.0, -800.0, -400.0, 33.0]),
    below=st.sampled_from(["hold", "zero"]),
    home=st.sampled_from(list(Direction)),
    odds=st.sampled_from([-2.0, 9.0]),
)
def test_every_table_keeps_every_limit(
    seed: int,
    curves: Literal[1, 2],
    reach: int,
    reference: float,
    below: Literal["hold", "zero"],
    home: Direction,
    odds: float,
) -> None:
    rng = np.random.default_rng(seed)
    order = np.arange(1, 20)
    shape = (
        np.sin(np.outer(X, order) * np.pi / 800.0 + rng.uniform(0, 6, 19))
        @ (rng.standard_normal(19) / order)
        * 0.02
    )
    other = shape + rng.normal() * 5 * UM + 0.01 * np.sin(X / rng.uniform(20.0, 200.0))
    wanted = wish(shape, other, reference=reference, reference_return=home, reversal_log_odds=odds)
    capacity = replace(
        COARSE,
        curves=curves,
        value_range=(-reach * UM, (reach // 2 + 1) * UM),
        below=below,
        above=below,
    )
    result = fit(wanted, capacity, spacing=50.0)
    table = result.compensation
    for curve in (table.positive, table.negative):
        assert np.allclose(curve / UM, np.round(curve / UM), atol=1e-6)
        assert curve.min() >= -(reach + 1e-6) * UM
        assert curve.max() <= (reach // 2 + 1 + 1e-6) * UM
    zero_state = held(table, np.array([reference]), home)[0]
    assert zero_state == 0.0
    assert result.certificate["rounding"] <= 0.5 * UM + 1e-9


# --- goals
# --------------------------------------------------------------------------------------------------


def test_each_goal_is_best_in_its_own_measure() -> None:
    rough = wish(wavy(X) + 4 * UM * np.exp(-(((X + 300) / 15) ** 2)), wavy(X) + 4 * UM + 1e-5 * X)

    def measures(result: FittedTable) -> dict[str, float]:
        plus, minus = left(result, rough)
        return {
            "expected": float(np.var([plus, minus])),
            "E": float(max(plus.max(), minus.max()) - min(plus.min(), minus.min())),
            "M": float(np.ptp(0.5 * (plus + minus))),
        }

    tables = {
        goal: measures(fit(rough, FINE, spacing=100.0, goal=goal))
        for goal in ("expected", "E", "M", "A")
    }
    for goal in ("expected", "E", "M"):
        others = [
            tables[other][goal]
            for other in tables
            if other not in {goal, "A" if goal == "E" else goal}
        ]
        assert all(tables[goal][goal] < 0.999 * other for other in others), goal
    # With the same noise at every position A is E and a constant: one table is best for both.
    assert tables["A"] == pytest.approx(tables["E"], rel=1e-6)


def test_the_least_range_equals_a_linear_program_of_its_own() -> None:
    from scipy.optimize import linprog

    result = fit(SMOOTH, FINE, spacing=200.0, goal="E")
    nodes = np.linspace(-800.0, 0.0, 5)
    hats = np.column_stack([np.interp(X, nodes, one) for one in np.eye(5)])[:, :-1]
    none, one = np.zeros((X.size, 1)), np.ones((X.size, 1))
    D = np.vstack(
        [np.hstack([hats, none]), np.hstack([hats, -one])]
    )  # unknowns: four nodes, backlash
    d = np.concatenate([SMOOTH.positive, SMOOTH.negative])
    ones = np.ones((d.size, 1))
    program = linprog(
        [0, 0, 0, 0, 0, 1, -1],
        A_ub=np.vstack([np.hstack([D, -ones, 0 * ones]), np.hstack([-D, 0 * ones, ones])]),
        b_ub=np.concatenate([d, -d]),
        bounds=[(None, None)] * 7,
    )
    plus, minus = left(result, SMOOTH)
    reached = max(plus.max(), minus.max()) - min(plus.min(), minus.min())
    assert reached == pytest.approx(
        program.fun, abs=2e-3 * UM
    )  # 1 nm of the certificate and the quantum
    assert result.certificate["gap"] <= 1e-3 * UM


# --- the reference and the ends
# ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("rule", ["hold", "zero"])
def test_a_reference_outside_the_table(rule: Literal["hold", "zero"]) -> None:
    capacity = replace(FINE, below=rule, above=rule)
    result = fit(SMOOTH, capacity, start=-700.0, end=-100.0, spacing=50.0)
    assert {"CW-F001", "CW-F003"} <= codes(result)
    table = result.compensation
    assert held(table, np.array([0.0]), POSITIVE)[0] == 0.0
    if rule == "hold":
        assert table.positive[-1] == 0.0
        # The datum moves with the end, by 10.4 µm: the shape of the wish is kept, not bent to zero
        # at the edge. The reversal value also has a say where the end is held, which shifts the
        # whole by half a micrometre.
        plus, _ = left(result, SMOOTH, np.linspace(-650.0, -150.0, 200))
        assert np.std(plus) < 0.4 * UM
        assert abs(np.mean(plus)) == pytest.approx(abs(wavy(np.array([-100.0]))[0]), abs=1 * UM)
    else:
        assert abs(table.positive[-1]) > 5 * UM  # nothing acts outside; inside the wish itself


def test_a_second_table_gives_nothing_where_no_table_acts() -> None:
    """Least squares over points, where the constant between the tables ends with them."""
    capacity = replace(TWO_CURVES, below="zero", above="zero")
    result = fit(SMOOTH, capacity, start=-600.0, end=0.0, spacing=100.0, mode="single")
    fine = np.linspace(X[0], X[-1], 40001)
    nodes = np.linspace(-600.0, 0.0, 7)
    inside = (fine >= -600.0)[:, np.newaxis]
    hats = np.column_stack([np.interp(fine, nodes, one) for one in np.eye(7)])[:, :-1] * inside
    matrix = np.vstack([np.hstack([hats, 0.0 * inside]), np.hstack([hats, 1.0 * inside])])
    aims = np.concatenate(
        [np.interp(fine, X, SMOOTH.positive), np.interp(fine, X, SMOOTH.negative)]
    )
    expected = np.linalg.lstsq(matrix, aims, rcond=None)[0]
    assert result.compensation.positive[:-1] == pytest.approx(expected[:-1], abs=2e-3 * UM)
    assert result.compensation.negative[0] - result.compensation.positive[0] == pytest.approx(
        expected[-1], abs=2e-3 * UM
    )


def test_zero_between_nodes_holds_on_the_curve() -> None:
    result = fit(
        replace(SMOOTH, reference=-333.0, positive=SMOOTH.positive - wavy(np.array([-333.0]))[0]),
        FINE,
        spacing=100.0,
    )
    at = held(result.compensation, np.array([-333.0]), POSITIVE)[0]
    assert abs(at) <= 1e-7  # within the quantum of the fine control


# --- the grid
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("request_", "pattern"),
    [
        (
            {"spacing": 30.0},
            r"26\.6667 steps long.*expected 25 or 32 mm, for a table from -800 to 0 mm, found 30 mm",
        ),
        (
            {"spacing": 1.0},
            r"too many points.*a spacing of 6\.4 mm or more fits.*at most 128 points, found 801",
        ),
        ({"spacing": 0.0125 / 10}, r"multiple of 0\.001 mm"),
        ({"start": -800.0004, "spacing": 50.0}, r"table\.start.*such as -800, found -800\.0004"),
    ],
)
def test_grids_that_the_control_cannot_say_exactly(
    request_: dict[str, float], pattern: str
) -> None:
    with pytest.raises(CapacityError, match=pattern):
        fit(SMOOTH, COARSE, **request_)


def test_faults_of_start_and_end_come_together() -> None:
    with pytest.raises(CapacityError) as caught:
        fit(SMOOTH, COARSE, start=-700.0004, end=-0.0004)
    assert len(caught.value.faults) == 2
    with pytest.raises(UsageError, match="start below end"):
        fit(SMOOTH, COARSE, start=-100.0, end=-100.0)
    with pytest.raises(UsageError, match="positive"):
        fit(SMOOTH, COARSE, spacing=-5.0)


def test_too_few_points() -> None:
    with pytest.raises(CapacityError, match="at least 5 points, found 3"):
        fit(SMOOTH, replace(COARSE, min_points=5), spacing=400.0)


def test_a_turn_has_no_more_points_than_the_control_can_ever_be_set_to() -> None:
    """Where nobody knows how many points are set, the most that there can be still count."""
    turn = replace(COARSE, period=800.0, max_points=None, most_points=100)
    with pytest.raises(CapacityError, match="at most 100 points, found 401 points"):
        fit(SMOOTH, turn, spacing=2.0)


def test_free_spacing_may_cut_the_last_section() -> None:
    result = fit(SMOOTH, replace(COARSE, spacing="free"), spacing=30.0)
    assert result.compensation.positions[[0, 1, -2, -1]].tolist() == [-800.0, -770.0, -20.0, 0.0]


def test_the_automatic_grid_is_exact_coarse_and_good_enough() -> None:
    for span, wanted in (
        (800.0, SMOOTH),
        (799.993, replace(SMOOTH, positions=X * 799.993 / 800.0)),
    ):
        result = fit(wanted, COARSE)
        nodes = result.compensation.positions
        step = nodes[1] - nodes[0]
        assert nodes == pytest.approx(nodes[0] + step * np.arange(nodes.size), abs=1e-9)
        assert nodes / 1e-3 == pytest.approx(np.round(nodes / 1e-3), abs=1e-6)
        assert nodes[0] <= -span
        assert 0.0 in nodes
        assert 8 <= nodes.size <= 40
        curve = np.interp(
            wanted.positions, nodes, np.interp(nodes, wanted.positions, wanted.positive)
        )
        assert np.sqrt(np.mean((curve - wanted.positive) ** 2)) <= 1 * UM


def test_a_control_with_few_points_says_what_that_costs() -> None:
    result = fit(SMOOTH, replace(COARSE, max_points=5))
    assert result.compensation.positions.size == 5
    assert "CW-F004" in codes(result)
    assert causes(result)["number of points"] > 0.5 * UM


@pytest.mark.parametrize(
    ("bend", "noise", "warned"),
    [
        (0.05 * UM, 0.0, False),  # less than 0.05 µm remain: no test shows that
        (6.0 * UM, 0.0, True),
        (6.0 * UM, 12.0 * UM, False),  # a test scatters by far more
    ],
)
def test_what_no_test_would_show_is_no_warning(bend: float, noise: float, *, warned: bool) -> None:
    """What is left stays among the limits, with its size."""
    curve = bend * np.sin(X / 90.0)
    wanted = wish(curve, curve, noise=noise)
    result = fit(wanted, replace(COARSE, max_points=5, quantum=1e-7))
    assert 0.0 < causes(result)["number of points"] < bend
    assert ("CW-F004" in codes(result)) == warned


def test_a_period_is_held_where_three_points_per_period_fit_and_left_out_below_two() -> None:
    x = np.linspace(-800.0, 0.0, 2001)
    wave = 3 * UM * np.sin(2 * np.pi * x / 20.0)
    wanted = wish(wavy(x) + wave, wavy(x) + wave, positions=x, periods=(20.0,))
    fine = replace(FINE, quantum=0.1 * UM, max_points=400)
    held_fine = fit(wanted, fine)
    assert np.max(np.diff(held_fine.compensation.positions)) <= 20.0 / 3 + 1e-9
    assert "CW-F002" not in codes(held_fine)
    few = fit(wanted, replace(fine, max_points=60))
    assert "CW-F002" in codes(few)
    assert causes(few)["spacing too wide for the period"] == pytest.approx(
        3 * UM / np.sqrt(2), rel=0.02
    )
    nodes = few.compensation.positions
    # The table follows the smooth part; the datum may move by what the wave is at the reference.
    smooth = few.compensation.positive - wavy(nodes)
    assert np.std(smooth) < 0.3 * UM
    explicit = fit(wanted, fine, spacing=8.0)
    assert "CW-F002" in codes(explicit)
    assert "CW-F002" not in codes(fit(wanted, fine, spacing=5.0))


@pytest.mark.parametrize("spacing", [3.2, "auto"])
@pytest.mark.parametrize("phase", [0.0, 1.0, 2.3])
def test_of_a_period_between_two_and_three_points_the_nodes_hold_their_part(
    spacing: Any, phase: float
) -> None:
    """A sine of ±2 µm over 8 mm beside a smooth curve, a control with 256 points over 800 mm: what
    is left between positions is what least squares leave on these nodes, 42 % of the wave's rms.
    """
    x = np.linspace(-800.0, 0.0, 3201)
    wave, size = np.sin(2 * np.pi * x / 8.0 + phase), 2 * UM / np.sqrt(2)
    wanted = wish(*2 * [wavy(x) + 2 * UM * wave], positions=x, periods=(8.0,), noise=0.3 * UM)
    result = fit(wanted, replace(FINE, max_points=256), spacing=spacing)
    nodes, table = result.compensation.positions, result.compensation.positive
    assert np.diff(nodes) == pytest.approx(3.2)
    where = np.linspace(-800.0, 0.0, 40001)
    true = wavy(where) + 2 * UM * np.sin(2 * np.pi * where / 8.0 + phase)
    hats = np.array([np.interp(where, nodes, one) for one in np.eye(nodes.size)])
    least = true - np.linalg.solve(hats @ hats.T, hats @ true) @ hats
    left = np.std(true - np.interp(where, nodes, table))
    assert left == pytest.approx(np.std(least), rel=0.005)
    assert left == pytest.approx(0.416 * size, rel=0.01)
    assert causes(result)["spacing too wide for the period"] == pytest.approx(left, rel=0.02)
    (message,) = (each.message for each in result.findings if each.code == "CW-F002")
    assert "(41 %)" in message or "(42 %)" in message
    assert "2.66 mm, which is 302 points" in message
    assert "has 256" in message


def test_a_period_below_two_points_is_left_out_and_the_finest_spacing_named() -> None:
    """Nodes trace a longer wave there, which widens what is left (Shannon 1949)."""
    x = np.linspace(-800.0, 0.0, 3201)
    wave = 3 * UM * np.sin(2 * np.pi * x / 5.0)
    wanted = wish(wave, wave, positions=x, periods=(5.0,))
    result = fit(wanted, replace(FINE, max_points=256))
    assert np.max(np.abs(result.compensation.positive)) < 0.05 * UM
    (message,) = (each.message for each in result.findings if each.code == "CW-F002")
    assert "finest spacing that this control allows here, 3.2 mm (251 points)" in message
    assert "1.66 mm, which is 483 points" in message


# --- what the control cannot do
# ---------------------------------------------------------------------------------------


def test_refusals() -> None:
    with pytest.raises(CapacityError, match="one table for both directions") as caught:
        fit(SMOOTH, replace(FINE, value_range=(1 * UM, 5 * UM)), mode="bidirectional")
    assert len(caught.value.faults) == 2
    assert caught.value.exit_code == 4


@pytest.mark.parametrize(
    "status", ["solved inaccurate", "maximum iterations reached", "run time limit reached"]
)
def test_a_solver_that_did_not_finish_has_failed(
    monkeypatch: pytest.MonkeyPatch, status: str
) -> None:
    import osqp

    class CutOff(osqp.OSQP):  # type: ignore[misc]
        def solve(self, **options: Any) -> Any:
            result = super().solve(**options)
            return SimpleNamespace(x=result.x, y=result.y, info=SimpleNamespace(status=status))

    monkeypatch.setattr(osqp, "OSQP", CutOff)
    with pytest.raises(CapacityError, match=f"no certified solution.*{status}"):
        fit(SMOOTH, COARSE, spacing=50.0)


def test_a_wrong_solution_does_not_pass(monkeypatch: pytest.MonkeyPatch) -> None:
    exact = solve._with_equations

    def off(problem: QuadraticProblem, active: Any, bound: Array) -> tuple[Array, Array]:
        x, y = exact(problem, active, bound)
        return x + 1e-6, y

    monkeypatch.setattr(solve, "_with_equations", off)
    with pytest.raises(CapacityError, match="does not pass its certificate"):
        fit(SMOOTH, COARSE, spacing=50.0)


def test_an_inaccurate_range_has_failed(monkeypatch: pytest.MonkeyPatch) -> None:
    import cvxpy

    monkeypatch.setattr(cvxpy, "OPTIMAL", "nothing is")
    with pytest.raises(CapacityError, match="no certified solution"):
        fit(SMOOTH, COARSE, spacing=100.0, goal="E")


def test_the_solvers_print_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    fit(SMOOTH, COARSE, spacing=50.0)
    fit(SMOOTH, COARSE, spacing=50.0, goal="M")
    captured = capfd.readouterr()
    assert captured.out == captured.err == ""


def test_points_that_serve_other_axes_too_stay_where_they_are() -> None:
    own = tuple(float(x) for x in (-820, -600, -410, -200, 0, 35))
    given = replace(FINE, spacing="free", points=own)
    assert fit(SMOOTH, given).compensation.positions.tolist() == list(own)
    assert fit(SMOOTH, given, start=-820.0, end=35.0).compensation.positions.tolist() == list(own)
    with pytest.raises(CapacityError, match="existing table must not change") as caught:
        fit(SMOOTH, given, start=-800.0, spacing=50.0)
    assert [fault.place for fault in caught.value.faults] == ["table.start", "table.spacing"]


def test_a_table_reaches_beyond_the_travel_where_nobody_knows_what_acts_there() -> None:
    plain = fit(SMOOTH, FINE).compensation
    reaching = fit(SMOOTH, replace(FINE, cover=1)).compensation
    step = plain.positions[1] - plain.positions[0]
    expected = [plain.positions[0] - step, *plain.positions, plain.positions[-1] + step]
    assert reaching.positions.tolist() == pytest.approx(expected, abs=1e-9)  # mm
    # Beyond the travel the end value is held: within 0.1 µm, the tie that settles what no part of
    # the travel sees.
    for end in (0, -1):
        assert reaching.positive[end] == pytest.approx(
            reaching.positive[1 if end == 0 else -2], abs=0.1 * UM
        )
    fixed = fit(SMOOTH, replace(FINE, cover=1), start=-800.0, end=0.0).compensation
    assert (fixed.positions[0], fixed.positions[-1]) == (-800.0, 0.0)
    full = replace(FINE, cover=1, max_points=plain.positions.size)
    assert fit(SMOOTH, full).compensation.positions.size <= plain.positions.size


def test_a_spacing_that_ends_a_hair_before_the_table_gives_no_node_twice() -> None:
    """In inches the step is no whole number of what the file can say: the last node and the end may
    be one.
    """
    inch = replace(TWO_CURVES, spacing="free", position_quantum=25.4e-4)
    where = np.linspace(0.0, 646.0, 401)
    wanted = wish(wavy(where), wavy(where) + 4 * UM, positions=where, reference=323.0)
    for pieces in range(2, 60):
        nodes = fit(wanted, inch, spacing=646.0 / pieces).compensation.positions
        assert np.all(np.diff(nodes) > 0)
