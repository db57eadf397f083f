"""Compensation -> the complete set of files that a control loads. Same input, same bytes: no dates,
no order by chance.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.definition.consistency import has_cross
from compwright.formats.definition.options import axis_options, resolve_options
from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.capacity import broken_limits
from compwright.formats.families.columns.reading import read_user_tables
from compwright.formats.families.columns.writing import write_user_tables
from compwright.formats.families.gantry import partner_of
from compwright.formats.families.grid.capacity import capacity_for
from compwright.formats.families.grid.tables import SAME_TURN
from compwright.formats.families.grid.writing import AxisTable, holds_two_curves, write_table_files
from compwright.formats.families.increments.writing import write_increments
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState


def write_tables(
    definition: Definition,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[Axis],
    options: Mapping[str, object],
    state: ControlState | None = None,
    files: Sequence[ControlFile] = (),
) -> tuple[ControlFile, ...]:
    """Return exactly the files that put ``compensations`` into the control, in the order of the
    axes.

    ``axes`` holds the axis of every compensation. ``files``: the control's own, to be patched. With
    a ``state`` what the control's own files answer (its unit, the points it has reserved, the
    numbers of other axes) counts. Raises UsageError for a compensation without an axis,
    CapacityError with everything that the control cannot hold exactly: all limits are checked here
    again, whatever was checked before.
    """
    resolved = resolve_options(definition, options, state)
    pairs = _pairs(definition, compensations, axes)
    if (
        definition.layout.shape == "user_tables" and files
    ):  # what they hold is the limit, whatever was known before
        state = read_user_tables(definition, files, options, [axis for _, axis, _ in pairs])
    pairs = with_partners(definition, pairs)
    faults = [
        fault
        for _, axis, compensation in pairs
        for fault in check_limits(definition, axis, compensation, resolved, state)
    ]
    sound = [pair for pair in pairs if pair[2].positions.size >= 2 and not _unsound(pair[2])]
    if definition.layout.shape == "section_increments":
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return write_increments(definition, sound, resolved, state, files)
    if definition.layout.shape == "user_tables":
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return write_user_tables(definition, pairs, resolved, files)
    written = write_table_files(definition, sound, resolved, state, files, faults)
    raise_all(CapacityError, list(dict.fromkeys(faults)))
    return written


def with_partners(definition: Definition, pairs: Sequence[AxisTable]) -> list[AxisTable]:
    """Return the tables with those of gantry partners, which are the same: on one axis alone a
    table racks the bridge.
    """
    result = {address: (address, axis, compensation) for address, axis, compensation in pairs}
    for _, axis, compensation in pairs:
        if axis.gantry is not None:
            partner = normal_text(definition, axis.gantry)
            result.setdefault(
                partner,
                (partner, partner_of(axis, partner), replace(compensation, address=partner)),
            )
    return list(result.values())


def _pairs(
    definition: Definition, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
) -> list[tuple[str, Axis, AxisCompensation]]:
    by_address = {normal_address(definition, axis)[0]: axis for axis in axes}
    faults = []
    pairs: dict[str, tuple[str, Axis, AxisCompensation]] = {}
    for compensation in compensations:
        found = next((axis for axis in axes if axis.address == compensation.address), None)
        address = (
            normal_address(definition, found)[0]
            if found is not None
            else normal_text(definition, compensation.address)
        )
        if address not in by_address:
            faults.append(
                Fault(
                    message=f"no axis has the address {compensation.address}",
                    expected=", ".join(by_address),
                )
            )
        elif address in pairs:
            faults.append(Fault(message=f"axis {address} has two tables"))
        else:
            pairs[address] = (address, by_address[address], compensation)
    raise_all(UsageError, faults)
    return list(pairs.values())


def _spacing(capacity: Capacity, compensation: AxisCompensation, label: str) -> Iterator[Fault]:
    if compensation.positions.size > 1:
        least = float(np.min(np.diff(compensation.positions)))
        if least < capacity.min_spacing * (1 - 1e-9):
            yield Fault(
                message=f"{label}: the points are too close; {capacity.min_spacing_reason}",
                expected=f"{capacity.min_spacing:g} {compensation.kind.unit} or more",
                found=f"{least:g}",
            )


def _unsound(compensation: AxisCompensation) -> str:
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


def check_limits(
    definition: Definition,
    axis: Axis,
    compensation: AxisCompensation,
    options: Mapping[str, object],
    state: ControlState | None = None,
) -> tuple[Fault, ...]:
    """Return what keeps the control from holding a compensation, apart from single values that are
    not exact.

    Names the limit, by how much it is broken and what would help.
    """
    label = f"axis {axis.name} ({compensation.address})"
    unsound = _unsound(compensation)
    if unsound:
        return (Fault(message=f"{label}: {unsound}"),)
    options = axis_options(definition, resolve_options(definition, options, state), axis)
    if has_cross(definition) and not holds_two_curves(definition, options, compensation):
        options = {
            **options,
            "cec": "absent",
        }  # one table and backlash are the better home for one curve
    try:
        capacity = capacity_for(definition, replace(axis, options={}), options, state)
    except CapacityError as error:
        return error.faults
    faults = [
        *_size(definition, capacity, compensation, label),
        *_curves(capacity, compensation, label),
    ]
    if axis.modulo is not None and definition.limit("no_endless_axis") is not None:
        faults.append(
            Fault(
                message=(
                    f"{label}: the control's table does not repeat, so an endless axis cannot"
                    " have one"
                ),
                expected="an axis with ends",
                found=f"modulo {axis.modulo:g}",
            )
        )
    elif definition.layout.shape == "values_by_index":
        faults.extend(_turn(capacity, compensation, label))
    faults.extend(_spacing(capacity, compensation, label))
    if compensation.kind is not axis.kind:
        faults.append(
            Fault(
                message=f"{label}: the table and the axis differ in kind",
                expected=axis.kind,
                found=compensation.kind,
            )
        )
    if definition.layout.shape == "user_tables":
        faults.extend(broken_limits(definition, axis, compensation, capacity))
    return (*faults, *_ends(definition, compensation, label))


def _size(
    definition: Definition, capacity: Capacity, compensation: AxisCompensation, label: str
) -> list[Fault]:
    count = compensation.positions.size
    hard = definition.limit_number("max_points")
    most = min((limit for limit in (capacity.max_points, hard) if limit is not None), default=None)
    faults = []
    if count < capacity.min_points:
        faults.append(
            Fault(
                message=f"{label}: too few points",
                expected=f"at least {capacity.min_points}",
                found=str(count),
            )
        )
    if most is not None and count > most:
        message = f"{label}: too many points; a wider spacing would help"
        faults.append(Fault(message=message, expected=f"at most {most}", found=str(count)))
    return faults


def _curves(capacity: Capacity, compensation: AxisCompensation, label: str) -> list[Fault]:
    faults = []
    if capacity.curves == 1 and not np.array_equal(compensation.positive, compensation.negative):
        message = (
            f"{label}: the control holds one curve for both directions; put the reversal into the"
            " backlash"
        )
        faults.append(Fault(message=message, expected="one curve", found="two different curves"))
    if capacity.backlash_quantum is None and compensation.backlash != 0:
        message = (
            f"{label}: the control has no backlash value beside the table; put it into the two"
            " curves"
        )
        faults.append(Fault(message=message, expected="0", found=f"{compensation.backlash:g}"))
    return faults


def _turn(capacity: Capacity, compensation: AxisCompensation, label: str) -> list[Fault]:
    """The table of an endless axis spans one turn and closes; another one does not repeat."""
    period = capacity.period
    if period is None:
        if compensation.period is None:
            return []
        return [
            Fault(
                message=f"{label}: the table repeats, the axis does not",
                expected="an axis with modulo",
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
        expected = f"a table that repeats, from end to end {period:g}"
        faults.append(
            Fault(
                message=f"{label}: the axis is endless, its table not",
                expected=expected,
                found=f"{span:g}",
            )
        )
    if span and any(
        curve[0] != curve[-1] for curve in (compensation.positive, compensation.negative)
    ):
        faults.append(
            Fault(
                message=(
                    f"{label}: the table of an endless axis must have the same value at both ends"
                )
            )
        )
    return faults


def _ends(definition: Definition, compensation: AxisCompensation, label: str) -> list[Fault]:
    """The table must mean the same outside its range as the control makes of it, or be zero at that
    end.
    """
    faults: list[Fault] = []
    if not compensation.positions.size:
        return faults
    for side, meant, made, node in (
        ("below", compensation.below, definition.layout.below, 0),
        ("above", compensation.above, definition.layout.above, -1),
    ):
        values = (compensation.positive[node], compensation.negative[node])
        if meant != made and any(value != 0 for value in values):
            faults.append(
                Fault(
                    message=(
                        f"{label}: {side} the table the control does something else than was"
                        " planned"
                    ),
                    expected=made,
                    found=meant,
                )
            )
    return faults
