"""``profile``, ``--profile`` and ``profile:`` in a job, from the outside."""

from __future__ import annotations

import json
from pathlib import Path

import openpyxl
import pytest

from compwright.cli import run as compwright
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.workflow.commands.evaluate import evaluate_files
from compwright.workflow.inputs.job_inputs import read_measurement
from loop import Machine

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()


def german_sheet(path: Path) -> Path:
    """A machine's test as a German spreadsheet saves it: cp1252, semicolons, decimal commas,
    CRLF.
    """
    targets = MACHINE.targets()
    readings = MACHINE.measure(targets, 1)
    lines = ["Messprotokoll Fräse;;;", "Soll [mm];Richtung;Lauf;Abweichung Ist - Soll [µm]"]
    for sign, word in ((1, "aufwärts"), (-1, "abwärts")):
        block = readings[sign]
        for row, target in enumerate(targets):
            for run in range(block.shape[1]):
                value = block[row, run] * 1000.0
                cells = (f"{target:.3f}", word, str(run + 1), f"{value:.4f}")
                lines.append(";".join(cells).replace(".", ","))
    path.write_bytes(("\r\n".join([*lines, "Mittelwert;;;0,5", ""])).encode("cp1252"))
    return path


@pytest.fixture
def sheet(tmp_path: Path) -> Path:
    folder = tmp_path / "Prüfung 1"
    folder.mkdir()
    return german_sheet(folder / "X Achse.csv")


def test_from_a_german_spreadsheet_to_results(
    sheet: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    profile = sheet.with_name("p.yaml")
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 0
    said = capsys.readouterr()
    assert said.out.count("the axis") == 3
    assert "sign: measured minus target, the header says so" in said.err
    assert "fill in" not in said.err
    arguments = ["evaluate", str(sheet), "--profile", str(profile), "--json", "-"]
    assert compwright(arguments) == 0
    (result,) = json.loads(capsys.readouterr().out)["results"]
    assert result["n_runs"] == {"positive": 5, "negative": 5}
    codes = {finding["code"] for finding in result["findings"]}
    assert {"CW-R059", "CW-R060"} <= codes
    assert "p.yaml" in result["header"]["profile"]
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 5


def test_without_a_profile_the_way_is_said(sheet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sheet.write_bytes(sheet.read_bytes().decode("cp1252").encode())
    assert compwright(["evaluate", str(sheet)]) == 3
    assert f"compwright profile '{sheet}' --out" in capsys.readouterr().err


def test_an_open_key_is_refused(sheet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sheet.write_bytes(sheet.read_bytes().replace(b" Ist - Soll", b""))
    profile = sheet.with_name("p.yaml")
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 0
    assert "fill in: sign" in capsys.readouterr().err
    assert compwright(["evaluate", str(sheet), "--profile", str(profile)]) == 2
    said = capsys.readouterr().err
    assert "p.yaml" in said
    assert "'sign' is empty and must be filled in" in said


def job_of(sheet: Path, extra: str = "") -> Path:
    job = sheet.with_name("job.yaml")
    job.write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\naxes:\n"
        f"  X: {{travel: [0, 800], address: AX1, before: [{{files: [{sheet.name}], name: x,"
        f" profile: p.yaml{extra}}}]}}\n",
        encoding="utf-8",
    )
    return job


def test_a_job_and_its_verification(sheet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    profile = sheet.with_name("p.yaml")
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 0
    job = job_of(sheet)
    assert compwright(["run", str(job)]) == 0, capsys.readouterr().err
    prediction = json.loads((job.with_suffix("") / "prediction.json").read_text())
    assert prediction["axes"]["X"]["before"]["A"] > 1.0
    # the test after loading comes from the same program, and is read by the same profile
    assert compwright(["verify", str(job), "--after", f"x={sheet}"]) in {0, 1}


def test_positions_are_mapped_once(sheet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    profile = sheet.with_name("p.yaml")
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 0
    text = profile.read_text(encoding="utf-8")
    profile.write_text(text.replace("offset: 0.0", "offset: 5.0"), encoding="utf-8")
    assert compwright(["run", str(job_of(sheet, ", position_map: {offset: 5}"))]) == 2
    assert "mapped twice" in capsys.readouterr().err


def test_run_with_files_takes_a_profile(sheet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    profile = sheet.with_name("p.yaml")
    assert compwright(["profile", str(sheet), "--out", str(profile)]) == 0
    words = ["--format", "siemens-840d-sl", "--axis", "X", "--travel", "0:800"]
    words += ["--option", "address=AX1", "--state", "none", "--profile", str(profile)]
    assert compwright(["run", str(sheet), *words]) == 0, capsys.readouterr().err
    said = compwright(["run", str(job_of(sheet)), "--profile", str(profile)])
    assert said == 2


def test_a_workbook_of_several_axes(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    for name in ("X", "Y"):
        sheet = book.create_sheet(name)
        sheet.append(["target_mm", "direction", "run", "deviation_um"])
        for row in ((0, "+", 1, 1.0), (100, "+", 1, 2.0 if name == "X" else 3.0)):
            sheet.append(list(row))
    path = tmp_path / "both.xlsx"
    book.save(path)
    assert [one["axis"] for one in evaluate_files(Session(), [path]).document["results"]] == [
        "X",
        "Y",
    ]
    assert read_measurement(Session(), path, axis="y").positive[1, 0] == pytest.approx(0.003)
    with pytest.raises(InputError, match=r"contains 2 tests, none of them of axis Z.*found X, Y"):
        read_measurement(Session(), path, axis="Z")
