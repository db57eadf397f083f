"""The virtual FANUC against the manual's numbers, tables worked by hand, and a brute-force walk
over the points.
"""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from compwright.controllers.virtual_control import VirtualControl, virtual_control
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
UM = {"detection_unit": 0.001}
# Corrections are whole pulses times the detection unit: only the rounding of doubles remains. mm.
EXACT = 1e-15

# The complete 30i example: X, interval 50 mm, reference number 40, -200..200 mm, and its totals in
# µm by node.
PARAMETERS = """%
N01851Q1A1P4A2P0A3P6
N03605Q1A1P00000000A2P00000000A3P00000000
N03620Q1A1P40A2P0A3P0
N03621Q1A1P37A2P0A3P0
N03622Q1A1P44A2P0A3P0
N03623Q1A1P1A2P0A3P0
N03624Q1A1M50.0A2M0.0A3M0.0
%
"""
INCREMENTS = {37: 1, 38: 0, 39: -2, 40: 1, 41: 2, 42: 1, 43: 0, 44: -1}
TOTALS = {-200: 0, -150: 1, -100: 1, -50: -1, 0: 0, 50: 2, 100: 3, 150: 3, 200: 2}
POINTS = "%\n" + "".join(f"N{10000 + n}Q0P{c}\n" for n, c in INCREMENTS.items()) + "%\n"
WHOLE = PARAMETERS.removesuffix("%\n") + POINTS.removeprefix("%\n")

# The program entry as the manual's practice shows it, its points completed to the same table.
PROGRAM = """%
O9100(PITCH X)
G10L52
N3620P1R40
N3621P1R37
N3622P1R44
N3623P1R1
N3624P1R50.0
N10037R1
N10038R0
G11
M30
%
"""

SHEET = """# axis: X
# address: 1
# value: correction
point,position,value,unit
3620,,40,
3621,,37,
3622,,44,
3623,,1,
3624,,50.0,mm
1851,,4,pulse
10037,-200,1,pulse
10038,-150,0,pulse
39,-100,-2,pulse
10040,-50,1,pulse
10041,0,2,pulse
10042,50,1,pulse
10043,100,0,pulse
10044,150,-1,pulse
"""


def control(
    *texts: str | bytes, form: str = "fanuc-30i", name: str = "f{}.txt", **request: Any
) -> VirtualControl:
    contents = [text if isinstance(text, bytes) else text.encode("latin-1") for text in texts]
    files = [ControlFile(name.format(i), content) for i, content in enumerate(contents)]
    return virtual_control(form, files, **{"options": UM, **request})


def sheet(text: str, name: str = "entry_X.csv", **request: Any) -> VirtualControl:
    return control(text, name=name, **request)


def values(
    box: VirtualControl, positions: Sequence[float], direction: Direction, address: str = "1"
) -> list[float]:
    return [float(value) for value in box.correction(address, np.array(positions), direction)]


def table_text(
    increments: Mapping[int, int],
    *,
    reference: int,
    lowest: int,
    highest: int,
    interval: float,
    more: str = "",
    factor: int = 1,
) -> str:
    """A minimal 30i file of axis 1 with these increments."""
    return (
        f"%\nN03620Q1A1P{reference}\nN03621Q1A1P{lowest}\nN03622Q1A1P{highest}\nN03623Q1A1P{factor}\nN03624Q1A1P{interval!r}\n{more}"
        + "".join(f"N{10000 + n}Q0P{c}\n" for n, c in increments.items())
        + "%\n"
    )


def walked(increments: Mapping[int, int], reference: int, interval: float, x: float) -> int:
    """Pulses on the way from the reference to ``x``, counted one section at a time; each comes in
    the middle of its section.
    """
    pulses = 0
    for number, pulse in increments.items():
        middle = (number - reference - 0.5) * interval
        if 0 < middle <= x:
            pulses += pulse  # passed on the way towards +
        elif x < middle < 0:
            pulses -= pulse  # passed on the way towards -
    return pulses


class TestPitch:
    def test_example_gives_its_printed_totals_in_both_directions(self) -> None:
        box = control(WHOLE)
        assert values(box, list(TOTALS), UP) == pytest.approx(
            [t / 1000 for t in TOTALS.values()], abs=EXACT
        )
        assert values(box, list(TOTALS), DOWN) == pytest.approx(
            [(t - 4) / 1000 for t in TOTALS.values()], abs=EXACT
        )
        assert box.points("1").tolist() == list(TOTALS)
        assert box.addresses() == ("1", "2", "3")
        assert box.points("2").size == 0
        assert values(box, [50.0], UP, "2") == [0.0]
        assert values(box, [50.0], DOWN, "3") == [-0.006]

    def test_pulses_come_in_the_middle_of_the_section_and_stay_outside(self) -> None:
        box = control(WHOLE)
        at = [
            -1e6,
            -201,
            -175.1,
            -175.0,
            -25.1,
            -24.9,
            24.9,
            25.0,
            74.9,
            75.1,
            174.9,
            175.1,
            201,
            1e6,
        ]
        wanted = [0, 0, 0, 1, -1, 0, 0, 2, 2, 3, 3, 2, 2, 2]
        assert values(box, at, UP) == pytest.approx([t / 1000 for t in wanted], abs=EXACT)

    def test_ramp_is_linear_between_points(self) -> None:
        box = control(WHOLE, options={**UM, "output": "ramp"})
        nodes, totals = list(TOTALS), list(TOTALS.values())
        for x in np.linspace(-300, 300, 241):
            low = max((i for i, node in enumerate(nodes) if node <= x), default=None)
            if low is None or low == len(nodes) - 1:
                wanted = float(totals[0] if low is None else totals[-1])
            else:
                wanted = totals[low] + (x - nodes[low]) / 50 * (totals[low + 1] - totals[low])
            assert values(box, [x], UP)[0] == pytest.approx(wanted / 1000, abs=EXACT)

    def test_totals_at_the_places_of_the_manual_figure(self) -> None:
        # interval 50 mm, numbers 33 to 48, reference 40 (0i-PB manual p. 100); own increments that
        # give the figure's totals
        increments = {
            33: 2,
            34: 2,
            35: 0,
            36: -1,
            37: 0,
            38: -1,
            39: -1,
            40: -1,
            41: 2,
            42: 1,
            43: 0,
            44: -2,
            45: 0,
            46: 0,
            47: -1,
            48: 0,
        }
        box = control(table_text(increments, reference=40, lowest=33, highest=48, interval=50.0))
        assert values(box, [-400, -250, 0, 100, 400], UP) == pytest.approx(
            [0, 0.004, 0, 0.003, 0], abs=EXACT
        )
        assert box.points("1")[[0, -1]].tolist() == [-400, 400]

    def test_manual_rule_of_the_extreme_numbers(self) -> None:
        # -400..800 mm at 50 mm with reference 40: numbers 33 to 56
        box = control(
            table_text(
                dict.fromkeys(range(33, 57), 0), reference=40, lowest=33, highest=56, interval=50.0
            )
        )
        assert box.points("1")[[0, -1]].tolist() == [-400, 800]

    @given(
        increments=st.lists(st.integers(-128, 127), min_size=2, max_size=30),
        data=st.data(),
        interval=st.sampled_from([0.5, 8.0, 12.5, 50.0]),
        factor=st.integers(1, 100),
    )
    @settings(max_examples=80, deadline=None)
    def test_against_a_walk_over_the_sections(
        self, increments: list[int], data: st.DataObject, interval: float, factor: int
    ) -> None:
        lowest = data.draw(st.integers(0, 1500))
        numbered = dict(enumerate(increments, start=lowest))
        reference = data.draw(st.sampled_from(list(numbered)))
        text = table_text(
            numbered,
            reference=reference,
            lowest=lowest,
            highest=lowest + len(increments) - 1,
            interval=interval,
            factor=factor,
        )
        x = [
            interval * data.draw(st.integers(-140, 140)) / 4 + interval / 16 for _ in range(20)
        ]  # never on a middle
        wanted = [factor * 0.001 * walked(numbered, reference, interval, at) for at in x]
        assert values(control(text), x, UP) == pytest.approx(
            wanted, abs=1e-12
        )  # mm; doubles of up to 400 mm

    def test_known_error_is_removed_to_half_a_pulse(self) -> None:
        # error = actual - commanded, 12 µm per 400 mm with a wave; the cumulative curve is rounded,
        # then differenced
        nodes = np.arange(-200, 201, 25.0)
        error = 30e-6 * nodes + 0.003 * np.sin(nodes / 60)
        totals = np.round(-(error - error[8]) / 0.001).astype(int)
        increments = {100 - 7 + i: int(step) for i, step in enumerate(np.diff(totals))}
        box = control(table_text(increments, reference=100, lowest=93, highest=108, interval=25.0))
        left = error + box.correction("1", nodes, UP)
        assert np.ptp(error) > 0.012
        assert np.max(np.abs(left)) <= 0.0005 + EXACT  # mm; half a detection unit

    def test_grid_hangs_on_the_reference_position(self) -> None:
        box = control(WHOLE, reference={"1": -350.0})
        shifted = [node - 350 for node in TOTALS]
        assert values(box, shifted, UP) == pytest.approx(
            [t / 1000 for t in TOTALS.values()], abs=EXACT
        )
        assert box.points("1").tolist() == shifted
        assert any("machine zero (unconfirmed)" in note for note in box.notes)
        assert not any("machine zero" in note for note in control(WHOLE).notes)
        by_option = control(WHOLE, options={**UM, "reference": "-350"})
        assert by_option.points("1").tolist() == shifted
        assert any(a.fact == "reference of 1" and a.value == "-350" for a in by_option.assumed)

    def test_magnification_and_detection_unit_multiply(self) -> None:
        text = WHOLE.replace("N03623Q1A1P1", "N03623Q1A1P3")
        assert values(control(text, options={"detection_unit": "0.0005"}), [100], UP) == [
            pytest.approx(0.0045, abs=EXACT)
        ]
        # backlash is not magnified: 3 * 3 - 4 pulses
        assert values(control(text), [100], DOWN) == [pytest.approx(0.005, abs=EXACT)]

    @pytest.mark.parametrize(
        ("unit", "same"), [("0.0006667", True), ("0.000667", False), ("0.00066", False)]
    )
    def test_a_detection_unit_that_the_files_contradict(self, unit: str, *, same: bool) -> None:
        """1820 = 3 of an IS-B axis: 0.001 mm / 1.5 = 0.00066666.. mm. Four digits leave less than a
        tenth of a pulse in a thousand pulses; three leave half a pulse.
        """
        text = in_style(("N01851", "N01820Q1A1P3\nN01013Q1A1P00000000\nN01851"))
        options = {"detection_unit": unit}
        if same:
            assert values(control(text, options=options), [50], UP) == [2 * float(unit)]
            return
        with pytest.raises(InputError, match=f"detection_unit {unit} of axis 1"):
            control(text, options=options)

    def test_travel_from_and_to_the_reference(self) -> None:
        # 0..100 mm: 3621 = r with increment 0 at r; -100..0: 3622 = r + 1 with increment 0 there
        ahead = control(
            table_text({40: 0, 41: 3, 42: 1}, reference=40, lowest=40, highest=42, interval=50.0)
        )
        assert values(ahead, [-100, -50, 0, 50, 100, 150], UP) == pytest.approx(
            [0, 0, 0, 0.003, 0.004, 0.004], abs=EXACT
        )
        behind = control(
            table_text({39: 3, 40: 1, 41: 0}, reference=40, lowest=39, highest=41, interval=50.0)
        )
        assert values(behind, [-150, -100, -50, 0, 50], UP) == pytest.approx(
            [-0.004, -0.004, -0.001, 0, 0], abs=EXACT
        )
        ends = control(
            table_text({39: 3, 40: 1}, reference=40, lowest=39, highest=40, interval=50.0)
        )
        assert values(ends, [-100, 0, 500], UP) == pytest.approx([-0.004, 0, 0], abs=EXACT)

    def test_sign_of_the_data_is_an_option(self) -> None:
        box = control(WHOLE, options={**UM, "pitch_sign": "-"})
        assert values(box, [100], UP) == [-0.003]
        assert values(box, [0], DOWN) == [-0.004]  # 1851 keeps its own

    def test_zero_magnification_compensates_nothing(self) -> None:
        box = control(PARAMETERS.replace("N03623Q1A1P1", "N03623Q1A1P0"))
        assert box.points("1").size == 0
        assert values(box, [100], UP) == [0.0]
        assert values(box, [100], DOWN) == [-0.004]


class TestBacklash:
    @pytest.mark.parametrize(("returning", "up", "down"), [(UP, 0.0, -0.012), (DOWN, 0.012, 0.0)])
    def test_acts_against_the_reference_return(
        self, returning: Direction, up: float, down: float
    ) -> None:
        box = control("%\nN01851Q1A1P12\n%\n", reference_return={"1": returning})
        assert values(box, [5.0], UP) == [up]
        assert values(box, [5.0], DOWN) == [down]
        assert any(a.fact == "pitch error compensation of 1" for a in box.assumed)

    def test_lost_motion_is_removed(self) -> None:
        # lost motion of 12 µm: arriving downward the axis stands 12 µm too high; 1851 = B / u with
        # B > 0 for lost motion
        error = {UP: 0.0, DOWN: 0.012}
        box = control("%\nN01851Q1A1P12\n%\n")
        actual = [error[d] + values(box, [100.0], d)[0] for d in (UP, DOWN)]
        assert actual[0] == pytest.approx(actual[1], abs=EXACT)

    def test_absent_is_zero_and_said(self) -> None:
        box = control(
            table_text({40: 1, 41: 0}, reference=40, lowest=40, highest=41, interval=50.0)
        )
        assert values(box, [0], DOWN) == [0.0]
        assert any(a.fact == "backlash 1851 of 1" and a.value == "0" for a in box.assumed)

    def test_rapid_traverse_is_noted_not_judged(self) -> None:
        text = "%\nN01800Q1L1P00010000\nN01851Q1A1P12\nN01852Q1A1P20\n%\n"
        box = control(text)
        assert values(box, [0], DOWN) == [-0.012]
        assert any("1852 = 20" in note for note in box.notes)
        assert not any(
            "1852" in note for note in control(text.replace("P00010000", "P00100000")).notes
        )


TURN = {61: 2, 62: 1, 63: 0, 64: -3, 65: -1, 66: 2, 67: 0, 68: -1}
ROTARY = table_text(
    {60: -1, **TURN},
    reference=60,
    lowest=60,
    highest=68,
    interval=45.0,
    more="N01006Q1A1P00000001\n",
)


class TestRotary:
    def test_reference_60_at_45_degrees(self) -> None:
        box = control(ROTARY)
        totals = [0, 2, 3, 3, 0, -1, 1, 1, 0]
        assert box.points("1").tolist() == [45.0 * i for i in range(9)]
        assert values(box, list(box.points("1")), UP) == pytest.approx(
            [t / 1000 for t in totals], abs=EXACT
        )
        # one turn further, one back, across zero: -45 is 315; the step of section 61 comes at 22.5
        # deg
        assert values(box, [405, -45, -315, 750, 22.4, 22.6, 359.9, -0.1], UP) == pytest.approx(
            [0.002, 0.001, 0.002, 0.002, 0, 0.002, 0, 0], abs=EXACT
        )
        assert not any("same section" in note for note in box.notes)

    def test_ramp_closes(self) -> None:
        box = control(ROTARY, options={**UM, "output": "ramp"})
        assert values(box, [-22.5, 337.5, 0, 360], UP) == pytest.approx(
            [0.0005, 0.0005, 0, 0], abs=EXACT
        )

    def test_hangs_on_the_reference(self) -> None:
        box = control(ROTARY, reference={"1": 30.0})
        assert values(box, [30, 75, 120, 390, -330], UP) == pytest.approx(
            [0, 0.002, 0.003, 0, 0], abs=EXACT
        )

    def test_sum_over_the_turn(self) -> None:
        with pytest.raises(InputError, match="add up to 3 detection units each turn"):
            control(ROTARY.replace("N10068Q0P-1", "N10068Q0P2"))
        with pytest.raises(InputError, match="add up to -6 detection units"):
            control(
                ROTARY.replace("N10068Q0P-1", "N10068Q0P-4").replace("N03623Q1A1P1", "N03623Q1A1P2")
            )

    def test_point_of_the_reference(self) -> None:
        box = control(ROTARY.replace("N10060Q0P-1", "N10060Q0P5"))
        assert values(box, [315], UP) == [0.001]
        assert any("60 and 68" in note for note in box.notes)
        assert any(
            "60 and 68" in note for note in control(ROTARY.replace("N10060Q0P-1\n", "")).notes
        )

    def test_turn_of_3625(self) -> None:
        text = ROTARY.replace("N01006", "N03625Q1A1P180.0\nN01006").replace("P45.0", "P22.5")
        box = control(text)
        assert values(box, [22.5, 202.5, -157.5], UP) == [0.002] * 3

    @pytest.mark.parametrize(
        ("text", "request_", "says"),
        [
            (
                ROTARY.replace("N03622Q1A1P68", "N03622Q1A1P67"),
                {"modulo": {"1": 360.0}},
                "3622 = 3620 + 8",
            ),
            (
                ROTARY.replace("N03622Q1A1P68", "N03622Q1A1P67\nN03625Q1A1P360.0"),
                {},
                "3622 = 3620 + 8",
            ),
            (
                ROTARY.replace("N03621Q1A1P60", "N03621Q1A1P61").replace(
                    "N03620Q1A1P60", "N03620Q1A1P61"
                ),
                {"modulo": {"1": 360.0}},
                "+ 8",
            ),
            (
                ROTARY.replace("N03621Q1A1P60", "N03621Q1A1P59\nN10059Q0P0"),
                {"modulo": {"1": 360.0}},
                "cover one turn",
            ),
            (ROTARY, {"modulo": {"1": 180.0}}, "turn of axis 1"),
            (
                WHOLE,
                {"modulo": {"1": 360.0}, "kinds": {"1": AxisKind.LINEAR}},
                "is linear but was given as endless",
            ),
        ],
    )
    def test_numbers_that_do_not_go_round(
        self, text: str, request_: dict[str, Any], says: str
    ) -> None:
        with pytest.raises(InputError) as caught:
            control(text, **request_)
        assert says in str(caught.value)

    def test_axis_with_ends(self) -> None:
        text = table_text({60: 0, 61: 2, 62: 1}, reference=60, lowest=60, highest=62, interval=45.0)
        box = control(text, kinds={"1": AxisKind.ROTARY})
        assert values(box, [-45, 0, 45, 90, 135, 405], UP) == pytest.approx(
            [0, 0, 0.002, 0.003, 0.003, 0.003], abs=EXACT
        )
        assert any("rotary axis with ends" in note for note in box.notes)


# A-77810E: reference 23, numbers 20 to 27, towards - from 30, interval 10 mm, 3627 = -4; increments
# are our own.
TOWARDS_PLUS = {20: 1, 21: 0, 22: -2, 23: 3, 24: 2, 25: -1, 26: 0, 27: 1}
TOWARDS_MINUS = {30: 0, 31: 2, 32: -1, 33: 1, 34: 1, 35: 0, 36: -2, 37: 3}
BOTH = table_text(
    {**TOWARDS_PLUS, **TOWARDS_MINUS},
    reference=23,
    lowest=20,
    highest=27,
    interval=10.0,
    more="N03605Q1A1P00000001\nN03626Q1A1P30\nN03627Q1A1P-4\nN01851Q1A1P0\n",
)
NODES = [-40, -30, -20, -10, 0, 10, 20, 30, 40]
PLUS = [-2, -1, -1, -3, 0, 2, 1, 1, 2]
MINUS = [-2, -2, 0, -1, 0, 1, 1, -1, 2]


class TestBidirectional:
    def test_reference_return_towards_plus(self) -> None:
        box = control(BOTH)
        assert box.points("1").tolist() == NODES
        assert values(box, NODES, UP) == pytest.approx([p / 1000 for p in PLUS], abs=EXACT)
        assert values(box, NODES, DOWN) == pytest.approx([(m - 4) / 1000 for m in MINUS], abs=EXACT)
        assert values(box, [0], UP) == [0.0]

    def test_reference_return_towards_minus(self) -> None:
        box = control(BOTH, reference_return={"1": DOWN})
        assert values(box, NODES, UP) == pytest.approx([(p - 4) / 1000 for p in PLUS], abs=EXACT)
        assert values(box, NODES, DOWN) == pytest.approx([m / 1000 for m in MINUS], abs=EXACT)
        assert any("unconfirmed" in note for note in box.notes)
        assert not any("unconfirmed" in note for note in control(BOTH).notes)

    def test_switched_off_is_one_set(self) -> None:
        box = control(BOTH.replace("P00000001", "P00000000"))
        assert values(box, NODES, DOWN) == pytest.approx([p / 1000 for p in PLUS], abs=EXACT)

    def test_backlash_acts_on_top(self) -> None:
        box = control(BOTH.replace("N01851Q1A1P0", "N01851Q1A1P7"))
        assert values(box, [0, 40], DOWN) == pytest.approx([-0.011, -0.009], abs=EXACT)
        assert values(box, [0, 40], UP) == pytest.approx([0, 0.002], abs=EXACT)

    def test_options_of_the_offset(self) -> None:
        tripled = BOTH.replace("N03623Q1A1P1", "N03623Q1A1P3")
        assert values(control(BOTH, options={**UM, "offset_sign": "-"}), [0], DOWN) == [0.004]
        assert values(control(tripled), [0, 40], DOWN) == pytest.approx([-0.004, 0.002], abs=EXACT)
        magnified = control(tripled, options={**UM, "offset_magnified": "yes"})
        assert values(magnified, [0, 40], DOWN) == pytest.approx([-0.012, -0.006], abs=EXACT)

    def test_reversal_error_of_a_machine_is_removed(self) -> None:
        # towards + and towards - the table stands off differently at each node; totals P and N,
        # 3627 = N(0) - P(0) with P(0) = 0
        nodes = np.arange(-40, 41, 10.0)
        error = {UP: 1e-4 * nodes, DOWN: 0.008 + 5e-5 * nodes}
        total = {d: np.round(-e / 0.001).astype(int) for d, e in error.items()}
        steps = {
            start + i: int(c)
            for start, d in ((20, UP), (30, DOWN))
            for i, c in enumerate(np.diff(total[d]))
        }
        more = f"N03605Q1A1P00000001\nN03626Q1A1P30\nN03627Q1A1P{total[DOWN][4]}\n"
        box = control(
            table_text(steps, reference=23, lowest=20, highest=27, interval=10.0, more=more)
        )
        for d in (UP, DOWN):
            assert (
                np.max(np.abs(error[d] + box.correction("1", nodes, d))) <= 0.0005 + 1e-12
            )  # mm; half a pulse and a tie

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("N03626Q1A1P30\n", "", "parameters 3626"),
            ("N03627Q1A1P-4\n", "", "parameters 3627"),
            ("N03626Q1A1P30", "N03626Q1A1P27", "overlap"),
            ("N03626Q1A1P30", "N03626Q1A1P1530", "up to 1535"),
            ("N10034Q0P1\n", "", "N10034"),
            ("N03605Q1A1P00000001", "N03605Q1A1P1", "eight binary digits"),
        ],
    )
    def test_incomplete(self, old: str, new: str, says: str) -> None:
        assert old in BOTH
        with pytest.raises(InputError) as caught:
            control(BOTH.replace(old, new))
        assert says in str(caught.value)

    def test_up_to_the_last_number(self) -> None:
        # eight points from 1528 end at 1535, the last of a 30i; and a set may follow the other
        # without a gap
        for start in (1528, 28):
            text = BOTH.replace("N03626Q1A1P30", f"N03626Q1A1P{start}")
            for number in TOWARDS_MINUS:
                text = text.replace(f"N{10000 + number}Q0", f"N{10000 + number - 30 + start}Q0")
            assert values(control(text), NODES, DOWN) == pytest.approx(
                [(m - 4) / 1000 for m in MINUS], abs=EXACT
            )

    def test_endless_axis(self) -> None:
        more = "N01006Q1A1P00000001\nN03605Q1A1P00000001\nN03626Q1A1P70\nN03627Q1A1P5\n"
        mirrored = {70: 0, **{n + 10: -c for n, c in TURN.items()}}
        text = table_text(
            {60: -1, **TURN, **mirrored},
            reference=60,
            lowest=60,
            highest=68,
            interval=45.0,
            more=more,
        )
        box = control(text)
        assert values(box, [90, 450, 0], DOWN) == pytest.approx([0.002, 0.002, 0.005], abs=EXACT)
        with pytest.raises(InputError, match="add up to 1 "):
            control(text.replace("N10078Q0P1", "N10078Q0P2"))


def in_style(*changes: tuple[str, str]) -> str:
    text = WHOLE
    for old, new in changes:
        text = text.replace(old, new)
    return text


SPACED = "\n".join(
    (
        line
        if line == "%"
        else "".join(
            f" {c} " if c in "PA" else c for c in line.replace("Q1", "").replace("Q0", "")
        ).replace("P  ", "P ")
    )
    for line in WHOLE.replace("M50.0", "P50.0").replace("M0.0", "P0.0").splitlines()
)


class TestText:
    @pytest.mark.parametrize(
        "text",
        [
            in_style(("\n", "\r\n")),
            in_style(("\n", "\n\r\r")),
            in_style(("\n", "\r")),
            in_style(("%\nN01851", "%;\nN01851")),
            in_style(("%\nN01851", "%(CNCID=1A2B3C4D,5E6F7A8B)\nN01851")),
            in_style(("Q0", "")),
            in_style(("Q1", ""), ("Q0", "")),
            in_style(("Q1", ""), ("Q0", ""), ("N0", "N")),
            in_style(("N0", "N000"), ("N10", "N0010")),
            in_style(("Q1A1", "Q1L1A1"), ("Q0P", "Q0L1P")),
            in_style(("A3P6", "A3P6S1P77"), ("M50.0", "P50.000")),
            in_style(("A1P40A2P0A3P0", "A3P0A2P0A1P40")),
            in_style(("N03620", "(REFERENCE (NUMBER\nN03620")).replace(
                "(REFERENCE (NUMBER", "(REFERENCE NUMBER)"
            ),
            in_style(("Q1A1P40", "Q1A1P40 (NUMBER)")),
            in_style(
                (
                    "N03620",
                    "N00000Q1L1P00000010\nN01320Q1A1P-1.0A2P-1.0\nN08130Q1L1P3\nN01240Q1A1M-1.0E\nN03620",
                )
            ),
            in_style(("N10037", "N11222Q1P00000001\nN14340Q1P1\nN13140Q1S1P5\nN10037")),
            in_style(("%", "")),
            WHOLE.removeprefix("%\n"),
            PARAMETERS + POINTS,
            SPACED,
            in_style(("M50.0A2M0.0A3M0.0", "I1.9685039370078740A2I0.0A3I0.0")),
            "\xef\xbb\xbf" + WHOLE,
        ],
    )
    def test_every_style_is_the_same_control(self, text: str) -> None:
        positions = np.array([-250, *TOTALS, 24.9, 25.1, -24.9, -25.1, 74.9, 300])
        box = control(text)
        for direction in (UP, DOWN):
            for address in ("1", "2", "3"):
                expected = control(WHOLE).correction(address, positions, direction)
                assert np.array_equal(box.correction(address, positions, direction), expected)

    def test_parameters_and_points_in_two_files(self) -> None:
        for texts in (
            (PARAMETERS, POINTS),
            (POINTS, PARAMETERS),
            (PARAMETERS, POINTS, POINTS, WHOLE),
        ):
            assert values(control(*texts), list(TOTALS), UP) == pytest.approx(
                [t / 1000 for t in TOTALS.values()], abs=EXACT
            )

    def test_program_entry(self) -> None:
        rest = "".join(f"N{10000 + n}R{c}\n" for n, c in INCREMENTS.items() if n > 38)
        box = control(PROGRAM.replace("G11", "N1851P1R4\nN3605P1Q0R0\n" + rest + "G11"))
        assert values(box, list(TOTALS), DOWN) == pytest.approx(
            [(t - 4) / 1000 for t in TOTALS.values()], abs=EXACT
        )
        parameters_behind = control(PROGRAM.replace("G11", rest + "G11\nN01851Q1A1P4"))
        assert values(parameters_behind, list(TOTALS), DOWN) == values(box, list(TOTALS), DOWN)
        with pytest.raises(InputError, match="N10039 to 10044"):
            control(PROGRAM)
        with pytest.raises(InputError, match="line 4: the block cannot be read"):
            control(PROGRAM.replace("G10L52\n", "O9101\n"))

    def test_q1_is_never_pitch_data(self) -> None:
        # a 30i has parameters above 10000, marked Q1 as all parameters: they are never pitch data
        box = control(in_style(("N10041Q0P2", "N10041Q0P2\nN10041Q1P9\nN10100Q1P3")))
        assert values(box, [50], UP) == [0.002]
        with pytest.raises(InputError, match="contains no pitch data"):
            control(in_style(("Q0", "Q1")))

    def test_older_series_counts_thousandths(self) -> None:
        old = in_style(("Q1", ""), ("Q0", ""), ("M50.0A2M0.0A3M0.0", "P50000A2P0A3P0"))
        expected = values(control(WHOLE), list(TOTALS), UP)
        box = control(old, form="fanuc-0i-16i")
        assert values(box, list(TOTALS), UP) == expected
        assert any(a.fact == "increment system of 1" and a.value == "IS-B" for a in box.assumed)
        assert values(control(WHOLE, form="fanuc-0i-16i"), list(TOTALS), UP) == expected
        fine = old.replace("P50000", "P500000").replace("N03605", "N01004P00000010\nN03605")
        assert values(control(fine, form="fanuc-0i-16i"), list(TOTALS), UP) == expected
        coarse = old.replace("P50000", "P5000").replace("N03605", "N01013A1P00000001\nN03605")
        assert values(control(coarse, form="fanuc-0i-16i"), list(TOTALS), UP) == expected
        with pytest.raises(InputError, match="no decimal point"):
            control(old)

    def test_inch_machine(self) -> None:
        # 1001#0 = 1: an interval of P2.0 is 2 inches, 50.8 mm; the detection unit is told in mm
        text = in_style(("N01851", "N01001Q1L1P00000001\nN01851"), ("M50.0", "P2.0"))
        assert control(text).points("1").tolist() == pytest.approx([50.8 * i for i in range(-4, 5)])
        assert any("inch" in note for note in control(text).notes)
        metric = text.replace("P2.0", "M50.0")  # says itself what it is
        assert control(metric).points("1").tolist() == list(TOTALS)
        whole = text.replace("P2.0", "P20000")  # IS-B: 0.0001 inch
        assert control(whole, form="fanuc-0i-16i").points("1").tolist() == pytest.approx(
            [50.8 * i for i in range(-4, 5)]
        )

    @pytest.mark.parametrize(
        ("row", "says"),
        [
            ("N01001Q1L1P1", "1001#0"),
            ("N01001Q1P00000002", "1001#0"),
            ("N01006Q1A1P8", "1006#0"),
            ("N01013Q1A1P2", "1013#0"),
            ("N01800Q1P16\nN01852Q1A1P9", "1800#4"),
        ],
    )
    def test_bits_in_another_form(self, row: str, says: str) -> None:
        """A control gives out eight digits (B-63950EN/02 p. 11); 0 is 0 in each form, and the bits
        of axis 2, which has no table, decide nothing.
        """
        with pytest.raises(InputError, match=f"{says} of axis 1 cannot be read"):
            control(in_style(("N01851", f"{row}\nN01851")))
        number = row[:6]
        control(in_style(("N01851", f"{number}Q1A1P0\nN01851")))
        control(in_style(("N01851", f"{number}Q1A1P00000000A2P7\nN01851")))

    def test_bits_of_a_program(self) -> None:
        metric = PROGRAM.replace("N3620", "N1006P1R00000000\nN3620")
        assert control(metric, POINTS).points("1").tolist() == list(TOTALS)
        with pytest.raises(InputError, match="1006#0 of axis 1 cannot be read"):
            control(metric.replace("R00000000", "R8"), POINTS)

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("N03620Q1A1P40", "N03620Q1A1P4x0", "block cannot be read"),
            ("N03620Q1A1P40", "N03620Q1A1P+40", "without plus sign"),
            ("N03620Q1A1P40", "N03620Q1A1P40;", "block cannot be read"),
            ("N03620Q1A1P40", "N03620Q1A1P40.0", "whole number"),
            ("N03620Q1A1P40", "N03620Q1A1M40", "whole number"),
            ("N03620Q1A1P40", "N03620Q1A1P40P41", "groups of axis and value"),
            ("N03620Q1A1P40A2", "N03620Q1A1P40A1P41A2", "contradicts"),
            ("N03620Q1A1P40", "N03620Q1A0P40", "axis number"),
            ("N03620Q1A1P40", "N03620Q0A1P40", "Q1"),
            ("N03620Q1A1P40", "N03620Q1L2A1P40", "first path"),
            ("N03620Q1A1P40", "N03620Q1P40", "names no axis"),
            ("N03620Q1A1P40", "n03620q1a1p40", "capital letters"),
            ("N03620Q1A1P40", "03620Q1A1P40", "block cannot be read"),
            ("N03620Q1A1P40A2P0A3P0", "N03620Q1A1P40A2P0A3", "behind every axis"),
            ("N03620Q1A1P40A2P0A3P0\n", "", "parameters 3620"),
            ("N03624Q1A1M50.0A2M0.0A3M0.0\n", "", "parameters 3624"),
            ("N03623Q1A1P1A2P0A3P0\nN03624Q1A1M50.0A2M0.0A3M0.0\n", "", "parameters 3623 to 3624"),
            ("M50.0", "M0.0", "above 0"),
            ("M50.0", "M-50.0", "0 or more"),
            ("M50.0", "M50", "no decimal point"),
            ("N03621Q1A1P37", "N03621Q1A1P41", "3621 <= 3620 <= 3622"),
            ("N03622Q1A1P44", "N03622Q1A1P39", "3621 <= 3620 <= 3622"),
            ("N03622Q1A1P44", "N03622Q1A1P46", "N10045 to 10046"),
            ("N03622Q1A1P44", "N03622Q1A1P1536", "0 to 1535"),
            ("N03623Q1A1P1", "N03623Q1A1P101", "0 to 100"),
            ("N01851Q1A1P4", "N01851Q1A1P10000", "-9999 to 9999"),
            ("N10041Q0P2\n", "", "N10041"),
            ("N10041Q0P2", "N10041Q0P128", "-128 to 127"),
            ("N10041Q0P2", "N10041Q0P-129", "-128 to 127"),
            ("N10041Q0P2", "N10041Q0P2.0", "whole number"),
            ("N10041Q0P2", "N10041Q0P2\nN10041Q0P3", "contradicts"),
            ("N10041Q0P2", "N10041Q0P", "block cannot be read"),
            ("N10041Q0P2", "N10041Q0A1P2", "block cannot be read"),
            ("N10041Q0P2", "N11536Q0P2", "no pitch data of point 1536"),
            ("N10041Q0P2", "%\nN10041Q0P2", "behind the closing %"),
            ("%\nN01851", "N01852Q1A1P4\n%\nN01851", "before the first %"),
            ("%\nN01851", "%N01851Q1A1P4\nN01851", "behind %"),
            ("%\nN01851", "%\n\x00N01851", "binary"),
        ],
    )
    def test_what_is_wrong_is_refused(self, old: str, new: str, says: str) -> None:
        assert old in WHOLE
        with pytest.raises(InputError, match=r"f0\.txt") as caught:
            control(WHOLE.replace(old, new, 1))
        assert says in str(caught.value)

    def test_all_faults_at_once_with_their_lines(self) -> None:
        with pytest.raises(InputError) as caught:
            control(in_style(("N03620Q1A1P40", "N03620Q1A1P+40"), ("N10041Q0P2", "N10041Q0P200")))
        assert [fault.place for fault in caught.value.faults[:2]] == ["line 4", "line 13"]

    def test_grid_without_points_names_them(self) -> None:
        with pytest.raises(InputError, match=r"contains no pitch data.*N10037 to 10044"):
            control(PARAMETERS)

    def test_points_without_a_grid(self) -> None:
        with pytest.raises(InputError, match=r"no compensation parameters.*pitch data only"):
            control(POINTS)
        with pytest.raises(InputError, match="no compensation parameters"):
            control("%\n%\n")

    def test_files_that_contradict_each_other(self) -> None:
        with pytest.raises(InputError, match=r"f1\.txt: line 2.*contradicts f0\.txt, line 9"):
            control(WHOLE, "%\nN10037Q0P2\n%\n")
        with pytest.raises(
            InputError, match=r"parameter 3622 of axis 1 contradicts f0\.txt, line 6"
        ):
            control(WHOLE, "%\nN03622Q1A1P43\n%\n")

    def test_limits_of_the_series(self) -> None:
        old = in_style(("N10041Q0P2", "N10041Q0P8"))
        with pytest.raises(InputError, match=r"line 13: the increment of point 41.*-7 to 7"):
            control(old, form="fanuc-0i-16i")
        control(old, form="fanuc-0i-16i", options={**UM, "increment_limit": "8"})
        control(in_style(("N10041Q0P2", "N10041Q0P-128")))
        with pytest.raises(InputError, match="-127"):
            control(
                in_style(("N10041Q0P2", "N10041Q0P-127")), options={**UM, "increment_limit": 126}
            )
        with pytest.raises(InputError, match="0 to 1023"):
            control(in_style(("N10044Q0P-1", "N10044Q0P-1\nN11024Q0P0")), form="fanuc-0i-16i")
        with pytest.raises(InputError, match="0 to 1023"):
            control(in_style(("N03622Q1A1P44", "N03622Q1A1P1024")), form="fanuc-0i-16i")

    def test_shared_points(self) -> None:
        other = "%\nN03620Q1A2P{r}\nN03621Q1A2P{low}\nN03622Q1A2P{high}\nN03623Q1A2P{k}\nN03624Q1A2M50.0\n%\n"
        mine = (
            "".join(line + "\n" for line in WHOLE.splitlines() if not line.startswith("N036"))
            + "%\n"
        )
        first = "N03620Q1A1P40\nN03621Q1A1P37\nN03622Q1A1P44\nN03623Q1A1P1\nN03624Q1A1M50.0\n"
        mine = mine.replace("%\n", "%\n" + first, 1).removesuffix("%\n")
        # Axis 2 counts from number 42: 43 and 44 (0, -1) lie above, 42, 41, 40 (1, 2, 1) below it.
        shared = control(mine, other.format(r=42, low=40, high=44, k=1))
        assert values(shared, [-150, -100, -50, 0, 50, 100], UP, "2") == [
            -0.004, -0.003, -0.001, 0.0, 0.0, -0.001,
        ]  # fmt: skip
        assert values(shared, [100], UP) == [0.003]
        assert any("points 40 to 44 as axis 1, in another way" in note for note in shared.notes)
        # the same range, counted from another place
        beside = control(mine, other.format(r=41, low=37, high=44, k=1))
        assert values(beside, [50], UP, "2") == [0.001]
        assert any("points 37 to 44 as axis 1, in another way" in note for note in beside.notes)
        gantry = control(mine, other.format(r=40, low=37, high=44, k=1))
        assert values(gantry, [100], UP, "2") == [0.003]
        assert any("in the same way" in note for note in gantry.notes)
        idle = control(mine, other.format(r=42, low=40, high=44, k=0))
        assert any("not in use" in note for note in idle.notes)

    def test_idle_points_and_unjudged_functions_are_named(self) -> None:
        box = control(in_style(("N10037", "N10200Q0P3\nN10201Q0P0\nN10037")))
        assert any("10200 contain values" in note for note in box.notes)
        with pytest.raises(InputError, match="3602: 00000001"):
            control(in_style(("N10037", "N03602Q1P00000001\nN10037")))
        for line, says in (("N10801Q1L1P1", "10801: 1"), ("N13381Q1L1P1", "13381: 1")):
            named = control(in_style(("N10037", f"{line}\nN05761Q1P0\nN10037")))
            assert any("axis 1" in note and says in note for note in named.notes)
            assert values(named, list(TOTALS), UP) == values(control(WHOLE), list(TOTALS), UP)
        assert any(
            "3605#2" in note for note in control(in_style(("A1P00000000", "A1P00000100"))).notes
        )
        assert any(
            "diameter" in note
            for note in control(in_style(("N03605", "N01006Q1A1P00001000\nN03605"))).notes
        )

    def test_strange_lines_and_a_missing_end_are_noted(self) -> None:
        box = control(in_style(("N03620", "CNC PARAMETER\nN03620")))
        assert any("line 4" in note for note in box.notes)
        assert any("cut short" in note for note in control(WHOLE.removesuffix("%\n")).notes)
        with pytest.raises(InputError, match="ends within a block"):
            control(WHOLE.removesuffix("\n%\n"))

    def test_cut_anywhere_is_refused_or_noted(self) -> None:
        whole = values(control(WHOLE), list(TOTALS), DOWN)
        read = 0
        for length in range(len(WHOLE) - 1):
            try:
                box = control(WHOLE[:length])
            except InputError:
                continue
            read += 1
            assert any("cut short" in note for note in box.notes)
            if box.points("1").size:
                assert values(box, list(TOTALS), DOWN) == whole
        assert (
            read == 3
        )  # behind 1851 and 3605, where no grid is begun, and whole but for the last %


class TestSheet:
    def test_is_the_same_control(self) -> None:
        expected = [values(control(WHOLE), list(TOTALS), d) for d in (UP, DOWN)]
        crlf = SHEET.replace("\n", "\r\n")
        for text in (
            SHEET,
            crlf,
            "\xef\xbb\xbf" + SHEET,
            SHEET.replace("# value: correction\n", "# some text\n"),
            SHEET + "3605#0,,0,\n",
        ):
            box = sheet(text)
            assert [values(box, list(TOTALS), d) for d in (UP, DOWN)] == expected
        assert sheet(SHEET).addresses() == ("1",)
        old = sheet(SHEET, form="fanuc-0i-16i")
        assert [values(old, list(TOTALS), d) for d in (UP, DOWN)] == expected
        whole_millimetres = sheet(SHEET.replace("50.0,mm", "50,mm"), form="fanuc-0i-16i")
        assert whole_millimetres.points("1").tolist() == list(TOTALS)

    def test_axis_by_address_then_axis_then_name(self) -> None:
        assert sheet(SHEET.replace("address: 1", "address: 5")).addresses() == ("5",)
        assert sheet(
            SHEET.replace("# address: 1\n", "").replace("axis: X", "axis: 3")
        ).addresses() == ("3",)
        bare = SHEET.replace("# address: 1\n", "").replace("# axis: X\n", "")
        assert sheet(bare, name="entry_2.csv").addresses() == ("2",)
        with pytest.raises(InputError, match="which controlled axis"):
            sheet(bare)

    def test_bidirectional_rotary(self) -> None:
        text = (
            "# address:"
            " 4\npoint,position,value,unit\n3620,,60,\n3621,,60,\n3622,,64,\n3623,,1,\n3624,,90,deg\n3625,,360,deg\n"
        )
        text += "3605#0,,1,\n3626,,70,\n3627,,5,pulse\n"
        text += "".join(
            f"{n},,{c},pulse\n"
            for n, c in {61: 1, 62: 2, 63: -2, 64: -1, 71: 0, 72: 3, 73: -3, 74: 0}.items()
        )
        box = sheet(text)
        assert values(box, [90, 180, 450], UP, "4") == pytest.approx(
            [0.001, 0.003, 0.001], abs=EXACT
        )
        assert values(box, [90, 180, 450], DOWN, "4") == pytest.approx(
            [0.005, 0.008, 0.005], abs=EXACT
        )

    def test_values_that_are_errors_need_the_sign(self) -> None:
        text = SHEET.replace("correction", "error")
        with pytest.raises(InputError, match="given as errors"):
            sheet(text)
        assert values(sheet(text, options={**UM, "pitch_sign": "-"}), [100], UP) == [-0.003]

    @pytest.mark.parametrize(
        ("old", "new", "says"),
        [
            ("point,position", "position,point", "header"),
            ("3624,,50.0,mm", "3624,,50.0,deg", "unit of parameter 3624"),
            ("3624,,50.0,mm", "3624,,50.0,", "unit of parameter 3624"),
            ("3624,,50.0,mm", "3624,,50;0,mm", "decimal point"),
            ("3624,,50.0,mm", "3624,0,50.0,mm", "position"),
            ("1851,,4,pulse", "1851,,4,mm", "unit of parameter 1851"),
            ("1851,,4,pulse", "1815,,4,pulse", "neither pitch data"),
            ("1851,,4,pulse", "1851,,4,pulse,", "four cells"),
            ("1851,,4,pulse", "3605#0,,2,", "0 or 1"),
            ("39,-100,-2,pulse", "39,-100,-2,um", "the unit of the pitch data"),
            ("39,-100,-2,pulse", "39,x,-2,pulse", "position"),
            ("39,-100,-2,pulse", "39,-100,-2.5,pulse", "whole number"),
            ("39,-100,-2,pulse", "39#1,-100,-2,pulse", "neither pitch data"),
            ("39,-100,-2,pulse\n", "", "N10039"),
            ("39,-100,-2,pulse", "39,-100,-2,pulse\n10039,,1,pulse", "contradicts"),
            ("value: correction", "value: total", "error or correction"),
            ("3622,,44,\n", "", "parameters 3622"),
            ("# axis: X", "\xff", "UTF-8"),
        ],
    )
    def test_what_is_wrong_is_refused(self, old: str, new: str, says: str) -> None:
        assert old in SHEET
        with pytest.raises(InputError) as caught:
            sheet(SHEET.replace(old, new, 1), kinds={"1": AxisKind.LINEAR})
        message = str(caught.value)
        assert "entry_X.csv" in message
        assert says in message

    def test_empty(self) -> None:
        with pytest.raises(InputError, match="contains neither"):
            sheet("# address: 1\npoint,position,value,unit\n")


class TestRequest:
    def test_detection_unit_is_asked_for(self) -> None:
        with pytest.raises(UsageError, match="detection_unit of axis 1, 2, 3"):
            control(WHOLE, options={})
        for wrong in (0, -0.001, "fine", True, math.nan, [0.001]):
            with pytest.raises(UsageError, match="detection_unit"):
                control(WHOLE, options={"detection_unit": wrong})

    def test_options_of_one_axis_go_over_the_others(self) -> None:
        box = control(WHOLE, axis_options={"3": {"detection_unit": 0.0001}})
        assert values(box, [0], DOWN, "3") == [pytest.approx(-0.0006, abs=EXACT)]
        assert values(box, [0], DOWN, "1") == [-0.004]
        only = control(WHOLE, options={}, axis_options={"1": UM})
        assert values(only, [100], UP) == [0.003]
        with pytest.raises(UsageError, match="detection_unit of axis 3"):
            only.correction("3", np.zeros(1), UP)

    @pytest.mark.parametrize(
        "option",
        [
            {"output": "smooth"}, {"pitch_sign": 1}, {"offset_sign": "plus"},
            {"offset_magnified": "maybe"}, {"increment_limit": 0},
            {"increment_limit": 128}, {"increment_limit": 7.5}, {"increment_limit": "many"},
            {"reference": "home"},
            {"reference_return": "up"}, {"reference_return": ["+"]},
        ],
    )  # fmt: skip
    def test_wrong_options(self, option: dict[str, object]) -> None:
        with pytest.raises(UsageError, match=next(iter(option))):
            control(WHOLE, options={**UM, **option})

    def test_kind_by_file_caller_or_unit(self) -> None:
        told = control(ROTARY.replace("N01006Q1A1P00000001\n", ""), kinds={"1": AxisKind.ROTARY})
        assert values(told, [405], UP) == [0.002]
        by_turn = control(ROTARY.replace("N01006Q1A1P00000001", "N03625Q1A1P360.0"))
        assert values(by_turn, [405], UP) == [0.002]
        assert any(a.fact == "kind of 1" and a.value == "rotary" for a in by_turn.assumed)
        against = control(
            WHOLE.replace("N03605", "N01006Q1A1P00000000\nN03605"), kinds={"1": AxisKind.ROTARY}
        )
        assert values(against, [405], UP) == [0.002]  # held beyond 200
        assert any("1006#0 = 0" in note for note in against.notes)

    def test_unknown_axis_and_no_cross_tables(self) -> None:
        box = control(WHOLE)
        with pytest.raises(UsageError, match="no data of axis 7"):
            box.correction("7", np.zeros(1), UP)
        crossing = getattr(box, "cross")()  # noqa: B009  # not in the protocol of this version
        assert crossing == ()
        with pytest.raises(UsageError, match="2 over the position of 1"):
            getattr(box, "cross_correction")("1", "2", np.zeros(1), UP)  # noqa: B009

    def test_any_shape(self) -> None:
        grid = np.linspace(-300, 300, 12).reshape(3, 4)
        for options in (UM, {**UM, "output": "ramp"}):
            box = control(WHOLE, options=options)
            assert box.correction("1", grid, DOWN).shape == (3, 4)
            assert box.correction("1", np.array(5.0), DOWN).shape == ()
            assert np.array_equal(
                box.correction("1", grid, UP).ravel(), box.correction("1", grid.ravel(), UP)
            )


class TestSpeed:
    def test_backup_of_15000_lines(self) -> None:
        other = "".join(
            f"N{n:05d}Q1A1P{n % 7}A2P0A3P0A4P0A5P0\n"
            for n in range(4000, 9999)
            if not 5700 < n < 5900
        )
        data = "".join(f"N{10000 + n}Q0P{INCREMENTS.get(n, 0)}\n" for n in range(1536))
        text = (
            PARAMETERS.removesuffix("%\n")
            + other
            + other.replace("Q1", "")
            + data
            + "N00000Q1L1P00000010\n" * 2000
            + "%\n"
        )
        assert text.count("\n") > 15000
        start = time.process_time()
        box = control(text)
        assert time.process_time() - start < 0.7  # s of the processor; measured 0.07
        assert values(box, [100], UP) == [0.003]

    @pytest.mark.parametrize("output", ["step", "ramp"])
    def test_many_positions_over_many_points(self, output: str) -> None:
        increments = {n: (-1) ** n for n in range(1500)}
        text = table_text(increments, reference=700, lowest=0, highest=1499, interval=2.0)
        box = control(text, options={**UM, "output": output})
        positions = np.linspace(-1500, 1700, 100_000)
        taken = []
        for _ in range(3):  # a collection of garbage alone may take 0.07 s
            start = time.process_time()
            box.correction("1", positions, UP)
            taken.append(time.process_time() - start)
        assert min(taken) < 0.1  # s of the processor; measured 0.003 and 0.008

    @pytest.mark.parametrize(
        "line",
        [
            "(" * 200_000,
            "N03620" + "A1P1" * 50_000,
            "N" + "1" * 200_000,
            "1" * 200_000,
            "N3620" + " " * 200_000,
        ],
    )
    def test_long_lines_end(self, line: str) -> None:
        start = time.process_time()
        with contextlib.suppress(InputError):
            control(WHOLE.replace("N03620", line + "\nN03620", 1))
        assert (
            time.process_time() - start < 1.0
        )  # s of the processor; a quadratic search takes minutes


def ask_everything(files: list[ControlFile], form: str = "fanuc-30i") -> None:
    """Load and ask; only InputError may come out (the options are good)."""
    try:
        box = virtual_control(form, files, options=UM)
    except InputError:
        return
    for address in box.addresses():
        for direction in Direction:
            answer = box.correction(address, np.linspace(-1e3, 1e3, 7), direction)
            assert answer.shape == (7,)
            assert np.all(np.isfinite(answer))
        assert np.all(np.diff(box.points(address)) > 0)


def mutated(text: str) -> st.SearchStrategy[bytes]:
    """Cuts, doublings and replaced bytes of a good file."""
    content = text.encode()

    def apply(edits: list[tuple[int, int, bytes]]) -> bytes:
        result = content
        for start, length, new in edits:
            at = start % (len(result) + 1)
            result = result[:at] + new + result[at + length :]
        return result

    fragments = [
        b"\n",
        b"P",
        b"-",
        b"9",
        b"A",
        b"Q0",
        b"%",
        b".",
        b",",
        b"N10040",
        b"A1P1",
        b"(",
        b"\r",
        b"0",
    ]
    edit = st.tuples(
        st.integers(0, 600), st.integers(0, 30), st.sampled_from(fragments) | st.binary(max_size=3)
    )
    return st.lists(edit, min_size=1, max_size=4).map(apply)


@given(
    content=st.binary(max_size=200)
    | mutated(WHOLE)
    | mutated(ROTARY)
    | mutated(BOTH)
    | mutated(PROGRAM)
)
@example(b"N03620Q1A1P" + b"9" * 5000)
@example(b"N03624Q1A1P" + b"9" * 400 + b".0")
@example(b"N" + b"9" * 5000 + b"P1")
@settings(max_examples=200, deadline=None)
def test_any_bytes(content: bytes) -> None:
    ask_everything([ControlFile("a.txt", content)])
    ask_everything(
        [ControlFile("a.txt", content), ControlFile("b.txt", POINTS.encode())], "fanuc-0i-16i"
    )


@given(content=st.binary(max_size=200) | mutated(SHEET))
@example(SHEET.replace("50.0", "9" * 400).encode())
@settings(max_examples=100, deadline=None)
def test_any_bytes_in_a_sheet(content: bytes) -> None:
    ask_everything([ControlFile("entry_1.csv", content)])
    ask_everything([ControlFile("a.txt", WHOLE.encode()), ControlFile("entry_1.csv", content)])
