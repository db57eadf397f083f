"""SINUMERIK: endless axes, gantries, and what the machine data say of an axis."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from card_files import card_values
from compwright.controls.control import decode, open_control
from compwright.formats.card import card_steps
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.facts import AxisFacts
from format_samples import LINUXCNC, SIEMENS, axis_of, codes, correction, files, siemens, table

POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE

#: A table of one turn: errors, deg.
TURN = """CHANDATA(1)
$AA_ENC_COMP[0,0,AX4]=0.001
$AA_ENC_COMP[0,1,AX4]=0.003
$AA_ENC_COMP[0,2,AX4]=-0.002
$AA_ENC_COMP[0,3,AX4]=0.001
$AA_ENC_COMP_STEP[0,AX4]=120
$AA_ENC_COMP_MIN[0,AX4]=0
$AA_ENC_COMP_MAX[0,AX4]=360
$AA_ENC_COMP_IS_MODULO[0,AX4]=1
$MA_BACKLASH[0,AX4]=0
M17
"""
ROUND = axis_of("AX4", kind=AxisKind.ROTARY, modulo=360.0)


def closed(
    values: list[float], negative: list[float] | None = None, *, start: float = 0.0
) -> AxisCompensation:
    positions = start + np.linspace(0.0, 360.0, len(values))
    made = table("AX4", list(positions), values, negative, kind=AxisKind.ROTARY)
    return replace(made, period=360.0)


# Endless axes
# --------------------------------------------------------------------------------------------------


def test_a_table_of_one_turn_repeats() -> None:
    state = siemens(TURN, ROUND)
    axis = state.axes["AX4"]
    assert axis.period == 360.0
    assert axis.positions.tolist() == [0, 120, 240, 360]
    for turn in (-720.0, 0.0, 360.0):
        # half way from -0.001 to -0.003, and from +0.002 to -0.001
        assert correction(state, "AX4", 60 + turn, POSITIVE) == pytest.approx(-0.002, abs=1e-12)
        assert correction(state, "AX4", 300 + turn, NEGATIVE) == pytest.approx(0.0005, abs=1e-12)
    assert control_format(SIEMENS, {}, state).capacity(ROUND).period == 360.0
    assert control_format(SIEMENS, {}).capacity(replace(ROUND, kind=AxisKind.LINEAR)).period is None
    assert (
        control_format(LINUXCNC, {})
        .capacity(axis_of("0", kind=AxisKind.ROTARY, modulo=360.0))
        .period
        is None
    )


def test_the_ends_of_a_turn_must_meet_and_its_length_be_the_modulo() -> None:
    with pytest.raises(InputError, match="two ends differ"):
        siemens(TURN.replace("3,AX4]=0.001", "3,AX4]=0.0011"))
    with pytest.raises(InputError, match="not the modulo"):
        siemens(TURN, replace(ROUND, modulo=180.0))
    with pytest.raises(InputError, match="endless"):
        siemens(TURN.replace("M17", "$MA_ROT_IS_MODULO[AX4]=0\nM17"), ROUND)
    assert (
        siemens(TURN.replace("M17", "$MA_ROT_IS_MODULO[AX4]=1\nM17"), ROUND).axes["AX4"].period
        == 360.0
    )


def test_a_job_and_a_table_that_differ_about_the_turn_are_told() -> None:
    assert "CW-S033" not in codes(siemens(TURN, ROUND))
    assert "CW-S033" in codes(siemens(TURN, replace(ROUND, modulo=None)))
    ends = siemens(TURN.replace("IS_MODULO[0,AX4]=1", "IS_MODULO[0,AX4]=0"), ROUND)
    assert ends.axes["AX4"].period is None
    assert "CW-S033" in codes(ends)


def test_an_archive_gives_endless_and_other_axes() -> None:
    linear = TURN.replace("AX4", "AX1").replace("IS_MODULO[0,AX1]=1", "IS_MODULO[0,AX1]=0")
    state = siemens(linear.replace("M17\n", "") + TURN)
    assert [axis.period for axis in state.axes.values()] == [None, 360.0]


def test_a_written_turn_comes_back_through_both_readers() -> None:
    new = closed([0.0, -0.0025, 0.001, 0.0004, 0.0])
    written = control_format(SIEMENS, {}).write([new], [ROUND])
    text = written[0].content.decode()
    for line in (
        "IS_MODULO[0,AX4]=1",
        "MIN[0,AX4]=0.000000",
        "MAX[0,AX4]=360.000000",
        "[0,4,AX4]=0.000000",
    ):
        assert f"{line}\n" in text
    back = decode(open_control(Session(), "siemens-840d-sl", {}), written, [ROUND]).state.axes[
        "AX4"
    ]
    where = np.array([-300.0, 45.0, 359.9, 700.0])
    np.testing.assert_allclose(
        back.at(where, POSITIVE), new.at(where, POSITIVE), rtol=0, atol=1e-12
    )


def test_a_turn_from_a_reference_is_told_from_the_beginning_of_the_range() -> None:
    """Whether a control finds its way into a table of 90 to 450 deg is not known: the same turn is
    written as 0 to 360.
    """
    axis = replace(ROUND, reference=90.0)
    new = closed([0.0, -0.0025, 0.001, 0.0004, 0.0], start=90.0)
    state = siemens(TURN.replace("M17", "$MA_ROT_IS_MODULO[AX4]=1\nM17"), axis)
    written = control_format(SIEMENS, {}, state).write([new], [axis])
    text = written[0].content.decode()
    for line in (
        "MIN[0,AX4]=0.000000",
        "MAX[0,AX4]=360.000000",
        "[0,0,AX4]=-0.000400",
        "[0,1,AX4]=0.000000",
        "[0,2,AX4]=0.002500",
    ):
        assert f"{line}\n" in text
    back = decode(open_control(Session(), "siemens-840d-sl", {}), written, [axis]).state.axes["AX4"]
    where = np.array([-300.0, 45.0, 90.0, 359.9, 700.0])
    np.testing.assert_allclose(
        back.at(where, POSITIVE), new.at(where, POSITIVE), rtol=0, atol=1e-12
    )  # deg
    with pytest.raises(CapacityError, match="MD30340"):  # no node at 0
        control_format(SIEMENS, {}, state).write([closed([0.0, -0.0025, 0.0], start=90.0)], [axis])


def test_a_turn_is_patched_into_the_own_file() -> None:
    given = files(C__INI=TURN)
    state = siemens(TURN, ROUND)
    (new,) = control_format(SIEMENS, {}, state).write(
        [closed([0.002, 0.001, 0.004, 0.002])], [ROUND], given
    )
    assert new.content.decode() == TURN.replace("0.001\n", "-0.002\n").replace(
        "=0.003", "=-0.001"
    ).replace("2,AX4]=-0.002", "2,AX4]=-0.004")
    ends = files(C__INI=TURN.replace("MODULO[0,AX4]=1", "MODULO[0,AX4]=0"))
    (new,) = control_format(SIEMENS, {}, state).write(
        [closed([0.002, 0.001, 0.004, 0.002])], [ROUND], ends
    )
    assert b"IS_MODULO[0,AX4]=1\n" in new.content


def test_a_pair_of_a_turn_repeats_too() -> None:
    options = {"cec": "available", "cec_tables": [0, 1], "cec_sign": "correction"}
    new = closed([0.0, 0.002, 0.0], [0.001, -0.002, 0.001])
    written = control_format(SIEMENS, options).write([new], [ROUND])
    assert written[0].content.decode().count("IS_MODULO[0]=1\n") == 1
    back = decode(open_control(Session(), "siemens-840d-sl", options), written, [ROUND]).state.axes[
        "AX4"
    ]
    where = np.array([-300.0, 45.0, 359.9, 700.0])
    for direction in Direction:
        np.testing.assert_allclose(
            back.at(where, direction), new.at(where, direction), rtol=0, atol=1e-12
        )
    assert control_format(SIEMENS, options).capacity(ROUND).period == 360.0


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (replace(closed([0.0, 0.1, 0.0]), period=None), "the axis is endless"),
        (replace(closed([0.0, 0.1, 0.0]), period=180.0), "the axis is endless"),
        (
            replace(closed([0.0, 0.1, 0.0]), positions=np.array([0.0, 90.0, 180.0])),
            "the axis is endless",
        ),
        (closed([0.0, 0.1, 0.2]), "same value at both ends"),
    ],
)
def test_a_table_that_is_no_turn_is_refused(wrong: AxisCompensation, says: str) -> None:
    with pytest.raises(CapacityError, match=says):
        control_format(SIEMENS, {}).write([wrong], [ROUND])


def test_a_table_that_repeats_on_an_axis_with_ends_is_refused() -> None:
    with pytest.raises(CapacityError, match="not endless"):
        control_format(SIEMENS, {}).write([closed([0.0, 0.1, 0.0])], [replace(ROUND, modulo=None)])


# Gantry
# --------------------------------------------------------------------------------------------------


def straight(address: str, last: float = 0.002) -> str:
    return (
        f"CHANDATA(1)\n$AA_ENC_COMP[0,0,{address}]=0.0\n$AA_ENC_COMP[0,1,{address}]={last}\n$AA_ENC_COMP_STEP[0,{address}]=400\n"
        f"$AA_ENC_COMP_MIN[0,{address}]=0\n$AA_ENC_COMP_MAX[0,{address}]=400\n$AA_ENC_COMP_IS_MODULO[0,{address}]=0\n"
        f"$MA_BACKLASH[0,{address}]=0.001\nM17\n"
    )


def gantry(partner: str = "ax5") -> Axis:
    return replace(axis_of("AX1"), gantry=partner)


NEW = table("AX1", [0.0, 400.0], [0.0, 0.0035], backlash=0.002)


def test_the_synchronised_axis_gets_the_same_table() -> None:
    written = {
        file.name: file.content.decode()
        for file in control_format(SIEMENS, {}).write([NEW], [gantry()])
    }
    assert list(written) == ["AX1_EEC.INI", "AX1_MD.INI", "AX5_EEC.INI", "AX5_MD.INI"]
    assert written["AX5_EEC.INI"] == written["AX1_EEC.INI"].replace("AX1", "AX5")
    assert written["AX5_MD.INI"] == written["AX1_MD.INI"].replace("AX1", "AX5")


def test_both_axes_of_a_gantry_are_read_and_patched_and_a_difference_is_told() -> None:
    same = files(A__INI=straight("AX1"), B__INI=straight("AX5"))
    state = control_format(SIEMENS, {}).read(same, [gantry()])
    assert list(state.axes) == ["AX1", "AX5"]
    assert "CW-S030" not in codes(state)
    other = files(A__INI=straight("AX1"), B__INI=straight("AX5", 0.003))
    assert "CW-S030" in codes(control_format(SIEMENS, {}).read(other, [gantry()]))
    written = control_format(SIEMENS, {}, state).write([NEW], [gantry()], other)
    assert [file.name for file in written] == ["A.INI", "B.INI"]
    back = decode(open_control(Session(), "siemens-840d-sl", {}), written, [gantry("AX5")]).state
    for address in ("AX1", "AX5"):
        assert back.axes[address].positive.tolist() == [0.0, 0.0035]
        assert back.axes[address].backlash == 0.002


def test_a_partner_of_which_the_files_say_nothing_is_missing_not_zero() -> None:
    with pytest.raises(InputError, match="axis AX5; missing values do not count as zero"):
        control_format(SIEMENS, {}).read(files(A__INI=straight("AX1")), [gantry()])


def test_a_gantry_takes_a_pair_of_tables_for_each_axis() -> None:
    options = {"cec": "available", "cec_tables": [0, 1, 2], "cec_sign": "correction"}
    two = replace(NEW, negative=np.array([0.001, 0.0]), backlash=0.0)
    for attempt in (
        lambda: control_format(SIEMENS, options).capacity(gantry()),
        lambda: control_format(SIEMENS, options).write([two], [gantry()]),
    ):
        with pytest.raises(CapacityError, match="CEC tables"):
            attempt()
    options["cec_tables"] = [0, 1, 2, 3]
    written = {
        file.name: file.content.decode()
        for file in control_format(SIEMENS, options).write([two], [gantry()])
    }
    assert "$AN_CEC_OUTPUT_AXIS[3]=(AX5)" in written["AX5_CEC.INI"]
    assert "$AN_CEC_DIRECTION[3]=-1" in written["AX5_CEC.INI"]


def test_two_axes_with_the_same_table_are_asked_about() -> None:
    text = straight("AX1").replace("M17\n", "") + straight("AX5")
    state = siemens(text, axis_of("AX1"))
    (finding,) = [finding for finding in state.findings if finding.code == "CW-S031"]
    assert "AX5" in finding.message
    assert "CW-S031" not in codes(
        siemens(straight("AX1").replace("M17\n", "") + straight("AX5", 0.003), axis_of("AX1"))
    )
    assert "CW-S031" not in codes(
        siemens(straight("AX1", 0.0).replace("M17\n", "") + straight("AX5", 0.0), axis_of("AX1"))
    )
    assert "CW-S031" not in codes(siemens(text, gantry()))
    assert "CW-S031" not in codes(siemens(text))  # nobody asked for one axis


def test_the_card_warns_of_a_gantry() -> None:
    for axis, words in (
        (gantry(), "synchronised axis ax5 too"),
        (axis_of("AX1"), "is not a gantry master axis"),
    ):
        steps = card_steps(
            SIEMENS,
            axis,
            card_values(control_format(SIEMENS, {}), axis, NEW, AxisFacts(), NEW.positions),
        )
        (text,) = [step.text for step in steps if step.title == "Gantry"]
        assert words in text
        assert "racks the bridge" in text


# Machine data
# --------------------------------------------------------------------------------------------------


def test_what_is_said_of_an_axis_as_a_whole_does_not_make_it_one_with_tables() -> None:
    data = "$MA_IS_ROT_AX[AX7]=1\n$MA_ROT_IS_MODULO[AX7]=1\n$MA_CEC_ENABLE[AX7]=1\n$MA_CEC_MAX_SUM[AX7]=1\n"
    given = [ControlFile("A.INI", (data + straight("AX1")).encode())]
    assert list(decode(open_control(Session(), "siemens-840d-sl", {}), given).state.axes) == ["AX1"]


def test_memory_that_nobody_wrote_is_no_table() -> None:
    blank = "$AA_ENC_COMP[1,0,AX1]=0\n$AA_ENC_COMP[1,1,AX1]=0\n" + "".join(
        f"$AA_ENC_COMP_{key}[1,AX1]=0\n" for key in ("STEP", "MIN", "MAX", "IS_MODULO")
    )
    state = siemens(blank + straight("AX1"), axis_of("AX1", system=2))
    assert state.axes["AX1"].positions.size == 0
    assert "CW-S032" in codes(state)
    with pytest.raises(InputError, match="not positive"):
        siemens(
            blank.replace("[1,1,AX1]=0", "[1,1,AX1]=0.1") + straight("AX1"),
            axis_of("AX1", system=2),
        )
