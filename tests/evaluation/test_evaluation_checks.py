"""Findings about the plan of a test, edition by edition."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import ArrayLike

from compwright.evaluation.plan_checks import plan_findings
from compwright.evaluation.standards import evaluate
from compwright.records.axis import AxisKind
from compwright.records.positioning import Cycle, PositioningTest
from evaluation_samples import axis_test, noisy, printed_table
from places import STANDARD_TABLES, needs_shared


def planned(
    targets: ArrayLike, n: int = 5, *, kind: AxisKind = AxisKind.LINEAR, cycle: Cycle = "standard"
) -> PositioningTest:
    where = np.array(targets, dtype=np.float64)
    block = np.zeros((where.size, n))
    return axis_test(where, block, block, kind=kind, cycle=cycle)


def dithered(length: float, number: int) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Unequal intervals from 0 to ``length``."""
    targets = np.linspace(0.0, length, number)
    targets[1:-1] += 0.1 * length / number * np.sin(np.arange(1, number - 1))
    return targets


def codes(
    test: PositioningTest,
    standard: str = "iso230-2:2014",
    travel: tuple[float, float] | None = None,
    periods: tuple[float, ...] = (),
) -> list[str]:
    return [finding.code for finding in plan_findings(test, standard, travel, periods)]


@needs_shared
@pytest.mark.parametrize("edition", ["1988", "1997"])
def test_the_standards_own_examples_are_well_planned(edition: str) -> None:
    test = printed_table(STANDARD_TABLES / f"iso-230-2-{edition}-table-2.csv")
    assert codes(test, f"iso230-2:{edition}") == []


@pytest.mark.parametrize(
    ("length", "number", "enough"),
    [
        (400, 4, False),
        (400, 5, True),
        (1500, 7, False),
        (1500, 8, True),
        (2000, 9, False),
        (2000, 10, True),
    ],
)
def test_five_targets_per_metre(length: float, number: int, *, enough: bool) -> None:
    assert ("CW-T002" not in codes(planned(dithered(length, number)))) is enough


@pytest.mark.parametrize(
    ("last", "number", "enough"),
    [
        (90, 2, False),
        (90, 3, True),
        (91, 4, False),
        (180, 5, True),
        (181, 7, False),
        (315, 8, True),
        (360, 8, True),
    ],
)
def test_rotary_targets_since_1997(last: float, number: int, *, enough: bool) -> None:
    test = planned(np.linspace(0.0, last, number), kind=AxisKind.ROTARY)
    for standard in ("iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "gost27843:2006"):
        assert ("CW-T002" not in codes(test, standard)) is enough


def test_rotary_targets_of_1988() -> None:
    principal = [0.0, 90.0, 180.0, 270.0]
    good = planned(sorted([*principal, 33.0, 141.0, 300.5]), kind=AxisKind.ROTARY)
    assert codes(good, "iso230-2:1988") == []
    assert codes(good, "iso230-2:2006") == ["CW-T002"]  # seven are fewer than eight
    assert codes(planned(sorted([*principal, 33.0]), kind=AxisKind.ROTARY), "iso230-2:1988") == [
        "CW-T002"
    ]


def test_principal_positions() -> None:
    eight = [7.0, 45.0, 90.0, 150.0, 180.0, 215.0, 270.0, 352.0]
    assert "CW-T004" not in codes(planned(eight, kind=AxisKind.ROTARY))  # 0° was not measured past
    without_90 = [0.0, 45.0, 93.0, 150.0, 180.0, 215.0, 270.0, 352.0]
    finding = next(
        f
        for f in plan_findings(planned(without_90, kind=AxisKind.ROTARY), "iso230-2:2014", None, ())
        if f.code == "CW-T004"
    )
    assert "90°" in finding.message
    assert "180°" not in finding.message
    assert "CW-T004" not in codes(
        planned([-180.0, -133.0, -90.0, -33.0, 0.0, 45.0, 90.0, 122.0], kind=AxisKind.ROTARY)
    )  # -90 is 270


def test_number_of_runs() -> None:
    assert codes(planned(dithered(500, 6), 3)) == ["CW-T001"]
    assert codes(planned(dithered(500, 6), 1)) == ["CW-T001"]  # a short axis needs five
    assert codes(planned(dithered(500, 6), 7)) == ["CW-T001"]


def test_long_linear_axes_have_two_tests() -> None:
    whole = planned(dithered(3000, 13), 1)
    assert codes(whole) == ["CW-T005"]  # says that the test over 2 000 mm belongs to it
    assert codes(planned(dithered(3000, 10), 1)) == ["CW-T005", "CW-T006"]  # mean interval 333 mm
    assert codes(planned(dithered(3120, 13), 1)) == ["CW-T005", "CW-T006"]  # 12 intervals of 260 mm
    repeated = plan_findings(planned(dithered(3000, 16), 5), "iso230-2:2014", None, ())
    assert [(finding.code, finding.severity) for finding in repeated] == [("CW-T005", "warning")]
    part = codes(planned(500.0 + dithered(2000, 11), 5), travel=(0.0, 3000.0))
    assert part == ["CW-T005"]
    # just 2 000 mm with n = 5 is what the standard asks for: no warning
    span = planned(500.0 + np.r_[0.0, dithered(1800, 9) + 100.0, 2000.0], 5)
    (said,) = [
        finding
        for finding in plan_findings(span, "iso230-2:2014", (0.0, 3000.0), ())
        if finding.code == "CW-T005"
    ]
    assert said.severity == "info"
    assert codes(planned(dithered(2000, 11), 5)) == []


def test_the_other_test_of_a_long_axis_is_missed_only_where_it_is_missing() -> None:
    whole = planned(dithered(4000, 17), 1)
    part = planned(500.0 + dithered(2000, 11), 5)
    over_all = planned(dithered(4000, 21), 5)

    def said(test: PositioningTest, *beside: PositioningTest) -> list[str]:
        found = plan_findings(test, "iso230-2:2014", (0.0, 4000.0), (), beside)
        return [finding.message for finding in found if finding.code == "CW-T005"]

    assert said(whole, part) == said(part, whole) == []
    assert "five approaches per direction" in said(whole)[0]
    assert "five approaches per direction" in said(whole, whole)[0]
    assert "whole length" in said(part)[0]
    assert "whole length" in said(part, part)[0]
    assert "repeats its approaches" in said(over_all, whole)[0]  # whatever there is beside it


def test_long_rotary_axes_by_edition() -> None:
    turns = planned(
        np.arange(0.0, 721.0, 45.0) + np.tile([0.0, 2.0], 9)[:17] * (np.arange(17) % 2),
        1,
        kind=AxisKind.ROTARY,
    )
    assert "CW-T006" in codes(turns, "iso230-2:1997")  # an interval of 47° is over 45°
    assert "CW-T006" in codes(turns, "gost27843:2006")
    assert "CW-T006" not in codes(turns, "iso230-2:2006")  # 17 targets over two turns
    assert "CW-T006" not in codes(turns, "iso230-2:2014")
    assert "CW-T005" not in codes(turns, "iso230-2:1988")  # no rule of its own
    sparse = planned(np.arange(0.0, 721.0, 60.0), 1, kind=AxisKind.ROTARY)
    assert "CW-T006" in codes(sparse, "iso230-2:2014")
    six_turns = planned(np.arange(0.0, 2161.0, 45.0), 1, kind=AxisKind.ROTARY)
    assert "CW-T006" in codes(six_turns, "iso230-2:2014")


def test_equal_spacing() -> None:
    grid = planned(np.arange(0.0, 501.0, 50.0))
    assert codes(grid) == ["CW-T008"]
    assert [f.severity for f in plan_findings(grid, "iso230-2:2014", None, ())] == ["info"]


@pytest.mark.parametrize(
    ("period", "hides"), [(10.0, True), (5.0, True), (100.0, True), (8.0, False), (16.0, False)]
)
def test_spacing_at_a_multiple_of_the_known_period(period: float, *, hides: bool) -> None:
    """On a 50 mm grid: 10 and 5 mm fall on one phase, 100 mm on two opposite ones; 8 and 16 mm on
    four and eight.
    """
    found = plan_findings(planned(np.arange(0.0, 501.0, 50.0)), "iso230-2:2014", None, (period,))
    assert [finding.code for finding in found] == ["CW-T008"] * hides
    assert all(finding.severity == "warning" for finding in found)


def test_random_offsets_show_the_period() -> None:
    targets = np.arange(0.0, 501.0, 50.0) + np.random.default_rng(2).uniform(-15.0, 15.0, 11)
    assert codes(planned(targets), periods=(10.0,)) == []


def test_travel() -> None:
    test = planned(dithered(500, 6))
    assert codes(test, travel=(-50.0, 540.0)) == []
    assert codes(test, travel=(-150.0, 540.0)) == [
        "CW-T007"
    ]  # 150 mm is more than one interval of 100 mm
    outside = plan_findings(test, "iso230-2:2014", (-500.0, 0.0), ())
    assert [(f.code, f.severity) for f in outside] == [("CW-T007", "warning")]


def test_step_cycle_and_one_direction() -> None:
    assert codes(planned(dithered(500, 6), cycle="step")) == ["CW-T009"]
    one_way = axis_test(dithered(500, 6), np.zeros((6, 5)))
    assert codes(one_way) == ["CW-T003"]


def test_findings_reach_the_result_and_never_refuse() -> None:
    result = evaluate(
        planned([0.0, 50.0], 1, cycle="step"),
        "iso230-2:2006",
        travel=(-900.0, 900.0),
        periods=(50.0,),
    )
    assert {"CW-T001", "CW-T002", "CW-T007", "CW-T009"} <= {
        finding.code for finding in result.findings
    }


def test_a_drift_in_the_step_cycle_goes_into_E_and_M() -> None:  # noqa: N802
    """Physics behind CW-T009: 11 targets one after the other, five readings per direction at each,
    a drift linear in time.
    """
    count, size = 11, 10e-3
    time = np.arange(count * 10).reshape(count, 10) / (count * 10 - 1)  # readings alternate + and -
    test = axis_test(
        np.arange(count) * 50.0, size * time[:, 0::2], size * time[:, 1::2], cycle="step"
    )
    parameters = evaluate(test).parameters
    assert parameters["M"] == pytest.approx(0.92 * size, rel=0.01)
    assert parameters["E"] == pytest.approx(0.92 * size, rel=0.02)
    assert (parameters["R"] or 0.0) < 0.15 * size


def test_a_sound_test_has_no_findings() -> None:
    assert evaluate(noisy(np.random.default_rng(8))).findings == ()
