"""Findings about noise that is more than plain scatter: its size, its probability, the next step.

The odds are posterior odds, averaged over the sampler's conditional probabilities (Gelfand and
Smith, J. Am. Stat. Assoc. 85, 1990). An effect is reported only if its odds are at least `CLEAR`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np

from compwright.estimation.noise_chain import NoiseState
from compwright.estimation.noise_patterns import DRIFT, DRIFT_TILT, OFFSET, RATES, TILT
from compwright.estimation.noise_readings import CellReadings, traverse_effects
from compwright.estimation.noise_spread import spread_shapes
from compwright.estimation.noise_tails import KINDS, OUTLIERS, STUDENT
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import FloatArray
from compwright.records.noise import INDEPENDENT, RUNS, WALK, WAVE, IndexArray
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.words.sentences import Amount, Sentence, say

#: Least odds of a finding: "strong" evidence (Kass and Raftery, J. Am. Stat. Assoc. 90, 1995,
#: section 3.2).
CLEAR: Final = 20.0
#: Odds above this rest on approximations and are reported as "over 1000".
_SURE: Final = 1000.0
#: Parts smaller than this, in standard deviations of a reading, change s by less than a tenth.
_MATTERS: Final = 0.4
#: Below this share of moves the others are the rule.
_SELDOM: Final = 0.5
_SHOWN: Final = 5
#: So many outliers with a place or a traverse in common are no chance.
_TOGETHER: Final = 3
_PATTERNS: Final = {INDEPENDENT: "traverses", RUNS: "runs", WALK: "walk", WAVE: "wave"}


def noise_findings(
    test: PositioningTest, readings: CellReadings, draws: Sequence[NoiseState], step: float
) -> tuple[Finding, ...]:
    """Return a finding for each effect in the noise of ``test`` that the ``draws`` clearly show.
    White noise gives no finding. ``step``: resolution of the instrument, mm or deg, 0 where it is
    negligible.
    """
    return (
        *_coarse(test, readings, step),
        *_drifts(test, draws),
        *_traverses(test, draws),
        *_tails(test, readings, draws),
        *_places(test, readings, draws),
    )


def _coarse(test: PositioningTest, readings: CellReadings, step: float) -> Iterator[Finding]:
    if not step:
        return
    counts = np.sum(readings.there, axis=1)
    means = np.sum(readings.values, axis=1) / np.maximum(counts, 1)
    about = np.abs(readings.values - means[:, np.newaxis])[readings.there]
    repeated = not np.any(about > SAME_READING)
    yield Finding.of(
        "CW-E029", "warning" if repeated else "info", step=_text(step, test), repeated=repeated
    )


def _drifts(test: PositioningTest, draws: Sequence[NoiseState]) -> Iterator[Finding]:
    sigma = _middle([draw.sigma for draw in draws])
    flattens = float(np.mean([RATES[draw.rate] > 0.0 for draw in draws])) > 0.5
    for kind in (DRIFT, DRIFT_TILT):
        size = _middle([draw.drift[kind - DRIFT] for draw in draws])
        odds = _odds(np.mean([draw.absent[kind] for draw in draws]))
        if odds < CLEAR or abs(size) < sigma:
            continue
        shown_odds = _odds_text(odds)
        if kind == DRIFT:
            yield Finding.of(
                "CW-E020",
                "warning",
                drift=_signed(size, test),
                odds=shown_odds,
                flattens=flattens,
                alone=True,
            )
        else:
            yield Finding.of(
                "CW-E021",
                "warning",
                lower=_signed(-size, test),
                upper=_signed(size, test),
                odds=shown_odds,
                flattens=flattens,
                alone=True,
            )


def _traverses(test: PositioningTest, draws: Sequence[NoiseState]) -> Iterator[Finding]:
    sigma = _middle([draw.sigma for draw in draws])
    offset, tilt = (_middle([draw.size[kind] for draw in draws]) for kind in (OFFSET, TILT))
    odds = _odds(np.mean([draw.absent[OFFSET] for draw in draws]))
    drifts = _odds(np.mean([draw.absent[DRIFT] for draw in draws])) >= CLEAR
    either = _odds(np.mean([not draw.size[[OFFSET, DRIFT]].any() for draw in draws]))
    if odds >= CLEAR and offset >= _MATTERS * sigma:
        pattern = int(np.argmax(np.bincount([draw.pattern for draw in draws])))
        alike = [draw for draw in draws if draw.pattern == pattern]
        seldom = _middle([draw.share for draw in alike]) < _SELDOM
        where = _moved(test, alike) if seldom and pattern == INDEPENDENT else ()
        yield Finding.of(
            "CW-E022.seldom" if seldom else "CW-E022.all",
            "warning",
            pattern=_PATTERNS[pattern],
            size=_text(offset, test),
            odds=_odds_text(odds),
            where=where,
        )
    elif either >= CLEAR > odds and not drifts:
        yield Finding.of("CW-E022.either", "warning", odds=_odds_text(either))
    odds = _odds(np.mean([draw.absent[TILT] for draw in draws]))
    if odds >= CLEAR and tilt >= _MATTERS * sigma:
        yield Finding.of("CW-E023", "warning", tilt=_text(tilt, test), odds=_odds_text(odds))


def _moved(test: PositioningTest, draws: Sequence[NoiseState]) -> list[Sentence]:
    """Return the names of the traverses that are shifted in most of the draws."""
    m, runs = test.targets.size, draws[0].moved.size // 2
    moved = np.flatnonzero(np.mean([draw.moved for draw in draws], axis=0) > 0.5)
    return [_traverse(test, m * int(k // runs), int(k % runs)) for k in moved]


def _tails(
    test: PositioningTest, readings: CellReadings, draws: Sequence[NoiseState]
) -> Iterator[Finding]:
    chances = np.mean([draw.tail_chances for draw in draws], axis=0)
    student, spoilt = (float(np.sum(chances[kind == KINDS])) for kind in (STUDENT, OUTLIERS))
    odds = _odds(float(np.sum(chances)) - student - spoilt)
    if odds < CLEAR:
        return
    taken = np.mean([draw.outlier for draw in draws], axis=0) / max(spoilt, 1e-9)
    cells, runs = np.nonzero(taken > 0.5)
    if spoilt > student and cells.size:
        off = np.median([_errors(readings, draw) for draw in draws], axis=0)
        order = np.argsort(-np.round(np.abs(off[cells, runs]), 9), kind="stable")
        places = _at_places(test, readings, cells)
        yield Finding.of(
            "CW-E032" if places.size else "CW-E024",
            "warning",
            outliers=cells.size,
            readings=np.count_nonzero(readings.there),
            where=[
                _where(test, int(cells[k]), int(runs[k]), float(off[cells[k], runs[k]]))
                for k in order[:_SHOWN]
            ],
            more=max(0, cells.size - _SHOWN),
            odds=_odds_text(odds),
            cause=_cause(test, places, cells, runs),
        )
    else:
        yield Finding.of("CW-E025", "info", odds=_odds_text(odds))


def _at_places(test: PositioningTest, readings: CellReadings, cells: IndexArray) -> IndexArray:
    """Return the numbers of the targets at which all outliers ``cells`` (k,) occur, or no numbers
    if they are single outliers. Each of these targets must have more than one outlier; there must
    be three outliers in all, or at each target half of its readings.
    """
    m = test.targets.size
    places, counts = np.unique(cells % m, return_counts=True)
    there = np.sum(np.sum(readings.there, axis=1).reshape(-1, m), axis=0)[places]
    several = np.all(counts > 1) and (cells.size >= _TOGETHER or np.all(2 * counts >= there))
    return places if several else places[:0]


def _cause(
    test: PositioningTest, places: IndexArray, cells: IndexArray, runs: IndexArray
) -> Sentence:
    """Return a sentence about the cause of outliers in the given ``cells`` (targets of a direction)
    and ``runs``: a fault at the targets ``places``, a fault of one traverse, or single wrong
    readings.
    """
    m = test.targets.size
    if places.size:
        targets = [_position(float(test.targets[place]), test) for place in places]
        return say("CW-E032.target", target=targets)
    if cells.size >= _TOGETHER and np.ptp(runs) == 0 and np.ptp(cells // m) == 0:
        traverse = _traverse(test, int(cells[0]), int(runs[0]))
        return say("CW-E024.traverse", traverse=traverse)
    return say("CW-E024.reading")


def _places(
    test: PositioningTest, readings: CellReadings, draws: Sequence[NoiseState]
) -> Iterator[Finding]:
    absent = np.mean([draw.absent_spread for draw in draws], axis=0)
    spread = np.array([draw.spread for draw in draws])
    sigma = np.array([draw.sigma for draw in draws])
    odds = _odds(absent[0])
    if odds >= CLEAR:
        ways = [_text(_middle(sigma * np.exp(0.5 * way * spread[:, 0])), test) for way in (1, -1)]
        yield Finding.of(
            "CW-E026", "info", positive=ways[0], negative=ways[1], odds=_odds_text(odds)
        )
    odds = _odds(float(np.min(absent[1:])))
    if odds >= CLEAR:
        m = test.targets.size
        along = sigma[:, np.newaxis] * np.exp(spread[:, 1:] @ spread_shapes(readings)[1:, :m])
        scale = np.round(np.median(along, axis=0), 12)
        least, most = int(np.argmin(scale)), int(np.argmax(scale))
        yield Finding.of(
            "CW-E027",
            "info",
            least=_text(float(scale[least]), test),
            least_at=_position(test.targets[least], test),
            most=_text(float(scale[most]), test),
            most_at=_position(test.targets[most], test),
            odds=_odds_text(odds),
        )


def _errors(readings: CellReadings, draw: NoiseState) -> FloatArray:
    """Return the random errors (c, n): readings minus target means, traverse shifts and drift."""
    moved = traverse_effects(readings, draw.effects)
    means = draw.data.means - draw.data.shares @ draw.effects
    return np.where(readings.there, readings.values - moved - means[:, np.newaxis], 0.0)


def _middle(values: Sequence[float] | FloatArray) -> float:
    return float(np.median(values))


def _odds(absent: float | np.floating[Any]) -> float:
    return (1.0 - float(absent)) / max(float(absent), 1e-300)


def _odds_text(odds: float) -> Sentence:
    return say("odds.over_1000") if odds > _SURE else say("odds.to_1", odds=odds)


def _text(value: float, test: PositioningTest) -> Amount:
    unit = test.kind.unit
    return Amount(float(value * outside_factor(unit)), shown_unit(unit), "2sig")


def _signed(value: float, test: PositioningTest) -> Amount:
    return replace(_text(value, test), form="+2sig" if value > 0.0 else "2sig")


def _position(position: float, test: PositioningTest) -> Amount:
    return Amount(float(position), test.kind.unit, ".10g")


def _traverse(test: PositioningTest, cell: int, run: int) -> Sentence:
    m = test.targets.size
    numbers = test.runs_positive if cell < m else test.runs_negative
    number = numbers[run] if run < len(numbers) else run + 1
    return say("traverse", run=number, direction="+" if cell < m else "−")


def _where(test: PositioningTest, cell: int, run: int, off: float) -> Sentence:
    place = _position(float(test.targets[cell % test.targets.size]), test)
    traverse = _traverse(test, cell, run)
    return say("reading_off", traverse=traverse, target=place, off=_signed(off, test))
