"""Is it the same measurement twice? Tests beside each other: files and readings that are the
same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.evaluation.plausibility import pooled_scatter
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source, share_a_file
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.records.result import PositioningResult


@dataclass(frozen=True, slots=True)
class Named:
    """A test by what the user calls it, with the files that it came from."""

    words: str
    sources: tuple[Source, ...]
    test: PositioningTest | None = None


def same_measurement(one: Named, other: Named) -> bool:
    """Return whether two tests share a file by its content, or hold the same scattering readings at
    the same targets.
    """
    if share_a_file(one.sources, other.sources):
        return True
    return one.test is not None and other.test is not None and same_readings(one.test, other.test)


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
