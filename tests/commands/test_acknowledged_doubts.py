"""A doubt about a measurement or the state of a control leaves nothing decided, in run and verify,
until the job acknowledges it. Readings from a machine with known errors.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_house import codes

from compwright.cli import run as compwright
from compwright.foundations.findings import DOUBTS, REMARKS, RESULTS, Finding
from compwright.planning.doubts import ScopedFinding, find_doubts
from compwright.records.job import Acknowledgement
from compwright.words.sentences import say
from loop import Machine, csv_of
from places import PROJECT

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(high=1200.0)
TARGETS = MACHINE.targets(count=25)
READINGS = MACHINE.measure(TARGETS, 1)
TURNED = {sign: -block for sign, block in READINGS.items()}  # lost motion above zero: CW-T032
LIMITS = ", accept: {A: 20, B: 40}"


def job(folder: Path, end: str = "", *, limits: str = LIMITS, state: str = "none") -> Path:
    path = folder / "job.yaml"
    path.write_text(
        f"compwright: 1\ncontroller: {{format: siemens-840d-sl}}\nstates: {{as_found: {state}}}\n"
        f"axes:\n  X: {{travel: [0, 1200], address: AX1, before: [x.csv]{limits}}}\n{end}"
    )
    return path


def run(folder: Path, end: str = "", *, limits: str = LIMITS) -> tuple[int, Any]:
    code = compwright(["run", str(job(folder, end, limits=limits)), "--force"])
    path = folder / "job" / "prediction.json"
    return code, json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def decisions(document: Any) -> set[str]:
    return {entry["decision"] for entry in document["axes"]["X"]["accept"].values()}


# ---------------------------------------------------------------- every code is classified


def test_every_code_is_a_doubt_a_result_or_a_remark_as_its_page_says() -> None:
    assert sorted([*DOUBTS, *RESULTS, *REMARKS]) == sorted(codes())
    page = (PROJECT / "docs" / "findings.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `(CW-[A-Z]+\d+)` \| [^|]* \| (\w+) \|", page, re.MULTILINE))
    assert rows == {
        **dict.fromkeys(DOUBTS, "yes"),
        **dict.fromkeys(RESULTS, "first"),
        **dict.fromkeys(REMARKS, "no"),
    }


# ---------------------------------------------------------------- run


@pytest.mark.real_pages
def test_a_turned_sign_leaves_limits_undecided_until_it_is_acknowledged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, TURNED))
    code, document = run(tmp_path)
    assert (code, decisions(document)) == (1, {"undecided"})
    assert [one["code"] for one in document["doubts"]] == ["CW-T032"]
    assert document["acknowledged"] == []
    reason = "the backlash value in the drive is too large"
    code, document = run(tmp_path, f"acknowledged: {{CW-T032: {{axis: X, reason: {reason}}}}}\n")
    assert (code, decisions(document), document["doubts"]) == (0, {"accept"}, [])
    assert [(one["code"], one["reason"]) for one in document["acknowledged"]] == [
        ("CW-T032", reason)
    ]
    assert reason in " ".join(capsys.readouterr().out.split())
    for page in ("report.html", "card/card.html", "card/card.md"):
        assert reason in (tmp_path / "job" / page).read_text(), page


@pytest.mark.real_pages
def test_a_file_that_lost_rows_is_undecided_without_any_limit(tmp_path: Path) -> None:
    """Every second row is gone: each target is left with some of its ten readings."""
    lines = csv_of(TARGETS, READINGS).splitlines(keepends=True)
    head = next(n for n, line in enumerate(lines) if line.startswith("target"))
    rows = lines[head + 1 :]
    kept = sorted(np.random.default_rng(4).choice(len(rows), len(rows) // 2, replace=False))
    (tmp_path / "x.csv").write_text("".join([*lines[: head + 1], *(rows[n] for n in kept)]))
    code, document = run(tmp_path, limits="")
    assert code == 1
    assert "CW-R053" in {one["code"] for one in document["doubts"]}
    page = (tmp_path / "job" / "report.html").read_text()
    assert 'class="verdict open"' in page


def test_a_few_lost_readings_are_no_cut_file(tmp_path: Path) -> None:
    readings = {sign: block.copy() for sign, block in READINGS.items()}
    readings[1][3, 2] = readings[-1][17, 0] = np.nan
    text = "".join(
        line
        for line in csv_of(TARGETS, readings).splitlines(keepends=True)
        if "nan" not in line.lower()
    )
    (tmp_path / "x.csv").write_text(text)
    code, document = run(tmp_path)
    assert (code, document["doubts"]) == (0, [])


@pytest.mark.real_pages
def test_an_acknowledgement_that_nothing_needs_is_reported(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, READINGS))
    path = job(tmp_path, "acknowledged: {CW-T031: coarse display}\n")
    assert compwright(["run", str(path), "--json", str(tmp_path / "p.json")]) == 0
    assert "CW-J021" in (tmp_path / "job" / "report.html").read_text()


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("{CW-T320: no}", "CW-T032"),
        ("{T032: no}", "CW-T032"),
        ("{CW-E014: no}", "doubt"),
        ("{CW-V036: no}", "keeps the verdict open and cannot be acknowledged"),
        ("{CW-T032: {axis: XX, reason: no}}", "'X', the nearest known name"),
        ("{CW-T032: {axis: X}}", "reason"),
        ("{CW-T032: ''}", "blank"),
    ],
)
def test_what_cannot_be_acknowledged_is_a_fault_of_the_job(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], given: str, expected: str
) -> None:
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, READINGS))
    assert compwright(["run", str(job(tmp_path, f"acknowledged: {given}\n"))]) == 2
    error = capsys.readouterr().err
    assert "acknowledged" in error
    assert expected in error


def test_an_acknowledgement_of_one_axis_leaves_the_others_in_doubt() -> None:
    of = Acknowledgement(code="CW-S002", reason="whole", axis="X")
    both = ScopedFinding(
        Finding("CW-S002", "warning", say("as_written", text="both")), frozenset({"X", "Y"})
    )
    every = ScopedFinding(Finding("CW-S002", "warning", say("as_written", text="all")))
    info = ScopedFinding(Finding("CW-T007", "info", say("as_written", text="part of the travel")))
    axes = ("X", "Y")
    found = find_doubts([both, every, info], [of], axes)
    assert [one.axes for one in found.open] == [frozenset({"Y"}), frozenset({"Y"})]
    assert [one.by for one in found.acknowledged] == [of, of]
    assert not found.about("X")
    assert found.about("Y")
    other = Acknowledgement(code="CW-S002", reason="also", axis="Y")
    found = find_doubts([both, every], [of, other], axes)
    assert (found.open, found.unused) == ((), ())
    general = Acknowledgement(code="CW-S002", reason="whole")
    assert find_doubts([both, every], [general], axes).open == ()
    assert find_doubts([both], [of, of], axes).unused == ()
    assert find_doubts([], [of], axes).unused == (of,)


def test_the_only_axis_of_a_job_answers_a_doubt_about_all() -> None:
    every = ScopedFinding(Finding("CW-S002", "warning", say("as_written", text="all")))
    of = Acknowledgement(code="CW-S002", reason="whole", axis="X")
    assert find_doubts([every], [of], ["X"]).open == ()
    assert find_doubts([every], [], ["X"]).open == (every,)
