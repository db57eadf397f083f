"""``run``: evaluate measurements, fit tables, write the control's files and read them again as a
check, predict new tests, and report.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from compwright.documents.decode import assumed_documents
from compwright.documents.findings import finding_documents
from compwright.documents.record import RECORD, listed_in_record
from compwright.foundations import storage
from compwright.foundations.errors import UsageError
from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded
from compwright.jobs.assumed_job import assumed_job, assumed_of
from compwright.records.job import Job
from compwright.records.prediction import AxisPrediction, CirclePrediction
from compwright.workflow.inputs.input_copies import files_of_job, given_job
from compwright.workflow.results.folder_record import folders_of_copies, known_results, recorded_run
from compwright.workflow.results.report_file import answer_files
from compwright.workflow.results.result_files import NO_STATE, PLAN, Results, result_files
from compwright.workflow.results.single_files import refuse_other_kinds
from compwright.workflow.run.pipeline import run_stages
from compwright.workflow.run.run_results import Finished
from compwright.workflow.verify.next_files import JOB
from compwright.workflow.verify.next_round import FOLDER as ROUND

NO_STATE_OPTION = (
    "--state: no table is written without the state of the control; add --state none, or --state"
    " with each of its files"
)
_NO_JOB = JOB + " is not written: a file name is not valid UTF-8: {}; rename the file"


@dataclass(frozen=True, slots=True, kw_only=True)
class RunOutcome:
    """The result of ``run``: the results of all stages, and the paths of the written files.

    ``no_tables``: why there are no tables at all. ``refused``: by axis, why a table that the job
    requires is missing.
    """

    exit_code: int
    evaluation: Mapping[str, Any]
    prediction: Mapping[str, Any]
    assumed: tuple[Mapping[str, str], ...]
    findings: tuple[Mapping[str, str], ...]
    files: tuple[Path, ...]
    no_tables: str = ""
    refused: Mapping[str, str]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedJob:
    """A job after all stages of ``run``, with the contents of its result files, which are not
    written yet.

    ``folder``: the folder of the job's relative paths. ``stated``: for a job without a job file,
    the values of the command line, which are then written with the results.
    """

    job: Job
    folder: Path
    stated: Mapping[str, Any] | None
    finished: Finished
    results: Results

    @property
    def exit_code(self) -> int:
        """Exit code: 0 if the limits are met, 1 if not, 2 if the control's contents are unknown."""
        return _exit_code(self.finished)

    def finding_documents(self) -> list[dict[str, Any]]:
        """Return the findings as plain data for JSON documents."""
        return finding_documents(self.finished.findings)


def planned(
    session: Session,
    job: Job,
    folder: Path,
    out: Path,
    *,
    stated: Mapping[str, Any] | None = None,
    accept_worse: bool = False,
    each: Each = in_turn,
) -> PlannedJob:
    """Return a job after all stages of ``run``, without writing any file. ``stated``: the values of
    the command line, for a run without a job file; ``accept_worse``: also write tables that would
    not improve their axis.

    ``out``: the folder of its results. ``each``: applies a function to all axes, one after the
    other or in parallel; the results are the same to the byte. Raises UsageError (2), InputError
    (3) and CapacityError (4).
    """
    finished = run_stages(session, job, folder, out, accept_worse=accept_worse, each=each)
    return PlannedJob(
        job=job,
        folder=folder,
        stated=stated,
        finished=finished,
        results=result_files(finished, each),
    )


def write_planned(
    session: Session,
    planned: PlannedJob,
    out: Path,
    *,
    force: bool = False,
    json_path: Path | None = None,
    report: Path | None = None,
) -> RunOutcome:
    """Write the files of a finished job into ``out``, all of them or none, together with the
    prediction (``json_path``) and the report as PDF (``report``) if these paths are given.

    If the state of the control is unknown, evaluation, prediction and report are written but no
    table (exit 2). Raises StorageError (5); no file is written then.
    """
    job, stated = planned.job, planned.stated
    finished, results = planned.finished, planned.results
    earlier = listed_in_record(storage.earlier_bytes(session, out / RECORD))
    draft = {} if stated is None else _assumed_job(stated, finished)
    given = [
        *(given_job(JOB, out / JOB, content) for content in draft.values()),
        *files_of_job(session, job, planned.folder, finished.measured.control.definition.own),
    ]
    recorded, outdated = recorded_run(session, finished, results, given, out, draft=draft)
    files = {**results.files, **recorded, **draft}
    elsewhere = answer_files(
        files["prediction.json"],
        json_path,
        files.get("report.html"),
        report,
        files.get("card/card.html"),
    )
    refuse_other_kinds(session, elsewhere, force=force, results=[out / name for name in files])
    sets = [f"{name}/{finished.measured.control.id}" for name in ("tables", "rollback")]
    any_there = any(storage.is_there(session, path) for path in elsewhere)
    paths = storage.write_files(
        session,
        out,
        files,
        # An earlier run without a state wrote no tables: its evaluation may be replaced.
        force=force or (bool(earlier) and PLAN not in earlier and not any_there),
        elsewhere=elsewhere,
        whole=sets,
        renewed=["card", *folders_of_copies(earlier)],
        outdated=outdated,
        known=known_results(session, out),
    )
    return RunOutcome(
        exit_code=planned.exit_code,
        evaluation=results.evaluation,
        prediction=results.prediction,
        assumed=tuple(
            assumed_documents(
                [
                    *(assumed_of(stated, _answered_by_files(finished)) if stated else ()),
                    *finished.assumed,
                ]
            )
        ),
        findings=tuple(planned.finding_documents()),
        files=tuple(paths),
        no_tables=(
            "" if finished.stated else f"{job.file}: {NO_STATE}" if job.file else NO_STATE_OPTION
        ),
        refused={
            name: str(work.refused)
            for name, work in finished.works.items()
            if work.refused and not work.stops
        },
        notes=(
            *results.notes,
            *_no_job(stated, draft),
            *_gone(out, outdated),
        ),
    )


def _assumed_job(stated: Mapping[str, Any], finished: Finished) -> dict[str, bytes]:
    """Return, by file name, a job file with the values ``stated`` on the command line and all
    assumptions. No file is returned if the name of an input file is not valid UTF-8.
    """
    as_text = json.dumps(stated, ensure_ascii=False)
    if encoded(as_text).decode() != as_text:
        return {}
    options, by_files = finished.fitted.control.options, _answered_by_files(finished)
    return {JOB: assumed_job(stated, options, finished.assumed, by_files).encode()}


def _no_job(stated: Mapping[str, Any] | None, draft: Mapping[str, bytes]) -> Iterator[str]:
    """Yield the note that no job file is written because file names are not valid UTF-8, if a run
    from the command line (``stated``) made no job file (``draft``).
    """
    if stated is not None and not draft:
        texts = re.findall(r'"([^"]*)"', json.dumps(stated, ensure_ascii=False))
        shown = {text: encoded(text).decode() for text in texts}
        yield _NO_JOB.format(", ".join(name for text, name in shown.items() if name != text))


def _answered_by_files(finished: Finished) -> dict[str, object]:
    """Return the job keys ``reference`` and ``reference_return`` with the values that the control's
    files state for an axis.
    """
    return {
        key: value
        for axis in finished.measured.axes.values()
        if axis.zero_at_reference
        for key, value in (
            ("reference", axis.reference),
            ("reference_return", axis.reference_return.value),
        )
    }


def _gone(out: Path, outdated: Sequence[str]) -> Iterator[str]:
    """Yield notes that an earlier verification in the result folder was removed because it belongs
    to another plan.
    """
    if not outdated:
        return
    names = ", ".join(encoded(name).decode() for name in outdated)
    yield f"{out}: the verification there was of another plan, and is removed ({names})"
    if storage.is_folder(out / ROUND):
        yield f"{out / ROUND} is of that verification; do not load anything of it"


def _exit_code(finished: Finished) -> int:
    if not finished.stated:
        return UsageError.exit_code
    # a table refused, a correction not made, a circle that gets worse
    failed = any(
        finding.severity == "error" or finding.code == "CW-P131" for finding in finished.findings
    )
    predicted: list[AxisPrediction | CirclePrediction] = [
        *finished.predicted.axes.values(),
        *finished.predicted.circles.values(),
    ]
    decisions = [entry.decision for one in predicted for entry in one.accept.values()]
    failed = failed or bool(finished.doubts.open)
    return 1 if failed or any(decision != "accept" for decision in decisions) else 0
