"""The plain CSV form of a stand-still test: columns ``time_min`` and ``deviation_um`` (linear axes)
or ``deviation_arcsec`` (rotary axes), one row per reading, in any order; comment keys are kept as
for other tests, and other columns are ignored.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.provenance import source_of
from compwright.foundations.units import TO_INSIDE
from compwright.instruments.comments import read_comments, sign_of
from compwright.instruments.csv_table import read_table, split_lines
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import DecimalMarks
from compwright.instruments.text_input import read_lines
from compwright.records.axis import AxisKind
from compwright.records.drift import DriftTest

TIME: Final = "time_min"
_VALUE: Final = {AxisKind.LINEAR: "deviation_um", AxisKind.ROTARY: "deviation_arcsec"}
#: Two readings tell a difference, not a range.
_FEWEST: Final = 3


def is_drift(text: Sequence[str]) -> bool:
    """Return whether the lines of a file are those of a stand-still test."""
    return any(line.lower().lstrip('"').startswith(TIME) for line in text)


def read_drift(content: bytes, file: str, kind: AxisKind | None = None) -> DriftTest:
    """Return the stand-still test of axes of a kind; None: of the kind that its columns say. Raises
    InputError with every fault at once: no such columns, cells that are no numbers, a time given
    twice, fewer than three readings.
    """
    faults = FaultList(file)
    comment_lines, lines = split_lines(read_lines(content, file))
    comments = read_comments(comment_lines, faults)
    if not lines:
        raise InputError(
            Fault(
                message="the file contains no readings",
                file=file,
                expected=f"the columns {TIME}, {_VALUE[kind or AxisKind.LINEAR]}",
                hint="add the readings below the header row",
            )
        )
    table = read_table(lines, faults)
    if kind is None:
        angles = _VALUE[AxisKind.ROTARY] in table.columns
        kind = AxisKind.ROTARY if angles else AxisKind.LINEAR
    lacking = [name for name in (TIME, _VALUE[kind]) if name not in table.columns]
    if lacking:
        faults.add(
            f"is not a stand-still test of a {kind.value} axis",
            place=f"line {table.line}",
            expected=f"the columns {TIME} and {_VALUE[kind]}",
            found=shown(", ".join(table.columns)),
            hint=f"name the columns {TIME} and {_VALUE[kind]} in the header row",
        )
        faults.raise_if_any()
    marks = DecimalMarks(faults)
    minutes, values = (
        marks.parse_all(table.of(name), table.lines, table.place(name), name).tolist()
        for name in (TIME, _VALUE[kind])
    )
    rows = list(zip(minutes, values, strict=True))
    marks.check(comma_is_delimiter=table.delimiter == ",")
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
