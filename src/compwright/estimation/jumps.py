"""Jumps of the error between two targets: a damaged scale, a joint of two scales, a wrong number of
encoder lines. A stationary prior smears them over its length, and overshoots on both sides.

The means of the targets about a gap are compared under two models: smooth error, local part and
noise; and the same with a step in the gap. All sizes and lengths are averaged over (Kass and
Raftery, Bayes Factors, J. Am. Stat. Assoc. 90, 1995); the step is integrated out in closed form
(Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, sections 2.7 and 5.2).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import BoolArray, IndexArray

#: Axes with a jump, a judgement: one in a hundred; and odds from which on one is named.
_AXES: Final = 1.0 / 100.0
_NAMED: Final = 20.0
#: Odds from which on it is counted with, as far as it is likely: between its targets the mean of
#: the error then is nearly a straight line, which does no harm where none is there.
_COUNTED: Final = 0.05
#: Odds above this rest on approximations.
_SURE: Final = 1000.0
_MOST: Final = 3  # jumps of one axis
_LOOKED_AT: Final = 5  # gaps at which a step is tried
_WINDOW: Final = 12  # targets on either side that are looked at
_FEWEST: Final = 5  # targets that show one
#: Part of the gap, at either end, in which its mean stays as it is at the target there: tables bend
#: at points of their own, and must hold what was measured.
_LEVEL: Final = 0.25
_LENGTHS: Final = 2.0 ** np.arange(7)  # of the smooth part, in mean distances of the targets
_LEAST: Final = 1e-4
_SIZES: Final = 8
_LOCAL: Final = 6


@dataclass(frozen=True, slots=True)
class Jump:
    """A step of the error by ``size`` with its standard deviation ``std`` somewhere between the
    targets ``low`` and ``high``, mm or deg; ``odds`` for it. With a ``turn`` (deg) the error comes
    back evenly over the rest of it, and ``high`` may lie in the next one. ``end``: the last target,
    where it clearly differs from the others and only it lies behind the step: then it may as well
    be off by itself.
    """

    low: float
    high: float
    size: float
    std: float
    odds: float
    turn: float | None = None
    end: float | None = None

    def ramp(self, positions: FloatArray) -> FloatArray:
        """Return what tables hold of the step (k,): no place in the gap is known."""
        return np.asarray(self.size * (self._level(positions) - self._back(positions)))

    def variance(self, positions: FloatArray) -> FloatArray:
        """Return the mean square (k,) of the step about `ramp`: it is there already, or not yet."""
        share = self._share(positions)
        square = share * (1.0 - share) + (share - self._level(positions)) ** 2
        return np.asarray(self.size**2 * self.probability * square)

    def drawn(self, positions: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return steps (count, k) at places that are drawn, less `ramp`, at ``positions`` (k,) or
        (count, k); nothing in the draws that have none.
        """
        places, there = rng.random((count, 1)), rng.random((count, 1)) < self.probability
        step = (self._share(positions) > places) - self._level(positions)
        return np.asarray(np.where(there, self.size * step, 0.0))

    @property
    def probability(self) -> float:
        """How probable it is."""
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
        """Whether the user hears of it."""
        return self.odds >= _NAMED or self.end is not None

    def finding(self, kind: AxisKind) -> Finding:
        """Return what the user should know of it (CW-E030)."""
        factor, small = outside_factor(kind.unit), shown_unit(kind.unit)
        std = self.std * factor
        decimals = max(0, 1 - int(np.floor(np.log10(max(std, 1e-3)))))
        size = f"{self.size * factor:+.{decimals}f} ± {std:.{decimals}f} {small}"
        high = self.high if self.turn is None else self.high % self.turn
        place = f"between {self.low:.10g} and {high:.10g} {kind.unit}"
        if self.odds >= _NAMED:
            sure = "over 1000" if self.odds > _SURE else significant(self.odds)
            what = f"The error jumps by {size} {place} (odds {sure} to 1)"
        else:
            what = (
                f"The error jumps by {size} {place}, or the target at {self.end:.10g} {kind.unit}"
                " alone is off by so much"
            )
        return Finding(
            "CW-E030",
            "warning",
            f"{what}: look at the scale there (damage, dirt, a joint), at its reading head, and at"
            " the line count of the encoder. Between these targets the place of the jump is"
            " unknown: measure there at targets a few mm apart before a table is loaded",
        )


def jumps_of(
    targets: FloatArray, means: FloatArray, stds: FloatArray, turn: float | None = None
) -> tuple[Jump, ...]:
    """Return the jumps that the ``means`` of the ``targets`` (m,) with the standard deviations
    ``stds`` (m,) of their noise show, mm or deg, ascending; those that were found first are taken
    out before others are looked for. ``turn`` (deg): of an endless axis, whose targets lie within
    one; the gap between the last and the first is one too.
    """
    found: dict[float, Jump] = {}
    left = means.copy()
    for _ in range(2 * _MOST):
        jump = _clearest(targets, left, stds, turn)
        if jump is None or (len(found) == _MOST and jump.low not in found):
            break
        left = left - jump.ramp(targets)
        first = found.get(jump.low)
        if first is not None:  # what another one had hidden of its size
            jump = replace(jump, size=first.size + jump.size, odds=max(first.odds, jump.odds))
        found[jump.low] = jump
    return tuple(found[low] for low in sorted(found))


def _clearest(
    targets: FloatArray, means: FloatArray, stds: FloatArray, turn: float | None
) -> Jump | None:
    m = targets.size
    if m < _FEWEST:
        return None
    gaps = np.arange(m - 1 if turn is None else m)
    prior = np.log(_AXES / gaps.size)
    best: Jump | None = None
    steps = [_step(targets, means, int(gap), turn) for gap in gaps]
    for gap in gaps[np.argsort(-np.round(steps, 12), kind="stable")[:_LOOKED_AT]]:
        x, seats = _about(targets, int(gap), _WINDOW, turn)
        behind = x > x[seats == gap][0]
        found = _evidence(x, means[seats], stds[seats], behind)
        step, alone = (float(np.exp(min(log + prior, 100.0))) for log in (found.step, found.alone))
        odds = step / (1.0 + alone)
        if odds >= _COUNTED and (best is None or odds > best.odds):
            low, high = float(targets[gap]), float(np.min(x[behind]))
            size, std = round(found.size, 9), round(found.std, 9)
            end = {0: low, m - 2: high}.get(int(gap)) if turn is None else None
            best = Jump(low, high, size, std, odds, turn, None if step + alone < _NAMED else end)
    return best


def _about(
    targets: FloatArray, gap: int, most: int, turn: float | None
) -> tuple[FloatArray, IndexArray]:
    """Return the positions (k,) of at most ``most`` targets on either side of a gap, ascending, and
    which targets they are; round the ``turn`` of an endless axis.
    """
    m = targets.size
    if turn is None:
        seats = np.arange(max(0, gap + 1 - most), min(m, gap + 1 + most))
        return targets[seats], seats
    half = min(most, m // 2)
    seats = np.arange(gap + 1 - half, gap + 1 + half)
    return targets[seats % m] + turn * (seats // m), seats % m


def _step(targets: FloatArray, means: FloatArray, gap: int, turn: float | None) -> float:
    """Return by how much the means differ across a gap beyond what those next to it do."""
    x, seats = _about(targets, gap, 2, turn)
    slopes = np.diff(means[seats]) / np.diff(x)
    own = int(np.flatnonzero(seats == gap)[0])
    usual = np.mean(np.delete(slopes, own))
    return float(abs(slopes[own] - usual) * (x[own + 1] - x[own]))


@dataclass(frozen=True, slots=True)
class _Evidence:
    """Logarithms of the Bayes factors for a ``step`` in a gap, and for one of the two targets about
    it being ``alone`` off by itself; size of the step and its standard deviation.
    """

    step: float
    alone: float
    size: float
    std: float


def _evidence(x: FloatArray, y: FloatArray, stds: FloatArray, behind: BoolArray) -> _Evidence:
    """Return what the means ``y`` at ``x`` say of a step between the targets that are ``behind`` it
    and the others.
    """
    straight = np.column_stack([np.ones_like(x), (x - x.mean()) / np.ptp(x)])
    rough = y - straight @ np.linalg.lstsq(straight, y, rcond=None)[0]
    # Below a ten-thousandth of what is there the covariance would not be positive any more.
    stds = np.maximum(stds, _LEAST * float(np.ptp(rough)))
    noise = float(np.sqrt(np.mean(stds**2)))
    largest = max(float(np.ptp(rough)), 2.0 * noise)
    free = (10.0 * largest) ** 2 * (straight @ straight.T) + np.diag(stds**2)
    smooth = _smooth(x, np.geomspace(0.1 * noise, 3.0 * largest, _SIZES)) + free
    steps = np.geomspace(3.0 * noise, 3.0 * largest, _SIZES) ** 2
    first = int(np.argmax(behind))
    seats = np.arange(x.size)
    sides = np.column_stack([rough, behind - 0.5, seats == first - 1, seats == first])
    gains, plains, sizes, squares = [], [], [], []
    for std in np.append(0.0, np.geomspace(noise, largest, _LOCAL)):
        factor = np.linalg.cholesky(smooth + std**2 * np.eye(x.size))
        white = np.linalg.solve(factor, np.broadcast_to(sides, (factor.shape[0], x.size, 4)))
        plain = -np.sum(np.log(np.diagonal(factor, axis1=1, axis2=2)), axis=1)
        plains.append(plain - 0.5 * np.sum(white[:, :, 0] ** 2, axis=1))
        own = np.sum(white[:, :, 1:] ** 2, axis=1)[:, :, np.newaxis]
        along = np.sum(white[:, :, :1] * white[:, :, 1:], axis=1)[:, :, np.newaxis]
        precision = own + 1.0 / steps
        gains.append(0.5 * along**2 / precision - 0.5 * np.log1p(steps * own))
        sizes.append((along / precision)[:, 0])
        squares.append(1.0 / precision[:, 0])
    plain = np.concatenate(plains)
    every = plain[:, np.newaxis, np.newaxis] + np.concatenate(gains)
    logs = np.logaddexp.reduce(every, axis=(0, 2)) - np.log(steps.size)
    logs = logs - np.logaddexp.reduce(plain)
    weights = np.exp(every[:, 0] - np.max(every[:, 0]))
    weights = weights / np.sum(weights)
    size = np.concatenate(sizes)
    mean = float(np.sum(weights * size))
    variance = float(np.sum(weights * (np.concatenate(squares) + size**2))) - mean**2
    std = float(np.sqrt(max(variance, 0.0)))
    return _Evidence(float(logs[0]), float(np.logaddexp(logs[1], logs[2])), mean, std)


def _smooth(x: FloatArray, stds: FloatArray) -> FloatArray:
    """Return covariances (n, k, k) of smooth errors at ``x`` (k,) of all lengths and ``stds``."""
    apart = np.abs(np.subtract.outer(x, x)) / (np.ptp(x) / (x.size - 1))
    scaled = apart / _LENGTHS[:, np.newaxis, np.newaxis]
    near = np.sqrt(3.0) * scaled
    shapes = np.concatenate([(1.0 + near) * np.exp(-near), np.exp(-0.5 * scaled**2)])
    every: FloatArray = stds[:, np.newaxis, np.newaxis, np.newaxis] ** 2 * shapes
    return every.reshape(-1, x.size, x.size)
