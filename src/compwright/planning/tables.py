"""Fitting of the best table of one axis within the limits of the control.

The fit uses the existing grid if that is suitable, and otherwise a new grid. If it uses the
existing one, it states how much a new grid would improve the axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from compwright.fitting.fit import fit_table
from compwright.fitting.grid_losses import good_enough
from compwright.fitting.truncation import range_faults, truncation_faults
from compwright.foundations.errors import CapacityError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.predicted_gain import judged_parameter, parameter_spread
from compwright.planning.repeating_table import with_repeating_table
from compwright.planning.separate_line import with_line
from compwright.planning.wanted_correction import without_kept_tables
from compwright.records.axis import Axis, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.prediction import TestPrediction
from compwright.words.sentences import Amount, Sentence, say

#: The finding that a new grid is chosen.
NEW_GRID: Final = "CW-P140"
#: What a table may lose against the best one: µm or arcsec of what a test shows.
NEXT_TO_NOTHING: Final = 0.1


def fit_within(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, axis: Axis
) -> FittedTable:
    """Return the fitted table of an axis. Existing tables that stay active are taken into account.

    A separate line and a repeating table are used if the control has them and they reduce the
    error. Raises CapacityError if the table that the control can hold differs from the wanted
    correction by more than the noise of a reading.
    """

    def fit(limits: Capacity, requested: TableRequest) -> FittedTable:
        own = without_kept_tables(wanted, limits.stays)
        raise_all(CapacityError, list(range_faults(own, limits)))
        table = fit_remaining(wanted, limits, requested, axis)
        raise_all(CapacityError, list(truncation_faults(table, own, limits)))
        return table

    plain = fit_keeping_grid(partial(fit, capacity), capacity, request, axis)
    inclined = with_line(fit, wanted, capacity, request, plain)
    table = with_repeating_table(fit, wanted, capacity, request, inclined)
    moved = (one for one in plain.findings if one.code == NEW_GRID)
    return replace(table, findings=tuple(dict.fromkeys((*moved, *table.findings))))


def fit_remaining(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    axis: Axis,
    *,
    costs: bool = True,
) -> FittedTable:
    """Return the table that, added to the existing tables that stay active, gives the wanted
    correction. With ``costs``, the table states the error that each limit of the control adds.

    Raises CapacityError if the control cannot hold the table.
    """
    own = without_kept_tables(wanted, capacity.stays)
    table = fit_table(own, capacity, request, address=axis.address, costs=costs)
    return replace(table, compensation=replace(table.compensation, others=capacity.stays))


def fit_keeping_grid(
    fit: Callable[[TableRequest], FittedTable],
    capacity: Capacity,
    request: TableRequest,
    axis: Axis,
) -> FittedTable:
    """Return the table that ``fit`` gives on the existing table points. If no table on these points
    is possible, use new points and add a warning.

    Raises the CapacityError of ``fit`` for the new points, if these are used.
    """
    try:
        return fit(request)
    except CapacityError as error:
        if not (request.keeps and capacity.there) or capacity.points is not None:
            raise
        why = "; ".join(str(fault) for fault in error.faults)
    chosen, unit = fit(replace(request, spacing="auto")), axis.kind.unit
    new = grid_text(chosen.compensation.positions, unit)
    return replace(
        chosen,
        findings=(
            Finding.of(
                "CW-P140",
                "warning",
                axis=axis.name,
                grid=new,
                existing=grid_text(np.array(capacity.there), unit),
                why=why,
            ),
            *chosen.findings,
        ),
    )


def free_grid_table(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    table: FittedTable,
    axis: Axis,
) -> FittedTable | None:
    """Return a table on freely chosen points if the existing points of ``table`` leave too large an
    interpolation error, else None.
    """
    held = table.compensation
    own = without_kept_tables(wanted, held.others)
    if not table.keeps_grid or good_enough(held.positions, own, capacity):
        return None
    try:
        return fit_within(wanted, capacity, replace(request, spacing="auto"), axis)
    except CapacityError:
        return None


def negligible_loss(kept: TestPrediction, best: TestPrediction) -> bool:
    """Return whether predicted tests with one table (``kept``) are almost as good as those with the
    best table (``best``).

    The tests are compared at the same targets and at new ones, by the parameter `judged_parameter`.
    """
    name = judged_parameter(best.before)
    if name is None:
        return False
    factor = outside_factor(best.before.test.kind.unit)
    return all(
        abs(mine[name].median) - abs(other[name].median) < NEXT_TO_NOTHING / factor
        for mine, other in (
            (kept.predicted, best.predicted),
            (kept.predicted_new_targets, best.predicted_new_targets),
        )
    )


def grid_text(points: FloatArray, unit: str) -> Sentence:
    """Return the points of a table as text: "25 points from 0 to 960 mm, every 40 mm"."""
    if points.size < 2:
        return say("grid.few", points=points.size)
    steps = np.diff(points)
    least, most = float(np.min(steps)), float(np.max(steps))
    start, end = points[0], points[-1]
    if most - least <= 1e-6 * most:
        return say("grid.even", points=points.size, start=start, end=end, unit=unit, step=most)
    return say(
        "grid.uneven",
        points=points.size,
        start=start,
        end=end,
        unit=unit,
        least=least,
        most=most,
    )


def new_grid_offer(
    axis: Axis,
    there: FloatArray,
    chosen: FittedTable,
    kept: TestPrediction,
    offered: TestPrediction,
    *,
    quantum: float,
    written: bool,
) -> Finding | None:
    """Return the finding that the ``chosen`` table, with new points, is better than a table at the
    existing points ``there`` (mm or deg), or None if it is not better. ``kept`` and ``offered``:
    tests predicted with the existing points (without a table if none is ``written``) and with the
    new points.

    A gain is large enough if it exceeds both ``quantum``, the control's resolution, and one
    standard deviation of the parameter between tests.
    """
    name = judged_parameter(kept.before)
    if name is None:
        return None
    pairs = [
        (kept.predicted[name], offered.predicted[name]),
        (kept.predicted_new_targets[name], offered.predicted_new_targets[name]),
    ]
    if not any(
        mine.median - other.median > max(quantum, parameter_spread(mine)) for mine, other in pairs
    ):
        return None
    unit = axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    (same, better), (new, better_new) = (
        [Amount(one.median * factor, small) for one in pair] for pair in pairs
    )
    old, new_grid = (grid_text(points, unit) for points in (there, chosen.compensation.positions))
    return Finding.of(
        "CW-P141",
        "info",
        axis=axis.name,
        stays=written,
        existing=old,
        parameter=name,
        same=same,
        new=new,
        grid=new_grid,
        better=better,
        better_new=better_new,
    )
