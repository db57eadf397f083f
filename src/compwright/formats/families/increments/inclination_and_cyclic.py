"""Inclination compensation and second (cyclic) table of a FANUC axis, on controls with both.

Inclination compensation is three straight lines through four points, each given by its point number
and an amount in detection units. It is put out at the points and added to the pitch data (FANUC
B-63522EN/02 page 222). It is zero at the reference position, and outside the four points it keeps
the end values.

The second table has the point numbers from 14985 to 14986 (values of these parameters). The first
of them is the start of the period. Each further one belongs to one section of the period. Its
increments have the same form as in the main table, and their sum is 0 (A-78868E pages 3 and 6).

Three facts are unconfirmed: both have the sign of the pitch data, 3623 does not multiply them, and
the period starts at the reference position.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from itertools import pairwise

import numpy as np

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import INCH, IncrementAxisValues
from compwright.formats.families.increments.neighbour_functions import (
    OPTION_OF,
    Function,
    functions,
)
from compwright.formats.families.increments.numbering import first_free
from compwright.formats.families.increments.parameters import ParameterValue
from compwright.formats.families.increments.sections import IncrementSections
from compwright.formats.text.scale import NotHeld
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import AxisCompensation

#: Points and totals there, both (k,) mm or deg, and the period after which they repeat; None:
#: never.
Curve = tuple[FloatArray, FloatArray, float | None]
#: Returns the increments (k,) of some numbers; None where one is missing.
Increments = Callable[[range], FloatArray | None]

_EVIDENCE = {
    "inclination": "unconfirmed: sign of the pitch data, detection units, not multiplied by 3623",
    "cyclic": "unconfirmed: sign of the pitch data, not multiplied by 3623, its period starts at"
    " the reference position",
}


class _NotCountedError(Exception):
    """Raised if a parameter makes a function unreadable; ``expected``: the values with which the
    function can be read.
    """

    def __init__(self, value: ParameterValue, how: str, expected: str) -> None:
        super().__init__(how)
        self.value = value
        self.how = how
        self.expected = expected


def counted(
    values: IncrementAxisValues,
    kind: AxisKind,
    options: Mapping[str, object],
    increments: Increments,
) -> Counted:
    """Return the inclination compensation and the cyclic table of an axis, each only if it is
    active and an option includes it. ``increments``: a function that returns the increments at
    given point numbers.
    """
    wanted = [
        (OPTION_OF[each.words], each)
        for each in functions(values.own)
        if OPTION_OF.get(each.words) in _EVIDENCE and options[OPTION_OF[each.words]] == "available"
    ]
    for name, function in wanted:
        fact = f"{values.label}: {function.words}"
        values.notes.assume(fact, f"counted as {function.description}", _EVIDENCE[name])
    return Counted(values, kind, dict(wanted), increments)


class Counted:
    """Those of the two functions, inclination compensation and cyclic table, that are read as part
    of one axis' compensation.
    """

    def __init__(
        self,
        values: IncrementAxisValues,
        kind: AxisKind,
        functions: Mapping[str, Function],
        increments: Increments,
    ) -> None:
        self.values = values
        self.kind = kind
        self.functions = functions
        self.increments = increments

    def curves(
        self, sections: IncrementSections | None, points: FloatArray, zero: float, scale: float
    ) -> Iterator[Curve]:
        """Yield the corrections by inclination compensation and by the cyclic table, which the
        control adds to the correction by the table at its points ``points``. ``zero``: the
        reference position; ``scale``: mm or deg per detection unit, with sign.

        If one of these corrections cannot be calculated, a fault is added to the notes.
        """
        try:
            if "inclination" in self.functions:
                function = self.functions["inclination"]
                yield points, self._inclination(function, sections, points, zero) * scale, None
            if "cyclic" in self.functions:
                interval, sums = self._cyclic(self.functions["cyclic"])
                places = np.round(zero + interval * np.arange(sums.size), 9)
                yield places, sums * scale, interval * (sums.size - 1)
        except _NotCountedError as error:
            message = (
                f"{self.values.label}: {error.value.label} cannot be counted: it is {error.how}"
            )
            self.values.notes.once(error.value.fault(message, error.expected))

    def _inclination(
        self,
        function: Function,
        sections: IncrementSections | None,
        points: FloatArray,
        zero: float,
    ) -> FloatArray:
        """Return the correction by inclination at the table's points ``points``, in detection
        units; it is zero at the reference position ``zero``.
        """
        own = self.values.own
        corners, amounts = (
            [own.get(number) for number in numbers]
            for numbers in (known.INCLINATION_POINTS, known.INCLINATION_AMOUNTS)
        )
        if sections is None:
            raise _NotCountedError(function.values[0], "without a grid", "3620 to 3624")
        if any(value is None for value in (*corners, *amounts)):
            raise _NotCountedError(
                function.values[0], "not given whole", "5861 to 5864, 5871 to 5874"
            )
        at, levels = (
            [value.whole for value in values if value is not None] for values in (corners, amounts)
        )
        pairs = pairwise(zip(at, levels, strict=True))
        if any(one[0] > two[0] or (one[0] == two[0] and one != two) for one, two in pairs):
            raise _NotCountedError(function.values[0], "not in order", "numbers that ascend")
        numbers = sections.reference + np.round((points - zero) / sections.interval)
        keep = np.concatenate([[True], np.diff(at) > 0])
        line = np.interp(
            np.append(numbers, sections.reference), np.compress(keep, at), np.compress(keep, levels)
        )
        return np.asarray(line[:-1] - line[-1])

    def _cyclic(self, function: Function) -> tuple[float, FloatArray]:
        """Return the cyclic table: interval (mm or deg), sums (k,) at section ends (detection
        units).
        """
        own, first = self.values.own, function.values[0]
        ends = [own.get(number) for number in (known.CYCLIC_FIRST, known.CYCLIC_LAST)]
        low, high = (0 if value is None else value.whole for value in ends)
        interval = self._interval(own.get(known.CYCLIC_INTERVAL))
        factor = own.get(known.CYCLIC_FACTOR)
        if high <= low or interval is None:
            raise _NotCountedError(first, "not given whole", "14985 < 14986, 14987 above 0")
        if factor is not None and factor.whole not in (0, 1):
            raise _NotCountedError(factor, "multiplied, which is not known well", "0 or 1")
        counts = self.increments(range(low + 1, high + 1))
        if counts is None:
            raise _NotCountedError(first, "without its pitch data", "the whole pitch data")
        if np.sum(counts) != 0:
            raise _NotCountedError(
                first, f"adding up to {np.sum(counts):g} in one period", "a sum of 0"
            )
        return interval, np.concatenate([[0.0], np.cumsum(counts)])

    def _interval(self, value: ParameterValue | None) -> float | None:
        if value is None or not value.nonzero:
            return None
        inch = self.values.in_inches(value.key, self.kind)
        return float(Decimal(value.text) * (INCH if inch else 1))


#: Amounts are 16-bit numbers.
AMOUNTS = (-32767, 32767)


@dataclass(frozen=True, slots=True)
class InclinationAndCyclic:
    """New inclination and cyclic tables: parameter texts by number, increments by point number."""

    parameters: Mapping[int, str] = field(default_factory=dict)
    points: Mapping[int, int] = field(default_factory=dict)


def line_parameters(numbers: Sequence[int], amounts: Sequence[int]) -> dict[int, str]:
    """Return the inclination parameters for a line through two points. Raises NotHeld if an amount
    is too large for the control.
    """
    low, high = AMOUNTS
    if not all(low <= amount <= high for amount in amounts):
        raise NotHeld(
            f"the line of inclination compensation would need the amounts {amounts[0]} and"
            f" {amounts[1]} (5871 to 5874); the control can store {low} to {high}"
        )
    (first, last), (begin, end) = numbers, amounts
    points = zip(known.INCLINATION_POINTS, (first, first, last, last), strict=True)
    levels = zip(known.INCLINATION_AMOUNTS, (begin, begin, end, end), strict=True)
    return {number: str(value) for number, value in (*points, *levels)}


def second_table(
    totals: FloatArray, interval: str, used: Sequence[range], start: int, highest: int
) -> InclinationAndCyclic:
    """Return a second (cyclic) table with the correction ``totals`` (k,) at its section ends. Its
    points get the first free numbers from ``start`` to ``highest``; ``used``: numbers that are not
    free.

    ``totals`` is in detection units. ``interval``: the width of the sections, as text. Raises
    NotHeld if too few successive numbers are free.
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
    """Return whether the table ``other`` repeats with a period that ``table`` does not have."""
    return other.period is not None and other.period != table.period
