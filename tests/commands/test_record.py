"""The record of a result folder: what went in, what came out, what was decided; the folder can be
handed over alone.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from places import PROJECT

pytestmark = pytest.mark.short_estimate

EXAMPLE = PROJECT / "examples" / "fanuc-backup"
OPTIONS = "tables/fanuc-30i"


def sha(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def record_of(folder: Path) -> dict[str, Any]:
    record = json.loads((folder / "record.json").read_text(encoding="utf-8"))
    assert isinstance(record, dict)
    return record


def verified(folder: Path, *words: str) -> int:
    """Verify the job in ``folder`` after simulating the test with its tables loaded."""
    tables = folder / "job" / OPTIONS
    machine = ["simulate", str(folder / "machine.yaml"), "--seed", "2"]
    after = folder / "after"
    assert compwright([*machine, "--out", str(after), "--with-tables", str(tables)]) == 0
    return compwright(["verify", str(folder / "job.yaml"), "--after", str(after / "x.csv"), *words])


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which a job with files of the control has been run."""
    folder = tmp_path_factory.mktemp("run") / "job"
    shutil.copytree(EXAMPLE, folder)
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder


@pytest.fixture(scope="module")
def done(run: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same, verified with what was read back."""
    folder = tmp_path_factory.mktemp("done") / "job"
    shutil.copytree(run, folder)
    shutil.copytree(folder / "job" / OPTIONS, folder / "read back")
    assert verified(folder, "--loaded", str(folder / "read back")) == 0
    return folder


def test_every_input_lies_in_the_folder_once_byte_for_byte(run: Path) -> None:
    record = record_of(run / "job")
    assert record["schema"] == "compwright/record/1"
    assert [(entry["role"], entry["file"]) for entry in record["inputs"]] == [
        ("job", "job.yaml"),
        ("test", "before/x.csv"),
        ("state", "control/CNC-PARA.TXT"),
        ("state", "control/PITCH.TXT"),
    ]
    for entry in record["inputs"]:
        original, copy = run / entry["file"], run / "job" / entry["copy"]
        assert original.read_bytes() == copy.read_bytes()
        assert (entry["sha256"], entry["size"]) == (sha(original), original.stat().st_size)
    copies = [path for path in (run / "job" / "inputs").rglob("*") if path.is_file()]
    # what was in the control lies in rollback/ already
    assert sorted(path.name for path in copies) == ["job.yaml", "x.csv"]


def test_every_file_is_listed_with_its_hash(run: Path) -> None:
    out = run / "job"
    record = record_of(out)
    found = {
        path.relative_to(out).as_posix(): sha(path)
        for path in out.rglob("*")
        if path.is_file() and path.name != "record.json"
    }
    assert {entry["file"]: entry["sha256"] for entry in record["files"]} == found
    assert record["plan"] == {"file": "plan.json", "sha256": found["plan.json"]}


@pytest.mark.parametrize(
    ("key", "value"), [("date", "2019-01-01"), ("instrument", "XL-80"), ("s", 0.01), ("", "")]
)
def test_a_record_that_was_edited_is_named(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], key: str, value: object
) -> None:
    """By `history`, after `run` and after `verify`; a record that was only saved again is not."""
    folder = tmp_path / "job"
    shutil.copytree(done / "job", folder)
    record = record_of(folder)
    if key:
        record["tests"][1][key] = value
    (folder / "record.json").write_text(json.dumps(record, indent=1), encoding="utf-8")
    assert compwright(["history", str(folder), "--json", "-"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["folders"]
    assert ["record.json was changed" in note for note in found["notes"]] == [True] * bool(key)
    assert found["files"] == []


def test_only_a_new_run_makes_an_edited_record_a_true_one(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Another verification keeps the edited tests before loading, so that it stays named; a new run
    leaves no verification that may be edited too.
    """
    folder = tmp_path / "job"
    shutil.copytree(done, folder)
    record = record_of(folder / "job")
    date = record["tests"][0]["date"]
    record["tests"][0]["date"] = "2019-01-01"
    (folder / "job" / "record.json").write_text(json.dumps(record), encoding="utf-8")

    def notes() -> list[str]:
        capsys.readouterr()
        assert compwright(["history", str(folder / "job"), "--json", "-"]) == 0
        (found,) = json.loads(capsys.readouterr().out)["folders"]
        return [note for note in found["notes"] if "was changed" in note]

    words = [str(folder / "job.yaml"), "--after", str(folder / "after" / "x.csv"), "--force"]
    assert compwright(["verify", *words]) == 0
    assert len(notes()) == 1
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 0
    assert notes() == []
    assert [(test["taken"], test["date"]) for test in record_of(folder / "job")["tests"]] == [
        ("before", date)
    ]
    assert compwright(["verify", *words]) == 0
    assert notes() == []


def test_the_record_of_a_run_says_with_what_and_what_was_decided(run: Path) -> None:
    record = record_of(run / "job")
    assert record["machine"]["serial"] == "SIM-3"
    assert record["definition"]["id"] == record["format"] == "fanuc-30i"
    assert record["definition"]["files"] == ["fanuc-30i.yaml", "fanuc.base.yaml"]
    assert record["options"]["detection_unit"] == 0.001
    accept = record["decisions"]["axes"]["X"]["accept"]
    assert {name: entry["decision"] for name, entry in accept.items()} == {
        "A": "accept",
        "B": "accept",
    }
    assert record["verification"] is None


def test_parameters_of_a_test_are_those_of_its_readings(run: Path) -> None:
    """Means, reversal and the pooled scatter by hand from the rows of the file."""
    rows = [
        line.split(",")
        for line in (run / "before" / "x.csv").read_text(encoding="utf-8").splitlines()
        if not line.startswith(("#", "target"))
    ]
    cells: dict[tuple[str, str], list[float]] = {}
    for target, direction, _, deviation in rows:
        cells.setdefault((target, direction), []).append(float(deviation))
    (test,) = record_of(run / "job")["tests"]
    variances = [np.var(readings, ddof=1) for readings in cells.values()]
    assert test["s"] == pytest.approx(np.sqrt(np.mean(variances)), abs=1e-6)
    # at most as sure as normal readings alike everywhere would be
    dof = sum(len(readings) - 1 for readings in cells.values())
    assert 4 <= test["std_error"]["s"]["dof"] <= dof
    reversal = [
        np.mean(cells[target, "+"]) - np.mean(cells[target, "-"])
        for target in {target for target, _ in cells}
    ]
    assert test["parameters"]["B_mean"] == pytest.approx(np.mean(reversal), abs=1e-6)
    targets = sorted({float(target) for target, _ in cells})
    both: dict[float, list[float]] = {target: [] for target in targets}
    for (target, _), readings in cells.items():
        both[float(target)].append(float(np.mean(readings)))
    slope = np.polyfit(targets, [np.mean(both[target]) for target in targets], 1)[0]
    assert test["parameters"]["slope"] == pytest.approx(1000.0 * slope, rel=1e-6)  # µm/mm: µm/m
    assert (test["date"], test["measured_in"]) == ("", "as_found")


def test_verify_completes_the_record_in_place(done: Path) -> None:
    out = done / "job"
    record = record_of(out)
    verification = record["verification"]
    assert verification["verdict"] == "good"
    axis = verification["axes"]["X"]
    assert axis["loading"]["verdict"] == "loaded"
    assert axis["read_back"] == "equal"
    assert axis["after"]["A"] < 8 < axis["before"]["A"]
    assert [test["taken"] for test in record["tests"]] == ["before", "after"]
    given = {entry["role"]: entry for entry in record["inputs"] if entry["by"] == "verify"}
    assert given["after"]["copy"] == "inputs/verify/x.csv"
    # what was read back is what was written: no second copy
    assert given["loaded"]["copy"].startswith(f"{OPTIONS}/")
    listed = {entry["file"]: entry["sha256"] for entry in record["files"]}
    assert {"verification.json", "plan.json", "inputs/verify/x.csv"} <= listed.keys()
    assert all(sha(out / name) == digest for name, digest in listed.items())


def test_verified_again_the_record_holds_the_last_verification_only(
    done: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(done, folder)
    other = folder / "other.csv"
    shutil.copy(folder / "after" / "x.csv", other)
    words = ["verify", str(folder / "job.yaml"), "--after", str(other)]
    assert compwright(words) == 5  # what is there is the user's to keep
    assert compwright([*words, "--force"]) == 0
    record = record_of(folder / "job")
    after = [entry["copy"] for entry in record["inputs"] if entry["by"] == "verify"]
    assert after == ["inputs/verify/other.csv"]
    assert not (folder / "job" / "inputs" / "verify" / "x.csv").exists()
    assert record["verification"]["axes"]["X"]["read_back"] == "none"


def test_a_folder_handed_over_alone_can_be_verified(run: Path, tmp_path: Path) -> None:
    """The job's copy, the plan and the test after loading are all that it takes."""
    folder = tmp_path / "elsewhere"
    shutil.copytree(run / "job", folder)
    shutil.copytree(EXAMPLE, tmp_path / "machine")
    after = tmp_path / "after"
    machine = ["simulate", str(tmp_path / "machine" / "machine.yaml"), "--seed", "2"]
    assert compwright([*machine, "--out", str(after), "--with-tables", str(folder / OPTIONS)]) == 0
    words = ["verify", str(folder / "inputs" / "job.yaml"), "--plan", str(folder)]
    words += ["--after", str(after / "x.csv")]
    assert compwright(words) == 0  # into the folder itself
    assert record_of(folder)["verification"]["verdict"] == "good"
    # with the results in another folder the record there claims no file of the first
    assert compwright([*words, "--out", str(tmp_path / "third")]) == 0
    third = record_of(tmp_path / "third")
    assert [entry["copy"] for entry in third["inputs"]] == [*[None] * 4, "inputs/verify/x.csv"]
    assert {entry["file"] for entry in third["files"]} == {
        *("inputs/verify/x.csv", "verification.json", "verification.html"),
    }


def test_a_run_again_renews_the_copies(run: Path, tmp_path: Path) -> None:
    folder = tmp_path / "job"
    shutil.copytree(run, folder)
    text = (folder / "job.yaml").read_text(encoding="utf-8")
    (folder / "before" / "x.csv").rename(folder / "before" / "first.csv")
    changed = text.replace("before/x.csv", "before/first.csv")
    (folder / "job.yaml").write_text(changed, encoding="utf-8")
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 0
    copies = folder / "job" / "inputs" / "before"
    assert [path.name for path in copies.iterdir()] == ["first.csv"]
    assert (folder / "job" / "inputs" / "job.yaml").read_text(encoding="utf-8") == changed


def test_a_copy_that_the_user_has_edited_is_not_overwritten(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(run, folder)
    edited = folder / "job" / "inputs" / "job.yaml"
    edited.write_text("my notes", encoding="utf-8")
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 5
    assert "inputs/job.yaml" in capsys.readouterr().err.replace("\\", "/")
    assert edited.read_text(encoding="utf-8") == "my notes"


def without_tests(text: str) -> str:
    record = json.loads(text)
    del record["tests"]
    return json.dumps(record)


@pytest.mark.parametrize("damage", [lambda _: "of my own", without_tests])
def test_a_file_that_is_no_record_is_not_overwritten_by_verify(
    run: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    damage: Callable[[str], str],
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(run, folder)
    file = folder / "job" / "record.json"
    text = damage(file.read_text(encoding="utf-8"))
    file.write_text(text, encoding="utf-8")
    assert verified(folder) == 5
    assert "record.json" in capsys.readouterr().err
    assert file.read_text(encoding="utf-8") == text
    assert not (folder / "job" / "verification.json").exists()


def test_a_run_without_a_record_is_verified_with_what_its_plan_says(
    run: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(run, folder)
    (folder / "job" / "record.json").unlink()
    assert verified(folder) == 0
    record = record_of(folder / "job")
    assert record["machine"]["serial"] == "SIM-3"
    assert [test["taken"] for test in record["tests"]] == ["before", "after"]


def test_without_a_state_the_record_says_that_no_table_is_written(
    run: Path, tmp_path: Path
) -> None:
    """And a second run still knows the copies of the first, although there is no plan."""
    folder = tmp_path / "job"
    shutil.copytree(EXAMPLE, folder)
    lines = (folder / "job.yaml").read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if "states" not in line and "as_found" not in line]
    job = folder / "job.yaml"
    job.write_text("\n".join(kept), encoding="utf-8")
    assert compwright(["run", str(job)]) == 2
    record = record_of(folder / "job")
    assert record["plan"] is None
    assert record["decisions"]["axes"]["X"]["table"] == "none"
    job.write_text("\n".join(["# once more", *kept]), encoding="utf-8")
    assert compwright(["run", str(job), "--force"]) == 2
    assert record_of(folder / "job")["inputs"][0]["sha256"] == sha(job)


def test_files_of_one_name_from_outside_the_job_are_kept_apart(run: Path, tmp_path: Path) -> None:
    folder = tmp_path / "job"
    shutil.copytree(EXAMPLE, folder)
    rows = (folder / "before" / "x.csv").read_text(encoding="utf-8").splitlines()
    first = [line for line in rows if not line.endswith(",") and ",5," not in line]
    head = [line for line in rows if line.startswith(("#", "target"))]
    for name, lines in (("a", first), ("b", [*head, *(line for line in rows if ",5," in line)])):
        (tmp_path / name).mkdir()
        (tmp_path / name / "x.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    text = (folder / "job.yaml").read_text(encoding="utf-8")
    both = "before: [{files: [../a/x.csv, ../b/x.csv], name: x}]"
    (folder / "job.yaml").write_text(text.replace("before: [before/x.csv]", both), encoding="utf-8")
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    given = {entry["file"]: entry for entry in record_of(folder / "job")["inputs"]}
    copies = [given[f"../{name}/x.csv"]["copy"] for name in ("a", "b")]
    assert copies == ["inputs/elsewhere/x.csv", "inputs/elsewhere/x-2.csv"]
    assert [sha(folder / "job" / copy) for copy in copies] == [
        sha(tmp_path / name / "x.csv") for name in ("a", "b")
    ]


def test_a_verified_run_made_again_keeps_its_verification(done: Path, tmp_path: Path) -> None:
    folder = tmp_path / "job"
    shutil.copytree(done, folder)
    before = record_of(folder / "job")
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 0
    record = record_of(folder / "job")
    for key in ("verification", "tests"):
        assert record[key] == before[key]
    assert [each["copy"] for each in record["inputs"]] == [
        each["copy"] for each in before["inputs"]
    ]
    assert {entry["file"] for entry in record["files"]} == {
        entry["file"] for entry in before["files"]
    }
    assert all(sha(folder / "job" / each["file"]) == each["sha256"] for each in record["files"])


def test_no_verdict_stays_beside_another_plan(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A page that says good of a table which is not the one that lies there."""
    folder = tmp_path / "job"
    shutil.copytree(done, folder)
    out = folder / "job"
    (out / "next").mkdir()
    text = (folder / "job.yaml").read_text(encoding="utf-8")
    (folder / "job.yaml").write_text(text.replace("A: 8", "A: 9"), encoding="utf-8")
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 0
    told = capsys.readouterr().err
    assert "was of another plan, and is removed" in told
    assert "do not load anything of it" in told
    left = {path.name for path in out.iterdir()}
    assert not {"verification.json", "verification.html"} & left
    assert record_of(out)["verification"] is None
    measured = out / "inputs" / "verify" / "x.csv"  # perhaps the only copy
    assert measured.read_bytes() == (folder / "after" / "x.csv").read_bytes()
    words = ["verify", str(folder / "job.yaml"), "--after", str(measured)]
    assert compwright([*words, "--force"]) == 0
    assert record_of(out)["verification"]["verdict"] == "good"


def test_a_next_round_of_an_earlier_verification_is_told(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(done, folder)
    (folder / "job" / "next").mkdir()
    words = ["verify", str(folder / "job.yaml"), "--after", str(folder / "after" / "x.csv")]
    assert compwright([*words, "--force"]) == 0
    assert "do not load anything of it" in capsys.readouterr().err
