"""The scales of a circle when the axes lag unequally: a first-order loop shrinks the travel of its
axis by (ωT)² / 2, a dead time does not (ISO 230-4:1996, B.3.2).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularRun, CircularTest, Diagnosis, Sense

RADIUS = 150.0  # mm
SCALE = (12.0, -20.0)  # um/m
LOST = 4.0  # um, both axes: it shows where the axes reverse


def circle(feed: float, lags: tuple[float, float], *, first_order: bool, seed: int) -> CircularTest:
    """Return a full circle of axes that lag by ``lags`` s, from their exact positions."""
    rng = np.random.default_rng(seed)
    omega = feed / 60.0 / RADIUS
    theta = np.radians((np.arange(1500) + 0.5) * 0.24)
    runs = []
    senses: tuple[tuple[Sense, float], ...] = (("ccw", 1.0), ("cw", -1.0))
    for sense, sign in senses:
        axes = []
        for index, lag in enumerate(lags):
            late = np.arctan(omega * lag) if first_order else omega * lag
            turned = theta - sign * late - index * 0.5 * np.pi
            shrunk = np.cos(late) if first_order else 1.0
            moves = -np.sign(sign * np.sin(turned))
            axes.append(
                RADIUS * shrunk * np.cos(turned) * (1.0 + 1e-6 * SCALE[index])
                - 0.5e-3 * LOST * moves
            )
        length = np.hypot(*axes) + 2e-4 * rng.standard_normal(theta.size)
        runs.append(
            CircularRun(sense=sense, number=1, angles=np.degrees(theta), deviations=length - RADIUS)
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


def scales(found: Diagnosis) -> tuple[float, float, float]:
    """Return both scales and the mismatch by the diameter, um/m."""
    first, second = (found.effects[f"scale_error_{axis}"].value for axis in ("first", "second"))
    return first, second, found.effects["scale_mismatch"].value / (2e-3 * RADIUS)


@pytest.mark.parametrize("first_order", [True, False])
def test_the_difference_of_the_scales_is_the_mismatch(first_order: bool) -> None:
    """At 4000 mm/min 30.5 ms and 28 ms leave 14.5 µm/m of mismatch if both loops are first-order
    and nothing if both are dead times: the error covers either, and both values are one.
    """
    found = diagnose(circle(4000.0, (0.0305, 0.028), first_order=first_order, seed=1))
    first, second, mismatch = scales(found)
    assert first - second == pytest.approx(mismatch, abs=1e-6)
    effect = found.effects["scale_mismatch"]
    error = effect.std_error / (2e-3 * RADIUS)
    assert abs(mismatch - (SCALE[0] - SCALE[1])) < 1.5 * error
    assert 6.0 < error < 11.0  # half of 14.5, and how far into a sample the axes reverse
    order = list(found.names)
    both = found.correlation[order.index("scale_mismatch"), order.index("scale_error_first")]
    assert both > 0.0


def test_what_is_taken_off_is_stated_and_gives_the_reading_back() -> None:
    """An angle that is wrong by a tenth of a sample turns a servo mismatch of 2.5 ms into 0.28 µm
    of scale mismatch: the error holds that too. A step shows between two samples, all the same at
    each reversal point: its angle is uniform over a sample (standard deviation 1/sqrt(12)), and the
    error is no larger than this makes it.
    """
    omega = 4000.0 / 60.0 / RADIUS
    lost = 0.5e6 * omega**2 * (0.0305**2 - 0.028**2)
    across = 2e-3 * RADIUS
    for seed in range(4):
        effect = diagnose(circle(4000.0, (0.0305, 0.028), first_order=True, seed=seed)).effects[
            "scale_mismatch"
        ]
        off, error = effect.more["lag_taken_off"], effect.more["lag_error"]
        assert off is not None
        assert error is not None
        rest = np.sqrt(effect.std_error**2 - error**2)
        assert abs((effect.value - off) - across * (SCALE[0] - SCALE[1] - lost)) < 2.5 * rest
        assert rest < 4.0 * (4000.0 / 60.0) * 2.5 * np.radians(0.24) / np.sqrt(12.0)
        assert off == pytest.approx(0.5 * across * lost, rel=0.25)


def test_positional_tolerance_holds_what_equal_lags_do_to_the_radius() -> None:
    """Two corners on a diagonal are apart by both scales over 300 mm and, approached from opposite
    sides, by both lost motions. At 4000 mm/min lags of 30 ms shrink the radius by 26.7 µm, at 100
    mm/min by 0.02 µm; corners of such a scale are 75 µm apart.
    """
    across = 2e-3 * RADIUS
    true = np.hypot(across * SCALE[0] + LOST, across * SCALE[1] - LOST)
    fast, slow = (
        diagnose(circle(feed, (0.03, 0.03), first_order=True, seed=1)) for feed in (4000.0, 100.0)
    )
    late, exact = (found.effects["positional_tolerance"] for found in (fast, slow))
    assert abs(late.value - true) < 2.0 * late.std_error
    assert abs(exact.value - true) < 2.0 * exact.std_error
    assert exact.std_error < 0.5
    unknown = replace(circle(100.0, (0.03, 0.03), first_order=True, seed=1), calibrated=False)
    assert "positional_tolerance" in diagnose(unknown).undetermined
