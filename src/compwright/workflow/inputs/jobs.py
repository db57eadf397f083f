"""Read the job from a job file or from the command line."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from compwright.controls.control import Control, Origin, open_control
from compwright.controls.definitions import is_path
from compwright.documents.plan import carried_definition
from compwright.documents.record import RECORD, copied_by_record
from compwright.evaluation.environmental_variation import environmental_variation
from compwright.foundations import storage
from compwright.foundations.errors import (
    CompwrightError,
    Fault,
    InputError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.input_sizes import JOB, MEASUREMENT
from compwright.foundations.key_faults import KeyFault
from compwright.foundations.session import Session
from compwright.instruments.drift_csv import read_drift
from compwright.instruments.environment_csv import joined, read_environment
from compwright.jobs.command_line import job_from_options, whole_travel
from compwright.jobs.consistency import NONE_WORD
from compwright.jobs.reading import read_job
from compwright.records.axis import Axis, AxisKind
from compwright.records.environment import AIR, MATERIAL, Environment
from compwright.records.job import Job
from compwright.records.options import KIND, REFERENCE, REFERENCE_RETURN
from compwright.records.plan import Texts
from compwright.workflow.inputs.logo import read_logo

_YAML = {".yaml", ".yml"}
PLAN = "plan.json"
#: What to add for a missing option.
_TO_ADD = {
    "--format": "`--format ID`, the control of the tables; `compwright formats list` shows the ids",
    "--axis": "`--axis X` with the name of the measured axis",
    "--travel": "`--travel 0:800` with the two ends of the axis' travel",
    "--state": "what is active in the control now: `--state none` (no compensation), or `--state"
    " FILE` with the files exported from the control",
}
#: Stands for a travel that is missing, so that everything else is asked for too.
_ANY_TRAVEL = "0:1"


def read_job_file(session: Session, path: Path, plan: Path | None = None) -> Job:
    """Read a job file, with the stand-still tests, environment record and logo that it names.
    ``plan``: the plan of an earlier run, whose copy of the user's own control definition is used.

    Raises InputError if one of these files cannot be read. Raises UsageError with every fault of
    the job.
    """
    carried = () if plan is None else carried_definition(storage.earlier_bytes(session, plan))
    further = partial(wrong_control, session, folder=path.parent, carried=carried)
    job = read_job(storage.read_bytes(session, path, JOB), str(path), further)
    errors: list[CompwrightError] = []
    for read in (_with_drifts, _with_environment, _with_logo):
        try:
            job = read(session, job, path.parent)
        except InputError as error:
            errors.append(error)
    raise_all(InputError, collect(errors))
    return job


def _with_logo(session: Session, job: Job, folder: Path) -> Job:
    """Return the job with the logo that it names."""
    if job.report.logo is None:
        return job
    image = read_logo(session, job.report.logo, folder)
    return replace(job, report=replace(job.report, image=image))


def _with_drifts(session: Session, job: Job, folder: Path) -> Job:
    """Return the job with the environmental variation error E_VE, evaluated from the stand-still
    tests that the job names.
    """
    errors: list[CompwrightError] = []
    for kind, request in job.drifts.items():
        file = storage.named_from(folder, request.file)
        try:
            drift = read_drift(storage.read_bytes(session, file, MEASUREMENT), request.file, kind)
        except InputError as error:
            errors.append(error)
            continue
        E_VE, findings = environmental_variation(drift, request.duration_min)
        job = job.with_variation(kind, E_VE)
        job = replace(
            job, findings=(*job.findings, *findings), sources=(*job.sources, drift.source)
        )
    raise_all(InputError, collect(errors))
    return job


def _with_environment(session: Session, job: Job, folder: Path) -> Job:
    """Return the job with its tests corrected by the environment record that it names."""
    request = job.environment
    if request is None:
        return job
    errors: list[CompwrightError] = []
    records = []
    for text in request.files:
        file = storage.named_from(folder, text)
        try:
            records.append(read_environment(storage.read_bytes(session, file, MEASUREMENT), text))
        except InputError as error:
            errors.append(error)
    raise_all(InputError, collect(errors))
    record = joined(records)
    material = record.values.get(MATERIAL)
    job = job.with_environment(
        Environment(
            record=record, equation=request.equation, instrument_air=request.instrument_air
        ),
        None if material is None else float(material.mean()),
    )
    every = [test.thermal for entry in job.axes.values() for test in entry.before]
    every += [job.thermal] if job.circles else []
    if not record.has_air and not any(every):
        raise InputError(
            Fault(
                message="the environment record contains only the temperature of the material, "
                "but the job has no key `thermal`, so nothing would be removed from "
                "the readings",
                file=", ".join(request.files),
                place="environment",
                hint="add `thermal: {alpha_m: 11.5}` with the coefficient of the scale to the job, "
                f"or the columns {', '.join(AIR)} to the environment record",
            )
        )
    if any(thermal is not None and math.isnan(thermal.T_m) for thermal in every):
        fault = Fault(
            message="the environment record has no column material_c, and the job does not "
            "state the temperature T_m of the material",
            file=", ".join(request.files),
            place="environment",
            expected="a column material_c, or T_m under thermal",
            hint="add `T_m` under `thermal` of the job, or a column `material_c` to the record",
        )
        raise InputError(fault)
    return replace(job, sources=(*job.sources, *record.sources))


def wrong_control(
    session: Session, data: Mapping[str, Any], *, folder: Path = Path(), carried: Texts = ()
) -> Iterator[KeyFault]:
    """Yield the faults of the control's id and of its options in the data of a job file.
    ``carried``: the texts of the control definition that is copied into a plan, if any.

    ``folder``: the folder to which the path of a definition is relative.
    """
    controller = data.get("controller")
    format_id = controller.get("format") if isinstance(controller, dict) else None
    options = controller.get("options", {}) if isinstance(controller, dict) else {}
    if not isinstance(format_id, str) or not isinstance(options, dict):
        return  # the schema says so
    try:
        control = open_control(session, format_id, options, Origin("", "", "", folder, carried))
    except UsageError as error:
        for fault in error.faults:
            if fault.file:  # a definition of one's own: its faults have places of their own
                yield KeyFault(("controller", "format"), str(fault))
                continue
            path = ("options", fault.place) if fault.place else ("format",)
            yield KeyFault(
                ("controller", *path), fault.message, fault.expected, fault.found, fault.hint
            )
        return
    states = data.get("states")
    given = list(states.values()) if isinstance(states, dict) else []
    files = any(state and state not in (NONE_WORD, [NONE_WORD]) for state in given)
    yield from _wrong_axis_options(data.get("axes"), control, unit_needed=not files)
    yield from _questions(data.get("axes"), control, files=files, stated=bool(given))
    yield from _unknown_diameter(data.get("axes"), control, files=files)
    for name in (REFERENCE, REFERENCE_RETURN, KIND):
        if name in options:
            yield KeyFault(
                ("controller", "options", name),
                "belongs to an axis",
                f"axes.NAME.{name}",
                "a controller's option",
            )


def _unknown_diameter(axes: object, control: Control, *, files: bool) -> Iterator[KeyFault]:
    """Yield a fault for each axis with diameter programming if it is unknown whether the control's
    tables count in radius or in diameter.

    All lengths in a job are radii, as the machine moves. If the control's files state how the axis
    is programmed, the job is checked against them. Without files (``files`` False) this check is
    impossible.
    """
    definition = control.definition
    if definition.diameter.tables == "radius" or (files and "diameter" in definition.bindings):
        return
    for name, section in axes.items() if isinstance(axes, dict) else ():
        if (
            isinstance(section, dict)
            and section.get("programmed") == "diameter"
            and section.get("kind", "linear") == "linear"
        ):
            yield KeyFault(
                ("axes", str(name), "programmed"),
                f"whether a table of {control.id} counts an axis in diameter programming in radius"
                " or in diameter is not confirmed",
                "radius, once a single point entered by hand has shown that the table moves the"
                " axis by its own value",
                "diameter",
            )


def _questions(axes: object, control: Control, *, files: bool, stated: bool) -> Iterator[KeyFault]:
    """Yield a fault for each value that the control needs for an axis and the job lacks.
    ``stated``: whether the job states the present contents of the control, so that tables are made.
    """
    sections = axes if isinstance(axes, dict) else {}
    given = {
        option
        for section in sections.values()
        if isinstance(section, dict) and isinstance(section.get("options"), dict)
        for option, value in section["options"].items()
        if value is not None
    }
    for name, section in sections.items():
        if not isinstance(section, dict):
            continue  # the schema says so
        reference, options = section.get("reference", 0), section.get("options", {})
        axis = Axis(
            name=str(name),
            kind=AxisKind.LINEAR,
            travel=(0.0, 1.0),
            address=str(section.get("address", name)),
            reference=float(reference) if isinstance(reference, int | float) else 0.0,
            options=options if isinstance(options, dict) else {},
        )
        found = list(control.format.questions(axis, files=files, given=given))
        # without a state no table is made; what stops the run anyway asks for the rest too
        for fault in found if stated or any(one.place == "address" for one in found) else ():
            own = ("axes", str(name)) if fault.place == "address" else ("controller", "options")
            yield KeyFault(
                (*own, fault.place), fault.message, fault.expected, fault.found, fault.hint
            )


def _wrong_axis_options(axes: object, control: Control, *, unit_needed: bool) -> Iterator[KeyFault]:
    for name, section in axes.items() if isinstance(axes, dict) else ():
        options = section.get("options", {}) if isinstance(section, dict) else {}
        if not isinstance(options, dict):
            continue  # the schema says so
        axis = Axis(name="", kind=AxisKind.LINEAR, travel=(0.0, 1.0), address="", options=options)
        try:
            control.format.options_of(axis, unit_needed=unit_needed)
        except UsageError as error:
            for fault in error.faults:
                place = fault.place.rpartition(" ")[2]
                own = ("axes", str(name)) if place in options else ("controller",)
                yield KeyFault(
                    (*own, "options", place), fault.message, fault.expected, fault.found, fault.hint
                )


def default_folder(session: Session, job_file: Path) -> Path:
    """Return the default result folder of a job: next to the job file, with the same stem.

    If the job is inside the results of its own run, such as the job of a next round or the copy of
    a job, the folder of these results is used.
    """
    own = (
        job_file.with_suffix("")
        if job_file.suffix
        else job_file.with_name(f"{job_file.name}-results")
    )
    above = job_file.parent.parent
    copies = copied_by_record(storage.earlier_bytes(session, above / RECORD))
    if f"{job_file.parent.name}/{job_file.name}" in copies and not storage.is_folder(own):
        return above
    among = any(storage.is_there(session, job_file.parent / name) for name in (PLAN, RECORD))
    return job_file.parent if among and not storage.is_folder(own) else own


@dataclass(frozen=True, slots=True)
class JobToRun:
    """A job, the folder of its relative paths, and the folder of its results.

    ``stated``: the values of the command line, for a run without a job file, in the form of a job.
    """

    job: Job
    folder: Path
    out: Path
    stated: Mapping[str, Any] | None = None


def job_of(
    session: Session,
    inputs: Sequence[str],
    *,
    format_id: str | None,
    axis: str | None,
    travel: str | None,
    states: Sequence[str],
    options: Sequence[str],
    profile: str | None = None,
    out: Path | None = None,
) -> JobToRun:
    """Return the job of a run. ``out``: the folder of its results, if one was named.

    A single input without ``--format`` is a job file. All other inputs are measurement files of one
    test, and the job's relative paths then start at the folder of its results. Raises UsageError
    with all faults.
    """
    first = Path(inputs[0])
    needed = {"--format": format_id, "--axis": axis, "--travel": travel}
    if len(inputs) == 1 and first.suffix.lower() in _YAML:
        storage.read_bytes(session, first, JOB)
        extra = {**needed, "--state": states, "--option": options, "--profile": profile}
        faults = [
            Fault(
                message=f"the option {name} is not allowed together with a job file",
                file=str(first),
                place=name,
                hint=f"leave {name} out, and set it in the job file",
            )
            for name, value in extra.items()
            if value
        ]
        raise_all(UsageError, faults)
        return JobToRun(
            read_job_file(session, first), first.parent, out or default_folder(session, first)
        )
    if travel and ":" not in travel:  # two values with a blank: the second one is among the files
        raise UsageError(whole_travel(travel))
    for text in inputs:
        if not storage.is_folder(Path(text)):
            storage.read_bytes(session, Path(text), MEASUREMENT)
        elif storage.is_there(session, Path(text) / PLAN):
            fault = Fault(
                message="this is a folder of results, not a measurement",
                file=text,
                hint=f"give {JOB.help}",
            )
            raise UsageError(fault)
    missing = [name for name in _TO_ADD if not {**needed, "--state": states}[name]]
    faults = [
        Fault(
            message=f"the option {name} is missing",
            place=name,
            hint=f"add {_TO_ADD[name]}; or give one job file",
        )
        for name in missing
        if missing != ["--state"]  # without it alone everything but the tables is made
    ]
    folder = out or default_folder(session, first)

    def there(text: str) -> str:
        return storage.way_to(Path(text), folder)

    control = format_id or ""
    if faults and not (format_id and axis):
        raise UsageError(*faults)  # what the control needs of the axis cannot be asked yet
    try:
        stated = job_from_options(
            [there(text) for text in inputs],
            format=there(control) if is_path(control) else control,
            axis=axis or "",
            travel=travel or _ANY_TRAVEL,
            states=[text if text == NONE_WORD else there(text) for text in states],
            options=options,
            profile=None if profile is None else there(profile),
            further=partial(wrong_control, session, folder=folder),
        )
    except UsageError as error:
        raise UsageError(*faults, *error.faults) from error
    raise_all(UsageError, faults)
    return JobToRun(stated.job, folder, folder, stated.data)
