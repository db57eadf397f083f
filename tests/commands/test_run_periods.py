"""A run on an axis whose screw nobody named: its period is found, told, and taken out."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, csv_of

MACHINE = Machine()
UM = 1e-3


def wave(x: Floats, _sign: int) -> Floats:
    """2.5 µm at a screw of 10 mm."""
    return np.asarray(2.5 * UM * np.sin(2 * np.pi * np.asarray(x, dtype=float) / 10.0 + 0.7))


def run(folder: Path, targets: Floats, axis: str) -> dict[str, dict[str, Any]]:
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1, wave)))
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        f"axes:\n  X: {{travel: [0, 800], address: AX1, before: [x.csv], {axis}}}\n"
    )
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return {
        name: json.loads((folder / "job" / f"{name}.json").read_text(encoding="utf-8"))["axes"]["X"]
        for name in ("prediction", "plan")
    }


def test_an_unknown_screw_is_found_told_and_taken_out(tmp_path: Path) -> None:
    """With nodes 2 mm apart the table follows the wave; rms left 0.5 µm and less (noise 0.4 µm
    over ten readings at 24 targets), instead of 1.8 µm."""
    found = run(tmp_path, MACHINE.targets(24), "table: {start: 0, end: 800, spacing: 2}")
    for document in found.values():
        (period,) = document["periods"]
        assert period["period"] == pytest.approx(10.0)
        assert period["probability"] > 0.95
        assert period["source"] == "found"
    table = found["prediction"]["table"]
    nodes = np.array(table["positions"])
    correction = np.array(table["correction_positive"]) * UM
    dense = np.linspace(20.0, 780.0, 2001)
    left = MACHINE.error(dense, 1) + wave(dense, 1) + np.interp(dense, nodes, correction)
    assert np.std(left) < 0.5 * UM
    search = found["prediction"]["period_search"]
    best = int(np.argmax(search["log_odds"]))
    assert search["periods"][best] == pytest.approx(10.0, rel=0.01)


def test_a_named_screw_stays_as_the_job_says(tmp_path: Path) -> None:
    found = run(tmp_path, MACHINE.targets(24), "screw_pitch: 10")
    assert found["prediction"]["periods"] == [{"period": 10.0, "probability": 1.0, "source": "job"}]
    assert found["plan"]["periods"] == found["prediction"]["periods"]


@pytest.mark.parametrize(("pitch", "doubted"), [(12, True), (10, False)])
def test_a_pitch_that_the_readings_do_not_show_is_doubted(
    tmp_path: Path, pitch: int, *, doubted: bool
) -> None:
    found = run(tmp_path, MACHINE.targets(24), f"screw_pitch: {pitch}")["prediction"]
    says = [each["message"] for each in found["findings"] if each["code"] == "CW-E016"]
    assert bool(says) == doubted
    if doubted:
        assert "screw_pitch 12 mm" in says[0]
        assert "every 10 mm" in says[0]
