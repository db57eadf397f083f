"""Data of the commissioning card that depend on the control: its tables, loading steps, changed
values, and how to restore them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from compwright.controls.control import Control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.judged_corrections import applied_correction
from compwright.formats.card import (
    CardStep,
    card_steps_of_all,
    gantry_words,
    points_needed,
    typed_backlash,
)
from compwright.formats.families.card_texts import AxisCard, CardRequest, loading_order
from compwright.formats.text.container import is_container
from compwright.formats.text.diff import EntryChange, compare_files
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.file_values import changes
from compwright.formats.text.texts import text_reader
from compwright.foundations.units import outside_factor, outside_unit, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.quick_check import check_positions, moved_by, quick_check
from compwright.records.axis import Axis, partner_of
from compwright.records.correction import AxisCompensation, ControlFile, no_compensation
from compwright.records.job import Job
from compwright.records.numbering import NumberedSections
from compwright.words.sentences import ControlText, SentenceText, control_text, say


def axis_documents(
    job: Job, control: Control, work: AxisWork, loaded: DecodedState, old: DecodedState
) -> Iterator[dict[str, Any]]:
    """Yield the card's data of the axis of ``work``, and of its gantry slave if that gets a table
    of its own. ``loaded``: the written files, decoded; ``old``: the control's files before.
    """
    own = _axis(job, control, work, loaded, old)
    yield own
    axis = work.planned.axis
    if axis.gantry is None or axis.gantry_table is None:
        return
    partner = partner_of(axis, axis.gantry)
    card = _card(control, partner, work, loaded)
    before = old.state.axes.get(partner.address)
    table = loaded.state.axes.get(partner.address)
    yield {
        **own,
        "name": partner.name,
        "address": partner.address,
        "rows": _rows(
            partner,
            (before, _backlash(before, old, partner)),
            (table, _backlash(table, loaded, partner)),
            (_typed_before(control, partner, old, table), _typed(control, partner, card)),
        ),
        "quick_check": [],
        "numbering": _numbering(card.numbered),
        "points_needed": None if table is None else points_needed(control.format, table),
        "fixed_positions": [],
    }


def _axis(
    job: Job, control: Control, work: AxisWork, loaded: DecodedState, old: DecodedState
) -> dict[str, Any]:
    axis, active = work.planned.axis, work.planned.active
    card = _card(control, axis, work, loaded)
    factor = outside_factor(axis.kind.unit)
    table = loaded.state.axes[axis.address]
    new = applied_correction(loaded, axis)
    return {
        "name": axis.name,
        "address": axis.address,
        "unit": outside_unit(axis.kind.unit),
        "position_unit": axis.kind.unit,
        "rows": _rows(
            axis,
            (active, _backlash(active, old, axis)),
            (table, _backlash(table, loaded, axis)),
            (_typed_before(control, axis, old, table), _typed(control, axis, card)),
        ),
        "quick_check": [
            {
                "position": entry.position,
                "direction": entry.direction.value,
                "adds": entry.adds * factor,
                "expected": entry.expected * factor,
                "stop": entry.stop * factor,
            }
            for entry in quick_check(work, new)
        ],
        "numbering": _numbering(card.numbered),
        "rapid": axis.motion == "rapid",
        "points_needed": points_needed(control.format, table),
        "fixed_positions": [
            {
                "name": name,
                "position": places[axis.name],
                "moves": moved_by(work, new, places[axis.name]) * factor,
            }
            for name, places in job.fixed_positions.items()
            if axis.name in places
        ],
    }


def _numbering(numbered: NumberedSections | None) -> dict[str, Any] | None:
    """Return the numbers of a table's sections (with their positions) as plain data for the card;
    None if the control does not number sections.
    """
    if numbered is None:
        return None
    return {
        "unit": numbered.unit,
        "reference": numbered.reference,
        "sections": [
            {"number": one.number, "from": one.low, "to": one.high} for one in numbered.sections
        ],
        "marks": [{"number": number, "name": name} for number, name in numbered.marks],
        "second": numbered.second,
        "words": list(numbered.words),
    }


def _backlash(table: AxisCompensation | None, held: DecodedState, axis: Axis) -> float:
    """Return an axis' backlash in mm or deg, including backlash that its table values contain.
    ``held``: the control's files, decoded, in which the ``table`` is.

    The table values contain backlash if the control includes its backlash parameter in the curve of
    one direction.
    """
    in_curves = held.state.facts_of(axis.address).stated.get("backlash_in_curves")
    own = 0.0 if table is None else table.backlash
    return own + (in_curves if isinstance(in_curves, float) else 0.0)


def _typed(control: Control, axis: Axis, card: AxisCard) -> str:
    """Return the new backlash as the text to type into the control's parameter."""
    return typed_backlash(control.definition, axis, card.values)


def _typed_before(
    control: Control, axis: Axis, old: DecodedState, new: AxisCompensation | None
) -> str:
    """Return the old backlash as the text to type into the parameter; 0 if none was active.

    ``old``: the control's old files, decoded. ``new``: the new table; None if there is none. The
    text is made from a table with the old backlash. If the old table has fewer than two points,
    this is a table of zeros at the points of ``new``.
    """
    table = old.state.axes.get(axis.address, no_compensation(axis.address, axis.kind))
    if new is not None and table.positions.size < 2:
        zero = np.zeros_like(new.positions)
        table = replace(new, positive=zero, negative=zero, backlash=table.backlash, slope=0.0)
    request = CardRequest(
        axis=axis, table=table, facts=old.state.facts_of(axis.address), check_at=np.zeros(1)
    )
    return _typed(control, axis, control.format.card(request))


def _rows(
    axis: Axis,
    old: tuple[AxisCompensation | None, float],
    new: tuple[AxisCompensation | None, float],
    typed: tuple[str, str],
) -> list[dict[str, str]]:
    """Return the card's rows on an axis' table (points, range, corrections, backlash) with old
    value, new value and unit. ``old``, ``new``: table and backlash; ``typed``: the old and the new
    backlash as texts to type into the control.
    """
    unit = axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)

    def describe(table: AxisCompensation | None, lost: float) -> dict[str, str]:
        amount = say(
            "label.with_unit", value=_minus(f"{round(lost * factor, 2) + 0.0:.2f}"), unit=small
        )
        backlash = SentenceText(amount)
        constant = table is not None and table.positions.size == 1 and lost != table.backlash
        if table is None or table.positions.size == 0 or constant:  # backlash alone
            none = control_text("none")
            return {"points": none, "range": "—", "largest": "—", "backlash": backlash}
        curves = np.concatenate([table.positive, table.negative]) * factor
        curves = np.round(curves, 2) + 0.0
        return {
            "points": str(table.positions.size),
            "range": _range(f"{table.positions[0]:g}", f"{table.positions[-1]:g}", unit),
            "largest": _range(f"{curves.min():.2f}", f"{curves.max():.2f}", small),
            "backlash": backlash,
        }

    before, after = describe(*old), describe(*new)
    titles = {
        "points": control_text("points of the table"),
        "range": control_text("range of the table"),
        "largest": control_text("corrections from, to"),
        "backlash": control_text("backlash in addition to the table"),
    }
    rows = [
        {"quantity": title, "old": before[key], "new": after[key], "typed_old": "", "typed": ""}
        for key, title in titles.items()
    ]
    rows[-1]["typed_old"], rows[-1]["typed"] = typed
    return rows


def _range(low: str, high: str, unit: str) -> str:
    return control_text("{low} to {high} {unit}", low=_minus(low), high=_minus(high), unit=unit)


def _minus(number: str) -> str:
    """Return a number with a minus sign instead of a hyphen, for display (not for typing in)."""
    return number.replace("-", "−")


def changes_document(
    control: Control, old: Sequence[ControlFile], entered: Sequence[ControlFile]
) -> dict[str, Any] | None:
    """Return as plain data the values that the new files ``entered`` change in the ``old`` files.

    Returns None if there are no old or no new files.
    """
    if not old or not entered:
        return None
    diff = compare_files(control.definition, old, entered)
    entries = [
        {"entry": change.entry, "old": change.old, "new": change.new}
        for change in (*diff.changes, *_in_other_lines(control, old, entered))
    ]
    return {"entries": entries, "untouched": diff.untouched}


def _in_other_lines(
    control: Control, old: Sequence[ControlFile], new: Sequence[ControlFile]
) -> Iterator[EntryChange]:
    """Yield the changed values in lines of the new files that are no statements of the definition,
    such as the cells of a table with columns.
    """
    reader, listing = text_reader(control.definition), control.format.listing
    own = (file for file in new if not is_container(file) and not is_entry_sheet(file))
    texts = ((file.name.rpartition(": ")[2], reader.read(file, [])) for file in own)
    read = {
        (name, place.line) for name, text in texts for place in (text.occurrences if text else ())
    }
    before, after = (listing.file_values(control.definition, files, old) for files in (old, new))
    for change in changes(before, after):
        entry = change.entry
        if change.new is None or not entry.line or (entry.file, entry.line) in read:
            continue
        was = None if change.old is None else change.old.text
        yield EntryChange(entry.name, entry.axis or None, was, change.new.text)


def unconfirmed_diameters(control: Control, axes: Sequence[Axis]) -> list[str]:
    """Return, for each axis programmed in diameter, the definition's text on what is unconfirmed
    about tables of such axes.
    """
    return [
        ControlText(control.definition.diameter.card, {"name": axis.name})
        for axis in axes
        if axis.programmed == "diameter"
    ]


def step_documents(
    control: Control,
    written: Mapping[str, AxisWork],
    loaded: DecodedState,
    between: Sequence[Mapping[str, Any]],
) -> list[Mapping[str, Any]]:
    """Return the card's steps for loading the new tables: those of the control's definition, then
    ``between``, those for cross-axis tables. ``written``: the axes that get tables, by name;
    ``loaded``: the written files, decoded.
    """
    tells = any("{gantry}" in rule.text for rule in control.definition.card)
    steps = [
        {
            "title": control_text(
                "{name} and {gantry} together", name=axis.name, gantry=axis.gantry
            ),
            "text": gantry_words(axis),
            "evidence": "inferred",
            "heads": (),
            "rows": (),
        }
        for axis in (work.planned.axis for work in written.values())
        if axis.gantry is not None and not tells
    ]
    steps += _plain(card_steps_of_all(control.definition, _with_values(control, written, loaded)))
    return [*_with_all_files(steps, between, loaded.files), *between]


def restore_steps(
    control: Control, written: Mapping[str, AxisWork], loaded: DecodedState
) -> list[dict[str, Any]]:
    """Return the card's steps for restoring the old values, made from the control's definition.
    ``written``: the axes that get tables, by name; ``loaded``: the written files, decoded.
    """
    axes = _with_values(control, written, loaded)
    return _plain(card_steps_of_all(control.definition, axes, control.definition.restore))


def _with_values(
    control: Control, written: Mapping[str, AxisWork], loaded: DecodedState
) -> list[tuple[Axis, Mapping[str, str]]]:
    """Return each axis and each gantry slave with the values that its texts on the card contain,
    such as file names. ``written``: the axes that get tables, by name; ``loaded``: the written
    files, decoded.

    A gantry slave has an axis number and files of its own. It gets the same table as its master, or
    the same change.
    """
    axes: list[tuple[Axis, Mapping[str, str]]] = []
    for work in written.values():
        axis = work.planned.axis
        axes.append((axis, _card(control, axis, work, loaded).values))
        if axis.gantry is not None:
            partner = partner_of(axis, axis.gantry)
            own = {"sheet": f"{axis.name}_{axis.gantry}", "gantry": gantry_words(axis)}
            axes.append((partner, {**_card(control, partner, work, loaded).values, **own}))
    return axes


def _plain(steps: Sequence[CardStep]) -> list[dict[str, Any]]:
    return [
        {
            "title": step.title,
            "text": step.text,
            "evidence": step.evidence,
            "heads": step.heads,
            "rows": step.rows,
        }
        for step in steps
    ]


def _with_all_files(
    steps: list[dict[str, Any]],
    between: Sequence[Mapping[str, Any]],
    files: Sequence[ControlFile],
) -> list[dict[str, Any]]:
    """Return the card's steps; the first step that loads or enters tables also names each file that
    no step names yet.
    """
    named = " ".join(f"{step['text']} {step.get('rows')}" for step in (*steps, *between))
    left = [file.name for file in files if file.name not in named]
    loading = next((step for step in steps if step["title"].startswith(("Load", "Enter"))), None)
    if left and loading is not None:
        files_too = control_text("The files in tables/: {files}.", files=tuple(left))
        loading["text"] = SentenceText(say("paragraph", sentences=(loading["text"], files_too)))
    return steps


def _card(control: Control, axis: Axis, work: AxisWork, loaded: DecodedState) -> AxisCard:
    """Return what the card shows about an axis or its gantry slave, made from the written files,
    which are decoded again.
    """
    leading, tables = work.planned.axis, loaded.state.axes
    return control.format.card(
        CardRequest(
            axis=axis,
            table=tables.get(axis.address, tables[leading.address]),
            facts=loaded.state.facts_of(axis.address),
            check_at=check_positions(work, applied_correction(loaded, leading)),
            files=loaded.files,
        )
    )


def restore_texts(
    control: Control,
    files: Sequence[ControlFile],
    back: Sequence[ControlFile],
    *,
    steps: bool,
    between: bool,
) -> list[str]:
    """Return the card's texts on how to restore the old state by loading files: ``back``, small
    files with the old values, if there are any; else ``files``, the control's old files.
    ``between``: there are new cross-axis tables.

    ``steps``: the card also contains the steps of `restore_steps`.
    """
    if not files:
        nothing = control_text("The job says that nothing was active.")
        off = control_text(
            "To go back: switch the compensation of these axes off as in the steps above (an empty"
            " table), set the backlash by the parameter in column Old of each axis, restart and"
            " reference."
        )
        cross = control_text(
            "Cross-axis tables: switch off what the steps above switch on, or set each of their"
            " values to 0."
        )
        own = nothing if steps else SentenceText(say("paragraph", sentences=(nothing, off)))
        return [own, cross] if between else [own]
    names = ", ".join(loading_order(control.definition, files))
    folder = f"rollback/{control.id}/"
    copies = {"folder": folder, "names": names}
    if not back:
        kept = control_text(
            "The untouched copies of the old files are in {folder} ({names}).", **copies
        )
        load = control_text(
            "Load the untouched copies in {folder} ({names}) the same way, restart and reference.",
            **copies,
        )
        return [kept if steps else load]
    small = say("card.then", names=loading_order(control.definition, back))
    return [
        control_text(
            "To undo: switch off as in the steps above, load {files} from {folder} (the old values"
            " of these axes and their switches; what was set by hand goes back by hand), activate,"
            " restart and reference.",
            files=small,
            folder=folder,
        ),
        control_text(
            "If more than these axes has to go back: switch off the compensation of every axis in"
            " them (what is on is protected), load the untouched copies in {folder} ({names}) the"
            " same way, restart and reference.",
            **copies,
        ),
    ]
