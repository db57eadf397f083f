"""The entry sheet: a CSV file of the values that an engineer types in at the control.

Comment lines have the form ``# key: value``. The columns are point, position, value and unit,
separated by commas; numbers have a decimal point. In a line of point data, point is the point
number. In a line of a parameter, point is the parameter's name, and position is empty. ``# value:
error`` or ``# value: correction`` states what the control is assumed to expect.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

HEADER = ("point", "position", "value", "unit")
VALUES = ("error", "correction")
KEPT_SHEETS = 128  #: Each sheet is parsed once in a run.
_NUMBER = re.compile(r"[+-]?(?:[0-9]{1,12}(?:\.[0-9]{0,12})?|\.[0-9]{1,12})")


@dataclass(frozen=True, slots=True)
class SheetRow:
    """One row of an entry sheet. ``position`` is empty for a parameter; ``line`` counts from 1."""

    point: str
    position: str
    value: str
    unit: str
    line: int = 0


@dataclass(frozen=True, slots=True)
class EntrySheet:
    """An entry sheet: its comments by key (lower case), and its rows in order."""

    name: str
    comments: Mapping[str, str]
    rows: tuple[SheetRow, ...]
    lines: Mapping[str, int] = field(default_factory=dict)

    @property
    def axis(self) -> str:
        """The axis name of a sheet: its comment ``address``, else ``axis``, else from its file
        name.
        """
        named = re.fullmatch(r"entry_(.+)\.csv", self.name, re.IGNORECASE)
        return (
            self.comments.get("address") or self.comments.get("axis") or (named[1] if named else "")
        )


@lru_cache(maxsize=KEPT_SHEETS)
def is_entry_sheet(file: ControlFile) -> bool:
    """Return whether a file is an entry sheet, by its header."""
    for line in file.content[:100_000].decode("latin-1").removeprefix("\xef\xbb\xbf").splitlines():
        if line.strip() and not line.lstrip().startswith("#"):
            return [cell.strip().lower() for cell in line.split(",")] == list(HEADER)
    return False


def read_sheet(file: ControlFile, faults: list[Fault]) -> EntrySheet | None:
    """Return an entry sheet; None if it contains faults, which are added to ``faults`` with their
    lines.
    """
    sheet, found = _read(file)
    faults.extend(found)
    return sheet


@lru_cache(maxsize=KEPT_SHEETS)
def _read(file: ControlFile) -> tuple[EntrySheet | None, tuple[Fault, ...]]:
    faults: list[Fault] = []
    return parse_sheet(file, faults), tuple(faults)


def parse_sheet(file: ControlFile, faults: list[Fault]) -> EntrySheet | None:
    """Return an entry sheet, without the cache of `read_sheet`."""
    try:
        text = file.content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        faults.append(
            Fault(
                message="the entry sheet is not UTF-8 text",
                file=file.name,
                place=f"byte {error.start}",
                hint="save the sheet as CSV UTF-8",
            )
        )
        return None
    reader = _SheetReader(file.name, faults)
    for number, line in enumerate(
        text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1
    ):
        if line.strip() and not reader.refused:
            reader.take(number, line)
    return reader.sheet()


class _SheetReader:
    def __init__(self, name: str, faults: list[Fault]) -> None:
        self.name = name
        self.faults = faults
        self.known = len(faults)
        self.comments: dict[str, str] = {}
        self.lines: dict[str, int] = {}
        self.rows: dict[str, SheetRow] = {}
        self.header = self.refused = False

    def fault(self, message: str, line: int, expected: str = "", found: str = "") -> None:
        self.faults.append(
            Fault(
                message=message,
                file=self.name,
                place=f"line {line}",
                expected=expected,
                found=found[:60],
                hint="correct this line of the entry sheet",
            )
        )

    def take(self, number: int, line: str) -> None:
        if line.lstrip().startswith("#"):
            key, mark, value = line.lstrip("# \t").partition(":")
            if mark:
                self.comments.setdefault(key.strip().lower(), value.strip())
                self.lines.setdefault(key.strip().lower(), number)
            return
        cells = [cell.strip() for cell in line.split(",")]
        if not self.header:
            self.header = True
            if [cell.lower() for cell in cells] != list(HEADER):
                self.fault(
                    "the header is not that of a typed-entry sheet", number, ",".join(HEADER), line
                )
                self.refused = True
            return
        if len(cells) != len(HEADER):
            self.fault(
                "the row has a wrong number of columns",
                number,
                f"{len(HEADER)} columns: {','.join(HEADER)}",
                line,
            )
        elif (
            not cells[0]
            or not _NUMBER.fullmatch(cells[2])
            or (cells[1] and not _NUMBER.fullmatch(cells[1]))
        ):
            expected = "a point, a position or nothing, a number with decimal point, a unit"
            self.fault("the row cannot be read", number, expected, line)
        elif cells[0] in self.rows:
            self.fault(
                f"point {cells[0]} is given twice",
                number,
                f"once, in line {self.rows[cells[0]].line}",
                line,
            )
        else:
            point, position, value, unit = cells
            self.rows[point] = SheetRow(point, position, value, unit, number)

    def sheet(self) -> EntrySheet | None:
        if len(self.faults) == self.known and not self.rows:
            self.fault("the sheet contains no rows, so it is cut short rather than empty", 1)
        meaning = self.comments.get("value", "")
        if meaning not in VALUES:
            self.fault(
                "the sheet must state what its values are",
                self.lines.get("value", 1),
                "# value: error or # value: correction",
                meaning,
            )
        if len(self.faults) > self.known:
            return None
        return EntrySheet(self.name, self.comments, tuple(self.rows.values()), self.lines)


def write_sheet(
    name: str, comments: Sequence[tuple[str, str]], rows: Sequence[SheetRow]
) -> ControlFile:
    """Return an entry sheet as a file in ASCII (other letters in UTF-8) with LF line ends."""
    head = "".join(f"# {key}: {value}\n" for key, value in comments)
    body = "".join(f"{row.point},{row.position},{row.value},{row.unit}\n" for row in rows)
    return ControlFile(name, (head + ",".join(HEADER) + "\n" + body).encode())
