"""Tests whose readings scatter too little to tell their noise, or not at all: what they show is
believed as it is, and nothing breaks. Judged by fresh tests that are simulated here from the known
shifts, and by the shifts themselves.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from compwright.estimation.axis import estimate_axis
from compwright.estimation.noise import infer_noise
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.statistics import parameters
from compwright.prediction.fresh_noise import fresh_noise
from compwright.prediction.fresh_scatter import fresh_scatter
from compwright.prediction.positioning import predict_test
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import NoiseDraws, without
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import Quantiles

UM = 1e-3
SHIFTS = np.array([0.0, 1.3, -0.7, 2.2, 0.4])
RNG = np.random.default_rng


def made(plus: FloatArray, minus: FloatArray, length: float = 800.0) -> PositioningTest:
    runs = tuple(range(1, plus.shape[1] + 1))
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=np.linspace(0.0, length, plus.shape[0]),
        positive=plus * UM,
        negative=minus * UM,
        runs_positive=runs,
        runs_negative=runs,
        frame="machine",
    )


def curve(count: int = 11) -> FloatArray:
    x = np.linspace(0.0, 800.0, count)
    return (10.0 * np.sin(x / 200.0) + 0.01 * x)[:, np.newaxis]


def shifted(runs: FloatArray, count: int = 11) -> PositioningTest:
    return made(curve(count) + runs, curve(count) - 3.0 + runs)


def known(test: PositioningTest) -> NoisePosterior:
    found = infer_noise(test)
    assert found is not None
    return found


def shown(noise: NoiseDraws, test: PositioningTest) -> Quantiles:
    """A of fresh tests of an axis whose error is nothing, µm."""
    still = np.zeros((noise.count, test.targets.size))
    scatter = fresh_scatter(
        noise, test.targets, test.positive.shape[1], test.negative.shape[1], RNG(1)
    )
    found = predict_test(
        still, still, scatter, change_positive=still[0], change_negative=still[0], coverage=2.0
    )["A"]
    return Quantiles(median=found.median / UM, p05=found.p05 / UM, p95=found.p95 / UM)


def simulated(std: float, runs: int = 5) -> FloatArray:
    """A (µm) of tests that differ by shifts of their runs alone."""
    means, ones = RNG(2).normal(0.0, std, (4000, 1, runs)), np.zeros((1, 11, 1))
    readings = means + ones
    mean, s = readings.mean(axis=2), readings.std(axis=2, ddof=1)
    return np.asarray(parameters(mean, s, mean, s, 2.0, "A")["A"])


# --- the spread between runs
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("inside", [0.0, 0.001, 0.01, 0.1])
def test_runs_that_differ_are_predicted_to_differ_whatever_the_scatter_inside(
    inside: float,
) -> None:
    test = shifted(SHIFTS + inside * RNG(3).standard_normal((11, 5)))
    found, fresh = (
        shown(known(test).fresh, test),
        np.median(simulated(float(np.std(SHIFTS, ddof=1)))),
    )
    assert 0.85 * fresh < found.median < 1.5 * fresh
    assert found.p05 < fresh < found.p95
    assert found.p95 > 4.0 * np.std(SHIFTS, ddof=1)  # R of the test itself


def test_traverses_that_tilt_are_predicted_to_tilt_without_scatter() -> None:
    """The ends move by the shifts against the middle, either way: there R was 4.5 µm."""
    turned = SHIFTS * np.linspace(-1.0, 1.0, 11)[:, np.newaxis]
    test = made(curve() + turned, curve() + turned)
    assert shown(known(test).fresh, test).median > 3.5


def test_each_draw_moves_repeated_runs_by_what_they_moved_or_more() -> None:
    """Of runs that are shifted the standard deviation is known to be 1.13 µm here."""
    offset = known(shifted(SHIFTS)).fresh.offset / UM
    assert np.min(offset) >= 0.99 * np.std(SHIFTS, ddof=1) * np.sqrt(0.8)


def test_scatter_in_one_direction_alone_is_predicted() -> None:
    plus = curve() + RNG(4).standard_normal((11, 5))
    test = made(plus, np.repeat(curve() - 3.0, 5, axis=1))
    found = known(test).fresh.sigma / UM
    assert np.median(found[:, 0]) == pytest.approx(1.0, abs=0.25)
    assert np.median(found[:, 1]) < 0.4


# --- nothing breaks
# --------------------------------------------------------------------------------------------------

#: Readings of a test in + and in -, µm, of eleven targets in five runs.
ALTERNATING, ALONE = np.array([0.0, 1.0, 0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0, 0.0, 0.0])
ONE = (np.arange(11) == 4)[:, np.newaxis]
FAMILY: dict[str, Callable[[], tuple[FloatArray, FloatArray]]] = {
    "alternating": lambda: (curve() + ALTERNATING, curve() - 3.0 + ALTERNATING),
    "one run": lambda: (curve() + ALONE, curve() - 3.0 + ALONE),
    "one run by 100 µm": lambda: (curve() + 100.0 * ALONE, curve() - 3.0 + 100.0 * ALONE),
    "one run, nothing else": lambda: (0.0 * curve() + ALONE, 0.0 * curve() + ALONE),
    "opposite": lambda: (curve() + SHIFTS, curve() - SHIFTS),
    "no scatter": lambda: (curve() + 0.0 * SHIFTS, curve() + 0.0 * SHIFTS),
    "all zero": lambda: (0.0 * curve() + 0.0 * SHIFTS, 0.0 * curve() + 0.0 * SHIFTS),
    "one target scatters": lambda: (
        curve() + ONE * RNG(5).standard_normal((11, 5)),
        curve() + 0.0 * SHIFTS,
    ),
    "one target does not": lambda: (
        curve() + ~ONE * RNG(6).standard_normal((11, 5)),
        curve() + ~ONE * RNG(7).standard_normal((11, 5)),
    ),
    "whole steps": lambda: (
        5.0 * np.round((curve() + SHIFTS) / 5.0),
        5.0 * np.round((curve() + SHIFTS) / 5.0),
    ),
    "metres off": lambda: (1e6 + curve() + SHIFTS, 1e6 + curve() + SHIFTS),
    "nanometres": lambda: (1e-4 * (curve() + SHIFTS), 1e-4 * (curve() + SHIFTS)),
    "centimetres": lambda: (1e4 * (curve() + SHIFTS), 1e4 * (curve() + SHIFTS)),
}


@pytest.mark.parametrize("name", FAMILY)
def test_every_valid_test_has_a_noise_and_an_error(name: str) -> None:
    """Without any warning of numpy (they are errors here)."""
    plus, minus = FAMILY[name]()
    test = made(plus, minus)
    noise = known(test)
    posterior = estimate_axis([ObservedTest(test=test, noise=noise)], travel=(0.0, 800.0))
    estimate = posterior.summary(test.targets)
    spread = float(np.max(np.abs(plus - plus.mean(axis=1, keepdims=True)))) * UM
    # The mean of a cell, as far as its readings differ and no instrument shows less than 10 nm.
    for found, block in ((estimate.mean_positive, plus), (estimate.mean_negative, minus)):
        assert np.max(np.abs(found - block.mean(axis=1) * UM)) < 1.5 * spread + 6.0 * UM
    found_a = shown(noise.fresh, test)
    assert 0.0 < found_a.p05 <= found_a.median <= found_a.p95 < 60.0 * spread / UM + 0.5


def test_a_reversal_that_differs_from_target_to_target_swings_nowhere_between_them() -> None:
    """Without scatter a smooth curve through such differences swings by hundreds of µm."""
    own = RNG(3).normal(0.0, 0.5, (2, 25, 1))
    test = made(curve(25) + own[0] + SHIFTS, curve(25) + own[1] - 5.0 + SHIFTS)
    posterior = estimate_axis([ObservedTest(test=test, noise=known(test))], travel=(0.0, 800.0))
    between = posterior.summary(np.linspace(0.0, 800.0, 321))
    reversal = (between.mean_positive - between.mean_negative) / UM
    assert np.max(np.abs(reversal - 5.0)) < 2.0  # four times what differs
    drawn = posterior.draw(test.targets, 400, RNG(4))
    own_reversal = (drawn.positive - drawn.negative) / UM
    # What no smooth reversal holds shows again: 0.5 µm in each direction.
    assert 0.4 < np.median(np.std(own_reversal, axis=1)) < 1.2


# --- coarse readings
# --------------------------------------------------------------------------------------------------


def test_two_targets_next_to_each_other_that_differ_do_not_make_a_huge_wave() -> None:
    """±2.5 µm in turn, once within 10 µm: a wave that explains it has an amplitude of 700 µm."""
    zigzag = np.where(np.arange(30) % 2, 2.5, -2.5)[:, np.newaxis]
    shifts, rng = np.array([0.0, 0.7, 0.47]), RNG(196)
    plus, minus = (zigzag + way * shifts + rng.normal(0.0, 0.01, (30, 3)) for way in (1.0, -1.0))
    test = made(plus, minus)
    targets = np.round(test.targets, 3)
    targets[15] = targets[14] + 0.01
    test = replace(test, targets=targets)
    error = estimate_axis([ObservedTest(test=test, noise=infer_noise(test))], travel=(0.0, 800.0))
    assert np.max(error.summary(np.arange(0.0, 800.0, 3.7)).std_positive) < 10.0 * 2.5 * UM


def test_the_step_that_was_assumed_is_told() -> None:
    """0.1 µm/mm at targets 50 mm apart: 5 µm from one to the next, and nothing in between."""
    line = np.repeat(0.1 * np.linspace(0.0, 500.0, 11)[:, np.newaxis], 5, axis=1)
    told = [one for one in known(made(line, line, 500.0)).findings if one.code == "CW-E029"]
    assert [one.severity for one in told] == ["warning"]
    assert "5 µm" in told[0].message


@pytest.mark.parametrize(
    "runs",
    [
        3.0 * np.array([0.0, 1.0, 0.0, 1.0, 0.0]),
        7.0 * np.arange(5.0),
        3.0 * np.array([0.0, 0.0, 1.0, 0.0, 0.0]),
        np.array([-3.0, 2.0, 0.0, 3.0, -1.0]),
    ],
)
@pytest.mark.parametrize("step", [0.5, 5.0])
def test_the_step_of_coarse_readings_is_told_whatever_runs_are_shifted_by(
    runs: FloatArray, step: float
) -> None:
    """Within the cells all differences are alike, and no step by themselves."""
    line = 0.1 * np.linspace(0.0, 500.0, 11)[:, np.newaxis] + step * runs
    shown = [
        step * np.round((line - lost + 0.1 * step * RNG(9).standard_normal((11, 5))) / step)
        for lost in (0.0, 3.0)
    ]
    (told,) = [
        one for one in known(made(shown[0], shown[1], 500.0)).findings if one.code == "CW-E029"
    ]
    assert told.values["step"].value == step


def test_shifts_of_whole_runs_and_gross_steps_are_no_resolution() -> None:
    flat = np.zeros((11, 5))
    gross = np.repeat(100.0 * np.arange(11)[:, np.newaxis], 5, axis=1)
    for test in (made(flat + ALONE, flat + ALONE), made(gross, gross)):
        assert "CW-E029" not in [one.code for one in known(test).findings]


# --- many runs
# --------------------------------------------------------------------------------------------------


def test_the_noise_of_many_runs_comes_from_some_and_the_means_from_all() -> None:
    readings = RNG(8).standard_normal((2, 11, 120))
    test = made(curve() + readings[0], curve() + readings[1])
    noise = known(test)
    assert "20 of 120 runs" in next(one.message for one in noise.findings if one.code == "CW-E031")
    plain = np.concatenate([test.positive, test.negative]).mean(axis=1)
    assert np.median(noise.mean, axis=0) == pytest.approx(plain, abs=0.02 * UM)
    assert np.median(noise.draws.sigma) == pytest.approx(UM, rel=0.15)
    assert np.median(noise.precision) == pytest.approx(120.0 / UM**2, rel=0.35)


def test_a_wave_over_many_runs_is_as_large_and_as_long_as_over_few() -> None:
    """Correlation after one correlation time: (1 + √3) exp(-√3) = 0.483."""
    few = known(shifted(SHIFTS)).fresh
    count = few.count
    noise = NoiseDraws(
        **{
            **{name: getattr(few, name) for name in few.__dataclass_fields__},
            "sigma": np.full((count, 2), 1e-9),
            "pattern": np.full(count, 3),
            "pace": np.full(count, 0.2),
            "offset": np.full(count, UM),
            "tilt": np.zeros(count),
            "drift": np.zeros(count),
            "drift_tilt": np.zeros(count),
        }
    )
    drawn = [fresh_noise(noise, np.array([400.0]), 500, 500, RNG(k))[0][:, 0] for k in range(10)]
    waves = np.concatenate(drawn) / UM
    assert np.std(waves[:, 250]) == pytest.approx(1.0, rel=0.06)
    assert np.mean(waves[:, 200] * waves[:, 300]) == pytest.approx(0.483, abs=0.06)


# --- calm at one end, rough at the other
# --------------------------------------------------------------------------------------------------


def test_an_outlier_of_a_calm_place_is_not_multiplied_at_a_rough_one() -> None:
    """Readings at one end are put off by up to 10 µm where most lie within 0.01 µm; at the other
    end they scatter by 1.5 µm. A disturbance has a size of its own, wherever the axis is.
    """
    rng = RNG(0)
    rough = np.geomspace(0.005, 1.5, 6)[:, np.newaxis] * rng.standard_normal((6, 12))
    rough[:2, 4:6] += np.array([[8.0, -6.0], [5.0, 10.0]])
    noise = known(made(rough, rough[:, ::-1])).fresh
    targets = np.linspace(0.0, 800.0, 6)
    fresh = np.concatenate([fresh_noise(noise, targets, 12, 0, RNG(k))[0] for k in range(5)])
    assert np.quantile(np.abs(fresh).max(axis=(1, 2)), 0.95) < 60.0 * UM
    assert np.mean(np.abs(fresh[:, :2]).max(axis=(1, 2)) > 3.0 * UM) > 0.5  # they come again
    assert not np.any(fresh_noise(without(noise, "scatter", "traverses"), targets, 9, 9, RNG(0)))
