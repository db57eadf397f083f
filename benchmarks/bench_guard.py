"""How often a fresh test lies in the predicted band, and in the band with its guard U on either
side, where what the job declares is really wrong by so much, in both tests independently; and
whether a guarded decision is ever more willing than a simple one.

    PYTHONPATH=src python benchmarks/bench_guard.py [AXES] [--tests N]

Axes are slopes, bows and waves over 0.4 to 1.5 m; the table takes out the estimated error at 33
points. ``read``: of N fresh tests of each axis, in per cent; ``true``: of the same tests without
instrument; ``order``: axes on which p95 + U lies below the p95 of the simple band.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass

import numpy as np

from compwright.evaluation.standards import evaluate
from compwright.planning.axis_work import AxisWork, predict_axis, start_axis
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.correction import ControlState
from compwright.records.job import Acceptance, AxisJob, Job, TestRequest
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import AxisPrediction

UM = 1e-3
ALPHA = 11.5
NAMES = ("A", "E", "M")
RUNS = 5


@dataclass(frozen=True)
class Kind:
    """What is declared, and by how much it is wrong in a fresh test of an axis of ``length`` m:
    standard deviation of a slope, µm/m, drawn per test, and of one that all tests share.
    """

    name: str
    budget: UncertaintyBudget
    per_test: float
    shared: float = 0.0


KINDS = (
    Kind("temperature", UncertaintyBudget(U_theta=1.0), 0.5 * ALPHA),
    Kind("instrument", UncertaintyBudget(device_per_m=6.0), 0.0, 3.0),
    Kind("both", UncertaintyBudget(U_theta=0.5, device_per_m=3.0), 0.25 * ALPHA, 1.5),
)


def measured(
    targets: FloatArray, curve: FloatArray, slope: float, rng: np.random.Generator
) -> PositioningTest:
    """Return a test whose readings are ``curve`` (2, m) and ``slope``, µm and µm/m."""
    seen = curve + slope * targets / 1000.0
    blocks = (seen[:, :, None] + 0.6 * rng.standard_normal((*seen.shape, RUNS))) * UM
    runs = tuple(range(1, RUNS + 1))
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=blocks[0],
        negative=blocks[1],
        runs_positive=runs,
        runs_negative=runs,
        frame="machine",
        thermal=Thermal(alpha_m=ALPHA, T_m=22.0),
    )


def table_of(work: AxisWork) -> Correction:
    """Return a table of 33 points that takes the estimated error out."""
    nodes = np.linspace(*work.planned.axis.travel, 33)
    left = work.posterior.summary(nodes)
    curves = {way: -left.mean(way) for way in Direction}
    return lambda x, way: np.interp(x, nodes, curves[way])


def predicted(
    kind: Kind, axis: Axis, test: PositioningTest, rule: str
) -> tuple[AxisPrediction, Correction]:
    """Return what is predicted by a rule, and the table that it is predicted for."""
    entry = AxisJob(
        axis=axis,
        before=(TestRequest(files=("x.csv",), name="x"),),
        accept=Acceptance(limits=dict.fromkeys(NAMES, 8.0)),
    )
    job = Job(
        file="job.yaml",
        format="any",
        axes={"X": entry},
        uncertainty=kind.budget,
        decision_rule="guarded" if rule == "guarded" else "simple",
    )
    planned = PlannedTest(test=test, measured_in="as_found")
    states = {"as_found": ControlState(format="any", axes={})}
    work = start_axis(job, entry, (planned,), states, no_correction)
    table = table_of(work)
    return predict_axis(work, table, None, job), table


def one(kind: Kind, number: int, tests: int) -> dict[str, tuple[float, float, float, bool]]:
    """Return of one axis, by parameter, the shares held by the simple band, by the guarded one,
    and that of true values, and whether the order of the rules is kept.
    """
    rng = np.random.default_rng([number, 41])
    length = rng.uniform(400.0, 1500.0)
    m = int(rng.integers(9, 22))
    targets = (np.arange(m) + 0.5 + rng.uniform(-0.3, 0.3, m)) * length / m
    u = targets / length
    shape = (u, np.sin(np.pi * u), np.sin(2.0 * np.pi * (u + rng.random())))[number % 3]
    curve = rng.uniform(4.0, 12.0) * shape + np.array([[0.0], [-2.0]])
    shared = kind.shared * rng.standard_normal()
    first = measured(targets, curve, shared + kind.per_test * rng.standard_normal(), rng)
    axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(0.0, length), address="X")
    simple, _ = predicted(kind, axis, first, "simple")
    guarded, table = predicted(kind, axis, first, "guarded")
    moved = np.stack([table(targets, way) for way in Direction]) / UM
    slopes = shared + kind.per_test * rng.standard_normal(tests)
    values = [
        [evaluate(measured(targets, curve + moved, float(s), rng)).parameters for s in sloped]
        for sloped in (slopes, np.zeros(tests))
    ]
    found = {}
    for name in NAMES:
        wide, band = simple.tests[0].predicted[name], guarded.tests[0].predicted[name]
        U = (guarded.accept[name].U or 0.0) * UM
        read, true = (np.array([each[name] for each in some], dtype=float) for some in values)
        simply = np.mean((read >= wide.p05) & (read <= wide.p95))
        held, truly = (
            np.mean((some >= band.p05 - U) & (some <= band.p95 + U)) for some in (read, true)
        )
        kept = band.p95 + U >= wide.p95 - 1e-9
        found[name] = float(simply), float(held), float(truly), kept
    return found


def main() -> None:
    """Print the shares of each kind, in per cent."""
    parser = argparse.ArgumentParser()
    parser.add_argument("axes", type=int, nargs="?", default=12)
    parser.add_argument("--tests", type=int, default=100)
    given = parser.parse_args()
    print(f"{'':14}" + "".join(f"{name:>4}: simple  guarded read, true  order" for name in NAMES))
    for kind in KINDS:
        every = [one(kind, number, given.tests) for number in range(given.axes)]
        cells = []
        for name in NAMES:
            parts = [each[name] for each in every]
            shares = 100.0 * np.mean([part[:3] for part in parts], axis=0)
            broken = sum(not part[3] for part in parts)
            cells.append("{:12.1f} {:13.1f} {:5.1f} {:6d}".format(*shares, broken))
        print(f"{kind.name:14}" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
