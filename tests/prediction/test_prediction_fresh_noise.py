"""Fresh noise: each part is drawn as large as it is told to be, and in its pattern."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.prediction.fresh_noise import fresh_noise
from compwright.records.axis import FloatArray
from compwright.records.noise import INDEPENDENT, RUNS, WALK, WAVE, NoiseDraws, normal_noise

TARGETS = np.linspace(0.0, 400.0, 5)
COUNT = 4000


def noise_of_size(sigma: float, **changes: object) -> NoiseDraws:
    quiet = normal_noise(np.full(COUNT, sigma), centre=200.0, half=200.0)
    arrays: dict[str, Any] = {
        name: np.full(COUNT, value, dtype=getattr(quiet, name).dtype)
        for name, value in changes.items()
    }
    return replace(quiet, **arrays)


def drawn(noise: NoiseDraws, runs: tuple[int, int] = (3, 3)) -> tuple[FloatArray, FloatArray]:
    return fresh_noise(noise, TARGETS, *runs, np.random.default_rng(1))


def test_white_noise_has_its_size_in_both_directions() -> None:
    """12 000 readings: their standard deviation is known to 0.65 %; four of these."""
    noise = replace(noise_of_size(1.0), sigma=np.tile([2.0, 3.0], (COUNT, 1)))
    plus, minus = drawn(noise)
    assert np.std(plus[:, 0]) == pytest.approx(2.0, rel=0.026)
    assert np.std(minus[:, 4]) == pytest.approx(3.0, rel=0.026)


def test_drift_goes_from_the_first_run_to_the_last_and_comes_again_to_about_a_tenth() -> None:
    """Rate 0: -1/2, 0, 1/2 of it; at the ends of the travel more and less of the expansion. As
    large as in the first test, its standard deviation 7 % of it (`_DIFFERS`): nine in ten lie
    within 11.5 %. 4000 tests: mean to 0.0011, standard deviation to 1.1 %; four of these.
    """
    plus, minus = drawn(noise_of_size(0.0, drift=4.0, drift_tilt=2.0))
    expected = np.outer([2.0, 3.0, 4.0, 5.0, 6.0], [-0.5, 0.0, 0.5])
    share = (plus[:, 2, 2] - plus[:, 2, 0]) / 4.0
    assert np.mean(share) == pytest.approx(1.0, abs=0.0044)
    assert np.std(share) == pytest.approx(0.07, rel=0.045)
    for block in (plus, minus):
        drift = block - block.mean(axis=2, keepdims=True)
        # an even pace as the limit of a slow one
        assert drift == pytest.approx(share[:, np.newaxis, np.newaxis] * expected, abs=1e-7)


def test_another_drift_moves_the_means_by_what_drifts_within_a_run() -> None:
    """Three runs up and down, evenly timed: from one run to the next half of the drift; of that
    none at the first target, half at the turn, all when the run is back.
    """
    plus, minus = drawn(noise_of_size(0.0, drift=4.0))
    share = (plus[:, 2, 2] - plus[:, 2, 0]) / 4.0
    more = np.outer(4.0 * (share - 1.0), [0.0, 0.125, 0.25, 0.375, 0.5])
    assert plus.mean(axis=2) == pytest.approx(0.5 * more, abs=1e-7)
    assert minus.mean(axis=2) == pytest.approx(0.5 * more[:, -1:] + 0.5 * more[:, ::-1], abs=1e-7)


@pytest.mark.parametrize(
    ("pattern", "within_run", "next_run"),
    [(INDEPENDENT, 2.0, 2.0), (RUNS, 0.0, 2.0), (WALK, 1.0, 2.0)],
)
def test_traverses_move_by_their_pattern(pattern: int, within_run: float, next_run: float) -> None:
    """Variance of the difference between traverses, in that of one effect: 2 for independent ones;
    0 within a run moved as a whole; one step within a run, two to the same traverse of the next.
    Standard error of a variance of 4000: 2.2 %; four of these.
    """
    plus, minus = drawn(noise_of_size(0.0, offset=1.0, pattern=pattern))
    assert np.var(plus[:, 2, 0] - minus[:, 2, 0]) == pytest.approx(within_run, rel=0.09)
    assert np.var(plus[:, 2, 1] - plus[:, 2, 0]) == pytest.approx(next_run, rel=0.09)
    assert np.ptp(plus, axis=1) == pytest.approx(0.0)  # the same at every target


def test_only_a_share_of_the_traverses_is_moved() -> None:
    """A tenth of 4000 x 6 traverses: 2400 +- 46; four of these. Those that are have the size."""
    plus, minus = drawn(noise_of_size(0.0, offset=2.0, moved=0.1))
    offsets = np.concatenate([plus[:, 2], minus[:, 2]], axis=1)
    there = offsets != 0.0
    assert np.count_nonzero(there) == pytest.approx(2400, abs=186)
    assert np.std(offsets[there]) == pytest.approx(2.0, rel=0.06)


def test_a_zero_point_that_seldom_jumps_stays_where_it_jumped_to() -> None:
    """Steps between 6 traverses, one in five: no step in 0.8^5 of the tests, 1311 +- 30 of 4000."""
    plus, minus = drawn(noise_of_size(0.0, offset=1.0, pattern=WALK, moved=0.2))
    in_time = np.stack([plus[:, 2], minus[:, 2]], axis=2).reshape(COUNT, 6)
    jumps = np.count_nonzero(np.diff(in_time, axis=1), axis=1)
    assert np.count_nonzero(jumps == 0) == pytest.approx(1311, abs=120)
    assert np.mean(jumps) == pytest.approx(1.0, abs=0.06)


def test_a_slow_wave_lifts_neighbours_alike_and_turns_them_by_their_direction() -> None:
    """Correlation time ten tests: a traverse of a sixth of the test hardly changes; the turn
    between one and the next is small against the wave, and what rises while the axis goes up
    rises while it comes down, which is the other way along the travel.
    """
    plus, minus = drawn(noise_of_size(0.0, offset=3.0, pattern=WAVE, pace=10.0))
    assert np.std(plus[:, 2, 0]) == pytest.approx(3.0, rel=0.045)
    assert np.std(plus[:, 2, 0] - minus[:, 2, 0]) < 0.1 * 3.0
    up, down = plus[:, 4, 0] - plus[:, 0, 0], minus[:, 4, 0] - minus[:, 0, 0]
    assert np.corrcoef(up, down)[0, 1] < -0.9
    assert np.corrcoef(up, minus[:, 2, 0] - plus[:, 2, 0])[0, 1] > 0.9


def test_tilts_turn_about_the_middle() -> None:
    plus, _ = drawn(noise_of_size(0.0, tilt=1.0))
    assert np.std(plus[:, 4, 1]) == pytest.approx(1.0, rel=0.045)
    assert plus[:, 0] == pytest.approx(-plus[:, 4])
    assert plus[:, 2] == pytest.approx(0.0)


def test_outliers_have_their_share_and_their_size() -> None:
    """60 000 readings, 2 % of them: 1200 +- 35; four of these."""
    plus, _ = drawn(noise_of_size(1.0, outlier_share=0.02, outlier_size=20.0, outlier_fixed=True))
    far = plus[np.abs(plus) > 10.0]
    assert far.size == pytest.approx(1200, abs=140)
    assert np.mean(np.abs(far)) == pytest.approx(20.0, abs=0.12)
    assert np.mean(far > 0.0) == pytest.approx(0.5, abs=0.06)
    wide, _ = drawn(noise_of_size(1.0, outlier_share=0.02, outlier_size=20.0))
    # P(|z| > 5 / 20) = 0.803 of the outliers, hardly any of the others.
    assert np.sum(np.abs(wide) > 5.0) == pytest.approx(0.803 * 1200, abs=140)


def test_students_readings_reach_as_far_as_his_table() -> None:
    """Three degrees of freedom: 5 % beyond 3.182 (any table of t); 3000 +- 53; four of these."""
    plus, _ = drawn(noise_of_size(1.0, dof=3.0))
    assert np.sum(np.abs(plus) > 3.182) == pytest.approx(3000, abs=215)


def test_one_direction_and_one_run() -> None:
    plus, minus = drawn(noise_of_size(1.0, offset=1.0, drift=9.0, pattern=WALK), (1, 0))
    assert plus.shape == (COUNT, 5, 1)
    assert minus.shape == (COUNT, 5, 0)
    assert abs(np.mean(plus)) < 0.1  # no drift in one run; standard error 0.016
