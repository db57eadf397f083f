"""Changes to a file as (start, end, bytes) on the original. A fresh file is a patch of a skeleton:
one way for both.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from compwright.formats.definition.statements import Occurrence


@dataclass(frozen=True, slots=True)
class Change:
    """The bytes from ``start`` up to but not including ``end`` are replaced; equal: bytes are
    inserted there.
    """

    start: int
    end: int
    content: bytes


def set_field(occurrence: Occurrence, field: str, text: str) -> tuple[Change, ...]:
    """Return the changes that put ``text`` into a field of a statement; a line checksum no longer
    fits and goes.
    """
    token = occurrence.tokens[field]
    changes = [Change(token.start, token.end, text.encode("ascii"))]
    if occurrence.checksum is not None:
        changes.append(Change(occurrence.checksum.start, occurrence.checksum.end, b""))
    return tuple(changes)


def apply_changes(original: bytes, changes: Iterable[Change]) -> bytes:
    """Return the original with all changes made; everything else stays byte for byte.

    Insertions at one place keep their order. Raises ValueError for changes that overlap or reach
    outside.
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
