"""Numbers of a user's tables -> positions and corrections in mm or deg: unit, sign, datum and
spacing, blank cells, one turn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import TABLE_VALUES
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Token
from compwright.formats.families.columns.sources import Sources
from compwright.formats.families.columns.table import POSITION, Row, UserTable, is_number
from compwright.formats.families.family import Family
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale, in_range
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, AxisKind, FloatArray

#: Of a table of a rotary axis only the entries from 0 to 360 degrees are used (TNC 407 technical
#: manual p156).
TURN = 360.0
_INCH = Decimal("25.4")


def fitting_rule(options: Mapping[str, object], text: str) -> Decimal | None:
    """Return the spacing in mm or deg that the first line of a table says; None when it is not one
    by the option spacing_rule.
    """
    if not is_number(text):
        return None
    number = Decimal(text)
    if options.get("spacing_rule") != "power_of_two":
        return number if number > 0 else None
    whole = number == number.to_integral_value() and 0 <= number <= MOST_DOUBLINGS
    return 2 ** int(number) * SMALLEST_SPACING if whole else None


#: The spacing is 2^n times this, n from 0 to MOST_DOUBLINGS (TNC 407 technical manual p153; the
#: largest n: TNC 306/360 p121).
SMALLEST_SPACING = Decimal("0.0001")
MOST_DOUBLINGS = 23


def kind_by_letter(address: str) -> AxisKind:
    """Return the kind that an axis of this name usually has: A, B and C turn."""
    return AxisKind.ROTARY if address.upper() in ("A", "B", "C") else AxisKind.LINEAR


def column_scale(definition: Definition, kind: AxisKind, options: Mapping[str, object]) -> Scale:
    """Return how numbers of an axis are written: table values as its option ``table_values``
    says.
    """
    return Scale(definition, kind, options, {"table_form": str(options[TABLE_VALUES])})


class TableValues:
    """Reads the numbers of tables by the axis that moves; what is wrong goes to the notes.
    ``axes``: what a job knows of them.
    """

    def __init__(
        self, control: Family, sources: Sources, axes: Mapping[str, Axis], notes: Notes
    ) -> None:
        self.control = control
        self.definition = control.definition
        self.sources = sources
        self.axes = axes
        self.notes = notes

    def own_options(self, address: str) -> Mapping[str, object]:
        """Return the options of an axis: its own over the controller's; what its entry sheet says
        of values goes over both.
        """
        axis = self.axes.get(address)
        options = self.control.options if axis is None else self.control.options_of(axis)
        sheet = self.sources.sheets.get(address)
        return options if sheet is None else {**options, TABLE_VALUES: sheet.comments["value"]}

    def scale(self, address: str, kind: AxisKind | None = None) -> Scale:
        """Return how the numbers of an axis are read; ``kind``: of what its table corrects, where
        that is not the axis itself.
        """
        return column_scale(self.definition, kind or self.kind(address), self.own_options(address))

    def kind(self, address: str) -> AxisKind:
        """Return whether an axis is linear or rotary: by the job, by the units of its sheet, else
        by its letter.
        """
        units = self.sources.units.get(address, set())
        by_sheet = AxisKind.ROTARY if "deg" in units else AxisKind.LINEAR
        known = self.axes[address].kind if address in self.axes else by_sheet if units else None
        if units and (known is not by_sheet or len({unit == "deg" for unit in units}) > 1):
            fault = Fault(
                message=(
                    f"axis {address}: the units of the entry sheet contradict the kind of the axis"
                    " or each other"
                ),
                file=self.sources.sheets[address].name if address in self.sources.sheets else "",
                expected=f"{known.unit if known else 'one kind of unit'}",
                found=", ".join(sorted(units)),
            )
            self.notes.faults += [] if fault in self.notes.faults else [fault]
        if known is None:
            known = kind_by_letter(address)
            self.notes.assume(f"axis {address}: kind", known, "inferred from the name of the axis")
        return known

    def positions(self, table: UserTable, address: str) -> tuple[Decimal, ...] | None:
        """Return the positions of a table's rows in mm or deg; None when something is wrong with
        them.
        """
        kind = self.kind(address)
        scale = self.scale(address, kind)
        factor = self._factor(table, kind)
        if not self.sources.numbered:
            found = [self._position_cell(table, row) for row in table.rows]
            if None in found:
                return None
            positions = [
                scale.read("node_position", cell.text) * factor
                for cell in found
                if cell is not None
            ]
        else:
            datum, step = table.head["datum"], table.head["spacing"]
            spacing = fitting_rule(self.own_options(address), step.text)
            if (
                table.head["unit"].text.upper() == "INCH"
                and self.own_options(address).get("spacing_rule") == "power_of_two"
            ):
                self._fault(
                    table,
                    1,
                    "whether the exponent of a table in inch counts inches is not known",
                    "a table in mm",
                    "INCH",
                )
                return None
            if spacing is None or not is_number(datum.text):
                what = f"DATUM:{datum.text} DIST:{step.text}"
                self._fault(
                    table,
                    1,
                    "datum and spacing cannot be read by the option spacing_rule",
                    "such as DATUM:-400 DIST:16",
                    what,
                )
                return None
            positions = [
                (Decimal(datum.text) + number * spacing) * factor
                for number in range(len(table.rows))
            ]
        return self._checked(table, positions, scale)

    def _position_cell(self, table: UserTable, row: Row) -> Token | None:
        cell = row.cells.get(POSITION)
        if cell is not None and is_number(cell.text):
            return cell
        self._fault(
            table,
            row.line,
            f"the row has no position in {POSITION}",
            "a number",
            cell.text if cell else "nothing",
        )
        return None

    def _checked(
        self, table: UserTable, positions: list[Decimal], scale: Scale
    ) -> tuple[Decimal, ...] | None:
        for row, position, before in zip(
            table.rows, positions, [None, *positions[:-1]], strict=True
        ):
            if before is not None and position <= before:
                self._fault(
                    table,
                    row.line,
                    "the positions do not ascend",
                    f"more than {before}",
                    str(position),
                )
                return None
            if not in_range(self.definition.measure("node_position"), scale, position):
                self._fault(
                    table,
                    row.line,
                    "a position this large is not plausible",
                    "see formats show",
                    str(position),
                )
                return None
        most = self.definition.limit_number("max_points")
        if most is not None and len(positions) > most:
            self._fault(
                table,
                table.rows[most].line,
                "more rows than the control takes",
                f"at most {most}",
                str(len(positions)),
            )
            return None
        return tuple(positions)

    def values(
        self, table: UserTable, name: str, positions: Sequence[Decimal], output: str, moving: str
    ) -> FloatArray | None:
        """Return the corrections (k,) of a column in mm or deg; None for a blank column or a faulty
        one.

        A blank cell between two others lies on the straight line between them; at an end of the
        table it is a fault.
        """
        cells = [row.cells.get(name) for row in table.rows]
        if not any(cells):
            return None
        known = len(self.notes.faults)
        kind = self.kind(output)
        scale = self.scale(moving, kind)
        numbers: list[float] = []
        for row, cell in zip(table.rows, cells, strict=True):
            if cell is None:
                if row in (table.rows[0], table.rows[-1]):
                    self._fault(
                        table,
                        row.line,
                        f"the column {name} is blank at an end of the table",
                        "a number",
                        "nothing",
                    )
            elif not is_number(cell.text):
                self._fault(
                    table,
                    row.line,
                    f"the column {name} holds no number",
                    "a decimal number",
                    cell.text,
                )
            else:
                value = scale.read("value", cell.text) * self._factor(table, kind)
                if not in_range(self.definition.measure("value"), scale, value):
                    self._fault(
                        table,
                        row.line,
                        f"column {name}: a value this large is not plausible",
                        "see formats show",
                        cell.text,
                    )
                numbers.append(float(value) + 0.0)
        if len(self.notes.faults) > known:
            return None
        where = np.array([float(position) for position in positions])
        filled = np.array([cell is not None for cell in cells])
        curve: FloatArray = np.interp(where, where[filled], np.array(numbers))
        return curve

    def _factor(self, table: UserTable, kind: AxisKind) -> Decimal:
        inch = table.head["unit"].text.upper() == "INCH" and kind is AxisKind.LINEAR
        return _INCH if inch else Decimal(1)

    def turned(
        self, address: str, positions: FloatArray, values: FloatArray, file: str
    ) -> tuple[FloatArray, FloatArray, float | None]:
        """Return nodes, values and period of a table: of a rotary axis only 0 to 360 degrees act,
        again in every turn.
        """
        axis = self.axes.get(address)
        if self.kind(address) is AxisKind.LINEAR:
            return positions, values, None
        endless = axis is not None and axis.modulo is not None
        if endless and axis is not None and axis.modulo != TURN:
            self.notes.faults.append(
                Fault(
                    message=f"axis {address}: one turn of a rotary axis is 360 degrees here",
                    file=file,
                    found=f"{axis.modulo:g}",
                )
            )
        if not endless and not (positions[0] <= 0 and positions[-1] >= TURN):
            if positions[0] < 0 or positions[-1] > TURN:
                self.notes.faults.append(
                    Fault(
                        message=(
                            f"axis {address}: of a rotary axis only 0 to 360 degrees are used; what"
                            " lies outside would be dropped without a word"
                        ),
                        file=file,
                        expected="0 to 360 degrees",
                        found=f"{positions[0]:g} to {positions[-1]:g}",
                    )
                )
            return positions, values, None
        inside = positions[(positions > 0) & (positions < TURN)]
        nodes = np.concatenate([[0.0], inside, [TURN]])
        curve = np.interp(nodes, positions, values)
        if curve[0] != curve[-1]:
            self.notes.find(
                "CW-S017",
                "warning",
                f"axis {address}: the table of {file} ends its turn with another value than it"
                " began with",
            )
        return nodes, curve, TURN

    def fault(self, file: str, place: str, message: str, expected: str, found: str) -> None:
        """Note a fault once."""
        fault = Fault(message=message, file=file, place=place, expected=expected, found=found[:60])
        self.notes.faults += [] if fault in self.notes.faults else [fault]

    def _fault(self, table: UserTable, line: int, message: str, expected: str, found: str) -> None:
        self.fault(table.file, f"line {line}", message, expected, found)
