"""Whether a file may have been cut off: its last rows belong to a traverse or a target that lacks
readings while all others are whole, or it holds less than it says itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import as_text
from compwright.instruments.numbers import parse_count
from compwright.instruments.reading_findings import cut_finding
from compwright.instruments.readings import IntArray, Readings
from compwright.records.axis import AxisKind

#: Keys of a header that say how much a file holds (small letters, one blank between words).
_TARGETS: Final = frozenset({"targets", "n targets", "number of targets", "positions"})
_RUNS: Final = frozenset({"runs", "n runs", "number of runs", "cycles", "number of cycles"})


def cut_findings(readings: Readings, kind: AxisKind, header: Mapping[str, str]) -> list[Finding]:
    """Return the findings; ``readings`` in the order of the file."""
    why = (_unfinished(readings, kind), *_promises(readings, header))
    return [cut_finding(words) for words in why if words]


def _unfinished(readings: Readings, kind: AxisKind) -> str:
    """Return why the last rows may be the rest of a traverse or target that was cut, in words."""
    if not len(readings):
        return ""
    last = readings.one(-1)
    _, traverse = np.unique(2 * readings.runs + readings.positive, return_inverse=True)
    _, target = np.unique(readings.targets, return_inverse=True)
    return _short(traverse, f"run {last.direction}{last.run}") or _short(
        target, f"target {as_text(last.target)} {kind.unit}"
    )


def _short(groups: IntArray, words: str) -> str:
    """Return in words that the group of the last reading alone has fewer readings than the others,
    empty where it has not; ``groups`` (n,): the group of each, from 0.
    """
    counts = np.bincount(groups)
    mine = groups[-1]
    whole = int(counts.max())
    if counts.size < 3 or np.flatnonzero(counts < whole).tolist() != [mine]:
        return ""
    return (
        f"The last rows are of {words}, which lacks {whole - counts[mine]} of {whole} readings"
        " while the others have all: the file may have been cut off."
    )


def _promises(readings: Readings, header: Mapping[str, str]) -> list[str]:
    found = {
        "targets": (_TARGETS, len(set(readings.targets.tolist()))),
        "runs": (_RUNS, len(set(readings.runs.tolist()))),
    }
    told = []
    for what, (keys, count) in found.items():
        for key, value in header.items():
            if " ".join(key.lower().replace("_", " ").split()) in keys:
                promised = _count(value)
                if promised > count:
                    told.append(
                        f"The file says that it has {promised} {what} (key {key}) and holds"
                        f" {count}: it may have been cut off."
                    )
    return told


def _count(text: str) -> int:
    try:
        return parse_count(text)
    except ValueError:
        return 0
