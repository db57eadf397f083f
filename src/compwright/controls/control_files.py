"""Find and read the files of a control that the user names, or the files in a folder."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from compwright.controls.control import Control
from compwright.controls.other_controls import refuse_other_control
from compwright.documents.record import RECORD
from compwright.formats.definition.schema import Definition
from compwright.formats.text.container import is_container
from compwright.formats.text.other_files import holds_no_data
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.input_sizes import (
    CONTROL,
    IN_FOLDER,
    MOST_CONTROL_TEXT,
    MOST_CONTROL_TEXTS,
    MOST_DIGITS,
    in_words,
)
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from compwright.records.serial_line import from_line

#: Every digit as 0, every other byte as a blank.
_DIGITS = bytes(ord("0") if chr(byte) in "0123456789" else ord(" ") for byte in range(256))
#: Results of a run; its tables are in folders below (``tables/<format>/``).
_RESULTS = ("plan.json", RECORD)
_TABLES = "tables"
_DEEPEST = 3


def holds_archive(files: Sequence[ControlFile]) -> bool:
    """Return whether one of the files is an archive, which contains other files."""
    return any(map(is_container, files))


def read_control(
    session: Session, control: Control, paths: Sequence[Path]
) -> tuple[ControlFile, ...]:
    """Read the files of a control. Raises InputError if they belong to another control."""
    files = read_files(session, paths)
    refuse_other_control(session, control.definition, files, control.origin.format_place)
    return files


def read_files(session: Session, paths: Sequence[Path]) -> tuple[ControlFile, ...]:
    """Read control files. A folder means all files in it. Raises InputError with every unreadable
    file.
    """
    faults: list[Fault] = []
    files: list[ControlFile] = []
    for path in paths:
        try:
            entries = control_entries(session, path)
            own = entries == [path]
            folder, kind = ("", CONTROL) if own else (str(entries[0].parent), IN_FOLDER)
            files.extend(
                from_line(entry.name, storage.read_bytes(session, entry, kind), folder)
                for entry in entries
            )
        except InputError as error:
            faults.extend(error.faults)
    faults.extend(
        Fault(
            message="two of the control's files have this name",
            file=name,
            expected="each file once",
            hint="give each file once, or rename one of them",
        )
        for name, times in Counter(file.name for file in files).items()
        if times > 1
    )
    faults.extend(filter(None, map(_long_text, files)))
    faults.extend(_long_together(files))
    faults.extend(filter(None, map(_endless_number, files)))
    raise_all(InputError, faults)
    return tuple(files)


def files_for_job(
    session: Session, definition: Definition, files: Sequence[Path]
) -> tuple[list[Path], tuple[str, ...]]:
    """Return the files that a job uses, and a message for each file in a folder that is ignored
    because it has no data of this control.

    ``files``: files and folders. A file in ``files`` is always used. If all files of a folder are
    used, or none has data, the folder itself is returned.
    """
    taken: list[Path] = []
    aside: list[Path] = []
    for path in files:
        inside = [one for one in storage.list_files(session, path) if one != path]
        read = read_files(session, [path]) if inside else ()
        others = {file.name for file in read if holds_no_data(definition, file)}
        left = [one for one in inside if one.name in others]
        whole = not left or len(left) == len(inside)
        taken += [path] if whole else [one for one in inside if one not in left]
        aside += [] if whole else left
    return taken, tuple(
        f"{path} is left aside: no line of it is a statement of {definition.id}" for path in aside
    )


def control_entries(session: Session, path: Path) -> list[Path]:
    """Return ``[path]`` for a file, and for a folder its files.

    If a folder contains only one folder with files, the files of that folder are returned. Raises
    InputError for a folder of results, for a folder with several such folders, and for a folder
    without files.
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


def _endless_number(file: ControlFile) -> Fault | None:
    """Return the fault of a file that contains a number too long for any control."""
    place = file.content.translate(_DIGITS).find(b"0" * (MOST_DIGITS + 1))
    if place < 0:
        return None
    line = 1 + file.content.count(b"\n", 0, place)
    return Fault(
        message="this line contains a number with too many digits",
        file=file.name,
        place=f"line {line}",
        expected=f"at most {MOST_DIGITS} digits",
        found=f"more than {MOST_DIGITS}",
        hint=(
            "correct this number in a copy of the file, or export the file from the control again"
        ),
    )


def _long_text(file: ControlFile) -> Fault | None:
    """Return the fault of a text file (no archive) that is longer than any control's text."""
    if len(file.content) <= MOST_CONTROL_TEXT or is_container(file):
        return None
    return Fault(
        message="the file is too large",
        file=file.name,
        expected=f"a file of at most {in_words(MOST_CONTROL_TEXT)}",
        found=in_words(len(file.content)),
        hint="split the file, or give only the part with the compensation data",
    )


def _long_together(files: Sequence[ControlFile]) -> Iterator[Fault]:
    """Yield a fault for texts that are together longer than all texts of any control."""
    sizes = [len(file.content) for file in files if not is_container(file)]
    if sum(sizes) > MOST_CONTROL_TEXTS:
        yield Fault(
            message="the control's files are too large",
            expected=f"at most {in_words(MOST_CONTROL_TEXTS)} in all files together",
            found=f"{len(sizes)} files of {in_words(sum(sizes))}",
            hint="give only the files with compensation data and axis parameters",
        )
