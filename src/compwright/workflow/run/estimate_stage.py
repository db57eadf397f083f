"""Second stage of a run: evaluate tests, and estimate errors and their corrections."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from compwright.controls.judged_corrections import applied_correction
from compwright.evaluation.same_error import same_error_findings
from compwright.foundations.findings import Finding
from compwright.foundations.parallel_work import Each, in_turn
from compwright.planning import axis_tasks
from compwright.planning.axis_work import AxisWork
from compwright.planning.circle_checks import CircleChecks
from compwright.planning.circle_network import network_findings
from compwright.planning.circles import CircleWork, start_circles, travel_findings
from compwright.planning.header_statements import with_statements
from compwright.planning.mirror_image import MIRRORED
from compwright.records.job import Job
from compwright.records.positioning import PositioningTest
from compwright.workflow.run.input_stage import Measured
from compwright.workflow.run.old_tables import with_old_tables


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """The axes with their errors, the circular tests with the causes of their deviations, and the
    comparison of circular tests with axes.
    """

    works: Mapping[str, AxisWork]
    circles: tuple[CircleWork, ...]
    checks: CircleChecks
    findings: tuple[Finding, ...]


def wanted(measured: Measured, each: Each = in_turn) -> Wanted:
    """Return the corrections that the tests of a job require.

    Raises UsageError for limits that fit no test. Raises InputError for tests that cannot be
    evaluated, or that cover less than half of the travel.
    """
    job, axes = measured.job, measured.axes
    entries = {name: entry for name, entry in job.axes.items() if entry.before}
    tests = measured.inputs.tests
    started = each(
        axis_tasks.start_task,
        [(job, entry, tests[name], measured.states) for name, entry in entries.items()],
    )
    works = {
        name: replace(work, as_found=applied_correction(measured.as_found, work.planned.axis))
        for name, work in zip(entries, started, strict=True)
    }
    works, old_tables = with_old_tables(measured, works, each)
    works = {name: _not_twice(job, work) for name, work in works.items()}
    serial = job.machine.get("serial", "")
    begun = start_circles(job, measured.circles, axes)
    circles = with_statements(begun, axes, measured.states, serial)
    checks = CircleChecks(job, works, measured.active)
    with_circles, taken = checks.with_circle_backlash(circles)
    places = (
        finding for work in circles for finding in (*work.findings, *travel_findings(work, axes))
    )
    return Wanted(
        works=with_circles,
        circles=circles,
        checks=checks,
        findings=(
            *measured.findings,
            *same_error_findings(_not_alike(measured)),
            *old_tables,
            *places,
            *checks.findings(circles),
            *network_findings(circles),
            *taken,
        ),
    )


def _not_twice(job: Job, work: AxisWork) -> AxisWork:
    """Return the axis; it gets no new table if its existing table seems to be made from the same
    test, because the same error would be corrected twice.

    If tests in two states show the effect of that table, its shape is no evidence, and the axis is
    not changed.
    """
    if work.refused:
        doubts = tuple(each for each in work.doubts if each.code != MIRRORED)
        return replace(work, doubts=doubts)
    name = work.planned.axis.name
    why = [each.sentence for each in work.doubts if each.code == MIRRORED]
    if not why or job.acknowledgement(MIRRORED, name) is not None:
        return work
    return replace(work, refused=why[0])


def _not_alike(measured: Measured) -> dict[str, list[PositioningTest]]:
    """Return the tests of each axis by name, without the slave axes of gantries, whose tests would
    resemble those of their masters.
    """
    followers = {axis.gantry for axis in measured.axes.values() if axis.gantry is not None}
    return {
        name: [entry.test for entry in tests]
        for name, tests in measured.inputs.tests.items()
        if measured.axes[name].address not in followers
    }
