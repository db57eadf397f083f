"""Automatic choice of table points: as few as the error needs and no more than the control allows.

The interpolation error between the points is computed for each grid, not estimated (`grid_losses`).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.fitting.grid_losses import good_enough, grid_loss, magnification_needed
from compwright.fitting.grid_steps import (
    GridCandidate,
    allowed_steps,
    is_whole,
    listed_steps,
    round_steps,
)
from compwright.fitting.requested_spacing import Span
from compwright.fitting.unresolved_periods import (
    HeldGrid,
    held_grid,
    ignored_periods,
    resolved_part,
)
from compwright.foundations.errors import CapacityError, Fault
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity, Lattice
from compwright.records.estimate import WantedCorrection

#: Where the control's number of points is not known, the automatic choice stays below this.
AUTO_MOST: Final = 500


def choose_candidate(
    pool: list[GridCandidate],
    others: list[GridCandidate],
    ends: tuple[float, float],
    capacity: Capacity,
    wanted: WantedCorrection,
) -> HeldGrid:
    """Return the best grid of table points, with the correction to fit on it. The candidates are
    ``pool``, grids with a table point at the reference, and ``others``, without such a point.
    ``ends``: ends of the table, mm or deg.

    Raises CapacityError if there is no candidate.
    """
    quantum = capacity.position_quantum
    if not (pool or others):
        unit = wanted.kind.unit
        least = (
            f", at least {capacity.min_spacing:.10g} {unit} apart" if capacity.min_spacing else ""
        )
        raise CapacityError(
            Fault(
                message="no grid of equally spaced points fits between the ends of the "
                f"table{_others(capacity)}",
                place="table",
                expected=(
                    f"{capacity.min_points} to {most_points(capacity)} points at multiples of"
                    f" {quantum:.10g} {unit}{least}"
                ),
                found=f"{ends[0]:.10g} to {ends[1]:.10g} {unit}",
                hint="change `start` and `end` of the table, or leave them out",
            )
        )
    chosen = _coarsest(pool, others, wanted, capacity)
    if chosen is not None:
        return HeldGrid(points=chosen, wanted=wanted)
    if capacity.lattice is not None:
        compromise = _least_left([*pool, *others], wanted, capacity, capacity.lattice)
        loss = grid_loss(compromise, wanted, capacity.interpolation)
        return held_grid(compromise, wanted, capacity, loss=loss)
    finest = _with_most_points(pool, others).points(quantum)
    kept = resolved_part(finest, wanted, capacity)
    if wanted.periods and ignored_periods(finest, wanted.periods) == list(wanted.periods):
        enough = _coarsest(pool, others, kept, capacity)
        if enough is not None:
            return held_grid(enough, wanted, capacity, finest=finest)
    loss = 0.0 if capacity.max_points is None else grid_loss(finest, kept, capacity.interpolation)
    return held_grid(finest, wanted, capacity, loss=loss, finest=finest)


def _others(capacity: Capacity) -> str:
    """Return a hint that a wider spacing of other axes leaves more points, if the axes share one
    store of points, else an empty text.
    """
    if capacity.shared_points is None:
        return ""
    return "; the axes of the control share its points: a wider spacing of other axes leaves more"


def most_points(capacity: Capacity) -> int:
    """Return the largest number of points that the control allows in a table."""
    return capacity.max_points or max(AUTO_MOST, capacity.min_points)


def candidates_over(
    span: Span, capacity: Capacity, wanted: WantedCorrection, most: int
) -> tuple[list[GridCandidate], list[GridCandidate]]:
    """Return two lists of possible grids over the table's range ``span`` with at most ``most``
    points, coarsest first: with a table point at the reference, and without.
    """
    in_quanta = wanted.reference / capacity.position_quantum
    reference = round(in_quanta) if is_whole(in_quanta) else None
    length = span.high - span.low
    exact = [
        GridCandidate(span.low, length // pieces, pieces + 1)
        for pieces in range(max(1, capacity.min_points - 1), most)
        if length % pieces == 0 and allowed_steps([length // pieces], capacity)
    ]
    on = [one for one in exact if reference is not None and (reference - span.low) % one.step == 0]
    off = [one for one in exact if one not in on]
    anchor = span.low if span.low_fixed else span.high if span.high_fixed else reference
    reaching = list(_reaching_out(span, span.low if anchor is None else anchor, capacity, most))
    same = [
        one for one in reaching if reference is not None and (reference - one.start) % one.step == 0
    ]
    # A grid that ends with the travel is the better one; one that reaches out only where there is
    # none nearly as coarse.
    on += [one for one in same if not any(0.5 * one.step <= other.step <= one.step for other in on)]
    off += [one for one in reaching if one not in same]
    return sorted(on, key=lambda one: one.count), sorted(off, key=lambda one: one.count)


def _with_most_points(pool: list[GridCandidate], others: list[GridCandidate]) -> GridCandidate:
    """Return the grid with most points. A grid without a point at the reference (``others``) is
    chosen only if it has more than 1.5 times as many points as any grid with such a point
    (``pool``).
    """
    best = max(pool or others, key=lambda candidate: candidate.count)
    spare = max(others, key=lambda candidate: candidate.count, default=best)
    return spare if spare.count > 1.5 * best.count else best


def _reaching_out(
    span: Span, anchor: int, capacity: Capacity, most: int
) -> Iterator[GridCandidate]:
    """Yield grids with a round interval and a point at ``anchor`` that extend beyond the travel.

    A grid extends beyond the travel only at an end that the job does not name. At an end named in
    the job, a control with free spacing gets a shorter last section.
    """
    length = span.high - span.low
    for step in allowed_steps(sorted(listed_steps(capacity)) or round_steps(2 * length), capacity):
        start = anchor - -(-(anchor - span.low) // step) * step
        count = -(-(span.high - start) // step) + 1
        if not capacity.min_points <= count <= most or (span.low_fixed and start != span.low):
            continue
        if span.high_fixed and start + (count - 1) * step != span.high:
            if capacity.spacing == "free":
                yield GridCandidate(start, step, count, span.high)
            continue
        yield GridCandidate(start, step, count)


def _coarsest(
    pool: list[GridCandidate],
    others: list[GridCandidate],
    wanted: WantedCorrection,
    capacity: Capacity,
) -> FloatArray | None:
    """Return the table points of the coarsest grid with a small enough interpolation error
    (`good_enough`), or None if no grid has one. Grids with a point at the reference (``pool``) are
    preferred to the ``others``.
    """
    on, off = _first_good(pool, wanted, capacity), _first_good(others, wanted, capacity)
    if on is None or (off is not None and off.count * 3 < on.count):
        on = off
    return None if on is None else on.points(capacity.position_quantum)


def _first_good(
    candidates: list[GridCandidate], wanted: WantedCorrection, capacity: Capacity
) -> GridCandidate | None:
    """Return the coarsest grid with a small enough interpolation error (`good_enough`), or a
    slightly finer grid with a round interval.
    """
    quantum = capacity.position_quantum
    best: GridCandidate | None = None
    first = 0
    for candidate in candidates:
        if best is not None and candidate.count > 1.3 * first + 1:
            break
        if best is not None and candidate.digits(quantum) >= best.digits(quantum):
            continue
        points = candidate.points(quantum)
        if good_enough(points, wanted, capacity):
            first = candidate.count if best is None else first
            best = candidate
    return best


def _least_left(
    candidates: list[GridCandidate], wanted: WantedCorrection, capacity: Capacity, lattice: Lattice
) -> FloatArray:
    """Return the points of the grid with the smallest expected error, if no grid is good enough.
    ``lattice``: the increments and magnifications of the control.

    The expected error of a grid has three parts. The first is the interpolation error. The second
    is the rounding error. Rounding leaves step / sqrt(12) rms at a table point (Bennett, Bell
    System Technical Journal 27, 1948). Between points it leaves about step / sqrt(18), because the
    mean of (1 - s)² + s² over a section is 2/3. The third part is what the largest increment cannot
    reach, if even the largest magnification is too small. A finer spacing needs smaller increments.
    Among grids of almost equal error the coarsest is taken.
    """
    scored = []
    for candidate in candidates:
        points = candidate.points(capacity.position_quantum)
        needed = magnification_needed(points, wanted, lattice)
        enough = next(
            (one for one in lattice.magnifications if one >= needed), lattice.magnifications[-1]
        )
        share = 1.0 - enough / needed if needed > enough else 0.0
        lacking = share * float(np.std(np.concatenate([wanted.positive, wanted.negative])))
        rounding = enough * lattice.unit / np.sqrt(18.0)
        left = float(
            np.sqrt(
                grid_loss(points, wanted, capacity.interpolation) ** 2 + rounding**2 + lacking**2
            )
        )
        scored.append((left, candidate.count, points))
    enough_left = 1.02 * min(left for left, _, _ in scored)
    return min((one for one in scored if one[0] <= enough_left), key=lambda one: one[1])[2]
