"""Causes that imitate other causes on a circle or an arc: each value holds the truth within its
error.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured, truth
from compwright.estimation.circle import diagnose

ARCS = [(70.0, 220.0), (250.0, 220.0), (0.0, 180.0), (100.0, 266.0)]


@pytest.mark.parametrize(("start", "extent"), ARCS)
@pytest.mark.parametrize("bent", ["s_shape_first", "s_shape_second"])
def test_a_straightness_of_third_order_is_no_squareness_of_an_arc(
    bent: str, start: float, extent: float
) -> None:
    """With its mean line at zero, 3 µm are 0.75 µm of sin4θ and 2 µm/m of squareness on 150 mm."""
    setup = Setup(start=start, extent=extent, samples=round(extent * 4.0), noise=0.1)
    machine = replace(Machine(squareness=20.0), **{bent: 3.0})  # type: ignore[arg-type]
    found = diagnose(measured(machine, setup, np.random.default_rng(7)))
    squareness = found.effects["squareness"]
    assert abs(squareness.value - 20.0) < 2.0 * squareness.std_error
    assert squareness.std_error < 25.0


@pytest.mark.parametrize("senses", [("ccw", "cw"), ("ccw",), ("cw",)])
@pytest.mark.parametrize("start", [0.0, 90.0, 180.0, 270.0])
def test_a_spiral_that_begins_at_a_reversal_point_is_no_lost_motion(
    start: float, senses: tuple[str, ...]
) -> None:
    """The jump from the end of a run to its begin has the sign of lost motion in both directions;
    only the ramp tells them apart.
    """
    setup = Setup(radius=50.0, start=start, senses=senses, noise=0.3)
    machine = Machine(spiral=-5.0, backlash_first_at_positive=3.0, backlash_first_at_negative=3.0)
    found = diagnose(measured(machine, setup, np.random.default_rng(8))).effects
    assert abs(found["spiral"].value + 5.0) < 2.0 * found["spiral"].std_error
    for name, true in truth(machine, setup).items():
        if name.startswith("backlash"):
            assert abs(found[name].value - true) < 2.5 * found[name].std_error, name
