"""The posterior of the noise: known noise is put into readings and found again; what is not there
is not found.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from compwright.estimation.noise import LEAST_DOF, infer_noise
from compwright.estimation.noise_chain import WAYS, GibbsChain
from compwright.estimation.noise_days import over_days
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.noise_readings import cell_readings
from compwright.estimation.noise_rounding import common_std, rounded_std, rounded_stds
from compwright.estimation.noise_tails import KINDS, OUTLIERS, REACH, TAILS
from compwright.prediction.fresh_noise import fresh_noise
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import INDEPENDENT, RUNS, WAVE, NoiseDraws, normal_noise, without
from compwright.records.positioning import PositioningTest

UM = 1e-3
M, N = 21, 5
TARGETS = np.linspace(0.0, 1000.0, M)
U = np.linspace(-1.0, 1.0, M)[:, np.newaxis]


def white(seed: int, m: int = M, n: int = N) -> FloatArray:
    """Standard normal numbers (2, m, n)."""
    return np.random.default_rng(seed).standard_normal((2, m, n))


def made(readings: FloatArray, **changes: object) -> PositioningTest:
    """A test with ``readings`` (2, m, n) in µm about an error curve of 20 µm."""
    m, n = readings.shape[1:]
    targets = np.linspace(0.0, 1000.0, m)
    curve = 20.0 * np.sin(targets / 150.0)[:, np.newaxis]
    test = PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=(readings[0] + curve) * UM,
        negative=(readings[1] + curve + 3.0) * UM,
        runs_positive=tuple(range(1, n + 1)),
        runs_negative=tuple(range(1, n + 1)),
        frame="machine",
    )
    return replace(test, **changes)  # type: ignore[arg-type]


def posterior(readings: FloatArray, **changes: object) -> NoisePosterior:
    found = infer_noise(made(readings, **changes))
    assert found is not None
    return found


def inside(truth: float, draws: FloatArray, reach: float = 0.005) -> bool:
    """Whether the central 99 % of the draws hold the truth."""
    low, high = np.quantile(draws, [reach, 1.0 - reach])
    return bool(low <= truth <= high)


# --- draws
# --------------------------------------------------------------------------------------------------


def test_each_sweep_offers_distributions_of_the_errors_as_probable_as_they_are() -> None:
    """Systematic sampling (Cochran 1977, chapter 8): of n from a list, a member of probability p is
    taken n p times, rounded up or down; the sampler goes on with one of them.
    """
    readings = white(3)
    readings[0, 4, 1] += 6.0
    test = made(readings)
    chain = GibbsChain(test, cell_readings(test), np.random.default_rng(5))
    for _ in range(12):
        chain.sweep()
        taken = np.bincount(chain.tails, minlength=chain.tail_chances.size)
        assert np.all(np.abs(taken - WAYS * chain.tail_chances) < 1.0)
        assert (chain.tail, chain.sigma) == (chain.tails[0], chain.sigmas[0])


def test_fresh_noise_belongs_to_the_draws_of_the_estimate() -> None:
    """Pairs of sweeps with one of them kept: of every pair the traverses of both, at least as large
    as they were, and of the one that is kept scales as large as its own."""
    shifts = 1.5 * np.random.default_rng(6).standard_normal((2, 1, N))
    found = posterior(white(6) + shifts)
    count = found.draws.count
    offset, sigma = (part.reshape(count, -1) for part in (found.fresh.offset, found.fresh.sigma))
    assert offset.shape == (count, 2 * WAYS)
    assert np.all(np.any(offset >= found.draws.offset[:, np.newaxis], axis=1))
    assert {len(set(row)) for row in offset.tolist()} <= {1, 2}
    assert np.mean(found.fresh.sigma) == pytest.approx(np.mean(found.draws.sigma), rel=0.03)
    assert np.unique(sigma).size > 4 * count


# --- from day to day
# --------------------------------------------------------------------------------------------------


def days(drifts: Sequence[float], scatters: Sequence[float]) -> list[NoiseDraws]:
    """The noise of tests of known drift (± 0.2 µm) and scatter (± 5 %)."""
    rng = np.random.default_rng(8)
    found = []
    for drift, scatter in zip(drifts, scatters, strict=True):
        sigma = scatter * np.exp(0.05 * rng.standard_normal(96))
        found.append(replace(normal_noise(sigma), drift=drift + 0.2 * rng.standard_normal(96)))
    return found


def fresh(drifts: Sequence[float], scatters: Sequence[float], seed: int) -> NoiseDraws:
    tests = days(drifts, scatters)
    noise = tests[0].taken(np.arange(600) % 96)
    return over_days(noise, tests, 0, np.random.default_rng(seed))


def test_two_days_hold_the_drift_and_the_scatter_of_a_third() -> None:
    """Drift with 4 µm and logarithm of the scatter with 0.4, on every other machine another each
    day, else the same: 5 to 95 % hold those of the third day in nine cases of ten.
    """
    rng, held = np.random.default_rng(9), []
    for seed in range(200):
        day = np.arange(3) * (seed % 2)
        drifts = 4.0 * rng.standard_normal(3)[day]
        scatters = np.exp(0.4 * rng.standard_normal(3)[day])
        noise = fresh(list(drifts[:2]), list(scatters[:2]), seed)
        held.append(
            (inside(drifts[2], noise.drift, 0.05), inside(scatters[2], noise.sigma[:, 0], 0.05))
        )
    drift, scatter = np.mean(held, axis=0)
    assert 0.84 < drift < 0.97
    assert 0.84 < scatter < 0.99


def test_what_two_days_show_alike_is_expected_again() -> None:
    noise = fresh((4.0, 4.1), (1.0, 1.02), 3)
    assert np.mean(np.abs(noise.drift - 4.05) < 1.0) > 0.75
    assert np.quantile(noise.sigma, [0.1, 0.9]) == pytest.approx([1.0, 1.0], abs=0.25)
    assert not np.any(fresh((0.0, 0.0), (1.0, 1.0), 3).drift_tilt)


def test_of_unknown_scatter_as_many_repeat_as_did_in_public_logs() -> None:
    """Axes of github.com/anderssandstrom that were measured again: 0.46 to 0.72 of them repeat,
    by which targets are counted. 600 draws: ± 0.04.
    """
    noise = normal_noise(np.exp(9.0 * np.random.default_rng(8).standard_normal(600)))
    third = over_days(noise, [noise, noise], 0, np.random.default_rng(3))
    assert 0.42 < np.mean(np.isclose(third.sigma, noise.sigma, rtol=1e-9)) < 0.76


@pytest.mark.parametrize("own", [0, 1])
def test_the_scatter_of_a_third_day_is_about_the_mean_of_both(own: int) -> None:
    """1 and 4 µm: normal logarithms about an unknown mean have their median in the middle, 2 µm,
    whichever of the two tests is repeated.
    """
    tests = days((0.0, 0.0), (1.0, 4.0))
    noise = tests[own].taken(np.arange(600) % 96)
    third = over_days(noise, tests, own, np.random.default_rng(5)).sigma
    assert np.median(third) == pytest.approx(2.0, rel=0.2)


def test_scatter_is_compared_by_how_far_the_errors_reach() -> None:
    """Student's law with 3 degrees of freedom reaches 1.36 of its scale in its central 99 %
    (numerically), the normal law 0.97: days of one reach show no change, whatever their scales.
    """
    normal, heavy = days((0.0, 0.0), (1.0, 0.97 / 1.36))
    normal = replace(normal, reach=np.full(normal.count, 0.97))
    heavy = replace(heavy, reach=np.full(heavy.count, 1.36), dof=np.full(heavy.count, 3.0))
    changed = over_days(
        normal.taken(np.arange(600) % 96), [normal, heavy], 0, np.random.default_rng(3)
    )
    assert np.median(changed.sigma) == pytest.approx(1.0, rel=0.05)
    assert np.quantile(changed.sigma, [0.1, 0.9]) == pytest.approx([1.0, 1.0], abs=0.25)


@pytest.mark.parametrize("tail", np.flatnonzero(KINDS != OUTLIERS))
def test_the_reach_of_each_tail_is_that_of_its_errors(tail: int) -> None:
    """By the density itself: root mean square within the quantiles 0.005 and 0.995."""
    z = np.sinh(np.linspace(-9.0, 9.0, 40_001))
    density = np.exp(TAILS[tail].log_density(z)) * np.gradient(z)
    share = np.cumsum(density) / np.sum(density)
    inner = (share > 0.005) & (share < 0.995)
    rms = np.sqrt(np.sum((density * z**2)[inner]) / np.sum(density[inner]))
    assert REACH[tail] == pytest.approx(rms, rel=0.02)


# --- nothing but white noise
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_white_noise_has_its_size_and_little_else(seed: int) -> None:
    """Pooled s of 168 degrees of freedom is known to 5.5 %; the posterior is as narrow as that."""
    draws = posterior(white(seed)).draws
    sigma = draws.sigma.mean(axis=1) / UM
    assert inside(1.0, sigma)
    assert np.std(sigma) < 2.0 * 0.055
    for part in (draws.offset, draws.tilt, np.abs(draws.drift), np.abs(draws.drift_tilt)):
        assert np.mean(part > 0.5 * UM) < 0.2


def test_the_means_of_the_cells_are_plain_means_of_white_noise() -> None:
    """Precision n / sigma², the curve untouched; the columns are small beside it."""
    readings = white(4)
    found = posterior(readings)
    test = made(readings)
    plain = np.concatenate([test.positive.mean(axis=1), test.negative.mean(axis=1)])
    assert np.median(found.mean, axis=0) == pytest.approx(plain, abs=0.15 * UM)  # of 0.45 µm
    assert np.median(1.0 / found.precision) == pytest.approx(UM**2 / N, rel=0.35)
    assert np.median(np.sum(found.columns**2, axis=2)) < 0.1 * UM**2 / N


# --- what moves whole traverses
# --------------------------------------------------------------------------------------------------


def test_a_drift_over_the_runs_is_found_with_sign_and_size() -> None:
    """6 µm down from first to last run. Least squares over 210 readings know it to 0.2 µm."""
    drift = -6.0 * (np.arange(N) / (N - 1) - 0.5)
    draws = posterior(white(5) + drift).draws
    assert np.median(draws.drift) == pytest.approx(-6.0 * UM, abs=0.6 * UM)
    assert inside(-6.0 * UM, draws.drift)
    assert np.median(draws.sigma) == pytest.approx(UM, rel=0.15)  # not taken for scatter


@pytest.mark.parametrize(("size", "shifted"), [(50.0, 0.0), (150.0, 0.0), (150.0, 2.0)])
def test_a_large_drift_is_no_row_of_shifts(size: float, shifted: float) -> None:
    """Of 0.1 µm of scatter a cold machine drifts by that much: told as such from whichever data,
    with and without shifts beside it.
    """
    for seed in range(101, 104):
        drift = -size * (np.arange(N) / (N - 1) - 0.5)
        moved = shifted * np.random.default_rng(seed).standard_normal((2, 1, N))
        found = posterior(white(seed) + drift + moved)
        assert np.all(found.draws.drift != 0.0)
        assert np.median(found.draws.drift) == pytest.approx(
            -size * UM, abs=(1.0 + 3.0 * shifted) * UM
        )
        (told,) = [each.message for each in found.findings if each.code == "CW-E020"]
        assert "more than 1000 times as likely as not" in told


def test_a_drift_that_grows_along_the_travel_is_found() -> None:
    """Expansion about the middle: the mean over the targets does not move at all."""
    drift = 6.0 * U * (np.arange(N) / (N - 1) - 0.5)
    draws = posterior(white(6) + drift).draws
    assert np.median(draws.drift_tilt) == pytest.approx(6.0 * UM, abs=0.9 * UM)
    assert np.median(draws.drift) == pytest.approx(0.0, abs=0.3 * UM)


def test_warming_up_that_flattens_is_told_from_even_drift() -> None:
    """Time constant of a fifth of the test, reading by reading in the order of the cycle."""
    run, place = np.arange(N), np.arange(M)[:, np.newaxis] / M
    time = np.stack([run + 0.5 * place, run + 1.0 - 0.5 * place]) / N
    draws = posterior(white(7) + 10.0 * (1.0 - np.exp(-5.0 * time))).draws
    assert np.mean(draws.drift_rate > 0.0) > 0.9
    # From the beginning of the first run to that of the last: 10 (1 - exp(-5 · 4/5)) = 9.8 µm.
    assert np.median(draws.drift) == pytest.approx(9.8 * UM, abs=1.5 * UM)


@pytest.mark.parametrize(("pattern", "shape"), [(INDEPENDENT, (2, 1, N)), (RUNS, (1, 1, N))])
def test_traverses_shifted_against_each_other_are_found(
    pattern: int, shape: tuple[int, ...]
) -> None:
    shifts = 2.0 * np.random.default_rng(8).standard_normal(shape)
    draws = posterior(white(8) + shifts).draws
    assert np.mean(draws.offset > 0.5 * UM) > 0.95
    assert inside(2.0 * UM, draws.offset)
    assert np.mean(draws.pattern == pattern) > 0.6
    assert np.median(draws.sigma) == pytest.approx(UM, rel=0.15)


def test_traverses_that_are_all_shifted_are_all_moved() -> None:
    shifts = 2.0 * np.random.default_rng(8).standard_normal((2, 1, N))
    draws = posterior(white(8) + shifts).draws
    assert np.mean(draws.moved == 1.0) > 0.5


def test_one_traverse_off_is_no_sign_that_all_of_them_move() -> None:
    """One of ten by 4 µm: with Jeffreys' prior the share is Beta(3/2, 19/2), 0.14 on average; a
    fresh test without any such traverse must be possible.
    """
    readings = white(8)
    readings[0, :, 2] += 4.0
    found = posterior(readings)
    moving = found.fresh.offset > 0.0
    assert np.mean(moving) > 0.95
    assert np.median(found.fresh.moved[moving]) < 0.35
    assert np.mean((1.0 - found.fresh.moved[moving]) ** (2 * N)) > 0.15
    told = message(found, "CW-E022")
    assert told.startswith("Single runs deviate from the others by ")
    assert "run 3 in +. Check" in told


def test_a_wave_in_time_is_neither_drift_nor_shifts() -> None:
    """Two waves of 2 µm in the test, reading by reading in the order of the cycle."""
    run, place = np.arange(N), np.arange(M)[:, np.newaxis] / M
    time = np.stack([run + 0.5 * place, run + 1.0 - 0.5 * place]) / N
    found = posterior(white(12) + 2.0 * np.sin(4.0 * np.pi * time + 1.0))
    assert np.mean(found.draws.pattern == WAVE) > 0.9
    assert inside(np.sqrt(2.0) * UM, found.draws.offset)
    assert np.median(found.draws.sigma) == pytest.approx(UM, rel=0.15)
    assert message(found, "CW-E022").startswith("The readings rise and fall slowly in time by ")


def test_shifted_traverses_leave_the_means_in_doubt_together() -> None:
    """Offsets of 3 µm: the mean of five in one direction is unknown to 3/sqrt(5) µm, common to all
    targets; the contrasts say nothing of it.
    """
    shifts = 3.0 * np.random.default_rng(9).standard_normal((2, 1, N))
    found = posterior(white(9) + shifts)
    common = np.einsum("kcq,keq->kce", found.columns, found.columns)
    expected = found.draws.offset**2 / N
    clear = (found.draws.pattern == INDEPENDENT) & (found.draws.moved == 1.0)  # all of them
    assert np.count_nonzero(clear) > 10
    middle, other = M // 2, M + M // 2
    assert common[clear, middle, middle] == pytest.approx(expected[clear], rel=0.05)
    assert common[clear, middle, M - 1] == pytest.approx(expected[clear], rel=0.05)
    assert common[clear, middle, other] == pytest.approx(0.0, abs=0.05 * UM**2)


# --- single readings
# --------------------------------------------------------------------------------------------------


def test_an_outlier_counts_little_and_leaves_the_scale_alone() -> None:
    readings = white(10)
    readings[0, 7, 2] += 25.0
    found = posterior(readings)
    assert inside(1.0 * UM, found.draws.sigma)
    without = made(readings).positive[7, [0, 1, 3, 4]].mean()
    assert np.median(found.mean[:, 7]) == pytest.approx(without, abs=0.3 * UM)  # of 5 µm
    assert np.median(found.precision[:, 7]) < 0.95 * np.median(found.precision[:, 8])


@pytest.mark.parametrize("off", [100.0, 300.0, 1000.0])
def test_one_gross_error_is_an_outlier_and_leaves_the_scale_of_the_others_alone(off: float) -> None:
    """One reading of 210, a hundred to a thousand scales off, in white noise of 1 µm."""
    readings = white(7)
    readings[0, 4, 2] += off
    found = posterior(readings)
    assert [finding.code for finding in found.findings] == ["CW-E024"]
    assert "1 of 210 readings is an outlier: run 3 in + at 200 mm" in found.findings[0].message
    assert np.median(found.draws.sigma) == pytest.approx(UM, rel=0.15)
    cell = found.mean[:, 4] - np.mean(np.delete(made(readings).positive[4], 2))
    assert np.max(np.abs(cell)) < 0.5 * UM


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_outliers_of_one_size_leave_the_mean_of_the_others(side: float) -> None:
    """A grain of 8 µm under every 20th reading of 1 µm scatter, always on the same side: a cell with
    one of them has the mean of its four others, 0.5 µm uncertain, which a turned shift misses by 3.
    """
    readings = white(21)
    readings[:, ::4, 3] += 8.0 * side
    found, test = posterior(readings), made(readings)
    others = np.stack([test.positive, test.negative])[:, ::4, [0, 1, 2, 4]].mean(axis=2)
    means = found.mean.reshape(-1, 2, M)[:, :, ::4]
    assert np.sqrt(np.mean((means - others) ** 2)) < 0.5 * UM
    assert inside(UM, found.draws.sigma)


def test_heavy_tails_are_found() -> None:
    readings = np.random.default_rng(11).standard_t(3.0, (2, M, N))
    found = posterior(readings)
    draws, fresh_draws = found.draws, found.fresh
    assert np.mean(np.isfinite(draws.dof) | (draws.outlier_share > 0.0)) > 0.95
    assert inside(1.0 * UM, draws.sigma, 0.0)
    # root mean square of t with 3 degrees of freedom between its quantiles 0.005 and 0.995
    assert np.median(fresh_draws.sigma[:, 0] * fresh_draws.reach) == pytest.approx(
        1.39 * UM, rel=0.15
    )


@pytest.mark.parametrize(("spread", "excess"), [("two places", -1.7), ("evenly", -1.2)])
def test_light_tails_come_again(spread: str, excess: float) -> None:
    """An axis that comes to rest on two places, or anywhere between two limits: the variance of five
    readings scatters by 2/4 + excess/5 of its square (Cramer, Mathematical Methods of Statistics,
    1946, 27.4), which is 1/2 for a normal law. More readings on one side move their mean.
    """
    rng = np.random.default_rng(12)
    if spread == "evenly":
        readings = rng.uniform(-np.sqrt(3.0), np.sqrt(3.0), (2, M, N))
    else:
        side = np.where(rng.random((2, M, N)) < 0.7, 1.0, -1.0)
        readings = side + 0.3 * rng.standard_normal((2, M, N))
    found = posterior(readings)
    plus, _ = fresh_noise(without(found.fresh, "traverses", "drift"), TARGETS, N, N, rng)
    squares = (np.std(plus, axis=2, ddof=1) / found.fresh.sigma[:, :1]) ** 2
    assert np.mean(squares) == pytest.approx(1.0, abs=0.05)
    assert np.var(squares) == pytest.approx(0.5 + excess / 5.0, abs=0.1)
    plain = np.mean(made(readings).positive, axis=1)
    assert np.mean(found.mean[:, :M], axis=0) == pytest.approx(plain, abs=0.1 * UM)
    assert found.findings == ()


@pytest.mark.parametrize("seed", [13, 20])
def test_scatter_that_differs_by_direction_or_grows_is_found(seed: int) -> None:
    by_direction = white(seed) * np.array([1.0, 2.5])[:, np.newaxis, np.newaxis]
    draws = posterior(by_direction).draws
    # 99 % of a normal law of log sigma: with seed 20 the first scatter lies at 1.7 % of its exact
    # chi-square law, beyond which 48 draws often have none.
    logs = np.log(draws.sigma / UM)
    assert np.all(np.abs(np.mean(logs, axis=0) - np.log([1.0, 2.5])) < 2.576 * np.std(logs, axis=0))
    growing = posterior(white(seed) * np.exp(0.8 * U)).draws.scale_at(TARGETS[[0, -1]])
    assert inside(1.6, np.log(growing[:, 0, 1] / growing[:, 0, 0]))


def test_scatter_of_a_worn_place_is_found_there() -> None:
    """Three times as much within 150 mm of 600 mm."""
    worn = 1.0 + 2.0 * np.exp(-(((TARGETS - 600.0) / 150.0) ** 2))
    draws = posterior(white(14) * worn[:, np.newaxis]).draws
    scale = np.median(draws.scale_at(np.array([100.0, 600.0])), axis=0)
    assert scale[0] / UM == pytest.approx([1.0, 3.0], rel=0.3)
    assert np.mean((draws.dof < 8.0) | (draws.outlier_share > 0.0)) < 0.3


def test_readings_of_a_coarse_instrument_show_their_scatter() -> None:
    """Steps of 2 µm with a scatter of 1 µm: fresh readings of one cell scatter by 1.13 µm; many of
    them are equal, which is no heavy tail.
    """
    readings = (
        2.0 * np.round(0.5 * white(14))
        - 20.0 * np.sin(np.linspace(0.0, 1000.0, M) / 150.0)[:, np.newaxis]
    )
    readings[1] -= 3.0
    draws = posterior(readings).draws
    assert inside(1.13 * UM, draws.sigma.mean(axis=1))
    assert np.mean((draws.dof < 8.0) | (draws.outlier_share > 0.0)) < 0.3


@pytest.mark.parametrize("sigma", [0.15, 0.3, 0.5, 2.0])
def test_rounded_readings_scatter_as_they_do_when_they_are_rounded(sigma: float) -> None:
    """Against 4000 cells of 50 rounded readings; standard error of the root below 1.5 %."""
    rng = np.random.default_rng(3)
    readings = rng.random((4000, 1)) + sigma * rng.standard_normal((4000, 50))
    variance = np.mean(np.var(np.round(readings), axis=1, ddof=1))
    assert rounded_std(3.0 * sigma, 3.0) == pytest.approx(3.0 * np.sqrt(variance), rel=0.05)


def test_many_scales_are_rounded_as_each_of_them() -> None:
    sigmas = np.array([0.05, 0.31, 0.31, 0.9, 2.0]) * UM
    expected = [rounded_std(float(sigma), UM) for sigma in sigmas]
    assert rounded_stds(sigmas, UM) == pytest.approx(expected, rel=1e-3)
    assert rounded_stds(sigmas[:1], UM) == pytest.approx(expected[:1])


@pytest.mark.parametrize("sigma", [0.0, 0.1, 0.25, 0.4])
def test_rounding_moves_all_readings_of_a_cell_alike(sigma: float) -> None:
    """Against 20000 cells: root mean square of what the mean of rounded readings is off, found from
    the product of two readings of a cell, in which their own scatter is not; known to about 2 % of
    1/12.
    """
    rng = np.random.default_rng(5)
    true = rng.random((20000, 1))
    off = np.round(true + sigma * rng.standard_normal((20000, 2))) - true
    assert common_std(3.0 * sigma, 3.0) ** 2 == pytest.approx(
        9.0 * np.mean(off[:, 0] * off[:, 1]), abs=9.0 * 0.05 / 12.0
    )


@pytest.mark.parametrize("sigma", [0.0, 0.1, 0.3])
def test_means_of_coarse_readings_are_believed_as_far_as_they_are_right(sigma: float) -> None:
    """Steps of 1 µm, true errors of the cells known: the means are off by what is said of them.
    Root mean square of 80 quotients: 1 ± 8 %; uniform or nearly so, thus less within two.
    """
    m = 40
    true = 30.0 * np.random.default_rng(8).random((2, m, 1))
    read = np.round(true + sigma * white(16, m=m))
    curve = 20.0 * np.sin(np.linspace(0.0, 1000.0, m) / 150.0)[:, np.newaxis]
    found = posterior(np.stack([read[0] - curve, read[1] - curve - 3.0]))
    off = (found.mean - true.ravel() * UM) * np.sqrt(found.precision)
    assert np.sqrt(np.mean(off**2)) == pytest.approx(1.0, abs=0.25)


def test_readings_without_any_scatter_have_the_least_noise() -> None:
    found = posterior(np.zeros((2, M, N)))
    assert np.all(np.isfinite(found.mean))
    assert np.all(found.draws.sigma > 0.0)
    assert np.all(found.draws.sigma < 0.1 * UM)


# --- protocols
# --------------------------------------------------------------------------------------------------


def test_few_repetitions_leave_the_noise_to_the_curve() -> None:
    assert infer_noise(made(white(1, n=1))) is None
    assert infer_noise(made(white(1, m=(LEAST_DOF - 1) // 2, n=2))) is None
    assert infer_noise(made(white(1, m=LEAST_DOF // 2, n=2))) is not None


def test_one_direction_with_readings_missing() -> None:
    readings = white(15)
    readings[0, 3, 1:] = np.nan
    readings[0, 9] = np.nan
    found = posterior(readings, negative=np.empty((M, 0)), runs_negative=())
    assert inside(1.0 * UM, found.draws.sigma[:, 0])
    empty = np.r_[9, M : 2 * M]
    assert not np.any(found.precision[:, empty])
    assert not np.any(found.mean[:, empty])
    assert np.all(np.isfinite(found.columns))


def test_a_missing_run_does_not_take_its_drift_out_of_the_mean() -> None:
    """The last run stopped halfway: the means of the other half lack its 4 µm of drift."""
    drift = 8.0 * (np.arange(N) / (N - 1) - 0.5)
    readings = 0.3 * white(16) + drift
    readings[:, 11:, 4] = np.nan
    found = posterior(readings)
    curve = np.tile(20.0 * np.sin(TARGETS / 150.0), 2) + np.repeat([0.0, 3.0], M)
    left = np.median(found.mean, axis=0) / UM - curve
    assert np.mean(left[11:M]) - np.mean(left[:11]) == pytest.approx(0.0, abs=0.25)  # of 1 µm


def test_nothing_drifts_in_a_step_cycle() -> None:
    drift = 6.0 * (np.arange(N) / (N - 1) - 0.5)
    draws = posterior(white(17) + drift, cycle="step").draws
    assert not np.any(draws.drift)
    assert np.all(draws.pattern <= RUNS)


def test_the_same_test_has_the_same_noise_in_any_unit() -> None:
    """Same bytes from the same readings; arcsec for µm changes sizes alone."""
    readings = white(18)
    first, second = posterior(readings), posterior(readings)
    assert first.mean.tobytes() == second.mean.tobytes()
    assert first.draws.sigma.tobytes() == second.draws.sigma.tobytes()
    doubled = posterior(2.0 * readings).draws
    assert doubled.sigma == pytest.approx(2.0 * first.draws.sigma, rel=1e-3)


# --- findings
# --------------------------------------------------------------------------------------------------


def codes(found: NoisePosterior) -> set[str]:
    return {finding.code for finding in found.findings}


def message(found: NoisePosterior, code: str) -> str:
    return next(finding.message for finding in found.findings if finding.code == code)


def test_nothing_is_said_of_white_noise() -> None:
    for seed in range(30, 34):
        assert posterior(white(seed)).findings == ()


def test_a_drift_is_told_with_its_size_and_its_odds() -> None:
    drift = -6.0 * (np.arange(N) / (N - 1) - 0.5)
    found = posterior(white(5) + drift)
    assert codes(found) == {"CW-E020"}
    size = re.search(
        r"drift by (-[0-9.]+) µm .*more than 1000 times as likely as not", message(found, "CW-E020")
    )
    assert size is not None
    assert float(size[1]) == pytest.approx(-6.0, abs=0.6)


def test_expansion_is_told_at_both_ends() -> None:
    drift = 6.0 * U * (np.arange(N) / (N - 1) - 0.5)
    told = message(posterior(white(6) + drift), "CW-E021")
    low, high = map(float, re.findall(r"([+-][0-9.]+) µm at the (?:lower|upper) end", told))
    assert (low, high) == pytest.approx((-6.0, 6.0), abs=0.9)


def test_outliers_are_told_by_run_direction_and_place() -> None:
    """In + and - the run numbers of the test count; what lies furthest off stands first."""
    readings = white(10)
    readings[0, 7, 2] += 25.0
    readings[1, 4, 0] -= 40.0
    found = posterior(readings, runs_positive=(1, 2, 6, 7, 8))
    assert codes(found) == {"CW-E024"}
    told = message(found, "CW-E024")
    assert told.startswith("2 of 210 readings are outliers: run 1 in − at 200 mm (deviates by -")
    assert "run 6 in + at 350 mm (deviates by +2" in told


def test_outliers_that_lie_together_are_told_by_what_they_have_in_common() -> None:
    """Half a traverse 12 µm off; one and two loose places whose readings scatter by 15 µm."""
    traverse, place, places = white(31), white(32), white(33)
    traverse[1, :9, 4] += 12.0
    place[:, 13] *= 15.0
    places[:, [4, 13]] *= 15.0
    (finding,) = (one for one in posterior(traverse).findings if one.code == "CW-E024")
    assert finding.values["cause"].name == "CW-E024.traverse"
    for loose, where in ((place, [650.0]), (places, [200.0, 650.0])):
        (doubt,) = (one for one in posterior(loose).findings if one.code == "CW-E032")
        assert doubt.is_doubt
        targets = dict(doubt.values["cause"].values)["target"]
        assert [target.value for target in targets] == where


@pytest.mark.parametrize(
    ("code", "readings"),
    [
        ("CW-E022", white(8) + 2.0 * np.random.default_rng(8).standard_normal((2, 1, N))),
        ("CW-E023", white(8) + 2.0 * np.random.default_rng(9).standard_normal((2, 1, N)) * U),
        ("CW-E025", np.random.default_rng(11).standard_t(3.0, (2, M, N))),
        ("CW-E026", white(13) * np.array([1.0, 2.5])[:, np.newaxis, np.newaxis]),
        ("CW-E027", white(13) * np.exp(0.8 * U)),
    ],
)
def test_each_deviation_from_white_noise_has_its_finding(code: str, readings: FloatArray) -> None:
    assert code in codes(posterior(readings))


@pytest.mark.parametrize("seed", [1, 2, 5])
def test_a_reading_one_step_beside_the_others_is_no_outlier(seed: int) -> None:
    """Steps of 1 µm and a scatter of 0.1: readings of a cell near the limit between two numbers."""
    true = 30.0 * np.random.default_rng(seed).random((2, M, 1))
    curve = 20.0 * np.sin(np.linspace(0.0, 1000.0, M) / 150.0)[:, np.newaxis]
    read = np.round(true + 0.1 * white(seed)) - curve
    read[1] -= 3.0
    assert [one.code for one in posterior(read).findings] == ["CW-E029"]
