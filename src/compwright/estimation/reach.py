"""How far the tests that are fitted reach beside the others of their axis."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from compwright.foundations.findings import Finding
from compwright.records.positioning import PositioningTest


def longer_tests(
    fitted: Sequence[PositioningTest], others: Iterable[PositioningTest]
) -> list[Finding]:
    """Return a doubt for each other test that reaches beyond the ``fitted`` ones by more than a
    mean interval of the first of them (CW-E011).

    An axis over 2 000 mm has two tests (ISO 230-2:1997, 5.2): its whole length once, and 2 000 mm
    five times. They count together where it is known what acted in each. Beyond the fitted ones the
    error is continued, although the other test measured it.
    """
    first = fitted[0]
    low = min(float(test.targets[0]) for test in fitted)
    high = max(float(test.targets[-1]) for test in fitted)
    interval = float(first.targets[-1] - first.targets[0]) / max(first.targets.size - 1, 1)
    unit = first.kind.unit
    names = " and ".join(test.name for test in fitted)
    which = f"test {names} alone, which covers" if len(fitted) == 1 else f"tests {names}, over"
    return [
        Finding(
            "CW-E011",
            "warning",
            f"The table is made from the {which} {low:g} to {high:g}"
            f" {unit}; the test {other.name} measured {other.targets[0]:g} to {other.targets[-1]:g}"
            f" {unit} and is not fitted. Beyond {low:g} to {high:g} {unit} the error is only"
            " continued and may be wrong by more than it is: name the state that was active in"
            " the control while"
            f" it was measured (measured_in), list the test {other.name} first, or let the table"
            " end at the measured range (table: start, end)",
        )
        for other in others
        if other.targets[0] < low - interval or other.targets[-1] > high + interval
    ]
