"""The virtual circular test against closed forms of the first-order model, stated here on their
own, and through its files.

Tolerances: the first-order forms leave out terms of second order in error/R, error² and products of
two errors. With errors of 5 µm on R = 100 mm these are below 5e-3² / 100 mm = 2.5e-7 mm = 0.00025
µm for a single geometric effect; a lag of 1 ms at 0.167 rad/s turns the trace by 1.7e-4 rad and
leaves R (1.7e-4)² / 2 = 1.4e-6 mm.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import UsageError
from compwright.foundations.session import Session
from compwright.instruments.circular_reading import read_circular
from compwright.records.axis import Direction, FloatArray
from compwright.records.circular import CircularTest
from compwright.simulation.circular import (
    CircleAxis,
    CircleErrors,
    CirclePlan,
    record_circle,
)
from compwright.simulation.circular_files import to_b5r, to_circular_csv
from compwright.simulation.reading import read_machine
from compwright.workflow.commands.simulate import load_machine, simulate_files

R = 100.0  # mm
V = 1000.0 / 60.0  # mm/s
SECOND_ORDER = 1e-6  # mm, see above
PLAN = CirclePlan(radius=R, feed=1000.0)


def trace(test: CircularTest, sense: str) -> tuple[FloatArray, FloatArray]:
    """Return angles in rad and deviations in mm of the only run in a direction."""
    (run,) = [run for run in test.runs if run.sense == sense]
    return np.radians(run.angles), run.deviations


Form = Callable[[FloatArray, float], FloatArray]

#: Errors, their radial deviation to first order (methods, section 2: d = +1 ccw, -1 cw), tolerance
#: in mm.
FORMS: dict[str, tuple[CircleErrors, Form, float]] = {
    "nothing": (CircleErrors(), lambda t, _: 0.0 * t, 1e-12),
    "scale of the first": (
        CircleErrors(first=CircleAxis(scale=50e-6)),
        lambda t, _: R * 50e-6 * np.cos(t) ** 2,
        SECOND_ORDER,
    ),
    "scale of the second": (
        CircleErrors(second=CircleAxis(scale=-50e-6)),
        lambda t, _: -R * 50e-6 * np.sin(t) ** 2,
        SECOND_ORDER,
    ),
    "squareness": (
        CircleErrors(squareness=50e-6),
        lambda t, _: -0.5 * 50e-6 * R * np.sin(2 * t),
        SECOND_ORDER,
    ),
    "lost motion of the first": (
        CircleErrors(first=CircleAxis(lost_motion=(0.005, 0.005))),
        lambda t, d: d * 0.0025 * np.sign(np.sin(t)) * np.cos(t),
        SECOND_ORDER,
    ),
    "lost motion of the second": (
        CircleErrors(second=CircleAxis(lost_motion=(0.005, 0.005))),
        lambda t, d: -d * 0.0025 * np.sign(np.cos(t)) * np.sin(t),
        SECOND_ORDER,
    ),
    "lost motion of its own at each end": (
        CircleErrors(first=CircleAxis(lost_motion=(0.005, 0.001))),
        lambda t, d: d * np.where(np.cos(t) > 0, 0.0025, 0.0005) * np.sign(np.sin(t)) * np.cos(t),
        SECOND_ORDER,
    ),
    "lag of the first": (
        CircleErrors(first=CircleAxis(lag=0.001)),
        lambda t, d: d * 0.5 * V * 0.001 * np.sin(2 * t),
        2e-6,  # R (w T)²/2 = 1.4e-6 mm
    ),
    "lag of the second": (
        CircleErrors(second=CircleAxis(lag=0.001)),
        lambda t, d: -d * 0.5 * V * 0.001 * np.sin(2 * t),
        2e-6,
    ),
    "equal lag": (
        CircleErrors(first=CircleAxis(lag=0.04), second=CircleAxis(lag=0.04)),
        lambda t, _: 0.0 * t,
        1e-12,
    ),
    "servo shrink": (
        CircleErrors(first=CircleAxis(gain=20.0), second=CircleAxis(gain=20.0)),
        lambda t, _: 0.0 * t - V * V / (2 * 20.0**2 * R),
        3e-7,  # next term of 1/sqrt(1 + q²): 3/8 q⁴ R, q = w/Kv = 0.0083
    ),
    "lateral play of the first": (
        CircleErrors(first=CircleAxis(lateral_play=0.004)),
        lambda t, d: -d * 0.002 * np.abs(np.sin(t)),
        SECOND_ORDER,
    ),
    "lateral play of the second": (
        CircleErrors(second=CircleAxis(lateral_play=0.004)),
        lambda t, d: d * 0.002 * np.abs(np.cos(t)),
        SECOND_ORDER,
    ),
    "cyclic of the first": (
        CircleErrors(first=CircleAxis(cyclic=0.003, pitch=10.0, phase=0.7)),
        lambda t, _: 0.003 * np.cos(2 * np.pi * R * np.cos(t) / 10.0 + 0.7) * np.cos(t),
        SECOND_ORDER,
    ),
    "cyclic of the second": (
        CircleErrors(second=CircleAxis(cyclic=0.003, pitch=8.0, phase=-0.2)),
        lambda t, _: 0.003 * np.cos(2 * np.pi * R * np.sin(t) / 8.0 - 0.2) * np.sin(t),
        SECOND_ORDER,
    ),
    "straightness of the first": (
        CircleErrors(first=CircleAxis(straightness=0.004)),
        lambda t, _: 0.004 * np.cos(t) ** 2 * np.sin(t),
        SECOND_ORDER,
    ),
    "straightness of the second": (
        CircleErrors(second=CircleAxis(straightness=0.004)),
        lambda t, _: 0.004 * np.sin(t) ** 2 * np.cos(t),
        SECOND_ORDER,
    ),
    "centre offset": (
        CircleErrors(offset=(0.005, -0.003)),
        lambda t, _: 0.005 * np.cos(t) - 0.003 * np.sin(t),
        SECOND_ORDER,
    ),
    "radius change": (CircleErrors(radius_change=0.002), lambda t, d: 0.0 * t + d * 0.002, 1e-12),
    "bar": (CircleErrors(bar=-0.002), lambda t, _: 0.0 * t - 0.002, 1e-12),
}


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize(("sense", "d"), [("ccw", 1.0), ("cw", -1.0)])
def test_each_effect_is_its_first_order_form(name: str, sense: str, d: float) -> None:
    errors, form, tolerance = FORMS[name]
    angles, deviations = trace(record_circle(errors, PLAN).test, sense)
    assert np.abs(deviations - form(angles, d)).max() <= tolerance
    if tolerance > 1e-9:
        assert (
            np.abs(deviations).max() > 100 * tolerance
        )  # the effect itself is far larger than what the form leaves out


def test_unequal_gains_mix_into_both_harmonics() -> None:
    """Kx 20/s, Ky 25/s: lag atan(w/K) and shrink 1/sqrt(1 + (w/K)²) of each axis, from the textbook
    frequency response.
    """
    w = V / R
    errors = CircleErrors(first=CircleAxis(gain=20.0), second=CircleAxis(gain=25.0))
    for sense, d in (("ccw", 1.0), ("cw", -1.0)):
        angles, deviations = trace(record_circle(errors, PLAN).test, sense)
        x = (np.exp(1j * d * angles) / (1 + 1j * w / 20.0)).real
        y = (np.exp(1j * (d * angles - np.pi / 2)) / (1 + 1j * w / 25.0)).real * d
        assert np.abs(deviations - R * (np.sqrt(x * x + y * y) - 1)).max() < 1e-11
        odd = 2 * np.mean(deviations * np.sin(2 * angles))
        assert odd == pytest.approx(
            d * 0.5 * V * (1 / 20.0 - 1 / 25.0), rel=0.02
        )  # first axis lags by 10 ms more


@pytest.mark.parametrize("sense", ["ccw", "cw"])
@pytest.mark.parametrize(
    ("errors", "at"),
    [
        (CircleErrors(first=CircleAxis(lost_motion=(0.006, 0.002))), {0.0: 0.006, 180.0: 0.002}),
        (CircleErrors(second=CircleAxis(lost_motion=(0.006, 0.002))), {90.0: 0.006, 270.0: 0.002}),
    ],
)
def test_lost_motion_steps_outward_at_the_reversals_in_both_senses(
    errors: CircleErrors, at: dict[float, float], sense: str
) -> None:
    """In the order of time, radius after minus radius before: +b at each reversal of the axis, and
    no step anywhere else.
    """
    plan = CirclePlan(radius=R, arc=(30.0, 360.0))
    (run,) = record_circle(errors, plan).test.of("ccw" if sense == "ccw" else "cw")
    steps = np.diff(run.deviations)
    between = 0.5 * (run.angles[1:] + run.angles[:-1]) % 360.0
    for angle, size in at.items():
        here = int(np.argmin(np.abs((between - angle + 180.0) % 360.0 - 180.0)))
        # the ramp of b/2 cos over one sample of 0.24 deg is below 1e-4 b
        assert steps[here] == pytest.approx(size, abs=1e-6)
        steps[here] = 0.0
    assert np.abs(steps).max() < 2e-5  # mm: b/2 sin over a sample is 1.3e-5 mm at most


def test_the_spike_points_outward_after_each_reversal_and_decays() -> None:
    errors = CircleErrors(first=CircleAxis(spike=0.004, spike_length=3.0))
    for sense, d in (("ccw", 1), ("cw", -1)):
        angles, deviations = trace(record_circle(errors, PLAN).test, sense)
        for reversal in (0.0, np.pi):
            along = R * np.mod(d * (angles - reversal), 2 * np.pi)
            near = along < 9.0  # mm of path after the reversal
            wanted = 0.004 * np.exp(-along[near] / 3.0)
            # the displacement is along the axis: its radial part is cos(9/100) = 0.996 of it where
            # it is 5 % of the height
            assert np.abs(deviations[near] - wanted).max() < 5e-6
            before = R * np.mod(-d * (angles - reversal), 2 * np.pi) < 9.0
            assert np.abs(deviations[before]).max() < 1e-9


def test_no_spike_of_a_reversal_before_the_motion_began() -> None:
    errors = CircleErrors(first=CircleAxis(spike=0.004, spike_length=50.0))
    plan = CirclePlan(radius=R, arc=(10.0, 100.0), overshoot=5.0)
    angles, deviations = trace(record_circle(errors, plan).test, "ccw")
    assert np.abs(deviations).max() < 1e-12
    through = CirclePlan(radius=R, arc=(10.0, 100.0), overshoot=15.0)
    angles, deviations = trace(record_circle(errors, through).test, "ccw")
    assert deviations[0] == pytest.approx(
        0.004 * math.exp(-R * angles[0] / 50.0) * math.cos(angles[0]), abs=1e-6
    )


def test_exact_geometry_where_first_order_is_wrong() -> None:
    """An offset of 0.5 mm on 50 mm: the circle seen from elsewhere, by the cosine rule."""
    plan = CirclePlan(radius=50.0)
    angles, deviations = trace(record_circle(CircleErrors(offset=(0.3, 0.4)), plan).test, "ccw")
    towards = math.atan2(0.4, 0.3)
    exact = np.sqrt(50.0**2 + 0.5**2 + 2 * 50.0 * 0.5 * np.cos(angles - towards)) - 50.0
    assert np.abs(deviations - exact).max() < 1e-11
    assert np.abs(deviations - 0.5 * np.cos(angles - towards)).max() > 1e-3


def test_corrections_cancel_lost_motion_and_scale_with_any_lag() -> None:
    def corrections(axis: str, positions: FloatArray, direction: FloatArray) -> FloatArray:
        if axis == "X":
            return -50e-6 * (positions - 300.0) + 0.5 * 0.005 * direction
        return 0.25 + 0.0 * positions  # a constant moves machine and set-up point alike

    errors = CircleErrors(
        first=CircleAxis(scale=50e-6, lost_motion=(0.005, 0.005), lag=0.02),
        second=CircleAxis(lag=0.02),
    )
    plan = CirclePlan(radius=R, centre=(400.0, 250.0))
    bare = record_circle(errors, plan).test
    corrected = record_circle(errors, plan, corrections=corrections).test
    assert max(np.abs(run.deviations).max() for run in bare.runs) > 5e-3
    # what is left: scale times the corrections, 50e-6 * 10 um
    assert max(np.abs(run.deviations).max() for run in corrected.runs) < 1e-6


def test_corrections_see_machine_positions_and_directions_of_motion() -> None:
    seen: dict[str, list[tuple[float, float]]] = {"X": [], "Y": []}

    def corrections(axis: str, positions: FloatArray, direction: FloatArray) -> FloatArray:
        if positions.size > 2:
            seen[axis].append((float(positions.min()), float(positions.max())))
            moving = np.sign(np.diff(positions))
            steady = (direction[1:] == direction[:-1]) & (moving != 0)
            assert np.array_equal(moving[steady], direction[1:][steady])
        return np.zeros(positions.shape)

    record_circle(
        CircleErrors(), CirclePlan(radius=R, centre=(400.0, -250.0)), corrections=corrections
    )
    for axis, centre in (("X", 400.0), ("Y", -250.0)):
        for low, high in seen[axis]:
            assert (low, high) == pytest.approx((centre - R, centre + R), abs=1e-3)
    assert [len(both) for both in seen.values()] == [2, 2]


def test_noise_has_its_size_and_correlation_and_depends_on_the_seed_alone() -> None:
    plan = CirclePlan(radius=R, runs=20)
    errors = CircleErrors(noise=0.0003, correlated_noise=0.0005, correlation=0.9)
    one = record_circle(errors, plan, seed=4).test
    values = np.array([run.deviations for run in one.runs])
    n = values.size
    effective = n * (1 - 0.9) / (1 + 0.9)
    variance = 0.0003**2 + 0.0005**2
    assert values.var() == pytest.approx(
        variance, rel=5 * math.sqrt(2 / effective)
    )  # five standard errors
    lag_one = float(np.mean(values[:, 1:] * values[:, :-1]))
    assert lag_one == pytest.approx(0.9 * 0.0005**2, rel=5 * math.sqrt(4 / effective))
    assert (
        abs(np.corrcoef(values[0], values[1])[0, 1]) < 0.4
    )  # runs are independent; 1500 correlated samples
    again = record_circle(errors, plan, seed=4).test
    assert all(
        np.array_equal(a.deviations, b.deviations)
        for a, b in zip(one.runs, again.runs, strict=True)
    )
    other = record_circle(errors, plan, seed=5).test
    assert not np.array_equal(one.runs[0].deviations, other.runs[0].deviations)
    scaled = record_circle(replace(errors, bar=0.01), plan, seed=4).test
    assert np.allclose(scaled.runs[3].deviations - one.runs[3].deviations, 0.01, atol=1e-12)


def test_the_plan_is_kept_and_samples_lie_at_half_steps() -> None:
    plan = CirclePlan(
        name="zx",
        axes=("Z", "X"),
        radius=150.0,
        feed=2000.0,
        arc=(250.0, 220.0),
        sample_rate=53.0,
        runs=2,
        first="cw",
    )
    recording = record_circle(CircleErrors(), plan)
    test = recording.test
    assert (test.plane, test.axes, test.arc, test.nominal_radius, test.feed) == (
        "ZX",
        ("Z", "X"),
        (250.0, 220.0),
        150.0,
        2000.0,
    )
    assert [(run.sense, run.number) for run in test.runs] == [
        ("ccw", 1),
        ("ccw", 2),
        ("cw", 1),
        ("cw", 2),
    ]
    assert [traverse.run.sense for traverse in recording.traverses] == ["cw", "ccw", "cw", "ccw"]
    n = test.runs[0].angles.size
    assert n == round(53.0 * 2 * math.pi * 150.0 / (2000.0 / 60.0) * 220 / 360)
    assert test.runs[0].angles[[0, -1]] == pytest.approx([250 + 110 / n, 470 - 110 / n])
    assert test.runs[2].angles[[0, -1]] == pytest.approx([470 - 110 / n, 250 + 110 / n])
    assert plan.rate == pytest.approx(53.0, rel=1 / n)


@pytest.mark.parametrize(
    "plan",
    [
        CirclePlan(radius=0.0),
        CirclePlan(feed=-1.0),
        CirclePlan(arc=(0.0, 400.0)),
        CirclePlan(sample_rate=1e9),
    ],
)
def test_impossible_plans_are_refused(plan: CirclePlan) -> None:
    with pytest.raises(UsageError, match="cannot be measured"):
        record_circle(CircleErrors(), plan)


ROUGH = CircleErrors(
    first=CircleAxis(scale=40e-6, lost_motion=(0.004, 0.006)),
    second=CircleAxis(lag=0.0005),
    squareness=30e-6,
    offset=(0.02, -0.01),
    noise=0.0002,
)


@pytest.mark.parametrize("arc", [(0.0, 360.0), (45.0, 360.0), (250.0, 220.0), (0.0, 90.0)])
@pytest.mark.parametrize("calibrated", [True, False])
def test_a_ballbar_file_is_read_back(arc: tuple[float, float], calibrated: bool) -> None:
    plan = CirclePlan(
        name="a & b",
        axes=("Z", "X"),
        feed=1800.0,
        arc=arc,
        centre=(-400.5, 20.0),
        calibrated=calibrated,
        runs=2,
        first="cw",
    )
    recording = record_circle(ROUGH, plan, seed=3)
    content = to_b5r(recording, {"machine": "VMC <850>"})
    test = read_circular(content, "x.b5r")
    assert (test.plane, test.axes, test.arc, test.calibrated, test.centre) == (
        "ZX",
        ("Z", "X"),
        arc,
        calibrated,
        (-400.5, 20.0),
    )
    assert test.feed == pytest.approx(1800.0, rel=1e-7)  # rate printed with ten digits
    assert test.header["test"] == "a & b"
    assert test.header["machine"] == "VMC <850>"
    assert test.findings == ()
    for ours, theirs in zip(recording.test.runs, test.runs, strict=True):
        assert (ours.sense, ours.number) == (theirs.sense, theirs.number)
        assert np.abs(ours.angles - theirs.angles).max() < 1e-9
        assert (
            np.abs(ours.deviations - theirs.deviations).max() <= 5.001e-6
        )  # half of the last printed digit


@pytest.mark.parametrize("arc", [(0.0, 360.0), (250.0, 220.0)])
def test_a_csv_file_is_read_back(arc: tuple[float, float]) -> None:
    plan = CirclePlan(arc=arc, centre=(-400.5, 20.0), runs=2)
    test = record_circle(ROUGH, plan, seed=3).test
    back = read_circular(to_circular_csv(test, {"machine": "VMC"}), "xy.csv")
    assert back.header["machine"] == "VMC"
    assert (back.feed, back.nominal_radius, back.centre, back.calibrated) == (
        1000.0,
        150.0,
        (-400.5, 20.0),
        True,
    )
    assert back.arc == pytest.approx(
        arc, abs=0.25
    )  # the file holds samples, not the arc: a sample is 0.24 deg
    assert back.full_circle == test.full_circle
    for ours, theirs in zip(test.runs, back.runs, strict=True):
        assert (ours.sense, ours.number) == (theirs.sense, theirs.number)
        assert np.abs(ours.angles - theirs.angles).max() < 1e-6
        assert np.abs(ours.deviations - theirs.deviations).max() < 1e-7


@settings(max_examples=40, deadline=None)
@given(
    start=st.floats(-360, 360),
    extent=st.floats(90, 360),
    rate=st.floats(5, 60),
    runs=st.integers(1, 3),
    overshoot=st.floats(0, 180),
)
def test_every_plan_survives_its_ballbar_file(
    start: float, extent: float, rate: float, runs: int, overshoot: float
) -> None:
    plan = CirclePlan(
        radius=50.0, arc=(start, extent), sample_rate=rate, runs=runs, overshoot=overshoot
    )
    recording = record_circle(ROUGH, plan, seed=1)
    test = read_circular(to_b5r(recording), "x.b5r")
    assert len(test.runs) == 2 * runs
    assert test.arc[1] == pytest.approx(extent, abs=1e-6)  # ten printed digits
    for ours, theirs in zip(recording.test.runs, test.runs, strict=True):
        turned = (ours.angles - theirs.angles + 180.0) % 360.0 - 180.0
        assert np.abs(turned).max() < 1e-6
        assert np.abs(ours.deviations - theirs.deviations).max() <= 5.001e-6


MACHINE = """
virtual_machine: 1
machine: {name: VMC 850, serial: SIM-1}
axes:
  X:
    travel: [0, 800]
    error: {slope_um_per_m: 50, reversal: {mean_um: -5}}
    test: {targets: 5, runs: 1}
circles:
  xy-150:
    format: b5r
    plane: XY
    centre: [400, 250]
    feed_mm_min: 2000
    error:
      squareness_um_per_m: 30
      Y: {lost_motion_um: [4, 6], lag_ms: 0.5, cyclic: {amplitude_um: 1, pitch_mm: 10}}
  plain: {centre: [400, 250]}
  n1: {centre: [400, 250], error: {noise_um: 1}}
  n2: {centre: [400, 250], error: {noise_um: 1}}
"""


def test_a_machine_file_with_circles(tmp_path: Path) -> None:
    file = tmp_path / "machine.yaml"
    file.write_text(MACHINE, encoding="utf-8")
    machine = load_machine(Session(), file)
    written = simulate_files(Session(), machine, tmp_path / "out", seed=2)
    assert sorted(path.name for path in written) == [
        "n1.csv",
        "n2.csv",
        "plain.csv",
        "x.csv",
        "xy-150.b5r",
    ]
    plain = read_circular((tmp_path / "out" / "plain.csv").read_bytes(), "plain.csv")
    angles, deviations = trace(plain, "ccw")
    # slope and reversal of X act on the circle: e_x R cos² + lost motion 5 um, to second order and
    # 0.0001 um of the file; this axis moves right when it comes back from its reference direction,
    # so the reversal is half on either side
    exact = 150.0 * 50e-6 * np.cos(angles) ** 2 + 0.0025 * np.sign(np.sin(angles)) * np.cos(angles)
    assert np.abs(deviations - exact).max() < 1e-6
    ballbar = read_circular((tmp_path / "out" / "xy-150.b5r").read_bytes(), "xy-150.b5r")
    assert ballbar.feed == pytest.approx(2000.0, rel=1e-7)
    assert ballbar.header["machine"] == "VMC 850 SIM-1"
    one, other = ((tmp_path / "out" / name).read_bytes() for name in ("n1.csv", "n2.csv"))
    assert one != other  # two circles do not share their noise
    again = simulate_files(Session(), machine, tmp_path / "again", seed=2)
    assert {path.name: path.read_bytes() for path in again} == {
        path.name: path.read_bytes() for path in written
    }


def test_numbers_of_a_machine_file_arrive_in_their_units() -> None:
    errors = read_machine(MACHINE.encode(), "machine.yaml").circles["xy-150"].errors
    assert errors.squareness == pytest.approx(30e-6)
    assert errors.second.lost_motion == pytest.approx((4e-3, 6e-3))
    assert errors.second.pitch == 10.0


def test_another_seed_is_another_measurement(tmp_path: Path) -> None:
    machine = read_machine(MACHINE.encode(), "machine.yaml")
    for seed in (1, 2):
        simulate_files(Session(), machine, tmp_path / str(seed), seed=seed)
    assert (tmp_path / "1" / "n1.csv").read_bytes() != (tmp_path / "2" / "n1.csv").read_bytes()
    assert (tmp_path / "1" / "plain.csv").read_bytes() == (
        tmp_path / "2" / "plain.csv"
    ).read_bytes()


def test_tables_act_on_the_circle() -> None:
    machine = read_machine(MACHINE.encode(), "machine.yaml")

    def correction(positions: FloatArray, direction: Direction) -> FloatArray:
        return -machine.error("X", positions, direction)

    bare = machine.record_circle("plain", seed=0).test
    corrected = machine.record_circle("plain", seed=0, corrections={"X": correction}).test
    assert np.abs(bare.runs[0].deviations).max() > 5e-3
    assert np.abs(corrected.runs[0].deviations).max() < 1e-9


def test_circles_without_axes_and_their_units() -> None:
    text = """
virtual_machine: 1
circles:
  c:
    plane: ZX
    arc: {start_deg: -110, extent_deg: 220}
    calibrated: false
    error:
      offset_um: [3, -2]
      bar_um: 1.5
      radius_change_um: 0.5
      noise_um: 0.1
      correlated_noise_um: 0.2
      correlation: 0.9
      Z: {scale_um_per_m: 20, gain_per_s: 40, spike_um: 3, spike_length_mm: 4, lateral_play_um: 1, straightness_um: 2}
      X: {lost_motion_um: 4, lag_ms: 0.5, cyclic: {amplitude_um: 1, pitch_mm: 12, phase_deg: 90}}
"""
    circle = read_machine(text.encode(), "m.yaml").circles["c"]
    z, x = circle.errors.first, circle.errors.second
    assert (
        z.scale,
        z.gain,
        z.spike,
        z.spike_length,
        z.lateral_play,
        z.straightness,
    ) == pytest.approx((20e-6, 40, 3e-3, 4, 1e-3, 2e-3))
    assert (*x.lost_motion, x.lag, x.cyclic, x.pitch, x.phase) == pytest.approx(
        (4e-3, 4e-3, 5e-4, 1e-3, 12, math.pi / 2)
    )
    errors = circle.errors
    assert (*errors.offset, errors.bar, errors.radius_change) == pytest.approx(
        (3e-3, -2e-3, 1.5e-3, 5e-4)
    )
    assert (errors.noise, errors.correlated_noise, errors.correlation) == pytest.approx(
        (1e-4, 2e-4, 0.9)
    )
    assert circle.plan.arc == (-110.0, 220.0)
    assert circle.plan.axes == ("Z", "X")
    assert not circle.plan.calibrated


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("plane: XY", "plane: XX", "line 12, circles.xy-150.plane names no plane"),
        (
            "centre: [400, 250]\n    feed",
            "centre: [100, 250]\n    feed",
            "puts the circle outside the travel",
        ),
        ("lag_ms: 0.5", "lag_um: 0.5", "unknown key; expected 'lag_ms'"),
        ("format: b5r", "format: rtl", "expected 'csv' or 'b5r'"),
        ("  plain:", "  x:", "is the name of an axis too"),
        ("  plain:", "  a/b:", "is not the name of a circle"),
        ("feed_mm_min: 2000", "feed_mm_min: 0", "expected more than 0"),
        ("[4, 6]", "[4, 6, 8]", "a list of 2 numbers"),
        ("feed_mm_min: 2000", "sample_rate_hz: 0.1", "samples in a run"),
        ("feed_mm_min: 2000", "arc: {extent_deg: 45}", "expected 90 or more"),
        ("feed_mm_min: 2000", "arc: {extent_deg: 400}", "expected 360 or less"),
        ("squareness_um_per_m: 30", "correlation: 1", "expected less than 1"),
        ("squareness_um_per_m: 30", "noise_um: -1", "expected 0 or more"),
        ("feed_mm_min: 2000", "calibrated: yes", "true or false"),
        ("feed_mm_min: 2000", "overshoot_deg: 400", "expected 360 or less"),
    ],
)
def test_faulty_circles_are_refused_with_their_place(old: str, new: str, words: str) -> None:
    assert old in MACHINE
    with pytest.raises(UsageError) as caught:
        read_machine(MACHINE.replace(old, new).encode(), "machine.yaml")
    assert words in str(caught.value)
