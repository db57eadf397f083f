"""Circles beside the laser: every sign by what the tool does at the machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from compwright.planning.axis_work import AxisWork
from compwright.planning.circle_checks import (
    CircleChecks,
    laser_values,
    lost_motion,
    mismatch,
    scale_error,
)
from compwright.planning.circles import CircleWork
from compwright.planning.value_with_error import ValueWithError
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.records.axis import AxisKind
from compwright.records.conditions import UncertaintyBudget
from compwright.records.correction import AxisCompensation
from compwright.records.job import ApplyRequest
from planning_samples import (
    MINUS,
    PPM,
    UM,
    KnownAxis,
    axis_of,
    by_slope,
    circle_of,
    job_of,
    work_of,
)

#: 20 µm/m too long, and 5 µm behind its direction when it arrives in -: it then stands too high.
LAGS = KnownAxis(lambda x: 20e-6 * x, lambda x: 20e-6 * x + 5.0 * UM)
FROM_CIRCLE = ApplyRequest(backlash_from="circle")


def checks_of(
    works: Mapping[str, AxisWork],
    states: Mapping[str, ActiveCorrections] | None = None,
    **words: Any,
) -> CircleChecks:
    axes = [work.planned.axis for work in works.values()]
    return CircleChecks(job_of(*axes, **words), works, states or {"as_found": NO_CORRECTIONS})


def codes(checks: CircleChecks, *circles: CircleWork) -> list[str]:
    return [finding.code for finding in checks.findings(circles)]


@pytest.mark.parametrize("index", [0, 1])
def test_an_axis_that_stays_behind_has_lost_motion_above_zero(index: int) -> None:
    found = laser_values(circle_of({}), work_of(LAGS), index, NO_CORRECTIONS)
    assert found.lost_motion.value == pytest.approx(5.0 * UM)
    assert found.scale.value == pytest.approx(20.0 * PPM)


def test_a_control_that_acted_during_the_circle_alone_is_counted_with() -> None:
    """It took 2 µm of the lost motion away and 15 µm/m of the scale, while the circle was
    measured.
    """
    during = ActiveCorrections({"X": by_slope(-15e-6, lost=-2.0 * UM)}, {})
    found = laser_values(circle_of({}), work_of(LAGS), 0, during)
    assert found.lost_motion.value == pytest.approx(3.0 * UM)
    assert found.scale.value == pytest.approx(5.0 * PPM)


def test_a_control_that_acted_during_the_laser_alone_is_counted_back() -> None:
    table = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=np.array([0.0, -15.0 * UM]),
        negative=np.array([0.0, -15.0 * UM]),
        backlash=2.0 * UM,
    )
    found = laser_values(circle_of({}), work_of(LAGS, active=table), 0, NO_CORRECTIONS)
    assert found.lost_motion.value == pytest.approx(7.0 * UM)  # -2 µm in - were in the readings
    assert found.scale.value == pytest.approx(35.0 * PPM)


def test_the_scale_is_that_between_the_two_ends_of_the_circle() -> None:
    """Bent by 1 nm/mm²: between 300 and 500 about the centre 400 the slope is 800 nm/mm."""
    bent = KnownAxis(lambda x: 1e-6 * x**2, lambda x: 1e-6 * x**2)
    found = laser_values(circle_of({}, centre=(400.0, 900.0)), work_of(bent), 0, NO_CORRECTIONS)
    assert found.scale.value == pytest.approx(800e-6)
    second = laser_values(circle_of({}, centre=(400.0, 900.0)), work_of(bent), 1, NO_CORRECTIONS)
    assert second.scale.value == pytest.approx(1800e-6)


def test_the_laser_itself_may_be_off_by_half_of_what_its_certificate_says() -> None:
    """U of 1 µm/m with k = 2 is a standard uncertainty of 0.5 µm/m."""
    budget = UncertaintyBudget(device_per_m=1.0)
    checks = checks_of({"X": work_of(LAGS)}, uncertainty=budget)
    laser = checks.laser(circle_of({}), 0)
    assert laser is not None
    assert laser.scale.std_error == pytest.approx(0.5 * PPM, rel=1e-3)


def test_an_axis_measured_in_one_direction_says_nothing_of_lost_motion() -> None:
    checks = checks_of({"X": work_of(LAGS, one_way=True)})
    assert checks.laser(circle_of({}), 0) is None
    assert checks.laser(circle_of({}), 1) is None  # Y has no test at all


def test_units_of_a_diagnosis() -> None:
    """µm of lost motion, µm/m of scale, µm over the diameter of mismatch: 8 µm over 200 mm."""
    circle = circle_of(
        {
            "backlash_second": (4.0, 0.5),
            "scale_error_first": (12.0, 2.0),
            "scale_mismatch": (8.0, 1.0),
        }
    )
    assert lost_motion(circle, 1) == ValueWithError(4.0 * UM, 0.5 * UM)
    assert lost_motion(circle, 0) is None
    assert scale_error(circle, 0) == ValueWithError(12.0 * PPM, 2.0 * PPM)
    between = mismatch(circle)
    assert between is not None
    assert (between.value, between.std_error) == pytest.approx((40.0 * PPM, 5.0 * PPM))


@pytest.mark.parametrize(("value", "told"), [(5.9, False), (6.1, True), (4.1, False), (3.9, True)])
def test_lost_motion_beyond_both_uncertainties_is_told(value: float, *, told: bool) -> None:
    """The laser says 5 µm; two standard errors of the circle are 1 µm."""
    circle = circle_of({"backlash_first": (value, 0.5)})
    assert (codes(checks_of({"X": work_of(LAGS)}), circle) == ["CW-P114"]) is told


def test_which_one_counts_is_said() -> None:
    circle = circle_of({"backlash_first": (9.0, 0.5)})
    for apply, word in ((ApplyRequest(), "laser"), (FROM_CIRCLE, "circle")):
        checks = checks_of({"X": work_of(LAGS)}, apply=apply)
        (finding,) = checks.findings([circle])
        assert f"value of the {word} is used" in finding.message
        assert (
            "+5.00 ± 0.00 µm according to the laser, and +9.00 ± 0.50 µm according to circle"
            in finding.message
        )


def test_a_scale_is_that_of_the_range_which_the_circle_covers() -> None:
    """Radius 100 mm about X 400: an axis of another slope elsewhere agrees with its laser there."""
    bent = KnownAxis(lambda x: 1e-6 * x**2, lambda x: 1e-6 * x**2)
    circle = circle_of({"scale_error_first": (900.0, 2.0)}, centre=(400.0, 900.0))
    (finding,) = checks_of({"X": work_of(bent)}).findings([circle])
    assert "the scale from 300 to 500 mm, where" in finding.message
    assert "+800.0 ± 0.0 µm/m according to the laser" in finding.message


@pytest.mark.parametrize(("value", "told"), [(15.9, True), (16.1, False), (24.1, True)])
def test_a_scale_beyond_both_uncertainties_is_told(value: float, *, told: bool) -> None:
    circle = circle_of({"scale_error_first": (value, 2.0)})
    assert (codes(checks_of({"X": work_of(LAGS)}), circle) == ["CW-P115"]) is told


def test_the_mismatch_is_the_first_axis_less_the_second() -> None:
    """X 20 µm/m, Y -10: over 200 mm the first diameter is 6 µm the longer one."""
    other = KnownAxis(lambda x: -10e-6 * x, lambda x: -10e-6 * x)
    works = {"X": work_of(LAGS), "Y": work_of(other, axis_of("Y"))}
    assert codes(checks_of(works), circle_of({"scale_mismatch": (6.0, 0.5)})) == []
    assert codes(checks_of(works), circle_of({"scale_mismatch": (4.0, 0.5)})) == ["CW-P116"]
    assert codes(checks_of(works), circle_of({"scale_mismatch": (-0.5, 0.05)})) == ["CW-P116"]
    assert codes(checks_of(works), circle_of({"scale_mismatch": (-6.0, 0.5)})) == ["CW-P172"]
    turned = circle_of({"scale_mismatch": (-6.0, 0.5)}, ("Y", "X"))
    assert codes(checks_of(works), turned) == []


@pytest.mark.parametrize("way", ["+", "-"])
def test_lost_motion_from_the_circle_leaves_the_zero_state_alone(way: str) -> None:
    """8 µm by the circle, 5 by the laser: 3 more, all of them against the direction of the
    reference return.
    """
    axis = axis_of(reference_return=MINUS if way == "-" else axis_of().reference_return)
    work = work_of(LAGS, axis)
    checks = checks_of({"X": work}, apply=FROM_CIRCLE)
    works, findings = checks.with_circle_backlash([circle_of({"backlash_first": (8.0, 0.5)})])
    old, new = work.planned.estimate, works["X"].planned.estimate
    np.testing.assert_allclose(new.mean_negative - new.mean_positive, 8.0 * UM)
    kept = "mean_negative" if way == "-" else "mean_positive"
    np.testing.assert_array_equal(getattr(new, kept), getattr(old, kept))
    assert [finding.code for finding in findings] == ["CW-P117"]
    assert "from the laser's value by +3.00 ± 0.50 µm" in findings[0].message


def test_circles_are_weighted_by_their_uncertainty() -> None:
    """6 ± 1 and 11 ± 2 µm: weights 4 to 1, so 7 µm; their error is 1/sqrt(1.25) = 0.894 µm."""
    circles = [
        circle_of({"backlash_first": (6.0, 1.0)}),
        circle_of({"backlash_second": (11.0, 2.0)}, ("Y", "X"), name="other"),
        circle_of({"backlash_first": (99.0, 0.1)}, ("Y", "Z"), name="beside"),
    ]
    checks = checks_of({"X": work_of(LAGS)}, apply=FROM_CIRCLE)
    works, findings = checks.with_circle_backlash(circles)
    estimate = works["X"].planned.estimate
    np.testing.assert_allclose(estimate.mean_negative - estimate.mean_positive, 7.0 * UM)
    assert "+2.00 ± 0.89 µm" in findings[0].message


def test_without_the_wish_of_the_job_the_laser_stays() -> None:
    checks = checks_of({"X": work_of(LAGS)})
    works, findings = checks.with_circle_backlash([circle_of({"backlash_first": (8.0, 0.5)})])
    assert works == checks.works
    assert findings == ()


def test_a_wish_that_no_circle_can_fulfil_is_an_error() -> None:
    checks = checks_of({"X": work_of(LAGS)}, apply=FROM_CIRCLE)
    _, beside = checks.with_circle_backlash([circle_of({"backlash_first": (8.0, 0.5)}, ("Y", "Z"))])
    assert [(finding.code, finding.severity) for finding in beside] == [
        ("CW-P130", "warning"),
        ("CW-P130", "error"),
    ]
    _, silent = checks.with_circle_backlash([circle_of({})])
    assert [finding.severity for finding in silent] == ["error", "error"]


def test_an_axis_without_a_test_has_no_table_to_put_lost_motion_into() -> None:
    axes = (axis_of(), axis_of("Y"))
    job = job_of(*axes, untested=("Y",), apply=FROM_CIRCLE)
    checks = CircleChecks(job, {"X": work_of(LAGS)}, {"as_found": NO_CORRECTIONS})
    circle = circle_of({"backlash_first": (8.0, 0.5), "backlash_second": (3.0, 0.5)})
    _, findings = checks.with_circle_backlash([circle])
    assert [finding.code for finding in findings] == ["CW-P130", "CW-P117"]
    assert findings[0].message.startswith(
        "Y: the lost motion that the circles show is not corrected"
    )
    # A job of circles only: they show the lost motion of both axes.
    job = job_of(*axes, untested=("X", "Y"), apply=FROM_CIRCLE)
    _, findings = CircleChecks(job, {}, checks.states).with_circle_backlash([circle])
    assert [finding.message.partition(" is not ")[2][:9] for finding in findings] == [
        "corrected"
    ] * 2
