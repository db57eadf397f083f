"""Read every value in the lists of an ISG kernel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.families.lists.coupling import COUPLING
from compwright.formats.families.lists.files import HEADERS, value_of, without_remarks
from compwright.formats.text.file_values import FileValue, by_statements, texts_of
from compwright.formats.text.texts import text_reader
from compwright.records.correction import ControlFile


def file_values(
    definition: Definition, files: Sequence[ControlFile], _: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every value in the lists by a key that contains the axis number instead of the file
    name.

    The key keeps the file name if the list states no axis number, or if the other key exists
    already. Raises InputError for a file that cannot be opened.
    """
    reader = text_reader(definition)
    found: dict[str, FileValue] = {}
    for file in texts_of(files):
        code = ControlFile(file.name, without_remarks(file.content))
        text = reader.read(code, [])
        places = text.occurrences if text is not None else ()
        headers = (value_of(each) for each in places if each.statement in HEADERS)
        axis = next((str(int(number)) for number in headers), "")
        values = by_statements(definition, [code])
        for key, entry in (_coupling(*one) for one in values.items()):
            by_axis = key.replace(file.name, f"axis {axis}", 1) if axis else key
            found[key if by_axis in found else by_axis] = replace(entry, axis=entry.axis or axis)
    return found


def _coupling(key: str, entry: FileValue) -> tuple[str, FileValue]:
    """Return a value under its key; in a line that couples axes, the value is separated from the
    name.
    """
    name, blank, value = entry.group.partition(" ")
    if not (blank and COUPLING.match(name)):
        return key, entry
    label = entry.name.removesuffix(blank + value)
    return (
        key.replace(entry.group, name),
        replace(entry, name=label, group=name, text=value, relevant=True),
    )
