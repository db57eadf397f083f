"""The SINUMERIK judge: the archive in its container, small files over it, units, steps that do not
divide, what is said of the axes; against numbers worked by hand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import pytest

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.control import SinumerikControl, sinumerik_control
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
#: mm or deg; rounding of doubles in sums of values of a few µm
EXACT = 1e-15
ACTIVE = "\\_NC_ACT.DIR\\"


def header(name: str, size: int, folder: str = ACTIVE, kind: str = "7") -> bytes:
    """Return the 512 bytes before a member: fields at fixed places, the check sum over all."""
    fields = {0: f"_N_{name.replace('.', '_')}", 50: name, 108: kind, 116: "040703"}
    fields |= {124: str(size), 136: "1476518605", 257: "/", 384: folder}
    block = bytearray(512)
    for place, text in fields.items():
        block[place : place + len(text)] = text.encode("ascii")
    told = str(sum(block)).encode("ascii")
    block[148 : 148 + len(told)] = told
    return bytes(block)


def member(name: str, text: str, folder: str = ACTIVE, kind: str = "7") -> bytes:
    content = text.encode("latin-1")
    return header(name, len(content), folder, kind) + content + b"\x00" * (-len(content) % 512)


def container(*members: bytes, also: str = "") -> bytes:
    """Return an archive; ``also``: a path that its list of contents holds beside the members."""
    paths = [
        (one[384:512].rstrip(b"\x00") + one[50:100].rstrip(b"\x00")).decode("ascii")
        for one in members
    ]
    contents = "\n".join([";---components---", *paths, also]).encode("ascii")
    first = bytearray(header("", len(contents), ""))
    first[0:16] = b"@@MMCIBN.002".ljust(16, b"\x00")
    first[148:156] = bytes(8)
    first[148:156] = str(sum(first)).encode("ascii").ljust(8, b"\x00")
    return bytes(first) + contents + b"\x00" * (-len(contents) % 512) + b"".join(members)


EEC = """
METRIC

CHANDATA(1)
$AA_ENC_COMP[1,0,AX1]=0.001
$AA_ENC_COMP[1,1,AX1]=0.003
$AA_ENC_COMP[1,2,AX1]=-0.002
$AA_ENC_COMP_STEP[1,AX1]=100
$AA_ENC_COMP_MIN[1,AX1]=-200
$AA_ENC_COMP_MAX[1,AX1]=0
$AA_ENC_COMP_IS_MODULO[1,AX1]=0
M17
"""
INITIAL = """
METRIC

CHANDATA(1)
N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]="X1"
N30200 $MA_NUM_ENCS[AX1]=2
N30300 $MA_IS_ROT_AX[AX1]=0
N32450 $MA_BACKLASH[1,AX1]=0.004
N32700 $MA_ENC_COMP_ENABLE[1,AX1]=1
M17
"""
WHOLE = container(
    member("@@_N_IBN_SS", "", kind="0"),
    member("AX_EEC.INI", EEC),
    member("INITIAL.INI", INITIAL),
    member(
        "LOAD.MPF", "$AA_ENC_COMP[1,0,AX1]=0.7\r\n$MA_BACKLASH[1,AX1]=9 \xe4\r\nM30", "\\MPF.DIR\\"
    ),
)


def load(
    *files: bytes | str, options: Mapping[str, object] | None = None, **request: object
) -> SinumerikControl:
    given = [
        ControlFile(f"f{number}", file if isinstance(file, bytes) else file.encode("latin-1"))
        for number, file in enumerate(files)
    ]
    return sinumerik_control(given, Request(options=dict(options or {}), **request))  # type: ignore[arg-type]


def at(control: SinumerikControl, axis: str, positions: Sequence[float], way: Direction) -> object:
    return pytest.approx(control.correction(axis, np.array(positions), way).tolist(), abs=EXACT)


class TestContainer:
    def test_the_active_members_are_the_state_and_programs_are_not(self) -> None:
        control = load(WHOLE)
        # minus the value: -1, -3, +2 um; between -150: -2; below MIN -1; above MAX +2
        assert at(control, "X1", [-300, -200, -150, -100, 0, 50], UP) == [
            -0.001,
            -0.001,
            -0.002,
            -0.003,
            0.002,
            0.002,
        ]
        assert at(control, "AX1", [-200, 0], DOWN) == [-0.005, -0.002]

    def test_where_a_fault_stands(self) -> None:
        bad = container(member("AX_EEC.INI", EEC.replace("[1,1,AX1]=0.003", "[1,1,AX1]=0,003")))
        with pytest.raises(InputError, match=r"f0: AX_EEC\.INI: line 6.*cannot be read"):
            load(bad)

    def test_the_same_member_twice_is_once_and_two_that_differ_are_refused(self) -> None:
        once = member("AX_EEC.INI", EEC)
        assert at(load(container(once, once)), "AX1", [-200], UP) == [-0.001]
        with pytest.raises(InputError, match=r"two different members \(files\) AX_EEC\.INI"):
            load(container(once, member("AX_EEC.INI", EEC.replace("0.003", "0.004"))))
        # the same name in a folder of programs is another file
        other = member("AX_EEC.INI", EEC.replace("0.003", "0.004"), "\\WKS.DIR\\A.WPD\\")
        assert at(load(container(once, other)), "AX1", [-100], UP) == [-0.003]

    def test_a_member_that_is_longer_than_it_says(self) -> None:
        content = EEC.encode() + b";.."
        longer = header("AX_EEC.INI", len(EEC)) + content + b"\x00" * (-len(EEC) % 512)
        with pytest.raises(
            InputError, match=r"damaged.*the member AX_EEC\.INI .*does not have the size"
        ):
            load(container(longer, member("INITIAL.INI", INITIAL)))

    def test_an_archive_that_is_cut_short(self) -> None:
        with pytest.raises(InputError, match=r"cut off.* LOAD\.MPF.*bytes"):
            load(WHOLE[:-500])
        with pytest.raises(InputError, match="is damaged"):
            load(WHOLE[:-700])

    def test_an_archive_without_compensation(self) -> None:
        with pytest.raises(InputError, match="no compensation data"):
            load(container(member("NC.OPT", "CHANDATA(1)\nM17\n")))

    def test_a_member_of_its_list_that_is_not_there(self) -> None:
        whole = container(member("AX_EEC.INI", EEC), also=ACTIVE + "INITIAL.INI")
        with pytest.raises(InputError, match=r"cut off: its table of contents names INITIAL\.INI"):
            load(whole)

    def test_the_first_bytes_of_it_are_refused_or_hold_all_that_acts(self) -> None:
        x = np.array([-200.0, -100.0, 0.0])
        whole = load(WHOLE).correction("X1", x, DOWN).tolist()
        refused = 0
        for end in range(1, len(WHOLE), 61):
            try:
                assert load(WHOLE[:end]).correction("X1", x, DOWN).tolist() == whole
            except InputError:
                refused += 1
        assert refused > 50


class TestSmallFilesOverAnArchive:
    SMALL = """CHANDATA(1)
$AA_ENC_COMP[1,0,AX1]=0.010
$AA_ENC_COMP[1,1,AX1]=0.020
$AA_ENC_COMP_STEP[1,AX1]=200
$MA_BACKLASH[1,AX1]=0.001
M17
"""

    def test_what_they_name_goes_over_the_archive_whatever_the_order(self) -> None:
        # MIN and MAX stay: points at -200 and 0; the third point of the archive is not used
        for files in ((WHOLE, self.SMALL), (self.SMALL, WHOLE)):
            control = load(*files)
            assert at(control, "X1", [-200, -100, 0], UP) == [-0.01, -0.015, -0.02]
            assert at(control, "X1", [-200, 0], DOWN) == [-0.011, -0.021]
            assert control.points("X1").tolist() == [-200, 0]

    def test_by_their_own_name_of_the_axis(self) -> None:
        assert at(load(WHOLE, self.SMALL.replace("AX1", "x1")), "X1", [-200], DOWN) == [-0.011]

    def test_two_small_files_that_contradict_each_other_are_refused(self) -> None:
        with pytest.raises(InputError, match=r"contradicts f1, line 2"):
            load(WHOLE, self.SMALL, self.SMALL.replace("0.010", "0.011"))

    def test_a_longer_table_needs_all_its_points(self) -> None:
        with pytest.raises(InputError, match="missing points"):
            load(WHOLE, "$AA_ENC_COMP_MAX[1,AX1]=100\n")

    def test_a_switch_in_a_small_file_is_the_last_word(self) -> None:
        for off in ("FALSE", "0.0", "0EX0", "'H0'", "'b0'"):
            control = load(f"$MA_ENC_COMP_ENABLE[1,AX1]={off}\n", WHOLE)
            assert at(control, "X1", [-200], UP) == [0.0]


class TestInch:
    TABLE = EEC.replace("METRIC", "INCH").replace("=100\n", "=10\n").replace("=-200", "=-20")

    def test_positions_values_and_backlash_of_a_linear_axis(self) -> None:
        # 10 inch = 254 mm; 0.001 inch = 25.4 um; 0.004 inch = 101.6 um
        control = load(self.TABLE, INITIAL.replace("METRIC", "INCH"))
        assert at(control, "X1", [-508, -254, 0], UP) == [-0.0254, -0.0762, 0.0508]
        assert at(control, "X1", [-508], DOWN) == [-0.0254 - 0.1016]
        assert control.points("X1").tolist() == pytest.approx([-508, -254, 0], abs=1e-9)

    @pytest.mark.parametrize(
        "line",
        [
            *(
                f"N10240 $MN_SCALING_SYSTEM_IS_METRIC={no}"
                for no in ("0", "FALSE", "0.0", "-0", "0EX0", "'H0'", "'b00'")
            ),
            "INCH",
            "inch",
        ],
    )
    def test_machine_data_or_a_line_says_it(self, line: str) -> None:
        control = load(line + self.TABLE.replace("INCH", ""))
        assert at(control, "AX1", [-508], UP) == [-0.0254]

    def test_the_option_says_it_where_no_file_does(self) -> None:
        text = self.TABLE.replace("INCH", "")
        assert at(load(text, options={"units": "inch"}), "AX1", [-508], UP) == [-0.0254]
        assert at(load(text, options={"units": "mm"}), "AX1", [-20], UP) == [-0.001]

    def test_a_rotary_axis_stays_in_degrees(self) -> None:
        for yes in ("TRUE", "1.0", "'H1'", "'B1'"):
            turning = INITIAL.replace("METRIC", "INCH")
            turning = turning.replace("ROT_AX[AX1]=0", f"ROT_AX[AX1]={yes}")
            assert at(load(self.TABLE, turning), "X1", [-20], DOWN) == [-0.001 - 0.004]
        told = load(self.TABLE, kinds={"AX1": AxisKind.ROTARY})
        assert at(told, "AX1", [-20], UP) == [-0.001]

    def test_a_comment_says_the_kind_as_well(self) -> None:
        text = self.TABLE + "; as it is: $MA_IS_ROT_AX[AX1]=1\n"
        assert at(load(text), "AX1", [-20], UP) == [-0.001]

    @pytest.mark.parametrize("value", ["2", "'H2'", "-1"])
    def test_a_kind_that_is_not_known(self, value: str) -> None:
        with pytest.raises(InputError, match=r"f0: line 1.*MD30300.*expected 0 or 1, found"):
            load(f"N30300 $MA_IS_ROT_AX[AX1]={value}\n" + self.TABLE)

    def test_said_in_two_ways(self) -> None:
        with pytest.raises(InputError, match=r"f1: line 2.*MD10240, METRIC or INCH"):
            load(self.TABLE, INITIAL)

    def test_an_inch_of_another_length(self) -> None:
        line = "N10250 $MN_SCALING_VALUE_INCH=25\n"
        with pytest.raises(InputError, match=r"MD10250.*expected 25\.4, found 25"):
            load(line + self.TABLE)
        assert at(load(line + EEC), "AX1", [-200], UP) == [-0.001]
        same = "N10250 $MN_SCALING_VALUE_INCH=25.4\n"
        assert at(load(same + self.TABLE), "AX1", [-508], UP) == [-0.0254]

    def test_units_of_somebodys_own(self) -> None:
        for mask in ("H1", "H800", "H201"):
            with pytest.raises(InputError, match="MD10220"):
                load(f"N10220 $MN_SCALING_USER_DEF_MASK='{mask}'\n" + EEC)
        # the gain of the loop (bit 9) moves nothing; angles move no linear axis
        for mask in ("H200", "H0"):
            assert at(
                load(f"N10220 $MN_SCALING_USER_DEF_MASK='{mask}'\n" + EEC), "AX1", [-200], UP
            ) == [-0.001]
        linear = {"AX1": AxisKind.LINEAR}
        text = "N10220 $MN_SCALING_USER_DEF_MASK='H2'\n" + EEC
        assert at(load(text, kinds=linear), "AX1", [-200], UP) == [-0.001]

    def test_sag_tables_follow_md32711(self) -> None:
        sag = "".join(
            f"$AN_CEC{line}\n"
            for line in (
                "[0,0]=0.001",
                "[0,1]=0.002",
                "_INPUT_AXIS[0]=(AX1)",
                "_OUTPUT_AXIS[0]=(AX2)",
                "_STEP[0]=10",
                "_MIN[0]=0",
                "_MAX[0]=10",
                "_DIRECTION[0]=0",
            )
        )
        told = {"cec_sign": "error"}
        metric = "$MA_CEC_SCALING_SYSTEM_METRIC[AX2]=1\n"
        here = load("INCH\n" + sag, metric, options=told)
        assert here.cross_correction("AX1", "AX2", np.array([10.0]), UP) == pytest.approx(
            [-0.002], abs=EXACT
        )
        there = load(sag, metric.replace("=1", "=0"), options=told)
        assert there.cross_correction("AX1", "AX2", np.array([254.0]), UP) == pytest.approx(
            [-0.0508], abs=EXACT
        )
        # the unit is said by nobody: left alone, unless the axis corrects itself
        assert load("INCH\n" + sag, options=told).cross() == ()
        with pytest.raises(InputError, match="MD32711 of AX1"):
            load("INCH\n" + sag.replace("AX2", "AX1"), options=told)


class TestStepsThatDoNotDivide:
    def table(self, step: float, values: Sequence[float], *, low: float, high: float) -> str:
        points = "".join(f"$AA_ENC_COMP[0,{n},AX1]={v}\n" for n, v in enumerate(values))
        return (
            f"{points}$AA_ENC_COMP_STEP[0,AX1]={step}\n$AA_ENC_COMP_MIN[0,AX1]={low}\n"
            f"$AA_ENC_COMP_MAX[0,AX1]={high}\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n"
        )

    def test_a_step_of_four_decimals_was_meant_to_divide(self) -> None:
        # 39 steps of 19.7436 from -215: the last point is meant for 555 and lies 0.0004 beyond
        text = self.table(19.7436, [0.001 * n for n in range(40)], low=-215, high=555)
        control = load(text)
        assert control.correction("AX1", np.array([555.0, 600.0]), UP).tolist() == [-0.039, -0.039]
        assert control.correction("AX1", np.array([-215 + 19.7436]), UP) == pytest.approx(
            [-0.001], abs=1e-12
        )
        assert any("AA_ENC_COMP_STEP of AX1" in one.fact for one in control.assumed)

    def test_max_between_two_points_that_are_alike(self) -> None:
        # -850, -750 ... -50 and +50 beyond MAX = 0: the same value on both sides, so nothing hangs on it
        values = [0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.009, 0, 0]
        control = load(self.table(100, values, low=-850, high=0))
        assert at(control, "AX1", [-900, -100, -50, -10, 30], UP) == [
            -0.001,
            -0.0085,
            -0.009,
            -0.009,
            -0.009,
        ]

    def test_max_between_two_points_that_differ(self) -> None:
        values = [0.001] * 9 + [0.002]
        with pytest.raises(InputError, match=r"not a whole number.*differ \(\$AA_ENC_COMP_STEP\)"):
            load(self.table(100, values, low=-850, high=0))
        # a point that no file holds may be anything
        with pytest.raises(InputError, match="not a whole number"):
            load(self.table(100, [0.001] * 9, low=-850, high=0))
        assert at(load(self.table(100, [0.0] * 9, low=-850, high=0)), "AX1", [-20], UP) == [0.0]


class TestListingsOfPrograms:
    """Decimal commas and values that are not there."""

    LISTING = """$MA_ENC_COMP_ENABLE[0,AX1]=0
CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=+0,0010 ; first
$AA_ENC_COMP[0,1,AX1]=-0,0030
$AA_ENC_COMP_STEP[0,AX1]=100
$AA_ENC_COMP_MIN[0,AX1]=-100,0
$AA_ENC_COMP_MAX[0,AX1]=0
$AA_ENC_COMP_IS_MODULO[0,AX1]=0
$MA_ENC_COMP_ENABLE[0,AX1]=1
"""

    def test_commas_throughout(self) -> None:
        assert at(load(self.LISTING), "AX1", [-100, -50, 0], UP) == [-0.001, 0.001, 0.003]

    def test_one_point_makes_them_uncertain(self) -> None:
        for line in ("$MA_BACKLASH[0,AX1]=0.001\n", "R1=2.5\n"):
            with pytest.raises(InputError, match="cannot be read"):
                load(self.LISTING + line)
        # a point in a remark is no value, and another file may have its own habit
        assert at(load(self.LISTING + "; =0.5\n"), "AX1", [0], UP) == [0.003]
        other = "$MA_BACKLASH[0,AX1]=0.002\n"
        assert at(load(self.LISTING, other), "AX1", [0], DOWN) == [0.001]

    def test_a_value_that_is_not_given(self) -> None:
        left_out = "$MA_BACKLASH[0,AX1]=n/a ; not measured\n"
        with pytest.raises(InputError, match=r"f0: line 10.*BACKLASH.*no other file states it"):
            load(self.LISTING + left_out)
        said = load(self.LISTING + left_out, "$MA_BACKLASH[0,ax1]=0.002\n")
        assert at(said, "AX1", [0], DOWN) == [0.001]


class TestWhatIsSaidOfTheAxes:
    def test_one_measuring_system_is_the_first(self) -> None:
        control = load(EEC, "$MA_NUM_ENCS[AX1]=1\n$MA_BACKLASH[0,AX1]=0.002\n")
        assert at(control, "AX1", [-200], DOWN) == [-0.002]
        assert at(load(EEC, "$MA_NUM_ENCS[AX1]=2\n"), "AX1", [-200], UP) == [-0.001]

    def test_conditions_of_programs_are_not_assignments(self) -> None:
        program = "%_N_L1_SPF\nIF $MA_IS_ROT_AX[AX1]==1 GOTOF L\nR1=$MA_NUM_ENCS[AX1]\nM17\n"
        control = load(EEC.replace("METRIC", "INCH") + program)
        # still a linear axis: -200 inch = -5080 mm
        assert at(control, "AX1", [-5080], UP) == [-0.0254]


class TestNeighbours:
    """What is odd about an axis that nobody asks for stops nothing."""

    @pytest.mark.parametrize(
        "odd",
        [
            "$AA_ENC_COMP_STEP[1,AX2]=0\n",  # with MIN and MAX: no grid
            "$AA_ENC_COMP_STEP[1,AX2]=7\n",  # more points than there are
            "$AA_ENC_COMP_IS_MODULO[1,AX2]=1\n$AA_ENC_COMP_STEP[1,AX2]=100\n",  # a turn that jumps
            "$MA_MM_ENC_COMP_MAX_POINTS[1,AX2]=2\n$AA_ENC_COMP_STEP[1,AX2]=100\n",
        ],
    )
    def test_their_tables(self, odd: str) -> None:
        keep = [line for line in EEC.split("\n") if line.startswith("$") and "_STEP" not in line]
        keep = [line for line in keep if "IS_MODULO" not in line or "IS_MODULO" not in odd]
        neighbour = "\n".join(keep).replace("AX1", "AX2") + "\n" + odd
        control = load(EEC, neighbour, axes_under_work=("AX1",))
        assert at(control, "AX1", [-200], UP) == [-0.001]
        if "MAX_POINTS" not in odd:
            assert any("AX2" in note and "left alone" in note for note in control.notes)
        with pytest.raises(InputError):
            load(EEC, neighbour, axes_under_work=("AX1", "AX2"))


class TestTablesThatStay:
    """A job that does not name an index in ``cec_tables`` leaves that table as it is."""

    OWN = "".join(
        f"$AN_CEC{line}\n"
        for line in (
            "[4,0]=0.01",
            "[4,1]=0.02",
            "_INPUT_AXIS[4]=(AX1)",
            "_OUTPUT_AXIS[4]=(AX1)",
            "_STEP[4]=100",
            "_MIN[4]=-200",
            "_MAX[4]=-100",
            "_DIRECTION[4]=0",
        )
    )

    def job(self, text: str, *, tables: list[int], sign: str | None) -> SinumerikControl:
        return load(
            EEC.replace("M17", "") + text,
            options={"cec_sign": sign, "cec_tables": []},
            axis_options={"AX1": {"cec_tables": tables}},
            reference_return={"AX1": UP},
            axes_under_work=("AX1",),
        )

    def test_a_curve_with_a_sign_is_counted(self) -> None:
        control = self.job(self.OWN, tables=[], sign="correction")
        assert at(control, "AX1", [-200, -100], UP) == [0.009, 0.017]

    def test_without_a_sign_it_is_not_counted_unless_it_is_to_be_written(self) -> None:
        assert at(self.job(self.OWN, tables=[], sign=None), "AX1", [-200], UP) == [-0.001]
        with pytest.raises(UsageError, match="cec_sign"):
            self.job(self.OWN, tables=[4], sign=None).correction("AX1", np.array([-200.0]), UP)

    @pytest.mark.parametrize(
        "odd", ["$AN_CEC_TYPE[4]=1\n", "$SN_CEC_0[4]=0.1\n", "$AN_CEC_NEW[4]=1\n"]
    )
    def test_what_is_no_curve_stays_and_is_named(self, odd: str) -> None:
        control = self.job(self.OWN + odd, tables=[], sign="correction")
        assert at(control, "AX1", [-200], UP) == [-0.001]
        assert any("CEC table 4" in note and "stays" in note for note in control.notes)
        with pytest.raises(InputError, match="CEC table 4"):
            self.job(self.OWN + odd, tables=[4], sign="correction")
