"""Exports of a SINUMERIK with several active axes, and the card followed on a control that protects.

Some controls skip a protected line, some stop the file there. Either way the axis under work ends
with what was planned, and its neighbours do what they did.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from harm_command import card_of, document, tables_of
from harm_following import follow
from harm_measuring import Axis, Correction, measure, write_csv
from harm_sinumerik import Control, grid_of


@dataclass(frozen=True)
class Held:
    """One axis of the control: table in mm (errors), switch, backlash, measuring system."""

    address: str
    slope: float
    on: int = 1
    backlash: float = 0.002
    system: int = 0

    def table(self) -> list[str]:
        rows = [
            f"$AA_ENC_COMP[{self.system},{i},{self.address}]={self.slope * i / 1000:.4f}"
            for i in range(7)
        ]
        return rows + grid_of(self.address, 7, 0.0, 100.0, self.system)

    def data(self) -> list[str]:
        key = f"[{self.system},{self.address}]"
        return [
            f"N32450 $MA_BACKLASH{key}={self.backlash}",
            f"N32700 $MA_ENC_COMP_ENABLE{key}={self.on}",
            f"N38000 $MA_MM_ENC_COMP_MAX_POINTS{key}=20",
        ]


def file(*parts: Sequence[str]) -> str:
    return "\n".join(["CHANDATA(1)", *(row for part in parts for row in part), "M17"]) + "\n"


X, Y, Z = Held("AX1", -3.0), Held("AX2", -5.0), Held("AX3", 4.0)
CROSS = [
    *(f"$AN_CEC[0,{i}]={value}" for i, value in enumerate((0.0, 0.004, 0.011))),
    "$AN_CEC_INPUT_AXIS[0]=(AX2)",
    "$AN_CEC_OUTPUT_AXIS[0]=(AX3)",
    "$AN_CEC_STEP[0]=300.0",
    "$AN_CEC_MIN[0]=0.0",
    "$AN_CEC_MAX[0]=600.0",
    "$AN_CEC_DIRECTION[0]=0",
    "$AN_CEC_MULT_BY_TABLE[0]=0",
    "$AN_CEC_IS_MODULO[0]=0",
]


def separate(*axes: Held) -> dict[str, str]:
    """Tables in one file, machine data in another: the usual export."""
    return {
        "AX_EEC.INI": file(*(axis.table() for axis in axes)),
        "MD.INI": file(*(axis.data() for axis in axes)),
    }


def holding(files: Mapping[str, str], *, stops: bool) -> Control:
    control = Control(stops=stops)
    for text in files.values():
        control.load(text)
    control.reset()
    return control


def added(control: Control, address: str, system: int) -> Correction:
    """Give what this control adds to one axis."""
    return lambda x, d: control.correction(address, x, d, system)


def acts(control: Control, skip: Sequence[Held]) -> dict[str, str]:
    """Give everything that the control holds of other axes, switches included."""
    mine = {axis.address for axis in skip}
    return {
        name: str(value)
        for name, value in control.memory.items()
        if not mine & set(re.findall(r"\w+", name.partition("[")[2]))
    }


def prepare(folder: Path, files: Mapping[str, str], axes: Sequence[Held], options: str) -> Path:
    control = holding(files, stops=False)
    rows = []
    for k, axis in enumerate(axes):
        machine = Axis(slope=52 + 9 * k, lost=6 + k, bow=6 - k)
        readings = measure(machine, added(control, axis.address, axis.system), seed=k + 1)
        name = f"Q{axis.address}"
        write_csv(folder / f"{name}.csv", name, readings)
        system = f", encoder: {{system: {axis.system + 1}}}" if axis.system else ""
        rows.append(
            f"  {name}: {{travel: [0, 600], address: {axis.address}, before: [{name}.csv]{system}}}"
        )
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    path = folder / "job.yaml"
    path.write_text(
        f"compwright: 1\ncontroller: {{format: siemens-840d-sl{options}}}\n"
        f"states: {{as_found: {state_of(files, axes)}}}\naxes:\n" + "\n".join(rows) + "\n",
        encoding="utf-8",
    )
    return path


def state_of(files: Mapping[str, str], axes: Sequence[Held]) -> str:
    names = f"[{', '.join(files)}]"
    return names if all(axis.on for axis in axes) else f"{{files: {names}, active: no}}"


def judge(folder: Path, files: Mapping[str, str], axes: Sequence[Held]) -> None:
    """Follow the card on both kinds of control, and measure every axis under work."""
    results = folder / "job"
    written = {path.name: path.read_text(encoding="utf-8") for path in tables_of(results)}
    predicted = document(results, "prediction.json")["axes"]
    for stops in (False, True):
        control = holding(files, stops=stops)
        neighbours = acts(control, axes)
        assert not follow(card_of(results), written, control), (
            "the card names a file that is not there"
        )
        assert not control.alarms
        assert acts(control, axes) == neighbours
        for k, axis in enumerate(axes):
            machine = Axis(slope=52 + 9 * k, lost=6 + k, bow=6 - k)
            after = measure(machine, added(control, axis.address, axis.system), seed=20)
            band = predicted[f"Q{axis.address}"]["predicted"]["A"]
            assert after.A() < 1.5 * band["p95"], (axis.address, stops, after.A())
