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


def test_the_scale_grows_along_the_travel() -> None:
    """exp(0.5 u) at u = -1, 1; a bulge of 0.3 leaves the mean of its logarithm over u at zero."""
    noise = normal_noise(np.array([2.0]), centre=100.0, half=100.0)
    noise = replace(noise, growth=np.array([0.5]), sigma=np.array([[2.0, 4.0]]))
    ends = noise.scale_at(np.array([0.0, 200.0]))
    assert ends[0] == pytest.approx(np.array([[1.2131, 3.2974], [2.4261, 6.5949]]), abs=1e-4)
    worn = replace(noise, growth=np.zeros(1), bulge=np.array([0.3]))
    along = np.log(worn.scale_at(np.linspace(0.0, 200.0, 2001))[0, 0] / 2.0)
    assert np.mean(along) == pytest.approx(0.0, abs=1e-3)
    assert along[1000] == pytest.approx(-0.1)


def test_a_part_is_taken_away_and_the_rest_stays() -> None:
    noise = normal_noise(np.array([1.0, 2.0]))
    quiet = without(noise, "scatter", "drift")
    assert not np.any(quiet.sigma)
    assert np.all(np.isinf(quiet.dof))
    assert noise.taken(np.array([1, 1, 0])).sigma[:, 1] == pytest.approx([2.0, 2.0, 1.0])
