"""Files of one control given with the format of another: one line that names the right format."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from format_samples import DEFINITIONS

EXAMPLES = Path(__file__).parents[2] / "examples"
#: Makers of which all series read the same statements; the two HEIDENHAIN forms differ.
ONE_FORM = ("fanuc", "siemens")


def _form(control: str) -> str:
    """The form of a control's files."""
    return next((maker for maker in ONE_FORM if control.startswith(maker)), control)


def _sets() -> dict[str, tuple[str, Mapping[str, bytes]]]:
    """The sample and each hand-worked set of files of each control, and those of the examples."""
    found: dict[str, tuple[str, Mapping[str, bytes]]] = {}
    for one in DEFINITIONS.values():
        sets = [("sample", one.sample_files), *((each.name, each.files) for each in one.expect)]
        for name, files in sets:
            texts = {file: text.encode("latin-1") for file, text in files.items()}
            found[f"{one.id}, {name}"] = one.id, texts
    for folder, control in (
        ("fanuc-backup", "fanuc-30i"),
        ("sinumerik-old-table", "siemens-840d-sl"),
    ):
        entries = (EXAMPLES / folder / "control").iterdir()
        found[folder] = control, {entry.name: entry.read_bytes() for entry in entries}
    return found


SETS = _sets()
#: One format of each form.
FORMATS = ("fanuc-30i", "siemens-840d-sl", *(name for name in DEFINITIONS if name == _form(name)))


def _written(files: Mapping[str, bytes], folder: Path) -> Path:
    folder.mkdir()
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder


@pytest.mark.parametrize("name", SETS)
def test_a_wrong_format_is_refused_with_the_right_one(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    right, files = SETS[name]
    folder = _written(files, tmp_path / "control")
    for wrong in FORMATS:
        if _form(wrong) == _form(right):
            continue
        out = tmp_path / "job.yaml"
        exit_code = compwright(["new", "--from", str(folder), "--format", wrong, "--out", str(out)])
        (line,) = capsys.readouterr().err.splitlines()
        assert exit_code == 3, line
        assert re.search(rf"of {re.escape(DEFINITIONS[right].maker)}, not of {wrong}\.", line)
        ids = re.findall(r"`--format ([^`]+)`", line.partition(". Next: give ")[2])
        assert right in ids, line
        assert {_form(one) for one in ids} == {_form(right)}, line
        assert not out.exists()


@pytest.mark.parametrize("name", SETS)
def test_a_right_format_is_never_taken_for_a_wrong_one(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    right, files = SETS[name]
    folder = _written(files, tmp_path / "control")
    compwright(["new", "--from", str(folder), "--format", right, "--out", str(tmp_path / "j.yaml")])
    assert ", not of " not in capsys.readouterr().err


@pytest.mark.parametrize("right", FORMATS)
def test_a_damaged_file_stays_a_file_of_its_control(
    right: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each file without its second half, and with a line that no control reads."""
    files = {
        name: text.encode("latin-1")[: max(60, len(text) // 2)] + b"\n??? damaged\n"
        for name, text in DEFINITIONS[right].sample_files.items()
    }
    folder = _written(files, tmp_path / "control")
    compwright(["new", "--from", str(folder), "--format", right, "--out", str(tmp_path / "j.yaml")])
    assert ", not of " not in capsys.readouterr().err


def test_the_job_that_names_a_wrong_format(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The next step names the key of the job, not an option of the command line."""
    job = (EXAMPLES / "sinumerik-old-table" / "job.yaml").read_text("utf-8")
    (tmp_path / "job.yaml").write_text(
        job.replace("siemens-840d-sl", "isg-kernel").replace("address: MA_Y", "address: 1"),
        encoding="utf-8",
    )
    for name in ("control", "before"):
        source = EXAMPLES / "sinumerik-old-table" / name
        _written({one.name: one.read_bytes() for one in source.iterdir()}, tmp_path / name)
    exit_code = compwright(["run", str(tmp_path / "job.yaml")])
    (line,) = capsys.readouterr().err.splitlines()
    assert exit_code == 3
    assert "of SINUMERIK (Siemens), not of isg-kernel. Next: write " in line
    assert "siemens-840d-sl" in line.partition("Next:")[2]
    assert "as `controller.format`, or give files of isg-kernel" in line


def test_redact_names_the_right_format_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = str(EXAMPLES / "fanuc-backup" / "control")
    out = tmp_path / "out"
    assert compwright(["redact", folder, "--format", "linuxcnc", "--out", str(out)]) == 3
    (line,) = capsys.readouterr().err.splitlines()
    assert "these are files of FANUC, not of linuxcnc. Next: give `--format fanuc-" in line
    assert not out.exists()
