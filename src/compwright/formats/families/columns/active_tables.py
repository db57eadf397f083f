"""Decide which tables are active, and the motion of which axis each active table follows."""

from __future__ import annotations

import re
from collections.abc import Sequence

from compwright.formats.definition.statements import field_matches
from compwright.formats.families.columns.sources import Sources
from compwright.formats.families.columns.table import ACTIVE, RESERVED, ROW_NUMBER, Row, UserTable
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis


def activate(
    sources: Sources, tables: Sequence[UserTable], axes: Sequence[Axis], faults: list[Fault]
) -> None:
    """Add each active table to ``sources``, under the axis whose motion the table follows.

    The active line of the .CMA file states this axis. Without a .CMA file, the name of the table
    states it.
    """
    values = [table for table in tables if table.kind == "values"]
    lines = [table for table in tables if table.kind == "assignments"]
    if len(lines) > 1:
        faults.append(
            Fault(
                message="the files contain several .CMA files (tables that assign .COM tables "
                "to axes), but only one can be active",
                file=", ".join(table.file for table in lines),
                expected="one .CMA file",
                hint="give only the .CMA file that was active during the test",
            )
        )
        return
    if lines:
        sources.assignments = lines[0]
        sources.active = _active_row(sources, lines[0], faults)
        _assigned(sources, values, faults)
        return
    for table in values:
        address = _named_axis(sources, table, axes, faults)
        if address is None:
            continue
        if address in sources.tables:
            faults.append(
                Fault(
                    message=f"the files contain two tables for axis {address}",
                    file=table.file,
                    expected="one table",
                    found=f"another one in {sources.tables[address].file}",
                    hint="give only the one that was active during the test",
                )
            )
        sources.tables[address] = table
        sources.assumed[table.file] = address


def _active_row(sources: Sources, table: UserTable, faults: list[Fault]) -> Row | None:
    column = next((name for name in ACTIVE if table.column(name) is not None), None)
    if column is None:
        if len(table.rows) == 1 and sources.numbered:
            return table.rows[0]
        what = (
            "a column ACTIVE"
            if not sources.numbered
            else "a single line, or a column ACTIVE or STATUS"
        )
        faults.append(
            Fault(
                message="the files do not show which line of the .CMA file is active",
                file=table.file,
                expected=what,
                hint=(
                    "give the .CMA file, with the mark in its active line, among the control's "
                    "files"
                ),
            )
        )
        return None
    marks = ("*", "M") if sources.numbered else ("*",)
    marked = [
        row for row in table.rows if column in row.cells and row.cells[column].text.upper() in marks
    ]
    if len(marked) > 1:
        faults.append(
            Fault(
                message="several lines of the .CMA file are marked as active",
                file=table.file,
                place=marked[1].place,
                expected=f"one mark {marks[0]} in the column {column}",
                hint="mark only the line that was active during the test",
            )
        )
    if not marked and sources.numbered and len(table.rows) == 1:
        return table.rows[0]
    return marked[0] if marked else None


def bare_name(text: str) -> str:
    """Return the name of a table without folder and ending, in capitals."""
    return re.sub(r"\.(COM|CMO)$", "", re.split(r"[/\\:]", text)[-1].upper())


def _assigned(sources: Sources, values: Sequence[UserTable], faults: list[Fault]) -> None:
    cells = sources.active.cells if sources.active is not None else {}
    used: list[UserTable] = []
    for column, cell in cells.items():
        if column in (ROW_NUMBER, *ACTIVE):
            continue
        wanted = bare_name(cell.text)
        address = sources.axis_of(column, assigned=True)
        if address in sources.tables or address in sources.missing:
            file = sources.assignments.file if sources.assignments is not None else ""
            faults.append(
                Fault(
                    message=f"axis {address} is in two columns of the .CMA file",
                    file=file,
                    expected="one column",
                    found=column,
                    hint=(
                        "remove one of the columns from the .CMA file at the control, then export "
                        "it again"
                    ),
                )
            )
        exact = [table for table in values if bare_name(table.file) == wanted]
        fitting = exact or [table for table in values if bare_name(table.name) == wanted]
        if len(fitting) > 1:
            faults.append(
                Fault(
                    message=f"the files contain several tables with the name {cell.text} for "
                    f"axis {address}",
                    file=", ".join(table.file for table in fitting),
                    expected="one table",
                    hint="give only one table of this name",
                )
            )
        if fitting:
            sources.tables[address] = fitting[0]
            used.append(fitting[0])
        else:
            sources.missing[address] = cell.text
    sources.idle = [table for table in values if table not in used]


def _named_axis(
    sources: Sources, table: UserTable, axes: Sequence[Axis], faults: list[Fault]
) -> str | None:
    """Return the axis whose motion a table follows, by the table's file name and by the name in its
    first line; None, with a fault, if these do not name exactly one axis.
    """
    definition = sources.definition
    names = [
        name for name in (table.name, table.file.rpartition(".")[0]) if field_matches("name", name)
    ]
    addresses = list(dict.fromkeys(normal_text(definition, name) for name in names))
    axis_names = {
        *sources.numbers.by_number.values(),
        *(normal_address(definition, axis)[0] for axis in axes),
    }
    if not sources.numbered:
        axis_names |= {column.name for column in table.columns if column.name not in RESERVED}
    fitting = [address for address in addresses if address in axis_names]
    if len(fitting) != 1:
        faults.append(
            Fault(
                message="the files do not show to which moving axis this table belongs",
                file=table.file,
                place="line 1",
                expected="the .CMA file too, or a table with the name of its axis",
                found=" and ".join(fitting or names) or table.name,
                hint="give the .CMA file too, or name the table file after its axis",
            )
        )
        return None
    return fitting[0]
