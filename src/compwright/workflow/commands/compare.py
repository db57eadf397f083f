"""``compare``: compare the values read back from the control with the plan, and name each
difference.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from compwright.controls.control import Control, decode, open_control, plan_origin
from compwright.controls.control_files import holds_archive, read_control
from compwright.controls.cross_tables import write_planned
from compwright.controls.decoded_state import DecodedState
from compwright.controls.differences import ComparedSide, compared_side
from compwright.controls.file_replacement import loadable_files, with_new_tables
from compwright.controls.judged_corrections import judged_correction
from compwright.controls.partial_loads import PartialLoad, partial_load
from compwright.controls.read_back import not_read_back, read_back_differences
from compwright.controls.reader_comparison import probe_positions
from compwright.documents.compare import ComparedAxis, Difference, compare_document
from compwright.documents.plan import read_plan
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import PLAN
from compwright.foundations.session import Session
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import ControlFile
from compwright.records.job import AS_FOUND
from compwright.records.plan import Plan, PlannedAxis
from compwright.verification.read_back import SAME, judge_read_back
from compwright.words.sentences import SentenceText, say
from compwright.workflow.run.export_stage import write_fitted

#: Why values cannot be read: a fault, or a question that the changed values raise.
_Refused = InputError | UsageError


@dataclass(frozen=True, slots=True)
class CompareOutcome:
    """The result of ``compare``; exit code 0 if the control's values equal the plan's, else 1.
    ``doubts``: why equal values do not show that the control is as planned.
    """

    exit_code: int
    document: Mapping[str, Any]
    doubts: tuple[Finding, ...]


def compare_plan(session: Session, plan_file: Path, loaded: Sequence[Path]) -> CompareOutcome:
    """Return how files that were read back from the control differ from a plan.

    Raises UsageError for a plan without tables. Raises InputError for files that cannot be read,
    contradict themselves or contain no data of an axis of the plan.
    """
    plan = read_plan(storage.read_bytes(session, plan_file, PLAN), str(plan_file))
    control = open_control(session, plan.format, plan.options, plan_origin(plan, plan_file))
    planned = [entry for entry in plan.axes.values() if entry.fitted is not None]
    if not planned and not any(entry.delivered for entry in plan.cross):
        raise UsageError(
            Fault(
                message="the plan contains no table, so there is nothing to compare",
                file=str(plan_file),
                hint="give the plan of a run that wrote tables",
            )
        )
    axes = [entry.axis for entry in planned]
    as_found = decode(
        control, plan.states.get(AS_FOUND, ()), axes, active=plan.active.get(AS_FOUND)
    )
    files, wish = planned_files(control.in_state(as_found.state), plan, as_found)
    given = read_control(session, control, loaded)
    found, refused = _found(control, given, axes, loaded)
    names = {
        address: axis.name
        for axis in axes
        for address in (axis.address, axis.gantry)
        if address is not None
    }
    back = compared_side(control, given, "read back", files)
    planned_side = ComparedSide((), {}, as_found.state)  # a sheet alone, and no files before
    if files:
        planned_side = compared_side(control, files, "the plan", given)
    if planned_side.state is None:
        # a changed key next to the file that it replaces: the other axes are those of the state
        planned_side = replace(planned_side, state=as_found.state, findings=())
    before = control.format.listing.file_values(control.definition, as_found.files, files)
    partly = partial_load(before, planned_side.entries, back.entries)
    read_back = read_back_differences(
        control, planned_side, back, names, plan.cross, plan.every_axis
    )
    differs = read_back.own or read_back.others.differences
    if refused is not None and not (
        differs and {axis.address for axis in axes} <= _axes_in(control, back)
    ):
        raise refused
    compared = {
        entry.axis.name: _compared(
            control, entry, wish, found[entry.axis.address], as_found, read_back.own, partly
        )
        for entry in planned
    }
    states = [one.state for one in found.values() if isinstance(one, DecodedState)]
    of_states = (finding for state in states for finding in state.findings)
    own = tuple(not_read_back(plan_file, loaded))
    if own:
        compared = {name: _not_read_back(axis) for name, axis in compared.items()}
    findings = tuple(dict.fromkeys((*control.findings, *own, *of_states, *read_back.findings)))
    assumed = tuple(dict.fromkeys(one for state in states for one in state.assumed))
    wanted = () if wish is None else wish.state.findings
    expected = (*as_found.state.findings, *wanted, *planned_side.findings)
    foreign = _axes_in(control, back) - {*names, *names.values()}
    unread = _unread(planned_side, back) if foreign else ()
    doubts = (
        *read_back.doubts,
        *unread,
        *_new_doubts(findings, {finding.code for finding in expected}),
    )
    rest = [finding for finding in findings if finding not in doubts]
    document = compare_document(plan.format, compared, read_back.others, assumed, rest, doubts)
    return CompareOutcome(0 if document["verdict"] == "same" else 1, document, doubts)


#: No doubts of a job, but of a control that was read back: a table that no axis names any more,
#: and files that only one reader understands.
_NEW_IN_CONTROL = frozenset({"CW-S012", "CW-S081"})


def _unread(planned: ComparedSide, back: ComparedSide) -> tuple[Finding, ...]:
    """Return the findings (CW-S080) that axes in the files read back cannot be read; none if the
    same axes are unreadable in the plan's own files.
    """
    all_lost = back.state is None and planned.state is not None
    lost = all_lost or back.unread - planned.unread
    return tuple(one for one in back.findings if one.code == "CW-S080") if lost else ()


def _new_doubts(found: Sequence[Finding], known: Collection[str]) -> Iterator[Finding]:
    """Yield the doubts about the files read back, without those whose code is ``known`` from the
    plan.
    """
    for one in found:
        new_in_control = one.code in _NEW_IN_CONTROL and one.severity != "info"
        if (one.is_doubt or new_in_control) and one.code not in known:
            yield one


def _found(
    control: Control, files: Sequence[ControlFile], axes: Sequence[Axis], loaded: Sequence[Path]
) -> tuple[dict[str, DecodedState | _Refused], _Refused | None]:
    """Return, for each axis address, the correction in the files read back (``loaded``: their
    paths), or the error because of which the correction cannot be read.

    If the control's axes can be read separately, an error of one axis does not hide the others. The
    second result is an error that concerns all axes, or None. Raises InputError if the files
    contain no data of an axis.
    """
    try:
        found = decode(control, files, axes)
    except (InputError, UsageError) as error:
        singly = control.format.listing.readable_alone(control.format, files)
        alone = all(axis.address in singly for axis in axes)
        return {
            axis.address: _found_alone(control, files, axis) if alone else error for axis in axes
        }, error
    unsaid = (axis for axis in axes if axis.address not in found.state.axes)
    raise_all(InputError, [_unsaid(axis.name, axis.address, loaded) for axis in unsaid])
    return dict.fromkeys((axis.address for axis in axes), found), None


def _found_alone(
    control: Control, files: Sequence[ControlFile], axis: Axis
) -> DecodedState | _Refused:
    try:
        return decode(control, files, [axis])
    except (InputError, UsageError) as error:
        return error


def _axes_in(control: Control, side: ComparedSide) -> set[str]:
    """Return the addresses of the axes about which the files contain data."""
    whereabouts = control.format.listing.value_location
    return {
        address
        for entry in side.entries.values()
        if entry.relevant
        for address in whereabouts(control.definition, entry, side.entries, side.state)[0]
    }


def planned_files(
    control: Control, plan: Plan, as_found: DecodedState
) -> tuple[tuple[ControlFile, ...], DecodedState | None]:
    """Return the control's files as they are if the plan is loaded completely, and the corrections
    that are decoded from these files (None if the plan has no table). ``as_found``: the control's
    contents before.

    The plan's files replace those files of the control from which they were made.
    """
    fitted = [
        (entry.axis, entry.fitted) for entry in plan.axes.values() if entry.fitted is not None
    ]
    files, wish = write_fitted(control, fitted, as_found)
    axes = plan.every_axis
    tabled = [axis.name for axis, table in fitted if table.compensation.positions.size]
    cross = [entry for entry in plan.cross if entry.written]
    files = write_planned(control, cross, files, as_found, axes, tabled).files
    if holds_archive(as_found.files):
        # it stays one: small files lie over it, and are no contradiction
        files = loadable_files(control, files, as_found, [axis for axis, _ in fitted], None).files
    addresses = [axes[name].address for name in tabled]
    return with_new_tables(control, as_found.files, files, addresses), wish


def _compared(
    control: Control,
    entry: PlannedAxis,
    wish: DecodedState | None,
    found: DecodedState | _Refused,
    as_found: DecodedState,
    own: Mapping[str, Sequence[Difference]],
    partly: PartialLoad | None,
) -> ComparedAxis:
    """Return how the correction and the other values of one axis in the files read back differ from
    the plan. ``own``: the differences of other values, by axis; ``partly``: which files were
    loaded, None if all of them.

    ``found``: the corrections read back, or the error because of which they are unknown.
    """
    axis = entry.axis
    if isinstance(found, (InputError, UsageError)):
        why = _partly(partly, str(found)) if partly else str(found)
        return ComparedAxis(axis.address, axis.kind, why, tuple(own.get(axis.name, ())))
    read_back = judge_read_back(
        judged_correction(wish, axis),
        judged_correction(found, axis),
        judged_correction(as_found, axis),
        *_points(entry),
    )
    look_at = _look_at(control, entry, read_back.verdict)
    if partly is not None and read_back.verdict != "loaded":
        message = _partly(partly, read_back.message)
        read_back = replace(read_back, verdict="partial", message=message)
    texts = own.get(axis.name, ())
    values = tuple(_values(entry, wish, found)) if read_back.verdict != "loaded" or texts else ()
    return ComparedAxis(
        axis.address,
        axis.kind,
        read_back,
        (*texts, *values),
        look_at,
    )


def _not_read_back(axis: ComparedAxis) -> ComparedAxis:
    """Return the comparison of an axis with files that ``run`` itself wrote. If the values equal
    the plan, the message states that these files do not show what is in the control.
    """
    found = axis.read_back
    if isinstance(found, str) or found.verdict != "loaded":
        return axis
    return replace(axis, read_back=replace(found, message=SentenceText(say("read_back.own"))))


def _partly(load: PartialLoad, why: str) -> SentenceText:
    """Return the sentence for a plan of which only some files were loaded (``load``: which ones,
    and which are missing). ``why``: the reason why the values cannot be read, or how they differ.
    """
    loaded, missing = list(load.loaded), list(load.missing)
    return SentenceText(say("read_back.partly", loaded=loaded, missing=missing, why=why))


def _look_at(control: Control, entry: PlannedAxis, verdict: str) -> tuple[str, ...]:
    """Return what the user should check on the control to find the cause of a difference."""
    if entry.fitted is None or verdict == "loaded":
        return ()
    sentences = control.look_at(entry.axis, entry.fitted.compensation)
    return {str(name): of_states for name, of_states in sentences.items()}.get(verdict, ())


def _unsaid(name: str, address: str, loaded: Sequence[Path]) -> Fault:
    return Fault(
        message=(
            f"the files contain no data of axis {name} (address "
            f"{address}); missing values do not count as zero"
        ),
        file=", ".join(map(str, loaded)),
        expected="the data of each axis of the plan, as read back from the control",
        hint=f"add the file with the data of {address} to `--loaded`",
    )


def _points(entry: PlannedAxis) -> tuple[FloatArray, float]:
    positions = entry.fitted.compensation.positions if entry.fitted is not None else np.empty(0)
    if positions.size < 2:
        return positions, 0.0
    return probe_positions(positions), float(positions[1] - positions[0])


def _values(
    entry: PlannedAxis, wish: DecodedState | None, found: DecodedState
) -> Iterator[Difference]:
    """Yield each table point and direction at which the correction differs from the plan."""
    axis = entry.axis
    if entry.fitted is None:
        return
    factor, unit = outside_factor(axis.kind.unit), outside_unit(axis.kind.unit)
    positions = entry.fitted.compensation.positions
    if positions.size == 0:
        positions = np.array(axis.travel)
    for direction in Direction:
        mine, theirs = (
            judged_correction(wish, axis)(positions, direction),
            judged_correction(found, axis)(positions, direction),
        )
        for position, planned, loaded in zip(positions, mine, theirs, strict=True):
            if abs(planned - loaded) > SAME:
                quantity = (
                    f"correction at {position:.10g} {axis.kind.unit} arriving in {direction.value}"
                )
                yield Difference(
                    axis.name, quantity, float(planned * factor), float(loaded * factor), unit
                )
