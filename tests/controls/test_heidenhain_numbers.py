"""HEIDENHAIN controls that count their axes: which number is which axis, and what to do where the
job and the files leave it open. Columns as in the classic dump (facts on HEIDENHAIN formats).
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

ITNC = "heidenhain-itnc530"
MACHINE = Machine()
MP = "MP710.0 : 0.0000\nMP710.1 : 0.0000\nMP720.0 : 0.0000\nMP720.1 : 0.0000\nMP730 : %00011\n"


def com(axis: str, number: int, rows: int = 19) -> str:
    values = "".join(f"{k:<5d}{0.0002 * k:+.4f}\n" for k in range(rows))
    return f"BEGIN {axis} .COM MM DATUM:-50 DIST:50\nNR   {number}=F()\n{values}END {axis} .COM\n"


def run(folder: Path, x: str, tables: dict[int, str], further: str = "") -> int:
    (folder / "x.csv").write_text(csv_of(MACHINE.targets(), MACHINE.measure(MACHINE.targets(), 1)))
    cells = [(f"{number:<10d}", f"{axis:<10s}") for number, axis in tables.items()]
    head, row = ("".join(one) for one in zip(*cells, strict=True))
    (folder / "C.CMA").write_text(f"BEGIN C .CMA MM\nNR   {head}\n0    {row}\nEND C .CMA\n")
    for number, axis in tables.items():
        (folder / f"{axis}.COM").write_text(com(axis, number))
    (folder / "MP.TXT").write_text(MP)
    files = ", ".join([*(f"{axis}.COM" for axis in tables.values()), "C.CMA", "MP.TXT"])
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {ITNC}}}\nstates: {{as_found: {{files: [{files}],"
        f" active: yes}}}}\naxes:\n  X: {{travel: [0, 800], {x}before: [x.csv]}}\n{further}"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def changed(folder: Path, tables: dict[int, str]) -> list[str]:
    new = folder / "job" / "tables" / ITNC
    return [
        axis
        for number, axis in tables.items()
        if (new / f"{axis}.COM").read_text() != com(axis, number)
    ]


def test_a_number_that_the_job_takes_from_its_axis_is_asked_about_and_both_ways_on_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tables = {1: "X", 2: "Y"}
    assert run(tmp_path, "axis_number: 2, ", tables) == 2
    text = " ".join(capsys.readouterr().err.split())
    assert "axes.X.axis_number: the files use axis number 1, which no axis of the job has" in text
    assert "remove `axis_number: 2`" in text
    assert "`address: Y`" in text
    assert run(tmp_path, "", tables) == 0
    assert changed(tmp_path, tables) == ["X"]
    assert run(tmp_path, "axis_number: 2, address: Y, ", tables) == 0
    assert changed(tmp_path, tables) == ["Y"]


def test_two_axes_with_one_number_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    readings = MACHINE.measure(MACHINE.targets(), 1)
    (tmp_path / "y.csv").write_text(csv_of(MACHINE.targets(), readings).replace(": X", ": Y"))
    y = "  Y: {travel: [0, 800], axis_number: 1, before: [y.csv]}\n"
    assert run(tmp_path, "axis_number: 1, ", {1: "X", 2: "Y"}, y) == 2
    assert "axes X and Y have the same axis number" in " ".join(capsys.readouterr().err.split())


def test_a_seventh_axis_of_the_machine_stops_nothing(tmp_path: Path) -> None:
    tables = {1: "X", 7: "U"}
    assert run(tmp_path, "", tables) == 0
    assert changed(tmp_path, tables) == ["X"]
