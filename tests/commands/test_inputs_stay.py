"""With --force too: what a command has read stays as it is, under whatever name, and so does what
an earlier run did not write.
"""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.foundations import storage
from compwright.foundations.errors import StorageError
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from dying import Process, running
from loop import Machine, csv_of
from next_steps import without_hint

pytestmark = pytest.mark.short_estimate

CONTROL = "siemens-840d-sl"
JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: AX1, before: [x.csv]}
"""
MACHINE = """\
virtual_machine: 1
machine: {name: Virtual, serial: "1"}
axes:
  X: {travel: [0, 500], error: {slope_um_per_m: 20, noise_um: 0.5}, test: {targets: 6, runs: 3}}
"""


def tree(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A measurement, a job, its results, the control's own files, and a test taken with them after
    the machine has changed.
    """
    folder = tmp_path_factory.mktemp("made")
    machine = Machine()
    targets = machine.targets()
    (folder / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (folder / "job.yaml").write_text(JOB)
    (folder / "machine.yaml").write_text(MACHINE)
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    control = folder / "control"
    shutil.copytree(folder / "job" / "tables" / CONTROL, control)
    files = [ControlFile(path.name, path.read_bytes()) for path in sorted(control.iterdir())]
    judge = virtual_control(CONTROL, files, reference_return={"AX1": Direction.POSITIVE})
    readings = Machine(bow=0.02).measure(
        targets, 2, lambda x, sign: judge.correction("AX1", x, Direction("+" if sign > 0 else "-"))
    )
    (folder / "after.csv").write_text(csv_of(targets, readings))
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(made, tmp_path / "hall")
    monkeypatch.chdir(tmp_path / "hall")
    return tmp_path / "hall"


def refused(folder: Path, capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """Run a command that must write nothing, and return what it says."""
    before = tree(folder)
    capsys.readouterr()
    assert compwright([*words, "--force"]) == 5
    assert tree(folder) == before
    return capsys.readouterr().err


VERIFIED = "r/verification.html"
READ = {
    "evaluate, json": (["evaluate", "x.csv", "--json", "x.csv"], "x.csv"),
    "evaluate, plot": (["evaluate", "x.csv", "--plot", "x.svg"], "x.svg"),
    "evaluate, folder": (["evaluate", "tests", "--json", "tests/x.csv"], "tests/x.csv"),
    "run, job": (["run", "job.yaml", "--json", "job.yaml"], "job.yaml"),
    "run, measurement": (["run", "job.yaml", "--json", "x.csv"], "x.csv"),
    "new": (
        ["new", "--from", "control", "--format", CONTROL, "--out", "control/AX1_MD.INI"],
        "control/AX1_MD.INI",
    ),
    "decode": (
        ["decode", "control", "--format", CONTROL, "--json", "control/AX1_MD.INI"],
        "control/AX1_MD.INI",
    ),
    "compare, plan": (
        ["compare", "job/plan.json", "--loaded", "control", "--json", "job/plan.json"],
        "job/plan.json",
    ),
    "compare, loaded": (
        ["compare", "job", "--loaded", "control", "--json", "control/AX1_EEC.INI"],
        "control/AX1_EEC.INI",
    ),
    "verify, plan": (
        ["verify", "job.yaml", "--after", "after.csv", "--json", "job/plan.json"],
        "job/plan.json",
    ),
    "verify, after": (
        ["verify", "job.yaml", "--after", "after.csv", "--json", "after.csv"],
        "after.csv",
    ),
    "verify, loaded": (
        [
            "verify",
            "job.yaml",
            "--after",
            "after.csv",
            "--loaded",
            "control",
            "--json",
            "control/AX1_MD.INI",
        ],
        "control/AX1_MD.INI",
    ),
    "export, state": (
        [
            "export",
            "job/plan.json",
            "--format",
            CONTROL,
            "--state",
            "control",
            "--option",
            "cec_sign=correction",
            "--out",
            "control",
        ],
        "control/AX1_EEC.INI",
    ),
    "simulate": (["simulate", "before/x.csv", "--out", "before"], "before/x.csv"),
    "run, report": (["run", "job.yaml", "--out", "o"], "o/report.html"),
    "run, record": (["run", "job.yaml", "--out", "p"], "p/record.json"),
    "run, table": (["run", "second.yaml", "--out", "q"], f"q/tables/{CONTROL}/AX1_EEC.INI"),
    "verify, page": (["verify", "job.yaml", "--after", "after.csv", "--out", "r"], VERIFIED),
    "profile": (["profile", "foreign.csv", "--out", "p.yaml"], "p.yaml"),
    "diff": (
        ["diff", "control", "--with", "old", "--format", CONTROL, "--json", "d.json"],
        "d.json",
    ),
    "history": (["history", "job", "--json", "job/record.json"], "job/record.json"),
}
#: Links that stand where a command writes, to what it reads: hard ones and symbolic ones.
LINKS: dict[str, tuple[str, Callable[[Path, Path], None]]] = {
    "o/report.html": ("x.csv", os.symlink),
    "p/record.json": ("job.yaml", os.link),
    f"q/tables/{CONTROL}/AX1_EEC.INI": ("control/AX1_EEC.INI", os.symlink),
    VERIFIED: ("after.csv", os.link),
    "p.yaml": ("foreign.csv", os.link),
    "d.json": ("old/AX1_MD.INI", os.symlink),
}


@pytest.mark.parametrize("case", READ)
def test_what_was_read_is_not_overwritten(
    case: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words, name = READ[case]
    (folder / "tests").mkdir()
    (folder / "before").mkdir()
    shutil.copy("x.csv", "tests/x.csv")
    shutil.copy("x.csv", "x.svg")
    shutil.copy("machine.yaml", "before/x.csv")  # a machine file with the name of a measurement
    (folder / "second.yaml").write_text(
        JOB.replace("none", "[control]").replace("x.csv", "after.csv")
    )
    (folder / "foreign.csv").write_text("Soll;Ist\n1,0;1,1\n2,0;2,1\n")
    shutil.copytree("control", "old")
    if name in LINKS:
        to, link = LINKS[name]
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        link(folder / to, folder / name)
    if case == "evaluate, plot":
        words = ["evaluate", "x.svg", "--plot", "x.svg"]
    if case == "export, state":  # another table than the one that is there
        text = (folder / "control" / "AX1_EEC.INI").read_text()
        (folder / "control" / "AX1_EEC.INI").write_text(text.replace("=0.00", "=-0.00"))
    assert f"{name}: the file is an input of this command and is not overwritten" in refused(
        folder, capsys, *words
    )


OTHER_NAMES: dict[str, Callable[[Path], str]] = {
    "symbolic link": lambda folder: _link(os.symlink, folder),
    "hard link": lambda folder: _link(os.link, folder),
    "whole path": lambda folder: str(folder / "x.csv"),
    "way around": lambda _folder: "job/../x.csv",
}


def _link(make: Callable[[Path, Path], None], folder: Path) -> str:
    make(folder / "x.csv", folder / "link.json")
    return "link.json"


@pytest.mark.parametrize("name", OTHER_NAMES)
def test_what_was_read_is_not_overwritten_under_another_name(
    name: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = OTHER_NAMES[name](folder)
    answer = refused(folder, capsys, "evaluate", "x.csv", "--json", other)
    assert "is an input of this command" in answer
    assert "`--force` to replace it" not in answer


def test_an_earlier_answer_is_replaced_where_it_is_named(folder: Path) -> None:
    Path("old.json").write_text("old")
    assert compwright(["evaluate", "x.csv", "--json", "old.json", "--force"]) == 0
    assert compwright(["evaluate", "after.csv", "--json", "old.json", "--force"]) == 0
    assert (
        (folder / "old.json").read_bytes().startswith(b'{\n  "schema": "compwright/evaluation/1"')
    )


@pytest.mark.parametrize(
    "words",
    [
        ["evaluate", "."],
        ["decode", "control", "--format", CONTROL],
        ["compare", "job/plan.json", "--loaded", "control"],
        ["diff", "control", "--with", "control", "--format", CONTROL],
        ["history", "."],
        ["formats", "list"],
    ],
    ids=lambda words: words[0],
)
def test_a_command_that_answers_only_changes_nothing_on_the_disk(
    folder: Path, words: list[str]
) -> None:
    """No call that changes a disk is even tried: a medium may be read only."""
    process = Process()
    with running(process):
        assert compwright(words) in (0, 1, 3)
    assert process.made == []


def test_a_medium_that_is_read_only_is_verified_from(folder: Path) -> None:
    """What is read lies where nothing can be made, what is written goes elsewhere."""
    elsewhere = folder.parent / "elsewhere"
    words = ["verify", "job.yaml", "--after", "after.csv", "--loaded", "control"]
    real = os.open

    def refusing(path: Any, flags: int, *arguments: Any, **more: Any) -> int:
        changes = flags & (os.O_CREAT | os.O_WRONLY | os.O_RDWR)
        if changes and folder in Path(path).resolve().parents:
            raise OSError(errno.EROFS, os.strerror(errno.EROFS), str(path))
        return real(path, flags, *arguments, **more)

    before = tree(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "open", refusing)
        assert compwright([*words, "--out", str(elsewhere)]) == 1
        assert compwright(words) == 5
    assert (elsewhere / "verification.json").is_file()
    assert tree(folder) == before


def test_a_command_remembers_only_its_own_inputs(folder: Path) -> None:
    assert compwright(["evaluate", "x.csv", "--json", "one.json"]) == 0
    assert compwright(["decode", "control", "--format", CONTROL, "--json", "two.json"]) == 0
    assert compwright(["evaluate", "x.csv", "--json", "one.json", "--force"]) == 0


@pytest.mark.skipif(os.name == "nt", reason="links need rights")
def test_nothing_is_removed_behind_a_link_that_leads_out(tmp_path: Path) -> None:
    """A set of files that was linked to the control's own: equal bytes do not make them results."""
    (tmp_path / "control").mkdir()
    (tmp_path / "control" / "A.INI").write_bytes(b"mine")
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "set").symlink_to(tmp_path / "control", target_is_directory=True)
    out, new = tmp_path / "out", {"b.txt": b"new"}
    with pytest.raises(StorageError, match=r"A\.INI: .*; this file is not one of them"):
        storage.write_files(Session(), out, new, force=True, whole=["set"])
    storage.write_files(Session(), out, new, force=True, renewed=["set"])
    assert (tmp_path / "control" / "A.INI").read_bytes() == b"mine"


def test_the_notes_of_the_user_stay(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "job" / "card" / "notes.txt").write_text("mine")
    (folder / "job" / "notes.txt").write_text("mine")
    assert compwright(["run", "job.yaml", "--force"]) == 0
    assert (folder / "job" / "card" / "notes.txt").read_text() == "mine"
    assert (folder / "job" / "notes.txt").read_text() == "mine"
    for place in ("tables", "rollback"):
        notes = folder / "job" / place / CONTROL / "notes.txt"
        notes.parent.mkdir(parents=True, exist_ok=True)
        notes.write_text("mine")
    said = refused(folder, capsys, "run", "job.yaml")
    for place in ("tables", "rollback"):
        assert (
            f"{place}/{CONTROL}/notes.txt: this folder may contain only the files of this command"
            in said
        )
        assert "move it to another folder" in said


def test_results_that_the_user_changed_stay(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A card that was filled in, a table that was corrected by hand."""
    names = ("card/card.md", f"tables/{CONTROL}/AX1_EEC.INI", "report.html", "evaluation.json")
    for name in names:
        path = folder / "job" / name
        path.write_bytes(path.read_bytes() + b"mine")
    said = refused(folder, capsys, "run", "job.yaml")
    for name in names:
        assert f"{name}: the file was not written by an earlier run, or was changed since" in said


def test_what_an_earlier_run_wrote_and_this_one_does_not_is_removed(folder: Path) -> None:
    (folder / "job.yaml").write_text(JOB.replace("AX1", "AX2"))
    assert compwright(["run", "job.yaml", "--force"]) == 0
    assert {path.name for path in (folder / "job" / "tables" / CONTROL).iterdir()} == {
        "AX2_EEC.INI",
        "AX2_MD.INI",
    }


def test_the_control_s_own_files_are_not_replaced_by_export(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The plan carries the files of the control, so that export does not read them from their
    folder again.
    """
    (folder / "job.yaml").write_text(JOB.replace("none", "[control]").replace("x.csv", "after.csv"))
    assert compwright(["run", "job.yaml", "--out", "second"]) in {0, 1}
    text = (folder / "second" / "plan.json").read_text()
    assert compwright(["export", "second/plan.json", "--format", CONTROL, "--out", "new"]) == 0
    if tree(folder / "new") != tree(folder / "control"):
        assert "was not written by an earlier run" in refused(
            folder, capsys, "export", "second/plan.json", "--format", CONTROL, "--out", "control"
        )
    assert '"results"' in text
    words = ["export", "second/plan.json", "--format", CONTROL, "--out", "new"]
    assert compwright([*words, "--force"]) == 0
    assert compwright(["decode", "new", "--format", CONTROL]) == 0
    table = folder / "new" / "AX1_EEC.INI"
    table.write_bytes(table.read_bytes() + b"; by hand\n")
    assert "AX1_EEC.INI: the file was not written by an earlier run, or was changed" in refused(
        folder, capsys, *words
    )


def test_simulate_replaces_its_own_files_and_no_real_ones(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright(["simulate", "machine.yaml", "--out", "virtual"]) == 0
    assert (
        compwright(["simulate", "machine.yaml", "--out", "virtual", "--seed", "2", "--force"]) == 0
    )
    said = refused(folder, capsys, "simulate", "machine.yaml", "--out", ".")
    assert "x.csv: the file was not written by an earlier run" in said
    edited = folder / "virtual" / "x.csv"
    edited.write_bytes(edited.read_bytes() + b"# looked at\n")
    said = refused(folder, capsys, "simulate", "machine.yaml", "--out", "virtual")
    assert "x.csv: the file was not written by an earlier run, or was changed since" in said
    assert compwright(["evaluate", "virtual"]) == 0  # the list is no measurement


def test_the_demo_leaves_a_job_of_the_user_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "job.yaml").write_text(JOB)
    assert "job.yaml: the file was not written by an earlier run" in refused(
        tmp_path, capsys, "demo", "--out", str(tmp_path)
    )


@pytest.mark.parametrize("name", ["plan.json", "evaluation.json", "../job/plan.json"])
def test_one_name_for_two_results_is_refused(
    name: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said = refused(folder, capsys, "run", "job.yaml", "--json", f"job/{name}")
    assert "two different output files would get this name" in said


def test_existing_files_are_one_line(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert compwright(["run", "job.yaml"]) == 5
    (line,) = [line for line in capsys.readouterr().err.splitlines() if line.startswith("error")]
    assert without_hint(line) == (
        "error: job: 11 of the files to write exist already in this folder; found evaluation.json, prediction.json, plan.json,"
        " tables/siemens-840d-sl/AX1_EEC.INI and 7 more"
    )
