"""Whole processes in turn: A B A B ..., wall and processor seconds of each, and the ratio pair by
pair.
"""

from __future__ import annotations

import atexit
import functools
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]
NUMPY = [sys.executable, "-c", "import numpy"]
COMPWRIGHT = [sys.executable, "-m", "compwright"]
_NOT_COMPILED = "PYTHONDONTWRITEBYTECODE"


@dataclass(frozen=True)
class Cost:
    """What one process took, in seconds."""

    wall: float
    cpu: float


def two_processors() -> str:
    """Stay on two processors where the system lets us, as a service laptop would; say what was
    done.
    """
    if not hasattr(os, "sched_setaffinity"):
        return f"{os.cpu_count()} processors"
    chosen = sorted(os.sched_getaffinity(0))[:2]
    os.sched_setaffinity(0, chosen)
    return f"{len(chosen)} processors"


@functools.cache
def _compiled() -> str:
    """Return a folder, new for this benchmark, for compiled modules: an installed package has its
    own.
    """
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def environment() -> dict[str, str]:
    """Return the variables of a process that runs this tree, its modules compiled once."""
    kept = {name: value for name, value in os.environ.items() if name != _NOT_COMPILED}
    return {**kept, "PYTHONPATH": str(PROJECT / "src"), "PYTHONPYCACHEPREFIX": _compiled()}


def once(command: Sequence[str]) -> Cost:
    """Run a command to its end; its output is thrown away. A failure ends the benchmark."""
    before = os.times()
    start = time.perf_counter()
    subprocess.run(
        command, env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=True
    )
    wall = time.perf_counter() - start
    after = os.times()
    cpu = (
        after.children_user - before.children_user + after.children_system - before.children_system
    )
    return Cost(wall=wall, cpu=cpu)


def in_turn(one: Sequence[str], other: Sequence[str], runs: int) -> list[tuple[Cost, Cost]]:
    """Run both in turn, after one uncounted run of each."""
    once(one)
    once(other)
    return [(once(one), once(other)) for _ in range(runs)]


def spread(values: Sequence[float], digits: int = 2) -> str:
    """Return minimum, median and maximum as text."""
    return (
        f"{min(values):.{digits}f} / {statistics.median(values):.{digits}f} /"
        f" {max(values):.{digits}f}"
    )
