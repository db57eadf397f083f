"""Find jumps of the error between two targets. Causes: a damaged scale, a joint of two scales, a
wrong number of encoder lines.

A smooth model would spread a jump over a length and overshoot on both sides. Sets of jumps and
outliers are compared by the evidence of the means (`step_evidence`; Kass and Raftery, Bayes
Factors, J. Am. Stat. Assoc. 90, 1995). Between the two targets of a jump, the mean of the error is
nearly a straight line. This does no harm if there is no jump.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.step_evidence import FoundStep, StepEvidence
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import AxisKind, FloatArray
from compwright.words.sentences import Amount

#: Odds from which on a jump is named, a judgement.
_NAMED: Final = 20.0
#: Odds above this rest on approximations.
_SURE: Final = 1000.0
_HALF: Final = 12  # targets on either side that are looked at
_FEWEST: Final = 5  # targets that show one
#: Part of the gap, at either end, in which its mean stays as it is at the target there: tables bend
#: at points of their own, and must hold what was measured. Between them the mean is a straight
#: line. A steeper one leaves up to a fifth less on average, because each place of the step in the
#: gap is equally probable, but more than straight lines between the means leave where the step is
#: near an end of the gap. On one axis either is the better one by that place: of 40 axes 22 got
#: better, 6 worse by 0.1 to 0.7 µm, in the mean by -1.0 ± 0.4 µm; steps at eight places of the gaps
#: of four of these 6 gave -0.3 to 0.1 µm (`benchmarks/bench_jumps.py 40 --tests 3`).
_LEVEL: Final = 0.05


@dataclass(frozen=True, slots=True)
class Jump:
    """A jump of the error between the targets ``low`` and ``high``: its ``size`` with standard
    deviation ``std``, mm or deg.

    ``odds``: odds that the jump exists. ``turn`` (deg): of an endless axis. There the error returns
    evenly over the rest of the turn, and ``high`` may be in the next turn. ``end``: the first or
    last target of the axis, if it alone is on its side of the jump. It may then be an outlier
    instead.
    """

    low: float
    high: float
    size: float
    std: float
    odds: float
    turn: float | None = None
    end: float | None = None

    def ramp(self, positions: FloatArray) -> FloatArray:
        """Return the mean (k,) of the jump over its possible places: a straight rise between two
        targets.
        """
        return np.asarray(self.size * (self._level(positions) - self._back(positions)))

    def variance(self, positions: FloatArray) -> FloatArray:
        """Return the mean square (k,) of the jump about its average `ramp`, because its exact place
        is unknown.
        """
        share = self._share(positions)
        square = share * (1.0 - share) + (share - self._level(positions)) ** 2
        return np.asarray(self.size**2 * self.probability * square)

    def drawn(self, positions: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return random draws (count, k) of the jump minus its mean `ramp`, at ``positions`` (k,)
        or (count, k). Draws in which the jump does not exist are zero.
        """
        places, there = rng.random((count, 1)), rng.random((count, 1)) < self.probability
        step = (self._share(positions) > places) - self._level(positions)
        return np.asarray(np.where(there, self.size * step, 0.0))

    @property
    def probability(self) -> float:
        """The probability that the jump exists."""
        return self.odds / (1.0 + self.odds)

    def _behind(self, positions: FloatArray) -> FloatArray:
        away = positions - self.low
        return away if self.turn is None else np.mod(away, self.turn)

    def _share(self, positions: FloatArray) -> FloatArray:
        return np.clip(self._behind(positions) / (self.high - self.low), 0.0, 1.0)

    def _level(self, positions: FloatArray) -> FloatArray:
        return np.clip((self._share(positions) - _LEVEL) / (1.0 - 2.0 * _LEVEL), 0.0, 1.0)

    def _back(self, positions: FloatArray) -> FloatArray | float:
        return 0.0 if self.turn is None else self._behind(positions) / self.turn

    @property
    def named(self) -> bool:
        """Whether the jump is reported to the user."""
        return self.odds >= _NAMED or self.end is not None

    def finding(self, kind: AxisKind) -> Finding:
        """Return the finding about this jump (CW-E030)."""
        factor, small = outside_factor(kind.unit), shown_unit(kind.unit)
        std = self.std * factor
        decimals = max(0, 1 - int(np.floor(np.log10(max(std, 1e-3)))))
        high = self.high if self.turn is None else self.high % self.turn
        return Finding.of(
            "CW-E030.jump" if self.odds >= _NAMED else "CW-E030.jump_or_target",
            "warning",
            size=Amount(self.size * factor, "", f"+.{decimals}f"),
            error=Amount(std, small, f".{decimals}f"),
            low=self.low,
            high=high,
            unit=kind.unit,
            odds=self.odds,
            sure=self.odds > _SURE,
            target=self.end,
        )


def find_jumps(
    targets: FloatArray, means: FloatArray, stds: FloatArray, turn: float | None = None
) -> tuple[Jump, ...]:
    """Return the jumps of the error that the ``means`` of the ``targets`` (m,) show, mm or deg,
    ascending.

    ``stds`` (m,): standard deviations of the noise of the means. The odds of a jump are relative to
    the best explanation without it. ``turn`` (deg): of an endless axis, whose targets are within
    one turn. The interval from the last target to the first one is then searched too.
    """
    m = targets.size
    if m < _FEWEST:
        return ()
    found = []
    for first, count, own in _windows(m, endless=turn is not None):
        indices = np.arange(first, first + count)
        x = targets[indices % m] + (0.0 if turn is None else turn * (indices // m))
        evidence = StepEvidence(
            x, means[indices % m], stds[indices % m], m - 1 if turn is None else m
        )
        for step in evidence.found():
            gap = (first + step.gap) % m
            if gap in own:
                low = float(targets[gap])
                high = float(x[step.gap + 1] - x[step.gap]) + low
                end = {0: low, m - 2: high}.get(gap) if turn is None else None
                found.append(_jump(step, low, high, turn, end))
    return tuple(sorted(found, key=lambda jump: jump.low))


def _windows(m: int, *, endless: bool) -> list[tuple[int, int, range]]:
    """Return groups of neighbouring targets. Each group is used to search for jumps in some of its
    gaps, the intervals between two targets; a gap has the index of the target before it.
    """
    count = min(2 * _HALF, m) if not endless else 2 * min(_HALF, m // 2)
    gaps = m if endless else m - 1
    if count == m and not endless:
        return [(0, m, range(gaps))]
    half = count // 2
    windows = []
    for low in range(0, gaps, half):
        own = range(low, min(low + half, gaps))
        first = (own.start + own.stop + 1 - count) // 2
        windows.append((first if endless else min(max(first, 0), m - count), count, own))
    return windows


def _jump(step: FoundStep, low: float, high: float, turn: float | None, end: float | None) -> Jump:
    """Return a found step between the targets ``low`` and ``high`` as a `Jump`.

    ``turn``: the length of one turn of a rotary axis, None for other axes. ``end``: the first or
    last target of the test, if ``low`` or ``high`` is this target; else None. Readings at an end
    can equally be an outlier instead of a step.
    """
    size, std, odds = round(step.size, 9), round(step.std, 9), step.odds
    if end is None:
        return Jump(low, high, size, std, odds, turn)
    alone = end if odds >= _NAMED else None
    return Jump(low, high, size, std, odds / (1.0 + odds), turn, alone)
