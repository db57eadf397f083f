"""The limits of a control for the table of one axis, used by fitting and prediction.

Built by ``formats``.
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

    The total at table point m = magnification * ``unit`` * sum of the increments up to m.

    ``unit`` is the detection unit, mm or deg; ``increments`` the least and largest increment, both
    included; ``magnifications`` those that may be chosen, ascending. ``offset_range``: the second
    table's own value at the reference, in units; None: there is none. ``offset_magnified``: that
    value is multiplied by the magnification too. ``there``: the magnification that the control has
    now; None: it has none.
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

    ``unit``: the size of an increment, mm or deg; ``increment``: the most of them per section;
    ``room``: the number of free points; ``step``: sections are multiples of it, mm or deg.
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

    ``curves`` 1: one table for both directions; 2: one per direction. ``quantum``: resolution of a
    table value. ``backlash_quantum`` None: the control has no backlash value in addition to the
    table (or ignores it). ``position_quantum``: table points, and for ``spacing``
    "equidistant" also the step, are multiples of it, so that the file contains exact values.
    ``max_points`` None: unknown; the plan then states the number that the control must be set to,
    at most ``most_points``.

    ``lattice``: values are whole increments (``quantum`` is then that of magnification 1).
    ``anchored``: the points are at the reference plus whole spacings. ``spacings``: the only ones
    possible; ``min_spacing``: none below it, for the reason ``min_spacing_reason``. ``period``: an
    endless axis; the table spans exactly one period from the reference, its last value equals its
    first. ``second_curve`` "asked": two tables only when the job asks for them. ``line``: no table
    at all but one slope (mm/mm, deg/deg), a multiple of this number, within ``value_range`` taken
    as slopes. ``nodes``: the only possible points, because other axes use the table's grid too.
    ``there``: the points (two or more, ascending; for a table that repeats, a period and both ends)
    of the table in the control's files, active or not; empty: there is none.
    ``there_shared``: other axes use its points too, so that a table on it needs some of its own.
    ``unfit``: why no table of this axis can use them, which only the control's format knows.
    ``cover``: whole spacings by which a table should reach beyond the travel on each side, where
    the control's action beyond its ends is unknown. ``shared_points``: the free points that all
    axes of the control share (None: each axis has its own), ``own_points``: those of ``max_points``
    that belong to this axis alone. ``zero``: the direction in which the correction is zero at the
    reference, however that is approached (None: that of the reference return); of two curves, the
    correction in + less that in - at the reference then lies in ``backlash_range``. ``stays``:
    active tables of the axis that stay, whatever is written. ``slope``: a straight line in addition
    to the table can take a slope, a multiple of this per section, mm or deg; None: there is none.
    ``wave``: a cyclic table for a short period; None: there is none. ``typed``: its points are
    typed by hand.
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
    nodes: tuple[float, ...] | None = None
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
