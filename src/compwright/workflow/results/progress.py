"""Show the progress of a long command: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:  # loads rich: only where a bar is drawn
    from compwright.reporting.progress import ProgressBar

#: Seconds that pass before a bar is drawn, and between two drawings.
_PATIENCE: Final = 0.5
_BETWEEN: Final = 0.1


@contextmanager
def progress(*, shown: bool) -> Iterator[Callable[[str, int, int], None]]:
    """Provide a function that reports progress, as a bar if ``shown`` is true, else not at all. Its
    arguments are the kind of work (a word), the number done, and the total number.

    The bar appears on standard error if the work takes longer than a moment, and is removed when
    the work is done.
    """
    if not shown:
        yield lambda what, done, count: None  # noqa: ARG005
        return
    watcher = _Watcher()
    try:
        yield watcher.tell
    finally:
        watcher.stop()


class _Watcher:
    def __init__(self) -> None:
        self._due = time.monotonic() + _PATIENCE
        self._bar: ProgressBar | None = None

    def tell(self, what: str, done: int, count: int) -> None:
        if time.monotonic() < self._due:
            return
        if self._bar is None:
            from compwright.reporting.progress import ProgressBar

            self._bar = ProgressBar()
        self._bar.tell(what, done, count)
        self._due = time.monotonic() + _BETWEEN

    def stop(self) -> None:
        if self._bar is not None:
            self._bar.stop()
