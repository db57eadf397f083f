"""Reader of Renishaw ballbar files ``.b5r`` (QC10, QC20-W): XML with the runs of a test.

The rules for reading come from six published files, whose own results are reproduced to 0.1 µm. The
samples of the arc are START_INDEX to END_INDEX inclusive. Each sample is in the middle of an equal
part of the arc. The length is NOMINAL_LENGTH + reading, and calibration and temperature are already
in it. Angles are counted from the first named axis to the second, whatever the view.

Codes made here:

- ``CW-R030`` info: temperature and calibration of the ballbar, already in the readings
- ``CW-R031`` warning: the true feed is not the programmed one
- ``CW-R032`` warning: the readings do not quite fill the arc and its overshoot
- ``CW-R033`` warning: a direction that the test specifies was not measured
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import MOST_SAMPLES_OF_A_RUN
from compwright.instruments.b5r_fields import finite, number_of, text_of
from compwright.instruments.b5r_header import BAR, header_of, vendor_results
from compwright.instruments.circular_arcs import FEWEST_SAMPLES
from compwright.instruments.circular_csv import axes_of_plane, centre_of
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.reading_findings import stray_finding
from compwright.instruments.safe_xml import Element, read_xml
from compwright.records.axis import FloatArray
from compwright.records.circular import SHORTEST_ARC, CircularRun, CircularTest, Sense
from compwright.words.sentences import NumberText

_SENSES: Final[Mapping[str, Sense]] = {"CCW": "ccw", "CW": "cw"}
_INDEX: Final = re.compile(r"[0-9]{1,8}")
#: No ballbar is longer, mm.
_LONGEST: Final = 10_000.0
_SAME_LENGTH: Final = 1e-6  # mm, rounding of printed lengths
_SAME_ANGLE: Final = 1e-6  # deg, the same for angles
#: In all files seen as many samples of overshoot follow the arc as precede it; beyond this the
#: readings are of another length.
_TAIL: Final = (2, 0.02)  # samples, share of the samples of the arc; the larger of both
#: No bar is shorter, no feed or sampling slower than this (mm, mm/min, Hz).
_SMALLEST = 1e-6
#: A feed off by more than this does not come from the rounding of the sampling: override, or an
#: axis that did not follow.
_FEED_SHARE: Final = 0.05


@dataclass(frozen=True, slots=True, kw_only=True)
class _Spec:
    """The planned radius (mm), feed (mm/min), arc (deg) and plane of a test; NaN if invalid."""

    length: float
    feed: float
    start: float
    extent: float
    plane: str
    axes: tuple[str, str]
    calibrated: bool


@dataclass(frozen=True, slots=True)
class _FeedRun:
    """A circular run, and its feed (mm/min) computed from the sample rate, None if unknown."""

    run: CircularRun
    feed: float | None
    stray: int


def read_b5r(content: bytes, file: str, name: str) -> CircularTest:
    """Return the circular test in a ``.b5r`` file. Raises InputError with every fault at once.

    Each fault states the line of the element and its path. These are faults:

    - XML that is broken or declares a document type, or another instrument's file;
    - no readings, or a missing or invalid number;
    - a test radius other than the length of the bar, or an arc below 90 deg;
    - indices outside the readings, or a number of readings that does not fit arc and overshoot.
    """
    root = read_xml(content, file)
    bar = _ballbar(root, file)
    faults = FaultList(file)
    spec = _spec(bar, faults)
    elements = list(root.all("RUN_RESULTS", "BALLBAR_RUN"))
    if not any(element.first("READINGS") for element in elements):
        faults.add(
            (
                "contains no readings: the test was set up, or its header exported, without a"
                " measurement"
            ),
            expected="RUN_RESULTS with a BALLBAR_RUN and its READINGS",
            hint="make the measurement, then save the file again",
        )
        faults.raise_if_any()
    runs = _runs(elements, spec, faults)
    faults.raise_if_any()
    feeds = [run.feed for run in runs if run.feed is not None]
    feed = sum(feeds) / len(feeds) if feeds else spec.feed
    header = header_of(root, elements)
    return CircularTest(
        name=name,
        plane=spec.plane,
        axes=spec.axes,
        nominal_radius=spec.length,
        feed=feed,
        arc=(spec.start % 360.0, spec.extent),
        calibrated=spec.calibrated,
        runs=tuple(sorted((run.run for run in runs), key=lambda run: (run.sense, run.number))),
        centre=centre_of(header.get("centre", "")),
        vendor=vendor_results(root, elements, [run.run for run in runs]),
        header=header,
        findings=(*_findings(bar, elements, spec, runs, feed), *_elsewhere(root, elements)),
    )


def _ballbar(root: Element, file: str) -> Element:
    if root.tag != "TEST_DOCUMENT":
        place, expected = f"line {root.line}", "the root element TEST_DOCUMENT"
        raise InputError(
            Fault(
                message="the file is not a ballbar file",
                file=file,
                place=place,
                expected=expected,
                found=shown(root.tag),
                hint="give the .b5r file that the ballbar software wrote",
            )
        )
    instrument = root.first("TEST_SPEC", "INSTRUMENT")
    bar = root.first(*BAR)
    if bar is None:
        kinds = (
            [child.tag for child in instrument.children]
            if instrument
            else [child.tag for child in root.children]
        )
        place = f"line {(instrument or root).line}, {'/'.join(BAR)}"
        raise InputError(
            Fault(
                message="the file is of another instrument"
                if instrument
                else "the file does not state which instrument measured",
                file=file,
                place=place,
                expected="a dynamic ballbar test",
                found=shown(", ".join(kinds[:8]) or "nothing"),
                hint="give a file with the expected kind of test",
            )
        )
    return bar


def _spec(bar: Element, faults: FaultList) -> _Spec:
    length = number_of(bar, "NOMINAL_LENGTH", faults, above=_SMALLEST, most=_LONGEST)
    if bar.first("TEST_RADIUS"):
        radius = number_of(bar, "TEST_RADIUS", faults, above=_SMALLEST, most=_LONGEST)
        if abs(radius - length) > _SAME_LENGTH:
            faults.add(
                "test radius and length of the ballbar differ",
                place=f"line {bar.line}, DYNAMIC_BALLBAR/TEST_RADIUS",
                expected=f"{length:g} mm, as NOMINAL_LENGTH",
                found=f"{radius:g} mm",
            )
    start = number_of(bar, "START_ANGLE", faults, above=-1000.0, most=1000.0)
    end = number_of(bar, "END_ANGLE", faults, above=-1000.0, most=1000.0)
    extent = (end - start) % 360.0
    if extent < _SAME_ANGLE:  # the same angle twice is the whole circle
        extent = 360.0
    if extent < SHORTEST_ARC - _SAME_ANGLE:
        faults.add(
            "covers too short an arc",
            place=f"line {bar.line}, DYNAMIC_BALLBAR/END_ANGLE",
            expected="at least 90 deg from START_ANGLE to END_ANGLE",
            found=f"{extent:g} deg, from {start:g} to {end:g}",
            hint="measure an arc of 90 deg or more",
        )
    plane, axes = _plane(bar, faults)
    return _Spec(
        length=length,
        feed=number_of(bar, "PROGRAMMED_FEEDRATE", faults, above=_SMALLEST),
        start=start,
        extent=extent,
        plane=plane,
        axes=axes,
        calibrated=bar.attributes.get("CALIBRATION_REQUIRED", "").lower() == "true",
    )


def _plane(bar: Element, faults: FaultList) -> tuple[str, tuple[str, str]]:
    """Return the plane, such as ``XY``, and the names of its two axes: those in the file, or the
    letters of the plane if the file does not name both.
    """
    element = bar.first("PLANE")
    plane = element.attributes.get("TEST_PLANE", "").upper() if element else ""
    letters = axes_of_plane(plane)
    named = [(bar.first("PLANE", f"{side}_AXIS_NAME") or bar).text for side in "AB"]
    if letters is None:
        faults.add(
            "names no plane",
            place=f"line {(element or bar).line}, DYNAMIC_BALLBAR/PLANE",
            expected="TEST_PLANE XY, YZ or ZX",
            found=shown(plane),
            hint='write the plane into a copy of the file: TEST_PLANE="XY"',
        )
        return "", ("", "")
    if all(named):
        upper = tuple(name.upper() for name in named)
        if letters != upper and {*upper} <= {*"XYZ"} and upper[0] != upper[1]:
            faults.add(
                "names other axes than its plane",
                place=f"line {(element or bar).line}, DYNAMIC_BALLBAR/PLANE",
                expected=f"{' and '.join(letters)} in A_AXIS_NAME and B_AXIS_NAME, as TEST_PLANE",
                found=shown(" and ".join(named)),
                hint="correct TEST_PLANE or both names in a copy of the file",
            )
        if upper[0] == upper[1]:
            faults.add(
                "names one axis twice",
                place=f"line {(element or bar).line}, DYNAMIC_BALLBAR/PLANE",
                expected="different names in A_AXIS_NAME and B_AXIS_NAME",
                found=shown(" and ".join(named)),
                hint="correct A_AXIS_NAME or B_AXIS_NAME in a copy of the file",
            )
        return plane, (named[0], named[1])
    return plane, letters


def _runs(elements: Sequence[Element], spec: _Spec, faults: FaultList) -> list[_FeedRun]:
    runs: list[_FeedRun] = []
    for element in elements:
        text, place = text_of(element, faults, "RUN_DIRECTION")
        sense = _SENSES.get(text.upper())
        if text and sense is None:
            faults.add(
                "direction is neither CCW nor CW",
                place=place,
                expected="CCW or CW",
                found=shown(text),
            )
        number = 1 + sum(run.run.sense == sense for run in runs)
        run = _run(element, sense or "ccw", number, spec, faults)
        if run is not None and sense is not None:
            runs.append(run)
    return runs


def _run(
    element: Element, sense: Sense, number: int, spec: _Spec, faults: FaultList
) -> _FeedRun | None:
    """Return one run with the angle of each sample (deg).

    For sample k of N (from 0), let s be (k + 1/2) extent/N. Its angle is start + s for ccw, and
    start + extent - s for cw.
    """
    readings = _readings(element, faults)
    indices = _indices(element, readings, faults)
    rate = (
        number_of(element, "SAMPLE_RATE", faults, above=_SMALLEST)
        if element.first("SAMPLE_RATE")
        else None
    )
    if readings is None or indices is None:
        return None
    first, last = indices
    count = last - first + 1
    stray = readings.size - 1 - last - first
    if abs(stray) > max(_TAIL[0], _TAIL[1] * count):
        faults.add(
            "READINGS have the wrong length",
            place=f"line {element.line}, BALLBAR_RUN/READINGS",
            expected=(
                f"{last + 1 + first} values: {count} of the arc and {first} of overshoot on either"
                " side"
            ),
            found=f"{readings.size}",
            hint="save the file again in the ballbar software: readings are missing or doubled",
        )
    along = (np.arange(count) + 0.5) * spec.extent / count
    begin = spec.start % 360.0
    angles = begin + along if sense == "ccw" else begin + spec.extent - along
    run = CircularRun(
        sense=sense, angles=angles, deviations=readings[first : last + 1], number=number
    )
    feed = (
        None
        if rate is None
        else 60.0 * 2.0 * math.pi * spec.length * (spec.extent / 360.0) / count * rate
    )
    return _FeedRun(run, feed, stray)


def _readings(element: Element, faults: FaultList) -> FloatArray | None:
    text, place = text_of(element, faults, "READINGS")
    tokens = text.split()
    if len(tokens) > MOST_SAMPLES_OF_A_RUN:
        faults.add(
            "READINGS are longer than any run",
            place=place,
            expected=f"at most {MOST_SAMPLES_OF_A_RUN} values",
            found=str(len(tokens)),
            hint="save the file again in the ballbar software",
        )
        return None
    values: list[float] = []
    wrong = False
    for position, token in enumerate(tokens, start=1):
        value = finite(token)
        if value is None:
            faults.add(
                "a reading is not a number",
                place=f"{place}, value {position}",
                expected="a number in mm with a decimal point",
                found=shown(token),
            )
            wrong = True
        else:
            values.append(value)
    return None if wrong or not values else np.array(values)


def _indices(
    element: Element, readings: FloatArray | None, faults: FaultList
) -> tuple[int, int] | None:
    """Return the indices of the first and last sample of the arc in ``readings``, or None if they
    are invalid.
    """
    found: list[int] = []
    for tag in ("START_INDEX", "END_INDEX"):
        text, place = text_of(element, faults, tag)
        if text and not _INDEX.fullmatch(text):
            faults.add("is not an index", place=place, expected="0, 1, 2, ...", found=shown(text))
        elif text:
            found.append(int(text))
    if readings is None or len(found) < 2:
        return None
    first, last = found
    place = f"line {element.line}, BALLBAR_RUN"
    if last >= readings.size:
        faults.add(
            "END_INDEX is outside the readings",
            place=place,
            expected=f"at most {readings.size - 1}, the last",
            found=str(last),
            hint="save the file again in the ballbar software: readings are missing",
        )
        return None
    if last - first + 1 < FEWEST_SAMPLES:
        faults.add(
            "has too few samples",
            place=place,
            expected=f"at least {FEWEST_SAMPLES} samples from START_INDEX to END_INDEX",
            found=f"{first} to {last}",
            hint="measure at a lower feed, or with a higher sample rate",
        )
        return None
    return first, last


def _number_or_text(text: str) -> str:
    return shown(text) if finite(text) is None else NumberText(text)


def _findings(
    bar: Element, elements: Sequence[Element], spec: _Spec, runs: Sequence[_FeedRun], feed: float
) -> list[Finding]:
    findings = []
    coefficient = (bar.first("TEMP_MATERIAL_COEFFICIENT") or bar).text
    temperatures = dict.fromkeys(
        found.text
        for element in elements
        if (found := element.first("RUN_TEMPERATURE")) and found.text
    )
    if finite(coefficient) and temperatures:
        findings.append(
            Finding.of(
                "CW-R030",
                "info",
                expansion=_number_or_text(coefficient),
                temperatures=map(_number_or_text, temperatures),
            )
        )
    if abs(feed / spec.feed - 1.0) > _FEED_SHARE:
        findings.append(Finding.of("CW-R031", "warning", feed=feed, programmed=spec.feed))
    findings.extend(_stray_finding(run) for run in runs if run.stray)
    measured = {run.run.sense for run in runs}
    wanted = [_SENSES.get(element.text.upper()) for element in bar.all("RUN_SPEC", "RUN_DIRECTION")]
    findings.extend(
        Finding.of("CW-R033", "warning", sense=sense)
        for sense in dict.fromkeys(
            sense for sense in wanted if sense is not None and sense not in measured
        )
    )
    return findings


def _elsewhere(root: Element, elements: Sequence[Element]) -> list[Finding]:
    """Return a list with the finding about runs in parts of the file that compwright does not read;
    the list is empty if there are no such runs.
    """
    read = {element.line for element in elements}
    lines = [
        (run.line, run.tag)
        for run in root.anywhere("BALLBAR_RUN")
        if run.line not in read and run.first("READINGS") is not None
    ]
    finding = stray_finding(lines)
    return [] if finding is None else [finding]


def _stray_finding(run: _FeedRun) -> Finding:
    return Finding.of(
        "CW-R032",
        "warning",
        direction=run.run.sense,
        run=run.run.number,
        number=abs(run.stray),
        more=run.stray > 0,
    )
