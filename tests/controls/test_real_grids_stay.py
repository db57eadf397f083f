"""The grids of two real controls stay: every axis of the real FANUC backup that has a table, with
every byte outside the values; every axis of the real SINUMERIK archive, in small files that assign
nothing of its neighbours, whose tables are switched on.

What acts while the test is taken comes from the shipped virtual controls; the error on top of it is
made here.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from backup_files_fanuc import FOLDER, PARAMETERS, PITCH
from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile
from loop import Floats
from sinumerik_archive import eec_text, machine_data, needs_archive

pytestmark = pytest.mark.short_estimate

needs_backup = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
)
#: Travel (inside the limits 1320 and 1321 of the backup) and kind by axis; addresses as the control
#: names them.
FANUC = {
    "X": ("1", -1000.0, 0.0, ""),
    "Y": ("2", -1072.5, 0.0, ""),
    "Z": ("3", -781.0, 0.0, ""),
    "B": ("4", 0.0, 360.0, "kind: rotary, modulo: 360, "),
}
SINUMERIK = {
    "AX1": (0.0, 950.0, ""),
    "AX2": (-850.0, 0.0, ""),
    "AX3": (-650.0, 0.0, ""),
    "AX4": (0.0, 360.0, "kind: rotary, modulo: 360, "),
    "AX5": (-120.0, 120.0, "kind: rotary, "),
}
#: The names that the archive's machine data give its axes.
SINUMERIK_NAMES = {"AX1": "X1", "AX2": "Y1", "AX3": "Z1", "AX4": "C1", "AX5": "A1"}


def measured(low: float, high: float, unit: str, acting: dict[int, object]) -> str:
    """A test of 17 targets, three runs each way, of an error that the old table does not know, with
    lost motion above every backlash value of the two controls.
    """
    rng = np.random.default_rng(7)
    inner = np.linspace(low, high, 17)[1:-1] + rng.uniform(-0.01, 0.01, 15) * (high - low)
    x: Floats = np.round(np.concatenate([[low], inner, [high]]), 2)
    rows = [f"target_{unit},direction,run,deviation_{unit}"]
    for sign, mark in ((1, "+"), (-1, "-")):
        error = 0.007 * np.sin(2 * np.pi * (x - low) / (high - low)) + (0.006 if sign < 0 else 0)
        mean = error + acting[sign](x)  # type: ignore[operator]
        for run in (1, 2, 3):
            noisy = mean + rng.normal(0, 0.0004, x.size)
            rows += [f"{at:g},{mark},{run},{value:.6f}" for at, value in zip(x, noisy, strict=True)]
    return "\n".join(rows) + "\n"


def acting(control: object, address: str) -> dict[int, object]:
    return {
        sign: lambda x, way=way: control.correction(address, x, way)  # type: ignore[attr-defined]
        for sign, way in ((1, Direction.POSITIVE), (-1, Direction.NEGATIVE))
    }


@needs_backup
@pytest.mark.parametrize("axis", FANUC)
def test_the_numbers_of_the_real_fanuc_backup(axis: str, tmp_path: Path) -> None:
    address, low, high, words = FANUC[axis]
    old = {name: (FOLDER / name).read_bytes() for name in (PARAMETERS, PITCH)}
    for name, content in old.items():
        (tmp_path / name).write_bytes(content)
    kind = AxisKind.ROTARY if words else AxisKind.LINEAR
    control = virtual_control(
        "fanuc-30i", [ControlFile(*one) for one in old.items()], kinds={address: kind}, options={"detection_unit": 0.0001}
    )  # fmt: skip
    unit = kind.unit
    (tmp_path / "x.csv").write_text(measured(low, high, unit, acting(control, address)))
    (tmp_path / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: fanuc-30i}}\nstates: {{as_found: [{PARAMETERS},"
        f" {PITCH}]}}\naxes:\n  {axis}: {{travel: [{low:g}, {high:g}], address: {address},"
        f" {words}before: x.csv}}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    new = {name: (folder / name).read_bytes() for name in (PARAMETERS, PITCH)}
    first, last = (number_of(old[PARAMETERS], parameter, address) for parameter in (3621, 3622))
    for name, content in old.items():
        pairs = zip(content.splitlines(), new[name].splitlines(), strict=True)
        changed = [before for before, after in pairs if before != after]
        numbers = {int(line[1:6]) for line in changed}
        own = {1851, 1852, 3623} if name == PARAMETERS else {*range(10_000 + first, 10_001 + last)}
        assert numbers <= own
        assert name == PARAMETERS or numbers


def number_of(parameters: bytes, number: int, address: str) -> int:
    line = next(one for one in parameters.splitlines() if one.startswith(b"N%05dQ1" % number))
    found = re.search(rb"A%sP(\d+)" % address.encode(), line)
    assert found is not None
    return int(found[1])


@needs_archive
@pytest.mark.parametrize("axis", SINUMERIK)
def test_the_tables_of_the_real_sinumerik_archive(axis: str, tmp_path: Path) -> None:
    low, high, words = SINUMERIK[axis]
    texts = {"MD.INI": machine_data(), "AX_EEC.INI": eec_text()}
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="latin-1", newline="")
    files = [ControlFile(name, text.encode("latin-1")) for name, text in texts.items()]
    control = virtual_control("siemens-840d-sl", files, encoder={axis: 2})
    unit = "deg" if words else "mm"
    (tmp_path / "x.csv").write_text(measured(low, high, unit, acting(control, axis)))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: [MD.INI,"
        f" AX_EEC.INI]}}\naxes:\n  {axis}: {{travel: [{low:g}, {high:g}],"
        f" {words}before: x.csv}}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    folder = tmp_path / "job" / "tables" / "siemens-840d-sl"
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        f"{SINUMERIK_NAMES[axis]}_{kind}.INI" for kind in ("EEC", "MD")
    )
    entry = re.compile(rf"^(\$AA_ENC_COMP\w*\[1,(?:\d+,)?{axis}\])=([^\s;]+)", re.MULTILINE)
    small = (folder / f"{SINUMERIK_NAMES[axis]}_EEC.INI").read_text(encoding="latin-1")
    old, new = (dict(entry.findall(text)) for text in (texts["AX_EEC.INI"], small))
    assert old.keys() == new.keys()
    changed = [name for name in old if float(old[name]) != float(new[name])]
    assert changed
    assert all(name.startswith("$AA_ENC_COMP[") for name in changed)
    for path in folder.iterdir():
        text = path.read_text(encoding="latin-1")
        assigned = re.findall(r"^\$\w+\[([^\]]*)\]", text, re.MULTILINE)
        assert assigned
        assert {place.rsplit(",", 1)[-1] for place in assigned} == {axis}
