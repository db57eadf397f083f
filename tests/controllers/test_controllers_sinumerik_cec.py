"""The SINUMERIK judge: sag and cross tables, endless leadscrew tables, archives; against numbers
worked by hand and brute force.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.control import (
    ROOM_828D,
    SinumerikControl,
    sinumerik_control,
)
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
#: mm or deg; rounding of doubles in sums of values of a few µm
EXACT = 1e-15


def load(*texts: str, options: Mapping[str, object] | None = None) -> SinumerikControl:
    files = [
        ControlFile(f"f{number}.ini", text.encode("latin-1")) for number, text in enumerate(texts)
    ]
    return sinumerik_control(files, Request(options={"cec_sign": "correction", **(options or {})}))


def cec(
    index: int,
    values: Sequence[float],
    grid: tuple[float, float, float],
    axes: tuple[str, str] = ("AX1", "AX1"),
    **more: int,
) -> str:
    """Return the lines of one table; ``grid``: MIN, STEP, MAX; ``more``: DIRECTION, MULT_BY_TABLE,
    IS_MODULO.
    """
    lines = [f"$AN_CEC[{index},{n}]={value:.9f}" for n, value in enumerate(values)]
    lines += [
        f"$AN_CEC_INPUT_AXIS[{index}]=({axes[0]})",
        f"$AN_CEC_OUTPUT_AXIS[{index}]=({axes[1]})",
    ]
    lines += [
        f"$AN_CEC_{key}[{index}]={value!r}"
        for key, value in zip(("MIN", "STEP", "MAX"), grid, strict=True)
    ]
    given = {"DIRECTION": 0, "MULT_BY_TABLE": 0, "IS_MODULO": 0} | more
    return (
        "\n".join([*lines, *(f"$AN_CEC_{key}[{index}]={value}" for key, value in given.items())])
        + "\n"
    )


def eec(
    axis: str, values: Sequence[float], grid: tuple[float, float, float], modulo: int = 0
) -> str:
    lines = [f"$AA_ENC_COMP[0,{n},{axis}]={value:.9f}" for n, value in enumerate(values)]
    lines += [
        f"$AA_ENC_COMP_{key}[0,{axis}]={value!r}"
        for key, value in zip(("MIN", "STEP", "MAX"), grid, strict=True)
    ]
    return "\n".join([*lines, f"$AA_ENC_COMP_IS_MODULO[0,{axis}]={modulo}"]) + "\n"


def at(
    control: SinumerikControl, address: str, positions: Iterable[float], direction: Direction
) -> list[float]:
    return [
        float(value) for value in control.correction(address, np.array(list(positions)), direction)
    ]


def across(
    control: SinumerikControl,
    base: str,
    corrected: str,
    positions: Iterable[float],
    direction: Direction,
) -> list[float]:
    return [
        float(value)
        for value in control.cross_correction(base, corrected, np.array(list(positions)), direction)
    ]


# The file shape of the 802D sl manual p. 222, numbers of our own: a ramp from AX1 onto AX2, a pair
# of tables of AX1 over itself.
SHAPE = """%_N_NC_CEC_INI
CHANDATA(1)
$AN_CEC[0,0]=0.000000
$AN_CEC[0,1]=-0.016000
$AN_CEC_INPUT_AXIS[0]=(AX1)
$AN_CEC_OUTPUT_AXIS[0]=(AX2)
$AN_CEC_STEP[0]=800.0
$AN_CEC_MIN[0]=0.0
$AN_CEC_MAX[0]=800.0
$AN_CEC_DIRECTION[0]=0
$AN_CEC_MULT_BY_TABLE[0]=0
$AN_CEC_IS_MODULO[0]=0
$AN_CEC[1,0]=0.000000
$AN_CEC[1,1]=0.002000
$AN_CEC[1,2]=-0.001500
$AN_CEC_INPUT_AXIS[1]=(AX1)
$AN_CEC_OUTPUT_AXIS[1]=(AX1)
$AN_CEC_STEP[1]=400.0
$AN_CEC_MIN[1]=0.0
$AN_CEC_MAX[1]=800.0
$AN_CEC_DIRECTION[1]=1
$AN_CEC_MULT_BY_TABLE[1]=0
$AN_CEC_IS_MODULO[1]=0
$AN_CEC[2,0]=0.004
$AN_CEC[2,1]=0.001
$AN_CEC[2,2]=0.0025
$AN_CEC_INPUT_AXIS[2]=(AX1)
$AN_CEC_OUTPUT_AXIS[2]=(AX1)
$AN_CEC_STEP[2]=400.0
$AN_CEC_MIN[2]=0.0
$AN_CEC_MAX[2]=800.0
$AN_CEC_DIRECTION[2]=-1
$AN_CEC_MULT_BY_TABLE[2]=0
$AN_CEC_IS_MODULO[2]=0
M17
"""
LINES = SHAPE.splitlines()


class TestShape:
    def test_own_tables_by_direction_worked_by_hand(self) -> None:
        control = load(SHAPE)
        positions = [-100, 0, 200, 400, 600, 800, 900]
        assert at(control, "AX1", positions, UP) == pytest.approx(
            [0, 0, 0.001, 0.002, 0.00025, -0.0015, -0.0015], abs=EXACT
        )
        assert at(control, "AX1", positions, DOWN) == pytest.approx(
            [0.004, 0.004, 0.0025, 0.001, 0.00175, 0.0025, 0.0025], abs=EXACT
        )
        assert control.points("AX1").tolist() == [0, 400, 800]

    def test_ramp_from_one_axis_to_the_other(self) -> None:
        control = load(SHAPE)
        assert control.cross() == (("AX1", "AX2"),)
        for direction in (UP, DOWN):
            got = across(control, "AX1", "AX2", [-50, 0, 200, 400, 800, 1000], direction)
            assert got == pytest.approx([0, 0, -0.004, -0.008, -0.016, -0.016], abs=EXACT)
        assert across(control, "ax1", "Ax2", [800], UP) == [-0.016]

    def test_axis_that_is_only_corrected_by_another_has_no_own_correction(self) -> None:
        control = load(SHAPE)
        assert control.addresses() == ("AX1",)
        with pytest.raises(UsageError, match="AX2"):
            control.correction("AX2", np.zeros(1), UP)
        with pytest.raises(UsageError, match="corrects axis AX1 over the position of axis AX2"):
            control.cross_correction("AX2", "AX1", np.zeros(1), UP)
        with pytest.raises(UsageError, match="no table"):
            control.cross_correction("AX1", "AX1", np.zeros(1), UP)

    def test_what_was_taken_without_being_said(self) -> None:
        control = load(SHAPE)
        facts = " | ".join(assumption.fact for assumption in control.assumed)
        for fact in (
            "cec_sign",
            "SD41300 $SN_CEC_TABLE_ENABLE of table 2",
            "MD32710 $MA_CEC_ENABLE of AX1",
            "MD32710 $MA_CEC_ENABLE of AX2",
        ):
            assert fact in facts
        assert "IS_MODULO" not in facts
        assert "DIRECTION" not in facts
        assert control.notes == ()
        said = load(
            SHAPE,
            "".join(f"$SN_CEC_TABLE_ENABLE[{n}]=1\n" for n in range(3)),
            "$MA_CEC_ENABLE[AX1]=1\n$MA_CEC_ENABLE[AX2]=1\n",
        )
        assert [assumption.fact for assumption in said.assumed] == [
            "sign of the CEC values (cec_sign)"
        ]
        left_out = ("$AN_CEC_IS_MODULO[0]", "$AN_CEC_MULT_BY_TABLE[2]")
        facts = " | ".join(
            assumption.fact
            for assumption in load(
                "\n".join(x for x in LINES if not x.startswith(left_out))
            ).assumed
        )
        assert "$AN_CEC_IS_MODULO of table 0" in facts
        assert "$AN_CEC_MULT_BY_TABLE of table 2" in facts

    def test_table_of_one_direction_without_its_partner_is_said(self) -> None:
        control = load("\n".join(line for line in LINES if "[2" not in line))
        assert at(control, "AX1", [400], DOWN) == [0.0]
        assert any("only while AX1 moves towards +" in note for note in control.notes)
        control = load("\n".join(line for line in LINES if "[1" not in line))
        assert at(control, "AX1", [400], UP) == [0.0]
        assert any("only while AX1 moves towards -" in note for note in control.notes)

    def test_variants_of_the_text_mean_the_same(self) -> None:
        variants = [
            SHAPE.replace("\n", "\r\n"),
            "\n".join(reversed(LINES[2:-1])),
            SHAPE.replace("=", " = ").replace("= 0.00", "= +0.00"),
            SHAPE.replace("$AN_CEC[", "$AN_CEC ["),
            SHAPE.lower(),
            SHAPE.replace("(AX1)", "( ax1 )").replace("$AN_CEC_STEP", "N120 $AN_CEC_STEP"),
            SHAPE.replace("(AX1)", "AX1 ; base"),
            SHAPE.replace("0.002000", "2EX-3 '0aF3"),
            SHAPE.replace(
                "CHANDATA(1)",
                ";$PATH=/_N_NC_ACT_DIR/_N_CEC_DIR\n$PATH=/_N_$AN_CEC_DIR\n$MA_CEC_MAX_VELO[AX1]=10",
            ),
            SHAPE.replace("M17", "M0\nM17"),
        ]
        positions = np.linspace(-100, 900, 41)
        expected = load(SHAPE)
        for text in variants:
            control = load(text)
            for direction in (UP, DOWN):
                assert np.array_equal(
                    control.correction("AX1", positions, direction),
                    expected.correction("AX1", positions, direction),
                ), text
                got = control.cross_correction("AX1", "AX2", positions, direction)
                assert np.array_equal(
                    got, expected.cross_correction("AX1", "AX2", positions, direction)
                ), text

    def test_file_cut_anywhere_is_refused_or_says_less(self) -> None:
        positions = np.linspace(-100, 900, 21)
        whole = load(SHAPE)
        accepted = 0
        for length in range(SHAPE.index("M17")):
            try:
                control = load(SHAPE[:length])
            except InputError:
                continue
            accepted += 1
            assert any("no end" in note for note in control.notes)
            for pair in control.cross():
                assert np.array_equal(
                    control.cross_correction(*pair, positions, UP),
                    whole.cross_correction(*pair, positions, UP),
                )
            if "AX1" in control.addresses():
                assert np.array_equal(
                    control.correction("AX1", positions, UP), whole.correction("AX1", positions, UP)
                )
        assert accepted > 0


class Test828D:
    """Function Manual 03/2013 p. 264: 11 points each, -585 to -5, pitch 58, one table for each
    direction; values of our own.
    """

    GRID = (-585.0, 58.0, -5.0)
    RISING = tuple(0.001 * (n + 1) for n in range(11))
    FALLING = tuple(0.020 - 0.002 * n for n in range(11))

    def text(self) -> str:
        reserved = "$MN_MM_CEC_MAX_POINTS[0]=11\n$MN_MM_CEC_MAX_POINTS[1]=11\n"
        return (
            reserved
            + cec(0, self.RISING, self.GRID, DIRECTION=1)
            + cec(1, self.FALLING, self.GRID, DIRECTION=-1)
        )

    def test_worked_by_hand(self) -> None:
        control = load(self.text())
        assert control.points("AX1").tolist() == [
            -585,
            -527,
            -469,
            -411,
            -353,
            -295,
            -237,
            -179,
            -121,
            -63,
            -5,
        ]
        positions = [-700, -585, -556, -527, -295, -34, -5, 100]
        assert at(control, "AX1", positions, UP) == pytest.approx(
            [0.001, 0.001, 0.0015, 0.002, 0.006, 0.0105, 0.011, 0.011], abs=EXACT
        )
        assert at(control, "AX1", positions, DOWN) == pytest.approx(
            [0.02, 0.02, 0.019, 0.018, 0.01, 0.001, 0.0, 0.0], abs=EXACT
        )

    def test_known_error_of_each_direction_is_removed(self) -> None:
        rng = np.random.default_rng(3)
        nodes = np.array([-585 + 58 * n for n in range(11)])
        error = {
            UP: np.round(rng.normal(0, 0.01, 11), 6),
            DOWN: np.round(rng.normal(0.02, 0.01, 11), 6),
        }
        text = cec(0, [*-error[UP]], self.GRID, DIRECTION=1) + cec(
            1, [*-error[DOWN]], self.GRID, DIRECTION=-1
        )
        turned = cec(0, [*error[UP]], self.GRID, DIRECTION=1) + cec(
            1, [*error[DOWN]], self.GRID, DIRECTION=-1
        )
        for direction in (UP, DOWN):
            for control in (
                load(text),
                load(text, options={"cec_sign": "correction"}),
                load(turned, options={"cec_sign": "error"}),
            ):
                assert (
                    np.max(np.abs(error[direction] + control.correction("AX1", nodes, direction)))
                    < EXACT
                )


class TestSums:
    def test_squareness_of_a_machine_is_removed(self) -> None:
        # Y leans by 30 µm/m towards + of X's travel: y is too far by 30e-6 (x - 100); the table
        # holds the opposite
        text = cec(
            4, [-30e-6 * (x - 100) for x in (-200, 600)], (-200.0, 800.0, 600.0), ("X1", "Y1")
        )
        x = np.linspace(-200, 600, 33)
        for direction in (UP, DOWN):
            left = 30e-6 * (x - 100) + load(text).cross_correction("X1", "Y1", x, direction)
            assert np.max(np.abs(left)) < EXACT

    def test_leadscrew_table_sag_table_and_backlash_add_up(self) -> None:
        text = eec("AX1", [0.003, 0.001], (0.0, 100.0, 100.0)) + cec(
            0, [0.010, 0.030], (0.0, 100.0, 100.0)
        )
        text += "$MA_BACKLASH[0,AX1]=0.010\n$MA_BACKLASH_FACTOR[0,AX1]=0.5\n"
        assert at(load(text), "AX1", [0, 50, 100], UP) == pytest.approx(
            [0.007, 0.018, 0.029], abs=EXACT
        )
        assert at(load(text), "AX1", [0, 50, 100], DOWN) == pytest.approx(
            [0.002, 0.013, 0.024], abs=EXACT
        )
        returned = sinumerik_control(
            [ControlFile("a.ini", text.encode())],
            Request(reference_return={"AX1": DOWN}, options={"cec_sign": "correction"}),
        )
        assert at(returned, "AX1", [50], UP) == pytest.approx([0.023], abs=EXACT)
        # as an error the sag value turns, and only that
        turned = load(text, options={"cec_sign": "error"})
        assert at(turned, "AX1", [0, 50, 100], UP) == pytest.approx(
            [-0.013, -0.022, -0.031], abs=EXACT
        )
        # outside both tables hold their ends (p. 240, p. 248)
        assert at(load(text), "AX1", [-10, 110], UP) == pytest.approx([0.007, 0.029], abs=EXACT)

    def test_points_are_those_of_all_own_tables(self) -> None:
        text = eec("AX1", [0, 0, 0], (-50.0, 50.0, 50.0)) + cec(0, [0, 0, 0], (0.0, 30.0, 60.0))
        text += cec(3, [0, 0], (10.0, 5.0, 15.0), ("AX2", "AX1")) + cec(
            7, [0, 0], (-1.0, 4.0, 3.0), ("AX1", "AX2")
        )
        control = load(text)
        assert control.points("AX1").tolist() == [-50, 0, 30, 50, 60]
        assert control.cross() == (("AX2", "AX1"), ("AX1", "AX2"))
        # 0.1 + 0.2 and 0.3 are one point
        near = cec(0, [0, 0, 0], (0.1, 0.2, 0.5)) + cec(1, [0, 0], (0.3, 0.2, 0.5))
        assert load(near).points("AX1").size == 3

    def test_axis_is_one_whatever_its_case(self) -> None:
        text = eec("AX1", [0.003, 0.001], (0.0, 100.0, 100.0)) + cec(
            0, [0.01, 0.03], (0.0, 100.0, 100.0), ("ax1", "Ax1")
        )
        text += cec(1, [0.02, 0.02], (0.0, 100.0, 100.0), ("aX1", "ax2")) + cec(
            2, [0.01, 0.01], (0.0, 100.0, 100.0), ("AX1", "AX2")
        )
        control = load(text, "$AN_CEC_OUTPUT_AXIS[0]=(AX1)\n")
        assert control.addresses() == ("AX1",)
        assert at(control, "ax1", [0], UP) == pytest.approx([0.007], abs=EXACT)
        assert control.cross() == (("AX1", "ax2"),)
        assert across(control, "AX1", "AX2", [0], UP) == pytest.approx([0.03], abs=EXACT)

    def test_weight_and_several_tables(self) -> None:
        text = cec(0, [0.010, 0.020], (0.0, 100.0, 100.0)) + cec(
            5, [0.001, 0.003], (50.0, 100.0, 150.0)
        )
        control = load(text, "$SN_CEC_TABLE_WEIGHT[5]=3.0\n$SN_CEC_TABLE_WEIGHT[5]=-2.0\n")
        assert at(control, "AX1", [0, 50, 100, 150], UP) == pytest.approx(
            [0.008, 0.013, 0.016, 0.014], abs=EXACT
        )
        assert at(load(text), "AX1", [100], UP) == pytest.approx([0.022], abs=EXACT)

    def test_modulo_table_repeats(self) -> None:
        text = cec(
            0, [0.001, 0.003, -0.002, 0.004, 0.001], (0.0, 90.0, 360.0), ("C1", "C1"), IS_MODULO=1
        )
        positions = [-45, 45, 405, 765, 0, 360, -360, 180]
        wanted = [0.0025, 0.002, 0.002, 0.002, 0.001, 0.001, 0.001, -0.002]
        assert at(load(text), "C1", positions, UP) == pytest.approx(wanted, abs=EXACT)

    def test_brute_force(self) -> None:
        rng = np.random.default_rng(11)
        made = [slow_table(rng, index) for index in range(6)]
        control = load("".join(table.text(index) for index, table in enumerate(made)))
        positions = [*rng.uniform(-900, 900, 200), *np.arange(-300, 300, 10.0)]
        for direction in (UP, DOWN):
            got = across(control, "X1", "Z1", positions, direction)
            for x, value in zip(positions, got, strict=True):
                wanted = 0.0
                for table in made:
                    wanted += 0.0 if table.factor else table.value(x, direction.sign)
                assert value == pytest.approx(
                    wanted, abs=1e-12
                )  # mm; sums of about 1 mm over positions of 1000 mm


@dataclass(frozen=True)
class SlowTable:
    """A table by search, one position at a time."""

    start: float
    step: float
    values: list[float]
    modulo: bool
    way: int
    weight: float
    factor: int

    @property
    def last(self) -> float:
        return self.start + self.step * (len(self.values) - 1)

    def text(self, index: int) -> str:
        more = {"DIRECTION": self.way, "MULT_BY_TABLE": self.factor, "IS_MODULO": int(self.modulo)}
        return (
            cec(index, self.values, (self.start, self.step, self.last), ("X1", "Z1"), **more)
            + f"$SN_CEC_TABLE_WEIGHT[{index}]={self.weight}\n"
        )

    def value(self, x: float, sign: int) -> float:
        if self.way and self.way != sign:
            return 0.0
        while self.modulo and x < self.start:
            x += self.last - self.start
        while self.modulo and x > self.last:
            x -= self.last - self.start
        x = min(max(x, self.start), self.last)
        for n, (left, right) in enumerate(pairwise(self.values)):
            below = self.start + n * self.step
            if below <= x <= below + self.step:
                return self.weight * (left + (right - left) * (x - below) / self.step)
        raise AssertionError(x)


def slow_table(rng: np.random.Generator, index: int) -> SlowTable:
    values = [round(float(value), 6) for value in rng.normal(0, 0.5, int(rng.integers(3, 9)))]
    modulo = index % 3 == 0
    if modulo:
        values[-1] = values[0]
    start, step = float(rng.integers(-300, 100)), float(rng.integers(10, 90))
    weight = round(float(rng.uniform(-2, 2)), 3)
    return SlowTable(
        start, step, values, modulo, (1, 0, -1)[index % 3], weight, (0, 3, 0, 6, 1, 5)[index]
    )


class TestProducts:
    """No page says whether a table adds its own values beside its product: it is left alone."""

    GRID = (0.0, 100.0, 100.0)

    def test_a_product_and_the_table_that_asks_for_it_are_not_counted_but_named(self) -> None:
        text = cec(0, [0.1, 0.2], self.GRID, ("X1", "Z1"), MULT_BY_TABLE=2) + cec(
            1, [0.5, 0.1], self.GRID, ("X1", "W1")
        )
        text += cec(2, [7.0, 9.0], self.GRID, ("X1", "Z1"))
        control = load(text)
        # of X1 on Z1 only the ordinary table is counted; the partner keeps its own values
        assert across(control, "X1", "Z1", [0, 50, 100], UP) == [7.0, 8.0, 9.0]
        assert across(control, "X1", "W1", [0, 50, 100], UP) == pytest.approx(
            [0.5, 0.3, 0.1], abs=EXACT
        )
        named = [note for note in control.notes if "$AN_CEC_MULT_BY_TABLE[0]" in note]
        assert len(named) == 1
        assert "multiplied by table 1" in named[0]

    def test_a_product_with_itself(self) -> None:
        text = cec(3, [0.2, 0.4], self.GRID, MULT_BY_TABLE=4) + eec("AX1", [0.1, 0.1], self.GRID)
        assert at(load(text), "AX1", [0, 100], UP) == [-0.1, -0.1]

    def test_a_product_over_another_axis_stops_nothing(self) -> None:
        text = cec(0, [0.1, 0.2], self.GRID, ("X1", "X1"), MULT_BY_TABLE=2) + cec(
            1, [0.5, 0.1], self.GRID, ("Y1", "Z1")
        )
        control = load(text + eec("X1", [0.001, 0.001], self.GRID))
        assert at(control, "X1", [50], UP) == [-0.001]
        assert control.cross() == (("Y1", "Z1"),)
        assert across(control, "Y1", "Z1", [50], UP) == pytest.approx([0.3], abs=EXACT)

    @pytest.mark.parametrize(
        "asleep",
        [
            "$SN_CEC_TABLE_ENABLE[1]=0\n",
            "$SN_CEC_TABLE_WEIGHT[1]=0\n",
        ],
    )
    def test_what_the_product_with_a_partner_that_sleeps_gives_is_on_no_page(
        self, asleep: str
    ) -> None:
        text = cec(0, [0.1, 0.2], self.GRID, MULT_BY_TABLE=2) + cec(
            1, [0.5, 0.1], self.GRID, ("Y1", "Z1")
        )
        control = load(text + eec("AX1", [0.1, 0.1], self.GRID), asleep)
        assert at(control, "AX1", [0, 100], UP) == [-0.1, -0.1]
        assert any("$AN_CEC_MULT_BY_TABLE[0]" in note for note in control.notes)

    def test_with_a_partner_of_zeros_there_is_no_product(self) -> None:
        zero = cec(0, [0.1, 0.2], self.GRID, MULT_BY_TABLE=2) + cec(
            1, [0.0, 0.0], self.GRID, ("Y1", "Z1")
        )
        assert at(load(zero), "AX1", [0, 100], UP) == [0.1, 0.2]

    def test_a_table_that_is_off_asks_for_no_product(self) -> None:
        text = cec(0, [0.1, 0.2], self.GRID, MULT_BY_TABLE=2) + cec(
            1, [0.5, 0.1], self.GRID, ("Y1", "Z1")
        )
        control = load(text, "$SN_CEC_TABLE_ENABLE[0]=0\n")
        assert at(control, "AX1", [0], UP) == [0.0]
        assert not any("MULT_BY_TABLE" in note for note in control.notes)

    def test_table_to_multiply_by_has_to_be_in_the_files(self) -> None:
        text = cec(0, [0.1, 0.2], self.GRID, MULT_BY_TABLE=3)
        with pytest.raises(
            InputError,
            match=r"\$AN_CEC_MULT_BY_TABLE\[0\] names a table that is not in the files.*index 2",
        ):
            load(text)
        zero = "".join(f"$AN_CEC_{key}[2]=0\n" for key in ("STEP", "MIN", "MAX"))
        assert at(load(text, zero), "AX1", [0], UP) == [0.1]


class TestSwitches:
    GRID = (0.0, 100.0, 100.0)
    TEXT = (
        cec(0, [0.1, 0.2], GRID)
        + cec(1, [0.01, 0.02], GRID)
        + cec(2, [0.001, 0.001], GRID, ("AX1", "AX2"))
    )

    def test_table_is_switched_by_its_last_value(self) -> None:
        off, on = "$SN_CEC_TABLE_ENABLE[0]=0\n", "$SN_CEC_TABLE_ENABLE[0]=1\n"
        assert at(load(off + self.TEXT + on), "AX1", [0], UP) == pytest.approx([0.11], abs=EXACT)
        control = load(on + self.TEXT + off)
        assert at(control, "AX1", [0], UP) == pytest.approx([0.01], abs=EXACT)
        assert any("CEC table 0: SD41300" in note for note in control.notes)

    def test_sum_is_switched_by_the_output_axis(self) -> None:
        off, on = "$MA_CEC_ENABLE[ax1]=0\n", "$MA_CEC_ENABLE[AX1]=1\n"
        control = load(on + off + self.TEXT)
        assert at(control, "AX1", [0], UP) == [0.0]
        assert across(control, "AX1", "AX2", [0], UP) == [0.001]
        assert any("AX1: MD32710" in note for note in control.notes)
        assert at(load(off + self.TEXT + on), "AX1", [0], UP) == pytest.approx([0.11], abs=EXACT)
        control = load(self.TEXT + "$MA_CEC_ENABLE[AX2]=0\n")
        assert across(control, "AX1", "AX2", [0], UP) == [0.0]
        assert control.cross() == (("AX1", "AX2"),)
        assert control.points("AX1").size == 2

    def test_sum_is_limited_and_said_when_it_cuts(self) -> None:
        text = cec(0, [-0.08, 0.06], self.GRID) + cec(1, [-0.05, 0.05], self.GRID)
        wide, narrow = (load(text, f"$MA_CEC_MAX_SUM[AX1]={limit}\n") for limit in (0.13, 0.1))
        assert at(wide, "AX1", [0, 100], UP) == pytest.approx([-0.13, 0.11], abs=EXACT)
        assert wide.notes == ()
        assert at(narrow, "AX1", [0, 50, 100], UP) == pytest.approx([-0.1, -0.01, 0.1], abs=EXACT)
        assert at(
            load(text, "$MA_CEC_MAX_SUM[AX1]=0.1\n", options={"cec_sign": "error"}), "AX1", [0], UP
        ) == [0.1]
        assert [note for note in narrow.notes if "MD32720" in note and "0.13" in note]
        assert not any("MAX_SUM" in assumption.fact for assumption in load(text).assumed)
        # tables of the two directions are never summed
        two = cec(0, [0.08, 0.06], self.GRID, DIRECTION=1) + cec(
            1, [0.05, 0.02], self.GRID, DIRECTION=-1
        )
        assert not any("MD32720" in note for note in load(two, "$MA_CEC_MAX_SUM[AX1]=0.1\n").notes)

    def test_limit_over_tables_that_repeat_counts_their_largest_values(self) -> None:
        # tops at 50 + 100 a and 20 + 70 b: they meet first at 650, outside both grids: 0.1 + 0.02
        text = cec(0, [0.0, 0.1, 0.0], (0.0, 50.0, 100.0), IS_MODULO=1)
        text += cec(1, [0.0, 0.02, 0.0], (-15.0, 35.0, 55.0), IS_MODULO=1)
        assert at(load(text), "AX1", [650], UP) == pytest.approx([0.12], abs=EXACT)
        assert any("MD32720" in note for note in load(text, "$MA_CEC_MAX_SUM[AX1]=0.1199\n").notes)
        assert not any(
            "MD32720" in note for note in load(text, "$MA_CEC_MAX_SUM[AX1]=0.1201\n").notes
        )

    def test_own_and_cross_tables_share_one_limit(self) -> None:
        text = cec(0, [0.08, 0.08], self.GRID) + cec(1, [-0.05, 0.0], self.GRID, ("AX2", "AX1"))
        assert any("MD32720" in note for note in load(text, "$MA_CEC_MAX_SUM[AX1]=0.1\n").notes)
        large = load(cec(0, [1.5, 0.0], self.GRID))
        assert at(large, "AX1", [0], UP) == [1.5]
        assert any("MD32720" in assumption.fact for assumption in large.assumed)

    def test_values_in_inch_are_mm_after_all(self) -> None:
        """MD32711 = 0: values and positions of linear axes in inch, whatever the basic system."""
        inch = cec(0, [0.001, 0.002], (0.0, 10.0, 10.0)) + "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0\n"
        # 10 inch are 254 mm; 0.001 inch 25.4 um; half way at 127 mm 38.1 um
        assert at(load(inch), "AX1", [0, 127, 254], UP) == pytest.approx(
            [0.0254, 0.0381, 0.0508], abs=EXACT
        )
        assert (
            load(
                self.TEXT,
                "$MA_CEC_SCALING_SYSTEM_METRIC[AX3]=0\n$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=1\n",
            ).notes
            == ()
        )

    def test_sign_option_is_one_of_two_words(self) -> None:
        with pytest.raises(UsageError, match="cec_sign"):
            load(self.TEXT, options={"cec_sign": "+"})

    @pytest.mark.parametrize(
        ("line", "says"),
        [
            ("$AN_CEC_TYPE[0]=1\n", r"\$AN_CEC_TYPE\[0\] = 1: .*cylinder error"),
            ("$SN_CEC_0[0]=0.01\n", r"\$SN_CEC_0\[0\] = 0.01: SD41320"),
            ("$SN_CEC_1[0]=0.02\n", r"\$SN_CEC_1\[0\] = 0.02: SD41321"),
            ("$AN_CEC_INPUT_NCU[0]=2\n", r"\$AN_CEC_INPUT_NCU\[0\] = 2: .*another NCU"),
            ("$AN_CEC_OUTPUT_NCU[0]=2\n", r"\$AN_CEC_OUTPUT_NCU\[0\] = 2: .*another NCU"),
        ],
    )
    def test_a_table_that_is_more_than_its_values(self, line: str, says: str) -> None:
        with pytest.raises(InputError, match=says):
            load(self.TEXT, line)
        crossing = cec(0, [0.1, 0.2], self.GRID, ("AX1", "AX2"))
        control = load(crossing + eec("AX1", [0.1, 0.1], self.GRID), line)
        assert control.cross() == ()
        assert at(control, "AX1", [0], UP) == [-0.1]
        # what is off, or nothing, stops nothing
        assert at(load(self.TEXT, line, "$SN_CEC_TABLE_ENABLE[0]=0\n"), "AX1", [0], UP) == [0.01]
        zero = line.split("=", maxsplit=1)[0] + "=0\n"
        assert at(load(self.TEXT, zero), "AX1", [0], UP) == pytest.approx([0.11], abs=EXACT)

    def test_a_table_between_axes_that_is_no_curve_hides_no_other_one(self) -> None:
        # table 0 ends between two points of different values; table 1 of the same axes is a curve
        split = cec(0, [0.1, 0.2, 0.3], (0.0, 100.0, 150.0), ("AX1", "AX2"))
        text = split + cec(1, [0.01, 0.02], self.GRID, ("AX1", "AX2"))
        control = load(text)
        assert control.cross() == (("AX1", "AX2"),)
        assert across(control, "AX1", "AX2", [0, 100], UP) == [0.01, 0.02]
        assert any("CEC table 0" in note and "stays" in note for note in control.notes)

    def test_what_works_out_the_cylinder_error_does_not_act(self) -> None:
        control = load(self.TEXT, "$SN_CEC_BAS_0[0]=5\n$SN_CEC_COMP_STORE_1[0]=7\n")
        assert at(control, "AX1", [0], UP) == pytest.approx([0.11], abs=EXACT)


class TestAControlOfFixedSize:
    """828D: 8 tables of 200 points."""

    def test_index_and_points(self) -> None:
        def load_828d(text: str) -> SinumerikControl:
            return sinumerik_control(
                [ControlFile("a.ini", text.encode())],
                Request(options={"cec_sign": "correction"}),
                room=ROOM_828D,
            )

        two = (0.0, 100.0, 100.0)
        assert at(load_828d(cec(7, [0.1, 0.2], two)), "AX1", [0], UP) == [0.1]
        with pytest.raises(InputError, match="CEC table 8 is none of this control"):
            load_828d(cec(8, [0.1, 0.2], two))
        full = cec(0, [0.001] * 200, (0.0, 1.0, 199.0))
        assert at(load_828d(full), "AX1", [0], UP) == [0.001]
        with pytest.raises(InputError, match="at most 200 points, found 201"):
            load_828d(cec(0, [0.001] * 201, (0.0, 1.0, 200.0)))
        # lines of tables that it does not have, all zero, say nothing
        zero = "".join(f"$AN_CEC_{key}[61]=0\n" for key in ("STEP", "MIN", "MAX"))
        assert at(load_828d(zero + cec(7, [0.1, 0.2], two)), "AX1", [0], UP) == [0.1]


class TestEndlessLeadscrewTable:
    def test_positions_are_taken_modulo_and_the_sign_is_that_of_an_error(self) -> None:
        text = eec("C1", [0.002, -0.004, 0.006, 0.002], (-60.0, 120.0, 300.0), modulo=1)
        # -120 is 240: half of 0.006 and 0.002; 420 is 60; 0 is half way between the first two
        wanted = [0.004, -0.002, 0.001, 0.001, 0.004, -0.004, 0.001]
        control = load(text)
        assert at(control, "C1", [60, -60, 0, 360, 60 - 360, -120, 720], UP) == pytest.approx(
            [0.004, -0.002, 0.001, 0.001, 0.004, -0.004, 0.001], abs=EXACT
        )
        assert at(control, "C1", [420, 300, 0, 360, 780, 240, 720], DOWN) == pytest.approx(
            wanted, abs=EXACT
        )

    def test_ends_that_differ_are_refused_with_the_jump(self) -> None:
        for text in (
            eec("C1", [0.002, -0.004, 0.006, 0.005], (0.0, 120.0, 360.0), modulo=1),
            cec(0, [0.002, -0.004, 0.006, 0.005], (0.0, 120.0, 360.0), ("C1", "C1"), IS_MODULO=1),
        ):
            with pytest.raises(InputError, match=r"jumps by -0\.003 at every turn"):
                load(text)
            once = load(
                text.replace("IS_MODULO[0,C1]=1", "IS_MODULO[0,C1]=0").replace(
                    "IS_MODULO[0]=1", "IS_MODULO[0]=0"
                )
            )
            assert np.abs(at(once, "C1", [500], UP)).tolist() == [0.005]


def changed(old: str, new: str, text: str = SHAPE) -> str:
    assert old in text
    return text.replace(old, new)


def test_points_above_max_are_ignored() -> None:
    """Values greater than k are ignored, that of k holds beyond it (FB2 09/2009 p370)."""
    shorter = load(changed("_MAX[1]=800.0", "_MAX[1]=400.0"))  # the table of travel in +
    where = [-50, 0, 200, 400, 600, 900]
    up, down = [0, 0, 0.001, 0.002, 0.002, 0.002], [0.004, 0.004, 0.0025, 0.001, 0.00175, 0.0025]
    assert at(shorter, "AX1", where, UP) == pytest.approx(up, abs=EXACT)
    assert at(shorter, "AX1", where, DOWN) == pytest.approx(down, abs=EXACT)
    assert any("points 2 to 2 lie above MAX" in note for note in shorter.notes)


class TestContradictions:
    @pytest.mark.parametrize(
        ("text", "says"),
        [
            (changed("$AN_CEC[1,1]=0.002000\n", ""), "missing points"),
            (
                "\n".join(line for line in LINES if not line.startswith("$AN_CEC[1")),
                "CEC table 1 has missing points",
            ),
            ("$AN_CEC[5,0]=0.1\n", "$AN_CEC_STEP, $AN_CEC_MIN, $AN_CEC_MAX"),
            (changed("$AN_CEC_MAX[1]=800.0\n", ""), "$AN_CEC_MAX"),
            (changed("$AN_CEC_DIRECTION[1]=1\n", ""), "$AN_CEC_DIRECTION"),
            (changed("$AN_CEC_INPUT_AXIS[1]=(AX1)\n", ""), "$AN_CEC_INPUT_AXIS"),
            (
                changed("$AN_CEC_OUTPUT_AXIS[1]=(AX1)", "$AN_CEC_OUTPUT_AXIS[1]=()"),
                "$AN_CEC_OUTPUT_AXIS",
            ),
            (changed("_MAX[1]=800.0", "_MAX[1]=810.0"), "whole number"),
            (changed("_MAX[1]=800.0", "_MAX[1]=1200.0"), "missing points"),
            (changed("_MAX[1]=800.0", "_MAX[1]=-1"), "MAX >= MIN"),
            (changed("_STEP[1]=400.0", "_STEP[1]=-400.0"), "STEP > 0"),
            (changed("_STEP[1]=400.0", "_STEP[1]=0.0000000000001"), "too small"),
            (
                changed("_STEP[1]=400.0", "_STEP[1]=1EX-10").replace(
                    "_MAX[1]=800.0", "_MAX[1]=2EX-10"
                ),
                "too small",
            ),
            # half a unit in the last place of 2^29: the second point would fall on the first
            (
                changed("_STEP[1]=400.0", "_STEP[1]=0.000000059604644775390625")
                .replace("_MIN[1]=0.0", "_MIN[1]=536870912")
                .replace("_MAX[1]=800.0", "_MAX[1]=536870912.00000011920928955078125"),
                "too small to change a position as large as MIN",
            ),
            ("$AN_CEC_STEP[3]=0\n$AN_CEC_MIN[3]=0\n", "CEC table 3 is incomplete"),
            (
                "".join(f"$AN_CEC_{key}[3]=0\n" for key in ("STEP", "MIN", "MAX"))
                + "$AN_CEC[3,0]=0.1\n",
                "STEP > 0",
            ),
            (changed("M17", "$AN_CEC[1,0]=0.1\nM17"), "$AN_CEC[1,0] contradicts f0.ini, line 13"),
            (changed("M17", "$AN_CEC_OUTPUT_AXIS[1]=(AX7)\nM17"), "contradicts"),
            (changed("M17", "$AN_CEC_MULT_BY_TABLE[1]=1\nM17"), "contradicts"),
            (changed("M17", "$AN_CEC_DIRECTION[2]=0\nM17"), "contradicts"),
            (changed("M17", "$AN_CEC_IS_MODULO[2]=1\nM17"), "contradicts"),
            (changed("_DIRECTION[1]=1", "_DIRECTION[1]=2"), "0, 1 or -1"),
            (changed("_IS_MODULO[1]=0", "_IS_MODULO[1]=-1"), "0 or 1"),
            (changed("_MULT_BY_TABLE[1]=0", "_MULT_BY_TABLE[1]=1.5"), "index + 1"),
            (changed("_MULT_BY_TABLE[1]=0", "_MULT_BY_TABLE[1]=-1"), "index + 1"),
            (changed("M17", "$MA_CEC_MAX_SUM[AX1]=-0.1\nM17"), "0 or more"),
            (changed("M17", "$SN_CEC_TABLE_ENABLE[1]=2\nM17"), "0 or 1"),
            (changed("M17", "$SN_CEC_TABLE_WEIGHT[1]=1EX12\nM17"), "at most"),
            (
                changed("M17", "$MN_MM_CEC_MAX_POINTS[1]=2\nM17"),
                "MD18342 of CEC table 1 reserves fewer points",
            ),
            (changed("$AN_CEC[1,1]", "$AN_CEC[1.1]"), "[table,point]"),
            (changed("$AN_CEC[1,1]", "$AN_CEC[1]"), "[table,point]"),
            (changed("$AN_CEC[1,1]", "AN_CEC[1,1]"), "cannot be read"),
            (changed("$AN_CEC_DIRECTION[1]", "$AN_CEC_DIRECTOIN[1]"), "is unknown"),
            (changed("$AN_CEC_IS_MODULO[1]", "$AA_CEC_COMP_IS_MODULO[1]"), "is unknown"),
            (changed("_STEP[1]=400.0", "_STEP[1]=(AX1)"), "a number"),
            (changed("_AXIS[1]=(AX1)", "_AXIS[1]=1"), "an axis"),
            (changed("$AN_CEC[1,0]", "M17\n$AN_CEC[1,0]"), "end of the program"),
            (changed("_IS_MODULO[2]=0", "_IS_MODULO[2]=1"), "at every turn"),
        ],
    )
    def test_refused_with_file_and_line(self, text: str, says: str) -> None:
        with pytest.raises(InputError, match=r"f0\.ini: line \d+") as caught:
            load(text)
        assert says in str(caught.value)

    def test_all_faults_of_both_kinds_of_tables_at_once(self) -> None:
        text = (
            changed("_MAX[0]=800.0", "_MAX[0]=810.0")
            .replace("$AN_CEC[1,1]=0.002000\n", "")
            .replace("[2,2]=0.0025", "[2,3]=0.0025")
        )
        with pytest.raises(InputError) as caught:
            load(text, eec("AX1", [0.1, 0.2], (0.0, 30.0, 100.0)))
        assert (
            len(caught.value.faults) == 3
        )  # the table of AX1 on AX2 is no curve, but whole: it is left alone

    def test_zero_values_behind_the_end_are_memory(self) -> None:
        control = load(changed("M17", "$AN_CEC[1,3]=0\n$AN_CEC[1,4]=-0.0\nM17"))
        assert at(control, "AX1", [900], UP) == [-0.0015]
        assert any("CEC table 1: points 3 to 4" in note for note in control.notes)

    def test_a_grid_far_larger_than_the_file_is_refused_quickly(self) -> None:
        lines = [
            "$AN_CEC_INPUT_AXIS[{0}]=(X1)",
            "$AN_CEC_OUTPUT_AXIS[{0}]=(X1)",
            "$AN_CEC_STEP[{0}]=0.001",
            "$AN_CEC_MIN[{0}]=0",
        ]
        lines += ["$AN_CEC_MAX[{0}]=999", "$AN_CEC[{0},0]=0"]
        text = "".join(line.format(index) + "\n" for index in range(300) for line in lines)
        started = time.process_time()
        with pytest.raises(InputError, match="missing points"):
            load(text)
        assert time.process_time() - started < 2.0  # s; 300 million points would take minutes


def archive(points: int = 4000) -> str:
    """Return the text of an archive: machine data, settings, a program, leadscrew tables and sag
    tables, each its own program.
    """
    rng = np.random.default_rng(5)
    machine = "".join(
        f"N{10000 + n} $MN_SOMETHING[{n}]={n * 0.5} '0{n % 10}aF\n" for n in range(8000)
    )
    axes = "".join(
        f"N32450 $MA_BACKLASH[0,AX{n}]=0.00{n}\nN32710 $MA_CEC_ENABLE[AX{n}]=1\n"
        for n in range(1, 10)
    )
    empty = "".join(
        f"$AN_CEC_{key}[{n}]=0\n"
        for n in range(2, 62)
        for key in ("STEP", "MIN", "MAX", "DIRECTION", "IS_MODULO")
    )
    first = eec(
        "AX1", np.round(rng.normal(0, 0.01, points), 6).tolist(), (0.0, 0.25, 0.25 * (points - 1))
    )
    sag = "".join(
        cec(t, np.round(rng.normal(0, 0.01, points), 6).tolist(), (0.0, 0.25, 0.25 * (points - 1)))
        for t in (0, 1)
    )
    return (
        f"%_N_INITIAL_INI\n;$PATH=/_N_NC_ACT_DIR\n{machine}{axes}M17\n"
        f'%_N_O1234_MPF\nN10 G1 X10 F100 MSG("$AN_CEC[")\nM30\n'
        f"%_N_AX1_EEC_INI\nCHANDATA(1)\n{first}M17\n\n"
        f"%_N_NC_CEC_INI\nCHANDATA(1)\n{sag}{empty}M17\n"
    )


class TestArchives:
    def test_each_program_ends_for_itself(self) -> None:
        one = (
            "%_N_AX1_EEC_INI\nCHANDATA(1)\n"
            + eec("AX1", [0.001, 0.002], (0.0, 100.0, 100.0))
            + "M17\n"
        )
        two = "%_N_NC_CEC_INI\n" + cec(0, [0.1, 0.2], (0.0, 100.0, 100.0)) + "M17 '12aB\n"
        control = load(one + two)
        assert at(control, "AX1", [0, 100], UP) == pytest.approx([0.099, 0.198], abs=EXACT)
        assert control.notes == ()
        assert at(load(two + one.replace("%_N", "%_n")), "AX1", [0], UP) == pytest.approx(
            [0.099], abs=EXACT
        )
        with pytest.raises(InputError, match="after the end of the program"):
            load(one + two.replace("%_N_NC_CEC_INI\n", ""))
        with pytest.raises(InputError, match="after the end of the program"):
            load(one + two.replace("%_N_NC_CEC_INI\n", "%\n"))

    def test_program_without_its_end_is_said(self) -> None:
        one = "%_N_AX1_EEC_INI\n" + eec("AX1", [0.001, 0.002], (0.0, 100.0, 100.0))
        control = load(one + "%_N_O1_MPF\nG0 X0\n%_N_O2_MPF\nM30\n")
        assert [note for note in control.notes if "no end" in note] == [
            (
                "f0.ini: no end (M17, M30 or M02) of the program that begins in line 1: it may have"
                " been cut short"
            )
        ]

    def test_load_sequence_in_one_archive_counts_by_its_last_value(self) -> None:
        table = cec(0, [0.1, 0.2], (0.0, 100.0, 100.0))
        off, on = (
            f"%_N_TEA_INI\nN32710 $MA_CEC_ENABLE[AX1]={value} '12aB\nM17\n" for value in (0, 1)
        )
        program = f"%_N_NC_CEC_INI\n{table}M17\n"
        assert at(load(off + program + on), "AX1", [0], UP) == [0.1]
        assert at(load(on + program + off), "AX1", [0], UP) == [0.0]

    def test_untouched_tables_are_one_note(self) -> None:
        control = load(archive(3))
        assert [note for note in control.notes if "CEC tables" in note] == [
            "CEC tables 2 to 61: all zero, the control's own default for no table"
        ]
        assert len(control.addresses()) == 9
        assert at(control, "AX3", [0], DOWN) == [-0.003]

    def test_twenty_thousand_lines_in_well_under_a_second(self) -> None:
        text = archive()
        assert text.count("\n") > 20_000
        fastest = min(seconds(text) for _ in range(3))
        assert fastest < 1.0  # s of processor time; it takes about a fifth of that

    def test_many_tables_do_not_take_the_square_of_their_number(self) -> None:
        text = "".join(
            cec(n, [0.1, 0.2], (0.0, 100.0, 100.0), (f"A{n}", "Z1"), MULT_BY_TABLE=n + 1)
            for n in range(1000)
        )
        assert (
            min(seconds(text) for _ in range(2)) < 2.0
        )  # s; a second loop over all tables would take minutes


def seconds(text: str) -> float:
    started = time.process_time()
    load(text)
    return time.process_time() - started


def ask_everything(content: bytes, *more: bytes) -> None:
    files = [ControlFile(f"{number}.ini", text) for number, text in enumerate((content, *more))]
    try:
        request = Request(options={"cec_sign": "correction"}, carried_out=True)
        control = sinumerik_control(files, request)
    except InputError:
        return
    x = np.linspace(-1e3, 1e3, 7)
    for direction in Direction:
        for address in control.addresses():
            assert np.all(np.isfinite(control.correction(address, x, direction)))
        for base, corrected in control.cross():
            assert np.all(np.isfinite(control.cross_correction(base, corrected, x, direction)))
    for address in control.addresses():
        assert np.all(np.diff(control.points(address)) > 0)


PRODUCT = SHAPE.replace("_MULT_BY_TABLE[0]=0", "_MULT_BY_TABLE[0]=2").replace(
    "M17", "$MA_CEC_MAX_SUM[AX2]=0.015\nM17\n"
)
ENDLESS = (
    "%_N_A_INI\n"
    + eec("C1", [0.002, -0.004, 0.002], (0.0, 180.0, 360.0), modulo=1)
    + "M17\n%_N_B_INI\n"
    + PRODUCT[16:]
)


@st.composite
def damaged(draw: st.DrawFn) -> bytes:
    """Cuts, doublings and replaced bytes of a good file."""
    content = draw(st.sampled_from([SHAPE, PRODUCT, ENDLESS])).encode()
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(content)))
        length = draw(st.integers(0, 40))
        tokens = st.sampled_from(
            [
                b"\n",
                b",",
                b"-",
                b"9",
                b"[",
                b"=",
                b"(",
                b"EX",
                b"EX9",
                b"EX-9",
                b"'",
                b"%_N_X\n",
                b"M17\n",
                b"0",
                b".",
            ]
        )
        new = draw(st.binary(max_size=4) | tokens | st.just(content[start : start + 60]))
        content = content[:start] + new + content[start + length :]
    return content


@given(content=damaged() | st.binary(max_size=300))
@settings(max_examples=200, deadline=None)
def test_any_bytes_are_refused_or_a_control(content: bytes) -> None:
    ask_everything(content)


@given(content=damaged(), other=damaged())
@settings(max_examples=100, deadline=None)
def test_any_bytes_beside_a_good_file(content: bytes, other: bytes) -> None:
    ask_everything(SHAPE.encode(), content)
    ask_everything(content, other)


NUMBER = st.floats(-1e12, 1e12) | st.sampled_from([0.0, 1.0, -1.0, 2.0, 100.0, 1e9, 1e-9, 1e-320])


@given(
    numbers=st.lists(NUMBER, min_size=8, max_size=8),
    whole=st.lists(st.sampled_from(["0", "1", "2", "-1"]), min_size=3, max_size=3),
)
@settings(max_examples=100, deadline=None)
def test_any_numbers_are_refused_or_a_finite_control(
    numbers: list[float], whole: list[str]
) -> None:
    low, step, high, *values = (f"{number:.15e}".replace("e", "EX") for number in numbers)
    text = "".join(f"$AN_CEC[0,{n}]={value}\n" for n, value in enumerate(values[:3]))
    text += "$AN_CEC_INPUT_AXIS[0]=(X)\n$AN_CEC_OUTPUT_AXIS[0]=(X)\n"
    text += f"$AN_CEC_MIN[0]={low}\n$AN_CEC_STEP[0]={step}\n$AN_CEC_MAX[0]={high}\n"
    text += "".join(
        f"$AN_CEC_{key}[0]={value}\n"
        for key, value in zip(("DIRECTION", "MULT_BY_TABLE", "IS_MODULO"), whole, strict=True)
    )
    ask_everything(
        (text + f"$SN_CEC_TABLE_WEIGHT[0]={values[3]}\n$MA_CEC_MAX_SUM[X]={values[4]}\n").encode()
    )
