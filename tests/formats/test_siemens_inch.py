"""SINUMERIK whose basic system is the inch (MD10240 = 0): the same machine as one in mm, in other
numbers.

The texts are small ones in the shape of a real archive, turned into inches by a helper that knows
nothing of the package; what they do is judged by a control made from the manuals' facts alone.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.formats.card import card_steps
from compwright.formats.families.card_texts import CardRequest
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.axis_pairs import write_cross
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import ControlFile, ControlState, CrossCompensation
from format_samples import SIEMENS, axis_of, codes, files, table
from sinumerik_archive import cec_lines, eec_lines, in_inch
from virtual_sinumerik import VirtualSinumerik

pytestmark = pytest.mark.short_estimate

NAMES = '$MN_AXCONF_MACHAX_NAME_TAB[0]="X1"\n$MN_AXCONF_MACHAX_NAME_TAB[3]="A1"\n'
MD = (
    "METRIC\nCHANDATA(1)\n" + NAMES + "$MN_SCALING_SYSTEM_IS_METRIC=1\n"
    "$MN_SCALING_VALUE_INCH=25.4\n$MA_IS_ROT_AX[AX1]=0\n$MA_IS_ROT_AX[AX4]=1\n"
    "$MA_ENC_COMP_ENABLE[0,AX1]=1\n$MA_ENC_COMP_ENABLE[0,AX4]=1\n"
    "$MA_BACKLASH[0,AX1]=0.00762\n$MA_BACKLASH[0,AX4]=0.002\n"
    "$MA_POS_LIMIT_MINUS[AX1]=-25.4\n$MA_POS_LIMIT_PLUS[AX1]=787.4\nM17\n"
)
EEC = (
    "METRIC\nCHANDATA(1)\n"
    + eec_lines("AX1", 0, 0.0, 127.0, [0.0, 0.00254, -0.00508, 0.0127, 0.0], modulo=False)
    + eec_lines("AX4", 0, -90.0, 45.0, [0.0, 0.001, -0.002, 0.003, 0.0], modulo=False)
    + "M17\n"
)
TO_INCH = ("IS_METRIC=1", "IS_METRIC=0")
X = replace(axis_of("AX1"), travel=(0.0, 508.0))
A = replace(axis_of("AX4", kind=AxisKind.ROTARY), name="A", travel=(-90.0, 90.0))
#: The printed digits of `in_inch` (1e-10 inch), mm.
PRINTED = 3e-9


def inch(text: str) -> str:
    return in_inch(text, {"AX4"}).replace(*TO_INCH)


def given(md: str, eec: str) -> list[ControlFile]:
    return files(INITIAL__INI=md, AX_EEC__INI=eec)


def read(md: str, eec: str, *axes: Axis, **options: object) -> ControlState:
    return control_format(SIEMENS, options).read(given(md, eec), axes or (X, A))


@pytest.mark.parametrize(
    ("md", "eec"),
    [
        (inch(MD), inch(EEC)),
        (inch(MD).replace("INCH\n", "", 1), inch(EEC).replace("INCH\n", "")),
        (inch(MD).replace("$MN_SCALING_SYSTEM_IS_METRIC=0\n", ""), inch(EEC)),
        (inch(MD), inch(EEC).replace("INCH\n", "")),
    ],
    ids=["both say it", "MD10240", "the line", "the line in one file"],
)
def test_the_same_machine_in_other_numbers(md: str, eec: str) -> None:
    metric, turned = read(MD, EEC), read(md, eec)
    for name in ("AX1", "AX4"):
        one, other = metric.axes[name], turned.axes[name]
        assert other.positions == pytest.approx(one.positions, abs=PRINTED)
        assert other.positive == pytest.approx(one.positive, abs=PRINTED)
        assert other.backlash == pytest.approx(one.backlash, abs=PRINTED)
    assert turned.axes["AX4"].positions.tolist() == [-90, -45, 0, 45, 90]
    assert turned.facts["AX1"].limits == pytest.approx((-25.4, 787.4), abs=PRINTED)
    with pytest.raises(InputError, match="POS_LIMIT_MINUS"):
        read(md, eec, replace(X, travel=(1000.0, 1500.0)))


@pytest.mark.parametrize("word", ["metric", "Metric"])
def test_one_unit_in_upper_and_lower_case_is_no_contradiction(word: str) -> None:
    lower = EEC.replace("METRIC", word)
    assert np.array_equal(read(MD, lower).axes["AX1"].positive, read(MD, EEC).axes["AX1"].positive)
    with pytest.raises(InputError, match="this line says inch"):
        read(MD.replace("METRIC", word), inch(EEC))


def test_files_that_contradict_themselves_are_refused_for_every_axis() -> None:
    for md in (MD.replace(*TO_INCH), inch(MD).replace("INCH", "METRIC")):
        for axis in (X, A):
            with pytest.raises(InputError, match=r"this line says inch.*MD10240, METRIC, INCH"):
                read(md, inch(EEC), axis)
    with pytest.raises(InputError, match="this line says inch"):
        read(MD, inch(EEC))


def test_an_inch_of_another_length_is_refused() -> None:
    with pytest.raises(InputError, match=r"MD10250.*25\.4"):
        read(inch(MD).replace("_INCH=25.4", "_INCH=25"), inch(EEC))
    assert read(MD.replace("_INCH=25.4", "_INCH=25"), EEC).axes  # a control in mm has no use for it


def loaded(md: str, written: list[ControlFile], before: list[ControlFile]) -> VirtualSinumerik:
    control = VirtualSinumerik()
    new = {file.name: file for file in written}
    control.load(md, protected=False)
    for file in [*(one for one in before if one.name not in new), *written]:
        control.load(file.content.decode("latin-1"), protected=False)
    return control


@pytest.mark.parametrize("patched", [True, False])
def test_what_is_written_does_what_was_asked(patched: bool) -> None:
    """Nodes and values in inch with as many digits as the control keeps, exactly; the control made
    from the manuals puts out what was asked for.
    """
    md = inch(MD)
    before = given(md, inch(EEC)) if patched else []
    options = {} if patched else {"units": "inch"}
    state = control_format(SIEMENS, options).read(before, [X, A]) if patched else None
    control = control_format(SIEMENS, options, state)
    quantum = control.capacity(X).quantum
    assert quantum == pytest.approx(25.4e-6, rel=1e-12)
    assert control.capacity(X).position_quantum == pytest.approx(25.4e-6, rel=1e-12)
    assert control.capacity(A).quantum == pytest.approx(1e-6, rel=1e-12)
    spacing, values = 5.0 * 25.4, np.array([0.0, 117.0, -203.0, 11.0, 0.0]) * quantum
    wanted = replace(
        table("AX1", list(spacing * np.arange(5)), list(values), backlash=150 * quantum),
    )
    written = list(control.write([wanted], [X], before))
    text = "".join(file.content.decode() for file in written).replace("0.000150", "0.00015")
    for line in (
        "$AA_ENC_COMP[0,1,AX1]=-0.000117",
        "$AA_ENC_COMP_STEP[0,AX1]=5",
        "$AA_ENC_COMP_MAX[0,AX1]=20",
        "$MA_BACKLASH[0,AX1]=0.00015",
    ):
        assert line in text, line
    if patched:
        old = "".join(file.content.decode() for file in before)
        changed = set(text.splitlines()) - set(old.splitlines())
        assert not [line for line in changed if "AX4" in line]
    physics = loaded(md, written, before)
    where = np.linspace(-20.0, 600.0, 63)
    for direction in Direction:
        sign = 1 if direction is Direction.POSITIVE else -1
        assert physics.correction("AX1", where, sign) == pytest.approx(
            wanted.at(where, direction), abs=1e-9
        )


def test_a_grid_that_no_inch_can_say_is_refused() -> None:
    control = control_format(SIEMENS, {"units": "inch"})
    with pytest.raises(CapacityError, match="not a multiple"):
        control.write([table("AX1", [0.0, 50.0, 100.0], [0.0, 0.0, 0.0])], [X])


def test_an_option_against_the_files_is_refused() -> None:
    state = read(inch(MD), inch(EEC))
    with pytest.raises(UsageError, match="contradicts the control's own files"):
        control_format(SIEMENS, {"units": "mm"}).in_state(state, strict=True)
    bare = inch(EEC).replace("INCH\n", "")
    told = control_format(SIEMENS, {"units": "inch"}).read(files(AX_EEC__INI=bare), [X])
    assert told.axes["AX1"].positions[-1] == pytest.approx(508.0, abs=PRINTED)


# Tables between axes: MD32711 of the output axis says their unit, whatever the basic system is
# --------------------------------------------------------------------------------------------------

CEC = {"cec": "available", "cec_tables": [20, 21], "cec_sign": "correction"}
ON = "$SN_CEC_TABLE_ENABLE[3]=1\n$MA_CEC_ENABLE[AX1]=1\n"


def with_cec(pair: tuple[str, str]) -> str:
    return inch(MD).replace("M17", cec_lines(3, *pair, 0, 10, [0, 0.001, 0.0]) + ON + "M17")


def test_an_own_table_in_unknown_units_is_refused_by_name() -> None:
    with pytest.raises(InputError, match=r"AX1.*MD32711"):
        read(with_cec(("AX1", "AX1")), inch(EEC), cec_sign="error", cec_tables=[3])


def test_tables_of_others_in_unknown_units_are_kept_and_not_shown() -> None:
    state = read(with_cec(("AX2", "AX1")), inch(EEC), cec_sign="error")
    assert "CW-S050" in codes(state)
    assert not state.cross
    assert "CEC table 3" in state.facts["AX1"].pairs.uncounted


METRIC_CEC = "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=1\n$MA_CEC_MAX_SUM[AX1]=0.01\n"


def test_md32711_says_their_unit_whatever_the_basic_system_is() -> None:
    """MD32711 = 1: the table is in mm, and so is a new one; the limit of the sum (MD32720) is
    machine data, in inch.
    """
    md = with_cec(("AX1", "AX1")).replace("M17", METRIC_CEC + "M17")
    state = read(md, inch(EEC), cec_sign="correction")
    assert state.axes["AX1"].others[0].positive.tolist() == [0, 0.001, 0]
    assert state.facts["AX1"].pairs.max_sum == pytest.approx(0.254, abs=1e-12)
    control = control_format(SIEMENS, {**CEC, "cec_tables": [3, 20, 21]}, state)
    assert control.capacity(X).curves == 2
    assert control.capacity(X).quantum == pytest.approx(1e-6, rel=1e-12)


def test_too_few_free_tables_suggest_no_index() -> None:
    """A suggested index may be one of the machine's builder, here 0."""
    md = MD.replace("M17", cec_lines(0, "AX2", "AX3", 0, 10, [0, 0.001, 0.0]) + "M17")
    state = read(md, EEC, cec_sign="error")
    with pytest.raises(CapacityError, match="CEC tables that are free") as refused:
        control_format(SIEMENS, {**CEC, "cec_tables": [0, 1]}, state).capacity(X)
    (fault,) = refused.value.faults
    assert "as `cec_tables` in the options" in fault.hint
    assert "[" not in fault.hint


def test_the_card_of_a_pair_in_mm_on_a_control_in_inch_says_mm() -> None:
    """What is typed into `$AN_CEC` counts in mm where MD32711 is 1: 0.1 inch would be 2.54 mm."""
    values = [0, 0.001, 0.003]
    pair = [
        cec_lines(t, "AX1", "AX1", 0, 254, values, direction=way) for t, way in ((3, 1), (4, -1))
    ]
    on = ON + ON.replace("[3]", "[4]") + METRIC_CEC
    md = inch(MD).replace("M17", "".join(pair) + on + "M17")
    md = md.replace("ENC_COMP_ENABLE[0,AX1]=1", "ENC_COMP_ENABLE[0,AX1]=0")
    options = {**CEC, "cec_tables": [3, 4]}
    before = given(md, inch(EEC))
    state = control_format(SIEMENS, options).read(before, [X])
    control = control_format(SIEMENS, options, state)
    two = replace(
        table("AX1", [0, 254, 508], [0, 0.002, 0.004]), negative=np.array([0.0, 0.001, 0.002])
    )
    written = control.write([two], [X], before)
    text = "".join(file.content.decode() for file in written)
    assert "$AN_CEC_MAX[3]=508" in text
    facts = control.read(written, [X]).facts["AX1"]
    asked = CardRequest(axis=X, table=two, facts=facts, check_at=two.positions, files=written)
    steps = {step.title: step.text for step in card_steps(SIEMENS, X, control.card(asked).values)}
    assert "write 0.1 mm into every point of tables 3 and 4" in steps["Check the sign"]
    assert "inch" not in steps["Check the sign"]
    assert "3 points from 0 to 508 mm every 254 mm" in steps["Load the table"]
    assert (
        "MD32450 $MA_BACKLASH[0,AX1] = 0 inch" in steps["Set the backlash and switch the table on"]
    )


@pytest.mark.parametrize("basic", ["inch", "metric"])
def test_a_table_in_inch_is_read_and_none_is_written(basic: str) -> None:
    """MD32711 = 0: 0.001 inch over 10 inch, whatever the basic system is."""
    data = "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0\n" + ON
    table = cec_lines(3, "AX1", "AX1", 0, 10, [0, 0.001, 0.0])
    words = {"inch": (inch(MD), inch(EEC)), "metric": (MD, EEC)}
    md, eec = words[basic]
    md = md.replace("M17", table + data + "M17")
    for options in ({}, {"cec_tables": [3]}):
        state = read(md, eec, cec_sign="correction", **options)
        (own,) = state.axes["AX1"].others
        assert own.positive.tolist() == pytest.approx([0, 0.0254, 0], abs=1e-12)
        assert own.positions[-1] - own.positions[0] == pytest.approx(508.0)
    with pytest.raises(CapacityError, match="MD32711"):
        control_format(SIEMENS, {**CEC, "cec_tables": [3, 20, 21]}, state).capacity(X)


def test_tables_of_rotary_axes_know_no_inch() -> None:
    both = with_cec(("AX4", "AX5")).replace(
        "M17", "$MA_IS_ROT_AX[AX5]=1\n$MA_CEC_SCALING_SYSTEM_METRIC[AX5]=0\nM17"
    )
    state = read(both, inch(EEC), cec_sign="correction")
    assert state.cross[0].positive.tolist() == [0, 0.001, 0]
    assert state.cross[0].positions.tolist() == [0, 10, 20]


def test_rotary_axes_know_no_inch() -> None:
    both = with_cec(("AX4", "AX5")).replace("M17", "$MA_IS_ROT_AX[AX5]=1\nM17")
    state = read(both, inch(EEC), cec_sign="correction")
    assert state.cross[0].positive.tolist() == [0, 0.001, 0]


def bound(**options: object) -> Family:
    return control_format(SIEMENS, {**CEC, **options})


def test_no_pair_and_no_table_between_axes_is_written_in_inch() -> None:
    with pytest.raises(CapacityError, match="MD32711"):
        bound(units="inch").capacity(X)
    assert bound(units="inch").capacity(A).curves == 2
    assert bound().capacity(X).curves == 2
    cross = CrossCompensation(
        input="AX1",
        output="AX2",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=np.array([0.0, 254.0]),
        positive=np.array([0.0, 0.001]),
        negative=np.array([0.0, 0.001]),
    )
    assert write_cross(bound(), [cross])
    with pytest.raises(CapacityError, match="MD32711"):
        write_cross(bound(units="inch"), [cross])


def test_a_grid_that_stays_keeps_its_text_however_many_places_it_has() -> None:
    """A grid in inch that is whole in mm, and one in mm with more places than a new one gets: values
    change, MIN, MAX and STEP do not.
    """
    for md, eec in (
        (inch(MD), inch(EEC.replace("127", "50").replace("508", "200"))),
        (MD, EEC.replace("=127", "=19.74358974").replace("=508", "=78.97435896")),
    ):
        before = given(md, eec)
        state = control_format(SIEMENS, {}).read(before, [X])
        old = state.axes["AX1"]
        control = control_format(SIEMENS, {}, state)
        steps = np.array([0.0, 3.0, -2.0, 5.0, 0.0])
        new = replace(old, positive=steps * control.capacity(X).quantum)
        new = replace(new, negative=new.positive)
        written = {file.name: file.content.decode() for file in control.write([new], [X], before)}
        text = written["AX_EEC.INI"]
        for key in ("STEP", "MIN", "MAX"):
            (line,) = (
                line for line in eec.splitlines() if line.startswith(f"$AA_ENC_COMP_{key}[0,AX1]")
            )
            assert line in text
        physics = loaded(written.get("INITIAL.INI", md), list(files(AX_EEC__INI=text)), before)
        where = np.linspace(-20.0, 300.0, 33)
        assert physics.correction("AX1", where, 1) == pytest.approx(
            new.at(where, Direction.POSITIVE), abs=1e-9
        )
