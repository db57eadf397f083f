"""Positioning tests after loading, read: which axis and which test of the job each repeats."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, UsageError, collect, raise_all
from compwright.records.job import AxisJob, Job, TestRequest
from compwright.records.plan import Plan
from compwright.records.positioning import PositioningTest
from compwright.verification.proof import AfterTest
from compwright.workflow.stages.inputs import read_measurement, read_test


def read_again(job: Job, entry: AxisJob, request: TestRequest) -> PositioningTest | None:
    """Return a test of the job as its files say it now; None where they are not there any more."""
    try:
        return read_test(job, entry, request, Path(job.file).parent)
    except CompwrightError:
        return None


def after_tests(job: Job, plan: Plan, specs: Sequence[str]) -> list[AfterTest]:
    """Read the after tests; several files of one test become one. Raises with every fault at
    once.
    """
    errors: list[CompwrightError] = []
    wanted: dict[tuple[str, str], list[str]] = {}
    for spec in specs:
        try:
            key, path = _assign(job, spec)
            wanted.setdefault(key, []).append(path)
        except CompwrightError as error:
            errors.append(error)
    found = []
    for (axis, name), paths in wanted.items():
        entry = job.axes[axis]
        request = next(item for item in entry.before if item.name == name)
        try:
            test = read_test(job, entry, replace(request, files=tuple(paths)), Path())
        except CompwrightError as error:
            errors.append(error)
            continue
        found.append(AfterTest(axis=axis, test=replace(test, name=name), repeats=name))
    if errors:
        raise max((type(error) for error in errors), key=lambda kind: kind.exit_code)(
            *collect(errors)
        )
    raise_all(UsageError, list(_unfit(plan, [item.axis for item in found])))
    return found


def _unfit(plan: Plan, axes: Sequence[str]) -> Iterator[Fault]:
    """Yield why tests of these axes cannot be judged: two of one, none at all, or no axis of the
    plan.
    """
    for axis in dict.fromkeys(axes):
        if axes.count(axis) > 1:
            yield Fault(
                message=f"two tests of axis {axis} were given; verify judges one test per axis",
                place="--after",
            )
    for axis in dict.fromkeys(axes):
        if axis not in plan.axes:
            yield Fault(
                message=f"the plan holds no axis {axis}",
                place="--after",
                expected=", ".join(plan.axes),
            )
    if not axes:
        yield Fault(
            message="no test to verify",
            place="--after",
            expected="the tests made after loading",
        )


def _assign(job: Job, spec: str) -> tuple[tuple[str, str], str]:
    """Return (axis, test name) and the path of an ``--after`` value: ``TEST=FILE``, else by the
    file's axis.
    """
    names = {request.name: axis for axis, entry in job.axes.items() for request in entry.before}
    head, mark, tail = spec.partition("=")
    if not spec or (mark and not tail):
        raise UsageError(
            Fault(
                message="names no file",
                place="--after",
                expected="FILE or TEST=FILE",
                found=repr(spec),
            )
        )
    if mark and head in names:
        return (_axis_of_name(job, head, tail), head), tail
    if mark and not storage.is_there(Path(spec)):
        known = " or ".join(names)
        raise UsageError(
            Fault(
                message="is no test of the job",
                place="--after",
                expected=f"{known} before the =",
                found=repr(spec),
            )
        )
    axis = _axis_of_file(job, spec, list(names))
    before = job.axes[axis].before
    if not before:
        raise UsageError(
            Fault(
                message=f"the job has no test of axis {axis} to hold it against",
                place="--after",
                expected=f"a test of {' or '.join(names.values()) or 'an axis with before'}",
                found=spec,
            )
        )
    return (axis, before[0].name), spec


def _axis_of_file(job: Job, spec: str, names: Sequence[str]) -> str:
    """Return the axis that a file says it measured, or the only one of the job. ``names``: of the
    job's tests.
    """
    measured = read_measurement(Path(spec)).axis
    if measured:
        axis = next((name for name in job.axes if name.upper() == measured.upper()), None)
        if axis is None:
            raise UsageError(
                Fault(
                    message=f"is a test of axis {measured}, which the job does not have",
                    file=spec,
                    expected=", ".join(job.axes),
                )
            )
        return axis
    if len(job.axes) > 1:
        raise UsageError(
            Fault(
                message="does not say which axis it measured",
                file=spec,
                place="--after",
                expected=f"TEST=FILE with TEST one of {', '.join(names)}",
            )
        )
    return next(iter(job.axes))


def _axis_of_name(job: Job, name: str, path: str) -> str:
    """Return the axis of a test name; where several axes use the name, the file says which one it
    is.
    """
    axes = [
        axis
        for axis, entry in job.axes.items()
        if any(request.name == name for request in entry.before)
    ]
    if len(axes) == 1:
        return axes[0]
    measured = read_measurement(Path(path)).axis.upper()
    for axis in axes:
        if axis.upper() == measured:
            return axis
    raise UsageError(
        Fault(
            message=f"several axes have a test {name}",
            file=path,
            place="key axis",
            expected=" or ".join(axes),
            found=measured,
        )
    )
