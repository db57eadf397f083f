"""Entry sheets ``entry_<axis>.csv`` for HEIDENHAIN controls: the rows that an engineer types at the
control.

A sheet has comment lines ``# key: value``, the header ``point,position,value,unit``, then rows with
points and parameters. This is a second, small reader on purpose. It shares no code with the package
that writes these sheets.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from compwright.controllers.heidenhain.elements import (
    Generation,
    LinePlace,
    Parameter,
    Quantity,
    binary_fault,
    lines_of,
    number,
)
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import ControlFile

HEADER = "point,position,value,unit"

_WHOLE = re.compile(r"[0-9]{1,6}")
_FILE_NAME = re.compile(r"entry_(.+)\.csv", re.IGNORECASE)
#: Unit of a length or angle -> factor to mm or deg.
_UNITS = {"mm": 1.0, "um": 1e-3, "deg": 1.0}
#: MP730 is a bit and has no unit; these are ways to write that.
_NO_UNIT = ("", "-", "bit")


@dataclass(frozen=True, slots=True)
class JudgedSheet:
    """An entry sheet of one axis: ``values`` (k,) at ``points`` (k,), both in mm or deg.

    k is 0 for a sheet with parameters only. ``errors``: the values are errors, else corrections.
    ``kind``: linear or rotary by the units; None without a unit.
    """

    address: str
    errors: bool
    points: FloatArray
    values: FloatArray
    kind: AxisKind | None
    parameters: tuple[Parameter, ...]
    place: LinePlace


def is_sheet(file: ControlFile) -> bool:
    """Return whether a file is an entry sheet, by its name or its header line."""
    if file.name.lower().endswith(".csv"):
        return True
    return any(_squeezed(line) == HEADER for line in lines_of(file.content.decode("latin-1")))


def read_sheet(file: ControlFile, generation: Generation) -> tuple[JudgedSheet | None, list[Fault]]:
    """Return the contents of an entry sheet, and its faults; if there are faults, the contents are
    None.
    """
    fault = binary_fault(file.name, file.content)
    if fault is not None:
        return None, [fault]
    try:
        text = file.content.decode("utf-8")
    except UnicodeDecodeError as error:
        return None, [
            Fault(
                message="the entry sheet is neither ASCII nor UTF-8 text",
                file=file.name,
                place=f"byte {error.start + 1}",
                hint="save the sheet as CSV UTF-8",
            )
        ]
    reader = _SheetLines(file.name, generation)
    for line, content in enumerate(lines_of(text), start=1):
        reader.read(content.strip(), LinePlace(file.name, line))
    sheet = reader.sheet()
    return (None, reader.faults) if reader.faults else (sheet, [])


class _SheetLines:
    """Reads the lines of one entry sheet in their order."""

    def __init__(self, file: str, generation: Generation) -> None:
        self.file = file
        self.generation = generation
        self.comments: dict[str, str] = {}
        self.header: LinePlace | None = None
        self.points: list[tuple[float, float]] = []
        self.parameters: list[tuple[Quantity, float, str, LinePlace]] = []
        self.kind: AxisKind | None = None
        self.next_point = 0
        self.faults: list[Fault] = []

    def read(self, line: str, place: LinePlace) -> None:
        """Read one line of the sheet, given without leading and trailing blanks."""
        if line.startswith("#"):
            self._comment(line[1:], place)
        elif _squeezed(line) == HEADER:
            if self.header is not None:
                self.faults.append(
                    place.fault("a second header: are these two sheets in one file?")
                )
            self.header = place
        elif line:
            self._row(line, place)

    def _comment(self, text: str, place: LinePlace) -> None:
        key, colon, value = text.partition(":")
        key, value = key.strip().lower(), value.strip()
        if not colon or key not in {"axis", "address", "value"}:
            return
        if self.comments.setdefault(key, value) != value:
            self.faults.append(
                place.fault(f"a second # {key}:", expected=self.comments[key], found=value)
            )

    def _row(self, line: str, place: LinePlace) -> None:
        fields = [part.strip() for part in line.split(",")]
        if self.header is None or len(fields) != 4:
            expected = f"the header {HEADER}" if self.header is None else f"four fields: {HEADER}"
            self.faults.append(
                place.fault("the line cannot be read", expected=expected, found=repr(line[:80]))
            )
            return
        point, position, value, unit = fields
        parsed = number(value)
        if parsed is None:
            self.faults.append(
                place.fault(
                    "value", expected="a number with a decimal point", found=repr(value[:40])
                )
            )
        elif _WHOLE.fullmatch(point):
            self._point(int(point), position, parsed, unit, place)
        else:
            self._parameter(point, position, parsed, unit, place)

    def _point(self, point: int, position: str, value: float, unit: str, place: LinePlace) -> None:
        where = number(position)
        wanted, self.next_point = self.next_point, point + 1
        if where is None:
            self.faults.append(
                place.fault(
                    "position", expected="a number with a decimal point", found=repr(position[:40])
                )
            )
        elif unit not in _UNITS:
            self.faults.append(
                place.fault(
                    "the unit of a point is wrong", expected="mm, um or deg", found=repr(unit[:40])
                )
            )
        elif point != wanted:
            self.faults.append(
                place.fault(
                    "points are not in order (a line lost?)",
                    expected=f"point {wanted}",
                    found=f"point {point}",
                )
            )
        elif self.points and where <= self.points[-1][0]:
            self.faults.append(
                place.fault(
                    "positions do not ascend",
                    expected=f"above {self.points[-1][0]:g}",
                    found=f"{where:g}",
                )
            )
        else:
            self._unit(unit, place)
            self.points.append((where, value * _UNITS[unit]))

    def _parameter(
        self, name: str, position: str, value: float, unit: str, place: LinePlace
    ) -> None:
        quantity = self.generation.parameters.get(name)
        if quantity is None:
            known = ", ".join(self.generation.parameters)
            self.faults.append(
                place.fault(
                    "point", expected=f"a whole number from 0, or {known}", found=repr(name[:40])
                )
            )
            return
        units = {
            Quantity.BACKLASH: tuple(_UNITS),
            Quantity.LINEAR: ("mm/m",),
            Quantity.NONLINEAR: _NO_UNIT,
        }[quantity]
        if position:
            self.faults.append(
                place.fault(
                    f"{name} has no position", expected="an empty field", found=repr(position[:40])
                )
            )
        elif unit not in units:
            self.faults.append(
                place.fault(
                    f"the unit of {name} is wrong",
                    expected=" or ".join(filter(None, units)),
                    found=repr(unit[:40]),
                )
            )
        elif quantity is Quantity.NONLINEAR and value not in {0.0, 1.0}:
            self.faults.append(
                place.fault(f"{name} of this axis", expected="0 or 1", found=f"{value:g}")
            )
        elif quantity is Quantity.BACKLASH:
            self._unit(unit, place)
            self.parameters.append(
                (quantity, value * _UNITS[unit], "deg" if unit == "deg" else "mm", place)
            )
        else:
            self.parameters.append((quantity, value, unit, place))

    def _unit(self, unit: str, place: LinePlace) -> None:
        kind = AxisKind.ROTARY if unit == "deg" else AxisKind.LINEAR
        if self.kind not in {None, kind}:
            self.faults.append(
                place.fault(
                    "the sheet contains both lengths and angles",
                    expected="one unit for the axis",
                    found=unit,
                )
            )
        self.kind = kind

    def sheet(self) -> JudgedSheet | None:
        """Return the entry sheet after its last line; None, with a fault, if it has no values or
        lacks a required comment.
        """
        before = len(self.faults)
        head = LinePlace(self.file, self.header.line if self.header else 1)
        if self.header is None and not self.faults:
            self.faults.append(
                Fault(
                    message="the file is not an entry sheet of compwright",
                    file=self.file,
                    expected=f"the header {HEADER}",
                    hint="use the sheet `entry_<axis>.csv` that `compwright run` writes into "
                    "the folder `card/`",
                )
            )
        elif not self.points and not self.parameters and not self.faults:
            self.faults.append(
                head.fault("the sheet contains no points and no parameters (cut off?)")
            )
        values = self.comments.get("value", "")
        if values not in {"error", "correction"}:
            self.faults.append(
                head.fault(
                    "the sheet does not state what its values are",
                    expected="# value: error or correction",
                    found=values,
                )
            )
        address = self.generation.address(self._address())
        if not address or any(character.isspace() for character in address):
            self.faults.append(
                head.fault(
                    "the sheet does not name its axis",
                    expected="# address: X, or entry_X.csv",
                    found=address,
                )
            )
        most = self.generation.most_points
        if most is not None and len(self.points) > most:
            self.faults.append(
                head.fault(
                    "the sheet contains too many points",
                    expected=f"at most {most}",
                    found=str(len(self.points)),
                )
            )
        if len(self.faults) > before:
            return None
        columns = np.array(self.points, dtype=np.float64).reshape(-1, 2)
        return JudgedSheet(
            address=address,
            errors=values == "error",
            points=columns[:, 0],
            values=columns[:, 1],
            kind=self.kind,
            parameters=tuple(
                Parameter(quantity, address, value, unit, at)
                for quantity, value, unit, at in self.parameters
            ),
            place=head,
        )

    def _address(self) -> str:
        by_name = _FILE_NAME.fullmatch(self.file)
        return (
            self.comments.get("address")
            or self.comments.get("axis")
            or (by_name.group(1) if by_name else "")
        )


def _squeezed(line: str) -> str:
    return line.strip().replace(" ", "").lower()
