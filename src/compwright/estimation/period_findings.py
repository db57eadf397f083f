"""Findings of a search for periods: their probability, and what to look for on the machine (odds:
Kass and Raftery, J. Am. Stat. Assoc. 90, 1995).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from compwright.estimation.period_models import PeriodSearch
from compwright.estimation.usual_periods import USUAL_PERIODS
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.targets import targets_text
from compwright.words.sentences import Sentence, say

#: A period is a usual one within this part of it.
_NEAR = 0.004
#: A period is the spacing of points within this part of it, as well as few targets tell it.
_AS_SPACED = 0.02
#: Less probable periods count in the prediction only: an axis without periods still keeps some at
#: a few per cent.
_REPORTED = 0.2


def period_findings(
    search: PeriodSearch,
    targets: FloatArray,
    kind: AxisKind,
    known: Sequence[float],
    fitted: Sequence[float],
    points: Sequence[float] = (),
) -> list[Finding]:
    """Return the findings of a search for periods, mm or deg, with readings at ``targets`` (m,).

    CW-E012: periods were found. CW-E013: periods cannot be distinguished. CW-E014: no period was
    found, or none can be found. CW-E015: some ``known`` periods are not among the ``fitted`` ones,
    because the data do not show them. ``points``: points of a table that was active, mm or deg.
    """
    unit = kind.unit
    found: list[Finding] = []
    grouped = {period for group in search.sure for period in group}
    reported = [
        each
        for each in search.found
        if each.period not in grouped and each.probability >= _REPORTED
    ]
    found += [
        Finding.of(
            "CW-E012.found",
            "info",
            period=each.period,
            unit=unit,
            probability=100 * each.probability,
            odds=_odds(each.probability),
            meaning=meaning(each.period, kind),
            nodes=_of_points(each.period, points),
        )
        for each in reported
        if each.named
    ]
    open_ = [
        say("CW-E012.period", period=each.period, unit=unit, percent=100 * each.probability)
        for each in reported
        if not each.named
    ]
    if open_:
        found.append(Finding.of("CW-E012.possible", "info", periods=open_))
    low, high = float(targets[0]), float(targets[-1])
    for group in search.sure:
        named = sorted(group, reverse=True)[:8]
        more = max(0, len(group) - 8)
        found.append(
            Finding.of(
                "CW-E013",
                "warning",
                periods=named,
                more=more,
                unit=unit,
                better=targets_text(low, high, targets.size, unit),
            )
        )
    if not reported and not search.sure and not known:
        found.append(_nothing(search, targets, unit))
    found += _left_out(known, fitted, unit)
    return found


def unseen_findings(
    unseen: Sequence[float], found: Sequence[float], kind: AxisKind
) -> list[Finding]:
    """Return the finding CW-E016 for known periods ``unseen`` (mm or deg) that the readings do not
    show, while they show other periods ``found``; an empty list without such periods.
    """
    if not unseen or not found:
        return []
    unit = kind.unit
    given, instead = ([f"{one:.5g}" for one in each] for each in (unseen, found))
    return [Finding.of("CW-E016", "warning", stated=given, unit=unit, found=instead)]


def _nothing(search: PeriodSearch, targets: FloatArray, unit: str) -> Finding:
    intervals = np.diff(targets)
    if search.curve is None:
        return Finding.of("CW-E014.few_targets", "info", targets=targets.size)
    if np.ptp(intervals) <= 1e-3 * np.mean(intervals):
        return Finding.of(
            "CW-E014.equal_spacing", "info", interval=float(np.mean(intervals)), unit=unit
        )
    probability = sum(model.probability for model in search.models if not model.periods)
    hidden = 1.0 - probability
    if hidden < 0.01:
        return Finding.of("CW-E014.unlikely", "info", probability=hidden)
    return Finding.of("CW-E014.hidden", "info", probability=100 * hidden)


def _left_out(known: Sequence[float], fitted: Sequence[float], unit: str) -> list[Finding]:
    if len(fitted) == len(known) or not fitted:
        return []
    return [
        Finding.of(
            "CW-E015", "info", known=len(known), fitted=len(fitted), periods=fitted, unit=unit
        )
    ]


def _of_points(period: float, points: Sequence[float]) -> float | None:
    """Return the interval of an active compensation table with points ``points`` if ``period``
    equals this interval, else None.
    """
    spacing = float(np.median(np.diff(points))) if len(points) > 2 else 0.0
    if abs(period - spacing) > _AS_SPACED * period:
        return None
    return spacing


def _odds(probability: float) -> Sentence:
    if probability > 0.999:
        return say("odds.above_1000")
    if probability >= 0.5:
        return say("odds.to_1", odds=probability / (1.0 - probability))
    return say("odds.1_to", odds=(1.0 - probability) / probability)


def meaning(period: float, kind: AxisKind) -> Sentence:
    """Return the possible causes of an error with this ``period`` (mm or deg)."""
    unit = kind.unit
    once, twice = (
        [
            say("period.cause", cause=each.cause, number=each.number)
            for each in USUAL_PERIODS[kind]
            if abs(each.size - times * period) <= _NEAR * times * period
            and each.cause != "half_lead"
        ]
        for times in (1, 2)
    )
    if once or twice:
        return say(
            "period.usual", period=period, double=2.0 * period, unit=unit, once=once, twice=twice
        )
    if kind is AxisKind.ROTARY:
        return say("period.unusual_division", parts=360.0 / period)
    return say("period.unusual_lead")
