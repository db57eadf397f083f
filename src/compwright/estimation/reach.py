"""How far the fitted test reaches beside the others of its axis."""

from __future__ import annotations

from collections.abc import Iterable

from compwright.foundations.findings import Finding
from compwright.records.positioning import PositioningTest


def longer_tests(fitted: PositioningTest, others: Iterable[PositioningTest]) -> list[Finding]:
    """Return a doubt for each other test that reaches beyond the ``fitted`` one by more than a mean
    interval of it (CW-E011).

    An axis over 2 000 mm has two tests (ISO 230-2, 5.2): its whole length once, and 2 000 mm five
    times. The table rests on the fitted one; beyond it the error is continued, although the other
    test measured it.
    """
    low, high = float(fitted.targets[0]), float(fitted.targets[-1])
    interval = (high - low) / max(fitted.targets.size - 1, 1)
    unit = fitted.kind.unit
    return [
        Finding(
            "CW-E011",
            "warning",
            f"The table is made from the test {fitted.name} alone, which covers {low:g} to {high:g}"
            f" {unit}; the test {other.name} measured {other.targets[0]:g} to {other.targets[-1]:g}"
            f" {unit} and is not fitted. Beyond {low:g} to {high:g} {unit} the error is only"
            f" continued and may be wrong by more than it is: list the test {other.name} first, or"
            " let the table end at the measured range (table: start, end)",
        )
        for other in others
        if other.targets[0] < low - interval or other.targets[-1] > high + interval
    ]
