"""SINUMERIK: what acts or decides in the control's own files is honoured, or the axis is refused
with the parameter by name.

The shapes of the files are those of a real archive (names in MD10000 beside AX1, two measuring
systems, foreign CEC tables whose range is no multiple of their step).
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from compwright.controls.control import decode, open_control
from compwright.formats.families.activity import Activity
from compwright.formats.families.shapes import control_format
from compwright.formats.text.diff import compare_files
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Encoder
from compwright.records.correction import ControlState
from compwright.workflow.commands.new import new_job
from format_samples import SIEMENS, axis_of, codes, files, table

NAMES = '$MN_AXCONF_MACHAX_NAME_TAB[0]="X1"\n$MN_AXCONF_MACHAX_NAME_TAB[1]="Y1"\n'


def eec(
    axis: str = "AX1", system: int = 0, values: tuple[float, ...] = (0.0, 0.004, 0.0), on: str = "1"
) -> str:
    lines = [f"$AA_ENC_COMP[{system},{i},{axis}]={value}" for i, value in enumerate(values)]
    lines += [
        f"$AA_ENC_COMP_{key}[{system},{axis}]={value}"
        for key, value in (("STEP", 400), ("MIN", 0), ("MAX", 800))
    ]
    lines += [f"$AA_ENC_COMP_IS_MODULO[{system},{axis}]=0"]
    return "\n".join(lines) + "\n" + (f"$MA_ENC_COMP_ENABLE[{system},{axis}]={on}\n" if on else "")


def cec(index: int, pair: tuple[str, str], value: str = "0.1", step: int = 100, **more: str) -> str:
    """A table of ``value`` from -850 to 0: 15 points every 100 as a real archive has it, 11 every
    85 on a whole grid.
    """
    lines = [f"$AN_CEC[{index},{n}]={value}" for n in range(11 if step == 85 else 15)]
    lines += [
        f"$AN_CEC_INPUT_AXIS[{index}]=({pair[0]})",
        f"$AN_CEC_OUTPUT_AXIS[{index}]=({pair[1]})",
    ]
    said = {
        "STEP": str(step),
        "MIN": "-850",
        "MAX": "0",
        "DIRECTION": "0",
        "MULT_BY_TABLE": "0",
        "IS_MODULO": "0",
        **more,
    }
    return (
        "\n".join([*lines, *(f"$AN_CEC_{key}[{index}]={text}" for key, text in said.items())])
        + "\n"
    )


def both_readers(
    text: str, *axes: Axis, active: bool | None = None, asking: bool = False, **options: object
) -> ControlState:
    return decode(
        open_control(Session(), "siemens-840d-sl", options),
        files(A__INI=text + "M17\n"),
        axes,
        active=active,
        asking=asking,
    ).state


def alone(
    text: str, *, asking: bool = False, active: bool | None = None, **options: object
) -> ControlState:
    """AX1 as a job reads it, by the reader of this room."""
    given, activity = files(A__INI=text + "M17\n"), Activity(active, asking)
    control = control_format(SIEMENS, options)
    return control.read(given, [axis_of("AX1")], activity=activity)


def unsaid(address: str = "AX1") -> Axis:
    """An axis of a job that does not name its measuring system."""
    return replace(axis_of(address), encoder=Encoder(stated=False))


# One axis by all its names
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("address", ["AX1", "X1"])
def test_an_axis_is_one_by_its_place_and_by_its_name(address: str) -> None:
    text = NAMES + eec("X1") + "$MA_BACKLASH[0,AX1]=0.003\n"
    state = both_readers(text, axis_of(address))
    axis = state.axes[address]
    assert axis.positive.tolist() == [0, -0.004, 0]
    assert axis.backlash == 0.003
    given = files(A__INI=text + "M17\n")
    (new,) = control_format(SIEMENS, {}, state).write(
        [table(address, [0.0, 400.0, 800.0], [0.0, 0.001, 0.0])], [axis_of(address)], given
    )
    assert b"[0,1,X1]=-0.001\n" in new.content  # the form that is there
    assert b"$MA_BACKLASH[0,AX1]=0.000\n" in new.content


def test_two_addresses_of_one_axis_are_refused() -> None:
    with pytest.raises(UsageError, match="X1 and AX1 are the same axis"):
        both_readers(NAMES + eec(), axis_of("X1"), axis_of("AX1"))


def test_without_the_list_two_names_are_two_axes() -> None:
    assert set(both_readers(eec("X1") + eec("AX1")).axes) == {"X1", "AX1"}


@pytest.mark.parametrize(
    ("address", "other", "names"),
    [
        ("AX1", "X1", ""),
        ("X1", "AX1", ""),
        ("AX1", "X1", NAMES.splitlines()[1]),
        ("X1", "AX1", NAMES.splitlines()[1]),
    ],
)
def test_names_that_no_list_tells_apart_are_refused(address: str, other: str, names: str) -> None:
    """MD10000 is not among the files, or not for these: the old table of AX1 may stand under X1 and
    go on acting.
    """
    with pytest.raises(InputError, match=rf"active values of {other} too.*MD10000"):
        both_readers(f"{names}\n{eec(address)}$MA_BACKLASH[0,{other}]=0.003\n", axis_of(address))
    assert both_readers(
        f"{names}\n{eec(address)}$MA_BACKLASH[0,Y1]=0\n" if names else eec(address),
        axis_of(address),
    ).axes


def over_itself(name: str, value: str) -> str:
    """A table of an axis over itself, as programs of compensation software hold it."""
    return (
        f"$AN_CEC_INPUT_AXIS[0]=({name})\n$AN_CEC_OUTPUT_AXIS[0]=({name})\n$AN_CEC_STEP[0]=100\n"
        "$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=100\n$AN_CEC_DIRECTION[0]=1\n"
        f"$AN_CEC_IS_MODULO[0]=0\n$AN_CEC[0,0]=0\n$AN_CEC[0,1]={value}"
    )


@pytest.mark.parametrize(
    "quiet",
    [
        over_itself("SP1", "0.000000"),
        "$MA_BACKLASH[0,SP1]=0",
        "$MA_BACKLASH[0,SP1]=0.0\n$MA_ENC_COMP_ENABLE[0,SP1]=0",
        "$MA_NUM_ENCS[SP1]=1\n$MA_POS_LIMIT_MINUS[SP1]=-500\n$MA_IS_ROT_AX[SP1]=1",
        eec("SP1", values=(0.0, 0.0, 0.0), on="0"),
    ],
)
def test_another_name_that_holds_nothing_stops_nothing(quiet: str) -> None:
    """Files of single axes without MD10000: whatever SP1 is, nothing acts under that name that
    could act on AX1 too.
    """
    state = both_readers(f"{eec()}$MA_BACKLASH[0,AX1]=0.003\n{quiet}\n", axis_of("AX1"))
    assert state.axes["AX1"].positive.tolist() == [0, -0.004, 0]


@pytest.mark.parametrize(
    "acting",
    [
        "$MA_BACKLASH[1,SP1]=-0.002",
        "$MA_ENC_COMP_ENABLE[0,SP1]=1",
        "$MA_CEC_ENABLE[SP1]=TRUE",
        "$AA_ENC_COMP[0,3,SP1]=0.001",
        over_itself("SP1", "0.002000"),
    ],
)
def test_another_name_that_acts_says_the_way_out(acting: str) -> None:
    with pytest.raises(InputError, match=r"SP1.*MD10000.*set `address: SP1` in the job"):
        both_readers(f"{eec()}{acting}\n", axis_of("AX1"))


def test_a_value_that_the_control_does_not_write_is_told_as_one() -> None:
    """A public generator of pairs writes -1 for a table that does not repeat."""
    text = over_itself("AX1", "0.002000").replace("MODULO[0]=0", "MODULO[0]=-1")
    with pytest.raises(
        InputError, match=r"AN_CEC_IS_MODULO has a value.*expected 0 or 1, found -1"
    ):
        control_format(SIEMENS, {"cec_sign": "error"}).read(files(A__INI=f"{text}\nM17\n"))


# Two measuring systems
# --------------------------------------------------------------------------------------------------


def test_the_system_that_is_switched_on_is_taken_where_the_job_names_none() -> None:
    text = eec(system=0, values=(0.0, 0.0, 0.0), on="0") + eec(system=1)
    state = both_readers(text, unsaid())
    assert state.facts["AX1"].encoder_system == 2
    assert state.axes["AX1"].positive.tolist() == [0, -0.004, 0]


def test_two_systems_that_are_both_on_are_asked_about() -> None:
    with pytest.raises(UsageError, match="both measuring systems"):
        both_readers(eec(system=0) + eec(system=1), unsaid())
    one = both_readers(eec(system=0) + eec(system=1) + "$MA_NUM_ENCS[AX1]=1\n", unsaid())
    assert one.facts["AX1"].encoder_system == 1


def test_a_measuring_system_that_the_axis_has_not_is_refused() -> None:
    """MD30200 = 1: system 2 is not there, whatever table stands under its index."""
    text = eec(system=0) + eec(system=1) + "$MA_NUM_ENCS[AX1]=1\n"
    with pytest.raises(InputError, match="MD30200"):
        both_readers(text, replace(axis_of("AX1"), encoder=Encoder(system=2)))
    assert both_readers(
        text.replace("ENCS[AX1]=1", "ENCS[AX1]=2"),
        replace(axis_of("AX1"), encoder=Encoder(system=2)),
    ).axes


# Whether the table acted
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("on", ["0", "FALSE", ""])
def test_a_table_that_may_not_have_acted_is_asked_about(on: str) -> None:
    with pytest.raises(UsageError, match="unknown whether the table was active during the test"):
        both_readers(eec(on=on), axis_of("AX1"), asking=True)
    acted = both_readers(eec(on=on), axis_of("AX1"), active=True, asking=True)
    assert acted.axes["AX1"].positive.tolist() == [0, -0.004, 0]
    slept = both_readers(eec(on=on), axis_of("AX1"), active=False, asking=True)
    assert slept.axes["AX1"].positions.size == 0
    assert both_readers(
        eec(values=(0.0, 0.0, 0.0), on=on), axis_of("AX1"), asking=True
    ).axes  # a table of zeros: no question


def test_an_answer_that_the_files_contradict_is_refused() -> None:
    assert both_readers(eec(on="TRUE"), axis_of("AX1"), asking=True).axes["AX1"].positions.size == 3
    with pytest.raises(UsageError, match="active: no"):
        both_readers(eec(on="TRUE"), axis_of("AX1"), active=False, asking=True)


SLEEPING = cec(0, ("AX1", "AX1"), step=85)
OFF = [
    "$SN_CEC_TABLE_ENABLE[0]=0\n$MA_CEC_ENABLE[AX1]=1\n",
    "$SN_CEC_TABLE_ENABLE[0]=1\n$MA_CEC_ENABLE[AX1]=0\n",
]


@pytest.mark.parametrize("off", OFF)
def test_an_answer_never_wakes_a_table_beside_the_one_that_acted(off: str) -> None:
    """The leadscrew table was on, a table of 0.1 mm over the axis itself off: no question, and no
    answer wakes it.
    """
    state = both_readers(eec() + SLEEPING + off, axis_of("AX1"), asking=True)
    assert state.axes["AX1"].positive.tolist() == [0, -0.004, 0]
    assert "CW-S034" in codes(state)
    with pytest.raises(UsageError, match="which of two tables was active"):
        both_readers(
            eec() + SLEEPING + off, axis_of("AX1"), active=True, asking=True, cec_sign="error"
        )
    with pytest.raises(UsageError, match="active: no"):
        both_readers(eec() + SLEEPING + off, axis_of("AX1"), active=False, asking=True)


@pytest.mark.parametrize("off", OFF)
def test_a_table_that_the_machine_data_switch_off_slept(off: str) -> None:
    """Values in one file, the switch in the machine data: nothing loads it and ends with off."""
    control = open_control(Session(), "siemens-840d-sl", {"cec_sign": "error"})

    def read(active: bool | None, values: tuple[float, ...]) -> ControlState:
        given = files(NC_CEC__INI=SLEEPING + "M17\n", MD__INI=eec(values=values) + off + "M17\n")
        return decode(control, given, [axis_of("AX1")], active=active, asking=True).state

    for active in (None, True):  # yes is true of the leadscrew table
        assert read(active, (0.0, 0.004, 0.0)).axes["AX1"].positive.tolist() == [0, -0.004, 0]
    assert not read(None, (0.0, 0.0, 0.0)).axes["AX1"].positive.any()
    with pytest.raises(UsageError, match="which of two tables was active"):
        read(True, (0.0, 0.0, 0.0))


@pytest.mark.parametrize(("on", "off"), [("0", OFF[0]), ("", OFF[1]), ("0", "")])
def test_one_answer_does_not_mean_two_tables(on: str, off: str) -> None:
    text = eec(on=on) + SLEEPING + off
    with pytest.raises(UsageError, match="which of two tables was active"):
        both_readers(text, axis_of("AX1"), active=True, asking=True, cec_sign="error")
    assert (
        both_readers(text, axis_of("AX1"), active=False, asking=True).axes["AX1"].positions.size
        == 0
    )


def test_an_answer_speaks_of_what_the_files_leave_open() -> None:
    """AX1 is on and AX2 off over a table with values, which slept: ``no`` is true of AX2 and leaves
    AX1 as its files say.
    """
    text = eec("AX1") + eec("AX2", on="0")
    axes = axis_of("AX1"), axis_of("AX2")
    with pytest.raises(UsageError, match=r"axis AX2.*unknown whether the table was active"):
        both_readers(text, *axes, asking=True)
    state = both_readers(text, *axes, active=False, asking=True)
    assert state.axes["AX1"].positive.tolist() == [0, -0.004, 0]
    assert state.axes["AX2"].positions.size == 0
    assert any(note.value == "on" and "AX1" in note.fact for note in state.assumed)


# Foreign CEC tables
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "foreign",
    [
        cec(0, ("AX2", "AX1")),
        cec(0, ("X", "X"), step=0) + "$SN_CEC_TABLE_ENABLE[0]=0\n",
        cec(0, ("AX3", "AX2"), FOO="7"),
        cec(0, ("AX1", "AX1"), value="0"),
    ],
)
def test_a_foreign_table_is_kept_and_stops_nothing(foreign: str) -> None:
    text = NAMES + foreign + eec() + "$MA_BACKLASH[0,AX1]=0\nM17\n"
    axis = axis_of("AX1")
    state = both_readers(text, axis)
    assert codes(state) & {"CW-S050", "CW-S054"}
    (new,) = control_format(SIEMENS, {}, state).write(
        [table("AX1", [0.0, 400.0, 800.0], [0.0, 0.001, 0.0])], [axis], files(A__INI=text)
    )
    assert foreign.encode() in new.content


SPECIAL = [
    "$AN_CEC_TYPE[0]=1",
    "$AN_CEC_INPUT_NCU[0]=2",
    "$AN_CEC_OUTPUT_NCU[0]=3",
    "$SN_CEC_0[0]=0.002",
    "$SN_CEC_1[0]=-0.002",
]


@pytest.mark.parametrize("line", SPECIAL)
def test_what_makes_a_table_special_is_never_overlooked(line: str) -> None:
    """A cylinder table, another NCU, setting data that the control adds to points 0 and 1: of
    others it is left alone, of the axis over itself refused by name.
    """
    name = line.partition("[")[0]
    foreign = cec(0, ("AX2", "AX1"), step=85) + line + "\n"
    state = both_readers(eec() + foreign, axis_of("AX1"), cec_sign="error")
    assert "CW-S050" in codes(state)
    assert not state.cross
    assert "CEC table 0" in state.facts["AX1"].pairs.uncounted
    for value in ("0.1", "0"):
        own = cec(0, ("AX1", "AX1"), value, step=85) + line + "\n"
        if value == "0" and not name.startswith("$SN"):
            continue  # a table of zeros does nothing, whatever it is
        with pytest.raises(InputError, match=re.escape(name)):
            alone(eec() + own, cec_tables=[0], cec_sign="error")
        stays = alone(eec() + own, cec_sign="error")
        assert stays.axes["AX1"].others == ()
        assert "CEC table 0" in stays.facts["AX1"].other_functions
    harmless = cec(0, ("AX2", "AX1"), step=85) + re.sub("=.*", "=0", line) + "\n"
    assert both_readers(eec() + harmless, axis_of("AX1"), cec_sign="error").cross


def test_what_makes_a_table_special_is_taken_back_where_ours_is_written() -> None:
    blank = "".join(f"$AN_CEC[20,{n}]=0\n" for n in range(15)) + (
        "$AN_CEC_STEP[20]=0\n$AN_CEC_MIN[20]=0\n$AN_CEC_MAX[20]=0\n$AN_CEC_TYPE[20]=1\n"
        "$SN_CEC_0[20]=0.003\n$SN_CEC_1[20]=0.004\n"
    )
    written = pair_into(eec() + blank + "$MA_CEC_ENABLE[AX1]=0\n")
    for line in ("$AN_CEC_TYPE[20]=0\n", "$SN_CEC_0[20]=0", "$SN_CEC_1[20]=0"):
        assert line in written
    assert "0.003" not in written


@pytest.mark.parametrize("mask", ["'H1'", "'H2'", "'H800'", "'B1000000000000'", "WORD"])
def test_units_of_the_users_own_are_refused(mask: str) -> None:
    """MD10220: 'H200', the gain of the control loop, stands in a real archive and changes no
    length.
    """
    with pytest.raises(InputError, match="MD10220"):
        both_readers(f"$MN_SCALING_USER_DEF_MASK={mask}\n{eec()}", axis_of("AX1"))
    assert both_readers(f"$MN_SCALING_USER_DEF_MASK='H200'\n{eec()}", axis_of("AX1")).axes


def test_a_turn_of_another_axis_that_does_not_close_stops_nothing() -> None:
    other = eec("AX4", values=(0.0, 0.001, 0.002)).replace(
        "IS_MODULO[0,AX4]=0", "IS_MODULO[0,AX4]=1"
    )
    assert set(both_readers(eec() + other, axis_of("AX1")).axes) == {"AX1"}
    with pytest.raises(InputError, match="two ends differ"):
        both_readers(eec() + other, axis_of("AX4"))


def test_an_own_table_that_cannot_be_read_stops_its_axis_alone() -> None:
    one = cec(0, ("AX1", "AX1")).replace("[0,9]=0.1", "[0,9]=0.2")  # beyond the end
    text = one + eec() + eec("AX2")
    with pytest.raises(InputError, match="does not divide"):
        alone(text, cec_tables=[0], cec_sign="error")
    assert both_readers(text, axis_of("AX2")).axes["AX2"].positions.size == 3


OPTIONS = {"cec": "available", "cec_tables": [20, 21], "cec_sign": "correction"}
TWO = table("AX1", [0.0, 400.0, 800.0], [0.0, 0.002, -0.0015], [-0.004, -0.001, -0.0065])


def pair_into(text: str) -> str:
    given = files(A__INI=text + "M17\n")
    state = control_format(SIEMENS, OPTIONS).read(given, [axis_of("AX1")])
    return "".join(
        file.content.decode()
        for file in control_format(SIEMENS, OPTIONS, state).write([TWO], [axis_of("AX1")], given)
    )


def test_a_sleeping_table_is_never_woken_by_any_name_of_the_axis() -> None:
    text = NAMES + eec() + "$MA_CEC_ENABLE[AX1]=0\n" + cec(0, ("AX2", "X1"), step=85)
    with pytest.raises(CapacityError, match="also activates others: 0"):
        pair_into(text)
    assert "$MA_CEC_ENABLE[AX1]=1\n" in pair_into(
        text + "$SN_CEC_TABLE_ENABLE[0]=0\n"
    )  # it sleeps on
    assert "$MA_CEC_ENABLE[AX1]=1\n" in pair_into(
        NAMES + eec() + "$MA_CEC_ENABLE[AX1]=0\n" + cec(0, ("AX2", "X1"), "0", 85)
    )


@pytest.mark.parametrize("sum_off", ["$MA_CEC_ENABLE[AX1]=0\n", ""])
def test_a_table_that_is_on_with_its_values_in_no_file_is_never_woken(sum_off: str) -> None:
    """Its output axis and values are unknown: the file of the CEC tables was not given."""
    text = NAMES + eec() + sum_off
    with pytest.raises(
        CapacityError, match=r"also activates others: 5 \(values in no given file: 5\)"
    ):
        pair_into(text + "$SN_CEC_TABLE_ENABLE[5]=1\n")
    assert "$AN_CEC_DIRECTION[21]=-1" in pair_into(text + "$SN_CEC_TABLE_ENABLE[5]=0\n")


def test_a_table_that_another_is_multiplied_by_is_not_written() -> None:
    with pytest.raises(CapacityError, match="MULT_BY_TABLE"):
        pair_into(
            eec()
            + cec(0, ("AX2", "AX3"), step=85, MULT_BY_TABLE="21")
            + "$SN_CEC_TABLE_ENABLE[0]=0\n"
        )


def test_values_in_inch_are_not_written_to() -> None:
    with pytest.raises(CapacityError, match="MD32711"):
        pair_into(eec() + "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0\n")


def test_the_sign_is_asked_for_where_a_pair_is_written_or_replaced() -> None:
    unknown = {**OPTIONS, "cec_sign": None}
    with pytest.raises(UsageError, match="dial gauge"):
        control_format(SIEMENS, unknown).write([TWO], [axis_of("AX1")])
    own = (
        cec(0, ("AX1", "AX1"), step=85)
        + "$SN_CEC_TABLE_ENABLE[0]=1\n$MA_CEC_ENABLE[AX1]=1\n"
        + eec()
    )
    with pytest.raises(UsageError, match="cec_sign"):
        both_readers(own, axis_of("AX1"), cec_tables=[0])
    stays = both_readers(own, axis_of("AX1"))  # nobody gave it to be written: no answer is needed
    assert "CEC table 0" in stays.facts["AX1"].other_functions
    others = both_readers(cec(0, ("AX3", "AX2"), step=85) + eec(), axis_of("AX1"))
    assert (others.cross, "CW-S051" in codes(others)) == ((), True)


# What else acts
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "says"),
    [("$MA_GANTRY_AXIS_TYPE[AX1]=1", "MD37100"), ("$MA_GANTRY_AXIS_TYPE[AX1]=11", "MD37100")],
)
def test_a_gantry_that_the_job_does_not_name_is_refused(line: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        both_readers(f"{eec()}{line}\n", axis_of("AX1"))


def test_what_stays_beside_the_table_is_named() -> None:
    text = eec() + "$MA_TEMP_COMP_TYPE[AX1]='H3'\n$SA_TEMP_COMP_SLOPE[AX1]=0.00001\n"
    assert "CW-S053" in codes(both_readers(text, axis_of("AX1")))
    assert "CW-S053" not in codes(both_readers(text.replace("H3", "H1"), axis_of("AX1")))


def test_a_travel_outside_the_software_limits_is_refused() -> None:
    """MD36100 and MD36110: with limits of -800 and 0 a travel of 0 to 800 is told from the other
    end.
    """

    def limited(low: int, high: int) -> ControlState:
        text = f"{eec()}$MA_POS_LIMIT_MINUS[AX1]={low}\n$MA_POS_LIMIT_PLUS[AX1]={high}\n"
        return both_readers(text, replace(axis_of("AX1"), travel=(0.0, 800.0)))

    with pytest.raises(InputError, match=r"POS_LIMIT_MINUS, \$MA_POS_LIMIT_PLUS"):
        limited(-800, 0)
    assert "CW-S045" in codes(limited(0, 700))
    assert "CW-S045" not in codes(limited(-5, 790))


def test_an_endless_axis_is_endless_for_job_and_control() -> None:
    text = (
        eec("AX4", values=(0.0, 0.0, 0.0)) + "$MA_ROT_IS_MODULO[AX4]=1\n$MA_MODULO_RANGE[AX4]=360\n"
    )
    with pytest.raises(InputError, match="MD30310"):
        both_readers(text, axis_of("AX4", kind=AxisKind.ROTARY))
    with pytest.raises(InputError, match="MD30330"):
        both_readers(text, axis_of("AX4", kind=AxisKind.ROTARY, modulo=180.0))


@pytest.mark.parametrize(
    ("head", "tail", "active"),
    [
        ("1", "", None),
        ("0", "", True),
        ("1", "1", None),
        ("0\n$MA_ENC_COMP_ENABLE[0,AX1]=1", "0", True),
    ],
)
def test_a_file_with_switch_and_values_is_off_before_the_values_and_on_behind_them(
    head: str, tail: str, active: bool | None
) -> None:
    """MD32700 = 1 protects a table (function manual K3): of a file that says so first the control
    takes none of the values.
    """
    switch = "$MA_ENC_COMP_ENABLE[0,AX1]="
    text = f"$MA_BACKLASH[0,AX1]=0\n{switch}{head}\n{eec(on=tail)}"
    state = both_readers(text, axis_of("AX1"), active=active)
    wanted = table("AX1", [0.0, 400.0, 800.0, 1200.0], [0.0, 0.001, 0.0, 0.002])
    (new,) = control_format(SIEMENS, {}, state).write(
        [wanted], [axis_of("AX1")], files(A__INI=text + "M17\n")
    )
    on = {"ENABLE": 0, "values": 0}
    for line in new.content.decode().splitlines():
        if line.startswith(switch):
            on["ENABLE"] = int(line.removeprefix(switch))
        elif line.startswith("$AA_ENC_COMP"):
            assert on["ENABLE"] == 0, line
            on["values"] += 1
    assert on == {"ENABLE": 1, "values": 4 + 4}


@pytest.mark.parametrize("before", ["$SN_CEC_TABLE_ENABLE[20]=1\n", "$MA_CEC_ENABLE[AX1]=1\n"])
def test_a_file_that_has_a_cec_table_on_before_its_values_is_not_written(before: str) -> None:
    """SD41300 and MD32710 protect a table like MD32700 (function manual K3); values first, then the
    switches, is written.
    """
    values = cec(20, ("AX1", "AX1"), value="0", step=85) + cec(
        21, ("AX1", "AX1"), value="0", step=85
    )
    on = "$SN_CEC_TABLE_ENABLE[20]=1\n$SN_CEC_TABLE_ENABLE[21]=1\n$MA_CEC_ENABLE[AX1]=1\n"
    with pytest.raises(CapacityError, match="before it gives"):
        pair_into(before + eec() + values + on.replace(before, ""))
    assert "$AN_CEC[20,1]=" in pair_into(eec() + values + on)


@pytest.mark.parametrize(
    ("off", "again"),
    [
        (["$SN_CEC_TABLE_ENABLE[20]"], False),
        (["$MA_CEC_ENABLE[AX1]"], False),
        (["$SN_CEC_TABLE_ENABLE[20]", "$SN_CEC_TABLE_ENABLE[21]", "$MA_CEC_ENABLE[AX1]"], False),
        (["$SN_CEC_TABLE_ENABLE[20]", "$MA_CEC_ENABLE[AX1]"], True),
    ],
)
def test_a_cec_table_that_is_off_before_its_values_goes_on_behind_them(
    off: list[str], again: bool
) -> None:
    """Off stays off until every value is there, as in a maker's program; ``again``: the file says
    itself what is behind them.
    """
    values = cec(20, ("AX1", "AX1"), value="0", step=85) + cec(
        21, ("AX1", "AX1"), value="0", step=85
    )
    every = ("$SN_CEC_TABLE_ENABLE[20]", "$SN_CEC_TABLE_ENABLE[21]", "$MA_CEC_ENABLE[AX1]")
    tail = "".join(f"{name}=1\n" for name in every if again or name not in off)
    lines = pair_into("".join(f"{name}=0\n" for name in off) + eec() + values + tail).splitlines()
    for name in every:
        own = "$AN_CEC[2" if "AX1" in name else name.replace("$SN_CEC_TABLE_ENABLE", "$AN_CEC")[:-1]
        rows = [n for n, line in enumerate(lines) if line.startswith(own)]
        assert len(rows) > 2, own
        said = {n: line.rpartition("=")[2] for n, line in enumerate(lines) if name in line}
        assert said[max(said)] == "1", name
        assert max(said) > rows[-1], name
        assert all(text == "0" for n, text in said.items() if n < rows[-1]), name


def test_an_entry_is_named_in_full() -> None:
    """What stands between the brackets of an input axis is its value; the entry is the name
    before.
    """
    old, new = cec(3, ("AX1", "AX1")) + NAMES, cec(3, ("AX3", "AX1")) + NAMES.replace("Y1", "Y2")
    changes = compare_files(SIEMENS, files(A__INI=old), files(A__INI=new)).changes
    told = {(change.entry, change.old, change.new) for change in changes}
    assert told == {
        ("$AN_CEC_INPUT_AXIS[3]", "AX1", "AX3"),
        ("$MN_AXCONF_MACHAX_NAME_TAB[1]", "Y1", "Y2"),
    }


@pytest.mark.parametrize("word", ["HX", "ON", "B12"])
def test_a_mask_that_cannot_be_read_is_no_zero(word: str) -> None:
    with pytest.raises(InputError, match="MD32750"):
        both_readers(f"{eec()}$MA_TEMP_COMP_TYPE[AX1]={word}\n", axis_of("AX1"))


def test_a_basic_system_that_no_file_says_is_listed() -> None:
    control = open_control(Session(), "siemens-840d-sl", {})

    def noted(text: str) -> dict[str, str]:
        state = both_readers(text, axis_of("AX1"))
        return {note.fact: note.evidence for note in control.in_state(state).assumed(state)}

    assert "default" in noted(eec())["option units"]
    for line in ("METRIC\n", "$MN_SCALING_SYSTEM_IS_METRIC=1\n"):
        assert "option units" not in noted(line + eec())


def test_the_limit_of_the_sum_is_listed_where_no_file_says_it() -> None:
    def said(text: str) -> bool:
        state = control_format(SIEMENS, OPTIONS).read(
            files(A__INI=text + "M17\n"), [axis_of("AX1")]
        )
        return any(
            "MD32720" in note.fact
            for note in control_format(SIEMENS, OPTIONS, state).capacity(axis_of("AX1")).assumed
        )

    assert said(eec())
    assert not said(eec() + "$MA_CEC_MAX_SUM[AX1]=1\n")


ROUND = replace(axis_of("AX4", kind=AxisKind.ROTARY, modulo=360.0), reference=90.0)
TURN_TABLE = replace(
    table(
        "AX4",
        [90.0, 180.0, 270.0, 360.0, 450.0],
        [0.0, 0.001, 0.0, 0.002, 0.0],
        kind=AxisKind.ROTARY,
    ),
    period=360.0,
)


def test_a_turn_that_no_file_says_needs_its_reference_at_the_start() -> None:
    with pytest.raises(CapacityError, match=r"MD30310.*MD30340"):
        control_format(SIEMENS, {}).write([TURN_TABLE], [ROUND])
    at_zero = replace(ROUND, reference=0.0)
    facts = [note.fact for note in control_format(SIEMENS, {}).capacity(at_zero).assumed]
    assert [number for fact in facts for number in ("MD30310", "MD30340") if number in fact] == [
        "MD30310",
        "MD30340",
    ]
    given = (
        eec("AX4", values=(0.0, 0.0, 0.0))
        + "$MA_ROT_IS_MODULO[AX4]=1\n$MA_MODULO_RANGE_START[AX4]=0\n"
    )
    state = both_readers(given, ROUND)
    assert not [
        note
        for note in control_format(SIEMENS, {}, state).capacity(ROUND).assumed
        if "MD303" in note.fact
    ]
    assert (
        b"$AA_ENC_COMP[0,0,AX4]=-0.002"
        in control_format(SIEMENS, {}, state).write([TURN_TABLE], [ROUND])[0].content
    )


def test_a_new_job_pairs_the_axes_of_a_gantry(tmp_path: Path) -> None:
    """MD37100: 1 leads the first group, 11 is the synchronised axis of it; AX3 is alone."""
    text = "METRIC\n" + eec("AX1") + eec("AX3", values=(0.0, 0.001, 0.0)) + eec("AX7")
    for axis, kind in (("AX1", 1), ("AX3", 0), ("AX7", 11)):
        text += f"$MA_GANTRY_AXIS_TYPE[{axis}]={kind}\n"
    (tmp_path / "A.INI").write_text(text + "M17\n")
    job = tmp_path / "job.yaml"
    new_job(Session(), [tmp_path / "A.INI"], "siemens-840d-sl", {}, job)
    said = job.read_text()
    assert re.findall(r"address: (\w+)", said) == ["AX1", "AX3"]
    assert re.findall(r"gantry: (\w+)", said) == ["AX7"]
    state = both_readers(text)
    assert [state.facts[each].leading for each in ("AX1", "AX3", "AX7")] == [None, None, "AX1"]
