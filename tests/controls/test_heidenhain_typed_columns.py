"""HEIDENHAIN: a correction between axes that is typed in leaves the machine as predicted.

The control is worked out by hand from the manuals: point k of a .COM is at DATUM + k times DIST,
straight lines between the points, the end values hold outside; a column that states errors adds the
opposite of its values; it is active on its axis only while the bit of that axis in MP730 is 1, and
so is every other column of this axis (TNC 407 technical manual p151 and p153, iTNC 530).
The circle finds that Y leans by 40 µm/m over X, with whatever was active while it was measured.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from test_heidenhain_described import PLAY, com
from test_run_apply import card, folder, measured, prediction, run  # noqa: F401 - two fixtures
from test_run_circles import Bent, write_circle

from compwright.cli import run as compwright
from loop import Floats

pytestmark = pytest.mark.short_estimate

ITNC, NCK = "heidenhain-itnc530", "heidenhain-nck"
LEAN = 40e-6  # of Y over X; the correction of Y is + 40 µm/m times the distance of X from 0
MEASURED = 1e-6  # the circle knows it to 1 µm/m
LINE = "BEGIN CONFIG .CMA MM\nNR   1         2\n0    X         Y\nEND   CONFIG .CMA\n"
PARAMETERS = "MP710.0 : 0.0\nMP710.1 : 0.0\nMP720.0 : 0.0\nMP720.1 : 0.0\n"
X = np.arange(0.0, 801.0, 50.0)
OWN, SAG = 1e-5, -2.5e-5  # mm of error for each mm: column 1=F() and column 2=F() of X.COM


def x_com(
    sag: float = SAG, *, datum: float = 0, dist: float = 100, rows: int = 9, unit: str = "MM"
) -> str:
    decimals = 4  # also in inch, where the last one is 2.5 µm: too coarse for the totals
    text = f"BEGIN X      .COM {unit} DATUM:{datum:g} DIST:{dist:g}\nNR   1=F()     2=F()\n"
    for k in range(rows):
        where = datum + k * dist
        text += f"{k:<5d}{OWN * where:<+10.{decimals}f}{sag * where:<+10.{decimals}f}".rstrip()
        text += "\n"
    return f"{text}END   X      .COM\n"


def y_com(own: float = 1e-5) -> str:
    rows = "".join(f"{k:<5d}          {own * 100 * k:+.4f}\n" for k in range(6))
    head = "BEGIN Y      .COM MM DATUM:-500 DIST:100\nNR   1=F()     2=F()\n"
    return f"{head}{rows}END   Y      .COM\n"


def files(folder: Path, texts: Mapping[str, str]) -> str:  # noqa: F811
    for name, text in texts.items():
        (folder / name).write_text(text)
    return f"[{', '.join(texts)}]"


def column(text: str, number: int) -> tuple[Floats, Floats]:
    """Positions and values of a column, mm, by the first line of the table."""
    head = text.splitlines()[0]
    factor = 25.4 if "INCH" in head else 1.0
    words = dict(re.findall(r"(DATUM|DIST):(\S+)", head))
    datum, dist = float(words["DATUM"]), float(words["DIST"])
    rows = [line.split() for line in text.splitlines()[2:-1]]
    values = np.array([float(row[number]) for row in rows])
    where: Floats = factor * (datum + dist * np.arange(len(rows), dtype=float))
    return where, factor * values


def added_to_y(text: str, where: Floats) -> Floats:
    """What column 2=F() of X.COM adds to Y while its bit is 1, mm: the opposite of the errors."""
    return -np.interp(where, *column(text, 2))


def sheet(folder: Path) -> tuple[str, list[list[str]]]:  # noqa: F811
    lines = (folder / "job" / "card" / "cross_X_Y.csv").read_text(encoding="utf-8").splitlines()
    return lines[0], [line.split(",") for line in lines[3:]]


def followed(folder: Path, text: str) -> str:  # noqa: F811
    """X.COM after the engineer did what the sheet and the card say: the totals of the sheet in
    column 2=F(), a row for each of them; a new row has the other values of its nearest old row.
    """
    head, rows = sheet(folder)
    assert "totals, in place of the values there" in head
    where = np.array([float(row[0]) for row in rows])
    factor = 25.4 if "positions in inch" in head else 1.0
    old, own = column(text, 1)
    kept = np.interp(where, old / factor, own / factor)
    steps = np.diff(where)
    np.testing.assert_allclose(steps, steps[0])  # rows that a table with DATUM and DIST can have
    first, names, *_ = text.splitlines()
    first = re.sub(r"DATUM:\S+", f"DATUM:{where[0]:g}", first)
    assert f"DIST:{steps[0]:g}" in first
    body = [f"{k:<5d}{kept[k]:<+10.5f}{row[1]}" for k, row in enumerate(rows)]
    return "\n".join([first, names, *body, "END   X      .COM"]) + "\n"


# --- what is not active now


@pytest.mark.parametrize(
    ("sag", "own", "cma", "named"),
    [
        (SAG, 1e-5, True, "X.COM, column 2=F(), Y.COM, column 2=F()"),
        (SAG, 0.0, True, "X.COM, column 2=F()"),
        (0.0, 1e-5, True, "Y.COM, column 2=F()"),
        (SAG, 1e-5, False, "X.COM, column 2=F(), Y.COM, column 2=F()"),
        (0.0, 0.0, False, "give the .CMA and every .COM"),
    ],
)
def test_what_the_bit_would_activate_besides_refuses_the_plane(
    *,
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    sag: float,
    own: float,
    cma: bool,
    named: str,
) -> None:
    """With the bit of Y at 1, every column of Y is active: also those that were not when the circle
    was measured.
    """
    texts = {"X.COM": x_com(sag), "Y.COM": y_com(own), "MP.TXT": f"{PARAMETERS}MP730 : %00001\n"}
    if cma:
        texts["CONFIG.CMA"] = LINE
    assert run(folder, ITNC, states=files(folder, texts)) == 1
    printed = " ".join(capsys.readouterr().out.split())
    assert "error CW-P113" in printed
    assert "the bit of Y in MP730" in printed
    assert named in printed
    assert not (folder / "job" / "card" / "cross_X_Y.csv").exists()
    assert not (folder / "job" / "tables").exists()
    circle = prediction(folder)["circles"]["xy-150"]
    assert circle["predicted"]["squareness"]["median"] == pytest.approx(40, abs=1)


def test_the_answer_not_active_wakes_no_table_of_the_axis_either(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    """MP730 is in no file, and the job says that nothing was active: Y.COM would be, with the bit
    that the column of Y in X.COM needs.
    """
    texts = {"X.COM": x_com(0.0), "Y.COM": y_com(), "CONFIG.CMA": LINE, "MP.TXT": PARAMETERS}
    given = files(folder, texts)
    assert run(folder, ITNC, states=f"{{files: {given}, active: no}}") == 1
    printed = " ".join(capsys.readouterr().out.split())
    assert "the bit of Y in MP730 would also activate" in printed
    assert "(Y.COM, column 2=F())" in printed
    assert not (folder / "job" / "tables").exists()


@pytest.mark.parametrize(
    ("answer", "method", "harm"),
    [
        ("no", "table", "which would activate the values in X.COM (Y over X)"),
        ("yes", "table", ""),
        ("no", "line", ""),
        ("yes", "line", "which would switch off the active values in X.COM (Y over X)"),
    ],
)
def test_the_bit_of_an_axis_changes_no_column_of_another_table(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    answer: str,
    method: str,
    harm: str,
) -> None:
    """Y is corrected, and the sheet sets its bit in MP730: 1 for a table, 0 for MP720. Column 2=F()
    of X.COM, active or not by the job's answer, must stay so.
    """
    rise = {"no": 0.5, "yes": 0.6}[answer] + {"table": 0.0, "line": 0.2}[method]
    lines = ["# axis: Y", "target_mm,direction,run,deviation_um"]
    for turn in range(1, 6):
        for way, sign in (("+", 1), ("-", -1)):
            lines += [f"{50 * k - 500},{way},{turn},{rise * k:.1f}" for k in range(11)[::sign]]
    (folder / "y.csv").write_text("\n".join(lines) + "\n")
    texts = {"X.COM": x_com(), "Y.COM": y_com(), "CONFIG.CMA": LINE, "MP.TXT": PARAMETERS}
    states = f"{{files: {files(folder, texts)}, active: {answer}}}"
    y = f"before: [y.csv], options: {{method: {method}}}"
    assert (run(folder, ITNC, states=states, y=y, apply="{}") == 4) is bool(harm)
    printed = capsys.readouterr().err
    assert harm in printed
    assert ("the bit of Y in MP730" in printed) is bool(harm)
    step = {"no": "set the bit to 1", "yes": "choose `method: table` for this axis"}[answer]
    assert (f"Next: {step}, or empty these columns; repeat the test" in printed) is bool(harm)
    assert (folder / "job" / "tables").exists() is not bool(harm)


@pytest.mark.parametrize(
    ("control", "texts", "why"),
    [
        # A mark in the line would activate every table that it names, not only the new column.
        (
            NCK,
            {
                "X.COM": com(19, 50),
                "CONFIG.CMA": "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X       Y\n0           X.COM\n[END]\n",
                "play.csv": PLAY.format("X"),
                "Y.csv": PLAY.format("Y") + "linearCompValue,,0.0,mm/m\n",
            },
            "no line of CONFIG.CMA is active",
        ),
        # The column of Y in X.COM would also bend Y by its own motion.
        (
            ITNC,
            {
                "X.COM": x_com(0.0),
                "CONFIG.CMA": LINE.replace("X         Y", "X         X"),
                "MP.TXT": f"{PARAMETERS}MP730 : %00011\n",
            },
            "X.COM is active for the motion of several axes: X, Y",
        ),
    ],
    ids=["no active line", "a table of two axes"],
)
def test_a_column_that_would_act_on_more_is_not_typed(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    control: str,
    texts: dict[str, str],
    why: str,
) -> None:
    assert run(folder, control, states=files(folder, texts)) == 1
    assert why in " ".join(capsys.readouterr().out.split())
    assert not (folder / "job" / "card" / "cross_X_Y.csv").exists()


def test_a_bit_of_0_with_empty_columns_is_set_by_the_card(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    texts = {
        "X.COM": x_com(0.0),
        "Y.COM": y_com(0.0),
        "CONFIG.CMA": LINE,
        "MP.TXT": f"{PARAMETERS}MP730 : %00001\n",
    }
    assert run(folder, ITNC, states=files(folder, texts)) == 0
    assert "the bit of Y in MP730 is 0: no table is active on it" in " ".join(
        capsys.readouterr().out.split()
    )
    assert "Set the bit of Y in MP730 to 1." in card(folder)
    after = added_to_y(followed(folder, texts["X.COM"]), X)
    np.testing.assert_allclose(after, LEAN * X, atol=800 * MEASURED + 1e-4)


# --- totals, in the rows and the unit of the table


@pytest.mark.parametrize(
    ("text", "more", "unit"),
    [
        (x_com(datum=200, rows=5), True, "mm"),
        (x_com(datum=130, rows=5), True, "mm"),  # rows at 30 and -70, 630 to 830
        (x_com(dist=8, rows=5, unit="INCH"), False, "inch"),  # to 32 inch, 812.8 mm
        (x_com(datum=8, dist=8, rows=2, unit="INCH"), True, "inch"),
    ],
)
def test_the_sheet_has_the_totals_of_every_row(
    *,
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    text: str,
    more: bool,
    unit: str,
) -> None:
    """Typed in, the column adds what it adds now and the correction, over the whole travel, and the
    other column stays as it is.
    """
    texts = {
        "X.COM": text,
        "Y.COM": y_com(),
        "CONFIG.CMA": LINE,
        "MP.TXT": f"{PARAMETERS}MP730 : %00011\n",
    }
    assert run(folder, ITNC, states=files(folder, texts)) == 0
    printed = " ".join(capsys.readouterr().out.split())
    step = card(folder)
    assert "Replace the values in X.COM, column 2=F() by these:" in printed
    assert "Replace the values in X.COM, column 2=F() by:" in step
    for one in (printed, step):
        assert "Add" not in one
        assert f" {unit} at " in one
    assert ("The table gets more rows" in step) is more
    assert {row[2] for row in sheet(folder)[1]} == {unit}
    assert {len(row[1].partition(".")[2]) for row in sheet(folder)[1]} == {4 if unit == "mm" else 5}
    after = followed(folder, text)
    expected = added_to_y(text, X) + LEAN * X
    steps = np.diff(column(after, 2)[0])[0]
    # the circle's 1 µm/m, half of the last digit, and old ends that hold only up to the next row
    bend = abs(SAG) * steps if "DATUM:130" in text else 0.0
    np.testing.assert_allclose(added_to_y(after, X), expected, atol=800 * MEASURED + 1.3e-4 + bend)
    for where in column(text, 2)[0]:
        np.testing.assert_allclose(
            added_to_y(after, where),
            added_to_y(text, where) + LEAN * where,
            atol=800 * MEASURED + 1.3e-4,
        )
    np.testing.assert_allclose(
        np.interp(X, *column(after, 1)), np.interp(X, *column(text, 1)), atol=1e-4
    )


@pytest.mark.parametrize(("dist", "held"), [(90, True), (180, False), (60, False)])
def test_the_table_of_a_rotary_axis_gets_totals_in_its_own_rows(
    *,
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    dist: float,
    held: bool,
) -> None:
    """Y moves by 5 µm over C, with a bend at every 90 degrees. Each row gets what it has now and
    this; the control uses only rows from 0 to 360 degrees, so none is added outside.
    """
    old = np.array([0.0, 0.001, 0.002, 0.003, 0.0])
    rows = "".join(f"{k:<5d}{value:+.4f}   +0.0000\n" for k, value in enumerate(old))
    texts = {
        "Y.COM": y_com(0.0),
        "C.COM": f"BEGIN C      .COM MM DATUM:0 DIST:{dist}\nNR   2=F()     6=F()\n{rows}END   C .COM\n",
        "CONFIG.CMA": "BEGIN CONFIG .CMA MM\nNR   2         6\n0    Y         C\nEND   CONFIG .CMA\n",
        "MP.TXT": "".join(f"MP710.{axis} : 0.0\nMP720.{axis} : 0.0\n" for axis in (1, 5))
        + "MP730 : %100010\n",
    }
    job = folder / "job.yaml"
    job.write_text(
        f"compwright: 1\ncontroller: {{format: {ITNC}}}\nstates: {{as_found: {files(folder, texts)}}}\n"
        "axes:\n  Y: {travel: [-500, 0], address: Y, before: []}\n"
        "  C: {travel: [0, 360], kind: rotary, modulo: 360, address: C, before: []}\n"
        "cross:\n  - {input: C, output: Y, positions: [0, 90, 180, 270, 360],"
        " deviations: [0, 5, 0, -5, 0], unit: um}\n"
    )
    assert compwright(["run", str(job)]) == (0 if held else 1)
    printed = " ".join(capsys.readouterr().out.split())
    file = folder / "job" / "card" / "cross_C_Y.csv"
    assert file.exists() is held
    if not held:
        why = "has no row at a position" if dist == 180 else "reaches from 0 to 240"
        assert f"is not corrected: C.COM {why}" in printed
        return
    head, *lines = file.read_text(encoding="utf-8").splitlines()
    assert "totals, in place of the values there" in head
    values = np.array([float(line.split(",")[1]) for line in lines[2:]])
    np.testing.assert_allclose(values - old, [0.0, 0.005, 0.0, -0.005, 0.0], atol=1e-9)


def test_a_table_that_is_not_among_the_files_is_added_to(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Message, card and sheet say the same."""
    assert run(folder, ITNC) == 0
    where = "the values in the table (.COM) of X, column of Y"
    assert f"Add these to {where}: " in " ".join(capsys.readouterr().out.split())
    step = card(folder)
    assert f"Add to {where}: " in step
    assert "If it is 0, and MP720 of Y or one of its columns in any table is not 0, leave" in step
    assert sheet(folder)[0] == "# column of Y in the table of X: add to the values there"


# --- what was typed in, read back


def scaled_column(text: str, factor: float) -> str:
    """A table with the values of column 2=F() multiplied."""
    head, names, *rows, end = text.splitlines()
    body = [
        f"{k:<5}{own:<10}{factor * float(value):+.4f}" for k, own, value in map(str.split, rows)
    ]
    return "\n".join([head, names, *body, end]) + "\n"


def own_column(text: str) -> str:
    """A table without column 2=F()."""
    head, _, *rows, end = text.splitlines()
    body = [" ".join(row.split()[:2]) for row in rows]
    return "\n".join([head, "NR   1=F()", *body, end]) + "\n"


def test_what_was_typed_in_is_compared_with_the_sheet(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The circle is as planned in every case: a value that is not that of the sheet, or the table
    as it was, is never good, and never the same. The sheet gives the table more rows.
    """
    texts = {
        "X.COM": x_com(datum=200, rows=5),
        "Y.COM": y_com(),
        "CONFIG.CMA": LINE,
        "MP.TXT": f"{PARAMETERS}MP730 : %00011\n",
    }
    assert run(folder, ITNC, states=files(folder, texts)) == 0
    sheet_followed = followed(folder, texts["X.COM"])
    write_circle(folder / "after.csv", Bent(squareness=0.0).circle(8))
    back = folder / "back"
    back.mkdir()
    words = ["verify", str(folder / "job.yaml"), "--after", str(folder / "after.csv"), "--force"]
    differs = "correction of Y over X, largest change: at X 800 arriving in +"
    for table, code, named in (
        (sheet_followed, 0, ""),
        (texts["X.COM"], 1, f"{differs} 46.900 15.000 µm"),
        (scaled_column(sheet_followed, -1.0), 1, f"{differs} 46.900 −46.900 µm"),
        (own_column(texts["X.COM"]), 1, "hold no table of axis Y over axis X"),
    ):
        for name, text in {**texts, "X.COM": table}.items():
            (back / name).write_text(text)
        capsys.readouterr()
        assert compwright([*words, "--loaded", str(back)]) == code
        shown = " ".join(capsys.readouterr().out.split())
        assert ("Verdict: good" in shown) is (code == 0)
        assert ("CW-V011" in shown or "CW-S087" in shown) is (code == 1)
        assert compwright(["compare", str(folder / "job"), "--loaded", str(back)]) == code
        shown = " ".join(capsys.readouterr().out.split())
        assert named in shown
        assert ("X.COM row" in shown) is ("hold no table" in named)


def typed_by_hand(bump: float = 0.0, rows: int = 9) -> str:
    """X.COM as an engineer fills it for a sheet with the errors 0 at X 0 and -0.0319 at X 800: rows
    every 100 mm on the line between them, to 0.1 µm. ``bump``: a typing error at X 400, mm.
    """
    text = "BEGIN X      .COM MM DATUM:0 DIST:100\nNR   1=F()     2=F()\n"
    for k in range(rows):
        value = -0.0319 * k / (rows - 1) + (bump if k == 4 else 0.0)
        text += f"{k:<5d}{0:<+10.4f}{value:+.4f}\n"
    return f"{text}END   X      .COM\n"


@pytest.mark.parametrize("named", ["nothing", "no column 1", "no table in column 1"])
@pytest.mark.parametrize(
    ("bump", "code"), [(0.0, 0), (0.05, 1), (0.0005, 1)], ids=["right", "50 µm", "0.5 µm"]
)
def test_a_table_typed_by_a_sheet_of_two_points_is_compared_at_its_own_rows(
    *,
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    named: str,
    bump: float,
    code: int,
) -> None:
    """No table of X is among the files, and the sheet has the ends of the line. The engineer makes
    a table and, as the card says, names it for X in the .CMA; `compare` and `verify` accept exactly
    this, and find a wrong row between the ends.
    """
    texts = {"Y.COM": y_com(), "MP.TXT": f"{PARAMETERS}MP730 : %00011\n"}
    texts["CONFIG.CMA"] = {
        "no column 1": LINE.replace("1         2", "2").replace("X         Y", "Y"),
        "no table in column 1": LINE.replace("0    X", "0     "),
    }.get(named, "")
    if named == "nothing":
        assert run(folder, ITNC) == 0
    else:
        assert run(folder, ITNC, states=files(folder, texts)) == 0
    _, rows = sheet(folder)
    assert [row[:2] for row in rows] == [["0.0000", "0.0000"], ["800.0000", "-0.0319"]]
    write_circle(folder / "after.csv", Bent(squareness=0.0).circle(8))
    back = folder / "back"
    back.mkdir()
    own = y_com(0.0) if named == "nothing" else texts["Y.COM"]
    for name, text in {
        **texts,
        "X.COM": typed_by_hand(bump),
        "Y.COM": own,
        "CONFIG.CMA": LINE,
    }.items():
        (back / name).write_text(text)
    capsys.readouterr()
    words = ["verify", str(folder / "job.yaml"), "--after", str(folder / "after.csv"), "--force"]
    assert compwright([*words, "--loaded", str(back)]) == code
    shown = " ".join(capsys.readouterr().out.split())
    assert ("Verdict: good" in shown) is (code == 0)
    assert ("CW-V011" in shown) is (code == 1)
    assert compwright(["compare", str(folder / "job"), "--loaded", str(back)]) == code
    shown = " ".join(capsys.readouterr().out.split())
    assert ("correction of Y over X, largest change: at X 400 arriving in +" in shown) is bool(code)
    assert "CONFIG.CMA" not in shown


NAMELESS = "BEGIN CONFIG .CMA MM\nNR   2\n0    Y\nEND   CONFIG .CMA\n"


@pytest.mark.parametrize(
    ("name", "text", "named"),
    [
        ("X.COM", own_column(typed_by_hand()), "hold no table of axis Y over axis X"),
        ("CONFIG.CMA", NAMELESS, "hold no table of axis Y over axis X"),
        ("CONFIG.CMA", LINE.replace("Y\n", "Y    X\n").replace("2\n", "2    3\n"), "row 0 3"),
        ("CONFIG.CMA", LINE.replace("Y\n", "Y    Z\n").replace("2\n", "2    3\n"), "row 0 3"),
        ("CONFIG.CMA", LINE.replace("Y\n", "X\n"), "CONFIG.CMA row 0 2 Y X"),
        ("MP.TXT", f"{PARAMETERS}MP730 : %00111\nMP750.0 : 0.01\n", "X MP.TXT: MP750.0"),
    ],
    ids=["no column", "not named", "also for Z", "one of Z", "also for Y", "a parameter"],
)
def test_a_table_that_is_new_for_its_axis_excuses_no_other_difference(
    folder: Path,  # noqa: F811
    capsys: pytest.CaptureFixture[str],
    name: str,
    text: str,
    named: str,
) -> None:
    texts = {"Y.COM": y_com(), "CONFIG.CMA": NAMELESS, "MP.TXT": f"{PARAMETERS}MP730 : %00111\n"}
    assert run(folder, ITNC, states=files(folder, texts)) == 0
    back = folder / "back"
    back.mkdir()
    typed_in = {**texts, "X.COM": typed_by_hand(), "CONFIG.CMA": LINE, name: text}
    if "Z" in text:
        typed_in["Z.COM"] = y_com().replace("BEGIN Y", "BEGIN Z").replace("END   Y", "END   Z")
        typed_in["Z.COM"] = typed_in["Z.COM"].replace("2=F()", "3=F()")
    for file, content in typed_in.items():
        (back / file).write_text(content)
    capsys.readouterr()
    assert compwright(["compare", str(folder / "job"), "--loaded", str(back)]) == 1
    assert named in " ".join(capsys.readouterr().out.split())
