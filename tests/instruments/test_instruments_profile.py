"""Tables of other programs by a mapping profile: what it says counts, and nothing else is taken."""

from __future__ import annotations

import re

import pytest

from compwright.foundations.errors import InputError, UsageError
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.profile_reading import read_profile
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest
from one_test import read_positioning
from profile_samples import LONG, LONG_PROFILE, WIDE, WIDE_PROFILE


def read(text: str, profile: str, encoding: str = "utf-8") -> PositioningTest:
    return read_positioning(
        text.encode(encoding), "x.csv", read_profile(profile.encode(), "P.yaml")
    )


def told(test: PositioningTest) -> dict[str, str]:
    return {finding.code: finding.message for finding in test.findings}


def refused(text: str, profile: str) -> str:
    with pytest.raises(InputError) as caught:
        read(text, profile)
    return str(caught.value)


def faults(profile: str) -> str:
    with pytest.raises(UsageError) as caught:
        read_profile(profile.encode(), "P.yaml")
    return str(caught.value)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_one_row_per_reading(encoding: str, end: str) -> None:
    test = read(LONG.replace("\n", end), LONG_PROFILE, encoding)
    assert (test.axis, test.kind, test.frame) == ("Y", AxisKind.LINEAR, "instrument")
    assert test.targets.tolist() == [0.0, 100.0]
    assert test.positive[:, 0] * 1000 == pytest.approx([0.4, 2.1], rel=1e-15)
    assert test.negative[:, 0] * 1000 == pytest.approx([-2.9, -0.8], rel=1e-15)
    assert "line 7 'Mittel; 0,5'" in told(test)["CW-R059"]


def test_worked_rows_say_how_it_was_read() -> None:
    said = told(read(LONG, LONG_PROFILE))["CW-R060"]
    assert "line 4: at 100 mm, approached from below, the axis went 2.1 µm too far" in said
    assert "line 6: at 0 mm, approached from above, the axis went 2.9 µm too far" in said
    turned = LONG_PROFILE.replace("measured minus target", "target minus measured")
    said = told(read(LONG, turned))["CW-R060"]
    assert "line 4: at 100 mm, approached from below, the axis stopped 2.1 µm short" in said


def test_the_sign_turns_everything() -> None:
    turned = LONG_PROFILE.replace("measured minus target", "target minus measured")
    assert (read(LONG, turned).positive == -read(LONG, LONG_PROFILE).positive).all()


def test_measured_positions() -> None:
    text = LONG.replace(";2,1", ";100,0021").replace(";0,4", ";0,0004")
    text = text.replace(";-0,8", ";99,9992").replace(";-2,9", ";-0,0029")
    profile = LONG_PROFILE.replace("value_is: deviation", "value_is: measured")
    profile = profile.replace("unit: um", "unit: mm").replace("sign: measured minus target\n", "")
    test = read(text, profile)
    assert test.positive[:, 0] == pytest.approx([0.0004, 0.0021], abs=1e-12)


def test_one_column_per_traverse() -> None:
    test = read(WIDE, WIDE_PROFILE)
    assert test.positive[0, 0] * 1000 == pytest.approx(0.4, rel=1e-15)
    assert test.negative[0, 0] * 1000 == pytest.approx(-2.9, rel=1e-15)
    assert "CW-R005" not in told(test)
    assert "100 mm in direction + only" in told(test)["CW-R050"]
    left = told(read(WIDE, WIDE_PROFILE.replace("leave_out: [T]\n", "")))
    assert left["CW-R005"] == "These columns were left out: T."


def test_runs_that_count_traverses() -> None:
    text = LONG.replace("zurück;1", "zurück;2").replace("Mittel;;;0,5\n", "")
    text += "0,000;vor;3;0,5\n100,000;vor;3;2,0\n100,000;zurück;4;-0,9\n0,000;zurück;4;-3,0\n"
    test = read(text, LONG_PROFILE + "run_counts: traverses\n")
    assert (test.runs_positive, test.runs_negative) == ((1, 2), (1, 2))
    assert test.negative[0] * 1000 == pytest.approx([-2.9, -3.0], rel=1e-15)


def test_directions_by_the_order_of_rows() -> None:
    profile = LONG_PROFILE.replace("direction_from: column", "direction_from: order")
    profile = profile.replace("run: Lauf\n", "")
    again = "0,000;;;0,5\n100,000;;;2,0\n100,000;;;-0,9\n0,000;;;-3,0\n"
    text = LONG.replace("Mittel;;;0,5\n", again)
    test = read(text, profile)
    assert test.positive[1] * 1000 == pytest.approx([2.1, 2.0], rel=1e-15)
    assert test.negative[1] * 1000 == pytest.approx([-0.8, -0.9], rel=1e-15)
    one_way = LONG.replace("zurück;1", "vor;2").replace("100,000;vor;2", "50,000;vor;2")
    assert "does not show the directions" in refused(
        one_way.replace("0,000;vor;2", "70,000;vor;2"), profile
    )


def test_positions_that_are_mapped() -> None:
    test = read(LONG, LONG_PROFILE + "position_map: {sense: -1, offset: 500}\n")
    assert (test.frame, test.targets.tolist()) == ("machine", [400.0, 500.0])
    # counted against the machine: + is -, and every deviation turns
    assert test.negative[:, 0] * 1000 == pytest.approx([-2.1, -0.4], rel=1e-12)


def test_angles() -> None:
    profile = LONG_PROFILE.replace("target_unit: mm", "target_unit: deg")
    test = read(LONG, profile.replace("unit: um", "unit: urad"))
    assert test.kind is AxisKind.ROTARY
    assert test.positive[1, 0] * 3600 == pytest.approx(2.1 * 0.2062648062, rel=1e-9)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "2,1",
            "2.1",
            "line 4, column 'Abw. [µm]' has a point, and the profile says decimal comma",
        ),
        ("2,1", "1.002,1", "has a point"),
        ("2,1", "zwei1", "is not a number"),
        ("100,000;vor;1", "100,000;hin;1", "not among the names that the profile lists"),
        ("100,000;vor;1", "100,000;vor;eins", "is not a number of at least 1"),
        ("100,000;vor;1", "0,000;vor;1", "a reading is given twice"),
        ("Abw. [µm]", "Abw.", "a column of the profile is not in the file"),
        ("0,000;vor;1;0,4", "0,000;vor;1;0,4;7", "more cells than the header row"),
        ("100,000;vor", '"100,000;vor', "a quote is not closed"),
    ],
)
def test_damage(old: str, new: str, words: str) -> None:
    assert old in LONG
    assert words in refused(LONG.replace(old, new, 1), LONG_PROFILE)


@pytest.mark.parametrize(
    "key",
    [
        *(
            "sign",
            "unit",
            "value_is",
            "direction_from",
            "target",
            "target_unit",
            "value",
            "decimal",
        ),
        *("delimiter", "header_line", "direction", "directions", "layout"),
    ],
)
def test_what_is_empty_is_refused(key: str) -> None:
    lines = LONG_PROFILE.splitlines()
    emptied = "\n".join(f"{key}:" if line.startswith(f"{key}:") else line for line in lines)
    without = "\n".join(line for line in lines if not line.startswith(f"{key}:"))
    assert f"'{key}' is empty and must be filled in" in faults(emptied)
    assert f"'{key}' is empty and must be filled in" in faults(without)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"zurück": "-"', '"zurück": ', "directions.zurück is empty and must be filled in"),
        ('"zurück": "-"', '"zurück": back', "is neither + nor -"),
        ("sign: measured minus target", "sign: plus", "sign is not an accepted value"),
        ("unit: um", "unit: arcsec", "is an angle and target_unit a length"),
        ("header_line: 2", "header_line: two", "is not a line number"),
        ("axis: Y", "axes: Y", "axes: unknown key; expected 'axis'"),
        ("compwright_profile: 1", "compwright_profile: 2", "of a version that is not known"),
        ("compwright_profile: 1", "profile: 1", "is not a mapping profile"),
        ("run: Lauf", "position_map: {sense: 2}", "is neither 1 nor -1"),
    ],
)
def test_profiles_that_are_wrong(old: str, new: str, words: str) -> None:
    assert old in LONG_PROFILE
    assert words in faults(LONG_PROFILE.replace(old, new, 1))


def test_all_faults_at_once() -> None:
    text = faults("compwright_profile: 1\nlayout: wide\nsens: +\n")
    assert len(text.splitlines()) > 6
    assert "P.yaml: line 3: sens" in text.replace("line 3, sens", "line 3: sens")


def test_an_unknown_layout_hides_no_other_fault() -> None:
    text = faults("compwright_profile: 1\nlayout: tall\ndecimal: dot\nheader_line: two\nsens: +\n")
    for key in ("layout", "decimal", "header_line", "sens"):
        assert re.search(f", {key}[: ]", text), text
    assert "'target'" not in text  # whether it is needed depends on the layout


def test_files_with_readers_of_their_own_do_not_need_it() -> None:
    plain = "# axis: X\ntarget_mm,direction,run,deviation_um\n0,+,1,1.0\n1,+,1,2.0\n"
    assert read(plain, LONG_PROFILE).axis == "X"
    targets = "TGT_DATA[1]=0\nTGT_DATA[2]=5\nREF_DATA_FWD[1,1]=0.1\nREF_DATA_FWD[2,1]=5.1\n"
    assert read(targets, LONG_PROFILE).targets.tolist() == [0.0, 5.0]


STATUS = '"Nr";"AX2 [mm]";"Delta [mm]";"AX1 [mm]";"T";"AX3 [mm]"\r\n'
STATUS += '"1";"0,000";"0,000";"0,001";"20";"0,004"\r\n"2";"100,000";"100,000";"0,002";"20";"0"\r\n'
STATUS += '"3";"200,000";"100,000";"0,003";"20";"0,001"\r\n'


def test_status_pro_is_known_and_asks() -> None:
    with pytest.raises(InputError, match="is a table of the Status Pro software"):
        read_positioning(STATUS.encode(), "s.csv")
    proposed = proposed_profile(STATUS.encode(), "s.csv")
    keys = {line.partition(":")[0] for line in proposed.open}
    assert {"value", "sign", "direction_from"} <= keys
    profile = LONG_PROFILE.replace("header_line: 2", "header_line: 1").replace("run: Lauf\n", "")
    profile = profile.replace("Soll [mm]", "AX2 [mm]").replace("unit: um", "unit: mm")
    profile = profile.replace("direction_from: column", 'direction_from: "+"')
    across = read(STATUS, profile.replace("Abw. [µm]", "AX1 [mm]"))
    assert across.positive[:, 0].tolist() == [0.001, 0.002, 0.003]
    step = refused(STATUS, profile.replace("Abw. [µm]", "Delta [mm]"))
    assert "the values are the distances between the targets" in step


@pytest.mark.parametrize("above", ["", "Fräse\n", "a;b\nc\nd\n"])
def test_files_of_one_program_with_more_or_less_text_above(above: str) -> None:
    text = above + LONG.partition("\n")[2]
    assert (read(text, LONG_PROFILE).positive == read(LONG, LONG_PROFILE).positive).all()


def test_a_header_row_that_stands_twice_is_not_guessed() -> None:
    header = LONG.splitlines()[1]
    assert "not in the file" in refused(f"a\nb\nc\n{header}\n{LONG}", LONG_PROFILE)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (
            "Achse: X",
            "the profile state different values of `axis`; expected Y as in P.yaml, found X",
        ),
        (
            "Einheit: mm",
            "the profile state different values of `unit`; expected um as in P.yaml, found mm",
        ),
        (
            "Soll - Ist",
            "the profile state different values of `sign`; expected measured minus target",
        ),
    ],
)
def test_a_profile_that_was_made_for_another_file(line: str, words: str) -> None:
    text = LONG.replace("Protokoll", line).replace("Abw. [µm]", "Abw.")
    assert words in refused(text, LONG_PROFILE.replace("Abw. [µm]", "Abw."))


def test_a_unit_above_the_table_may_be_that_of_the_targets() -> None:
    assert read(LONG.replace("Protokoll", "Einheit: mm"), LONG_PROFILE).axis == "Y"
