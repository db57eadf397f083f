"""Check whether the readings of a test fit the sign, the unit and the active table that file and
job state.

The readings as stated are compared with the same readings under another assumption: opposite sign,
+ and - exchanged, targets in the opposite order, positions counted in the opposite direction, or
the table of the control not active.

From each assumption follows an error of the axis, and the assumption is as probable as this error.
Errors of axes are smooth. If the error jumps from target to target, these must be jumps of the
active table. If the targets have random parts (ISO 230-2:1988, 4.3.2), their deviations must agree
with the error at these positions.

Four tables of five are assumed to be made for their axis: the error is the opposite of the table
times a factor of 1 ± 0.25. Half of these tables also reproduce the jumps (periods, wear), the other
half only the smooth part. For the fifth table the factor is any number around 0. Therefore flat
readings with an active table are no doubt: a good table leaves them.

Without a table, the error is equally smooth for every sign and direction. Such tests are not judged
here; `evaluation.plausibility` judges their reversal.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.likelihood import ScaledCurve, log_likelihood
from compwright.estimation.model import Travel
from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.copied_runs import copied_run_findings
from compwright.evaluation.plausibility import reversal_above_zero
from compwright.foundations.findings import Finding
from compwright.planning.consistent_tests import active_at
from compwright.planning.mirror_image import mirror_image_doubts
from compwright.planning.reading_interpretations import (
    ActiveAt,
    Interpretation,
    InterpretedTest,
    add_to_readings,
    reading_interpretations,
)
from compwright.records.axis import Axis
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.result import PositioningResult
from compwright.records.rounding import LOGARITHM, rounded_number
from compwright.words.sentences import say

#: How much less usual than a test as stated each other way of reading is: a weak prior.
_PRIOR: Final[Mapping[Interpretation, float]] = {
    "stated": 0.88,
    "off": 0.05,
    "sign": 0.02,
    "directions": 0.02,
    "order": 0.015,
    "against": 0.015,
}
#: A test is doubted where it is as stated with less than this probability.
_DOUBTED: Final = 0.2
#: Other ways of reading that are named.
_NAMED: Final = 0.1
#: Standard deviation of the factor of a table, about 1 where it was made for this error, about 0
#: where it was not; and the share of the cases: made for all of it, for its smooth part, for none.
_MADE_FOR_IT: Final = 0.25
_ANYTHING: Final = 1.0
_SHARES: Final = (0.4, 0.4, 0.2)
#: Fewest targets of a test that is judged.
_FEWEST: Final = 6
#: Largest ratio that is reported: beyond, what the model leaves out decides.
_MOST: Final = 1e6


def reading_doubts(
    tests: Sequence[PlannedTest],
    observed: Sequence[ObservedTest],
    axis: Axis,
    states: Mapping[str, ControlState],
) -> tuple[Finding, ...]:
    """Return the doubts about the tests of an axis: a mirror image of the active table (CW-P161),
    or another sign, unit or direction (CW-P160). ``observed``: the same tests, each with its active
    correction subtracted.

    A test with the doubt CW-P161 gets no doubt CW-P160.
    """
    mirrored = dict(mirror_image_doubts(tests, observed, axis, states))
    known = states if tests[0].measured_in in states else {}
    misread = (
        finding
        for place, (planned, bare) in enumerate(zip(tests, observed, strict=True))
        if place not in mirrored
        for finding in misreading_doubts(
            # Copied runs tell nothing of the noise: it is inferred with the error.
            replace(bare, noise=None) if copied_run_findings(planned.test) else bare,
            axis,
            active_at(planned, axis, known),
        )
    )
    return (*mirrored.values(), *misread)


def with_known_backlash(result: PositioningResult, bare: ObservedTest) -> PositioningResult:
    """Return the result with CW-T032 (mean reversal above zero) reduced to information, if the
    active backlash value explains it: ``bare``, the test with its active correction subtracted,
    does not show it.
    """
    if reversal_above_zero(bare.test):
        return result
    findings = tuple(
        replace(
            finding,
            severity="info",
            sentence=say("backlash_compensation_larger", finding=finding.sentence),
        )
        if finding.code == "CW-T032"
        else finding
        for finding in result.findings
    )
    return replace(result, findings=findings)


def misreading_doubts(
    bare: ObservedTest, axis: Axis, active: ActiveAt | None
) -> tuple[Finding, ...]:
    """Return the doubt CW-P160, with the odds, if the readings fit another sign or unit far better
    than the stated one; an empty tuple otherwise. ``bare``: the test with its ``active`` correction
    (mm or deg, None: unknown) subtracted.
    """
    if bare.test.targets.size < _FEWEST:
        return ()
    ways = reading_interpretations(bare, axis, active)
    if len(ways) < 2:
        return ()
    logs = {
        reading.way: rounded_number(_log_likelihood(reading, axis), LOGARITHM) for reading in ways
    }
    return _doubt(logs, bare.test.name)


def _log_likelihood(reading: InterpretedTest, axis: Axis) -> float:
    travel, periods = Travel(*axis.travel, axis.modulo), axis.screw_pitch
    if reading.table is None or reading.smooth is None:
        return log_likelihood(reading.error, travel, periods)
    whole, smooth = reading.table, reading.smooth
    cases = (
        (add_to_readings(reading.error, whole), ScaledCurve(*whole, _MADE_FOR_IT)),
        (add_to_readings(reading.error, smooth), ScaledCurve(*smooth, _MADE_FOR_IT)),
        (reading.error, ScaledCurve(*smooth, _ANYTHING)),
    )
    parts = [
        math.log(share) + log_likelihood(error, travel, periods, shape)
        for share, (error, shape) in zip(_SHARES, cases, strict=True)
    ]
    return float(np.logaddexp.reduce(parts))


def _doubt(logs: Mapping[Interpretation, float], name: str) -> tuple[Finding, ...]:
    priors = {way: math.log(_PRIOR[way]) + value for way, value in logs.items()}
    whole = float(np.logaddexp.reduce(np.array(list(priors.values()))))
    probability = {way: math.exp(value - whole) for way, value in priors.items()}
    if probability["stated"] > _DOUBTED:
        return ()
    others = sorted(
        (way for way in probability if way != "stated" and probability[way] >= _NAMED),
        key=lambda way: -probability[way],
    )
    ratios = {way: math.exp(min(logs[way] - logs["stated"], math.log(_MOST))) for way in others}
    ways = [say("CW-P160.way", way=way, odds=ratio) for way, ratio in ratios.items()]
    checks = [say("CW-P160.check", way=way) for way in others]
    return (Finding.of("CW-P160", "warning", test=name, ways=ways, checks=checks),)
