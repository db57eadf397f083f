"""Choice of the table points, at positions that the control can express exactly.

The points are the existing ones, those given in the job, or as many as the error needs. All
arithmetic on positions is in whole resolution steps. So start + i * step is exact for every i.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.fitting.automatic_grid import candidates_over, choose_candidate, most_points
from compwright.fitting.existing_grid import close_point_findings, existing_points
from compwright.fitting.grid_steps import GridCandidate, is_whole
from compwright.fitting.reference_grids import reference_grids
from compwright.fitting.requested_spacing import Span, requested_grid
from compwright.fitting.unresolved_periods import HeldGrid, held_grid
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest


def choose_grid(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> HeldGrid:
    """Return the points for a table. Existing points are kept if the job allows it.

    Raises CapacityError if the control cannot hold the requested grid (with the limit and what
    would fit) or the existing grid cannot be used. Raises UsageError if the spacing is not positive
    or start is not below end.
    """
    spacing = request.named_spacing
    if spacing is not None and not spacing > 0.0:
        found = f"{spacing:g} {wanted.kind.unit}"
        raise UsageError(
            Fault(
                message="the spacing must be positive",
                place="table.spacing",
                found=found,
                hint="give a positive `table: {spacing: ...}`",
            )
        )
    if capacity.points is not None:
        return held_grid(
            _given_points(np.array(capacity.points), request, wanted.kind.unit), wanted, capacity
        )
    _check_order(wanted, request)
    kept_points = existing_points(wanted, capacity, request)
    if kept_points is not None:
        return _kept(kept_points, capacity, wanted)
    if capacity.anchored or capacity.period is not None:
        grids = reference_grids(wanted, capacity, request, most_points(capacity))
        if spacing is not None:
            return held_grid(grids[0].points(capacity.position_quantum), wanted, capacity)
        ends = (float(wanted.positions[0]), float(wanted.positions[-1]))
        return choose_candidate(grids, [], ends, capacity, wanted)
    span = _span(wanted, capacity, request)
    if spacing is not None:
        points = requested_grid(span, spacing, capacity, wanted)
        return held_grid(points, wanted, capacity)
    pool, others = candidates_over(span, capacity, wanted, most_points(capacity))
    ends = (span.low * capacity.position_quantum, span.high * capacity.position_quantum)
    return _covering(choose_candidate(pool, others, ends, capacity, wanted), span, capacity)


def possible_grids(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, most: int
) -> list[FloatArray]:
    """Return the equally spaced grids of at most ``most`` points that the control can hold,
    coarsest first.

    There is one grid for each number of points. A grid with a point at the reference is preferred.
    Raises CapacityError if no end that the job names fits.
    """
    most = min(most, most_points(capacity))
    if capacity.anchored or capacity.period is not None:
        grids = reference_grids(wanted, capacity, request, most)
    else:
        pool, others = candidates_over(_span(wanted, capacity, request), capacity, wanted, most)
        grids = [*pool, *others]
    by_count: dict[int, GridCandidate] = {}
    for one in grids:
        by_count.setdefault(one.count, one)
    return [by_count[count].points(capacity.position_quantum) for count in sorted(by_count)]


def _given_points(points: FloatArray, request: TableRequest, unit: str) -> FloatArray:
    """Return ``points``, the table points of a control whose points must not change. Raises
    CapacityError if the job states different points.
    """
    step = float(np.max(np.diff(points)))
    requested = (
        ("start", request.start, float(points[0])),
        ("end", request.end, float(points[-1])),
        ("spacing", request.named_spacing, step),
    )
    raise_all(
        CapacityError,
        [
            Fault(
                message=(
                    "the points of the existing table must not change, because the "
                    "columns of other axes in the same table depend on them"
                ),
                place=f"table.{name}",
                expected=f"{name}: {there:.10g} ({unit}), or no {name}",
                found=f"{given:.10g} {unit}",
                hint=f"set `table: {{{name}: {there:.10g}}}`, or leave `{name}` out",
            )
            for name, given, there in requested
            if given is not None and abs(given - there) > 1e-6
        ],
    )
    return points


def _kept(points: FloatArray, capacity: Capacity, wanted: WantedCorrection) -> HeldGrid:
    grid = held_grid(points, wanted, capacity)
    findings = (*grid.findings, *close_point_findings(points, capacity, wanted.kind.unit))
    return replace(grid, findings=findings, kept=True)


def _covering(grid: HeldGrid, span: Span, capacity: Capacity) -> HeldGrid:
    """Return the grid extended beyond the travel by as many intervals as the control needs, except
    at ends stated in the job.
    """
    points = grid.points
    below = 0 if span.low_fixed else capacity.cover
    above = 0 if span.high_fixed else capacity.cover
    if not below + above or points.size + below + above > most_points(capacity):
        return grid
    first, last = float(points[1] - points[0]), float(points[-1] - points[-2])
    reaching = np.concatenate(
        [
            points[0] - first * np.arange(below, 0, -1),
            points,
            points[-1] + last * np.arange(1, above + 1),
        ]
    )
    return replace(grid, points=np.round(reaching, 10))


def _check_order(wanted: WantedCorrection, request: TableRequest) -> tuple[float, float]:
    low = float(wanted.positions[0]) if request.start is None else request.start
    high = float(wanted.positions[-1]) if request.end is None else request.end
    if not low < high:
        raise UsageError(
            Fault(
                message="the table has no length",
                place="table",
                expected="start below end",
                found=f"{low:g} to {high:g}",
                hint="give `table: {start: ..., end: ...}` with start below end",
            )
        )
    return low, high


def _span(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> Span:
    low, high = _check_order(wanted, request)
    quantum = capacity.position_quantum
    faults = []
    for name, value in (("start", request.start), ("end", request.end)):
        if value is not None and not is_whole(value / quantum):
            nearest = round(value / quantum) * quantum
            faults.append(
                Fault(
                    message=f"the control cannot store the table's {name} exactly",
                    place=f"table.{name}",
                    expected=(
                        f"a multiple of {quantum:.10g} {wanted.kind.unit}, such as {nearest:.10g}"
                    ),
                    found=f"{value:.12g}",
                    hint=f"set `table: {{{name}: {nearest:.10g}}}`",
                )
            )
    raise_all(CapacityError, faults)
    # Outward, so that the table covers the travel.
    return Span(
        low=int(np.floor(low / quantum + 1e-6)),
        high=int(np.ceil(high / quantum - 1e-6)),
        low_fixed=request.start is not None,
        high_fixed=request.end is not None,
    )
