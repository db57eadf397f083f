"""Checks of the test plan against the edition of the standard: targets, runs, principal positions,
spacing, long axes, cycle.

A fault of the plan is reported as a finding. The test is never refused for it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from compwright.evaluation.reading_checks import position_text, sign_text
from compwright.foundations.findings import Finding, Severity
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.positioning import PositioningTest
from compwright.records.targets import targets_text
from compwright.words.sentences import Sentence, say

#: Longest axis that is tested with n = 5 over its whole length, mm and deg.
LONG: Final = {AxisKind.LINEAR: 2000.0, AxisKind.ROTARY: 360.0}
_FIRST_EDITION: Final = "iso230-2:1988"
_EIGHT_PER_TURN: Final = ("iso230-2:2006", "iso230-2:2014")
_PRINCIPAL: Final = (0.0, 90.0, 180.0, 270.0)
#: Targets in a circle of phases see a periodic error of any phase when the smaller eigenvalue of
#: the covariance of cosine and sine is 0.5 (evenly spread); below this value one phase is seen at
#: less than a third of its size.
_PHASES_SEEN: Final = 0.05


def plan_findings(
    test: PositioningTest,
    standard: str,
    travel: tuple[float, float] | None,
    periods: Sequence[float],
    other_tests: Sequence[PositioningTest] = (),
) -> list[Finding]:
    """Return the findings about targets, cycle, travel and number of runs of a test.

    ``standard``: id of the edition, such as ``iso230-2:2014``. VDI 3441 is checked by the rules of
    ISO 230-2. ``travel``: both ends of the axis' travel, mm or deg. ``periods``: periods of known
    periodic errors, mm or deg. ``other_tests``: other tests of the same axis.
    """
    findings = [*_runs(test)]
    if test.kind is AxisKind.LINEAR:
        findings += _linear_targets(test)
    else:
        findings += _rotary_targets(test, standard)
    findings += [
        *_long_axis(test, standard, travel, other_tests),
        *_travel_covered(test, travel),
        *_spacing(test, periods),
    ]
    if test.cycle == "step":
        findings.append(Finding.of("CW-T009", "warning"))
    return findings


def approaches(test: PositioningTest) -> int:
    """Return the largest number of readings at one target in one direction."""
    return int(max((test.readings(d).max(initial=0.0) for d in Direction), default=0.0))


def _length(test: PositioningTest) -> float:
    return float(test.targets[-1] - test.targets[0])


def _is_long(test: PositioningTest, travel: tuple[float, float] | None) -> bool:
    longest = max(_length(test), travel[1] - travel[0] if travel else 0.0)
    return longest > LONG[test.kind] * (1.0 + 1e-9)


def _runs(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T001 if a direction has fewer than five approaches. A single approach
    is allowed only for axes over 2 000 mm or 360°.
    """
    counts = {d: int(test.readings(d).max(initial=0.0)) for d in Direction}
    measured = {d: n for d, n in counts.items() if n}
    if len(measured) == 1:
        only = next(iter(measured))
        one_way = [Finding.of("CW-T003", "info", direction=sign_text(only))]
    else:
        one_way = []
    if set(measured.values()) == {1} and _length(test) > LONG[test.kind]:
        return one_way
    wrong = [
        say("CW-T001.count", count=n, direction=sign_text(d)) for d, n in measured.items() if n != 5
    ]
    if not wrong:
        return one_way
    severity: Severity = "warning" if min(measured.values()) < 5 else "info"
    return [
        *one_way,
        Finding.of("CW-T001", severity, counts=wrong),
    ]


def _linear_targets(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T002 if a linear axis has fewer than five targets per metre, or fewer
    than five in all (4.3.2). Long axes with one approach have another interval.
    """
    length = _length(test)
    if length > LONG[test.kind] and approaches(test) == 1:
        return []
    needed = max(5, math.ceil(5.0 * length / 1000.0 - 1e-9))
    if test.targets.size >= needed:
        return []
    return [
        Finding.of(
            "CW-T002.linear", "warning", targets=test.targets.size, length=length, needed=needed
        )
    ]


def _rotary_targets(test: PositioningTest, standard: str) -> list[Finding]:
    """Return the findings CW-T002 and CW-T004 if a rotary axis lacks targets or principal positions
    (4.3.4; from 1997 with table 1).
    """
    length, number = _length(test), test.targets.size
    missing = [p for p in _PRINCIPAL if _within(test, p) and not _has(test.targets, p)]
    findings = []
    if standard == _FIRST_EDITION:
        others = sum(not any(_has(np.array([x]), p) for p in _PRINCIPAL) for x in test.targets)
        if others < 3:
            findings.append(Finding.of("CW-T002.principal", "warning", others=others))
    else:
        needed = 3 if length <= 90.0 else 5 if length <= 180.0 else 8
        if number < needed:
            findings.append(
                Finding.of(
                    "CW-T002.rotary", "warning", targets=number, length=length, needed=needed
                )
            )
    if missing:
        severity: Severity = "warning" if standard == _FIRST_EDITION else "info"
        named = [f"{p:g}°" for p in missing]
        findings.append(Finding.of("CW-T004", severity, positions=named))
    return findings


def _within(test: PositioningTest, principal: float) -> bool:
    """Return whether the angle ``principal``, plus any whole number of turns, is in the measured
    range.
    """
    first, last = float(test.targets[0]), float(test.targets[-1])
    return (
        first - 1e-9
        <= principal + 360.0 * math.ceil((first - principal - 1e-9) / 360.0)
        <= last + 1e-9
    )


def _has(targets: FloatArray, principal: float) -> bool:
    offset = (targets - principal + 180.0) % 360.0 - 180.0
    return bool(np.any(np.abs(offset) < 1e-6))


def _long_axis(
    test: PositioningTest,
    standard: str,
    travel: tuple[float, float] | None,
    other_tests: Sequence[PositioningTest],
) -> list[Finding]:
    """Return the finding CW-T005 if an axis over 2 000 mm or 360° lacks one of its two tests: one
    approach over the whole length, or five over 2 000 mm or 360°.

    The second test may be among ``other_tests``; then it is not missing. For a test with one
    approach, CW-T006 is returned too if its targets are too far apart.
    """
    if not _is_long(test, travel) or (test.kind is AxisKind.ROTARY and standard == _FIRST_EDITION):
        return []
    limit = "2 000 mm" if test.kind is AxisKind.LINEAR else "360°"
    findings = []
    if _is_single(test):
        if all(approaches(other) == 1 for other in other_tests):
            findings.append(Finding.of("CW-T005.repeated_missing", "info", limit=limit))
        findings += _long_interval(test, standard)
    elif _length(test) > LONG[test.kind] * (1.0 + 1e-9):
        findings.append(Finding.of("CW-T005.repeated_long", "warning", limit=limit))
    elif not any(_is_single(other) for other in other_tests):
        findings.append(Finding.of("CW-T005.whole_missing", "info", limit=limit))
    return findings


def _is_single(test: PositioningTest) -> bool:
    """Return whether this is the test of a long axis with one approach per direction."""
    return approaches(test) == 1 and _length(test) > LONG[test.kind]


def _long_interval(test: PositioningTest, standard: str) -> list[Finding]:
    """Return the finding CW-T006 if targets of a long axis are over 250 mm apart (4.3.3). Rotary
    axes need an interval of at most 45° (1997, GOST), or eight targets per turn up to 1 800° (2006,
    2014).
    """
    length, number = _length(test), test.targets.size
    if test.kind is AxisKind.LINEAR:
        mean = length / max(number - 1, 1)
        if mean <= 250.0 * (1.0 + 1e-9):
            return []
        return [Finding.of("CW-T006.linear", "warning", interval=mean)]
    findings = []
    widest = float(np.diff(test.targets).max())
    if standard in _EIGHT_PER_TURN:
        turns = length / 360.0
        if number < 8.0 * turns - 1e-9:
            findings.append(Finding.of("CW-T006.per_turn", "warning", targets=number, turns=turns))
    elif widest > 45.0 * (1.0 + 1e-9):
        findings.append(Finding.of("CW-T006.rotary", "warning", interval=widest))
    if length > 1800.0 * (1.0 + 1e-9):
        findings.append(Finding.of("CW-T006.turns", "info", length=length))
    return findings


def _travel_covered(test: PositioningTest, travel: tuple[float, float] | None) -> list[Finding]:
    """Return the finding CW-T007 if targets lie outside the travel, or more than one mean interval
    at an end of the travel has no target.

    A rotary axis of a full turn is not checked, because its angles may be counted from anywhere.
    """
    if travel is None:
        return []
    full_turn = test.kind is AxisKind.ROTARY and travel[1] - travel[0] >= 360.0 - 1e-6
    first, last = float(test.targets[0]), float(test.targets[-1])
    if not full_turn and (first < travel[0] - 1e-6 or last > travel[1] + 1e-6):
        return [
            Finding.of(
                "CW-T007.outside",
                "warning",
                first=position_text(first, test),
                last=position_text(last, test),
                travel_start=position_text(travel[0], test),
                travel_end=position_text(travel[1], test),
            )
        ]
    if _is_long(test, travel) or full_turn or test.targets.size < 2:
        return []
    interval = (last - first) / (test.targets.size - 1)
    ends = [(first - travel[0], "lower"), (travel[1] - last, "upper")]
    uncovered = [
        say("CW-T007.end", length=position_text(round(gap, 6), test), end=end)
        for gap, end in ends
        if gap > interval * (1.0 + 1e-9)
    ]
    if not uncovered:
        return []
    return [Finding.of("CW-T007.uncovered", "info", ends=uncovered)]


def _spacing(test: PositioningTest, periods: Sequence[float]) -> list[Finding]:
    """Return the finding CW-T008 if targets are equally spaced, or if their spacing hides a known
    period of the error (4.2).
    """
    if test.targets.size < 3:
        return []
    hidden = [
        Finding.of(
            "CW-T008.period",
            "warning",
            period=position_text(period, test),
            better=_targets_text(test),
        )
        for period in periods
        if _phases_seen(test.targets, period) < _PHASES_SEEN
    ]
    if hidden or periods:
        return hidden
    intervals = np.diff(test.targets)
    if intervals.max() - intervals.min() > 1e-3 * intervals.mean():
        return []
    return [
        Finding.of(
            "CW-T008.equal",
            "info",
            interval=position_text(float(intervals.mean()), test),
            better=_targets_text(test),
        )
    ]


def _targets_text(test: PositioningTest) -> Sentence:
    low, high = float(test.targets[0]), float(test.targets[-1])
    return targets_text(low, high, test.targets.size, test.kind.unit)


def _phases_seen(targets: FloatArray, period: float) -> float:
    """Return how evenly targets sample the phases of a wave of ``period``: 0 (hidden) to 0.5.

    It is the smaller eigenvalue of the covariance matrix of the cosine and sine of the phase at the
    targets.
    """
    phase = 2.0 * np.pi * targets / period
    covariance = np.cov(np.vstack([np.cos(phase), np.sin(phase)]), bias=True)
    return float(np.linalg.eigvalsh(covariance)[0])
