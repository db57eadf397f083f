"""Compare two sets of control files: each changed entry, and the number of unchanged lines."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

from compwright.formats.definition.schema import Definition, Statement
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.container import unpacked
from compwright.formats.text.entry_sheet import is_entry_sheet, read_sheet
from compwright.formats.text.gathering import same_value
from compwright.formats.text.texts import TextReader, text_reader
from compwright.records.correction import ControlFile

#: Fields that say which entry a line is; all others hold its values.
_IDENTITY = ("axis", "system", "index", "number", "table", "position", "line")
#: Files whose values are kept by content: a run compares the same ones several times.
_KEPT = 32


@dataclass(frozen=True, slots=True)
class EntryChange:
    """One entry of the control's files that differs, with its old and new value as the control
    writes them.

    ``old``: None if the entry is new. ``new``: None if the entry was removed. ``address``: the axis
    address; None if the line names no axis.
    """

    entry: str
    address: str | None
    old: str | None
    new: str | None


@dataclass(frozen=True, slots=True)
class FileDiff:
    """All entries that differ between two sets of files, and the number of unchanged lines.

    ``changes``: the changed entries in the order of the new files, then the removed entries.
    ``untouched``: the number of unchanged lines of the old files.
    """

    changes: tuple[EntryChange, ...]
    untouched: int


@dataclass(frozen=True, slots=True)
class DiffEntry:
    """One value in the control's files, as text, with its axis, for comparing two sets of files.

    ``label``: a function that returns the control's text up to the value. It is a function because
    only few entries of a whole backup need their label.
    """

    label: Callable[[], str]
    address: str | None
    text: str


#: What tells a value from all others, and the value.
_KeyedEntry = tuple[tuple[str, ...], DiffEntry]


def compare_files(
    definition: Definition, old: Sequence[ControlFile], new: Sequence[ControlFile]
) -> FileDiff:
    """Return the differences between the entries of two sets of files. Tables are compared row by
    row.

    Entries that cannot be read are left out: their faults were reported when the files were read.
    """
    old, new = unpacked(old, []), unpacked(new, [])
    before, after = dict(entries_of(definition, old)), dict(entries_of(definition, new))
    changes = []
    for key, entry in after.items():
        was = before.get(key)
        if was is None or not same_value(was.text, entry.text):
            changes.append(
                EntryChange(entry.label(), entry.address, was.text if was else None, entry.text)
            )
    replaced = {file.name for file in new}
    for key, entry in before.items():
        if key not in after and key[0] in replaced:
            changes.append(EntryChange(entry.label(), entry.address, entry.text, None))
    return FileDiff(tuple(changes), _untouched(old, new))


def _untouched(old: Sequence[ControlFile], new: Sequence[ControlFile]) -> int:
    by_name = {file.name: file for file in new}
    count = 0
    for file in old:
        lines = Counter(line for line in file.content.splitlines() if line.strip())
        other = by_name.get(file.name)
        kept = lines if other is None else lines & Counter(other.content.splitlines())
        count += sum(kept.values())
    return count


def entries_of(definition: Definition, files: Sequence[ControlFile]) -> Iterator[_KeyedEntry]:
    """Yield the values of all statements, each with a unique key."""
    reader = text_reader(definition)
    for file in unpacked(files, []):
        yield from _entries(reader, file)


@lru_cache(maxsize=_KEPT)
def _entries(reader: TextReader, file: ControlFile) -> tuple[_KeyedEntry, ...]:
    if is_entry_sheet(file):
        return tuple(_sheet_entries(file))
    text = reader.read(file, [])
    rows: Counter[str] = Counter()
    found: list[_KeyedEntry] = []
    for occurrence in text.occurrences if text else ():
        rows[occurrence.statement] += 1
        found += _values(reader.definition, occurrence, rows[occurrence.statement])
    return tuple(found)


def _sheet_entries(file: ControlFile) -> Iterator[_KeyedEntry]:
    sheet = read_sheet(file, [])
    for row in sheet.rows if sheet else ():
        label = f"{row.point} at {row.position}" if row.position else row.point
        yield (
            (file.name, row.point),
            DiffEntry(
                partial(str, f"{file.name}: {label}"), sheet.axis if sheet else None, row.value
            ),
        )


def _values(definition: Definition, occurrence: Occurrence, row: int) -> Iterator[_KeyedEntry]:
    """Yield the values of a statement, each with a key; a value on a line without a name has its
    ``row`` in the file as key.
    """
    statement = definition.statements[occurrence.statement]
    tokens = occurrence.tokens
    identity = [tokens[name].text for name in _IDENTITY if name in tokens]
    if statement.form.startswith("({"):
        identity = [str(row)]
    named = tokens.get("axis")
    address = normal_text(definition, named.text) if named is not None else None
    # A line that names neither axis nor number belongs to its file: the same row in another file is
    # another entry.
    scope = "" if {"axis", "number", "table"} & set(tokens) else occurrence.file
    for field, token in tokens.items():
        if field in _IDENTITY or field == "key":
            continue
        yield (
            (scope, statement.name, *identity, field),
            DiffEntry(partial(_label, statement, occurrence, field, row), address, token.text),
        )


def _label(statement: Statement, occurrence: Occurrence, field: str, row: int) -> str:
    """Return the part of a line before its value, as a name for the value."""
    values = {name: token.text for name, token in occurrence.tokens.items()}
    marked = {**values, **{name: "\0" for name in statement.fields if name not in _IDENTITY}}
    text = print_form(
        statement.form, {name: marked.get(name, "") for name in (*statement.fields, *marked)}
    )
    label = re.sub(r'(?:(?<![A-Za-z])[PMI]|[=( "])+$', "", text.split("\0")[0])
    if statement.fields.get(field) == "bit":
        return f"{label} bit {field[1:]}"
    several = sum(name not in _IDENTITY and name != "key" for name in statement.fields) > 1
    if several:
        return f"{label or statement.name} {field}"
    return label or f"{occurrence.file}: {statement.name} {row}"
