"""The text form ``TGT_DATA[i]=``, ``REF_DATA_FWD[i,j]=``, ``REF_DATA_BWD[i,j]=`` of the ecmc test
tools (ESS, PSI).

One ``KEY=value`` per line, indices from 1: i counts targets, j cycles. The reference values are
absolute readings in the unit of the key ``UNIT`` (mm when it is absent, as the form itself says).
Layout after eleven published files; forward and backward are taken as labelled there: forward is
the approach in positive direction.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise

import numpy as np

from compwright.foundations.units import TO_INSIDE
from compwright.instruments.fault_list import TOLD_PER_KIND, FaultList, shown
from compwright.instruments.numbers import DecimalMarks, parse_count
from compwright.instruments.readings import Readings, readings_at
from compwright.records.axis import AxisKind, Direction

_ASSIGNMENT = re.compile(
    r"\s*(?P<name>[A-Za-z_]\w*)\s*(?:\[(?P<indices>[^\]]*)\]\s*)?=(?P<value>.*)", re.ASCII
)
_DATA = re.compile(r"\s*(?:TGT_DATA|REF_DATA_FWD|REF_DATA_BWD)\s*\[")
_KEYS_OF_FORM = re.compile(
    r"\s*(?:UNIT|CYCLES|POSITIONS|TEST_DATA|REF_PV|TEST_PV|TGT_SET_PV|DEC)\s*="
)
_DIRECTIONS = {"REF_DATA_FWD": Direction.POSITIVE, "REF_DATA_BWD": Direction.NEGATIVE}
_DEGREES = {"degree": "deg", "degrees": "deg", "°": "deg"}


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetData:
    """What the file says: kind, readings in mm or deg (deviations), header keys, and what remains
    to be told. ``alone``: the name of the readings where they are those of one direction; else
    empty.
    """

    kind: AxisKind
    readings: Readings
    header: Mapping[str, str]
    unit_said: bool
    descending: bool
    alone: str


@dataclass(slots=True)
class _Entries:
    """Values by index with the line on which each stands."""

    targets: dict[int, tuple[float, int]] = field(default_factory=dict)
    readings: dict[Direction, dict[tuple[int, int], tuple[float, int]]] = field(
        default_factory=lambda: {direction: {} for direction in Direction}
    )
    keys: dict[str, tuple[str, int]] = field(default_factory=dict)
    #: Indices by how they are written: a million readings have few of them.
    known: dict[str, int] = field(default_factory=dict)

    def index(self, written: str) -> int:
        """Return an index as a number. Raises ValueError where it is none."""
        found = self.known.get(written)
        if found is None:
            found = self.known[written] = parse_count(written)
        return found


def is_target_data(lines: Iterable[str]) -> bool:
    """Whether the lines (comments taken out) are of this form: a line of data, or one of its keys
    first.
    """
    return any(
        _DATA.match(line) or (index == 0 and _KEYS_OF_FORM.match(line))
        for index, line in enumerate(lines)
    )


def read_target_data(lines: Sequence[tuple[int, str]], faults: FaultList) -> TargetData:
    """Return the readings of the lines (comments and blank lines taken out); every fault is noted.

    Faults: a line that is no assignment, wrong indices, an entry given twice, an index that is
    missing or has no target, ``CYCLES`` or ``POSITIONS`` that disagree with the entries, an unknown
    unit.
    """
    entries = _Entries()
    marks = DecimalMarks(faults)
    for number, line in lines:
        match = _ASSIGNMENT.fullmatch(line)
        if match is None:
            faults.add(
                "is not KEY=value",
                place=f"line {number}",
                expected="a line such as TGT_DATA[1]=0.0",
                found=shown(line),
            )
        elif match["name"] == "TGT_DATA" or match["name"] in _DIRECTIONS:
            _take_value(entries, match, number, marks, faults)
        else:
            _take_key(entries, match, number, faults)
    marks.check()
    unit, factor = _unit(entries, faults)
    _check_complete(entries, faults)
    listed = [entries.targets[index][0] for index in sorted(entries.targets)]
    return TargetData(
        kind=AxisKind.LINEAR if unit == "mm" else AxisKind.ROTARY,
        readings=_readings(entries, factor),
        header={key: value for key, (value, _) in entries.keys.items()},
        unit_said="UNIT" in entries.keys,
        alone=_alone(entries),
        descending=len(listed) > 1 and all(later < earlier for earlier, later in pairwise(listed)),
    )


def _alone(entries: _Entries) -> str:
    held = [name for name, direction in _DIRECTIONS.items() if entries.readings[direction]]
    return held[0] if len(held) == 1 else ""


def _readings(entries: _Entries, factor: float) -> Readings:
    """Return the readings that have a target, in mm or deg by ``factor``."""
    wanted = {index: value for index, (value, _) in entries.targets.items()}
    parts = []
    for direction in Direction:
        block = entries.readings[direction]
        columns = np.array(
            [
                np.fromiter((wanted.get(i, np.nan) for i, _ in block), np.float64, len(block)),
                np.fromiter((value for value, _ in block.values()), np.float64, len(block)),
                np.fromiter((j for _, j in block), np.float64, len(block)),
                np.fromiter((line for _, line in block.values()), np.float64, len(block)),
                np.full(len(block), float(direction is Direction.POSITIVE)),
            ]
        )
        there = np.fromiter((i in wanted for i, _ in block), np.bool_, len(block))
        parts.append(columns[:, there])
    targets, values, runs, lines, positive = np.concatenate(parts, axis=1)
    deviations = (values - targets) * factor
    return readings_at(lines, targets * factor, positive, runs, deviations)


def _take_value(
    entries: _Entries, match: re.Match[str], line: int, marks: DecimalMarks, faults: FaultList
) -> None:
    name, written = match["name"], match["indices"]
    label = f"{name}[{(written or '').strip()}]"
    wanted = 1 if name == "TGT_DATA" else 2
    try:
        indices = tuple(map(entries.index, (written or "").split(",")))
    except ValueError:
        indices = ()
    if len(indices) != wanted:
        shape = "[target]" if wanted == 1 else "[target,cycle]"
        faults.add(
            "has wrong indices",
            place=f"line {line}",
            expected=f"{name}{shape}, counted from 1",
            found=shown(label),
        )
        return
    value = marks.parse(match["value"], place=f"line {line}, {label}", column=name)
    if value is None:
        value = float("nan")  # the entry is there, only unreadable: not to be told as missing too
    if len(indices) == 1:
        first = entries.targets.setdefault(indices[0], (value, line))[1]
    else:
        first = entries.readings[_DIRECTIONS[name]].setdefault(
            (indices[0], indices[1]), (value, line)
        )[1]
    if first != line:
        faults.add(
            "is given twice",
            place=f"line {line}, {label}",
            expected="each index once",
            found=f"the first in line {first}",
        )


def _take_key(entries: _Entries, match: re.Match[str], line: int, faults: FaultList) -> None:
    key = match["name"] if match["indices"] is None else f"{match['name']}[{match['indices']}]"
    first = entries.keys.setdefault(key, (match["value"].strip(), line))[1]
    if first != line:
        faults.add(
            "is given twice",
            place=f"line {line}, {key}",
            expected="each key once",
            found=f"the first in line {first}",
        )


def _unit(entries: _Entries, faults: FaultList) -> tuple[str, float]:
    if "UNIT" not in entries.keys:
        return TO_INSIDE["mm"]
    text, line = entries.keys["UNIT"]
    lower = text.lower()
    known = TO_INSIDE.get(text) or TO_INSIDE.get(_DEGREES.get(lower, lower))
    if known is None:
        faults.add(
            "names an unknown unit",
            place=f"line {line}, UNIT",
            expected="mm, um, deg or arcsec",
            found=shown(text),
        )
        return TO_INSIDE["mm"]
    return known


def _check_complete(entries: _Entries, faults: FaultList) -> None:
    """Note counts that disagree with the entries, and entries that the counts of targets and cycles
    demand but are not there.
    """
    taken = [index for block in entries.readings.values() for index in block]
    positions = max(entries.targets, default=0)
    cycles = max((j for _, j in taken), default=0)
    if not taken:
        faults.add(
            "holds no readings",
            expected="lines REF_DATA_FWD[target,cycle]= or REF_DATA_BWD[target,cycle]=",
        )
    _check_count(entries, "POSITIONS", positions, "the highest index of TGT_DATA", faults)
    if taken:
        _check_count(entries, "CYCLES", cycles, "the highest cycle of the readings", faults)
    _note_missing(
        [f"TGT_DATA[{i}]" for i in _first_missing(entries.targets, positions)],
        positions - len(entries.targets),
        faults,
    )
    for name, direction in _DIRECTIONS.items():
        block = entries.readings[direction]
        for (i, j), (_, line) in block.items():
            if i > positions:
                faults.add(
                    "has no target",
                    place=f"line {line}, {name}[{i},{j}]",
                    expected=f"an index up to {positions}" if positions else "lines TGT_DATA[i]=",
                )
        inside = {index for index in block if index[0] <= positions}
        if block:
            grid = (
                (i, j)
                for j in range(1, cycles + 1)
                for i in range(1, positions + 1)
                if (i, j) not in inside
            )
            count = positions * cycles - len(inside)
            _note_missing(
                [f"{name}[{i},{j}]" for i, j in islice(grid, TOLD_PER_KIND)] if count else [],
                count,
                faults,
            )


def _first_missing(present: Mapping[int, object], highest: int) -> Iterator[int]:
    return islice((index for index in range(1, highest + 1) if index not in present), TOLD_PER_KIND)


def _note_missing(names: Sequence[str], count: int, faults: FaultList) -> None:
    if names:
        more = f" and {count - len(names)} more" if count > len(names) else ""
        faults.add("entries are missing", expected=f"{', '.join(names)}{more}")


def _check_count(entries: _Entries, key: str, found: int, what: str, faults: FaultList) -> None:
    if key not in entries.keys:
        return
    text, line = entries.keys[key]
    try:
        count = parse_count(text)
    except ValueError as reason:
        faults.add(f"{reason}", place=f"line {line}, {key}", expected="a count", found=shown(text))
        return
    if count != found:
        faults.add(
            "disagrees with the entries",
            place=f"line {line}, {key}",
            expected=f"{found}, {what}",
            found=str(count),
        )
