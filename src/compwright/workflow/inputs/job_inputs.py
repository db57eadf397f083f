"""Read the files of a job: tests and states. All faults are collected."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from compwright.controls.control import Control, decode
from compwright.controls.control_files import read_control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.gantries import partner_questions
from compwright.controls.job_completion import length_unit, other_joints
from compwright.evaluation.environment_reduction import reduce_by_record
from compwright.evaluation.expansion import remove_differential_expansion
from compwright.evaluation.temperatures import temperatures_of, with_temperatures
from compwright.foundations import storage
from compwright.foundations.errors import (
    CompwrightError,
    Fault,
    InputError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.input_sizes import MEASUREMENT
from compwright.foundations.session import Session
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.foundations.utf8 import shown_path
from compwright.instruments.plausibility import skipped_finding
from compwright.instruments.profile import Profile
from compwright.instruments.reading import read_tests
from compwright.instruments.reading_findings import sheets_finding
from compwright.planning.motions import unknown_motions
from compwright.records.axis import Axis, AxisKind, PositionMap
from compwright.records.job import AS_FOUND, AxisJob, Job, TestRequest
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest, merge, to_machine
from compwright.words.sentences import say
from compwright.workflow.inputs.measurement_files import load_profile, measurement_files

#: A table over the travel, read in the wrong unit, is 25.4 times too short or long; it may reach
#: over 0.8 of the travel only.
_SAME_RANGE = 1.25


@dataclass(frozen=True, slots=True)
class JobInputs:
    """The contents of a job's files: tests by axis name, and states of the control by name."""

    tests: Mapping[str, tuple[PlannedTest, ...]]
    states: Mapping[str, DecodedState]


def read_job_inputs(session: Session, job: Job, control: Control, folder: Path) -> JobInputs:
    """Read every file that a job names. Raises InputError with all faults."""
    errors: list[CompwrightError] = []
    tests: dict[str, tuple[PlannedTest, ...]] = {}
    for name, entry in job.axes.items():
        found = []
        for request in entry.before:
            try:
                found.append(
                    PlannedTest(
                        test=read_test(session, entry, request, folder),
                        measured_in=request.measured_in,
                        motion=request.motion,
                    )
                )
            except InputError as error:
                errors.append(error)
        tests[name] = tuple(found)
    unanswered: list[Fault] = []
    states: dict[str, DecodedState] = {}
    axes = [entry.axis for entry in job.axes.values()]
    for name, paths in job.states.items():
        try:
            files = read_control(
                session, control, [storage.named_from(folder, path) for path in paths]
            )
            states[name] = decode(control, files, axes, active=job.active.get(name), asking=True)
        except InputError as error:
            errors.append(error)
        except UsageError as error:
            unanswered.extend(error.faults)
    raise_all(InputError, collect(errors))
    questions, contradicted = partner_questions(job, states)
    raise_all(UsageError, [*unanswered, *questions])
    raise_all(
        InputError,
        [
            *contradicted,
            *_missing_axes(job, states),
            *_other_neighbours(job, states),
            *_other_tables_between(job, states),
            *_other_switches(job, states),
            *_misnamed(job, states),
            *unknown_motions(job, {name: decoded.state for name, decoded in states.items()}),
        ],
    )
    raise_all(UsageError, list(_unsaid_units(job, control, states)))
    return JobInputs(tests=tests, states=states)


def read_measurement(
    session: Session, path: Path, profile: Profile | None = None, axis: str = ""
) -> PositioningTest:
    """Read the test in one measurement file, with a profile if there is one. Raises InputError."""
    tests = read_tests(storage.read_bytes(session, path, MEASUREMENT), shown_path(path), profile)
    if len(tests) == 1:
        return tests[0]
    ours = [test for test in tests if axis and test.axis.upper() == axis.upper()]
    if len(ours) != 1:
        raise InputError(
            Fault(
                message=f"the file contains {len(tests)} tests"
                + (f", {len(ours) or 'none'} of them of axis {axis}" if axis else ""),
                file=shown_path(path),
                expected="one test of the axis",
                found=", ".join(test.axis or test.name for test in tests),
                hint="give a file with one test of this axis",
            )
        )
    return _without_unnamed(ours[0], tests)


def _without_unnamed(ours: PositioningTest, tests: Sequence[PositioningTest]) -> PositioningTest:
    """Return the test ``ours`` of a named axis, with a warning if the file also contains tests
    whose axis is not named.

    The warning is needed because such a test may be a newer measurement of the same axis, on a
    copied sheet.
    """
    unnamed = [test.name for test in tests if not test.axis]
    if not unnamed:
        return ours
    finding = sheets_finding(say("CW-R061.tests", tests=unnamed, used=ours.name))
    return replace(ours, findings=(*ours.findings, finding))


def read_test(
    session: Session,
    entry: AxisJob,
    request: TestRequest,
    folder: Path,
    measured: Sequence[PositioningTest] = (),
) -> PositioningTest:
    """Read the files of the test ``request`` of one axis (or its parts ``measured`` in memory) as
    one record in machine coordinates.

    The temperature is taken from the first of these that states it: the environment record, the
    test's own keys, its files, the axis.
    """
    errors: list[CompwrightError] = []
    parts = list(measured)
    skipped: tuple[Path, ...] = ()
    profile = (
        load_profile(session, storage.named_from(folder, request.profile))
        if request.profile
        else None
    )
    for text in request.files:
        try:
            found = measurement_files(session, storage.named_from(folder, text))
        except InputError as error:
            errors.append(error)
            continue
        skipped += found.skipped
        for path in found.files:
            try:
                parts.append(read_measurement(session, path, profile, entry.axis.name))
            except InputError as error:
                errors.append(error)
    raise_all(InputError, collect(errors))
    for part in parts:
        _check_axis(entry.axis, part)
    _check_one_map(entry, request, parts)
    test = to_machine(merge(parts, request.name), request.position_map)
    thermal, stated = request.thermal, {}
    if thermal is not None:
        of_files = temperatures_of(parts).items()
        stated = {name: T for name, T in of_files if name not in request.own_temperatures}
        thermal = with_temperatures(thermal, stated)
    if request.environment is not None:
        mapped = profile.position_map if profile is not None else None
        zero = (mapped or request.position_map).offset
        own = "T_m" in {*stated, *request.own_temperatures}
        test = reduce_by_record(test, request.environment, thermal, zero, own_temperature=own)
    elif thermal is not None:
        test = remove_differential_expansion(test, thermal)
    finding = skipped_finding([shown_path(path) for path in skipped])
    return replace(
        test,
        axis=entry.axis.name,
        findings=test.findings if finding is None else (*test.findings, finding),
    )


def _check_one_map(entry: AxisJob, request: TestRequest, parts: Sequence[PositioningTest]) -> None:
    """Raise an error if both the job and the mapping profile convert the instrument's positions
    (``position_map``), so that the ``parts`` of a test would be converted twice.
    """
    if request.position_map == PositionMap():
        return
    faults = [
        Fault(
            message="the positions of this test are mapped twice, by its profile and by the job",
            place=f"axes.{entry.axis.name}, test {request.name}",
            expected="a position_map in one of them",
            found=f"profile {request.profile}",
            hint="remove `position_map` from the job or from the profile",
        )
        for part in parts
        if part.frame == "machine"
    ]
    raise_all(UsageError, faults[:1])


def _check_axis(axis: Axis, test: PositioningTest) -> None:
    file = test.sources[0].file if test.sources else test.name
    faults = []
    if test.kind is not axis.kind:
        faults.append(
            Fault(
                message=f"the file is a test of a {test.kind.value} axis",
                file=file,
                expected=f"a test of the {axis.kind.value} axis {axis.name}",
                found=f"positions in {test.kind.unit}",
                hint=("give a test of this axis, or correct `kind` of the axis in the job"),
            )
        )
    if test.axis and test.axis.upper() != axis.name.upper():
        faults.append(
            Fault(
                message=f"the file is a test of axis {test.axis}, not of {axis.name}",
                file=file,
                place="key axis",
                hint=(
                    f"list the file under axis {test.axis} of the job, or rename axis {axis.name} "
                    f"to {test.axis} and keep its `address`, or correct `# axis:` in the file"
                ),
            )
        )
    raise_all(InputError, faults)


def _other_neighbours(job: Job, states: Mapping[str, DecodedState]) -> list[Fault]:
    """Return a fault for each axis whose measuring system, or whose other active compensation
    functions next to the table, differ between the job's states.
    """
    faults = []
    for name, entry in job.axes.items():
        facts_of = {
            state: decoded.state.facts_of(entry.axis.address) for state, decoded in states.items()
        }
        # A control without files (the word none) has no active compensation, but a measuring
        # system.
        filled = {state for state, decoded in states.items() if decoded.files}
        between = {request.measured_in for request in job.circles} | {
            request.measured_in for request in job.cross
        }
        own = {request.measured_in for request in entry.before}
        concerned = {AS_FOUND} | own | between | filled
        for quantity, what, compared in (
            ("other_functions", "what is active in addition to its table", concerned),
            ("encoder_system", "its measuring system", filled),
        ):
            found = {
                state: str(getattr(facts, quantity) or "nothing")
                for state, facts in facts_of.items()
                if state in compared
            }
            if len(set(found.values())) > 1:
                found = _differing(found)
                faults.append(
                    Fault(
                        message=f"axis {name}: {what} differs between the entries of `states`",
                        file=job.file,
                        place="states",
                        expected="the same in all of them",
                        found="; ".join(f"{state}: {words}" for state, words in found.items()),
                        hint=(
                            "give files that agree in this under `states`, or set `measured_in` "
                            "to the same entry of `states` for all tests"
                        ),
                    )
                )
    return faults


def _differing(found: Mapping[str, str]) -> dict[str, str]:
    """Return the texts, each with only those of its comma-separated parts that are not in all of
    the texts.
    """
    parts = {name: words.replace("; ", ", ").split(", ") for name, words in found.items()}
    alike = set.intersection(*map(set, parts.values()))
    return {
        name: ", ".join(part for part in each if part not in alike) or "nothing"
        for name, each in parts.items()
    }


def _other_tables_between(job: Job, states: Mapping[str, DecodedState]) -> Iterator[Fault]:
    """Yield a fault where cross-axis tables of unknown effect differ between the job's states."""
    now = states.get(AS_FOUND)
    measured = {request.measured_in for request in job.circles} | {
        request.measured_in for request in job.cross
    }
    for name, entry in job.axes.items():
        for state in sorted((measured & states.keys()) - {AS_FOUND}):
            if now is None:
                continue
            pairs = [one.state.facts_of(entry.axis.address).pairs for one in (now, states[state])]
            tables = [facts.uncounted or "none" for facts in pairs]
            if tables[0] != tables[1]:
                (help_, *_) = (facts.uncounted_help for facts in pairs if facts.uncounted)
                yield Fault(
                    message=(
                        f"cross-axis tables correct axis {name}, and they are not the same in "
                        f"`states: {AS_FOUND}` and `states: {state}`. A circle or a cross "
                        f"measurement in {state} therefore does not show the effect of the tables "
                        f"in {AS_FOUND}"
                    ),
                    file=job.file,
                    place=f"states.{state}",
                    expected=f"a measurement in {AS_FOUND}, or {help_}",
                    found=f"{AS_FOUND}: {tables[0]}; {state}: {tables[1]}",
                    hint=(
                        f"repeat the circle or the cross measurement in {AS_FOUND}, or give {help_}"
                    ),
                )


def _other_switches(job: Job, states: Mapping[str, DecodedState]) -> Iterator[Fault]:
    """Yield a fault for each state of a circle or cross measurement whose files switch a table
    between two axes of the job otherwise than `active` says. For the state as found, writing
    refuses it.
    """
    addresses = {entry.axis.address for entry in job.axes.values()}
    measured = {request.measured_in for request in job.circles}
    measured |= {request.measured_in for request in job.cross}
    for name in sorted(measured.intersection(states) - {AS_FOUND}):
        for pair in sorted(sorted(each) for each in states[name].contradicted):
            if addresses.issuperset(pair):
                yield Fault(
                    message=(
                        f"`active` in `states: {name}` says whether the table between the axes"
                        f" {' and '.join(pair)} was active during the test, and the files do not"
                        " say so"
                    ),
                    file=job.file,
                    place=f"states.{name}",
                    expected="no key `active`",
                    hint=(
                        "give the files with all switches as they were during the test, without"
                        " the tables that were off, and leave out `active`"
                    ),
                )


def _misnamed(job: Job, states: Mapping[str, DecodedState]) -> Iterator[Fault]:
    """Yield a fault if the control's files assign an axis address of the job to an axis of another
    name, or several joints to one axis.
    """
    for name, decoded in states.items():
        for entry in job.axes.values():
            facts = decoded.state.facts_of(entry.axis.address)
            for fault in other_joints(entry.axis, facts, name):
                yield fault.in_file(job.file)


def _unsaid_units(
    job: Job, control: Control, states: Mapping[str, DecodedState]
) -> Iterator[Fault]:
    """Yield a fault if the files do not state mm or inch, and the length of a table shows that the
    assumed unit is wrong.
    """
    unanswered = length_unit(control.definition)
    if unanswered is None or unanswered[0].name in control.given:
        return
    rule, whole_file = unanswered
    for name, decoded in states.items():
        for entry in job.axes.values():
            axis, found = entry.axis, decoded.state.axes.get(entry.axis.address)
            facts = decoded.state.facts_of(axis.address)
            if (
                found is None
                or found.positions.size < 2
                or axis.kind is not AxisKind.LINEAR
                or rule.settled_by in facts.stated
            ):
                continue
            ratio = (axis.travel[1] - axis.travel[0]) / float(
                found.positions[-1] - found.positions[0]
            )
            if max(ratio, 1 / ratio) > MILLIMETRES_PER_INCH / _SAME_RANGE:
                yield Fault(
                    message=(
                        f"axis {axis.name}: the unit of the machine is not given. If it is "
                        f"{control.options[rule.name]}, the table in the files of `states: {name}` "
                        "does not fit the travel of the axis"
                    ),
                    file=job.file,
                    place=f"controller.options.{rule.name}",
                    expected=f"{' or '.join(rule.choices)}, or {whole_file}",
                    found=(
                        f"a table from {found.positions[0]:g} to {found.positions[-1]:g} mm, a"
                        f" travel from {axis.travel[0]:g} to {axis.travel[1]:g} mm"
                    ),
                    hint=f"set `{rule.name}` in `controller.options`, or give {whole_file}",
                )


def _missing_axes(job: Job, states: Mapping[str, DecodedState]) -> list[Fault]:
    """Return a fault for each state whose files contain no data of an axis, because missing data
    does not mean no compensation.
    """
    faults: list[Fault] = []
    for name, decoded in states.items():
        if not decoded.files:
            continue
        faults.extend(
            Fault(
                message=(
                    "the files of this entry of `states` contain no data of axis "
                    f"{entry.axis.name} (address {entry.axis.address})"
                ),
                file=job.file,
                place=f"states.{name}",
                expected="the file with its table or backlash, or the word none",
                found=f"only {', '.join(sorted(decoded.state.axes)) or 'no axis at all'}",
                hint=(
                    f"add the file with the table of {entry.axis.address} to this entry of"
                    " `states`, or write `none` where the control has no compensation"
                ),
            )
            for entry in job.axes.values()
            if entry.axis.address not in decoded.state.axes
            and (entry.before or entry.axis.name in job.apply.scale)
        )
    return faults
