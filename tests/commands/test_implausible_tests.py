"""Measurements that cannot be right: run refuses what is certain, what is possible stands first
everywhere, honest ones pass.
"""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(high=1200.0)


def readings(
    machine: Machine = MACHINE, seed: int = 1, runs: int = 5
) -> tuple[Floats, dict[int, Floats]]:
    targets = machine.targets(count=25)
    return targets, machine.measure(targets, seed, runs=runs)


def write(path: Path, targets: Floats, values: dict[int, Floats], axis: str = "X") -> Path:
    path.write_text(csv_of(targets, values, axis))
    return path


def job(folder: Path, before: str = "[x.csv]", axes: str = "", extra: str = "") -> Path:
    path = folder / "job.yaml"
    path.write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        f"axes:\n  X: {{travel: [0, 1200], address: AX1, before: {before}}}\n{axes}{extra}"
    )
    return path


def run(folder: Path, *words: str, **keys: str) -> int:
    return compwright(["run", str(job(folder, **keys)), *words])


def document(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def doubts(folder: Path) -> list[str]:
    return [finding["code"] for finding in document(folder / "job" / "prediction.json")["doubts"]]


# ---------------------------------------------------------------- refused


def test_mm_read_as_um_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    targets, values = readings()
    write(tmp_path / "x.csv", targets, {sign: block / 1000.0 for sign, block in values.items()})
    assert run(tmp_path) == 3
    said = capsys.readouterr().err
    assert "1000 times too small (mm read as µm)" in said
    assert "x.csv" in said
    assert not (tmp_path / "job").exists()
    assert (
        compwright(["evaluate", str(tmp_path / "x.csv"), "--json", str(tmp_path / "x.json")]) == 0
    )
    assert "CW-T030" in {
        finding["code"] for finding in document(tmp_path / "x.json")["results"][0]["findings"]
    }


def test_um_read_as_mm_is_named_before_what_the_control_cannot_hold(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    targets, values = readings()
    write(tmp_path / "x.csv", targets, {sign: block * 1000.0 for sign, block in values.items()})
    assert run(tmp_path) == 4
    said = capsys.readouterr().err.splitlines()
    doubt = next(n for n, line in enumerate(said) if "read as mm" in line)
    assert "x.csv" in said[doubt]
    assert "larger than the control can store" in said[-1]
    assert doubt < len(said) - 1


@pytest.mark.parametrize("runs", [1, 5])
def test_zeros_are_refused(tmp_path: Path, runs: int) -> None:
    targets, values = readings(runs=runs)
    write(tmp_path / "x.csv", targets, {sign: 0.0 * block for sign, block in values.items()})
    assert run(tmp_path) == 3


def test_deg_read_as_arcsec_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """10 arcsec of error with 0.5 arcsec of noise, in degrees: 0.0028 and 0.00014."""
    targets = np.arange(0.0, 360.0, 30.0)
    rng = np.random.default_rng(1)
    wave = (10.0 * np.sin(np.radians(targets)))[:, None] / 3600.0
    values = {sign: (wave + rng.normal(0, 0.5 / 3600.0, (12, 5))) / 3600.0 for sign in (1, -1)}
    (tmp_path / "c.csv").write_text(csv_of(targets, values, "C", "deg"))
    path = tmp_path / "job.yaml"
    path.write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        "axes:\n  C: {kind: rotary, travel: [0, 360], address: AX4, before: [c.csv]}\n"
    )
    assert compwright(["run", str(path)]) == 3
    assert "the unit is another one" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("factor", "unit"), [(25.4, "inches"), (1000.0, "metres"), (0.001, "micrometres")]
)
def test_targets_in_another_unit_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], factor: float, unit: str
) -> None:
    targets, values = readings()
    write(tmp_path / "x.csv", targets / factor, values)
    assert run(tmp_path) == 3
    assert f"the targets are in {unit}" in capsys.readouterr().err


def test_measured_positions_named_deviations_are_refused(tmp_path: Path) -> None:
    targets, values = readings()
    write(
        tmp_path / "x.csv",
        targets,
        {sign: block + targets[:, None] for sign, block in values.items()},
    )
    assert run(tmp_path) == 3


@pytest.mark.parametrize("how", ["two tests", "two axes", "one test", "renamed"])
def test_one_measurement_given_twice_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], how: str
) -> None:
    path = write(tmp_path / "x.csv", *readings(), axis="")
    shutil.copy(path, tmp_path / "copy.csv")
    if how == "renamed":  # another comment: other bytes, the same readings
        (tmp_path / "copy.csv").write_text("# operator: other\n" + path.read_text())
    second = "  Y: {travel: [0, 1200], address: AX2, before: [copy.csv]}\n"
    keys = {
        "two tests": {"before": "[x.csv, copy.csv]"},
        "two axes": {"axes": second},
        "one test": {"before": "[{files: [x.csv, copy.csv]}]"},
        "renamed": {"before": "[x.csv, copy.csv]"},
    }[how]
    assert run(tmp_path, **keys) == 3
    refused = capsys.readouterr().err
    assert "copy.csv: " in refused
    if how == "one test":
        assert "the same measurement as" in refused
        assert "x.csv" in refused
    else:
        second_axis = "Y" if how == "two axes" else "X"
        assert f"test x of axis X and test copy of axis {second_axis} come from" in refused
        assert "the same readings twice" in refused
    if how == "two tests":
        words = [str(path), str(tmp_path / "copy.csv"), "--json", str(tmp_path / "e.json")]
        assert compwright(["evaluate", *words]) == 0
        found = [
            [entry["code"] for entry in result["findings"]]
            for result in document(tmp_path / "e.json")["results"]
        ]
        assert all("CW-T034" in codes for codes in found)


# ---------------------------------------------------------------- doubts


@pytest.mark.real_pages
def test_swapped_directions_stand_first_everywhere(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Lost motion of 13 µm with + and - exchanged: a mean reversal of +13 µm."""
    targets, values = readings(replace(MACHINE, lost=0.013))
    write(tmp_path / "x.csv", targets, {1: values[-1], -1: values[1]})
    assert run(tmp_path) == 1
    assert doubts(tmp_path) == ["CW-T032"]
    terminal = capsys.readouterr().out
    assert terminal.index("Check first") < terminal.index("swapped") < terminal.index("axis X")
    card = (tmp_path / "job" / "card" / "card.md").read_text()
    page = (tmp_path / "job" / "report.html").read_text()
    for shown in (terminal, card, page):
        assert "acknowledged: {CW-T032: reason}" in shown
    assert "The mean reversal value is +1" in card  # +13 µm with a standard error of 0.1 µm
    assert card.index("swapped") < card.index("## Steps")
    page = (tmp_path / "job" / "report.html").read_text()
    assert page.index("swapped") < page.index('class="verdict')
    assert compwright(["evaluate", str(tmp_path / "x.csv")]) == 0
    shown = capsys.readouterr().out
    assert shown.index("swapped") < shown.index("Accuracy")


@pytest.mark.real_pages
def test_a_doubt_leaves_limits_undecided(tmp_path: Path) -> None:
    targets, values = readings()
    write(tmp_path / "x.csv", targets, {1: values[-1], -1: values[1]})
    path = job(tmp_path)
    path.write_text(path.read_text().replace("before: [x.csv]", "before: [x.csv], accept: {A: 20}"))
    assert compwright(["run", str(path)]) == 1
    page = (tmp_path / "job" / "report.html").read_text()
    assert '<section class="verdict open">\n<h2>Undecided' in page
    assert "to be met" not in page


@pytest.mark.full_estimate
def test_one_run_copied_is_a_doubt(tmp_path: Path) -> None:
    targets, values = readings(runs=1)
    write(
        tmp_path / "x.csv",
        targets,
        {sign: np.repeat(block, 5, axis=1) for sign, block in values.items()},
    )
    assert run(tmp_path) == 1
    assert doubts(tmp_path) == ["CW-T031"]
    message = document(tmp_path / "job" / "prediction.json")["doubts"][0]["message"]
    assert "runs 1, 2, 3, 4 and 5 in +" in message


def test_targets_written_in_inches_are_a_doubt_without_a_travel(tmp_path: Path) -> None:
    """Every 48 mm, in inches with five decimals: whole millimetres only when taken for inches."""
    targets = np.round(np.arange(1, 25) * 48.0 / 25.4, 4)
    _, values = readings()
    write(tmp_path / "x.csv", targets, {sign: block[:24] for sign, block in values.items()})
    assert (
        compwright(["evaluate", str(tmp_path / "x.csv"), "--json", str(tmp_path / "x.json")]) == 0
    )
    assert "CW-T033" in {
        finding["code"] for finding in document(tmp_path / "x.json")["results"][0]["findings"]
    }


# ---------------------------------------------------------------- honest tests


@pytest.mark.parametrize(
    "machine",
    [
        MACHINE,
        replace(
            MACHINE, slope=0.0, bow=0.0003, lost=0.0002, noise=0.00005
        ),  # among the best: A 0.9 µm, noise 0.05 µm
        replace(MACHINE, slope=200e-6, bow=0.05, lost=0.04, noise=0.004),  # among the worst
        replace(MACHINE, lost=-0.002),  # backlash over-compensated by 2 µm
        replace(MACHINE, lost=0.0),
    ],
)
@pytest.mark.full_estimate
def test_honest_machines_are_neither_refused_nor_doubted(tmp_path: Path, machine: Machine) -> None:
    write(tmp_path / "x.csv", *readings(machine))
    assert run(tmp_path, "--accept-worse") == 0
    assert doubts(tmp_path) == []


@pytest.mark.full_estimate
def test_readings_rounded_to_a_micrometre_are_not_refused(tmp_path: Path) -> None:
    """A dial that shows whole micrometres: most repeats are the same, the runs are not."""
    targets, values = readings()
    write(tmp_path / "x.csv", targets, {sign: np.round(block, 3) for sign, block in values.items()})
    assert run(tmp_path) == 0
    assert doubts(tmp_path) == []


@pytest.mark.full_estimate
def test_two_axes_with_readings_of_their_own_pass(tmp_path: Path) -> None:
    write(tmp_path / "x.csv", *readings())
    other = replace(MACHINE, slope=-12e-6, bow=-0.004)
    write(tmp_path / "y.csv", *readings(other, seed=2), axis="Y")
    assert run(tmp_path, axes="  Y: {travel: [0, 1200], address: AX2, before: [y.csv]}\n") == 0
    assert doubts(tmp_path) == []


@pytest.mark.parametrize("travel", ["[0, 31.5]", "[0, 700]", "[-800, 0]"])
def test_targets_where_the_axis_cannot_go_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], travel: str
) -> None:
    """An axis does not leave its travel: the travel is that of another axis, or in inches, or the
    offset is missing.
    """
    machine = Machine()
    targets = machine.targets(count=17)
    write(tmp_path / "x.csv", targets, machine.measure(targets, 1))
    words = [
        "--format",
        "linuxcnc",
        "--axis",
        "X",
        f"--travel={travel[1:-1].replace(', ', ':')}",
        "--state",
        "none",
    ]
    assert compwright(["run", str(tmp_path / "x.csv"), *words, "--out", str(tmp_path / "out")]) == 3
    assert "travel" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_targets_a_little_outside_the_travel_are_a_doubt(tmp_path: Path) -> None:
    """12 mm beyond the travel at intervals of 48 mm: a rounded travel perhaps, an offset
    perhaps.
    """
    targets, values = readings()
    write(tmp_path / "x.csv", targets - targets[0] - 12.0, values)
    assert run(tmp_path) == 1
    assert "CW-T007" in doubts(tmp_path)


def test_a_test_of_another_axis_with_another_zero_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Readings that agree to the last digit but for one constant: one measurement, two zeros of the
    instrument.
    """
    targets, values = readings()
    write(tmp_path / "x.csv", targets, values)
    write(
        tmp_path / "y.csv", targets, {sign: block + 0.0003 for sign, block in values.items()}, "Y"
    )
    assert run(tmp_path, axes="  Y: {travel: [0, 1200], address: AX2, before: [y.csv]}\n") == 3
    assert "the same readings twice" in capsys.readouterr().err


@pytest.mark.parametrize("fault", ["sign", "directions", "inches", "corrected", "axis"])
def test_a_second_test_that_contradicts_the_first_is_a_doubt(tmp_path: Path, fault: str) -> None:
    """Both are of one axis in one state; whichever is right, the table is made from the first."""
    targets, values = readings()
    write(tmp_path / "x.csv", targets, values)
    targets = MACHINE.targets(count=13, seed=8)
    other = Machine(high=1200.0, slope=-60e-6, bow=-0.004)
    fresh = (other if fault == "axis" else MACHINE).measure(targets, 7)
    if fault == "sign":
        fresh = {sign: -block for sign, block in fresh.items()}
    if fault == "corrected":
        fresh = {
            sign: block - MACHINE.error(targets, sign)[:, np.newaxis]
            for sign, block in fresh.items()
        }
    if fault == "directions":
        fresh = {sign: fresh[-sign] for sign in fresh}
    write(tmp_path / "x2.csv", targets / 25.4 if fault == "inches" else targets, fresh)
    run(tmp_path, before="[x.csv, x2.csv]")
    assert "CW-T036" in doubts(tmp_path)


@pytest.mark.full_estimate
@pytest.mark.parametrize("slope", [-4e-6, 4e-6])
def test_a_second_test_on_a_warmer_day_is_no_doubt(tmp_path: Path, slope: float) -> None:
    """4 µm/m, a third of a degree, beside an error of 25 µm/m, at other targets and with another
    zero.
    """
    targets, values = readings()
    write(tmp_path / "x.csv", targets, values)
    targets = MACHINE.targets(count=13, seed=8)
    fresh = {
        sign: block + slope * targets[:, np.newaxis]
        for sign, block in MACHINE.measure(targets, 7).items()
    }
    write(tmp_path / "x2.csv", targets, fresh)
    assert run(tmp_path, before="[x.csv, x2.csv]") == 0
    assert doubts(tmp_path) == []


@pytest.mark.full_estimate
def test_an_endless_axis_may_be_counted_from_anywhere(tmp_path: Path) -> None:
    """Targets from -180 to 150 on a table of 0 to 360: the same places."""
    targets = np.arange(-180.0, 180.0, 30.0) + np.random.default_rng(2).uniform(
        -5.0, 5.0, 12
    ).round(1)
    rng = np.random.default_rng(1)
    wave = (8.0 * np.sin(np.radians(targets)))[:, None] / 3600.0
    values = {
        sign: wave - sign * 1.5 / 3600.0 + rng.normal(0, 0.3 / 3600.0, (12, 5)) for sign in (1, -1)
    }
    (tmp_path / "c.csv").write_text(csv_of(targets, values, "C", "deg"))
    path = tmp_path / "job.yaml"
    path.write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        "axes:\n  C: {kind: rotary, travel: [0, 360], modulo: 360, address: AX4, before: [c.csv]}\n"
    )
    assert compwright(["run", str(path)]) == 0
    assert doubts(tmp_path) == []
