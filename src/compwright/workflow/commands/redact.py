"""``redact``: copies of measurement and control files without names, serial numbers and remarks."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Any, Final

from compwright.documents.json_text import to_json
from compwright.formats.text.redaction import LINE
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError
from compwright.foundations.redaction import Cuts, Names, telling
from compwright.foundations.utf8 import encoded, shown_path, visible
from compwright.instruments.profile import Profile
from compwright.instruments.redaction.measurement import ALLOWED, holds_table, is_measurement
from compwright.records.correction import ControlFile
from compwright.workflow.stages.measurement_files import load_profile
from compwright.workflow.stages.own_files import write_listed
from compwright.workflow.stages.redacted_controls import control_copies, texts_in
from compwright.workflow.stages.redacted_measurements import measurement_copy
from compwright.workflow.stages.single_files import refuse_other_kinds

SCHEMA: Final = "compwright/redaction/1"
#: A run of digits in the name of a file that may be a serial number; dates are none.
_SERIAL: Final = re.compile(r"(?<![0-9])(?!(?:19|20)[0-9]{6}(?![0-9]))[0-9]{5,}(?![0-9])")


@dataclass(frozen=True, slots=True, kw_only=True)
class RedactedFile:
    """One file: its own path, where the copy stands, what it was taken for, and how many texts were
    taken out, by kind. ``texts``: these themselves, for whoever asks.
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
    """The copies in the order of their files, and what was wrong with the others."""

    files: tuple[RedactedFile, ...]
    faults: tuple[Fault, ...]
    written: tuple[Path, ...]

    @property
    def exit_code(self) -> int:
        """0, or that of files that could not be copied."""
        return InputError.exit_code if self.faults else 0

    @property
    def document(self) -> dict[str, Any]:
        """The answer as JSON; the texts that were taken out are not in it."""
        return {
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


@dataclass(slots=True)
class _Input:
    """One file to copy; ``name``: its own, or that of a text in a container below its stem."""

    path: Path
    name: str
    content: bytes
    cuts: Cuts
    copy: bytes = b""
    taken_for: str = ""
    profile: str = ""

    @property
    def shown(self) -> str:
        """The file for messages."""
        inside = self.name.partition("/")[2]
        return f"{shown_path(self.path)}{': ' if inside else ''}{inside}"


def redact_files(
    paths: Sequence[Path],
    out: Path,
    *,
    profile: Path | None = None,
    format_id: str | None = None,
    json_path: Path | None = None,
    force: bool = False,
) -> RedactOutcome:
    """Write a copy of each file into ``out``, under its own name unless that holds a text that was
    taken out, or what may be a serial number.

    What is not known, or cannot be proven, is not copied and stands in ``faults``; the rest is.
    Raises UsageError for a wrong profile or control, StorageError where nothing can be written.
    """
    read_by = load_profile(profile) if profile is not None else None
    names, faults = Names(), list[Fault]()
    inputs = _read(paths, names, faults)
    _copy(inputs, read_by, format_id, faults)
    done = [one for one in inputs if one.taken_for]
    files = _named(done, names)
    outcome = RedactOutcome(files=_told(done, files, out), faults=tuple(faults), written=())
    contents = {
        name: content
        for one, name in zip(done, files, strict=True)
        for name, content in _of(one, name)
    }
    elsewhere = {} if json_path is None else {json_path: encoded(to_json(outcome.document))}
    refuse_other_kinds(elsewhere, force=force, results=[out / name for name in contents])
    if contents:
        written = write_listed(
            out, contents, command="redact", force=force, as_set=False, elsewhere=elsewhere
        )
    else:
        written = storage.write_files(out, {}, elsewhere=elsewhere, force=force)
    return replace(outcome, written=tuple(written))


def _read(paths: Sequence[Path], names: Names, faults: list[Fault]) -> list[_Input]:
    """Return what there is to copy, the texts of a container in its place; two files of one name
    are a fault, for their copies would be one.
    """
    inputs: dict[str, _Input] = {}
    for path in paths:
        try:
            found = [one for entry in storage.list_files(path) for one in _inputs(entry, names)]
        except InputError as error:
            faults.extend(fault.in_file(shown_path(path)) for fault in error.faults)
            continue
        twice = [one for one in found if inputs.setdefault(one.name.casefold(), one) is not one]
        faults.extend(
            Fault(
                message="has the name of another file, and their copies would be one",
                file=one.shown,
                expected="a command of its own, with another --out",
            )
            for one in twice
        )
    return list(inputs.values())


def _inputs(path: Path, names: Names) -> list[_Input]:
    content = storage.read_bytes(path)
    texts = texts_in(ControlFile(path.name, content)) or (ControlFile(path.name, content),)
    return [_Input(path, text.name, text.content, Cuts(names)) for text in texts]


def _copy(
    inputs: Sequence[_Input],
    profile: Profile | None,
    format_id: str | None,
    faults: list[Fault],
) -> None:
    """Make the copies: of measurements one by one, of controls' files together, and of what is
    neither by the profile that is proposed for it.
    """
    others: list[_Input] = []
    for one in inputs:
        if format_id is None and is_measurement(one.content, one.name, profile):
            _measurement(one, profile, faults)
        else:
            others.append(one)
    files = [ControlFile(one.name, one.content) for one in others]
    copies = control_copies(files, {one.name: one.cuts for one in others}, format_id)
    for one in others:
        copy = copies.made.get(one.name)
        if copy is not None:
            one.copy, one.taken_for = copy.content, "control file"
            continue
        one.cuts.removed.clear()
        why: list[Fault] = []
        if format_id is None and one.name in copies.unknown and _measurement(one, profile, why):
            continue
        told = [fault for fault in copies.faults if fault.file == one.name]
        if why and holds_table(one.content, one.name):
            told = why
        faults.extend(replace(fault, file=one.shown) for fault in told)


def _measurement(one: _Input, profile: Profile | None, faults: list[Fault]) -> bool:
    try:
        made = measurement_copy(one.content, one.shown, one.cuts, profile)
    except CompwrightError as error:
        one.cuts.removed.clear()
        faults.extend(error.faults)
        return False
    one.copy, one.profile, one.taken_for = made.content, made.profile, "measurement"
    return True


def _of(one: _Input, name: str) -> list[tuple[str, bytes]]:
    copies = [(name, one.copy)]
    if one.profile:
        copies.append((f"{PurePath(name).with_suffix('')}.profile.yaml", encoded(one.profile)))
    return copies


def _named(inputs: Sequence[_Input], names: Names) -> list[str]:
    """Return the names of the copies: those of the files, but for stems in which something stands
    that was taken out of any of them, or that may be a serial number.
    """
    somebody = {
        piece
        for one in inputs
        for kind, text in one.cuts.removed
        for piece in telling(_ADDRESS.sub(" ", text) if kind == LINE else text, ALLOWED | _COMMON)
        if _SIZE.fullmatch(piece) is None
    }
    made: list[str] = []
    for one in inputs:
        name = "/".join(_shown(part, somebody, names) for part in one.name.split("/"))
        path, number = PurePath(name), 1
        while name.casefold() in {other.casefold() for other in made}:
            number += 1
            name = str(path.with_stem(f"{path.stem}_{number}"))
        made.append(name)
    return made


def _shown(name: str, somebody: set[str], names: Names) -> str:
    """Return the name of a copy; one that stands in a file as a name is what stands there now."""
    stem, ending = PurePath(name).stem, PurePath(name).suffix
    if somebody & _pieces(ending):
        ending = ""
    gives_away = somebody & _pieces(stem) or _SERIAL.search(stem) or names.knows(stem)
    return f"{names.of(stem)}{ending}" if gives_away else f"{stem}{ending}"


def _pieces(text: str) -> set[str]:
    return set(re.findall(r"[^\W_]+", text.casefold()))


#: What a control calls its data, in a line of a program or of data that nobody reads.
_ADDRESS: Final = re.compile(r"\$?[A-Za-z0-9]*_[A-Za-z0-9_]*")
#: A length or an angle in the name of a file.
_SIZE: Final = re.compile(r"[0-9]+(?:mm|um|deg|grad|min)")
#: Words in names of files that name nobody.
_COMMON: Final = frozenset(
    {
        *("axis", "before", "after", "test", "measurement", "measured", "linear"),
        *("rotary", "circle", "circular", "ballbar", "backup", "parameter", "parameters"),
        *("pitch", "error", "compensation", "table", "positive", "negative", "data"),
        *("file", "files", "achse", "messung", "vorher", "nachher", "config"),
        *("configuration", "machine", "maschine", "laser", "plane", "first", "second"),
        *("joint", "entry", "para", "comp", "runs", "left", "right", "north", "south"),
    }
)


def _told(inputs: Sequence[_Input], names: Sequence[str], out: Path) -> tuple[RedactedFile, ...]:
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


def redaction_lines(outcome: RedactOutcome, *, show: bool = False) -> list[str]:
    """Return in words what was copied and taken out; ``show``: the texts themselves too."""
    lines = []
    for one in outcome.files:
        counts = ", ".join(f"{count} {kind}" for kind, count in one.removed.items())
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
