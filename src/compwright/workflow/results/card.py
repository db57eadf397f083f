"""The commissioning card: settings, expected readings, a quick check, and the rollback."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from compwright.controls.card import (
    axis_documents,
    changes_document,
    restore_steps,
    restore_texts,
    step_documents,
    unconfirmed_diameters,
)
from compwright.controls.control import Control
from compwright.controls.cross_tables import CrossOutcome
from compwright.controls.decoded_state import DecodedState
from compwright.documents.decode import assumed_documents
from compwright.foundations.utf8 import encoded, visible_lines
from compwright.planning.axis_work import AxisWork
from compwright.records.correction import Assumption, ControlFile
from compwright.records.job import AS_FOUND, Job
from compwright.words.sentences import ControlText, SentenceText, control_text, say
from compwright.workflow.inputs.job_inputs import JobInputs

SCHEMA = "compwright/card/1"
_NOTHING_PROVEN = control_text(
    "Nothing yet on a machine: not the form of the files, not sign, size, places and order of the"
    " values, not the backlash. The first good verification on this one with what was read back"
    " (compwright verify --loaded) proves what it can, and writes it down in proven/."
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
    between: CrossOutcome,
    harmful: Sequence[str],
) -> dict[str, Any]:
    """Return the contents of a run's commissioning card as plain data, with values in µm or arcsec.

    ``loaded``: the corrections read from the written files. ``entered``: the changed copies of the
    control's own files, and new files. ``back``: small files that restore the old values.
    ``between``: the corrections between axes. ``harmful``: sentences on the harm if only some of
    the files are loaded.
    """
    written = {name: work for name, work in works.items() if work.planned.fitted is not None}
    facts = assumed_documents(assumed)
    restoring = [] if loaded is None or back else restore_steps(control, written, loaded)
    old = inputs.states[AS_FOUND]
    return {
        "schema": SCHEMA,
        "language": job.report.language,
        "title": SentenceText(say("card.title", axes=list(written or job.axes))),
        "machine": dict(job.machine),
        "format": {"id": control.id, "title": ControlText(control.definition.title, {})},
        "axes": [
            axis
            for work in written.values()
            if loaded is not None
            for axis in axis_documents(job, control, work, loaded, old)
        ],
        "steps": [
            *_in_one_step(harmful),
            *(step_documents(control, written, loaded, between.steps) if loaded else between.steps),
        ],
        "changes": changes_document(control, old.files, entered),
        "unconfirmed": [
            *(
                SentenceText(say("label.coded", code=entry["fact"], text=entry["value"]))
                for entry in facts
                if "unconfirmed" in entry["evidence"]
            ),
            *unconfirmed_diameters(control, [work.planned.axis for work in written.values()]),
        ],
        "assumed": [*_as_read(written), *facts],
        "restore": restore_texts(
            control,
            old.files,
            back,
            steps=bool(restoring) or not (written or old.files),
            between=between.written or bool(between.sheets),
        ),
        "restore_steps": restoring,
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
    """Return, as rows of the card, what was assumed when the measurement files were read."""
    return [
        {
            "fact": control_text("axis {axis}, test {test}", axis=name, test=result.test.name),
            "value": finding.message,
            "evidence": control_text("as the file was read ({code})", code=finding.code),
        }
        for name, work in works.items()
        for result in work.results
        for finding in result.test.findings
        if finding.code in _READ
    ]


def changes_csv(changes: Mapping[str, Any]) -> bytes:
    """Return all changed entries as CSV with the columns entry, old and new value."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["entry", "old", "new"])
    writer.writerows([row["entry"], row["old"], row["new"]] for row in changes["entries"])
    return encoded(visible_lines(text.getvalue()))


def _in_one_step(harmful: Sequence[str]) -> list[dict[str, Any]]:
    """Return the card's first step, "All files or none", if loading only some would do harm."""
    if not harmful:
        return []
    rule = control_text(
        "The files of this card belong together: go through all steps in one go. Move no axis"
        " before all files are loaded and active."
    )
    return [
        {
            "title": control_text("All files or none"),
            "text": SentenceText(say("paragraph", sentences=(rule, *harmful))),
            "evidence": "confirmed",
            "heads": (),
            "rows": (),
        }
    ]
