"""Compensation -> the user's own exported tables and parameters, patched in place; what has no
place there -> entry sheets.

No manual shows the text of these files, so none is invented: only cells of the axis' own column
change, rows are added in the table's own style, and one bit of a mask that was read. Everything
else keeps its bytes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import axis_options
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.families.columns.capacity import by_line, slope_scale, spacings, user_scale
from compwright.formats.families.columns.sources import (
    PARAMETERS,
    Sources,
    ambiguous,
    find_sources,
    mask_of,
    parameter_name,
)
from compwright.formats.families.columns.text import (
    POSITION,
    ROW_NUMBER,
    SECOND,
    Row,
    UserTable,
    cell_changes,
    is_number,
    set_cell,
)
from compwright.formats.families.columns.values import (
    MOST_DOUBLINGS,
    SMALLEST_SPACING,
    TURN,
    TableValues,
)
from compwright.formats.text.entry_sheet import SheetRow, is_entry_sheet, write_sheet
from compwright.formats.text.notes import Notes
from compwright.formats.text.patching import Change, apply_changes, set_field
from compwright.formats.text.scale import EXACTNESS, NotHeld
from compwright.foundations.errors import CapacityError, Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile


def write_user_tables(
    definition: Definition,
    pairs: Sequence[tuple[str, Axis, AxisCompensation]],
    options: Mapping[str, object],
    files: Sequence[ControlFile],
) -> tuple[ControlFile, ...]:
    """Return the files that put the compensations (address, axis, table) into the control.

    The user's own ``files`` come back patched, all of them but old entry sheets, so that the set is
    complete; for what they have no place for there is one entry sheet per axis. Raises InputError
    for files that cannot be read, CapacityError with everything that cannot be written exactly,
    UsageError where a value that would be replaced is in no file.
    """
    if files:
        _refuse_unsaid_backlash(definition, pairs, options, files)
    own = [file for file in files if not is_entry_sheet(file)]
    patcher = _Patcher(definition, {address: axis for address, axis, _ in pairs}, options, own)
    faults: list[Fault] = []
    sheets: list[ControlFile] = []
    for address, axis, compensation in pairs:
        try:
            sheet = patcher.put(address, axis, compensation)
        except NotHeld as error:
            faults.append(Fault(message=f"axis {axis.name} ({address}): {error}"))
        except CapacityError as error:
            faults.extend(error.faults)
        else:
            sheets += [] if sheet is None else [sheet]
    raise_all(CapacityError, faults)
    return (*patcher.files(), *sheets)


def _refuse_unsaid_backlash(
    definition: Definition,
    pairs: Sequence[tuple[str, Axis, AxisCompensation]],
    options: Mapping[str, object],
    files: Sequence[ControlFile],
) -> None:
    """A backlash is written over what stands in the control: where no file says that, it would be
    lost from the total.
    """
    given = find_sources(definition, files, [axis for _, axis, _ in pairs], []).given
    name = parameter_name(definition, "backlash")
    asked = [
        Fault(
            message=(
                f"axis {axis.name} ({address}): {name} is in no file of the state, and the new"
                " table writes it: a value that stands in the control would be lost from the total"
            ),
            place="states",
            expected=(
                f"{name} as it stands in the control among the files: an entry sheet of {address}"
                f" with the line {name},,0.0000,{axis.kind.unit} where it is 0"
            ),
            found="no value",
        )
        for address, axis, compensation in pairs
        if (address, "backlash") not in given
        and Decimal(
            user_scale(definition, axis, axis_options(definition, options, axis)).write(
                "backlash", compensation.backlash
            )
        )
    ]
    raise_all(UsageError, asked)


class _Patcher:
    """Collects the changes to the user's own files."""

    def __init__(
        self,
        definition: Definition,
        axes: Mapping[str, Axis],
        options: Mapping[str, object],
        own: Sequence[ControlFile],
    ) -> None:
        self.definition = definition
        self.options = options
        self.own = {file.name: file.content for file in own}
        self.changes: dict[str, list[Change]] = {file.name: [] for file in own}
        self.masks: dict[tuple[str, int], tuple[Occurrence, str]] = {}
        notes = Notes()
        self.sources: Sources = find_sources(definition, own, list(axes.values()), notes.faults)
        raise_all(InputError, notes.faults)
        self.values = TableValues(definition, self.sources, axes, options, notes)

    def files(self) -> tuple[ControlFile, ...]:
        """Return the user's files with all changes made."""
        for (file, _), (place, text) in self.masks.items():
            self.changes[file].extend(set_field(place, "value", text))
        self.masks = {}
        return tuple(
            ControlFile(name, apply_changes(content, self.changes[name]))
            for name, content in self.own.items()
        )

    def put(self, address: str, axis: Axis, compensation: AxisCompensation) -> ControlFile | None:
        """Note the changes for one axis and return the sheet with what has no place in the user's
        files; None: nothing is left.
        """
        entry = _Entry(
            self.definition, axis, compensation, axis_options(self.definition, self.options, axis)
        )
        points: list[SheetRow] = []
        if not entry.line:
            if self.sources.own_column(address) is not None:
                _TableFiller(self, address, entry).fill()
            else:
                points = entry.points()
        left = {
            name: text
            for name, text in entry.parameters().items()
            if not self._parameter(address, name, text)
        }
        rows = [*points, *entry.parameter_rows(left)]
        return self._sheet(address, entry, rows, len(points)) if rows else None

    def _sheet(
        self, address: str, entry: _Entry, rows: Sequence[SheetRow], points: int
    ) -> ControlFile:
        file = next(file for file in self.definition.writing if file.rows is not None)
        meaning = str(entry.options["table_values"])
        comments = [
            ("axis", entry.axis.name),
            ("address", address),
            ("format", self.definition.id),
            ("value", meaning),
            ("points", str(points)),
            (
                "note",
                (
                    f"values of points are {meaning}s as the control is assumed to expect them:"
                    " check the sign, see the card"
                ),
            ),
            ("note", f"positions are machine coordinates in {entry.axis.kind.unit}"),
        ]
        return write_sheet(print_form(file.name, {"axis": address}), comments, rows)

    def _parameter(self, address: str, quantity: str, text: str) -> bool:
        """Note the change of a parameter in the user's files; False where it is not in them."""
        found = [
            given
            for given in self.sources.given.get((address, quantity), [])
            if given.occurrence is not None
        ]
        for given in found:
            place = given.occurrence
            if place is None:
                continue
            if quantity == "enabled":
                self._bit(address, place, text)
            elif Decimal(given.text) != Decimal(text):
                plus = "+" if given.text.startswith("+") and not text.startswith("-") else ""
                self.changes[given.file].extend(set_field(place, "value", plus + text))
        return bool(found)

    def _bit(self, address: str, place: Occurrence, text: str) -> None:
        """Change one bit of a mask, for several axes one after the other."""
        key = (place.file, place.tokens["value"].start)
        known = self.masks[key][1] if key in self.masks else place.tokens["value"].text
        number, mask = self.sources.numbers.number(address), mask_of(known)
        if number is None or mask is None or mask >> (number - 1) & 1 == int(text):
            return
        self._woken(address, awake=text == "1")
        changed = mask ^ 1 << (number - 1)
        new = f"%{changed:0{len(known) - 1}b}" if known.startswith("%") else str(changed)
        self.masks[key] = (place, f"%{changed:b}" if ambiguous(new) else new)

    def _woken(self, address: str, *, awake: bool) -> None:
        """Refuse to change the bit of an axis on which tables of other axes act, or would.

        The bit selects every table that corrects the axis, not its own alone. Raises NotHeld.
        """
        column = self.sources.column_of(address)
        others = [
            f"{table.file} ({address} over {moving})"
            for moving, table in self.sources.tables.items()
            if moving != address
            and any(_not_zero(row.cells[column].text) for row in table.rows if column in row.cells)
        ]
        if others:
            name = parameter_name(self.definition, "enabled")
            what = "would wake what sleeps" if awake else "would switch off what acts"
            raise NotHeld(
                f"the bit of {address} in {name} has to become {int(awake)}, which {what} in"
                f" {', '.join(others)}; empty that column first, or set the bit and measure again"
            )


def _not_zero(text: str) -> bool:
    return not is_number(text) or Decimal(text) != 0


class _Entry:
    """What is entered for one axis, as text."""

    def __init__(
        self,
        definition: Definition,
        axis: Axis,
        compensation: AxisCompensation,
        options: Mapping[str, object],
    ) -> None:
        self.definition = definition
        self.axis = axis
        self.compensation = compensation
        self.options = options
        self.scale = user_scale(definition, axis, options)
        self.line = by_line(options)
        self.nodes, self.positive, self.negative = _one_turn(axis, compensation)

    def value(self, correction: float) -> str:
        return self.scale.write("value", correction)

    def points(self) -> list[SheetRow]:
        """Return the points of the sheet."""
        rows = []
        for number, (node, correction) in enumerate(zip(self.nodes, self.positive, strict=True)):
            position = self.scale.write("node_position", float(node))
            rows.append(
                SheetRow(str(number), position, self.value(float(correction)), self.axis.kind.unit)
            )
        return rows

    def parameters(self) -> dict[str, str]:
        """Return the parameters by quantity. Beside a table the linear one is 0: nothing counts
        twice, whichever of them acts.
        """
        texts = {
            "backlash": self.scale.write("backlash", self.compensation.backlash),
            "slope": (
                slope_scale(self.definition, self.options).write("slope", self.compensation.slope)
            ),
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
        units = {"backlash": self.axis.kind.unit, "slope": "mm/m", "enabled": ""}
        return [
            SheetRow(parameter_name(self.definition, name), "", text, units[name])
            for name, text in left.items()
        ]


def _one_turn(
    axis: Axis, compensation: AxisCompensation
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return nodes and curves as the table holds them: those of an endless axis from 0 to 360
    degrees, wherever its reference is.

    Raises NotHeld when no node lies at 0 degrees.
    """
    nodes, positive, negative = compensation.positions, compensation.positive, compensation.negative
    if axis.modulo is None or not nodes.size:
        return nodes, positive, negative
    turned = np.round(np.mod(nodes[:-1], TURN), 9) % TURN
    order = np.argsort(turned)
    if turned[order[0]] != 0:
        raise NotHeld(
            "the table needs a point at 0 degrees; a spacing that divides the reference"
            f" {axis.reference:g} would help"
        )
    where = np.concatenate([turned[order], [TURN]])
    curves = [
        np.concatenate([curve[:-1][order], [curve[:-1][order[0]]]])
        for curve in (positive, negative)
    ]
    return where, curves[0], curves[1]


class _TableFiller:
    """Puts one axis' curve into its column of the user's table."""

    def __init__(self, patcher: _Patcher, address: str, entry: _Entry) -> None:
        self.patcher = patcher
        self.sources = patcher.sources
        self.table: UserTable = patcher.sources.tables[address]
        self.column = patcher.sources.column_of(address)
        self.address = address
        self.entry = entry
        self.content = patcher.own[self.table.file]
        self.changes = patcher.changes[self.table.file]

    def fill(self) -> None:
        """Note all changes. Raises NotHeld and CapacityError for what the table cannot take."""
        self._suits()
        positions = self._positions()
        others = self.table.others(self.column, POSITION, SECOND)
        if others:
            self._rows(np.array(positions), self._on_the_grid(positions, others))
            return
        nodes = self.entry.nodes
        extra = max(
            0, len(self.table.rows) - nodes.size
        )  # rows that stay: the end value goes on over them
        step = float(nodes[-1] - nodes[-2]) if nodes.size > 1 else 1.0
        grid = np.concatenate([nodes, nodes[-1] + step * np.arange(1, extra + 1)])
        if (
            extra
            and self.entry.axis.kind is AxisKind.ROTARY
            and self.entry.axis.modulo is None
            and grid[-1] > TURN
        ):
            raise NotHeld(
                f"{self.table.file} has {extra} rows too many, and there is no room behind 360"
                " degrees; delete them"
            )
        held = np.concatenate([np.arange(nodes.size), np.full(extra, nodes.size - 1)])
        self._head(grid)
        self._rows(grid, held)

    def _suits(self) -> None:
        if self.table.head["unit"].text.upper() != "MM":
            raise NotHeld(
                f"{self.table.file} is in inch; export it with the control set to mm, or leave it"
                " out for an entry sheet"
            )
        moving = [address for address, table in self.sources.tables.items() if table is self.table]
        if len(moving) > 1:
            raise NotHeld(
                f"{self.table.file} acts for the motion of several axes ({', '.join(moving)}): a"
                " change for one changes all"
            )
        second = self.table.column(SECOND)
        if second is None and not np.array_equal(self.entry.positive, self.entry.negative):
            raise NotHeld(f"{self.table.file} has no column {SECOND} for the second curve")

    def _positions(self) -> list[float]:
        positions = self.patcher.values.positions(self.table, self.address)
        raise_all(InputError, self.patcher.values.notes.faults)
        return [float(position) for position in positions or ()]

    def _on_the_grid(self, positions: Sequence[float], others: Sequence[str]) -> np.ndarray:
        """Return, for every row, the node whose value it gets; the table's grid serves other axes
        and has to stay.
        """
        nodes = self.entry.nodes
        slack = EXACTNESS * self.entry.scale.quantum("node_position")
        first = int(np.argmin(np.abs(np.array(positions) - nodes[0])))
        part = np.array(positions[first : first + nodes.size])
        if part.size != nodes.size or np.max(np.abs(part - nodes)) > slack:
            unit = self.entry.axis.kind.unit
            steps = np.diff(positions)
            even = steps.size and np.ptp(steps) <= slack
            spacing = f", spacing: {steps[0]:.10g}" if even else ""
            raise CapacityError(
                Fault(
                    message=(
                        f"axis {self.entry.axis.name} ({self.address}): the points of"
                        f" {self.table.file} have to stay, because its columns {', '.join(others)}"
                        " depend on them"
                    ),
                    place="table",
                    expected=(
                        f"table: {{start: {positions[0]:.10g}, end: {positions[-1]:.10g}{spacing}}}"
                        f" in the job ({unit})"
                    ),
                    found=f"{nodes.size} points from {nodes[0]:.10g} to {nodes[-1]:.10g}",
                )
            )
        return np.clip(np.arange(len(positions)) - first, 0, nodes.size - 1)

    def _head(self, grid: FloatArray) -> None:
        """Set datum and spacing in the first line, where the table has them there."""
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
                plus = "+" if cell.text.startswith("+") and not new.startswith("-") else ""
                self.changes.append(Change(cell.start, cell.end, (plus + new).encode("ascii")))

    def _rows(self, grid: FloatArray, held: np.ndarray) -> None:
        """Fill the rows that there are and add those that are missing; ``held`` (k,): the node
        whose value a row gets.
        """
        rows = self.table.rows
        for row, position, node in zip(rows, grid, held, strict=False):
            line = self.content[row.start : row.end].decode("latin-1")
            self.changes.extend(
                cell_changes(self.table, row, line, self._cells(float(position), int(node), row))
            )
        last = rows[-1]
        line = self.content[last.start : last.end].decode("latin-1")
        end = self.content[last.end : last.next]
        for number in range(len(rows), len(grid)):
            cells = {
                ROW_NUMBER: str(number),
                **self._cells(float(grid[number]), int(held[number]), None),
            }
            added = line
            for name, text in cells.items():
                added = set_cell(self.table, added, name, text)
            self.changes.append(Change(last.next, last.next, added.encode("latin-1") + end))

    def _cells(self, position: float, node: int, row: Row | None) -> dict[str, str]:
        """Return the cells of a row; a cell that says the same number already keeps its
        characters.
        """
        entry = self.entry
        cells = {self.column: self._signed(entry.value(float(entry.positive[node])), self.column)}
        if self._two_columns():
            cells[SECOND] = self._signed(entry.value(float(entry.negative[node])), SECOND)
        if not self.sources.numbered:
            text = f"{Decimal(entry.scale.write('node_position', position)).normalize():f}"
            cells[POSITION] = self._signed(text, POSITION)
        known = {} if row is None else row.cells
        return {
            name: text
            for name, text in cells.items()
            if name not in known
            or not is_number(known[name].text)
            or Decimal(known[name].text) != Decimal(text)
        }

    def _two_columns(self) -> bool:
        """Whether the second curve is written: asked for, or filled already (then equal to the
        first: both readings agree).
        """
        if self.table.column(SECOND) is None:
            return False
        return self.entry.options.get("backlash_column") == "second_curve" or any(
            SECOND in row.cells for row in self.table.rows
        )

    def _signed(self, text: str, column: str) -> str:
        """Return a number with a plus sign where the table writes one."""
        if text.startswith("-"):
            return text
        texts = [row.cells[column].text for row in self.table.rows if column in row.cells]
        if not texts and column != POSITION:
            skipped = (ROW_NUMBER, POSITION)
            texts = [
                cell.text
                for row in self.table.rows
                for name, cell in row.cells.items()
                if name not in skipped
            ]
        return f"+{text}" if any(one.startswith("+") for one in texts) else text
