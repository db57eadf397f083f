"""After loading: ``compare`` on what was read back, ``verify`` on a test of the loaded control, and
``new`` from the files. Faults go into the outcome of the job.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import yaml

from backup_files_fanuc import PITCH
from backup_jobs_fanuc import AxisJob, csv
from judge_fanuc import Outcome, Played, acting, control_of, quietly, reloaded
from virtual_fanuc import Floats, VirtualFanuc

_POINT = re.compile(rb"(N1\d{4}(?:Q0)?P)(-?\d+)")
_RECORD = re.compile(r"^(?P<target>[-0-9.]+),\+,1,", re.MULTILINE)


def judge_loaded(outcome: Outcome, played: Played) -> None:
    """compare and verify; only where all files of the control were given and all axes got a
    table.
    """
    job = played.job
    complete = job.files is not None and job.really is None and not played.unknown
    if not complete or played.code != 0 or len(outcome.written) != len(job.axes):
        return
    files = _read_back(played)
    outcome.faults.extend(_compare(played, files))
    outcome.faults.extend(_verify(outcome, played, files))


def _read_back(played: Played) -> list[Path]:
    """What the loaded control punches: every file that was given, patched where it was patched; and
    what came beside it.
    """
    given = [
        patched if (patched := played.tables / name).is_file() else played.out.parent / name
        for name in played.job.files or {}
    ]
    fresh = [path for path in sorted(played.tables.iterdir()) if path not in given]
    return given + fresh


def _compare(played: Played, files: list[Path]) -> Iterator[str]:
    plan = str(played.out / "plan.json")
    old = [played.out.parent / name for name in played.job.files or {}]
    for what, loaded, expected in (("was planned", files, 0), ("was before", old, 1)):
        words = [word for path in loaded for word in ("--loaded", str(path))]
        code, said, shown = quietly(["compare", plan, *words])
        if code != expected:
            yield f"COMPARE with what {what}: exit {code}\n{said}{shown}"[:900]
    pitch = next((path for path in files if path.name == PITCH), None)
    if pitch is not None:
        spoilt = played.out.parent / "spoilt" / PITCH
        spoilt.parent.mkdir(exist_ok=True)
        foreign = _foreign_point(played)
        if foreign is None:
            return
        pattern = re.compile(rb"(N%d(?:Q0)?P)(-?\d+)" % (10000 + foreign))
        spoilt.write_bytes(
            pattern.sub(lambda found: found[1] + b"%d" % (int(found[2]) + 1), pitch.read_bytes())
        )
        words = [w for p in files for w in ("--loaded", str(spoilt if p == pitch else p))]
        code, said, shown = quietly(["compare", plan, *words])
        if code != 1:
            yield f"COMPARE with a neighbour's point {foreign} changed: exit {code}\n{said}{shown}"


def _foreign_point(played: Played) -> int | None:
    """A point of an axis that is not in the job."""
    control = played.before
    mine = {axis.address for axis in played.job.axes}
    for axis in control.axes():
        grid = control.grid(axis)
        if axis not in mine and grid.acts and not grid.turn and grid.last <= 1023:
            return grid.last
    return None


def _after(axis: AxisJob, control: VirtualFanuc, path: Path, rng: np.random.Generator) -> str:
    """A test of the loaded control at the very targets of the test before, as a file."""
    text = (path / f"{axis.name}.csv").read_text()
    x: Floats = np.unique([float(found["target"]) for found in _RECORD.finditer(text)])
    name = path / f"{axis.name}_after.csv"
    name.write_text(
        csv(axis.name, axis.rotary, x, axis.physics.read(rng, x, acting(control, axis)))
    )
    return str(name)


def _verify(outcome: Outcome, played: Played, files: list[Path]) -> Iterator[str]:
    job = played.job
    after = control_of(job, reloaded(played.really, played.tables))
    rng = np.random.default_rng([job.seed, 9])
    for what, control in (("loaded", after), ("nothing loaded", played.before)):
        words = ["verify", str(played.out.parent / "job.yaml"), "--plan", str(played.out)]
        for axis in job.axes:
            words += [
                "--after",
                f"{axis.name.lower()}_before=" + _after(axis, control, played.out.parent, rng),
            ]
        if control is after:
            words += [word for path in files for word in ("--loaded", str(path))]
        document = played.out.parent / f"verify_{what[0]}" / "verification.json"
        words += ["--out", str(document.parent)]
        code, said, _ = quietly(words)
        if not document.is_file():
            yield f"VERIFY {what}: exit {code}, no document\n{said[:600]}"
            continue
        found = json.loads(document.read_text())
        verdict = found["verdict"]
        loading = [entry["loading"]["verdict"] for entry in found["axes"].values()]
        outcome.verdicts.append(f"{what}: {verdict}")
        expected = {"good": 0, "bad": 1, "undecided": 1}[verdict]
        wrong = (verdict == "bad" and control is after) or (
            verdict == "good" and control is not after
        )
        if wrong or code != expected:
            yield f"VERIFY {what}: exit {code}, {verdict}, {loading}\n{said[:900]}"


def judge_new(outcome: Outcome, played: Played) -> None:
    """``new`` makes a job of the files that says what they say, and ``run`` asks for nothing
    more.
    """
    job = played.job
    folder = played.out.parent
    words = ["new", "--format", job.format, "--out", str(folder / "new.yaml")]
    for name in job.files or {}:
        words += ["--from", str(folder / name)]
    code, said, _ = quietly(words)
    if code != 0:
        outcome.faults.append(f"NEW: exit {code}\n{said[:600]}")
        return
    text = yaml.safe_load((folder / "new.yaml").read_text())
    axes = {}
    for axis in job.axes:
        found = text["axes"].get(axis.name)
        if found is None or str(found.get("address")) != str(axis.address):
            outcome.faults.append(f"NEW: no axis {axis.name} at {axis.address}: {found}")
            return
        if found.get("kind", "linear") != ("rotary" if axis.rotary else "linear"):
            outcome.faults.append(f"NEW: kind of {axis.name} is {found.get('kind')}")
        test = {"files": [f"{axis.name}.csv"], "name": f"{axis.name.lower()}_before"}
        if axis.rapid:
            test["motion"] = "rapid"
        home = "-" if axis.home < 0 else "+"
        axes[axis.name] = found | {
            "before": [test],
            "travel": list(axis.travel),
            "reference_return": home,
        }
        axes[axis.name] = {k: v for k, v in axes[axis.name].items() if v is not None}
    text["axes"] = axes
    (folder / "new_job.yaml").write_text(yaml.safe_dump(text))
    out = folder / "new_out"
    code, said, shown = quietly(["run", str(folder / "new_job.yaml"), "--out", str(out)])
    again = replace(played, out=out, code=code, said=said, shown=shown)
    tables = again.tables
    if code != 0 or not tables.is_dir():
        outcome.faults.append(f"NEW: run of its job ends with {code}\n{said[:900]}")
