"""The closed list of table shapes, each with its reading and its writing: values by index, rows by
position.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Definition, Shape
from compwright.formats.text.gathering import Found, same_value
from compwright.formats.text.scale import NotHeld, Scale, in_range
from compwright.foundations.errors import Fault
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation

#: How far (MAX - MIN) / STEP may be from a whole number when a file is read.
WHOLE_STEPS = Decimal("1e-6")


@dataclass(slots=True)
class TableSource:
    """What was found for one table. ``label`` names it in messages; ``singles``: start, end and
    spacing.
    """

    label: str
    rows: Sequence[Found]
    singles: Mapping[str, Found]
    faults: list[Fault]
    findings: list[Finding]

    def fault(
        self, message: str, found: Found | None = None, *, expected: str = "", what: str = ""
    ) -> None:
        """Note a fault, at the line of ``found`` or else of the first thing that was found."""
        place = found or next(iter((*self.rows, *self.singles.values())), None)
        self.faults.append(
            Fault(
                message=f"{self.label}: {message}",
                file=place.occurrence.file if place else "",
                place=place.occurrence.place if place and found else "",
                expected=expected,
                found=what,
            )
        )


@dataclass(frozen=True, slots=True)
class Table:
    """Nodes (k,) strictly ascending and the correction (k,) of each direction, mm or deg."""

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray


@dataclass(frozen=True, slots=True)
class WrittenTable:
    """The fields of each row and the single values (by quantity) that belong to the table, as
    text.
    """

    rows: tuple[Mapping[str, str], ...]
    singles: Mapping[str, str]


def read_table(definition: Definition, source: TableSource, scale: Scale) -> Table | None:
    """Return the table that was found; None when there is none, or when something is wrong with it
    (then ``source`` has faults).
    """
    return _READERS[definition.layout.shape](definition, source, scale)


def write_table(
    definition: Definition, compensation: AxisCompensation, scale: Scale, faults: list[Fault]
) -> WrittenTable:
    """Return the text of a table; what the control's text cannot say exactly goes to ``faults``."""
    return _WRITERS[definition.layout.shape](definition, compensation, scale, faults)


def _read_values(
    definition: Definition, row: Found, scale: Scale, source: TableSource, position: Decimal
) -> tuple[Decimal, Decimal] | None:
    values = []
    for quantity in curves(definition):
        measure = definition.measure(quantity)
        text = row.occurrence.tokens[measure.field].text
        value = scale.read(quantity, text, position)
        if not in_range(measure, scale, value):
            low, high = scale.range(quantity)
            source.fault(
                "a correction this large is not plausible",
                row,
                expected=f"{low:g} .. {high:g} {scale.kind.unit}",
                what=f"{float(value):g} {scale.kind.unit} from {text}",
            )
            return None
        values.append(value)
    return values[0], values[-1]


def _read_position(
    definition: Definition, found: Found, quantity: str, scale: Scale, source: TableSource
) -> Decimal | None:
    measure = definition.measure(quantity)
    text = found.occurrence.tokens[measure.field].text
    value = scale.read(quantity, text)
    if in_range(measure, scale, value):
        return value
    low, high = scale.range(quantity)
    source.fault(
        "a position this large is not plausible",
        found,
        expected=f"{low:g} .. {high:g} {scale.kind.unit}",
        what=text,
    )
    return None


def _table(positions: Sequence[Decimal], values: Sequence[tuple[Decimal, Decimal]]) -> Table:
    return Table(
        np.array([float(position) for position in positions]),
        np.array([float(value[0]) + 0.0 for value in values]),
        np.array([float(value[1]) + 0.0 for value in values]),
    )


def _read_by_index(definition: Definition, source: TableSource, scale: Scale) -> Table | None:
    grid = {
        name: source.singles.get(name) for name in ("table_start", "table_end", "table_spacing")
    }
    if not source.rows and not any(grid.values()):
        return None
    if is_blank(definition, source):
        source.findings.append(
            Finding(
                "CW-S032",
                "info",
                f"{source.label}: values and grid are all zero, which means no table",
            )
        )
        return None
    forms = {name: definition.statements[definition.bindings[name].statement].form for name in grid}
    missing = [forms[name] for name, found in grid.items() if found is None]
    if missing:
        source.fault(
            "the table has no grid",
            expected=", ".join(missing).replace("{", "<").replace("}", ">"),
            what="no such line",
        )
        return None
    if not source.rows:
        source.fault(
            "the files name a grid but hold no values: this is contradictory, not an empty table"
        )
        return None
    values = _indexed(definition, source)
    count = _steps(definition, source, scale)
    if values is None or count is None:
        return None
    start, step, steps = count
    # one of the first len(values) + 1 indices is free; a few more make the message useful, however
    # wild the grid is
    absent = [str(index) for index in range(min(steps + 1, len(values) + 8)) if index not in values]
    if absent:
        source.fault(
            "values are missing; a file that was cut short?",
            expected=f"{steps + 1} values, 0 to {steps}",
            what=f"{len(values)} values, without {', '.join(absent[:8])}",
        )
        return None
    if not _unused(definition, source, values, steps):
        return None
    positions = [start + index * step for index in range(steps + 1)]
    pairs = [
        _read_values(definition, values[index], scale, source, positions[index])
        for index in range(steps + 1)
    ]
    whole = [pair for pair in pairs if pair is not None]
    return _table(positions, whole) if len(whole) == len(pairs) else None


def is_blank(definition: Definition, source: TableSource) -> bool:
    """Return whether everything that was found is zero, the grid too: memory that nobody has
    written.
    """
    fields = [definition.bindings[quantity].field for quantity in curves(definition)]
    values = [row.occurrence.tokens[name].text for row in source.rows for name in fields]
    grid = [found.text for found in source.singles.values()]
    return bool(grid) and all(Decimal(text) == 0 for text in (*values, *grid))


def _indexed(definition: Definition, source: TableSource) -> dict[int, Found] | None:
    fields = [definition.bindings[quantity].field for quantity in curves(definition)]
    values: dict[int, Found] = {}
    clean = True
    for row in source.rows:
        index = int(row.occurrence.tokens["index"].text)
        first = values.setdefault(index, row)
        for name in fields:
            if not same_value(row.occurrence.tokens[name].text, first.occurrence.tokens[name].text):
                source.fault(
                    f"value {index} contradicts {first.where}",
                    row,
                    expected=first.occurrence.tokens[name].text,
                    what=row.occurrence.tokens[name].text,
                )
                clean = False
    return values if clean else None


def _steps(
    definition: Definition, source: TableSource, scale: Scale
) -> tuple[Decimal, Decimal, int] | None:
    """Return start, spacing and the number of spacings."""
    read = [
        _read_position(definition, source.singles[name], name, scale, source)
        for name in ("table_start", "table_end", "table_spacing")
    ]
    start, end, step = read
    if start is None or end is None or step is None:
        return None
    if step <= 0:
        source.fault(
            "the spacing is not positive",
            source.singles["table_spacing"],
            expected="more than 0",
            what=str(step),
        )
        return None
    if end <= start:
        source.fault(
            "the end is not above the start",
            source.singles["table_end"],
            expected=f"more than {start}",
            what=str(end),
        )
        return None
    ratio = (end - start) / step
    steps = int(ratio.to_integral_value())
    if steps < 1 or abs(ratio - steps) > WHOLE_STEPS:
        source.fault(
            "the spacing does not divide the length of the table",
            source.singles["table_spacing"],
            expected="(end - start) / spacing a whole number",
            what=f"({end} - {start}) / {step} = {float(ratio):.6f}",
        )
        return None
    return start, step, steps


def _unused(
    definition: Definition, source: TableSource, values: Mapping[int, Found], steps: int
) -> bool:
    """Values behind the end are memory that the control does not use; they must be zero to be
    believed.
    """
    fields = [definition.bindings[quantity].field for quantity in curves(definition)]
    extra = [index for index in values if index > steps]
    for index in sorted(extra):
        if any(Decimal(values[index].occurrence.tokens[name].text) != 0 for name in fields):
            source.fault(
                f"value {index} lies behind the end of the table",
                values[index],
                expected=f"values 0 to {steps}",
                what=f"{len(values)} values",
            )
            return False
    if extra:
        source.findings.append(
            Finding(
                "CW-S004",
                "info",
                f"{source.label}: {len(extra)} values behind the end of the table are zero and not"
                " used",
            )
        )
    return True


def _read_by_position(definition: Definition, source: TableSource, scale: Scale) -> Table | None:
    positions: list[Decimal] = []
    pairs: list[tuple[Decimal, Decimal]] = []
    for row in source.rows:
        position = _read_position(definition, row, "node_position", scale, source)
        if position is None:
            return None
        if positions and position <= positions[-1]:
            source.fault(
                "the positions do not ascend",
                row,
                expected=f"more than {positions[-1]}",
                what=str(position),
            )
            return None
        pair = _read_values(definition, row, scale, source, position)
        if pair is None:
            return None
        positions.append(position)
        pairs.append(pair)
    return _table(positions, pairs) if positions else None


def _write_by_index(
    definition: Definition, compensation: AxisCompensation, scale: Scale, faults: list[Fault]
) -> WrittenTable:
    positions = compensation.positions
    spacing = float(positions[-1] - positions[0]) / (positions.size - 1)
    singles = {}
    for quantity, value in (
        ("table_start", positions[0]),
        ("table_end", positions[-1]),
        ("table_spacing", spacing),
    ):
        singles[quantity] = _text(scale, quantity, float(value), 0.0, compensation, faults)
    even = positions[0] + spacing * np.arange(positions.size)
    worst = float(np.max(np.abs(positions - even)))
    if worst > scale.quantum("table_spacing") / 2:
        faults.append(
            Fault(
                message=f"axis {compensation.address}: the nodes are not equally spaced",
                expected=f"every {spacing:.9g} {scale.kind.unit}",
                found=f"a node {worst:.6g} {scale.kind.unit} away from its place",
            )
        )
    rows = [
        {"index": str(index), **_value_texts(definition, compensation, index, scale, faults)}
        for index in range(positions.size)
    ]
    return WrittenTable(tuple(rows), singles)


def _write_by_position(
    definition: Definition, compensation: AxisCompensation, scale: Scale, faults: list[Fault]
) -> WrittenTable:
    field = definition.bindings["node_position"].field
    rows = [
        {
            field: _text(scale, "node_position", float(position), 0.0, compensation, faults),
            **_value_texts(definition, compensation, index, scale, faults),
        }
        for index, position in enumerate(compensation.positions)
    ]
    return WrittenTable(tuple(rows), {})


def _value_texts(
    definition: Definition,
    compensation: AxisCompensation,
    index: int,
    scale: Scale,
    faults: list[Fault],
) -> dict[str, str]:
    position = float(compensation.positions[index])
    sides = (compensation.positive, compensation.negative)
    return {
        definition.bindings[quantity].field: _text(
            scale, quantity, float(sides[side][index]), position, compensation, faults
        )
        for side, quantity in enumerate(curves(definition))
    }


def _text(
    scale: Scale,
    quantity: str,
    value: float,
    position: float,
    compensation: AxisCompensation,
    faults: list[Fault],
) -> str:
    try:
        return scale.write(quantity, value, position)
    except NotHeld as error:
        faults.append(
            Fault(
                message=(
                    f"axis {compensation.address}, {quantity.replace('_', ' ')} at {position:.9g}:"
                    f" {error}"
                )
            )
        )
        return "0"


_READERS: Mapping[Shape, Callable[[Definition, TableSource, Scale], Table | None]] = {
    "values_by_index": _read_by_index,
    "rows_by_position": _read_by_position,
}
_WRITERS: Mapping[
    Shape, Callable[[Definition, AxisCompensation, Scale, list[Fault]], WrittenTable]
] = {
    "values_by_index": _write_by_index,
    "rows_by_position": _write_by_position,
}
