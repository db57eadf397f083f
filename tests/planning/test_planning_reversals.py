"""The reversal of an axis over the measured range, wherever its travel begins."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.planning.reversal_along_travel import reversal_curve, reversal_rise
from compwright.prediction.active_corrections import no_correction
from compwright.records.axis import AxisKind
from compwright.records.estimate import ErrorEstimate

MEASURED = (5.0, 350.0)


def turned(kind: AxisKind, start: float, length: float) -> ErrorEstimate:
    """A reversal that rises by 1e-5 deg per deg of the turn from 0 to 360."""
    positions = np.linspace(start, start + length, 401)
    reversal = 1e-5 * (positions % 360.0)
    return ErrorEstimate(
        kind=kind,
        positions=positions,
        mean_positive=0.5 * reversal,
        mean_negative=-0.5 * reversal,
        std_positive=np.zeros(401),
        std_negative=np.zeros(401),
        noise=1e-6,
        noise_dof=100.0,
        measured=MEASURED,
    )


@pytest.mark.parametrize("start", [0.0, 360.0, -360.0, 90.0])
def test_a_turn_may_begin_anywhere(start: float) -> None:
    estimate = turned(AxisKind.ROTARY, start, 360.0)
    where, reversal = reversal_curve(estimate, no_correction)
    assert np.min(where) == pytest.approx(MEASURED[0], abs=1.0)
    assert np.max(where) == pytest.approx(MEASURED[1], abs=1.0)
    assert np.mean(reversal) == pytest.approx(1e-5 * np.mean(MEASURED), rel=0.01)
    assert reversal_rise(estimate, no_correction) == pytest.approx(
        1e-5 * np.ptp(MEASURED), rel=1e-6
    )


def test_of_a_linear_axis_what_was_not_measured_is_left_out() -> None:
    where, _ = reversal_curve(turned(AxisKind.LINEAR, 0.0, 720.0), no_correction)
    assert np.all((where >= MEASURED[0]) & (where <= MEASURED[1]))
