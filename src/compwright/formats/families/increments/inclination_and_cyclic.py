"""Functions that compwright writes in addition to a table of whole increments: a straight line
(inclination compensation) and a table with a short period (second cyclic table).

The line has two points and two amounts, given twice because there is room for three lines (FANUC
B-63522EN/02 page 222). The second table's first number is its reference point and holds 0, those
behind it own the sections of one period (A-78868E page 6). Unconfirmed: the sign of both, assumed
to be that of the pitch data.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.numbering import first_free
from compwright.formats.text.scale import NotHeld
from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation

#: Amounts are 16-bit numbers.
AMOUNTS = (-32767, 32767)


@dataclass(frozen=True, slots=True)
class InclinationAndCyclic:
    """Parameters by number, as text, and increments by point number."""

    parameters: Mapping[int, str] = field(default_factory=dict)
    points: Mapping[int, int] = field(default_factory=dict)


def line_parameters(numbers: Sequence[int], amounts: Sequence[int]) -> dict[int, str]:
    """Return the parameters of the line through two point numbers with their amounts, detection
    units. Raises NotHeld for amounts beyond the control's range.
    """
    low, high = AMOUNTS
    if not all(low <= amount <= high for amount in amounts):
        raise NotHeld(
            f"the line of inclination compensation would need the amounts {amounts[0]} and"
            f" {amounts[1]} (5871 to 5874); the control holds {low} to {high}"
        )
    (first, last), (begin, end) = numbers, amounts
    points = zip(known.INCLINATION_POINTS, (first, first, last, last), strict=True)
    levels = zip(known.INCLINATION_AMOUNTS, (begin, begin, end, end), strict=True)
    return {number: str(value) for number, value in (*points, *levels)}


def second_table(
    totals: FloatArray, interval: str, used: Sequence[range], start: int, highest: int
) -> InclinationAndCyclic:
    """Return a second table of ``totals`` (k,), detection units at the section ends of one period,
    in the first unused numbers from ``start`` on. Raises NotHeld.

    ``interval``: the width of its sections, as text.
    """
    first = first_free(totals.size, used, start, highest)
    if first is None:
        raise NotHeld(f"the second table needs {totals.size} point numbers in a row that are free")
    return InclinationAndCyclic(
        parameters={
            known.CYCLIC_FIRST: str(first),
            known.CYCLIC_LAST: str(first + totals.size - 1),
            known.CYCLIC_INTERVAL: interval,
        },
        points={first: 0}
        | {first + 1 + k: int(value) for k, value in enumerate(np.diff(totals).astype(np.int64))},
    )


def repeats_alone(other: AxisCompensation, table: AxisCompensation) -> bool:
    """Return whether an additional table repeats with a period of its own."""
    return other.period is not None and other.period != table.period
