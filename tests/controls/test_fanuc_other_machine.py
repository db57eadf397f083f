"""A plan handed to another machine of the same series, and a card whose parameters are typed in:
what the user says, and what the control's own files hold, is what counts.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from backup_files_fanuc import FOLDER, PARAMETERS, PITCH, Backup
from backup_jobs_fanuc import Job, alike, axis_job, job_on
from judge_fanuc import Played, quietly, run_job
from virtual_fanuc import VirtualFanuc, loaded

pytestmark = pytest.mark.short_estimate

needs_backup = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
)
#: 1851 as written is a whole number of detection units of the coarser control.
HALF_UNIT = 0.5 * 0.001


def exported(played: Played, out: Path, *words: str) -> tuple[int, str]:
    command = ["export", str(played.out / "plan.json"), "--format", "fanuc-30i"]
    code, said, _ = quietly([*command, *words, "--out", str(out)])
    return code, said


def with_unit(unit: str) -> Job:
    """One linear axis in an empty control, its detection unit (mm) said by the axis itself."""
    axis = axis_job(np.random.default_rng(6), 1)
    axis = replace(axis, words={**axis.words, "options": f"{{detection_unit: {unit}}}"})
    return job_on("plain", axis, None, options={"first_point": "10"})


def backlash(folder: Path) -> int:
    found = re.search(r"N01851Q1A1P(-?\d+)", (folder / "PARAM_1.TXT").read_text())
    assert found is not None
    return int(found[1])


def test_the_detection_unit_of_the_command_goes_over_that_of_the_plan(tmp_path: Path) -> None:
    """1851 and pitch data count in detection units (0.0001 mm here, 0.001 mm there): the same
    lost motion in mm is a tenth of the count on the coarser control.
    """
    played = run_job(with_unit("0.0001"), tmp_path)
    assert played.code == 0, played.said
    words = ["--state", "none", "--option"]
    code, said = exported(played, tmp_path / "same", *words, "first_point=10")
    assert code == 0, said
    code, said = exported(
        played, tmp_path / "coarse", *words, "first_point=10", "detection_unit=0.001"
    )
    assert code == 0, said
    fine, coarse = backlash(tmp_path / "same"), backlash(tmp_path / "coarse")
    assert abs(fine) > 10, "the axis has a lost motion that shows"
    assert abs(0.0001 * fine - 0.001 * coarse) <= HALF_UNIT + 1e-9


@needs_backup
def test_a_detection_unit_against_the_plans_own_files_is_refused(tmp_path: Path) -> None:
    axis = axis_job(np.random.default_rng(6), 1)
    played = run_job(job_on("plain", axis, alike(Backup.real(), 1)), tmp_path)
    assert played.code == 0, played.said
    code, said = exported(played, tmp_path / "again", "--option", "detection_unit=0.001")
    assert code == 3, said
    assert "1820" in said
    assert not (tmp_path / "again").exists()


@needs_backup
def test_the_card_sets_no_turn_that_the_files_leave_alone(tmp_path: Path) -> None:
    """B of the real backup turns endlessly by 1260 = 360 while 3625 = 0.0: who types in what the
    card says has to end at what was planned, and ``compare`` has to agree.
    """
    axis = axis_job(np.random.default_rng(3), 4)
    played = run_job(job_on("plain", axis, alike(Backup.real(), 4)), tmp_path)
    assert played.code == 0, played.said
    card = (played.out / "card" / "card.md").read_text()
    steps = card[card.index("## Steps") : card.index("## Axis")]
    files = {name: (played.tables / name).read_bytes() for name in (PARAMETERS, PITCH)}
    after = VirtualFanuc(loaded(files.values()))
    for number, value in re.findall(r"\b(36\d\d) = (-?[\d.]+)", steps):
        if (number, value) == ("3623", "0"):  # for the check of the sign alone
            continue
        assert float(value) == after.value(int(number), 4), number


def test_the_card_sets_the_turn_where_nothing_stands_there(tmp_path: Path) -> None:
    """An empty control: 3625 = 360 is written and said (B-63980EN/01 page 100)."""
    axis = axis_job(np.random.default_rng(3), 4)
    job = job_on("plain", axis, None, options={"first_point": "10", "detection_unit": "0.0001"})
    played = run_job(job, tmp_path)
    assert played.code == 0, played.said
    assert "3625 = 360" in (played.out / "card" / "card.md").read_text()
    assert "N03625Q1A4P360" in (played.tables / "PARAM_4.TXT").read_text()
