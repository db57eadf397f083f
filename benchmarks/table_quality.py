"""How good are the tables, and how honest the predictions? Several hundred virtual axes by kind.

    python benchmarks/table_quality.py [N] [--kind K]... [--results FILE] [--jobs J]

For each axis: a test, ``run``, then fresh tests with the table that ``run`` wrote, at the same
targets and at targets dithered anew. Asked: does a parameter lie within p05 to p95; how large is A
beside that of the table that knows the truth, on the same nodes and for the same fresh readings;
what would other tables have done; was the period found.

Width: mean width of the bands (of A alone) over that of a judge who knows kind and size of the
noise and the family of the error curve, and has seen the same readings (``informed.py``); how often
the judge's own bands hold is printed with ``--details``, and its table stands beside the others.
Where the job gives no period, a second judge must find them in the readings (``period unknown``).

Not every kind can reach 84 %. Where a traverse is off now and then, a third of the first tests show
none. A judge who does not know that the axis is of this kind holds 79 % (``bench_rare_shift.py``).

``--results`` keeps every axis in a file of JSON lines and does not repeat what stands there.
Prints and judges nothing.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import io
import json
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from informed import Informed, inform
from machine_kinds import KINDS, machine_of
from machines import Machine, name_seed
from numpy.typing import NDArray
from quality_summary import PARAMETERS, Record, show
from rival_tables import Table, parameters, rivals

Floats = NDArray[np.float64]
FRESH = 8  # tests after loading, at the same targets and at new ones
DRAWS = 160  # of the judge who knows the noise


def test_files(count: int) -> list[str]:
    """Return the names of the files of ``count`` tests."""
    return ["x.csv", *(f"x{number}.csv" for number in range(2, count + 1))]


def job_of(machine: Machine) -> str:
    """Return the job file, for a control whose table is no limit."""
    axis: dict[str, Any] = {
        "travel": [machine.low, machine.high],
        "address": "AX1",
        "before": test_files(machine.tests),
        "table": {"spacing": machine.spacing, "mode": machine.mode},
    }
    if machine.rotary:
        axis["kind"] = "rotary"
    if machine.turn:
        axis["modulo"] = machine.turn
    if machine.told:
        axis["screw_pitch"] = list(machine.told)
    options = {"cec": "available", "cec_sign": "error", "cec_tables": [0, 1]}
    return json.dumps(
        {
            "compwright": 1,
            "controller": {"format": "siemens-840d-sl", "options": options},
            "states": {"as_found": "none"},
            "axes": {"X": axis},
            **machine.job,
        }
    )


def csv_of(machine: Machine, x: Floats, readings: Floats, name: str = "X") -> str:
    """Return the measurement file of axis ``name``."""
    target, unit = ("deg", "arcsec") if machine.rotary else ("mm", "um")
    lines = [
        f"# axis: {name}",
        "# cycle: standard",
        f"target_{target},direction,run,deviation_{unit}",
    ]
    for word, block in zip("+-", readings, strict=True):
        for i, row in enumerate(block):
            lines += [
                f"{x[i]:.3f},{word},{run + 1},{value:.4f}"
                for run, value in enumerate(row)
                if np.isfinite(value)
            ]
    return "\n".join(lines) + "\n"


def measured(
    machine: Machine, rng: np.random.Generator, warm: float, acting: Floats | None = None
) -> Floats:
    """Return a test as the instrument leaves it, which rounds once what the axis does with the
    correction ``acting`` (2, m); NaN where a reading was not made.
    """
    moved = machine.measure(machine.targets, rng, warm)
    readings = machine.seen(moved if acting is None else moved + acting[:, :, None])
    lost = rng.uniform(size=readings.shape) < machine.missing
    lost[:, :, :2] = False  # a cell keeps two
    readings[lost] = np.nan
    for index, sign in enumerate((1, -1)):
        if sign not in machine.signs:
            readings[index] = np.nan
    return readings


def run_tool(machine: Machine, tests: list[Floats], folder: Path) -> tuple[Record, float]:
    """Return ``axes.X`` of the prediction and the seconds of the run."""
    from compwright.cli import run

    for file, readings in zip(test_files(len(tests)), tests, strict=True):
        text = csv_of(machine, machine.targets, readings)
        (folder / file).write_text(text, encoding="utf-8")
    (folder / "job.yaml").write_text(job_of(machine), encoding="utf-8")
    said = io.StringIO()
    start = time.perf_counter()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        code = run(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])
    seconds = time.perf_counter() - start
    if code not in {0, 1}:
        raise RuntimeError(said.getvalue())
    document = json.loads((folder / "out" / "prediction.json").read_text(encoding="utf-8"))
    return document["axes"]["X"], seconds


def experiment(kind: str, number: int) -> Record:
    """Measure, run, measure again."""
    machine = machine_of(kind, number)
    rng = name_seed(kind, number, 1)
    warm = machine.temperature(rng)
    tests = [measured(machine, rng, warm)]
    tests += [measured(machine, rng, machine.temperature(rng)) for _ in range(machine.tests - 1)]
    record: Record = {"kind": kind, "number": number}
    with tempfile.TemporaryDirectory() as name:
        try:
            axis, record["seconds"] = run_tool(machine, tests, Path(name))
        except Exception as error:  # noqa: BLE001 - a run that fails is a result
            return {**record, "failed": f"{type(error).__name__}: {error}"[:500]}
    table = axis["table"]
    nodes = np.array(table["positions"] if table else [machine.low, machine.high], dtype=float)
    grid = nodes if table else np.arange(machine.low, machine.high, machine.spacing)
    ours = np.zeros((2, nodes.size))
    if table:
        ours = np.array([table["correction_positive"], table["correction_negative"]])
    known = inform(machine, tests)
    tables = rivals(machine, tests[0], grid, warm, known)
    tables["ours"] = Table(nodes, ours, machine.turn)
    fresh = _fresh(machine, tables, name_seed(kind, number, 2))
    return {
        **record,
        **fresh,
        "no_table": not table,
        "bands": {
            where: _bands(axis[key], machine.signs)
            for where, key in (("same", "predicted"), ("new", "predicted_new_targets"))
        },
        "informed": _informed_bands(known, tables["ours"], name_seed(kind, number, 3)),
        "periods": axis.get("periods", []),
        "codes": sorted(entry["code"] for entry in axis.get("findings", [])),
        "truth": list(machine.periods),
        "told": list(machine.told),
        "length": machine.length,
    }


def _bands(predicted: Mapping[str, Any] | None, signs: tuple[int, ...]) -> Record:
    """Return [p05, median, p95] by parameter; those of the one direction under the short names."""
    ending = "" if len(signs) == 2 else "_positive" if signs[0] > 0 else "_negative"
    bands = {}
    for name in PARAMETERS:
        entry = (predicted or {}).get(name + ending if name in "AER" else name)
        if entry:
            bands[name] = [entry["p05"], entry["median"], entry["p95"]]
    return bands


def _fresh(machine: Machine, tables: Mapping[str, Table], rng: np.random.Generator) -> Record:
    """Return, for the same and for new targets, our parameters in each fresh test, and the
    mean A (E where a test has no A) of each table; all tables see the same readings.
    """
    ours: Record = {"same": defaultdict(list), "new": defaultdict(list)}
    merit: Record = {where: dict.fromkeys(tables, 0.0) for where in ours}
    for where in ours:
        for _ in range(FRESH):
            x = machine.targets if where == "same" else machine.new_targets(rng)
            raw = machine.measure(x, rng, machine.temperature(rng))
            for name, table in tables.items():
                values = parameters(machine.seen(raw + table.at(x)[:, :, None]), machine.signs)
                merit[where][name] += values.get("A", values["E"]) / FRESH
                if name == "ours":
                    for key, value in values.items():
                        ours[where][key].append(round(value, 4))
    return {"fresh": ours, "merit": merit}


def _informed_bands(known: Informed, table: Table, rng: np.random.Generator) -> Record:
    """Return [p05, median, p95] by parameter of who knows the noise, with our table loaded."""
    machine = known.machine
    bands: Record = {}
    for where in ("same", "new"):
        values = defaultdict(list)
        for _ in range(DRAWS):
            x = machine.targets if where == "same" else machine.new_targets(rng)
            mean = known.error(x, rng) + table.at(x)
            raw = mean[:, :, None] + machine.scatter(x, rng, machine.temperature(rng))
            for name, value in parameters(machine.seen(raw), machine.signs).items():
                values[name].append(value)
        bands[where] = {
            name: [round(float(q), 4) for q in np.quantile(some, [0.05, 0.5, 0.95])]
            for name, some in values.items()
        }
    return bands


# ---- the work


def main() -> None:
    """Work, then print."""
    reader = argparse.ArgumentParser(description="Tables and predictions on virtual axes by kind.")
    reader.add_argument("count", nargs="?", type=int, default=20, help="axes per kind")
    reader.add_argument("--kind", action="append", help="only kinds with this in their names")
    reader.add_argument("--results", type=Path, help="JSON lines, read and added to")
    reader.add_argument("--jobs", type=int, default=1, help="processes")
    reader.add_argument("--seconds", type=float, default=float("inf"), help="stop after these")
    reader.add_argument("--details", action="store_true", help="each parameter's misses")
    words = reader.parse_args()
    kinds = [k for k in KINDS if not words.kind or any(part in k for part in words.kind)]
    records: list[Record] = []
    if words.results and words.results.exists():
        lines = words.results.read_text(encoding="utf-8").splitlines()
        records = [json.loads(line) for line in lines]
    done = {(one["kind"], one["number"]) for one in records}
    tasks = [(kind, number) for number in range(words.count) for kind in kinds]
    todo = [task for task in tasks if task not in done]
    end = time.monotonic() + words.seconds
    importlib.import_module("osqp")  # which wants it, too
    sys.modules["jinja2"] = None  # type: ignore[assignment] # no report: nobody reads it here
    for record in _worked(todo, words.jobs, end):
        records.append(record)
        if words.results:
            with words.results.open("a", encoding="utf-8") as file:
                file.write(json.dumps(record) + "\n")
    show(records, kinds, details=words.details)


def _worked(todo: Sequence[tuple[str, int]], jobs: int, end: float) -> Iterator[Record]:
    if jobs == 1:
        for task in todo:
            if time.monotonic() > end:
                return
            yield experiment(*task)
        return
    with ProcessPoolExecutor(jobs) as pool:  # in portions, so that an end comes soon
        for start in range(0, len(todo), 8 * jobs):
            if time.monotonic() > end:
                return
            yield from pool.map(experiment, *zip(*todo[start : start + 8 * jobs], strict=True))


if __name__ == "__main__":
    main()
