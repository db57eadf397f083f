"""Corrections between axes, by hand: which way a bent axis is moved, and by how much."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from compwright.planning.circles import CircleWork
from compwright.planning.cross import CrossPlan, angle_of, plan_cross
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.records.axis import Axis, AxisKind
from compwright.records.job import Acknowledgement, ApplyRequest, CrossRequest
from compwright.records.plan import PlannedCross
from planning_samples import MINUS, PLUS, PPM, UM, axis_of, by_slope, circle_of, job_of

AXES = (axis_of(), axis_of("Y"))
BEND_Y = ApplyRequest(squareness={"XY": "Y"})
BEND_X = ApplyRequest(squareness={"XY": "X"})


def plan(
    *circles: CircleWork,
    states: Mapping[str, ActiveCorrections] | None = None,
    axes: tuple[Axis, ...] = AXES,
    **words: Any,
) -> CrossPlan:
    acting = states or {"as_found": NO_CORRECTIONS}
    return plan_cross(job_of(*axes, **words), circles, acting, acting["as_found"])


def only(found: CrossPlan) -> PlannedCross:
    (planned,) = found.planned
    return planned


def codes(found: CrossPlan) -> list[str]:
    return [finding.code for finding in found.findings]


def added(found: CrossPlan, *where: float) -> list[float]:
    """What is added to the bent axis at positions of the other one, µm."""
    return [round(value / UM, 6) for value in only(found).added.at(np.array(where), PLUS)]


def square(value: float, error: float = 2.0, **words: Any) -> CircleWork:
    return circle_of({"squareness": (value, error)}, **words)


def straight(deviations: tuple[float, ...], **words: Any) -> CrossRequest:
    positions = words.pop("positions", (0.0, 500.0, 1000.0))
    return CrossRequest(input="X", output="Y", positions=positions, deviations=deviations, **words)


def test_more_than_a_right_angle_lifts_the_bent_axis_along_the_other() -> None:
    """30 µm/m more than 90°: at X 1000 the machine is 30 µm too far to -Y, so Y goes 30 µm to +."""
    found = plan(square(30.0), apply=BEND_Y)
    planned = only(found)
    assert (planned.input, planned.output, planned.source) == ("X", "Y", "circle")
    assert added(found, 0.0, 500.0, 1000.0) == [0.0, 15.0, 30.0]
    assert planned.squareness == pytest.approx(30.0 * PPM)
    assert planned.std_error == pytest.approx(2.0 * PPM)
    assert codes(found) == ["CW-P111", "CW-P109"]


@pytest.mark.parametrize(
    ("error", "shown"),
    [
        (2.0, "+30.0 ± 2.0"),
        (0.06, "+30.0 ± 0.1"),
        (0.024, "+30.00 ± 0.02"),
        (0.0031, "+30.000 ± 0.003"),
    ],
)
def test_a_standard_error_is_not_shown_as_zero(error: float, shown: str) -> None:
    """A quiet circle of many samples has one below 0.05 µm/m."""
    found = plan(square(30.0, error), apply=BEND_Y)
    (one,) = (each.message for each in found.findings if each.code == "CW-P109")
    assert f"the squareness is {shown} µm/m" in one


def test_bending_the_other_axis_has_the_same_sign() -> None:
    found = plan(square(30.0), apply=BEND_X)
    assert (only(found).input, only(found).output) == ("Y", "X")
    assert added(found, 0.0, 1000.0) == [0.0, 30.0]


def test_the_ramp_is_zero_at_the_reference_of_the_axis_that_moves() -> None:
    axes = (axis_of(reference=400.0), axis_of("Y", reference=123.0))
    assert added(plan(square(30.0), axes=axes, apply=BEND_Y), 0.0, 400.0, 1000.0) == [
        *(-12.0, 0.0, 18.0)
    ]


@pytest.mark.parametrize(
    "pair", [("X", "Y"), ("Y", "X")]
)  # moving Y with X, or X with Y: the angle closes
def test_what_acts_between_the_axes_takes_its_own_slope_off_the_angle(
    pair: tuple[str, str],
) -> None:
    acting = ActiveCorrections({"X": by_slope(5e-4), "Y": by_slope(-3e-4)}, {pair: by_slope(30e-6)})
    assert angle_of(square(0.0), acting) == pytest.approx(30.0 * PPM, rel=1e-3)
    assert angle_of(square(0.0), NO_CORRECTIONS) == 0.0


def test_a_step_at_the_reversal_is_no_angle() -> None:
    """A correction that only depends on the direction moves both halves of each run alike."""
    acting = ActiveCorrections({}, {("X", "Y"): by_slope(0.0, lost=10.0 * UM)})
    assert angle_of(square(0.0), acting) == pytest.approx(0.0, abs=0.1 * PPM)


def test_a_circle_of_another_state_is_brought_to_what_acts_now() -> None:
    """While Y was bent by 30 µm/m it still showed 10: the machine itself has 40."""
    before = ActiveCorrections({}, {("X", "Y"): by_slope(30e-6)})
    circle = square(10.0, measured_in="before")
    now_bare = plan(circle, apply=BEND_Y, states={"as_found": NO_CORRECTIONS, "before": before})
    assert only(now_bare).squareness == pytest.approx(40.0 * PPM, rel=1e-3)
    now_bent = plan(circle, apply=BEND_Y, states={"as_found": before, "before": NO_CORRECTIONS})
    assert only(now_bent).squareness == pytest.approx(-20.0 * PPM, rel=1e-3)
    (shown,) = (one.message for one in now_bent.findings if one.code == "CW-P109")
    assert "with the control's existing table is -20.0" in shown
    assert "measured in another state" in shown
    (shown,) = (one.message for one in now_bare.findings if one.code == "CW-P109")
    assert "the squareness is +40.0" in shown  # no table exists now
    assert "measured in another state" in shown


def test_circles_of_a_plane_are_weighted() -> None:
    """30 ± 2 and 45 ± 4 µm/m: 33, ± 1.79; the chi-square of 11.25 at one degree of freedom says that
    they disagree, so ± 6. Nothing is corrected until this is acknowledged.
    """
    circles = square(30.0, 2.0, name="a"), square(45.0, 4.0, name="b")
    refused = plan(*circles, apply=BEND_Y)
    assert refused.planned == ()
    assert codes(refused) == ["CW-P110", "CW-P106"]
    known = (Acknowledgement(code="CW-P110", reason="the floor was relevelled"),)
    found = plan(*circles, apply=BEND_Y, acknowledged=known)
    planned = only(found)
    assert planned.squareness == pytest.approx(33.0 * PPM)
    assert planned.std_error == pytest.approx(6.0 * PPM)
    assert planned.tests == ("a", "b")
    assert "CW-P110" in codes(found)


def test_circles_that_scatter_by_chance_only_widen_the_error() -> None:
    """20 and 27 µm/m, both ± 2: 2.5 standard errors apart, as one sound pair in eighty is."""
    found = plan(square(20.0, 2.0, name="a"), square(27.0, 2.0, name="b"), apply=BEND_Y)
    assert only(found).std_error == pytest.approx(3.5 * PPM)
    assert "CW-P110" not in codes(found)


def test_circles_that_agree_are_better_than_each() -> None:
    found = plan(square(30.0, 2.0, name="a"), square(32.0, 2.0, name="b"), apply=BEND_Y)
    assert only(found).std_error == pytest.approx(np.sqrt(2.0) * PPM)
    assert "CW-P110" not in codes(found)


@pytest.mark.parametrize(
    ("value", "error", "code"),
    [
        (-30.0, 4.8, "CW-P109"),
        (-30.0, 7.4, "CW-P109"),
        (-30.0, 7.6, "CW-P106"),  # two standard errors above half of the value
        (116.0, 14.9, "CW-P109"),
        (116.0, 15.1, "CW-P106"),  # two standard errors above 30 µm/m
        (1.0, 6.9, "CW-P107"),  # at most 15 µm/m: needs no correction
        (1.0, 7.1, "CW-P106"),
        (4.0, 2.0, "CW-P107"),
    ],
)
def test_an_angle_is_corrected_where_it_is_known_well_enough(
    value: float, error: float, code: str
) -> None:
    found = plan(square(value, error), apply=BEND_Y)
    assert bool(found.planned) is (code == "CW-P109")
    rest = [one.code for one in found.findings if one.code not in ("CW-P111", "CW-P166")]
    assert rest == [code]
    assert all(
        finding.severity == "error" for finding in found.findings if finding.code == "CW-P106"
    )


@pytest.mark.parametrize(
    ("value", "error", "chance"),
    [
        (60.0, 7.5, ""),  # P(z > 4): 0.003 %
        (-30.0, 4.8, ""),  # P(z > 3.125): 0.089 %
        (-30.0, 5.0, "0.13 %"),  # P(z > 3): 0.135 %
        (30.0, 7.4, "2.1 %"),  # P(z > 2.027): 2.13 %
    ],
)
def test_a_correction_that_may_make_it_worse_is_a_doubt(
    value: float, error: float, chance: str
) -> None:
    """The true squareness is normal about the measured one; below half of it the corrected machine
    is further from 90° than before.
    """
    found = plan(square(value, error), apply=BEND_Y)
    assert only(found).squareness == pytest.approx(value * PPM)
    doubts = [one for one in found.findings if one.code == "CW-P166"]
    assert [one.is_doubt for one in doubts] == [True] * bool(chance)
    assert all(f"worse with a probability of {chance}." in one.message for one in doubts)


def test_circles_that_are_too_poor_alone_count_together() -> None:
    """Four times ± 16 µm/m (k = 2) are ± 8 together, below half of 30."""
    four = [square(30.0, 8.0, name=name) for name in "abcd"]
    assert plan(four[0], apply=BEND_Y).planned == ()
    assert only(plan(*four, apply=BEND_Y)).squareness == pytest.approx(30.0 * PPM)


def test_an_angle_that_nobody_asks_to_correct_is_said() -> None:
    assert codes(plan(square(30.0))) == ["CW-P108"]
    assert codes(plan(square(3.0))) == []
    assert codes(plan(apply=BEND_Y)) == ["CW-P106"]
    other = plan(
        square(30.0), axes=(*AXES, axis_of("Z")), apply=ApplyRequest(squareness={"YZ": "Z"})
    )
    assert codes(other) == ["CW-P106", "CW-P108"]


@pytest.mark.parametrize(("travel", "far"), [(400.0, False), (401.0, True)])
def test_beyond_two_diameters_it_is_an_extrapolation(travel: float, *, far: bool) -> None:
    axes = (axis_of(travel=(0.0, travel)), axis_of("Y"))
    found = plan(square(30.0), axes=axes, apply=BEND_Y)
    assert ("CW-P111" in codes(found)) is far


def test_a_gantry_that_a_direct_measurement_bends_is_named_too() -> None:
    bent, moving = (axis_of(), axis_of("Y", gantry="Y2")), (axis_of(gantry="X2"), axis_of("Y"))
    for axes, named in ((bent, True), (moving, False)):
        found = plan(axes=axes, cross=(straight((0.0, 0.01, 0.02)),))
        assert ("CW-P112" in codes(found)) == named


def test_a_gantry_is_named() -> None:
    axes = (axis_of(), axis_of("Y", gantry="Y2"))
    assert "CW-P112" in codes(plan(square(30.0), axes=axes, apply=BEND_Y))
    assert "CW-P112" not in codes(plan(square(30.0), axes=axes, apply=BEND_X))


def test_a_measured_deviation_is_taken_back_from_the_reference_on() -> None:
    """Straightness 0, 6, 4 µm at X 0, 500, 1000: Y is moved by minus that."""
    found = plan(cross=(straight((0.0, 6.0 * UM, 4.0 * UM)),))
    assert added(found, 0.0, 500.0, 1000.0) == [0.0, -6.0, -4.0]
    assert added(found, 250.0) == [-3.0]
    assert only(found).source == "cross"
    middle = (axis_of(reference=500.0), axis_of("Y"))
    again = plan(axes=middle, cross=(straight((0.0, 6.0 * UM, 4.0 * UM)),))
    assert added(again, 0.0, 500.0, 1000.0) == [6.0, 0.0, 2.0]


def test_a_measured_slope_is_an_angle_with_the_sign_of_the_circle() -> None:
    """30 µm to -Y over a metre of X is 30 µm/m more than 90°; the circle that says so confirms."""
    down = straight((0.0, -15.0 * UM, -30.0 * UM))
    found = plan(square(31.0), cross=(down,))
    assert only(found).squareness == pytest.approx(30.0 * PPM)
    assert codes(found) == ["CW-P105"]
    assert codes(plan(square(-31.0), cross=(down,))) == ["CW-P104"]


@pytest.mark.parametrize(
    ("circle", "found_codes"),
    [
        (None, ["CW-P169"]),
        (45.0, ["CW-P105"]),  # against one square: 30 and 15 µm/m are its two parts
        (30.0, ["CW-P104", "CW-P169"]),
    ],
)
def test_a_circle_shows_whether_two_slopes_are_one_squareness(
    circle: float | None, found_codes: list[str]
) -> None:
    over_x = straight((0.0, -15.0 * UM, -30.0 * UM))
    over_y = CrossRequest(
        input="Y",
        output="X",
        positions=(0.0, 500.0, 1000.0),
        deviations=(0.0, -7.5 * UM, -15.0 * UM),
    )
    circles = () if circle is None else (square(circle),)
    found = plan(*circles, cross=(over_x, over_y))
    assert codes(found) == found_codes
    if circle is not None:
        said = str(found.findings[0].sentence)
        assert "squareness +45.0 µm/m according to the sum of the direct measurements" in said
        assert "the direct measurement." not in said
    if circle is None:
        assert found.findings[0].values["total"] == pytest.approx(45.0)


def test_a_squareness_that_would_move_an_axis_by_more_than_a_millimetre_is_a_doubt() -> None:
    """1.1 mm/m over a metre; the bound is that of measured deviations."""
    assert "CW-P168" in codes(plan(square(1100.0), apply=BEND_Y))
    assert "CW-P168" not in codes(plan(square(900.0), apply=BEND_Y))


def test_an_angle_of_more_than_a_millimetre_per_metre_is_a_doubt_on_a_short_axis_too() -> None:
    """A nominal radius in inches makes such an angle: 60 µm/m by a radius of 150 mm is 1 524 by
    5.9.
    """
    axes = (axis_of(travel=(0.0, 200.0)), axis_of("Y"))
    (doubt,) = (
        one
        for one in plan(square(1524.0), axes=axes, apply=BEND_Y).findings
        if one.code == "CW-P168"
    )
    assert "reaches 1.524 mm/m, more than 1 mm/m" in doubt.message
    assert "CW-P168" not in codes(plan(square(900.0), axes=axes, apply=BEND_Y))


@pytest.mark.parametrize(
    ("circle", "error", "found_codes"),
    [
        (34.9, 0.1, ["CW-P105"]),
        (35.1, 0.1, ["CW-P104"]),
        (39.9, 5.0, ["CW-P105"]),
        (40.1, 5.0, []),  # neither confirmed nor contradicted
        (45.4, 5.0, []),
        (45.5, 5.0, ["CW-P104"]),
    ],
)
def test_square_and_circle_agree_within_a_good_square_or_the_circle(
    circle: float, error: float, found_codes: list[str]
) -> None:
    found = plan(square(circle, error), cross=(straight((0.0, -15.0 * UM, -30.0 * UM)),))
    assert codes(found) == found_codes


def test_the_direct_measurement_wins_over_the_circle() -> None:
    found = plan(square(80.0), cross=(straight((0.0, -15.0 * UM, -30.0 * UM)),), apply=BEND_Y)
    assert only(found).source == "cross"


def test_what_acted_then_and_acts_now_counts_for_a_direct_measurement() -> None:
    """Then Y was moved by 10 µm/m and stood straight: without it, as now, 10 µm/m are missing. And
    the other way round.
    """
    bent, request = (
        ActiveCorrections({}, {("X", "Y"): by_slope(10e-6)}),
        straight((0.0,) * 3, measured_in="then"),
    )
    bare_now = plan(cross=(request,), states={"as_found": NO_CORRECTIONS, "then": bent})
    assert added(bare_now, 0.0, 1000.0) == [0.0, 10.0]
    bent_now = plan(cross=(request,), states={"as_found": bent, "then": NO_CORRECTIONS})
    assert added(bent_now, 0.0, 1000.0) == [0.0, -10.0]


def test_directions_of_the_moving_axis_are_kept_apart() -> None:
    lag = ActiveCorrections({}, {("X", "Y"): lambda x, way: (4e-6 if way is MINUS else 0.0) * x})
    request = straight((0.0,) * 3, measured_in="then")
    found = plan(cross=(request,), states={"as_found": NO_CORRECTIONS, "then": lag})
    added_by = only(found).added
    assert added_by.at(np.array([1000.0]), PLUS)[0] == pytest.approx(0.0, abs=1e-9)
    assert added_by.at(np.array([1000.0]), MINUS)[0] == pytest.approx(4.0 * UM)


def test_beyond_the_measured_range_the_mean_slope_goes_on() -> None:
    """Measured from 400 to 600 with 20 µm/m: at the ends of the travel -8 and 12 µm from 400."""
    axes = (axis_of(reference=400.0), axis_of("Y"))
    request = straight((0.0, -2.0 * UM, -4.0 * UM), positions=(400.0, 500.0, 600.0))
    found = plan(axes=axes, cross=(request,))
    assert added(found, 0.0, 400.0, 600.0, 1000.0) == [-8.0, 0.0, 4.0, 12.0]
    assert "CW-P111" in codes(found)


def test_nodes_at_equal_steps_that_miss_a_measured_point_are_told() -> None:
    uneven = straight((0.0, 9.0 * UM, 0.0, 0.0), positions=(0.0, 130.0, 430.0, 1000.0))
    assert "CW-P103" in codes(plan(cross=(uneven,)))
    even = straight((0.0, 9.0 * UM, 0.0), positions=(0.0, 500.0, 1000.0))
    assert "CW-P103" not in codes(plan(cross=(even,)))


def test_two_points_are_a_table_of_two_points_over_the_travel() -> None:
    request = straight((0.0, -3.0 * UM), positions=(100.0, 400.0))
    found = plan(cross=(request,))
    assert only(found).added.positions.tolist() == [0.0, 1000.0]
    assert added(found, 0.0, 1000.0) == [0.0, 10.0]


def test_axes_that_the_job_does_not_have_are_left_to_the_reading_of_the_job() -> None:
    found = plan(axes=(axis_of(),), cross=(straight((0.0,) * 3),), apply=BEND_Y)
    assert (found.planned, found.findings) == ((), ())


@pytest.mark.parametrize(
    ("words", "doubted"),
    [({"travel": (0.0, 180.0)}, True), ({"travel": (0.0, 180.0), "modulo": 360.0}, False)],
)
def test_no_position_lies_outside_the_travel_of_an_endless_axis(
    words: dict[str, Any], doubted: bool
) -> None:
    axes = (axis_of(kind=AxisKind.ROTARY, **words), axis_of("Y"))
    crossed = straight((0.0, 2.0 * UM, 1.0 * UM), positions=(0.0, 92.0, 184.0))
    assert ("CW-P170" in codes(plan(axes=axes, cross=(crossed,)))) is doubted
