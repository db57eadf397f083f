"""The public library: docs/tutorials/library.md played in a copy of its example, and calls side by side."""

from __future__ import annotations

import doctest
import json
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import compwright as cw
from compwright.cli import run
from places import PROJECT

PAGE = PROJECT / "docs" / "tutorials" / "library.md"
EXAMPLE = PROJECT / "examples" / "linuxcnc-two-axes"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the example with the results of its job."""
    copy = tmp_path_factory.mktemp("library") / "machine"
    shutil.copytree(EXAMPLE, copy)
    assert run(["run", str(copy / "job.yaml"), "--out", str(copy / "by-command")]) == 0
    return copy


@pytest.mark.real_figures
def test_page_is_what_a_reader_gets(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas")
    shutil.copytree(EXAMPLE, tmp_path / "machine")
    monkeypatch.chdir(tmp_path / "machine")
    text = PAGE.read_text(encoding="utf-8")
    names: dict[str, object] = {}
    examples = 0
    for kind, body in re.findall(
        r"^```(python|console)\n(.*?)^```", text, re.DOTALL | re.MULTILINE
    ):
        if kind == "console":
            assert [run(line[2:].split()[1:]) for line in body.splitlines()] == [0]
            continue
        part = doctest.DocTestParser().get_doctest(body, names, PAGE.name, str(PAGE), 0)
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS, verbose=False)
        report: list[str] = []
        failed, tried = runner.run(part, out=report.append, clear_globs=False)
        assert failed == 0, "".join(report)
        names |= part.globs
        examples += tried
    assert examples > 15
    for name in cw.__all__:
        assert f"cw.{name}" in text, f"docs/tutorials/library.md shows no example of {name}"


@pytest.mark.real_figures
def test_notebook_runs_from_top_to_bottom(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "machine")
    monkeypatch.chdir(tmp_path / "machine")
    monkeypatch.setenv("MPLBACKEND", "agg")
    notebook = json.loads(Path("from_python.ipynb").read_text(encoding="utf-8"))
    names: dict[str, Any] = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), names)  # noqa: S102 - our own notebook
    assert [test["A"] for test in names["after"]] == pytest.approx([9.67, 14.3], abs=0.5)


def test_plan_is_that_of_the_command(folder: Path) -> None:
    plan = cw.plan(folder / "job.yaml")
    there = folder / "by-command"
    assert plan.to_dict() == json.loads((there / "prediction.json").read_text("utf-8"))
    assert plan.tables == {
        file.name: file.read_bytes() for file in (there / "tables" / "linuxcnc").iterdir()
    }
    assert not (folder / "job").exists()
    with pytest.raises(cw.StorageError):
        plan.write(there)


def test_correction_and_error_cancel(folder: Path) -> None:
    """Physics: what the control adds is minus the estimated error, up to the datum."""
    where = np.linspace(50.0, 1150.0, 23)
    error = cw.estimate(
        [
            test
            for test in cw.read(folder / "before" / "x.csv")
            if isinstance(test, cw.PositioningTest)
        ]
    )
    correction = cw.decode(folder / "by-command" / "tables" / "linuxcnc", "linuxcnc")["0"]
    left = np.concatenate(
        [
            error.mean(where, "+") + correction(where, "+"),
            error.mean(where, "-") + correction(where, "-"),
        ]
    )
    assert np.ptp(left) < 3.0 < np.ptp(error.mean(where, "+"))


def test_reversed_instrument_swaps_approaches_and_sign(folder: Path) -> None:
    (test,) = cw.read(folder / "before" / "x.csv")
    assert isinstance(test, cw.PositioningTest)
    plain, turned = cw.estimate(test), cw.estimate(test, sense=-1, offset=1200.0)
    assert turned.mean(1200.0 - 300.0, "-") == pytest.approx(-plain.mean(300.0, "+"), abs=0.2)


def test_two_threads_do_not_disturb_each_other(folder: Path) -> None:
    alone = cw.plan(folder / "job.yaml").to_dict()
    with ThreadPoolExecutor(2) as pool:
        both = list(pool.map(lambda _: cw.plan(folder / "job.yaml").to_dict(), range(2)))
    assert both == [alone, alone]


def test_wrong_input_is_one_error_with_every_fault(tmp_path: Path) -> None:
    with pytest.raises(cw.UsageError, match="axes"):
        cw.estimate(cw.simulate(EXAMPLE / "machine.yaml"))  # type: ignore[arg-type]
    with pytest.raises(cw.UsageError, match="more than one test"):
        cw.evaluate(EXAMPLE / "before")
    (tmp_path / "one.csv").write_text("a,b\n1,2\n")
    (tmp_path / "two.csv").write_text("c\n3\n")
    with pytest.raises(cw.InputError) as error:
        cw.read(tmp_path)
    assert {Path(fault.file).name for fault in error.value.faults} == {"one.csv", "two.csv"}


def test_import_loads_nothing() -> None:
    asked = "import sys, compwright; print('numpy' in sys.modules, len(dir(compwright)) > 12)"
    found = subprocess.run(
        [sys.executable, "-c", asked], capture_output=True, text=True, check=True
    )
    assert found.stdout.split() == ["False", "True"]
