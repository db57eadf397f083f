"""Tables of one axis in two shapes: values by index at equal spacing, or rows with positions.

A table with values by index states its start, end and spacing once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.shape_rules import AXIS, NUMBER, KeptLines, ShapeRules
from compwright.formats.families.grid.tables import (
    GridTable,
    TableShape,
    TableSource,
    TableText,
    WrittenTable,
    table_of,
)
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.foundations.errors import Fault

#: How far (MAX - MIN) / STEP may be from a whole number when a file is read: without a word, and
#: as a step that was rounded when it was written (770 / 39 = 19.7436).
WHOLE_STEPS = Decimal("1e-6")
ROUNDED_STEPS = Decimal("1e-3")
#: Points closer together than this are one, mm or deg: far below what a control resolves, far above
#: the rounding of doubles.
SAME_POINT = 1e-9
_GRID = ("table_start", "table_end", "table_spacing")


_VALUE = rf"(?:{NUMBER}|'[HB][0-9A-F]+'|TRUE|FALSE|n/a|\"(?:{AXIS})?\"|\((?:{AXIS}|[0-9]+)?\))"
_INDEX = rf"\[\s*(?:{AXIS}|[0-9]+)(?:\s*,\s*(?:{AXIS}|[0-9]+))*\s*\]"
#: What a control calls its data: capitals, and no number that is long enough for a serial one.
_ADDRESS = r"(?-i:(?![A-Z0-9_]*[0-9]{5})[A-Z0-9_]+)"


class ByIndex(TableShape):
    """A table with values by index from 0, at equal spacing."""

    rules = ShapeRules(
        kept=KeptLines(
            (
                (
                    rf"(?:N[0-9]+\s+)?\$[MSA][NACD]S?_{_ADDRESS}(?:{_INDEX})?\s*(?:=|\s)\s*{_VALUE}"
                    r"(?:\s+'[0-9A-F]{4})?"
                ),
                r"CHANDATA\([0-9]{1,2}\)",
                r"METRIC|INCH|M17|M30|M0?2|M0|NEWCONF|STOPRE",
                (
                    r"%_N_(?:N?C?_?(?:AX[0-9]*|NC|CH[0-9]*|COMPLETE|INITIAL|TOA[0-9]*|UFR|EEC|CEC|QEC|TEA|SEA"
                    r"|INI|MPF|SPF|ACT|DIR)_?)+"
                ),
            )
        ),
        words="values by index on an equally spaced grid",
        grid=("table_start", "table_end", "table_spacing"),
        row="index",
    )
    spacing = "equidistant"
    repeats = True

    def read(self, source: TableSource) -> GridTable | None:
        """Return the table; None if missing, not valid or never written; see `TableShape.read`."""
        if not source.rows and not source.singles:
            return None
        if is_blank(source):
            source.notes.find("CW-S032", "info", label=source.label)
            return None
        if not _whole(source):
            return None
        values = indexed(source)
        grid = None if values is None else _steps(source, values)
        if values is None or grid is None or not _complete(source, values, grid):
            return None
        positions = [grid.start + index * grid.spacing for index in range(grid.steps + 1)]
        pairs = [source.values(values[index], place) for index, place in enumerate(positions)]
        sound = [pair for pair in pairs if pair is not None]
        return table_of(positions, sound) if len(sound) == len(pairs) else None

    def write(self, text: TableText) -> WrittenTable:
        """Return the text of a table by index, which needs equal spacing; see `TableShape.write`.

        If the grid stays the same, start, end and spacing keep their existing text with all its
        decimal places.
        """
        positions, scale = text.compensation.positions, text.scale
        rows = tuple({"index": str(index), **text.values(index)} for index in range(positions.size))
        if _stays(text):
            return WrittenTable(rows, {name: text.there[name] for name in _GRID})
        spacing = float(positions[-1] - positions[0]) / (positions.size - 1)
        numbers = (float(positions[0]), float(positions[-1]), spacing)
        singles = {
            name: text.number(name, number) for name, number in zip(_GRID, numbers, strict=True)
        }
        even = positions[0] + spacing * np.arange(positions.size)
        worst = float(np.max(np.abs(positions - even)))
        if worst > scale.quantum("table_spacing") / 2:
            text.faults.append(
                Fault(
                    message=f"axis {text.compensation.address}: the points of the table are not "
                    "equally spaced",
                    expected=f"a point every {spacing:.9g} {scale.kind.unit}",
                    found=f"a point that deviates by {worst:.6g} {scale.kind.unit}",
                    hint="give `table: {spacing: ...}` for this axis, so that a new grid is made",
                )
            )
        return WrittenTable(rows, singles)


def _stays(text: TableText) -> bool:
    """Return whether the new table has the start, end and spacing of the table in the files."""
    if not set(_GRID) <= text.there.keys():
        return False
    start, end, step = (text.scale.read(name, text.there[name]) for name in _GRID)
    if step <= 0:
        return False
    positions, ratio = text.compensation.positions, (end - start) / step
    steps = round(ratio)
    if steps + 1 != positions.size or abs(ratio - steps) > ROUNDED_STEPS:
        # an end between two points would leave it to the control which of them is the last one
        return False
    there = np.array([float(start + index * step) for index in range(positions.size)])
    return bool(np.all(np.abs(there - positions) < SAME_POINT))


def is_blank(source: TableSource) -> bool:
    """Return whether all values of a table, its start, end and spacing are zero, because no table
    was ever stored.
    """
    values = [
        row.occurrence.tokens[name].text for row in source.rows for name in source.value_fields
    ]
    grid = [found.text for found in source.singles.values()]
    return bool(grid) and all(Decimal(text) == 0 for text in (*values, *grid))


def _whole(source: TableSource) -> bool:
    """Return whether the files contain a table's start, end and spacing, and at least one of its
    values.
    """
    definition = source.scale.definition
    forms = {
        name: definition.statements[definition.bindings[name].statement].form for name in _GRID
    }
    missing = [form for name, form in forms.items() if name not in source.singles]
    if missing:
        expected = ", ".join(missing).replace("{", "<").replace("}", ">")
        source.fault("the table has no grid", expected=expected, what="no such line")
    elif not source.rows:
        source.fault(
            "the files contain a grid without values, so they are cut short, not an empty table"
        )
    return bool(source.rows) and not missing


def indexed(source: TableSource) -> dict[int, FoundValue] | None:
    """Return the rows by index; None (with faults) if two rows with the same index differ."""
    values: dict[int, FoundValue] = {}
    clean = True
    for row in source.rows:
        index = int(row.occurrence.tokens["index"].text)
        first = values.setdefault(index, row)
        for name in source.value_fields:
            text, expected = row.occurrence.tokens[name].text, first.occurrence.tokens[name].text
            if not same_value(text, expected):
                message = f"value {index} contradicts {first.where}"
                source.fault(message, row, expected=expected, what=text)
                clean = False
    return values if clean else None


@dataclass(frozen=True, slots=True)
class _Grid:
    """The positions of equally spaced points: start, spacing, and number of spacings.

    ``beyond``: the table has one more point, which the control may use or not. Its value is the
    same as that of the last point.
    """

    start: Decimal
    spacing: Decimal
    steps: int
    beyond: bool = False


def _steps(source: TableSource, values: Mapping[int, FoundValue]) -> _Grid | None:
    """Return start, spacing and number of spacings of the table in the files.

    If the table's end lies between two points, it is not known whether the control uses the second
    one. Such a table is accepted only if both points have the same value.
    """
    start, end, step = (source.position(name, source.singles[name]) for name in _GRID)
    if start is None or end is None or step is None:
        return None
    if step <= 0:
        what, message = source.singles["table_spacing"], "the spacing is not positive"
        source.fault(message, what, expected="more than 0", what=str(step))
        return None
    if end <= start:
        what, message = source.singles["table_end"], "the end is not above the start"
        source.fault(message, what, expected=f"more than {start}", what=str(end))
        return None
    ratio = (end - start) / step
    steps = int(ratio.to_integral_value())
    division = f"({end} - {start}) / {step} = {float(ratio):.6f}"
    if steps >= 1 and abs(ratio - steps) <= ROUNDED_STEPS:
        if abs(ratio - steps) > WHOLE_STEPS:
            evidence = f"inferred: {division}; a step that was rounded when it was written"
            source.notes.assume(f"{source.label}: spacings of its table", str(steps), evidence)
        return _Grid(start, step, steps)
    inside = int(ratio)
    if inside >= 1 and not source.ends_at_point and _alike(source, values, inside):
        evidence = f"{division}: the values on both sides of the end are the same"
        source.notes.assume(f"{source.label}: spacings of its table", str(inside), evidence)
        return _Grid(start, step, inside, beyond=True)
    source.fault(
        "the spacing does not divide the length of the table, and its values on both sides of the"
        " end differ",
        source.singles["table_spacing"],
        expected="(end - start) / spacing a whole number, or the same value in both",
        what=division,
    )
    return None


def _alike(source: TableSource, values: Mapping[int, FoundValue], inside: int) -> bool:
    """Return whether the row after the last point, whose index is ``inside``, repeats the value of
    this point; for a table of zeros, only whether the last point has a row.
    """
    held = [
        [Decimal(row.occurrence.tokens[name].text) for name in source.value_fields]
        for row in values.values()
    ]
    if not any(value != 0 for row in held for value in row):
        return inside in values
    pair = [values[index] for index in (inside, inside + 1) if index in values]
    texts = [[row.occurrence.tokens[name].text for name in source.value_fields] for row in pair]
    return len(texts) == 2 and all(map(same_value, *texts))


def _complete(source: TableSource, values: Mapping[int, FoundValue], grid: _Grid) -> bool:
    """Return whether every table point has a value.

    Values after the end are only reported, because the control does not use them. They can be left
    from an older, longer table (SINUMERIK FB2 09/2009, 6FC5397-1BP20-0BA0, p362 and p370: values
    greater than k are ignored).
    """
    steps = grid.steps
    # one of the first len(values) + 1 indices is free; a few more make the message useful, however
    # wild the grid is
    absent = [str(index) for index in range(min(steps + 1, len(values) + 8)) if index not in values]
    if absent:
        source.fault(
            "values are missing; a file that was cut short?",
            expected=f"{steps + 1} values, 0 to {steps}",
            what=f"{len(values)} values, without {', '.join(absent[:8])}",
        )
        return False
    extra = sorted(index for index in values if index > steps + grid.beyond)
    held = [
        index
        for index in extra
        if any(
            Decimal(values[index].occurrence.tokens[name].text) != 0 for name in source.value_fields
        )
    ]
    if held:
        source.notes.find(
            "CW-S004.not_zero",
            "warning",
            label=source.label,
            values=len(extra),
            first=extra[0],
            last=extra[-1],
            not_zero=len(held),
        )
    elif extra:
        source.notes.find("CW-S004.zero", "info", label=source.label, values=len(extra))
    return True


#: The sections and keys of settings of a machine other than its compensation.
_SECTIONS = (
    r"EMC|DISPLAY|FILTER|RS274NGC|EMCMOT|TASK|HAL|HALUI|APPLICATIONS|TRAJ|KINS|EMCIO|EMCSERVER"
    r"|(?:JOINT|SPINDLE)_[0-9]{1,2}|AXIS_[A-Z0-9]"
)
_SETTINGS = (
    r"(?:MIN|MAX|HOME|STEPGEN|DEFAULT|FERROR|SCALE|INPUT_SCALE|OUTPUT_SCALE|ENCODER_SCALE|JOINTS"
    r"|SERVO|BASE|CYCLE|STEP|STEPLEN|STEPSPACE|DIRSETUP|DIRHOLD|DEADBAND|BIAS|FF[0-3]|[PID]"
    r"|BACKLASH|COMP_FILE_TYPE|LOCKING|VOLATILE|LATCH|INCREMENTS|SPINDLES|POSITION|NO_FORCE)"
)


class ByPosition(TableShape):
    """A table with rows of position and value, positions ascending."""

    rules = ShapeRules(
        kept=KeptLines(
            (
                rf"\[(?:{_SECTIONS})\]",
                rf"{_SETTINGS}(?:_[A-Z0-9_]+)?\s*=\s*{NUMBER}(?:\s+{NUMBER})*",
            )
        ),
        words="rows by position, freely spaced",
        grid=("node_position",),
        row="position",
        afresh=True,
        repeats_turns=True,
    )
    spacing = "free"
    repeats = False

    def read(self, source: TableSource) -> GridTable | None:
        """Return the table with its listed positions; see `TableShape.read`."""
        positions: list[Decimal] = []
        pairs: list[tuple[Decimal, Decimal]] = []
        for row in source.rows:
            position = source.position("node_position", row)
            if position is None:
                return None
            if positions and position <= positions[-1]:
                expected = f"more than {positions[-1]}"
                source.fault(
                    "the positions do not ascend", row, expected=expected, what=str(position)
                )
                return None
            pair = source.values(row, position)
            if pair is None:
                return None
            positions.append(position)
            pairs.append(pair)
        return table_of(positions, pairs) if positions else None

    def write(self, text: TableText) -> WrittenTable:
        """Return the text of a table with listed positions; see `TableShape.write`."""
        field = text.scale.definition.bindings["node_position"].field
        rows = [
            {field: text.number("node_position", float(position)), **text.values(index)}
            for index, position in enumerate(text.compensation.positions)
        ]
        return WrittenTable(tuple(rows), {})


SHAPES: Mapping[str, TableShape] = {
    "values_by_index": ByIndex(),
    "rows_by_position": ByPosition(),
}


def shape_of(definition: Definition) -> TableShape:
    """Return the object that reads and writes the control's tables in their shape."""
    return SHAPES[definition.layout.shape]
