"""Excel workbooks: one sheet per axis or a column of axes, every digit, and what is refused."""

from __future__ import annotations

import io
import re
import sys
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.reading import read_tests
from compwright.workflow.inputs.job_inputs import read_measurement
from one_test import read_positioning

Rows = Sequence[Sequence[Any]]
LONG = ("target_mm", "direction", "run", "deviation_um")
READINGS = [(0.512, "+", 1, 0.4), (100.274, "+", 1, 2.1), (100.274, "-", 1, -1.6)]
READINGS += [(0.512, "-", 1, -2.9)]


def workbook(sheets: Mapping[str, Rows]) -> bytes:
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(list(row))
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


def refused(content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        read_tests(content, "x.xlsx")
    return str(caught.value)


def test_one_sheet_reads_as_the_same_csv() -> None:
    test = read_positioning(workbook({"Data": [("# axis: X",), LONG, *READINGS]}), "x.xlsx")
    text = "# axis: X\n" + "\n".join(",".join(map(str, row)) for row in [LONG, *READINGS]) + "\n"
    plain = read_positioning(text.encode(), "x.csv")
    assert (test.name, test.axis) == ("x", "X")
    assert test.targets.tolist() == plain.targets.tolist()
    assert test.positive.tolist() == plain.positive.tolist()
    assert test.negative.tolist() == plain.negative.tolist()
    assert test.header == plain.header


@pytest.mark.parametrize("value", [0.3, 1 / 3, 1e-7, -12.345, 7, 1.25])
def test_every_digit(value: float) -> None:
    test = read_positioning(workbook({"X": [LONG, (1.5, "+", 1, value), (2, "+", 1, 0)]}), "x.xlsx")
    assert test.positive[0, 0] == value * (1.0 / 1000.0)
    assert "CW-R015" not in {finding.code for finding in test.findings}


def test_one_sheet_per_axis() -> None:
    sheets: dict[str, Rows] = {
        "X": [LONG, *READINGS],
        "Achse Y": [("# axis", "Y"), ("# unit", "um"), ("target_mm", "+1", "-1"), (0, 1.5, -0.5)],
        "Notes": [("made by", "N N")],
    }
    tests = read_tests(workbook(sheets), "m.xlsx")
    assert [(test.name, test.axis) for test in tests] == [("m X", "X"), ("m Achse Y", "Y")]
    assert len({test.sources[0].sha256 for test in tests}) == 2
    assert {test.sources[0].file for test in tests} == {"m.xlsx"}
    said = {finding.code: finding.message for finding in tests[0].findings}
    assert "axis: X, the name of the sheet" in said["CW-R001"]
    assert said["CW-R061"] == "Sheets that were left out: Notes."


@pytest.mark.parametrize("form", ["xlsx", "csv"])
def test_a_column_of_axes(form: str) -> None:
    rows: list[tuple[Any, ...]] = [("axis", *LONG)]
    rows += [
        (axis, *row[:3], row[3] * factor)
        for axis, factor in (("X", 1), ("Y", 2))
        for row in READINGS
    ]
    if form == "xlsx":
        content = workbook({"all": rows})
    else:
        content = "\n".join(",".join(map(str, row)) for row in rows).encode() + b"\n"
    x, y = read_tests(content, f"m.{form}")
    assert (x.axis, y.axis) == ("X", "Y")
    assert (y.positive == 2 * x.positive).all()
    assert "CW-R005" not in {finding.code for finding in x.findings}
    nameless = content.replace(b"\nY,", b"\n,", 1) if form == "csv" else b""
    if nameless:
        with pytest.raises(InputError, match=r"line 6: the row names no axis"):
            read_tests(nameless, "m.csv")


def test_a_foreign_sheet_by_a_profile() -> None:
    header = ("Soll [mm]", "Richtung", "Abweichung Ist - Soll [µm]")
    rows = [
        ("Protokoll",),
        header,
        *((t, {"+": "auf", "-": "ab"}[d], v) for t, d, _, v in READINGS),
    ]
    content = workbook({"X": rows, "Y": rows, "Info": [("a",)]})
    assert "no sheet contains a test" in refused(content)
    proposed = proposed_profile(content, "m.xlsx")
    assert not proposed.open
    profile = read_profile(proposed.text.encode(), "P.yaml")
    tests = read_tests(content, "m.xlsx", profile)
    assert [test.axis for test in tests] == ["X", "Y"]
    assert tests[0].positive[:, 0] * 1000 == pytest.approx([0.4, 2.1], rel=1e-15)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([LONG, (0, "+", 1, "=A1*2")], "contains a formula without a result"),
        ([LONG, (0, "+", 1, "n/a")], "x.xlsx, sheet S: line 2, column deviation_um"),
        ([LONG, ("#DIV/0!", "+", 1, 0.5)], "is not a number"),
        ([("target_mm", 1, -1), (0, 0.1, 0.2)], "do not show direction and run"),
        ([("a", "b"), (1, 2)], "no sheet contains a test"),
        ([], "empty sheets"),
    ],
)
def test_what_is_refused(rows: Rows, words: str) -> None:
    assert words in refused(workbook({"S": rows}))


def test_a_mixed_workbook_is_profiled_by_the_sheet_that_needs_it() -> None:
    """A cover, a sheet of plain CSV, and one of another program: none hides the other."""
    foreign = [("Soll [mm]", "Richtung", "Lauf", "Abweichung [µm]"), *READINGS]
    content = workbook({"Cover": [("Report",)], "X": [LONG, *READINGS], "Y": foreign})
    proposed = proposed_profile(content, "m.xlsx")
    assert proposed.notes[0] == "proposed for the sheet Y; X needs none"
    text = proposed.text.replace("\nsign:", "\nsign: measured minus target")
    tests = read_tests(content, "m.xlsx", read_profile(text.encode(), "P.yaml"))
    assert [test.axis for test in tests] == ["X", "Y"]


def test_files_that_only_begin_like_one() -> None:
    assert "a damaged archive" in refused(b"PK\x03\x04....")
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("a.txt", "text")
    assert "is a zip archive" in refused(stream.getvalue())
    whole = workbook({"X": [LONG, *READINGS]})
    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(whole)) as old, zipfile.ZipFile(stream, "w") as new:
        for name in old.namelist():
            content = old.read(name)
            new.writestr(name, content[: len(content) // 2] if "sheet1" in name else content)
    assert "cannot be opened" in refused(stream.getvalue())


def test_an_archive_that_unpacks_to_very_much() -> None:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("xl/workbook.xml", b" " * 81_000_000)
    assert "is too large when unpacked" in refused(stream.getvalue())


def changed(part: str, edits: Sequence[tuple[bytes, bytes, int]]) -> bytes:
    """Return a workbook with more in a part: before a piece of it another one, so many times."""
    stream = io.BytesIO()
    whole = io.BytesIO(workbook({"X": [LONG, *READINGS]}))
    with (
        zipfile.ZipFile(whole) as old,
        zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as new,
    ):
        for name in old.namelist():
            content = old.read(name)
            for piece, more, times in edits if name == part else ():
                content = content.replace(piece, more * times + piece, 1)
            new.writestr(name, content)
    return stream.getvalue()


_SHEET = "xl/worksheets/sheet1.xml"
_CLOSE = b"</sheetData>"


@pytest.mark.parametrize(
    ("part", "edits", "words"),
    [
        (_SHEET, [(_CLOSE, b'<row s="1"/>', 1_000_001)], "contains too many cells"),
        (_SHEET, [(_CLOSE, b"<x:c />", 1_000_001)], "contains too many cells"),
        (_SHEET, [(_CLOSE, b" ", 81_000_000)], "of sheets and texts"),
        ("xl/styles.xml", [(b"</styleSheet>", b" ", 9_000_000)], "of styles and names"),
        (
            _SHEET,
            [(b"<worksheet", b'<!DOCTYPE x [<!ENTITY a "9">]>', 1), (b"</v>", b"&a;", 1)],
            "declares a document type",
        ),
    ],
    ids=["rows", "cells", "sheet", "styles", "entities"],
)
def test_bombs_are_refused_before_openpyxl_sees_them(
    part: str,
    edits: Sequence[tuple[bytes, bytes, int]],
    words: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    content = changed(part, edits)
    monkeypatch.setattr(openpyxl, "load_workbook", None)
    assert words in refused(content)


def test_without_openpyxl(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    content = workbook({"X": [LONG, *READINGS]})
    assert f'"{sys.executable}" -m pip install openpyxl' in refused(content)


def test_a_copied_sheet_of_no_axis_beside_the_one_that_a_job_takes_is_told(tmp_path: Path) -> None:
    """The copy is what a spreadsheet program calls ``X (2)``: it may be the newer measurement."""
    file = tmp_path / "m.xlsx"
    other = [(target, way, run, -value) for target, way, run, value in READINGS]
    sheets = {"X": [LONG, *READINGS], "Y": [LONG, *other]}
    file.write_bytes(workbook(sheets))
    codes = [finding.code for finding in read_measurement(Session(), file, None, "X").findings]
    assert "CW-R061" not in codes
    file.write_bytes(workbook({**sheets, "X (2)": [LONG, *other]}))
    test = read_measurement(Session(), file, None, "X")
    assert test.positive[0, 0] == pytest.approx(0.0004)
    (told,) = [finding for finding in test.findings if finding.code == "CW-R061"]
    assert told.severity == "warning"
    assert "X (2)" in told.message
    assert "m Y" not in told.message


# ---------------------------------------------------------------- hidden


def hiding(*, rows: Sequence[int] = (), columns: Sequence[str] = (), state: str = "") -> bytes:
    """Two sheets of the same readings; the second hides something."""
    book = openpyxl.load_workbook(
        io.BytesIO(workbook({"X": [LONG, *READINGS], "Y & Z": [LONG, *READINGS, (None, None)]}))
    )
    sheet = book["Y & Z"]
    for row in rows:
        sheet.row_dimensions[row].hidden = True
    for column in columns:
        sheet.column_dimensions[column].hidden = True
    if state:
        sheet.sheet_state = state
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


def told_hidden(content: bytes) -> list[list[str]]:
    return [
        [one.message for one in test.findings if one.code == "CW-R064"]
        for test in read_tests(content, "x.xlsx")
    ]


def test_hidden_rows_are_read_and_told() -> None:
    """Rows without anything in them are nobody's loss."""
    open_, hidden = read_tests(hiding(rows=[3, 5, 9]), "x.xlsx")
    assert open_.positive.tolist() == hidden.positive.tolist()
    (first, (told,)) = told_hidden(hiding(rows=[3, 5, 9]))
    assert first == []
    assert "2 rows, hidden or filtered out (row 3, 5)" in told


def test_rows_that_a_filter_hides_are_told() -> None:
    """As a spreadsheet program saves a filter: the rows that do not pass are hidden."""
    book = openpyxl.load_workbook(io.BytesIO(workbook({"X": [LONG, *READINGS]})))
    sheet = book["X"]
    sheet.auto_filter.ref = "A1:D5"
    sheet.auto_filter.add_filter_column(1, ["+"])
    for row in (4, 5):
        sheet.row_dimensions[row].hidden = True
    stream = io.BytesIO()
    book.save(stream)
    ((told,),) = told_hidden(stream.getvalue())
    assert "2 rows, hidden or filtered out (row 4, 5)" in told


def test_hidden_columns_and_sheets_are_told() -> None:
    assert "1 column (D)" in told_hidden(hiding(columns=["D", "F"]))[1][0]
    for state in ("hidden", "veryHidden"):
        assert "the whole sheet" in told_hidden(hiding(state=state))[1][0]
    assert told_hidden(hiding()) == [[], []]


def test_rows_without_numbers_of_their_own_are_counted() -> None:
    """The number of a row may be left out (ECMA-376, 18.3.1.73): it is the next one."""
    content = hiding(rows=[3])
    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(stream, "w") as new:
        for name in old.namelist():
            part = old.read(name)
            new.writestr(name, re.sub(rb'(<row) r="\d+"', rb"\1", part))
    assert "1 row, hidden or filtered out (row 3)" in told_hidden(stream.getvalue())[1][0]
