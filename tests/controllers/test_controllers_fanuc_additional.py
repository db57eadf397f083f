"""The virtual FANUC: what acts beside pitch data and 1851, paths, units, and the families of
controls, with numbers of the manuals' examples and numbers worked by hand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

import numpy as np
import pytest

from compwright.controllers.virtual_control import VirtualControl, virtual_control
from compwright.foundations.errors import InputError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile
from virtual_fanuc import VirtualFanuc, loaded

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
UM = {"detection_unit": 0.001}
# Whole detection units, or halves of them, times the unit: only the rounding of doubles remains. mm
EXACT = 1e-13


def control(text: str, form: str = "fanuc-30i", **request: Any) -> VirtualControl:
    file = ControlFile("ALL.TXT", text.encode("ascii"))
    return virtual_control(form, [file], **{"options": UM, **request})


def um(
    box: VirtualControl, positions: Sequence[float], direction: Direction = UP, address: str = "1"
) -> list[float]:
    """Corrections in µm, or in thousandths of a degree."""
    return [
        round(1000 * float(v), 7) for v in box.correction(address, np.array(positions), direction)
    ]


def grid(
    reference: int, first: int, last: int, interval: float, axis: int = 1, factor: int = 1
) -> str:
    return "".join(
        f"N0{number}Q1A{axis}P{value}\n"
        for number, value in zip(
            range(3620, 3625), (reference, first, last, factor, interval), strict=True
        )
    )


def points(values: Mapping[int, int]) -> str:
    return "".join(f"N{10000 + number}Q0P{value}\n" for number, value in values.items())


def lines(at: Sequence[int], amounts: Sequence[int], axis: int = 1) -> str:
    return "".join(f"N0{5861 + i}Q1A{axis}P{n}\n" for i, n in enumerate(at)) + "".join(
        f"N0{5871 + i}Q1A{axis}P{n}\n" for i, n in enumerate(amounts)
    )


def tape(*parts: str) -> str:
    return "%\n" + "".join(parts) + "%\n"


def flat(first: int, last: int) -> str:
    return points(dict.fromkeys(range(first, last + 1), 0))


class TestInclination:
    # nodes of 37 .. 44 at reference 40 and 50 mm: -150 .. 200, the lower end of 37 at -200
    BENT = tape(grid(40, 37, 44, 50.0), lines((37, 40, 42, 44), (10, 4, 4, -2)), flat(37, 44))
    POINTS = (-200, -150, -100, -50, 0, 50, 100, 150, 200)
    COUNTED: ClassVar[dict[str, Any]] = {"options": {**UM, "inclination": "available"}}

    def test_left_as_it_is_and_named_unless_it_is_to_count(self) -> None:
        box = control(self.BENT)
        assert um(box, self.POINTS) == [0.0] * 9
        assert any("5871: 10" in note and "not counted" in note for note in box.notes)
        assert not any("inclination" in fact.fact for fact in box.assumed)

    def test_three_straight_lines_through_four_points(self) -> None:
        box = control(self.BENT, **self.COUNTED)
        # 10 at 37, 4 at 40 and 42, -2 at 44, held below 37; less the 4 of the reference
        assert um(box, self.POINTS) == [6, 6, 4, 2, 0, 0, 0, -3, -6]
        assert um(box, (1000, -1000)) == [-6, 6]
        assert any("inclination of 1" in fact.fact for fact in box.assumed)
        assert not any("inclination" in note for note in box.notes)

    def test_comes_at_the_pitch_intervals(self) -> None:
        assert um(control(self.BENT, **self.COUNTED), (124.9, 125.1, 174.9, 175.1)) == [
            0,
            -3,
            -3,
            -6,
        ]
        ramp = control(self.BENT, options={**UM, "inclination": "available", "output": "ramp"})
        assert um(ramp, (125.0, 162.5)) == [-1.5, -3.75]

    def test_is_added_to_the_pitch_data_and_not_magnified(self) -> None:
        text = tape(
            grid(40, 37, 44, 50.0, factor=5),
            lines((37, 40, 42, 44), (10, 4, 4, -2)),
            points({37: 1, 38: 0, 39: -2, 40: 1, 41: 2, 42: 1, 43: 0, 44: -1}),
        )
        totals = (0, 1, 1, -1, 0, 2, 3, 3, 2)
        inclined = (6, 6, 4, 2, 0, 0, 0, -3, -6)
        wanted = [5 * total + line for total, line in zip(totals, inclined, strict=True)]
        assert um(control(text, **self.COUNTED), self.POINTS) == wanted
        minus = control(text, options={**UM, "inclination": "available", "pitch_sign": "-"})
        assert um(minus, self.POINTS) == [-value for value in wanted]

    def test_numbers_of_the_manual(self) -> None:
        # B-64523EN-1/02 1.3.8: first 512, reference 602, last 767: more than 128 points. 10 mm apart
        text = tape(
            grid(602, 512, 767, 10.0), lines((512, 602, 700, 767), (0, 90, 90, 23)), flat(512, 767)
        )
        at = [10.0 * (number - 602) for number in (512, 557, 602, 700, 733, 767)]
        assert um(control(text, **self.COUNTED), at) == [-90, -45, 0, 0, -33, -67]

    def test_two_points_are_a_line(self) -> None:
        text = tape(grid(40, 37, 44, 50.0), lines((37, 37, 44, 44), (0, 0, 14, 14)), flat(37, 44))
        assert um(control(text, **self.COUNTED), (-150, 0, 50, 200)) == [-6, 0, 2, 8]

    @pytest.mark.parametrize(
        ("at", "amounts", "says"),
        [
            ((37, 44, 42, 43), (1, 2, 3, 4), "ascending"),
            ((37, 37, 42, 43), (1, 2, 3, 4), "ascending"),
            ((0, 0, 0, 0), (0, 0, 3, 0), "ascending"),
            ((37, 40, 42, 44), (1, 2, 3, 40000), "32767"),
        ],
    )
    def test_what_is_no_line_is_refused(
        self, at: tuple[int, ...], amounts: tuple[int, ...], says: str
    ) -> None:
        text = tape(grid(40, 37, 44, 50.0), lines(at, amounts), flat(37, 44))
        with pytest.raises(InputError, match=f"587[1-4].*{says}|{says}.*587[1-4]"):
            control(text, **self.COUNTED)
        control(text)  # where it does not count it stops nothing

    def test_switched_off_pitch_data(self) -> None:
        off = self.BENT.replace("N03623Q1A1P1", "N03623Q1A1P0")
        with pytest.raises(InputError, match="3623 = 0: it is unknown whether it is active"):
            control(off, **self.COUNTED)
        assert um(control(off), (100,)) == [0.0]
        for old, new in (("N03622Q1A1P44", "N03622Q1A1P37"), (grid(40, 37, 44, 50.0), "")):
            other = self.BENT.replace(old, new).replace("%\n", "%\nN01851Q1A1P4\n", 1)
            with pytest.raises(
                InputError, match="without a grid: it is unknown whether it is active"
            ):
                control(other.replace("N03620Q1A1P40", "N03620Q1A1P37"), **self.COUNTED)

    def test_turn_has_to_close(self) -> None:
        def turning(end: int) -> str:
            return tape(
                "N01006Q1A1P00000001\n",
                grid(60, 60, 68, 45.0),
                lines((60, 62, 64, 68), (0, 4, 8, end)),
                flat(60, 68),
            )

        box = control(turning(0), **self.COUNTED)
        assert um(box, (45, 90, 180, 315, 360, 405)) == [2, 4, 8, 2, 0, 2]
        with pytest.raises(InputError, match="5871 to 5874 of axis 1 adds up to 3"):
            control(turning(3), **self.COUNTED)

    def test_zero_says_nothing(self) -> None:
        box = control(
            tape(grid(40, 37, 44, 50.0), lines((1, 5, 3, 2), (0, 0, 0, 0)), flat(37, 44)),
            **self.COUNTED,
        )
        assert um(box, self.POINTS) == [0.0] * 9
        assert not any("inclination" in note for note in box.notes)


class TestCycle:
    # A-78868E page 6: 14985 = 10, 14986 = 20, 14987 = 2.0, and the amounts of numbers 10 to 20
    AMOUNTS: ClassVar[dict[int, int]] = dict(
        zip(range(10, 21), (0, 1, 1, 1, -1, -1, -1, -1, -1, 1, 1), strict=True)
    )
    PARAMETERS = "N14985Q1A1P10\nN14986Q1A1P20\nN14987Q1A1P2.0\n"
    TURN: ClassVar[dict[int, int]] = {
        60: -1,
        61: 2,
        62: 1,
        63: 0,
        64: -3,
        65: -1,
        66: 2,
        67: 0,
        68: -1,
    }
    WHOLE = tape(
        "N01006Q1A1P00000001\n",
        grid(60, 60, 68, 45.0),
        PARAMETERS,
        points({**AMOUNTS, **TURN}),
    )
    COUNTED: ClassVar[dict[str, Any]] = {"options": {**UM, "cyclic": "available"}}

    def test_left_as_it_is_and_named_unless_it_is_to_count(self) -> None:
        box = control(self.WHOLE)
        assert um(box, (6.0, 46.0)) == [0, 2]
        assert any("14986: 20" in note and "not counted" in note for note in box.notes)
        assert not any("no axis uses them" in note for note in box.notes)

    def test_example_of_the_report(self) -> None:
        box = control(self.WHOLE.replace("N03623Q1A1P1", "N03623Q1A1P0"), **self.COUNTED)
        within = (0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20)
        assert um(box, within) == [0, 1, 2, 3, 2, 1, 0, -1, -2, -1, 0]
        assert um(box, (6.9, 7.1, 26, -2, 366)) == [3, 2, 3, -1, 3]
        assert any(fact.evidence == "unconfirmed" for fact in box.assumed)

    def test_is_superposed_on_the_turn(self) -> None:
        # 46: the node 45 of the main table holds 2, and 46 is 6 within the third period: 3
        assert um(control(self.WHOLE, **self.COUNTED), (46.0, 92.0)) == [5, 3]

    def test_ramp(self) -> None:
        box = control(self.WHOLE, options={**UM, "cyclic": "available", "output": "ramp"})
        assert um(box, (1.0,)) == [round(0.5 + 2 / 45, 7)]

    def test_linear_axis(self) -> None:
        text = tape(grid(60, 57, 62, 100.0), self.PARAMETERS, points(self.AMOUNTS), flat(57, 62))
        assert um(control(text, **self.COUNTED), (-2.0, 6.0)) == [-1, 3]

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("N10015Q0P-1\n", "N10015Q0P0\n", "add up to 1 "),
            ("N10015Q0P-1\n", "", "N10015"),
            ("N14987", "N14988Q1A1P2\nN14987", "what 14988 does"),
            ("14986Q1A1P20", "14986Q1A1P10", "14985 below 14986"),
            ("14987Q1A1P2.0", "14987Q1A1P0.0", "14987 above 0"),
            ("14987Q1A1P2.0", "14987Q1A1P7.0", "whole number of its periods of 70"),
        ],
    )
    def test_what_does_not_close_is_refused(self, old: str, new: str, says: str) -> None:
        assert old in self.WHOLE
        with pytest.raises(InputError, match=says):
            control(self.WHOLE.replace(old, new), **self.COUNTED)


class TestStraightness:
    PAIR = (
        "N05711Q1P1\nN05721Q1P2\n"
        + "".join(f"N0{5731 + i}Q1P{n}\n" for i, n in enumerate((37, 40, 42, 44)))
        + "".join(f"N0{5761 + i}Q1P{n}\n" for i, n in enumerate((10, 4, 4, -2)))
    )
    WHOLE = tape("N01851Q1A1P0A2P0\n", grid(40, 37, 44, 50.0), PAIR, flat(37, 44))
    COUNTED: ClassVar[dict[str, Any]] = {"options": {**UM, "straightness": "available"}}

    def test_left_as_it_is_and_named_unless_it_is_to_count(self) -> None:
        box = control(self.WHOLE)
        assert box.cross() == ()
        for axis in ("axis 1", "axis 2"):
            assert any(axis in note and "straightness" in note for note in box.notes)

    def test_bends_the_other_axis_over_the_points_of_the_moving_one(self) -> None:
        box = control(self.WHOLE, **self.COUNTED)
        assert box.cross() == (("1", "2"),)
        at = np.array([-200.0, -150, -125, -100, 0, 100, 150, 200, 900])
        for direction in (UP, DOWN):
            got = 1000 * box.cross_correction("1", "2", at, direction)
            assert got == pytest.approx([6, 6, 5, 4, 0, 0, -3, -6, -6], abs=1e3 * EXACT)
        assert um(box, (-150, 200)) == [0, 0]

    def test_begins_at_the_lower_end_of_the_first_section(self) -> None:
        pair = self.WHOLE.replace("N05731Q1P37", "N05731Q1P36")
        shift = control(pair, **self.COUNTED).cross_correction("1", "2", np.array([-200.0]), UP)
        assert 1000 * shift == pytest.approx([6], abs=1e3 * EXACT)
        third = control(pair, **self.COUNTED).cross_correction("1", "2", np.array([-150.0]), UP)
        assert 1000 * third == pytest.approx(
            [4.5], abs=1e3 * EXACT
        )  # 10 less a quarter of 6, less 4

    def test_counts_in_the_unit_of_the_bent_axis(self) -> None:
        box = control(self.WHOLE, **self.COUNTED, axis_options={"2": {"detection_unit": 0.0001}})
        got = 1000 * box.cross_correction("1", "2", np.array([-150.0]), UP)
        assert got == pytest.approx([0.6], abs=1e3 * EXACT)

    def test_by_path(self) -> None:
        by_path = self.WHOLE.replace("Q1P", "Q1L2P")
        with pytest.raises(InputError, match="the axis that 5711 names is unknown"):
            control(by_path, **self.COUNTED)
        homes = "N00981Q1A1P2A2P2A3P1\n"
        assert control(by_path.replace("%\n", "%\n" + homes, 1), **self.COUNTED).cross() == (
            ("1", "2"),
        )
        other = "N00981Q1A1P1A2P2A3P2\n"  # the first axis of path 2 is axis 2
        with pytest.raises(InputError, match="the axis that 5711 names is unknown"):
            control(by_path.replace("%\n", "%\n" + other, 1), **self.COUNTED)

    @pytest.mark.parametrize("number", [5714, 5724, 5735, 5768, 5791, 13301, 13371, 13399])
    def test_more_of_it_is_not_known(self, number: int) -> None:
        more = self.WHOLE.replace("N05711", f"N{number:05d}Q1L1P7\nN05711")
        with pytest.raises(InputError, match=f"what {number} does in straightness"):
            control(more, **self.COUNTED)
        assert control(more).cross() == ()

    def test_zero_says_nothing(self) -> None:
        zero = self.WHOLE.replace("Q1P", "Q1L2P")
        for i, amount in enumerate((10, 4, 4, -2)):
            zero = zero.replace(f"N0{5761 + i}Q1L2P{amount}\n", f"N0{5761 + i}Q1L2P0\n")
        assert control(zero, **self.COUNTED).cross() == ()

    def test_moving_axis_without_points_that_act(self) -> None:
        with pytest.raises(InputError, match="moves with axis 1, whose points are not active"):
            control(self.WHOLE.replace("N03623Q1A1P1", "N03623Q1A1P0"), **self.COUNTED)

    def test_nobody_asks_for_it(self) -> None:
        box = control(
            self.WHOLE.replace("A2P0\n", "A2P0A3P0\n"), **self.COUNTED, axes_under_work=("3",)
        )
        assert box.cross() == ()


class TestBacklash:
    TEXT = tape("N01800Q1L1P00010000\nN01851Q1A1P12\nN01852Q1A1P20\n")

    def test_motion_says_which_one_acts(self) -> None:
        assert um(control(self.TEXT), (0,), DOWN) == [-12]
        rapid: dict[str, Any] = {"options": {**UM, "motion": "rapid"}}
        assert um(control(self.TEXT, **rapid), (0,), DOWN) == [-20]
        one_value = self.TEXT.replace("P00010000", "P00000000")
        assert um(control(one_value, **rapid), (0,), DOWN) == [-12]

    def test_smooth_backlash_is_named(self) -> None:
        box = control(self.TEXT.replace("N01851", "N01848Q1A1P500\nN01851"))
        assert any("smooth backlash" in note and "1848: 500" in note for note in box.notes)
        assert not any("smooth" in note for note in control(self.TEXT).notes)


def test_totals_stop_only_a_table_that_acts() -> None:
    text = tape("N03602Q1P00000001\nN01851Q1A1P4\n", grid(40, 37, 44, 50.0), flat(37, 44))
    with pytest.raises(InputError, match="3602: 00000001"):
        control(text)
    assert um(control(text.replace("N03623Q1A1P1", "N03623Q1A1P0")), (0,), DOWN) == [-4]


class TestPaths:
    TABLE = (
        grid(40, 37, 44, 2.0),
        points({37: 1, 38: 0, 39: -2, 40: 1, 41: 2, 42: 1, 43: 0, 44: -1}),
    )

    def test_unit_system_by_path(self) -> None:
        apart = "N01001Q1L1P00000000L2P00000001\n"
        with pytest.raises(InputError, match=r"1001#0.*981 of axis 1") as caught:
            control(tape(apart, *self.TABLE))
        assert "L1 00000000, L2 00000001" in str(caught.value)
        first = control(tape("N00981Q1A1P1\n", apart, *self.TABLE))
        second = control(tape("N00981Q1A1P2\n", apart, *self.TABLE))
        assert first.points("1")[-1] == 8.0
        assert second.points("1")[-1] == pytest.approx(8.0 * 25.4, abs=1e-9)
        alike = control(tape(apart.replace("L1P00000000", "L1P00000001"), *self.TABLE))
        assert alike.points("1")[-1] == pytest.approx(8.0 * 25.4, abs=1e-9)

    def test_rapid_backlash_by_path(self) -> None:
        bits = "N01800Q1L1P00000000L2P00010000\n"
        with pytest.raises(InputError, match="1800#4"):
            control(tape(bits, "N01851Q1A1P12\nN01852Q1A1P20\n"))
        assert um(control(tape(bits, "N01851Q1A1P12\nN01852Q1A1P12\n")), (0,), DOWN) == [-12]
        own = tape("N00981Q1A1P2\n", bits, "N01851Q1A1P12\nN01852Q1A1P20\n")
        assert um(control(own, options={**UM, "motion": "rapid"}), (0,), DOWN) == [-20]

    def test_neighbour_stops_nothing(self) -> None:
        text = tape(
            "N01800Q1L1P00000000L2P00010000\nN01851Q1A1P12A2P4\nN01852Q1A1P12A2P9\n",
            *self.TABLE,
        )
        box = control(text, axes_under_work=("1",))
        assert um(box, (8.0,)) == [2]
        with pytest.raises(InputError, match="1800#4"):
            control(text, axes_under_work=("2",))


class TestDetectionUnit:
    @pytest.mark.parametrize(
        ("system", "code", "unit"),
        [
            ("00000000", 2, 0.001),
            ("00000000", 20, 0.0001),
            ("00000000", 1, 0.002),
            ("00000000", 96, 0.001 / 48),
            ("00000000", 101, 0.001),
            ("00000000", 102, 0.002),
            ("00000000", 127, 0.027),
            ("00000001", 2, 0.01),
            ("00000010", 2, 0.0001),
            ("00000010", 20, 0.00001),
            ("00000100", 2, 0.00001),
            ("00001000", 2, 0.000001),
        ],
    )
    def test_by_1820_and_1013(self, system: str, code: int, unit: float) -> None:
        text = tape(f"N01013Q1A1P{system}\nN01820Q1A1P{code}\nN01851Q1A1P10\n")
        box = control(text, options={})
        assert box.correction("1", np.zeros(1), DOWN)[0] == pytest.approx(-10 * unit, rel=1e-12)
        fine = any("unconfirmed" in fact.evidence for fact in box.assumed)
        assert fine == (system in ("00000100", "00001000"))

    @pytest.mark.parametrize("code", [0, 97, 100, 128, -2])
    def test_other_codings_are_not_taken(self, code: int) -> None:
        text = tape(f"N01013Q1A1P00000000\nN01820Q1A1P{code}\nN01851Q1A1P10\n")
        assert um(control(text), (0,), DOWN) == [-10]  # by the option alone
        assert not any("detection unit" in fact.fact for fact in control(text).assumed)

    def test_1004_speaks_on_older_series_alone(self) -> None:
        text = tape("N01004P00000000\nN01820A1P2\nN01851A1P10\n")
        assert um(control(text, form="fanuc-0i-16i", options={}), (0,), DOWN) == [-10]
        for form in ("fanuc-30i", "fanuc-0i-d", "fanuc-0i-f"):
            assert um(control(text, form=form, options={"detection_unit": 0.0001}), (0,), DOWN) == [
                -1
            ]

    def test_inch_machine(self) -> None:
        text = tape("N01001Q1P00000001\nN01013Q1A1P00000000\nN01820Q1A1P2\nN01851Q1A1P10\n")
        linear = control(text, options={}, kinds={"1": AxisKind.LINEAR})
        assert um(linear, (0,), DOWN) == pytest.approx([-25.4], abs=1e-6)
        turning = control(text, options={}, kinds={"1": AxisKind.ROTARY})
        assert um(turning, (0,), DOWN) == [-10]


class TestFamilies:
    # B-64303CM-1/01 p. 26 (0i-D): numbers 31 to 37, reference 33; its figure goes from -2 to 3
    AMOUNTS: ClassVar[dict[int, int]] = {31: -3, 32: 1, 33: 1, 34: 1, 35: 2, 36: -1, 37: -3}
    FIGURE: ClassVar[dict[int, int]] = {-30: 1, -20: -2, -10: -1, 0: 0, 10: 1, 20: 3, 30: 2, 40: -1}
    TEXT = tape(grid(33, 31, 37, 10.0), points(AMOUNTS))

    @pytest.mark.parametrize("form", ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"])
    def test_figure_of_the_manual(self, form: str) -> None:
        assert um(control(self.TEXT, form=form), list(self.FIGURE)) == list(self.FIGURE.values())

    @pytest.mark.parametrize("form", ["fanuc-0i-d", "fanuc-0i-f"])
    def test_switched_off_by_8135(self, form: str) -> None:
        off = self.TEXT.replace("%\n", "%\nN08135Q1P00000001\nN01851Q1A1P4\n", 1)
        with pytest.raises(InputError, match="8135#0 = 1 switches stored pitch error"):
            control(off, form=form)
        assert um(control(off), (10,)) == [1]  # another parameter elsewhere
        on = control(off.replace("P00000001", "P00000010"), form=form)
        assert um(on, (10,), DOWN) == [-3]
        table_off = control(off.replace("N03623Q1A1P1", "N03623Q1A1P0"), form=form)
        assert um(table_off, (10,), DOWN) == [-4]

    def test_limits(self) -> None:
        eight = self.TEXT.replace("N10035Q0P2", "N10035Q0P8")
        for form in ("fanuc-0i-d", "fanuc-0i-f"):
            with pytest.raises(InputError, match="-7 to 7"):
                control(eight, form=form)
            control(eight, form=form, options={**UM, "increment_limit": "127"})
            with pytest.raises(InputError, match="no decimal point"):
                control(self.TEXT.replace("P10.0", "P10"), form=form)
        more = self.TEXT.replace("N10035", "N11024Q0P0\nN10035")
        with pytest.raises(InputError, match="0 to 1023"):
            control(more, form="fanuc-0i-d")
        control(more, form="fanuc-0i-f")

    OLDEST = "%;\n" + "".join(
        f"N0{number}A1P{value}\n"
        for number, value in zip(range(5420, 5425), (33, 31, 37, 1, 10.0), strict=True)
    )

    def test_15i_has_numbers_of_its_own(self) -> None:
        text = self.OLDEST + "N01851A1P4\nN03621A1P5\nN03605P00000001\n%\n"
        file = [ControlFile("PARAM.TXT", text.encode())]
        data = "%\n" + "".join(f"N{10000 + n}P{v}\n" for n, v in self.AMOUNTS.items()) + "%\n"
        file.append(ControlFile("PITCH.TXT", data.encode()))
        box = virtual_control("fanuc-15i", file, options=UM)
        assert um(box, list(self.FIGURE)) == list(self.FIGURE.values())
        assert um(box, (0,), DOWN) == [-4]

    def test_15i_speaks_of_its_own_numbers(self) -> None:
        with pytest.raises(InputError, match="parameters 5424") as caught:
            control(self.OLDEST.replace("N05424A1P10.0\n", "") + "%\n", form="fanuc-15i")
        assert "36" not in str(caught.value)

    def test_15i_at_rapid_traverse(self) -> None:
        text = "%\nN01800P00010000\nN01851A1P4\nN01852A1P9\n%\n"
        rapid: dict[str, Any] = {"form": "fanuc-15i", "options": {**UM, "motion": "rapid"}}
        with pytest.raises(InputError, match="whether 1852 is active on axis 1"):
            control(text, **rapid)
        assert um(control(text.replace("P9", "P4"), **rapid), (0,), DOWN) == [-4]
        assert um(control(text, form="fanuc-15i"), (0,), DOWN) == [-4]

    @pytest.mark.parametrize("line", ["N05426A1P50\n", "N05481A1P3\n", "N05441P2\n"])
    def test_15i_unknown_is_refused(self, line: str) -> None:
        text = self.OLDEST + points(self.AMOUNTS) + line + "%\n"
        with pytest.raises(InputError, match=line[2:6]):
            control(text, form="fanuc-15i")
        control(text.replace(line, line.replace(line[line.index("P") :], "P0\n")), form="fanuc-15i")


def test_rotary_axis_without_the_copy_of_its_last_section() -> None:
    """B of a real backup: reference 300, first 301, last 312, 30 degrees."""
    amounts = dict(zip(range(301, 313), (2, 1, 0, -3, -1, 2, 0, -1, 3, 0, -2, -1), strict=True))
    text = tape("N01006Q1A5P00000001\n", grid(300, 301, 312, 30.0, axis=5), points(amounts))
    box = control(text)
    wanted = [int(total) for total in np.cumsum([0, *amounts.values()])]
    assert um(box, [30.0 * i for i in range(13)], address="5") == wanted
    assert um(box, (-30.0, 390.0), address="5") == [1, 2]


@pytest.mark.parametrize("seed", range(12))
def test_agrees_with_the_virtual_control_of_the_tests(seed: int) -> None:
    """Two readers written apart from the same pages, on random tables with all three functions."""
    rng = np.random.default_rng(seed)
    first, count = int(rng.integers(5, 40)), int(rng.integers(6, 30))
    last, interval = first + count, float(rng.integers(4, 40))
    reference = int(rng.integers(first, last))
    at = np.sort(rng.choice(np.arange(first, last + 1), 4, replace=False))
    period = rng.integers(-7, 8, 6)
    amounts = [int(v) for v in rng.integers(-90, 90, 4)]
    text = tape(
        "N01013Q1A1P00000000A2P00000010\nN01820Q1A1P20A2P102\nN01800Q1P00010000\n",
        "N01851Q1A1P7A2P0\nN01852Q1A1P-3A2P0\n",
        grid(reference, first, last, interval, factor=int(rng.integers(1, 11))),
        lines([int(n) for n in at], [int(v) for v in rng.integers(-90, 90, 4)]),
        f"N14985Q1A1P100\nN14986Q1A1P107\nN14987Q1A1P{float(rng.integers(1, 9))}\n",
        "N05711Q1L1P1\nN05721Q1L1P2\n",
        *(f"N0{5731 + i}Q1L1P{n}\nN0{5761 + i}Q1L1P{amounts[i]}\n" for i, n in enumerate(at)),
        points({first + i: int(v) for i, v in enumerate(rng.integers(-7, 8, count + 1))}),
        points({100 + i: int(v) for i, v in enumerate([0, *period, -period.sum()])}),
    )
    counted = {"inclination": "available", "cyclic": "available", "straightness": "available"}
    wide = {"increment_limit": "127"}
    other = VirtualFanuc(loaded([text.encode()]))
    x = rng.uniform(-700, 700, 500)
    for motion in ("feed", "rapid"):
        box = control(text, options={**counted, **wide, "motion": motion})
        for direction in Direction:
            theirs = other.correction(1, x, direction.sign, rapid=motion == "rapid")
            assert box.correction("1", x, direction) == pytest.approx(theirs, abs=EXACT)
    nodes = interval * np.arange(first - 1 - reference, last + 1 - reference, dtype=np.float64)
    bent = other.straightness(1, nodes)[2]
    assert box.cross_correction("1", "2", nodes, UP) == pytest.approx(bent, abs=EXACT)


class TestTypedSheet:
    """Rows of lines and of the second table, as an engineer types them."""

    ROWS = (
        "# address: 4\n# value: correction\npoint,position,value,unit\n"
        "1851,,0,pulse\n3620,,40,\n3621,,40,\n3622,,44,\n3623,,1,\n3624,,90.0,deg\n3625,,360.0,deg\n"
        "5861,,40,\n5862,,40,\n5863,,44,\n5864,,44,\n5871,,0,\n5872,,0,pulse\n5873,,0,\n5874,,0,\n"
        "14985,,100,\n14986,,104,\n14987,,5.0,\n"
        + "".join(f"{10000 + n},,0,pulse\n" for n in range(40, 45))
        + "10100,,0,pulse\n10101,,3,pulse\n10102,,-1,pulse\n10103,,-2,pulse\n10104,,0,pulse\n"
    )
    COUNTED: ClassVar[dict[str, Any]] = {**UM, "cyclic": "available", "inclination": "available"}

    def box(self, text: str, form: str = "fanuc-30i") -> VirtualControl:
        kinds, modulo = {"4": AxisKind.ROTARY}, {"4": 360.0}
        file = ControlFile("entry_B.csv", text.encode())
        return virtual_control(form, [file], options=self.COUNTED, kinds=kinds, modulo=modulo)

    def test_rows_of_the_second_table(self) -> None:
        # 3, -1, -2 and 0 in the four sections of 5 degrees of a period
        for text in (self.ROWS, self.ROWS.replace("5.0,\n", "5.0,deg\n")):
            box = self.box(text)
            assert um(box, (0, 5, 10, 15, 20, 25, 345), address="4") == [0, 3, 2, 0, 0, 3, 3]

    def test_rows_of_lines(self) -> None:
        # 0 at both ends of the turn, 6 at number 42 (180 degrees), straight between
        bent = self.ROWS.replace("5863,,44,\n", "5863,,42,\n").replace("5873,,0,", "5873,,6,")
        straight = bent.replace("14985,,100,", "14985,,0,").replace("14986,,104,", "14986,,0,")
        straight = straight.replace("14987,,5.0,", "14987,,0.0,")
        assert um(self.box(straight), (0, 90, 180, 270, 360), address="4") == [0, 3, 6, 3, 0]

    @pytest.mark.parametrize(
        ("old", "new", "fault"),
        [
            ("14985,,100,\n", "14985,,100,pulse\n", "line 19: the unit of parameter 14985"),
            ("14987,,5.0,\n", "14987,20,5.0,\n", "line 21: parameter 14987 has a position"),
            ("14987,,5.0,\n", "14987,,5.0,mm\n", "unit of parameter 14987"),
            ("5871,,0,\n", "5871,,0,deg\n", "line 15: the unit of parameter 5871"),
            ("14987,,5.0,\n", "14987,,5.0,\n14987,,30.0,\n", "14987 .*contradicts"),
        ],
    )
    def test_rows_that_cannot_be_meant(self, old: str, new: str, fault: str) -> None:
        with pytest.raises(InputError, match=fault):
            self.box(self.ROWS.replace(old, new))


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("N01820Q1A1P2\n", "N01820Q1A1P20\n"),
        ("N05871Q1A1P10\n", "N05871Q1A1P12\n"),
        ("N14987Q1A1P2.0\n", "N14987Q1A1P4.0\n"),
        ("N00981Q1A1P1\n", "N00981Q1A1P2\n"),
    ],
)
def test_one_number_with_two_values_is_refused(first: str, second: str) -> None:
    """Two dumps one after the other, or two files: nobody knows which one is in the control."""
    start = tape("N01013Q1A1P00000010\nN01851Q1A1P4\n", first)
    files = [ControlFile("A.TXT", start.encode()), ControlFile("B.TXT", tape(second).encode())]
    number, options = first[1:6].lstrip("0"), {} if "1820" in first else UM
    with pytest.raises(
        InputError, match=rf"B\.TXT: line 2: .*{number}.*contradicts A\.TXT, line 4"
    ):
        virtual_control("fanuc-30i", files, options=options)
    same = [files[0], ControlFile("B.TXT", tape(first).encode())]
    assert virtual_control("fanuc-30i", same, options=options).addresses() == ("1",)


def test_a_contradiction_stops_the_axis_that_it_may_hold_for() -> None:
    def two(first: str, second: str, *asked: str) -> VirtualControl:
        start = tape("N01851Q1A1P4A2P6\n", first).encode()
        files = [ControlFile("A.TXT", start), ControlFile("B.TXT", tape(second).encode())]
        return virtual_control("fanuc-30i", files, options=UM, axes_under_work=asked)

    with pytest.raises(InputError, match="5871 of A2 contradicts"):
        two("N05871Q1A2P10\n", "N05871Q1A2P12\n", "2")
    assert um(two("N05871Q1A2P10\n", "N05871Q1A2P12\n", "1"), [5], DOWN) == [-4]
    for pair in (
        ("N01001Q1L1P00000000\n", "N01001Q1L1P00000001\n"),
        ("N10800Q1L1P1\n", "N10800Q1L1P2\n"),
        ("N01800Q1P00010000\n", "N01800Q1P00000000\n"),
        ("N01260Q1A1M360.0\n", "N01260Q1A1I360.0\n"),
    ):
        with pytest.raises(InputError, match=r"contradicts A\.TXT, line 3"):
            two(*pair, "1")
    assert um(two("N01260Q1A1M360.0\n", "N01260Q1A1M360\n", "1"), [5], DOWN) == [-4]
