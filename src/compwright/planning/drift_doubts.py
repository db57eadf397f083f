"""Findings about drift within a run, which has the same effect as a reversal error that varies
along the travel.

A run goes up through the m targets and down again (ISO 230-2, standard test cycle): 2 m readings at
equal times, target i (0 .. m - 1) in + as number i, in - as number 2 m - 1 - i. An axis that drifts
by D from the first of n runs to the last moves by D / (n - 1) within each. Its reversal (mean in +
minus mean in -) then changes by -(2 m - 1 - 2 i) / (2 m) of that: one half on average, nearly all
of it at the low end, nearly nothing at the high end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.predicted_gain import judged_parameter
from compwright.planning.reversal_along_travel import (
    drift_within_run,
    explained_by_drift,
    reversal_curve,
    reversal_rise,
)
from compwright.planning.simulated_repeat_tests import FreshTests, generator
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import Direction
from compwright.records.rounding import rounded_number
from compwright.words.sentences import Amount

#: A backlash value is doubted from where the drift may make out so much of it, and so much of the
#: standard deviation of one reading.
_OF_THE_REVERSAL: Final = 0.25
_OF_THE_NOISE: Final = 0.5
#: A drift is there from this probability; a change of the parameter counts from this part of it.
_CERTAIN: Final = 0.9
_MATTERS: Final = 0.1


def drift_or_reversal(work: AxisWork, fresh: FreshTests) -> Iterator[Finding]:
    """Yield a finding if a table may contain drift of the test instead of the error of the axis.

    CW-P153: the second table that the job requires; CW-P154: the constant between the directions,
    which is the backlash value, or that of two curves where the control has none.
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


def drift_of_one_test(work: AxisWork, new: Correction, fresh: FreshTests) -> Iterator[Finding]:
    """Yield the finding CW-P165 if only a second test can show whether the drift of the first test
    is repeated.
    """
    noise, name = fresh.draws.noise, judged_parameter(work.results[0])
    certain = float(np.mean(noise.drift != 0.0)) >= _CERTAIN
    if name is None or not certain or len(work.posterior.alike) != 1:
        return
    result = work.results[0].test
    share = generator(result.axis, result.name, "another day").standard_normal(noise.count)
    other = replace(noise, drift=share * noise.drift, drift_tilt=share * noise.drift_tilt)
    change = difference(new, work.active)
    same = fresh.quantiles(change, only=name)[name]
    apart = fresh.with_noise(other).quantiles(change, only=name)[name]
    if abs(same.p05 - apart.p05) < _MATTERS * abs(same.median):
        return
    axis = work.planned.axis
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    yield Finding.of(
        "CW-P165",
        "info",
        axis=axis.name,
        drift=Amount(rounded_number(np.median(np.abs(noise.drift))) * factor, unit),
        parameter=name,
        low=same.p05 * factor,
        high=same.p95 * factor,
        least=apart.p05 * factor,
        most=apart.p95 * factor,
        unit=unit,
    )


def _second_table(work: AxisWork, drift: float, within: float) -> Iterator[Finding]:
    """Yield the finding CW-P153 if the difference of the tables for + and − may come from drift.

    ``drift`` from the first run to the last, ``within`` a run; mm or deg.
    """
    rises = reversal_rise(work.planned.estimate, work.active)
    if not explained_by_drift(rises, within):
        return
    risen, drifted, shown = _texts(work, rises, drift, within)
    yield Finding.of(
        "CW-P153", "warning", axis=work.planned.axis.name, risen=risen, drifted=drifted, shown=shown
    )


def _backlash_value(work: AxisWork, drift: float, moved: float) -> Iterator[Finding]:
    """Yield the finding CW-P154 if drift may have changed the backlash value.

    ``drift`` from the first run to the last, by which the mean reversal is ``moved``; mm or deg.
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
