"""The virtual controls against the manuals' numbers, observed values of a real control, and brute
force.
"""

from __future__ import annotations

import ctypes
import math
import platform
from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from compwright.controllers.linuxcnc.table import load_table, three_numbers
from compwright.controllers.sinumerik.reachable_lines import Line, conflicts
from compwright.controllers.virtual_control import KNOWN, VirtualControl, virtual_control
from compwright.foundations.errors import CompwrightError, InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE

# Shape and numbers of the sample in the Siemens function manual's layout (K3), values in mm.
EEC = """%_N_AX_EEC_INI
CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=0.003
$AA_ENC_COMP[0,1,AX1]=0.001
$AA_ENC_COMP[0,2,AX1]=0.0
$AA_ENC_COMP[0,3,AX1]=-0.002
$AA_ENC_COMP[0,4,AX1]=-0.0045
$AA_ENC_COMP_STEP[0,AX1]=50.0
$AA_ENC_COMP_MIN[0,AX1]=-100.0
$AA_ENC_COMP_MAX[0,AX1]=100.0
$AA_ENC_COMP_IS_MODULO[0,AX1]=0
M17
"""

# The table whose corrections were read from a running LinuxCNC 2.9.0~pre1.
OBSERVED = "-100 -100.010 -99.980\n0 0.004 0.010\n100 100.020 100.030\n"

# Single precision of trims of 0.03 mm: 0.03 * 2**-24 = 1.8e-9 mm; the observed values are printed
# to 1e-6 mm.
SINGLE = 4e-9


def siemens(*texts: str, **request: object) -> VirtualControl:
    files = [ControlFile(f"f{i}.ini", text.encode("latin-1")) for i, text in enumerate(texts)]
    # # keywords pass through
    return virtual_control("siemens-840d-sl", files, **request)  # type: ignore[arg-type]


def linuxcnc(**request: object) -> VirtualControl:
    # # a dict
    files = [ControlFile(name, content.encode()) for name, content in request.pop("files").items()]  # type: ignore[attr-defined]
    # # keywords pass through
    return virtual_control("linuxcnc", files, **request)  # type: ignore[arg-type]


def comp(text: str, comp_type: int = 0, extra: str = "") -> VirtualControl:
    ini = f"[JOINT_0]\nCOMP_FILE = joint_0.comp\nCOMP_FILE_TYPE = {comp_type}\n{extra}"
    return linuxcnc(files={"joint_0.comp": text, "joint_0.ini": ini})


def values(
    control: VirtualControl, address: str, positions: Sequence[float], direction: Direction
) -> list[float]:
    return [float(value) for value in control.correction(address, np.array(positions), direction)]


class TestSinumerik:
    def test_positive_value_moves_the_axis_towards_minus(self) -> None:
        control = siemens(EEC)
        # 0.5 * (0.003 + 0.001) at -75, 0.5 * (-0.002 - 0.0045) at 75, by hand; outside the end
        # values (p. 240)
        wanted = [-0.003, -0.003, -0.002, -0.001, 0.0, 0.002, 0.00325, 0.0045, 0.0045]
        for direction in (UP, DOWN):
            got = values(control, "AX1", [-150, -100, -75, -50, 0, 50, 75, 100, 150], direction)
            assert got == pytest.approx(wanted, abs=1e-15)  # mm; rounding of doubles
        assert control.points("AX1").tolist() == [-100, -50, 0, 50, 100]
        assert control.addresses() == ("AX1",)

    def test_measured_error_written_unchanged_is_removed(self) -> None:
        # a machine that is 5 µm too far at 200 mm, 2 µm short at 100 mm; the table holds e(x)
        # itself (manual p. 238)
        points = {0: 0.0, 1: -0.002, 2: 0.005}
        text = "".join(f"$AA_ENC_COMP[0,{n},X1]={e}\n" for n, e in points.items())
        text += (
            "$AA_ENC_COMP_STEP[0,X1]=100\n$AA_ENC_COMP_MIN[0,X1]=0\n$AA_ENC_COMP_MAX[0,X1]=200\n"
        )
        left = np.array([0.0, -0.002, 0.005]) + siemens(text).correction(
            "X1", np.array([0.0, 100, 200]), UP
        )
        assert np.max(np.abs(left)) < 1e-15  # mm

    @pytest.mark.parametrize(("returning", "up", "down"), [(UP, 0.0, -0.012), (DOWN, 0.012, 0.0)])
    def test_backlash_acts_against_the_referencing_direction(
        self, returning: Direction, up: float, down: float
    ) -> None:
        control = siemens(
            "N32450 $MA_BACKLASH[0,AX1]=0.012 '1a2F\n", reference_return={"AX1": returning}
        )
        assert values(control, "AX1", [5.0], UP) == [up]
        assert values(control, "AX1", [5.0], DOWN) == [down]
        assert control.points("AX1").size == 0

    def test_backlash_value_of_a_machine_with_lost_motion_removes_it(self) -> None:
        # lost motion of 12 µm: arriving downward the table stands 12 µm too high, B = mean(+) -
        # mean(-) = -0.012, MD32450 = -B
        error = {UP: 0.0, DOWN: 0.012}
        control = siemens("$MA_BACKLASH[0,AX1]=0.012\n")
        actual = [error[d] + values(control, "AX1", [100.0], d)[0] for d in (UP, DOWN)]
        assert actual[0] == pytest.approx(actual[1], abs=1e-15)

    def test_factor_multiplies_backlash(self) -> None:
        control = siemens("$MA_BACKLASH[0,AX1]=0.012\n$MA_BACKLASH_FACTOR[0,AX1]=0.5\n")
        assert values(control, "AX1", [0], DOWN) == [-0.006]

    @pytest.mark.parametrize(
        ("factor", "taken"), [(0.01, True), (100, True), (0.0099, False), (101, False)]
    )
    def test_factor_has_the_range_of_the_list_manual(self, factor: float, taken: bool) -> None:
        """MD32452: 0.01 to 100."""
        text = f"$MA_BACKLASH[0,AX1]=0.0002\n$MA_BACKLASH_FACTOR[0,AX1]={factor}\n"
        if taken:
            assert values(siemens(text), "AX1", [0], DOWN) == pytest.approx([-0.0002 * factor])
        else:
            with pytest.raises(InputError, match=r"0\.01 to 100"):
                siemens(text)

    def test_a_jump_in_the_last_line_leads_back(self) -> None:
        """GOTOF searches towards the end of a program, GOTOB towards its beginning: the assignment
        of line 2 is executed, over the jump of line 4. Without that jump no run executes it.
        """
        program = [
            Line(1, frozenset(), ("GOTOF", "LAST")),
            Line(2, frozenset({"FIRST"}), (), given=True),
            Line(3, frozenset(), ("M17",)),
            Line(4, frozenset({"LAST"}), ("GOTOB", "FIRST")),
        ]
        assert conflicts(program) is None
        assert conflicts([*program[:3], Line(4, frozenset({"LAST"}), ("M17",))]) == (2, 0)

    def test_table_and_backlash_add_up(self) -> None:
        control = siemens(EEC, "$MA_BACKLASH[0,AX1]=0.010\n")
        assert values(control, "AX1", [-100, 50], DOWN) == pytest.approx(
            [-0.013, -0.008], abs=1e-15
        )

    def test_load_sequence_counts_by_its_last_value(self) -> None:
        off, on = "$MA_ENC_COMP_ENABLE[0,AX1]=0\n", "$MA_ENC_COMP_ENABLE[0,AX1]=1\nNEWCONF\n"
        assert values(siemens(off + EEC.replace("M17", on + "M17")), "AX1", [-100], UP) == [-0.003]
        switched_off = siemens(on + EEC.replace("M17", off + "M17"))
        assert values(switched_off, "AX1", [-100], UP) == [0.0]
        assert any("MD32700" in note for note in switched_off.notes)
        assert any("MD32700" in a.fact for a in siemens(EEC).assumed)
        assert not any("MD32700" in a.fact for a in siemens(on, EEC).assumed)

    def test_modulo_table_repeats(self) -> None:
        text = "".join(
            f"$AA_ENC_COMP[1,{n},AX4]={v}\n"
            for n, v in enumerate([0.001, 0.003, -0.002, 0.004, 0.001])
        )
        text += "$AA_ENC_COMP_STEP[1,AX4]=90\n$AA_ENC_COMP_MIN[1,AX4]=0\n$AA_ENC_COMP_MAX[1,AX4]=360\n$AA_ENC_COMP_IS_MODULO[1,AX4]=1\n"
        control = siemens(text)
        # -45 is 315: mean of 0.004 and 0.001; 405 is 45: mean of 0.001 and 0.003
        wanted = [-0.0025, -0.002, -0.002, -0.002, -0.001, -0.001, -0.001]
        assert values(control, "AX4", [-45, 45, 405, 765, 0, 360, -360], UP) == pytest.approx(
            wanted, abs=1e-15
        )

    def test_variants_of_the_text_mean_the_same(self) -> None:
        reordered = "\n".join(reversed(EEC.replace("M17\n", "").splitlines()[2:]))
        variants = [
            reordered,
            EEC.replace("\n", "\r\n"),
            EEC.replace("=", " = +").replace("+-", "-"),
            EEC.replace("0.003\n", "0.003000 ; first point\n").replace("_N_AX_", "_N_AX1_"),
            ";$PATH=/_N_NC_ACT_DIR\n" + EEC.replace("M17", "M0\nM30"),
            EEC.lower().replace("%_n_ax_eec_ini", "%_N_AX_EEC_INI"),
            EEC.replace("[0,0,AX1]=0.003", "[ 0 , 0 , AX1 ]=3EX-3"),
            EEC.replace("=0.0\n", "=-0.0\n"),
        ]
        positions = np.linspace(-130, 130, 53)
        expected = siemens(EEC).correction("AX1", positions, UP)
        for text in variants:
            assert np.array_equal(siemens(text).correction("AX1", positions, UP), expected), text
        blank = siemens(EEC.replace("[0,2,AX1]=", "[0,2,AX1] "))
        assert np.array_equal(blank.correction("AX1", positions, UP), expected)
        assert any("blank" in note for note in blank.notes)

    def test_points_above_max_are_ignored_and_the_last_one_inside_holds(self) -> None:
        """An older, longer table (FB2 09/2009 p362); beyond MAX the value of point k (p240)."""
        control = siemens(EEC.replace("=100.0", "=50.0"))
        assert control.points("AX1").tolist() == [-100, -50, 0, 50]
        assert values(control, "AX1", [-100, 0, 25, 50, 75, 500], UP) == [
            *(-0.003, 0.0, 0.001, 0.002, 0.002, 0.002)
        ]
        assert any("points 4 to 4 lie above MAX" in note for note in control.notes)

    def test_interpolation_against_brute_force(self) -> None:
        rng = np.random.default_rng(1)
        table = np.round(rng.normal(0, 0.01, 26), 6)
        text = "".join(f"$AA_ENC_COMP[1,{n},AX1]={v:.6f}\n" for n, v in enumerate(table))
        text += "$AA_ENC_COMP_STEP[1,AX1]=50\n$AA_ENC_COMP_MIN[1,AX1]=-625\n$AA_ENC_COMP_MAX[1,AX1]=625\n"
        text += "$MA_MM_ENC_COMP_MAX_POINTS[1,AX1]=26\n"
        positions = [*rng.uniform(-700, 700, 400), *np.arange(-625, 626, 50.0)]
        got = values(siemens(text), "AX1", positions, UP)
        for x, correction in zip(positions, got, strict=True):
            assert correction == pytest.approx(
                -slow_value(x, [-625 + 50 * n for n in range(26)], table), abs=1e-15
            )

    def test_only_system_with_a_table_is_taken_and_said(self) -> None:
        control = siemens(EEC.replace("[0,", "[1,"), "$MA_BACKLASH[0,AX1]=0.5\n")
        assert values(control, "AX1", [-100], DOWN) == [
            -0.003
        ]  # not the 0.5 mm of the other system
        assert any(a.value == "2" for a in control.assumed)
        wrong = siemens(EEC.replace("[0,", "[1,"), encoder={"AX1": 1})
        assert values(wrong, "AX1", [-100], DOWN) == [0.0]
        assert any("does not act" in note for note in wrong.notes)

    @pytest.mark.parametrize(
        ("text", "says"),
        [
            (EEC.replace("$AA_ENC_COMP[0,3,AX1]=-0.002\n", ""), "missing points"),
            (EEC[: EEC.index("$AA_ENC_COMP[0,4")], "STEP"),
            (EEC.replace("$AA_ENC_COMP_MAX[0,AX1]=100.0\n", ""), "MAX"),
            (EEC.replace("=100.0", "=200.0"), "missing points"),
            (EEC.replace("=100.0", "=110.0"), "whole number"),
            (EEC.replace("STEP[0,AX1]=50.0", "STEP[0,AX1]=0"), "STEP > 0"),
            (EEC.replace("=100.0", "=-200.0"), "MAX >= MIN"),
            (EEC.replace("0.003", "0,003"), "cannot be read"),
            (EEC.replace("0.003", "3E-3"), "cannot be read"),
            (EEC.replace("0.003", ""), "cannot be read"),
            (EEC.replace("[0,0,AX1]", "[0,0]"), "index"),
            (EEC.replace("[0,0,AX1]", "[2,0,AX1]"), "0 or 1"),
            (EEC + EEC.replace("0.003", "0.004"), "contradicts"),
            (EEC.replace("_MODULO[0,AX1]=0", "_MODULO[0,AX1]=-1"), "0 or 1"),
            (EEC.replace("M17\n", "") + "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=4\n", "MD38000"),
            (EEC.replace("$AA_ENC_COMP[0,3", "M17\n$AA_ENC_COMP[0,3"), "end of the program"),
            (EEC.replace("ENC_COMP_STEP", "ENC_COMP_STPE"), "is unknown"),
            (
                "".join(line + "\n" for line in EEC.splitlines() if "COMP[" not in line),
                "missing points",
            ),
            ("CHANDATA(1)\nM17\n", "no compensation data"),
            ("\x00\x01ARCHIVE" + EEC, "binary"),
        ],
    )
    def test_what_contradicts_itself_is_refused_with_its_line(self, text: str, says: str) -> None:
        with pytest.raises(InputError, match=r"f0\.ini") as caught:
            siemens(text)
        assert says in str(caught.value)

    def test_file_cut_anywhere_is_refused_or_the_same_or_empty_handed(self) -> None:
        positions = np.linspace(-150, 150, 61)
        whole = siemens(EEC).correction("AX1", positions, UP)
        for length in range(len(EEC)):
            try:
                control = siemens(EEC[:length])
            except InputError:
                continue
            # the only survivors have all points and the grid: they mean the same (MAX=100. without
            # its last digit, too)
            assert np.array_equal(control.correction("AX1", positions, UP), whole), EEC[:length][
                -40:
            ]

    def test_all_faults_at_once(self) -> None:
        with pytest.raises(InputError) as caught:
            siemens(EEC.replace("0.003", "x").replace("-0.002", "y"))
        assert [fault.place for fault in caught.value.faults] == ["line 3", "line 6"]

    def test_untouched_second_system_of_an_archive_is_no_table(self) -> None:
        zero = "".join(
            f"$AA_ENC_COMP_{key}[1,AX1]=0\n" for key in ("STEP", "MIN", "MAX", "IS_MODULO")
        )
        assert values(siemens(EEC, zero), "AX1", [-100], UP) == [-0.003]


class TestLinuxCnc:
    def test_values_observed_on_the_real_control(self) -> None:
        control = comp(OBSERVED)
        assert values(control, "0", [10, 50, 100, 150], UP) == pytest.approx(
            [-0.0056, -0.012, -0.020, -0.020], abs=SINGLE
        )
        assert values(control, "0", [50, 0, -50], DOWN) == pytest.approx(
            [-0.020, -0.010, -0.015], abs=SINGLE
        )
        assert control.points("0").tolist() == [-100, 0, 100]
        assert control.notes == ()
        assert values(comp("10 10.02 9.99\n"), "X", [10], UP) == pytest.approx([-0.02], abs=SINGLE)
        assert values(comp("10 10.02 9.99\n"), "X", [10], DOWN) == pytest.approx([0.01], abs=SINGLE)
        assert values(comp("10 0.03 -0.01\n", 1), "0", [-500, 500], UP) == pytest.approx(
            [0.03, 0.03], abs=SINGLE
        )

    def test_same_data_in_both_types(self) -> None:
        trims = "-200  0.0080 -0.0040\n   0  0.0000 -0.0120\n 200 -0.0100 -0.0230\n"
        actual = "-200 -200.0080 -199.9960\n0 0.0000 0.0120\n200 200.0100 200.0230\n"
        positions = np.linspace(-250, 250, 101)
        for direction, column in ((UP, [0.008, 0.0, -0.010]), (DOWN, [-0.004, -0.012, -0.023])):
            wanted = [slow_value(x, [-200, 0, 200], column) for x in positions]
            for control in (comp(trims, 1), comp(actual, 0), comp(trims, 2), comp(trims, -1)):
                assert control.correction("0", positions, direction).tolist() == pytest.approx(
                    wanted, abs=SINGLE
                )

    def test_backlash_acts_half_each_way_and_only_without_a_table(self) -> None:
        alone = linuxcnc(files={"m.ini": "[JOINT_0]\nBACKLASH = 0.020\n"})
        assert values(alone, "0", [3], UP) == [0.010]
        assert values(alone, "0", [3], DOWN) == [-0.010]
        both = comp(OBSERVED, extra="BACKLASH = 0.020\n")
        assert values(both, "0", [100], UP) == pytest.approx([-0.020], abs=SINGLE)
        assert any("BACKLASH" in note and "ignored" in note for note in both.notes)
        # a header line empties the table: the control falls back to BACKLASH
        emptied = comp("nominal forward reverse\n" + OBSERVED, extra="BACKLASH = 0.020\n")
        assert values(emptied, "0", [100], UP) == [0.010]
        assert any("line 1" in note and "3 further lines" in note for note in emptied.notes)

    @pytest.mark.parametrize(
        ("text", "rows"),
        [
            ("# comment\n" + OBSERVED, 0),
            ("; comment\n" + OBSERVED, 0),
            ("\n" + OBSERVED, 0),
            ("\ufeff" + OBSERVED, 0),
            (OBSERVED.replace(" ", ","), 0),
            (OBSERVED.replace(" ", ";"), 0),
            (OBSERVED.replace(".", ","), 0),
            ("0 1\n" + OBSERVED, 0),
            ("0mm 0 0\n1 1 1\n", 0),
            ("", 0),
            (OBSERVED.replace("0 0.004", "# \n0 0.004", 1), 1),
            (OBSERVED.replace("\n0 ", "\n\n0 "), 1),
            (OBSERVED.replace("\n0 0.004 0.010", "\n0 0.004"), 1),
            (OBSERVED.replace("\n", "\r"), 1),
            (OBSERVED.replace("\n", " " * 260 + "\n", 1), 1),
            (OBSERVED.replace("100 100", "\u2212100 100"), 2),
            (OBSERVED.replace("\n", "\r\n"), 3),
            (OBSERVED.replace(" ", "\t").rstrip(), 3),
            (OBSERVED.replace("\n", " # text\n") + "\n\n", 3),
            (OBSERVED.replace("\n", " 7\n"), 3),
            ("  -1e2 -1.0001e+2 -99.98\n+0 +0.004 0x.01\n100 100 100\n", 3),
            ("100 100 100\n0 0 0\n-100 -100 -100\n", 1),
            ("0 0 0\n0 0 0\n5 5 5\n", 2),
            ("".join(f"{n} {n} {n}\n" for n in range(300)), 256),
        ],
    )
    def test_files_are_cut_where_the_real_control_was_seen_to_cut_them(
        self, text: str, rows: int
    ) -> None:
        control = comp(text)
        assert control.points("0").size == rows
        assert (control.notes == ()) == (rows == 3), "whatever is dropped must be said"

    @pytest.mark.parametrize(
        "row", ["1 2 3,4", "1.2.3.4", "1-2-3", "1 2 3abc", "1 2 3\0 4", "1 2 3\r4 5 6"]
    )
    def test_row_that_reads_otherwise_than_it_looks_is_said(self, row: str) -> None:
        control = comp(row + "\n")
        assert control.points("0").size == 1
        assert any("first three numbers" in note for note in control.notes)

    def test_dropped_line_is_named(self) -> None:
        control = comp(OBSERVED.replace("\n0 ", "\n\n0 "))
        assert len(control.notes) == 1
        assert "joint_0.comp: line 2" in control.notes[0]
        assert "2 further lines" in control.notes[0]

    def test_interpolation_against_brute_force(self) -> None:
        rng = np.random.default_rng(2)
        nominal = np.unique(np.round(rng.uniform(-500, 500, 40), 3))
        columns = rng.normal(0, 0.02, (2, nominal.size))
        text = "".join(f"{x} {a:.7f} {b:.7f}\n" for x, a, b in zip(nominal, *columns, strict=True))
        control = comp(text, 1)
        positions = [*rng.uniform(-600, 600, 300), *nominal]
        for direction, column in zip((UP, DOWN), np.round(columns, 7), strict=True):
            got = values(control, "0", positions, direction)
            # mm; trims up to 0.1 in single precision (6e-9) and slopes, in single too, over gaps up
            # to 120 mm
            assert got == pytest.approx(
                [slow_value(x, nominal, column) for x in positions], abs=3e-8
            )

    def test_type_defaults_to_actual_positions(self) -> None:
        control = linuxcnc(
            files={
                "joint_0.comp": OBSERVED,
                "m.ini": "[JOINT_0]\nCOMP_FILE = tables/joint_0.comp\n",
            }
        )
        assert values(control, "0", [100], UP) == pytest.approx([-0.020], abs=SINGLE)
        assert any("COMP_FILE_TYPE" in a.fact for a in control.assumed)

    def test_table_without_ini(self) -> None:
        control = linuxcnc(files={"joint_2.comp": OBSERVED})
        assert control.addresses() == ("2",)
        assert values(control, "2", [100], UP) == pytest.approx([-0.020], abs=SINGLE)
        assert {a.fact for a in control.assumed} >= {
            "joint that loads joint_2.comp",
            "COMP_FILE_TYPE of joint 2",
        }
        trims = linuxcnc(
            files={"x.comp": "0 0.01 0.02\n"}, options={"axis": "X", "comp_file_type": "1"}
        )
        assert values(trims, "0", [1], DOWN) == pytest.approx([0.02], abs=SINGLE)
        with pytest.raises(InputError, match="which joint"):
            linuxcnc(files={"x.comp": OBSERVED})

    def test_inch_machine(self) -> None:
        # 1 inch: 0.001 inch too far going +, so -0.0254 mm at 25.4 mm; the other joint turns in
        # degrees and is not scaled
        files = {
            "m.ini": (
                "[TRAJ]\nLINEAR_UNITS = inch\n[JOINT_0]\nTYPE ="
                " LINEAR\nCOMP_FILE=a\n[JOINT_1]\nTYPE = ANGULAR\nCOMP_FILE=b\n"
            ),
            "a": "0 0 0\n1 1.001 1\n",
            "b": "0 0 0\n1 1.001 1\n",
        }
        control = linuxcnc(files=files)
        assert control.points("0").tolist() == [0.0, 25.4]
        assert values(control, "0", [25.4, 12.7], UP) == pytest.approx(
            [-0.0254, -0.0127], abs=25.4 * SINGLE
        )
        assert values(control, "1", [1.0], UP) == pytest.approx([-0.001], abs=SINGLE)
        # a number there counts machine units per mm
        by_number = linuxcnc(
            files=files | {"m.ini": files["m.ini"].replace("inch", f"{1 / 25.4:.12f}")}
        )
        assert values(by_number, "0", [25.4], UP) == pytest.approx([-0.0254], abs=25.4 * SINGLE)
        alone = {"joint_0.comp": files["a"]}
        assert values(
            linuxcnc(files=alone, options={"units": "inch"}), "0", [25.4], UP
        ) == pytest.approx([-0.0254], abs=1e-7)
        rotary = linuxcnc(files=alone, options={"units": "inch"}, kinds={"0": AxisKind.ROTARY})
        assert values(rotary, "0", [1.0], UP) == pytest.approx([-0.001], abs=SINGLE)

    def test_ini_is_searched_as_the_control_searches_it(self) -> None:
        machine = (
            "[TRAJ]\nLINEAR_UNITS = mm\n[JOINT_0]\nTYPE = LINEAR\n#COMP_FILE ="
            " other\nCOMP_FILE_TYPE_X = 1\nCOMP_FILE_TYPE=1 # trims\nCOMP_FILE ="
            " a\n[JOINT_1]\nBACKLASH =\n[JOINT_0]\nBACKLASH = 5\n[JOINT_10]\nBACKLASH = 0.5\n"
        )
        control = linuxcnc(files={"m.ini": machine, "a": "0 0.01 0.02\n"})
        assert control.addresses() == ("0", "1", "10")
        assert values(control, "0", [1], UP) == pytest.approx([0.01], abs=SINGLE)
        assert values(control, "1", [1], UP) == [0.0]
        assert values(control, "10", [1], UP) == [0.25]
        assert any("second section [JOINT_0]" in note for note in control.notes)

    def test_key_of_a_later_section_and_continued_line(self) -> None:
        text = "[JOINT_0]\nTYPE = LINEAR\n[JOINT_1]\nBACKLASH = 1.\\\n5\n[DISPLAY]\nBACKLASH = 7\n"
        control = linuxcnc(files={"m.ini": text})
        assert values(control, "0", [0], UP) == [0.0]
        assert values(control, "1", [0], UP) == [0.75]

    def test_longest_line(self) -> None:
        # 254 bytes with the line end still are one row; one more, and the line end is left over as
        # a line without numbers
        for length, rows in ((254, 3), (255, 1)):
            first, rest = OBSERVED.split("\n", 1)
            assert comp(first.ljust(length - 1) + "\n" + rest).points("0").size == rows

    def test_included_joint_file(self) -> None:
        part = "[JOINT_0]\nCOMP_FILE = joint_0.comp\nCOMP_FILE_TYPE = 1\nBACKLASH = 0\n"
        machine = "[TRAJ]\nLINEAR_UNITS = mm\n#INCLUDE joint_0.ini\nTYPE = LINEAR\n"
        control = linuxcnc(
            files={"m.ini": machine, "joint_0.ini": part, "joint_0.comp": "0 0.01 0.02\n"}
        )
        assert values(control, "0", [1], UP) == pytest.approx([0.01], abs=SINGLE)
        assert control.notes == ()
        keys_only = {
            "m.ini": "[JOINT_0]\n#INCLUDE keys.inc\n",
            "keys.inc": part.split("\n", 1)[1],
            "joint_0.comp": "0 0.01 0.02\n",
        }
        control = linuxcnc(files=keys_only)
        assert values(control, "0", [1], UP) == pytest.approx([0.01], abs=SINGLE)
        assert control.notes == ()
        with pytest.raises(InputError, match=r"m\.ini: line 3: .*was not given.*joint_0\.ini"):
            linuxcnc(files={"m.ini": machine, "joint_0.comp": "0 0.01 0.02\n"})

    @pytest.mark.parametrize(
        ("ini", "says"),
        [
            ("[JOINT_0]\nCOMP_FILE = gone.comp\n", "was not given"),
            ("[JOINT_0]\nCOMP_FILE = a\nCOMP_FILE_TYPE = none\n", "COMP_FILE_TYPE"),
            ("[JOINT_0]\nBACKLASH = much\n", "BACKLASH"),
            ("[JOINT_0]\nTYPE = ROUND\n", "LINEAR or ANGULAR"),
            ("[TRAJ]\nLINEAR_UNITS = furlong\n[JOINT_0]\n", "LINEAR_UNITS"),
            ("[JOINT_0]\rBACKLASH = 1\n", "carriage return"),
            ("[EMC]\nVERSION = 1.1\n", "no joint"),
        ],
    )
    def test_what_keeps_the_control_from_starting(self, ini: str, says: str) -> None:
        files = {"m.ini": ini} | ({"a": OBSERVED} if "= a" in ini else {})
        with pytest.raises(InputError, match=r"m\.ini") as caught:
            linuxcnc(files=files)
        assert says in str(caught.value)

    def test_contradicting_inis(self) -> None:
        with pytest.raises(InputError, match="differs"):
            linuxcnc(
                files={"a.ini": "[JOINT_0]\nBACKLASH = 1\n", "b.ini": "[JOINT_0]\nBACKLASH = 2\n"}
            )

    def test_not_finite_numbers_give_no_number(self) -> None:
        for text in ("0 0 0\n1 nan 1\n", "0 0 inf\n", "0 0 1e300\n"):
            control = comp(text)
            assert math.isnan(values(control, "0", [0.5], UP)[0])
            assert any("not finite" in note for note in control.notes)

    def test_trims_are_stored_in_single_precision(self) -> None:
        table = load_table(b"0 0.1 0\n", "t", 1)
        assert table.forward[0] == float(np.float32(0.1)) != 0.1


class TestNumbers:
    """The reader's idea of three numbers is that of the C library."""

    libc = ctypes.CDLL("libc.so.6") if platform.system() == "Linux" else None

    @pytest.mark.skipif(libc is None, reason="compares with the C library of Linux")
    @given(
        st.text(alphabet="0123456789.-+eExXpPinfatyINF# ,\t\r(_", max_size=24)
        | st.text(alphabet="0123456789.eE+- ", max_size=30)
    )
    @example("1 2 infi")
    @example("infinity 2 -inf")
    @example("nan(1) 1 2")
    @example("1e 2 3e+")
    @example("0x 2 3")
    @example("0x.p1 0x1p3 0X1.8P-1")
    @example("1e400 1e-400 0x1p9999")
    @settings(max_examples=200, deadline=None)
    def test_as_scanf_does(self, text: str) -> None:
        assert self.libc is not None
        found = [ctypes.c_double() for _ in range(3)]
        count = self.libc.sscanf(
            text.encode(), b"%lf %lf %lf", *[ctypes.byref(number) for number in found]
        )
        mine = three_numbers(text.encode())
        assert (mine is not None) == (count == 3)
        if mine is not None:
            np.testing.assert_array_equal(mine, [number.value for number in found])


class TestContract:
    def test_known_and_unknown(self) -> None:
        heidenhain = {"heidenhain-itnc530", "heidenhain-nck"}
        fanuc = {"fanuc-0i-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-15i", "fanuc-30i"}
        siemens_ids = {"siemens-828d", "siemens-840d-pl", "siemens-840d-sl", "siemens-one"}
        single = {"linuxcnc", "isg-kernel", "pmac"}
        assert set(KNOWN) == single | siemens_ids | heidenhain | fanuc
        with pytest.raises(UsageError, match="no virtual control"):
            virtual_control("abacus", [ControlFile("a", b"")])
        for format_id in KNOWN:
            with pytest.raises(InputError, match="no file of the control"):
                virtual_control(format_id, [])

    def test_a_control_without_cross_tables_says_so(self) -> None:
        for control in (siemens(EEC), comp(OBSERVED)):
            assert control.cross() == ()
            with pytest.raises(UsageError, match="no table"):
                control.cross_correction("X", "Y", np.zeros(2), UP)

    def test_unknown_axis(self) -> None:
        for control in (siemens(EEC), comp(OBSERVED)):
            with pytest.raises(UsageError, match="no data of axis AX7"):
                control.correction("AX7", np.zeros(1), UP)

    def test_reference_return_is_assumed_and_listed(self) -> None:
        assert any(
            a.fact == "reference_return of AX1" and a.value == "+" for a in siemens(EEC).assumed
        )
        by_option = siemens("$MA_BACKLASH[0,AX1]=0.012\n", options={"reference_return": "-"})
        assert values(by_option, "AX1", [0], UP) == [0.012]
        with pytest.raises(UsageError, match="reference_return"):
            siemens(EEC, options={"reference_return": "up"})

    def test_any_shape(self) -> None:
        grid = np.linspace(-120, 120, 12).reshape(3, 4)
        for control, address in ((siemens(EEC), "AX1"), (comp(OBSERVED), "0")):
            assert control.correction(address, grid, DOWN).shape == (3, 4)
            assert control.correction(address, np.array(5.0), DOWN).shape == ()
            assert np.array_equal(
                control.correction(address, grid, UP).ravel(),
                control.correction(address, grid.ravel(), UP),
            )


def ask_everything(format_id: str, files: list[ControlFile]) -> None:
    """Load and ask; only compwright's own errors may come out."""
    try:
        control = virtual_control(format_id, files)
    except CompwrightError:
        return
    for address in control.addresses():
        for direction in Direction:
            assert control.correction(address, np.linspace(-1e3, 1e3, 7), direction).shape == (7,)
        assert np.all(np.diff(control.points(address)) > 0) or not np.all(
            np.isfinite(control.points(address))
        )


def mutated(text: str) -> st.SearchStrategy[bytes]:
    """Cuts, doublings and replaced bytes of a good file."""
    content = text.encode()

    def apply(edits: list[tuple[int, int, bytes]]) -> bytes:
        result = content
        for start, length, new in edits:
            result = (
                result[: start % (len(result) + 1)]
                + new
                + result[start % (len(result) + 1) + length :]
            )
        return result

    edit = st.tuples(
        st.integers(0, 400),
        st.integers(0, 40),
        st.binary(max_size=4) | st.sampled_from([b"\n", b",", b"-", b"9", b"[", b"="]),
    )
    return st.lists(edit, min_size=1, max_size=4).map(apply)


@given(content=st.binary(max_size=400) | mutated(EEC), other=st.binary(max_size=50))
@settings(max_examples=100, deadline=None)
def test_any_bytes_sinumerik(content: bytes, other: bytes) -> None:
    ask_everything("siemens-840d-sl", [ControlFile("a.ini", content)])
    ask_everything(
        "siemens-840d-sl",
        [
            ControlFile("a.ini", EEC.encode()),
            ControlFile("b.ini", content),
            ControlFile("c", other),
        ],
    )


INI = (
    "[TRAJ]\nLINEAR_UNITS = mm\n[JOINT_0]\nTYPE = LINEAR\nCOMP_FILE = joint_0.comp\nCOMP_FILE_TYPE"
    " = 0\nBACKLASH = 0.01\n"
)


@given(
    table=st.binary(max_size=300) | mutated(OBSERVED), ini=st.binary(max_size=200) | mutated(INI)
)
@settings(max_examples=100, deadline=None)
def test_any_bytes_linuxcnc(table: bytes, ini: bytes) -> None:
    ask_everything("linuxcnc", [ControlFile("joint_0.comp", table)])
    ask_everything(
        "linuxcnc", [ControlFile("joint_0.comp", table), ControlFile("joint_0.ini", INI.encode())]
    )
    ask_everything(
        "linuxcnc", [ControlFile("joint_0.comp", table), ControlFile("joint_0.ini", ini)]
    )


def slow_value(
    x: float, nodes: Sequence[float] | np.ndarray, column: Sequence[float] | np.ndarray
) -> float:
    """Linear interpolation by search, one position at a time; the end values held outside."""
    if x < nodes[0]:
        return float(column[0])
    for i in range(len(nodes) - 1):
        if nodes[i] <= x <= nodes[i + 1]:
            return float(
                column[i] + (column[i + 1] - column[i]) * (x - nodes[i]) / (nodes[i + 1] - nodes[i])
            )
    return float(column[-1])
