"""Limits of an axis on a control with user-made tables (HEIDENHAIN), and faults of tables that
exceed these limits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.sources import AxisNumbers
from compwright.formats.families.columns.values import (
    MOST_DOUBLINGS,
    SMALLEST_SPACING,
    TURN,
    column_scale,
)
from compwright.formats.families.family import Family
from compwright.formats.text.scale import EXACTNESS
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption, AxisCompensation
from compwright.words.sentences import control_text, unconfirmed


def by_line(options: Mapping[str, object]) -> bool:
    """Return whether the linear error parameter corrects an axis, not a table (method "line")."""
    return options.get("method") == "line"


def columns_capacity(control: Family, axis: Axis) -> Capacity:
    """Return the limits of an axis' table, such as point count and spacing, in mm or deg.

    Raises UsageError for a wrong option of the axis, CapacityError if the control has no such table
    or parameter.
    """
    definition, state, own = control.definition, control.state, control.options_of(axis)
    address, _ = control.address(axis)
    raise_all(CapacityError, list(_impossible(definition, axis, own)))
    scale = column_scale(definition, axis.kind, own)
    slope = column_scale(definition, AxisKind.LINEAR, own)
    facts = state.facts_of(address).stated
    line, endless = by_line(own), axis.modulo is not None
    shared = [one for one in state.cross if one.input == address]
    fixed = shared[0].positions if shared and facts.get("own_column") and not line else None
    second = own.get("backlash_column") == "second_curve" and bool(facts.get("second_column"))
    return Capacity(
        format=definition.id,
        curves=2 if second else 1,
        spacing="equidistant",  # listed positions too: MANUALplus 620 technical manual p715
        quantum=scale.quantum("value"),
        position_quantum=scale.quantum("node_position"),
        value_range=slope.range("slope") if line else scale.range("value"),
        backlash_quantum=scale.quantum("backlash"),
        backlash_range=scale.range("backlash"),
        min_points=0 if line else definition.limit_number("min_points") or 2,
        max_points=_max_points(definition, own),
        spacings=spacings(own),
        anchored=endless,
        period=TURN if endless else None,
        line=slope.quantum("slope") if line else None,
        points=None if fixed is None else tuple(float(point) for point in fixed),
        there=control.existing_grid(axis),
        cover=(
            0 if endless or line or axis.kind is AxisKind.ROTARY else 1
        ),  # of a turn only 0 to 360 degrees are used
        typed=not (line or facts.get("own_column")),
        below=definition.layout.below,
        above=definition.layout.above,
        assumed=tuple(_assumed(definition, axis, own, second=second)),
    )


def spacings(options: Mapping[str, object]) -> tuple[float, ...] | None:
    """Return the point spacings that the option spacing_rule allows, mm or deg; None: any."""
    if options.get("spacing_rule") != "power_of_two":
        return None
    return tuple(float(2**power * SMALLEST_SPACING) for power in range(MOST_DOUBLINGS + 1))


def _max_points(definition: Definition, options: Mapping[str, object]) -> int | None:
    given, hard = options.get("max_points"), definition.limit_number("max_points")
    known = [limit for limit in (given, hard) if isinstance(limit, int)]
    return min(known) if known else None


def _impossible(
    definition: Definition, axis: Axis, options: Mapping[str, object]
) -> Iterator[Fault]:
    rotary = axis.kind is AxisKind.ROTARY
    if by_line(options) and rotary:
        yield Fault(
            message=f"{name_of(definition, 'slope')} has no effect on rotary axes",
            place="method",
            expected="method: table",
            found="method: line",
            hint="set `method: table` in the options of this axis",
        )
    if axis.modulo is not None and (not rotary or axis.modulo != TURN):
        yield Fault(
            message="a repeating table needs a rotary axis and spans 0 to 360 degrees",
            place="modulo",
            expected=f"modulo: {TURN:g} on a rotary axis",
            found=f"modulo: {axis.modulo:g} on a {axis.kind} axis",
            hint="correct `kind`, `travel` or `modulo` of the axis in the job",
        )
    if axis.modulo is not None and options.get("spacing_rule") == "power_of_two":
        yield Fault(
            message=(
                "a spacing of 0.0001 degrees times a power of two (`spacing_rule: power_of_two`) "
                "cannot divide one turn into 256 points or fewer"
            ),
            place="spacing_rule",
            expected="spacing_rule: free, or a table that is typed in by hand",
            found="spacing_rule: power_of_two",
            hint=(
                "set `spacing_rule: free` in the options of this axis, or type the values in by "
                "hand"
            ),
        )


def _assumed(
    definition: Definition, axis: Axis, options: Mapping[str, object], *, second: bool
) -> Iterator[Assumption]:
    if options.get("backlash_column") == "second_curve" and not second:
        yield Assumption(
            fact=control_text("axis {name}: curve for travel in -", name=axis.name),
            value=control_text("none: no table of the axis with a column BACKLASH was given"),
            evidence=unconfirmed(control_text("an entry sheet has no place for it")),
        )
    if not by_line(options):
        yield Assumption(
            fact=control_text("axis {name}: outside the table", name=axis.name),
            value=control_text(
                "the end values hold; let the table reach one spacing beyond the travel on each"
                " side"
            ),
            evidence=definition.layout.evidence.text,
        )


def broken_limits(
    control: Family, axis: Axis, compensation: AxisCompensation, capacity: Capacity
) -> Iterator[Fault]:
    """Yield a fault for each limit of this family of controls that a compensation breaks."""
    label, unit = f"axis {axis.name} ({compensation.address})", axis.kind.unit
    if compensation.interpolation != "linear" or compensation.others:
        yield Fault(
            message=f"{label}: the control has only one table, with straight lines between its "
            "points, and the planned compensation needs more",
            hint="set `table: {mode: single}` for this axis",
        )
    yield from _line_faults(label, axis, compensation, capacity)
    points = compensation.positions
    if points.size < 2:
        return
    yield from _grid_faults(label, unit, np.diff(points), capacity)
    rule = control.definition.limit_number("spacing_per_step")
    if rule is not None:
        yield from _steep_faults(label, unit, compensation, rule)
    if axis.kind is AxisKind.ROTARY:
        yield from _turn_faults(label, compensation, capacity)


def _line_faults(
    label: str, axis: Axis, compensation: AxisCompensation, capacity: Capacity
) -> Iterator[Fault]:
    """Yield a fault if a linear parameter and a table are both set, because they exclude each
    other.
    """
    if capacity.line is not None and compensation.positions.size:
        yield Fault(
            message=f"{label}: the control uses either the linear parameter or a table, not both",
            expected="no table",
            found="a table",
            hint=(
                "leave the table out; to use a table instead of the linear parameter, set "
                "`method: table` in the options of this axis"
            ),
        )
    if capacity.line is None and compensation.slope:
        yield Fault(
            message=f"{label}: the linear parameter has no effect, because the control uses a "
            "table",
            expected="0 mm/m",
            found=f"{compensation.slope * 1000:g} mm/m",
            hint=(
                "set the linear parameter to 0; to use it instead of a table set `method: "
                "line` in the options of this axis"
            ),
        )
    if capacity.line is not None and compensation.slope and compensation.origin != axis.reference:
        yield Fault(
            message=f"{label}: the straight-line correction must be zero at the reference position",
            expected=f"zero at {axis.reference:g} {axis.kind.unit}",
            found=f"zero at {compensation.origin:g}",
            hint="make the plan again with `compwright run`",
        )


def _steep_faults(
    label: str, unit: str, compensation: AxisCompensation, rule: int
) -> Iterator[Fault]:
    points, values = compensation.positions, compensation.positive
    steps = np.diff(points)
    worst = int(np.argmax(np.abs(np.diff(values)) - steps / rule))
    step = float(abs(values[worst + 1] - values[worst]))
    if step > float(steps[worst]) / rule * (1 + 1e-9):
        yield Fault(
            message=f"{label}: neighbouring values at {points[worst]:g} {unit} differ by more "
            "than the control allows",
            expected=f"at most spacing / {rule} = {float(steps[worst]) / rule:.6g} {unit}",
            found=f"{step:.6g} {unit}",
            hint="give a wider `table: {spacing: ...}` for this axis",
        )


def _grid_faults(label: str, unit: str, steps: np.ndarray, capacity: Capacity) -> Iterator[Fault]:
    slack = EXACTNESS * capacity.position_quantum
    if capacity.spacing == "equidistant" and np.ptp(steps) > slack:
        yield Fault(
            message=f"{label}: the points are not equally spaced",
            expected="equally spaced points, in the existing table too",
            found=f"{np.min(steps):.10g} to {np.max(steps):.10g} {unit}",
            hint=(
                "correct the rows of the table in the control so that they are equally spaced, "
                "measure again, then run the job again"
            ),
        )
    elif capacity.spacings is not None and capacity.points is None:
        near = min(capacity.spacings, key=lambda one: abs(one - float(steps[0])))
        if abs(near - float(steps[0])) > slack:
            yield Fault(
                message=(
                    f"{label}: the spacing is not 0.0001 {unit} times a power of two, as "
                    "the option spacing_rule demands"
                ),
                expected=f"a spacing such as {near:.10g} {unit}",
                found=f"{steps[0]:.10g} {unit}",
                hint=f"set `table: {{spacing: {near:.10g}}}` for this axis",
            )


def _turn_faults(label: str, compensation: AxisCompensation, capacity: Capacity) -> Iterator[Fault]:
    points = compensation.positions
    if capacity.period is None:
        if points[0] < 0 or points[-1] > TURN:
            yield Fault(
                message=(
                    f"{label}: the control uses only the entries from 0 to 360 degrees of a rotary"
                    " axis"
                ),
                expected="a travel within 0 to 360, or modulo: 360 in the job",
                found=f"a table from {points[0]:g} to {points[-1]:g}",
                hint="set a `travel` within 0 to 360, or `modulo: 360`, for this axis in the job",
            )
        return
    ends = [(curve[0], curve[-1]) for curve in (compensation.positive, compensation.negative)]
    if abs(points[-1] - points[0] - TURN) > EXACTNESS * capacity.position_quantum or any(
        first != last for first, last in ends
    ):
        yield Fault(
            message=(
                f"{label}: the table of an endless axis must span one turn and have the same value"
                " at both ends"
            ),
            expected=f"{TURN:g} degrees, equal end values",
            found=f"{points[-1] - points[0]:g} degrees, "
            f"end values {ends[0][0]:g} and {ends[0][1]:g}",
            hint="run the job again, so that the table is made for a whole turn",
        )


#: In the place of the number of an axis that no file gives.
_NO_NUMBER = control_text("(see the axis list of the machine)")


def card_values(control: Family, axis: Axis, compensation: AxisCompensation) -> dict[str, str]:
    """Return the card values that only this family has: axis number, parameter bit, table text."""
    own = control.options_of(axis)
    address, _ = control.address(axis)
    number = AxisNumbers(control.definition, [axis]).number(address)
    unit = axis.kind.unit
    points = compensation.positions
    values = {
        "number": _NO_NUMBER if number is None else str(number),
        "bit": _NO_NUMBER if number is None else str(number - 1),
        "nonlinear": "1" if points.size else "0",
        "linear": column_scale(control.definition, AxisKind.LINEAR, own).write(
            "slope", compensation.slope
        ),
        "table_values": str(own["table_values"]),
        "table": control_text("no table"),
    }
    if points.size:
        spacing = (points[-1] - points[0]) / max(points.size - 1, 1)
        every = control_text(", every {spacing} {unit}", spacing=f"{spacing:.10g}", unit=unit)
        values["table"] = control_text(
            "{points} points from {start} to {end} {unit}{every}",
            points=str(points.size),
            start=f"{points[0]:.10g}",
            end=f"{points[-1]:.10g}",
            unit=unit,
            every=every if points.size > 1 else "",
        )
    return values
