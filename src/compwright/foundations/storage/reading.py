"""Reading whole: ordinary files alone, and what a command has read is remembered as its input."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Sequence
from pathlib import Path

from compwright.foundations.command_inputs import is_input, remember
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.foreseen import foreseen_bytes
from compwright.foundations.storage.looking import identity, reason

_MOST_BYTES = 256 * 1024 * 1024  # no measurement or control file comes near it
#: Opening what became a pipe since it was looked at must not wait for the other end (POSIX;
#: elsewhere there is no such flag).
_NO_WAITING = (
    getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
)


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file, and remember that it was read; of one that is to be written with
    what is made of it (`foreseen`) the bytes that it will have.

    Raises InputError when it is missing, cannot be read, is no ordinary file (a pipe or device
    could be waited for without end) or is larger than 256 MiB.
    """
    expected = foreseen_bytes(path)
    if expected is not None:
        return expected
    try:
        refused = _not_to_be_read(path.stat())
        if refused is None:
            with open(path, "rb", opener=_opened) as stream:
                seen = os.fstat(stream.fileno())
                refused = _not_to_be_read(seen)
                content = stream.read(_MOST_BYTES + 1) if refused is None else b""
            remember((seen.st_dev, seen.st_ino))
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have (a null byte)
        raise InputError(
            Fault(message="cannot be read", file=str(path), found=reason(error))
        ) from error
    if refused is not None:
        raise InputError(
            Fault(
                message="cannot be read", file=str(path), expected="an ordinary file", found=refused
            )
        )
    if len(content) > _MOST_BYTES:
        raise InputError(
            Fault(message="is too large", file=str(path), expected=f"at most {_MOST_BYTES} bytes")
        )
    return content


def earlier_bytes(path: Path) -> bytes:
    """Return the bytes of a result of an earlier run, empty where there is none; it counts as a
    result, not as an input.
    """
    try:
        return path.read_bytes() if path.is_file() and path.stat().st_size <= _MOST_BYTES else b""
    except (OSError, ValueError):
        return b""


def _opened(path: str, flags: int) -> int:
    return os.open(path, flags | _NO_WAITING)


def _not_to_be_read(seen: os.stat_result) -> str | None:
    """Return what it is that cannot be read as a file, None for an ordinary file."""
    kinds = (
        (stat.S_ISDIR, os.strerror(errno.EISDIR)),
        (stat.S_ISFIFO, "a pipe"),
        (stat.S_ISSOCK, "a socket"),
        (stat.S_ISCHR, "a device"),
        (stat.S_ISBLK, "a device"),
    )
    return next((name for is_kind, name in kinds if is_kind(seen.st_mode)), None)


def state_of(paths: Sequence[Path]) -> str:
    """Return what the file system says of files: the same text as long as none was changed, added
    or taken away. They count as read: what is said of them comes from here.
    """
    told = []
    for path in paths:
        try:
            seen = path.stat()
            remember((seen.st_dev, seen.st_ino))
            told.append(f"{seen.st_size}:{seen.st_mtime_ns}")
        except (OSError, ValueError):
            told.append("-")
    return " ".join(told)


def was_read(path: Path) -> bool:
    """Whether this command has read the file at ``path``, by this or another name."""
    return is_input(identity(path))
