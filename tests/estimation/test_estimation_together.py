"""Several tests of one axis, and noise that is known: against formulas that need no estimation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from compwright.estimation.axis import AxisPosterior, estimate_axis
from compwright.estimation.cells import build_cells
from compwright.estimation.evidence import _by_cells, _by_weights, _Marginal
from compwright.estimation.model import Periods, Travel, model_evidence
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.observed_test import ObservedTest, traverse_columns
from compwright.records.axis import AxisKind
from compwright.records.noise import normal_noise
from compwright.records.positioning import PositioningTest

Array = NDArray[np.float64]
UM = 1e-3
TRAVEL = (0.0, 1000.0)
X = np.linspace(20.0, 980.0, 17)


def smooth(x: Array) -> Array:
    return 8 * UM * np.sin(x / 150.0) + 2e-5 * x


def read(positive: Array, negative: Array, targets: Array = X) -> PositioningTest:
    """Readings by rows of targets and columns of runs, mm."""
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=positive,
        negative=negative,
        frame="machine",
    )


def known(test: PositioningTest, sigma: float, offset: float = 0.0) -> ObservedTest:
    """A test whose noise is known: normal readings of ``sigma``, and every traverse set up anew by
    ``offset`` (standard deviations, mm).
    """
    means = np.concatenate([np.mean(test.positive, axis=1), np.mean(test.negative, axis=1)])
    runs = test.positive.shape[1]
    up = np.repeat([1.0, 0.0], test.targets.size)
    columns = offset / np.sqrt(runs) * np.column_stack([up, 1.0 - up])
    readings = replace(normal_noise(np.array([sigma])), offset=np.array([offset]))
    noise = NoisePosterior(
        draws=readings,
        fresh=readings,
        mean=means[np.newaxis],
        precision=np.full((1, means.size), runs / sigma**2),
        columns=columns[np.newaxis],
        sigma=sigma,
        dof=1e6,
    )
    return ObservedTest(test=test, noise=noise)


def noisy(
    rng: np.random.Generator, sigma: float, reversal: float = 0.0, runs: int = 5, x: Array = X
) -> PositioningTest:
    shape = (x.size, runs)
    up, down = (
        (smooth(x) + half)[:, np.newaxis] + sigma * rng.standard_normal(shape)
        for half in (0.5 * reversal, -0.5 * reversal)
    )
    return read(up, down, x)


def mean_reversal(posterior: AxisPosterior) -> Array:
    draws = posterior.draw(X, 4000, np.random.default_rng(3))
    return np.asarray(np.mean(draws.positive - draws.negative, axis=1))


@pytest.mark.parametrize("offset", [0.0, 0.4 * UM, 2.0 * UM])
def test_the_mean_reversal_varies_as_the_components_of_variance_say(offset: float) -> None:
    """m targets, n traverses either way: the mean of all reversals has the variance 2 sigma² / (n
    m) + 2 offset² / n (two-way layout; Montgomery, Design and Analysis of Experiments, nested
    design).
    """
    sigma, runs = 1.0 * UM, 5
    test = noisy(np.random.default_rng(1), sigma, reversal=-3 * UM)
    drawn = mean_reversal(estimate_axis([known(test, sigma, offset)], travel=TRAVEL))
    expected = np.sqrt(2 * sigma**2 / (runs * X.size) + 2 * offset**2 / runs)
    # 4000 draws tell a standard deviation to 1.1 %; four times that, and 1 % for the vague prior.
    assert np.std(drawn) == pytest.approx(expected, rel=0.055)


def test_fresh_tests_follow_all_that_is_told_of_their_noise_evenly() -> None:
    """Of two tests: each has the noise of its own kind."""
    rng = np.random.default_rng(2)
    tests = [known(noisy(rng, sigma), sigma) for sigma in (1.0 * UM, 2.0 * UM)]
    sizes = np.array([1.0, 1.2, 1.3, 1.6]) * UM
    tests = [
        replace(each, noise=replace(each.noise, fresh=normal_noise(factor * sizes)))
        for each, factor in zip(tests, (1.0, 2.0), strict=True)
        if each.noise is not None
    ]
    posterior = estimate_axis(tests, travel=TRAVEL)
    for place, factor in enumerate((1.0, 2.0)):
        drawn = posterior.draw(X, 402, np.random.default_rng(4), place).noise.sigma[:, 0]
        found, often = np.unique(drawn, return_counts=True)
        assert found == pytest.approx(factor * sizes)
        assert sorted(often) == [100, 100, 101, 101]


def test_two_tests_count_by_their_inverse_variances() -> None:
    """Reversals of 2 µm and 5 µm, readings of 1 and 2 µm: (4 * 2 + 1 * 5) / 5 = 2.6 µm."""
    sure, unsure = (
        read(
            np.tile((smooth(X) + b / 2)[:, np.newaxis], 5), np.tile((smooth(X) - b / 2)[:, None], 5)
        )
        for b in (2.0 * UM, 5.0 * UM)
    )
    posterior = estimate_axis([known(sure, 1 * UM), known(unsure, 2 * UM)], travel=TRAVEL)
    summary = posterior.summary(X)
    found = float(np.mean(summary.mean_positive - summary.mean_negative))
    # The prior of the constant, ten times the scale (the slope of 20 µm/m left out: 5.6 µm rms), pulls
    # by less than a thousandth.
    assert found == pytest.approx(2.6 * UM, abs=0.01 * UM)


def test_the_datum_of_every_test_is_its_own() -> None:
    rng = np.random.default_rng(2)
    first, second = noisy(rng, 1 * UM), noisy(rng, 1 * UM)
    moved = replace(second, positive=second.positive + 0.7, negative=second.negative + 0.7)
    one, other = (
        estimate_axis([known(first, 1 * UM), known(each, 1 * UM)], travel=TRAVEL).summary(X)
        for each in (second, moved)
    )
    # 0.7 mm more than everything else: rounding takes eight digits of it, not nine.
    assert other.mean_positive == pytest.approx(one.mean_positive, abs=1e-3 * UM)
    assert other.std_positive == pytest.approx(one.std_positive, rel=1e-3)


def test_two_tests_know_as_much_as_one_of_as_many_readings() -> None:
    rng = np.random.default_rng(4)
    whole = noisy(rng, 1 * UM, runs=10)
    parts = [
        replace(whole, positive=whole.positive[:, s], negative=whole.negative[:, s])
        for s in (slice(0, 5), slice(5, 10))
    ]
    one = estimate_axis([known(whole, 1 * UM)], travel=TRAVEL).summary(X)
    two = estimate_axis([known(part, 1 * UM) for part in parts], travel=TRAVEL).summary(X)
    # But for one datum more: 1 of 17 targets.
    assert two.mean_positive - np.mean(two.mean_positive) == pytest.approx(
        one.mean_positive - np.mean(one.mean_positive), abs=0.1 * UM
    )
    assert np.mean(two.std_positive) == pytest.approx(np.mean(one.std_positive), rel=0.1)


def test_slopes_of_unlike_temperature_count_by_their_uncertainty() -> None:
    """+10 µm/m known to 4 µm/m and -10 µm/m known to 8: (10 / 16 - 10 / 64) / (1 / 16 + 1 / 64) = 6;
    its uncertainty 1 / sqrt(1 / 16 + 1 / 64) = 3.58 µm/m.
    """
    tests = []
    for slope, std in ((10e-6, 4e-6), (-10e-6, 8e-6)):
        readings = np.tile((slope * X)[:, np.newaxis], 5)
        tests.append(replace(known(read(readings, readings), 0.01 * UM), slope_std=std))
    posterior = estimate_axis(tests, travel=TRAVEL)
    ends = posterior.draw(np.array([20.0, 980.0]), 4000, np.random.default_rng(1))
    slopes = (ends.positive[:, 1] - ends.positive[:, 0]) / 960.0
    assert np.mean(slopes) == pytest.approx(6e-6, abs=0.25e-6)  # four of 3.58 / sqrt(4000)
    assert np.std(slopes) == pytest.approx(3.58e-6, rel=0.06)


def test_a_single_run_over_the_whole_length_tells_what_five_over_a_part_do_not() -> None:
    """ISO 230-2, 5.2: beyond 2 m the five runs say nothing, the single one does; inside both do."""
    rng = np.random.default_rng(5)
    near, far = np.linspace(10.0, 1990.0, 21), np.linspace(10.0, 3990.0, 21)
    travel, where = (0.0, 4000.0), np.linspace(100.0, 3900.0, 39)
    five, single = noisy(rng, 1 * UM, x=near), noisy(rng, 1 * UM, runs=1, x=far)
    both = estimate_axis([known(five, 1 * UM), ObservedTest(test=single)], travel=travel)
    alone = estimate_axis([known(five, 1 * UM)], travel=travel)
    # Which datum is right is nobody's question: compare from 1 m on.
    left = both.summary(where).mean_positive - smooth(where)
    left -= np.interp(1000.0, where, left)
    std = both.summary(where).std_positive
    assert np.all(np.abs(left) < 4 * np.maximum(std, 0.5 * UM))
    outside = where > 2500.0
    assert np.mean(std[outside]) < 0.3 * np.mean(alone.summary(where).std_positive[outside])
    # The noise of the single readings is about that of the others, which tell it.
    fresh = both.draw(where, 200, rng, 1).noise
    assert np.median(fresh.sigma) == pytest.approx(1 * UM, rel=0.35)


@pytest.mark.parametrize("among", [_by_cells, _by_weights])
def test_the_density_of_the_means_is_that_of_their_covariance(
    among: Callable[..., _Marginal],
) -> None:
    """Written out: functions of the basis, local part, noise, and what traverses have in common."""
    rng = np.random.default_rng(6)
    tests = [known(noisy(rng, 1 * UM), 1 * UM, 0.5 * UM), known(noisy(rng, 1 * UM), 2 * UM)]
    cells = build_cells(tests)
    evidence = model_evidence(cells, Travel(*TRAVEL), Periods((90.0,), ((1, 2),)), varying=True)
    h = evidence.prior.centre + 0.3 * rng.standard_normal(evidence.prior.centre.size)
    data = cells.data
    variances = np.concatenate([np.exp(evidence.log_variances(h)[0]), data.extra_std**2])
    covariance = evidence.rows * variances @ evidence.rows.T
    covariance += data.columns[0] @ data.columns[0].T + np.diag(1.0 / data.precision[0])
    covariance += evidence.variances(h)[1] * np.equal.outer(data.target_index, data.target_index)
    found = among(evidence._scaled(h, None), derivatives=True)
    # The vague columns have 100 times the variance of the scale: eight digits are left.
    assert covariance @ found.residual == pytest.approx(evidence.values, abs=1e-6)
    square = evidence.values @ np.linalg.solve(covariance, evidence.values)
    written_out = -0.5 * (square + np.linalg.slogdet(covariance)[1])
    assert found.log == pytest.approx(written_out, abs=1e-5)


def test_single_readings_scatter_about_as_those_of_the_test_that_tells_it() -> None:
    """Three targets read once say hardly anything of their noise: it is that of the other test, to a
    factor of e (two standard deviations of what is expected).
    """
    rng = np.random.default_rng(7)
    few = noisy(rng, 1 * UM, runs=1, x=np.array([100.0, 500.0, 900.0]))
    tests = [known(noisy(rng, 1 * UM), 1 * UM, 0.3 * UM), ObservedTest(test=few)]
    noise = estimate_axis(tests, travel=TRAVEL).draw(X, 400, rng, 1).noise
    logs = np.log(noise.sigma[:, 0] / UM)
    assert abs(np.median(logs)) < 1.0
    assert np.std(logs) < 0.5
    assert np.all(noise.offset == 0.3 * UM)  # and so its traverses move


def test_no_draw_of_the_noise_is_picked_by_the_chance_that_moved_its_means() -> None:
    """48 equally likely noises, whose means differ as if by heavy tails: all of them stay."""
    rng = np.random.default_rng(8)
    first = known(noisy(rng, 1 * UM), 1 * UM)
    one = first.noise
    assert one is not None
    mean = one.mean + 0.4 * UM * rng.standard_normal((48, one.mean.shape[1]))
    sizes = rng.uniform(0.9, 1.1, 48) * UM
    noise = replace(
        one,
        draws=normal_noise(sizes),
        fresh=normal_noise(sizes),
        mean=mean,
        precision=np.tile(one.precision, (48, 1)),
        columns=np.tile(one.columns, (48, 1, 1)),
    )
    drawn = estimate_axis([replace(first, noise=noise)], travel=TRAVEL).draw(X, 480, rng).noise
    found, counts = np.unique(drawn.sigma[:, 0], return_counts=True)
    assert found == pytest.approx(np.sort(sizes))
    assert set(counts) == {10}


def test_traverses_that_are_moved_now_and_then_count_by_their_mean_square() -> None:
    """A quarter of the traverses off by 4 µm: over many tests the mean square is that of 2 µm."""
    noise = replace(normal_noise(np.array([UM])), offset=np.full(1, 4 * UM), moved=np.full(1, 0.25))
    columns = traverse_columns(noise, np.array([0.0, 0.0]), np.array([1.0, -1.0]))
    assert np.sum(columns[0] ** 2, axis=1) == pytest.approx((2 * UM) ** 2)
