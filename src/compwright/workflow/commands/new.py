"""``new``: make a job file from the control's own files, which two independent readers decode."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from compwright.controls.control import Control, decode, open_control
from compwright.controls.control_files import files_for_job, read_control
from compwright.controls.definitions import is_path
from compwright.controls.differences import read_axis_by_axis
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded
from compwright.jobs.command_line import stated_activity
from compwright.jobs.writing import AxisDraft, Prefilled, job_text
from compwright.records.axis import AxisKind
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.facts import AxisFacts
from compwright.records.options import UnansweredOption
from compwright.workflow.results.single_files import refuse_other_kinds

#: Findings of the control's files that are shown for a new job: the basis of its contents.
_SHOWN = ("CW-S072",)


@dataclass(frozen=True, slots=True)
class NewOutcome:
    """The result of ``new``: the job file, the keys that the user must fill in, and the axes that
    are not in the job.
    """

    path: Path
    open: tuple[str, ...]
    left_out: tuple[str, ...]


def new_job(
    session: Session,
    files: Sequence[Path],
    format_id: str,
    options: dict[str, object],
    out: Path,
    *,
    force: bool = False,
) -> NewOutcome:
    """Write a job with every axis that has an active compensation in the control's files.

    If no axis has a table or backlash value, the job has every axis that the files name. From a
    folder, the job takes the files that concern the control. Raises UsageError, StorageError, and
    InputError for files that contradict themselves.
    """
    active = stated_activity(options)
    control = open_control(session, format_id, options)
    unknown = _unknown_option(control)
    assumed_value = False
    files, aside = files_for_job(session, control.definition, files)
    own = read_control(session, control, files)
    try:
        state, left_out = _read(control, own, active=active)
    except UsageError:
        if unknown is None:
            raise
        # Which axes there are does not depend on it.
        assumed_value = True
        whole = open_control(session, format_id, {**options, unknown.name: unknown.stand_in})
        state, left_out = _read(whole, own, active=active)
    drafts = list(_drafts(control, state, unknown))
    if not drafts:
        raise InputError(
            Fault(
                message="the files contain no axis",
                file=", ".join(map(str, files)),
                hint="give the control's parameter files too",
            )
        )
    given = {
        name: Prefilled(value, "as given on the command line") for name, value in options.items()
    }
    if unknown is not None:
        if assumed_value and unknown.lengths:
            drafts = [_without_lengths(draft, unknown) for draft in drafts]
        every_axis = control.definition.options[unknown.name].asked is not None
        if assumed_value or every_axis:
            given |= _unanswered(unknown, drafts)
    named = storage.relative(Path(format_id), out.parent) if is_path(format_id) else format_id
    listed = [storage.relative(path, out.parent) for path in files]
    text = job_text(named, given, listed, drafts, active=active)
    refuse_other_kinds(session, {out: encoded(text)}, force=force)
    storage.write_file(session, out, encoded(text), force=force)
    shown = (finding for finding in state.findings if finding.code in _SHOWN)
    messages = (finding.message for finding in (*control.findings, *shown))
    notes = (*aside, *left_out, *_idle(control, state, drafts), *messages)
    return NewOutcome(out, tuple(_open(given, drafts)), notes)


def _unknown_option(control: Control) -> UnansweredOption | None:
    """Return the option of the control whose value no file states and the user did not give, so
    that the user must state it; None if there is none.
    """
    open_option = control.format.unanswered_option
    if open_option is None or open_option.name not in control.definition.options:
        return None
    return open_option if control.options[open_option.name] is None else None


def _unanswered(unknown: UnansweredOption, drafts: Sequence[AxisDraft]) -> dict[str, Prefilled]:
    """Return the control's ``unknown`` option as a job key for the user to fill in; an empty
    mapping if every axis in ``drafts`` has control options of its own.
    """
    if all("options" in draft.values for draft in drafts):
        return {}
    return {unknown.name: Prefilled(None, f"{unknown.words}; nothing in the files says it")}


def _without_lengths(draft: AxisDraft, unknown: UnansweredOption) -> AxisDraft:
    """Return the draft of an axis without the lengths that were read with an assumed unit."""
    hanging = {
        key: Prefilled(None, f"mm or deg, by {unknown.name}; {entry.source}")
        for key, entry in draft.values.items()
        if key in ("travel", "modulo") and entry.value is not None
    }
    return replace(draft, values={**draft.values, **hanging})


def _read(
    control: Control, files: Sequence[ControlFile], *, active: bool | None
) -> tuple[ControlState, tuple[str, ...]]:
    """Return the contents of the files, and messages about axes that cannot be read. ``active``:
    whether the tables are active, None if the user did not state it.

    Raises InputError if no axis can be read.
    """
    try:
        return decode(control, files, active=active, drafting=True).state, ()
    except InputError:
        found = read_axis_by_axis(
            control,
            files,
            lambda address: (
                decode(control, files, address=address, active=active, drafting=True).state
            ),
        )
        if found.state is None:
            raise
        return found.state, tuple(
            f"axis {address} is left out: {error.faults[0]}"
            for address, error in found.refused.items()
        )


def _open(options: Mapping[str, Prefilled], drafts: Sequence[AxisDraft]) -> Iterator[str]:
    for name, entry in options.items():
        if entry.value is None:
            yield f"controller.options.{name}: {entry.source}"
    for draft in drafts:
        for key, entry in draft.values.items():
            if entry.value is None:
                yield f"axes.{draft.name}.{key}: {entry.source}"


def _drafts(
    control: Control, state: ControlState, unknown: UnansweredOption | None
) -> Iterator[AxisDraft]:
    compensated = [
        address
        for address, axis in state.axes.items()
        if axis.positions.size
        or axis.backlash
        or axis.slope
        or axis.others
        or state.facts_of(address).other_functions
    ]
    # A control whose every table repeats says nothing of an axis without ends by it.
    turns = "repeats" in control.definition.bindings
    names: set[str] = set()
    for address in compensated or list(state.axes):
        facts = state.facts_of(address)
        name = _name(control, address, facts)
        partners = _partners(address, name, facts)
        if (name in names and partners) or facts.leading in state.axes:
            continue  # the second joint of an axis: it gets the table of the first
        if name in names:
            raise UsageError(
                Fault(
                    message=f"two axes would be called {name}",
                    found=address,
                    hint=(
                        "give these axes different names in the control's files, or "
                        "write the job by hand"
                    ),
                )
            )
        names.add(name)
        values = dict(_values(address, state.axes[address], facts, turns=turns))
        if unknown is not None and unknown.name in facts.stated:
            values["options"] = Prefilled(
                {unknown.name: facts.stated[unknown.name]},
                f"read from the control's files: {facts.unit_evidence}",
            )
        if partners:
            values["gantry"] = Prefilled(
                partners[0], "the control's files drive this axis by two joints"
            )
        elif facts.synchronised:
            messages = "the control's files pair these two axes as a gantry"
            values["gantry"] = Prefilled(facts.synchronised[0], messages)
        yield AxisDraft(name=name, values=values)


def _partners(address: str, name: str, facts: AxisFacts) -> list[str]:
    """Return the numbers of the joints (motors), other than ``address``, that move the same axis
    according to the control's files.
    """
    return [
        str(index)
        for index, letter in enumerate(facts.letters)
        if letter == name and str(index) != address
    ]


def _idle(control: Control, state: ControlState, drafts: Sequence[AxisDraft]) -> Iterator[str]:
    """Yield one message that lists the axes in the control's files that are not in the job, because
    they have no compensation.
    """
    held = {
        str(entry.value)
        for draft in drafts
        for key, entry in draft.values.items()
        if key in ("address", "gantry")
    }
    names = {address: _name(control, address, state.facts_of(address)) for address in state.axes}
    # Where the control's files name its axes, those without a name are places for axes that the
    # machine does not have.
    named = [address for address, facts in state.facts.items() if facts.name is not None]
    left = [
        address for address in state.axes if address not in held and (not named or address in named)
    ]
    if left:
        listed = ", ".join(
            address if names[address] == address else f"{address} ({names[address]})"
            for address in left
        )
        yield (
            f"left out, because nothing in the files is active on them: {listed};"
            " add those that were measured"
        )


def _name(control: Control, address: str, facts: AxisFacts) -> str:
    """Return the axis name in the control's files, else its address."""
    if facts.name is not None:
        return facts.name
    letters = control.definition.addresses.letters
    if letters is not None and address.isdigit() and int(address) < len(letters):
        return letters[int(address)]
    return f"axis {address}" if address.isdigit() else address


def _returning(facts: AxisFacts, messages: str) -> Prefilled:
    home = facts.reference_return
    return (
        Prefilled("+", "CHECK: direction in which the reference is approached")
        if home is None
        else Prefilled(home.value, f"from {messages}")
    )


def _values(
    address: str, axis: AxisCompensation, facts: AxisFacts, *, turns: bool
) -> Iterator[tuple[str, Prefilled]]:
    messages = "the control's files"
    known = facts.kind is not None
    yield (
        "kind",
        Prefilled(
            axis.kind.value,
            f"from {messages}" if known else "CHECK: linear or rotary; the files do not say it",
        ),
    )
    yield from _travel(address, axis, facts, messages, turns=turns)
    if facts.reference is not None:
        yield "reference", Prefilled(facts.reference, f"from {messages}")
    else:
        yield "reference", Prefilled(0.0, "CHECK: machine coordinate of the reference position")
    yield "reference_return", _returning(facts, messages)
    encoder: dict[str, object] = {}
    if facts.absolute_encoder is not None:
        encoder["type"] = "absolute" if facts.absolute_encoder else "incremental"
    if facts.encoder_system is not None:
        encoder["system"] = facts.encoder_system
    if encoder:
        yield "encoder", Prefilled(encoder, f"from {messages}")
    if axis.kind is AxisKind.LINEAR and facts.diameter is not None:
        yield (
            "programmed",
            Prefilled("diameter" if facts.diameter else "radius", f"from {messages}"),
        )
    if facts.lead is not None:
        yield "screw_pitch", Prefilled(facts.lead, f"offered: {facts.lead_evidence}")
    yield "before", Prefilled(None, "[path of the measurement], or delete the axis")


def _travel(
    address: str, axis: AxisCompensation, facts: AxisFacts, messages: str, *, turns: bool
) -> Iterator[tuple[str, Prefilled]]:
    """Yield the job's keys for the travel of an axis, or for the full turn of a rotary axis.
    ``turns``: whether a table that repeats shows that its axis is endless.
    """
    low, high = facts.limits or (0.0, 0.0)
    endless = facts.endless if facts.turn is None else facts.turn.length
    turn = endless if axis.period is None else axis.period
    if turn is not None and axis.kind is AxisKind.ROTARY:
        yield "travel", Prefilled([0.0, float(turn)], f"one turn of an endless axis, by {messages}")
    elif low < high and abs(low) < 99999 and abs(high) < 99999:
        why = f"; {facts.limits_evidence}" if facts.limits_evidence else ""
        yield "travel", Prefilled([low, high], f"software limits in {messages}{why}")
    else:
        unit = "deg" if axis.kind is AxisKind.ROTARY else "mm"
        yield "travel", Prefilled(None, f"[low, high] in machine coordinates, {unit}")
    yield "address", Prefilled(address, "the control's own name of the axis")
    if axis.period is not None and (turns or axis.kind is AxisKind.ROTARY):
        yield "modulo", Prefilled(axis.period, f"the table in {messages} repeats")
    elif turn is not None and axis.kind is AxisKind.ROTARY:
        yield "modulo", Prefilled(turn, f"from {messages}: the axis has no ends")
