"""Angles of one run that were counted in its direction of travel or from another axis; circles from
the exact path.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.evaluation.circular_angles import wrong_angles
from compwright.records.circular import CircularTest

BENT = Machine(
    squareness=35.0,
    backlash_first_at_positive=3.0,
    backlash_first_at_negative=3.0,
    backlash_second_at_positive=2.0,
    backlash_second_at_negative=2.0,
    reversal_spike_first=2.0,
    servo_mismatch=0.3,
    centre=(0.003, -0.002),
)


def mirrored(test: CircularTest, turn: float = 0.0) -> CircularTest:
    """The test with the angles of cw counted as it travels: ``turn`` minus the angle."""
    full = test.full_circle
    runs = (
        replace(run, angles=np.mod(turn - run.angles, 360.0) if full else turn - run.angles)
        if run.sense == "cw"
        else run
        for run in test.runs
    )
    return replace(test, runs=tuple(runs))


@pytest.mark.parametrize("samples", [180, 1500])
@pytest.mark.parametrize("lag", [0.0, 20.0])
def test_angles_in_the_direction_of_travel_are_a_doubt(samples: int, lag: float) -> None:
    setup = Setup(feed=1000.0, noise=0.2, samples=samples)
    test = measured(replace(BENT, lag=lag), setup, np.random.default_rng(samples))
    assert not wrong_angles(test)
    (finding,) = wrong_angles(mirrored(test))
    assert finding.code == "CW-C014"
    assert finding.is_doubt


def test_a_ball_that_moved_between_the_runs_is_none() -> None:
    """10 µm along the second axis, the bar well centred: mirrored, both centres agree."""
    test = measured(replace(BENT, centre=(0.0, 0.0)), Setup(noise=0.2), np.random.default_rng(3))
    moved = tuple(
        replace(
            run,
            deviations=run.deviations
            + (0.005 if run.sense == "cw" else -0.005) * np.sin(np.radians(run.angles)),
        )
        for run in test.runs
    )
    assert not wrong_angles(replace(test, runs=moved))


@pytest.mark.parametrize("start", [0.0, 90.0, 180.0, 270.0])
def test_angles_from_the_start_of_a_run_in_the_direction_of_travel(start: float) -> None:
    """What is at ``start`` - t is at ``start`` + t."""
    test = measured(BENT, Setup(start=start, noise=0.2), np.random.default_rng(7))
    (finding,) = wrong_angles(mirrored(test, 2.0 * start))
    assert np.mod(float(finding.values["turn"]) - 2.0 * start, 360.0) == 0.0


@pytest.mark.parametrize("start", [70.0, 250.0])
def test_angles_of_an_arc_in_the_direction_of_travel(start: float) -> None:
    """A cw run of 220° ends at ``start``, and its angles begin there."""
    test = measured(BENT, Setup(start=start, extent=220.0, noise=0.2), np.random.default_rng(4))
    assert not wrong_angles(test)
    (finding,) = wrong_angles(mirrored(test, 2.0 * start + 220.0))
    assert finding.values["turn"] == pytest.approx(2.0 * start + 220.0)


@pytest.mark.parametrize("turn", [90.0, 270.0])
def test_angles_from_another_axis_are_a_doubt(turn: float) -> None:
    """With a scale mismatch of 12 µm: it does not depend on the direction, and is turned too."""
    machine = replace(BENT, scale_error_first=40.0)
    test = measured(machine, Setup(noise=0.2), np.random.default_rng(5))
    assert not wrong_angles(test)
    runs = (
        replace(run, angles=np.mod(run.angles - turn, 360.0)) if run.sense == "cw" else run
        for run in test.runs
    )
    (finding,) = wrong_angles(replace(test, runs=tuple(runs)))
    assert finding.sentence.name == "CW-C014.turned"
    assert finding.values["turn"] == turn
    assert finding.is_doubt


def test_samples_without_noise_are_none() -> None:
    assert not wrong_angles(measured(Machine(squareness=35.0), Setup()))
