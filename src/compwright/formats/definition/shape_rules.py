"""The rules for definitions by the shape of their tables, and the lines that copies without private
names keep (`redact`).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Final

NUMBER: Final = r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:EX?[+-]?[0-9]{1,3})?"
#: What may stand where a control names an axis.
AXIS: Final = r"(?:[A-Za-z]{1,2}|AX|M[AXSC]_?[A-Z]?|CA_?[A-Z]|SP)[0-9]{0,2}"


@dataclass(frozen=True, slots=True)
class KeptLines:
    """Patterns of the lines that stay in a copy without private names, for tables of one shape.

    ``whole``: lines that may stay unchanged. ``naming``: lines of numbers, marks and names; a name
    is private unless it is an axis name. ``first``: first lines that identify the shape, whatever
    else they contain.
    """

    whole: tuple[str, ...]
    naming: str = "(?!)"
    first: str = "(?!)"

    def stays(self, line: str) -> bool:
        """Return whether a line stays unchanged in a copy without private names."""
        return _compiled(self.whole).fullmatch(line) is not None

    def holds_names(self, line: str) -> bool:
        """Return whether a line consists of numbers, marks and names only, so that it stays once
        its private names are removed.
        """
        return _compiled((self.naming,)).fullmatch(line) is not None

    def begins(self, content: bytes) -> bool:
        """Return whether the first line of a file (``content``) matches the pattern of a first line
        that files with such tables have.
        """
        return _compiled((self.first,)).match(content[:1000].decode("latin-1")) is not None


@cache
def _compiled(lines: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{line})" for line in lines), re.IGNORECASE | re.ASCII)


@dataclass(frozen=True, slots=True, kw_only=True)
class ShapeRules:
    """The rules for all definitions whose tables have the same shape in the files.

    ``words``: the shape in words. ``grid``: the quantities that define the nodes. ``signs``:
    quantities with a fixed sign, with the signs that a definition may state. ``row``: where
    position and values of a node are: in one statement that has the position (``position``), a
    field ``index`` (``index``), or only the values (``values``); None: each may be in a statement
    of its own. ``by_axis``: a file belongs to one axis. ``columns``: every table has columns for
    other axes, so that corrections between axes need nothing else. ``afresh``: files are always
    written anew, never patched. ``parameters``: those in addition to the table whose meaning a
    definition states. ``kept``: lines that `redact` may leave unchanged, in addition to the
    definition's statements. ``repeats_turns``: the table of a rotary axis over several turns
    repeats its turn. ``quantities``: those that only definitions of this shape bind, taken as
    written. ``typed``: fields of its own that the text of a typed parameter may have.
    """

    words: str
    kept: KeptLines
    grid: tuple[str, ...]
    signs: Mapping[str, frozenset[str]] = field(default_factory=dict)
    row: str | None = "values"
    by_axis: bool = True
    columns: bool = False
    afresh: bool = False
    repeats_turns: bool = False
    quantities: tuple[str, ...] = ()
    parameters: frozenset[str] = frozenset()
    typed: frozenset[str] = frozenset()
