"""CEC tables of the axis over itself, and products on it, that nobody gave to be written: they stay,
and what is written acts beside them.

Whatever such a table does, and whichever way its values count, it does the same during the test and
afterwards. So the change that is written is the change of the whole: shown on a control made from the
manuals' facts alone.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import backup_variations_sinumerik as variations
from backup_cases_sinumerik import Case
from backup_variations_sinumerik import named
from compwright.cli import run as compwright
from compwright.formats.families.activity import Activity
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.planning.wanted_correction import without_kept_tables
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile, ControlState
from compwright.records.estimate import WantedCorrection
from format_samples import SIEMENS, axis_of, codes, files, table
from sinumerik_archive import cec_lines, eec_lines, needs_archive
from sinumerik_judge import try_case
from virtual_sinumerik import VirtualSinumerik

pytestmark = pytest.mark.short_estimate

AXIS = replace(axis_of("AX1"), travel=(0.0, 800.0))
EEC = eec_lines("AX1", 0, 0.0, 200.0, [0.0, 0.004, -0.002, 0.003, 0.0], modulo=False)
MD = (
    "$MA_ENC_COMP_ENABLE[0,AX1]=1\n$MA_BACKLASH[0,AX1]=0.002\n$MA_CEC_ENABLE[AX1]=1\n"
    "$SN_CEC_TABLE_ENABLE[3]=1\n$SN_CEC_TABLE_ENABLE[4]=0\n$MA_CEC_MAX_SUM[AX1]=1\n"
)
OWN = cec_lines(3, "AX1", "AX1", 0, 400, [0.01, -0.02, 0.03])
NO_MULTIPLE = OWN.replace("_STEP[3]=400", "_STEP[3]=300")
FACTOR = cec_lines(4, "AX1", "AX1", 0, 400, [0.5, 1.0, -0.7])
PRODUCT = OWN.replace("MULT_BY_TABLE[3]=0", "MULT_BY_TABLE[3]=5") + FACTOR
FOREIGN = PRODUCT.replace("INPUT_AXIS[3]=(AX1)", "INPUT_AXIS[3]=(AX2)")
STAYING = {
    "a curve": OWN,
    "one direction": OWN.replace("DIRECTION[3]=0", "DIRECTION[3]=-1"),
    "no multiple of its step": NO_MULTIPLE,
    "a product": PRODUCT,
    "a product of another axis": FOREIGN,
    "a weight": OWN + "$SN_CEC_TABLE_WEIGHT[3]=0.4\n",
}
NEW = table("AX1", [0.0, 400.0, 800.0], [0.0, -0.003, 0.001], backlash=0.004)


def given(cec: str) -> list[ControlFile]:
    return files(A__INI=f"METRIC\nCHANDATA(1)\n{EEC}{cec}{MD}M17\n")


def read(text: str, **options: object) -> ControlState:
    return control_format(SIEMENS, options).read(given(text), [AXIS])


def control_with(content: list[ControlFile], sign: float) -> VirtualSinumerik:
    control = VirtualSinumerik(cec_sign=sign, positions={"AX2": 137.0})
    for file in content:
        control.load(file.content.decode("latin-1"), protected=False)
    return control


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("name", STAYING)
@pytest.mark.parametrize("told", [True, False], ids=["sign told", "sign is not given"])
def test_the_change_that_is_written_is_the_change_of_the_whole(
    name: str, sign: float, told: bool
) -> None:
    cec = STAYING[name]
    options: dict[str, object] = {"cec_sign": "correction" if sign > 0 else "error"} if told else {}
    state = read(cec, **options)
    old = state.axes["AX1"]
    counted = told and name in ("a curve", "one direction", "a weight")
    assert bool(state.stays) is counted
    assert ("CEC table 3" in state.facts["AX1"].other_functions) is not counted
    before = given(cec)
    written = list(control_format(SIEMENS, options, state).write([NEW], [AXIS], before))
    assert [line for line in cec.splitlines() if line.encode() not in written[0].content] == []
    was, now = control_with(before, sign), control_with(written, sign)
    where = np.linspace(-50.0, 900.0, 96)
    new = replace(NEW, others=state.stays.get("AX1", ()))
    for direction in Direction:
        step = 1 if direction is Direction.POSITIVE else -1
        change = now.correction("AX1", where, step) - was.correction("AX1", where, step)
        assert change == pytest.approx(
            new.at(where, direction) - old.at(where, direction), abs=1e-9
        )


def test_a_table_that_was_given_to_be_written_is_none_that_stays() -> None:
    for cec, why in ((NO_MULTIPLE, "does not divide"), (PRODUCT, "multiplied")):
        with pytest.raises(InputError, match=why):
            read(cec, cec_tables=[3], cec_sign="error")
    with pytest.raises(UsageError, match="cec_sign"):
        read(OWN, cec_tables=[3])
    state = read(OWN, cec_tables=[3], cec_sign="error")
    assert not state.stays
    control = control_format(SIEMENS, {"cec_tables": [3], "cec_sign": "error"}, state)
    (file,) = control.write([NEW], [AXIS], given(OWN))
    assert b"$AN_CEC[3,1]=0.00\n" in file.content  # emptied: it would act beside the new one


def test_a_factor_of_a_table_that_stays_is_not_emptied() -> None:
    """Table 4, given to be written, is what table 3 of another axis is multiplied by."""
    options: dict[str, object] = {"cec_tables": [4], "cec_sign": "error"}
    on = [
        replace(file, content=file.content.replace(b"ENABLE[4]=0", b"ENABLE[4]=1"))
        for file in given(FOREIGN)
    ]
    state = control_format(SIEMENS, options).read(on, [AXIS])
    with pytest.raises(CapacityError, match=r"table 3 .*multiplies it by table 4 .*MULT_BY_TABLE"):
        control_format(SIEMENS, options, state).write([NEW], [AXIS], on)


@pytest.mark.parametrize("gone", ["$SN_CEC_TABLE_ENABLE[3]=1\n", "$MA_CEC_ENABLE[AX1]=1\n"])
def test_whether_it_acts_must_be_told_where_readings_hang_on_it(gone: str) -> None:
    """What is off in the test and wakes afterwards is no table that stays."""
    text = [replace(f, content=f.content.replace(gone.encode(), b"")) for f in given(OWN)]
    control = control_format(SIEMENS, {"cec_sign": "error"})

    def asked(said: bool | None) -> ControlState:
        return control.read(text, [AXIS], activity=Activity(said, asking=True))

    with pytest.raises(UsageError, match="is unknown whether the table was active"):
        asked(None)
    assert asked(True).stays
    slept = asked(False)
    assert not slept.stays
    bound = control_format(SIEMENS, {"cec_sign": "error"}, slept)
    with pytest.raises(CapacityError, match="would be active in addition to the new table"):
        bound.write([NEW], [AXIS], text)


def test_two_states_that_differ_in_it_say_so() -> None:
    one, other = (read(NO_MULTIPLE.replace("0.03", value)) for value in ("0.03", "0.031"))
    factor = read(PRODUCT), read(PRODUCT.replace("-0.7", "-0.6"))
    assert one.facts["AX1"].other_functions != other.facts["AX1"].other_functions
    assert factor[0].facts["AX1"].other_functions != factor[1].facts["AX1"].other_functions
    assert "CW-S050" in codes(one)
    assert "CW-S011" in codes(factor[0])


def test_a_pair_leaves_room_for_what_stays() -> None:
    """MD32720 limits the sum of all tables."""
    options: dict[str, object] = {"cec": "available", "cec_tables": [20, 21], "cec_sign": "error"}
    for cec, taken in ((OWN, 0.03), (NO_MULTIPLE, 0.03), (PRODUCT, 0.03 * 2)):
        state = read(cec, **options)
        capacity = control_format(SIEMENS, options, state).capacity(AXIS)
        assert capacity.value_range == pytest.approx((-1 + taken, 1 - taken), abs=1e-12)


@pytest.mark.parametrize("told", [{}, {"cec_sign": "error"}], ids=["sign not given", "sign given"])
@pytest.mark.parametrize("other", ["AX1", "AX2"])
def test_a_sum_that_the_control_cuts_off_stays_too(other: str, told: dict[str, object]) -> None:
    """MD32720 below what the table reaches, alone or with a table of another axis: the control cuts
    the sum before and after alike.
    """
    both = OWN + cec_lines(4, other, "AX1", 0, 400, [0.02, 0.01, -0.01])
    on = MD.replace("ENABLE[4]=0", "ENABLE[4]=1").replace("MAX_SUM[AX1]=1", "MAX_SUM[AX1]=0.015")
    text = files(A__INI=f"METRIC\nCHANDATA(1)\n{EEC}{both}{on}M17\n")
    state = control_format(SIEMENS, told).read(text, [AXIS])
    assert not state.cross
    assert "CEC table 3" in state.facts["AX1"].other_functions
    (written,) = control_format(SIEMENS, told, state).write([NEW], [AXIS], text)
    was, now = control_with(text, -1.0), control_with([written], -1.0)
    where = np.linspace(-50.0, 900.0, 96)
    for direction in Direction:
        step = 1 if direction is Direction.POSITIVE else -1
        change = now.correction("AX1", where, step) - was.correction("AX1", where, step)
        old = state.axes["AX1"].at(where, direction)
        assert change == pytest.approx(NEW.at(where, direction) - old, abs=1e-9)
        assert np.max(np.abs(was.correction("AX1", where, step) - old)) <= 0.015 + 1e-9
    with pytest.raises(InputError, match="CEC_MAX_SUM"):
        control_format(SIEMENS, {"cec_sign": "error", "cec_tables": [4]}).read(text, [AXIS])
    with pytest.raises(InputError, match="CEC_MAX_SUM"):
        control_format(SIEMENS, {"cec_sign": "error"}).read(text)


def test_what_is_wanted_beside_it_is_zero_at_the_reference_again() -> None:
    (stays,) = read(OWN, cec_sign="error").stays["AX1"]
    nodes = np.linspace(0.0, 800.0, 9)
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=0.001 * np.sin(nodes),
        negative=0.001 * np.cos(nodes),
        reference=0.0,
        reference_return=Direction.POSITIVE,
        noise=0.001,
        reversal_log_odds=0.0,
        periods=(),
    )
    own = without_kept_tables(wanted, (stays,))
    assert without_kept_tables(wanted, ()) is wanted
    assert own.positive[0] == 0.0
    for direction in Direction:
        whole = own.total(direction) + stays.at(nodes, direction)
        assert np.ptp(whole - wanted.total(direction)) < 1e-15


def builders_table(case: Case, rng: np.random.Generator) -> None:
    """One for both directions, of several micrometres, which no option names."""
    variations.own_table(case, rng, 0, 9, 2.0)


@needs_archive
@pytest.mark.parametrize("sign", [1.0, -1.0], ids=["correction", "error"])
@pytest.mark.parametrize("told", [True, False], ids=["told", "sign is not given"])
def test_a_job_beside_a_builders_table_of_the_axis(
    sign: float, told: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Written as well as without it: the leadscrew table takes back what the other one does."""

    def run(arguments: list[str]) -> tuple[int, str]:
        capsys.readouterr()
        code = compwright(arguments)
        out, err = capsys.readouterr()
        return code, err + out

    predicted = []
    for special in (builders_table, variations.nothing):
        case = named(special, 3)
        case.cec_sign = sign
        if told and special is builders_table:
            case.options["cec_sign"] = "correction" if sign > 0 else "error"
        (tmp_path / special.__name__).mkdir()
        outcome = try_case(case, tmp_path / special.__name__, run)
        assert not outcome.harms, outcome.line()
        assert outcome.written, outcome.line()
        assert case.cec is not None
        assert outcome.files.get("NC_CEC.INI", case.cec.encode()) == case.cec.encode()
        predicted.append(outcome.predicted)
    # The grid that is there stays, and the other table bends between its nodes; uncounted it is 33 um.
    assert predicted[0] < 1.5 * predicted[1]
