"""HEIDENHAIN in formats: sheets, exported tables and parameters, worked by hand from the manuals'
facts.

Signs: a table of errors corrects by their opposite; MP720 is the error in mm/m; a positive MP710
(backLash) is lost motion, added only against the direction of the reference return. Grid: point k
at DATUM + k * DIST, DIST as exponent 2^n * 0.0001 mm.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from card_files import card_values
from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import decode, open_control
from compwright.formats.card import card_steps
from compwright.formats.definition.schema import Definition
from compwright.formats.families.card_texts import UNKNOWN, CardRequest
from compwright.formats.families.shapes import control_format
from compwright.formats.gate import check_definition
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.facts import AxisFacts
from format_samples import DEFINITIONS, axis_of, codes, correction, table
from loop import Machine, accuracy, allowed, csv_of

pytestmark = pytest.mark.short_estimate

ITNC = DEFINITIONS["heidenhain-itnc530"]
NCK = DEFINITIONS["heidenhain-nck"]
PLUS, MINUS = Direction.POSITIVE, Direction.NEGATIVE
NM = 1e-6  # mm: a thousandth of the smallest number that these files hold

SHEET = """# axis: X
# address: X
# value: error
point,position,value,unit
0,-100,0.0020,mm
1,0,0,mm
2,100,-4.0,um
MP710,,3,um
MP720,,0.070,mm/m
MP730,,1,
"""
COM = """BEGIN X      .COM MM DATUM:-400 DIST:16
NR   1=F()     2=F()     3=F()
0    +0                  +0.0001
1    -0.0012             +0.0003
2    -0.0021             -0.0006
END   X      .COM
"""
ALONE = """BEGIN X      .COM MM DATUM:-400 DIST:16
NR   1=F()     2=F()     3=F()
0    +0
1    -0.0012
2    -0.0021
END   X      .COM
"""
NCK_COM = """BEGIN X.COM MM
NR  AXISPOS    BACKLASH   X          Y
0   -400       +0.0040    +0.0000    +0.0000
1   -200       +0.0021    -0.0018    +0.0015
2   +0         +0.0043    +0.0007    +0.0030
[END]
"""
NCK_ALONE = """BEGIN X.COM MM
NR  AXISPOS    X
0   -400       +0.0000
1   -200       -0.0018
2   +0         +0.0007
[END]
"""
MP = """; machine parameters
MP700 : %00000
MP710.0 : +0.0040 ;backlash X
MP710.1 : 0.0010
MP720.0 : 0.0500
MP730 : %00010
"""


def file(name: str, text: str) -> ControlFile:
    return ControlFile(name, text.encode("latin-1"))


def itnc(*files: ControlFile, axes: tuple[Axis, ...] = (), **options: object) -> ControlState:
    return control_format(ITNC, options).read(files, axes)


def nck(*files: ControlFile, axes: tuple[Axis, ...] = (), **options: object) -> ControlState:
    return control_format(NCK, options).read(files, axes)


def um(state: ControlState, address: str, position: float, direction: Direction = PLUS) -> float:
    return 1000 * correction(state, address, position, direction)


def text_of(files: tuple[ControlFile, ...], name: str) -> str:
    return next(one.content.decode("latin-1") for one in files if one.name == name)


def judged(
    definition_id: str, files: tuple[ControlFile, ...], axes: tuple[Axis, ...], **options: object
) -> ControlState:
    """Read with both readers, which share no code: decode raises where they do not agree."""
    return decode(open_control(Session(), definition_id, options), files, axes).state


# The definitions
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("definition", [ITNC, NCK], ids=lambda one: one.id)
def test_the_definitions_pass_their_gate(definition: object) -> None:
    assert check_definition(definition) == ()  # type: ignore[arg-type]


# Reading
# --------------------------------------------------------------------------------------------------


def test_a_sheet_of_errors() -> None:
    state = itnc(file("entry_X.csv", SHEET))
    assert um(state, "X", -100) == pytest.approx(-2, abs=NM)
    assert um(state, "X", 50) == pytest.approx(2, abs=NM)
    assert um(state, "X", 50, MINUS) == pytest.approx(-1, abs=NM)  # less 3 µm of lost motion
    assert um(state, "X", 900) == pytest.approx(
        4, abs=NM
    )  # the end value holds; MP720 is dead beside a table
    assert "CW-S009" in codes(state)
    assert any(
        entry.fact == "outside the tables" and "unconfirmed" in entry.evidence
        for entry in state.assumed
    )


def test_a_sheet_of_corrections_keeps_the_sign_of_its_parameters() -> None:
    sheet = SHEET.replace("value: error", "value: correction").replace("MP730,,1,", "MP730,,0,")
    state = itnc(
        file("entry_X.csv", sheet)
    )  # bit 0: the table is off, the line acts: 0.070 mm/m too far
    assert um(state, "X", 100) == pytest.approx(-7, abs=NM)
    assert um(state, "X", -100, MINUS) == pytest.approx(7 - 3, abs=NM)
    assert "CW-S007" in codes(state)
    on = itnc(file("entry_X.csv", sheet.replace("MP730,,0,", "MP730,,1,")))
    assert um(on, "X", -100) == pytest.approx(2, abs=NM)


def test_the_line_turns_about_the_reference() -> None:
    axis = replace(axis_of("X", returns=MINUS), reference=-50.0)
    state = itnc(file("p.txt", "MP710.0 : 0.004\nMP720.0 : -0.1\nMP730 : 0\n"), axes=(axis,))
    assert um(state, "X", -50, MINUS) == pytest.approx(0, abs=NM)
    assert um(state, "X", 50, MINUS) == pytest.approx(10, abs=NM)  # 0.1 mm/m too short over 100 mm
    assert um(state, "X", 50, PLUS) == pytest.approx(14, abs=NM)


def test_an_exported_table_with_another_axis_column() -> None:
    state = itnc(
        file("X.COM", COM), file("MP.TXT", MP.replace("%00010", "%00111")), axes=(axis_of("X"),)
    )
    assert um(state, "X", -392) == pytest.approx(0.6, abs=NM)
    assert um(state, "X", -368) == pytest.approx(2.1, abs=NM)
    assert um(state, "X", -368, MINUS) == pytest.approx(2.1 - 4, abs=NM)
    (cross,) = state.cross
    assert (cross.input, cross.output) == ("X", "Z")
    assert cross.at(np.array([-384.0, -376.0]), PLUS) == pytest.approx([-0.0003, 0.00015], abs=1e-9)
    # the bit of Z is 0: no table acts on Z, another axis' neither; its column is there all the same
    (off,) = itnc(
        file("X.COM", COM), file("MP.TXT", MP.replace("%00010", "%00011")), axes=(axis_of("X"),)
    ).cross
    assert (off.input, off.output, off.positive.tolist()) == (
        "X",
        "Z",
        [0.0] * cross.positions.size,
    )


def test_the_exponent_counts_tenths_of_a_micrometre() -> None:
    state = itnc(file("X.COM", COM), spacing_rule="power_of_two")  # 2^16 * 0.0001 mm = 6.5536 mm
    assert state.axes["X"].positions == pytest.approx([-400, -393.4464, -386.8928], abs=1e-9)
    with pytest.raises(InputError, match="spacing_rule"):
        itnc(file("X.COM", COM.replace("DIST:16", "DIST:24")), spacing_rule="power_of_two")


def test_values_as_corrections_and_in_inch() -> None:
    assert um(itnc(file("X.COM", COM), table_values="correction"), "X", -384) == pytest.approx(
        -1.2, abs=NM
    )
    inch = itnc(file("X.COM", COM.replace(" MM ", " INCH ")))
    assert inch.axes["X"].positions == pytest.approx([-10160, -9753.6, -9347.2], abs=1e-9)
    assert um(inch, "X", -9753.6) == pytest.approx(1.2 * 25.4, abs=NM)


def test_a_blank_cell_lies_between_its_neighbours() -> None:
    blank = COM.replace("1    -0.0012             +0.0003", "1                        +0.0003")
    assert um(itnc(file("X.COM", blank)), "X", -384) == pytest.approx(1.05, abs=NM)
    with pytest.raises(InputError, match=r"X\.COM: line 5: .* blank at an end"):
        itnc(file("X.COM", COM.replace("2    -0.0021   ", "2              ")))


def test_columns_flush_right_and_without_widths() -> None:
    right = (
        "BEGIN X .COM MM DATUM:0 DIST:5\n NR      1=F()      2=F()\n"
        "  0               0.0100\n  1    -0.0020\n  2     0.0040    0.0300\nEND\n"
    )
    with pytest.raises(InputError, match="blank at an end"):
        itnc(file("X.COM", right))
    full = right.replace("  0               0.0100", "  0          0    0.0100")
    state = itnc(file("X.COM", full))
    assert um(state, "X", 10) == pytest.approx(-4, abs=NM)
    assert state.cross[0].positive == pytest.approx([-0.01, -0.02, -0.03], abs=1e-9)  # errors too
    loose = (
        "BEGIN X .COM MM DATUM:0 DIST:5\nNR 1=F() 2=F()\n0 0.0000 0.0100\n1 -0.0020 0.0200\nEND\n"
    )
    assert um(itnc(file("X.COM", loose)), "X", 5) == pytest.approx(2, abs=NM)
    assert itnc(file("X.COM", loose)).cross[0].positive == pytest.approx([-0.01, -0.02], abs=1e-9)


def test_what_could_stand_in_two_columns_is_refused() -> None:
    between = "BEGIN X .COM MM DATUM:0 DIST:5\nNR   1=F()     2=F()\n0           1\nEND\n"
    with pytest.raises(InputError, match=r"line 3: .*between two columns"):
        itnc(file("X.COM", between))
    with pytest.raises(InputError, match=r"line 4: .*are not below"):
        itnc(
            file(
                "X.COM",
                "BEGIN X .COM MM DATUM:0 DIST:5\nNR 1=F() 2=F()\n0 0.0000 0.0100\n1       "
                " 0.0200\nEND\n",
            )
        )


def test_the_active_line_says_which_table_acts() -> None:
    other = COM.replace("X  ", "OLD").replace("-0.0012", "-0.0099")
    lines = (
        "BEGIN CONFIG .CMA MM\nNR   1         2         3\n0    NEW       Y\nEND   CONFIG .CMA\n"
    )
    new = COM.replace("X  ", "NEW")
    state = itnc(
        file("old.com", other), file("new.com", new), file("c.cma", lines), axes=(axis_of("X"),)
    )
    assert um(state, "X", -384) == pytest.approx(1.2, abs=NM)
    assert any("old.com" in entry.message for entry in state.findings if entry.code == "CW-S012")
    assert ("CW-S012", {"file": "Y", "axis": "Y"}) in [
        (one.code, one.values) for one in state.findings
    ]
    with pytest.raises(InputError, match=r"axis Y: the active table was not given; expected Y"):
        itnc(file("new.com", new), file("c.cma", lines))
    with pytest.raises(InputError, match="to which moving axis this table belongs"):
        itnc(file("new.com", new))
    with pytest.raises(InputError, match="axis X is in two columns"):
        itnc(file("new.com", new), file("c.cma", lines.replace("2         3", "1=F()     3")))
    two = lines.replace("END ", "1    OLD\nEND ")
    with pytest.raises(InputError, match="do not show which line"):
        itnc(file("new.com", new), file("c.cma", two))


def test_the_marked_line_of_several_and_the_name_of_the_file() -> None:
    lines = (
        "BEGIN CONFIG .CMA MM\nNR   1         2         STATUS\n0    OLD\n1    NEW                "
        " M\nEND   CONFIG .CMA\n"
    )
    old = COM.replace("-0.0012", "-0.0099")  # both files hold a table called X in its first line
    state = itnc(file("OLD.COM", old), file("NEW.COM", COM), file("c.cma", lines))
    assert um(state, "X", -384) == pytest.approx(1.2, abs=NM)
    back = itnc(
        file("OLD.COM", old),
        file("NEW.COM", COM),
        file("c.cma", lines.replace("0    OLD", "0    NEW").replace("1    NEW", "1    OLD")),
    )
    assert um(back, "X", -384) == pytest.approx(9.9, abs=NM)
    with pytest.raises(InputError, match="several tables with the name X"):
        itnc(file("OLD.COM", old), file("NEW.COM", COM), file("c.cma", lines.replace("NEW", "X  ")))


def test_nck_star_marks_the_line() -> None:
    lines = (
        "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X      Y\n0           A.COM\n1   *       X.COM\n[END]\n"
    )
    state = nck(file("X.COM", NCK_ALONE), file("config.cma", lines))
    assert um(state, "X", -100) == pytest.approx(0.55, abs=NM)
    none = nck(file("X.COM", NCK_ALONE), file("config.cma", lines.replace("*", " ")))
    assert none.axes == {}  # no line is active: nothing acts
    assert "CW-S012" in codes(none)
    with pytest.raises(InputError, match="several lines"):
        nck(file("X.COM", NCK_ALONE), file("config.cma", lines.replace("0        ", "0   *    ")))


def test_nck_backlash_is_the_second_curve() -> None:
    """The column holds the values for travel in -, of the table's own axis (MANUALplus 620
    technical manual p715).
    """
    with pytest.raises(InputError, match="backlash_column"):
        nck(file("X.COM", NCK_COM), backlash_column="absent")
    state = nck(file("X.COM", NCK_COM))
    assert um(state, "X", -200, PLUS) == pytest.approx(1.8, abs=NM)
    assert um(state, "X", -200, MINUS) == pytest.approx(-2.1, abs=NM)
    assert [(one.input, one.output) for one in state.cross] == [("X", "Y")]


def test_parameters_have_to_agree() -> None:
    with pytest.raises(
        InputError,
        match=(
            r"MP\.TXT: line 3: .*MP710 contradicts entry_X\.csv, line 8; expected 0\.003, found"
            r" \+0\.0040"
        ),
    ):
        itnc(
            file("entry_X.csv", SHEET),
            file("MP.TXT", MP.replace("%00010", "%00001")),
            axes=(axis_of("X"),),
        )
    with pytest.raises(InputError, match=r"MP730 selects a table, but it is in no file"):
        itnc(file("MP.TXT", MP), axes=(axis_of("Y"),))
    with pytest.raises(InputError, match="two tables"):
        itnc(file("entry_X.csv", SHEET), file("X.COM", COM))
    with pytest.raises(InputError, match="no given file states the compensation of axis B"):
        itnc(file("entry_X.csv", SHEET), axes=(axis_of("B"),))


def test_the_job_counts_axes_its_own_way() -> None:
    axes = tuple(replace(axis_of(name), axis_number=n) for name, n in (("Z", 1), ("X", 3)))
    state = itnc(file("Z.COM", COM.replace("X  ", "Z  ")), axes=axes)
    assert um(state, "Z", -384) == pytest.approx(1.2, abs=NM)


BAD_SHEETS = {
    "no sign": ("# value: error\n", "", "must state what its values are"),
    "unknown sign": ("value: error", "value: deviation", "value: error or # value: correction"),
    "cut short": (
        "# value: error\n",
        "# value: error\n# points: 4\n",
        "fewer or more points than it states.* expected 4 points, found 3",
    ),
    "positions descend": ("1,0,0,mm", "1,-200,0,mm", "do not ascend"),
    "a point missing": ("1,0,0,mm\n", "", "numbered one by one"),
    "unit of a point": ("1,0,0,mm", "1,0,0,inch", "unit of a point"),
    "unknown parameter": ("MP710,,", "MP711,,", "no point and no parameter"),
    "parameter with a position": ("MP710,,", "MP710,5,", "has no position"),
    "unit of MP720": ("mm/m", "mm", "unit of MP720"),
    "two bits": ("MP730,,1,", "MP730,,3,", "0 or 1"),
    "too large": ("MP710,,3,um", "MP710,,3,mm", "-1 .. 1 mm"),
    "kinds mixed": ("MP710,,3,um", "MP710,,0.003,deg", "units of the entry sheet"),
    "implausible value": ("-4.0,um", "-40,mm", "not plausible"),
    "decimal comma": ("0.0020,mm", '"0,0020",mm', "wrong number of columns"),
    "an axis that cannot be": ("# address: X", "# address: X-1", "cannot have this address"),
}


@pytest.mark.parametrize(("old", "new", "says"), BAD_SHEETS.values(), ids=list(BAD_SHEETS))
def test_a_bad_sheet_is_refused_with_its_place(old: str, new: str, says: str) -> None:
    assert old in SHEET
    with pytest.raises(InputError, match=says) as caught:
        itnc(file("entry_X.csv", SHEET.replace(old, new)))
    assert all(fault.file == "entry_X.csv" for fault in caught.value.faults)


BAD_TABLES = {
    "cut short": ("END   X      .COM\n", "", "no end"),
    "no datum": ("DATUM:-400 ", "", "first line cannot be read"),
    "no rows": (
        (
            "\n0    +0                  +0.0001\n1    -0.0012             +0.0003\n2    -0.0021    "
            "         -0.0006"
        ),
        "",
        "no rows",
    ),
    "row numbers": ("\n2    ", "\n3    ", "numbered one by one"),
    "no number": ("-0.0012", "-0,0012", "no number"),
    "end of another table": ("END   X", "END   Y", "end of another table"),
    "two tables in a file": (
        "END   X      .COM\n",
        "END   X      .COM\nBEGIN\n",
        "more text follows",
    ),
    "implausible": ("-0.0012", "-12.000", "not plausible"),
    "column twice": ("2=F()", "1=F()", "is in the table twice"),
    "no spacing": ("DIST:16", "DIST:0", "datum and spacing"),
}


@pytest.mark.parametrize(("old", "new", "says"), BAD_TABLES.values(), ids=list(BAD_TABLES))
def test_a_bad_table_is_refused_with_its_place(old: str, new: str, says: str) -> None:
    assert old in COM
    with pytest.raises(InputError, match=says) as caught:
        itnc(file("X.COM", COM.replace(old, new)))
    assert all(
        fault.file == "X.COM" and (fault.place or says == "no end") for fault in caught.value.faults
    )


def test_more_rows_than_the_control_takes() -> None:
    rows = "".join(f"{n:<5}+0.0001\n" for n in range(257))
    text = f"BEGIN X .COM MM DATUM:0 DIST:5\nNR   1=F()\n{rows}END\n"
    with pytest.raises(InputError, match=r"line 259: .*at most 256, found 257"):
        itnc(file("X.COM", text))
    assert itnc(file("X.COM", text.replace("256  +0.0001\n", ""))).axes["X"].positions.size == 256


# Rotary axes
# --------------------------------------------------------------------------------------------------


def turn_table(name: str, datum: float, step: float, values: list[float]) -> ControlFile:
    rows = "".join(f"{n:<5}{value:+.4f}\n" for n, value in enumerate(values))
    return file(
        f"{name}.COM",
        f"BEGIN {name} .COM MM DATUM:{datum:g} DIST:{step:g}\nNR   6=F()\n{rows}END\n",
    )


def test_a_turn_repeats_and_only_0_to_360_counts() -> None:
    state = itnc(turn_table("C", 0, 90, [0, -0.001, -0.002, -0.003, 0]))
    assert state.axes["C"].kind is AxisKind.ROTARY
    for turn in (-720, 0, 360):
        assert correction(state, "C", turn + 45, PLUS) == pytest.approx(0.0005, abs=1e-9)
    longer = itnc(turn_table("C", -90, 90, [0.5, 0, -0.001, -0.002, -0.003, 0, 0.7]))
    assert longer.axes["C"].positions.tolist() == [0, 90, 180, 270, 360]
    assert correction(longer, "C", 359.999, PLUS) == pytest.approx(0, abs=1e-7)
    step = itnc(turn_table("C", 0, 180, [0, -0.001, -0.002]))
    assert "CW-S017" in codes(step)
    with pytest.raises(InputError, match="0 to 360"):
        itnc(turn_table("C", -90, 45, [0, 0.001, 0]))
    assert "CW-S009" in codes(itnc(file("p.txt", "MP720.5 : 0.05\n")))  # no effect on rotary axes


def test_an_endless_table_is_written_from_zero_wherever_the_reference_is() -> None:
    axis = replace(
        axis_of("C", kind=AxisKind.ROTARY, modulo=360.0), reference=90.0, travel=(0.0, 360.0)
    )
    nodes = [90, 180, 270, 360, 450]
    wanted = replace(
        table("C", nodes, [0, 0.001, 0.002, -0.003, 0], kind=AxisKind.ROTARY), period=360.0
    )
    files = control_format(ITNC, {}).write([wanted], [axis])
    again = judged(ITNC.id, files, (axis,)).axes["C"]
    assert again.positions.tolist() == [0, 90, 180, 270, 360]
    where = np.array([-200.0, 0.0, 33.0, 100.0, 300.0, 800.0])
    assert again.at(where, PLUS) == pytest.approx(wanted.at(where, PLUS), abs=1e-9)
    open_ended = replace(
        wanted,
        positive=np.array([0, 0.001, 0.002, -0.003, 0.001]),
        negative=np.array([0, 0.001, 0.002, -0.003, 0.001]),
    )
    with pytest.raises(CapacityError, match="have the same value at both ends"):
        control_format(ITNC, {}).write([open_ended], [axis])
    off = replace(axis, reference=10.0)
    shifted = replace(wanted, positions=np.array(nodes, dtype=float) - 80)
    with pytest.raises(CapacityError, match="a point at 0 degrees"):
        control_format(ITNC, {}).write([shifted], [off])
    limited = replace(axis, modulo=None)
    with pytest.raises(CapacityError, match="0 to 360 degrees"):
        control_format(ITNC, {}).write([replace(wanted, period=None)], [limited])


# Capacity
# --------------------------------------------------------------------------------------------------


def test_capacity_of_a_table() -> None:
    capacity = control_format(ITNC, {}).capacity(axis_of("X"))
    assert (capacity.spacing, capacity.curves, capacity.max_points, capacity.quantum) == (
        "equidistant",
        1,
        256,
        1e-4,
    )
    assert (capacity.backlash_range, capacity.backlash_quantum, capacity.cover) == (
        (-1, 1),
        1e-4,
        1,
    )
    assert (capacity.spacings, capacity.points, capacity.line, capacity.period) == (
        None,
        None,
        None,
        None,
    )
    powers = control_format(ITNC, {"spacing_rule": "power_of_two"}).capacity(axis_of("X")).spacings
    assert powers is not None
    assert (len(powers), powers[0]) == (24, 1e-4)
    assert powers[16] == pytest.approx(6.5536, abs=1e-12)
    assert control_format(ITNC, {"max_points": 64}).capacity(axis_of("X")).max_points == 64
    listed = control_format(NCK, {}).capacity(axis_of("X"))  # MANUALplus 620 manual p715
    assert (listed.spacing, listed.max_points) == ("equidistant", 256)
    turn = control_format(ITNC, {}).capacity(axis_of("C", kind=AxisKind.ROTARY, modulo=360.0))
    assert (turn.period, turn.anchored, turn.cover) == (360, True, 0)


def test_capacity_of_a_line() -> None:
    capacity = control_format(ITNC, {"method": "line"}).capacity(axis_of("X"))
    assert capacity.line == pytest.approx(1e-6, abs=1e-15)  # 0.001 mm/m
    assert capacity.value_range == pytest.approx((-1e-3, 1e-3), abs=1e-15)  # ±1 mm/m
    with pytest.raises(CapacityError, match="MP720 has no effect on rotary axes"):
        control_format(ITNC, {"method": "line"}).capacity(axis_of("C", kind=AxisKind.ROTARY))
    with pytest.raises(CapacityError, match="power_of_two"):
        control_format(ITNC, {"spacing_rule": "power_of_two"}).capacity(
            axis_of("C", kind=AxisKind.ROTARY, modulo=360.0)
        )
    with pytest.raises(CapacityError, match="360"):
        control_format(ITNC, {}).capacity(axis_of("C", kind=AxisKind.ROTARY, modulo=180.0))
    with pytest.raises(UsageError, match="method"):
        control_format(NCK, {"method": "line"}).capacity(axis_of("X"))


def test_capacity_takes_the_grid_that_other_axes_need() -> None:
    state = itnc(file("X.COM", COM), axes=(axis_of("X"),))
    assert control_format(ITNC, {}, state).capacity(axis_of("X")).points == (-400, -384, -368)
    assert (
        control_format(ITNC, {}, itnc(file("X.COM", ALONE))).capacity(axis_of("X")).points is None
    )
    two = nck(file("X.COM", NCK_COM))
    assert control_format(NCK, {}, two).capacity(axis_of("X")).curves == 2
    absent = {"backlash_column": "absent"}
    assert control_format(NCK, absent, two).capacity(axis_of("X")).curves == 1
    alone = control_format(NCK, {}).capacity(axis_of("X"))
    assert alone.curves == 1  # a sheet has no place for a second curve
    assert alone.max_points == 256  # MANUALplus 620 technical manual p715
    assert any("BACKLASH" in entry.value for entry in alone.assumed)


# Writing a sheet
# --------------------------------------------------------------------------------------------------


def test_a_sheet_as_it_is_written() -> None:
    wanted = table("X", [-100, 0, 100], [0.002, 0, -0.0101], backlash=0.0037)
    (sheet,) = control_format(ITNC, {}).write([wanted], [axis_of("X")])
    assert sheet.name == "entry_X.csv"
    assert (
        sheet.content.decode()
        == "# axis: X\n# address: X\n# format: heidenhain-itnc530\n# value: error\n# points: 3\n"
        "# note: values of points are errors as the control is assumed to expect them: check the"
        " sign, see the card\n"
        "# note: positions are machine coordinates in mm\n"
        "point,position,value,unit\n"
        "0,-100.0000,-0.0020,mm\n1,0.0000,0.0000,mm\n2,100.0000,0.0101,mm\n"
        "MP710,,0.0037,mm\nMP720,,0.000,mm/m\nMP730,,1,\n"
    )
    (other,) = control_format(ITNC, {"table_values": "correction"}).write([wanted], [axis_of("X")])
    assert "# value: correction" in other.content.decode()
    assert "0,-100.0000,0.0020,mm" in other.content.decode()
    (keys,) = control_format(NCK, {}).write([wanted], [axis_of("X")])
    assert "backLash,,0.0037,mm\nlinearCompValue,,0.000,mm/m\n" in keys.content.decode()


def test_a_line_is_two_numbers_and_a_bit() -> None:
    axis = replace(axis_of("X"), reference=50.0, travel=(0.0, 400.0))
    none = np.empty(0)
    line = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=none,
        positive=none,
        negative=none,
        backlash=0.004,
        slope=-70e-6,
        origin=50.0,
    )
    (sheet,) = control_format(ITNC, {"method": "line"}).write([line], [axis])
    assert sheet.content.decode().endswith("unit\nMP710,,0.0040,mm\nMP720,,0.070,mm/m\nMP730,,0,\n")
    again = judged(ITNC.id, (sheet,), (axis,), method="line").axes["X"]
    where = np.array([0.0, 50.0, 400.0])
    for direction in Direction:
        assert again.at(where, direction) == pytest.approx(line.at(where, direction), abs=1e-9)
    values = card_values(
        control_format(ITNC, {"method": "line"}), axis, line, AxisFacts(), line.positions
    )
    assert values["nonlinear"] == "0"
    assert not [step for step in card_steps(ITNC, axis, values) if UNKNOWN in step.text]
    for wrong, says in (
        (replace(line, slope=-70.4e-6), "not a multiple"),
        (replace(line, slope=1.2e-3), "outside"),
        (replace(line, origin=0.0), "zero at the reference"),
        (table("X", [0, 1], [0, 0]), "either the linear parameter or a table, not both"),
    ):
        with pytest.raises(CapacityError, match=says):
            control_format(ITNC, {"method": "line"}).write([wrong], [axis])
    with pytest.raises(CapacityError, match="too few points"):
        control_format(ITNC, {}).write([line], [axis])


@pytest.mark.parametrize("definition", [ITNC, NCK])
def test_the_card_has_the_sheet_typed_into_no_table_of_another_motion(
    definition: Definition,
) -> None:
    """X.COM in the column of Y is X = F(Y): typed over it, the pitch error of X would follow Y."""
    wanted = table("X", [0, 50, 100], [0, 0.001, 0.002])
    control = control_format(definition, {})
    sheet = control.write([wanted], [axis_of("X")])
    own = ControlFile("X.COM", b"BEGIN X .COM MM DATUM:0 DIST:50\n")
    play = sheet[0].content.replace(b"points: 3", b"points: 0")
    for files, says in (
        (
            (own, *sheet),
            "names for the motion of axis X; where it names none, into a new one. Never",
        ),
        (sheet, "Type the sheet entry_X.csv into"),
        ((own,), "Load your own .COM file of tables/: it holds the table. Typed"),
        ((own, replace(sheet[0], content=play)), "entry_X.csv holds the parameters"),
    ):
        asked = CardRequest(
            axis=axis_of("X"),
            table=wanted,
            facts=AxisFacts(),
            check_at=wanted.positions,
            files=files,
        )
        values = control.card(asked).values
        steps = {s.title: s.text for s in card_steps(definition, axis_of("X"), values)}
        assert says in steps["Enter the table"]
        assert ("Load your own" in steps["Enter the table"]) == ("Load" in says or "holds" in says)


def test_the_card_names_the_own_bit_and_column() -> None:
    wanted = table("Y", [0, 50, 100, 150, 200], [0, 0.001, 0.002, 0.003, 0.004], backlash=0.0025)
    values = card_values(
        control_format(ITNC, {}), axis_of("Y"), wanted, AxisFacts(), wanted.positions
    )
    assert (values["number"], values["bit"], values["nonlinear"], values["linear"]) == (
        "2",
        "1",
        "1",
        "0.000",
    )
    steps = {step.title: step.text for step in card_steps(ITNC, axis_of("Y"), values)}
    assert (
        "MP710.1 = 0.0025 mm, MP720.1 = 0.000 mm/m, MP730 bit 1 = 1" in steps["Set the parameters"]
    )
    assert "5 points from 0 to 200 mm, every 50 mm" in steps["Enter the table"]
    assert "column 2=F(). The values are errors" in steps["Enter the table"]
    assert "two of the check positions" in steps["Check the sign"]
    other = card_values(
        control_format(ITNC, {}),
        replace(axis_of("W"), axis_number=7),
        replace(wanted, address="W"),
        AxisFacts(),
        replace(wanted, address="W").positions,
    )
    assert other["bit"] == "6"
    assert (
        "axis list"
        in card_values(
            control_format(ITNC, {}),
            axis_of("W"),
            replace(wanted, address="W"),
            AxisFacts(),
            replace(wanted, address="W").positions,
        )["bit"]
    )


LIMITS = {
    "a point too many": (table("X", list(range(257)), [0.0] * 257), {}, "at most 256, found 257"),
    "one point": (table("X", [0], [0]), {}, "at least 2"),
    "two curves": (table("X", [0, 10], [0, 0], [0, 0.001]), {}, "one table"),
    "unequal spacing": (table("X", [0, 10, 25], [0, 0, 0]), {}, "equally spaced"),
    "no power of two": (
        table("X", [0, 10, 20], [0, 0, 0]),
        {"spacing_rule": "power_of_two"},
        "13.1072",
    ),
    "value between two steps": (table("X", [0, 10], [0, 0.00005]), {}, "not a multiple"),
    "position between two steps": (table("X", [0, 10.00005], [0, 0]), {}, "not a multiple"),
    "backlash too large": (table("X", [0, 10], [0, 0], backlash=1.0001), {}, "outside"),
    "too steep": (
        table("X", [0, 10], [0, 0.1563]),
        {},
        "spacing / 64 = 0.15625 mm, found 0.1563 mm",
    ),
    "a line beside the table": (replace(table("X", [0, 10], [0, 0]), slope=1e-6), {}, "no effect"),
    "steps between points": (
        replace(table("X", [0, 10], [0, 0]), interpolation="step"),
        {},
        "straight lines",
    ),
    "positions that descend": (table("X", [10, 0], [0, 0]), {}, "ascend"),
}


@pytest.mark.parametrize(("wanted", "options", "says"), LIMITS.values(), ids=list(LIMITS))
def test_what_the_control_cannot_hold(
    wanted: AxisCompensation, options: dict[str, object], says: str
) -> None:
    with pytest.raises(CapacityError, match=says):
        control_format(ITNC, options).write([wanted], [axis_of("X")])


def test_the_steepest_step_that_may_be() -> None:
    control_format(ITNC, {}).write([table("X", [0, 10], [0, 0.1562])], [axis_of("X")])


# Filling the user's own files
# ------------------------------------------------------------------------------------------------


def test_only_the_own_column_changes() -> None:
    wanted = table("X", [-400, -384, -368], [0.001, 0, -0.0234])
    files = control_format(ITNC, {}).write(
        [wanted], [axis_of("X")], [file("X.COM", COM.replace("\n", "\r\n"))]
    )
    expected = (
        "BEGIN X      .COM MM DATUM:-400 DIST:16\n"
        "NR   1=F()     2=F()     3=F()\n"
        "0    -0.0010             +0.0001\n"
        "1    +0.0000             +0.0003\n"
        "2    +0.0234             -0.0006\n"
        "END   X      .COM\n"
    ).replace("\n", "\r\n")
    assert text_of(files, "X.COM") == expected
    assert [one.name for one in files] == ["X.COM", "entry_X.csv"]
    assert "MP730,,1," in text_of(files, "entry_X.csv")
    assert ",-400" not in text_of(files, "entry_X.csv")  # the points are in the table
    state = judged(ITNC.id, files, (axis_of("X"),))
    assert state.axes["X"].positive == pytest.approx(wanted.positive, abs=1e-9)


def test_a_shorter_table_on_a_shared_grid_keeps_the_end_values() -> None:
    files = control_format(ITNC, {}).write(
        [table("X", [-400, -384], [0.001, 0.003])], [axis_of("X")], [file("X.COM", COM)]
    )
    assert "1    -0.0030             +0.0003\n2    -0.0030             -0.0006\n" in text_of(
        files, "X.COM"
    )


@pytest.mark.parametrize(
    "nodes", [[-400, -376, -352], [-400, -368, -336], [-384, -368, -352], [-400, -384, -368, -352]]
)
def test_a_shared_grid_has_to_stay(nodes: list[float]) -> None:
    wanted = table("X", nodes, [0.001] * len(nodes))
    with pytest.raises(
        CapacityError, match=r"start: -400, end: -368, spacing: 16.*found \d points"
    ) as caught:
        control_format(ITNC, {}).write([wanted], [axis_of("X")], [file("X.COM", COM)])
    assert "columns 3=F() depend on them" in str(caught.value)


def test_rows_are_added_and_the_grid_moves_where_the_column_is_alone() -> None:
    wanted = table("X", [-20, 0, 20, 40, 60], [0.001, 0, -0.001, -0.002, -0.0003])
    files = control_format(ITNC, {}).write([wanted], [axis_of("X")], [file("X.COM", ALONE)])
    assert text_of(files, "X.COM") == (
        "BEGIN X      .COM MM DATUM:-20 DIST:20\n"
        "NR   1=F()     2=F()     3=F()\n"
        "0    -0.0010\n1    +0\n2    +0.0010\n3    +0.0020\n4    +0.0003\n"
        "END   X      .COM\n"
    ).replace("1    +0\n", "1    +0.0000\n")
    powers = table("X", [0, 6.5536, 13.1072], [0, 0.001, 0])
    options = {"spacing_rule": "power_of_two"}
    exponent = control_format(ITNC, options).write(
        [powers], [axis_of("X")], [file("X.COM", ALONE.replace("DIST:16", "DIST:14"))]
    )
    assert "DATUM:0 DIST:16\n" in text_of(exponent, "X.COM")


def test_rows_that_are_too_many_go_on_with_the_end_value() -> None:
    files = control_format(ITNC, {}).write(
        [table("X", [0, 50], [0, 0.0042])], [axis_of("X")], [file("X.COM", ALONE)]
    )
    assert "DATUM:0 DIST:50\n" in text_of(files, "X.COM")
    assert "1    -0.0042\n2    -0.0042\nEND" in text_of(files, "X.COM")


def test_nck_positions_and_curves() -> None:
    wanted = table("X", [-10, 15.5, 41, 66.5], [0.001, 0, -0.002, 0])
    files = control_format(NCK, {}).write([wanted], [axis_of("X")], [file("X.COM", NCK_ALONE)])
    assert (
        text_of(files, "X.COM")
        == "BEGIN X.COM MM\nNR  AXISPOS    X\n0   -10        -0.0010\n1   +15.5      +0.0000\n2  "
        " +41        +0.0020\n3   +66.5      +0.0000\n[END]\n"
    )
    uneven = table("X", [-10, 0, 25.5], [0, 0.001, 0])  # p715: equal steps are asked for
    with pytest.raises(CapacityError, match="not equally spaced"):
        control_format(NCK, {}).write([uneven], [axis_of("X")], [file("X.COM", NCK_ALONE)])
    assert "CW-S046" in codes(nck(file("X.COM", NCK_ALONE.replace("-200", "-300"))))
    two = table("X", [-400, -200, 0], [0.001, 0, -0.002], [0.002, 0.0005, 0])
    both = control_format(NCK, {}).write([two], [axis_of("X")], [file("X.COM", NCK_COM)])
    assert (
        "0   -400       -0.0020    -0.0010    +0.0000\n1   -200       -0.0005    +0.0000   "
        " +0.0015\n" in text_of(both, "X.COM")
    )
    again = judged(NCK.id, both, (axis_of("X"),)).axes["X"]
    assert again.negative == pytest.approx(two.negative, abs=1e-9)
    with pytest.raises(CapacityError, match="one table"):
        control_format(NCK, {}).write([two], [axis_of("X")], [file("X.COM", NCK_ALONE)])
    with pytest.raises(CapacityError, match=r"start: -400, end: 0, spacing: 200"):
        control_format(NCK, {}).write([wanted], [axis_of("X")], [file("X.COM", NCK_COM)])


def test_a_filled_backlash_column_stays_equal() -> None:
    equal = (
        NCK_COM.replace("+0.0040", "+0.0000", 1)
        .replace("+0.0021", "-0.0018")
        .replace("+0.0043", "+0.0007")
    )
    files = control_format(NCK, {}).write(
        [table("X", [-400, -200, 0], [0, 0.003, 0])], [axis_of("X")], [file("X.COM", equal)]
    )
    assert "1   -200       -0.0030    -0.0030    +0.0015\n" in text_of(files, "X.COM")


def test_a_value_that_does_not_fit_its_column() -> None:
    narrow = (
        "BEGIN X .COM MM DATUM:0 DIST:100\nNR  1=F()  2=F()\n0   0.0    0.01\n1   0.0   "
        " 0.02\nEND\n"
    )
    wanted = table("X", [0, 100], [0, 0.0021])
    with pytest.raises(
        CapacityError,
        match=r"-0\.0021 does not fit the column 1=F\(\) of X\.COM, which is 6 characters wide",
    ):
        control_format(ITNC, {}).write([wanted], [axis_of("X")], [file("X.COM", narrow)])
    fits = control_format(ITNC, {}).write(
        [table("X", [0, 100], [0, -0.0021])], [axis_of("X")], [file("X.COM", narrow)]
    )
    assert "1   0.0021 0.02\n" in text_of(fits, "X.COM")


def test_numbers_flush_right_stay_so() -> None:
    right = (
        "BEGIN X .COM MM DATUM:0 DIST:100\nNR      1=F()      2=F()\n 0          0     0.0100\n 1  "
        "   0.0020     0.0300\nEND\n"
    )
    files = control_format(ITNC, {}).write(
        [table("X", [0, 100], [-0.01, 0.0001])], [axis_of("X")], [file("X.COM", right)]
    )
    assert "0     0.0100     0.0100\n 1    -0.0001     0.0300\n" in text_of(files, "X.COM")


def test_numbers_flush_right_under_names_flush_left() -> None:
    text = (
        "BEGIN X .COM MM DATUM:0 DIST:100\nNR   1=F()     2=F()\n0          0     0.0100\n1    "
        " 0.0020     0.0300\nEND\n"
    )
    files = control_format(ITNC, {}).write(
        [table("X", [0, 100], [-0.01, 0.0001])], [axis_of("X")], [file("X.COM", text)]
    )
    assert "0     0.0100     0.0100\n1    -0.0001     0.0300\n" in text_of(files, "X.COM")


def test_a_column_of_zeros_does_not_hold_the_grid() -> None:
    zeros = ALONE.replace("0    +0", "0    +0                  +0").replace(
        "-0.0012", "-0.0012             +0"
    )
    zeros = zeros.replace("-0.0021", "-0.0021             +0")
    wanted = table("X", [0, 10, 20, 30], [0, 0.001, 0.002, 0.003])
    files = control_format(ITNC, {}).write([wanted], [axis_of("X")], [file("X.COM", zeros)])
    assert "DATUM:0 DIST:10\n" in text_of(files, "X.COM")
    assert "2    -0.0020             +0\n3    -0.0030             +0\nEND" in text_of(
        files, "X.COM"
    )


def test_a_table_in_inch_is_not_filled() -> None:
    with pytest.raises(CapacityError, match="inch"):
        control_format(ITNC, {}).write(
            [table("X", [0, 1], [0, 0])],
            [axis_of("X")],
            [file("X.COM", ALONE.replace(" MM ", " INCH "))],
        )


def test_one_bit_and_one_index_of_the_parameters() -> None:
    wanted = table("X", [0, 100], [0, 0.001], backlash=0.0025)
    files = control_format(ITNC, {}).write([wanted], [axis_of("X")], [file("MP.TXT", MP)])
    assert text_of(files, "MP.TXT") == MP.replace("+0.0040 ;", "+0.0025 ;").replace(
        "0.0500", "0.000"
    ).replace("%00010", "%00011")
    sheet = text_of(files, "entry_X.csv")
    assert "MP7" not in sheet  # everything has its place in the list
    assert "1,100.0000,-0.0010,mm" in sheet
    judged(ITNC.id, files, (axis_of("X"),))
    long = MP.replace("+0.0040", "+.00400")
    same = control_format(ITNC, {}).write(
        [replace(wanted, backlash=0.004)], [axis_of("X")], [file("MP.TXT", long)]
    )
    assert "MP710.0 : +.00400 ;" in text_of(same, "MP.TXT")  # an equal number keeps its characters
    decimal = control_format(ITNC, {}).write(
        [wanted], [axis_of("X")], [file("MP.TXT", MP.replace("%00010", "18"))]
    )
    assert "MP730 : 19\n" in text_of(decimal, "MP.TXT")
    other = table("Y", [0, 100], [0, 0.001])
    eleven = control_format(ITNC, {}).write(
        [other], [axis_of("Y")], [file("MP.TXT", MP.replace("%00010", "9"))]
    )
    assert "MP730 : %1011\n" in text_of(eleven, "MP.TXT")  # 11 could be the first two axes


def test_bits_without_their_mark_that_could_be_a_decimal_number_are_refused() -> None:
    """MP730 : 11 is X and Y, or X, Y and the fourth axis; 0 and 18 are what they are."""
    for text in ("11", "00101", "10"):
        with pytest.raises(InputError, match="MP730 can be read in two ways"):
            itnc(file("MP.TXT", MP.replace("%00010", text)), axes=(axis_of("X"),))
    for text in ("0", "18"):
        assert (
            itnc(file("MP.TXT", MP.replace("%00010", text)), axes=(axis_of("X"),))
            .axes["X"]
            .backlash
            == 0.004
        )


def test_two_axes_change_one_mask_and_two_tables() -> None:
    axes = (axis_of("X"), replace(axis_of("Z"), name="Z"))
    none = np.empty(0)
    line = AxisCompensation(
        address="X", kind=AxisKind.LINEAR, positions=none, positive=none, negative=none, slope=5e-6
    )
    axes = (replace(axes[0], options={"method": "line"}), axes[1])
    z_table = (
        ALONE.replace("X  ", "Z  ")
        .replace("1=F()", "7=F()")
        .replace("3=F()", "1=F()")
        .replace("7=F()", "3=F()")
    )
    files = control_format(ITNC, {}).write(
        [line, table("Z", [0, 10], [0.001, 0])],
        axes,
        [
            file("MP.TXT", MP.replace("%00010", "%00001")),
            file("Z.COM", z_table),
            file(
                "entry_X.csv", SHEET.replace("3,um", "4,um").replace("0.070", "0.05")
            ),  # what acts in X now
        ],
    )
    assert "MP730 : %00100\n" in text_of(files, "MP.TXT")
    assert "MP720.0 : -0.005\n" in text_of(files, "MP.TXT")
    assert "0    -0.0010\n1    +0.0000\n2    +0.0000\n" in text_of(files, "Z.COM")
    state = judged(ITNC.id, files, axes)
    assert um(state, "X", 1000) == pytest.approx(5, abs=NM)


# Physics: inject a known error and recover it
# -----------------------------------------------------------------------------


@pytest.mark.parametrize("format_id", [ITNC.id, NCK.id])
def test_a_run_removes_a_known_error(format_id: str, tmp_path: Path) -> None:
    machine = Machine()
    targets = machine.targets()
    before = machine.measure(targets, 1)
    (tmp_path / "x.csv").write_text(csv_of(targets, before))
    out = tmp_path / "out"
    arguments = [
        "run",
        str(tmp_path / "x.csv"),
        "--format",
        format_id,
        "--axis",
        "X",
        "--travel",
        f"{machine.low}:{machine.high}",
    ]
    assert compwright([*arguments, "--state", "none", "--out", str(out)]) == 0
    files = [
        ControlFile(path.name, path.read_bytes())
        for path in sorted((out / "tables" / format_id).iterdir())
    ]
    assert [one.name for one in files] == ["entry_X.csv"]
    control = virtual_control(format_id, files)

    def acting(x: np.ndarray, sign: int) -> np.ndarray:
        return control.correction("X", x, PLUS if sign > 0 else MINUS)

    fresh = machine.targets(seed=8)
    spacing = float(np.max(np.diff(control.points("X"))))
    limit = allowed(machine, fresh, spacing)  # mm
    assert accuracy(before) > 3 * limit
    assert accuracy(machine.measure(fresh, 2, acting)) <= limit
    card = (out / "card" / "card.md").read_text(encoding="utf-8")
    assert UNKNOWN not in card
    assert "entry_X.csv into the .COM file that the active line" in card.replace("\\", "")


def test_a_run_fills_the_table_that_is_in_the_control(tmp_path: Path) -> None:
    machine = Machine()
    targets = machine.targets()
    # In the control: errors of 5 and 10 µm that belong to another machine, in a table of three
    # rows; MP710 of 12 µm.
    old = "BEGIN X .COM MM DATUM:0 DIST:500\n" + ALONE.split("\n", 1)[1].replace(
        "-0.0012", "-0.0050"
    ).replace("-0.0021", "+0.0100")
    (tmp_path / "X.COM").write_text(old)
    (tmp_path / "MP.TXT").write_text("MP710.0 : 0.0120\nMP720.0 : 0.0000\nMP730 : %00101\n")
    states = [ControlFile(name, (tmp_path / name).read_bytes()) for name in ("X.COM", "MP.TXT")]
    was = virtual_control(ITNC.id, states)
    measured = machine.measure(
        targets, 3, lambda x, sign: was.correction("X", x, PLUS if sign > 0 else MINUS)
    )
    (tmp_path / "x.csv").write_text(csv_of(targets, measured))
    out = tmp_path / "out"
    arguments = [
        "run",
        str(tmp_path / "x.csv"),
        "--format",
        ITNC.id,
        "--axis",
        "X",
        "--travel",
        f"{machine.low}:{machine.high}",
        "--option",
        "spacing=auto",
    ]
    assert (
        compwright(
            [
                *arguments,
                "--state",
                str(tmp_path / "X.COM"),
                "--state",
                str(tmp_path / "MP.TXT"),
                "--out",
                str(out),
            ]
        )
        == 0
    )
    files = [
        ControlFile(path.name, path.read_bytes())
        for path in sorted((out / "tables" / ITNC.id).iterdir())
    ]
    assert [one.name for one in files] == ["MP.TXT", "X.COM"]  # everything has its place: no sheet
    assert b"MP730 : %00101\n" in files[0].content
    now = virtual_control(ITNC.id, files)
    fresh = machine.targets(seed=9)
    after = machine.measure(
        fresh, 4, lambda x, sign: now.correction("X", x, PLUS if sign > 0 else MINUS)
    )
    limit = allowed(machine, fresh, float(np.max(np.diff(now.points("X")))))  # mm
    assert accuracy(measured) > 3 * limit
    assert accuracy(after) <= limit


# Properties
# --------------------------------------------------------------------------------------------------

COUNTS = st.integers(-9_999, 9_999)  # tenths of a micrometre


@given(data=st.data())
@settings(deadline=None, max_examples=120)
def test_what_is_filled_in_is_read_back(data: st.DataObject) -> None:
    """Into the user's table or a sheet, read by both readers: the same correction everywhere, other
    columns untouched.
    """
    numbered = data.draw(st.booleans())
    definition = ITNC if numbered else NCK
    count = data.draw(st.integers(2, 8))
    # a step of at least 2 mm times 64: neighbouring values may differ by 2 mm
    start, step = data.draw(st.integers(-(10**6), 10**6)), data.draw(st.integers(1_280_000, 10**7))
    nodes = (start + step * np.arange(count)) * 1e-4
    values = np.array(data.draw(st.lists(COUNTS, min_size=count, max_size=count))) * 1e-4
    wanted = table("X", list(nodes), list(values), backlash=data.draw(COUNTS) * 1e-4)
    template = data.draw(st.sampled_from([None, ALONE if numbered else NCK_ALONE]))
    newline = data.draw(st.sampled_from(["\n", "\r\n"]))
    play = SHEET.split("0,-100", maxsplit=1)[0] + f"{'MP710' if numbered else 'backLash'},,0,mm\n"
    given_files = (
        []
        if template is None
        else [file("X.COM", template.replace("\n", newline)), file("entry_X.csv", play)]
    )
    options = {"table_values": data.draw(st.sampled_from(["error", "correction"]))}
    axis = axis_of("X", returns=data.draw(st.sampled_from(list(Direction))))
    files = control_format(definition, options).write([wanted], [axis], given_files)
    assert files == control_format(definition, options).write([wanted], [axis], given_files)
    again = judged(definition.id, files, (axis,), **options).axes["X"]
    where = np.concatenate(
        [nodes, nodes[:-1] + 0.3 * np.diff(nodes), [nodes[0] - 77, nodes[-1] + 77]]
    )
    returned = replace(wanted, reference_return=axis.reference_return)
    for direction in Direction:
        np.testing.assert_allclose(
            again.at(where, direction), returned.at(where, direction), rtol=0, atol=1e-9
        )


PIECES = st.one_of(
    st.binary(max_size=6),
    st.sampled_from(
        [b"\n", b"\r", b" ", b",", b"BEGIN", b"END", b"[END]", b"NR", b"1=F()", b"*", b"\t"]
    ),
)


@given(data=st.data())
@settings(deadline=None, max_examples=100)
def test_a_damaged_file_is_refused_or_read(data: st.DataObject) -> None:
    definition, files = data.draw(
        st.sampled_from(
            [
                (
                    ITNC,
                    (
                        file("entry_X.csv", SHEET),
                        file("MP.TXT", MP.replace("0040", "0030").replace("%00010", "1")),
                    ),
                ),
                (
                    ITNC,
                    (
                        file("X.COM", COM),
                        file("c.cma", "BEGIN C .CMA MM\nNR   1         2\n0    X\nEND\n"),
                    ),
                ),
                (
                    NCK,
                    (
                        file("X.COM", NCK_ALONE),
                        file(
                            "c.cma",
                            "BEGIN C.CMA MM\nNR  ACTIVE  X      Y\n0   *       X.COM\n[END]\n",
                        ),
                    ),
                ),
            ]
        )
    )
    which = data.draw(st.integers(0, len(files) - 1))
    content = files[which].content
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.integers(0, len(content)))
        content = (
            content[:place] + data.draw(PIECES) + content[place + data.draw(st.integers(0, 12)) :]
        )
    damaged = [
        ControlFile(one.name, content) if index == which else one for index, one in enumerate(files)
    ]
    try:
        state = control_format(definition, {}).read(damaged)
    except (InputError, UsageError):
        return
    for axis in state.axes.values():
        assert axis.positions.shape == axis.positive.shape == axis.negative.shape
        assert np.all(np.diff(axis.positions) > 0)
        assert np.all(np.isfinite([*axis.positive, *axis.negative, axis.backlash, axis.slope]))
        assert np.all(np.abs(axis.positive) <= 254)  # the plausibility bound of 10, taken as inch
    try:
        control_format(definition, {}).write(
            [table("X", [0, 128], [0, 0.001])], [axis_of("X")], damaged
        )
    except (InputError, UsageError, CapacityError):
        return
