"""The virtual HEIDENHAIN controls against the manuals' figures and signs, worked by hand, injected
errors and brute force.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.controllers.virtual_control import VirtualControl, virtual_control
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE

#: mm or deg: sums and products of a few decimal numbers in binary.
ROUNDING = 1e-12

# Shape of the classic dump; X = F(X) and Y = F(X), errors in mm. DIST is the spacing itself.
COM = """BEGIN X      .COM MM DATUM:-400 DIST:16
NR   1=F()     2=F()     3=F()     4=F()     5=F()
0    +0        +0
1    -0.0012   +0.0003
2    -0.0021   +0.0006
END   X      .COM
"""
CMA = """BEGIN CONFIG .CMA MM
NR   1         2         3
0    X
END   CONFIG .CMA
"""
NCK_COM = """BEGIN X.COM MM
NR  AXISPOS    BACKLASH   X          Y
0   -400       +0.0040    +0.0000    +0.0000
1   -200       +0.0021    -0.0018    +0.0015
2   +0         +0.0043    +0.0007    +0.0030
[END]
"""
NCK_CMA = """BEGIN CONFIG.CMA MM
NR  ACTIVE  X      Y
0   *       X.COM
[END]
"""
SHEET = """# axis: X
# value: error
point,position,value,unit
0,-90,0,mm
1,-40,0.0030,mm
2,10,-0.0010,mm
MP710,,0.0040,mm
MP730,,1,
"""


def itnc(files: Mapping[str, str | bytes], **request: object) -> VirtualControl:
    return control("heidenhain-itnc530", files, **request)


def nck(files: Mapping[str, str | bytes], **request: object) -> VirtualControl:
    return control("heidenhain-nck", files, **request)


def control(format_id: str, files: Mapping[str, str | bytes], **request: object) -> VirtualControl:
    given_files = [
        ControlFile(name, text.encode() if isinstance(text, str) else text)
        for name, text in files.items()
    ]
    # # keywords pass through
    return virtual_control(format_id, given_files, **request)  # type: ignore[arg-type]


def values(
    loaded: VirtualControl, address: str, positions: Sequence[float], direction: Direction = UP
) -> list[float]:
    return [float(value) for value in loaded.correction(address, np.array(positions), direction)]


def crossed(
    loaded: VirtualControl, moving: str, output: str, positions: Sequence[float]
) -> list[float]:
    found = [
        loaded.cross_correction(moving, output, np.array(positions), direction).tolist()
        for direction in Direction
    ]
    assert found[0] == found[1]  # these tables know no direction
    return [float(value) for value in found[0]]


def pairs(loaded: VirtualControl) -> tuple[tuple[str, str], ...]:
    return loaded.cross()


def facts(loaded: VirtualControl) -> dict[str, str]:
    return {assumption.fact: assumption.value for assumption in loaded.assumed}


def com(
    rows: Sequence[str],
    head: str = "DATUM:0 DIST:10",
    heading: str = "NR   1=F()     2=F()",
    unit: str = "MM",
) -> str:
    body = "\n".join(f"{index:<4} {row}" for index, row in enumerate(rows))
    return f"BEGIN X      .COM {unit} {head}\n{heading}\n{body}\nEND   X      .COM\n"


class TestItncTables:
    def test_errors_are_taken_away_between_and_beyond_the_points(self) -> None:
        loaded = itnc({"X.COM": COM, "CONFIG.CMA": CMA})
        # -384: minus the error -0.0012; -376: half way to -0.0021; both ends held
        positions = [-500, -400, -392, -384, -376, -368, 0]
        for direction in (UP, DOWN):
            assert values(loaded, "X", positions, direction) == pytest.approx(
                [0, 0, 0.0006, 0.0012, 0.00165, 0.0021, 0.0021], abs=ROUNDING
            )
        assert crossed(loaded, "X", "Y", positions) == pytest.approx(
            [0, 0, -0.00015, -0.0003, -0.00045, -0.0006, -0.0006], abs=ROUNDING
        )
        assert loaded.points("X").tolist() == [-400, -384, -368]
        assert loaded.addresses() == ("X", "Y")
        assert pairs(loaded) == (("X", "Y"),)
        assert loaded.points("Y").size == 0
        assert values(loaded, "Y", [-384]) == [0.0]  # what X does to Y is no correction of Y by Y

    def test_table_of_a_measured_machine_removes_its_error(self) -> None:
        # 5 µm too far at 20 mm, 2 µm short at 10 mm: the table holds e itself
        error = np.array([0.0, -0.002, 0.005])
        loaded = itnc({"X.COM": com([f"{value:+.4f}" for value in error])})
        left = error + loaded.correction("X", np.array([0.0, 10, 20]), UP)
        assert np.max(np.abs(left)) < ROUNDING

    def test_values_may_be_corrections(self) -> None:
        loaded = itnc({"X.COM": COM, "C.CMA": CMA}, options={"table_values": "correction"})
        assert values(loaded, "X", [-384]) == [-0.0012]
        assert crossed(loaded, "X", "Y", [-384]) == [0.0003]
        by_axis = itnc(
            {"X.COM": COM, "C.CMA": CMA}, axis_options={"X": {"table_values": "correction"}}
        )
        assert values(by_axis, "X", [-384]) == [-0.0012]

    def test_exponent_counts_tenths_of_a_micrometre(self) -> None:
        # the figure of the TNC 407: datum -90, n = 16, every second point at -76.8928, -63.7856
        rows = ["+0", "+0.001", "+0.002", "+0.003", "+0.004"]
        text = com(rows, "DATUM:-90 DIST:16")
        loaded = itnc({"X.COM": text}, options={"spacing_rule": "power_of_two"})
        assert loaded.points("X")[[0, 2, 4]].tolist() == pytest.approx(
            [-90, -76.8928, -63.7856], abs=1e-9
        )
        assert values(loaded, "X", [-76.8928, -63.7856]) == pytest.approx(
            [-0.002, -0.004], abs=ROUNDING
        )
        assert (
            itnc({"X.COM": text}).points("X")[1] == -74.0
        )  # without the rule DIST is the spacing in mm
        assert facts(itnc({"X.COM": text}))["spacing_rule of X.COM"] == "free"

    @pytest.mark.parametrize("distance", ["24", "-1", "6.5"])
    def test_exponent_out_of_range(self, distance: str) -> None:
        with pytest.raises(InputError, match="exponent from 0 to 23"):
            itnc(
                {"X.COM": com(["+0", "+1"], f"DATUM:0 DIST:{distance}")},
                options={"spacing_rule": "power_of_two"},
            )

    def test_column_numbers_are_axes(self) -> None:
        heading = "NR   1=F()     2=F()     3=F()     4=F()     5=F()     6=F()     7=F()"
        rows = [
            "0         0         0         0         0         0         0",
            "1         2         3         4         5         6         7",
        ]
        loaded = itnc({"X.COM": com(rows, heading=heading)})
        assert loaded.addresses() == ("X", "Y", "Z", "A", "B", "C", "7")
        assert values(loaded, "X", [10]) == [-1.0]
        assert [crossed(loaded, "X", axis, [10])[0] for axis in ("Y", "Z", "A", "B", "C", "7")] == [
            -2,
            -3,
            -4,
            -5,
            -6,
            -7,
        ]

    def test_blank_cells_are_bridged(self) -> None:
        rows = ["+0        +0", "          +0.001", "", "+0.006    +0.002"]
        loaded = itnc({"X.COM": com(rows)})
        # X: straight from 0 at 0 to 6 µm at 30; Y: 1 µm at 10, then straight to 2 µm at 30
        assert values(loaded, "X", [10, 20]) == pytest.approx([-0.002, -0.004], abs=ROUNDING)
        assert crossed(loaded, "X", "Y", [10, 20]) == pytest.approx([-0.001, -0.0015], abs=ROUNDING)
        assert loaded.points("X").tolist() == [0, 30]

    def test_cells_aligned_to_the_right_end_of_a_heading(self) -> None:
        rows = [
            "  NR     1=F()     2=F()",
            "   0        +0        +0",
            "   1             +0.0010",
            "   2   +0.0050   +0.0020",
        ]
        text = "\n".join(["BEGIN X .COM MM DATUM:0 DIST:10", *rows, "END X .COM", ""])
        loaded = itnc({"X.COM": text})
        assert values(loaded, "X", [10, 20]) == pytest.approx([-0.0025, -0.005], abs=ROUNDING)
        assert crossed(loaded, "X", "Y", [10]) == pytest.approx([-0.001], abs=ROUNDING)

    def test_whole_blank_column_is_no_table(self) -> None:
        loaded = itnc({"X.COM": com(["          +0", "          +0.003"])})
        assert loaded.addresses() == ("Y",)
        assert crossed(loaded, "X", "Y", [10]) == [-0.003]
        with pytest.raises(UsageError, match="no data of axis X"):
            loaded.correction("X", np.zeros(1), UP)
        with pytest.raises(UsageError, match="no table"):
            crossed(loaded, "Y", "X", [0])

    def test_inch(self) -> None:
        rows = ["+0        +0", "+0.0010   +0.0020"]
        loaded = itnc({"X.COM": com(rows, "DATUM:-1 DIST:2", "NR   1=F()     4=F()", "INCH")})
        assert loaded.points("X").tolist() == pytest.approx([-25.4, 25.4], abs=ROUNDING)
        assert values(loaded, "X", [25.4]) == pytest.approx([-0.0254], abs=ROUNDING)
        assert crossed(loaded, "X", "A", [25.4]) == pytest.approx(
            [-0.002], abs=ROUNDING
        )  # an angle is no length
        assert any("inch" in value for value in facts(loaded).values())

    def test_same_file_in_other_clothes(self) -> None:
        wanted = values(itnc({"X.COM": COM, "C.CMA": CMA}), "X", [-390, -376])
        for text in (
            COM.replace("\n", "\r\n"),
            "\ufeff" + COM,
            COM.replace("X      .COM", "X.COM"),
            COM.replace("DATUM:-400 DIST:16", "DIST: 16.0 DATUM: -400.000"),
            COM.replace("\n0 ", "\n\n0 "),
            COM.lower().replace("mm", "MM"),
            COM.replace("END   X      .COM", "[END]"),
        ):
            assert values(itnc({"any.txt": text, "C.CMA": CMA}), "x", [-390, -376]) == wanted
        assert (
            values(itnc({"all.txt": "; exported\n" + COM + "\n" + CMA}), "X", [-390, -376])
            == wanted
        )


class TestItncAssignment:
    def test_column_of_the_cma_is_the_moving_axis(self) -> None:
        loaded = itnc({"X.COM": COM, "C.CMA": CMA.replace("0    X", "0              X")})
        # the same table under Y: its column 1 is now X = F(Y), its column 2 is Y = F(Y)
        assert pairs(loaded) == (("Y", "X"),)
        assert crossed(loaded, "Y", "X", [-384]) == [0.0012]
        assert values(loaded, "Y", [-384]) == [-0.0003]

    def test_only_the_marked_line_acts(self) -> None:
        other = COM.replace("X      .COM", "X2     .COM").replace("-0.0012", "-0.0099")
        lines = (
            "BEGIN M .CMA MM\nNR   STATUS    1         2\n0              X\n1    M         X2\nEND"
            " M .CMA\n"
        )
        files = {"X.COM": COM, "X2.COM": other}
        second = itnc({**files, "M.CMA": lines})
        assert values(second, "X", [-384]) == [0.0099]
        assert any("X.COM does not act" in note for note in second.notes)
        first = itnc(
            {
                **files,
                "M.CMA": (
                    lines.replace("0              X", "0    M         X").replace(
                        "1    M         X2", "1              X2"
                    )
                ),
            }
        )
        assert values(first, "X", [-384]) == [0.0012]
        for marks in (
            lines.replace("M         X2", "          X2"),
            lines.replace("0              X", "0    M         X"),
        ):
            with pytest.raises(InputError, match="which line is active"):
                itnc({**files, "M.CMA": marks})

    def test_table_that_the_cma_leaves_out(self) -> None:
        loaded = itnc(
            {
                "X.COM": COM,
                "Y.COM": COM.replace("X      .COM", "Y      .COM"),
                "C.CMA": CMA.replace("0    X", "0    Y"),
            }
        )
        assert values(loaded, "X", [-384]) == [0.0012]  # by Y.COM, which stands under X
        assert any("X.COM does not act" in note for note in loaded.notes)

    def test_missing_and_doubled_tables(self) -> None:
        with pytest.raises(InputError, match=r"Q\.COM under X was not given"):
            itnc({"X.COM": COM, "C.CMA": CMA.replace("0    X", "0    Q")})
        with pytest.raises(InputError, match=r"X\.COM under X was given twice"):
            itnc({"a": COM, "b": COM, "C.CMA": CMA})
        with pytest.raises(InputError, match="two tables have the same name"):
            itnc({"a": COM, "b": COM})
        with pytest.raises(InputError, match=r"a second \.CMA"):
            itnc({"X.COM": COM, "C.CMA": CMA, "D.CMA": CMA})

    def test_without_cma_the_name_says_the_axis(self) -> None:
        loaded = itnc({"X.COM": COM})
        assert values(loaded, "X", [-384]) == [0.0012]
        assert facts(loaded)["axis that moves X.COM"] == "X"
        by_file = itnc({"Y.COM": COM.replace("X      .COM", "PITCH  .COM")})
        assert pairs(by_file) == (("Y", "X"),)
        assert values(by_file, "Y", [-384]) == [-0.0003]
        nameless = COM.replace("X      .COM", "PITCH  .COM")
        assert values(itnc({"p.COM": nameless}, options={"axis": "X"}), "X", [-384]) == [0.0012]
        for name, text in (("p.COM", nameless), ("Y.COM", COM)):  # no axis, and two
            with pytest.raises(InputError, match="which axis this table is moved"):
                itnc({name: text})


class TestItncParameters:
    def test_linear_error_is_taken_away_from_the_reference(self) -> None:
        # 10 µm too far on 1000 mm of travel: MP720 = +0.010 mm/m
        loaded = itnc(
            {"mp.txt": "MP720.0 : 0.0100\nMP720.1 : -0.0200\nMP710.0 : 0\n"}, reference={"X": 100.0}
        )
        assert values(loaded, "X", [100, 1100, -400]) == pytest.approx(
            [0, -0.010, 0.005], abs=ROUNDING
        )
        assert values(loaded, "Y", [500], DOWN) == pytest.approx([0.010], abs=ROUNDING)
        error = 10e-6 * (np.array([100.0, 600, 1100]) - 100.0)
        assert (
            np.max(np.abs(error + loaded.correction("X", np.array([100.0, 600, 1100]), UP)))
            < ROUNDING
        )
        assert facts(itnc({"mp.txt": "MP720.0 : 0.01\n"}))["reference of X"] == "0"

    @pytest.mark.parametrize(("returning", "up", "down"), [(UP, 0.0, -0.004), (DOWN, 0.004, 0.0)])
    def test_backlash_goes_on_in_the_direction_of_motion(
        self, returning: Direction, up: float, down: float
    ) -> None:
        loaded = itnc(
            {"mp.txt": "MP710.0 : 0.0040\nMP710.3 : -0.0010\n"},
            reference_return={"X": returning, "A": returning},
        )
        assert values(loaded, "X", [5.0], UP) == [up]
        assert values(loaded, "X", [5.0], DOWN) == [down]
        assert values(loaded, "A", [5.0], UP) == [-up / 4]
        assert facts(loaded)["zero state of MP710 of X"].startswith("arriving")

    def test_backlash_of_a_table_that_travels_too_short_removes_it(self) -> None:
        # encoder ahead: arriving in - the table stands 4 µm too high
        error = {UP: 0.0, DOWN: 0.004}
        loaded = itnc({"mp.txt": "MP710.0 : 0.0040"})
        assert [error[d] + values(loaded, "X", [100], d)[0] for d in (UP, DOWN)] == pytest.approx(
            [0, 0], abs=ROUNDING
        )

    @pytest.mark.parametrize(
        ("mask", "x", "y"),
        [("%00001", 1, 0), ("%00010", 0, 1), ("%00011", 1, 1), ("2", 0, 1), ("%0", 0, 1)],
    )
    def test_tables_or_linear_error_never_both(self, mask: str, x: int, y: int) -> None:
        text = f"MP720.0 : 0.1\nMP720.1 : 0.2\nMP730 : {mask}\n"
        loaded = itnc({"X.COM": COM, "C.CMA": CMA, "mp.txt": text})
        table, linear = 0.0012, 0.1 * 384 / 1000
        assert values(loaded, "X", [-384]) == pytest.approx([table if x else linear], abs=ROUNDING)
        # without its bit in the file an axis with a table counts as nonlinear; the bit of the
        # corrected axis counts
        assert crossed(loaded, "X", "Y", [-384]) == [-0.0003 if y else 0.0]
        assert values(loaded, "Y", [-384]) == pytest.approx(
            [0.0 if y else 0.2 * 384 / 1000], abs=ROUNDING
        )
        assert any("its tables do not act" in note for note in loaded.notes) == (not x or not y)
        assert any("MP720 of" in note for note in loaded.notes) == bool(x or y)

    def test_bit_without_a_table_kills_the_linear_error(self) -> None:
        loaded = itnc({"mp.txt": "MP720.0 : 0.1\nMP730 : %1\n"})
        assert values(loaded, "X", [1000]) == [0.0]
        assert any("old tables may act" in note for note in loaded.notes)

    def test_no_linear_error_on_rotary_axes(self) -> None:
        loaded = itnc({"mp.txt": "MP720.5 : 0.1\n"})
        assert values(loaded, "C", [90]) == [0.0]
        assert any("rotary" in note for note in loaded.notes)
        assert facts(loaded)["kind of C"] == "rotary"
        assert values(
            itnc({"mp.txt": "MP720.5 : 0.1\n"}, kinds={"C": AxisKind.LINEAR}), "C", [100]
        ) == pytest.approx([-0.01], abs=ROUNDING)

    def test_table_backlash_and_other_lines_together(self) -> None:
        text = "; backup\nMP100 : XYZ\nMP710.0 : 0.0100 ;play\nMP7100.0 : 5\nhello\n"
        loaded = itnc({"X.COM": COM, "C.CMA": CMA, "mp.txt": text})
        assert values(loaded, "X", [-384], DOWN) == pytest.approx([0.0012 - 0.01], abs=ROUNDING)
        assert any("line 5: not a machine parameter" in note for note in loaded.notes)
        assert itnc({"one.txt": COM + CMA + "MP710.0 : 0.01\n"}).correction(
            "X", np.array(-384.0), DOWN
        ) == pytest.approx(-0.0088)


class TestRotary:
    TURN = com([f"{0.001 * (k % 4)}" for k in range(5)], "DATUM:0 DIST:90", "NR   6=F()").replace(
        "X      ", "C      "
    )

    def test_table_of_a_whole_turn_repeats(self) -> None:
        loaded = itnc({"C.COM": self.TURN})
        # 0, 1, 2, 3, 0 thousandths at 0, 90 .. 360; -45 is 315, 405 is 45
        wanted = [-0.0015, 0, -0.0005, -0.001, -0.0015, 0, -0.0005, -0.003]
        assert values(loaded, "C", [-45, 0, 45, 90, 315, 360, 405, -90]) == pytest.approx(
            wanted, abs=ROUNDING
        )
        assert facts(loaded)["turn of C"] == "360"
        assert not any("jumps" in note for note in loaded.notes)

    def test_linear_axis_does_not_repeat(self) -> None:
        loaded = itnc({"C.COM": self.TURN}, kinds={"C": AxisKind.LINEAR})
        assert values(loaded, "C", [-90, 450]) == [0.0, 0.0]

    def test_short_table_repeats_only_when_told(self) -> None:
        short = self.TURN.replace("4    0.0\n", "")
        assert values(itnc({"C.COM": short}), "C", [-90, 315, 450]) == [0.0, -0.003, -0.003]  # held
        told = itnc({"C.COM": short}, modulo={"C": 360.0})
        assert values(told, "C", [-90, 315, 450]) == pytest.approx(
            [-0.003, -0.003, -0.001], abs=ROUNDING
        )
        assert any("jumps by -0.003" in note for note in told.notes)
        with pytest.raises(UsageError, match=r"axis C has a wrong .modulo.*found 180"):
            itnc({"C.COM": short}, modulo={"C": 180.0})

    def test_entries_outside_the_turn_are_not_used(self) -> None:
        # a tilting axis from -90 to 90: nothing but 0 to 360 deg is used
        text = com(["0.004", "0.001", "0.003"], "DATUM:-90 DIST:90", "NR   4=F()").replace(
            "X      ", "A      "
        )
        loaded = itnc({"A.COM": text})
        assert values(loaded, "A", [-90, -45, 0, 45]) == pytest.approx(
            [-0.001, -0.001, -0.001, -0.002], abs=ROUNDING
        )
        assert any("outside 0 to 360" in note for note in loaded.notes)
        above = itnc({"A.COM": text.replace("DATUM:-90 DIST:90", "DATUM:180 DIST:180")})
        assert values(above, "A", [0, 270, 360, 450, 540]) == pytest.approx(
            [-0.004, -0.0025, -0.001, -0.001, -0.001], abs=ROUNDING
        )
        listed = (
            "BEGIN A.COM MM\nNR  AXISPOS    A\n0   -90        0.004\n1   0          0.001\n2   90  "
            "       0.003\n[END]\n"
        )
        assert values(nck({"A.COM": listed}), "A", [-90, -45]) == pytest.approx(
            [-0.004, -0.0025], abs=ROUNDING
        )

    def test_exponent_beyond_the_turn(self) -> None:
        # 2^16 * 0.0001 deg = 6.5536 deg: 56 points end at 360.448, a straight line of 0.001 per
        # step; 360 deg is row 54.9316...
        rows = [f"{0.001 * k:.3f}" for k in range(56)]
        text = com(rows, "DATUM:0 DIST:16", "NR   6=F()").replace("X      ", "C      ")
        loaded = itnc({"C.COM": text}, options={"spacing_rule": "power_of_two"})
        assert values(loaded, "C", [359.0, 361.0]) == pytest.approx(
            [-0.359 / 6.5536, -0.001 / 6.5536], abs=1e-12
        )
        assert any("jumps by -0.0549" in note for note in loaded.notes)


class TestSheets:
    def test_points_and_parameters(self) -> None:
        loaded = itnc({"entry_X.csv": SHEET})
        assert loaded.addresses() == ("X",)
        assert loaded.points("X").tolist() == [-90, -40, 10]
        assert values(loaded, "X", [-100, -90, -65, -40, 10, 50]) == pytest.approx(
            [0, 0, -0.0015, -0.003, 0.001, 0.001], abs=ROUNDING
        )
        assert values(loaded, "X", [-40], DOWN) == pytest.approx([-0.007], abs=ROUNDING)
        assert not any(fact.startswith(("MP730", "MP710")) for fact in facts(loaded))
        correction = itnc(
            {"entry_X.csv": SHEET.replace("value: error", "value: correction")},
            options={"table_values": "error"},
        )
        assert values(correction, "X", [-40]) == [0.003]  # the sheet says it, not the option

    def test_micrometres_and_other_clothes(self) -> None:
        wanted = values(itnc({"entry_X.csv": SHEET}), "X", [-65, 0], DOWN)
        for text in (
            SHEET.replace("0.0030,mm", "3.0,um").replace("0.0040,mm", "4,um"),
            "\ufeff" + SHEET.replace("\n", "\r\n"),
            SHEET.replace(
                "# axis: X", "# address: x\n# axis: lengthwise\n# machine: Müller 3\n# no key"
            ),
            SHEET.replace("# axis: X\n", ""),
            SHEET.replace(",", " , ").replace("MP730,,1,\n", "MP730 , , 1 ,\n\n"),
        ):
            assert values(itnc({"entry_X.csv": text}), "X", [-65, 0], DOWN) == pytest.approx(
                wanted, abs=ROUNDING
            )
        assert itnc({"entry_y.CSV": SHEET.replace("# axis: X\n", "")}).addresses() == ("Y",)

    def test_parameters_alone(self) -> None:
        text = (
            "# axis: X\n# value:"
            " error\npoint,position,value,unit\nMP720,,0.0100,mm/m\nMP710,,0.002,mm\n"
        )
        loaded = itnc({"entry_X.csv": text}, reference={"X": -50.0})
        assert values(loaded, "X", [-50, 950], DOWN) == pytest.approx(
            [-0.002, -0.012], abs=ROUNDING
        )
        # a linear error keeps its own sign convention whatever the points are
        assert values(
            itnc({"s.csv": text.replace("value: error", "value: correction")}), "X", [1000]
        ) == pytest.approx([-0.010], abs=ROUNDING)
        assert values(itnc({"s.csv": text + "MP730,,1,\n"}), "X", [1000]) == [0.0]

    def test_linear_error_is_dead_beside_points(self) -> None:
        loaded = itnc({"entry_X.csv": SHEET + "MP720,,0.1,mm/m\n"})
        assert values(loaded, "X", [-40]) == [-0.003]
        assert any("MP720 of X has no effect" in note for note in loaded.notes)
        switched = itnc(
            {"entry_X.csv": SHEET.replace("MP730,,1", "MP730,,0") + "MP720,,0.1,mm/m\n"}
        )
        assert values(switched, "X", [-40]) == pytest.approx([0.004], abs=ROUNDING)
        assert switched.points("X").size == 3  # the table is there, it does not act

    def test_rotary(self) -> None:
        text = (
            "# axis: C\n# value:"
            " error\npoint,position,value,unit\n0,0,0,deg\n1,180,0.002,deg\n2,360,0,deg\nMP710,,0.001,deg\n"
        )
        loaded = itnc({"entry_C.csv": text})
        assert values(loaded, "C", [-90, 540], DOWN) == pytest.approx(
            [-0.002, -0.003], abs=ROUNDING
        )
        other = itnc(
            {"entry_W.csv": text.replace("axis: C", "axis: W")}
        )  # the unit says what the letter does not
        assert values(other, "W", [-90]) == pytest.approx([-0.001], abs=ROUNDING)
        with pytest.raises(
            InputError, match=r"the unit of axis C is unclear; expected mm, found deg"
        ):
            itnc({"entry_C.csv": text}, kinds={"C": AxisKind.LINEAR})
        play = "# axis: C\n# value: error\npoint,position,value,unit\nMP710,,0.001,mm\n"
        with pytest.raises(InputError, match="unit of the backlash of C; expected deg, found mm"):
            itnc({"entry_C.csv": text.replace("MP710,,0.001,deg\n", ""), "play.csv": play})

    def test_sheet_and_table_of_one_axis_agree_or_are_refused(self) -> None:
        sheet = (
            "# axis: X\n# value:"
            " error\npoint,position,value,unit\n0,-400,0,mm\n1,-384,-0.0012,mm\n2,-368,-0.0021,mm\n"
        )
        both = itnc({"X.COM": COM, "C.CMA": CMA, "entry_X.csv": sheet})
        assert values(both, "X", [-376]) == pytest.approx([0.00165], abs=ROUNDING)
        for wrong in (
            sheet.replace("0.0012", "0.0013"),
            sheet.replace("value: error", "value: correction"),
            sheet.replace("-384", "-384.9").replace("-368", "-369.8"),
        ):
            with pytest.raises(InputError, match="differs from that of"):
                itnc({"X.COM": COM, "C.CMA": CMA, "entry_X.csv": wrong})
        with pytest.raises(InputError, match="MP710 of X contradicts"):
            itnc({"mp.txt": "MP710.0 : 0.003\n", "entry_X.csv": SHEET})

    def test_grid_that_can_be_typed(self) -> None:
        power = SHEET.replace("-40,", "-83.4464,").replace("2,10,", "2,-76.8928,")
        assert (
            itnc({"entry_X.csv": power}, options={"spacing_rule": "power_of_two"}).points("X")[2]
            == -76.8928
        )
        for text, options in (
            (SHEET.replace("2,10", "2,11"), {}),
            (SHEET, {"spacing_rule": "power_of_two"}),
        ):
            with pytest.raises(InputError, match="not equally spaced"):
                itnc({"entry_X.csv": text}, options=options)

    def test_nck(self) -> None:
        points = "0,-90,0,mm\n1,-40,0.003,mm\n2,400,-0.001,mm\n"
        text = (
            "# address: X1\n# value:"
            f" error\npoint,position,value,unit\n{points}backLash,,0.004,mm\n"
        )
        loaded = nck({"entry_X.csv": text})
        assert loaded.addresses() == ("X1",)
        assert values(loaded, "X1", [-65, 400], DOWN) == pytest.approx(
            [-0.0055, -0.003], abs=ROUNDING
        )
        assert any("backLash also" in note for note in loaded.notes)
        with pytest.raises(UsageError, match="no data of axis x1"):  # names keep their case
            values(loaded, "x1", [0])
        linear = nck(
            {
                "s.csv": (
                    "# axis: X\n# value:"
                    " error\npoint,position,value,unit\nlinearCompValue,,0.01,mm/m\n"
                )
            },
            reference={"X": 100},
        )
        assert values(linear, "X", [100, 1100]) == pytest.approx([0, -0.01], abs=ROUNDING)
        assert any(
            "unconfirmed" in assumption.evidence and "linearCompValue" in assumption.fact
            for assumption in linear.assumed
        )


class TestNck:
    def test_tables_by_position(self) -> None:
        loaded = nck(
            {"X.COM": NCK_COM.replace("-200 ", "-300 "), "config.cma": NCK_CMA},
            options={"backlash_column": "second_curve"},
        )
        # points at -400, -300, 0: -150 is half way from -1.8 to 0.7 µm
        assert loaded.points("X").tolist() == [-400, -300, 0]
        assert values(loaded, "X", [-400, -300, -150, 50], UP) == pytest.approx(
            [0, 0.0018, 0.00055, -0.0007], abs=ROUNDING
        )
        assert values(loaded, "X", [-400, -300, -150, 50], DOWN) == pytest.approx(
            [-0.004, -0.0021, -0.0032, -0.0043], abs=ROUNDING
        )
        assert crossed(loaded, "X", "Y", [-350, 0]) == pytest.approx(
            [-0.00075, -0.003], abs=ROUNDING
        )
        assert facts(loaded)["BACKLASH in X.COM"].startswith("the whole curve")

    def test_backlash_column_is_the_curve_towards_minus(self) -> None:
        # MANUALplus 620 p. 715: no option is needed; a file may speak against it
        assert values(nck({"X.COM": NCK_COM}), "X", [-400, 0], DOWN) == [-0.004, -0.0043]
        assert values(nck({"X.COM": NCK_COM}), "X", [-400, 0], UP) == [0.0, -0.0007]
        with pytest.raises(InputError, match="column BACKLASH is not blank"):
            nck({"X.COM": NCK_COM}, options={"backlash_column": "absent"})
        equal = (
            NCK_COM.replace("+0.0040", "+0.0000")
            .replace("+0.0021", "-0.0018")
            .replace("+0.0043", "       ")
        )
        blank = (
            NCK_COM.replace("+0.0040", "       ")
            .replace("+0.0021", "       ")
            .replace("+0.0043", "       ")
        )
        without = "\n".join(
            line[:15] + line[26:] if line[:1] in "N012" else line for line in NCK_COM.split("\n")
        )
        for text in (equal, blank, without):
            for option in ("absent", "second_curve") if text is not equal else ("absent",):
                loaded = nck({"X.COM": text}, options={"backlash_column": option})
                for direction in (UP, DOWN):
                    assert values(loaded, "X", [-200, -100], direction) == pytest.approx(
                        [0.0018, 0.00055], abs=ROUNDING
                    )
        with pytest.raises(InputError, match="BACKLASH is blank at an end"):
            nck({"X.COM": equal}, options={"backlash_column": "second_curve"})

    def test_first_line_with_an_edition(self) -> None:
        for more in (
            " Version: 'Update:110.24'",
            " VERSION: 'Update:120.17 Date:2004-08-01'",
            " Version: 'Update:120.17 Date:2004-08-01' U",
            " U",
        ):
            loaded = nck({"X.COM": NCK_COM.replace("X.COM MM", "X.COM MM" + more)})
            assert values(loaded, "X", [-200], UP) == [0.0018]
        with pytest.raises(InputError, match="head of the table"):
            nck({"X.COM": NCK_COM.replace("X.COM MM", "X.COM MM Edition: 'x'")})

    def test_tables_that_describe_their_columns(self) -> None:
        # the value of X in row 1 begins beside the name X: only the widths say whose cell it is
        rows = (
            "NR      AXISPOS    BACKLASH  X        Y\n"
            "0       -400                 +0.0000  +0.0000\n"
            "1       -200                  -0.0018 +0.0015\n"
            "2       +0                   +0.0007  +0.0030\n[END]\n"
        )
        widths = {"NR": 8, "AXISPOS": 11, "BACKLASH": 10, "X": 9, "Y": 9}
        named = "BEGIN X.COM MM Version: 'Update:110.24'\n"
        new = "TableDescription (\n  columns:= [\n" + "".join(
            f'    CfgColumnDescription (\n      key:="{name}",\n      width:={width},\n'
            '      unit:=TEXT,\n      initial:="(0",\n      readonly:=FALSE\n    ),\n'
            for name, width in widths.items()
        )
        new += '  ],\n  primaryKey:="NR"\n)\n'
        old = "#STRUCTBEGIN\n" + "".join(
            f"   NAME = {name}\n     TYPE = N\n     WIDTH = {width - 1}\n     DEC = 4\n*   // x\n"
            for name, width in widths.items()
            if name != "NR"
        )
        old += "#STRUCTEND\n"
        key = new.replace('"NR"', '"KEY"')
        for text, table in (
            (new, rows),
            (old, rows),
            (key, rows.replace("NR      ", "KEY     ")),
        ):
            loaded = nck({"X.COM": named + text + table})
            assert values(loaded, "X", [-400, -200, 0], DOWN) == [0.0, 0.0018, -0.0007]
        for text in ("", new.replace("width:=9", "width:=12")):
            with pytest.raises(InputError, match="ambiguous to which column"):
                nck({"X.COM": named + text + rows})

    def test_descriptions_that_are_refused(self) -> None:
        begin = NCK_COM.split("\n", 1)
        for text, says in (
            ("#STRUCTBEGIN\n   NAME = X\n", "description of the table has no end"),
            ("TableDescription (\n  columns:= [\n", "description of the table has no end"),
            (
                'TableDescription (\n  key:="X",\n  unitIsInch:=TRUE\n)\n',
                "X is in inch of its own",
            ),
        ):
            with pytest.raises(InputError, match=says):
                nck({"X.COM": "\n".join([begin[0], text + begin[1]])})

    def test_second_curve_with_a_blank(self) -> None:
        loaded = nck(
            {"X.COM": NCK_COM.replace("+0.0021", "       ")},
            options={"backlash_column": "second_curve"},
        )
        assert values(loaded, "X", [-200], DOWN) == pytest.approx(
            [-0.00415], abs=ROUNDING
        )  # half way from 4.0 to 4.3 µm
        assert values(loaded, "X", [-200], UP) == [0.0018]
        assert loaded.points("X").tolist() == [-400, -200, 0]

    def test_backlash_needs_the_column_of_the_moving_axis(self) -> None:
        with pytest.raises(InputError, match="a column BACKLASH but no column"):
            nck(
                {"Z.COM": NCK_COM.replace("X.COM", "Z.COM")},
                options={"backlash_column": "second_curve"},
            )

    def test_star_switches_the_line_on(self) -> None:
        plain = "BEGIN {}.COM MM\nNR  AXISPOS    X\n0   0          0\n1   100        {}\n[END]\n"
        files = {"X.COM": plain.format("X", "0.001"), "X2.COM": plain.format("X2", "0.002")}
        lines = (
            "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X       Y\n0           X.COM\n1   *      "
            " X2.COM\n[END]\n"
        )
        assert values(nck({**files, "config.cma": lines}), "X", [100]) == [-0.002]
        first = lines.replace("0           X", "0   *       X").replace("1   *", "1    ")
        assert values(nck({**files, "config.cma": first}), "X", [100]) == [-0.001]
        none = nck({**files, "config.cma": lines.replace("*", " ")})
        assert values(none, "X", [100]) == [0.0]
        assert any("no line of the .CMA is active" in note for note in none.notes)
        alone = nck({"X.COM": files["X.COM"], "config.cma": NCK_CMA.replace("*", " ")})
        assert values(alone, "X", [100]) == [0.0]  # the only line, and yet the star decides
        starless = NCK_CMA.replace("ACTIVE", "      ").replace("*", " ")
        assert values(nck({"X.COM": files["X.COM"], "config.cma": starless}), "X", [100]) == [
            -0.001
        ]  # no column to mark
        with pytest.raises(InputError, match="which line is active"):
            nck({**files, "config.cma": lines.replace("0           X", "0   *       X")})
        with pytest.raises(InputError, match=r"expected \* or blank"):
            nck({**files, "config.cma": lines.replace("*", "x")})

    def test_axis_keys_are_the_same_in_both_files(self) -> None:
        with pytest.raises(
            InputError, match=r"axis that the \.CMA file does not contain; expected X or Z, found Y"
        ):
            nck(
                {"X.COM": NCK_COM, "config.cma": NCK_CMA.replace("Y", "Z")},
                options={"backlash_column": "second_curve"},
            )

    def test_one_table_under_two_axes(self) -> None:
        text = "BEGIN S.COM MM\nNR  AXISPOS    Y\n0   0          0\n1   100        0.002\n[END]\n"
        loaded = nck(
            {
                "S.COM": text,
                "c.cma": "BEGIN C.CMA MM\nNR  ACTIVE  X      Y\n0   *       S.COM  S.COM\n[END]\n",
            }
        )
        assert pairs(loaded) == (("X", "Y"),)
        assert values(loaded, "Y", [50]) == pytest.approx([-0.001], abs=ROUNDING)
        assert crossed(loaded, "X", "Y", [50]) == pytest.approx([-0.001], abs=ROUNDING)

    def test_squareness_ramp(self) -> None:
        # Y leans by 20 µm/m with X: e_y = 20e-6 * x; the ramp holds the error, the sum vanishes
        text = "BEGIN X.COM MM\nNR  AXISPOS    Y\n0   0          0\n1   1000       0.0200\n[END]\n"
        loaded = nck({"X.COM": text})
        x = np.linspace(0, 1000, 11)
        left = 20e-6 * x + np.array(crossed(loaded, "X", "Y", [float(p) for p in x]))
        assert np.max(np.abs(left)) < ROUNDING

    def test_inch_scales_positions_and_values(self) -> None:
        text = "BEGIN X.COM INCH\nNR  AXISPOS    X\n0   0          0\n1   10         0.001\n[END]\n"
        assert values(nck({"X.COM": text}), "X", [254, 127]) == pytest.approx(
            [-0.0254, -0.0127], abs=ROUNDING
        )


WRONG_ITNC = {
    "end missing": (COM.replace("END   X      .COM\n", ""), "no end line"),
    "end of another": (COM.replace("END   X ", "END   Y "), "end of another table"),
    "begins twice": ("BEGIN X      .COM MM DATUM:0 DIST:1\n" + COM, "no end line"),
    "no unit": (COM.replace(" MM ", " "), "head of the table"),
    "no datum": (COM.replace("DATUM:-400 ", ""), "lacks DATUM"),
    "two datums": (COM.replace("DIST:16", "DIST:16 DATUM:3"), "head of the table"),
    "datum in words": (COM.replace("-400", "-4x0"), "head of the table"),
    "no spacing": (COM.replace("DIST:16", "DIST:0"), "spacing above 0"),
    "row lost": (COM.replace("1    -0.0012   +0.0003\n", ""), "row number"),
    "comma": (COM.replace("-0.0012", "-0,0012"), "decimal point"),
    "exponent": (COM.replace("-0.0012", "-1.2E-3"), "decimal point"),
    "blank at the end": (COM.replace("-0.0021", "       "), "blank at an end"),
    "blank at the start": (
        COM.replace("0    +0        +0", "0              +0"),
        "blank at an end",
    ),
    "between headings": (COM.replace("-0.0012   +0.0003", "-0.0012        +0.03"), "ambiguous"),
    "across headings": (COM.replace("-0.0012   +0.0003", "-0.001234567890123"), "ambiguous"),
    "two under one": (COM.replace("-0.0012   +0.0003", "-0 +12"), "ambiguous"),
    "too many": (COM.replace("+0.0003", "+0.0003 1 2 3 4 5"), "ambiguous"),
    "tab": (COM.replace("-0.0012   +0.0003", "-0.0012\t+0.0003"), "ambiguous"),
    "no heading": (
        "\n".join(line for line in COM.split("\n") if "=F()" not in line),
        "the line of column headings is missing",
    ),
    "nck heading": (COM.replace("1=F()", "X    "), "column heading"),
    "column twice": (COM.replace("2=F()", "1=F()"), "two columns have the same name"),
    "column twice in other words": (
        COM.replace("2=F()", "01=F()"),
        "two columns belong to the same axis",
    ),
    "no rows": (
        "\n".join(line for line in COM.split("\n") if line[:1] not in "012" or not line),
        "no rows",
    ),
    "no values": (com(["", ""]), "no values"),
    "257 points": (com(["+0"] * 257), "at most 256"),
    "stray line": (COM + "something\n", "line cannot be read"),
    "nothing": ("hello\n", "line cannot be read"),
    "empty": ("", "no compensation data"),
    "only a mask": ("MP730 : %00001\n", "no compensation data"),
    "only a cma": (CMA.replace("0    X", "0"), "no compensation data"),
    "binary": ("MP710.0 : 0\x00", "binary"),
    "no index": ("MP710 : 0.004\n", "parameter cannot be read"),
    "index of a mask": ("MP730.0 : 1\n", "parameter cannot be read"),
    "no colon": ("MP710.0 0.004\n", "parameter cannot be read"),
    "axis 19": ("MP710.18 : 0.004\n", "parameter cannot be read"),
    "bad mask": ("MP730 : %0002\n", "MP730"),
    "eleven, or the first two axes": ("MP730 : 11\n", "MP730: .*%"),
    "micrometres as mm": ("MP710.0 : 4.0\n", "-1 to 1"),
    "linear out of range": ("MP720.0 : -1.5\n", "-1 to 1"),
    "two values": ("MP710.0 : 0.004\nMP710.0 : 0.005\n", "contradicts"),
    "cma cell between": (COM + CMA.replace("0    X", "0        X"), "ambiguous"),
    "two tables lines": (COM + CMA.replace("0    X", "0    X\n1    X"), "which line is active"),
    "cma axis 0": (COM + CMA.replace("1  ", "0  "), "each axis once"),
    "cma axis 19": (COM + CMA.replace("2  ", "19 "), "each axis once"),
    "cma axis twice": (COM + CMA.replace("2  ", "01 "), "each axis once"),
}


class TestRefusals:
    @pytest.mark.parametrize(("text", "message"), WRONG_ITNC.values(), ids=list(WRONG_ITNC))
    def test_itnc(self, text: str, message: str) -> None:
        with pytest.raises(InputError, match=message):
            itnc({"X.COM": text})

    @pytest.mark.parametrize(
        ("old", "new", "message"),
        [
            ("# value: error\n", "", "what its values are"),
            ("value: error", "value: errors", "what its values are"),
            ("# axis: X", "# axis: X\n# axis: Y", "a second # axis"),
            ("point,position,value,unit\n", "", "expected the header"),
            ("unit\n", "unit\npoint,position,value,unit\n", "a second header"),
            ("1,-40", "2,-40", "not in order"),
            ("0,-90,0,mm\n", "", "not in order"),
            ("-40,0.0030", "-95,0.0030", "do not ascend"),
            ("-40,0.0030", "-90,0.0030", "do not ascend"),
            ("0.0030", "0,0030", "four fields"),
            ("0.0030", "3e-3", "decimal point"),
            ("-40,", ",", "position"),
            ("0.0030,mm", "0.0030,µm", "unit of a point"),
            ("0.0030,mm", "0.0030,deg", "lengths and angles"),
            ("0.0040,mm", "0.0040,deg", "lengths and angles"),
            ("0.0040,mm", "0.0040,", "unit of MP710"),
            ("MP710,,", "MP710,0,", "no position"),
            ("MP710", "backLash", "expected a whole number from 0, or MP710"),
            ("MP730,,1", "MP730,,2", "0 or 1"),
            ("0.0040,mm", "4.0,mm", "-1 to 1"),
            ("MP730,,1,\n", "MP720,,0.1,mm\n", "unit of MP720"),
        ],
    )
    def test_sheet(self, old: str, new: str, message: str) -> None:
        assert old in SHEET
        with pytest.raises(InputError, match=message):
            itnc({"entry_X.csv": SHEET.replace(old, new, 1)})

    def test_sheet_that_says_nothing(self) -> None:
        head = "# value: error\npoint,position,value,unit\n"
        with pytest.raises(InputError, match="no points and no parameters"):
            itnc({"entry_X.csv": head})
        with pytest.raises(InputError, match="not an entry sheet"):
            itnc({"entry_X.csv": ""})
        with pytest.raises(InputError, match="name its axis"):
            itnc({"sheet.csv": head + "0,0,0,mm\n"})
        with pytest.raises(InputError, match="UTF-8"):
            itnc({"entry_X.csv": SHEET.encode() + b"# \xff\n"})
        with pytest.raises(InputError, match="binary"):
            itnc({"entry_X.csv": SHEET.encode("utf-16")})
        long = head + "".join(f"{k},{k},0,mm\n" for k in range(257))
        with pytest.raises(InputError, match="at most 256"):
            itnc({"entry_X.csv": long})
        with pytest.raises(InputError, match="at most 256, found 257"):
            nck({"entry_X.csv": long})

    @pytest.mark.parametrize(
        ("old", "new", "message"),
        [
            ("AXISPOS ", "POSITION", "NR AXISPOS"),
            ("-200", "-500", "do not ascend"),
            ("-200 ", "     ", "has no position"),
            ("MM\n", "MM DATUM:0 DIST:5\n", "nothing behind the unit"),
            ("[END]", "", "no end line"),
            ("+0.0015", "+0.0015x", "decimal point"),
            ("+0.0043", "+0.00a3", "column BACKLASH"),
        ],
    )
    def test_nck(self, old: str, new: str, message: str) -> None:
        assert old in NCK_COM
        with pytest.raises(InputError, match=message):
            nck(
                {"X.COM": NCK_COM.replace(old, new, 1)}, options={"backlash_column": "second_curve"}
            )

    def test_parameters_of_the_other_generation(self) -> None:
        with pytest.raises(InputError, match="not of this control"):
            nck({"mp.txt": "MP710.0 : 0.004\n"})
        with pytest.raises(InputError, match="backLash"):
            nck({"entry_X.csv": SHEET})

    def test_all_faults_at_once_with_their_lines(self) -> None:
        with pytest.raises(InputError) as raised:
            itnc(
                {
                    "X.COM": COM.replace("-0.0012", "-0,0012").replace("+0.0006", "six"),
                    "entry_Y.csv": "nonsense\n",
                }
            )
        lines = str(raised.value).splitlines()
        assert [line.split(": ")[:2] for line in lines][:3] == [
            ["X.COM", "line 4"],
            ["X.COM", "line 5"],
            ["entry_Y.csv", "line 1"],
        ]

    @pytest.mark.parametrize(
        ("option", "value"),
        [
            ("table_values", "errors"),
            ("spacing_rule", 2),
            ("reference_return", "up"),
            ("reference", "here"),
        ],
    )
    def test_wrong_options(self, option: str, value: object) -> None:
        with pytest.raises(UsageError, match=option):
            itnc({"X.COM": COM}, options={option: value})
        if option == "table_values":
            with pytest.raises(UsageError, match="backlash_column"):
                nck({"X.COM": NCK_COM}, options={"backlash_column": "yes"})


class TestProtocol:
    def test_any_shape(self) -> None:
        loaded = itnc(
            {"X.COM": COM, "C.CMA": CMA, "mp": "MP710.0 : 0.001\nMP710.2 : 0.1\nMP720.2 : 0.1\n"}
        )
        grid = np.linspace(-410, -360, 12).reshape(3, 4)
        for axis in ("X", "Z"):
            assert loaded.correction(axis, grid, DOWN).shape == (3, 4)
            assert loaded.correction(axis, np.array(5.0), DOWN).shape == ()
            assert np.array_equal(
                loaded.correction(axis, grid, UP).ravel(), loaded.correction(axis, grid.ravel(), UP)
            )
        assert loaded.cross_correction("X", "Y", grid, UP).shape == (3, 4)

    def test_what_is_not_sure_is_listed(self) -> None:
        listed = facts(itnc({"X.COM": COM}))
        assert listed["values of X.COM"] == "error"
        assert listed["outside the table of X"] == "the end values hold"
        assert listed["MP730 of X"] == "1"
        assert listed["reference_return of X"] == "+"
        assert len(listed) == len(itnc({"X.COM": COM}).assumed)  # each once

    def test_kinematics_columns_are_left_out_and_said(self) -> None:
        loaded = itnc(
            {"X.COM": com(["0         0", "0.001     0.002"], heading="NR   1=F()     C4")}
        )
        assert loaded.addresses() == ("X",)
        assert any("C4" in note for note in loaded.notes)

    def test_quick(self) -> None:
        rows = "".join(f"{k}  {k}  {k % 7 / 1000}\n" for k in range(15000))
        started = time.process_time()
        with pytest.raises(InputError, match="at most 256"):
            nck({"X.COM": f"BEGIN X.COM MM\nNR AXISPOS X\n{rows}[END]\n"})
        assert (
            time.process_time() - started < 2.0
        )  # s of the processor; 0.1 s here, and anything quadratic takes minutes
        started = time.process_time()
        for line in (
            "MP710" + " " * 200_000,
            "BEGIN " * 50_000,
            "0 " * 200_000,
            "[END]" * 50_000,
            "MP710." + "9" * 200_000,
        ):
            with pytest.raises(InputError):
                itnc({"X.COM": COM.replace("END", f"{line}\nEND"), "m": line})
        assert time.process_time() - started < 2.0  # s of the processor


def brute_force(nodes: Sequence[float], column: Sequence[float | None], x: float) -> float:
    """Walk along the rows that have a value; errors, so minus the straight line; ends held."""
    known = [(node, value) for node, value in zip(nodes, column, strict=True) if value is not None]
    if x <= known[0][0]:
        return -known[0][1]
    for (left, first), (right, second) in pairwise(known):
        if x <= right:
            return -(first + (second - first) * (x - left) / (right - left))
    return -known[-1][1]


CELL = st.none() | st.integers(-9999, 9999).map(lambda n: n / 10_000)
FULL = st.integers(-9999, 9999).map(lambda n: n / 10_000)


@st.composite
def columns(draw: st.DrawFn, count: int) -> list[list[float | None]]:
    """Columns of one length, their ends filled."""
    rows = draw(st.integers(2, 9))
    return [[draw(FULL), *(draw(CELL) for _ in range(rows - 2)), draw(FULL)] for _ in range(count)]


def cell(value: float | None) -> str:
    return "" if value is None else f"{value:+.4f}"


@given(
    table=columns(3),
    datum=st.integers(-5000, 5000),
    step=st.integers(1, 400),
    width=st.integers(8, 14),
)
@settings(max_examples=60, deadline=None)
def test_brute_force_itnc(
    table: list[list[float | None]], datum: int, step: int, width: int
) -> None:
    numbers = (2, 1, 6)
    heading = "NR   " + "".join(f"{n}=F()".ljust(width) for n in numbers)
    rows = [
        f"{k:<5}" + "".join(cell(column[k]).ljust(width) for column in table)
        for k in range(len(table[0]))
    ]
    text = "\n".join(
        [f"BEGIN X .COM MM DATUM:{datum / 10} DIST:{step / 10}", heading, *rows, "END X .COM", ""]
    )
    loaded = itnc({"X.COM": text})
    nodes = [datum / 10 + step / 10 * k for k in range(len(rows))]
    where = [float(x) for x in np.linspace(nodes[0] - 5, nodes[-1] + 5, 23)]
    for axis, column in zip(("Y", "X", "C"), table, strict=True):
        wanted = [brute_force(nodes, column, x) for x in where]
        got = values(loaded, "X", where) if axis == "X" else crossed(loaded, "X", axis, where)
        assert got == pytest.approx(
            wanted, abs=1e-9
        )  # mm; rounding of the positions times a slope below 20


@given(
    table=columns(2),
    starts=st.lists(st.integers(-9000, 9000), min_size=9, max_size=9, unique=True).map(sorted),
    second=st.booleans(),
    width=st.integers(9, 14),
)
@settings(max_examples=60, deadline=None)
def test_brute_force_nck(
    table: list[list[float | None]], starts: list[int], second: bool, width: int
) -> None:
    names = ("BACKLASH", "X") if second else ("Y1", "X")
    heading = "NR   " + "AXISPOS".ljust(width) + "".join(name.ljust(width) for name in names)
    nodes = [start / 10 for start in starts[: len(table[0])]]
    rows = [
        f"{k:<5}" + f"{nodes[k]}".ljust(width) + "".join(cell(c[k]).ljust(width) for c in table)
        for k in range(len(nodes))
    ]
    loaded = nck(
        {"X.COM": "\n".join(["BEGIN X.COM MM", heading, *rows, "[END]", ""])},
        options={"backlash_column": "second_curve"},
    )
    where = [float(x) for x in np.linspace(nodes[0] - 5, nodes[-1] + 5, 23)]
    other = values(loaded, "X", where, DOWN) if second else crossed(loaded, "X", "Y1", where)
    assert values(loaded, "X", where, UP) == pytest.approx(
        [brute_force(nodes, table[1], x) for x in where], abs=1e-9
    )
    assert other == pytest.approx([brute_force(nodes, table[0], x) for x in where], abs=1e-9)


def ask_everything(format_id: str, files: Mapping[str, bytes], **request: object) -> None:
    """Load and ask; only compwright's own errors may come out."""
    try:
        loaded = control(format_id, files, **request)
    except InputError:
        return
    where = np.linspace(-1e3, 1e3, 7)
    assert loaded.addresses()
    for address in loaded.addresses():
        for direction in Direction:
            found = loaded.correction(address, where, direction)
            assert found.shape == (7,)
            assert np.all(np.isfinite(found))
        assert np.all(np.diff(loaded.points(address)) > 0)
    for moving, output in pairs(loaded):
        assert np.all(np.isfinite(crossed(loaded, moving, output, [-1e3, 0, 1e3])))


def mutated(text: str) -> st.SearchStrategy[bytes]:
    """Cuts, doublings and replaced bytes of a good file."""
    content = text.encode()

    def apply(edits: list[tuple[int, int, bytes]]) -> bytes:
        result = content
        for start, length, new in edits:
            at = start % (len(result) + 1)
            result = result[:at] + new + result[at + length :]
        return result

    pieces = st.sampled_from(
        [
            b"\n",
            b",",
            b"-",
            b"9",
            b".",
            b" ",
            b"=",
            b"*",
            b"BEGIN ",
            b"[END]\n",
            b"999999999",
            b"\t",
            b"X",
            b"#",
        ]
    )
    edit = st.tuples(st.integers(0, 500), st.integers(0, 30), st.binary(max_size=3) | pieces)
    return st.lists(edit, min_size=1, max_size=4).map(apply)


MP = "MP710.0 : 0.004\nMP710.5 : 0.004\nMP720.1 : 0.01\nMP730 : %00001\n"


@given(
    table=mutated(COM) | st.binary(max_size=200),
    cma=mutated(CMA),
    mp=mutated(MP),
    sheet=mutated(SHEET) | st.binary(max_size=200),
    rule=st.sampled_from(["free", "power_of_two"]),
)
@settings(max_examples=100, deadline=None)
def test_any_bytes_itnc(table: bytes, cma: bytes, mp: bytes, sheet: bytes, rule: str) -> None:
    whole = {
        "X.COM": COM.encode(),
        "C.CMA": CMA.encode(),
        "mp.txt": MP.encode(),
        "entry_Z.csv": SHEET.replace("axis: X", "axis: Z").encode(),
    }
    ask_everything("heidenhain-itnc530", whole)
    for changed in ({"X.COM": table}, {"C.CMA": cma}, {"mp.txt": mp}, {"entry_Z.csv": sheet}):
        ask_everything("heidenhain-itnc530", {**whole, **changed}, options={"spacing_rule": rule})
        ask_everything("heidenhain-itnc530", changed, options={"spacing_rule": rule})


@given(
    table=mutated(NCK_COM),
    cma=mutated(NCK_CMA),
    sheet=mutated(SHEET.replace("MP710", "backLash").replace("MP730,,1,\n", "")),
)
@settings(max_examples=100, deadline=None)
def test_any_bytes_nck(table: bytes, cma: bytes, sheet: bytes) -> None:
    options = {"backlash_column": "second_curve"}
    ask_everything("heidenhain-nck", {"X.COM": table, "C.CMA": NCK_CMA.encode()}, options=options)
    ask_everything("heidenhain-nck", {"X.COM": table})
    ask_everything("heidenhain-nck", {"X.COM": NCK_COM.encode(), "C.CMA": cma}, options=options)
    ask_everything("heidenhain-nck", {"entry_C.csv": sheet})


class TestHowTheControlCountsItsAxes:
    """The numbers of columns, parameters and bits, as the caller tells them."""

    def test_columns_of_com_and_cma(self) -> None:
        # column 2 is A here, not Y; Y, whose usual number it is, is none of them
        files = {"X.COM": COM, "CONFIG.CMA": CMA}
        usual = itnc(files)
        assert usual.cross() == (("X", "Y"),)
        told = itnc(files, axis_number={"X": 1, "a": 2})
        assert told.cross() == (("X", "A"),)
        assert crossed(told, "X", "A", [-384]) == [-0.0003]
        with pytest.raises(UsageError):
            told.cross_correction("X", "Y", np.zeros(1), UP)

    def test_index_of_a_parameter_and_bit_of_mp730(self) -> None:
        # C is the fourth axis: index 3, bit 3; A, whose usual number that is, gets nothing
        files = {"mp": "MP710.3 : 0.004\nMP710.5 : 0.1\nMP720.3 : 0\nMP730 : %01000\n"}
        told = itnc(files, axis_number={"C": 4}, reference_return={"C": UP})
        assert values(told, "C", [0], DOWN) == [-0.004]
        assert "A" not in told.addresses()
        assert "6" in told.addresses()  # the sixth axis, which is not called C here
        assert values(itnc(files, reference_return={"A": UP}), "A", [0], DOWN) == [-0.004]

    def test_missing_mp730_is_assumed_and_said(self) -> None:
        facts_of = {one.fact: one.value for one in itnc({"X.COM": COM}).assumed}
        assert facts_of["MP730 of X"] == "1"
