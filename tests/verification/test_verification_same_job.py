"""A plan of another job, or of this one before it was edited, is told by what differs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.records.axis import Axis, Encoder
from compwright.records.correction import ControlFile
from compwright.records.fitted_table import TableRequest
from compwright.records.job import AxisJob, CircleRequest, Job, TestRequest
from compwright.records.plan import Plan, PlannedAxis
from compwright.records.positioning import PositioningTest
from compwright.verification.stale_plan import stale_plan
from planning_samples import KnownAxis, axis_of, circle_of, job_of, work_of

PLANNED = work_of(KnownAxis(np.zeros_like, np.zeros_like)).planned
FILE = ControlFile("X.INI", b"1")
JOB = job_of(axis_of(), options={"unit": 0.001}, states={"as_found": ("X.INI",)})
PLAN = Plan(
    version="1",
    format="any",
    options={"unit": 0.001, "other": 3},
    standard="iso230-2:2014",
    axes={"X": PLANNED},
    states={"as_found": (FILE,)},
)


def told(
    job: Job = JOB,
    plan: Plan = PLAN,
    options: Mapping[str, object] | None = None,
    now: PositioningTest | None = PLANNED.tests[0].test,
) -> list[tuple[str, str, str]]:
    """What differs: place, what the job says, what the plan says."""
    options = PLAN.options if options is None else options

    def read(_entry: AxisJob, _request: TestRequest) -> PositioningTest | None:
        return now

    faults = stale_plan(job, plan, "plan.json", options=options, read=read)
    return [(fault.place, fault.expected, fault.found) for fault in faults]


def with_axis(axis: Axis | None = None, **words: Any) -> Job:
    entry = JOB.axes["X"]
    return replace(JOB, axes={"X": replace(entry, axis=axis or entry.axis, **words)})


def test_the_plan_of_this_job_is_no_other() -> None:
    assert told() == []


@pytest.mark.parametrize(
    ("axis", "place", "mine", "theirs"),
    [
        (axis_of(travel=(0.0, 900.0)), "travel", "[0, 900]", "[0, 1000]"),
        (axis_of(encoder=Encoder(system=2)), "encoder.system", "2", "1"),
        (axis_of(modulo=360.0), "modulo", "360", "not given"),
        (axis_of(options={"unit": 0.01}), "options.unit", "0.01", "not given"),
        (axis_of(gantry="X2"), "gantry", "X2", "not given"),
    ],
)
def test_an_axis_that_was_edited(axis: Axis, place: str, mine: str, theirs: str) -> None:
    assert told(with_axis(axis)) == [(f"axis X: {place}", mine, theirs)]


def test_who_said_which_measuring_system_is_no_difference() -> None:
    assert told(with_axis(axis_of(encoder=Encoder(stated=False)))) == []


def test_a_table_that_was_asked_for_otherwise() -> None:
    edited = with_axis(table=TableRequest(spacing=25.0))
    assert told(edited) == [("axis X: table.spacing", "25", "not given")]


def test_one_table_where_two_could_hold_the_drift_is_the_same_job() -> None:
    planned = replace(PLANNED, request=TableRequest(mode="single"))
    plan = replace(PLAN, axes={"X": planned})
    assert told(with_axis(table=TableRequest(mode="auto")), plan) == []
    asked = TableRequest(mode="bidirectional")
    assert told(with_axis(table=asked), plan) == [("axis X: table.mode", "bidirectional", "single")]


def test_a_goal_whose_table_did_not_gain_is_the_same_job() -> None:
    """The plan then holds the usual table, and says so by its goal."""
    for_m = TableRequest(goal="M")
    assert told(with_axis(table=for_m)) == []
    planned = replace(PLAN, axes={"X": replace(PLANNED, request=for_m)})
    assert told(plan=planned) == [("axis X: table.goal", "expected", "M")]
    assert told(with_axis(table=for_m), plan=planned) == []


def test_axes_that_came_or_went() -> None:
    assert told(job_of(axis_of(), axis_of("Y"), options=JOB.options, states=JOB.states)) == [
        ("axes", "X, Y", "X")
    ]
    untested: Mapping[str, PlannedAxis] = {"X": PLANNED, "Y": replace(PLANNED, tests=())}
    assert told(plan=replace(PLAN, axes=untested)) == []  # its table came from circles


def test_tests_under_other_names_or_of_another_state() -> None:
    other = TestRequest(files=("x.csv",), name="y")
    assert told(with_axis(before=(other,))) == [("axis X: tests", "y", "x")]
    before = TestRequest(files=("x.csv",), name="x", measured_in="before")
    assert told(with_axis(before=(before,))) == [
        ("axis X, test x: measured_in", "before", "as_found")
    ]


def test_files_that_hold_other_readings_now() -> None:
    test = PLANNED.tests[0].test
    told_then = [("axis X, test x", "the readings that its files hold now", "other readings")]
    assert told(now=replace(test, positive=test.positive + 1e-8)) == told_then
    assert told(now=replace(test, negative=test.negative + 1e-8)) == told_then
    assert told(now=replace(test, targets=test.targets + 1e-8)) == told_then
    assert told(now=replace(test, positive=test.positive[:, :1])) == told_then
    assert told(now=replace(test, positive=test.positive + 1e-10)) == []  # rounded by JSON
    assert told(now=None) == []  # the files are elsewhere


def test_options_of_the_control_that_the_job_gives() -> None:
    assert told(options={"unit": 0.01, "other": 4}) == [
        ("controller.options.unit", "0.01", "0.001")
    ]
    lists = replace(PLAN, options={"unit": [1, 2]})  # as JSON gives a tuple back
    assert told(plan=lists, options={"unit": (1, 2)}) == []


def test_states_that_were_given_otherwise() -> None:
    place = "states.as_found"
    assert told(replace(JOB, states={})) == [(place, "not given", "files")]
    assert told(replace(JOB, states={"as_found": ()})) == [(place, "none", "files")]
    assert told(plan=replace(PLAN, states={"as_found": ()})) == [(place, "files", "none")]
    assert told(replace(JOB, active={"as_found": False})) == [
        (f"{place}.active", "no", "not given")
    ]


def test_circles_under_other_names() -> None:
    request = CircleRequest(files=("xy.b5r",), name="xy")
    assert told(replace(JOB, circles=(request,))) == [("circles", "xy", "none")]
    with_circle = replace(PLAN, circles={"xy": circle_of({}).planned})
    assert told(plan=with_circle) == [("circles", "none", "xy")]
    assert told(replace(JOB, circles=(request,)), with_circle) == []
