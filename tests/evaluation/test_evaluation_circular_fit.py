"""The least-squares circle against certified results, hand-worked figures and the condition that
defines it.
"""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from circular_samples import Array, table
from compwright.evaluation.circular_fit import least_squares_circle
from compwright.foundations.errors import InputError
from places import REAL, needs_shared


def on_circle(
    angles: ArrayLike, radii: ArrayLike, centre: tuple[float, float] = (0.0, 0.0)
) -> Array:
    angle, radius = np.array(angles, dtype=np.float64), np.array(radii, dtype=np.float64)
    return np.column_stack([centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)])


@needs_shared
def test_certified_circles() -> None:
    """NIST cir2d1..30, partial arcs from 90°: centre and diameter to 1e-8 of the diameter, what the
    certificate's use needs.
    """
    points = defaultdict(list)
    for row in table(REAL / "circle" / "nist_cir2d_points.csv"):
        points[row["set"]].append([float(row[name]) for name in "xyz"])
    certified = table(REAL / "circle" / "nist_cir2d_lsq_fits.csv")
    assert len(certified) == 30
    for row in certified:
        plane = [i for i, name in enumerate("xyz") if abs(float(row[f"n{name}"])) < 0.5]
        centre, radius = least_squares_circle(np.array(points[row["set"]])[:, plane])
        expected = [float(row[f"c{'xyz'[i]}"]) for i in plane]
        diameter = float(row["diameter"])
        assert np.hypot(centre[0] - expected[0], centre[1] - expected[1]) < 1e-8 * diameter, row[
            "set"
        ]
        assert abs(2.0 * radius - diameter) < 1e-8 * diameter, row["set"]


def test_three_points_lie_on_their_circle() -> None:
    """(5, 0), (0, 5) and (-3, -4) lie on the circle about 0 of radius 5; shifted by (100, -7)."""
    centre, radius = least_squares_circle(np.array([[105.0, -7.0], [100.0, -2.0], [97.0, -11.0]]))
    assert centre == pytest.approx((100.0, -7.0), abs=1e-12)  # some roundings of 100
    assert radius == pytest.approx(5.0, abs=1e-12)


def test_four_points_of_a_cross() -> None:
    """(±11, 0) and (0, ±9): by symmetry about 0 the centre is 0, and the radius is the mean
    distance, 10.
    """
    centre, radius = least_squares_circle(
        np.array([[11.0, 0.0], [-11.0, 0.0], [0.0, 9.0], [0.0, -9.0]])
    )
    assert centre == pytest.approx((0.0, 0.0), abs=1e-12)
    assert radius == pytest.approx(10.0, abs=1e-12)


def test_distances_are_orthogonal_not_algebraic() -> None:
    """A fit of the squares gives a radius of sqrt((11² + 9²)/2) = 10.0499 for the cross, not 10."""
    _, radius = least_squares_circle(np.array([[11.0, 0.0], [-11.0, 0.0], [0.0, 9.0], [0.0, -9.0]]))
    assert abs(radius - 10.0499) > 0.04


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.integers(5, 300),
    st.floats(90.0, 360.0),
    st.floats(0.0, 0.02),
    st.floats(-1000.0, 1000.0),
)
def test_no_centre_nearby_is_better(
    seed: int, n: int, extent: float, noise: float, shift: float
) -> None:
    """The variance of the distances is stationary at the centre and larger beside it, also far from
    the origin.
    """
    rng = np.random.default_rng(seed)
    angle = np.radians(np.linspace(0.0, extent * (1.0 - 1.0 / n), n))
    points = on_circle(angle, 50.0 + rng.normal(0.0, 1.0, n) * noise, (shift, -shift))
    centre, radius = least_squares_circle(points)

    def cost(dx: float, dy: float) -> float:
        distance = np.hypot(points[:, 0] - centre[0] - dx, points[:, 1] - centre[1] - dy)
        return float(np.sum((distance - distance.mean()) ** 2))

    step = 0.01  # mm: the curvature of the cost stands far above its rounding (1e-13 mm)²
    for way in np.radians(np.arange(0, 360, 30)):
        assert cost(0.0, 0.0) <= cost(step * np.cos(way), step * np.sin(way)) + 1e-20
    distance = np.hypot(points[:, 0] - centre[0], points[:, 1] - centre[1])
    assert radius == pytest.approx(distance.mean(), abs=1e-11)
    direction = (points - np.array(centre)) / distance[:, np.newaxis]
    slope = direction.T @ (
        distance - radius
    )  # zero at the least; rounding of distances (1e-13 mm at 1000 mm) times n
    assert np.abs(slope).max() < 1e-10 * n


@pytest.mark.parametrize(
    "points",
    [
        [[0.0, 0.0], [1.0, 1.0]],
        [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [7.0, 7.0]],
        [[3.0, 4.0], [3.0, 4.0], [3.0, 4.0], [3.0, 4.0]],
        [[3.0, 4.0], [3.0, 4.0], [5.0, 4.0], [5.0, 4.0]],
        [[0.0, 0.0], [1.0, 0.0], [0.0, np.nan], [1.0, 1.0]],
        [[0.0, 0.0], [1.0, 0.0], [0.0, np.inf], [1.0, 1.0]],
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    ],
)
def test_no_circle(points: list[list[float]]) -> None:
    with pytest.raises(InputError, match="no circle"):
        least_squares_circle(np.array(points))


def test_a_point_in_the_centre_is_no_obstacle() -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
    centre, radius = least_squares_circle(points)
    assert np.all(np.isfinite([*centre, radius]))


def cloud(seed: int) -> Array:
    """Return a few points that scatter by half the radius, nothing like a circle."""
    rng = np.random.default_rng(seed)
    n = rng.integers(4, 9)
    return on_circle(rng.uniform(0.0, 2.0 * np.pi, n), 1.0 + rng.normal(0.0, 0.5, n))


@pytest.mark.parametrize("seed", range(4, 80))
def test_points_unlike_a_circle(seed: int) -> None:
    points = cloud(seed)
    centre, radius = least_squares_circle(points)
    offset = points - np.array(centre)
    distance = np.hypot(offset[:, 0], offset[:, 1])
    assert (
        np.abs((offset / distance[:, np.newaxis]).T @ (distance - radius)).max() < 1e-12
    )  # stationary to rounding


def test_points_nearest_to_a_straight_line() -> None:
    with pytest.raises(InputError, match="straight line"):
        least_squares_circle(cloud(3))
