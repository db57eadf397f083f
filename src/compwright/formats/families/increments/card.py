"""What the card says of whole steps by section."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.schema import Definition
from compwright.formats.families.card_words import REFERENCING, UNKNOWN
from compwright.formats.text.scale import Scale
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation
from compwright.records.facts import Fact


def increment_values(
    axis: Axis,
    compensation: AxisCompensation,
    definition: Definition,
    options: Mapping[str, object],
    facts: Mapping[str, Fact],
) -> dict[str, str]:
    """Return the values of the card of one axis; ``options``: those of the axis."""
    scale = Scale(definition, axis.kind, options, {})
    unit = axis.kind.unit
    values = {
        name: str(facts[name])
        for name in ("reference_number", "first_number", "last_number", "magnification")
        if name in facts
    }
    values["unit"] = unit
    values["detection_unit"] = f"{scale.quantum('value'):g} {unit}"
    values["backlash"] = scale.write("backlash", compensation.backlash)
    values["further"] = _further(axis, facts)
    if facts.get("absolute_encoder") == "yes":  # by 1815#5, whatever the job takes it for
        values["referencing"] = REFERENCING["absolute"]
    values["other_sign"] = "'+'" if options.get("pitch_sign") == "-" else "'-'"
    positions = compensation.positions
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1):.10g}"
    return values


def _further(axis: Axis, facts: Mapping[str, Fact]) -> str:
    """Return what has to be set beside the grid and 1851: second set, turn, backlash at rapid
    traverse.
    """
    two = facts.get("bidirectional") == "yes"
    said = [f"3605#0 = {int(two)}"]
    if two:
        said += [
            f"3626 = {facts.get('negative_first', UNKNOWN)}",
            f"3627 = {facts.get('negative_offset', UNKNOWN)}",
        ]
    if axis.modulo is not None:
        said.append(f"3625 = {axis.modulo:g}")
    if facts.get("separate_rapid") == "yes" and "backlash_rapid" in facts:
        said.append(f"1852 = {facts['backlash_rapid']}")
    return ", ".join(said)
