"""Entry sheets -> the points and parameters of their axes."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from decimal import Decimal

from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.columns.sources import PARAMETERS, SheetPoint, Sources
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.entry_sheet import EntrySheet, SheetRow, read_sheet
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault, UsageError
from compwright.records.correction import ControlFile

_UNITS = {"mm": Decimal(1), "um": Decimal("0.001"), "deg": Decimal(1), "mm/m": Decimal(1)}


def take_sheet(sources: Sources, file: ControlFile, number: int, faults: list[Fault]) -> None:
    """Add the contents of a sheet to the sources; ``number``: its index among the files."""
    sheet = read_sheet(file, faults)
    address = None if sheet is None else _address(sources, sheet, faults)
    if sheet is None or address is None:
        return
    known = len(faults)
    points = _rows(sources, address, sheet, number, faults)
    _check_count(sheet, len(points), faults)
    for before, after in itertools.pairwise(points):
        if after.position <= before.position:
            faults.append(
                Fault(
                    message="the positions do not ascend",
                    file=file.name,
                    place=f"line {after.line}",
                    expected=f"more than {before.position}",
                    found=str(after.position),
                    hint="sort the rows by position",
                )
            )
    if len(faults) == known:
        sources.sheets[address] = sheet
        sources.points[address] = tuple(points)


def _address(sources: Sources, sheet: EntrySheet, faults: list[Fault]) -> str | None:
    try:
        address = normal_text(sources.definition, sheet.axis)
    except UsageError as error:
        faults.extend(fault.in_file(sheet.name) for fault in error.faults)
        return None
    if address not in sources.sheets:
        return address
    faults.append(
        Fault(
            message=f"axis {address} has two entry sheets",
            file=sheet.name,
            expected="one",
            found=sources.sheets[address].name,
            hint="keep one of the two files",
        )
    )
    return None


def _rows(
    sources: Sources, address: str, sheet: EntrySheet, number: int, faults: list[Fault]
) -> list[SheetPoint]:
    """Add the parameters of a sheet to the sources and return its points."""
    definition = sources.definition
    names = {name_of(definition, name): name for name in PARAMETERS if name in definition.bindings}
    points: list[SheetPoint] = []
    for row in sheet.rows:
        if row.point in names:
            found = _parameter(names[row.point], row, sheet.name, number, faults)
            if found is not None:
                _give(sources, address, names[row.point], row.unit, found)
        elif re.fullmatch("[0-9]{1,6}", row.point) and row.position:
            points += _points(row, len(points), sheet.name, faults)
            sources.units.setdefault(address, set()).add(row.unit)
        else:
            expected = f"a point from 0 with its position, or {', '.join(names)} without one"
            message = "no point and no parameter is called so"
            faults.append(_at(row, sheet.name, message, expected, row.point))
    return points


def _check_count(sheet: EntrySheet, found: int, faults: list[Fault]) -> None:
    """Check the number of points against the count in the sheet: a lost last line would go
    unnoticed.
    """
    text = sheet.comments.get("points")
    if text is not None and text != str(found):
        place = f"line {sheet.lines.get('points', 1)}"
        message = "the sheet does not hold as many points as it says; it may have been cut short"
        faults.append(
            Fault(
                message=message,
                file=sheet.name,
                place=place,
                expected=text[:60],
                found=str(found),
                hint="correct this line of the entry sheet",
            )
        )


def _points(row: SheetRow, expected: int, file: str, faults: list[Fault]) -> Iterator[SheetPoint]:
    if int(row.point) != expected:
        faults.append(
            _at(
                row, file, "the points are not numbered one by one from 0", str(expected), row.point
            )
        )
    elif row.unit not in ("mm", "um", "deg"):
        faults.append(
            _at(
                row,
                file,
                "the unit of a point is not known",
                "mm, um or deg",
                row.unit or "nothing",
            )
        )
    else:
        yield SheetPoint(Decimal(row.position), Decimal(row.value) * _UNITS[row.unit], row.line)


def _give(sources: Sources, address: str, quantity: str, unit: str, found: FoundValue) -> None:
    sources.given.setdefault((address, quantity), []).append(found)
    if quantity == "backlash":
        sources.units.setdefault(address, set()).add(unit)


def _parameter(
    quantity: str, row: SheetRow, file: str, number: int, faults: list[Fault]
) -> FoundValue | None:
    units = {"slope": ("mm/m",), "enabled": ("", "-", "bit")}.get(quantity, ("mm", "um", "deg"))
    if row.position:
        faults.append(_at(row, file, "a parameter has no position", "an empty cell", row.position))
    elif row.unit not in units:
        message = f"the unit of {row.point} is not known"
        faults.append(_at(row, file, message, " or ".join(units), row.unit or "nothing"))
    elif quantity == "enabled" and Decimal(row.value) not in (0, 1):
        faults.append(_at(row, file, f"{row.point} of one axis is one bit", "0 or 1", row.value))
    else:
        text = row.value if quantity == "enabled" else f"{Decimal(row.value) * _UNITS[row.unit]:f}"
        return FoundValue(text, Occurrence(quantity, file, row.line, {}), number)
    return None


def _at(row: SheetRow, file: str, message: str, expected: str, found: str) -> Fault:
    return Fault(
        message=message,
        file=file,
        place=f"line {row.line}",
        expected=expected,
        found=found[:60],
        hint="correct this line of the entry sheet",
    )
