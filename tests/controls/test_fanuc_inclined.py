"""A slope that whole increments hold badly goes into inclination compensation (FANUC 5861 to 5864,
5871 to 5874: B-63522EN/02 p. 222), where the job says that the control has it; what the files hold of
it is counted then, and so is the second table (14985 to 14987: A-78868E p. 6).

The virtual machine is that of test_fanuc_neighbour_functions: lines and sums by hand from the numbers.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
import test_fanuc_backup_honoured as plain
from test_fanuc_backup_honoured import Bench, Edits, said
from test_fanuc_neighbour_functions import INCLINED, NeighbourBench, cyclic, inclination

from compwright.cli import run as compwright
from compwright.records.axis import FloatArray

pytestmark = pytest.mark.short_estimate

#: 1 µm per pulse, and the parameters of the line at rest, as in the real backup.
COARSE: Edits = {
    (1820, "1"): "2",
    (3623, "1"): "1",
    **{(number, "1"): "0" for number in (*range(5861, 5865), *range(5871, 5875))},
}
LIMIT = 'increment_limit: "7"'
UNIT = 0.001


def steep(_axis: int, x: FloatArray, sign: int) -> FloatArray:
    """400 µm/m: 16 pulses in each section of 40 mm, more than twice what one increment holds."""
    return np.asarray(-4e-4 * x + 0.002 * np.sin(x / 140) + (0.004 if sign < 0 else 0.0))


@pytest.fixture
def steep_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plain, "error", steep)


def line(parameters: str, x: FloatArray) -> FloatArray:
    """The line by hand, at the points, 1 µm per pulse."""
    return 10.0 * inclination(1.0)(parameters, x)


def left_at_points(bench: Bench) -> float:
    """What is left at the points of the written table in both directions, mm; not at the ends,
    where half a section counts.
    """
    parameters, points = bench.written()
    x = np.arange(-960.0, -30.0, 40.0)
    rest = [
        steep(1, x, sign) + plain.added(parameters, points, 1, x, sign, unit=UNIT)
        + line(parameters, x)
        for sign in (1, -1)
    ]  # fmt: skip
    return float(np.ptp(rest))


@pytest.mark.usefixtures("steep_axis")
def test_a_steep_slope_goes_into_the_line_and_the_rest_into_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spacing = {"X": "table: {spacing: 40}"}
    benches = []
    for name, option in (("alone", ""), ("line", "inclination: available, ")):
        (tmp_path / name).mkdir()
        bench = Bench(tmp_path / name, COARSE, unit=UNIT, points={})
        assert bench.run("X", options=f", options: {{{option}{LIMIT}}}", axes=spacing) == 0
        benches.append(bench)
    alone, inclined = benches
    parameters, points = inclined.written()
    numbers = [int(said(parameters, number, 1)) for number in range(5861, 5865)]
    amounts = [int(said(parameters, number, 1)) for number in range(5871, 5875)]
    first, last = (int(said(parameters, number, 1)) for number in (3621, 3622))
    assert numbers == [first, first, numbers[3], numbers[3]]
    assert first < numbers[3] <= last
    assert amounts == [amounts[0], amounts[0], amounts[3], amounts[3]]
    # a whole number of pulses in each section: 16 of 40 mm by 400 µm/m
    assert amounts[3] - amounts[0] == 16 * (numbers[3] - numbers[0])
    assert int(said(parameters, 3623, 1)) == 1
    assert int(said(alone.written()[0], 3623, 1)) > 1
    assert max(map(abs, points.values())) <= 7
    assert left_at_points(inclined) < left_at_points(alone)
    assert left_at_points(inclined) < 0.003  # one pulse and the noise of 3 runs
    told = " ".join(capsys.readouterr().out.split()).partition("CW-P142")[2]
    found = re.search(r"([\d.]+) µm rms would be left without this line, and ([\d.]+) µm", told)
    assert found is not None
    before, after = map(float, found.groups())
    assert after < 0.9 * before
    card = (inclined.folder / "job" / "card" / "card.md").read_text()
    assert f"parameter 5871 of axis 1 = {amounts[0]}" in card
    assert "unconfirmed" in card
    sheet = (inclined.folder / "job" / "card" / "entry_X.csv").read_text()
    assert f"5871,,{amounts[0]}," in sheet


@pytest.mark.usefixtures("steep_axis")
def test_what_was_written_reads_back_and_compares(tmp_path: Path) -> None:
    bench = Bench(tmp_path, COARSE, unit=UNIT, points={})
    options = f", options: {{inclination: available, {LIMIT}}}"
    assert bench.run("X", options=options, axes={"X": "table: {spacing: 40}"}) == 0
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    parameters, points = bench.written()
    files = [str(file) for file in sorted(folder.iterdir())]
    out = tmp_path / "decoded.json"
    words = ["--format", "fanuc-30i", "--axis", "1", "--at=-1000:0:40", "--json", str(out)]
    assert compwright(["decode", *files, *words]) == 0
    decoded = json.loads(out.read_text())["axes"]["1"]
    x = np.array(decoded["positions"])
    hand = plain.added(parameters, points, 1, x, 1, unit=UNIT) + line(parameters, x)
    assert decoded["correction_positive"] == pytest.approx(1000 * hand, abs=1e-9)
    plan = str(tmp_path / "job" / "plan.json")
    loaded = [word for file in files for word in ("--loaded", file)]
    assert compwright(["compare", plan, *loaded]) == 0
    typed = str(tmp_path / "job" / "card" / "entry_X.csv")
    assert compwright(["compare", plan, "--loaded", typed]) == 0
    # the line forgotten, or of the other sign
    amount = said(parameters, 5871, 1)
    for other in ("0", amount.removeprefix("-")):
        (folder / "CNC-PARA.TXT").write_text(
            "\n".join(
                row.replace(f"A1P{amount}", f"A1P{other}")
                if row[:6] in ("N05871", "N05872")
                else row
                for row in parameters.split("\n")
            )
        )
        assert compwright(["compare", plan, *loaded]) == 1


@pytest.mark.usefixtures("steep_axis")
def test_without_files_the_line_stands_in_fresh_lines(tmp_path: Path) -> None:
    bench = Bench(tmp_path, COARSE, unit=UNIT, points={})
    bench.state = "none"
    bench.measure("X")
    bench.measure = lambda *_: None  # type: ignore[method-assign]
    text = (tmp_path / "X.csv").read_text()
    table = 0.004  # 1851 = 40 pulses acted in those readings: take it out
    rows = [row.split(",") for row in text.split("\n")[1:] if row]
    (tmp_path / "X.csv").write_text(
        "target_mm,direction,run,deviation_mm\n"
        + "".join(
            f"{x},{mark},{run},{float(value) + (10 * table if mark == '-' else 0):.6f}\n"
            for x, mark, run, value in rows
        )
    )
    options = (
        f", options: {{inclination: available, {LIMIT}, detection_unit: 0.001, first_point: 1}}"
    )
    assert bench.run("X", options=options, axes={"X": "table: {spacing: 40}"}) == 0
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    fresh = (folder / "PARAM_1.TXT").read_text()
    assert re.search(r"^N05861Q1A1P\d+$", fresh, re.MULTILINE)
    assert re.search(r"^N05874Q1A1P-?\d+$", fresh, re.MULTILINE)


def test_a_gentle_slope_stays_in_the_table_and_says_why(tmp_path: Path) -> None:
    """20 µm/m on 0.1 µm per pulse: nothing is lost by the table alone."""
    edits = {(number, "1"): "0" for number in (*range(5861, 5865), *range(5871, 5875))}
    bench = Bench(tmp_path, edits)
    assert bench.run("X", options=", options: {inclination: available}") == 0
    assert not {number for number, _ in bench.changed()} & set(range(5861, 5875))


@pytest.mark.parametrize("state", ["as_found", "old"])
def test_what_is_there_is_counted_and_stays(state: str, tmp_path: Path) -> None:
    """With the option the lines count: also for a test that was taken without them."""
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    measured = ""
    if state == "old":
        old = bench.parameters.replace("A1P-90", "A1P0").replace("A1P60A", "A1P0A")
        (tmp_path / "OLD.TXT").write_text(old)
        bench.beside = lambda _, x: inclination(1.0)(old, x)
        measured = ", measured_in: old"
    bench.run("X", options=", options: {inclination: available}")
    job = tmp_path / "job.yaml"
    text = job.read_text().replace("before: [X.csv]", f"before: {{files: X.csv{measured}}}")
    job.write_text(
        text.replace("states: {", "states: {old: [OLD.TXT, PITCH.TXT], ") if measured else text
    )
    assert compwright(["run", str(job), "--force"]) == 0
    bench.beside = inclination(1.0)
    assert not {number for number, _ in bench.changed()} & set(range(5861, 5875))
    assert bench.left("X") < 0.0055 + 0.0025  # the steps of 40 mm and those of the lines


def test_decode_shows_totals_with_lines_and_second_table(tmp_path: Path) -> None:
    edits = {**INCLINED, (14985, "1"): "400", (14986, "1"): "410", (14987, "1"): "4.0"}
    steps = dict(zip(range(401, 411), (10, 10, 10, -10, -10, -10, -10, -10, 10, 10), strict=True))
    bench = NeighbourBench(tmp_path, edits, points=plain.POINTS | steps)
    out = tmp_path / "decoded.json"
    files = [str(tmp_path / name) for name in ("CNC-PARA.TXT", "PITCH.TXT")]
    words = ["--format", "fanuc-30i", "--axis", "1", "--at=-1000:0:7", "--json", str(out)]
    assert compwright(["decode", *files, *words]) == 0
    document = json.loads(out.read_text())
    x = np.array(document["axes"]["1"]["positions"])
    hand = plain.added(bench.parameters, bench.points, 1, x, 1)
    hand += inclination(1.0)(bench.parameters, x) + cyclic(1.0)(bench.parameters, x)
    assert document["axes"]["1"]["correction_positive"] == pytest.approx(1000 * hand, abs=1e-9)
    facts = {entry["fact"]: entry["evidence"] for entry in document["assumed"]}
    for words_ in ("inclination compensation", "the second (cyclic) table"):
        assert facts[f"axis 1: {words_}"].startswith("unconfirmed")


@pytest.mark.parametrize(
    ("edits", "named"),
    [
        ({**INCLINED, (5862, "1"): "10"}, "5861 of axis 1 = 18"),
        ({(14985, "1"): "400", (14986, "1"): "410"}, "14985"),
        (
            {(14985, "1"): "400", (14986, "1"): "410", (14987, "1"): "4.0", (14988, "1"): "2"},
            "14988",
        ),
        ({(14985, "1"): "600", (14986, "1"): "603", (14987, "1"): "4.0"}, "14985"),
    ],
)
def test_what_cannot_be_counted_is_refused_by_name(
    edits: Edits, named: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Points not in order, a table without an interval, multiplied, or with a sum that creeps."""
    bench = NeighbourBench(tmp_path, edits, points=plain.POINTS | {601: 3})
    options = ", options: {inclination: available, cyclic: available}"
    assert bench.run("X", options=options) == 3
    assert f"parameter {named}" in capsys.readouterr().err
