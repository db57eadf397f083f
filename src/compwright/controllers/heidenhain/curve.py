"""Correction curve of one HEIDENHAIN table column, and the axes built from such curves and from
parameters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.records.axis import Direction, FloatArray

#: A turn of a rotary axis, deg: only entries from 0 to 360 are used (TNC 407 technical manual p.
#: 156).
TURN = 360.0
#: Positions meet 0 and 360 deg to this many deg: multiples of a spacing in binary numbers.
_MEETS = 1e-6


@dataclass(frozen=True, slots=True)
class CorrectionCurve:
    """Corrections ``values`` (k,) at ``nodes`` (k,): straight lines between, end values held
    outside.

    ``endless``: positions count modulo 360 deg; ``one_turn``: only 0 to 360 deg is used.
    """

    nodes: FloatArray
    values: FloatArray
    endless: bool = False
    one_turn: bool = False

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the values at ``positions`` (any shape)."""
        if self.endless:
            positions = np.mod(positions, TURN)
        elif self.one_turn:
            positions = np.clip(positions, 0.0, TURN)
        return np.asarray(np.interp(positions, self.nodes, self.values), dtype=np.float64)


@dataclass(frozen=True, slots=True)
class OwnTable:
    """The table of an axis over itself: a curve for each approach direction (the same one where the
    control has only one).
    """

    positive: CorrectionCurve
    negative: CorrectionCurve

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the values at ``positions`` arriving in ``direction``."""
        return (self.positive if direction is Direction.POSITIVE else self.negative).at(positions)

    def nodes(self) -> FloatArray:
        """Return the positions of both curves, ascending."""
        return np.union1d(self.positive.nodes, self.negative.nodes)


@dataclass(frozen=True, slots=True)
class HeidenhainAxis:
    """One axis. ``nonlinear``: its tables are active, else its linear error; never both (TNC 407
    technical manual p. 151).

    ``linear_error``: the active one, mm/m, positive when the axis travels too far; 0 with active
    tables. ``backlash``: mm or deg, positive when the encoder runs ahead and the travel is too
    short.
    """

    table: OwnTable | None
    nonlinear: bool
    linear_error: float
    reference: float
    backlash: float
    reference_return: Direction

    def correction(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.
        """
        total = np.zeros(positions.shape)
        if self.nonlinear and self.table is not None:
            total = total + self.table.at(positions, direction)
        total = total - self.linear_error * (positions - self.reference) / 1000.0
        if direction is not self.reference_return:
            total = total + direction.sign * self.backlash
        return total


def whole_turn(nodes: FloatArray) -> bool:
    """Return whether a rotary table reaches from 0 to 360 deg."""
    return bool(nodes[0] <= _MEETS and nodes[-1] >= TURN - _MEETS)


def leaves_turn(nodes: FloatArray) -> bool:
    """Return whether a rotary table has entries outside 0 to 360 deg."""
    return bool(nodes[0] < -_MEETS or nodes[-1] > TURN + _MEETS)
