"""Goals of the fit, judged by tests that the fit has not seen: a known error, an estimate that is
wrong by a known law, and ranges computed here.
"""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray

from compwright.documents.json_text import to_json
from compwright.documents.plan import _wanted_out
from compwright.documents.plan_reading import plan_validator
from compwright.fitting.fit import fit_table
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity, Lattice
from compwright.records.estimate import Scenarios, WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest

Array = NDArray[np.float64]
UM = 1e-3
X = np.linspace(0.0, 800.0, 401)
PLUS, MINUS = Direction.POSITIVE, Direction.NEGATIVE
CONTROL = Capacity(
    format="any",
    curves=1,
    spacing="equidistant",
    quantum=1e-6,
    position_quantum=1e-3,
    value_range=(-1.0, 1.0),
    backlash_quantum=1e-6,
    backlash_range=(-1.0, 1.0),
)
WHOLE = replace(
    CONTROL,
    quantum=1 * UM,
    backlash_quantum=1 * UM,
    lattice=Lattice(unit=1 * UM, increments=(-7, 7), magnifications=(1, 2)),
)


def fresh_tests(count: int, seed: int, *, one_way: bool = False) -> Scenarios:
    """The estimate is wrong by a smooth wave of 0.5 µm, readings scatter by 0.3 µm, s about it."""
    rng = np.random.default_rng(seed)
    m = 15
    where = np.sort(rng.uniform(5.0, 795.0, (count, m)), axis=1)
    wrong = (
        0.5 * UM * np.sin(where / rng.uniform(40, 90, (count, 1)) + rng.uniform(0, 6, (count, 1)))
    )
    scatter = [wrong + 0.3 * UM * rng.standard_normal((count, m)) for _ in range(2)]
    half = [2 * 0.5 * UM * np.sqrt(rng.chisquare(4, (count, m)) / 4) for _ in range(2)]
    none = np.empty(0)
    return Scenarios(
        count=count,
        positions=where.ravel(),
        positive=scatter[0].ravel(),
        negative=none if one_way else scatter[1].ravel(),
        half_positive=half[0].ravel(),
        half_negative=none if one_way else half[1].ravel(),
    )


def wish(positive: Array, negative: Array, scenarios: Scenarios | None) -> WantedCorrection:
    return WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=X,
        positive=positive,
        negative=negative,
        reference=0.0,
        reference_return=PLUS,
        noise=0.5 * UM,
        scenarios=scenarios,
    )


def fit(wanted: WantedCorrection, capacity: Capacity, **request: Any) -> FittedTable:
    return fit_table(wanted, capacity, TableRequest(**request), address="1")


def shown(table: FittedTable, wanted: WantedCorrection, tests: Scenarios) -> dict[str, float]:
    """Means of A, E and M over tests (ISO 230-2:2006, 2.19 to 2.23), µm, by their formulas."""
    shape = (tests.count, -1)
    where = tests.positions
    mean, half = {}, {}
    for way, beyond, k_s in (
        (PLUS, tests.positive, tests.half_positive),
        (MINUS, tests.negative, tests.half_negative),
    ):
        if beyond.size:
            left = table.compensation.at(where, way) - np.interp(where, X, wanted.total(way))
            mean[way], half[way] = (beyond + left).reshape(shape), k_s.reshape(shape)
    both = list(mean)
    high = np.max([(mean[w] + half[w]).max(axis=1) for w in both], axis=0)
    low = np.min([(mean[w] - half[w]).min(axis=1) for w in both], axis=0)
    all_means = np.hstack([mean[w] for w in both])
    middle = np.mean([mean[w] for w in both], axis=0)
    return {
        "A": float(np.mean(high - low)) / UM,
        "E": float(np.mean(np.ptp(all_means, axis=1))) / UM,
        "M": float(np.mean(np.ptp(middle, axis=1))) / UM,
    }


BUMP = 8 * UM * np.exp(-(((X - 300.0) / 25.0) ** 2)) + 3 * UM * np.sin(X / 150.0)
BUMP = BUMP - BUMP[0]
#: A straight line of least square leaves 0.55 of it, one of least range 0.47: at the ends of
#: x^4 - 0.8 x + c and x^4 - x + c.
BENT = 12 * UM * (X / 800.0) ** 4


@pytest.mark.parametrize("goal", ["A", "E", "M"])
@pytest.mark.parametrize("capacity", [CONTROL, WHOLE])
def test_a_goal_is_reached_by_tests_that_the_fit_has_not_seen(
    goal: Literal["A", "E", "M"], capacity: Capacity
) -> None:
    """Two nodes cannot hold what bends: the goal has the better line, and shows it in 400 other
    tests.
    """
    wanted = wish(BENT, BENT + 4 * UM, fresh_tests(96, 1))
    others = fresh_tests(400, 2)
    table = fit(wanted, capacity, spacing=800.0, goal=goal)
    usual = fit(wanted, capacity, spacing=800.0)
    assert shown(table, wanted, others)[goal] < 0.97 * shown(usual, wanted, others)[goal]
    assert table.compensation.at(np.zeros(1), PLUS)[0] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("goal", ["A", "E", "M"])
def test_where_the_table_holds_all_the_goal_costs_nothing(goal: Literal["A", "E", "M"]) -> None:
    """Nothing to gain: within 1 % of the least expected square, where the least range of the
    estimate's mean would follow the estimate's own error.
    """
    wanted = wish(BUMP, BUMP + 4 * UM, fresh_tests(96, 3))
    others = fresh_tests(400, 4)
    values = {
        name: shown(fit(wanted, CONTROL, spacing=20.0, goal=name), wanted, others)
        for name in ("expected", goal)
    }
    assert values[goal][goal] < 1.01 * values["expected"][goal]


@pytest.mark.parametrize("goal", ["A", "E"])
def test_the_program_is_better_out_of_sample_than_the_least_range_of_the_mean(
    goal: Literal["A", "E"],
) -> None:
    rough = BUMP + 1.5 * UM * np.sin(X / 13.0)
    wanted = wish(rough, rough + 4 * UM, fresh_tests(96, 5))
    others = fresh_tests(400, 6)
    table = fit(wanted, CONTROL, spacing=100.0, goal=goal)
    minimax = fit(replace(wanted, scenarios=None), CONTROL, spacing=100.0, goal=goal)
    assert shown(table, wanted, others)[goal] < 0.98 * shown(minimax, wanted, others)[goal]


def test_the_limits_of_the_control_hold_whatever_the_goal() -> None:
    capacity = replace(CONTROL, value_range=(-1.0 * UM, 4.0 * UM))
    wanted = wish(BUMP, BUMP + 4 * UM, fresh_tests(96, 7))
    table = fit(wanted, capacity, spacing=100.0, goal="A")
    assert table.compensation.positive.max() <= 4.0 * UM + 1e-12
    assert table.compensation.positive.min() >= -1.0 * UM - 1e-12
    assert table.certificate["primal"] <= 1e-6
    assert table.certificate["gap"] <= 0.01 * UM + 1e-6


def test_nothing_moves_where_no_target_came() -> None:
    """Nodes every 4 mm, most of them seen by no target: no node leaves its neighbours."""
    wanted = wish(BUMP, BUMP, fresh_tests(96, 8))
    table = fit(wanted, CONTROL, spacing=4.0, goal="M").compensation
    usual = fit(wanted, CONTROL, spacing=4.0).compensation
    assert np.max(np.abs(np.diff(table.positive - usual.positive))) < 0.2 * UM


def test_one_direction_has_a_goal_of_its_own() -> None:
    wanted = wish(BENT, BENT, fresh_tests(96, 9, one_way=True))
    others = fresh_tests(400, 10, one_way=True)
    table = fit(wanted, CONTROL, spacing=800.0, goal="E")
    usual = fit(wanted, CONTROL, spacing=800.0)
    assert shown(table, wanted, others)["E"] < 0.97 * shown(usual, wanted, others)["E"]


def test_the_plan_holds_the_tests_by_which_a_goal_was_judged() -> None:
    """Read back from the plan's own text the same table comes out: export fits it again."""
    wanted = wish(BUMP, BUMP + 4 * UM, fresh_tests(24, 11))
    out = _wanted_out(wanted)
    back = plan_validator(WantedCorrection).validate_python(json.loads(to_json(out)))
    assert "scenarios" not in _wanted_out(replace(wanted, scenarios=None))
    one, other = (fit(each, CONTROL, spacing=100.0, goal="A") for each in (wanted, back))
    assert np.array_equal(one.compensation.positive, other.compensation.positive)


@pytest.mark.parametrize("goal", ["A", "E", "M"])
def test_what_lies_between_targets_is_not_followed_at_those_that_were_drawn(
    goal: Literal["A", "E", "M"],
) -> None:
    """12 sets of targets, each in 8 tests: every test of a set shows the same wave of 7.3 mm, 2 µm,
    which nodes every 40 mm cannot hold. The goal costs nothing at other targets.
    """

    def drawn(sets: int, each: int, seed: int) -> Scenarios:
        rng = np.random.default_rng(seed)
        where = np.repeat(np.sort(rng.uniform(5.0, 795.0, (sets, 15)), axis=1), each, axis=0)
        wave = 2 * UM * np.sin(2 * np.pi * where / 7.3)
        shown = [wave + 0.1 * UM * rng.standard_normal(where.shape) for _ in range(2)]
        half = np.full(where.size, 0.2 * UM)
        return Scenarios(
            count=sets * each,
            positions=where.ravel(),
            positive=shown[0].ravel(),
            negative=shown[1].ravel(),
            half_positive=half,
            half_negative=half,
        )

    wanted = wish(BUMP, BUMP + 4 * UM, drawn(12, 8, 12))
    others = drawn(400, 1, 13)
    table, usual = (fit(wanted, CONTROL, spacing=40.0, goal=each) for each in (goal, "expected"))
    assert shown(table, wanted, others)[goal] < 1.01 * shown(usual, wanted, others)[goal]
