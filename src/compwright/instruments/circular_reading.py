"""Read circular tests from ``.b5r`` or plain CSV files. Several files of a test are joined.

Codes made here:

- ``CW-R035`` warning: a deviation of a circle larger than 1 mm
- ``CW-R036`` warning: a run whose deviations are all below the resolution of a ballbar
- ``CW-R037`` warning: files of one test differ in facts other than those that identify the test
"""

from __future__ import annotations

import codecs
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import source_of
from compwright.instruments.b5r import read_b5r
from compwright.instruments.b5r_elements import ELEMENTS
from compwright.instruments.circular_arcs import check_same_arc
from compwright.instruments.circular_csv import read_circular_csv
from compwright.instruments.fault_list import FaultList
from compwright.instruments.own_forms import spans_of_plain_csv
from compwright.instruments.spans import Grammar
from compwright.instruments.text_input import stem
from compwright.records.circular import CircularRun, CircularTest
from compwright.records.positioning import LARGEST_PLAUSIBLE

_SAME_RADIUS: Final = 1e-6  # mm, rounding of printed lengths
#: Feeds of the runs of one test may differ by the override's last digit and by sampling, not more.
_SAME_FEED: Final = 0.05
_SAME_CENTRE: Final = 0.01  # mm
#: Resolution of a ballbar, mm: smaller deviations are in another unit, or were not measured.
_RESOLUTION: Final = 1e-4
#: On less than about this, deg, offset and radius follow the squareness of a good machine.
_HALF_CIRCLE: Final = 170.0


@dataclass(frozen=True, slots=True)
class CircularForm:
    """A file format of circular tests: its reader, and the meaning of its text (``grammar``).

    ``read`` is called with the content, the name of the file and the name of the test. The command
    `redact` uses ``grammar`` to decide which parts of the file it keeps and which it replaces.
    """

    name: str
    read: Callable[[bytes, str, str], CircularTest]
    grammar: Grammar


BALLBAR: Final = CircularForm("a ballbar's file (.b5r)", read_b5r, ELEMENTS)
PLAIN_CIRCLE: Final = CircularForm("plain CSV, circular", read_circular_csv, spans_of_plain_csv)
CIRCULAR_FORMS: Final = (BALLBAR, PLAIN_CIRCLE)


def circular_form(content: bytes) -> CircularForm:
    """Return the form of a circular test: ballbar XML if it begins with ``<``, else plain CSV."""
    start = content[:64].lstrip(codecs.BOM_UTF8 + codecs.BOM_UTF16_LE + b" \t\r\n\x00")
    return BALLBAR if start.startswith(b"<") else PLAIN_CIRCLE


def read_circular(content: bytes, file: str) -> CircularTest:
    """Return the circular test in ``content``. ``file``: its name in messages and in the record's
    source.

    The forms ``.b5r`` and plain CSV (contract, "Plain CSV") are recognised by the content. Lengths
    of the result are in mm, and deviations are measured minus nominal. Angles are in deg from the
    first axis to the second. The feed is the feed that was really reached, if the file shows it.
    Raises InputError with all faults that can be found at once.
    """
    test = circular_form(content).read(content, file, stem(file))
    return replace(
        test, sources=(source_of(file, content),), findings=(*test.findings, *_plausibility(test))
    )


def merge_circular(tests: Sequence[CircularTest], name: str) -> CircularTest:
    """Join several files (one for each direction or for each run) to one test, and number its runs
    continuously.

    Raises InputError if the files do not belong together (plane, radius, feed, arc or centre
    differ) or if a file is given twice. Raises UsageError if no file is given.
    """
    if not tests:
        raise UsageError(
            Fault(
                message="no measurement file is given for this circular test",
                place=name,
                expected="at least one file",
                hint="give `file`, or `ccw` and `cw`, in this entry of `circles`",
            )
        )
    faults = FaultList("")
    first = tests[0]
    hashes = Counter(source.sha256 for test in tests for source in test.sources)
    for test in tests[1:]:
        _check_same_test(first, test, faults)
    for sha256, count in hashes.items():
        if count > 1:
            names = [
                source.file for test in tests for source in test.sources if source.sha256 == sha256
            ]
            faults.add(
                "the same measurement is given twice",
                place=name,
                expected="each run once",
                found=", ".join(names),
                hint="give each file once",
            )
    faults.raise_if_any()
    return replace(
        first,
        name=name,
        feed=float(np.mean([test.feed for test in tests])),
        calibrated=all(test.calibrated for test in tests),
        centre=next((test.centre for test in tests if test.centre is not None), None),
        runs=tuple(_counted([run for test in tests for run in test.runs])),
        vendor=_joined_vendor(tests),
        sources=tuple(source for test in tests for source in test.sources),
        header=_joined_header(tests),
        findings=(
            *dict.fromkeys(finding for test in tests for finding in test.findings),
            *_differences(tests),
        ),
    )


def _counted(runs: Sequence[CircularRun]) -> list[CircularRun]:
    """Return the runs, ccw before cw, numbered from 1 in each direction."""
    return [
        replace(run, number=number)
        for sense in ("ccw", "cw")
        for number, run in enumerate((run for run in runs if run.sense == sense), start=1)
    ]


def _file_of(test: CircularTest) -> str:
    return ", ".join(source.file for source in test.sources) or test.name


def _step(test: CircularTest) -> float:
    return max(float(np.median(np.abs(np.diff(run.angles)))) for run in test.runs)


def _check_same_test(one: CircularTest, other: CircularTest, faults: FaultList) -> None:
    names = (_file_of(one), _file_of(other))

    def differ(what: str, expected: str, found: str) -> None:
        faults.add(
            f"{what} differs between the files of one test",
            place=names[1],
            expected=f"{expected} as in {names[0]}",
            found=found,
            hint="give the files of one test only, or correct this value in one of them",
        )

    if (one.plane, one.axes) != (other.plane, other.axes):
        differ(
            "the plane",
            f"{one.plane} ({', '.join(one.axes)})",
            f"{other.plane} ({', '.join(other.axes)})",
        )
    if abs(one.nominal_radius - other.nominal_radius) > _SAME_RADIUS:
        differ(
            "the nominal radius", f"{one.nominal_radius:.10g} mm", f"{other.nominal_radius:.10g} mm"
        )
    if abs(other.feed / one.feed - 1.0) > _SAME_FEED:
        differ("the feed", f"about {one.feed:.5g} mm/min", f"{other.feed:.5g} mm/min")
    if one.centre and other.centre and _apart(one.centre, other.centre):
        differ(
            "the centre",
            ", ".join(f"{value:g}" for value in one.centre),
            ", ".join(f"{value:g}" for value in other.centre),
        )
    if not (one.full_circle and other.full_circle):
        check_same_arc(one.arc, other.arc, max(_step(one), _step(other)), names, faults)


def _apart(one: Sequence[float], other: Sequence[float]) -> bool:
    return (
        len(one) != len(other)
        or max(abs(a - b) for a, b in zip(one, other, strict=True)) > _SAME_CENTRE
    )


def _joined_header(tests: Sequence[CircularTest]) -> dict[str, str]:
    """Return the header of a test in several files: for each key the values in the files, one per
    line, equal values once.
    """
    keys = dict.fromkeys(key for test in tests for key in test.header)
    return {
        key: "\n".join(dict.fromkeys(test.header[key] for test in tests if key in test.header))
        for key in keys
    }


def _joined_vendor(tests: Sequence[CircularTest]) -> Mapping[str, object]:
    """Return the results printed by the vendor's software. If several files have such results, they
    are returned by file name.
    """
    printed = {_file_of(test): test.vendor for test in tests if test.vendor}
    return next(iter(printed.values())) if len(printed) == 1 else printed


def _differences(tests: Sequence[CircularTest]) -> list[Finding]:
    if len({test.calibrated for test in tests}) == 1:
        return []
    without = [_file_of(test) for test in tests if not test.calibrated]
    return [Finding.of("CW-R037", "warning", files=without)]


def _plausibility(test: CircularTest) -> list[Finding]:
    findings = []
    largest = max(float(np.abs(run.deviations).max()) for run in test.runs)
    if largest > LARGEST_PLAUSIBLE:
        findings.append(Finding.of("CW-R035", "warning", largest=largest))
    small = [
        f"{run.sense} {run.number}" for run in test.runs if _least_deviation(run) < _RESOLUTION
    ]
    if small:
        findings.append(Finding.of("CW-R036", "warning", runs=small))
    return findings


def _least_deviation(run: CircularRun) -> float:
    """Return the largest amount, mm, of the deviations of a run, about zero or about the
    least-squares circle, whichever is less. A short arc has no circle of its own.
    """
    largest = float(np.abs(run.deviations).max())
    theta = np.radians(run.angles)
    if np.ptp(run.angles) < _HALF_CIRCLE:
        return largest
    circle = np.column_stack([np.ones_like(theta), np.cos(theta), np.sin(theta)])
    fitted = circle @ np.linalg.lstsq(circle, run.deviations, rcond=None)[0]
    return min(largest, float(np.abs(run.deviations - fitted).max()))
