"""What files state of compensation, next to the state of the job: a contradiction is a doubt, and
nothing is decided.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from compwright.foundations.findings import DOUBTS
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states:
  as_found: none
  old: [old.ini]
axes:
  X: {travel: [0, 800], address: AX1, before: [{files: [FILES], name: x, measured_in: STATE}], accept: {A: 500}}
MORE"""
OLD = (
    "CHANDATA(1)\n$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=3\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n"
    "$MA_BACKLASH[0,AX1]=0.002\nM17\n"
)


def run(
    folder: Path, texts: list[str], state: str = "as_found", more: str = ""
) -> tuple[int, dict[str, object]]:
    machine = Machine()
    targets = machine.targets()
    names = []
    for number, text in enumerate(texts, 1):
        names.append(f"x{number}.csv")
        readings = csv_of(targets, machine.measure(targets, number))
        (folder / names[-1]).write_text(text + readings)
    (folder / "old.ini").write_text(OLD)
    job = JOB.replace("FILES", ", ".join(names)).replace("STATE", state).replace("MORE", more)
    (folder / "job.yaml").write_text(job)
    code = compwright(["run", str(folder / "job.yaml"), "--force"])
    prediction = json.loads((folder / "job" / "prediction.json").read_text(encoding="utf-8"))
    return code, prediction


def doubts(prediction: dict[str, object], code: str = "CW-P162") -> list[str]:
    found = prediction["doubts"]
    assert isinstance(found, list)
    return [entry["message"] for entry in found if entry["code"] == code]


def test_it_is_a_doubt_and_the_difference_of_files_is_none() -> None:
    assert "CW-P162" in DOUBTS
    assert "CW-P163" not in DOUBTS


@pytest.mark.real_pages
def test_on_in_the_file_and_nothing_in_the_state(tmp_path: Path) -> None:
    code, prediction = run(tmp_path, ["# compensation: on\n"])
    (message,) = doubts(prediction)
    assert "compensation was on" in message
    assert "as_found" in message
    axes = prediction["axes"]
    assert isinstance(axes, dict)
    assert axes["X"]["accept"]["A"]["decision"] == "undecided"
    assert code == 1
    for page in ("report.html", "card/card.md"):
        assert "compensation was on" in (tmp_path / "job" / page).read_text(encoding="utf-8")


def test_acknowledged_it_decides(tmp_path: Path) -> None:
    more = "acknowledged: {CW-P162: thermal compensation was on and nothing else}\n"
    code, prediction = run(tmp_path, ["# compensation: on\n"], more=more)
    assert (code, doubts(prediction)) == (0, [])


@pytest.mark.parametrize("text", ["", "# compensation: off\n", "# compensation: see the log\n"])
def test_no_doubt_without_a_contradiction(tmp_path: Path, text: str) -> None:
    code, prediction = run(tmp_path, [text])
    assert (code, doubts(prediction)) == (0, [])


@pytest.mark.parametrize(
    ("job", "files", "other"),
    [
        ("7", ["8"], "number 8, but this machine has 7."),
        ("", ["7", "8"], "number 8, but this machine has 7."),
        ("SN-7", ["sn 7"], ""),
        ("not given", ["8"], ""),
        ("7", ["redacted_1"], ""),
    ],
)
def test_a_file_of_another_machine_is_a_doubt(
    tmp_path: Path, job: str, files: list[str], other: str
) -> None:
    texts = [f"# serial: {serial}\n" for serial in files]
    code, prediction = run(tmp_path, texts, more=f'machine: {{serial: "{job}"}}\n' if job else "")
    found = doubts(prediction, "CW-P171")
    assert (code, [other in message for message in found]) == ((1, [True]) if other else (0, []))
    if other:
        more = "acknowledged: {CW-P171: the number was typed wrong}\n"
        code, _ = run(
            tmp_path, texts, more=more + (f'machine: {{serial: "{job}"}}\n' if job else "")
        )
        assert code == 0


def test_off_in_the_file_and_an_active_backlash_in_the_state(tmp_path: Path) -> None:
    _, prediction = run(tmp_path, ["# compensation: off\n"], state="old")
    (message,) = doubts(prediction)
    assert "compensation was off" in message
    assert "old" in message
    _, prediction = run(tmp_path, ["# compensation: on\n"], state="old")
    assert doubts(prediction) == []


@pytest.mark.real_pages
def test_files_of_one_test_that_differ_are_named(tmp_path: Path) -> None:
    texts = [
        "# compensation: off\n# operator: Ada\n# serial: 7\n",
        "# compensation: on\n# operator: Bob\n# serial: 7\n",
    ]
    _, prediction = run(tmp_path, texts)
    (message,) = doubts(prediction)
    assert "both on and off" in message
    evaluation = json.loads((tmp_path / "job" / "evaluation.json").read_text(encoding="utf-8"))
    (result,) = evaluation["results"]
    assert result["header"]["operator"] == "Ada\nBob"
    assert result["header"]["serial"] == "7"
    axes = prediction["axes"]
    assert isinstance(axes, dict)
    (named,) = [one["message"] for one in axes["X"]["findings"] if one["code"] == "CW-P163"]
    assert "operator: Ada / Bob" in named
    assert "serial" not in named
    page = (tmp_path / "job" / "report.html").read_text(encoding="utf-8")
    assert "Ada; Bob" in page
