"""The grid that is in a FANUC control stays: 3620 to 3622, 3624 and the point numbers, on small
copies of a real backup and on the backup itself.

What hangs on point numbers (inclination 5861 to 5874, straightness 5711 to 5764) does the same
before and after where no number moves: that is what these tests hold.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from test_fanuc_backup_honoured import AXES, POINTS, Bench, said

GRID = (3620, 3621, 3622, 3624, 3625, 3626)


def grid(text: str, axis: str, numbers: tuple[int, ...] = GRID) -> dict[int, str]:
    return {number: said(text, number, AXES[axis]) for number in numbers}


def findings(bench: Bench, axis: str) -> dict[str, str]:
    prediction = json.loads((bench.folder / "job" / "prediction.json").read_text())
    return {one["code"]: one["message"] for one in prediction["axes"][axis]["findings"]}


@pytest.mark.parametrize("axis", ["X", "Y", "Z", "B"])
def test_numbers_interval_and_reference_stay_where_the_job_says_no_spacing(
    axis: str, tmp_path: Path
) -> None:
    bench = Bench(tmp_path)
    assert bench.run(axis) == 0
    parameters, points = bench.written()
    assert grid(parameters, axis) == grid(bench.parameters, axis)
    first, last = (int(said(parameters, number, AXES[axis])) for number in (3621, 3622))
    moved = {number for number in points if points[number] != POINTS.get(number, 0)}
    assert moved <= set(range(first, last + 1))  # of B not 300 either, its reference's own number
    assert bench.left(axis) < (0.0018 if axis == "B" else 0.006)  # 12 sections of B's 0.006 deg


def test_auto_chooses_and_a_number_names_the_grid(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X", axes={"X": "table: {spacing: 25}"}) == 0
    assert float(said(bench.written()[0], 3624, 1)) == 25
    (tmp_path / "auto").mkdir()
    bench = Bench(tmp_path / "auto")
    assert bench.run("B", axes={"B": "table: {spacing: auto}"}) == 0
    assert float(said(bench.written()[0], 3624, 4)) < 30
    assert bench.left("B") < 0.0008


def test_the_command_line_says_auto_too(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    bench.measure("X")
    words = [str(bench.folder / "X.csv"), "--format", "fanuc-30i", "--axis", "X"]
    words += ["--travel=-1000:0", "--out", str(bench.folder / "job")]
    words += [f"--state={bench.folder / name}" for name in ("CNC-PARA.TXT", "PITCH.TXT")]
    assert compwright(["run", *words, "--option=address=1", "--option=spacing=auto"]) == 0
    assert float(said(bench.written()[0], 3624, 1)) != 40
    assert compwright(["run", *words, "--option=address=1", "--force"]) == 0
    assert float(said(bench.written()[0], 3624, 1)) == 40
