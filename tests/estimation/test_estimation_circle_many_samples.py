"""Circular tests with thousands of samples in a run."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured, random_machine
from compwright.estimation.circle import MOST_SAMPLES, diagnose


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


def test_no_vibration_is_reported_from_averaged_samples() -> None:
    setup = Setup(noise=0.05, samples=3 * MOST_SAMPLES, feed=500.0)
    sound = measured(Machine(squareness=20.0), setup, np.random.default_rng(0))
    # 0.6 µm at a third of the sample rate: the mean of three neighbours does not show it.
    shaken = replace(
        sound,
        runs=tuple(
            replace(
                run,
                deviations=run.deviations
                + 0.6e-3 * np.cos(2.0 * np.pi / 3.0 * np.arange(run.angles.size)),
            )
            for run in sound.runs
        ),
    )
    assert "vibration" in diagnose(shaken).undetermined
    few = replace(
        sound,
        runs=tuple(
            replace(r, angles=r.angles[::6], deviations=r.deviations[::6]) for r in sound.runs
        ),
    )
    assert "vibration" not in diagnose(few).undetermined
