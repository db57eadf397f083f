"""Fresh tests by which a goal is judged, and what is told of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

from compwright.planning.axes import AxisWork, fit_all
from compwright.planning.fresh import Like, fresh_tests
from compwright.planning.goals import goal_told
from compwright.planning.scenarios import scenarios_of
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import no_compensation
from compwright.records.fitted import TableRequest
from planning_samples import UM, KnownAxis, axis_of, capacity_of, work_of

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

    return fit_all({"X": replace(work, planned=planned)}, capacity, "job.yaml")["X"]


def told(work: AxisWork) -> list[str]:
    table = work.planned.fitted
    assert table is not None
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, Like())
    return [finding.message for finding in goal_told(work, table.compensation.at, fresh)]


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
    assert len(np.unique(found.positions)) > 5 * m  # several sets of targets


def test_one_direction_has_tests_of_one_direction() -> None:
    work = work_of(BENT, one_way=True)
    dense = BENT.summary(np.linspace(0.0, 1000.0, 401))
    found = scenarios_of(work.results[0], work.posterior, dense, work.planned.axis)
    assert found.positive.size == found.positions.size
    assert found.negative.size == found.half_negative.size == 0


def test_a_goal_that_gains_is_told_with_both_numbers() -> None:
    """Two nodes under a bent error: E with the goal, and in brackets with the usual table."""
    work = fitted("E", 1000.0)
    (message,) = told(work)
    assert "made for the least E" in message
    mine, usual = (float(part.strip("(),")) for part in message.split("E ")[-1].split()[:2])
    assert mine < 0.97 * usual


def test_a_goal_that_gains_nothing_says_so() -> None:
    (message,) = told(fitted("A", 25.0))
    if "is the one of least A too" not in message:  # or it is nearly the same
        values = [part.strip("(),") for part in message.split("A ")[-1].split()[:2]]
        assert float(values[0]) == pytest.approx(float(values[1]), rel=0.01)


def test_without_a_goal_nothing_is_told() -> None:
    work = fitted("expected", 25.0)
    assert told(work) == []
    assert work.planned.wanted is not None
    assert work.planned.wanted.scenarios is None
