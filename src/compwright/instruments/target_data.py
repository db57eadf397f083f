"""Reader of text files with lines ``TGT_DATA[i]=value`` of the ecmc test tools (ESS, PSI).

The readings are in lines ``REF_DATA_FWD[i,j]=`` and ``REF_DATA_BWD[i,j]=``. There is one
``KEY=value`` per line. The indices start at 1: i counts targets, j counts cycles. The reference
values are absolute readings in the unit of the key ``UNIT`` (mm if the key is absent, as the form
itself states).

The layout is that of eleven published files. FWD (forward) is the approach in positive direction,
as these files label it.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise
from typing import Final

import numpy as np

from compwright.foundations.units import TO_INSIDE
from compwright.instruments.comments import comment_text
from compwright.instruments.fault_list import SHOWN_PER_KIND, FaultList, shown
from compwright.instruments.numbers import DecimalMarks, parse_count
from compwright.instruments.readings import IntArray, Readings, readings_at
from compwright.instruments.spans import Spans, TextSpan, by_key, whole
from compwright.records.axis import AxisKind, Direction, FloatArray

_TARGET, _FORWARD, _BACKWARD = "TGT_DATA", "REF_DATA_FWD", "REF_DATA_BWD"
#: How lines of data begin: of a million lines hardly any other has to be looked at twice.
_BEGINNINGS: Final = (f"{_TARGET}[", f"{_FORWARD}[", f"{_BACKWARD}[")
_ASSIGNMENT = re.compile(
    r"\s*(?P<name>[A-Za-z_]\w*)\s*(?:\[(?P<indices>[^\]]*)\]\s*)?=(?P<value>.*)", re.ASCII
)
#: The keys of the form, with what their values are.
KEYS: Final = by_key(
    {
        "row": (_TARGET, _FORWARD, _BACKWARD),
        "keywords": ("UNIT",),
        "numbers": ("CYCLES", "POSITIONS", "DEC"),
        "name": ("TEST_DATA", "REF_PV", "TEST_PV", "TGT_SET_PV"),
    }
)
_DATA = re.compile(rf"\s*(?:{_TARGET}|{_FORWARD}|{_BACKWARD})\s*\[")
_OTHERS = "|".join(name for name, meaning in KEYS.items() if meaning != "row")
_KEYS_OF_FORM = re.compile(rf"\s*(?:{_OTHERS})\s*=")
_DIRECTIONS = {_FORWARD: Direction.POSITIVE, _BACKWARD: Direction.NEGATIVE}
_DEGREES = {"degree": "deg", "degrees": "deg", "°": "deg"}


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetData:
    """The contents of a target data file: kind of axis, readings (mm or deg) and header.

    ``alone``: if the file has readings of one direction only, their name (``REF_DATA_FWD`` or
    ``REF_DATA_BWD``); else empty.
    """

    kind: AxisKind
    readings: Readings
    header: Mapping[str, str]
    unit_stated: bool
    descending: bool
    alone: str


@dataclass(slots=True)
class _TargetColumn:
    """The entries ``NAME[i,j]=value`` with one ``NAME``, in the order of the file, with their line
    numbers.

    If an entry has only one index, its ``j`` is 0.
    """

    i: array[int] = field(default_factory=lambda: array("q"))
    j: array[int] = field(default_factory=lambda: array("q"))
    texts: list[str] = field(default_factory=list)
    lines: array[int] = field(default_factory=lambda: array("q"))


@dataclass(frozen=True, slots=True)
class _Entries:
    """The entries ``NAME[i,j]=value`` with one ``NAME`` as arrays (n,), sorted by index; NaN for an
    unreadable value.
    """

    i: IntArray
    j: IntArray
    values: FloatArray
    lines: IntArray


@dataclass(slots=True)
class _Found:
    """The entries of a target data file by name, and its other keys with their lines."""

    columns: dict[str, _TargetColumn] = field(
        default_factory=lambda: {name: _TargetColumn() for name in (_TARGET, *_DIRECTIONS)}
    )
    keys: dict[str, tuple[str, int]] = field(default_factory=dict)
    #: Indices by how they are written: a million readings have few of them.
    known: dict[str, int] = field(default_factory=dict)

    def index(self, written: str) -> int:
        """Return the index in square brackets as a number. Raises ValueError for other text."""
        found = self.known.get(written)
        if found is None:
            found = self.known[written] = parse_count(written)
        return found


def split_target_data(
    text: Sequence[str],
) -> tuple[list[tuple[int, str]], Iterator[tuple[int, str]]]:
    """Return comment lines (without ``#``) and other non-blank lines, with line numbers from 1."""
    comments = [
        (number, comment)
        for number, line in enumerate(text, start=1)
        if not line.startswith(_BEGINNINGS) and (comment := comment_text(line)) is not None
    ]
    taken = {number for number, _ in comments}
    lines = (
        (number, line)
        for number, line in enumerate(text, start=1)
        if line.startswith(_BEGINNINGS) or (number not in taken and line.strip(" \t,;"))
    )
    return comments, lines


def is_target_data(lines: Iterable[str]) -> bool:
    """Return whether the lines (without comments) are a target data file."""
    return any(
        _DATA.match(line) or (index == 0 and _KEYS_OF_FORM.match(line))
        for index, line in enumerate(lines)
    )


def spans_in(line: str) -> Spans:
    """Return the parts of a line that is not a comment, each with its meaning."""
    match = _ASSIGNMENT.fullmatch(line)
    if match is None:
        return whole(line, "remark")
    value, (begin, end) = match.start("value"), match.span("indices")
    meaning = KEYS.get(match["name"])
    if meaning is None:
        return (
            TextSpan(match.start("name"), value - 1, "name"),
            TextSpan(value, len(line), "remark"),
        )
    indices = (TextSpan(begin, end, meaning),) if begin >= 0 else ()
    return TextSpan(*match.span("name"), "key"), *indices, TextSpan(value, len(line), meaning)


def read_target_data(lines: Iterable[tuple[int, str]], faults: FaultList) -> TargetData:
    """Return the readings in the lines (without comments and blank lines). Every fault is added to
    ``faults``.

    Faults: a line is not an assignment, an index is wrong or missing or has no target, an entry is
    given twice, ``CYCLES`` or ``POSITIONS`` disagrees with the entries, or the unit is unknown.
    """
    found = _found(lines, faults)
    marks = DecimalMarks(faults)
    entries = {
        name: _entries(name, column, marks, faults) for name, column in found.columns.items()
    }
    marks.check()
    unit, factor = _unit(found.keys, faults)
    _check_complete(entries, found.keys, faults)
    listed = entries[_TARGET].values.tolist()
    held = [name for name in _DIRECTIONS if entries[name].i.size]
    return TargetData(
        kind=AxisKind.LINEAR if unit == "mm" else AxisKind.ROTARY,
        readings=_readings(entries, factor),
        header={key: value for key, (value, _) in found.keys.items()},
        unit_stated="UNIT" in found.keys,
        alone=held[0] if len(held) == 1 else "",
        descending=len(listed) > 1 and all(later < earlier for earlier, later in pairwise(listed)),
    )


def _found(lines: Iterable[tuple[int, str]], faults: FaultList) -> _Found:
    found = _Found()
    for number, line in lines:
        match = _ASSIGNMENT.fullmatch(line)
        if match is None:
            faults.add(
                "is not KEY=value",
                place=f"line {number}",
                expected="a line such as TGT_DATA[1]=0.0",
                found=shown(line),
                hint="write KEY=value, or remove this line",
            )
            continue
        column = found.columns.get(match["name"])
        if column is None:
            _take_key(found, match, number, faults)
        else:
            _take_entry(found, column, match, number, faults)
    return found


def _take_entry(
    found: _Found, column: _TargetColumn, match: re.Match[str], line: int, faults: FaultList
) -> None:
    name = match["name"]
    count = 1 if name == _TARGET else 2
    try:
        indices = [found.index(written) for written in (match["indices"] or "").split(",")]
    except ValueError:
        indices = []
    if len(indices) != count:
        faults.add(
            "has wrong indices",
            place=f"line {line}",
            expected=f"{name}{'[target]' if count == 1 else '[target,cycle]'}, counted from 1",
            found=shown(f"{name}[{(match['indices'] or '').strip()}]"),
            hint="number the entries from 1",
        )
        return
    column.i.append(indices[0])
    column.j.append(indices[1] if count == 2 else 0)
    column.texts.append(match["value"])
    column.lines.append(line)


def _entries(name: str, column: _TargetColumn, marks: DecimalMarks, faults: FaultList) -> _Entries:
    """Return the numbers of a column. For repeated indices the first one counts."""
    i, j, lines = (np.array(each, dtype=np.int64) for each in (column.i, column.j, column.lines))

    def label(at: int) -> str:
        return f"{name}[{i[at]}]" if name == _TARGET else f"{name}[{i[at]},{j[at]}]"

    def place(at: int) -> str:
        return f"line {lines[at]}, {label(at)}"

    values = marks.parse_all(column.texts, lines, place, name)
    # Indices have nine digits at most: two of them fit into one number.
    _, kept, same = np.unique(i * 1_000_000_000 + j, return_index=True, return_inverse=True)
    for at in np.setdiff1d(np.arange(i.size), kept).tolist():
        faults.add(
            "is given twice",
            place=place(at),
            expected="each index once",
            found=f"the first in line {lines[kept[same[at]]]}",
        )
    return _Entries(i[kept], j[kept], values[kept], lines[kept])


def _readings(entries: Mapping[str, _Entries], factor: float) -> Readings:
    """Return the readings that have a target, converted to mm or deg by ``factor``."""
    wanted = entries[_TARGET]
    parts = []
    for name, direction in _DIRECTIONS.items():
        block = entries[name]
        there = np.isin(block.i, wanted.i)
        targets = wanted.values[np.searchsorted(wanted.i, block.i[there])]
        positive = np.full(targets.size, direction is Direction.POSITIVE)
        parts.append(
            (block.lines[there], targets, positive, block.j[there], block.values[there] - targets)
        )
    lines, targets, positive, runs, deviations = (
        np.concatenate(each) for each in zip(*parts, strict=True)
    )
    order = np.argsort(lines, kind="stable")
    return readings_at(
        lines[order],
        targets[order] * factor,
        positive[order],
        runs[order],
        deviations[order] * factor,
    )


def _take_key(found: _Found, match: re.Match[str], line: int, faults: FaultList) -> None:
    key = match["name"] if match["indices"] is None else f"{match['name']}[{match['indices']}]"
    first = found.keys.setdefault(key, (match["value"].strip(), line))[1]
    if first != line:
        faults.add(
            "is given twice",
            place=f"line {line}, {key}",
            expected="each key once",
            found=f"the first in line {first}",
        )


def _unit(keys: Mapping[str, tuple[str, int]], faults: FaultList) -> tuple[str, float]:
    if "UNIT" not in keys:
        return TO_INSIDE["mm"]
    text, line = keys["UNIT"]
    lower = text.lower()
    known = TO_INSIDE.get(text) or TO_INSIDE.get(_DEGREES.get(lower, lower))
    if known is None:
        faults.add(
            "names an unknown unit",
            place=f"line {line}, UNIT",
            expected="mm, um, deg or arcsec",
            found=shown(text),
            hint="write mm, um, deg or arcsec",
        )
        return TO_INSIDE["mm"]
    return known


def _check_complete(
    entries: Mapping[str, _Entries], keys: Mapping[str, tuple[str, int]], faults: FaultList
) -> None:
    """Add faults for missing entries, and for stated counts that differ from the entries."""
    targets = entries[_TARGET].i
    positions = int(targets.max(initial=0))
    cycles = max(int(entries[name].j.max(initial=0)) for name in _DIRECTIONS)
    if not cycles:
        faults.add(
            "contains no readings",
            expected="lines REF_DATA_FWD[target,cycle]= or REF_DATA_BWD[target,cycle]=",
            hint="make the measurement, then export the file again",
        )
    _check_count(keys, "POSITIONS", positions, "the highest index of TGT_DATA", faults)
    if cycles:
        _check_count(keys, "CYCLES", cycles, "the highest cycle of the readings", faults)
    held = set(targets.tolist())
    missing = (f"TGT_DATA[{i}]" for i in range(1, positions + 1) if i not in held)
    _note_missing(missing, positions - targets.size, faults)
    for name in _DIRECTIONS:
        _check_block(name, entries[name], positions, cycles, faults)


def _check_block(
    name: str, block: _Entries, positions: int, cycles: int, faults: FaultList
) -> None:
    """Add faults for readings of a block of entries: one for each reading whose target is missing,
    and one for all targets without a reading in one of the ``cycles``. ``positions``: the number of
    targets.
    """
    inside = block.i <= positions
    for at in np.flatnonzero(~inside):
        faults.add(
            "is a reading at a target that the file does not contain",
            place=f"line {block.lines[at]}, {name}[{block.i[at]},{block.j[at]}]",
            expected=f"a target index up to {positions}" if positions else "lines TGT_DATA[i]=",
            hint="add the entry TGT_DATA of this target, or export the file again",
        )
    count = positions * cycles - int(inside.sum())
    if block.i.size and count:
        held = set(zip(block.i.tolist(), block.j.tolist(), strict=True))
        grid = (
            f"{name}[{i},{j}]"
            for j in range(1, cycles + 1)
            for i in range(1, positions + 1)
            if (i, j) not in held
        )
        _note_missing(grid, count, faults)


def _note_missing(names: Iterable[str], count: int, faults: FaultList) -> None:
    if count:
        listed = list(islice(names, SHOWN_PER_KIND))
        more = f" and {count - len(listed)} more" if count > len(listed) else ""
        faults.add(
            "entries are missing",
            expected=f"{', '.join(listed)}{more}",
            hint="export the whole test again",
        )


def _check_count(
    keys: Mapping[str, tuple[str, int]], key: str, found: int, what: str, faults: FaultList
) -> None:
    if key not in keys:
        return
    text, line = keys[key]
    try:
        count = parse_count(text)
    except ValueError as reason:
        faults.add(f"{reason}", place=f"line {line}, {key}", expected="a count", found=shown(text))
        return
    if count != found:
        faults.add(
            f"is not {what}",
            place=f"line {line}, {key}",
            expected=str(found),
            found=str(count),
            hint="export the whole test again",
        )
