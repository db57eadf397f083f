"""Findings about drift within a run, which has the same effect as a reversal error that varies
along the travel.

In the standard test cycle of ISO 230-2 a run goes up through the m targets and down again: 2 m
readings at equal times. Target i (0 .. m - 1) is reading i in + and reading 2 m - 1 - i in -. An
axis that drifts by D from the first of n runs to the last moves by d = D / (n - 1) within each run.
Its reversal (mean in + minus mean in -) at target i then changes by -d (2 m - 1 - 2 i) / (2 m): by
half of d on average, by nearly d at the low end, and by nearly nothing at the high end.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.reversal_along_travel import (
    drift_within_run,
    explained_by_drift,
    reversal_curve,
    reversal_rise,
)
from compwright.planning.simulated_repeat_tests import FreshTests
from compwright.records.axis import Direction
from compwright.records.rounding import rounded_number
from compwright.words.sentences import Amount

#: A backlash value is doubted from where the drift may make out so much of it, and so much of the
#: standard deviation of one reading.
_OF_THE_REVERSAL: Final = 0.25
_OF_THE_NOISE: Final = 0.5


def drift_or_reversal(work: AxisWork, fresh: FreshTests) -> Iterator[Finding]:
    """Yield a finding if a table may contain drift of the test instead of the error of the axis.
    ``fresh``: simulated repetitions of the first test, which contain its drift.

    CW-P153 concerns the second table that the job requires. CW-P154 concerns the constant
    difference between the directions: the backlash value, or the difference of the two curves if
    the control has no backlash value.
    """
    planned, test = work.planned, work.results[0].test
    runs = min(int(np.max(test.readings(way), initial=0.0)) for way in Direction)
    if planned.fitted is None or runs < 2:
        return
    noise = fresh.draws.noise
    drift = rounded_number(np.median(noise.drift))
    if planned.fitted.mode == "bidirectional":
        yield from _second_table(work, drift, drift_within_run(test, noise))
    elif work.capacity is not None and (
        work.capacity.curves == 2 or work.capacity.backlash_quantum is not None
    ):
        along = (test.targets - noise.centre) / noise.half
        each = (drift + np.median(noise.drift_tilt) * along) / (runs - 1)
        m = test.targets.size
        waits = (2 * m - 1 - 2 * np.arange(m)) / (2 * m)
        yield from _backlash_value(work, drift, rounded_number(-float(np.mean(waits * each))))


def _second_table(work: AxisWork, drift: float, within: float) -> Iterator[Finding]:
    """Yield the finding CW-P153 if the drift ``within`` each run can explain the difference of the
    tables for + and −. ``drift``: from the first run to the last; mm or deg.
    """
    rises = reversal_rise(work.planned.estimate, work.active)
    if not explained_by_drift(rises, within):
        return
    risen, drifted, shown = _texts(work, rises, drift, within)
    yield Finding.of(
        "CW-P153", "warning", axis=work.planned.axis.name, risen=risen, drifted=drifted, shown=shown
    )


def _backlash_value(work: AxisWork, drift: float, moved: float) -> Iterator[Finding]:
    """Yield the finding CW-P154 if drift changed the mean reversal error, and so the backlash
    value, by a significant amount ``moved``. ``drift``: from the first run to the last; mm or deg.
    """
    _, reversal = reversal_curve(work.planned.estimate, work.active)
    mean = rounded_number(float(np.mean(reversal)))
    noise = work.planned.estimate.noise
    if abs(moved) < max(_OF_THE_REVERSAL * abs(mean), _OF_THE_NOISE * noise, 1e-9):
        return
    measured, drifted, shown = _texts(work, mean, drift, moved)
    yield Finding.of(
        "CW-P154",
        "warning",
        axis=work.planned.axis.name,
        measured=measured,
        drifted=drifted,
        shown=shown,
    )


def _texts(work: AxisWork, *sizes: float) -> Iterator[Amount]:
    unit = work.planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    return (Amount(one * factor, small, "+.2f") for one in sizes)
