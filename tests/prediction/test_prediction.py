"""The predicted test against readings drawn one by one, against known truth, and against the
contract's rules.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from compwright.evaluation.statistics import mean_deviation, parameters, standard_deviation
from compwright.foundations.errors import UsageError
from compwright.prediction.fresh_scatter import fresh_scatter
from compwright.prediction.positioning import (
    Quantiles,
    decide_prediction,
    dithered_targets,
    predict_test,
)
from compwright.records.axis import FloatArray
from compwright.records.noise import normal_noise

NOISE = 0.5
M = 12


def rng(seed: int) -> np.random.Generator:
    return np.random.default_rng(seed)


def still(m: int = M) -> FloatArray:
    return np.zeros(m)


def predicted_test(
    positive: FloatArray,
    negative: FloatArray,
    noise: FloatArray,
    *,
    runs_positive: int | FloatArray,
    runs_negative: int | FloatArray,
    rng: np.random.Generator,
    **words: Any,
) -> Mapping[str, Quantiles]:
    """Fresh tests whose readings scatter by a normal law of standard deviation ``noise`` (s,)."""
    targets = np.arange(positive.shape[1], dtype=float)
    scatter = fresh_scatter(normal_noise(noise), targets, runs_positive, runs_negative, rng)
    return predict_test(positive, negative, scatter, **words)


# ---------------------------------------------------------------- the law of a fresh test


@pytest.mark.parametrize("runs", [2, 5, 10])
def test_agrees_with_readings_drawn_one_by_one(runs: int) -> None:
    count = 20_000
    truth_positive = np.linspace(-2.0, 1.0, M)
    truth_negative = truth_positive[::-1] + 1.5
    readings = [
        truth[:, None] + NOISE * rng(k).standard_normal((count, M, runs))
        for k, truth in enumerate((truth_positive, truth_negative))
    ]
    drawn = parameters(
        mean_deviation(readings[0]),
        standard_deviation(readings[0]),
        mean_deviation(readings[1]),
        standard_deviation(readings[1]),
        2.0,
    )
    predicted = predicted_test(
        np.tile(truth_positive, (count, 1)),
        np.tile(truth_negative, (count, 1)),
        np.full(count, NOISE),
        runs_positive=runs,
        runs_negative=runs,
        change_positive=still(),
        change_negative=still(),
        coverage=2.0,
        rng=rng(9),
    )
    assert set(predicted) == set(drawn)
    for name, values in drawn.items():
        p05, median, p95 = np.quantile(values, [0.05, 0.5, 0.95])
        # A quantile from 20 000 draws has a standard error near 2.1 sqrt(0.05 * 0.95 / 20 000) =
        # 0.003 in units of the spread at the 5 % point of a normal law; 0.03 of the 90 % width
        # leaves room for skewed parameters and for two samples.
        room = 0.03 * (p95 - p05)
        assert predicted[name].median == pytest.approx(median, abs=room), name
        assert predicted[name].p05 == pytest.approx(p05, abs=room), name
        assert predicted[name].p95 == pytest.approx(p95, abs=room), name


def test_ninety_percent_interval_holds_ninety_percent_of_fresh_tests() -> None:
    # Truth from a normal law, measured with known noise, posterior exact (normal with known
    # variances): the interval must hold 90 % of the fresh tests. 600 axes: standard error 1.2 %,
    # bounds at about 3.3 of these; 400 draws put the ends of the interval 1.1 % off at random, which
    # cancels over the axes.
    axes, draws, runs, prior = 600, 400, 5, 1.0
    inside = dict.fromkeys(("A", "A_positive", "E", "M", "R", "R_negative", "B", "B_mean"), 0)
    generator = rng(17)
    mean_variance = NOISE**2 / runs
    shrink = prior**2 / (prior**2 + mean_variance)
    for _ in range(axes):
        truth = prior * generator.standard_normal((2, M))
        before = truth + np.sqrt(mean_variance) * generator.standard_normal((2, M))
        posterior = shrink * before + np.sqrt(shrink * mean_variance) * generator.standard_normal(
            (draws, 2, M)
        )
        change = generator.standard_normal((2, M))
        predicted = predicted_test(
            posterior[:, 0],
            posterior[:, 1],
            np.full(draws, NOISE),
            runs_positive=runs,
            runs_negative=runs,
            change_positive=change[0],
            change_negative=change[1],
            coverage=2.0,
            rng=generator,
        )
        after = (truth + change)[:, :, None] + NOISE * generator.standard_normal((2, M, runs))
        mean, s = after.mean(axis=2), after.std(axis=2, ddof=1)
        fresh = parameters(mean[0], s[0], mean[1], s[1], 2.0)
        for name in inside:
            inside[name] += int(predicted[name].p05 <= float(fresh[name]) <= predicted[name].p95)
    for name, hits in inside.items():
        assert 0.86 <= hits / axes <= 0.94, (name, hits / axes)


def test_by_hand_without_noise() -> None:
    # one draw: + 0 1 2, - 1 1 4; the change takes 1 off the last + and adds 1 to the first -: + 0 1
    # 1, - 2 1 4
    predicted = predicted_test(
        np.array([[0.0, 1.0, 2.0]]),
        np.array([[1.0, 1.0, 4.0]]),
        np.zeros(1),
        runs_positive=5,
        runs_negative=5,
        change_positive=np.array([0.0, 0.0, -1.0]),
        change_negative=np.array([1.0, 0.0, 0.0]),
        coverage=2.0,
        rng=rng(0),
    )
    expected = {
        "A": 4.0,
        "A_positive": 1.0,
        "A_negative": 3.0,
        "E": 4.0,
        "M": 1.5,
        "R": 3.0,
        "B": 3.0,
        "B_mean": -5.0 / 3.0,
    }
    # B: -2, 0, -3; means of both: 1, 1, 2.5
    for name, value in expected.items():
        got = predicted[name]
        assert (got.p05, got.median, got.p95) == pytest.approx((value, value, value)), name


def test_perfect_correction_leaves_the_noise() -> None:
    draws = np.tile(np.linspace(0.0, 30.0, M), (4000, 1))
    predicted = predicted_test(
        draws,
        draws,
        np.full(4000, NOISE),
        runs_positive=5,
        runs_negative=5,
        change_positive=-draws[0],
        change_negative=-draws[0],
        coverage=2.0,
        rng=rng(1),
    )
    # Ranges of 24 means of standard deviation noise / sqrt(5): expected range 3.895 of them (tables
    # of the studentised range, d2 for 24); the median of the range lies within 0.1 of its mean.
    assert predicted["E"].median == pytest.approx(
        3.895 * NOISE / np.sqrt(5.0), abs=0.1 * NOISE / np.sqrt(5.0)
    )


def test_a_new_datum_changes_nothing() -> None:
    draws = rng(3).standard_normal((500, M))
    common = {
        "runs_positive": 5,
        "runs_negative": 5,
        "change_positive": still(),
        "change_negative": still(),
        "coverage": 2.0,
    }
    first = predicted_test(draws, draws, np.full(500, NOISE), rng=rng(4), **common)  # type: ignore[arg-type]
    moved = predicted_test(draws + 7.0, draws + 7.0, np.full(500, NOISE), rng=rng(4), **common)  # type: ignore[arg-type]
    for name, value in first.items():
        assert moved[name].median == pytest.approx(value.median, abs=1e-9)


# ---------------------------------------------------------------- tests with fewer readings


def names_of(
    runs_positive: int | FloatArray, runs_negative: int | FloatArray, *, vdi: bool = False
) -> set[str]:
    draws = rng(2).standard_normal((50, M))
    predicted = predicted_test(
        draws,
        draws,
        np.full(50, NOISE),
        runs_positive=runs_positive,
        runs_negative=runs_negative,
        change_positive=still(),
        change_negative=still(),
        coverage=2.0,
        rng=rng(3),
        vdi=vdi,
    )
    return set(predicted)


def test_only_the_parameters_that_such_a_test_has() -> None:
    assert names_of(5, 0) == {"A_positive", "E_positive", "R_positive"}
    assert names_of(0, 5) == {"A_negative", "E_negative", "R_negative"}
    # n = 1 (axes over 2 000 mm): s, R and A do not apply
    assert names_of(1, 1) == {"E", "E_positive", "E_negative", "M", "B", "B_mean"}
    assert names_of(1, 0) == {"E_positive"}
    assert names_of(5, 5, vdi=True) == {"P", "Ps_max", "Ps_mean", "Pa", "U_max", "U_mean"}


def test_number_of_readings_by_target() -> None:
    runs = np.full(M, 5.0)
    runs[3] = 1.0  # one target has no s: no A, no R in that direction, but every mean
    assert names_of(runs, 5) == {
        "A_negative",
        "R_negative",
        "E",
        "E_positive",
        "E_negative",
        "M",
        "B",
        "B_mean",
    }
    # The mean of a target read once scatters by the full noise: E of two targets, one read 400
    # times, is noise away from zero.
    count = 20_000
    predicted = predicted_test(
        np.zeros((count, 2)),
        np.zeros((count, 2)),
        np.full(count, NOISE),
        runs_positive=np.array([1.0, 400.0]),
        runs_negative=0,
        change_positive=np.zeros(2),
        change_negative=np.zeros(2),
        coverage=2.0,
        rng=rng(5),
    )
    # |N(0, noise)|: median 0.6745, 95 % 1.960 noise; standard error of such a quantile below 0.02 noise
    assert predicted["E_positive"].median == pytest.approx(0.6745 * NOISE, abs=0.03 * NOISE)
    assert predicted["E_positive"].p95 == pytest.approx(1.960 * NOISE, abs=0.06 * NOISE)


def test_same_generator_same_prediction() -> None:
    draws = rng(3).standard_normal((100, M))

    def once() -> Quantiles:
        return predicted_test(
            draws,
            draws,
            np.full(100, NOISE),
            runs_positive=5,
            runs_negative=5,
            change_positive=still(),
            change_negative=still(),
            coverage=3.0,
            rng=rng(8),
        )["A"]

    assert once() == once()


# ---------------------------------------------------------------- new targets


@given(
    low=st.floats(-2000.0, 2000.0),
    length=st.floats(100.0, 5000.0),
    count=st.integers(1, 60),
    seed=st.integers(0, 10_000),
)
def test_targets_follow_the_contract(low: float, length: float, count: int, seed: int) -> None:
    targets = dithered_targets((low, low + length), count, rng(seed))
    assert targets.shape == (count,)
    assert np.all(np.diff(targets) > 0.0)
    assert targets.min() >= low + 4.0 - 1e-9
    assert targets.max() <= low + length - 4.0 + 1e-9
    if 0.8 * length / count >= 4.0:  # the margin does not reach into the second interval
        u = (targets - low) * count / length - np.arange(count) - 0.5
        inner = u[(targets > low + 4.0 + 1e-9) & (targets < low + length - 4.0 - 1e-9)]
        assert np.all(np.abs(inner) <= 0.3 + 1e-9)


def test_targets_use_the_whole_dither() -> None:
    u = np.concatenate(
        [
            dithered_targets((0.0, 1000.0), 10, rng(seed)) / 100.0 - np.arange(10) - 0.5
            for seed in range(300)
        ]
    )
    # 3000 values uniform in ±0.3: the extremes come within 0.001 with near certainty; the mean has
    # standard error 0.0032
    assert u.min() == pytest.approx(-0.3, abs=0.002)
    assert u.max() == pytest.approx(0.3, abs=0.002)
    assert u.mean() == pytest.approx(0.0, abs=0.013)


def test_targets_of_short_and_rotary_axes() -> None:
    short = dithered_targets((0.0, 10.0), 5, rng(1))
    assert short.min() >= 2.5  # a quarter of the travel: 4 mm at both ends would leave 2 mm
    assert short.max() <= 7.5
    assert np.all(np.diff(short) > 0.0)
    rotary = dithered_targets((0.0, 360.0), 8, rng(1), margin=0.0)
    assert np.all(np.abs(rotary / 45.0 - np.arange(8) - 0.5) <= 0.3)
    crowded = dithered_targets((0.0, 40.0), 60, rng(1))
    assert np.all(np.diff(crowded) > 0.0)
    assert crowded.min() >= 4.0
    # 4 mm are six intervals: the same rule over the 32 mm between the margins
    assert np.all(np.abs((crowded - 4.0) * 60 / 32.0 - np.arange(60) - 0.5) <= 0.3 + 1e-9)


def test_short_travels_keep_a_quarter_at_each_end() -> None:
    """8 mm: 2 mm at each end, where 4 mm would leave one place for all targets."""
    rng = np.random.default_rng(5)
    placed = np.array([dithered_targets((10.0, 18.0), 3, rng) for _ in range(200)])
    assert float(np.min(placed)) == pytest.approx(12.0, abs=0.05)
    assert float(np.max(placed)) == pytest.approx(16.0, abs=0.05)
    assert np.all(np.diff(placed, axis=1) > 0.0)


@pytest.mark.parametrize(
    ("travel", "count"),
    [((10.0, 10.0), 5), ((10.0, 0.0), 5), ((0.0, 10.0), 0), ((float("nan"), 1.0), 3)],
)
def test_impossible_targets(travel: tuple[float, float], count: int) -> None:
    with pytest.raises(UsageError, match="no target"):
        dithered_targets(travel, count, rng(0))


# ---------------------------------------------------------------- decisions


@pytest.mark.parametrize(
    ("p05", "p95", "decision"),
    [
        (4.0, 8.0, "accept"),
        (4.0, 8.001, "undecided"),
        (8.0, 9.0, "undecided"),
        (8.001, 9.0, "reject"),
        (1.0, 2.0, "accept"),
    ],
)
def test_decision_by_the_interval(p05: float, p95: float, decision: str) -> None:
    assert decide_prediction(Quantiles(median=6.0, p05=p05, p95=p95), 8.0) == decision
