"""Restore files after an interrupted command, at the next command that uses the folder.

As long as the journal exists, the old files are valid. First all new files are removed, then the
old files are put back, then the journal is removed. So a folder never shows old and new files
together. Each step can be repeated, so a recovery may be interrupted too.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, suppress
from itertools import chain, takewhile
from pathlib import Path

from compwright.foundations.errors import CompwrightError, Fault
from compwright.foundations.session import Session
from compwright.foundations.storage import disk
from compwright.foundations.storage.file_status import reason, resolved
from compwright.foundations.storage.journal import (
    JOURNAL,
    UNFINISHED,
    DamagedError,
    Journal,
    digest_at,
    is_new,
    is_ours,
    new_file,
    old_file,
    read_journal,
)
from compwright.foundations.storage.locking import PATIENCE, Lock, take

#: A folder with its journal.
Set = tuple[Path, Journal]


class NotPutRightError(Exception):
    """Raised if the files of an interrupted command cannot be restored, with the faults."""

    def __init__(self, *faults: Fault) -> None:
        super().__init__("\n".join(map(str, faults)))
        self.faults = faults


# ---------------------------------------------------------------- whoever reads or writes next


def put_right_above(session: Session, path: Path, error: type[CompwrightError]) -> None:
    """Restore the files of interrupted processes in the folder of ``path`` and its parents, once
    per session. If that is impossible for ``path``, raise an error of the class ``error``.

    The error is raised only if ``path`` is a file that would have to be restored, or a folder that
    directly contains such a file.
    """
    folder = os.path.dirname(os.path.abspath(path))  # noqa: PTH100, PTH120 - for every file read
    if folder not in session.searched:
        for above in _not_searched(session, Path(folder)):
            if os.path.lexists(above / UNFINISHED):
                _put_right(session, above)
            session.searched.add(str(above))
    for left, faults in session.unrestored.items():
        if _concerns(Path(left), path):
            raise error(
                Fault(
                    message="a stopped command left this file unfinished",
                    file=str(path),
                    hint=faults[0].hint,
                ),
                *faults,
            )


def put_right_in(session: Session, folder: Path, error: type[CompwrightError]) -> None:
    """Restore the files of interrupted processes in ``folder`` itself and in its parents, as
    `put_right_above` does. If that is impossible, raise an error of the class ``error``.
    """
    put_right_above(session, folder / UNFINISHED, error)
    put_right_above(session, folder, error)


def _not_searched(session: Session, folder: Path) -> list[Path]:
    """Return ``folder`` and its parents that the session has not yet searched, outermost first."""
    found: list[Path] = []
    for way in (folder, resolved(folder)):
        inner = takewhile(lambda path: str(path) not in session.searched, chain([way], way.parents))
        found.extend(reversed(list(inner)))
    return list(dict.fromkeys(found))


def _put_right(session: Session, folder: Path) -> None:
    """Undo the interrupted change in a folder, or record why that is impossible."""
    if str(folder) in session.unrestored:
        return
    try:
        _take_back(session, folder)
    except NotPutRightError as left:
        session.unrestored[str(folder)] = left.faults
    except (OSError, DamagedError) as error:
        if not os.path.lexists(folder / UNFINISHED):  # another process has done it meanwhile
            return
        fault = Fault(
            message="the unfinished files of a stopped command cannot be removed",
            file=str(folder / UNFINISHED),
            found=reason(error) if isinstance(error, OSError) else str(error),
            hint=(
                "check the permissions of the folder, then run the command again"
                if isinstance(error, OSError)
                else "see `Stopped while writing` in docs/commands.md: put the files `0.old` and on"
                " of this folder back by hand, then remove it"
            ),
        )
        session.unrestored[str(folder)] = (fault,)


def _concerns(folder: Path, path: Path) -> bool:
    """Return whether the unfinished change in ``folder`` affects ``path``. If the journal of the
    change is unreadable, every path inside the folder is affected.
    """
    real, root = resolved(path.parent) / path.name, resolved(folder)
    try:
        journal = read_journal(folder)
    except (OSError, DamagedError):
        return root in (real, *real.parents)
    named = {root.joinpath(entry.name) for entry in journal.entries} if journal else set()
    return real in named or real in {file.parent for file in named}


# ---------------------------------------------------------------- one folder, or several as one


def _take_back(session: Session, folder: Path) -> None:
    journal = read_journal(folder)
    if journal is None:
        _sweep(folder)
    elif journal.first:
        _take_back_part(session, folder, journal)
    else:
        _take_back_first(session, folder)


def _sweep(folder: Path) -> None:
    """Remove temporary files that belong to no journal, except those of a running process.

    Such files were prepared but not used, or were left after a completed change. Files that cannot
    be removed stay, because they do no harm.
    """
    with suppress(OSError):
        lock = take(folder / UNFINISHED, patience=0.0)
        try:
            if read_journal(folder) is None:
                clear(lock)
        finally:
            lock.release()


def _take_back_first(session: Session, folder: Path) -> None:
    with ExitStack() as held:
        first = _held(folder, held)
        journal = read_journal(folder)
        if journal is None:  # a living process has finished meanwhile
            clear(first)
            return
        others = [(other, theirs, _held(other, held)) for other, theirs in _parts(folder, journal)]
        withdraw([(folder, journal), *((other, theirs) for other, theirs, _ in others)])
        for lock in (*(lock for *_, lock in others), first):
            with suppress(OSError):
                clear(lock)
    session.restored.append(str(folder))


def _held(folder: Path, held: ExitStack) -> Lock:
    lock = take(folder / UNFINISHED, patience=PATIENCE)
    held.callback(lock.release)
    return lock


def _parts(folder: Path, journal: Journal) -> Iterator[Set]:
    """Yield each further folder that takes part in the change of files of this ``journal``, with
    the journal in that folder.
    """
    for name in journal.parts:
        other = _from(folder, name)
        theirs = read_journal(other)
        if theirs is None or theirs.key != journal.key or not theirs.first:
            continue
        if resolved(_from(other, theirs.first)) == resolved(folder):
            yield other, theirs


def _from(folder: Path, name: str) -> Path:
    return Path(os.path.normpath(folder / name))


def _take_back_part(session: Session, folder: Path, journal: Journal) -> None:
    first = _from(folder, journal.first)
    if not first.is_dir():
        raise NotPutRightError(
            Fault(
                message=(
                    "a command was stopped while it wrote here, and the folder with the "
                    "list of its files is missing"
                ),
                file=str(folder / UNFINISHED),
                expected=f"the folder {first}, or no file {UNFINISHED}",
                hint=(
                    f"put the folder {first} back, or remove {folder / UNFINISHED} (the other "
                    "files then stay as they are)"
                ),
            )
        )
    if _decides(first, journal):
        _take_back_undone(session, first, folder, journal)
    elif not _is_swept(first, folder, journal):
        _take_back_part(session, folder, journal)


def _take_back_undone(session: Session, first: Path, folder: Path, journal: Journal) -> None:
    """Undo an incomplete change of files in several folders. ``first``: the folder with the main
    journal of the change.

    If the main journal does not list ``folder``, this is a copy of one of the folders. Its change
    is then undone first, separately.
    """
    deciding = read_journal(first)
    known = () if deciding is None else tuple(_parts(first, deciding))
    if resolved(folder) not in (resolved(other) for other, _ in known):
        with ExitStack() as held:
            lock = _held(folder, held)
            withdraw([(folder, journal)])
            clear(lock)
        session.restored.append(str(folder))
    _take_back_first(session, first)


def _is_swept(first: Path, folder: Path, journal: Journal) -> bool:
    """Remove the temporary files of a completed change and return True; return False, and remove
    nothing, if the change was not completed.
    """
    try:
        with ExitStack() as held:
            lock = _held(folder, held)
            if _decides(first, journal):
                return False
            clear(lock)
    except TimeoutError:
        raise
    except OSError:  # another process has done it, or the folder is read-only: done either way
        pass
    return True


def _decides(first: Path, journal: Journal) -> bool:
    """Return whether a change is incomplete: the folder ``first`` still has its main journal."""
    theirs = read_journal(first)
    return theirs is not None and theirs.key == journal.key


def clear(lock: Lock) -> None:
    """Remove a temporary folder and compwright's files in it. Nothing is done if its lock is
    already released. Raises OSError.
    """
    if lock.handle < 0:
        return
    for name in os.listdir(lock.staging):  # noqa: PTH208 - names, no paths
        if is_ours(name):
            disk.remove(lock.staging / name)
    lock.remove()


# ---------------------------------------------------------------- files


def withdraw(sets: Sequence[Set]) -> None:
    """Undo a change of files in several folders: restore their old files, then remove the journals.
    ``sets``: the folders, each with its journal.

    Raises NotPutRightError, before anything is changed, if a file was changed since or an old file
    is missing. Raises OSError.
    """
    faults = [
        fault
        for folder, journal in sets
        for fault in (*_changed_since(folder, journal), *_lost_since(folder, journal))
    ]
    if faults:
        raise NotPutRightError(*faults)
    for folder, journal in sets:
        _remove_new(folder, journal)
    for folder, journal in sets:
        _restore_old(folder, journal)
    sync_folders(sets)
    for folder, journal in sets:
        for name in reversed(journal.made):
            with suppress(OSError):  # the user has put something there
                (folder / name).rmdir()
    first, _ = sets[0]
    (first / UNFINISHED / JOURNAL).unlink()


def sync_folders(sets: Sequence[Set]) -> None:
    """Wait until all file names changed by journals are stored on the disk. ``sets``: the folders,
    each with its journal. Raises OSError.
    """
    touched = [
        path
        for folder, journal in sets
        for path in (
            folder / UNFINISHED,
            folder,
            *((folder / name).parent for name in journal.made),
            *((folder / entry.name).parent for entry in journal.entries),
        )
    ]
    for path in dict.fromkeys(touched):
        if path.is_dir():
            disk.sync_folder(path)


def _changed_since(folder: Path, journal: Journal) -> Iterator[Fault]:
    """Yield a fault for each file whose contents are neither those before nor those after the
    interrupted change.
    """
    for number, entry in enumerate(journal.entries):
        target = folder / entry.name
        kept = os.path.lexists(old_file(folder, number))
        in_question = kept or (not entry.there and _is_placed(folder, number, journal))
        if not in_question or not os.path.lexists(target):
            continue
        if not (_is_placed(folder, number, journal) and is_new(target, entry)):
            yield Fault(
                message="the file was changed after a command had stopped while writing it",
                file=str(target),
                hint="move the file to another folder, then run the command again",
            )


def _lost_since(folder: Path, journal: Journal) -> Iterator[Fault]:
    """Yield a fault for each old file (kept in the temporary folder until the change is complete)
    that is now missing or damaged.

    This happens in a folder that is being copied or synchronised: its files arrive one by one, and
    some may be missing.
    """
    for number, entry in enumerate(journal.entries):
        target, kept = folder / entry.name, old_file(folder, number)
        if not entry.there:
            continue
        if os.path.lexists(kept):
            if entry.earlier and digest_at(kept) != entry.earlier:
                yield _lost("is damaged", target, folder)
        elif not os.path.lexists(target) or (
            entry.earlier
            and entry.earlier != entry.digest
            and _is_placed(folder, number, journal)
            and is_new(target, entry)
        ):
            yield _lost("is missing", target, folder)


def _lost(what: str, target: Path, folder: Path) -> Fault:
    return Fault(
        message="a command was stopped after it had moved the earlier file away, and the moved "
        f"file {what}",
        file=str(target),
        hint=(
            "copy the folder again as a whole with hidden files, or remove "
            f"{folder / UNFINISHED} (old and new files then stay as they are)"
        ),
    )


def _is_placed(folder: Path, number: int, journal: Journal) -> bool:
    """Return whether the new file of the journal entry ``number`` was already moved from the
    temporary folder to its place.
    """
    return bool(journal.entries[number].digest) and not os.path.lexists(new_file(folder, number))


def _remove_new(folder: Path, journal: Journal) -> None:
    for number, entry in enumerate(journal.entries):
        kept = os.path.lexists(old_file(folder, number))
        if _is_placed(folder, number, journal) and (kept or not entry.there):
            disk.remove(folder / entry.name)


def _restore_old(folder: Path, journal: Journal) -> None:
    for number, entry in enumerate(journal.entries):
        if os.path.lexists(old_file(folder, number)):
            disk.move(old_file(folder, number), folder / entry.name)
