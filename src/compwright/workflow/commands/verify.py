"""``verify``: compare the test after loading with the test before and the prediction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from compwright.controls.control import Control, decode, open_control, origin_of, plan_origin
from compwright.controls.control_files import read_control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.job_completion import completed_by_files, named_axes, with_counted_turns
from compwright.controls.read_back import (
    not_read_back,
)
from compwright.documents.json_text import to_json
from compwright.documents.plan import read_plan
from compwright.documents.record import RECORD
from compwright.documents.verification import (
    VerifiedAxis,
    VerifiedCircle,
    verification_document,
)
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import PLAN
from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.session import Session
from compwright.records.circular import CircularTest
from compwright.records.job import AS_FOUND, Job
from compwright.records.plan import Plan
from compwright.records.positioning import PositioningTest
from compwright.verification.acceptance import OverallVerdict, overall_verdict
from compwright.verification.proof import (
    changed_limits,
    copied_tests,
    not_measured,
    other_circle,
    outside_of_tables,
    read_back_findings,
    unproven_circle,
)
from compwright.verification.stale_plan import stale_fault, stale_plan
from compwright.workflow.commands.compare import CompareOutcome, compare_plan, planned_files
from compwright.workflow.inputs.after_tests import after_tests, read_again
from compwright.workflow.inputs.input_copies import BY_VERIFY, INPUTS, files_of_verify
from compwright.workflow.results.folder_record import (
    RunResult,
    known_results,
    recorded_verification,
)
from compwright.workflow.results.report_file import answer_files
from compwright.workflow.results.single_files import refuse_other_kinds
from compwright.workflow.results.view import evaluations, verify_view
from compwright.workflow.verify.circle_decision import TablesOnControl
from compwright.workflow.verify.next_round import (
    FOLDER,
    Round,
    Verified,
    known_with_rounds,
    lacks_proof,
    next_round,
    refuse_later_rounds,
)
from compwright.workflow.verify.proof_export import FOLDER as PROVEN
from compwright.workflow.verify.proof_export import proven_files
from compwright.workflow.verify.verified_axis import between_axes, differing_tables, verified_axis
from compwright.workflow.verify.verify_circles import (
    split_after,
    squareness_decisions,
    verify_circles,
)

VERIFICATION = "verification.json"
NOT_READ_BACK = Fault(
    message="`--update` needs the tables that are now in the control, as the start of the next "
    "round",
    place="--update",
    expected="--loaded with the files that are now in the control",
    hint="add `--loaded` with the files read back from the control",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifyOutcome:
    """The result of ``verify``. ``exit_code`` is 0 only for the verdict ``good``. ``of_axes``: the
    values of ``--after`` that are positioning tests. ``of_circles``: those of circles, by name.
    """

    exit_code: int
    document: Mapping[str, Any]
    files: tuple[Path, ...]
    notes: tuple[str, ...] = ()
    of_axes: tuple[str, ...] = ()
    of_circles: Mapping[str, Sequence[str]] = field(default_factory=dict)


def plan_path(session: Session, given: Path | None, default: Path) -> Path:
    """Return the path of the plan file. ``given``: the file itself, or the folder of a run; None
    means the folder ``default``.
    """
    chosen = default if given is None else given
    is_file = storage.is_there(session, chosen) and not storage.is_folder(chosen)
    return chosen if is_file or chosen.suffix.lower() == ".json" else chosen / "plan.json"


def verify_job(
    session: Session,
    job: Job,
    after: Sequence[str],
    *,
    plan_file: Path,
    out: Path,
    loaded: Sequence[Path] = (),
    force: bool = False,
    json_path: Path | None = None,
    report: Path | None = None,
    update: bool = False,
    profile: Path | None = None,
    each: Each = in_turn,
) -> VerifyOutcome:
    """Judge the tests after loading, and write the results into ``out``, with ``update`` also the
    files of the next round, all or nothing.

    The results are ``verification.json`` and ``verification.html``. The next round is written into
    the folder ``next`` in ``out``.

    - ``after``: texts ``FILE`` or ``TEST=FILE``, relative to the working directory.
    - ``loaded``: the files that were read back from the control.
    - ``profile``: the mapping profile of the tests after loading; default: that of the job.
    - ``json_path``: the path of another copy of the verification. ``report``: that of its page as
      PDF.
    - ``each``: applies a function to the axes of the next round.

    Raises UsageError (2; also for ``update`` without ``loaded``), InputError (3) and StorageError
    (5); no file is written then. If the next round cannot be made, the exit code is 1.
    """
    if update and not loaded:
        raise UsageError(NOT_READ_BACK)
    if update:
        refuse_later_rounds(session, out)
    found, verdict, compared = _verified(session, job, after, plan_file, loaded, profile)
    document = _document(found, verdict)
    values = compared if isinstance(compared, str) else compared.document
    then = next_round(session, found, values, out, each) if update else None
    if then is not None:
        document = {**document, "next": then.document}
    evaluated = _evaluated(found.axes, found.circles)
    words = _options(("--after", after), ("--loaded", loaded), ("--profile", (profile,)))
    files, notes = _files(found.job, found.control, document, *evaluated, words)
    before, after_loading = evaluated
    proof, proven = proven_files(found, document, (out, plan_file.parent), loaded)
    files |= proof
    files |= recorded_verification(
        session,
        RunResult(found.plan, found.control, plan_file),
        out,
        files_of_verify(session, found.job, found.specs, found.circle_files, loaded, profile),
        files,
        document=document,
        before=before,
        after=after_loading,
    )
    return VerifyOutcome(
        exit_code=0 if verdict == "good" and (then is None or then.files) else 1,
        document=document,
        files=_stored(session, out, files, then, json_path, report, force=force),
        notes=(*notes, *proven, *(then.notes if then is not None else ()), *_left_over(out, then)),
        of_axes=tuple(found.specs),
        of_circles={
            name: [f"{name}={path.as_posix()}" for path in paths]
            for name, paths in found.circle_files.items()
        },
    )


def verification_of(
    session: Session,
    job: Job,
    after: Sequence[str | PositioningTest | CircularTest],
    plan_file: Path,
    loaded: Sequence[Path],
) -> dict[str, Any]:
    """Return the verification document without writing it. ``after``: the tests after loading, as
    files or in memory; ``loaded``: the control's files that were read back.
    """
    found, verdict, _ = _verified(session, job, after, plan_file, loaded)
    return _document(found, verdict)


def _document(found: Verified, verdict: OverallVerdict) -> dict[str, Any]:
    return verification_document(
        found.plan.format, found.axes, verdict, found.circles, found.findings
    )


def _verified(
    session: Session,
    job: Job,
    after: Sequence[str | PositioningTest | CircularTest],
    plan_file: Path,
    loaded: Sequence[Path],
    profile: Path | None = None,
) -> tuple[Verified, OverallVerdict, CompareOutcome | str]:
    """Return the results of the tests after loading, the verdict on the whole job, and the
    comparison of the files read back (``loaded``) with the plan, or why there is none. ``profile``:
    the mapping profile of these tests, None for that of the job.
    """
    plan, control, job, states = _planned(session, job, plan_file)
    known = [entry.axis for entry in plan.axes.values()]
    others, circle_files = split_after(session, plan, after)
    tests = after_tests(session, job, plan, others, profile) if others or not circle_files else []
    as_found = states.get(AS_FOUND) or decode(control, (), known)
    stored = as_found
    if plan.active.get(AS_FOUND) is False:  # what its tables do once they are switched on
        with suppress(CompwrightError):  # unknown where the files do not show which one would be on
            stored = decode(control, plan.states[AS_FOUND], known, active=True)
    read_back = decode(control, read_control(session, control, loaded), known) if loaded else None
    ours = tuple(not_read_back(plan_file, loaded))
    twice = copied_tests(tests)
    axes = {
        test.axis: verified_axis(
            job,
            control,
            plan.axes[test.axis],
            test,
            as_found,
            stored.state,
            read_back,
            twice.get(test.axis),
            {name: axis for name, axis in plan.axes.items() if name != test.axis},
            ours=bool(ours),
        )
        for test in tests
    }
    compared = _compared(session, plan_file, loaded) if loaded else ""
    cross = [entry for entry in plan.cross if entry.written and read_back]
    files = planned_files(control.in_state(as_found.state), plan, as_found)[0] if cross else ()
    between = list(between_axes(control, plan, files, as_found, read_back))
    on_control = TablesOnControl.of(
        control.in_state(as_found.state),
        plan,
        as_found,
        stored.state,
        between,
        compared.document["axes"] if isinstance(compared, CompareOutcome) else {},
        believed=read_back is not None and not ours,
    )
    circles = verify_circles(session, job, plan, circle_files, on_control, states)
    measured = {name: circle.after.test for name, circle in circles.items()}
    general = [
        *changed_limits(job, plan),
        *not_measured(
            job,
            plan,
            {name: axis.before.test.name for name, axis in axes.items()},
            measured,
            {axis for circle in circles.values() for axis in circle.scales},
        ),
        *(
            finding
            for name, test in measured.items()
            for finding in (
                *unproven_circle(
                    plan.circles[name].test, test, job.machine.get("serial", ""), name
                ),
                *(
                    other_circle(plan.circles[name].test, test, name, limited=True)
                    if circles[name].accept
                    else ()
                ),
            )
        ),
        *(found for _, found in between),
        *differing_tables(
            control,
            (entry for name, entry in plan.axes.items() if name not in axes),
            as_found,
            read_back,
        ),
    ]
    if isinstance(compared, CompareOutcome):
        more = list(read_back_findings(job, compared.document, compared.doubts, general))
        named = outside_of_tables(compared.document)
        # The finding of the others names the table, its value and its place.
        repeated = [found for entry, found in between if entry and entry.addresses[1] in named]
        general = [one for one in general if one.code != "CW-V011" or one not in repeated] + more
    found = Verified(
        job=job,
        plan=plan,
        control=control,
        specs=[spec for spec in others if isinstance(spec, str)],
        tests=tests,
        axes=axes,
        circles=circles,
        circle_files={
            name: [part for part in parts if isinstance(part, Path)]
            for name, parts in circle_files.items()
        },
        findings=(*control.findings, *ours, *general),
        read_back=() if read_back is None else read_back.files,
    )
    return found, _verdict(plan, axes, circles, general), compared


def _compared(session: Session, plan_file: Path, loaded: Sequence[Path]) -> CompareOutcome | str:
    """Return the result of ``compare``, or the reason why the comparison failed."""
    try:
        return compare_plan(session, plan_file, loaded)
    except (InputError, UsageError) as error:
        return "; ".join(str(fault) for fault in error.faults)


def _stored(
    session: Session,
    out: Path,
    files: Mapping[str, bytes],
    then: Round | None,
    json_path: Path | None,
    report: Path | None,
    *,
    force: bool,
) -> tuple[Path, ...]:
    """Write the files of the verification and of the next round (``then``), all or none. Returns
    the written paths.
    """
    below = {} if then is None else then.files
    page = files.get("verification.html")
    answer = answer_files(files[VERIFICATION], json_path, page, report)
    refuse_other_kinds(
        session, answer, force=force, results=[out / name for name in (*files, *below)]
    )
    return tuple(
        storage.write_files(
            session,
            out,
            {**files, **below},
            force=force,
            elsewhere=answer,
            whole=() if then is None else then.whole,
            renewed=[PROVEN, f"{INPUTS}/{BY_VERIFY}", *(() if then is None else then.renewed)],
            completed=[RECORD],
            known=known_with_rounds(session, out, known_results(session, out)),
        )
    )


def _left_over(out: Path, then: Round | None) -> tuple[str, ...]:
    """Return a tuple with the warning that the folder still contains the next round of an earlier
    verification, whose files must not be loaded. The tuple is empty if there is none, or if the new
    next round ``then`` replaces it.
    """
    if (then is not None and then.files) or not storage.is_folder(out / FOLDER):
        return ()
    return (f"{out / FOLDER} is of an earlier verification; do not load anything of it",)


def _planned(
    session: Session, job: Job, file: Path
) -> tuple[Plan, Control, Job, dict[str, DecodedState]]:
    """Return the plan, the control, the job with the control's axis names, and what the control
    contained in each of the job's ``states``.

    Raises InputError if the plan belongs to another job.
    """
    if not storage.is_there(session, file):
        raise InputError(
            Fault(
                message="there is no plan of this job",
                file=str(file),
                expected="--plan with the result folder of `compwright run`, or its plan.json",
                hint=(
                    f"run the job first: `compwright run {job.file}`; or give the"
                    " folder of its results with `--plan DIR`"
                ),
            )
        )
    plan = read_plan(storage.read_bytes(session, file, PLAN), str(file))
    control = open_control(session, plan.format, plan.options, plan_origin(plan, file))
    named = open_control(
        session,
        job.format,
        job.options,
        replace(origin_of(job, Path(job.file).parent), carried=plan.definition),
    )
    if named.id != plan.format:
        raise InputError(stale_fault("format", named.id, plan.format, str(file)))
    control = replace(control, notes=named.notes)
    own = plan.states.get(AS_FOUND, ())
    job, _ = named_axes(job, control, lambda: control.format.listing.names(control.format, own))
    known = [entry.axis for entry in plan.axes.values()]
    states = {
        name: decode(control, files, known, active=plan.active.get(name))
        for name, files in plan.states.items()
    }
    job = completed_by_files(job, states, AS_FOUND)
    job, _ = with_counted_turns(job, control, {name: one.tests for name, one in plan.axes.items()})
    faults = stale_plan(
        job, plan, str(file), options=named.options, read=partial(read_again, session, job)
    )
    raise_all(InputError, faults)
    return plan, control, job, states


def _verdict(
    plan: Plan,
    axes: Mapping[str, VerifiedAxis],
    circles: Mapping[str, VerifiedCircle],
    general: Sequence[Finding],
) -> OverallVerdict:
    """Return the verdict on the job. ``general``: findings about the whole job, each of which
    prevents the verdict ``good``. If there are only circular tests, the decisions on squareness are
    used in place of loading verdicts, and scale errors that were corrected from circles are loaded
    if nothing is found against them.
    """
    squareness = squareness_decisions(circles)
    scales = [entry for entry in plan.axes.values() if entry.fitted and not entry.tests]
    tested: list[VerifiedAxis | VerifiedCircle] = [*axes.values(), *circles.values()]
    findings = [finding for one in tested for finding in one.findings]
    if any(finding.severity == "error" for finding in (*findings, *general)):
        return "bad"
    return overall_verdict(
        [
            *(entry.decision for one in tested for entry in one.accept.values()),
            *squareness,
        ],
        [
            *(
                [axis.loading["verdict"] for axis in axes.values()]
                or ["loaded" for _ in (*squareness, *scales)]
            ),
            *(verdict for circle in circles.values() for verdict in circle.scale_loading),
        ],
        still_open=bool(general) or any(lacks_proof(finding) for finding in findings),
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


def _options(*given: tuple[str, Iterable[object]]) -> list[str]:
    """Return command-line options and their values as a list of words."""
    return [
        word
        for name, values in given
        for value in values
        if value is not None
        for word in (name, str(value))
    ]


def _files(
    job: Job,
    control: Control,
    document: Mapping[str, Any],
    before: Mapping[str, Any],
    after: Mapping[str, Any],
    options: Sequence[str],
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    files = {VERIFICATION: to_json(document).encode()}
    try:
        from compwright.reporting.verify_report import verify_report

        view = verify_view(
            job,
            control,
            document["axes"],
            options,
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
