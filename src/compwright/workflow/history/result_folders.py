"""Read result folders: their records, and whether their files are unchanged."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from compwright.documents.json_text import no_number
from compwright.documents.older_record import older_record
from compwright.documents.record import RECORD, is_as_written, read_record
from compwright.documents.record_reading import faults_of_record
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.input_sizes import JSON
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.workflow.results.scatter import errors_of

#: What tells a result folder; without a record, of an older version.
_DOCUMENTS = ("evaluation.json", "plan.json", "verification.json")
_MARKS = (RECORD, "plan.json", "verification.json")
#: Folders of a result folder that hold copies, no results of their own.
_NO_RESULTS = frozenset({"inputs", "tables", "rollback", "card", "proven"})
_CHANGED = (
    f"{RECORD} was changed after it was written, so its values and dates may be wrong. Make the"
    " results again with `compwright run`, then `compwright verify`"
)


@dataclass(frozen=True, slots=True)
class ResultFolder:
    """A result folder: its record, the notes about it, those of its files that were changed or are
    missing, and the names of all its files.
    """

    path: Path
    record: Mapping[str, Any]
    notes: tuple[str, ...]
    files: tuple[tuple[str, str], ...]
    names: tuple[str, ...]


def result_folders(session: Session, tops: Sequence[Path]) -> tuple[list[Path], list[Fault]]:
    """Return the result folders below ``tops`` (each once), and a fault for each folder that cannot
    be read or has no results.
    """
    found: dict[Path, Path] = {}
    faults: list[Fault] = []
    for top in tops:
        try:
            folders, refused = storage.folders_holding(session, top, _MARKS)
        except InputError as error:
            faults.extend(error.faults)
            continue
        faults.extend(refused)
        known = frozenset(folders)
        own = [folder for folder in folders if not _is_part(folder, known)]
        if not own and not refused:
            faults.append(
                Fault(
                    message="the folder contains no results of compwright",
                    file=shown_path(top),
                    expected=f"a folder that run or verify wrote (with {RECORD}), or a folder "
                    "above it",
                    hint="give a folder that `compwright run` or `verify` wrote",
                )
            )
        for folder in own:
            found.setdefault(storage.resolved(folder), folder)
    return list(found.values()), faults


def _is_part(folder: Path, folders: Collection[Path]) -> bool:
    """Return whether a folder is inside another result folder and belongs to it, such as the folder
    of its input copies.
    """
    way = (folder, *folder.parents)
    return any(above in folders and below.name in _NO_RESULTS for below, above in pairwise(way))


def read_folder(session: Session, path: Path) -> ResultFolder:
    """Read a result folder. Raises InputError for a damaged record or document."""
    file = path / RECORD
    if not storage.is_there(session, file):
        return _read_older(session, path)
    record = read_record(storage.read_bytes(session, file, JSON), shown_path(file))
    expected = _expected(record)
    return ResultFolder(
        path=path,
        record=record,
        notes=() if is_as_written(record) else (_CHANGED,),
        files=tuple(_not_as_written(session, path, expected)),
        names=(RECORD, *expected),
    )


def _expected(record: Mapping[str, Any]) -> dict[str, str]:
    """Return the files that a record lists, with the SHA-256 of each."""
    listed = {str(entry["file"]): str(entry["sha256"]) for entry in record["files"]}
    inputs = {
        str(entry["copy"]): str(entry["sha256"])
        for entry in record["inputs"]
        if entry["copy"] is not None
    }
    return inputs | listed


def _not_as_written(
    session: Session, path: Path, expected: Mapping[str, str]
) -> Iterator[tuple[str, str]]:
    for name, digest in expected.items():
        place = path / name
        try:
            same = fingerprint(storage.read_bytes(session, place)) == digest
        except InputError:
            yield name, "unreadable" if storage.is_there(session, place) else "missing"
            continue
        if not same:
            yield name, "changed"


def _read_older(session: Session, path: Path) -> ResultFolder:
    documents = {name: _document(session, path / name) for name in _DOCUMENTS}
    try:
        record = older_record(
            documents["evaluation.json"],
            documents["plan.json"],
            documents["verification.json"],
            errors_of,
        )
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        raise _misfit(path, error) from error
    raise_all(InputError, [fault.in_file(shown_path(path)) for fault in faults_of_record(record)])
    missing = [name for name, document in documents.items() if document is None]
    without_record = "has no record (an older version): the files in it are not checked"
    without = f", and {' and '.join(missing)} not there" if missing else ""
    return ResultFolder(path, record, (f"{without_record}{without}",), (), _DOCUMENTS)


def _document(session: Session, path: Path) -> Mapping[str, Any] | None:
    """Return a JSON document of any version, or None if there is no file. Raises InputError."""
    if not storage.is_there(session, path):
        return None
    try:
        text = storage.read_bytes(session, path, JSON).decode("utf-8")
        data = json.loads(text, parse_constant=no_number)
    except (ValueError, RecursionError) as error:
        raise InputError(
            Fault(
                message="the file is not JSON",
                file=shown_path(path),
                found=str(error),
                hint="make the results again with `compwright run`",
            )
        ) from error
    if not isinstance(data, dict):
        raise InputError(
            Fault(
                message="the file is not a results file of compwright",
                file=shown_path(path),
                found=str(data),
                hint="make the results again with `compwright run`",
            )
        )
    return data


def _misfit(path: Path, error: Exception) -> InputError:
    lacking = isinstance(error, KeyError)
    return InputError(
        Fault(
            message="the results file lacks a key"
            if lacking
            else "the results file has a wrong form",
            file=shown_path(path),
            expected=str(error.args[0]) if lacking else "",
            found="" if lacking else str(error),
            hint="make the results again with `compwright run`",
        )
    )
