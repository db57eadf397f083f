"""Run a command line and return its exit code."""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from io import StringIO, TextIOWrapper
from typing import NoReturn

import click

from compwright.cli.saying import ask_for_report, errors, tell
from compwright.cli.words import Invocation, compwright
from compwright.foundations.errors import CompwrightError, StorageError, UsageError
from compwright.foundations.own_faults import OWN_FAULT, own_fault
from compwright.foundations.parallel_work import Crew, Each, alone
from compwright.foundations.processors import look_for_garbage_seldom, use_one_thread
from compwright.foundations.session import Session
from compwright.foundations.utf8 import visible


def main() -> NoReturn:
    """Run the command line and exit with its exit code."""
    use_one_thread()
    look_for_garbage_seldom()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(
            stream, TextIOWrapper
        ):  # a terminal that knows no µ gets a question mark, not a crash
            stream.reconfigure(errors="replace")
    sys.exit(run(sys.argv[1:], crew=_side_by_side))


def _side_by_side(items: int, ready: Callable[[], None]) -> AbstractContextManager[Each]:
    """Return the parallel workers for the axes of a job, of which each calls ``ready`` first; their
    module is imported here because few commands need it.
    """
    from compwright.foundations.processes import side_by_side

    return side_by_side(items, ready)


def run(arguments: list[str], crew: Crew = alone) -> int:
    """Run a command and return its exit code. Errors are printed as lines, without traceback.
    ``crew``: makes the parallel workers for the axes of a job.
    """
    session = Session()
    try:
        return _done(arguments, Invocation(session, crew))
    finally:
        for folder in session.restored:
            tell(
                f"{visible(folder)}: a command that was stopped had begun to write here; its files"
                " are again as they were before it"
            )


def _done(arguments: list[str], invocation: Invocation) -> int:
    try:
        code = compwright.main(
            args=arguments, prog_name="compwright", standalone_mode=False, obj=invocation
        )
    except click.exceptions.Exit as leaving:
        return leaving.exit_code
    except SystemExit:  # raised where the reader of the help has closed the pipe
        return 0
    except click.Abort:
        tell("stopped")
        return 130
    except click.ClickException as error:
        return _wrong_words(error)
    except CompwrightError as error:
        errors(error.lines())
        return error.exit_code
    # any other exception is a fault of compwright itself, and reported as one
    except Exception as error:  # noqa: BLE001
        if (
            isinstance(error, OSError) and error.errno == errno.ENOSPC
        ):  # files are written elsewhere: this is standard output
            sys.stdout = StringIO()
            errors([f"standard output: cannot be written; found {error.strerror}"])
            return StorageError.exit_code
        return _own_fault(error)
    return code if isinstance(code, int) else 0


def _wrong_words(error: click.ClickException) -> int:
    context = error.ctx if isinstance(error, click.UsageError) else None
    if (
        context is not None and error.format_message() == context.get_help()
    ):  # a group without a command shows its help
        tell(error.format_message())
        return UsageError.exit_code
    errors([error.format_message()])
    if context is not None:
        # A value that is wrong is in the message with those that are right: an example of
        # other options would lead away from it.
        wrong_value = type(error) is click.BadParameter
        example = "" if wrong_value else next(iter(getattr(context.command, "examples", ())), "")
        tell(f"Next: {example and f'{example}; or '}{context.command_path} --help")
    return UsageError.exit_code


def _own_fault(error: Exception) -> int:
    errors([str(own_fault(error))])
    ask_for_report()
    return OWN_FAULT
