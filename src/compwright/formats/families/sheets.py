"""What stands beside the tables: the sheet to type in where a file's form is unconfirmed, a program
that enters the same values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from compwright.formats.definition.options import resolve_options
from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments.entries import all_entries
from compwright.formats.families.increments.writing import sheet_rows, write_programs
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.entry_sheet import write_sheet
from compwright.formats.writing import with_partners, write_tables
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile, ControlState


def second_forms(
    definition: Definition,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[Axis],
    options: Mapping[str, object],
    state: ControlState | None,
) -> tuple[ControlFile, ...]:
    """Return the typed-entry sheets of compensations that were written already, and programs where
    the options ask for them.

    Controls whose text form is confirmed have none. ``compensations`` belong to ``axes`` one by
    one.
    """
    if definition.layout.shape == "user_tables":
        return write_tables(definition, compensations, axes, options, state)
    if definition.layout.shape != "section_increments":
        return ()
    resolved = resolve_options(definition, options, state)
    own = [
        (normal_address(definition, axis)[0], axis, table)
        for axis, table in zip(axes, compensations, strict=True)
    ]
    pairs = with_partners(definition, own)
    names = {address: axis.name for address, axis, _ in own}
    leaders = {axis.gantry: axis.name for _, axis, _ in own if axis.gantry is not None}
    entries = all_entries(definition, pairs, resolved, state)
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
    if resolved.get("program") != "g10":
        return tuple(sheets)
    if state is not None and any(
        said.get("length_unit") == "inch" for said in state.facts.values()
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
