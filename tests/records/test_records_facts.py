"""What the control's own files say of an axis beside its table, as typed facts: by hand numbers."""

from __future__ import annotations

import pytest
from test_formats_siemens_cec import PAIR, RAMP, cec

from compwright.formats.families.shapes import control_format
from compwright.records.axis import AxisKind
from compwright.records.facts import AxisFacts, Turn
from format_samples import LINUXCNC, files, siemens

MACHINE = "$MA_BACKLASH[0,AX1]=0\n"


def test_limits_of_an_inch_machine_are_in_mm_and_letters_name_the_joint() -> None:
    ini = (
        "[TRAJ]\nLINEAR_UNITS = inch\n[KINS]\nKINEMATICS = trivkins coordinates=xyy\n"
        "[JOINT_1]\nBACKLASH = 0.001\nMIN_LIMIT = -2\nMAX_LIMIT = 10\n"
    )
    facts = control_format(LINUXCNC, {}).read(files(m__ini=ini)).facts["1"]
    assert (facts.name, facts.letters) == ("Y", "XYY")
    assert facts.limits == pytest.approx((-50.8, 254.0), abs=1e-12)  # mm; rounding of doubles
    assert facts.stated["length_unit"] == "inch"
    assert (facts.turn, facts.encoder_system) == (None, None)


def test_one_limit_alone_is_none() -> None:
    lines = MACHINE + "$MA_POS_LIMIT_MINUS[AX1]=-5\n"
    assert siemens(lines).facts["AX1"].limits is None
    both = siemens(lines + "$MA_POS_LIMIT_PLUS[AX1]=700\n").facts["AX1"]
    assert both.limits == (-5.0, 700.0)
    # 100 000 mm is the control's own word for no limit
    far = siemens(lines + "$MA_POS_LIMIT_PLUS[AX1]=100000\n").facts["AX1"]
    assert far.limits is None


@pytest.mark.parametrize(
    ("said", "turn"),
    [
        ("", Turn(0.0, 360.0, stated=False)),
        ("$MA_MODULO_RANGE_START[AX4]=-180\n", Turn(-180.0, 360.0, stated=True)),
        ("$MA_MODULO_RANGE[AX4]=180\n", Turn(0.0, 180.0, stated=False)),
    ],
)
def test_the_turn_of_an_endless_axis(said: str, turn: Turn) -> None:
    lines = "$MA_BACKLASH[0,AX4]=0\n$MA_IS_ROT_AX[AX4]=1\n$MA_ROT_IS_MODULO[AX4]=1\n"
    facts = siemens(lines + said).facts["AX4"]
    assert facts.turn == turn
    assert facts.limits == (turn.start, turn.start + turn.length)
    assert facts.kind is AxisKind.ROTARY


def test_tables_between_axes_by_axis_and_by_control() -> None:
    lines = "$MN_MM_CEC_MAX_POINTS[4]=11\n$MA_CEC_MAX_SUM[AX1]=0.5\n"
    state = siemens(PAIR + RAMP + MACHINE + lines)
    # index 4 acts in +, index 7 in -
    assert state.facts["AX1"].pairs.own == (4, 7)
    assert state.facts["AX1"].pairs.max_sum == 0.5
    assert state.tables.used == {0: ("AX1", "AX2"), 4: ("AX1", "AX1"), 7: ("AX1", "AX1")}
    assert state.tables.reserved == {4: 11}
    turned = cec(9, [0.0, 0.002], (0, 800, 800), direction=-1) + cec(
        3, [0.0, 0.001], (0, 800, 800), direction=1
    )
    assert siemens(turned + MACHINE).facts["AX1"].pairs.own == (3, 9)


def test_an_axis_that_no_file_names_has_no_facts() -> None:
    assert siemens(MACHINE).facts_of("AX9") == AxisFacts()
