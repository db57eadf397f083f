"""The test after loading in another table than the first one: ``verify --profile``."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

PROFILE = """\
compwright_profile: 1
layout: long
delimiter: semicolon
decimal: comma
header_line: 1
target: Soll
target_unit: mm
value: {value}
value_is: deviation
unit: um
sign: measured minus target
direction_from: column
direction: Richtung
directions: {{"+": "+", "-": "-"}}
run: Lauf
run_counts: runs
axis: X
cycle: standard
"""
JOB = """\
compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X:
    travel: [0, 400]
    address: "0"
    before: [{files: [x.csv], profile: before.yaml}]
    accept: {A: 9}
"""


def table(column: str, slope: float, seed: int) -> str:
    rng = np.random.default_rng(seed)
    rows = [
        f"{target};{sign};{run};{slope * target + rng.normal(0, 0.4):.3f}".replace(".", ",")
        for target in range(5, 400, 43)
        for sign in "+-"
        for run in range(1, 6)
    ]
    return f"Soll;Richtung;Lauf;{column}\n" + "\n".join(rows) + "\n"


@pytest.fixture(scope="module")
def loaded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A job whose first test has a column Abw, and a test after loading with a column Fehler."""
    folder = tmp_path_factory.mktemp("profile")
    (folder / "x.csv").write_text(table("Abw", 0.05, 1))
    (folder / "after.csv").write_text(table("Fehler", 0.0, 2))
    (folder / "before.yaml").write_text(PROFILE.format(value="Abw"))
    (folder / "after.yaml").write_text(PROFILE.format(value="Fehler"))
    (folder / "job.yaml").write_text(JOB)
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder


def verify(folder: Path, *words: str) -> int:
    after = str(folder / "after.csv")
    return compwright(["verify", str(folder / "job.yaml"), "--after", after, *words])


def test_the_profile_of_the_test_after_loading(loaded: Path, tmp_path: Path) -> None:
    folder = tmp_path / "all"
    shutil.copytree(loaded, folder)
    back = str(folder / "back")
    shutil.copytree(folder / "job" / "tables" / "linuxcnc", back)
    words = ["--profile", str(folder / "after.yaml"), "--loaded", back, "--update"]
    assert verify(folder, *words) in (0, 1)
    found = json.loads((folder / "job" / "verification.json").read_text())["axes"]["X"]
    assert found["loading"]["verdict"] == "loaded"
    assert found["after"]["A"] < 5.0
    record = json.loads((folder / "job" / "record.json").read_text())
    assert [entry["by"] for entry in record["inputs"] if entry["role"] == "profile"] == [
        "run",
        "verify",
    ]


def test_why_the_profile_of_the_job_does_not_fit(
    loaded: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert verify(loaded) == 3
    said = capsys.readouterr().err
    assert "Abw" in said
    assert "Fehler" in said
    assert "--profile P.yaml" in said
