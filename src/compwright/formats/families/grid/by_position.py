"""Rows that give their position."""

from __future__ import annotations

from decimal import Decimal

from compwright.formats.definition.kept_lines import NUMBER, KeptLines
from compwright.formats.definition.shape_rules import ShapeRules
from compwright.formats.families.grid.tables import (
    GridTable,
    TableShape,
    TableSource,
    TableText,
    WrittenTable,
    table_of,
)

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
    """Rows of position and values, ascending."""

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
        """See `TableShape.read`."""
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
        """See `TableShape.write`."""
        field = text.scale.definition.bindings["node_position"].field
        rows = [
            {field: text.number("node_position", float(position)), **text.values(index)}
            for index, position in enumerate(text.compensation.positions)
        ]
        return WrittenTable(tuple(rows), {})
