"""Read positioning tests made after loading, and find the test of the job that each repeats."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from compwright.evaluation.temperatures import temperatures_of
from compwright.foundations import storage
from compwright.foundations.errors import (
    CompwrightError,
    Fault,
    InputError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.session import Session
from compwright.instruments.fault_list import by_profile
from compwright.records.environment import MATERIAL
from compwright.records.job import AxisJob, Job, TestRequest
from compwright.records.plan import Plan
from compwright.records.positioning import PositioningTest
from compwright.verification.measurement_faults import file_disagreement
from compwright.verification.proof import AfterTest
from compwright.workflow.inputs.job_inputs import read_measurement, read_test
from compwright.workflow.inputs.measurement_files import load_profile


def read_again(
    session: Session, job: Job, entry: AxisJob, request: TestRequest
) -> PositioningTest | None:
    """Return the positioning test ``request`` of the job's axis ``entry``, read again from its
    files, or None if that fails.
    """
    try:
        return read_test(session, entry, request, Path(job.file).parent)
    except CompwrightError:
        return None


def after_tests(
    session: Session,
    job: Job,
    plan: Plan,
    specs: Sequence[str | PositioningTest],
    profile: Path | None = None,
) -> list[AfterTest]:
    """Read the tests after loading, given as ``specs`` (values of ``--after``, or tests in memory);
    several files of one test are joined. Raises one error with the faults of all files.

    ``profile``: the mapping profile of the tests after loading, which replaces that of the job.
    """
    profiles = _profiles(job) if profile is None else [profile]
    errors: list[CompwrightError] = []
    wanted: dict[tuple[str, str], list[str | PositioningTest]] = {}
    for spec in specs:
        try:
            key, part = _assign(session, job, spec, profiles)
            wanted.setdefault(key, []).append(part)
        except CompwrightError as error:
            errors.append(error)
    found = []
    for (axis, name), parts in wanted.items():
        entry = job.axes[axis]
        paths = [part for part in parts if isinstance(part, str)]
        measured = [part for part in parts if isinstance(part, PositioningTest)]
        request = next(item for item in entry.before if item.name == name)
        try:
            # a path of the command line is used as given, that of the job's profile is relative to
            # the job
            folder = Path(job.file).parent
            of_job = storage.named_from(folder, request.profile) if request.profile else None
            later = _later(request, paths)
            used = profile or of_job
            later = replace(later, profile=str(used) if used else None)
            test = read_test(session, entry, later, Path(), measured)
            _refuse_files_apart(session, entry, later, measured)
        except CompwrightError as error:
            errors.append(error)
            continue
        errors.extend(_without_temperature(request, plan, test, axis))
        found.append(
            AfterTest(
                axis, replace(test, name=name), name, tuple(Path(path) for path in paths), profile
            )
        )
    if errors:
        raise max((type(error) for error in errors), key=lambda kind: kind.exit_code)(
            *collect(errors)
        )
    raise_all(UsageError, list(_unfit(plan, [item.axis for item in found])))
    return found


def _later(request: TestRequest, paths: Sequence[str]) -> TestRequest:
    """Return how to read a test after loading: as the job's own test is read, but from the files
    ``paths``.

    The temperatures that the job states are left out, because they are those of the test before
    loading. An environment record can cover both tests, so the readings must have times.
    """
    environment = request.environment
    return replace(
        request,
        files=tuple(paths),
        own_temperatures=(),
        environment=None if environment is None else replace(environment, needs_time=True),
    )


def _refuse_files_apart(
    session: Session, entry: AxisJob, request: TestRequest, measured: Sequence[PositioningTest]
) -> None:
    """Raise an error if the files of a test differ in the state of the control or the set-up."""
    if len(request.files) + len(measured) < 2:
        return
    alone = replace(request, files=())
    parts = [
        *(
            read_test(session, entry, replace(alone, files=(file,)), Path())
            for file in request.files
        ),
        *(read_test(session, entry, alone, Path(), [test]) for test in measured),
    ]
    found = file_disagreement(parts)
    if found is not None:
        part, words = found
        raise InputError(
            Fault(
                message=(
                    f"the file contradicts {parts[0].sources[0].file}: several files of one axis "
                    f"are read as parts of one test, but their means differ by {words}"
                ),
                file=part.sources[0].file,
                place=f"--after, test {request.name}",
                expected="files of one test, with one set-up and the same control contents",
                hint="give only the files that were measured with what is in the control now",
            )
        )


def _without_temperature(
    request: TestRequest, plan: Plan, test: PositioningTest, axis: str
) -> Iterator[InputError]:
    """Yield an error for each temperature that the test before loading had of its own, but that the
    test after loading does not state.
    """
    planned = plan.axes[axis].tests if axis in plan.axes else ()
    before = next((each.test for each in planned if each.test.name == request.name), None)
    if before is None or before.thermal is None or test.thermal is None:
        return
    record = request.environment.record if request.environment is not None else None
    of_first, now = (temperatures_of([each]) for each in (before, test))
    for name, temperature, expands in (
        ("T_m", before.thermal.T_m, True),
        ("T_d", before.thermal.T_d, before.thermal.alpha_d != 0.0),
    ):
        own = name in request.own_temperatures or name in of_first
        if name == "T_m" and record is not None and MATERIAL in record.values:
            continue  # both tests have the temperature of their own hours
        if own and expands and name not in now:
            yield InputError(
                Fault(
                    message=(
                        "the file states no temperature, but the test before loading was "
                        f"reduced to 20 °C from its own temperature ({temperature:g} °C)"
                    ),
                    file=test.sources[0].file if test.sources else test.name,
                    place=f"key {name}",
                    expected=(
                        f"a line such as '# {name}: 22.4' above the readings (°C), or {name}_start"
                        f" and {name}_end"
                    ),
                    hint="add such a line to the file",
                )
            )


def _unfit(plan: Plan, axes: Sequence[str]) -> Iterator[Fault]:
    """Yield a fault if no test is given at all, if an axis has two tests, or if an axis is not in
    the plan.
    """
    for axis in dict.fromkeys(axes):
        if axes.count(axis) > 1:
            yield Fault(
                message=(f"two tests of axis {axis} were given, but verify uses one test per axis"),
                place="--after",
                hint="give only one test of this axis",
            )
    for axis in dict.fromkeys(axes):
        if axis not in plan.axes:
            yield Fault(
                message=f"the plan contains no axis {axis}",
                place="--after",
                expected=", ".join(plan.axes),
                hint="give the test of an axis of the plan",
            )
    if not axes:
        yield Fault(
            message="no test to verify was given",
            place="--after",
            expected="the tests made after loading",
            hint="give the test taken after loading: `--after FILE`",
        )


def _assign(
    session: Session, job: Job, spec: str | PositioningTest, profiles: Sequence[Path]
) -> tuple[tuple[str, str], str | PositioningTest]:
    """Return what a value of ``--after`` means: the axis and the name of the test that it repeats,
    and the file or the test in memory.
    """
    names = {request.name: axis for axis, entry in job.axes.items() for request in entry.before}
    if isinstance(spec, PositioningTest):
        return _first_test(job, _axis_of(job, spec.axis, spec.name, names), spec.name, names), spec
    head, mark, tail = spec.partition("=")
    if not spec or (mark and not tail):
        raise UsageError(
            Fault(
                message="the value of `--after` contains no file name",
                place="--after",
                expected="FILE or TEST=FILE",
                found=repr(spec),
                hint="give `--after FILE` or `--after TEST=FILE`",
            )
        )
    if mark and head in names:
        return (_axis_of_name(session, job, head, tail, profiles), head), tail
    if mark and not storage.is_there(session, Path(spec)):
        known = " or ".join(names)
        raise UsageError(
            Fault(
                message="the name before the `=` in `--after` is not a test of the job",
                place="--after",
                expected=f"{known}",
                found=repr(spec),
                hint=f"write {known} before the `=`",
            )
        )
    axis = _axis_of(job, _axis_in(session, spec, profiles), spec, names)
    return _first_test(job, axis, spec, names), spec


def _first_test(job: Job, axis: str, spec: str, names: Mapping[str, str]) -> tuple[str, str]:
    """Return ``axis`` and the name of the axis's first test in the job. ``names``: the axis of each
    test name.
    """
    before = job.axes[axis].before
    if not before:
        raise UsageError(
            Fault(
                message=f"the job has no test of axis {axis}, so this test cannot be compared",
                place="--after",
                expected="a test of "
                f"{' or '.join(names.values()) or 'an axis that has `before` in the job'}",
                found=spec,
                hint="give a test of an axis that has `before` in the job",
            )
        )
    return axis, before[0].name


def _axis_of(job: Job, measured: str, spec: str, names: Iterable[str]) -> str:
    """Return the axis of the job for a test: the one that its file names (``measured``), or the
    only axis of the job.
    """
    if measured:
        axis = next((name for name in job.axes if name.upper() == measured.upper()), None)
        if axis is None:
            raise UsageError(
                Fault(
                    message=f"the file is a test of axis {measured}, which is not in the job",
                    file=spec,
                    expected=", ".join(job.axes),
                    hint="give the test of an axis of the job",
                )
            )
        return axis
    if len(job.axes) > 1:
        raise UsageError(
            Fault(
                message="the file does not state which axis it measures",
                file=spec,
                place="--after",
                expected=f"TEST=FILE, where TEST is one of {', '.join(names)}",
                hint=(
                    "give `--after TEST=FILE`, such as `--after "
                    f"{next(iter(names), 'TEST')}={spec}`"
                ),
            )
        )
    return next(iter(job.axes))


def _axis_in(session: Session, path: str, profiles: Sequence[Path]) -> str:
    """Return the axis that a measurement file names. To read the file, one of the ``profiles`` can
    be necessary.
    """
    try:
        return read_measurement(session, Path(path)).axis
    except InputError:
        if not profiles:
            raise
    faults: list[Fault] = []
    for profile in profiles:
        try:
            return read_measurement(session, Path(path), load_profile(session, profile)).axis
        except InputError as error:
            faults += [fault.within(f"by the profile {profile}") for fault in error.faults]
    fault = Fault(
        message=f"no given profile describes the columns of {path}",
        place="--profile",
        expected="a profile that states the columns of this test",
        hint=f"make one with {by_profile(path)}",
    )
    raise InputError(*faults, fault)


def _profiles(job: Job) -> list[Path]:
    """Return the profiles of a job; their paths are relative to the job's own file."""
    requests = [request for entry in job.axes.values() for request in entry.before]
    named = dict.fromkeys(request.profile for request in requests if request.profile)
    return [storage.named_from(Path(job.file).parent, name) for name in named]


def _axis_of_name(
    session: Session, job: Job, name: str, path: str, profiles: Sequence[Path]
) -> str:
    """Return the axis whose test in the job has this ``name``. If several axes have such a test,
    the axis named in the file decides.
    """
    axes = [
        axis
        for axis, entry in job.axes.items()
        if any(request.name == name for request in entry.before)
    ]
    if len(axes) == 1:
        return axes[0]
    measured = _axis_in(session, path, profiles).upper()
    for axis in axes:
        if axis.upper() == measured:
            return axis
    raise UsageError(
        Fault(
            message=f"several axes of the job have a test with the name {name}, and the file does "
            "not name one of these axes",
            file=path,
            place="key axis",
            expected=" or ".join(axes),
            found=measured,
            hint="add the line `# axis: NAME` with one of these axes to the file",
        )
    )
