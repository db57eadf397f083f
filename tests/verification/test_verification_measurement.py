"""The test after loading beside the first one: copies, gaps of coverage, and the loading verdict of
turned readings. Readings are made by hand.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.positioning import PositioningTest
from compwright.records.verification import LoadingVerdict
from compwright.verification.measurement_faults import (
    copied_scatter,
    measurement_fault,
    proof_findings,
)
from compwright.verification.read_back import judge_read_back
from evaluation_samples import axis_test
from loadings import judged as judged_loading

UM = 1e-3  # mm
TARGETS = np.linspace(0.0, 1000.0, 11)
TRAVEL = (0.0, 1000.0)


def measured(seed: int, *, size: float = 1.0, targets: FloatArray = TARGETS) -> PositioningTest:
    """An honest test: 12 µm/m and a wave times ``size``, 4 µm lost motion, 1 µm of noise, 5 runs."""
    rng = np.random.default_rng(seed)
    curve = size * (12e-6 * targets + 3 * UM * np.sin(targets / 150.0))
    up, down = (
        curve[:, None] + side * 2 * UM + UM * rng.standard_normal((targets.size, 5))
        for side in (-1.0, 1.0)
    )
    return axis_test(targets, up, down, name="first")


FIRST = measured(1)


def test_a_test_of_its_own_shows_no_fault_and_lacks_nothing() -> None:
    after = measured(2, size=0.2)
    assert measurement_fault(after, FIRST, TRAVEL) is None
    assert copied_scatter(after, FIRST) is None
    assert proof_findings(after, FIRST) == []


@pytest.mark.parametrize(
    ("positive", "negative", "words"),
    [
        (FIRST.positive, FIRST.negative, "from before loading. Measure"),
        (FIRST.positive + 0.007, FIRST.negative + 0.007, "from before loading. Measure"),
        (-FIRST.positive, -FIRST.negative, "with the sign reversed"),
        (0.002 - FIRST.positive, 0.002 - FIRST.negative, "with the sign reversed"),
        (FIRST.negative, FIRST.positive, "with the directions exchanged"),
    ],
)
def test_readings_of_the_first_test_are_a_copy_whatever_their_zero(
    positive: FloatArray, negative: FloatArray, words: str
) -> None:
    fault = measurement_fault(axis_test(TARGETS, positive, negative), FIRST, TRAVEL)
    assert fault is not None
    assert fault.of == "copied"
    assert words in str(fault.sentence)


def test_readings_at_other_targets_are_no_copy() -> None:
    after = axis_test(TARGETS + 1.0, FIRST.positive + 1 * UM, FIRST.negative)
    assert copied_scatter(after, FIRST) is None
    for moved in (0.5 * UM, -0.5 * UM):  # each direction its own constant: not one other zero
        after = axis_test(TARGETS + 1.0, FIRST.positive + moved, FIRST.negative)
        assert measurement_fault(after, FIRST, TRAVEL) is None


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_scatter_of_the_first_test_under_another_error_is_a_copy(sign: float) -> None:
    """Made from it: another systematic error with the first test's scatter, run by run, and a drift
    on top. Honest scatter of 80 degrees of freedom correlates by 0.11 (1 / sqrt(80)).
    """
    residue = FIRST.positive - FIRST.positive.mean(axis=1, keepdims=True)
    other = FIRST.negative - FIRST.negative.mean(axis=1, keepdims=True)
    curve = 5 * UM * np.cos(TARGETS / 200.0)[:, None]
    drift = 2 * UM * np.arange(5)
    made = axis_test(TARGETS, curve + sign * residue + drift, curve + sign * other + drift)
    correlation = copied_scatter(made, FIRST)
    assert correlation == pytest.approx(1.0, abs=1e-9)
    fault = measurement_fault(made, FIRST, TRAVEL)
    assert fault is not None
    assert "(correlation 1.00)" in str(fault.sentence)


@pytest.mark.parametrize(
    ("keep", "words"),
    [
        (np.arange(0, 11, 2), "it has 6 targets"),
        (np.arange(2, 11), "it covers 200 mm to 1000 mm"),
        (np.arange(0, 9), "it covers 0 mm to 800 mm"),
        (np.r_[0:4, 7:11], "over 400 mm of the travel there is no target"),
        (np.r_[0:2, 10:11], "it has 3 targets, and the standard asks for 5 at least"),
    ],
)
def test_targets_that_do_not_cover_the_first_test(keep: FloatArray, words: str) -> None:
    after = measured(2, targets=TARGETS[keep.astype(np.int64)])
    (finding,) = proof_findings(after, FIRST)
    assert finding.code == "CW-V020"
    assert words in finding.message


def test_one_interval_at_an_end_and_more_targets_are_enough() -> None:
    """Newly dithered targets begin and end up to an interval further inside."""
    for targets in (np.linspace(99.0, 901.0, 11), np.linspace(0.0, 1000.0, 21)):
        assert proof_findings(measured(2, targets=targets), FIRST) == []


def test_fewer_runs_than_the_first_test_lack_proof() -> None:
    after = measured(2)
    (finding,) = proof_findings(replace(after, negative=after.negative[:, :3]), FIRST)
    assert "it has 3 approaches in - (the first test: 5)" in finding.message


# ---------------------------------------------------------------- the loading of turned readings

LOADED = 4 * UM * np.sin(np.arange(9) / 1.3)
INACTIVE = LOADED + 20 * UM * np.cos(np.arange(9) / 2.0)


def judged(
    positive: FloatArray, negative: FloatArray, loaded: tuple[FloatArray, FloatArray]
) -> LoadingVerdict:
    """One reading per target and direction, noise 1 µm known exactly, expectations known exactly."""
    return judged_loading(
        (positive[:, None], negative[:, None]),
        np.stack(loaded),
        np.stack([INACTIVE, INACTIVE - 3 * UM]),
        None,
        UM,
        turned=True,
    )


#: A fault of measurement is 50 times less to be expected than a good measurement.
PRIOR = math.log(0.02)


def test_a_turned_sign_is_told_with_its_likelihood() -> None:
    """Deviations y that should be m: turned back nothing is left, as they stand 2 m less its mean;
    so the margin is half the sum of (2 (m - mean m) / noise)^2.
    """
    loaded = LOADED, LOADED + 6 * UM
    verdict = judged(-loaded[0], -loaded[1], loaded)
    both = np.concatenate(loaded)
    assert (verdict.verdict, verdict.of) == ("measurement", "sign")
    assert verdict.margin == pytest.approx(
        0.5 * np.sum((2 * (both - both.mean()) / UM) ** 2) + PRIOR
    )


def test_exchanged_directions_are_told_with_their_likelihood() -> None:
    """Exchanged, the reversal r = -8 µm is + 8 µm: off by 8 µm at each of 18 means."""
    loaded = LOADED, LOADED + 8 * UM
    verdict = judged(loaded[1], loaded[0], loaded)
    assert (verdict.verdict, verdict.of) == ("measurement", "direction")
    assert verdict.margin == pytest.approx(0.5 * 18 * 8.0**2 + PRIOR)


@pytest.mark.parametrize("datum", [0.0, 12 * UM, -5 * UM])
def test_what_is_left_does_not_count_the_datum(datum: float) -> None:
    """The after test repeats the state before the loading but for its zero: nothing is left."""
    loaded = LOADED, LOADED + 6 * UM
    verdict = judged(INACTIVE + datum, INACTIVE - 3 * UM + datum, loaded)
    assert verdict.verdict == "not_active"
    assert (
        "differs by 0.00 µm rms from what it would show if the control were still as before"
        in verdict.message
    )
    verdict = judged(loaded[0] + datum, loaded[1] + datum, loaded)
    assert verdict.verdict == "loaded"
    assert "differs by 0.00 µm rms from the prediction" in verdict.message


# ---------------------------------------------------------------- what was read back

NODES = np.linspace(0.0, 400.0, 9)
SHAPE = np.array([0.0, 3.0, 1.0, -2.0, 4.0, 5.5, 2.0, 7.0, 6.0]) * UM


def table(
    factor: float = 1.0, backlash: float = 0.0, positions: FloatArray = NODES, side: float = 1.0
) -> FloatArray:
    return factor * np.interp(positions, NODES, SHAPE) + (0.0 if side > 0 else backlash)


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (2.0, "radius and diameter"),
        (0.5, "radius and diameter"),
        (10.0, "ten times"),
        (0.1, "a tenth"),
        (16.0, "multiplied by 16 twice"),
        (1.0 / 16.0, "counts entered in place of 1/16 counts"),
        (25.4, "values in mm entered as inch"),
        (1.0 / 25.4, "values in inch entered as mm"),
        (1000.0, "values in µm entered as mm"),
        (0.001, "values in mm entered as µm"),
    ],
)
@pytest.mark.parametrize("backlash", [0.0, 0.003])
def test_a_factor_with_a_known_cause_is_named(factor: float, words: str, backlash: float) -> None:
    """Scaled tables of the same shape, beside a backlash that is scaled with them or not."""

    def planned(where: FloatArray, side: Direction) -> FloatArray:
        return table(positions=where, backlash=backlash, side=side.sign)

    def loaded(where: FloatArray, side: Direction) -> FloatArray:
        return table(factor, positions=where, backlash=2 * backlash, side=side.sign)

    def nothing(where: FloatArray, side: Direction) -> FloatArray:
        return np.zeros(where.shape)

    answer = judge_read_back(planned, loaded, nothing, NODES, 50.0)
    assert answer.verdict == "scaled"
    assert words in answer.message
    if not backlash:
        # the largest value of the table is 7 µm, at 350 mm
        assert answer.worst == pytest.approx(abs(factor - 1.0) * 7 * UM)
        assert answer.position == 350.0


@pytest.mark.parametrize(("sign", "name"), [(-1.0, "increment"), (1.0, "on_top")])
def test_the_existing_table_missing_or_twice_is_named(sign: float, name: str) -> None:
    def existing(where: FloatArray, side: Direction) -> FloatArray:
        return 4.0 * UM * np.sin(where / 90.0)

    def planned(where: FloatArray, side: Direction) -> FloatArray:
        return table(positions=where, side=side.sign)

    def loaded(where: FloatArray, side: Direction) -> FloatArray:
        return planned(where, side) + sign * existing(where, side)

    assert judge_read_back(planned, loaded, existing, NODES, 50.0).verdict == name


def rotary(targets: Any, seed: int) -> PositioningTest:
    rng = np.random.default_rng(seed)
    blocks = [rng.standard_normal((targets.size, 5)) / 3600.0 for _ in range(2)]
    return axis_test(targets, blocks[0], blocks[1], kind=AxisKind.ROTARY)


def test_a_full_turn_may_begin_anywhere_and_a_part_of_one_may_not() -> None:
    turn = np.linspace(0.0, 330.0, 12)
    assert proof_findings(rotary(turn + 75.0, 2), rotary(turn, 1)) == []
    part = np.linspace(0.0, 160.0, 9)
    (finding,) = proof_findings(rotary(part + 75.0, 2), rotary(part, 1))
    assert "it covers 75 deg to 235 deg" in finding.message
