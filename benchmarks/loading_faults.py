"""Does ``verify`` find what was done wrong in loading a table? Virtual axes, injected faults.

    python benchmarks/loading_faults.py [--count N] [--seed S] [--kind K]... [--control C]...
        [--fault F]... [--old O]... [--results FILE] [--keep DIR] [--list]

A job of two or three axes with tests and ``run``; then ``--tests`` times a test after loading, each
axis with a fault of its own: the truth, plus what a control with that fault adds (computed from
what ``decode`` says of the written files, or decoded from files that were changed), plus fresh
noise; and ``verify``. Compared with the name of what was injected:

right       the verdict, or one of its ``equivalent``
wrong       another name; ``alike`` where that name's own after-test is within one standard error
undecided   no name

A third of the jobs have tables of an earlier error in the control (``--old`` chooses): ``active``
in the test before; ``idle`` there, and the job states it (`measured_in`, or `active: no` where
the files do not show it); or ``believed``: idle, but the job states
that they were active, which is the fault ``state``.

by fault, by kind of axis and control, and by how far the nearest other name is away. ``apart``
counts the list of names as the faults' list has them; ``apart (variants)`` also everything else
that may stand under another name (backlash with or without, old table or nothing, any cut).

``--results`` keeps every case as JSON lines and does not repeat the jobs that stand there.
``--keep`` leaves the folders. Prints and judges nothing.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from fault_machines import FLEET, Axis, axis_of, earlier, job_axis
from fault_summary import show
from injected_faults import NAMES, OLD, Fault, Plan, apart, entered, faults_of
from loaded_controls import CONTROLS, Control, Loaded, said, without_reports
from machines import Floats, Machine, name_seed
from numpy.random import Generator
from table_quality import csv_of, measured

Record = dict[str, Any]

#: Controls that the fleet is dealt to, the usual ones more often.
DEALT = (
    *("siemens-840d-sl", "siemens-840d-sl", "fanuc-30i", "fanuc-30i", "linuxcnc", "linuxcnc"),
    *("heidenhain-itnc530", "heidenhain-nck", "isg-kernel", "pmac"),
)

#: Names of one and the same test: each is right, and not far from the other.
SAME_TEST = ("state", "on_top")


@dataclass(frozen=True)
class Job:
    """A job that was run: its folder, its axes, what was written for each that has a table."""

    number: int
    folder: Path
    axes: dict[str, Axis]
    plans: dict[str, Plan]


# ---- making a job


def job_of(number: int, seed: int, words: argparse.Namespace, folder: Path) -> Job:
    """Make a job's files and run it; with an old table, run that one first."""
    rng = name_seed("loading faults", seed, number)
    kinds = [kind for kind in FLEET if not words.kind or any(part in kind for part in words.kind)]
    control = CONTROLS[str(rng.choice(words.control or DEALT))]
    axes: dict[str, Axis] = {}
    for name in "XYZ"[: int(rng.integers(2, 4))]:
        kind = str(rng.choice(kinds))
        if not control.endless and kind == "endless rotary axis":
            kind = "rotary, limited"
        axes[name] = axis_of(kind, 1000 * seed + number, name)
    kept = words.old or (["none"] if rng.uniform() < 0.65 else OLD)
    how = str(rng.choice(kept))
    old = None if how == "none" else _old_tables(axes, control, rng, folder)
    tests = {}
    for name, axis in axes.items():
        active = old.at(name, axis.before.targets) if old and how == "active" else None
        tests[name] = a_test(axis.before, rng, active)
    tables = _run(axes, control, tests, folder / "job", _states(old, how, control))
    new = _loaded(axes, control, folder / "job")
    size = {name: 3.6 if axes[name].before.rotary else 1.0 for name in tables}  # 0.001 deg, mm
    plans = {}
    for name in tables:
        others = {other: size[name] / size[other] for other in tables if other != name}
        plans[name] = Plan(name, axes[name].before, new, old, others, how)
    return Job(number, folder, axes, plans)


def _old_tables(
    axes: Mapping[str, Axis], control: Control, rng: Generator, folder: Path
) -> Loaded | None:
    """Tables of an earlier error; None unless every axis has one."""
    tests = {name: a_test(earlier(axis, rng), rng) for name, axis in axes.items()}
    tables = _run(axes, control, tests, folder / "earlier", {"as_found": "none"})
    if len(tables) < len(axes):
        return None
    return _loaded(axes, control, folder / "earlier")


def _states(old: Loaded | None, how: str, control: Control) -> dict[str, Any]:
    """Return what the job states of the control; a state ``idle``: in which its tests were taken.

    Files that show a table as switched on contradict `active: no`; there a state of its own says
    that nothing was active.
    """
    if old is None:
        return {"as_found": "none"}
    files = [str(old.folder)]
    if how != "idle":
        return {"as_found": {"files": files, "active": "yes"}}
    if control.format == "isg-kernel":
        return {"as_found": {"files": files, "active": "no"}}
    return {"as_found": files, "idle": "none"}


def _loaded(axes: Mapping[str, Axis], control: Control, folder: Path) -> Loaded:
    rotary = frozenset(name for name, axis in axes.items() if axis.before.rotary)
    return Loaded(control, folder / "out" / "tables" / control.format, rotary)


def a_test(
    machine: Machine, rng: Generator, acting: Floats | None = None
) -> tuple[Machine, Floats]:
    """Readings at the machine's targets, with what acts added."""
    return machine, measured(machine, rng, machine.temperature(rng), acting)


def _run(
    axes: Mapping[str, Axis],
    control: Control,
    tests: Mapping[str, tuple[Machine, Floats]],
    folder: Path,
    states: dict[str, Any],
) -> list[str]:
    """Write the job, run it; return the axes that have a table."""
    folder.mkdir(parents=True)
    entries = {}
    for place, (name, axis) in enumerate(axes.items()):
        machine, readings = tests[name]
        text = csv_of(machine, machine.targets, readings, name)
        (folder / f"{name}.csv").write_text(text, encoding="utf-8")
        empty = states["as_found"] == "none"
        options = {"first_point": 300 * place} if control.increments and empty else {}
        entries[name] = job_axis(axis, control.addresses[name], options)
        if not empty:
            del entries[name]["table"]["spacing"]  # the grid that is there
        if "idle" in states:
            entries[name]["before"] = [{"files": [f"{name}.csv"], "measured_in": "idle"}]
    job = {
        "compwright": 1,
        "controller": {"format": control.format, "options": dict(control.options)},
        "states": states,
        "axes": entries,
    }
    (folder / "job.yaml").write_text(json.dumps(job, indent=1), encoding="utf-8")
    code, _, why = said("run", str(folder / "job.yaml"), "--out", str(folder / "out"))
    if code not in {0, 1}:
        raise RuntimeError(f"run ends with {code}: {why.strip()[-400:]}")
    document = json.loads((folder / "out" / "prediction.json").read_text(encoding="utf-8"))
    return [name for name in axes if document["axes"][name]["table"]]


# ---- the tests after loading


def cases_of(job: Job, seed: int, words: argparse.Namespace) -> Iterator[Record]:
    """Inject, measure, verify, several times; yield a case for each axis with a table."""
    rng = name_seed("loading faults, after", seed, job.number)
    lists = {name: _list_of(plan, job.axes[name], rng) for name, plan in job.plans.items()}
    wanted = words.fault or NAMES
    for test in range(words.tests):
        folder = job.folder / f"after-{test}"
        folder.mkdir()
        chosen = {
            name: _choose(
                job.plans[name],
                job.axes[name],
                faults,
                ("state", "not_active") if job.plans[name].how == "believed" else wanted,
                rng,
                folder,
            )
            for name, faults in lists.items()
        }
        files = []
        for name, fault in chosen.items():
            after = job.axes[name].after
            machine, readings = a_test(after, rng, fault.correction)
            path = folder / f"{name}_after.csv"
            path.write_text(csv_of(machine, machine.targets, readings, name), encoding="utf-8")
            files += ["--after", f"{name}={path}"]
        document, why = _verified(job, files, folder)
        for name, fault in chosen.items():
            yield {
                "job": job.number,
                "test": test,
                "axis": name,
                "control": job.plans[name].control.format,
                "kind": job.axes[name].kind,
                "old": job.plans[name].how,
                **_scored(fault, lists[name], job.axes[name], document, name, why),
            }


def _list_of(plan: Plan, axis: Axis, rng: Generator) -> list[Fault]:
    slope = float(rng.choice([-1, 1]) * rng.uniform(8, 40))
    slopes = () if axis.before.rotary else (slope,)
    return list(faults_of(plan, axis.after.targets, slopes))


def _choose(
    plan: Plan,
    axis: Axis,
    faults: Sequence[Fault],
    wanted: Sequence[str],
    rng: Generator,
    folder: Path,
) -> Fault:
    """Draw a name of those that the axis can have, then one of its variants or changed files."""
    names = [name for name in wanted if any(fault.name == name for fault in faults)] or ["loaded"]
    name = str(rng.choice(names))
    if rng.uniform() < 0.4:
        fault = entered(plan, name, axis.after.targets, rng, folder / f"files-{plan.name}")
        if fault is not None:
            return fault
    some = [fault for fault in faults if fault.name == name]
    return some[int(rng.integers(len(some)))]


def _verified(job: Job, files: Sequence[str], folder: Path) -> tuple[Mapping[str, Any], str]:
    inside = job.folder / "job"
    code, answer, why = said(
        *("verify", str(inside / "job.yaml"), *files, "--plan", str(inside / "out")),
        *("--out", str(folder / "out"), "--json", "-"),
    )
    if code not in {0, 1}:
        return {}, f"verify ends with {code}: {why.strip()[-300:]}"
    document: Mapping[str, Any] = json.loads(answer)
    return document, ""


def _scored(
    fault: Fault,
    faults: Sequence[Fault],
    axis: Axis,
    document: Mapping[str, Any],
    name: str,
    why: str,
) -> Record:
    """Hold the answer against what was injected."""
    after = axis.after
    rows = [0 if sign > 0 else 1 for sign in after.signs]
    error = axis.spread * float(np.sqrt(2 / after.runs))
    far = {
        other.name + "|" + other.words: apart(fault.correction, other.correction, error, rows)
        for other in faults
    }
    same = SAME_TEST if fault.name in SAME_TEST else (fault.name,)
    others = [other for other in faults if other.name not in same]
    record: Record = {
        "fault": fault.name,
        "words": fault.words,
        "value": fault.value,
        "apart": min(far[o.name + "|" + o.words] for o in others if o.plain),
        "variants": min(far[o.name + "|" + o.words] for o in others),
        "nearest": min((o for o in others), key=lambda o: far[o.name + "|" + o.words]).name,
    }
    loading = document.get("axes", {}).get(name, {}).get("loading")
    if loading is None:
        return {**record, "outcome": "failed", "message": why or "no answer for this axis"}
    verdict = loading["verdict"]
    named = [value for key, value in far.items() if key.startswith(verdict + "|")]
    return {
        **record,
        "verdict": verdict,
        "overall": document["verdict"],
        "equivalent": loading["equivalent"],
        "candidates": loading.get("candidates", []),
        "factor": loading.get("factor"),
        "shift_nodes": loading.get("shift_nodes"),
        "of": loading.get("of"),
        "message": loading["message"],
        "outcome": _outcome(fault, loading, min(named, default=np.inf)),
        "value_right": _value_right(fault, loading),
    }


def _outcome(fault: Fault, loading: Mapping[str, Any], distance: float) -> str:
    if fault.name == loading["verdict"] or fault.name in loading["equivalent"]:
        return "right"
    if loading["verdict"] == "undecided":
        return "undecided"
    return "alike" if distance <= 1.0 else "wrong"


def _value_right(fault: Fault, loading: Mapping[str, Any]) -> bool:
    """Whether factor (within a sixth), nodes or axis are those that were injected."""
    if fault.name != loading["verdict"]:
        return True
    if fault.name == "scaled":
        return bool(abs(loading["factor"] / float(fault.value) - 1) < 1 / 6)
    if fault.name == "shifted":
        return bool(loading["shift_nodes"] == fault.value)
    return fault.name != "wrong_axis" or loading.get("of") == fault.value


# ---- the work


def main() -> None:
    """Work, then print."""
    reader = argparse.ArgumentParser(description="Loading faults: named, open, or wrongly named.")
    reader.add_argument("--count", type=int, default=20, help="jobs of two or three axes")
    reader.add_argument("--tests", type=int, default=6, help="tests after loading, each job")
    reader.add_argument("--seed", type=int, default=1, help="of the fleet")
    reader.add_argument("--kind", action="append", help="only kinds with this in their names")
    reader.add_argument("--control", action="append", choices=sorted(CONTROLS))
    reader.add_argument("--fault", action="append", choices=NAMES)
    reader.add_argument("--old", action="append", choices=("none", *OLD))
    reader.add_argument("--job", type=int, action="append", help="only these jobs")
    reader.add_argument("--results", type=Path, help="JSON lines, read and added to")
    reader.add_argument("--keep", type=Path, help="leave the folders of the jobs in this one")
    reader.add_argument("--seconds", type=float, default=float("inf"), help="stop after these")
    reader.add_argument("--list", action="store_true", help="every case that is not right")
    words = reader.parse_args()
    records: list[Record] = []
    if words.results and words.results.exists():
        lines = words.results.read_text(encoding="utf-8").splitlines()
        records = [json.loads(line) for line in lines]
    done = {one["job"] for one in records}
    end = time.monotonic() + words.seconds
    without_reports()
    for number in words.job or range(words.count):
        if number in done or time.monotonic() > end:
            continue
        fresh = list(_worked(number, words))
        records += fresh
        if words.results:
            with words.results.open("a", encoding="utf-8") as file:
                file.writelines(json.dumps(one, default=float) + "\n" for one in fresh)
    show(records, every=words.list)


def _worked(number: int, words: argparse.Namespace) -> Iterator[Record]:
    """Yield the cases of a job; a job that cannot be run is one case."""
    place = nullcontext(words.keep / f"{number}") if words.keep else tempfile.TemporaryDirectory()
    with place as folder:
        try:
            job = job_of(number, words.seed, words, Path(folder))
        except (RuntimeError, ValueError) as error:
            yield {"job": number, "outcome": "no job", "message": str(error)}
            return
        if not job.plans:
            yield {"job": number, "outcome": "no table", "message": ""}
            return
        yield from cases_of(job, words.seed, words)


if __name__ == "__main__":
    main()
