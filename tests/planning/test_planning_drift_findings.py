"""Drift and outliers of a test are told once, by the estimate where it tells them."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.evaluation.standards import evaluate
from compwright.planning.axis_work import AxisWork, start_axis
from compwright.prediction.active_corrections import no_correction
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from planning_samples import UM, axis_of, job_of, readings_of

pytestmark = pytest.mark.short_estimate


def started(*tests: PositioningTest) -> AxisWork:
    job = job_of(axis_of())
    planned = tuple(PlannedTest(test=test, measured_in="as_found") for test in tests)
    state = {"as_found": ControlState(format="any", axes={})}
    return start_axis(job, job.axes["X"], planned, state, no_correction)


def codes(work: AxisWork, place: int = 0) -> list[str]:
    return [each.code for each in (*work.results[place].findings, *work.findings)]


def drifting(name: str = "x", size: float = 8.0) -> PositioningTest:
    """Five runs that rise by ``size`` µm from the first to the last, 0.4 µm of noise."""
    rng = np.random.default_rng(5)
    rise = size * UM * np.arange(5) / 4.0
    blocks = [rise + 0.4 * UM * rng.standard_normal((11, 5)) for _ in range(2)]
    return readings_of(*blocks, name=name)


def spoilt() -> PositioningTest:
    rng = np.random.default_rng(6)
    blocks = [0.4 * UM * rng.standard_normal((11, 5)) for _ in range(2)]
    blocks[0][3, 1] += 20.0 * UM
    blocks[1][7, 4] -= 15.0 * UM
    return readings_of(*blocks)


def test_a_drift_is_told_once() -> None:
    assert "CW-T012" in [each.code for each in evaluate(drifting()).findings]
    told = codes(started(drifting()))
    assert [code for code in told if code in ("CW-T012", "CW-E020")] == ["CW-E020"]


def test_one_test_does_not_show_whether_its_drift_repeats_and_two_do() -> None:
    for tests, stated in (
        ((drifting(),), "knows only this one test"),
        ((drifting(), drifting("y", 5.0)), "allows for a drift that differs from test to test"),
    ):
        messages = [one.message for one in started(*tests).findings if one.code == "CW-E020"]
        assert messages
        assert all(stated in message for message in messages)


def test_a_drift_of_a_test_that_does_not_count_is_told_by_the_evaluation() -> None:
    """The second shows ten times the error the other way."""
    first = drifting()
    ramp = 40.0 * UM * np.sin(first.targets / 150.0)[:, np.newaxis]
    other = drifting("y")
    counting = readings_of(first.positive + ramp, first.negative + ramp)
    turned = readings_of(other.positive - 3 * ramp, other.negative - 3 * ramp, name="y")
    work = started(counting, turned)
    assert work.planned.tests[1].acted is None
    assert "CW-T012" not in [each.code for each in work.results[0].findings]
    assert "CW-T012" in [each.code for each in work.results[1].findings]


def test_outliers_are_told_once_and_the_result_without_them_stays() -> None:
    alone = next(each for each in evaluate(spoilt()).findings if each.code == "CW-T014")
    assert alone.severity == "warning"
    assert "run 2 in +" in alone.message
    work = started(spoilt())
    assert "CW-E024" in codes(work)
    (compared,) = [each for each in work.results[0].findings if each.code == "CW-T014"]
    assert compared.severity == "info"
    assert "run 2 in +" not in compared.message
    assert compared.message.endswith(alone.message[alone.message.index("A: ") :])
