"""Large inputs: seconds and largest memory of whole commands, by form of the input and its size,
and how both grow (ten times the rows: about ten times the seconds). Prints figures, judges nothing.

``bench_sizes.py [ROWS]... [--only WORD]``: 100 000 and 1 000 000 rows without arguments.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import large_files
from measure import COMPWRIGHT, environment, two_processors

_LONGEST = 240  # s; what takes longer is ended and told so


@dataclass(frozen=True)
class Figures:
    """What one process took: wall and processor seconds, largest memory in MB (both 0 where the
    system does not tell), and its exit code (None: ended by us).
    """

    wall: float
    seconds: float
    megabytes: float
    code: int | None
    said: str


def measured(command: Sequence[str]) -> Figures:
    """Run a command to its end, or for as long as we wait."""
    start = time.perf_counter()
    with tempfile.TemporaryFile() as told:
        process = subprocess.Popen(
            command, env=environment(), stdout=subprocess.DEVNULL, stderr=told
        )
        seconds, megabytes, code = _waited(process)
        wall = time.perf_counter() - start
        told.seek(0)
        lines = told.read(4000).decode("utf-8", "replace").splitlines() or [""]
    return Figures(wall, seconds, megabytes, code, lines[0][:90])


def _waited(process: subprocess.Popen[bytes]) -> tuple[float, float, int | None]:
    """Return processor seconds and largest memory of a process, and its exit code."""
    if not hasattr(os, "wait4"):
        return 0.0, 0.0, process.wait(_LONGEST)
    end = time.monotonic() + _LONGEST
    while time.monotonic() < end:
        number, status, used = os.wait4(process.pid, os.WNOHANG)
        if number:
            break
        time.sleep(0.02)
    else:
        process.kill()
        _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    ended = None if process.returncode < 0 else process.returncode
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, ended


@dataclass(frozen=True)
class Case:
    """A command on an input that ``make`` writes into a folder with so many rows."""

    name: str
    make: Callable[[Path, int], list[str]]


CASES = tuple(Case(name, make) for name, make in large_files.COMMANDS.items())


def main() -> None:
    """Print a row per command and size."""
    parser = argparse.ArgumentParser()
    parser.add_argument("rows", nargs="*", type=int)
    parser.add_argument("--only", default="")
    wanted = parser.parse_args()
    sizes = wanted.rows or [100_000, 1_000_000]
    print(f"whole processes on {two_processors()}")
    print(f"{'command':34} {'rows':>9} {'MB in':>7} {'wall':>6} {'cpu s':>6} {'MB':>5} {'exit':>5}")
    for case in CASES:
        if wanted.only not in case.name:
            continue
        before = None
        for rows in sizes:
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                words = case.make(folder, rows)
                size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
                found = measured([*COMPWRIGHT, *words])
            growth = "" if before is None else f"x{found.seconds / (before.seconds or 1.0):.1f}"
            code = "ended" if found.code is None else str(found.code)
            print(
                f"{case.name:34} {rows:9} {size / 1e6:7.1f} {found.wall:6.1f}"
                f" {found.seconds:6.1f} {found.megabytes:5.0f} {code:>5}  {growth} {found.said}",
                flush=True,
            )
            before = found


if __name__ == "__main__":
    main()
