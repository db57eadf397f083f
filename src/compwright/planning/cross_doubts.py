"""Doubts about corrections between axes: made twice from one measurement, implausibly large, the
squareness of one plane on both axes, positions outside the travel.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, FloatArray
from compwright.records.plan import PlannedCross
from compwright.records.positioning import LARGEST_PLAUSIBLE
from compwright.words.sentences import Amount, say

#: What a good granite square is true to, rad: two values closer than this agree.
SQUARE: Final = 5e-6
#: What the largest usual increment of a table rounds, mm.
INCREMENT: Final = 1e-3
#: A change differs from an existing correction that was made from the same readings by less than
#: this share of it, also where these have fewer digits,
_EQUAL: Final = 0.005
#: or by the error of the comparison; it counts up to this share, because small corrections are not
#: all made from one measurement.
_SIMILAR: Final = 0.25
#: Less than this, mm or deg, beyond the travel is rounding.
_OUTSIDE: Final = 1e-6
_PPM: Final = 1e6
_PER_METRE: Final = 1e3  # rad in mm/m


def repeated(planned: PlannedCross, off: float, size: float, error: float) -> Iterator[Finding]:
    """Yield the doubt CW-P167 if a change of the ``size`` differs from the present correction
    hardly more than the ``error`` of this comparison: by ``off``, all in one unit. The table was
    then probably made from this very measurement.
    """
    if size > 0.0 and off <= max(_EQUAL * size, min(error, _SIMILAR * size)):
        unit = planned.added.output_kind.unit
        largest = Amount(_largest(planned) * outside_factor(unit), shown_unit(unit), ".1f")
        yield Finding.of(
            "CW-P167",
            "warning",
            (planned.input, planned.output),
            input=planned.input,
            output=planned.output,
            largest=largest,
        )


def too_large(planned: PlannedCross) -> Iterator[Finding]:
    """Yield the doubt CW-P168 if a change is larger than deviations and corrections usually are, or
    turns an axis by more than 1 mm/m. A circle shows the angle only, whatever the travel.
    """
    largest, unit = _largest(planned), str(planned.added.output_kind.unit)
    angle = abs(planned.squareness) * _PER_METRE
    if planned.source == "circle" and angle > LARGEST_PLAUSIBLE:
        largest, unit = angle, "mm/m"
    if largest > LARGEST_PLAUSIBLE:
        yield Finding.of(
            "CW-P168",
            "warning",
            (planned.input, planned.output),
            input=planned.input,
            output=planned.output,
            largest=Amount(largest, unit, ".4g"),
            unit=unit,
            source=planned.source,
        )


def outside_travel(planned: PlannedCross, given: Axis, where: FloatArray) -> Iterator[Finding]:
    """Yield the doubt CW-P170 if a position of ``where`` (n,), ascending, lies outside the travel
    of the axis ``given``. An endless axis has no position outside.
    """
    (low, high), unit = given.travel, given.kind.unit
    if given.endless:
        return
    if where[0] < low - _OUTSIDE or where[-1] > high + _OUTSIDE:
        ends = (Amount(float(end), unit, ".10g") for end in (where[0], where[-1], low, high))
        first, last, travel_start, travel_end = ends
        yield Finding.of(
            "CW-P170",
            "warning",
            (planned.input, planned.output),
            input=planned.input,
            output=planned.output,
            first=first,
            last=last,
            travel_start=travel_start,
            travel_end=travel_end,
        )


def has_slope(where: FloatArray, curve: FloatArray) -> bool:
    """Return whether a ``curve`` (n,), mm, measured at positions ``where`` (n,), ascending, mm,
    contains a squareness in addition to straightness.

    Straightness has the line through the end points or the least-squares line as its reference (ISO
    230-1): a curve of which either is parallel to the axis, to the accuracy of a square, has none.
    """
    ends = (curve[-1] - curve[0]) / (where[-1] - where[0])
    return bool(min(abs(ends), abs(np.polyfit(where, curve, 1)[0])) > SQUARE)


def both_sloped(sloped: Sequence[PlannedCross]) -> Iterator[Finding]:
    """Yield the doubt CW-P169 if there are two corrections ``sloped``, both of one plane. The
    angle of the plane is one value, and each of them removes a part of it.

    The sum is right if both were measured against one square. It is twice what is needed if each
    axis was measured against the other. The files do not show which.
    """
    if len(sloped) < 2:
        return
    slopes = [
        say("CW-P169.slope", input=one.input, output=one.output, slope=one.squareness * _PPM)
        for one in sloped
    ]
    yield Finding.of(
        "CW-P169",
        "warning",
        (sloped[0].input, sloped[0].output),
        plane="".join(sorted(sloped[0].pair)),
        slopes=slopes,
        total=sum(one.squareness for one in sloped) * _PPM,
    )


def _largest(planned: PlannedCross) -> float:
    """Return the largest amount of a correction between axes, mm or deg."""
    return float(np.max(np.abs([planned.added.positive, planned.added.negative])))
