"""Values of a correction between axes that the engineer types into a column of a table.

Where the moving axis' table is among the files, the values are totals for all of its rows, in the
unit of the table. They replace the values in the column.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.families.columns.crossing import CrossFiller, correction_at_rows
from compwright.formats.families.columns.table import POSITION, ROW_NUMBER, UserTable, is_number
from compwright.formats.text.scale import EXACTNESS, NotHeld
from compwright.foundations.errors import InputError, raise_all
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import CrossCompensation
from compwright.records.plan import PlannedCross
from compwright.words.sentences import control_text

#: Decimal places of a value in mm or deg, one more in inch; a table may show more.
_DECIMALS = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class TypedColumn:
    """A correction between axes as it is typed into a column of a table at the control.

    ``where``: the table and the column. ``rows``: position and value of each row in the unit of
    the table, mm, inch or deg; ``unit``, ``position_unit``: these units. ``decimals``: decimal
    places of the values. ``total``: the values replace those in the column; otherwise they are
    added to them. ``more_rows``: whether the table has fewer rows now. ``added``: the correction
    that typing them in adds to the active one, mm or deg.
    """

    where: str
    rows: tuple[tuple[float, float], ...]
    unit: str
    position_unit: str
    decimals: int = _DECIMALS
    total: bool = False
    more_rows: bool = False
    added: CrossCompensation


def typed_column(filler: CrossFiller, entry: PlannedCross) -> TypedColumn:
    """Return the values of a correction for which the user's files have no place.

    Raises NotHeld, with the reason, if the table cannot contain it.
    """
    added = replace(entry.added, negative=entry.added.positive)
    sources = filler.sources
    table, column = sources.tables.get(added.input), sources.column_of(added.output)
    where = (
        _unknown_table(filler, entry)
        if table is None
        else control_text("{file}, column {column}", file=table.file, column=column)
    )
    scale = filler.values.scale(added.input, added.output_kind)
    sign = -1.0 if scale.sign("value") == "error" else 1.0
    unit, position_unit = str(added.output_kind.unit), str(added.input_kind.unit)
    if table is None:
        numbers = np.round(sign * added.positive, _DECIMALS) + 0.0
        rows = tuple(zip(added.positions.tolist(), numbers.tolist(), strict=True))
        held = replace(added, positive=sign * numbers, negative=sign * numbers)
        return TypedColumn(
            where=where, rows=rows, unit=unit, position_unit=position_unit, added=held
        )
    filler.refuse_shared(table)
    exact = filler.values.positions(table, added.input) or ()
    raise_all(InputError, filler.values.notes.faults)
    now = np.array([float(position) for position in exact])
    old = filler.values.values(table, column, exact, added.output, added.input)
    raise_all(InputError, filler.values.notes.faults)
    grid = _covering(filler, table, now, added)
    before = np.zeros(grid.size) if old is None else np.interp(grid, now, old)
    total = before + correction_at_rows(added, grid, table.file)
    filler.refuse_steep(table, grid, total)
    along, across = (
        float(filler.values.factor(table, kind)) for kind in (added.input_kind, added.output_kind)
    )
    decimals = max([_DECIMALS + int(across != 1.0), *_decimals(table)])
    numbers = np.round(sign * total / across, decimals) + 0.0
    more = sign * numbers * across - before
    return TypedColumn(
        where=where,
        rows=tuple(zip((grid / along).tolist(), numbers.tolist(), strict=True)),
        unit=unit if across == 1.0 else "inch",
        position_unit=position_unit if along == 1.0 else "inch",
        decimals=decimals,
        total=True,
        more_rows=grid.size > now.size,
        added=replace(added, positions=grid, positive=more, negative=more),
    )


def _unknown_table(filler: CrossFiller, entry: PlannedCross) -> str:
    """Return the text that names a table which is not among the files."""
    if filler.sources.assignments is None:
        return control_text(
            "the table (.COM) of {input}, column of {output}",
            input=entry.input,
            output=entry.output,
        )
    return control_text(
        "the table (.COM) that the active line of the .CMA names for the motion of {input} (a new"
        " one, where it names none), column of {output}",
        input=entry.input,
        output=entry.output,
    )


def _covering(
    filler: CrossFiller, table: UserTable, rows: FloatArray, added: CrossCompensation
) -> FloatArray:
    """Return the positions of a table's rows, with those that it needs in addition to reach over
    the correction, at the spacing of the rows. Raises NotHeld if these are too many, or if the
    table follows a rotary axis: the control uses only its rows from 0 to 360 degrees.
    """
    first, last = added.positions[0] + EXACTNESS, added.positions[-1] - EXACTNESS
    fixed = rows.size < 2 or added.input_kind is AxisKind.ROTARY
    if fixed and not rows[0] <= first <= last <= rows[-1]:
        correction_at_rows(added, rows, table.file)  # raises NotHeld: the rows do not cover it
    steps = np.diff(rows) if rows.size > 1 else np.ones(1)
    below = max(0, int(np.ceil((rows[0] - first) / steps[0])))
    above = max(0, int(np.ceil((last - rows[-1]) / steps[-1])))
    most = filler.family.definition.limit_number("max_points")
    if most is not None and rows.size + below + above > most:
        raise NotHeld(
            control_text(
                "{file} would need {rows} rows, and the control accepts {most}",
                file=table.file,
                rows=str(rows.size + below + above),
                most=str(most),
            )
        )
    start = rows[0] - steps[0] * np.arange(below, 0, -1)
    end = rows[-1] + steps[-1] * np.arange(1, above + 1)
    return np.concatenate([start, rows, end])


def _decimals(table: UserTable) -> Iterator[int]:
    """Yield the number of decimal places of each value in a table."""
    for row in table.rows:
        for name, cell in row.cells.items():
            if name not in (ROW_NUMBER, POSITION) and is_number(cell.text):
                yield len(cell.text.partition(".")[2])
