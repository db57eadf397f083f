"""Lists of the ISG kernel: hand-worked numbers of the vendor's form, limits, what acts beside the
table, and lists of the user's own that are changed in place.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from test_run_circles import Bent, measure

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.formats.families.activity import Activity
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from format_samples import DEFINITIONS, axis_of, codes, table
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

ISG = "isg-kernel"
#: The sample of the definition: hand-worked in µm, + and -, at positions in mm (values are errors).
SAMPLE = DEFINITIONS[ISG].sample_files["achskw1.lis"]
WORKED = {
    -250.0: (4.0, 2.5),
    -100.0: (2.0, 0.35),
    0.0: (0.0, -1.8),
    75.0: (-1.5, -3.0),
    225.0: (-5.7, -6.6),
    310.0: (-8.4, -9.0),
}
#: Far below the tenth of a µm in which the lists count, mm.
EXACT = 1e-12
EVEN = """kopf.achs_nr 1
kw.ssfk.unit 1
kw.ssfk.interval 20000   # 2 mm
kw.ssfk.kw_startpos -909000
kw.ssfk.kw_nr_max 3
kw.ssfk.bilateral 0
kw.ssfk.table[ 0].pos 0    # -90.9 mm
kw.ssfk.table[ 1].pos 10   # -88.9 mm
kw.ssfk.table[ 2].pos -30
"""
SLAVE = """kopf.achs_nr 2
kw.crosscomp.unit 1
kw.crosscomp.master_ax_nr 1
kw.crosscomp.last_index 2
kw.crosscomp.table[0].setpoint -1000000
kw.crosscomp.table[0].correction 0
kw.crosscomp.table[1].setpoint 0
kw.crosscomp.table[1].correction 20
kw.crosscomp.table[2].setpoint 2000000
kw.crosscomp.table[2].correction -40
"""
PLAY = "kopf.achs_nr 1\nlr_param.ssfk 1\nlr_param.anwahl_losekomp 1\ngetriebe[0].lose 50\n"
X = axis_of("1")


def files(**texts: str) -> list[ControlFile]:
    return [ControlFile(f"{name}.lis", text.encode("latin-1")) for name, text in texts.items()]


def read(
    *axes: Axis, options: dict[str, object] | None = None, active: bool | None = None, **texts: str
) -> ControlState:
    activity = Activity(stated=active, asking=bool(axes))
    return control_format(DEFINITIONS[ISG], options or {}).read(
        files(**texts), axes, activity=activity
    )


def at(state: ControlState, address: str, place: float) -> tuple[float, float]:
    """Corrections in µm at one position, arriving in + and in -."""
    both = [state.axes[address].at(np.array([place]), each)[0] * 1e3 for each in Direction]
    return float(both[0]), float(both[1])


def written(
    compensation: AxisCompensation, *own: ControlFile, axis: Axis = X, **options: object
) -> dict[str, str]:
    made = control_format(DEFINITIONS[ISG], options).write([compensation], [axis], own)
    return {file.name: file.content.decode("latin-1") for file in made}


# --- reading


@pytest.mark.parametrize(("place", "worked"), WORKED.items())
def test_the_vendors_form_gives_the_corrections_worked_by_hand(
    place: float, worked: tuple[float, float]
) -> None:
    assert at(read(a=SAMPLE), "1", place) == pytest.approx(worked, abs=1e-9)
    turned = read(a=SAMPLE, options={"table_values": "correction"})
    assert at(turned, "1", place) == pytest.approx([-one for one in worked], abs=1e-9)


def test_statements_may_stand_in_any_order_case_and_with_remarks() -> None:
    lines = SAMPLE.splitlines()
    odd = [line.replace("[", "[ ").upper() for line in reversed(lines[1:])]
    text = "/* written by hand:\nkw.ssfk.table[0].pos 999\n*/\r\n:\r\n" + "\r\n".join(odd)
    text += " /* last */\r\nkw.ssfk.res1 0\r\n"
    assert at(read(a=text), "1", 225.0) == pytest.approx(WORKED[225.0], abs=1e-9)


def test_equal_spacing_one_column_and_a_backlash() -> None:
    state = read(a=EVEN, b=PLAY)
    # -89.9 mm lies half way from 0 to 10 counts of 0.1 µm: error 0.5 µm; 5 µm of play in -
    assert at(state, "1", -89.9) == pytest.approx((-0.5, -5.5), abs=1e-9)
    assert at(state, "1", -200.0) == pytest.approx((0.0, -5.0), abs=1e-9)
    assert any("arriving in -" in each.value for each in state.assumed)
    other = read(replace(X, reference_return=Direction.NEGATIVE), a=EVEN, b=PLAY)
    assert at(other, "1", -89.9) == pytest.approx((4.5, -0.5), abs=1e-9)


def test_increments_need_their_length() -> None:
    text = EVEN.replace("unit 1", "unit 0")
    with pytest.raises(UsageError, match="whose length is unknown"):
        read(X, a=text)
    # 20 000 increments of 0.5 µm are 10 mm; from -454.5 mm, 10 increments are 5 µm
    state = read(X, a=text, options={"encoder_increment": 0.0005})
    assert state.axes["1"].positions.tolist() == pytest.approx([-454.5, -444.5, -434.5])
    assert at(state, "1", -444.5) == pytest.approx((-5.0, -5.0), abs=1e-9)


def test_a_table_that_repeats_goes_on_behind_its_ends() -> None:
    text = SAMPLE.replace("modulo                    0", "modulo 1").replace(
        "[3].pos              84", "[3].pos -40"
    )
    turn = text.replace("[3].neg              90", "[3].neg -25")
    assert at(read(a=turn), "1", -100.0 + 500.0) == pytest.approx(WORKED[-100.0], abs=1e-9)
    with pytest.raises(InputError, match="first and last entry must be equal"):
        read(a=text)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("kw.ssfk.unit                      1 ", "#", "kw.ssfk.unit is missing"),
        ("interval                  0 ", "interval=0 ", "cannot be read"),
        ("kw_nr_max                 4", "kw_nr_max 5", "is missing (1 of 5)"),
        ("kw_nr_max                 4", "kw_nr_max 3", "lies beyond the last entry"),
        ("kw_nr_max                 4", "kw_nr_max 1500", "must be less than"),
        ("kw_nr_max                 4", "kw_nr_max 4\nkw.ssfk.max_points 4", "must be less than"),
        (
            "kw_nr_max                 4",
            "kw_nr_max 999999998\nkw.ssfk.max_points 999999999",
            "is missing (999999994 of 999999998)",
        ),
        ("kw_startpos               -2000000", "kw_startpos 1", "is not the first setpoint"),
        ("[2].setpoint         1500000", "[2].setpoint -5", "do not ascend at entry 2"),
        ("[1].pos              0", "[1].pos 0x0", "kw.ssfk.table[1].pos"),
        ("[1].pos              0", "[1].pos 0\nkw.ssfk.table[1].pos 1", "contradicts"),
        ("bilateral                 1", "bilateral 0", "the column for - contains another value"),
        ("bilateral                 1", "bilateral 2", "not known"),
        ("kopf.achs_nr                      1", "", "does not state the number of its axis"),
        ("kopf.log_achs_name                X", "kopf.log_achs_nr 2", "name different axes"),
        ("kw.ssfk.modulo                    0", "kw.temp.gain 3", "kw.temp.gain"),
        ("kw.ssfk.modulo                    0", "kw.ssfk.res1 1", "kw.ssfk.res1"),
        (
            "kw.ssfk.modulo                    0",
            "kw.crosscomp2.table[0][0].correction 4",
            "kw.crosscomp2",
        ),
    ],
)
def test_what_contradicts_itself_is_refused_by_line(old: str, new: str, said: str) -> None:
    assert old in SAMPLE
    with pytest.raises(InputError) as error:
        read(X, a=SAMPLE.replace(old, new, 1))
    assert said in str(error.value)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("getriebe[0].lose 50", "no list shows whether it is active"),
        ("lr_param.anwahl_losekomp 1", "getriebe[0].lose is missing"),
        ("lr_param.anwahl_losekomp 1\ngetriebe[0].lose -50", "less than 0"),
        ("lr_param.anwahl_losekomp 1\ngetriebe[0].lose 0.5", "must be a whole number"),
        ("lr_param.anwahl_losekomp 2\ngetriebe[0].lose 40000", "must be a whole number"),
        ("lr_param.anwahl_losekomp 1\ngetriebe[0].lose 5\ngetriebe[1].lose 6", "gear 1"),
        ("lr_param.anwahl_losekomp 3\ngetriebe[0].lose 5", "not known"),
    ],
)
def test_a_backlash_that_is_not_clear_is_refused(lines: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        read(X, a=EVEN, b=f"kopf.achs_nr 1\n{lines}\n")
    assert said in str(error.value)


def test_a_backlash_beside_two_columns_is_refused_and_one_that_is_off_is_nothing() -> None:
    with pytest.raises(InputError, match="contains the reversal"):
        read(X, a=SAMPLE, b=PLAY)
    off = PLAY.replace("losekomp 1", "losekomp 0")
    assert at(read(X, a=SAMPLE, b=off), "1", 0.0) == pytest.approx(WORKED[0.0], abs=1e-9)


@pytest.mark.parametrize("where", ["kw.ssfk.manual_activation 1", "lr_param.ssfk 0"])
def test_a_table_that_is_switched_off_acts_only_where_the_job_says_so(where: str) -> None:
    off = f"kopf.achs_nr 1\n{where}\n"
    with pytest.raises(UsageError, match="is unknown whether the table was active"):
        read(X, a=SAMPLE, b=off)
    assert read(a=SAMPLE, b=off).axes["1"].positions.size == 0
    acting = read(X, active=True, a=SAMPLE, b=off)
    assert at(acting, "1", 75.0) == pytest.approx(WORKED[75.0], abs=1e-9)
    assert read(X, active=False, a=SAMPLE, b=off).axes["1"].positions.size == 0


def test_the_start_up_list_says_what_is_loaded_and_whose_it_is() -> None:
    headless = SAMPLE.replace("kopf.achs_nr                      1", "")
    start = "zahl_kw 1\nachs_kw_log_ax_nr[0] 4\nachs_kw[0] C:\\cnc\\A.LIS\n"
    state = read(a=headless, start=start)
    assert at(state, "4", 75.0) == pytest.approx(WORKED[75.0], abs=1e-9)
    # another list of the same axis is not loaded
    state = read(a=headless, old=EVEN.replace("nr 1", "nr 4"), start=start)
    assert at(state, "4", 75.0) == pytest.approx(WORKED[75.0], abs=1e-9)
    assert "CW-S012" in codes(state)
    with pytest.raises(InputError, match="was not given"):
        read(axis_of("4"), b=PLAY.replace("nr 1", "nr 4"), start=start)
    with pytest.raises(InputError, match="name different axes"):
        read(a=SAMPLE, start=start)


@pytest.mark.parametrize(
    ("start", "says"),
    [
        (
            "zahl_kw 0\nachs_kw_log_ax_nr[0] 1\nachs_kw[0] a.lis\n",
            "expected zahl_kw 1, or no such entry",
        ),
        (
            "zahl_kw 1\nachs_kw_log_ax_nr[1] 1\nachs_kw[1] a.lis\n",
            "expected zahl_kw 2, or no such entry",
        ),
        ("zahl_kw 1\nzahl_kw 2\nachs_kw_log_ax_nr[0] 1\nachs_kw[0] a.lis\n", "contradicts"),
    ],
)
def test_a_list_beyond_the_number_of_the_start_up_list_is_refused(start: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read(a=SAMPLE, start=start)
    with pytest.raises(InputError, match="zahl_kw"):
        virtual_control(ISG, files(a=SAMPLE, start=start))


@pytest.mark.parametrize(
    ("word", "kind"),
    [
        ("0x0001", AxisKind.LINEAR),
        ("ACHSTYP_TRANSLATOR", AxisKind.LINEAR),
        ("0x0002", AxisKind.ROTARY),
        ("2", AxisKind.ROTARY),
        ("ACHSTYP_ROTATOR", AxisKind.ROTARY),
        ("0x0004", AxisKind.ROTARY),
        ("0x0008", None),
        ("TRANSLATOR_X", None),
    ],
)
def test_both_readers_compare_the_type_of_the_axis_with_its_kind(
    word: str, kind: AxisKind | None
) -> None:
    """P-AXIS-00018: 0x0001 ACHSTYP_TRANSLATOR, 0x0002 ACHSTYP_ROTATOR, 0x0004 ACHSTYP_SPINDEL."""
    first = f"kopf.achs_nr 1\nkenngr.achs_typ {word}\n"
    lists = files(achsmds1=first, achskw1=EVEN)
    for asked in AxisKind:
        axis = replace(X, kind=asked, modulo=None)
        if kind is asked:
            assert read(axis, achsmds1=first, achskw1=EVEN).facts_of("1").kind is kind
            virtual_control(ISG, lists, kinds={"1": asked}, axes_under_work=["1"])
            continue
        with pytest.raises(InputError, match=r"line 2.*achs_typ"):
            read(axis, achsmds1=first, achskw1=EVEN)
        with pytest.raises(InputError, match=r"line 2.*type of axis 1"):
            virtual_control(ISG, lists, kinds={"1": asked}, axes_under_work=["1"])
    if kind is not None:
        assert read(achsmds1=first, achskw1=EVEN).axes["1"].kind is kind


def test_what_no_list_says_of_an_axis_is_refused() -> None:
    with pytest.raises(InputError, match="missing values do not count as zero"):
        read(axis_of("7"), a=SAMPLE)


def test_the_axes_of_a_gantry_get_one_table_and_twins_are_told() -> None:
    second = SAMPLE.replace("achs_nr                      1", "achs_nr 2")
    assert "CW-S031" in codes(read(X, a=SAMPLE, b=second))
    leading = replace(X, gantry="2")
    assert not codes(read(leading, a=SAMPLE, b=second)) & {"CW-S030", "CW-S031"}
    other = second.replace("[0].pos              -40", "[0].pos 5")
    assert "CW-S030" in codes(read(leading, a=SAMPLE, b=other))
    made = written(NEW, *files(a=SAMPLE, b=other), axis=leading)
    assert (
        made["a.lis"].split("\n")[5:]
        == made["b.lis"].replace("[0].pos 0", "[0].pos              0").split("\n")[5:]
    )


# --- cross-axis tables


def test_a_table_in_the_slaves_list_is_read_with_its_sign_and_left_out_without() -> None:
    state = read(a=SLAVE, options={"cross_values": "correction"})
    (entry,) = state.cross
    assert (entry.input, entry.output) == ("1", "2")
    where = np.array([-500.0, -50.0, 100.0, 900.0])
    # ends held; half way from 0 to 2 µm, and from 2 to -4 µm
    found = entry.at(where, Direction.NEGATIVE) * 1e3
    assert found.tolist() == pytest.approx([0.0, 1.0, -1.0, -4.0], abs=1e-9)
    other = read(a=SLAVE, options={"cross_values": "error"}).cross[0]
    assert np.array_equal(other.positive, -entry.positive)
    state = read(a=SLAVE)
    assert not state.cross
    assert "CW-S050" in codes(state)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("master_ax_nr 1", "master_ax_nr 2", "its own master"),
        ("master_ax_nr 1", "slave_ax_nr 1", "kw.crosscomp.slave_ax_nr"),
        ("last_index 2", "last_index 1", "beyond the last entry"),
        ("last_index 2", "last_index 3", "is missing"),
        ("last_index 2", "last_index 1001", "less than 1001"),
        ("setpoint 0", "setpoint -1000000", "do not ascend"),
        ("unit 1", "unit 0", "in increments"),
    ],
)
def test_a_table_between_axes_that_is_not_clear_is_refused(old: str, new: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        read(axis_of("2"), a=SLAVE.replace(old, new, 1), options={"cross_values": "error"})
    assert said in str(error.value)


def test_what_is_odd_about_an_axis_that_nobody_asks_for_stops_nothing() -> None:
    odd = SLAVE + "getriebe[0].lose 50\nkw.temp.gain 3\n"
    state = read(X, a=SAMPLE, b=odd, options={"cross_values": "error"})
    assert at(state, "1", 75.0) == pytest.approx(WORKED[75.0], abs=1e-9)
    assert not state.cross
    assert "CW-S050" in codes(state)


# --- writing

NEW = table("1", [-200.0, 0.0, 150.0, 300.0], [0.0, -0.001, 0.002, 0.0034], [0.0, 0.001, 0.0, 0.01])


def test_a_new_list_has_header_first_and_whole_tenths() -> None:
    text = written(NEW)["achskw1.lis"]
    lines = [line.split() for line in text.split("\r\n") if line and not line.startswith("#")]
    assert lines[:8] == [
        ["kopf.achs_nr", "1"],
        ["kw.ssfk.unit", "1"],
        ["kw.ssfk.bilateral", "1"],
        ["kw.ssfk.interval", "0"],
        ["kw.ssfk.kw_startpos", "-2000000"],
        ["kw.ssfk.kw_nr_max", "4"],
        ["kw.ssfk.modulo", "0"],
        ["kw.ssfk.table[0].setpoint", "-2000000"],
    ]
    assert lines[-3:] == [
        ["kw.ssfk.table[3].setpoint", "3000000"],
        ["kw.ssfk.table[3].pos", "-34"],
        ["kw.ssfk.table[3].neg", "-100"],
    ]
    turned = written(NEW, table_values="correction")["achskw1.lis"]
    assert "table[3].pos         34\r\n" in turned


def test_values_in_their_places_change_and_nothing_else() -> None:
    own = ControlFile(
        "a.lis", SAMPLE.replace("[2].neg              42", "[2].neg 42 # \xe4").encode("latin-1")
    )
    text = written(NEW, own)["a.lis"]
    changed = {
        (old, new)
        for old, new in zip(
            own.content.decode("latin-1").split("\n"), text.split("\n"), strict=True
        )
        if old != new
    }
    assert {new.strip() for _, new in changed} == {
        "kw.ssfk.table[0].pos              0",
        "kw.ssfk.table[0].neg              0",
        "kw.ssfk.table[1].pos              10",
        "kw.ssfk.table[1].neg              -10",
        "kw.ssfk.table[2].pos              -20",
        "kw.ssfk.table[2].neg 0 # \xe4",
        "kw.ssfk.table[3].pos              -34",
        "kw.ssfk.table[3].neg              -100",
    }


def test_other_entries_take_the_place_of_the_old_ones_and_foreign_lines_stay() -> None:
    own = (
        EVEN.replace("kw.ssfk.table[ 1]", "kw.ssfk.res1 0\n/* keep\n this */ kw.ssfk.table[ 1]")
        + "# end\nother.key 7\n"
    )
    short = table("1", [-90.0, -88.0], [0.0, 0.001], [0.001, 0.0])
    text = written(short, ControlFile("a.lis", own.encode()))["a.lis"]
    assert text.split("\n") == [
        "kopf.achs_nr 1",
        "kw.ssfk.unit 1",
        "kw.ssfk.interval 20000   # 2 mm",
        "kw.ssfk.kw_startpos -900000",
        "kw.ssfk.kw_nr_max 2",
        "kw.ssfk.bilateral 1",
        "kw.ssfk.modulo               0",
        "kw.ssfk.table[0].pos         0",
        "kw.ssfk.table[0].neg         -10",
        "kw.ssfk.table[1].pos         -10",
        "kw.ssfk.table[1].neg         0",
        "kw.ssfk.res1 0",
        "/* keep",
        " this */    # -88.9 mm",
        "# end",
        "other.key 7",
        "",
    ]
    both = EVEN.replace("bilateral 0", "bilateral 1") + "".join(
        f"kw.ssfk.table[{index}].neg 0\n" for index in range(3)
    )
    moved = table("1", [-90.0, -88.0, -86.0], [0.0, 0.001, 0.0])
    text = written(moved, ControlFile("a.lis", both.encode()))["a.lis"]
    assert "mm" not in text.replace("# 2 mm", "")  # a remark that names the old place goes
    uneven = table("1", [-90.0, -88.0, -80.0], [0.0, 0.001, 0.0])
    text = written(uneven, ControlFile("a.lis", EVEN.encode()))["a.lis"]
    assert "interval 0   # 2 mm" in text
    assert "table[2].setpoint    -800000" in text


def test_what_would_act_beside_the_table_or_keep_it_from_acting_is_set() -> None:
    own = files(
        a=EVEN + "kw.ssfk.manual_activation 1\n",
        b=PLAY.replace("ssfk 1", "ssfk 0") + "kenngr.x 5\ngetriebe[1].lose 50\n",
        start="zahl_kw 1\nachs_kw_log_ax_nr[0] 1\nachs_kw[0] a.lis\n",
    )
    made = written(NEW, *own)
    assert "manual_activation 0" in made["a.lis"]
    assert made["b.lis"] == (
        "kopf.achs_nr 1\nlr_param.ssfk 1\nlr_param.anwahl_losekomp 1\ngetriebe[0].lose 0\n"
        "kenngr.x 5\ngetriebe[1].lose 0\n"
    )
    assert made["start.lis"] == "zahl_kw 1\nachs_kw_log_ax_nr[0] 1\nachs_kw[0] a.lis\n"


def test_a_new_list_is_named_in_the_start_up_list() -> None:
    own = files(
        b=PLAY,
        achskw1=EVEN.replace("nr 1", "nr 2"),
        start="zahl_kw 1\nachs_kw_log_ax_nr[0] 2\nachs_kw[0] achskw1.lis",
    )
    made = written(NEW, *own)
    assert set(made) == {"b.lis", "start.lis", "achskw1_2.lis"}
    assert made["start.lis"].splitlines() == [
        "zahl_kw 2",
        "achs_kw_log_ax_nr[0] 2",
        "achs_kw[0] achskw1.lis",
        "achs_kw_log_ax_nr[1]    1",
        "achs_kw[1]              achskw1_2.lis",
    ]
    judge = virtual_control(
        ISG, [ControlFile(n, t.encode()) for n, t in made.items()], axes_under_work=["1"]
    )
    found = judge.correction("1", np.array([300.0]), Direction.NEGATIVE)
    assert found == pytest.approx([0.01], abs=EXACT)


def test_limits_of_points_and_types() -> None:
    grid = np.arange(1500.0)
    with pytest.raises(CapacityError, match="at most 1499"):
        written(table("1", grid.tolist(), [0.0] * 1500))
    assert written(table("1", grid[:1499].tolist(), [0.0] * 1499))
    own = ControlFile("a.lis", (EVEN + "kw.ssfk.max_points 4\n").encode())
    with pytest.raises(CapacityError, match="at most 3"):
        written(NEW, own)
    high = table("1", [0.0, 10.0], [3.2767, 3.2768], [0.0, 0.0])
    with pytest.raises(CapacityError, match="type"):
        written(high, value_type="sgn16")
    with pytest.raises(CapacityError, match="type"):
        written(replace(high, positive=-high.positive), value_type="sgn16")
    assert "-32768" in written(high)["achskw1.lis"]
    with pytest.raises(CapacityError, match="not a multiple"):
        written(table("1", [0.0, 10.0], [0.00005, 0.0]))
    with pytest.raises(CapacityError, match="backlash"):
        written(table("1", [0.0, 10.0], [0.0, 0.001], backlash=0.005))


def test_an_endless_axis_gets_a_table_that_repeats() -> None:
    axis = axis_of("1", kind=AxisKind.ROTARY, modulo=360.0)
    turn = table("1", [0.0, 90.0, 360.0], [0.0, 0.002, 0.0], kind=AxisKind.ROTARY)
    text = written(replace(turn, period=360.0), axis=axis)["achskw1.lis"]
    assert "kw.ssfk.modulo               1\r\n" in text
    assert "table[2].setpoint    3600000" in text
    with pytest.raises(CapacityError, match="endless"):
        written(turn, axis=axis)


def test_a_list_in_increments_stays_in_increments() -> None:
    own = ControlFile("a.lis", EVEN.replace("unit 1", "unit 0").encode())
    text = written(table("1", [0.0, 10.0], [0.001, 0.0]), own, encoder_increment=0.0005)["a.lis"]
    assert "unit 0" in text
    assert "interval 20000" in text
    assert "table[0].pos         -2\n" in text


def test_unit_and_room_of_an_empty_list_hold_for_what_is_written_into_it() -> None:
    own = ControlFile(
        "a.lis",
        b"kopf.achs_nr 1\nkw.ssfk.unit 0\nkw.ssfk.interval 0\nkw.ssfk.kw_nr_max 0\n"
        b"kw.ssfk.max_points 4\nkw.ssfk.bilateral 0\n",
    )
    short = table("1", [0.0, 10.0], [0.001, 0.0])
    with pytest.raises(UsageError, match="whose length is unknown"):
        written(short, own)
    text = written(short, own, encoder_increment=0.0005)["a.lis"]
    assert "table[1].setpoint    20000\n" in text
    assert "table[0].pos         -2\n" in text
    with pytest.raises(CapacityError, match="at most 3"):
        written(NEW, own, encoder_increment=0.0005)


counts = st.lists(st.integers(-5_000_000, 5_000_000), min_size=2, max_size=12, unique=True)


@settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
@given(places=counts, data=st.data(), values=st.sampled_from(["error", "correction"]))
def test_what_is_written_comes_back_new_or_in_the_own_list(
    places: list[int], data: st.DataObject, values: str
) -> None:
    number = st.integers(-30_000, 30_000)
    curve = st.lists(number, min_size=len(places), max_size=len(places))
    nodes = [place * 1e-4 for place in sorted(places)]
    up, down = ([one * 1e-4 for one in data.draw(curve)] for _ in range(2))
    made = table("1", nodes, up, down)
    control = control_format(DEFINITIONS[ISG], {"table_values": values})
    for own in ([], files(a=SAMPLE), files(a=EVEN)):
        new = control.write([made], [X], own)
        assert control.write([made], [X], own) == new
        back = control.read(new, [X]).axes["1"]
        judge = virtual_control(ISG, new, options={"table_values": values})
        for direction in Direction:
            wanted = made.at(np.array(nodes), direction)
            assert back.at(np.array(nodes), direction) == pytest.approx(wanted, abs=1e-9)
            found = judge.correction("1", np.array(nodes), direction)
            assert found == pytest.approx(wanted, abs=1e-9)


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_damaged_lists_are_refused_or_read_as_the_judge_reads_them(data: st.DataObject) -> None:
    parts = {"a": SAMPLE, "b": PLAY.replace("lose 50", "lose 0"), "c": SLAVE}
    name = data.draw(st.sampled_from(sorted(parts)))
    text = bytearray(parts[name].encode())
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(text) - 1))
        kind = data.draw(st.sampled_from(["byte", "cut", "double"]))
        if kind == "byte":
            text[place] = data.draw(st.sampled_from(b"0123456789.-+#*/[]= \t\nakwE\xe4"))
        elif kind == "cut":
            del text[place : place + data.draw(st.integers(1, 30))]
        else:
            text[place:place] = text[place : place + data.draw(st.integers(1, 60))]
        if not text:
            text = bytearray(b" ")
    given_files = [
        ControlFile(f"{key}.lis", bytes(text) if key == name else each.encode())
        for key, each in parts.items()
    ]
    options = {"cross_values": "error"}
    try:
        mine = control_format(DEFINITIONS[ISG], options).read(given_files)
        judge = virtual_control(ISG, given_files, options=options)
    except (InputError, UsageError):
        return
    where = np.array([-300.0, -120.0, 3.0, 70.0, 290.0, 400.0])
    for address in set(mine.axes) & set(judge.addresses()):
        for direction in Direction:
            found = judge.correction(address, where, direction)
            assert mine.axes[address].at(where, direction) == pytest.approx(found, abs=1e-9)


# --- a run


def test_a_run_patches_the_lists_that_were_given(tmp_path: Path) -> None:
    machine = Machine(low=-200, high=300)
    (tmp_path / "control").mkdir()
    given = files(kw=SAMPLE, mds=PLAY.replace("lose 50", "lose 0"))
    for file in given:
        (tmp_path / "control" / file.name).write_bytes(file.content)
    judge = virtual_control(ISG, given)
    readings = machine.measure(
        machine.targets(),
        1,
        lambda x, sign: judge.correction("1", x, Direction("+" if sign > 0 else "-")),
    )
    (tmp_path / "x.csv").write_text(csv_of(machine.targets(), readings))
    words = ["run", str(tmp_path / "x.csv"), "--format", ISG, "--axis", "X", "--travel", "-200:300"]
    words += ["--state", str(tmp_path / "control"), "--option", "address=1"]
    assert compwright([*words, "--out", str(tmp_path / "out")]) == 0
    made = tmp_path / "out" / "tables" / ISG
    assert sorted(path.name for path in made.iterdir()) == ["kw.lis", "mds.lis"]
    text = (tmp_path / "out" / "card" / "card.md").read_text(encoding="utf-8")
    for words_of_card in (
        "Check the sign before anything",
        "COMP OFF LEAD",
        "achs_kw_log_ax_nr",
        "lose",
    ):
        assert words_of_card in text
    assert "(not known)" not in text


@pytest.fixture(scope="module")
def bent(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bent")
    measure(folder, Bent())  # squareness +40 µm/m: Y has to follow X by +40 µm/m
    return folder


def squareness(
    folder: Path, bent: Path, states: str, control: str = ISG, options: str = "", second: str = "2"
) -> int:
    for file in bent.iterdir():
        (folder / file.name).write_bytes(file.read_bytes())
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {{{options}}}}}\n"
        f"states: {{as_found: {states}}}\naxes:\n"
        f'  X: {{travel: [0, 800], address: "{second[:-1]}1", before: [x.csv]}}\n'
        f'  Y: {{travel: [-500, 0], address: "{second}", before: []}}\n'
        "circles: [{file: xy.csv, name: xy-150, centre: [400, -250]}]\n"
        f"apply: {{squareness: {{XY: Y}}}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def cross_acting(folder: Path, values: str, *places: float) -> list[float]:
    made = [ControlFile(p.name, p.read_bytes()) for p in sorted(folder.iterdir())]
    judge = virtual_control(ISG, made, options={"cross_values": values})
    found = judge.cross_correction("1", "2", np.array(places), Direction.POSITIVE)
    return [float(value) * 1e3 for value in found]


@pytest.mark.parametrize("values", ["error", "correction"])
def test_squareness_goes_into_a_new_list_of_the_slave(
    values: str, bent: Path, tmp_path: Path
) -> None:
    assert squareness(tmp_path, bent, "none", options=f"cross_values: {values}") == 0
    made = tmp_path / "job" / "tables" / ISG
    assert (made / "achskw2.lis").read_text().count("].setpoint") == 2  # a straight line
    # 40 µm/m over 0.8 m, the end held
    assert cross_acting(made, values, 0, 400, 800, 900) == pytest.approx([0, 16, 32, 32], abs=0.8)


@pytest.mark.parametrize(("own", "first"), [("error", "-"), ("correction", "")])
def test_the_values_mean_what_the_slaves_own_option_says(
    own: str, first: str, bent: Path, tmp_path: Path
) -> None:
    """The bent axis says it for itself; that of the controller and of the master are others."""
    other = {"error": "correction", "correction": "error"}[own]
    assert squareness(tmp_path, bent, "none", options=f"cross_values: {other}") == 0
    text = (tmp_path / "job.yaml").read_text()
    (tmp_path / "job.yaml").write_text(
        text.replace(
            "before: [x.csv]", f"before: [x.csv], options: {{cross_values: {other}}}"
        ).replace("before: []", f"before: [], options: {{cross_values: {own}}}")
    )
    assert compwright(["run", str(tmp_path / "job.yaml"), "--force"]) == 0
    rows = (tmp_path / "job" / "tables" / ISG / "achskw2.lis").read_text().splitlines()
    (last,) = (row.split()[-1] for row in rows if "table[1].correction" in row)
    # Y follows X by 40 µm/m, 32 µm at 800 mm: 320 tenths, less what the fit of the circle misses
    assert last.startswith(first)
    assert abs(int(last)) == pytest.approx(320, abs=8)


def test_squareness_is_added_to_what_the_slaves_list_does(bent: Path, tmp_path: Path) -> None:
    (tmp_path / "y.lis").write_text(SLAVE + "other.key 5\n")
    (tmp_path / "x.lis").write_text(SAMPLE)
    options = "cross_values: correction"
    assert squareness(tmp_path, bent, "[x.lis, y.lis]", options=options) == 0
    made = tmp_path / "job" / "tables" / ISG
    assert (made / "y.lis").read_text().endswith("other.key 5\n")
    # before: 0 at -100, 2 at 0, -4 from 200 on (µm); added: 40 µm/m from 0 on
    found = cross_acting(made, "correction", -100, 0, 200, 800)
    assert found == pytest.approx([0, 2, 4, 28], abs=0.8)


def test_a_list_of_the_slave_that_was_not_read_back_is_named(
    bent: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its values name the slave alone."""
    assert squareness(tmp_path, bent, "none", options="cross_values: error") == 0
    made, plan = tmp_path / "job" / "tables" / ISG, str(tmp_path / "job" / "plan.json")
    for name in ("achskw1.lis", "achskw2.lis"):
        (tmp_path / name).write_bytes((made / name).read_bytes())
    words = ["compare", plan, "--loaded", str(tmp_path / "achskw1.lis")]
    capsys.readouterr()
    assert compwright(words) == 1
    shown = " ".join(capsys.readouterr().out.split())
    assert "Y over axis X was not read back completely: kw.crosscomp.unit and 6 more" in shown
    assert compwright([*words, "--loaded", str(tmp_path / "achskw2.lis")]) == 0
    (between,) = json.loads((tmp_path / "job" / "prediction.json").read_text())["cross"]
    assert "-0.0" not in map(str, between["correction"])


def test_squareness_without_the_meaning_of_the_values_is_asked_for(
    bent: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert squareness(tmp_path, bent, "none") == 2
    assert "cross_values" in capsys.readouterr().err
    assert not (tmp_path / "job").exists()


def test_a_slave_of_another_axis_is_not_changed(bent: Path, tmp_path: Path) -> None:
    (tmp_path / "y.lis").write_text(SLAVE.replace("master_ax_nr 1", "master_ax_nr 3"))
    (tmp_path / "x.lis").write_text(SAMPLE)
    assert squareness(tmp_path, bent, "[x.lis, y.lis]", options="cross_values: error") == 1
    assert "only one other axis" in (tmp_path / "job" / "card" / "card.md").read_text("utf-8")
    assert not (tmp_path / "job" / "tables" / ISG / "y.lis").exists()


def test_a_control_without_files_takes_squareness_beside_the_table_of_one_axis(
    bent: Path, tmp_path: Path
) -> None:
    options = "cec: available, cec_sign: correction, cec_tables: [0, 1, 2, 3]"
    control = "siemens-840d-sl"
    assert squareness(tmp_path, bent, "none", control, options, "AX2") == 0
