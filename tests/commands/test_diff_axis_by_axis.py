"""diff and compare where one axis of a control cannot be read: every other axis is told all the
same, and no axis is told by the fault of another.

A backup of four axes (`fanuc_backup`): X 37 to 44, Y 100 to 104, B 200 to 208; 0.001 mm. A second,
cyclic table (FANUC A-78868E p3: its values stand in the array of all axes, from 14985 to 14986) of
axis 4 that is set over the numbers of X makes X unreadable, and axis 4 as its interval is missing.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from fanuc_backup import parameters, pitch_data
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

Files = dict[str, str]
MACHINE = Machine(low=-200, high=200, slope=40e-6, bow=0.006, lost=0.005)
CYCLIC = "N14985Q1A4P37\nN14986Q1A4P44\n%"


def backup() -> Files:
    return {"CNC-PARA.TXT": parameters(lines=50), "PITCH.TXT": pitch_data()}


def put(files: Files, old: str, new: str) -> Files:
    assert sum(text.count(old) for text in files.values()) == 1, old
    return {name: text.replace(old, new) for name, text in files.items()}


def over_x(files: Files) -> Files:
    """Axis 4 gets a second table over the numbers of X."""
    text = files["CNC-PARA.TXT"].rstrip()
    assert text.endswith("%")
    return {**files, "CNC-PARA.TXT": text[:-1] + CYCLIC + "\n"}


def written(folder: Path, files: Files) -> Path:
    folder.mkdir()
    for name, text in files.items():
        (folder / name).write_text(text)
    return folder


def answer(folder: Path, words: list[str]) -> tuple[int, dict[str, Any]]:
    path = folder / "answer.json"
    code = compwright([*words, "--json", str(path)])
    return code, json.loads(path.read_text())


def diff_words(folder: Path, new: Files) -> list[str]:
    old, other = written(folder / "old", backup()), written(folder / "new", new)
    words = ["diff", str(old), "--with", str(other), "--format", "fanuc-30i"]
    return [*words, "--option", "detection_unit=0.001"]


def test_an_odd_axis_hides_no_other_from_diff(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Point 101 of Y one step less, magnification 2: 2 µm; X by its entries alone."""
    changed = put(over_x(backup()), "N10101Q0P3\n", "N10101Q0P2\n")
    changed = put(changed, "N10039Q0P-2\n", "N10039Q0P-3\n")
    words = diff_words(tmp_path, changed)
    code, found = answer(tmp_path, words)
    assert (code, found["corrections_compared"]) == (1, False)
    axes = found["axes"]
    assert {each: axis["correction_compared"] for each, axis in axes.items()} == {
        "1": False, "2": True, "4": False,
    }  # fmt: skip
    assert abs(axes["2"]["correction"]["max_change_um"]) == pytest.approx(2.0)
    assert (axes["1"]["correction"], axes["4"]["correction"]) == (None, None)
    told = [one["message"] for one in found["findings"] if one["code"] == "CW-S080"]
    assert [message.split()[:4] for message in told] == [
        ["NEW:", "for", "axis", f"{axis},"] for axis in ("1", "4")
    ]
    assert "14985" in told[0]
    capsys.readouterr()
    assert compwright(words) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "axis 1 (X): only its entries are compared" in said
    assert "axis 2 (Y): the correction changes by up to" in said


def test_an_axis_that_is_off_is_told_beside_an_odd_one(tmp_path: Path) -> None:
    """Z has no table (3623 = 0): its backlash is all that it does, 1 µm more."""
    changed = put(over_x(backup()), "N01851Q1A1P4A2P2A3P6A4P0", "N01851Q1A1P4A2P2A3P7A4P0")
    _, found = answer(tmp_path, diff_words(tmp_path, changed))
    assert abs(found["axes"]["3"]["correction"]["max_change_um"]) == pytest.approx(1.0)


@pytest.fixture(scope="module")
def planned(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A plan with tables of X, Y and Z, on a backup with no tables (3623 = 0)."""
    folder = tmp_path_factory.mktemp("planned")
    old = put(backup(), "N03623Q1A1P1A2P2A3P0A4P1", "N03623Q1A1P0A2P0A3P0A4P1")
    old = put(old, "N01851Q1A1P4A2P2A3P6A4P0", "N01851Q1A1P0A2P0A3P0A4P0")
    old = put(old, "N01852Q1A1P4A2P2A3P6A4P0", "N01852Q1A1P0A2P0A3P0A4P0")
    old = {
        **old,
        "CNC-PARA.TXT": old["CNC-PARA.TXT"]
        .replace("A1P210.0", "A1M210.0")
        .replace("A1M210.0A2M410.0A3M5.0", "A1M210.0A2M210.0A3M210.0")
        .replace("A1M-210.0A2M-10.0A3M-500.0", "A1M-210.0A2M-210.0A3M-210.0"),
    }
    written(folder / "control", old)
    targets = MACHINE.targets()
    axes = []
    for number, name in enumerate("XYZ", start=1):
        machine = replace(MACHINE, slope=number * MACHINE.slope, bow=(2 - number) * MACHINE.bow)
        text = csv_of(targets, machine.measure(targets, number), name)
        (folder / f"{name}.csv").write_text(text)
        axes.append(
            f"  {name}: {{address: {number}, travel: [-200, 200], table: {{spacing: 50}},"
            f" before: [{name}.csv]}}"
        )
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: fanuc-30i, options: {detection_unit: 0.001}}\n"
        "states: {as_found: [control]}\naxes:\n" + "\n".join(axes) + "\n"
    )
    assert compwright(["run", str(folder / "job.yaml"), "--out", str(folder / "out")]) == 0
    return folder / "out"


def loaded(planned: Path) -> Files:
    folder = planned / "tables" / "fanuc-30i"
    return {path.name: path.read_text() for path in folder.iterdir()}


def test_an_odd_axis_hides_no_other_from_compare(planned: Path, tmp_path: Path) -> None:
    own = loaded(planned)
    first = int(own["CNC-PARA.TXT"].split("N03621Q1A1P")[1].split("A2P")[0])
    own["CNC-PARA.TXT"] = own["CNC-PARA.TXT"].rstrip()[:-1] + (
        f"N14985Q1A4P{first}\nN14986Q1A4P{first + 7}\n%\n"
    )
    place = written(tmp_path / "back", own)
    code, found = answer(tmp_path, ["compare", str(planned / "plan.json"), "--loaded", str(place)])
    assert (code, found["verdict"]) == (1, "different")
    told = {name: axis["verdict"] for name, axis in found["axes"].items()}
    assert told == {"X": "unreadable", "Y": "loaded", "Z": "loaded"}
    assert "axis 1" in found["axes"]["X"]["message"]


def test_each_axis_is_refused_by_its_own_fault(planned: Path, tmp_path: Path) -> None:
    """The last point of X and that of Z were not read back; a point of Y was changed."""
    own = loaded(planned)
    points = own["PITCH.TXT"].split("\n")
    for number, value in ((1, None), (2, 99), (3, None)):
        last = own["CNC-PARA.TXT"].split("N03622Q1")[1].split(f"A{number}P")[1].split("A")[0]
        record = f"N{10000 + int(last)}Q0P"
        points = [
            f"{record}{value}" if line.startswith(record) else line
            for line in points
            if value is not None or not line.startswith(record)
        ]
    place = written(tmp_path / "back", {**own, "PITCH.TXT": "\n".join(points)})
    _, found = answer(tmp_path, ["compare", str(planned / "plan.json"), "--loaded", str(place)])
    axes = found["axes"]
    assert [axes[name]["verdict"] for name in "XYZ"] == ["unreadable", "other", "unreadable"]
    assert "axis 1" in axes["X"]["message"]
    assert "axis 3" in axes["Z"]["message"]
    assert "axis 1" not in axes["Z"]["message"]
