"""Table points counted from the reference position: at whole intervals from it, or over one period
of an endless axis.
"""

from __future__ import annotations

from math import gcd

import numpy as np

from compwright.fitting.grid_steps import GridCandidate, allowed_steps, is_whole, round_steps
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest


def reference_grids(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, most: int
) -> list[GridCandidate]:
    """Return the grids that the control accepts, coarsest first, or only one if the job states the
    spacing.

    The reference is always a table point, because the control counts from there. At an end that the
    job leaves open, the grid extends beyond the travel by less than one spacing. Raises
    CapacityError with all faults if start, end or spacing in the job do not fit. The faults state
    values that fit.
    """
    if capacity.period is not None:
        return _endless_grids(capacity.period, wanted, capacity, request, most)
    ends = _fixed_ends(wanted, capacity, request)
    steps = _steps(wanted, capacity, request, ends)
    reach = _reach(wanted, capacity, request)
    grids = [_over(step, reach, wanted.reference) for step in steps]
    if request.named_spacing is not None:
        raise_all(CapacityError, _count_faults(grids[0].count, capacity, wanted))
        return grids
    return sorted(
        (one for one in grids if max(2, capacity.min_points) <= one.count <= most),
        key=lambda one: one.count,
    )


def _over(step: int, reach: tuple[float, float], origin: float) -> GridCandidate:
    """Return the grid with interval ``step`` that covers the range ``reach``; both in resolution
    steps from the reference.
    """
    first = min(0, int(np.floor(reach[0] / step + 1e-6)))
    last = max(0, int(np.ceil(reach[1] / step - 1e-6)))
    return GridCandidate(first * step, step, last - first + 1, origin=origin)


def _reach(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest
) -> tuple[float, float]:
    low = float(wanted.positions[0]) if request.start is None else request.start
    high = float(wanted.positions[-1]) if request.end is None else request.end
    return (low - wanted.reference) / capacity.position_quantum, (
        high - wanted.reference
    ) / capacity.position_quantum


def _fixed_ends(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest
) -> tuple[int | None, int | None]:
    """Return the ends stated in the job, in resolution steps from the reference. Raises
    CapacityError if the control does not accept them.
    """
    unit, quantum, reference = wanted.kind.unit, capacity.position_quantum, wanted.reference
    faults: list[Fault] = []
    found: list[int | None] = []
    for name, value, sign in (("start", request.start, -1), ("end", request.end, 1)):
        if value is None:
            found.append(None)
            continue
        counted = (value - reference) / quantum
        found.append(round(counted))
        if sign * counted < -1e-6:
            side = "below" if sign < 0 else "above"
            faults.append(
                Fault(
                    message=(
                        "the control counts its points from the reference position, "
                        "which must be inside the table"
                    ),
                    place=f"table.{name}",
                    expected=f"{name}: {reference:.10g} ({unit}) or a position {side} it",
                    found=f"{value:.12g}",
                    hint=f"set `table: {{{name}: {reference:.10g}}}`, or a position {side} it",
                )
            )
        elif not is_whole(counted):
            nearest = reference + round(counted) * quantum
            faults.append(
                Fault(
                    message=f"the control cannot store the table's {name} exactly",
                    place=f"table.{name}",
                    expected=(
                        f"{reference:.10g} {unit} plus a multiple of {quantum:.10g} {unit}, such as"
                        f" {nearest:.10g}"
                    ),
                    found=f"{value:.12g}",
                    hint=f"set `table: {{{name}: {nearest:.10g}}}`",
                )
            )
    raise_all(CapacityError, faults)
    return found[0], found[1]


def _steps(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    ends: tuple[int | None, int | None],
) -> list[int]:
    """Return the possible intervals in resolution steps, or only the interval stated in the job.
    Raises CapacityError if the stated interval does not fit.
    """
    if request.named_spacing is not None:
        step = requested_step(request.named_spacing, capacity, wanted.kind.unit)
        raise_all(CapacityError, _end_faults(step, wanted, capacity, ends))
        return [step]
    fixed = [abs(end) for end in ends if end]
    if fixed:
        return allowed_steps(divisors(gcd(*fixed)), capacity)
    low, high = _reach(wanted, capacity, request)
    length = max(high, 0.0) - min(low, 0.0)
    own = [round(spacing / capacity.position_quantum) for spacing in capacity.spacings or ()]
    return allowed_steps(
        [step for step in own if step > 0] or round_steps(int(2 * length)), capacity
    )


def divisors(number: int) -> list[int]:
    """Return all divisors of ``number`` >= 1, ascending."""
    small = [one for one in range(1, int(np.sqrt(number)) + 1) if number % one == 0]
    return sorted({*small, *(number // one for one in small)})


def requested_step(spacing: float, capacity: Capacity, unit: str) -> int:
    """Return the spacing stated in the job in resolution steps. Raises CapacityError if the control
    does not accept it.
    """
    quantum = capacity.position_quantum
    step = round(spacing / quantum)
    faults = []
    if not (step > 0 and is_whole(spacing / quantum)):
        nearest = max(1, step) * quantum
        faults.append(
            Fault(
                message="the control cannot store this spacing exactly",
                place="table.spacing",
                expected=f"a multiple of {quantum:.10g} {unit}, such as {nearest:.10g}",
                found=f"{spacing:.12g} {unit}",
                hint=f"set `table: {{spacing: {nearest:.10g}}}`",
            )
        )
    elif not allowed_steps([step], capacity):
        faults.append(_not_taken(spacing, capacity, unit))
    raise_all(CapacityError, faults)
    return step


def _not_taken(spacing: float, capacity: Capacity, unit: str) -> Fault:
    if spacing < capacity.min_spacing:
        why = f": {capacity.min_spacing_reason}" if capacity.min_spacing_reason else ""
        return Fault(
            message=f"the spacing is too small for the control{why}",
            place="table.spacing",
            expected=f"at least {capacity.min_spacing:.10g} {unit}",
            found=f"{spacing:.12g} {unit}",
            hint=f"set `table: {{spacing: {capacity.min_spacing:.10g}}}` or larger",
        )
    own = sorted(capacity.spacings or ())
    near = [
        max((one for one in own if one < spacing), default=None),
        min((one for one in own if one > spacing), default=None),
    ]
    return Fault(
        message="the control allows only certain spacings",
        place="table.spacing",
        expected=f"{' or '.join(f'{one:.10g}' for one in near if one is not None)} {unit}",
        found=f"{spacing:.12g} {unit}",
        hint="set `table: {spacing: ...}` to one of these",
    )


def _end_faults(
    step: int, wanted: WantedCorrection, capacity: Capacity, ends: tuple[int | None, int | None]
) -> list[Fault]:
    unit, quantum, reference = wanted.kind.unit, capacity.position_quantum, wanted.reference
    faults = []
    for name, verb, end in (("start", "starts", ends[0]), ("end", "ends", ends[1])):
        if end is None or end % step == 0:
            continue
        lower = end // step
        near = " or ".join(f"{reference + one * step * quantum:.10g}" for one in (lower, lower + 1))
        faults.append(
            Fault(
                message=(
                    f"the {name} of the table is not a whole number of spacings away from "
                    f"the reference position ({reference:.10g} {unit})"
                ),
                place=f"table.{name}",
                expected=(
                    f"a table that {verb} at {near} {unit} (the spacing is {step * quantum:.10g} "
                    f"{unit})"
                ),
                found=f"{reference + end * quantum:.12g}",
                hint=f"set `table: {{{name}: ...}}` to one of these positions",
            )
        )
    return faults


def _count_faults(count: int, capacity: Capacity, wanted: WantedCorrection) -> list[Fault]:
    least, most = max(2, capacity.min_points), capacity.at_most
    if count >= least and (most is None or count <= most):
        return []
    many = most is not None and count > most
    return [
        Fault(
            message=(
                f"the table would have too {'many' if many else 'few'} points, counted from "
                f"the reference position ({wanted.reference:.10g} {wanted.kind.unit})"
            ),
            place="table.spacing",
            expected=f"at most {most} points" if many else f"at least {least} points",
            found=f"{count} points",
            hint=(
                f"give a {'larger' if many else 'smaller'} `table: "
                f"{{spacing: ...}}`, or leave it out"
            ),
        )
    ]


# --- endless axes
# --------------------------------------------------------------------------------------------------


def _endless_grids(
    period: float, wanted: WantedCorrection, capacity: Capacity, request: TableRequest, most: int
) -> list[GridCandidate]:
    quantum, unit, reference = capacity.position_quantum, wanted.kind.unit, wanted.reference
    faults = [
        Fault(
            message=(
                "the table of an endless axis must span exactly one period, from the reference "
                "position on"
            ),
            place=f"table.{name}",
            expected=f"{name}: {place:.10g} ({unit}), or no {name}",
            found=f"{value:.12g}",
            hint=f"set `table: {{{name}: {place:.10g}}}`, or leave `{name}` out",
        )
        for name, value, place in (
            ("start", request.start, reference),
            ("end", request.end, reference + period),
        )
        if value is not None and abs(value - place) > 1e-6 * period
    ]
    raise_all(CapacityError, faults)
    length = round(period / quantum)
    steps = allowed_steps(divisors(length), capacity) if is_whole(period / quantum) else []
    grids = [GridCandidate(0, step, length // step + 1, origin=reference) for step in steps]
    if request.named_spacing is None:
        return sorted(
            (one for one in grids if max(2, capacity.min_points) <= one.count <= most),
            key=lambda one: one.count,
        )
    step = requested_step(request.named_spacing, capacity, unit)
    chosen = [one for one in grids if one.step == step]
    if not chosen:
        near = [
            max((one for one in steps if one < step), default=None),
            min((one for one in steps if one > step), default=None),
        ]
        raise CapacityError(
            Fault(
                message=f"the spacing must divide the period of {period:.10g} {unit}",
                place="table.spacing",
                expected=(
                    f"{' or '.join(f'{one * quantum:.10g}' for one in near if one is not None)}"
                    f" {unit}"
                ),
                found=f"{request.named_spacing:.12g} {unit}",
                hint="set `table: {spacing: ...}` to one of these",
            )
        )
    raise_all(CapacityError, _count_faults(chosen[0].count, capacity, wanted))
    return chosen
