"""Tables to be written, each with its axis and the address used in the files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.families import limits
from compwright.formats.text.addresses import normal_text
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.records.axis import Axis, partner_of
from compwright.records.correction import AxisCompensation

#: Address, axis and table: what is written for one axis.
AxisTable = tuple[str, Axis, AxisCompensation]


def paired(
    definition: Definition,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[tuple[str, Axis]],
) -> list[AxisTable]:
    """Return the tables with their axes (address in the files, axis), in the order of the tables.

    Raises UsageError for every table without an axis, and for two of one axis.
    """
    by_address = dict(axes)
    faults = []
    pairs: dict[str, AxisTable] = {}
    for compensation in compensations:
        named = compensation.address
        address = next(
            (address for address, axis in axes if axis.address == named),
            None,
        ) or normal_text(definition, named)
        if address not in by_address:
            faults.append(
                Fault(
                    message=f"no axis has the address {named}",
                    expected=", ".join(by_address),
                    hint="use one of these addresses, or add the axis to the job",
                )
            )
        elif address in pairs:
            faults.append(
                Fault(message=f"axis {address} has two tables", hint="remove one of the two tables")
            )
        else:
            pairs[address] = (address, by_address[address], compensation)
    raise_all(UsageError, faults)
    return list(pairs.values())


def with_partners(definition: Definition, pairs: Sequence[AxisTable]) -> list[AxisTable]:
    """Return the tables with equal ones for gantry partners: a table on one axis alone racks the
    bridge.
    """
    result = {address: (address, axis, compensation) for address, axis, compensation in pairs}
    for _, axis, compensation in pairs:
        if axis.gantry is not None:
            partner = normal_text(definition, axis.gantry)
            table = replace(compensation, address=partner)
            result.setdefault(partner, (partner, partner_of(axis, partner), table))
    return list(result.values())


def sound(tables: Sequence[AxisTable]) -> list[AxisTable]:
    """Return the tables that can be written: two points or more, finite, ascending."""
    return [each for each in tables if each[2].positions.size >= 2 and not limits.unsound(each[2])]
