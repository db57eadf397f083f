"""The contents of the files of a control with user-made tables (HEIDENHAIN), sorted by axis."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.table import RESERVED, VALUES, Row, UserTable
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.entry_sheet import EntrySheet
from compwright.formats.text.gathering import FoundValue
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis

#: Letters of the axes that the control counts from 1, where no job says more (X = 1 .. C = 6).
LETTERS = "XYZABC"
#: Quantities that are parameters of an axis, in the order in which they are entered.
PARAMETERS = ("backlash", "slope", "enabled")
#: An axis that goes by its number.
_BY_NUMBER = re.compile(r"AX([1-9][0-9]?)$")
_COLUMN = re.compile(r"([0-9]{1,3})=F\(\)", re.IGNORECASE)
_ASSIGNED_COLUMN = re.compile(r"([0-9]{1,3})(?:=F\(\))?", re.IGNORECASE)


class AxisNumbers:
    """The axis numbers of a control, from 1, and the axis addresses that belong to them.

    By default the numbers follow the letters X, Y, Z, A, B, C. An ``axis_number`` in the job has
    priority over this order. So has a synchronised axis that the job names by its number (AX4).
    """

    def __init__(self, definition: Definition, axes: Sequence[Axis]) -> None:
        numbers = {
            axis.axis_number: normal_address(definition, axis)[0]
            for axis in axes
            if axis.axis_number is not None
        }
        gantries = (axis.gantry for axis in axes if axis.gantry is not None)
        numbers |= {int(found[1]): found[0] for one in gantries if (found := _BY_NUMBER.match(one))}
        self.stated = frozenset(numbers)
        letters = {
            place: letter
            for place, letter in enumerate(LETTERS, start=1)
            if letter not in numbers.values()
        }
        self.by_number: Mapping[int, str] = {**letters, **numbers}

    def address(self, number: int) -> str:
        """Return the address of an axis by its number, or the number as text if unknown."""
        return self.by_number.get(number, str(number))

    def follower(self, number: int, known: Collection[str]) -> str:
        """Return the address of an axis that moves with another axis, given by its number.
        ``known``: addresses of the axes that the job names.

        An unknown axis has the address AX with its number, such as AX4. So has an axis whose
        assumed letter is that of a rotary axis which the job does not name.
        """
        letter = self.address(number)
        assumed = self.by_number.get(number) == letter and number not in self.stated
        return f"AX{number}" if assumed and letter in "ABC" and letter not in known else letter

    def number(self, address: str) -> int | None:
        """Return the number, from 1, of the axis at an address; the address itself if it is a
        number, None if the axis is unknown.
        """
        own = int(address) if address.isdigit() else None
        return next((number for number, known in self.by_number.items() if known == address), own)


@dataclass(frozen=True, slots=True)
class SheetPoint:
    """A point of an entry sheet: position and value in mm or deg. The value is an error or a
    correction, as the sheet states.
    """

    position: Decimal
    value: Decimal
    line: int


@dataclass(slots=True)
class Sources:
    """The contents of the files: tables, entry sheets and parameters.

    ``tables``: the active tables, by moving axis. ``active``: the line of the .CMA file that names
    the active tables. ``idle``: tables that this line does not name. ``missing``: by axis, the name
    of a table that this line names and that was not given. ``given``: parameters by axis and
    quantity, in the unit of the quantity; a parameter from an entry sheet has no tokens.
    """

    definition: Definition
    numbers: AxisNumbers
    sheets: dict[str, EntrySheet] = field(default_factory=dict)
    points: dict[str, tuple[SheetPoint, ...]] = field(default_factory=dict)
    units: dict[str, set[str]] = field(default_factory=dict)
    given: dict[tuple[str, str], list[FoundValue]] = field(default_factory=dict)
    tables: dict[str, UserTable] = field(default_factory=dict)
    idle: list[UserTable] = field(default_factory=list)
    assignments: UserTable | None = None
    active: Row | None = None
    missing: dict[str, str] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)

    @property
    def numbered(self) -> bool:
        """Whether the tables of this control name their columns by axis number (and have equal
        spacing), not by axis name.
        """
        return "datum" in self.definition.statements[VALUES].fields

    @property
    def starred(self) -> bool:
        """Whether a mark in the .CMA file activates tables, and not a parameter of the control."""
        return not self.numbered and self.active is not None

    @property
    def assigned(self) -> tuple[str, ...]:
        """The axes in whose columns the active line of the .CMA file names a table or none."""
        if self.assignments is None or self.active is None:
            return ()
        return tuple(self.axis_of(one.name, assigned=True) for one in self.assignments.columns)

    def column_of(self, address: str) -> str:
        """Return the name that an axis' column has in every table of values."""
        return f"{self.numbers.number(address)}=F()" if self.numbered else address

    def axis_of(self, column: str, *, assigned: bool = False) -> str:
        """Return the address of the axis that a table column corrects; for a column without an axis
        number, its name. ``assigned``: the column is in the table that assigns tables to axes.
        """
        match = (
            (_ASSIGNED_COLUMN if assigned else _COLUMN).fullmatch(column) if self.numbered else None
        )
        return self.numbers.address(int(match[1])) if match else column

    def own_column(self, address: str) -> str | None:
        """Return the name of an axis' column in the table that follows the same axis; None if there
        is no such table or column.
        """
        table = self.tables.get(address)
        name = self.column_of(address)
        return name if table is not None and table.column(name) is not None else None

    def mentioned(self) -> tuple[str, ...]:
        """Return every axis that any file mentions."""
        moved = [
            self.axis_of(column.name) for table in self.tables.values() for column in table.columns
        ]
        known = (
            *self.sheets,
            *(address for address, _ in self.given),
            *self.tables,
            *self.missing,
            *moved,
            *self.assigned,
        )
        return tuple(name for name in dict.fromkeys(known) if name not in RESERVED)
