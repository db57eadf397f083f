"""The guard band of a predicted decision: from axes whose true temperatures are known, and by hand
numbers.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, sqrt
from typing import Any, cast

import numpy as np
import pytest

from compwright.estimation.axis import Draws
from compwright.evaluation.standards import evaluate
from compwright.planning.guard_bands import guard_bands
from compwright.planning.predicted_gain import predict_same_targets
from compwright.planning.simulated_repeat_tests import RepeatConditions, fresh_tests
from compwright.planning.temperature_slopes import slope_after
from compwright.planning.wanted_correction import MeasuredError
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.axis import AxisKind
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.job import Job
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import Quantiles
from planning_samples import (
    PPM,
    TARGETS,
    UM,
    Curve,
    Floats,
    KnownAxis,
    axis_of,
    by_slope,
    job_of,
    readings_of,
    work_of,
)

STEEL = Thermal(alpha_m=11.5, T_m=24.0)
THETA = UncertaintyBudget(U_theta=0.5)
OF_ONE = 11.5 * 0.5  # µm over 1 m, expanded: what half a kelvin makes of one test


def guarded_job(budget: UncertaintyBudget | None, kind: AxisKind = AxisKind.LINEAR) -> Job:
    which = "uncertainty_rotary" if kind is AxisKind.ROTARY else "uncertainty"
    return job_of(axis_of(kind=kind), decision_rule="guarded", **{which: budget})


def two_readings(curve: Curve, **words: Any) -> PositioningTest:
    rows = curve(TARGETS)[:, None] * np.ones((1, 2))
    return readings_of(rows, rows, **{"thermal": STEEL, **words})


def bands(
    job: Job,
    known: KnownAxis,
    change: Correction = no_correction,
    tests: tuple[PositioningTest, ...] = (),
    standard: str = "iso230-2:2014",
) -> tuple[dict[str, Quantiles], dict[str, Quantiles], dict[str, float] | None]:
    """What a fresh test like the last of ``tests`` shows without what is declared and with the
    slopes of both tests, and U, all in µm (or arcsec).
    """
    (axis,) = (entry.axis for entry in job.axes.values())
    own = tests or (two_readings(known.plus, kind=axis.kind),)
    planned = replace(
        work_of(known, axis).planned,
        tests=tuple(PlannedTest(test=test, measured_in="as_found") for test in own),
    )
    result, place = evaluate(own[-1], standard), len(own) - 1
    posterior = cast("MeasuredError", known)
    slope = slope_after(job, planned.tests, own[-1])
    narrow, wide = (
        predict_same_targets(result, posterior, change, axis, RepeatConditions(place, std))
        for std in (0.0, slope)
    )
    stated = guard_bands(job, planned, place, result, posterior, change)
    unit = 1.0 / 3600.0 if axis.kind is AxisKind.ROTARY else UM
    U = None if stated is None else {name: each.U / unit for name, each in stated.items()}
    return dict(narrow), dict(wide), U


def test_it_holds_what_wrong_temperatures_of_both_tests_make_of_a_straight_axis() -> None:
    """The table takes out the slope as it was read, true slope and wrong temperature alike; the
    next test reads it again with a wrong temperature of its own. A of a straight line is abs(slope)
    · 1 m, so in 95.45 of 100 pairs of tests it lies within √2 · 5.75 µm.
    """
    rng = np.random.default_rng(3)
    wrong = 0.25 * rng.standard_normal((2, 100_000))  # K, standard deviation U/2
    left = 11.5 * (wrong[1] - wrong[0])  # µm/m after loading, whatever the true slope was
    read = (30.0 + 11.5 * wrong[0, 0]) * PPM
    straight = KnownAxis(lambda x: read * x, lambda x: read * x)
    shown, _, U = bands(guarded_job(THETA), straight, by_slope(-read))
    assert U is not None
    for name in ("A", "E", "M"):
        assert shown[name].p95 == pytest.approx(0.0, abs=1e-12)
        assert np.mean(np.abs(left) <= U[name]) == pytest.approx(0.9545, abs=0.004)
        assert U[name] == pytest.approx(sqrt(2.0) * OF_ONE, rel=0.02)
    assert (U["B"], U["R"]) == (0.0, 0.0)


def test_it_is_that_of_the_curve_that_the_table_leaves() -> None:
    """Two waves over the length: before, the extremes lie 200 mm apart, or 700; afterwards the
    slope alone decides over the whole metre.
    """

    def wave(x: Floats) -> Floats:
        return 0.05 * np.sin(2.0 * np.pi * x / 400.0)

    known = KnownAxis(wave, wave)
    job = guarded_job(THETA)
    before, after = (
        bands(job, known, change)[2]
        for change in (no_correction, lambda x, _way: -wave(np.asarray(x)))
    )
    assert before is not None
    assert after is not None
    assert before["E"] < 0.85 * after["E"]
    assert after["E"] == pytest.approx(sqrt(2.0) * OF_ONE, rel=0.02)


def bow(x: Floats) -> Floats:
    return 4e-3 * np.sin(np.pi * x / 1000.0)


@pytest.mark.parametrize(
    "known",
    [
        KnownAxis(np.zeros_like, np.zeros_like),
        KnownAxis(np.zeros_like, np.zeros_like, noise=1.5 * UM),
        KnownAxis(lambda x: 9e-6 * x, lambda x: 9e-6 * x, noise=0.3 * UM),
        KnownAxis(bow, bow, noise=0.5 * UM),
    ],
    ids=["flat", "noisy", "sloped", "bowed"],
)
def test_a_guarded_decision_is_never_more_willing_than_a_simple_one(known: KnownAxis) -> None:
    every = UncertaintyBudget(U_theta=0.5, misalignment_mm=1.0, setup=1.0, device_per_m=0.3)
    narrow, wide, U = bands(guarded_job(every), known)
    assert U is not None
    for name, band in narrow.items():
        assert band.p95 + U[name] * UM >= wide[name].p95 - 1e-12, name
        assert band.p05 - U[name] * UM <= wide[name].p05 + 1e-12, name


class Seldom(KnownAxis):
    """A flat axis that jumps by 0.1 mm in 45 of 1000 draws: its 95 % value knows nothing of it."""

    def draw(self, positions: Floats, count: int, rng: np.random.Generator, test: int = 0) -> Draws:
        flat = super().draw(positions, count, rng, test)
        jumps = 0.1 * (np.arange(count) < 0.045 * count)[:, None] * (positions > 500.0)
        return replace(flat, positive=flat.positive + jumps, negative=flat.negative + jumps)


def test_nor_where_what_is_seldom_hides_the_tail_of_what_is_declared() -> None:
    """Of the tests that do not jump 0.5 in 100 may lie beyond the 95 % value with the slopes: 2.8
    of their standard deviations. Two would be the U of the slopes alone.
    """
    narrow, wide, U = bands(guarded_job(THETA), Seldom(np.zeros_like, np.zeros_like))
    assert U is not None
    assert wide["A"].p95 > 1.2 * sqrt(2.0) * OF_ONE * UM
    assert narrow["A"].p95 + U["A"] * UM == pytest.approx(wide["A"].p95)


def test_at_new_targets_an_uncertain_temperature_tilts_a_straight_axis() -> None:
    """E of a straight line is abs(slope) times its length; of a normal law 95 % of the sizes lie
    within 1.96 and half within 0.674 standard deviations.
    """
    axis = axis_of()
    flat = cast("MeasuredError", KnownAxis(np.zeros_like, np.zeros_like))
    result = evaluate(two_readings(np.zeros_like), "iso230-2:2014")
    fresh = fresh_tests(result, flat, axis, RepeatConditions(slope_std=5.0 * PPM))
    length = float(np.mean(np.ptp(fresh.targets, axis=1)))
    shown = fresh.quantiles(no_correction)["E"]
    assert shown.p95 == pytest.approx(1.96 * 5.0 * PPM * length, rel=0.1)
    assert shown.median == pytest.approx(0.674 * 5.0 * PPM * length, rel=0.1)
    assert fresh.quantiles(no_correction, warm=False)["E"].p95 < 1e-9


def test_what_is_the_same_in_both_tests_counts_once() -> None:
    """Instrument and coefficient: the table has their error, the next test does not show it."""
    flat = KnownAxis(np.zeros_like, np.zeros_like)
    for budget, expected in (
        (UncertaintyBudget(device=0.5, device_per_m=2.0), 2.5),
        (UncertaintyBudget(U_alpha=1.5), 4.0 * 1.5),
        (UncertaintyBudget(device_per_m=2.0, U_theta=0.5), hypot(2.0, sqrt(2.0) * OF_ONE)),
        (UncertaintyBudget(setup=2.0), sqrt(2.0) * 2.0),
        (UncertaintyBudget(misalignment_mm=2.0), sqrt(2.0) * 4.0 / sqrt(12.0)),
    ):
        _, _, U = bands(guarded_job(budget), flat)
        assert U is not None
        assert U["E"] == pytest.approx(expected, rel=0.03), budget


def test_the_coefficient_counts_again_between_tests_at_two_temperatures() -> None:
    """The table is made from a test at 30 °C: one at 20 °C meets what 10 K did to it."""
    flat = KnownAxis(np.zeros_like, np.zeros_like)
    tests = tuple(
        two_readings(np.zeros_like, name=name, thermal=replace(STEEL, T_m=T))
        for name, T in (("warm", 30.0), ("cold", 20.0))
    )
    _, _, U = bands(guarded_job(UncertaintyBudget(U_alpha=1.0)), flat, tests=tests)
    assert U is not None
    assert U["E"] == pytest.approx(10.0, rel=0.02)


def test_of_angles_the_set_up_counts_for_both_tests_and_the_instrument_once() -> None:
    flat = KnownAxis(np.zeros_like, np.zeros_like)
    budget = UncertaintyBudget(device=2.0, setup=1.5)
    _, _, U = bands(guarded_job(budget, AxisKind.ROTARY), flat)
    assert U is not None
    assert U["A"] == pytest.approx(hypot(2.0, 1.5, 1.5), rel=0.02)


def test_the_environment_counts_for_the_coming_test() -> None:
    """M of the means of both directions, two readings each: E_VE/√3 · √(1/2)."""
    steep = KnownAxis(lambda x: 1e-4 * x, lambda x: 1e-4 * x)
    _, _, U = bands(guarded_job(UncertaintyBudget(E_VE=2.0)), steep)
    assert U is not None
    assert U["M"] == pytest.approx(2.0 / sqrt(3.0) * sqrt(0.5), rel=0.06)


def test_without_contributors_there_is_none() -> None:
    flat = KnownAxis(np.zeros_like, np.zeros_like)
    assert bands(guarded_job(None), flat)[2] is None
    assert bands(guarded_job(THETA), flat, standard="vdi3441")[2] is None
