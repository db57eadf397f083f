"""What lies where, without reading it."""

from __future__ import annotations

import glob
import os
from collections.abc import Sequence
from pathlib import Path

from compwright.foundations.command_inputs import Identity
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.foreseen import foreseen_bytes


def list_files(path: Path) -> list[Path]:
    """Return ``[path]`` for a file or for nothing, and for a folder all in it but folders by name,
    hidden ones left out.

    What is no ordinary file (a pipe, a link to nowhere) is listed too: `read_bytes` says so. Raises
    InputError when the folder cannot be listed.
    """
    try:
        if not path.is_dir():
            return [path]
        return sorted(
            entry for entry in path.iterdir() if not (entry.name.startswith(".") or entry.is_dir())
        )
    except (OSError, ValueError) as error:
        raise InputError(
            Fault(message="folder cannot be read", file=str(path), found=reason(error))
        ) from error


def in_folders_of(folder: Path, name: str) -> list[Path]:
    """Return the files called ``name`` that lie in the folders of ``folder``, one level down; what
    cannot be listed has none.
    """
    try:
        return sorted(path for path in folder.glob(f"*/{name}") if path.is_file())
    except OSError:
        return []


def folders_holding(top: Path, names: Sequence[str]) -> tuple[list[Path], list[Fault]]:
    """Return ``top`` and the folders below it that hold a file of one of ``names``, in the order of
    their names, and those that cannot be read; hidden folders and links to folders are left out.

    Raises InputError where ``top`` is no folder.
    """
    if not is_folder(top):
        raise InputError(
            Fault(
                message="is no folder",
                file=str(top),
                expected="a folder with results",
                found="a file" if is_there(top) else "nothing",
            )
        )
    found: list[Path] = []
    faults: list[Fault] = []

    def refused(error: OSError) -> None:
        faults.append(
            Fault(
                message="folder cannot be read",
                file=str(error.filename or top),
                found=reason(error),
            )
        )

    for folder, below, files in os.walk(top, onerror=refused):
        below[:] = sorted(name for name in below if not name.startswith("."))
        if not set(names).isdisjoint(files):
            found.append(Path(folder))
    return sorted(found), faults


def resolved(path: Path) -> Path:
    """Return ``path`` from the root, without links; as it is where it cannot be followed."""
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return path


def is_there(path: Path) -> bool:
    """Whether there is a file, folder or link at ``path``; False for a name that no file can
    have.
    """
    return foreseen_bytes(path) is not None or os.path.lexists(path)


def is_folder(path: Path) -> bool:
    """Whether ``path`` is a folder that can be looked at."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


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


def matching(pattern: str) -> list[str]:
    """Return the paths that fit a pattern with ``*`` and ``?`` by name, hidden ones left out; the
    pattern itself where something is called so, and where nothing fits.
    """
    if not {"*", "?"} & set(pattern) or os.path.lexists(pattern):
        return [pattern]
    try:
        # not of pathlib: hidden files stay out, as in a shell
        found = sorted(glob.glob(pattern.replace("[", "[[]")))  # noqa: PTH207
    except (OSError, ValueError):
        found = []
    return found or [pattern]


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
    strerror = getattr(error, "strerror", None)
    return strerror or str(error) or type(error).__name__
