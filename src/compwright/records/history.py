"""The history of a machine: one entry for each test, from the records of result folders."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

#: Whether the same table was active in two tests; ``unknown``: their files differ, or do not say.
SameTable = Literal["same", "changed", "unknown"]


@dataclass(frozen=True, slots=True, kw_only=True)
class HistoryEntry:
    """One test of an axis or of a plane in the history of a machine.

    - ``folder``: the result folder. ``number``: the place of the test in it. ``what``: the axis, or
      the plane of a circle.
    - ``date``: the date as the file states it. ``day``: the same date in a form that can be sorted
      (ISO 8601). Both are empty if the file states none.
    - ``values``: the parameters, by name, in ``unit``; ``squareness`` of a circle and ``slope`` of
      a linear axis in µm/m. ``errors``: standard error and degrees of freedom. ``declared``:
      expanded uncertainty and coverage factor. ``limits``: by parameter.
    - ``means``: the mean deviation at each target in direction + and -; empty if unknown.
    - ``table``: the table that was active, in a word. ``acting``: a hash of the table's files;
      empty if unknown.
    - ``sources``: SHA-256 of the test's files. ``instrument``: as the file names it.
    """

    folder: str
    number: int
    machine: str
    serial: str
    what: str
    kind: Literal["positioning", "circular"]
    rotary: bool
    test: str
    taken: Literal["before", "after"]
    date: str
    day: str
    unit: str
    standard: str
    values: Mapping[str, float]
    errors: Mapping[str, tuple[float, float]]
    declared: Mapping[str, tuple[float, float]]
    targets: tuple[float, ...]
    means: tuple[tuple[float, ...], tuple[float, ...]]
    table: str
    acting: str
    verdict: str
    sources: tuple[str, ...]
    simulated: bool
    instrument: str
    limits: Mapping[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class NotedChange:
    """A change of a parameter between two tests that is larger than its uncertainty explains.

    ``size``, ``std_error``: in the unit of the parameter. ``chance``: the probability that two
    tests of an unchanged machine differ as much. ``score``: the standard normal value that has this
    probability.
    """

    parameter: str
    before: int
    after: int
    value_before: float
    value_after: float
    size: float
    std_error: float
    score: float
    chance: float
    table: SameTable
    undeclared: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class NotedJump:
    """A sudden change of a parameter between two tests in a history."""

    before: int
    after: int
    size: float
    std_error: float


@dataclass(frozen=True, slots=True, kw_only=True)
class NotedTrend:
    """The rate at which a parameter changes, in its unit per year, and the day on which the
    parameter will reach its limit.

    ``interval``: the ends of the rate's 95 % interval. ``tests``: the entries from which the rate
    is estimated, by their places in the series. ``limit``: the limit, or None if none is given.
    ``reached``: the median of the day on which the limit will be reached. ``earliest``, ``latest``:
    the ends of the 90 % interval of this day. Days are in ISO 8601, and empty if they are more than
    30 years ahead.
    """

    parameter: str
    rate: float
    interval: tuple[float, float]
    std_error: float
    clear: bool
    tests: tuple[int, ...]
    jumps: tuple[NotedJump, ...]
    limit: float | None
    reached: str
    earliest: str
    latest: str
