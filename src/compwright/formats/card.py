"""The steps by which a table gets into the control, with their evidence."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from compwright.formats.addresses import normal_address
from compwright.formats.capacity import scale_for_writing
from compwright.formats.options import resolve_options
from compwright.formats.schema import Definition
from compwright.formats.statements import field_names, print_form
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import Axis, Direction
from compwright.records.correction import AxisCompensation, Evidence

UNKNOWN = "(not known)"


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
            text=print_form(rule.text, {name: known.get(name, UNKNOWN) for name in field_names(rule.text)}),
            evidence=rule.evidence.state,
            source=rule.evidence.source,
        )
        for rule in definition.card
    )


def card_values(
    definition: Definition, axis: Axis, compensation: AxisCompensation, options: Mapping[str, object]
) -> dict[str, str]:
    """Return what the card says about a table: points, start, end, spacing, backlash (in the control's unit), three check values.

    The check values are corrections at nodes near the quarters of the table, by direction, in µm or arcsec.
    """
    scale = scale_for_writing(definition, axis, resolve_options(definition, options))
    node = "table_start" if "table_start" in definition.bindings else "node_position"
    factor = float(scale.factor(node))
    positions = compensation.positions
    values = {"points": str(positions.size), "unit": scale.unit(node), "backlash": f"{compensation.backlash / factor:.10g}"}
    if positions.size:
        values["start"] = f"{positions[0] / factor:.10g}"
        values["end"] = f"{positions[-1] / factor:.10g}"
        values["check"] = _check(compensation)
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1) / factor:.10g}"
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
        **files,
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
