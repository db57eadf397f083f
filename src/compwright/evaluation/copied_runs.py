"""Search for runs that are copies of each other: identical readings, or readings with noise added
(CW-T031).

Repeated runs of a machine differ at every target by their noise. If two runs agree ten times better
than other runs of the test, they are copies of one run. If the resolution of the instrument is
coarser than the noise, runs may be equal by chance.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from itertools import combinations
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.reading_checks import sign_text, text_of
from compwright.foundations.findings import Finding
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest
from compwright.words.sentences import Sentence, say

#: Scatter below this is rounding of binary numbers, not a measurement: 1 pm, 1e-9 deg.
_ROUNDING: Final = 1e-9
_DIRECTIONS: Final = (Direction.POSITIVE, Direction.NEGATIVE)
#: Two runs that differ by less than this of what the runs of a test differ by are one run. With
#: eight targets (six degrees of freedom) honest runs do so once in 200 000 pairs.
_COPY: Final = 0.1
_TARGETS: Final = 8
#: Quantile of the differences of the pairs that is used as the noise: above most copies, below an
#: outlying run.
_QUANTILE: Final = 0.75
#: Differences within this many steps of the instrument's last digit are made by the rounding.
_STEPS: Final = 1.5
#: Two runs are the same by chance where this many such pairs are expected in a test.
_CHANCE: Final = 1e-3
#: Copies named in a message; the others are counted.
_NAMED: Final = 4
_MOST_LISTED: Final = 20  # runs of one group, and groups, that are listed
#: Most runs that are compared pair by pair; among more of them some are alike by chance, and the
#: work grows with their square.
_MOST_RUNS: Final = 100
#: Differences of readings that are held in memory at once.
_AT_ONCE: Final = 1_000_000


def copied_runs(test: PositioningTest) -> dict[Direction, list[list[int]]]:
    """Return, for each direction, the groups of two or more runs (column numbers) with the same
    readings.

    Runs are compared only if they have three or more readings in common. In a test with more than
    `_MOST_RUNS` runs, only runs with readings at the same targets are compared.
    """
    found: dict[Direction, list[list[int]]] = {}
    for direction in _DIRECTIONS:
        block = test.deviations(direction)
        groups = _groups(block) if block.shape[1] <= _MOST_RUNS else _groups_of_many(block)
        found[direction] = [group for group in groups if len(group) > 1]
    return found


def _groups(block: FloatArray) -> list[list[int]]:
    groups: list[list[int]] = []
    for column in range(block.shape[1]):
        group = next(
            (group for group in groups if _same(block[:, group[0]], block[:, column])), None
        )
        if group is None:
            groups.append([column])
        else:
            group.append(column)
    return groups


def _groups_of_many(block: FloatArray) -> list[list[int]]:
    groups: defaultdict[bytes, list[int]] = defaultdict(list)
    for column, values in enumerate(np.round(block / _ROUNDING).T + 0.0):  # no negative zero
        if np.count_nonzero(np.isfinite(values)) >= 3 and np.any(np.nan_to_num(values)):
            groups[values.tobytes()].append(column)
    return list(groups.values())


def copied_run_findings(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T031 if runs of one direction, or of both, agree to the last digit or
    almost.
    """
    exact = _exact(test)
    if exact and not _by_chance(test):
        rest = len(exact) - _MOST_LISTED
        return [Finding.of("CW-T031.same", "warning", runs=exact[:_MOST_LISTED], more=max(0, rest))]
    near, noise = _near(test)
    if not near:
        return []
    more = max(0, len(near) - _NAMED)
    return [
        Finding.of(
            "CW-T031.near", "warning", runs=near[:_NAMED], more=more, noise=text_of(noise, test)
        )
    ]


def _exact(test: PositioningTest) -> list[Sentence]:
    parts = []
    for direction, groups in copied_runs(test).items():
        for group in groups:
            names = [_number(test, direction, column) for column in group]
            more = max(0, len(names) - _MOST_LISTED)
            parts.append(
                say(
                    "CW-T031.runs",
                    runs=names[: min(len(names) - 1, _MOST_LISTED)],
                    last=names[-1],
                    more=more,
                    direction=sign_text(direction),
                )
            )
    if (
        test.positive.shape == test.negative.shape
        and all(map(_same, test.positive.T, test.negative.T))
        and test.positive.size
    ):
        parts.append(say("CW-T031.directions"))
    return parts


def _by_chance(test: PositioningTest) -> bool:
    """Return whether equal runs can be a coincidence, because the readings have a coarse
    resolution.

    In pairs of different runs, the share p of targets with equal readings is the probability that
    two readings are equal. For one pair of runs, the probability of equal readings at all m targets
    is p^m.
    """
    agree, count, pairs = 0.0, 0, 0
    for direction in _DIRECTIONS:
        runs = test.deviations(direction).T
        pairs += len(runs) * (len(runs) - 1) // 2
        for one, other in combinations(runs[:_MOST_RUNS], 2):
            both = np.isfinite(one) & np.isfinite(other)
            if np.any(both) and not _same(one, other):
                agree += float(np.mean(np.abs(one[both] - other[both]) <= _ROUNDING))
                count += 1
    return count > 0 and pairs * (agree / count) ** test.targets.size > _CHANCE


def _near(test: PositioningTest) -> tuple[list[Sentence], float]:
    """Return the pairs of almost equal runs as text, and the typical rms difference between runs of
    a direction (mm or deg).
    """
    if test.positive.shape[1] + test.negative.shape[1] > _MOST_RUNS:
        return [], 0.0
    traverses = [
        (direction, column, values)
        for direction in _DIRECTIONS
        for column, values in enumerate(test.deviations(direction).T)
        if np.any(np.nan_to_num(values))  # zeros have a finding of their own
    ]
    apart = {
        (traverses[one][:2], traverses[other][:2]): gap
        for one, other, gap in _all_apart([values for _, _, values in traverses])
    }
    within = [gap for (one, other), gap in apart.items() if one[0] is other[0]]
    # np.quantile loads numpy.ma
    place = _QUANTILE * (len(within) - 1)
    noise = float(np.interp(place, np.arange(len(within)), sorted(within))) if within else 0.0
    if noise <= _STEPS * test.step:
        return [], noise
    near = [
        say(
            "CW-T031.pair",
            one=_name(test, *one),
            other=_name(test, *other),
            difference=text_of(gap, test),
        )
        for (one, other), gap in apart.items()
        if gap < _COPY * noise
    ]
    return near, noise


def _all_apart(runs: Sequence[FloatArray]) -> list[tuple[int, int, float]]:
    """Return the rms difference of each pair of ``runs`` (m,) after a constant and a linear drift
    are removed, except for pairs with too few common targets.
    """
    if len(runs) < 2:
        return []
    columns = np.column_stack(runs)
    first, second = np.triu_indices(len(runs), 1)
    pieces = -(-first.size * len(columns) // _AT_ONCE)
    return [
        apart
        for one, other in zip(
            np.array_split(first, pieces), np.array_split(second, pieces), strict=True
        )
        for apart in _apart(columns, one, other)
    ]


def _apart(
    columns: FloatArray, first: NDArray[np.intp], second: NDArray[np.intp]
) -> list[tuple[int, int, float]]:
    """Return the rms differences, as in `_all_apart`, for the pairs (p,) of runs with the column
    numbers ``first`` and ``second``.
    """
    gaps = columns[:, first] - columns[:, second]
    patterns, which = np.unique(np.isfinite(gaps), axis=1, return_inverse=True)
    found = []
    for index, known in enumerate(patterns.T):
        alike = np.flatnonzero(which.ravel() == index)
        if np.count_nonzero(known) >= _TARGETS:
            sizes = _without_drift(gaps[np.ix_(known, alike)], np.flatnonzero(known))
            found += list(zip(alike, sizes, strict=True))
    return [(int(first[pair]), int(second[pair]), float(size)) for pair, size in sorted(found)]


def _without_drift(gaps: FloatArray, places: NDArray[np.intp]) -> FloatArray:
    """Return the rms (p,) of differences (c, p) after their mean and slope over ``places`` (c,) are
    removed.
    """
    along = places - np.mean(places)
    left = gaps - np.mean(gaps, axis=0)
    left -= np.multiply.outer(along, along @ left) / (along @ along)
    rms: FloatArray = np.sqrt(np.sum(left**2, axis=0) / (places.size - 2))
    return rms


def _same(one: FloatArray, other: FloatArray) -> bool:
    both = np.isfinite(one) & np.isfinite(other)
    return bool(
        np.count_nonzero(both) >= 3
        and np.any(one[both])
        and np.max(np.abs(one[both] - other[both])) <= _ROUNDING
    )


def _number(test: PositioningTest, direction: Direction, column: int) -> str:
    runs = test.runs_positive if direction is Direction.POSITIVE else test.runs_negative
    return str(runs[column]) if column < len(runs) else str(column + 1)


def _name(test: PositioningTest, direction: Direction, column: int) -> str:
    return f"run {_number(test, direction, column)} in {sign_text(direction)}"
