"""Cards beside a control of the judge's own: numbers and files that they name are those of the files.

The check positions say what the control adds there; the control, loaded with what was written, adds
exactly that.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from harm_bridges import BRIDGES, TABLE, Bridge
from harm_columns import load, prepare
from harm_command import card_of, command, tables_of
from harm_fanuc import Backup, Fanuc, Pitch
from harm_measuring import Axis, Correction, measure, write_csv

pytestmark = pytest.mark.short_estimate

_ROW = re.compile(r"^\| *([−-]?[\d.]+) *\| *([+−-]) *\| *([−-]?[\d.]+) *\|", re.MULTILINE)
_FILE = re.compile(r"\b[\w-]+\.(?:INI|TXT|NC|comp|ini|pmc|lis|csv|MPF|SPF)\b")


def number(text: str) -> float:
    return float(text.replace("−", "-"))


def shown(card: str) -> Iterator[tuple[float, int, float]]:
    """Give the check positions: position, direction, what the control adds in µm."""
    for position, direction, adds in _ROW.findall(card):
        yield number(position), 1 if direction == "+" else -1, number(adds)


def compare(card: str, correction: Correction) -> None:
    rows = list(shown(card))
    assert len(rows) >= 4
    for position, direction, adds in rows:
        assert 1000 * correction(position, direction) == pytest.approx(adds, abs=0.01)


def files_and_steps(folder: Path, given: set[str]) -> None:
    """Each file that the steps name is there, and each file to load is named in a step."""
    card = card_of(folder)
    steps = "## Steps" + card.split("## Steps", 1)[1].split("\n## ", 1)[0]
    there = {path.name for path in folder.rglob("*") if path.is_file()} | given
    named = set(_FILE.findall(steps))
    assert named <= there, named - there
    for path in tables_of(folder):
        assert path.name in named or path.parent.name in steps or "tables/" in steps, path.name


@pytest.mark.parametrize("make", BRIDGES.values(), ids=BRIDGES)
def test_the_control_adds_what_the_card_says(make: type[Bridge], tmp_path: Path) -> None:
    bridge = make()
    answer = command("run", prepare(tmp_path, bridge, TABLE, ""))
    assert answer.code == 0, answer.first
    load(bridge, tmp_path / "job")
    compare(card_of(tmp_path / "job"), bridge.correction(bridge.lead))
    files_and_steps(tmp_path / "job", {path.name for path in tmp_path.iterdir()})


#: Grids of one FANUC axis: reference at either end or within, sections beyond the travel.
GRIDS = {
    "reference at the upper end": (
        Pitch(40, 28, 50.0, [-3, -2, -4, -1, -2, -3, -1, 0, -2, -3, -1, -2, 0], 2),
        -600.0,
        0.0,
    ),
    "reference is the last point": (
        Pitch(40, 29, 50.0, [-2, -4, -1, -2, -3, -1, 0, -2, -3, -1, -2, -5], 2),
        -600.0,
        0.0,
    ),
    "reference at the lower end": (
        Pitch(40, 40, 50.0, [0, -3, -2, -4, -1, -2, -3, -1, 0, -2, -3, -1, -2], 2),
        0.0,
        600.0,
    ),
    "reference within": (
        Pitch(40, 33, 50.0, [-1, 0, 2, -1, 3, 1, 0, -1, 2, 1, 0, -1, -2], 2),
        -350.0,
        250.0,
    ),
    "magnification 10": (
        Pitch(40, 33, 50.0, [0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, 0, 0], 2, magnification=10),
        -350.0,
        250.0,
    ),
    "points beyond both ends": (
        Pitch(40, 30, 50.0, [4, 4, -1, 2, -1, 0, 1, -1, 2, 1, 0, -1, 1, 2, 9, 7, -8], 2),
        -350.0,
        250.0,
    ),
}


@pytest.mark.parametrize("case", GRIDS)
def test_a_fanuc_card_holds_the_numbers_of_its_files(case: str, tmp_path: Path) -> None:
    pitch, low, high = GRIDS[case]
    backup = Backup({1: pitch}, low=low, high=high)
    control = Fanuc()
    for name, text in (("CNC-PARA.TXT", backup.parameters()), ("PITCH.TXT", backup.points())):
        (tmp_path / name).write_text(text, encoding="utf-8")
        control.load(text)
    machine = Axis(low, high, slope=60)
    before = measure(machine, lambda x, d: control.correction(1, x, d))
    write_csv(tmp_path / "x.csv", "X", before)
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: fanuc-30i}\n"
        "states: {as_found: [CNC-PARA.TXT, PITCH.TXT]}\n"
        f"axes:\n  X: {{travel: [{low}, {high}], address: 1, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    answer = command("run", tmp_path / "job.yaml")
    assert answer.code == 0, answer.first
    for path in tables_of(tmp_path / "job"):
        control.load(path.read_text(encoding="utf-8"))
    assert measure(machine, lambda x, d: control.correction(1, x, d), seed=3).A() < before.A()
    card = card_of(tmp_path / "job")
    compare(card, lambda x, d: control.correction(1, x, d))
    step = card[card.index("3620 = ") :].split("\n- [ ]", 1)[0]
    for point, held in re.findall(r"[Pp]oint (\d+) holds (-?\d+)", card):
        assert control.data[int(point)] == int(held)
    for parameter, value in re.findall(r"\b(36\d\d|1851) = (-?[\d.]+)(?<!\.)", step):
        assert control.number(int(parameter), 1) == float(value), parameter
    for row, new in re.findall(r"^\| N1(\d{4})Q0 *\| *-?\d+ *\| *(-?\d+) *\|", card, re.MULTILINE):
        assert control.data[int(row)] == int(new)
    sheet = (tmp_path / "job" / "card" / "entry_X.csv").read_text(encoding="utf-8")
    for entry, place, value in re.findall(r"^(\d+),([^,]*),(-?[\d.]+),", sheet, re.MULTILINE):
        if int(entry) < 10000:
            assert control.number(int(entry), 1) == float(value)
            continue
        assert control.data[int(entry) - 10000] == int(value)
        assert float(place) == (int(entry) - 10040) * pitch.interval
