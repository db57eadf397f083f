"""Controls with a table for each axis: values by index at equal spacing, or rows with positions.

The form of positions and values in a file is a `TableShape` (`tables`); there is one class for each
form. The family `pairs` extends this family by cross-axis tables; nothing here depends on it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import ClassVar

from compwright.formats.definition.schema import Definition
from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest, alternative_answer
from compwright.formats.families.card_texts import (
    AxisCard,
    CardRequest,
    named_files,
    table_values,
)
from compwright.formats.families.family import Family, Listing, check_tables, writable_tables
from compwright.formats.families.grid.capacity import GridLimits
from compwright.formats.families.grid.joints import sure_joints
from compwright.formats.families.grid.reading import GridReader
from compwright.formats.families.grid.table_files import base_name
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.families.grid.writing import GridWriter
from compwright.formats.text.file_values import FileValue, by_statements
from compwright.formats.text.texts import text_reader
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

#: Keys other than those of the definition that decide the scale of a joint or move its zero
#: (LinuxCNC documentation, INI configuration: [JOINT_n], [KINS]).
_CORRECTING = re.compile(
    r"\[(?:JOINT_[0-9]+|KINS)\] (?:(?:INPUT_|OUTPUT_)?SCALE|HOME|HOME_OFFSET|KINEMATICS)"
)


def file_values(
    definition: Definition, files: Sequence[ControlFile], naming: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every value in the files by name, each table row under the axis of its table file.
    ``naming``: other files of the same control that may name this axis.
    """
    found = by_statements(definition, files)
    table_file = definition.bindings.get("table_file")
    owners = {
        base_name(entry.text): entry.axis
        for entry in (*by_statements(definition, naming).values(), *found.values())
        if table_file is not None and entry.group == table_file.statement
    }
    return {
        key: replace(
            entry,
            axis=entry.axis or owners.get(entry.file, ""),
            relevant=entry.relevant or _CORRECTING.fullmatch(entry.group) is not None,
        )
        for key, entry in found.items()
    }


def _names(control: Family, files: Sequence[ControlFile]) -> Mapping[str, tuple[str, str]]:
    """Return the axis letter of each joint of the machine, by the kinematics in the files."""
    definition = control.definition
    if "axis_letters" not in definition.bindings:
        return {}
    reader = text_reader(definition)
    texts = [text for file in files if (text := reader.read(file, [])) is not None]
    first = {
        name: next(
            (
                one.tokens["value"].text
                for text in texts
                for one in text.occurrences
                if one.statement == definition.bindings[name].statement
            ),
            "",
        )
        for name in ("axis_letters", "axis_order", "joint_count")
    }
    letters = sure_joints(*first.values())
    evidence = f"{name_of(definition, 'axis_letters')} = {first['axis_letters']}"
    return {letter: (str(letters.index(letter)), evidence) for letter in dict.fromkeys(letters)}


class GridFamily(Family):
    """Controls with one table per axis. A derived family replaces ``reader`` and ``writer``."""

    reader: type[GridReader] = GridReader
    writer: type[GridWriter] = GridWriter
    listing: ClassVar[Listing] = Listing(file_values=file_values, names=_names)

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`."""
        return self.reader(self, files, axes, address, activity).read()

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of one axis' table in mm or deg; see `Family.capacity`."""
        del one_curve
        return GridLimits(self, axis).capacity()

    def between(self, request: BetweenRequest) -> Between:
        """Return the answer that the control has no cross-axis tables; see `Family.between`."""
        return alternative_answer(self.definition, request.planned)

    def _own_limits(
        self, axis: Axis, compensation: AxisCompensation, capacity: Capacity, label: str
    ) -> Sequence[Fault]:
        """Return the faults of a table that repeats each turn of an endless axis."""
        del axis
        repeats = shape_of(self.definition).repeats
        return limits.turn(capacity, compensation, label) if repeats else ()

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that load ``compensations`` into the control; see `Family.write`."""
        tables, faults = check_tables(self, compensations, axes, self._own_limits)
        whole = writable_tables(tables)
        written = self.writer(self, files, [address for address, _, _ in whole]).written(
            whole, faults
        )
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return written

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        values = table_values(self.definition, self.scale_of(request.axis), request.table)
        typed = request.facts.stated.get("typed_backlash")  # not in the table: half each way
        values |= {} if typed is None else {"backlash": str(typed)}
        return AxisCard(values | named_files(self, request.axis, request.files))
