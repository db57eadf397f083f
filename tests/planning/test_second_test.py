"""What one test leaves open is stated in µm of A; what a plain machine does not show is not."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from compwright.evaluation.standards import evaluate
from compwright.foundations.findings import Finding
from compwright.planning.axis_work import repeats_of_first, start_axis
from compwright.planning.second_test import second_test_findings, unequal_scatter
from compwright.prediction.active_corrections import no_correction
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from planning_samples import UM, Floats, axis_of, job_of, readings_of

pytestmark = pytest.mark.short_estimate

SEEDS = range(4)
M, N = 13, 5
TARGETS = np.linspace(30.0, 970.0, M)
#: The scatter of the runs of a machine that is quiet at first, µm.
RUNS = np.array([0.3, 0.4, 0.6, 1.2, 1.5])


def a_test(block: Floats, targets: Floats = TARGETS, name: str = "x") -> PositioningTest:
    """A test with readings (2, m, n) in µm."""
    plus, minus = block * UM
    return readings_of(plus, minus, targets, name=name)


def findings(*blocks: Floats) -> list[Finding]:
    """What a second test would decide, from tests (2, m, n) in µm taken in the same way."""
    job = job_of(axis_of())
    planned = tuple(
        PlannedTest(test=a_test(block, name=f"x{k}"), measured_in="as_found")
        for k, block in enumerate(blocks)
    )
    state = {"as_found": ControlState(format="any", axes={})}
    work = start_axis(job, job.axes["X"], planned, state, no_correction)
    return list(second_test_findings(work, no_correction, repeats_of_first(work)))


def seen(finding: Finding) -> str:
    return str(dict(finding.sentence.values)["seen"].name).removeprefix("CW-P165.")


def bounds(finding: Finding, *names: str) -> tuple[float, ...]:
    values: dict[str, Any] = dict(finding.sentence.values)
    return tuple(values[name] for name in names)


def accuracies(blocks: list[Floats]) -> Floats:
    """A of tests (2, m, n) in µm, by ISO 230-2."""
    results = [evaluate(a_test(one), checked=False) for one in blocks]
    return np.array([result.parameters["A"] or np.nan for result in results]) / UM


def resting(seed: int) -> Floats:
    """Readings that come to rest 0.65 µm on either side, give or take 0.5 µm."""
    rng = np.random.default_rng([165, seed])
    return 0.65 * rng.choice([-1.0, 1.0], (2, M, N)) + 0.5 * rng.standard_normal((2, M, N))


def scattering(seed: int, stds: Floats | float) -> Floats:
    return np.random.default_rng([166, seed]).standard_normal((2, M, N)) * stds


def test_places_of_rest_that_one_test_leaves_open() -> None:
    """One law holds the A of fresh tests of this machine; the other, without the rests, is higher:
    the standard deviation of five normal readings varies more.
    """
    said = [[each for each in findings(resting(seed)) if seen(each) == "rest"] for seed in SEEDS]
    stated = [each for (each,) in filter(None, said)]
    assert len(stated) >= 2
    fresh = accuracies([resting(100 + seed) for seed in range(60)])
    low, high, least, most = np.mean(
        [bounds(each, "low", "high", "least", "most") for each in stated], axis=0
    )
    assert np.mean((fresh > low) & (fresh < high)) > 0.6
    assert low < least
    assert high < most < 1.5 * high
    assert all("stopped at either of two positions" in each.message for each in stated)


def test_a_scatter_that_differs_between_the_runs() -> None:
    """The next day may be as quiet as the first run or as loud as the last one."""
    said = [
        [each for each in findings(scattering(seed, RUNS)) if seen(each) == "scatter"]
        for seed in SEEDS
    ]
    stated = [each for (each,) in filter(None, said)]
    assert len(stated) >= 3
    least, most = np.median([bounds(each, "least", "most") for each in stated], axis=0)
    quiet, loud = (
        np.median(accuracies([scattering(100 + seed, std) for seed in range(20)]))
        for std in (RUNS[0], RUNS[-1])
    )
    assert 0.5 * quiet < least < 1.5 * quiet
    assert 0.75 * loud < most < 1.6 * loud


@pytest.mark.parametrize("second", [False, True])
def test_a_plain_machine_and_two_tests_leave_nothing_open(second: bool) -> None:
    blocks = [
        [resting(seed), resting(200 + seed)] if second else [scattering(seed, 0.8)]
        for seed in SEEDS
    ]
    assert sum(bool(findings(*each)) for each in blocks) <= (0 if second else 1)


@pytest.mark.parametrize(("runs", "targets"), [(3, 20), (5, 11), (10, 11)])
def test_equal_runs_are_seldom_taken_for_unequal_ones(runs: int, targets: int) -> None:
    """One in a thousand of 300 tests with a scatter that grows along the travel, and with shifts of
    the traverses: three at most with a probability of 0.9997 (Poisson).
    """
    rng = np.random.default_rng(2026)
    along = np.linspace(0.5, 1.5, targets)
    counted = 0
    for _ in range(300):
        block = rng.standard_normal((2, targets, runs)) * along[:, np.newaxis]
        block = block + 3.0 * rng.standard_normal((2, 1, runs))
        counted += unequal_scatter(a_test(block, along)) is not None
    assert counted <= 3
