"""Contents of the card for whole steps by section."""

from __future__ import annotations

from collections.abc import Iterator

from compwright.formats.families.card_words import UNKNOWN
from compwright.formats.families.family import Family
from compwright.formats.families.increments.backlash import backlash_words
from compwright.formats.families.increments.increment_facts import IncrementFacts, increments_of
from compwright.formats.text.values import name_of
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation
from compwright.records.facts import AxisFacts

_ABSOLUTE = (
    "Absolute encoder: no reference return. Leave its adjustment alone (1815): machine zero would"
    " be lost."
)
#: Words of the fields that name a parameter, each with the contents of the parameter.
_PARAMETERS = {
    "reference": "reference_number",
    "first": "first_number",
    "last": "last_number",
    "magnification": "magnification",
    "spacing": "table_spacing",
}


def increment_values(
    family: Family, axis: Axis, compensation: AxisCompensation, facts: AxisFacts
) -> dict[str, str]:
    """Return the card's values of one axis; ``facts``: facts of the axis in the written files."""
    scale, own = family.scale_of(axis), increments_of(facts)
    names = ("reference_number", "first_number", "last_number", "magnification")
    words = {name: getattr(own, name) for name in names}
    values = {
        **{name: str(number) for name, number in words.items() if number is not None},
        **{
            f"at_{word}": name_of(family.definition, quantity)
            for word, quantity in _PARAMETERS.items()
        },
        "unit": axis.kind.unit,
        "detection_unit": f"{scale.quantum('value'):g} {axis.kind.unit}",
        "backlash": _feed_backlash(scale.write("backlash", compensation.backlash), facts),
        "further": "; ".join(
            filter(None, (_further(family, axis, own), *_neighbours(family, axis, facts)))
        ),
        "other_sign": "'+'" if scale.options.get("pitch_sign") == "-" else "'-'",
    }
    if facts.absolute_encoder or axis.encoder.type == "absolute":  # by 1815#5, or by the job
        values["referencing"] = _ABSOLUTE
    positions = compensation.positions
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1):.10g}"
    return values


def _feed_backlash(count: str, facts: AxisFacts) -> str:
    """Return 1851 as in the files; else ``count``, that of the table."""
    held = increments_of(facts).backlash
    return count if held is None else str(held)


def _neighbours(family: Family, axis: Axis, facts: AxisFacts) -> Iterator[str]:
    """Yield remarks on functions in addition to the table; ``facts``: of the axis in the written
    files.
    """
    before = increments_of(family.state.facts_of(family.address(axis)[0]))
    now = increments_of(facts)
    old = {point.number for each in before.hung for point in each.points or ()}
    new = [point for each in now.hung for point in each.points or ()]
    if now.waved and not before.waved:
        yield (
            f"set too: {now.waved}, whose points are in the sheet; its sign and where"
            " its period starts are unconfirmed, so measure one period in its sections with it and"
            " with 14985 to 14987 = 0 (power cycle each time) before production"
        )
    if now.inclined and not before.inclined:
        yield (
            f"set too: {now.inclined}; its sign and unit are unconfirmed, so measure"
            " both ends of the travel with these amounts and with 0 (power cycle each "
            "time) before you switch"
            " on the whole table"
        )
    elif {point.number for point in new} != old:
        kept = ", ".join(point.label for point in new)
        yield f"set too, because the grid moves and these positions stay: {kept}"
    if facts.other_functions:
        kept = "; ".join(each for each in facts.other_functions.split("; ") if "parameter" in each)
        yield f"leave unchanged what is active in addition to the table: {kept}"


def _further(family: Family, axis: Axis, facts: IncrementFacts) -> str:
    """Return the parameters needed in addition to the grid and 1851: second set, turn, backlash at
    rapid traverse. ``facts``: of the axis in the written files, with the turn of an endless axis.
    """
    words = {}
    if "bidirectional" in family.definition.bindings:
        words["3605#0"] = str(int(facts.two_sets))
    if facts.two_sets:
        first, offset = facts.negative_first, facts.negative_offset
        words["3626"] = UNKNOWN if first is None else str(first)
        words["3627"] = UNKNOWN if offset is None else f"{offset} detection units"
    if axis.modulo is not None and facts.turn is not None:
        words[name_of(family.definition, "turn")] = f"{facts.turn:g} {axis.kind.unit}"
    lines = [*(f"{name} = {value}" for name, value in words.items()), backlash_words(facts)]
    return ", ".join(filter(None, lines))
