"""From a test and the state of the control to the table that the control shall hold."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.estimation.axis import AxisPosterior, estimate_axis
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import ErrorEstimate, WantedCorrection
from compwright.records.positioning import PositioningTest

#: Points over the travel at which estimate and wanted correction are kept: at least, at most, and per period.
DENSE_LEAST = 401
DENSE_MOST = 4001
DENSE_PER_PERIOD = 10


def posterior_of(test: PositioningTest, axis: Axis) -> AxisPosterior:
    """Return the error of ``axis`` as one test tells it. The same test gives the same posterior."""
    return estimate_axis(test, travel=axis.travel, periods=axis.screw_pitch)


def dense_positions(axis: Axis) -> FloatArray:
    """Return equally spaced positions over the travel, close enough for the shortest known period."""
    low, high = axis.travel
    wanted = DENSE_LEAST
    if axis.screw_pitch:
        wanted = int(np.ceil((high - low) / min(axis.screw_pitch) * DENSE_PER_PERIOD)) + 1
    return np.linspace(low, high, int(np.clip(wanted, DENSE_LEAST, DENSE_MOST)))


def wanted_correction(
    estimate: ErrorEstimate, active: AxisCompensation, axis: Axis, *, reversal_log_odds: float
) -> WantedCorrection:
    """Return the totals that would remove the estimated error: what acted during the test minus the error.

    wanted(x, d) = active(x, d) - error(x, d), shifted by one constant so that it is zero at the reference approached in the
    reference-return direction. Where the reference lies outside the travel, the nearest end of the travel stands for it.
    """
    positive = active.at(estimate.positions, Direction.POSITIVE) - estimate.mean_positive
    negative = active.at(estimate.positions, Direction.NEGATIVE) - estimate.mean_negative
    at_reference = positive if axis.reference_return is Direction.POSITIVE else negative
    shift = float(np.interp(axis.reference, estimate.positions, at_reference))
    return WantedCorrection(
        kind=axis.kind,
        positions=estimate.positions,
        positive=positive - shift,
        negative=negative - shift,
        reference=axis.reference,
        reference_return=axis.reference_return,
        noise=estimate.noise,
        reversal_log_odds=reversal_log_odds,
        periods=axis.screw_pitch,
    )


def with_change(test: PositioningTest, positive: FloatArray, negative: FloatArray) -> PositioningTest:
    """Return the test as it would have come out with the correction changed by (m,) ``positive`` and ``negative``."""
    return replace(test, positive=test.positive + positive[:, np.newaxis], negative=test.negative + negative[:, np.newaxis])
