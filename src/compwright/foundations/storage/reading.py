"""Read ordinary files completely, and record each as an input of the session."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.file_kinds import refuse_other_kind
from compwright.foundations.input_sizes import ANY, InputKind, in_words
from compwright.foundations.session import Session
from compwright.foundations.storage.file_status import identity, reason
from compwright.foundations.storage.recovery import put_right_above

#: Opening what became a pipe since it was looked at must not wait for the other end (POSIX;
#: elsewhere there is no such flag).
_NO_WAITING = (
    getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
)


def read_bytes(session: Session, path: Path, kind: InputKind = ANY) -> bytes:
    """Return the bytes of a file, or of a file that this session will write but has not written
    yet, and record the file as an input.

    Raises InputError for a file that is missing, cannot be read, or is larger than allowed for its
    ``kind``. Raises it too for a device or a pipe, because reading that might never end. A file
    that is clearly of another kind is a UsageError if a job, profile, definition or virtual machine
    was expected, else an InputError.
    """
    pending = session.pending.get(path)
    if pending is not None:
        return pending
    put_right_above(session, path, InputError)
    try:
        refused = _not_to_be_read(path.stat(), kind)
        if refused is None:
            with open(path, "rb", opener=_opened) as stream:
                seen = os.fstat(stream.fileno())
                refused = _not_to_be_read(seen, kind)
                content = b"" if refused else _at_most(stream, seen.st_size, kind.most_bytes + 1)
            session.inputs.add((seen.st_dev, seen.st_ino))
    except FileNotFoundError as error:
        raise InputError(_absent(path).in_file(str(path))) from error
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have (a null byte)
        refused = Fault(
            message="the file cannot be read",
            found=reason(error),
            hint="check the path, and whether you may read the file",
        )
        raise InputError(refused.in_file(str(path))) from error
    if refused is None and len(content) > kind.most_bytes:  # longer than it says itself
        refused = _too_large(kind, f"more than {in_words(kind.most_bytes)}")
    if refused is not None:
        raise InputError(refused.in_file(str(path)))
    refuse_other_kind(content, kind, str(path))
    return content


def _absent(path: Path) -> Fault:
    """Return the fault of a missing file, with the command that writes it if it is a result."""
    from compwright.foundations.key_faults import nearest

    folder = next((one for one in path.parents if one.is_dir()), path.parent)
    part = path.relative_to(folder).parts[0]
    place = "the current folder" if folder == Path() else str(folder)
    found, hint = f"no {part!r} in {place}", "check the path"
    with contextlib.suppress(OSError):
        if near := nearest(part, (one.name for one in folder.iterdir())):
            found, hint = f"{near} in {place}", f"give {folder / near}, or check the path"
    if part == "tables" and (folder / "plan.json").is_file():
        hint = (
            "this run wrote no table: `compwright run` says why; give the control's files as"
            " `states` in the job and run it again"
        )
    elif path.name == "plan.json":
        hint = "write it with `compwright run JOB.yaml`, or check the path"
    return Fault(message="the file does not exist", found=found, hint=hint)


def _at_most(stream: BinaryIO, size: int, count: int) -> bytes:
    """Return up to ``count`` bytes of a stream. Raises OSError if the stream has no data at once,
    such as an empty pipe.

    ``size``: the size that the file states. More memory is reserved only if there is more to read.
    """
    content = b""
    for most in (size + 1, count - size - 1):
        part = stream.read(most)
        if part is None:
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        content += part
        if len(part) < most:
            break
    return content


def earlier_bytes(session: Session, path: Path) -> bytes:
    """Return the bytes of an earlier result, or b"" if there is no such file. The file is not
    recorded as an input of the session.

    Raises InputError if an interrupted command left the file incomplete and it cannot be restored.
    """
    put_right_above(session, path, InputError)
    return bytes_as_they_are(path)


def bytes_as_they_are(path: Path) -> bytes:
    """Return the bytes of a file as it is, without restoring interrupted changes first; b"" if
    there is no file.
    """
    try:
        small = path.is_file() and path.stat().st_size <= ANY.most_bytes
        return path.read_bytes() if small else b""
    except (OSError, ValueError):
        return b""


def _opened(path: str, flags: int) -> int:
    return os.open(path, flags | _NO_WAITING)


def _not_to_be_read(seen: os.stat_result, kind: InputKind) -> Fault | None:
    """Return the fault of a folder, a device or too large a file, or None for other files.
    ``seen``: the file's status from the file system; ``kind``: the kind of input that is expected.
    """
    kinds = (
        (stat.S_ISDIR, "a folder"),
        (stat.S_ISFIFO, "a pipe"),
        (stat.S_ISSOCK, "a socket"),
        (stat.S_ISCHR, "a device"),
        (stat.S_ISBLK, "a device"),
    )
    found = next((name for is_kind, name in kinds if is_kind(seen.st_mode)), None)
    if found is not None:
        hint = f"give {kind.help or 'the name of a file'}"
        return Fault(message="the file cannot be read", expected=kind.name, found=found, hint=hint)
    if seen.st_size > kind.most_bytes:
        return _too_large(kind, in_words(seen.st_size))
    return None


def _too_large(kind: InputKind, found: str) -> Fault:
    expected = f"{kind.name} of at most {in_words(kind.most_bytes)}"
    hint = f"give {kind.help or 'a smaller file'}"
    return Fault(message="the file is too large", expected=expected, found=found, hint=hint)


def state_of(session: Session, paths: Sequence[Path]) -> str:
    """Return a text made of the size and the time of each file, by which later changes are noticed.
    The files are recorded as inputs of the session.
    """
    states = []
    for path in paths:
        put_right_above(session, path, InputError)
        try:
            seen = path.stat()
            session.inputs.add((seen.st_dev, seen.st_ino))
            states.append(f"{seen.st_size}:{seen.st_mtime_ns}")
        except (OSError, ValueError):
            states.append("-")
    return " ".join(states)


def was_read(session: Session, path: Path) -> bool:
    """Return whether the file at ``path`` was read in this session, under this or another name."""
    return identity(path) in session.inputs
