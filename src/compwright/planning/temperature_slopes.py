"""The effect of uncertain temperature and set-up: a slope error of a test that differs from test to
test.

It is counted once. Under the decision rule ``simple`` it is in the band of the prediction; under
``guarded`` it is in the guard band U alone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

from compwright.evaluation.uncertainty import slope_between_tests
from compwright.records.conditions import UncertaintyBudget
from compwright.records.job import Job
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest


def with_temperature_slopes(job: Job, tests: Sequence[PlannedTest]) -> tuple[PlannedTest, ...]:
    """Return the tests of an axis, each with the standard deviation of its slope error (mm/mm) from
    temperature and set-up.

    Under the decision rule ``guarded`` the slope error is relative to that of the first test,
    because U contains the slope error of the first test.
    """
    first = tests[0].test
    own = tuple(
        replace(
            each,
            slope_std=slope_between_tests(each.test, job.budget(each.test.kind), first.thermal),
        )
        for each in tests
    )
    return relative_to_first(own) if job.decision_rule == "guarded" else own


def relative_to_first(tests: Sequence[PlannedTest]) -> tuple[PlannedTest, ...]:
    """Return the tests, each with the standard deviation of the difference between its slope and
    the slope of the first test, from which the table takes its slope.

    It is zero for the first test. For every other test it combines the standard deviations of both
    slopes.
    """
    first, *others = tests
    return (
        replace(first, slope_std=0.0),
        *(replace(each, slope_std=math.hypot(first.slope_std, each.slope_std)) for each in others),
    )


def fresh_slope(rule: Literal["simple", "guarded"], test: PlannedTest) -> float:
    """Return the standard deviation of the slope (mm/mm) in a simulated repetition of a test: 0 if
    the ``rule`` is ``guarded``, because the guard band contains the slope.
    """
    return 0.0 if rule == "guarded" else test.slope_std


def slope_in_table(job: Job, tests: Sequence[PlannedTest], coming: PositioningTest) -> float:
    """Return the standard deviation (mm/mm) of the slope error in the table, which has its slope
    from the first of the ``tests``, relative to the slope of a later test ``coming``.

    It combines two parts: the uncertain slope of the first test, and the uncertain expansion
    coefficient times the difference of the temperatures of both tests.
    """
    budget, first = job.budget(coming.kind), tests[0].test
    common = None if budget is None else UncertaintyBudget(U_alpha=budget.U_alpha)
    return math.hypot(
        slope_between_tests(first, budget, first.thermal),
        slope_between_tests(coming, common, first.thermal),
    )


def slope_after(job: Job, tests: Sequence[PlannedTest], after: PositioningTest) -> float:
    """Return the standard deviation (mm/mm) of the slope difference between the first of the
    ``tests`` and the test ``after`` loading.
    """
    budget, first = job.budget(after.kind), tests[0].test
    own = (slope_between_tests(each, budget, first.thermal) for each in (first, after))
    return math.hypot(*own)
