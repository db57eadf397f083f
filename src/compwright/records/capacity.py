"""What one axis of one control can hold: built by ``formats``, seen by ``fitting`` and ``prediction`` instead of the control."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from compwright.records.correction import Assumption, Beyond


@dataclass(frozen=True, slots=True, kw_only=True)
class Capacity:
    """Limits of one axis' table, mm or deg.

    ``curves`` 1: one table for both directions; 2: one per direction. ``quantum``: resolution of a table value.
    ``backlash_quantum`` None: the control has no backlash value beside the table (or ignores it). ``position_quantum``: nodes,
    and with ``spacing`` "equidistant" the step too, must be multiples of it so that the file says them exactly.
    ``max_points`` None: not known; the plan then says how many the control must be set to hold. ``max_increment`` is the largest
    difference of neighbouring values; None: unlimited.
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
    max_increment: float | None = None
    below: Beyond = "hold"
    above: Beyond = "hold"
    assumed: tuple[Assumption, ...] = ()
