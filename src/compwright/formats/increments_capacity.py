"""What one axis of a control with increments by section (FANUC) can hold."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.addresses import normal_address
from compwright.formats.increments_axis import increment_limit
from compwright.formats.increments_entries import OFFSETS
from compwright.formats.numbering import longest_gap
from compwright.formats.options import axis_options
from compwright.formats.scale import Scale
from compwright.formats.schema import Definition
from compwright.formats.section_increments import used_numbers
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import Assumption, ControlState


def increments_capacity(definition: Definition, axis: Axis, options: Mapping[str, object], state: ControlState | None) -> Capacity:
    """Return the limits of one axis' table in mm or deg; ``options`` are the controller's, resolved.

    Raises UsageError for a wrong option of the axis, or where nobody says its detection unit.
    """
    own = axis_options(definition, options, axis)
    address, assumption = normal_address(definition, axis)
    scale = Scale(definition, axis.kind, own, {})
    unit = scale.quantum("value")
    limit = increment_limit(own)
    facts = state.facts if state is not None else {}
    highest = definition.limit_number("max_number") or 0
    gap = longest_gap(highest, used_numbers(facts, [address]), int(str(own.get("first_point", 0))))
    assumed = [assumption] if assumption is not None else []
    least, reason = _least_spacing(definition, axis, own, assumed)
    bound = 10.0 if axis.kind.unit == "mm" else 1.0
    return Capacity(
        format=definition.id,
        curves=2 if axis.modulo is None else 1,
        second_curve="asked",
        spacing="equidistant",
        quantum=unit,
        position_quantum=0.001,
        value_range=(-bound, bound),
        backlash_quantum=scale.quantum("backlash"),
        backlash_range=scale.range("backlash"),
        min_points=definition.limit_number("min_points") or 2,
        # sections, not nodes, have numbers; one more may be needed where the travel starts or ends at the reference
        max_points=max(2, gap),
        lattice=Lattice(
            unit=unit,
            increments=(-limit, limit),
            magnifications=tuple(range(1, (definition.limit_number("max_magnification") or 1) + 1)),
            offset_range=OFFSETS,
            offset_magnified=own.get("offset_magnified") == "yes",
        ),
        interpolation="linear" if own.get("output") == "ramp" else "step",
        anchored=True,
        min_spacing=least,
        min_spacing_reason=reason,
        period=axis.modulo,
        below=definition.layout.below,
        above=definition.layout.above,
        assumed=tuple(assumed),
    )


def _least_spacing(
    definition: Definition, axis: Axis, options: Mapping[str, object], assumed: list[Assumption]
) -> tuple[float, str]:
    rule = definition.limit("feed_per_spacing")
    feed = options.get("max_feed")
    if rule is None or rule.number is None:
        return 0.0, ""
    if not isinstance(feed, (int, float)) or feed <= 0:
        assumed.append(
            Assumption(
                fact=f"axis {axis.name}: smallest interval for its feed",
                value="not checked: the option max_feed is not given",
                evidence=str(rule.evidence),
            )
        )
        return 0.0, ""
    least = float(feed) / rule.number
    return (
        least,
        f"at {feed:g} mm/min (or deg/min) the control needs at least {least:g}: feed / {rule.number} ({rule.evidence.state})",
    )
