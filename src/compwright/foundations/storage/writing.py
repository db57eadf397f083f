"""Write several files, all of them or none."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path, PurePosixPath

from compwright.foundations.errors import Fault, StorageError, raise_all
from compwright.foundations.session import Session
from compwright.foundations.storage.file_status import (
    identity,
    is_existing_file,
    is_folder,
    resolved,
)
from compwright.foundations.storage.hindrances import refuse_overwriting
from compwright.foundations.storage.reading import earlier_bytes, was_read
from compwright.foundations.storage.recovery import put_right_above, put_right_in
from compwright.foundations.storage.transaction import put

#: Whether an existing file of this relative name and content was written by an earlier run of the
#: same command.
Known = Callable[[str, bytes], bool]


def write_files(
    session: Session,
    folder: Path,
    files: Mapping[str, bytes],
    *,
    force: bool = False,
    elsewhere: Mapping[Path, bytes] | None = None,
    whole: Sequence[str] = (),
    renewed: Sequence[str] = (),
    completed: Sequence[str] = (),
    outdated: Sequence[str] = (),
    known: Known = lambda _name, _content: True,
) -> list[Path]:
    """Write ``files`` (name to bytes) into ``folder``, and the files ``elsewhere`` (path to bytes)
    to their own paths, all or none. The other arguments state which existing files are replaced,
    removed or kept.

    - ``known``: a function that returns whether an earlier run wrote an existing file, given its
      name and bytes. Any other file is the user's and is not replaced.
    - ``whole``: folders below ``folder`` that contain only new files afterwards. Another file in
      them is an error, unless it is known and ``force`` is true.
    - ``renewed``: folders in which the user may keep files.
    - ``completed``: files of an earlier command that are replaced even without ``force``.
    - ``outdated``: files that no longer fit the new ones.

    With ``force``, outdated files and further known files directly in the ``whole`` and ``renewed``
    folders are removed. Returns the paths in the given order.

    Raises StorageError if a file exists (unless ``force``), was read by this command or is the
    user's. Raises it also for missing permission, a full disk, and a name that leads out of
    ``folder``. After an error all files are as before, replaced ones included.
    """
    below = {_below(folder, name): name for name in files}
    _put_right(session, folder, [*below, *(elsewhere or ())], [*whole, *renewed])
    targets = _merged({path: files[name] for path, name in below.items()}, dict(elsewhere or {}))
    unchanged = _Unchanged(targets)
    refuse_overwriting(
        session, targets, force=force, completed=[_below(folder, name) for name in completed]
    )
    gone = _strangers(folder, [*whole, *renewed], targets) | {
        path: name for name in outdated if is_existing_file(path := _below(folder, name))
    }
    unchanged.add(gone)
    lost = {
        path: known(name, earlier_bytes(session, path))
        and (path in below or _lies_in(path, folder))
        for path, name in (below | gone).items()
        if is_existing_file(path)
    }
    raise_all(
        StorageError,
        [
            *_users_files(session, below, lost, targets),
            *_in_the_way(session, folder, whole, gone, lost, force=force),
        ],
    )
    removed = [
        path for path in gone if force and lost.get(path, False) and not was_read(session, path)
    ]
    put(session, folder, targets, removed, unchanged.check)
    return list(targets)


def _put_right(session: Session, folder: Path, paths: Sequence[Path], names: Sequence[str]) -> None:
    """Restore files of interrupted commands in the folders of ``paths``, and in the folders
    ``names`` below ``folder``, before these are written to.

    Folders that were searched before are searched again, because another command may have been
    interrupted in the meantime.
    """
    session.search_again()
    for path in paths:
        put_right_above(session, path, StorageError)
    for name in names:
        put_right_in(session, _below(folder, name), StorageError)


class _Unchanged:
    """The state of the files to be replaced, to notice changes until they are replaced."""

    def __init__(self, paths: Iterable[Path]) -> None:
        self._seen = {path: _seen(path) for path in paths}

    def add(self, paths: Iterable[Path]) -> None:
        self._seen |= {path: _seen(path) for path in paths}

    def check(self) -> None:
        """Raise StorageError for files that another program changed in the meantime."""
        faults = [
            Fault(
                message=(
                    "another program changed the file at this moment, so it is not overwritten"
                ),
                file=str(path),
                hint="run the command again",
            )
            for path, seen in self._seen.items()
            if _seen(path) != seen
        ]
        raise_all(StorageError, faults)


def _seen(path: Path) -> tuple[int, ...]:
    """Return numbers about a file (such as its size and time), of which at least one differs after
    the file was changed.
    """
    try:
        seen = path.lstat()
    except (OSError, ValueError):
        return ()
    return (seen.st_dev, seen.st_ino, seen.st_size, seen.st_mtime_ns)


def _lies_in(path: Path, folder: Path) -> bool:
    """Return whether a file is in ``folder`` itself, not behind a link that leads outside."""
    return resolved(folder) in (resolved(path.parent) / path.name).parents


def _merged(files: dict[Path, bytes], others: dict[Path, bytes]) -> dict[Path, bytes]:
    """Return the files of both mappings as one. Raises StorageError if a path has different
    contents in the two.
    """
    raise_all(StorageError, list(_twice_named(files, others)))
    return files | others


def _twice_named(files: Mapping[Path, bytes], others: Mapping[Path, bytes]) -> Iterator[Fault]:
    for path, content in others.items():
        if files.get(path, content) != content:
            yield Fault(
                message="two different output files would get this name",
                file=str(path),
                hint="give one of them another name",
            )


def _strangers(
    folder: Path, names: Sequence[str], targets: Mapping[Path, bytes]
) -> dict[Path, str]:
    """Return the files that are in the folders ``names`` (below ``folder``) but will not be
    written, because they are not among ``targets``.
    """
    written = {identity(path) for path in targets} - {None}
    found: dict[Path, str] = {}
    for name in names:
        inner = _below(folder, name)
        for path in sorted(inner.iterdir()) if is_folder(inner) else ():
            is_target = path in targets or identity(path) in written
            if not is_target and (path.is_file() or path.is_symlink()):
                found[path] = f"{name}/{path.name}"
    return found


def _users_files(
    session: Session,
    below: Mapping[Path, str],
    known: Mapping[Path, bool],
    targets: Mapping[Path, bytes],
) -> Iterator[Fault]:
    """Yield a fault for each file to be replaced that belongs to the user: no run wrote it, or
    somebody changed it since (``known`` is False at its path).
    """
    for path in below:
        if not known.get(path, True) and earlier_bytes(session, path) != targets[path]:
            yield Fault(
                message=(
                    "the file was not written by an earlier run, or was changed since "
                    "then, so it is not overwritten"
                ),
                file=str(path),
                hint="move the file to another folder, or give another `--out`",
            )


def _in_the_way(
    session: Session,
    folder: Path,
    whole: Sequence[str],
    gone: Mapping[Path, str],
    known: Mapping[Path, bool],
    *,
    force: bool,
) -> Iterator[Fault]:
    """Yield a fault for each of the files ``gone``, which this command does not write, that may not
    stay in one of the folders ``whole``, which contain only files of this command.
    """
    inside = {_below(folder, name) for name in whole}
    for path in gone:
        removable = known.get(path, False) and not was_read(session, path)
        if path.parent in inside and not (force and removable):
            hint = (
                "give a folder with nothing else in it, or `--force` to remove it"
                if removable
                else "move it to another folder"
            )
            yield Fault(
                message=(
                    "this folder may contain only the files of this command, because the folder is "
                    "used as a whole; this file is not one of them"
                ),
                file=str(path),
                hint=hint,
            )


def write_file(session: Session, path: Path, content: bytes, *, force: bool = False) -> Path:
    """Write one file completely. ``force``: replace any file that the command has not read."""
    if not path.name:
        raise StorageError(
            Fault(
                message="this is a folder, not a file",
                file=str(path),
                hint="give the name of a file",
            )
        )
    return write_files(session, path.parent, {path.name: content}, force=force)[0]


def _below(folder: Path, name: str) -> Path:
    parts = PurePosixPath(name).parts
    if not parts or ".." in parts or PurePosixPath(name).is_absolute() or Path(name).is_absolute():
        raise StorageError(
            Fault(
                message="the file to write is outside of the folder",
                file=name,
                hint=f"give a name inside {folder}",
            )
        )
    return folder.joinpath(*parts)
