"""Print to standard output and standard error, even if these are closed or full."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from io import StringIO
from pathlib import Path
from typing import Any

import click

from compwright import __version__
from compwright.foundations.session import Session
from compwright.foundations.utf8 import visible, visible_lines

#: Most errors that are printed: a file of the wrong kind is wrong in every line.
_MOST_ERRORS = 25


def print_safely(say: Callable[[], None]) -> None:
    """Call ``say`` to print on standard output; a reader that stops early causes no error."""
    try:
        say()
    except (BrokenPipeError, SystemExit):  # SystemExit: rich leaves the program then
        sys.stdout = StringIO()


def print_lines(lines: Iterable[str]) -> None:
    """Print lines on standard output."""
    print_safely(lambda: click.echo("\n".join(map(visible_lines, lines))))


def answer(
    document: Mapping[str, Any], json_path: Path | None, renderables: Callable[[], list[Any]]
) -> None:
    """Print the result of a command: as JSON for ``--json -``, else as text and tables."""
    from compwright.workflow.results.answers import show, to_json

    if _on_output(json_path):
        text = to_json(document).encode()  # always UTF-8, whatever the terminal speaks
        print_safely(lambda: click.echo(text, nl=False))
    else:
        print_safely(lambda: show(renderables()))


def deliver(
    session: Session,
    document: Mapping[str, Any],
    json_path: Path | None,
    renderables: Callable[[], list[Any]],
    *,
    force: bool,
) -> None:
    """Write a command's document to the file of ``--json``, and print the result."""
    from compwright.workflow.results.answers import write_document

    to_file = json_file(json_path)
    if to_file is not None:
        write_document(session, document, to_file, force=force)
    answer(document, json_path, renderables)


def answer_lines(
    document: Mapping[str, Any], json_path: Path | None, lines: Callable[[], Iterable[str]]
) -> None:
    """Print the result of a command: as JSON for ``--json -``, else as lines of text."""
    if _on_output(json_path):
        answer(document, json_path, list)
    else:
        print_lines(map(visible, lines()))


def next_step_line(json_path: Path | None, line: Callable[[], str]) -> None:
    """Print the next step as the last line of the output, but not if the output is JSON (``--json
    -``).
    """
    if not _on_output(json_path):
        print_lines([line()])


def _on_output(json_path: Path | None) -> bool:
    return json_path is not None and str(json_path) == "-"


def json_file(json_path: Path | None) -> Path | None:
    """Return the file named by ``--json``, or None without one or for standard output (``-``)."""
    return None if _on_output(json_path) else json_path


def errors(lines: Iterable[str]) -> int:
    """Print errors, one per line, up to a limit. Returns the number of those not printed."""
    texts = list(lines)
    for line in texts[:_MOST_ERRORS]:
        tell(f"error: {visible(line)}")
    more = max(len(texts) - _MOST_ERRORS, 0)
    if more:
        tell(f"error: ... and {more} more like these")
    return more


def tell(line: str) -> None:
    """Print a line on standard error, without an exception if that is closed or full."""
    try:
        click.echo(visible_lines(line), err=True)
    except OSError:
        sys.stderr = StringIO()


def ask_for_report() -> None:
    """Print how to report an internal error of compwright."""
    tell(
        f"Please send this line, the command, the input files and the version {__version__} to the"
        " developers of compwright."
    )


def on_terminal() -> bool:
    """Return whether standard error is a terminal, which can show a progress bar."""
    return sys.stderr.isatty()
