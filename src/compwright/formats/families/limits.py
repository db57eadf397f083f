"""Checks that apply to the tables of every control: numbers, point counts, spacing, ends."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation

#: How far period and modulo of an endless axis may be apart, deg: less than any control resolves.
SAME_TURN = 1e-6
_OUTSIDE = {"hold": "the value of this point", "zero": "zero"}


def invalid_values(compensation: AxisCompensation) -> str:
    """Return as text why the numbers of a table are not valid; empty for a valid table."""
    positions = compensation.positions
    if (
        not positions.shape == compensation.positive.shape == compensation.negative.shape
        or positions.ndim != 1
    ):
        return "positions and values have different lengths"
    numbers = np.concatenate(
        [positions, compensation.positive, compensation.negative, [compensation.backlash]]
    )
    if not np.all(np.isfinite(numbers)):
        return "a value is not a finite number"
    if np.any(np.diff(positions) <= 0):
        return "the positions do not ascend"
    return ""


def size(
    definition: Definition, capacity: Capacity, compensation: AxisCompensation, label: str
) -> list[Fault]:
    """Return a fault if a table has fewer or more points than the control allows."""
    count = compensation.positions.size
    hard = definition.limit_number("max_points")
    most = min((limit for limit in (capacity.max_points, hard) if limit is not None), default=None)
    faults = []
    if count < capacity.min_points:
        faults.append(
            Fault(
                message=f"{label} has too few points",
                expected=f"at least {capacity.min_points}",
                found=str(count),
                hint="give a smaller `table: {spacing: ...}`",
            )
        )
    if most is not None and count > most:
        faults.append(
            Fault(
                message=f"{label} has too many points",
                expected=f"at most {most}",
                found=str(count),
                hint=capacity.fewer_points(count),
            )
        )
    return faults


def curves(capacity: Capacity, compensation: AxisCompensation, label: str) -> list[Fault]:
    """Return faults if a table needs one curve per direction, or a backlash value, and the control
    cannot store these.
    """
    faults = []
    if capacity.curves == 1 and not np.array_equal(compensation.positive, compensation.negative):
        faults.append(
            Fault(
                message=f"{label}: the control has only one table for both directions",
                expected="one table for both directions",
                found="two different tables",
                hint="set `table: {mode: single}` for this axis",
            )
        )
    if capacity.backlash_quantum is None and compensation.backlash != 0:
        faults.append(
            Fault(
                message=f"{label}: the control has no backlash value in addition to the table",
                expected="0",
                found=f"{compensation.backlash:g}",
                hint="include the reversal error in a table for each direction: `table: {mode: "
                "bidirectional}`",
            )
        )
    return faults


def turn(capacity: Capacity, compensation: AxisCompensation, label: str) -> list[Fault]:
    """Return faults if a table repeats on an axis with ends; or if, on an endless axis, it does not
    repeat once per turn, or its two ends differ.
    """
    period = capacity.period
    if period is None:
        if compensation.period is None:
            return []
        return [
            Fault(
                message=f"{label}: the table repeats, but the axis is not endless",
                expected="an axis with `modulo`",
                hint="give a table without `period`, or set `modulo` of the axis in the job",
            )
        ]
    span = (
        float(compensation.positions[-1] - compensation.positions[0])
        if compensation.positions.size
        else 0.0
    )
    faults = []
    if (
        compensation.period is None
        or abs(compensation.period - period) > SAME_TURN
        or abs(span - period) > SAME_TURN
    ):
        faults.append(
            Fault(
                message=f"{label}: the axis is endless, but its table does not repeat once per "
                "turn",
                expected=f"a table that repeats after {period:g}",
                found=f"a table that spans {span:g}",
                hint="make the table span one turn, or remove `modulo` of the axis from the job",
            )
        )
    if span and any(
        curve[0] != curve[-1] for curve in (compensation.positive, compensation.negative)
    ):
        faults.append(
            Fault(
                message=(
                    f"{label}: the table of an endless axis must have the same value at both ends"
                ),
                hint="give both ends of the table the same value",
            )
        )
    return faults


def endless(definition: Definition, axis: Axis, label: str) -> list[Fault]:
    """Return a fault if the axis is endless but the control's tables cannot repeat."""
    if axis.modulo is None or axis.counts_turns or definition.limit("no_endless_axis") is None:
        return []
    return [
        Fault(
            message=f"{label}: a table of this control does not repeat, so an endless axis "
            "cannot have one",
            expected="an axis with ends",
            found=f"modulo {axis.modulo:g}",
            hint="remove `modulo` of the axis from the job, and give its `travel`",
        )
    ]


def spacing(capacity: Capacity, compensation: AxisCompensation, label: str) -> Iterator[Fault]:
    """Yield a fault for points that are closer to each other than the control allows."""
    if compensation.positions.size > 1:
        least = float(np.min(np.diff(compensation.positions)))
        there = np.array(capacity.there)
        if there.shape == compensation.positions.shape and np.allclose(
            there, compensation.positions, rtol=0.0, atol=1e-6 * least
        ):
            return  # the control has run on this grid
        if least < capacity.min_spacing * (1 - 1e-9):
            yield Fault(
                message=f"{label}: the points are too close to each other; "
                f"{capacity.min_spacing_reason}",
                expected=f"{capacity.min_spacing:g} {compensation.kind.unit} or more",
                found=f"{least:g}",
                hint="give a larger `table: {spacing: ...}`",
            )


def ends(definition: Definition, compensation: AxisCompensation, label: str) -> list[Fault]:
    """Return a fault for each end of a table beyond which the control does not continue the
    correction as planned.
    """
    faults: list[Fault] = []
    if not compensation.positions.size:
        return faults
    for side, meant, made, point in (
        ("below", compensation.below, definition.layout.below, 0),
        ("above", compensation.above, definition.layout.above, -1),
    ):
        values = (compensation.positive[point], compensation.negative[point])
        end = "first" if side == "below" else "last"
        if meant != made and any(value != 0 for value in values):
            faults.append(
                Fault(
                    message=(
                        f"{label}: the correction {side} the {end} point is not the same in the "
                        "control and in the plan"
                    ),
                    expected=f"{_OUTSIDE[made]}, as in the control",
                    found=f"{_OUTSIDE[meant]} in the plan",
                    hint="make the table cover the whole travel: `table: {start, end}` in the job",
                )
            )
    return faults


def kind(axis: Axis, compensation: AxisCompensation, label: str) -> list[Fault]:
    """Return a fault if a table in mm is for a rotary axis, or a table in degrees for a linear
    axis.
    """
    if compensation.kind is axis.kind:
        return []
    return [
        Fault(
            message=f"{label}: the table is {compensation.kind}, but the axis is {axis.kind}",
            expected=axis.kind,
            found=compensation.kind,
            hint="correct `kind` of the axis in the job",
        )
    ]
