"""Corrections between axes by straightness compensation: parameters as a sheet to type in, numbers
and signs from memory, none confirmed by a page.

Two points of the moving axis' numbers, the amounts absolute in detection units of the compensated
axis: a straight line. A curve, an axis without a table and a second pair are said instead.
"""

from __future__ import annotations

from compwright.formats.families.between import (
    Asked,
    Between,
    in_turn,
    instead,
    label,
    not_held,
    typed_in,
)
from compwright.formats.families.family import Family
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile, ControlState
from compwright.records.plan import PlannedCross


def straightness_between(family: Family, asked: Asked) -> Between:
    """Return the parameters of one straight line, where the job says that the control has them."""
    if family.options.get("straightness") != "available":
        return instead(family.definition, asked.planned)
    state = asked.read(asked.tables) if asked.tables else None
    (entry, *others) = asked.planned
    rows = None if others else _rows(family, asked, entry, state)
    if rows is None:
        why = "straightness compensation is known for one straight line over a table only"
        return in_turn(not_held(each, why) for each in asked.planned)
    sheet = _sheet(entry, rows)
    message = (
        f"{label(entry)} is in no file: its parameters stand in {sheet.name} beside the card, all"
        " unconfirmed."
    )
    text = f"{message} Prove the sign with a square or a dial gauge, on and off, before production."
    return typed_in(entry, sheet, message, text)


def _rows(
    family: Family, asked: Asked, entry: PlannedCross, state: ControlState | None
) -> list[tuple[str, str, str]] | None:
    """Return parameter, value and meaning; None where one straight line over a table does not say
    it. ``state``: what the tables of this run say.
    """
    added, bent = entry.added, asked.axes.get(entry.output)
    table = None if state is None else state.axes.get(added.input)
    unit = None if bent is None else family.options_of(bent).get("detection_unit")
    if (
        state is None
        or table is None
        or table.positions.size < 2
        or added.positions.size > 2
        or not isinstance(unit, float)
    ):
        return None
    facts = state.facts_of(added.input).increments
    first, last = facts.first_number, facts.last_number
    low, high = added.at(table.positions[[1, -1]], Direction.POSITIVE) / unit
    return [
        ("5711", added.input, "moving axis"),
        ("5721", added.output, "compensated axis"),
        *((number, str(first), "point number at the - end") for number in ("5731", "5732")),
        *((number, str(last), "point number at the + end") for number in ("5733", "5734")),
        *((number, f"{low:.0f}", "amount, detection units") for number in ("5761", "5762")),
        *((number, f"{high:.0f}", "amount, detection units") for number in ("5763", "5764")),
    ]


def _sheet(entry: PlannedCross, rows: list[tuple[str, str, str]]) -> ControlFile:
    head = (
        "# straightness compensation: numbers and signs UNCONFIRMED, from memory; check each in"
        " the manual of the control\nparameter,value,meaning\n"
    )
    body = "".join(f"{number},{value},{what}\n" for number, value, what in rows)
    return ControlFile(f"straightness_{entry.input}_{entry.output}.csv", f"{head}{body}".encode())
