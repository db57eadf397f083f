"""A limit is accepted only where fresh tests at new targets keep it too: periods that may be in the
error, and those that the targets cannot show. Readings from a machine with a known error.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.estimation.hidden_periods import hidden_periods
from compwright.estimation.period_models import NOTHING, PeriodCurve, PeriodModel, PeriodSearch
from compwright.planning.limits import accept_decisions
from compwright.records.axis import AxisKind
from compwright.records.prediction import Quantiles
from loop import Floats, Machine, csv_of
from planning_samples import UM
from test_planning_limits import entry_of, predicted

pytestmark = pytest.mark.remembered

#: Searched, and no period found.
SEARCHED = PeriodSearch(
    (PeriodModel((), (), 1.0),), (), (), PeriodCurve(np.array([10.0]), np.array([-1.0]))
)


@dataclass(frozen=True)
class Waving(Machine):
    """A machine whose screw of 10 mm lead wobbles by ``wave`` mm."""

    wave: float = 0.0

    def error(self, x: Floats, sign: int) -> Floats:
        return super().error(x, sign) + self.wave * np.sin(2 * np.pi * x / 10.0)


def run(folder: Path, machine: Machine, targets: Floats, limit: float) -> tuple[int, Any]:
    (folder / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\n"
        "axes:\n  X: {travel: [0, 800], address: AX1, before: [x.csv], table: {spacing: 10},"
        f" accept: {{A: {limit}}}}}\n"
    )
    code = compwright(["run", str(folder / "job.yaml")])
    return code, json.loads((folder / "job" / "prediction.json").read_text())["axes"]["X"]


@pytest.mark.parametrize(
    ("new", "limit", "decision"),
    [(7.9, 8.0, "accept"), (8.1, 8.0, "undecided"), (99.0, 0.5, "reject")],
)
def test_new_targets_have_to_keep_a_limit_too(new: float, limit: float, decision: str) -> None:
    shown = {"A": Quantiles(2.0 * UM, 1.0 * UM, new * UM)}
    found = accept_decisions(entry_of({"A": limit}), (predicted(1.0, 2.0),), "simple", shown)
    assert found["A"].decision == decision


@pytest.mark.parametrize(("count", "code"), [(6, 1), (25, 0)])
def test_six_targets_tell_nothing_of_a_period(tmp_path: Path, count: int, code: int) -> None:
    """4 µm are 1.5 µm more than the noise alone needs (R of 0.4 µm: 6 sigma)."""
    machine = Machine(bow=0.0005)
    found, axis = run(tmp_path, machine, machine.targets(count), 4.0)
    assert axis["predicted"]["A"]["p95"] < 4.0
    assert found == code
    codes = {finding["code"] for finding in axis["findings"]}
    assert ("CW-P133" in codes) is (code == 1)


def test_an_interval_that_is_a_multiple_of_the_lead_hides_it(tmp_path: Path) -> None:
    """Every 50 mm a wave of 10 mm is always the same; a test at other targets shows 6 µm of it."""
    targets = np.arange(0.0, 801.0, 50.0)
    machine = Waving(bow=0.0005, wave=0.003)
    found, axis = run(tmp_path, machine, targets, 4.0)
    assert axis["predicted"]["A"]["p95"] < 4.0
    assert (found, axis["accept"]["A"]["decision"]) == (1, "undecided")
    between = machine.measure(np.sort(targets[:-1] + np.tile([2.0, 8.0], 8)), 2)
    assert np.ptp(np.mean(between[1], axis=1) - np.arange(16) * 50 * 25e-6) > 0.004


def test_targets_with_a_random_part_hide_no_usual_period() -> None:
    def hidden(targets: Floats, search: PeriodSearch = SEARCHED, *, known: bool = False) -> float:
        return hidden_periods(targets, AxisKind.LINEAR, search, known=known).probability

    every = np.arange(0.0, 801.0, 50.0)
    assert hidden(Machine().targets(25)) == 0.0
    assert 0.05 < hidden(every) < 0.3
    assert hidden(every, known=True) < hidden(every)
    assert hidden(every[:6], NOTHING) == pytest.approx(0.5)  # as many axes show one as none
    found = hidden_periods(every, AxisKind.LINEAR, SEARCHED, known=False)
    assert {5.0, 10.0, 25.0, 50.0} <= set(found.periods)
    assert {8.0, 16.0, 32.0}.isdisjoint(found.periods)  # seen as a wave, whatever its length
    waves = found.waves(np.linspace(0.0, 100.0, 400), 4000, np.random.default_rng(1))
    size = 0.5 * np.ptp(waves, axis=1)
    there = size > 1e-9
    assert np.mean(there) == pytest.approx(found.probability, abs=0.03)
    assert np.mean(size[there]) == pytest.approx(1.5e-3 * np.sqrt(2 / np.pi), rel=0.1)
