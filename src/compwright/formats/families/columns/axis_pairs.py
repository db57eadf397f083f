"""Corrections between axes, written as columns of the table that follows the moving axis.

The correction is written if the user's own table has the column and its rows can hold it. Otherwise
the engineer types it in. The sign of such a table is unconfirmed in both cases.

A column corrects an axis only while tables are selected for that axis. The linear error parameter
of the axis is not active then. An axis that is corrected by its linear error parameter therefore
gets no column, and a remark reports this.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

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
from compwright.formats.families.columns.typed_columns import TypedColumn, typed_column
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
            filler.refuse_waking(entry.added.output, tabled=entry.output in request.tabled)
        except NotHeld as error:
            answers.append(cannot_hold([entry], error.args[0]))
            continue
        try:
            filled = filler.fill(entry)
        except NotHeld as error:
            try:
                column = typed_column(filler, entry)
            except NotHeld as refusal:
                answers.append(cannot_hold([entry], refusal.args[0]))
            else:
                answers.append(_typed(filler, request, entry, column, error.args[0]))
        else:
            files = filler.patched(range(len(files)))
            held.append(filled.entry)
            answers.append(_in_the_table(filler, request, filled))
    if not held:
        return combined_answer(answers)
    changed = tuple(after for before, after in zip(own, files, strict=True) if after != before)
    if not request.tables:  # the set that the control loads is complete, whoever changes it
        changed = merged_files(request.base, changed)
    return replace(
        combined_answer(answers), files=changed, held=tuple(held), quantum=values_quantum(family)
    )


def _in_the_table(filler: CrossFiller, request: BetweenRequest, filled: Filled) -> Between:
    """Return the answer for a correction that was written into the user's own table."""
    entry, form = filled.entry, _form(filler.family, request, filled.entry)
    rows = _rows(entry, form)
    where = control_text("{file}, column {column}", file=filled.file, column=str(filled.column))
    text = control_text(
        "{error} is in {where}, added to what was there: {values}"
        " (values are {form}s). Load that file; no other column of it changes."
        " {selected}{check}",
        error=error_label(entry),
        where=where,
        values=_shown(rows, entry.added.output_kind.unit),
        form=form,
        selected=_selected(filler, entry),
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


def _typed(
    filler: CrossFiller, request: BetweenRequest, entry: PlannedCross, column: TypedColumn, why: str
) -> Between:
    """Return the answer that a table ``column`` has to be typed in, for the reason ``why``."""
    form = _form(filler.family, request, entry)
    sheet = _sheet(entry, form, column)
    position_unit = "" if column.position_unit == entry.added.input_kind.unit else "inch"
    what = error_label(entry)
    rows = _shown(list(column.rows), column.unit, position_unit, column.decimals)
    sentence = say(
        "CW-P113.typed",
        what=what,
        why=why,
        total=column.total,
        where=column.where,
        rows=rows,
        values=form,
    )
    text = say(
        "card.typed_column",
        what=what,
        total=column.total,
        where=column.where,
        rows=rows,
        values=form,
        sheet=sheet.name,
        more=column.more_rows,
        selected=_selected(filler, entry),
        check=_CHECK,
    )
    changed = replace(entry, added=column.added)
    return entry_sheet_answer(changed, column.added.positive, sheet, sentence, SentenceText(text))


def _form(family: Family, request: BetweenRequest, entry: PlannedCross) -> str:
    """Return what the numbers in the moving axis' table are: "error" or "correction"."""
    return str(family.options_of(request.axes.get(entry.input))["table_values"])


def _selected(filler: CrossFiller, entry: PlannedCross) -> str:
    """Return the card's sentence on the bit of the corrected axis that selects the table column."""
    select, output = _parameter(filler.family, "enabled"), entry.added.output
    if not select:
        return ""
    names = {"output": entry.output, "parameter": select}
    if filler.is_off(output):
        return control_text("Set the bit of {output} in {parameter} to 1. ", **names)
    active = control_text(
        "The column is active only while the bit of {output} in {parameter} is 1. ", **names
    )
    if (output, "enabled") in filler.sources.given:
        return active
    return control_text(
        "{active}If it is 0, and {linear} of {output} or one of its columns in any table is not 0,"
        " leave out this step: set the bit to 1 first and repeat the test. ",
        active=active,
        linear=_parameter(filler.family, "slope"),
        output=entry.output,
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


def _rows(entry: PlannedCross, form: str) -> list[tuple[float, float]]:
    """Return a table column's positions and values, mm or deg; ``form``: errors or corrections."""
    sign = -1.0 if form == "error" else 1.0
    added = entry.added
    return [
        (float(position), round(sign * float(value), 4) + 0.0)
        for position, value in zip(added.positions, added.positive, strict=True)
    ]


def _shown(
    rows: list[tuple[float, float]], unit: str, position_unit: str = "", decimals: int = 4
) -> tuple[str, ...]:
    """Return rows as texts: all, or the first, the last and that of the largest value.

    ``position_unit``: empty if it is that of the axis in the job.
    """
    texts = [
        control_text(
            "{value} {unit} at {position}",
            value=f"{value:+.{decimals}f}",
            unit=unit,
            position=f"{position:g} {position_unit}".rstrip(),
        )
        for position, value in rows
    ]
    if len(texts) <= _MOST_SHOWN:
        return tuple(texts)
    last = len(rows) - 1
    largest = max(range(len(rows)), key=lambda place: abs(rows[place][1]))
    shown: list[str] = [texts[0]]
    for before, place in pairwise(sorted({0, largest, last})):
        shown += [*(["…"] if place > before + 1 else []), texts[place]]
    return tuple(shown)


def _sheet(entry: PlannedCross, form: str, column: TypedColumn) -> ControlFile:
    head = f"# column of {entry.output} in the table of {entry.input}: "
    head += "totals, in place of the values there" if column.total else "add to the values there"
    if column.position_unit != entry.added.input_kind.unit:
        head += f"; positions in {column.position_unit}"
    head += f"\n# value: {form}\nposition_{entry.input},{entry.output},unit\n"
    body = "".join(
        f"{position:.4f},{value:.{column.decimals}f},{column.unit}\n"
        for position, value in column.rows
    )
    return ControlFile(f"cross_{entry.input}_{entry.output}.csv", (head + body).encode())
