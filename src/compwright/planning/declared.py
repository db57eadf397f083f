"""What the job declares of temperature and set-up, as slopes that tests have of their own.

Counted once: under the decision rule ``simple`` in the band of the prediction, under ``guarded`` in
the guard band U alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from compwright.evaluation.uncertainty import slope_between_tests
from compwright.records.job import Job
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest


def with_slopes(job: Job, tests: Sequence[PlannedTest]) -> tuple[PlannedTest, ...]:
    """Return the tests of an axis with the standard deviation of the slope (mm/mm) that each has of
    its own.

    ``guarded``: the slope of the first test, on which the table stands, is in U; the others lie
    beside it by both.
    """
    first = tests[0].test
    own = [
        slope_between_tests(each.test, job.budget(each.test.kind), first.thermal) for each in tests
    ]
    if job.decision_rule == "guarded":
        own = [0.0, *(float(np.hypot(own[0], slope)) for slope in own[1:])]
    return tuple(replace(test, slope_std=slope) for test, slope in zip(tests, own, strict=True))


def fresh_slope(rule: Literal["simple", "guarded"], test: PlannedTest) -> float:
    """Return the standard deviation of the slope (mm/mm) of a fresh test like ``test`` in the band
    of its prediction.
    """
    return 0.0 if rule == "guarded" else test.slope_std


def slope_after(job: Job, tests: Sequence[PlannedTest], after: PositioningTest) -> float:
    """Return the standard deviation of the slope (mm/mm) that a test ``after`` loading may have
    against the error that the ``tests`` before tell.

    Under ``guarded`` that error is told without the uncertain slope of its own test: both count.
    """
    budget, first = job.budget(after.kind), tests[0].test
    own = slope_between_tests(after, budget, first.thermal)
    if job.decision_rule != "guarded":
        return own
    return float(np.hypot(own, slope_between_tests(first, budget, first.thermal)))
