"""Search for tests of a job that come from the same measurement: equal files or equal readings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.duplicate_candidates import equal_tests, tests_with_equal_run
from compwright.evaluation.pooled_scatter import pooled_scatter
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source, share_a_file
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import SAME_READING, PositioningTest

#: Runs are compared at as many common targets at least.
_TARGETS: Final = 5
#: Two runs are the same by chance where this many such pairs are expected.
_CHANCE: Final = 1e-3
#: Differences of runs that are held at once.
_AT_ONCE: Final = 1_000_000
#: Tests named in a message.
_NAMED: Final = 4


_Blocks = Mapping[Direction, FloatArray]


@dataclass(frozen=True, slots=True)
class NamedTest:
    """A test with its name for the user and the files that contain it."""

    words: str
    sources: tuple[Source, ...]
    test: PositioningTest | None = None


def same_measurement(one: NamedTest, other: NamedTest) -> bool:
    """Return whether two tests come from one measurement: they have a file with the same contents
    or a run in common, or all their readings agree except for a constant.
    """
    if share_a_file(one.sources, other.sources):
        return True
    if one.test is None or other.test is None:
        return False
    return same_readings(one.test, other.test) or share_a_run(one.test, other.test)


def same_readings(one: PositioningTest, other: PositioningTest) -> bool:
    """Return whether the readings of two tests agree except for a constant (instrument's zero).

    The result is False for readings without any scatter, because these may agree by chance.
    """
    if one.kind is not other.kind or pooled_scatter(one)[0] <= SAME_READING:
        return False
    pairs = (
        (one.targets, other.targets),
        (one.positive, other.positive),
        (one.negative, other.negative),
    )
    if any(a.shape != b.shape for a, b in pairs) or not np.allclose(
        one.targets, other.targets, rtol=0.0, atol=SAME_READING
    ):
        return False
    gaps = np.concatenate([(a - b).ravel() for a, b in pairs[1:]])
    made = np.concatenate([(np.isfinite(a) == np.isfinite(b)).ravel() for a, b in pairs[1:]])
    known = gaps[np.isfinite(gaps)]
    return bool(made.all() and known.size and np.ptp(known) <= SAME_READING)


def share_a_run(one: PositioningTest, other: PositioningTest) -> bool:
    """Return whether two tests have a run in common, except for a constant, in each direction that
    both contain.

    The run number does not matter: a test may contain only some of the runs, or all runs in another
    order. Coarse readings can agree by chance. In pairs of different runs, p is the share of
    targets with the same difference. For one pair, the probability that all m targets agree is p^(m
    - 1).
    """
    if one.kind is not other.kind:
        return False
    place = np.searchsorted(other.targets, one.targets - SAME_READING)
    place = np.minimum(place, other.targets.size - 1)
    at = np.flatnonzero(np.abs(other.targets[place] - one.targets) <= SAME_READING)
    there = place[at]
    if at.size < _TARGETS:
        return False
    ours = {direction: one.deviations(direction)[at] for direction in Direction}
    others = {direction: other.deviations(direction)[there] for direction in Direction}
    if _always_by_chance(ours, others):
        return False
    zeros = [found for way in Direction if (found := _zeros(ours[way], others[way])) is not None]
    if not (zeros and _in_common(zeros)):
        return False
    apart, chances = [], []
    for mine, theirs in product(Direction, repeat=2):
        for gap in _gaps(ours[mine], others[theirs]):
            if mine is theirs:
                chances.append(gap.size - 1)
            if mine is not theirs or np.ptp(gap) > SAME_READING:
                apart.append(gap)
    if not apart:
        return False
    shares = [_most_alike(gap) / gap.size for gap in apart]
    return float(np.sum(np.mean(shares) ** np.asarray(chances))) < _CHANCE


def _always_by_chance(ours: _Blocks, others: _Blocks) -> bool:
    """Return whether two tests have so few targets that their runs can agree by chance.

    Among m differences, one is the most frequent. The probability p that two readings agree is
    therefore at least 1/m. Only runs without a missing reading are counted.
    """
    targets = len(ours[Direction.POSITIVE])
    pairs = 0
    for direction in Direction:
        whole = [
            block[:, np.isfinite(block).all(axis=0)]
            for block in (ours[direction], others[direction])
        ]
        moving = np.count_nonzero(np.ptp(whole[0], axis=0) > SAME_READING)
        pairs += moving * whole[1].shape[1]
    return bool(pairs * (1.0 / targets) ** (targets - 1) >= _CHANCE)


def _zeros(mine: FloatArray, theirs: FloatArray) -> list[float] | None:
    """Return the constant difference of each pair of runs (columns) that otherwise agree.

    None if no two runs can be compared: they have too few common readings, or were not measured.
    """
    found: list[float] = []
    compared = False
    at_once = max(1, _AT_ONCE // max(theirs.size, 1))
    for start in range(0, mine.shape[1], at_once):
        left = mine[:, start : start + at_once, np.newaxis]
        gaps = left - theirs[:, np.newaxis, :]
        made = np.isfinite(gaps)
        counted = (made.sum(axis=0) >= _TARGETS) & (_spread(left, made) > SAME_READING)
        compared = compared or bool(counted.any())
        same = counted & (_spread(gaps, made) <= SAME_READING)
        first = np.take_along_axis(gaps, made.argmax(axis=0)[np.newaxis], axis=0)[0]
        found += first[same].tolist()
    return found if compared else None


def _spread(values: FloatArray, where: NDArray[np.bool_]) -> FloatArray:
    """Return the largest minus the smallest of the values marked in ``where`` (c, ..). The result
    is negative where no value is marked.
    """
    largest = np.where(where, values, -np.inf).max(axis=0)
    smallest = np.where(where, values, np.inf).min(axis=0)
    spread: FloatArray = largest - smallest
    return spread


def _gaps(mine: FloatArray, theirs: FloatArray) -> Iterator[FloatArray]:
    """Yield the difference of each pair of runs (columns) of two blocks, at targets where both have
    a reading.

    Pairs with too few common readings are left out. Runs with the same value everywhere were not
    measured and are left out too.
    """
    for left in mine.T:
        for gap, both in zip(
            (left[:, np.newaxis] - theirs).T,
            (np.isfinite(left)[:, np.newaxis] & np.isfinite(theirs)).T,
            strict=True,
        ):
            if np.count_nonzero(both) >= _TARGETS and np.ptp(left[both]) > SAME_READING:
                yield gap[both]


def _in_common(zeros: Sequence[Sequence[float]]) -> bool:
    """Return whether two tests differ by one constant that is the same in every direction.
    ``zeros``: the possible constants in each direction.
    """
    first, *others = zeros
    return any(
        all(any(abs(zero - each) <= SAME_READING for each in other) for other in others)
        for zero in first
    )


def _most_alike(gaps: FloatArray) -> int:
    """Return how often the most frequent value occurs among the differences ``gaps``."""
    ordered = np.sort(gaps)
    beyond = np.searchsorted(ordered, ordered + SAME_READING, side="right")
    return int(np.max(beyond - np.arange(gaps.size)))


def repeat_findings(tests: Sequence[PositioningTest]) -> list[Finding | None]:
    """Return an entry for each test: the finding CW-T034 if it repeats the measurement of another
    test, else None.

    The result equals that of `same_measurement` on all pairs, but the time grows only in proportion
    to the number of tests.
    """
    kinds = _one_of_each(tests)
    sharing = _sharing_runs([tests[members[0]] for members in kinds])
    found: list[Finding | None] = [None] * len(tests)
    for kind, members in enumerate(kinds):
        same = sorted(index for near in (kind, *sharing[kind]) for index in kinds[near])
        for index in members:
            others = [other for other in same[: _NAMED + 2] if other != index]
            if others:
                found[index] = _repeated([_file(tests[other]) for other in others])
    return found


def _sharing_runs(tests: Sequence[PositioningTest]) -> list[set[int]]:
    """Return, for each test, the indices of the other tests that have a run in common with this
    test. Very large sets are incomplete.
    """
    sharing: list[set[int]] = [set() for _ in tests]
    looked_at: set[tuple[int, int]] = set()
    for group in tests_with_equal_run(tests, _TARGETS):
        for one, other in combinations(group, 2):
            if min(len(sharing[one]), len(sharing[other])) > _NAMED or (one, other) in looked_at:
                continue
            looked_at.add((one, other))
            if share_a_run(tests[one], tests[other]):
                sharing[one].add(other)
                sharing[other].add(one)
    return sharing


def _one_of_each(tests: Sequence[PositioningTest]) -> list[list[int]]:
    """Return the tests in groups with the same file or readings, as ascending indices. Most groups
    have one test.
    """
    above = list(range(len(tests)))

    def join(one: int, other: int) -> None:
        low, high = sorted((_top(above, one), _top(above, other)))
        above[high] = low

    by_file: dict[str, int] = {}
    for index, test in enumerate(tests):
        for source in test.sources:
            join(index, by_file.setdefault(source.sha256, index))
    for first, *others in equal_tests(tests):
        if pooled_scatter(tests[first])[0] > SAME_READING:
            for other in others:
                join(first, other)
    groups: dict[int, list[int]] = {}
    for index in range(len(tests)):
        groups.setdefault(_top(above, index), []).append(index)
    return list(groups.values())


def _top(above: list[int], index: int) -> int:
    """Return the lowest index in the group of ``index`` (union-find with path compression).
    ``above``: for each index, a lower index of the same group or the same index.
    """
    while above[index] != index:
        above[index] = above[above[index]]
        index = above[index]
    return index


def repeated_files(tests: Sequence[Sequence[Source]]) -> list[Finding | None]:
    """Return an entry for each test, which is given by its files: the finding CW-T034 if one of
    these files also belongs to another test, else None.
    """
    having: dict[str, list[int]] = {}
    for index, sources in enumerate(tests):
        for source in sources:
            having.setdefault(source.sha256, []).append(index)
    others = (
        dict.fromkeys(
            tests[other][0].file
            for source in sources
            for other in having[source.sha256][: _NAMED + 2]
            if other != index
        )
        for index, sources in enumerate(tests)
    )
    return [_repeated(list(names)) if names else None for names in others]


def _repeated(names: Sequence[str]) -> Finding:
    return Finding.of("CW-T034", "warning", tests=names[:_NAMED], others=len(names) > _NAMED)


def _file(test: PositioningTest) -> str:
    return test.sources[0].file if test.sources else test.name
