"""What acts on an axis of a FANUC beside its table and stays: it cancels whatever its sign and its
unit, as long as the grid on which it hangs does the same.

The virtual machine is that of test_fanuc_backup_honoured, with the other function added by hand:
inclination is three straight lines through the point numbers 5861 to 5864, put out at the points
(FANUC B-63522EN/02 p. 222), the second table repeats over its own interval (A-78868E p. 6). Both
are tried with either sign and with two units, because no page says them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest
import test_fanuc_backup_honoured as plain
from test_fanuc_backup_honoured import SMALL, UNIT, Bench, Edits, said

from compwright.cli import run as compwright
from compwright.records.axis import FloatArray

pytestmark = pytest.mark.short_estimate

#: What acts beside the table at x, mm, by the parameters that are in the control.
Beside = Callable[[str, FloatArray], FloatArray]

INCLINED: Edits = {
    (5861, "1"): "18", (5862, "1"): "24", (5863, "1"): "30", (5864, "1"): "38",
    (5871, "1"): "-90", (5872, "1"): "60", (5873, "1"): "10", (5874, "1"): "-40",
}  # fmt: skip


def inclination(factor: float) -> Beside:
    def at(parameters: str, x: FloatArray) -> FloatArray:
        reference, first, last = (int(said(parameters, n, 1)) for n in (3620, 3621, 3622))
        node = np.floor(x / float(said(parameters, 3624, 1)) + 0.5)
        node = np.clip(node + reference, first - 1, last)
        at = [float(said(parameters, number, 1)) for number in range(5861, 5865)]
        amounts = [float(said(parameters, number, 1)) for number in range(5871, 5875)]
        lines = np.interp(np.append(node, reference), at, amounts)
        return np.asarray(factor * UNIT * (lines[:-1] - lines[-1]))

    return at


def cyclic(factor: float) -> Beside:
    """10 numbers from 401 over 10 x 4.0 mm."""

    def at(parameters: str, x: FloatArray) -> FloatArray:
        assert said(parameters, 14985, 1) == "400"
        steps = np.cumsum([0, 10, 10, 10, -10, -10, -10, -10, -10, 10, 10])
        return np.asarray(factor * UNIT * steps[np.floor(np.mod(x, 40.0) / 4.0 + 0.5).astype(int)])

    return at


def nothing(_parameters: str, x: FloatArray) -> FloatArray:
    return np.zeros_like(x)


class NeighbourBench(Bench):
    """A bench on which something acts beside the table."""

    def __init__(
        self,
        folder: Path,
        edits: Edits,
        beside: Beside = nothing,
        *,
        points: Mapping[int, int] | None = plain.POINTS,
    ) -> None:
        super().__init__(folder, edits, points=points)
        self.beside = beside

    def measure(self, name: str, targets: FloatArray | None = None) -> None:
        kept = plain.error
        try:
            plain.error = lambda axis, x, sign: (
                kept(axis, x, sign) + self.beside(self.parameters, x)
            )
            super().measure(name, targets)
        finally:
            plain.error = kept

    def left(self, name: str) -> float:
        x = np.linspace(*plain.TRAVEL[name], 301)
        parameters, points = self.written()
        axis = plain.AXES[name]
        return float(
            np.ptp(
                [
                    plain.error(axis, x, sign)
                    + plain.added(parameters, points, axis, x, sign)
                    + self.beside(parameters, x)
                    for sign in (1, -1)
                ]
            )
        )


STAYS = {"X": "table: {spacing: 40}"}
#: Three runs with 0.3 µm of noise at 13 targets, mm.
NOISE = 0.001


def plainly_left(folder: Path, spacing: int) -> float:
    """What is left of the axis by the steps of its table, with nothing beside it, mm."""
    folder = folder / f"plain{spacing}"
    folder.mkdir()
    bench = Bench(folder)
    assert bench.run("X", axes={"X": f"table: {{spacing: {spacing}}}"}) == 0
    return bench.left("X")


#: Parameters and the first that has to be named.
LEFT_ALONE: dict[str, tuple[Edits, str]] = {
    "inclination": ({(5861, "1"): "5", (5871, "1"): "7"}, "5871"),
    "second cyclic table": (
        {(14985, "1"): "400", (14986, "1"): "410", (14987, "1"): "2.0"},
        "14985",
    ),
    "straightness, moving": (
        {(5711, "L1"): "1", (5721, "L1"): "2", (5731, "L1"): "1", (5761, "L1"): "5"},
        "5711",
    ),
    "straightness, bent": (
        {(5711, "L1"): "2", (5721, "L1"): "1", (5731, "L1"): "101", (5761, "L1"): "5"},
        "5721",
    ),
    "further straightness": ({(13391, "L1"): "3"}, "13391"),
    "three-dimensional": ({(10800, "L1"): "1"}, "10800"),
    "smooth backlash": ({(1848, "1"): "3"}, "1848"),
}


@pytest.mark.parametrize("what", LEFT_ALONE)
def test_what_stays_is_named_and_stops_nothing(
    what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edits, named = LEFT_ALONE[what]
    bench = Bench(tmp_path, edits)
    assert bench.run("X", axes=STAYS) == 0
    assert f"parameter {named}" in " ".join(capsys.readouterr().out.split())
    assert {number for number, _ in bench.changed()} <= {1851, 1852, 3621, 3622, 3623}


@pytest.mark.parametrize("factor", [1.0, -1.0, 10.0])
def test_inclination_cancels_whatever_its_sign_and_unit(
    factor: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = NeighbourBench(tmp_path, INCLINED, inclination(factor))
    assert bench.run("X", axes=STAYS) == 0
    # the steps of the lines themselves stay: 25 units of 0.1 µm between two points
    assert bench.left("X") < plainly_left(tmp_path, 40) + abs(factor) * 25 * UNIT + NOISE
    changed = {number for number, _ in bench.changed()}
    assert not changed & {*range(5861, 5865), *range(5871, 5875), 3620, 3623, 3624}
    shown = capsys.readouterr().out
    assert "CW-S048" in shown
    assert "parameter 5871 of axis 1 = -90" in " ".join(shown.split())


def test_a_finer_grid_takes_the_numbers_of_the_inclination_with_it(tmp_path: Path) -> None:
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    assert bench.run("X", axes={"X": "table: {spacing: 20}"}) == 0
    parameters, _ = bench.written()
    reference = int(said(parameters, 3620, 1))
    moved = [int(said(parameters, number, 1)) for number in range(5861, 5865)]
    assert [20 * (number - reference) for number in moved] == [
        40 * (number - 40) for number in (18, 24, 30, 38)
    ]
    assert {number for number, _ in bench.changed()} & set(range(5871, 5875)) == set()
    # its new steps, and half an old one that the readings held at the targets
    assert bench.left("X") < plainly_left(tmp_path, 20) + (13 + 0.5 * 25) * UNIT + NOISE
    card = (tmp_path / "job" / "card" / "card.md").read_text()
    for number, value in zip(range(5861, 5865), moved, strict=True):
        assert f"parameter {number} of axis 1 = {value}" in card
    assert "parameter 5871 of axis 1 = -90" in card  # what is left as it is


@pytest.mark.parametrize(
    ("edits", "spacing", "named"),
    [
        (INCLINED, 30, "parameter 5861 of axis 1 = 18"),
        ({**INCLINED, (5864, "1"): "60"}, 20, "parameter 5864 of axis 1 = 60"),
        ({(14985, "1"): "400", (14986, "1"): "410", (14987, "1"): "4.0"}, 20, "14985"),
        ({(5714, "L1"): "1"}, 20, "5714"),
        ({(13391, "L1"): "3"}, 20, "13391"),
        ({(10800, "L1"): "1"}, 20, "10800"),
        ({(5711, "L1"): "1", (5731, "L1"): "20", (5735, "L1"): "30"}, 20, "5711"),
    ],
)
def test_a_grid_that_cannot_take_it_along_is_refused_by_name(
    edits: Edits, spacing: int, named: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No node at the old position; beyond the old grid, where the line went on unseen; numbers that
    are not known.
    """
    bench = NeighbourBench(tmp_path, edits)
    assert bench.run("X", axes={"X": f"table: {{spacing: {spacing}}}"}) == 4
    told = capsys.readouterr().err
    assert named in told
    assert "leave `spacing`, `start` and `end` out of `table`" in told


def test_a_table_that_is_off_does_not_wake_what_stands_beside_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = NeighbourBench(tmp_path, {**INCLINED, (3623, "1"): "0"})
    assert bench.run("X", axes=STAYS) == 4
    told = capsys.readouterr().err
    assert "parameter 5861 of axis 1 = 18" in told
    assert "its table is off" in told


@pytest.mark.parametrize("factor", [1.0, -1.0])
def test_the_second_table_cancels(factor: float, tmp_path: Path) -> None:
    edits = {(14985, "1"): "400", (14986, "1"): "410", (14987, "1"): "4.0"}
    steps = dict(zip(range(401, 411), (10, 10, 10, -10, -10, -10, -10, -10, 10, 10), strict=True))
    bench = NeighbourBench(tmp_path, edits, cyclic(factor), points=plain.POINTS | steps)
    # whole periods apart: what repeats within a section looks like nothing to the test
    assert bench.run("X", axes=STAYS, targets=np.arange(-1000.0, 1.0, 40.0)) == 0
    _, points = bench.written()
    assert {number: points[number] for number in steps} == steps
    # what repeats within a section cannot be in the table: it stays as it was
    own = float(np.ptp(cyclic(factor)(bench.parameters, np.linspace(-1000, 0, 1001))))
    assert bench.left("X") < plainly_left(tmp_path, 40) + own + NOISE


def test_a_second_table_in_the_numbers_of_its_own_axis_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edits = {(14985, "1"): "10", (14986, "1"): "20", (14987, "1"): "4.0"}
    assert NeighbourBench(tmp_path, edits).run("X", axes=STAYS) == 3
    assert "parameter 14985 of axis 1 = 10" in capsys.readouterr().err


def test_straightness_takes_its_numbers_along_and_nothing_else(tmp_path: Path) -> None:
    """X moves and Y is corrected: the points are X's. By path (L), as a backup has them."""
    edits = {
        (5711, "L1"): "1", (5721, "L1"): "2", (5731, "L1"): "16", (5732, "L1"): "16",
        (5733, "L1"): "40", (5734, "L1"): "40", (5763, "L1"): "30", (5764, "L1"): "30",
    }  # fmt: skip
    bench = NeighbourBench(tmp_path, edits)
    assert bench.run("X", axes={"X": "table: {spacing: 20}"}) == 0
    parameters, _ = bench.written()
    reference = int(said(parameters, 3620, 1))
    assert f"N05731Q1L1P{reference - 48}" in parameters
    assert f"N05733Q1L1P{reference}\n" in parameters.replace(" \n", "\n")
    assert ("5731", "L") not in {(str(n), o[0]) for n, o in bench.changed() if n > 5734}
    bench.folder = tmp_path / "bent"
    bench.folder.mkdir()
    other = NeighbourBench(bench.folder, edits)
    assert other.run("Y", axes={"Y": "table: {spacing: 10}"}) == 0  # Y only is moved by it
    assert not {number for number, _ in other.changed()} & set(range(5711, 5800))


@pytest.mark.parametrize("path", ["1", "2"])
def test_each_path_speaks_for_its_own_axes(path: str, tmp_path: Path) -> None:
    """X alone in path 2: axis 1 of that path is X, axis 1 of the first path is not."""
    mine, other = f"L{path}", f"L{3 - int(path)}"
    points = {5731: "16", 5732: "16", 5733: "40", 5734: "40"}
    edits: Edits = {(981, "1"): path, (5711, mine): "1", (5721, mine): "7"}
    edits = {**edits, **{(number, mine): value for number, value in points.items()}}
    edits = {**edits, **{(number, other): "0" for number in (5711, 5721, *points)}}
    bench = NeighbourBench(tmp_path, edits)
    text = bench.parameters
    for number in (5732, 5733, 5734):  # both paths on one line, as a control writes them
        row = "".join(f"L{k}P{edits[(number, f'L{k}')]}" for k in (1, 2))
        text = re.sub(rf"^N0{number}Q1.*$", f"N0{number}Q1{row} ", text, flags=re.MULTILINE)
    bench.parameters = text
    (tmp_path / "CNC-PARA.TXT").write_text(text)
    assert bench.run("X", axes={"X": "table: {spacing: 20}"}) == 0
    parameters, _ = bench.written()
    reference = int(said(parameters, 3620, 1))
    for number, old in points.items():
        found = re.search(rf"^N0{number}Q1L1P(-?\d+)L2P(-?\d+)", parameters, re.MULTILINE)
        assert found is not None
        values = dict(zip(("L1", "L2"), map(int, found.groups()), strict=True))
        assert 20 * (values[mine] - reference) == 40 * (int(old) - 40)
        assert values[other] == 0


def test_a_state_in_which_it_differs_is_refused_by_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A test with everything off, or with another inclination: what the difference does is not
    known.
    """
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    bench.run("X", axes=STAYS)
    (tmp_path / "OLD.TXT").write_text(bench.parameters.replace("A1P-90", "A1P-80"))
    job = tmp_path / "job.yaml"
    for state in ("none", "[OLD.TXT, PITCH.TXT]"):
        text = job.read_text().replace(
            "before: [X.csv]", "before: {files: X.csv, measured_in: old}"
        )
        other = tmp_path / "other.yaml"
        other.write_text(text.replace("states: {", f"states: {{old: {state}, "))
        capsys.readouterr()
        assert compwright(["run", str(other)]) == 3
        told = capsys.readouterr().err
        assert "parameter 5871 of axis 1 = -90" in told
        assert "in addition to its table" in told


def smooth(first: int, start: int, end: int) -> Edits:
    return {(1848, "1"): str(first), (1846, "1"): str(start), (1847, "1"): str(end)}


def test_smooth_backlash_that_ends_near_the_reversal_is_left_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path, smooth(3, 100, 5000))
    assert bench.run("X", axes=STAYS) == 0
    assert bench.left("X") < SMALL
    assert not {number for number, _ in bench.changed()} & set(range(1846, 1850))
    shown = " ".join(capsys.readouterr().out.split())
    assert "CW-S047" in shown
    assert "0.5 mm after a reversal" in shown


def test_smooth_backlash_that_may_reach_a_target_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Bench(tmp_path, smooth(3, 100, 50000)).run("X", axes=STAYS) == 3
    assert "parameter 1847 of axis 1 = 50000" in capsys.readouterr().err


def test_a_backlash_below_its_own_first_stage_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """1851 = 90 with 4 µm of lost motion in 0.1 µm: about 40 is left, less than a first stage of
    60.
    """
    bench = Bench(tmp_path, {**smooth(60, 10, 20), (1851, "1"): "90", (1852, "1"): "90"})
    assert bench.run("X", axes=STAYS) == 4
    assert "1848 = 60" in capsys.readouterr().err


def test_the_plan_is_compared_with_the_numbers_that_moved(tmp_path: Path) -> None:
    bench = NeighbourBench(tmp_path, INCLINED, inclination(1.0))
    assert bench.run("X", axes={"X": "table: {spacing: 20}"}) == 0
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    words = [word for file in sorted(folder.iterdir()) for word in ("--loaded", str(file))]
    plan = str(tmp_path / "job" / "plan.json")
    assert compwright(["compare", plan, *words, "--json", str(tmp_path / "c.json")]) == 0
    assert json.loads((tmp_path / "c.json").read_text())["verdict"] == "same"
