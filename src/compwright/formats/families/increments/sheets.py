"""Whole steps as a sheet to type in, and as a program that enters the same values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.families.family import AxisTable
from compwright.formats.families.increments.entries import all_entries
from compwright.formats.families.increments.writing import sheet_rows, write_programs
from compwright.formats.text.entry_sheet import write_sheet
from compwright.foundations.errors import Fault, UsageError
from compwright.records.correction import ControlFile, ControlState


def increment_sheets(
    definition: Definition,
    own: Sequence[AxisTable],
    pairs: Sequence[AxisTable],
    options: Mapping[str, object],
    state: ControlState | None,
) -> tuple[ControlFile, ...]:
    """Return the typed-entry sheets, and programs where the options ask for them.

    ``own``: the tables of the axes that lead; ``pairs``: those of gantry partners too.
    """
    names = {address: axis.name for address, axis, _ in own}
    leaders = {axis.gantry: axis.name for _, axis, _ in own if axis.gantry is not None}
    entries = all_entries(definition, pairs, options, state)
    sheets = [
        write_sheet(
            f"entry_{names.get(entry.address) or f'{leaders[entry.address]}_{entry.address}'}.csv",
            (
                ("axis", entry.name),
                ("address", entry.address),
                ("format", definition.id),
                ("value", "correction"),
                (
                    "unit pulse",
                    (
                        "whole detection units, before the magnification 3623; position: upper end"
                        " of the point's section"
                    ),
                ),
            ),
            sheet_rows(definition, entry),
        )
        for entry in entries
    ]
    if options.get("program") != "g10":
        return tuple(sheets)
    if state is not None and any(
        facts.said.get("length_unit") == "inch" for facts in state.facts.values()
    ):
        raise UsageError(
            Fault(
                message=(
                    "a program has no letter for the unit, and the intervals in mm are not whole on"
                    " an inch machine (1001#0)"
                ),
                place="program",
                expected="none: load the files or type in the sheet",
                found="g10",
            )
        )
    return (*sheets, *write_programs(definition, entries))
