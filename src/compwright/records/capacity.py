"""The limits of a control for the table of one axis, used by fitting and prediction.

The records are made by the package ``formats``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from compwright.records.axis import Direction
from compwright.records.correction import Assumption, AxisCompensation, Beyond, Interpolation
from compwright.words.sentences import Sentence


@dataclass(frozen=True, slots=True, kw_only=True)
class Lattice:
    """Limits of a control that stores a table as whole-number increments; the correction at a point
    is the sum of the increments from the reference position to this point.

    The total at table point m is the magnification times ``unit`` times the sum of the increments
    up to m.

    - ``unit``: the detection unit, mm or deg.
    - ``increments``: the least and the largest increment, both included.
    - ``magnifications``: those that may be chosen, ascending. ``there``: the one that the control
      has now; None if it has none.
    - ``offset_range``: the range of the second table's own value at the reference, in units; None
      if the control has no such value. ``offset_magnified``: whether the magnification also
      multiplies this value.
    """

    unit: float
    increments: tuple[int, int]
    magnifications: tuple[int, ...]
    offset_range: tuple[int, int] | None = None
    offset_magnified: bool = False
    there: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Wave:
    """Limits of a cyclic table, which is active in addition to the main table and repeats with a
    short period.

    ``unit``: the size of an increment, mm or deg. ``increment``: the largest number of increments
    per section. ``room``: the number of free points. ``step``: the length of a section is a
    multiple of it, mm or deg.
    """

    unit: float
    increment: int
    room: int
    step: float

    def holds(self, section: float) -> bool:
        """Return whether the length of a table section (mm or deg) is a multiple of ``step``."""
        return abs(section / self.step - round(section / self.step)) < 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Capacity:
    """The limits of a control for the table of one axis, in mm or deg.

    - ``curves``: 1 for one table for both directions, 2 for one table per direction.
      ``second_curve``: ``"asked"`` if two tables are made only when the job asks for them.
    - ``quantum``: resolution of a table value. ``backlash_quantum``: resolution of the backlash
      value; None if the control has none in addition to the table, or ignores it.
    - ``position_quantum``: table points are multiples of it and, for ``spacing`` "equidistant",
      also the interval, so that the file contains exact values.
    - ``max_points``: the largest number of points; None if unknown. The plan then states the number
      that the control must be set to, at most ``most_points``. ``reserved_by``: the parameter that
      reserves the points, empty if none does.
    - ``lattice``: values are whole increments; ``quantum`` is then that of magnification 1.
    - ``anchored``: the points are at the reference plus whole intervals.
    - ``spacings``: the only possible intervals. ``min_spacing``: the least interval, for the reason
      ``min_spacing_reason``.
    - ``period``: that of an endless axis; the table spans exactly one period from the reference,
      and its last value equals its first.
    - ``line``: the control has no table, but one slope (mm/mm, deg/deg). The slope is a multiple of
      this number, and ``value_range`` is its range.
    - ``points``: the only possible points, because other axes use the table's grid too.
    - ``there``: the points (two or more, ascending) of the table in the control's files, active or
      not; empty if there is none. For a table that repeats they are those of one period with both
      ends.
    - ``there_shared``: other axes use the points ``there`` too, so that a table on them needs some
      of its own.
    - ``unfit``: the reason why no table of this axis can use the points ``there``; only the
      control's format knows it.
    - ``cover``: the number of intervals by which a table should extend beyond the travel on each
      side, where it is unknown what the control does beyond the table's ends.
    - ``shared_points``: the free points that all axes of the control share; None if each axis has
      its own. ``own_points``: those of ``max_points`` that belong to this axis alone.
    - ``zero``: the direction in which the correction is zero at the reference, however that is
      approached; None for the direction of the reference return. If there are two curves, the
      correction in + minus that in - at the reference must lie in ``backlash_range``.
    - ``stays``: active tables of the axis that stay, whatever is written.
    - ``slope``: a straight line in addition to the table can take a slope, a multiple of this
      number per section, mm or deg; None if there is none.
    - ``wave``: a cyclic table for a short period; None if there is none.
    - ``typed``: whether a person types in the points.
    """

    format: str
    curves: Literal[1, 2]
    spacing: Literal["equidistant", "free"]
    quantum: float
    position_quantum: float
    value_range: tuple[float, float]
    backlash_quantum: float | None = None
    backlash_range: tuple[float, float] = (0.0, 0.0)
    min_points: int = 2
    max_points: int | None = None
    reserved_by: str = ""
    lattice: Lattice | None = None
    interpolation: Interpolation = "linear"
    anchored: bool = False
    spacings: tuple[float, ...] | None = None
    min_spacing: float = 0.0
    min_spacing_reason: Sentence | None = None
    period: float | None = None
    second_curve: Literal["chosen", "asked"] = "chosen"
    line: float | None = None
    most_points: int | None = None
    points: tuple[float, ...] | None = None
    there: tuple[float, ...] = ()
    there_shared: bool = False
    unfit: str = ""
    cover: int = 0
    shared_points: int | None = None
    own_points: int = 0
    zero: Direction | None = None
    below: Beyond = "hold"
    above: Beyond = "hold"
    stays: tuple[AxisCompensation, ...] = ()
    slope: float | None = None
    wave: Wave | None = None
    typed: bool = False
    assumed: tuple[Assumption, ...] = ()

    @property
    def at_most(self) -> int | None:
        """The largest possible number of table points, or None if no limit is known."""
        limits = (self.max_points, self.most_points)
        return min((limit for limit in limits if limit is not None), default=None)

    def fewer_points(self, count: int) -> str:
        """Return the next step where a table would need ``count`` points, which are too many."""
        step = "give a larger `table: {spacing: ...}`, or leave it out"
        if not self.reserved_by or count > (self.most_points or count):
            return step
        return (
            f"{step}; or set {self.reserved_by} to {count} or more in the control (save an archive,"
            f" power on, load the archive back), and `points: {count}` in the options of the axis"
        )
