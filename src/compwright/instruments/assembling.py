"""Combine single readings into a positioning test, with the checks that need all readings."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from compwright.foundations.input_sizes import MOST_CELLS, MOST_READINGS, MOST_TARGETS
from compwright.instruments.fault_list import FaultList
from compwright.instruments.readings import Readings
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.environment import ReadingTimes

#: Share of the targets that may have been approached in one direction only.
_MOST_ONE_SIDED = 0.25


@dataclass(frozen=True, slots=True)
class ReadingGrid:
    """The readings of a positioning test, one array per direction with a row per target and a
    column per run.

    - ``targets`` (m,): ascending.
    - ``deviations`` (m, n): by direction; NaN where there is no reading.
    - ``runs`` (n,): by direction, the numbers of the runs.
    - ``times``: when the readings were taken; None if the file does not state it.
    - ``one_sided``: in words, targets that were left out because a bidirectional test approached
      them from one side only.
    """

    targets: FloatArray
    deviations: Mapping[Direction, FloatArray]
    runs: Mapping[Direction, tuple[int, ...]]
    times: ReadingTimes | None
    one_sided: tuple[str, ...] = ()


def as_text(position: float) -> str:
    """Return a position as text, without exponent for usual sizes and without trailing zeros."""
    return f"{position:.10g}"


def grid_of(readings: Readings, kind: AxisKind, faults: FaultList) -> ReadingGrid:
    """Return the readings, which can be in any order, as arrays with a row per target and a column
    per run.

    Raises InputError, with the faults found before, if there are no readings or too many, or if a
    reading is given twice. In a bidirectional test both directions must have the same targets (ISO
    230-2, clause 4: each target is approached from both sides). Up to one target in four that was
    approached in one direction only is left out; more are an error. Two targets are the same if
    their numbers are exactly equal: no target is rounded.
    """
    one_sided: dict[float, str] = {}
    if not faults:
        if not len(readings):
            faults.add(
                "contains no readings",
                expected="at least one reading below the header",
                hint="add the readings below the header row, or export the file again",
            )
        _check_size(readings, faults)
        faults.raise_if_any()
        _check_unique(readings, kind, faults)
        one_sided = _check_both_directions(readings, kind, faults)
    faults.raise_if_any()
    if one_sided:
        readings = readings.only(~np.isin(readings.targets, list(one_sided)))
    targets, rows = np.unique(readings.targets, return_inverse=True)
    deviations, runs, times = {}, {}, {}
    for direction in Direction:
        ours = readings.positive == (direction is Direction.POSITIVE)
        numbers, columns = np.unique(readings.runs[ours], return_inverse=True)
        block = np.full((targets.size, numbers.size), np.nan)
        block[rows[ours], columns] = readings.deviations[ours]
        deviations[direction], runs[direction] = block, tuple(numbers.tolist())
        if readings.times is not None:
            times[direction] = np.full_like(block, np.nan)
            times[direction][rows[ours], columns] = readings.times[ours]
    taken = (
        ReadingTimes(
            clock=readings.clock,
            positive=times[Direction.POSITIVE],
            negative=times[Direction.NEGATIVE],
        )
        if times
        else None
    )
    return ReadingGrid(targets, deviations, runs, taken, tuple(one_sided.values()))


def _check_unique(readings: Readings, kind: AxisKind, faults: FaultList) -> None:
    keys = (readings.runs, readings.positive, readings.targets)
    order = np.lexsort(keys)
    same = np.ones(max(order.size - 1, 0), dtype=np.bool_)
    for key in keys:
        same &= key[order][1:] == key[order][:-1]
    if not np.any(same):
        return
    seen: dict[tuple[float, bool, int], int] = {}
    for index in np.sort(order[np.append(same, False) | np.append(False, same)]).tolist():
        reading = readings.one(index)
        first = seen.setdefault(
            (reading.target, reading.direction is Direction.POSITIVE, reading.run), index
        )
        if first != index:
            faults.add(
                "a reading is given twice",
                place=reading.place,
                expected="one reading per target, direction and run",
                found=(
                    f"target {as_text(reading.target)} {kind.unit}, direction {reading.direction},"
                    f" run {reading.run} also in {readings.place(first)}"
                ),
                hint="remove one of the two, or give it another run number",
            )


def _first_of(readings: Readings, direction: Direction) -> dict[float, int]:
    """Return the first reading of each target in one direction, in ascending order of the
    targets.
    """
    ours = np.flatnonzero(readings.positive == (direction is Direction.POSITIVE))
    targets, first = np.unique(readings.targets[ours], return_index=True)
    return dict(zip(targets.tolist(), ours[first].tolist(), strict=True))


def _check_both_directions(
    readings: Readings, kind: AxisKind, faults: FaultList
) -> dict[float, str]:
    """Return, as text, the targets that have readings in only one direction, if these are few in a
    bidirectional test. If they are many, add a fault for each.

    A target close to a different target of the opposite direction is always a fault.
    """
    positive, negative = (_first_of(readings, direction) for direction in Direction)
    if not positive or not negative:
        return {}
    few = _MOST_ONE_SIDED * len(set(positive) | set(negative))
    only_positive = sorted(set(positive) - set(negative))
    only_negative = sorted(set(negative) - set(positive))
    found: dict[float, tuple[int, str]] = {}
    reported: set[float] = set()
    reach = min((b - a for a, b in pairwise(sorted(positive))), default=np.inf) / 2
    for target in only_positive:
        at = bisect_left(only_negative, target)
        near = min(
            only_negative[max(at - 1, 0) : at + 1], key=partial(_distance, target), default=np.inf
        )
        if _distance(target, near) < reach:
            reported.add(near)
            faults.add(
                "the targets of the two directions differ",
                place=readings.place(negative[near]),
                expected=(
                    f"{as_text(target)} {kind.unit} as in direction +"
                    f" ({readings.place(positive[target])})"
                ),
                found=f"{as_text(near)} {kind.unit} in direction -",
                hint="write the same target in both directions",
            )
        else:
            found[target] = (positive[target], "+")
    found |= {target: (negative[target], "-") for target in only_negative if target not in reported}
    if len(found) <= few:
        return {
            target: f"{as_text(target)} {kind.unit} in direction {direction} only"
            f" ({readings.place(index)})"
            for target, (index, direction) in sorted(found.items())
        }
    for target, (index, direction) in found.items():
        _note_one_sided(target, readings.place(index), direction, kind, faults)
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
        hint="export the file again with all its readings",
    )


def _check_size(readings: Readings, faults: FaultList) -> None:
    targets = len(set(readings.targets.tolist()))
    traverses = len(set((2 * readings.runs + readings.positive).tolist()))
    if targets * traverses > MOST_CELLS:
        faults.add(
            "the readings do not form a table of targets and runs",
            expected="runs that each contain most of the targets",
            found=f"{len(readings)} readings at {targets} targets in {traverses} runs",
            hint="give each run of the test the same run number in all its rows",
        )
    for count, most, what in (
        (len(readings), MOST_READINGS, "readings"),
        (targets, MOST_TARGETS, "targets"),
    ):
        if count > most:
            faults.add(
                f"contains too many {what}",
                expected=f"at most {most} in one test",
                found=str(count),
                hint="give one test per file",
            )
