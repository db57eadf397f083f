"""Check whether a plan was made from the present job: axes, options, states, tests and circles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from compwright.foundations.errors import Fault
from compwright.records.job import AS_FOUND, AxisJob, Job, TestRequest
from compwright.records.plan import Plan, PlannedAxis
from compwright.records.positioning import SAME_READING, PositioningTest

ReadAgain = Callable[[AxisJob, TestRequest], PositioningTest | None]


def stale_plan(
    job: Job, plan: Plan, file: str, *, options: Mapping[str, object], read: ReadAgain
) -> list[Fault]:
    """Return a fault for each difference between the job and the inputs from which the plan was
    made. Limits are not compared.

    ``options``: those of the job, with the values that it leaves to the control. ``read``: a
    function that reads a test of the job again from its files; it returns None if the files no
    longer exist.
    """
    differences = [
        *_axes_differ(job, plan, read),
        *_options_differ(job, plan, options),
        *_states_differ(job, plan),
    ]
    circles = {circle.name for circle in job.circles}
    if circles != set(plan.circles):
        differences.append(
            (
                "circles",
                ", ".join(sorted(circles)) or "none",
                ", ".join(sorted(plan.circles)) or "none",
            )
        )
    return [stale_fault(what, mine, theirs, file) for what, mine, theirs in differences]


def stale_fault(what: str, mine: str, theirs: str, file: str) -> Fault:
    """Return the fault that the key ``what`` has the value ``mine`` in the job, but ``theirs`` in
    the plan.
    """
    return Fault(
        message="the plan was made for another job, or before this job was edited",
        file=file,
        place=what,
        expected=mine,
        found=theirs,
        hint="run the job again with `compwright run`, or give the plan of this job with `--plan`",
    )


def _axes_differ(job: Job, plan: Plan, read: ReadAgain) -> Iterator[tuple[str, str, str]]:
    names = {name for name, entry in job.axes.items() if entry.before}
    planned = {name for name, entry in plan.axes.items() if entry.tests}
    if names != planned:
        yield "axes", ", ".join(sorted(names)), ", ".join(sorted(planned))
    for name in sorted(names & planned):
        mine, theirs = job.axes[name], plan.axes[name]
        yield from _differences(f"axis {name}: ", mine.axis, theirs.axis)
        made = theirs.request
        if made.goal == "expected":  # also where the table for the goal of the job did not gain
            made = replace(made, goal=mine.table.goal)
        if mine.table.mode == "auto":  # one table is planned where two could hold the drift
            made = replace(made, mode="auto")
        yield from _differences(f"axis {name}: table.", mine.table, made)
        yield from _tests_differ(mine, theirs, read)


def _differences(place: str, mine: Any, theirs: Any) -> Iterator[tuple[str, str, str]]:
    """Yield each difference between a record of the job (``mine``) and that of the plan
    (``theirs``): the key in the job (below the key path ``place``), and both values as text.
    """
    for field in fields(mine):
        one, other = getattr(mine, field.name), getattr(theirs, field.name)
        if not field.compare or one == other:
            continue
        if is_dataclass(one):
            yield from _differences(f"{place}{field.name}.", one, other)
        elif isinstance(one, Mapping):
            for key in sorted({*one, *other}):
                if _plain(one.get(key)) != _plain(other.get(key)):
                    yield f"{place}{field.name}.{key}", _text(one.get(key)), _text(other.get(key))
        else:
            yield f"{place}{field.name}", _text(one), _text(other)


def _tests_differ(
    mine: AxisJob, theirs: PlannedAxis, read: ReadAgain
) -> Iterator[tuple[str, str, str]]:
    name = mine.axis.name
    if [request.name for request in mine.before] != [planned.test.name for planned in theirs.tests]:
        was = ", ".join(planned.test.name for planned in theirs.tests)
        yield f"axis {name}: tests", ", ".join(request.name for request in mine.before), was
        return
    for request, planned in zip(mine.before, theirs.tests, strict=True):
        if request.measured_in != planned.measured_in:
            yield (
                f"axis {name}, test {request.name}: measured_in",
                request.measured_in,
                planned.measured_in,
            )
        if request.motion != planned.motion:
            yield f"axis {name}, test {request.name}: motion", request.motion, planned.motion
        now = read(mine, request)
        if now is not None and not _same(now, planned.test):
            yield (
                f"axis {name}, test {request.name}",
                "the readings that its files hold now",
                "other readings",
            )


def _same(one: PositioningTest, other: PositioningTest) -> bool:
    pairs = (
        (one.targets, other.targets),
        (one.positive, other.positive),
        (one.negative, other.negative),
    )
    return all(
        a.shape == b.shape and np.allclose(a, b, rtol=0.0, atol=SAME_READING, equal_nan=True)
        for a, b in pairs
    )


def _options_differ(
    job: Job, plan: Plan, options: Mapping[str, object]
) -> Iterator[tuple[str, str, str]]:
    for name in job.options:
        mine, theirs = options.get(name), plan.options.get(name)
        if _plain(mine) != _plain(theirs):
            yield f"controller.options.{name}", _text(mine), _text(theirs)


def _states_differ(job: Job, plan: Plan) -> Iterator[tuple[str, str, str]]:
    """Yield each difference between the states of the control in the job and in the plan."""
    for name in sorted({AS_FOUND, *job.states} & {AS_FOUND, *plan.states}):
        mine, theirs = job.states.get(name), plan.states.get(name)
        if (mine is None) != (theirs is None) or bool(mine) != bool(theirs):
            was, now = (
                "not given" if state is None else "files" if state else "none"
                for state in (theirs, mine)
            )
            yield f"states.{name}", now, was
        elif job.active.get(name) != plan.active.get(name):
            yield f"states.{name}.active", _text(job.active.get(name)), _text(plan.active.get(name))


def _plain(value: Any) -> Any:
    """Return a value with tuples as lists, as it is after writing to JSON and reading."""
    return [_plain(entry) for entry in value] if isinstance(value, list | tuple) else value


def _text(value: Any) -> str:
    """Return a value as it is written in a job file."""
    if value is None:
        return "not given"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_text, value))}]"
    return f"{value:g}" if isinstance(value, float) else str(value)
