"""FANUC functions that are active in addition to an axis' table and stay unchanged.

These are inclination, straightness, the second (cyclic) table and three-dimensional compensation.

The new total correction is the old one minus the measured error. A function that is the same during
the test and afterwards therefore does not change the result, whatever its sign and unit. So it is
reported and left alone, as long as the grid that it depends on stays.

Sources: inclination and straightness FANUC B-63522EN/02 page 222, cyclic table A-78868E pages 3 and
6; further pairs, three-dimensional compensation: unconfirmed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.increment_facts import FunctionOnPoints, PointNumber
from compwright.formats.families.increments.parameters import AxisParameters, ParameterValue

#: Parameter groups that may compensate by the grid on a series where their meaning is unknown.
_MAY_COMPENSATE = {"inclination", "straightness", "cyclic", "spatial", "totals", "pitch_bits"}
#: The option of each function by which the user says that compwright may count and write it.
_ACROSS, _BENT = (
    "straightness compensation of another axis by this one",
    "straightness compensation of this axis by another one",
)
OPTION_OF = {
    "inclination compensation": "inclination",
    "the second (cyclic) table": "cyclic",
    _ACROSS: "straightness",
    _BENT: "straightness",
}


@dataclass(frozen=True, slots=True)
class Function:
    """A function, apart from table and backlash, that corrects an axis, with its parameters.

    ``points``: the parameters whose values are point numbers of the axis' own sections; None: it is
    unknown on which point numbers the function depends. ``moves``: the correction changes with the
    axis' own position.
    """

    words: str
    values: tuple[ParameterValue, ...]
    points: tuple[ParameterValue, ...] | None
    moves: bool = True

    @property
    def description(self) -> str:
        """The name of the function with its parameters and their values, as text."""
        return f"{self.words} ({', '.join(value.label for value in self.values)})"


def functions(own: AxisParameters) -> Iterator[Function]:
    """Yield every function that, by an axis' parameters ``own``, corrects the axis in addition to
    table and backlash.
    """
    yield from _inclination(own)
    cyclic = _nonzero(own, known.CYCLIC)
    if cyclic and cyclic[0].number != known.CYCLIC_FACTOR:
        yield Function("the second (cyclic) table", cyclic, None)
    yield from _straightness(own)
    spatial = tuple(
        value for value in own.all.of(known.SPATIAL) if value.nonzero and own.named_by(value)
    )
    if spatial:
        yield Function("three-dimensional error compensation", spatial, None)


def left_alone(every: Iterable[Function], options: Mapping[str, object]) -> list[Function]:
    """Return those of the functions ``every`` that stay unread and unchanged, because no option
    includes them.
    """
    return [
        function
        for function in every
        if options.get(OPTION_OF.get(function.words, "")) != "available"
    ]


def functions_on_points(
    own: AxisParameters, every: Iterable[Function]
) -> tuple[FunctionOnPoints, ...]:
    """Return those of the functions ``every`` that refer to point numbers of the axis, each with
    the places of these numbers in the files. ``own``: the axis' parameters.

    ``every``: all functions that correct this axis. Parameters of unknown meaning that may be a
    further compensation of this axis are returned too.
    """
    return tuple(
        FunctionOnPoints(
            label=f"{function.words}, {function.values[0].place}",
            points=None if function.points is None else tuple(map(_point, function.points)),
        )
        for function in every
        if function.points is None or function.points
    ) + tuple(
        FunctionOnPoints(label=f"perhaps further compensation, {value.place}", points=None)
        for value in own.all.unknown
        if known.NAMES[value.number] in _MAY_COMPENSATE
        and (value.owner != "A" or value.index == own.index)
    )


def straightness_functions(own: AxisParameters, alone: Sequence[Function]) -> str:
    """Return as text the parameters, with values, of straightness compensation; empty if no such
    function is among ``alone``, the functions that correct the axis and stay unchanged.
    """
    if all(each.words != _BENT for each in alone):
        return ""
    numbers = (
        *(*known.STRAIGHTNESS_MOVING, *known.STRAIGHTNESS_BENT),
        *(*known.STRAIGHTNESS_POINTS, *known.STRAIGHTNESS_AMOUNTS),
    )
    return ", ".join(value.label for value in own.all.of(numbers) if value.nonzero)


def _point(value: ParameterValue) -> PointNumber:
    return PointNumber(
        number=value.whole,
        parameter=str(value.number) if value.owner == "A" else "",
        label=value.label,
        file=value.file,
        start=value.start,
        size=len(value.text),
    )


def _nonzero(own: AxisParameters, numbers: tuple[int, ...]) -> tuple[ParameterValue, ...]:
    values = (own.get(number) for number in numbers)
    return tuple(value for value in values if value is not None and value.nonzero)


def _inclination(own: AxisParameters) -> Iterator[Function]:
    amounts = _nonzero(own, tuple(known.INCLINATION_AMOUNTS))
    if amounts:
        points = tuple(value for n in known.INCLINATION_POINTS if (value := own.get(n)) is not None)
        yield Function("inclination compensation", (*points, *amounts), points)


def _straightness(own: AxisParameters) -> Iterator[Function]:
    """Yield a function for each axis pair of straightness compensation that contains the axis with
    the parameters ``own``.

    The axis is the moving axis of the pair, to whose sections the point numbers refer, or the
    compensated axis. Further pairs whose axes are unknown are yielded too, because they may contain
    this axis.
    """
    for value in own.all.of(known.STRAIGHTNESS_MOVING):
        if not value.nonzero or not own.named_by(value):
            continue
        pair = value.number - known.STRAIGHTNESS_MOVING[0]
        words = _ACROSS
        if pair >= known.STRAIGHTNESS_PAIRS:
            yield Function(words, (value,), None)
            continue
        first = known.STRAIGHTNESS_POINTS[0] + 10 * pair
        row = [
            point
            for point in own.all.of(range(first, first + known.STRAIGHTNESS_ROW))
            if point.whose == value.whose
        ]
        points = tuple(one for one in row if one.number < first + known.STRAIGHTNESS_USED)
        more = tuple(one for one in row if one not in points and one.nonzero)
        yield Function(words, (value, *points, *more), None if more else points)
    for value in own.all.of(known.STRAIGHTNESS_BENT):
        if value.nonzero and own.named_by(value):
            yield Function(_BENT, (value,), (), moves=False)
    # Which axes the further pairs mean is not known: they may mean this one.
    more = tuple(value for value in own.all.of(known.STRAIGHTNESS_MORE) if value.nonzero)
    if more:
        yield Function("further straightness compensation", more, None)


def stays(function: Function) -> str:
    """Return the remark to the user about a function that stays unchanged."""
    if not function.moves:
        return (
            f"{function.description} is left as it is; it moves the axis by the position of another"
            " axis, which stands still in a test of this axis"
        )
    return (
        f"{function.description} is active in addition to the table and is left as it is: it was"
        " active in the tests and is the same afterwards, so it cancels, and is in none of the"
        " numbers shown here. It depends on the grid: do not change it, or the numbers that"
        " define it, before the new table is verified"
    )
