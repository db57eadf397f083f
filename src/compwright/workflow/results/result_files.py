"""The files of a run: documents, tables, rollback, card and report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from compwright.controls.gantries import with_partners
from compwright.controls.partial_loads import harmful_parts
from compwright.documents.decode import assumed_documents
from compwright.documents.findings import finding_documents
from compwright.documents.json_text import to_json
from compwright.documents.plan import plan_document
from compwright.documents.prediction import prediction_document
from compwright.foundations.errors import UsageError
from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.provenance import fingerprint
from compwright.foundations.utf8 import encoded
from compwright.records.correction import ControlFile
from compwright.words.sentences import SentenceText, say
from compwright.workflow.results.card import card_document, changes_csv
from compwright.workflow.results.view import evaluations, run_view
from compwright.workflow.run.export_stage import tables_of
from compwright.workflow.run.run_results import Finished

NO_STATE = SentenceText(say("run.no_state"))

PLAN = "plan.json"


@dataclass(frozen=True, slots=True)
class Results:
    """The contents of every file of a run by relative name, the evaluation and prediction
    documents, and notes for the user.
    """

    files: Mapping[str, bytes]
    evaluation: Mapping[str, Any]
    prediction: Mapping[str, Any]
    notes: tuple[str, ...] = ()


def result_files(finished: Finished, each: Each = in_turn) -> Results:
    """Return every file of a run, in the listed order."""
    tests = [result for work in finished.works.values() for result in work.results]
    evaluation = evaluations(tests, [work.result for work in finished.wanted.circles])
    prediction = prediction_document(
        finished.measured.control.id,
        finished.predicted.axes,
        finished.written.cross.totals,
        finished.predicted.circles,
        finished.first,
        finished.doubts.acknowledged,
        judged=finished.measured.control.definition.judged,
    )
    files = {
        "evaluation.json": to_json(evaluation).encode(),
        "prediction.json": to_json(prediction).encode(),
        **_control_files(finished),
    }
    card = _card(finished, prediction)
    files |= _card_files(finished, card)
    notes: tuple[str, ...] = ()
    try:
        if card is not None:
            from compwright.reporting.card import card_html

            files["card/card.html"] = card_html(dict(card))
        names = [*files, "report.html"]
        files["report.html"] = _report(finished, card, names, evaluation, prediction, each)
    except UsageError as error:
        notes = (f"report.html is not written: {error}",)
    if finished.stated:
        made = {
            encoded(name).decode(): fingerprint(content)
            for name, content in files.items()
            if name != PLAN
        }
        files[PLAN] = to_json(plan_document(finished.plan(made))).encode()
    return Results(files, evaluation, prediction, notes)


def _control_files(finished: Finished) -> dict[str, bytes]:
    """Return the contents of the tables and rollback files by name, and an empty entry for the
    plan, which is made later.
    """
    as_found, format_id = finished.measured.as_found, finished.fitted.control.id
    if as_found is None:
        return {}
    written = finished.written
    sets = {"tables": written.tables, "rollback": (*as_found.files, *written.back)}
    return {
        PLAN: b"",
        **{
            f"{folder}/{format_id}/{file.name}": file.raw
            for folder, files in sets.items()
            for file in files
        },
    }


def _card(finished: Finished, prediction: Mapping[str, Any]) -> Mapping[str, Any] | None:
    """Return the card as plain data, or None if nothing has to be done at the control."""
    written = finished.written
    if not (written.tables or written.cross.steps):
        return None
    card = card_document(
        finished.measured.job,
        finished.fitted.control,
        finished.works,
        written.loaded,
        finished.measured.inputs,
        finished.assumed,
        entered=written.entered,
        back=written.back,
        between=written.cross,
        harmful=_harmful(finished),
    )
    return {
        **card,
        "doubts": prediction["doubts"],
        "acknowledged": prediction["acknowledged"],
        "limits": prediction["axes"],
        "circle_limits": prediction["circles"],
    }


def _harmful(finished: Finished) -> tuple[str, ...]:
    """Return sentences about the harm of loading only some of the written files."""
    written, as_found = finished.written, finished.measured.as_found
    works = {name: work for name, work in finished.works.items() if work.planned.fitted is not None}
    own = () if as_found is None else as_found.files
    return harmful_parts(finished.fitted.control, own, written.tables, works)


def _card_files(finished: Finished, card: Mapping[str, Any] | None) -> dict[str, bytes]:
    """Return the card as text, the list of changed entries, and the entry sheets."""
    if card is None:
        return {}
    from compwright.reporting.card import card_markdown

    sheets = (*_second_forms(finished), *finished.written.cross.sheets)
    changes = {} if card["changes"] is None else {"card/changes.csv": changes_csv(card["changes"])}
    return {
        "card/card.md": encoded(card_markdown(dict(card))),
        **changes,
        **{f"card/{file.name}": file.content for file in sheets},
    }


def _second_forms(finished: Finished) -> tuple[ControlFile, ...]:
    control, as_found = finished.fitted.control, finished.measured.as_found
    if as_found is None:
        return ()
    every = with_partners(control, tables_of(finished.works, {}), as_found)
    return control.format.sheets(
        [table.compensation for _, table in every], [axis for axis, _ in every]
    )


def _report(
    finished: Finished,
    card: Mapping[str, Any] | None,
    names: list[str],
    evaluation: Mapping[str, Any],
    prediction: Mapping[str, Any],
    each: Each,
) -> bytes:
    """Return the HTML report, which lists the files ``names``. Raises UsageError if the extra
    ``report`` is not installed.
    """
    from compwright.reporting.run_report import run_report

    as_found = finished.measured.as_found
    view = run_view(
        finished.measured.job,
        finished.fitted.control,
        finished.works,
        finished.written.loaded,
        evaluation=evaluation,
        prediction=prediction,
        assumed=assumed_documents(finished.assumed),
        findings=finding_documents(finished.findings),
        files=names,
        changes=None if card is None else card["changes"],
        no_tables=None if finished.stated else NO_STATE,
        stated=finished.stated,
        state_files=[] if as_found is None else [file.name for file in as_found.files],
    )
    return run_report(view, each)
