"""Point number of each section of an axis, for the drawing on the card."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from compwright.formats.families.family import Family
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.text.values import name_of
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation
from compwright.records.facts import AxisFacts
from compwright.records.numbering import NumberedSections, Section


def numbered_sections(
    family: Family, axis: Axis, facts: AxisFacts, table: AxisCompensation
) -> NumberedSections | None:
    """Return the sections by number, from the written files (``facts``, and the ``table`` that was
    read back); None if those hold no table.
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
    """Return the increments at the points of an axis with ends, by number, as read back."""
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
    yield (
        "A point holds the change of the correction over its own section, looking from - to +, in"
        f" detection units times the magnification; at the reference position ({zero} {unit}) the"
        " correction is 0."
    )
    if axis.modulo is not None:
        owns = (
            f"it stands for the same section as point {last} and must hold the same value"
            if first == reference
            else "it owns no section"
        )
        yield (
            f"{at['reference']} = {reference} is the number of the reference: {owns};"
            f" {reference + 1} to {last} are the sections of one turn and add up to 0."
        )
    elif reference in by_number:
        span = _span(by_number[reference], unit)
        yield f"{at['reference']} = {reference} {span}, at the reference."
    if axis.modulo is None:
        yield f"{at['first']} = {first} {_span(by_number[first], unit)}, the first."
    yield f"{at['last']} = {last} {_span(by_number[last], unit)}, the last."
    for number in sorted({first, last} & set(held)):
        section = by_number[number]
        if section.high <= axis.travel[0] or section.low >= axis.travel[1]:
            yield f"Point {number} holds {held[number]}: its section lies beyond the travel."
    if numbered.second is not None:
        end = numbered.second + last - first
        yield (
            f"For travel in - the same sections have the numbers {numbered.second} to {end}"
            f" ({name_of(family.definition, 'negative_first')})."
        )


def _span(section: Section, unit: str) -> str:
    return f"owns {section.low:.10g} to {section.high:.10g} {unit}"
