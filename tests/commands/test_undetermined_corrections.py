"""Squareness and scale of circles that do not determine them: no value, no table, exit 1.

The circles are computed as a machine moves (`circle_machine`), so the truth is known.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.cli import run as compwright
from compwright.documents.circular import circular_document
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.records.correction_need import correction_need
from compwright.simulation.circular_files import to_circular_csv

pytestmark = pytest.mark.short_estimate

#: A machine with 28 µm/m less than 90°, lost motion of both axes, and a column that bends.
MACHINE = Machine(
    squareness=-28.0,
    scale_error_first=40.0,
    scale_error_second=-30.0,
    backlash_first_at_positive=6.0,
    backlash_first_at_negative=5.0,
    backlash_second_at_positive=3.0,
    backlash_second_at_negative=4.0,
    lateral_play_first=2.0,
    servo_mismatch=0.1,
    straightness_second=3.0,
)
FULL = Setup(feed=300.0, noise=0.2)
#: Arcs by what they lack.
HALF_X = replace(FULL, start=0.0, extent=180.0, samples=750)  # X reverses at 0° and 180°
HALF_Y = replace(FULL, start=90.0, extent=180.0, samples=750)  # Y reverses at 90° and 270°
QUARTER = replace(FULL, start=35.0, extent=100.0, samples=400)
ONE_WAY = replace(FULL, senses=("ccw",))
LACKING = {"half_x": HALF_X, "half_y": HALF_Y, "quarter": QUARTER, "one_way": ONE_WAY}


def circle(setup: Setup) -> Any:
    return measured(MACHINE, setup, np.random.default_rng(3))


def run(folder: Path, setup: Setup, apply: str, control: str = "siemens-840d-sl") -> int:
    (folder / "xy.csv").write_bytes(to_circular_csv(circle(setup), {}))
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {{cec: available, cec_sign:"
        " correction, cec_tables: [0, 1, 2, 3]}}\nstates: {as_found: none}\naxes:\n"
        "  X: {travel: [0, 800], address: AX1, before: []}\n"
        "  Y: {travel: [-500, 0], address: AX2, before: []}\n"
        "circles: [{file: xy.csv, name: xy, centre: [400, -250]}]\n"
        f"apply: {apply}\n"
    )
    return compwright(["run", str(folder / "job.yaml")])


def written(folder: Path) -> list[str]:
    return sorted(path.name for path in (folder / "job" / "tables").rglob("*") if path.is_file())


def evaluation(folder: Path) -> Any:
    return json.loads((folder / "job" / "evaluation.json").read_text())["results"][0]


@pytest.mark.parametrize("name", list(LACKING))
def test_a_squareness_that_the_path_cannot_separate_is_no_table(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, LACKING[name], "{squareness: {XY: Y}}") == 1
    assert "error CW-P106" in " ".join(capsys.readouterr().out.split())
    assert written(tmp_path) == []
    found = evaluation(tmp_path)
    assert found["diagnosis"]["squareness"]["value"] is None
    assert found["plain"]["squareness"] is None
    assert "measure a full circle in both directions" in found["not_applicable"]["squareness"]
    before = json.loads((tmp_path / "job" / "prediction.json").read_text())["circles"]["xy"]
    assert before["before"]["squareness"] is None
    assert "squareness" not in before["predicted"]
    # Nothing is loaded: a fresh test is like this one.
    assert before["predicted"]["G_ccw"]["p95"] < 1.5 * before["before"]["G_ccw"]


def test_the_full_circle_of_the_same_machine_is_a_table(tmp_path: Path) -> None:
    assert run(tmp_path, FULL, "{squareness: {XY: Y}}") == 0
    assert [name for name in written(tmp_path) if "CEC" in name or "CROSS" in name]
    found = evaluation(tmp_path)
    assert found["diagnosis"]["squareness"]["value"] == pytest.approx(-28.0, abs=3.0)
    assert "squareness" not in found["not_applicable"]


@pytest.mark.parametrize("name", list(LACKING))
def test_a_scale_that_the_path_cannot_separate_is_no_table(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """The feed is low enough for the scale of single axes: only the path is at fault."""
    setup = replace(LACKING[name], feed=100.0)
    assert run(tmp_path, setup, "{scale: [X]}") == 1
    assert "error CW-P119" in " ".join(capsys.readouterr().out.split())
    assert written(tmp_path) == []
    assert evaluation(tmp_path)["diagnosis"]["scale_error_first"]["value"] is None


@pytest.mark.parametrize(
    ("value", "std_error", "need"),
    [
        (100.0, 10.0, "correct"),
        (-40.0, 9.0, "correct"),
        (4.0, 5.0, "negligible"),  # -6 to 14 µm/m: nowhere 15
        (-4.0, 5.0, "negligible"),
        (12.0, 7.0, "undetermined"),  # -2 to 26 µm/m: nothing at all, or more than 15
        (-12.0, 7.0, "undetermined"),
        (100.0, 30.0, "undetermined"),
        (0.03, 0.004, "negligible"),  # 0.03 µm over a metre: no table holds that
        (-1.5, 0.2, "correct"),
    ],
)
def test_an_interval_of_95_percent_decides(value: float, std_error: float, need: str) -> None:
    assert correction_need(value, std_error) == need


def test_lost_motion_of_an_axis_that_does_not_reverse_is_not_given() -> None:
    document = circular_document(diagnose_circle(circle(HALF_X), "iso230-4:2005"))
    assert document["diagnosis"]["backlash_first"]["value"] is None
    assert document["diagnosis"]["backlash_second"]["value"] == pytest.approx(3.0, abs=0.5)
    shares = [entry["share"] for entry in document["diagnosis"].values() if entry["share"]]
    assert all(0.0 < share <= 1.0 for share in shares)


def test_shares_are_of_the_causes_and_sum_to_one() -> None:
    """Both scales make 9 and 6 µm; what the centred circle shows of them is their difference."""
    setup = replace(FULL, feed=100.0)
    scales = Machine(
        scale_error_first=60.0, scale_error_second=40.0, backlash_first_at_positive=2.0
    )
    document = circular_document(diagnose_circle(measured(scales, setup), "iso230-4:2005"))
    found = document["diagnosis"]
    assert found["scale_error_first"]["effect"] == pytest.approx(9.0, rel=0.02)
    for part in ("scale_error_first", "scale_error_second", "backlash_first_at_positive"):
        assert found[part]["value"] is not None
        assert found[part]["share"] is None
    assert sum(entry["share"] or 0.0 for entry in found.values()) == pytest.approx(1.0, abs=0.001)


def test_a_squareness_drowned_in_noise_is_null_with_its_numbers() -> None:
    setup = replace(FULL, radius=50.0, noise=15.0, samples=200)
    found = circular_document(diagnose_circle(circle(setup), "iso230-4:2005"))
    entry = found["diagnosis"]["squareness"]
    assert entry["value"] is None
    # Of 400 samples: sqrt(2 / 400) * 15 um is the error of the amplitude of sin2θ, beta R / 2.
    assert entry["std_error"] == pytest.approx(2e3 * 15.0 * (2 / 400) ** 0.5 / 50.0, rel=0.2)
    assert "too uncertain: the uncertainty (k = 2)" in found["not_applicable"]["squareness"]
