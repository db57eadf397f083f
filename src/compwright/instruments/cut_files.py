"""Whether a file may have been cut off: its last rows belong to a traverse or a target that lacks
readings while all others are whole, or it holds less than it says itself.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Final, TypeVar

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import Reading, as_text
from compwright.instruments.numbers import parse_count
from compwright.instruments.reading_findings import cut_finding
from compwright.records.axis import AxisKind

_Key = TypeVar("_Key")

#: Keys of a header that say how much a file holds (small letters, one blank between words).
_TARGETS: Final = frozenset({"targets", "n targets", "number of targets", "positions"})
_RUNS: Final = frozenset({"runs", "n runs", "number of runs", "cycles", "number of cycles"})


def cut_findings(
    readings: Sequence[Reading], kind: AxisKind, header: Mapping[str, str]
) -> list[Finding]:
    """Return the findings; ``readings`` in the order of the file."""
    why = (_unfinished(readings, kind), *_promises(readings, header))
    return [cut_finding(words) for words in why if words]


def _unfinished(readings: Sequence[Reading], kind: AxisKind) -> str:
    """Return why the last rows may be the rest of a traverse or target that was cut, in words."""
    if not readings:
        return ""
    last = readings[-1]
    traverses = Counter((reading.direction, reading.run) for reading in readings)
    targets = Counter(reading.target for reading in readings)
    return _short(
        traverses, (last.direction, last.run), f"run {last.direction}{last.run}"
    ) or _short(targets, last.target, f"target {as_text(last.target)} {kind.unit}")


def _short(counts: Counter[_Key], mine: _Key, words: str) -> str:
    """Return in words that ``mine`` alone has fewer readings than the others, empty where it has
    not.
    """
    whole = max(counts.values())
    if len(counts) < 3 or [key for key, count in counts.items() if count < whole] != [mine]:
        return ""
    return (
        f"The last rows are of {words}, which lacks {whole - counts[mine]} of {whole} readings"
        " while the others have all: the file may have been cut off."
    )


def _promises(readings: Sequence[Reading], header: Mapping[str, str]) -> list[str]:
    found = {
        "targets": (_TARGETS, len({reading.target for reading in readings})),
        "runs": (_RUNS, len({reading.run for reading in readings})),
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
