"""A process that dies at one of its calls to the disk: from then on nothing reaches the disk, no
matter what the code does to undo its work. Or one whose call is refused.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from compwright.foundations.command_inputs import start_command

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
    """Let what is done inside be done by ``process``, a command of its own."""
    start_command()
    with pytest.MonkeyPatch.context() as patch:
        for name in CALLS:
            patch.setattr(os, name, process.standing_for(name))
        try:
            yield
        except Killed:
            assert process.dead
    start_command()
