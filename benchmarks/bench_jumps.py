"""Tables of axes whose error jumps, against straight lines between the means of the same test.

    python benchmarks/bench_jumps.py [N] [--kind jumps|ordinary|small] [--tests T] [--seed S]
        [--first F] [--out FILE]

Virtual axes from physics alone (`examiner_axes.py`): a smooth error, a lost motion and a jump of 3
to 200 µm at any place (`small`: 5 to 10 µm at 8 targets; `ordinary`: no jump), measured at 6 to 100
targets in one or both directions, for LinuxCNC, FANUC and SINUMERIK in turn. Judged without the
estimate: mean A (E in one direction) of fresh tests at new targets, the same random numbers
for both tables, with what `run` writes and with the interpolated means put on the same points,
rounded alike and put out as the control does it (FANUC: a step in the middle between two points).
Where no table is written nothing is corrected. Every axis is measured T times, each time with
tables of its own: the noise of that test makes either of them the better one by chance. Prints each
axis that is worse on average by more than two standard errors and 0.1 µm, and the ratios.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from examiner_axes import (
    TRAVEL,
    Axis,
    Values,
    constant,
    dithered,
    jump,
    scatter,
    smooth,
    spread_targets,
    together,
    wave,
    write_test,
)

from compwright.documents.prediction import compensation_outside
from compwright.foundations.errors import CompwrightError
from compwright.foundations.session import Session
from compwright.workflow.inputs.jobs import read_job_file
from compwright.workflow.run.pipeline import run_stages

FRESH = 20
NOTHING = {
    "positions": [0.0, TRAVEL],
    "correction_positive": [0.0, 0.0],
    "correction_negative": [0.0, 0.0],
}
#: Formats with the axis' address, options, and the step of a value, µm.
CONTROLS: dict[str, tuple[Any, dict[str, Any], float]] = {
    "linuxcnc": ("0", {}, 0.0),
    "fanuc-30i": (1, {"detection_unit": 0.001, "first_point": 100}, 1.0),
    "siemens-840d-sl": ("AX1", {}, 0.0),
}


def machine(kind: str, rng: np.random.Generator) -> tuple[Axis, tuple[int, ...]]:
    """Return an axis with its test, and the directions that were measured."""
    size = float(rng.choice([-1, 1]) * np.exp(rng.uniform(np.log(3.0), np.log(200.0))))
    count = round(float(np.exp(rng.uniform(np.log(6.0), np.log(100.0)))))
    if kind == "small":
        size, count = float(rng.choice([-1, 1]) * rng.uniform(5.0, 10.0)), 8
    parts = [smooth(rng, float(rng.choice([2.0, 5.0, 10.0])))]
    if kind != "ordinary":
        parts.append(jump(float(rng.uniform(0.05, 0.95) * TRAVEL), size))
    if rng.random() < 0.2:
        parts.append(wave(1.5, 10.0, rng.uniform(0, 6.28)))
    sigma = float(rng.choice([0.2, 0.5, 1.0]))
    noise = scatter(sigma, sigma * float(rng.choice([0.0, 1.0])))
    lost = constant(-float(rng.choice([0.0, 3.0])))
    targets = spread_targets(count, rng=rng if rng.random() < 0.7 else None)
    name = f"{size if kind != 'ordinary' else 0:+.1f} µm at {count} targets"
    axis = Axis(name, together(*parts), lost, noise, targets)
    axis.test(rng, targets)  # keeps the numbers of these machines
    return axis, (0,) if rng.random() < 0.2 else (0, 1)


def table_of(axis: Axis, ways: tuple[int, ...], control: str, folder: Path) -> dict[str, Any]:
    """Return what `run` writes, as its judge reads it back; nothing where it writes none."""
    address, options, _ = CONTROLS[control]
    write_test(folder / "x.csv", "X", axis.targets, axis.readings)
    if len(ways) == 1:
        text = (folder / "x.csv").read_text(encoding="utf-8").splitlines(keepends=True)
        kept = "".join(line for line in text if ",-," not in line)
        (folder / "x.csv").write_text(kept, encoding="utf-8")
    entry = {"travel": [0, TRAVEL], "address": address, "before": ["x.csv"]}
    job = {
        "compwright": 1,
        "controller": {"format": control, "options": options},
        "states": {"as_found": "none"},
        "axes": {"X": entry},
    }
    (folder / "job.yaml").write_text(json.dumps(job), encoding="utf-8")
    read = read_job_file(Session(), folder / "job.yaml")
    found = run_stages(Session(), read, folder, folder / "out")
    table = found.predicted.axes["X"].table
    return NOTHING if table is None else compensation_outside(table)


def straight(axis: Axis, table: dict[str, Any], control: str) -> dict[str, Any]:
    """Return the means on the same points: rounded as this control rounds, one curve and a
    backlash where it has no more.
    """
    nodes = np.array(table["positions"] if table is not NOTHING else axis.targets, dtype=float)
    means = -axis.readings.mean(axis=1)
    both = np.array([np.interp(nodes, axis.targets, one) for one in means])
    if control != "linuxcnc":
        half = float(np.mean(means[0] - means[1])) / 2.0
        both = np.array([both.mean(axis=0) + half, both.mean(axis=0) - half])
    step = CONTROLS[control][2]
    if step:
        both = step * np.round(both / step)
    names = ("correction_positive", "correction_negative")
    return {"positions": nodes.tolist()} | dict(zip(names, both.tolist(), strict=True))


def corrections(table: dict[str, Any], targets: Values, control: str) -> Values:
    """Return what the control adds at targets, in both directions."""
    nodes = np.array(table["positions"])
    if control == "fanuc-30i":
        targets = nodes[np.searchsorted(0.5 * (nodes[1:] + nodes[:-1]), targets)]
    names = ("correction_positive", "correction_negative")
    return np.array([np.interp(targets, nodes, table[name]) for name in names])


def left(
    axis: Axis, ways: tuple[int, ...], tables: list[dict[str, Any]], control: str, seed: list[int]
) -> Values:
    """Return the mean A (µm) of fresh tests at new targets (tables,)."""
    values = np.empty((len(tables), FRESH))
    for test in range(FRESH):
        rng = np.random.default_rng([3, *seed, test])
        targets = dithered(rng, len(axis.targets), axis.travel)
        for place, table in enumerate(tables):
            rng = np.random.default_rng([4, *seed, test])
            readings = axis.test(rng, targets, corrections(table, targets, control))[list(ways)]
            mean, spread = readings.mean(axis=1), 2.0 * readings.std(axis=1, ddof=1)
            values[place, test] = (mean + spread).max() - (mean - spread).min()
    return np.asarray(values.mean(axis=1))


def compared(
    axis: Axis, ways: tuple[int, ...], control: str, seed: list[int], tests: int
) -> Values:
    """Return the mean A (µm) after each first test, with `run`, with lines, with nothing
    (tests, 3).
    """
    values = []
    for test in range(tests):
        axis.readings = axis.test(np.random.default_rng([2, *seed, test]), axis.targets)
        with tempfile.TemporaryDirectory() as name:
            table = table_of(axis, ways, control, Path(name))
        tables = [table, straight(axis, table, control), NOTHING]
        values.append(left(axis, ways, tables, control, [*seed, test]))
    return np.array(values)


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=100)
    parser.add_argument("--kind", default="jumps", choices=["jumps", "small", "ordinary"])
    parser.add_argument("--tests", type=int, default=5, help="first tests of each axis")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    ratios, worse = [], 0
    for number in range(options.first, options.first + options.count):
        rng = np.random.default_rng([options.seed, number, len(options.kind)])
        axis, ways = machine(options.kind, rng)
        control = list(CONTROLS)[number % len(CONTROLS)]
        what = f"{number} {control}, {axis.name}, {len(ways)} directions"
        try:
            values = compared(axis, ways, control, [options.seed, number], options.tests)
        except CompwrightError as fault:
            print(f"{what}: {fault}", flush=True)
            continue
        ours, lines, before = values.mean(axis=0)
        more = values[:, 0] - values[:, 1]
        error = float(more.std(ddof=1) / np.sqrt(more.size))
        ratios.append(ours / lines)
        is_worse = more.mean() > max(2.0 * error, 0.1)
        worse += is_worse
        if is_worse:
            print(
                f"WORSE: {what}: A {ours:.2f}, straight lines {lines:.2f} (difference"
                f" {more.mean():.2f} ± {error:.2f}), before {before:.2f}",
                flush=True,
            )
        if options.out:
            values_of = {"ours": ours, "lines": lines, "before": before, "error": error}
            record = {"number": number, "what": what, "worse": bool(is_worse), **values_of}
            with options.out.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(record) + "\n")
    shares = np.array(ratios)
    print(
        f"{options.kind}: {shares.size} axes, A by that of straight lines: geometric mean"
        f" {np.exp(np.mean(np.log(shares))):.3f}, at most {shares.max():.3f};"
        f" worse beyond noise {worse}"
    )


if __name__ == "__main__":
    main()
