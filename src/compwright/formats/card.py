"""The steps by which a table gets into the control, with their evidence."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from compwright.formats.addresses import normal_address
from compwright.formats.axis_reading import Fact
from compwright.formats.capacity import scale_for_writing
from compwright.formats.cec import CEC_PAIR
from compwright.formats.consistency import has_cross
from compwright.formats.options import axis_options, resolve_options
from compwright.formats.scale import Scale
from compwright.formats.schema import Definition
from compwright.formats.statements import field_names, print_form
from compwright.formats.user_tables_capacity import user_card_values
from compwright.foundations.units import outside_factor, outside_unit, shown_unit
from compwright.records.axis import Axis, Direction
from compwright.records.correction import AxisCompensation, Evidence

UNKNOWN = "(not known)"
#: Among the values of a card: how many curves the table has that is written.
CURVES = "curves"


@dataclass(frozen=True, slots=True)
class CardStep:
    """One step for the engineer at the control."""

    title: str
    text: str
    evidence: Evidence
    source: str = ""


def card_steps(definition: Definition, axis: Axis, values: Mapping[str, str]) -> tuple[CardStep, ...]:
    """Return the steps for one axis.

    ``values`` fill the fields of the text (see `card_values`); a missing one reads "(not known)".
    """
    known = {**_axis_values(definition, axis), **values}
    return tuple(
        CardStep(
            title=rule.title,
            text=print_form(text, {name: known.get(name, UNKNOWN) for name in field_names(text)}),
            evidence=rule.evidence.state,
            source=rule.evidence.source,
        )
        for rule in definition.card
        for text in (rule.two_curves if known.get(CURVES) == "2" else rule.text,)
    )


def card_values(
    definition: Definition,
    axis: Axis,
    compensation: AxisCompensation,
    options: Mapping[str, object],
    facts: Mapping[str, Fact] | None = None,
) -> dict[str, str]:
    """Return what the card says about a table: points, start, end, spacing, backlash (in the control's unit), three check values.

    The check values are corrections at nodes near the quarters of the table, by direction, in µm or arcsec. ``facts``: what the
    files that hold the table say of the axis (`ControlState.facts`), such as its point numbers.
    """
    resolved = resolve_options(definition, options)
    if definition.layout.shape == "section_increments":
        return _increment_values(axis, compensation, definition, axis_options(definition, resolved, axis), facts or {})
    scale = scale_for_writing(definition, axis, resolved)
    node = "table_start" if "table_start" in definition.bindings else "node_position"
    factor = float(scale.factor(node))
    positions = compensation.positions
    values = {"points": str(positions.size), "unit": scale.unit(node), "backlash": f"{compensation.backlash / factor:.10g}"}
    if has_cross(definition) and not np.array_equal(compensation.positive, compensation.negative):
        values[CURVES] = "2"
    values |= _cross_values(facts or {})
    if positions.size:
        values["start"] = f"{positions[0] / factor:.10g}"
        values["end"] = f"{positions[-1] / factor:.10g}"
        values["check"] = _check(compensation)
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1) / factor:.10g}"
    if definition.layout.shape == "user_tables":
        values.update(user_card_values(definition, axis, compensation, resolved))
    return values


def _axis_values(definition: Definition, axis: Axis) -> dict[str, str]:
    address, _ = normal_address(definition, axis)
    named = {"axis": address, "system": str(axis.encoder.system - 1)}
    files = {f"file_{number}": print_form(file.name, named) for number, file in enumerate(definition.writing, start=1)}
    return {
        "name": axis.name,
        "address": address,
        "system": str(axis.encoder.system),
        "index": str(axis.encoder.system - 1),
        "reference": f"{axis.reference:.10g}",
        "reference_return": axis.reference_return.value,
        "unit": axis.kind.unit,
        "gantry": _gantry(axis),
        "referencing": _REFERENCING[axis.encoder.type],
        **files,
    }


def _gantry(axis: Axis) -> str:
    if axis.gantry is None:
        return (
            f"Axis {axis.name} leads no gantry as far as the job says. If it does, stop: a table on the leading axis alone "
            "racks the bridge. Name its synchronised axis in the job (gantry), so that it gets the same table."
        )
    return (
        f"Axis {axis.name} leads a gantry: do every step for the synchronised axis {axis.gantry} too, before anything moves. "
        "A table on the leading axis alone racks the bridge."
    )


def _cross_values(facts: Mapping[str, Fact]) -> dict[str, str]:
    """Return which tables between axes hold the two directions, as far as the files that were written say it."""
    pair = str(facts.get(CEC_PAIR, "")).split()
    return {"table_positive": pair[0], "table_negative": pair[1]} if len(pair) == 2 else {}


def _increment_values(
    axis: Axis,
    compensation: AxisCompensation,
    definition: Definition,
    options: Mapping[str, object],
    facts: Mapping[str, Fact],
) -> dict[str, str]:
    scale = Scale(definition, axis.kind, options, {})
    unit = axis.kind.unit
    values = {
        name: str(facts[name]) for name in ("reference_number", "first_number", "last_number", "magnification") if name in facts
    }
    values["unit"] = unit
    values["detection_unit"] = f"{scale.quantum('value'):g} {unit}"
    values["backlash"] = scale.write("backlash", compensation.backlash)
    values["other_sign"] = "'+'" if options.get("pitch_sign") == "-" else "'-'"
    positions = compensation.positions
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1):.10g}"
        values["check"] = _check(compensation)
        values |= _sign_check(compensation)
    return values


#: What has to be done so that the control knows where the axis is, by the kind of encoder.
_REFERENCING = {
    "incremental": "Incremental encoder: reference the axis after the power cycle; nothing acts before that.",
    "absolute": "Absolute encoder: no reference return. Leave its adjustment alone (FANUC 1815): machine zero would be lost.",
    "distance_coded": "Distance-coded scale: move the axis over two marks after the power cycle; nothing acts before that.",
}


def _sign_check(compensation: AxisCompensation) -> dict[str, str]:
    """Return the two nodes between which the table changes the distance most: there the sign shows best."""
    curve = compensation.curve(Direction.POSITIVE)
    low, high = sorted((int(np.argmin(curve)), int(np.argmax(curve))))
    unit = compensation.kind.unit
    change = float(curve[high] - curve[low]) * outside_factor(unit)
    return {
        "check_from": f"{compensation.positions[low]:.10g}",
        "check_to": f"{compensation.positions[high]:.10g}",
        "check_change": f"{change:+.1f} {shown_unit(unit)}",
    }


def _check(compensation: AxisCompensation) -> str:
    last = compensation.positions.size - 1
    nodes = np.unique(np.round(np.array([0.25, 0.5, 0.75]) * last).astype(int))
    unit = compensation.kind.unit
    factor, shown = outside_factor(unit), outside_unit(unit).replace("um", "µm")
    parts = []
    for node in nodes:
        plus = compensation.total(Direction.POSITIVE)[node] * factor
        minus = compensation.total(Direction.NEGATIVE)[node] * factor
        parts.append(f"{compensation.positions[node]:.10g} {unit}: {plus:+.1f} {shown} arriving in +, {minus:+.1f} {shown} in -")
    return "; ".join(parts)
