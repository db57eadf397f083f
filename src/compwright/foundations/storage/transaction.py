"""Replace several files together, all or none, even if the process is stopped.

The new files are first written to a temporary folder and synced, before any other file is changed.
Then the journal is put there by one rename. The old files are moved there, then the new files are
moved to their places. The removal of the journal completes the change. If the process is stopped
before, the next command undoes the change (`recovery`). After an error or Ctrl-C this command
itself undoes it. A single file in an existing folder needs no journal: one rename is enough.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from compwright.foundations.errors import Fault, StorageError
from compwright.foundations.session import Session
from compwright.foundations.storage import disk
from compwright.foundations.storage.file_status import reason, relative, resolved
from compwright.foundations.storage.journal import (
    JOURNAL,
    UNFINISHED,
    Journal,
    JournalEntry,
    digest_at,
    digest_of,
    is_ours,
    new_file,
    old_file,
    put_journal,
)
from compwright.foundations.storage.locking import Lock, take
from compwright.foundations.storage.recovery import (
    NotPutRightError,
    clear,
    sync_folders,
    withdraw,
)


def put(
    session: Session,
    folder: Path,
    targets: Mapping[Path, bytes],
    removed: Sequence[Path],
    check: Callable[[], None],
) -> None:
    """Write ``targets`` (path to bytes) and remove the paths ``removed``, all or nothing. ``check``
    is called just before that, and raises an error if a file was changed in the meantime.

    ``folder``: the folder whose journal decides, if any of the files is below it. During ``check``
    all folders are locked, so no other process can write there. Raises StorageError; then
    everything is as it was before.
    """
    try:
        parts = _parts(folder, targets, removed)
    except OSError as error:
        fault = Fault(
            message="files cannot be written into this folder",
            file=str(folder),
            found=reason(error),
            hint="check the permissions and the free space of this folder",
        )
        raise StorageError(fault) from error
    if parts:
        _Work(session, parts, next(iter((*targets, *removed)))).do(check)


@dataclass(frozen=True, slots=True)
class _Change:
    """A file to be written, or to be removed if it has no ``content``."""

    name: str
    path: Path  # as the caller named it
    content: bytes | None


@dataclass(slots=True)
class _Part:
    """A folder, and the changes of files in it, all on one file system."""

    folder: Path
    changes: dict[str, _Change] = field(default_factory=dict)


def _parts(folder: Path, targets: Mapping[Path, bytes], removed: Sequence[Path]) -> list[_Part]:
    """Return the changes grouped by folder. Those in or below ``folder`` and on its file system are
    one group, the first.
    """
    root = resolved(folder)
    found = {root: _Part(root)}
    contents: dict[Path, bytes | None] = {**targets, **dict.fromkeys(removed)}
    for path, content in contents.items():
        home = resolved(path.parent)
        near = home.is_relative_to(root) and _device(home) == _device(root)
        part = found.setdefault(root if near else home, _Part(root if near else home))
        name = (home / path.name).relative_to(part.folder).as_posix()
        part.changes[os.path.normcase(name)] = _Change(name, path, content)
    return [part for part in found.values() if part.changes]


def _device(folder: Path) -> int:
    """Return the number of the file system on which a folder is, or will be made."""
    there = next((path for path in (folder, *folder.parents) if path.exists()), folder)
    return there.stat().st_dev


class _Work:
    """A change of several files in steps, each of which can be undone."""

    def __init__(self, session: Session, parts: list[_Part], current: Path) -> None:
        self.session = session
        self.parts = parts
        self.current = current  # the file that an error names
        self.above: list[Path] = []  # folders that were made to hold the results
        self.locks: list[Lock] = []
        self.sets: list[tuple[Path, Journal]] = []

    def do(self, check: Callable[[], None]) -> None:
        """Make all changes, or undo them on an error (StorageError) or Ctrl-C. ``check`` is called
        before the first change, and can stop it by an error.
        """
        try:
            self._prepare(check)
            if self._is_one_step():
                self._place_one()
            else:
                self._begin()
                self._move()
                self._finish()
        except (OSError, ValueError) as error:
            more = self._take_back()
            raise StorageError(
                Fault(
                    message="the file cannot be written",
                    file=str(self.current),
                    found=reason(error),
                    hint="check the permissions and the free space of this folder",
                ),
                *more,
            ) from error
        except BaseException:  # Ctrl-C leaves nothing half-written either
            self._take_back()
            raise
        finally:
            for lock in self.locks:
                lock.release()

    def _prepare(self, check: Callable[[], None]) -> None:
        """Lock all folders, call ``check``, and write all new files to temporary places on the
        disk, before anything is changed.
        """
        for part in sorted(self.parts, key=lambda part: str(part.folder)):
            self.current = next(iter(part.changes.values())).path
            disk.make_folder(part.folder, self.above)
            lock = take(part.folder / UNFINISHED, make=True)
            self.locks.append(lock)
            self._sweep(lock)
        check()
        for part in self.parts:
            for number, change in enumerate(part.changes.values()):
                if change.content is not None:
                    self.current = change.path
                    self._stage(part, number, change.content)

    def _sweep(self, lock: Lock) -> None:
        """Remove temporary files of an interrupted process."""
        if os.path.lexists(lock.staging / JOURNAL):
            why = self.session.unrestored.get(str(lock.staging.parent), ())
            now = Fault(
                message="another command is writing into this folder",
                file=str(lock.staging),
                hint="wait until the other command has ended, then run this command again",
            )
            raise StorageError(*(why or (now,)))
        for name in os.listdir(lock.staging):  # noqa: PTH208 - names, no paths
            if is_ours(name):
                disk.remove(lock.staging / name)

    def _stage(self, part: _Part, number: int, content: bytes) -> None:
        """Write a new file into the temporary folder, with the access rights of the old file."""
        waiting = new_file(part.folder, number)
        disk.write_new(waiting, content)
        if self.current.is_file():
            shutil.copymode(self.current, waiting)

    def _is_one_step(self) -> bool:
        changes = [(part, change) for part in self.parts for change in part.changes.values()]
        (part, change), *more = changes
        return (
            not more and change.content is not None and (part.folder / change.name).parent.is_dir()
        )

    def _place_one(self) -> None:
        (part,) = self.parts
        (change,) = part.changes.values()
        target = part.folder / change.name
        disk.move(new_file(part.folder, 0), target)
        with suppress(OSError):  # it is done
            disk.sync_folder(target.parent)
        self._clear()

    def _begin(self) -> None:
        """Write the journals, that of the first folder last. After that, the next command undoes
        the change if this one is interrupted.
        """
        key = os.urandom(8).hex()
        first, *others = self.parts
        self.sets = [
            (
                part.folder,
                Journal(
                    key=key,
                    entries=tuple(_entry(part, change) for change in part.changes.values()),
                    made=_missing(part),
                    parts=tuple(relative(other.folder, first.folder) for other in others)
                    if part is first
                    else (),
                    first="" if part is first else relative(first.folder, part.folder),
                ),
            )
            for part in self.parts
        ]
        for folder in (
            *(made.parent for made in self.above),
            *(part.folder for part in self.parts),
        ):
            disk.sync_folder(folder)
        for folder, journal in reversed(self.sets):
            put_journal(folder, journal)

    def _move(self) -> None:
        """Move all old files to the temporary folders, then the new files to their places.

        The first step is synced before the second one begins. Otherwise the disk could store the
        changes in another order, and an old file could be lost under a new one.
        """
        for folder, journal in self.sets:
            for number, entry in enumerate(journal.entries):
                if entry.there:
                    self.current = folder / entry.name
                    disk.move(self.current, old_file(folder, number))
        sync_folders(self.sets)
        for folder, journal in self.sets:
            for name in journal.made:
                self.current = folder / name
                self.current.mkdir(exist_ok=True)
            for number, entry in enumerate(journal.entries):
                if entry.digest:
                    self.current = folder / entry.name
                    disk.move(new_file(folder, number), self.current)

    def _finish(self) -> None:
        """Complete the change by removing the journal, after all else is on the disk."""
        sync_folders(self.sets)
        first, _ = self.sets[0]
        (first / UNFINISHED / JOURNAL).unlink()
        with suppress(OSError):  # it is done; what is left waits for the next command then
            disk.sync_folder(first / UNFINISHED)
            self._clear()

    def _clear(self) -> None:
        """Remove the temporary folders. A folder that cannot be removed now is removed by the next
        command.
        """
        for lock in self.locks:
            with suppress(OSError):
                clear(lock)

    def _take_back(self) -> tuple[Fault, ...]:
        """Undo the changes. Return faults if that is impossible."""
        try:
            if self.sets and os.path.lexists(self.sets[0][0] / UNFINISHED / JOURNAL):
                withdraw(self.sets)
        except (OSError, NotPutRightError) as error:
            left = Fault(
                message=(
                    "the earlier files are only partly restored; the next command that "
                    "reads this folder restores the rest"
                ),
                file=str(self.sets[0][0]),
                found=reason(error) if isinstance(error, OSError) else str(error),
                hint="run the command again",
            )
            return (left,)
        self._clear()
        for folder in reversed(self.above):
            with suppress(OSError):
                folder.rmdir()
        return ()


def _entry(part: _Part, change: _Change) -> JournalEntry:
    target = part.folder / change.name
    earlier = ""
    with suppress(OSError):  # not there, or not to be read
        earlier = digest_at(target)
    return JournalEntry(
        name=change.name,
        there=os.path.lexists(target),
        digest="" if change.content is None else digest_of(change.content),
        earlier=earlier,
    )


def _missing(part: _Part) -> tuple[str, ...]:
    """Return the folders that must be made for the changes, outermost first."""
    found: dict[str, None] = {}
    for change in part.changes.values():
        above = (part.folder / change.name).relative_to(part.folder).parents
        for folder in reversed(list(above)[:-1]):
            if not (part.folder / folder).exists():
                found[folder.as_posix()] = None
    return tuple(found)
