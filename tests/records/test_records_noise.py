"""The noise of a test as numbers: order and progress over the runs, scale, parts taken away."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.records.noise import normal_noise, progress, traverse_order, without


def test_traverses_alternate_beginning_with_plus() -> None:
    plus, minus = traverse_order(3, 3)
    assert list(plus) == [0, 2, 4]
    assert list(minus) == [1, 3, 5]


def test_traverses_left_over_come_last() -> None:
    plus, minus = traverse_order(2, 4)
    assert list(plus) == [0, 2]
    assert list(minus) == [1, 3, 4, 5]


def test_progress_is_even_or_flattens_out() -> None:
    """Warming up with a time constant of a third of the test: (1 - e^-1.5) / (1 - e^-3) = 0.8176
    at half time.
    """
    even, flattening = progress(5, np.array([0.0, 3.0]))
    assert even == pytest.approx([0.0, 0.25, 0.5, 0.75, 1.0], abs=1e-8)
    assert flattening[[0, 2, 4]] == pytest.approx([0.0, 0.8176, 1.0], abs=1e-4)
    assert list(progress(1, np.array(2.0))) == [0.0]


def test_the_scale_changes_along_the_travel() -> None:
    """exp(0.5 cos(pi (u + 1) / 2)) at u = -1, 0, 1 and beyond the end, where it stays."""
    noise = normal_noise(np.array([2.0]), centre=100.0, half=100.0)
    noise = replace(noise, growth=np.array([[0.5]]), sigma=np.array([[2.0, 4.0]]))
    along = noise.scale_at(np.array([0.0, 100.0, 200.0, 300.0]))
    expected = np.array([3.2974, 2.0, 1.2131, 1.2131])
    assert along[0] == pytest.approx(np.stack([expected, 2.0 * expected]), abs=1e-4)


def test_a_part_is_taken_away_and_the_rest_stays() -> None:
    noise = normal_noise(np.array([1.0, 2.0]))
    quiet = without(noise, "scatter", "drift")
    assert not np.any(quiet.sigma)
    assert np.all(np.isinf(quiet.dof))
    assert noise.taken(np.array([1, 1, 0])).sigma[:, 1] == pytest.approx([2.0, 2.0, 1.0])
