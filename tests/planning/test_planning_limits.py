"""Limits of a job against what is predicted and what was measured, by hand numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest

from compwright.foundations.errors import UsageError
from compwright.planning.limit_decisions import (
    accept_decisions,
    accepted_index,
    check_limits,
    lacking_guard,
    magnitude,
    measured_decisions,
)
from compwright.records.axis import AxisKind
from compwright.records.conditions import UncertaintyBudget
from compwright.records.job import Acceptance, AxisJob, TestRequest
from compwright.records.prediction import AcceptDecision, Quantiles, TestPrediction
from compwright.records.result import ExpandedUncertainty, PositioningResult
from planning_samples import UM, KnownAxis, axis_of, job_of, work_of

Rule = Literal["simple", "guarded"]
RESULT = work_of(KnownAxis(np.zeros_like, np.zeros_like)).results[0]
ARCSEC = 1.0 / 3600.0  # deg


def result_of(
    name: str = "x", U: float | None = None, **parameters: float | None
) -> PositioningResult:
    """A test with these parameters, µm; ``U`` of all of them, µm."""
    return replace(
        RESULT,
        test=replace(RESULT.test, name=name),
        parameters={
            key: None if value is None else value * UM for key, value in parameters.items()
        },
        uncertainty=None if U is None else {key: ExpandedUncertainty(U * UM) for key in parameters},
    )


def entry_of(limits: dict[str, float], test: str | None = None, **axis: Any) -> AxisJob:
    requests = tuple(TestRequest(files=(f"{name}.csv",), name=name) for name in ("x", "y"))
    accept = Acceptance(limits=limits, test=test)
    return AxisJob(axis=axis_of(**axis), before=requests, accept=accept)


def predicted(p05: float, p95: float, name: str = "x", U: float | None = None) -> TestPrediction:
    """A prediction of A, µm, with its U; that of the measured test is another one."""
    quantiles = Quantiles((p05 + p95) / 2.0 * UM, p05 * UM, p95 * UM)
    return TestPrediction(
        name=name,
        before=result_of(name, 0.1, A=20.0),
        predicted={"A": quantiles},
        predicted_new_targets={},
        uncertainty=None if U is None else {"A": ExpandedUncertainty(U * UM)},
    )


def decided(entry: AxisJob, *tests: TestPrediction, rule: Rule = "simple") -> AcceptDecision:
    return accept_decisions(entry, tests, rule)["A"]


@pytest.mark.parametrize(
    ("p05", "p95", "decision"),
    [
        (5.0, 7.9, "accept"),
        (5.0, 8.1, "undecided"),
        (7.9, 12.0, "undecided"),
        (8.1, 12.0, "reject"),
        (-7.9, -5.0, "accept"),  # a limit bounds the size
        (-12.0, -8.1, "reject"),
        (-9.0, 1.0, "undecided"),
    ],
)
def test_nineteen_of_twenty_fresh_tests_decide(p05: float, p95: float, decision: str) -> None:
    assert decided(entry_of({"A": 8.0}), predicted(p05, p95)).decision == decision


@pytest.mark.parametrize(
    ("p05", "p95", "decision"),
    [
        (5.0, 5.9, "accept"),
        (5.0, 6.1, "undecided"),
        (9.9, 12.0, "undecided"),
        (10.1, 12.0, "reject"),
    ],
)
def test_a_guarded_decision_keeps_the_uncertainty_away_from_the_limit(
    p05: float, p95: float, decision: str
) -> None:
    found = decided(entry_of({"A": 8.0}), predicted(p05, p95, U=2.0), rule="guarded")
    assert (found.decision, found.U, found.rule, found.limit) == (decision, 2.0, "guarded", 8.0)
    assert decided(entry_of({"A": 8.0}), predicted(5.0, 7.9, U=2.0)).U is None  # simple


def test_a_guard_of_nothing_decides_nothing() -> None:
    for p05, p95 in ((1.0, 2.0), (90.0, 99.0)):
        found = decided(entry_of({"A": 8.0}), predicted(p05, p95), rule="guarded")
        assert (found.decision, found.U) == ("undecided", None)


def test_the_guard_counts_at_new_targets_too() -> None:
    """Limit 8, U 1 µm: at the same targets 6 keeps it; at new ones 7.5 does not, 6.5 does."""
    for p95, decision in ((7.5, "undecided"), (6.5, "accept")):
        new = {"A": Quantiles(median=6.0 * UM, p05=5.0 * UM, p95=p95 * UM)}
        test = replace(predicted(4.0, 6.0, U=1.0), predicted_new_targets=new)
        found = accept_decisions(entry_of({"A": 8.0}), (test,), "guarded")["A"]
        assert found.decision == decision


def test_limits_speak_of_the_first_test_or_the_one_that_is_named() -> None:
    tests = (predicted(1.0, 2.0, "x"), predicted(9.0, 12.0, "y"))
    first, second = (
        decided(entry_of({"A": 8.0}), *tests),
        decided(entry_of({"A": 8.0}, "y"), *tests),
    )
    assert (first.decision, first.test) == ("accept", None)
    assert (second.decision, second.test) == ("reject", "y")
    assert accepted_index(Acceptance(limits={}, test="y"), ("x", "y")) == 1
    assert accept_decisions(replace(entry_of({}), accept=None), tests, "simple") == {}


def test_limits_of_a_rotary_axis_are_arcseconds() -> None:
    arcs = replace(
        predicted(0.0, 0.0), predicted={"A": Quantiles(6.0 * ARCSEC, 5.0 * ARCSEC, 7.0 * ARCSEC)}
    )
    assert decided(entry_of({"A": 8.0}, kind=AxisKind.ROTARY), arcs).decision == "accept"
    assert decided(entry_of({"A": 4.0}, kind=AxisKind.ROTARY), arcs).decision == "reject"


@pytest.mark.parametrize(
    ("given", "size"),
    [
        ((2.0, 1.0, 3.0), (2.0, 1.0, 3.0)),
        ((-2.0, -3.0, -1.0), (2.0, 1.0, 3.0)),
        ((0.5, -1.0, 3.0), (0.5, 0.0, 3.0)),
        ((-0.5, -3.0, 1.0), (0.5, 0.0, 3.0)),
    ],
)
def test_the_size_of_a_value_with_a_sign(
    given: tuple[float, float, float], size: tuple[float, float, float]
) -> None:
    """Each as (median, 5 %, 95 %)."""
    assert magnitude(Quantiles(*given)) == Quantiles(*size)


def test_a_limit_on_what_the_test_does_not_have_is_a_fault_of_the_job() -> None:
    entry = entry_of({"A": 8.0, "M": 3.0})
    result = replace(result_of(A=5.0, M=None), not_applicable={"M": "one direction"})
    with pytest.raises(UsageError) as caught:
        check_limits(job_of(axis_of()), entry, (result,))
    (fault,) = caught.value.faults
    assert (fault.place, fault.expected, fault.found) == (
        "axes.X.accept.M",
        "one of A",
        "one direction",
    )
    check_limits(job_of(axis_of()), replace(entry, accept=None), (result,))


def test_the_test_that_the_limits_name_is_the_one_that_must_have_them() -> None:
    results = (result_of("x", A=5.0, M=None), result_of("y", A=5.0, M=2.0))
    check_limits(job_of(axis_of()), entry_of({"M": 3.0}, "y"), results)
    with pytest.raises(UsageError, match="gives no value of M for the test x"):
        check_limits(job_of(axis_of()), entry_of({"M": 3.0}), results)


def test_a_guarded_decision_asks_for_an_uncertainty() -> None:
    entry, result = entry_of({"A": 8.0}), result_of(A=5.0)
    with pytest.raises(UsageError, match="needs the measurement uncertainty"):
        check_limits(job_of(axis_of(), decision_rule="guarded"), entry, (result,))
    known = job_of(axis_of(), decision_rule="guarded", uncertainty=UncertaintyBudget(device=0.5))
    check_limits(known, entry, (result,))


@pytest.mark.parametrize(
    ("standard", "kind", "words"),
    [
        ("vdi3441", AxisKind.LINEAR, "VDI/DGQ 3441"),
        ("iso230-2:2014", AxisKind.ROTARY, "uncertainty.rotary"),
        ("iso230-2:2014", AxisKind.LINEAR, "device.U in µm"),
    ],
)
def test_what_to_give_for_a_guard(standard: str, kind: AxisKind, words: str) -> None:
    (finding,) = lacking_guard(axis_of(kind=kind), standard, ["A", "E"])
    assert finding.code == "CW-P132"
    assert words in finding.message
    assert "the uncertainty U of A, E, which is unknown" in finding.message
    assert lacking_guard(axis_of(), standard, []) == ()


def after(
    value: float | None,
    U: float | None = None,
    rule: Rule = "simple",
    *,
    believed: bool = True,
    proven: bool = True,
) -> AcceptDecision:
    result = result_of(U=U, A=value)
    entry = entry_of({"A": 8.0})
    return measured_decisions(entry, result, rule, believed=believed, proven=proven)["A"]


@pytest.mark.parametrize(
    ("value", "U", "rule", "decision"),
    [
        (7.9, None, "simple", "accept"),
        (8.1, None, "simple", "reject"),
        (-8.1, None, "simple", "reject"),  # a limit bounds the size
        (-7.9, None, "simple", "accept"),
        (7.9, 2.0, "simple", "accept"),
        (5.9, 2.0, "guarded", "accept"),
        (6.1, 2.0, "guarded", "undecided"),
        (10.1, 2.0, "guarded", "reject"),
        (1.0, None, "guarded", "undecided"),
        (None, None, "simple", "undecided"),
    ],
)
def test_the_value_after_loading_decides(
    value: float | None, U: float | None, rule: Rule, decision: str
) -> None:
    found = after(value, U, rule)
    assert (found.decision, found.limit, found.U, found.rule) == (decision, 8.0, U, rule)
    assert found.value == (None if value is None else pytest.approx(value))


def test_readings_that_are_not_believed_decide_nothing_and_thin_ones_accept_nothing() -> None:
    assert after(1.0, believed=False).decision == "undecided"
    assert after(99.0, believed=False).decision == "undecided"
    assert after(1.0, proven=False).decision == "undecided"
    assert after(99.0, proven=False).decision == "reject"


def test_another_test_than_the_limits_speak_of_decides_nothing() -> None:
    for test, told in ((None, True), ("x", True), ("y", False)):
        entry = entry_of({"A": 8.0}, test)
        found = measured_decisions(entry, result_of(A=1.0), "simple", believed=True, proven=True)
        assert bool(found) is told
    none = replace(entry_of({}), accept=None)
    assert measured_decisions(none, result_of(A=1.0), "simple", believed=True, proven=True) == {}
