"""Search for tests that are possibly copies of one measurement.

The candidates are found by sorting, so that not every pair is compared. `duplicate_measurements`
then decides. Two tests may agree except for a constant (the zero of the instrument). To find them,
one reading of each test is subtracted from its readings, and equal numbers are searched.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.positioning import SAME_READING, PositioningTest

#: Of the targets that two runs have in common so many are looked at, the lowest ones: enough that
#: runs hardly agree there by chance, however coarse their digits.
_LOOKED_AT: Final = 12

_Numbers = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class _CandidateRun:
    """One run of the test with index ``owner``: its readings (n,), mm or deg, and the numbers of
    their targets.
    """

    owner: int
    places: _Numbers
    values: FloatArray


def equal_tests(tests: Sequence[PositioningTest]) -> list[list[int]]:
    """Return groups of ``tests`` (two or more indices, ascending) with the same targets, whose
    readings differ by one constant, within `SAME_READING`.
    """
    blocks = [np.concatenate([test.positive.ravel(), test.negative.ravel()]) for test in tests]
    made = [np.isfinite(block) for block in blocks]
    shifted = [block[known] - block[known][:1] for block, known in zip(blocks, made, strict=True)]
    groups: dict[Hashable, list[int]] = defaultdict(list)
    for index, (test, known, places, values) in enumerate(
        zip(tests, made, _places(tests), _numbered(shifted), strict=True)
    ):
        shape = test.kind, test.positive.shape, test.negative.shape
        groups[*shape, known.tobytes(), places.tobytes(), values.tobytes()].append(index)
    return [group for group in groups.values() if len(group) > 1]


def tests_with_equal_run(tests: Sequence[PositioningTest], fewest: int) -> Iterator[list[int]]:
    """Yield groups of ``tests`` (two or more indices, ascending) that possibly contain the same
    run, compared at ``fewest`` common targets or more.

    Each test of a group has a run in one direction that agrees with a run of the others, except for
    a constant. Only the `_LOOKED_AT` lowest common targets are compared. Tests whose runs agree at
    all common targets are always in such a group. A run with the same value everywhere was not
    measured and is left out.
    """
    runs: dict[tuple[AxisKind, Direction], list[_CandidateRun]] = defaultdict(list)
    for index, (test, places) in enumerate(zip(tests, _places(tests), strict=True)):
        for direction in Direction:
            for column in test.deviations(direction).T:
                made = np.isfinite(column)
                values = column[made]
                if values.size >= fewest and np.ptp(values) > SAME_READING:
                    runs[test.kind, direction].append(_CandidateRun(index, places[made], values))
    for some in runs.values():
        for group in _agreeing(some, fewest):
            yield sorted(group)


def _agreeing(runs: Sequence[_CandidateRun], fewest: int) -> Iterator[set[int]]:
    """Yield groups of tests. Each test of a group has a run that agrees with a run of each other
    test of the group at the compared targets, which are ``fewest`` or more.
    """
    grids: dict[bytes, list[_CandidateRun]] = defaultdict(list)
    for run in runs:
        grids[run.places.tobytes()].append(run)
    looked: dict[bytes, list[_CandidateRun]] = defaultdict(list)
    several = list(grids.values())
    for grid, parts in enumerate(_looked_at([some[0].places for some in several], fewest)):
        for part in parts:
            looked[part] += several[grid]
    for part, some in looked.items():
        if len({run.owner for run in some}) < 2:
            continue  # a test with targets of its own
        yield from _same_there(some, np.frombuffer(part, dtype=np.int64))


def _looked_at(grids: Sequence[_Numbers], fewest: int) -> list[set[bytes]]:
    """Return, for each list of targets, the sets of targets at which runs with this list are
    compared: the complete list, and the targets in common with any other list (if at least
    ``fewest``).
    """
    having: dict[int, list[int]] = defaultdict(list)
    for index, places in enumerate(grids):
        for place in places.tolist():
            having[place].append(index)
    lists = {place: np.array(indices) for place, indices in having.items()}
    found: list[set[bytes]] = [set() for _ in grids]
    for index, places in enumerate(grids):
        common = np.bincount(np.concatenate([lists[place] for place in places.tolist()]))
        for other in (np.flatnonzero(common[index:] >= fewest) + index).tolist():
            part = _common(places, grids[other])[:_LOOKED_AT].tobytes()
            found[index].add(part)
            found[other].add(part)
    return found


def _common(one: _Numbers, other: _Numbers) -> _Numbers:
    return one if one is other else np.intersect1d(one, other, assume_unique=True)


def _same_there(runs: Sequence[_CandidateRun], part: _Numbers) -> Iterator[set[int]]:
    """Yield groups of tests whose runs differ only by a constant at the targets numbered in
    ``part``.
    """
    values = np.stack([run.values[np.searchsorted(run.places, part)] for run in runs])
    columns = (values[:, 1:] - values[:, :1]).T
    rows = np.column_stack([_numbers(column) for column in columns])
    groups: dict[bytes, set[int]] = defaultdict(set)
    for run, row in zip(runs, rows, strict=True):
        groups[row.tobytes()].add(run.owner)
    return (group for group in groups.values() if len(group) > 1)


def _places(tests: Sequence[PositioningTest]) -> list[_Numbers]:
    """Return target numbers for each test; the same target has the same number in all tests."""
    return _numbered([test.targets for test in tests])


def _numbered(several: Sequence[FloatArray]) -> list[_Numbers]:
    """Return a number for each value of several arrays; equal values have the same number."""
    if not several:
        return []
    ends = np.cumsum([values.size for values in several])[:-1]
    return np.split(_numbers(np.concatenate(several)), ends)


def _numbers(values: FloatArray) -> _Numbers:
    """Return a number for each value, in ascending order. Values that differ by at most
    `SAME_READING` share a number.
    """
    order = np.argsort(values, kind="stable")
    ordered = values[order]
    numbers = np.empty(values.size, dtype=np.int64)
    numbers[order] = np.cumsum(np.diff(ordered, prepend=ordered[:1]) > SAME_READING)
    return numbers
