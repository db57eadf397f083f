"""Files that belong together, of which only some are loaded: the magnification stays where a test
shows nothing of a better one, the card says what a part alone does, and compare names the files
that are missing.

The bench is the small copy of a real FANUC backup: X with 3623 = 10 and a detection unit of 0.1 µm.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_fanuc_backup_honoured import POINTS, Bench, added, data, error, said

from compwright.cli import run as compwright

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]


class NoisyBench(Bench):
    """Readings that scatter by ``noise``, mm."""

    noise = 0.0003

    def measure(self, name: str, targets: Any = None) -> None:
        super().measure(name, targets)
        path = self.folder / f"{name}.csv"
        head, *rows = path.read_text().splitlines()
        rng = np.random.default_rng(7)
        more = rng.normal(0, self.noise, len(rows))
        cells = [row.rsplit(",", 1) for row in rows]
        new = [
            f"{start},{float(end) + by:.6f}" for (start, end), by in zip(cells, more, strict=True)
        ]
        path.write_text("\n".join([head, *new]) + "\n")


def shown(bench: Bench) -> float:
    prediction = json.loads((bench.folder / "job" / "prediction.json").read_text())
    return float(prediction["axes"]["X"]["predicted_new_targets"]["A"]["median"])


@pytest.mark.full_estimate  # whether a finer step shows is what the prediction says
def test_the_magnification_stays_where_a_test_shows_nothing_of_a_better_one(
    tmp_path: Path,
) -> None:
    bench = NoisyBench(tmp_path)
    bench.noise = 0.004
    assert bench.run("X") == 0
    parameters, points = bench.written()
    assert said(parameters, 3623, 1) == "10"
    assert "All files or none" not in (tmp_path / "job" / "card" / "card.md").read_text()
    # with the pitch file alone the axis is nowhere further off than with nothing new
    x = np.linspace(-1000, 0, 301)
    alone = [error(1, x, sign) + added(bench.parameters, points, 1, x, sign) for sign in (1, -1)]
    before = [
        error(1, x, sign) + added(bench.parameters, bench.points, 1, x, sign) for sign in (1, -1)
    ]
    assert np.ptp(alone) < np.ptp(before)


@pytest.fixture(scope="module")
def finer(tmp_path_factory: pytest.TempPathFactory) -> Bench:
    """An axis that repeats well: steps of 1 µm are what limits it, and the magnification becomes 1."""
    bench = Bench(tmp_path_factory.mktemp("finer"))
    assert bench.run("X") == 0
    assert said(bench.written()[0], 3623, 1) == "1"
    return bench


def test_the_card_says_what_one_file_alone_does(finer: Bench) -> None:
    """By the virtual machine: error and old parameters with the new points, at the targets."""
    card = (finer.folder / "job" / "card" / "card.md").read_text()
    found = re.search(r"With PITCH\.TXT alone axis X has A (\d+) µm \(now (\d+) µm\)", card)
    assert found is not None
    rows = [row.split(",") for row in (finer.folder / "X.csv").read_text().splitlines()[1:]]
    x = np.unique([float(row[0]) for row in rows])
    _, points = finer.written()
    left = [error(1, x, sign) + added(finer.parameters, points, 1, x, sign) for sign in (1, -1)]
    assert float(found[1]) == pytest.approx(np.ptp(left) * 1000, abs=3)  # and 4 s of 0.3 µm
    assert card.index("All files or none") < card.index("Save first")
    titles = re.findall(r"\*\*(.+?)\*\*", card)
    assert sum("pitch data" in title for title in titles) == 1  # parameters and points: one step


@pytest.mark.parametrize(
    ("loaded", "missing"), [("PITCH.TXT", "CNC-PARA.TXT"), ("CNC-PARA.TXT", "PITCH.TXT")]
)
def test_compare_names_the_file_that_was_not_loaded(
    finer: Bench, tmp_path: Path, loaded: str, missing: str
) -> None:
    """The other one is as it was, whatever the saved files are called."""
    new = (finer.folder / "job" / "tables" / "fanuc-30i" / loaded).read_text()
    old = (finer.folder / missing).read_text()
    (tmp_path / "ONE.TXT").write_text(new)
    (tmp_path / "OTHER.TXT").write_text(old)
    answer = tmp_path / "compare.json"
    words = [f"--loaded={tmp_path / name}" for name in ("ONE.TXT", "OTHER.TXT")]
    plan = str(finer.folder / "job" / "plan.json")
    assert compwright(["compare", plan, *words, f"--json={answer}"]) == 1
    axis = json.loads(answer.read_text())["axes"]["X"]
    assert axis["verdict"] == "partial"
    assert axis["message"].startswith(f"only {loaded} was loaded: load {missing} too")


def test_a_single_value_that_was_mistyped_is_no_missing_file(finer: Bench, tmp_path: Path) -> None:
    folder = finer.folder / "job" / "tables" / "fanuc-30i"
    parameters, pitch = ((folder / name).read_text() for name in ("CNC-PARA.TXT", "PITCH.TXT"))
    number = next(n for n, value in data(pitch).items() if value != POINTS.get(n, 0) and n < 41)
    pitch = re.sub(rf"(N{10000 + number}Q0P)-?\d+", rf"\g<1>{POINTS.get(number, 0)}", pitch)
    (tmp_path / "CNC-PARA.TXT").write_text(parameters)
    (tmp_path / "PITCH.TXT").write_text(pitch)
    answer = tmp_path / "compare.json"
    plan = str(finer.folder / "job" / "plan.json")
    words = [f"--loaded={tmp_path / name}" for name in ("CNC-PARA.TXT", "PITCH.TXT")]
    assert compwright(["compare", plan, *words, f"--json={answer}"]) == 1
    assert json.loads(answer.read_text())["axes"]["X"]["verdict"] == "other"
