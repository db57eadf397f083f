"""A report shows readings as they were measured, and those reduced to 20 °C under their own name."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

TARGETS = Machine().targets(9)


@pytest.mark.parametrize("thermal", ["", "thermal: {alpha_m: 11.5, T_m: 22.0, x_fix: 100}\n"])
@pytest.mark.real_pages
def test_single_readings_are_those_of_the_file(tmp_path: Path, thermal: str) -> None:
    """2 K above 20 °C: 23 µm/m are taken off, from 100 mm on (ISO 230-2, 3.1)."""
    readings = Machine().measure(TARGETS, 1)
    (tmp_path / "x.csv").write_text(csv_of(TARGETS, readings))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        f"axes:\n  X: {{travel: [0, 800], address: AX1, before: [x.csv]}}\n{thermal}"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    page = (tmp_path / "job" / "report.html").read_text(encoding="utf-8")
    tables = re.findall(
        r"<summary>(Single readings[^<]*)</summary>(.*?)</details>", page, re.DOTALL
    )
    shown = {
        name: np.array(
            [
                [
                    float(cell.replace("−", "-"))
                    for cell in re.findall(r"<td[^>]*>([^<]*)</td>", row)
                ]
                for row in re.findall(r"<tr>(.*?)</tr>", text, re.DOTALL)
                if "<td" in row
            ]
        )
        for name, text in tables
    }
    # a table of each approach, + first
    measured = 1000 * np.vstack([readings[1], readings[-1]])
    reduced = measured - 0.023 * (np.tile(TARGETS, 2)[:, np.newaxis] - 100)
    raw = "Single readings, as measured" if thermal else "Single readings"
    assert set(shown) == {raw, *(["Single readings, reduced to 20 °C"] if thermal else [])}
    np.testing.assert_allclose(shown[raw][:, 1:6], measured, atol=0.006)
    if thermal:
        cold = shown["Single readings, reduced to 20 °C"]
        np.testing.assert_allclose(cold[:, 1:6], reduced, atol=0.006)
