"""HEIDENHAIN tables of newer controls, which describe their columns before the names, and the
correction between axes that goes into the user's own table.

The descriptions have the form of tables of other kinds that such controls export (pallets, cutting
data, tools: public with the reader github drunsinn/pyLSV2, tests/test_files). Columns of a .COM:
MANUALplus 620 technical manual p716.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from test_heidenhain_activity import MACHINE, OLD
from test_heidenhain_activity import run as run_activity
from test_run_apply import card, folder, measured, run  # noqa: F401 - two fixtures

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.controls import control
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import ControlFile, ControlState
from format_samples import DEFINITIONS, axis_of, correction, table
from loop import csv_of

pytestmark = pytest.mark.short_estimate

ITNC = DEFINITIONS["heidenhain-itnc530"]
NCK = DEFINITIONS["heidenhain-nck"]
NM = 1e-6  # mm: a thousandth of the smallest number that these files hold

OBJECT = """BEGIN X.COM MM Version: 'Update:110.24 Date:2004-08-01' U
TableDescription (
  columns:= [
    CfgColumnDescription (
      key:="NR",
      width:=6,
      unit:=INT,
      readonly:=TRUE
    ),
    CfgColumnDescription (
      key:="AXISPOS",
      width:=12,
      unit:=LENGTH
    ),
    CfgColumnDescription (
      key:="BACKLASH",
      width:=12
    ),
    CfgColumnDescription (
      key:="X",
      width:=12,
      minimum:="-0.0100",
      maximum:="+0.0100"
    ),
    CfgColumnDescription (
      key:="Y",
      width:=12
    )
  ],
  primaryKey:="NR"
)
NR    AXISPOS     BACKLASH    X           Y
0     -400                    +0.0000     +0.0002
1     -200                    -0.0018
2     +0                      +0.0007     +0.0001
[END]
"""
STRUCT = """BEGIN X .COM MM DATUM:-400 DIST:200
#STRUCTBEGIN
   NAME = 1=F()
     TYPE = N
     WIDTH = 9
     DEC = 3
*                // a remark
       DIA-ENGLISH = Error?
   NAME = 2=F()
     TYPE = N
     WIDTH = 9
     DEC = 4
#STRUCTEND
NR      1=F()     2=F()
0       +0.000    +0.0000
1       -0.002    +0.0001
2                 +0.0002
3       +0.001    +0.0003
END X .COM
"""


def file(name: str, text: str) -> ControlFile:
    return ControlFile(name, text.encode("latin-1"))


def read(text: str, form: str = NCK.id, **options: object) -> ControlState:
    return control_format(DEFINITIONS[form], options).read([file("X.COM", text)])


def filled(text: str, values: list[float], form: str = NCK.id) -> str:
    wanted = table("X", [-400.0 + 200 * k for k in range(len(values))], values)
    files = control_format(DEFINITIONS[form], {}).write(
        [wanted], [axis_of("X")], [file("X.COM", text)]
    )
    return files[0].content.decode("latin-1")


def um(state: ControlState, position: float) -> float:
    return 1000 * correction(state, "X", position, Direction.POSITIVE)


def test_a_described_table_is_read_by_the_places_of_its_columns() -> None:
    state = read(OBJECT)
    assert um(state, -200) == pytest.approx(1.8, abs=NM)
    assert um(state, -100) == pytest.approx(0.55, abs=NM)
    state = read(STRUCT, ITNC.id)
    assert um(state, -200) == pytest.approx(2.0, abs=NM)
    assert um(state, 0) == pytest.approx(0.5, abs=NM)  # blank: between 2.0 and -1.0


def test_only_cells_of_the_own_column_change_in_a_described_table() -> None:
    # the column of Y holds the grid
    wanted = filled(OBJECT, [0.001, -0.0021, 0])
    expected = OBJECT  # BACKLASH is the curve for travel in -: the same here
    for old, new in (("+0.0000", "-0.0010"), ("-0.0018", "+0.0021"), ("+0.0007", "+0.0000")):
        expected = expected.replace(" " * 12 + old, f"{new:<12}{new}")
    assert wanted == expected
    assert filled(STRUCT, [0.001, 0, 0, -0.002], ITNC.id) == STRUCT.replace(
        "0       +0.000 ", "0       -0.0010"
    ).replace("-0.002 ", "+0.0000").replace("2                 ", "2       +0.0000   ").replace(
        "+0.001 ", "+0.0020"
    )


@pytest.mark.parametrize(
    ("text", "values", "form", "why"),
    [
        (OBJECT, [0, -0.0101, 0], NCK.id, r"X of X.COM, which takes -0.0100 .. 0.0100"),
        (STRUCT, [0, -0.0015, 0, 0], ITNC.id, r"1=F\(\) of X.COM, which holds 3 decimals"),
        (
            OBJECT.replace('      minimum:="-0.0100",', "      readonly:=TRUE,"),
            [0, 0.001, 0],
            NCK.id,
            "read only",
        ),
    ],
)
def test_what_a_column_takes_by_its_own_description_is_honoured(
    text: str, values: list[float], form: str, why: str
) -> None:
    with pytest.raises(CapacityError, match=why):
        filled(text, values, form)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("  primaryKey", "  ( primaryKey", "no end"),
        ('key:="X",', 'key:="X",\n      unitIsInch:=TRUE,', "described in inch"),
        ("U\nTable", "V\nTable", "first line cannot be read"),
        ("NR    AXISPOS", "KEY   AXISPOS", "names of the columns are missing"),
    ],
)
def test_a_bad_description_is_refused(old: str, new: str, why: str) -> None:
    assert old in OBJECT
    with pytest.raises(InputError, match=why):
        read(OBJECT.replace(old, new))


def test_the_rows_may_be_numbered_by_another_key() -> None:
    state = read(OBJECT.replace("NR ", "KEY").replace('"NR"', '"KEY"'))
    assert um(state, -200) == pytest.approx(1.8, abs=NM)


# --- a correction between axes goes into the user's own table


def com(rows: int, step: int, start: int = -50) -> str:
    lines = "".join(
        f"{k:<6d}{start + step * k:<+12.1f}{0:<+12.4f}{0.0010 * (k % 2):<+12.4f}\n"
        for k in range(rows)
    )
    return f"BEGIN X.COM MM\nNR    AXISPOS     X           Y\n{lines}[END]\n"


CMA = "BEGIN CONFIG.CMA MM\nNR    ACTIVE  X       Y       Z\n0     *       X.COM\n[END]\n"
PLAY = "# axis: {}\n# value: error\npoint,position,value,unit\nbackLash,,0.0000,mm\n"


def states(place: Path, text: str) -> str:
    """Files that leave no value open; without a backlash of X the result would be in doubt."""
    (place / "X.COM").write_text(text)
    (place / "CONFIG.CMA").write_text(CMA)
    (place / "play.csv").write_text(PLAY.format("X"))
    return "[X.COM, CONFIG.CMA, play.csv]"


def test_squareness_goes_into_the_column_of_the_bent_axis(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Y leans by + 40 µm/m of the distance of X from its reference, 0: values are errors, and what
    stood in the column (0 and 1 µm in turn) stays in the total.
    """
    text = com(19, 50)
    assert run(folder, NCK.id, states=states(folder, text)) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert "in X.COM, column Y (the values there are errors)" in printed
    loaded = folder / "job" / "tables" / NCK.id
    assert sorted(path.name for path in loaded.iterdir()) == ["CONFIG.CMA", "X.COM", "play.csv"]
    for name in ("CONFIG.CMA", "play.csv"):
        assert (loaded / name).read_text() == (folder / name).read_text()
    new = (loaded / "X.COM").read_text()
    rows = [line.split() for line in new.splitlines()[2:-1]]
    x = np.array([float(row[1]) for row in rows])
    was = 0.001 * (np.arange(19) % 2)
    np.testing.assert_allclose(  # mm: the squareness is known to 1 µm/m, over 0.85 m
        [float(row[3]) for row in rows], was - 40e-6 * x, atol=9.5e-4
    )
    # every other character stays
    assert [line[:30] for line in new.splitlines()] == [line[:30] for line in text.splitlines()]
    step = next(line for line in card(folder).splitlines() if "X.COM, column Y" in line)
    assert step
    assert not (folder / "job" / "card" / "cross_X_Y.csv").exists()
    judge = virtual_control(
        NCK.id, [ControlFile(path.name, path.read_bytes()) for path in loaded.iterdir()]
    )
    assert judge.cross_correction("X", "Y", np.array([0.0, 800.0]), Direction.POSITIVE) == (
        pytest.approx([-0.001, -0.001 + 0.032], abs=9e-4)
    )


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (com(15, 50), "X.COM reaches from -50 to 650, the correction from 0 to 800"),
        (com(19, 50).replace("   Y\n", "   Z\n"), "X.COM has no column Y"),
        (com(19, 50).replace(".COM MM", ".COM INCH"), "X.COM is in inch"),
    ],
)
def test_where_the_table_has_no_place_the_sheet_comes_as_before(
    folder: Path,  # noqa: F811
    text: str,
    why: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (folder / "Y.csv").write_text(PLAY.format("Y") + "linearCompValue,,0.0,mm/m\n")
    assert run(folder, NCK.id, states=states(folder, text).replace("]", ", Y.csv]")) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert f"({why})." in printed
    assert "Replace the values in X.COM, column Y by these: " in printed
    assert (folder / "job" / "card" / "cross_X_Y.csv").exists()
    assert not (folder / "job" / "tables").exists()


@pytest.mark.real_pages
def test_an_axis_without_a_table_in_the_active_line_gets_the_sheet(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The cell of Y in the active line is blank, so Y has no table. Its parameters are in no file:
    they are doubts, and the sheet is there.
    """
    text = com(19, 50).replace("   Y\n", "   Z\n")
    assert run(folder, NCK.id, states=states(folder, text)) == 1
    printed = " ".join(capsys.readouterr().out.split())
    assert "(X.COM has no column Y). Replace the values in X.COM, column Y by these:" in printed
    job = folder / "job.yaml"
    job.write_text(job.read_text() + "report: {language: de}\n")
    assert compwright(["run", str(job), "--force"]) == 1
    page = " ".join((folder / "job" / "report.html").read_text(encoding="utf-8").split())
    assert "(X.COM hat keine Spalte Y)" in page
    assert "außerhalb der Tabellen" in page
    assert "the end values" not in page
    for name in ("backLash", "linearCompValue"):
        assert f"axis Y: {name} is not in the files; 0 is assumed" in printed
    assert (folder / "job" / "card" / "cross_X_Y.csv").exists()


def test_an_axis_in_no_file_is_refused_with_the_files_that_would_name_it(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    (folder / "X.COM").write_text(com(19, 50).replace("   Y\n", "   Z\n"))
    assert run(folder, NCK.id, states="[X.COM]") == 3
    printed = " ".join(capsys.readouterr().err.split())
    for words in (
        "a .CMA or .COM with a column of Y",
        "backLash or linearCompValue of Y",
        "axes X, Z",
    ):
        assert words in printed
    assert "slope" not in printed


@pytest.mark.parametrize("bit", ["1", "0"])
def test_a_column_of_an_axis_whose_bit_is_0_is_not_filled(
    folder: Path,  # noqa: F811
    bit: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    rows = "".join(f"{k:<5d}+0.0000   +0.0000\n" for k in range(5))
    (folder / "X.COM").write_text(
        f"BEGIN X .COM MM DATUM:0 DIST:200\nNR   1=F()     2=F()\n{rows}END X .COM\n"
    )
    (folder / "MP.TXT").write_text(
        f"MP710.0 : 0.0\nMP710.1 : 0.0\nMP720.0 : 0.0\nMP720.1 : 0.0\nMP730 : %000{bit}1\n"
    )
    (folder / "CONFIG.CMA").write_text("BEGIN CONFIG .CMA MM\nNR   1\n0    X\nEND CONFIG .CMA\n")
    assert run(folder, ITNC.id, states="[X.COM, MP.TXT, CONFIG.CMA]") == 0
    printed = " ".join(capsys.readouterr().out.split())
    if bit == "0":
        assert "the bit of Y in MP730 is 0: no table is active on it" in printed
        return
    assert "in X.COM, column 2=F() (the values there are errors)" in printed
    last = (folder / "job" / "tables" / ITNC.id / "X.COM").read_text().splitlines()[-2].split()
    assert [float(word) for word in last] == [4, 0, pytest.approx(-0.032, abs=9e-4)]


def test_beside_a_table_of_the_moving_axis_and_an_old_sheet(folder: Path) -> None:  # noqa: F811
    """X gets a table of its own in the same file; its backlash was stated by a sheet."""
    given = states(folder, com(19, 50))
    x = "before: [x.csv], table: {start: -50, end: 850, spacing: 50}"
    assert run(folder, NCK.id, states=given, x=x) == 0
    loaded = folder / "job" / "tables" / NCK.id
    assert sorted(path.name for path in loaded.iterdir()) == ["CONFIG.CMA", "X.COM", "entry_X.csv"]
    rows = [line.split() for line in (loaded / "X.COM").read_text().splitlines()[2:-1]]
    assert any(float(row[2]) for row in rows)
    assert float(rows[17][3]) == pytest.approx(0.001 - 0.032, abs=9e-4)


# --- a switch that no file holds is listed


@pytest.mark.parametrize(
    ("files", "value"),
    [
        ({"X.COM": STRUCT.replace("002", "000").replace("+0.001 ", "+0.000 ")}, "table of zeros"),
        ({"MP.TXT": "MP710.0 : 0.0\n"}, "0: no table is active"),
        ({"entry_X.csv": "point,position,value,unit\n0,0,0.001,mm\n1,9,0,mm\n"}, "1: its table"),
    ],
)
def test_what_a_missing_mp730_was_taken_as_is_listed(files: dict[str, str], value: str) -> None:
    sources = [
        file(name, text.replace("point,", "# value: error\npoint,", 1))
        for name, text in files.items()
    ]
    state = control_format(ITNC, {}).read(sources, [axis_of("X")])
    assert any("MP730" in one.fact and value in one.value for one in state.assumed)


def test_a_line_beside_a_table_of_zeros_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """MP720 of 0.02 mm/m acts only while the bit is 0 (TNC 407 technical manual p151)."""
    files = {"mp": "MP710.0 : 0.0\nMP720.0 : 0.0200\n"}
    assert run_activity(tmp_path, ITNC.id, values=0 * OLD, files=files) == 2
    printed = capsys.readouterr().err
    assert "MP720 is not zero. It is active only if no table is selected" in printed
    assert "no file contains the switch MP730" in printed
    columns = []
    for answer in ("yes", "no"):
        assert run_activity(tmp_path, ITNC.id, f", active: {answer}", 0 * OLD, files) == 0
        lines = (tmp_path / "job" / "tables" / ITNC.id / "X.COM").read_text().splitlines()[2:-1]
        columns.append([float(line.split()[-1]) for line in lines])
    # 0.02 mm/m too far over the 800 mm from the reference
    assert columns[1][17] - columns[0][17] == pytest.approx(0.016, abs=2.01e-4)


# --- the job counts axes its own way


def test_the_job_tells_both_readers_how_the_control_counts_an_axis(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The control's axis 4 is Z: column 4=F(), index and bit 3."""
    rows = "0    +0        +0.0010\n1    +0        -0.0020\n"
    text = f"BEGIN Z .COM MM DATUM:0 DIST:400\nNR   1=F()     4=F()\n{rows}END Z .COM\n"
    axis = Axis(name="Z", kind=AxisKind.LINEAR, travel=(0.0, 400.0), address="Z", axis_number=4)
    files = [file("Z.COM", text), file("MP.TXT", "MP710.3 : 0.0\nMP720.3 : 0\nMP730 : %01000\n")]
    told: list[object] = []

    def judge(*_: object, **given: object) -> object:
        told.append(given["axis_number"])
        raise InterruptedError

    monkeypatch.setattr(control, "virtual_control", judge)
    with pytest.raises(InterruptedError):
        control.decode(control.open_control(Session(), ITNC.id, {}), files, [axis])
    assert told == [{"Z": 4}]


def test_a_column_by_the_number_of_the_job_is_read_by_both(tmp_path: Path) -> None:
    """decode raises where the two readers do not agree; without the number 4=F() is A."""
    rows = "0    +0        +0.0010\n1    +0        -0.0020\n"
    text = f"BEGIN Z .COM MM DATUM:0 DIST:400\nNR   1=F()     4=F()\n{rows}END Z .COM\n"
    axis = Axis(name="Z", kind=AxisKind.LINEAR, travel=(0.0, 400.0), address="Z", axis_number=4)
    files = [file("Z.COM", text), file("MP.TXT", "MP710.3 : 0.0\nMP720.3 : 0\nMP730 : %01000\n")]
    state = control.decode(control.open_control(Session(), ITNC.id, {}), files, [axis]).state
    assert 1000 * correction(state, "Z", 400, Direction.POSITIVE) == pytest.approx(2, abs=NM)


# --- the grid that is there stays


@pytest.mark.parametrize("form", [ITNC.id, NCK.id])
def test_the_rows_of_the_own_table_stay(tmp_path: Path, form: str) -> None:
    nodes = np.arange(-37.0, 900.0, 61.0)  # no grid that anybody would choose
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    rows = "".join(
        f"{k:<6d}{x:<+12.1f}+0.0000\n" if form == NCK.id else f"{k:<6d}+0.0000\n"
        for k, x in enumerate(nodes)
    )
    head = (
        "BEGIN X.COM MM\nNR    AXISPOS     X\n"
        if form == NCK.id
        else "BEGIN X .COM MM DATUM:-37 DIST:61\nNR    1=F()\n"
    )
    text = f"{head}{rows}" + ("[END]\n" if form == NCK.id else "END X .COM\n")
    (tmp_path / "X.COM").write_text(text)
    name = "backLash" if form == NCK.id else "MP710"
    (tmp_path / "p.csv").write_text(PLAY.format("X").replace("backLash", name))
    (tmp_path / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {form}}}\nstates: {{as_found: [X.COM, p.csv]}}\n"
        "axes:\n  X: {travel: [0, 800], before: [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    new = (tmp_path / "job" / "tables" / form / "X.COM").read_text()
    cut = 18 if form == NCK.id else 6
    assert [line[:cut] for line in new.splitlines()] == [line[:cut] for line in text.splitlines()]
    assert new != text
