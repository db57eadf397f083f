"""Checks of the readings: missing, traverses of zeros, drift from run to run, deviating runs, and
outliers.

With n = 5 no reading can be further than 1.789 s from its own mean. A limit of 3 s would therefore
never be exceeded. Suspect readings are found by medians that are pooled over the targets. No
reading is removed: each finding shows the result with and without the suspect readings.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import permutations
from typing import Final

import numpy as np

from compwright.evaluation.residuals import pooled_residuals, robust_scale, run_medians
from compwright.evaluation.valid_readings import (
    BY_CHANCE,
    chance_of_zero,
    keep_readings,
    outlying_readings,
    without_readings,
)
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest
from compwright.words.sentences import Amount, Sentence, say

#: Returns one sentence that compares the result with and without some readings; "" where nothing
#: can be compared.
Compare = Callable[[PositioningTest], Sentence | None]

#: A traverse: its direction and its column among the readings.
Traverse = tuple[Direction, int]

#: Runs in random order look ordered with this chance at most before it is called a drift; 2/5! of
#: five runs is 1/60. Simulated with five runs, this calls 1.3 % of tests with independent readings
#: at 11 targets a drift, 0.2 % at 41, and 1.1 to 2 % where whole runs move at random.
DRIFT_CHANCE: Final = 0.02
_RANDOM_ORDERS: Final = 20_000
#: Of more runs than this no orders are tried: they would fill the memory.
_MOST_ORDERED: Final = 100
#: Most runs that are named one by one, the farthest ones.
_MOST_TRAVERSES: Final = 20
#: A traverse is suspect when its median shift exceeds so many robust standard deviations of a
#: reading. The medians of sound traverses seldom reach one of them; shifts of whole runs that are
#: themselves random must not be called suspect one by one
#: (tests/evaluation/test_evaluation_readings.py holds both rates).
TRAVERSE_LIMIT: Final = 5.0
#: Ends of the travel, in root mean squares of evenly spaced places about its middle.
_STEEPEST: Final = math.sqrt(3.0)
_SHOWN: Final = 5
#: Scatter below this is rounding of binary numbers, not a measurement: 1 pm, 1e-9 deg.
_ROUNDING: Final = 1e-9
_BOTH: Final = (Direction.POSITIVE, Direction.NEGATIVE)


def text_of(value: float, test: PositioningTest) -> Amount:
    """Return a deviation (mm or deg) as text in µm or arcsec."""
    outside = float(value * outside_factor(test.kind.unit))
    return Amount(outside, unit_text(test), ".2f" if abs(outside) >= 1.0 else ".3f")


def signed_text(value: float, test: PositioningTest) -> Amount:
    """Return a deviation (mm or deg) as text in µm or arcsec, with its sign."""
    shown = text_of(value, test)
    return replace(shown, form=f"+{shown.form}") if value > 0 else shown


def unit_text(test: PositioningTest) -> str:
    """Return the unit in which deviations are shown to the user."""
    return "µm" if test.kind.unit == "mm" else "arcsec"


def position_text(position: float, test: PositioningTest) -> Amount:
    """Return a target position with its unit."""
    return Amount(float(position), test.kind.unit, ".10g")


def sign_text(direction: Direction) -> str:
    """Return the approach direction as text, + or −."""
    return "+" if direction is Direction.POSITIVE else "−"


def _run_number(test: PositioningTest, direction: Direction, column: int) -> int:
    runs = test.runs_positive if direction is Direction.POSITIVE else test.runs_negative
    return runs[column] if column < len(runs) else column + 1


def reading_findings(
    test: PositioningTest, compare: Compare, reported: Collection[str] = ()
) -> list[Finding]:
    """Return all findings about the readings of ``test``. ``compare``: a function that returns the
    parameters with and without some readings as text. ``reported``: codes of findings that the
    noise estimate reports.

    If ``reported`` contains CW-T012, drift is not reported again. If it contains CW-T014, the
    suspect readings are not listed again; only the result with and without them is reported.
    """
    return [
        *missing_reading_findings(test),
        *zero_traverse_findings(test),
        *([] if "CW-T012" in reported else drift_findings(test)),
        *suspect_traverse_findings(test, compare),
        *suspect_reading_findings(test, compare, reported="CW-T014" in reported),
    ]


def missing_reading_findings(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T010 if targets of one direction have different numbers of readings."""
    parts = []
    for direction in _BOTH:
        number = test.readings(direction)
        measured = number[number > 0]
        if measured.size and measured.min() < number.max():
            few = [
                position_text(x, test)
                for x, n in zip(test.targets, number, strict=True)
                if 0 < n < number.max()
            ]
            parts.append(
                say(
                    "CW-T010.direction",
                    direction=sign_text(direction),
                    fewer=len(few),
                    targets=number.size,
                    at=few[:_SHOWN],
                    more=len(few) > _SHOWN,
                )
            )
    if not parts:
        return []
    return [Finding.of("CW-T010", "warning", where=parts)]


def zero_traverse_findings(test: PositioningTest) -> list[Finding]:
    """Return the findings CW-T011 about readings that are exactly zero.

    There is one finding for each traverse of two targets or more whose readings are all zero. One
    finding reports all other traverses that contain too many zeros in a row. If reading the file
    has already given CW-R010, traverses of zeros are not reported again.
    """
    reported = any(finding.code == "CW-R010" for finding in test.findings)
    findings, filled = [], []
    chance = chance_of_zero(test)
    for direction in _BOTH:
        deviations = test.deviations(direction)
        for column in range(deviations.shape[1]):
            values = deviations[:, column][np.isfinite(deviations[:, column])]
            name = say(
                "in_direction",
                value=_run_number(test, direction, column),
                direction=sign_text(direction),
            )
            if values.size > 1 and not np.any(values):
                findings += (
                    []
                    if reported
                    else [
                        Finding.of(
                            "CW-T011.traverse",
                            "warning",
                            run=_run_number(test, direction, column),
                            direction=sign_text(direction),
                            targets=values.size,
                        )
                    ]
                )
            elif (
                row := _longest_row_of_zeros(values)
            ) > 1 and values.size * chance**row < BY_CHANCE:
                filled.append((name, row))
    if filled:
        findings.append(
            Finding.of(
                "CW-T011.rows",
                "warning",
                targets=max(row for _, row in filled),
                traverses=[name for name, _ in filled[:_SHOWN]],
                more=max(0, len(filled) - _SHOWN),
            )
        )
    return findings


def _longest_row_of_zeros(values: FloatArray) -> int:
    longest = row = 0
    for value in values:
        row = row + 1 if value == 0.0 else 0
        longest = max(longest, row)
    return longest


def drift_findings(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T012 if the deviations at the targets drift from run to run.

    This is a drift between successive approaches to any particular target position (ISO 230-2:1997,
    3.3), pooled over the targets. At least five runs are needed. A drift smaller than the robust
    standard deviation of a reading is not reported.

    Two drifts are computed for each direction. One is the same at all targets: the zero point
    moves. The other is proportional to the place along the travel: expansion, which may cancel in
    the mean. Each reading counts by its distance from the median of its target. Distances are
    clipped at three robust standard deviations, so that one bad reading cannot decide. The
    statistic is the sum of the squares of these four drifts. Its significance follows from all
    orders of the runs; both directions always have the same order. Shifts of whole runs in random
    order therefore raise an alarm no more often than `DRIFT_CHANCE`.
    """
    residuals, scale = pooled_residuals(test)
    along = _along(test.targets)
    scores = {
        direction: _run_scores(residual, along, scale)
        for direction, residual in zip(_BOTH, residuals, strict=True)
        if residual.shape[1] >= 5 and np.any(np.isfinite(residual))
    }
    if test.cycle == "step" or not scores:
        return []
    runs = min(score.shape[1] for score in scores.values())
    table = np.vstack([score[:, :runs] for score in scores.values()])
    centred: FloatArray = np.arange(runs, dtype=np.float64) - 0.5 * (runs - 1)
    chance = _chance(table, centred)
    sizes = table @ centred * (runs - 1) / (centred @ centred)
    means, growths = sizes[0::2], sizes[1::2] * _STEEPEST
    if chance > DRIFT_CHANCE or max(np.abs(means).max(), np.abs(growths).max()) < scale:
        return []
    return [
        Finding.of(
            "CW-T012",
            "warning",
            how=_drift_sentence(test, scores, means, growths),
            chance=100.0 * chance,
        )
    ]


def _drift_sentence(
    test: PositioningTest,
    directions: Iterable[Direction],
    means: FloatArray,
    growths: FloatArray,
) -> Sentence:
    """Return the drift of each direction as text: its mean from ``means`` or, if ``growths``
    (variation of the drift along the travel) exceed the means, the drift at both ends of the
    travel.
    """
    if np.abs(growths).max() <= np.abs(means).max():
        each = [
            say(
                "in_direction",
                value=signed_text(float(mean), test),
                direction=sign_text(direction),
            )
            for direction, mean in zip(directions, means, strict=True)
        ]
        return say("CW-T012.mean", drifts=each)
    each = [
        say(
            "CW-T012.ends",
            lower=signed_text(float(mean - growth), test),
            upper=signed_text(float(mean + growth), test),
            direction=sign_text(direction),
        )
        for direction, mean, growth in zip(directions, means, growths, strict=True)
    ]
    return say("CW-T012.growing", drifts=each)


def _along(targets: FloatArray) -> FloatArray:
    """Return the position of each target (m,), scaled to mean 0 and mean square 1."""
    away = targets - np.mean(targets)
    spread: FloatArray = away / max(float(np.sqrt(np.mean(away**2))), _ROUNDING)
    return spread


def _chance(table: FloatArray, centred: FloatArray) -> float:
    """Return the probability that runs in random order show at least the measured drift. ``table``:
    drift scores (rows) of each run (column); ``centred``: numbers of the runs minus their mean.

    With up to 100 runs, the drifts are computed for many orders of the runs. With more runs, the
    drifts in random order are taken as normal. Their covariance is the covariance of the scores
    times the sum of squares of ``centred``. The statistic is then a sum of squares of normal
    values.
    """
    runs = centred.size
    if runs > _MOST_ORDERED:
        away = table - table.mean(axis=1, keepdims=True)
        variances = np.linalg.eigvalsh(away @ away.T) * (centred @ centred) / (runs - 1)
        draws = np.random.default_rng(0).standard_normal((_RANDOM_ORDERS, len(table)))
        statistic = draws**2 @ np.maximum(variances, 0.0)
    else:
        statistic = ((table @ _orders(runs).T) ** 2).sum(axis=0)
    observed = float(((table @ centred) ** 2).sum())
    at_least = float(np.mean(statistic >= observed * (1.0 - 1e-9)))
    return max(at_least, 1.0 / statistic.size)


@lru_cache(maxsize=8)
def _orders(runs: int) -> FloatArray:
    """Return orders of the runs, as offsets from the middle: all orders, or 20 000 random orders if
    there are many runs.
    """
    centred: FloatArray = np.arange(runs, dtype=np.float64) - 0.5 * (runs - 1)
    if runs <= 7:
        orders = np.array(list(permutations(centred)))
    else:
        orders = np.random.default_rng(0).permuted(np.tile(centred, (_RANDOM_ORDERS, 1)), axis=1)
    orders.flags.writeable = False  # kept for the next test
    return orders


def suspect_traverse_findings(test: PositioningTest, compare: Compare) -> list[Finding]:
    """Return the finding CW-T013 for each run whose readings in one or both directions deviate as a
    whole, with the text of ``compare`` about the parameters without them. At least three runs are
    needed.
    """
    shifts = _shifts(test)
    suspect = _suspect(test, shifts)
    farthest = sorted(suspect, key=lambda run: -max(abs(shifts[each]) for each in suspect[run]))
    findings = []
    for run in sorted(farthest[:_MOST_TRAVERSES]):
        traverses = suspect[run]
        changed = _without(test, traverses)
        both = len(traverses) > 1
        offs = [
            say("in_direction", value=signed_text(shifts[each], test), direction=sign_text(each[0]))
            for each in traverses
        ]
        scatter, compared = text_of(pooled_residuals(changed)[1], test), compare(changed)
        findings.append(
            Finding.of(
                "CW-T013.run", "warning", run=run, off=offs, scatter=scatter, compared=compared
            )
            if both
            else Finding.of(
                "CW-T013.traverse",
                "warning",
                run=run,
                direction=sign_text(traverses[0][0]),
                off=signed_text(shifts[traverses[0]], test),
                scatter=scatter,
                compared=compared,
            )
        )
    if len(farthest) > _MOST_TRAVERSES:
        findings.append(Finding.of("CW-T013.more", "warning", more=len(farthest) - _MOST_TRAVERSES))
    return findings


def _shifts(test: PositioningTest) -> dict[Traverse, float]:
    """Return the offset of each traverse from the other traverses of its direction (median over
    targets; mm or deg).

    Only directions with three runs or more are included.
    """
    shifts: dict[Traverse, float] = {}
    for direction, residual in zip(_BOTH, pooled_residuals(test)[0], strict=True):
        if residual.shape[1] >= 3:
            medians = np.nan_to_num(run_medians(residual)).ravel().tolist()
            shifts |= {(direction, column): shift for column, shift in enumerate(medians)}
    return shifts


def _suspect(test: PositioningTest, shifts: Mapping[Traverse, float]) -> dict[int, list[Traverse]]:
    """Return, by number of the run, the traverses of each run whose offset from the other traverses
    is too large. ``shifts``: these offsets (`_shifts`).

    Each run is compared with the scatter of the readings in the other runs. Otherwise an outlying
    run would increase the scatter that it is compared with.
    """
    residuals, scale = pooled_residuals(test)
    within = robust_scale([each - run_medians(each) for each in residuals], test)
    by_run: dict[int, list[Traverse]] = {}
    for traverse, shift in shifts.items():
        if abs(shift) > TRAVERSE_LIMIT * within > 0.0:
            by_run.setdefault(_run_number(test, *traverse), []).append(traverse)
    few = len(by_run) <= _MOST_TRAVERSES
    suspect = {}
    for run, traverses in by_run.items():
        others = pooled_residuals(_without(test, traverses))[1] if few else scale
        far = [each for each in traverses if abs(shifts[each]) > TRAVERSE_LIMIT * others]
        if far:
            suspect[run] = far
    return suspect


def _without(test: PositioningTest, traverses: Iterable[Traverse]) -> PositioningTest:
    """Return ``test`` without the readings of the given traverses."""
    for direction, column in traverses:
        keep = np.ones(test.deviations(direction).shape, dtype=bool)
        keep[:, column] = False
        test = keep_readings(test, direction, keep)
    return test


def suspect_reading_findings(
    test: PositioningTest, compare: Compare, *, reported: bool = False
) -> list[Finding]:
    """Return one finding (CW-T014) for all readings that are outliers both at their target and in
    their traverse. At least four readings per target are needed. If ``reported`` elsewhere, it
    contains only what ``compare`` states: the parameters with and without these readings.
    """
    found, scale = outlying_readings(test)
    if not found:
        return []
    changed = without_readings(test, found)
    if reported:
        compared = compare(changed)
        return (
            [Finding.of("CW-T014.compared", "info", readings=len(found), compared=compared)]
            if compared
            else []
        )
    where = [
        say(
            "reading_off",
            traverse=say("traverse", run=_run_number(test, d, j), direction=sign_text(d)),
            target=position_text(float(test.targets[i]), test),
            off=signed_text(off, test),
        )
        for off, d, i, j in found[:_SHOWN]
    ]
    return [
        Finding.of(
            "CW-T014.listed",
            "warning",
            readings=len(found),
            where=where,
            more=max(0, len(found) - _SHOWN),
            scatter=text_of(scale, test),
            compared=compare(changed),
        )
    ]


def _run_scores(residual: FloatArray, along: FloatArray, scale: float) -> FloatArray:
    """Return two drift scores of each run, (2, n): the mean residual, and the mean of residual
    times ``along``. Both are 0 for a run without readings.

    ``residual`` (m, n): readings minus the median of their target. ``along`` (m,): scaled place of
    the targets along the travel. Residuals are clipped at three times ``scale``.
    """
    clipped = np.clip(np.nan_to_num(residual), -3.0 * scale, 3.0 * scale)
    number = np.maximum(np.isfinite(residual).sum(axis=0), 1)
    scores: FloatArray = np.stack([np.ones_like(along), along]) @ clipped / number
    return scores
