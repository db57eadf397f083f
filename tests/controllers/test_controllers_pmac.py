"""The virtual PMAC against worked numbers of the manuals' rules, and against damage.

1000 counts per mm: 16 in a script is one count, which is 1 µm.
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
PER_MM: dict[str, object] = {"counts_per_unit": 1000}

WORKED = """I51=0
#1 DEFINE COMP 4,#1D,400000
-32 -48 16 0
#1 DEFINE BLCOMP 4,400000
8 12 -4 0
I185=32 I186=96
I51=1
"""
# Worked by hand: table alone going +, less 6 counts and the backlash table going -; mm and counts.
GOING_UP = {0: 0, 50: -1, 100: -2, 150: -2.5, 200: -3, -50: 0.5, -100: 1}
GOING_DOWN = {0: -6, 50: -7.25, 100: -8.5, 150: -9.125, 200: -9.75, -50: -5.375, -100: -4.75}

# Motor 2 is bent by motor 1; its own table is defined in the same script.
CROSS = """#1 DELETE COMP
#2 DELETE COMP ; from the lowest motor upwards
#3 DEFINE COMP 2,#1D,#2,200000
160 0
#2 DEFINE COMP 2,#2D,100000
-16 0
I51=1
"""

# µm: rounding of doubles at 1e2 µm and below.
ROUNDING = 1e-9


def pmac(*texts: str, **request: object) -> VirtualControl:
    files = [ControlFile(f"comp{i}.pmc", text.encode("latin-1")) for i, text in enumerate(texts, 1)]
    # # keywords pass through
    return virtual_control("pmac", files, **{"options": PER_MM, **request})  # type: ignore[arg-type]


def um(
    control: VirtualControl, positions: Sequence[float], direction: Direction, address: str = "1"
) -> list[float]:
    at = np.array(positions, dtype=float)
    return [float(value) * 1e3 for value in control.correction(address, at, direction)]


def close(numbers: Sequence[float]) -> object:
    """Equal in µm but for the rounding of doubles."""
    return pytest.approx(list(numbers), abs=ROUNDING)


class TestTables:
    @pytest.mark.parametrize(("direction", "wanted"), [(UP, GOING_UP), (DOWN, GOING_DOWN)])
    def test_worked_script(self, direction: Direction, wanted: dict[int, float]) -> None:
        control = pmac(WORKED)
        assert um(control, list(wanted), direction) == close(list(wanted.values()))
        assert control.addresses() == ("1",)
        assert control.cross() == ()

    def test_entries_are_added(self) -> None:
        # the axis stands 2 µm too far at 100 mm: the script holds -2 counts, 1/16 count each
        assert um(pmac(WORKED), [100], UP) == close([-2.0])

    def test_it_repeats_after_its_length(self) -> None:
        places = [-350, 450, 850, -750, 400, -400]
        assert um(pmac(WORKED), places, UP) == close([-1, -1, -1, -1, 0, 0])
        # between 200 and 300 mm the unused gap: from -3 to +1 count
        assert um(pmac(WORKED), [225, 250, 275], UP) == close([-2, -1, 0])

    def test_points_are_the_entries_with_motor_zero(self) -> None:
        control = pmac(WORKED, reference={"1": -850.0})
        assert control.points("1").tolist() == pytest.approx([-850, -750, -650, -550, -450])
        finer = WORKED.replace("BLCOMP 4,400000\n8 12 -4 0", "BLCOMP 2,400000\n8 0")
        assert pmac(finer).points("1").tolist() == pytest.approx([0, 100, 200, 300, 400])

    def test_motor_zero_is_the_reference(self) -> None:
        control = pmac(WORKED, reference={"1": -850.0})
        assert um(control, [-850, -750, -650], UP) == close([0, -2, -3])
        assert um(control, [-850, -950], DOWN) == close([-6, -4.75])
        assert "reference of 1" in [one.fact for one in pmac(WORKED).assumed]

    def test_a_motor_that_counts_against_the_axis(self) -> None:
        control = pmac(WORKED, axis_options={"1": {"counts_per_unit": -1000.0}})
        # at -100 mm the motor stands at +100 mm: -2 counts are +2 µm of the axis; the motor moves
        # in its negative direction while the axis moves in its positive one
        assert um(control, [-100], DOWN) == close([2.0])
        assert um(control, [-100], UP) == close([8.5])
        assert np.all(np.diff(control.points("1")) > 0)
        assert control.points("1")[0] == pytest.approx(-400)

    def test_counts_per_unit_are_never_assumed(self) -> None:
        for wrong in ({}, {"counts_per_unit": 0}, {"counts_per_unit": "x"}):
            with pytest.raises(UsageError, match="option counts_per_unit of motor 1"):
                pmac(WORKED, options=wrong)
        assert um(pmac(WORKED, options={"counts_per_unit": "2000"}), [50], UP) == close([-1.0])
        # of a motor that is not under work nobody asks, and nothing is said
        other = pmac(WORKED, options={}, axes_under_work=("2",))
        with pytest.raises(UsageError, match="counts_per_unit of motor 1"):
            other.correction("1", np.zeros(1), UP)

    def test_writing_is_free(self) -> None:
        for text in (
            WORKED.lower(),
            WORKED.replace("\n", "\r\n"),
            WORKED.replace("\n", "\r"),
            WORKED.replace("DEFINE", "DEF").replace("4,400000", "4 , 400000"),
            WORKED.replace("-32 -48 16 0", "-32\n-48 ; two\n\n+16\n0"),
            WORKED.replace("I185=32 I186=96", "I185 = $20\nI186=$60\nI187=64\nP1=3\nM169->D:$0"),
            "; a remark\n&1\n#1->1000X\n" + WORKED + "SAVE\n",
            WORKED.replace("\n#1 DEFINE BL", "\nDEFINE BL"),
        ):
            assert um(pmac(text), list(GOING_DOWN), DOWN) == close(list(GOING_DOWN.values()))

    def test_without_d_the_actual_position_is_taken_for_the_commanded(self) -> None:
        for text in (WORKED.replace("#1D,", "#1,"), WORKED.replace("#1D,", "")):
            assert um(pmac(text), list(GOING_UP), UP) == close(list(GOING_UP.values()))
            assert any("looked up by" in one.fact for one in pmac(text).assumed)
        assert not any("looked up by" in one.fact for one in pmac(WORKED).assumed)

    def test_tables_of_one_motor_add_up(self) -> None:
        text = WORKED.replace("I51=0\n", "I51=0\n#3 DEFINE COMP 2,#1D,#1,400000\n160 0\n")
        # half way up to 10 counts at 100 mm
        assert um(pmac(text), [100, 200], UP) == close([3.0, 7.0])

    def test_scripts_run_one_after_the_other(self) -> None:
        first, second = WORKED.split("I185")
        control = pmac(first, "I185" + second)
        assert um(control, [100], DOWN) == close([-8.5])
        again = "#1 DELETE BLCOMP\n#1 DELETE COMP\n#1 DEFINE COMP 2,#1D,400000\n32 0\n"
        assert um(pmac(WORKED, again), [100, 200], UP) == close([1.0, 2.0])
        assert um(pmac(WORKED, "I51=0"), [100], UP) == [0.0]

    def test_any_shape(self) -> None:
        grid = np.linspace(-300, 400, 12).reshape(3, 4)
        assert pmac(WORKED).correction("1", grid, UP).shape == (3, 4)
        assert pmac(WORKED).correction("1", np.array(5.0), DOWN).shape == ()


class TestTurn:
    ROTARY = "#4 DEFINE COMP 4,#4D,36000\n16 32 -16 0\nI51=1\n"

    def test_length_is_one_turn(self) -> None:
        options: dict[str, object] = {"counts_per_unit": 100}
        control = pmac(self.ROTARY, options=options, modulo={"4": 360.0})
        # 1/100 deg per count
        got = control.correction("4", np.array([-45, 0, 45, 90, 405.0]), UP)
        assert got.tolist() == pytest.approx([-0.005, 0, 0.005, 0.01, 0.005], abs=1e-12)
        half = self.ROTARY.replace("36000", "18000")
        pmac(half, options=options, modulo={"4": 360.0})

    def test_another_length_is_refused(self) -> None:
        options: dict[str, object] = {"counts_per_unit": 100}
        for length in ("36001", "40000", "72000"):
            text = self.ROTARY.replace("36000", length)
            with pytest.raises(InputError, match=r"line 1: the table repeats after .*36000 counts"):
                pmac(text, options=options, modulo={"4": 360.0})


class TestBacklash:
    def test_constant(self) -> None:
        control = pmac("I185=32\nI186=120\n")
        # 120/16 = 7.5 counts, subtracted while the last motion was negative
        assert um(control, [-5, 300], UP) == [0.0, 0.0]
        assert um(control, [-5, 300], DOWN) == close([-7.5, -7.5])
        assert control.points("1").size == 0

    def test_value_of_a_machine_with_lost_motion_removes_it(self) -> None:
        # lost motion of 7.5 µm: arriving towards - the table stands 7.5 µm too high
        control = pmac("I185=32\nI186=120\n")
        assert um(control, [0], DOWN)[0] + 7.5 == pytest.approx(um(control, [0], UP)[0])

    def test_take_up_rate_zero_switches_it_off(self) -> None:
        off = WORKED.replace("I185=32", "I185=0")
        assert um(pmac(off), list(GOING_UP), DOWN) == close(list(GOING_UP.values()))
        assert any("backlash of motor 1 is off (I185)" in note for note in pmac(off).notes)
        assert um(pmac(off, active=True), [100], DOWN) == close([-8.5])

    def test_the_tables_switch_leaves_the_constant(self) -> None:
        off = WORKED.replace("I51=1", "I51=0")
        assert um(pmac(off), [0, 100], UP) == [0.0, 0.0]
        assert um(pmac(off), [0, 100], DOWN) == close([-6, -6])
        assert pmac(off).points("1").size == 5

    def test_missing_is_not_zero(self) -> None:
        with pytest.raises(InputError, match=r"line 6: I185 .*; expected a line I185=\.\.\."):
            pmac(WORKED.replace("I185=32", ""))
        with pytest.raises(InputError, match=r"line 4: I186 .*; expected a line I186=\.\.\."):
            pmac(WORKED.replace("I186=96", ""))
        answered = pmac(WORKED.replace("I185=32", ""), active=True)
        assert um(answered, [100], DOWN) == close([-8.5])
        without = "#1 DEFINE COMP 2,#1D,400000\n32 0\n"
        assumed = [(one.fact, one.value) for one in pmac(without).assumed]
        assert ("I186", "0") in assumed
        assert ("I51", "1") in assumed
        assert um(pmac(without, active=False), [100], UP) == [0.0]

    @pytest.mark.parametrize("wrong", ["-1", "8388608", "1.5", "P5"])
    def test_range(self, wrong: str) -> None:
        with pytest.raises(InputError, match="line 6: I186; expected a whole number, 0 to 8388607"):
            pmac(WORKED.replace("I186=96", f"I186={wrong}"))

    def test_a_range_of_variables(self) -> None:
        control = pmac("I180..186=48\n")
        assert um(control, [0], DOWN) == close([-3.0])


class TestCross:
    def test_source_and_target(self) -> None:
        control = pmac(CROSS)
        assert control.cross() == (("1", "2"),)
        at = np.array([-50, 0, 50, 100, 150, 250.0])
        for direction in (UP, DOWN):
            got = control.cross_correction("1", "2", at, direction) * 1e3
            assert got.tolist() == close([5, 0, 5, 10, 5, 5])
        assert um(control, [25, 50], UP, "2") == close([-0.5, -1])
        assert control.addresses() == ("2",)
        with pytest.raises(
            UsageError,
            match="no table that corrects motor 1 over the position of motor 2; expected 2 over 1",
        ):
            control.cross_correction("2", "1", at, UP)

    def test_units_of_both_motors(self) -> None:
        own: dict[str, dict[str, object]] = {
            "1": {"counts_per_unit": 2000},
            "2": {"counts_per_unit": -500},
        }
        control = pmac(CROSS, options={}, axis_options=own, reference={"1": 10.0})
        # half way along 200000 counts of motor 1 is 50 mm from its zero; 10 counts of motor 2 are
        # -20 µm
        got = control.cross_correction("1", "2", np.array([10.0, 60.0]), UP) * 1e3
        assert got.tolist() == close([0, -20])
        with pytest.raises(UsageError, match="counts_per_unit of motor 1"):
            pmac(CROSS, options={}, axis_options={"2": own["2"]})

    def test_default_target_is_the_addressed_motor(self) -> None:
        text = "#2 DEFINE COMP 2,#1D,200000\n160 0\nI51=1\n"
        assert pmac(text).cross() == (("1", "2"),)
        assert um(pmac(text + "I285=0\n"), [3], UP, "2") == [0.0]

    def test_switched_off(self) -> None:
        assert pmac(CROSS.replace("I51=1", "I51=0")).cross() == ()

    def test_of_others_nothing_is_said(self) -> None:
        control = pmac(CROSS, options={}, axes_under_work=("7",))
        assert control.cross() == ()
        assert any("motor 1 does to motor 2" in note for note in control.notes)

    def test_planes_are_refused_by_name(self) -> None:
        plane = "#1 DEFINE COMP 1.2,#1D,#2D,#1,1000,2000\n0 0 5 0 0\nI51=1\n"
        with pytest.raises(InputError, match="line 1: a table over two motors corrects motor 1"):
            pmac(plane)
        assert um(pmac(plane.replace("5", "0")), [0], UP) == [0.0]
        assert any("two motors" in note for note in pmac(plane, axes_under_work=("2",)).notes)
        with pytest.raises(InputError, match="expected 5 whole numbers, found 4"):
            pmac(plane.replace("0 0 5 0 0", "0 0 5 0"))
        with pytest.raises(InputError, match="corrects motor 1"):
            pmac("#4" + plane.removeprefix("#1"))
        # the third motor is the target, the addressed one without it
        with pytest.raises(InputError, match="corrects motor 1"):
            pmac(plane.replace("#1D,#2D,#1,", "#3,"))


class TestScript:
    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("-32 -48 16 0", "-32 -48 16", r"line 2: .*does not get its.*4 whole numbers, found 3"),
            ("-32 -48 16 0", "-32 -48 16 0 0", "line 3: a number that belongs to no table"),
            ("-32 -48 16 0", "-32 -48 16 4", "line 2: the last entry .*; expected 0, found 4"),
            ("8 12 -4 0", "8 12 -4 1", "line 4: the last entry of DEFINE BLCOMP"),
            ("-32 -48 16 0", "-32 -48.5 16 0", "does not get its entries"),
            ("-32 -48 16 0", "-32 $30 16 0", "does not get its entries"),
            ("-32 -48 16 0", "-32 -9999999 16 0", "line 3: an entry; expected -8388607 to 8388607"),
            ("COMP 4,#1D,400000", "COMP 0,#1D,400000", "line 2: DEFINE COMP; expected at least"),
            ("COMP 4,#1D,400000", "COMP 4,#1D,0", "line 2: DEFINE COMP; expected at least one"),
            ("COMP 4,#1D,400000", "COMP 4,#1D", "line 2: not a command"),
            ("COMP 4,#1D,400000", "COMP 4,#33D,400000", "a motor; expected 1 to 32, found #33"),
            ("COMP 4,#1D,400000", "CMP 4,#1D,400000", "line 2: not a command"),
            ("#1 DEFINE COMP", "DEFINE COMP", "line 2: this line names no motor"),
            ("#1 DEFINE COMP", "#0 DEFINE COMP", "a motor; expected 1 to 32, found #0"),
            ("I51=1", "I51=2", "line 7: I51; expected 0 or 1, found '2'"),
            ("I51=1", "I51=P1", "line 7: I51; expected 0 or 1"),
            ("I51=1", "I51=$#1", "line 7: I51; expected 0 or 1, found '.#1'"),
            ("I51=1", "I51=", "line 7: I51; expected 0 or 1, found ''"),
            ("I51=1", "$$$", "line 7: not a command that is known here"),
            ("I51=1", "COMPTABLE[0].NX[0]=4", "line 7: a script of a Power PMAC"),
            ("I51=1", "OPEN PROG 1 CLEAR\nI51=1\nCLOSE", "line 8: a program sets I51 when it runs"),
            ("I51=1", "OPEN PLC 1\nP1=I51", "line 7: a program in the script has no end"),
            ("I51=1", "#1 DEFINE COMP 2,400000\n1 0", "ERR003: DEFINE COMP of motor 1 is refused"),
            ("I51=1", "#1 DEFINE BLCOMP 1,4\n0", "expected DELETE BLCOMP before it"),
            ("I51=1", "#2 DEFINE BLCOMP 1,4\n0", "expected the highest motor first, found one of"),
            ("I51=0", "DEFINE GATHER", "line 2: ERR003: .*, found GATHER already"),
            ("I51=0", "DEFINE ROTARY 100", "line 2: ERR003: .*, found ROT already"),
            ("I51=0", "#3 DEFINE TCOMP 2,400\n1 0", "line 3: ERR003: .*, found TCOMP already"),
            ("I51=0", "#3 DEFINE BLCOMP 1,400\n0", "ERR003: DEFINE COMP .*found BLCOMP already"),
        ],
    )
    def test_faults_by_line(self, old: str, new: str, says: str) -> None:
        text = WORKED.replace(old, new)
        assert text != WORKED
        with pytest.raises(InputError, match=says) as caught:
            pmac(text)
        assert all("comp1.pmc" in str(fault) for fault in caught.value.faults)

    def test_order_of_motors(self) -> None:
        high_first = "#2 DEFINE COMP 1,400\n0\n#1 DEFINE COMP 1,400\n0\nI51=1\n"
        pmac(high_first)
        with pytest.raises(InputError, match="ERR003: DEFINE COMP of motor 2"):
            pmac(high_first.replace("#2", "#0").replace("#1", "#2").replace("#0", "#1"))
        with pytest.raises(InputError, match=r"ERR003: DELETE COMP of motor 2 is refused.*lowest"):
            pmac(high_first + "#2 DELETE COMP\n")
        pmac(high_first + "#1 DELETE COMP\n#2 DELETE COMP\n")

    def test_buffers_that_are_deleted_first(self) -> None:
        text = "DEFINE GATHER\n#3 DEFINE TCOMP 2,400\n1 0\nDEL GATHER\n"
        with pytest.raises(InputError, match="found GATHER already"):
            pmac(text + WORKED)
        text = "#3 DEFINE TCOMP 2,400\n1 0\nDEFINE GATHER\nDEL GATHER\n#3 DELETE TCOMP\n"
        assert um(pmac(text + WORKED), [100], UP) == close([-2])

    def test_programs_are_read_over(self) -> None:
        text = WORKED + "OPEN PLC 5 CLEAR\nIF (P1>3) I285=3\nX100 Y(SIN(30))\nCLOSE\nI186=112\n"
        assert um(pmac(text), [0], DOWN) == close([-7])
        # what a program does to another motor stops nothing here
        assert pmac(text, axes_under_work=("1",)).addresses() == ("1",)

    def test_what_is_odd_about_others_stops_nothing(self) -> None:
        text = WORKED.replace("I51=0", "#2 DEFINE COMP 2,400\n1 1")
        control = pmac(text, axes_under_work=("1",))
        assert um(control, [100], UP) == close([-2])
        assert control.addresses() == ("1",)
        assert any("motor 2" in note for note in control.notes)
        with pytest.raises(InputError, match="the last entry"):
            pmac(text)

    def test_all_faults_at_once(self) -> None:
        with pytest.raises(InputError) as caught:
            pmac(WORKED.replace("16 0", "16 4").replace("-4 0", "-4 3"))
        assert len(caught.value.faults) == 2

    def test_unknown_motor(self) -> None:
        for wrong in ("2", "X", "²", "-1", ""):
            with pytest.raises(UsageError, match="contain no data of axis"):
                pmac(WORKED).correction(wrong, np.zeros(1), UP)

    def test_binary(self) -> None:
        with pytest.raises(InputError, match="NUL"):
            pmac(WORKED.replace("I51=0", "\x00"))


def ask_everything(content: bytes) -> None:
    """Load and ask; only compwright's own errors may come out, and no number that is none."""
    try:
        control = virtual_control("pmac", [ControlFile("a.pmc", content)], options=PER_MM)
    except CompwrightError:
        return
    for address in control.addresses():
        for direction in Direction:
            got = control.correction(address, np.linspace(-1e3, 1e3, 7), direction)
            assert got.shape == (7,)
            assert np.all(np.isfinite(got))
        assert np.all(np.diff(control.points(address)) > 0)
    for source, target in control.cross():
        got = control.cross_correction(source, target, np.linspace(-1e3, 1e3, 7), UP)
        assert np.all(np.isfinite(got))


class TestDamage:
    @settings(max_examples=60, deadline=None)
    @given(
        st.sampled_from([WORKED, CROSS, "#1 DEFINE COMP 1.1,#1,#2,10,10\n0 0 0\nI180..187=3\n"]),
        st.lists(
            st.tuples(
                st.floats(0, 1),
                st.integers(0, 3),
                st.one_of(
                    st.sampled_from(
                        [b"", b"9", b"-", b".", b"#", b"\n", b";", b"D", b"$", b"9999"]
                    ),
                    st.binary(min_size=1, max_size=3),
                ),
            ),
            min_size=1,
            max_size=4,
        ),
    )
    def test_damaged_scripts(self, text: str, damage: list[tuple[float, int, bytes]]) -> None:
        content = bytearray(text.encode())
        for place, length, new in damage:
            at = int(place * (len(content) - 1))
            content[at : at + length] = new
        ask_everything(bytes(content))

    @settings(max_examples=50, deadline=None)
    @given(st.binary(max_size=200))
    def test_anything(self, content: bytes) -> None:
        ask_everything(content)

    @pytest.mark.parametrize("text", [WORKED, CROSS])
    def test_cut_anywhere(self, text: str) -> None:
        for end in range(len(text)):
            ask_everything(text[:end].encode())
