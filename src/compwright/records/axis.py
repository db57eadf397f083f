"""An axis of the machine, with its names in the job and on the control."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from compwright.foundations.units import PositionUnit

FloatArray = NDArray[np.float64]


class Direction(StrEnum):
    """Approach direction: the sign of the axis motion that arrives at the position."""

    POSITIVE = "+"
    NEGATIVE = "-"

    @property
    def sign(self) -> int:
        """+1 or -1, as a number."""
        return 1 if self is Direction.POSITIVE else -1

    @property
    def opposite(self) -> Direction:
        """The opposite direction."""
        return Direction.NEGATIVE if self is Direction.POSITIVE else Direction.POSITIVE


#: What a synchronised axis with a table of its own gets: the total of the leading axis, or its own
#: total with the change of the leading axis.
GantryTable = Literal["same", "change"]
#: How the axis was driven while a test was taken: controls may compensate backlash otherwise in
#: rapid traverse.
Motion = Literal["feed", "rapid"]


class AxisKind(StrEnum):
    """Kind of axis: linear (mm) or rotary (deg)."""

    LINEAR = "linear"
    ROTARY = "rotary"

    @property
    def unit(self) -> PositionUnit:
        """The internal unit of positions and deviations: mm or deg."""
        return "mm" if self is AxisKind.LINEAR else "deg"


@dataclass(frozen=True, slots=True)
class PositionMap:
    """The conversion of the instrument's positions: machine = sense * instrument + offset.
    ``sense`` -1 also exchanges the approach directions.
    """

    sense: Literal[1, -1] = 1
    offset: float = 0.0


@dataclass(frozen=True, slots=True)
class Encoder:
    """The measuring system of an axis: its number (1 or 2) and its type.

    Number 2 has the index 1 in files that count from 0. ``stated``: False if the measuring system
    is an assumption.
    """

    type: Literal["incremental", "absolute", "distance_coded"] = "incremental"
    system: int = 1
    stated: bool = field(default=True, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """One axis of the machine, in machine coordinates; lengths and positions in mm or deg.

    - ``address``: the control's own name of the axis as text (``"1"``, ``"AX1"``, ``"X"``,
      ``"0"``).
    - ``reference``, ``reference_return``: the correction is zero at this position, approached in
      this direction.
    - ``screw_pitch``: the known periods; empty if unknown. ``suggested_period``: a period that the
      control's files suggest; it is used only if the readings show it.
    - ``motion``: the motion in the test from which the table is made, and for which its backlash is
      valid.
    - ``gantry``: the address of the synchronised axis. ``gantry_table``: whether that axis gets the
      same total or the same change; None if the job does not state it.
    - ``moves_alone``: the job states that no other axis moves together with this one.
    - ``unapplied_steps``: the control never applies a step of the correction whose size is above
      the first number and not above the second, mm or deg.
    - ``zero_at_reference``: after homing, the control takes the correction at the reference as
      zero, whatever the table contains there.
    - ``counts_turns``: the error repeats after ``modulo``, and the positions continue from turn to
      turn over the travel.
    """

    name: str
    kind: AxisKind
    travel: tuple[float, float]
    address: str
    modulo: float | None = None
    axis_number: int | None = None
    gantry: str | None = None
    gantry_table: GantryTable | None = None
    moves_alone: bool = False
    reference: float = 0.0
    reference_return: Direction = Direction.POSITIVE
    encoder: Encoder = Encoder()
    programmed: Literal["radius", "diameter"] = "radius"
    screw_pitch: tuple[float, ...] = ()
    suggested_period: float | None = field(default=None, compare=False)
    motion: Motion = "feed"
    options: Mapping[str, object] = field(default_factory=dict)
    unapplied_steps: tuple[float, float] | None = field(default=None, compare=False)
    zero_at_reference: bool = field(default=False, compare=False)
    counts_turns: bool = field(default=False, compare=False)

    @property
    def endless(self) -> bool:
        """Whether the axis is rotary with a modulo range or a travel of a full turn: its angles may
        be counted from anywhere, and none is outside its travel.
        """
        low, high = self.travel
        whole = self.modulo is not None or high - low >= 360.0 - 1e-6
        return self.kind is AxisKind.ROTARY and whole


def partner_of(axis: Axis, address: str) -> Axis:
    """Return the slave axis of a gantry: a copy of its master axis with the slave's ``address``."""
    return replace(
        axis,
        name=f"{axis.name} ({address})",
        address=address,
        gantry=None,
        gantry_table=None,
        axis_number=None,
    )
