"""The virtual ISG kernel against worked numbers of its vendor's file form, and against damage.

Numbers in the lists count 0.1 µm: 10000 is 1 mm, and a value of 40 is 4 µm.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.controllers.virtual_control import VirtualControl, virtual_control
from compwright.foundations.errors import CompwrightError, InputError, UsageError
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE

# The worked file: listed setpoints, both directions.
LISTED = """# axis compensation data, X axis
kopf.achs_nr                      1
kopf.log_achs_name                X
kw.ssfk.unit                      1      # 0 encoder increments, 1 = 0.1 um (rotary 0.0001 deg)
kw.ssfk.interval                  0      # 0: setpoints listed; else spacing
kw.ssfk.kw_startpos               -2000000
kw.ssfk.kw_nr_max                 4
kw.ssfk.bilateral                 1
kw.ssfk.modulo                    0
kw.ssfk.table[0].setpoint         -2000000
kw.ssfk.table[0].pos              -40
kw.ssfk.table[0].neg              -25
kw.ssfk.table[1].setpoint         0
kw.ssfk.table[1].pos              0
kw.ssfk.table[1].neg              18
kw.ssfk.table[2].setpoint         1500000
kw.ssfk.table[2].pos              30
kw.ssfk.table[2].neg              42
kw.ssfk.table[3].setpoint         3000000
kw.ssfk.table[3].pos              84
kw.ssfk.table[3].neg              90
"""
AT = (-250, -100, 0, 75, 225, 310)  # mm
# Worked by hand for errors, so that the correction is minus the value; µm.
WORKED = {UP: (4.0, 2.0, 0.0, -1.5, -5.7, -8.4), DOWN: (2.5, 0.35, -1.8, -3.0, -6.6, -9.0)}

# Equal spacing in encoder increments, the shape of a public machine file: values before positions,
# an old key, remarks behind values; here with one column.
EVEN = """# ****************************************
:
#TC_AXIS_COMP_DESC:    Achskompensationsdaten X-Achse
kopf.achs_nr                          1
kopf.log_achs_name              X_ACHSE
kw.ssfk.interval                  20000
kw.ssfk.kw_startpos             -909000
kw.ssfk.kw_nr_max                     3
kw.ssfk.modulo                        0
kw.ssfk.res1                          0
kw.ssfk.unit                          0     /* 0:Increments 1:Metric */
kw.ssfk.bilateral                     0
kw.ssfk.table[0].pos                  0     /*   -90.9    */
kw.ssfk.table[1].pos                 90     /*   -88.9    */
kw.ssfk.table[ 2].pos               -30     /*   -86.9
                                                 two lines of remark */
"""
SWITCHES = "kopf.achs_nr 1\nlr_param.ssfk 1\ngetriebe[0].lose 0\nlr_param.anwahl_losekomp 0\n"

# Axis 2 is bent by axis 1: at 100 mm of axis 1 there are 10 µm.
CROSS = """kopf.achs_nr 2
kw.crosscomp.unit 1
kw.crosscomp.last_index 2
kw.crosscomp.master_ax_nr 1
kw.crosscomp.n_cycles 0
kw.crosscomp.table[0].setpoint 0
kw.crosscomp.table[0].correction 0
kw.crosscomp.table[1].setpoint 1000000
kw.crosscomp.table[1].correction 100
kw.crosscomp.table[2].setpoint 2000000
kw.crosscomp.table[2].correction -50
"""
TURN = """kopf.achs_nr 4
kw.ssfk.unit 1
kw.ssfk.interval 900000
kw.ssfk.kw_startpos 0
kw.ssfk.kw_nr_max 5
kw.ssfk.bilateral 0
kw.ssfk.modulo 1
kw.ssfk.table[0].pos 10
kw.ssfk.table[1].pos 30
kw.ssfk.table[2].pos -20
kw.ssfk.table[3].pos 40
kw.ssfk.table[4].pos 10
"""
LOST_MOTION = "kopf.achs_nr 1\ngetriebe[0].lose 120\nlr_param.anwahl_losekomp 1\n"

# mm: rounding of doubles at 300 mm and below.
ROUNDING = 1e-12


def isg(*texts: str, **request: object) -> VirtualControl:
    files = [
        ControlFile(f"achskw{i}.lis", text.encode("latin-1")) for i, text in enumerate(texts, 1)
    ]
    # # keywords pass through
    return virtual_control("isg-kernel", files, **request)  # type: ignore[arg-type]


def um(
    control: VirtualControl, positions: Sequence[float], direction: Direction, address: str = "1"
) -> list[float]:
    at = np.array(positions, dtype=float)
    return [float(value) * 1e3 for value in control.correction(address, at, direction)]


def close(numbers: Sequence[float]) -> object:
    """Equal in µm but for the rounding of doubles."""
    return pytest.approx(list(numbers), abs=ROUNDING * 1e3)


def one_column(text: str) -> str:
    lines = text.replace("bilateral                 1", "bilateral 0").split("\n")
    return "\n".join(line for line in lines if ".neg" not in line)


class TestTable:
    @pytest.mark.parametrize("direction", [UP, DOWN])
    def test_worked_file(self, direction: Direction) -> None:
        control = isg(LISTED)
        assert um(control, AT, direction) == close(WORKED[direction])
        assert control.addresses() == ("1",)
        assert control.points("1").tolist() == pytest.approx([-200, 0, 150, 300], abs=ROUNDING)
        assert control.cross() == ()

    def test_the_option_turns_the_sign(self) -> None:
        control = isg(LISTED, options={"table_values": "correction"})
        assert um(control, AT, DOWN) == close([-value for value in WORKED[DOWN]])
        own = isg(LISTED, axis_options={"1": {"table_values": "correction"}})
        assert um(own, AT, UP) == close([-value for value in WORKED[UP]])
        assert ("table_values of axis 1", "correction", "option") in [
            (one.fact, one.value, one.evidence) for one in control.assumed
        ]
        default = next(one for one in isg(LISTED).assumed if "table_values" in one.fact)
        assert default.value == "error"
        assert default.evidence.startswith("inferred")
        with pytest.raises(UsageError, match="option table_values"):
            isg(LISTED, options={"table_values": "plus"})

    def test_measured_error_written_unchanged_is_removed(self) -> None:
        # the axis stands 3 µm too far at 150 mm going +, the list holds 30
        assert um(isg(LISTED), [150], UP) == close([-3.0])

    def test_equal_spacing_in_encoder_increments(self) -> None:
        # 10000 increments per mm as the remarks say: -90.9, -88.9, -86.9 mm; 90 increments are 9 µm
        control = isg(EVEN, options={"encoder_increment": 1e-4})
        assert control.points("1").tolist() == pytest.approx([-90.9, -88.9, -86.9], abs=ROUNDING)
        for direction in (UP, DOWN):
            got = um(control, [-100, -90.9, -89.9, -88.9, -87.9, -86.9, 0], direction)
            assert got == close([0, 0, -4.5, -9, -3, 3, 3])
        finer = isg(EVEN, axis_options={"1": {"encoder_increment": "0.00005"}})
        assert um(finer, [-44.45], UP) == close([-4.5])

    def test_encoder_increments_need_their_size(self) -> None:
        with pytest.raises(UsageError, match=r"encoder_increment of axis 1 .*\(kw\.ssfk\.unit 0\)"):
            isg(EVEN)
        with pytest.raises(InputError, match="kw_startpos; expected -2147483647 to 2147483647"):
            isg(EVEN.replace("-909000", "-1e308"), options={"encoder_increment": 1e-4})
        for wrong in (0, -1, "x", True, float("nan")):
            with pytest.raises(UsageError, match="encoder_increment"):
                isg(EVEN, options={"encoder_increment": wrong})
        # of another axis than the one under work it is not asked for
        assert isg(EVEN, axes_under_work=("2",)).addresses() == ()

    def test_order_of_statements_blanks_and_line_ends_mean_nothing(self) -> None:
        lines = LISTED.strip().split("\n")
        loose = [line.replace("[", "[ ").replace("]", " ]").replace("   ", "\t") for line in lines]
        for text in (
            "\n".join(reversed(lines)),
            "\r\n".join(loose),
            "\r".join(lines),
            "\xef\xbb\xbf" + LISTED,
            LISTED.upper(),
            LISTED.replace("kopf.achs_nr ", "kopf.log_achs_nr "),
            LISTED.replace("[0]", "[00]"),
            LISTED + "kw.ssfk.table[3].neg 90.0\n",
        ):
            assert um(isg(text), AT, DOWN) == close(WORKED[DOWN])

    def test_one_column_serves_both_directions(self) -> None:
        assert um(isg(one_column(LISTED)), AT, DOWN) == close(WORKED[UP])
        with pytest.raises(InputError, match="bilateral is 0, and neg of entry 0 differs"):
            isg(LISTED.replace("bilateral                 1", "bilateral 0"))

    def test_fractions_and_number_types(self) -> None:
        text = LISTED.replace("pos              84", "pos 84.5")
        assert um(isg(text), [300], UP) == close([-8.45])
        assert um(isg(text, options={"value_type": "real64"}), [300], UP) == close([-8.45])
        with pytest.raises(InputError, match=r"line 20: sgn32 holds whole numbers"):
            isg(text, options={"value_type": "sgn32"})
        large = LISTED.replace("pos              84", "pos 32768")
        assert um(isg(large), [300], UP) == close([-3276.8])
        with pytest.raises(
            InputError, match=r"line 20: the value is larger .* at most 32767, found '32768'"
        ):
            isg(large, options={"value_type": "sgn16"})
        with pytest.raises(InputError, match="at most 2147483647"):
            isg(LISTED.replace("pos              84", "pos 2147483648"))
        with pytest.raises(UsageError, match="option value_type"):
            isg(LISTED, options={"value_type": "int"})

    def test_a_list_without_entries_is_no_table(self) -> None:
        for text in (
            "kopf.achs_nr 3\nkw.ssfk.max_points 1\n",
            "kopf.achs_nr 3\nkw.ssfk.kw_nr_max 0",
        ):
            control = isg(text)
            assert control.points("3").size == 0
            assert um(control, [5], DOWN, "3") == [0.0]

    def test_any_shape(self) -> None:
        grid = np.linspace(-300, 400, 12).reshape(3, 4)
        assert isg(LISTED, LOST_MOTION.replace("120", "0")).correction("1", grid, UP).shape == (
            3,
            4,
        )
        assert isg(LISTED).correction("1", np.array(5.0), UP).shape == ()


class TestModulo:
    def test_it_wraps(self) -> None:
        control = isg(TURN, modulo={"4": 360.0})
        # -45 is 315: half way from 40 to 10; 405 is 45: half way from 10 to 30; counted in 0.0001
        # deg, here in 0.001
        wanted = [-2.5, -1.0, -2.0, -2.0, -1.0]
        assert um(control, [-45, 0, 45, 405, 720], UP, "4") == close(wanted)
        # the same values a quarter turn earlier: 45 is half way from 30 to -20
        early = isg(TURN.replace("kw_startpos 0", "kw_startpos -900000"))
        assert um(early, [-135, -90, 45, 225, 315], UP, "4") == close([-2.5, -1, -0.5, -2.5, -2])

    def test_without_modulo_the_ends_hold(self) -> None:
        for text in (TURN.replace("modulo 1", "modulo 0"), TURN.replace("kw.ssfk.modulo 1\n", "")):
            held = isg(text.replace("[4].pos 10", "[4].pos 50"))
            assert um(held, [-45, 405], UP, "4") == close([-1.0, -5.0])

    def test_contradictions(self) -> None:
        with pytest.raises(InputError, match="last entry differs from the first"):
            isg(TURN.replace("[4].pos 10", "[4].pos 11"))
        with pytest.raises(InputError, match="spans 360; expected one turn, 180"):
            isg(TURN, modulo={"4": 180.0})
        one = "".join(f"{line}\n" for line in TURN.split("\n") if "].pos" not in line)
        with pytest.raises(InputError, match="one entry is not enough"):
            isg(one.replace("nr_max 5", "nr_max 1") + "kw.ssfk.table[0].pos 1\n")


class TestSwitches:
    def test_what_the_files_say(self) -> None:
        off = SWITCHES.replace("ssfk 1", "ssfk 0")
        assert um(isg(LISTED, SWITCHES), AT, UP) == close(WORKED[UP])
        assert um(isg(LISTED, off), AT, UP) == close([0] * 6)
        assert isg(LISTED, off).points("1").size == 4
        assert um(isg(LISTED, off, active=True), AT, UP) == close(WORKED[UP])

    def test_what_they_do_not_say(self) -> None:
        assumed = [(one.fact, one.value) for one in isg(LISTED).assumed]
        assert ("lr_param.ssfk of axis 1", "1") in assumed
        assert ("getriebe[0].lose of axis 1", "0") in assumed
        silent = [one.fact for one in isg(LISTED, SWITCHES).assumed]
        assert silent == ["table_values of axis 1"]
        assert um(isg(LISTED, active=False), AT, UP) == close([0] * 6)

    def test_manual_activation_waits_for_an_nc_program(self) -> None:
        text = LISTED + "kw.ssfk.manual_activation 1\n"
        assert um(isg(text, SWITCHES), AT, UP) == close([0] * 6)
        assert um(isg(text, SWITCHES, active=True), AT, UP) == close(WORKED[UP])
        assert any("NC program" in one.evidence for one in isg(text, SWITCHES).assumed)
        never = LISTED + "kw.ssfk.manual_activation 0\n"
        assert um(isg(never, SWITCHES), AT, UP) == close(WORKED[UP])


class TestBacklash:
    @pytest.mark.parametrize(("home", "up", "down"), [(UP, 0.0, -12.0), (DOWN, 12.0, 0.0)])
    @pytest.mark.parametrize("choice", ["1", "2"])
    def test_acts_against_the_referencing_direction(
        self, home: Direction, up: float, down: float, choice: str
    ) -> None:
        text = LOST_MOTION.replace("komp 1", f"komp {choice}")
        control = isg(text, reference_return={"1": home})
        assert um(control, [-7], UP) == close([up])
        assert um(control, [300], DOWN) == close([down])
        assert control.points("1").size == 0

    def test_value_of_a_machine_with_lost_motion_removes_it(self) -> None:
        # lost motion of 12 µm: arriving towards - the table stands 12 µm too high
        control = isg(LOST_MOTION)
        assert um(control, [0], DOWN)[0] + 12.0 == pytest.approx(um(control, [0], UP)[0], abs=1e-9)
        assert any("sense of getriebe[0].lose" in one.fact for one in control.assumed)

    def test_beside_a_table_with_one_column(self) -> None:
        got = um(isg(one_column(LISTED), LOST_MOTION), AT, DOWN)
        assert got == close([value - 12.0 for value in WORKED[UP]])

    def test_refused(self) -> None:
        with pytest.raises(
            InputError, match=r"line 2: getriebe\[0\]\.lose .* in addition to a table with"
        ):
            isg(LISTED, LOST_MOTION)
        off = LOST_MOTION.replace("komp 1", "komp 0")
        assert um(isg(LISTED, off), AT, DOWN) == close(WORKED[DOWN])
        assert um(isg(LISTED, LOST_MOTION, active=False), [0], DOWN) == close([-12.0])
        with pytest.raises(InputError, match="the direction of a negative one is unknown"):
            isg(LOST_MOTION.replace("120", "-120"))
        assert um(isg(off.replace("120", "-120")), [0], DOWN) == [0.0]
        for wrong in ("32768", "1.5", "x"):
            with pytest.raises(InputError, match=r"line 2: getriebe\[0\]\.lose"):
                isg(LOST_MOTION.replace("120", wrong))
        with pytest.raises(InputError, match="0, 1 or 2"):
            isg(LOST_MOTION.replace("komp 1", "komp 3"))
        with pytest.raises(InputError, match="the active gear"):
            isg(LOST_MOTION + "getriebe[1].lose 50\n")
        assert um(isg(LOST_MOTION + "getriebe[1].lose 120\n"), [0], DOWN) == close([-12.0])

    def test_half_of_it_is_not_an_answer(self) -> None:
        with pytest.raises(InputError, match=r"expected a line lr_param\.anwahl_losekomp"):
            isg("kopf.achs_nr 1\ngetriebe[0].lose 120\n")
        with pytest.raises(InputError, match=r"expected a line getriebe\[0\]\.lose"):
            isg("kopf.achs_nr 1\nlr_param.anwahl_losekomp 1\n")


class TestCross:
    @pytest.mark.parametrize(("said", "sign"), [("correction", 1.0), ("error", -1.0)])
    def test_slaves_list(self, said: str, sign: float) -> None:
        control = isg(CROSS, options={"cross_values": said})
        assert control.cross() == (("1", "2"),)
        at = np.array([-50, 0, 50, 100, 150, 200, 900.0])
        for direction in (UP, DOWN):
            got = control.cross_correction("1", "2", at, direction) * 1e3 * sign
            assert got.tolist() == close([0, 0, 5, 10, 2.5, -5, -5])
        assert control.addresses() == ("2",)
        assert um(control, [5], UP, "2") == [0.0]
        assert any(one.fact.startswith("outside the cross") for one in control.assumed)

    def test_the_sign_is_never_assumed(self) -> None:
        control = isg(CROSS)
        assert control.cross() == ()
        assert any("option cross_values" in note for note in control.notes)
        with pytest.raises(
            UsageError,
            match=r"no table that corrects axis 2 over the position of axis 1.*cross_values",
        ):
            control.cross_correction("1", "2", np.zeros(1), UP)
        with pytest.raises(UsageError, match="option cross_values"):
            isg(CROSS, options={"cross_values": "yes"})

    def test_the_leadscrew_option_does_not_turn_it(self) -> None:
        control = isg(CROSS, options={"cross_values": "error", "table_values": "correction"})
        got = control.cross_correction("1", "2", np.array([100.0]), UP) * 1e3
        assert got.tolist() == close([-10])

    def test_increments_count_in_each_axis_own(self) -> None:
        text = CROSS.replace("unit 1", "unit 0")
        sizes: dict[str, dict[str, object]] = {
            "1": {"encoder_increment": 1e-3},
            "2": {"encoder_increment": 2e-3},
        }
        options = {"cross_values": "correction"}
        control = isg(text, options=options, axis_options=sizes)
        got = control.cross_correction("1", "2", np.array([500.0, 1000.0]), UP)
        assert got.tolist() == pytest.approx([0.1, 0.2], abs=ROUNDING)
        with pytest.raises(UsageError, match="encoder_increment of axis 1"):
            isg(text, options=options, axis_options={"2": sizes["2"]})

    def test_switched_off_or_zero(self) -> None:
        off = isg(CROSS + "lr_param.crosscomp 0\n", options={"cross_values": "error"})
        assert off.cross() == ()
        assert any("does not act" in note for note in off.notes)
        zero = CROSS.replace("correction 100", "correction 0").replace("-50", "0")
        assert isg(zero, options={"cross_values": "error"}).cross() == ()

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("master_ax_nr 1", "master_ax_nr 2", "the axis corrects itself"),
            ("master_ax_nr 1", "master_ax_nr 0", r"expected a line kw\.crosscomp\.master_ax_nr"),
            ("master_ax_nr 1", "slave_ax_nr 1", r"line 4: kw\.crosscomp\.slave_ax_nr .* not known"),
            ("last_index 2", "last_index 1", "line 10: entry 2 is beyond the last"),
            ("last_index 2", "last_index 3", "1 of 4 are missing"),
            ("last_index 2", "last_index 1001", "more entries than there is room for"),
            ("kw.crosscomp.last_index 2\n", "", r"expected a line kw\.crosscomp\.last_index"),
            ("setpoint 2000000", "setpoint 900000", "line 10: setpoint 2 does not ascend"),
            ("kw.crosscomp.unit 1\n", "", r"expected a line kw\.crosscomp\.unit"),
            ("kw.crosscomp.table[1].setpoint 1000000\n", "", r"table\[1\]\.setpoint"),
        ],
    )
    def test_contradictions(self, old: str, new: str, says: str) -> None:
        text = CROSS.replace(old, new)
        assert text != CROSS
        with pytest.raises(InputError, match=says):
            isg(text, options={"cross_values": "error"})

    def test_planes_are_refused_by_name(self) -> None:
        plane = "kopf.achs_nr 2\nkw.crosscomp2.unit 1\nkw.crosscomp2.interval 1000000\n"
        acting = plane + "kw.crosscomp2.table[ 0][ 1].correction 7\n"
        with pytest.raises(InputError, match=r"line 4: kw\.crosscomp2 corrects axis 2"):
            isg(acting)
        with pytest.raises(InputError, match=r"kw\.crosscomp2 corrects axis 2"):
            isg(plane)
        for harmless in (
            acting + "lr_param.crosscomp2 0\n",
            acting.replace("correction 7", "correction 0"),
            "kopf.achs_nr 2\nkw.crosscomp2.max_points 1\n",
        ):
            assert um(isg(harmless), [0], UP, "2") == [0.0]
        other = isg(acting, LISTED, axes_under_work=("1",))
        assert other.addresses() == ("1",)
        assert any("crosscomp2" in note for note in other.notes)


class TestLists:
    def test_several_axes(self) -> None:
        second = LISTED.replace("achs_nr                      1", "achs_nr 12").replace("84", "85")
        control = isg(LISTED, second, SWITCHES)
        assert control.addresses() == ("1", "12")
        assert um(control, [310], UP, "12") == close([-8.5])
        assert um(control, [310], UP) == close([-8.4])
        with pytest.raises(UsageError, match="no data of axis 2"):
            control.correction("2", np.zeros(1), UP)

    def test_start_up_list(self) -> None:
        start = "zahl_kw 1\nzahl_mds 4\nachs_kw_log_ax_nr[0] 1\nachs_kw[0] tc\\ACHSKW2.lis\n"
        assert um(isg(start, LISTED), AT, UP) == close(WORKED[UP])
        bare = LISTED.replace("kopf.achs_nr                      1\n", "")
        assert um(isg(start, bare), AT, UP) == close(WORKED[UP])
        with pytest.raises(
            InputError,
            match=r"line 2: the start-up list gives two axes to one list; expected 4 as the s",
        ):
            isg(start.replace("nr[0] 1", "nr[0] 4"), LISTED)
        spare = isg(start, LISTED, LISTED.replace("nr                      1", "nr 2"))
        assert spare.addresses() == ("1",)
        assert any("does not name this list" in note for note in spare.notes)
        with pytest.raises(InputError, match=r"expected a line achs_kw_log_ax_nr\[0\]"):
            isg(start.replace("nr[0]", "nr[1]"), LISTED)
        # zahl_kw counts the lists from 0 on: with 1 of them there is no list 1.
        with pytest.raises(
            InputError,
            match="the start-up list has more lists than its number zahl_kw states; expected zahl_kw 2",
        ):
            isg(start.replace("[0]", "[1]"), LISTED)

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("kopf.achs_nr                      1", "", "does not show to which axis"),
            ("kopf.achs_nr                      1", "kopf.achs_nr X", "a logical axis number"),
            (
                "kopf.log_achs_name                X",
                "kopf.log_achs_nr 2",
                "gives two axes to one list",
            ),
            ("kw.ssfk.unit                      1", "kw.ssfk.unit 2", "0 or 1"),
            ("kw.ssfk.unit                      1", "", r"expected a line kw\.ssfk\.unit"),
            ("kw.ssfk.unit                      1", "kw.ssfk.unit = 1", "line 4: .*a number"),
            (
                "kw.ssfk.unit                      1",
                "kw.ssfk.unit=1",
                "line 4: the line contains no statement",
            ),
            (
                "kw.ssfk.unit                      1",
                "kw.ssfk.unit",
                "line 4: the line contains no statement",
            ),
            ("kw.ssfk.interval                  0", "", r"expected a line kw\.ssfk\.interval"),
            ("kw.ssfk.interval                  0", "kw.ssfk.interval -5", "0 to 2147483647"),
            ("kw.ssfk.interval                  0", "kw.ssfk.interval 1e308", "0 to 2147"),
            (
                "kw.ssfk.interval                  0",
                "kw.ssfk.interval 1500000",
                "line 13: a setpoint is not at its equally spaced place; expected -500000, found '0'",
            ),
            (
                "kw_startpos               -2000000",
                "kw_startpos -1999999",
                "line 6: two lines state different starts of the table; expected -2000000",
            ),
            ("kw_nr_max                 4", "kw_nr_max 5", "1 of 5 entries are missing"),
            ("kw_nr_max                 4", "kw_nr_max 3", "line 19: entry 3 is beyond the last"),
            ("kw_nr_max                 4", "kw_nr_max 0", "but contains some"),
            ("kw_nr_max                 4", "kw_nr_max 1500", "less than 1500 .the default"),
            ("kw_nr_max                 4", "kw_nr_max 2000000000", "less than 1500"),
            ("kw_nr_max                 4", "kw_nr_max 4.5", "a whole number"),
            ("kw.ssfk.kw_nr_max                 4", "", r"expected a line kw\.ssfk\.kw_nr_max"),
            ("kw.ssfk.bilateral                 1", "", r"expected a line kw\.ssfk\.bilateral"),
            ("kw.ssfk.table[2].neg              42", "", r"expected a line kw\.ssfk\.table\[2\]"),
            ("kw.ssfk.table[2].pos              30", "", "1 of 4 entries are missing"),
            ("setpoint         1500000", "setpoint -1500000", "line 16: setpoint 2 does not asc"),
            ("setpoint         1500000", "setpoint 0", "setpoint 2 does not ascend"),
            ("table[2].pos              30", "table[2].pos 3O", "line 17: .*a number, found '3O'"),
            ("table[2].pos              30", "table[2].pos 1e999", "line 17: .*a number"),
            (
                "table[2].pos              30",
                "table[2.pos 30",
                "line 17: the line contains no statement",
            ),
            ("kw.ssfk.modulo                    0", "kw.ssfk.twist 3", "twist .* not known"),
            ("kw.ssfk.modulo                    0", "kw.temp.offset 3", "temp.* not known"),
            ("# axis compensation", "/* axis compensation", "line 1: the comment"),
        ],
    )
    def test_faults_by_line(self, old: str, new: str, says: str) -> None:
        text = LISTED.replace(old, new)
        assert text != LISTED
        with pytest.raises(InputError, match=says) as caught:
            isg(text)
        assert all("achskw1.lis" in str(fault) for fault in caught.value.faults)

    def test_lines_count_on_through_a_remark_of_two(self) -> None:
        with pytest.raises(InputError, match="line 17: the line contains no statement"):
            isg(EVEN + "kw.ssfk.modulo=1\n", options={"encoder_increment": 1e-4})

    def test_more_room_has_to_be_said(self) -> None:
        head = one_column(LISTED).split("kw.ssfk.table")[0]
        head = head.replace("interval                  0", "interval 10")
        long = head.replace("kw_nr_max                 4", "kw_nr_max 1500")
        long += "".join(f"kw.ssfk.table[{i}].pos {i % 7}\n" for i in range(1500))
        with pytest.raises(InputError, match="less than 1500"):
            isg(long)
        assert isg(long + "kw.ssfk.max_points 1501\n").points("1").size == 1500
        with pytest.raises(InputError, match=r"less than 1500 .max_points"):
            isg(long + "kw.ssfk.max_points 1500\n")
        with pytest.raises(InputError, match=r"less than 1500 .the default"):
            isg(long + "kw.ssfk.max_points 0\n")
        many = long.replace("kw_nr_max 1500", "kw_nr_max 2000000000")
        with pytest.raises(InputError, match="of 2000000000 entries are missing"):
            isg(many + "kw.ssfk.max_points 2147483647\n")

    def test_twice_is_once_or_a_contradiction(self) -> None:
        with pytest.raises(InputError, match=r"line 2: kw\.ssfk\.table\[3\]\.neg .* twice"):
            isg(LISTED, "kopf.achs_nr 1\nkw.ssfk.table[3].neg 91\n")

    def test_all_faults_at_once(self) -> None:
        text = LISTED.replace("pos              30", "pos x").replace(
            "pos              84", "pos y"
        )
        with pytest.raises(InputError) as caught:
            isg(text)
        assert len(caught.value.faults) == 2

    def test_what_is_odd_about_others_stops_nothing(self) -> None:
        broken = LISTED.replace("achs_nr                      1", "achs_nr 2").replace("42", "x")
        control = isg(LISTED, broken, axes_under_work=("1",))
        assert control.addresses() == ("1",)
        assert any("table[2].neg" in note for note in control.notes)

    def test_unknown_lines_are_left_alone(self) -> None:
        extra = (
            "kenngr.hub_messtaster 20000\n...\nlr_param.n_backlash_cyc 5\nkenngr.hub_messtaster 3\n"
        )
        assert um(isg(LISTED + extra), AT, UP) == close(WORKED[UP])

    def test_binary(self) -> None:
        with pytest.raises(InputError, match="NUL"):
            isg(LISTED.replace("X", "\x00"))


def ask_everything(content: bytes) -> None:
    """Load and ask; only compwright's own errors may come out, and no number that is none."""
    options = {"encoder_increment": 1e-4, "cross_values": "error"}
    try:
        control = virtual_control("isg-kernel", [ControlFile("a.lis", content)], options=options)
    except CompwrightError:
        return
    for address in control.addresses():
        for direction in Direction:
            got = control.correction(address, np.linspace(-1e3, 1e3, 7), direction)
            assert got.shape == (7,)
            assert np.all(np.isfinite(got))
        assert np.all(np.diff(control.points(address)) > 0)


class TestDamage:
    @settings(max_examples=60, deadline=None)
    @given(
        st.sampled_from([LISTED, EVEN, CROSS, TURN, LOST_MOTION]),
        st.lists(
            st.tuples(
                st.floats(0, 1),
                st.integers(0, 3),
                st.one_of(
                    st.sampled_from([b"", b"9", b"-", b".", b"e9", b"\n", b"/*", b"[1]", b"1e300"]),
                    st.binary(min_size=1, max_size=3),
                ),
            ),
            min_size=1,
            max_size=4,
        ),
    )
    def test_damaged_files(self, text: str, damage: list[tuple[float, int, bytes]]) -> None:
        content = bytearray(text.encode())
        for place, length, new in damage:
            at = int(place * (len(content) - 1))
            content[at : at + length] = new
        ask_everything(bytes(content))

    @settings(max_examples=50, deadline=None)
    @given(st.binary(max_size=200))
    def test_anything(self, content: bytes) -> None:
        ask_everything(content)

    @pytest.mark.parametrize("text", [LISTED, EVEN, CROSS])
    def test_cut_anywhere(self, text: str) -> None:
        for end in range(0, len(text), 11):
            ask_everything(text[:end].encode())
