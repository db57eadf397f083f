"""Read times in the cells of a table: a date with a time, a time of day, or a number."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from typing import Final

import numpy as np

from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import parse_number
from compwright.records.axis import FloatArray
from compwright.records.environment import Clock

#: The column of times, in measurement files and in records of the environment.
TIME: Final = "time"
#: What a cell may hold, for messages.
EXPECTED: Final = "2026-11-24T08:15:30, 24.11.2026 08:15:30, 08:15:30, or a number"
_OF_DAY: Final = re.compile(r"([01]?\d|2[0-3]):([0-5]\d)(?::([0-5]\d(?:[.,]\d+)?))?")
_DAY_FIRST: Final = re.compile(r"(\d{1,2})\.(\d{1,2})\.(\d{4})[ T]+(.*)")


def times_of(
    cells: Sequence[str], place: Callable[[int], str], faults: FaultList
) -> tuple[Clock, FloatArray]:
    """Return the form in which a column gives times (such as date and time, or a number), and the
    times (n,): in seconds, or the numbers as they are written.

    A cell without a time, or with a time in another form than the first cell, is a fault and gives
    NaN. If there are no cells, the form is "number".
    """
    found: list[float] = []
    first: Clock | None = None
    for index, cell in enumerate(cells):
        parsed = _time_of(cell.strip())
        if parsed is None:
            faults.add(
                "is not a time",
                place=place(index),
                expected=EXPECTED,
                found=shown(cell),
                hint="write the time in one of these forms",
            )
        elif first not in (None, parsed[0]):
            faults.add(
                "is a time in a different form from the first",
                place=place(index),
                expected=f"a {first}, as in the first row",
                found=shown(cell),
                hint="write all times in the form of the first row",
            )
            parsed = None
        else:
            first = parsed[0]
        found.append(np.nan if parsed is None else parsed[1])
    return first or "number", np.array(found, dtype=np.float64)


def _time_of(text: str) -> tuple[Clock, float] | None:
    of_day = _OF_DAY.fullmatch(text)
    if of_day:
        hours, minutes, seconds = of_day.groups(default="0")
        return "time of day", (
            3600.0 * int(hours) + 60.0 * int(minutes) + float(seconds.replace(",", "."))
        )
    day_first = _DAY_FIRST.fullmatch(text)
    if day_first:
        day, month, year, rest = day_first.groups()
        text = f"{year}-{int(month):02d}-{int(day):02d}T{rest}"
    if re.match(r"\d{4}-\d\d-\d\d[ T]", text):
        try:
            moment = datetime.fromisoformat(text)
        except ValueError:
            return None
        if moment.tzinfo is not None:
            return "date and time with zone", moment.timestamp()
        return "date and time", moment.replace(tzinfo=UTC).timestamp()
    try:
        return "number", parse_number(text)
    except ValueError:
        return None
