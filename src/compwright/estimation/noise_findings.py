"""What the noise of a test is beside plain scatter, in words: how much, how sure, what to do.

Odds are posterior odds, averaged over the sampler's conditional probabilities (Gelfand and Smith,
J. Am. Stat. Assoc. 85, 1990); nothing is said below `CLEAR`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Final

import numpy as np

from compwright.estimation.noise_chain import Draw
from compwright.estimation.noise_patterns import DRIFT, DRIFT_TILT, OFFSET, RATES, TILT
from compwright.estimation.noise_readings import CellReadings, at_traverses
from compwright.estimation.noise_spread import shapes_of
from compwright.estimation.noise_tails import KINDS, NORMAL, OUTLIERS, STUDENT
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import FloatArray
from compwright.records.noise import INDEPENDENT, RUNS, WALK, WAVE, IndexArray
from compwright.records.positioning import SAME_READING, PositioningTest

#: Odds from which something is said: "strong" evidence (Kass and Raftery, J. Am. Stat. Assoc. 90,
#: 1995, section 3.2).
CLEAR: Final = 20.0
#: Odds above this rest on approximations and are told as "over 1000".
_SURE: Final = 1000.0
#: Parts smaller than this, in standard deviations of a reading, change s by less than a tenth.
_MATTERS: Final = 0.4
#: Below this share of moves the others are the rule.
_SELDOM: Final = 0.5
_SHOWN: Final = 5
#: So many outliers with a place or a traverse in common are no chance.
_TOGETHER: Final = 3
_LOOK: Final = (
    "look at warm-up, clamping, reference runs and the mounting of the instrument between traverses"
)
_PATTERN_WORDS: Final = {
    INDEPENDENT: "Traverses are shifted against each other",
    RUNS: "Runs are shifted against each other as a whole",
    WALK: "The zero point wanders from traverse to traverse",
    WAVE: "The readings rise and fall slowly in time",
}
#: The same where most stay where they are.
_SELDOM_WORDS: Final = {
    INDEPENDENT: "Single traverses stand off the others",
    RUNS: "Single runs stand off the others as a whole",
    WALK: "The zero point jumps now and then, and stays there,",
}
_AIR: Final = "look at the air of the hall (heating, cooling, drafts, sun)"


def noise_findings(
    test: PositioningTest, readings: CellReadings, draws: Sequence[Draw], step: float
) -> tuple[Finding, ...]:
    """Return what ``draws`` of the noise of ``test`` clearly show beside white noise; ``step``, mm
    or deg: to which its instrument rounds, 0 where that changes nothing.
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
    why = "every target repeats one reading, and " if repeated else ""
    yield Finding(
        "CW-E029",
        "warning" if repeated else "info",
        f"Assumed resolution of the instrument: {_text(step, test)} ({why}all readings lie on this"
        " step). The true error may differ from each mean by half a step. If the instrument"
        " resolves more, export its readings with all digits and evaluate again",
    )


def _drifts(test: PositioningTest, draws: Sequence[Draw]) -> Iterator[Finding]:
    sigma = _middle([draw.sigma for draw in draws])
    flattens = float(np.mean([RATES[draw.rate] > 0.0 for draw in draws])) > 0.5
    how = ", and it flattens out" if flattens else ""
    for kind, code in ((DRIFT, "CW-E020"), (DRIFT_TILT, "CW-E021")):
        size = _middle([draw.drift[kind - DRIFT] for draw in draws])
        odds = _odds(np.mean([draw.absent[kind] for draw in draws]))
        if odds < CLEAR or abs(size) < sigma:
            continue
        if kind == DRIFT:
            message = (
                f"The readings drift by {_signed(size, test)} from the first run to the last"
                f" ({_told(odds)}){how}"
            )
        else:
            message = (
                "The readings drift apart along the travel, as in thermal expansion: by"
                f" {_signed(-size, test)} at its lower end and {_signed(size, test)} at its upper"
                f" end from the first run to the last ({_told(odds)}){how}"
            )
        yield Finding(
            code,
            "warning",
            f"{message}. The prediction takes it that a test repeated in the same way, from as cold"
            " an axis, drifts so again, to about a tenth; one test does not tell: another drift, or"
            " none because the axis is warm by then, lies outside of the band. Warm the axis up"
            " and measure again to see it without",
        )


def _traverses(test: PositioningTest, draws: Sequence[Draw]) -> Iterator[Finding]:
    sigma = _middle([draw.sigma for draw in draws])
    offset, tilt = (_middle([draw.size[kind] for draw in draws]) for kind in (OFFSET, TILT))
    odds = _odds(np.mean([draw.absent[OFFSET] for draw in draws]))
    drifts = _odds(np.mean([draw.absent[DRIFT] for draw in draws])) >= CLEAR
    either = _odds(np.mean([not draw.size[[OFFSET, DRIFT]].any() for draw in draws]))
    if odds >= CLEAR and offset >= _MATTERS * sigma:
        pattern = int(np.argmax(np.bincount([draw.pattern for draw in draws])))
        alike = [draw for draw in draws if draw.pattern == pattern]
        seldom = _middle([draw.share for draw in alike]) < _SELDOM
        words = (_SELDOM_WORDS if seldom else _PATTERN_WORDS)[pattern]
        size = f"{_text(offset, test)}{' a step' if pattern == WALK and not seldom else ''}"
        where = _standing_off(test, alike) if seldom and pattern == INDEPENDENT else ""
        yield Finding(
            "CW-E022",
            "warning",
            f"{words} by {size} (one standard deviation; {_told(odds)}){where}:"
            f" {_AIR if pattern == WAVE else _LOOK}. The prediction draws such"
            f" {'waves' if pattern == WAVE else 'shifts'} anew{', as seldom' if seldom else ''}",
        )
    elif either >= CLEAR > odds and not drifts:
        yield Finding(
            "CW-E022",
            "warning",
            f"The traverses move against each other ({_told(either)}); whether they drift or jump"
            f" these readings cannot tell: {_LOOK}. The prediction counts with both",
        )
    odds = _odds(np.mean([draw.absent[TILT] for draw in draws]))
    if odds >= CLEAR and tilt >= _MATTERS * sigma:
        yield Finding(
            "CW-E023",
            "warning",
            "The scale changes from traverse to traverse: the ends of the travel move by"
            f" {_text(tilt, test)} against its middle (one standard deviation; {_told(odds)}): look"
            " at the compensation of air and temperature of the instrument and at drafts",
        )


def _standing_off(test: PositioningTest, draws: Sequence[Draw]) -> str:
    """Return which traverses are moved in most of the draws, in words."""
    m, runs = test.targets.size, draws[0].moved.size // 2
    moved = np.flatnonzero(np.mean([draw.moved for draw in draws], axis=0) > 0.5)
    told = [_traverse(test, m * int(k // runs), int(k % runs)) for k in moved]
    return f", {' and '.join(told)}" if told else ""


def _tails(
    test: PositioningTest, readings: CellReadings, draws: Sequence[Draw]
) -> Iterator[Finding]:
    chances = np.mean([draw.tail_chances for draw in draws], axis=0)
    normal, student, spoilt = (
        float(np.sum(chances[kind == KINDS])) for kind in (NORMAL, STUDENT, OUTLIERS)
    )
    odds = _odds(normal)
    if odds < CLEAR:
        return
    taken = np.mean([draw.outlier for draw in draws], axis=0) / max(spoilt, 1e-9)
    cells, runs = np.nonzero(taken > 0.5)
    if spoilt > student and cells.size:
        off = np.median([_errors(readings, draw) for draw in draws], axis=0)
        order = np.argsort(-np.round(np.abs(off[cells, runs]), 9), kind="stable")
        told = ", ".join(
            _where(test, int(cells[k]), int(runs[k]), float(off[cells[k], runs[k]]))
            for k in order[:_SHOWN]
        )
        more = f" and {cells.size - _SHOWN} more" if cells.size > _SHOWN else ""
        are = "readings are outliers" if cells.size > 1 else "readings is an outlier"
        yield Finding(
            "CW-E024",
            "warning",
            f"{cells.size} of {np.count_nonzero(readings.there)} {are}: {told}{more}"
            f" ({_told(odds)}). They count little in the estimate, and a repeated test is predicted"
            f" to have as many: {_cause(test, cells, runs)}, then measure again",
        )
    else:
        yield Finding(
            "CW-E025",
            "info",
            "Single readings lie further out than normal scatter explains"
            f" ({_told(odds)}): far readings count less in the estimate, and a repeated test is"
            " predicted to have such readings",
        )


def _cause(test: PositioningTest, cells: IndexArray, runs: IndexArray) -> str:
    """Return what to look for behind outliers in ``cells`` and ``runs`` (k,): they may all lie in
    one traverse or at one place.
    """
    m = test.targets.size
    if cells.size >= _TOGETHER and np.ptp(cells % m) == 0:
        place = _position(float(test.targets[cells[0] % m]), test)
        return f"all at {place}, look at screw, guides and covers there"
    if cells.size >= _TOGETHER and np.ptp(runs) == 0 and np.ptp(cells // m) == 0:
        traverse = _traverse(test, int(cells[0]), int(runs[0]))
        return f"all in {traverse}, find out what happened in that traverse"
    return "find their cause (beam, chips, clamping)"


def _places(
    test: PositioningTest, readings: CellReadings, draws: Sequence[Draw]
) -> Iterator[Finding]:
    absent = np.mean([draw.absent_spread for draw in draws], axis=0)
    spread = np.array([draw.spread for draw in draws])
    sigma = np.array([draw.sigma for draw in draws])
    odds = _odds(absent[0])
    if odds >= CLEAR:
        ways = [_text(_middle(sigma * np.exp(0.5 * way * spread[:, 0])), test) for way in (1, -1)]
        yield Finding(
            "CW-E026",
            "info",
            f"The readings scatter by {ways[0]} in + and by {ways[1]} in −"
            f" ({_told(odds)}): look for what moves freely in one direction only",
        )
    odds = _odds(float(np.min(absent[1:])))
    if odds >= CLEAR:
        m = test.targets.size
        along = sigma[:, np.newaxis] * np.exp(spread[:, 1:] @ shapes_of(readings)[1:, :m])
        scale = np.round(np.median(along, axis=0), 12)
        told = " and ".join(
            f"{word}, by {_text(float(scale[i]), test)}, at {_position(test.targets[i], test)}"
            for i, word in ((np.argmin(scale), "least"), (np.argmax(scale), "most"))
        )
        yield Finding(
            "CW-E027",
            "info",
            f"The scatter of the readings depends on the position: {told} ({_told(odds)}): look at"
            " screw, guides and covers where it is largest",
        )


def _errors(readings: CellReadings, draw: Draw) -> FloatArray:
    """Return the readings (c, n) less the means of their cells and what traverses and drift do."""
    moved = at_traverses(readings, draw.effects)
    means = draw.data.means - draw.data.shares @ draw.effects
    return np.where(readings.there, readings.values - moved - means[:, np.newaxis], 0.0)


def _middle(values: Sequence[float] | FloatArray) -> float:
    return float(np.median(values))


def _odds(absent: float | np.floating[Any]) -> float:
    return (1.0 - float(absent)) / max(float(absent), 1e-300)


def _told(odds: float) -> str:
    return "odds over 1000 to 1" if odds > _SURE else f"odds {significant(odds)} to 1"


def _text(value: float, test: PositioningTest) -> str:
    return f"{significant(value * outside_factor(test.kind.unit))} {shown_unit(test.kind.unit)}"


def _signed(value: float, test: PositioningTest) -> str:
    return f"{'+' if value > 0.0 else ''}{_text(value, test)}"


def _position(position: float, test: PositioningTest) -> str:
    return f"{position:.10g} {test.kind.unit}"


def _traverse(test: PositioningTest, cell: int, run: int) -> str:
    m = test.targets.size
    numbers = test.runs_positive if cell < m else test.runs_negative
    number = numbers[run] if run < len(numbers) else run + 1
    return f"run {number} in {'+' if cell < m else '−'}"


def _where(test: PositioningTest, cell: int, run: int, off: float) -> str:
    place = _position(float(test.targets[cell % test.targets.size]), test)
    return f"{_traverse(test, cell, run)} at {place} ({_signed(off, test)} off)"
