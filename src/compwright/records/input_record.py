"""The list of a command's input files in the record of a result folder."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

InputRole = Literal[
    "job",
    "definition",
    "test",
    "profile",
    "circle",
    "drift",
    "environment",
    "logo",
    "state",
    "after",
    "loaded",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordedInput:
    """A file that a command read, and where the result folder has its copy.

    ``file``: as the job or the command line names it. ``copy``: the path of the same bytes below
    the result folder, or None if they are not in it. ``of``: the test or the state of the control
    to which the file belongs. ``by``: the command that read it, ``run`` or ``verify``.
    """

    role: InputRole
    of: str
    file: str
    sha256: str
    size: int
    copy: str | None
    by: str
