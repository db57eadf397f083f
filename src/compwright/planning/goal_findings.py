"""Findings about the goal of a fit (the parameter that it minimises, such as A): what this goal
gains and costs in separate simulated tests.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from compwright.fitting.whole_increments import GOAL_LEFT
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.scenarios import same_tables
from compwright.planning.simulated_repeat_tests import FreshTests
from compwright.prediction.active_corrections import Correction, difference
from compwright.words.sentences import say

#: Reported parameters: of both directions, of the one that was measured, or of VDI/DGQ 3441.
_REPORTED: Final = (
    ("A", "E", "M"),
    ("A_positive", "E_positive", "A_negative", "E_negative"),
    ("P", "Pa"),
)


def goal_findings(work: AxisWork, new: Correction, fresh: FreshTests) -> Iterator[Finding]:
    """Yield the finding CW-P152: A, E and M of the simulated tests ``fresh`` with the chosen table
    ``new`` and, for comparison, with the fitted table that was not chosen.

    It is yielded only if the job has a goal other than the least expected square.
    """
    planned, goal = work.planned, work.entry.table.goal
    if work.alternative is None or planned.fitted is None:
        return
    mine, others = (
        fresh.quantiles(difference(correction, work.active))
        for correction in (new, work.alternative.compensation.at)
    )
    same = same_tables(planned.fitted, work.alternative)
    unit = planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    names = next(
        found
        for parameters in _REPORTED
        if (found := [name for name in parameters if name in mine])
    )
    left = any(finding.code == GOAL_LEFT for finding in planned.fitted.findings)
    yield Finding.of(
        "CW-P152",
        "info",
        axis=planned.axis.name,
        tables="left"
        if left
        else "same"
        if same
        else "taken"
        if planned.request.goal == goal
        else "no_gain",
        goal=goal,
        parameters=[
            say(
                "CW-P152.parameter",
                parameter=name,
                value=mine[name].median * factor,
                other=None if same else others[name].median * factor,
            )
            for name in names
        ],
        unit=small,
    )
