"""Guard bands for decisions about a future test: the expanded uncertainty of its parameters (ISO
14253-1).

It includes the uncertainty of the earlier tests, because their errors are now in the table.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from compwright.evaluation.uncertainty import expanded_uncertainties
from compwright.planning.predicted_gain import predict_same_targets
from compwright.planning.simulated_repeat_tests import RepeatConditions
from compwright.planning.temperature_slopes import slope_after, slope_in_table
from compwright.planning.wanted_correction import MeasuredError, with_change
from compwright.prediction.active_corrections import Correction
from compwright.records.axis import AxisKind, Direction
from compwright.records.job import Job
from compwright.records.plan import PlannedAxis
from compwright.records.prediction import Quantiles
from compwright.records.result import ExpandedUncertainty, PositioningResult


def guard_bands(
    job: Job,
    planned: PlannedAxis,
    place: int,
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
) -> Mapping[str, ExpandedUncertainty] | None:
    """Return the expanded uncertainty U (mm or deg, k = 2) of each parameter of a repetition of the
    test with index ``place``, after a ``change`` of the correction. None: the job declares no
    uncertainty, or the standard is VDI 3441.

    It is the U of the measured test after the change (`expanded_uncertainties`), because U depends
    on the remaining curve. Errors of temperature, misalignment and set-up are drawn twice: once for
    the test from which the table is made, and once for the repetition. The errors of the instrument
    and of the expansion coefficient are the same in both tests. The table contains them, and the
    repetition does not show them, so they are drawn once.

    U is at least the amount by which the declared slopes of both tests move the ends of the band.
    Therefore a guarded decision neither accepts nor rejects what a simple decision leaves
    undecided.
    """
    test, kind = result.test, result.test.kind
    budget = job.budget(kind)
    if budget is None:
        return None
    if kind is AxisKind.ROTARY:  # set-up gives no slope of angles: add both draws
        budget = replace(budget, setup=math.hypot(budget.setup, budget.setup))
    stated, _ = expanded_uncertainties(
        with_change(test, *(change(test.targets, direction) for direction in Direction)),
        result.parameters,
        result.coverage,
        budget,
        test.thermal,
        table_slope=slope_in_table(job, planned.tests, test),
    )
    slope = slope_after(job, planned.tests, test)
    if stated is None or slope == 0.0:
        return stated
    still, sloped = (
        predict_same_targets(result, posterior, change, planned.axis, RepeatConditions(place, std))
        for std in (0.0, slope)
    )
    return {
        name: replace(each, U=max(each.U, _moved(still[name], sloped[name])))
        for name, each in stated.items()
    }


def _moved(narrow: Quantiles, wide: Quantiles) -> float:
    """Return how far the range ``wide`` (5 % to 95 %) extends beyond the range ``narrow``, at the
    end where it extends further.
    """
    return max(wide.p95 - narrow.p95, narrow.p05 - wide.p05)
