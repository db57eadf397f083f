"""``export``: write the tables of a plan again, for the plan's control or for another control."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from compwright.controls.control import COMMAND_LINE, Control, decode, open_control
from compwright.controls.control_files import read_control
from compwright.controls.cross_tables import write_planned
from compwright.controls.decoded_state import DecodedState
from compwright.controls.file_replacement import loadable_files
from compwright.controls.job_completion import completed_axis
from compwright.documents.plan import read_plan
from compwright.foundations import storage
from compwright.foundations.errors import (
    CapacityError,
    CompwrightError,
    Fault,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import PLAN
from compwright.foundations.session import Session
from compwright.jobs.command_line import stated_activity
from compwright.planning.practical_tables import planned_request
from compwright.planning.tables import fit_within
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, ControlFile
from compwright.records.fitted_table import FittedTable
from compwright.records.job import AS_FOUND
from compwright.records.plan import Plan, PlannedCross
from compwright.workflow.inputs.own_output import refuse_added_again
from compwright.workflow.results.own_files import write_listed
from compwright.workflow.run.export_stage import write_fitted

#: ``--option address.X=0``: how the control names axis X of the plan.
ADDRESS = "address."


@dataclass(frozen=True, slots=True)
class ExportOutcome:
    """The result of ``export``: written files, assumptions, axes without a table, and findings."""

    files: tuple[Path, ...]
    assumed: tuple[Assumption, ...]
    missing: tuple[str, ...]
    findings: tuple[Finding, ...] = ()


def export_plan(
    session: Session,
    path: Path,
    format_id: str,
    options: dict[str, object],
    states: Sequence[str],
    out: Path,
    *,
    force: bool = False,
) -> ExportOutcome:
    """Fit tables to the total corrections in the plan file ``path`` within the limits of a control,
    and write the control's files into ``out``.

    ``states``: the present contents of the control, ``none`` or its files; empty: as in the plan,
    if the plan is for the same format. Another control has its own names of the axes: the options
    ``address.NAME`` give them, and otherwise the plan's names are used. Raises UsageError (2) if
    the state is unknown, InputError (3), CapacityError (4) and StorageError (5).
    """
    plan = read_plan(storage.read_bytes(session, path, PLAN), str(path))
    addresses = {
        key.removeprefix(ADDRESS): str(options.pop(key))
        for key in list(options)
        if key.startswith(ADDRESS)
    }
    active = stated_activity(options)
    raise_all(UsageError, _unknown(addresses, plan, str(path)))
    origin = replace(COMMAND_LINE, carried=plan.definition)
    control = open_control(session, format_id, options, origin)
    if control.id == plan.format:
        control = open_control(session, format_id, {**plan.options, **options}, origin)
    moved, taken = _axes_here(plan, control, addresses, options)
    state = _state(session, plan, control, list(moved.values()), states, str(path), active=active)
    refuse_added_again(plan, path, state)
    moved = {
        name: completed_axis(axis, [state.state], control.given) for name, axis in moved.items()
    }
    control = control.in_state(state.state)
    fitted = _refitted(plan, control, moved)
    if not fitted and not plan.cross:
        raise UsageError(
            Fault(
                message=(
                    "the plan contains no table: every axis was left as it is, "
                    "because no table would improve it"
                ),
                file=str(path),
                hint="give the plan of a run that wrote tables",
            )
        )
    files, image = write_fitted(control, fitted, state)
    tabled = [axis.name for axis, table in fitted if table.compensation.positions.size]
    cross = write_planned(
        control, [_addressed(entry, moved) for entry in plan.cross], files, state, moved, tabled
    )
    axes = [axis for axis, _ in fitted]
    delivery = loadable_files(control, cross.files, state, axes, None if cross.written else image)
    written = write_listed(
        session,
        out,
        {file.name: file.raw for file in delivery.files},
        command="export",
        force=force,
        as_set=True,
    )
    return ExportOutcome(
        files=tuple(written),
        assumed=tuple(
            dict.fromkeys((*control.assumed(state.state, axes=axes), *state.state.assumed, *taken))
        ),
        missing=tuple(name for name, entry in plan.axes.items() if entry.fitted is None),
        findings=(*control.findings, *cross.findings),
    )


def _refitted(
    plan: Plan, control: Control, axes: Mapping[str, Axis]
) -> list[tuple[Axis, FittedTable]]:
    """Return the axes of a plan, each with a table fitted within the limits of a control."""
    fitted = []
    errors: list[CompwrightError] = []
    for name, entry in plan.axes.items():
        if entry.wanted is None or entry.fitted is None:
            continue
        axis = axes[name]
        try:
            capacity = control.format.capacity(axis, one_curve=entry.request.mode == "single")
            request = entry.request
            if plan.format == control.id:
                capacity, request = planned_request(capacity, request, entry.fitted)
            table = fit_within(entry.wanted, capacity, request, axis)
        except CapacityError as error:
            errors.append(CapacityError(*(fault.within(f"axis {name}") for fault in error.faults)))
        else:
            fitted.append((axis, table))
    raise_all(CapacityError, collect(errors))
    return fitted


def _axes_here(
    plan: Plan, control: Control, addresses: Mapping[str, str], options: Mapping[str, object]
) -> tuple[dict[str, Axis], list[Assumption]]:
    """Return the axes of a plan by name, with the addresses that they have on ``control``, and the
    assumptions about these addresses.

    For the plan's own control the result has all axes. For another control it has those that get a
    table or whose name is given. Options belong to one control, so those of the plan's control are
    not used for another. ``options``: those of the command, which override them.
    """
    same = plan.format == control.id
    fitted = {name for name, entry in plan.axes.items() if entry.fitted is not None}
    crossing = {name for entry in plan.cross for name in entry.pair} & set(plan.axes)
    axes: dict[str, Axis] = {}
    assumed = []
    for name, axis in plan.every_axis.items():
        if not (same or name in fitted or name in addresses or name in crossing):
            continue
        wanted_address = addresses.get(name, axis.address if same else name)
        address, assumption = control.format.address(replace(axis, address=wanted_address))
        own = {key: value for key, value in axis.options.items() if same and key not in options}
        axes[name] = replace(axis, address=address, options=own)
        assumed += [assumption] if assumption is not None and name in fitted else []
    return axes, assumed


def _addressed(entry: PlannedCross, axes: Mapping[str, Axis]) -> PlannedCross:
    """Return a planned cross-axis correction, in which the two axes have their addresses on the
    control of the export.
    """
    given, bent = axes.get(entry.input), axes.get(entry.output)
    added = entry.added if given is None else replace(entry.added, input=given.address)
    return replace(entry, added=added if bent is None else replace(added, output=bent.address))


def _unknown(addresses: Mapping[str, str], plan: Plan, file: str) -> list[Fault]:
    return [
        Fault(
            message=f"the plan has no axis {name}",
            file=file,
            place=f"--option {ADDRESS}{name}",
            expected=", ".join(plan.every_axis),
            hint="use one of these axes",
        )
        for name in addresses
        if name not in plan.every_axis
    ]


def _state(
    session: Session,
    plan: Plan,
    control: Control,
    axes: Sequence[Axis],
    states: Sequence[str],
    file: str,
    *,
    active: bool | None,
) -> DecodedState:
    """Return the existing compensation in the control for the given ``axes``: none, that of the
    control files ``states``, or, without ``states``, that in the plan ``file``. ``active``: whether
    the tables are active, None if not stated.
    """
    if list(states) == ["none"]:
        return decode(control, (), axes)
    if "none" in states:
        raise UsageError(
            Fault(
                message="`--state` contains both files and the word none",
                place="--state",
                expected="the word none, or the control's files",
                hint="give `--state none`, or `--state` with the control's files",
            )
        )
    if states:
        return decode(
            control,
            read_control(session, control, [Path(text) for text in states]),
            axes,
            active=active,
            asking=True,
        )
    if plan.format == control.id and AS_FOUND in plan.states:
        files: tuple[ControlFile, ...] = plan.states[AS_FOUND]
        return decode(control, files, axes, active=plan.active.get(AS_FOUND))
    raise UsageError(
        Fault(
            message="the control's existing compensation is not given",
            file=file,
            place="--state",
            expected="--state none, or --state with each file of the control",
            found=f"a plan made for {plan.format}",
            hint="give `--state none`, or `--state` with each file of the control",
        )
    )
