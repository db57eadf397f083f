"""Reader of the text files ``.pos`` of API lasers: mean deviations of a test, in mm.

Each block has a title line, such as ``Position <tab> Forward Directional Avg Error``, and rows of
position and mean deviation (measured minus target). The file does not contain the readings. Source:
one reader of a third party; no real file was available.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.answers import Answers
from compwright.instruments.assembling import as_text
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.foreign_units import LENGTHS
from compwright.instruments.numbers import DecimalMarks
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.reading_findings import cut_finding, falling_finding, stray_finding
from compwright.instruments.readings import readings_at
from compwright.instruments.sections import (
    check_units,
    header_of,
    no_end_finding,
    opens_section,
    sections_of,
    spans_in,
    with_axis,
)
from compwright.instruments.sections import spans_of as spans_of_sections
from compwright.instruments.spans import Spans, TextSpan
from compwright.instruments.worked_rows import read_so_finding
from compwright.records.axis import AxisKind, Direction
from compwright.words.sentences import SentenceText, say

_TITLE = re.compile(
    r"\s*Position\s+(?P<which>Bidirectional|Forward|Reverse|Backward)(?:\s+Directional)?"
    r"\s+Avg\.?\s+Error\s*(?P<rest>.*)",
    re.IGNORECASE,
)
_BOTH, _FORWARD, _BACK = "both", "forward", "back"
_WHICH = {"bidirectional": _BOTH, "forward": _FORWARD, "reverse": _BACK, "backward": _BACK}
_ROW = re.compile(r"[+-]?[0-9.,]\S*(?:\s+\S+)*")
#: A row where no rows are: position and mean deviation.
_MEAN = re.compile(r"[+-]?[0-9]+(?:[.,][0-9]+)?\s+[+-]?[0-9]+[.,][0-9]+")
_ENVIRONMENT: Final = "ENVIRONMENT"

#: Means by position as written, with the line of each, in the order of the file.
_Block = dict[float, tuple[float, int]]


def is_mean_blocks(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a ``.pos`` file with blocks of means."""
    return any("Avg" in line and _TITLE.fullmatch(line) for line in text)


def spans_of(text: Sequence[str]) -> Iterator[Spans]:
    """Yield the parts of each line, each with its meaning: ``key``, ``row`` or ``remark``."""
    block = False
    for line, found in zip(text, spans_of_sections(text), strict=True):
        title = _TITLE.fullmatch(line)
        block = (block or title is not None) and not opens_section(line)
        if title is not None:
            rest = title.start("rest")
            yield TextSpan(0, rest, "key"), TextSpan(rest, len(line), "remark")
        else:
            yield spans_in(line, rows=True) if block else found


def read_mean_blocks(text: Sequence[str], faults: FaultList, answers: Answers) -> Parsed:
    """Return the means in the lines of a file as one run per direction.

    If the file has no means of the way back, they are calculated: twice the means of both
    directions minus the means of the way out. Every fault is added to ``faults``. Faults: the file
    has only the means of both directions; blocks have different positions; means contradict each
    other by more than the printed digits.
    """
    sections = sections_of(text, faults)
    check_units(sections, ["HEADER", "TARGET DATA"], faults)
    marks = DecimalMarks(faults)
    blocks, decimals = _blocks(text, marks, faults)
    marks.check()
    faults.raise_if_any()
    out, back, computed = _both_ways(blocks, 0.5 * 10.0**-decimals, faults)
    faults.raise_if_any()
    unit = answers.unit or "mm"
    if unit not in LENGTHS:
        faults.add(
            "is a file of lengths",
            expected=" or ".join(LENGTHS),
            found=unit,
            hint="correct `unit` in the profile",
        )
        faults.raise_if_any()
    factor = LENGTHS[unit] * (-1.0 if answers.sign == "target minus measured" else 1.0)
    listed = list(out)
    rising = len(listed) < 2 or listed[-1] > listed[0]
    directions = (Direction.POSITIVE, Direction.NEGATIVE)[:: 1 if rising else -1]
    rows = [
        (line, position, direction is Direction.POSITIVE, value)
        for direction, block in zip(directions, (out, back), strict=True)
        for position, (value, line) in block.items()
    ]
    lines, positions, positive, values = zip(*rows, strict=True)
    readings = readings_at(
        lines, positions, positive, [1] * len(rows), np.array(values, dtype=np.float64) * factor
    )
    header = header_of(sections, ["HEADER", "USER-TEXT", "EQUIPMENT"])
    assumed = [] if answers.unit else [SentenceText(say("reading.unit_mm"))]
    assumed += [] if answers.sign else [SentenceText(say("reading.deviation"))]
    assumed.append(SentenceText(say("reading.forward", direction=directions[0])))
    worked = read_so_finding(readings, AxisKind.LINEAR)
    findings = [
        _means_only(computed=computed),
        *_not_in_order(listed),
        worked,
        _cut(sections.lines),
        stray_finding(_above(text)),
    ]
    return Parsed(
        kind=AxisKind.LINEAR,
        readings=readings,
        header=with_axis(header, sections.value("USER-TEXT", "Axis")[0]),
        assumed=tuple(assumed),
        findings=tuple(
            finding
            for finding in (*findings, no_end_finding(sections) if sections.ended else None)
            if finding is not None
        ),
    )


def _blocks(
    text: Sequence[str], marks: DecimalMarks, faults: FaultList
) -> tuple[Mapping[str, _Block], int]:
    """Return the blocks of means (forward, backward, both), and their number of decimals."""
    blocks: dict[str, _Block] = {}
    current: _Block | None = None
    decimals = 0
    for number, line in enumerate(text, start=1):
        title = _TITLE.fullmatch(line)
        if title is not None:
            which = _WHICH[title["which"].lower()]
            if which in blocks:
                faults.add(
                    "a block is given twice",
                    place=f"line {number}",
                    found=shown(line),
                    hint="remove one of the two blocks",
                )
            current = blocks[which] = {}
        elif blocks and line.strip():
            if not _ROW.fullmatch(line.strip()):
                current = None  # the next section, or a title of another analysis
                continue
            if current is None:
                faults.add(
                    "is not below the title of a block of means",
                    place=f"line {number}",
                    expected="rows directly below 'Position  Forward Directional Avg Error'",
                    found=shown(line),
                    hint="remove this row, or export the file again",
                )
                continue
            row = _row(number, line, marks, faults)
            if row is not None and row[0] in current:
                faults.add(
                    "a position is given twice",
                    place=f"line {number}",
                    found=shown(line),
                    hint="remove one of the two rows",
                )
            elif row is not None:
                current[row[0]] = (row[1], number)
                decimals = max(decimals, row[2])
    return blocks, decimals


def _above(text: Sequence[str]) -> list[tuple[int, str]]:
    """Return the lines above the first block of means that look as if they belonged to a block: a
    position with its mean.
    """
    found: list[tuple[int, str]] = []
    listing = False
    for number, line in enumerate(text, start=1):
        if _TITLE.fullmatch(line):
            break
        if ":" in line:
            listing = line.strip().lower().startswith("target")
        elif not listing and _MEAN.fullmatch(line.strip()):
            found.append((number, line.strip()))
    return found


def _row(
    number: int, line: str, marks: DecimalMarks, faults: FaultList
) -> tuple[float, float, int] | None:
    cells = line.split()
    if len(cells) != 2:
        faults.add(
            "is not a row of position and mean deviation",
            place=f"line {number}",
            expected="two numbers",
            found=shown(line),
        )
        return None
    position = marks.parse(cells[0], place=f"line {number}", column="position")
    value = marks.parse(cells[1], place=f"line {number}", column="mean deviation")
    if position is None or value is None:
        return None
    return position, value, len(cells[1].replace(",", ".").partition(".")[2])


def _both_ways(
    blocks: Mapping[str, _Block], half_digit: float, faults: FaultList
) -> tuple[_Block, _Block, bool]:
    """Return the forward means, the backward means, and whether the backward means were computed
    (from the forward means and the means of both directions) because the file lacks them.
    ``half_digit``: half of the last digit of the means.
    """
    both, out, back = (blocks.get(which) for which in (_BOTH, _FORWARD, _BACK))
    given = [block for block in (both, out, back) if block is not None]
    if not any(given):
        faults.add("contains no means", expected="rows of position and mean deviation")
        return {}, {}, False
    if any(set(block) != set(given[0]) for block in given):
        faults.add(
            "the blocks of means have different positions; the file may have been cut off",
            expected="the same positions in each",
            found=", ".join(f"{len(block)} rows" for block in given),
            hint="export the file again",
        )
        return {}, {}, False
    if out is None:
        faults.add(
            "contains no means of the forward direction, so the directions cannot be separated",
            expected="a block 'Forward Directional Avg Error'",
            hint="export the file again with the block 'Forward Directional Avg Error'",
        )
        return {}, {}, False
    if both is None:
        return out, back or {}, False
    if back is None:
        computed = {
            position: (2.0 * both[position][0] - value, line)
            for position, (value, line) in out.items()
        }
        return out, computed, True
    for position, (value, line) in both.items():
        if abs(out[position][0] + back[position][0] - 2.0 * value) > 4.0001 * half_digit:
            faults.add(
                "is not the mean of the two directions",
                place=f"line {line}",
                expected=as_text((out[position][0] + back[position][0]) / 2.0),
                found=as_text(value),
                hint="export the file again",
            )
    return out, back, False


def _means_only(*, computed: bool) -> Finding:
    return Finding.of("CW-R057", "warning", way_back=computed)


def _not_in_order(listed: Sequence[float]) -> list[Finding]:
    if {int(np.sign(b - a)) for a, b in pairwise(listed)} <= {1}:
        return []
    return [
        falling_finding(say("CW-R014.forward")),
    ]


def _cut(sections: Mapping[str, object]) -> Finding | None:
    if _ENVIRONMENT in sections:
        return None
    return cut_finding(say("CW-R053.environment"))
