"""No reading is lost in silence: header cells as spreadsheets write them, one-sided targets, files
cut off inside a number.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.instruments.circular_csv import read_circular_csv
from compwright.instruments.profile_reading import read_profile
from compwright.records.positioning import PositioningTest
from laser_files import laser_file, mean_file
from next_steps import without_hint
from one_test import read_positioning
from places import PROJECT
from profile_samples import LONG as FOREIGN
from profile_samples import LONG_PROFILE, WIDE, WIDE_PROFILE

#: Three traverses each way at two targets; a reading says which traverse it is: 1.3 is run 3 in +,
#: -2.3 run 3 in -.
ROWS = "0.5,1.1,-1.1,1.2,-1.2,1.3,-1.3\n100.5,2.1,-2.1,2.2,-2.2,2.3,-2.3\n"


def read(text: str) -> PositioningTest:
    return read_positioning(text.encode(), "x.csv")


def wide(column: str, place: int = 5) -> PositioningTest:
    """Read the wide file in which one column (counted from 1; 5 is +3, 6 is -3) has another
    name.
    """
    names = ["+1", "-1", "+2", "-2", "+3", "-3"]
    names[place - 1] = column
    return read(f"# unit: um\ntarget_mm,{','.join(names)}\n{ROWS}")


def refusal(text: str) -> str:
    with pytest.raises(InputError) as caught:
        read(text)
    return str(caught.value)


def messages(test: PositioningTest) -> dict[str, tuple[str, str]]:
    return {finding.code: (finding.severity, finding.message) for finding in test.findings}


@pytest.mark.parametrize(
    "column",
    [
        "+ 3",
        "3+",
        "3 +",
        "+3.0",
        '"+3,0"',
        "run 3 +",
        "+ run 3",
        "run +3",
        "+03",
        "\uff0b3",
        "+3 up",
        "up +3",
        "3↑",
        "+3 (positive)",
        "run 3 (+)",
        "Run no 3 +",
    ],
)
def test_a_traverse_in_positive_direction_is_known_however_it_is_written(column: str) -> None:
    test = wide(column)
    assert test.runs_positive == test.runs_negative == (1, 2, 3)
    assert test.positive[:, 2].tolist() == pytest.approx([0.0013, 0.0023])
    assert "CW-R005" not in messages(test)


@pytest.mark.parametrize(
    "column",
    ["- 3", "3-", "-3.0", "run 3 -", "\u22123", "\u2013 3", "\u20103", "3\u2013", "\uff0d3"],
)
def test_a_traverse_in_negative_direction_is_known_however_it_is_written(column: str) -> None:
    test = wide(column, 6)
    assert test.runs_positive == test.runs_negative == (1, 2, 3)
    assert test.negative[:, 2].tolist() == pytest.approx([-0.0013, -0.0023])


@pytest.mark.parametrize(
    "column",
    ["+3 down", "up 3", "3 forward", "+3.5", "±3", "+3-", "+-3", "+3↓", "run 3", "+0", "+3 (4)"],
)
def test_what_may_be_a_traverse_is_refused_with_its_line(column: str) -> None:
    text = f"# unit: um\ntarget_mm,+1,-1,+2,-2,{column},-3\n{ROWS}"
    assert (
        "x.csv: line 2: the names of traverse columns do not show direction and run; expected +1, -1"
        in refusal(text)
    )
    assert f"found {column}" in refusal(text)


def test_one_traverse_in_two_columns() -> None:
    text = f"# unit: um\ntarget_mm,+1,-1,+2,-2,+ 2,-3\n{ROWS}"
    assert (
        "x.csv: line 2: a traverse is given twice; expected one column per traverse, found '+2' and"
        " '+ 2'" in refusal(text)
    )


def test_columns_that_are_no_traverse_are_a_warning() -> None:
    text = "# unit: um\ntarget_mm,+1,-1,temperature,mean +,sensor-2\n0.5,1,2,20.1,1,7\n"
    assert messages(read(text))["CW-R005"] == (
        "warning",
        "These columns were left out: temperature, mean +, sensor-2.",
    )


def test_direction_with_the_dash_of_a_word_processor() -> None:
    test = read("target_mm,direction,run,deviation_um\n0.5,+,1,1\n0.5,\u2013,1,2\n0.5,\u2212,2,3\n")
    assert test.negative.tolist() == [[0.002, 0.003]]


LONG = "target_mm,direction,run,deviation_um\n"


def long(targets: int, *left_out: str) -> str:
    rows = [f"{100 * i},{sign},1,{i}.5" for i in range(targets) for sign in "+-"]
    return LONG + "".join(f"{row}\n" for row in rows if not row.startswith(left_out or "no"))


def test_a_target_that_lacks_one_direction_is_left_out_with_a_warning() -> None:
    test = read(long(5, "300,-"))
    assert test.targets.tolist() == [0, 100, 200, 400]
    assert np.isfinite(test.positive).all()
    severity, message = messages(test)["CW-R050"]
    assert severity == "warning"
    assert message.endswith("left out: 300 mm in direction + only (line 8).")


def test_many_targets_that_lack_one_direction_are_refused() -> None:
    assert refusal(long(5, "300,-", "400,+")).count("was approached in one direction only") == 2


def test_a_typing_error_in_a_target_is_refused() -> None:
    text = long(6).replace("300,-", "301,-")
    assert "the targets of the two directions differ; expected 300 mm as in direction +" in refusal(
        text
    )


@pytest.mark.parametrize(
    ("rows", "number"),
    [
        ("0,+,1,1\n0,-,1,12", "12"),
        ("0,+,1,1.25\n0,-,1,-12.2", "-12.2"),
        ("0,+,1,1.25\n0,-,1,-12.", "-12."),
        ("0,+,1,1.25\r\n0,-,1,-12.255", "-12.255"),
    ],
)
def test_a_file_that_may_be_cut_off_inside_a_number(rows: str, number: str) -> None:
    severity, message = messages(read(LONG + rows))["CW-R051"]
    assert severity == "warning"
    assert message.startswith(f"The last line ends after '{number}' without a line break (line 3)")
    assert "CW-R051" not in messages(read(f"{LONG}{rows}\n"))


def test_a_last_number_as_long_as_the_others_is_whole() -> None:
    assert "CW-R051" not in messages(read(LONG + "0,+,1,1.25\n0,-,1,-12.20"))
    data = "TGT_DATA[1]=0.0\nREF_DATA_FWD[1,1]=0.01\nREF_DATA_BWD[1,1]=0.02"
    assert "CW-R051" in messages(read(data))  # nothing else is printed like the last one
    assert "CW-R051" not in messages(read(data + "\n"))


@pytest.mark.parametrize(
    ("text", "column"),
    [
        ("target_in,direction,run,deviation_um\n1,+,1,1\n", "target_in"),
        ("target_inch,direction,run,deviation_thou\n1,+,1,1\n", "target_inch"),
        ("target_mm,direction,run,deviation_mil\n1,+,1,1\n", "deviation_mil"),
        ("target (in),+1,-1\n1,1,1\n", "target (in)"),
    ],
)
def test_inches_are_answered_with_what_to_do(text: str, column: str) -> None:
    said = refusal(text)
    assert (
        "is in inches, which compwright does not read; expected target_mm and deviation_um: multiply targets in"
        " inches by 25.4" in said
    )
    assert f"found '{column}'" in said


@pytest.mark.parametrize("code_page", ["cp1252", "cp1251", "gbk"])
def test_an_older_code_page_in_comments_and_names_is_read_and_said(code_page: str) -> None:
    """Every number is ASCII, which all code pages share: the same readings, whatever was taken."""
    words = {"cp1252": "Müller, 20 °C", "cp1251": "Иванов", "gbk": "张伟"}[code_page]
    text = f"# operator: {words}\r\n" + long(5).replace("\n", "\r\n")
    plain = read_positioning(text.encode(), "x.csv")
    test = read_positioning(text.encode(code_page), "x.csv")
    assert np.array_equal(test.positive, plain.positive)
    assert np.array_equal(test.negative, plain.negative)
    (said,) = set(test.findings) - set(plain.findings)
    assert (said.code, said.severity) == ("CW-R062", "info")
    assert f"Line 1 then reads '# operator: {words}'" in said.message


def test_a_micro_sign_in_the_name_of_a_column_is_read() -> None:
    text = long(5).replace("deviation_um", "deviation_µm")
    test = read_positioning(text.encode("cp1252"), "x.csv")
    assert np.array_equal(test.positive, read_positioning(text.encode(), "x.csv").positive)
    assert [one.code for one in test.findings].count("CW-R062") == 1


def test_the_code_page_of_windows_among_readings_is_answered_with_what_to_do() -> None:
    """A dash of a word processor for the direction: a reading hangs on it."""
    text = long(5).replace(",-,1,", ",–,1,", 1)
    text = "# Müller\n" + text
    with pytest.raises(InputError) as caught:
        read_positioning(text.encode("cp1252"), "x.csv")
    assert (
        without_hint(str(caught.value))
        == "x.csv: line 4: the file is not text in a known encoding; expected UTF-8: save the file again"
        " with that encoding (editor: save as, encoding UTF-8; spreadsheet: CSV UTF-8), or write"
        " u for µ and deg for °, found '0,–,1,0.5' (Windows-1252)"
    )


def test_the_page_about_measurement_files() -> None:
    page = (PROJECT / "docs" / "measurement-files.md").read_text(encoding="utf-8")
    long, wide, _, circle = re.findall(r"```csv\n(.*?)```", page, re.DOTALL)
    one, other = read(long), read(wide)
    assert one.axis == other.axis == "X"
    for values in ("targets", "positive", "negative"):
        assert getattr(one, values).tolist() == getattr(other, values).tolist()
    # As the page says: at 100.274, coming in +, run 1, it stood 2.1 µm too far to plus.
    assert one.positive[1, 0] == pytest.approx(0.0021)
    assert one.negative.tolist() == [
        pytest.approx([-0.0029, -0.0031]),
        pytest.approx([-0.0016, -0.0012]),
    ]
    head = circle.partition("ccw,")[0]
    rows = "".join(
        f"{sense},{angle},1.2\n" for sense in ("ccw", "cw") for angle in range(0, 360, 5)
    )
    assert read_circular_csv((head + rows).encode(), "xy.csv", "xy").plane == "XY"
    test = read_circular_csv(("# Prüfer: Müller\n" + head + rows).encode("cp1252"), "xy.csv", "xy")
    assert "CW-R062" in [finding.code for finding in test.findings]
    for code in re.findall(r"`(CW-[A-Z][0-9]{3})`", page):
        assert code in (PROJECT / "docs" / "findings.md").read_text(encoding="utf-8")


def stray(text: str, profile: str = "") -> str:
    """What is told of lines outside the readings; empty where nothing is."""
    mapped = read_profile(profile.encode(), "P.yaml") if profile else None
    test = read_positioning(text.encode(), "x", mapped)
    return messages(test).get("CW-R063", ("", ""))[1]


def test_rows_of_a_laser_file_in_another_section() -> None:
    runs = {(run, at): f"{at}.{run}" for run in (1, 2, 3, 4) for at in (1, 2, 3)}
    whole = laser_file(["0", "100", "200"], runs)
    assert stray(whole) == ""
    lost = [f"   {run}     3     3.{run}\r\n" for run in (1, 2, 3, 4)]
    moved = whole
    for row in lost:
        moved = moved.replace(row, "")
    moved = moved.replace("Target-count: 3", "Target-count: 2").replace("0 100 200", "0 100")
    assert stray(moved) == ""
    moved = moved.replace("USER-TEXT::\r\n", "USER-TEXT::\r\n" + "".join(lost))
    assert "line 14 '1 3 3.1', 15 '2 3 3.2', 16 '3 3 3.3', 17 '4 3 3.4'." in stray(moved)


def test_means_above_their_title() -> None:
    rows = [("0.000", "0.0000"), ("100.000", "0.0021"), ("200.000", "0.0030")]
    blocks = {"Forward Directional": rows, "Reverse Directional": rows}
    whole = mean_file(blocks)
    assert stray(whole) == ""
    moved = whole.replace("100.000\t0.0021\r\n", "")
    moved = moved.replace("Axis: Y\r\n", "Axis: Y\r\n100.000\t0.0021\r\n")
    assert "line 4 '100.000 0.0021'" in stray(moved)


@pytest.mark.parametrize(
    ("text", "profile", "row", "told"),
    [
        (FOREIGN, LONG_PROFILE, 3, "line 1 '100,000;vor;1;2,1', 2 '100,000;zurück;1;-0,8'."),
        (WIDE, WIDE_PROFILE, 3, "line 1 '200 3.0 1.0 20', 2 '300 3.0 1.5 20'."),
        (
            WIDE.replace("\tT\n", "\tT\tU\n"),
            WIDE_PROFILE,
            3,
            "line 1 '200 3.0 1.0 20', 2 '300 3.0 1.5 20'.",
        ),
    ],
)
def test_rows_above_the_header_row(text: str, profile: str, row: int, told: str) -> None:
    assert stray(text, profile) == ""
    lines = text.splitlines(keepends=True)
    moved = lines[row : row + 2]
    assert told in stray("".join([*moved, *lines[:row], *lines[row + 2 :]]), profile)


@pytest.mark.parametrize(
    ("text", "profile", "row"),
    [
        (f"# unit: um\ntarget_mm,+1,-1,+2,-2,+3,-3\n{ROWS}", None, "50.5,,,,,,"),
        (WIDE, WIDE_PROFILE, "50.5\t\t\t"),
        (WIDE, WIDE_PROFILE, "50.5"),  # the row in which a copy ended
        (FOREIGN.replace("Mittel;;;0,5\n", ""), LONG_PROFILE, "50,500;vor;1;"),
    ],
)
def test_a_target_without_any_reading_is_told(text: str, profile: str | None, row: str) -> None:
    used = read_profile(profile.encode(), "p.yaml") if profile else None
    whole = read_positioning(text.encode(), "x.csv", used)
    assert not any("Rows without any" in finding.message for finding in whole.findings)
    test = read_positioning(f"{text}{row}\n".encode(), "x.csv", used)
    assert 50.5 not in test.targets
    severity, message = next(
        (finding.severity, finding.message)
        for finding in test.findings
        if finding.code == "CW-R006" and "Rows without any reading" in finding.message
    )
    assert severity == "warning"
    assert "target 50.5 mm" in message


#: What a spreadsheet shows for a target that it cannot show or work out, in English, German, French
#: and Russian, and what somebody writes who takes a row out by hand.
MARKS = ["#####", "#REF!", "#DIV/0!", "#N/A", "#WERT!", "#BEZUG!", "#NV", "#VALEUR!", "#ЗНАЧ!"]
MARKS += ["# 50.5", "#50.5"]


@pytest.mark.parametrize("mark", MARKS)
def test_a_row_whose_target_is_shown_as_a_comment_is_told(mark: str) -> None:
    head = "# unit: um\ntarget_mm,+1,-1,+2,-2,+3,-3\n"
    row = f"{mark},1.1,-1.1,1.2,-1.2,1.3,-1.3\n"
    told = stray(head + row + ROWS)
    assert "line 3 " in told
    assert mark.split(maxsplit=1)[0] in told
    assert stray(f"{head}{ROWS}# end of the test, 1.1 mm before the stop\n# runs: 3\n") == ""
    long = "target_mm,direction,run,deviation_um\n0,+,1,1.1\n100,+,1,1.2\n0,-,1,1.3\n100,-,1,1.4\n"
    assert "line 6 " in stray(f"{long}{mark},+,2,1.5\n")
    foreign = FOREIGN.replace("Mittel", f"{mark};vor;2;0,7\nMittel")
    assert "line 7 " in stray(foreign, LONG_PROFILE)
