"""Warning for tests of an axis that cover more travel than the tests that are fitted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from compwright.foundations.findings import Finding
from compwright.records.positioning import PositioningTest


def longer_tests(
    fitted: Sequence[PositioningTest], others: Iterable[PositioningTest]
) -> list[Finding]:
    """Return the finding CW-E011 for each of the ``others``, tests not in use, that extends beyond
    the ``fitted`` tests by more than one mean interval of targets.

    An axis longer than 2 000 mm has two tests (ISO 230-2:1997, 5.2): one over its whole length,
    made once, and one over 2 000 mm, made five times. Both are used together if it is known which
    compensation was active in each. Otherwise the error beyond the fitted tests is extrapolated,
    although the other test measured it.
    """
    first = fitted[0]
    low = min(float(test.targets[0]) for test in fitted)
    high = max(float(test.targets[-1]) for test in fitted)
    interval = float(first.targets[-1] - first.targets[0]) / max(first.targets.size - 1, 1)
    unit = first.kind.unit
    names = [test.name for test in fitted]
    return [
        Finding.of(
            "CW-E011",
            "warning",
            tests=names,
            number=len(names),
            low=low,
            high=high,
            unit=unit,
            other=other.name,
            other_low=other.targets[0],
            other_high=other.targets[-1],
        )
        for other in others
        if other.targets[0] < low - interval or other.targets[-1] > high + interval
    ]
