"""What a whole INI of LinuxCNC says of its joints: letters, gantries, limits, units, kinematics; taken, or refused by name."""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

MACHINE = Machine(low=0.0, high=200.0)
INI = """[KINS]
KINEMATICS = trivkins coordinates=XYYZA
[TRAJ]
LINEAR_UNITS = inch
ANGULAR_UNITS = degree
[JOINT_0]
TYPE = LINEAR
MIN_LIMIT = -1.0
MAX_LIMIT = 20
BACKLASH = 0.001
[JOINT_1]
TYPE = LINEAR
BACKLASH = 0.002
[JOINT_2]
TYPE = LINEAR
BACKLASH = 0.002
[JOINT_3]
TYPE = LINEAR
[JOINT_4]
TYPE = ANGULAR
MIN_LIMIT = -90
MAX_LIMIT = 90
BACKLASH = 0.01
"""


def run(folder: Path, axis: str, ini: str = INI) -> int:
    targets = MACHINE.targets()
    name = axis.split(":", maxsplit=1)[0]
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1), axis=name))
    (folder / "machine.ini").write_text(ini)
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [machine.ini]}\n"
        f"axes:\n  {axis}travel: [0, 200], before: [x.csv]}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def test_a_new_job_takes_kind_limits_and_letters_and_names_what_it_leaves_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "machine.ini").write_text(INI)
    assert (
        compwright(["new", "--from", str(tmp_path / "machine.ini"), "--format", "linuxcnc", "--out", str(tmp_path / "j.yaml")]) == 0
    )
    text = (tmp_path / "j.yaml").read_text()
    assert "travel: [-25.4, 508.0]" in text  # -1 in and 20 in
    assert "travel: [-90.0, 90.0]" in text
    assert text.count("kind: rotary   # from the control's files") == 1
    assert 'gantry: "2"' in text
    named = [line.strip(' :"') for line in text.splitlines() if line.endswith(":") and line.startswith("  ")]
    assert [name for name in named if len(name) == 1] == ["X", "Y", "A"]
    assert "left out, because nothing in the files acts on them: 3 (Z)" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("axis", "ini", "word"),
    [
        ('Z: {address: "2", ', INI, "joint 2 is Y"),  # the place of Z among XYZ, but the second joint of Y here
        ("Z: {", INI, "joint 2 is Y"),
        ('Y: {address: "1", ', INI, 'gantry: "2"'),
        ('X: {address: "0", ', INI.replace("trivkins coordinates=XYYZA", "corexykins"), "KINEMATICS"),
        ('A: {address: "4", kind: rotary, ', INI.replace("= degree", "= rad"), "ANGULAR_UNITS"),
    ],
)
def test_what_would_put_a_table_on_the_wrong_joint_or_in_the_wrong_unit_is_refused(
    tmp_path: Path, axis: str, ini: str, word: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, axis, ini) == 3
    assert word in capsys.readouterr().err


def test_the_joints_of_a_gantry_get_one_table_each(tmp_path: Path) -> None:
    assert run(tmp_path, 'Y: {address: "1", gantry: "2", ') == 0
    names = sorted(path.name for path in (tmp_path / "job" / "tables" / "linuxcnc").iterdir())
    assert names == ["joint_1.comp", "joint_1.ini", "joint_2.comp", "joint_2.ini"]
    assert "BACKLASH becomes 0" in (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
