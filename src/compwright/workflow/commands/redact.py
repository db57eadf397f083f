"""``redact``: copies of measurement and control files without names, serial numbers and remarks."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Any, Final

from compwright.controls.control_copies import control_copies, texts_in
from compwright.documents.json_text import to_json
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, UsageError
from compwright.foundations.redaction import Cuts, Names
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded, shown_path, visible
from compwright.instruments.profile import Profile
from compwright.instruments.redaction.measurement import holds_table, is_measurement
from compwright.instruments.workbook import is_workbook
from compwright.records.correction import ControlFile
from compwright.workflow.inputs.measurement_files import load_profile
from compwright.workflow.redact.redacted_measurements import measurement_copy
from compwright.workflow.redact.redacted_names import names_of_copies
from compwright.workflow.results.own_files import write_listed
from compwright.workflow.results.single_files import refuse_other_kinds

SCHEMA: Final = "compwright/redaction/1"
#: Before the words that say where texts of a kind stood.
_WHERE: Final = re.compile(r"(?= (?:behind|next to) )")


@dataclass(frozen=True, slots=True, kw_only=True)
class RedactedFile:
    """One copied file: the original, the copy, the kind of file, and for each kind of text how many
    texts were removed.

    ``texts``: the removed texts themselves, for a user who wants to see them.
    """

    file: Path
    copy: Path
    taken_for: str
    removed: dict[str, int]
    texts: tuple[tuple[str, str], ...] = ()
    name: str = ""
    renamed: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class RedactOutcome:
    """The result of ``redact``: the copies, the faults of files that could not be copied, and the
    inner folders that were not searched.
    """

    files: tuple[RedactedFile, ...]
    faults: tuple[Fault, ...]
    written: tuple[Path, ...]
    folders: tuple[Path, ...] = ()

    @property
    def exit_code(self) -> int:
        """The exit code: 0 if all files were copied, else that of an unreadable input."""
        return InputError.exit_code if self.faults else 0

    @property
    def document(self) -> dict[str, Any]:
        """The answer as JSON, without the removed texts."""
        document: dict[str, Any] = {
            "schema": SCHEMA,
            "files": [
                {
                    "file": shown_path(one.file),
                    "copy": shown_path(one.copy),
                    "taken_for": one.taken_for,
                    "removed": one.removed,
                    "renamed": one.renamed,
                }
                for one in self.files
            ],
            "errors": [
                {"file": fault.file, "message": str(replace(fault, file=""))}
                for fault in self.faults
            ],
        }
        if self.folders:
            document["folders"] = [shown_path(path) for path in self.folders]
        return document


@dataclass(slots=True)
class _FileToCopy:
    """One file to copy. ``name``: its name; inside an archive, the archive's name comes first."""

    path: Path
    name: str
    content: bytes
    cuts: Cuts
    copy: bytes = b""
    taken_for: str = ""
    profile: str = ""

    @property
    def shown(self) -> str:
        """The name of the file in messages."""
        inside = self.name.partition("/")[2]
        return f"{shown_path(self.path)}{': ' if inside else ''}{inside}"


def redact_files(
    session: Session,
    paths: Sequence[Path],
    out: Path,
    *,
    profile: Path | None = None,
    format_id: str | None = None,
    json_path: Path | None = None,
    force: bool = False,
) -> RedactOutcome:
    """Write a copy of each file without names into ``out``.

    A copy has the name of its original, unless that name contains a removed text or a possible
    serial number. A file is not copied if its kind is unknown, or if it cannot be proven that its
    copy is clean. Such a file is listed in ``faults``, and the rest is copied.

    Raises UsageError for a wrong profile or control, and for a JSON file in the folder of the
    copies. Raises StorageError if nothing can be written.
    """
    if json_path is not None and storage.resolved(out) in storage.resolved(json_path).parents:
        raise UsageError(
            Fault(
                message=(
                    "the file of `--json` contains the original names, so it must not be in the "
                    "folder of the copies"
                ),
                file=shown_path(json_path),
                expected="a path outside of the folder of the copies",
                hint="give `--json` a path outside of the folder of the copies",
            )
        )
    read_by = load_profile(session, profile) if profile is not None else None
    names, faults = Names(), list[Fault]()
    inputs = _read(session, paths, names, faults)
    _copy(session, inputs, read_by, format_id, faults)
    done = [one for one in inputs if one.taken_for]
    removed = [text for one in done for text in one.cuts.removed]
    files = names_of_copies([one.name for one in done], removed, names)
    outcome = RedactOutcome(
        files=_redacted_files(done, files, out),
        faults=tuple(faults),
        written=(),
        folders=_inner_folders(paths, out),
    )
    contents = {
        name: content
        for one, name in zip(done, files, strict=True)
        for name, content in _of(one, name)
    }
    elsewhere = {} if json_path is None else {json_path: encoded(to_json(outcome.document))}
    refuse_other_kinds(session, elsewhere, force=force, results=[out / name for name in contents])
    if contents:
        written = write_listed(
            session, out, contents, command="redact", force=force, as_set=False, elsewhere=elsewhere
        )
    else:
        written = storage.write_files(session, out, {}, elsewhere=elsewhere, force=force)
    return replace(outcome, written=tuple(written))


def _inner_folders(paths: Sequence[Path], out: Path) -> tuple[Path, ...]:
    """Return the folders inside the given folders, except the folder of the copies."""
    known = {storage.resolved(path) for path in (*paths, out)}
    inner = dict.fromkeys(one for path in paths for one in storage.folders_in(path))
    return tuple(one for one in inner if storage.resolved(one) not in known)


def _read(
    session: Session, paths: Sequence[Path], names: Names, faults: list[Fault]
) -> list[_FileToCopy]:
    """Return the files to copy, and in place of an archive the text files in it. Two files with the
    same name are a fault.

    A file that is given twice is copied once.
    """
    inputs: dict[str, _FileToCopy] = {}
    for entry in _entries(session, paths, faults):
        try:
            found = _inputs(session, entry, names)
        except InputError as error:
            faults.extend(fault.in_file(shown_path(entry)) for fault in error.faults)
            continue
        twice = [one for one in found if inputs.setdefault(one.name.casefold(), one) is not one]
        faults.extend(
            Fault(
                message=("two files have this name, so one copy would overwrite the other"),
                file=one.shown,
                hint="copy this file with a command of its own and another `--out`",
            )
            for one in twice
        )
    return list(inputs.values())


def _entries(session: Session, paths: Sequence[Path], faults: list[Fault]) -> list[Path]:
    """Return the files in ``paths``, each once."""
    entries: dict[Path, Path] = {}
    for path in paths:
        try:
            for entry in storage.list_files(session, path):
                entries.setdefault(storage.resolved(entry.parent) / entry.name, entry)
        except InputError as error:
            faults.extend(fault.in_file(shown_path(path)) for fault in error.faults)
    return list(entries.values())


def _inputs(session: Session, path: Path, names: Names) -> list[_FileToCopy]:
    content = storage.read_bytes(session, path)
    texts = texts_in(ControlFile(path.name, content)) or (ControlFile(path.name, content),)
    return [_FileToCopy(path, text.name, text.content, Cuts(names)) for text in texts]


def _copy(
    session: Session,
    inputs: Sequence[_FileToCopy],
    profile: Profile | None,
    format_id: str | None,
    faults: list[Fault],
) -> None:
    """Copy each measurement file by itself and all control files together. Files of unknown kind
    are copied as tables, by a proposed mapping profile.
    """
    others: list[_FileToCopy] = []
    for one in inputs:
        if format_id is None and is_measurement(one.content, one.name, profile):
            _measurement(one, profile, faults)
        else:
            others.append(one)
    files = [ControlFile(one.name, one.content) for one in others]
    copies = control_copies(session, files, {one.name: one.cuts for one in others}, format_id)
    for one in others:
        copy = copies.made.get(one.name)
        if copy is not None:
            one.copy, one.taken_for = copy.content, "control file"
            continue
        one.cuts.removed.clear()
        why: list[Fault] = []
        if format_id is None and one.name in copies.unknown and _measurement(one, profile, why):
            continue
        refused = [fault for fault in copies.faults if fault.file == one.name]
        if why and holds_table(one.content, one.name):
            refused = why
        faults.extend(replace(fault, file=one.shown) for fault in refused)


def _measurement(one: _FileToCopy, profile: Profile | None, faults: list[Fault]) -> bool:
    try:
        made = measurement_copy(one.content, one.shown, one.cuts, profile)
    except CompwrightError as error:
        one.cuts.removed.clear()
        faults.extend(error.faults)
        return False
    one.copy, one.profile, one.taken_for = made.content, made.profile, "measurement"
    if is_workbook(made.content):  # without its programs it is another kind of workbook
        one.name = str(PurePath(one.name).with_suffix(".xlsx"))
    return True


def _of(one: _FileToCopy, name: str) -> list[tuple[str, bytes]]:
    copies = [(name, one.copy)]
    if one.profile:
        copies.append((f"{PurePath(name).with_suffix('')}.profile.yaml", encoded(one.profile)))
    return copies


def _redacted_files(
    inputs: Sequence[_FileToCopy], names: Sequence[str], out: Path
) -> tuple[RedactedFile, ...]:
    return tuple(
        RedactedFile(
            file=one.path,
            copy=out / name,
            taken_for=one.taken_for,
            removed=one.cuts.counts(),
            texts=tuple(one.cuts.removed),
            name=one.name,
            renamed=name != one.name,
        )
        for one, name in zip(inputs, names, strict=True)
    )


def _counted(count: int, kind: str) -> str:
    """Return a number of removed texts of one kind as words: "1 comment", "3 rows next to the
    table".
    """
    noun, *where = _WHERE.split(kind, maxsplit=1)
    return f"{count} {noun}{'s' * (count != 1)}{''.join(where)}"


def redaction_lines(outcome: RedactOutcome, *, show: bool = False) -> list[str]:
    """Return lines of text about the copies, with the number of removed texts. ``show``: list the
    removed texts themselves too.
    """
    lines = []
    for one in outcome.files:
        counts = ", ".join(_counted(count, kind) for kind, count in one.removed.items())
        lines.append(f"{one.copy}: as {one.taken_for}; taken out: {counts or 'nothing'}")
        if one.renamed:
            lines.append(f"  not named {one.name}: that holds such a text, or a long number")
        if show:
            lines += [f"  {kind}: {visible(text)}" for kind, text in dict.fromkeys(one.texts)]
    if outcome.files:
        lines.append(
            "Look at the names of the copies, and at the copies, before you send them: dates, names"
            " of axes and all numbers that are read are still in them."
        )
    return lines
