"""All values in a control's files by their names, independent of line order and layout."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from compwright.formats.definition.schema import Definition
from compwright.formats.text.container import unpacked
from compwright.formats.text.diff import entries_of
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.gathering import same_value
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile

_SETTING = re.compile(r"[ \t]*([^=:]+?)[ \t]*[=:][ \t]*(.*?)[ \t]*")
#: Quantities of a definition that compensate nothing.
SILENT_QUANTITIES = frozenset({"limit_low", "limit_high", "axis_name"})
_SECTION = re.compile(r"[ \t]*\[([^\]]+)\][ \t]*")


@dataclass(frozen=True, slots=True)
class FileValue:
    """One value in the files with the name that it has on the control.

    - ``name``: the control's text up to the value.
    - ``group``: a common name for counting entries of the same kind.
    - ``axis``: the address that the entry names; empty if it names none.
    - ``relevant``: the value belongs to a compensation, or decides the unit, kind or zero of an
      axis.
    - ``meaning``: in words; empty if unknown.
    """

    name: str
    group: str
    text: str
    file: str
    line: int
    axis: str = ""
    relevant: bool = False
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class FileValueChange:
    """One value that differs between two sets of files; ``old`` or ``new`` is None if that set does
    not contain the value.
    """

    old: FileValue | None
    new: FileValue | None

    @property
    def entry(self) -> FileValue:
        """The new value, or the old one if the new files do not contain it."""
        found = self.new or self.old
        if found is None:
            raise ValueError
        return found


FileValues = Mapping[str, FileValue]


def changes(old: FileValues, new: FileValues) -> tuple[FileValueChange, ...]:
    """Return the values that differ, in the order of the new files, then those that were removed.

    Numbers are equal whatever their number of decimals, and TRUE equals 1.
    """
    found = [
        FileValueChange(old.get(key), entry)
        for key, entry in new.items()
        if key not in old or not same_text(old[key].text, entry.text)
    ]
    return (*found, *(FileValueChange(entry, None) for key, entry in old.items() if key not in new))


def same_text(first: str, second: str) -> bool:
    """Return whether two values are equal as text, as numbers, or as truth values."""
    truth = {"TRUE": "1", "FALSE": "0"}
    one, other = (truth.get(text.upper(), text) for text in (first, second))
    return one == other or same_value(one, other)


def texts_of(files: Sequence[ControlFile]) -> tuple[ControlFile, ...]:
    """Return the texts in files, with each archive replaced by its texts. Raises InputError for an
    archive that cannot be opened.
    """
    faults: list[Fault] = []
    texts = unpacked(files, faults)
    raise_all(InputError, faults)
    return tuple(ControlFile(text.name.rpartition(": ")[2], text.content) for text in texts)


def by_statements(definition: Definition, files: Sequence[ControlFile]) -> dict[str, FileValue]:
    """Return all values of files, each under a unique key: values in statements of the definition,
    then the values in all lines that are no statement.

    Values in other lines are identified by their name and the section of the file.
    """
    found: dict[str, FileValue] = {}
    texts = texts_of(files)
    quantities: dict[str, list[str]] = {}
    for quantity, binding in definition.bindings.items():
        quantities.setdefault(binding.statement, []).append(quantity)
    for key, entry in entries_of(definition, texts):
        bound = quantities.get(key[1], [])
        meaning = ", ".join(bound).replace("_", " ")
        relevant = not bound or not SILENT_QUANTITIES.issuperset(bound)
        found["|".join(key)] = FileValue(
            entry.label(), key[1], entry.text, key[0], 0, entry.address or "", relevant, meaning
        )
    for text in texts:
        if not is_entry_sheet(text):
            found.update(_other_lines(definition, text))
    return found


def _other_lines(definition: Definition, file: ControlFile) -> Iterator[tuple[str, FileValue]]:
    reader = text_reader(definition)
    read = reader.read(file, [])
    known = {place.line for place in read.occurrences} if read is not None else set()
    section = ""
    lines: Counter[str] = Counter()
    for line in reader.lines(file.content.decode("latin-1")):
        text = line.text.strip()
        opened = _SECTION.fullmatch(text)
        if opened is not None:
            section = opened[1]
        if not text or text[0] in "#;%(" or opened is not None or line.number in known:
            continue
        setting = _SETTING.fullmatch(text)
        name = " ".join((setting[1] if setting is not None else text).split())
        lines[section + name] += 1
        shown = f"[{section}] {name}" if section else name
        key = f"{file.name}|{section}|{name}|{lines[section + name]}"
        value = setting[2] if setting is not None else "there"
        yield key, FileValue(f"{file.name}: {shown}", shown, value, file.name, line.number)
