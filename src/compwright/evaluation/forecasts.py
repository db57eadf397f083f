"""The time at which a parameter will reach its limit, from trends of the parameter or of slope and
reversal error.

A, E, M, R and B are not linear in time, even if slope and reversal error are. They follow from the
mean curve by the standard's formulas F (ISO 230-2:2014, clause 3), in µm or arcsec:

    P(t) = F(shape + slope(t) x, mean B(t)) + rest(t)

``x``: position. ``shape``: the mean curve of both directions without its slope and mean reversal
error, averaged over the tests. ``rest``: the parameter of a test minus F of shape, slope and mean B
of this test (scatter, wear at one place). Slope, mean B and rest have separate trends. Any other
parameter consists of the rest alone. F is convex. So in each random draw of levels and rates, the
parameter rises above the limit only once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.statistics import parameters
from compwright.records.axis import FloatArray
from compwright.records.history import HistoryEntry

#: They follow from the mean curve.
_OF_CURVE: Final = frozenset({"A", "E", "M", "R", "B"})
#: Years ahead beyond which no date is given, and halvings of them down to a day.
_HORIZON: Final = 30.0
_HALVINGS: Final = 15
#: Share of the draws in the interval, and the shares below it that are tried.
_HELD: Final = 0.9
_BELOW: Final = np.arange(0.005, 0.0975, 0.005)
#: Draws whose curves are computed at once: larger arrays are taken from the system each time.
_AT_ONCE: Final = 1000

#: Years after the last test, ends and median of the 90 % interval (early, median, late); None: not
#: within 30 years.
Ahead = tuple[float | None, float | None, float | None]


@dataclass(frozen=True, slots=True)
class ErrorCurve:
    """The mean deviation in each direction over position, without its slope and mean reversal
    error.

    ``along`` (m,): distance of each target from the mean of all targets, m. ``shape`` (2, m): the
    deviations in + and in −.
    """

    parameter: str
    along: FloatArray
    shape: FloatArray

    def value(self, slope: FloatArray, reversal: FloatArray) -> FloatArray:
        """Return the parameter (n,) without scatter, from slopes (µm/m) and mean reversal errors
        (n,).
        """
        portions = [slice(i, i + _AT_ONCE) for i in range(0, len(slope), _AT_ONCE)]
        return np.concatenate([self._value(slope[each], reversal[each]) for each in portions])

    def _value(self, slope: FloatArray, reversal: FloatArray) -> FloatArray:
        mean = np.multiply.outer(self.along, slope)
        half, shape = 0.5 * reversal, self.shape[:, :, None]
        up, down = mean + shape[0] + half, mean + shape[1] - half
        s = np.zeros(self.along.size)
        # transposed: maxima over targets are faster where the draws are next to each other
        return parameters(up.T, s, down.T, s, 1.0, self.parameter)[self.parameter]


def error_curve(parameter: str, entries: Sequence[HistoryEntry]) -> ErrorCurve | None:
    """Return the average error curve of tests at the same targets. None if the ``parameter`` cannot
    be computed from such a curve, or if a test did not record its curve.
    """
    along, shapes = np.empty(0), []
    for entry in entries:
        means = [np.array(mean) for mean in entry.means if len(mean) == len(entry.targets)]
        if parameter not in _OF_CURVE or not entry.targets or not means:
            return None
        order = np.argsort(entry.targets)
        positions = np.array(entry.targets)[order]
        along = (positions - positions.mean()) / 1000.0
        sloped = entry.values.get("slope", 0.0) * along
        half = 0.5 * entry.values.get("B_mean", 0.0)
        shapes.append([means[0][order] - sloped - half, means[-1][order] - sloped + half])
    return ErrorCurve(parameter, along, np.mean(shapes, axis=0))


def reached(
    limit: float,
    rest: FloatArray,
    curve: ErrorCurve | None = None,
    slope: FloatArray | None = None,
    reversal: FloatArray | None = None,
) -> Ahead:
    """Return the years until a parameter exceeds ``limit``: early, median, late. All are None if
    the parameter does not grow; one is None if it is beyond 30 years.

    90 % of the draws lie between early and late. The shares before and after are those of the
    shortest 90 % interval of the parameter's value at the median date. Near the slope at which F is
    lowest, all draws are above this lowest value: equal shares would exclude it.

    ``rest``, ``slope``, ``reversal`` (2, n): random draws of the present level and of the rate per
    year. ``slope`` and ``reversal`` are slope and mean reversal error; ``rest`` is the part of the
    parameter that follows from neither. The scatter of single tests is ignored. A limit that is
    exceeded already is reached after 0 years.
    """
    nothing = np.zeros_like(rest)
    parts = [nothing if part is None else part for part in (slope, reversal)]

    def value(years: FloatArray | float) -> FloatArray:
        sloped, turned = (level + rate * years for level, rate in parts)
        own: FloatArray = rest[0] + rest[1] * years
        return own if curve is None else own + curve.value(sloped, turned)

    if np.median(value(1.0) - value(0.0)) <= 0.0:
        return (None, None, None)
    early, late = np.zeros(rest.shape[1]), np.full(rest.shape[1], _HORIZON)
    beyond = value(late) > limit
    now = value(early) > limit
    for _ in range(_HALVINGS):
        middle = 0.5 * (early + late)
        passed = value(middle) > limit
        early, late = np.where(passed, early, middle), np.where(passed, middle, late)
    years = np.where(beyond, np.where(now, 0.0, late), np.inf)
    median = float(np.quantile(years, 0.5, method="inverted_cdf"))
    then = value(min(median, _HORIZON))
    width = np.quantile(then, _BELOW + _HELD) - np.quantile(then, _BELOW)
    below = float(_BELOW[np.argmin(np.round(width, 9))])
    shares = (1.0 - _HELD - below, 0.5, 1.0 - below)
    ends = np.quantile(years, shares, method="inverted_cdf")
    first, middle, last = (float(end) if end <= _HORIZON else None for end in ends)
    return first, middle, last
