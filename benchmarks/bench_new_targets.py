"""How often do fresh tests at new targets break a limit that was accepted?

    python benchmarks/bench_new_targets.py [N] [--sound] [--kind KIND]... [--seed S] [--out FILE]

Virtual axes from physics alone (`examiner_axes.py`), 0 to 800 mm, with one periodic error of 2 to
60 mm and 0 to 5 µm; half of the periods are usual screw leads. Each is measured at 5 to 40 targets,
equally spaced, scattered about that, or by the rule of ISO 230-2 (random over a whole interval).
Two kinds more: targets at multiples of half a lead or all of it, and screws of twice the lead that
bump twice in a turn (19.97 mm may be 39.94). A table every 10 mm takes out what is estimated.
Limits on A of 1.1 to 3 times the predicted 95 % value at the same targets are decided upon; fresh
tests of the axis with its table, at new targets, show which are broken. `--sound`: axes
without a periodic error, and limits of 1.5 and 2.5 times the true A (the median of the fresh
tests); prints how many are accepted.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from examiner_axes import (
    TRAVEL,
    Axis,
    Values,
    accuracy,
    constant,
    dithered,
    scatter,
    smooth,
    spread_targets,
    together,
    wave,
)

from compwright.planning.axis_work import predict_axis, start_axis
from compwright.planning.limit_decisions import accept_decisions
from compwright.prediction.active_corrections import no_correction
from compwright.records.axis import Axis as JobAxis
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlState
from compwright.records.job import Acceptance, AxisJob, Job, TestRequest
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest

FACTORS = (1.1, 1.3, 1.6, 2.0, 3.0)
SOUND_FACTORS = (1.5, 2.5)
FRESH = 300
LEADS = (4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0)
UM = 1e-3
#: The kinds of test, by the numbers of targets and how they are placed.
COUNTS = {"few": (5, 7), "eight": (8, 13), "some": (14, 20), "many": (21, 40)}
PLACES = ("equal", "scattered", "random")
KINDS = [f"{count} {place}" for count in COUNTS for place in PLACES]
KINDS += ["multiples", "two bumps"]


def targets_of(count: int, place: str, rng: np.random.Generator) -> Values:
    """Return the targets of a test."""
    if place == "random":
        interval = TRAVEL / count
        return np.round((np.arange(count) + rng.uniform(0.02, 0.98, count)) * interval, 3)
    return spread_targets(count, rng=rng if place == "scattered" else None)


def machine(kind: str, rng: np.random.Generator, *, sound: bool) -> Axis:
    """Return an axis with its test."""
    period = float(rng.choice(LEADS) if rng.random() < 0.5 else np.exp(rng.uniform(0.7, 4.1)))
    count = int(rng.integers(9, 16))
    if kind == "multiples":
        period = float(rng.choice([19.97, 39.92, 10.0, 20.0, 12.0, 24.0]))
        targets = np.round(np.sort(rng.choice(40, count, replace=False)) * 19.97)
    elif kind == "two bumps":
        period = float(rng.choice([19.97, 20.0]))
        targets = targets_of(count, "scattered", rng)
    else:
        name, place = kind.split()
        low, high = COUNTS[name]
        targets = targets_of(int(rng.integers(low, high + 1)), place, rng)
    parts = [smooth(rng, float(rng.choice([3.0, 8.0, 15.0])))]
    amplitude, phase = float(rng.uniform(0.0, 5.0)), float(rng.uniform(0.0, 6.28))
    if not sound:
        parts.append(wave(amplitude, period, phase))
    if kind == "two bumps" and not sound:
        parts.append(wave(amplitude * rng.uniform(0.0, 0.7), 2.0 * period, rng.uniform(0.0, 6.28)))
    sigma = float(rng.choice([0.2, 0.5, 1.0]))
    shift = sigma * float(rng.choice([0.0, 0.5, 1.0]))
    lost = constant(-float(rng.uniform(0.0, 5.0)))
    axis = Axis(
        f"{period:.5g}/{amplitude:.2f}", together(*parts), lost, scatter(sigma, shift), targets
    )
    axis.readings = axis.test(rng, targets)
    return axis


def judged(virtual: Axis, number: int, *, sound: bool) -> dict[str, object]:
    """Make a table of the test, decide, and try the decisions with fresh tests."""
    axis = JobAxis(name="X", kind=AxisKind.LINEAR, travel=virtual.travel, address="X")
    entry = AxisJob(
        axis=axis,
        before=(TestRequest(files=("x.csv",), name=f"x{number}"),),
    )
    test = PositioningTest(
        name=f"x{number}",
        axis="X",
        kind=AxisKind.LINEAR,
        frame="machine",
        targets=virtual.targets,
        positive=virtual.readings[0].T * UM,
        negative=virtual.readings[1].T * UM,
        runs_positive=tuple(range(virtual.runs)),
        runs_negative=tuple(range(virtual.runs)),
    )
    job = Job(file="job.yaml", format="bench", axes={"X": entry})
    planned = (PlannedTest(test=test, measured_in="as_found"),)
    state = {"as_found": ControlState(format="bench", axes={})}
    work = start_axis(job, entry, planned, state, no_correction)
    nodes = np.arange(0.0, TRAVEL + 5.0, 10.0)
    estimate = work.posterior.summary(nodes)

    def change(positions: Values, way: Direction) -> Values:
        return -np.interp(positions, nodes, estimate.mean(way))

    values = fresh_values(virtual, change, np.random.default_rng([5, number]))
    predicted = predict_axis(work, change, None, job).tests[0]
    limits = (
        [factor * float(np.median(values)) for factor in SOUND_FACTORS]
        if sound
        else [factor * predicted.predicted["A"].p95 / UM for factor in FACTORS]
    )
    decisions = []
    for limit in limits:
        entry = replace(entry, accept=Acceptance(limits={"A": limit}))
        decisions.append(accept_decisions(entry, (predicted,), "simple")["A"].decision)
    return {
        "axis": virtual.name,
        "targets": len(virtual.targets),
        "same": round(predicted.predicted["A"].p95 / UM, 3),
        "new": round(predicted.predicted_new_targets["A"].p95 / UM, 3),
        "fresh": [round(float(v), 3) for v in np.quantile(values, (0.05, 0.5, 0.95))],
        "limits": [round(limit, 3) for limit in limits],
        "decisions": decisions,
        "broken": [float(np.mean(values > limit)) for limit in limits],
        "periods": [(p.period, p.probability) for p in work.posterior.own.periods],
    }


def fresh_values(virtual: Axis, change: Callable[..., Values], rng: np.random.Generator) -> Values:
    """Return A of fresh tests at new targets, µm."""
    values = []
    for _ in range(FRESH):
        targets = dithered(rng, len(virtual.targets), virtual.travel)
        more = np.array([change(targets, way) for way in Direction]) / UM
        values.append(accuracy(virtual.test(rng, targets, more)))
    return np.array(values)


def share(values: list[float]) -> str:
    """Return a mean in per cent, with its standard error."""
    if not values:
        return "  -"
    error = np.std(values, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else 0.0
    return f"{100 * np.mean(values):.1f} ± {100 * error:.1f} %"


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=260)
    parser.add_argument("--sound", action="store_true")
    parser.add_argument("--kind", action="append", default=[])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    kinds = options.kind or KINDS
    found: dict[str, list[dict[str, object]]] = {kind: [] for kind in kinds}
    for number in range(options.count):
        kind = kinds[number % len(kinds)]
        rng = np.random.default_rng([options.seed, number, KINDS.index(kind)])
        result = judged(machine(kind, rng, sound=options.sound), number, sound=options.sound)
        found[kind].append(result)
        if options.out:
            with options.out.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps({"kind": kind, **result}) + "\n")
    everything: list[float] = []
    for kind, results in found.items():
        pairs = [
            (place, decision, broken)
            for each in results
            for place, (decision, broken) in enumerate(
                zip(each["decisions"], each["broken"], strict=True)  # type: ignore[call-overload]
            )
        ]
        accepted = [broken for _, decision, broken in pairs if decision == "accept"]
        everything += accepted
        by_factor = [
            sum(place == at and decision == "accept" for place, decision, _ in pairs)
            for at in range(len(SOUND_FACTORS if options.sound else FACTORS))
        ]
        print(
            f"{kind:16} {len(results):4} axes, accepted {by_factor}, broken {share(accepted)}",
            flush=True,
        )
    print(f"all: {len(everything)} limits accepted, broken by {share(everything)}")


if __name__ == "__main__":
    main()
