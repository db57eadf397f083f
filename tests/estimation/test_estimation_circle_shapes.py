"""Causes that imitate other causes on a circle or an arc: each value holds the truth within its
error.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Array, Machine, Setup, measured, truth
from compwright.estimation.circle import diagnose
from compwright.estimation.circle_model import ENDS

ARCS = [(70.0, 220.0), (250.0, 220.0), (0.0, 180.0), (100.0, 266.0)]


@pytest.mark.parametrize(("start", "extent"), ARCS)
@pytest.mark.parametrize("bent", ["s_shape_first", "s_shape_second"])
def test_a_straightness_of_third_order_is_no_squareness_of_an_arc(
    bent: str, start: float, extent: float
) -> None:
    """With its mean line at zero, 3 µm are 0.75 µm of sin4θ and 2 µm/m of squareness on 150 mm."""
    setup = Setup(start=start, extent=extent, samples=round(extent * 4.0), noise=0.1)
    machine = replace(Machine(squareness=20.0), **{bent: 3.0})  # type: ignore[arg-type]
    found = diagnose(measured(machine, setup, np.random.default_rng(7)))
    squareness = found.effects["squareness"]
    assert abs(squareness.value - 20.0) < 2.0 * squareness.std_error
    assert squareness.std_error < 25.0


@pytest.mark.parametrize("order", [4, 5, 6])
@pytest.mark.parametrize("start", [-34.0, 56.0])
def test_a_lobe_of_a_tenth_of_a_micrometre_is_no_squareness_of_an_arc(
    start: float, order: int
) -> None:
    """On 165°, with one reversal point of each axis, a lobe as large as one increment of the usual
    instrument looks like tens of µm/m: radial deviations of R/2 sin2θ differ little from it.
    """
    setup = Setup(radius=200.0, start=start, extent=165.0, samples=1365, noise=0.04)
    test = measured(Machine(squareness=18.0), setup, np.random.default_rng(3))
    runs = tuple(
        replace(run, deviations=run.deviations + 1e-4 * np.cos(order * np.radians(run.angles)))
        for run in test.runs
    )
    found = diagnose(replace(test, runs=runs)).effects
    for name, true in ("squareness", 18.0), ("scale_mismatch", 0.0), ("straightness_second", 0.0):
        assert abs(found[name].value - true) < 2.5 * found[name].std_error, name


@pytest.mark.parametrize("start", [315.0, 135.0])
def test_lost_motion_of_an_axis_that_does_not_reverse_is_no_radius_change(start: float) -> None:
    """The second axis moves in one sense through the arc. Its lost motion b changes along its travel,
    by 3.4 µm from end to end: by 1.7 µm y/R from its mean, of which half counts in each direction.
    """
    setup = Setup(radius=50.0, start=start, extent=92.0, samples=383, noise=0.05)
    lost = Machine(backlash_second_at_positive=6.8, backlash_second_at_negative=6.8)
    test = measured(lost, setup, np.random.default_rng(4))
    runs = []
    for run in test.runs:
        theta, turn = np.radians(run.angles), 1.0 if run.sense == "ccw" else -1.0
        more = 0.85e-3 * turn * np.sign(np.cos(theta)) * np.sin(theta) ** 2
        runs.append(replace(run, deviations=run.deviations + more))
    found = diagnose(replace(test, runs=tuple(runs))).effects
    for name in "radius_change", "lateral_play_first":
        assert abs(found[name].value) < 2.5 * found[name].std_error, name


@pytest.mark.parametrize(
    ("start", "senses"),
    [
        *((start, ("ccw", "cw")) for start in (0.0, 90.0, 180.0, 270.0)),
        (90.0, ("ccw",)),
        (180.0, ("cw",)),
    ],
)
def test_a_spiral_that_begins_at_a_reversal_point_is_no_lost_motion(
    start: float, senses: tuple[str, ...]
) -> None:
    """The jump from the end of a run to its begin has the sign of lost motion in both directions;
    only the ramp tells them apart.
    """
    setup = Setup(radius=50.0, start=start, senses=senses, noise=0.3)
    machine = Machine(spiral=-5.0, backlash_first_at_positive=3.0, backlash_first_at_negative=3.0)
    found = diagnose(measured(machine, setup, np.random.default_rng(8))).effects
    assert abs(found["spiral"].value + 5.0) < 2.0 * found["spiral"].std_error
    for name, true in truth(machine, setup).items():
        if name.startswith("backlash"):
            assert abs(found[name].value - true) < 2.5 * found[name].std_error, name


@pytest.mark.parametrize("senses", [("ccw", "cw"), ("ccw",)])
@pytest.mark.parametrize("start", [0.0, 270.0])
def test_a_large_spiral_is_no_lost_motion(start: float, senses: tuple[str, ...]) -> None:
    """A cold spindle grows by 30 µm during a run that begins at a reversal point, on a machine
    whose axes are late.
    """
    setup = Setup(radius=50.0, feed=3700.0, start=start, senses=senses, noise=0.25)
    diagnosis = diagnose(measured(Machine(spiral=30.0, lag=49.0), setup, np.random.default_rng(12)))
    found = diagnosis.effects
    assert "spiral" not in diagnosis.undetermined
    assert abs(found["spiral"].value - 30.0) < 2.5 * found["spiral"].std_error
    assert found["spiral"].std_error < 3.0
    for axis in ("first", "second"):
        for end in ENDS:
            lost = found[f"backlash_{axis}_at_{end}"]
            assert abs(lost.value) < 2.5 * lost.std_error


def test_a_spike_that_does_not_fall_exponentially_is_no_servo_mismatch() -> None:
    """A spike of 7 µm with a rise falls as 1 / (1 + t²), at both ends of the first axis. What is
    left of it far from the reversals looks like sin2θ with the sign of the direction. A sum of
    decays can never be this shape; the rest may count as noise, but not as a clear servo mismatch.
    """
    plain = Setup()
    since = np.mod((np.arange(plain.samples) + 0.5) * 2.0 * np.pi / plain.samples, np.pi)
    arc = plain.radius * since
    spike = 9.0 * (1.0 - np.exp(-arc / 0.8)) / (1.0 + (arc / 5.0) ** 2) * np.cos(since)
    setup = replace(plain, noise=0.1, extra=dict.fromkeys(plain.senses, spike))
    lost = {f"backlash_first_at_{end}": 3.0 for end in ("positive", "negative")}
    machine = replace(Machine(servo_mismatch=0.1), **lost)  # type: ignore[arg-type]
    errors = []
    for seed in range(1, 5):
        servo = diagnose(measured(machine, setup, np.random.default_rng(seed))).effects[
            "servo_mismatch"
        ]
        assert servo.std_error < 0.002
        errors.append((servo.value - 0.1) / servo.std_error)
    assert float(np.sqrt(np.mean(np.square(errors)))) < 3.0


@pytest.mark.parametrize("ramp", [True, False])
@pytest.mark.parametrize("time", [0.02, 0.05, 0.08])
def test_a_changeover_that_takes_a_time_is_no_scale_mismatch(time: float, ramp: bool) -> None:
    """A change of the radius by 3 µm at 45°, 135°, ..., passed in a time after these angles."""
    setup = Setup(radius=50.0, feed=4000.0, noise=0.1)
    steps = (np.arange(setup.samples) + 0.5) * 360.0 / setup.samples
    since = np.radians(np.mod(steps - 45.0, 90.0)) * setup.radius / (setup.feed / 60.0)
    into = np.where(np.mod(steps - 45.0, 180.0) < 90.0, -1.5, 1.5)
    left = np.maximum(1.0 - since / time, 0.0) if ramp else np.exp(-since / time)
    change = into * (1.0 - 2.0 * left)
    # The same angles by the time of a cw run, which begins at 360°: 45° from there is 315°.
    extra = {"ccw": change, "cw": change}
    test = measured(Machine(), replace(setup, extra=extra), np.random.default_rng(9))
    found = diagnose(test).effects
    assert abs(found["master_slave"].value - 3.0) < 2.0 * found["master_slave"].std_error
    assert abs(found["scale_mismatch"].value) < 2.0 * found["scale_mismatch"].std_error
    assert found["scale_mismatch"].std_error < 1.0


@pytest.mark.parametrize("axis", ["first", "second"])
@pytest.mark.parametrize(
    ("lost", "reach"), [(4.0, 20.0), (1.5, 40.0), (10.0, 95.0), (-4.0, 20.0), (-6.5, 60.0)]
)
def test_lost_motion_that_is_taken_up_gradually_is_no_spike(
    axis: str, lost: float, reach: float
) -> None:
    """Friction slips: exp(-travel / reach) of the lost motion, µm, is missing (Dahl 1968)."""
    setup = Setup(noise=0.1)
    steps = np.radians((np.arange(setup.samples) + 0.5) * 360.0 / setup.samples)
    extra = {}
    for sense, theta in (("ccw", steps), ("cw", 2.0 * np.pi - steps)):
        own = np.cos(theta) if axis == "first" else np.sin(theta)
        turned = np.mod(steps if axis == "first" else steps - 0.5 * np.pi, np.pi)
        missing = np.exp(-1e3 * setup.radius * (1.0 - np.cos(turned)) / reach)
        moves = np.sign(np.sin(theta) if axis == "first" else -np.cos(theta))
        moves = moves if sense == "ccw" else -moves
        extra[sense] = 0.5 * lost * moves * (1.0 - 2.0 * missing) * own
    test = measured(Machine(), replace(setup, extra=extra), np.random.default_rng(3))
    found = diagnose(test).effects
    for end in ENDS:
        spike = found[f"reversal_spike_{axis}_at_{end}"]
        assert abs(spike.value) < 2.0 * spike.std_error
        # Between no spike and all of it: at most half of the distance, and what the noise adds.
        assert spike.std_error < (0.5 * lost + 2.0 * setup.noise if lost > 0.0 else -lost)
        play = found[f"backlash_{axis}_at_{end}"]
        assert abs(play.value - lost) < 3.0 * play.std_error


@pytest.mark.parametrize("pitch", [100.0, 200.0])
def test_a_spike_of_an_axis_that_sticks_and_slips_has_the_error_of_this_motion(
    pitch: float,
) -> None:
    """The second axis lags and jumps by 3 µm at standstill, each ``pitch`` µm of its travel, before
    and after its reversals, and has no spike. At a tenth of the path speed 1/e of it is left.
    """
    setup = Setup(radius=50.0, feed=500.0, noise=0.1)
    steps = np.radians((np.arange(setup.samples) + 0.5) * 360.0 / setup.samples)
    extra, near = {}, np.abs(np.cos(steps)) < np.sin(np.radians(3.0))
    for sense, theta in (("ccw", steps), ("cw", 2.0 * np.pi - steps)):
        place = 1e3 * setup.radius * np.sin(theta)
        slip = np.mod(place / pitch + 0.3 * np.sin(7.3e-3 * place), 1.0) - 0.5
        moves = np.sign(np.cos(theta)) * (1.0 if sense == "ccw" else -1.0)
        slip *= -3.0 * moves * np.exp(-((np.cos(theta) / 0.1) ** 2))
        extra[sense] = slip * np.sin(theta)
    test = measured(Machine(), replace(setup, extra=extra), np.random.default_rng(1))
    found, moved = diagnose(test).effects, float(np.std(extra["ccw"][near]))
    for end in ENDS:
        spike = found[f"reversal_spike_second_at_{end}"]
        assert abs(spike.value) < 2.0 * spike.std_error
        assert 0.7 * moved < spike.std_error < 2.0 * moved


def reversing(setup: Setup, spike: Array, lost: float, missing: Array) -> Setup:
    """Return a setup whose first axis has a ``spike`` (n,), µm outward, after each reversal, and of
    whose lost motion a share (n,) is ``missing``, over the arc after the reversal.
    """
    own = spike + 0.5 * lost * (1.0 - 2.0 * missing)
    own = own * np.cos(after(setup) / setup.radius)
    return replace(setup, extra=dict.fromkeys(setup.senses, own))


def after(setup: Setup) -> Array:
    """Return the arc (n,), mm, after the last reversal of the first axis."""
    steps = np.radians((np.arange(setup.samples) + 0.5) * 360.0 / setup.samples)
    arc: Array = setup.radius * np.mod(steps, np.pi)
    return arc


def decaying(arc: Array, length: float) -> Array:
    """Return a spike (n,) of height 1 from ``arc`` 0 on. Its rise takes a third of its decay."""
    peak = np.log1p(3.0) / 3.0
    top = (1.0 - np.exp(-3.0 * peak)) * np.exp(-peak)
    share = np.maximum(arc, 0.0) / length
    found: Array = (1.0 - np.exp(-3.0 * share)) * np.exp(-share) / top
    return found


def errors_of_spikes(setup: Setup, height: float) -> tuple[list[float], list[float]]:
    """Return the errors of the spikes of the first axis in four tests, in standard errors, and the
    standard errors.
    """
    errors, stated = [], []
    for seed in (1, 2):
        found = diagnose(measured(Machine(), setup, np.random.default_rng(seed))).effects
        for end in ENDS:
            spike = found[f"reversal_spike_first_at_{end}"]
            errors.append((spike.value - height) / spike.std_error)
            stated.append(spike.std_error)
    return errors, stated


@pytest.mark.parametrize(
    ("samples", "feed", "length", "lost"),
    [(600, 1000.0, 0.35, 3.0), (800, 1500.0, 0.3, 3.0), (600, 1000.0, 0.4, 0.0)],
)
def test_a_spike_that_one_sample_shows_may_be_much_higher(
    samples: int, feed: float, length: float, lost: float
) -> None:
    """The only sample is 2 decays after the reversal: a spike of 5 µm shows 1 µm."""
    setup = Setup(samples=samples, feed=feed, noise=0.05)
    spike = 5.0 * decaying(after(setup), length)
    errors, stated = errors_of_spikes(reversing(setup, spike, lost, np.zeros_like(spike)), 5.0)
    assert np.max(np.abs(errors)) < 2.0
    assert np.max(stated) < 5.0


def test_a_small_spike_excludes_no_higher_one_between_the_samples() -> None:
    """Of the usual decays, 15 to 150 ms, a fifth are over before the first sample, 94 ms after the
    reversal. A spike of 5 µm with 24 ms shows 0.1 µm. One that is not seen is 4 µm high (standard
    deviation): the root of a fifth of that is 1.8 µm.
    """
    setup = Setup(samples=600, feed=500.0, noise=0.05)
    spike = 5.0 * decaying(after(setup), 0.2)
    errors, stated = errors_of_spikes(reversing(setup, spike, 0.0, np.zeros_like(spike)), 5.0)
    assert np.max(np.abs(errors)) < 3.0
    assert 1.7 < np.min(stated) <= np.max(stated) < 3.0


def test_a_spike_that_begins_when_lost_motion_is_passed_is_not_extrapolated_to_the_reversal() -> (
    None
):
    """An axis stands still over 1.6 mm of arc, which pass 9 µm of lost motion. A spike of 2 µm that
    decays over 0.5 mm begins there. From the reversal on it would be one of 40 µm.
    """
    setup = Setup(samples=3000, noise=0.1)
    arc = after(setup)
    travel = 1e3 * arc**2 / (2.0 * setup.radius)
    spike = 2.0 * decaying(arc - np.sqrt(2e-3 * 9.0 * setup.radius), 0.5)
    passed = reversing(setup, spike, 9.0, np.maximum(1.0 - travel / 9.0, 0.0))
    errors, _ = errors_of_spikes(passed, 2.0)
    assert np.max(np.abs(errors)) < 2.0


def test_a_small_inward_spike_is_not_stated_as_none() -> None:
    """A spike of -1 µm in noise of 0.4 µm is as likely found inward as not at all."""
    setup = Setup(noise=0.4)
    spike = -decaying(after(setup), 1.5)
    errors, stated = errors_of_spikes(reversing(setup, spike, 0.0, np.zeros_like(spike)), -1.0)
    assert np.max(np.abs(errors)) < 2.0
    assert np.median(stated) < 1.0


def test_a_spike_outward_can_be_hidden_by_lost_motion_that_is_taken_up() -> None:
    """At the reversal the path is inside by the lost motion of 5 µm less the spike of 3 µm."""
    setup = Setup(noise=0.1)
    arc = after(setup)
    missing = np.exp(-1e3 * setup.radius * (1.0 - np.cos(arc / setup.radius)) / 200.0)
    errors, _ = errors_of_spikes(reversing(setup, 3.0 * decaying(arc, 2.0), 5.0, missing), 3.0)
    assert np.max(np.abs(errors)) < 2.0
