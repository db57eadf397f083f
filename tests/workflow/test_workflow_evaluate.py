"""``evaluate`` from files to exit code, and what stands at the terminal."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from compwright.foundations.errors import StorageError, UsageError
from compwright.foundations.session import Session
from compwright.workflow.commands.evaluate import (
    evaluate_files,
    evaluation_renderables,
    write_evaluation,
)
from compwright.workflow.results.answers import to_json
from next_steps import without_hint
from places import PROJECT

pytestmark = pytest.mark.real_pages

GOOD = "# axis: X\n# machine: VMC 850\ntarget_mm,direction,run,deviation_um\n"


def csv_file(folder: Path, name: str, scale: float = 1.0, directions: str = "+-") -> Path:
    """A slope, 2 µm more in − at every target, five readings whose scatter is 1.3 times as large in
    −.
    """
    scatter = (0.3, -0.8, 0.6, -0.2, 0.1)
    rows = []
    for x in (3.0, 110.5, 190.0, 310.0, 402.0):
        for d in directions:
            lost, factor = (2.0, 1.3) if d == "-" else (0.0, 1.0)
            for run, off in enumerate(scatter, start=1):
                rows.append(
                    f"{x},{d},{run},{scale * (x / 100 + lost + factor * off * (1 + x / 400)):.3f}\n"
                )
    path = folder / name
    path.write_text(GOOD + "".join(rows), encoding="utf-8")
    return path


def test_files_and_standards(tmp_path: Path) -> None:
    paths = [csv_file(tmp_path, "a.csv"), csv_file(tmp_path, "b.csv", 2.0)]
    run = evaluate_files(Session(), paths, ["vdi3441", "iso230-4:1996"])  # one per kind of test
    assert run.exit_code == 0
    found = [(r["name"], r["standard"]) for r in run.document["results"]]
    assert found == [(n, "vdi3441") for n in "ab"]
    assert run.document["results"][0]["sources"][0]["file"] == str(paths[0])
    single = evaluate_files(Session(), paths[:1]).document["results"][0]
    assert single["standard"] == "iso230-2:2014"
    # 2 µm more in − at every target
    assert single["parameters"]["B"] == pytest.approx(
        2.0, abs=0.001
    )  # µm; the file holds steps of 0.001


def test_a_folder_is_read_whole_and_what_is_unreadable_is_listed(tmp_path: Path) -> None:
    good = csv_file(tmp_path, "b.csv")
    (tmp_path / "a.txt").write_text("shopping list\n", encoding="utf-8")
    (tmp_path / "c.csv").write_text(
        "target_mm,direction,run,deviation_um\n1,+,1,abc\n", encoding="utf-8"
    )
    (tmp_path / ".hidden").write_text("x", encoding="utf-8")
    (tmp_path / "inner").mkdir()
    run = evaluate_files(Session(), [tmp_path, good, tmp_path / "nowhere.csv"])
    assert run.exit_code == 3
    assert [r["name"] for r in run.document["results"]] == ["b"]  # once, though named twice
    files = [Path(error["file"]).name for error in run.document["errors"]]
    assert sorted(set(files)) == ["a.txt", "c.csv", "nowhere.csv"]
    assert all(error["message"] for error in run.document["errors"])
    json.loads(to_json(run.document))


def test_a_file_that_cannot_be_read_goes_before_a_test_that_the_method_does_not_fit(
    tmp_path: Path,
) -> None:
    """Exit 3 before 2: the range method of 1988 has no factor for 20 readings at a target."""
    many = tmp_path / "many.csv"
    rows = [
        f"{x},{d},{run},{run % 3 + x}\n" for x in (0, 50, 100) for d in "+-" for run in range(1, 21)
    ]
    many.write_text(GOOD + "".join(rows), encoding="utf-8")
    good = csv_file(tmp_path, "good.csv")
    (broken := tmp_path / "broken.csv").write_text("shopping list\n", encoding="utf-8")
    for paths, code in (([good], 0), ([many, good], 2), ([many, good, broken], 3)):
        assert evaluate_files(Session(), paths, ["iso230-2:1988"], "range").exit_code == code


def test_an_empty_folder_is_an_error(tmp_path: Path) -> None:
    run = evaluate_files(Session(), [tmp_path])
    assert run.exit_code == 3
    (error,) = run.document["errors"]
    assert error["file"] == str(tmp_path)
    assert without_hint(error["message"]) == "the folder contains no files"


def test_wrong_options_are_told_all_at_once(tmp_path: Path) -> None:
    path = csv_file(tmp_path, "a.csv")
    with pytest.raises(UsageError) as caught:
        evaluate_files(
            Session(), [path], ["iso230-4:2004", "iso230-2:1999", "vdi3441", "iso230-2:1988"]
        )
    assert len(caught.value.faults) == 3
    assert "found iso230-4:2004" in str(caught.value)
    assert "found iso230-2:1999" in str(caught.value)
    assert "expected one per kind of test, found vdi3441, iso230-2:1988" in str(caught.value)
    with pytest.raises(UsageError, match="range"):
        evaluate_files(Session(), [path], [], "range")
    with pytest.raises(UsageError, match="no measurement file"):
        evaluate_files(Session(), [])
    assert (
        evaluate_files(Session(), [path], ["iso230-2:1988"], "range").document["results"][0][
            "spread"
        ]
        == "range"
    )


def test_writing(tmp_path: Path) -> None:
    run = evaluate_files(Session(), [csv_file(tmp_path, "a.csv")])
    target = tmp_path / "out.json"
    assert write_evaluation(Session(), run.document, json_path=target) == [target]
    assert json.loads(target.read_text("utf-8")) == run.document
    with pytest.raises(StorageError, match="exists"):
        write_evaluation(Session(), run.document, json_path=target)
    first = target.read_bytes()
    write_evaluation(
        Session(),
        evaluate_files(Session(), [tmp_path / "a.csv"]).document,
        json_path=target,
        force=True,
    )
    assert target.read_bytes() == first


def several(folder: Path, standards: list[str]) -> dict[str, Any]:
    """The results to several standards in one document, as ``evaluate`` gives them one by one."""
    documents = [
        evaluate_files(Session(), [folder], [standard] if standard else []).document
        for standard in standards or [""]
    ]
    return {
        **documents[0],
        "results": [result for document in documents for result in document["results"]],
    }


def shown(folder: Path, standards: list[str], width: int, *, targets: bool = False) -> str:
    document = several(folder, standards)
    console = Console(width=width, record=True, file=None, force_terminal=False, color_system=None)
    with console.capture() as captured:
        for part in evaluation_renderables(document, targets=targets):
            console.print(part)
    return captured.get()


@pytest.mark.parametrize("width", [80, 120])
def test_terminal_shows_the_documents_numbers(tmp_path: Path, width: int) -> None:
    csv_file(tmp_path, "spindle.csv")
    text = shown(tmp_path, ["iso230-2:2014", "iso230-2:1988", "vdi3441"], width, targets=True)
    results = several(tmp_path, ["iso230-2:2014", "iso230-2:1988", "vdi3441"])["results"]
    assert all(len(line.rstrip()) <= width for line in text.splitlines())
    for title in ("ISO 230-2:2014 (2 s)", "ISO 230-2:1988 (3 s)", "VDI/DGQ 3441 (3 s)"):
        assert title in text
    assert "spindle.csv · axis X (linear)" in text
    assert "5 targets from 3 to 402 mm, 5 runs in each direction" in text
    for result in results:
        for value in result["parameters"].values():
            if value is not None:
                assert f"{abs(value):.2f}" in text
    for name, word in (("A", "Accuracy"), ("E", "Systematic deviation"), ("R", "Repeatability")):
        row = (
            next(line for line in text.splitlines() if line.startswith(word))
            .removeprefix(word)
            .split()
        )
        assert row[:4] == [
            name,
            *(
                f"{results[0]['parameters'][name + suffix]:.2f}"
                for suffix in ("", "_positive", "_negative")
            ),
        ]
    for finding in results[0]["findings"]:
        assert finding["code"] in text
    assert "…" not in text  # nothing cut off
    # what three standards share is told once
    assert sum(line.lstrip().startswith(("info", "warning")) for line in text.splitlines()) == len(
        results[0]["findings"]
    )


def test_terminal_shows_what_is_missing(tmp_path: Path) -> None:
    csv_file(tmp_path, "a.csv", directions="+")
    (tmp_path / "z.txt").write_text("nothing", encoding="utf-8")
    text = shown(tmp_path, [], 80)
    assert "not measured in the − direction" in text
    assert "Not evaluated" in text
    assert "z.txt" in "".join(text.split())  # a long path breaks at the end of a line


def test_hostile_text_is_shown_as_it_is(tmp_path: Path) -> None:
    path = csv_file(tmp_path, "a.csv")
    path.write_text(
        path.read_text("utf-8").replace("# axis: X", "# axis: [red]X[/]"), encoding="utf-8"
    )
    assert "axis [red]X[/] (linear)" in shown(tmp_path, [], 80)


def test_the_evaluate_path_loads_nothing_heavy(tmp_path: Path) -> None:
    path = csv_file(tmp_path, "a.csv")
    code = (
        "import sys; from pathlib import Path; from compwright.workflow.results.answers import"
        " to_json;from compwright.foundations.session import Session;"
        "from compwright.workflow.commands.evaluate import"
        f" evaluate_files;to_json(evaluate_files(Session(), [Path({str(path)!r})]).document);print([m"
        " for m in ('scipy', 'cvxpy', 'osqp', 'matplotlib', 'pydantic', 'rich', 'numpy.ma') if m in"
        " sys.modules])"
    )
    environment = {**os.environ, "PYTHONPATH": str(PROJECT / "src")}
    answer = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    )
    assert answer.stdout.strip() == "[]"
