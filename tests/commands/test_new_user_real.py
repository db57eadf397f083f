"""A new user's way with real files, by the commands of README and tutorials alone: a whole FANUC
backup and a SINUMERIK archive with a laser file each to a table that is in the control, and a
ballbar file to what the mechanic checks first.

The laser files are written here: 12 µm/m too long, 3 µm of lost motion, some scatter.
"""

from __future__ import annotations

import json
import random
import re
import shutil
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from places import REAL, needs_shared

pytestmark = [needs_shared, pytest.mark.short_estimate]

SLOPE, LOST = 0.012, 3.0


def laser_file(path: Path, low: float, high: float) -> None:
    chance = random.Random(4)  # noqa: S311 - no secret
    rows = ["# axis: X", "target_mm,direction,run,deviation_um"]
    for run in range(1, 6):
        for sign in "+-":
            for place in range(17):
                target = low + (high - low) * (place / 16) + place * 7 % 5 * 1.13
                scatter = chance.gauss(0.0, 0.5)
                value = SLOPE * target - (LOST if sign == "+" else 0.0) + scatter
                rows.append(f"{target:.3f},{sign},{run},{value:.2f}")
    path.write_text("\n".join([*rows, ""]), encoding="utf-8")


@pytest.mark.parametrize(
    ("files", "name", "travel", "tables"),
    [
        ("fanuc", "31i", (-960.0, -40.0), "fanuc-30i"),
        ("siemens/dmu_840d_sl.arc", "840d-sl", (20.0, 895.0), "siemens-840d-sl"),
    ],
)
def test_from_the_control_s_files_to_a_table_in_the_control(
    files: str,
    name: str,
    travel: tuple[float, float],
    tables: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    control = tmp_path / "control"
    if (REAL / files).is_dir():
        shutil.copytree(REAL / files, control)
    else:
        control.mkdir()
        shutil.copy(REAL / files, control)
    laser_file(tmp_path / "x.csv", *travel)
    assert compwright(["evaluate", "x.csv"]) == 0
    assert compwright(["new", "--from", "control", "--format", name, "--out", "job.yaml"]) == 0
    asked = capsys.readouterr().err
    assert asked.count("fill in: axes.") == asked.count(".before: ")  # only the tests are open
    text = Path("job.yaml").read_text(encoding="utf-8")
    text = re.sub(r"before:   # FILL IN.*", "before: [x.csv]", text, count=1)
    Path("job.yaml").write_text(text, encoding="utf-8")
    assert compwright(["run", "job.yaml"]) == 2  # the axes that were not measured
    assert "delete the axis from the job" in capsys.readouterr().err
    Path("job.yaml").write_text(text[: text.index('  "Y":')], encoding="utf-8")
    assert compwright(["run", "job.yaml"]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last.endswith("type: compwright compare job --loaded READ_BACK")
    assert compwright(["compare", "job", "--loaded", f"job/tables/{tables}"]) == 0
    predicted = json.loads(Path("job/prediction.json").read_text(encoding="utf-8"))["axes"]["X"]
    assert predicted["before"]["B_mean"] == pytest.approx(-LOST, abs=0.3)
    assert predicted["predicted"]["A"]["p95"] < 0.6 * predicted["before"]["A"]


def test_a_ballbar_file_says_what_the_mechanic_checks_first(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert compwright(["evaluate", str(REAL / "ballbar" / "ballbar_qc20w_150mm_XY.b5r")]) == 0
    shown = capsys.readouterr().out
    first = shown.partition("\nCheck first\n")[2].splitlines()[0]
    # the vendor's software printed a squareness of -10.4 um/m, 5 standard errors of the estimate
    assert "Squareness XY" in shown.partition("\nCheck first\n")[2]
    assert re.match(r"[A-Z][\w +]+ X?Y?.* \(\d+ % of all effects\)\. ", first)
