"""Copies of a control's files without names: which control they are of is told by what is in them,
and each copy is proven by the readers of its original.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path, PurePath
from typing import Any

from compwright.documents.decode import DecodedAxis, decode_document
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import definitions_from
from compwright.formats.families.control_texts import texts_of
from compwright.formats.families.kept_lines import STATE_TEXTS, kept_lines
from compwright.formats.text.container import is_container, opened, unknown_container
from compwright.formats.text.entry_sheet import is_entry_sheet, parse_sheet
from compwright.formats.text.redaction import (
    RedactedText,
    definition_words,
    redacted_sheet,
    redacted_text,
    same_statements,
)
from compwright.formats.text.texts import ReadText, TextReader, text_reader
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError
from compwright.foundations.redaction import Cuts
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from compwright.workflow.stages.acting import judged_cross
from compwright.workflow.stages.control import decode, judged, open_control
from compwright.workflow.stages.definitions import definition_named
from compwright.workflow.stages.redacted_measurements import not_the_same, refuse_left_over

#: Where an option has no default: the numbers of a copy are those of its original in any unit.
_ANY_UNIT = 0.001
#: What is no state of one control alone.
SHEET = "typed-entry sheet"
#: A table of bare numbers is a control's only by the ending of its name.
_BARE_TABLE = ".comp"


@dataclass(frozen=True, slots=True)
class ControlCopy:
    """The copy of one file, the control that it is of, and the new names in it by the old ones."""

    content: bytes
    control: str
    renamed: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ControlCopies:
    """Copies by the name of the file, what is wrong with the others, and which of them are of no
    control that is known.
    """

    made: Mapping[str, ControlCopy]
    faults: tuple[Fault, ...]
    unknown: frozenset[str]


@dataclass(frozen=True, slots=True)
class _Candidate:
    definition: Definition
    text: ControlFile
    read: ReadText
    statements: int


def control_copies(
    files: Sequence[ControlFile], cuts: Mapping[str, Cuts], format_id: str | None
) -> ControlCopies:
    """Return the proven copies of the files of controls; each file has ``cuts`` of its own, by its
    name. ``format_id``: the control, where somebody says it.

    Raises UsageError for a control that is not known.
    """
    faults: list[Fault] = []
    found = {file.name: list(_candidates(file, format_id)) for file in files}
    totals = _totals(found.values())
    copies: dict[str, ControlCopy] = {}
    for file in files:
        try:
            copies[file.name] = _copy(file, found[file.name], totals, cuts[file.name])
        except InputError as error:
            faults.extend(fault.in_file(file.name) for fault in error.faults)
    unknown = frozenset(
        file.name for file in files if not (found[file.name] or is_entry_sheet(file))
    )
    for name in _decoded_otherwise(files, copies):
        del copies[name]
        faults.extend(not_the_same(name, "another correction").faults)
    return ControlCopies(copies, tuple(faults), unknown)


def _decoded_otherwise(
    files: Sequence[ControlFile], copies: Mapping[str, ControlCopy]
) -> Iterator[str]:
    """Yield the names of files whose copies, taken together, give another correction."""
    for control in sorted({copy.control for copy in copies.values()} & set(_definitions())):
        group = [
            file for file in files if file.name in copies and copies[file.name].control == control
        ]
        made = [replace(file, content=copies[file.name].content) for file in group]
        renamed = {
            old.upper(): new for file in group for old, new in copies[file.name].renamed.items()
        }
        if not _decoded_alike(control, group, made, renamed):
            yield from [file.name for file in group]


def _copy(
    file: ControlFile, found: Sequence[_Candidate], totals: Mapping[str, int], cuts: Cuts
) -> ControlCopy:
    if is_entry_sheet(file):
        return _sheet(file, cuts)
    if not found:
        raise _unknown(file)
    best = max(found, key=lambda one: (one.statements, totals[one.definition.id]))
    reader = text_reader(best.definition)
    made = redacted_text(reader, file, best.read, kept_lines(best.definition), cuts)
    _prove(best, reader, made)
    allowed = definition_words(best.definition) | frozenset(made.words)
    refuse_left_over(file.name, cuts, [made.file.content], allowed)
    return ControlCopy(made.file.content, best.definition.id, made.renamed)


def _prove(best: _Candidate, reader: TextReader, made: RedactedText) -> None:
    faults: list[Fault] = []
    (text,) = texts_of(best.definition, [made.file], faults) or (made.file,)
    again = reader.parse(text, faults)
    if again is None or faults:
        raise not_the_same(best.text.name, faults[0].message if faults else "nothing")
    if not same_statements(best.read, again, made.renamed):
        raise not_the_same(best.text.name, "other values")


def _sheet(file: ControlFile, cuts: Cuts) -> ControlCopy:
    faults: list[Fault] = []
    old = parse_sheet(file, faults)
    made = replace(file, content=redacted_sheet(file.content, cuts))
    new = parse_sheet(made, faults)
    if faults or old is None or new is None:
        raise InputError(*faults)
    if old.rows != new.rows or old.axis != new.axis:
        raise not_the_same(file.name, "other values")
    refuse_left_over(file.name, cuts, [made.content], frozenset({"value", "axis", "points"}))
    return ControlCopy(made.content, SHEET)


def _candidates(file: ControlFile, format_id: str | None) -> Iterator[_Candidate]:
    """Yield the controls that read a file without a fault, with the number of statements that no
    other file could hold by chance; a text out of a container is a control's without any.
    """
    if is_entry_sheet(file):
        return
    known = [definition_named(format_id, Path())] if format_id else _definitions().values()
    for definition in known:
        reader, faults = text_reader(definition), list[Fault]()
        (text,) = texts_of(definition, [file], faults) or (file,)
        read = reader.parse(text, faults)
        if faults or read is None:
            continue
        heads = {name for name, matcher in reader.matchers.items() if matcher.head}
        count = sum(one.statement in heads for one in read.occurrences)
        bare = file.name.lower().endswith(_BARE_TABLE) or format_id is not None
        if count or (bare and read.occurrences) or "/" in file.name:
            yield _Candidate(definition, text, read, count)


def _totals(found: Iterable[list[_Candidate]]) -> dict[str, int]:
    totals: dict[str, int] = {}
    for candidates in found:
        for one in candidates:
            totals[one.definition.id] = totals.get(one.definition.id, 0) + one.statements
    return totals


@cache
def _definitions() -> Mapping[str, Definition]:
    """Return what ships, by its id."""
    return definitions_from(storage.definition_files())


def _decoded_alike(
    control_id: str,
    old: Sequence[ControlFile],
    new: Sequence[ControlFile],
    renamed: Mapping[str, str],
) -> bool:
    """Whether both readers understand the copies of a control's files as the originals; True where
    the originals alone do not make a state of a control. ``renamed``: new names of axes by the old
    ones, in capitals.
    """
    for options in _options(control_id):
        try:
            first = _decoded(control_id, options, old, renamed)
        except CompwrightError:
            continue
        try:
            return first == _decoded(control_id, options, new, {})
        except CompwrightError:
            return False
    return True


def _options(control_id: str) -> Iterator[dict[str, object]]:
    """Yield answers to what the files of a control leave open, until one lets them be read."""
    rules = _definitions()[control_id].options
    asked: dict[str, object] = {
        name: _ANY_UNIT for name, rule in rules.items() if rule.asked is not None
    }
    yield {}
    if asked:
        yield asked
    for name, rule in rules.items():
        for choice in rule.choices:
            if choice != rule.default:
                yield {**asked, name: choice}


def _decoded(
    control_id: str,
    options: dict[str, object],
    files: Sequence[ControlFile],
    renamed: Mapping[str, str],
) -> dict[str, Any]:
    def name(address: str) -> str:
        return renamed.get(address.upper(), address).upper()

    decoded = decode(open_control(control_id, options), files)
    axes = {
        name(address): DecodedAxis(
            kind=entry.kind,
            positions=entry.positions,
            positive=judged(decoded, address, entry.positions, Direction.POSITIVE),
            negative=judged(decoded, address, entry.positions, Direction.NEGATIVE),
        )
        for address, entry in decoded.state.axes.items()
    }
    cross = [
        replace(entry, input=name(entry.input), output=name(entry.output))
        for entry in judged_cross(decoded, None)
    ]
    return decode_document(axes, (), (), cross)


def texts_in(file: ControlFile) -> tuple[ControlFile, ...]:
    """Return the texts of a container that are the state of the control, each named by a path below
    the name of the container; none for a file that is no container.

    A copy of the container itself cannot be made: its checksum is not understood. Raises InputError
    for one that cannot be opened.
    """
    if not is_container(file):
        return ()
    container, faults = opened(file)
    if container is None:
        hint = f"the texts in it, exported one by one: {STATE_TEXTS}"
        raise InputError(*(replace(fault, expected=hint) for fault in faults))
    stem = PurePath(file.name).stem
    return tuple(
        ControlFile(f"{stem}/{text.name.rpartition(': ')[2]}", text.content)
        for text in container.state
    )


def _unknown(file: ControlFile) -> InputError:
    what = unknown_container(file.content)
    return InputError(
        Fault(
            message="is not known, so that nobody could say what in it is a name; it is not copied",
            file=file.name,
            expected="a measurement file or a text of a control that compwright reads; any other"
            " table with --profile P.yaml (compwright profile FILE --out P.yaml)",
            found=what.rstrip(","),
        )
    )
