"""Entry sheets ``entry_<axis>.csv`` for a FANUC: the rows that an engineer types at the control.

A sheet begins with comments ``# key: value``. ``address`` or ``axis`` states the controlled axis
number, ``value`` whether the values are errors or corrections. The header
``point,position,value,unit`` and the rows follow.

The point of a row is the number of a pitch point (10000 + n, or n), and the value is its increment
in pulses. Or the point is a parameter, without position: ``3620``, ``3605#0``, a parameter of
inclination or of the second table. Cells are separated by commas; numbers have a decimal point.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from compwright.controllers.fanuc.series import ControlSeries
from compwright.controllers.fanuc.text import POINT_BASE, ParameterSetting, PointRecord, TapeContent
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Parameter (number, bit) -> units that its value may carry.
PARAMETERS: dict[tuple[int, int | None], frozenset[str]] = {
    **{
        (number, None): frozenset({"", "pulse"})
        for number in (1851, 1852, 3620, 3621, 3622, 3623, 3626, 3627)
    },
    **{(number, None): frozenset({"mm", "deg"}) for number in (3624, 3625)},
    (3605, 0): frozenset({""}),
    **{(number, None): frozenset({""}) for number in (*range(5861, 5865), 14985, 14986)},
    **{(number, None): frozenset({"", "pulse"}) for number in range(5871, 5875)},
    (14987, None): frozenset({"", "mm", "deg"}),
}
#: No FANUC has more points; below the parameters' numbers, so a bare number is one or the other.
_POINTS_BELOW = 1536

_HEADER = ("point", "position", "value", "unit")
_POINT = re.compile(r"([0-9]{1,6})(?:#([0-7]))?")
_NUMBER = re.compile(r"-?(?:[0-9]{1,12}(?:\.[0-9]{0,12})?|\.[0-9]{1,12})")
_COMMENT = re.compile(r"#\s*(\w+)\s*:(.*)")
_AXIS = re.compile(r"0?[1-9]|[1-9][0-9]", re.ASCII)


def is_sheet(file: ControlFile) -> bool:
    """Return whether a file is an entry sheet, by its name."""
    return file.name.casefold().endswith(".csv")


def read_sheet(
    file: ControlFile, pitch_sign: Callable[[str], str], series: ControlSeries
) -> TapeContent:
    """Return the contents of an entry sheet. ``pitch_sign``: the function that returns the option
    of this name for an axis address.

    If the sheet states that its values are errors, the option ``pitch_sign`` must be ``-``. Else a
    fault is added.
    """
    try:
        text = file.content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return TapeContent(
            faults=[
                Fault(
                    message="the entry sheet is not UTF-8 text",
                    file=file.name,
                    place=f"byte {error.start}",
                    hint="save the sheet as CSV UTF-8",
                )
            ]
        )
    lines = [
        (number, line.strip()) for number, line in enumerate(re.split(r"\r\n|\n|\r", text), start=1)
    ]
    sheet = _Sheet(file.name, pitch_sign, series)
    for number, line in lines:
        if line.startswith("#"):
            sheet.comment(line, number)
    sheet.find_axis()
    for number, line in lines:
        if line and not line.startswith("#"):
            sheet.row(tuple(cell.strip() for cell in line.split(",")), number)
    sheet.finish()
    return sheet.found


class _Sheet:
    def __init__(self, file: str, pitch_sign: Callable[[str], str], series: ControlSeries) -> None:
        self.file = file
        self.series = series
        self.pitch_sign = pitch_sign
        self.errors_at = 0
        self.found = TapeContent()
        self.keys: dict[str, str] = {}
        self.axis: int | None = None
        self.headed = False

    def comment(self, line: str, number: int) -> None:
        """Read a comment line such as ``# key: value``; other comments are ignored."""
        match = _COMMENT.match(line)
        if match is None:
            return
        key, value = match[1].casefold(), match[2].strip()
        if key == "value":
            if value not in ("error", "correction"):
                self._wrong(number, "what the values are", "error or correction", value)
            self.errors_at = number if value == "error" else self.errors_at
        if key in ("address", "axis") and self.keys.get(key, value) != value:
            self._wrong(number, f"a second {key}", self.keys[key], value)
        self.keys.setdefault(key, value)

    def find_axis(self) -> None:
        """Set the controlled axis number: from the comment ``address``, else ``axis``, else the
        file name.
        """
        named = re.fullmatch(r"entry_(.*)\.csv", self.file, re.IGNORECASE | re.DOTALL)
        given = self.keys.get("address") or self.keys.get("axis") or (named[1] if named else "")
        if _AXIS.fullmatch(given):
            self.axis = int(given)
            if self.errors_at and self.pitch_sign(str(self.axis)) == "+":
                self._wrong(
                    self.errors_at,
                    "values are given as errors, but option pitch_sign is +",
                    "correction",
                    "error",
                )
        else:
            self._wrong(
                0, "which controlled axis the sheet is for", "a comment such as # address: 1", given
            )

    def row(self, cells: tuple[str, ...], number: int) -> None:
        """Read one line of the sheet: the header row, or a row with a value."""
        if not self.headed:
            self.headed = True
            if tuple(cell.casefold() for cell in cells) != _HEADER:
                self._wrong(number, "header", ",".join(_HEADER), ",".join(cells))
            return
        if len(cells) != len(_HEADER):
            self._wrong(number, "row", "four cells: " + ",".join(_HEADER), ",".join(cells))
            return
        point, position, value, unit = cells
        match = _POINT.fullmatch(point)
        if match is None:
            self._wrong(number, "point", "a number such as 10040, 3620 or 3605#0", point)
            return
        known = self.series.number_here(int(match[1]))
        key = (
            int(match[1]) if known is None else known,
            None if match[2] is None else int(match[2]),
        )
        if not _NUMBER.fullmatch(value):
            self._wrong(
                number, f"the value of {point} is wrong", "a number with a decimal point", value
            )
        elif key in PARAMETERS and known is not None:
            self._parameter(key, position, value, unit, number)
        elif key[1] is None and (key[0] < _POINTS_BELOW or key[0] >= POINT_BASE):
            self._point(key[0], position, value, unit, number)
        else:
            self._wrong(
                number,
                "point is neither pitch data nor a parameter of the compensation",
                "10040, 3620, 3605#0 ..",
                point,
            )

    def finish(self) -> None:
        """Add a fault for an entry sheet without values."""
        if not self.found.settings and not self.found.points and not self.found.faults:
            self.found.faults.append(
                Fault(
                    message="the entry sheet contains neither compensation points nor parameters",
                    file=self.file,
                    hint="use the sheet `entry_<axis>.csv` that `compwright run` writes into "
                    "the folder `card/`",
                )
            )

    def _parameter(
        self, key: tuple[int, int | None], position: str, value: str, unit: str, line: int
    ) -> None:
        if position:
            self._wrong(line, f"parameter {key[0]} has a position", "an empty cell", position)
        elif unit not in PARAMETERS[key]:
            self._wrong(
                line,
                f"the unit of parameter {key[0]} is wrong",
                " or ".join(sorted(PARAMETERS[key])) or "none",
                unit,
            )
        else:
            self.found.settings.append(
                ParameterSetting(key[0], self.axis, key[1], unit or "P", value, self.file, line)
            )

    def _point(self, number: int, position: str, value: str, unit: str, line: int) -> None:
        if position and not (_NUMBER.fullmatch(position) and math.isfinite(float(position))):
            self._wrong(line, "position", "a number or nothing", position)
        elif unit != "pulse":
            self._wrong(line, "the unit of the pitch data is wrong", "pulse", unit)
        else:
            point = number - POINT_BASE if number >= POINT_BASE else number
            self.found.points.append(PointRecord(point, value, "sheet", self.file, line))

    def _wrong(self, line: int, message: str, expected: str, found: str) -> None:
        place = f"line {line}" if line else ""
        self.found.faults.append(
            Fault(
                message=message,
                file=self.file,
                place=place,
                expected=expected,
                found=found,
                hint="correct this line of the entry sheet",
            )
        )
