"""The commissioning card: what to set, what the control must then show, a quick check, and the way
back.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from compwright.documents.decode import assumed_documents
from compwright.formats.card import (
    card_steps_of_all,
    gantry_words,
)
from compwright.formats.definition.statements import print_form
from compwright.formats.families.gantry import partner_of
from compwright.formats.text.diff import compare_files
from compwright.foundations.units import outside_factor, outside_unit
from compwright.foundations.utf8 import encoded, visible_lines
from compwright.planning.axes import AxisWork
from compwright.planning.quick_check import check_positions, moved_by, quick_check
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, AxisCompensation, ControlFile
from compwright.records.facts import AxisFacts
from compwright.records.job import AS_FOUND, Job
from compwright.workflow.stages.acting import correction_of
from compwright.workflow.stages.control import Control
from compwright.workflow.stages.decoded import DecodedState
from compwright.workflow.stages.inputs import JobInputs

SCHEMA = "compwright/card/1"
_NOTHING_PROVEN = (
    "nothing yet on a machine: not the form of the files, not sign, size, places and order of the"
    " values, not the backlash. The first good verification on this one with what was read back"
    " (compwright verify --loaded) proves what it can, and writes it down in proven/"
)


def card_document(
    job: Job,
    control: Control,
    works: Mapping[str, AxisWork],
    loaded: DecodedState | None,
    inputs: JobInputs,
    assumed: Iterable[Assumption],
    *,
    entered: Sequence[ControlFile],
    back: Sequence[ControlFile],
) -> dict[str, Any]:
    """Return the card of a run as plain data, values in µm or arcsec.

    ``entered``: the control's own files as patched, and new ones; ``back``: small files that bring
    the old values back.
    """
    written = {name: work for name, work in works.items() if work.planned.fitted is not None}
    facts = assumed_documents(assumed)
    return {
        "schema": SCHEMA,
        "title": f"Commissioning card: {', '.join(written or job.axes)}",
        "machine": dict(job.machine),
        "format": {"id": control.id, "title": control.definition.title},
        "axes": [_axis(job, control, work, loaded) for work in written.values()],
        "steps": _steps(control, written, loaded),
        "changes": changes_document(control, inputs, entered),
        "unconfirmed": [
            *(
                f"{entry['fact']}: {entry['value']}"
                for entry in facts
                if "unconfirmed" in entry["evidence"]
            ),
            *(
                print_form(control.definition.diameter.card, {"name": work.planned.axis.name})
                for work in written.values()
                if work.planned.axis.programmed == "diameter"
            ),
        ],
        "assumed": [*_as_read(written), *facts],
        "restore": _restore(control, inputs, back),
        "files": [f"tables/{control.id}/{file.name}" for file in (loaded.files if loaded else ())],
        "proven": (
            "; ".join(
                ", ".join(entry.values()) for entry in (*control.definition.proven, *job.proven)
            )
            or _NOTHING_PROVEN
        ),
    }


#: Findings that say what was taken for granted of a measurement file: what it does not say, its
#: encoding, and readings in words, which are wrong where sign, direction or unit are.
_READ = ("CW-R001", "CW-R056", "CW-R060", "CW-R062")


def _as_read(works: Mapping[str, AxisWork]) -> list[dict[str, str]]:
    """Return how the measurements were read that the tables come from, as assumed facts."""
    return [
        {
            "fact": f"axis {name}, test {result.test.name}",
            "value": finding.message,
            "evidence": f"as the file was read ({finding.code})",
        }
        for name, work in works.items()
        for result in work.results
        for finding in result.test.findings
        if finding.code in _READ
    ]


def _axis(
    job: Job, control: Control, work: AxisWork, loaded: DecodedState | None
) -> dict[str, Any]:
    axis = work.planned.axis
    factor = outside_factor(axis.kind.unit)
    table = loaded.state.axes[axis.address] if loaded else None
    new = correction_of(loaded, axis)
    return {
        "name": axis.name,
        "address": axis.address,
        "unit": outside_unit(axis.kind.unit),
        "position_unit": axis.kind.unit,
        "rows": _rows(work.planned.active, table, factor, axis.kind.unit),
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
        "numbering": _numbering(control, axis, loaded),
        "rapid": axis.motion == "rapid",
        "points_needed": control.format.points_needed(table) if table is not None else None,
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


def _numbering(control: Control, axis: Axis, loaded: DecodedState | None) -> dict[str, Any] | None:
    """Return which section has which number, as plain data; None where points have none."""
    facts = AxisFacts() if loaded is None else loaded.state.facts_of(axis.address)
    numbered = control.format.numbered(axis, facts)
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


def _rows(
    old: AxisCompensation | None, new: AxisCompensation | None, factor: float, unit: str
) -> list[dict[str, str]]:
    def describe(table: AxisCompensation | None) -> dict[str, str]:
        if table is None or table.positions.size == 0:
            return {
                "points": "none",
                "range": "-",
                "largest": "-",
                "backlash": f"{(table.backlash if table else 0.0) * factor:.2f}",
            }
        curves = np.concatenate([table.positive, table.negative]) * factor
        return {
            "points": str(table.positions.size),
            "range": f"{table.positions[0]:g} to {table.positions[-1]:g} {unit}",
            "largest": f"{curves.min():.2f} to {curves.max():.2f}",
            "backlash": f"{table.backlash * factor:.2f}",
        }

    before, after = describe(old), describe(new)
    titles = {
        "points": "points of the table",
        "range": "range of the table",
        "largest": "corrections from, to",
        "backlash": "backlash beside the table",
    }
    return [
        {"quantity": title, "old": before[key], "new": after[key]} for key, title in titles.items()
    ]


def changes_document(
    control: Control, inputs: JobInputs, entered: Sequence[ControlFile]
) -> dict[str, Any] | None:
    """Return what the files that are ``entered`` change in the control's own, as plain data; None
    where there were none.
    """
    old = inputs.states[AS_FOUND].files
    if not old or not entered:
        return None
    diff = compare_files(control.definition, old, entered)
    entries = [
        {"entry": change.entry, "old": change.old, "new": change.new} for change in diff.changes
    ]
    return {"entries": entries, "untouched": diff.untouched}


def changes_csv(changes: Mapping[str, Any]) -> bytes:
    """Return every change as CSV: entry, old, new; empty where there is none."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["entry", "old", "new"])
    writer.writerows([row["entry"], row["old"], row["new"]] for row in changes["entries"])
    return encoded(visible_lines(text.getvalue()))


def _steps(
    control: Control, written: Mapping[str, AxisWork], loaded: DecodedState | None
) -> list[dict[str, Any]]:
    """Return the steps in the order of the definition; what is the same for all axes stands
    once.
    """
    axes, both = [], []
    tells = any("{gantry}" in rule.text for rule in control.definition.card)
    for work in written.values():
        axis, fitted = work.planned.axis, work.planned.fitted
        facts = loaded.state.facts_of(axis.address) if loaded else AxisFacts()
        where = check_positions(work, correction_of(loaded, axis))
        values = (
            control.format.card_values(axis, fitted.compensation, facts, where) if fitted else {}
        )
        axes.append((axis, {**values, **_named_files(control, axis, loaded)}))
        if axis.gantry is not None and fitted and loaded and not tells:
            partner = partner_of(
                axis, axis.gantry
            )  # the same table, on numbers and in files of its own
            facts = loaded.state.facts_of(axis.gantry)
            values = control.format.card_values(partner, fitted.compensation, facts, where)
            own = {"sheet": control.format.partner_sheet(axis.name, axis.gantry)}
            axes.append((partner, {**values, **_named_files(control, partner, loaded), **own}))
            both.append(
                {
                    "title": f"{axis.name} and {axis.gantry} together",
                    "text": gantry_words(axis),
                    "evidence": "inferred",
                }
            )
    return [{**step, "heads": (), "rows": ()} for step in both] + [
        {
            "title": step.title,
            "text": step.text,
            "evidence": step.evidence,
            "heads": step.heads,
            "rows": step.rows,
        }
        for step in card_steps_of_all(control.definition, axes)
    ]


def _named_files(control: Control, axis: Axis, loaded: DecodedState | None) -> dict[str, str]:
    """Return the names of the files in the texts of the steps."""
    return control.format.named_files(axis, loaded.files if loaded else ())


def _restore(control: Control, inputs: JobInputs, back: Sequence[ControlFile]) -> list[str]:
    files = inputs.states[AS_FOUND].files
    if not files:
        off = (
            "switch the compensation of these axes off (an empty table, backlash 0), restart and"
            " reference"
        )
        return [f"The job says that nothing was active. To go back: {off}."]
    names = ", ".join(control.format.loading_order(files))
    folder = f"rollback/{control.id}/"
    copies = f"Load the untouched copies in {folder} ({names}) the same way, restart and reference."
    if not back:
        return [copies]
    small = ", then ".join(control.format.loading_order(back))
    return [
        (
            f"To undo: switch off as in the steps above, load {small} from {folder} (the old values"
            " of these axes and their switches; what was set by hand goes back by hand), activate,"
            " restart and reference."
        ),
        f"If more than these axes has to go back: {copies[0].lower()}{copies[1:]}",
    ]
