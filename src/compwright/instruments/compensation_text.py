"""Reader of ``.ren`` files, in which laser software exports an error compensation table as text.

``Sign convention`` states whether the values are errors (measured minus target) or corrections. The
user of that software chooses it, so it is never assumed. Values and positions are in mm. Source:
two readers of third parties and one record of a real table; no real file was available.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.input_sizes import MOST_TARGETS
from compwright.instruments.answers import Answers
from compwright.instruments.assembling import as_text
from compwright.instruments.fault_list import FaultList, by_profile, shown
from compwright.instruments.foreign_units import LENGTHS
from compwright.instruments.numbers import DecimalMarks, parse_number
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.reading_findings import stray_finding
from compwright.instruments.readings import readings_at
from compwright.instruments.sections import Line
from compwright.instruments.spans import Spans, TextSpan, by_key, whole
from compwright.instruments.worked_rows import read_so_finding
from compwright.records.axis import AxisKind, Direction
from compwright.words.sentences import SentenceText, say

#: The keys, with what their values are.
KEYS: Final = by_key(
    {
        "quantity": (
            *("compensation start", "compensation end", "compensation spacing"),
            *("compensation output", "compensation type", "compensation resolution"),
            *("reference position", "backlash error", "sign convention", "table type"),
        ),
        "title": ("test name",),
    }
)
_KEY = re.compile(rf"\s*(?P<key>{'|'.join(KEYS)})\b\s*[:=]?\s*(?P<value>.*?)\s*", re.IGNORECASE)
_OUTPUT = "compensation output"
_SIGNS = {"as errors": 1.0, "errors": 1.0, "as corrections": -1.0, "corrections": -1.0}
_NONE = frozenset({"", "n/a", "na", "none", "-"})
_COLUMNS = {"no.": "no", "no": "no", "target no": "no", "target no.": "no", "point": "no"} | {
    name: name for name in ("axis position", "combined", "forward", "reverse")
}
_NUMBER_WITH_UNIT = re.compile(r"(?P<number>[+-]?[0-9.,]+(?:[eE][+-]?[0-9]+)?)\s*(?P<unit>\S*)")
#: A row of the table: number, position, one value or more.
_ROW = re.compile(r"[0-9]+(?:[\s;]+[+-]?[0-9][0-9.,]*(?:[eE][+-]?[0-9]+)?){2,}")
#: Positions printed and computed from start and spacing are the same within this, mm.
_SAME = 1e-3
#: A value and its nearest multiple of the resolution are the same within this share of it.
_MULTIPLE = 1e-3


@dataclass(slots=True)
class _Text:
    keys: dict[str, tuple[str, int]] = field(default_factory=dict)
    columns: tuple[str, ...] = ()
    rows: list[Line] = field(default_factory=list)
    other: list[Line] = field(default_factory=list)

    def get(self, key: str) -> str:
        return self.keys.get(key, ("", 0))[0]

    def place(self, key: str) -> str:
        return f"line {self.keys[key][1]}, {key}" if key in self.keys else ""


def is_compensation_text(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a ``.ren`` error compensation table."""
    keys = (_KEY.fullmatch(line) for line in text if "compensation" in line.lower())
    found = {match["key"].lower() for match in keys if match is not None}
    return len(found & {"compensation start", "compensation end", "compensation spacing"}) >= 2


def spans_of(text: Sequence[str]) -> Iterator[Spans]:
    """Yield the parts of each line, each with its meaning: ``key``, ``row`` or ``remark``."""
    rows = False
    for line in text:
        match = _KEY.fullmatch(line)
        if match is not None:
            key = match["key"].lower()
            rows = rows or key == _OUTPUT
            yield (
                TextSpan(*match.span("key"), "key"),
                TextSpan(match.start("value"), len(line), KEYS[key]),
            )
        elif _header(line.strip()):
            rows = True
            yield whole(line, "key")
        else:
            yield whole(line, "row" if rows else "remark")


def read_compensation_text(text: Sequence[str], faults: FaultList, answers: Answers) -> Parsed:
    """Return the table of a ``.ren`` file as deviations, with one run per direction.

    Every fault is added to ``faults``. Faults: the sign is not stated; the values are not absolute;
    one table has a backlash, whose direction is unknown; the values may be counts of the
    resolution; the number of rows differs from start, end and spacing; the positions disagree with
    start, end and spacing.
    """
    found = _text(text)
    marks = DecimalMarks(faults)
    sign = _sign(found, answers, faults)
    if found.get("compensation type").lower() not in {"", "absolute"}:
        faults.add(
            "contains values of an unknown type",
            place=found.place("compensation type"),
            expected="Absolute",
            found=shown(found.get("compensation type")),
            hint="export the table as absolute values, or give the file of the test (.rtl)",
        )
    columns = _columns(found, _grid(found, marks, faults), marks, faults)
    factor = _unit(found, columns, answers, faults)
    _check_directions(found, columns, marks, faults)
    marks.check()
    faults.raise_if_any()
    if "combined" in columns and "forward" not in columns:
        columns = {"forward": columns["combined"], "reverse": columns["combined"]}
    pairs = ((Direction.POSITIVE, "forward"), (Direction.NEGATIVE, "reverse"))
    rows = [
        (line, position, direction is Direction.POSITIVE, value)
        for direction, name in pairs
        for position, value, line in columns[name]
    ]
    lines, positions, positive, values = zip(*rows, strict=True) if rows else ((), (), (), ())
    deviations = np.array(values, dtype=np.float64) * factor * sign
    readings = readings_at(lines, positions, positive, [1] * len(rows), deviations)
    stray = stray_finding([line for line in found.other if _ROW.fullmatch(line[1])])
    header = {key: value for key, (value, _) in found.keys.items() if value}
    if found.other:
        header["comment"] = "\n".join(line for _, line in found.other)
    return Parsed(
        kind=AxisKind.LINEAR,
        readings=readings,
        header=header,
        assumed=(
            SentenceText(say("reading.forward", direction="+")),
            *(() if answers.unit else (SentenceText(say("reading.unit_mm")),)),
        ),
        findings=(
            Finding.of("CW-R058", "warning", sign=found.get("sign convention")),
            *filter(None, [stray, read_so_finding(readings, AxisKind.LINEAR)]),
        ),
    )


def _text(text: Sequence[str]) -> _Text:
    found = _Text()
    inside = False
    for number, raw in enumerate(text, start=1):
        line = raw.strip()
        if not line:
            continue
        match = _KEY.fullmatch(line)
        columns = _header(line)
        if columns:
            found.columns, inside = columns, True
        elif match is not None and not inside:
            found.keys.setdefault(match["key"].lower(), (match["value"], number))
            inside = match["key"].lower() == _OUTPUT and not match["value"]
        elif inside:
            found.rows.append((number, line))
        else:
            found.other.append((number, line))
    return found


def _header(line: str) -> tuple[str, ...]:
    """Return the column names if the line is the table's header row, else an empty tuple."""
    names = [_COLUMNS.get(cell.lower(), "") for cell in re.split(r"\s{2,}|\t|;", line) if cell]
    return tuple(names) if "axis position" in names and "" not in names else ()


def _sign(found: _Text, answers: Answers, faults: FaultList) -> float:
    """Return 1 or -1, the factor from the table's values to measured minus target."""
    written = found.get("sign convention").lower()
    if written in _SIGNS:
        return _SIGNS[written]
    if not written and answers.sign is not None:
        return 1.0 if answers.sign == "measured minus target" else -1.0
    faults.add(
        (
            "the file does not state whether its values are errors or corrections"
            if not written
            else "the sign convention is unknown"
        ),
        place=found.place("sign convention"),
        expected="a line 'Sign convention' with 'As errors' or 'As corrections'",
        found=shown(found.get("sign convention")) if written else "",
        hint=f"state the sign in a profile: {by_profile(faults.file)}",
    )
    return 1.0


def _length(
    found: _Text, key: str, marks: DecimalMarks, faults: FaultList, *, needed: bool = True
) -> float | None:
    written = found.get(key)
    if not written or written.lower() in _NONE:
        if needed:
            faults.add(
                f"'{key.capitalize()}' is missing",
                expected="a length in mm",
                hint="export the table again with this line",
            )
        return None
    match = _NUMBER_WITH_UNIT.fullmatch(written)
    if match is None or match["unit"].lower() not in {"", "mm"}:
        faults.add(
            "is not a length in mm",
            place=found.place(key),
            expected="mm",
            found=shown(written),
            hint="export the table in mm",
        )
        return None
    return marks.parse(match["number"], place=found.place(key), column=key)


def _grid(found: _Text, marks: DecimalMarks, faults: FaultList) -> list[float]:
    """Return the positions of the table's points (mm), from the stated start, end and spacing."""
    start, end, spacing = (
        _length(found, f"compensation {what}", marks, faults)
        for what in ("start", "end", "spacing")
    )
    if start is None or end is None or spacing is None:
        return []
    steps = (end - start) / spacing if spacing else -1.0
    if not 0 <= steps <= MOST_TARGETS or abs(steps - round(steps)) * abs(spacing) > _SAME:
        faults.add(
            "start, end and spacing do not fit together",
            place=found.place("compensation spacing"),
            expected="an end that is a whole number of spacings beyond the start",
            found=f"{as_text(start)}, {as_text(end)} and {as_text(spacing)} mm",
            hint="export the table again",
        )
        return []
    return [start + index * spacing for index in range(round(steps) + 1)]


def _columns(
    found: _Text, grid: Sequence[float], marks: DecimalMarks, faults: FaultList
) -> dict[str, list[tuple[float, float, int]]]:
    """Return, for each column of the table (combined, forward, reverse), its points: position,
    value and line number.
    """
    names = found.columns or ("combined",)
    columns: dict[str, list[tuple[float, float, int]]] = {
        name: [] for name in names if name in {"combined", "forward", "reverse"}
    }
    if grid and len(found.rows) != len(grid):
        faults.add(
            "has fewer or more rows than its start, end and spacing state; the file may have"
            " been cut off",
            expected=str(len(grid)),
            found=str(len(found.rows)),
            hint="export the table again",
        )
    for index, (number, line) in enumerate(found.rows):
        cells = line.split()
        if len(cells) != len(names):
            faults.add(
                "is not a row of the table",
                place=f"line {number}",
                expected=f"{len(names)} numbers",
                found=shown(line),
            )
            continue
        values = {
            name: marks.parse(cell, place=f"line {number}", column=name)
            for name, cell in zip(names, cells, strict=True)
            if name != "no"
        }
        position = values.get("axis position", grid[index] if index < len(grid) else None)
        if position is None:
            continue
        if index < len(grid) and abs(position - grid[index]) > _SAME:
            faults.add(
                "is not at the position that start and spacing give",
                place=f"line {number}",
                expected=as_text(grid[index]),
                found=as_text(position),
            )
        for name, column in columns.items():
            value = values[name]
            if value is not None:
                column.append((position, value, number))
    return columns


def _unit(
    found: _Text,
    columns: dict[str, list[tuple[float, float, int]]],
    answers: Answers,
    faults: FaultList,
) -> float:
    """Return the factor from the table's values to mm. The values of some tables are counts of a
    resolution.
    """
    if answers.unit is not None:
        if answers.unit not in LENGTHS:
            faults.add(
                "is a table of lengths",
                expected=" or ".join(LENGTHS),
                found=answers.unit,
                hint="correct `unit` in the profile",
            )
        return LENGTHS.get(answers.unit, 1.0)
    match = _NUMBER_WITH_UNIT.fullmatch(found.get("compensation resolution"))
    of_one = match is not None and _is_one(match["number"])
    values = [value for column in columns.values() for _, value, _ in column]
    whole = all(abs(value - round(value)) <= _MULTIPLE for value in values) and any(values)
    if whole and not of_one:
        faults.add(
            "the values are whole numbers, so they may be mm, or counts of the compensation"
            " resolution",
            place=found.place("compensation resolution"),
            expected="a stated unit of the values",
            found=shown(found.get("compensation resolution")),
            hint=f"state the unit of the values in a profile: {by_profile(faults.file)}",
        )
    return 1.0


def _is_one(text: str) -> bool:
    try:
        return parse_number(text) == 1.0
    except ValueError:
        return False


def _check_directions(
    found: _Text, columns: Iterable[str], marks: DecimalMarks, faults: FaultList
) -> None:
    if {"forward", "reverse"} <= set(columns):
        return
    backlash = _length(found, "backlash error", marks, faults, needed=False)
    if "combined" not in columns or backlash != 0.0:
        faults.add(
            "contains one table for both directions; how its backlash is split between them is"
            " unknown",
            place=found.place("backlash error"),
            expected="columns Forward and Reverse, or a backlash error of 0",
            found=shown(found.get("backlash error")),
            hint=(
                "give the file of the test (.rtl), or export the table with columns Forward and"
                " Reverse"
            ),
        )
