"""The range E_VE of environmental variation, from a stand-still test.

ISO 230-2:2006 names the contributor (introduction and annex A, A.2.5) and refers to ISO 230-3 for
the test: the axis is at rest, and the reading is recorded for the duration of a positioning test.
The texts of annex A and of ISO 230-3 were not available. Here E_VE is the largest range of the
readings within the duration of a positioning test.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.drift import DriftTest
from compwright.words.sentences import Amount, say

#: min: no positioning test is shorter. 5 targets, five times in both directions (4.3.2), 6 s each.
SHORTEST: Final = 5.0
#: Readings further apart than this share of the duration may pass by what comes and goes.
_COARSE: Final = 0.1


def environmental_variation(
    drift: DriftTest, duration_min: float | None
) -> tuple[float, tuple[Finding, ...]]:
    """Return the range E_VE of environmental variation (µm or arcsec) within ``duration_min``, the
    duration of a positioning test (None: within the whole series), and its findings.

    CW-T026 states the range and the time over which it was found. CW-T027: the series is too short
    or its readings are too far apart in time.
    """
    length = float(drift.minutes[-1] - drift.minutes[0])
    over = length if duration_min is None else min(duration_min, length)
    value = _largest_range(drift, over) * outside_factor(drift.kind.unit)
    unit = shown_unit(drift.kind.unit)
    found = Finding.of(
        "CW-T026.whole" if duration_min is None else "CW-T026.within",
        "info",
        E_VE=Amount(value, unit),
        file=drift.source.file,
        minutes=over,
    )
    return value, (found, *_too_short(drift, length, duration_min))


def _largest_range(drift: DriftTest, over: float) -> float:
    """Return the largest range (mm or deg) of the readings within any ``over`` minutes."""
    largest = 0.0
    last = np.searchsorted(drift.minutes, drift.minutes + over * (1.0 + 1e-9), side="right")
    for first, end in enumerate(last):
        largest = max(largest, float(np.ptp(drift.deviations[first:end])))
        if end == drift.minutes.size:
            break
    return largest


def _too_short(drift: DriftTest, length: float, duration_min: float | None) -> tuple[Finding, ...]:
    needed = SHORTEST if duration_min is None else duration_min
    widest = float(np.max(np.diff(drift.minutes)))
    faults = []
    if length < needed:
        faults.append(say("CW-T027.short", minutes=length, test=duration_min))
    if widest > _COARSE * min(duration_min or length, length):
        faults.append(say("CW-T027.coarse", minutes=widest))
    if not faults:
        return ()
    return (Finding.of("CW-T027", "warning", file=drift.source.file, reasons=faults),)
