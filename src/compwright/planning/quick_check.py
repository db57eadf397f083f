"""Positions for a quick check of a loaded table at the machine, with the readings to expect."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from compwright.planning.axis_work import AxisWork
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import Direction, FloatArray

#: A reading further off than this many times the scatter of one reading is no accident (with a
#: normal scatter, one in 10^6).
STOP_SCATTER = 5.0


@dataclass(frozen=True, slots=True)
class CheckReading:
    """One reading of the quick check, mm or deg.

    ``adds``: the correction that the control adds at this position. ``expected``: the expected
    reading. ``stop``: the difference from the expected reading at which the engineer must stop.
    """

    position: float
    direction: Direction
    adds: float
    expected: float
    stop: float


def check_positions(work: AxisWork, new: Correction) -> FloatArray:
    """Return the three positions of the quick check: targets of the first test within the travel.

    Two are the ends. The third is the target at which the new correction deviates most from the
    straight line through the ends, because a wrong sign shows there best.
    """
    low, high = work.planned.axis.travel
    targets = work.results[0].test.targets
    inside = targets[(targets >= low) & (targets <= high)]
    if inside.size < 3:
        return np.array([low, (low + high) / 2, high])
    ends, middle = inside[[0, -1]], inside[1:-1]
    line = np.interp(middle, ends, new(ends, Direction.POSITIVE))
    off = np.round(np.abs(new(middle, Direction.POSITIVE) - line), 9)
    central = np.argsort(
        np.abs(middle - ends.mean()), kind="stable"
    )  # of equal ones the one in the middle
    return np.array([ends[0], middle[central[np.argmax(off[central])]], ends[1]])


def quick_check(work: AxisWork, new: Correction) -> Iterator[CheckReading]:
    """Yield the expected readings at the check positions in + and then −. The instrument is zeroed
    at the first position in +.
    """
    change = difference(new, work.active)
    chosen = check_positions(work, new)
    estimate = work.estimate_at(chosen)
    zero = float(estimate.mean_positive[0] + change(chosen[:1], Direction.POSITIVE)[0])
    stop = STOP_SCATTER * np.hypot(estimate.noise * np.sqrt(2), estimate.std_positive)
    for direction, order in ((Direction.POSITIVE, (0, 1, 2)), (Direction.NEGATIVE, (2, 1, 0))):
        expected = estimate.mean(direction) + change(chosen, direction)
        adds = new(chosen, direction)
        for index in order:
            yield CheckReading(
                position=float(chosen[index]),
                direction=direction,
                adds=float(adds[index]),
                expected=float(expected[index]) - zero,
                stop=float(stop[index]),
            )


def moved_by(work: AxisWork, new: Correction, position: float) -> float:
    """Return how far a fixed position of an axis moves, mm or deg, when ``new`` replaces the
    present correction.

    If the control takes the correction at the reference as zero after homing, a change of the
    correction at the reference moves nothing.
    """
    axis, change = work.planned.axis, difference(new, work.as_found)
    moved, zero = change(np.array([position, axis.reference]), axis.reference_return)
    return float(moved - zero if axis.zero_at_reference else moved)
