"""The lines of cross-axis tables in the control's files, by table index and quantity."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from compwright.formats.definition.schema import Definition
from compwright.formats.text.gathering import FoundValue, Gathered

#: Quantities of one table, by the names that a table on one axis has.
AS_TABLE = {
    "cross_value": "value",
    "cross_start": "table_start",
    "cross_end": "table_end",
    "cross_spacing": "table_spacing",
}
#: Quantities that name the two axes of a table.
BETWEEN = ("cross_input", "cross_output")
#: Quantities without which a table is none; those behind them count as a default where they are
#: absent.
NEEDED = (*BETWEEN, *AS_TABLE, "cross_direction")
DATA = (*NEEDED, "cross_multiplier", "cross_repeats")
#: The NCU of the input axis and that of the output axis: 0 or 1 for this one.
NCUS = ("cross_input_ncu", "cross_output_ncu")

#: What the control adds to the values of point 0 and point 1.
ADDED = ("cross_first_added", "cross_second_added")

#: Input and output axis.
Pair = tuple[str, str]
#: Every place of one table by quantity.
Places = Mapping[str, Sequence[FoundValue]]


def as_table(definition: Definition) -> Definition:
    """Return a copy of a definition in which the quantities of an axis table are those of a
    cross-axis table.
    """
    bindings = {
        name: replace(definition.bindings[cross], quantity=name) for cross, name in AS_TABLE.items()
    }
    return replace(definition, bindings={**definition.bindings, **bindings})


def places_of(gathered: Gathered) -> dict[int, dict[str, list[FoundValue]]]:
    """Return the lines of each cross-axis table, by table index and quantity."""
    found: dict[int, dict[str, list[FoundValue]]] = {}
    for quantity, places in gathered.singles.get((None, None), {}).items():
        for place in places:
            if quantity.startswith("cross_") and "table" in place.occurrence.tokens:
                index = int(place.occurrence.tokens["table"].text)
                found.setdefault(index, {}).setdefault(quantity, []).append(place)
    return found


def last(quantity: str, places: Places) -> FoundValue | None:
    """Return the line in the files that states a quantity last."""
    found = places.get(quantity, ())
    return found[-1] if found else None


def of_axis(gathered: Gathered, address: str) -> Places:
    """Return the settings that apply to all cross-axis tables on one output axis."""
    return gathered.singles.get((address, None), {})


def is_whole(places: Places) -> bool:
    """Return whether a table is complete: all its single values are stated, and no point number is
    missing.
    """
    points = {int(row.occurrence.tokens["index"].text) for row in places.get("cross_value", ())}
    return all(name in places for name in NEEDED) and points == set(range(len(points)))


def is_unused(places: Places) -> bool:
    """Return whether all numbers of a table are zero, which is the control's default for a table
    that was never written.
    """
    numbers = [place.text for name in AS_TABLE for place in places.get(name, ())]
    return bool(numbers) and all(Decimal(number) == 0 for number in numbers)


def is_elsewhere(places: Places) -> bool:
    """Return whether the files assign the input axis or output axis of a table to another NCU."""
    units = [place.text for name in NCUS for place in places.get(name, ())]
    return any(Decimal(unit) > 1 for unit in units)


def is_zero(places: Places) -> bool:
    """Return whether every value of a table is zero, so that it corrects nothing."""
    added = [found for name in ADDED for found in places.get(name, ())[-1:]]
    return all(Decimal(row.text) == 0 for row in (*places.get("cross_value", ()), *added))


def print_of(places: Places) -> str:
    """Return a check code of eight characters for the contents of a table."""
    lines = [
        f"{name} {found.occurrence.tokens.get('index', found).text} {found.text}"
        for name in (*DATA, "cross_weight", "cross_type", *ADDED)
        for found in places.get(name, ())
    ]
    return hashlib.sha256("\n".join(lines).encode("utf-8", "surrogatepass")).hexdigest()[:8]
