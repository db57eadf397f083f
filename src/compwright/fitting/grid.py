"""Choice of the nodes: positions that the control can say exactly, as few as the error needs, as many as the control allows.

All arithmetic on positions is in whole quanta of the position, so that start + i * step is exact for every i.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.fitting.periodic import without_periods
from compwright.fitting.problem import BOTH, limited_increment
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted import TableRequest

#: Where the control's number of points is not known, the automatic choice stays below this.
AUTO_MOST: Final = 500
#: A period is held from three points per period on (25 % of its rms is left then).
POINTS_PER_PERIOD: Final = 3.0
#: The grid may lose this share of the noise of a reading (rms), or one quantum.
NOISE_SHARE: Final = 0.1
_NICE: Final = (10, 20, 25, 40, 50)  # tenths of a power of ten


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """``nodes`` (k,) mm or deg; ``wanted``: what is left to fit, without periods that the nodes cannot hold.

    ``left_out``: rms of those. ``points_loss``: rms that more points would save, 0 where the number of points is no limit.
    """

    nodes: FloatArray
    wanted: WantedCorrection
    left_out: float = 0.0
    points_loss: float = 0.0
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True, slots=True)
class _Span:
    """Ends in whole quanta of the position; ``fixed`` where the job named them."""

    low: int
    high: int
    low_fixed: bool
    high_fixed: bool


def choose_grid(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> Grid:
    """Return the nodes for a table.

    Raises CapacityError where the control cannot hold the asked grid (which limit, what would fit), UsageError where
    start does not lie below end.
    """
    span = _span(wanted, capacity, request)
    if request.spacing is not None:
        nodes = _explicit(span, request.spacing, capacity, wanted)
        return _explicit_grid(nodes, wanted)
    return _automatic(span, capacity, wanted)


def _span(wanted: WantedCorrection, capacity: Capacity, request: TableRequest) -> _Span:
    low = float(wanted.positions[0]) if request.start is None else request.start
    high = float(wanted.positions[-1]) if request.end is None else request.end
    if not low < high:
        raise UsageError(
            Fault(message="the table is empty", place="table", expected="start below end", found=f"{low:g} to {high:g}")
        )
    quantum = capacity.position_quantum
    faults = []
    for name, value in (("start", request.start), ("end", request.end)):
        if value is not None and not _whole(value / quantum):
            nearest = round(value / quantum) * quantum
            faults.append(
                Fault(
                    message=f"the control cannot hold the table's {name} exactly",
                    place=f"table.{name}",
                    expected=f"a multiple of {quantum:.10g} {wanted.kind.unit}, such as {nearest:.10g}",
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


def _whole(ratio: float) -> bool:
    return abs(ratio - round(ratio)) <= 1e-6 * max(1.0, abs(ratio) * 1e-3)


def _nodes(start: int, step: int, count: int, quantum: float) -> FloatArray:
    # Rounded to 10 decimals: the number that a file says, not the product's last bits.
    nodes: FloatArray = np.round((start + step * np.arange(count, dtype=np.int64)) * quantum, 10)
    return nodes


# --- a spacing that the job names -------------------------------------------------------------------------------------


def _explicit(span: _Span, spacing: float, capacity: Capacity, wanted: WantedCorrection) -> FloatArray:
    quantum, unit = capacity.position_quantum, wanted.kind.unit
    if not spacing > 0.0:
        raise UsageError(Fault(message="the spacing must be positive", place="table.spacing", found=f"{spacing:g} {unit}"))
    length = span.high - span.low
    step = round(spacing / quantum)
    if capacity.spacing == "free" and step > 0:
        return _freely_spaced(span, spacing, capacity, unit)
    if not (step > 0 and _whole(spacing / quantum)):
        raise _refused(span, spacing, capacity, f"the step must be a multiple of {quantum:.10g} {unit}", unit)
    if length % step:
        pieces = length / step
        raise _refused(span, spacing, capacity, f"the table is {pieces:.6g} steps long, not a whole number", unit)
    _check_count(length // step + 1, span, capacity, unit)
    return _nodes(span.low, step, length // step + 1, quantum)


def _freely_spaced(span: _Span, spacing: float, capacity: Capacity, unit: str) -> FloatArray:
    """Return nodes that the control lists one by one: each the nearest that it can say, the last section perhaps shorter."""
    quantum = capacity.position_quantum
    sections = int(np.ceil((span.high - span.low) * quantum / spacing - 1e-9))
    _check_count(sections + 1, span, capacity, unit)
    counts = span.low + np.round(np.arange(sections + 1) * (spacing / quantum)).astype(np.int64)
    counts[-1] = span.high
    nodes: FloatArray = np.round(counts * quantum, 10)
    return nodes


def _check_count(count: int, span: _Span, capacity: Capacity, unit: str) -> None:
    length = (span.high - span.low) * capacity.position_quantum
    if capacity.max_points is not None and count > capacity.max_points:
        least = _nearest_steps(span, 0.0, capacity)[1]
        fits = f"; from {least:.10g} {unit} on a spacing fits" if least else ""
        raise CapacityError(
            Fault(
                message=f"too many points for the table of {length:.10g} {unit}{fits}",
                place="table.spacing",
                expected=f"at most {capacity.max_points} points",
                found=f"{count} points",
            )
        )
    if count < capacity.min_points:
        raise CapacityError(
            Fault(
                message=f"too few points for the table of {length:.10g} {unit}; a smaller spacing would help",
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
            expected=f"{' or '.join(near)} {unit} (from {span.low * quantum:.10g} to {span.high * quantum:.10g} {unit})",
            found=f"{spacing:.12g} {unit}",
        )
    )


def _nearest_steps(span: _Span, spacing: float, capacity: Capacity) -> tuple[float | None, float | None]:
    """Return the largest step below and the smallest above ``spacing`` that divides the table and keeps the number of points."""
    length = span.high - span.low
    most = capacity.max_points or 100_000
    fitting = [length // pieces for pieces in range(max(1, capacity.min_points - 1), min(most, length + 1)) if length % pieces == 0]
    steps = [step * capacity.position_quantum for step in fitting]
    below = [step for step in steps if step < spacing]
    above = [step for step in steps if step > spacing]
    return (max(below) if below else None), (min(above) if above else None)


def _explicit_grid(nodes: FloatArray, wanted: WantedCorrection) -> Grid:
    step = float(np.max(np.diff(nodes)))
    return _leaving_out(nodes, wanted, [period for period in wanted.periods if step * POINTS_PER_PERIOD > period * (1 + 1e-9)])


def _leaving_out(nodes: FloatArray, wanted: WantedCorrection, periods: list[float], loss: float = 0.0) -> Grid:
    """Return the grid with the part of ``periods`` left out, and a finding where that is more than nothing."""
    if not periods:
        return Grid(nodes=nodes, wanted=wanted, points_loss=loss)
    smooth, rms = without_periods(wanted, periods)
    unit = wanted.kind.unit
    named = ", ".join(f"{period:g}" for period in periods)
    factor, small = (1e3, "µm") if unit == "mm" else (3600.0, "arcsec")
    found = Finding(
        "CW-F002",
        "info",
        f"The spacing of {float(np.max(np.diff(nodes))):g} {unit} cannot hold an error of period {named} {unit} "
        f"(a third of the period is needed): it is left out of the table, {rms * factor:.2g} {small} rms",
    )
    return Grid(nodes=nodes, wanted=smooth, left_out=rms, points_loss=loss, findings=(found,))


# --- the automatic choice ---------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Candidate:
    """An equally spaced grid in quanta of the position; ``last`` cuts the last section short (free spacing only)."""

    start: int
    step: int
    count: int
    last: int | None = None

    def nodes(self, quantum: float) -> FloatArray:
        nodes = _nodes(self.start, self.step, self.count, quantum)
        if self.last is not None:
            nodes[-1] = np.round(self.last * quantum, 10)
        return nodes

    def digits(self, quantum: float) -> int:
        """Return the number of digits of the step: 50 has one, 53.125 has five."""
        return len(f"{self.step * quantum:.10g}".replace(".", "").strip("0"))


def _automatic(span: _Span, capacity: Capacity, wanted: WantedCorrection) -> Grid:
    most = capacity.max_points or max(AUTO_MOST, capacity.min_points)
    quantum = capacity.position_quantum
    pool, others = _candidates(span, capacity, wanted, most)
    if not (pool or others):
        raise CapacityError(
            Fault(
                message="no equally spaced grid fits the table's ends",
                place="table",
                expected=f"{capacity.min_points} to {most} points at multiples of {quantum:.10g} {wanted.kind.unit}",
                found=f"{span.low * quantum:.10g} to {span.high * quantum:.10g} {wanted.kind.unit}",
            )
        )
    chosen = _coarsest(pool, others, wanted, capacity)
    if chosen is not None:
        return Grid(nodes=chosen, wanted=wanted)
    finest = _with_most_points(pool, others).nodes(quantum)
    step = float(np.max(np.diff(finest)))
    lost = [period for period in wanted.periods if step * POINTS_PER_PERIOD > period * (1 + 1e-9)]
    kept = without_periods(wanted, lost)[0] if lost else wanted
    if lost and len(lost) == len(wanted.periods):
        enough = _coarsest(pool, others, kept, capacity)
        if enough is not None:
            return _leaving_out(enough, wanted, lost)
    return _leaving_out(finest, wanted, lost, 0.0 if capacity.max_points is None else _loss(finest, kept))


def _with_most_points(pool: list[_Candidate], others: list[_Candidate]) -> _Candidate:
    """Return the finest grid; one without a node at the reference only where it has half as many points again."""
    best = max(pool or others, key=lambda candidate: candidate.count)
    spare = max(others, key=lambda candidate: candidate.count, default=best)
    return spare if spare.count > 1.5 * best.count else best


def _candidates(span: _Span, capacity: Capacity, wanted: WantedCorrection, most: int) -> tuple[list[_Candidate], list[_Candidate]]:
    """Return grids, coarsest first: those with the reference at a node (or on the continued grid), and the others."""
    in_quanta = wanted.reference / capacity.position_quantum
    reference = round(in_quanta) if _whole(in_quanta) else None
    length = span.high - span.low
    exact = [
        _Candidate(span.low, length // pieces, pieces + 1)
        for pieces in range(max(1, capacity.min_points - 1), most)
        if length % pieces == 0
    ]
    on = [one for one in exact if reference is not None and (reference - span.low) % one.step == 0]
    off = [one for one in exact if one not in on]
    anchor = span.low if span.low_fixed else span.high if span.high_fixed else reference
    reaching = list(_reaching_out(span, span.low if anchor is None else anchor, capacity, most))
    same = [one for one in reaching if reference is not None and (reference - one.start) % one.step == 0]
    # A grid that ends with the travel is the better one; one that reaches out only where there is none nearly as coarse.
    on += [one for one in same if not any(0.5 * one.step <= other.step <= one.step for other in on)]
    off += [one for one in reaching if one not in same]
    return sorted(on, key=lambda one: one.count), sorted(off, key=lambda one: one.count)


def _reaching_out(span: _Span, anchor: int, capacity: Capacity, most: int) -> Iterator[_Candidate]:
    """Yield grids of round steps through ``anchor`` that reach beyond the travel where the job left the end open.

    With free spacing, an end that the job fixed cuts the last section short.
    """
    length = span.high - span.low
    for step in sorted({int(digit * 10**exponent / 10) for exponent in range(1, 11) for digit in _NICE}):
        if step > 2 * length:
            break
        start = anchor - -(-(anchor - span.low) // step) * step
        count = -(-(span.high - start) // step) + 1
        if not capacity.min_points <= count <= most or (span.low_fixed and start != span.low):
            continue
        if span.high_fixed and start + (count - 1) * step != span.high:
            if capacity.spacing == "free":
                yield _Candidate(start, step, count, span.high)
            continue
        yield _Candidate(start, step, count)


def _coarsest(pool: list[_Candidate], others: list[_Candidate], wanted: WantedCorrection, capacity: Capacity) -> FloatArray | None:
    """Return the nodes of the coarsest grid that is good enough, preferably with the reference at a node; None: there is none."""
    on, off = _first_good(pool, wanted, capacity), _first_good(others, wanted, capacity)
    if on is None or (off is not None and off.count * 3 < on.count):
        on = off
    return None if on is None else on.nodes(capacity.position_quantum)


def _first_good(candidates: list[_Candidate], wanted: WantedCorrection, capacity: Capacity) -> _Candidate | None:
    """Return a grid that loses no more than the tolerance: the coarsest, or one nearly as coarse with a rounder step."""
    limit, quantum = limited_increment(capacity), capacity.position_quantum
    tolerance = max(capacity.quantum, NOISE_SHARE * wanted.noise)
    best: _Candidate | None = None
    first = 0
    for candidate in candidates:
        if best is not None and candidate.count > 1.3 * first + 1:
            break
        if best is not None and candidate.digits(quantum) >= best.digits(quantum):
            continue
        nodes = candidate.nodes(quantum)
        if _loss(nodes, wanted) <= tolerance and (limit is None or _steepest(nodes, wanted) <= limit):
            first = candidate.count if best is None else first
            best = candidate
    return best


def _loss(nodes: FloatArray, wanted: WantedCorrection) -> float:
    """Return the rms over the travel and both directions of what interpolation between the nodes loses."""
    where = wanted.positions
    square = [
        np.mean((np.interp(where, nodes, np.interp(nodes, where, curve)) - curve) ** 2)
        for curve in (wanted.total(direction) for direction in BOTH)
    ]
    return float(np.sqrt(np.mean(square)))


def _steepest(nodes: FloatArray, wanted: WantedCorrection) -> float:
    return float(max(np.max(np.abs(np.diff(np.interp(nodes, wanted.positions, wanted.total(direction))))) for direction in BOTH))
