"""The points of the actual path of a circular test, and the difference of two paths by angle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.circular_fit import Point, least_squares_circle
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun

_MOST_ROUNDS: Final = 30
#: The centre stands still when it moves by less than this share of the radius: 0.15 pm at 150 mm.
_STANDSTILL: Final = 1e-12
#: Angles that differ by less (deg) are the same angle: the last digits of binary numbers.
SAME_ANGLE: Final = 1e-9


@dataclass(frozen=True, slots=True)
class ActualPath:
    """One actual path of the tool: commanded ``angles`` (n,) deg, and ``points`` (n, 2) mm relative
    to the set-up centre.
    """

    run: CircularRun
    points: FloatArray

    def distances(self, centre: Point) -> FloatArray:
        """Return the distances (n,) of the points from ``centre``, mm."""
        distances: FloatArray = np.hypot(
            self.points[:, 0] - centre[0], self.points[:, 1] - centre[1]
        )
        return distances


def paths(runs: Sequence[CircularRun], nominal_radius: float) -> tuple[ActualPath, ...]:
    """Return the actual path of each of the ``runs`` of one set-up; lengths in mm, angles in deg.

    Angles are commanded angles about the programmed centre. Distances are measured from the set-up
    centre. The two centres differ by the set-up offset. The programmed centre is assumed to be the
    least-squares centre of all runs together. Each point is placed at its measured distance from
    the set-up centre, in the direction of its commanded point. This is repeated until the centre no
    longer moves.

    If the points were placed at the commanded angles around the set-up centre, an offset e would
    produce an ellipse of e²/2R: 2.5 µm for 0.5 mm at R = 50 mm.

    Raises InputError if no circle passes through the points.
    """
    centre = (0.0, 0.0)
    placed = tuple(_placed(run, nominal_radius, centre) for run in runs)
    for _ in range(_MOST_ROUNDS):
        found, _ = least_squares_circle(np.vstack([path.points for path in placed]))
        placed = tuple(_placed(run, nominal_radius, found) for run in runs)
        if np.hypot(found[0] - centre[0], found[1] - centre[1]) <= _STANDSTILL * nominal_radius:
            break
        centre = found
    return placed


def _placed(run: CircularRun, nominal_radius: float, centre: Point) -> ActualPath:
    angle = np.radians(run.angles)
    x = nominal_radius * np.cos(angle) + centre[0]
    y = nominal_radius * np.sin(angle) + centre[1]
    factor = (nominal_radius + run.deviations) / np.hypot(x, y)
    return ActualPath(run=run, points=np.column_stack([x * factor, y * factor]))


def hysteresis(
    one: ActualPath, other: ActualPath, centre: Point, arc: tuple[float, float]
) -> float:
    """Return H, mm: the largest difference, at one angle, of the distances of two paths from
    ``centre``. ``arc``: start and extent of the test, deg. NaN where no angle is common.

    Source: ISO 230-4:1996, 3.3 and note 1. Each path is a straight line between its samples. The
    largest difference is therefore at a sample of one of the paths. Angles that only one path
    covers are left out. If a path has several samples at one angle, the largest and the smallest
    distance are used. On a full circle, each path is closed.
    """
    closed = arc[1] >= 360.0
    seam = 0.0 if closed else arc[0] - 0.5 * (360.0 - arc[1])
    curves = [_Curve.of(path, centre, seam, closed=closed) for path in (one, other)]
    begin, end = max(curve.angles[0] for curve in curves), min(curve.angles[-1] for curve in curves)
    at = np.concatenate([curve.angles for curve in curves])
    at = at[(at >= begin) & (at <= end)]
    if at.size == 0:
        return float("nan")
    low = [np.interp(at, curve.angles, curve.low) for curve in curves]
    high = [np.interp(at, curve.angles, curve.high) for curve in curves]
    return float(max((high[0] - low[1]).max(), (high[1] - low[0]).max()))


@dataclass(frozen=True, slots=True)
class _Curve:
    """Smallest and largest distance of a path from its centre at each angle (deg, ascending)."""

    angles: FloatArray
    low: FloatArray
    high: FloatArray

    @classmethod
    def of(cls, path: ActualPath, centre: Point, seam: float, *, closed: bool) -> _Curve:
        angles = np.mod(path.run.angles - seam, 360.0)
        order = np.argsort(angles)
        angles, distances = angles[order], path.distances(centre)[order]
        first = np.flatnonzero(np.diff(angles, prepend=-np.inf) > SAME_ANGLE)
        angles = angles[first]
        low, high = np.minimum.reduceat(distances, first), np.maximum.reduceat(distances, first)
        if closed:
            angles = np.concatenate([[angles[-1] - 360.0], angles, [angles[0] + 360.0]])
            low, high = (
                np.concatenate([values[-1:], values, values[:1]]) for values in (low, high)
            )
        return cls(angles=angles, low=low, high=high)
