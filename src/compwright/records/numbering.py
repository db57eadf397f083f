"""Numbered sections of a table, as drawn on the card."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class Section(NamedTuple):
    """One section of a table: its number, start and end, mm or deg."""

    number: int
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class NumberedSections:
    """The numbered sections into which a control divides the table of one axis, in ascending order
    and without gaps.

    ``reference``: the position from which they are counted, mm or deg. ``marks``: the control's
    names for some of the numbers. ``second``: the number of the first section in the second set,
    for travel in -; None if there is one set. ``words``: what the user must know about the
    sections, one sentence each.
    """

    unit: str
    reference: float
    sections: tuple[Section, ...]
    marks: tuple[tuple[int, str], ...]
    second: int | None
    words: tuple[str, ...]
