"""Replacement of the best table by one that is easier to load, if tests would show almost no
difference.

The easier table keeps the magnification set in the control, and has fewer points if a person types
them in.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from compwright.fitting.grid import possible_grids
from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.predicted_gain import judged_parameter
from compwright.planning.tables import fit_within, grid_text, negligible_loss
from compwright.records.axis import Axis, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.prediction import TestPrediction
from compwright.words.sentences import say

#: What a test like the first one shows with a table.
Shown = Callable[[FittedTable], TestPrediction]
_Found = tuple[FittedTable, TestPrediction]
#: Fewer points are taken where they are at most this part of the best number.
_FEWER: Final = 0.9
#: So many coarser grids in a row have to be too coarse.
_NEXT: Final = 3
#: The finding that fewer points are typed, and what all of them would give.
FEWER_POINTS: Final = "CW-P144"


def practical_table(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    axis: Axis,
    shown: Shown,
) -> tuple[Capacity, FittedTable]:
    """Return the control's limits, narrowed if needed, and the fitted table: the easiest to load
    that is good enough. ``shown`` returns the predicted test for a table. Raises CapacityError if
    the control can hold no table.
    """
    capacity, table = _with_kept_magnification(wanted, capacity, request, axis, shown)
    if capacity.typed and request.named_spacing is None:
        table = _with_fewest_points(wanted, capacity, request, axis, shown, table)
    return capacity, table


def planned_request(
    capacity: Capacity, request: TableRequest, planned: FittedTable
) -> tuple[Capacity, TableRequest]:
    """Return the limits and the requested table points with which a new fit gives the ``planned``
    table again.

    They contain the magnification if the plan kept the one in the control, and the reduced number
    of points of a table that is typed in.
    """
    lattice, points = capacity.lattice, planned.compensation.positions
    kept = None if lattice is None else lattice.there
    stayed = kept is not None and planned.certificate.get("magnification") == kept
    if lattice is not None and kept is not None and stayed:
        capacity = replace(capacity, lattice=replace(lattice, magnifications=(kept,)))
    few = any(finding.code == FEWER_POINTS for finding in planned.findings)
    return capacity, _covering(request, points, 0) if capacity.typed and few else request


def _with_kept_magnification(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, axis: Axis, shown: Shown
) -> tuple[Capacity, FittedTable]:
    """Return the control's limits and the best table. The table keeps the magnification set in the
    control if the test that ``shown`` predicts for it shows almost no difference.

    A new magnification is a risk. If it is loaded without its increments, or these are loaded
    without it, the control multiplies the whole table by a wrong factor.
    """
    lattice = capacity.lattice
    best = fit_within(wanted, capacity, request, axis)
    there = None if lattice is None else lattice.there
    if lattice is None or there is None or best.certificate.get("magnification") == there:
        return capacity, best
    staying = replace(capacity, lattice=replace(lattice, magnifications=(there,)))
    try:
        kept = fit_within(wanted, staying, request, axis)
    except CapacityError:
        return capacity, best
    return (staying, kept) if negligible_loss(shown(kept), shown(best)) else (capacity, best)


def _with_fewest_points(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    axis: Axis,
    shown: Shown,
    best: FittedTable,
) -> FittedTable:
    """Return the table with the fewest points that is almost as good as the ``best`` table in the
    tests that ``shown`` predicts. Existing table points are kept.
    """
    points = best.compensation.positions
    if (
        best.keeps_grid
        or capacity.points is not None
        or capacity.line is not None
        or points.size < 3
    ):
        return best
    aim = shown(best)

    def enough(grid: FloatArray) -> _Found | None:
        covering = _covering(request, grid, capacity.cover)
        try:
            fewer = fit_within(wanted, capacity, covering, axis)
        except CapacityError:
            return None
        found = shown(fewer)
        return (fewer, found) if negligible_loss(found, aim) else None

    most = int(_FEWER * points.size) - 2 * capacity.cover
    grids = possible_grids(wanted, capacity, request, most)
    taken = _fewest(grids, enough)
    if taken is None:
        return best
    fewer, found = taken
    finding = _fewer_points(axis, fewer, best, found, aim)
    return replace(fewer, findings=(*fewer.findings, finding))


def _fewest(
    grids: Sequence[FloatArray], enough: Callable[[FloatArray], _Found | None]
) -> _Found | None:
    """Return a good table on one of the coarsest ``grids`` and the test predicted for this table,
    or None if there is none. ``enough`` returns both for a grid whose table is good enough, else
    None.

    The search halves the range of grids, because more points are usually better. Then it tries the
    next coarser grids one by one.
    """
    low, high = 0, len(grids)
    best: _Found | None = None
    while low < high:
        middle = (low + high) // 2
        found = enough(grids[middle])
        if found is None:
            low = middle + 1
        else:
            best, high = found, middle
    missed = 0
    while best is not None and high > 0 and missed < _NEXT:
        high -= 1
        found = enough(grids[high])
        best, missed = (best, missed + 1) if found is None else (found, 0)
    return best


def _covering(request: TableRequest, grid: FloatArray, cover: int) -> TableRequest:
    """Return the request with the spacing of ``grid``. Where the job states no end, the points
    extend ``cover`` spacings beyond the grid.
    """
    spacing = float(grid[-1] - grid[0]) / (grid.size - 1)
    start, end = float(grid[0]) - cover * spacing, float(grid[-1]) + cover * spacing
    return replace(
        request,
        start=start if request.start is None else request.start,
        end=end if request.end is None else request.end,
        spacing=spacing,
    )


def _fewer_points(
    axis: Axis,
    fewer: FittedTable,
    best: FittedTable,
    found: TestPrediction,
    aim: TestPrediction,
) -> Finding:
    name, unit = judged_parameter(aim.before) or "", axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    mine, other = (
        say(
            "grid.predicted",
            name=name,
            value=one.predicted[name].median * factor,
            unit=small,
            elsewhere=one.predicted_new_targets[name].median * factor,
        )
        for one in (found, aim)
    )
    few, many = (grid_text(one.compensation.positions, unit) for one in (fewer, best))
    points = best.compensation.positions
    spacing = float(points[-1] - points[0]) / (points.size - 1)
    return Finding.of(
        "CW-P144",
        "info",
        axis=axis.name,
        few=few,
        mine=mine,
        many=many,
        other=other,
        start=points[0],
        end=points[-1],
        spacing=spacing,
    )
