"""`run --force` killed at every system call that changes a disk, has it lasting or locks: what the
next command then finds.

``python benchmarks/kill_run.py [--every N] [--putting-right]`` (POSIX with ``strace``).

A result folder of an earlier job, verified, with a file for ``--json`` beside it and notes of the
user in both, is written anew by `run --force`. Its stage of writing is done again as a process of
its own, with the same files, and killed (SIGKILL on entry of the call, ``strace``) at its first
call, its second, and so on (``--every N``: at each N-th). Then another command reads the folder,
each in turn, and every file is compared by its sha256: all as before the run, or all as after it,
the notes as they were. ``--putting-right``: the command that takes back is killed too, at each of
its calls, and another one reads. Prints counts by
what was found; exit 1 where anything was mixed or lost.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import pickle
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from compwright.cli import run as compwright
from compwright.foundations import storage
from compwright.foundations.session import Session
from killing import WORKS, calls_of, killed_at
from loop import Machine, csv_of

CONTROL = "siemens-840d-sl"
JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: AX1, before: [x.csv]}
  Y: {travel: [0, 800], address: AX2, before: [y.csv]}
"""
JSON = "beside/prediction.json"
NOTES = ("job/notes.txt", "job/card/notes.txt", "job/inputs/notes.txt", "beside/notes.txt")
HIDDEN = ".compwright-unfinished"
#: Who reads next, in the folder above the results.
COMMANDS: dict[str, list[str]] = {
    "decode": ["decode", f"job/tables/{CONTROL}", "--format", CONTROL],
    "verify": ["verify", "job.yaml", "--after", "x-after.csv", "--out", "verified"],
    "history": ["history", "."],
    "evaluate": ["evaluate", "job/inputs"],
    "compare": ["compare", "job", "--loaded", f"job/tables/{CONTROL}"],
    "run": ["run", "job.yaml"],  # without --force: the results are there
    "evaluate beside": ["evaluate", "beside"],
}
WRITING = """
import pickle, sys
from pathlib import Path
from compwright.foundations import storage
from compwright.foundations.session import Session
given = pickle.loads(Path(sys.argv[1]).read_bytes())
known = lambda name, _content: name in given["known"]
storage.write_files(Session(), given["folder"], given["files"], known=known, **given["words"])
"""
READING = "import sys; from compwright.cli import run; run(sys.argv[1:])"


def quietly(words: list[str]) -> tuple[int, str]:
    """Run a command here and return its exit code and what it says of errors."""
    said = StringIO()
    with redirect_stdout(StringIO()), redirect_stderr(said):
        return compwright(words), said.getvalue()


def done(words: list[str]) -> None:
    """Run a command that must do its work."""
    code, said = quietly(words)
    if code not in (0, 1):
        sys.exit(f"{words}: exit {code}: {said}")


@contextmanager
def inside(folder: Path) -> Iterator[None]:
    """Work in a folder."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def digests(top: Path) -> dict[str, str]:
    """Return every file of the results and beside them, by its sha256."""
    return {
        path.relative_to(top).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for place in ("job", "beside")
        for path in sorted((top / place).rglob("*"))
        if path.is_file()
    }


def prepare(top: Path) -> Path:
    """Make the folder as it is before the run in ``top``, and return the file with what the run
    writes.
    """
    machine = Machine()
    targets = machine.targets()
    for name, seed in (("x", 1), ("y", 2), ("x-after", 3), ("x-new", 4), ("y-new", 5)):
        (top / f"{name}.csv").write_text(
            csv_of(targets, machine.measure(targets, seed), name[0].upper())
        )
    (top / "job.yaml").write_text(JOB)
    with inside(top):
        (top / "beside").mkdir()
        done(["run", "job.yaml", "--json", JSON])
        done(["verify", "job.yaml", "--after", "x-after.csv"])
        for name in NOTES:
            (top / name).write_text("mine")
        for axis in "xy":
            (top / f"{axis}-new.csv").replace(top / f"{axis}.csv")
        (top / "job.yaml").write_text(JOB.replace("AX2", "AX3"))
        return captured(top)


def captured(top: Path) -> Path:
    """Return what `run --force` hands to storage, in a file; nothing is written by it."""
    kept: dict[str, Any] = {}

    def keeping(_: Session, folder: Path, files: dict[str, bytes], **words: Any) -> list[Path]:
        known = words.pop("known")
        kept.update(folder=folder, files=dict(files), words=words, known=listed(known, folder))
        return []

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(storage, "write_files", keeping)
        done(["run", "job.yaml", "--force", "--json", JSON])
    (top / "set").write_bytes(pickle.dumps(kept))
    return top / "set"


def listed(known: Callable[[str, bytes], bool], folder: Path) -> set[str]:
    """Return the files of the folder that an earlier run wrote, by what the run says of them."""
    paths = [path for path in folder.rglob("*") if path.is_file()]
    names = {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}
    return {name for name, content in names.items() if known(name, content)}


class Trial:
    """One folder before the run, made again for each kill."""

    def __init__(self, top: Path) -> None:
        self.top, self.before, self.log = top / "hall", top / "before", top / "log"
        self.top.mkdir()
        self.kept = prepare(self.top)
        shutil.copytree(self.top, self.before)
        self.command = [sys.executable, "-c", WRITING, str(self.kept)]
        self.old = digests(self.top)
        with inside(self.top):
            self.calls = calls_of(self.command, self.log)
        self.new = digests(self.top)
        if any(self.old[name] != self.new[name] for name in NOTES):
            sys.exit("the notes of the user were changed")

    def restore(self) -> None:
        """Make the folder as it was before the run."""
        shutil.rmtree(self.top)
        shutil.copytree(self.before, self.top)

    def kill(self, number: int) -> None:
        """Write, and be killed at that call."""
        self.restore()
        with inside(self.top):
            killed_at(self.calls[number], self.command, self.log)

    def seen(self) -> tuple[str, bool]:
        """Return what lies there by its own names, and whether there is a journal."""
        there = digests(self.top)
        named = {name: digest for name, digest in there.items() if HIDDEN not in name}
        begun = f"job/{HIDDEN}/journal.json" in there
        if named == self.old:
            return "as before", begun
        if named == self.new:
            return "as after", begun
        mixed = not (named.items() <= self.old.items() or named.items() <= self.new.items())
        return "MIXED" if mixed else "a part", begun

    def read_by(self, name: str) -> tuple[str, str]:
        """Let a command read, and return what it found and said."""
        with inside(self.top):
            _, said = quietly(COMMANDS[name])
            found, begun = self.seen()
            quietly(COMMANDS["evaluate beside"])  # sweeps there what was only prepared
            quietly(COMMANDS["history"])
        left = list(self.top.rglob(HIDDEN))
        return ("LEFT OVER" if begun or left else found), said


def all_kills(trial: Trial, every: int) -> Counter[str]:
    """Kill at each call, read with each command in turn, and return how often what was found."""
    counts: Counter[str] = Counter()
    names = list(COMMANDS)
    for number in range(0, len(trial.calls), every):
        trial.kill(number)
        raw, begun = trial.seen()
        reader = names[number // every % len(names)]
        found, said = trial.read_by(reader)
        counts[f"left by the kill: {raw}{', with a journal' if begun else ''}"] += 1
        counts[f"found by the next command: {found}"] += 1
        counts[f"read by {reader}"] += 1
        told = "had begun to write here" in said
        if found not in ("as before", "as after") or raw == "MIXED" or told != begun:
            counts["WRONG"] += 1
            print(f"{trial.calls[number]}, read by {reader}: {raw}, then {found}; {said}")
    return counts


def putting_right_killed(trial: Trial, every: int) -> Counter[str]:
    """Kill in the midst of the moves, kill who takes it back at each call, and read."""
    moves = [at for at, call in enumerate(trial.calls) if call.name.startswith("rename")]
    number = moves[-3]
    trial.kill(number)
    middle = trial.top.with_name("middle")
    shutil.copytree(trial.top, middle)
    reading = [sys.executable, "-c", READING, *COMMANDS["decode"]]
    with inside(trial.top):
        calls = calls_of(reading, trial.log)
    counts: Counter[str] = Counter()
    for at in range(0, len(calls), every):
        shutil.rmtree(trial.top)
        shutil.copytree(middle, trial.top)
        with inside(trial.top):
            killed_at(calls[at], reading, trial.log)
        raw, _ = trial.seen()
        found, said = trial.read_by("compare")
        counts[f"found after putting right was killed: {found}"] += 1
        if found != "as before" or raw == "MIXED":
            counts["WRONG"] += 1
            print(f"{calls[at]} of putting right: {raw}, then {found}; {said}")
    return counts


def main() -> int:
    """Do all and print the counts."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--putting-right", action="store_true")
    asked = parser.parse_args()
    if not WORKS:
        print("strace is not there, or may not trace: nothing was tried")
        return 0
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as made:
        trial = Trial(Path(made))
        changed = sum(trial.new.get(name) != digest for name, digest in trial.old.items())
        print(
            f"{len(trial.old)} files before, {len(trial.new)} after, {changed} of the earlier ones"
            f" replaced or removed; {len(trial.calls)} system calls:",
            ", ".join(f"{count} {name}" for name, count in by_name(trial).items()),
        )
        work = putting_right_killed if asked.putting_right else all_kills
        counts = work(trial, asked.every)
    for what, count in sorted(counts.items()):
        print(f"{count:6d} {what}")
    print(f"{time.perf_counter() - start:.0f} s")
    return 1 if counts["WRONG"] else 0


def by_name(trial: Trial) -> Counter[str]:
    """Return how often each call is made."""
    return Counter(call.name for call in trial.calls)


if __name__ == "__main__":
    sys.exit(main())
