"""A table is never counted twice: the test from which it was made does not go with the state that
it has become.

Three rounds with one and the same test would add the same correction three times. A fresh test,
taken with the tables loaded, is the next round, and that works.
"""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.evaluation.rounded_copies import is_coarse, is_rounded_copy
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile
from compwright.records.positioning import PositioningTest
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

AXES = {
    "X": Machine(low=0.0, high=800.0),
    "Y": Machine(low=-500.0, high=0.0, slope=-20e-6, bow=0.004),
}
ADDRESS = {"X": "0", "Y": "1"}


def measure(folder: Path, axis: str, seed: int, tables: Path | None = None) -> None:
    """Measure an axis with the tables of a folder loaded (None: nothing is)."""
    machine = AXES[axis]
    acting = None
    if tables is not None:
        judge = virtual_control(
            "linuxcnc",
            [ControlFile(path.name, path.read_bytes()) for path in sorted(tables.iterdir())],
        )

        def acting(where: Floats, sign: int) -> Floats:
            return judge.correction(
                ADDRESS[axis], where, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE
            )

    targets = machine.targets()
    (folder / f"{axis.lower()}.csv").write_text(
        csv_of(targets, machine.measure(targets, seed, acting), axis=axis)
    )


@pytest.fixture(scope="module")
def once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a first round: two axes of a control in which nothing was."""
    folder = tmp_path_factory.mktemp("first")
    for number, axis in enumerate(AXES):
        measure(folder, axis, number)
    assert run(folder) == 0
    return folder


@pytest.fixture
def folder(once: Path, tmp_path: Path) -> Path:
    shutil.copytree(once, tmp_path / "hall")
    return tmp_path / "hall"


def run(
    folder: Path,
    *words: str,
    as_found: str = "none",
    axes: str = "XY",
    name: str = "job",
    extra: str = "",
    entry: str = "",
) -> int:
    sections = {
        "X": f"  X: {{travel: [0, 800], address: 0, before: [{entry or 'x.csv'}]}}\n",
        "Y": "  Y: {travel: [-500, 0], address: 1, before: [y.csv]}\n",
    }
    (folder / f"{name}.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found:"
        f" {as_found}{extra}}}\naxes:\n" + "".join(sections[axis] for axis in axes)
    )
    return compwright(["run", str(folder / f"{name}.yaml"), *words])


def table(out: Path) -> Any:
    return np.array(
        json.loads((out / "prediction.json").read_text())["axes"]["X"]["table"][
            "correction_positive"
        ]
    )


def positioning_test(targets: Floats, readings: dict[int, Floats]) -> PositioningTest:
    runs = tuple(range(1, 6))
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=readings[1],
        negative=readings[-1],
        runs_positive=runs,
        runs_negative=runs,
    )


def rounded(test: PositioningTest, digits: int) -> PositioningTest:
    return replace(
        test,
        positive=np.round(test.positive, digits),
        negative=np.round(test.negative, digits),
    )


def copied(folder: Path) -> str:
    shutil.copytree(folder / "job" / "tables" / "linuxcnc", folder / "control")
    return "[control]"


def test_what_a_run_writes_is_not_what_it_starts_from(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measure(folder, "X", 9, folder / "job" / "tables" / "linuxcnc")
    assert run(folder, "--force", as_found="[job/tables/linuxcnc]") == 2
    assert "is an output of this run" in capsys.readouterr().err


@pytest.mark.parametrize("axes", ["XY", "X"])
def test_copied_tables_with_the_test_from_which_they_were_made(
    folder: Path, axes: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(folder, "--force", as_found=copied(folder), axes=axes) == 2
    said = capsys.readouterr().err
    assert "added a second time" in said
    assert str(Path("job") / "plan.json") in said
    assert "axes.X.before" in said
    assert ("axes.Y.before" in said) == (axes == "XY")


def test_another_folder_for_the_results_makes_no_difference(folder: Path) -> None:
    assert (
        run(folder, "--out", str(folder / "two"), as_found="[job/tables/linuxcnc]", name="two") == 2
    )
    assert (
        run(folder, "--out", str(folder.parent / "away"), as_found=copied(folder), name="three")
        == 2
    )


def test_files_that_do_the_same_in_another_form_are_the_same_tables(folder: Path) -> None:
    copied(folder)
    for path in (folder / "control").glob("*.comp"):
        path.write_bytes(path.read_bytes().replace(b" ", b"\t").replace(b"\n", b"\r\n"))
    assert run(folder, "--out", str(folder / "two"), as_found="[control]", name="two") == 2


def test_the_same_readings_in_another_file_are_the_same_test(folder: Path) -> None:
    (folder / "again.csv").write_text("# a copy\n" + (folder / "x.csv").read_text())
    assert (
        run(
            folder,
            "--out",
            str(folder / "two"),
            as_found=copied(folder),
            axes="X",
            entry="again.csv",
            name="two",
        )
        == 2
    )


def written_again(folder: Path, what: str) -> str:
    """Write the test of X once more: the control's files that go with it are its tables."""
    targets = AXES["X"].targets()
    readings = dict(AXES["X"].measure(targets, 0))
    if what == "other zero":
        readings = {sign: block + 0.0123 for sign, block in readings.items()}
    if what == "other order":
        readings = {sign: block[:, ::-1] for sign, block in readings.items()}
    if what == "some runs":
        readings = {sign: block[:, 1:4] for sign, block in readings.items()}
    if what == "every second target":
        targets, readings = targets[::2], {sign: block[::2] for sign, block in readings.items()}
    step = 0.001 if what == "whole µm" else 0.0001
    readings = {sign: step * np.round(block / step) for sign, block in readings.items()}
    (folder / "again.csv").write_text(csv_of(targets, readings))
    return copied(folder)


@pytest.mark.parametrize(
    "what",
    ["rounded", "whole µm", "other zero", "other order", "some runs", "every second target"],
)
def test_readings_with_fewer_digits_are_the_same_test(
    folder: Path, what: str, capsys: pytest.CaptureFixture[str]
) -> None:
    state = written_again(folder, what)
    assert run(folder, "--force", as_found=state, axes="X", entry="again.csv") == 2
    assert "a test taken with these tables loaded" in capsys.readouterr().err


def test_the_plan_next_to_the_measurements_is_found(folder: Path, tmp_path: Path) -> None:
    written_again(folder, "rounded")
    (tmp_path / "today").mkdir()
    entry = str(folder / "again.csv")
    as_found = f"[{folder / 'control'}]"
    assert run(tmp_path / "today", as_found=as_found, axes="X", entry=entry) == 2


def test_the_plan_of_yesterday_is_found_next_to_the_folder_of_today(folder: Path) -> None:
    written_again(folder, "rounded")
    today = folder.parent / "today"
    today.mkdir()
    for name in ("again.csv", "control"):
        shutil.move(folder / name, today / name)
    assert run(today, as_found="[control]", axes="X", entry="again.csv") == 2


def test_a_machine_without_its_table_is_no_copy_of_the_first_test() -> None:
    """Fresh readings of the same axis scatter by its noise; rounded ones are the same runs."""
    targets = AXES["X"].targets()
    first, other = (positioning_test(targets, AXES["X"].measure(targets, n)) for n in (0, 1))
    assert is_rounded_copy(rounded(first, 4), first)
    assert is_rounded_copy(rounded(first, 3), first)
    assert not is_rounded_copy(other, first)
    assert not is_rounded_copy(rounded(other, 4), first)


def test_readings_at_further_targets_are_no_part_of_a_copy() -> None:
    targets = AXES["X"].targets()
    first, other = (positioning_test(targets, AXES["X"].measure(targets, n)) for n in (0, 1))
    for more, copied in ((1, True), (targets.size, False)):
        longer = replace(
            first,
            targets=np.concatenate([targets, targets[:more] + 0.7]),
            positive=np.vstack([first.positive, other.positive[:more]]),
            negative=np.vstack([first.negative, other.negative[:more]]),
        )
        order = np.argsort(longer.targets)
        longer = replace(
            longer,
            targets=longer.targets[order],
            positive=longer.positive[order],
            negative=longer.negative[order],
        )
        assert is_rounded_copy(longer, first) is copied


@pytest.mark.parametrize(("noise", "coarse"), [(0.05e-3, True), (0.5e-3, False)])
def test_readings_are_coarse_beside_the_scatter_of_the_runs(noise: float, *, coarse: bool) -> None:
    """In steps of 0.1 µm; runs that differ by constants of 3 µm do not make them fine."""
    rng = np.random.default_rng(3)
    targets = np.linspace(20.0, 780.0, 20)
    shifts = 3e-3 * np.arange(5)
    readings = {sign: shifts + rng.normal(0.0, noise, (20, 5)) for sign in (1, -1)}
    test = positioning_test(targets, readings)
    assert is_coarse(rounded(test, 4), test) is coarse


def test_a_run_without_a_job(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = [
        "run",
        str(folder / "x.csv"),
        "--format",
        "linuxcnc",
        "--axis",
        "X",
        "--travel",
        "0:800",
        "--option",
        "address=0",
    ]
    tables = [str(path) for path in sorted((folder / "job" / "tables" / "linuxcnc").iterdir())]
    states = [word for path in tables for word in ("--state", path)]
    assert compwright([*words, *states, "--out", str(folder / "two")]) == 2
    assert "added a second time" in capsys.readouterr().err


def test_a_fresh_test_with_the_tables_loaded_is_the_next_round(folder: Path) -> None:
    first = table(folder / "job")
    state = copied(folder)
    for number, axis in enumerate(AXES):
        measure(folder, axis, 20 + number, folder / "control")
    assert (
        run(folder, "--out", str(folder / "two"), "--accept-worse", as_found=state, name="two") == 0
    )
    # µm: what is left is noise, 0.4 a reading, the mean of ten 0.13; at a node no more than ten of
    # these
    assert np.max(np.abs(table(folder / "two") - first)) < 1.3


def test_the_old_test_with_the_state_in_which_it_was_taken_is_right(folder: Path) -> None:
    """The tables are in the control, the test was taken before: the totals come out as they are."""
    state = copied(folder)
    entry = "{files: [x.csv], measured_in: bare}"
    words = ("--out", str(folder / "two"), "--accept-worse")
    assert (
        run(folder, *words, as_found=state, extra=", bare: none", entry=entry, axes="X", name="two")
        == 0
    )
    assert table(folder / "two") == pytest.approx(
        table(folder / "job"), abs=0.2
    )  # µm: half of a quantum is far less


def test_the_same_job_again_is_the_same_job(folder: Path) -> None:
    assert run(folder, "--force") == 0


def test_one_axis_that_was_not_loaded_keeps_its_test(folder: Path) -> None:
    """Only Y was loaded: for X nothing has changed, and its test still holds."""
    (folder / "control").mkdir()
    for name in ("joint_1.comp", "joint_1.ini"):
        shutil.copy(folder / "job" / "tables" / "linuxcnc" / name, folder / "control")
    (folder / "control" / "joint_0.ini").write_text("[JOINT_0]\nBACKLASH = 0\n")
    assert (
        run(folder, "--out", str(folder / "two"), as_found="[control]", axes="X", name="two") == 0
    )
    assert (
        run(
            folder,
            "--out",
            str(folder / "two"),
            "--force",
            as_found="[control]",
            axes="Y",
            name="two",
        )
        == 2
    )


def test_the_old_test_less_a_row_is_still_the_old_test(folder: Path) -> None:
    """A row deleted in a spreadsheet makes no new measurement: 169 of 170 readings to the last
    digit are no chance.
    """
    state = copied(folder)
    rows = (folder / "x.csv").read_text().splitlines()
    (folder / "x.csv").write_text("\n".join(rows[:-1]) + "\n")
    assert run(folder, "--force", as_found=state, axes="X", name="next") == 2
