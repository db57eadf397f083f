"""Read a job file as a `Job`. All faults are reported at once."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.findings import Finding
from compwright.foundations.key_faults import KeyFault, shown
from compwright.foundations.units import TO_INSIDE
from compwright.foundations.validation import key_faults
from compwright.foundations.yaml_reader import YamlDocument, read_yaml_with_faults
from compwright.jobs.consistency import NONE_WORD, contradictions, unusable
from compwright.jobs.plain_data import default_name
from compwright.jobs.schema import (
    SCHEMA_VERSION,
    AxisSection,
    CircleSection,
    CrossSection,
    DriftSection,
    EnvironmentSection,
    InstrumentAirSection,
    JobSection,
    OwnThermalSection,
    PositionMapSection,
    TestSection,
    known_keys,
)
from compwright.records.axis import Axis, AxisKind, Direction, Encoder, PositionMap
from compwright.records.conditions import CircularBudget, Thermal, UncertaintyBudget
from compwright.records.drift import DriftRequest
from compwright.records.environment import EnvironmentRequest, InstrumentAir
from compwright.records.fitted_table import TableRequest
from compwright.records.job import (
    AS_FOUND,
    NONE_STATE,
    Acceptance,
    Acknowledgement,
    ApplyRequest,
    AxisJob,
    CircleRequest,
    CrossRequest,
    Job,
    ReportHead,
    TestRequest,
    other_axis,
)

#: What is expected under a key that is missing.
_MISSING = {
    "compwright": "the version of the schema, such as 1",
    "controller": "the format of the control, such as {format: ID}",
    "format": "an id of `compwright formats list`",
    "axes": "at least one axis, such as {X: {travel: [0, 800], before: [x.csv]}}",
    "travel": "its ends in machine coordinates, mm or deg, such as [0, 800]",
    "before": "the measurement files, such as [x.csv]",
    "files": "the measurement files, such as [x.csv]",
}


@dataclass(frozen=True, slots=True)
class CheckedJob:
    """The result of `check`: the validated job, or its faults."""

    section: JobSection | None
    faults: tuple[Fault, ...]


#: What else a job must keep to, from its plain data: the rooms that know the controls say what of
#: it does not exist.
Further = Callable[[Mapping[str, Any]], Iterable[KeyFault]]


def _nothing_further(_data: Mapping[str, Any]) -> Iterable[KeyFault]:
    return ()


def read_job(content: bytes, file: str, further: Further = _nothing_further) -> Job:
    """Return the job in a job file, with its paths as written. ``further``: a function that makes
    additional checks of the job's data.

    ``file``: the name of the job file in messages. Raises UsageError with every fault at once; each
    has file, ``line N, key.path``, expected and found. Faults: the text is not YAML, a key is given
    twice or unknown (with the nearest known key), a value has a wrong type or range, a name does
    not exist. If the job was written for a newer version of compwright, this is the only fault.
    """
    try:
        document, faults = read_yaml_with_faults(content, file)
    except InputError as error:
        raise UsageError(*error.faults) from error
    _refuse_other_versions(document, file)
    checked = check(document, file, further)
    spoken_for = {fault.place for fault in faults}
    faults += tuple(fault for fault in checked.faults if fault.place not in spoken_for)
    if faults or checked.section is None:
        raise UsageError(*sorted(faults, key=lambda fault: _line(fault.place)))
    return job_of(checked.section, file)


def check(document: YamlDocument, file: str, further: Further = _nothing_further) -> CheckedJob:
    """Check a job by the schema, for contradictions, and by the function ``further``; return the
    validated job, or its faults.
    """
    data = document.data
    if not isinstance(data, dict):
        return CheckedJob(
            None,
            (
                Fault(
                    message="the file is not a job",
                    file=file,
                    expected="keys and values",
                    found=shown(data),
                    hint=(
                        "make a job file with `compwright new --from FILE --format ID "
                        "--out JOB.yaml`"
                    ),
                ),
            ),
        )
    section: JobSection | None = None
    faults = list(unusable(data))
    try:
        section = JobSection.model_validate(data)
    except ValidationError as error:
        without_use = {fault.path for fault in faults}
        faults += [
            fault
            for fault in key_faults(error, data, known_keys, _MISSING, JobSection.model_validate)
            if fault.path not in without_use
        ]
    faults += (*contradictions(data), *further(data))
    return CheckedJob(section, tuple(fault.in_file(file, document.place) for fault in faults))


def _line(place: str) -> int:
    found = re.match(r"line (\d+)", place)
    return int(found[1]) if found else 0


def _refuse_other_versions(document: YamlDocument, file: str) -> None:
    """Raise UsageError for a job file of a newer version before any unknown key is reported."""
    version = document.data.get("compwright") if isinstance(document.data, dict) else None
    if version == SCHEMA_VERSION or not isinstance(version, int) or isinstance(version, bool):
        return
    raise UsageError(
        Fault(
            message=(
                "the job is written for a newer version of compwright"
                if version > SCHEMA_VERSION
                else "the job states a version that does not exist"
            ),
            file=file,
            place=document.place(("compwright",)),
            expected=f"compwright: {SCHEMA_VERSION}",
            found=shown(version),
            hint=("make the job again with `compwright new`, or correct the line `compwright:`"),
        )
    )


def job_of(section: JobSection, file: str) -> Job:
    """Return the job record for a validated job file."""
    findings = (
        *_idle_findings(section),
        *_absent_axes(section),
        *_state_findings(section),
    )
    return Job(
        file=file,
        format=section.controller.format,
        axes={name: _axis_job(name, axis, section.thermal) for name, axis in section.axes.items()},
        options=section.controller.options,
        states={name: _state(state.files) for name, state in section.states.items()},
        active={
            name: state.active for name, state in section.states.items() if state.active is not None
        },
        machine=section.machine.model_dump(exclude_none=True),
        fixed_positions=section.fixed_positions,
        uncertainty=_budget(section),
        uncertainty_rotary=_rotary_budget(section),
        uncertainty_circular=_circular_budget(section),
        drifts=_drifts(section),
        environment=_environment(section.environment),
        thermal=_thermal(section.thermal),
        decision_rule=section.decision_rule,
        proven=tuple(proof.model_dump() for proof in section.proven),
        standard=section.standard,
        report=ReportHead(**section.report.model_dump()),
        circles=tuple(_circle(circle) for circle in section.circles),
        cross=tuple(_cross(entry) for entry in section.cross),
        apply=(
            ApplyRequest(
                squareness=section.apply.squareness,
                scale=tuple(section.apply.scale),
                backlash_from=section.apply.backlash_from,
            )
            if section.apply
            else ApplyRequest()
        ),
        acknowledged=tuple(
            Acknowledgement(code=code, reason=entry.reason, axis=entry.axis)
            for code, entries in section.acknowledged.items()
            for entry in entries
        ),
        findings=findings,
    )


def _state(files: list[str]) -> tuple[str, ...]:
    return NONE_STATE if files == [NONE_WORD] else tuple(files)


def _axis_job(name: str, section: AxisSection, of_job: OwnThermalSection | None) -> AxisJob:
    low, high = section.travel
    thermal = (of_job, section.thermal) if section.kind == "linear" else ()
    alone = section.gantry is not None and section.gantry.axis == NONE_WORD
    axis = Axis(
        name=name,
        kind=AxisKind(section.kind),
        travel=(float(low), float(high)),
        address=section.address or name,
        modulo=section.modulo if section.kind == "rotary" else None,
        axis_number=section.axis_number,
        gantry=None if alone or section.gantry is None else section.gantry.axis,
        gantry_table=None if alone or section.gantry is None else section.gantry.table,
        moves_alone=alone,
        reference=section.reference or 0.0,
        reference_return=Direction(section.reference_return or "+"),
        encoder=Encoder(
            type=section.encoder.type,
            system=int(section.encoder.system or 1),
            stated=section.encoder.system is not None,
        ),
        programmed=section.programmed,
        screw_pitch=tuple(section.screw_pitch or ()),
        motion=section.before[0].motion if section.before else "feed",
        options=section.options,
    )
    return AxisJob(
        axis=axis,
        before=tuple(_test(test, section.position_map, thermal) for test in section.before),
        table=TableRequest(**section.table.model_dump()),
        accept=_acceptance(section.accept),
        thermal=_thermal(*thermal),
        stated=frozenset(
            name for name in ("reference", "reference_return") if getattr(section, name) is not None
        ),
    )


def _test(
    section: TestSection,
    of_axis: PositionMapSection,
    thermal: tuple[OwnThermalSection | None, ...],
) -> TestRequest:
    position_map = section.position_map or of_axis
    return TestRequest(
        files=tuple(section.files),
        name=section.name or default_name(section.files[0]),
        measured_in=section.measured_in,
        position_map=PositionMap(
            sense=1 if position_map.sense == 1 else -1, offset=position_map.offset
        ),
        motion=section.motion,
        thermal=_thermal(*thermal, section.thermal),
        own_temperatures=tuple(
            name
            for name in ("T_m", "T_d")
            if section.thermal and getattr(section.thermal, name) is not None
        ),
        profile=section.profile,
    )


def _thermal(*sections: OwnThermalSection | None) -> Thermal | None:
    """Return the differential expansion from ``sections``; keys of later sections override those of
    earlier sections.
    """
    keys: dict[str, Any] = {}
    for section in sections:
        keys |= section.model_dump(exclude_none=True) if section else {}
    for name, rise in (("T_m", "rise_m"), ("T_d", "rise_d")):
        if name in keys:
            start, end = keys[name][0], keys[name][-1]
            keys |= {name: 0.5 * (start + end), rise: end - start}
    # the temperature that no key states comes from the record of the environment
    return Thermal(**{"T_m": math.nan, **keys}) if keys else None


def _environment(section: EnvironmentSection | None) -> EnvironmentRequest | None:
    if section is None:
        return None
    air = section.instrument_air
    counted = None if air == "vacuum" else InstrumentAir()
    if isinstance(air, InstrumentAirSection):
        counted = InstrumentAir(**air.model_dump(), stated=True)
    return EnvironmentRequest(
        files=tuple(section.files), equation=section.equation, instrument_air=counted
    )


def _circle(section: CircleSection) -> CircleRequest:
    files = tuple(file for file in (section.file, section.ccw, section.cw) if file is not None)
    return CircleRequest(
        files=files,
        name=section.name or default_name(files[0]),
        measured_in=section.measured_in,
        centre=tuple(section.centre) if section.centre is not None else None,
        accept=_acceptance(section.accept),
    )


def _cross(section: CrossSection) -> CrossRequest:
    factor = TO_INSIDE[section.unit][1]
    pairs = sorted(zip(section.positions, section.deviations, strict=True))
    return CrossRequest(
        input=section.input,
        output=section.output,
        positions=tuple(float(position) for position, _ in pairs),
        deviations=tuple(deviation * factor for _, deviation in pairs),
        measured_in=section.measured_in,
    )


def _acceptance(accept: Mapping[str, Any] | None) -> Acceptance | None:
    if accept is None:
        return None
    limits = {name: float(limit) for name, limit in accept.items() if name != "test"}
    return Acceptance(limits=limits, test=str(accept["test"]) if "test" in accept else None)


def _budget(section: JobSection) -> UncertaintyBudget | None:
    given = section.uncertainty
    if given is None:
        return None
    contributors = given.model_dump(exclude={"device", "E_VE", "rotary", "circular"})
    return UncertaintyBudget(
        device=given.device.U,
        device_per_m=given.device.per_m,
        E_VE=_range(given.E_VE),
        **contributors,
    )


def _rotary_budget(section: JobSection) -> UncertaintyBudget | None:
    rotary = section.uncertainty.rotary if section.uncertainty else None
    if rotary is None:
        return None
    return UncertaintyBudget(device=rotary.U, setup=rotary.setup, E_VE=_range(rotary.E_VE))


def _circular_budget(section: JobSection) -> CircularBudget | None:
    """Return the contributors to the uncertainty of circular tests that the job states."""
    given = section.uncertainty
    if given is None or given.circular is None:
        return None
    return CircularBudget(
        U_theta=given.U_theta, U_alpha=given.U_alpha, **given.circular.model_dump()
    )


def _range(variation: float | DriftSection) -> float:
    """Return the environmental variation that the job states; 0 if it states a stand-still test,
    which is evaluated later.
    """
    return 0.0 if isinstance(variation, DriftSection) else variation


def _drifts(section: JobSection) -> dict[AxisKind, DriftRequest]:
    of_kind: dict[AxisKind, float | DriftSection] = {}
    if section.uncertainty is not None:
        of_kind[AxisKind.LINEAR] = section.uncertainty.E_VE
        if section.uncertainty.rotary is not None:
            of_kind[AxisKind.ROTARY] = section.uncertainty.rotary.E_VE
    return {
        kind: DriftRequest(file=given.file, duration_min=given.duration_min)
        for kind, given in of_kind.items()
        if isinstance(given, DriftSection)
    }


def _absent_axes(section: JobSection) -> list[Finding]:
    """Return a finding for each requested correction whose axis the job does not contain."""
    requested: list[tuple[str, tuple[str, ...]]] = [
        (f"cross[{index}]", (entry.input, entry.output))
        for index, entry in enumerate(section.cross)
    ]
    if section.apply is not None:
        requested += [("apply.scale", (name,)) for name in section.apply.scale]
        requested += [
            (f"apply.squareness.{plane}", (bent, other_axis(plane, bent)))
            for plane, bent in section.apply.squareness.items()
        ]
    return [
        Finding.of("CW-J004", "error", place=place, axis=name)
        for place, names in requested
        for name in names
        if name not in section.axes
    ]


def _idle_findings(section: JobSection) -> list[Finding]:
    return [
        Finding.of("CW-J003", "warning", axis=name)
        for name, axis in section.axes.items()
        if axis.modulo is not None and axis.kind == "linear"
    ]


def _state_findings(section: JobSection) -> list[Finding]:
    if not section.states or AS_FOUND in section.states:
        return []
    return [Finding.of("CW-J002", "warning", states=", ".join(section.states))]
