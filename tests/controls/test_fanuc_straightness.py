"""Squareness by straightness compensation (FANUC 5711, 5721, 5731 to 5734, 5761 to 5764, by path) in the
control's own files: B-63522EN/02 p. 222 for the lines between point numbers of the moving axis; that
a positive amount moves the compensated axis in + is unconfirmed, and said so.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from test_fanuc_backup_honoured import UNIT, Bench, Edits, said

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

ROWS = (5711, 5721, *range(5731, 5735), *range(5761, 5765))
REST: Edits = {(number, "L1"): "0" for number in ROWS}
AVAILABLE = ", options: {straightness: available}"
#: Y leaves the square by 40 µm/m over X.
CROSS = "cross: [{input: X, output: Y, positions: [-1000, 0], deviations: [40, 0], unit: um}]\n"


def whole_rows(bench: Bench, edits: Edits) -> None:
    """Put the parameters of the pair into the backup, each on its line for both paths."""
    text = bench.parameters
    for number in ROWS:
        line = f"N{number:05d}Q1L1P{edits.get((number, 'L1'), '0')}L2P0 "
        if re.search(rf"^N{number:05d}", text, re.MULTILINE):
            text = re.sub(rf"^N{number:05d}.*$", line, text, flags=re.MULTILINE)
        else:
            text = text.replace("N05861", f"{line}\nN05861", 1)
    bench.parameters = text
    (bench.folder / "CNC-PARA.TXT").write_text(text)


def run(bench: Bench, options: str = AVAILABLE, words: str = "") -> int:
    """A job of X and Y with the measurement between them; run twice, the second with it."""
    bench.run("X", "Y", options=options, axes={"X": words} if words else {})
    job = bench.folder / "job.yaml"
    job.write_text(job.read_text() + CROSS)
    return compwright(["run", str(job), "--force"])


def by_path(text: str, number: int) -> tuple[int, int]:
    found = re.search(rf"^N{number:05d}Q1L1P(-?\d+)L2P(-?\d+)", text, re.MULTILINE)
    assert found is not None
    return int(found[1]), int(found[2])


def test_the_line_stands_in_the_files_where_they_hold_its_parameters(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    whole_rows(bench, REST)
    assert run(bench) == 0
    parameters, _ = bench.written()
    values = {number: by_path(parameters, number) for number in ROWS}
    assert {second for _, second in values.values()} == {0}
    assert (values[5711][0], values[5721][0]) == (1, 2)
    reference = int(said(parameters, 3620, 1))
    interval = float(said(parameters, 3624, 1))
    places = [interval * (values[number][0] - reference) for number in range(5731, 5735)]
    assert places == [-1000.0, -1000.0, 0.0, 0.0]
    amounts = [values[number][0] * UNIT for number in range(5761, 5765)]
    # 40 µm at -1000, 0 at 0 are taken away, in 0.1 µm
    assert np.array(amounts) - amounts[2] == pytest.approx([-0.04, -0.04, 0, 0], abs=1e-9)
    card = (tmp_path / "job" / "card" / "card.md").read_text()
    assert f"5761 = {values[5761][0]}" in card
    assert "unconfirmed" in card
    out = tmp_path / "decoded.json"
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    words = ["--format", "fanuc-30i", "--option", "straightness=available", "--at=-1000,-500,0"]
    files = [str(file) for file in sorted(folder.iterdir())]
    assert compwright(["decode", *files, *words, "--json", str(out)]) == 0
    (between,) = json.loads(out.read_text())["cross"]
    assert (between["input"], between["output"]) == ("1", "2")
    assert between["correction"] == pytest.approx([-40, -20, 0], abs=0.2)


def test_a_second_visit_counts_what_is_there_and_uses_the_next_pair(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A pair that acts stays; without a further one at rest the line comes as a sheet."""
    acting = {**REST, (5711, "L1"): "1", (5721, "L1"): "3", (5731, "L1"): "15", (5732, "L1"): "15",
              (5733, "L1"): "40", (5734, "L1"): "40", (5761, "L1"): "50", (5762, "L1"): "50"}  # fmt: skip
    bench = Bench(tmp_path)
    whole_rows(bench, acting)
    assert run(bench) in (0, 1)
    parameters, _ = bench.written()
    assert [by_path(parameters, number)[0] for number in ROWS] == [
        int(acting[number, "L1"]) for number in ROWS
    ]
    # the sheet names the next pair; its line keeps 40 µm/m to the ends of the points 15 to 40
    sheet = (tmp_path / "job" / "card" / "straightness_X_Y.csv").read_text().splitlines()[2:]
    rows = {int(line.split(",")[0]): int(line.split(",")[1]) for line in sheet}
    assert list(rows) == [5712, 5722, *range(5741, 5745), *range(5771, 5775)]
    length = float(said(parameters, 3624, 1)) * (rows[5744] - rows[5741])
    assert (rows[5774] - rows[5771]) * UNIT == pytest.approx(40e-6 * length, abs=1.1 * UNIT)
    # the control's file has 5711 and its row, by path: what is missing is their place in the output
    shown = " ".join(capsys.readouterr().out.split())
    assert "parameters that this run does not write into the control's files" in shown
    assert "in no file" not in shown


def test_squareness_alone_leaves_the_pitch_data_next_to_the_parameters(tmp_path: Path) -> None:
    """The pitch data are a file of their own; without them the parameters cannot be read."""
    bench = Bench(tmp_path)
    whole_rows(bench, REST)
    run(bench)
    job = tmp_path / "job.yaml"
    job.write_text(re.sub(r"before: \[\w+\.csv\]", "before: []", job.read_text()))
    assert compwright(["run", str(job), "--out", str(tmp_path / "job"), "--force"]) == 0
    changed = (tmp_path / "job" / "card" / "changes.csv").read_text().splitlines()[1:]
    numbers = {line.partition("Q")[0] for line in changed}
    assert {"N05711", "N05721"} <= numbers <= {f"N0{number}" for number in range(5711, 5765)}
    assert len(numbers) == len(changed) >= 5
    assert {file.name for file in (tmp_path / "job" / "tables" / "fanuc-30i").iterdir()} == {
        "CNC-PARA.TXT",
        "PITCH.TXT",
    }


def test_where_every_pair_is_in_use_nothing_is_typed_over_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    text = bench.parameters
    for pair in range(3):
        points, amounts = 5731 + 10 * pair, 5761 + 10 * pair
        values = {5711 + pair: 1, 5721 + pair: 3}
        values |= {points: 15, points + 1: 15, points + 2: 40, points + 3: 40}
        values |= {amounts: 50, amounts + 1: 50, amounts + 2: 0, amounts + 3: 0}
        for number, value in values.items():
            text = re.sub(rf"^N{number:05d}Q.*\n", "", text, flags=re.MULTILINE)
            text = text.replace("N05861", f"N{number:05d}Q1L1P{value}L2P0\nN05861", 1)
    bench.parameters = text
    (tmp_path / "CNC-PARA.TXT").write_text(text)
    run(bench)
    assert "every pair of straightness compensation (5711 to 5713) is in use" in (
        " ".join(capsys.readouterr().out.split())
    )
    assert not (tmp_path / "job" / "card" / "straightness_X_Y.csv").exists()


@pytest.mark.parametrize(
    ("more", "named"),
    [("N05714Q1L1P2L2P0", "5714"), ("N05735Q1L1P20L2P0", "5735"), ("N13301Q1L1P5L2P0", "13301")],
)
def test_what_is_not_understood_is_refused_where_straightness_is_counted(
    more: str, named: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    whole_rows(bench, REST)
    file = tmp_path / "CNC-PARA.TXT"
    file.write_text(file.read_text().replace("N05861", f"{more}\nN05861", 1))
    assert bench.run("X", options=AVAILABLE) == 3
    assert f"parameter {named} of path 1" in capsys.readouterr().err


def test_without_the_option_nothing_is_written(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    whole_rows(bench, REST)
    assert run(bench, options="") == 1
    parameters, _ = bench.written()
    assert {by_path(parameters, number) for number in ROWS} == {(0, 0)}


def test_a_measurement_between_axes_in_a_state_in_which_it_differs_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Left alone it cancels only where it acted alike; counted, the difference is known."""
    acting = {**REST, (5711, "L1"): "1", (5721, "L1"): "2", (5731, "L1"): "15", (5732, "L1"): "15",
              (5733, "L1"): "40", (5734, "L1"): "40", (5761, "L1"): "50", (5762, "L1"): "50"}  # fmt: skip
    bench = Bench(tmp_path)
    whole_rows(bench, acting)
    old = bench.parameters.replace("N05761Q1L1P50", "N05761Q1L1P40")
    (tmp_path / "OLD.TXT").write_text(old)
    bench.run("X", "Y")
    job = tmp_path / "job.yaml"
    text = job.read_text().replace("states: {", "states: {old: [OLD.TXT, PITCH.TXT], ")
    job.write_text(text + CROSS.replace("input: X", "measured_in: old, input: X"))
    capsys.readouterr()
    assert compwright(["run", str(job), "--force"]) == 3
    told = capsys.readouterr().err
    assert "parameter 5761 of path 1" in told
    assert "straightness: available" in told
