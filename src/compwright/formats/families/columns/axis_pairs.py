"""Corrections between axes, written as columns of the table that follows the moving axis.

The correction is written if the user's own table has the column and its rows can hold it. Otherwise
the engineer types it in. The sign of such a table is unconfirmed in both cases.

A column corrects an axis only while tables are selected for that axis. The linear error parameter
of the axis is not active then. An axis that is corrected by its linear error parameter therefore
gets no column, and a remark reports this.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.formats.families.axis_pairs import (
    Between,
    BetweenRequest,
    cannot_hold,
    combined_answer,
    entry_sheet_answer,
    error_label,
    merged_files,
)
from compwright.formats.families.columns.crossing import CrossFiller, Filled, values_quantum
from compwright.formats.families.family import Family
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.scale import NotHeld
from compwright.formats.text.values import name_of
from compwright.records.correction import ControlFile
from compwright.records.plan import PlannedCross
from compwright.words.sentences import SentenceText, control_text, say

#: More points than these are typed from the sheet.
_MOST_SHOWN = 8
_CHECK = control_text(
    "The sign is unconfirmed: check it with a square or a dial gauge, on and off, before"
    " production."
)


def columns_between(family: Family, request: BetweenRequest) -> Between:
    """Return the answer to a request for corrections between axes: filled table columns, rows to
    type in, or the reason why a correction is impossible.
    """
    files = tuple(file for file in request.base if not is_entry_sheet(file))
    own = files
    held: list[PlannedCross] = []
    answers: list[Between] = []
    for entry in request.planned:
        why = _by_line(family, request, entry)
        if why:
            answers.append(cannot_hold([entry], why))
            continue
        filler = CrossFiller(family, request.axes, files)
        try:
            filled = filler.fill(entry)
        except NotHeld as error:
            answers.append(_typed(family, request, entry, error.args[0]))
        else:
            files = filler.patched(range(len(files)))
            held.append(filled.entry)
            answers.append(_in_the_table(family, request, filled))
    if not held:
        return combined_answer(answers)
    changed = tuple(after for before, after in zip(own, files, strict=True) if after != before)
    if not request.tables:  # the set that the control loads is complete, whoever changes it
        changed = merged_files(request.base, changed)
    return replace(
        combined_answer(answers), files=changed, held=tuple(held), quantum=values_quantum(family)
    )


def _in_the_table(family: Family, request: BetweenRequest, filled: Filled) -> Between:
    """Return the answer for a correction that was written into the user's own table."""
    entry, form = filled.entry, _form(family, request, filled.entry)
    rows = _rows(entry, form)
    where = control_text("{file}, column {column}", file=filled.file, column=str(filled.column))
    text = control_text(
        "{error} is in {where}, added to what was there: {values}"
        " (values are {form}s). Load that file; no other column of it changes."
        " {selected}{check}",
        error=SentenceText(error_label(entry)),
        where=where,
        values=_shown(entry, rows),
        form=form,
        selected=_selected(family, entry),
        check=_CHECK,
    )
    return Between(
        remarks=(
            ("info", say("CW-P113.column", what=error_label(entry), where=where, values=form)),
        ),
        steps=(
            {
                "title": control_text(
                    "{output} over {input}: {where}",
                    output=entry.output,
                    input=entry.input,
                    where=where,
                ),
                "text": text,
                "evidence": "unconfirmed",
            },
        ),
    )


def _typed(family: Family, request: BetweenRequest, entry: PlannedCross, why: str) -> Between:
    """Return the answer that a table column has to be typed in, for the reason ``why``."""
    form = _form(family, request, entry)
    rows = _rows(entry, form)
    where = control_text(
        "the table (.COM) of {input}, column of {output}", input=entry.input, output=entry.output
    )
    sentence = say(
        "CW-P113.typed",
        what=error_label(entry),
        why=why,
        where=where,
        rows=_shown(entry, rows),
        values=form,
    )
    text = control_text(
        "{error}. Add to the values in {where}, on a straight line between:"
        " {values} (values are {form}s). {selected}{check}",
        error=SentenceText(error_label(entry)),
        where=where,
        values=_shown(entry, rows),
        form=form,
        selected=_selected(family, entry),
        check=_CHECK,
    )
    values = _sign(form) * np.array([value for _, value in rows])
    return entry_sheet_answer(entry, values, _sheet(entry, form, rows), sentence, text)


def _form(family: Family, request: BetweenRequest, entry: PlannedCross) -> str:
    """Return what the numbers in the moving axis' table are: "error" or "correction"."""
    return str(family.options_of(request.axes.get(entry.input))["table_values"])


def _selected(family: Family, entry: PlannedCross) -> str:
    """Return the card's sentence that the table column is active only while the corrected axis' bit
    in a parameter is 1.
    """
    select = _parameter(family, "enabled")
    if not select:
        return ""
    return control_text(
        "It is active on {output} only while the bit of {output} in {parameter} is 1. ",
        output=entry.output,
        parameter=select,
    )


def _by_line(family: Family, request: BetweenRequest, entry: PlannedCross) -> str:
    """Return why no table corrects the axis to be corrected (it uses the linear error parameter);
    empty if tables can correct it.

    The axis uses this parameter if the job corrects the axis by it, or if its value is not zero now
    and the axis gets no table.
    """
    axis, linear = request.axes.get(entry.output), _parameter(family, "slope")
    if axis is None:
        return ""
    old = family.state.axes.get(axis.address)
    if family.options_of(axis).get("method") == "line":
        why = control_text(
            "the job corrects {name} by {parameter} (method: line)",
            name=axis.name,
            parameter=linear,
        )
    elif entry.output not in request.tabled and old is not None and old.slope != 0.0:
        why = control_text(
            "{parameter} corrects {name} now ({slope} mm/m)",
            parameter=linear,
            name=axis.name,
            slope=f"{-old.slope * 1e3:+.3f}",
        )
    else:
        return ""
    return control_text(
        "{why}, and a column is active only with tables, never with {parameter}; give {name} a test"
        " and a table of its own",
        why=why,
        parameter=linear,
        name=axis.name,
    )


def _parameter(family: Family, quantity: str) -> str:
    """Return the control's name of a parameter; empty if it has none."""
    return name_of(family.definition, quantity) if quantity in family.definition.bindings else ""


def _sign(form: str) -> float:
    return -1.0 if form == "error" else 1.0


def _rows(entry: PlannedCross, form: str) -> list[tuple[float, float]]:
    """Return a table column's positions and values, mm or deg; ``form``: errors or corrections."""
    added = entry.added
    return [
        (float(position), round(_sign(form) * float(value), 4) + 0.0)
        for position, value in zip(added.positions, added.positive, strict=True)
    ]


def _shown(entry: PlannedCross, rows: list[tuple[float, float]]) -> str:
    unit = entry.added.output_kind.unit
    shown = rows if len(rows) <= _MOST_SHOWN else [rows[0], rows[-1]]
    return SentenceText(
        say(
            "as_written",
            text=[
                control_text(
                    "{value} {unit} at {position}",
                    value=f"{value:+.4f}",
                    unit=unit,
                    position=f"{position:g}",
                )
                for position, value in shown
            ],
        )
    )


def _sheet(entry: PlannedCross, form: str, rows: list[tuple[float, float]]) -> ControlFile:
    unit = entry.added.output_kind.unit
    head = f"# column of {entry.output} in the table of {entry.input}\n# value: {form}\n"
    head += f"position_{entry.input},{entry.output},unit\n"
    body = "".join(f"{position:.4f},{value:.4f},{unit}\n" for position, value in rows)
    return ControlFile(f"cross_{entry.input}_{entry.output}.csv", (head + body).encode())
