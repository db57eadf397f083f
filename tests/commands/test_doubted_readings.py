"""Before anything is written: readings that look like something else than what they say, with the
odds. A machine with a known error is measured, one thing goes wrong, and that thing is named.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.evaluation.plausibility import plausibility_findings
from compwright.evaluation.same_error import same_error_findings, same_error_odds
from compwright.evaluation.typical_magnitudes import turned_odds
from compwright.foundations.findings import Finding
from compwright.planning.sign_and_unit_doubts import misreading_doubts
from compwright.planning.wanted_correction import observed_tests
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from loop import Floats, Machine, csv_of

MACHINE = Machine(low=-400.0, high=400.0)
TARGETS = MACHINE.targets(count=25)
Readings = dict[int, Floats]


def as_test(readings: Readings, targets: Floats = TARGETS, name: str = "x") -> PositioningTest:
    return PositioningTest(
        name=name,
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=readings[1],
        negative=readings[-1],
        frame="machine",
    )


# ---------------------------------------------------------------- an old table that acts


def old_table(machine: Machine = MACHINE) -> AxisCompensation:
    """What the control holds from another year: whole µm every 50 mm, put out in the middle of each
    section, a fifth of the error short.
    """
    nodes = np.arange(machine.low, machine.high + 1.0, 50.0)
    error = 0.5 * (machine.error(nodes, 1) + machine.error(nodes, -1))
    values = np.round(-0.8 * (error - error[8]), 3)
    return AxisCompensation(
        address="1",
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=values,
        negative=values,
        backlash=0.005,
        interpolation="step",
    )


TABLE = old_table()


def corrected(x: Floats, sign: int) -> Floats:
    return TABLE.at(x, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE)


def doubts(
    readings: Readings, targets: Floats = TARGETS, table: AxisCompensation | None = TABLE
) -> list[str]:
    planned = PlannedTest(test=as_test(readings, targets), measured_in="as_found")
    (bare,) = observed_tests([planned], table)
    axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(-400.0, 400.0), address="1")
    found = misreading_doubts(bare, axis, None if table is None else table.at)
    assert all((one.code, one.severity) == ("CW-P160", "warning") for one in found)
    return [one.message for one in found]


BEFORE = MACHINE.measure(TARGETS, 1)
OPPOSITE = {sign: block[::-1] for sign, block in BEFORE.items()}
MEASURED = MACHINE.measure(TARGETS, 1, corrected)
#: What went wrong -> the readings, their targets, and what has to be said.
WRONG: dict[str, tuple[Readings, Floats, str]] = {
    "compensation off": (BEFORE, TARGETS, "was not active"),
    "sign": ({sign: -block for sign, block in MEASURED.items()}, TARGETS, "sign of the deviations"),
    "order": ({sign: block[::-1] for sign, block in MEASURED.items()}, TARGETS, "opposite order"),
    "against the machine": (
        {sign: -MEASURED[-sign][::-1] for sign in MEASURED},
        -TARGETS[::-1],
        "counts against",
    ),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_test_under_an_old_table_is_held_against_what_it_says(what: str) -> None:
    readings, targets, says = WRONG[what]
    (message,) = doubts(readings, targets)
    assert says in message
    times = re.search(r"(?:more than )?(\d+) times more likely", message)
    assert times is not None
    assert float(times[1]) > 50
    assert ", or " not in message  # one way of reading, not several


@pytest.mark.parametrize("seed", [2, 3])
def test_an_honest_test_under_an_old_table_is_not_doubted(seed: int) -> None:
    assert doubts(MACHINE.measure(TARGETS, seed, corrected)) == []


@pytest.mark.parametrize("seed", [2, 3])
def test_flat_readings_say_nothing_against_the_table_that_made_them_flat(seed: int) -> None:
    """What the table takes away changes from target to target, as periods and wear do."""
    rng = np.random.default_rng(seed)
    values = rng.normal(0.0, 0.002, TARGETS.size) + 0.006 * (TARGETS / 400.0) ** 2
    made = AxisCompensation(
        address="1", kind=AxisKind.LINEAR, positions=TARGETS, positive=values, negative=values
    )
    flat = {sign: rng.normal(0.0, 0.3e-3, (TARGETS.size, 5)) for sign in (1, -1)}
    assert doubts(flat, table=made) == []


def test_readings_in_the_opposite_order_show_without_a_table() -> None:
    """Targets with random parts: 5 mm beside the place make 0.1 µm of 25 µm/m."""
    assert doubts(BEFORE, table=None) == []
    (message,) = doubts(OPPOSITE, table=None)
    assert "opposite order" in message


def test_what_is_doubted_stands_first(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, OPPOSITE))
    again = MACHINE.measure(TARGETS, 7)
    (tmp_path / "y.csv").write_text(
        csv_of(TARGETS, {sign: block[::-1] for sign, block in again.items()}, "Y")
    )
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\naxes:\n"
        "  X: {travel: [-400, 400], address: 0, before: [x.csv]}\n"
        "  Y: {travel: [-400, 400], address: 1, before: [y.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 1
    told = json.loads((tmp_path / "job" / "prediction.json").read_text())
    assert [finding["code"] for finding in told["doubts"]].count("CW-P160") == 2
    assert "CW-T037" in capsys.readouterr().out


def test_symmetric_targets_and_few_say_nothing() -> None:
    equal = np.linspace(-400.0, 400.0, 17)
    readings = MACHINE.measure(equal, 1)
    assert doubts({s: block[::-1] for s, block in readings.items()}, equal, None) == []
    few = {s: block[[1, 4, 9, 15, 22]][::-1] for s, block in MACHINE.measure(TARGETS, 1).items()}
    assert doubts(few, TARGETS[[1, 4, 9, 15, 22]], None) == []


# ---------------------------------------------------------------- one axis measured for two


def test_one_axis_measured_for_two() -> None:
    """A second measurement, with noise and a zero of its own: no copy, and the same error."""
    first, again = (as_test(MACHINE.measure(TARGETS, seed)) for seed in (1, 2))
    (found,) = same_error_findings({"X": [first], "Y": [again]})
    assert (found.code, found.severity) == ("CW-T037", "warning")
    assert "X and Y" in found.message
    assert "times as likely as not" in found.message


@pytest.mark.parametrize("scale", [1.0, 0.3, 0.1])
def test_two_axes_are_not_doubted_however_small_their_errors(scale: float) -> None:
    for seed in range(8):
        rng = np.random.default_rng(seed)
        one, two = (
            replace(
                MACHINE,
                slope=25e-6 * scale * rng.normal(),
                bow=0.006 * scale * rng.normal(),
                lost=0.005 * scale * rng.uniform(0.2, 1.5),
            )
            for _ in range(2)
        )
        tests = [as_test(axis.measure(TARGETS, seed + 10 * n)) for n, axis in enumerate((one, two))]
        assert same_error_odds(*tests) < 50.0


def test_tests_without_common_targets_are_not_compared() -> None:
    other = MACHINE.targets(count=25, seed=9)
    tests = {
        "X": [as_test(MACHINE.measure(TARGETS, 1))],
        "Y": [as_test(MACHINE.measure(other, 2), other)],
    }
    assert same_error_findings(tests) == []


# ---------------------------------------------------------------- unit and directions


@pytest.mark.parametrize(
    ("machine", "change", "says"),
    [
        # 160 µm and noise of 4 µm in mm: 0.16 µm and 4 nm, which a stage for wafers may show
        (replace(MACHINE, slope=400e-6, bow=0.05, noise=0.006), 1e-3, "mm read as µm"),
        # one of the best, A 0.9 µm, read as mm: 0.9 mm
        (replace(MACHINE, slope=0.0, bow=0.0003, lost=0.0002, noise=0.0001), 1e3, "µm read as mm"),
    ],
)
def test_a_unit_is_doubted_by_size_and_scatter_with_its_odds(
    machine: Machine, change: float, says: str
) -> None:
    readings = machine.measure(TARGETS, 1)
    assert "CW-T030" not in {one.code for one in plausibility_findings(as_test(readings))}
    scaled = as_test({sign: block * change for sign, block in readings.items()})
    (found,) = (one for one in plausibility_findings(scaled) if one.code == "CW-T030")
    assert "{unit} read as {read_as}".format(**found.values) == says
    assert found.values["odds"] >= 20


def test_measured_positions_near_their_targets_are_in_the_unit_of_the_targets() -> None:
    """934.669 mm read as 936.699 is a poor axis; in µm it would be 0.937 mm: not near its target."""
    large = as_test({d: 100.0 * values for d, values in MACHINE.measure(TARGETS, 1).items()})
    assert "CW-T030" in {one.code for one in plausibility_findings(large)}
    measured = replace(large, findings=(Finding.of("CW-R003", "info"),))
    assert "CW-T030" not in {one.code for one in plausibility_findings(measured)}


def test_the_odds_of_turned_directions_grow_with_the_reversal() -> None:
    odds: Callable[[float], float] = lambda um: turned_odds(um * 1e-3, AxisKind.LINEAR)  # noqa: E731
    assert odds(1.0) < 3.0  # a µm too much of backlash compensation is common
    assert 3.0 < odds(4.0) < odds(13.0) < odds(40.0)
    assert odds(-13.0) == pytest.approx(1.0 / odds(13.0))
    lost = replace(MACHINE, lost=0.013).measure(TARGETS, 1)
    (found,) = (
        one
        for one in plausibility_findings(as_test({1: lost[-1], -1: lost[1]}))
        if one.code == "CW-T032"
    )
    assert re.search(
        r"\+1[23]\.\d+ µm.*the directions .*\(20 times as likely as not", found.message
    )
