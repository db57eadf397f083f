"""The plain CSV form of an environment record: columns for the time and for air or material
temperatures.

Each row is a moment, in any order. The column ``time`` is required. The air in the beam has the
columns ``air_c``, ``pressure_hpa`` and ``humidity_percent``; the scale or workpiece has the column
``material_c``. One of these two groups is required. Other columns are ignored, but a misspelt name
of one of these columns is refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.provenance import source_of
from compwright.instruments.csv_table import CsvTable, misspelt, read_table, split_lines
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import DecimalMarks
from compwright.instruments.text_input import read_lines
from compwright.instruments.times import TIME, times_of
from compwright.records.axis import FloatArray
from compwright.records.conditions import PLAUSIBLE_TEMPERATURES
from compwright.records.environment import AIR, MATERIAL, EnvironmentRecord

HUMIDITY: Final = AIR[2]
#: What a hall has: a pressure in kPa, Pa or reduced to another unit, a temperature in °F or K, or a
#: humidity as a fraction, lies outside.
_PLAUSIBLE: Final = {
    "air_c": PLAUSIBLE_TEMPERATURES,
    "pressure_hpa": (500.0, 1100.0),
    HUMIDITY: (1.01, 100.0),  # or 0, dry air
    MATERIAL: PLAUSIBLE_TEMPERATURES,
}


def read_environment(content: bytes, file: str) -> EnvironmentRecord:
    """Return the environment record in a file. Raises InputError with every fault at once.

    Faults: there is no column of times or of values, a column name is misspelt, a cell is not a
    number or its value is impossible in its unit, a time is given twice.
    """
    faults = FaultList(file)
    _, lines = split_lines(read_lines(content, file))
    if len(lines) < 2:
        raise InputError(
            Fault(
                message="the file contains no rows of values",
                file=file,
                expected=f"the columns {TIME}, {', '.join([*AIR, MATERIAL])}",
                hint="add a header row and a row of values for each time",
            )
        )
    table = read_table(lines, faults)
    columns = [name for name in (*AIR, MATERIAL) if name in table.columns]
    for column, name in misspelt(table.columns, (TIME, *AIR, MATERIAL)).items():
        faults.add(
            f"the column {column} is not known",
            place=f"line {table.line}",
            expected=f"{name}, the nearest known name",
            found=shown(column),
            hint=f"rename it to `{name}` if it holds these values, else remove it",
        )
    faults.raise_if_any()
    whole = not set(AIR) & set(columns) or set(AIR) <= set(columns)
    if TIME not in table.columns or not columns or not whole:
        faults.add(
            "is not a record of the environment",
            place=f"line {table.line}",
            expected=(
                f"a column {TIME}, and in addition all columns of the air ({', '.join(AIR)}), "
                f"the column {MATERIAL}, or both"
            ),
            found=shown(", ".join(table.columns)),
            hint=(
                "give the columns these names in the header row; remove air columns if the"
                " record does not contain all of them"
            ),
        )
        faults.raise_if_any()
    clock, times = times_of(table.of(TIME), table.place(TIME), faults)
    if clock == "time of day" and np.any(np.diff(times) < 0.0):
        faults.add(
            "the times of day go backwards: the record passes midnight, or its rows are not sorted",
            place=table.place(TIME)(int(np.argmax(np.diff(times) < 0.0)) + 1),
            expected="rising times of day, or a date with each time",
            hint="write the date with each time, here and in the measurement files",
        )
    marks = DecimalMarks(faults)
    values = {name: _column(table, name, marks, faults) for name in columns}
    marks.check(comma_is_delimiter=table.delimiter == ",")
    order = np.argsort(times, kind="stable")
    for index in order[np.flatnonzero(np.diff(times[order]) == 0.0) + 1]:
        faults.add(
            "a time is given twice",
            place=table.place(TIME)(int(index)),
            expected="each time once",
            found=shown(table.of(TIME)[int(index)]),
            hint="remove one of the two rows",
        )
    faults.raise_if_any()
    return EnvironmentRecord(
        clock=clock,
        times=times[order],
        values={name: value[order] for name, value in values.items()},
        sources=(source_of(file, content),),
    )


def joined(records: Sequence[EnvironmentRecord]) -> EnvironmentRecord:
    """Combine several environment records into one. Raises InputError if their columns or their
    kinds of time differ, or if a time occurs twice.
    """
    first, *others = records
    found = first
    for other in others:
        file = other.sources[0].file
        for what, ours, theirs in (
            ("columns", ", ".join(first.values), ", ".join(other.values)),
            ("times", first.clock, other.clock),
        ):
            if ours != theirs:
                raise InputError(
                    Fault(
                        message=f"this file of `environment` does not have the same {what} as "
                        f"{first.sources[0].file}",
                        file=file,
                        expected=ours,
                        found=theirs,
                        hint=f"give the same {what} in every file of `environment`",
                    )
                )
        found = replace(
            found,
            times=np.append(found.times, other.times),
            values={
                name: np.append(value, other.values[name]) for name, value in found.values.items()
            },
            sources=(*found.sources, *other.sources),
        )
    order = np.argsort(found.times)
    times = found.times[order]
    if np.any(np.diff(times) == 0.0):
        raise InputError(
            Fault(
                message="two files of `environment` contain rows with the same time",
                file=", ".join(source.file for source in found.sources),
                expected="each time once",
                hint="give each file once, and remove rows that are in two files",
            )
        )
    return replace(
        found, times=times, values={name: value[order] for name, value in found.values.items()}
    )


def _column(table: CsvTable, name: str, marks: DecimalMarks, faults: FaultList) -> FloatArray:
    numbers = marks.parse_all(table.of(name), table.lines, table.place(name), name)
    low, high = _PLAUSIBLE[name]
    dry = (name == HUMIDITY) & (numbers == 0.0)
    outside = np.flatnonzero(((numbers < low) | (numbers > high)) & ~dry)
    if outside.size:
        faults.add(
            "contains a value that is not plausible in the unit of its column",
            place=table.place(name)(int(outside[0])),
            expected=f"{low:g} to {high:g}{' (dry air: 0)' if name == HUMIDITY else ''}",
            found=(
                f"{shown(table.of(name)[int(outside[0])])} ({outside.size} of {numbers.size} rows)"
            ),
            hint="convert the column to the unit of its name (°C, hPa, %)",
        )
    return numbers
