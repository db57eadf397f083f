"""``programmed: diameter`` is checked against the control, without meaning for its tables, or
refused by name.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(low=0.0, high=200.0)


def run(folder: Path, control: str, address: str, programmed: str, options: str = "{}") -> int:
    targets = MACHINE.targets()
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {options}}}\nstates: {{as_found:"
        " none}\n"
        f'axes:\n  X: {{travel: [0, 200], address: "{address}", before: [x.csv], programmed:'
        f" {programmed}}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


@pytest.mark.parametrize("control", ["heidenhain-itnc530", "heidenhain-nck"])
def test_a_control_of_which_nobody_knows_refuses(
    tmp_path: Path, control: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, control, "X", "diameter") == 2
    said = capsys.readouterr().err
    assert "axes.X.programmed" in said
    assert "radius or in diameter" in said


def test_linuxcnc_counts_joints_in_radius(tmp_path: Path) -> None:
    """Facts: a table is looked up at the commanded joint position, behind everything that the
    program's words mean.
    """
    tables = []
    for programmed in ("radius", "diameter"):
        assert run(tmp_path, "linuxcnc", "0", programmed) == 0
        tables.append((tmp_path / "job" / "tables" / "linuxcnc" / "joint_0.comp").read_bytes())
        assert ("In G7 program twice" in (tmp_path / "job" / "card" / "card.md").read_text()) == (
            programmed == "diameter"
        )
    assert tables[0] == tables[1]


def test_an_axis_key_among_the_controller_s_options_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The reference of an axis decides where its table is zero; as an option of the controller
    nothing in a job reads it.
    """
    assert run(tmp_path, "linuxcnc", "0", "radius", "{reference: 100}") == 2
    assert "axes.NAME.reference" in capsys.readouterr().err
