"""Plain CSV positioning files: numbers against printed tables, and one small file for each fault an
engineer can make.
"""

from __future__ import annotations

import hashlib

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.records.axis import AxisKind, Direction
from compwright.records.positioning import PositioningTest
from next_steps import without_hint
from one_test import read_positioning
from places import STANDARD_TABLES, needs_shared

LONG = "target_mm,direction,run,deviation_um\n"
#: Three targets, two directions, two runs; deviations in um are 10 * index + run, minus 5 in
#: direction -, with .5 behind.
COMPLETE = LONG + "".join(
    f"{100 * index}.0,{sign},{run},{10 * index + run - (5 if sign == '-' else 0)}.5\n"
    for index in range(3)
    for sign in "+-"
    for run in (1, 2)
)


def read(text: str, file: str = "runs/x_before.csv") -> PositioningTest:
    return read_positioning(text.encode(), file)


def faults(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        read(text)
    assert caught.value.exit_code == 3
    return [without_hint(line) for line in str(caught.value).split("\n")]


def one_fault(text: str) -> str:
    lines = faults(text)
    assert len(lines) == 1, lines
    return lines[0]


def codes(test: PositioningTest) -> set[str]:
    return {finding.code for finding in test.findings}


def message(test: PositioningTest, code: str) -> str:
    (finding,) = [finding for finding in test.findings if finding.code == code]
    return finding.message


# ----------------------------------------------------------------------------------------------
# numbers from outside


@needs_shared
def test_printed_table_of_1988() -> None:
    path = STANDARD_TABLES / "iso-230-2-1988-table-2.csv"
    content = path.read_bytes()
    test = read_positioning(content, "a/iso-230-2-1988-table-2.csv")
    assert (test.name, test.axis, test.kind, test.frame) == (
        "iso-230-2-1988-table-2",
        "X",
        AxisKind.LINEAR,
        "instrument",
    )
    assert test.positive.shape == test.negative.shape == (11, 5)
    assert np.isfinite(test.positive).sum() + np.isfinite(test.negative).sum() == 110
    # First row of the printed table: -2.6 -1.6 -2.7 -1.8 -0.9 um upward, 2.3 1.1 3.2 2.5 1.5 um
    # downward, at 0.000 mm.
    np.testing.assert_allclose(
        test.positive[0] * 1000, [-2.6, -1.6, -2.7, -1.8, -0.9], atol=1e-12
    )  # um, exact but for binary
    np.testing.assert_allclose(test.negative[0] * 1000, [2.3, 1.1, 3.2, 2.5, 1.5], atol=1e-12)
    assert test.targets[1] == 150.710
    # Printed mean reversal value -1.53 um, computed -1.5291 (expected.md, four decimals).
    reversal = (test.positive.mean(axis=1) - test.negative.mean(axis=1)).mean() * 1000
    assert reversal == pytest.approx(-1.5291, abs=0.5e-4)  # um, half of the last digit
    assert test.sources[0].sha256 == hashlib.sha256(content).hexdigest()
    assert test.sources[0].file == "a/iso-230-2-1988-table-2.csv"
    assert test.header["source"] == "ISO 230-2:1988, Table 2, typed from the document"


@needs_shared
def test_printed_table_of_1997() -> None:
    test = read_positioning((STANDARD_TABLES / "iso-230-2-1997-table-2.csv").read_bytes(), "t.csv")
    up, down = test.positive.mean(axis=1) * 1000, test.negative.mean(axis=1) * 1000  # um
    assert test.positive.size + test.negative.size == 110
    # expected.md: mean reversal -3.7109, M 3.99, E 7.70, E down 4.04, E up 3.94 um; half of the
    # last digit each.
    assert (up - down).mean() == pytest.approx(-3.7109, abs=0.5e-4)
    assert np.ptp((up + down) / 2) == pytest.approx(3.99, abs=0.5e-2)
    assert np.ptp(np.concatenate([up, down])) == pytest.approx(7.70, abs=0.5e-2)
    assert np.ptp(down) == pytest.approx(4.04, abs=0.5e-2)
    assert np.ptp(up) == pytest.approx(3.94, abs=0.5e-2)
    assert "CW-R006" not in codes(test)


# ------------------------------------------------------------------------------------------------------- what is read


def test_long_form_places_every_reading() -> None:
    test = read(COMPLETE)
    np.testing.assert_array_equal(test.targets, [0.0, 100.0, 200.0])
    # um to mm: the last digit of a double at 20 um
    np.testing.assert_allclose(
        test.positive * 1000, [[1.5, 2.5], [11.5, 12.5], [21.5, 22.5]], atol=1e-12
    )
    np.testing.assert_allclose(
        test.negative * 1000, [[-4.5, -3.5], [6.5, 7.5], [16.5, 17.5]], atol=1e-12
    )
    assert test.runs_positive == test.runs_negative == (1, 2)
    assert test.name == "x_before"


def test_order_of_rows_and_columns_does_not_matter() -> None:
    header, *rows = COMPLETE.splitlines()
    turned = [",".join(reversed(row.split(","))) for row in (header, *reversed(rows))]
    other = read("\n".join(turned))
    np.testing.assert_array_equal(other.positive, read(COMPLETE).positive)
    np.testing.assert_array_equal(other.negative, read(COMPLETE).negative)


@pytest.mark.parametrize(
    ("header", "cells", "expected"),
    [
        ("target_mm,direction,run,deviation_um", "100.5,+,1,-2.5", -0.0025),
        ("target_mm,direction,run,deviation_mm", "100.5,+,1,-0.0025", -0.0025),
        ("target_mm,direction,run,measured_mm", "100.5,+,1,100.4975", -0.0025),
        (
            "target_deg,direction,run,deviation_arcsec",
            "90.5,+,1,-9.0",
            -0.0025,
        ),  # 9 arcsec = 9/3600 deg
        ("target_deg,direction,run,deviation_deg", "90.5,+,1,-0.0025", -0.0025),
        ("target_deg,direction,run,measured_deg", "90.5,+,1,90.4975", -0.0025),
    ],
)
def test_value_columns_and_units(header: str, cells: str, expected: float) -> None:
    test = read(f"{header}\n{cells}\n")
    # mm or deg: 1e-13 is the last digit of a double at 100
    assert test.positive[0, 0] == pytest.approx(expected, abs=1e-13)
    assert test.kind is (AxisKind.LINEAR if "mm" in header.partition(",")[0] else AxisKind.ROTARY)
    assert ("CW-R003" in codes(test)) == ("measured" in header)


def test_sign_key_turns_deviations_but_not_measured_values() -> None:
    assert (
        read("# deviation: target minus measured\n" + LONG + "0,+,1,2.5").positive[0, 0] == -0.0025
    )
    assert (
        read("# Deviation: Measured  minus target\n" + LONG + "0,+,1,2.5").positive[0, 0] == 0.0025
    )
    measured = read(
        "# deviation: target minus measured\ntarget_mm,direction,run,measured_mm\n0,+,1,0.0025"
    )
    assert measured.positive[0, 0] == 0.0025
    assert "CW-R013" in codes(measured)
    unsaid = read("target_mm,direction,run,measured_mm\n0,+,1,0.0025")
    assert (
        message(unsaid, "CW-R001")
        == "The file does not state the following, so it was assumed: cycle: standard."
    )


def test_wide_form_with_an_empty_cell() -> None:
    text = "# unit: um\n# axis: Y\ntarget_mm;+1;-1;+2;-2\n0,5;1,5;-1;2,5;-2\n100,5;;-3;4;-4\n"
    test = read(text)
    np.testing.assert_allclose(test.positive * 1000, [[1.5, 2.5], [np.nan, 4.0]], atol=1e-12)  # um
    np.testing.assert_allclose(test.negative * 1000, [[-1.0, -2.0], [-3.0, -4.0]], atol=1e-12)
    assert message(test, "CW-R006") == "1 of 8 readings are missing: 100.5 mm in run +1."


def test_wide_form_rotary_and_sign() -> None:
    test = read(
        "# unit: arcsec\n# deviation: target minus measured\ntarget_deg,-1,+1\n0.0,3.6,7.2\n"
    )
    assert test.kind is AxisKind.ROTARY
    assert test.positive[0, 0] == pytest.approx(-0.002, abs=1e-15)  # deg
    assert test.negative[0, 0] == pytest.approx(-0.001, abs=1e-15)


@pytest.mark.parametrize("unit", ["um", "µm", "μm", "UM"])
def test_spellings_of_the_micrometre(unit: str) -> None:
    assert read(f"# unit: {unit}\ntarget_mm,+1\n0.5,3\n").positive[0, 0] == pytest.approx(
        0.003, abs=1e-15
    )  # mm


def test_what_spreadsheets_do_to_a_file() -> None:
    plain = read("# axis: X\n# note: a, b\n" + COMPLETE)
    header, *rows = COMPLETE.splitlines()
    quoted = [
        ";".join(f' "{cell.replace(".", ",")}" ' for cell in row.split(",")) + ";" for row in rows
    ]
    lines = [
        "# axis: X;;;;",
        '"# note: a, b";;;;',
        header.replace(",", " ; ") + ";",
        *quoted,
        ";;;;",
        "",
    ]
    twice_marked = "\ufeff" + "\n".join(lines)
    for content in (
        twice_marked.encode("utf-8-sig"),
        "\r\n".join(lines).encode("utf-8-sig"),
        "\r".join(lines).encode("utf-16"),
    ):
        other = read_positioning(content, "runs/x_before.csv")
        np.testing.assert_array_equal(other.positive, plain.positive)
        np.testing.assert_array_equal(other.negative, plain.negative)
        assert other.header == plain.header == {"axis": "X", "note": "a, b"}
        assert other.findings == plain.findings


def test_comment_lines_are_kept() -> None:
    text = (
        "# Machine: VMC: 850\n# first line\n# see http://x.y/z\n# Serial: 7\n# Air temp: 20.1\n#"
        " Air temp: 20.3\n#\n# cycle: Step\n"
    )
    test = read(text + COMPLETE + "# last line\n")
    assert test.header == {
        "machine": "VMC: 850",
        "comment": "first line\nsee http://x.y/z\nlast line",
        "serial": "7",
        "Air temp": "20.1\n20.3",
        "cycle": "Step",
    }
    assert test.cycle == "step"
    assert (
        message(test, "CW-R001")
        == "The file does not state the following, so it was assumed: deviation: measured minus target."
    )


def test_a_sign_below_the_rows_counts_too() -> None:
    assert read(LONG + "0,+,1,2.5\n# deviation: target minus measured\n").positive[0, 0] == -0.0025


def test_typographic_minus_is_a_minus() -> None:
    test = read(LONG + "0,−,1,−2.5\n")
    assert test.negative[0, 0] == -0.0025
    assert test.positive.shape == (1, 0)


def test_one_direction_and_gaps_in_the_run_numbers() -> None:
    test = read(LONG + "0,-,3,1.5\n50,-,3,1\n0,-,1,2\n50,-,1,2\n")
    assert test.runs_negative == (1, 3)
    np.testing.assert_allclose(test.negative[0] * 1000, [2.0, 1.5], atol=1e-12)  # um
    assert test.deviations(Direction.POSITIVE).shape == (2, 0)
    assert not test.bidirectional


# ---------------------------------------------------------------------------------------------------------- findings


def test_what_is_not_said_is_told() -> None:
    assert message(read(COMPLETE), "CW-R001").endswith(
        "deviation: measured minus target; cycle: standard."
    )
    assert "CW-R002" in codes(read(COMPLETE))
    said = read("# axis: X\n# cycle: standard\n# deviation: measured minus target\n" + COMPLETE)
    assert codes(said) == set()


def test_compensated_for_and_extra_columns() -> None:
    test = read(
        "# compensated for: air"
        " temperature\ntarget_mm,direction,run,deviation_um,time,Note\n0.5,+,1,1,12:00,\n"
    )
    assert test.header["compensated_for"] == "air temperature"
    assert "air temperature" in message(test, "CW-R004")
    assert message(test, "CW-R005") == "These columns were left out: note."
    assert "CW-R004" not in codes(read("# compensated_for: none\n" + COMPLETE))


@pytest.mark.parametrize("name", ["tiem", "Time [s]", "timestamp"])
def test_a_misspelt_column_of_times(name: str) -> None:
    test = read(f"target_mm,direction,run,deviation_um,{name},note\n0.5,+,1,1,12:00,a\n")
    left = " ".join(name.lower().split())
    assert message(test, "CW-R005") == (
        f"These columns were left out: {left}, note. If {left} is the column time, rename it."
    )


def test_no_second_column_of_times_is_suggested() -> None:
    test = read(
        "target_mm,direction,run,deviation_um,time,timestamp\n0.5,+,1,1,2026-11-27T12:00:00,1\n"
    )
    assert message(test, "CW-R005").endswith("left out: timestamp.")


def test_deviation_beyond_a_millimetre() -> None:
    test = read(COMPLETE.replace("deviation_um", "deviation_mm"))
    # 10 * 2 + 2 + 0.5 = 22.5 is the largest of the twelve, and -4.5 to 22.5 are all beyond 1 mm.
    assert (
        message(test, "CW-R008")
        == "12 of 12 deviations are larger than 1 mm. The largest is 22.5 mm, at target 200 mm. Check"
        " the unit."
    )
    assert "CW-R008" not in codes(read(LONG + "0.5,+,1,1000\n"))  # exactly 1 mm is not larger
    assert "after 360 deg" in message(
        read("target_deg,direction,run,measured_deg\n0.0,+,1,359.99\n90,+,1,90.01\n"), "CW-R008"
    )


def test_deviations_below_the_resolution_of_any_instrument() -> None:
    assert "CW-R009" in codes(read(LONG + "0.5,+,1,0.0009\n1,+,1,-0.0005\n"))
    assert "CW-R009" not in codes(read(LONG + "0.5,+,1,0.001\n1,+,1,-0.0005\n"))


def test_a_traverse_of_zeros() -> None:
    test = read("# unit: um\ntarget_mm,+1,-1,+2,-2\n0.5,1,2,1,0\n10,1,2,0,0\n20,1,2,1,0\n")
    assert message(test, "CW-R010").startswith(
        "Every deviation of run -2 is exactly zero, while others are not"
    )
    assert "CW-R010" not in codes(
        read("# unit: um\ntarget_mm,+1,-1\n0.5,0,0\n10,0,0\n")
    )  # all zero: CW-R009 says so
    assert "CW-R010" not in codes(
        read(LONG + "0.5,+,1,2\n10,+,1,3\n0.5,+,2,0\n")
    )  # one zero is a reading, not a traverse


def test_measured_positions_in_a_deviation_column() -> None:
    text = "target_mm,direction,run,deviation_mm\n" + "".join(
        f"{t},+,1,{t}.002\n" for t in range(0, 500, 50)
    )
    assert codes(read(text)) >= {"CW-R011"}
    assert "CW-R008" not in codes(read(text))
    assert "CW-R011" not in codes(read(text.replace("deviation_mm", "measured_mm")))


def test_targets_almost_the_same_in_one_direction() -> None:
    rows = "".join(
        f"{t},+,{r},1.5\n" for t in (0, 50, 100, 150) for r in (1, 2) if (t, r) != (100, 2)
    )
    assert "100 and 100.01 mm" in message(read(LONG + rows + "100.010,+,2,1.5\n"), "CW-R012")
    assert "CW-R012" not in codes(read(LONG + rows + "100,+,2,1.5\n"))
    near = "100.010,+,1,1.5\n100.010,+,2,1.5\n"  # run 1 has both: two targets, however near
    assert "CW-R012" not in codes(read(LONG + rows + near))


def test_different_numbers_of_traverses() -> None:
    test = read(LONG + "0.5,+,1,1\n0.5,+,2,1\n0.5,-,1,1\n")
    assert message(test, "CW-R007").startswith(
        "There are 2 runs in direction + but 1 in direction −. "
    )


# ------------------------------------------------------------------------------------------------------------ faults


def test_a_text_value_is_named_with_line_and_column() -> None:
    rows = COMPLETE.splitlines()
    rows[8] = rows[8].rpartition(",")[0] + ",out of beam"
    assert (
        one_fault("\n".join(rows))
        == "runs/x_before.csv: line 9, column deviation_um is not a number; expected a number, or"
        " no row for a reading that was not made, found 'out of beam'"
    )


@pytest.mark.parametrize(
    "value", ["nan", "NaN", "inf", "-Infinity", "#NUM!", "1.#INF", "1e10", "1e999"]
)
def test_what_is_not_finite(value: str) -> None:
    line = one_fault(COMPLETE + f"300,+,1,{value}\n")
    assert "line 14, column deviation_um" in line
    assert ("too large" in line) == value.startswith("1e")


@pytest.mark.parametrize(
    "value", ["1_000", "0x10", "1.2.3", "٣", "1 2", "--1", "1e", "e5", ".", "5um"]
)
def test_what_is_not_a_number(value: str) -> None:
    assert "line 2, column deviation_um is not a number" in one_fault(LONG + f"0.5,+,1,{value}\n")


def test_an_empty_cell_in_the_long_form() -> None:
    line = one_fault(COMPLETE + "300,+,1,\n")
    assert "line 14, column deviation_um is empty" in line
    assert "no row" in line


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        (
            LONG.replace(",", ";") + "0,5;+;1;1,5\n50,5;+;1;1.5\n",
            "line 3, column deviation_um",
            "decimal marks are mixed",
        ),
        (
            LONG + '0.5,+,1,"1,5"\n',
            "line 2, column deviation_um",
            "the comma is the delimiter and the decimal mark at once",
        ),
        (
            LONG.replace(",", ";") + "1,250;+;1;5\n",
            "line 2, column target_mm",
            "a number with thousands marks",
        ),
        (
            LONG.replace(",", ";") + "1.250,5;+;1;5\n",
            "line 2, column target_mm",
            "has thousands marks",
        ),
        (
            LONG.replace(",", ";") + "1'250.5;+;1;5\n",
            "line 2, column target_mm",
            "has thousands marks",
        ),
        (
            LONG.replace(",", ";") + "1 250.5;+;1;5\n",
            "line 2, column target_mm",
            "has thousands marks",
        ),
    ],
)
def test_decimal_and_thousands_marks(text: str, place: str, words: str) -> None:
    line = one_fault(text)
    assert place in line
    assert words in line


def test_one_number_proves_the_decimal_comma() -> None:
    test = read(LONG.replace(",", ";") + "1,250;+;1;5\n0,500;+;1;5\n")
    np.testing.assert_array_equal(test.targets, [0.5, 1.25])


def test_a_point_that_may_mark_thousands_is_told() -> None:
    assert "'1.250' was read with a decimal point" in message(
        read(LONG + "750,+,1,5\n1.250,+,1,5\n"), "CW-R015"
    )
    assert "CW-R015" not in codes(read(LONG + "750,+,1,5\n1.250,+,1,5.5\n"))
    assert "CW-R015" not in codes(
        read(LONG + "100.000,+,1,5\n200.000,+,1,5\n")
    )  # how instruments print
    # every reading has a point: as thousands they were 6076 µm and 5810 µm, none below 1000
    rows = "6,+,1,6.076\n20.896,+,1,5.810\n494,+,1,6.632\n"
    assert "CW-R015" not in codes(read(LONG + rows))
    assert "'20.896' was read" in message(read(LONG + rows.replace("6.632", "7")), "CW-R015")


def test_decimal_comma_with_comma_as_delimiter() -> None:
    line = one_fault(LONG + "0,5,+,1,2,5\n")
    assert "line 2: the row has fewer or more cells than the header row; expected 4 cells" in line
    assert "found 6 (a decimal comma cannot be used where the comma is the delimiter)" in line


def test_rows_with_fewer_or_more_cells() -> None:
    lines = faults(COMPLETE + "300,+,1\n300,+,1,2,hot\n")
    assert [line.split(": ")[1] for line in lines] == ["line 14", "line 15"]
    assert lines[0].endswith("expected 4 cells with the comma as delimiter, found 3")
    assert lines[1].endswith("found 5")


@pytest.mark.parametrize("missing", ["target_mm", "direction", "run", "deviation_um"])
def test_a_missing_column(missing: str) -> None:
    text = one_fault(LONG.replace(missing, "other") + "0,+,1,1\n")
    assert "line 1" in text
    assert {"target_mm": "target column", "deviation_um": "value column"}.get(
        missing, f"column '{missing}'"
    ) in text


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "target_mm,direction,run,deviation_arcsec\n0,+,1,1\n",
            "one is a length, the other an angle",
        ),
        ("target_deg,direction,run,measured_mm\n0,+,1,1\n", "one is a length, the other an angle"),
        ("# unit: deg\ntarget_mm,+1\n0,1\n", "one is a length, the other an angle"),
        ("# unit: um\ntarget_deg,+1\n0,1\n", "one is a length, the other an angle"),
        (
            "# unit: thou\ntarget_mm,+1\n0,1\n",
            "key 'unit' names an unknown unit; expected um, mm, arcsec or deg, found 'thou'",
        ),
        ("target_mm,+1\n0,1\n", "key 'unit' is missing"),
        ("target_mm,target_deg,direction,run,deviation_um\n0,0,+,1,1\n", "two target columns"),
        (
            "target_mm,direction,run,deviation_um,deviation_mm\n0,+,1,1,0.001\n",
            "more than one value column",
        ),
        ("target_mm,direction,run,run,deviation_um\n0,+,1,1,1\n", "a column is given twice"),
        (
            "# unit: um\ntarget_mm,1,2\n0,1,1\n",
            "the names of traverse columns do not show direction and run",
        ),
        (
            "# unit: um\ntarget_mm,+1,-0\n0,1,1\n",
            "the names of traverse columns do not show direction and run",
        ),
        ("# unit: um\ntarget_mm,+1,+1\n0,1,1\n", "a column is given twice"),
        (
            "# unit: um\ntarget_mm,+1,-1\n0,1,1\n0.0,2,2\n",
            "line 4, column target_mm: a target is given twice",
        ),
        (
            "# unit: um\ntarget_mm,+1,direction\n0,1,+\n",
            "mixes two forms of table; expected either direction, run",
        ),
        (
            LONG + "0,*,1,1\n",
            "line 2, column direction: direction is neither + nor -; expected + or -, found '*'",
        ),
        (LONG + "0,,1,1\n", "direction is neither + nor -"),
        (LONG + "0,+,0,1\n", "line 2, column run: run is not a whole number of at least 1"),
        (LONG + "0,+,-1,1\n", "run is not a whole number of at least 1"),
        (LONG + "0,+,1.5,1\n", "run is not a whole number of at least 1"),
        (
            "# cycle: pilgrim\n" + LONG + "0,+,1,1\n",
            "line 1: key 'cycle' has an unknown value; expected standard or step",
        ),
        (
            "# deviation: reversed\n" + LONG + "0,+,1,1\n",
            "line 1: key 'deviation' has an unknown value",
        ),
        ("# axis: X\n# axis: Y\n" + LONG + "0,+,1,1\n", "line 2: key 'axis' is given twice"),
        (LONG + "0,+,1,1\n0.00,+,1,2\n", "line 3: a reading is given twice"),
        (LONG + '0,+,1,"1\n', "line 2: a quote is not closed on its line"),
        (
            "target_mm,direction,run,deviation_um,\n0,+,1,1,hot\n",
            "line 2, column 5: a value is in a column without a name",
        ),
        (
            "# compwright: positioning 2\n" + LONG + "0,+,1,1\n",
            "was written for a newer version of compwright",
        ),
    ],
)
def test_contradictions(text: str, words: str) -> None:
    assert words in one_fault(text)


def test_targets_that_differ_between_the_directions() -> None:
    lines = faults(LONG + "0,+,1,1\n0,-,1,1\n100.000,+,1,1\n100.010,-,1,1\n200,+,1,1\n300,-,1,1\n")
    one_sided = (
        "a target of a test in two directions was approached in one direction only; expected"
        " readings in both directions"
    )
    differ = "the targets of the two directions differ; expected 100 mm as in direction + (line 4)"
    assert lines[0] == f"runs/x_before.csv: line 5: {differ}, found 100.01 mm in direction -"
    assert (
        lines[1] == f"runs/x_before.csv: line 6: {one_sided} at each target, found target 200 mm in"
        " direction + only"
    )
    assert (
        lines[2] == f"runs/x_before.csv: line 7: {one_sided} at each target, found target 300 mm in"
        " direction - only"
    )
    assert len(lines) == 3


def test_a_whole_target_missing_in_one_direction_of_the_wide_form() -> None:
    assert "target 10 mm in direction - only" in one_fault(
        "# unit: um\ntarget_mm,+1,-1,+2\n0.5,1,1,1\n10,,1,\n"
    )


def test_all_faults_at_once_in_the_order_of_the_lines() -> None:
    lines = faults("# cycle: x\n" + LONG + "0,+,1,a\n0,?,1,1\n0,+,z,1\n0,+\nb,+,1,1\n")
    assert [line.split(": ")[1].split(",")[0] for line in lines] == [
        f"line {n}" for n in (1, 3, 4, 5, 6, 7)
    ]


def test_many_faults_of_one_kind_are_counted() -> None:
    lines = faults(LONG + "0,+,1,a\n" * 40)
    assert len(lines) == 11
    assert lines[-1] == "runs/x_before.csv: is not a number: 30 more places with this fault"


def test_readings_that_form_no_table_are_refused() -> None:
    assert "do not form a table" in one_fault(
        LONG + "".join(f"{n}.5,+,{n},1\n" for n in range(1, 2100))
    )


@pytest.mark.parametrize("line", ["sep=;", '"sep=;"', "SEP=;"])
def test_the_line_that_tells_a_spreadsheet_the_delimiter(line: str) -> None:
    text = f"{line}\r\ntarget_mm;direction;run;deviation_um\r\n0;+;1;0,5\r\n10;+;1;1,5\r\n"
    assert read_positioning(text.encode(), "x.csv").targets.tolist() == [0.0, 10.0]


def test_blanks_around_cells_change_nothing() -> None:
    spaced = COMPLETE.replace(",", " , ").replace("\n", " \n")
    np.testing.assert_array_equal(read(spaced).positive, read(COMPLETE).positive)
    np.testing.assert_array_equal(read(spaced).negative, read(COMPLETE).negative)


def test_a_number_of_absurd_length_is_a_fault_of_its_line() -> None:
    line = f"300.0,+,1,{'1' * 200_000}.5\n"
    assert one_fault(COMPLETE + line).startswith("runs/x_before.csv: line 14")
