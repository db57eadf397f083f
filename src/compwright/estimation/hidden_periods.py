"""Periods of the error that the targets of an axis cannot show, whatever the readings are: too few
targets for a search, or an interval that is a multiple of the period.

Nothing is measured of them, so what is expected before the data is all that is known: as often as
`periods` expects a period, with an amplitude that is half of a normal law. Its width is a
judgement: ISO 3408-3 (2006) lets the lead of a screw vary by 6 to 8 µm within one turn (grades 3
and 5), and most screws keep half of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.basis import hidden_share
from compwright.estimation.cells import HIDDEN
from compwright.estimation.period_models import PeriodSearch
from compwright.estimation.periods import FIRST, FURTHER
from compwright.estimation.usual_periods import USUAL_PERIODS
from compwright.records.axis import AxisKind, FloatArray

#: Standard deviation of the normal law of which the amplitude is one half: 1.5 µm, 1.5 arcsec.
_AMPLITUDE: Final = {AxisKind.LINEAR: 1.5e-3, AxisKind.ROTARY: 1.5 / 3600.0}
_NOTHING: Final = 1e-12


@dataclass(frozen=True, slots=True)
class HiddenPeriods:
    """That one of the ``periods`` (mm or deg) may be in the error: ``probability`` of any, and the
    ``shares`` of each (sum 1); ``amplitude``: see the module, mm or deg.
    """

    probability: float
    periods: tuple[float, ...]
    shares: tuple[float, ...]
    amplitude: float

    def waves(self, targets: FloatArray, count: int, rng: np.random.Generator) -> FloatArray:
        """Return draws (count, m) of what they may add at ``targets`` (m,)."""
        if not self.periods:
            return np.zeros((count, targets.size))
        size = np.abs(rng.normal(0.0, self.amplitude, count))
        size = size * (rng.uniform(size=count) < self.probability)
        period = rng.choice(np.array(self.periods), count, p=np.array(self.shares))
        turns = targets / period[:, np.newaxis] + rng.uniform(size=count)[:, np.newaxis]
        found: FloatArray = size[:, np.newaxis] * np.sin(2.0 * np.pi * turns)
        return found


def hidden_periods(
    targets: FloatArray, kind: AxisKind, search: PeriodSearch, *, known: bool
) -> HiddenPeriods:
    """Return what the ``targets`` (m,), mm or deg, cannot show; ``known``: whether a period is
    known to be in the error, beside which another one is rare. All that is not searched is hidden.
    """
    searched = search.curve is not None
    usual = USUAL_PERIODS[kind]
    hidden = [each for each in usual if not searched or hidden_share(targets, each.size) >= HIDDEN]
    weight = sum(each.weight for each in hidden)
    share = weight / sum(each.weight for each in usual)
    without = 0.0 if known else sum(one.probability for one in search.models if not one.periods)
    probability = 0.0
    for odds, part in ((FIRST, without), (FURTHER, 1.0 - without)):
        there = share * (odds.usual if searched else 1.0 - odds.none)
        probability += part * there / (there + odds.none)
    return HiddenPeriods(
        probability=probability,
        periods=tuple(each.size for each in hidden),
        shares=tuple(each.weight / max(weight, _NOTHING) for each in hidden),
        amplitude=_AMPLITUDE[kind],
    )
