"""Convert the numbers of a user's table to positions and corrections in mm or deg.

The conversion applies unit, sign, datum and spacing, fills blank cells, and brings rotary axes to
one turn.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import known_kind
from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.sources import Sources
from compwright.formats.families.columns.table import POSITION, Row, UserTable, is_number
from compwright.formats.families.family import Family
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import NumberScale, in_range
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.options import TABLE_VALUES
from compwright.words.sentences import control_text

#: Of a table of a rotary axis only the entries from 0 to 360 degrees are used (TNC 407 technical
#: manual p156).
TURN = 360.0
_INCH = Decimal("25.4")


def fitting_rule(options: Mapping[str, object], text: str) -> Decimal | None:
    """Return the spacing, mm or deg, that a table's first line states; None if it is not valid."""
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


_LETTERS = frozenset("XYZUVWABC")


def column_scale(
    definition: Definition, kind: AxisKind, options: Mapping[str, object]
) -> NumberScale:
    """Return unit, sign and resolution of an axis' table values by its option ``table_values``."""
    return NumberScale(definition, kind, options, {"table_form": str(options[TABLE_VALUES])})


class TableValues:
    """Reads the numbers in the tables of each moving axis. Errors in the files are added to
    ``notes``.

    ``axes``: the axes of the job, by address.
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
        """Return the options of an axis; its entry sheet has priority over its options in the job,
        and these over the controller's options.
        """
        axis = self.axes.get(address)
        options = self.control.options if axis is None else self.control.options_of(axis)
        sheet = self.sources.sheets.get(address)
        return options if sheet is None else {**options, TABLE_VALUES: sheet.comments["value"]}

    def scale(self, address: str, kind: AxisKind | None = None) -> NumberScale:
        """Return unit, sign and resolution of an axis' numbers.

        ``kind``: the kind of the corrected axis, if the table corrects another axis.
        """
        return column_scale(self.definition, kind or self.kind(address), self.own_options(address))

    def kind(self, address: str) -> AxisKind:
        """Return the kind of an axis (linear, rotary) by the job, else by the units in its entry
        sheet, else by an option or the axis letter.
        """
        units = self.sources.units.get(address, set())
        by_sheet = AxisKind.ROTARY if "deg" in units else AxisKind.LINEAR
        known = self.axes[address].kind if address in self.axes else by_sheet if units else None
        if units and (known is not by_sheet or len({unit == "deg" for unit in units}) > 1):
            fault = Fault(
                message=(
                    f"axis {address}: the units of the entry sheet contradict each other, or the"
                    " kind (linear or rotary) of the axis"
                ),
                file=self.sources.sheets[address].name if address in self.sources.sheets else "",
                expected=f"{known.unit if known else 'one kind of unit'}",
                found=", ".join(sorted(units)),
                hint="correct the units of the sheet, or `kind` of the axis in the job",
            )
            self.notes.once(fault)
        if known is None:
            known = known_kind(self.control.options, address)
        if known is None:
            rotary = address.upper() in ("A", "B", "C")
            known = AxisKind.ROTARY if rotary else AxisKind.LINEAR
            self.notes.assume(
                control_text("axis {name}: kind", name=address),
                known,
                control_text("inferred from the name of the axis"),
            )
        return known

    def stated_kind(self, address: str) -> AxisKind | None:
        """Return the kind of an axis by its entry sheet or letter (DIN 66217: A, B, C rotary); else
        None.
        """
        known = bool(self.sources.units.get(address)) or address.upper() in _LETTERS
        return self.kind(address) if known else None

    def positions(self, table: UserTable, address: str) -> tuple[Decimal, ...] | None:
        """Return the positions of a table's rows in mm or deg; None if they contain errors."""
        kind = self.kind(address)
        scale = self.scale(address, kind)
        found = (
            self._spaced(table, address) if self.sources.numbered else self._listed(table, scale)
        )
        if found is None:
            return None
        factor = self.factor(table, kind)
        self._uneven(table, found)
        return self._checked(table, [position * factor for position in found], scale)

    def _uneven(self, table: UserTable, found: Sequence[Decimal]) -> None:
        """Report a table whose points are not equally spaced; its positions are used as they are
        written.

        The control requires equal spacing (MANUALplus 620 technical manual p715). Its behaviour
        with other tables is not known.
        """
        steps = {after - before for before, after in itertools.pairwise(found)}
        if len(steps) > 1:
            self.notes.find(
                "CW-S046", "warning", file=table.file, least=min(steps), most=max(steps)
            )

    def _listed(self, table: UserTable, scale: NumberScale) -> list[Decimal] | None:
        """Return the positions that the rows of a table state, in the unit of the table; None if a
        row states no position.
        """
        positions = []
        for row in table.rows:
            cell = row.cells.get(POSITION)
            if cell is not None and is_number(cell.text):
                positions.append(scale.read("node_position", cell.text))
            else:
                message = f"the row has no position in {POSITION}"
                self._fault(table, row.line, message, "a number", cell.text if cell else "nothing")
        return positions if len(positions) == len(table.rows) else None

    def _spaced(self, table: UserTable, address: str) -> list[Decimal] | None:
        """Return the rows' positions from the first line (first position, spacing), in the table's
        unit.
        """
        datum, step = table.head["datum"], table.head["spacing"]
        options = self.own_options(address)
        inch = table.head["unit"].text.upper() == "INCH"
        if inch and options.get("spacing_rule") == "power_of_two":
            message = "whether the exponent of a table in inch counts inches is not known"
            self._fault(table, 1, message, "a table in mm", "INCH")
            return None
        spacing = fitting_rule(options, step.text)
        if spacing is None or not is_number(datum.text):
            message = "datum and spacing cannot be read by the option spacing_rule"
            what = f"DATUM:{datum.text} DIST:{step.text}"
            self._fault(table, 1, message, "such as DATUM:-400 DIST:16", what)
            return None
        return [Decimal(datum.text) + number * spacing for number in range(len(table.rows))]

    def _checked(
        self, table: UserTable, positions: list[Decimal], scale: NumberScale
    ) -> tuple[Decimal, ...] | None:
        point = self.definition.measure("node_position")
        for row, position, before in zip(
            table.rows, positions, [None, *positions[:-1]], strict=True
        ):
            why = expected = ""
            if before is not None and position <= before:
                why, expected = "the positions do not ascend", f"more than {before}"
            elif not in_range(point, scale, position):
                why, expected = "a position this large is not plausible", "see formats show"
            if why:
                self._fault(table, row.line, why, expected, str(position))
                return None
        most = self.definition.limit_number("max_points")
        if most is not None and len(positions) > most:
            line, found = table.rows[most].line, str(len(positions))
            self._fault(
                table,
                line,
                "the table has more rows than the control accepts",
                f"at most {most}",
                found,
            )
            return None
        return tuple(positions)

    def values(
        self, table: UserTable, name: str, positions: Sequence[Decimal], output: str, moving: str
    ) -> FloatArray | None:
        """Return the corrections (k,) of the axis ``output`` in a table column, mm or deg, at the
        ``positions`` of the axis ``moving``. The result is None for a blank or faulty column.

        A blank cell between two others is interpolated linearly. A blank cell at an end of the
        table is a fault.
        """
        cells = [row.cells.get(name) for row in table.rows]
        if not any(cells):
            return None
        known = len(self.notes.faults)
        scale = self.scale(moving, self.kind(output))
        ends = (table.rows[0], table.rows[-1])
        numbers: list[float] = []
        for row, cell in zip(table.rows, cells, strict=True):
            if cell is not None:
                numbers += self._value(table, row, f"column {name}", cell.text, scale)
            elif row in ends:
                message = f"the column {name} is blank at an end of the table"
                self._fault(table, row.line, message, "a number", "nothing")
        if len(self.notes.faults) > known:
            return None
        where = np.array([float(position) for position in positions])
        filled = np.array([cell is not None for cell in cells])
        curve: FloatArray = np.interp(where, where[filled], np.array(numbers))
        return curve

    def _value(
        self, table: UserTable, row: Row, column: str, text: str, scale: NumberScale
    ) -> Iterator[float]:
        if not is_number(text):
            message = f"the {column} contains no number"
            self._fault(table, row.line, message, "a decimal number", text)
            return
        value = scale.read("value", text) * self.factor(table, scale.kind)
        if not in_range(self.definition.measure("value"), scale, value):
            message = f"{column}: a value this large is not plausible"
            self._fault(table, row.line, message, "see formats show", text)
        yield float(value) + 0.0

    def factor(self, table: UserTable, kind: AxisKind) -> Decimal:
        """Return the factor from a table's numbers for an axis of this kind to mm or deg."""
        inch = table.head["unit"].text.upper() == "INCH" and kind is AxisKind.LINEAR
        return _INCH if inch else Decimal(1)

    def turned(
        self, address: str, positions: FloatArray, values: FloatArray, file: str
    ) -> tuple[FloatArray, FloatArray, float | None]:
        """Return positions, values and period of a table; for a rotary axis reduced to one turn
        from 0 to 360 degrees.
        """
        axis = self.axes.get(address)
        if self.kind(address) is AxisKind.LINEAR:
            return positions, values, None
        modulo = axis.modulo if axis is not None else None
        if modulo is not None and modulo != TURN:
            self.notes.faults.append(
                Fault(
                    message=f"axis {address}: a control of this kind has 360 degrees in one "
                    "turn of a rotary axis",
                    file=file,
                    found=f"{modulo:g}",
                    hint=(
                        "correct `modulo` of the axis in the job, or give the file that belongs to "
                        "this machine"
                    ),
                )
            )
        if modulo is None and not (positions[0] <= 0 and positions[-1] >= TURN):
            if positions[0] < 0 or positions[-1] > TURN:
                self.notes.faults.append(
                    Fault(
                        message=(
                            f"axis {address}: the control uses only the entries from 0 to "
                            "360 degrees of a rotary axis, so the rest would be lost"
                        ),
                        file=file,
                        expected="0 to 360 degrees",
                        found=f"{positions[0]:g} to {positions[-1]:g}",
                        hint=(
                            "correct the positions in a copy of this file, or `kind` of "
                            "the axis in "
                            "the job"
                        ),
                    )
                )
            return positions, values, None
        points = np.concatenate([[0.0], positions[(positions > 0) & (positions < TURN)], [TURN]])
        curve = np.interp(points, positions, values)
        if curve[0] != curve[-1]:
            self.notes.find("CW-S017", "warning", axis=address, file=file)
        return points, curve, TURN

    def fault(self, file: str, place: str, message: str, expected: str, found: str) -> None:
        """Add an error in a file to the notes, unless it is there already."""
        fault = Fault(
            message=message,
            file=file,
            place=place,
            expected=expected,
            found=found[:60],
            hint=("correct this value in a copy of the file, or export it from the control again"),
        )
        self.notes.once(fault)

    def _fault(self, table: UserTable, line: int, message: str, expected: str, found: str) -> None:
        self.fault(table.file, f"line {line}", message, expected, found)
