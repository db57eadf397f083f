"""A file of the wrong kind: one line that says what it is and what was expected, in every command
that takes a file; and a folder of control files, found where they are.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

JOB = """\
compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X: {travel: [0, 400], address: "0", before: [x.csv]}
"""
DOCUMENTS = ("plan", "prediction", "evaluation", "record")
#: What each kind of file is called in the message.
WORDS = {
    "job": "is a job file",
    "plan": "is a plan",
    "prediction": "is prediction.json",
    "evaluation": "is evaluation.json",
    "record": "is record.json",
    "measurement": "is a measurement file",
    "machine": "is a virtual machine",
    "profile": "is a mapping profile",
    "definition": "is a definition",
    "page": "is a page",
}
#: Commands by the kind that they take at ``@``, with the exit code for another kind.
COMMANDS = (
    ("job", 2, "run @"),
    ("job", 2, "verify @ --after x.csv"),
    ("plan", 3, "compare @ --loaded job/tables/linuxcnc"),
    ("plan", 3, "export @ --format linuxcnc --out out"),
    ("plan", 3, "verify job.yaml --after x.csv --plan @"),
    ("measurement", 3, "evaluate @"),
    ("measurement", 3, "run @ --format linuxcnc --axis X --travel 0:400 --state none"),
    ("measurement", 3, "profile @ --out out.yaml"),
    ("control", 3, "decode @ --format linuxcnc"),
    ("control", 3, "new --from @ --format linuxcnc --out out.yaml"),
    ("control", 3, "compare job/plan.json --loaded @"),
    ("control", 3, "diff @ --with job/tables/linuxcnc --format linuxcnc"),
    ("profile", 2, "evaluate x.csv --profile @"),
    ("machine", 2, "simulate @ --out out"),
    ("definition", 2, "formats show ./@"),
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A job with its results, and one file of each kind, named by its kind."""
    place = tmp_path_factory.mktemp("kinds")
    rows = [
        f"{target},{sign},{run},{0.01 * target + 0.4 * run + (3 if sign == '-' else 0):.2f}"
        for target in range(0, 401, 40)
        for sign in "+-"
        for run in (1, 2, 3)
    ]
    (place / "x.csv").write_text(
        "# axis: X\ntarget_mm,direction,run,deviation_um\n" + "\n".join(rows) + "\n"
    )
    (place / "job.yaml").write_text(JOB)
    assert compwright(["run", str(place / "job.yaml")]) in (0, 1)
    for name in DOCUMENTS:
        shutil.copy(place / "job" / f"{name}.json", place / f"{name}.yaml")
    shutil.copy(place / "x.csv", place / "measurement.yaml")
    (place / "machine.yaml").write_text("# of a demo\nvirtual_machine: 1\naxes: {}\n")
    (place / "profile.yaml").write_text("compwright_profile: 1\nlayout: own\n")
    (place / "definition.yaml").write_text("compwright_format: 2\nid: mine\n")
    (place / "page.yaml").write_text("<!doctype html>\n<html></html>\n")
    return place


@pytest.mark.parametrize(("wanted", "code", "command"), COMMANDS)
def test_another_kind_of_file_is_one_line(
    folder: Path,
    wanted: str,
    code: int,
    command: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(folder)
    for kind, words in WORDS.items():
        if kind == wanted:
            continue
        given = [word.replace("@", f"{kind}.yaml") for word in command.split()]
        if wanted == "measurement" and command.startswith("run"):
            shutil.copy(f"{kind}.yaml", f"{kind}.txt")
            given = [word.replace(".yaml", ".txt") for word in given]
        capsys.readouterr()
        found = compwright(given)
        said = capsys.readouterr().err.strip().splitlines()
        assert (found, len(said)) == (code, 1), (given, said)
        assert words in said[0]
        assert ". Next: give " in said[0]


def test_a_folder_of_results_is_one_line_with_the_way_on(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(folder)
    for command, code, words in (
        ("run job", 2, "JOB.yaml"),
        ("verify job --after x.csv", 3, "JOB.yaml"),
        ("decode job --format linuxcnc", 3, str(Path("job/tables/linuxcnc"))),
        ("compare job/plan.json --loaded job", 3, str(Path("job/tables/linuxcnc"))),
        ("simulate job --out out", 3, "machine.yaml"),
    ):
        capsys.readouterr()
        found = compwright(command.split())
        said = capsys.readouterr().err.strip().splitlines()
        assert (found, len(said)) == (code, 1), (command, said)
        assert words in said[0]


def test_files_one_folder_deeper_are_found(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``job/tables`` holds one folder, and that the files."""
    shutil.copytree(folder / "job" / "tables", tmp_path / "back" / "disk")
    plan = str(folder / "job" / "plan.json")
    assert compwright(["compare", plan, "--loaded", str(tmp_path / "back")]) == 0
    state = tmp_path / "job.yaml"
    state.write_text(JOB.replace("as_found: none", f"as_found: [{tmp_path / 'back'}]"))
    shutil.copy(folder / "x.csv", tmp_path)
    capsys.readouterr()
    assert compwright(["run", str(state), "--json", "-", "--force"]) in (0, 1)
    record = json.loads((tmp_path / "job" / "record.json").read_text())
    assert any(entry["role"] == "state" for entry in record["inputs"])


def test_several_folders_of_files_are_listed(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("monday", "friday"):
        shutil.copytree(folder / "job" / "tables" / "linuxcnc", tmp_path / name)
    command = ["decode", str(tmp_path), "--format", "linuxcnc"]
    assert compwright(command) == 3
    said = capsys.readouterr().err
    assert str(tmp_path / "monday") in said
    assert str(tmp_path / "friday") in said
    (tmp_path / "empty").mkdir()
    assert compwright(["decode", str(tmp_path / "empty"), "--format", "linuxcnc"]) == 3
    assert "contains no files" in capsys.readouterr().err
