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

pytestmark = pytest.mark.short_estimate

X = Machine(bow=0.009)
Y = Machine(slope=-30e-6, bow=0.007, lost=0.003)
TARGETS = X.targets(count=15)
Readings = dict[int, Floats]
JOB = """compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: 0, before: [x.csv], table: {spacing: 400}, accept: {A: 60}}
  Y: {travel: [0, 800], address: 1, before: [y.csv], table: {spacing: 400}}
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


def after(done: Path, out: Path, x: Readings, y: Readings, name: str = "X") -> tuple[int, Any]:
    """Verify with these tests of X and Y; ``name``: the axis that the file of X names."""
    for test, axis, readings in (("x", name, x), ("y", "Y", y)):
        (out / f"{test}.csv").write_text(csv_of(TARGETS, readings, axis))
    return verify(done, out, f"x={out / 'x.csv'}", f"y={out / 'y.csv'}")


def turned(readings: Readings, change: Callable[[Floats], Floats]) -> Readings:
    return {sign: change(block) for sign, block in readings.items()}


def codes(document: Any) -> set[str]:
    return {finding["code"] for finding in document["doubts"]}


# ---------------------------------------------------------------- after loading


def test_honest_tests_are_good(done: Path, tmp_path: Path) -> None:
    """Else nothing below would mean anything."""
    code, document = after(done, tmp_path, honest(done, "X"), honest(done, "Y"))
    assert (code, document["verdict"], document["doubts"]) == (0, "good", [])
    assert {axis["loading"]["verdict"] for axis in document["axes"].values()} == {"loaded"}


Spoil = Callable[[Readings, Readings, Readings], Readings]
#: Made of the honest test, the one from before, and that of the other axis from before; what may
#: be told.
SPOILED: dict[str, tuple[Spoil, set[str]]] = {
    "every sign negated": (lambda now, _, __: turned(now, np.negative), {"sign"}),
    "directions exchanged": (lambda now, _, __: {s: now[-s] for s in now}, {"direction"}),
    "half the test from before": (lambda _, old, __: turned(old, lambda b: b / 2), {"copied"}),
    "a tenth of it": (lambda _, old, __: turned(old, lambda b: b / 10), {"copied"}),
    "three times it": (lambda _, old, __: turned(old, lambda b: 3 * b), {"copied"}),
    "the other axis' one": (lambda _, __, other: other, {"wrong_axis", "copied"}),
}


@pytest.mark.parametrize(
    ("x", "y"),
    [
        ("every sign negated", "directions exchanged"),
        ("directions exchanged", "every sign negated"),
        ("half the test from before", "a tenth of it"),
        ("three times it", "the other axis' one"),
    ],
)
def test_a_worthless_test_is_named_for_what_it_is(
    done: Path, tmp_path: Path, x: str, y: str
) -> None:
    x_test, y_test = (
        SPOILED[what][0](honest(done, name), before(name), before(other))
        for what, name, other in ((x, "X", "Y"), (y, "Y", "X"))
    )
    code, document = after(done, tmp_path, x_test, y_test)
    assert (code, document["verdict"]) == (1, "undecided")
    assert "CW-V026" in codes(document)
    assert document["axes"]["X"]["accept"]["A"]["decision"] == "undecided"
    for axis, what in (("X", x), ("Y", y)):
        loading = document["axes"][axis]["loading"]
        assert loading["verdict"] == "measurement"
        assert loading["of"] in SPOILED[what][1]
        assert loading["message"]


def test_the_test_of_another_axis_is_no_test_of_this_one(done: Path, tmp_path: Path) -> None:
    """Fresh tests of both with their tables loaded, the files exchanged."""
    _, document = after(done, tmp_path, honest(done, "Y"), honest(done, "X"))
    assert document["verdict"] != "good"
    for axis in document["axes"].values():
        assert axis["loading"]["verdict"] in {"measurement", "undecided"}


def test_a_file_that_names_another_axis_is_not_taken_in_silence(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, document = after(done, tmp_path, honest(done, "X"), honest(done, "Y"), name="Y")
    assert code != 0
    assert "axis" in capsys.readouterr().err
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
    "two of the targets": lambda x: (turned(x, lambda b: b[[3, 11]]), TARGETS[[3, 11]]),
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
