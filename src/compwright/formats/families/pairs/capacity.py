"""What an axis can hold in a pair of tables over itself (CEC), one for each direction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from compwright.formats.definition.consistency import has_cross
from compwright.formats.definition.options import settled_number
from compwright.formats.definition.schema import Definition
from compwright.formats.families.pairs.reading import (
    CEC_MAX_SUM,
    CEC_ODD_SUM,
    allowed_tables,
    as_table,
    free_tables,
    reserved_in,
    tables_in,
    with_some_sign,
)
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.scale import Scale
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption, ControlState


def cec_available(definition: Definition, options: Mapping[str, object]) -> bool:
    """Return whether the control has tables between axes, by its option ``cec``."""
    return has_cross(definition) and options.get("cec") == "available"


def with_cec(
    definition: Definition,
    axis: Axis,
    options: Mapping[str, object],
    state: ControlState | None,
    capacity: Capacity,
) -> Capacity:
    """Return ``capacity`` (that of one table and backlash) as it is with a pair of tables for the
    axis.

    A gantry needs a pair for each of its axes. Raises CapacityError when too few indices may be
    written.
    """
    address, _ = normal_address(definition, axis)
    addresses = (
        [address] if axis.gantry is None else [address, normal_text(definition, axis.gantry)]
    )
    facts = state.facts if state is not None else {}
    tables = _tables(definition, axis, addresses, options, facts)
    scale = Scale(as_table(definition), axis.kind, with_some_sign(options), {})
    low, high = scale.range("value")
    for each in addresses:
        room = _room(each, state)
        low, high = max(low, -room), min(high, room)
    reserved = [
        points for index, points in reserved_in(facts).items() if index in tables and points > 0
    ]
    fact = min(reserved) if len(reserved) == len(tables) else None
    points = settled_number(definition, _points_option(definition), options, fact)
    assumed = [note for note in capacity.assumed if "number of points" not in note.fact]
    if points is None:
        assumed.append(
            Assumption(
                fact=f"axis {axis.name}: number of points of its CEC tables (MD18342)",
                value="as many as are needed; the card says how many to set",
                evidence="unconfirmed: the control's files do not say it",
            )
        )
    if "cross_max_sum" in definition.bindings and CEC_MAX_SUM not in facts.get(address, {}):
        assumed.append(
            Assumption(
                fact=f"axis {axis.name}: limit of the sum of its CEC tables (MD32720)",
                value=f"not reached (default 1 {axis.kind.unit})",
                evidence="unconfirmed: in no file, its default from memory",
            )
        )
    return replace(
        capacity,
        curves=2,
        quantum=scale.quantum("value"),
        position_quantum=scale.quantum("table_start"),
        value_range=(low, high),
        backlash_quantum=None,
        backlash_range=(0.0, 0.0),
        max_points=points,
        below="hold",
        above="hold",
        assumed=tuple(assumed),
    )


def _points_option(definition: Definition) -> str:
    return next(
        name for name, option in definition.options.items() if option.settled_by == "max_points"
    )


def _tables(
    definition: Definition,
    axis: Axis,
    addresses: list[str],
    options: Mapping[str, object],
    facts: Mapping[str, Mapping[str, object]],
) -> list[int]:
    """Return the indices that the tables of these axes will take."""
    allowed, in_use = allowed_tables(options), tables_in(facts)
    taken: list[int] = []
    for address in addresses:
        taken += [index for index in free_tables(allowed, in_use, address) if index not in taken][
            :2
        ]
    needed = 2 * len(addresses)
    if len(taken) < needed:
        raise CapacityError(too_few(axis.name, definition.id, needed, len(taken), allowed))
    return taken


def too_few(name: str, format_id: str, needed: int, found: int, allowed: tuple[int, ...]) -> Fault:
    """Return the fault of an axis that finds too few tables."""
    return Fault(
        message=(
            f"axis {name}: {format_id} needs {needed} CEC tables that are free or already the axis'"
            " own pair"
        ),
        place="option cec_tables",
        expected=f"{needed} such indices",
        found=(
            f"{found} among {', '.join(map(str, allowed))}"
            if allowed
            else "none: the option is not given"
        ),
    )


def _room(address: str, state: ControlState | None) -> float:
    """Return what CEC_MAX_SUM leaves beside the tables by which other axes correct this one, mm or
    deg.
    """
    if state is None:
        return float("inf")
    limit = state.facts.get(address, {}).get(CEC_MAX_SUM)
    if not isinstance(limit, (int, float)):
        return float("inf")
    others = sum(
        max(float(np.max(np.abs(entry.positive))), float(np.max(np.abs(entry.negative))))
        for entry in state.cross
        if entry.output == address
    )
    odd = state.facts[address].get(CEC_ODD_SUM, 0.0)
    return max(0.0, float(limit) - others - (float(odd) if isinstance(odd, (int, float)) else 0.0))
