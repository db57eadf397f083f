"""The existing table points of the control, and whether a new table can use exactly these points.

Other functions of a control may depend on these points and their numbers. If the points stay, the
effect of these functions does not change.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.fitting.grid_steps import allowed_steps
from compwright.foundations.errors import CapacityError, Fault
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest

#: A grid over less of the travel than this part cannot serve: as little as the targets of a test
#: have to cover.
_LEAST_COVERED: Final = 0.5
#: Two places are one where they are nearer than this part of a spacing: arithmetic dust.
_SAME: Final = 1e-6


def existing_points(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest
) -> FloatArray | None:
    """Return the existing table points (k,), mm or deg, or None if other points are to be chosen.

    The result is None if the control has no existing points, or if the job requires other points.
    On an endless axis the points begin at the reference. An end in the job shortens the grid, or
    extends it with the grid's own interval. Raises CapacityError, with the reason, if the grid
    cannot be used.
    """
    if not (request.keeps and capacity.there):
        return None
    points: FloatArray = np.array(capacity.there)
    unit = wanted.kind.unit
    if capacity.unfit:
        raise _no_use(capacity.unfit, "", "")
    if capacity.period is not None:
        _check_turn_ends(request, wanted.reference, capacity.period, unit)
        points = _from_reference(points, wanted.reference, capacity.period, unit)
    else:
        if request.start is None and request.end is None:
            _check_reach(points, wanted.positions, unit)
        points = _to_named_ends(points, capacity, request, unit)
    _check_steps(points, capacity, unit)
    if capacity.anchored and not _on(points, wanted.reference):
        raise _no_use(
            "the control counts its points from the reference position, which is none of them",
            f"a point at {wanted.reference:.10g} {unit}",
            f"{points[0]:.10g} to {points[-1]:.10g} {unit}",
        )
    least, most = max(2, capacity.min_points), capacity.at_most
    if points.size < least or (most is not None and points.size > most):
        expected = f"at least {least} points" if points.size < least else f"at most {most} points"
        raise _no_use("the control does not have so many points", expected, f"{points.size}")
    return points


def close_point_findings(points: FloatArray, capacity: Capacity, unit: str) -> tuple[Finding, ...]:
    """Return a warning if the existing points break a rule of the control. This is not an error,
    because the control ran with these points.
    """
    least = float(np.min(np.diff(points)))
    if least >= capacity.min_spacing * (1 - 1e-9):
        return ()
    return (
        Finding.of(
            "CW-F011", "warning", spacing=least, unit=unit, reason=capacity.min_spacing_reason
        ),
    )


def _no_use(why: str, expected: str, found: str) -> CapacityError:
    return CapacityError(
        Fault(
            message=f"the new table cannot keep the points of the existing one: {why}",
            place="table.spacing",
            expected=expected,
            found=found,
            hint="leave `spacing` out of `table`, or set it to the existing one",
        )
    )


def _check_turn_ends(request: TableRequest, begin: float, period: float, unit: str) -> None:
    for name, value, place in (
        ("start", request.start, begin),
        ("end", request.end, begin + period),
    ):
        if value is not None and abs(value - place) > _SAME * period:
            raise _no_use(
                f"table.{name} is none of a table that goes round from the reference position",
                f"{place:.10g} {unit}, or nothing",
                f"{value:.10g} {unit}",
            )


def _from_reference(points: FloatArray, reference: float, period: float, unit: str) -> FloatArray:
    """Return the table points of one period, from the reference up to the reference again."""
    slack = _SAME * float(np.min(np.diff(points)))
    span = float(points[-1] - points[0])
    if abs(span - period) > max(slack, _SAME):
        raise _no_use("it does not span the turn", f"{period:.10g} {unit}", f"{span:.10g} {unit}")
    ahead = np.mod(points[:-1] - reference, period)
    ahead[np.abs(ahead - period) <= slack] = 0.0
    ahead = np.sort(ahead)
    if ahead[0] > slack:
        near = float(points[int(np.argmin(np.abs(points - reference)))])
        raise _no_use(
            "the table of an endless axis counts from the reference position, and no point is"
            " there",
            f"a point at {reference:.10g} {unit}",
            f"the nearest at {near:.10g} {unit}",
        )
    turned: FloatArray = np.round(reference + np.append(ahead, period), 10)
    return turned


def _to_named_ends(
    points: FloatArray, capacity: Capacity, request: TableRequest, unit: str
) -> FloatArray:
    """Return the table points cut or extended to the ends stated in the job.

    If the control allows any spacing, an end between two points becomes a point.
    """
    for name, end, sign in (("start", request.start, -1), ("end", request.end, 1)):
        if end is None:
            continue
        points = points if sign > 0 else -points[::-1]
        points = _to_end(points, sign * end)
        if capacity.spacing == "equidistant" and not _even(points):
            step = float(points[1] - points[0])
            raise _no_use(
                f"table.{name} is none of its points, which come every {step:.10g} {unit}",
                "an end on the grid",
                f"{end:.10g} {unit}",
            )
        points = points if sign > 0 else -points[::-1]
    result: FloatArray = np.round(points, 10)
    return result


def _to_end(points: FloatArray, end: float) -> FloatArray:
    """Return ascending table points up to ``end``, which is the last point. If the points end
    before ``end``, further points follow at the last interval.
    """
    step = float(points[-1] - points[-2])
    more = int(np.ceil((end - float(points[-1])) / step - _SAME))
    longer = np.concatenate([points, points[-1] + step * np.arange(1, max(more, 0) + 1)])
    inside = longer[longer < end - _SAME * step]
    shorter: FloatArray = np.append(inside, end)
    return shorter


def _check_reach(points: FloatArray, travel: FloatArray, unit: str) -> None:
    low, high = float(travel[0]), float(travel[-1])
    covered = max(0.0, min(float(points[-1]), high) - max(float(points[0]), low))
    if covered < _LEAST_COVERED * (high - low):
        raise _no_use(
            "it covers less than half of the travel",
            f"most of {low:.10g} to {high:.10g} {unit}",
            f"{covered:.10g} {unit} of it, by points from {points[0]:.10g} to {points[-1]:.10g}",
        )


def _even(points: FloatArray) -> bool:
    steps = np.diff(points)
    return bool(steps.size) and float(np.ptp(steps)) <= _SAME * float(np.max(steps))


def _check_steps(points: FloatArray, capacity: Capacity, unit: str) -> None:
    steps = np.diff(points)
    if capacity.spacing == "equidistant" and not _even(points):
        found = f"{np.min(steps):.10g} to {np.max(steps):.10g} {unit}"
        raise _no_use("its points are not equally spaced", "one spacing", found)
    step = float(steps[0])
    counted = round(step / capacity.position_quantum)
    if capacity.spacings is not None and not allowed_steps([counted], capacity):
        near = min(capacity.spacings, key=lambda one: abs(one - step))
        raise _no_use(
            "the control does not take its spacing",
            f"such as {near:.10g} {unit}",
            f"{step:.10g} {unit}",
        )


def _on(points: FloatArray, place: float) -> bool:
    step = float(np.min(np.diff(points)))
    return bool(np.min(np.abs(points - place)) <= _SAME * step)
