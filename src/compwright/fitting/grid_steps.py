"""Equal intervals in whole resolution steps of the position, and which ones a control accepts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity

_NICE: Final = (10, 20, 25, 40, 50)  # tenths of a power of ten
_HAIR: Final = 1e-9


def is_whole(ratio: float) -> bool:
    """Return whether ``ratio`` is a whole number except for rounding errors."""
    return abs(ratio - round(ratio)) <= 1e-6 * max(1.0, abs(ratio) * 1e-3)


def points_at(start: int, step: int, count: int, quantum: float, origin: float = 0.0) -> FloatArray:
    """Return table points (count,), mm or deg: ``origin`` plus multiples of ``quantum``, with
    ``start`` and ``step`` in units of ``quantum``.
    """
    # Rounded to 10 decimals: the number that a file says, not the product's last bits.
    points: FloatArray = np.round(
        origin + (start + step * np.arange(count, dtype=np.int64)) * quantum, 10
    )
    return points


def round_steps(most: int) -> list[int]:
    """Return intervals with few digits up to ``most``, ascending, in resolution steps."""
    return [
        step
        for step in sorted(
            {int(digit * 10**exponent / 10) for exponent in range(1, 11) for digit in _NICE}
        )
        if step <= most
    ]


def allowed_steps(steps: Iterable[int], capacity: Capacity) -> list[int]:
    """Return those ``steps`` (intervals in resolution steps, > 0) that the control accepts: not
    below its smallest spacing, and among its list of spacings if it has one.
    """
    quantum = capacity.position_quantum
    long_enough = [step for step in steps if step * quantum >= capacity.min_spacing * (1 - _HAIR)]
    if capacity.spacings is None:
        return long_enough
    own = listed_steps(capacity)
    return [step for step in long_enough if step in own]


def listed_steps(capacity: Capacity) -> frozenset[int]:
    """Return the intervals, in resolution steps, that a control with a fixed list of intervals
    accepts.
    """
    return frozenset(
        round(spacing / capacity.position_quantum) for spacing in capacity.spacings or ()
    )


@dataclass(frozen=True, slots=True)
class GridCandidate:
    """Equally spaced table points, counted in resolution steps from ``origin`` (mm or deg).
    ``last`` shortens the last interval.
    """

    start: int
    step: int
    count: int
    last: int | None = None
    origin: float = 0.0

    def points(self, quantum: float) -> FloatArray:
        """Return the table points (count,), mm or deg."""
        points = points_at(self.start, self.step, self.count, quantum, self.origin)
        if self.last is not None:
            points[-1] = np.round(self.last * quantum, 10)
        return points

    def digits(self, quantum: float) -> int:
        """Return the number of digits of the interval, such as one for 50 and five for 53.125."""
        return len(f"{self.step * quantum:.10g}".replace(".", "").strip("0"))
