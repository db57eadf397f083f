"""Corrections between axes in free tables of their own, and how to load them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from compwright.formats.definition.statements import print_form
from compwright.formats.families.between import (
    Between,
    BetweenRequest,
    in_turn,
    label,
    not_held,
    together,
)
from compwright.formats.families.card_words import file_stem
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.cross_writing import write_cross
from compwright.formats.families.pairs.options import reserving
from compwright.foundations.errors import CapacityError
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.correction import ControlFile, ControlState
from compwright.records.plan import PlannedCross

#: Stands before the names of the control's own files while tables are written, to tell them from
#: new ones.
_OWN = "own files/"


def pairs_between(family: Family, request: BetweenRequest, *, small: bool) -> Between:
    """Return the tables between axes with the steps that load them, or why the control has no room
    for them. ``small``: the result is delivered in small files.
    """
    before = request.read(request.base)
    try:
        new = _written(family, request, before)
    except CapacityError as error:
        why = "; ".join(str(fault) for fault in error.faults).replace(_OWN, "")
        return in_turn(not_held(entry, why) for entry in request.planned)
    after = request.read(together(request.base, new), written=True)
    steps = (
        step
        for entry in request.planned
        for step in _steps(family, entry, _named(family, entry, new, small=small), before, after)
    )
    return Between(files=new, steps=tuple(steps))


def _written(
    family: Family, request: BetweenRequest, before: ControlState
) -> tuple[ControlFile, ...]:
    """Return the files of the base that change, and new ones under names that no file of it has.

    A new file may have the same name as one that a former round left in the control: it must not
    replace that one.
    """
    marked = [replace(file, name=_OWN + file.name) for file in request.base]
    taken = {file.name for file in request.base}
    files = []
    added = [entry.added for entry in request.planned]
    for file in write_cross(family.in_state(before), added, marked):
        name = file.name.removeprefix(_OWN)
        stem, dot, ending = name.rpartition(".")
        number = 2
        while file.name == name and name in taken:
            name, number = f"{stem}_{number}{dot}{ending}", number + 1
        taken.add(name)
        files.append(replace(file, name=name))
    return tuple(files)


def _named(family: Family, entry: PlannedCross, new: Sequence[ControlFile], *, small: bool) -> str:
    """Return the names of the delivered files that hold a new table."""
    if not small:
        return " and ".join(file.name for file in new)
    form = next(file.name for file in family.definition.writing if file.when == "cross")
    return print_form(form, {"axis": file_stem(family, entry.added.output)})


def _steps(
    family: Family,
    entry: PlannedCross,
    named: str,
    before: ControlState,
    after: ControlState,
) -> list[dict[str, str]]:
    """Return the steps that load the new tables between two axes: sign first, then the data, the
    switches last.

    Existing tables of the same axes belong to others, and stay unchanged.
    """
    added = entry.added
    pair, others = (added.input, added.output), before.tables.used
    mine = [
        str(index)
        for index, axes in sorted(after.tables.used.items())
        if axes == pair and index not in others
    ]
    tables = " and ".join(mine)
    which = f"table {tables}" if len(mine) == 1 else f"tables {tables}"
    texts = {
        "reserve and switch off": _reserving(
            added.output, reserving(family.definition, added.positions.size, which), which
        ),
        "check the sign": _checking(
            entry, named, which, "it" if len(mine) == 1 else "each of them"
        ),
        "load": _loading(entry, named),
        "switch on": _switching(entry, which),
    }
    title = f"{entry.output} over {entry.input}"
    return [
        {"title": f"{title}: {step}", "text": text, "evidence": "inferred"}
        for step, text in texts.items()
    ]


def _switches(address: str) -> tuple[str, str]:
    return f"MD32710 $MA_CEC_ENABLE[{address}]", "SD41300 $SN_CEC_TABLE_ENABLE"


def _reserving(address: str, room: str, which: str) -> str:
    enable, switch = _switches(address)
    return (
        f"{room} Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
        f" before: if it was 0, find out what else sleeps on axis {address} (every other table"
        " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
        " before anything else. MD32710 would wake it."
    )


def _checking(entry: PlannedCross, named: str, which: str, each: str) -> str:
    unit = entry.added.output_kind.unit
    return (
        f"Before {named} is loaded: write 0.1 {unit} into every point of {which} and switch"
        f" {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
        f" gauge on {entry.added.output} must show +0.1 {unit} for cec_sign: correction, -0.1"
        f" {unit} for cec_sign: error. If it does not: load nothing, and run again with the"
        " other one. Write 0 again and switch off as in the step before."
    )


def _loading(entry: PlannedCross, named: str) -> str:
    added, own = entry.added, entry.added.output_kind.unit
    factor, unit = outside_factor(own), shown_unit(own)
    ends = ", ".join(
        f"{value * factor:+.2f} {unit} at {entry.input} {position:g}"
        for position, value in zip(added.positions[[0, -1]], added.positive[[0, -1]], strict=True)
    )
    text = str(label(entry))
    return (
        f"Load {named}. {text[:1].upper()}{text[1:]}: {entry.output} is moved by {ends}, 0 at the"
        f" reference of {entry.input}."
    )


def _switching(entry: PlannedCross, which: str) -> str:
    address = entry.added.output
    enable, switch = _switches(address)
    return (
        f"If MD32710 was 0 before: SD41300 = 0 for what else sleeps on axis {address}, first."
        f" Set {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
        f" offsets of {entry.output} shift with {entry.input}: probe them again. Compare the result"
        " with a square or a dial gauge before production."
    )
