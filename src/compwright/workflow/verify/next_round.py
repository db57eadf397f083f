"""The next round after loading: which axes can be corrected further, and the result folder of its
job.

A change is added to the existing table under two conditions. A measurement has shown that this
table is active as planned, and the values read back are those that were to be loaded. Every other
axis keeps its existing table, because a change could be added to a loading fault, or could make a
wrong sign worse.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, Final

from compwright.controls.control import Control, decode
from compwright.controls.file_replacement import contents_after_loading
from compwright.documents.next_round import UpdatedAxis, next_document
from compwright.documents.record import RECORD, copied_by_record
from compwright.documents.verification import VerifiedAxis, VerifiedCircle
from compwright.foundations import storage
from compwright.foundations.errors import (
    CapacityError,
    Fault,
    InputError,
    StorageError,
    UsageError,
)
from compwright.foundations.findings import Finding
from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.units import outside_factor, shown_unit
from compwright.foundations.utf8 import encoded
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile
from compwright.records.job import AS_FOUND, Job, other_axis
from compwright.records.limits import LimitingCauses
from compwright.records.plan import Plan
from compwright.verification.proof import AfterTest
from compwright.words.sentences import SentenceText, say
from compwright.workflow.inputs.input_copies import files_of_job
from compwright.workflow.inputs.jobs import read_job_file
from compwright.workflow.results.folder_record import known_results, recorded_run
from compwright.workflow.results.result_files import result_files
from compwright.workflow.run.pipeline import run_stages
from compwright.workflow.run.run_results import Finished
from compwright.workflow.verify.next_files import JOB, Looped, next_files

#: The folder of the next round, in that of the results.
FOLDER: Final = "next"
#: Findings, in addition to doubts, that name a proof that the test of an axis lacks.
LACKING: Final = frozenset(
    {"CW-V020", "CW-V021", "CW-V024", "CW-V026", "CW-V029", "CW-V032", "CW-V036"}
)
#: Findings that name a circle which was not measured after loading.
_UNPROVEN: Final = frozenset({"CW-V025", "CW-V029", "CW-V032", "CW-V034"})
_NOT_FROM_HERE: Final = frozenset({"CW-V011", "CW-S087", "CW-V022", "CW-V033"})


@dataclass(frozen=True, slots=True, kw_only=True)
class Verified:
    """The plan, the job, the files and the results of ``verify``, as the next round needs them.

    ``specs``: those values of ``--after`` that are positioning tests. ``tests``: these tests.
    ``circles``: results of circles after loading. ``circle_files``: the files of each circle, by
    name. ``read_back``: the files read back from the control.
    """

    job: Job
    plan: Plan
    control: Control
    specs: Sequence[str]
    tests: Sequence[AfterTest]
    axes: Mapping[str, VerifiedAxis]
    circles: Mapping[str, VerifiedCircle]
    circle_files: Mapping[str, Sequence[Path]]
    findings: Sequence[Finding]
    read_back: tuple[ControlFile, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """The document about the next round, the files of the next round (empty if it is not written),
    and notes for the user.

    ``whole``: folders that contain exactly these files afterwards. ``renewed``: folders in which
    the user may keep his own files.
    """

    document: Mapping[str, Any]
    files: Mapping[str, bytes] = field(default_factory=dict)
    whole: Sequence[str] = ()
    renewed: Sequence[str] = ()
    notes: tuple[str, ...] = ()


def next_round(
    session: Session,
    found: Verified,
    compared: Mapping[str, Any] | str,
    out: Path,
    each: Each = in_turn,
) -> Round:
    """Return the next round of a verified job, or the reason why no axis can be corrected further.
    ``compared``: the document of ``compare``, or the reason why there is none.
    """
    outcomes = {name: UpdatedAxis(reason=why) for name, why in _refused(found, compared)}
    general = _general(found, compared)
    well = [test for test in found.tests if test.axis not in outcomes]
    planes = list(_squareness(found, [test.axis for test in well]))
    if general or not (well or planes):
        return Round(document=next_document(general or _no_axis(found), outcomes))
    try:
        looped = _looped(found, well, planes)
        inputs = next_files(session, found.job, found.plan, looped)
        finished, results, notes = _worked(session, inputs, out / FOLDER, each)
    except (InputError, UsageError, CapacityError) as error:
        reason = "; ".join(str(fault) for fault in error.faults)
        stopped = SentenceText(say("next.cannot_be_made", reason=reason))
        return Round(document=next_document(stopped, outcomes))
    outcomes |= {test.axis: _updated_axis(finished, test.axis) for test in well}
    between = any(entry.written for entry in finished.written.cross.planned)
    updated = any(axis.updated for axis in outcomes.values())
    stop, why = (True, "") if updated or between else _kept_squareness(found, finished)
    if not stop:
        return Round(document=next_document(why, outcomes))
    outcomes = {name: outcomes[name] for name in found.plan.axes if name in outcomes}
    files = {**inputs, **results}
    return Round(
        document=next_document(
            why or _result(outcomes, between=between),
            outcomes,
            list(_between(found, looped)),
            written=True,
        ),
        files={f"{FOLDER}/{name}": content for name, content in files.items()},
        whole=[f"{FOLDER}/{name}" for name in _whole(session, out, inputs, found.plan.format)],
        renewed=[f"{FOLDER}/card"],
        notes=notes,
    )


# ---------------------------------------------------------------- may it be corrected further


def _general(found: Verified, compared: Mapping[str, Any] | str) -> str:
    """Return the reason why no axis at all can be corrected further, or "" if some axes can.
    ``compared``: the document of ``compare``, or the reason why there is none.
    """
    # limits that were changed, a table between axes that is another one or was not read back
    changed = [one.message for one in found.findings if one.code in _NOT_FROM_HERE]
    if changed:
        return changed[0]
    if isinstance(compared, str):
        return SentenceText(say("next.not_compared", why=compared))
    elsewhere = [one for one in compared["differences"] if one["axis"] not in compared["axes"]]
    off = {name: one for name, one in compared["axes"].items() if one["verdict"] != "loaded"}
    more = len(elsewhere) - 1
    if off and elsewhere and not any(one["axis"] for one in elsewhere):
        # values that name no axis: those of a table that is not the plan's, as far as anyone knows
        differing = [
            say("of_axis_small", axis=name, finding=one["message"]) for name, one in off.items()
        ]
        quantity = elsewhere[0]["quantity"]
        return SentenceText(
            say("next.read_back_differs", axes=differing, quantity=quantity, more=more)
        )
    if elsewhere:
        first = elsewhere[0]
        return SentenceText(
            say("next.something_else", quantity=first["quantity"], axis=first["axis"], more=more)
        )
    return ""


def _no_axis(found: Verified) -> str:
    """Return the message that no axis can be corrected further, and so no squareness either."""
    if not (found.circles and found.job.apply.squareness):
        return SentenceText(say("next.no_axis"))
    faulty = sorted(
        {
            circle.after.test.plane
            for circle in found.circles.values()
            if circle.squareness is not None and not circle.squareness.active
        }
    )
    if faulty:
        return SentenceText(say("next.squareness_not_active", planes=faulty))
    axes = found.plan.axes.values()
    measured = any(entry.fitted is not None and entry.tests for entry in axes)
    return SentenceText(say("next.squareness_alone", measured=measured))


def _kept_squareness(found: Verified, finished: Finished) -> tuple[bool, str]:
    """Return whether no plane needs a further correction, and the message about squareness."""
    about = [each for each in finished.written.findings if each.code in {"CW-P106", "CW-P107"}]
    if not about:
        return False, _no_axis(found)
    stop = all(each.code == "CW-P107" for each in about)
    planes = [each.values["plane"] for each in about if stop or each.code == "CW-P106"]
    return stop, SentenceText(say("next.stop_squareness", stop=stop, planes=planes))


def lacks_proof(finding: Finding) -> bool:
    """Return whether a finding means that a test does not prove the planned table active."""
    of_scale = finding.code == "CW-V035" and bool(finding.values.get("axis"))
    return finding.code in LACKING or finding.is_doubt or of_scale


def _refused(found: Verified, compared: Mapping[str, Any] | str) -> Iterator[tuple[str, str]]:
    """Yield the axes of the plan that must not be corrected further, each with the reason.
    ``compared``: the document of ``compare``, or the reason why there is none.
    """
    for name, entry in found.plan.axes.items():
        if entry.fitted is None:
            yield name, SentenceText(say("next.no_table"))
        elif not entry.tests:
            yield name, SentenceText(say("next.circles_only"))
        elif name not in found.axes:
            yield name, SentenceText(say("next.not_measured"))
        elif why := _doubted(found.axes[name]) or _differs(name, compared):
            yield name, SentenceText(say("next.kept", why=why))


def _doubted(axis: VerifiedAxis) -> str:
    """Return why a test does not prove the planned table active, or "" if the test proves it."""
    verdict = axis.loading["verdict"]
    if verdict != "loaded":
        name, of = verdict.replace("_", " "), axis.loading.get("of") or ""
        return SentenceText(say("next.verdict", verdict=verdict, name=name, of=of))
    doubts = [one for one in axis.findings if lacks_proof(one) or one.severity == "error"]
    if doubts:
        first = doubts[0]
        return SentenceText(say("next.doubted", code=first.code, message=first.message))
    return ""


def _differs(name: str, compared: Mapping[str, Any] | str) -> str:
    """Return, as text, how the files read back differ from the plan for the axis ``name``; "" if
    they do not differ or were not compared.
    """
    if isinstance(compared, str):
        return ""
    axis = compared["axes"][name]
    mine = [one["quantity"] for one in compared["differences"] if one["axis"] == name]
    if axis["verdict"] == "loaded" and not mine:
        return ""
    quantity = mine[0] if mine else ""
    return SentenceText(say("next.differs", why=axis["message"], quantity=quantity))


# ---------------------------------------------------------------- the job and what it makes


def _looped(found: Verified, well: Sequence[AfterTest], planes: Sequence[str]) -> Looped:
    """Return the results of this round that the job of the next round needs as inputs. ``well``:
    the tests of the axes that can be corrected further; ``planes``: those whose squareness can be.
    """
    axes = {test.axis: test for test in well}
    pairs = [_pair(found.job, plane) for plane in planes]
    by_circles = {
        axis
        for circle in found.plan.circles.values()
        if axes.keys() & set(circle.test.axes) or frozenset(circle.test.axes) in pairs
        for axis in circle.test.axes
        if axis in found.job.axes
    }
    others = [name for name in found.job.axes if name in by_circles - axes.keys()]
    files = contents_after_loading(found.plan.states.get(AS_FOUND, ()), found.read_back)
    return Looped(
        axes=axes,
        files=files,
        active=_active(found, files, list(axes) or others),
        other_axes=others,
        circles=_measured(found),
        squareness=planes,
    )


def _measured(found: Verified) -> dict[str, Sequence[Path]]:
    """Return, by name, the files of the circular tests that were made after loading. Copies of
    those from before loading, older files, files of another machine and doubtful ones are left out.
    """
    unproven = {one.values.get("circle") for one in found.findings if one.code in _UNPROVEN}
    unproven |= {
        name for name, circle in found.circles.items() if any(map(lacks_proof, circle.findings))
    }
    return {name: files for name, files in found.circle_files.items() if name not in unproven}


def _pair(job: Job, plane: str) -> frozenset[str]:
    bent = job.apply.squareness[plane]
    return frozenset({bent, other_axis(plane, bent)})


def _active(found: Verified, files: Sequence[ControlFile], axes: Sequence[str]) -> bool | None:
    """Return whether the next job must state that the tables are active: True if the control's
    files do not state it, else None.
    """
    working = [found.job.axes[name].axis for name in axes]
    try:
        decode(found.control, files, working, asking=True)
    except UsageError:
        return True
    return None


def _squareness(found: Verified, axes: Collection[str]) -> Iterator[str]:
    """Yield the planes whose squareness can be corrected again in the next round. ``axes``: the
    axes that can be corrected further.

    A plane is yielded if its circle was measured again and no axis of it has a table in doubt. If
    its squareness was corrected before, this correction must be active.
    """
    doubted = {
        name
        for name, entry in found.plan.axes.items()
        if entry.fitted is not None and name not in axes
    }
    measured = _measured(found)
    for plane in found.job.apply.squareness:
        pair = _pair(found.job, plane)
        again = [
            found.circles[name]
            for name in measured
            if frozenset(found.plan.circles[name].test.axes) == pair
        ]
        corrected = [entry for entry in found.plan.cross if entry.pair == pair]
        proven = all(circle.squareness is not None and circle.squareness.active for circle in again)
        if again and not pair & doubted and (proven or not corrected):
            yield plane


def _worked(
    session: Session, inputs: Mapping[str, bytes], folder: Path, each: Each
) -> tuple[Finished, Mapping[str, bytes], tuple[str, ...]]:
    """Return the results of the next job after all stages of ``run``, the files made from these
    results, and notes for the user.
    """
    next_session = session.with_pending(folder, inputs)
    job = read_job_file(next_session, folder / JOB)
    finished = run_stages(next_session, job, folder, folder, each=each)
    results = result_files(finished, each)
    given = files_of_job(next_session, job, folder, finished.measured.control.definition.own)
    record, _ = recorded_run(session, finished, results, given, folder)
    return finished, {**results.files, **record}, results.notes


def _updated_axis(finished: Finished, name: str) -> UpdatedAxis:
    """Return whether an axis gets a new table in the next round, and why it does or does not."""
    work, prediction = finished.works[name], finished.predicted.axes[name]
    if work.planned.fitted is not None:
        return UpdatedAxis(
            updated=True, table=True, reason=_gained(prediction.limits, work.planned.axis)
        )
    if not work.stops:
        return UpdatedAxis(reason=SentenceText(say("next.stop_axis", stop=False, why=work.refused)))
    stopped = [one.message for one in prediction.findings if one.code == "CW-P155"]
    reason = SentenceText(say("next.stop_axis", stop=True, why=work.refused))
    return UpdatedAxis(
        updated=True,
        reason=stopped[0].removeprefix(f"Axis {name}: ") if stopped else reason,
    )


def _gained(limits: LimitingCauses | None, axis: Axis) -> str:
    """Return the sentence on how the new table is expected to change the parameter in ``limits``;
    if ``limits`` is None, only that a new table is written.
    """
    if limits is None:
        return SentenceText(say("next.written"))
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    now, then = limits.now * factor, limits.then * factor
    parameter = limits.parameter
    return SentenceText(say("next.gained", parameter=parameter, now=now, then=then, unit=unit))


def _result(outcomes: Mapping[str, UpdatedAxis], *, between: bool) -> str:
    """Return the sentence that asks the user to load the tables of the next round (those in
    ``outcomes``, and those ``between`` axes), or to stop because a further round would gain too
    little.
    """
    tabled = [name for name, axis in outcomes.items() if axis.table]
    if tabled or between:
        return SentenceText(say("next.load", axes=tabled, between=between))
    stopped = [name for name, axis in outcomes.items() if axis.updated]
    return SentenceText(say("next.stop", axes=stopped))


def _between(found: Verified, looped: Looped) -> Iterator[str]:
    """Yield a sentence for each correction between axes in the plan, which states whether the next
    round makes its table again or keeps it.
    """
    again = [_pair(found.job, plane) for plane in looped.squareness]
    for entry in found.plan.cross:
        yield SentenceText(
            say("next.between_again", output=entry.output, input=entry.input)
            if entry.pair in again
            else say("next.between_kept", output=entry.output, input=entry.input)
        )


# ---------------------------------------------------------------- its folder


def refuse_later_rounds(session: Session, out: Path) -> None:
    """Raise StorageError if the next round in ``out`` is already verified, and would be lost."""
    gone_on = out / FOLDER / "verification.json"
    if storage.is_there(session, gone_on):
        raise StorageError(
            Fault(
                message=(
                    f"the tables in {FOLDER} are already verified: this file is their "
                    "verification, and is not replaced, not even with --force"
                ),
                file=str(gone_on),
                expected=f"another `--out`, or no {FOLDER} in this folder",
                hint=f"give another `--out`, or move {FOLDER} to another folder",
            )
        )


def known_with_rounds(session: Session, out: Path, known: storage.Known) -> storage.Known:
    """Return a function that decides whether a file was written by a command and is unchanged, in
    the result folder (decided by ``known``) or in the folder of its next round.
    """
    inputs = copied_by_record(storage.earlier_bytes(session, out / FOLDER / RECORD))
    of_round = known_results(session, out / FOLDER)

    def known_below(name: str, content: bytes) -> bool:
        if not name.startswith(f"{FOLDER}/"):
            return known(name, content)
        below = encoded(name.removeprefix(f"{FOLDER}/")).decode()
        return of_round(below, content) or inputs.get(below) == fingerprint(content)

    return known_below


def _whole(session: Session, out: Path, inputs: Mapping[str, bytes], format_id: str) -> list[str]:
    """Return the folders of the next round that may contain only files of the next round."""
    earlier = copied_by_record(storage.earlier_bytes(session, out / FOLDER / RECORD))
    folders = {str(PurePosixPath(name).parent) for name in (*inputs, *earlier)}
    sets = {f"{name}/{format_id}" for name in ("tables", "rollback")}
    return sorted((folders | sets) - {"."})
