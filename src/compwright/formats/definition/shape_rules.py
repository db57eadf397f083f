"""What a definition has to bind for the shape of its tables: data that each family brings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.formats.definition.kept_lines import KeptLines


@dataclass(frozen=True, slots=True, kw_only=True)
class ShapeRules:
    """What definitions of one shape have in common.

    ``words``: the shape as people read it. ``grid``: the quantities that say where the nodes are.
    ``signs``: quantities that have one sign whatever a definition says, with the signs that it may
    say. ``row``: position and values of a node stand in one statement, which says the position
    itself (``position``), is counted by its field ``index`` (``index``), or only holds the values
    (``values``); None: each may stand in a statement of its own. ``by_axis``: a file belongs to one
    axis. ``columns``: every table has columns for other axes, so that nothing else is needed to
    correct between axes. ``afresh``: files are always written anew, never patched. ``parameters``:
    those beside the table of which a definition says what they are. ``kept``: lines that `redact`
    may leave as they are, beside the statements of the definition. ``repeats_turns``: the table of
    a rotary axis over several turns holds its turn again and again. ``quantities``: what only
    definitions of this shape bind, taken as it stands.
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
