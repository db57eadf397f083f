"""The scale of an axis that no laser measured, from circles whose scale is known."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from compwright.foundations.errors import CapacityError, Fault
from compwright.planning.axis_work import AxisWork, CapacityOf
from compwright.planning.circle_checks import CircleChecks
from compwright.planning.circles import CircleWork
from compwright.planning.scale import ScaleCorrection, correct_scales, scale_steps, shrinking
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.job import ApplyRequest
from planning_samples import (
    PLUS,
    PPM,
    UM,
    KnownAxis,
    axis_of,
    by_slope,
    capacity_of,
    circle_of,
    job_of,
    work_of,
)

EMPTY = ControlState(format="any", axes={})
Y = axis_of("Y")


def scaled(
    *circles: CircleWork,
    works: Mapping[str, AxisWork] | None = None,
    states: Mapping[str, ActiveCorrections] | None = None,
    state: ControlState = EMPTY,
    axis: Axis = Y,
    capacity: CapacityOf = capacity_of,
) -> ScaleCorrection:
    apply = ApplyRequest(scale=(axis.name,))
    job = job_of(axis_of(), axis, untested=(axis.name,), apply=apply)
    checks = CircleChecks(job, works or {}, states or {"as_found": NO_CORRECTIONS})
    (found,) = correct_scales(job, circles, checks, capacity, state)
    return found


def slope_of(found: ScaleCorrection) -> float:
    """What the table does, mm/mm, between 100 and 900 mm."""
    assert found.planned is not None
    assert found.planned.fitted is not None
    at = found.planned.fitted.compensation.at(np.array([100.0, 900.0]), PLUS)
    return float(np.diff(at)[0]) / 800.0


def test_the_softest_loop_shrinks_a_circle_by_a_known_part() -> None:
    """100 mm/s at Kv 16.67 1/s lag 6 mm; of a radius of 100 mm that is 6²/(2·100²) = 1.8e-3."""
    assert shrinking(circle_of({}, feed=6000.0)) == pytest.approx(1.8e-3)
    assert shrinking(circle_of({}, feed=6000.0, radius=200.0)) == pytest.approx(0.45e-3)


def test_a_scale_at_a_low_feed_is_taken_away_about_the_reference() -> None:
    """50 µm/m too long: 1000 mm are 50 µm too far, so the table draws them back."""
    found = scaled(circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0))
    assert found.finding.code == "CW-P120"
    assert (
        "scale error +50.0 ± 2.0 µm/m according to circular test circle at a low feed"
        in found.finding.message
    )
    assert slope_of(found) == pytest.approx(-50.0 * PPM, abs=0.2 * PPM)
    assert found.planned is not None
    assert found.planned.fitted is not None
    assert float(found.planned.fitted.compensation.at(np.zeros(1), PLUS)[0]) == 0.0


def test_the_table_is_zero_at_a_reference_in_the_middle() -> None:
    axis = axis_of("Y", reference=400.0)
    found = scaled(circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0), axis=axis)
    assert found.planned is not None
    assert found.planned.wanted is not None
    wanted = np.interp(
        [0.0, 400.0, 1000.0], found.planned.wanted.positions, found.planned.wanted.positive
    )
    np.testing.assert_allclose(wanted, [20.0 * UM, 0.0, -30.0 * UM], atol=1e-9)
    assert found.planned.estimate.std_positive[-1] == pytest.approx(600.0 * 2.0 * PPM)


def test_what_is_in_the_control_stays_in_the_total() -> None:
    """The control already draws back 30 µm/m and the axis is 50 µm/m too long with it: -80."""
    table = AxisCompensation(
        address="Y",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=np.array([0.0, -30.0 * UM]),
        negative=np.array([0.0, -30.0 * UM]),
    )
    state = ControlState(format="any", axes={"Y": table})
    acts = {"as_found": ActiveCorrections({"Y": table.at}, {})}
    circle = circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0)
    found = scaled(circle, state=state, states=acts)
    assert slope_of(found) == pytest.approx(-80.0 * PPM, abs=0.2 * PPM)


def test_a_circle_of_another_state_is_brought_to_what_acts_now() -> None:
    """Measured while the control drew back 30 µm/m, it showed 50; now nothing acts: 80."""
    states = {"as_found": NO_CORRECTIONS, "before": ActiveCorrections({"Y": by_slope(-30e-6)}, {})}
    circle = circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0, measured_in="before")
    found = scaled(circle, states=states)
    assert "scale error +80.0 ± 2.0 µm/m" in found.finding.message
    turned = {"as_found": states["before"], "before": NO_CORRECTIONS}
    assert "scale error +20.0 ± 2.0 µm/m" in scaled(circle, states=turned).finding.message


def test_two_feeds_tell_what_the_lag_takes_away() -> None:
    """A scale of 40 µm/m; the loop takes k at one feed and 4k at twice the feed: 40 - k, 40 - 4k."""
    k = 18.0
    slow = circle_of({"scale_error_second": (40.0 - k, 1.0)}, feed=1000.0, name="slow")
    fast = circle_of({"scale_error_second": (40.0 - 4.0 * k, 1.0)}, feed=2000.0, name="fast")
    found = scaled(slow, fast)
    assert "scale error +40.0 ± " in found.finding.message
    assert (
        "according to circular tests slow and fast at two feeds, extrapolated to feed zero"
        in found.finding.message
    )
    assert slope_of(scaled(fast, slow)) == pytest.approx(-40.0 * PPM, abs=0.3 * PPM)


def test_the_uncertainty_of_two_feeds_is_that_of_the_extrapolation() -> None:
    """Weights 4/3 and -1/3; of each standard error the doubt of its lag (uniform) is taken out: left
    are 3 µm/m, so sqrt(16 + 1) = 4.12, stated twice.
    """
    feeds = (1000.0, 2000.0)
    circles = []
    for feed in feeds:
        doubt = shrinking(circle_of({}, feed=feed)) / np.sqrt(3.0) / PPM
        error = float(np.hypot(3.0, doubt))
        circles.append(circle_of({"scale_error_second": (100.0, error)}, feed=feed))
    assert "scale error +100.0 ± 4.1 µm/m" in scaled(*circles).finding.message


def test_circles_about_two_places_are_not_one_pair_of_feeds() -> None:
    slow = circle_of({"scale_error_second": (22.0, 1.0)}, feed=1000.0)
    fast = circle_of({"scale_error_second": (-32.0, 1.0)}, feed=2000.0, centre=(500.0, 400.0))
    found = scaled(slow, fast)
    assert (found.planned, found.finding.code) == (None, "CW-P119")
    assert "may make the circle smaller by 50 µm/m" in found.finding.message


@pytest.mark.parametrize(("axes", "cause"), [(("X", "Y"), -4.0), (("Y", "X"), 4.0)])
def test_the_mismatch_with_an_axis_under_the_laser_gives_the_other(
    axes: tuple[str, str], cause: float
) -> None:
    """X 10 µm/m by the laser, Y 30: over 200 mm Y is 4 µm longer."""
    laser = work_of(KnownAxis(lambda x: 10e-6 * x, lambda x: 10e-6 * x))
    circle = circle_of({"scale_mismatch": (cause, 0.2)}, axes)
    found = scaled(circle, works={"X": laser})
    assert (
        "scale error +30.0 ± 1.0 µm/m according to the scale of axis X by laser, and the scale difference of the two axes in circular test circle"
        in (found.finding.message)
    )
    assert slope_of(found) == pytest.approx(-30.0 * PPM, abs=0.2 * PPM)


def test_a_bar_of_unknown_length_beside_an_axis_without_a_laser_tells_nothing() -> None:
    found = scaled(circle_of({"scale_mismatch": (4.0, 0.2)}, calibrated=False))
    assert (found.planned, found.finding.severity) == (None, "error")
    assert "the bar of circle was not calibrated" in found.finding.message
    assert "none was measured with it" in scaled().finding.message


@pytest.mark.parametrize(
    ("value", "error", "code", "severity"),
    [
        (50.0, 12.4, "CW-P120", "warning"),
        (-50.0, 12.4, "CW-P120", "warning"),
        (50.0, 12.6, "CW-P119", "error"),  # two standard errors above half of the value
        (-90.0, 15.1, "CW-P119", "error"),  # two standard errors above 30 µm/m
        (2.0, 6.0, "CW-P119", "info"),  # needs no correction
    ],
)
def test_a_scale_is_corrected_where_it_is_known_well_enough(
    value: float, error: float, code: str, severity: str
) -> None:
    found = scaled(circle_of({"scale_error_second": (value, error)}, feed=150.0))
    assert (found.planned is not None) is (code == "CW-P120")
    assert (found.finding.code, found.finding.severity) == (code, severity)


def test_a_scale_whose_correction_may_make_it_worse_is_a_doubt() -> None:
    """50 ± 12.4 µm/m (one standard error): below 25 with P(z > 2.016), 2.2 %."""
    for error, doubts in ((7.0, []), (12.4, ["CW-P166"])):
        found = scaled(circle_of({"scale_error_second": (50.0, error)}, feed=150.0))
        assert [one.code for one in found.findings if one.is_doubt] == doubts
    assert "scale of axis Y" in found.findings[-1].message
    assert "a probability of 2.2 %." in found.findings[-1].message


def test_circles_at_low_feeds_are_weighted() -> None:
    """40 ± 1 and 50 ± 2 µm/m: 42."""
    found = scaled(
        circle_of({"scale_error_second": (40.0, 1.0)}, feed=150.0, name="a"),
        circle_of({"scale_error_first": (50.0, 2.0)}, ("Y", "Z"), feed=150.0, name="b"),
    )
    assert (
        "scale error +42.0 ± 0.9 µm/m according to circular test a at a low feed; circular test b at a low feed"
        in found.finding.message
    )


def test_a_laser_on_the_axis_wins() -> None:
    job = job_of(axis_of(), apply=ApplyRequest(scale=("X", "W")))
    checks = CircleChecks(job, {}, {"as_found": NO_CORRECTIONS})
    (found,) = correct_scales(job, [circle_of({})], checks, capacity_of, EMPTY)
    assert (found.planned, found.finding.code) == (None, "CW-P118")


def test_a_control_that_cannot_hold_it_is_an_error_with_its_reason() -> None:
    def holds_nothing(axis: Axis, *, one_curve: bool = False) -> Capacity:
        raise CapacityError(Fault(message="no table left"))

    found = scaled(
        circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0), capacity=holds_nothing
    )
    assert (found.planned, found.finding.severity) == (None, "error")
    assert "not corrected: no table left" in found.finding.message
    assert scale_steps([found]) == ()


def test_the_card_says_to_measure_with_a_laser() -> None:
    found = scaled(circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0))
    (step,) = scale_steps([found])
    assert step["title"] == "Y: scale from circles"
    assert step["text"].endswith("Measure Y with a laser when you can.")
