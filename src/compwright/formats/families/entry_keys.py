"""Which entry of the control a line sets, independent of the name used for its axis."""

from __future__ import annotations

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.axis_names import AxisNames

#: Statement, axis, and the other fields that say which entry it is.
Key = tuple[str, str, tuple[str, ...]]
#: Fields that say which entry a line is, apart from the axis.
_WHICH = ("system", "table", "set", "index", "key")
#: Quantities that list the names of axes: they must be the same everywhere.
NAMES = ("machine_axis", "channel_axis", "channel_machine_axis")


def entry_key(definition: Definition, occurrence: Occurrence, names: AxisNames) -> Key:
    """Return the key of the entry in a line; ``names``: the axis names."""
    tokens = occurrence.tokens
    axis = tokens.get("axis")
    address = "" if axis is None else names.address(normal_text(definition, axis.text))
    texts = (tokens[name].text for name in which_fields(definition, occurrence.statement))
    which = tuple(str(int(text)) if text.isdigit() else text.upper() for text in texts)
    return occurrence.statement, address, which


def which_fields(definition: Definition, statement: str) -> list[str]:
    """Return the fields that identify the entry of a statement, apart from the axis."""
    return [name for name in definition.statements[statement].fields if name in _WHICH]


def value_of(occurrence: Occurrence) -> str:
    """Return the value of an entry as written."""
    which = ("axis", *_WHICH)
    return next(token.text for name, token in occurrence.tokens.items() if name not in which)


def quantities_of(definition: Definition, statement: str) -> list[str]:
    """Return the quantities that a statement holds."""
    return [name for name, binding in definition.bindings.items() if binding.statement == statement]
