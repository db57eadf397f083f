"""Functions that look at paths without changing anything: whether a path exists, its size, its
absolute or relative form.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from compwright.foundations.session import Identity


def is_folder(path: Path) -> bool:
    """Return whether ``path`` is a readable folder."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def size_of(paths: Iterable[Path]) -> int:
    """Return the total size of files, in bytes. Raises OSError if a file is missing."""
    return sum(path.stat().st_size for path in paths)


def resolved(path: Path) -> Path:
    """Return ``path`` as an absolute path without links, or unchanged if that fails."""
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return path


def relative(path: Path, folder: Path) -> str:
    """Return ``path`` relative to ``folder``, with ``/``, or absolute on another drive."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        return path.as_posix()


def way_to(path: Path, folder: Path) -> str:
    """Return ``path`` relative to ``folder``, with ``/``; links are resolved before comparison.

    The path is absolute if there is no relative one (another drive). The folder need not exist yet.
    """
    plain = path.name not in {"", ".."}
    whole = resolved(path.parent) / path.name if plain else resolved(path)
    return relative(whole, resolved(folder))


def named_from(folder: Path, name: str) -> Path:
    """Return the path of the file ``name`` in ``folder``. Parts ``..`` are removed if the shorter
    path leads to the same file.

    They are also removed if the file does not exist: a folder on the longer path may not exist yet.
    """
    path = folder / name
    if ".." not in Path(name).parts:
        return path
    short = Path(os.path.normpath(path))
    there = identity(path)
    return short if there is None or there == identity(short) else path


def identity(path: Path) -> Identity | None:
    """Return device and inode of the file at ``path``, or None if there is no file."""
    try:
        seen = path.stat()
    except (OSError, ValueError):
        return None
    return (seen.st_dev, seen.st_ino)


def is_existing_file(path: Path) -> bool:
    """Return whether a new file at ``path`` would replace a file or a link to a file."""
    try:
        return os.path.lexists(path) and (path.is_file() or path.is_symlink()) and not path.is_dir()
    except (OSError, ValueError):
        return False


def reason(error: OSError | ValueError) -> str:
    """Return why the file system refused an operation, as text."""
    return getattr(error, "strerror", None) or str(error) or type(error).__name__
