"""Directions of a circular test that are exchanged in the file: what follows a reversal in time
then comes before it. Machines from the exact path, and the real files.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured, random_machine
from circular_samples import ballbar_file
from compwright.estimation.circle_directions import exchange_odds
from compwright.estimation.circle_model import circle_samples
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.records.circular import CircularTest, Sense
from places import REAL, needs_shared

FILES = sorted((REAL / "ballbar").glob("*.b5r"))
OTHER: dict[Sense, Sense] = {"ccw": "cw", "cw": "ccw"}
#: A thousand to one, from which a statement is clear.
CLEAR = np.log(1000.0)


def exchanged(test: CircularTest) -> CircularTest:
    """The test whose file calls each run by the other direction."""
    runs = [
        replace(
            run,
            sense=OTHER[run.sense],
            angles=run.angles[::-1],
            deviations=run.deviations[::-1],
        )
        for run in test.runs
    ]
    return replace(test, runs=tuple(runs))


def odds(test: CircularTest) -> float:
    return exchange_odds(circle_samples(test))


def spiked(
    height: float, *, start: float = 45.0, extent: float = 360.0, seed: int = 1
) -> CircularTest:
    machine = Machine(
        squareness=30.0,
        backlash_first_at_positive=2.0,
        backlash_second_at_negative=3.0,
        servo_mismatch=0.2,
        reversal_spike_first=height,
        reversal_spike_second=0.7 * height,
        lag=5.0,
    )
    setup = Setup(feed=1000.0, noise=0.2, start=start, extent=extent)
    return measured(machine, setup, np.random.default_rng(seed))


@pytest.mark.parametrize(("start", "extent"), [(45.0, 360.0), (0.0, 360.0), (250.0, 220.0)])
@pytest.mark.parametrize("height", [4.0, -4.0])
def test_spikes_before_their_reversal_are_a_doubt(
    height: float, start: float, extent: float
) -> None:
    test = spiked(height, start=start, extent=extent)
    result = diagnose_circle(test, "iso230-4:2005")
    assert "CW-D012" not in {finding.code for finding in result.findings}
    result = diagnose_circle(exchanged(test), "iso230-4:2005")
    (found,) = (finding for finding in result.findings if finding.code == "CW-D012")
    assert found.is_doubt


def test_no_machine_with_right_directions_is_doubted() -> None:
    """Sixty machines of mixed causes; some have no spikes or delays at all."""
    rng = np.random.default_rng(20261128)
    most = -np.inf
    for number in range(60):
        radius, feed = float(rng.choice([50.0, 100.0, 150.0])), float(rng.choice([500.0, 1e3, 3e3]))
        setup = Setup(radius=radius, feed=feed, noise=0.2, wander=0.3 * (number % 2))
        machine = random_machine(rng, radius)
        most = max(most, odds(measured(machine, setup, rng)))
    assert most < CLEAR


def test_a_circle_without_any_reversal_effect_decides_nothing() -> None:
    test = measured(Machine(squareness=50.0), Setup(noise=0.2), np.random.default_rng(5))
    assert abs(odds(test)) < CLEAR
    assert odds(replace(test, runs=test.runs[:1])) == -np.inf


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_real_files_have_the_directions_that_they_state(path: Path) -> None:
    test, _ = ballbar_file(path)
    assert odds(test) < -CLEAR
    assert odds(exchanged(test)) > CLEAR


@needs_shared
def test_a_real_circle_with_clear_spikes_is_named_when_its_directions_are_exchanged() -> None:
    test, _ = ballbar_file(REAL / "ballbar" / "ballbar_qc20w_150mm_XY.b5r")
    for given, named in ((test, []), (exchanged(test), ["CW-D012"])):
        result = diagnose_circle(given, "iso230-4:2005")
        assert [one.code for one in result.findings if one.code == "CW-D012"] == named


def turned(test: CircularTest, way: str) -> CircularTest:
    """The test as a file states it whose deviations or angles have the other sign."""
    runs = [
        replace(run, deviations=-run.deviations)
        if way == "deviations"
        else replace(run, angles=-run.angles[::-1] % 360.0, deviations=run.deviations[::-1])
        for run in test.runs
    ]
    if way == "angles":
        order = [np.argsort(run.angles) for run in runs]
        runs = [
            replace(run, angles=run.angles[by], deviations=run.deviations[by])
            for run, by in zip(runs, order, strict=True)
        ]
    return replace(test, runs=tuple(runs))


@pytest.mark.parametrize("way", ["deviations", "angles"])
def test_a_turned_sign_shows_as_negative_lost_motion(way: str) -> None:
    """Squareness has the wrong sign then, and nothing else of the file shows it."""
    machine = Machine(
        squareness=60.0,
        backlash_first_at_positive=4.0,
        backlash_first_at_negative=3.0,
        backlash_second_at_positive=2.0,
        backlash_second_at_negative=2.0,
    )
    test = measured(machine, Setup(noise=0.2), np.random.default_rng(3))
    right = diagnose_circle(test, "iso230-4:2005")
    assert "CW-D013" not in {finding.code for finding in right.findings}
    wrong = diagnose_circle(turned(test, way), "iso230-4:2005")
    (found,) = (finding for finding in wrong.findings if finding.code == "CW-D013")
    assert found.is_doubt
    assert wrong.diagnosis is not None
    assert wrong.diagnosis.effects["squareness"].value == pytest.approx(-60.0, abs=3.0)


def test_little_negative_lost_motion_is_no_doubt() -> None:
    """A backlash value that is a little too large makes it; CW-T032 has the same bound."""
    machine = Machine(
        backlash_first_at_positive=-1.7,
        backlash_first_at_negative=-1.5,
        backlash_second_at_positive=-1.7,
        backlash_second_at_negative=-1.7,
    )
    test = measured(machine, Setup(noise=0.2), np.random.default_rng(3))
    result = diagnose_circle(test, "iso230-4:2005")
    assert "CW-D013" not in {finding.code for finding in result.findings}


@pytest.mark.parametrize(
    ("start", "drift", "lost", "runs"),
    [(0.0, 8.0, 0.0, 2), (90.0, -12.0, 4.0, 2), (45.0, 8.0, 0.0, 2), (0.0, 0.0, 8.0, 0)],
)
def test_a_radius_that_drifts_is_named_wherever_the_run_begins(
    start: float, drift: float, lost: float, runs: int
) -> None:
    """At a reversal point lost motion makes the same step between the ends as a drift."""
    machine = Machine(
        spiral=drift, backlash_first_at_positive=lost, backlash_second_at_positive=lost
    )
    test = measured(machine, Setup(noise=0.2, start=start), np.random.default_rng(4))
    findings = diagnose_circle(test, "iso230-4:2005").findings
    assert len([finding for finding in findings if finding.code == "CW-C012"]) == runs
