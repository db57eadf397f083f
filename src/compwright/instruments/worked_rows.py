"""Write readings as sentences, so that the user notices a wrong sign, unit or direction before
loading.
"""

from __future__ import annotations

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.instruments.assembling import as_text
from compwright.instruments.readings import ApproachReading, Readings
from compwright.records.axis import AxisKind, Direction

_FROM = {Direction.POSITIVE: "approached from below", Direction.NEGATIVE: "approached from above"}
_SHOWN = 3


def worked_readings(readings: Readings, kind: AxisKind) -> list[str]:
    """Return up to three readings as sentences: the one with the largest deviation in each
    direction, and one in the middle of the targets.
    """
    chosen: dict[str, ApproachReading] = {}
    for positive in (True, False):
        ours = np.flatnonzero(readings.positive == positive)
        if ours.size:
            largest = ours[np.argmax(np.abs(readings.deviations[ours]))]
            chosen.setdefault(readings.place(int(largest)), readings.one(int(largest)))
    middle = np.lexsort((readings.runs, readings.targets))
    for index in np.roll(middle, -(middle.size // 2)).tolist():
        if len(chosen) >= _SHOWN:
            break
        chosen.setdefault(readings.place(index), readings.one(index))
    return [in_words(reading, kind) for reading in chosen.values()]


def read_so_finding(readings: Readings, kind: AxisKind, by: str = "") -> Finding | None:
    """Return the finding that shows some readings as sentences, or None if there are no readings.
    ``by``: the profile with which they were read.
    """
    if not len(readings):
        return None
    return Finding.of("CW-R060", "info", by=by, readings=worked_readings(readings, kind))


def in_words(reading: ApproachReading, kind: AxisKind) -> str:
    """Return a reading as a sentence: position, direction of approach, and deviation."""
    size = abs(reading.deviation) * outside_factor(kind.unit)
    verb = "went" if kind is AxisKind.LINEAR else "turned"
    forth = (reading.deviation > 0.0) == (reading.direction is Direction.POSITIVE)
    number = f"{as_text(float(f'{size:.6g}'))} {shown_unit(kind.unit)}"
    if not size:
        how = f"{verb} exactly there"
    elif forth:
        how = f"{verb} {number} too far"
    else:
        how = f"stopped {number} short"
    return (
        f"{reading.place}: at {as_text(reading.target)} {kind.unit}, {_FROM[reading.direction]},"
        f" the axis {how}"
    )
