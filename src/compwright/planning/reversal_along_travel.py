"""The reversal error of an axis along its travel, and whether drift of the test explains its
variation.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.prediction.active_corrections import Correction
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.estimate import ErrorEstimate
from compwright.records.noise import NoiseDraws
from compwright.records.positioning import PositioningTest
from compwright.records.rounding import rounded_number

#: The reversal changes by about what the drift would give: within this factor.
_ALIKE: Final = 2.0


def reversal_curve(estimate: ErrorEstimate, active: Correction) -> tuple[FloatArray, FloatArray]:
    """Return positions (k,) in the measured range, and the reversal error of the uncorrected axis
    there, mm or deg.

    The reversal error is the mean in + minus the mean in -, without the ``active`` correction. For
    a rotary axis whole turns are removed, because its travel may begin at a reference that is some
    turns away from the measured range.
    """
    low, high = estimate.measured
    where = estimate.positions
    within = low + (where - low) % 360.0 if estimate.kind is AxisKind.ROTARY else where
    inside = (within >= low) & (within <= high)
    reversal: FloatArray = (
        estimate.mean_positive
        - active(where, Direction.POSITIVE)
        - estimate.mean_negative
        + active(where, Direction.NEGATIVE)
    )
    return within[inside], reversal[inside]


def reversal_rise(estimate: ErrorEstimate, active: Correction) -> float:
    """Return how much a straight line through the reversal error of the uncorrected axis rises over
    the measured range, mm or deg.
    """
    where, reversal = reversal_curve(estimate, active)
    slope = np.polyfit(where - where[0], reversal, 1)[0]
    low, high = estimate.measured
    return rounded_number(slope * (high - low))


def drift_within_run(test: PositioningTest, noise: NoiseDraws) -> float:
    """Return the drift of the axis within a run, mm or deg, or 0 if the readings show none."""
    runs = min(int(np.max(test.readings(way), initial=0.0)) for way in Direction)
    return 0.0 if runs < 2 else rounded_number(np.median(noise.drift)) / (runs - 1)


def explained_by_drift(rise: float, within: float) -> bool:
    """Return whether a drift ``within`` each run can explain a reversal error that rises by
    ``rise``.
    """
    return within != 0.0 and 1.0 / _ALIKE <= rise / within <= _ALIKE
