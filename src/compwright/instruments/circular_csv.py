"""The plain CSV form of a circular test: a row per sample with direction, run, angle and radius.

Columns, in any order: ``direction`` (``ccw``, ``cw``), ``angle_deg``, and either ``radius_mm`` or
``deviation_um``. The column ``run`` is optional. The rows may be in any order.

Required comment keys: ``plane`` (first and second axis), ``nominal_radius_mm`` and ``feed_mm_min``.
Optional ones: ``calibrated``, ``centre`` and ``deviation`` (the sign of ``deviation_um``).

Code made here:

- ``CW-R034`` warning: samples are missing within a run
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import MOST_READINGS
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE, MILLIMETRES_PER_INCH
from compwright.instruments.circular_arcs import LARGEST_ANGLE, Sweep, common_arc, run_of, sweep_of
from compwright.instruments.code_page import read_plain_lines
from compwright.instruments.comments import Comments, read_comments, sign_of
from compwright.instruments.csv_table import (
    CIRCULAR_COLUMNS,
    CIRCULAR_VALUES,
    INCHES,
    CsvTable,
    NumberedLines,
    in_inches,
    read_table,
    split_lines,
)
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import DecimalMarks, counts_of, parse_number
from compwright.instruments.reading_findings import (
    assumed_finding,
    doubtful_finding,
    left_out_finding,
    unfinished_finding,
)
from compwright.instruments.readings import IntArray
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun, CircularTest, Sense

KEYS: Final = frozenset(
    {"plane", "nominal_radius_mm", "feed_mm_min", "calibrated", "centre", "deviation", "compwright"}
)
_NEWEST_FORM: Final = 1
PLANE: Final = re.compile(r"([A-Za-z][0-9]{0,2})[ ,/-]?([A-Za-z][0-9]{0,2})")
_FORM_KEY: Final = re.compile(r"circular\s+([0-9]{1,9})")
_SENSES: Final[tuple[Sense, Sense]] = ("ccw", "cw")
_YES: Final[Mapping[str, bool]] = {"yes": True, "true": True, "no": False, "false": False}
#: Radii whose median lies farther from nominal than this are in another unit or of another circle.
_FAR: Final = (1.0, 0.05)  # mm, share of the nominal radius; the larger of both
#: No bar is shorter and no feed slower than this (mm, mm/min).
_SMALLEST: Final = 1e-3
_MANY_STEPS: Final = 5.0  # a gap of so many samples is reported
#: Usual arcs are of 90, 180 and 220 deg. A longer one than this may be a circle with a gap: nothing
#: is inferred from the order of the rows.
_LARGEST_USUAL_ARC: Final = 270.0
_RADII: Final = {
    "inch": MILLIMETRES_PER_INCH,
    "um": 1.0 / MICROMETRES_PER_MILLIMETRE,
    "m": 1000.0,
}  # a unit in mm


@dataclass(frozen=True, slots=True, eq=False)
class _Samples:
    """The samples of one run in file order: angles (n,) deg, values (n,) and line numbers."""

    angles: FloatArray
    values: FloatArray
    lines: IntArray


@dataclass(frozen=True, slots=True, kw_only=True)
class _Keys:
    """Axes, radius (mm), feed (mm/min) and centre (mm) in the comment lines; NaN if invalid.

    ``sign``: factor (1, -1) from the file's deviations to measured minus nominal.
    """

    axes: tuple[str, str]
    radius: float
    feed: float
    calibrated: bool | None
    centre: tuple[float, ...] | None
    sign: float


def read_circular_csv(content: bytes, file: str, name: str) -> CircularTest:
    """Return the circular test in a plain CSV file. Raises InputError with every fault at once."""
    faults = FaultList(file)
    text, code_page = read_plain_lines(content, file)
    comment_lines, lines = split_lines(text)
    comments = read_comments(comment_lines, faults, decisive=KEYS)
    _check_form(comments, lines, file)
    keys = _keys(comments, faults)
    table = read_table(lines, faults)
    marks = DecimalMarks(faults)
    value = _value_column(table, faults)
    if value == "radius_mm" and keys.sign < 0.0:
        faults.add(
            "key 'deviation' turns the sign, but the values are radii",
            place=comments.places["deviation"],
            expected="a column deviation_um with this key",
            found="column radius_mm",
            hint="remove the line, or name the column by what its values are",
        )
    samples = _samples(table, value, marks, faults)
    marks.check(comma_is_delimiter=table.delimiter == ",")
    faults.raise_if_any()
    sweeps, runs, arc = _assembled(samples, value, keys, faults)
    left_out = [column for column in table.columns if column not in CIRCULAR_COLUMNS]
    findings = [
        assumed_finding(
            []
            if keys.calibrated is not None
            else ["calibrated: no (the length of the bar is not known)"]
        ),
        code_page,
        left_out_finding(left_out),
        doubtful_finding(marks.doubtful_point()),
        *(finding for sweep in sweeps for finding in _gap_findings(sweep)),
        unfinished_finding(text),
    ]
    return CircularTest(
        name=name,
        plane="".join(keys.axes),
        axes=keys.axes,
        nominal_radius=keys.radius,
        feed=keys.feed,
        arc=arc,
        calibrated=bool(keys.calibrated),
        runs=tuple(runs),
        centre=keys.centre,
        header=comments.header,
        findings=tuple(finding for finding in findings if finding is not None),
    )


def _check_form(comments: Comments, lines: NumberedLines, file: str) -> None:
    form = comments.get("compwright").lower()
    match = _FORM_KEY.fullmatch(form)
    if form and not (match and int(match[1]) <= _NEWEST_FORM):
        newer = "the file was written for a newer version of compwright"
        raise InputError(
            Fault(
                message=newer if match else "the file is not a circular test",
                file=file,
                place=comments.places["compwright"],
                expected=f"# compwright: circular {_NEWEST_FORM}"
                f"{', or a lower number' if match else ''}",
                found=shown(form),
                hint=(
                    "update compwright, or export the test again in this form"
                    if match
                    else "give the file of a circular test; its header has the line "
                    f"`# compwright: circular {_NEWEST_FORM}`"
                ),
            )
        )
    if not lines:
        raise InputError(
            Fault(
                message="the file contains comment lines only",
                file=file,
                expected="a header row and samples",
                hint="add a header row and the samples",
            )
        )


def _keys(comments: Comments, faults: FaultList) -> _Keys:
    calibrated = _YES.get(comments.get("calibrated").lower())
    if comments.get("calibrated") and calibrated is None:
        expected = "yes, no, true or false"
        _note_wrong("calibrated", "has an unknown value", comments, expected, faults)
    return _Keys(
        axes=_axes(comments, faults),
        radius=_positive(comments, "nominal_radius_mm", "150", faults),
        feed=_positive(comments, "feed_mm_min", "1000", faults),
        calibrated=calibrated,
        centre=_centre(comments, faults),
        sign=sign_of(comments, faults) or 1.0,
    )


def _axes(comments: Comments, faults: FaultList) -> tuple[str, str]:
    text = comments.get("plane")
    if not text:
        _note_missing("plane", "XY", faults)
        return "", ""
    axes = axes_of_plane(text)
    if axes is None:
        expected = "first and second axis, such as XY, YZ or ZX"
        _note_wrong("plane", "names no plane", comments, expected, faults)
        return "", ""
    return axes


def axes_of_plane(text: str) -> tuple[str, str] | None:
    """Return the two axes of a plane such as ``XY`` or ``X1-Y1``, or None for another text."""
    match = PLANE.fullmatch(text.strip())
    if match is None or match[1].upper() == match[2].upper():
        return None
    return match[1].upper(), match[2].upper()


def _note_missing(key: str, example: str, faults: FaultList) -> None:
    faults.add(
        f"key '{key}' is missing",
        expected="a comment line with its value",
        hint=f"add the line `# {key}: {example}` above the header row",
    )


def _note_wrong(
    key: str, message: str, comments: Comments, expected: str, faults: FaultList
) -> None:
    faults.add(
        f"key '{key}' {message}",
        place=comments.places[key],
        expected=expected,
        found=shown(comments.get(key)),
        hint=f"correct the line `# {key}: ...`",
    )


def _positive(comments: Comments, key: str, example: str, faults: FaultList) -> float:
    text = comments.get(key)
    if not text:
        _note_missing(key, example, faults)
        return float("nan")
    try:
        value = parse_number(text)
    except ValueError as reason:
        _note_wrong(key, str(reason), comments, "a number above 0", faults)
        return float("nan")
    if value < _SMALLEST:
        _note_wrong(key, "is not positive", comments, "a number above 0", faults)
    return value


def _centre(comments: Comments, faults: FaultList) -> tuple[float, ...] | None:
    text = comments.get("centre")
    if not text:
        return None
    centre = centre_of(text)
    if centre is None:
        expected = "two or three coordinates in mm, such as -400, -250, -300"
        _note_wrong("centre", "is not a position", comments, expected, faults)
    return centre


def centre_of(text: str) -> tuple[float, ...] | None:
    """Return the two or three coordinates (mm) in a text, or None for another text."""
    inner = text.strip().strip("[]()").strip()
    parts = inner.split(";") if ";" in inner else [part.strip(",") for part in inner.split()]
    if len(parts) < 2:
        parts = inner.split(",")
    try:
        numbers = tuple(parse_number(part) for part in parts)
    except ValueError:
        return None
    return numbers if len(numbers) in {2, 3} else None


def _value_column(table: CsvTable, faults: FaultList) -> str:
    """Return the name of the column with the measured values. Raises InputError if the table has no
    such column.
    """
    place = f"line {table.line}"
    found = f"columns {', '.join(table.columns[:8])}"
    for column in ("direction", "angle_deg"):
        if column not in table.columns:
            faults.add(
                f"column '{column}' is missing",
                place=place,
                expected="direction, angle_deg and a value",
                found=found,
                hint=f"name the column with these values `{column}` in the header row",
            )
    values = [column for column in table.columns if column in CIRCULAR_VALUES]
    inches = in_inches(table.columns)
    if inches:
        faults.add(
            "is in inches, which compwright does not read",
            place=place,
            expected=INCHES,
            found=shown(inches),
            hint="export the file again in mm",
        )
    elif not values:
        faults.add(
            "the value column is missing",
            place=place,
            expected=" or ".join(CIRCULAR_VALUES),
            found=found,
            hint="name the column of the values radius_mm or deviation_um in the header row",
        )
    if len(values) > 1:
        faults.add(
            "there is more than one value column",
            place=place,
            expected=" or ".join(CIRCULAR_VALUES),
            found=", ".join(values),
            hint="leave one of these columns out",
        )
    if len(values) != 1 or not {"direction", "angle_deg"} <= set(table.columns):
        faults.raise_if_any()
    return values[0]


def _samples(
    table: CsvTable, value: str, marks: DecimalMarks, faults: FaultList
) -> dict[tuple[Sense, int], _Samples]:
    """Return the samples of each run, by direction (ccw, cw) and run number. ``value``: the name of
    the column with the measured values.
    """
    _check_size(table, faults)
    senses = table.which("direction", _SENSES, str.lower, faults)
    numbered = "run" in table.columns
    runs = (
        counts_of(table.of("run"), table.place("run"), "run", faults)
        if numbered
        else np.ones(len(table.lines), dtype=np.int64)
    )
    angles, values = (
        marks.parse_all(table.of(name), table.lines, table.place(name), name)
        for name in ("angle_deg", value)
    )
    for index in np.flatnonzero(np.abs(angles) > LARGEST_ANGLE).tolist():
        faults.add(
            "is not an angle on the circle",
            place=table.place("angle_deg")(index),
            expected=f"-{LARGEST_ANGLE:g} to {LARGEST_ANGLE:g} deg",
            found=f"{angles[index]:g}",
            hint="write the angle in degrees",
        )
    whole = (senses >= 0) & (runs > 0) & np.isfinite(angles) & np.isfinite(values)
    lines = np.array(table.lines, dtype=np.int64)
    taken = np.flatnonzero(whole)
    taken = taken[np.lexsort((taken, runs[taken], senses[taken]))]
    ends = np.flatnonzero(np.diff(runs[taken]) | np.diff(senses[taken])) + 1
    samples = {
        (_SENSES[senses[ours[0]]], int(runs[ours[0]])): _Samples(
            angles[ours], values[ours], lines[ours]
        )
        for ours in np.split(taken, ends)
        if ours.size
    }
    if not samples and not faults:
        faults.add(
            "contains no samples",
            expected="at least one run below the header",
            hint="add the samples below the header row",
        )
    for (sense, run), of_run in samples.items():
        _check_unique(of_run, f"{sense} run {run}", numbered, faults)
    return samples


def _check_size(table: CsvTable, faults: FaultList) -> None:
    if len(table.lines) > MOST_READINGS:
        faults.add(
            "contains too many samples",
            expected=f"at most {MOST_READINGS} in one test",
            found=str(len(table.lines)),
            hint="give one test per file",
        )
        faults.raise_if_any()


# one caller
def _check_unique(samples: _Samples, name: str, numbered: bool, faults: FaultList) -> None:  # noqa: FBT001
    if np.all(np.diff(np.sort(samples.angles))):
        return
    lines: dict[float, int] = {}
    for angle, line in zip(samples.angles.tolist(), samples.lines.tolist(), strict=True):
        first = lines.setdefault(angle, line)
        if first != line:
            faults.add(
                "a sample is given twice",
                place=f"line {line}",
                expected=(
                    "each angle once per direction and run"
                    if numbered
                    else "a column 'run' if a direction has several runs"
                ),
                found=f"{angle:.10g} deg of {name} also in line {first}",
                hint="remove one of the two, or add a column `run` that counts the runs",
            )


def _assembled(
    samples: Mapping[tuple[Sense, int], _Samples],
    value: str,
    keys: _Keys,
    faults: FaultList,
) -> tuple[list[Sweep], list[CircularRun], tuple[float, float]]:
    """Return the samples sorted by angle, the runs, and their common arc. Raises InputError."""
    sweeps: list[Sweep] = []
    deviations: list[FloatArray] = []
    for (sense, number), ours in sorted(samples.items(), key=lambda item: item[0]):
        sweep = sweep_of(sense, number, ours.angles, faults)
        values = ours.values
        if value == "radius_mm":
            _check_unit(values, keys.radius, f"{sense} run {number}", faults)
            values = values - keys.radius
        else:
            values = keys.sign * values / MICROMETRES_PER_MILLIMETRE
        if sweep is not None:
            sweeps.append(sweep)
            deviations.append(values)
    faults.raise_if_any()
    arc = common_arc(sweeps, faults)
    faults.raise_if_any()
    return (
        sweeps,
        [run_of(sweep, block, arc[0]) for sweep, block in zip(sweeps, deviations, strict=True)],
        arc,
    )


def _check_unit(radii: FloatArray, nominal: float, name: str, faults: FaultList) -> None:
    """Add a fault if the radii differ much from the nominal radius; the fault names a wrong unit
    that would explain the difference.
    """
    middle = float(np.median(radii))
    far = max(_FAR[0], _FAR[1] * nominal)
    if abs(middle - nominal) <= far:
        return
    unit = next(
        (unit for unit, factor in _RADII.items() if abs(middle * factor - nominal) <= far), ""
    )
    hint = (
        f", as it would be in {unit}"
        if unit
        else ", as deviations are"
        if abs(middle) <= _FAR[0]
        else ""
    )
    faults.add(
        "radius_mm is far from the nominal radius",
        place=f"{name}, column radius_mm",
        expected=f"about {nominal:.10g} mm",
        found=f"{middle:.10g}{hint}",
        hint=(
            "correct `# nominal_radius_mm`, or name the column by its unit (radius_mm,"
            " deviation_um)"
        ),
    )


def _gap_findings(sweep: Sweep) -> Iterator[Finding]:
    width, begin = sweep.gap
    if width > _MANY_STEPS * sweep.step:
        yield Finding.of(
            "CW-R034", "warning", run=sweep.name, angle=begin % 360.0, width=width, step=sweep.step
        )
    if sweep.extent > _LARGEST_USUAL_ARC and 360.0 - sweep.extent > _MANY_STEPS * sweep.step:
        yield Finding.of(
            "CW-R034.open",
            "warning",
            run=sweep.name,
            begin=float(sweep.angles[-1]) % 360.0,
            end=float(sweep.angles[0]),
            arc=sweep.extent,
        )
