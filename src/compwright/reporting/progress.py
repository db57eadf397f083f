"""A bar that shows how far a command is, on standard error. This module loads rich."""

from __future__ import annotations

from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeRemainingColumn,
)

from compwright.reporting.shown import messages_console


class ProgressBar:
    """A line for each kind of work; drawn at each report of progress, without a thread, and removed
    at the end, where the answer then begins.
    """

    def __init__(self) -> None:
        self._lines: dict[str, TaskID] = {}
        self._progress = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
            console=messages_console(),
            transient=True,
            auto_refresh=False,
        )
        self._progress.start()

    def tell(self, what: str, done: int, count: int) -> None:
        """Draw that of ``count`` things, called ``what``, so many are ``done``."""
        if what not in self._lines:
            self._lines[what] = self._progress.add_task(what, total=count)
        self._progress.update(self._lines[what], completed=done)
        self._progress.refresh()

    def stop(self) -> None:
        """Take the bar away."""
        self._progress.stop()
