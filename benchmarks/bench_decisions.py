"""How often is a sound test doubted, and a limit left undecided that the same targets would accept?

    python benchmarks/bench_decisions.py [N] [--limits M] [--kind K]...

Machine ``number`` of each kind of ``machine_kinds.py`` in turn, N in all: a job without limits,
``run``. Its test is what it says, so each doubt is a false one. The first M machines run once more
with a limit on A of 1.3 times the predicted 95 % value at the same targets; what is not accepted
then is open because of new targets. Prints each doubt, each such limit, and the counts.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from machine_kinds import KINDS, machine_of
from machines import Machine, name_seed
from table_quality import csv_of, job_of, measured


def prediction(machine: Machine, text: str, limits: dict[str, float]) -> tuple[int, Any]:
    """Run a job of one axis; return exit code and prediction (None without one)."""
    from compwright.cli import run

    job = json.loads(job_of(machine))
    job["axes"]["X"]["accept"] = limits
    if not limits:
        del job["axes"]["X"]["accept"]
    said = io.StringIO()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "x.csv").write_text(text, encoding="utf-8")
        (folder / "job.yaml").write_text(json.dumps(job), encoding="utf-8")
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = run(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])
        path = folder / "out" / "prediction.json"
        return code, json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=300)
    parser.add_argument("--limits", type=int, default=60)
    parser.add_argument("--kind", action="append", default=[])
    options = parser.parse_args()
    kinds = options.kind or list(KINDS)
    doubts: Counter[str] = Counter()
    doubted = runs = tried = accepted = 0
    for index in range(options.count):
        kind, number = kinds[index % len(kinds)], index // len(kinds)
        machine = machine_of(kind, number)
        rng = name_seed(kind, number, 1)
        readings = measured(machine, rng, machine.temperature(rng))
        text = csv_of(machine, machine.targets, np.asarray(readings))
        code, found = prediction(machine, text, {})
        if found is None:
            print(kind, number, "exit", code, flush=True)
            continue
        runs += 1
        codes = [one["code"] for one in found["doubts"]]
        doubted += bool(codes)
        doubts.update(codes)
        if codes:
            print(kind, number, *codes, flush=True)
        band = found["axes"]["X"]["predicted"].get("A")
        if band is None or tried >= options.limits or codes:
            continue
        tried += 1
        _, decided = prediction(machine, text, {"A": 1.3 * band["p95"]})
        decision = decided["axes"]["X"]["accept"]["A"]["decision"]
        accepted += decision == "accept"
        if decision != "accept":
            new = decided["axes"]["X"]["predicted_new_targets"]["A"]["p95"]
            print(kind, number, f"limit {1.3 * band['p95']:.2f}, new targets {new:.2f}: {decision}")
    print(f"doubted {doubted} of {runs}: {dict(doubts)}")
    print(f"limits at 1.3 times the 95 % value: {accepted} of {tried} accepted")


if __name__ == "__main__":
    main()
