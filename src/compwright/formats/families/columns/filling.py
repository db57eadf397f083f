"""Write an axis' corrections into its column of the user's table, in the table's own number style.

The datum (first position) and the spacing are in the first line of the table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import numpy as np

from compwright.formats.families.columns.capacity import by_line, spacings
from compwright.formats.families.columns.sources import PARAMETERS
from compwright.formats.families.columns.table import (
    POSITION,
    ROW_NUMBER,
    SECOND,
    Row,
    UserTable,
    cell_changes,
    is_number,
    set_cell,
    with_sign,
)
from compwright.formats.families.columns.values import (
    MOST_DOUBLINGS,
    SMALLEST_SPACING,
    TURN,
    TableValues,
    column_scale,
)
from compwright.formats.families.family import Family
from compwright.formats.text.entry_sheet import SheetRow
from compwright.formats.text.patching import BytesChange, Patches
from compwright.formats.text.scale import EXACTNESS, NotHeld
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, InputError, raise_all
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import AxisCompensation


class ColumnEntry:
    """The texts to enter for one axis: its table's positions and values, and its parameters."""

    def __init__(self, control: Family, axis: Axis, compensation: AxisCompensation) -> None:
        self.definition = control.definition
        self.axis = axis
        self.compensation = compensation
        self.options = control.options_of(axis)
        self.scale = column_scale(self.definition, axis.kind, self.options)
        self.line = by_line(self.options)
        self.points, self.positive, self.negative = _one_turn(axis, compensation)

    def value(self, correction: float) -> str:
        """Return a correction in mm or deg as text for a table cell. Raises NotHeld if it cannot be
        written.
        """
        return self.scale.write("value", correction)

    def rows(self) -> list[SheetRow]:
        """Return the table points as rows of the entry sheet."""
        rows = []
        for number, (point, correction) in enumerate(zip(self.points, self.positive, strict=True)):
            position = self.scale.write("node_position", float(point))
            rows.append(
                SheetRow(str(number), position, self.value(float(correction)), self.axis.kind.unit)
            )
        return rows

    def parameters(self) -> dict[str, str]:
        """Return the texts of the axis' parameters: backlash, linear error, table active.

        With a table the linear error parameter is 0. So no error is corrected twice, whichever of
        the two is active.
        """
        straight = column_scale(self.definition, AxisKind.LINEAR, self.options)
        texts = {
            "backlash": self.scale.write("backlash", self.compensation.backlash),
            "slope": straight.write("slope", self.compensation.slope),
            "enabled": "0" if self.line else "1",
        }
        if self.axis.kind is AxisKind.ROTARY:
            del texts["slope"]  # it has no effect there
        return {
            name: texts[name]
            for name in PARAMETERS
            if name in texts and name in self.definition.bindings
        }

    def parameter_rows(self, left: Mapping[str, str]) -> list[SheetRow]:
        """Return entry sheet rows for the parameters ``left``, which are in none of the files."""
        units = {"backlash": self.axis.kind.unit, "slope": "mm/m", "enabled": ""}
        return [
            SheetRow(name_of(self.definition, name), "", text, units[name])
            for name, text in left.items()
        ]


def _one_turn(
    axis: Axis, compensation: AxisCompensation
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return positions and corrections (+, -) of a table; on an endless axis from 0 to 360 degrees.

    Raises NotHeld if no table point is at 0 degrees.
    """
    points, positive, negative = (
        compensation.positions,
        compensation.positive,
        compensation.negative,
    )
    if axis.modulo is None or not points.size:
        return points, positive, negative
    turned = np.round(np.mod(points[:-1], TURN), 9) % TURN
    order = np.argsort(turned)
    if turned[order[0]] != 0:
        raise NotHeld(
            "the table needs a point at 0 degrees. Next: set `table: {spacing: ...}` of the axis to"
            f" a spacing that divides the reference {axis.reference:g}"
        )
    where = np.concatenate([turned[order], [TURN]])
    curves = [
        np.concatenate([curve[:-1][order], [curve[:-1][order[0]]]])
        for curve in (positive, negative)
    ]
    return where, curves[0], curves[1]


class TableFiller:
    """Writes the corrections of one axis into its column of the user's table."""

    def __init__(
        self, patches: Patches, values: TableValues, address: str, entry: ColumnEntry
    ) -> None:
        self.patches = patches
        self.values = values
        self.sources = values.sources
        self.table = values.sources.tables[address]
        self.column = values.sources.column_of(address)
        self.address = address
        self.entry = entry
        self.number = [file.name for file in patches.files].index(self.table.file)

    def fill(self) -> None:
        """Record all changes to the table. Raises NotHeld or CapacityError if impossible."""
        self._suits()
        positions = self._positions()
        others = self.table.others(self.column, POSITION, SECOND)
        if others:
            self._rows(np.array(positions), self._on_the_grid(positions, others))
            return
        points = self.entry.points
        extra = max(
            0, len(self.table.rows) - points.size
        )  # rows that stay: the end value goes on over them
        step = float(points[-1] - points[-2]) if points.size > 1 else 1.0
        grid = np.concatenate([points, points[-1] + step * np.arange(1, extra + 1)])
        if (
            extra
            and self.entry.axis.kind is AxisKind.ROTARY
            and self.entry.axis.modulo is None
            and grid[-1] > TURN
        ):
            raise NotHeld(
                f"{self.table.file} has {extra} rows too many, and there is no room behind 360"
                " degrees. Next: delete these rows in the control, and export the table again"
            )
        held = np.concatenate([np.arange(points.size), np.full(extra, points.size - 1)])
        self._head(grid)
        self._rows(grid, held)

    def _suits(self) -> None:
        if self.table.head["unit"].text.upper() != "MM":
            raise NotHeld(
                f"{self.table.file} is in inch. Next: export all tables with the control set to mm"
            )
        moving = [address for address, table in self.sources.tables.items() if table is self.table]
        if len(moving) > 1:
            raise NotHeld(
                f"{self.table.file} is active for the motion of several axes "
                f"({', '.join(moving)}), and a change for one of them changes all. Next: name a"
                " table of its own for each axis in the active line of the .CMA, repeat the test,"
                " and give the files as they are then"
            )
        second = self.table.column(SECOND)
        if second is None and not np.array_equal(self.entry.positive, self.entry.negative):
            raise NotHeld(f"{self.table.file} has no column {SECOND} for the second curve")

    def _positions(self) -> list[float]:
        positions = self.values.positions(self.table, self.address)
        raise_all(InputError, self.values.notes.faults)
        return [float(position) for position in positions or ()]

    def _on_the_grid(self, positions: Sequence[float], others: Sequence[str]) -> np.ndarray:
        """Return, for each row of the existing table, the index of the new table's point that gives
        the row its value. Raises CapacityError if rows would need new positions, because the
        columns ``others`` depend on the old ones.
        """
        points = self.entry.points
        slack = EXACTNESS * self.entry.scale.quantum("node_position")
        first = int(np.argmin(np.abs(np.array(positions) - points[0])))
        part = np.array(positions[first : first + points.size])
        if part.size != points.size or np.max(np.abs(part - points)) > slack:
            unit = self.entry.axis.kind.unit
            steps = np.diff(positions)
            even = steps.size and np.ptp(steps) <= slack
            spacing = f", spacing: {steps[0]:.10g}" if even else ""
            raise CapacityError(
                Fault(
                    message=(
                        f"axis {self.entry.axis.name} ({self.address}): the points of the table"
                        f" in {self.table.file} must not change, because its columns"
                        f" {', '.join(others)} depend on them"
                    ),
                    place="table",
                    expected=(
                        f"table: {{start: {positions[0]:.10g}, end: {positions[-1]:.10g}{spacing}}}"
                        f" in the job ({unit})"
                    ),
                    found=f"{points.size} points from {points[0]:.10g} to {points[-1]:.10g}",
                    hint=(
                        f"set `table: {{start: {positions[0]:.10g}, end: {positions[-1]:.10g}}}` "
                        "for this axis in the job"
                    ),
                )
            )
        return np.clip(np.arange(len(positions)) - first, 0, points.size - 1)

    def _head(self, grid: FloatArray) -> None:
        """Write the first position and the spacing into the table's first line, if tables of this
        control state them there.
        """
        if not self.sources.numbered:
            return
        spacing = float(grid[1] - grid[0])
        known = spacings(self.entry.options)
        text = f"{Decimal(self.entry.scale.write('node_position', spacing)).normalize():f}"
        if known is not None:
            text = str(
                min(
                    range(MOST_DOUBLINGS + 1),
                    key=lambda power: abs(float(2**power * SMALLEST_SPACING) - spacing),
                )
            )
        datum = f"{Decimal(self.entry.scale.write('node_position', float(grid[0]))).normalize():f}"
        for name, new in (("datum", datum), ("spacing", text)):
            cell = self.table.head[name]
            if Decimal(cell.text) != Decimal(new):
                text = with_sign(cell.text, new)
                self.patches.replace(self.number, BytesChange(cell.start, cell.end, text.encode()))

    def _rows(self, grid: FloatArray, held: np.ndarray) -> None:
        """Fill the table's existing rows, and add rows for the points beyond them. ``grid``: the
        position of each row; ``held``: the index of the point whose value the row gets.
        """
        rows = self.table.rows
        content = self.patches.files[self.number].content
        for row, position, point in zip(rows, grid, held, strict=False):
            line = content[row.start : row.end].decode("latin-1")
            cells = self._cells(float(position), int(point), row)
            self.patches.replace(self.number, *cell_changes(self.table, row, line, cells))
        last = content[rows[-1].start : rows[-1].end].decode("latin-1")
        added = []
        for number in range(len(rows), len(grid)):
            line = set_cell(self.table, last, ROW_NUMBER, str(number))
            for name, text in self._cells(float(grid[number]), int(held[number]), None).items():
                line = set_cell(self.table, line, name, text)
            added.append(line)
        self.patches.add_lines(self.number, rows[-1].start, added)

    def _cells(self, position: float, point: int, row: Row | None) -> dict[str, str]:
        """Return the new texts of a row's cells by column, for the table point with the index
        ``point``; cells whose number does not change are left out.
        """
        entry = self.entry
        cells = {
            self.column: signed(self.table, entry.value(float(entry.positive[point])), self.column)
        }
        if self._two_columns():
            cells[SECOND] = signed(self.table, entry.value(float(entry.negative[point])), SECOND)
        if not self.sources.numbered:
            text = f"{Decimal(entry.scale.write('node_position', position)).normalize():f}"
            cells[POSITION] = signed(self.table, text, POSITION)
        known = {} if row is None else row.cells
        return {
            name: text
            for name, text in cells.items()
            if name not in known
            or not is_number(known[name].text)
            or Decimal(known[name].text) != Decimal(text)
        }

    def _two_columns(self) -> bool:
        """Return whether to write the second column of values: an option requires it, or rows
        already have cells in it.
        """
        if self.table.column(SECOND) is None:
            return False
        return self.entry.options.get("backlash_column") == "second_curve" or any(
            SECOND in row.cells for row in self.table.rows
        )


def signed(table: UserTable, text: str, column: str) -> str:
    """Return the number ``text``, with a plus sign if numbers in its column (in an empty column: in
    the table) have plus signs.
    """
    if text.startswith("-"):
        return text
    texts = [row.cells[column].text for row in table.rows if column in row.cells]
    if not texts and column != POSITION:
        skipped = (ROW_NUMBER, POSITION)
        texts = [
            cell.text
            for row in table.rows
            for name, cell in row.cells.items()
            if name not in skipped
        ]
    return f"+{text}" if any(one.startswith("+") for one in texts) else text
