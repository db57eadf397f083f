"""The lag of both axes of a circle whose lost motion is taken up gradually: an axis stands still
after its reversal until its command has moved by the lost motion (ISO 230-4:1996, B.3.1).
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from circle_machine import Machine, Setup, measured
from compwright.estimation import circle as circle_module
from compwright.estimation.circle import diagnose
from compwright.estimation.circle_lag import Lag
from compwright.records.circular import CircularRun, CircularTest, Sense

RADIUS = 150.0  # mm
LOST = {"first": 12.0, "second": 7.0}  # um
CENTRE = (0.05, -0.03)  # mm
SQUARENESS = 40.0  # um/m
SAMPLES, FINE = 1500, 40


def with_play(command: NDArray[np.float64], lost: float) -> NDArray[np.float64]:
    """Return the positions of a slide that its command pushes with play ``lost`` (same unit)."""
    moved = np.empty_like(command)
    at = command[0]
    for index, pushed in enumerate(command):
        at = min(max(at, pushed - 0.5 * lost), pushed + 0.5 * lost)
        moved[index] = at
    return moved


def circle(feed: float, lag: float, seed: int) -> CircularTest:
    """Return a full circle of axes that are ``lag`` s late, after a quarter of a turn before it."""
    rng = np.random.default_rng(seed)
    omega = feed / 60.0 / RADIUS
    runs = []
    senses: tuple[tuple[Sense, float], ...] = (("ccw", 1.0), ("cw", -1.0))
    for sense, sign in senses:
        step = 2.0 * np.pi / SAMPLES
        turned = (np.arange(-SAMPLES // 4 * FINE, SAMPLES * FINE) / FINE + 0.5) * step
        actual = sign * (turned - omega * lag)
        x = with_play(RADIUS * np.cos(actual), 1e-3 * LOST["first"])[SAMPLES // 4 * FINE :: FINE]
        y = with_play(RADIUS * np.sin(actual), 1e-3 * LOST["second"])[SAMPLES // 4 * FINE :: FINE]
        length = np.hypot(x - 1e-6 * SQUARENESS * y + CENTRE[0], y + CENTRE[1])
        runs.append(
            CircularRun(
                sense=sense,
                number=1,
                angles=np.degrees(sign * turned[SAMPLES // 4 * FINE :: FINE]),
                deviations=length - RADIUS + 2e-4 * rng.standard_normal(SAMPLES),
            )
        )
    return CircularTest(
        name="xy",
        plane="XY",
        axes=("X", "Y"),
        nominal_radius=RADIUS,
        feed=feed,
        arc=(0.0, 360.0),
        calibrated=True,
        runs=tuple(runs),
    )


@pytest.mark.parametrize("feed", [1000.0, 3000.0])
@pytest.mark.parametrize("lag", [0.0, 60.0])
def test_a_lag_is_told_from_lost_motion_that_is_taken_up(feed: float, lag: float) -> None:
    """12 µm are taken up over 1.9 mm of arc: 114 ms at 1000 mm/min, 38 ms at 3000 mm/min."""
    for seed in range(2):
        found = diagnose(circle(feed, 1e-3 * lag, seed))
        shown = [each.values for each in found.findings if each.code == "CW-D011"]
        assert len(shown) == (lag > 0.0)
        for values in shown:
            assert abs(float(values["lag"]) - lag) < 2.5 * float(values["error"])
        true = {
            "squareness": SQUARENESS,
            "backlash_first": LOST["first"],
            "backlash_second": LOST["second"],
            "offset_change_first": 0.0,
            "offset_change_second": 0.0,
        }
        for name, value in true.items():
            effect = found.effects[name]
            assert abs(effect.value - value) < 3.0 * effect.std_error, (name, effect)


def test_a_reading_between_the_reversal_and_its_estimated_angle(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The runs begin at a reversal point. The axes reverse 0.9 samples later, and the lag says 1.1
    ± 0.3: the only reading before the reversal of the model is in fact after it. A spiral of
    -12.7 ± 0.2 µm and a lost motion of -4.9 µm were stated, where 0 and 8 µm are true.
    """
    count = 1885
    setup = Setup(radius=50.0, feed=1000.0, samples=count, start=90.0 - 180.0 / count, noise=0.1)
    step = 2.0 * np.pi / count
    machine = Machine(
        backlash_first_at_positive=3.0,
        backlash_first_at_negative=3.0,
        backlash_second_at_positive=8.0,
        backlash_second_at_negative=8.0,
        reversal_spike_first=3.0,
        reversal_spike_second=5.0,
        decay_first=1.0,
        decay_second=1.6,
        lag=1e3 * 0.9 * step * setup.radius / (setup.feed / 60.0),
    )
    monkeypatch.setattr(
        circle_module, "common_lag", lambda _: Lag(1.1 * step, 0.3 * step, clear=True)
    )
    found = diagnose(measured(machine, setup, np.random.default_rng(0)))
    for name, value in (
        ("spiral", 0.0),
        ("offset_change_first", 0.0),
        ("backlash_second_at_positive", 8.0),
        ("backlash_first_at_positive", 3.0),
    ):
        effect = found.effects[name]
        assert abs(effect.value - value) < 3.0 * effect.std_error, (name, effect)
        assert effect.std_error < 0.2


@pytest.mark.parametrize("lag", [23.0, 46.0])
def test_a_lag_that_no_reversal_shows_shifts_a_straightness_of_third_order(lag: float) -> None:
    """Without lost motion and spikes nothing shows the lag. It turns the fourth harmonic of the
    straightness, in opposite senses by direction: radius change (0.13 ± 0.01 µm at 23 ms) and
    lateral play of 0.2 µm were stated, where 0 is true.
    """
    setup = Setup(noise=0.07, feed=2300.0)
    machine = Machine(s_shape_first=-1.6, s_shape_second=1.6, servo_mismatch=0.5, lag=lag)
    for seed in range(2):
        found = diagnose(measured(machine, setup, np.random.default_rng(seed)))
        for name in ("radius_change", "lateral_play_first", "lateral_play_second"):
            effect = found.effects[name]
            assert abs(effect.value) < 3.0 * effect.std_error, (name, effect)


@pytest.mark.parametrize("known", [False, True])
def test_a_cyclic_error_of_late_axes(known: bool) -> None:
    """At 2 700 mm/min axes that are 42 ms late are 1.9 mm behind in each direction: in the middle
    of the travel a pitch of 5 mm has three quarters of a turn between the directions. 0.00 ± 0.10
    µm at a pitch of 4.27 mm was stated, and offset changes of 0.3 µm.
    """
    setup = Setup(radius=100.0, feed=2700.0, samples=1745, noise=0.1)
    machine = Machine(
        squareness=50.0,
        cyclic_first=4.8,
        pitch_first=5.0,
        cyclic_second=0.5,
        pitch_second=7.0,
        servo_mismatch=3.0,
        lag=42.0,
        centre=(0.012, -0.0135),
    )
    periods = {"X": 5.0} if known else None
    found = diagnose(measured(machine, setup, np.random.default_rng(2)), periods=periods)
    for name, value, error in (
        ("cyclic_first", 4.8, 0.02),
        ("cyclic_second", 0.5, 0.02),
        ("offset_change_first", 0.0, 0.02),
        ("offset_change_second", 0.0, 0.02),
        ("servo_mismatch", 3.0, 0.002),
        ("lateral_play_first", 0.0, 0.1),
        ("lateral_play_second", 0.0, 0.1),
        ("vibration", 0.0, 0.05),
    ):
        effect = found.effects[name]
        assert abs(effect.value - value) < 3.0 * effect.std_error, (name, effect)
        assert effect.std_error < error
    for axis, pitch in (("first", 5.0), ("second", 7.0)):
        assert found.effects[f"cyclic_{axis}"].more["period"] == pytest.approx(pitch, rel=1e-3)
    (shown,) = [each.values for each in found.findings if each.code == "CW-D011"]
    assert float(shown["lag"]) == pytest.approx(42.0, abs=2.0 * float(shown["error"]))
    assert float(shown["error"]) < 1.0


def test_a_cyclic_error_in_one_direction_of_late_axes() -> None:
    """Late axes turn a cyclic error by its delay in the one half of the circle and back in the
    other.
    """
    setup = Setup(radius=50.0, feed=3500.0, samples=900, noise=0.05, senses=("ccw",))
    machine = Machine(cyclic_second=1.4, pitch_second=4.0, lag=31.0)
    found = diagnose(measured(machine, setup, np.random.default_rng(2)))
    effect = found.effects["cyclic_second"]
    assert abs(effect.value - 1.4) < 3.0 * effect.std_error
    assert effect.std_error < 0.03
    assert effect.more["period"] == pytest.approx(4.0, rel=1e-3)
