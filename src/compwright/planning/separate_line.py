"""A straight line in a separate table of the control, for a slope that whole increments reproduce
badly.

The line rises by a whole number of units per interval, so that it is exact at every table point.
The table corrects the rest, with smaller increments and a smaller step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.words.sentences import Amount

#: The line is worth it where it takes away more than this part of what is left at the points.
WORTH: Final = 0.1
#: Fits a table in addition to those that stay, within the limits of the control. Raises
#: CapacityError.
Fit = Callable[[Capacity, TableRequest], FittedTable]


def with_line(
    fit: Fit,
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    plain: FittedTable,
) -> FittedTable:
    """Return the table ``plain``, supplemented by a straight line in a separate table of the
    control. ``fit`` fits the main table again.

    The line is used only if it clearly reduces the error at the table points. Otherwise the result
    is ``plain`` alone. A finding states the errors with and without the line.
    """
    if capacity.slope is None or capacity.period is not None:
        return plain
    points, grid = plain.compensation.positions, request
    spacing = float(points[-1] - points[0]) / (points.size - 1)
    if not plain.keeps_grid:
        # The line is level up to the second point: one more section keeps that out of the travel.
        more = points[1] > wanted.positions[0]
        points = np.concatenate([points[:1] - spacing, points]) if more else points
        grid = replace(request, start=float(points[0]), end=float(points[-1]), spacing=spacing)
    line = _line(plain.compensation, points, capacity.slope, wanted.reference)
    if line is None:
        return plain
    with_line_there = replace(capacity, stays=(*capacity.stays, line), slope=None)
    try:
        inclined = fit(with_line_there, grid)
    except CapacityError:
        return plain
    left, left_with_line = (_left(wanted, each.compensation) for each in (plain, inclined))
    kind = wanted.kind
    factor, unit = outside_factor(kind.unit), shown_unit(kind.unit)
    slope = float(line.positive[-1] - line.positive[0]) / float(points[-1] - points[1])
    rise = (
        Amount(slope * factor * 1000, f"{unit}/m", "+.2f")
        if kind.unit == "mm"
        else Amount(slope, "", "+.6f")
    )
    alone, with_line_ = (Amount(each * factor, unit, ".3f") for each in (left, left_with_line))
    if left - left_with_line <= WORTH * left:
        found = Finding.of("CW-P142.table", "info", slope=rise, left=alone, with_line=with_line_)
        return replace(plain, findings=(*plain.findings, found))
    found = Finding.of("CW-P142.line", "info", slope=rise, left=alone, with_line=with_line_)
    return replace(inclined, findings=(*inclined.findings, found))


def _line(
    table: AxisCompensation, points: FloatArray, unit: float, reference: float
) -> AxisCompensation | None:
    """Return a straight line with the slope of ``table``, zero at the reference. None if the rise
    per interval rounds to zero units of the control, or with fewer than three points.
    """
    mean = (table.positive + table.negative) / 2
    if mean.size < 3:
        return None
    slope = float(np.polyfit(np.arange(mean.size, dtype=np.float64), mean, 1)[0])
    rise = round(slope / unit) * unit * np.maximum(np.arange(points.size), 1.0)
    if not np.any(rise):
        return None
    rise = rise - rise[int(np.argmin(np.abs(points - reference)))]
    return replace(table, positions=points, positive=rise, negative=rise, backlash=0.0, others=())


def _left(wanted: WantedCorrection, table: AxisCompensation) -> float:
    """Return the rms error that ``table`` leaves at its points within the travel, over both
    directions.
    """
    points, places = table.positions, wanted.positions
    inside = points[(points >= places[0]) & (points <= places[-1])]
    rest = [
        np.interp(inside, places, wanted.total(side)) - table.at(inside, side) for side in Direction
    ]
    return float(np.sqrt(np.mean(np.square(rest))))
