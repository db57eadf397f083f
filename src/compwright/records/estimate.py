"""The estimated error of an axis, and the correction that would remove it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, Direction, FloatArray


@dataclass(frozen=True, slots=True)
class AxisPeriod:
    """The period of a periodic error (mm or deg), with its probability and its source."""

    period: float
    probability: float
    source: Literal["job", "found", "files"]

    @property
    def named(self) -> bool:
        """Whether the period is used in decisions, which it is if a periodic error with this period
        is more probable than none.
        """
        return self.probability > 0.5


@dataclass(frozen=True, slots=True)
class PeriodEvidence:
    """The evidence that the axis has a periodic error, for each of the possible ``periods`` (k,),
    mm or deg.

    ``log_odds`` (k,): natural logarithm of the likelihood of this period divided by that of no
    period. ``detectable`` (k,): the amplitude, mm or deg, from which the test shows a wave in 95 %
    of all cases at three standard errors; inf if it shows none. ``alike``: groups of periods that
    the targets cannot distinguish.
    """

    periods: FloatArray
    log_odds: FloatArray
    detectable: FloatArray
    alike: tuple[tuple[float, ...], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorEstimate:
    """The estimated deviation over the travel with its uncertainty, mm or deg.

    ``positions`` (g,): strictly ascending over the whole travel. ``mean_*``, ``std_*`` (g,): mean
    and standard deviation for approaches in + and -. If only one direction was measured, both
    directions have its curve, and a finding states this. ``noise``: the standard deviation of a
    single reading, which is never 0. ``noise_dof``: its degrees of freedom. ``measured``: the range
    of the targets. ``periods``: the known periods and those found.
    """

    kind: AxisKind
    positions: FloatArray
    mean_positive: FloatArray
    mean_negative: FloatArray
    std_positive: FloatArray
    std_negative: FloatArray
    noise: float
    noise_dof: float
    measured: tuple[float, float]
    findings: tuple[Finding, ...] = ()
    periods: tuple[AxisPeriod, ...] = ()

    def mean(self, direction: Direction) -> FloatArray:
        """Return the estimated deviation (g,) in one approach direction."""
        return self.mean_positive if direction is Direction.POSITIVE else self.mean_negative

    def taken(self, places: NDArray[np.intp]) -> ErrorEstimate:
        """Return the estimate at only those positions that have the indices ``places``."""
        return replace(
            self,
            positions=self.positions[places],
            mean_positive=self.mean_positive[places],
            mean_negative=self.mean_negative[places],
            std_positive=self.std_positive[places],
            std_negative=self.std_negative[places],
        )


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Scenarios:
    """Simulated new tests, all equally probable. The fit of a table judges by them how well the
    table reaches its goal (such as the least A).

    There are ``count`` tests of m targets each. The arrays (count * m,) have one test after the
    other, mm or deg. ``positive``, ``negative``: mean of the readings minus the estimated error.
    ``half_*``: k times s of the readings, 0 if there is no s. The arrays of a direction that is not
    measured are empty.
    """

    count: int
    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    half_positive: FloatArray
    half_negative: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class WantedCorrection:
    """The total correction that would remove the estimated error, before rounding and limits.

    ``positions`` (g,): strictly ascending over the travel. ``positive``, ``negative`` (g,): totals
    (existing table plus change), zero at ``reference`` approached in ``reference_return``.
    ``noise``: a finer grid is not worthwhile for errors below this (mm or deg).
    ``reversal_log_odds``: natural logarithm of the odds that the reversal varies with position.
    ``periods``: known periods (mm or deg) that the estimate contains. ``scenarios``: simulated new
    tests, if a goal needs them.
    """

    kind: AxisKind
    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    reference: float
    reference_return: Direction
    noise: float
    reversal_log_odds: float = 0.0
    periods: tuple[float, ...] = ()
    scenarios: Scenarios | None = None

    def total(self, direction: Direction) -> FloatArray:
        """Return the wanted total correction (g,) in one approach direction."""
        return self.positive if direction is Direction.POSITIVE else self.negative
