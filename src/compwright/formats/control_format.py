"""The one door to a control: its definition, its options and what its files say, bound once."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.consistency import has_cross
from compwright.formats.definition.schema import Definition, Shape
from compwright.formats.families.columns.family import ColumnsFamily
from compwright.formats.families.family import Family
from compwright.formats.families.grid.family import GridFamily
from compwright.formats.families.increments.family import IncrementsFamily
from compwright.formats.families.lists.family import ListsFamily
from compwright.formats.families.pairs.family import PairsFamily
from compwright.formats.families.wrapped.family import WrappedFamily
from compwright.records.correction import ControlState

_FAMILIES: Mapping[Shape, type[Family]] = {
    "values_by_index": GridFamily,
    "rows_by_position": GridFamily,
    "section_increments": IncrementsFamily,
    "user_tables": ColumnsFamily,
    "lists_by_axis": ListsFamily,
    "wrapped_counts": WrappedFamily,
}

_WORDS: Mapping[Shape, str] = {
    "values_by_index": "values by index on an equally spaced grid",
    "rows_by_position": "rows by position, freely spaced",
    "section_increments": "whole increments by section, numbered in one array for all axes",
    "user_tables": "rows in tables that the control exports, or typed in from a sheet",
    "lists_by_axis": "entries by index, at equal or at any spacing, in one list per axis",
    "wrapped_counts": "parts of a count over a length that repeats, defined by a script",
}


def shape_words(definition: Definition) -> str:
    """Return the form of a control's table, as people read it."""
    return _WORDS[definition.layout.shape]


def control_format(
    definition: Definition,
    given: Mapping[str, object],
    state: ControlState | None = None,
    *,
    strict: bool = False,
) -> Family:
    """Return the control of a definition, its options settled.

    ``given`` may hold text from the command line; with a ``state``, an option that the control's
    own files answer takes that answer. ``strict``: every option of ``given`` was said by somebody.
    Raises UsageError with every fault: unknown option, a value of the wrong kind, one that
    contradicts the control's files.
    """
    family = PairsFamily if has_cross(definition) else _FAMILIES[definition.layout.shape]
    return family(definition, given, state, strict=strict)
