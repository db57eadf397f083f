"""Reversal points of a circular test, each with a lost motion and a spike of its own, and symptoms
that are read with them; circles from the exact path (`circle_machine`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from circle_machine import Machine, Setup, measured
from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularTest

Array = NDArray[np.float64]
UM = 1e-3
LOST = Machine(
    backlash_first_at_positive=2.0,
    backlash_first_at_negative=2.0,
    backlash_second_at_positive=2.0,
    backlash_second_at_negative=2.0,
)


def outward(test: CircularTest, place: float, height: float, decay: float) -> CircularTest:
    """Return the test with a spike of ``height`` um and ``decay`` mm after the reversal at ``place``
    deg, in both directions.
    """
    runs = []
    for run in test.runs:
        sense = 1.0 if run.sense == "ccw" else -1.0
        since = np.mod(np.radians(sense * (run.angles - place)), 2.0 * np.pi) * test.nominal_radius
        runs.append(replace(run, deviations=run.deviations + UM * height * np.exp(-since / decay)))
    return replace(test, runs=tuple(runs))


@pytest.mark.parametrize("decay_ms", [50.0, 200.0])
def test_a_spike_at_one_end_is_no_lost_motion(decay_ms: float) -> None:
    """Lost motion of 2 um at both ends, spikes of 4 and 0 um, 1500 samples at 1 000 mm/min."""
    setup = Setup(feed=1000.0, start=44.88, noise=0.1)  # from 0° a spiral hides it
    test = measured(LOST, setup, np.random.default_rng(5))
    effects = diagnose(outward(test, 0.0, 4.0, decay_ms / 60.0)).effects
    expected = {
        "backlash_first": 2.0,
        "backlash_first_at_positive": 2.0,
        "backlash_first_at_negative": 2.0,
        "reversal_spike_first": 2.0,
        "reversal_spike_first_at_positive": 4.0,
        "reversal_spike_first_at_negative": 0.0,
        "reversal_spike_second_at_positive": 0.0,
    }
    for name, value in expected.items():
        assert abs(effects[name].value - value) < 3.0 * effects[name].std_error, name
    assert effects["backlash_first"].std_error < 0.1
    more = effects["reversal_spike_first_at_positive"].more
    assert more["decay"] == pytest.approx(decay_ms, rel=0.4)
    assert effects["reversal_spike_first_at_negative"].more["decay"] is None
    # Half a sample (19 ms) after the reversal: 4 exp(-19 / decay), and the noise of two maxima.
    assert more["raw_peak"] == pytest.approx(4.0 * np.exp(-18.85 / decay_ms), abs=0.3)


def test_the_raw_peak_of_an_inward_spike_is_the_lowest_reading() -> None:
    setup = Setup(feed=1000.0, start=44.88, noise=0.1)
    test = measured(Machine(), setup, np.random.default_rng(8))
    effect = diagnose(outward(test, 0.0, -4.0, 3.0)).effects["reversal_spike_first_at_positive"]
    assert effect.value < -2.0
    assert effect.more["raw_peak"] == pytest.approx(-4.0, abs=0.6)


def test_directions_that_differ_have_values_of_their_own() -> None:
    test = measured(LOST, Setup(feed=1000.0, noise=0.1), np.random.default_rng(6))
    spiked = outward(test, 90.0, 5.0, 4.0)
    effects = diagnose(replace(test, runs=(spiked.runs[0], test.runs[1]))).effects
    for name, height in (("_ccw", 5.0), ("_cw", 0.0)):
        effect = effects[f"reversal_spike_second_at_positive{name}"]
        assert abs(effect.value - height) < 3.0 * effect.std_error + 0.1
    assert not any(name.endswith("_cw") for name in diagnose(spiked).effects)


def test_centres_that_differ_between_the_directions() -> None:
    test = measured(Machine(), Setup(noise=0.1), np.random.default_rng(7))
    runs = []
    for run in test.runs:
        half = 0.5 * UM if run.sense == "ccw" else -0.5 * UM
        theta = np.radians(run.angles)
        moved = half * (1.2 * np.cos(theta) - 0.8 * np.sin(theta))
        runs.append(replace(run, deviations=run.deviations + moved))
    effects = diagnose(replace(test, runs=tuple(runs))).effects
    for axis, change in (("first", 1.2), ("second", -0.8)):
        effect = effects[f"offset_change_{axis}"]
        assert abs(effect.value - change) < 3.0 * effect.std_error
        assert effect.std_error < 0.2


def test_spiral_changeover_and_vibration() -> None:
    setup = Setup(start=30.0, noise=0.1)
    test = measured(LOST, setup, np.random.default_rng(8))
    seconds = (
        (np.arange(setup.samples) + 0.5) * 2.0 * np.pi * 150.0 / (2000.0 / 60.0) / setup.samples
    )
    runs = []
    for run in test.runs:
        theta = np.radians(run.angles)
        drift = 2.0 * (np.arange(setup.samples) / setup.samples - 0.5)
        step = 0.75 * np.sign(np.cos(2.0 * theta))
        wave = 0.5 * np.cos(2.0 * np.pi * 7.3 * seconds)
        runs.append(replace(run, deviations=run.deviations + UM * (drift + step + wave)))
    effects = diagnose(replace(test, runs=tuple(runs))).effects
    for name, value in (("spiral", 2.0), ("master_slave", 1.5), ("vibration", 0.5)):
        assert abs(effects[name].value - value) < 3.0 * effects[name].std_error, name
        assert effects[name].std_error < 0.3 * value, name
    assert effects["vibration"].more["frequency"] == pytest.approx(7.3, abs=0.02)
    assert diagnose(test).effects["vibration"].more["frequency"] is None


@pytest.mark.parametrize("along", [np.cos, np.sin])
def test_a_vibration_of_one_axis_has_the_root_mean_square_of_its_readings(
    along: Callable[[Array], Array],
) -> None:
    setup = Setup(start=30.0, noise=0.1)
    test = measured(LOST, setup, np.random.default_rng(12))
    turn = 2.0 * np.pi * setup.radius / (setup.feed / 60.0)
    seconds = (np.arange(setup.samples) + 0.5) * turn / setup.samples
    runs = []
    for run in test.runs:
        wave = UM * np.sin(2.0 * np.pi * 7.3 * seconds) * along(np.radians(run.angles))
        runs.append(replace(run, deviations=run.deviations + wave))
    effect = diagnose(replace(test, runs=tuple(runs))).effects["vibration"]
    assert abs(effect.value - np.sqrt(0.5)) < 2.0 * effect.std_error
    # The readings alone have 7.3 Hz plus and minus one turn, 0.035 Hz, each with a half.
    assert effect.more["frequency"] == pytest.approx(7.3, abs=0.01)


@pytest.mark.parametrize("start", [160.0, 250.0])
def test_a_vibration_along_the_bar_is_none_of_an_axis_on_an_arc(start: float) -> None:
    """In the middle of these arcs of 220°, one axis alone is in line with the bar."""
    setup = Setup(start=start, extent=220.0, samples=900, noise=0.1)
    test = measured(LOST, setup, np.random.default_rng(13))
    seconds = np.radians(220.0) * setup.radius / (setup.feed / 60.0)
    wave = np.sin(2.0 * np.pi * 7.3 * seconds * (np.arange(900) + 0.5) / 900)
    runs = [replace(run, deviations=run.deviations + 0.4 * UM * wave) for run in test.runs]
    effect = diagnose(replace(test, runs=tuple(runs))).effects["vibration"]
    assert effect.axis is None
    assert abs(effect.value - 0.4) < 2.0 * effect.std_error
    assert effect.std_error < 0.1


def test_lobes_are_amplitudes_of_the_mean_trace() -> None:
    """-(40 um/m)(0.15 m)/2 sin2θ has 3 um; k/4 sin3θ of a sag k = 4 um has 1 um."""
    machine = Machine(squareness=40.0, straightness_first=4.0, servo_mismatch=0.3)
    # At a low feed a servo mismatch takes nothing off the scale.
    setup = Setup(noise=0.1, feed=300.0)
    effects = diagnose(measured(machine, setup, np.random.default_rng(9))).effects
    for name, value in (("lobes_2", 3.0), ("lobes_3", 1.0)):
        assert effects[name].value == pytest.approx(value, abs=0.02)
        assert effects[name].std_error == pytest.approx(0.1 * np.sqrt(2.0 / 3000.0), rel=0.3)
    # Aligned with the first axis: 6 um of squareness at a corner, and a sag of 4 um of the corners
    # against the middles of two sides: (6, 4) and (-6, 0).
    assert effects["positional_tolerance"].value == pytest.approx(np.hypot(12.0, 4.0), abs=0.1)


def test_an_arc_gives_no_value_that_is_mostly_prior() -> None:
    setup = Setup(start=45.0, extent=90.0, samples=375, noise=0.3)
    found = diagnose(measured(LOST, setup, np.random.default_rng(10)))
    for name in ("squareness", "scale_mismatch", "lobes_2", "positional_tolerance"):
        assert name in found.undetermined, name
    effect = found.effects["backlash_second"]
    assert abs(effect.value - 2.0) < 3.0 * effect.std_error
