"""The machines of `benchmarks/bench_circle.py`: their geometry by the first-order formulas of the
circular test (ISO 230-4 diagnosis), their bound, and the squareness that is read from them.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from bench_circle import evaluated
from examiner_circles import TURNS, Array, Circle, circle, quiet

R, V = 150.0, 1000.0 / 60.0  # mm, mm/s


def both_ends(name: str, value: float) -> dict[str, float]:
    return {f"{name}_at_positive": value, f"{name}_at_negative": value}


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"squareness": 30.0}, lambda t, _: -0.030 * R / 2 * np.sin(2 * t)),
        ({"scale_error_first": 30.0}, lambda t, _: 0.030 * R * np.cos(t) ** 2),
        ({"scale_error_second": 30.0}, lambda t, _: 0.030 * R * np.sin(t) ** 2),
        ({"lag_first": 0.2}, lambda t, d: d * V * 0.2 / 2 * np.sin(2 * t)),
        (both_ends("backlash_first", 4.0), lambda t, d: 2 * d * np.sign(np.sin(t)) * np.cos(t)),
        (both_ends("backlash_second", 4.0), lambda t, d: -2 * d * np.sign(np.cos(t)) * np.sin(t)),
        ({"lateral_play_first": 3.0}, lambda t, d: -1.5 * d * np.abs(np.sin(t))),
        ({"lateral_play_second": 3.0}, lambda t, d: 1.5 * d * np.abs(np.cos(t))),
        ({"straightness_first": 3.0}, lambda t, _: 3 * np.cos(t) ** 2 * np.sin(t)),
        (
            {"cyclic_first": 2.0},
            lambda t, _: 2 * np.cos(2 * np.pi * R * np.cos(t) / 10) * np.cos(t),
        ),
        ({"radius_change": 0.7}, lambda t, d: 0.7 * d + 0 * t),
    ],
)
def test_geometry(values: dict[str, float], expected: Callable[[Array, float], Array]) -> None:
    """Terms in µm; what is left is of second order."""
    test = Circle(values={**quiet(), **values}, radius=R, feed=60 * V)
    for sense, sign in TURNS.items():
        angles = np.radians(test.angles(sense))
        found = 1e3 * test.readings(sense)
        np.testing.assert_allclose(found, expected(angles, sign), atol=0.002)


@pytest.mark.parametrize("friction", ["peak", "creep", "stand"])
@pytest.mark.parametrize("height", [5.0, -5.0])
def test_a_spike_has_its_height_after_its_own_reversal_alone(friction: str, height: float) -> None:
    values = {**quiet(), "reversal_spike_second_at_negative": height}
    test = Circle(values=values, radius=R, feed=60 * V, samples=36000, friction=friction)
    for sense, sign in TURNS.items():
        read, angles = 1e3 * test.readings(sense), test.angles(sense)
        after = sign * (angles - 270.0)
        assert np.max(read * np.sign(height)) == pytest.approx(5.0, rel=0.02)
        assert np.max(np.abs(read[(after < 0.0) | (after > 8.0)])) < 0.1
    assert test.peaks()["second_at_negative"] == pytest.approx(height, rel=0.02)


def test_bound() -> None:
    """Least squares by hand: one cause, white noise, the others known to be zero."""
    test = Circle(values={**quiet(), "squareness": 20.0}, noise=0.3)
    angles = np.radians(test.angles("ccw"))
    alone = 0.3 / np.sqrt(2 * np.sum((-1e-3 * R / 2 * np.sin(2 * angles)) ** 2))
    assert alone < test.bound()["squareness"] < 1.5 * alone


@pytest.mark.parametrize("number", [0, 1, 2, 3])
def test_squareness_where_the_circle_shows_it(number: int, tmp_path: Path) -> None:
    """Within three standard errors; an arc in which no axis reverses has none."""
    rng = np.random.default_rng([7, number])
    whole = circle(rng, "360")
    found = evaluated(whole, rng, tmp_path / "c.csv")["diagnosis"]["squareness"]
    assert whole.determinable(whole.bound())
    assert abs(found["value"] - whole.values["squareness"]) < 3 * found["std_error"]
    arc = circle(rng, "90 between")
    answer = evaluated(arc, rng, tmp_path / "a.csv")
    assert "errors" not in answer
    assert answer["diagnosis"] is None or answer["diagnosis"]["squareness"]["value"] is None
