"""The noise of a test as numbers: the order of the cycle, and parts taken away."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.records.noise import cycle_times, normal_noise, traverse_order, without


def test_a_standard_cycle_goes_up_and_down_in_turn() -> None:
    """Two runs over three targets: +1 up, -1 down, +2 up, -2 down; twelve readings, 1/11 apart."""
    plus, minus = cycle_times(3, 2, 2, "standard")
    assert (plus + 0.5) * 11.0 == pytest.approx(np.array([[0, 6], [1, 7], [2, 8]]))
    assert (minus + 0.5) * 11.0 == pytest.approx(np.array([[5, 11], [4, 10], [3, 9]]))


def test_a_step_cycle_ends_with_one_target_before_the_next() -> None:
    """ISO 230-2:1997, annex A: +, -, +, - at each target; twelve readings."""
    plus, minus = cycle_times(3, 2, 2, "step")
    assert (plus + 0.5) * 11.0 == pytest.approx(np.array([[0, 2], [4, 6], [8, 10]]))
    assert (minus + 0.5) * 11.0 == pytest.approx(np.array([[1, 3], [5, 7], [9, 11]]))


@pytest.mark.parametrize("cycle", ["standard", "step"])
@pytest.mark.parametrize(("positive", "negative"), [(5, 5), (3, 5), (5, 0), (0, 2), (1, 1)])
def test_every_reading_has_its_own_time(cycle: str, positive: int, negative: int) -> None:
    blocks = cycle_times(7, positive, negative, cycle)  # type: ignore[arg-type]
    assert [block.shape for block in blocks] == [(7, positive), (7, negative)]
    times = np.sort(np.concatenate([block.ravel() for block in blocks]))
    assert times == pytest.approx(np.linspace(-0.5, 0.5, 7 * (positive + negative)))


def test_traverses_left_over_come_last() -> None:
    plus, minus = traverse_order(2, 4)
    assert list(plus) == [0, 2]
    assert list(minus) == [1, 3, 4, 5]


def test_a_part_is_taken_away_and_the_rest_stays() -> None:
    noise = normal_noise(np.array([1.0, 2.0]))
    drifting = without(noise, "scatter", "drift")
    assert not np.any(drifting.sigma)
    assert np.all(np.isinf(drifting.dof))
    assert noise.taken(np.array([1, 1, 0])).sigma[:, 1] == pytest.approx([2.0, 2.0, 1.0])
