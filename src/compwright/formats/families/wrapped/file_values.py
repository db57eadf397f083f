"""Read every value of PMAC scripts.

Entries of tables are named by motor and entry number, so file and line breaks do not matter.
Variables are named by their number. All other lines are read one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.families.wrapped.card_memory import MemoryTable
from compwright.formats.families.wrapped.preprocessor import whole_value
from compwright.formats.families.wrapped.script import read_script
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.file_values import FileValue, by_statements, texts_of
from compwright.records.correction import ControlFile


def file_values(
    definition: Definition, files: Sequence[ControlFile], _: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every value of the scripts. Raises InputError for a file that cannot be opened."""
    texts = texts_of(files)
    scripts = [text for text in texts if not is_entry_sheet(text)]
    tables = read_script(definition, scripts).tables.values()
    known = {(word.file, word.line) for table in tables for word in (table.word, *table.values)}
    of_tables = {
        definition.bindings[name].statement
        for name in ("table_end", "value_positive", "value_negative")
    } | {"lost_motion_table"}
    found = {
        key: replace(entry, text=_number(entry.text))
        for key, entry in by_statements(definition, scripts).items()
        if entry.group not in of_tables and (entry.file, entry.line) not in known
    }
    found.update(by_statements(definition, [text for text in texts if is_entry_sheet(text)]))
    for table in tables:
        found.update(_values(table))
    return found


def _values(table: MemoryTable) -> Iterator[tuple[str, FileValue]]:
    name = f"#{table.motor} {table.kind}"
    size = {"entries": table.entries, "length": table.length}
    looked_up = f"#{table.source}{'D' * table.desired},#{table.target}"
    places = {f"[{place}]": word for place, word in enumerate(table.values, 1)}

    def value(what: str, text: str) -> tuple[str, FileValue]:
        return f"|{name}|{what}", FileValue(
            f"{name} {what}",
            name,
            text,
            "",
            0,
            axis=str(table.target or table.motor),
            relevant=table.kind != "TCOMP",
        )

    yield value("source and target", looked_up)
    for what, word in {**size, **places}.items():
        if word is not None:
            yield value(what, word.text)


def _number(text: str) -> str:
    number = whole_value(text, {})
    return text if number is None else str(number)
