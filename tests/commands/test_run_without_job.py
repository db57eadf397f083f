"""``run FILE...`` leaves the job that it assumed: complete, ready to edit and to run again with the
same bytes.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from pathlib import Path

import pytest
import yaml
from test_inputs_stay import tree

from compwright.cli import run as compwright
from compwright.foundations import storage
from compwright.jobs.assumed_job import assumed_job, assumed_of
from compwright.jobs.command_line import StatedJob, job_from_options
from compwright.jobs.reading import read_job
from compwright.records.correction import Assumption
from laser_files import laser_file
from loop import Floats, Machine

pytestmark = pytest.mark.short_estimate

FILE = "Messungen Süd/X Achse vorher.rtl"
WORDS = ["--format", "siemens-840d-sl", "--axis", "X", "--travel", "0:800", "--state", "none"]
WORDS += ["--option", "address=AX1"]
OUT = "Ergebnis für X"


def rtl(targets: Floats, readings: Mapping[int, Floats]) -> str:
    """A file of the laser's software: CRLF, runs counted by traverse, deviations in µm."""
    deviations = {
        (2 * run + (1 if sign > 0 else 2), target + 1): f"{1000 * block[target, run]:.2f}"
        for sign, block in readings.items()
        for run in range(block.shape[1])
        for target in range(block.shape[0])
    }
    names = [f"{target:.3f}" for target in targets]
    return laser_file(names, dict(sorted(deviations.items())), machine="Fräsmaschine Süd, 3 µ")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A hall with a measurement, and the results of a run without a job file."""
    hall = tmp_path_factory.mktemp("Halle 3 ä")
    machine = Machine()
    targets = machine.targets()
    (hall / FILE).parent.mkdir()
    (hall / FILE).write_bytes(rtl(targets, machine.measure(targets, 1)).encode("cp1252"))
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(hall)
        assert compwright(["run", FILE, *WORDS, "--out", OUT]) == 0
    return hall


@pytest.fixture
def hall(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(made, tmp_path / "hall")
    monkeypatch.chdir(tmp_path / "hall")
    return tmp_path / "hall"


def test_the_job_names_the_measurement_from_where_it_lies(made: Path) -> None:
    data = yaml.safe_load((made / OUT / "job.yaml").read_bytes())
    (test,) = data["axes"]["X"]["before"]
    assert test["files"] == [f"../{FILE}"]
    assert data["axes"]["X"]["travel"] == [0, 800]
    assert data["states"] == {"as_found": "none"}
    assert (data["controller"]["format"], data["axes"]["X"]["address"]) == (WORDS[1], "AX1")


@pytest.mark.usefixtures("afresh")
def test_the_job_gives_the_same_bytes_again(hall: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = tree(hall)
    job = f"{OUT}/job.yaml"
    assert compwright(["run", job]) == 5
    assert "exist already" in capsys.readouterr().err
    assert compwright(["run", job, "--force"]) == 0
    assert tree(hall) == before
    # and what was assumed is known as the tool's own until somebody edits it
    other = [*WORDS, "screw_pitch=10"]
    assert compwright(["run", FILE, *other, "--out", OUT, "--force"]) == 0
    text = (hall / job).read_text()
    assert "screw_pitch: 10 " in text
    (hall / job).write_text(text.replace("kind: linear", "kind:  linear"))
    edited = tree(hall)
    assert compwright(["run", FILE, *WORDS, "--out", OUT, "--force"]) == 5
    assert (
        "job.yaml: the file was not written by an earlier run, or was changed"
        in capsys.readouterr().err
    )
    assert tree(hall) == edited
    assert compwright(["run", job, "--force"]) == 0
    assert compwright(["run", FILE, *WORDS, "--out", OUT, "--force"]) == 5
    assert (hall / job).read_text() == edited[job].decode()


def test_a_job_of_the_user_s_own_is_not_replaced(
    hall: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (hall / "other").mkdir()
    (hall / "other" / "job.yaml").write_text("compwright: 1\n")
    assert compwright(["run", FILE, *WORDS, "--out", "other", "--force"]) == 5
    assert "other/job.yaml: the file was not written by an earlier run" in capsys.readouterr().err
    assert tree(hall / "other") == {"job.yaml": b"compwright: 1\n"}


@pytest.mark.skipif(os.name == "nt", reason="names there are always text")
def test_a_name_that_is_no_text_leaves_no_job(
    hall: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = os.fsdecode(b"x\xff.rtl")
    shutil.copy(hall / FILE, hall / name)
    assert compwright(["run", name, *WORDS, "--out", "odd"]) == 0
    note = "job.yaml is not written: a file name is not valid UTF-8: ../x\\udcff.rtl; rename"
    assert note in capsys.readouterr().err
    assert not (hall / "odd" / "job.yaml").exists()
    assert (hall / "odd" / "plan.json").is_file()


def test_without_a_state_the_job_is_left_too(
    hall: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [word for word in WORDS if word not in ("--state", "none")]
    assert compwright(["run", FILE, *words, "--out", "open"]) == 2
    assert "add --state none" in capsys.readouterr().err
    before = tree(hall)
    assert compwright(["run", "open/job.yaml", "--force"]) == 2
    assert tree(hall) == before
    again = ["run", FILE, *words, "--out", "open"]
    assert compwright(again) == 2, "an evaluation alone is replaced without --force"
    assert compwright([*again, "--state", "none"]) in (0, 1)
    assert (hall / "open" / "plan.json").is_file()
    assert compwright(again) == 5, "tables are replaced with --force only"


def stated(**words: object) -> StatedJob:
    given: dict[str, object] = {
        "format": "fanuc-30i",
        "axis": "Y",
        "travel": "-850:0",
        "states": ["none"],
        "options": [],
    }
    return job_from_options(["../a b.csv"], **{**given, **words})  # type: ignore[arg-type]


SETTLED = {"detection_unit": 0.001, "cards": ["a", "b"]}
LEFT = (
    Assumption("option detection_unit", "0.001", "default of the definition"),
    Assumption("option cards", "a, b", "default of the definition"),
    Assumption("axis Y: number of points", "as many as are needed", "nobody says it"),
)


@pytest.mark.parametrize(
    "words",
    [
        {},
        {"states": []},
        {"states": ["../back up/A.TXT", "../B.TXT"]},
        {"states": ["A.TXT"], "options": ["active=yes"]},
        {"options": ["kind=rotary", "reference=-0.5", "reference_return=-", "k=v"]},
        {"options": ["encoder_system=2", "screw_pitch=10,4.5", "spacing=10", "mode=single"]},
        {"profile": "../Süd/p.yaml", "axis": "no"},
    ],
)
def test_the_job_says_what_its_command_line_said(words: dict[str, object]) -> None:
    """Read back it is the same job, also where every line that is held back is taken in."""
    said = stated(**words)
    text = assumed_job(said.data, SETTLED, LEFT, {})
    assert read_job(text.encode(), "") == said.job
    held_back = ("#   options:", *(f"#     {name}:" for name in SETTLED))
    whole = [
        line.removeprefix("# ") if line.startswith(held_back) else line
        for line in text.splitlines()
    ]
    assert read_job("\n".join(whole).encode(), "").options == {**said.job.options, **SETTLED}


def test_every_value_says_where_it_comes_from() -> None:
    said = stated(options=["reference=5"])
    lines = assumed_job(said.data, SETTLED, LEFT, {}).splitlines()
    values = [line for line in lines if line.split("#")[0].partition(":")[2].strip()]
    sources = {line.split(":")[0].strip(" -"): line.rpartition("  # ")[2] for line in values}
    del sources["compwright"]
    assert all(sources.values())
    assert sources["reference"] == "--option reference"
    assert sources["kind"].startswith("assumed: ")
    listed = {entry.fact for entry in assumed_of(said.data, {})}
    assert {"axis Y: kind", "axis Y: reference_return", "test: motion", "standard"} <= listed
    assert "axis Y: reference" not in listed


def test_way_from_one_folder_to_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Through links too: what the name says must hold where the job will lie."""
    (tmp_path / "far" / "away").mkdir(parents=True)
    (tmp_path / "x.csv").write_text("x")
    (tmp_path / "out").symlink_to(tmp_path / "far" / "away", target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    named = storage.way_to(Path("x.csv"), Path("out"))
    assert named == "../../x.csv"
    found = storage.named_from(Path("out"), named)
    assert found.samefile("x.csv")
    assert storage.named_from(Path("new/folder"), "../../x.csv") == Path("x.csv")
    assert storage.named_from(Path("far/away"), "../../x.csv") == Path("x.csv")

    def other_drive(*_: object) -> str:
        raise ValueError("path is on mount 'D:', start on mount 'C:'")

    monkeypatch.setattr(os.path, "relpath", other_drive)
    assert storage.way_to(Path("x.csv"), Path("out")) == (tmp_path / "x.csv").as_posix()


def test_an_axis_that_no_file_names_is_asked_for_by_its_number(
    hall: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A control that counts its axes, and nothing in it yet: nothing says which of them X is."""
    del hall
    words = ["run", FILE, "--format", "fanuc-30i", "--axis", "X", "--travel", "0:800"]
    assert compwright([*words, "--state", "none", "--out", "elsewhere"]) == 2
    said = capsys.readouterr().err
    assert "fanuc-30i needs the number of axis X" in said
    assert "no file of the control" not in said
