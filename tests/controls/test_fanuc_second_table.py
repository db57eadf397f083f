"""A short period of a rotary axis goes into the second table (FANUC 14985 to 14987: A-78868E pages 3
and 6, a worm of a rotary table), where the job says that the control has it.

The virtual machine is that of test_fanuc_backup_honoured; the second table is summed by hand: its
first number is the reference point, those behind it own the sections of one period.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import test_fanuc_backup_honoured as plain
from test_fanuc_backup_honoured import UNIT, Bench, Edits, said

from compwright.cli import run as compwright
from compwright.planning import repeating_table
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import no_compensation
from compwright.records.estimate import WantedCorrection

pytestmark = pytest.mark.short_estimate

#: The parameters stand in the backup, at rest.
AT_REST: Edits = {(14985, "4"): "0", (14986, "4"): "0", (14987, "4"): "0.0"}
#: Targets that show the worm: 42 over the turn, none a whole period from the next.
_PLACES = np.random.default_rng(3)
TARGETS = np.sort(
    np.round(
        np.concatenate(
            [np.arange(0.0, 360.0, 30.0) + _PLACES.uniform(0, 30, 12), _PLACES.uniform(0, 360, 30)]
        ),
        3,
    )
)
PERIOD, AMPLITUDE = 4.0, 0.002


def worm(_axis: int, x: FloatArray, sign: int, period: float = PERIOD) -> FloatArray:
    wave = AMPLITUDE * np.sin(2 * np.pi * x / period + 0.7)
    return np.asarray(0.002 * np.sin(np.radians(x) + 1) + wave + (0.0008 if sign < 0 else 0.0))


@pytest.fixture
def on_a_worm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plain, "error", worm)


def second(parameters: str, points: dict[int, int], x: FloatArray) -> FloatArray:
    first, last = (int(said(parameters, number, 4)) for number in (14985, 14986))
    if last == first:
        return np.zeros_like(x)
    interval = float(said(parameters, 14987, 4))
    increments = [points[number] for number in range(first + 1, last + 1)]
    assert points[first] == 0
    assert sum(increments) == 0
    sums = np.cumsum([0, *increments])
    place = np.mod(x, interval * len(increments)) / interval
    return np.asarray(UNIT * sums[np.floor(place + 0.5).astype(int)])


def left(bench: Bench) -> FloatArray:
    """What is left of the worm over two sections of the main table, deg, one direction."""
    parameters, points = bench.written()
    x = np.linspace(46.0, 74.0, 561)  # within the same step of the main table
    rest = worm(4, x, 1) + plain.added(parameters, points, 4, x, 1) + second(parameters, points, x)
    straight = np.polyval(np.polyfit(x, rest, 1), x)
    return np.asarray(rest - straight)


def test_what_the_main_table_holds_of_the_period_is_left_to_the_second() -> None:
    """Sections of 1.875 of a period of 4 hold some of it: the second table takes the whole wave,
    not what its sections leave.
    """
    x = np.linspace(0.0, 360.0, 7201)
    wave = AMPLITUDE * np.sin(2 * np.pi * x / PERIOD + 0.7)
    wanted = WantedCorrection(
        kind=AxisKind.ROTARY,
        positions=x,
        positive=wave,
        negative=wave,
        reference=0.0,
        reference_return=Direction.POSITIVE,
        noise=1e-4,
        periods=(PERIOD,),
    )
    nodes = np.linspace(0.0, 360.0, 193)
    hats = np.array([np.interp(x, nodes, one) for one in np.eye(nodes.size)])
    values = np.linalg.solve(hats @ hats.T, hats @ wave)
    table = replace(
        no_compensation("4", AxisKind.ROTARY), positions=nodes, positive=values, negative=values
    )
    bare, held = (
        repeating_table._left(wanted, table, ()),
        repeating_table._left(wanted, table, (PERIOD,)),
    )
    folded = [one.reshape(-1)[:7200].reshape(90, 80).mean(axis=0) for one in (bare, held, wave)]
    assert np.std(folded[0]) < 0.7 * np.std(wave)
    assert folded[1] == pytest.approx(folded[2], abs=0.02 * AMPLITUDE)


AXIS = {"B": "screw_pitch: 4"}


@pytest.mark.usefixtures("on_a_worm")
def test_the_worm_goes_into_the_second_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    benches = []
    for option in ("", ", options: {cyclic: available}"):
        folder = tmp_path / ("with" if option else "without")
        folder.mkdir()
        bench = Bench(folder, AT_REST)
        assert bench.run("B", options=option, axes=AXIS, targets=TARGETS) == 0
        benches.append(bench)
    without, bench = benches
    # nearly the whole wave stays without; with it a tenth of a period's steps and 3 runs of noise
    assert np.ptp(left(without)) > 1.8 * AMPLITUDE
    # steps in the middle of sections of a twelfth of the period leave less than a third of the
    # wave's rms; half a section of shift would leave more than that
    assert np.std(left(bench)) < 0.3 * np.std(left(without))
    parameters = bench.written()[0]
    first, last = (int(said(parameters, number, 4)) for number in (14985, 14986))
    interval = float(said(parameters, 14987, 4))
    assert interval * (last - first) == pytest.approx(PERIOD)
    own = set(range(first, last + 1))
    assert not own & {*plain.POINTS, *range(1, 42), *range(101, 142), *range(201, 242)}
    assert not own & set(range(300, 313))
    assert {number for number, _ in without.changed()} & {14985, 14986, 14987} == set()
    shown = " ".join(capsys.readouterr().out.split())
    assert "CW-P143" in shown
    card = (bench.folder / "job" / "card" / "card.md").read_text()
    assert f"parameter 14985 of axis 4 = {first}" in card
    sheet = (bench.folder / "job" / "card" / "entry_B.csv").read_text()
    assert re.search(rf"^{10000 + first},,0,", sheet, re.MULTILINE)
    plan = str(bench.folder / "job" / "plan.json")
    folder = bench.folder / "job" / "tables" / "fanuc-30i"
    loaded = [word for file in sorted(folder.iterdir()) for word in ("--loaded", str(file))]
    assert compwright(["compare", plan, *loaded]) == 0
    typed = bench.folder / "job" / "card" / "entry_B.csv"
    assert compwright(["compare", plan, "--loaded", str(typed)]) == 0


@pytest.mark.usefixtures("on_a_worm")
@pytest.mark.parametrize(
    ("edits", "words"),
    [
        ({(14985, "4"): "400", (14986, "4"): "410", (14987, "4"): "2.0"}, "screw_pitch: 4"),
        (AT_REST, "screw_pitch: 4, table: {spacing: 1}"),  # the grid holds it
    ],
)
def test_where_it_cannot_be_or_is_not_needed_it_is_left(
    edits: Edits, words: str, tmp_path: Path
) -> None:
    bench = Bench(tmp_path, edits)
    options = ", options: {cyclic: available}"
    assert bench.run("B", options=options, axes={"B": words}, targets=TARGETS) == 0
    assert not {number for number, _ in bench.changed()} & {14985, 14986, 14987}


@pytest.mark.usefixtures("on_a_worm")
@pytest.mark.parametrize("spacing", [1.8, 2.0])
def test_points_of_the_main_table_may_lie_in_the_middle_of_sections_of_the_second(
    spacing: float, tmp_path: Path
) -> None:
    """127.8 deg is point 71 of a grid of 1.8 deg, and the step between sections 319 and 320 of 0.4
    deg of the second table: whoever reads it takes the same side.
    """
    bench = Bench(tmp_path, AT_REST)
    options = ", options: {cyclic: available}"
    words = {"B": f"screw_pitch: 4, table: {{spacing: {spacing}}}"}
    assert bench.run("B", options=options, axes=words, targets=TARGETS) == 0


def test_a_period_that_does_not_divide_the_turn_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its phase slips from turn to turn: no table of one period holds it."""
    monkeypatch.setattr(plain, "error", partial(worm, period=7.0))
    bench = Bench(tmp_path, AT_REST)
    options = ", options: {cyclic: available}"
    assert bench.run("B", options=options, axes={"B": "screw_pitch: 7"}, targets=TARGETS) == 0
    assert not {number for number, _ in bench.changed()} & {14985, 14986, 14987}


def test_a_linear_axis_gets_none(tmp_path: Path) -> None:
    """The one page that describes the table speaks of rotary axes."""
    edits = {(14985, "1"): "0", (14986, "1"): "0", (14987, "1"): "0.0"}
    bench = Bench(tmp_path, edits)
    options = ", options: {cyclic: available}"
    assert bench.run("X", options=options, axes={"X": "screw_pitch: 10"}) == 0
    assert not {number for number, _ in bench.changed()} & {14985, 14986, 14987}
