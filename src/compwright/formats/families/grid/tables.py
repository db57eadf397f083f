"""The table of one axis: its lines in the files, its values, and its text for writing.

A `TableShape` (see `table_shapes`) reads and writes tables with these classes. A control whose
files hold a table in another form gets a `TableShape` of its own, with an entry in ``SHAPES``. No
other code depends on the form of positions and values in a file.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from typing import ClassVar, Literal

import numpy as np

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.shape_rules import ShapeRules
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import NotHeld, NumberScale, in_range
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation

_CORRECT = "correct the table in a copy of the file, or export it from the control again"


@dataclass(frozen=True, slots=True)
class GridTable:
    """A table: positions (k,), ascending, and the correction (k,) in each direction, mm or deg."""

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray


@dataclass(frozen=True, slots=True)
class WrittenTable:
    """The text of one table to write: each row's fields, and single values such as the spacing."""

    rows: tuple[Mapping[str, str], ...]
    singles: Mapping[str, str]


@dataclass(slots=True)
class TableSource:
    """The lines of one table in the control's files, and what is needed to read their numbers.

    ``label``: the name of the table in messages. ``singles``: the lines with its start, end and
    spacing, by quantity. ``ends_at_point``: the end of the table has to be a point, as for an
    endless axis.
    """

    label: str
    rows: Sequence[FoundValue]
    singles: Mapping[str, FoundValue]
    scale: NumberScale
    notes: Notes
    ends_at_point: bool = False

    @property
    def value_fields(self) -> list[str]:
        """The names of the fields of a row that contain values."""
        return value_fields(self.scale.definition)

    def fault(
        self,
        message: str,
        found: FoundValue | None = None,
        *,
        expected: str = "",
        what: str = "",
        hint: str = _CORRECT,
    ) -> None:
        """Add a fault at the line of the value ``found``; without this value, in the file of the
        table.
        """
        place = found or next(iter((*self.rows, *self.singles.values())), None)
        self.notes.faults.append(
            Fault(
                message=f"{self.label}: {message}",
                file=place.occurrence.file if place else "",
                place=place.occurrence.place if place and found else "",
                expected=expected,
                found=what,
                hint=hint,
            )
        )

    def position(self, quantity: str, found: FoundValue) -> Decimal | None:
        """Return a position, mm or deg; None, with a fault, if it is beyond the plausible range."""
        measure = self.scale.definition.measure(quantity)
        text = found.occurrence.tokens[measure.field].text
        value = self.scale.read(quantity, text)
        if in_range(measure, self.scale, value):
            return value
        low, high = self.scale.range(quantity)
        message = "a position this large is not plausible"
        expected = f"{low:g} .. {high:g} {self.scale.kind.unit}"
        self.fault(message, found, expected=expected, what=text)
        return None

    def values(self, row: FoundValue, position: Decimal) -> tuple[Decimal, Decimal] | None:
        """Return a row's corrections (+, -), mm or deg; None (with a fault) if they are out of
        range.
        """
        values, unit = [], self.scale.kind.unit
        for quantity in curves(self.scale.definition):
            measure = self.scale.definition.measure(quantity)
            text = row.occurrence.tokens[measure.field].text
            value = self.scale.read(quantity, text, position)
            if not in_range(measure, self.scale, value):
                low, high = self.scale.range(quantity)
                self.fault(
                    "a correction this large is not plausible",
                    row,
                    expected=f"{low:g} .. {high:g} {unit}",
                    what=f"{float(value):g} {unit} from {text}",
                )
                return None
            values.append(value)
        return values[0], values[-1]


@dataclass(frozen=True, slots=True)
class TableText:
    """Converts the numbers of one table to text.

    A number that the text cannot represent exactly is a fault in ``faults``. ``there``: the text of
    the existing grid in the files, by quantity; empty if there is none.
    """

    compensation: AxisCompensation
    scale: NumberScale
    faults: list[Fault]
    there: Mapping[str, str] = field(default_factory=dict)

    def number(self, quantity: str, value: float, position: float = 0.0) -> str:
        """Return the text of one number. ``position`` (mm or deg): that of its row."""
        try:
            return self.scale.write(quantity, value, position)
        except NotHeld as error:
            what = f"{quantity.replace('_', ' ')} at {position:.9g}"
            self.faults.append(
                Fault(
                    message=f"axis {self.compensation.address}, {what}: {error}",
                    hint="correct the grid of this axis: `table: {start, end, spacing}` in the job",
                )
            )
            return "0"

    def values(self, index: int) -> dict[str, str]:
        """Return the correction at one table point as text, for each value field of the row."""
        definition, position = self.scale.definition, float(self.compensation.positions[index])
        sides = (self.compensation.positive, self.compensation.negative)
        return {
            definition.bindings[quantity].field: self.number(quantity, float(side[index]), position)
            for quantity, side in zip(curves(definition), sides, strict=False)
        }


class TableShape(ABC):
    """How a table stores positions and values in a file, with reading and writing.

    ``spacing``: whether the table points must be equally spaced ("equidistant") or not ("free").
    ``repeats``: whether the table of an endless axis can repeat after one turn.
    """

    rules: ClassVar[ShapeRules]
    spacing: ClassVar[Literal["equidistant", "free"]]
    repeats: ClassVar[bool]

    @abstractmethod
    def read(self, source: TableSource) -> GridTable | None:
        """Return the table in the lines ``source`` of the files; None if there is none or it is not
        valid (then with faults).
        """

    @abstractmethod
    def write(self, text: TableText) -> WrittenTable:
        """Return the text of a table with at least two points."""


def value_fields(definition: Definition) -> list[str]:
    """Return the names of the fields of a row that contain values."""
    return [definition.bindings[quantity].field for quantity in curves(definition)]


def table_of(positions: Sequence[Decimal], values: Sequence[tuple[Decimal, Decimal]]) -> GridTable:
    """Return a table from its positions and its corrections (+, -), all in mm or deg."""
    return GridTable(
        np.array([float(position) for position in positions]),
        np.array([float(value[0]) + 0.0 for value in values]),
        np.array([float(value[1]) + 0.0 for value in values]),
    )
