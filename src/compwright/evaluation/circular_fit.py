"""The least-squares circle, with the least sum of squared distances to the points (ISO 230-4:1996,
3.3 note 1 and 3.5 b).
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.records.axis import FloatArray

Point = tuple[float, float]

_MOST_STEPS: Final = 200
#: Points whose spread across their longest direction is smaller than this share of the spread along
#: it lie on a straight line: squared, it is what rounding leaves of the smaller eigenvalue.
_STRAIGHT: Final = 1e-7
#: A centre so many sizes of the figure away belongs to a straight line.
_FARTHEST: Final = 1e6
#: A step smaller than this share of the size of the figure moves the centre by less than rounding
#: does.
_STANDSTILL: Final = 1e-15
#: Steps below this share shrink until only rounding is left; one that does not ends the search.
_FLAT: Final = 1e-8


def least_squares_circle(points: FloatArray) -> tuple[Point, float]:
    """Return centre and radius of the least-squares circle through ``points`` (n, 2); same unit.

    The method is Gauss-Newton from an algebraic start, on centred and scaled coordinates. The
    radius is the mean distance and thus not a separate unknown. Partial arcs are fitted in the same
    way. Raises InputError for an array of another shape, for values that are not finite, for fewer
    than three different points, and for points on (or nearest to) a straight line.
    """
    _require_points(points)
    shift = points.mean(axis=0)
    moved = points - shift
    size = float(np.abs(moved).max())
    x, y = np.ascontiguousarray(moved.T / size) if size > 0.0 else moved.T
    _require_curved(x, y, size)
    a, b = _refined(x, y, _algebraic_centre(x, y))
    if max(abs(a), abs(b)) > _FARTHEST:
        raise InputError(
            Fault(
                message="no circle can be fitted to these points",
                expected="points nearer to a circle than to a straight line",
                hint="check the radius and the unit of the samples",
            )
        )
    radius = float(np.hypot(x - a, y - b).mean())
    return (float(shift[0] + size * a), float(shift[1] + size * b)), size * radius


def _require_points(points: FloatArray) -> None:
    if points.ndim != 2 or points.shape[1] != 2 or points.shape[0] < 3:
        found = " x ".join(str(n) for n in points.shape)
        raise InputError(
            Fault(
                message="no circle can be fitted to these points",
                expected="at least three points (x, y)",
                found=found,
                hint="give at least three points",
            )
        )
    if not np.all(np.isfinite(points)):
        raise InputError(
            Fault(
                message="no circle can be fitted to these points",
                expected="finite coordinates",
                hint="remove the points that are not numbers",
            )
        )


def _require_curved(x: FloatArray, y: FloatArray, size: float) -> None:
    scatter = np.array([[x @ x, x @ y], [x @ y, y @ y]])
    least, most = np.linalg.eigvalsh(scatter)
    if size <= 0.0 or least <= _STRAIGHT**2 * most:
        raise InputError(
            Fault(
                message="no circle can be fitted to these points",
                expected="three points that do not lie on a straight line",
                hint="give points on an arc of 90° or more",
            )
        )


def _algebraic_centre(x: FloatArray, y: FloatArray) -> Point:
    """Return the centre of an algebraic circle fit, which minimises the squares of x² + y² - 2 a x
    - 2 b y - c (Kåsa 1976). The points have mean 0.
    """
    square = x * x + y * y
    scatter = 2.0 * np.array([[x @ x, x @ y], [x @ y, y @ y]])
    a, b = np.linalg.solve(scatter, np.array([x @ square, y @ square]))
    return float(a), float(b)


def _refined(x: FloatArray, y: FloatArray, start: Point) -> Point:
    """Return the centre from which the distances of the points vary least, by Gauss-Newton steps.

    Near a circle, only rounding errors remain in the steps after a few iterations. The steps are
    not damped: in 20 000 sets of points with a scatter of half the radius, damping never changed
    the result. If the steps diverge, the points are nearest to a straight line.
    """
    centre, last = np.array(start), np.inf
    for _ in range(_MOST_STEPS):
        step = _gauss_newton_step(x - centre[0], y - centre[1])
        size = float(np.abs(step).max())
        centre = centre + step
        if size <= _STANDSTILL or last <= size < _FLAT or np.abs(centre).max() > _FARTHEST:
            break
        last = size
    return float(centre[0]), float(centre[1])


def _gauss_newton_step(dx: FloatArray, dy: FloatArray) -> FloatArray:
    """Return the change (2,) of the centre. ``dx``, ``dy``: points minus the present centre."""
    distance = np.hypot(dx, dy)
    safe = np.where(
        distance > 0.0, distance, 1.0
    )  # a point in the centre has no direction; it pulls nowhere
    u, v = dx / safe, dy / safe
    u -= u.mean()
    v -= v.mean()
    residual = distance - distance.mean()
    matrix = np.array([[u @ u, u @ v], [u @ v, v @ v]])
    step: FloatArray = np.linalg.lstsq(matrix, np.array([u @ residual, v @ residual]), rcond=None)[
        0
    ]
    return step
