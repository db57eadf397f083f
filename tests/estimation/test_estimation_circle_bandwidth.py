"""Waves on a circle seen through an instrument that is slower than they are, waves that are only
correlated noise, and waves on a short arc.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularRun, CircularTest

CYCLIC = 2.0  # um
SETUP = Setup(radius=100.0, feed=2000.0, samples=1440, noise=0.1)


def filtered(test: CircularTest, slow: float) -> CircularTest:
    """Return what a first-order filter with a time constant of ``slow`` samples reads, begun one
    turn before.
    """

    def read(run: CircularRun) -> CircularRun:
        later = run.angles[-1] > run.angles[0]
        order = slice(None) if later == (run.sense == "ccw") else slice(None, None, -1)
        values, level, kept = run.deviations[order].copy(), 0.0, np.exp(-1.0 / slow)
        for _ in range(2):
            for index, value in enumerate(run.deviations[order]):
                level = kept * level + (1.0 - kept) * value
                values[index] = level
        return replace(run, deviations=values[order])

    return replace(test, runs=tuple(map(read, test.runs)))


@pytest.mark.parametrize("slow", [0.5, 2.0])
def test_a_cyclic_error_is_not_made_small_by_a_slow_instrument(slow: float) -> None:
    """A pitch of 8 mm is 18 samples where the axis is fastest: a filter of two samples loses 18 %
    there and nothing beside the reversals. Its delay shifts the wave by up to 0.9 mm.
    """
    machine = Machine(cyclic_first=CYCLIC, pitch_first=8.0)
    for seed in range(3):
        test = measured(machine, SETUP, np.random.default_rng(seed))
        effect = diagnose(filtered(test, slow)).effects["cyclic_first"]
        assert abs(effect.value - CYCLIC) < 3.0 * effect.std_error
        assert effect.std_error < 0.1
        assert effect.value > 0.96 * CYCLIC


@pytest.mark.parametrize(
    ("start", "samples", "amplitude", "pitch", "noise"),
    [(45.0, 383, 0.45, 10.0, 0.05), (30.0, 180, 1.3, 17.7, 0.15)],
)
def test_a_cyclic_error_between_the_axes_is_no_vibration(
    start: float, samples: int, amplitude: float, pitch: float, noise: float
) -> None:
    """Over these arcs the second axis moves 16 and 26 mm, far from the centre. A frequency that is
    wrong by half a period over this travel turns the phase at the centre by more than a turn.
    """
    setup = Setup(radius=50.0, feed=2000.0, start=start, extent=92.0, samples=samples, noise=noise)
    machine = Machine(cyclic_second=amplitude, pitch_second=pitch)
    for seed in range(4):
        effects = diagnose(measured(machine, setup, np.random.default_rng(seed))).effects
        cyclic, vibration = effects["cyclic_second"], effects["vibration"]
        assert vibration.more["frequency"] is None
        assert vibration.std_error < 0.1 * amplitude
        assert abs(cyclic.value - amplitude) < 3.0 * cyclic.std_error
        assert cyclic.std_error < 0.05 * amplitude


def test_cyclic_errors_of_both_axes_do_not_disturb_each_other() -> None:
    """While one of them is fitted alone, the other counts as noise: frequency and amplitude that
    were fitted then are wrong by 0.5 % and 2 %.
    """
    setup = replace(SETUP, radius=50.0, feed=4000.0, start=135.0, samples=1500, noise=0.05)
    sizes: dict[str, Any] = {"cyclic_first": 1.4, "cyclic_second": 1.9}
    machine = Machine(**sizes, pitch_first=8.0, pitch_second=8.0)
    for seed in range(2):
        effects = diagnose(measured(machine, setup, np.random.default_rng(seed))).effects
        for name, amplitude in sizes.items():
            assert abs(effects[name].value - amplitude) < 3.0 * effects[name].std_error
            assert effects[name].more["period"] == pytest.approx(8.0, abs=0.002)


def test_correlated_noise_is_no_vibration() -> None:
    setup = replace(SETUP, noise=0.02, wander=0.3, length=10.0)
    for seed in range(6):
        found = diagnose(measured(Machine(), setup, np.random.default_rng([5, seed])))
        effect = found.effects["vibration"]
        assert effect.value < 2.0 * effect.std_error


def test_a_vibration_near_the_sampling_rate_may_be_larger_than_it_shows() -> None:
    """1 µm at a fifth of the sampling rate, through a filter of 0.3 samples, shows 0.94 µm."""
    test = measured(Machine(), SETUP, np.random.default_rng(9))
    wave = 1e-3 * np.sin(2.0 * np.pi * 0.2 * np.arange(SETUP.samples))
    shaken = replace(
        test, runs=tuple(replace(run, deviations=run.deviations + wave) for run in test.runs)
    )
    effect = diagnose(filtered(shaken, 0.3)).effects["vibration"]
    assert abs(effect.value - 1.0) < 2.0 * effect.std_error
    assert 0.02 < effect.std_error < 0.2
