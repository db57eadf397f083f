"""Single readings to a positioning test: the checks that need all readings at once, and the
arrays.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from compwright.instruments.fault_list import FaultList
from compwright.records.axis import AxisKind, Direction, FloatArray

#: Cells of the two reading tables together beyond which a file is refused: a test has some hundred
#: readings.
_MOST_CELLS = 4_000_000
#: Share of the targets that may have been approached in one direction only.
_MOST_ONE_SIDED = 0.25


@dataclass(frozen=True, slots=True)
class Reading:
    """One approach: ``target`` and ``deviation`` (measured minus target) in mm or deg, and where in
    the file it stands.
    """

    target: float
    direction: Direction
    run: int
    deviation: float
    place: str


@dataclass(frozen=True, slots=True)
class Grid:
    """The readings as arrays: ``targets`` (m,) ascending; per direction ``deviations`` (m, n), NaN
    for none, and ``runs`` (n,).

    ``one_sided``: targets that were left out, because a test in two directions approached them in
    one only, in words.
    """

    targets: FloatArray
    deviations: Mapping[Direction, FloatArray]
    runs: Mapping[Direction, tuple[int, ...]]
    one_sided: tuple[str, ...] = ()


def as_text(position: float) -> str:
    """Return a position as people write it: no exponent for usual sizes, no trailing zeros."""
    return f"{position:.10g}"


def grid_of(readings: Sequence[Reading], kind: AxisKind, faults: FaultList) -> Grid:
    """Return the readings as arrays, in any order given.

    Raises InputError (with the faults noted before) when there are no readings, a reading is given
    twice, or a test in two directions does not have the same targets in both (ISO 230-2, clause 4:
    each target is approached from both sides); up to one target in four that was approached in one
    direction only is left out. Targets are the same when their numbers are exactly equal: nothing
    is rounded to make them so.
    """
    one_sided: dict[float, str] = {}
    if not faults:
        if not readings:
            faults.add("holds no readings", expected="at least one reading below the header")
        _check_unique(readings, kind, faults)
        one_sided = _check_both_directions(readings, kind, faults)
        _check_size(readings, faults)
    faults.raise_if_any()
    readings = [reading for reading in readings if reading.target not in one_sided]
    targets = sorted({reading.target for reading in readings})
    row = {target: index for index, target in enumerate(targets)}
    deviations, runs = {}, {}
    for direction in Direction:
        ours = [reading for reading in readings if reading.direction is direction]
        numbers = sorted({reading.run for reading in ours})
        column = {run: index for index, run in enumerate(numbers)}
        block = np.full((len(targets), len(numbers)), np.nan)
        for reading in ours:
            block[row[reading.target], column[reading.run]] = reading.deviation
        deviations[direction], runs[direction] = block, tuple(numbers)
    return Grid(np.array(targets, dtype=np.float64), deviations, runs, tuple(one_sided.values()))


def _check_unique(readings: Sequence[Reading], kind: AxisKind, faults: FaultList) -> None:
    seen: dict[tuple[float, Direction, int], str] = {}
    for reading in readings:
        key = (reading.target, reading.direction, reading.run)
        first = seen.setdefault(key, reading.place)
        if first != reading.place:
            faults.add(
                "a reading is given twice",
                place=reading.place,
                expected="one reading per target, direction and run",
                found=(
                    f"target {as_text(reading.target)} {kind.unit}, direction {reading.direction},"
                    f" run {reading.run} also in {first}"
                ),
            )


def _check_both_directions(
    readings: Sequence[Reading], kind: AxisKind, faults: FaultList
) -> dict[float, str]:
    """Return the targets that only one direction of a test in two directions has, in words, where
    they are few.

    Else each is a fault; so is one near which another stands in the opposite direction.
    """
    places: dict[Direction, dict[float, str]] = {direction: {} for direction in Direction}
    for reading in readings:
        places[reading.direction].setdefault(reading.target, reading.place)
    positive, negative = places[Direction.POSITIVE], places[Direction.NEGATIVE]
    if not positive or not negative:
        return {}
    few = _MOST_ONE_SIDED * len(set(positive) | set(negative))
    only_positive = sorted(set(positive) - set(negative))
    only_negative = sorted(set(negative) - set(positive))
    found: dict[float, tuple[str, str]] = {}
    reach = min((b - a for a, b in pairwise(sorted(positive))), default=np.inf) / 2
    for target in only_positive:
        at = bisect_left(only_negative, target)
        near = min(
            only_negative[max(at - 1, 0) : at + 1], key=partial(_distance, target), default=np.inf
        )
        if _distance(target, near) < reach:
            only_negative.remove(near)
            faults.add(
                "the targets of the two directions differ",
                place=negative[near],
                expected=f"{as_text(target)} {kind.unit} as in direction + ({positive[target]})",
                found=f"{as_text(near)} {kind.unit} in direction -",
            )
        else:
            found[target] = (positive[target], "+")
    found |= {target: (negative[target], "-") for target in only_negative}
    if len(found) <= few:
        return {
            target: f"{as_text(target)} {kind.unit} in direction {direction} only ({place})"
            for target, (place, direction) in sorted(found.items())
        }
    for target, (place, direction) in found.items():
        _note_one_sided(target, place, direction, kind, faults)
    return {}


def _distance(one: float, other: float) -> float:
    return abs(one - other)


def _note_one_sided(
    target: float, place: str, direction: str, kind: AxisKind, faults: FaultList
) -> None:
    faults.add(
        "a target of a test in two directions was approached in one direction only",
        place=place,
        expected="readings in both directions at each target",
        found=f"target {as_text(target)} {kind.unit} in direction {direction} only",
    )


def _check_size(readings: Sequence[Reading], faults: FaultList) -> None:
    targets = len({reading.target for reading in readings})
    traverses = len({(reading.direction, reading.run) for reading in readings})
    if targets * traverses > _MOST_CELLS:
        faults.add(
            "the readings do not form a table of targets and runs",
            expected="each run at most of the targets",
            found=f"{len(readings)} readings at {targets} targets in {traverses} runs",
        )
