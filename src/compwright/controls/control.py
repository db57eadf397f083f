"""A control for a command: its definition, its options, and its files decoded by two file readers.

Every set of files is read by ``formats`` (from the definition) and by ``controllers`` (the judge,
an independent reader). If the two results differ, the files are refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from compwright.controllers.virtual_control import virtual_control
from compwright.controls.decoded_state import DecodedState, SingleReader
from compwright.controls.definitions import (
    carried_definition,
    definition_named,
    is_path,
    own_definition,
)
from compwright.controls.reader_comparison import disagreements
from compwright.formats.card import look_at
from compwright.formats.definition.schema import Definition
from compwright.formats.families.activity import IDLE_TEST, Activity
from compwright.formats.families.family import Family
from compwright.formats.families.shapes import RULES, control_format
from compwright.formats.text.other_files import without_other_files
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.session import Session
from compwright.records.axis import Axis
from compwright.records.correction import (
    Assumption,
    AxisCompensation,
    ControlFile,
    ControlState,
)
from compwright.records.job import Job
from compwright.records.options import KIND, REFERENCE, REFERENCE_RETURN, TABLE_VALUES
from compwright.records.plan import Plan, Texts
from compwright.records.serial_line import whole
from compwright.records.verification import LoadingName
from compwright.words.sentences import ControlText, control_text

#: Options of decode that the axes of a job say themselves, and that the reading of files without a
#: job lists itself.
_STATED_ELSEWHERE = frozenset({KIND, REFERENCE, REFERENCE_RETURN})


def _shown(value: object) -> str:
    if value is None:
        return control_text("not given")
    if isinstance(value, tuple | list):
        return ", ".join(str(entry) for entry in value) or control_text("none")
    return f"{value:g}" if isinstance(value, float) else ControlText(str(value), {})


@dataclass(frozen=True, slots=True)
class Origin:
    """The place (job, plan or command line) that states the name and options of a control.

    - ``file``: the job or plan; empty for the command line.
    - ``format_place``: key or option that names the control. ``before_option``: what precedes the
      name of an option in messages.
    - ``folder``: the folder to which the path of a definition is relative.
    - ``carried``: the texts of the definition that the plan contains.
    """

    file: str = ""
    format_place: str = "--format"
    before_option: str = "--option "
    folder: Path = Path()
    carried: Texts = ()

    def named(self, error: UsageError) -> UsageError:
        """Return a copy of ``error`` that names the place of each faulty option."""
        return UsageError(
            *(
                replace(fault, place=f"{self.before_option}{fault.place}").in_file(self.file)
                for fault in error.faults
            )
        )


COMMAND_LINE = Origin()
#: The key of a job or a machine that names the control.
JOB_PLACE = "controller.format"


def origin_of(job: Job, folder: Path) -> Origin:
    """Return the place at which a job names its control.

    ``folder``: the folder to which paths in the job are relative.
    """
    if not job.file:
        return replace(COMMAND_LINE, folder=folder)
    return Origin(job.file, JOB_PLACE, "controller.options.", folder)


def plan_origin(plan: Plan, file: Path) -> Origin:
    """Return the place at which a plan names its control."""
    return Origin(str(file), "format", "options.", carried=plan.definition)


@dataclass(frozen=True, slots=True)
class Control:
    """A control with its definition and all options. ``notes``: findings about the definition."""

    format: Family
    origin: Origin = COMMAND_LINE
    notes: tuple[Finding, ...] = ()

    @property
    def definition(self) -> Definition:
        """The known facts about the control's files."""
        return self.format.definition

    @property
    def options(self) -> Mapping[str, object]:
        """All options of the control, by name, with the value in use."""
        return self.format.options

    @property
    def given(self) -> Mapping[str, object]:
        """The options that the user gave, by name; options with default values are left out."""
        return self.format.given

    @property
    def id(self) -> str:
        """The name of the control's format."""
        return self.definition.id

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings that apply to all results for this control, for example that no independent file
        reader (virtual control) exists for it.
        """
        if self.definition.judged == "independent":
            return self.notes
        judged = Finding.of(
            "CW-S060",
            "warning",
            definition=self.id,
            expectation=self.definition.worked_for,
        )
        return (judged, *self.notes)

    def look_at(self, axis: Axis, table: AxisCompensation) -> Mapping[LoadingName, tuple[str, ...]]:
        """Return the sentences on what the user has to check at the control, by the verdict on how
        the new ``table`` was loaded (such as inverted or not active).
        """
        return look_at(self.format, axis, table)

    def in_state(self, state: ControlState) -> Control:
        """Return the control with the options, such as the length unit, that its own files state.

        ``state``: the decoded files. Raises UsageError if an option given by the user contradicts
        the files.
        """
        try:
            return replace(self, format=self.format.in_state(state, strict=True))
        except UsageError as error:
            raise self.origin.named(error) from error

    def assumed(self, *states: ControlState, axes: Sequence[Axis] = ()) -> tuple[Assumption, ...]:
        """Return an assumption for each option that has its default value because neither job,
        command line nor files state it.

        ``states``: the decoded files. ``axes``: the axes of a job; without them, all axes of the
        states. An option gives no assumption if the job or the files state it for each of these
        axes.
        """
        answered = {
            name for state in states for facts in state.facts.values() for name in facts.stated
        }
        in_files = {
            name
            for name, option in self.definition.options.items()
            if option.settled_by in answered
        }
        stated = set(self.given) | in_files | _STATED_ELSEWHERE | self._given_by_axes(states, axes)
        return tuple(
            Assumption(
                control_text("option {name}", name=name),
                _shown(value),
                self._default_evidence(name),
            )
            for name, value in self.options.items()
            if name not in stated
        )

    def _given_by_axes(self, states: Sequence[ControlState], axes: Sequence[Axis]) -> set[str]:
        named = [(self.format.address(axis)[0], set(axis.options)) for axis in axes] or [
            (address, set[str]()) for state in states for address in state.axes
        ]
        each = [
            own.union(*(state.facts_of(address).stated for state in states))
            for address, own in named
        ]
        return set.intersection(*each) if each else set()

    def _default_evidence(self, name: str) -> str:
        rule = self.definition.options.get(name)
        if rule is None or rule.evidence.state != "unconfirmed":
            return control_text("default of the definition")
        return control_text("default of the definition; {evidence}", evidence=rule.evidence.text)


def open_control(
    session: Session, format_id: str, given: Mapping[str, object], origin: Origin = COMMAND_LINE
) -> Control:
    """Return a control by its id or its definition's path. ``given``: the user's options by name;
    ``origin``: where id and options are stated. Raises UsageError with all faults.
    """
    try:
        definition, notes = _definition(session, format_id, origin)
    except UsageError as error:
        faults = (
            fault if fault.file else replace(fault, place=origin.format_place)
            for fault in error.faults
        )
        raise UsageError(*(fault.in_file(origin.file) for fault in faults)) from error
    try:
        format_ = control_format(definition, dict(given))
    except UsageError as error:
        raise origin.named(error) from error
    return Control(format=format_, origin=origin, notes=notes)


def _definition(
    session: Session, name: str, origin: Origin
) -> tuple[Definition, tuple[Finding, ...]]:
    """Return a control's definition and the findings about it; a definition copied into the plan
    takes precedence.
    """
    if not origin.carried:
        found = definition_named(session, name, origin.folder)
        return found, () if found.id == name or is_path(name) else (
            Finding.of(
                "CW-S062",
                "info",
                name=name,
                definition=found.id,
                title=ControlText(found.title, {}),
            ),
        )
    carried = carried_definition(session, origin.carried)
    if name == carried.id:
        return carried, ()
    if not is_path(name):
        return definition_named(session, name, origin.folder), ()
    try:
        found = own_definition(session, storage.named_from(origin.folder, name))
    except InputError as error:
        if Path(name).name != Path(carried.file).name:
            raise UsageError(*error.faults) from error
        return carried, (_not_as_planned(carried, f"{name} can no longer be read"),)
    if found.id != carried.id:
        return definition_named(session, name, origin.folder), ()
    same = [text for _, text in found.own] == [text for _, text in carried.own]
    return carried, () if same else (_not_as_planned(carried, f"{name} has changed since the run"),)


def _not_as_planned(carried: Definition, what: str) -> Finding:
    return Finding.of("CW-S061", "warning", what=what, carried=carried.id)


def decode(
    control: Control,
    files: Sequence[ControlFile],
    axes: Sequence[Axis] = (),
    *,
    address: str | None = None,
    written: bool = False,
    active: bool | None = None,
    asking: bool = False,
    carried_out: bool = False,
    drafting: bool = False,
) -> DecodedState:
    """Decode a control's files with compwright's two independent file readers, and compare their
    results. ``axes``: the axes of a job; ``address``: the only axis to be read; ``written``:
    compwright has just written the files; ``active``: the job's answer whether the tables were
    active, required if ``asking``.

    A table that names no axis belongs to the axis in ``axes`` or ``address``. ``active`` applies if
    the files do not state whether a table is active; without it, ``asking`` gives a UsageError.
    ``carried_out``: all values of the programs among the files were executed. ``drafting``: a job
    is drafted from the files, so tables that no job changes exclude no axis.

    Raises InputError if the files cannot be read, contradict themselves, or give different results
    with the two readers. For files written by compwright (``written``), different results are an
    internal error: CompwrightError.
    """
    if not files:
        return DecodedState(files=(), state=ControlState(format=control.id, axes={}), judge=None)
    definition = control.definition
    selects = RULES[definition.layout.shape].columns or "enabled" in definition.bindings
    if active is False and not selects:
        raise UsageError(
            Fault(
                message=(
                    f"the job gives `active: no` under `states`, but the files of {control.id} "
                    "themselves show which tables are active"
                ),
                expected="no key `active`",
                hint=f"leave out `active` in this entry of `states`. {IDLE_TEST}",
            )
        )
    carried_out = carried_out or written or active is True
    if control.definition.limit("no_patching") is not None:
        files = whole(files)
    activity = Activity(stated=active, asking=asking, carried_out=carried_out)
    reading = control.format
    if not axes:
        listing = reading.listing
        shown = listing.for_draft or listing.for_display if drafting else listing.for_display
        reading = shown(reading)
    files, left_aside = without_other_files(control.definition, files)
    given = files
    if active is False:
        files, left_out = control.format.listing.executed(control.definition, files)
        left_aside += left_out
    state = ControlState(format=control.id, axes={})
    if files:
        state = reading.read(files, axes, address=address, activity=activity)
    state = replace(state, findings=(*state.findings, *left_aside))
    if asking or not axes:
        _check_meaning(control, state, axes)
    named = [
        (each, axis) for axis in axes for each in (axis.address, axis.gantry) if each is not None
    ]
    if control.definition.judged == "read_back":
        return DecodedState(files, state, SingleReader(state), active)
    alone = address or (axes[0].address if len(axes) == 1 else None)
    judge = virtual_control(
        control.id,
        given,
        reference_return={address: axis.reference_return for address, axis in state.axes.items()},
        kinds={address: axis.kind for address, axis in state.axes.items()},
        encoder={
            **_systems(state),
            **{address: axis.encoder.system for address, axis in named if axis.encoder.stated},
        },
        active=active,
        carried_out=carried_out,
        modulo={address: axis.modulo for address, axis in named if axis.modulo is not None},
        reference={address: axis.reference for address, axis in named},
        axis_options={
            **{each: {} for each in state.axes if drafting},
            **{
                each: {**axis.options, **_judged_at(control.definition, axis)}
                for each, axis in named
            },
        },
        options={**reading.options, **({"axis": alone} if alone is not None else {})},
        axes_under_work=tuple(state.axes),
        axis_number={
            axis.address: axis.axis_number for axis in axes if axis.axis_number is not None
        },
    )
    raise_all(CompwrightError if written else InputError, disagreements(state, judge))
    return DecodedState(files=files, state=state, judge=judge, active=active)


def _judged_at(definition: Definition, axis: Axis) -> Mapping[str, str]:
    """Return the option ``motion`` with the kind of motion at which an axis was measured (rapid),
    if the control has another backlash for it; else no options.
    """
    differs = "backlash_rapid" in definition.bindings and axis.motion != "feed"
    return {"motion": axis.motion} if differs else {}


def _check_meaning(control: Control, state: ControlState, axes: Sequence[Axis]) -> None:
    """Raise UsageError if an axis' option ``table_values`` contradicts its entry sheet."""
    own = {axis.address: axis.options.get(TABLE_VALUES) for axis in axes}
    faults = []
    for address, facts in state.facts.items():
        stated, given = (
            facts.stated.get(TABLE_VALUES),
            own.get(address) or control.given.get(TABLE_VALUES),
        )
        if None in (stated, given) or stated == given:
            continue
        faults.append(
            Fault(
                message=(
                    f"axis {address}: the option {TABLE_VALUES} contradicts the entry "
                    "sheet among the control's files"
                ),
                place=control.origin.before_option + TABLE_VALUES,
                file=control.origin.file,
                expected=str(stated),
                found=str(given),
                hint=(
                    f"set `{TABLE_VALUES}: {stated}` in the options; if instead a test at the "
                    f"machine showed that the values of the table are the {given}, write "
                    f"`# value: {given}` into the sheet, or remove the table from the control and "
                    "measure again"
                ),
            )
        )
    raise_all(UsageError, faults)


def _systems(state: ControlState) -> dict[str, int]:
    """Return the number of the measuring system whose table was read, by axis address."""
    return {
        address: facts.encoder_system
        for address, facts in state.facts.items()
        if facts.encoder_system is not None
    }
