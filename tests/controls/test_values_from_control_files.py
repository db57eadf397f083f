"""What a job leaves to the control's own files is the same for every command: a plan is no stranger
to the job it was made from.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from test_fanuc_backup_honoured import Bench, added, error

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()


def test_a_detection_unit_read_from_the_backup_is_no_edit_of_the_job(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X") == 0
    parameters, points = bench.written()
    targets = np.linspace(-990.0, -10.0, 13)
    rng = np.random.default_rng(99)
    readings = {
        sign: (
            (error(1, targets, sign) + added(parameters, points, 1, targets, sign))[:, None]
            + rng.normal(0, 0.0003, (13, 3))
        )
        for sign in (1, -1)
    }
    (tmp_path / "after.csv").write_text(csv_of(targets, readings))
    code = compwright(
        ["verify", str(tmp_path / "job.yaml"), "--after", f"X={tmp_path / 'after.csv'}"]
    )
    document = json.loads((tmp_path / "job" / "verification.json").read_text())
    assert document["axes"]["X"]["loading"]["verdict"] == "loaded"
    assert (code, document["verdict"]) == (0, "good")


def test_a_detection_unit_read_from_the_backup_stays_with_its_control(tmp_path: Path) -> None:
    assert Bench(tmp_path).run("X") == 0
    plan, out = str(tmp_path / "job" / "plan.json"), str(tmp_path / "other")
    options = [
        "--format",
        "siemens-840d-sl",
        "--state",
        "none",
        "--option",
        "address.X=AX1",
        "--out",
        out,
    ]
    assert compwright(["export", plan, *options]) == 0


def test_the_measuring_system_in_use_is_no_edit_of_the_job(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    targets = MACHINE.targets()
    for name, seed in (("x.csv", 1), ("again.csv", 2)):
        (tmp_path / name).write_text(csv_of(targets, MACHINE.measure(targets, seed)))
    values = "".join(f"$AA_ENC_COMP[1,{n},AX1]=0.0\n" for n in range(21))
    (tmp_path / "EEC.INI").write_text(
        f"{values}$AA_ENC_COMP_STEP[1,AX1]=40\n$AA_ENC_COMP_MIN[1,AX1]=0\n$AA_ENC_COMP_MAX[1,AX1]=800\n$AA_ENC_COMP_IS_MODULO[1,AX1]=0\nM17\n"
    )
    switched_on = "$MN_SCALING_SYSTEM_IS_METRIC=1\n$MA_BACKLASH[1,AX1]=0\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n$MA_ENC_COMP_ENABLE[1,AX1]=1\nM17\n"
    (tmp_path / "MD.INI").write_text(switched_on)
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: [EEC.INI,"
        " MD.INI]}\naxes:\n  X: {travel: [0, 800], address: AX1, before: [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    capsys.readouterr()
    # measured once more without loading: the plan is this job's, and the verdict says that the
    # table does not act
    assert (
        compwright(["verify", str(tmp_path / "job.yaml"), "--after", f"x={tmp_path / 'again.csv'}"])
        == 1
    )
    document = json.loads((tmp_path / "job" / "verification.json").read_text())
    assert document["axes"]["X"]["loading"]["verdict"] == "not_active"


def test_a_backlash_that_no_file_says_stands_first(tmp_path: Path) -> None:
    """The table's file alone: a backlash in the control is counted as zero, and would be lost from
    the total if it is not.
    """
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    values = "".join(f"$AA_ENC_COMP[0,{n},AX1]=0.0\n" for n in range(21))
    grid = "".join(
        f"$AA_ENC_COMP_{name}[0,AX1]={value}\n"
        for name, value in (("STEP", 40), ("MIN", 0), ("MAX", 800), ("IS_MODULO", 0))
    )
    (tmp_path / "EEC.INI").write_text(f"METRIC\n{values}{grid}M17\n")
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: [EEC.INI]}\n"
        "axes:\n  X: {travel: [0, 800], address: AX1, before: [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 1  # until it is acknowledged
    doubts = json.loads((tmp_path / "job" / "prediction.json").read_text())["doubts"]
    assert any(doubt["code"] == "CW-S005" and "BACKLASH" in doubt["message"] for doubt in doubts)
