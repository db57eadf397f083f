"""Corrections between axes by FANUC straightness compensation, as files or as an entry sheet.

The correction is written into the control's own files if they contain the parameters of an unused
axis pair. Otherwise it becomes an entry sheet. Parameter numbers and signs are from memory; no page
confirms them.

The correction is a straight line between two points of the moving axis' table. Each amount is the
whole correction at a point, in detection units of the compensated axis. A curve, a moving axis
without a table, and a second axis pair are not written; a remark says so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.formats.families.axis_pairs import (
    Between,
    BetweenRequest,
    alternative_answer,
    cannot_hold,
    entry_sheet_answer,
    error_label,
)
from compwright.formats.families.family import Family
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.parameters import Parameters, ParameterValue
from compwright.formats.families.increments.straightness import free_pair, unused_pairs
from compwright.formats.text.patching import BytesChange, apply_changes
from compwright.records.axis import FloatArray
from compwright.records.correction import ControlFile, ControlState
from compwright.records.plan import PlannedCross
from compwright.words.sentences import control_text, say


def straightness_between(family: Family, request: BetweenRequest) -> Between:
    """Return the answer to a request for corrections between axes: a straight line in straightness
    compensation, if the options allow it.
    """
    if family.options.get("straightness") != "available":
        return alternative_answer(family.definition, request.planned)
    (entry, *others) = request.planned
    filled = None if others else _filled(family, request, entry)
    if filled is not None:
        return filled
    state = request.read(request.base) if request.base else None
    read = Parameters(request.base, family.definition.parameters)
    numbers, _ = next(unused_pairs(read, entry.added.input), ((), {}))
    found = None if others else _rows(family, request, entry, state, numbers)
    if found is None:
        why = control_text("every pair of straightness compensation (5711 to 5713) is in use")
        table = None if state is None else state.axes.get(entry.added.input)
        if numbers and (table is None or table.positions.size < 2):
            why = control_text(
                "straightness compensation counts the points of the pitch table of the moving axis"
                " {input}, which has none. Next: give {input} a positioning test (`before`), or the"
                " control's files with its pitch data (`states`)",
                input=entry.input,
            )
        elif numbers:
            why = control_text(
                "straightness compensation is known for one straight line over a table only"
            )
        return cannot_hold(request.planned, why)
    rows, values = found
    sheet = _sheet(entry, rows)
    sentence = say("CW-P113.sheet", what=error_label(entry), sheet=sheet.name)
    text = control_text(
        "{sentence} Prove the sign with a square or a dial gauge, on and off, before production.",
        sentence=say("card.capital", text=sentence),
    )
    return entry_sheet_answer(entry, values, sheet, sentence, text)


def _filled(family: Family, request: BetweenRequest, entry: PlannedCross) -> Between | None:
    """Return an answer with files in which unused parameters of straightness compensation contain
    the straight line; None if impossible.

    It is impossible if no axis pair is unused. It is also impossible if the line cannot be written
    exactly. Its ends must be points of the moving axis' table, and both directions must have the
    same correction.
    """
    added, bent = entry.added, request.axes.get(entry.output)
    places = free_pair(Parameters(request.base, family.definition.parameters), added.input)
    unit = None if bent is None else family.options_of(bent).get("detection_unit")
    if places is None or not isinstance(unit, float) or added.positions.size != 2:
        return None
    state = request.read(request.base)
    table, facts = state.axes.get(added.input), increments_of(state.facts_of(added.input))
    if table is None or table.positions.size < 2 or table.period is not None:
        return None
    steps = [int(np.argmin(np.abs(table.positions - place))) for place in added.positions]
    on_points = np.abs(table.positions[steps] - added.positions) <= 1e-6
    alike = np.array_equal(added.positive, added.negative)
    if not (np.all(on_points) and alike and steps[0] >= 1 and facts.first_number is not None):
        return None
    # The first point is the lower end of the first section, whose number stands for its upper end.
    points = [str(facts.first_number - 1 + step) for step in steps for _ in range(2)]
    amounts = [str(round(float(value / unit))) for value in added.positive for _ in range(2)]
    texts = [added.input, added.output, *points, *amounts]
    named = {places[place].number: text for place, text in enumerate(texts)}
    values = [f"{number} = {text}" for number, text in named.items()]
    sentence = say("CW-P113.straightness", what=error_label(entry), values=values)
    text = control_text(
        "{sentence} Its numbers and its sign are unconfirmed: prove them with a square or a dial"
        " gauge, on and off, before production.",
        sentence=say("card.capital", text=sentence),
    )
    title = control_text(
        "{output} over {input}: straightness compensation", output=entry.output, input=entry.input
    )
    return Between(
        files=_patched(request.base, places, texts),
        remarks=(("warning", sentence),),
        steps=({"title": title, "text": text, "evidence": "unconfirmed"},),
        quantum=2 * unit,  # either amount is rounded, and the value at the reference between them
    )


def _patched(
    files: Sequence[ControlFile], places: Mapping[int, ParameterValue], texts: Sequence[str]
) -> tuple[ControlFile, ...]:
    changes: dict[str, list[BytesChange]] = {}
    for place, text in enumerate(texts):
        value = places[place]
        change = BytesChange(value.start, value.start + len(value.text), text.encode("ascii"))
        changes.setdefault(value.file, []).append(change)
    return tuple(  # all: parameters are read only together with their pitch data
        ControlFile(file.name, apply_changes(file.content, changes.get(file.name, [])))
        for file in files
    )


def _rows(
    family: Family,
    request: BetweenRequest,
    entry: PlannedCross,
    state: ControlState | None,
    numbers: Sequence[int],
) -> tuple[list[tuple[str, str, str]], FloatArray] | None:
    """Return the entry sheet's rows (parameter, value, meaning) for a straight line, and what they
    correct at the positions of ``entry``, mm or deg; None if no line fits. ``state``: the control
    after this run's tables; ``numbers``: the parameters of an unused axis pair.
    """
    added, bent = entry.added, request.axes.get(entry.output)
    table = None if state is None else state.axes.get(added.input)
    unit = None if bent is None else family.options_of(bent).get("detection_unit")
    if (
        state is None
        or not numbers
        or table is None
        or table.positions.size < 2
        or added.positions.size != 2
        or not isinstance(unit, float)
    ):
        return None
    facts = increments_of(state.facts_of(added.input))
    first, last = facts.first_number, facts.last_number
    # The table may reach beyond the line's positions: the line goes on to the points at its ends.
    line = np.polynomial.Polynomial.fit(added.positions, added.positive, 1)
    where = table.positions[[1, -1]]
    amounts = np.round(line(where) / unit)
    ends = [str(int(amount)) for amount in amounts]
    held = np.polynomial.Polynomial.fit(where, amounts * unit, 1)
    values = (added.input, added.output, *(str(first),) * 2, *(str(last),) * 2)
    texts = (*values, *(ends[0],) * 2, *(ends[1],) * 2)
    points = ("point number at the - end",) * 2 + ("point number at the + end",) * 2
    means = ("moving axis", "compensated axis", *points, *("amount, detection units",) * 4)
    return list(zip(map(str, numbers), texts, means, strict=True)), held(added.positions)


def _sheet(entry: PlannedCross, rows: list[tuple[str, str, str]]) -> ControlFile:
    head = (
        "# straightness compensation: numbers and signs UNCONFIRMED, from general knowledge; check"
        " each in the manual of the control\nparameter,value,meaning\n"
    )
    body = "".join(f"{number},{value},{what}\n" for number, value, what in rows)
    return ControlFile(f"straightness_{entry.input}_{entry.output}.csv", f"{head}{body}".encode())
