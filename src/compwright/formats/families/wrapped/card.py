"""Contents of the commissioning card for the table of a motor."""

from __future__ import annotations

from compwright.formats.families.wrapped.counts import PARTS, Counts
from compwright.formats.families.wrapped.tables import MotorTable
from compwright.records.axis import Axis


def table_words(axis: Axis, table: MotorTable, counts: Counts, rate: str) -> dict[str, str]:
    """Return the values of the card's fields: entries, length, spacing, the gap, the backlash and
    its rate.
    """
    unit = axis.kind.unit
    spacing = table.length / len(table.entries) * counts.count
    gap = "the length is one turn, and there is no gap"
    if table.gap is not None:
        turn = table.length * counts.count
        gap = (
            f"what lies beyond {table.gap[0]:.10g} {unit} and below {table.gap[1]:.10g} "
            f"{unit} is the gap"
            f" that must stay unused (the table repeats after {turn:.10g} {unit}): keep the"
            " software limits inside"
        )
    at_zero = table.constant / PARTS * counts.count
    return {
        "points": str(len(table.entries)),
        "length": str(table.length),
        "unit": unit,
        "spacing": f"{spacing:.10g}",
        "gap": gap,
        "constant": str(table.constant),
        "backlash": f"{at_zero:.6f}",
        "rate": rate if table.takes_up else "0 or as it is (there is no backlash)",
        "counts": f"{counts.per_unit:.10g}",
        "tables": "COMP and BLCOMP" if table.varies else "COMP",
    }
