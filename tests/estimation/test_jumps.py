"""Jumps of the error between two targets: axes with a known step are simulated here, and what is
made of them is compared with the truth and with straight lines between the means.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from compwright.estimation.axis import AxisPosterior, estimate_axis
from compwright.estimation.jumps import Jump, find_jumps
from compwright.estimation.noise import infer_noise
from compwright.estimation.observed_test import ObservedTest
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.positioning import PositioningTest

UM = 1e-3
LENGTH = 800.0
Curve = Callable[[FloatArray], FloatArray]


def smooth(phase: float) -> Curve:
    return lambda x: 10.0 * np.sin(x / 200.0 + phase) + 0.01 * x


def jumping(phase: float, *steps: tuple[float, float]) -> Curve:
    """A smooth error, and steps (place in mm, size in µm)."""
    plain = smooth(phase)
    return lambda x: plain(x) + sum(size * (x > place) for place, size in steps)


def estimated(error: Curve, targets: FloatArray, seed: int, noise: float = 0.3) -> AxisPosterior:
    rng = np.random.default_rng(seed)
    readings = [
        (error(targets)[:, np.newaxis] + lost + noise * rng.standard_normal((targets.size, 5))) * UM
        for lost in (0.0, -3.0)
    ]
    test = PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=readings[0],
        negative=readings[1],
        runs_positive=(1, 2, 3, 4, 5),
        runs_negative=(1, 2, 3, 4, 5),
        frame="machine",
    )
    return estimate_axis([ObservedTest(test=test, noise=infer_noise(test))], travel=(0.0, LENGTH))


def dithered(count: int, seed: int) -> FloatArray:
    places = np.arange(count) + 0.5 + np.random.default_rng(seed).uniform(-0.3, 0.3, count)
    return np.asarray(np.round(places * LENGTH / count, 3))


def left(posterior: AxisPosterior, error: Curve, where: FloatArray) -> float:
    """The range of what a table of minus the estimate leaves in +, µm."""
    held = posterior.summary(where).mean_positive / UM
    return float(np.ptp(error(where) - held))


# --- found, and told
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [8, 17])
def test_a_jump_is_named_with_its_size_and_place(count: int) -> None:
    targets = dithered(count, 1)
    place = float(targets[3] + targets[4]) / 2.0
    posterior = estimated(jumping(1.0, (place, 100.0)), targets, 2)
    (jump,) = posterior.cells.jumps
    assert (jump.low, jump.high) == (targets[3], targets[4])
    assert abs(jump.size / UM - 100.0) < 3.0 * jump.std / UM < 15.0
    (told,) = [one for one in posterior.findings if one.code == "CW-E030"]
    assert told.severity == "warning"
    assert f"{targets[3]:.10g} and {targets[4]:.10g} mm" in told.message
    assert "+100" in told.message or "+99" in told.message or "+101" in told.message


def test_two_jumps_are_named_each_with_its_sign() -> None:
    targets = np.linspace(0.0, LENGTH, 21)
    posterior = estimated(jumping(0.0, (210.0, 40.0), (610.0, -60.0)), targets, 3)
    found = [(jump.low, round(jump.size / UM, -1)) for jump in posterior.cells.jumps]
    assert found == [(200.0, 40.0), (600.0, -60.0)]


@pytest.mark.parametrize("count", [11, 16, 21])
@pytest.mark.parametrize("back", [-50.0, 50.0, -30.0])
def test_two_jumps_do_not_hide_each_other(count: int, back: float) -> None:
    """A flat axis, 50 µm up and then ``back``: one jump alone explains it as badly as none."""
    targets = np.linspace(0.0, LENGTH, count)
    first, second = count // 4, 2 * count // 3
    values = 50.0 * (np.arange(count) > first) + back * (np.arange(count) > second)
    values = values + np.random.default_rng(count).normal(0.0, 0.2, count)
    found = find_jumps(targets, values * UM, np.full(count, 0.2 * UM))
    assert [jump.low for jump in found] == [targets[first], targets[second]]
    assert [jump.size / UM for jump in found] == pytest.approx([50.0, back], abs=1.0)
    assert all(jump.named for jump in found)


def test_jumps_of_a_long_axis_are_found_where_they_are() -> None:
    """More targets than are looked at together, and jumps near the ends and close together."""
    count = 45
    targets = dithered(count, 8)
    truth = {2: 20.0, 22: -40.0, 25: 40.0, 41: 8.0}
    values = smooth(0.5)(targets) + np.random.default_rng(8).normal(0.0, 0.2, count)
    for gap, size in truth.items():
        values = values + size * (np.arange(count) > gap)
    found = [one for one in find_jumps(targets, values * UM, np.full(count, 0.2 * UM)) if one.named]
    assert [jump.low for jump in found] == [targets[gap] for gap in truth]
    assert [jump.size / UM for jump in found] == pytest.approx(list(truth.values()), abs=1.0)


def test_two_outliers_next_to_each_other_may_be_two_jumps() -> None:
    """Nothing tells them apart: neither is sure."""
    targets = np.linspace(0.0, LENGTH, 15)
    values = 50.0 * np.isin(np.arange(15), (6, 7)) + np.random.default_rng(3).normal(0.0, 0.2, 15)
    found = find_jumps(targets, values * UM, np.full(15, 0.2 * UM))
    assert [jump.low for jump in found] == [targets[5], targets[7]]
    assert all(0.2 < jump.odds < 5.0 for jump in found)


@pytest.mark.parametrize("seed", range(6))
def test_smooth_errors_kinks_bumps_and_waves_are_no_jump(seed: int) -> None:
    rng = np.random.default_rng(seed)
    x = dithered(int(rng.integers(8, 30)), seed)
    errors = (
        smooth(seed)(x),
        smooth(seed)(x) + 0.1 * np.maximum(x - 350.0, 0.0),
        smooth(seed)(x) + 15.0 * np.exp(-0.5 * ((x - 400.0) / 60.0) ** 2),
        smooth(seed)(x) + 3.0 * np.sin(2.0 * np.pi * x / 10.0),
        smooth(seed)(x) + 20.0 * (np.arange(x.size) == 5),
        5.0 * np.round(smooth(seed)(x) / 5.0),
    )
    for number, error in enumerate(errors):
        values = (error + rng.normal(0.0, 0.2, x.size)) * UM
        stds = np.full(x.size, (0.2 if number < 5 else 1.5) * UM)
        assert not [jump for jump in find_jumps(x, values, stds) if jump.named], number


# --- what the table then holds
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("count", "size"), [(8, 30.0), (11, 100.0), (17, 1000.0)])
def test_the_estimate_is_never_worse_than_straight_lines_between_the_means(
    count: int, size: float
) -> None:
    """Everywhere but between the two targets, where nobody knows the place of the jump."""
    ours, lines = [], []
    for seed in range(2):
        targets = dithered(count, seed)
        rng = np.random.default_rng(seed)
        gap = int(rng.integers(2, count - 2))
        error = jumping(seed, (float(targets[gap - 1]) + 1.0, size))
        posterior = estimated(error, targets, seed, noise=0.1)
        where = np.linspace(targets[0], targets[-1], 400)
        where = where[(where < targets[gap - 1]) | (where > targets[gap])]
        ours.append(left(posterior, error, where))
        lines.append(float(np.ptp(error(where) - np.interp(where, targets, error(targets)))))
    assert np.mean(ours) < np.mean(lines) + 0.2
    assert max(ours) < 1.5


def test_a_small_jump_between_few_targets_brings_no_short_waves_into_the_table() -> None:
    """5 µm, not found: several periods explain it as badly. None is probable, none is in the mean;
    the band holds them.
    """
    targets = dithered(8, 55)
    posterior = estimated(jumping(55, (float(targets[2]) + 20.0, 5.0)), targets, 55)
    assert sum(one.probability for one in posterior.periods) < 0.5
    where = np.arange(targets[0], targets[-1], 1.0)
    summary = posterior.summary(where)
    bends = np.diff(summary.mean_positive, 2) / UM  # a wave of 6 mm and 0.1 µm: 0.1 µm
    assert np.max(np.abs(bends)) < 0.02
    drawn = posterior.draw(where[20::40], 4000, np.random.default_rng(1)).positive
    about = np.sqrt(np.mean((drawn - summary.mean_positive[20::40]) ** 2, axis=0))
    assert about == pytest.approx(summary.std_positive[20::40], rel=0.07)


def test_the_gap_is_as_uncertain_as_the_jump() -> None:
    """Half of the draws have it in the middle of the gap, half do not: 100 µm apart."""
    targets = np.linspace(0.0, LENGTH, 17)
    posterior = estimated(jumping(1.0, (260.0, 100.0)), targets, 5)
    drawn = posterior.draw(np.array([240.0, 275.0, 310.0]), 400, np.random.default_rng(1)).positive
    low, middle, high = np.std(drawn, axis=0) / UM
    assert middle == pytest.approx(50.0, rel=0.1)
    assert max(low, high) < 3.0
    std = posterior.summary(np.array([240.0, 275.0, 310.0])).std_positive / UM
    assert std[1] == pytest.approx(50.0, rel=0.05)


# --- at the ends, and round an endless axis
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("gap", [0, 9])
def test_behind_the_last_gap_it_may_be_a_jump_or_one_target(gap: int) -> None:
    """The table then ends in a straight line, and swings nowhere else."""
    targets = dithered(11, 4)
    error = jumping(0.0, (float(targets[gap]) + 20.0, 100.0))
    posterior = estimated(error, targets, 4)
    (jump,) = posterior.cells.jumps
    assert (jump.low, jump.high) == (targets[gap], targets[gap + 1])
    (told,) = [one for one in posterior.findings if one.code == "CW-E030"]
    alone = targets[0] if gap == 0 else targets[10]
    assert f"or only the target at {alone:.10g} mm deviates" in told.message
    where = np.linspace(targets[0], targets[-1], 400)
    where = where[(where < targets[gap]) | (where > targets[gap + 1])]
    lines = np.interp(where, targets, error(targets))
    assert left(posterior, error, where) < 1.2 * np.ptp(error(where) - lines) + 0.3


def test_a_target_that_is_off_alone_is_no_jump() -> None:
    targets = dithered(17, 5)
    values = smooth(1.0)(targets) + 30.0 * (np.arange(17) == 8)
    values = values + np.random.default_rng(5).normal(0.0, 0.2, 17)
    assert not [one for one in find_jumps(targets, values * UM, np.full(17, 0.2 * UM)) if one.named]


@pytest.mark.parametrize(("place", "low", "high"), [(205.0, 200.0, 210.0), (355.0, 350.0, 0.0)])
def test_a_jump_of_an_endless_axis_is_found_across_the_seam_too(
    place: float, low: float, high: float
) -> None:
    """A ring whose ends do not meet: the error runs away evenly, and jumps back at the joint."""
    turn = 360.0
    targets = np.arange(0.0, turn, 10.0)

    def error(x: FloatArray) -> FloatArray:
        return np.asarray(
            4.0 * np.sin(np.radians(x)) - 20.0 * np.mod(x - place, turn) / turn + 20.0
        )

    values = error(targets) + np.random.default_rng(6).normal(0.0, 0.2, targets.size)
    (jump,) = find_jumps(targets, values, np.full(targets.size, 0.2), turn)
    assert jump.named
    assert (jump.low, jump.high % turn) == (low, high)
    assert jump.size == pytest.approx(20.0, abs=1.0)
    assert f"between {low:g} and {high:g} deg" in jump.finding(AxisKind.ROTARY).message
    far = np.array([low - 1e-6, low + 10.0 + 1e-6])
    assert np.ptp(jump.ramp(far)) == pytest.approx(jump.size * 35.0 / 36.0, rel=1e-3)


def test_the_table_bends_inside_the_gap_and_holds_its_targets() -> None:
    """A control's points lie anywhere: 2 mm beside the targets of this gap of 50 mm."""
    targets = np.linspace(0.0, LENGTH, 17)
    error = jumping(1.0, (260.0, 100.0))
    posterior = estimated(error, targets, 5, noise=0.1)
    points = np.append(np.arange(0.0, LENGTH, 4.0) + 2.0, LENGTH)
    table = np.interp(targets, points, posterior.summary(points).mean_positive / UM)
    assert np.ptp(error(targets)[1:-1] - table[1:-1]) < 1.0


def test_what_is_hardly_there_is_drawn_as_rarely() -> None:
    jump = Jump(low=0.0, high=10.0, size=1.0, std=0.1, odds=0.25)
    drawn = jump.drawn(np.array([0.4, 9.6]), 8000, np.random.default_rng(7))
    there = np.any(drawn != 0.0, axis=1)  # a step in the fifth of the draws, here or there
    assert np.mean(there) == pytest.approx(0.2 * 0.08, abs=0.005)
    own = np.array([[1.0], [9.0]])
    assert jump.drawn(own, 2, np.random.default_rng(8)).shape == (2, 1)
    assert jump.variance(np.array([5.0]))[0] == pytest.approx(0.2 * 0.25)


def test_means_on_a_straight_line_without_any_spread_show_no_jump() -> None:
    targets = np.linspace(0.0, 800.0, 17)
    for slope in (0.0, 2e-5):
        assert find_jumps(targets, slope * targets + 0.003, np.zeros(17)) == ()
