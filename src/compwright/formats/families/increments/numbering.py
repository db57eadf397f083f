"""Assign point numbers to axes: their existing numbers, or the first free block of the array."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import chain

from compwright.formats.families.increments.increment_facts import IncrementFacts, increments_of
from compwright.records.correction import ControlState


class NoRoom(ValueError):  # noqa: N818 - it says what is the matter, and never leaves the room
    """Raised if no block of free point numbers is long enough for a table."""


@dataclass(frozen=True, slots=True)
class NumberPlace:
    """The point numbers of one axis: numbers of the reference, of the first section and of the last
    section.
    """

    reference: int
    first: int
    last: int
    negative_first: int | None = None

    @property
    def ranges(self) -> tuple[range, ...]:
        """The one or two ranges of the axis' point numbers; the second is for travel towards -."""
        own = range(self.first, self.last + 1)
        if self.negative_first is None:
            return (own,)
        return own, range(self.negative_first, self.negative_first + len(own))


def find_place(
    low: int,
    high: int,
    *,
    highest: int,
    used: Sequence[range],
    two: bool,
    reference: int | None,
    negative: int | None = None,
    claimed: Sequence[range] = (),
    start: int,
) -> NumberPlace:
    """Return the point numbers of a table that reaches from ``low`` to ``high``, in intervals from
    the reference. ``highest``: the control's last number; ``used``: numbers that are not free;
    ``two``: one data set per direction; ``start``: the first number to use.

    - ``low`` and ``high``: whole numbers with low <= 0 <= high.
    - ``reference``: the existing number of the reference. It is kept if the table still fits there.
    - ``negative``: the existing first number of the set for travel towards -. It is kept likewise.
    - ``claimed``: all existing numbers of the axis. They are tried before the free numbers from
      ``start`` on.

    The set for travel towards - has as many numbers as the other set. Raises NoRoom if too few
    successive numbers are free.
    """
    first, last = section_numbers(low, high)
    length = last - first + 1
    if reference is not None:
        kept = _at(reference, first, last, two=two)
        both = [replace(kept, negative_first=negative)] if two and negative is not None else []
        for place in (*both, kept):
            if _free(place, highest, used):
                return place
    needed = length * (2 if two else 1)
    own = (range(one.start, one.stop + 1 - needed) for one in claimed)
    for begin in chain(*own, range(start, highest + 2 - needed)):
        place = _at(begin - first, first, last, two=two)
        if _free(place, highest, used):
            return place
    gap = longest_gap(highest, used, start)
    raise NoRoom(
        f"the table needs {needed} point numbers in a row; the longest row that"
        f" no other axis uses has {gap} (numbers {start} to {highest}); a wider spacing or a"
        " shorter table would help, or files that show the contents of more numbers"
    )


def section_numbers(low: int, high: int) -> tuple[int, int]:
    """Return the first and the last number of new sections from ``low`` to ``high``, all counted
    from the reference: the first is never above that of the reference, the last one always is.
    """
    return min(low + 1, 0), max(high, 1)


def kept_place(
    low: int,
    high: int,
    facts: IncrementFacts,
    *,
    highest: int,
    used: Sequence[range],
    two: bool,
    endless: bool,
) -> NumberPlace | None:
    """Return the existing point numbers of an axis; None if a table from ``low`` to ``high``
    (intervals from the reference) needs other numbers, or if other axes use them. ``two``: one data
    set per direction; ``endless``: the axis is endless.

    If the second data set does not exist yet, it gets the first free numbers after the table.
    """
    reference, first, last = facts.reference_number, facts.first_number, facts.last_number
    if reference is None or first is None or last is None or first >= last:
        return None
    # Round a turn the first section begins at the reference, whose own number may be left out on
    # an endless axis; with ends, 3621 must not lie above 3620.
    round_turn = low == 0 and (first == reference or (endless and first == reference + 1))
    if first > reference and not round_turn:
        return None
    if high != last - reference or not (round_turn or low == first - 1 - reference):
        return None
    place = NumberPlace(reference, first, last)
    if two:
        there = facts.negative_first if facts.two_sets else None
        starts = range(last + 1, highest + 2 - len(place.ranges[0])) if there is None else [there]
        places = (NumberPlace(reference, first, last, start) for start in starts)
        return next((one for one in places if _free(one, highest, used)), None)
    return place if _free(place, highest, used) else None


def first_free(length: int, used: Sequence[range], start: int, highest: int) -> int | None:
    """Return the lowest of ``length`` successive point numbers from ``start`` to ``highest`` that
    are not in ``used``; None if there are not as many.
    """
    for begin in range(start, highest + 2 - length):
        if not any(begin < taken.stop and taken.start < begin + length for taken in used):
            return begin
    return None


def longest_gap(highest: int, used: Sequence[range], start: int = 0) -> int:
    """Return the length of the longest block of numbers from ``start`` to ``highest`` that are not
    in ``used``.
    """
    longest, place = 0, start
    for taken in sorted((one for one in used if len(one)), key=lambda one: one.start):
        longest = max(longest, min(taken.start, highest + 1) - place)
        place = max(place, taken.stop)
    return max(longest, highest + 1 - place)


def used_numbers(state: ControlState, without: Iterable[str]) -> list[range]:
    """Return the point numbers in use, except those of the axes ``without``.

    Three kinds of numbers are in use:

    - numbers of the tables of other axes, also of a table that is switched off;
    - numbers that contain data, unless they belong to the tables of the axes ``without``;
    - numbers of second (cyclic) tables, even if they belong to the tables of the axes ``without``.
    """
    left_out = set(without)
    claims = {address: increments_of(facts).claimed for address, facts in state.facts.items()}
    own = [numbers for address in left_out for numbers in claims.get(address, ())]
    others = sorted(
        number for number in state.reserved if not any(number in numbers for numbers in own)
    )
    return [
        *(numbers for one, each in claims.items() if one not in left_out for numbers in each),
        *(range(number, number + 1) for number in others),
        *(
            numbers
            for one in sorted(left_out)
            for numbers in increments_of(state.facts_of(one)).foreign
        ),
    ]


def _at(reference: int, first: int, last: int, *, two: bool) -> NumberPlace:
    begin, end = reference + first, reference + last
    return NumberPlace(reference, begin, end, end + 1 if two else None)


def _free(place: NumberPlace, highest: int, used: Sequence[range]) -> bool:
    own, *second = place.ranges
    return not any(_meet(own, other) for other in second) and all(
        numbers.start >= 0
        and numbers.stop - 1 <= highest
        and not any(_meet(numbers, taken) for taken in used)
        for numbers in place.ranges
    )


def _meet(one: range, other: range) -> bool:
    return one.start < other.stop and other.start < one.stop
