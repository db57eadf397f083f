"""Table points with the spacing stated in the job, or the reason why this spacing does not fit,
with the nearest spacings that fit.

All arithmetic is in whole resolution steps of the position.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.fitting.grid_steps import allowed_steps, is_whole, points_at
from compwright.fitting.reference_grids import requested_step
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection


@dataclass(frozen=True, slots=True)
class Span:
    """The two ends of a table in whole resolution steps, each ``fixed`` if the job states it."""

    low: int
    high: int
    low_fixed: bool
    high_fixed: bool


def requested_grid(
    span: Span, spacing: float, capacity: Capacity, wanted: WantedCorrection
) -> FloatArray:
    """Return table points with exactly this ``spacing``, mm or deg. Raises CapacityError if the
    control cannot hold them.
    """
    quantum, unit = capacity.position_quantum, wanted.kind.unit
    length = span.high - span.low
    step = round(spacing / quantum)
    if capacity.spacing == "free" and step > 0:
        return _freely_spaced(span, spacing, capacity, unit)
    if capacity.spacings is not None and not (span.low_fixed and span.high_fixed):
        return _reaching_grid(span, requested_step(spacing, capacity, unit), capacity, wanted)
    if not (step > 0 and is_whole(spacing / quantum)):
        raise _refused(
            span, spacing, capacity, f"the step must be a multiple of {quantum:.10g} {unit}", unit
        )
    if length % step:
        pieces = length / step
        raise _refused(
            span,
            spacing,
            capacity,
            f"the table is {pieces:.6g} steps long, not a whole number",
            unit,
        )
    requested_step(spacing, capacity, unit)
    _check_count(length // step + 1, span, capacity, unit)
    return points_at(span.low, step, length // step + 1, quantum)


def _reaching_grid(
    span: Span, step: int, capacity: Capacity, wanted: WantedCorrection
) -> FloatArray:
    """Return table points with the interval ``step`` (in resolution steps) over the range ``span``,
    for a control that accepts only certain intervals.

    One point is at an end given in the job or, without such an end, at the reference. At an open
    end the points extend beyond the range.
    """
    anchor = (
        span.low
        if span.low_fixed
        else span.high
        if span.high_fixed
        else round(wanted.reference / capacity.position_quantum)
    )
    start = anchor - -(-(anchor - span.low) // step) * step
    count = -(-(span.high - start) // step) + 1
    _check_count(count, span, capacity, wanted.kind.unit)
    return points_at(start, step, count, capacity.position_quantum)


def _freely_spaced(span: Span, spacing: float, capacity: Capacity, unit: str) -> FloatArray:
    """Return table points for a control in which each point has a position of its own.

    Each point is at the nearest position that the control can express. The last section may be
    shorter than the ``spacing``.
    """
    quantum = capacity.position_quantum
    sections = int(np.ceil((span.high - span.low) * quantum / spacing - 1e-9))
    _check_count(sections + 1, span, capacity, unit)
    counts = span.low + np.round(np.arange(sections + 1) * (spacing / quantum)).astype(np.int64)
    counts[-1] = span.high
    counts = np.unique(counts)  # a last section shorter than the control can say is none
    points: FloatArray = np.round(counts * quantum, 10)
    return points


def _check_count(count: int, span: Span, capacity: Capacity, unit: str) -> None:
    length = (span.high - span.low) * capacity.position_quantum
    most = capacity.at_most
    if most is not None and count > most:
        least = _nearest_steps(span, 0.0, capacity)[1]
        fits = f"; a spacing of {least:.10g} {unit} or more fits" if least else ""
        raise CapacityError(
            Fault(
                message=f"with this spacing a table of {length:.10g} {unit} has too many "
                f"points{fits}",
                place="table.spacing",
                expected=f"at most {most} points",
                found=f"{count} points",
                hint=capacity.fewer_points(count),
            )
        )
    if count < capacity.min_points:
        raise CapacityError(
            Fault(
                message=f"with this spacing a table of {length:.10g} {unit} has too few points",
                place="table.spacing",
                expected=f"at least {capacity.min_points} points",
                found=f"{count} points",
                hint="give a smaller `table: {spacing: ...}`, or leave it out",
            )
        )


def _refused(span: Span, spacing: float, capacity: Capacity, why: str, unit: str) -> CapacityError:
    near = [f"{step:.10g}" for step in _nearest_steps(span, spacing, capacity) if step]
    quantum = capacity.position_quantum
    return CapacityError(
        Fault(
            message=f"the control cannot store this spacing exactly: {why}",
            place="table.spacing",
            expected=(
                f"{' or '.join(near)} {unit}, for a table from {span.low * quantum:.10g} to"
                f" {span.high * quantum:.10g} {unit}"
            ),
            found=f"{spacing:.12g} {unit}",
            hint="set `table: {spacing: ...}` to one of these",
        )
    )


def _nearest_steps(
    span: Span, spacing: float, capacity: Capacity
) -> tuple[float | None, float | None]:
    """Return the nearest spacings below and above ``spacing`` that divide the table into whole
    intervals, None where there is none.
    """
    length = span.high - span.low
    most = min(capacity.at_most or 100_000, 100_000)
    fitting = [
        length // pieces
        for pieces in range(max(1, capacity.min_points - 1), min(most, length + 1))
        if length % pieces == 0
    ]
    steps = [step * capacity.position_quantum for step in allowed_steps(fitting, capacity)]
    below = [step for step in steps if step < spacing]
    above = [step for step in steps if step > spacing]
    return (max(below) if below else None), (min(above) if above else None)
