"""The files of a control in a folder that somebody names."""

from __future__ import annotations

from pathlib import Path

from compwright.documents.record import RECORD
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import CONTROL
from compwright.foundations.session import Session

#: Results of a run; its tables are in folders below (``tables/<format>/``).
_RESULTS = ("plan.json", RECORD)
_TABLES = "tables"
_DEEPEST = 3


def control_entries(session: Session, path: Path) -> list[Path]:
    """Return ``[path]`` for a file, and for a folder its files; of one without files those of the
    only folder below it that has some.

    Raises InputError for a folder of results, for several such folders, and for none.
    """
    entries = _entries(session, path, _DEEPEST)
    if not entries:  # nothing to read is not "nothing is active": that is the word none
        raise _fault(path, "the folder contains no files", CONTROL.help)
    return entries


def _entries(session: Session, path: Path, deepest: int) -> list[Path]:
    entries = storage.list_files(session, path)
    if entries == [path]:
        return entries
    if any(entry.name in _RESULTS for entry in entries):
        below = [str(folder) for folder in storage.folders_in(path / _TABLES)]
        raise _fault(path, "this is a folder of results", " or ".join(below) or CONTROL.help)
    if entries or deepest == 0:
        return entries
    found = [
        files
        for folder in storage.folders_in(path)
        if (files := _entries(session, folder, deepest - 1))
    ]
    if len(found) > 1:
        folders = " or ".join(str(files[0].parent) for files in found)
        raise _fault(path, "contains several folders of files", f"one of them: {folders}")
    return found[0] if found else []


def _fault(path: Path, message: str, wanted: str) -> InputError:
    return InputError(Fault(message=message, file=str(path), hint=f"give {wanted}"))
