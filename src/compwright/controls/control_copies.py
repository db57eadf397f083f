"""Copy a control's files without private names, and check that each copy is decoded as the original
is.

The contents of a file show to which control it belongs.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePath
from typing import Any

from compwright.controls.control import decode, open_control
from compwright.controls.decoded_state import judged_values
from compwright.controls.definitions import definition_named, shipped_definitions
from compwright.controls.judged_corrections import judged_cross
from compwright.controls.other_controls import refuse_other_control, statements_at_start
from compwright.documents.decode import DecodedAxis, decode_document
from compwright.formats.definition.schema import Definition
from compwright.formats.families.control_texts import STATE_TEXTS, texts_of
from compwright.formats.families.shapes import RULES
from compwright.formats.text.container import is_container, opened, unknown_container
from compwright.formats.text.entry_sheet import is_entry_sheet, parse_sheet
from compwright.formats.text.redaction import (
    TextRedactor,
    definition_words,
    redacted_sheet,
    same_statements,
)
from compwright.formats.text.texts import ReadText, text_reader
from compwright.foundations.errors import CompwrightError, Fault, InputError
from compwright.foundations.redaction import Cuts, not_the_same, refuse_left_over
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile

#: Where an option has no default: the numbers of a copy are those of its original in any unit.
_ANY_UNIT = 0.001
#: What is no state of one control alone.
SHEET = "typed-entry sheet"
#: Bytes of a file that tell which control it is of.
_LOOKED_AT = 65536
#: A table of bare numbers is a control's only by the ending of its name, or where another file
#: names it.
_BARE_TABLE = ".comp"


@dataclass(frozen=True, slots=True)
class ControlCopy:
    """The copy of one file without private names, the control to which it belongs, and the replaced
    names with their new names.
    """

    content: bytes
    control: str
    renamed: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ControlCopies:
    """The result of copying: the copies by file name, the faults of files that were not copied, and
    the names of files of unknown controls.
    """

    made: Mapping[str, ControlCopy]
    faults: tuple[Fault, ...]
    unknown: frozenset[str]


def control_copies(
    session: Session, files: Sequence[ControlFile], cuts: Mapping[str, Cuts], format_id: str | None
) -> ControlCopies:
    """Return the checked copies of control files. ``cuts``: by file name, the record of the texts
    that are removed from the file; ``format_id``: the control, if it is known.

    Raises UsageError for an unknown ``format_id``.
    """
    faults: list[Fault] = []
    likely = _likely(session, files, format_id)
    copies: dict[str, ControlCopy] = {}
    for file in files:
        try:
            copies[file.name] = _copy(file, likely[file.name], cuts[file.name])
        except InputError as error:
            faults.extend(fault.in_file(file.name) for fault in error.faults)
    unknown = frozenset(
        file.name for file in files if not (likely[file.name] or is_entry_sheet(file))
    )
    for name in _decoded_otherwise(session, files, copies):
        del copies[name]
        faults.extend(not_the_same(name, "another correction").faults)
    return ControlCopies(copies, tuple(faults), unknown)


def _decoded_otherwise(
    session: Session, files: Sequence[ControlFile], copies: Mapping[str, ControlCopy]
) -> Iterator[str]:
    """Yield the names of files whose copies, decoded together, give a different correction from the
    originals.
    """
    shipped = shipped_definitions(session)
    shapes = {
        name: shipped[copy.control].layout.shape
        for name, copy in copies.items()
        if copy.control in shipped
    }
    for shape in sorted(set(shapes.values())):
        group = [file for file in files if shapes.get(file.name) == shape]
        control = copies[group[0].name].control
        renamed = {
            old.upper(): new for file in group for old, new in copies[file.name].renamed.items()
        }
        named = {re.split(r"[/\\]", old)[-1]: new for old, new in renamed.items()}
        made = [
            ControlFile(named.get(file.name.upper(), file.name), copies[file.name].content)
            for file in group
        ]
        if not _same_decoding(session, shipped, control, group, made, renamed):
            yield from [file.name for file in group]


def _copy(file: ControlFile, likely: Sequence[Definition], cuts: Cuts) -> ControlCopy:
    if is_entry_sheet(file):
        return _sheet(file, cuts)
    if not likely:
        raise _unknown(file)
    definition, read = _as_read(file, likely)
    reader = text_reader(definition)
    made = TextRedactor(reader, file, read, RULES[definition.layout.shape].kept, cuts).copy()
    again = _read(made.file, definition)
    if isinstance(again, tuple):
        raise not_the_same(file.name, again[0].message)
    if not same_statements(read, again, made.renamed):
        raise not_the_same(file.name, "other values")
    for other in likely:  # whatever another control would read in it stays too
        if other.layout.shape != definition.layout.shape and statements_at_start(file, other):
            first, second = _read(file, other), _read(made.file, other)
            if isinstance(first, ReadText) and not (
                isinstance(second, ReadText) and same_statements(first, second, made.renamed)
            ):
                raise not_the_same(file.name, f"other values for {other.id}")
    allowed = definition_words(definition) | frozenset(made.words)
    refuse_left_over(file.name, cuts, [made.file.content], allowed)
    return ControlCopy(made.file.content, definition.id, made.renamed)


def _as_read(file: ControlFile, likely: Sequence[Definition]) -> tuple[Definition, ReadText]:
    """Return the first of the ``likely`` definitions by which a file can be read without a fault,
    and the contents of the file. Raises InputError if there is none.

    The error contains the faults found with the first definition.
    """
    first: tuple[Fault, ...] = ()
    for definition in likely:
        read = _read(file, definition)
        if isinstance(read, ReadText):
            return definition, read
        first = first or read
    raise InputError(*first)


def _read(file: ControlFile, definition: Definition) -> ReadText | tuple[Fault, ...]:
    """Return the statements of a file; if it cannot be read, its faults."""
    faults: list[Fault] = []
    (text,) = texts_of(definition, [file], faults) or (file,)
    read = text_reader(definition).read(text, faults)
    return read if read is not None and not faults else tuple(faults)


def _sheet(file: ControlFile, cuts: Cuts) -> ControlCopy:
    faults: list[Fault] = []
    old = parse_sheet(file, faults)
    if faults or old is None:
        raise InputError(*faults)
    made = replace(file, content=redacted_sheet(file.content, cuts))
    new = parse_sheet(made, faults)
    if faults or new is None:
        raise not_the_same(file.name, faults[0].message if faults else "nothing")
    if old.rows != new.rows or old.axis != new.axis:
        raise not_the_same(file.name, "other values")
    refuse_left_over(file.name, cuts, [made.content], frozenset({"value", "axis", "points"}))
    return ControlCopy(made.content, SHEET)


def _likely(
    session: Session, files: Sequence[ControlFile], format_id: str | None
) -> dict[str, list[Definition]]:
    """Return for each file the controls that could have written it, the most probable first.

    Controls are ordered by the number of their statements in the first part of the file. If equal,
    the order follows the statements in the other files of the same archive.

    A file without such statements, for example a table of bare numbers, can belong to many
    controls. It is assigned to a control if ``format_id`` names the control, or if the file was in
    an archive. It is also assigned if the ending of its name, or another file that names it, shows
    that it is a table.
    """
    known = (
        [definition_named(session, format_id, Path())]
        if format_id
        else list(shipped_definitions(session).values())
    )
    if format_id:
        refuse_other_control(session, known[0], files)
    counts = {
        file.name: {definition.id: statements_at_start(file, definition) for definition in known}
        for file in files
        if not is_entry_sheet(file)
    }
    named = _named_by_others(files)
    likely = {}
    for file in files:
        own = counts.get(file.name, {})
        of_set = [stated for name, stated in counts.items() if _set_of(name) == _set_of(file.name)]
        totals = {one.id: sum(stated[one.id] for stated in of_set) for one in known}
        likely[file.name] = sorted(
            (
                one
                for one in known
                if own and (own[one.id] or format_id is not None or _bare(file, one, named))
            ),
            key=lambda one: (-own[one.id], -totals[one.id]),
        )
    return likely


def _set_of(name: str) -> str:
    """Return the name of the archive that contains a text; empty for a file outside archives."""
    return name.rpartition("/")[0]


def _named_by_others(files: Sequence[ControlFile]) -> frozenset[str]:
    """Return the names of files that other files mention, as settings mention table files."""

    def names(other: ControlFile, file: ControlFile) -> bool:
        name = re.escape(file.name.lower().encode(errors="replace"))
        return re.search(rb"(?<![\w.-])" + name + rb"(?![\w.-])", texts[other.name]) is not None

    texts = {file.name: file.content.lower() for file in files}
    return frozenset(
        file.name
        for file in files
        if any(other is not file and names(other, file) for other in files)
    )


def _bare(file: ControlFile, definition: Definition, named: frozenset[str]) -> bool:
    """Return whether the text of a file, read by ``definition``, does not show to which control it
    belongs. ``named``: file names that other files mention.
    """
    if "/" in file.name or RULES[definition.layout.shape].kept.begins(file.content):
        return True
    if not (file.name.lower().endswith(_BARE_TABLE) or file.name in named):
        return False
    read = _read(file, definition)
    return isinstance(read, ReadText) and bool(read.occurrences)


def _same_decoding(
    session: Session,
    shipped: Mapping[str, Definition],
    control_id: str,
    old: Sequence[ControlFile],
    new: Sequence[ControlFile],
    renamed: Mapping[str, str],
) -> bool:
    """Return whether both file readers of compwright find the same corrections in the copies and in
    the originals.

    ``old``: the originals. ``new``: the copies. ``renamed``: new names of axes by their old names
    in capitals. The result is also true if the originals alone cannot be decoded.
    """
    for likely, options in _ways_to_read(shipped, control_id):
        try:
            first = _decoded(session, likely, options, old, renamed)
        except CompwrightError:
            continue
        try:
            return first == _decoded(session, likely, options, new, {})
        except CompwrightError:
            return False
    return True


def _ways_to_read(
    shipped: Mapping[str, Definition], control_id: str
) -> Iterator[tuple[str, dict[str, object]]]:
    """Yield the controls whose files have the same layout (``control_id`` first), each with trial
    options by which the files are possibly readable.
    """
    shape = shipped[control_id].layout.shape
    relatives = [name for name, one in shipped.items() if one.layout.shape == shape]
    for name in sorted(relatives, key=lambda name: name != control_id):
        for options in _options(shipped[name]):
            yield name, options


def _options(definition: Definition) -> Iterator[dict[str, object]]:
    """Yield trial values of those options without which a control's files are possibly not
    readable.
    """
    rules = definition.options
    required: dict[str, object] = {
        name: _ANY_UNIT for name, rule in rules.items() if rule.asked is not None
    }
    yield {}
    if required:
        yield required
    for name, rule in rules.items():
        for choice in rule.choices:
            if choice != rule.default:
                yield {**required, name: choice}


def _decoded(
    session: Session,
    control_id: str,
    options: dict[str, object],
    files: Sequence[ControlFile],
    renamed: Mapping[str, str],
) -> dict[str, Any]:
    def name(address: str) -> str:
        return renamed.get(address.upper(), address).upper()

    decoded = decode(open_control(session, control_id, options), files)
    axes = {
        name(address): DecodedAxis(
            kind=entry.kind,
            positions=entry.positions,
            positive=judged_values(decoded, address, entry.positions, Direction.POSITIVE),
            negative=judged_values(decoded, address, entry.positions, Direction.NEGATIVE),
        )
        for address, entry in decoded.state.axes.items()
    }
    cross = [
        replace(entry, input=name(entry.input), output=name(entry.output))
        for entry in judged_cross(decoded, None)
    ]
    return decode_document(axes, (), (), cross)


def texts_in(file: ControlFile) -> tuple[ControlFile, ...]:
    """Return the text files in an archive that state the control's settings; empty if ``file`` is
    no archive.

    The texts are copied one by one, because the checksum of the archive itself is unknown. Raises
    InputError for an archive that cannot be opened.
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
    return InputError(
        Fault(
            message="the file was not copied: its format is unknown, so the names of persons, "
            "companies and machines in it cannot be found and removed",
            file=file.name,
            expected="a measurement file or a text of a control that compwright reads",
            found=unknown_container(file.content).rstrip(","),
            hint="leave the file out; for a table of another program make a profile: "
            "`compwright profile FILE --out P.yaml`, then add `--profile P.yaml`",
        )
    )
