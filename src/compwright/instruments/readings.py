"""The readings of one test as columns, because a file may contain a million of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import Direction, FloatArray
from compwright.records.environment import Clock

IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class ApproachReading:
    """One reading: ``target``, ``deviation`` (measured minus target), mm or deg, and its place in
    the file.
    """

    target: float
    direction: Direction
    run: int
    deviation: float
    place: str


@dataclass(frozen=True, slots=True, eq=False)
class Readings:
    """The readings of one test in the order of the file, mm or deg.

    ``targets`` and ``deviations`` (n,). ``positive`` (n,): whether the target was approached in
    direction +. ``runs`` (n,): the run number, from 1. ``place``: a function that returns the place
    of a reading in the file from its index. ``times`` (n,): the time of each reading in the form
    ``clock``, or None if the file does not state times.
    """

    targets: FloatArray
    positive: BoolArray
    runs: IntArray
    deviations: FloatArray
    place: Callable[[int], str]
    clock: Clock = "number"
    times: FloatArray | None = None

    def __len__(self) -> int:
        """Return the number of readings."""
        return int(self.targets.size)

    def one(self, index: int) -> ApproachReading:
        """Return one reading by its index."""
        return ApproachReading(
            float(self.targets[index]),
            Direction.POSITIVE if self.positive[index] else Direction.NEGATIVE,
            int(self.runs[index]),
            float(self.deviations[index]),
            self.place(index),
        )

    def only(self, chosen: BoolArray | IntArray) -> Readings:
        """Return the readings selected by a mask or by indices, in the order of the indices."""
        indices = np.arange(len(self))[chosen]
        place = self.place
        return Readings(
            self.targets[indices],
            self.positive[indices],
            self.runs[indices],
            self.deviations[indices],
            lambda index: place(int(indices[index])),
            self.clock,
            None if self.times is None else self.times[indices],
        )


def readings_at(
    lines: Sequence[int] | IntArray,
    targets: Sequence[float] | FloatArray,
    positive: Sequence[bool] | BoolArray,
    runs: Sequence[int] | IntArray,
    deviations: Sequence[float] | FloatArray,
) -> Readings:
    """Return readings from arrays (n,), mm or deg, each on its own line."""
    at = np.array(lines, dtype=np.int64)
    return Readings(
        np.array(targets, dtype=np.float64) + 0.0,  # no negative zero
        np.array(positive, dtype=np.bool_),
        np.array(runs, dtype=np.int64),
        np.array(deviations, dtype=np.float64),
        lambda index: f"line {at[index]}",
    )
