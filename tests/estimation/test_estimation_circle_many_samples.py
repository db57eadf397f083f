"""Circular tests with thousands of samples in a run."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured, random_machine, truth
from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularTest


@pytest.mark.parametrize("seed", [0, 1, 3, 4])
def test_a_cyclic_error_that_is_not_there_is_bounded_by_the_samples(seed: int) -> None:
    rng = np.random.default_rng(seed)
    setup = Setup(noise=0.05, samples=3600)
    machine = replace(
        random_machine(rng, setup.radius),
        cyclic_first=0.0,
        reversal_spike_first=6.0,
        reversal_spike_second=8.0,
        decay_first=25.0,
        decay_second=25.0,
    )
    effect = diagnose(measured(machine, setup, rng)).effects["cyclic_first"]
    # The bound of an amplitude from n samples of both runs that x cosθ halves: 0.05 sqrt(4 / 7200)
    # = 0.0012; a search over all pitches finds four to ten times that.
    assert effect.value < 0.02
    assert 0.0012 < effect.std_error < 0.03


def test_a_mean_of_readings_before_and_after_a_reversal_is_modelled_as_such() -> None:
    """10 472 readings, in means of three: at 90° and 270° two lie before the reversal and one
    after it. 20 µm of lost motion left a third of it there, 6.7 µm, where the noise is 0.02 µm.
    """
    setup = Setup(noise=0.02, samples=10_472, feed=900.0)
    machine = Machine(
        backlash_first_at_positive=20.0,
        backlash_first_at_negative=20.0,
        backlash_second_at_positive=20.0,
        backlash_second_at_negative=20.0,
    )
    found = diagnose(measured(machine, setup, np.random.default_rng(3)))
    assert found.residual < 0.02e-3
    for axis in ("first", "second"):
        effect = found.effects[f"backlash_{axis}"]
        assert abs(effect.value - 20.0) < 2.5 * effect.std_error + 0.005, axis


def test_the_causes_of_long_runs_lie_within_their_errors() -> None:
    """50 000 readings. The sharpest spike lasts 1.5 mm, 40 readings; the shorter pitch is 2 mm."""
    setup = Setup(noise=0.3, wander=0.05, length=500.0, samples=25_000, feed=1000.0)
    machine = Machine(
        squareness=25.0,
        backlash_first_at_positive=3.0,
        backlash_first_at_negative=1.0,
        backlash_second_at_positive=2.0,
        backlash_second_at_negative=2.5,
        servo_mismatch=0.2,
        lateral_play_second=1.5,
        straightness_first=2.0,
        reversal_spike_first=4.0,
        reversal_spike_second=2.0,
        decay_first=1.5,
        decay_second=6.0,
        cyclic_first=0.5,
        cyclic_second=0.4,
        pitch_first=2.0,
        pitch_second=10.0,
    )
    true = {**truth(machine, setup), "cyclic_first": 0.5, "cyclic_second": 0.4}
    true |= {"reversal_spike_first": 4.0, "reversal_spike_second": 2.0}
    off = []
    for seed in (21, 22):
        found = diagnose(measured(machine, setup, np.random.default_rng(seed))).effects
        off += [
            (found[name].value - true[name]) / found[name].std_error
            for name in true.keys() & found.keys() - {"scale_error_first", "scale_error_second"}
        ]
        # The bound of an amplitude that x cosθ halves, from n readings: 0.3 sqrt(4 / n) = 0.003;
        # that of a spike, from 40 readings at each of four reversals: 0.3 sqrt(2 / 160) = 0.03.
        assert found["cyclic_first"].std_error < 0.01
        assert found["reversal_spike_first"].std_error < 0.4
        assert found["cyclic_first"].more["period"] == pytest.approx(2.0, rel=1e-4)
    assert np.mean(np.abs(off) <= 2.0) >= 0.9
    assert np.sqrt(np.mean(np.square(off))) < 1.3


#: Unlike ends, a spike and a lag at the reversals of one axis, a cyclic error at the other.
REVERSING = Machine(
    squareness=20.0,
    backlash_first_at_positive=3.0,
    backlash_first_at_negative=2.0,
    reversal_spike_first=4.0,
    decay_first=1.0,
    cyclic_second=2.0,
    pitch_second=5.0,
    lag=8.0,
)


def shaken(
    setup: Setup, frequency: float, amplitude: float, axis: str | None, seed: int
) -> CircularTest:
    """Return a test of the machine whose ``axis`` (None: the bar) vibrates at a ``frequency``, Hz,
    with an ``amplitude``, um, and with a phase of its own in each run.
    """
    rng = np.random.default_rng(seed)
    test = measured(REVERSING, setup, rng)
    turn = 2.0 * np.pi * setup.radius / (setup.feed / 60.0)
    seconds = np.arange(setup.samples) * turn / setup.samples
    runs = []
    for run in test.runs:
        theta = np.radians(run.angles)
        share = {None: np.ones_like(theta), "X": np.cos(theta), "Y": np.sin(theta)}[axis]
        wave = np.cos(2.0 * np.pi * (frequency * seconds + rng.uniform()))
        runs.append(replace(run, deviations=run.deviations + 1e-3 * amplitude * share * wave))
    return replace(test, runs=tuple(runs))


@pytest.mark.parametrize(
    ("frequency", "rate", "samples", "axis"),
    [
        (30.0, 250.0, 4001, None),
        (30.0, 1000.0, 12000, "X"),
        (300.0, 700.0, 9000, None),
        (900.0, 2000.0, 4001, "Y"),
        # The rate of the means of five samples: a mean over whole periods shows nothing.
        (400.0, 2000.0, 20000, None),
    ],
)
def test_a_vibration_is_found_in_long_runs(
    frequency: float, rate: float, samples: int, axis: str | None
) -> None:
    setup = Setup(
        noise=0.1, samples=samples, feed=60.0 * 2.0 * np.pi * 150.0 * rate / samples, radius=150.0
    )
    effect = diagnose(shaken(setup, frequency, 0.3, axis, 3)).effects["vibration"]
    size = 0.3 if axis is None else 0.3 * np.sqrt(0.5)
    # The bound of an amplitude from n samples with noise s in both runs: s / sqrt(n).
    bound = 0.1 / np.sqrt(samples)
    assert effect.axis == axis
    assert abs(effect.value - size) < min(2.0 * effect.std_error, 3.0 * bound)
    # The bound of a frequency is sqrt(3) / (pi T) times the relative error of the amplitude.
    turn = samples / rate
    bound *= np.sqrt(3.0) / (np.pi * turn * size)
    assert abs((effect.more["frequency"] or 0.0) - frequency) < 3.0 * bound + 0.005 / turn
    assert effect.effect == pytest.approx(0.6, rel=0.05)


@pytest.mark.parametrize("samples", [4001, 8000])
def test_long_runs_without_a_vibration_have_none(samples: int) -> None:
    """A vibration as large as what may be hidden is found by chance in half of the tests; one of
    twice this size is found.
    """
    setup = Setup(noise=0.1, samples=samples, feed=2000.0)
    effect = diagnose(shaken(setup, 1.0, 0.0, None, 4)).effects["vibration"]
    assert effect.value == 0.0
    assert effect.more["frequency"] is None
    rate = samples / (2.0 * np.pi * setup.radius / (setup.feed / 60.0))
    for axis, name in ((None, "bar"), ("X", "first"), ("Y", "second")):
        hidden = effect.more[f"hidden_{name}"] or 0.0
        # Three to fifteen times the bound of an amplitude that is not searched, s / sqrt(n).
        assert 0.3 / np.sqrt(samples) < hidden < 1.5 / np.sqrt(samples)
        assert hidden <= 2.0 * effect.std_error
        own = 2.0 * hidden * (1.0 if axis is None else np.sqrt(2.0))
        found = diagnose(shaken(setup, 0.41 * rate, own, axis, 4)).effects["vibration"]
        assert found.more["frequency"] == pytest.approx(0.41 * rate, rel=1e-3)
        assert found.axis == axis


def test_other_causes_are_those_without_the_vibration() -> None:
    """A vibration of 1 um next to the rate of the means has 0.13 um in them, at 1.1 Hz. One of 3 um
    hides the lag of 8 ms, so that the errors of the spikes grow.
    """
    setup = Setup(noise=0.1, samples=12000, feed=1000.0)
    rate = setup.samples / (2.0 * np.pi * setup.radius / (setup.feed / 60.0))
    still, moved = (
        diagnose(shaken(setup, rate / 3.0 - 1.1, amplitude, None, 8)).effects
        for amplitude in (0.0, 1.0)
    )
    for name in ("squareness", "backlash_first", "reversal_spike_first_at_positive", "spiral"):
        assert abs(moved[name].value - still[name].value) < 0.3 * still[name].std_error, name
        assert moved[name].std_error < 1.2 * still[name].std_error, name
