"""A progress bar on standard error. This module loads the library rich."""

from __future__ import annotations

from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeRemainingColumn,
)

from compwright.reporting.safe_text import messages_console


class ProgressBar:
    """A progress bar with one line for each kind of work. It is removed at the end.

    It is drawn at each report of progress, without a thread. The answer of the command is then
    printed in its place.
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
        """Show that ``done`` of ``count`` items are complete. ``what``: the kind of work."""
        if what not in self._lines:
            self._lines[what] = self._progress.add_task(what, total=count)
        self._progress.update(self._lines[what], completed=done)
        self._progress.refresh()

    def stop(self) -> None:
        """Remove the progress bar."""
        self._progress.stop()
