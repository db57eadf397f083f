"""Requirements on a definition by the shape of its tables: data that each family gives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.formats.definition.kept_lines import KeptLines


@dataclass(frozen=True, slots=True, kw_only=True)
class ShapeRules:
    """Common properties of all definitions of one shape.

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
    written.
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
