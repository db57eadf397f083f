"""What is not a positioning file: the message says what was found and what is accepted."""

from __future__ import annotations

import pytest

from compwright.foundations.errors import InputError
from next_steps import MARK
from one_test import read_positioning
from places import REAL, needs_shared


def fault(content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        read_positioning(content, "f.csv")
    (line,) = str(caught.value).split("\n")
    assert line.startswith("f.csv: ")
    return line


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"\xef\xbb\xbf", "is empty"),
        (b" \r\n\t\n,;\n"[:4], "is empty"),
        (b"# axis: X\n", "contains comment lines only"),
        (b"target_mm,direction,run,deviation_um\n", "contains no readings"),
        (b"# unit: um\ntarget_mm,+1,-1\n0,,\n", "contains no readings"),
        (b"target_mm,direction\x00\n", "is a binary file"),
        (b"\x7fELF\x02\x01", "is a binary file"),
        (b"\x93\x00\x01\xff", "is a binary file"),
        (b"PK\x03\x04....", "an Excel workbook"),
        (b"\xd0\xcf\x11\xe0....", "an old Excel workbook"),
        (
            "# operator: Müller\ntarget_mm\n".encode("latin-1"),
            "line 1: the file is not text in a known encoding",
        ),
        (b"# a\r# b\r\n# c\n\xff", "line 4: the file is not text in a known encoding"),
        (b"\xff\xfea", "is not text in a known encoding"),
        (b"<html><body>", "found XML or HTML"),
        (b'{"schema": "compwright/plan/1"}', "JSON"),
        (b"point,position,value,unit\n1,0,0.5,um\n", "typed-entry sheet"),
        (b"0.000,+,1,-2.6\n", "a row of numbers where the header row should be"),
        (b"target_mm direction run deviation_um\n0 + 1 2\n", "without comma, semicolon or tab"),
        (b"time,reading_um\n08:00,0.1\n", "rename the columns to time_min and deviation_um"),
        (b"Elapsed time (min);Value\n0;0.1\n", "stand-still test (axis at rest) have other names"),
        (b"Messwert;Soll\n1;2\n", "found 'Messwert;Soll' as the first row"),
        (b'"target_mm,direction\n', "line 1: the header row"),
        (b"direction,angle_deg,radius_mm\nccw,0,100\n", "contains a circular test"),
        (b"# compwright: circular 1\nx,y\n", "contains a circular test"),
    ],
)
def test_other_files(content: bytes, words: str) -> None:
    line = fault(content)
    assert words in line
    assert "; expected " in line or "quotation mark" in line
    assert MARK in line


def test_the_accepted_forms_are_named() -> None:
    line = fault(b"a,b\n1,2\n")
    assert "is not a positioning file" in line
    assert "plain CSV" in line
    assert "TGT_DATA" in line
    assert "time_min and deviation_um" in line


@needs_shared
@pytest.mark.parametrize("name", ["ballbar_demo_100mm_XY.b5r", "ballbar_qc20w_150mm_ZX_220deg.b5r"])
def test_a_ballbar_file(name: str) -> None:
    assert "contains a circular test" in fault((REAL / "ballbar" / name).read_bytes())


@needs_shared
def test_a_rotary_log_in_columns_of_its_own() -> None:
    with pytest.raises(InputError) as caught:
        read_positioning(
            (REAL / "rotary" / "ess_tank_axis_repeatability.csv").read_bytes(), "f.csv"
        )
    text = str(caught.value)
    assert "line 4: the value column is missing" in text
    assert "column 'direction' is missing" in text
    assert "column 'run' is missing" in text
    assert "openloop_deg" in text
