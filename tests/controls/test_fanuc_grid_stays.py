"""The grid that is in a FANUC control stays: 3620 to 3622, 3624 and the point numbers, on small
copies of a real backup and on the backup itself.

What hangs on point numbers (inclination 5861 to 5874, straightness 5711 to 5764) does the same
before and after where no number moves: that is what these tests hold.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
import test_fanuc_backup_honoured
from test_fanuc_backup_honoured import AXES, POINTS, Bench, error, said

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

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
    bench = Bench(tmp_path, points=POINTS | {300: 7})
    assert bench.run(axis) == 0
    parameters, points = bench.written()
    assert grid(parameters, axis) == grid(bench.parameters, axis)
    first, last = (int(said(parameters, number, AXES[axis])) for number in (3621, 3622))
    moved = {number for number in points if points[number] != bench.points.get(number, 0)}
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


def test_a_table_that_is_switched_off_keeps_its_grid(tmp_path: Path) -> None:
    bench = Bench(tmp_path, {(3623, "1"): "0", (3623, "4"): "0"}, points={})
    for axis in "XB":
        assert bench.run(axis) == 0
        parameters, _ = bench.written()
        assert grid(parameters, axis) == grid(bench.parameters, axis)
        assert said(parameters, 3623, AXES[axis]) != "0"
        (tmp_path / "job").rename(tmp_path / f"done-{axis}")


@pytest.mark.parametrize(
    ("first", "reference", "last"), [(1, 26, 26), (10, 10, 37), (1, 20, 27)], ids=str
)
def test_a_reference_at_an_end_of_the_numbers_stays_there(
    first: int, reference: int, last: int, tmp_path: Path
) -> None:
    """3621 <= 3620 <= 3622, both equal signs: sections from -26 to 0, -1 to 27, -20 to 7 of 40 mm."""
    edits = {(3621, "1"): str(first), (3620, "1"): str(reference), (3622, "1"): str(last)}
    low, high = 40 * (first - 1 - reference), 40 * (last - reference)
    bench = Bench(tmp_path, {**edits, (1321, "1"): f"{low}.0", (1320, "1"): f"{high + 1}.0"})
    targets = np.linspace(low, high, 13).round()
    assert bench.run("X", axes={"X": f"travel: [{low}, {high}]"}, targets=targets) == 0
    parameters, points = bench.written()
    assert grid(parameters, "X") == grid(bench.parameters, "X")
    assert {n for n in points if points[n] != POINTS.get(n, 0)} <= {*range(first, last + 1)}


def test_a_rotary_axis_with_ends_gets_its_numbers_in_order(tmp_path: Path) -> None:
    """3621 = 3620 + 1 is known of an endless axis alone: with ends 3621 <= 3620 is written."""
    bench = Bench(tmp_path, {(1006, "4"): "00000011"})
    assert bench.run("B", axes={"B": "modulo: -"}) == 0
    parameters, _ = bench.written()
    assert [said(parameters, number, 4) for number in (3620, 3621, 3622)] == ["300", "300", "312"]
    assert float(said(parameters, 3624, 4)) == 30.0


def test_both_sets_keep_their_numbers(tmp_path: Path) -> None:
    edits = {(3605, "1"): "00000011", (3626, "1"): "500", (3627, "1"): "40"}
    bench = Bench(tmp_path, edits, points=POINTS | {n: POINTS.get(n - 499, 0) for n in range(500, 541)})  # fmt: skip
    axis = "table: {mode: bidirectional}"
    assert bench.run("X", axes={"X": axis}) == 0
    parameters, points = bench.written()
    assert grid(parameters, "X") == grid(bench.parameters, "X")
    assert said(parameters, 3605, 1)[-1] == "1"
    outside = {n for n in points if points[n] != bench.points.get(n, 0)}
    assert outside <= {*range(1, 42), *range(500, 541)}


def test_a_second_set_that_was_not_there_gets_numbers_and_the_first_stays(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X", axes={"X": "table: {mode: bidirectional}"}) == 0
    parameters, _ = bench.written()
    kept = (3620, 3621, 3622, 3624)
    assert grid(parameters, "X", kept) == grid(bench.parameters, "X", kept)
    assert int(said(parameters, 3626, 1)) == 42  # the first 41 numbers in a row that are free


def test_numbers_that_two_axes_share_are_left_to_the_other_one(tmp_path: Path) -> None:
    bench = Bench(
        tmp_path, {(3620, "2"): "40", (3621, "2"): "1", (3622, "2"): "41", (3623, "2"): "0"}
    )
    assert bench.run("X") == 0
    parameters, points = bench.written()
    numbers = {int(said(parameters, number, 1)) for number in (3621, 3622)}
    assert not numbers & {*range(1, 42)}
    assert float(said(parameters, 3624, 1)) == 40.0
    assert {n: points[n] for n in range(1, 42)} == {n: bench.points.get(n, 0) for n in range(1, 42)}


def test_an_interval_below_the_rule_for_its_feed_stays_and_is_told(tmp_path: Path) -> None:
    """400 000 mm/min / 7500 is 53 mm: the rule is from memory, and the machine has run with 40."""
    bench = Bench(tmp_path, {(1420, "1"): "400000.0"})
    assert bench.run("X") == 0
    assert grid(bench.written()[0], "X") == grid(bench.parameters, "X")
    assert "set `spacing: auto` in the table of the axis" in findings(bench, "X")["CW-F011"]


@pytest.mark.full_estimate
@pytest.mark.real_pages
def test_a_gain_is_offered_with_its_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # An error so large that the grid costs more than what differs from test to test.
    monkeypatch.setattr(test_fanuc_backup_honoured, "error", lambda *where: 2.0 * error(*where))
    bench = Bench(tmp_path)
    assert bench.run("B") == 0
    told = findings(bench, "B")["CW-P141"]
    numbers = re.findall(r"([\d.]+) arcsec at the same targets, ([\d.]+) arcsec at new", told)
    (same, new), (better, better_new) = numbers
    predicted = json.loads((tmp_path / "job" / "prediction.json").read_text())["axes"]["B"]
    assert float(same) == pytest.approx(predicted["predicted"]["A"]["median"], abs=0.006)
    assert float(new) == pytest.approx(predicted["predicted_new_targets"]["A"]["median"], abs=0.006)
    assert (
        "keeps the points of the existing table (13 points from 0 to 360 deg, every 30 deg)" in told
    )
    # The offer is what auto gives.
    assert (
        bench.run("B", axes={"B": "table: {spacing: auto}"}, options="") == 5
    )  # nothing is overwritten
    (tmp_path / "job").rename(tmp_path / "kept")
    assert bench.run("B", axes={"B": "table: {spacing: auto}"}) == 0
    chosen = json.loads((tmp_path / "job" / "prediction.json").read_text())["axes"]["B"]
    assert float(better) == pytest.approx(chosen["predicted"]["A"]["median"], abs=0.02)
    assert float(better_new) == pytest.approx(
        chosen["predicted_new_targets"]["A"]["median"], abs=0.02
    )
    assert "CW-P141" not in findings(bench, "B")
    report = (tmp_path / "kept" / "report.html").read_text()
    assert "CW-P141" in report


@pytest.mark.full_estimate
def test_no_offer_where_a_test_would_not_show_the_gain(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("Y") == 0
    assert "CW-P141" not in findings(bench, "Y")


def test_a_grid_over_a_part_of_the_travel_stays_and_says_what_it_costs(tmp_path: Path) -> None:
    """Numbers 25 to 41: -640 to 40 mm of -1000 to 0."""
    bench = Bench(tmp_path, {(3621, "1"): "25"})
    assert bench.run("X") == 0
    assert grid(bench.written()[0], "X") == grid(bench.parameters, "X")
    told = findings(bench, "X")
    assert "does not cover 360 mm of the travel" in told["CW-F001"]
    assert "CW-P141" in told


def test_less_than_half_of_the_travel_is_chosen_anew_with_the_reason(tmp_path: Path) -> None:
    bench = Bench(tmp_path, {(3621, "1"): "35"})
    assert bench.run("X") == 0
    told = findings(bench, "X")["CW-P140"]
    assert "8 points from -240 to 40 mm, every 40 mm" in told
    assert "covers less than half of the travel" in told
    assert bench.left("X") < 0.006
