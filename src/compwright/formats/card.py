"""Steps of the commissioning card: how to load a table into the control, and what to check if it
has no effect.

The steps are sentences of the control's definition, with their evidence.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.formats.definition.schema import CardRule, Definition, LookRule, Measure
from compwright.formats.definition.statements import field_names
from compwright.formats.families.card_texts import CURVES, REFERENCING, UNKNOWN, numbered_files
from compwright.formats.families.family import Family
from compwright.formats.families.resolved_definition import ResolvedDefinition
from compwright.formats.text.addresses import normal_address
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, Evidence
from compwright.records.verification import LoadingName
from compwright.words.sentences import ControlText, SentenceText, control_text, say

#: A field with a longer value is a sentence and keeps its place in the text.
_LONGEST_CELL = 48
#: The heading of the column that names the axis of a row.
AXIS_COLUMN = "axis"


@dataclass(frozen=True, slots=True)
class CardStep:
    """One step of the commissioning card: title, text, evidence for the text, and a table of the
    values that differ between axes.

    ``heads``: headings of the columns of this table. ``rows``: its rows, one per axis. The text
    refers to a column as ``‹head›``.
    """

    title: str
    text: str
    evidence: Evidence
    source: str = ""
    heads: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


def card_steps(
    definition: Definition, axis: Axis, values: Mapping[str, str]
) -> tuple[CardStep, ...]:
    """Return the commissioning card's steps for one axis. ``values``: texts for the ``{name}``
    fields of these steps, by field name; see `card_steps_of_all`.
    """
    return card_steps_of_all(definition, [(axis, values)])


def card_steps_of_all(
    definition: Definition,
    axes: Sequence[tuple[Axis, Mapping[str, str]]],
    rules: Sequence[CardRule] | None = None,
) -> tuple[CardStep, ...]:
    """Return the commissioning card's steps for several ``axes``, each given with its texts by
    field name. ``rules``: the steps to return (None: all steps of the definition).

    The texts of each axis fill the ``{name}`` fields of the steps (see `AxisCard`). A missing text
    reads "(not known)". A step without any text is left out. A text that is the same for all axes
    is printed once. Short values that differ are put into a table with a row per axis.
    """
    known = [{**axis_values(definition, axis), **values} for axis, values in axes]
    return tuple(
        CardStep(
            ControlText(rule.title, {}),
            text,
            rule.evidence.state,
            rule.evidence.source,
            heads,
            rows,
        )
        for rule in (definition.card if rules is None else rules)
        for text, heads, rows in (
            _for_all(
                [rule.two_curves if of.get(CURVES) == "2" else rule.text for of in known], known
            ),
        )
        if text.strip()
    )


def _for_all(
    forms: Sequence[str], known: Sequence[Mapping[str, str]]
) -> tuple[str, tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """Return the text of one card step for all axes, then the column heads and rows of a table with
    the short values that differ between axes (both empty if none differ). ``forms``: the step's
    text with ``{name}`` fields, for each axis; ``known``: the texts for these fields.
    """
    filled = [
        {name: of.get(name, UNKNOWN) for name in field_names(form)}
        for form, of in zip(forms, known, strict=True)
    ]
    if len(set(forms)) == 1:
        differing = [
            name
            for name in dict.fromkeys(field_names(forms[0]))
            if len({of[name] for of in filled}) > 1
        ]
        if differing and all(len(of[name]) <= _LONGEST_CELL for of in filled for name in differing):
            heads = [name.rstrip("0123456789").strip("_").replace("_", " ") for name in differing]
            named = {name: f"‹{head}›" for name, head in zip(differing, heads, strict=True)}
            rows = tuple(
                (of["name"], *(values[name] for name in differing))
                for of, values in zip(known, filled, strict=True)
            )
            return ControlText(forms[0], {**filled[0], **named}), (AXIS_COLUMN, *heads), rows
    lines = dict.fromkeys(map(ControlText, forms, filled))
    return SentenceText(say("card.lines", texts=lines)), (), ()


def axis_values(definition: Definition, axis: Axis) -> dict[str, str]:
    """Return the values of one axis for the ``{name}`` fields of a definition's texts, such as its
    address, measuring system, reference and file names.
    """
    address, _ = normal_address(definition, axis)
    return {
        "name": axis.name,
        "sheet": axis.name,
        "address": address,
        "system": str(axis.encoder.system),
        "index": str(axis.encoder.system - 1),
        "reference": f"{axis.reference:.10g}",
        "reference_return": axis.reference_return.value,
        "unit": axis.kind.unit,
        "gantry": gantry_words(axis),
        "archive": "",
        "emptied": "",
        "load": "",
        "others": "",
        "others_back": "",
        "woken": "",
        "referencing": REFERENCING[axis.encoder.type],
        **numbered_files(definition, axis),
    }


def typed_backlash(definition: Definition, axis: Axis, values: Mapping[str, str]) -> str:
    """Return the card's text on the backlash value that the user types in; empty if the control has
    no such value. ``values``: texts for the fields of this text, by field name.
    """
    rule = definition.bindings.get("backlash")
    if not isinstance(rule, Measure) or not rule.typed:
        return ""
    return ControlText(rule.typed, _used(rule.typed, {**axis_values(definition, axis), **values}))


def gantry_words(axis: Axis) -> str:
    """Return the card's text about the slave axis of a gantry."""
    if axis.gantry is None:
        return control_text(
            "The job says that {name} is not a gantry master axis. If it is one, stop: a"
            " table on the master axis alone racks the bridge. Name its synchronised axis in the"
            " job (gantry), so that it gets the same table.",
            name=axis.name,
        )
    own = axis.gantry_table == "change"
    return control_text(
        "Axis {name} leads a gantry: do every step for the synchronised axis {gantry}"
        " too, before anything moves.{own} A table on the leading axis alone racks the bridge.",
        name=axis.name,
        gantry=axis.gantry,
        own=control_text(" It has values of its own.") if own else "",
    )


def _used(form: str, values: Mapping[str, str]) -> dict[str, str]:
    """Return those of the ``values`` that the text ``form`` contains as ``{name}`` fields."""
    return {name: values[name] for name in field_names(form)}


def points_needed(control: ResolvedDefinition, table: AxisCompensation) -> int | None:
    """Return how many points the control must reserve for a table; None if it has nothing to
    reserve.

    It has nothing to reserve if this control never reserves points. The same applies to a table
    with one curve if the control's files show that enough points are reserved.
    """
    reserves = any(
        control.definition.limit(limit) is not None for limit in ("points_reserved", "max_points")
    )
    needed = int(table.positions.size)
    room = control.state.facts_of(table.address).stated.get("max_points", 0)
    one_curve = np.array_equal(table.positive, table.negative)
    there = one_curve and isinstance(room, int) and room >= needed
    return needed if reserves and not there else None


def look_at(
    control: Family, axis: Axis, compensation: AxisCompensation
) -> Mapping[LoadingName, tuple[str, ...]]:
    """Return the sentences on what the user has to check at the control, by the verdict on how the
    table was loaded (such as inverted or not active).

    ``compensation``: the table that was to be loaded. It decides between texts for one and for two
    curves. A sentence that no manual confirms is marked as unconfirmed. The verdict ``loaded`` has
    sentences too, because a test may show the same with another table. These sentences state how to
    check that the planned table is active.
    """
    values = axis_values(control.definition, axis)
    pair = not np.array_equal(compensation.positive, compensation.negative)
    return {
        verdict: tuple(_sentences(rules, values, pair=pair))
        for verdict, rules in control.definition.look_at.items()
    }


def _sentences(
    rules: tuple[LookRule, ...], values: Mapping[str, str], *, pair: bool
) -> Iterator[str]:
    for rule in rules:
        form = rule.two_curves if pair else rule.text
        text = ControlText(form, _used(form, values))
        state = rule.evidence.state
        doubtful = SentenceText(say("card.look_at", text=text, state=state))
        yield text if state == "confirmed" else doubtful
