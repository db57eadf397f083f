"""Causes that limit the accuracy of an axis after compensation."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitingCause:
    """A cause that limits an axis. ``value``: by how much it enlarges a parameter, mm or deg.

    Both are from the same draws; it is negative where it happens to cancel another cause.

    ``rms``: of a limit of the control, the root mean square that it leaves over the travel and both
    directions (mm or deg); None: not one of those.
    """

    cause: str
    value: float
    rms: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitingCauses:
    """The causes that keep a ``parameter`` from being smaller. Its values, in mm or deg, are those
    expected in a new test at new targets.

    ``now`` with what is in the control, ``then`` with what is written, ``least`` of an axis without
    any error, by its scatter alone.

    ``spread``: the standard deviation of ``then`` from test to test, below its median: a few
    readings far off stretch it above. ``causes``, the largest first, do not add up to ``then``: the
    parameter is a range, and what two causes do at different places
    counts once.
    """

    parameter: str
    now: float
    then: float
    least: float
    spread: float
    causes: tuple[LimitingCause, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class PointCountOption:
    """The value of a parameter that is predicted if the table has this number of ``points``: median
    and range, mm or deg.

    For a new test at new targets. ``spacing``: of the points (mm or deg; the widest section).

    ``written``: the table that is written; ``there``: on the points that are in the control.
    """

    points: int
    spacing: float
    median: float
    p05: float
    p95: float
    written: bool = False
    there: bool = False
