"""One measurement given as two tests: by its runs, however they are numbered, and never by chance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.evaluation.repeats import share_a_run
from compwright.records.positioning import PositioningTest
from planning_samples import UM, Floats, readings_of

TARGETS = np.linspace(20.0, 980.0, 15)


def measured(
    seed: int, *, step: float = 0.0, runs: int = 5, targets: Floats = TARGETS
) -> PositioningTest:
    """Runs of one axis with 0.4 µm of noise, read in steps (mm; 0: exactly)."""
    rng = np.random.default_rng(seed)
    blocks = []
    for sign in (1.0, -1.0):
        error = 5.0 * UM * np.sin(targets / 200.0) - sign * 2.0 * UM
        block = error[:, np.newaxis] + 0.4 * UM * rng.standard_normal((targets.size, runs))
        blocks.append(np.round(block / step) * step if step else block)
    return readings_of(blocks[0], blocks[1], targets, name=f"t{seed}")


def part(test: PositioningTest, columns: list[int], zero: float = 0.0) -> PositioningTest:
    """Some runs of a test in an order of their own, read from another zero."""
    return replace(
        test,
        positive=test.positive[:, columns] + zero,
        negative=test.negative[:, columns] + zero,
        runs_positive=tuple(range(1, len(columns) + 1)),
        runs_negative=tuple(range(1, len(columns) + 1)),
    )


@pytest.mark.parametrize("columns", [[1, 2, 3, 4, 0], [0, 1, 2], [3]])
@pytest.mark.parametrize("zero", [0.0, 0.003])
@pytest.mark.parametrize("step", [0.0, 1e-4])
def test_runs_of_a_test_are_no_second_test(columns: list[int], zero: float, step: float) -> None:
    test = measured(1, step=step)
    again = part(test, columns, zero)
    assert share_a_run(test, again)
    assert share_a_run(again, test)


def test_some_targets_of_a_test_are_no_second_test() -> None:
    test = measured(1)
    fewer = replace(
        test, targets=TARGETS[3:11], positive=test.positive[3:11], negative=test.negative[3:11]
    )
    assert share_a_run(test, fewer)


@pytest.mark.parametrize("step", [0.0, 1e-4, 1e-3, 2e-3])
@pytest.mark.parametrize("runs", [1, 5])
def test_a_second_measurement_is_one_however_coarse_the_digits(step: float, runs: int) -> None:
    """0.4 µm of noise read in 1 or 2 µm: many readings agree to the last digit by chance."""
    for seed in range(5):
        assert not share_a_run(measured(seed, step=step), measured(seed + 50, step=step, runs=runs))


def test_machines_without_any_noise_may_read_alike() -> None:
    still = measured(1)
    mean = replace(
        still,
        positive=np.repeat(still.positive.mean(axis=1, keepdims=True), 5, axis=1),
        negative=np.repeat(still.positive.mean(axis=1, keepdims=True) + 4.0 * UM, 5, axis=1),
    )
    assert not share_a_run(mean, mean)


def test_runs_that_were_not_made_in_either_test_are_no_shared_run() -> None:
    one, other = measured(1), measured(2)
    for test in (one, other):
        test.negative[:, 4] = 0.0
    assert not share_a_run(one, other)


def test_another_reversal_is_another_measurement() -> None:
    """The same readings in + and 3 µm more in −: another backlash acted, at rapid traverse."""
    test = measured(1)
    assert not share_a_run(test, replace(test, negative=test.negative + 3.0 * UM))


def test_one_direction_of_a_test_is_no_second_test() -> None:
    test = measured(1)
    up = replace(test, negative=np.empty((TARGETS.size, 0)), runs_negative=())
    assert share_a_run(test, up)
    assert share_a_run(up, test)
