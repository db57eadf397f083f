"""Means (.pos) and compensation texts (.ren) of laser software."""

from __future__ import annotations

import pytest

from compwright.foundations.errors import InputError
from compwright.instruments.profile import Profile
from compwright.records.positioning import PositioningTest
from laser_files import compensation_file, laser_file, mean_file
from one_test import read_positioning

FORWARD = [("0.000", "0.0000"), ("100.000", "0.0021"), ("200.000", "0.0034")]
REVERSE = [("0.000", "-0.0030"), ("100.000", "-0.0011"), ("200.000", "0.0005")]
BOTH = [("0.000", "-0.0015"), ("100.000", "0.0005"), ("200.000", "0.0020")]


def read(text: str, profile: Profile | None = None) -> PositioningTest:
    return read_positioning(text.encode(), "y.pos", profile)


def told(test: PositioningTest) -> dict[str, str]:
    return {finding.code: finding.message for finding in test.findings}


def refused(text: str, profile: Profile | None = None) -> str:
    with pytest.raises(InputError) as caught:
        read(text, profile)
    return str(caught.value)


def test_means_of_both_ways() -> None:
    test = read(
        mean_file(
            {
                "Bidirectional": BOTH,
                "Forward Directional": FORWARD,
                "Reverse Directional": REVERSE,
            }
        )
    )
    assert test.axis == "Y"
    assert test.targets.tolist() == [0.0, 100.0, 200.0]
    assert test.positive[:, 0].tolist() == [0.0, 0.0021, 0.0034]
    assert test.negative[:, 0].tolist() == [-0.003, -0.0011, 0.0005]
    assert "means of several runs, not single readings" in told(test)["CW-R057"]
    assert "unit: mm" in told(test)["CW-R001"]


def test_the_way_back_from_both_and_forward() -> None:
    test = read(mean_file({"Bidirectional": BOTH, "Forward Directional": FORWARD}))
    assert test.negative[:, 0] == pytest.approx([-0.003, -0.0011, 0.0006], abs=1e-12)
    assert "2 × mean of both directions" in told(test)["CW-R057"]


def test_positions_from_high_to_low_turn_the_directions() -> None:
    test = read(
        mean_file({"Forward Directional": FORWARD[::-1], "Reverse Directional": REVERSE[::-1]})
    )
    assert test.negative[:, 0].tolist() == [0.0, 0.0021, 0.0034]
    assert "CW-R014" in told(test)


def test_a_file_of_means_that_was_cut() -> None:
    whole = {"Forward Directional": FORWARD, "Reverse Directional": REVERSE}
    assert "CW-R053" in told(read(mean_file(whole, end=False)))
    assert "CW-R053" not in told(read(mean_file(whole)))
    short = {**whole, "Reverse Directional": REVERSE[:2]}
    assert "may have been cut off" in refused(mean_file(short))


@pytest.mark.parametrize(
    ("blocks", "words"),
    [
        ({"Bidirectional": BOTH}, "the directions cannot be separated"),
        ({"Forward Directional": []}, "contains no means"),
        (
            {
                "Bidirectional": FORWARD,
                "Forward Directional": FORWARD,
                "Reverse Directional": REVERSE,
            },
            "is not the mean of the two directions; expected -0.0015",
        ),
        ({"Forward Directional": [("0.000", "x")]}, "is not a number"),
        (
            {"Forward Directional": [("x", "0.1"), *FORWARD]},
            "is not below the title of a block of means",
        ),
        ({"Forward Directional": [("0.000", "0.001 3")]}, "is not a row of position and mean"),
        ({"Forward Directional": [*FORWARD, FORWARD[0]]}, "a position is given twice"),
    ],
)
def test_means_that_are_refused(blocks: dict[str, list[tuple[str, str]]], words: str) -> None:
    assert words in refused(mean_file(blocks))


def test_two_forms_at_once() -> None:
    runs = laser_file(["0", "1"], {(1, 1): "0.0", (1, 2): "1.0"})
    both = runs.replace("EQUIPMENT::", "Position\tBidirectional Avg Error\n0\t0.1\nEQUIPMENT::")
    assert "mixes two formats" in refused(both)


ROWS = [["1", "-250", "0", "-0.0002"], ["2", "-225", "0.0013", "0.0008"]]
ROWS += [["3", "-200", "0.0021", "0.0017"]]


@pytest.mark.parametrize(
    ("sign", "factor"),
    [("As errors", 1.0), ("Errors", 1.0), ("As corrections", -1.0), ("Corrections", -1.0)],
)
def test_a_compensation_text_by_its_field(sign: str, factor: float) -> None:
    test = read(compensation_file(ROWS, sign=sign))
    assert test.targets.tolist() == [-250.0, -225.0, -200.0]
    assert test.positive[:, 0].tolist() == [factor * value for value in (0.0, 0.0013, 0.0021)]
    assert test.negative[:, 0].tolist() == [factor * value for value in (-0.0002, 0.0008, 0.0017)]
    assert "a compensation table" in told(test)["CW-R058"]


def test_a_row_of_a_compensation_text_above_its_table_is_told() -> None:
    whole = compensation_file(ROWS)
    assert "CW-R063" not in told(read(whole))
    first, *others = whole.splitlines(keepends=True)
    moved = "".join([first, "3   -200   -1   0.0011\r\n", *others])
    assert "line 2 '3 -200 -1 0.0011'." in told(read(moved))["CW-R063"]
    assert "CW-R063" not in told(read("".join([first, "2 of 3, 2026-03-02\r\n", *others])))


def test_a_compensation_text_without_the_field() -> None:
    text = compensation_file(ROWS, sign=None)
    assert "errors or corrections" in refused(text)
    test = read(text, Profile(file="p", layout="own", sign="target minus measured"))
    assert test.positive[:, 0].tolist() == [0.0, -0.0013, -0.0021]


def test_one_table_without_backlash() -> None:
    rows = [["1", "-250", "0.001"], ["2", "-225", "0.002"], ["3", "-200", "0.003"]]
    columns = "No.   Axis position   Combined"
    test = read(compensation_file(rows, columns=columns, backlash="0.000 mm"))
    assert test.positive.tolist() == test.negative.tolist() == [[0.001], [0.002], [0.003]]
    for backlash in ("0.005 mm", "N/A"):
        text = compensation_file(rows, columns=columns, backlash=backlash)
        assert "how its backlash is split" in refused(text)


def test_a_list_of_values() -> None:
    text = compensation_file([["0.001"], ["0.002"], ["0.003"]], columns="", backlash="0")
    assert read(text).targets.tolist() == [-250.0, -225.0, -200.0]
    short = compensation_file([["0.001"], ["0.002"]], columns="", backlash="0")
    assert "fewer or more rows" in refused(short)


@pytest.mark.parametrize(
    ("words", "changes"),
    [
        ("of an unknown type", {"kind": "Incremental"}),
        ("the sign convention is unknown", {"sign": "As measured"}),
        ("do not fit together", {"spacing": "24 mm"}),
        ("is not a length in mm", {"start": "-250 in"}),
        ("is missing", {"start": ""}),
        ("is not at the position", {"start": "-245 mm", "end": "-195 mm"}),
        ("fewer or more rows", {"end": "-175 mm"}),
    ],
)
def test_compensation_texts_that_are_refused(words: str, changes: dict[str, str]) -> None:
    assert words in refused(compensation_file(ROWS, **changes))


def test_whole_numbers_may_be_counts() -> None:
    rows = [["1", "-250", "0", "-2"], ["2", "-225", "13", "8"], ["3", "-200", "21", "17"]]
    text = compensation_file(rows, resolution="0.0001 mm")
    assert "counts of the compensation resolution" in refused(text)
    test = read(text, Profile(file="p", layout="own", unit="um"))
    assert test.positive[:, 0] == pytest.approx([0.0, 0.013, 0.021], rel=1e-15)


@pytest.mark.parametrize("spacing", ["1e-320", "0", "-25", "1e6", "0.0000001"])
def test_a_spacing_that_no_table_has(spacing: str) -> None:
    with pytest.raises(InputError, match="start, end and spacing do not fit together"):
        read(compensation_file(ROWS, spacing=f"{spacing} mm"))
