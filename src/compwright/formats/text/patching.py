"""Changes to files by byte position; all other bytes stay as they are.

A new file is made by changing a template, so the same code serves both cases.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from compwright.formats.definition.schema import Definition, Dialect, WrittenFile
from compwright.formats.definition.statements import Occurrence, Token, print_form
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class BytesChange:
    """One change: the bytes from ``start`` to before ``end`` are replaced. If both are equal, bytes
    are inserted.
    """

    start: int
    end: int
    content: bytes


@dataclass(frozen=True, slots=True)
class BytesPlace:
    """The byte range of a line, from ``start`` to ``end``; the next line begins at ``next``."""

    start: int
    end: int
    next: int


def set_field(occurrence: Occurrence, field: str, text: str) -> tuple[BytesChange, ...]:
    """Return the byte changes that put ``text`` into one field of a line.

    A checksum of the line is removed, because it would be wrong after the change.
    """
    token = occurrence.tokens[field]
    changes = [BytesChange(token.start, token.end, text.encode("ascii"))]
    if occurrence.checksum is not None:
        changes.append(BytesChange(occurrence.checksum.start, occurrence.checksum.end, b""))
    return tuple(changes)


def apply_changes(original: bytes, changes: Iterable[BytesChange]) -> bytes:
    """Return the original with all changes made. All other bytes stay.

    Insertions at the same byte keep their order. Raises ValueError for changes that overlap or are
    outside of the file.
    """
    parts: list[bytes] = []
    place = 0
    for change in sorted(changes, key=lambda change: (change.start, change.end)):
        if not place <= change.start <= change.end <= len(original):
            raise ValueError(
                f"change {change.start}..{change.end} overlaps another one or lies outside the file"
            )
        parts += [original[place : change.start], change.content]
        place = change.end
    return b"".join([*parts, original[place:]])


class Patches:
    """Collects the changes to several files, each identified by its index.

    If the same bytes are replaced twice, the second text is used.
    """

    def __init__(self, dialect: Dialect, files: Sequence[ControlFile]) -> None:
        self.dialect = dialect
        self.files = list(files)
        self._ends = sorted((end.encode() for end in dialect.newlines_read), key=len, reverse=True)
        self._end = re.compile(b"|".join(map(re.escape, self._ends)))
        self._replaced: dict[int, dict[tuple[int, int], BytesChange]] = {}
        self._inserted: dict[int, list[BytesChange]] = {}

    def replace(self, number: int, *changes: BytesChange) -> None:
        """Record the replacement of bytes in one file, given by its index ``number``."""
        replaced = self._replaced.setdefault(number, {})
        replaced.update({(change.start, change.end): change for change in changes})

    def insert(self, number: int, place: int, text: str) -> None:
        """Insert text before the byte ``place``, after earlier insertions there."""
        change = BytesChange(place, place, text.encode("latin-1"))
        self._inserted.setdefault(number, []).append(change)

    def text(self, number: int, token: Token) -> str:
        """Return the text of a token, including changes made so far."""
        change = self._replaced.get(number, {}).get((token.start, token.end))
        return token.text if change is None else change.content.decode("latin-1")

    def line(self, number: int, place: int) -> BytesPlace:
        """Return the line that contains the byte ``place`` of a file."""
        content = self.files[number].content
        before = [
            found + len(end) for end in self._ends if (found := content.rfind(end, 0, place)) >= 0
        ]
        match = self._end.search(content, place)
        end = len(content.removesuffix(b"\x1a")) if match is None else match.start()
        return BytesPlace(max(before, default=0), end, end if match is None else match.end())

    def like(
        self, number: int, occurrence: Occurrence, texts: Mapping[str, str], *, end: str = ""
    ) -> str:
        """Return a copy of a line in which some fields have the new ``texts``; it ends with the
        field ``end``, or with the line if ``end`` is empty.
        """
        line = self.line(number, occurrence.tokens[next(iter(texts))].start)
        stop = occurrence.tokens[end].end if end else line.end
        changes = [
            BytesChange(token.start - line.start, token.end - line.start, text.encode("ascii"))
            for token, text in ((occurrence.tokens[name], text) for name, text in texts.items())
        ]
        content = self.files[number].content[line.start : stop]
        return apply_changes(content, changes).decode("latin-1")

    def add_lines(
        self, number: int, place: int, lines: Iterable[str], *, before: bool = False
    ) -> None:
        """Add lines after (or ``before``) the line that contains the byte ``place``.

        If the file's last line has no line end, it gets one, and the new last line has none.
        """
        line = self.line(number, place)
        found = self.files[number].content[line.end : line.next].decode()
        end = found or self.dialect.newline
        for text in lines:
            if before:
                self.insert(number, line.start, text + end)
            else:
                self.insert(number, line.next, text + end if found else end + text)

    def cut_line(self, number: int, place: int) -> None:
        """Remove the line that contains the byte ``place`` of a file."""
        line = self.line(number, place)
        self.replace(number, BytesChange(line.start, line.next, b""))

    def changed(self) -> set[int]:
        """Return the indices of the files for which changes are recorded."""
        return {*self._replaced, *self._inserted}

    def patched(self, numbers: Iterable[int]) -> tuple[ControlFile, ...]:
        """Return the files with these indices, with all changes made, in the order of the files."""
        return tuple(
            ControlFile(
                self.files[number].name,
                apply_changes(
                    self.files[number].content,
                    [
                        *self._replaced.get(number, {}).values(),
                        *self._inserted.get(number, ()),
                    ],
                ),
            )
            for number in sorted(set(numbers))
        )


def fresh_file(
    definition: Definition,
    file: WrittenFile,
    name: str,
    named: Mapping[str, str],
    rows: Iterable[str],
) -> Patches:
    """Return a new file made from the template ``file`` of a definition, with ``rows`` between
    header and footer. ``named``: texts for the fields in header and footer, by field name.
    """
    newline = definition.dialect.newline
    header, footer = (
        "".join(print_form(line, named) + newline for line in lines).encode("ascii", "replace")
        for lines in (file.header, file.footer)
    )
    patches = Patches(definition.dialect, [ControlFile(name, header + footer)])
    patches.insert(0, len(header), "".join(row + newline for row in rows))
    return patches
