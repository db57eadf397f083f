"""Laser software's runs (.rtl, .rta): layout, units, directions and what is refused or told."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.instruments.profile import Profile
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest
from laser_files import laser_file
from one_test import read_positioning

TARGETS = ["0.0000", "100.2500", "200.0000", "300.1250", "400.0000", "500.0000"]
#: Two cycles: run r, target i -> about 2 µm of lost motion and 1 µm per target.
READINGS = {
    (run, index): f"{index - 1 - 2.0 * (run % 2 == 0) + 0.1 * run:.1f}"
    for run in (1, 2, 3, 4)
    for index in range(1, 7)
}


def read(text: str | bytes, profile: Profile | None = None) -> PositioningTest:
    content = text if isinstance(text, bytes) else text.encode()
    return read_positioning(content, "x.rtl", profile)


def told(test: PositioningTest) -> dict[str, str]:
    return {finding.code: finding.message for finding in test.findings}


def refused(text: str, profile: Profile | None = None) -> str:
    with pytest.raises(InputError) as caught:
        read(text, profile)
    return str(caught.value)


@pytest.mark.parametrize("descending", [True, False])
@pytest.mark.parametrize("row_header", ["Run Target Data:", "Run Target Data: "])
def test_every_digit(descending: bool, row_header: str) -> None:
    test = read(laser_file(TARGETS, READINGS, descending=descending, row_header=row_header))
    assert (test.axis, test.kind, test.header["machine"]) == ("X", AxisKind.LINEAR, "VMC 850")
    assert test.targets.tolist() == [0.0, 100.25, 200.0, 300.125, 400.0, 500.0]
    assert (test.runs_positive, test.runs_negative) == ((1, 2), (1, 2))
    for runs, block in (((1, 3), test.positive), ((2, 4), test.negative)):
        for column, run in enumerate(runs):
            written = [float(READINGS[run, index]) for index in range(1, 7)]
            np.testing.assert_allclose(block[:, column] * 1000.0, written, rtol=1e-15)
    assert ("CW-R055" in told(test)) is not descending
    assert "CW-R053" not in told(test)


def test_what_was_taken_is_said() -> None:
    said = told(read(laser_file(TARGETS, READINGS)))["CW-R001"]
    for words in (
        "unit: um",
        "measured minus target",
        "2 traverses, approaches in direction +",
        "run 2, 4, ..: 2 traverses, approaches in direction -",
    ):
        assert words in said


def test_another_version_is_said() -> None:
    text = laser_file(TARGETS, READINGS)
    assert "layout" not in told(read(text))["CW-R001"]
    other = text.replace("V20.02.02", "4.13.9")
    assert "layout: that of V20 (the file says version 4.13.9)" in told(read(other))["CW-R001"]


def test_readings_in_words() -> None:
    said = told(read(laser_file(TARGETS, READINGS)))["CW-R060"]
    # run 3, target 6: 5.3 µm in direction +; run 2, target 1: -1.8 µm in direction -
    assert "at 500 mm, approached from below, the axis went 5.3 µm too far" in said
    assert "at 500 mm, approached from above, the axis stopped 3.4 µm short" in said


def test_targets_from_high_to_low_turn_the_directions() -> None:
    rising = read(laser_file(TARGETS, READINGS))
    mirrored = {(run, 7 - index): value for (run, index), value in READINGS.items()}
    falling = read(laser_file(TARGETS[::-1], mirrored))
    assert falling.targets.tolist() == rising.targets.tolist()
    np.testing.assert_array_equal(falling.positive, rising.negative)
    np.testing.assert_array_equal(falling.negative, rising.positive)
    assert "direction -" in told(falling)["CW-R014"]


def test_one_direction_by_its_flags() -> None:
    test = read(laser_file(TARGETS, READINGS, flags="0 1 2 0", descending=False))
    assert (test.positive.shape, test.negative.shape) == ((6, 4), (6, 0))
    written = [float(READINGS[run, 3]) for run in (1, 2, 3, 4)]
    np.testing.assert_allclose(test.positive[2] * 1000.0, written, rtol=1e-15)


@pytest.mark.parametrize("flags", ["0 1 2 0", "0 0 2 0", None])
def test_a_way_back_of_zeros_was_not_made(flags: str | None) -> None:
    filled = {key: value if key[0] % 2 else "0" for key, value in READINGS.items()}
    test = read(laser_file(TARGETS, filled, flags=flags, descending=False))
    assert (test.positive.shape, test.negative.shape) == ((6, 2), (6, 0))
    assert "exactly zero: 2, 4" in told(test)["CW-R054"]


def test_rows_that_contradict_the_directions() -> None:
    assert "contradicts the direction of the run" in refused(
        laser_file(TARGETS, READINGS, flags="0 1 2 0")
    )
    mirrored = {(run, 7 - index): READINGS[run, index] for run, index in READINGS}
    lines = laser_file(TARGETS, mirrored).split("\r\n")
    first = next(at for at, line in enumerate(lines) if line.startswith("   1     1 "))
    lines[first : first + 6] = lines[first : first + 6][::-1]
    assert "run 1 from the last target to the first" in refused("\r\n".join(lines))


def test_targets_without_an_order() -> None:
    mixed = ["0", "200", "100", "300", "400", "500"]
    assert "the direction of each approach is unknown" in refused(laser_file(mixed, READINGS))


def test_angles_are_microradian() -> None:
    test = read(laser_file(TARGETS, {(1, 1): "0.0", (1, 2): "12.3"}, file_type="rta", axis="B"))
    assert (test.kind, test.axis) == (AxisKind.ROTARY, "B")
    # 1 µrad is 0.206265 arcsec
    assert test.positive[1, 0] * 3600 == pytest.approx(12.3 * 0.206264806247, rel=1e-11)
    assert "2.5371 arcsec" in told(test)["CW-R056"]


def test_angles_whose_unit_nobody_knows() -> None:
    text = laser_file(TARGETS, {(1, 1): "0.0", (1, 2): "0.0123"}, file_type="rta")
    assert "unit: urad` or `unit: mrad" in refused(text)
    test = read(text, Profile(file="p", layout="own", unit="mrad"))
    assert test.positive[1, 0] * 3600 == pytest.approx(12.3 * 0.206264806247, rel=1e-11)
    assert "CW-R056" not in told(test)
    assert "contradict" in refused(text, Profile(file="p", layout="own", unit="um"))


def test_the_sign_may_be_said() -> None:
    turned = read(
        laser_file(TARGETS, READINGS), Profile(file="p", layout="own", sign="target minus measured")
    )
    np.testing.assert_array_equal(turned.positive, -read(laser_file(TARGETS, READINGS)).positive)


@pytest.mark.parametrize(
    ("kind", "words"),
    [("rts", "contains straightness, not positions"), ("rtz", "the type of the file is unknown")],
)
def test_other_types(kind: str, words: str) -> None:
    assert words in refused(laser_file(TARGETS, READINGS, file_type=kind))


def test_dynamic_data() -> None:
    text = b"HEADER::\r\nFilename: x.rtx\r\nFile Type: rtx\r\nData:\r\n" + bytes(range(64))
    with pytest.raises(InputError, match="dynamic data"):
        read(text)


def test_a_file_that_was_cut() -> None:
    whole = laser_file(TARGETS, READINGS)
    at = whole.index("   4     3 ")
    cut = read(whole[:at])
    assert "may have been cut off" in told(cut)["CW-R053"]
    assert "3 of 24 readings are missing" in told(cut)["CW-R006"]
    halved = read(whole[: whole.index("   3     6 ")])
    messages = [finding.message for finding in halved.findings if finding.code == "CW-R053"]
    assert any("has 4 runs, but it contains 3" in message for message in messages)
    assert any("EOF:: is missing" in message for message in messages)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("Target-count: 6", "Target-count: 7", "contains fewer or more targets than it states"),
        ("Run-count: 4", "Run-count: 3", "names an unknown run"),
        ("Run-count: 4", "Run-count: four", "is not a whole number"),
        ("   1     6     5.1", "   1     7     5.1", "names an unknown target"),
        ("   1     6     5.1", "   1     5     5.1", "a reading is given twice"),
        ("   1     6     5.1", "   1     6", "is not a row of run, target and deviation"),
        (
            "   1     6     5.1",
            "   1     6     5.1 7",
            ("is not a row of run, target and deviation"),
        ),
        ("   1     6     5.1", "   1     6     5,1", "decimal marks are mixed"),
        ("   1     6     5.1", "   1     6     nan", "is not a finite number"),
        ("Owner      : Linear", "Units : inch", "states a unit"),
        ("RUNS::", "HEADER::", "section HEADER:: is given twice"),
        ("EOF::", "EOF::\r\nHEADER::", "contains lines after the end mark EOF::"),
        ("File type  : rtl", "", "no line 'File type'"),
    ],
)
def test_damage(old: str, new: str, words: str) -> None:
    text = laser_file(TARGETS, READINGS)
    assert old in text
    assert words in refused(text.replace(old, new, 1))


def test_sections_in_small_letters() -> None:
    text = laser_file(TARGETS, READINGS).replace("HEADER::", "Header::").replace("EOF::", "eof::")
    assert told(read(text)) == told(read(laser_file(TARGETS, READINGS)))


def test_nothing_but_a_header() -> None:
    assert "contains no targets" in refused("HEADER::\r\nFile type  : rtl\r\n")


@pytest.mark.parametrize(
    ("machine", "encoding"), [("机床一号", "gbk"), ("Fräse", "latin-1"), ("Fräse 机", "utf-8")]
)
def test_text_of_users_in_old_code_pages(machine: str, encoding: str) -> None:
    content = laser_file(TARGETS, READINGS, machine=machine).encode(encoding)
    assert read(content).header["machine"] == machine


@pytest.mark.parametrize(
    ("written", "name"), [("X", "X"), ("x axis", "X"), ("Achse Y1", "Y1"), ("left gantry", "")]
)
def test_names_of_axes(written: str, name: str) -> None:
    test = read(laser_file(TARGETS, READINGS, axis=written))
    assert test.axis == name
    assert ("CW-R002" in told(test)) is not bool(name)
