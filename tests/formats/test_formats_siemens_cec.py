"""SINUMERIK: cross-axis tables (CEC), by hand-worked numbers: pairs of an axis over itself,
squareness, straightness.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from card_files import card_values
from compwright.controls.control import decode, open_control
from compwright.formats.card import card_steps
from compwright.formats.definition.schema import Definition
from compwright.formats.families.card_texts import UNKNOWN
from compwright.formats.families.pairs import axis_pairs as cross_writing
from compwright.formats.families.pairs.sums import cross_tables
from compwright.formats.families.pairs.tables import Cec
from compwright.formats.families.pairs.updated_tables import over_own_points
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, CompwrightError, InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from format_samples import LINUXCNC, SIEMENS, axis_of, codes, correction, files, siemens, table

POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE
EXACT = 1e-12  # mm; rounding of doubles


def cec(
    index: int,
    values: Sequence[float],
    grid: tuple[float, float, float],
    axes: tuple[str, str] = ("AX1", "AX1"),
    direction: int = 0,
    **more: int,
) -> str:
    """One table; ``grid``: MIN, STEP, MAX."""
    lines = [f"$AN_CEC[{index},{n}]={value:.7f}" for n, value in enumerate(values)]
    lines += [
        f"$AN_CEC_INPUT_AXIS[{index}]=({axes[0]})",
        f"$AN_CEC_OUTPUT_AXIS[{index}]=({axes[1]})",
    ]
    for key, number in zip(("MIN", "STEP", "MAX"), grid, strict=True):
        lines.append(f"$AN_CEC_{key}[{index}]={number}")
    said = {"DIRECTION": direction, "MULT_BY_TABLE": 0, "IS_MODULO": 0, **more}
    lines += [f"$AN_CEC_{key}[{index}]={value}" for key, value in said.items()]
    return "\n".join(lines) + "\n"


PAIR = cec(4, [0.0, 0.002, -0.0015], (0, 400, 800), direction=1) + cec(
    7, [-0.004, -0.001, -0.0065], (0, 400, 800), direction=-1
)
RAMP = cec(0, [0.0, -0.016], (0, 800, 800), ("AX1", "AX2"))
EEC = (
    "$AA_ENC_COMP[0,0,AX1]=0.003\n$AA_ENC_COMP[0,1,AX1]=0.001\n"
    "$AA_ENC_COMP_STEP[0,AX1]=800\n$AA_ENC_COMP_MIN[0,AX1]=0\n$AA_ENC_COMP_MAX[0,AX1]=800\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n"
)
MD = "$MA_BACKLASH[0,AX1]=0\n"
CEC: dict[str, object] = {"cec": "available", "cec_tables": [4, 7], "cec_sign": "correction"}
#: Two curves: what the pair of PAIR does.
TWO = table("AX1", [0.0, 400.0, 800.0], [0.0, 0.002, -0.0015], [-0.004, -0.001, -0.0065])
ONE = table("AX1", [0.0, 800.0], [0.0, 0.002], backlash=0.003)


def write_cross(
    definition: Definition,
    entries: Sequence[CrossCompensation],
    options: Mapping[str, object],
    state: ControlState | None = None,
    own: Sequence[ControlFile] = (),
) -> tuple[ControlFile, ...]:
    return cross_writing.write_cross(control_format(definition, options, state), entries, own)


def texts(written: Sequence[ControlFile]) -> dict[str, str]:
    return {file.name: file.content.decode() for file in written}


def agreed(
    written: Sequence[ControlFile], axes: Sequence[Axis] = (), **options: object
) -> ControlState:
    """What both readers say; raises where they do not agree."""
    return decode(
        open_control(Session(), "siemens-840d-sl", {"cec_sign": "correction"} | options),
        written,
        axes,
    ).state


# Reading
# --------------------------------------------------------------------------------------------------


def test_a_pair_is_two_curves_and_another_pair_of_axes_stands_beside() -> None:
    state = siemens(PAIR + RAMP + MD)
    assert list(state.axes) == ["AX1"]
    axis = state.axes["AX1"]
    assert axis.positions.tolist() == [0, 400, 800]
    assert axis.positive.tolist() == [0, 0.002, -0.0015]
    assert axis.negative.tolist() == [-0.004, -0.001, -0.0065]
    assert (axis.below, axis.above, axis.backlash, axis.others) == ("hold", "hold", 0.0, ())
    assert "CW-S008" not in codes(state)  # the axis has a table
    (cross,) = state.cross
    assert (cross.input, cross.output) == ("AX1", "AX2")
    # half of -0.016 at 400; both directions; the ends hold
    assert cross.at(np.array([-50, 400, 900]), POSITIVE) == pytest.approx(
        [0, -0.008, -0.016], abs=EXACT
    )
    assert cross.at(np.array([400.0]), NEGATIVE) == pytest.approx([-0.008], abs=EXACT)


def test_the_sign_is_an_option() -> None:
    state = siemens(PAIR + RAMP + EEC + MD, options={"cec_sign": "error"})
    assert correction(state, "AX1", 400, POSITIVE) == pytest.approx(
        -0.002 - 0.002, abs=EXACT
    )  # EEC keeps its own sign
    assert state.cross[0].positive.tolist() == [0, 0.016]


def test_a_lone_table_between_axes_says_that_its_sign_is_not_known() -> None:
    """No manual says the sign of CEC: a view of such a table, even of no other, has to tell."""
    state = decode(open_control(Session(), "siemens-840d-sl", {}), files(cec__ini=RAMP)).state
    assert state.axes == {}
    assert [entry.output for entry in state.cross] == ["AX2"]
    assert "CW-S055" in codes(state)
    told = decode(
        open_control(Session(), "siemens-840d-sl", {"cec_sign": "error"}), files(cec__ini=RAMP)
    ).state
    assert "CW-S055" not in codes(told)


def test_the_index_of_a_table_between_axes_is_not_free_for_a_pair() -> None:
    state = siemens(RAMP)
    assert state.tables.used == {0: ("AX1", "AX2")}
    one_too_few = control_format(SIEMENS, {**CEC, "cec_tables": [0, 4]}, state)
    with pytest.raises(CapacityError, match=r"2 CEC tables that are free.*table: \{mode: single\}"):
        one_too_few.capacity(axis_of("AX1"))
    enough = control_format(SIEMENS, {**CEC, "cec_tables": [0, 4, 5]}, state)
    assert enough.capacity(axis_of("AX1")).curves == 2


def test_leadscrew_table_pair_and_backlash_add_up() -> None:
    state = siemens(PAIR + EEC + "$MA_BACKLASH[0,AX1]=0.010\n", axis_of("AX1"))
    assert len(state.axes["AX1"].others) == 1
    assert correction(state, "AX1", 400, POSITIVE) == pytest.approx(-0.002 + 0.002, abs=EXACT)
    assert correction(state, "AX1", 400, NEGATIVE) == pytest.approx(
        -0.002 - 0.001 - 0.010, abs=EXACT
    )


def test_tables_of_one_pair_of_axes_add_up_whatever_their_grids() -> None:
    text = cec(1, [0.0, 0.010], (0, 100, 100)) + cec(
        2, [0.001, 0.003, 0.002], (-30, 60, 90), direction=-1
    )
    text += "$SN_CEC_TABLE_WEIGHT[1]=0.5\n"
    state = siemens(text + MD)
    # + : half of the first; - : second table too, at 0 it is 0.001 + 0.002 * 30 / 60, at 60 it is
    # 0.003 - 0.001 * 30 / 60
    assert correction(state, "AX1", 60, POSITIVE) == pytest.approx(0.003, abs=EXACT)
    assert correction(state, "AX1", 0, NEGATIVE) == pytest.approx(0.002, abs=EXACT)
    assert correction(state, "AX1", 60, NEGATIVE) == pytest.approx(0.003 + 0.0025, abs=EXACT)
    assert correction(state, "AX1", -500, NEGATIVE) == pytest.approx(0.001, abs=EXACT)


@pytest.mark.parametrize(
    ("what", "line", "pair_acts", "ramp_acts"),
    [
        ("one table off", "$SN_CEC_TABLE_ENABLE[0]=0", True, False),
        ("off, then on", "$SN_CEC_TABLE_ENABLE[0]=0\n$SN_CEC_TABLE_ENABLE[0]=1", True, True),
        ("on, then off", "$MA_CEC_ENABLE[AX2]=1\n$MA_CEC_ENABLE[AX2]=0", True, False),
        ("the input axis does not matter", "$MA_CEC_ENABLE[AX1]=0", False, True),
        ("on", "$MA_CEC_ENABLE[AX1]=1\n$SN_CEC_TABLE_ENABLE[4]=1", True, True),
    ],
)
def test_switches(what: str, line: str, pair_acts: bool, ramp_acts: bool) -> None:
    state = agreed(files(A__INI=f"{PAIR}{RAMP}{MD}{line}\n"))
    assert (state.axes["AX1"].positions.size > 0) is pair_acts
    assert bool(state.cross) is ramp_acts
    assert ("CW-S034" in codes(state)) is not (pair_acts and ramp_acts)


def test_what_the_files_do_not_say_is_listed() -> None:
    facts = [note.fact for note in siemens(PAIR + MD).assumed]
    assert any("$SN_CEC_TABLE_ENABLE" in fact for fact in facts)
    assert any("$MA_CEC_ENABLE" in fact for fact in facts)
    said = "$MA_CEC_ENABLE[AX1]=1\n$SN_CEC_TABLE_ENABLE[4]=1\n$SN_CEC_TABLE_ENABLE[7]=1\n"
    assert not any("CEC" in note.fact for note in siemens(PAIR + MD + said).assumed)


@pytest.mark.parametrize(
    ("what", "old", "new", "says"),
    [
        ("no direction", "$AN_CEC_DIRECTION[4]=1\n", "", "DIRECTION is missing"),
        ("no input", "$AN_CEC_INPUT_AXIS[4]=(AX1)\n", "", "INPUT_AXIS is missing"),
        ("no output", "$AN_CEC_OUTPUT_AXIS[4]=(AX1)\n", "", "OUTPUT_AXIS is missing"),
        ("no step", "$AN_CEC_STEP[4]=400\n", "", "STEP is missing"),
        ("no value", "$AN_CEC[4,1]=0.0020000\n", "", "values are missing"),
        (
            "another direction",
            "DIRECTION[4]=1",
            "DIRECTION[4]=2",
            "the direction of the table is unknown",
        ),
        ("a product", "MULT_BY_TABLE[4]=0", "MULT_BY_TABLE[4]=8", "multiplied by table 7"),
        ("repeats, unequal ends", "IS_MODULO[4]=0", "IS_MODULO[4]=1", "two ends differ"),
        ("a switch that is no switch", "IS_MODULO[4]=0", "IS_MODULO[4]=7", "not known"),
        ("a spacing that does not divide", "STEP[4]=400", "STEP[4]=390", "does not divide"),
        ("too large", "0.0020000", "20.002", "not plausible"),
        ("a decimal comma", "0.0020000", "0,002", "decimal comma"),
        ("a damaged name", "$AN_CEC_STEP[4]", "$AN_CEC_STEPS[4]", "cannot be read"),
    ],
)
def test_contradictory_tables_are_refused(what: str, old: str, new: str, says: str) -> None:
    assert old in PAIR
    with pytest.raises(InputError, match=says) as caught:
        siemens(PAIR.replace(old, new, 1) + MD)
    assert "A.INI" in str(caught.value)


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("$AN_CEC_INPUT_AXIS[4]=(AX3)", "contradicts"),
        ("$MN_MM_CEC_MAX_POINTS[4]=2", "not reserved"),
        ("$MA_CEC_MAX_SUM[AX1]=0.006", "CEC_MAX_SUM"),
    ],
)
def test_what_speaks_against_a_table(line: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        siemens(f"{PAIR}{MD}{line}\n")
    fitting = siemens(
        f"{PAIR}{MD}$MN_MM_CEC_MAX_POINTS[4]=3\n$MA_CEC_MAX_SUM[AX1]=0.0065\n$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=1\n"
    )
    assert fitting.axes["AX1"].positions.size == 3


def test_a_product_on_another_axis_is_left_out_where_nobody_asks_for_it() -> None:
    text = RAMP.replace("MULT_BY_TABLE[0]=0", "MULT_BY_TABLE[0]=5") + PAIR + MD
    state = siemens(text, axis_of("AX1"))
    assert state.cross == ()
    assert "CW-S011" in codes(state)
    with pytest.raises(InputError, match="multiplied"):
        siemens(text)
    with pytest.raises(
        CapacityError, match=r"none in `cec_tables` \(0\)"
    ):  # it is not free all the same
        control_format(
            SIEMENS, {"cec": "available", "cec_tables": [0], "cec_sign": "correction"}, state
        ).capacity(axis_of("AX1"))


def test_a_product_counts_only_where_it_acts_and_for_whom_it_acts() -> None:
    text = (
        RAMP.replace("MULT_BY_TABLE[0]=0", "MULT_BY_TABLE[0]=5")
        + PAIR
        + MD
        + "$MA_BACKLASH[0,AX2]=0\n"
    )
    with pytest.raises(InputError, match="multiplied"):
        siemens(text)  # a view of everything
    with pytest.raises(InputError, match="multiplied"):
        siemens(text, axis_of("AX2"), options={"cec_tables": [0]})
    left = siemens(text, axis_of("AX2"))  # it stays: alike in the readings and afterwards
    assert "CW-S011" in codes(left)
    assert left.cross == ()
    assert "CEC table 0" in left.facts["AX2"].other_functions
    assert siemens(text + "$SN_CEC_TABLE_ENABLE[0]=0\n").cross == ()


def test_backlash_acts_beside_a_pair() -> None:
    state = agreed(files(A__INI=PAIR + "$MA_BACKLASH[0,AX1]=0.010\n"))
    assert correction(state, "AX1", 400, NEGATIVE) == pytest.approx(-0.001 - 0.010, abs=EXACT)


def test_memory_that_nobody_wrote_is_no_table() -> None:
    blank = cec(9, [0.0, 0.0], (0, 0, 0), ("AX3", "AX3"))
    state = siemens(blank + PAIR + MD)
    assert list(state.axes) == ["AX1"]
    assert 9 not in state.tables.used


def test_a_file_of_cross_tables_alone_is_read() -> None:
    state = agreed(files(A__INI=RAMP))
    assert (dict(state.axes), len(state.cross)) == ({}, 1)


def test_both_spellings_of_an_axis_and_lines_that_are_not_used() -> None:
    text = (PAIR + RAMP).replace("(AX1)", "( ax1 )") + MD
    extra = "$AN_CEC_INPUT_NCU[4]=0\n$AN_CEC_OUTPUT_NCU[4]=0\n$AN_CEC_TYPE[4]=0\n"
    assert siemens(text + extra).axes["AX1"].positive.tolist() == [0, 0.002, -0.0015]
    bare = siemens(PAIR.replace("(AX1)", "AX1") + MD)
    assert bare.axes["AX1"].negative.tolist() == [-0.004, -0.001, -0.0065]
    assert "CW-S013" in codes(bare)


# Capacity
# --------------------------------------------------------------------------------------------------


def test_the_capacity_of_a_pair() -> None:
    capacity = control_format(SIEMENS, CEC).capacity(axis_of("AX1"))
    assert (capacity.curves, capacity.backlash_quantum, capacity.quantum) == (2, None, 1e-6)
    assert (capacity.max_points, capacity.value_range) == (None, (-10.0, 10.0))
    assert any("its CEC tables (MD18342)" in note.fact for note in capacity.assumed)
    reserved = (
        "$MN_MM_CEC_MAX_POINTS[4]=40\n$MN_MM_CEC_MAX_POINTS[7]=30\n$MN_MM_CEC_MAX_POINTS[2]=5\n"
    )
    state = siemens(
        f"{MD}{reserved}$MA_CEC_MAX_SUM[AX1]=0.05\n"
        + cec(2, [0.0, -0.02], (0, 10, 10), ("AX3", "AX1"))
    )
    capacity = control_format(SIEMENS, CEC, state).capacity(axis_of("AX1"))
    assert capacity.max_points == 30
    assert capacity.value_range == pytest.approx(
        (-0.03, 0.03)
    )  # 0.05 less what another axis' table takes
    assert (
        control_format(SIEMENS, {**CEC, "points": 200}, state).capacity(axis_of("AX1")).max_points
        == 200
    )
    assert control_format(SIEMENS, {}, state).capacity(axis_of("AX1")).curves == 1


@pytest.mark.parametrize(
    ("indices", "found"),
    [
        ([], "none"),
        ([4], "1 in `cec_tables` (4)"),
        ([4, 0], "1 in `cec_tables` (4, 0)"),
        ([0, 1], "none in `cec_tables` ("),
        ([4, 4], "1 in `cec_tables` ("),
    ],
)
def test_too_few_tables_are_told_with_how_many_are_needed(indices: list[int], found: str) -> None:
    taken = RAMP + cec(1, [0.0, 0.1], (0, 1, 1), ("AX3", "AX3"))
    state = siemens(taken + MD, axis_of("AX1"))
    options = {"cec": "available", "cec_tables": indices, "cec_sign": "correction"}
    with pytest.raises(CapacityError, match="2 CEC tables") as caught:
        control_format(SIEMENS, options, state).capacity(axis_of("AX1"))
    assert "cec_tables" in str(caught.value)
    assert found in str(caught.value)
    with pytest.raises(CapacityError, match="2 CEC tables"):
        control_format(SIEMENS, options, state).write(
            [TWO], [axis_of("AX1")], files(A__INI=taken + MD)
        )


def test_options_of_an_axis_go_over_those_of_the_control() -> None:
    axis = replace(axis_of("AX1"), options={"cec_tables": "4,7"})
    assert (
        control_format(SIEMENS, {"cec": "available", "cec_tables": [0], "cec_sign": "correction"})
        .capacity(axis)
        .curves
        == 2
    )
    assert (
        control_format(SIEMENS, CEC).capacity(replace(axis, options={"cec": "absent"})).curves == 1
    )


# Writing
# --------------------------------------------------------------------------------------------------

WRITTEN = """%_N_NC_CEC_INI
CHANDATA(1)
$AN_CEC[4,0]=0.000000
$AN_CEC[4,1]=0.002000
$AN_CEC[4,2]=-0.001500
$AN_CEC_INPUT_AXIS[4]=(AX1)
$AN_CEC_OUTPUT_AXIS[4]=(AX1)
$AN_CEC_MIN[4]=0.000000
$AN_CEC_MAX[4]=800.000000
$AN_CEC_STEP[4]=400.000000
$AN_CEC_DIRECTION[4]=1
$AN_CEC_MULT_BY_TABLE[4]=0
$AN_CEC_IS_MODULO[4]=0
$AN_CEC[7,0]=-0.004000
$AN_CEC[7,1]=-0.001000
$AN_CEC[7,2]=-0.006500
$AN_CEC_INPUT_AXIS[7]=(AX1)
$AN_CEC_OUTPUT_AXIS[7]=(AX1)
$AN_CEC_MIN[7]=0.000000
$AN_CEC_MAX[7]=800.000000
$AN_CEC_STEP[7]=400.000000
$AN_CEC_DIRECTION[7]=-1
$AN_CEC_MULT_BY_TABLE[7]=0
$AN_CEC_IS_MODULO[7]=0
M17
"""


def on(*tables: int) -> str:
    return "; by hand: $MA_CEC_ENABLE[AX1]=1\n" + "".join(
        f"$SN_CEC_TABLE_ENABLE[{index}]=1\n" for index in tables
    )


def test_two_curves_go_into_a_pair_and_nothing_else_acts() -> None:
    written = texts(control_format(SIEMENS, CEC).write([TWO], [axis_of("AX1", system=2)]))
    assert list(written) == ["AX1_CEC.INI", "AX1_MD.INI"]
    assert written["AX1_CEC.INI"] == WRITTEN
    assert (
        written["AX1_MD.INI"]
        == f"CHANDATA(1)\n$MA_BACKLASH[1,AX1]=0.000000\n$MA_ENC_COMP_ENABLE[1,AX1]=0\n{on(4, 7)}M17\n"
    )
    turned = texts(
        control_format(SIEMENS, {**CEC, "cec_sign": "error"}).write([TWO], [axis_of("AX1")])
    )
    assert "$AN_CEC[7,2]=0.006500\n" in turned["AX1_CEC.INI"]


def test_one_curve_and_backlash_stay_in_the_leadscrew_table() -> None:
    one = table("AX1", [0.0, 800.0], [0.0, 0.002], backlash=0.003)
    assert list(texts(control_format(SIEMENS, CEC).write([one], [axis_of("AX1")]))) == [
        "AX1_EEC.INI",
        "AX1_MD.INI",
    ]
    with pytest.raises(CapacityError, match="one table"):
        control_format(SIEMENS, {}).write([TWO], [axis_of("AX1")])
    with pytest.raises(CapacityError, match="backlash"):
        control_format(SIEMENS, CEC).write([replace(TWO, backlash=0.001)], [axis_of("AX1")])


def test_what_is_written_comes_back_through_both_readers() -> None:
    axis = axis_of("AX1", returns=NEGATIVE)
    written = control_format(SIEMENS, {**CEC, "cec_sign": "error"}).write([TWO], [axis])
    back = agreed(written, [axis], **{**CEC, "cec_sign": "error"}).axes["AX1"]
    assert (back.positive.tolist(), back.negative.tolist()) == (
        TWO.positive.tolist(),
        TWO.negative.tolist(),
    )
    assert (back.backlash, back.others) == (0.0, ())


def patch(
    text: str,
    compensation: AxisCompensation,
    options: Mapping[str, object],
    axis: Axis | None = None,
) -> dict[str, str]:
    axis = axis or axis_of("AX1")
    given = files(A__INI=text)
    state = control_format(SIEMENS, options).read(given, [axis])
    written = control_format(SIEMENS, options, state).write([compensation], [axis], given)
    agreed(written, [axis], **options)
    return texts(written)


def test_an_own_pair_is_patched_in_place_each_table_keeps_its_direction() -> None:
    swapped = PAIR.replace("DIRECTION[4]=1", "DIRECTION[4]=-1").replace(
        "DIRECTION[7]=-1", "DIRECTION[7]=1"
    )
    text = RAMP + swapped.replace("(AX1)", "(ax1)") + MD + "$MA_ENC_COMP_ENABLE[0,AX1]=0\nM17\n"
    new = table("AX1", [0.0, 400.0, 800.0], [0.001, 0.002, 0.003], [-0.001, -0.002, -0.003])
    patched = patch(text, new, CEC)["A.INI"]
    old_lines, new_lines = text.splitlines(), patched.splitlines()[: len(text.splitlines())]
    assert {a: b for a, b in zip(old_lines, new_lines, strict=True) if a != b} == {
        "$AN_CEC[4,0]=0.0000000": "$AN_CEC[4,0]=-0.0010000",
        "$AN_CEC[4,1]=0.0020000": "$AN_CEC[4,1]=-0.0020000",
        "$AN_CEC[4,2]=-0.0015000": "$AN_CEC[4,2]=-0.0030000",
        "$AN_CEC[7,0]=-0.0040000": "$AN_CEC[7,0]=0.0010000",
        "$AN_CEC[7,1]=-0.0010000": "$AN_CEC[7,1]=0.0020000",
        "$AN_CEC[7,2]=-0.0065000": "$AN_CEC[7,2]=0.0030000",
    }


def test_free_tables_are_taken_in_their_order_and_others_never() -> None:
    written = patch(
        RAMP + MD + "M17\n",
        TWO,
        {"cec": "available", "cec_tables": [0, 9, 3, 5], "cec_sign": "correction"},
    )
    assert set(written) == {"A.INI", "AX1_MD.INI", "AX1_CEC.INI"}
    assert written["A.INI"] == RAMP + MD + "M17\n"
    assert written["AX1_MD.INI"] == f"CHANDATA(1)\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n{on(9, 3)}M17\n"
    assert written["AX1_CEC.INI"] == WRITTEN.replace("[4", "[9").replace("[7", "[3")


def test_reserved_memory_is_filled_in_place() -> None:
    blank = (
        cec(4, [0.0, 0.0], (0, 0, 0), ("AX2", "AX2"))
        + "$SN_CEC_TABLE_ENABLE[4]=0\n$SN_CEC_TABLE_WEIGHT[4]=0.5\n"
    )
    written = patch(
        blank + MD + "$MA_CEC_ENABLE[AX1]=0\n$MA_ENC_COMP_ENABLE[0,AX1]=0\nM17\n", TWO, CEC
    )
    assert set(written) == {"A.INI", "AX1_CEC.INI", "AX1_MD.INI"}
    assert written["AX1_MD.INI"] == "CHANDATA(1)\n$SN_CEC_TABLE_ENABLE[7]=1\nM17\n"
    for line in (
        "$AN_CEC[4,2]=-0.0015000",
        "$AN_CEC_INPUT_AXIS[4]=(AX1)",
        "$AN_CEC_MAX[4]=800",
        "$SN_CEC_TABLE_ENABLE[4]=1",
        "$SN_CEC_TABLE_WEIGHT[4]=1.0",
        "$MA_CEC_ENABLE[AX1]=1",
    ):
        assert line in written["A.INI"].splitlines()
    assert "$AN_CEC[4," not in written["AX1_CEC.INI"]
    assert "$AN_CEC_DIRECTION[7]=-1" in written["AX1_CEC.INI"]


def test_the_points_of_a_pair_are_reserved_where_the_files_reserve_none_or_the_option_promises_them() -> (
    None
):
    reserved = (
        "$MN_MM_CEC_MAX_POINTS[4]=0\n$MN_MM_CEC_MAX_POINTS[7]=9\n$MN_MM_CEC_MAX_POINTS[8]=0\n"
    )
    written = patch(reserved + MD + "M17\n", TWO, CEC)["A.INI"]
    assert written.startswith(reserved.replace("[4]=0", "[4]=3"))
    few = "$MN_MM_CEC_MAX_POINTS[4]=2\n$MN_MM_CEC_MAX_POINTS[7]=2\n"
    with pytest.raises(CapacityError, match="at most 2"):
        patch(few + MD + "M17\n", TWO, CEC)
    assert patch(few + MD + "M17\n", TWO, {**CEC, "points": 40})["A.INI"].startswith(
        few.replace("=2", "=40")
    )


def test_the_leadscrew_table_is_switched_off_where_a_pair_is_written() -> None:
    text = EEC + "$MA_BACKLASH[0,AX1]=0.012\n$MA_ENC_COMP_ENABLE[0,AX1]=1\nM17\n"
    written = patch(text, TWO, CEC)
    assert "$MA_BACKLASH[0,AX1]=0.000\n" in written["A.INI"]
    assert "$MA_ENC_COMP_ENABLE[0,AX1]=0\n" in written["A.INI"]
    assert written["A.INI"].startswith(EEC)
    silent = patch(EEC + "$MA_BACKLASH[0,AX1]=0.012\nM17\n", TWO, CEC)
    assert silent["AX1_MD.INI"] == f"CHANDATA(1)\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n{on(4, 7)}M17\n"


def test_an_old_pair_is_emptied_where_one_curve_is_written() -> None:
    written = patch(PAIR + RAMP + MD + "M17\n", ONE, CEC)
    lines = written["A.INI"].splitlines()
    for index in (4, 7):
        assert {line for line in lines if line.startswith(f"$AN_CEC[{index},")} == {
            f"$AN_CEC[{index},{n}]=0.0000000" for n in range(3)
        }
    assert "$AN_CEC[0,1]=-0.0160000" in lines  # another pair of axes
    assert "$MA_BACKLASH[0,AX1]=0.003" in lines
    assert "AX1_EEC.INI" in written


def test_an_own_table_that_nobody_gave_to_be_written_stays() -> None:
    """Of a pair the job names one: the other is somebody else's, and what is written acts beside
    it.
    """
    options = {"cec": "available", "cec_tables": [4, 1], "cec_sign": "correction"}
    given = files(A__INI=PAIR + MD + "M17\n")
    state = control_format(SIEMENS, options).read(given, [axis_of("AX1")])
    (stays,) = state.stays["AX1"]
    assert (stays.positive.tolist(), stays.negative.tolist()) == (
        [0, 0, 0],
        [-0.004, -0.001, -0.0065],
    )
    (other,) = state.axes["AX1"].others
    (beside,) = control_format(SIEMENS, options, state).capacity(axis_of("AX1")).stays
    assert other.negative.tolist() == beside.negative.tolist() == stays.negative.tolist()
    written = patch(PAIR + MD + "M17\n", ONE, options)
    assert "$AN_CEC[7,0]=-0.0040000" in written["A.INI"]
    assert "$AN_CEC[4,1]=0.0000000" in written["A.INI"]


def test_an_own_table_that_is_switched_off_stays_as_it_is() -> None:
    written = patch(
        PAIR + "$SN_CEC_TABLE_ENABLE[7]=0\n" + MD + "M17\n",
        ONE,
        {"cec": "available", "cec_tables": [4], "cec_sign": "correction"},
    )
    assert "$AN_CEC[7,0]=-0.0040000" in written["A.INI"]
    assert "$AN_CEC[4,1]=0.0000000" in written["A.INI"]


def test_a_table_for_both_directions_makes_room_for_one_that_has_its_direction() -> None:
    text = (
        PAIR.replace("DIRECTION[4]=1", "DIRECTION[4]=0").replace(
            "DIRECTION[7]=-1", "DIRECTION[7]=1"
        )
        + MD
        + "M17\n"
    )
    lines = patch(text, TWO, CEC)["A.INI"].splitlines()
    assert "$AN_CEC_DIRECTION[4]=-1" in lines
    assert "$AN_CEC_DIRECTION[7]=1" in lines
    assert "$AN_CEC[7,1]=0.0020000" in lines


def test_a_third_own_table_is_emptied_too() -> None:
    third = cec(2, [0.001, 0.001], (0, 1, 1))
    written = patch(
        PAIR + third + MD + "M17\n",
        TWO,
        {"cec": "available", "cec_tables": [7, 4, 2], "cec_sign": "correction"},
    )
    assert "$AN_CEC[2,0]=0.0000000" in written["A.INI"]
    assert "$AN_CEC[7,2]=-0.0065000" in written["A.INI"]


def test_two_axes_take_tables_apart_from_each_other() -> None:
    other = replace(TWO, address="AX2")
    axes = [axis_of("AX1"), replace(axis_of("AX2"), name="Y")]
    options = {"cec": "available", "cec_tables": [1, 2, 3, 4], "cec_sign": "correction"}
    written = texts(control_format(SIEMENS, options).write([TWO, other], axes))
    assert "$AN_CEC_OUTPUT_AXIS[2]=(AX1)" in written["AX1_CEC.INI"]
    assert "$AN_CEC_OUTPUT_AXIS[3]=(AX2)" in written["AX2_CEC.INI"]
    with pytest.raises(CapacityError, match=r"axis Y.*2 CEC tables"):
        control_format(
            SIEMENS, {"cec": "available", "cec_tables": [1, 2, 3], "cec_sign": "correction"}
        ).write([TWO, other], axes)


def test_a_sum_that_is_switched_off_is_not_switched_on_for_others_tables() -> None:
    sleeping = cec(1, [0.0, 0.1], (0, 1, 1), ("AX3", "AX1")) + "$MA_CEC_ENABLE[AX1]=0\n"
    with pytest.raises(CapacityError, match="also activates others: 1"):
        patch(sleeping + MD + "M17\n", TWO, CEC)


def test_the_card_names_the_tables_and_the_check_of_the_sign() -> None:
    axis = axis_of("AX1")
    state = control_format(SIEMENS, CEC).read(
        control_format(SIEMENS, CEC).write([TWO], [axis]), [axis]
    )
    steps = card_steps(
        SIEMENS,
        axis,
        card_values(control_format(SIEMENS, CEC), axis, TWO, state.facts["AX1"], TWO.positions),
    )
    text = "\n".join(step.text for step in steps)
    assert UNKNOWN not in text
    for words in (
        "table 4 for travel in +, table 7 for travel in -",
        "AX1_CEC.INI",
        "MD18342",
        "with cec_sign: error in -",
        "racks the bridge",
    ):
        assert words in text
    single = "\n".join(
        step.text
        for step in card_steps(
            SIEMENS,
            axis,
            card_values(control_format(SIEMENS, CEC), axis, ONE, AxisFacts(), ONE.positions),
        )
    )
    assert "AX1_EEC.INI" in single
    assert "MD18342 $MN" not in single


# Cross-axis tables
# --------------------------------------------------------------------------------------------------


def cross(
    positive: Sequence[float],
    negative: Sequence[float] | None = None,
    axes: tuple[str, str] = ("AX1", "AX2"),
) -> CrossCompensation:
    return CrossCompensation(
        input=axes[0],
        output=axes[1],
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=np.linspace(0, 800, len(positive)),
        positive=np.array(positive),
        negative=np.array(positive if negative is None else negative),
    )


def test_squareness_is_a_ramp_of_two_points() -> None:
    # beta = -20 um/m: AX2 has to move by -0.016 mm while AX1 goes 800 mm
    (file,) = write_cross(
        SIEMENS,
        [cross([0.0, -0.016])],
        {"cec": "available", "cec_tables": [0], "cec_sign": "correction"},
    )
    assert file.name == "AX2_CROSS.INI"
    body = [line for line in file.content.decode().splitlines() if line.startswith("$")]
    assert body == [
        "$AN_CEC[0,0]=0.000000",
        "$AN_CEC[0,1]=-0.016000",
        "$AN_CEC_INPUT_AXIS[0]=(AX1)",
        "$AN_CEC_OUTPUT_AXIS[0]=(AX2)",
        "$AN_CEC_MIN[0]=0.000000",
        "$AN_CEC_MAX[0]=800.000000",
        "$AN_CEC_STEP[0]=800.000000",
        "$AN_CEC_DIRECTION[0]=0",
        "$AN_CEC_MULT_BY_TABLE[0]=0",
        "$AN_CEC_IS_MODULO[0]=0",
    ]
    back = agreed([file]).cross[0]
    assert (back.positive.tolist(), back.negative.tolist()) == ([0, -0.016], [0, -0.016])


def test_straightness_by_direction_takes_a_pair_of_free_tables_and_adds_up() -> None:
    bow = cross([0.0, 0.003, 0.0], [0.001, 0.004, 0.001])
    given = files(A__INI=RAMP + PAIR + MD + "$MA_CEC_ENABLE[AX2]=1\nM17\n")
    state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
    options = {"cec": "available", "cec_tables": [0, 4, 5, 6], "cec_sign": "correction"}
    written = write_cross(SIEMENS, [bow], options, state, given)
    assert list(texts(written)) == ["AX2_CROSS.INI"]  # nothing of the own file changes
    assert "$AN_CEC_DIRECTION[6]=-1" in texts(written)["AX2_CROSS.INI"]
    (total,) = agreed([*given, *written]).cross
    assert total.at(np.array([400.0]), POSITIVE) == pytest.approx([-0.008 + 0.003], abs=EXACT)
    assert total.at(np.array([400.0]), NEGATIVE) == pytest.approx([-0.008 + 0.004], abs=EXACT)
    with pytest.raises(CapacityError, match=r"AX2 over AX1.*2 CEC tables"):
        write_cross(
            SIEMENS,
            [bow],
            {"cec": "available", "cec_tables": [0, 4, 5], "cec_sign": "correction"},
            state,
            given,
        )


def test_squareness_without_a_free_table_says_how_to_free_one() -> None:
    """Both indices that may be written hold the pair of AX1; else they belong to other axes."""
    ramp = cross([0.0, 0.016], [0.0, 0.016])
    other = PAIR
    for index in (4, 7):
        other = other.replace(f"OUTPUT_AXIS[{index}]=(AX1)", f"OUTPUT_AXIS[{index}]=(AX3)")
    for text, single in ((PAIR, True), (other, False)):
        given = files(A__INI=text + MD + "$MA_CEC_ENABLE[AX1]=1\nM17\n")
        state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
        with pytest.raises(CapacityError) as caught:
            write_cross(SIEMENS, [ramp], CEC, state, given)
        assert "look in the control for an unused table" in str(caught.value)
        assert ("set `table: {mode: single}`" in str(caught.value)) is single


def test_reserved_memory_takes_cross_tables_too() -> None:
    given = files(
        A__INI=cec(3, [0.0], (0, 0, 0), ("AX1", "AX1")) + MD + "$MA_CEC_ENABLE[AX2]=0\nM17\n"
    )
    state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
    (file,) = write_cross(
        SIEMENS,
        [cross([0.0, -0.016])],
        {"cec": "available", "cec_tables": [3], "cec_sign": "correction"},
        state,
        given,
    )
    assert "$AN_CEC[3,1]=-0.0160000" in file.content.decode()
    assert "$MA_CEC_ENABLE[AX2]=1" in file.content.decode()
    assert agreed([file]).cross[0].positive.tolist() == [0, -0.016]


def blank(index: int) -> str:
    """A table that was never used, as an archive holds it."""
    return cec(index, [0.0, 0.0], (0, 0, 0), ("", ""))


@pytest.mark.parametrize(
    "text",
    [
        blank(3),
        blank(3) + blank(3),
        "$AN_CEC_INPUT_AXIS[3]=()\n$AN_CEC_OUTPUT_AXIS[3]=()\n",
        blank(3).replace("OUTPUT_AXIS[3]=()", "OUTPUT_AXIS[3]=(AX2)"),
        blank(3).replace("AN_CEC_INPUT_AXIS[3]=()", "an_cec_input_axis[3]=() '1f2e"),
    ],
    ids=["blank", "twice", "nothing else", "half", "checksum"],
)
def test_the_empty_brackets_of_a_blank_table_take_the_axes(text: str) -> None:
    given = files(A__INI=text + MD + "$MA_CEC_ENABLE[AX2]=1\nM17\n")
    state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
    options = {"cec": "available", "cec_tables": [3], "cec_sign": "correction"}
    (file,) = write_cross(SIEMENS, [cross([0.0, -0.016])], options, state, given)
    assert file.name == "A.INI"
    lines = file.content.decode().upper().splitlines()
    for line in ("$AN_CEC_INPUT_AXIS[3]=(AX1)", "$AN_CEC_OUTPUT_AXIS[3]=(AX2)"):
        key = line.partition("=")[0]
        assert {each for each in lines if each.startswith(key)} == {line}
        assert sum(each.startswith(key) for each in lines) == text.upper().count(key)
    (entry,) = agreed([file]).cross
    assert (entry.input, entry.output) == ("AX1", "AX2")
    assert entry.positive.tolist() == [0, -0.016]


def test_the_empty_brackets_of_a_blank_table_take_an_axis_over_itself() -> None:
    written = patch(blank(4) + blank(7) + MD + "M17\n", TWO, CEC)["A.INI"]
    assert written.count("AXIS[4]=(AX1)\n") == written.count("AXIS[7]=(AX1)\n") == 2
    assert "()" not in written


@pytest.mark.parametrize(
    ("entry", "says"),
    [
        (
            replace(cross([0.0, 0.1]), below="zero", positive=np.array([0.1, 0.1])),
            "end value",
        ),
        (replace(cross([0.0, 0.1]), positive=np.array([0.0])), "two points"),
        (replace(cross([0.0, 0.1]), positive=np.array([0.0, np.nan])), "not finite"),
        (replace(cross([0.0, 0.1]), positions=np.array([5.0, 5.0])), "ascend"),
        (replace(cross([0.0, 0.1, 0.2]), positions=np.array([0.0, 1.0, 3.0])), "equally spaced"),
        (cross([0.0, 0.0000005]), "multiple"),
        (cross([0.0, 11.0]), "outside"),
        (replace(cross([0.0, 0.1]), period=800.0), "same value at both ends"),
        (replace(cross([0.0, 0.0]), period=700.0), "one period"),
    ],
)
def test_cross_tables_that_no_control_holds_are_refused(
    entry: CrossCompensation, says: str
) -> None:
    with pytest.raises(CapacityError, match=says):
        write_cross(
            SIEMENS,
            [entry],
            {"cec": "available", "cec_tables": [0, 1, 2], "cec_sign": "correction"},
        )


def test_cross_tables_need_the_option_free_memory_and_room() -> None:
    with pytest.raises(CapacityError, match="option cec"):
        write_cross(SIEMENS, [cross([0.0, 0.1])], {})
    with pytest.raises(UsageError, match="over its"):
        write_cross(
            SIEMENS,
            [cross([0.0, 0.1], axes=("AX1", "ax1"))],
            {"cec": "available", "cec_tables": [0], "cec_sign": "correction"},
        )
    given = files(
        A__INI=f"{RAMP}$MA_CEC_ENABLE[AX2]=1\n$MA_CEC_MAX_SUM[AX2]=0.02\n$MN_MM_CEC_MAX_POINTS[1]=2\n$MA_BACKLASH[0,AX2]=0\nM17\n"
    )
    state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
    options = {"cec": "available", "cec_tables": [1], "cec_sign": "correction"}
    assert write_cross(SIEMENS, [cross([0.0, -0.004])], options, state, given)
    with pytest.raises(CapacityError, match="MD32720"):
        write_cross(SIEMENS, [cross([0.0, -0.005])], options, state, given)
    with pytest.raises(CapacityError, match="MD18342"):
        write_cross(SIEMENS, [cross([0.0, 0.001, 0.002])], options, state, given)


def test_an_empty_table_of_another_ncu_is_not_free() -> None:
    options = {"cec": "available", "cec_tables": [1], "cec_sign": "correction"}
    empty = "".join(
        f"$AN_CEC{name}=0\n"
        for name in ("[1,0]", "[1,1]", "_STEP[1]", "_MIN[1]", "_MAX[1]", "_DIRECTION[1]")
    )
    empty += "$AN_CEC_INPUT_AXIS[1]=(AX1)\n$AN_CEC_OUTPUT_AXIS[1]=(AX2)\n"
    for unit in (1, 2):
        given = files(
            A__INI=f"{empty}$AN_CEC_OUTPUT_NCU[1]={unit}\n{RAMP}$MA_CEC_ENABLE[AX2]=1\n"
            "$MN_MM_CEC_MAX_POINTS[1]=2\n$MA_BACKLASH[0,AX2]=0\nM17\n"
        )
        state = control_format(SIEMENS, {"cec_sign": "correction"}).read(given)
        if unit == 1:
            assert write_cross(SIEMENS, [cross([0.0, 0.004])], options, state, given)
        else:
            with pytest.raises(CapacityError, match="cec_tables"):
                write_cross(SIEMENS, [cross([0.0, 0.004])], options, state, given)


#: A table of the machine's own, a bend of AX2 over AX1, and what switches it on.
BEND = cec(0, [0.004, 0.010, -0.002], (0, 400, 800), ("AX1", "AX2"))
SWITCHES = {
    "$SN_CEC_TABLE_ENABLE[0]": "1",
    "$SN_CEC_TABLE_WEIGHT[0]": "1",
    "$MA_CEC_ENABLE[AX2]": "1",
    "$MN_MM_CEC_MAX_POINTS[0]": "9",
}


def own_bend(bend: str = BEND, **changed: str) -> list[ControlFile]:
    """The machine's files; a value "" leaves a switch out."""
    switches = SWITCHES | {
        key.replace("__", "[").replace("_END", "]"): v for key, v in changed.items()
    }
    lines = "".join(f"{key}={value}\n" for key, value in switches.items() if value)
    return files(A__INI=f"{bend}{MD}$MA_BACKLASH[0,AX2]=0\n{lines}M17\n")


def in_place(
    given: Sequence[ControlFile], entry: CrossCompensation, tables: Sequence[int], sign: str
) -> tuple[ControlFile, ...]:
    options = {"cec": "available", "cec_tables": list(tables), "cec_sign": sign}
    state = control_format(SIEMENS, options).read(given)
    return write_cross(SIEMENS, [entry], options, state, given)


def by_hand(text: str, index: int, x: float) -> float:
    """The number that the control takes from a table at x: linear, the ends hold."""
    values = {int(n): float(v) for n, v in re.findall(rf"\$AN_CEC\[{index},(\d+)\]=(\S+)", text)}
    low, step, high = (
        float(re.findall(rf"\$AN_CEC_{key}\[{index}\]=(\S+)", text)[-1])
        for key in ("MIN", "STEP", "MAX")
    )
    place = (min(max(x, low), high) - low) / step
    first = min(int(place), round((high - low) / step) - 1)
    return values[first] + (values[first + 1] - values[first]) * (place - first)


@pytest.mark.parametrize(("sign", "file_sign"), [("correction", 1), ("error", -1)])
@pytest.mark.parametrize("tables", [[0], [0, 5], [5, 0]])
def test_the_own_table_of_a_pair_is_updated_in_place(
    sign: str, file_sign: int, tables: Sequence[int]
) -> None:
    """Its points stay; each holds its old value plus that of the ramp, no further table is used."""
    given = own_bend()
    (file,) = in_place(given, cross([0.0, -0.016]), tables, sign)
    assert file.name == "A.INI"
    text = file.content.decode()
    for place in np.linspace(-100, 900, 41):
        ramp = -0.016 * min(max(place, 0.0), 800.0) / 800
        was = by_hand(given[0].content.decode(), 0, place)
        assert by_hand(text, 0, place) == pytest.approx(was + file_sign * ramp, abs=1e-9)
    assert "$AN_CEC[5," not in text
    changed = set(text.splitlines()) ^ set(given[0].content.decode().splitlines())
    assert all(line.startswith("$AN_CEC[0,") for line in changed)


def test_a_table_beyond_the_travel_takes_a_ramp_between_its_points() -> None:
    """Points from -100 to 900 every 200 mm: the ramp ends at the nearest points outside the travel,
    0 to 800. Points from 100 to 700 every 200 mm: they get an interval of 100 mm from 0 to 800.
    """
    wide = cec(0, [0.004, 0.010, -0.002, 0, 0, 0.001], (-100, 200, 900), ("AX1", "AX2"))
    narrow = cec(0, [0.004, 0.010, -0.002, 0], (100, 200, 700), ("AX1", "AX2"))
    for bend, points in ((wide, 6), (narrow, 9)):
        given = own_bend(bend)
        options = {"cec": "available", "cec_tables": [0], "cec_sign": "correction"}
        control = control_format(SIEMENS, options)
        control = control.in_state(control.read(given))
        entry = over_own_points(control, cross([0.0, -0.016]))
        (file,) = write_cross(SIEMENS, [entry], options, control.state, given)
        text = file.content.decode()
        assert len(re.findall(r"\$AN_CEC\[0,", text)) == points
        for place in np.linspace(0, 800, 33):
            was = by_hand(given[0].content.decode(), 0, place)
            assert by_hand(text, 0, place) == pytest.approx(was - 2e-5 * place, abs=1e-9)


@pytest.mark.parametrize(
    ("bend", "switches"),
    [
        (BEND, {"$SN_CEC_TABLE_ENABLE__0_END": "0"}),
        (BEND, {"$SN_CEC_TABLE_ENABLE__0_END": ""}),
        (BEND, {"$SN_CEC_TABLE_WEIGHT__0_END": "2"}),
        (BEND, {"$SN_CEC_TABLE_WEIGHT__0_END": ""}),
        (BEND, {"$MA_CEC_ENABLE__AX2_END": "0"}),
        (BEND.replace("DIRECTION[0]=0", "DIRECTION[0]=1"), {}),
        (BEND.replace("MULT_BY_TABLE[0]=0", "MULT_BY_TABLE[0]=3"), {}),
        (BEND.replace("-0.002", "0.004").replace("IS_MODULO[0]=0", "IS_MODULO[0]=1"), {}),
        (BEND + "$AN_CEC_TYPE[0]=1\n", {}),
        (BEND + "$SN_CEC_0[0]=0.01\n", {}),
        (BEND + "$AN_CEC_OUTPUT_NCU[0]=2\n", {}),
        (BEND + cec(3, [0, 0.01], (0, 800, 800), ("AX1", "AX3"), MULT_BY_TABLE=1), {}),
        (BEND.replace("STEP[0]=400", "STEP[0]=300"), {}),
        (cec(0, [0.004, 0.010, -0.002], (7, 300, 607), ("AX1", "AX2")), {}),
    ],
)
def test_an_own_table_that_cannot_take_a_correction_exactly_stays(
    bend: str, switches: Mapping[str, str]
) -> None:
    given = own_bend(bend, **switches)
    with pytest.raises((CapacityError, InputError)) as caught:
        in_place(given, cross([0.0, -0.016]), [0], "correction")
    assert "table 0" in str(caught.value)


def test_an_own_table_that_may_not_be_written_is_named() -> None:
    with pytest.raises(CapacityError) as caught:
        in_place(own_bend(), cross([0.0, -0.016]), [], "correction")
    assert (
        "table 0 of these axes takes no further correction: `cec_tables` does not name it; exp"
        in (str(caught.value))
    )
    assert "Next: add 0 to `cec_tables`, so that it is changed in place; or" in str(caught.value)


def test_cross_tables_and_a_pair_of_one_run_do_not_meet() -> None:
    options = {"cec": "available", "cec_tables": [2, 3, 5], "cec_sign": "correction"}
    axis = axis_of("AX1")
    tables = control_format(SIEMENS, options).write([TWO], [axis])
    state = control_format(SIEMENS, options).read(tables, [axis])
    new = write_cross(SIEMENS, [cross([0.0, -0.016])], options, state, tables)
    assert "$AN_CEC_INPUT_AXIS[5]=(AX1)" in texts(new)["AX2_CROSS.INI"]
    both = agreed([*tables, *new], [axis], **options)
    assert both.axes["AX1"].positive.tolist() == TWO.positive.tolist()
    assert both.cross[0].positive.tolist() == [0, -0.016]


def test_a_definition_without_such_tables_holds_none() -> None:
    with pytest.raises(CapacityError, match="option"):
        write_cross(LINUXCNC, [cross([0.0, 0.1])], {})


# Both readers
# --------------------------------------------------------------------------------------------------


@st.composite
def sag(draw: st.DrawFn) -> str:
    text = MD + draw(
        st.sampled_from(["", EEC, "$MA_CEC_ENABLE[AX1]=0\n", "$MA_CEC_ENABLE[AX2]=1\n"])
    )
    for index in draw(st.lists(st.integers(0, 9), unique=True, max_size=4)):
        count = draw(st.integers(2, 5))
        values = draw(st.lists(st.integers(-9999, 9999), min_size=count, max_size=count))
        modulo = draw(st.booleans())
        if modulo:
            values[-1] = values[0]
        start, step = draw(st.integers(-500, 500)), draw(st.integers(1, 200))
        axes = draw(st.sampled_from([("AX1", "AX1"), ("AX1", "AX2"), ("AX2", "AX1")]))
        grid = (float(start), float(step), float(start + step * (count - 1)))
        text += cec(
            index,
            [v / 1e6 for v in values],
            grid,
            axes,
            draw(st.sampled_from([-1, 0, 1])),
            IS_MODULO=int(modulo),
        )
        text += draw(
            st.sampled_from(
                ["", f"$SN_CEC_TABLE_ENABLE[{index}]=0\n", f"$SN_CEC_TABLE_WEIGHT[{index}]=-0.5\n"]
            )
        )
    return text


@given(text=sag(), sign=st.sampled_from(["correction", "error"]))
@settings(deadline=None, max_examples=60)
def test_both_readers_agree_on_any_tables(text: str, sign: str) -> None:
    agreed(files(A__INI=text + "M17\n"), cec_sign=sign)


@given(data=st.data())
@settings(deadline=None, max_examples=100)
def test_damaged_tables_are_refused_or_agreed_on(data: st.DataObject) -> None:
    content = (PAIR + RAMP + MD + "M17\n").encode()
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.integers(0, len(content)))
        piece = data.draw(
            st.one_of(
                st.binary(max_size=4),
                st.sampled_from([b"\n", b"'", b"(", b"-1", b"$AN_CEC", b"9" * 16]),
            )
        )
        content = content[:place] + piece + content[place + data.draw(st.integers(0, 10)) :]
    try:
        state = control_format(SIEMENS, {"cec_sign": "correction"}).read(
            [ControlFile("A.INI", content)]
        )
    except (InputError, UsageError):
        return
    for axis in state.axes.values():
        assert np.all(np.diff(axis.positions) > 0)


def test_a_difference_between_the_readers_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    given = files(A__INI=RAMP + MD)
    agreed(given)

    def a_micrometre_off(
        cec: Cec, kind: Callable[[str], AxisKind]
    ) -> tuple[CrossCompensation, ...]:
        return tuple(replace(one, positive=one.positive + 1e-3) for one in cross_tables(cec, kind))

    def none(cec: Cec, kind: Callable[[str], AxisKind]) -> tuple[CrossCompensation, ...]:
        return cross_tables(cec, kind)[:0]

    def another(cec: Cec, kind: Callable[[str], AxisKind]) -> tuple[CrossCompensation, ...]:
        return tuple(replace(one, output="AX3") for one in cross_tables(cec, kind))

    for wrong, says in (
        (a_micrometre_off, "do not agree"),
        (none, "do not agree"),
        (another, "different cross-axis tables"),
    ):
        monkeypatch.setattr("compwright.formats.families.pairs.state.cross_tables", wrong)
        with pytest.raises(CompwrightError, match=says):
            agreed(given)
