"""Fresh tests by which a goal is judged, and what is told of it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any, Literal

import numpy as np
import pytest

from compwright.evaluation.standards import evaluate
from compwright.planning.axis_fits import fit_all
from compwright.planning.axis_work import AxisWork, start_axis
from compwright.planning.goal_findings import goal_findings
from compwright.planning.scenarios import goal_improves, same_tables, scenarios_of
from compwright.planning.simulated_repeat_tests import RepeatConditions, fresh_tests
from compwright.prediction.active_corrections import no_correction
from compwright.records.axis import Axis, Direction
from compwright.records.capacity import Capacity
from compwright.records.correction import ControlState, no_compensation
from compwright.records.fitted_table import TableRequest
from compwright.records.job import AS_FOUND
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from planning_samples import (
    MINUS,
    PLUS,
    UM,
    KnownAxis,
    axis_of,
    by_slope,
    capacity_of,
    job_of,
    work_of,
)

pytestmark = pytest.mark.short_estimate

BENT = KnownAxis(
    lambda x: 12 * UM * (x / 1000.0) ** 4, lambda x: 12 * UM * (x / 1000.0) ** 4, noise=0.4 * UM
)


def fitted(goal: Literal["expected", "A", "E", "M"], spacing: float) -> AxisWork:
    axis = axis_of()
    work = work_of(BENT, axis, active=no_compensation(axis.address, axis.kind))
    request = TableRequest(start=0.0, end=1000.0, spacing=spacing, goal=goal)
    dense = BENT.summary(np.linspace(0.0, 1000.0, 401))
    planned = replace(work.planned, request=request, estimate=dense)

    def capacity(axis: Axis, *, one_curve: bool = False) -> Capacity:
        return replace(capacity_of(axis, one_curve=one_curve), quantum=1e-7)

    entry = replace(work.entry, table=request)
    return fit_all({"X": replace(work, entry=entry, planned=planned)}, capacity, "job.yaml")["X"]


def parameters(work: AxisWork) -> list[str]:
    table = work.planned.fitted
    assert table is not None
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, RepeatConditions())
    return [finding.message for finding in goal_findings(work, table.compensation.at, fresh)]


def test_scenarios_are_tests_like_the_one_that_was_measured() -> None:
    """Known error, readings of 0.4 µm, two of them: means scatter by 0.4 / sqrt(2), k s is 2 s."""
    work = work_of(BENT)
    dense = BENT.summary(np.linspace(0.0, 1000.0, 4001))
    found = scenarios_of(work.results[0], work.posterior, dense, work.planned.axis)
    m = work.results[0].test.targets.size
    assert found.positions.size == found.count * m
    assert np.all(np.diff(found.positions.reshape(found.count, m), axis=1) > 0.0)
    for beyond, half in (
        (found.positive, found.half_positive),
        (found.negative, found.half_negative),
    ):
        assert np.std(beyond) / UM == pytest.approx(0.4 / np.sqrt(2.0), rel=0.1)
        assert np.sqrt(np.mean(half**2)) / UM == pytest.approx(2 * 0.4, rel=0.1)
    assert len(np.unique(found.positions)) > 20 * m  # many sets of targets


def test_one_direction_has_tests_of_one_direction() -> None:
    work = work_of(BENT, one_way=True)
    dense = BENT.summary(np.linspace(0.0, 1000.0, 401))
    found = scenarios_of(work.results[0], work.posterior, dense, work.planned.axis)
    assert found.positive.size == found.positions.size
    assert found.negative.size == found.half_negative.size == 0


def test_one_reading_at_each_target_has_no_spread() -> None:
    """ISO 230-2, clause 5.2: from one approach per direction no repeatability follows."""
    work = work_of(BENT)
    test = work.results[0].test
    once = replace(
        test,
        positive=test.positive[:, :1],
        negative=test.negative[:, :1],
        runs_positive=(1,),
        runs_negative=(1,),
    )
    dense = BENT.summary(np.linspace(0.0, 1000.0, 401))
    found = scenarios_of(evaluate(once, "iso230-2:2014"), work.posterior, dense, work.planned.axis)
    assert found.half_positive.size == found.half_negative.size == found.positions.size
    assert not np.any(found.half_positive)
    assert not np.any(found.half_negative)


def test_a_goal_that_gains_is_told_with_both_numbers() -> None:
    """Two nodes under a bent error: E with the goal, and in brackets with the usual table."""
    work = fitted("E", 1000.0)
    (message,) = parameters(work)
    assert "made for the smallest E" in message
    mine, usual = (float(part.strip("(),")) for part in message.split("E ")[-1].split()[:2])
    assert mine < 0.97 * usual


def test_a_goal_that_gains_nothing_says_so() -> None:
    (message,) = parameters(fitted("A", 25.0))
    if "also gives the smallest A" not in message:  # or it is nearly the same
        values = [part.strip("(),") for part in message.split("A ")[-1].split()[:2]]
        assert float(values[0]) == pytest.approx(float(values[1]), rel=0.01)


def test_without_a_goal_nothing_is_told() -> None:
    work = fitted("expected", 25.0)
    assert parameters(work) == []
    assert work.planned.wanted is not None
    assert work.planned.wanted.scenarios is None


@cache
def with_a_wave(goal: Literal["expected", "A", "E", "M"]) -> AxisWork:
    """A wave of 10 mm that nobody named and a reversal that varies, by a test of 21 targets and
    five runs; nodes every 100 mm on a control with one table and a reversal value.
    """
    axis = axis_of(travel=(0.0, 800.0))
    rng = np.random.default_rng(4)
    x = np.sort(np.linspace(15.0, 785.0, 21) + rng.uniform(-9.0, 9.0, 21))
    error = 15e-6 * x + 5 * UM * np.sin(x / 70.0) + 1.5 * UM * np.sin(2 * np.pi * x / 10.0)
    lost = -4 * UM + 4 * UM * np.sin(x / 110.0)
    readings = [
        each[:, np.newaxis] + 0.4 * UM * rng.standard_normal((21, 5))
        for each in (error, error + lost)
    ]
    test = PositioningTest(
        axis="X",
        kind=axis.kind,
        targets=x,
        positive=readings[0],
        negative=readings[1],
        name="x",
        frame="machine",
    )
    request = TableRequest(start=0.0, end=800.0, spacing=100.0, mode="single", goal=goal)
    entry = replace(job_of(axis).axes["X"], table=request)
    state = no_compensation(axis.address, axis.kind)
    control = ControlState(format="any", axes={axis.address: state})
    job = replace(job_of(axis), axes={"X": entry})
    planned = (PlannedTest(test=test, measured_in=AS_FOUND),)
    work = start_axis(job, entry, planned, {AS_FOUND: control}, no_correction)

    def capacity(axis: Axis, *, one_curve: bool = False) -> Capacity:
        return replace(capacity_of(axis, one_curve=one_curve), quantum=1e-7)

    return fit_all({"X": work}, capacity, "job.yaml")["X"]


@pytest.mark.parametrize("goal", ["A", "E"])
def test_a_goal_does_no_harm_where_targets_do_not_show_all(goal: Literal["A", "E"]) -> None:
    """Over 40 sets of targets that nobody has seen, 10 tests each: the table for the goal has no
    more of it than the usual one, but for twice the error of such a mean.
    """
    tables = [with_a_wave(each) for each in ("expected", goal)]
    rng = np.random.default_rng(77)
    more = []
    for _ in range(40):
        x = np.sort(rng.uniform(4.0, 796.0, 21))
        drawn = tables[0].posterior.draw(x, 10, rng)
        noise = 0.4 * UM / np.sqrt(5.0) * rng.standard_normal((2, 10, 21))
        shown = []
        for work in tables:
            assert work.planned.fitted is not None
            at = work.planned.fitted.compensation.at
            means = np.stack([drawn.positive + at(x, PLUS), drawn.negative + at(x, MINUS)]) + noise
            half = 2 * 0.4 * UM if goal == "A" else 0.0
            shown.append(np.max(means + half, axis=(0, 2)) - np.min(means - half, axis=(0, 2)))
        more.append(float(np.mean(shown[1] - shown[0])))
    assert np.mean(more) < 2 * np.std(more) / np.sqrt(len(more)) + 1e-9


def test_only_what_fresh_tests_show_is_a_gain() -> None:
    work = work_of(KnownAxis(lambda x: 0.0 * x, lambda x: 0.0 * x, noise=0.4 * UM))
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, RepeatConditions())
    level = by_slope(0.0)

    def wavy(x: Any, way: Direction) -> Any:
        return 3 * UM * np.sin(np.asarray(x) / 40.0)

    def hardly(x: Any, way: Direction) -> Any:
        return 1e-3 * wavy(x, way)

    for goal in ("A", "E", "M"):
        assert goal_improves(goal, level, wavy, fresh)
        assert not goal_improves(goal, wavy, level, fresh)
        assert not goal_improves(goal, level, hardly, fresh)
        assert not goal_improves(goal, hardly, level, fresh)


def test_a_table_that_fresh_tests_do_not_bear_out_is_not_taken(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Nor when the plan is exported: there it asks for the least expected square."""
    monkeypatch.setattr("compwright.planning.axis_fits.goal_improves", lambda *_: False)
    work, usual = fitted("E", 1000.0), fitted("expected", 1000.0)
    assert work.planned.fitted is not None
    assert usual.planned.fitted is not None
    assert same_tables(work.planned.fitted, usual.planned.fitted)
    assert work.planned.request.goal == "expected"
    assert work.planned.wanted is not None
    assert work.planned.wanted.scenarios is None
    (message,) = parameters(work)
    assert "the table with the least expected squared error is used" in message
    assert "in brackets: with the table made for the smallest E" in message
