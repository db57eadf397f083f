"""The texts of a control's files: archives are unpacked, and separate files replace values in the
archives.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import takewhile

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, Token
from compwright.formats.families.axis_names import axis_names
from compwright.formats.text.addresses import NAMES, AxisNames, Key, entry_key, quantities_of
from compwright.formats.text.container import is_container, unpacked
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.gathering import Gathered, gather
from compwright.formats.text.patching import BytesChange, apply_changes
from compwright.formats.text.texts import ReadText, text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile

#: What a user exports in the place of an archive in a container.
STATE_TEXTS = "machine data of all axes, AX_EEC_INI, NC_CEC_INI"
#: The quantity of a table's values, and that which says where it ends.
_ROWS = {"value": "table_end", "cross_value": "cross_end"}
#: A value with a decimal comma, one with a decimal point, and one without a value.
_COMMA = re.compile(
    rb"^([^;\n]*=[ \t]*[+-]?[0-9]+),([0-9]+)(?=[ \t]*(?:;[^\n]*)?\r?$)", re.MULTILINE
)
_POINT = re.compile(rb"^[^;\n]*=[ \t]*[+-]?[0-9]*\.[0-9]", re.MULTILINE)
_UNKNOWN = re.compile(
    rb"^((?:[^;\n=]*?[^;\n= \t])?)[ \t]*=[ \t]*n/a[ \t]*\r?$", re.MULTILINE | re.IGNORECASE
)
#: What stands before the comment of a line with a value, and in it the word before a value that
#: is known.
_ASSIGNING = re.compile(rb"^[^;\n=]*=[^;\n]*", re.MULTILINE)
_ASSIGNED = re.compile(rb"(?<![^\s=])([^\s=]++)[ \t]*+=(?![ \t]*+n/a)", re.IGNORECASE)
#: What was laid over containers is kept by content, of as many sets as a job has states.
_KEPT = 16


def gathered_files(
    definition: Definition, files: Sequence[ControlFile], wanted: Sequence[str] = ()
) -> Gathered:
    """Return all values in the files, sorted by axis and measuring system. ``wanted``: the axis
    addresses in a job or on the command line.

    Raises the errors of `axis_names`, and InputError for files that cannot be read.
    """
    reader, faults = text_reader(definition), list[Fault]()
    whole = texts_of(definition, files, faults)
    read = [reader.read(file, faults, number) for number, file in enumerate(whole)]
    raise_all(InputError, faults)
    texts = [text for text in read if text is not None]
    return gather(definition, texts, axis_names(definition, texts, wanted))


def all_names(
    definition: Definition, files: Sequence[ControlFile], addresses: Sequence[str]
) -> set[str]:
    """Return all names that the files give to the axes at ``addresses``, and these addresses."""
    reader, faults = text_reader(definition), list[Fault]()
    texts = [
        text
        for file in texts_of(definition, files, faults)
        if not is_entry_sheet(file) and (text := reader.read(file, faults)) is not None
    ]
    names = axis_names(definition, texts, addresses)
    return {name for address in addresses for name in names.forms(address)}


def texts_of(
    definition: Definition, files: Sequence[ControlFile], faults: list[Fault]
) -> tuple[ControlFile, ...]:
    """Return the texts of a control's files, with archives unpacked.

    Files that are given next to an archive were loaded after it, whatever their order here. Entries
    of the archive that these files contain too are therefore replaced by blanks. The same is done
    with values of a table for which these files state the end. Faults of an archive are added to
    ``faults``.
    """
    found, wrong = _texts_of(definition, tuple(files))
    faults.extend(wrong)
    return found


@lru_cache(maxsize=_KEPT)
def _texts_of(
    definition: Definition, files: tuple[ControlFile, ...]
) -> tuple[tuple[ControlFile, ...], tuple[Fault, ...]]:
    faults: list[Fault] = []
    packed = unpacked([file for file in files if is_container(file)], faults)
    loose = _listed([file for file in files if not is_container(file)], definition)
    return (*under_new_entries(definition, packed, loose), *loose), tuple(faults)


def under_new_entries(
    definition: Definition, own: Sequence[ControlFile], new: Sequence[ControlFile]
) -> tuple[ControlFile, ...]:
    """Return the ``own`` files with blanks in place of each line whose value is also in one of the
    ``new`` files.

    If any of the files cannot be read, ``own`` is returned unchanged. The reader of that file
    reports the fault.
    """
    if not (own and new):
        return tuple(own)
    reader = text_reader(definition)
    texts = [reader.read(file, []) for file in (*own, *new)]
    read = [text for text in texts if text is not None]
    if len(read) < len(texts):
        return tuple(own)
    over = _Over(definition, axis_names(definition, read), read[len(own) :])
    return tuple(over.blanked(file, text) for file, text in zip(own, read, strict=False))


def is_listing(definition: Definition, file: ControlFile) -> bool:
    """Return whether a file is a listing for people, not an export that the control can load.

    All values with decimals in a listing have decimal commas, which no control accepts.
    """
    return (
        "files" in definition.options
        and not is_container(file)
        and _COMMA.search(file.content) is not None
        and _POINT.search(file.content) is None
    )


def _listed(files: Sequence[ControlFile], definition: Definition) -> tuple[ControlFile, ...]:
    """Return files with decimal points in place of the decimal commas of printed listings.

    An entry without a value (``n/a``) is replaced by blanks if another file has a value for it.
    """
    pointed = [
        replace(file, content=_COMMA.sub(rb"\1.\2", file.content))
        if is_listing(definition, file)
        else file
        for file in files
    ]
    if not any(_UNKNOWN.search(file.content) for file in pointed):
        return tuple(pointed)
    assigned = _assigned_names(pointed)
    return tuple(_without_unknown(file, at, assigned) for at, file in enumerate(pointed))


def _assigned_names(files: Sequence[ControlFile]) -> list[tuple[bytes, int]]:
    """Return the names to which the files assign values (``name = value``), each with the index of
    its file.

    The names are in lower case, reversed and sorted. Names with the same ending are thus
    neighbours.
    """
    return sorted(
        {
            (found[1][::-1].lower(), at)
            for at, file in enumerate(files)
            for line in _ASSIGNING.finditer(file.content)
            for found in _ASSIGNED.finditer(line[0])
        }
    )


def _without_unknown(
    file: ControlFile, at: int, assigned: Sequence[tuple[bytes, int]]
) -> ControlFile:
    known: dict[bytes, bool] = {}

    def blank(found: re.Match[bytes]) -> bytes:
        words = found[1].split()
        name = words[-1][::-1].lower() if words else b""
        if name not in known:
            first = bisect_left(assigned, (name,)) if name else len(assigned)
            behind = (assigned[place] for place in range(first, len(assigned)))
            alike = takewhile(lambda one: one[0].startswith(name), behind)
            known[name] = any(index != at for _, index in alike)
        return b" " * len(found[0]) if known[name] else found[0]

    return replace(file, content=_UNKNOWN.sub(blank, file.content))


class _Over:
    """Blanks out those lines of archived files whose values are also in separate files."""

    def __init__(self, definition: Definition, names: AxisNames, texts: Iterable[ReadText]) -> None:
        self.definition = definition
        self.names = names
        assigned = [one for text in texts for one in text.occurrences]
        self.keys = {self._key(one) for one in assigned if self._counts(one)}
        self.ended = {self._table(one) for one in assigned if self._holds(one, _ROWS.values())}

    def blanked(self, file: ControlFile, text: ReadText) -> ControlFile:
        """Return a text of the archive with blanks for the lines that separate files replace."""
        spans = [
            (min(token.start for token in tokens), max(token.end for token in tokens))
            for one in text.occurrences
            if self._superseded(one)
            for tokens in [self._own_tokens(one)]
        ]
        lines = [
            (file.content.rfind(b"\n", 0, start) + 1, _end(file.content, end))
            for start, end in spans
        ]
        changes = [BytesChange(start, end, b" " * (end - start)) for start, end in lines]
        return ControlFile(file.name, apply_changes(file.content, changes))

    def _own_tokens(self, one: Occurrence) -> list[Token]:
        """Return the fields of the line ``one``, except fields that repeat the header of its
        section.
        """
        within = self.definition.statements[one.statement].within or ""
        return [token for name, token in one.tokens.items() if f"{{{name}}}" not in within]

    def _superseded(self, one: Occurrence) -> bool:
        if not self._counts(one):
            return False
        row = self._holds(one, _ROWS)
        return self._key(one) in self.keys or (row and self._table(one) in self.ended)

    def _counts(self, one: Occurrence) -> bool:
        """Return whether a line states a value of one axis or one table, other than the name of an
        axis.
        """
        of_one = "axis" in one.tokens or "table" in one.tokens
        return of_one and not self._holds(one, NAMES)

    def _holds(self, one: Occurrence, quantities: Iterable[str]) -> bool:
        return not set(quantities).isdisjoint(quantities_of(self.definition, one.statement))

    def _key(self, one: Occurrence) -> Key:
        return entry_key(self.definition, one, self.names)

    def _table(self, one: Occurrence) -> tuple[str, str, str]:
        """Return the table to which a line belongs."""
        of = [one.tokens[name].text if name in one.tokens else "" for name in ("system", "table")]
        return self._key(one)[1], of[0].lstrip("0"), of[1].lstrip("0")


def _end(content: bytes, place: int) -> int:
    """Return the byte position at which the line that contains the byte ``place`` ends."""
    found = content.find(b"\n", place)
    return len(content) if found < 0 else found
