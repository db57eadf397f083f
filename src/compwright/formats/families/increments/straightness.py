"""Straightness compensation, in which the position of one axis corrects another axis; it is read
only if options include it.

There are three pairs of axes: 5711 to 5713 state the moving axes, 5721 to 5723 the compensated
axes. Each pair has four point numbers of the moving axis (5731, 5741, 5751 and on). It also has
four amounts in detection units of the compensated axis (5761, 5771, 5781 and on).

The correction is a straight line between two points and zero at the reference position. It is put
out at the points (FANUC B-63522EN/02 page 222). Unconfirmed: the parameter numbers, and that a
positive amount moves the compensated axis towards +.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import (
    AxisParameters,
    Parameters,
    ParameterValue,
)
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray

#: Parameters of pairs of unknown meaning: if one is not 0, the active compensation is unknown.
_UNKNOWN = (
    *known.STRAIGHTNESS_MOVING[known.STRAIGHTNESS_PAIRS :],
    *known.STRAIGHTNESS_BENT[known.STRAIGHTNESS_PAIRS :],
    *(
        first + 10 * pair + place
        for first in (known.STRAIGHTNESS_POINTS[0], known.STRAIGHTNESS_AMOUNTS[0])
        for pair in range(known.STRAIGHTNESS_PAIRS)
        for place in range(known.STRAIGHTNESS_USED, known.STRAIGHTNESS_ROW)
    ),
    *range(5791, 5800),
    *known.STRAIGHTNESS_MORE,
)


@dataclass(frozen=True, slots=True)
class Pair:
    """A moving axis, the axis that it corrects, and the correction ``amounts`` at four points.

    ``bent``: the corrected axis. ``place``: the parameter that messages name.
    """

    moving: str
    bent: str
    points: tuple[int, ...]
    amounts: tuple[int, ...]
    place: ParameterValue

    def at(self, numbers: FloatArray, reference: int) -> FloatArray:
        """Return the correction at the point ``numbers`` (k,), minus the correction at the
        reference.
        """
        keep = np.concatenate([[True], np.diff(self.points) > 0])
        at, levels = np.compress(keep, self.points), np.compress(keep, self.amounts)
        lines = np.interp(np.append(numbers, reference), at, levels)
        return np.asarray(lines[:-1] - lines[-1])


def row_of(pair: int, *, amounts: bool = False) -> range:
    """Return the four parameter numbers that state the points of axis pair 0, 1 or 2, or
    (``amounts``) the corrections at these points.
    """
    rows = known.STRAIGHTNESS_AMOUNTS if amounts else known.STRAIGHTNESS_POINTS
    first = rows[0] + 10 * pair
    return range(first, first + known.STRAIGHTNESS_USED)


def straightness_pairs(
    parameters: Parameters, addresses: list[str], faults: list[Fault]
) -> Iterator[Pair]:
    """Yield the active axis pairs; a pair that cannot be used is a fault at its parameter."""
    unknown = (value for value in parameters.of(_UNKNOWN) if value.nonzero)
    faults += [
        value.fault("a straightness compensation that compwright does not know is active", "0")
        for value in unknown
    ]
    for value in parameters.of(known.STRAIGHTNESS_MOVING[: known.STRAIGHTNESS_PAIRS]):
        if not value.nonzero:
            continue
        number = value.number - known.STRAIGHTNESS_MOVING[0]
        bent = _own(parameters, value, [known.STRAIGHTNESS_BENT[0] + number])
        points, amounts = (
            tuple(each.whole for each in _own(parameters, value, row_of(number, amounts=kind)))
            for kind in (False, True)
        )
        names = [
            [one for one in addresses if AxisParameters(parameters, one).named_by(each)]
            for each in (value, *bent)
        ]
        steps = pairwise(zip(points, amounts, strict=False))
        disordered = any(a[0] > b[0] or (a[0] == b[0] and a != b) for a, b in steps)
        whole = len(points) == len(amounts) == known.STRAIGHTNESS_USED
        if [len(each) for each in names] != [1, 1] or not whole or disordered:
            message = f"{value.label}: straightness compensation cannot be counted"
            expected = "two axes, four points that ascend and four amounts"
            faults.append(value.fault(message, expected))
            continue
        yield Pair(names[0][0], names[1][0], points, amounts, value)


def _own(
    parameters: Parameters, value: ParameterValue, numbers: range | list[int]
) -> list[ParameterValue]:
    """Return those of the parameters ``numbers`` that have the same owner (axis, path or machine)
    as ``value``.
    """
    return [each for each in parameters.of(numbers) if each.whose == value.whose]


def unused_pairs(
    parameters: Parameters, moving: str
) -> Iterator[tuple[tuple[int, ...], dict[int, ParameterValue]]]:
    """Yield each axis pair of straightness compensation whose parameters are all zero or in no
    file: its ten parameter numbers, and by index (0 to 9) those of them that are in the files.

    Index 0 is the moving axis, 1 the compensated axis, 2 to 5 the points, 6 to 9 the amounts. If
    the parameters differ by path, those of the path of the axis ``moving`` are used.
    """
    own = AxisParameters(parameters, moving)
    for pair in range(known.STRAIGHTNESS_PAIRS):
        axes = known.STRAIGHTNESS_MOVING[pair], known.STRAIGHTNESS_BENT[pair]
        numbers = (*axes, *row_of(pair), *row_of(pair, amounts=True))
        values = [own.get(number) for number in numbers]
        found = {place: value for place, value in enumerate(values) if value is not None}
        if all(value.owner != "A" and not value.nonzero for value in found.values()):
            yield numbers, found


def free_pair(parameters: Parameters, moving: str) -> dict[int, ParameterValue] | None:
    """Return, by index (0 to 9), the parameters of the first axis pair of straightness compensation
    that is complete in the files and at zero. ``moving``: the moving axis, whose path counts.

    None if there is no such pair, or if the moving axis is not in the first path. In another path
    an axis number in these parameters may be counted within the path.
    """
    if (AxisParameters(parameters, moving).path or 1) != 1:
        return None
    pairs = unused_pairs(parameters, moving)
    return next((found for numbers, found in pairs if len(found) == len(numbers)), None)
