"""The verdict ``thermal``: a table that acts on an axis that is longer or shorter than before."""

from __future__ import annotations

import math
import re
from collections import Counter

import numpy as np
import pytest

from compwright.records.axis import FloatArray
from compwright.records.verification import LoadingVerdict
from compwright.verification.acceptance import overall_verdict
from loadings import judged, ways_of

UM = 1e-3  # mm
PPM = 1e-6
M = 21
POSITIONS = np.linspace(-780.0, -20.0, M)
ALONG = POSITIONS - POSITIONS.mean()
RUNS = 5
NOISE = 0.5 * UM


def table_of(seed: int) -> FloatArray:
    """A correction (2, m) of 5 µm rms: waves, a slope of 10 µm/m, and 4 µm for the reversal."""
    generator = np.random.default_rng([seed, 3])
    phase = generator.uniform(0.0, 2.0 * np.pi, 2)
    long, short = (
        np.sin(2.0 * np.pi * POSITIONS / length + p)
        for length, p in zip((700.0, 300.0), phase, strict=True)
    )
    both: FloatArray = np.stack([long + short, long + short + 0.8]) * 4.0 * UM + 10.0 * PPM * ALONG
    return both


def judge(
    table: FloatArray,
    acting: FloatArray,
    seed: int,
    *,
    slope: float = 0.0,
    declared: float | None = 0.0,
) -> LoadingVerdict:
    """Before and after a table (2, m) with ``acting`` (2, m) in its place and ``slope`` (mm/mm)
    more; ``declared``: standard deviation of a slope, mm/mm.
    """
    generator = np.random.default_rng([seed, 5])
    truth = -table
    before = truth + NOISE / math.sqrt(RUNS) * generator.standard_normal((2, M))
    datum = 7 * UM
    after = (truth + acting + slope * ALONG + datum)[:, :, None] + NOISE * (
        generator.standard_normal((2, M, RUNS))
    )
    return judged(
        (after[0], after[1]),
        before + table,
        before,
        np.eye(2 * M) * NOISE**2 / RUNS,
        NOISE,
        positions=POSITIONS,
        declared=declared,
        ways=ways_of(table, (-1.0, 0.1, 0.5, 2.0), free=True),
    )


@pytest.mark.parametrize("slope", [4.0, -12.0, 60.0])
def test_a_slope_beside_a_table_that_acts_is_named_with_its_size(slope: float) -> None:
    """The standard error of a slope over 2 m means of both tests: noise · √(2/n) / |x|."""
    error = NOISE * math.sqrt(2.0 / RUNS) / np.linalg.norm(np.tile(ALONG, 2)) / PPM
    off = []
    for seed in range(40):
        table = table_of(seed)
        verdict = judge(table, table, seed, slope=slope * PPM)
        assert verdict.verdict == "thermal", verdict.message
        assert verdict.equivalent == ()
        assert verdict.slope is not None
        assert verdict.slope[1] / PPM == pytest.approx(error, rel=0.25)  # of the test's own noise
        off.append((verdict.slope[0] / PPM - slope) / error)
        assert [finding.code for finding in verdict.findings] == ["CW-V027"]
        assert (
            f"{verdict.slope[0] / PPM:+.2f} ± {verdict.slope[1] / PPM:.2f} µm/m" in verdict.message
        )
    assert np.std(off) == pytest.approx(1.0, abs=0.3)  # 40 tests: 0.11
    assert abs(np.mean(off)) < 0.6


def test_what_the_job_declares_is_no_slope_to_name() -> None:
    """Up to two standard deviations of what is declared the table is loaded; at six, thermal."""
    found = {
        times: Counter(
            judge(table_of(s), table_of(s), s, slope=times * 4 * PPM, declared=4 * PPM).verdict
            for s in range(30)
        )
        for times in (0, 1, -2, 6)
    }
    assert found[0]["loaded"] + found[1]["loaded"] + found[-2]["loaded"] == 90
    assert found[6]["thermal"] == 30


@pytest.mark.parametrize("times", [-1.5, 1.5, 2.4])
def test_what_the_job_declares_is_told_with_its_size_where_the_table_is_loaded(
    times: float,
) -> None:
    """Limits may be broken by a hall that is warmer: the reader learns it though nothing is wrong
    with the table.
    """
    verdict = judge(table_of(3), table_of(3), 3, slope=times * 20 * PPM, declared=20 * PPM)
    assert verdict.verdict == "loaded"
    told = re.search(r"rise by ([+-][\d.]+) ± ([\d.]+) µm/m more", verdict.message)
    assert told is not None
    assert float(told[1]) == pytest.approx(times * 20.0, abs=4.0 * float(told[2]))
    assert 0.05 < float(told[2]) < 1.0
    within = "within" if abs(times) <= 2.0 else "beyond"
    assert f"{within} what the job declares for two tests (± 40.0 µm/m, k = 2)" in verdict.message
    still = judge(table_of(3), table_of(3), 3, declared=20 * PPM)
    assert "rise by" not in still.message


def test_the_declared_slope_is_not_in_the_standard_error() -> None:
    table = table_of(1)
    plain = judge(table, table, 1, slope=60 * PPM)
    declared = judge(table, table, 1, slope=60 * PPM, declared=4 * PPM)
    assert plain.slope is not None
    assert declared.slope is not None
    assert declared.slope == pytest.approx(plain.slope, rel=1e-3)
    assert "± 8.0 µm/m, k = 2" in declared.message


def test_a_table_that_does_not_act_is_found_beside_a_slope() -> None:
    found: Counter[str] = Counter()
    for seed in range(30):
        verdict = judge(table_of(seed), np.zeros((2, M)), seed, slope=25 * PPM)
        found[verdict.verdict] += 1
        assert "is not active" in verdict.message
        assert verdict.slope is not None
    assert found == {"not_active": 30}


@pytest.mark.parametrize("factor", [-1.0, 0.1, 0.5, 0.85, 1.2, 2.0])
def test_a_scaled_table_is_never_thermal(factor: float) -> None:
    for seed in range(15):
        table = table_of(seed)
        named = "inverted" if factor < 0.0 else "scaled"
        assert judge(table, factor * table, seed).verdict == named
        assert judge(table, factor * table, seed, slope=20 * PPM).verdict == named


def test_other_faults_of_the_table_are_not_thermal() -> None:
    for seed in range(15):
        table = table_of(seed)
        shifted = np.roll(table, 2, axis=1)
        other = table_of(seed + 100)
        lost = table + np.array([[3.0 * UM], [0.0]])
        for acting in (shifted, other, lost):
            for slope in (0.0, 15 * PPM):
                assert judge(table, acting, seed, slope=slope).verdict == "undecided"


@pytest.mark.parametrize("slope", [-8.0, 6.0, 30.0])
def test_a_straight_line_is_thermal_and_scaled_alike(slope: float) -> None:
    """A correction of 20 µm/m acting by 1 + slope/20 of itself gives the same test, whatever the
    noise.
    """
    table = np.stack([20.0 * PPM * ALONG] * 2)
    verdict = judge(table, table, 4, slope=slope * PPM)
    assert (verdict.verdict, verdict.equivalent) == ("thermal", ("scaled",))
    scaled = judge(table, (1.0 + slope / 20.0) * table, 4)
    assert scaled.verdict == verdict.verdict
    assert "active with factor" in verdict.message


def test_a_correction_that_is_nearly_straight_leaves_it_open() -> None:
    """0.2 µm beside the line: more than the same within one standard error, too little to tell."""
    bend = 0.2 * UM * np.cos(2.0 * np.pi * POSITIONS / 760.0)
    table = np.stack([20.0 * PPM * ALONG + bend] * 2)
    verdict = judge(table, table, 4, slope=10 * PPM)
    assert verdict.verdict == "undecided"
    assert {each.verdict for each in verdict.candidates[:2]} == {"thermal", "scaled"}


def test_angles_have_no_temperature() -> None:
    table = table_of(2)
    verdict = judge(table, table, 2, slope=30 * PPM, declared=None)
    assert (verdict.verdict, verdict.slope) == ("undecided", None)


def test_thermal_is_neither_good_nor_bad() -> None:
    assert overall_verdict(["accept"], ["loaded", "thermal"]) == "undecided"
    assert overall_verdict([], ["thermal"]) == "undecided"
    assert overall_verdict(["reject"], ["thermal"]) == "bad"
    assert overall_verdict(["accept"], ["not_active", "thermal"]) == "bad"
