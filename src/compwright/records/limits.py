"""Causes that limit the accuracy of an axis after compensation."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitingCause:
    """A cause that limits an axis. ``value``: the amount by which it increases a parameter, mm or
    deg.

    ``value`` is the difference of the parameter with and without the cause, from the same random
    draws. It is negative if the cause happens to cancel another cause. ``rms``: if the cause is a
    limit of the control, the root mean square error that the limit leaves over the travel and both
    directions (mm or deg); else None.
    """

    cause: str
    value: float
    rms: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class LimitingCauses:
    """The causes that keep a ``parameter`` from being smaller. Its values, in mm or deg, are those
    expected in a new test at new targets.

    ``now``: with the present contents of the control. ``then``: with what is written. ``least``:
    for an axis without any error, only with its scatter. ``spread``: the standard deviation of
    ``then`` from test to test, calculated from the values below its median, because a few outlying
    readings increase those above it.

    ``causes``: the largest first. Their values do not add up to ``then``, because the parameter is
    a range: of two causes at different places it contains only one.
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

    The prediction is for a new test at new targets. ``spacing``: the largest interval of the points
    (mm or deg). ``written``: whether this table is written. ``there``: whether it has the points
    that are in the control.
    """

    points: int
    spacing: float
    median: float
    p05: float
    p95: float
    written: bool = False
    there: bool = False
