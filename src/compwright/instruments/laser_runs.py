"""Reader of laser software's text files ``.rtl`` (linear) and ``.rta`` (angular).

A file states its number of targets, the targets in mm or deg, ``Flags``, and the number of runs, in
which each traverse counts as a run. Each row has run and target (both from 1) and the deviation
(measured minus target), in µm for linear axes and in µrad for angular ones. Layout, units and sign
are those of six independent readers and writers; no real file was available.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import ARCSECONDS_PER_DEGREE
from compwright.instruments.answers import Answers
from compwright.instruments.assembling import as_text
from compwright.instruments.csv_table import GatheredRows
from compwright.instruments.fault_list import FaultList, by_profile, shown
from compwright.instruments.foreign_units import ANGLES, LENGTHS
from compwright.instruments.mean_blocks import is_mean_blocks
from compwright.instruments.numbers import DecimalMarks, parse_count
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.reading_findings import (
    cut_finding,
    falling_finding,
    stray_finding,
)
from compwright.instruments.readings import IntArray, Readings, readings_at
from compwright.instruments.sections import (
    FileSections,
    Line,
    check_units,
    has_section,
    header_of,
    no_end_finding,
    sections_of,
    with_axis,
)
from compwright.instruments.worked_rows import read_so_finding
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.words.sentences import SentenceText, say

_TARGETS, _RUNS, _ROWS = "TARGET DATA", "RUNS", "DEVIATIONS"
_ROW_HEADER = re.compile(r"run\s+target\s+data\s*:?", re.IGNORECASE)
#: Run and target of a row, counted from 1.
_INDICES = re.compile(r"(?![0-9]{10})0*[1-9][0-9]* (?![0-9]{10})0*[1-9][0-9]*")
#: A row where no rows are: run, target and a deviation.
_READING = re.compile(r"[0-9]+\s+[0-9]+\s+[+-]?[0-9]+(?:[.,][0-9]+)?")
_KINDS = {"rtl": AxisKind.LINEAR, "rta": AxisKind.ROTARY}
#: Other files of the family: what they hold, for the message that refuses them.
_OTHER_KINDS = {
    "rts": "straightness",
    "rtx": "dynamic data",
    "rtq": "squareness",
    "rtf": "flatness",
}
#: The only version of which the layout was seen.
_KNOWN_VERSION = "V20"
#: Flags that a writer of this form puts for a test in one direction; a hint, not a proof.
_ONE_WAY = ["0", "1", "2", "0"]
_UNIT = {AxisKind.LINEAR: "um", AxisKind.ROTARY: "urad"}
#: Largest deviation of an angular file, in µrad (about 1 arcsec), below which the numbers are
#: rather in mrad: one of the known programs takes them so.
_LEAST_MICRORADIAN = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class _RunRows:
    """The rows of one run: target ``indices`` (n,) from 1, ``values`` (n,) and line numbers."""

    indices: IntArray
    values: FloatArray
    lines: IntArray


@dataclass(slots=True)
class _Runs:
    """The rows of a file by run number."""

    rows: dict[int, _RunRows]
    targets: list[float]
    promised: int | None

    def order(self, run: int) -> int:
        """Return +1 if the targets of a run rise, -1 if they fall, 0 otherwise."""
        steps = np.unique(np.sign(np.diff(self.rows[run].indices))).tolist()
        return int(steps[0]) if len(steps) == 1 else 0

    def zero(self, run: int) -> bool:
        """Return whether every deviation of a run is exactly zero."""
        return not np.any(self.rows[run].values)


def is_laser_runs(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a ``.rtl`` or ``.rta`` positioning test."""
    return has_section(text, [_ROWS, _RUNS]) or (
        has_section(text, ["HEADER", _TARGETS]) and not is_mean_blocks(text)
    )


def read_laser_runs(text: Sequence[str], faults: FaultList, answers: Answers) -> Parsed:
    """Return the test in the lines of a file. Every fault is added to ``faults``.

    Faults: the file is of another type, counts disagree with the contents, a row is invalid or
    names a run or target that does not exist, or the order of the targets does not show the
    directions. Raises InputError if nothing can be read without guessing.
    """
    sections = sections_of(text, faults)
    kind = _kind(sections, faults)
    check_units(sections, ["HEADER", _TARGETS, _RUNS], faults)
    marks = DecimalMarks(faults)
    runs = _Runs(
        rows=_rows(sections, marks, faults),
        targets=_targets(sections, marks),
        promised=_count(sections, _RUNS, "Run-count", faults),
    )
    marks.check()
    _check_counts(sections, runs, faults)
    faults.raise_if_any()
    directions, assumed, findings = _directions(sections, runs, faults)
    faults.raise_if_any()
    factor, unit_words, unit_finding = _unit(kind, runs, answers, faults)
    faults.raise_if_any()
    sign = -1.0 if answers.sign == "target minus measured" else 1.0
    readings = _readings(runs, directions, factor * sign)
    header = header_of(sections, ["HEADER", "USER-TEXT", "EQUIPMENT", "ENVIRONMENT"])
    signs = () if answers.sign else (SentenceText(say("reading.deviation")),)
    worked = read_so_finding(readings, kind)
    stray = stray_finding(_stray(sections))
    about = (no_end_finding(sections), _fewer_runs(runs), stray, unit_finding, *findings, worked)
    return Parsed(
        kind=kind,
        readings=readings,
        header=with_axis(header, sections.value("USER-TEXT", "Axis")[0]),
        assumed=(*unit_words, *signs, *assumed, *_other_version(sections)),
        findings=tuple(finding for finding in about if finding is not None),
    )


def _readings(
    runs: _Runs, directions: Mapping[int, tuple[Direction, int]], factor: float
) -> Readings:
    """Return the readings of the runs with a known direction. ``factor``: to mm or deg."""
    used = [(rows, *directions[run]) for run, rows in runs.rows.items() if run in directions]
    sizes = [rows.lines.size for rows, _, _ in used]
    indices = np.concatenate([rows.indices for rows, _, _ in used])
    values = np.concatenate([rows.values for rows, _, _ in used])
    return readings_at(
        np.concatenate([rows.lines for rows, _, _ in used]),
        np.array(runs.targets)[indices - 1],
        np.repeat([direction is Direction.POSITIVE for _, direction, _ in used], sizes),
        np.repeat([number for _, _, number in used], sizes),
        values * factor,
    )


def place(line: int | np.int64) -> str:
    """Return the place of a line as faults name it: ``line 12``."""
    return f"line {line}"


def _kind(sections: FileSections, faults: FaultList) -> AxisKind:
    written, where = sections.value("HEADER", "File type")
    name = written.strip().lower().lstrip(".")
    if name not in _KINDS:
        holds = _OTHER_KINDS.get(name)
        faults.add(
            f"the file contains {holds}, not positions"
            if holds
            else "the type of the file is unknown",
            place=where,
            expected="File type: rtl (linear) or rta (angular)",
            found=shown(written) if written else "no line 'File type' below HEADER::",
            hint="give a positioning test (.rtl or .rta)",
        )
        faults.raise_if_any()
    return _KINDS[name]


def _targets(sections: FileSections, marks: DecimalMarks) -> list[float]:
    """Return the targets in the file's order: the numbers between ``Targets :`` and the next
    key.
    """
    targets: list[float] = []
    inside = False
    for number, text in sections.lines.get(_TARGETS, ()):
        key = re.match(r"([A-Za-z][\w -]*?)\s*:", text)
        if key is not None:
            inside = key[1].lower() == "targets"
        if not inside:
            continue
        for cell in text[key.end() if key else 0 :].split():
            value = marks.parse(cell, place=f"line {number}, Targets", column="targets")
            if value is not None:
                targets.append(value)
    return targets


def _rows(sections: FileSections, marks: DecimalMarks, faults: FaultList) -> dict[int, _RunRows]:
    """Return the rows of each run, in ascending order of the runs."""
    table = GatheredRows(3)
    for number, text in sections.lines.get(_ROWS, ()):
        cells = text.split()
        if len(cells) == 3 and _INDICES.fullmatch(f"{cells[0]} {cells[1]}"):
            table.add(number, cells)
        elif not _ROW_HEADER.fullmatch(text):
            faults.add(
                "is not a row of run, target and deviation",
                place=place(number),
                expected="such as '1  1  0.3'",
                found=shown(text),
            )
    lines = np.array(table.lines, dtype=np.int64)
    runs, indices, written = table.columns()
    values = marks.parse_all(written, lines, lambda index: place(lines[index]), "deviations")
    found = np.flatnonzero(np.isfinite(values))
    numbers = np.fromiter(map(int, runs), np.int64, lines.size)[found]
    targets = np.fromiter(map(int, indices), np.int64, lines.size)
    order = np.argsort(numbers, kind="stable")
    ends = np.flatnonzero(np.diff(numbers[order])) + 1
    return {
        int(runs[ours[0]]): _RunRows(targets[ours], values[ours], lines[ours])
        for ours in np.split(found[order], ends)
        if ours.size
    }


def _stray(sections: FileSections) -> list[Line]:
    """Return lines that look like readings but are outside the readings and the list of targets."""
    found: list[Line] = []
    for name in sections.lines.keys() - {_ROWS}:
        listing = False
        for number, text in sections.lines[name]:
            if name == _TARGETS and ":" in text:
                listing = text.lower().startswith("targets")
            elif not listing and _READING.fullmatch(text):
                found.append((number, text))
    return sorted(found)


def _count(sections: FileSections, section: str, key: str, faults: FaultList) -> int | None:
    written, where = sections.value(section, key)
    if not where:
        return None
    try:
        return parse_count(written)
    except ValueError as reason:
        faults.add(str(reason), place=where, expected="a count", found=shown(written))
        return None


def _check_counts(sections: FileSections, runs: _Runs, faults: FaultList) -> None:
    promised = _count(sections, _TARGETS, "Target-count", faults)
    if not runs.targets:
        faults.add(
            "contains no targets",
            expected="numbers below 'Targets :' in TARGET DATA::",
            hint="export the file again",
        )
    elif promised is not None and promised != len(runs.targets):
        faults.add(
            "contains fewer or more targets than it states",
            place=sections.value(_TARGETS, "Target-count")[1],
            expected=f"{promised} numbers below 'Targets :'",
            found=f"{len(runs.targets)}",
            hint="export the file again",
        )
    if not runs.rows:
        faults.add(
            "contains no readings",
            expected="rows below 'Run Target Data:' in DEVIATIONS::",
            hint="make the measurement, then export the file again",
        )
    for run, rows in runs.rows.items():
        beyond = rows.indices > len(runs.targets) if runs.targets else rows.indices < 0
        for index, line in zip(rows.indices[beyond], rows.lines[beyond], strict=True):
            faults.add(
                "names an unknown target",
                place=place(line),
                expected=f"1 to {len(runs.targets)}",
                found=str(index),
                hint="export the file again",
            )
        for line in rows.lines if runs.promised is not None and run > runs.promised else ():
            faults.add(
                "names an unknown run",
                place=place(line),
                expected=f"1 to {runs.promised} (Run-count)",
                found=str(run),
                hint="export the file again",
            )


def _directions(
    sections: FileSections, runs: _Runs, faults: FaultList
) -> tuple[Mapping[int, tuple[Direction, int]], tuple[str, ...], list[Finding]]:
    """Return the direction and the run number of each traverse, the assumptions made for that as
    text, and the findings.

    By default odd traverses go from the first target to the last, and even traverses go back. The
    file can show otherwise, in this order: if all even traverses contain only zeros, there was no
    way back; if the rows of an even traverse are in falling order, it went back; the flags may
    state a single direction.
    """
    steps = {int(np.sign(b - a)) for a, b in pairwise(runs.targets)}
    if len(steps) > 1 or 0 in steps:
        faults.add(
            "the targets are in no order, so the direction of each approach is unknown",
            place=sections.value(_TARGETS, "Target-count")[1],
            expected="targets from low to high or from high to low",
            hint="export the readings as plain CSV with a column `direction`",
        )
        return {}, (), []
    rising = steps != {-1}
    out, back = (Direction.POSITIVE, Direction.NEGATIVE)[:: 1 if rising else -1]
    odd = [run for run in runs.rows if run % 2]
    even = [run for run in runs.rows if not run % 2]
    one_way = sections.value(_TARGETS, "Flags")[0].split() == _ONE_WAY
    findings: list[Finding] = []
    if even and all(map(runs.zero, even)) and not all(map(runs.zero, odd)):
        findings.append(Finding.of("CW-R054", "warning", runs=even[:6], more=len(even) > 6))
        even = []
    if any(runs.order(run) < 0 for run in odd) or (
        one_way and any(runs.order(run) < 0 for run in even)
    ):
        wrong = next(run for run in (*odd, *even) if runs.order(run) < 0)
        faults.add(
            "the order of the rows contradicts the direction of the run",
            place=place(runs.rows[wrong].lines[0]),
            expected=(
                "rows from the first target to the last in odd runs, and in all runs of a test"
                " in one direction (Flags: 0 1 2 0)"
            ),
            found=f"run {wrong} from the last target to the first",
            hint="export the readings as plain CSV with a column `direction`",
        )
    if one_way:
        numbered = {run: (out, n) for n, run in enumerate(sorted([*odd, *even]), start=1)}
        words = f"all {len(numbered)} runs: approaches in direction {out} (Flags: 0 1 2 0)"
    else:
        numbered = {run: (out, (run + 1) // 2) for run in odd}
        numbered |= {run: (back, run // 2) for run in even}
        words = f"run 1, 3, ..: {_traverses(odd)}, approaches in direction {out}"
        if even:
            words += f"; run 2, 4, ..: {_traverses(even)}, approaches in direction {back}"
            if not any(runs.order(run) < 0 for run in even) and len(runs.targets) > 1:
                findings.append(Finding.of("CW-R055", "warning", back=back, run=even[0]))
    if not rising:
        findings.append(falling_finding(say("CW-R014.odd_runs", direction=out)))
    return numbered, (words,), findings


def _other_version(sections: FileSections) -> list[str]:
    """Return a list with one text, the assumption that the file has the known layout although it
    states another version; the list is empty if it states the known version or none.
    """
    version = sections.value("HEADER", "Version no")[0]
    if version.startswith(_KNOWN_VERSION) or not version:
        return []
    return [f"layout: that of {_KNOWN_VERSION} (the file says version {version})"]


def _traverses(runs: Sequence[int]) -> str:
    return f"{len(runs)} traverse{'' if len(runs) == 1 else 's'}"


def _fewer_runs(runs: _Runs) -> Finding | None:
    """Return the finding that the file has fewer runs than its header states, else None."""
    last = max(runs.rows)
    if runs.promised is None or last >= runs.promised:
        return None
    return cut_finding(say("CW-R053.run_count", promised=runs.promised, found=last))


def _unit(
    kind: AxisKind, runs: _Runs, answers: Answers, faults: FaultList
) -> tuple[float, tuple[str, ...], Finding | None]:
    """Return the factor from the file's unit to mm or deg, the unit as text if it is assumed, and a
    finding if the assumption is doubtful.
    """
    units = LENGTHS if kind is AxisKind.LINEAR else ANGLES
    if answers.unit is not None:
        if answers.unit not in units:
            faults.add(
                "unit and type of file contradict each other",
                place="unit",
                expected=" or ".join(units),
                found=answers.unit,
                hint="correct `unit` in the profile",
            )
        return units.get(answers.unit, 1.0), (), None
    factor = units[_UNIT[kind]]
    if kind is AxisKind.LINEAR:
        return factor, ("unit: um",), None
    largest = max(float(np.max(np.abs(rows.values))) for rows in runs.rows.values())
    if 0.0 < largest < _LEAST_MICRORADIAN:
        faults.add(
            "the file does not state the unit of its angles, and its numbers may be too small for"
            " microradian",
            expected="a stated unit",
            found=f"no deviation larger than {as_text(largest)}",
            hint=(
                "compare one number with the instrument's report, then state `unit: urad` or"
                f" `unit: mrad` in a profile: {by_profile(faults.file)}"
            ),
        )
    arcsec = as_text(round(largest * factor * ARCSECONDS_PER_DEGREE, 4))
    return (
        factor,
        ("unit: urad",),
        Finding.of("CW-R056", "warning", largest=as_text(largest), arcsec=arcsec),
    )
