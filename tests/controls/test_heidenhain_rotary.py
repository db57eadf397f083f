"""HEIDENHAIN: a rotary axis with ends. Of its table only 0 to 360 degrees are used (TNC 407
technical manual p156).
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine

pytestmark = pytest.mark.short_estimate


def run(folder: Path, control: str, low: float, high: float) -> int:
    turn = Machine(low=low, high=high, slope=0.0, bow=0.003, lost=0.002)  # deg
    targets = turn.targets()
    rows = [
        f"{x},{'+' if sign > 0 else '-'},{run},{3600 * value:.4f}\n"
        for sign, block in turn.measure(targets, 1).items()
        for x, readings in zip(targets, block, strict=True)
        for run, value in enumerate(readings, start=1)
    ]
    (folder / "c.csv").write_text("target_deg,direction,run,deviation_arcsec\n" + "".join(rows))
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}}}\nstates: {{as_found: none}}\n"
        f"axes:\n  C: {{kind: rotary, travel: [{low:g}, {high:g}], before: [c.csv]}}\n"
    )
    return compwright(["run", str(folder / "job.yaml")])


@pytest.mark.parametrize("control", ["heidenhain-itnc530", "heidenhain-nck"])
@pytest.mark.parametrize(("low", "high"), [(0.0, 360.0), (0.0, 350.0), (5.0, 340.0)])
def test_a_travel_within_the_turn_gets_a_table_within_it(
    tmp_path: Path, control: str, low: float, high: float
) -> None:
    assert run(tmp_path, control, low, high) == 0
    sheet = (tmp_path / "job" / "tables" / control / "entry_C.csv").read_text()
    nodes = [float(line.split(",")[1]) for line in sheet.splitlines() if line[:1].isdigit()]
    assert 0 <= nodes[0] <= low
    assert high <= nodes[-1] <= 360


def test_a_travel_below_zero_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, "heidenhain-itnc530", -90.0, 90.0) == 4
    assert "0 to 360" in capsys.readouterr().err
