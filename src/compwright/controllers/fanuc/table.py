"""The pitch error compensation of a FANUC by position, as totals in whole detection units.

The rules are taken from the manuals, independently of the definition that writes the files:

- An increment belongs to its section. With reference number r and interval b, number n belongs to
  the section from (n - r - 1) b to (n - r) b (0i-PB parameter manual B-63980EN/01 p. 100). On both
  sides of r, increments are counted from the negative towards the positive side.
- The total at the point m b is the sum of the increments from the reference to this point. It is 0
  at the reference. For m < 0 it is minus the sum of the increments in between.
- The pulses of a section are output in its middle (practice), or as a ramp with interpolated
  compensation. Outside the table the total of its end applies.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from compwright.records.axis import FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class IncrementGrid:
    """The point numbers, interval and travel per turn of an axis' table (parameters 3605#0 and 3620
    to 3627).

    ``interval``: mm or deg. ``turn``: travel per turn of an endless axis, deg; else None.
    ``negative_from``: 3626, the first point number for travel towards -; None without bidirectional
    data. ``offset``: 3627, detection units.
    """

    axis: int
    reference: int
    lowest: int
    highest: int
    magnification: int
    interval: float
    turn: float | None = None
    negative_from: int | None = None
    offset: int = 0

    def starts(self) -> tuple[int, ...]:
        """Return the first point number of the table, and that of the second set (for travel
        towards -) if the table has one.
        """
        return (self.lowest,) if self.negative_from is None else (self.lowest, self.negative_from)

    def numbers(self) -> list[int]:
        """Return all point numbers that the axis uses."""
        return [start + i for start in self.starts() for i in range(self.highest - self.lowest + 1)]

    def same_use(self, other: IncrementGrid) -> bool:
        """Return whether two axes use the same point numbers in the same way, which is allowed for
        a gantry pair.
        """
        return replace(self, axis=0) == replace(other, axis=0)


@dataclass(frozen=True, slots=True)
class PitchTable:
    """The total corrections (k,) of a pitch error table in each direction, in detection units.

    Total i (0 to k - 1) is at the position ``(first + i) * interval`` relative to the reference, mm
    or deg. ``positive``, ``negative`` (k,): totals for travel towards + and −. ``turn``: period of
    an endless axis, deg; None for an axis with ends.
    """

    first: int
    interval: float
    turn: float | None
    positive: FloatArray
    negative: FloatArray

    def positions(self) -> FloatArray:
        """Return the positions (k,) of the section ends relative to the reference, ascending."""
        return np.asarray(
            self.interval * np.arange(self.first, self.first + self.positive.size), dtype=np.float64
        )

    def pulses(self, positions: FloatArray, *, positive: bool, ramp: bool) -> FloatArray:
        """Return the correction, detection units, at ``positions`` (mm or deg from reference)
        approached towards + (if ``positive``) or −: linear within a section with ``ramp``, else in
        one step at its middle.
        """
        totals = self.positive if positive else self.negative
        x = np.asarray(positions, dtype=np.float64)
        if self.turn is not None:
            x = np.mod(x, self.turn)
        sections = np.clip(x / self.interval - self.first, 0.0, totals.size - 1)
        if not ramp:
            return np.asarray(totals[np.floor(sections + 0.5).astype(np.intp)], dtype=np.float64)
        left = np.minimum(np.floor(sections).astype(np.intp), totals.size - 2)
        return np.asarray(
            totals[left] + (sections - left) * (totals[left + 1] - totals[left]), dtype=np.float64
        )


def totals(increments: list[int], before_reference: int) -> FloatArray:
    """Return the total corrections (k + 1,) at the ends of the sections whose increments are
    ``increments`` (k,). The total is 0 after the first ``before_reference`` increments, at the
    reference.
    """
    running = np.concatenate([[0], np.cumsum(np.asarray(increments, dtype=np.int64))])
    return np.asarray(running - running[before_reference], dtype=np.float64)
