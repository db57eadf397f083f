"""The minimum zone: the narrowest ring between two concentric circles that contains all points
(Chebyshev; ISO 230-4:1996, 3.4).

The width w(c) = max|p - c| - min|p - c| has a minimum only at a certain kind of centre c. There,
two points lie on the outer circle and two on the inner circle, and the two pairs alternate around
c. The directions to the outer pair and to the inner pair then span crossing chords of the unit
circle. Therefore w rises in every direction to first order. With three points on one circle and one
on the other, w is stationary only if two of them lie on one ray. Across this ray w is largest, not
least. So the centre is the crossing of two perpendicular bisectors.

A working-set method finds it. All crossings of the bisectors of a few points are tried. This gives
the least width for these few points exactly, which is a lower bound for all points. Points outside
this ring join the few points. Points that do not touch the ring leave when the width has grown.
When no point is outside, the lower bound is reached.
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

    The ring has the least width of all centres within a limited distance (`_reach`) of the
    least-squares centre. Seen from a centre far away, a short piece of arc looks like a strip;
    roundness does not mean this. Every point counts and lies in the ring. The width is the least
    one to within rounding (about 1e-14 of the radius). If only two points on one ray determine the
    width, many centres give the same width, to within 1e-9 of it. One of them is returned.

    Raises InputError for fewer than three different points, for points on a straight line, and for
    points whose distances from the least-squares centre differ by more than a quarter of the
    radius. Raises CapacityError if the iteration does not converge.
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

    Moving the centre by s along a unit vector e changes the distances by about s u·e. Here u are
    the unit vectors towards the points. Let k be the smallest range of u·e over all e, and w the
    present width. The width after the move is at least k s - w. A better centre therefore has s <=
    2 w / k. The result is twice this bound, to allow for terms of second order. It is at most the
    largest distance of a point.
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

    The candidates are the origin and the crossings of the points' perpendicular bisectors within
    ``reach`` of the origin. Widths that differ by at most ``tolerance`` are equal. Several centres
    are equally good if two points on one ray determine the width. Then their mean is returned,
    because it leaves the fewest points outside.
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
