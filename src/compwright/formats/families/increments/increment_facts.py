"""What a FANUC's files state about the table sections of one axis."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.records.facts import AxisFacts


@dataclass(frozen=True, slots=True)
class PointNumber:
    """A point number in the files by which another function refers to the table of an axis.

    ``label``: the name of its parameter with the value. ``parameter``: the name alone, empty if the
    parameter does not belong to this axis alone.
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

    - ``reference_number``, ``first_number``, ``last_number``: the point numbers of the reference,
      the first and the last section, in the array that all axes share.
    - ``negative_first``: the first number of the data set for travel towards -; it is used if
      ``two_sets`` is true.
    - ``negative_offset``, ``backlash``, ``backlash_rapid``: in detection units.
    - ``separate_rapid``: rapid traverse has a backlash of its own.
    - ``inch``: the machine's unit is the inch.
    - ``rapid_feed``: in mm/min or deg/min.
    - ``unread``: point numbers whose contents no file states.
    - ``interval``: the width of the sections, mm or deg.
    - ``hung``: other functions that refer to point numbers of this table; their values stay.
    - ``first_stage``: the part of a smooth backlash that is put out at once, detection units.
    - ``inclined``: the existing inclination compensation in words, empty if there is none.
    - ``waved``: the existing second (cyclic) table in words, empty if there is none.
    - ``turn``: the travel of one turn on which the table is based, deg.
    - ``foreign``: point numbers of all second (cyclic) tables. None of them is free for a table.
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

        If the first number is one above that of the reference (a table of a full turn), the number
        of the reference is included.
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
