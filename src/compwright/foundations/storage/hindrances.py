"""Rules for files that a command must not overwrite."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from compwright.foundations.errors import Fault, StorageError
from compwright.foundations.session import Session
from compwright.foundations.storage.file_status import identity, is_existing_file, reason, relative
from compwright.foundations.storage.reading import was_read

_MOST_NAMED = 4  # files named in a line about several


def refuse_overwriting(
    session: Session, targets: Mapping[Path, bytes], *, force: bool, completed: Sequence[Path] = ()
) -> None:
    """Raise StorageError if the command must not write some of the files ``targets``, such as files
    that exist already. ``completed``: existing files that may be replaced even without ``force``.

    Four kinds of targets are refused even with ``force``:

    - a file that this command has read, unless the same bytes are written;
    - the name of a folder;
    - something that is no ordinary file, such as a device or a pipe;
    - a file that would be written twice.
    """
    faults = dict.fromkeys(
        fault for path, content in targets.items() for fault in _hindrances(session, path, content)
    )
    named = {fault.file for fault in faults}
    existing = [
        path
        for path in targets
        if not (force or path in completed or str(path) in named) and is_existing_file(path)
    ]
    faults |= dict.fromkeys(_twice(targets))
    if existing:
        faults[_exist_already(existing)] = None
    if faults:
        raise StorageError(*faults)


def _hindrances(session: Session, path: Path, content: bytes) -> Iterator[Fault]:
    try:
        exists, is_file, is_folder = os.path.lexists(path), path.is_file(), path.is_dir()
        is_link = path.is_symlink()
        above = next((folder for folder in path.parents if os.path.lexists(folder)), None)
        blocked = above is not None and not above.is_dir()
        input_lost = is_file and was_read(session, path) and path.read_bytes() != content
    except (OSError, ValueError) as error:
        yield Fault(
            message="the file cannot be written",
            file=str(path),
            found=reason(error),
            hint="check the permissions of the folder, or give another `--out`",
        )
        return
    if blocked:
        yield Fault(
            message="this is not a folder, so nothing can be written into it",
            file=str(above),
            hint="give another folder",
        )
    elif is_folder:
        yield Fault(
            message="this is a folder, not a file", file=str(path), hint="give the name of a file"
        )
    elif (
        exists and not is_file and not (is_link and not path.exists())
    ):  # a link to nowhere is only a name
        yield Fault(
            message="this is not an ordinary file (a device or a pipe)",
            file=str(path),
            hint="give another name",
        )
    elif input_lost:
        yield Fault(
            message="the file is an input of this command and is not overwritten, not even "
            "with --force",
            file=str(path),
            hint="give another name",
        )


def _exist_already(paths: Sequence[Path]) -> Fault:
    """Return one fault about all files that exist already, with the name of the first."""
    if len(paths) == 1:
        return Fault(
            message="a file of this name exists already",
            file=str(paths[0]),
            hint="give another name, or `--force` to replace it",
        )
    folder = Path(os.path.commonpath([path.parent for path in paths]))
    names = [relative(path, folder) for path in paths[:_MOST_NAMED]]
    more = len(paths) - len(names)
    return Fault(
        message=f"{len(paths)} of the files to write exist already in this folder",
        file=str(folder),
        found=", ".join(names) + (f" and {more} more" if more else ""),
        hint="give another folder (`--out`), or `--force` to replace them",
    )


def _twice(targets: Mapping[Path, bytes]) -> Iterator[Fault]:
    """Yield a fault for each file that would be written twice with different contents."""
    seen: dict[object, bytes] = {}
    for path, content in targets.items():
        if seen.setdefault(identity(path) or _place(path), content) != content:
            yield Fault(
                message="two different output files would get this name",
                file=str(path),
                hint="give one of them another name",
            )


def _place(path: Path) -> str:
    with suppress(OSError, ValueError, RuntimeError):
        return os.path.normcase(path.resolve())
    return str(path)
