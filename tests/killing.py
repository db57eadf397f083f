"""A process that the kernel kills at a chosen system call: SIGKILL on its entry, by ``strace``."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

#: What changes a disk, has it lasting, or locks; by the names of several processors.
SYSTEM_CALLS = (
    *("rename", "renameat", "renameat2", "link", "linkat", "symlink", "symlinkat"),
    *("write", "pwrite64", "writev", "fsync", "fdatasync", "ftruncate", "truncate"),
    *("unlink", "unlinkat", "mkdir", "mkdirat", "rmdir", "chmod", "fchmod", "fchmodat", "flock"),
)
_LINE = re.compile(r"^(\d+) +(\w+)\(")


def _works() -> bool:
    """Whether there is an strace that may trace: in some containers it may not."""
    if shutil.which("strace") is None:
        return False
    tried = subprocess.run(
        ["strace", "-o", os.devnull, "true"], capture_output=True, check=False, timeout=60
    )
    return tried.returncode == 0


WORKS = _works()
needs_strace = pytest.mark.skipif(not WORKS, reason="strace is not there, or may not trace")


@dataclass(frozen=True, slots=True)
class Call:
    """The ``count``-th call of that name (from 1) in a process."""

    name: str
    count: int


def _strace(log: Path, words: Sequence[str], command: Sequence[str]) -> int:
    done = subprocess.run(
        ["strace", "-f", "-o", str(log), *words, *command],
        capture_output=True,
        check=False,
        timeout=120,
    )
    return done.returncode


def calls_of(command: Sequence[str], log: Path) -> list[Call]:
    """Run a command to its end, which must be a good one, and return the system calls that its
    first process makes, in their order.
    """
    known = [name for name in SYSTEM_CALLS if _is_known(name)]
    assert _strace(log, ["-e", f"trace={','.join(known)}"], command) == 0
    counts: Counter[str] = Counter()
    found = []
    lines = [_LINE.match(line) for line in log.read_text(errors="replace").splitlines()]
    made = [(match[1], match[2]) for match in lines if match]
    for process, name in made:
        if name in known and process == made[0][0]:
            counts[name] += 1
            found.append(Call(name, counts[name]))
    return found


def _is_known(name: str) -> bool:
    """Whether there is such a call on this processor."""
    tried = ["strace", "-o", os.devnull, "-e", f"trace={name}", "true"]
    return subprocess.run(tried, capture_output=True, check=False, timeout=60).returncode == 0


def killed_at(call: Call, command: Sequence[str], log: Path) -> None:
    """Run a command and have it killed on entry of a system call, which is not made."""
    inject = f"inject={call.name}:signal=KILL:when={call.count}"
    code = _strace(log, ["-e", f"trace={call.name}", "-e", inject], command)
    assert code in (-9, 137), f"{call} was never made"
