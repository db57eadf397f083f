"""The closed list of table shapes on one axis."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.schema import Definition
from compwright.formats.families.grid.by_index import ByIndex
from compwright.formats.families.grid.by_position import ByPosition
from compwright.formats.families.grid.tables import TableShape

SHAPES: Mapping[str, TableShape] = {
    "values_by_index": ByIndex(),
    "rows_by_position": ByPosition(),
}


def shape_of(definition: Definition) -> TableShape:
    """Return the shape of a control's tables."""
    return SHAPES[definition.layout.shape]
