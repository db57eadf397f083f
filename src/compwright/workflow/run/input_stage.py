"""First stage of a run: open the control, and read and check every file of the job."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from compwright.controls.control import Control, open_control, origin_of
from compwright.controls.control_files import read_control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.job_completion import (
    completed_by_files,
    keys_with_effect,
    named_axes,
    unknown_zeros,
    with_counted_turns,
)
from compwright.controls.judged_corrections import active_corrections
from compwright.evaluation.duplicate_measurements import NamedTest
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.session import Session
from compwright.jobs.idle_keys import idle_keys
from compwright.prediction.active_corrections import ActiveCorrections
from compwright.records.axis import Axis
from compwright.records.circular import CircularTest
from compwright.records.correction import Assumption, ControlState
from compwright.records.job import AS_FOUND, Job
from compwright.workflow.inputs.circles import read_circles
from compwright.workflow.inputs.job_inputs import JobInputs, read_job_inputs
from compwright.workflow.inputs.own_output import refuse_own_output
from compwright.workflow.inputs.plausibility import given_twice, impossible_tests, named_tests


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """The contents of a job's files, and the job with the axis names of the control.

    ``active``: the active corrections of each state, by the name of the state. ``named``:
    assumptions about names of axes. ``findings``: about the reader by which the control's files
    were read, and about keys of the job without effect.
    """

    job: Job
    control: Control
    inputs: JobInputs
    circles: tuple[CircularTest, ...]
    active: Mapping[str, ActiveCorrections]
    named: tuple[Assumption, ...]
    findings: tuple[Finding, ...]

    @property
    def axes(self) -> dict[str, Axis]:
        """Every axis of the job by its name."""
        return {name: entry.axis for name, entry in self.job.axes.items()}

    @property
    def as_found(self) -> DecodedState | None:
        """The present contents of the control, or None if they are unknown."""
        return self.inputs.states.get(AS_FOUND)

    @property
    def states(self) -> dict[str, ControlState]:
        """The contents of each state, by its name."""
        return {name: decoded.state for name, decoded in self.inputs.states.items()}


def measured(session: Session, job: Job, folder: Path, out: Path) -> Measured:
    """Open the control of a job, and read all its files, relative to ``folder``.

    Raises UsageError and InputError for a file that cannot be read or contradicts itself, for a
    measurement that cannot be of this machine, and for tables that an earlier run made from the
    same tests.
    """
    control = open_control(session, job.format, job.options, origin_of(job, folder))
    own = [storage.named_from(folder, path) for path in job.states.get(AS_FOUND, ())]
    job, named = named_axes(
        job,
        control,
        lambda: control.format.listing.names(control.format, read_control(session, control, own)),
    )
    idle = idle_keys(job, **keys_with_effect(control.definition))
    inputs, circles = _inputs(session, job, control, folder)
    job = completed_by_files(job, inputs.states, AS_FOUND)
    job, turns = with_counted_turns(job, control, inputs.tests)
    now = inputs.states.get(AS_FOUND)
    raise_all(UsageError, list(unknown_zeros(job, control, None if now is None else now.state)))
    axes = {name: entry.axis for name, entry in job.axes.items()}
    taken_in = [
        (test, request.measured_in) for test, request in zip(circles, job.circles, strict=True)
    ]
    refuse_own_output(session, job, inputs, taken_in, folder, out)
    return Measured(
        job=job,
        control=control,
        inputs=inputs,
        circles=circles,
        active={name: active_corrections(decoded, axes) for name, decoded in inputs.states.items()},
        named=(*named, *turns),
        findings=(*control.findings, *idle),
    )


def _inputs(
    session: Session, job: Job, control: Control, folder: Path
) -> tuple[JobInputs, tuple[CircularTest, ...]]:
    """Read the files of a job. Raises InputError with all faults."""
    tests: tuple[CircularTest, ...] = ()
    faults: tuple[Fault, ...] = ()
    try:
        tests = read_circles(session, job, folder)
    except InputError as error:
        faults = error.faults
    try:
        inputs = read_job_inputs(session, job, control, folder)
    except InputError as error:
        raise InputError(*error.faults, *faults) from error
    raise_all(InputError, list(faults))
    circles = [NamedTest(f"circle {test.name}", test.sources) for test in tests]
    raise_all(
        InputError,
        [
            *impossible_tests(job, inputs.tests),
            *given_twice([*named_tests(inputs.tests), *circles]),
        ],
    )
    return inputs, tests
