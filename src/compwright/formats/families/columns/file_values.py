"""Read every table cell and every parameter line in the files of a HEIDENHAIN control."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.active_tables import bare_name
from compwright.formats.families.columns.sources import AxisNumbers
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
from compwright.formats.text.file_values import FileValue, by_statements
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile, ControlState

#: Parameters that act on an axis or its zero, by their number.
_PARAMETERS = {
    range(710, 711): "backlash",
    range(711, 717): "reversal spikes",
    range(720, 721): "linear error",
    range(730, 731): "whether the line or the table is active",
    range(750, 753): "reversal error",
    range(960, 961): "machine datum",
}
_NUMBER = re.compile(r"MP([0-9]+)\b", re.IGNORECASE)
_WORDS = {POSITION: "position of the point", SECOND: "value for travel in -"}
_INDEX = re.compile(r"MP[0-9]+\.([0-9]+)", re.IGNORECASE)


def file_values(
    definition: Definition, files: Sequence[ControlFile], _: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every value of the files. Raises InputError for a table that cannot be read."""
    faults: list[Fault] = []
    found: dict[str, FileValue] = {}
    tables = [file for file in files if is_user_table(file) and not is_other_table(file)]
    for file in tables:
        table = read_table_text(definition, file, faults)
        found.update(_cells(table) if table is not None else ())
    raise_all(InputError, faults)
    rest = by_statements(definition, [file for file in files if file not in tables])
    for key, entry in rest.items():
        match = _NUMBER.search(entry.name)
        number = int(match[1]) if match is not None else 0
        meaning = next((words for known, words in _PARAMETERS.items() if number in known), "")
        relevant = entry.relevant or bool(meaning)
        found[key] = replace(entry, relevant=relevant, meaning=meaning or entry.meaning)
    return found


def _cells(table: UserTable) -> Iterator[tuple[str, FileValue]]:
    file = table.file
    for key, token in table.head.items():
        if key != "name":
            name = f"{file}: {key}"
            meaning = f"{key} of the table"
            yield name, FileValue(name, name, token.text, file, 1, relevant=True, meaning=meaning)
    for number, row in enumerate(table.rows):
        for column, cell in row.cells.items():
            if column == ROW_NUMBER:
                continue
            name = f"{file} row {number} {column}"
            group = f"{file}: column {column}"
            words = _WORDS.get(column, f"value of {column}" if table.kind == "values" else column)
            yield (
                name,
                FileValue(name, group, cell.text, file, row.line, relevant=True, meaning=words),
            )


def value_location(
    definition: Definition,
    entry: FileValue,
    entries: Mapping[str, FileValue],
    _: ControlState | None,
) -> tuple[tuple[str, ...], float | None]:
    """Return the axes of a table value (corrected axis, moving axis) and its position."""
    by_grid = "datum" in definition.fields  # columns are then named by number
    numbers = AxisNumbers(definition, ()).by_number if by_grid else {}
    columns = {f"{number}=F()": address for number, address in numbers.items()}
    columns |= {f"{number}": address for number, address in numbers.items()}  # of a .CMA
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


def _row(entries: Mapping[str, FileValue], file: str, number: int) -> float | None:
    listed = entries.get(f"{file} row {number} {POSITION}")
    if listed is not None:
        return float(listed.text) if is_number(listed.text) else None
    datum, spacing = (entries.get(f"{file}: {key}") for key in ("datum", "spacing"))
    if datum is None or spacing is None or not is_number(datum.text + "0"):
        return None
    return float(datum.text) + number * float(spacing.text) if is_number(spacing.text) else None
