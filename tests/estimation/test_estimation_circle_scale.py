"""The scales of a circle when the axes lag unequally: a first-order loop shrinks the travel of its
axis by (ωT)² / 2, a dead time does not (ISO 230-4:1996, B.3.2). Feedforward takes off more of the
lag than of this.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularRun, CircularTest, Diagnosis, Sense

RADIUS = 150.0  # mm
SCALE = (12.0, -20.0)  # um/m
LOST = 4.0  # um, both axes: it shows where the axes reverse


#: The response of a servo loop to its command at an angular frequency.
Loop = Callable[[float], complex]


def position_loop(time: float, share: float = 0.0, velocity: float = 0.0) -> Loop:
    """Return a loop of time constants s of position and ``velocity``; ``share`` of feedforward."""

    def response(omega: float) -> complex:
        s = 1j * omega
        return (1.0 + share * s * time) / (1.0 + s * time * (1.0 + s * velocity))

    return response


def dead_time(time: float) -> Loop:
    """Return a loop that answers late by a ``time``, s."""
    return lambda omega: complex(np.exp(-1j * omega * time))


def circle(feed: float, loops: tuple[Loop, Loop], *, seed: int, lost: float = LOST) -> CircularTest:
    """Return a full circle of axes with these servo ``loops``, from their exact positions."""
    rng = np.random.default_rng(seed)
    omega = feed / 60.0 / RADIUS
    theta = np.radians((np.arange(1500) + 0.5) * 0.24)
    runs = []
    senses: tuple[tuple[Sense, float], ...] = (("ccw", 1.0), ("cw", -1.0))
    for sense, sign in senses:
        axes = []
        for index, loop in enumerate(loops):
            answer = loop(omega)
            turned = theta + sign * np.angle(answer) - index * 0.5 * np.pi
            moves = -np.sign(sign * np.sin(turned))
            axes.append(
                RADIUS * abs(answer) * np.cos(turned) * (1.0 + 1e-6 * SCALE[index])
                - 0.5e-3 * lost * moves
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


@pytest.mark.parametrize("kind", [position_loop, dead_time])
def test_the_difference_of_the_scales_is_the_mismatch(kind: Callable[[float], Loop]) -> None:
    """At 4000 mm/min 30.5 ms and 28 ms leave 14.5 µm/m of mismatch if both loops are first-order
    and nothing if both are dead times: the error covers either, and both values are one.
    """
    found = diagnose(circle(4000.0, (kind(0.0305), kind(0.028)), seed=1))
    first, second, mismatch = scales(found)
    assert first - second == pytest.approx(mismatch, abs=1e-6)
    effect = found.effects["scale_mismatch"]
    error = effect.std_error / (2e-3 * RADIUS)
    assert abs(mismatch - (SCALE[0] - SCALE[1])) < 2.0 * error
    # Loops down to 16.7/s: (1 + f) T may be 0 to 120 ms, which gives 59 µm/m with 2.5 ms.
    assert error == pytest.approx(59.3 / np.sqrt(12.0), rel=0.2)
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
        loops = position_loop(0.0305), position_loop(0.028)
        effect = diagnose(circle(4000.0, loops, seed=seed)).effects["scale_mismatch"]
        off, error = effect.more["lag_taken_off"], effect.more["lag_error"]
        assert off is not None
        assert error is not None
        rest = np.sqrt(effect.std_error**2 - error**2)
        assert abs((effect.value - off) - across * (SCALE[0] - SCALE[1] - lost)) < 2.5 * rest
        assert rest < 4.0 * (4000.0 / 60.0) * 2.5 * np.radians(0.24) / np.sqrt(12.0)
        # The mean of 0 and 120 ms, where a loop without feedforward has 29 ms.
        assert off == pytest.approx(60.0 / 29.25 * across * lost, rel=0.05)


@pytest.mark.parametrize(
    "loops",
    [
        (position_loop(0.054, share=0.5), position_loop(0.049, share=0.5)),
        (position_loop(0.060, share=0.9), position_loop(0.055, share=0.9)),
        (position_loop(0.032, 0.99, velocity=0.006), position_loop(0.028, 0.99, velocity=0.006)),
    ],
)
@pytest.mark.parametrize("lost", [0.0, LOST])
def test_feedforward_hides_the_lag_but_not_what_it_does_to_the_scales(
    loops: tuple[Loop, Loop], lost: float
) -> None:
    """Behind 90 % of feedforward 60 ms and 55 ms differ by 0.5 ms only, and shrink the circle as
    unequally as 10 ms and 0 ms would without; a velocity loop enlarges it with no lag at all.
    """
    effect = diagnose(circle(3000.0, loops, seed=2, lost=lost)).effects["scale_mismatch"]
    assert abs(effect.value - 2e-3 * RADIUS * (SCALE[0] - SCALE[1])) < 2.0 * effect.std_error


def test_positional_tolerance_holds_what_equal_lags_do_to_the_radius() -> None:
    """Two corners on a diagonal are apart by both scales over 300 mm and, approached from opposite
    sides, by both lost motions. At 4000 mm/min lags of 30 ms shrink the radius by 26.7 µm, at 100
    mm/min by 0.02 µm; corners of such a scale are 75 µm apart.
    """
    across, equal = 2e-3 * RADIUS, (position_loop(0.03), position_loop(0.03))
    true = np.hypot(across * SCALE[0] + LOST, across * SCALE[1] - LOST)
    fast, slow = (diagnose(circle(feed, equal, seed=1)) for feed in (4000.0, 100.0))
    late, exact = (found.effects["positional_tolerance"] for found in (fast, slow))
    assert abs(late.value - true) < 2.0 * late.std_error
    assert abs(exact.value - true) < 2.0 * exact.std_error
    assert exact.std_error < 0.5
    unknown = replace(circle(100.0, equal, seed=1), calibrated=False)
    assert "positional_tolerance" in diagnose(unknown).undetermined
