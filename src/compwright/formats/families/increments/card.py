"""The card's values for a FANUC axis, and the point numbers of its sections for the drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from compwright.formats.families.card_texts import UNKNOWN
from compwright.formats.families.family import Family
from compwright.formats.families.increments.backlash import backlash_words
from compwright.formats.families.increments.increment_facts import IncrementFacts, increments_of
from compwright.formats.text.values import name_of
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation
from compwright.records.facts import AxisFacts
from compwright.records.numbering import NumberedSections, Section
from compwright.words.sentences import SentenceText, control_text, say

_ABSOLUTE = control_text(
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
    """Return the commissioning card's values of one axis, such as point numbers and backlash.

    ``facts``: what the written files state about the axis.
    """
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
        "further": SentenceText(
            say(
                "listed",
                items=[
                    *filter(None, (_further(family, axis, own), *_neighbours(family, axis, facts)))
                ],
                more=0,
            )
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
    """Return the value of 1851 in the files; if it is in none, ``count``, the table's backlash."""
    held = increments_of(facts).backlash
    return count if held is None else str(held)


def _neighbours(family: Family, axis: Axis, facts: AxisFacts) -> Iterator[str]:
    """Yield remarks on functions that are active in addition to the table.

    ``facts``: what the written files state about the axis.
    """
    before = increments_of(family.state.facts_of(family.address(axis)[0]))
    now = increments_of(facts)
    old = {point.number for each in before.hung for point in each.points or ()}
    new = [point for each in now.hung for point in each.points or ()]
    if now.waved and not before.waved:
        yield control_text(
            "set too: {function}, whose points are in the sheet; its sign and where"
            " its period starts are unconfirmed, so measure one period in its sections with it and"
            " with 14985 to 14987 = 0 (power cycle each time) before production",
            function=str(now.waved),
        )
    if now.inclined and not before.inclined:
        yield control_text(
            "set too: {function}; its sign and unit are unconfirmed, so measure"
            " both ends of the travel with these amounts and with 0 (power cycle each "
            "time) before you switch"
            " on the whole table",
            function=str(now.inclined),
        )
    elif {point.number for point in new} != old:
        kept = ", ".join(point.label for point in new)
        yield control_text(
            "set too, because the grid moves and these positions stay: {kept}", kept=kept
        )
    if facts.other_functions:
        kept = "; ".join(each for each in facts.other_functions.split("; ") if "parameter" in each)
        yield control_text(
            "leave unchanged what is active in addition to the table: {kept}", kept=kept
        )


def _further(family: Family, axis: Axis, facts: IncrementFacts) -> str:
    """Return the card's text on parameters to type in next to the table: data set for travel
    towards -, turn, backlash at rapid traverse.

    The parameters of the grid and 1851 are elsewhere on the card. ``facts``: what the written files
    state about the axis, with the turn of an endless axis.
    """
    words = {}
    if "bidirectional" in family.definition.bindings:
        words["3605#0"] = str(int(facts.two_sets))
    if facts.two_sets:
        first, offset = facts.negative_first, facts.negative_offset
        words["3626"] = UNKNOWN if first is None else str(first)
        words["3627"] = (
            UNKNOWN
            if offset is None
            else control_text("{value} detection units", value=str(offset))
        )
    if axis.modulo is not None and facts.turn is not None:
        words[name_of(family.definition, "turn")] = f"{facts.turn:g} {axis.kind.unit}"
    lines = [
        *(
            SentenceText(say("card.parameter", name=name, value=value))
            for name, value in words.items()
        ),
        backlash_words(facts),
    ]
    return SentenceText(say("as_written", text=[*filter(None, lines)]))


def numbered_sections(
    family: Family, axis: Axis, facts: AxisFacts, table: AxisCompensation
) -> NumberedSections | None:
    """Return the sections of a table by point number, for the drawing on the card; None if the axis
    has no table.

    ``facts``: what the written files state about the axis. ``table``: the table as it was read back
    from these files.
    """
    increments = increments_of(facts)
    reference, first, last = (
        increments.reference_number,
        increments.first_number,
        increments.last_number,
    )
    interval = increments.interval
    if reference is None or first is None or last is None or not interval or first > last:
        return None
    begin = reference + 1 if axis.modulo is not None else first
    sections = tuple(
        Section(
            number,
            round(axis.reference + (number - reference - 1) * interval, 9),
            round(axis.reference + (number - reference) * interval, 9),
        )
        for number in range(begin, last + 1)
    )
    names = {
        "first_number": first,
        "reference_number": reference,
        "last_number": last,
    }
    second = increments.negative_first if increments.two_sets else None
    if second is not None:
        names["negative_first"] = second
    marks = tuple((number, name_of(family.definition, name)) for name, number in names.items())
    numbered = NumberedSections(axis.kind.unit, axis.reference, sections, marks, second, ())
    held = _held(family, axis, facts, table)
    words = tuple(_words(family, axis, numbered, reference, first, last, held))
    return NumberedSections(axis.kind.unit, axis.reference, sections, marks, second, words)


def _held(
    family: Family, axis: Axis, facts: AxisFacts, table: AxisCompensation
) -> Mapping[int, int]:
    """Return the increments by point number, as read back, for an axis that is not endless."""
    scale, increments = family.scale_of(axis), increments_of(facts)
    unit = scale.quantum("value") * (increments.magnification or 0)
    sign = -1 if scale.options.get("pitch_sign") == "-" else 1
    if axis.modulo is not None or increments.first_number is None or not unit:
        return {}
    steps = np.round(np.diff(table.positive) / unit).astype(int) * sign
    return dict(enumerate((int(step) for step in steps), start=increments.first_number))


def _words(
    family: Family,
    axis: Axis,
    numbered: NumberedSections,
    reference: int,
    first: int,
    last: int,
    held: Mapping[int, int],
) -> Iterator[str]:
    unit, zero = numbered.unit, f"{numbered.reference:.10g}"
    at = {
        name: name_of(family.definition, f"{name}_number")
        for name in ("reference", "first", "last")
    }
    by_number = {section.number: section for section in numbered.sections}
    yield control_text(
        "A point holds the change of the correction over its own section, looking from - to +, in"
        " detection units times the magnification; at the reference position ({zero} {unit}) the"
        " correction is 0.",
        zero=zero,
        unit=unit,
    )
    if axis.modulo is not None:
        same = control_text(
            "it stands for the same section as point {last} and must hold the same value",
            last=str(last),
        )
        yield control_text(
            "{parameter} = {reference} is the number of the reference: {owns};"
            " {next} to {last} are the sections of one turn and add up to 0.",
            parameter=at["reference"],
            reference=str(reference),
            owns=same if first == reference else control_text("it owns no section"),
            next=str(reference + 1),
            last=str(last),
        )
    elif reference in by_number:
        yield control_text(
            "{parameter} = {number} {owns}, at the reference.",
            **_owning(at["reference"], by_number[reference], unit),
        )
    if axis.modulo is None:
        yield control_text(
            "{parameter} = {number} {owns}, the first.",
            **_owning(at["first"], by_number[first], unit),
        )
    yield control_text(
        "{parameter} = {number} {owns}, the last.", **_owning(at["last"], by_number[last], unit)
    )
    for number in sorted({first, last} & set(held)):
        section = by_number[number]
        if section.high <= axis.travel[0] or section.low >= axis.travel[1]:
            yield control_text(
                "Point {number} holds {value}: its section lies beyond the travel.",
                number=str(number),
                value=str(held[number]),
            )
    if numbered.second is not None:
        yield control_text(
            "For travel in - the same sections have the numbers {first} to {last} ({parameter}).",
            first=str(numbered.second),
            last=str(numbered.second + last - first),
            parameter=name_of(family.definition, "negative_first"),
        )


def _owning(parameter: str, section: Section, unit: str) -> dict[str, str]:
    """Return the texts that the drawing shows for one table section: parameter, point number and
    range.
    """
    low, high = f"{section.low:.10g}", f"{section.high:.10g}"
    owns = control_text("owns {low} to {high} {unit}", low=low, high=high, unit=unit)
    return {"parameter": parameter, "number": str(section.number), "owns": owns}
