"""Do repeated rounds converge on every control, and stop by themselves?

    python benchmarks/rounds.py [--count N] [--seed S] [--control C]... [--kind K]... [--rounds R]

For each control that writes tables: a virtual axis is measured (every second one at seven places
only, twice), ``run`` makes a table, the virtual machine applies what ``decode`` says of it, a fresh
test follows, and ``verify --update`` with the loaded files read back makes the tables of the next
round, until it writes none. Printed, by control and round: A of the fresh test over that of an axis
without error (same noise, same targets; median, and the largest), and how many stopped; what else
ended a loop, by its reason.

Then the same with a machine that applies every correction with the opposite sign: the first
verification has to say so, and nothing may be written for a next round.

Prints and judges nothing.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from fault_machines import FLEET, Axis, axis_of, job_axis
from loaded_controls import CONTROLS, Control, Loaded, said, without_reports
from machines import Floats, Machine, dithered, name_seed
from numpy.random import Generator
from table_quality import csv_of, measured

Record = dict[str, Any]
FLOORS = 60  # tests of an axis without error
#: Errors from lowest to highest, µm: more than whole increments of a micrometre leave.
SIZES = (15.0, 60.0)
#: Kinds that no test after loading tells much about, or that the controls hold only in part.
LEFT_OUT = ("one direction only", "long axis, n = 1", "steps", "worn spot", "kink")


def loop(control: Control, axis: Axis, rng: Generator, rounds: int, sign: float = 1.0) -> Record:
    """Go round until nothing is written; ``sign``: with which the machine applies corrections."""
    record: Record = {"control": control.format, "kind": axis.kind, "A": [], "verdicts": []}
    floor = _floor(axis.after, rng)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        record["A"].append(_a(axis.before, _first_test(control, axis, rng, folder)))
        code, _, why = said("run", str(folder / "job.yaml"), "--out", str(folder / "out"))
        tables = folder / "out" / "tables" / control.format
        if code not in {0, 1} or not tables.exists():
            return {**record, "end": f"run {code}", "why": why.strip()[-200:]}
        job, out = folder / "job.yaml", folder / "out"
        rotary = frozenset(axis.name if axis.before.rotary else "")
        for number in range(1, rounds + 1):
            acting = sign * Loaded(control, tables, rotary).at(axis.name, axis.after.targets)
            a, document, why = _verify(axis, acting, tables, job, out, number, rng)
            record["A"].append(a / floor)
            if document is None:
                return {**record, "end": "failed", "why": why}
            following = document["next"]
            record["verdicts"].append(document["axes"][axis.name]["loading"]["verdict"])
            further = following["axes"].get(axis.name) or {}
            if not (following["written"] and further.get("table")):
                why = further.get("reason") or following["reason"]
                return {**record, "end": "stopped", "why": why}
            job, out = out / "next" / "job.yaml", out / "next"
            tables = out / "tables" / control.format
        return {**record, "end": "still going", "why": ""}


def _first_test(control: Control, axis: Axis, rng: Generator, folder: Path) -> Floats:
    machine = axis.before
    readings = measured(machine, rng, machine.temperature(rng))
    text = csv_of(machine, machine.targets, readings, axis.name)
    (folder / f"{axis.name}.csv").write_text(text, encoding="utf-8")
    options = {"first_point": 0} if control.increments else {}
    job = {
        "compwright": 1,
        "controller": {"format": control.format, "options": dict(control.options)},
        "states": {"as_found": "none"},
        "axes": {axis.name: job_axis(axis, control.addresses[axis.name], options)},
    }
    (folder / "job.yaml").write_text(json.dumps(job), encoding="utf-8")
    return readings


def _verify(
    axis: Axis,
    acting: Floats,
    tables: Path,
    job: Path,
    out: Path,
    number: int,
    rng: Generator,
) -> tuple[float, Mapping[str, Any] | None, str]:
    """Measure with ``acting`` loaded, verify and update: A, the answer, why there is none."""
    machine = axis.after
    readings = measured(machine, rng, machine.temperature(rng), acting)
    path = out / f"after-{number}.csv"
    path.write_text(csv_of(machine, machine.targets, readings, axis.name), encoding="utf-8")
    code, answer, why = said(
        *("verify", str(job), "--after", str(path), "--plan", str(out), "--out", str(out)),
        *("--loaded", str(tables), "--update", "--json", "-"),
    )
    document = json.loads(answer) if code in {0, 1} else None
    return _a(machine, readings), document, f"verify {code}: {why.strip()[-200:]}"


def _a(machine: Machine, readings: Floats) -> float:
    """A (ISO 230-2:2006, 2.24; k = 2), or E of a test without repetitions; readings may lack."""
    used = readings[[0 if sign > 0 else 1 for sign in machine.signs]]
    mean = np.nanmean(used, axis=2)
    s = np.nanstd(used, axis=2, ddof=1) if machine.runs > 1 else 0 * mean
    return float((mean + 2 * s).max() - (mean - 2 * s).min())


def _floor(machine: Machine, rng: Generator) -> float:
    """The median A of tests of this axis without any error."""
    tests = [machine.scatter(machine.targets, rng) for _ in range(FLOORS)]
    return float(np.median([_a(machine, machine.seen(test)) for test in tests]))


# ---- printing


def show(records: Sequence[Record], rounds: int) -> None:
    """Print the rounds by control and what ended the loops."""
    head = ["control", "axes", "A before, µm", *(f"round {k}" for k in range(1, rounds + 1))]
    print("| " + " | ".join([*head, "stopped", "still going", "other"]) + " |")
    print("|---" * (len(head) + 3) + "|")
    by_control: dict[str, list[Record]] = defaultdict(list)
    for one in records:
        by_control[one["control"]].append(one)
    for control, some in by_control.items():
        cells = [control, str(len(some)), f"{np.median([one['A'][0] for one in some]):.1f}"]
        for number in range(1, rounds + 1):
            values = [one["A"][number] for one in some if len(one["A"]) > number]
            told = f"{np.median(values):.2f}, {max(values):.2f} ({len(values)})" if values else ""
            cells.append(told)
        ends = Counter(one["end"] for one in some)
        other = sum(ends.values()) - ends["stopped"] - ends["still going"]
        cells += [str(ends["stopped"]), str(ends["still going"]), str(other)]
        print("| " + " | ".join(cells) + " |")
    print("\nA of the round over A of an axis without error: median, largest (axes)\n")
    whys = Counter((one["end"], tuple(one["verdicts"]), one["why"][:160]) for one in records)
    for (end, verdicts, why), count in whys.most_common():
        print(f"{count} x {end}, {' '.join(verdicts) or 'no verdict'}: {why}")


def main() -> None:
    """Work, then print."""
    reader = argparse.ArgumentParser(
        description="Rounds of measuring and loading on every control."
    )
    reader.add_argument("--count", type=int, default=3, help="axes for each control")
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--rounds", type=int, default=4)
    reader.add_argument("--control", action="append", choices=sorted(CONTROLS))
    reader.add_argument("--kind", action="append", help="only kinds with this in their names")
    words = reader.parse_args()
    without_reports()
    kinds = [kind for kind in FLEET if kind not in LEFT_OUT]
    kinds = [kind for kind in kinds if not words.kind or any(part in kind for part in words.kind)]
    straight, turned = [], []
    for name in words.control or CONTROLS:
        for number in range(words.count):
            rng = name_seed(f"rounds, {name}", words.seed, number)
            kind, size = str(rng.choice(kinds)), float(rng.uniform(*SIZES))
            if kind == "endless rotary axis" and not CONTROLS[name].endless:
                kind = "rotary, limited"
            axis = axis_of(kind, 1000 * words.seed + number, "X", size)
            axis = replace(axis, spacing="auto")  # what the control holds and the error needs
            axis = _first_test_thin(axis, rng) if number % 2 else axis
            straight.append(loop(CONTROLS[name], axis, rng, words.rounds))
            turned.append(loop(CONTROLS[name], axis, rng, 1, sign=-1.0))
    print("## as it should be\n")
    show(straight, words.rounds)
    print("\n## every correction the wrong way round\n")
    show(turned, 1)


def _first_test_thin(axis: Axis, rng: Generator) -> Axis:
    """The first test at seven places, twice: what it leaves open the next rounds have to find."""
    machine = axis.before
    few = dithered(rng, machine.low, machine.length, 7)
    return replace(axis, before=replace(machine, targets=few, runs=2, missing=0.0))


if __name__ == "__main__":
    main()
