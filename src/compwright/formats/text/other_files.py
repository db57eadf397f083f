"""Files that lie beside those of a control and say nothing of it: lists of its hardware, notes."""

from __future__ import annotations

import re

from compwright.formats.definition.schema import Definition
from compwright.formats.text.texts import BINARY, text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: An assignment, a numbered block or a row of numbers: whatever the maker, a control could take it.
_DATA = re.compile(
    rb"=|^[ \t]*/?N[ \t]*[0-9]|^[-+0-9.,;Ee \t]*[0-9][-+0-9.,;Ee \t]*\r?$",
    re.MULTILINE | re.IGNORECASE,
)


def says_nothing(definition: Definition, file: ControlFile) -> bool:
    """Return whether a file is a text of which no line is a statement of the control, or looks like
    data of any.

    A file that was damaged in part, or that stands in other characters, is none of these.
    """
    if not file.content.strip() or BINARY.search(file.content) or _DATA.search(file.content):
        return False
    faults: list[Fault] = []
    read = text_reader(definition).read(file, faults)
    return read is not None and not faults and not read.occurrences
