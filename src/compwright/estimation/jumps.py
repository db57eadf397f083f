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
from compwright.records.noise import IndexArray

#: Axes with a jump, a judgement: one in three hundred; and odds from which on one is named.
_AXES: Final = 1.0 / 300.0
_NAMED: Final = 20.0
#: Odds from which on it is counted with: between its targets the error then is a straight line and
#: less certain, so that one which is not there does no harm.
_COUNTED: Final = 0.05
#: Odds above this rest on approximations.
_SURE: Final = 1000.0
_MOST: Final = 3  # jumps of one axis
_LOOKED_AT: Final = 4  # gaps at which a step is tried
_BESIDE: Final = 2  # targets that a step has on either side at least
_WINDOW: Final = 12  # targets on either side that are looked at
_LENGTHS: Final = 2.0 ** np.arange(7)  # of the smooth part, in mean distances of the targets
_LEAST: Final = 1e-4
_SIZES: Final = 8
_LOCAL: Final = 6


@dataclass(frozen=True, slots=True)
class Jump:
    """A step of the error by ``size`` with its standard deviation ``std`` somewhere between the
    targets ``low`` and ``high``, mm or deg; ``odds`` for it.
    """

    low: float
    high: float
    size: float
    std: float
    odds: float

    def ramp(self, positions: FloatArray) -> FloatArray:
        """Return the mean of the step (k,): in the gap every place is as likely."""
        return np.asarray(self.size * self._share(positions))

    def variance(self, positions: FloatArray) -> FloatArray:
        """Return the variance (k,) of the step about its mean: it is there already, or not yet."""
        share = self._share(positions)
        return np.asarray(self.size**2 * share * (1.0 - share))

    def drawn(self, positions: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return steps (count, k) at places that are drawn, less their mean."""
        places = rng.uniform(self.low, self.high, (count, 1))
        return np.asarray(self.size * (positions > places) - self.ramp(positions))

    def _share(self, positions: FloatArray) -> FloatArray:
        return np.clip((positions - self.low) / (self.high - self.low), 0.0, 1.0)

    @property
    def named(self) -> bool:
        """Whether it is there so surely that the user is told of it."""
        return self.odds >= _NAMED

    def finding(self, kind: AxisKind) -> Finding:
        """Return what the user should know of it (CW-E030)."""
        factor, small = outside_factor(kind.unit), shown_unit(kind.unit)
        sure = "over 1000" if self.odds > _SURE else significant(self.odds)
        std = self.std * factor
        decimals = max(0, 1 - int(np.floor(np.log10(max(std, 1e-3)))))
        return Finding(
            "CW-E030",
            "warning",
            f"The error jumps by {self.size * factor:+.{decimals}f} ± {std:.{decimals}f} {small}"
            f" between {self.low:.10g} and {self.high:.10g} {kind.unit} (odds {sure} to 1): look at"
            " the scale there (damage, dirt, a joint), at its reading head, and at the line count"
            " of the encoder. Between these targets the place of the jump is unknown: measure there"
            " at targets a few mm apart before a table is loaded",
        )


def jumps_of(targets: FloatArray, means: FloatArray, stds: FloatArray) -> tuple[Jump, ...]:
    """Return the jumps that the ``means`` of the ``targets`` (m,) with the standard deviations
    ``stds`` (m,) of their noise show, mm or deg, ascending; those that were found first are taken
    out before others are looked for.
    """
    found: dict[float, Jump] = {}
    left = means.copy()
    for _ in range(2 * _MOST):
        jump = _clearest(targets, left, stds)
        if jump is None or (len(found) == _MOST and jump.low not in found):
            break
        left = left - jump.ramp(targets)
        first = found.get(jump.low)
        if first is not None:  # what another one had hidden of its size
            jump = replace(jump, size=first.size + jump.size, odds=max(first.odds, jump.odds))
        found[jump.low] = jump
    return tuple(found[low] for low in sorted(found))


def _clearest(targets: FloatArray, means: FloatArray, stds: FloatArray) -> Jump | None:
    gaps = np.arange(_BESIDE - 1, targets.size - _BESIDE)
    if not gaps.size:
        return None
    before = _continued(targets, means, gaps, -1)
    after = _continued(targets, means, gaps + 1, 1)
    steps = np.round(np.abs(after - before), 12)
    prior = np.log(_AXES / gaps.size)
    best: Jump | None = None
    for gap in gaps[np.argsort(-steps, kind="stable")[:_LOOKED_AT]]:
        window = slice(max(0, gap + 1 - _WINDOW), gap + 1 + _WINDOW)
        behind = np.arange(targets.size)[window] > gap
        log, size, std = _evidence(targets[window], means[window], stds[window], behind)
        odds = float(np.exp(min(log + prior, 100.0)))
        if odds >= _COUNTED and (best is None or odds > best.odds):
            low, high = float(targets[gap]), float(targets[gap + 1])
            best = Jump(low, high, round(size, 9), round(std, 9), odds)
    return best


def _continued(x: FloatArray, y: FloatArray, places: IndexArray, way: int) -> FloatArray:
    """Return the values in the middle of gaps, continued from the targets ``places`` and beside
    them.
    """
    here, far = places, places + way
    middle = 0.5 * (x[here] + x[here - way])
    slope = (y[here] - y[far]) / (x[here] - x[far])
    return np.asarray(y[here] + slope * (middle - x[here]))


def _evidence(
    x: FloatArray, y: FloatArray, stds: FloatArray, behind: FloatArray
) -> tuple[float, float, float]:
    """Return the logarithm of the Bayes factor for a step between the targets that are ``behind``
    it and the others; its size and standard deviation.
    """
    straight = np.column_stack([np.ones_like(x), (x - x.mean()) / np.ptp(x)])
    rough = y - straight @ np.linalg.lstsq(straight, y, rcond=None)[0]
    # Below a ten-thousandth of what is there the covariance would not be positive any more.
    stds = np.maximum(stds, _LEAST * float(np.ptp(rough)))
    noise = float(np.sqrt(np.mean(stds**2)))
    largest = max(float(np.ptp(rough)), 2.0 * noise)
    apart = np.abs(np.subtract.outer(x, x)) / (np.ptp(x) / (x.size - 1))
    scaled = apart / _LENGTHS[:, np.newaxis, np.newaxis]
    near = np.sqrt(3.0) * scaled
    shapes = np.concatenate([(1.0 + near) * np.exp(-near), np.exp(-0.5 * scaled**2)])
    sizes = np.geomspace(0.1 * noise, 3.0 * largest, _SIZES) ** 2
    local = np.append(0.0, np.geomspace(noise, largest, _LOCAL)) ** 2
    smooth = (sizes[:, np.newaxis, np.newaxis, np.newaxis] * shapes).reshape(-1, x.size, x.size)
    free = (10.0 * largest) ** 2 * (straight @ straight.T) + np.diag(stds**2)
    column = behind - 0.5
    logs, means, variances = [], [], []
    steps = np.geomspace(3.0 * noise, 3.0 * largest, _SIZES) ** 2
    for square in local:
        covariance = smooth + free + square * np.eye(x.size)
        factor = np.linalg.cholesky(covariance)
        sides = np.column_stack([rough, column])[np.newaxis]
        white = np.linalg.solve(factor, np.broadcast_to(sides, (factor.shape[0], x.size, 2)))
        plain = -np.sum(np.log(np.diagonal(factor, axis1=1, axis2=2)), axis=1)
        plain = plain - 0.5 * np.sum(white[:, :, 0] ** 2, axis=1)
        told = np.sum(white[:, :, 1] ** 2, axis=1)[:, np.newaxis]
        along = np.sum(white[:, :, 0] * white[:, :, 1], axis=1)[:, np.newaxis]
        precision = told + 1.0 / steps
        gain = 0.5 * along**2 / precision - 0.5 * np.log1p(steps * told)
        logs.append(np.column_stack([plain, plain[:, np.newaxis] + gain]))
        means.append(along / precision)
        variances.append(1.0 / precision)
    every = np.concatenate(logs)
    without = np.logaddexp.reduce(every[:, 0])
    with_step = np.logaddexp.reduce(every[:, 1:].ravel())
    weights = np.exp(every[:, 1:] - with_step)
    size, square = np.concatenate(means), np.concatenate(variances)
    mean = float(np.sum(weights * size))
    variance = float(np.sum(weights * (square + size**2))) - mean**2
    log = float(with_step - np.log(steps.size) - without)
    return log, mean, float(np.sqrt(max(variance, 0.0)))
