"""How often is a sound test doubted, and a limit left undecided that the same targets would accept?

    python benchmarks/bench_decisions.py [N] [--first F] [--limits M] [--kind K]...

Machine ``number`` of each kind of ``machine_kinds.py`` in turn, N in all from the F-th: a job
without limits, worked through without its pages. Its test is what it says, so each doubt is a
false one. The first M machines run once more with a limit on A of 1.3 times the predicted 95 %
value at the same targets; what is not accepted then is open because of new targets. Prints
each doubt, each such limit, and the counts.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from machine_kinds import KINDS, machine_of
from machines import Machine, name_seed
from table_quality import csv_of, job_of, measured, test_files

from compwright.foundations.errors import CompwrightError
from compwright.foundations.session import Session
from compwright.foundations.units import outside_factor
from compwright.workflow.inputs.jobs import read_job_file
from compwright.workflow.run.pipeline import run_stages
from compwright.workflow.run.run_results import Finished


def prediction(
    machine: Machine, texts: Sequence[str], limits: dict[str, float], folder: Path
) -> tuple[Finished | None, str]:
    """Return a job of one axis worked through, less its pages; None and why where it fails."""
    job = json.loads(job_of(machine))
    if limits:
        job["axes"]["X"]["accept"] = limits
    for file, text in zip(test_files(len(texts)), texts, strict=True):
        (folder / file).write_text(text, encoding="utf-8")
    (folder / "job.yaml").write_text(json.dumps(job), encoding="utf-8")
    try:
        return run_stages(
            Session(), read_job_file(Session(), folder / "job.yaml"), folder, folder / "out"
        ), ""
    except CompwrightError as error:
        return None, str(error)


@dataclass
class Counts:
    """What the runs came to."""

    runs: int = 0
    doubted: int = 0
    doubts: Counter[str] = field(default_factory=Counter)
    tried: int = 0
    accepted: int = 0

    def show(self) -> None:
        """Print the counts."""
        print(f"doubted {self.doubted} of {self.runs}: {dict(self.doubts)}")
        print(
            f"limits at 1.3 times the 95 % value: {self.accepted} of {self.tried} accepted",
            flush=True,
        )


def count(kind: str, number: int, folder: Path, counts: Counts, limits: int) -> None:
    """Run one machine, and once more with a limit while fewer than ``limits`` were tried."""
    machine = machine_of(kind, number)
    rng = name_seed(kind, number, 1)
    texts = [
        csv_of(machine, machine.targets, measured(machine, rng, machine.temperature(rng)))
        for _ in range(machine.tests)
    ]
    found, why = prediction(machine, texts, {}, folder)
    if found is None:
        print(kind, number, why, flush=True)
        return
    counts.runs += 1
    doubts = [one.finding for one in found.doubts.open]
    counts.doubted += bool(doubts)
    counts.doubts.update(one.code for one in doubts)
    for one in doubts:
        print(kind, number, one.code, one.message, flush=True)
    shown = found.predicted.axes["X"].tests[0]
    if "A" not in shown.predicted or counts.tried >= limits or doubts:
        return
    counts.tried += 1
    factor = outside_factor(found.works["X"].planned.axis.kind.unit)
    limit = 1.3 * shown.predicted["A"].p95 * factor
    decided, _ = prediction(machine, texts, {"A": limit}, folder)
    decision = decided and decided.predicted.axes["X"].accept["A"].decision
    counts.accepted += decision == "accept"
    if decision != "accept":
        new = shown.predicted_new_targets["A"].p95 * factor
        print(kind, number, f"limit {limit:.2f}, new targets {new:.2f}: {decision}")


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=300)
    parser.add_argument("--first", type=int, default=0, help="begin with this machine of all")
    parser.add_argument("--limits", type=int, default=60)
    parser.add_argument("--kind", action="append", default=[])
    options = parser.parse_args()
    kinds = options.kind or list(KINDS)
    counts = Counts()
    with tempfile.TemporaryDirectory() as name:
        for index in range(options.first, options.first + options.count):
            kind, number = kinds[index % len(kinds)], index // len(kinds)
            count(kind, number, Path(name), counts, options.limits)
    counts.show()


if __name__ == "__main__":
    main()
