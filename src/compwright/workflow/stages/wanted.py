"""Second stage of a job: tests evaluated, errors estimated, and laser and circles held against each
other.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from compwright.foundations.findings import Finding
from compwright.planning.axes import AxisWork, start_axis
from compwright.planning.checks import Checks
from compwright.planning.circles import CircleWork, checked_axes, start_circles
from compwright.workflow.stages.acting import correction_of
from compwright.workflow.stages.measured import Measured


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """The axes with their errors and the circles with their causes; ``checks`` tells what one says
    of the other.
    """

    works: Mapping[str, AxisWork]
    circles: tuple[CircleWork, ...]
    checks: Checks
    findings: tuple[Finding, ...]


def wanted(measured: Measured) -> Wanted:
    """Return what the tests of a job ask of its control.

    Raises UsageError for limits that fit no test, InputError for tests that cannot be evaluated or
    leave most of the travel open.
    """
    job, axes = measured.job, measured.axes
    works = {
        name: start_axis(
            job,
            entry,
            measured.inputs.tests[name],
            measured.states,
            correction_of(measured.as_found, entry.axis),
        )
        for name, entry in job.axes.items()
        if entry.before
    }
    circles = start_circles(job, measured.circles, axes)
    checks = Checks(job, works, measured.acting)
    with_circles, taken = checks.with_circle_backlash(circles)
    places = (
        finding for work in circles for finding in (*work.findings, *checked_axes(work, axes))
    )
    return Wanted(
        works=with_circles,
        circles=circles,
        checks=checks,
        findings=(*measured.findings, *places, *checks.findings(circles), *taken),
    )
