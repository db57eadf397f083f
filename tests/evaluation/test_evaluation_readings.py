"""Findings about the readings: drift, suspect traverses and readings, zeros; by injection and by
rates of false alarm.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from compwright.evaluation.reading_checks import (
    drift_findings,
    reading_findings,
    suspect_reading_findings,
    suspect_traverse_findings,
)
from compwright.evaluation.standards import evaluate
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest
from evaluation_samples import UM, axis_test, noisy, printed_table
from one_test import read_positioning
from places import REAL, STANDARD_TABLES, needs_shared


def no_comparison(_: PositioningTest) -> None:
    return None


def share(found: list[bool]) -> float:
    return sum(found) / len(found)


# --- drift
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("common", [0.0, 0.5, 0.97])
def test_drift_is_rarely_seen_where_there_is_none(common: float) -> None:
    """Also when whole runs shift together in random order: the permutation test allows 1/60; 200
    tests, three standard errors.
    """
    found = [
        bool(drift_findings(noisy(np.random.default_rng(seed), common=common)))
        for seed in range(200)
    ]
    assert share(found) <= 1 / 60 + 3 * np.sqrt(1 / 60 / 200)


def test_drift_is_found() -> None:
    """Four standard deviations of a reading over five runs, 11 targets: nearly always; run numbers
    are the order of time.
    """
    found = [
        bool(drift_findings(noisy(np.random.default_rng(seed), drift=4.0))) for seed in range(100)
    ]
    assert share(found) >= 0.97
    found = [
        bool(drift_findings(noisy(np.random.default_rng(seed), drift=-2.0, runs=8)))
        for seed in range(100)
    ]
    assert share(found) >= 0.9


def test_the_size_of_the_drift_is_told_with_its_sign() -> None:
    finding = drift_findings(noisy(np.random.default_rng(1), drift=-8.0, s=0.5))[0]
    sizes = [float(number) for number in re.findall(r"(-[0-9.]+) µm in [+−]", finding.message)]
    assert sizes == pytest.approx(
        [-8.0, -8.0], abs=0.7
    )  # µm; se of the slope 0.5 * 4 / sqrt(10 * 11) = 0.19, clipping adds a little
    assert "1.7 %" in finding.message  # 2 of the 120 orders of five runs


def test_opposite_drift_in_the_two_directions_is_found() -> None:
    test = noisy(np.random.default_rng(4), s=0.5)
    ramp = np.linspace(0.0, 6.0, 5) * UM
    assert drift_findings(
        replace(test, positive=test.positive + ramp, negative=test.negative - ramp)
    )


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_expansion_that_cancels_in_the_mean_is_found(sign: float) -> None:
    """Six µm more at the upper end and six less at the lower one: every target progresses in order
    (clause 3.3), the mean over the targets does not move.
    """
    test = noisy(np.random.default_rng(4), s=0.5)
    along = np.linspace(-1.0, 1.0, test.targets.size)[:, np.newaxis]
    growing = sign * 6.0 * UM * along * np.linspace(0.0, 1.0, 5)
    found = drift_findings(
        replace(test, positive=test.positive + growing, negative=test.negative + growing)
    )
    ends = [float(each) for each in re.findall(r"([+-][0-9.]+) µm", found[0].message)]
    # Standard error at an end: 0.5 * 4 / sqrt(10 * 11) * 2 = 0.38 µm; clipping adds a little.
    assert ends == pytest.approx([-sign * 6.0, sign * 6.0] * 2, abs=1.2)


def test_expansion_in_random_order_of_the_runs_is_no_drift() -> None:
    """Runs that are tilted each on its own: one order in sixty; 200 tests, three standard
    errors.
    """
    found = []
    for seed in range(200):
        rng = np.random.default_rng(seed)
        test = noisy(rng)
        tilts = np.linspace(-1.0, 1.0, test.targets.size)[:, np.newaxis] * rng.normal(0, 3 * UM, 5)
        tilted = replace(test, positive=test.positive + tilts, negative=test.negative + tilts)
        found.append(bool(drift_findings(tilted)))
    assert share(found) <= 1 / 60 + 3 * np.sqrt(1 / 60 / 200)


def test_drift_in_one_direction_of_a_one_directional_test() -> None:
    test = noisy(np.random.default_rng(4), s=0.5, drift=6.0)
    assert drift_findings(replace(test, negative=np.empty((test.targets.size, 0))))
    assert drift_findings(replace(test, positive=np.full(test.positive.shape, np.nan)))


def test_no_drift_from_four_runs_or_in_the_step_cycle() -> None:
    assert not drift_findings(noisy(np.random.default_rng(0), runs=4, drift=20.0))
    assert not drift_findings(replace(noisy(np.random.default_rng(0), drift=20.0), cycle="step"))


def test_one_bad_reading_does_not_hide_a_drift() -> None:
    test = noisy(np.random.default_rng(3), s=0.5, drift=6.0)
    spoilt = test.positive.copy()
    spoilt[4, 0] += 200.0 * UM
    assert drift_findings(replace(test, positive=spoilt))


@needs_shared
def test_drift_of_the_printed_tables() -> None:
    """The 1988 example warms up (-8.2, -5.9, -6.3, -4.5, -3.4 at 1 201.9 mm); that of 1997 shifts
    as a whole, in no order.
    """
    found = {
        edition: drift_findings(printed_table(STANDARD_TABLES / f"iso-230-2-{edition}-table-2.csv"))
        for edition in ("1988", "1997")
    }
    assert len(found["1988"]) == 1
    assert found["1997"] == []


# --- suspects
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("common", [0.0, 0.5, 0.97])
def test_sound_tests_are_rarely_suspect(common: float) -> None:
    tests = [noisy(np.random.default_rng(seed), common=common) for seed in range(200)]
    assert share([bool(suspect_traverse_findings(test, no_comparison)) for test in tests]) <= 0.03
    assert share([bool(suspect_reading_findings(test, no_comparison)) for test in tests]) <= 0.01


@needs_shared
def test_printed_and_real_tests_are_not_suspect() -> None:
    tests = [printed_table(path) for path in sorted(STANDARD_TABLES.glob("*.csv"))]
    tests += [
        read_positioning(path.read_bytes(), path.name)
        for path in sorted((REAL / "positioning").glob("*.dat"))
    ]
    assert len(tests) == 5
    for test in tests:
        assert not suspect_traverse_findings(test, no_comparison)
        assert not suspect_reading_findings(test, no_comparison)


def test_a_shifted_traverse_is_found_and_named() -> None:
    found = []
    for seed in range(50):
        test = noisy(np.random.default_rng(seed))
        shifted = test.negative.copy()
        shifted[:, 3] -= 10.0 * UM
        findings = suspect_traverse_findings(replace(test, negative=shifted), no_comparison)
        found.append(
            len(findings) == 1
            and (findings[0].values["run"], findings[0].values["direction"]) == (4, "−")
            and findings[0].values["off"].value < 0.0
        )
    assert share(found) >= 0.95


def test_a_run_off_in_both_directions_is_one_finding_shown_without_both() -> None:
    """One run of five off by eight standard deviations of a reading scatters every target: it is
    held against the other runs, and what is compared is the test without it.
    """
    compared: list[PositioningTest] = []

    def kept(test: PositioningTest) -> None:
        compared.append(test)

    found = []
    for seed in range(50):
        test = noisy(np.random.default_rng(seed))
        up, down = test.positive.copy(), test.negative.copy()
        up[:, 2] += 8.0 * UM
        down[:, 2] += 8.0 * UM
        findings = suspect_traverse_findings(replace(test, positive=up, negative=down), kept)
        found.append(
            len(findings) == 1
            and findings[0].sentence.name == "CW-T013.run"
            and findings[0].values["run"] == 3
            and findings[0].sentence.outside()["off"][0]["value"]["value"] > 0.0
        )
    assert share(found) >= 0.95
    for left in compared:
        for block in (left.positive, left.negative):
            assert np.isnan(block).any(axis=0).tolist() == [False, False, True, False, False]


def test_a_three_s_rule_could_not_see_it() -> None:
    """One of five readings 1 000 s off lies 4/sqrt(5) = 1.789 s from the mean of the five; the
    pooled rule sees it.
    """
    test = noisy(np.random.default_rng(9))
    spoilt = test.positive.copy()
    spoilt[2, 1] += 1000.0 * UM
    row = spoilt[2]
    assert np.abs(row - row.mean()).max() / row.std(ddof=1) < 1.7889
    findings = suspect_reading_findings(replace(test, positive=spoilt), no_comparison)
    assert len(findings) == 1
    assert (
        f"run 2 in + at {test.targets[2]:.10g} mm (+100" in findings[0].message
        or "run 2 in + at" in findings[0].message
    )


def test_the_result_with_and_without_a_suspect_is_told_and_nothing_is_dropped() -> None:
    sound = noisy(np.random.default_rng(11))
    spoilt = sound.positive.copy()
    spoilt[5, 2] += 60.0 * UM
    removed = spoilt.copy()
    removed[5, 2] = np.nan
    result = evaluate(replace(sound, positive=spoilt))
    without = evaluate(replace(sound, positive=removed))
    message = next(finding.message for finding in result.findings if finding.code == "CW-T014")
    for name in ("A", "R"):
        assert (
            f"{name}: {(result.parameters[name] or 0) / UM:.2f} µm with these readings,"
            f" {(without.parameters[name] or 0) / UM:.2f} µm without them" in message
        )
    assert (result.parameters["A"] or 0) > 60.0 * UM


def test_coarse_readings_are_not_suspect() -> None:
    """Readings in steps of 1 µm that nearly always repeat: a single last digit is no reason to
    suspect anything.
    """
    steps = np.zeros((11, 5))
    steps[3, 2] = steps[5, 4] = steps[8, 0] = 1.0
    steps[10] = [0.0, 1.0, 2.0, 1.0, 3.0]  # one target scatters, so the scale is not zero
    test = axis_test(np.arange(11) * 37.0, steps * UM, np.zeros((11, 5)))
    assert not suspect_reading_findings(test, no_comparison)
    assert not suspect_traverse_findings(test, no_comparison)


# --- zeros and missing
# --------------------------------------------------------------------------------------------------


def test_a_traverse_of_zeros_is_told_once() -> None:
    test = noisy(np.random.default_rng(2))
    zeros = test.positive.copy()
    zeros[:, 1] = 0.0
    findings = [
        finding
        for finding in reading_findings(replace(test, positive=zeros), no_comparison)
        if finding.code == "CW-T011"
    ]
    assert [finding.message[:21] for finding in findings] == ["Run 2 in direction + "]
    assert not [f for f in reading_findings(test, no_comparison) if f.code == "CW-T011"]


def test_the_longest_row_of_zeros_is_counted() -> None:
    """Four targets side by side and two more apart were filled up."""
    test = noisy(np.random.default_rng(2))
    zeros = test.positive.copy()
    zeros[[1, 2, 3, 4, 7, 8], 1] = 0.0
    (found,) = [
        finding.message
        for finding in reading_findings(replace(test, positive=zeros), no_comparison)
        if finding.code == "CW-T011"
    ]
    assert found.startswith("In traverse 2 in +, up to 4 neighbouring targets")


def test_run_numbers_of_the_file_are_used() -> None:
    test = replace(noisy(np.random.default_rng(2)), runs_positive=(1, 2, 3, 4, 7))
    zeros = test.positive.copy()
    zeros[:, 4] = 0.0
    findings = [
        finding.message
        for finding in reading_findings(replace(test, positive=zeros), no_comparison)
        if finding.code == "CW-T011"
    ]
    assert findings[0].startswith("Run 7 in direction + ")


def test_rotary_findings_speak_of_arcsec() -> None:
    targets = np.sort(np.concatenate([np.arange(0.0, 360.0, 45.0), [22.0, 100.0, 200.0]]))
    readings = np.random.default_rng(1).normal(size=(2, 11, 5)) / 3600.0
    readings[0, :, 0] += 30.0 / 3600.0
    test = axis_test(targets, readings[0], readings[1], kind=AxisKind.ROTARY)
    finding = next(each for each in evaluate(test).findings if each.code == "CW-T013")
    off = finding.sentence.outside()["off"]
    assert off["unit"] == "arcsec"
    assert off["value"] == pytest.approx(
        30.0, abs=2.0
    )  # the median of 11 targets scatters by 0.4, that of four runs by 0.6
