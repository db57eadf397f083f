"""A table made by somebody else, read by a mapping profile (`profile.Profile`)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import Reading, as_text
from compwright.instruments.csv_table import Row
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.foreign_table import (
    ForeignTable,
    cells_of,
    foreign_table,
    named_columns,
)
from compwright.instruments.foreign_units import ANGLES, LENGTHS
from compwright.instruments.header_words import axis_above, difference_of, said_unit, unit_of
from compwright.instruments.numbers import parse_number
from compwright.instruments.parsed import Parsed
from compwright.instruments.parts import Part, parts_by_axis
from compwright.instruments.profile import Profile
from compwright.instruments.reading_findings import left_out_finding
from compwright.instruments.worked_rows import read_so_finding
from compwright.records.axis import Direction

_COUNT = re.compile(r"[^0-9]*([0-9]{1,9})[^0-9]*")
_LISTED = 5
_LOOKED_AT = 200  # lines of a file that may hold its header row
_SAME_STEP = 1e-4  # mm, deg: rounding of printed positions


@dataclass(frozen=True, slots=True)
class _Row:
    """What one row says: target and deviation in mm or deg, what its direction and run columns
    hold.
    """

    target: float
    deviation: float
    direction: str
    run: str
    line: int


def at_its_header(text: Sequence[str], profile: Profile) -> Profile:
    """Return the profile with the line where its columns stand in this file: files of one program
    differ in how much text stands above.

    As it is where its own line has them, where there is no header row, and where no line or more
    than one has them all.
    """
    wanted = set(_wanted(profile))
    if not profile.header_line or not wanted:
        return profile
    found = [
        number
        for number, line in enumerate(text[:_LOOKED_AT], start=1)
        if wanted <= set(named_columns(cells_of(line, profile.delimiter) or []))
    ]
    if profile.header_line in found or len(found) != 1:
        return profile
    return replace(profile, header_line=found[0])


def has_columns(text: Sequence[str], profile: Profile) -> bool:
    """Whether the columns of a profile are all there in the lines of a file."""
    faults = FaultList("")
    top = text[: profile.header_line] if profile.header_line else text
    table = foreign_table(top, profile.delimiter, profile.header_line, faults)
    return not faults and set(_wanted(profile)) <= set(table.columns)


def read_by_profile(text: Sequence[str], profile: Profile, faults: FaultList) -> Parsed:
    """Return the test in the lines of a file; every fault is noted.

    Rows whose target holds no digit (means, remarks) and columns that the profile does not name are
    left out with a warning; all else that is no number is a fault. Raises InputError where columns
    are missing.
    """
    table = foreign_table(text, profile.delimiter, profile.header_line, faults)
    for name in _wanted(profile):
        if name not in table.columns:
            faults.add(
                "a column of the profile is not in the file",
                place=f"line {profile.header_line}" if profile.header_line else "",
                expected=shown(name),
                found=", ".join(table.columns[:12]) or "no columns",
            )
    axis = axis_above(table.before)
    _refuse_contradictions(table.before, axis, profile, faults)
    faults.raise_if_any()
    cells = _Cells(table, profile, faults)
    unused = [row for row in table.rows if not _has_digit(cells.text(row, profile.target))]
    rows = [row for row in table.rows if _has_digit(cells.text(row, profile.target))]
    if profile.layout == "wide":
        readings = _wide(rows, cells, profile)
    else:
        readings = _long(rows, cells, profile, faults)
    left = [
        name
        for name in table.columns
        if name not in {*_wanted(profile), *profile.leave_out} and cells.filled(name)
    ]
    about = (
        left_out_finding(left),
        _unused(unused, profile),
        read_so_finding(readings, profile.kind, f"the profile {profile.file}"),
    )
    header = {"comment": "\n".join(table.before)} if table.before else {}
    return Parsed(
        kind=profile.kind,
        readings=tuple(readings),
        header={**header, **({"axis": profile.axis or axis} if profile.axis or axis else {})},
        cycle=profile.cycle,
        findings=tuple(finding for finding in about if finding is not None),
    )


def _refuse_contradictions(
    before: Sequence[str], axis: str, profile: Profile, faults: FaultList
) -> None:
    """Note what the text above a table says otherwise than the profile, which may have been made
    for another file.
    """
    named = any(map(unit_of, (profile.value, *profile.traverses)))  # the column says it itself
    unit = "" if named else next(filter(None, map(said_unit, before)), "")
    sign = next(filter(None, map(difference_of, before)), "")
    for what, said, mine in (
        ("axis", axis.upper(), profile.axis.upper()),
        ("unit", unit, profile.unit or ""),
        ("sign", sign, "" if profile.measured else profile.sign or ""),
    ):
        if said and mine and said != mine:
            faults.add(
                f"the text above the table and the profile contradict each other: {what}",
                expected=f"{mine} as in {profile.file}",
                found=said,
            )


def profiled_parts(text: Sequence[str], profile: Profile, faults: FaultList) -> tuple[Part, ...]:
    """Return the parts of a table: one per axis where the profile names a column of axes."""
    if not profile.axis_column or not has_columns(text, profile):
        return (Part(text),)
    table = foreign_table(text, profile.delimiter, profile.header_line, FaultList(""))
    column = table.columns.index(profile.axis_column)
    target = table.columns.index(profile.target)
    rows = [row.line for row in table.rows if _has_digit(row.cells[target])]
    return parts_by_axis(text, profile.delimiter, (profile.header_line, column), rows, faults)


def _wanted(profile: Profile) -> list[str]:
    axis = [profile.axis_column] if profile.axis_column else []
    if profile.layout == "wide":
        return [profile.target, *profile.traverses, *axis]
    direction = profile.direction if profile.direction_from == "column" else ""
    names = (profile.target, profile.value, direction, profile.run, *axis)
    return [name for name in names if name]


def _has_digit(text: str) -> bool:
    return any(character.isdigit() for character in text)


class _Cells:
    """Cells by the name of their column, and as numbers with the decimal mark of the profile."""

    def __init__(self, table: ForeignTable, profile: Profile, faults: FaultList) -> None:
        self.at = {name: index for index, name in enumerate(table.columns)}
        self.rows, self.profile, self.faults = table.rows, profile, faults

    def text(self, row: Row, name: str) -> str:
        return row.cells[self.at[name]] if name else ""

    def filled(self, name: str) -> bool:
        return any(row.cells[self.at[name]] for row in self.rows)

    def number(self, row: Row, name: str) -> float | None:
        text = self.text(row, name)
        place = f"line {row.line}, column {name}"
        other = {".": ",", ",": "."}[self.profile.decimal]
        if other in text and _has_digit(text):
            mark = {".": "point", ",": "comma"}
            self.faults.add(
                f"has a {mark[other]}, and the profile says decimal {mark[self.profile.decimal]}",
                place=place,
                expected="one decimal mark throughout, no thousands marks",
                found=shown(text),
            )
            return None
        try:
            return parse_number(text)
        except ValueError as reason:
            self.faults.add(str(reason), place=place, expected="a number", found=shown(text))
            return None

    def deviation(self, row: Row, name: str, target: float) -> float | None:
        """Return measured minus target in mm or deg of the value in a column; ``target`` in mm or
        deg.
        """
        number = self.number(row, name)
        if number is None:
            return None
        value = number * _factor(self.profile.unit or "")
        if self.profile.measured:
            return value - target
        return -value if self.profile.sign == "target minus measured" else value


def _factor(unit: str) -> float:
    return {**LENGTHS, **ANGLES}[unit]


def _wide(rows: Sequence[Row], cells: _Cells, profile: Profile) -> list[Reading]:
    readings = []
    for row in rows:
        number = cells.number(row, profile.target)
        if number is None:
            continue
        target = number * _factor(profile.target_unit) + 0.0
        for column, (direction, run) in profile.traverses.items():
            if not cells.text(row, column):
                continue
            deviation = cells.deviation(row, column, target)
            if deviation is not None:
                place = f"line {row.line}, column {column}"
                readings.append(Reading(target, direction, run, deviation, place))
    return readings


def _long(rows: Sequence[Row], cells: _Cells, profile: Profile, faults: FaultList) -> list[Reading]:
    taken = []
    by_column = profile.direction_from == "column"
    for row in rows:
        number = cells.number(row, profile.target)
        if number is None or not cells.text(row, profile.value):
            continue  # an empty value is a reading that was not made; `plausibility` counts them
        target = number * _factor(profile.target_unit) + 0.0
        deviation = cells.deviation(row, profile.value, target)
        if deviation is not None:
            direction = cells.text(row, profile.direction if by_column else "")
            run = cells.text(row, profile.run)
            taken.append(_Row(target, deviation, direction, run, row.line))
    _refuse_steps(taken, profile, faults)
    directions = list(_directions(taken, profile, faults))
    if None in directions:
        return []
    told = [direction for direction in directions if direction is not None]
    runs = _runs(taken, told, profile, faults)
    return [
        Reading(row.target, direction, run, row.deviation, f"line {row.line}")
        for row, direction, run in zip(taken, told, runs, strict=True)
        if run is not None
    ]


def _refuse_steps(rows: Sequence[_Row], profile: Profile, faults: FaultList) -> None:
    """Note values that are the distances of the targets: some programs print them beside."""
    steps = [b.target - a.target for a, b in pairwise(rows)]
    if profile.measured or len(steps) < 2 or not any(steps):
        return
    if all(
        abs(abs(row.deviation) - abs(step)) <= _SAME_STEP
        for row, step in zip(rows[1:], steps, strict=True)
    ):
        faults.add(
            "the values are the distances between the targets, not deviations",
            place=f"column {profile.value}",
            expected="the column with deviations or measured positions",
        )


def _directions(
    rows: Sequence[_Row], profile: Profile, faults: FaultList
) -> Iterator[Direction | None]:
    if profile.direction_from in {"+", "-"}:
        yield from [Direction(profile.direction_from)] * len(rows)
        return
    if profile.direction_from == "order":
        yield from _by_order(rows, faults)
        return
    for row in rows:
        direction = profile.directions.get(row.direction.casefold())
        if direction is None:
            faults.add(
                "the direction is none of the words of the profile",
                place=f"line {row.line}, column {profile.direction}",
                expected=", ".join(profile.directions),
                found=shown(row.direction),
            )
        yield direction


def traverses_of(targets: Sequence[float]) -> list[slice]:
    """Return the traverses of targets in the order of time: a new one begins where a target follows
    itself.
    """
    ends = [index for index, (a, b) in enumerate(pairwise(targets), start=1) if a == b]
    return [slice(a, b) for a, b in pairwise([0, *ends, len(targets)])]


def _by_order(rows: Sequence[_Row], faults: FaultList) -> Iterator[Direction | None]:
    """Yield the direction of each row: rising targets are approached from below, falling ones from
    above; the axis turns where a target follows itself.
    """
    targets = [row.target for row in rows]
    for part in traverses_of(targets):
        steps = {int(np.sign(b - a)) for a, b in pairwise(targets[part])}
        if len(steps) != 1:
            faults.add(
                "the order of the rows does not tell the directions",
                place=f"line {rows[part.start].line}" if part.stop > part.start else "",
                expected="targets up and down in turns, the one at each end twice",
                found=f"targets {', '.join(map(as_text, targets[part][:6]))}",
            )
            yield from [None] * (part.stop - part.start)
        else:
            direction = Direction.POSITIVE if steps.pop() > 0 else Direction.NEGATIVE
            yield from [direction] * (part.stop - part.start)


def _runs(
    rows: Sequence[_Row], directions: Sequence[Direction], profile: Profile, faults: FaultList
) -> list[int | None]:
    """Return the run of each row: by its column, or how often its target came in this direction."""
    if not profile.run:
        times: dict[tuple[float, Direction], int] = {}
        counted: list[int | None] = []
        for row, direction in zip(rows, directions, strict=True):
            key = (row.target, direction)
            times[key] = times.get(key, 0) + 1
            counted.append(times[key])
        return counted
    runs: list[int | None] = []
    for row in rows:
        match = _COUNT.fullmatch(row.run)
        number = int(match[1]) if match else 0
        if number < 1:
            faults.add(
                "the run holds not one number of at least 1",
                place=f"line {row.line}, column {profile.run}",
                expected="1, 2, 3, ..",
                found=shown(row.run),
            )
        runs.append(number or None)
    if profile.run_counts == "runs":
        return runs
    ranks = {
        direction: sorted(
            {run for run, one in zip(runs, directions, strict=True) if run and one is direction}
        )
        for direction in Direction
    }
    return [
        ranks[direction].index(run) + 1 if run else None
        for run, direction in zip(runs, directions, strict=True)
    ]


def _unused(rows: Sequence[Row], profile: Profile) -> Finding | None:
    if not rows:
        return None
    told = [f"{row.line} {shown('; '.join(filter(None, row.cells)))}" for row in rows[:_LISTED]]
    more = f" and {len(rows) - _LISTED} more" if len(rows) > _LISTED else ""
    return Finding(
        "CW-R059",
        "warning",
        f"Rows without a number in the column {shown(profile.target)} were left out: line"
        f" {', '.join(told)}{more}.",
    )
