"""Tables whose STEP does not divide their range: read where every reading of the control agrees.

Of (MAX - MIN) / STEP = 8.5 no manual says whether the ninth spacing counts; where the points on
both sides of MAX hold the same value, that value acts from the first of them on either way.
"""

from __future__ import annotations

import numpy as np
import pytest

from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile, ControlState
from format_samples import SIEMENS, axis_of, table

#: 850 mm in steps of 100: points at -850 ... -50, and 50 beyond MAX = 0.
VALUES = [0.0, 0.001, 0.002, 0.004, 0.003, 0.002, 0.001, 0.001, 0.002]


def read(values: list[float], low: str, high: str, step: str, modulo: int = 0) -> ControlState:
    rows = "".join(f"$AA_ENC_COMP[0,{n},AX1]={value}\n" for n, value in enumerate(values))
    text = (
        f"CHANDATA(1)\n{rows}$AA_ENC_COMP_STEP[0,AX1]={step}\n$AA_ENC_COMP_MIN[0,AX1]={low}\n"
        f"$AA_ENC_COMP_MAX[0,AX1]={high}\n$AA_ENC_COMP_IS_MODULO[0,AX1]={modulo}\n"
        "$MA_ENC_COMP_ENABLE[0,AX1]=1\nM17\n"
    )
    return control_format(SIEMENS, {}).read([ControlFile("A.INI", text.encode())])


def test_equal_values_on_both_sides_of_the_end_are_certain() -> None:
    """Errors: -50 and beyond hold 2 µm whichever way the control counts, so the axis is moved by
    -2 µm there.
    """
    state = read([*VALUES, 0.002, 0.0, 0.0], "-850", "0", "100")
    axis = state.axes["AX1"]
    where = np.array([-900.0, -850, -800, -550, -50, -20, 0, 50, 200])
    assert axis.at(where, Direction.POSITIVE) == pytest.approx(
        [0, 0, -0.0005, -0.004, -0.002, -0.002, -0.002, -0.002, -0.002], abs=1e-12
    )
    assert any("8.5" in one.evidence for one in state.assumed)


@pytest.mark.parametrize("beyond", [[0.0], [-0.002], []])
def test_other_values_beyond_the_end_are_refused(beyond: list[float]) -> None:
    with pytest.raises(InputError, match=r"spacing does not divide.*\(0 - -850\) / 100 = 8.5"):
        read([*VALUES, *beyond], "-850", "0", "100")


def test_a_value_behind_both_is_ignored_and_named() -> None:
    """Values greater than k are ignored (FB2 09/2009 p362), whichever way the control counts k."""
    state = read([*VALUES, 0.002, 0.003], "-850", "0", "100")
    without = read([*VALUES, 0.002], "-850", "0", "100")
    where = np.linspace(-900, 300, 97)
    first, second = (one.axes["AX1"].at(where, Direction.POSITIVE) for one in (state, without))
    np.testing.assert_array_equal(first, second)
    assert [one.severity for one in state.findings if one.code == "CW-S004"] == ["warning"]


def test_a_table_of_zeros_holds_nothing_on_any_grid() -> None:
    axis = read([0.0] * 9, "-850", "0", "100").axes["AX1"]
    assert not axis.at(np.linspace(-900, 100, 50), Direction.NEGATIVE).any()


def test_a_repeating_table_must_close() -> None:
    with pytest.raises(InputError, match="does not divide"):
        read([0.0, 0.001, 0.002, 0.002], "0", "250", "100", modulo=1)


def test_a_step_that_was_rounded_when_it_was_written() -> None:
    """A real listing: 770 mm in 39 steps, written as 19.7436."""
    values = [round(0.0001 * n, 4) for n in range(40)]
    state = read(values, "-215", "555", "19.7436")
    axis = state.axes["AX1"]
    assert axis.positions.size == 40
    assert axis.positions[-1] == pytest.approx(555.0, abs=5e-4)
    (told,) = [one for one in state.assumed if "spacings" in one.fact]
    assert told.value == "39"


@pytest.mark.parametrize("ratio", ["14.7", "14.5", "14.3"])
def test_a_new_table_on_such_nodes_ends_at_the_last_of_them(ratio: str) -> None:
    """Whoever counts the point beyond MAX, or does not, reads the same: 15 points, MAX on the last;
    what stood beyond becomes 0.
    """
    rows = "".join(f"$AA_ENC_COMP[0,{n},AX1]=0\n" for n in range(16))
    own = ControlFile(
        "A.INI",
        (
            f"CHANDATA(1)\n{rows}$AA_ENC_COMP_STEP[0,AX1]=50\n$AA_ENC_COMP_MIN[0,AX1]=0\n"
            f"$AA_ENC_COMP_MAX[0,AX1]={50 * float(ratio):g}\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n"
            "$MA_ENC_COMP_ENABLE[0,AX1]=1\nM17\n"
        ).encode(),
    )
    axis = axis_of("AX1")
    state = control_format(SIEMENS, {}).read([own], [axis])
    nodes = state.axes["AX1"].positions
    assert nodes[-1] == 700
    values = np.linspace(0.0, -0.014, 15)
    new = control_format(SIEMENS, {}, state).write(
        [table("AX1", list(nodes), list(values))], [axis], [own]
    )
    text = "".join(file.content.decode() for file in new)
    assert float(text.split("$AA_ENC_COMP_MAX[0,AX1]=")[1].split()[0]) == 700
    read_back = control_format(SIEMENS, {}).read(new, [axis]).axes["AX1"]
    np.testing.assert_allclose(read_back.positive, values, atol=5e-7)
