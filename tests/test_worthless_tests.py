"""Measurements that are worth nothing, as they come from a hall: none after loading is good, none
before loading makes a table without a warning, and each is answered with its cause.

Two axes with a coarse table, which leaves enough of the error for a turned sign to show; one run of
the job for all. Zeros, units, copies, missing axes and targets: ``test_verify_proof``; before
loading: ``test_implausible_tests``.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, csv_of

X = Machine(bow=0.009)
Y = Machine(slope=-30e-6, bow=0.007, lost=0.003)
TARGETS = X.targets(count=25)
Readings = dict[int, Floats]
JOB = """compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: 0, before: [x.csv], table: {spacing: 200}, accept: {A: 60}}
  Y: {travel: [0, 800], address: 1, before: [y.csv], table: {spacing: 200}}
"""


def loaded(tables: Path, address: str) -> Callable[[Floats, int], Floats]:
    """The correction of a joint, from the rows of its file: position less actual position."""
    rows = np.loadtxt(tables / f"joint_{address}.comp")
    column = {1: 1, -1: 2}
    return lambda x, sign: np.interp(x, rows[:, 0], rows[:, 0] - rows[:, column[sign]])


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The job, run, with honest tests after loading beside it."""
    folder = tmp_path_factory.mktemp("done")
    (folder / "job.yaml").write_text(JOB)
    for name, machine in (("X", X), ("Y", Y)):
        path = folder / f"{name.lower()}.csv"
        path.write_text(csv_of(TARGETS, machine.measure(TARGETS, ord(name)), name))
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder


def honest(done: Path, name: str, seed: int = 3) -> Readings:
    tables = done / "job" / "tables" / "linuxcnc"
    machine, address = {"X": (X, "0"), "Y": (Y, "1")}[name]
    return machine.measure(TARGETS, seed + ord(name), loaded(tables, address))


def before(name: str) -> Readings:
    return {"X": X, "Y": Y}[name].measure(TARGETS, ord(name))


def verify(done: Path, out: Path, *after: str) -> tuple[int, Any]:
    words = [word for file in after for word in ("--after", file)]
    code = compwright(["verify", str(done / "job.yaml"), *words, "--out", str(out)])
    path = out / "verification.json"
    return code, json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def after_x(
    done: Path, out: Path, x: Readings, targets: Floats = TARGETS, name: str = "X"
) -> tuple[int, Any]:
    """Verify with this test of X beside an honest one of Y."""
    out.mkdir(exist_ok=True)
    (out / "x.csv").write_text(csv_of(targets, x, name))
    (out / "y.csv").write_text(csv_of(TARGETS, honest(done, "Y"), "Y"))
    return verify(done, out, f"x={out / 'x.csv'}", f"y={out / 'y.csv'}")


def turned(readings: Readings, change: Callable[[Floats], Floats]) -> Readings:
    return {sign: change(block) for sign, block in readings.items()}


def codes(document: Any) -> set[str]:
    return {finding["code"] for finding in document["doubts"]}


# ---------------------------------------------------------------- after loading


def test_honest_tests_are_good(done: Path, tmp_path: Path) -> None:
    """Else nothing below would mean anything."""
    code, document = after_x(done, tmp_path, honest(done, "X"))
    assert (code, document["verdict"], document["doubts"]) == (0, "good", [])
    assert {axis["loading"]["verdict"] for axis in document["axes"].values()} == {"loaded"}


#: What was done with the readings, and what may be told.
FAULTS: dict[str, tuple[Callable[[Readings], Readings], set[str]]] = {
    "every sign negated": (lambda now: turned(now, np.negative), {"sign"}),
    "directions exchanged": (lambda now: {sign: now[-sign] for sign in now}, {"direction"}),
    "half the test from before": (lambda _: turned(before("X"), lambda b: 0.5 * b), {"copied"}),
    "a tenth of the test from before": (
        lambda _: turned(before("X"), lambda b: b / 10),
        {"copied"},
    ),
    "the other axis' test from before": (lambda _: before("Y"), {"wrong_axis", "copied"}),
    "three times the test from before": (
        lambda _: turned(before("X"), lambda b: 3 * b),
        {"copied"},
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_worthless_test_is_named_for_what_it_is(done: Path, tmp_path: Path, fault: str) -> None:
    change, of = FAULTS[fault]
    code, document = after_x(done, tmp_path, change(honest(done, "X")))
    axis = document["axes"]["X"]
    assert (code, document["verdict"]) == (1, "undecided")
    assert axis["loading"]["verdict"] == "measurement"
    assert axis["loading"]["of"] in of
    assert axis["loading"]["message"]
    assert axis["accept"]["A"]["decision"] == "undecided"
    assert "CW-V026" in codes(document)


def test_the_test_of_another_axis_is_no_test_of_this_one(done: Path, tmp_path: Path) -> None:
    """A fresh test of Y, with its table loaded, given for X; what the file itself says is held
    against the axis.
    """
    now = Y.measure(TARGETS, 40, loaded(done / "job" / "tables" / "linuxcnc", "1"))
    _, document = after_x(done, tmp_path, now)
    assert document["verdict"] != "good"
    assert document["axes"]["X"]["loading"]["verdict"] in {"measurement", "undecided"}


def test_a_file_that_names_another_axis_is_not_taken_in_silence(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, document = after_x(done, tmp_path, honest(done, "X"), name="Y")
    said = capsys.readouterr().err
    assert code != 0
    assert "axis" in said
    assert document is None or document["verdict"] != "good"


# ---------------------------------------------------------------- before loading


def run_with(folder: Path, x: Readings, targets: Floats = TARGETS, name: str = "X") -> int:
    (folder / "x.csv").write_text(csv_of(targets, x, name))
    (folder / "job.yaml").write_text("".join(JOB.splitlines(keepends=True)[:-1]))
    return compwright(["run", str(folder / "job.yaml")])


def test_um_read_as_mm_makes_no_table(tmp_path: Path) -> None:
    code = run_with(tmp_path, turned(before("X"), lambda block: block * 1000))
    assert code in {3, 4}  # 4: so large that no control holds it
    assert not (tmp_path / "job" / "tables").exists()


DOUBTFUL: dict[str, Callable[[Readings], tuple[Readings, Floats]]] = {
    "every sign negated": lambda x: (turned(x, np.negative), TARGETS),
    "the second direction a copy": lambda x: ({1: x[1], -1: x[1]}, TARGETS),
    "two of the targets": lambda x: (turned(x, lambda b: b[[3, 17]]), TARGETS[[3, 17]]),
}


@pytest.mark.parametrize("fault", DOUBTFUL)
def test_a_doubtful_test_makes_no_table_without_a_warning(tmp_path: Path, fault: str) -> None:
    code = run_with(tmp_path, *DOUBTFUL[fault](before("X")))
    if code == 3:
        assert not (tmp_path / "job").exists()
        return
    document = json.loads((tmp_path / "job" / "prediction.json").read_text(encoding="utf-8"))
    assert {doubt["severity"] for doubt in document["doubts"]} & {"warning", "error"}


def test_the_test_of_another_axis_makes_no_table(tmp_path: Path) -> None:
    assert run_with(tmp_path, before("X"), name="Y") in {2, 3}
    assert not (tmp_path / "job").exists()
