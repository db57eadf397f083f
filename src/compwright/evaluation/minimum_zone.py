"""The minimum zone: the narrowest ring between two concentric circles that contains all points
(Chebyshev; ISO 230-4:1996, 3.4).

The width w(c) = max|p - c| - min|p - c| has a minimum only where two points lie on the outer and
two on the inner circle and the two pairs alternate around the centre: there the directions to the
outer pair and to the inner pair span crossing chords of the unit circle, so that w rises in every
direction to first order. (Three on one circle and one on the other is a stationary point only if
two of them lie on one ray, where w is largest, not least, across the ray.) Such a centre is the
crossing of two perpendicular bisectors.

Working-set method: all crossings of the bisectors of a few points are tried, which gives the least
width of these few exactly, a lower bound for all points; points outside that zone join them, and
the points that do not touch it leave when the width has grown. When no point is outside, the bound
is reached.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.circular_fit import Point, least_squares_circle
from compwright.foundations.errors import CapacityError, Fault, InputError
from compwright.records.axis import FloatArray

Indices = NDArray[np.intp]

#: The points are taken in so many sectors of equal number; the outermost and the innermost of each
#: may join in a round.
_SECTORS: Final = 6
_MOST_ROUNDS: Final = 100
#: Distances from the least-squares centre that spread over more than this share of the radius are
#: not those of a circle. Below it 9 000 random sets (even, normal, heavy-tailed, coarse, spikes;
#: arcs from 90°) took 9 rounds and 14 points at most.
_NOT_ROUND: Final = 0.25
#: Crossings of all bisectors of so many points are the most that are tried at once (about 12
#: million distances).
_MOST_WORKING: Final = 40
#: Distances that differ by less, relative to the radius, are equal: some tens of roundings.
_ROUNDING: Final = 64.0 * float(np.finfo(np.float64).eps)


def minimum_zone(
    points: FloatArray, least_squares: tuple[Point, float] | None = None
) -> tuple[Point, float, float]:
    """Return centre, inner and outer radius of the narrowest ring that contains ``points`` (n, 2).
    ``least_squares``: centre and radius of the points' least-squares circle, if already known.

    The least width over all centres in the region around the least-squares centre that the reach
    bounds; a centre far away, about which a short piece of arc looks like a strip, is not what
    roundness means. Every point counts, and each lies in the annulus. The width is the least one to
    within rounding (some 1e-14 of the radius). Where two points on one ray alone set it, many
    centres give it, to 1e-9 of itself; one of them is returned.

    Raises InputError for fewer than three different points, for points on a straight line, and for
    points whose distances from the least-squares centre spread over more than a quarter of the
    radius; CapacityError if the iteration does not converge.
    """
    start, radius = least_squares or least_squares_circle(points)
    x, y = _around(points[:, 0] - start[0], points[:, 1] - start[1])
    distance = np.hypot(x, y)
    if float(np.ptp(distance)) > _NOT_ROUND * radius:
        found = f"{float(np.ptp(distance)):.4g} at a radius of {radius:.4g}"
        raise InputError(
            Fault(
                message="the points are not near a circle",
                expected="distances from the centre that differ by less than a quarter of the "
                "radius",
                found=found,
                hint="check the radius and the unit of the samples",
            )
        )
    reach = _reach(x, y, distance)
    tolerance = _ROUNDING * radius
    centre, width = np.zeros(2), -np.inf
    low, high = np.inf, -np.inf
    working = np.empty(0, dtype=np.intp)
    for _ in range(_MOST_ROUNDS):
        joining = _outside(distance, low - tolerance, high + tolerance)
        if joining.size == 0:
            return (
                (start[0] + float(centre[0]), start[1] + float(centre[1])),
                float(distance.min()),
                float(distance.max()),
            )
        working = np.union1d(working, joining)
        centre = _narrowest(x[working], y[working], reach, tolerance)
        distance = np.hypot(x - centre[0], y - centre[1])
        low, high = float(distance[working].min()), float(distance[working].max())
        if high - low > width + tolerance or working.size > _MOST_WORKING - 2 * _SECTORS:
            touching = (distance[working] < low + tolerance) | (
                distance[working] > high - tolerance
            )
            working = working[touching]
        width = max(width, high - low)
    raise CapacityError(
        Fault(
            message="the minimum zone calculation does not converge",
            found=f"{points.shape[0]} points",
            hint="send this line and the measurement file to the developers of compwright",
        )
    )


def _around(x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the points sorted by their angle about the centre, starting after the largest gap."""
    angle = np.arctan2(y, x)
    order = np.argsort(angle)
    gaps = np.diff(angle[order], append=angle[order[0]] + 2.0 * np.pi)
    order = np.roll(order, -1 - int(np.argmax(gaps)))
    return np.ascontiguousarray(x[order]), np.ascontiguousarray(y[order])


def _reach(x: FloatArray, y: FloatArray, distance: FloatArray) -> float:
    """Return an upper bound of the distance from least-squares centre to minimum-zone centre.

    Moving the centre by s along a unit vector e changes the distances by about s u·e, u the
    directions of the points. Let k be the smallest range of u·e over all e. The width is then at
    least k s minus the present one, so that a better centre has s <= 2 width / k. This is doubled
    for terms of second order, and at most the distance of the points themselves.
    """
    thin = max(1, x.size // 256)
    some = np.where(distance > 0.0, distance, 1.0)[::thin]
    turn = np.linspace(0.0, np.pi, 36, endpoint=False)
    along = np.outer(x[::thin] / some, np.cos(turn)) + np.outer(y[::thin] / some, np.sin(turn))
    least = float(np.ptp(along, axis=0).min())
    width, largest = float(np.ptp(distance)), float(distance.max())
    return min(largest, 4.0 * width / least) if least > 0.0 else largest


def _outside(distance: FloatArray, low: float, high: float) -> Indices:
    """Return the indices of points outside the ring from radius ``low`` to ``high``: of each
    sector, the farthest and the nearest point if it is outside.
    """
    bounds = np.linspace(0, distance.size, _SECTORS + 1).astype(np.intp)
    found = []
    for begin, end in pairwise(bounds):
        if begin == end:
            continue
        sector = distance[begin:end]
        far, near = int(sector.argmax()), int(sector.argmin())
        found += [begin + far] if sector[far] > high else []
        found += [begin + near] if sector[near] < low else []
    return np.array(found, dtype=np.intp)


@cache
def _pairs(n: int) -> tuple[Indices, Indices]:
    first, second = np.triu_indices(n, 1)
    return first, second


def _narrowest(x: FloatArray, y: FloatArray, reach: float, tolerance: float) -> FloatArray:
    """Return the centre (2,) of the narrowest ring that contains a few points.

    Candidates: the origin and the intersections of the points' bisectors, no farther from the
    origin than ``reach``. If several are equally good (two points on a ray determine the width),
    the middle one: it leaves the fewest points outside.
    """
    first, second = _pairs(x.size)
    nx, ny = x[second] - x[first], y[second] - y[first]
    level = 0.5 * (nx * (x[second] + x[first]) + ny * (y[second] + y[first]))
    one, other = _pairs(nx.size)
    with np.errstate(
        divide="ignore", invalid="ignore", over="ignore"
    ):  # parallel bisectors do not cross
        across = nx[one] * ny[other] - nx[other] * ny[one]
        cx = (level[one] * ny[other] - level[other] * ny[one]) / across
        cy = (nx[one] * level[other] - nx[other] * level[one]) / across
        near = np.hypot(cx, cy) <= reach
    cx, cy = np.append(cx[near], 0.0), np.append(cy[near], 0.0)
    distance = np.hypot(x[:, np.newaxis] - cx, y[:, np.newaxis] - cy)
    width = distance.max(axis=0) - distance.min(axis=0)
    best = width <= width.min() + tolerance
    return np.array([cx[best].mean(), cy[best].mean()])
