"""The synchronised axis of a gantry that has a table, grid or backlash of its own: the job says
whether it gets the same total or the same change; nothing of it is overwritten unasked.

The machine is plain: what each column's control adds is worked out here from the files alone.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile

pytestmark = pytest.mark.short_estimate

X = np.linspace(0.0, 800.0, 17)
UM = 1e-3


def error(x: FloatArray, side: Direction) -> FloatArray:
    """What is wrong now with both columns alike, mm: grown since the tables were made."""
    return np.asarray(1.2e-5 * x + 0.003 * np.sin(x / 160) + (0.004 if side.sign < 0 else 0.0))


def write_test(folder: Path) -> None:
    """A test with the tables active: they cancel what the columns had; `error` is left."""
    rng = np.random.default_rng(7)
    rows = ["target_mm,direction,run,deviation_mm"]
    for side in Direction:
        for run in range(1, 4):
            values = error(X, side) + rng.normal(0, 0.0003, X.size)
            rows += [f"{x:g},{side.value},{run},{v:.6f}" for x, v in zip(X, values, strict=True)]
    (folder / "x.csv").write_text("\n".join(rows) + "\n")


def eec(address: str, values: FloatArray, step: float, backlash: float) -> str:
    rows = [f"$AA_ENC_COMP[0,{n},{address}]={value:.6f}" for n, value in enumerate(values)]
    return "\n".join(
        [
            *rows,
            f"$AA_ENC_COMP_STEP[0,{address}]={step:g}",
            f"$AA_ENC_COMP_MIN[0,{address}]=0",
            f"$AA_ENC_COMP_MAX[0,{address}]={step * (len(values) - 1):g}",
            f"$AA_ENC_COMP_IS_MODULO[0,{address}]=0",
            f"$MA_ENC_COMP_ENABLE[0,{address}]=1",
            f"$MA_BACKLASH[0,{address}]={backlash:g}",
            f"$MA_MM_ENC_COMP_MAX_POINTS[0,{address}]=100",
            f"$MA_GANTRY_AXIS_TYPE[{address}]={1 if address == 'AX1' else 11}",
        ]
    )


def own_values(step: float) -> FloatArray:
    """A table of the other column: another shape, 12 µm."""
    x = np.arange(0.0, 801.0, step)
    return np.asarray(np.round(0.012 * np.sin(x / 255), 6))


def sinumerik(folder: Path, own: str) -> None:
    lead = eec("AX1", np.round(0.006 * np.sin(np.arange(0, 801, 50) / 200), 6), 50, 0.002)
    (folder / "ALL.INI").write_text(f"CHANDATA(1)\n{lead}\n{own}\nM17\n")


def fanuc(folder: Path, own: dict[int, str], increments: dict[int, int]) -> None:
    lead = {
        1006: "00000000",
        1013: "00000000",
        1820: "2",
        1851: "3",
        1852: "9",
        3620: "10",
        3621: "10",
        3622: "26",
        3623: "1",
        3624: "50.0",
        3605: "00000000",
    }
    rows = {number: f"A1P{value}A2P{own.get(number, value)}" for number, value in lead.items()}
    rows |= {1800: "P00010000", 1001: "P00000000", 8311: "A1P0A2P1"}
    text = "".join(f"N{number:05d}Q1{rows[number]}\n" for number in sorted(rows))
    data = {n: [1, 0, -1, 2, 0, -2, 1, 1][n % 8] for n in range(11, 27)} | increments
    points = "".join(f"N{10_000 + n}Q0P{data.get(n, 0)}\n" for n in range(1536))
    (folder / "CNC-PARA.TXT").write_text(f"%\n{text}%")
    (folder / "PITCH.TXT").write_text(f"%\n{points}%")


def linuxcnc(folder: Path, own: list[tuple[float, float]], lead: list[tuple[float, float]]) -> None:
    joints = ""
    for number, rows in enumerate((lead, own)):
        name = f"joint_{number}.comp"
        joints += (
            f"[JOINT_{number}]\nTYPE = LINEAR\nMIN_LIMIT = 0\nMAX_LIMIT = 800\nCOMP_FILE = {name}\n"
            "COMP_FILE_TYPE = 1\n"
        )
        lines = [f"{x:g} {value:.6f} {value:.6f}" for x, value in rows]
        (folder / name).write_text("\n".join(lines) + "\n")
    (folder / "machine.ini").write_text(
        "[KINS]\nKINEMATICS = trivkins coordinates=XX\nJOINTS = 2\n[TRAJ]\nLINEAR_UNITS = mm\n"
        f"COORDINATES = XX\n{joints}"
    )


class Bench:
    """A folder with a control's files, a test in that state, and a job."""

    def __init__(self, folder: Path, control: str, addresses: tuple[str, str]) -> None:
        self.folder, self.control, self.addresses = folder, control, addresses
        self.old = self.judged([path for path in folder.iterdir() if path.suffix != ".csv"])
        self.state = sorted(path.name for path in folder.iterdir())
        write_test(folder)

    def run(self, table: str | None) -> int:
        gantry = f'"{self.addresses[1]}"'
        if table is not None:
            gantry = f"{{axis: {gantry}, table: {table}}}"
        (self.folder / "job.yaml").write_text(
            f"compwright: 1\ncontroller: {{format: {self.control}}}\n"
            f"states: {{as_found: {json.dumps(self.state)}}}\n"
            f'axes:\n  X: {{travel: [0, 800], address: "{self.addresses[0]}", gantry: {gantry},'
            " before: [x.csv]}\n"
        )
        return compwright(["run", str(self.folder / "job.yaml"), "--force"])

    def judged(self, paths: list[Path], motion: str = "feed") -> dict[Any, FloatArray]:
        """What the control adds to each column with files, by address and direction, at `X`."""
        files = [ControlFile(path.name, path.read_bytes()) for path in sorted(paths)]
        options = {"motion": motion} if "fanuc" in self.control else None
        judge = virtual_control(self.control, files, options=options)
        return {
            (address, side): judge.correction(address, X, side)
            for address in self.addresses
            for side in Direction
        }

    def new(self, motion: str = "feed") -> dict[Any, FloatArray]:
        tables = self.folder / "job" / "tables" / self.control
        return self.judged(list(tables.iterdir()), motion)


def bench(folder: Path, control: str) -> Bench:
    """Both columns with tables of their own, on grids of their own."""
    if control == "siemens-840d-sl":
        sinumerik(folder, eec("AX5", own_values(100), 100, 0.005))
        return Bench(folder, control, ("AX1", "AX5"))
    if control == "linuxcnc":
        own = [(float(x), float(0.012 * np.sin(x / 255))) for x in range(0, 801, 100)]
        lead = [(float(x), float(0.006 * np.sin(x / 200))) for x in range(0, 801, 50)]
        linuxcnc(folder, own, lead)
        return Bench(folder, control, ("0", "1"))
    own_numbers = {1851: "7", 1852: "5", 3620: "110", 3621: "110", 3622: "126"}
    fanuc(folder, own_numbers, {n: [0, 2, 1, -1, 0, 1, -1, 0][n % 8] for n in range(111, 127)})
    return Bench(folder, "fanuc-30i", ("1", "2"))


@pytest.mark.parametrize("control", ["siemens-840d-sl", "fanuc-30i", "linuxcnc"])
def test_a_column_with_a_table_of_its_own_is_asked_for(
    control: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made = bench(tmp_path, control)
    assert made.run(None) == 2
    said = capsys.readouterr().err
    assert "axes.X.gantry" in said
    assert "table: same" in said
    assert "table: change" in said
    assert not (tmp_path / "job").exists()


@pytest.mark.parametrize("control", ["siemens-840d-sl", "fanuc-30i", "linuxcnc"])
def test_the_same_change_is_added_to_each_total(
    control: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made = bench(tmp_path, control)
    lead, own = made.addresses
    assert made.run("change") == 0
    new = made.new()
    coarse = slice(None, None, 2)  # nodes of the coarser grid
    for side in Direction:
        change = new[lead, side] - made.old[lead, side]
        assert np.ptp(change) > 6 * UM
        left = error(X, side) + change
        assert np.ptp(left) < 2.5 * UM
        apart = new[own, side] - made.old[own, side] - change
        assert np.max(np.abs(apart[coarse])) < 1.01 * UM * (1 if control == "fanuc-30i" else 0.01)
    if control == "fanuc-30i":
        tables = tmp_path / "job" / "tables" / control
        text = (tables / "CNC-PARA.TXT").read_text()
        feed, rapid = (
            [int(v) for v in re.findall(r"A\dP(-?\d+)", line)]
            for line in re.findall(r"N0185[12]Q1.*", text)
        )
        assert np.subtract(feed, (3, 7)).tolist() == [feed[0] - 3] * 2
        assert np.subtract(rapid, (9, 5)).tolist() == [feed[0] - 3] * 2
    plan = str(tmp_path / "job" / "plan.json")
    loaded = tmp_path / "job" / "tables" / control
    # The units and types of the INI file of LinuxCNC are not in the files that were written.
    capsys.readouterr()
    unread = int(control == "linuxcnc")
    assert compwright(["compare", plan, "--loaded", str(loaded)]) == unread
    assert capsys.readouterr().out.count("TYPE (rotary)") == 2 * unread
    if control == "linuxcnc":
        back = tmp_path / "back"
        shutil.copytree(loaded, back)
        job = str(tmp_path / "job.yaml")
        verify = ["verify", job, "--after", str(tmp_path / "x.csv"), "--loaded", str(back)]
        assert codes(tmp_path, verify) == {"CW-V010"}
        shutil.copy(back / "joint_0.comp", back / "joint_1.comp")  # not its own table
        assert codes(tmp_path, verify) == {"CW-V011"}
        assert compwright(["compare", plan, "--loaded", str(back)]) == 1


def codes(folder: Path, verify: list[str]) -> set[str]:
    """What verify says of the files that were read back."""
    out = folder / "verified.json"
    compwright([*verify, "--json", str(out), "--out", str(folder / "verified"), "--force"])
    found = set(re.findall(r"CW-V01[01]", out.read_text(encoding="utf-8")))
    assert found
    return found


@pytest.mark.parametrize("control", ["siemens-840d-sl", "fanuc-30i", "linuxcnc"])
def test_the_same_total_goes_to_both(control: str, tmp_path: Path) -> None:
    made = bench(tmp_path, control)
    lead, own = made.addresses
    assert made.run("same") == 0
    for motion in ("feed", "rapid") if control == "fanuc-30i" else ("feed",):
        new = made.new(motion)
        for side in Direction:
            np.testing.assert_allclose(new[lead, side], new[own, side], atol=1e-9)
