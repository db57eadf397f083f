"""How improbable a ratio is, as the standard normal value that is exceeded as seldom."""

from __future__ import annotations

import math


def score_of_t(t: float, dof: float) -> float:
    """Return the standard normal value as improbable as ``t`` of Student's law with ``dof`` degrees
    of freedom (sign kept).

    Wallace, Ann. Math. Statist. 30 (1959), "Bounds on normal approximations": within 0.1 for the
    values and degrees of freedom that decide anything here.
    """
    size = (8.0 * dof + 1.0) / (8.0 * dof + 3.0) * math.sqrt(dof * math.log1p(t * t / dof))
    return math.copysign(size, t)


def score_of_ratio(ratio: float, dof: float, dof_below: float) -> float:
    """Return the standard normal value as improbable as a ratio of two variances with ``dof`` and
    ``dof_below`` degrees of freedom; negative where the upper one is smaller.

    Paulson, Ann. Math. Statist. 13 (1942) 233: the cube root of F is nearly normal. Turned so that
    the larger variance stands above, where it is at its best.
    """
    if ratio < 1.0:
        return -score_of_ratio(1.0 / ratio if ratio > 0.0 else math.inf, dof_below, dof)
    if math.isinf(ratio):
        return math.inf
    a, b = 2.0 / (9.0 * dof), 2.0 / (9.0 * dof_below)
    root = math.cbrt(ratio)
    return ((1.0 - b) * root - (1.0 - a)) / math.sqrt(b * root**2 + a)


def chance(score: float) -> float:
    """Return the probability that a standard normal value is at least as far from zero."""
    return math.erfc(abs(score) / math.sqrt(2.0))
