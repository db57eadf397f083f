"""Choice of the nodes: positions that the control can say exactly, as few as the error needs, as
many as the control allows.

All arithmetic on positions is in whole quanta of the position, so that start + i * step is exact
for every i. What straight lines between nodes lose is computed, not estimated (`losses`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.fitting.anchored import anchored_grids, named_step
from compwright.fitting.losses import good_enough, grid_loss, magnification_needed
from compwright.fitting.periodic import without_periods
from compwright.fitting.standing import standing_nodes, too_close
from compwright.fitting.steps import Candidate, nodes_at, own_steps, round_steps, taken_steps, whole
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity, Lattice
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted import TableRequest

#: Where the control's number of points is not known, the automatic choice stays below this.
AUTO_MOST: Final = 500
#: A period is held from three points per period on (25 % of its rms is left then).
POINTS_PER_PERIOD: Final = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """``nodes`` (k,) mm or deg; ``wanted``: what is left to fit, without periods that the nodes
    cannot hold.

    ``left_out``: rms of those. ``points_loss``: rms that more points would save, 0 where the number
    of points is no limit. ``kept``: the nodes are those of the grid that is in the control.
    """

    nodes: FloatArray
    wanted: WantedCorrection
    left_out: float = 0.0
    points_loss: float = 0.0
    findings: tuple[Finding, ...] = ()
    kept: bool = False


@dataclass(frozen=True, slots=True)
class _Span:
    """Ends in whole quanta of the position; ``fixed`` where the job named them."""

    low: int
    high: int
    low_fixed: bool
    high_fixed: bool


def choose_grid(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> Grid:
    """Return the nodes for a table: those that are in the control, where the job lets them stay.

    Raises CapacityError where the control cannot hold the asked grid (which limit, what would fit),
    or where the one that is there cannot serve; UsageError where start does not lie below end.
    """
    spacing = request.named_spacing
    if spacing is not None and not spacing > 0.0:
        found = f"{spacing:g} {wanted.kind.unit}"
        raise UsageError(
            Fault(message="the spacing must be positive", place="table.spacing", found=found)
        )
    if capacity.nodes is not None:
        return _explicit_grid(
            _given_nodes(np.array(capacity.nodes), request, wanted.kind.unit), wanted
        )
    _check_order(wanted, request)
    standing = standing_nodes(wanted, capacity, request)
    if standing is not None:
        return _kept(standing, capacity, wanted)
    if capacity.anchored or capacity.period is not None:
        grids = anchored_grids(wanted, capacity, request, _most(capacity))
        if spacing is not None:
            return _explicit_grid(grids[0].nodes(capacity.position_quantum), wanted)
        ends = (float(wanted.positions[0]), float(wanted.positions[-1]))
        return _automatic(grids, [], ends, capacity, wanted)
    span = _span(wanted, capacity, request)
    if spacing is not None:
        nodes = _explicit(span, spacing, capacity, wanted)
        return _explicit_grid(nodes, wanted)
    pool, others = _candidates(span, capacity, wanted, _most(capacity))
    ends = (span.low * capacity.position_quantum, span.high * capacity.position_quantum)
    return _covering(_automatic(pool, others, ends, capacity, wanted), span, capacity)


def possible_grids(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, most: int
) -> list[FloatArray]:
    """Return the equally spaced grids of at most ``most`` points that the control can hold, one of
    each number of points, coarsest first, those with the reference at a node before others.

    Raises CapacityError where no end that the job names fits.
    """
    most = min(most, _most(capacity))
    if capacity.anchored or capacity.period is not None:
        grids = anchored_grids(wanted, capacity, request, most)
    else:
        pool, others = _candidates(_span(wanted, capacity, request), capacity, wanted, most)
        grids = [*pool, *others]
    by_count: dict[int, Candidate] = {}
    for one in grids:
        by_count.setdefault(one.count, one)
    return [by_count[count].nodes(capacity.position_quantum) for count in sorted(by_count)]


def _given_nodes(nodes: FloatArray, request: TableRequest, unit: str) -> FloatArray:
    """Return the nodes that the control's own table has; the job may name them, but no others."""
    step = float(np.max(np.diff(nodes)))
    asked = (
        ("start", request.start, float(nodes[0])),
        ("end", request.end, float(nodes[-1])),
        ("spacing", request.named_spacing, step),
    )
    raise_all(
        CapacityError,
        [
            Fault(
                message=(
                    "the points of the control's own table have to stay, because other axes'"
                    " columns depend on them"
                ),
                place=f"table.{name}",
                expected=f"{there:.10g} {unit}, or nothing",
                found=f"{given:.10g} {unit}",
            )
            for name, given, there in asked
            if given is not None and abs(given - there) > 1e-6
        ],
    )
    return nodes


def _kept(nodes: FloatArray, capacity: Capacity, wanted: WantedCorrection) -> Grid:
    grid = _explicit_grid(nodes, wanted)
    findings = (*grid.findings, *too_close(nodes, capacity, wanted.kind.unit))
    return replace(grid, findings=findings, kept=True)


def _covering(grid: Grid, span: _Span, capacity: Capacity) -> Grid:
    """Return the grid with the spacings beyond the travel that the control should have where the
    job left the ends open.
    """
    nodes = grid.nodes
    below = 0 if span.low_fixed else capacity.cover
    above = 0 if span.high_fixed else capacity.cover
    if not below + above or nodes.size + below + above > _most(capacity):
        return grid
    first, last = float(nodes[1] - nodes[0]), float(nodes[-1] - nodes[-2])
    reaching = np.concatenate(
        [
            nodes[0] - first * np.arange(below, 0, -1),
            nodes,
            nodes[-1] + last * np.arange(1, above + 1),
        ]
    )
    return replace(grid, nodes=np.round(reaching, 10))


def _most(capacity: Capacity) -> int:
    return capacity.max_points or max(AUTO_MOST, capacity.min_points)


def _check_order(wanted: WantedCorrection, request: TableRequest) -> tuple[float, float]:
    low = float(wanted.positions[0]) if request.start is None else request.start
    high = float(wanted.positions[-1]) if request.end is None else request.end
    if not low < high:
        raise UsageError(
            Fault(
                message="the table is empty",
                place="table",
                expected="start below end",
                found=f"{low:g} to {high:g}",
            )
        )
    return low, high


def _span(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> _Span:
    low, high = _check_order(wanted, request)
    quantum = capacity.position_quantum
    faults = []
    for name, value in (("start", request.start), ("end", request.end)):
        if value is not None and not whole(value / quantum):
            nearest = round(value / quantum) * quantum
            faults.append(
                Fault(
                    message=f"the control cannot hold the table's {name} exactly",
                    place=f"table.{name}",
                    expected=(
                        f"a multiple of {quantum:.10g} {wanted.kind.unit}, such as {nearest:.10g}"
                    ),
                    found=f"{value:.12g}",
                )
            )
    raise_all(CapacityError, faults)
    # Outward, so that the table covers the travel.
    return _Span(
        low=int(np.floor(low / quantum + 1e-6)),
        high=int(np.ceil(high / quantum - 1e-6)),
        low_fixed=request.start is not None,
        high_fixed=request.end is not None,
    )


# --- a spacing that the job names
# -------------------------------------------------------------------------------------


def _explicit(
    span: _Span, spacing: float, capacity: Capacity, wanted: WantedCorrection
) -> FloatArray:
    quantum, unit = capacity.position_quantum, wanted.kind.unit
    length = span.high - span.low
    step = round(spacing / quantum)
    if capacity.spacing == "free" and step > 0:
        return _freely_spaced(span, spacing, capacity, unit)
    if capacity.spacings is not None and not (span.low_fixed and span.high_fixed):
        return _reaching_grid(span, named_step(spacing, capacity, unit), capacity, wanted)
    if not (step > 0 and whole(spacing / quantum)):
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
    named_step(spacing, capacity, unit)
    _check_count(length // step + 1, span, capacity, unit)
    return nodes_at(span.low, step, length // step + 1, quantum)


def _reaching_grid(
    span: _Span, step: int, capacity: Capacity, wanted: WantedCorrection
) -> FloatArray:
    """Return nodes of a control that has only certain spacings: through the reference or the job's
    end, over the open ends.
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
    return nodes_at(start, step, count, capacity.position_quantum)


def _freely_spaced(span: _Span, spacing: float, capacity: Capacity, unit: str) -> FloatArray:
    """Return nodes that the control lists one by one: each the nearest that it can say, the last
    section perhaps shorter.
    """
    quantum = capacity.position_quantum
    sections = int(np.ceil((span.high - span.low) * quantum / spacing - 1e-9))
    _check_count(sections + 1, span, capacity, unit)
    counts = span.low + np.round(np.arange(sections + 1) * (spacing / quantum)).astype(np.int64)
    counts[-1] = span.high
    counts = np.unique(counts)  # a last section shorter than the control can say is none
    nodes: FloatArray = np.round(counts * quantum, 10)
    return nodes


def _check_count(count: int, span: _Span, capacity: Capacity, unit: str) -> None:
    length = (span.high - span.low) * capacity.position_quantum
    most = capacity.at_most
    if most is not None and count > most:
        least = _nearest_steps(span, 0.0, capacity)[1]
        fits = f"; from {least:.10g} {unit} on a spacing fits" if least else ""
        raise CapacityError(
            Fault(
                message=f"too many points for the table of {length:.10g} {unit}{fits}",
                place="table.spacing",
                expected=f"at most {most} points",
                found=f"{count} points",
            )
        )
    if count < capacity.min_points:
        raise CapacityError(
            Fault(
                message=(
                    f"too few points for the table of {length:.10g} {unit}; a smaller spacing would"
                    " help"
                ),
                place="table.spacing",
                expected=f"at least {capacity.min_points} points",
                found=f"{count} points",
            )
        )


def _refused(span: _Span, spacing: float, capacity: Capacity, why: str, unit: str) -> CapacityError:
    near = [f"{step:.10g}" for step in _nearest_steps(span, spacing, capacity) if step]
    quantum = capacity.position_quantum
    return CapacityError(
        Fault(
            message=f"the control cannot hold this spacing exactly: {why}",
            place="table.spacing",
            expected=(
                f"{' or '.join(near)} {unit} (from {span.low * quantum:.10g} to"
                f" {span.high * quantum:.10g} {unit})"
            ),
            found=f"{spacing:.12g} {unit}",
        )
    )


def _nearest_steps(
    span: _Span, spacing: float, capacity: Capacity
) -> tuple[float | None, float | None]:
    """Return the largest step below and the smallest above ``spacing`` that divides the table and
    keeps the number of points.
    """
    length = span.high - span.low
    most = min(capacity.at_most or 100_000, 100_000)
    fitting = [
        length // pieces
        for pieces in range(max(1, capacity.min_points - 1), min(most, length + 1))
        if length % pieces == 0
    ]
    steps = [step * capacity.position_quantum for step in taken_steps(fitting, capacity)]
    below = [step for step in steps if step < spacing]
    above = [step for step in steps if step > spacing]
    return (max(below) if below else None), (min(above) if above else None)


def _explicit_grid(nodes: FloatArray, wanted: WantedCorrection, *, loss: float = 0.0) -> Grid:
    step = float(np.max(np.diff(nodes)))
    lost = [period for period in wanted.periods if step * POINTS_PER_PERIOD > period * (1 + 1e-9)]
    return _leaving_out(nodes, wanted, lost, loss)


def _leaving_out(
    nodes: FloatArray, wanted: WantedCorrection, periods: list[float], loss: float = 0.0
) -> Grid:
    """Return the grid with the part of ``periods`` left out, and a finding where that is more than
    nothing.
    """
    if not periods:
        return Grid(nodes=nodes, wanted=wanted, points_loss=loss)
    smooth, rms = without_periods(wanted, periods)
    unit = wanted.kind.unit
    named = ", ".join(f"{period:g}" for period in periods)
    factor, small = (1e3, "µm") if unit == "mm" else (3600.0, "arcsec")
    found = Finding(
        "CW-F002",
        "info",
        f"The spacing of {float(np.max(np.diff(nodes))):g} {unit} cannot hold an error of period"
        f" {named} {unit} (a third of the period is needed): it is left out of the table,"
        f" {significant(rms * factor)} {small} rms",
    )
    return Grid(nodes=nodes, wanted=smooth, left_out=rms, points_loss=loss, findings=(found,))


# --- the automatic choice
# ---------------------------------------------------------------------------------------------


def _automatic(
    pool: list[Candidate],
    others: list[Candidate],
    ends: tuple[float, float],
    capacity: Capacity,
    wanted: WantedCorrection,
) -> Grid:
    quantum = capacity.position_quantum
    if not (pool or others):
        unit = wanted.kind.unit
        least = (
            f", at least {capacity.min_spacing:.10g} {unit} apart" if capacity.min_spacing else ""
        )
        raise CapacityError(
            Fault(
                message="no equally spaced grid fits the table's ends",
                place="table",
                expected=(
                    f"{capacity.min_points} to {_most(capacity)} points at multiples of"
                    f" {quantum:.10g} {unit}{least}"
                ),
                found=f"{ends[0]:.10g} to {ends[1]:.10g} {unit}",
            )
        )
    chosen = _coarsest(pool, others, wanted, capacity)
    if chosen is not None:
        return Grid(nodes=chosen, wanted=wanted)
    if capacity.lattice is not None:
        compromise = _least_left([*pool, *others], wanted, capacity, capacity.lattice)
        return _explicit_grid(
            compromise, wanted, loss=grid_loss(compromise, wanted, capacity.interpolation)
        )
    finest = _with_most_points(pool, others).nodes(quantum)
    step = float(np.max(np.diff(finest)))
    lost = [period for period in wanted.periods if step * POINTS_PER_PERIOD > period * (1 + 1e-9)]
    kept = without_periods(wanted, lost)[0] if lost else wanted
    if lost and len(lost) == len(wanted.periods):
        enough = _coarsest(pool, others, kept, capacity)
        if enough is not None:
            return _leaving_out(enough, wanted, lost)
    return _leaving_out(
        finest,
        wanted,
        lost,
        0.0 if capacity.max_points is None else grid_loss(finest, kept, capacity.interpolation),
    )


def _with_most_points(pool: list[Candidate], others: list[Candidate]) -> Candidate:
    """Return the finest grid; one without a node at the reference only where it has half as many
    points again.
    """
    best = max(pool or others, key=lambda candidate: candidate.count)
    spare = max(others, key=lambda candidate: candidate.count, default=best)
    return spare if spare.count > 1.5 * best.count else best


def _candidates(
    span: _Span, capacity: Capacity, wanted: WantedCorrection, most: int
) -> tuple[list[Candidate], list[Candidate]]:
    """Return grids, coarsest first: those with the reference at a node (or on the continued grid),
    and the others.
    """
    in_quanta = wanted.reference / capacity.position_quantum
    reference = round(in_quanta) if whole(in_quanta) else None
    length = span.high - span.low
    exact = [
        Candidate(span.low, length // pieces, pieces + 1)
        for pieces in range(max(1, capacity.min_points - 1), most)
        if length % pieces == 0 and taken_steps([length // pieces], capacity)
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


def _reaching_out(span: _Span, anchor: int, capacity: Capacity, most: int) -> Iterator[Candidate]:
    """Yield grids of round steps through ``anchor`` that reach beyond the travel where the job left
    the end open.

    With free spacing, an end that the job fixed cuts the last section short.
    """
    length = span.high - span.low
    for step in taken_steps(sorted(own_steps(capacity)) or round_steps(2 * length), capacity):
        start = anchor - -(-(anchor - span.low) // step) * step
        count = -(-(span.high - start) // step) + 1
        if not capacity.min_points <= count <= most or (span.low_fixed and start != span.low):
            continue
        if span.high_fixed and start + (count - 1) * step != span.high:
            if capacity.spacing == "free":
                yield Candidate(start, step, count, span.high)
            continue
        yield Candidate(start, step, count)


def _coarsest(
    pool: list[Candidate], others: list[Candidate], wanted: WantedCorrection, capacity: Capacity
) -> FloatArray | None:
    """Return the nodes of the coarsest grid that is good enough, preferably with the reference at a
    node; None: there is none.
    """
    on, off = _first_good(pool, wanted, capacity), _first_good(others, wanted, capacity)
    if on is None or (off is not None and off.count * 3 < on.count):
        on = off
    return None if on is None else on.nodes(capacity.position_quantum)


def _first_good(
    candidates: list[Candidate], wanted: WantedCorrection, capacity: Capacity
) -> Candidate | None:
    """Return a grid that loses no more than the tolerance: the coarsest, or one nearly as coarse
    with a rounder step.
    """
    quantum = capacity.position_quantum
    best: Candidate | None = None
    first = 0
    for candidate in candidates:
        if best is not None and candidate.count > 1.3 * first + 1:
            break
        if best is not None and candidate.digits(quantum) >= best.digits(quantum):
            continue
        nodes = candidate.nodes(quantum)
        if good_enough(nodes, wanted, capacity):
            first = candidate.count if best is None else first
            best = candidate
    return best


def _least_left(
    candidates: list[Candidate], wanted: WantedCorrection, capacity: Capacity, lattice: Lattice
) -> FloatArray:
    """Return the grid that is expected to leave least where none is good enough: finer spacing,
    smaller increments, but a coarser magnification where those do not suffice. The coarsest of
    those that are nearly as good.

    Rounding leaves step / sqrt(12) rms at a node (Bennett, Bell System Technical Journal 27, 1948)
    and, because the mean of (1 - s)² + s² over a section is 2/3, about step / sqrt(18) between
    straight lines; increments that are too small leave about what they lack.
    """
    scored = []
    for candidate in candidates:
        nodes = candidate.nodes(capacity.position_quantum)
        needed = magnification_needed(nodes, wanted, lattice)
        enough = next(
            (one for one in lattice.magnifications if one >= needed), lattice.magnifications[-1]
        )
        share = 1.0 - enough / needed if needed > enough else 0.0
        lacking = share * float(np.std(np.concatenate([wanted.positive, wanted.negative])))
        rounding = enough * lattice.unit / np.sqrt(18.0)
        left = float(
            np.sqrt(
                grid_loss(nodes, wanted, capacity.interpolation) ** 2 + rounding**2 + lacking**2
            )
        )
        scored.append((left, candidate.count, nodes))
    enough_left = 1.02 * min(left for left, _, _ in scored)
    return min((one for one in scored if one[0] <= enough_left), key=lambda one: one[1])[2]
