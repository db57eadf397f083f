"""A mutation per fact of the HEIDENHAIN definitions: whatever is removed or turned in one, a check
here falls. The checks know the facts from the manuals, not from the definitions.

Sources: TNC 407 technical manual p151 to p156 and p622, MANUALplus 620 technical manual p707 to
p718; sheets, lists of parameters and tables in the forms of docs/controllers/heidenhain.md.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from compwright.formats.definition.schema import Definition
from compwright.formats.families.shapes import control_format
from compwright.formats.gate import check_definition
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import CapacityError, CompwrightError, InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from format_samples import DEFINITIONS, axis_of, correction, table
from mutants import Check, falls, mutants

ITNC, NCK = "heidenhain-itnc530", "heidenhain-nck"
PLUS, MINUS = Direction.POSITIVE, Direction.NEGATIVE
X = axis_of("X")
C = Axis(name="C", kind=AxisKind.ROTARY, travel=(0.0, 90.0), address="C")

#: Facts that decide nothing in this family, with the reason.
DECIDES_NOTHING = {
    # an entry sheet is compwright's own form, read and written by one reader for all controls
    r"bindings\.(node_position|value|backlash)\.field: ": "columns of the sheet",
    r"bindings\.(node_position|value|table_form)\.repeated: ": "rows are numbered, one each",
    r"bindings\.(node_position|value)\.when_absent: ": "a row without them is refused before",
    r"texts\.sheet\.": "the sheet",
    r"statements\.(values_begin|assignments_begin)\.rest: ": "the end of the line is read apart",
    # tables are recognised by their first word and read by their columns
    r"texts\.table\.": "a table",
    r"bindings\.slope\.unit\.rotary: ": "no effect on rotary axes (p151)",
    r"bindings\.slope\.when_absent: |bindings\.enabled\.when_absent: ": "asked for or listed",
    r"bindings\.(table_form|enabled)\.values: ": "the words are those of the sheet and the mask",
    r"bindings\.enabled\.writes: ": "the mask is written bit by bit",
    r"statements\.(\w+)\.fields\.number: integer -> bit": "indices of axes are counted, 0 to 9",
    r"writing\[0\]\.set: ": "one file for each axis, whatever it is called",
    r"bindings\.(backlash|slope)\.repeated: ": "NCK: one sheet for an axis, each row once",
    r"limits\[0\]: removed": "two points make a line on every control",
    r"options\.max_points\.default: ": "the limit says the same",
    r"dialect\.newline: ": "rows end as those of the user's own file",
    r"texts\.parameters\.blank_lines: ": "other lines are ignored, blank ones too",
    r"bindings\.slope\.unit\.linear: mm/m -> um": "1 mm/m is 1 µm/mm: the same factor",
}


def file(name: str, text: str) -> ControlFile:
    return ControlFile(name, text.encode("latin-1"))


def read(d: Definition, *files: ControlFile, axes: tuple[Axis, ...] = (X,)) -> ControlState:
    return control_format(d, {}).read(files, axes)


def refused(kind: type[CompwrightError], call: Callable[[], object]) -> None:
    try:
        call()
    except kind:
        return
    raise AssertionError


def um(state: ControlState, axis: str, position: float, direction: Direction = PLUS) -> float:
    return 1000 * correction(state, axis, position, direction)


def near(found: float, wanted: float) -> None:
    assert found == pytest.approx(wanted, abs=1e-6), (found, wanted)


def written(d: Definition, wanted: AxisCompensation, axis: Axis = X, *files: ControlFile) -> str:
    found = control_format(d, {}).write([wanted], [axis], files)
    return "".join(f"== {one.name}\n{one.content.decode('latin-1')}" for one in found)


SHEET = "# axis: {0}\n# value: error\npoint,position,value,unit\n{1}"


def sheet(d: Definition, rows: str, axis: Axis = X) -> ControlState:
    return read(
        d, file(f"entry_{axis.address}.csv", SHEET.format(axis.address, rows)), axes=(axis,)
    )


# --- what both have


def gate(d: Definition) -> None:
    assert check_definition(d) == ()


def a_sheet_as_it_is_written(d: Definition) -> None:
    """Errors in mm to 0.0001, the linear error 0 beside a table (p151), the own bit."""
    text = written(d, table("X", [-10.5, 0, 10.5], [0.0012, 0, -0.0034], backlash=0.0025))
    rows = [line for line in text.splitlines() if line[:1] not in ("#", "=")]
    name, linear = ("backLash", "linearCompValue") if d.id == NCK else ("MP710", "MP720")
    last = [] if d.id == NCK else ["MP730,,1,"]
    assert rows == [
        *("point,position,value,unit", "0,-10.5000,-0.0012,mm", "1,0.0000,0.0000,mm"),
        *("2,10.5000,0.0034,mm", f"{name},,0.0025,mm", f"{linear},,0.000,mm/m", *last),
    ]
    assert "# value: error\n" in text
    assert "\r" not in text
    assert text.startswith("== entry_X.csv\n")


def the_lines_of_a_sheet_are_statements(d: Definition) -> None:
    matchers = text_reader(d).matchers
    linear = "linearCompValue" if d.id == NCK else "MP720"
    lash = "backLash" if d.id == NCK else "MP710"
    lines = {
        "columns": "point,position,value,unit",
        "meaning": "# value: correction",
        "point": "12,-10.5000,+0.0012,mm",
        "backlash": f"{lash},,-0.0025,deg",
        "linear": f"{linear},,0.125,mm/m",
    } | ({} if d.id == NCK else {"nonlinear": "MP730,,1,"})
    for name, line in lines.items():
        assert matchers[name].match(line) is not None, line
        assert matchers[name].match(f"{line} more") is None, line
    point = matchers["point"].match(lines["point"])
    assert point is not None
    assert (point[1]["position"], point[1]["value"]) == ("-10.5000", "+0.0012")
    assert matchers["meaning"].match("# value: error") is not None
    if d.id == ITNC:
        assert matchers["nonlinear"].match("MP730,,2,") is None


def ranges(d: Definition) -> None:
    """Plausible values: positions to 100 m, table values to 10 mm; MP710 and MP720 to 1."""
    lash, linear = ("backLash", "linearCompValue") if d.id == NCK else ("MP710", "MP720")
    for rows, other in (
        ("0,{}100000,0,mm\n", "0,{}100001,0,mm\n"),
        ("0,0,{}10.0000,mm\n", "0,0,{}10.0001,mm\n"),
        (f"{lash},,{{}}1.0000,mm\n", f"{lash},,{{}}1.0001,mm\n"),
        (f"{linear},,{{}}1.000,mm/m\n", f"{linear},,{{}}1.001,mm/m\n"),
    ):
        for sign in ("", "-"):
            sheet(d, rows.format(sign))
            refused(InputError, partial(sheet, d, other.format(sign)))


def degrees(d: Definition) -> None:
    """On a rotary axis numbers are degrees, to 0.0001."""
    lash = "backLash" if d.id == NCK else "MP710"
    state = sheet(d, f"0,0,0.0010,deg\n1,90,0,deg\n{lash},,0.0020,deg\n", C)
    near(correction(state, "C", 0, PLUS), -0.001)
    near(correction(state, "C", 45, MINUS), -0.0005 + -0.002)
    rows = written(d, table("C", [0, 90], [0.001, 0], kind=AxisKind.ROTARY, backlash=0.002), C)
    assert "0,0.0000,-0.0010,deg\n1,90.0000,0.0000,deg\n" in rows
    assert f"{lash},,0.0020,deg" in rows


def ends(d: Definition) -> None:
    state = sheet(d, "0,0,0.0010,mm\n1,90,0.0030,mm\n")
    near(um(state, "X", -50), -1)
    near(um(state, "X", 500), -3)


def options_of_an_axis(d: Definition) -> None:
    turned = replace(X, options={"table_values": "correction", "max_points": 64})
    control = control_format(d, {})
    assert control.capacity(turned).max_points == 64
    assert control.capacity(X).max_points == 256
    assert "0,0.0000,0.0010,mm" in written(d, table("X", [0, 9], [0.001, 0]), turned)
    refused(UsageError, lambda: control_format(d, {"max_points": 64.5}))
    if d.id == NCK:
        both = replace(X, options={"backlash_column": "absent"})
        refused(InputError, lambda: read(d, file("X.COM", NCK_COM), axes=(both,)))
    else:
        powers = replace(X, options={"spacing_rule": "power_of_two"})
        assert control.capacity(powers).spacings is not None
        line = replace(X, options={"method": "line"})
        assert control.capacity(line).line == pytest.approx(1e-6)
        turning = replace(C, options={"method": "line"})
        refused(CapacityError, lambda: control.capacity(turning))


def at_most_256_points(d: Definition) -> None:
    """Module 9095 refuses longer tables (p622); MANUALplus 620 p715."""
    for count, fits in ((256, True), (257, False)):
        rows = "".join(f"{k},{k},0,mm\n" for k in range(count))
        if fits:
            sheet(d, rows)
        else:
            refused(InputError, partial(sheet, d, rows))
    control = control_format(d, {"max_points": 300})
    assert control.capacity(X).max_points == 256


def two_points(d: Definition) -> None:
    assert control_format(d, {}).capacity(X).min_points == 2


def diameter(d: Definition) -> None:
    assert d.diameter.tables == "unconfirmed"  # asked for by the job, see test_programmed_diameter


# --- tables and lists of an iTNC 530

COM = (
    "begin X      .com mm datum:-400 dist:16\r\nNR   1=f()     2=F()\r\n"
    "0    +0        +0.0001\r\n\r\n1    -0.0012   +0.0003\r\n2    -0.0021   -0.0006\r\n"
    "END   X      .COM\r\n"
)
CMA = "BEGIN C .CMA MM\nNR   1         2\n0    X\nEND C .CMA\n"
LIST = (
    "; parameters\nMP7: 12\n\n  MP710.0:-0.0040 ;X\nMP710.11 : 0.0010\nMP720.0 : +0.070\n"
    "mp730 : %00000\nother line\n"
)


def an_exported_table(d: Definition) -> None:
    close = COM.replace("X      .com", "X.com")
    for text, *files in (
        *((COM,), (close,), (COM, file("C.CMA", CMA)), (COM, file("C.CMA", CMA.lower()))),
    ):
        state = read(d, file("X.COM", text), *files)
        near(um(state, "X", -384), 1.2)
        near(um(state, "X", -376), 1.65)
        (cross,) = state.cross
        near(1000 * float(cross.at(np.array([-368.0]), PLUS)[0]), 0.6)
    other = file("C.CMA", CMA.replace("0    X", "0    Y"))
    refused(InputError, lambda: read(d, file("X.COM", COM), other))  # Y.COM was not given


def a_list_of_parameters(d: Definition) -> None:
    """A positive MP710 is lost motion, MP720 too far in mm/m; index and bit count from 0."""
    state = read(d, file("MP.TXT", LIST))
    near(um(state, "X", 100, PLUS), -7)
    near(um(state, "X", 100, MINUS), -7 + 4)
    near(um(read(d, file("MP.TXT", LIST.replace("0.0040 ;X", "0.0040"))), "X", 0, MINUS), 4)
    twice = LIST.replace("MP7: 12", "MP710.0 : 0.0050")
    refused(InputError, lambda: read(d, file("MP.TXT", twice)))
    refused(InputError, lambda: read(d, file("M.TXT", LIST.replace("mp730", "MP720.0 : 0\nmp730"))))
    refused(InputError, lambda: read(d, file("M.T", f"MP730 : %1\n{LIST}"), file("X.COM", COM)))
    for line, odd in (
        ("-0.0040 ;X", "-0.0040 X"), ("+0.070", "+0,070"), ("%00000", "%00000 X"),
        ("mp730 :", "MP730 ="), ("mp730 :", "MP730:="), ("MP720.0 :", "MP720.0"),
    ):  # fmt: skip
        refused(InputError, partial(read, d, file("M.T", LIST.replace(line, odd))))
    alone = read(d, file("MP.TXT", "MP720.0 : 0.1\n"))
    assert [one.code for one in alone.findings].count("CW-S005") == 1
    assert any("MP710" in one.fact for one in alone.assumed)


def a_list_that_is_patched(d: Definition) -> None:
    text = written(d, table("X", [0, 100], [0, 0.001], backlash=0.0025), X, file("M.T", LIST))
    wanted = LIST.replace("-0.0040", "0.0025").replace("+0.070", "+0.000")
    assert wanted.replace("%00000", "%00001") in text
    assert "MP7" not in text.split("== entry_X.csv")[1]


def the_line_alone(d: Definition) -> None:
    line = replace(X, options={"method": "line"})
    wanted = replace(table("X", [], []), slope=-70e-6)
    text = written(d, wanted, line)
    assert "MP720,,0.070,mm/m" in text
    assert "MP730,,0," in text


def a_steep_table(d: Definition) -> None:
    """Neighbours at most the spacing / 64 apart."""
    control_format(d, {}).write([table("X", [0, 6.4], [0, 0.1])], [X])
    refused(
        CapacityError,
        lambda: control_format(d, {}).write([table("X", [0, 6.4], [0, 0.1001])], [X]),
    )


def addresses_itnc(d: Definition) -> None:
    lower = axis_of("x")
    near(um(read(d, file("X.COM", COM), axes=(lower,)), "X", -384), 1.2)


# --- tables of an NCK control

NCK_COM = (
    "Begin X.com MM\r\nNR  AXISPOS    backlash   X          Y\r\n"
    "0   -400       +0.0040    +0.0000    +0.0000\r\n1   -200       +0.0021    -0.0018    +0.0015"
    "\r\n2   +0         +0.0043    +0.0007    +0.0030\r\n[End]\r\n"
)
NCK_CMA = "Begin Config.Cma MM\nNR  ACTIVE  X      Y\n0   *       X.COM\n[END]\n"


def a_table_of_an_nck(d: Definition) -> None:
    for files in ((), (file("c.cma", NCK_CMA),)):
        state = read(d, file("X.COM", NCK_COM), *files)
        near(um(state, "X", -100, PLUS), 0.55)
        near(um(state, "X", -100, MINUS), -3.2)
        (cross,) = state.cross
        near(1000 * float(cross.at(np.array([-200.0]), PLUS)[0]), -1.5)
    refused(InputError, lambda: read(d, file("X.COM", NCK_COM), file("c.cma", NCK_CMA[:-6])))


def addresses_nck(d: Definition) -> None:
    refused(InputError, lambda: read(d, file("X.COM", NCK_COM), axes=(axis_of("x"),)))


def a_sheet_of_an_nck(d: Definition) -> None:
    state = sheet(d, "backLash,,-0.0040,mm\nlinearCompValue,,0.070,mm/m\n")
    near(um(state, "X", 100, PLUS), -7)
    near(um(state, "X", 100, MINUS), -7 + 4)
    for row in ("backLash,,0.{},mm\n", "linearCompValue,,0.{},mm/m\n"):
        refused(InputError, partial(sheet, d, row.format(1) + row.format(2)))
    alone = sheet(d, "linearCompValue,,0.1,mm/m\n")
    assert "CW-S005" in [one.code for one in alone.findings]


BOTH: tuple[Check, ...] = (
    gate, a_sheet_as_it_is_written, the_lines_of_a_sheet_are_statements, ranges, degrees, ends,
    options_of_an_axis, at_most_256_points, two_points, diameter,
)  # fmt: skip
CHECKS: dict[str, tuple[Check, ...]] = {
    ITNC: (*BOTH, an_exported_table, a_list_of_parameters, a_list_that_is_patched, the_line_alone,
           a_steep_table, addresses_itnc),
    NCK: (*BOTH, a_table_of_an_nck, addresses_nck, a_sheet_of_an_nck),
}  # fmt: skip


@pytest.mark.parametrize("name", CHECKS)
def test_the_checks_hold(name: str) -> None:
    for check in CHECKS[name]:
        check(DEFINITIONS[name])


@pytest.mark.parametrize("name", CHECKS)
def test_every_fact_that_is_turned_lets_a_check_fall(name: str) -> None:
    checks = {check.__name__: check for check in CHECKS[name]}
    unnoticed = [what for what, text in mutants(name) if not falls(text, checks)]
    rules = [re.compile(pattern) for pattern in DECIDES_NOTHING]
    assert [what for what in unnoticed if not any(rule.match(what) for rule in rules)] == []


def test_what_decides_nothing_is_in_a_definition() -> None:
    every = [what for name in CHECKS for what, _ in mutants(name)]
    for pattern in DECIDES_NOTHING:
        assert any(re.match(pattern, what) for what in every), pattern
