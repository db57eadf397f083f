"""Read a table of another program with a mapping profile (`profile.Profile`)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import as_text
from compwright.instruments.csv_table import rows_as_comments
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.foreign_table import (
    ForeignTable,
    cells_of,
    foreign_table,
    named_columns,
)
from compwright.instruments.foreign_units import ANGLES, LENGTHS
from compwright.instruments.header_words import axis_above, difference_of, stated_unit, unit_of
from compwright.instruments.numbers import parse_number, plain_numbers
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.parts import TestPart, parts_by_axis
from compwright.instruments.profile import Profile
from compwright.instruments.reading_findings import (
    left_out_finding,
    stray_finding,
    unread_finding,
)
from compwright.instruments.readings import Readings, readings_at
from compwright.instruments.worked_rows import read_so_finding
from compwright.records.axis import Direction, FloatArray

_NUMBER = re.compile(r"[+-]?[0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?")
_COUNT = re.compile(r"[^0-9]*([0-9]{1,9})[^0-9]*")
_LISTED = 5
_LOOKED_AT = 200  # lines of a file that may hold its header row
_SAME_STEP = 1e-4  # mm, deg: rounding of printed positions


@dataclass(frozen=True, slots=True, eq=False)
class _ProfiledRows:
    """The contents of rows: targets and deviations (n,) in mm or deg, directions, runs, lines."""

    targets: FloatArray
    deviations: FloatArray
    directions: Sequence[str]
    runs: Sequence[str]
    lines: Sequence[int]


def at_its_header(text: Sequence[str], profile: Profile) -> Profile:
    """Return the profile with the number of the header line in this file, because the header can be
    on another line than in the profile.

    The profile stays unchanged if its own line has all columns, if there is no header row, or if
    not exactly one line has all columns.
    """
    wanted = set(columns_of(profile))
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
    """Return whether the lines of a file contain all columns of a profile."""
    faults = FaultList("")
    top = text[: profile.header_line] if profile.header_line else text
    table = foreign_table(top, profile.delimiter, profile.header_line, faults)
    return not faults and set(columns_of(profile)) <= set(table.columns)


def read_by_profile(text: Sequence[str], profile: Profile, faults: FaultList) -> Parsed:
    """Return the test in the lines of a file. Every fault is added to ``faults``.

    Two things are left out with a warning: rows whose target contains no digit (means, remarks),
    and columns that the profile does not name. Any other cell that is not a number is a fault.
    Raises InputError if columns are missing.
    """
    table = foreign_table(text, profile.delimiter, profile.header_line, faults)
    for name in columns_of(profile):
        if name not in table.columns:
            faults.add(
                "a column of the profile is not in the file",
                place=f"line {profile.header_line}" if profile.header_line else "",
                expected=shown(name),
                found=", ".join(table.columns[:12]) or "no columns",
                hint="write one of these names into the profile",
            )
    axis = axis_above(table.before)
    _refuse_contradictions(table.before, axis, profile, faults)
    faults.raise_if_any()
    cells = _Cells(table, profile, faults)
    numbered = list(map(_has_digit, table.of(profile.target)))
    unused = [row for row, used in enumerate(numbered) if not used]
    rows = [row for row, used in enumerate(numbered) if used]
    if profile.layout == "wide":
        readings, targets = _wide(rows, cells, profile)
    else:
        readings, targets = _long(rows, cells, profile, faults)
    left = [
        name
        for name in table.columns
        if name not in {*columns_of(profile), *profile.leave_out} and cells.filled(name)
    ]
    about = (
        left_out_finding(left),
        unread_finding(targets, readings, profile.kind),
        stray_finding([*_above(text, table, profile), *_hidden(text, table, profile)]),
        _unused(unused, table, profile),
        read_so_finding(readings, profile.kind, f"the profile {profile.file}"),
    )
    header = {"comment": "\n".join(table.before)} if table.before else {}
    return Parsed(
        kind=profile.kind,
        readings=readings,
        header={**header, **({"axis": profile.axis or axis} if profile.axis or axis else {})},
        cycle=profile.cycle,
        findings=tuple(finding for finding in about if finding is not None),
    )


def _refuse_contradictions(
    before: Sequence[str], axis: str, profile: Profile, faults: FaultList
) -> None:
    """Add a fault if the lines ``before`` a table contradict the profile, such as by another axis,
    unit or sign.
    """
    named = any(map(unit_of, (profile.value, *profile.traverses)))  # the column says it itself
    unit = "" if named else next(filter(None, map(stated_unit, before)), "")
    sign = next(filter(None, map(difference_of, before)), "")
    for what, stated, mine in (
        ("axis", axis.upper(), profile.axis.upper()),
        ("unit", unit, profile.unit or ""),
        ("sign", sign, "" if profile.measured else profile.sign or ""),
    ):
        if stated and mine and stated != mine:
            faults.add(
                f"the text above the table and the profile state different values of `{what}`",
                expected=f"{mine} as in {profile.file}",
                found=stated,
                hint=f"correct `{what}` in the profile, or the text in the file",
            )


def profiled_parts(
    text: Sequence[str], profile: Profile, faults: FaultList
) -> tuple[TestPart, ...]:
    """Return the lines of each axis if the profile names a column of axes, else all lines as one
    part.
    """
    if not profile.axis_column or not has_columns(text, profile):
        return (TestPart(text),)
    table = foreign_table(text, profile.delimiter, profile.header_line, FaultList(""))
    column = table.columns.index(profile.axis_column)
    targets = zip(table.lines, table.of(profile.target), strict=True)
    rows = [line for line, target in targets if _has_digit(target)]
    return parts_by_axis(text, profile.delimiter, (profile.header_line, column), rows, faults)


def columns_of(profile: Profile) -> list[str]:
    """Return the names of the columns that a profile uses."""
    axis = [profile.axis_column] if profile.axis_column else []
    if profile.layout == "wide":
        return [profile.target, *profile.traverses, *axis]
    direction = profile.direction if profile.direction_from == "column" else ""
    names = (profile.target, profile.value, direction, profile.run, *axis)
    return [name for name in names if name]


def _has_digit(text: str) -> bool:
    return any(map(str.isdigit, text))


class _Cells:
    """Cells by column name, as text and as numbers with the profile's decimal mark."""

    def __init__(self, table: ForeignTable, profile: Profile, faults: FaultList) -> None:
        self.table, self.profile, self.faults = table, profile, faults

    def text(self, rows: Sequence[int], name: str) -> list[str]:
        """Return the cells of the column ``name`` in the given rows; empty texts if the profile
        names no such column.
        """
        if not name:
            return [""] * len(rows)
        cells = self.table.of(name)
        return [cells[row] for row in rows]

    def filled(self, name: str) -> bool:
        return any(self.table.of(name))

    def numbers(self, rows: Sequence[int], name: str) -> FloatArray:
        """Return the numbers (n,) of a column in the given rows, NaN for an invalid cell."""
        texts = self.text(rows, name)
        plain = plain_numbers(texts, self.profile.decimal)
        if plain is not None:
            return plain
        found = (self._number(row, name, text) for row, text in zip(rows, texts, strict=True))
        return np.fromiter(found, np.float64, len(texts))

    def _number(self, row: int, name: str, text: str) -> float:
        place = f"line {self.table.lines[row]}, column '{name}'"
        other = {".": ",", ",": "."}[self.profile.decimal]
        if other in text and _has_digit(text):
            mark = {".": "point", ",": "comma"}
            self.faults.add(
                f"has a {mark[other]}, and the profile says decimal {mark[self.profile.decimal]}",
                place=place,
                expected="one decimal mark throughout, no thousands marks",
                found=shown(text),
                hint="correct `decimal` in the profile",
            )
            return np.nan
        try:
            return parse_number(text)
        except ValueError as reason:
            self.faults.add(str(reason), place=place, expected="a number", found=shown(text))
            return np.nan

    def targets(self, rows: Sequence[int]) -> FloatArray:
        """Return the targets (n,) in the given rows, in mm or deg."""
        return self.numbers(rows, self.profile.target) * _factor(self.profile.target_unit) + 0.0

    def deviations(self, rows: Sequence[int], name: str, targets: FloatArray) -> FloatArray:
        """Return the deviations (n,), measured minus target, in mm or deg, of the given rows."""
        values = self.numbers(rows, name) * _factor(self.profile.unit or "")
        if self.profile.measured:
            return values - targets
        return -values if self.profile.sign == "target minus measured" else values


def _factor(unit: str) -> float:
    return {**LENGTHS, **ANGLES}[unit]


def _wide(rows: Sequence[int], cells: _Cells, profile: Profile) -> tuple[Readings, FloatArray]:
    """Return the readings and the targets of all rows of a table with one column per traverse."""
    targets = cells.targets(rows)
    lines = np.array([cells.table.lines[row] for row in rows], dtype=np.int64)
    names = list(profile.traverses)
    blocks = []
    for column, name in enumerate(names):
        texts = cells.text(rows, name)
        made = np.array([bool(text) for text in texts], dtype=np.bool_) & np.isfinite(targets)
        here = np.flatnonzero(made)
        used = [rows[index] for index in here.tolist()]
        values = cells.deviations(used, name, targets[here])
        blocks.append((here, np.full(here.size, column), values))
    at, columns, deviations = (np.concatenate(parts) for parts in zip(*blocks, strict=True))
    order = np.lexsort((columns, at))  # row by row, as in the file
    order = order[np.isfinite(deviations[order])]
    at, columns, deviations = at[order], columns[order], deviations[order]
    ways = list(profile.traverses.values())
    readings = Readings(
        targets[at],
        np.array([way is Direction.POSITIVE for way, _ in ways], dtype=np.bool_)[columns],
        np.array([run for _, run in ways], dtype=np.int64)[columns],
        deviations,
        lambda index: f"line {lines[at[index]]}, column '{names[columns[index]]}'",
    )
    return readings, targets


def _long(
    rows: Sequence[int], cells: _Cells, profile: Profile, faults: FaultList
) -> tuple[Readings, FloatArray]:
    """Return the readings and the targets of all rows of a table with one row per reading."""
    targets = of_rows = cells.targets(rows)
    values = cells.text(rows, profile.value)
    # an empty value is a reading that was not made; `plausibility` counts them
    made = np.array([bool(text) for text in values], dtype=np.bool_) & np.isfinite(targets)
    rows, targets = [rows[index] for index in np.flatnonzero(made).tolist()], targets[made]
    deviations = cells.deviations(rows, profile.value, targets)
    whole = np.isfinite(deviations)
    rows = [rows[index] for index in np.flatnonzero(whole).tolist()]
    by_column = profile.direction_from == "column"
    taken = _ProfiledRows(
        targets[whole],
        deviations[whole],
        cells.text(rows, profile.direction if by_column else ""),
        cells.text(rows, profile.run),
        [cells.table.lines[row] for row in rows],
    )
    _refuse_steps(taken, profile, faults)
    directions = list(_directions(taken, profile, faults))
    known = [direction for direction in directions if direction is not None]
    if len(known) < len(directions):
        rows, known = [], []
        taken = _ProfiledRows(np.empty(0), np.empty(0), (), (), ())
    runs = np.array(_runs(taken, known, profile, faults), dtype=np.int64)
    positive = [direction is Direction.POSITIVE for direction in known]
    readings = readings_at(taken.lines, taken.targets, positive, runs, taken.deviations)
    return (readings if runs.all() else readings.only(runs > 0)), of_rows


def _refuse_steps(rows: _ProfiledRows, profile: Profile, faults: FaultList) -> None:
    """Add a fault if the values in the profile's column of deviations are really the distances
    between the targets.
    """
    steps = np.diff(rows.targets)
    if profile.measured or steps.size < 2 or not np.any(steps):
        return
    if np.all(np.abs(np.abs(rows.deviations[1:]) - np.abs(steps)) <= _SAME_STEP):
        faults.add(
            "the values are the distances between the targets, not deviations",
            place=f"column '{profile.value}'",
            expected="the column with deviations or measured positions",
            hint="correct `value` in the profile: it names the column of the spacing",
        )


def _directions(
    rows: _ProfiledRows, profile: Profile, faults: FaultList
) -> Iterator[Direction | None]:
    if profile.direction_from in {"+", "-"}:
        yield from [Direction(profile.direction_from)] * len(rows.lines)
        return
    if profile.direction_from == "order":
        yield from _by_order(rows, faults)
        return
    known = {word: profile.directions.get(word.casefold()) for word in set(rows.directions)}
    for line, word in zip(rows.lines, rows.directions, strict=True):
        if known[word] is None:
            faults.add(
                "the direction is not among the names that the profile lists under `directions`",
                place=f"line {line}, column '{profile.direction}'",
                expected=", ".join(profile.directions),
                found=shown(word),
                hint="add this name under `directions` of the profile",
            )
        yield known[word]


def traverses_of(targets: FloatArray) -> list[slice]:
    """Return the index range of each traverse in the ``targets`` (n,). A traverse begins where a
    target is repeated.
    """
    ends = (np.flatnonzero(np.diff(targets) == 0.0) + 1).tolist()
    return [slice(a, b) for a, b in pairwise([0, *ends, len(targets)])]


def _by_order(rows: _ProfiledRows, faults: FaultList) -> Iterator[Direction | None]:
    """Yield the direction of each row: + in a traverse with rising targets, − in one with falling
    targets; None, with a fault, if neither.
    """
    for part in traverses_of(rows.targets):
        targets = rows.targets[part]
        steps = np.unique(np.sign(np.diff(targets))).tolist()
        if len(steps) != 1:
            faults.add(
                "the order of the rows does not show the directions",
                place=f"line {rows.lines[part.start]}" if part.stop > part.start else "",
                expected="targets that rise, then fall, and so on, each end target twice in a row",
                found=f"targets {', '.join(map(as_text, targets[:6].tolist()))}",
                hint="name a column with the direction in the profile (`direction_from`)",
            )
            yield from [None] * (part.stop - part.start)
        else:
            direction = Direction.POSITIVE if steps[0] > 0 else Direction.NEGATIVE
            yield from [direction] * (part.stop - part.start)


def _runs(
    rows: _ProfiledRows, directions: Sequence[Direction], profile: Profile, faults: FaultList
) -> list[int]:
    """Return the run number of each row: from the column of run numbers, or else counted as
    repeated approaches to a target; 0 for an invalid cell.
    """
    if not profile.run:
        times: Counter[tuple[float, Direction]] = Counter()
        counted = []
        for key in zip(rows.targets.tolist(), directions, strict=True):
            times[key] += 1
            counted.append(times[key])
        return counted
    known = {text: _count(text) for text in set(rows.runs)}
    runs = [known[text] for text in rows.runs]
    for line, text, run in zip(rows.lines, rows.runs, runs, strict=True):
        if not run:
            faults.add(
                "the run is not a number of at least 1",
                place=f"line {line}, column '{profile.run}'",
                expected="1, 2, 3, ..",
                found=shown(text),
                hint="name another column as `run` in the profile, or leave `run` empty there",
            )
    if profile.run_counts == "runs":
        return runs
    ways = list(zip(directions, runs, strict=True))
    of = {one: sorted({run for way, run in ways if run and way is one}) for one in Direction}
    ranks = {(one, run): rank for one in of for rank, run in enumerate(of[one], start=1)}
    return [ranks.get(way, 0) for way in ways]


def _count(text: str) -> int:
    match = _COUNT.fullmatch(text)
    return int(match[1]) if match else 0


def _above(text: Sequence[str], table: ForeignTable, profile: Profile) -> list[tuple[int, str]]:
    """Return the lines above the header row that look like data rows, with numbers in the columns
    of targets and of readings.
    """
    if not profile.header_line:
        return []
    target = table.columns.index(profile.target)
    values = [
        place
        for place, name in enumerate(table.columns)
        if name in {profile.value, *profile.traverses}
    ]
    found = []
    for number, line in enumerate(text[: profile.header_line - 1], start=1):
        cells = cells_of(line, profile.delimiter) or []
        valued = (cells[place] for place in values if place < len(cells))
        if target < len(cells) and any(map(_NUMBER.fullmatch, valued)):
            found += [(number, line)] if _NUMBER.fullmatch(cells[target]) else []
    return found


def _hidden(text: Sequence[str], table: ForeignTable, profile: Profile) -> list[tuple[int, str]]:
    def cells(line: str) -> list[str] | None:
        return cells_of(line, profile.delimiter)

    return rows_as_comments(text, profile.header_line, cells, len(table.columns))


def _unused(rows: Sequence[int], table: ForeignTable, profile: Profile) -> Finding | None:
    if not rows:
        return None
    listed_lines = []
    for row in rows[:_LISTED]:
        cells = filter(None, (column[row] for column in table.cells))
        listed_lines.append(f"{table.lines[row]} {shown('; '.join(cells))}")
    more = max(0, len(rows) - _LISTED)
    return Finding.of(
        "CW-R059", "warning", column=shown(profile.target), lines=listed_lines, more=more
    )
