"""A straight line of our own by inclination compensation: two points and two amounts, given twice
because there is room for three lines (FANUC B-63522EN/02 page 222). Unconfirmed: the sign, which is
taken to be that of the pitch data.
"""

from __future__ import annotations

from collections.abc import Sequence

from compwright.formats.families.increments import parameters as known
from compwright.formats.text.scale import NotHeld

#: Amounts are 16-bit numbers.
AMOUNTS = (-32767, 32767)


def line_parameters(numbers: Sequence[int], amounts: Sequence[int]) -> dict[int, int]:
    """Return the parameters of the line through two point numbers with their amounts, detection
    units. Raises NotHeld for amounts that the control does not have.
    """
    low, high = AMOUNTS
    if not all(low <= amount <= high for amount in amounts):
        raise NotHeld(
            f"the line of inclination compensation would need the amounts {amounts[0]} and"
            f" {amounts[1]} (5871 to 5874); the control holds {low} to {high}"
        )
    (first, last), (begin, end) = numbers, amounts
    points = zip(known.INCLINATION_POINTS, (first, first, last, last), strict=True)
    return dict(points) | dict(
        zip(known.INCLINATION_AMOUNTS, (begin, begin, end, end), strict=True)
    )
