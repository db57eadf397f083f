"""The plain CSV forms of a positioning test: long (row per reading) and wide (row per target).

The long form has one row per reading, with the columns ``target_mm`` or ``target_deg``,
``direction`` (``+``, ``-``), ``run``, and one of ``deviation_um``, ``deviation_mm``,
``deviation_arcsec``, ``deviation_deg``, ``measured_mm``, ``measured_deg``. A column ``time`` is
optional.

The wide form has one row per target, with the column ``target_mm`` or ``target_deg`` and one column
of deviations per traverse (``+1``, ``-1``, ``+2``, ...). The comment key ``unit`` is required and
states the unit of the deviations. An empty cell means that this reading was not taken. Measured
positions instead of deviations are possible in the long form only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import TO_INSIDE
from compwright.instruments.comments import Comments, sign_of
from compwright.instruments.csv_table import (
    COLUMNS,
    INCHES,
    CsvTable,
    in_inches,
    like_traverse,
    plain_signs,
    traverse_of,
)
from compwright.instruments.fault_list import FaultList, by_profile, shown
from compwright.instruments.numbers import DecimalMarks, counts_of
from compwright.instruments.parts import AXIS_COLUMN
from compwright.instruments.reading_findings import unread_finding
from compwright.instruments.readings import Readings, readings_at
from compwright.instruments.times import TIME, times_of
from compwright.records.axis import AxisKind, FloatArray

_KIND_OF_TARGET = {"target_mm": AxisKind.LINEAR, "target_deg": AxisKind.ROTARY}
#: Columns of values; the unit is the last part of the name.
VALUES = (
    "deviation_um",
    "deviation_mm",
    "deviation_arcsec",
    "deviation_deg",
    "measured_mm",
    "measured_deg",
)
_UNITS_OF = {AxisKind.LINEAR: "um or mm", AxisKind.ROTARY: "arcsec or deg"}


@dataclass(frozen=True, slots=True, kw_only=True)
class CsvReadings:
    """The contents of a plain CSV file: the kind of axis, the readings in mm or deg, and what has
    to be reported about the columns.
    """

    kind: AxisKind
    readings: Readings
    measured: bool = False
    sign_stated: bool = False
    left_out: tuple[str, ...] = ()
    doubtful: str = ""
    unread: Finding | None = None


def read_csv(table: CsvTable, comments: Comments, faults: FaultList) -> CsvReadings:
    """Return the readings of a plain CSV file. Faults of cells are added to ``faults``.

    Raises InputError if the columns are neither those of the long form nor those of the wide form.
    """
    traverses = {
        column: traverse
        for column in table.columns
        if (traverse := traverse_of(column)) is not None
    }
    long = [
        column for column in table.columns if column in COLUMNS and column not in _KIND_OF_TARGET
    ]
    _refuse_unsigned(table, bool(traverses), faults)
    _refuse_twice(table, traverses, faults)
    target = _target_column(table, faults)
    sign = sign_of(comments, faults)
    if traverses and long:
        faults.add(
            "the header row mixes two forms of table",
            place=f"line {table.line}",
            expected="either direction, run and a value, or one column per traverse (+1, -1, ...)",
            found=_listed([*long, *traverses]),
            hint=(
                "name the columns either target_mm, direction, run, deviation_um, or target_mm, +1,"
                " -1, ..."
            ),
        )
    marks = DecimalMarks(faults)
    value = "" if traverses else _value_column(table, target, faults)
    used: tuple[str, ...] = (
        (target, *traverses) if traverses else (target, "direction", "run", value)
    )
    if not traverses:
        _note_missing(table, faults)
    if not set(used) <= set(table.columns):
        faults.raise_if_any()  # without these columns every row would repeat the same fault
    if traverses:
        factor = _wide_factor(target, comments, faults) * (sign or 1.0)
        readings, targets = _wide(table, (target, traverses), factor, marks, faults)
        unread = unread_finding(targets, readings, _KIND_OF_TARGET[target])
    else:
        unread = None  # an empty value of a row is a fault there
        readings = _long(table, (target, value), sign or 1.0, marks, faults)
        used += (TIME,) if readings.times is not None else ()
    marks.check(comma_is_delimiter=table.delimiter == ",")
    return CsvReadings(
        kind=_KIND_OF_TARGET[target],
        readings=readings,
        measured=value.startswith("measured"),
        sign_stated=sign is not None,
        left_out=tuple(column for column in table.columns if column not in (*used, AXIS_COLUMN)),
        doubtful=marks.doubtful_point(),
        unread=unread,
    )


# one caller
def _refuse_unsigned(table: CsvTable, wide: bool, faults: FaultList) -> None:  # noqa: FBT001
    """Raise an error for columns named by a number without direction (such as 1 or 2), because a
    spreadsheet may have removed the plus sign.

    In a ``wide`` file an error is also raised for names such as ``up 3`` and ``+3 up``, because
    otherwise the traverse would be left out unnoticed.
    """
    unknown = [
        column for column in table.columns if traverse_of(column) is None and column not in COLUMNS
    ]
    bare = [
        column
        for column in unknown
        if column.lstrip("+-").isdigit() or (wide and like_traverse(column))
    ]
    if bare:
        faults.add(
            "the names of traverse columns do not show direction and run",
            place=f"line {table.line}",
            expected="+1, -1, +2, -2, ... (the sign is the direction, the number is the run)",
            found=_listed(bare),
            hint="rename these columns +1, -1, +2, -2, ...",
        )
        faults.raise_if_any()


def _refuse_twice(
    table: CsvTable, traverses: Mapping[str, tuple[str, int]], faults: FaultList
) -> None:
    """Add a fault if two columns contain the same traverse, such as ``+3`` and ``3 +``."""
    first: dict[tuple[str, int], str] = {}
    for column, traverse in traverses.items():
        other = first.setdefault(traverse, column)
        if other != column:
            faults.add(
                "a traverse is given twice",
                place=f"line {table.line}",
                expected="one column per traverse",
                found=f"'{other}' and '{column}'",
                hint="rename or remove one of the two columns",
            )


def _listed(columns: Sequence[str]) -> str:
    return ", ".join(columns[:8]) + (", ..." if len(columns) > 8 else "") if columns else "none"


def _note_missing(table: CsvTable, faults: FaultList) -> None:
    for column in ("direction", "run"):
        if column not in table.columns:
            faults.add(
                f"column '{column}' is missing",
                place=f"line {table.line}",
                expected=(
                    "target_mm or target_deg, direction, run and one value column, or target and"
                    " traverses (+1, -1, ...)"
                ),
                found=f"columns {_listed(table.columns)}",
                hint=f"name the column with these values `{column}` in the header row",
            )


def _target_column(table: CsvTable, faults: FaultList) -> str:
    targets = [column for column in _KIND_OF_TARGET if column in table.columns]
    inches = in_inches(table.columns)
    if inches:
        faults.add(
            "is in inches, which compwright does not read",
            place=f"line {table.line}",
            expected=INCHES,
            found=shown(inches),
            hint="export the file again in mm",
        )
        faults.raise_if_any()
    if not targets:
        faults.add(
            "the target column is missing",
            place=f"line {table.line}",
            expected="target_mm or target_deg",
            found=f"columns {_listed(table.columns)}",
            hint=f"describe the table with {by_profile(faults.file)}",
        )
    if len(targets) > 1:
        faults.add(
            "there are two target columns",
            place=f"line {table.line}",
            expected="target_mm or target_deg, not both",
            found=_listed(targets),
            hint="leave one of them out",
        )
    return targets[0] if targets else ""


def _value_column(table: CsvTable, target: str, faults: FaultList) -> str:
    values = [column for column in table.columns if column in VALUES]
    place = f"line {table.line}"
    if not values:
        faults.add(
            "the value column is missing",
            place=place,
            expected=f"one of {', '.join(VALUES)}",
            found=_listed(table.columns),
            hint=f"describe the table with {by_profile(faults.file)}",
        )
    if len(values) > 1:
        faults.add(
            "there is more than one value column",
            place=place,
            expected="one of them",
            found=_listed(values),
            hint="leave all but one of these columns out",
        )
    if (
        len(values) == 1
        and target
        and TO_INSIDE[values[0].rpartition("_")[2]][0] != _KIND_OF_TARGET[target].unit
    ):
        faults.add(
            "target and value contradict each other: one is a length, the other an angle",
            place=place,
            expected=f"a value in {_UNITS_OF[_KIND_OF_TARGET[target]]} with {target}",
            found=values[0],
            hint="rename the column whose unit is wrong",
        )
    return values[0] if values else ""


def _wide_factor(target: str, comments: Comments, faults: FaultList) -> float:
    """Return the factor from the unit in the comment lines to mm or deg, 1 if it is invalid."""
    unit = comments.get("unit")
    wanted = (
        f"a comment line such as '# unit: {'arcsec' if target == 'target_deg' else 'um'}' above the"
        " header row"
    )
    if not unit:
        faults.add(
            "key 'unit' is missing: a table with a column for each traverse (+1, -1, ...) needs "
            "the unit of its deviations",
            expected=wanted,
            hint="add the line `# unit: um` (or mm, arcsec, deg) above the header row",
        )
        return 1.0
    known = TO_INSIDE.get(unit) or TO_INSIDE.get(unit.lower())
    place = comments.places["unit"]
    if known is None:
        hint = f" (inches are not read; {INCHES})" if in_inches([f"unit {unit.lower()}"]) else ""
        faults.add(
            "key 'unit' names an unknown unit",
            place=place,
            expected="um, mm, arcsec or deg",
            found=f"{shown(unit)}{hint}",
            hint="write `# unit: um`, mm, arcsec or deg",
        )
        return 1.0
    if target and known[0] != _KIND_OF_TARGET[target].unit:
        faults.add(
            "target and unit contradict each other: one is a length, the other an angle",
            place=place,
            expected=f"{_UNITS_OF[_KIND_OF_TARGET[target]]} with {target}",
            found=shown(unit),
            hint="correct the line `# unit: ...`, or the name of the target column",
        )
    return known[1]


def _long(
    table: CsvTable, columns: tuple[str, str], sign: float, marks: DecimalMarks, faults: FaultList
) -> Readings:
    target, value = columns
    factor = TO_INSIDE[value.rpartition("_")[2]][1]
    positions = marks.parse_all(table.of(target), table.lines, table.place(target), target)
    ways = table.which("direction", ("+", "-"), plain_signs, faults)
    runs = counts_of(table.of("run"), table.place("run"), "run", faults)
    numbers = marks.parse_all(
        table.of(value),
        table.lines,
        table.place(value),
        value,
        "a number, or no row for a reading that was not made",
    )
    if value.startswith("measured"):
        deviations = numbers * factor - positions
    else:
        deviations = sign * (numbers * factor)
    readings = _timed(table, readings_at(table.lines, positions, ways == 0, runs, deviations))
    whole = np.isfinite(deviations) & np.isfinite(positions) & (runs > 0) & (ways >= 0)
    return readings if whole.all() else readings.only(whole)


def _timed(table: CsvTable, readings: Readings) -> Readings:
    """Return the readings with the time of each from the column ``time``; NaN for a row without a
    time.
    """
    if TIME not in table.columns:
        return readings
    clock, times = times_of(table.of(TIME), table.place(TIME), FaultList(""))
    return replace(readings, clock=clock, times=times) if np.isfinite(times).any() else readings


def _wide(
    table: CsvTable,
    columns: tuple[str, Mapping[str, tuple[str, int]]],
    factor: float,
    marks: DecimalMarks,
    faults: FaultList,
) -> tuple[Readings, FloatArray]:
    """Return the readings and targets of a table with one row per target; NaN if invalid."""
    target, traverses = columns
    names = list(traverses)
    positions = marks.parse_all(table.of(target), table.lines, table.place(target), target)
    rows = _rows_of_new_targets(table, target, positions.tolist(), faults)
    of = [table.of(name) for name in names]
    made = [(row, index) for row in rows for index in range(len(names)) if of[index][row]]
    row, column = np.array(made, dtype=np.int64).reshape(-1, 2).T
    lines = np.array(table.lines, dtype=np.int64)[row]

    def place(index: int) -> str:
        return f"line {lines[index]}, column {names[column[index]]}"

    numbers = marks.parse_all(
        [of[index][row] for row, index in made],
        lines,
        place,
        "traverses",
        "a number, or an empty cell for a reading not made",
    )
    signs = np.array([sign == "+" for sign, _ in traverses.values()], dtype=np.bool_)
    runs = np.array([run for _, run in traverses.values()], dtype=np.int64)
    readings = Readings(positions[row] + 0.0, signs[column], runs[column], numbers * factor, place)
    whole = np.isfinite(readings.targets) & np.isfinite(numbers)
    return (readings if whole.all() else readings.only(whole)), positions


def _rows_of_new_targets(
    table: CsvTable, target: str, positions: Sequence[float], faults: FaultList
) -> list[int]:
    """Return the indices of the rows whose target is not in an earlier row, and add a fault for
    each row that repeats a target.
    """
    first: dict[float, int] = {}
    rows = []
    for row, position in enumerate(positions):
        above = first.setdefault(position, row) if position == position else row
        if above == row:
            rows.append(row)
            continue
        faults.add(
            "a target is given twice",
            place=table.place(target)(row),
            expected="one row per target",
            found=f"{shown(table.of(target)[row])} also in line {table.lines[above]}",
            hint="remove one of the two rows, or correct the target of one of them",
        )
    return rows
