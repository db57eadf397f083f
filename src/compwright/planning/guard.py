"""The guard band of a decision about a test that is to come (ISO 14253-1): the expanded uncertainty
of its parameters, with what the tests before it have put into the table.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from compwright.evaluation.uncertainty import expanded_uncertainties
from compwright.planning.declared import slope_after, slope_in_table
from compwright.planning.fresh import Like
from compwright.planning.outlook import predict_same_targets
from compwright.planning.wanted import MeasuredError, with_change
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
    """Return U (mm or deg, k = 2) of the parameters that a fresh test like ``result``, the one at
    ``place`` of its axis, will have after a ``change`` of the correction; None where the job
    declares nothing, and for VDI 3441.

    It is the U of the measured test as the change leaves it (`expanded_uncertainties`), because U
    depends on the curve that is left. Temperature, misalignment and set-up are drawn twice: for the
    test on which the table stands, whose error acts in the machine from then on, and for the fresh
    one. The instrument and the coefficient of expansion are the same in both: what they do wrong
    the table has, and the fresh test does not show it; they count once. U is at least by how much
    the declared slopes of both tests, in the band, move its ends: a guarded decision accepts and
    rejects nothing that a simple one leaves open.
    """
    test, kind = result.test, result.test.kind
    budget = job.budget(kind)
    if budget is None:
        return None
    if kind is AxisKind.ROTARY:  # of angles the set-up is no slope: both draws of it lie beside
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
        predict_same_targets(result, posterior, change, planned.axis, Like(place, std))
        for std in (0.0, slope)
    )
    return {
        name: replace(each, U=max(each.U, _moved(still[name], sloped[name])))
        for name, each in stated.items()
    }


def _moved(narrow: Quantiles, wide: Quantiles) -> float:
    """Return by how much ``wide`` reaches beyond ``narrow``, at the end where it is more."""
    return max(wide.p95 - narrow.p95, narrow.p05 - wide.p05)
