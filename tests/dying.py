"""A process that dies at one of its calls to the disk: from then on nothing reaches the disk, no
matter what the code does to undo its work. Or one whose call is refused. And a disk whose power
fails: what was not synced may have happened or not, in any order.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any

import pytest

#: What changes a disk, or has it lasting.
CALLS = (
    *("open", "write", "fsync", "replace", "rename", "link", "symlink", "truncate"),
    *("unlink", "remove", "mkdir", "rmdir", "chmod", "utime"),
)


class Killed(BaseException):
    """No undoing helps: every later call to the disk is as dead."""


class Process:
    """Counts its calls to the disk and dies at call ``at`` (from 1; 0: never), before it is made or,
    for what is written, with half of it done. With ``refused`` that call fails so instead, and the
    process goes on.
    """

    def __init__(self, at: int = 0, *, refused: BaseException | None = None) -> None:
        self.at = at
        self.refused = refused
        self.made: list[str] = []
        self.dead = False

    def standing_for(self, name: str) -> Callable[..., Any]:
        real = getattr(os, name)

        def call(*arguments: Any, **words: Any) -> Any:
            if name == "open" and not arguments[1] & (os.O_CREAT | os.O_WRONLY | os.O_RDWR):
                return real(*arguments, **words)
            if self.dead:
                raise Killed
            self.made.append(name)
            if len(self.made) == self.at:
                if self.refused is not None:
                    raise self.refused
                self.dead = True
                if name == "write":
                    real(arguments[0], bytes(arguments[1])[: len(arguments[1]) // 2])
                raise Killed
            return real(*arguments, **words)

        return call


@contextmanager
def running(process: Process) -> Iterator[None]:
    """Let what is done inside be done by ``process``."""
    with pytest.MonkeyPatch.context() as patch:
        for name in CALLS:
            patch.setattr(os, name, process.standing_for(name))
        try:
            yield
        except Killed:
            assert process.dead


@dataclass(slots=True)
class Step:
    """A name that was made, moved or removed, or (``sync``) a file or folder that was synced."""

    kind: str
    path: Path
    target: Path | None = None
    content: bytearray = field(default_factory=bytearray)

    def folders(self) -> set[Path]:
        """Return the folders whose names it changes."""
        return {path.parent for path in (self.path, self.target) if path is not None}


class Disk:
    """What a process does to a disk, step by step."""

    def __init__(self, top: Path) -> None:
        self.top = top
        self.steps: list[Step] = []
        self._open: dict[int, Step] = {}
        self._real = {name: getattr(os, name) for name in ("open", "write", "replace", "unlink")}

    def _done(self, kind: str, path: Any, target: Any = None) -> Step:
        def below(name: Any) -> Path:
            return Path(name).resolve().relative_to(self.top.resolve())

        step = Step(kind, below(path), None if target is None else below(target))
        self.steps.append(step)
        return step

    @contextmanager
    def watched(self) -> Iterator[None]:
        """Note what is done inside."""
        make, drop = os.mkdir, os.rmdir

        def opened(path: Any, flags: int, mode: int = 0o777) -> int:
            handle: int = self._real["open"](path, flags, mode)
            created = flags & os.O_CREAT
            step = self._done("create", path) if created else Step("sync", Path(path))
            self._open[handle] = step
            return handle

        def written(handle: int, content: bytes) -> int:
            self._open[handle].content += content
            return int(self._real["write"](handle, content))

        def synced(handle: int) -> None:
            step = self._open[handle]
            path = step.path if step.kind == "sync" else self.top / step.path
            self._done("sync", path)

        def noting(kind: str, real: Callable[..., Any]) -> Callable[..., Any]:
            def call(*arguments: Any, **words: Any) -> Any:
                result = real(*arguments, **words)
                self._done(kind, *(arguments if kind == "replace" else arguments[:1]))
                return result

            return call

        with pytest.MonkeyPatch.context() as patch:
            for name, double in (("open", opened), ("write", written), ("fsync", synced)):
                patch.setattr(os, name, double)
            for name in ("replace", "unlink"):
                patch.setattr(os, name, noting(name, self._real[name]))
            patch.setattr(os, "mkdir", noting("mkdir", make))
            patch.setattr(os, "rmdir", noting("rmdir", drop))
            yield

    def fail(self, before: Path, at: int, chance: Random) -> None:
        """Make of ``before``, a copy of the disk as it was, what is left when the power fails after
        ``at`` steps.
        """
        for number, step in enumerate(self.steps[:at]):
            later = {other.path for other in self.steps[number:at] if other.kind == "sync"}
            if step.kind != "sync" and (step.folders() <= later or chance.random() < 0.5):
                whole = len(step.content) if step.path in later else chance.randint(0, 2)
                with suppress(OSError):  # built on a step that did not happen
                    _again(before, step, bytes(step.content[:whole]))


def _again(top: Path, step: Step, content: bytes) -> None:
    path = top / step.path
    if step.kind == "create":
        path.write_bytes(content)
    elif step.kind == "replace" and step.target is not None:
        path.replace(top / step.target)
    elif step.kind == "unlink":
        path.unlink()
    elif step.kind == "mkdir":
        path.mkdir()
    else:
        path.rmdir()
