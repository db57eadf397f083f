"""Report an internal fault of compwright as one line instead of a traceback."""

from __future__ import annotations

from pathlib import Path

from compwright.foundations.errors import Fault

#: Exit code of a fault of compwright's own.
OWN_FAULT = 70
#: The next step for an internal error that depends on the job.
SEND_JOB = "send this line, the job and its files to the developers of compwright"


def own_fault(error: Exception, file: str = "") -> Fault:
    """Return the fault that reports an internal error of compwright: class, text and line."""
    from traceback import extract_tb  # loaded where there is a fault: help and results need none

    frames = extract_tb(error.__traceback__)
    where = next(
        (frame for frame in reversed(frames) if "compwright" in frame.filename), frames[-1]
    )
    return Fault(
        message=(
            f"an internal error of compwright: {type(error).__name__}: {error}"
            f" ({Path(where.filename).name}, line {where.lineno})"
        ),
        file=file,
        hint="send this line, the command and the input files to the developers of compwright",
    )
