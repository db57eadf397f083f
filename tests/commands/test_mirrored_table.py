"""The test that led to the table in the control, given once more with that table as state: it would
be corrected twice. Honest tests with a table that is active are not doubted.
"""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_verify_proof import sinumerik

from compwright.cli import run as compwright
from compwright.planning.mirror_image import chance_of_mirror
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
TARGETS = MACHINE.targets(count=25)
Readings = dict[int, Floats]


def run(folder: Path, state: str, readings: Readings, name: str, end: str = "") -> tuple[int, Any]:
    (folder / f"{name}.csv").write_text(csv_of(TARGETS, readings))
    (folder / f"{name}.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: siemens-840d-sl}}\nstates: {{as_found: {state}}}\n"
        f"axes:\n  X: {{travel: [0, 800], address: AX1, before: [{name}.csv]}}\n{end}"
    )
    code = compwright(["run", str(folder / f"{name}.yaml"), "--force"])
    return code, json.loads((folder / name / "prediction.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def loaded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the table that the first test led to, read back, without its plan."""
    first = tmp_path_factory.mktemp("first") / "deeper" / "down"
    first.mkdir(parents=True)
    folder = tmp_path_factory.mktemp("mirror")
    code, _ = run(first, "none", MACHINE.measure(TARGETS, 1), "first")
    assert code == 0
    shutil.copytree(first / "first" / "tables" / "siemens-840d-sl", folder / "control")
    return folder


def tables(folder: Path) -> Path:
    return folder / "control"


@pytest.mark.parametrize("what", ["rounded", "other datum", "three runs", "half the backlash"])
@pytest.mark.full_estimate
def test_the_test_of_yesterday_is_not_corrected_twice(loaded: Path, what: str) -> None:
    readings = MACHINE.measure(TARGETS, 1)
    if what == "rounded":
        readings = {sign: np.round(block, 4) for sign, block in readings.items()}
    if what == "other datum":
        readings = {sign: block + 0.0123 for sign, block in readings.items()}
    if what == "three runs":
        readings = {sign: block[:, 1:4] for sign, block in readings.items()}
    if what == "half the backlash":  # the other half was in the control before
        readings[-1] = readings[-1] + 0.5 * MACHINE.lost
    code, found = run(loaded, f"[{tables(loaded)}]", readings, "again")
    assert code == 1
    codes = {one["code"] for one in found["doubts"]}
    assert "CW-P161" in codes
    assert "CW-P160" not in codes  # the cause is known: no other one is told
    assert found["axes"]["X"]["table"] is None


def test_an_acknowledged_mirror_image_gets_its_table(loaded: Path) -> None:
    readings = {s: np.round(block, 4) for s, block in MACHINE.measure(TARGETS, 1).items()}
    acknowledged = "acknowledged: {CW-P161: the machine was rebuilt}\n"
    _, found = run(loaded, f"[{tables(loaded)}]", readings, "known", acknowledged)
    assert found["axes"]["X"]["table"] is not None
    assert "CW-P161" in {one["code"] for one in found["acknowledged"]}


@pytest.mark.parametrize("grown", [1.0, 1.25, 0.7])
def test_a_test_with_an_active_table_is_no_mirror_image(loaded: Path, grown: float) -> None:
    machine = replace(MACHINE, bow=grown * MACHINE.bow, slope=grown * MACHINE.slope)
    readings = machine.measure(TARGETS, 7, sinumerik(tables(loaded)))
    _, found = run(loaded, f"[{tables(loaded)}]", readings, "honest")
    assert "CW-P161" not in {one["code"] for one in found["doubts"]}


@pytest.mark.parametrize(("older", "found"), [(0.0, True), (0.4, True), (1.0, False)])
def test_a_table_that_changes_an_older_one_by_more_than_that_is_a_mirror_image(
    older: float, found: bool
) -> None:
    """What the test showed, and an older table of another shape, by its share of that size."""
    u = np.linspace(0.0, 1.0, 25)
    shown = 0.006 * np.sin(2 * np.pi * (1.3 * u + 0.1))
    table = -shown + older * 0.006 * np.sin(2 * np.pi * (2.1 * u + 0.4))
    assert (chance_of_mirror(table, shown, 800.0 * u, 1e-4) < 0.1) is found


def test_noise_alone_is_no_mirror_image() -> None:
    """Readings or tables whose shape is hardly more than the noise of a mean say nothing."""
    targets = 40.0 * np.arange(21.0)
    wave = np.sin(2 * np.pi * targets / 800.0)
    for size, seen in ((3.0, False), (6.0, True)):
        table = size * np.sqrt(2.0) * 1e-4 * wave  # root mean square: so many times the noise
        assert (chance_of_mirror(table, -table, targets, 1e-4) < 0.1) is seen
        assert chance_of_mirror(0.1 * table, -table, targets, 1e-4) == 1.0
        assert chance_of_mirror(table, -0.1 * table, targets, 1e-4) == 1.0


def test_tables_that_are_not_perfect_are_hardly_ever_mirror_images() -> None:
    """Random axes whose table leaves some of its own shape (0 ± 25 %) and another curve."""
    rng = np.random.default_rng(5)
    u = np.linspace(0.0, 1.0, 21)
    found = 0
    for _ in range(2000):
        waves = [
            rng.uniform(0.001, 0.01) * np.sin(2 * np.pi * (rng.uniform(0.3, 3.0) * u + phase))
            for phase in rng.uniform(size=2)
        ]
        table = waves[0] + rng.normal(0.0, 20e-3) * u
        left = rng.normal(0.0, 0.25) * table + rng.uniform(0.0, 1.0) * waves[1]
        shown = left + rng.normal(0.0, 1e-4, u.size)
        found += chance_of_mirror(table, shown, 800.0 * u, 1e-4) < 0.1
        yesterday = -table + rng.normal(0.0, 1e-4, u.size)
        bent = table - np.polyval(np.polyfit(u, table, 1), u)
        chance = chance_of_mirror(table, yesterday, 800.0 * u, 1e-4)
        assert chance < 0.1 or np.std(bent) < 0.5e-3
    assert found <= 20  # 1 %


@pytest.mark.parametrize("bends", [1, 2, 4])
def test_the_chance_is_that_of_random_curves_in_as_many_bends(bends: int) -> None:
    """Curves of cosines, of random directions and of sizes within a decade, counted."""
    rng = np.random.default_rng(11)
    u = (np.arange(41) + 0.5) / 41
    waves = np.cos(np.pi * np.outer(np.arange(2, 2 + 2 * bends, 2), u))  # even: without a slope
    table = np.ones(bends) @ waves
    others = rng.normal(size=(20_000, bends)) @ waves
    size, sizes = (np.sqrt(np.mean(curve**2, axis=-1)) for curve in (table, others))
    others *= (size * 10 ** rng.uniform(-0.5, 0.5, 20_000) / sizes)[:, np.newaxis]
    left = np.sqrt(np.mean((others + table) ** 2, axis=1))
    counted = float(np.mean(left < 0.3 * size))
    stated = chance_of_mirror(1e-3 * table, -0.7e-3 * table, 800.0 * u, 0.0)
    assert counted / 2 < stated < 3 * counted
