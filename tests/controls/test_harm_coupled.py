"""Two columns that move as one: neither gets a table alone, none loses what is its own.

Judged with both columns measured, on six controls that this judge has built from the facts.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

import harm_columns
from compwright.controls.control import open_control
from compwright.controls.differences import ComparedSide, compared_side
from compwright.controls.read_back import newly_coupled
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlFile, ControlState, CrossCompensation
from compwright.records.facts import AxisFacts
from compwright.records.plan import PlannedCross
from harm_bridges import (
    BACKLASH,
    BRIDGES,
    EMPTY,
    GRID,
    LEAD,
    TABLE,
    Bridge,
    Column,
    FanucBridge,
    PmacBridge,
    Skew,
)
from harm_columns import APART, FIRST, SECOND, accuracy, load, prepare, snapshot
from harm_command import ASKED, card_of, command, tables_of

pytestmark = pytest.mark.short_estimate

EACH = [pytest.param(make, id=name) for name, make in BRIDGES.items()]
COUPLED = [
    pytest.param(make, coupling, id=f"{name} {coupling}")
    for name, make in BRIDGES.items()
    for coupling in make().couplings
]


@pytest.mark.parametrize(("make", "coupling"), COUPLED)
def test_a_column_alone_gets_no_table(make: type[Bridge], coupling: str, tmp_path: Path) -> None:
    bridge = make()
    answer = command("run", prepare(tmp_path, bridge, TABLE, coupling))
    assert answer.declined, answer.first
    assert not tables_of(tmp_path / "job")
    if coupling.isdigit():
        assert answer.names(coupling)


def test_every_question_about_the_axis_is_asked_at_once(tmp_path: Path) -> None:
    """A FANUC file without 1820 and 1013: the detection unit is asked for together with 8311."""
    job = prepare(tmp_path, FanucBridge(), TABLE, "8311")
    parameters = tmp_path / "CNC-PARA.TXT"
    rows = parameters.read_text(encoding="utf-8").splitlines(keepends=True)
    kept = [row for row in rows if not row.startswith(("N01820", "N01013"))]
    parameters.write_text("".join(kept), encoding="utf-8")
    answer = command("run", job)
    assert answer.code == ASKED, answer.first
    assert answer.names("detection_unit", "8311", "gantry")


@pytest.mark.parametrize(("make", "coupling"), COUPLED)
def test_the_partner_alone_gets_no_table(make: type[Bridge], coupling: str, tmp_path: Path) -> None:
    bridge = make()
    bridge.lead, bridge.partner = bridge.partner, bridge.lead
    answer = command("run", prepare(tmp_path, bridge, TABLE, coupling))
    assert answer.declined, answer.first
    assert not tables_of(tmp_path / "job")


@pytest.mark.parametrize(
    ("make", "coupling"), [case for case in COUPLED if not re.search("8186|I206", str(case.id))]
)
def test_new_fills_in_the_partner(make: type[Bridge], coupling: str, tmp_path: Path) -> None:
    bridge = make()
    files = prepare(tmp_path, bridge, TABLE, coupling).read_text().split("[", 1)[1].split("]")[0]
    option = bridge.options.strip("{}").replace(": ", "=")
    answer = command(
        "new",
        *(word for name in files.split(", ") for word in ("--from", tmp_path / name)),
        *("--format", bridge.format, "--out", tmp_path / "new.yaml"),
        *(("--option", option) if option else ()),
    )
    assert answer.code == 0, answer.first
    text = (tmp_path / "new.yaml").read_text(encoding="utf-8")
    rows = [row for row in text.splitlines() if row.strip().startswith("gantry")]
    assert any(bridge.partner in row or bridge.lead in row for row in rows), text


@pytest.mark.parametrize("make", EACH)
@pytest.mark.parametrize(
    "partner", [TABLE, BACKLASH, GRID, EMPTY], ids=["table", "backlash", "grid", "empty"]
)
def test_a_partner_with_something_of_its_own_is_asked_about(
    make: type[Bridge], partner: Column, tmp_path: Path
) -> None:
    bridge = make()
    for gantry in ("IT", "{axis: IT}"):
        answer = command(
            "run", prepare(tmp_path, bridge, partner, bridge.couplings[0], gantry), "--force"
        )
        assert answer.code == ASKED, answer.first
        assert not tables_of(tmp_path / "job")


#: µm by which two columns may move apart without a doubt.
UNDOUBTED = 2.0
OWN = {"table": TABLE, "backlash": BACKLASH, "grid": GRID, "empty": EMPTY}


@pytest.mark.parametrize(
    ("make", "partner"),
    [
        pytest.param(make, partner, id=f"{name} {what}")
        for name, make in BRIDGES.items()
        for what, partner in OWN.items()
    ],
)
def test_the_change_keeps_the_columns_square(
    make: type[Bridge], partner: Column, tmp_path: Path
) -> None:
    """Both columns move by the same: the first gets better, and the skew stays what it was."""
    bridge = make()
    path = prepare(tmp_path, bridge, partner, bridge.couplings[0], "{axis: IT, table: change}")
    first, second = (snapshot(bridge, address) for address in (bridge.lead, bridge.partner))
    before = accuracy(FIRST, bridge.correction(bridge.lead), 3)
    answer = command("run", path)
    doubted = answer.names("CW-S038")
    assert answer.code == (1 if doubted else 0), answer.first
    load(bridge, tmp_path / "job")
    assert accuracy(FIRST, bridge.correction(bridge.lead), 3) < 0.6 * before
    skew = Skew()
    pairs = zip(
        skew.changes(first, bridge.correction(bridge.lead)),
        skew.changes(second, bridge.correction(bridge.partner)),
        strict=True,
    )
    apart = max(abs(a - b) for a, b in pairs)
    assert apart <= APART + 1e-6
    if not doubted:
        assert apart <= UNDOUBTED
    if partner.step == LEAD.step:
        assert not doubted or apart > UNDOUBTED - 0.5


def test_columns_that_move_apart_by_more_than_is_gained_decide_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Steps of 300 mm on one column and of 50 mm on the other: no table can move both alike."""
    monkeypatch.setattr(harm_columns, "LEAD", Column((0, -17, -34), step=300.0))
    bridge = BRIDGES["fanuc"]()
    path = prepare(tmp_path, bridge, GRID, bridge.couplings[0], "{axis: IT, table: change}")
    answer = command("run", path)
    assert answer.code == 1, answer.first
    assert answer.names("CW-S038")


@pytest.mark.parametrize("make", EACH)
def test_the_same_table_is_the_same(make: type[Bridge], tmp_path: Path) -> None:
    bridge = make()
    path = prepare(tmp_path, bridge, TABLE, bridge.couplings[0], "{axis: IT, table: same}")
    answer = command("run", path)
    assert answer.code == 0, answer.first
    load(bridge, tmp_path / "job")
    one, other = (bridge.correction(address) for address in (bridge.lead, bridge.partner))
    assert all(abs(one(x, d) - other(x, d)) < 2e-4 for x in Skew().places for d in (1, -1))
    if isinstance(bridge, PmacBridge):  # 1 count is 1 µm
        rows = re.findall(
            r"backlash in addition to the table \|[^|]*\| *([-\d.]+) µm", card_of(tmp_path / "job")
        )
        assert {float(row) for row in rows} == {round(bridge.play["1"] / 16, 2)}


#: Values that no page allows for a parameter that couples axes: control, file, line, its name.
UNREADABLE = [
    ("sinumerik", "MD.INI", "$MA_MS_ASSIGN_MASTER_SPEED_CMD[AX4]=R5", "MD37250"),
    ("sinumerik", "MD.INI", "N37252 $MA_MS_ASSIGN_MASTER_TORQUE_CTR[AX4]=_MASTER", "MD37252"),
    ("sinumerik", "MD.INI", "$MA_CC_MASTER_AXIS[AX4]= ; 1", "MD63000"),
    ("sinumerik", "MD.INI", "$MA_GANTRY_AXIS_TYPE[AX4]=1X", "GANTRY_AXIS_TYPE"),
    ("sinumerik", "MD.INI", "$MC_TRAFO_RESET_VALUE=R1", "TRAFO_RESET_VALUE"),
    ("heidenhain", "MP.TXT", "MP850.1 : X", "MP850.1"),
    ("heidenhain", "MP.TXT", "MP850.1 : 1,0", "MP850.1"),
    ("isg", "achskw2.lis", "kenngr.gantry_ax_nr X1", "kenngr.gantry_ax_nr"),
    ("isg", "achskw2.lis", "kenngr.gantry_ax_nr", "kenngr.gantry_ax_nr"),
    ("isg", "achskw2.lis", "kenngr.multi_link[0].lead_axis -", "multi_link"),
    ("pmac", "comp.pmc", "I206=MODE", "I206"),
    ("fanuc", "CNC-PARA.TXT", "N08311Q1A1P0A2P0A3P0A4P1.5", "8311"),
]


@pytest.mark.parametrize(("name", "file", "line", "parameter"), UNREADABLE)
def test_a_coupling_that_cannot_be_read_is_no_zero(
    name: str, file: str, line: str, parameter: str, tmp_path: Path
) -> None:
    job = prepare(tmp_path, BRIDGES[name](), TABLE, "")
    path = tmp_path / file
    rows = [row for row in path.read_text().splitlines() if parameter not in row]
    last = rows[-1:] if rows[-1] in ("M17", "%") else []
    path.write_text("\n".join([*rows[: len(rows) - len(last)], line, *last]) + "\n")
    answer = command("run", job)
    assert answer.declined, answer.first
    assert answer.names(parameter)


def read_side(bridge: Bridge, files: Mapping[str, str]) -> ComparedSide:
    options = yaml.safe_load(bridge.options)
    contents = [ControlFile(name, text.encode()) for name, text in files.items()]
    return compared_side(open_control(Session(), bridge.format, options), contents, "the files")


@pytest.mark.parametrize(
    ("name", "file", "line", "parameter"),
    [
        *(one for one in UNREADABLE if one[3] != "GANTRY_AXIS_TYPE"),  # the file is not read at all
        ("sinumerik", "MD.INI", "$MA_CC_MASTER_AXIS[AX4]=1", "MD63000"),
        ("isg", "achskw2.lis", "kenngr.multi_link[0].lead_axis 1", "multi_link"),
        *(
            (name, coupling, "", "->" if coupling == "definition" else coupling)
            for name, make in BRIDGES.items()
            for coupling in make().couplings
            if name != "linuxcnc"  # no tables between axes
        ),
    ],
)
def test_a_coupling_that_appears_in_what_was_read_back_is_a_doubt(
    name: str, file: str, line: str, parameter: str
) -> None:
    """A table on one of two coupled axes racks the machine, whatever file states the coupling."""
    bridge = BRIDGES[name]()
    plain = bridge.files(TABLE, TABLE, "")
    if line:
        rows = [row for row in plain[file].splitlines() if parameter not in row]
        last = rows[-1:] if rows[-1] in ("M17", "%") else []
        new = {**plain, file: "\n".join([*rows[: len(rows) - len(last)], line, *last]) + "\n"}
    else:
        new = bridge.files(TABLE, TABLE, file)
    where = np.array([0.0, 100.0])
    linear = AxisKind.LINEAR
    added = CrossCompensation(
        input=bridge.partner,
        output="9",
        input_kind=linear,
        output_kind=linear,
        positions=where,
        positive=where,
        negative=where,
    )
    cross = PlannedCross(input="X", output="Y", added=added, source="circle")
    sides = [read_side(bridge, files) for files in (plain, new)]
    assert not newly_coupled([cross], {}, sides[0], sides[0])
    assert not newly_coupled([replace(cross, written=False)], {}, *sides)
    (finding,) = newly_coupled([cross], {}, *sides)
    assert "X" in finding.values.values()
    assert parameter in str(finding.message)


def coupled_side(**couplings: dict[str, str]) -> ComparedSide:
    facts = {name: AxisFacts(couplings=each) for name, each in couplings.items()}
    return ComparedSide((), {}, ControlState(format="siemens-840d-sl", axes={}, facts=facts))


def test_what_is_coupled_now_is_named_by_axis_by_value_and_by_the_job() -> None:
    """Both axes of a table are named. A gantry of the job that only the files read back hold is as
    planned; a value that has changed is none of a new coupling.
    """
    where = np.array([0.0, 100.0])
    added = CrossCompensation(
        input="AX1",
        output="AX2",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=where,
        positive=where,
        negative=where,
    )
    cross = PlannedCross(input="X", output="Y", added=added, source="circle", written=True)
    axes = {
        "X": Axis(name="X", address="AX1", kind=AxisKind.LINEAR, travel=(0.0, 100.0), gantry="AX5")
    }
    plain, leads = coupled_side(), coupled_side(AX1={"MD37100 = 1": "AX5"})

    def found(axes: Mapping[str, Axis], *sides: ComparedSide) -> str:
        return " ".join(str(one.message) for one in newly_coupled([cross], axes, *sides))

    both = coupled_side(AX1={"MD37100[AX1] = 1": "AX5"}, AX2={"MD37100[AX2] = 1": "AX6"})
    assert "MD37100[AX1]" in found({}, plain, both)
    assert "MD37100[AX2]" in found({}, plain, both)
    assert "MD37100[AX1]" not in found(axes, plain, both)
    assert not found(axes, plain, leads)
    assert "state it in the job" in found({}, plain, leads)
    for other in ({"MD37100 = 1": "AX6"}, {"MD37100 = 11": ""}):
        assert "state it in the job" in found(axes, plain, coupled_side(AX1=other))
    changed = found(axes, leads, coupled_side(AX1={"MD37100 = 11": ""}))
    assert "is MD37100 = 11 in the files read back, and MD37100 = 1 in those of the plan" in changed
    assert "do not" not in changed
    assert not found(axes, leads, coupled_side(AX1={"MD37100 = 2": "AX5"}))


def test_a_coupling_of_the_lists_is_compared_by_its_value() -> None:
    """Its line has no `=`: `kenngr.gantry_ax_nr 0` couples nothing."""
    bridge = BRIDGES["isg"]()
    texts = {
        value: read_side(bridge, bridge.files(TABLE, TABLE, "") | {"o.lis": f"{line} {value}\n"})
        for line, value in [("kopf.achs_nr 3\nkenngr.gantry_ax_nr", one) for one in "012"]
    }
    ((key, entry),) = [
        (key, one) for key, one in texts["0"].entries.items() if "gantry" in one.name
    ]
    assert (entry.axis, entry.text, entry.relevant) == ("3", "0", True)
    assert [side.entries[key].text for side in texts.values()] == ["0", "1", "2"]


@pytest.mark.parametrize("value", ["-x", "1.5"])
def test_a_homing_sequence_that_cannot_be_read_is_no_zero(value: str, tmp_path: Path) -> None:
    """Without letters in the line of the kinematics, a negative sequence may join two joints."""
    job = prepare(tmp_path, BRIDGES["linuxcnc"](), TABLE, "")
    path = tmp_path / "mill.ini"
    text = path.read_text().replace("trivkins coordinates=XYZA kinstype=BOTH", "trivkins")
    text = text.replace("[JOINT_1]\n", f"[JOINT_1]\nHOME_SEQUENCE = {value}\n")
    path.write_text(text)
    answer = command("run", job)
    assert answer.declined, answer.first
    assert answer.names("HOME_SEQUENCE")


def test_both_tables_are_switched_off_first(tmp_path: Path) -> None:
    """A table that is on is protected: the step names the switch of both columns."""
    bridge = BRIDGES["sinumerik"]()
    answer = command("run", prepare(tmp_path, bridge, TABLE, "37100", "{axis: IT, table: same}"))
    assert answer.code == 0, answer.first
    step = card_of(tmp_path / "job").split("Switch the old table off")[1].split("- [ ] **")[0]
    assert "AX1" in step
    assert "AX4" in step


def test_equal_tables_without_a_gantry_are_a_remark(tmp_path: Path) -> None:
    """MD37100 = 0: the files say that the axes are no gantry."""
    answer = command("run", prepare(tmp_path, BRIDGES["sinumerik"](), LEAD, ""))
    assert answer.code == 0, answer.first
    assert "No gantry: MD37100 = 0" in card_of(tmp_path / "job")


@pytest.mark.parametrize("make", EACH)
def test_columns_that_do_the_same_need_no_answer(make: type[Bridge], tmp_path: Path) -> None:
    bridge = make()
    before_second = 0.0
    path = prepare(tmp_path, bridge, LEAD, bridge.couplings[0], "IT")
    before_second = accuracy(SECOND, bridge.correction(bridge.partner), 5)
    answer = command("run", path)
    assert answer.code == 0, answer.first
    load(bridge, tmp_path / "job")
    assert accuracy(SECOND, bridge.correction(bridge.partner), 5) < before_second


@pytest.mark.parametrize("make", EACH)
@pytest.mark.parametrize("coupling", ["", "others"])
def test_an_axis_of_its_own_is_written_whatever_others_do(
    make: type[Bridge], coupling: str, tmp_path: Path
) -> None:
    bridge = make()
    path = prepare(tmp_path, bridge, TABLE, coupling)
    second = snapshot(bridge, bridge.partner)
    answer = command("run", path)
    assert answer.code == 0, answer.first
    load(bridge, tmp_path / "job")
    assert not any(Skew().changes(second, bridge.correction(bridge.partner)))
