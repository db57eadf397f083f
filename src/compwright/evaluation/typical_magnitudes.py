"""Comparison of readings with typical sizes on machine tools, to detect a wrong unit or reversed
directions.

The typical sizes are weak priors. They are stated here because no standard has them. Linear axes
are in µm, rotary axes in arcsec.

- Scatter of repeated readings: lognormal about 1 µm (0.5 arcsec). One standard deviation is a
  factor of 4; two standard deviations are 0.06 to 16 µm.
- Range of all readings: lognormal about 15 µm (10 arcsec). One standard deviation is a factor of 4;
  two standard deviations are 1 to 240 µm. Scatter and range of two real axes were 3.2 and 93 µm,
  and 17.7 and 97 µm.
- Mean reversal error of 60 % of the axes: lost motion (below zero), lognormal about 4 µm with a
  factor of 3. Of 35 %: compensated or not present, normal with 1.5 µm. Of 5 %: over-compensated,
  exponential with 4 µm above zero.

Odds are ratios of such densities (Jeffreys, Theory of Probability, 3rd ed. 1961, section 5.0).
"""

from __future__ import annotations

import math
from typing import Final

from compwright.evaluation.pooled_scatter import pooled_scatter, reading_range
from compwright.foundations.units import outside_factor
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest

#: Centre of scatter and of range, µm or arcsec, and the factor of one standard deviation.
_SCATTER: Final = {AxisKind.LINEAR: 1.0, AxisKind.ROTARY: 0.5}
_RANGE: Final = {AxisKind.LINEAR: 15.0, AxisKind.ROTARY: 10.0}
_FACTOR: Final = 4.0
#: Degrees of freedom from which the scatter counts.
_ENOUGH: Final = 4.0
#: Scatter below this is rounding of binary numbers, mm or deg.
_ROUNDING: Final = 1e-9
_LOST, _LOST_FACTOR, _LOST_SHARE = 4.0, 3.0, 0.6
_NONE, _NONE_SHARE = 1.5, 0.35
_OVER, _OVER_SHARE = 4.0, 0.05


def unit_odds(test: PositioningTest, factor: float) -> float:
    """Return the odds that the readings must be multiplied by ``factor`` to be in the stated unit,
    judged by the typical size of readings.
    """
    outside = outside_factor(test.kind.unit)
    s, dof = pooled_scatter(test)
    sizes = [(reading_range(test) * outside, _RANGE[test.kind])]
    if dof >= _ENOUGH and s > _ROUNDING:
        sizes.append((s * outside, _SCATTER[test.kind]))
    logs = (
        _log_square(size / centre) - _log_square(size * factor / centre)
        for size, centre in sizes
        if size > 0.0
    )
    return math.exp(min(sum(logs), 50.0))


def _log_square(ratio: float) -> float:
    return 0.5 * (math.log(ratio) / math.log(_FACTOR)) ** 2


def turned_odds(reversal: float, kind: AxisKind) -> float:
    """Return the odds that a mean reversal error has the opposite sign, from typical values.

    ``reversal``: mean(+) - mean(-), mm or deg, negative for lost motion (ISO 230-2:1997, 2.14).
    """
    size = reversal * outside_factor(kind.unit)
    return _density(-size) / max(_density(size), 1e-12)


def _density(reversal: float) -> float:
    """Return the probability density of a mean reversal error (µm, arcsec) on typical machines."""
    near = math.exp(-0.5 * (reversal / _NONE) ** 2) / (_NONE * math.sqrt(2.0 * math.pi))
    density = _NONE_SHARE * near
    if reversal > 0.0:
        return density + _OVER_SHARE * math.exp(-reversal / _OVER) / _OVER
    lost, width = -reversal, math.log(_LOST_FACTOR)
    if lost > 0.0:
        away = math.log(lost / _LOST) / width
        density += _LOST_SHARE * math.exp(-0.5 * away**2) / (lost * width * math.sqrt(2 * math.pi))
    return density
