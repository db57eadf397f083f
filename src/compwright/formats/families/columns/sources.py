"""The files of a control with tables of its own (HEIDENHAIN), sorted: entry sheets, tables, the
line that is active, parameters.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, field_matches
from compwright.formats.families.columns.text import (
    ACTIVE,
    RESERVED,
    ROW_NUMBER,
    VALUES,
    Row,
    UserTable,
    is_user_table,
    read_table_text,
)
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.entry_sheet import EntrySheet, SheetRow, is_entry_sheet, read_sheet
from compwright.formats.text.texts import TextReader, text_reader
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile

#: Letters of the axes that the control counts from 1, where no job says more (X = 1 .. C = 6).
LETTERS = "XYZABC"
#: Quantities that are parameters of an axis, in the order in which they are entered.
PARAMETERS = ("backlash", "slope", "enabled")
_UNITS = {"mm": Decimal(1), "um": Decimal("0.001"), "deg": Decimal(1), "mm/m": Decimal(1)}
_COLUMN = re.compile(r"([0-9]{1,3})=F\(\)", re.IGNORECASE)
_ASSIGNED_COLUMN = re.compile(r"([0-9]{1,3})(?:=F\(\))?", re.IGNORECASE)
_MASK = re.compile(r"%([01]{1,32})|([0-9]{1,9})")


class AxisNumbers:
    """How the control counts its axes, from 1. A job's ``axis_number`` goes over the letters."""

    def __init__(self, definition: Definition, axes: Sequence[Axis]) -> None:
        said = {
            axis.axis_number: normal_address(definition, axis)[0]
            for axis in axes
            if axis.axis_number is not None
        }
        letters = {
            place: letter
            for place, letter in enumerate(LETTERS, start=1)
            if letter not in said.values()
        }
        self.by_number: Mapping[int, str] = {**letters, **said}

    def address(self, number: int) -> str:
        """Return the address of an axis; its number where nobody says which axis that is."""
        return self.by_number.get(number, str(number))

    def number(self, address: str) -> int | None:
        """Return the number of an axis, from 1; None where nobody says it."""
        return next((number for number, known in self.by_number.items() if known == address), None)


@dataclass(frozen=True, slots=True)
class Given:
    """A parameter of an axis as it was found: its text in the unit of its quantity. ``occurrence``:
    where it is in a text file.
    """

    text: str
    file: str
    place: str
    occurrence: Occurrence | None = None


@dataclass(frozen=True, slots=True)
class SheetPoint:
    """A point of an entry sheet, position in mm or deg, value in mm or deg as it stands there (an
    error or a correction).
    """

    position: Decimal
    value: Decimal
    line: int


@dataclass(slots=True)
class Sources:
    """What the files hold. ``tables``: by the moving axis, those that act; ``idle``: those that the
    active line does not name.

    ``missing``: the axis -> the table that the active line names and that was not given.
    ``active``: that line.
    """

    definition: Definition
    numbers: AxisNumbers
    sheets: dict[str, EntrySheet] = field(default_factory=dict)
    points: dict[str, tuple[SheetPoint, ...]] = field(default_factory=dict)
    units: dict[str, set[str]] = field(default_factory=dict)
    given: dict[tuple[str, str], list[Given]] = field(default_factory=dict)
    tables: dict[str, UserTable] = field(default_factory=dict)
    idle: list[UserTable] = field(default_factory=list)
    assignments: UserTable | None = None
    active: Row | None = None
    missing: dict[str, str] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)

    @property
    def numbered(self) -> bool:
        """Whether columns are named by axis numbers on an equally spaced grid; else by axis names,
        with listed positions.
        """
        return "datum" in self.definition.statements[VALUES].fields

    @property
    def starred(self) -> bool:
        """Whether a mark in the table of assignments says that its tables act; where axes have
        numbers a parameter says it.
        """
        return not self.numbered and self.active is not None

    def column_of(self, address: str) -> str:
        """Return the name of an axis' column in a table of values."""
        return f"{self.numbers.number(address)}=F()" if self.numbered else address

    def axis_of(self, column: str, *, assigned: bool = False) -> str:
        """Return the axis of a column in a table of values (or of assignments); its own name where
        it is no axis'.
        """
        match = (
            (_ASSIGNED_COLUMN if assigned else _COLUMN).fullmatch(column) if self.numbered else None
        )
        return self.numbers.address(int(match[1])) if match else column

    def own_column(self, address: str) -> str | None:
        """Return the name of the column that an axis has in its own table; None without one."""
        table = self.tables.get(address)
        name = self.column_of(address)
        return name if table is not None and table.column(name) is not None else None

    def mentioned(self) -> tuple[str, ...]:
        """Return every axis of which a file says something."""
        moved = [
            self.axis_of(column.name) for table in self.tables.values() for column in table.columns
        ]
        known = (
            *self.sheets,
            *(address for address, _ in self.given),
            *self.tables,
            *self.missing,
            *moved,
        )
        return tuple(name for name in dict.fromkeys(known) if name not in RESERVED)


def parameter_name(definition: Definition, quantity: str) -> str:
    """Return the control's name of a parameter (``MP710``): the first word of its line in the entry
    sheet.
    """
    return definition.statements[definition.bindings[quantity].statement].form.split(",")[0]


def find_sources(
    definition: Definition, files: Sequence[ControlFile], axes: Sequence[Axis], faults: list[Fault]
) -> Sources:
    """Return the files sorted; everything that is wrong with one of them, or between them, goes to
    ``faults``.
    """
    sources = Sources(definition, AxisNumbers(definition, axes))
    reader = text_reader(definition)
    tables: list[UserTable] = []
    for number, file in enumerate(files):
        if is_entry_sheet(file):
            _take_sheet(sources, file, faults)
        elif is_user_table(file):
            table = read_table_text(definition, file, faults)
            tables += [] if table is None else [table]
        else:
            _take_parameters(sources, reader, file, number, faults)
    if not faults:
        _activate(sources, tables, axes, faults)
    return sources


# --- entry sheets


def _take_sheet(sources: Sources, file: ControlFile, faults: list[Fault]) -> None:
    sheet = read_sheet(file, faults)
    if sheet is None:
        return
    known = len(faults)
    try:
        address = normal_text(sources.definition, sheet.axis)
    except UsageError as error:
        faults.extend(fault.in_file(file.name) for fault in error.faults)
        return
    if address in sources.sheets:
        other = sources.sheets[address].name
        faults.append(
            Fault(
                message=f"axis {address} has two entry sheets",
                file=file.name,
                expected="one",
                found=other,
            )
        )
        return
    names = {
        parameter_name(sources.definition, name): name
        for name in PARAMETERS
        if name in sources.definition.bindings
    }
    points: list[SheetPoint] = []
    for row in sheet.rows:
        if row.point in names:
            _take_parameter_row(sources, address, names[row.point], row, file.name, faults)
        elif re.fullmatch("[0-9]{1,6}", row.point) and row.position:
            points += _points(row, len(points), file.name, faults)
            sources.units.setdefault(address, set()).add(row.unit)
        else:
            expected = f"a point from 0 with its position, or {', '.join(names)} without one"
            faults.append(
                _at(row, file.name, "no point and no parameter is called so", expected, row.point)
            )
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
                )
            )
    if len(faults) == known:
        sources.sheets[address] = sheet
        sources.points[address] = tuple(points)


def _check_count(sheet: EntrySheet, found: int, faults: list[Fault]) -> None:
    """A sheet that says how many points it has is checked: a lost last line would otherwise go
    unnoticed.
    """
    said = sheet.comments.get("points")
    if said is not None and said != str(found):
        place = f"line {sheet.lines.get('points', 1)}"
        message = "the sheet does not hold as many points as it says; it may have been cut short"
        faults.append(
            Fault(
                message=message, file=sheet.name, place=place, expected=said[:60], found=str(found)
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


def _take_parameter_row(
    sources: Sources, address: str, quantity: str, row: SheetRow, file: str, faults: list[Fault]
) -> None:
    units = {"slope": ("mm/m",), "enabled": ("", "-", "bit")}.get(quantity, ("mm", "um", "deg"))
    if row.position:
        faults.append(_at(row, file, "a parameter has no position", "an empty cell", row.position))
    elif row.unit not in units:
        faults.append(
            _at(
                row,
                file,
                f"the unit of {row.point} is not known",
                " or ".join(units),
                row.unit or "nothing",
            )
        )
    elif quantity == "enabled" and Decimal(row.value) not in (0, 1):
        faults.append(_at(row, file, f"{row.point} of one axis is one bit", "0 or 1", row.value))
    else:
        text = row.value if quantity == "enabled" else f"{Decimal(row.value) * _UNITS[row.unit]:f}"
        sources.given.setdefault((address, quantity), []).append(
            Given(text, file, f"line {row.line}")
        )
        if quantity == "backlash":
            sources.units.setdefault(address, set()).add(row.unit)


def _at(row: SheetRow, file: str, message: str, expected: str, found: str) -> Fault:
    return Fault(
        message=message, file=file, place=f"line {row.line}", expected=expected, found=found[:60]
    )


# --- parameters as lines of text


def _take_parameters(
    sources: Sources, reader: TextReader, file: ControlFile, number: int, faults: list[Fault]
) -> None:
    definition = sources.definition
    known = len(faults)
    text = reader.read(file, faults, number)
    sources.findings.extend(text.findings if text is not None else ())
    lines = {
        statement.name: quantity
        for quantity in PARAMETERS
        if quantity in definition.bindings
        for statement in definition.statements.values()
        if statement.text == "parameters"
        and statement.form.startswith(parameter_name(definition, quantity))
    }
    found = [
        place
        for place in (text.occurrences if text is not None else ())
        if place.statement in lines
    ]
    if not found and len(faults) == known:
        kinds = "an entry sheet, or a table that begins with BEGIN"
        forms = [
            definition.statements[name].form.replace("{", "<").replace("}", ">") for name in lines
        ]
        faults.append(
            Fault(
                message=f"nothing in it is compensation data of {definition.id}",
                file=file.name,
                expected=f"{kinds}, or lines such as {', '.join(forms)}" if forms else kinds,
            )
        )
    for place in found:
        quantity = lines[place.statement]
        if quantity == "enabled":
            _take_mask(sources, place, faults)
        else:
            address = sources.numbers.address(int(place.tokens["number"].text) + 1)
            given = Given(place.tokens["value"].text, file.name, place.place, place)
            sources.given.setdefault((address, quantity), []).append(given)


def _take_mask(sources: Sources, place: Occurrence, faults: list[Fault]) -> None:
    text = place.tokens["value"].text
    mask = mask_of(text)
    if ambiguous(text):
        name = parameter_name(sources.definition, "enabled")
        message = (
            f"{name} is a mask or a decimal number: with these digits it can be read in two ways"
        )
        faults.append(
            Fault(
                message=message,
                file=place.file,
                place=place.place,
                expected=f"%{text}, or %{int(text):b}",
                found=text[:60],
            )
        )
        return
    if mask is None:
        faults.append(
            Fault(
                message="the bits cannot be read",
                file=place.file,
                place=place.place,
                expected="%00011, or 3",
                found=text[:60],
            )
        )
        return
    for number, address in sources.numbers.by_number.items():
        bit = str(mask >> (number - 1) & 1)
        sources.given.setdefault((address, "enabled"), []).append(
            Given(bit, place.file, place.place, place)
        )


def ambiguous(text: str) -> bool:
    """Whether bits without ``%`` could be meant as bits or as a decimal number, and these differ
    (``11``: 3 or 11).
    """
    return re.fullmatch("[01]{1,32}", text) is not None and int(text, 2) != int(text)


def mask_of(text: str) -> int | None:
    """Return a bit mask (``%00011`` or ``3``) as a number, bit 0 the first axis; None when it is
    none.
    """
    match = _MASK.fullmatch(text)
    if match is None:
        return None
    return int(match[1], 2) if match[1] else int(match[2])


# --- which table acts


def _activate(
    sources: Sources, tables: Sequence[UserTable], axes: Sequence[Axis], faults: list[Fault]
) -> None:
    values = [table for table in tables if table.kind == "values"]
    lines = [table for table in tables if table.kind == "assignments"]
    if len(lines) > 1:
        faults.append(
            Fault(
                message="several tables of assignments; only one can be the active one",
                file=", ".join(table.file for table in lines),
                expected="one .CMA",
            )
        )
        return
    if lines:
        sources.assignments = lines[0]
        sources.active = _active_row(sources, lines[0], faults)
        _assigned(sources, values, faults)
        return
    for table in values:
        address = _named_axis(sources, table, axes, faults)
        if address is None:
            continue
        if address in sources.tables:
            other = sources.tables[address].file
            faults.append(
                Fault(
                    message=f"two tables for axis {address}",
                    file=table.file,
                    expected="one",
                    found=other,
                )
            )
        sources.tables[address] = table
        sources.assumed[table.file] = address


def _active_row(sources: Sources, table: UserTable, faults: list[Fault]) -> Row | None:
    column = next((name for name in ACTIVE if table.column(name) is not None), None)
    if column is None:
        if len(table.rows) == 1 and sources.numbered:
            return table.rows[0]
        what = (
            "a column ACTIVE"
            if not sources.numbered
            else "a single line, or a column ACTIVE or STATUS"
        )
        faults.append(
            Fault(message="nothing says which line is active", file=table.file, expected=what)
        )
        return None
    marks = ("*", "M") if sources.numbered else ("*",)
    marked = [
        row for row in table.rows if column in row.cells and row.cells[column].text.upper() in marks
    ]
    if len(marked) > 1:
        faults.append(
            Fault(
                message="several lines are active",
                file=table.file,
                place=marked[1].place,
                expected=f"one {marks[0]} in {column}",
            )
        )
    if not marked and sources.numbered and len(table.rows) == 1:
        return table.rows[0]
    return marked[0] if marked else None


def bare_name(text: str) -> str:
    """Return the name of a table without folder and ending, in capitals."""
    return re.sub(r"\.(COM|CMO)$", "", re.split(r"[/\\:]", text)[-1].upper())


def _assigned(sources: Sources, values: Sequence[UserTable], faults: list[Fault]) -> None:
    cells = sources.active.cells if sources.active is not None else {}
    used: list[UserTable] = []
    for column, cell in cells.items():
        if column in (ROW_NUMBER, *ACTIVE):
            continue
        wanted = bare_name(cell.text)
        address = sources.axis_of(column, assigned=True)
        if address in sources.tables or address in sources.missing:
            file = sources.assignments.file if sources.assignments is not None else ""
            faults.append(
                Fault(
                    message=f"axis {address} stands in two columns",
                    file=file,
                    expected="one",
                    found=column,
                )
            )
        exact = [table for table in values if bare_name(table.file) == wanted]
        fitting = exact or [table for table in values if bare_name(table.name) == wanted]
        if len(fitting) > 1:
            names = ", ".join(table.file for table in fitting)
            faults.append(
                Fault(
                    message=f"axis {address}: several tables are called {cell.text}",
                    file=names,
                    expected="one",
                )
            )
        if fitting:
            sources.tables[address] = fitting[0]
            used.append(fitting[0])
        else:
            sources.missing[address] = cell.text
    sources.idle = [table for table in values if table not in used]


def _named_axis(
    sources: Sources, table: UserTable, axes: Sequence[Axis], faults: list[Fault]
) -> str | None:
    """Return the moving axis by the names of the table: that of its first line and that of its file
    must not contradict.
    """
    definition = sources.definition
    names = [
        name for name in (table.name, table.file.rpartition(".")[0]) if field_matches("name", name)
    ]
    addresses = list(dict.fromkeys(normal_text(definition, name) for name in names))
    axis_names = {
        *sources.numbers.by_number.values(),
        *(normal_address(definition, axis)[0] for axis in axes),
    }
    if not sources.numbered:
        axis_names |= {column.name for column in table.columns if column.name not in RESERVED}
    fitting = [address for address in addresses if address in axis_names]
    if len(fitting) != 1:
        faults.append(
            Fault(
                message="nothing says which axis moves when this table acts",
                file=table.file,
                place="line 1",
                expected="the .CMA too, or a table that is called like its axis",
                found=" and ".join(fitting or names) or table.name,
            )
        )
        return None
    return fitting[0]
