"""Every fact of the SINUMERIK definition decides something: removed or turned, one of a few checks
falls.

What lines do is said here by hand, from the manuals' facts, and by the tests' own virtual control.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from compwright.formats.card import points_needed
from compwright.formats.definition.inheritance import DefinitionText
from compwright.formats.definition.schema import Definition
from compwright.formats.families.pairs.axis_pairs import write_cross
from compwright.formats.families.shapes import control_format
from compwright.formats.gate import check_definition
from compwright.foundations.errors import CompwrightError, InputError
from compwright.records.axis import Axis, AxisKind, Direction, Encoder
from compwright.records.correction import (
    ControlFile,
    ControlState,
    CrossCompensation,
)
from format_samples import DEFINITIONS, codes, files, table
from mutants import Check, falls, merged_definition, mutants
from sinumerik_archive import cec_lines, eec_lines
from virtual_sinumerik import VirtualSinumerik

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
SIGN = {UP: 1, DOWN: -1}
#: mm or deg: doubles, far below the millionth that a control prints.
SAME = 1e-9

X = Axis(name="X", kind=AxisKind.LINEAR, travel=(0.0, 800.0), address="AX1")
Y = replace(X, name="Y", address="AX2", encoder=Encoder(stated=False), travel=(0.0, 400.0))
Z = replace(X, name="Z", address="AX3", travel=(0.0, 100.0))
B = replace(X, name="B", kind=AxisKind.ROTARY, address="AX4", travel=(-90.0, 90.0))
C = replace(B, name="C", address="AX5", travel=(0.0, 360.0), modulo=360.0)
D = replace(C, name="D", address="AX6")
ALL = (X, Y, B, C)

EEC = (
    eec_lines("AX1", 0, 10.0, 200.0, [0.001, 0.004, -0.002, 0.003, 0.0], modulo=False)
    + eec_lines("AX2", 1, 0.0, 100.5, [0.0, 0.002, -0.004], modulo=False)
    + eec_lines("AX4", 0, -90.0, 45.0, [0.0, 0.001, -0.002, 0.003, 0.0], modulo=False)
    + eec_lines("AX5", 0, 0.0, 90.0, [0.001, 0.002, -0.002, 0.003, 0.001], modulo=True)
)
CEC = (
    cec_lines(3, "AX1", "AX1", 10, 400, [0.01, -0.02, 0.03], direction=1)
    + cec_lines(4, "AX1", "AX1", 10, 400, [0.0, 0.004, 0.001], direction=-1)
    + cec_lines(5, "AX2", "AX1", -50, 100, [0.0, 0.005, 0.001])
    + cec_lines(6, "AX5", "AX4", 0, 120, [0.002, 0.001, 0.0, 0.002], modulo=1)
)
MD = (
    "$MA_ENC_COMP_ENABLE[0,AX1]=1\n$MA_ENC_COMP_ENABLE[1,AX2]=1\n$MA_ENC_COMP_ENABLE[0,AX4]=1\n"
    "$MA_ENC_COMP_ENABLE[0,AX5]=1\n$MA_BACKLASH[0,AX1]=0.002\n$MA_BACKLASH[1,AX2]=-0.001\n"
    "$MA_BACKLASH[0,AX4]=0.003\n$MA_BACKLASH[0,AX5]=0\n$MA_CEC_ENABLE[AX1]=1\n$MA_CEC_ENABLE[AX4]=1\n"
    "$MA_CEC_MAX_SUM[AX1]=1\n$MA_CEC_MAX_SUM[AX4]=1\n$MA_IS_ROT_AX[AX4]=1\n$MA_IS_ROT_AX[AX5]=1\n"
    "$MA_ROT_IS_MODULO[AX5]=1\n$MA_MODULO_RANGE[AX5]=360\n$MA_MODULO_RANGE_START[AX5]=0\n"
    + "".join(f"$SN_CEC_TABLE_ENABLE[{index}]=1\n" for index in (3, 4, 5, 6))
)
BASE = EEC + CEC + MD
OURS: dict[str, object] = {"cec_tables": [3, 4], "cec_sign": "error"}


def text_of(*parts: str, unit: str = "METRIC\n") -> list[ControlFile]:
    return files(A__INI=unit + "CHANDATA(1)\n" + "".join(parts) + "M17\n")


def read(
    definition: Definition, given: Sequence[ControlFile], *axes: Axis, **options: object
) -> ControlState:
    return control_format(definition, {**OURS, **options}).read(given, axes or ALL)


def refused(action: Callable[..., object], *args: Any, **more: Any) -> str:
    """Why something is refused; empty where it is not."""
    try:
        action(*args, **more)
    except CompwrightError as error:
        return str(error)
    return ""


@cache
def physics(text: str) -> VirtualSinumerik:
    control = VirtualSinumerik(cec_sign=-1.0, used={"AX2": 1})
    control.load(text, protected=False)
    return control


PLACES = np.linspace(-300.0, 1200.0, 301) + 0.07


def agrees(state: ControlState, text: str) -> None:
    for address, axis in state.axes.items():
        for direction in Direction:
            there = physics(text).correction(address, PLACES, SIGN[direction])
            if address in ("AX1", "AX4"):  # a table from an axis that stands still: a constant
                there = there - there[150] + axis.at(PLACES, direction)[150]
            assert np.abs(axis.at(PLACES, direction) - there).max() < SAME, (address, direction)


# --- what is read
# --------------------------------------------------------------------------------------------------


def gate(definition: Definition) -> None:
    assert check_definition(definition) == ()


def acts(definition: Definition) -> None:
    """Everything together, as the virtual control does it, and the cross-axis tables."""
    (given,) = text_of(BASE)
    state = read(definition, [given])
    agrees(state, given.content.decode())
    assert state.facts["AX2"].encoder_system == 2
    found = {(one.input, one.output): one for one in state.cross}
    assert found["AX2", "AX1"].positions.tolist() == [-50, 50, 150]
    assert found["AX2", "AX1"].positive.tolist() == [0, -0.005, -0.001]
    assert found["AX5", "AX4"].period == 360
    assert state.tables.used == {
        3: ("AX1", "AX1"),
        4: ("AX1", "AX1"),
        5: ("AX2", "AX1"),
        6: ("AX5", "AX4"),
    }
    assert state.facts["AX1"].pairs.own == (3, 4)


def absent(definition: Definition) -> None:
    """What no file says: a table is on and does not repeat, there is no backlash, the axis has
    ends. All of it is told.
    """
    eec, cec = (
        eec_lines("AX1", 0, 0.0, 200.0, [0.001, 0.004], modulo=False),
        cec_lines(3, "AX1", "AX1", 0, 400, [0.01, -0.02], direction=1),
    )
    silent = re.compile(r"^\$(AA_ENC_COMP|AN_CEC)_IS_MODULO.*\n", re.MULTILINE)
    given = text_of(silent.sub("", eec), silent.sub("", cec))
    told = " ".join(f"{each.fact} {each.value}" for each in read(definition, given, X).assumed)
    state = control_format(definition, OURS).read(given, address="AX1")
    # errors: 1 and 4 µm of the one, 10 and -20 of the other, both taken away; the ends stay
    found = state.axes["AX1"].at(np.array([-50.0, 0.0, 200.0, 900.0]), Direction.POSITIVE)
    assert np.allclose(found, [-0.011, -0.011, 0.001, 0.016], atol=SAME), found
    assert state.axes["AX1"].backlash == 0.0
    assert state.axes["AX1"].kind is AxisKind.LINEAR
    assert "CW-S005" in codes(state)
    assert "IS_MODULO" in told


def forms(definition: Definition) -> None:
    """Forms that other programs write, letters of both cases, blanks, checksums, both line ends."""
    plain = read(definition, text_of(BASE))
    shapes: Sequence[Callable[[str], str]] = (
        lambda text: re.sub(r"^(\$AA_ENC_COMP\w*\[.*?\])=", r"\1 ", text, flags=re.MULTILINE),
        lambda text: re.sub(r"_AXIS\[(\d)\]=\((\w+)\)", r"_AXIS[\1]=\2", text),
        lambda text: re.sub(r"=(?=[-\d])", " = ", text).replace("[0,", "[ 0 , "),
        lambda text: text.lower(),
        lambda text: text.replace("\n", "\r\n"),
        lambda text: re.sub(r"^(\$MA.*)$", r"N32450 \1 '0a1b", text, flags=re.MULTILINE),
        lambda text: text.replace("\n", "\n\n").replace("M17", ";$PATH=/_N\nM17"),
        *(
            lambda text, one=one: (
                text.replace("ENABLE[0,AX1]=1", f"ENABLE[0,AX1]={one}")
                .replace("MODULO[0,AX5]=1", f"MODULO[0,AX5]={one}")
                .replace("MODULO[6]=1", f"MODULO[6]={one}")
            )
            for one in ("TRUE", "1.0", "+1", "01", "1.0EX0", "10EX-1", "'H1'", "'h01'", "'B001'")
        ),
    )
    for shape in shapes:
        given = files(A__INI=shape(text_of(BASE)[0].content.decode()))
        state = read(definition, given)
        for name, axis in plain.axes.items():
            assert np.array_equal(state.axes[name].at(PLACES, UP), axis.at(PLACES, UP)), name
        assert len(state.cross) == 2
    lower = read(definition, text_of(BASE), replace(X, address="ax1"))
    assert list(lower.axes) == ["AX1"]
    assert refused(read, definition, text_of(BASE, "$AN_CEC_ FOO[9]=7\n"), X)
    for end in ("M17", "M30", "M02", "M2", "M0"):
        whole = files(A__INI=f"METRIC\n{BASE}{end}\n")
        assert "CW-S002" not in codes(read(definition, whole)), end
    assert "CW-S002" in codes(read(definition, files(A__INI=f"METRIC\n{BASE}")))


#: A line, what stands before it and no longer counts, whose facts are looked at, and what they say.
def reserved(state: ControlState, _address: str) -> int:
    """The points of table 5."""
    return state.tables.reserved[5]


def from_y(state: ControlState, _address: str) -> list[float] | None:
    """What AX2 does to AX1."""
    return shown(state, "AX2")


LAST: Sequence[tuple[str, str, str, Axis, Callable[[Any, str], object], object]] = (
    ("$MA_BACKLASH[0,AX1]", "0.001", "0.0025", X, lambda s, a: s.axes[a].backlash, 0.0025),
    ("$MA_BACKLASH_FACTOR[0,AX1]", "1", "1.5", X, lambda s, a: s.axes[a].backlash, 0.003),
    ("$MA_ENC_COMP_ENABLE[0,AX1]", "1", "FALSE", X, lambda s, a: s.facts[a].enabled, False),
    ("$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]", "99", "7", X, lambda s, a: s.facts[a].stated["max_points"], 7),
    ("$MA_ROT_IS_MODULO[AX5]", "0", "TRUE", C, lambda s, a: s.facts[a].turn is not None, True),
    ("$MA_MODULO_RANGE[AX5]", "300", "360.0", C, lambda s, a: s.facts[a].turn.length, 360.0),
    ("$MA_MODULO_RANGE_START[AX6]", "0", "-180.5", D, lambda s, a: s.facts[a].turn.start, -180.5),
    ("$MA_POS_LIMIT_MINUS[AX1]", "-5", "-10.5", X, lambda s, a: s.facts[a].limits[0], -10.5),
    ("$MA_POS_LIMIT_PLUS[AX1]", "5", "810.25", X, lambda s, a: s.facts[a].limits[1], 810.25),
    ("$MN_AXCONF_MACHAX_NAME_TAB[0]", '"X3"', '"X3"', X, lambda s, a: s.facts[a].name, "X3"),
    ("$MC_AXCONF_CHANAX_NAME_TAB[2]", '"U"', '"U"', X, lambda s, a: s.facts[a].name, "U"),
    ("$MC_AXCONF_MACHAX_USED[2]", "2", "2", Y, lambda s, a: s.facts[a].name, "U"),
    ("$MA_BACKLASH_DYN[0,AX1]", "0", "0.0025", X, lambda s, a: "MD32456[0] = 0.0025" in s.facts[a].other_functions, True),
    ("$MA_TEMP_COMP_TYPE[AX1]", "'H0'", "'H3'", X, lambda s, a: "MD32750" in s.facts[a].other_functions, True),
    ("$SA_TEMP_COMP_SLOPE[AX1]", "0", "1.5E-05", X, lambda s, a: "SD43910 = 1.5e-05" in s.facts[a].other_functions, True),
    ("$SN_CEC_TABLE_ENABLE[5]", "1", "FALSE", X, from_y, None),
    ("$MA_CEC_ENABLE[AX1]", "0", "TRUE", X, from_y, [0, -0.005, -0.001]),
    ("$SN_CEC_TABLE_WEIGHT[5]", "1", "0.5", X, from_y, [0, -0.0025, -0.0005]),
    ("$MA_CEC_MAX_SUM[AX1]", "1", "0.25", X, lambda s, a: s.facts[a].pairs.max_sum, 0.25),
    ("$MA_CEC_SCALING_SYSTEM_METRIC[AX1]", "FALSE", "TRUE", X, lambda s, a: (s.facts[a].pairs.metric, shown(s, "AX2")), (True, [0, -0.005, -0.001])),
    ("$MN_MM_CEC_MAX_POINTS[5]", "99", "7", X, reserved, 7),
    ("$AN_CEC_TYPE[5]", "0", "1", X, from_y, None),
    ("$AN_CEC_INPUT_NCU[5]", "1", "2", X, from_y, None),
    ("$AN_CEC_OUTPUT_NCU[5]", "1", "2", X, from_y, None),
    ("$SN_CEC_0[5]", "0", "0.001", X, from_y, None),
    ("$SN_CEC_1[5]", "0", "0.001", X, from_y, None),
    ("$AN_CEC_FOO[5]", "7", "8.5", X, from_y, None),
)  # fmt: skip
#: What stands in the files beside a line, where it means nothing alone.
FOREIGN = cec_lines(5, "AX2", "AX1", -50, 100, [0.0, 0.005, 0.001]) + "$SN_CEC_TABLE_ENABLE[5]=1\n"
WITH = {
    "$MA_CEC_ENABLE[AX1]": FOREIGN,
    "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]": FOREIGN,
    "$MA_MODULO_RANGE_START[AX6]": "$MA_ROT_IS_MODULO[AX6]=1\n$MA_IS_ROT_AX[AX6]=1\n$MA_BACKLASH[0,AX6]=0\n",
    "$MA_POS_LIMIT_MINUS[AX1]": "$MA_POS_LIMIT_PLUS[AX1]=900\n",
    "$MA_POS_LIMIT_PLUS[AX1]": "$MA_POS_LIMIT_MINUS[AX1]=0\n",
    "$MC_AXCONF_CHANAX_NAME_TAB[2]": "$MC_AXCONF_MACHAX_USED[2]=1\n",
    "$MC_AXCONF_MACHAX_USED[2]": '$MC_AXCONF_CHANAX_NAME_TAB[2]="U"\n$MA_BACKLASH[1,AX2]=0\n',
    "$MA_TEMP_COMP_TYPE[AX1]": "$SA_TEMP_COMP_SLOPE[AX1]=0.00001\n",
    "$SA_TEMP_COMP_SLOPE[AX1]": "$MA_TEMP_COMP_TYPE[AX1]='B10'\n",
}


def shown(state: ControlState, base: str) -> list[float] | None:
    return next((one.positive.tolist() for one in state.cross if one.input == base), None)


def part_of(register: str) -> str:
    """The lines of BASE that concern the axis or the table of a register, and the axis AX1."""
    inside = register.partition("[")[2].rstrip("]")
    address = inside.rpartition(",")[2] if "AX" in inside else "AX1"
    index = inside.partition(",")[0] if register.startswith(("$AN_", "$SN_", "$MN_MM")) else "-"
    mine = re.compile(rf"AX1\]|{address}\]|CEC\w*\[{index}[],]")
    lines = [line for line in BASE.splitlines() if mine.search(line)]
    return "\n".join(line for line in lines if not line.startswith(register + "=")) + "\n"


def last(entry: Any) -> Check:
    """Machine data and setting data: the last value of a file counts, and each does what it says.
    A line with something behind it is none.
    """
    register, before, value, axis, fact, expected = entry

    def check(definition: Definition) -> None:
        base = part_of(register) + WITH.get(register, "")
        given = text_of(base, f"{register}={before}\n{register}={value}\n")
        assert fact(read(definition, given, axis), axis.address) == expected, register
        first = f"{register}={before}\n" if before != value else ""
        garbled = text_of(base, first, f"{register}={value} G1\n")
        try:
            state = read(definition, garbled, axis)
        except InputError:
            return  # a line of compensation that cannot be read
        assert fact(state, axis.address) != expected, register

    return check


def kinds(definition: Definition) -> None:
    """MD30300 by number and word, MD30200, names of MD10000, where no job says them."""
    for other, value, kind in (("0", "TRUE", AxisKind.ROTARY), ("1", "0", AxisKind.LINEAR)):
        given = text_of(EEC, f"$MA_IS_ROT_AX[AX1]={other}\n$MA_IS_ROT_AX[AX1]={value}\n")
        state = control_format(definition, {}).read(given, address="AX1")
        assert (state.axes["AX1"].kind, state.facts["AX1"].kind) == (kind, kind)
    both = text_of(
        EEC, eec_lines("AX2", 0, 0, 100, [0, 0.5, 0], modulo=False), "$MA_NUM_ENCS[AX2]=2\n"
    )
    assert "both measuring systems" in refused(read, definition, both, Y)
    one = text_of(
        both[0].content.decode().split("(1)\n")[1].replace("M17\n", ""), "$MA_NUM_ENCS[AX2]=1\n"
    )
    assert read(definition, one, Y).facts["AX2"].encoder_system == 1
    turn = EEC + MD.replace("$MA_MODULO_RANGE[AX5]=360", "$MA_MODULO_RANGE[AX5]=300")
    assert refused(read, definition, text_of(turn), C)
    named = text_of(EEC, '$MN_AXCONF_MACHAX_NAME_TAB[1]="Y1"\n')
    assert list(read(definition, named, replace(Y, address="Y1")).axes) == ["Y1"]
    for line in ("$MA_NUM_ENCS[AX2]=1 G1", '$MN_AXCONF_MACHAX_NAME_TAB[1]="Y1" G1'):
        assert refused(read, definition, text_of(both[0].content.decode()[18:-4], line + "\n"), replace(Y, address="Y1" if "NAME" in line else "AX2"))  # fmt: skip


def added(definition: Definition) -> None:
    """SD41320 and SD41321: what is added to points 0 and 1 of a table; zero changes nothing."""
    base = EEC + FOREIGN + "$MA_CEC_ENABLE[AX1]=1\n"
    for name in ("$SN_CEC_0", "$SN_CEC_1"):
        for value, shows in (("0", [0, -0.005, -0.001]), ("0.001", None)):
            state = read(definition, text_of(base, f"{name}[5]={value}\n"), X)
            assert from_y(state, "AX1") == shows, name


def names(definition: Definition) -> None:
    """What stops an axis, by the name of the parameter."""
    for line, why in (
        ("$MA_GANTRY_AXIS_TYPE[AX1]=0\n$MA_GANTRY_AXIS_TYPE[AX1]=11", "MD37100"),
        ("$MN_SCALING_USER_DEF_MASK='H0'\n$MN_SCALING_USER_DEF_MASK='H801'", "MD10220"),
        ("$MN_SCALING_SYSTEM_IS_METRIC=FALSE", "this line says inch"),
        ("$MN_SCALING_SYSTEM_IS_METRIC=1\n$MN_SCALING_SYSTEM_IS_METRIC=0", "this line says inch"),
        ("INCH", "this line says inch"),
        ("$MA_IS_ROT_AX[AX1]=1", "is linear in the job and rotary in the control's files"),
    ):
        assert why in refused(read, definition, text_of(BASE, line + "\n"), X), line
        first = line.splitlines()[-1]
        garbled = text_of(BASE, line.replace(first, first + " G1") + "\n")
        assert why not in refused(read, definition, garbled, X), line


def inches(definition: Definition) -> None:
    """By number, by word and by option; MD10250 counts then."""
    for unit, more, given in (
        ("", "$MN_SCALING_SYSTEM_IS_METRIC=FALSE\n", {}),
        ("INCH\n", "", {}),
        ("", "", {"units": "inch"}),
    ):
        state = read(definition, text_of(EEC, more, unit=unit), X, B, **given)
        assert state.axes["AX1"].positions.tolist() == [254, 5334, 10414, 15494, 20574]
        assert state.axes["AX4"].positions.tolist() == [-90, -45, 0, 45, 90]
        for value in ("25.4", "25.5", "25.5 G1"):
            first = "" if "G1" in value else "$MN_SCALING_VALUE_INCH=25\n"
            line = f"{first}$MN_SCALING_VALUE_INCH={value}\n"
            why = refused(read, definition, text_of(EEC, more, line, unit=unit), X, **given)
            assert ("MD10250" in why) is (value == "25.5" and not given)
    metric = text_of(EEC, "$MN_SCALING_SYSTEM_IS_METRIC=1\n", unit="")
    assert read(definition, metric, X).facts["AX1"].stated["length_unit"] == "mm"
    state = read(definition, text_of(EEC), X)
    why = refused(control_format(definition, {"units": "inch"}).in_state, state, strict=True)
    assert "contradicts the control's own files" in why
    assert "length_unit" not in read(definition, text_of(EEC, unit=""), X).facts["AX1"].stated
    assert control_format(definition, {}).options["units"] == "mm"


#: Lines of a table: said twice and differently, the file contradicts itself.
TWICE = (
    ("$AA_ENC_COMP[0,1,AX1]", "0.5"),
    ("$AA_ENC_COMP_MIN[0,AX1]", "20"),
    ("$AA_ENC_COMP_MAX[0,AX1]", "1010"),
    ("$AA_ENC_COMP_STEP[0,AX1]", "100"),
    ("$AA_ENC_COMP_IS_MODULO[0,AX1]", "1"),
    ("$AN_CEC[3,1]", "0.5"),
    ("$AN_CEC_MIN[3]", "20"),
    ("$AN_CEC_MAX[3]", "1210"),
    ("$AN_CEC_STEP[3]", "200"),
    ("$AN_CEC_DIRECTION[3]", "0"),
    ("$AN_CEC_MULT_BY_TABLE[3]", "1"),
    ("$AN_CEC_IS_MODULO[3]", "1"),
    ("$AN_CEC_INPUT_AXIS[3]", "(AX2)"),
    ("$AN_CEC_OUTPUT_AXIS[3]", "(AX2)"),
)


def twice(entry: tuple[str, str]) -> Check:
    """A line of a table that stands twice and differs, is garbled or missing."""
    register, other = entry

    def check(definition: Definition) -> None:
        line = re.search(rf"^{re.escape(register)}=(.*)$", BASE, re.MULTILINE)
        assert line is not None
        base = part_of(register)
        for first, second in ((line[1], other), (other, line[1])):
            given = text_of(base, f"{register}={first}\n{register}={second}\n")
            assert "contradicts" in refused(read, definition, given, X), register
        assert refused(read, definition, text_of(base, line[0] + " G1\n"), X), register
        if "MULT" not in register and "MODULO" not in register:
            assert refused(read, definition, text_of(base), X), register

    return check


def tables(definition: Definition) -> None:
    """Products, and what repeats."""
    products = BASE.replace("MULT_BY_TABLE[3]=0", "MULT_BY_TABLE[3]=12")
    assert "multiplied by table 11" in refused(read, definition, text_of(products), X)
    repeats = cec_lines(9, "AX2", "AX1", 0, 100, [0.001, 0.002, 0.001], modulo=1)
    for value, period in (("TRUE", 200), ("FALSE", None)):
        text = repeats.replace("IS_MODULO[9]=1", f"IS_MODULO[9]={value}")
        state = read(definition, text_of(EEC, text), X)
        assert state.cross[0].period == period
    silent = repeats.replace("$AN_CEC_IS_MODULO[9]=1\n", "").replace(
        "$AN_CEC_MULT_BY_TABLE[9]=0\n", ""
    )
    assert read(definition, text_of(EEC, silent), X).cross[0].period is None
    quiet = EEC.replace("$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n", "")
    assert read(definition, text_of(quiet), X).axes["AX1"].period is None


def ranges(definition: Definition) -> None:
    """What is no length and no correction that a machine has is refused, large ones are not."""
    far = "$AA_ENC_COMP{}[0,AX1]={}\n"
    for low, step, high, value, sound in (
        (-60000, 60000, 60000, 9.9, True),
        (-60000, 60000, 60000, -9.9, True),
        (0, 5, 10, 0, True),
        (60000, 15000, 90000, 0.001, True),
        (-90000, 15000, -60000, 0.001, True),
        (-150000, 75000, 0, 0.001, False),
        (0, 75000, 150000, 0.001, False),
        (-90000, 105000, 15000, 0.001, False),
        (0, 100, 200, 10.5, False),
        (0, 100, 200, -10.5, False),
    ):
        text = "".join(f"$AA_ENC_COMP[0,{n},AX1]={v}\n" for n, v in enumerate((0, value, 0)))
        text += "".join(
            far.format(key, number)
            for key, number in (("_MIN", low), ("_STEP", step), ("_MAX", high))
        )
        assert bool(refused(read, definition, text_of(text), X)) is not sound, (low, step, high, value)  # fmt: skip
        pair = (
            text.replace("[0,0,AX1]", "[3,0]")
            .replace("[0,1,AX1]", "[3,1]")
            .replace("[0,2,AX1]", "[3,2]")
        )
        pair = pair.replace("[0,AX1]", "[3]").replace("AA_ENC_COMP", "AN_CEC")
        pair += (
            "$AN_CEC_INPUT_AXIS[3]=(AX1)\n$AN_CEC_OUTPUT_AXIS[3]=(AX1)\n$AN_CEC_DIRECTION[3]=0\n"
        )
        why = refused(read, definition, text_of(EEC, pair, "$MA_CEC_MAX_SUM[AX1]=20\n"), X)  # fmt: skip
        assert bool(why) is not sound, (low, step, high, value, why)
    for lost, fine in (("9.9", True), ("-9.9", True), ("10.5", False), ("-10.5", False)):
        given = text_of(EEC, f"$MA_BACKLASH[0,AX1]={lost}\n")
        assert bool(refused(read, definition, given, X)) is not fine, lost


def claims(definition: Definition) -> None:
    """A line of compensation that cannot be read is never passed over."""
    for line in (
        "$AA_ENC_COMP[0,AX1]=0.001",
        "$MA_ENC_COMP_ENABLE[AX1]=1",
        "$MA_BACKLASH[AX1]=0.001",
        "$MA_BACKLASH_FACTOR[AX1]=1",
        "$MA_MM_ENC_COMP_MAX_POINTS[AX1]=9",
        "$AN_CEC(3)=1",
        "$MA_CEC_ENABLE[0,AX1]=1",
        "$SN_CEC_TABLE_ENABLE[3,0]=1",
        "$MA_CEC_MAX_SUM[0,AX1]=1",
        "$MN_MM_CEC_MAX_POINTS=9",
        "$MA_CEC_SCALING_SYSTEM_METRIC[0,AX1]=1",
    ):
        assert refused(read, definition, text_of(BASE, line + "\n"), X), line
        cut = line.partition("=")[0]  # no assignment: only the claim holds it
        assert refused(read, definition, text_of(BASE, cut + "\n"), X), cut


# --- what is written
# --------------------------------------------------------------------------------------------------

ONE = table("AX1", [0.123456, 0.246912], [0.000001, -0.000234], backlash=0.000007)
TWO = replace(ONE, negative=ONE.positive * -2, backlash=0.0)
FILES = {
    "AX1_EEC.INI": (
        "%_N_AX_EEC_INI\nCHANDATA(1)\n$AA_ENC_COMP[0,0,AX1]=-0.000001\n$AA_ENC_COMP[0,1,AX1]=0.000234\n"
        "$AA_ENC_COMP_STEP[0,AX1]=0.123456\n$AA_ENC_COMP_MIN[0,AX1]=0.123456\n"
        "$AA_ENC_COMP_MAX[0,AX1]=0.246912\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\nM17\n"
    ),
    "AX1_MD.INI": (
        "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.000007\n$MA_ENC_COMP_ENABLE[0,AX1]=1\nM17\n"
    ),
}


def pair_text(index: int, values: Sequence[str], direction: str, pair: tuple[str, str]) -> str:
    lines = [f"$AN_CEC[{index},{n}]={value}" for n, value in enumerate(values)]
    said = {
        "INPUT_AXIS": f"({pair[0]})",
        "OUTPUT_AXIS": f"({pair[1]})",
        "MIN": "0.123456",
        "MAX": "0.246912",
        "STEP": "0.123456",
        "DIRECTION": direction,
        "MULT_BY_TABLE": "0",
        "IS_MODULO": "0",
    }
    return "\n".join([*lines, *(f"$AN_CEC_{key}[{index}]={text}" for key, text in said.items())])


PAIR_FILES = {
    "AX1_CEC.INI": "%_N_NC_CEC_INI\nCHANDATA(1)\n"
    + pair_text(3, ("-0.000001", "0.000234"), "1", ("AX1", "AX1"))
    + "\n"
    + pair_text(4, ("0.000002", "-0.000468"), "-1", ("AX1", "AX1"))
    + "\nM17\n",
    "AX1_MD.INI": "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.000000\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n"
    "; by hand: $MA_CEC_ENABLE[AX1]=1\n"
    "$SN_CEC_TABLE_ENABLE[3]=1\n$SN_CEC_TABLE_ENABLE[4]=1\nM17\n",
}
CROSS_FILES = {
    "AX2_CROSS.INI": "%_N_NC_CEC_INI\nCHANDATA(1)\n"
    + pair_text(3, ("-0.000001", "0.000234"), "0", ("AX1", "AX2"))
    + "\n; by hand: $SN_CEC_TABLE_ENABLE[3]=1\n; by hand: $MA_CEC_ENABLE[AX2]=1\nM17\n",
}


def numbers(text: str) -> list[str]:
    """Lines with numbers without zeros at their end, sorted: their order is no fact."""
    return sorted(re.sub(r"(\.\d*?)0+$", r"\1", line).rstrip(".") for line in text.splitlines())


def same_files(written: Sequence[ControlFile], expected: Mapping[str, str]) -> None:
    found = {file.name: file.content.decode() for file in written}
    assert len(written) == len(expected)
    assert {name: numbers(text) for name, text in found.items()} == {
        name: numbers(text) for name, text in expected.items()
    }
    for name, text in expected.items():
        assert found[name].splitlines()[:2] == text.splitlines()[:2]
        assert found[name].endswith("\nM17\n")


def fresh(definition: Definition) -> None:
    """New files, letter by letter; what their text cannot say exactly is refused."""
    control = control_format(definition, {**OURS, "cec": "available"})
    same_files(control_format(definition, OURS).write([ONE], [X]), FILES)
    same_files(control.write([TWO], [X]), PAIR_FILES)
    bent = CrossCompensation(
        input="AX1",
        output="AX2",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=ONE.positions,
        positive=ONE.positive,
        negative=ONE.negative,
    )
    same_files(write_cross(control, [bent]), CROSS_FILES)
    for one, two in ((ONE, False), (TWO, True)):
        bound = control if two else control_format(definition, OURS)
        capacity = bound.capacity(X, one_curve=not two)
        assert (capacity.quantum, capacity.position_quantum) == pytest.approx(
            (1e-6, 1e-6), rel=1e-9
        )
        step = replace(one, positions=np.array([0.1, 0.2000001]))
        start = replace(one, positions=np.array([0.1000001, 0.2000001]))
        half = np.array([0.1, 0.1000005, 0.100001])  # ends that can be said, a step that cannot
        between = replace(
            one, positions=half, positive=0 * half, negative=np.array([0, 1e-6 * two, 0])
        )
        for broken in (step, start, between):
            assert refused(bound.write, [broken], [X])
    turning = replace(TWO, address="AX4", kind=AxisKind.ROTARY)
    for each in control.write([turning], [B]):
        if each.name == "AX4_CEC.INI":
            same_files([each], {"AX4_CEC.INI": PAIR_FILES["AX1_CEC.INI"].replace("AX1", "AX4")})
    alone = replace(ONE, address="AX4", kind=AxisKind.ROTARY)
    written = control_format(definition, {}).write([alone], [B])
    same_files(
        written, {n.replace("AX1", "AX4"): t.replace("AX1", "AX4") for n, t in FILES.items()}
    )
    endless = replace(
        table("AX5", [0.0, 180.0, 360.0], [0.0, 0.001, 0.0], kind=AxisKind.ROTARY), period=360.0
    )
    state = read(definition, text_of(BASE), C)
    one_turn, _ = control_format(definition, OURS, state).write([endless], [C])
    assert "$AA_ENC_COMP_IS_MODULO[0,AX5]=1\n" in one_turn.content.decode()
    repeating = replace(endless, negative=-endless.negative)
    free = {**OURS, "cec": "available", "cec_tables": [8, 9]}
    (paired, *_) = control_format(definition, free, state).write([repeating], [C])
    assert "$AN_CEC_IS_MODULO[8]=1\n" in paired.content.decode()


def patched(definition: Definition) -> None:
    """Into the control's own files, switched on again where they end with it off."""
    off = BASE.replace("$MA_ENC_COMP_ENABLE[0,AX1]=1", "$MA_ENC_COMP_ENABLE[0,AX1]=0")
    off = off.replace("TABLE_ENABLE[3]=1", "TABLE_ENABLE[3]=0").replace(
        "_ENABLE[4]=1", "_ENABLE[4]=0"
    )
    off = off.replace("$SN_CEC_TABLE_ENABLE[5]=1", "$SN_CEC_TABLE_ENABLE[5]=0")
    off = off.replace("$MA_CEC_ENABLE[AX1]=1", "$MA_CEC_ENABLE[AX1]=0")
    off += "$SN_CEC_TABLE_WEIGHT[3]=2\n$MN_MM_CEC_MAX_POINTS[3]=2\n$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=2\n"
    tables, md = off.split("$MA_ENC_COMP_ENABLE", 1)
    given = files(T__INI=f"METRIC\n{tables}M17\n", MD__INI=f"METRIC\n$MA_ENC_COMP_ENABLE{md}M17\n")
    wanted = table("AX1", [10.0, 410.0, 810.0], [0.0, 0.001, 0.002], backlash=0.004)
    for two in (False, True):
        options: dict[str, object] = {**OURS, "points": 9, **({"cec": "available"} if two else {})}
        state = read(definition, given, X, **options)
        new = replace(wanted, negative=wanted.negative * -3, backlash=0.0) if two else wanted
        written = {
            f.name: f for f in control_format(definition, options, state).write([new], [X], given)
        }
        texts = [written.get(file.name, file).content.decode() for file in given]
        text, loaded = "".join(texts), VirtualSinumerik(cec_sign=-1.0)
        for each in texts:
            loaded.load(each, protected=False)
        for direction in Direction:
            there = loaded.correction("AX1", PLACES, SIGN[direction])
            assert np.abs(new.at(PLACES, direction) - there).max() < SAME, two
        assert f"$MN_MM_CEC_MAX_POINTS[3]={9 if two else 2}\n" in text
        assert f"$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]={2 if two else 9}\n" in text


# --- options and limits
# --------------------------------------------------------------------------------------------------


def options(definition: Definition) -> None:
    control = control_format(definition, {})
    told = {name: control.options[name] for name in ("units", "points", "encoder_system", "cec")}
    assert told == {"units": "mm", "points": None, "encoder_system": "auto", "cec": "absent"}
    assert (control.options["cec_tables"], control.options["cec_sign"]) == ((), None)
    assert control.options["files"] is None
    for value in ("small", "patched"):
        assert control_format(definition, {"files": value}).options["files"] == value
    for name, value in (("units", "mm"), ("cec_sign", "error"), ("files", "small")):
        own = replace(X, options={name: value})
        assert "whole control" in refused(control.options_of, own), name
    own_options: Sequence[tuple[str, object]] = (
        ("points", 9),
        ("encoder_system", "1"),
        ("encoder_system", "2"),
        ("cec", "available"),
        ("cec_tables", (1, 2)),
    )
    for name, chosen_value in own_options:
        own = replace(X, options={name: chosen_value})
        assert control.options_of(own)[name] == chosen_value
    assert refused(control_format, definition, {"points": 7.5})
    for system in ("1", "2"):
        two = text_of(EEC, eec_lines("AX1", 1, 0, 100, [0, 0.5, 0], modulo=False))
        chosen = control_format(definition, {"encoder_system": system}).read(two, address="AX1")
        assert chosen.facts["AX1"].encoder_system == int(system)
    for sign, factor in (("error", -1), ("correction", 1)):
        state = read(definition, text_of(BASE), cec_sign=sign)
        assert shown(state, "AX2") == [0, factor * 0.005, factor * 0.001]
    unsigned = control_format(definition, {"cec_tables": [3, 4], "cec": "available"})
    assert "cec_sign" in refused(unsigned.write, [TWO], [X])


def limits(definition: Definition) -> None:
    control = control_format(definition, {})
    capacity = control.capacity(X)
    assert (capacity.min_points, capacity.max_points, capacity.most_points) == (2, None, 5000)
    assert points_needed(control, ONE) == 2
    given = text_of(EEC, "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=8\n")
    state = read(definition, given, X)
    for own, most in (({}, 8), ({"points": 20}, 20)):
        assert control_format(definition, {**OURS, **own}, state).capacity(X).max_points == most
    short = text_of(EEC, "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=4\n")
    assert "reserved so many points" in refused(read, definition, short, X)
    fewer = text_of(BASE, "$MN_MM_CEC_MAX_POINTS[3]=2\n")
    assert "reserved so many points" in refused(read, definition, fewer, X)


PROBES: dict[str, Check] = {f"{entry[0]} last": last(entry) for entry in LAST} | {
    f"{entry[0]} twice": twice(entry) for entry in TWICE
}
CHECKS: dict[str, Check] = {
    each.__name__: each
    for each in (
        fresh, acts, absent, added, names, inches, claims, limits, kinds, tables, ranges, options, patched, forms,
        gate,
    )
}  # fmt: skip


def checks_for(name: str) -> dict[str, Check]:
    """All checks, those first that look at the line of a mutant."""
    parts = re.split(r"[.:]", name)
    whole = merged_definition(FORMAT).data
    statement = parts[1] if parts[0] == "statements" else None
    if parts[0] == "bindings":
        statement = whole["bindings"][parts[1]]["statement"]
    head = "-" if statement is None else whole["statements"][statement]["form"].partition("{")[0]
    mine = {key: check for key, check in PROBES.items() if key.startswith(head)}
    return mine | CHECKS | PROBES


#: Facts that decide nothing here -> why. Whatever else survives is a hole in the checks, or a dead
#: key of the definition.
DECIDES_NOTHING = {
    r"bindings\.\w+\.when_absent": "zeros for what has no value when it is absent: what is missing is"
    " told, asked for or refused by the reading; the values that there are: below",
    r"bindings\.(machine|channel|channel_machine)_axis\.(field|repeated)": "every name counts,"
    " wherever it stands",
    r"bindings\.(modulo_start|modulo_range|limit_\w+|gantry_type|encoders|inch_length|unit_mask"
    r"|temperature_\w+|dynamic_backlash|cross_other)\.repeated": "single data of an axis: the last"
    " line counts",
    r"bindings\.(length_unit|unit_word)\.repeated": "each place is held against all others",
    r"bindings\.(value|cross_value)\.repeated": "points are read by number, and held against each"
    " other",
    r"bindings\.cross_other\.field": "that there is such a line decides",
    r"bindings\.\w+\.writes": "written as the table asks, or never",
    r"bindings\.(table|cross)_spacing\.range: bound 0 -> -5": "a step is more than 0 anyway",
    r"bindings\.(table|cross)_end\.digits: 6 -> 7": "its start and step say it",
    r"bindings\.(table|cross)_start\.range: bound 100000 -> 200000": "its end lies beyond too",
    r"bindings\.(table|cross)_end\.range: bound -100000 -> -200000": "its start lies beyond too",
    r"statements\.cec_(type|input_ncu|output_ncu)\.fields": "a key that is not known leaves the"
    " table alone too",
    r"statements\.encoders\.fields": "two systems, or nobody says how many: asked alike",
    r"texts\.control\.blank_lines": "lines that say nothing are passed over, empty ones too",
    r"writing\[0\]\.set: one_curve -> complete": "a pair takes no file with rows of one table",
    r"diameter\.tables": "decides a question of the job",
}
#: One mutant in eighteen, in so many shares; all of them: benchmarks/bench_facts.py.
EVERY, SHARES = 18, 3
FORMAT = "siemens-840d-sl"


@cache
def turned_facts() -> tuple[tuple[str, DefinitionText], ...]:
    return tuple(mutants(FORMAT))


def silent_facts(first: int, every: int) -> list[str]:
    """The facts, from the ``first`` on each of so many, that no check notices when they are
    turned.
    """
    return [
        name
        for name, text in turned_facts()[first::every]
        if not any(re.match(each, name) for each in DECIDES_NOTHING)
        and not falls(text, checks_for(name))
    ]


@pytest.mark.parametrize("check", CHECKS | PROBES)
def test_the_definition_as_it_is_keeps_every_check(check: str) -> None:
    assert falls(merged_definition(FORMAT), {check: (CHECKS | PROBES)[check]}) == ""


@pytest.mark.parametrize("share", range(SHARES))
def test_a_fact_removed_or_turned_makes_a_check_fall(share: int) -> None:
    assert silent_facts(share * EVERY, SHARES * EVERY) == []


def test_what_decides_nothing_is_a_fact_that_is_there() -> None:
    names = [name for name, _ in turned_facts()]
    assert len(names) > 700
    for pattern in DECIDES_NOTHING:
        assert any(re.match(pattern, name) for name in names), pattern


@pytest.mark.parametrize(
    ("quantity", "value"),
    [
        ("repeats", "yes"),
        ("enabled", "no"),
        ("backlash", "0.001"),
        ("rotary", "rotary"),
        ("cross_repeats", "yes"),
    ],
)
def test_what_counts_where_no_file_says_it_decides_something(quantity: str, value: str) -> None:
    definition = DEFINITIONS[FORMAT]
    binding = definition.bindings[quantity]
    assert binding.when_absent is not None
    turned = replace(binding, when_absent=replace(binding.when_absent, value=value))
    bindings = {**definition.bindings, quantity: turned}
    absent(definition)
    with pytest.raises((AssertionError, CompwrightError, KeyError)):
        absent(replace(definition, bindings=bindings))
