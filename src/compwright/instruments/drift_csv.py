"""Readers of two plain CSV forms with two columns: stand-still tests, and tests of lost motion
after small or slow moves.

Columns of a stand-still test: ``time_min``, and ``deviation_um`` (linear axes) or
``deviation_arcsec`` (rotary axes). Columns of a test of lost motion: ``distance_mm`` or
``speed_mm_min`` of the move, and ``lost_motion_um``. Columns may be in any order, and other columns
are ignored. Comment keys are kept as for other tests.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.provenance import source_of
from compwright.foundations.units import TO_INSIDE
from compwright.instruments.comments import Comments, read_comments, sign_of
from compwright.instruments.csv_table import CsvTable, read_table, split_lines
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import DecimalMarks
from compwright.instruments.text_input import read_lines
from compwright.records.axis import AxisKind
from compwright.records.drift import DriftTest, LostMotionTest

TIME: Final = "time_min"
#: What lost motion may depend on, and the column of its values.
DISTANCE: Final = "distance_mm"
SPEED: Final = "speed_mm_min"
LOST_MOTION: Final = "lost_motion_um"
_VALUE: Final = {AxisKind.LINEAR: "deviation_um", AxisKind.ROTARY: "deviation_arcsec"}
#: Two readings tell a difference, not a range.
_FEWEST: Final = 3


def is_drift(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a stand-still test."""
    return any(line.lower().lstrip('"').startswith(TIME) for line in text)


def is_lost_motion(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a table of lost motion over distance or speed."""
    lines = (line.lower().lstrip('"') for line in text)
    return any(LOST_MOTION in line and line.startswith((DISTANCE, SPEED)) for line in lines)


def is_two_columns(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are a stand-still test or a table of lost motion."""
    return is_drift(text) or is_lost_motion(text)


def read_drift(content: bytes, file: str, kind: AxisKind | None = None) -> DriftTest:
    """Return the stand-still test in a file of an axis of this ``kind`` (linear, rotary; None: the
    kind that the columns of the file state). Raises InputError with every fault at once.

    Faults: a column is missing, a cell is not a number, a time is given twice, there are fewer than
    three readings.
    """
    faults = FaultList(file)
    comments, table = _columns(content, faults, (TIME, _VALUE[kind or AxisKind.LINEAR]))
    if kind is None:
        angles = _VALUE[AxisKind.ROTARY] in table.columns
        kind = AxisKind.ROTARY if angles else AxisKind.LINEAR
    what = f"is not a stand-still test (axis at rest) of a {kind.value} axis"
    rows = _pairs(table, (TIME, _VALUE[kind]), what, faults)
    _refuse_too_few(rows, faults)
    sign = sign_of(comments, faults) or 1.0
    faults.raise_if_any()
    series = np.array(sorted(rows), dtype=np.float64)
    unit = _VALUE[kind].removeprefix("deviation_")
    return DriftTest(
        kind=kind,
        minutes=series[:, 0],
        deviations=sign * series[:, 1] * TO_INSIDE[unit][1],
        source=source_of(file, content),
        header=comments.header,
    )


def read_lost_motion(content: bytes, file: str) -> LostMotionTest:
    """Return a table of lost motion over distance (mm) or speed (mm/min). Raises InputError."""
    faults = FaultList(file)
    comments, table = _columns(content, faults, (DISTANCE, LOST_MOTION))
    over = SPEED if SPEED in table.columns and DISTANCE not in table.columns else DISTANCE
    rows = _pairs(table, (over, LOST_MOTION), "is not a table of lost motion", faults)
    wrong = [at for at, _ in rows if at <= 0.0]
    if wrong:
        faults.add(
            f"{over} is not above zero",
            found=f"{wrong[0]:g}",
            hint="give the length or the speed of the move without its sign",
        )
    if not faults and len({at for at, _ in rows}) < _FEWEST:
        faults.add(
            f"has too few values of {over}",
            expected=f"{_FEWEST} at least",
            found=str(len({at for at, _ in rows})),
            hint="measure the lost motion after shorter and longer, slower and faster moves",
        )
    faults.raise_if_any()
    series = np.array(sorted(rows), dtype=np.float64)
    return LostMotionTest(
        over="speed" if over == SPEED else "distance",
        moves=series[:, 0],
        lost_motion=series[:, 1] * TO_INSIDE["um"][1],
        source=source_of(file, content),
        header=comments.header,
    )


def _columns(
    content: bytes, faults: FaultList, expected: tuple[str, str]
) -> tuple[Comments, CsvTable]:
    comment_lines, lines = split_lines(read_lines(content, faults.file))
    comments = read_comments(comment_lines, faults)
    if not lines:
        raise InputError(
            Fault(
                message="contains no readings",
                file=faults.file,
                expected=", ".join(expected),
                hint="add the readings below the header row",
            )
        )
    return comments, read_table(lines, faults)


def _pairs(
    table: CsvTable, columns: tuple[str, str], what: str, faults: FaultList
) -> list[tuple[float, float]]:
    """Return the pairs of numbers in two columns. ``what``: the message of the fault if one of the
    columns is missing.
    """
    if any(name not in table.columns for name in columns):
        faults.add(
            what,
            place=f"line {table.line}",
            expected=f"the columns {columns[0]} and {columns[1]}",
            found=shown(", ".join(table.columns)),
            hint=f"name the columns {columns[0]} and {columns[1]} in the header row",
        )
        faults.raise_if_any()
    marks = DecimalMarks(faults)
    one, other = (
        marks.parse_all(table.of(name), table.lines, table.place(name), name).tolist()
        for name in columns
    )
    marks.check(comma_is_delimiter=table.delimiter == ",")
    return list(zip(one, other, strict=True))


def _refuse_too_few(rows: list[tuple[float, float]], faults: FaultList) -> None:
    times = [minutes for minutes, _ in rows]
    twice = [minutes for minutes, count in Counter(times).items() if count > 1]
    if twice:
        faults.add(
            "a time is given twice",
            expected="each time once",
            found=f"{twice[0]:g} min",
            hint="remove one of the two rows",
        )
    if not faults and len(rows) < _FEWEST:
        faults.add(
            "has too few readings to show a drift",
            expected=f"{_FEWEST} at least, over the time that a positioning test takes",
            found=str(len(rows)),
            hint="record for as long as a positioning test takes",
        )
