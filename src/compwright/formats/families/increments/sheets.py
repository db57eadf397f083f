"""Whole steps as an entry sheet, and as a program that enters the same values."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.formats.families.axis_tables import AxisTable, with_partners
from compwright.formats.families.family import Family
from compwright.formats.families.increments.entries import all_entries
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.writing import sheet_rows, write_programs
from compwright.formats.text.entry_sheet import write_sheet
from compwright.foundations.errors import Fault, UsageError
from compwright.records.correction import ControlFile

_PULSE = (
    "whole detection units, before the magnification 3623; position: upper end of the point's"
    " section"
)


def increment_sheets(family: Family, own: Sequence[AxisTable]) -> tuple[ControlFile, ...]:
    """Return the entry sheets, and programs if the options require them.

    ``own``: the tables of leading axes; those of gantry partners are derived from them.
    """
    definition = family.definition
    names = {address: axis.name for address, axis, _ in own}
    names |= {
        axis.gantry: f"{axis.name}_{axis.gantry}" for _, axis, _ in own if axis.gantry is not None
    }
    entries = all_entries(family, with_partners(family.definition, own))
    sheets = [
        write_sheet(
            f"entry_{names[entry.address]}.csv",
            (
                ("axis", entry.axis.name),
                ("address", entry.address),
                ("format", definition.id),
                ("value", "correction"),
                ("unit pulse", _PULSE),
            ),
            tuple(sheet_rows(definition, entry)),
        )
        for entry in entries
    ]
    if family.options.get("program") != "g10":
        return tuple(sheets)
    if any(increments_of(facts).inch for facts in family.state.facts.values()):
        message = (
            "a program has no letter for the unit, and the intervals in mm are not whole on an inch"
            " machine (1001#0)"
        )
        raise UsageError(
            Fault(
                message=message,
                place="program",
                expected="none: load the files or type in the sheet",
                found="g10",
                hint="leave the option `program` out; the card contains the values to enter",
            )
        )
    return (*sheets, *write_programs(definition, entries))
