"""What lies at a name, by the file system alone."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from compwright.foundations.session import Identity


def is_folder(path: Path) -> bool:
    """Whether ``path`` is a folder that can be looked at."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def size_of(paths: Iterable[Path]) -> int:
    """Return the size of files together, in bytes. Raises OSError for one that is not there."""
    return sum(path.stat().st_size for path in paths)


def resolved(path: Path) -> Path:
    """Return ``path`` from the root, without links; as it is where it cannot be followed."""
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return path


def relative(path: Path, folder: Path) -> str:
    """Return how ``path`` is named from ``folder``, with ``/``; whole where there is no such way
    (another drive).
    """
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        return path.as_posix()


def way_to(path: Path, folder: Path) -> str:
    """Return how ``path`` is named from ``folder`` by a name that holds through links, with ``/``;
    whole where there is no such way (another drive). The folder need not be there yet.
    """
    plain = path.name not in {"", ".."}
    whole = resolved(path.parent) / path.name if plain else resolved(path)
    return relative(whole, resolved(folder))


def named_from(folder: Path, name: str) -> Path:
    """Return the path of what a file in ``folder`` calls ``name``: without the way into the folder
    and out of it again, which may not be there yet.
    """
    path = folder / name
    if ".." not in Path(name).parts:
        return path
    short = Path(os.path.normpath(path))
    there = identity(path)
    return short if there is None or there == identity(short) else path


def identity(path: Path) -> Identity | None:
    """Return what the file at ``path`` is, None where there is none."""
    try:
        seen = path.stat()
    except (OSError, ValueError):
        return None
    return (seen.st_dev, seen.st_ino)


def is_existing_file(path: Path) -> bool:
    """Whether something stands at ``path`` that a file would replace: a file or any link but one to
    a folder.
    """
    try:
        return os.path.lexists(path) and (path.is_file() or path.is_symlink()) and not path.is_dir()
    except (OSError, ValueError):
        return False


def reason(error: OSError | ValueError) -> str:
    """Return why the file system refused, in its own words."""
    return getattr(error, "strerror", None) or str(error) or type(error).__name__
