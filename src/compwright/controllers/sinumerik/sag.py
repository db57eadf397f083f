"""SINUMERIK cross-axis tables (CEC): the position of one axis corrects another axis or itself.

The rules are taken from the manuals (Function Manual Extended Functions 03/2013, chapter K3; 802D
sl Function Manual 11/2012; Siemens' texts of the setting data):

- The input is the setpoint of INPUT_AXIS. The value corrects OUTPUT_AXIS, which may be the same
  axis (p. 248). Several tables add up (802D sl p. 215). Values are linear between points (p. 237);
  outside, the end values apply (p. 248). A modulo table repeats; its two end values should be equal
  (p. 249).
- DIRECTION 0: the table is active in both directions; 1: only while the input axis moves towards +;
  -1: only while it moves towards - (p. 249).
- SD41300 switches a table on or off, MD32710 of the output axis the sum of its tables (p. 245).
  SD41310 is a factor of a table, MD32720 limits the sum.
- Sign: by the Function Manual of 03/2009, p. 372, a positive value moves the axis towards -, as
  with the leadscrew table. A builder's measuring program in a real archive agrees. But values may
  have been made with the opposite sign: only the option ``cec_sign`` states it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.controllers.sinumerik.tables import CompensationTable
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Direction, FloatArray

#: Points of two tables that lie closer are one; no control divides a millimetre or a degree
#: further.
_SAME_POINT = 1e-9

#: Input and output axis.
Pair = tuple[str, str]


@dataclass(frozen=True, slots=True)
class SagTable:
    """One cross-axis table (CEC) with its weight, direction and activation.

    - ``direction``: 1: active while the input axis moves towards +; -1: towards -; 0: both.
    - ``weight``: factor of the values. ``enabled``: the table is switched on.
    - ``factor``: index of the table by which MULT_BY_TABLE multiplies this table; None without one.
    - ``stays``: the job does not change the table, so its effect is the same before and after.
    """

    input: str
    output: str
    table: CompensationTable
    direction: int
    weight: float
    enabled: bool
    factor: int | None
    stays: bool = False

    def value(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the weighted correction at ``positions`` (any shape); zero if the table is
        inactive.
        """
        if not self.enabled or self.direction == -direction.sign:
            return np.zeros(positions.shape)
        return self.weight * self.table.value(positions)

    def is_active(self) -> bool:
        """Return whether the table is on and its values are not all zero."""
        return self.enabled and self.weight != 0.0 and bool(np.any(self.table.values))

    def bound(self, direction: Direction) -> float:
        """Return the largest absolute value that the table has in ``direction``."""
        return float(np.max(np.abs(self.value(self.table.positions(), direction))))


@dataclass(frozen=True, slots=True)
class Sag:
    """All cross-axis tables (CEC) in use.

    - ``by_pair``: tables by input and output axis.
    - ``sign``: +1 if the values are corrections, -1 if they are errors, 0 if unknown.
    - ``off``: output axes whose tables MD32710 switches off.
    - ``limits``: limit of the sum of the tables (MD32720) by output axis, mm or deg.
    - ``odd``: for each axis, the reason why an active table by its own position cannot be
      evaluated.
    - ``uncounted``: axes with such a table that stays unchanged and is not included in the
      correction.
    """

    by_pair: Mapping[Pair, tuple[SagTable, ...]]
    off: frozenset[str]
    limits: Mapping[str, float]
    sign: int
    odd: Mapping[str, str] = field(default_factory=dict)
    uncounted: tuple[str, ...] = ()

    def pairs(self) -> tuple[Pair, ...]:
        """Return the pairs (input axis, output axis) of all tables in the order of their indices,
        each once.
        """
        return tuple(self.by_pair)

    def points(self, pair: Pair) -> FloatArray:
        """Return the positions (k,) of the points of all tables of an axis pair, ascending."""
        return union([table.table.positions() for table in self._of(pair)])

    def own_shift(self, axis: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction (mm or deg) of an axis by tables of its own position, at
        ``positions``.

        If the sign is unknown, tables that stay unchanged are not included. Raises UsageError if
        the effect of a table is unknown, or if the sign of another active table is unknown.
        """
        pair = (axis, axis)
        if axis in self.odd:
            raise UsageError(
                Fault(
                    message=(
                        f"axis {axis} is corrected by CEC tables over its own position, and "
                        f"their effect is unknown: {self.odd[axis]}"
                    ),
                    hint="export the CEC tables again, or leave the axis out of the job",
                )
            )
        if self.sign:
            return self.shift(pair, positions, direction)
        if all(table.stays or not table.is_active() for table in self._of(pair)):
            return np.zeros(positions.shape)
        raise UsageError(
            Fault(
                message=(
                    f"axis {axis} has CEC tables over its own position, and it is not given "
                    "whether their values are corrections or errors (opposite sign)"
                ),
                place="option cec_sign",
                expected="`cec_sign=correction` or `cec_sign=error`",
                hint="give `--option cec_sign=correction` or `--option cec_sign=error`",
            )
        )

    def shift(self, pair: Pair, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction (mm or deg) of the output axis with the input axis at ``positions``
        (any shape), moving in ``direction``. Raises UsageError for an unknown sign.
        """
        if self.sign == 0 and pair[0] != pair[1]:
            raise UsageError(
                Fault(
                    message="it is not given whether the CEC values are corrections or errors "
                    "(opposite sign)",
                    place="option cec_sign",
                    expected="`cec_sign=correction` or `cec_sign=error`",
                    hint="give `--option cec_sign=correction` or `--option cec_sign=error`",
                )
            )
        if pair[1] in self.off and pair[0] != pair[1]:
            return np.zeros(positions.shape)
        limit = self.limits.get(pair[1], np.inf)
        return np.asarray(
            self.sign * np.clip(self._total(pair, positions, direction), -limit, limit),
            dtype=np.float64,
        )

    def peak(self, pair: Pair) -> float:
        """Return the largest absolute sum of an axis pair's tables, or an upper bound of it."""
        return max(self._peak(pair, direction) for direction in Direction)

    def _peak(self, pair: Pair, direction: Direction) -> float:
        own = self._of(pair)
        if any(table.table.modulo for table in own):
            return sum(table.bound(direction) for table in own)
        return float(np.max(np.abs(self._total(pair, self.points(pair), direction))))

    def _total(self, pair: Pair, positions: FloatArray, direction: Direction) -> FloatArray:
        return sum(
            (table.value(positions, direction) for table in self._of(pair)),
            np.zeros(positions.shape),
        )

    def _of(self, pair: Pair) -> tuple[SagTable, ...]:
        return self.by_pair.get(pair, ())


def union(positions: Sequence[FloatArray]) -> FloatArray:
    """Return the points (k,) of several tables, ascending, equal ones (within 1e-9) once."""
    filled = [points for points in positions if points.size]
    if len(filled) < 2:
        return filled[0] if filled else np.empty(0)
    every = np.sort(np.concatenate(filled))
    return np.asarray(
        every[np.concatenate([[True], np.diff(every) > _SAME_POINT])], dtype=np.float64
    )
