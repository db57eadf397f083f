"""The journal of planned file changes; with it, the next command restores an interrupted change.

While files are written, each folder contains a temporary folder `UNFINISHED`. This contains the
lock, the new files (``0.new``, ``1.new``, ..), the old files (``0.old``, ..) and the journal. The
number of a file is its index in the journal's list. The journal of the first folder decides for all
folders: as long as it exists, the old files are valid. The journals of the other folders name the
first folder.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from compwright.foundations.storage import disk

#: The name of that folder, chosen so that a user recognises it.
UNFINISHED = ".compwright-unfinished"
JOURNAL = "journal.json"
_PART = "journal.part"
_FORM = "compwright/unfinished/1"
_MOST_BYTES = 16 * 1024 * 1024  # of a journal: 50 000 files


class DamagedError(Exception):
    """Raised if a journal cannot be used, with the reason as text."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JournalEntry:
    """A file that the change writes (``digest``: SHA-256 of the new bytes), or removes if it has no
    ``digest``.

    - ``name``: the path below the folder, with ``/``.
    - ``there``: whether something existed under this name before.
    - ``earlier``: SHA-256 of the old bytes; empty if it was no file or could not be read.
    """

    name: str
    there: bool
    digest: str = ""
    earlier: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Journal:
    """The planned changes of the files in one folder.

    - ``made``: folders below it that are created for the change.
    - ``parts``: in the journal that decides, the paths of the other folders of the change.
    - ``first``: in the other journals, the path of the folder whose journal decides.

    All paths are relative to this folder.
    """

    key: str
    entries: tuple[JournalEntry, ...]
    made: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()
    first: str = ""


def new_file(folder: Path, number: int) -> Path:
    """Return the temporary path of the new file for the journal entry ``number``."""
    return folder / UNFINISHED / f"{number}.new"


def old_file(folder: Path, number: int) -> Path:
    """Return the temporary path of the old file for the journal entry ``number``."""
    return folder / UNFINISHED / f"{number}.old"


def is_ours(name: str) -> bool:
    """Return whether a file in the temporary folder has one of the names that compwright gives to
    its files there.
    """
    number, _, kind = name.partition(".")
    return name in (JOURNAL, _PART) or (number.isdecimal() and kind in ("new", "old"))


def digest_of(content: bytes) -> str:
    """Return the SHA-256 hash that identifies a new file."""
    return hashlib.sha256(content).hexdigest()


def digest_at(path: Path) -> str:
    """Return the SHA-256 of a file, "" if it is not an ordinary file. Raises OSError."""
    if not stat.S_ISREG(path.lstat().st_mode):
        return ""
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def is_new(path: Path, entry: JournalEntry) -> bool:
    """Return whether the file at ``path`` has the new contents of ``entry``. Raises OSError."""
    return digest_at(path) == entry.digest != ""


def put_journal(folder: Path, journal: Journal) -> None:
    """Put a journal in its place with one rename, and wait until it is on the disk. Raises
    OSError.
    """
    staging = folder / UNFINISHED
    disk.write_new(staging / _PART, _text(journal).encode("ascii"))
    disk.move(staging / _PART, staging / JOURNAL)
    disk.sync_folder(staging)


def read_journal(folder: Path) -> Journal | None:
    """Return the journal of a folder, or None if there is no journal.

    Raises DamagedError if the journal is damaged or names files outside of the folder. Raises
    OSError if it cannot be read.
    """
    staging = folder / UNFINISHED
    try:
        if not stat.S_ISDIR(staging.lstat().st_mode):
            raise DamagedError("is not a folder")
        seen = (staging / JOURNAL).lstat()
        if not stat.S_ISREG(seen.st_mode) or seen.st_size > _MOST_BYTES:
            raise DamagedError("its journal is not a file that compwright has written")
        content = (staging / JOURNAL).read_bytes()
    except FileNotFoundError:
        if _has_both(staging) and not os.path.lexists(staging / JOURNAL) and _has_both(staging):
            raise DamagedError("its journal is missing") from None
        return None
    journal = _read(content)
    for name in (*(entry.name for entry in journal.entries), *journal.made):
        if not _is_inside(folder, name):
            raise DamagedError(f"its journal names a file outside of the folder: {name}")
    return journal


def _has_both(staging: Path) -> bool:
    """Return whether the temporary folder contains both old and new files.

    This is possible only while there is a journal. If there is none, the folder is an incomplete
    copy.
    """
    try:
        kinds = {name.partition(".")[2] for name in os.listdir(staging) if is_ours(name)}  # noqa: PTH208
    except OSError:
        return False
    return {"old", "new"} <= kinds


def _text(journal: Journal) -> str:
    data = {
        "form": _FORM,
        "key": journal.key,
        "files": [
            [entry.name, entry.there, entry.digest, entry.earlier] for entry in journal.entries
        ],
        "made": list(journal.made),
        "parts": list(journal.parts),
        "first": journal.first,
    }
    return json.dumps({**data, "sha256": _checksum(data)}, indent=1)


def _checksum(data: dict[str, Any]) -> str:
    return digest_of(json.dumps(data, sort_keys=True).encode("ascii"))


def _read(content: bytes) -> Journal:
    try:
        data = json.loads(content)
        checksum = data.pop("sha256")
        if data["form"] != _FORM:
            raise DamagedError("its journal is of another version of compwright")
        if checksum != _checksum(data):
            raise DamagedError("its journal is damaged")
        entries = tuple(
            JournalEntry(
                name=str(name), there=bool(there), digest=str(digest), earlier=str(earlier)
            )
            for name, there, digest, earlier in data["files"]
        )
        return Journal(
            key=str(data["key"]),
            entries=entries,
            made=tuple(map(str, data["made"])),
            parts=tuple(map(str, data["parts"])),
            first=str(data["first"]),
        )
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise DamagedError("its journal is damaged") from error


def _is_inside(folder: Path, name: str) -> bool:
    """Return whether a name leads to a file inside the folder, but not in the temporary folder."""
    parts = Path(*PurePosixPath(name).parts).parts  # as this system divides it
    if not parts or ".." in parts or UNFINISHED in parts or "\0" in name:
        return False
    if PurePosixPath(name).is_absolute() or Path(name).is_absolute() or Path(name).drive:
        return False
    way = Path(os.path.realpath(folder.joinpath(*parts[:-1])))
    return way.is_relative_to(os.path.realpath(folder))
