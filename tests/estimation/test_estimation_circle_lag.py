"""The lag of both axes of a circle whose lost motion is taken up gradually: an axis stands still
after its reversal until its command has moved by the lost motion (ISO 230-4:1996, B.3.1).
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularRun, CircularTest, Sense

RADIUS = 150.0  # mm
LOST = {"first": 12.0, "second": 7.0}  # um
CENTRE = (0.05, -0.03)  # mm
SQUARENESS = 40.0  # um/m
SAMPLES, FINE = 1500, 40


def with_play(command: NDArray[np.float64], lost: float) -> NDArray[np.float64]:
    """Return the positions of a slide that its command pushes with play ``lost`` (same unit)."""
    moved = np.empty_like(command)
    at = command[0]
    for index, pushed in enumerate(command):
        at = min(max(at, pushed - 0.5 * lost), pushed + 0.5 * lost)
        moved[index] = at
    return moved


def circle(feed: float, lag: float, seed: int) -> CircularTest:
    """Return a full circle of axes that are ``lag`` s late, after a quarter of a turn before it."""
    rng = np.random.default_rng(seed)
    omega = feed / 60.0 / RADIUS
    runs = []
    senses: tuple[tuple[Sense, float], ...] = (("ccw", 1.0), ("cw", -1.0))
    for sense, sign in senses:
        step = 2.0 * np.pi / SAMPLES
        turned = (np.arange(-SAMPLES // 4 * FINE, SAMPLES * FINE) / FINE + 0.5) * step
        actual = sign * (turned - omega * lag)
        x = with_play(RADIUS * np.cos(actual), 1e-3 * LOST["first"])[SAMPLES // 4 * FINE :: FINE]
        y = with_play(RADIUS * np.sin(actual), 1e-3 * LOST["second"])[SAMPLES // 4 * FINE :: FINE]
        length = np.hypot(x - 1e-6 * SQUARENESS * y + CENTRE[0], y + CENTRE[1])
        runs.append(
            CircularRun(
                sense=sense,
                number=1,
                angles=np.degrees(sign * turned[SAMPLES // 4 * FINE :: FINE]),
                deviations=length - RADIUS + 2e-4 * rng.standard_normal(SAMPLES),
            )
        )
    return CircularTest(
        name="xy",
        plane="XY",
        axes=("X", "Y"),
        nominal_radius=RADIUS,
        feed=feed,
        arc=(0.0, 360.0),
        calibrated=True,
        runs=tuple(runs),
    )


@pytest.mark.parametrize("feed", [1000.0, 3000.0])
@pytest.mark.parametrize("lag", [0.0, 60.0])
def test_a_lag_is_told_from_lost_motion_that_is_taken_up(feed: float, lag: float) -> None:
    """12 µm are taken up over 1.9 mm of arc: 114 ms at 1000 mm/min, 38 ms at 3000 mm/min."""
    for seed in range(2):
        found = diagnose(circle(feed, 1e-3 * lag, seed))
        shown = [each.values for each in found.findings if each.code == "CW-D011"]
        assert len(shown) == (lag > 0.0)
        for values in shown:
            assert abs(float(values["lag"]) - lag) < 2.5 * float(values["error"])
        true = {
            "squareness": SQUARENESS,
            "backlash_first": LOST["first"],
            "backlash_second": LOST["second"],
            "offset_change_first": 0.0,
            "offset_change_second": 0.0,
        }
        for name, value in true.items():
            effect = found.effects[name]
            assert abs(effect.value - value) < 3.0 * effect.std_error, (name, effect)
