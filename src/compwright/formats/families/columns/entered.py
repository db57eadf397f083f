"""Every cell of a HEIDENHAIN's tables and every line of its parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.acting import bare_name
from compwright.formats.families.columns.table import (
    POSITION,
    RESERVED,
    ROW_NUMBER,
    SECOND,
    UserTable,
    is_number,
)
from compwright.formats.families.columns.table_reading import (
    is_other_table,
    is_user_table,
    read_table_text,
)
from compwright.formats.text.entered import Entered, by_statements
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile

#: Parameters beside those of the definition that act on an axis or its zero.
_ACTING = re.compile(r"MP(?:71[0-6]|720|730|75[0-2]|960)\b", re.IGNORECASE)
_INDEX = re.compile(r"MP[0-9]+\.([0-9]+)", re.IGNORECASE)


def entered(definition: Definition, files: Sequence[ControlFile]) -> dict[str, Entered]:
    """Return every value of the files. Raises InputError for a table that cannot be read."""
    faults: list[Fault] = []
    found: dict[str, Entered] = {}
    tables = [file for file in files if is_user_table(file) and not is_other_table(file)]
    for file in tables:
        table = read_table_text(definition, file, faults)
        found.update(_cells(table) if table is not None else ())
    raise_all(InputError, faults)
    rest = by_statements(definition, [file for file in files if file not in tables])
    for key, entry in rest.items():
        acts = entry.acts or _ACTING.search(entry.name) is not None
        found[key] = Entered(
            entry.name, entry.group, entry.text, entry.file, entry.line, entry.axis, acts
        )
    return found


def _cells(table: UserTable) -> Iterator[tuple[str, Entered]]:
    file = table.file
    for key, token in table.head.items():
        if key != "name":
            name = f"{file}: {key}"
            yield name, Entered(name, f"{file}: {key}", token.text, file, 1, "", acts=True)
    for number, row in enumerate(table.rows):
        for column, cell in row.cells.items():
            if column == ROW_NUMBER:
                continue
            name = f"{file} row {number} {column}"
            group = f"{file}: column {column}"
            yield name, Entered(name, group, cell.text, file, row.line, "", acts=True)


def whereabouts(
    entry: Entered, entries: Mapping[str, Entered], columns: Mapping[str, str]
) -> tuple[tuple[str, ...], float | None]:
    """Return the axes that a value belongs to (that whose column it is, that which moves), and the
    position of a row. ``columns``: the axis of a column's name.
    """
    match = re.fullmatch(r"(.*) row ([0-9]+) (\S+)", entry.name)
    if match is None:
        index = _INDEX.search(entry.name)
        number = columns.get(f"{int(index[1]) + 1}=F()", "") if index is not None else ""
        own = entry.axis or number
        return ((own,) if own else ()), None
    moving = bare_name(entry.file)
    column = columns.get(match[3], match[3])
    named = [column] if match[3] not in RESERVED or match[3] == SECOND else []
    axes = tuple(dict.fromkeys(moving if name == SECOND else name for name in (*named, moving)))
    return axes, _row(entries, entry.file, int(match[2]))


def _row(entries: Mapping[str, Entered], file: str, number: int) -> float | None:
    listed = entries.get(f"{file} row {number} {POSITION}")
    if listed is not None:
        return float(listed.text) if is_number(listed.text) else None
    datum, spacing = (entries.get(f"{file}: {key}") for key in ("datum", "spacing"))
    if datum is None or spacing is None or not is_number(datum.text + "0"):
        return None
    return float(datum.text) + number * float(spacing.text) if is_number(spacing.text) else None
