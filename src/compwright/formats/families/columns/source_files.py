"""Sort the files of a control with user-made tables (HEIDENHAIN), and read their points and
parameters for each axis.

Points are in entry sheets. Parameters are in entry sheets or in lines of a text, partly as bit
masks.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, readable
from compwright.formats.families.columns.active_tables import activate
from compwright.formats.families.columns.sources import PARAMETERS, AxisNumbers, SheetPoint, Sources
from compwright.formats.families.columns.table import UserTable
from compwright.formats.families.columns.table_reading import is_user_table, read_table_text
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.entry_sheet import EntrySheet, SheetRow, is_entry_sheet, read_sheet
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.texts import TextReader, text_reader
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile

_UNITS = {"mm": Decimal(1), "um": Decimal("0.001"), "deg": Decimal(1), "mm/m": Decimal(1)}


def take_sheet(sources: Sources, file: ControlFile, number: int, faults: list[Fault]) -> None:
    """Add the table points and parameters of an entry sheet to ``sources``. ``number``: the index
    of this file among all files; ``faults``: the list that gets the sheet's errors.
    """
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
                    message="the positions of the entry sheet do not ascend",
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
    """Add an entry sheet's parameters to ``sources``, and return the table points of the sheet.
    ``number``: the index of this file among all files.
    """
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
    """Compare the number of points in an entry sheet with the count that the sheet states, because
    the last lines of a sheet can be lost.
    """
    text = sheet.comments.get("points")
    if text is not None and text != str(found):
        place = f"line {sheet.lines.get('points', 1)}"
        faults.append(
            Fault(
                message="the entry sheet contains fewer or more points than it states, so it "
                "may have been cut off",
                file=sheet.name,
                place=place,
                expected=f"{text[:60]} points",
                found=str(found),
                hint="give the whole sheet; if no point is missing, correct the number here",
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


_MASK = re.compile(r"%([01]{1,32})|([0-9]{1,9})")


def take_parameters(
    sources: Sources, reader: TextReader, file: ControlFile, number: int, faults: list[Fault]
) -> None:
    """Add the parameters in a text file to ``sources``. ``number``: the index of this file among
    all files; ``faults``: the list that gets the file's errors.
    """
    known = len(faults)
    text = reader.read(file, faults, number)
    sources.findings.extend(text.findings if text is not None else ())
    lines = _parameter_lines(sources.definition)
    found = [
        place
        for place in (text.occurrences if text is not None else ())
        if place.statement in lines
    ]
    if not found and len(faults) == known:
        faults.append(_nothing(sources.definition, file, lines))
    for place in found:
        quantity = lines[place.statement]
        if quantity == "enabled":
            _take_mask(sources, place, number, faults)
        else:
            address = sources.numbers.address(int(place.tokens["number"].text) + 1)
            given = FoundValue(place.tokens["value"].text, place, number)
            sources.given.setdefault((address, quantity), []).append(given)


def _parameter_lines(definition: Definition) -> dict[str, str]:
    """Return, by the name of each statement that contains a parameter, the quantity that this
    parameter is.
    """
    return {
        statement.name: quantity
        for quantity in PARAMETERS
        if quantity in definition.bindings
        for statement in definition.statements.values()
        if statement.text == "parameters"
        and statement.form.startswith(name_of(definition, quantity))
    }


def _nothing(definition: Definition, file: ControlFile, lines: Iterable[str]) -> Fault:
    kinds = "an entry sheet, or a table that begins with BEGIN"
    forms = [readable(definition.statements[name].form) for name in lines]
    return Fault(
        message=f"the file contains no compensation data of {definition.id}",
        file=file.name,
        expected=f"{kinds}, or lines such as {', '.join(forms)}" if forms else kinds,
        hint=(
            "give the file with tables or compensation parameters of this control, or "
            "correct `format`"
        ),
    )


def _take_mask(sources: Sources, place: Occurrence, file: int, faults: list[Fault]) -> None:
    text = place.tokens["value"].text
    mask = mask_of(text)
    if ambiguous(text):
        name = name_of(sources.definition, "enabled")
        faults.append(
            Fault(
                message=f"{name} can be read in two ways with these digits, as a bit mask or as "
                "a decimal number",
                file=place.file,
                place=place.place,
                expected=f"%{text}, or %{int(text):b}",
                found=text[:60],
                hint=(
                    "correct the bits in a copy of this file, or export it from the control again"
                ),
            )
        )
        return
    if mask is None:
        faults.append(
            Fault(
                message="the bits in this line cannot be read",
                file=place.file,
                place=place.place,
                expected="%00011, or 3",
                found=text[:60],
                hint=(
                    "correct the bits in a copy of this file, or export it from the control again"
                ),
            )
        )
        return
    for number, address in sources.numbers.by_number.items():
        bit = str(mask >> (number - 1) & 1)
        sources.given.setdefault((address, "enabled"), []).append(FoundValue(bit, place, file))


def ambiguous(text: str) -> bool:
    """Return whether digits without ``%`` mean different numbers as bits and as decimals: ``11`` is
    3 or 11.
    """
    return re.fullmatch("[01]{1,32}", text) is not None and int(text, 2) != int(text)


def mask_of(text: str) -> int | None:
    """Return a bit mask (``%00011`` or ``3``) as a number, bit 0 the first axis; None for other
    text.
    """
    match = _MASK.fullmatch(text)
    if match is None:
        return None
    return int(match[1], 2) if match[1] else int(match[2])


def find_sources(
    definition: Definition, files: Sequence[ControlFile], axes: Sequence[Axis], faults: list[Fault]
) -> Sources:
    """Return tables, sheets and parameters in the files; errors are added to ``faults``."""
    sources = Sources(definition, AxisNumbers(definition, axes))
    reader = text_reader(definition)
    tables: list[UserTable] = []
    for number, file in enumerate(files):
        if is_entry_sheet(file):
            take_sheet(sources, file, number, faults)
        elif is_user_table(file):
            table = read_table_text(definition, file, faults)
            tables += [] if table is None else [table]
        else:
            take_parameters(sources, reader, file, number, faults)
    if not faults:
        activate(sources, tables, axes, faults)
    return sources
