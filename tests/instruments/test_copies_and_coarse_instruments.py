"""Readings copied with little changes are seen; an honest instrument that shows few digits is not
taken for a copy.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.evaluation.copied_runs import copied_run_findings
from compwright.foundations.session import Session
from compwright.workflow.inputs.job_inputs import read_measurement
from loop import Floats, Machine, csv_of
from one_test import read_positioning

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(noise=0.0006)
TARGETS = MACHINE.targets(count=17)
Readings = dict[int, Floats]


def doubts(folder: Path, readings: Readings) -> list[str]:
    """The doubts of a run of a LinuxCNC axis with these readings."""
    (folder / "x.csv").write_text(csv_of(TARGETS, readings))
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\n"
        "axes:\n  X: {travel: [0, 800], address: 0, before: [x.csv]}\n"
    )
    compwright(["run", str(folder / "job.yaml")])
    return [
        finding["code"]
        for finding in json.loads((folder / "job" / "prediction.json").read_text())["doubts"]
    ]


def changed_a_little(readings: Readings, columns: list[int], noise: float) -> Readings:
    """Runs taken from ``columns`` with fresh noise (mm) on top."""
    rng = np.random.default_rng(4)
    return {
        sign: block[:, columns] + rng.normal(0.0, noise, block.shape)
        for sign, block in readings.items()
    }


def findings(folder: Path, readings: Readings) -> list[str]:
    path = folder / "x.csv"
    path.write_text(csv_of(TARGETS, readings))
    return [finding.message for finding in copied_run_findings(read_measurement(Session(), path))]


def test_two_runs_made_five_with_a_little_noise_are_a_doubt(tmp_path: Path) -> None:
    """0.02 µm on copies of runs that differ by 0.85 µm from each other: no axis repeats so well in
    three runs and not in two.
    """
    assert "CW-T031" in doubts(
        tmp_path, changed_a_little(MACHINE.measure(TARGETS, 1), [0, 1, 0, 1, 0], 0.00002)
    )


@pytest.mark.parametrize("columns", [[0, 1, 2, 3, 3], [0, 0, 0, 0, 1], [0, 1, 2, 2, 2]])
def test_copied_runs_with_a_little_noise_are_found(tmp_path: Path, columns: list[int]) -> None:
    assert findings(tmp_path, changed_a_little(MACHINE.measure(TARGETS, 1), columns, 0.00001))


def test_one_direction_made_from_the_other_is_found(tmp_path: Path) -> None:
    """The two directions of one run have nothing in common but the axis: their noise is never the
    same at every target.
    """
    readings = MACHINE.measure(TARGETS, 1)
    assert findings(tmp_path, {1: readings[1], -1: readings[1] + 0.006})


@pytest.mark.parametrize("seed", range(12))
def test_honest_runs_are_no_copies(tmp_path: Path, seed: int) -> None:
    """Also where one traverse drifts, and where one lies off and scatters three times as much."""
    readings = MACHINE.measure(TARGETS, seed)
    readings[1][:, 0] += np.linspace(0.0, 0.004, TARGETS.size)
    readings[-1][:, 1] += 0.003 + np.random.default_rng(seed).normal(0.0, 0.0018, TARGETS.size)
    assert findings(tmp_path, readings) == []


@pytest.mark.parametrize(("noise", "step"), [(0.00002, 0.0001), (0.00005, 0.0001), (0.0004, 0.001)])
def test_a_display_coarser_than_the_noise_is_no_copy(
    tmp_path: Path, noise: float, step: float
) -> None:
    """Noise below the last digit: runs are the same to the last digit by chance (0.1 µm on linear
    scales, 1 µm on old displays).
    """
    machine = Machine(noise=noise)
    for seed in range(6):
        readings = {
            sign: np.round(block / step) * step
            for sign, block in machine.measure(TARGETS, seed).items()
        }
        assert findings(tmp_path, readings) == []


def test_an_exact_copy_in_few_digits_is_found(tmp_path: Path) -> None:
    """0.6 µm of noise at 0.1 µm: two runs that agree at all of 17 targets are no chance."""
    readings = {
        sign: np.round(block / 1e-4) * 1e-4 for sign, block in MACHINE.measure(TARGETS, 3).items()
    }
    assert findings(tmp_path, {sign: block[:, [0, 1, 2, 3, 3]] for sign, block in readings.items()})


def test_zeros_for_half_of_the_travel_are_a_doubt(tmp_path: Path) -> None:
    """A program that was stopped halfway, its sheet filled up with zeros: half of the table would
    be made of them.
    """
    readings = MACHINE.measure(TARGETS, 1)
    unmeasured = (np.arange(TARGETS.size) >= TARGETS.size // 2)[:, np.newaxis]
    assert "CW-T011" in doubts(
        tmp_path, {sign: np.where(unmeasured, 0.0, block) for sign, block in readings.items()}
    )


@pytest.mark.full_estimate
def test_an_instrument_zeroed_at_the_first_target_is_no_doubt(tmp_path: Path) -> None:
    readings = MACHINE.measure(TARGETS, 1)
    assert doubts(tmp_path, {sign: block - block[:1] for sign, block in readings.items()}) == []


@pytest.mark.full_estimate
def test_zeros_of_a_coarse_display_are_no_doubt(tmp_path: Path) -> None:
    """1 µm digits and 0.3 µm of noise about zero: most readings are zero."""
    rng = np.random.default_rng(1)
    near_zero = {
        sign: np.round(rng.normal(0.0, 0.0003, (TARGETS.size, 5)) / 1e-3) * 1e-3 for sign in (1, -1)
    }
    far = {
        sign: block + np.where(TARGETS > 600.0, 0.004, 0.0)[:, np.newaxis]
        for sign, block in near_zero.items()
    }
    assert "CW-T011" not in doubts(tmp_path, far)


def test_a_run_of_zeros_on_a_coarse_display_is_no_run_that_was_not_made() -> None:
    """A display of 1 µm shows a good axis (0.4 µm of noise) as 0 in eight readings of ten: a whole
    run of nine zeros is common.
    """
    rng = np.random.default_rng(4)
    shown = np.round(rng.normal(0.0, 0.4, (9, 10)))
    shown[:, 3] = 0.0
    rows = [f"{50.0 * k}," + ",".join(f"{value:g}" for value in row) for k, row in enumerate(shown)]
    head = (
        "# unit: um\ntarget_mm,"
        + ",".join(f"{sign}{run}" for run in range(1, 6) for sign in "+-")
        + "\n"
    )
    coarse = read_positioning((head + "\n".join(rows) + "\n").encode(), "coarse.csv")
    assert "CW-R010" not in [finding.code for finding in coarse.findings]
    fine = np.round(rng.normal(0.0, 4.0, (9, 10)), 1)
    fine[:, 3] = 0.0
    rows = [f"{50.0 * k}," + ",".join(f"{value:g}" for value in row) for k, row in enumerate(fine)]
    filled = read_positioning((head + "\n".join(rows) + "\n").encode(), "filled.csv")
    assert "CW-R010" in [finding.code for finding in filled.findings]
