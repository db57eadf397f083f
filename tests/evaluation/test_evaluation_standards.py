"""Evaluation against the standards' printed tables, real files with an independent evaluation, and
numbers worked by hand.
"""

from __future__ import annotations

import csv
from dataclasses import replace
from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from compwright.evaluation.standards import STANDARDS, evaluate
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import FloatArray
from compwright.records.result import PositioningResult
from evaluation_samples import UM, axis_test, printed_table
from one_test import read_positioning
from places import REAL, STANDARD_TABLES, needs_shared

ISO = tuple(name for name, standard in STANDARDS.items() if standard.names[0] == "A")
LATER = ("iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "gost27843:2006")


def value(result: PositioningResult, name: str) -> float:
    found = result.parameters[name]
    assert found is not None, result.not_applicable.get(name)
    return found / UM


# --- printed tables
# --------------------------------------------------------------------------------------------------

# ISO 230-2:1988, table 2, rows "mean", "s" and "greater value of ...", typed from the document.
# None: misprints of the table (one deviation of j = 4, s of j = 2 and of j = 8), each explained in
# the list that comes with the table.
MEAN_UP_1988 = (-1.92, 0.92, -4.18, None, -7.32, -3.8, -4.86, -3.74, -5.66, -4.84, -5.32)
MEAN_DOWN_1988 = (2.12, 5.4, -1.34, 2.64, -8.52, -4.6, -4.72, -4.24, -4.2, -3.46, -1.54)
S_UP_1988 = (0.746, None, 1.339, None, 0.876, 1.054, 1.226, None, 1.828, 1.973, 1.851)
S_DOWN_1988 = (0.832, 0.495, 0.76, 0.619, 0.661, 1.296, 1.028, 1.345, 1.632, 1.649, 1.388)
REVERSAL_1988 = (-4.04, -4.48, -2.84, None, 1.2, 0.8, -0.14, 0.5, -1.46, -1.38, -3.78)
R_1988 = (8.77, 8.06, 9.13, None, 5.81, 7.85, 7.36, 8.99, 11.84, 12.25, 13.49)


@needs_shared
def test_table_of_1988_target_by_target() -> None:
    columns = evaluate(
        printed_table(STANDARD_TABLES / "iso-230-2-1988-table-2.csv"), "iso230-2:1988"
    ).targets
    for printed, computed, tolerance in (
        (MEAN_UP_1988, columns.mean_positive, 0.005),  # µm; printed to 0.01
        (MEAN_DOWN_1988, columns.mean_negative, 0.005),
        (S_UP_1988, columns.s_positive, 0.001),  # printed to 0.001, the last digit partly cut off
        (S_DOWN_1988, columns.s_negative, 0.001),
        (REVERSAL_1988, columns.reversal, 0.005),
        (R_1988, columns.repeatability, 0.01),  # the print cuts off instead of rounding
    ):
        for number, mm in zip(printed, computed, strict=True):
            if number is not None:
                assert mm / UM == pytest.approx(number, abs=tolerance + 1e-9)


@needs_shared
def test_table_of_1988_axis() -> None:
    result = evaluate(
        printed_table(STANDARD_TABLES / "iso-230-2-1988-table-2.csv"), "iso230-2:1988"
    )
    assert value(result, "A") == pytest.approx(18.03, abs=0.005)  # µm; printed to 0.01
    assert value(result, "R") == pytest.approx(13.49, abs=0.01)  # cut off
    assert value(result, "R_positive") == pytest.approx(11.84, abs=0.005)
    assert value(result, "R_negative") == pytest.approx(9.9, abs=0.05)  # printed to 0.1
    assert value(result, "B_mean") == pytest.approx(-1.53, abs=0.005)
    assert result.at == {
        "R": 1500.41,
        "R_positive": 1351.56,
        "R_negative": 1351.56,
    }  # j = 11, 10, 10
    for name in ("E", "E_positive", "E_negative", "M", "B"):
        assert result.parameters[name] is None
        assert "1988" in result.not_applicable[name]
    # A applies to one direction too (2.13): limits printed in the rows mean + 3s and mean - 3s
    assert value(result, "A_positive") == pytest.approx(
        4.10 - -11.14, abs=0.1
    )  # µm; 4.10 is of j = 4, whose deviation is misprinted
    assert value(result, "A_negative") == pytest.approx(6.89 - -10.50, abs=0.01)


@needs_shared
@pytest.mark.parametrize("standard", LATER)
def test_table_of_1997(standard: str) -> None:
    result = evaluate(printed_table(STANDARD_TABLES / "iso-230-2-1997-table-2.csv"), standard)
    printed = {
        "A": 9.6,
        "A_positive": 6.1,
        "A_negative": 5.7,
        "E": 7.7,
        "E_positive": 3.9,
        "E_negative": 4.0,
        "M": 4.0,
    }
    printed |= {"R": 6.5, "R_positive": 2.9, "R_negative": 2.5, "B": 4.1, "B_mean": -3.7}
    # worked from the definitions outside this project
    worked = {
        "A": 9.586,
        "A_positive": 6.138,
        "A_negative": 5.766,
        "E": 7.70,
        "E_positive": 3.94,
        "E_negative": 4.04,
        "M": 3.99,
    }
    worked |= {"R": 6.551, "R_positive": 2.985, "R_negative": 2.552, "B": 4.12, "B_mean": -3.7109}
    for name, number in printed.items():
        assert value(result, name) == pytest.approx(number, abs=0.1)  # µm; printed and read to 0.1
        assert value(result, name) == pytest.approx(worked[name], abs=0.0006)  # µm; worked to 0.001
    assert result.at == {
        "R": 1408.462,
        "R_positive": 1580.269,
        "R_negative": 1750.92,
        "B": 175.077,
    }  # i = 9, 10, 11, 2
    assert not result.not_applicable


@needs_shared
@pytest.mark.parametrize("name", ["ess_b02_x.dat", "ess_muts_y_ild50.dat", "psi_test_fat_sat.dat"])
def test_real_files(name: str) -> None:
    folder = REAL / "positioning"
    lines = [
        line
        for line in (folder / "expected.csv").read_text("utf-8").splitlines()
        if not line.startswith("#")
    ]
    expected = next(row for row in csv.DictReader(lines) if row["dataset"] == name)
    result = evaluate(read_positioning((folder / name).read_bytes(), name))
    columns = {
        "B_avg": "B_mean",
        "E_fwd": "E_positive",
        "E_bwd": "E_negative",
        "R_fwd": "R_positive",
        "R_bwd": "R_negative",
    }
    columns |= {
        "A_fwd": "A_positive",
        "A_bwd": "A_negative",
        **{key: key for key in ("A", "E", "M", "R", "B")},
    }
    for column, parameter in columns.items():
        assert value(result, parameter) == pytest.approx(
            float(expected[column]) * 1000.0, abs=0.001
        )  # µm; printed to 0.001


# --- numbers worked by hand
# --------------------------------------------------------------------------------------------------

SMALL = axis_test([0.0, 100.0], [[1 * UM, 3 * UM], [0.0, 0.0]], [[5 * UM, 7 * UM], [0.0, 2 * UM]])
EXACT = 1e-9  # µm, rounding of binary numbers


def test_small_case_by_hand() -> None:
    # target 0: mean 2 and 6, s = sqrt 2 both; target 100: mean 0 and 1, s = 0 and sqrt 2
    result = evaluate(SMALL, "iso230-2:2006")
    r = sqrt(2.0)
    expected = {
        "A": (6 + 2 * r) - min(2 - 2 * r, 1 - 2 * r),
        "A_positive": (2 + 2 * r) - (2 - 2 * r),  # the second target lies inside
        "A_negative": (6 + 2 * r) - (1 - 2 * r),
        "E": 6.0,
        "E_positive": 2.0,
        "E_negative": 5.0,
        "M": 4 - 0.5,
        "R": 4 + 4 * r,
        "R_positive": 4 * r,
        "R_negative": 4 * r,
        "B": 4.0,
        "B_mean": -2.5,
    }
    for name, number in expected.items():
        assert value(result, name) == pytest.approx(number, abs=EXACT), name
    assert result.at["B"] == 0.0


def test_bidirectional_repeatability_is_not_the_larger_of_both_directions() -> None:
    # no reversal, one direction scatters much more: R_i = max(2s+ + 2s-, 4s+, 4s-) = 4s+
    test = axis_test([0.0, 1.0], [[0.0, 2 * UM], [0.0, 0.0]], [[1 * UM, 1 * UM], [0.0, 0.0]])
    assert value(evaluate(test), "R") == pytest.approx(4 * sqrt(2.0), abs=EXACT)
    # with a reversal of 10 µm: 2s+ + 2s- + 10
    shifted = replace(test, negative=test.negative + 10 * UM)
    assert value(evaluate(shifted), "R") == pytest.approx(2 * sqrt(2.0) + 10.0, abs=EXACT)


def test_vdi_by_hand() -> None:
    test = axis_test([0.0, 100.0], [[1 * UM, 3 * UM], [0.0, 0.0]], [[5 * UM, 7 * UM], [0.0, 0.0]])
    result = evaluate(test, "vdi3441")
    scatter = 6.0 * sqrt(2.0)  # at target 0: both s are sqrt 2; U = 4, mean 4; target 100: all zero
    expected = {
        "P": 4 + scatter,
        "Ps_max": scatter,
        "Ps_mean": scatter / 2,
        "Pa": 4.0,
        "U_max": 4.0,
        "U_mean": 2.0,
    }
    assert set(result.parameters) == set(expected)
    for name, number in expected.items():
        assert value(result, name) == pytest.approx(number, abs=EXACT), name
    assert result.at == {"Ps_max": 0.0, "U_max": 0.0}
    assert result.coverage == 3.0


def test_vdi_scatter_averages_the_directions() -> None:
    test = axis_test([0.0, 1.0], [[0.0, 2 * UM], [0.0, 0.0]], [[1 * UM, 1 * UM], [0.0, 0.0]])
    assert value(evaluate(test, "vdi3441"), "Ps_max") == pytest.approx(3 * sqrt(2.0), abs=EXACT)


def test_the_factor_is_three_in_1988_and_two_later() -> None:
    by_edition = {name: value(evaluate(SMALL, name), "R_positive") for name in ISO}
    assert by_edition.pop("iso230-2:1988") == pytest.approx(6 * sqrt(2.0), abs=EXACT)
    assert list(by_edition.values()) == pytest.approx([4 * sqrt(2.0)] * 4, abs=EXACT)


# --- the range method
# --------------------------------------------------------------------------------------------------


def spread_of(n: int) -> FloatArray:
    """One target's readings with a range of exactly 1 µm, and a second target without scatter."""
    readings = np.zeros((2, n))
    readings[0, 0] = 1 * UM
    return readings


@pytest.mark.parametrize(
    ("standard", "n", "s"),
    [
        ("iso230-2:1988", 2, 1 / 1.128),
        ("iso230-2:1988", 5, 1 / 2.326),
        ("iso230-2:1988", 10, 1 / 3.078),
        ("gost27843:2006", 5, 0.4299),
        ("gost27843:2006", 9, 0.3367),
        ("gost27843:2006", 10, 0.3249),  # the print has 0.3429; 1 / 3.078 = 0.3249
    ],
)
def test_range_method(standard: str, n: int, s: float) -> None:
    result = evaluate(axis_test([0.0, 1.0], spread_of(n), spread_of(n)), standard, spread="range")
    assert result.targets.s_positive[0] / UM == pytest.approx(s, abs=EXACT)
    assert result.spread == "range"
    assert value(result, "R_positive") == pytest.approx(2 * result.coverage * s, abs=EXACT)


@pytest.mark.parametrize(
    ("standard", "n"), [("gost27843:2006", 4), ("gost27843:2006", 11), ("iso230-2:1988", 11)]
)
def test_range_method_without_a_factor(standard: str, n: int) -> None:
    with pytest.raises(UsageError, match=f"found {n}"):
        evaluate(axis_test([0.0, 1.0], spread_of(n), spread_of(n)), standard, spread="range")


@pytest.mark.parametrize("standard", ["iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "vdi3441"])
def test_no_range_method_in_the_other_standards(standard: str) -> None:
    with pytest.raises(UsageError, match="range"):
        evaluate(SMALL, standard, spread="range")


def test_unknown_standard_lists_the_known() -> None:
    with pytest.raises(UsageError, match=r"iso230-2:1988, .*vdi3441, found din"):
        evaluate(SMALL, "din")


# --- what a test cannot give
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("standard", LATER)
def test_one_approach_per_direction(standard: str) -> None:
    test = axis_test(
        [0.0, 250.0, 500.0], [[1 * UM], [4 * UM], [2 * UM]], [[2 * UM], [6 * UM], [2 * UM]]
    )
    result = evaluate(test, standard)
    for name in ("A", "A_positive", "A_negative", "R", "R_positive", "R_negative"):
        assert result.parameters[name] is None
        assert "one approach per direction (clause" in result.not_applicable[name]
    expected = {"E": 5.0, "E_positive": 3.0, "E_negative": 4.0, "M": 3.5, "B": 2.0, "B_mean": -1.0}
    for name, number in expected.items():
        assert value(result, name) == pytest.approx(number, abs=EXACT)
    assert set(result.at) == {"B"}
    assert np.all(np.isnan(result.targets.s_positive))


def test_one_approach_per_direction_in_1988_and_vdi() -> None:
    test = axis_test([0.0, 250.0], [[1 * UM], [4 * UM]], [[2 * UM], [6 * UM]])
    first = evaluate(test, "iso230-2:1988")
    assert [name for name, number in first.parameters.items() if number is not None] == ["B_mean"]
    vdi = evaluate(test, "vdi3441")
    assert {name for name, number in vdi.parameters.items() if number is None} == {
        "P",
        "Ps_max",
        "Ps_mean",
    }
    assert value(vdi, "U_max") == pytest.approx(2.0, abs=EXACT)


@pytest.mark.parametrize("missing", ["positive", "negative"])
def test_one_direction_has_its_own_parameters_only(missing: str) -> None:
    other = {"positive": "negative", "negative": "positive"}[missing]
    readings = np.array([[0.0, 2 * UM], [4 * UM, 4 * UM]])
    nothing = np.full((2, 2), np.nan)
    test = (
        axis_test([0.0, 1.0], nothing, readings)
        if missing == "positive"
        else axis_test([0.0, 1.0], readings)
    )
    result = evaluate(test)
    present = {name for name, number in result.parameters.items() if number is not None}
    assert present == {f"A_{other}", f"E_{other}", f"R_{other}"}
    assert value(result, f"E_{other}") == pytest.approx(3.0, abs=EXACT)
    sign = {"positive": "+", "negative": "−"}[missing]
    assert result.not_applicable["A"] == f"the test was not measured in the {sign} direction"
    assert set(evaluate(test, "vdi3441").not_applicable) == {
        "P",
        "Ps_max",
        "Ps_mean",
        "Pa",
        "U_max",
        "U_mean",
    }


def test_missing_readings_count_by_target() -> None:
    full = np.array([[1.0, 2.0, 3.0, 4.0, 5.0], [1.0, 1.0, 1.0, 1.0, 1.0]]) * UM
    holed = full.copy()
    holed[0, 4] = np.nan
    result = evaluate(axis_test([0.0, 1.0], holed, full))
    assert result.targets.mean_positive[0] / UM == pytest.approx(2.5, abs=EXACT)
    assert result.targets.s_positive[0] / UM == pytest.approx(
        sqrt(5.0 / 3.0), abs=EXACT
    )  # n - 1 = 3
    assert "CW-T010" in {finding.code for finding in result.findings}
    assert None not in result.parameters.values()


def test_a_target_with_one_reading_takes_away_what_needs_s_in_its_direction() -> None:
    positive = np.array([[0.0, 2.0], [8.0, np.nan], [4.0, 4.0]]) * UM
    negative = np.array([[0.0, 2.0], [4.0, 4.0], [4.0, 4.0]]) * UM
    result = evaluate(axis_test([0.0, 10.0, 20.0], positive, negative))
    nulls = {name for name, number in result.parameters.items() if number is None}
    assert nulls == {"A", "A_positive", "R", "R_positive"}
    assert "+ direction at 10 mm" in result.not_applicable["A"]
    assert value(result, "E") == pytest.approx(
        7.0, abs=EXACT
    )  # the single reading counts as its target's mean
    assert value(result, "B") == pytest.approx(4.0, abs=EXACT)
    told = next(finding.message for finding in result.findings if finding.code == "CW-T016")
    # over the targets 0 and 20: A = (4) - (1 - 2 sqrt 2), R = 4 sqrt 2
    assert f"A {4 - (1 - 2 * sqrt(2)):.2f} µm" in told
    assert f"R {4 * sqrt(2):.2f} µm" in told


def test_a_target_without_any_reading_is_left_out_with_a_finding() -> None:
    positive = np.array([[0.0, 2.0], [np.nan, np.nan], [4.0, 4.0]]) * UM
    result = evaluate(axis_test([0.0, 10.0, 20.0], positive, positive))
    assert value(result, "E") == pytest.approx(3.0, abs=EXACT)
    assert "CW-T015" in {finding.code for finding in result.findings}


def test_a_test_without_readings_is_refused() -> None:
    with pytest.raises(InputError, match="no readings"):
        evaluate(axis_test([0.0, 1.0], [[np.nan], [np.nan]]))
    with pytest.raises(InputError, match="ascending"):
        evaluate(axis_test([1.0, 0.0], [[0.0], [0.0]]))
    with pytest.raises(InputError, match="one row"):
        evaluate(axis_test([1.0, 2.0, 3.0], [[0.0], [0.0]]))


# --- what holds for every test
# --------------------------------------------------------------------------------------------------

readings = arrays(np.float64, (4, 3), elements=st.floats(-0.05, 0.05, allow_subnormal=False))


@given(readings, readings, st.sampled_from(LATER), st.floats(-1.0, 1.0))
def test_relations_between_parameters(
    positive: FloatArray, negative: FloatArray, standard: str, datum: float
) -> None:
    test = axis_test([0.0, 10.0, 20.0, 30.0], positive, negative)
    given_ = {name: number or 0.0 for name, number in evaluate(test, standard).parameters.items()}
    slack = 1e-12  # mm, rounding
    assert given_["A"] >= given_["E"] - slack
    assert given_["A"] >= max(given_["A_positive"], given_["A_negative"], given_["R"]) - slack
    assert given_["R"] >= max(given_["R_positive"], given_["R_negative"], given_["B"]) - slack
    assert (
        given_["E"]
        >= max(given_["E_positive"], given_["E_negative"], given_["M"], given_["B"]) - slack
    )
    assert abs(given_["B_mean"]) <= given_["B"] + slack
    # the datum of the instrument is arbitrary; exchanging the directions changes the sign of the
    # reversal only
    moved = evaluate(
        replace(test, positive=positive + datum, negative=negative + datum), standard
    ).parameters
    swapped = evaluate(replace(test, positive=negative, negative=positive), standard).parameters
    for name, number in given_.items():
        assert moved[name] == pytest.approx(number, abs=1e-9)
    for name in ("A", "E", "M", "R", "B"):
        assert swapped[name] == pytest.approx(given_[name], abs=slack)
    assert swapped["B_mean"] == pytest.approx(-given_["B_mean"], abs=slack)
