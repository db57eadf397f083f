"""The families of controls by the shape of their tables, and the entry to a control's format."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.consistency import has_cross
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.shape_rules import ShapeRules
from compwright.formats.families.columns import family as columns
from compwright.formats.families.family import Family
from compwright.formats.families.grid.family import GridFamily
from compwright.formats.families.grid.table_shapes import SHAPES as GRIDS
from compwright.formats.families.increments import family as increments
from compwright.formats.families.lists import family as lists
from compwright.formats.families.pairs.family import PairsFamily
from compwright.formats.families.wrapped import family as wrapped
from compwright.records.correction import ControlState

_FAMILIES: Mapping[str, type[Family]] = {
    **dict.fromkeys(GRIDS, GridFamily),
    "section_increments": increments.IncrementsFamily,
    "user_tables": columns.ColumnsFamily,
    "lists_by_axis": lists.ListsFamily,
    "wrapped_counts": wrapped.WrappedFamily,
}
#: What a definition has to bind, by the shape of its tables.
RULES: Mapping[str, ShapeRules] = {
    **{name: shape.rules for name, shape in GRIDS.items()},
    "section_increments": increments.RULES,
    "user_tables": columns.RULES,
    "lists_by_axis": lists.RULES,
    "wrapped_counts": wrapped.RULES,
}


def family_of(definition: Definition) -> type[Family]:
    """Return the family of a control, by its table shape and whether it has cross-axis tables."""
    return PairsFamily if has_cross(definition) else _FAMILIES[definition.layout.shape]


def control_format(
    definition: Definition,
    given: Mapping[str, object],
    state: ControlState | None = None,
    *,
    strict: bool = False,
) -> Family:
    """Return the definition with its options, as an object of the family that reads and writes the
    control's files. ``given``: options by name; ``strict``: the user stated each of them, so one
    that contradicts the files (``state``) is a fault.

    The values in ``given`` may be text from the command line. If there is a ``state``, an option
    whose value follows from the control's own files gets that value. Raises UsageError with every
    fault: an unknown option, a wrong type, or a contradiction to the control's files.
    """
    return family_of(definition)(definition, given, state, strict=strict)
