"""A folder of positioning files: files per second by the wall clock, start-up included, and the
memory of all processes together; in one process and in two, in turn. Prints, judges nothing.

The files are those of honest axes: error, lost motion, noise and targets of each are its own, every
second one has evenly spaced targets.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import subprocess
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from measure import COMPWRIGHT, environment, spread, two_processors

WANTED = "above 250 files a second on two processors, below 300 MB"


@dataclass(frozen=True)
class Run:
    """``peak``: the largest sum of the resident memory of all processes, MB; ``told``: a
    fingerprint of the answer.
    """

    seconds: float
    peak: float
    told: str


def write_folder(folder: Path, files: int) -> None:
    """Write the tests of ``files`` axes, 11 targets and 5 runs each way, in the long form."""
    rng = np.random.default_rng(1)
    even = np.arange(11) * 80.0
    for number in range(files):
        moved = np.round(even + rng.uniform(-20.0, 20.0, 11), 1)
        targets = moved if number % 2 else even
        error = 8.0 * np.sin(targets / 170.0 + rng.uniform(0.0, 6.0)) + targets * rng.normal() / 160
        rows = [f"# axis: {'XYZ'[number % 3]}", "# machine: VMC 850", "# cycle: standard"]
        rows.append("target_mm,direction,run,deviation_um")
        for run in range(1, 6):
            for direction, lost in (("+", -0.9), ("-", 0.9)):
                read = error + lost + 0.6 * rng.normal(size=11)
                rows += [
                    f"{target:g},{direction},{run},{value:.2f}"
                    for target, value in zip(targets, read, strict=True)
                ]
        (folder / f"t{number:05}.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


def timed(command: Sequence[str], processors: int) -> Run:
    """Run a command on so many processors; its memory is looked at every 20 ms (Linux)."""
    allowed = sorted(os.sched_getaffinity(0))[:processors]
    start = time.perf_counter()
    running = subprocess.Popen(
        command,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        preexec_fn=lambda: os.sched_setaffinity(0, allowed),  # noqa: PLW1509 - no threads here yet
    )
    peak = [0.0]
    over = threading.Event()
    watching = threading.Thread(target=_watch, args=(running.pid, peak, over))
    watching.start()
    told = hashlib.sha256(running.communicate()[0]).hexdigest()
    code = running.returncode
    seconds = time.perf_counter() - start
    over.set()
    watching.join()
    if code:
        raise SystemExit(f"{' '.join(command)}: exit {code}")
    return Run(seconds, peak[0], told)


def _watch(top: int, peak: list[float], over: threading.Event) -> None:
    while not over.wait(0.02):
        peak[0] = max(peak[0], sum(map(_resident, _family(top))))


def _family(top: int) -> list[int]:
    """Return a process and all that it started."""
    found = [top]
    for pid in found:
        try:
            listed = Path(f"/proc/{pid}/task/{pid}/children").read_text("ascii")
        except OSError:
            continue
        found += map(int, listed.split())
    return found


def _resident(pid: int) -> float:
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text("ascii").split()[1])
    except (OSError, IndexError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def main() -> None:
    """Print a row for each answer: files per second on one and on two processors, their ratio, and
    memory; and whether both gave the same bytes.
    """
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--files", type=int, nargs="+", default=[100, 300, 1000])
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    print(f"{two_processors()}; minimum / median / maximum of {given.runs} pairs; wanted {WANTED}")
    for files in given.files:
        with tempfile.TemporaryDirectory() as folder:
            write_folder(Path(folder), files)
            for name, words in (("lines", []), ("--json -", ["--json", "-"])):
                command = [*COMPWRIGHT, "evaluate", folder, *words]
                timed(command, 2)  # modules are compiled
                pairs = [(timed(command, 2), timed(command, 1)) for _ in range(given.runs)]
                two, one = zip(*pairs, strict=True)
                rates = [spread([files / run.seconds for run in some], 0) for some in (two, one)]
                peaks = [max(run.peak for run in some) for some in (two, one)]
                same = len({run.told for run in (*two, *one)}) == 1
                print(
                    f"{files:6} files, {name:9} two: {rates[0]} files/s, one: {rates[1]}; ratio"
                    f" {spread([b.seconds / a.seconds for a, b in pairs])}; memory {peaks[0]:.0f}"
                    f" and {peaks[1]:.0f} MB; {'same' if same else 'OTHER'} bytes",
                    flush=True,
                )


if __name__ == "__main__":
    main()
