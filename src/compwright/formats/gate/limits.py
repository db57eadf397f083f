"""Every limit of a definition, tested by exceeding it: the writer has to refuse a table beyond
it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families.family import Family
from compwright.foundations.errors import CapacityError, CompwrightError, Fault
from compwright.records.axis import Axis, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation

#: Largest table that is tried: some limits are too large to be reached.
_MOST_POINTS = 20_000


def unenforced_limits(
    control: Family, axis: Axis, compensation: AxisCompensation
) -> Iterator[Fault]:
    """Yield a fault for every limit that the writer does not enforce. ``compensation``: a valid
    table of ``axis``.
    """
    capacity = control.capacity(axis)
    for name, broken, its_axis in _broken(control.definition, axis, compensation, capacity):
        try:
            control.write([broken], [its_axis])
        except CapacityError:
            continue
        except CompwrightError as error:
            message = f"the limit {name} is refused in the wrong way: {error}"
            yield control.definition.text.fault(("limits",), message)
            continue
        message = f"a table that breaks the limit {name} is written all the same"
        yield control.definition.text.fault(("limits",), message)


def _broken(
    definition: Definition, axis: Axis, table: AxisCompensation, capacity: Capacity
) -> Iterator[tuple[str, AxisCompensation, Axis]]:
    for name, broken in _beyond(axis, table, capacity):
        yield name, broken, axis
    step = float(np.min(np.diff(table.positions)))
    feed, per_spacing = (
        definition.limit_number("feed_per_spacing"),
        definition.limit_number("spacing_per_step"),
    )
    if feed is not None and "max_feed" in definition.options:
        yield (
            "feed_per_spacing",
            table,
            replace(axis, options={**axis.options, "max_feed": 2.0 * feed * step}),
        )
    if per_spacing is not None:
        yield (
            "spacing_per_step",
            _with_value(
                table, 0, float(np.round(2.0 * step / per_spacing, 3)) + float(table.positive[1])
            ),
            axis,
        )
    if definition.limit("no_endless_axis") is not None:
        yield "no_endless_axis", table, replace(axis, modulo=360.0)


def _beyond(
    axis: Axis, table: AxisCompensation, capacity: Capacity
) -> Iterator[tuple[str, AxisCompensation]]:
    node = int(np.argmax(np.abs(table.positions - axis.reference)))
    yield (
        "min_points",
        replace(
            table,
            positions=table.positions[:1],
            positive=table.positive[:1],
            negative=table.negative[:1],
        ),
    )
    yield (
        "resolution of a value",
        _with_value(table, node, float(table.positive[node]) + 0.4 * capacity.quantum),
    )
    for side, bound in zip(("lowest", "highest"), capacity.value_range, strict=True):
        if np.isfinite(bound):
            beyond = bound + np.sign(bound) * capacity.quantum * 10
            yield f"{side} value", _with_value(table, node, float(beyond))
    if capacity.curves == 1:
        yield (
            "one curve for both directions",
            replace(table, negative=table.negative + 10 * capacity.quantum),
        )
    if capacity.backlash_quantum is None:
        yield "no backlash in addition to the table", replace(table, backlash=0.001)
    else:
        beyond = capacity.backlash_range[1] + capacity.backlash_quantum * 10
        yield "backlash range", replace(table, backlash=float(beyond))
        yield (
            "resolution of the backlash",
            replace(table, backlash=table.backlash + 0.4 * capacity.backlash_quantum),
        )
    if capacity.max_points is not None and capacity.max_points < _MOST_POINTS:
        yield "max_points", _longer(table, capacity)
    if capacity.spacing == "equidistant" and table.positions.size > 2:
        moved = table.positions.copy()
        moved[1] += 0.3 * (moved[2] - moved[1])
        yield "equal spacing", replace(table, positions=moved)
    if capacity.lattice is not None:
        largest = capacity.lattice.increments[1] * capacity.lattice.magnifications[-1]
        yield "largest increment", _with_value(table, node, (largest + 1) * capacity.quantum * 10)


def _with_value(table: AxisCompensation, node: int, value: float) -> AxisCompensation:
    def changed(curve: FloatArray) -> FloatArray:
        result = curve.copy()
        result[node] = value
        return result

    return replace(table, positive=changed(table.positive), negative=changed(table.negative))


def _longer(table: AxisCompensation, capacity: Capacity) -> AxisCompensation:
    """Return a table of zeros with more points than allowed, on the same grid."""
    step = float(table.positions[1] - table.positions[0])
    count = int(capacity.max_points or 0) + 2
    positions = table.positions[0] + step * np.arange(count)
    return replace(table, positions=positions, positive=np.zeros(count), negative=np.zeros(count))
