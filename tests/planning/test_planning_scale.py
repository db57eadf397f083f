"""The scale of an axis that no laser measured, from circles whose scale is known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.foundations.errors import CapacityError, Fault
from compwright.planning.axis_work import AxisWork, CapacityOf
from compwright.planning.circle_checks import CircleChecks
from compwright.planning.circle_network import network_findings
from compwright.planning.circles import CircleWork
from compwright.planning.scale import ScaleCorrection, correct_scales, scale_steps, shrinking
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.fitted_table import Mode, TableRequest
from compwright.records.job import Acknowledgement, ApplyRequest
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
    acknowledged: tuple[Acknowledgement, ...] = (),
    mode: Mode = "auto",
) -> ScaleCorrection:
    apply = ApplyRequest(scale=(axis.name,))
    job = job_of(axis_of(), axis, untested=(axis.name,), apply=apply, acknowledged=acknowledged)
    entry = replace(job.axes[axis.name], table=TableRequest(mode=mode))
    job = replace(job, axes={**job.axes, axis.name: entry})
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


def fed(
    name: str, feed: float, *, axes: tuple[str, str] = ("X", "Y"), y: float = 40.0, **more: Any
) -> CircleWork:
    """A circle of a machine with scale errors X 10, Y ``y``, Z -5 µm/m whose position loops lag by 30,
    36 and 42 ms: each shrinks its axis by (ω T)² / 2. The fit leaves 0.3 µm/m open.
    """
    radius = more.setdefault("radius", 100.0)
    turning = feed / 60.0 / radius * 1e-3
    first, second = (
        {"X": 10.0, "Y": y, "Z": -5.0}[axis]
        - 0.5e6 * (turning * {"X": 30.0, "Y": 36.0, "Z": 42.0}[axis]) ** 2
        for axis in axes
    )
    doubt = shrinking(circle_of({}, axes, feed=feed, radius=radius)) / np.sqrt(3.0) / PPM
    across = 2e-3 * radius
    found = {
        "scale_mismatch": (across * (first - second), across * 0.3),
        "scale_error_first": (first, float(np.hypot(0.3, doubt))),
        "scale_error_second": (second, float(np.hypot(0.3, doubt))),
    }
    return circle_of(found, axes, feed=feed, name=name, **more)


@pytest.mark.parametrize(
    "circles",
    [
        (fed("a", 1000.0), fed("b", 2000.0)),
        (fed("a", 1000.0), fed("b", 1000.0, radius=50.0)),  # two radii turn the loops differently
        (fed("a", 150.0), fed("b", 4000.0), fed("c", 4000.0, centre=(300.0, 500.0))),
        (fed("a", 1000.0), fed("b", 3000.0), fed("c", 1000.0, axes=("Y", "Z"))),
    ],
)
def test_circles_together_tell_scale_from_lag(circles: tuple[CircleWork, ...]) -> None:
    """Each circle shows Y smaller by 18 µm/m at 1000 mm/min, 288 at 4000: the table corrects the 40
    of the machine, with the value and error that the finding about all circles states.
    """
    found = scaled(*circles)
    assert found.finding.code == "CW-P120"
    assert slope_of(found) == pytest.approx(-40.0 * PPM, abs=1.5 * PPM)
    names = ", ".join(work.name for work in circles)
    assert f"according to circular tests {names} together" in found.finding.message
    (together,) = (one for one in network_findings(circles) if one.code == "CW-P135")
    stated = together.message.split(" Y ")[1].split(" µm/m")[0]
    assert f"scale error {stated} µm/m" in found.finding.message


def test_circles_that_tell_no_scale_together_ask_for_a_low_feed() -> None:
    """At 300 mm/min on 150 mm (200 on 100) a loop of 16.7/s takes 2 µm/m."""
    found = scaled(fed("a", 3000.0), fed("b", 3000.0))
    assert (found.planned, found.finding.code) == (None, "CW-P119")
    assert "measure a circle at 200 mm/min or slower" in found.finding.message
    assert scaled(fed("a", 3000.0), fed("b", 200.0)).finding.code == "CW-P120"


@pytest.mark.parametrize(("radius", "feed"), [(100.0, 200), (50.8, 101), (63.7, 127)])
def test_a_circle_at_the_feed_that_is_asked_for_gives_the_scale(radius: float, feed: int) -> None:
    """50.8 mm take 101.6 mm/min for 2 µm/m: at 102 the lag would be too large again."""
    asked = scaled(fed("a", 3000.0, radius=radius)).finding.message
    assert f"measure a circle at {feed} mm/min or slower" in asked
    assert scaled(fed("a", float(feed), radius=radius)).finding.code == "CW-P120"


def test_circles_together_are_brought_to_what_is_active_now() -> None:
    """Measured while the control drew back 30 µm/m, Y showed 40; now nothing is active: 70."""
    states = {"as_found": NO_CORRECTIONS, "before": ActiveCorrections({"Y": by_slope(-30e-6)}, {})}
    circles = [fed(name, feed, measured_in="before") for name, feed in (("a", 500.0), ("b", 3e3))]
    assert slope_of(scaled(*circles, states=states)) == pytest.approx(-70.0 * PPM, abs=1.5 * PPM)


@pytest.mark.parametrize(("axes", "cause"), [(("X", "Y"), -4.0), (("Y", "X"), 4.0)])
def test_the_mismatch_with_an_axis_under_the_laser_gives_the_other(
    axes: tuple[str, str], cause: float
) -> None:
    """X 10 µm/m by the laser, Y 30: over 200 mm Y is 4 µm longer."""
    laser = work_of(KnownAxis(lambda x: 10e-6 * x, lambda x: 10e-6 * x))
    circle = circle_of({"scale_mismatch": (cause, 0.2)}, axes)
    found = scaled(circle, works={"X": laser})
    assert (
        "scale error +30.0 ± 1.0 µm/m according to circular test circle and the laser on axis X."
        in (found.finding.message)
    )
    assert slope_of(found) == pytest.approx(-30.0 * PPM, abs=0.2 * PPM)


def test_a_bar_of_unknown_length_beside_an_axis_without_a_laser_tells_nothing() -> None:
    found = scaled(circle_of({"scale_mismatch": (4.0, 0.2)}, calibrated=False))
    assert (found.planned, found.finding.severity) == (None, "error")
    assert "the bar of circle circle was not calibrated" in found.finding.message
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
    """40 ± 1 and 42 ± 2 µm/m: 40.4."""
    found = scaled(
        circle_of({"scale_error_second": (40.0, 1.0)}, feed=150.0, name="a"),
        circle_of({"scale_error_first": (42.0, 2.0)}, ("Y", "Z"), feed=150.0, name="b"),
    )
    assert (
        "scale error +40.4 ± 0.9 µm/m according to circular test a at a low feed; circular test b at a low feed"
        in found.finding.message
    )


KNOWN = (Acknowledgement(code="CW-P136", reason="the floor was relevelled"),)
LATE = {"as_found": NO_CORRECTIONS, "before": ActiveCorrections({"Y": by_slope(-12e-6)}, {})}


@pytest.mark.parametrize(
    ("first", "second"), [((500.0, 3e3), (500.0, 3e3)), ((500.0, 3e3), (150.0,)), ((150.0,),) * 2]
)
def test_a_table_that_was_not_active_in_a_state_is_told_and_not_averaged(
    first: tuple[float, ...], second: tuple[float, ...]
) -> None:
    """The machine has 40 µm/m in both states. With the 12 of a table that did nothing, the circles
    of one state become 52: the mean is right for neither.
    """
    circles = [
        fed(f"{state} {feed:g}", feed, measured_in=state)
        for state, feeds in (("before", first), ("as_found", second))
        for feed in feeds
    ]
    refused = scaled(*circles, states=LATE)
    assert (refused.planned, refused.finding.severity) == (None, "error")
    assert "acknowledge CW-P136" in refused.finding.message
    (doubt,) = (one for one in refused.findings if one.code == "CW-P136")
    assert (doubt.is_doubt, doubt.axes) == (True, ("Y",))
    assert 40.0 < -slope_of(scaled(*circles, states=LATE, acknowledged=KNOWN)) / PPM < 52.0
    assert [one.code for one in scaled(*circles).findings] == ["CW-P120", "CW-P111"]


def test_the_circles_of_one_state_that_contradict_each_other_are_not_averaged() -> None:
    """One of four shows Y longer by 6 µm/m: 20 standard errors. 60 at low feeds are too uncertain."""
    four = fed("a", 150.0), fed("b", 1000.0), fed("c", 3000.0), fed("odd", 500.0, y=46.0)
    assert "CW-P136" in [one.code for one in network_findings(four)]
    refused = scaled(*four)
    assert (refused.planned, refused.finding.severity) == (None, "error")
    assert "acknowledge CW-P136" in refused.finding.message
    assert 40.0 < -slope_of(scaled(*four, acknowledged=KNOWN)) / PPM < 46.0
    far = scaled(fed("a", 150.0), fed("b", 150.0, y=100.0))
    assert (far.planned, far.finding.severity) == (None, "error")
    assert "± 60.0 µm/m is too uncertain" in far.finding.message
    assert "square" not in far.finding.message  # what helps a squareness does not help a scale


def of_like_axes(growth: float) -> list[CircleWork]:
    """Circles of two axes of 50 µm/m that grow by ``growth`` (1e-6 for (1 rad/s)²), R 100."""
    return [
        circle_of(
            {
                "scale_mismatch": (0.0, 0.06),
                "scale_error_first": (shown, float(np.hypot(0.3, doubt))),
                "scale_error_second": (shown, float(np.hypot(0.3, doubt))),
            },
            feed=feed,
            radius=100.0,
            name=name,
        )
        for name, feed in (("a", 500.0), ("b", 3000.0))
        for shown in (50.0 + growth * (feed / 6000.0) ** 2,)
        for doubt in (shrinking(circle_of({}, feed=feed, radius=100.0)) / np.sqrt(3.0) / PPM,)
    ]


def test_a_loop_that_is_softer_than_any_usual_one_gives_no_scale() -> None:
    """A bar 5 µm longer in the second test, or a circle that was driven at another feed than the
    file says, looks like a loop of 83 ms in the fit; 16.7/s (60 ms) is the softest usual one.
    """
    for lag, code in ((55.0, "CW-P120"), (83.0, "CW-P119")):
        circles = of_like_axes(-0.5 * lag**2)
        found = scaled(*circles)
        assert found.finding.code == code
        said = [one for one in network_findings(circles) if one.code == "CW-P136"]
        assert len(said) == (0 if code == "CW-P120" else 2)  # X and Y
        assert all("83 ms (usual: up to 60 ms)" in one.message for one in said)
    assert -slope_of(scaled(*circles, acknowledged=KNOWN)) / PPM == pytest.approx(50.0, abs=1.0)


@pytest.mark.parametrize(("growth", "doubts"), [(90.0, 0), (320.0, 2), (1770.0, 2)])
def test_a_circle_that_grows_with_the_feed_gives_no_scale(growth: float, doubts: int) -> None:
    """A loop of 60 ms under full feedforward before a velocity loop of 5 ms: T T' = 300e-6 s²,
    75 µm/m from 500 to 3000 mm/min. With 15 ms and feedforward 1.05 it is 75 + 12. No loop makes
    1770: 430 µm/m, or 43 µm of the radius.
    """
    circles = of_like_axes(growth)
    said = [one for one in network_findings(circles) if one.code == "CW-P136"]
    assert len(said) == doubts
    assert all("grows with the feed" in one.message and one.is_doubt for one in said)
    assert all("position loop of" not in one.message for one in said)
    assert scaled(*circles).finding.code == ("CW-P119" if doubts else "CW-P120")


def test_a_laser_on_the_axis_wins() -> None:
    job = job_of(axis_of(), apply=ApplyRequest(scale=("X", "W")))
    checks = CircleChecks(job, {}, {"as_found": NO_CORRECTIONS})
    (found,) = correct_scales(job, [circle_of({})], checks, capacity_of, EMPTY)
    assert (found.planned, found.finding.code) == (None, "CW-P118")


@pytest.mark.parametrize(("centres", "far"), [((500.0,), True), ((250.0, 550.0), False)])
def test_a_scale_from_a_small_part_of_the_travel_is_extrapolated(
    centres: tuple[float, ...], *, far: bool
) -> None:
    """One circle of 400 mm on 1000 mm of travel; two of them cover 700 mm. Squareness has the same
    limit, half of the travel.
    """
    found = scaled(
        *(
            circle_of(
                {"scale_error_second": (50.0, 2.0)},
                radius=200.0,
                feed=150.0,
                centre=(500.0, centre),
                name=f"at {centre:g}",
            )
            for centre in centres
        )
    )
    reach = [one.message for one in found.findings if one.code == "CW-P111"]
    assert len(reach) == far
    if far:
        assert "over 1000 mm of axis Y" in reach[0]
        assert "is only 400 mm" in reach[0]


@pytest.mark.parametrize("feeds", [(150.0,), (150.0, 1000.0, 3000.0)])
def test_a_circle_that_shows_no_scale_reaches_over_nothing(feeds: tuple[float, ...]) -> None:
    """Circles from 400 to 600 mm show the scale. One from 800 to 1000 mm shows nothing: the part
    that it covers is extrapolated, and what was active there during the tests counts for nothing.
    """

    def bent(positions: FloatArray, direction: Direction) -> FloatArray:
        return -20.0 * PPM * np.maximum(positions - 700.0, 0.0)

    states = {"as_found": NO_CORRECTIONS, "before": ActiveCorrections({"Y": bent}, {})}
    circles = [fed(f"{feed:g}", feed, measured_in="before") for feed in feeds]
    blind = circle_of({}, centre=(500.0, 900.0), name="blind", measured_in="before")
    alone, found = (scaled(*those, states=states) for those in (circles, [*circles, blind]))
    reach = [one.message for one in found.findings if one.code == "CW-P111"]
    assert reach == [one.message for one in alone.findings if one.code == "CW-P111"]
    assert "is only 200 mm" in reach[0]
    # 1 µm/m: what the lag leaves open at one feed; the part that counts for nothing would be 5 to 10
    assert slope_of(found) == pytest.approx(slope_of(alone), abs=1.0 * PPM)


def holds_one(axis: Axis, *, one_curve: bool = False) -> Capacity:
    """A control without free indices for a second table, as a SINUMERIK 840D sl with one CEC."""
    if not one_curve:
        raise CapacityError(Fault(message="needs 2 tables"))
    return replace(capacity_of(axis), curves=1)


@pytest.mark.parametrize(
    ("mode", "planned"), [("auto", True), ("single", True), ("bidirectional", False)]
)
def test_a_scale_needs_no_second_table(mode: Mode, *, planned: bool) -> None:
    circle = circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0)
    found = scaled(circle, capacity=holds_one, mode=mode)
    assert (found.planned is not None) is planned
    if planned:
        assert slope_of(found) == pytest.approx(-50.0 * PPM, abs=0.2 * PPM)
    else:
        assert "needs 2 tables" in found.finding.message


@pytest.mark.parametrize(("minus", "planned"), [((4.0, -26.0), True), ((4.0, -29.0), False)])
def test_existing_tables_that_differ_keep_both_directions(
    minus: tuple[float, float], *, planned: bool
) -> None:
    """The same but for a constant, which is the backlash; or a difference of 1 to 4 µm."""
    table = AxisCompensation(
        address="Y",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=np.array([0.0, -30.0]) * UM,
        negative=np.array(minus) * UM,
    )
    found = scaled(
        circle_of({"scale_error_second": (50.0, 2.0)}, feed=150.0),
        state=ControlState(format="any", axes={"Y": table}),
        states={"as_found": ActiveCorrections({"Y": table.at}, {})},
        capacity=holds_one,
    )
    assert (found.planned is not None) is planned


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
