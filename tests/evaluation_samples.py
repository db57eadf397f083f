"""Tests to evaluate: the printed tables read by a reader of its own, and axes with known errors."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from compwright.records.axis import AxisKind, FloatArray
from compwright.records.positioning import Cycle, PositioningTest

UM = 1e-3  # mm


def printed_table(path: Path) -> PositioningTest:
    """Return a long-form table in µm; a reader apart from the project's, for complete tables
    only.
    """
    rows = [
        line for line in path.read_text("utf-8").splitlines() if line and not line.startswith("#")
    ]
    readings = {
        (float(r["target_mm"]), r["direction"], int(r["run"])): float(r["deviation_um"])
        for r in csv.DictReader(rows)
    }
    targets = sorted({target for target, _, _ in readings})
    runs = sorted({run for _, _, run in readings})
    block = {d: [[readings[x, d, j] * UM for j in runs] for x in targets] for d in "+-"}
    return axis_test(targets, block["+"], block["-"], name=path.stem)


def axis_test(
    targets: ArrayLike,
    positive: ArrayLike,
    negative: ArrayLike | None = None,
    *,
    kind: AxisKind = AxisKind.LINEAR,
    cycle: Cycle = "standard",
    header: dict[str, str] | None = None,
    name: str = "test",
) -> PositioningTest:
    """Return a test from plain lists in mm or deg; ``negative`` None is a test in one direction."""
    where = np.array(targets, dtype=np.float64)
    return PositioningTest(
        name=name,
        axis="X",
        kind=kind,
        targets=where,
        positive=np.array(positive, dtype=np.float64),
        negative=(
            np.empty((where.size, 0)) if negative is None else np.array(negative, dtype=np.float64)
        ),
        cycle=cycle,
        header=header or {},
    )


def noisy(
    rng: np.random.Generator,
    *,
    targets: int = 11,
    runs: int = 5,
    s: float = 1.0,
    common: float = 0.0,
    drift: float = 0.0,
) -> PositioningTest:
    """Return a sound axis: a smooth error, 3 µm lost motion, readings with ``s`` µm of scatter.

    ``common`` is the share of the variance that whole runs have in common; ``drift`` µm from the
    first run to the last.
    """
    x = np.linspace(20.0, 980.0, targets) + rng.uniform(-20.0, 20.0, targets)

    def readings(lost: float) -> FloatArray:
        curve = 6.0 * np.sin(x / 300.0)[:, np.newaxis] + lost
        own = np.sqrt(1.0 - common) * rng.normal(size=(targets, runs))
        run = np.sqrt(common) * rng.normal(size=(1, runs))
        ramp = drift * np.arange(runs) / (runs - 1)
        values: FloatArray = (curve + s * (own + run) + ramp) * UM
        return values

    return axis_test(x, readings(0.0), readings(3.0))
