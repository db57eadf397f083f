"""Write a correction between axes into a column of the table that follows the moving axis.

Only cells of that column change. The positions of the table stay.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.families.columns.filling import signed
from compwright.formats.families.columns.source_files import find_sources
from compwright.formats.families.columns.table import UserTable, cell_changes, is_number
from compwright.formats.families.columns.values import TableValues
from compwright.formats.families.family import Family
from compwright.formats.text.notes import Notes
from compwright.formats.text.patching import Patches
from compwright.formats.text.scale import EXACTNESS, NotHeld, NumberScale
from compwright.formats.text.values import name_of
from compwright.foundations.errors import InputError, raise_all
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import ControlFile, CrossCompensation
from compwright.records.plan import PlannedCross
from compwright.words.sentences import control_text


@dataclass(frozen=True, slots=True)
class Filled:
    """A correction between axes as it was written into a column of the user's table."""

    file: str
    column: str
    entry: PlannedCross


def values_quantum(family: Family) -> float:
    """Return the smallest step of the values in a column, in mm or deg (the number is the same for
    both).
    """
    return float(Decimal(1).scaleb(-family.definition.measure("value").digits))


class CrossFiller(Patches):
    """Writes corrections into columns of the tables in ``files``, one after the other."""

    def __init__(
        self, family: Family, axes: Mapping[str, Axis], files: Sequence[ControlFile]
    ) -> None:
        super().__init__(family.definition.dialect, files)
        self.family = family
        self.by_address = {axis.address: axis for axis in axes.values()}
        notes = Notes()
        self.sources = find_sources(family.definition, files, list(axes.values()), notes.faults)
        raise_all(InputError, notes.faults)
        self.values = TableValues(family, self.sources, self.by_address, notes)

    def refuse_waking(self, output: str, *, tabled: bool) -> None:
        """Raise NotHeld if the switch that makes a column active on an axis would also activate
        values that are not active now. ``tabled``: the axis gets a new table of its own.

        The bit of the axis selects every table that corrects it. The active line of the .CMA
        activates every table that it names.
        """
        sources, definition = self.sources, self.family.definition
        if sources.assignments is not None and sources.active is None:
            raise NotHeld(
                control_text(
                    "no line of {file} is active, and an active line activates every table that it"
                    " names; mark the line, repeat the test and give the files as they are then",
                    file=sources.assignments.file,
                )
            )
        column = sources.column_of(output)
        waking = tuple(
            control_text("{file}, column {column}", file=table.file, column=column)
            for moving, table in sources.tables.items()
            if table.fills(column) and not (tabled and moving == output)
        )
        bit = control_text("the active line of the .CMA")
        if "enabled" in definition.bindings:
            bit = control_text(
                "the bit of {output} in {parameter}",
                output=output,
                parameter=name_of(definition, "enabled"),
            )
        if waking and (self.is_off(output) or self._is_idle(output, tabled=tabled)):
            raise NotHeld(
                control_text(
                    "no table is active on {output} now, and {bit} would also activate values that"
                    " are not active now ({tables}); empty these columns, or activate them and"
                    " repeat the test, then give the files as they are then",
                    output=output,
                    bit=bit,
                    tables=waking,
                )
            )
        if self.is_off(output) and (sources.assignments is None or sources.missing):
            raise NotHeld(
                control_text(
                    "no table is active on {output} now, and not all tables that {bit} would"
                    " activate are among the files; give the .CMA and every .COM that its active"
                    " line names",
                    output=output,
                    bit=bit,
                )
            )

    def _is_idle(self, output: str, *, tabled: bool) -> bool:
        """Return whether the control's state has a table for an axis that is not active on it."""
        state = self.family.state
        return (bool(state.facts_of(output).grid) and not tabled) or any(
            entry.output == output and not entry.positive.any() for entry in state.cross
        )

    def fill(self, entry: PlannedCross) -> Filled:
        """Note the change of each table cell that a correction needs; return the correction as
        written.

        Raises NotHeld, with the reason, if the user's files have no place for it.
        """
        added = entry.added
        table, column = self._place(added)
        exact = self.values.positions(table, added.input) or ()
        raise_all(InputError, self.values.notes.faults)
        rows = np.array([float(position) for position in exact])
        more = correction_at_rows(added, rows, table.file)
        old = self.values.values(table, column, exact, added.output, added.input)
        raise_all(InputError, self.values.notes.faults)
        total = (np.zeros(rows.size) if old is None else old) + more
        self.refuse_steep(table, rows, total)
        self._write(table, column, self.values.scale(added.input, added.output_kind), total)
        held = replace(added, positions=rows, positive=more, negative=more, period=None)
        return Filled(table.file, column, replace(entry, added=held))

    def _place(self, added: CrossCompensation) -> tuple[UserTable, str]:
        """Return the moving axis' table and the name of its column for the corrected axis. Raises
        NotHeld if there is no such table or column.
        """
        table = self.sources.tables.get(added.input)
        if table is None:
            raise NotHeld(
                control_text(
                    "no table (.COM) that is active for {input} is among the files",
                    input=added.input,
                )
            )
        if self.is_off(added.output):
            bits = name_of(self.family.definition, "enabled")
            raise NotHeld(
                control_text(
                    "the bit of {output} in {parameter} is 0: no table is active on it",
                    output=added.output,
                    parameter=bits,
                )
            )
        column = self.sources.column_of(added.output)
        if table.column(column) is None:
            raise NotHeld(
                control_text("{file} has no column {column}", file=table.file, column=column)
            )
        if added.input_kind is not AxisKind.LINEAR:
            raise NotHeld(control_text("{input} is a rotary axis", input=added.input))
        if table.head["unit"].text.upper() != "MM":
            raise NotHeld(control_text("{file} is in inch", file=table.file))
        self.refuse_shared(table)
        return table, column

    def is_off(self, output: str) -> bool:
        """Return whether the files state that no table is active on an axis."""
        return any(bit.text == "0" for bit in self.sources.given.get((output, "enabled"), []))

    def refuse_shared(self, table: UserTable) -> None:
        """Raise NotHeld if a table follows the motion of several axes."""
        moving = tuple(address for address, known in self.sources.tables.items() if known is table)
        if len(moving) > 1:
            raise NotHeld(
                control_text(
                    "{file} is active for the motion of several axes: {axes}",
                    file=table.file,
                    axes=moving,
                )
            )

    def refuse_steep(self, table: UserTable, rows: FloatArray, total: FloatArray) -> None:
        """Raise NotHeld if neighbouring values ``total`` of a column, at the positions ``rows``,
        differ by more than the control allows.
        """
        rule = self.family.definition.limit_number("spacing_per_step")
        if rule is not None and np.any(np.abs(np.diff(total)) > np.diff(rows) / rule):
            raise NotHeld(
                control_text(
                    "neighbouring values of {file} would differ too much",
                    file=table.file,
                )
            )

    def _write(self, table: UserTable, column: str, scale: NumberScale, total: FloatArray) -> None:
        quantum = scale.quantum("value")
        number = [file.name for file in self.files].index(table.file)
        changes = []
        for row, value in zip(table.rows, total, strict=True):
            text = scale.write("value", round(float(value) / quantum) * quantum)
            cell = row.cells.get(column)
            if cell is not None and is_number(cell.text) and Decimal(cell.text) == Decimal(text):
                continue
            line = self.files[number].content[row.start : row.end].decode("latin-1")
            changes += cell_changes(table, row, line, {column: signed(table, text, column)})
        self.replace(number, *changes)


def correction_at_rows(added: CrossCompensation, rows: FloatArray, file: str) -> FloatArray:
    """Return the correction (k,), mm or deg, interpolated at the positions of the table's rows.

    A straight line is extended to the ends of the table. Raises NotHeld if each direction has its
    own curve, if the rows do not cover the correction, or if a bend is at no row.
    """
    if not np.array_equal(added.positive, added.negative):
        raise NotHeld(
            control_text(
                "a column of {file} is for both directions, but the correction has two curves",
                file=file,
            )
        )
    if rows[0] > added.positions[0] + EXACTNESS or rows[-1] < added.positions[-1] - EXACTNESS:
        raise NotHeld(
            control_text(
                "{file} reaches from {low} to {high}, the correction from {first} to {last}",
                file=file,
                low=f"{rows[0]:g}",
                high=f"{rows[-1]:g}",
                first=f"{added.positions[0]:g}",
                last=f"{added.positions[-1]:g}",
            )
        )
    slopes = np.diff(added.positive) / np.diff(added.positions)
    straight = added.positive[0] + slopes[0] * (rows - added.positions[0])
    if np.allclose(np.interp(added.positions, rows, straight), added.positive, rtol=0, atol=1e-9):
        return np.asarray(straight, dtype=float)
    apart = [float(np.min(np.abs(rows - position))) for position in added.positions]
    if max(apart) > EXACTNESS:
        raise NotHeld(
            control_text(
                "{file} has no row at a position where the correction bends",
                file=file,
            )
        )
    return np.interp(rows, added.positions, added.positive)
