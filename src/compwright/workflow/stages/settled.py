"""What a job leaves to its control: names of axes, and what the control's own files answer."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from compwright.formats.definition.options import (
    DETECTION_UNIT,
    TABLE_VALUES,
)
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, ControlState
from compwright.records.job import AxisJob, Job
from compwright.workflow.stages.control import Control
from compwright.workflow.stages.decoded import DecodedState


def named_axes(
    job: Job, control: Control, by_name: Callable[[], Mapping[str, tuple[str, str]]]
) -> tuple[Job, tuple[Assumption, ...]]:
    """Return the job with control and axes named as the control names them, and what had to be
    assumed for that.

    ``by_name``: the addresses that the control's own files give to names of axes, and what says so;
    asked only where a job's address is none that the control can have. Raises UsageError for such
    an address that they do not tell, and for two axes at one address.
    """
    axes: dict[str, AxisJob] = {}
    assumed: list[Assumption] = []
    faults: list[Fault] = []
    for name, entry in job.axes.items():
        try:
            address, assumption = _address(control, entry.axis, by_name)
            gantry = (
                None
                if entry.axis.gantry is None
                else normal_text(control.definition, entry.axis.gantry)
            )
        except UsageError as error:
            faults.extend(
                fault.within(f"axes.{name}.address").in_file(job.file) for fault in error.faults
            )
            continue
        taken = next((other for other, mine in axes.items() if mine.axis.address == address), None)
        if taken is not None:
            faults.append(
                Fault(
                    message=f"axes {taken} and {name} have one address",
                    file=job.file,
                    place=f"axes.{name}",
                    found=address,
                )
            )
        assumed.extend([assumption] if assumption else [])
        axes[name] = replace(entry, axis=replace(entry.axis, address=address, gantry=gantry))
    raise_all(UsageError, faults)
    return replace(job, format=control.id, axes=axes), tuple(assumed)


def _address(
    control: Control, axis: Axis, by_name: Callable[[], Mapping[str, tuple[str, str]]]
) -> tuple[str, Assumption | None]:
    try:
        return normal_address(control.definition, axis)
    except UsageError:
        said = by_name().get(axis.address.strip().upper())
        if said is None:
            raise
        address, evidence = said
        return address, Assumption(f"address of axis {axis.name}", address, evidence)


def settled_by_files(job: Job, states: Mapping[str, DecodedState], as_found: str) -> Job:
    """Return the job with what it leaves to the control's own files: detection units, what tables
    mean, measuring systems.

    ``states``: all that were read; ``as_found``: the name of the one that is in the control now.
    """
    read = [decoded.state for decoded in states.values()]
    axes = {
        name: replace(entry, axis=settled_axis(entry.axis, read, job.options))
        for name, entry in job.axes.items()
    }
    job = replace(job, axes=axes)
    return _with_systems_in_use(job, states[as_found].state) if as_found in states else job


def settled_axis(axis: Axis, states: Sequence[ControlState], given: Mapping[str, object]) -> Axis:
    """Return an axis with the options that nobody gave (``given``: the controller's) and that the
    control's own files say of it.
    """
    options = dict(axis.options)
    for name in (DETECTION_UNIT, TABLE_VALUES):
        said = [state.facts_of(axis.address).said.get(name) for state in states]
        found = next((one for one in said if one is not None), None)
        if found is not None and given.get(name) is None:
            options.setdefault(name, found)
    leads = (state.facts_of(axis.address).lead for state in states)
    suggested = next((lead for lead in leads if lead is not None), None)
    return replace(axis, options=options, suggested_period=suggested)


def _with_systems_in_use(job: Job, state: ControlState) -> Job:
    """Return the job with the measuring system that the control's files show to be in use, where
    the job names none.
    """
    axes = {}
    for name, entry in job.axes.items():
        found = state.facts_of(entry.axis.address).encoder_system
        if entry.axis.encoder.stated or found is None:
            axes[name] = entry
        else:
            axes[name] = replace(
                entry,
                axis=replace(
                    entry.axis, encoder=replace(entry.axis.encoder, system=found, stated=True)
                ),
            )
    return replace(job, axes=axes)
