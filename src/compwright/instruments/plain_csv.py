"""The plain CSV forms of a positioning test, long and wide (contract, "Plain CSV").

Long: columns ``target_mm`` or ``target_deg``, ``direction`` (``+``, ``-``), ``run`` and one of
``deviation_um``, ``deviation_mm``, ``deviation_arcsec``, ``deviation_deg``, ``measured_mm``,
``measured_deg``; one row per reading. Wide: ``target_mm`` or ``target_deg`` and one column of
deviations per traverse (``+1``, ``-1``, ``+2``, ...) in the unit of the required key ``unit``; an
empty cell is a reading that was not made. Measured positions have the long form only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from compwright.foundations.units import TO_INSIDE
from compwright.instruments.assembling import Reading
from compwright.instruments.comments import Comments, sign_of
from compwright.instruments.csv_table import (
    COLUMNS,
    INCHES,
    Table,
    in_inches,
    like_traverse,
    plain_signs,
    traverse_of,
)
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import DecimalMarks, parse_count
from compwright.instruments.parts import AXIS_COLUMN
from compwright.records.axis import AxisKind, Direction

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
    """What the rows say: the kind of axis, the readings in mm or deg, and what remains to be told
    about the columns.
    """

    kind: AxisKind
    readings: tuple[Reading, ...]
    measured: bool = False
    sign_said: bool = False
    left_out: tuple[str, ...] = ()
    doubtful: str = ""


def read_csv(table: Table, comments: Comments, faults: FaultList) -> CsvReadings:
    """Return the readings of a plain CSV file; faults of cells are noted.

    Raises InputError when the columns do not form one of the two forms.
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
            "the header row mixes the long and the wide form",
            place=f"line {table.line}",
            expected="either direction, run and a value, or one column per traverse (+1, -1, ...)",
            found=_listed([*long, *traverses]),
        )
    marks = DecimalMarks(faults)
    value = "" if traverses else _value_column(table, target, faults)
    used = (target, *traverses) if traverses else (target, "direction", "run", value)
    if not traverses:
        _note_missing(table, faults)
    if not set(used) <= set(table.columns):
        faults.raise_if_any()  # without these columns every row would repeat the same fault
    if traverses:
        factor = _wide_factor(target, comments, faults) * (sign or 1.0)
        readings = _wide(table, (target, traverses), factor, marks, faults)
    else:
        readings = _long(table, (target, value), sign or 1.0, marks, faults)
    marks.check(comma_is_delimiter=table.delimiter == ",")
    return CsvReadings(
        kind=_KIND_OF_TARGET[target],
        readings=tuple(readings),
        measured=value.startswith("measured"),
        sign_said=sign is not None,
        left_out=tuple(column for column in table.columns if column not in (*used, AXIS_COLUMN)),
        doubtful=marks.doubtful_point(),
    )


# one caller
def _refuse_unsigned(table: Table, wide: bool, faults: FaultList) -> None:  # noqa: FBT001
    """Raise for columns named 1, 2, ... or +0: spreadsheets take the plus off, and then the
    direction is lost.

    In a ``wide`` file also for ``up 3`` or ``+3 up``: a traverse that is left out would be missed
    by nobody.
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
            "traverse columns are not named by direction and run",
            place=f"line {table.line}",
            expected=(
                "+1, -1, +2, -2, ... (another name, without a number, for a column that is no"
                " traverse)"
            ),
            found=_listed(bare),
        )
        faults.raise_if_any()


def _refuse_twice(
    table: Table, traverses: Mapping[str, tuple[str, int]], faults: FaultList
) -> None:
    """Note a traverse that two columns name, ``+3`` and ``3 +``."""
    first: dict[tuple[str, int], str] = {}
    for column, traverse in traverses.items():
        other = first.setdefault(traverse, column)
        if other != column:
            found = f"'{other}' and '{column}'"
            faults.add(
                "a traverse is given twice",
                place=f"line {table.line}",
                expected="one column per traverse",
                found=found,
            )


def _listed(columns: Sequence[str]) -> str:
    return ", ".join(columns[:8]) + (", ..." if len(columns) > 8 else "") if columns else "none"


def _note_missing(table: Table, faults: FaultList) -> None:
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
            )


def _target_column(table: Table, faults: FaultList) -> str:
    targets = [column for column in _KIND_OF_TARGET if column in table.columns]
    inches = in_inches(table.columns)
    if inches:
        faults.add(
            "is in inches, which are not read",
            place=f"line {table.line}",
            expected=INCHES,
            found=shown(inches),
        )
        faults.raise_if_any()
    if not targets:
        faults.add(
            "the target column is missing",
            place=f"line {table.line}",
            expected=(
                "target_mm or target_deg; a table of another program is read by a mapping profile"
                " (compwright profile FILE --out P.yaml)"
            ),
            found=f"columns {_listed(table.columns)}",
        )
    if len(targets) > 1:
        faults.add(
            "there are two target columns",
            place=f"line {table.line}",
            expected="target_mm or target_deg, not both",
            found=_listed(targets),
        )
    return targets[0] if targets else ""


def _value_column(table: Table, target: str, faults: FaultList) -> str:
    values = [column for column in table.columns if column in VALUES]
    place = f"line {table.line}"
    if not values:
        faults.add(
            "the value column is missing",
            place=place,
            expected=f"one of {', '.join(VALUES)}; a table of another program is read by a mapping"
            " profile (compwright profile FILE --out P.yaml)",
            found=_listed(table.columns),
        )
    if len(values) > 1:
        faults.add(
            "there is more than one value column",
            place=place,
            expected="one of them",
            found=_listed(values),
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
        )
    return values[0] if values else ""


def _wide_factor(target: str, comments: Comments, faults: FaultList) -> float:
    """Return the factor from the key ``unit`` to mm or deg; 1 after noting a fault."""
    unit = comments.get("unit")
    wanted = (
        f"a comment line such as '# unit: {'arcsec' if target == 'target_deg' else 'um'}' above the"
        " header row"
    )
    if not unit:
        faults.add(
            "key 'unit' is missing: the wide form needs the unit of its deviations", expected=wanted
        )
        return 1.0
    known = TO_INSIDE.get(unit) or TO_INSIDE.get(unit.lower())
    place = comments.places["unit"]
    if known is None:
        hint = f" (inches are not read; {INCHES})" if in_inches([f"unit {unit.lower()}"]) else ""
        found = f"{shown(unit)}{hint}"
        faults.add(
            "key 'unit' names an unknown unit",
            place=place,
            expected="um, mm, arcsec or deg",
            found=found,
        )
        return 1.0
    if target and known[0] != _KIND_OF_TARGET[target].unit:
        faults.add(
            "target and unit contradict each other: one is a length, the other an angle",
            place=place,
            expected=f"{_UNITS_OF[_KIND_OF_TARGET[target]]} with {target}",
            found=shown(unit),
        )
    return known[1]


def _long(
    table: Table, columns: tuple[str, str], sign: float, marks: DecimalMarks, faults: FaultList
) -> list[Reading]:
    target, value = columns
    where = {name: table.columns.index(name) for name in (target, "direction", "run", value)}
    factor = TO_INSIDE[value.rpartition("_")[2]][1]
    absolute = value.startswith("measured")
    readings = []
    for row in table.rows:
        cell = {name: row.cells[index] for name, index in where.items()}
        position = marks.parse(cell[target], place=_place(row.line, target), column=target)
        direction = _direction(cell["direction"], row.line, faults)
        run = _run(cell["run"], row.line, faults)
        number = marks.parse(
            cell[value],
            place=_place(row.line, value),
            column=value,
            expected="a number, or no row for a reading that was not made",
        )
        if position is None or direction is None or run is None or number is None:
            continue
        deviation = number * factor - position if absolute else sign * (number * factor)
        readings.append(Reading(position + 0.0, direction, run, deviation, f"line {row.line}"))
    return readings


def _wide(
    table: Table,
    columns: tuple[str, Mapping[str, tuple[str, int]]],
    factor: float,
    marks: DecimalMarks,
    faults: FaultList,
) -> list[Reading]:
    target, traverses = columns
    at = table.columns.index(target)
    where = [
        (column, table.columns.index(column), Direction(sign), run)
        for column, (sign, run) in traverses.items()
    ]
    lines: dict[float, int] = {}
    readings = []
    for row in table.rows:
        position = marks.parse(row.cells[at], place=_place(row.line, target), column=target)
        if position is not None and lines.setdefault(position, row.line) != row.line:
            faults.add(
                "a target is given twice",
                place=_place(row.line, target),
                expected="one row per target",
                found=f"{shown(row.cells[at])} also in line {lines[position]}",
            )
            continue  # its readings would each be told as given twice
        for column, index, direction, run in where:
            if not row.cells[index]:
                continue
            place = _place(row.line, column)
            number = marks.parse(
                row.cells[index],
                place=place,
                column="traverses",
                expected="a number, or an empty cell for a reading not made",
            )
            if position is not None and number is not None:
                readings.append(Reading(position + 0.0, direction, run, number * factor, place))
    return readings


def _place(line: int, column: str) -> str:
    return f"line {line}, column {column}"


def _direction(text: str, line: int, faults: FaultList) -> Direction | None:
    sign = plain_signs(text)
    if sign in {"+", "-"}:
        return Direction(sign)
    faults.add(
        "direction is neither + nor -",
        place=_place(line, "direction"),
        expected="+ or -",
        found=shown(text),
    )
    return None


def _run(text: str, line: int, faults: FaultList) -> int | None:
    try:
        return parse_count(text)
    except ValueError as reason:
        faults.add(
            f"run {reason}", place=_place(line, "run"), expected="1, 2, 3, ...", found=shown(text)
        )
        return None
