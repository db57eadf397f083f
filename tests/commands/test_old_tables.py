"""Two tests of an axis, with compensation on and off, before anything is written: what the control
really did is named, and a table whose total would be wrong is not written.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from compwright.records.stored_table import StoredTable
from compwright.verification.existing_table import ExistingTableVerdict
from compwright.workflow.run.old_tables import judged_old_table
from loop import Floats, Machine, csv_of

MACHINE = Machine(bow=0.012)
TARGETS = MACHINE.targets(count=17)
AXIS = Axis(name="X", kind=AxisKind.LINEAR, travel=(0.0, 800.0), address="0")
NODES = np.arange(0.0, 801.0, 50.0)
TABLE = AxisCompensation(
    address="0",
    kind=AxisKind.LINEAR,
    positions=NODES,
    positive=-0.8 * MACHINE.error(NODES, 1),
    negative=-0.8 * MACHINE.error(NODES, -1) - 0.0002,
)
Acts = Callable[[Floats, int], Floats]
STATES = {
    "off": ControlState(format="any", axes={}),
    "on": ControlState(format="any", axes={"0": TABLE}),
}

TABLES = {"X": StoredTable.by_point(TABLE)}


def acts(factor: float = 1.0, shift: float = 0.0) -> Acts:
    """What the control adds: its table times ``factor``, ``shift`` mm too far to +."""

    def added(x: Floats, sign: int) -> Floats:
        side = Direction.POSITIVE if sign > 0 else Direction.NEGATIVE
        return factor * TABLE.at(x - shift, side)

    return added


def planned(
    state: str, seed: int, correction: Acts | None = None, sign: float = 1.0
) -> PlannedTest:
    values = MACHINE.measure(TARGETS, seed, correction)
    test = PositioningTest(
        name=f"x_{state}",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=TARGETS,
        positive=values[1],
        negative=values[-1],
        frame="machine",
    )
    return PlannedTest(test=test, measured_in=state)


def judged(correction: Acts) -> ExistingTableVerdict:
    off, on = planned("off", 1), planned("on", 2, correction)
    return judged_old_table(AXIS, off, on, STATES, TABLES)


def test_a_table_that_acted_is_said_to_have_acted() -> None:
    old = judged(acts())
    assert (old.verdict.verdict, old.contradicted) == ("loaded", False)
    finding = old.finding()
    assert finding is not None
    assert (finding.code, finding.severity) == ("CW-V030", "info")


@pytest.mark.parametrize(
    ("what", "correction", "says"),
    [
        ("inverted", acts(factor=-1.0), "opposite sign"),
        ("shifted", acts(shift=100.0), "shifted by +2 points"),
    ],
)
def test_what_contradicts_the_files_is_named(what: str, correction: Acts, says: str) -> None:
    old = judged(correction)
    assert old.verdict.verdict == what, old.verdict
    assert old.contradicted
    assert old.probability_active < 0.01
    assert old.finding() is None
    reason = str(old.refusal(["look at the switch."]))
    assert says in reason
    assert reason.endswith("Look at: look at the switch")


@pytest.mark.parametrize("both", [acts(factor=0.0), acts()], ids=["off in both", "on in both"])
def test_two_tests_that_show_the_same_do_not_say_in_which_one_it_was_wrong(both: Acts) -> None:
    """Who forgot to switch off for the test without it has the same difference, none, as who forgot
    to switch on.
    """
    old = judged_old_table(AXIS, planned("off", 1, both), planned("on", 2, both), STATES, TABLES)
    assert old.contradicted
    reason = str(old.refusal([]))
    assert "was active in x_off too" in reason
    assert "contradict the control's files (99.9 % sure)." in reason


def test_tests_that_were_exchanged_may_look_like_the_opposite_sign() -> None:
    old = judged_old_table(AXIS, planned("off", 1, acts()), planned("on", 2), STATES, TABLES)
    assert old.verdict.verdict == "inverted"
    assert "the two tests are exchanged" in str(old.refusal([]))
    assert "exchanged" not in str(judged(acts(shift=100.0)).refusal([]))


def test_a_table_that_changes_next_to_nothing_cannot_be_told() -> None:
    """Of a table of half the noise of the means, nothing is claimed either way."""
    small = {
        **STATES,
        "on": ControlState(
            format="any",
            axes={
                "0": AxisCompensation(
                    address="0",
                    kind=AxisKind.LINEAR,
                    positions=NODES,
                    positive=0.00005 * np.sin(NODES / 90.0),
                    negative=0.00005 * np.sin(NODES / 90.0),
                )
            },
        ),
    }
    old = judged_old_table(
        AXIS,
        planned("off", 1),
        planned("on", 2),
        small,
        {"X": StoredTable.by_point(small["on"].axes["0"])},
    )
    assert not old.contradicted


def test_no_total_is_made_from_what_did_not_act(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The control held a table, was told to be on, and was not."""
    (tmp_path / "off.csv").write_text(csv_of(TARGETS, MACHINE.measure(TARGETS, 1)))
    (tmp_path / "on.csv").write_text(csv_of(TARGETS, MACHINE.measure(TARGETS, 2)))
    rows = zip(NODES, NODES - TABLE.positive, NODES - TABLE.negative, strict=True)
    (tmp_path / "joint_0.comp").write_text(
        "".join(f"{a:.4f} {b:.4f} {c:.4f}\n" for a, b, c in rows)
    )
    (tmp_path / "joint_0.ini").write_text(
        "[JOINT_0]\nCOMP_FILE = joint_0.comp\nCOMP_FILE_TYPE = 0\nBACKLASH = 0\n"
    )
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\n"
        "states: {as_found: [joint_0.comp, joint_0.ini], bare: none}\n"
        "axes:\n  X:\n    travel: [0, 800]\n    address: 0\n"
        "    before: [{files: on.csv, name: with}, {files: off.csv, name: without, measured_in: bare}]\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "CW-P001" in said
    assert "was not active" in said
    assert "COMP_FILE of [JOINT_0]" in said
    assert not (tmp_path / "job" / "tables").exists()
    assert (
        json.loads((tmp_path / "job" / "prediction.json").read_text())["axes"]["X"]["table"] is None
    )


@pytest.mark.short_estimate
def test_an_old_backlash_is_on_the_card_and_no_contradiction_of_the_new_ini(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """LinuxCNC gives half of BACKLASH in each direction; the user's INI gets three new lines."""
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, MACHINE.measure(TARGETS, 1)))
    ini = "[TRAJ]\nLINEAR_UNITS = mm\n[JOINT_0]\nTYPE = LINEAR\nBACKLASH=0.003\n"
    (tmp_path / "machine.ini").write_text(ini)
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [machine.ini]}\n"
        "axes:\n  X: {travel: [0, 800], address: 0, before: [x.csv], accept: {A: 20}}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    card = (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
    (row,) = [line for line in card.splitlines() if "backlash in addition" in line]
    assert "= 0.003 mm (3.00 µm)" in row.split("|")[3]
    assert "= 0 mm (0.00 µm)" in row.split("|")[4]
    tables = tmp_path / "job" / "tables" / "linuxcnc"
    back = tmp_path / "back"
    back.mkdir()
    (back / "joint_0.comp").write_bytes((tables / "joint_0.comp").read_bytes())
    keys = (tables / "joint_0.ini").read_text().removeprefix("[JOINT_0]\n")
    (back / "machine.ini").write_text(ini.replace("BACKLASH=0.003\n", keys))
    capsys.readouterr()
    compared = ["compare", str(tmp_path / "job"), "--loaded", str(back), "--json", "-"]
    assert compwright(compared) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["axes"]["X"]["differences"] == 0
    assert document["findings"] == []
    again = ["export", str(tmp_path / "job"), "--format", "linuxcnc", "--out", str(tmp_path / "a")]
    assert compwright(again) == 0  # the folder of the run, as its help says
    assert (tmp_path / "a" / "joint_0.comp").read_bytes() == (back / "joint_0.comp").read_bytes()


def test_an_old_table_that_was_idle_in_the_first_test_is_told_by_the_read_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The test after loading alone could also come from a total added to the old table; no step is
    named that is right for one of the two only, and the lost motion turned is explained.
    """
    monkeypatch.chdir(tmp_path)
    Path("first.csv").write_text(csv_of(TARGETS, MACHINE.measure(TARGETS, 31)))
    old = 0.004 * np.sin(NODES / 90.0)
    rows = zip(NODES, NODES - old, NODES - old + 0.003, strict=True)
    Path("joint_0.comp").write_text("".join(f"{a:.4f} {b:.4f} {c:.4f}\n" for a, b, c in rows))
    Path("joint_0.ini").write_text(
        "[JOINT_0]\nCOMP_FILE = joint_0.comp\nCOMP_FILE_TYPE = 0\nBACKLASH = 0\n"
    )
    Path("job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\n"
        "states: {as_found: [joint_0.comp, joint_0.ini]}\n"
        "axes: {X: {travel: [0, 800], address: 0, before: [first.csv]}}\n"
    )
    compwright(["run", "job.yaml"])
    new = np.loadtxt("job/tables/linuxcnc/joint_0.comp").T

    def loaded(x: Floats, sign: int) -> Floats:
        added: Floats = np.interp(x, new[0], new[0] - new[1 if sign > 0 else 2])
        return added

    Path("after.csv").write_text(csv_of(TARGETS, MACHINE.measure(TARGETS, 2, loaded)))
    capsys.readouterr()
    verify = ["verify", "job.yaml", "--after", "after.csv", "--force"]
    assert compwright(verify) == 1
    shown = " ".join(capsys.readouterr().out.split())
    assert "Loading: added to the existing table." in shown
    assert "readings: existing table not active in the first test." in shown
    assert "Clear the table" not in shown
    assert "CW-T032" not in shown
    shutil.copytree("job/tables/linuxcnc", "read_back")
    assert compwright([*verify, "--loaded", "read_back"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert "Loading: existing table not active in the first test." in lines
    assert lines[-1] == (
        "Next: state what was active in the first test of X (states), then type:"
        " compwright run job.yaml --out job --force"
    )
