"""The minimum zone against hand-worked figures, brute force, a linear program and the alternation
that proves it.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike
from scipy.optimize import linprog

from circular_samples import Array
from compwright.evaluation.circular_fit import least_squares_circle
from compwright.evaluation.minimum_zone import minimum_zone
from compwright.foundations.errors import InputError

#: Widths of figures of 50 to 150 mm are compared to this, mm: some hundred roundings of a distance
#: (2e-14), a millionth of a nm.
CLOSE = 1e-11


def polar(angles: ArrayLike, radii: ArrayLike, centre: tuple[float, float] = (0.0, 0.0)) -> Array:
    """Return points (n, 2) from angles in deg and radii in mm."""
    angle, radius = (
        np.radians(np.array(angles, dtype=np.float64)),
        np.array(radii, dtype=np.float64),
    )
    return np.column_stack([centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)])


def widths(points: Array, centres: Array) -> Array:
    distance = np.hypot(
        points[:, 0, np.newaxis] - centres[:, 0], points[:, 1, np.newaxis] - centres[:, 1]
    )
    return np.array(distance.max(axis=0) - distance.min(axis=0))


def brute_force(points: Array) -> float:
    """Return the least width over all centres equally far from two points and equally far from two
    others (or the same).

    Every minimum lies at such a centre; those far away, about which an arc is a strip, are left
    out. An own formula: the equations 2 (p - q)·c = |p|² - |q|² one by one.
    """
    near = np.array(least_squares_circle(points)[0])
    moved = points - near
    best = widths(moved, np.zeros((1, 2)))[0]
    lines = [(2.0 * (p - q), float(p @ p - q @ q)) for p, q in combinations(moved, 2)]
    for (one, level), (other, height) in combinations(lines, 2):
        matrix = np.array([one, other])
        if abs(np.linalg.det(matrix)) < 1e-12:
            continue
        centre = np.linalg.solve(matrix, np.array([level, height]))
        if np.hypot(*centre) < 10.0:
            best = min(best, widths(moved, centre[np.newaxis])[0])
    return float(best)


def alternates(points: Array, centre: tuple[float, float], inner: float, outer: float) -> bool:
    """Whether two points on the outer and two on the inner circle alternate around the centre.

    Then the chords of their directions cross. Points within 1e-9 mm of a circle are on it.
    """
    moved = points - np.array(centre)
    distance = np.hypot(moved[:, 0], moved[:, 1])
    angle = np.arctan2(moved[:, 1], moved[:, 0])
    ways = {True: angle[distance > outer - 1e-9], False: angle[distance < inner + 1e-9]}
    for begin, end in combinations(np.sort(ways[True]), 2):
        between = (ways[False] >= begin) & (ways[False] <= end)
        outside = (ways[False] <= begin) | (ways[False] >= end)
        if np.any(between) and np.any(outside):
            return True
    return False


def width_of(points: Array) -> float:
    _, inner, outer = minimum_zone(points)
    return outer - inner


def test_a_cross_of_two_diameters() -> None:
    """(±10.1, 0) outside and (0, ±9.9) inside alternate about the origin: no other centre has a
    smaller width than 0.2.
    """
    points = polar([0.0, 90.0, 180.0, 270.0], [10.1, 9.9, 10.1, 9.9], (3.0, -4.0))
    centre, inner, outer = minimum_zone(points)
    assert centre == pytest.approx((3.0, -4.0), abs=CLOSE)
    assert (inner, outer) == pytest.approx((9.9, 10.1), abs=CLOSE)


def test_unequal_diameters_move_the_centre() -> None:
    """Outer points at x = 10.3 and -9.9 are equally far from x = 0.2; inner ones at y = ±9 from y =
    0, 9.0022 from (0.2, 0).
    """
    centre, inner, outer = minimum_zone(
        np.array([[10.3, 0.0], [-9.9, 0.0], [0.0, 9.0], [0.0, -9.0]])
    )
    assert centre == pytest.approx((0.2, 0.0), abs=CLOSE)
    assert outer == pytest.approx(10.1, abs=CLOSE)
    assert inner == pytest.approx(np.sqrt(81.04), abs=CLOSE)


def test_an_ellipse() -> None:
    """Half axes 50.01 and 50: the width is their difference, about the middle."""
    angle = np.radians(np.arange(0.0, 360.0, 0.5))
    centre, inner, outer = minimum_zone(
        np.column_stack([50.01 * np.cos(angle), 50.0 * np.sin(angle)])
    )
    assert centre == pytest.approx((0.0, 0.0), abs=1e-9)
    assert (inner, outer) == pytest.approx((50.0, 50.01), abs=CLOSE)


@pytest.mark.parametrize("lobes", [2, 3, 5, 7])
def test_lobes(lobes: int) -> None:
    """r = 50 + 0.004 cos(k t) has k maxima and k minima that alternate about the origin: 0.008,
    whatever the eccentricity.
    """
    angle = np.arange(
        0.0, 360.0, 0.25
    )  # meets the maxima and, for even k, the minima; 1e-6 of the amplitude else
    points = polar(angle, 50.0 + 0.004 * np.cos(lobes * np.radians(angle)), (0.3, -0.4))
    centre, inner, outer = minimum_zone(points)
    assert centre == pytest.approx((0.3, -0.4), abs=1e-6)
    assert outer - inner == pytest.approx(0.008, abs=1e-7)


def test_an_arc_of_90_degrees() -> None:
    """On an arc the Chebyshev polynomial of degree 3 in the angle-like variable alternates four
    times; here four points only.

    Directions 0°, 30°, 60°, 90° with +1, -1, +1, -1 µm of a fit that has no first-order effect: the
    multipliers of r, x and y are solved for by hand in ``weights`` and give the width of the zone
    as the weighted sum of the distances.
    """
    angle = np.array([0.0, 30.0, 60.0, 90.0])
    radii = 100.0 + np.array([3.0, -2.0, 5.0, -4.0]) * 1e-3
    weights = np.linalg.solve(  # 1·w = 0, cos·w = 0, sin·w = 0, w0 + w2 = 1
        np.vstack(
            [np.ones(4), np.cos(np.radians(angle)), np.sin(np.radians(angle)), [1.0, 0.0, 1.0, 0.0]]
        ),
        [0.0, 0.0, 0.0, 1.0],
    )
    expected = float(
        weights @ radii
    )  # first order; the second is (shift 0.03 mm)²/R, about 1e-5 mm
    assert width_of(polar(angle, radii)) == pytest.approx(expected, abs=2e-5)


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.integers(3, 8),
    st.sampled_from([90.0, 180.0, 220.0, 360.0]),
    st.sampled_from([0.0, 1e-4, 0.01]),
    st.booleans(),
    st.booleans(),
)
def test_equal_to_brute_force(
    seed: int, n: int, extent: float, noise: float, twice: bool, coarse: bool
) -> None:
    """Small random sets on arcs and circles, exact ones, repeated directions and repeated
    values.
    """
    assume(n > 3 or not twice)  # two different points lie on no circle
    rng = np.random.default_rng(seed)
    angle = extent * (np.arange(n) + rng.uniform(0.0, 0.9, n)) / n
    if twice:
        angle[-1] = angle[0]
    deviation = rng.normal(0.0, 1.0, n) * noise
    if coarse:
        deviation = np.round(deviation, 3)
    points = polar(angle, 50.0 + deviation, (0.3, -0.4))
    assert width_of(points) == pytest.approx(brute_force(points), abs=CLOSE)


def test_no_circle_in_two_different_points() -> None:
    with pytest.raises(InputError, match="no circle"):
        minimum_zone(polar([0.0, 90.0, 0.0, 90.0], [50.0] * 4))


@pytest.mark.parametrize("extent", [90.0, 220.0, 360.0])
@pytest.mark.parametrize("n", [40, 1500])
def test_the_touching_points_alternate(extent: float, n: int) -> None:
    for seed in range(10):
        rng = np.random.default_rng(seed)
        points = polar(rng.uniform(0.0, extent, n), 50.0 + rng.normal(0.0, 0.002, n), (0.5, 0.0))
        centre, inner, outer = minimum_zone(points)
        assert alternates(points, centre, inner, outer)
        distance = np.hypot(points[:, 0] - centre[0], points[:, 1] - centre[1])
        assert (distance.min(), distance.max()) == pytest.approx((inner, outer), abs=CLOSE)


@pytest.mark.parametrize("extent", [90.0, 360.0])
def test_no_smaller_than_the_linear_program_allows(extent: float) -> None:
    """Distances from a centre moved by s are at least d - u·s: no s within 0.1 mm beats the program
    by more than s²/2r.
    """
    rng = np.random.default_rng(5)
    points = polar(rng.uniform(0.0, extent, 600), 50.0 + rng.normal(0.0, 0.002, 600), (0.2, 0.5))
    centre, inner, outer = minimum_zone(points)
    moved = points - np.array(centre)
    distance = np.hypot(moved[:, 0], moved[:, 1])
    direction = moved / distance[:, np.newaxis]
    one = np.ones((distance.size, 1))
    zero = np.zeros((distance.size, 1))
    # unknowns s_x, s_y, outer, inner: d - u·s <= outer, d - u·s >= inner
    program = linprog(
        [0.0, 0.0, 1.0, -1.0],
        A_ub=np.vstack([np.hstack([-direction, -one, zero]), np.hstack([direction, zero, one])]),
        b_ub=np.concatenate([-distance, distance]),
        bounds=[(-0.1, 0.1), (-0.1, 0.1), (None, None), (None, None)],
        method="highs-ds",
    )
    assert program.status == 0
    assert outer - inner == pytest.approx(
        program.fun, abs=1e-9
    )  # HiGHS works to 1e-7 of its tolerances; met far better here


def test_two_points_on_one_ray_set_the_width() -> None:
    """A spike of 20 µm in one of two runs, -1 µm in the other at the same angle: no centre can
    bring the two closer.

    Both runs scatter by less than 1 µm otherwise, so many centres leave all other points between
    the two.
    """
    rng = np.random.default_rng(3)
    angle = np.tile(np.arange(0.0, 360.0, 0.25), 2)
    deviation = rng.uniform(-0.5e-3, 0.5e-3, angle.size)
    deviation[480], deviation[480 + 1440] = 0.02, -0.001
    _, inner, outer = minimum_zone(polar(angle, 150.0 + deviation))
    assert outer - inner == pytest.approx(
        0.021, abs=1e-9
    )  # the ray turns by the shift over the radius: 0.021 (1e-4)²/2


def test_eccentric_circle_is_still_a_circle() -> None:
    """0.5 mm off centre at R = 50: a centre term alone, without its second order, would leave 2.5
    µm.
    """
    angle = np.arange(0.0, 360.0, 0.3)
    centre, inner, outer = minimum_zone(polar(angle, np.full(angle.size, 50.0), (0.5, 0.0)))
    assert centre == pytest.approx((0.5, 0.0), abs=CLOSE)
    assert outer - inner < CLOSE


def test_every_point_counts() -> None:
    """One sample of 3000 stands out by 50 µm: a moved centre is as much nearer to its neighbours,
    0.12° beside.
    """
    deviation = np.zeros(3000)
    deviation[1234] = 0.05
    angle = np.arange(3000) * 0.12
    width = width_of(polar(angle, 150.0 + deviation))
    assert width == pytest.approx(0.05, abs=1e-6)  # 0.05 (1 - cos 0.12°) is 1e-7


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.floats(-500.0, 500.0),
    st.floats(0.0, 360.0),
    st.floats(0.01, 100.0),
)
def test_shift_turn_and_scale(seed: int, shift: float, turn: float, scale: float) -> None:
    """The width does not depend on place and direction and grows with the scale, to the roundings
    of coordinates of 1000 mm.
    """
    rng = np.random.default_rng(seed)
    angle, radius = np.sort(rng.uniform(0.0, 270.0, 200)), 50.0 + rng.normal(0.0, 0.005, 200)
    plain = width_of(polar(angle, radius))
    moved = width_of(scale * polar(angle + turn, radius, (shift, -2.0 * shift)))
    assert moved == pytest.approx(scale * plain, abs=1e-11 * max(scale, 1.0))


@settings(max_examples=100, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.integers(5, 400),
    st.floats(1e-6, 1.0),
    st.sampled_from(["normal", "heavy", "spikes"]),
)
def test_wild_points_give_a_zone_or_are_refused(seed: int, n: int, size: float, kind: str) -> None:
    """Scatter up to the radius: the zone holds all points and is no wider than that about the
    least-squares centre.
    """
    rng = np.random.default_rng(seed)
    spikes = (rng.random(n) < 0.02).astype(np.float64)
    scatter = {
        "normal": rng.normal(size=n),
        "heavy": rng.standard_cauchy(size=n),
        "spikes": spikes,
    }[kind]
    points = polar(rng.uniform(0.0, 360.0, n), 1.0 + size * scatter)
    try:
        centre, inner, outer = minimum_zone(points)
    except InputError:
        assert np.ptp(size * scatter) > 0.05  # of the radius: what could not be round
        return
    close = CLOSE * max(1.0, outer)  # heavy tails can have radii of 1e5
    assert widths(points, np.array([centre]))[0] == pytest.approx(outer - inner, abs=close)
    assert outer - inner <= widths(points, np.array([least_squares_circle(points)[0]]))[0] + close


def test_points_far_from_any_circle() -> None:
    square = np.array([[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0], [0.1, 0.0], [-0.1, 0.0]])
    with pytest.raises(InputError, match="not near a circle"):
        minimum_zone(square)


def test_coarse_readings_with_many_ties() -> None:
    """Readings in steps of 1 µm: hundreds of points share each circle."""
    rng = np.random.default_rng(9)
    angle = np.tile(np.arange(0.0, 360.0, 0.24), 2)
    deviation = np.round(3.0 * np.cos(2.0 * np.radians(angle)) + rng.normal(size=angle.size)) * 1e-3
    points = polar(angle, 150.0 + deviation, (0.004, 0.002))
    centre, inner, outer = minimum_zone(points)
    assert alternates(points, centre, inner, outer)
    assert outer - inner <= np.ptp(deviation) + CLOSE
