"""SINUMERIK: the control's own CEC table of a pair of axes, free tables, and the limit of their sum
(MD32720).

The control adds all active tables of an output axis (802D sl Function Manual 11/2012, page 215), so
a free table next to the own one is as good as a change of the own one, where the sum is right.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from compwright.formats.families.pairs.axis_pairs import write_cross
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError
from compwright.records.axis import AxisKind
from compwright.records.correction import ControlFile, CrossCompensation
from format_samples import SIEMENS, axis_of, files

ON = "$MA_CEC_ENABLE[AX2]=1\n$SN_CEC_TABLE_ENABLE[0]=1\n$SN_CEC_TABLE_WEIGHT[0]=1\n"
#: Table 0 adds 15 µm/m of AX1 to AX2, 12 µm at 800 mm.
OWN = (
    "".join(f"$AN_CEC[0,{point}]={0.0015 * point:.4f}\n" for point in range(9))
    + "$AN_CEC_INPUT_AXIS[0]=(AX1)\n$AN_CEC_OUTPUT_AXIS[0]=(AX2)\n$AN_CEC_STEP[0]=100\n"
    "$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=800\n$AN_CEC_DIRECTION[0]=0\n"
    "$AN_CEC_MULT_BY_TABLE[0]=0\n$AN_CEC_IS_MODULO[0]=0\n"
)
FACTS = "$MN_MM_CEC_MAX_POINTS[0]=9\n$MA_BACKLASH[0,AX1]=0\n$MA_BACKLASH[0,AX2]=0\n"


#: Table 1, of AX3, is multiplied by table 0; it is off.
OTHER = OWN.replace("[0]", "[1]").replace("[0,", "[1,").replace("(AX1)", "(AX3)")
PRODUCT = OTHER.replace("BY_TABLE[1]=0", "BY_TABLE[1]=1") + "$SN_CEC_TABLE_ENABLE[1]=0\n"


def ramp(last: float, base: str = "AX1") -> CrossCompensation:
    """A straight line from 0 to ``last`` (mm) at 800 mm of the axis ``base``."""
    values = np.array([0.0, last])
    return CrossCompensation(
        input=base,
        output="AX2",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=np.array([0.0, 800.0]),
        positive=values,
        negative=values,
    )


def written(
    given: Sequence[ControlFile], tables: Sequence[int], *entries: CrossCompensation
) -> tuple[ControlFile, ...]:
    options = {"cec": "available", "cec_tables": list(tables), "cec_sign": "correction"}
    control = control_format(SIEMENS, options)
    return write_cross(control.in_state(control.read(given)), entries, given)


@pytest.mark.parametrize("last", [0.008, -0.008])
def test_a_free_table_holds_what_a_protected_own_table_does_not(last: float) -> None:
    """SD41300 and MD32710 are on in lines before the values, so the control would take no new value
    of table 0 from this file: table 1 holds the correction, and the sum is the old one and the new.
    """
    given = files(ALL__INI=f"{ON}{FACTS}{OWN}M17\n")
    (new,) = written(given, [0, 1], ramp(last))
    assert new.name == "AX2_CROSS.INI"
    assert b"[0" not in new.content
    state = control_format(SIEMENS, {"cec_sign": "correction"}).read([*given, new])
    (total,) = state.cross
    assert total.positive == pytest.approx(
        [(0.012 + last) * x / 800 for x in total.positions], abs=1e-9
    )


def test_a_protected_own_table_without_a_free_one_is_refused_with_both_ways_out() -> None:
    with pytest.raises(CapacityError) as caught:
        written(files(ALL__INI=f"{ON}{FACTS}{OWN}M17\n"), [0], ramp(0.008))
    for words in ("SD41300", "MD32710", "NC_CEC.INI", "unused table", "`cec_tables`"):
        assert words in str(caught.value)


@pytest.mark.parametrize("tables", [[0], [1]])
@pytest.mark.parametrize(("last", "reach"), [(-0.008, ""), (0.008, "0.02"), (-0.028, "0.016")])
def test_the_limit_of_the_sum_counts_what_is_active_after_loading(
    tables: Sequence[int], last: float, reach: str
) -> None:
    """12 µm are active; MD32720 is 15 µm. 12 - 8 µm are within it, 12 + 8 and 12 - 28 µm not."""
    given = files(MD__INI=f"{ON}{FACTS}$MA_CEC_MAX_SUM[AX2]=0.015\nM17\n", CEC__INI=f"{OWN}M17\n")
    if not reach:
        assert written(given, tables, ramp(last))
        return
    with pytest.raises(CapacityError, match=r"CEC_MAX_SUM \(MD32720\)") as caught:
        written(given, tables, ramp(last))
    (fault,) = caught.value.faults
    assert fault.found == f"up to {reach}"


def test_two_corrections_of_one_run_are_one_sum() -> None:
    """8 µm over AX1 and 8 µm over AX3, each within the limit of 15 µm, are 16 µm at the corner."""
    given = files(MD__INI=f"$MA_CEC_ENABLE[AX2]=1\n{FACTS}$MA_CEC_MAX_SUM[AX2]=0.015\nM17\n")
    with pytest.raises(CapacityError, match=r"over AX1 and AX3.*MD32720"):
        written(given, [1, 2], ramp(0.008), ramp(0.008, "AX3"))
    assert written(given, [1, 2], ramp(0.008), ramp(0.006, "AX3"))


def test_an_own_table_that_cannot_be_read_is_named_with_its_reason() -> None:
    far = OWN.replace("MAX[0]=800", "MAX[0]=800000000000000").replace(
        "STEP[0]=100", "STEP[0]=100000000000000"
    )
    with pytest.raises(CapacityError) as caught:
        written(files(MD__INI=f"{ON}{FACTS}M17\n", CEC__INI=f"{far}M17\n"), [0], ramp(0.008))
    assert "no further correction: a position this large is not plausible" in str(caught.value)
    assert "MD18342" not in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "reason", "step"),
    [
        ("$SN_CEC_TABLE_WEIGHT[0]=1\n", "", ("SD41310 ($SN_CEC_TABLE_WEIGHT[0]) is in no given file,"
         " needed: 1"), "add the file with $SN_CEC_TABLE_WEIGHT[0]"),
        ("WEIGHT[0]=1", "WEIGHT[0]=0.5", "SD41310 ($SN_CEC_TABLE_WEIGHT[0]) is 0.5, needed: 1",
         "set $SN_CEC_TABLE_WEIGHT[0] to 1 in the control, multiply the values of table 0 by 0.5"),
        ("$SN_CEC_TABLE_ENABLE[0]=1\n", "", ("SD41300 ($SN_CEC_TABLE_ENABLE[0]) is in no given file,"
         " needed: 1"), "add the file with $SN_CEC_TABLE_ENABLE[0]"),
        ("CEC_ENABLE[AX2]=1", "CEC_ENABLE[AX2]=0", "MD32710 ($MA_CEC_ENABLE[AX2]) is 0, needed: 1",
         "set $MA_CEC_ENABLE[AX2] to 1 in the control, measure again"),
        ("DIRECTION[0]=0", "DIRECTION[0]=1", "$AN_CEC_DIRECTION[0] is 1, needed: 0",
         "look in the control for an unused table"),
        ("IS_MODULO[0]=0\n", "IS_MODULO[0]=0\n" + PRODUCT,
         "$AN_CEC_MULT_BY_TABLE[1] is 1: table 1 is multiplied by it",
         "look in the control for an unused table"),
        ("AX2]=0\n", "AX2]=0\n$AN_CEC_TYPE[0]=1\n", "$AN_CEC_TYPE makes it a special table",
         "correct this table in the control"),
    ],
)  # fmt: skip
def test_only_the_condition_that_is_not_met_is_named_with_its_next_step(
    old: str, new: str, reason: str, step: str
) -> None:
    """Each has one sentence: the parameter, its value, the value that is needed."""
    text = f"{ON}{FACTS}{OWN}M17\n"
    assert old in text
    md, cec = (part.replace(old, new) for part in (f"{ON}{FACTS}M17\n", f"{OWN}M17\n"))
    with pytest.raises(CapacityError) as caught:
        written(files(MD__INI=md, CEC__INI=cec), [0], ramp(0.008))
    (fault,) = caught.value.faults
    assert fault.message.endswith(f"table 0 of these axes takes no further correction: {reason}")
    assert fault.hint.startswith(step)
    assert "give its index as `cec_tables`" in fault.hint


@pytest.mark.parametrize(
    ("room", "reason", "step"),
    [
        ("$MN_MM_CEC_MAX_POINTS[0]=7\n", "MD18342 ($MN_MM_CEC_MAX_POINTS[0]) is 7, needed: 9",
         "set MD18342 to 9 or more (save an archive, power on, load the archive back)"),
        ("", ("MD18342 ($MN_MM_CEC_MAX_POINTS[0]) is in no given file, and room is known for 7"
         " points only, needed: 9"), "add the file with MD18342"),
    ],
)  # fmt: skip
def test_the_points_that_a_table_needs_are_counted(room: str, reason: str, step: str) -> None:
    """0 to 600 every 100 mm must reach 800: 9 points."""
    rows = OWN.replace("MAX[0]=800", "MAX[0]=600").splitlines(keepends=True)
    cec = "".join(row for row in rows if not row.startswith(("$AN_CEC[0,7", "$AN_CEC[0,8")))
    md = ON + FACTS.replace("$MN_MM_CEC_MAX_POINTS[0]=9\n", room)
    with pytest.raises(CapacityError) as caught:
        written(files(MD__INI=f"{md}M17\n", CEC__INI=f"{cec}M17\n"), [0], ramp(0.008))
    (fault,) = caught.value.faults
    assert fault.message.endswith(f"takes no further correction: {reason}")
    assert fault.hint.startswith(step)


@pytest.mark.parametrize("tables", [[0], [1]])
@pytest.mark.parametrize(("line", "on"), [("", True), ("$MN_MM_CEC_MAX_POINTS[0]=0\n", False)])
def test_a_cross_axis_table_that_is_on_and_in_no_file_is_not_free(
    tables: Sequence[int], line: str, on: bool
) -> None:
    """Setting data say that table 0 is on, and only they were exported: it would be overwritten."""
    given = files(MD__INI=f"{ON}{FACTS}{line}M17\n")
    options = {"cec": "available", "cec_tables": tables, "cec_sign": "correction"}
    control, axes = control_format(SIEMENS, options), [axis_of("AX1"), axis_of("AX2")]
    if not on or tables != [0]:
        assert not control.read(given, axes).cross
        return
    with pytest.raises(InputError, match=r"CEC table 0: it is switched on.*NC_CEC\.INI"):
        control.read(given, axes)


def test_a_table_that_is_on_and_in_no_file_is_refused_by_its_parameters() -> None:
    """Squareness alone too: what the axis does now is unknown."""
    md = f"{ON}{FACTS}$MA_NUM_ENCS[AX1]=2\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n$MA_BACKLASH[1,AX1]=0\n"
    given = files(MD__INI=f"{md}$MA_ENC_COMP_ENABLE[1,AX1]=1\nM17\n", CEC__INI=f"{OWN}M17\n")
    with pytest.raises(InputError) as caught:
        control_format(SIEMENS, {"cec_sign": "error"}).read(given, [axis_of("AX1", system=2)])
    assert "$MA_ENC_COMP_ENABLE = 1" in str(caught.value)
    assert "no given file contains it ($AA_ENC_COMP)" in str(caught.value)


def test_an_axis_with_settings_but_no_compensation_is_refused_with_the_lines_wanted() -> None:
    """Table 0 works from AX3 to AX2; of AX1 the files have nothing but MD32710."""
    given = files(MD__INI=f"{ON}$MA_CEC_ENABLE[AX1]=1\nM17\n", CEC__INI=OWN.replace("AX1", "AX3"))
    with pytest.raises(InputError) as caught:
        control_format(SIEMENS, {"cec_sign": "error"}).read(given, [axis_of("AX1"), axis_of("AX2")])
    said = str(caught.value)
    for words in (
        "$MA_BACKLASH[<system>,AX1]",
        "$MA_ENC_COMP_ENABLE[",
        "AX1 (only $MA_CEC_ENABLE)",
    ):
        assert words in said
    assert "no axis at all" not in said
