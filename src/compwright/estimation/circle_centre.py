"""The position of the ball at the centre of a circular test, from the geometry of the path.

The angle of a circular test is the commanded angle θ. If the ball is not at the centre of the path,
the distance is r(θ) = |(R + m) u(θ) + c|. Here u = (cosθ, sinθ), c is the centre of the path seen
from the ball, R the nominal radius and m the mean deviation of the radius. The second-order part of
this distance, (c_x sinθ - c_y cosθ)² / 2R, looks like scale mismatch and squareness. A model that
is linear in c would leave this part in the data. The least-squares circle is that of ISO
230-4:1996, 3.3, but with commanded instead of measured angles.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: Rounds of Gauss-Newton. The error falls as its square: 0.5 mm on R = 50 mm is below 1e-9 mm after
#: three.
ROUNDS: Final = 3


def recentre(
    theta: FloatArray, deviations: FloatArray, radius: float
) -> tuple[float, float, float]:
    """Return (c_x, c_y, m), mm: the centre of the path and the mean deviation of its radius.

    ``theta`` (n,): commanded angles, rad. ``deviations`` (n,): measured distance minus ``radius``,
    mm. ``radius``: nominal radius, mm. The solution is by least squares (Gauss-Newton: Nocedal and
    Wright, Numerical Optimization, 2nd ed. 2006, section 10.3). A short arc cannot separate the
    three values. Then the smallest of the equally good solutions is returned.
    """
    cos, sin = np.cos(theta), np.sin(theta)
    measured = radius + deviations
    x = y = mean = 0.0
    for _ in range(ROUNDS):
        along, across = (radius + mean) * cos + x, (radius + mean) * sin + y
        distance = np.hypot(along, across)
        rows = np.column_stack(
            [along / distance, across / distance, (along * cos + across * sin) / distance]
        )
        step, *_ = np.linalg.lstsq(rows, measured - distance, rcond=None)
        x, y, mean = x + float(step[0]), y + float(step[1]), mean + float(step[2])
    return x, y, mean


def second_order(theta: FloatArray, centre: tuple[float, float], radius: float) -> FloatArray:
    """Return the second-order effect of an offset centre on the measured distance, mm (n,).

    ``theta`` (n,): commanded angles, rad. ``centre``: centre c of the path, mm. ``radius``: radius
    R, mm. The effect is |R u + c| - R - c.u with u = (cosθ, sinθ). It is computed exactly, by the
    cosine rule.
    """
    cos, sin = np.cos(theta), np.sin(theta)
    x, y = centre
    beyond: FloatArray = np.hypot(radius * cos + x, radius * sin + y) - radius - (x * cos + y * sin)
    return beyond


def radial_ranges(theta: FloatArray, curves: FloatArray) -> FloatArray:
    """Return the peak-to-peak value of each curve of radial deviations (c, n) over both runs, after
    its least-squares circle is removed.
    """
    rows = np.column_stack([np.cos(theta), np.sin(theta), np.ones_like(theta)])
    solved = np.linalg.solve(rows.T @ rows, rows.T @ curves.T)
    spread: FloatArray = np.ptp(curves - (rows @ solved).T, axis=1)
    return spread
