"""Point numbers, sets and parameters of a FANUC that belong to somebody else, or to nobody: a new
table stays off numbers to which another function points, a change of 3605#0 is none of ours where
something hangs on the table, and the card says what the written files hold.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from test_fanuc_backup_honoured import POINTS, Bench, Edits, said
from test_fanuc_neighbour_functions import INCLINED, NeighbourBench, inclination

from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS

pytestmark = pytest.mark.short_estimate

#: A second table of axis 4 whose numbers lie among those that X claims (A-78868E page 6).
CYCLIC: Edits = {(14985, "4"): "22", (14986, "4"): "30", (14987, "4"): "2.0"}
ITS_POINTS = range(22, 31)


@pytest.mark.parametrize("table", ["", "table: {spacing: 20}"])
def test_a_table_that_was_off_is_put_beside_the_points_of_another_function(
    table: str, tmp_path: Path
) -> None:
    """A table that leaves its old numbers clears them, but for those of the other table."""
    bench = Bench(tmp_path, {(3623, "1"): "0", **CYCLIC})
    assert bench.run("X", axes={"X": table}) == 0
    parameters, points = bench.written()
    first, last = (int(said(parameters, number, 1)) for number in (3621, 3622))
    assert set(range(first, last + 1)).isdisjoint(ITS_POINTS)
    assert {n: points.get(n, 0) for n in ITS_POINTS} == {n: POINTS.get(n, 0) for n in ITS_POINTS}
    assert bench.left("X") < 0.03


def test_a_table_that_is_on_is_refused_by_the_parameter_that_points_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Bench(tmp_path, CYCLIC).run("X") == 3
    assert "parameter 14985 of axis 4" in capsys.readouterr().err


@pytest.mark.parametrize("amount", ["0", "40"])
def test_an_inclination_of_another_axis_names_sections_of_that_axis(
    amount: str, tmp_path: Path
) -> None:
    """5861 counts in the row of its own axis and holds no data: X shares nothing with it."""
    bench = Bench(tmp_path, {(5861, "3"): "20", (5864, "3"): "30", (5873, "3"): amount})
    assert bench.run("X") == 0
    assert bench.left("X") < 0.03


@pytest.mark.parametrize("number", [1, 11])
def test_the_second_set_is_held_against_other_functions_too(number: int) -> None:
    """Numbers 1 to 4, for travel in - 11 to 14."""
    lines = {3605: "00000001", 3620: 2, 3621: 1, 3622: 4, 3623: 1, 3624: "10.0", 3626: 11, 3627: 0}
    rows = [f"N{key:05d}Q1A1P{value}" for key, value in lines.items()]
    rows += [f"N14985Q1A2P{number}", f"N14986Q1A2P{number + 3}"]
    rows += [f"N{10000 + n}Q0P0" for n in (*range(1, 5), *range(11, 15))]
    file = ControlFile("ALL.TXT", "\n".join(["%", *rows, "%", ""]).encode())
    axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(-10.0, 20.0), address="1")
    control = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001})
    span = f"{number} to {number + 3}"
    with pytest.raises(InputError, match=f"another function uses its point numbers {span}"):
        control.read([file], [axis])


@pytest.mark.parametrize("turn", ["0.0", "360.0"])
def test_the_card_says_the_turn_that_the_written_file_holds(turn: str, tmp_path: Path) -> None:
    """B of a real backup lives with 3625 = 0: nobody shall type 360 there on the card's word."""
    bench = Bench(tmp_path, {(3625, "4"): turn})
    assert bench.run("B") == 0
    parameters, _ = bench.written()
    held = float(said(parameters, 3625, 4))
    assert held == float(turn)
    card = (tmp_path / "job" / "card" / "card.md").read_text()
    assert [float(value) for value in re.findall(r"3625 = ([0-9.]+)", card)] == [held]


# --- what hangs on the table
# --------------------------------------------------------------------------------------------------


def test_one_set_of_data_stays_one_where_something_hangs_on_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No page says whether inclination acts beside two sets as beside one."""
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    assert bench.run("X", axes={"X": "table: {mode: bidirectional}"}) == 4
    told = " ".join(capsys.readouterr().err.split())
    assert "parameter 5861 of axis 1" in told
    assert "3605#0 would change from 0 to 1" in told
    assert not (tmp_path / "job" / "tables").exists()
    assert bench.run("X", axes={"X": "table: {mode: single}"}) == 0


def test_two_sets_without_anything_beside_them_are_written(tmp_path: Path) -> None:
    assert Bench(tmp_path).run("X", axes={"X": "table: {mode: bidirectional}"}) == 0


def test_a_finer_grid_that_needs_the_old_ends_is_told_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """3620 = 40, 3621 = 1, 3622 = 41, 3624 = 40 mm. By the manual the point at the negative end has
    the number 3620 - travel/3624 + 1: 40 intervals of 40 mm below the reference, one above.
    """
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    assert bench.run("X", axes={"X": "table: {spacing: 20, start: -200, end: 0}"}) == 4
    told = " ".join(capsys.readouterr().err.split())
    found = re.search(r"table: \{(start: \S+, end: \S+?)\}, the old ends", told)
    assert found is not None, told
    assert found[1] == "start: -1600, end: 40"
    assert bench.run("X", axes={"X": f"table: {{spacing: 20, {found[1]}}}"}) == 0
