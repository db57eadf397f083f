"""``verify``: the test after loading against the plan: before, predicted and after side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from compwright.documents.json_text import to_json
from compwright.documents.plan import read_plan
from compwright.documents.record import RECORD
from compwright.documents.verification import (
    VerifiedAxis,
    VerifiedCircle,
    verification_document,
)
from compwright.foundations import storage
from compwright.foundations.errors import InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.job import AS_FOUND, Job
from compwright.records.plan import Plan
from compwright.verification.acceptance import OverallVerdict, overall_verdict
from compwright.verification.proof import changed_limits, copies, not_measured, old_circles
from compwright.verification.same_job import stale, stale_plan
from compwright.workflow.showing.recorded import (
    RunResult,
    known_to_record,
    recorded_verification,
)
from compwright.workflow.showing.view import evaluations, verify_view
from compwright.workflow.stages.after_tests import after_tests, read_again
from compwright.workflow.stages.control import (
    Control,
    DecodedState,
    decode,
    open_control,
    origin_of,
    plan_origin,
    read_files,
)
from compwright.workflow.stages.handed_over import BY_VERIFY, INPUTS, files_of_verify
from compwright.workflow.stages.settled import named_axes, settled_by_files
from compwright.workflow.stages.verified_axis import verified_axis
from compwright.workflow.stages.verify_circles import (
    split_after,
    squareness_decisions,
    verify_circles,
)

#: Findings of an axis that say what its test does not prove: the verdict is undecided.
_LACKING = frozenset({"CW-V020", "CW-V021", "CW-V024", "CW-E010"})


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifyOutcome:
    """What ``verify`` found and wrote. ``exit_code`` is 0 only for the verdict ``good``."""

    exit_code: int
    document: Mapping[str, Any]
    files: tuple[Path, ...]
    notes: tuple[str, ...] = ()


def plan_path(given: Path | None, default: Path) -> Path:
    """Return the plan file: ``given`` (a file or the folder of a run) or that of the default
    folder.
    """
    chosen = default if given is None else given
    is_file = storage.is_there(chosen) and not storage.is_folder(chosen)
    return chosen if is_file or chosen.suffix.lower() == ".json" else chosen / "plan.json"


def verify_job(
    job: Job,
    after: Sequence[str],
    *,
    plan_file: Path,
    out: Path,
    loaded: Sequence[Path] = (),
    force: bool = False,
    json_path: Path | None = None,
) -> VerifyOutcome:
    """Judge the tests after loading and write ``verification.json`` and ``verification.html`` into
    ``out``.

    ``after``: ``FILE`` or ``TEST=FILE``, relative to the working directory; ``loaded``:
    what was read back from the control; ``json_path``: the verification once more. Raises
    UsageError (2), InputError (3) and StorageError (5); nothing is written then.
    """
    plan, control, job, states = _planned(job, plan_file)
    known = [entry.axis for entry in plan.axes.values()]
    others, circle_files = split_after(plan, after)
    tests = after_tests(job, plan, others) if others or not circle_files else []
    as_found = states.get(AS_FOUND) or decode(control, (), known)
    read_back = decode(control, read_files(loaded), known) if loaded else None
    twice = copies(tests)
    axes = {
        test.axis: verified_axis(
            job, plan.axes[test.axis], test, as_found, read_back, twice.get(test.axis)
        )
        for test in tests
    }
    circles = verify_circles(plan, circle_files, as_found, states)
    measured = {name: circle.after.test for name, circle in circles.items()}
    general = [
        *changed_limits(job, plan),
        *not_measured(
            job, plan, {name: axis.before.test.name for name, axis in axes.items()}, measured
        ),
        *old_circles(plan, measured),
    ]
    verdict = _verdict(axes, circles, general)
    said = [*control.findings, *general]
    document = verification_document(plan.format, axes, verdict, circles, said)
    evaluated = _evaluated(axes, circles)
    files, notes = _files(job, control, document, *evaluated)
    before, after_loading = evaluated
    files |= recorded_verification(
        RunResult(plan, control, plan_file),
        out,
        files_of_verify(job, others, circle_files, loaded),
        files,
        document=document,
        before=before,
        after=after_loading,
    )
    elsewhere = {} if json_path is None else {json_path: files["verification.json"]}
    written = storage.write_files(
        out,
        files,
        force=force,
        elsewhere=elsewhere,
        renewed=[f"{INPUTS}/{BY_VERIFY}"],
        completed=[RECORD],
        known=known_to_record(out),
    )
    return VerifyOutcome(
        exit_code=0 if verdict == "good" else 1,
        document=document,
        files=tuple(written),
        notes=notes,
    )


def _planned(job: Job, file: Path) -> tuple[Plan, Control, Job, dict[str, DecodedState]]:
    """Return the plan of a job, its control, the job with the names and options that the control
    gives it, and what the plan's copies of the control's files say.

    Raises InputError for the plan of another job.
    """
    plan = read_plan(storage.read_bytes(file), str(file))
    control = open_control(plan.format, plan.options, plan_origin(plan, file))
    named = open_control(job.format, job.options, replace(origin_of(job), carried=plan.definition))
    if named.id != plan.format:
        raise InputError(stale("format", named.id, plan.format, str(file)))
    control = replace(control, notes=named.notes)
    own = plan.states.get(AS_FOUND, ())
    job, _ = named_axes(job, control, lambda: control.format.addresses_by_name(own))
    known = [entry.axis for entry in plan.axes.values()]
    states = {
        name: decode(control, files, known, active=plan.active.get(name))
        for name, files in plan.states.items()
    }
    job = settled_by_files(job, states, AS_FOUND)
    faults = stale_plan(job, plan, str(file), options=named.options, read=partial(read_again, job))
    raise_all(InputError, faults)
    return plan, control, job, states


def _verdict(
    axes: Mapping[str, VerifiedAxis],
    circles: Mapping[str, VerifiedCircle],
    general: Sequence[Finding],
) -> OverallVerdict:
    """Return the one verdict. Without a positioning test only squareness says whether the tables
    act.
    """
    squareness = squareness_decisions(circles)
    findings = [finding for axis in axes.values() for finding in axis.findings]
    if any(finding.severity == "error" for finding in findings):
        return "bad"
    return overall_verdict(
        [
            *(entry.decision for axis in axes.values() for entry in axis.accept.values()),
            *squareness,
        ],
        [axis.loading["verdict"] for axis in axes.values()] or ["loaded" for _ in squareness],
        still_open=bool(general) or any(finding.code in _LACKING for finding in findings),
    )


def _evaluated(
    axes: Mapping[str, VerifiedAxis], circles: Mapping[str, VerifiedCircle]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the evaluations of the tests before and after loading."""
    return (
        evaluations(
            [axis.before for axis in axes.values()],
            [circle.prediction.before for circle in circles.values()],
        ),
        evaluations(
            [axis.after for axis in axes.values()],
            [circle.after for circle in circles.values()],
        ),
    )


def _files(
    job: Job,
    control: Control,
    document: Mapping[str, Any],
    before: Mapping[str, Any],
    after: Mapping[str, Any],
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    files = {"verification.json": to_json(document).encode()}
    try:
        from compwright.reporting.report import verify_report

        view = verify_view(
            job,
            control,
            document["axes"],
            verification=document,
            evaluation_before=before,
            evaluation_after=after,
            findings=[
                *document["findings"],
                *(finding for axis in document["axes"].values() for finding in axis["findings"]),
            ],
        )
        files["verification.html"] = verify_report(view)
    except UsageError as error:
        return files, (f"verification.html is not written: {error}",)
    return files, ()
