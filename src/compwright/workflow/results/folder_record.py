"""The record of a result folder: written by ``run``, completed by ``verify``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import Any

from compwright import __version__
from compwright.controls.control import Control
from compwright.documents.plan import listed_files
from compwright.documents.record import (
    COPIES_OF_VERIFY,
    RECORD,
    definition_entry,
    elsewhere,
    is_record,
    kept_verification,
    listed_in_record,
    outdated_verification,
    planned_record,
    read_record,
    record_bytes,
    run_record,
    verified_record,
)
from compwright.foundations import storage
from compwright.foundations.errors import InputError
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded
from compwright.records.plan import Plan
from compwright.workflow.inputs.input_copies import (
    BY_VERIFY,
    INPUTS,
    GivenFile,
    kept,
)
from compwright.workflow.results.result_files import PLAN, Results
from compwright.workflow.results.scatter import errors_of
from compwright.workflow.run.run_results import Finished


def recorded_run(
    session: Session,
    finished: Finished,
    results: Results,
    given: Sequence[GivenFile],
    out: Path,
    *,
    draft: Mapping[str, bytes] = MappingProxyType({}),
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Return the files to be written (a run's record and copies of its inputs), and the names of
    files of an earlier verification to be removed. ``draft``: the job file that a run without a job
    file makes.

    ``given``: the inputs (`files_of_job`). ``out``: the result folder.
    """
    job, control = finished.measured.job, finished.measured.control
    there = {
        name: content for name, content in results.files.items() if name.startswith("rollback/")
    }
    inputs, copies = kept(given, out, by="run", there=there, written=results.files)
    about = {
        "version": __version__,
        "machine": dict(job.machine),
        "format": control.id,
        "definition": _definition(control),
        "options": dict(finished.fitted.control.options),
        "axis_options": {
            name: dict(entry.axis.options) for name, entry in job.axes.items() if entry.axis.options
        },
        "standard": job.standard,
        "decision_rule": job.decision_rule,
        "states": sorted(finished.measured.inputs.states),
    }
    measured_in = {
        f"{name} {planned.test.name}": planned.measured_in
        for name, tests in finished.measured.inputs.tests.items()
        for planned in tests
    } | {circle.name: circle.planned.measured_in for circle in finished.wanted.circles}
    earlier = _earlier_record(session, out)
    record = run_record(
        about,
        inputs,
        {**results.files, **copies, **draft, **_own_job(given, out, earlier)},
        evaluation=results.evaluation,
        prediction=results.prediction,
        measured_in=measured_in,
        errors=errors_of,
    )
    if earlier is not None:
        record = kept_verification(record, earlier)
    outdated = {} if earlier is None else outdated_verification(record, earlier)
    stale = [
        name
        for name, digest in outdated.items()
        if fingerprint(storage.earlier_bytes(session, out / name)) == digest
    ]
    return {**copies, RECORD: record_bytes(record)}, tuple(stale)


def _own_job(
    given: Sequence[GivenFile], out: Path, earlier: Mapping[str, Any] | None
) -> dict[str, bytes]:
    """Return the job file in the result folder if an earlier run wrote this file and it was not
    changed since.
    """
    listed = {} if earlier is None else {each["file"]: each["sha256"] for each in earlier["files"]}
    return {
        file.path.name: file.content
        for file in given
        if file.role == "job"
        and file.path is not None
        and storage.resolved(file.path.parent) == storage.resolved(out)
        and listed.get(file.path.name) == fingerprint(file.content)
    }


def _earlier_record(session: Session, out: Path) -> dict[str, Any] | None:
    try:
        return read_record(storage.earlier_bytes(session, out / RECORD), RECORD)
    except InputError:
        return None


def _definition(control: Control) -> Any:
    definition = control.definition
    places = {file for file, _ in definition.text.places.values()}  # many in one file
    files = {PurePath(file).name for file in places}
    return definition_entry(
        definition.id, definition.text.data, files, own=definition.judged != "independent"
    )


def known_results(session: Session, folder: Path) -> storage.Known:
    """Return a function that decides whether a file in ``folder`` was written by a command and has
    not been changed since.
    """
    planned = listed_files(storage.earlier_bytes(session, folder / PLAN))
    listed = {**planned, **listed_in_record(storage.earlier_bytes(session, folder / RECORD))}

    def known(name: str, found: bytes) -> bool:
        if name == RECORD:
            return is_record(found)
        if name == PLAN and PLAN not in listed:  # a run of an older version left no record
            return bool(planned)
        return listed.get(encoded(name).decode()) == fingerprint(found)

    return known


def folders_of_copies(names: Mapping[str, Any] | Sequence[str]) -> list[str]:
    """Return the folders below `INPUTS` that contain the copied inputs of ``run``; those with
    inputs of ``verify`` are left out.
    """
    return list(
        dict.fromkeys(
            name.rpartition("/")[0]
            for name in names
            if name.startswith(f"{INPUTS}/") and not name.startswith(COPIES_OF_VERIFY)
        )
    )


def recorded_verification(
    session: Session,
    run: RunResult,
    out: Path,
    given: Sequence[GivenFile],
    files: Mapping[str, bytes],
    *,
    document: Mapping[str, Any],
    before: Mapping[str, Any],
    after: Mapping[str, Any],
) -> dict[str, bytes]:
    """Return the copies of the inputs of ``verify``, and the record with the verification added:
    its ``document``, and the evaluations of its tests ``before`` and ``after`` loading.

    ``files``: the other files that the command writes.
    """
    begun = _begun(session, run, out, before)
    there = _still_there(session, begun, out, files)
    inputs, copies = kept(given, out, by=BY_VERIFY, there=there, written=files)
    record = verified_record(
        begun,
        inputs,
        {**files, **copies},
        verification=document,
        evaluation=after,
        version=__version__,
        errors=errors_of,
    )
    return {**copies, RECORD: record_bytes(record)}


@dataclass(frozen=True, slots=True)
class RunResult:
    """A plan that is being verified, the control of the plan, and the path of the plan."""

    plan: Plan
    control: Control
    file: Path


def _still_there(
    session: Session, record: Mapping[str, Any], out: Path, written: Mapping[str, bytes]
) -> dict[str, bytes]:
    """Return those files of the run that are still unchanged in the folder and that this command
    does not replace.
    """
    found = {
        str(entry["file"]): (
            str(entry["sha256"]),
            storage.earlier_bytes(session, out / entry["file"]),
        )
        for entry in record["files"]
        if entry.get("by") != BY_VERIFY and entry["file"] not in written
    }
    return {
        name: content for name, (digest, content) in found.items() if fingerprint(content) == digest
    }


def _begun(
    session: Session, run: RunResult, out: Path, before: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the record of the run, to which the verification is added. If the verification is
    written to another folder, the record does not list the run's files.

    A run of an older version has no record. It is then made from the plan, as far as possible.
    """
    digest = fingerprint(storage.earlier_bytes(session, run.file))
    try:
        record = read_record(storage.earlier_bytes(session, run.file.parent / RECORD), RECORD)
        own = (record["plan"] or {}).get("sha256") == digest
    except (InputError, KeyError, AttributeError):
        record, own = {}, False
    if not own:
        return planned_record(_about_plan(run), digest, before, errors_of)
    if storage.resolved(run.file.parent) == storage.resolved(out):
        return record
    return elsewhere(record)


def _about_plan(run: RunResult) -> dict[str, Any]:
    plan = run.plan
    return {
        "version": plan.version,
        "machine": dict(plan.machine),
        "format": plan.format,
        "definition": _definition(run.control),
        "options": dict(plan.options),
        "axis_options": {
            name: dict(entry.axis.options)
            for name, entry in plan.axes.items()
            if entry.axis.options
        },
        "standard": plan.standard,
        "decision_rule": plan.decision_rule,
        "states": sorted(plan.states),
    }
