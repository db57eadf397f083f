"""Small problems of the fit that are solved by hand."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

import cvxpy
import numpy as np
import pytest
from numpy.typing import NDArray

from compwright.fitting import mean_range
from compwright.fitting.chain import ChainTarget, build_chain
from compwright.fitting.fit import fit_table
from compwright.fitting.mean_range import Deviations, solve_ranges
from compwright.fitting.problem import QuadraticProblem, Rows
from compwright.fitting.rounding import to_quanta
from compwright.fitting.sparse_matrices import from_dense, identity, stack_rows
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest

Array = NDArray[np.float64]
UM = 1e-3
X = np.linspace(-80.0, 75.0, 32)
PLAIN = Capacity(
    format="plain",
    curves=1,
    spacing="equidistant",
    quantum=1e-7,
    position_quantum=1e-3,
    value_range=(-10.0, 10.0),
)
LINE = replace(PLAIN, quantum=1e-6, line=5e-6, value_range=(-1e-3, 1e-3))


def fitted(curve: Array, capacity: Capacity, *, reference: float = 10.0, **asked: Any) -> Any:
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=X,
        positive=curve,
        negative=curve,
        reference=reference,
        reference_return=Direction.POSITIVE,
        noise=UM,
    )
    table: AxisCompensation = fit_table(
        wanted, capacity, TableRequest(**asked), address="1"
    ).compensation
    return table


@pytest.mark.parametrize(
    ("ends", "nodes"),
    [
        ({}, [-90.0, -40.0, 10.0, 60.0, 110.0]),  # through the reference
        ({"start": -80.0}, [-80.0, -30.0, 20.0, 70.0, 120.0]),
        ({"end": 75.0}, [-125.0, -75.0, -25.0, 25.0, 75.0]),
    ],
)
def test_certain_spacings_reach_over_the_open_ends(
    ends: dict[str, float], nodes: list[float]
) -> None:
    capacity = replace(PLAIN, spacings=(25.0, 50.0))
    found = fitted(1e-5 * X, capacity, spacing=50.0, **ends)
    assert found.positions.tolist() == nodes


@pytest.mark.parametrize(
    ("slope", "held"),
    [(12e-6, 10e-6), (13e-6, 15e-6), (-13e-6, -15e-6), (-2e-6, 0.0), (2e-3, 1e-3)],
)
def test_one_slope_is_the_nearest_that_the_control_holds(slope: float, held: float) -> None:
    found = fitted(slope * X + 0.02, LINE)
    assert found.slope == pytest.approx(held, abs=1e-12)
    assert not np.signbit(found.slope) or held < 0.0  # no minus zero in a file
    assert (found.origin, found.backlash, found.positions.size) == (10.0, 0.0, 0)


def pulled_up(scale: float) -> tuple[Deviations, QuadraticProblem]:
    """Deviations 0, x - s and 2 x: their range is s + |x| near 0, least at x = 0. The square pulls x
    up.
    """
    limits = QuadraticProblem(
        P=identity(1),
        q=np.array([-scale]),
        constant=0.0,
        A=stack_rows([], 1),
        lower=np.empty(0),
        upper=np.empty(0),
    )
    shown = Deviations(
        D=from_dense(np.array([[0.0], [1.0], [2.0]])),
        base=np.array([0.0, -scale, 0.0]),
        half=np.zeros(3),
        test=np.zeros(3, dtype=np.int64),
    )
    return shown, limits


@pytest.mark.parametrize(("scale", "slack"), [(1.0, 0.1), (0.01, 1e-3)])
def test_the_least_range_and_its_gap_by_hand(scale: float, slack: float) -> None:
    """Half the slack is given to the square, so that the range lies that much above the least."""
    x, proof = solve_ranges(*pulled_up(scale), slack=slack)
    assert x == pytest.approx([0.5 * slack], abs=1e-6)
    assert proof["gap"] == pytest.approx(0.5 * slack, abs=1e-6)
    assert proof["primal"] == 0.0


def test_where_the_solver_gives_up_on_the_square_the_least_range_counts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Clarabel calls some of these problems infeasible, although the least range fulfils them."""
    usual = mean_range._cvxpy

    def gives_up(cost: Array, G: Any, h: Array, P: Any, n: int) -> tuple[Array, Array]:
        if P is not None:
            raise CapacityError(Fault(message="no certified solution"))
        return usual(cost, G, h, P, n)

    monkeypatch.setattr(mean_range, "_cvxpy", gives_up)
    x, proof = solve_ranges(*pulled_up(1.0), slack=0.1)
    assert x == pytest.approx([0.0], abs=1e-6)
    assert max(proof.values()) < 1e-6


def test_an_inaccurate_solution_has_failed_without_a_warning(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As cvxpy does it: a warning for the terminal, and a status."""

    def inaccurate(problem: Any, **_: Any) -> None:
        warnings.warn("Solution may be inaccurate. Try another solver", UserWarning, stacklevel=2)
        problem._status = cvxpy.OPTIMAL_INACCURATE

    monkeypatch.setattr(cvxpy.Problem, "solve", inaccurate)
    with pytest.raises(CapacityError, match="the solver gave up"):
        solve_ranges(*pulled_up(1.0), slack=0.1)


def test_a_chain_of_one_node_is_a_mean() -> None:
    """Weights 3 and 1 at aims 2 and 6: the mean is 3, the mean square half of 3 + 9."""
    rows = Rows(left=np.zeros(2, dtype=np.int64), lower=np.ones(2), upper=np.zeros(2))
    wish = ChainTarget(rows=rows, weights=np.array([3.0, 1.0]), aims=np.array([2.0, 6.0]))
    chain = build_chain((wish,), 2, fixed=(), kept=(), closed=False)
    assert chain.kept.tolist() == [0]
    assert chain.optimum == pytest.approx([3.0])
    assert chain.least == pytest.approx(6.0)
    assert chain.solve(np.array([2.0])) == pytest.approx([0.5])
    assert chain.value(np.array([4.0]), 0.0) == pytest.approx(0.5 * (3 * 4.0 + 4.0))


def test_halves_go_up_on_both_sides_of_zero() -> None:
    values = np.array([-1.5, -0.5, -0.4999, 0.4999, 0.5, 1.5]) * UM
    assert to_quanta(values, UM).tolist() == [-1.0, 0.0, 0.0, 0.0, 1.0, 2.0]


@pytest.mark.parametrize("low", [-800.0, -400.0, 100.0])
def test_a_table_that_ends_with_the_travel_leaves_nothing_to_say(low: float) -> None:
    """Whatever the sign of the coordinates: neither uncovered travel nor nodes beyond it."""
    where = np.linspace(low, low + 800.0, 81)
    curve = 20 * UM * np.sin(where / 100.0)
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=where,
        positive=curve,
        negative=curve,
        reference=low,
        reference_return=Direction.POSITIVE,
        noise=UM,
    )
    for end, codes in (
        (low + 800.0, set()),
        (low + 750.0, {"CW-F001"}),
        (low + 850.0, {"CW-F006"}),
    ):
        request = TableRequest(start=low, end=end, spacing=50.0)
        found = fit_table(wanted, PLAIN, request, address="1").findings
        assert {one.code for one in found} & {"CW-F001", "CW-F006"} == codes
