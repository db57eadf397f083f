"""How far a long command is: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

#: Seconds that pass before a bar is drawn, and between two drawings.
_PATIENCE: Final = 0.5
_BETWEEN: Final = 0.1


@contextmanager
def progress(*, shown: bool) -> Iterator[Callable[[str, int, int], None]]:
    """Provide what is told of which things (a word) how many of how many are done, and draws a bar
    on standard error until the work is done: where that is a terminal, ``shown``, and not done at
    once.
    """
    if not (shown and sys.stderr.isatty()):
        yield lambda what, done, count: None  # noqa: ARG005
        return
    bar = _Bar()
    try:
        yield bar.tell
    finally:
        bar.stop()


class _Bar:
    """A bar for one thing after the other; drawn when it is told, not by a thread of its own."""

    def __init__(self) -> None:
        self._begun = time.monotonic()
        self._drawn = self._begun + _PATIENCE - _BETWEEN
        self._progress: Progress | None = None
        self._tasks: dict[str, TaskID] = {}

    def tell(self, what: str, done: int, count: int) -> None:
        if time.monotonic() - self._drawn < _BETWEEN:
            return
        if self._progress is None:
            self._progress = _progress()
            self._progress.start()
        if what not in self._tasks:
            self._tasks[what] = self._progress.add_task(what, total=count)
        self._progress.update(self._tasks[what], completed=done)
        self._progress.refresh()
        self._drawn = time.monotonic()

    def stop(self) -> None:
        if self._progress is not None:
            self._progress.stop()


def _progress() -> Progress:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,  # the answer stands where it stood
        auto_refresh=False,
    )
