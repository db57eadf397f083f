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

    ``whole``: lines that may stay unchanged. ``naming``: lines that consist of numbers, punctuation
    marks and names; a name in them is private unless it is an axis name. ``first``: first lines
    that identify the shape, whatever else they contain.
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

    - ``words``: description of the shape.
    - ``kept``: lines that `redact` may leave unchanged, in addition to the definition's statements.
    - ``grid``: quantities that define the table points.
    - ``signs``: for each quantity with a fixed sign, the signs that a definition may state.
    - ``row``: statement that contains position and values of a point. It has the position
      (``position``), a field ``index`` (``index``), or only the values (``values``). None: each may
      be in a statement of its own.
    - ``by_axis``: a file belongs to one axis.
    - ``columns``: every table has columns for other axes, which contain the corrections between
      axes.
    - ``afresh``: files are always written anew, never patched.
    - ``repeats_turns``: on a rotary axis that travels several turns, the table repeats one turn.
    - ``quantities``: quantities that only definitions of this shape have; they are used as written.
    - ``parameters``: parameters in addition to the table, whose meaning a definition must state.
    - ``typed``: fields that only this shape allows in the text of a typed parameter.
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
