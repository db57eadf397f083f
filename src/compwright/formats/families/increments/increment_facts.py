"""What a FANUC's files state about the table sections of one axis."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.records.facts import AxisFacts


@dataclass(frozen=True, slots=True)
class PointNumber:
    """A point number in the files by which another function refers to the table of an axis.

    ``label`` names it with its value; ``parameter`` is its name if it belongs to the axis alone,
    else empty.
    """

    number: int
    parameter: str
    label: str
    file: str
    start: int
    size: int


@dataclass(frozen=True, slots=True)
class FunctionOnPoints:
    """An active function that refers to point numbers of a table (``points``; None if its point
    numbers are unknown).
    """

    label: str
    points: tuple[PointNumber, ...] | None


@dataclass(frozen=True, slots=True, kw_only=True)
class IncrementFacts:
    """What the files state about an axis' table and backlash. A value is None if no file states it.

    ``reference_number``, ``first_number``, ``last_number``: the numbers of its sections in the
    array that all axes share, ``negative_first`` that of the set for travel towards -, which counts
    with ``two_sets``. ``negative_offset``, ``backlash``, ``backlash_rapid``: detection units.
    ``separate_rapid``: rapid traverse has a backlash of its own. ``inch``: the machine counts in
    inches. ``rapid_feed``: mm/min or deg/min. ``unread``: numbers whose contents no file states.
    ``interval``: the width of its sections, mm or deg. ``hung``: functions in addition to the table
    that depend on its numbers and are left alone. ``first_stage``: the part of the backlash that is
    output at once if the rest follows on the way, detection units. ``inclined``: the existing line
    of inclination compensation, in words; empty: none. ``waved``: the second table, the same.
    ``turn``: the travel of one turn that its table has, deg. ``foreign``: the numbers of second
    tables, wherever they are: none of them is free for a table.
    """

    reference_number: int | None = None
    first_number: int | None = None
    last_number: int | None = None
    magnification: int | None = None
    negative_first: int | None = None
    negative_offset: int | None = None
    two_sets: bool = False
    backlash: int | None = None
    backlash_rapid: int | None = None
    separate_rapid: bool | None = None
    inch: bool | None = None
    rapid_feed: float | None = None
    unread: frozenset[int] = frozenset()
    interval: float | None = None
    hung: tuple[FunctionOnPoints, ...] = ()
    first_stage: int = 0
    inclined: str = ""
    waved: str = ""
    turn: float | None = None
    foreign: tuple[range, ...] = ()

    @property
    def claimed(self) -> tuple[range, ...]:
        """The one or two ranges of point numbers that the axis uses; empty without a table.

        A full turn without the reference's own number claims that too.
        """
        first, last = self.first_number, self.last_number
        if first is None or last is None or first >= last:
            return ()
        if self.reference_number == first - 1:
            return (range(first - 1, last + 1),)
        own, second = range(first, last + 1), self.negative_first
        if not self.two_sets or second is None:
            return (own,)
        return own, range(second, second + len(own))


def increments_of(facts: AxisFacts) -> IncrementFacts:
    """Return what the files state about an axis' table sections; a record without values if they do
    not name the axis.
    """
    own = facts.of_family
    return own if isinstance(own, IncrementFacts) else IncrementFacts()
