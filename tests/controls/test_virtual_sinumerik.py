"""The virtual SINUMERIK of the tests against the manuals' own statements: a judge that is wrong
judges nothing.
"""

from __future__ import annotations

import numpy as np
import pytest

from virtual_sinumerik import VirtualSinumerik, assignments

TABLE = """%_N_AX_EEC_INI
CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=0.003
$AA_ENC_COMP[0,1,AX1]=0.001
$AA_ENC_COMP[0,2,AX1]=0.0
$AA_ENC_COMP[0,3,AX1] = -0.002 ; a remark $AA_ENC_COMP[0,3,AX1]=9
$AA_ENC_COMP[0,4,AX1]=-0.0045
$AA_ENC_COMP_STEP[0,AX1]=50.0
$AA_ENC_COMP_MIN[0,AX1]=-100.0
$AA_ENC_COMP_MAX[0,AX1]=100.0
$AA_ENC_COMP_IS_MODULO[0,AX1]=0
M17
$AA_ENC_COMP[0,0,AX1]=99
"""
PLACES = np.array([-500.0, -100.0, -75.0, 100.0, 900.0])


def control(*texts: str, **words: object) -> VirtualSinumerik:
    virtual = VirtualSinumerik(**words)  # type: ignore[arg-type]  # fields by name
    for text in texts:
        virtual.load(text)
    return virtual


def test_a_positive_table_value_moves_the_axis_in_the_negative_direction() -> None:
    virtual = control(TABLE, "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=TRUE")
    np.testing.assert_allclose(
        virtual.correction("AX1", PLACES, 1), [-0.003, -0.003, -0.002, 0.0045, 0.0045], atol=1e-12
    )


def test_a_table_that_is_switched_off_does_nothing() -> None:
    assert not control(TABLE, "$MA_ENC_COMP_ENABLE[0,AX1]=0").correction("AX1", PLACES, 1).any()


def test_a_table_is_write_protected_while_it_acts() -> None:
    virtual = control(TABLE, "$MA_ENC_COMP_ENABLE[0,AX1]=1", TABLE.replace("0.003", "0.5"))
    assert [(refused.new, refused.mattered) for refused in virtual.refused if refused.mattered] == [
        ("0.5", True)
    ]
    assert virtual.correction("AX1", PLACES, 1)[0] == pytest.approx(-0.003, abs=1e-12)


def test_points_beyond_the_reserved_ones_are_not_taken() -> None:
    virtual = control("$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=4", TABLE)
    assert [refused.new for refused in virtual.refused] == ["-0.0045"]


@pytest.mark.parametrize("text", [TABLE.replace("CHANDATA", "INCH\nCHANDATA"), TABLE])
def test_an_inch_control_counts_in_inches(text: str) -> None:
    virtual = control("$MN_SCALING_SYSTEM_IS_METRIC=0", text, "$MA_ENC_COMP_ENABLE[0,AX1]=1")
    assert virtual.correction("AX1", np.array([-100 * 25.4]), 1)[0] == pytest.approx(
        -0.003 * 25.4, abs=1e-12
    )


def test_degrees_stay_degrees_on_an_inch_control() -> None:
    virtual = control(
        "$MN_SCALING_SYSTEM_IS_METRIC=0\n$MA_IS_ROT_AX[AX1]=1",
        TABLE,
        "$MA_ENC_COMP_ENABLE[0,AX1]=1",
    )
    assert virtual.correction("AX1", np.array([-100.0]), 1)[0] == pytest.approx(-0.003, abs=1e-12)


def test_a_modulo_table_repeats() -> None:
    text = TABLE.replace("-0.0045", "0.003").replace("MODULO[0,AX1]=0", "MODULO[0,AX1]=1")
    virtual = control(text, "$MA_ENC_COMP_ENABLE[0,AX1]=1")
    np.testing.assert_allclose(
        virtual.correction("AX1", np.array([-75.0, 125.0, 325.0]), 1), -0.002, atol=1e-12
    )


def test_the_measuring_system_in_use_is_the_only_one_that_acts() -> None:
    second = TABLE.replace("[0,", "[1,").replace(
        "M17", "$MA_BACKLASH[1,AX1]=0.01\n$MA_BACKLASH[0,AX1]=0.5\nM17"
    )
    virtual = control(second, "$MA_NUM_ENCS[AX1]=2\n$MA_ENC_COMP_ENABLE[1,AX1]=1")
    assert virtual.correction("AX1", np.array([-100.0]), -1)[0] == pytest.approx(
        -0.003 - 0.01, abs=1e-12
    )
    assert (
        not control(second, "$MA_NUM_ENCS[AX1]=1\n$MA_ENC_COMP_ENABLE[1,AX1]=1")
        .correction("AX1", PLACES, 1)
        .any()
    )


@pytest.mark.parametrize("home", [1, -1])
def test_backlash_acts_against_the_direction_of_referencing(home: int) -> None:
    virtual = control(
        "$MA_BACKLASH[0,AX1]=0.004\n$MA_BACKLASH_FACTOR[0,AX1]=2", reference_return={"AX1": home}
    )
    found = [virtual.correction("AX1", np.zeros(1), direction)[0] for direction in (home, -home)]
    np.testing.assert_allclose(found, [0, -home * 0.008], atol=1e-12)


def test_x1_and_ax1_are_one_axis() -> None:
    virtual = control(
        '$MN_AXCONF_MACHAX_NAME_TAB[0]="X1"',
        TABLE.replace("AX1", "X1"),
        "$MA_ENC_COMP_ENABLE[0,AX1]=1",
    )
    assert virtual.correction("AX1", PLACES, 1)[0] == pytest.approx(-0.003, abs=1e-12)


CROSS = """$AN_CEC[3,0]=0\n$AN_CEC[3,1]=0.01\n$AN_CEC_INPUT_AXIS[3]=(AX2)\n$AN_CEC_OUTPUT_AXIS[3] = (AX1)\n$AN_CEC_STEP[3]=100
$AN_CEC_MIN[3]=0\n$AN_CEC_MAX[3]=100\n$AN_CEC_DIRECTION[3]=0\n$AN_CEC_MULT_BY_TABLE[3]=0\n$AN_CEC_IS_MODULO[3]=0\n"""
ON = "$MA_CEC_ENABLE[AX1]=1\n$SN_CEC_TABLE_ENABLE[3]=1"


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_cross_table_acts_with_the_sign_of_its_world(sign: float) -> None:
    virtual = control(CROSS, ON, cec_sign=sign, positions={"AX2": 50.0})
    np.testing.assert_allclose(virtual.correction("AX1", PLACES, 1), sign * 0.005, atol=1e-12)
    assert not virtual.correction("AX2", PLACES, 1).any()


@pytest.mark.parametrize("off", ["$MA_CEC_ENABLE[AX1]=0", "$SN_CEC_TABLE_ENABLE[3]=FALSE"])
def test_either_switch_puts_a_cross_table_to_sleep(off: str) -> None:
    assert not control(CROSS, ON, off, positions={"AX2": 50.0}).correction("AX1", PLACES, 1).any()


def test_a_pair_acts_by_direction_with_weight_and_limit() -> None:
    own = CROSS.replace("(AX2)", "(AX1)").replace("DIRECTION[3]=0", "DIRECTION[3]=-1")
    virtual = control(own, "$SN_CEC_TABLE_WEIGHT[3]=0.5\n$MA_CEC_MAX_SUM[AX1]=0.004", ON)
    assert not virtual.correction("AX1", PLACES, 1).any()
    np.testing.assert_allclose(
        virtual.correction("AX1", np.array([0.0, 50.0, 100.0]), -1), [0, 0.0025, 0.004], atol=1e-12
    )


@pytest.mark.parametrize("own", [0.0, 1.0])
def test_a_product_of_two_tables_goes_to_the_first_ones_output(own: float) -> None:
    """Whether the first table adds its own value too is on no page: both worlds can be made."""
    other = CROSS.replace("[3", "[4").replace("(AX2)", "(AX1)").replace("0.01", "2")
    multiplied = CROSS.replace("TABLE[3]=0", "TABLE[3]=5")
    virtual = control(multiplied, other, ON, positions={"AX2": 50.0}, own_beside_product=bool(own))
    np.testing.assert_allclose(
        virtual.correction("AX1", np.array([25.0, 100.0]), 1),
        [0.005 * (0.5 + own), 0.005 * (2 + own)],
        atol=1e-12,
    )


def test_the_machine_data_of_the_output_axis_say_the_unit_of_a_cross_table() -> None:
    """MD32711, not MD10240."""
    lines = (CROSS, ON, "$MN_SCALING_SYSTEM_IS_METRIC=0")
    virtual = control(*lines, positions={"AX2": 50.0})
    np.testing.assert_allclose(virtual.correction("AX1", PLACES, 1), 0.005, atol=1e-12)
    virtual.load("$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0")
    np.testing.assert_allclose(
        virtual.correction("AX1", PLACES, 1), 0.01 * 25.4 * 50 / 2540, atol=1e-12
    )


def test_two_setting_data_are_added_to_the_first_two_points() -> None:
    """SD41320 and SD41321."""
    virtual = control(CROSS, ON, "$SN_CEC_0[3]=0.002\n$SN_CEC_1[3]=-0.004")
    for place, expected in ((0.0, 0.002), (100.0, 0.006)):
        virtual.positions["AX2"] = place
        np.testing.assert_allclose(virtual.correction("AX1", PLACES, 1), expected, atol=1e-12)


@pytest.mark.parametrize("beyond", [False, True])
def test_a_step_that_does_not_divide_the_range_leaves_the_last_point_open(beyond: bool) -> None:
    """-100 to 70 by 50: whether the point at 100 counts up to 70 is on no page."""
    text = TABLE.replace("MAX[0,AX1]=100.0", "MAX[0,AX1]=70.0")
    virtual = control(text, "$MA_ENC_COMP_ENABLE[0,AX1]=1", point_beyond=beyond)
    found = virtual.correction("AX1", np.array([50.0, 70.0, 900.0]), 1)
    last = 0.002 + 0.0025 * 20 / 50 if beyond else 0.002
    np.testing.assert_allclose(found, [0.002, last, last], atol=1e-12)


def test_conditions_are_no_assignments() -> None:
    text = (
        'IF $MA_NUM_ENCS[AX1]==1 GOTOF ENDE\nN10 IF ($A_X[1]=="B")'
        " $MA_BACKLASH[0,AX1]=1\n$MA_BACKLASH [0, AX1] = +0.5"
    )
    assert [(register, value.text) for register, value in assignments(text)] == [
        (("MA_BACKLASH", ("0", "AX1")), "+0.5")
    ]
