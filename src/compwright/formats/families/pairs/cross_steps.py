"""The steps of the commissioning card for CEC tables between two axes."""

from __future__ import annotations

from compwright.formats.families.axis_pairs import error_label
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.options import reserving, tables_in_words
from compwright.formats.families.pairs.updated_tables import largest_sum
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedCross
from compwright.words.sentences import control_text, say

#: The least movement that a dial gauge shows beyond doubt, mm or deg.
_VISIBLE = 0.005


def cross_steps(
    family: Family,
    entry: PlannedCross,
    named: str,
    before: ControlState,
    after: ControlState,
) -> list[dict[str, str]]:
    """Return the card's steps for new tables: reserve memory, check the sign, load, activate.
    ``named``: the files to load; ``before`` and ``after``: the state of the control's files without
    and with the new tables.

    Other tables of the same axes are not in these steps, because they stay unchanged.
    """
    added = entry.added
    pair, others = (added.input, added.output), before.tables
    updated = {
        one: len(curve[0])
        for one, curve in after.tables.curves.items()
        if others.curves.get(one) not in (None, curve)
    }
    mine = [
        index
        for index, axes in sorted(after.tables.used.items())
        if axes == pair and (index not in others.used or index in updated)
    ]
    if not mine:  # nothing changes
        return []
    which = tables_in_words([str(index) for index in mine])
    points = max(updated.get(index, added.positions.size) for index in mine)
    room = reserving(family.definition, points, which)
    each = control_text("it") if len(mine) == 1 else control_text("each of them")
    axes = {"output": entry.output, "input": entry.input}
    value = _check_value(before, added.output)
    check = _checking(entry, named, which, each, value)
    steps = {
        control_text("{output} over {input}: reserve and switch off", **axes): _reserving(
            added.output, room, which
        ),
        control_text("{output} over {input}: check the sign", **axes): (
            _in_use(check, which, value) if updated.keys() & set(mine) else check
        ),
        control_text("{output} over {input}: load", **axes): _loading(entry, named),
        control_text("{output} over {input}: switch on", **axes): _switching(entry, which),
    }
    return [{"title": title, "text": text, "evidence": "inferred"} for title, text in steps.items()]


def _switches(address: str) -> tuple[str, str]:
    return f"MD32710 $MA_CEC_ENABLE[{address}]", "SD41300 $SN_CEC_TABLE_ENABLE"


def _reserving(address: str, room: str, which: str) -> str:
    enable, switch = _switches(address)
    return control_text(
        "{room} Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
        " before: if it was 0, find out what else is inactive on axis {address} (every other table"
        " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
        " before anything else. MD32710 would activate it.",
        room=room,
        enable=enable,
        switch=switch,
        which=which,
        address=address,
    )


def _check_value(before: ControlState, output: str) -> str:
    """Return as text the correction, mm or deg, of a table with which its sign is checked: 0.1, or
    what CEC_MAX_SUM leaves for it next to the tables that are active. If this is too little to be
    seen, the table itself has most of the sum, and gets all of it.
    """
    limit = before.facts_of(output).pairs.max_sum
    if limit is None:
        return "0.1"
    room = limit - largest_sum(before, output)
    return f"{min(0.1, room if room >= _VISIBLE else limit):.3g}"


def _checking(entry: PlannedCross, named: str, which: str, each: str, value: str) -> str:
    unit = entry.added.output_kind.unit
    return control_text(
        "Before {files} is loaded: write {value} {unit} into every point of {which} and switch"
        " {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
        " gauge on {address} must show +{value} {unit} for cec_sign: correction, -{value}"
        " {unit} for cec_sign: error. If it does not: load nothing, and run again with the"
        " other one. Write 0 again and switch off as in the step before.",
        files=named,
        value=value,
        unit=unit,
        which=which,
        each=each,
        address=entry.added.output,
    )


def _in_use(check: str, which: str, value: str) -> str:
    return control_text(
        "{check} In use: {which}. The file holds its old values plus this correction. After"
        " the check its values are {value} or 0: if you load nothing, load its old values of the"
        " folder rollback again, and set MD32710 and SD41300 as they were.",
        check=check,
        which=which,
        value=value,
    )


def _loading(entry: PlannedCross, named: str) -> str:
    added, own = entry.added, entry.added.output_kind.unit
    factor, unit = outside_factor(own), shown_unit(own)
    ends = tuple(
        control_text(
            "{value} {unit} at {input} {position}",
            value=f"{round(value * factor, 2) + 0.0:+.2f}",
            unit=unit,
            input=entry.input,
            position=f"{position:g}",
        )
        for position, value in zip(added.positions[[0, -1]], added.positive[[0, -1]], strict=True)
    )
    return control_text(
        "Load {files}. {error}: {output} is moved by {ends}, 0 at the reference of {input}.",
        files=named,
        error=say("card.capital", text=error_label(entry)),
        output=entry.output,
        ends=ends,
        input=entry.input,
    )


def _switching(entry: PlannedCross, which: str) -> str:
    address = entry.added.output
    enable, switch = _switches(address)
    return control_text(
        "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first."
        " Set {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
        " offsets of {output} shift with {input}: probe them again. Compare the result"
        " with a square or a dial gauge before production.",
        address=address,
        enable=enable,
        switch=switch,
        which=which,
        output=entry.output,
        input=entry.input,
    )
