"""Copy measurement files without names. Each copy is checked by reading it with the same reader as
the original.
"""

from __future__ import annotations

import numpy as np

from compwright.foundations.errors import CompwrightError
from compwright.foundations.redaction import Cuts, not_the_same, refuse_left_over
from compwright.instruments.circular_reading import read_circular
from compwright.instruments.drift_csv import (
    is_drift,
    is_lost_motion,
    read_drift,
    read_lost_motion,
)
from compwright.instruments.other_files import is_circular
from compwright.instruments.profile import Profile
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.reading import read_tests
from compwright.instruments.redaction.measurement import (
    ALLOWED,
    Redacted,
    redacted_measurement,
)
from compwright.instruments.redaction.words import is_axis
from compwright.instruments.text_input import read_any_lines
from compwright.instruments.workbook import is_workbook, sheets_of
from compwright.records.axis import AxisKind

#: What was read, in the order of the file: numbers, and the words that decide about them.
_Read = list[tuple[object, ...]]


def measurement_copy(content: bytes, file: str, cuts: Cuts, profile: Profile | None) -> Redacted:
    """Return a checked copy of a measurement file without names; ``cuts`` records the removed
    texts.

    Raises InputError for a file that cannot be read, for a copy that would have another meaning,
    and for a copy that still contains a removed text.
    """
    made = redacted_measurement(content, file, cuts, profile)
    read_by = None if not made.profile else read_profile(made.answered.encode(), "profile")
    old = _read(content, file, made.read_by)
    try:
        new = _read(made.content, file, read_by if read_by is not None else made.read_by)
    except CompwrightError as error:
        raise not_the_same(file, str(error.faults[0].message)) from error
    if not _same(old, new):
        raise not_the_same(file, "other numbers")
    refuse_left_over(
        file, cuts, _members(made, file), ALLOWED, in_lines=not is_workbook(made.content)
    )
    return made


def _members(made: Redacted, file: str) -> list[bytes]:
    texts = [made.profile.encode()]
    if not is_workbook(made.content):
        return [made.content, *texts]
    return [
        *texts,
        *(
            "\n".join((sheet.name, *sheet.lines)).encode()
            for sheet in sheets_of(made.content, file)
        ),
    ]


def _read(content: bytes, file: str, profile: Profile | None) -> _Read:
    if not is_workbook(content):
        if is_circular(content, file):
            return _circle(content, file)
        if profile is None and is_drift(read_any_lines(content, file)[0]):
            return _drift(content, file)
        if profile is None and is_lost_motion(read_any_lines(content, file)[0]):
            lost = read_lost_motion(content, file)
            return [(lost.over, lost.moves, lost.lost_motion)]
    return [
        (
            test.axis if is_axis(test.axis) else "",
            test.kind,
            test.targets,
            test.positive,
            test.negative,
            test.runs_positive,
            test.runs_negative,
            test.cycle,
            test.frame,
            tuple((one.code, one.severity) for one in test.findings if one.code in _DECISIVE),
        )
        for test in read_tests(content, file, profile)
    ]


#: Findings about readings: they must not come or go.
_DECISIVE = frozenset({"CW-R006", "CW-R007", "CW-R050", "CW-R051", "CW-R053", "CW-R054", "CW-R055"})


def _circle(content: bytes, file: str) -> _Read:
    test = read_circular(content, file)
    return [
        (test.plane, test.axes, test.nominal_radius, test.feed, test.arc, test.calibrated),
        (test.centre or (),),
        *((run.sense, run.number, run.angles, run.deviations) for run in test.runs),
    ]


def _drift(content: bytes, file: str) -> _Read:
    lines, _ = read_any_lines(content, file)
    rotary = any("deviation_arcsec" in line.lower() for line in lines)
    test = read_drift(content, file, AxisKind.ROTARY if rotary else AxisKind.LINEAR)
    return [(test.kind, test.minutes, test.deviations)]


def _same(old: _Read, new: _Read) -> bool:
    return len(old) == len(new) and all(
        len(one) == len(other) and all(map(_equal, one, other))
        for one, other in zip(old, new, strict=True)
    )


def _equal(one: object, other: object) -> bool:
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return np.array_equal(one, other, equal_nan=True)
    return one == other
