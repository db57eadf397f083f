"""List the contents of folders, after restoring files of interrupted commands."""

from __future__ import annotations

import glob
import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.session import Session
from compwright.foundations.storage.file_status import is_folder, reason
from compwright.foundations.storage.journal import UNFINISHED
from compwright.foundations.storage.recovery import put_right_above, put_right_in


def list_files(session: Session, path: Path) -> list[Path]:
    """Return ``[path]`` for a file, or the files in a folder by name. Hidden ones are left out.

    Entries that are no ordinary files (a pipe, a link to nowhere) are listed too; `read_bytes`
    raises an error for them. Raises InputError if the folder cannot be listed.
    """
    put_right_in(session, path, InputError)
    try:
        if not path.is_dir():
            return [path]
        return sorted(
            entry for entry in path.iterdir() if not (entry.name.startswith(".") or entry.is_dir())
        )
    except (OSError, ValueError) as error:
        raise InputError(
            Fault(
                message="the folder cannot be read",
                file=str(path),
                found=reason(error),
                hint="check the path and its permissions",
            )
        ) from error


def folders_in(path: Path) -> list[Path]:
    """Return the folders in a folder, without hidden ones; none if it cannot be listed."""
    try:
        return sorted(
            entry for entry in path.iterdir() if entry.is_dir() and not entry.name.startswith(".")
        )
    except (OSError, ValueError):
        return []


def in_folders_of(session: Session, folder: Path, name: str) -> list[Path]:
    """Return the files called ``name`` in the folders directly inside ``folder``."""
    found = []
    try:
        for inner in sorted(path for path in folder.iterdir() if path.is_dir()):
            with suppress(InputError):
                put_right_in(session, inner, InputError)
                found += [inner / name] if (inner / name).is_file() else []
    except (OSError, ValueError):
        return []
    return found


def folders_holding(
    session: Session, top: Path, names: Sequence[str]
) -> tuple[list[Path], list[Fault]]:
    """Return those folders in ``top`` (at any depth) that contain a file with one of ``names``, and
    a fault for each unreadable folder.

    The folders are sorted by name. Hidden folders and links to folders are left out. Raises
    InputError if ``top`` is no folder.
    """
    if not is_folder(top):
        raise InputError(
            Fault(
                message="this is not a folder",
                file=str(top),
                expected="a folder with results",
                found="a file" if is_there(session, top) else "nothing",
                hint="give a folder that `compwright run` or `verify` wrote",
            )
        )
    found: list[Path] = []
    faults: list[Fault] = []

    def refused(error: OSError) -> None:
        faults.append(
            Fault(
                message="the folder cannot be read",
                file=str(error.filename or top),
                found=reason(error),
                hint="check the path and its permissions",
            )
        )

    put_right_above(session, top, InputError)
    for folder, below, files in os.walk(top, onerror=refused):
        if UNFINISHED not in (*below, *files):
            session.searched.add(os.path.abspath(folder))  # noqa: PTH100 - for every folder
        else:
            try:
                put_right_in(session, Path(folder), InputError)
                below[:], files[:] = _names_in(Path(folder))
            except InputError as left:
                faults.extend(left.faults)
                below[:], files[:] = [], []
        below[:] = sorted(name for name in below if not name.startswith("."))
        if not set(names).isdisjoint(files):
            found.append(Path(folder))
    return sorted(found), faults


def _names_in(folder: Path) -> tuple[list[str], list[str]]:
    """Return the names of folders and of files in a folder; none if it cannot be listed."""
    try:
        with os.scandir(folder) as entries:
            kinds = [(entry.name, entry.is_dir()) for entry in entries]
    except OSError:
        return [], []
    return [name for name, is_dir in kinds if is_dir], [
        name for name, is_dir in kinds if not is_dir
    ]


def is_there(session: Session, path: Path) -> bool:
    """Return whether a file, folder or link exists, or will be written by this session. Raises
    InputError if interrupted changes cannot be restored.
    """
    if path in session.pending:
        return True
    put_right_above(session, path, InputError)
    return os.path.lexists(path)


def matching(session: Session, pattern: str) -> list[str]:
    """Return the paths that match a pattern with ``*`` and ``?``, or the pattern if none does."""
    if not {"*", "?"} & set(pattern) or os.path.lexists(pattern):
        return [pattern]
    put_right_above(session, Path(pattern), InputError)
    try:
        # not of pathlib: hidden files stay out, as in a shell
        found = sorted(glob.glob(pattern.replace("[", "[[]")))  # noqa: PTH207
    except (OSError, ValueError):
        found = []
    return found or [pattern]
