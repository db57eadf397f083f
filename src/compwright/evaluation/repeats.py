"""Is it the same measurement twice? Tests beside each other: files and readings that are the
same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Final

import numpy as np

from compwright.evaluation.scatter import pooled_scatter
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source, share_a_file
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.records.result import PositioningResult

#: Runs are compared at as many common targets at least.
_TARGETS: Final = 5
#: Two runs are the same by chance where this many such pairs are expected.
_CHANCE: Final = 1e-3


@dataclass(frozen=True, slots=True)
class Named:
    """A test by what the user calls it, with the files that it came from."""

    words: str
    sources: tuple[Source, ...]
    test: PositioningTest | None = None


def same_measurement(one: Named, other: Named) -> bool:
    """Return whether two tests share a file by its content, hold the same scattering readings at
    the same targets, or share a run.
    """
    if share_a_file(one.sources, other.sources):
        return True
    if one.test is None or other.test is None:
        return False
    return same_readings(one.test, other.test) or share_a_run(one.test, other.test)


def same_readings(one: PositioningTest, other: PositioningTest) -> bool:
    """Return whether two tests agree reading by reading, but for one constant: another zero of the
    instrument.

    Readings without any scatter may do so by chance and do not count.
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
    """Return whether a run of one test is a run of the other, whatever its number, in every
    direction that both have, but for one constant: some of the runs, or all in another order, given
    as a test of their own.

    Of the pairs of runs that differ, the share p of targets with one and the same difference tells
    how often coarse digits agree; runs that agree at all of m targets do so with the chance
    p^(m - 1) for each pair.
    """
    if one.kind is not other.kind:
        return False
    place = np.searchsorted(other.targets, one.targets - SAME_READING)
    place = np.minimum(place, other.targets.size - 1)
    at = np.flatnonzero(np.abs(other.targets[place] - one.targets) <= SAME_READING)
    there = place[at]
    zeros: dict[Direction, list[float]] = {}
    shares, chances = [], []
    for mine, theirs in product(Direction, repeat=2):
        for left, right in product(one.deviations(mine)[at].T, other.deviations(theirs)[there].T):
            both = np.isfinite(left - right)
            gap = (left - right)[both]
            if gap.size < _TARGETS or np.ptp(left[both]) <= SAME_READING:
                continue  # too few, or a run of zeros that was not made
            if mine is theirs:
                zeros.setdefault(mine, [])
                chances.append(gap.size - 1)
            if mine is theirs and np.ptp(gap) <= SAME_READING:
                zeros[mine].append(float(gap[0]))
            else:
                shares.append(_most_alike(gap) / gap.size)
    if not (zeros and shares and _in_common(list(zeros.values()))):
        return False
    return float(np.sum(np.mean(shares) ** np.asarray(chances))) < _CHANCE


def _in_common(zeros: Sequence[Sequence[float]]) -> bool:
    """Return whether one constant is among those of every direction."""
    first, *others = zeros
    return any(
        all(any(abs(zero - each) <= SAME_READING for each in other) for other in others)
        for zero in first
    )


def _most_alike(gaps: FloatArray) -> int:
    """Return how many of the differences are one and the same."""
    ordered = np.sort(gaps)
    beyond = np.searchsorted(ordered, ordered + SAME_READING, side="right")
    return int(np.max(beyond - np.arange(gaps.size)))


def with_repeats(results: Sequence[PositioningResult]) -> list[PositioningResult]:
    """Return the results, each that repeats the measurement of another one with a finding that says
    so (CW-T034).
    """
    named = [Named(_file(result), result.test.sources, result.test) for result in results]
    found = []
    for result, mine in zip(results, named, strict=True):
        others = [
            other.words for other in named if other is not mine and same_measurement(mine, other)
        ]
        message = f"The same measurement as {', '.join(others)}: given twice it proves nothing new."
        repeated = (Finding("CW-T034", "warning", message),) if others else ()
        found.append(replace(result, findings=(*result.findings, *repeated)))
    return found


def _file(result: PositioningResult) -> str:
    return result.test.sources[0].file if result.test.sources else result.test.name
