"""Disk operations that are durable, even if the power fails."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from time import sleep

_NEW = (
    os.O_WRONLY
    | os.O_CREAT
    | os.O_EXCL
    | getattr(os, "O_BINARY", 0)
    | getattr(os, "O_CLOEXEC", 0)
    | getattr(os, "O_NOINHERIT", 0)
)
_WINDOWS = os.name == "nt"
#: s: on Windows a virus scanner opens each new file for a moment, and blocks its renaming.
_PAUSES = (0.05, 0.2, 0.75)
#: What a file system answers that cannot make a folder last by itself.
_NOT_FOR_FOLDERS = {
    getattr(errno, name)
    for name in ("EINVAL", "ENOTSUP", "EOPNOTSUPP", "ENOSYS", "EBADF")
    if hasattr(errno, name)
}


def write_new(path: Path, content: bytes) -> None:
    """Write a new file and wait until it is stored on the disk. Raises OSError."""
    handle = os.open(path, _NEW, 0o666)  # less the bits of the user's mask
    try:
        rest = memoryview(content)
        while rest:
            rest = rest[os.write(handle, rest) :]
        os.fsync(handle)
    finally:
        os.close(handle)


def sync_folder(folder: Path) -> None:
    """Wait until the file names in a folder are stored on the disk. Raises OSError.

    Nothing is done on Windows, which cannot open folders and itself keeps the order of changes to
    names (NTFS). Nothing is done on a file system without this operation either.
    """
    if not hasattr(os, "O_DIRECTORY"):
        return
    try:
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | getattr(os, "O_CLOEXEC", 0))
    except PermissionError:  # a folder to write into, not to list
        return
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno not in _NOT_FOR_FOLDERS:
            raise
    finally:
        os.close(handle)


def move(source: Path, target: Path) -> None:
    """Rename a file within one file system; a file that already has the new name is replaced.
    Raises OSError.
    """
    for pause in _PAUSES if _WINDOWS else ():
        try:
            source.replace(target)
        except PermissionError:
            sleep(pause)
        else:
            return
    source.replace(target)


def remove(path: Path) -> None:
    """Remove a file, on Windows also a read-only one. Raises OSError."""
    try:
        path.unlink(missing_ok=True)
    except PermissionError:
        if not _WINDOWS:
            raise
        path.chmod(0o666)
        path.unlink(missing_ok=True)


def make_folder(folder: Path, made: list[Path]) -> None:
    """Make a folder and its missing parents. Each folder made is added to ``made`` at once, so that
    ``made`` is right even if a later folder fails.
    """
    missing: list[Path] = []
    probe = folder
    while not probe.exists():
        missing.append(probe)
        probe = probe.parent
    for path in reversed(missing):
        path.mkdir(exist_ok=True)
        made.append(path)
