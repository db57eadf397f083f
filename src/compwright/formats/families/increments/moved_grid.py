"""Change the point numbers of a table together with those in functions that refer to them.

If that is impossible, the new table is refused, and the message names the parameter.
"""

from __future__ import annotations

from compwright.formats.families.increments.increment_facts import (
    FunctionOnPoints,
    IncrementFacts,
    PointNumber,
)
from compwright.formats.families.increments.numbering import NumberPlace
from compwright.formats.text.scale import NotHeld
from compwright.records.axis import Axis

#: Tolerance of a position at a point, in spacings: rounding of floating point.
_ON_GRID = 1e-6
_HELP = (
    "leave `spacing`, `start` and `end` out of `table`, so that the existing points stay, or"
    " remove the function from the control and measure again"
)


def moved_numbers(
    axis: Axis, facts: IncrementFacts, place: NumberPlace, interval: float, magnification: int
) -> tuple[tuple[PointNumber, int], ...]:
    """Return those point numbers in the parameters of other functions that the new table changes,
    each with its new number. ``place``, ``interval`` (mm or deg), ``magnification``: those of the
    new table.

    The result is empty if the positions keep their point numbers. Raises NotHeld with the name of
    the first function whose effect the new table would change.
    """
    for each in facts.hung:
        _check_kept(each, facts, magnification)
    if not facts.hung or _stays(axis, facts, place, interval):
        return ()
    return tuple(
        (point, new)
        for each in facts.hung
        for point in _known(each, facts, place, interval)
        if (new := _point_in_place(axis, each, point, facts, place, interval)) != point.number
    )


def check_sets(facts: IncrementFacts, *, two: bool) -> None:
    """Raise NotHeld if other functions refer to the existing table and the new one has two data
    sets (``two``) instead of one, or one instead of two.

    The error names the first such function: it is not known whether its effect is the same with one
    and with two data sets.
    """
    for each in facts.hung if two is not facts.two_sets else ():
        mode = "bidirectional" if facts.two_sets else "single"
        raise NotHeld(
            f"{each.label}, is active with {_sets(two=facts.two_sets)}; whether it is the same with"
            f" {_sets(two=two)} is not known: 3605#0 would change from"
            f" {int(facts.two_sets)} to {int(two)}; table: {{mode: {mode}}} keeps it, or"
            " remove the function from the control and measure again"
        )


def _sets(*, two: bool) -> str:
    return "two sets of data" if two else "one set of data"


def _stays(axis: Axis, facts: IncrementFacts, place: NumberPlace, interval: float) -> bool:
    """Return whether every point number keeps its position when the new table is written.
    ``place``, ``interval``: point numbers and interval of the new table.
    """
    if (facts.reference_number, facts.interval) != (place.reference, interval):
        return False
    if axis.modulo is not None:  # a full turn, with or without the reference's own number
        return True
    low, high = ((end - axis.reference) / interval for end in axis.travel)
    old, new = (facts.first_number, facts.last_number), (place.first, place.last)
    first, last = (
        [int(number or 0) - place.reference for number in numbers]
        for numbers in zip(old, new, strict=True)
    )
    below = first[0] == first[1] or max(first) - 1 <= low + _ON_GRID
    above = last[0] == last[1] or min(last) >= high - _ON_GRID
    return below and above


def _check_kept(each: FunctionOnPoints, facts: IncrementFacts, magnification: int) -> None:
    """Raise NotHeld if the function ``each`` refers to points of a table that is not active, or
    that gets another magnification.

    Its effect with the new table would be unknown.
    """
    if not facts.magnification or facts.first_number == facts.last_number:
        raise NotHeld(
            f"{each.label}, is set, but its table is off. A new table may make it active, and"
            " its effect was not measured. Set it to 0, or switch it on and measure with it"
        )
    if magnification != facts.magnification:
        raise NotHeld(
            f"{each.label}, is active in addition to a table with 3623 = "
            f"{facts.magnification}, and whether that"
            f" multiplies it is not known; the new table needs 3623 = {magnification}"
        )


def _known(
    each: FunctionOnPoints, facts: IncrementFacts, place: NumberPlace, interval: float
) -> tuple[PointNumber, ...]:
    if each.points is None:
        raise NotHeld(
            f"{each.label}, is active in addition to the table, and the numbers that it "
            "depends on are unknown:"
            f" {_grids(facts, place, interval)}; {_HELP}"
        )
    return each.points


def _point_in_place(
    axis: Axis,
    each: FunctionOnPoints,
    point: PointNumber,
    facts: IncrementFacts,
    place: NumberPlace,
    interval: float,
) -> int:
    """Return the new number of a point to which the function ``each`` refers. Raises NotHeld if the
    new table (``place``, ``interval``) has no point at the same position.
    """
    old, first, last = (
        int(number or 0)
        for number in (facts.reference_number, facts.first_number, facts.last_number)
    )
    steps = (point.number - old) * float(facts.interval or 0.0) / interval
    new = place.reference + round(steps)
    on_point = abs(steps - round(steps)) <= _ON_GRID
    inside = first - 1 <= point.number <= last and place.first - 1 <= new <= place.last
    if on_point and inside:
        return new
    why = (
        "is not a point of the new table"
        if not on_point
        else "lies outside the old or the new grid"
    )
    help_ = _old_ends(axis, facts, interval) if on_point else _HELP
    raise NotHeld(
        f"{each.label}, is active in addition to the table: the position of {point.label} {why}"
        f" ({_grids(facts, place, interval)}); {help_}"
    )


def _old_ends(axis: Axis, facts: IncrementFacts, interval: float) -> str:
    """Return the advice to keep the table's old ends, if the new interval divides the old one."""
    old = float(facts.interval or 0.0)
    ratio = old / interval
    if axis.modulo is not None or round(ratio) < 1 or abs(ratio - round(ratio)) > _ON_GRID:
        return _HELP
    reference, first, last = (
        int(number or 0)
        for number in (facts.reference_number, facts.first_number, facts.last_number)
    )
    low, high = (axis.reference + (end - reference) * old for end in (first - 1, last))
    return f"table: {{start: {low:g}, end: {high:g}}}, the old ends, would keep it, or {_HELP}"


def _grids(facts: IncrementFacts, place: NumberPlace, interval: float) -> str:
    return (
        f"3620 to 3622 are {facts.reference_number}, {facts.first_number}, {facts.last_number} with"
        f" an interval of {facts.interval:g}, the new grid would be {place.reference},"
        f" {place.first}, {place.last} with {interval:g}"
    )
