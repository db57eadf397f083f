"""Check whether a file was cut off.

A file was cut off if its last traverse or target is incomplete while all others are complete, or if
it contains fewer targets or runs than its own header states.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.numbers import parse_count
from compwright.instruments.reading_findings import cut_finding
from compwright.instruments.readings import IntArray, Readings
from compwright.records.axis import AxisKind
from compwright.words.sentences import Amount, Sentence, say

#: Keys of a header that say how much a file holds (small letters, one blank between words).
_TARGETS: Final = frozenset({"targets", "n targets", "number of targets", "positions"})
_RUNS: Final = frozenset({"runs", "n runs", "number of runs", "cycles", "number of cycles"})


def cut_findings(readings: Readings, kind: AxisKind, header: Mapping[str, str]) -> list[Finding]:
    """Return the findings that a file was probably cut off. ``readings`` are in the order of the
    file.
    """
    why = (_unfinished(readings, kind), *_promises(readings, header))
    return [cut_finding(sentence) for sentence in why if sentence is not None]


def _unfinished(readings: Readings, kind: AxisKind) -> Sentence | None:
    """Return the sentence that states which readings the last traverse or the last target seems to
    lack, or None if both are complete.
    """
    if not len(readings):
        return None
    last = readings.one(-1)
    _, traverse = np.unique(2 * readings.runs + readings.positive, return_inverse=True)
    _, target = np.unique(readings.targets, return_inverse=True)
    if lacking := _lacking(traverse, target):
        number, of = lacking
        run = f"{last.direction}{last.run}"
        return say("CW-R053.last_run", run=run, lacking=number, readings=of)
    if lacking := _lacking(target, traverse):
        number, of = lacking
        place = Amount(last.target, kind.unit, ".10g")
        return say("CW-R053.last_target", target=place, lacking=number, readings=of)
    _, runs = np.unique(readings.runs, return_inverse=True)
    in_turn = np.count_nonzero(np.diff(traverse)) > traverse.max()  # + and - at each target
    if in_turn and (lacking := _lacking(runs, 2 * target + readings.positive)):
        number, of = lacking
        return say("CW-R053.last_run", run=f"{last.run}", lacking=number, readings=of)
    return None


def _lacking(groups: IntArray, others: IntArray) -> tuple[int, int] | None:
    """Return how many readings the last group (a traverse or a target) lacks, and how many a
    complete group has; None unless the last group is the only incomplete one.

    ``groups`` (n,): the number of the group of each reading, from 0. ``others`` (n,): the place of
    each reading within its group, from 0. If the groups are traverses, the places are targets, and
    the reverse. Every group must go through its places in one order, or back and forth. A reading
    that is missing at any other place was left out, not cut off.
    """
    counts = np.bincount(groups)
    mine = groups[-1]
    whole, there = int(counts.max()), int(counts[mine])
    if counts.size < 3 or np.flatnonzero(counts < whole).tolist() != [mine]:
        return None
    order = others[groups == np.argmax(counts)]
    begun = others[-there:]
    is_end = np.all(groups[-there:] == mine) and any(
        np.array_equal(begun, way[:there]) for way in (order, order[::-1])
    )
    return (whole - there, whole) if is_end else None


def _promises(readings: Readings, header: Mapping[str, str]) -> list[Sentence]:
    found = {
        "targets": (_TARGETS, len(set(readings.targets.tolist()))),
        "runs": (_RUNS, len(set(readings.runs.tolist()))),
    }
    reasons = []
    for what, (keys, count) in found.items():
        for key, value in header.items():
            if " ".join(key.lower().replace("_", " ").split()) in keys:
                promised = _count(value)
                if promised > count:
                    reasons.append(
                        say("CW-R053.header", what=what, promised=promised, key=key, found=count)
                    )
    return reasons


def _count(text: str) -> int:
    try:
        return parse_count(text)
    except ValueError:
        return 0
