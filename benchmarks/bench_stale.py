"""Is yesterday's test given with today's table noticed, and an honest second test left alone?

    OPENBLAS_NUM_THREADS=1 python benchmarks/bench_stale.py [N] [--first F] [--kind K]... [--out F]

Physics alone: an axis with a known error, the table that was in its control, a test with that table
active, and the table that ``run`` makes of it, loaded. Then the second job: its state is what was
loaded; its test is the first one again in another form (stale), or a new one that was taken with
the table active (honest). Controls: FANUC, SINUMERIK, LinuxCNC; one table or two; with and
without a table before; with and without the first plan where `run` looks for earlier ones.

Harm: no doubt, and a table that makes the true A larger by a tenth and 0.5 µm. Prints each harm,
each honest test that is doubted, and the counts by kind. `--out`: JSON lines of all cases.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from examiner_axes import (
    Axis,
    accuracy,
    constant,
    smooth,
    sound,
    spread_targets,
    together,
    write_test,
)

from compwright.foundations.errors import CompwrightError
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import AxisCompensation
from compwright.workflow.inputs.jobs import read_job_file
from compwright.workflow.run.pipeline import run_stages
from compwright.workflow.run.run_results import Finished

Values = np.ndarray[Any, np.dtype[np.float64]]
#: How a control is named in a job; a second table of a FANUC needs a backup of its own.
CONTROLS = {
    "fanuc": "{format: fanuc-30i, options: {first_point: 100, detection_unit: 0.001}}",
    "sinumerik": "{format: siemens-840d-sl,"
    " options: {cec: available, cec_sign: error, cec_tables: [0, 1]}}",
    "linuxcnc": "{format: linuxcnc}",
}
ADDRESSES = {"fanuc": "1", "sinumerik": "AX1", "linuxcnc": "0"}
STALE = ("rounded", "datum", "three runs", "other order of runs", "every second target")
HONEST = ("honest", "honest, worn", "honest, grown", "honest, new targets")


@dataclass(frozen=True)
class Case:
    """One machine: its control, whether a table was in it before its first test, whether the first
    plan can be seen by the second job, and the second test.
    """

    number: int
    control: str
    mode: str
    before: bool
    visible: bool
    second: str

    @property
    def stale(self) -> bool:
        """Whether the second test is the first one again."""
        return self.second in STALE

    @property
    def group(self) -> str:
        """The count that it belongs to."""
        if not self.stale:
            return self.second
        return (
            f"stale, table before: {'yes' if self.before else 'no'},"
            f" plan: {'seen' if self.visible else 'not seen'}"
        )


def case_of(number: int, kinds: list[str]) -> Case:
    """Return a case: every combination in turn."""
    rng = np.random.default_rng([number, 23])
    return Case(
        number,
        control := list(CONTROLS)[number % 3],
        "single" if control == "fanuc" else ("single", "bidirectional")[number // 3 % 2],
        bool(rng.integers(4) > 0),
        bool(number // 6 % 2),
        str(kinds[number // 2 % len(kinds)]),
    )


def aged(axis: Axis, rng: np.random.Generator, share: float) -> None:
    """Let an axis wear: another smooth error of this share of its size, and some backlash."""
    where = np.linspace(*axis.travel, 200)
    more = smooth(rng, share * float(np.std(axis.error(where))))
    axis.error = together(axis.error, more)
    axis.reversal = together(axis.reversal, constant(-abs(float(rng.normal(0, 1)))))


def correction(table: AxisCompensation | None, targets: Values) -> Values | float:
    """Return what a table adds in both directions, µm."""
    if table is None:
        return 0.0
    return 1e3 * np.array([table.at(targets, direction) for direction in Direction])


def true_accuracy(axis: Axis, table: AxisCompensation | None, seed: int) -> float:
    """Return the mean A of fresh tests at targets of their own, µm."""
    rng = np.random.default_rng([seed, 99])
    values = []
    for _ in range(40):
        targets = spread_targets(25, axis.travel, rng)
        values.append(accuracy(axis.test(rng, targets, correction(table, targets))))
    return float(np.mean(values))


def run(case: Case, folder: Path, axis: Axis, state: str) -> Finished:
    """Work through a job of the axis; its tables are left below ``out`` as `run` leaves them."""
    folder.mkdir(parents=True, exist_ok=True)
    write_test(folder / "x.csv", "X", axis.targets, axis.readings)
    low, high = axis.travel
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {CONTROLS[case.control]}\nstates: {{as_found: {state}}}\n"
        f"axes:\n  X:\n    travel: [{low:g}, {high:g}]\n    address: {ADDRESSES[case.control]}\n"
        f"    table: {{mode: {case.mode}}}\n    before: x.csv\n    accept: {{A: 1000}}\n",
        encoding="utf-8",
    )
    return run_stages(
        Session(), read_job_file(Session(), folder / "job.yaml"), folder, folder / "job"
    )


def load(finished: Finished, folder: Path) -> AxisCompensation | None:
    """Leave what was written in a folder of the control; return the table, None without one."""
    table = finished.predicted.axes["X"].table
    if table is not None:
        folder.mkdir(exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        for file in finished.written.tables:
            (folder / file.name).write_bytes(file.raw)
    return table


def second_test(case: Case, axis: Axis, rng: np.random.Generator, table: AxisCompensation) -> None:
    """Give the axis the test of the second job."""
    old = axis.readings
    if case.stale:
        values = {
            "rounded": old,
            "datum": old + 7.3,
            "three runs": old[:, -3:],
            "other order of runs": old[:, rng.permutation(old.shape[1])],
            "every second target": old[:, :, ::2],
        }[case.second]
        axis.readings = np.round(values, 1)
        if case.second == "every second target":
            axis.targets = axis.targets[::2]
        return
    if case.second == "honest, worn":
        aged(axis, rng, float(rng.uniform(0.1, 0.6)))
    if case.second == "honest, grown":
        error, factor = axis.error, float(rng.uniform(0.7, 1.3))
        axis.error = lambda x: factor * error(x)
    if case.second == "honest, new targets":
        axis.targets = spread_targets(len(axis.targets), axis.travel, rng)
    axis.readings = axis.test(rng, axis.targets, correction(table, axis.targets))


def tried(case: Case, folder: Path) -> dict[str, Any] | None:
    """Return what became of a case; None where the first job writes no table."""
    rng = np.random.default_rng([case.number, 5])
    axis = sound(rng, case.number)
    table = None
    if case.before:
        axis.readings = axis.test(rng, axis.targets)
        table = load(run(case, folder / "zero", axis, "none"), folder / "control")
        aged(axis, rng, float(rng.uniform(0.2, 1.0)))
    axis.readings = axis.test(rng, axis.targets, correction(table, axis.targets))
    first = run(case, folder / "first", axis, "none" if table is None else "[../control]")
    loaded = load(first, folder / "control")
    if loaded is None:
        return None
    second_test(case, axis, rng, loaded)
    place = folder / "second"
    if case.visible:  # in the folder of the job, or in that of another day next to it
        there = place / "first" if case.number // 12 % 2 else folder / "first" / "job"
        write_plan(first, there / "plan.json")
    found = run(case, place, axis, "[../control]")
    again = found.predicted.axes["X"].table
    doubts = [one.finding.code for one in found.doubts.open]
    return entry(case, doubts, written=again is not None) | {
        "loaded A": true_accuracy(axis, loaded, case.number),
        "A again": true_accuracy(axis, again or loaded, case.number),
    }


def entry(case: Case, doubts: list[str], *, written: bool) -> dict[str, Any]:
    """Return what is kept of every case."""
    return {
        "case": case.number,
        "group": case.group,
        "control": case.control,
        "mode": case.mode,
        "second": case.second,
        "doubts": doubts,
        "written": written,
    }


def write_plan(finished: Finished, path: Path) -> None:
    """Write the plan of a run."""
    from compwright.documents.json_text import to_json
    from compwright.documents.plan import plan_document

    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(to_json(plan_document(finished.plan({}))), encoding="utf-8")


def results(cases: Iterator[Case]) -> Iterator[dict[str, Any]]:
    """Yield what became of each case; a job that is refused writes nothing."""
    for case in cases:
        with tempfile.TemporaryDirectory() as name:
            try:
                found = tried(case, Path(name))
            except CompwrightError as error:
                doubts = [f"exit {error.exit_code}"]
                found = entry(case, doubts, written=False) | {"why": str(error)}
        if found is not None:
            yield found


def harm(one: dict[str, Any]) -> bool:
    """Whether a table without a doubt makes the axis worse."""
    worse = one["written"] and one["A again"] > 1.1 * one["loaded A"] + 0.5
    return worse and not one["doubts"]


def main() -> None:
    """Try, then print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=60)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kind", action="append", choices=[*STALE, *HONEST])
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    kinds = options.kind or list(STALE)
    numbers = range(options.first, options.first + options.count)
    found: list[dict[str, Any]] = []
    for one in results(case_of(number, kinds) for number in numbers):
        found.append(one)
        if harm(one) or (one["doubts"] and "honest" in one["group"]):
            print(json.dumps(one), flush=True)
        if options.out:
            with options.out.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(one) + "\n")
    for group in sorted({one["group"] for one in found}):
        those = [one for one in found if one["group"] == group]
        doubts = Counter(code for one in those for code in set(one["doubts"]))
        print(
            f"{group}: {len(those)}, doubted {sum(bool(one['doubts']) for one in those)}"
            f" {dict(doubts)}, tables {sum(one['written'] for one in those)},"
            f" harm {sum(map(harm, those))}"
        )


if __name__ == "__main__":
    main()
