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
from circle_machine import Machine, Setup, measured
from compwright.cli import run
from compwright.simulation.circular_files import to_circular_csv
from places import PROJECT, REAL, needs_shared

PAGE = PROJECT / "docs" / "tutorials" / "library.md"
EXAMPLE = PROJECT / "examples" / "linuxcnc-two-axes"

pytestmark = pytest.mark.short_estimate


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the example with the results of its job."""
    copy = tmp_path_factory.mktemp("library") / "machine"
    shutil.copytree(EXAMPLE, copy)
    assert run(["run", str(copy / "job.yaml"), "--out", str(copy / "by-command")]) == 0
    return copy


@pytest.mark.real_pages
@pytest.mark.full_estimate
def test_page_is_what_a_reader_gets(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas")
    shutil.copytree(EXAMPLE, tmp_path / "machine")
    monkeypatch.chdir(tmp_path / "machine")
    text = PAGE.read_text(encoding="utf-8")
    names: dict[str, object] = {}
    examples = 0
    for body in re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
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


@pytest.mark.real_pages
@pytest.mark.full_estimate
def test_notebook_runs_from_top_to_bottom(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "machine")
    monkeypatch.chdir(tmp_path / "machine")
    monkeypatch.setenv("MPLBACKEND", "agg")
    notebook = json.loads(Path("from_python.ipynb").read_text(encoding="utf-8"))
    names: dict[str, Any] = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), names)  # noqa: S102 - our own notebook
    after = [cw.evaluate(test) for test in names["after"]]
    assert [test["A"] for test in after] == pytest.approx([9.67, 14.3], abs=0.5)
    *_, last = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert eval(last["source"][-1], names).verdict == "good"  # noqa: S307 - our own notebook
    lines = [line for cell in notebook["cells"] if "outputs" in cell for line in cell["source"]]
    assert len(lines) == 15


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


def test_tests_in_memory_are_verified_as_their_files(folder: Path) -> None:
    results = folder / "by-command"
    tables = str(results / "tables" / "linuxcnc")
    machine, after = str(folder / "machine.yaml"), folder / "after"
    assert run(["simulate", machine, "--out", str(after), "--with-tables", tables]) == 0
    files = cw.verify(folder / "job.yaml", [after / "x.csv", after / "a.csv"], plan=results)
    rotary, linear = cw.read(after)
    memory = cw.verify(folder / "job.yaml", [linear, rotary], plan=results)
    assert memory.to_dict() == files.to_dict()
    with pytest.raises(cw.InputError, match="contradicts"):  # before and after are not one test
        cw.verify(folder / "job.yaml", [linear, folder / "before" / "x.csv"], plan=results)
    (old, *_) = cw.read(folder / "before" / "x.csv")
    assert "CW-V" in str(cw.verify(folder / "job.yaml", old, plan=results).to_dict())


def test_circles_in_memory_are_verified_as_their_files(tmp_path: Path) -> None:
    for seed, name in enumerate(("before", "after")):
        test = measured(Machine(squareness=30.0), Setup(noise=0.1), np.random.default_rng(seed))
        (tmp_path / f"{name}.csv").write_bytes(to_circular_csv(test))
    job = tmp_path / "job.yaml"
    job.write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\n"
        "axes:\n  X: {travel: [0, 800], address: 0, before: []}\n"
        "  Y: {travel: [0, 800], address: 1, before: []}\n"
        "circles:\n  - {file: before.csv, name: xy, centre: [400, 400], accept: {D: 30}}\n"
    )
    cw.plan(job).write()
    (circle,) = cw.read(tmp_path / "after.csv")
    assert repr(circle).startswith("CircularTest('after': plane XY, radius 150 mm, feed ")
    with pytest.raises(cw.UsageError, match="give positioning tests"):
        cw.estimate(circle)
    memory, file = cw.verify(job, circle), cw.verify(job, tmp_path / "after.csv")
    assert memory.to_dict() == file.to_dict()
    assert "xy" in memory.to_dict()["circles"]


def test_errors_name_the_arguments_of_the_library(folder: Path, tmp_path: Path) -> None:
    """What is copied from a message has to work where it was printed."""
    plan = cw.plan(folder / "job.yaml")
    with pytest.raises(cw.StorageError, match=r"give another folder .`folder`., or `force=True`"):
        plan.write(folder / "by-command")
    with pytest.raises(cw.UsageError, match='give `spread="std"` or `spread="range"`'):
        cw.evaluate(folder / "before" / "x.csv", spread="max")  # type: ignore[arg-type]
    with pytest.raises(cw.InputError, match='folder of its results with `plan="DIR"`'):
        cw.verify(folder / "job.yaml", cw.read(folder / "before"), plan=tmp_path)
    foreign = tmp_path / "table.csv"
    foreign.write_text("pos;dev\n1;2\n")
    with pytest.raises(
        cw.InputError, match=r"`compwright profile .* --out P.yaml`, then `profile="
    ):
        cw.read(foreign)


def test_tests_print_themselves_in_one_line_with_units(folder: Path) -> None:
    rotary, linear = cw.read(folder / "before")
    assert repr(linear) == (
        "PositioningTest('x': axis X, 25 targets from 20.087 to 1176.76 mm, traverses +5 -5, "
        "deviations -5.40 to 67.69 µm)"
    )
    assert repr(rotary).endswith(" arcsec)")


def test_correction_and_error_cancel(folder: Path) -> None:
    """Physics: what the control adds is minus the estimated error, up to the datum."""
    where = np.linspace(50.0, 1150.0, 23)
    error = cw.estimate(cw.read(folder / "before" / "x.csv"))
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
    plain, turned = cw.estimate(test), cw.estimate(test, sense=-1, offset=1200.0)
    assert turned.mean(1200.0 - 300.0, "-") == pytest.approx(-plain.mean(300.0, "+"), abs=0.2)


def test_two_threads_do_not_disturb_each_other(folder: Path) -> None:
    alone = cw.plan(folder / "job.yaml").to_dict()
    with ThreadPoolExecutor(2) as pool:
        both = list(pool.map(lambda _: cw.plan(folder / "job.yaml").to_dict(), range(2)))
    assert both == [alone, alone]


def test_wrong_input_is_one_error_with_every_fault(tmp_path: Path) -> None:
    with pytest.raises(cw.UsageError, match="axes"):
        cw.estimate(cw.simulate(EXAMPLE / "machine.yaml"))
    with pytest.raises(cw.UsageError, match="one test is evaluated at a time"):
        cw.evaluate(EXAMPLE / "before")
    tests = cw.read(EXAMPLE / "before")
    with pytest.raises(cw.UsageError, match="one test is evaluated at a time"):
        cw.evaluate(tests)
    assert cw.evaluate(tests[:1]).name == tests[0].name
    (tmp_path / "one.csv").write_text("a,b\n1,2\n")
    (tmp_path / "two.csv").write_text("c\n3\n")
    with pytest.raises(cw.InputError) as error:
        cw.read(tmp_path)
    assert {Path(fault.file).name for fault in error.value.faults} == {"one.csv", "two.csv"}


@needs_shared
@pytest.mark.real_pages
def test_a_job_of_circles_only_names_its_circles_and_axes(tmp_path: Path) -> None:
    file = REAL / "ballbar" / "ballbar_qc20w_150mm_XY.b5r"
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\n"
        "controller: {format: siemens-840d-sl,"
        " options: {cec: available, cec_sign: correction, cec_tables: [0]}}\n"
        "states: {as_found: none}\n"
        "axes:\n"
        "  X: {travel: [0, 800], address: AX1, before: []}\n"
        "  Y: {travel: [0, 800], address: AX2, before: []}\n"
        f"circles: [{{file: '{file}', name: xy, centre: [400, 400]}}]\n"
        "apply: {squareness: {XY: Y}}\n"
    )
    plan = cw.plan(tmp_path / "job.yaml")
    assert re.search(r"siemens-840d-sl: xy G 5.07 -> [\d.]+ \(", repr(plan))
    plan.write(tmp_path / "out")
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Compensation of X, Y" in page
    assert "axes X and Y" in page
    card = (tmp_path / "out" / "card" / "card.md").read_text(encoding="utf-8")
    assert "column Old" not in card  # no parameter of an axis is changed


def test_import_loads_nothing() -> None:
    asked = "import sys, compwright; print('numpy' in sys.modules, len(dir(compwright)) > 12)"
    found = subprocess.run(
        [sys.executable, "-c", asked], capture_output=True, text=True, check=True
    )
    assert found.stdout.split() == ["False", "True"]
