"""What one axis of the control can hold, from the definition, the options and the control's own
files.
"""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.consistency import curves, grid
from compwright.formats.definition.options import settled_number
from compwright.formats.definition.schema import Choice, Definition, OptionValue
from compwright.formats.families.grid.beside import MODULO_START, RANGE_START, RANGE_START_SAID
from compwright.formats.families.grid.turns import RANGE_QUANTITY, spacings_from
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import Scale
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption, ControlState


def scale_for_writing(definition: Definition, axis: Axis, options: Mapping[str, object]) -> Scale:
    """Return how numbers of an axis are written; choices are those that the options ask for."""
    return Scale(definition, axis.kind, options, written_choices(definition, options))


def written_choices(definition: Definition, options: Mapping[str, object]) -> dict[str, str]:
    """Return the neutral word of every choice as it will be written."""
    return {
        name: binding.values[written_text(binding, options)]
        for name, binding in definition.bindings.items()
        if isinstance(binding, Choice)
    }


def written_text(binding: Choice, options: Mapping[str, object]) -> str:
    """Return the text of a choice as it will be written."""
    return (
        str(options[binding.writes.option])
        if isinstance(binding.writes, OptionValue)
        else binding.writes
    )


def grid_capacity(
    definition: Definition, axis: Axis, options: Mapping[str, object], state: ControlState | None
) -> Capacity:
    """Return the limits of one axis' own table in mm or deg; ``options``: those of the axis."""
    address, assumption = normal_address(definition, axis)
    assumed = [assumption] if assumption is not None else []
    scale = scale_for_writing(definition, axis, options)
    facts = state.facts.get(address, {}) if state is not None else {}
    assumed += _turn_unsaid(definition, axis, facts)
    value, node = curves(definition)[0], grid(definition)[0]
    beside = (
        "backlash" in definition.bindings and definition.limit("no_backlash_beside_table") is None
    )
    return Capacity(
        format=definition.id,
        curves=1 if definition.layout.pairing == "none" else 2,
        spacing="equidistant" if definition.layout.shape == "values_by_index" else "free",
        quantum=scale.quantum(value),
        position_quantum=scale.quantum(node),
        value_range=scale.range(value),
        backlash_quantum=scale.quantum("backlash") if beside else None,
        backlash_range=scale.range("backlash") if beside else (0.0, 0.0),
        min_points=definition.limit_number("min_points") or 1,
        max_points=_max_points(definition, axis, options, facts.get("max_points"), assumed),
        below=definition.layout.below,
        above=definition.layout.above,
        most_points=definition.limit_number("max_points"),
        period=_period(definition, axis),
        spacings=_spacings(definition, axis, scale.quantum(node), facts),
        assumed=tuple(assumed),
    )


def _period(definition: Definition, axis: Axis) -> float | None:
    """Return the turn of an endless axis whose table repeats; on a linear axis modulo has no
    meaning.
    """
    if (
        definition.layout.shape != "values_by_index"
        or definition.limit("no_endless_axis") is not None
    ):
        return None
    return axis.modulo if axis.kind is AxisKind.ROTARY else None


def _turn_unsaid(
    definition: Definition, axis: Axis, facts: Mapping[str, object]
) -> list[Assumption]:
    """Return what is taken for granted of the turn of an endless axis: that the control wraps it,
    and where its turn begins.
    """
    if (
        _period(definition, axis) is None
        or RANGE_QUANTITY not in definition.bindings
        or facts.get(RANGE_START_SAID)
    ):
        return []
    unsaid = [] if RANGE_START in facts else [("that the control wraps it (MD30310)", "yes")]
    unsaid.append(("where its turn begins (MD30340)", f"{MODULO_START:g} deg"))
    return [
        Assumption(f"axis {axis.name}: {fact}", value, "unconfirmed: in no file")
        for fact, value in unsaid
    ]


def _spacings(
    definition: Definition, axis: Axis, quantum: float, facts: Mapping[str, object]
) -> tuple[float, ...] | None:
    """Return the spacings of an endless axis whose reference is not where its range begins; None:
    no such rule.
    """
    period = _period(definition, axis)
    if period is None or RANGE_QUANTITY not in definition.bindings:
        return None
    said = facts.get(RANGE_START)
    start = float(said) if isinstance(said, (int, float)) else MODULO_START
    return spacings_from(axis.reference, start, period, quantum)


def _max_points(
    definition: Definition,
    axis: Axis,
    options: Mapping[str, object],
    fact: object,
    assumed: list[Assumption],
) -> int | None:
    hard = definition.limit_number("max_points")
    if definition.limit("points_reserved") is None:
        return hard
    name = next(
        name for name, option in definition.options.items() if option.settled_by == "max_points"
    )
    reserved = settled_number(definition, name, options, fact)
    if reserved is None:
        what = (
            "the control has reserved none yet"
            if fact == 0
            else "the control's files do not say it"
        )
        assumed.append(
            Assumption(
                fact=f"axis {axis.name}: number of points the control can hold",
                value="as many as are needed; the card says how many to set",
                evidence=f"unconfirmed: {what}",
            )
        )
        return None
    return reserved if hard is None else min(reserved, hard)
