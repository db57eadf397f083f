"""What the cards of several families say in the same words."""

from __future__ import annotations

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import print_form
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import NumberScale
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation

#: Stands where a card has no value for a field of its text.
UNKNOWN = "(not known)"
#: Among the values of a card: how many curves the table has that is written.
CURVES = "curves"
#: What has to be done so that the control knows where the axis is, by the kind of encoder.
REFERENCING = {
    "incremental": (
        "Incremental encoder: reference the axis after the power cycle; nothing acts before that."
    ),
    "absolute": (
        "Absolute encoder: no reference return. Leave its adjustment alone: machine zero would be"
        " lost."
    ),
    "distance_coded": (
        "Distance-coded scale: move the axis over two marks after the power cycle; nothing acts"
        " before that."
    ),
}


def typed(value: float) -> str:
    """Return a number as it is typed at a control: digits and a point, never an exponent."""
    return np.format_float_positional(float(f"{value:.10g}"), trim="-")


def table_values(
    definition: Definition, scale: NumberScale, compensation: AxisCompensation
) -> dict[str, str]:
    """Return points, unit, backlash, start, end and spacing of a table, in the control's units:
    lengths in that of the positions, the backlash in its own.
    """
    node = "table_start" if "table_start" in definition.bindings else "node_position"
    lost = "backlash" if "backlash" in definition.bindings else node
    factor = float(scale.factor(node))
    positions = compensation.positions
    values = {
        "points": str(positions.size),
        "unit": scale.unit(node),
        "backlash": typed(compensation.backlash / float(scale.factor(lost))),
        "backlash_unit": scale.unit(lost),
    }
    if positions.size:
        values["start"] = f"{positions[0] / factor:.10g}"
        values["end"] = f"{positions[-1] / factor:.10g}"
    if positions.size > 1:
        step = (positions[-1] - positions[0]) / (positions.size - 1)
        values["spacing"] = f"{step / factor:.10g}"
    return values


def sign_check(compensation: AxisCompensation, where: FloatArray) -> dict[str, str]:
    """Return the two of the positions ``where`` (mm or deg, ascending) between which the table
    changes the distance most: there the sign shows best.
    """
    if compensation.positions.size < 2:
        return {}
    curve = compensation.at(where, Direction.POSITIVE)
    low, high = sorted((int(np.argmin(curve)), int(np.argmax(curve))))
    unit = compensation.kind.unit
    change = float(curve[high] - curve[low]) * outside_factor(unit)
    return {
        "check_from": f"{where[low]:.10g}",
        "check_to": f"{where[high]:.10g}",
        "check_change": f"{change:+.1f} {shown_unit(unit)}",
    }


def file_names(definition: Definition, axis: Axis) -> list[str]:
    """Return how the definition's files are called for an axis, in its order, whether they are
    written or not.
    """
    address, _ = normal_address(definition, axis)
    named = {"axis": address, "system": str(axis.encoder.system - 1)}
    return [print_form(file.name, named) for file in definition.writing]
