"""Recognise files in a folder that contain no data of the control, such as notes."""

from __future__ import annotations

import re
from collections.abc import Sequence

from compwright.formats.definition.schema import Definition, TextKind
from compwright.formats.text.texts import BINARY, text_reader
from compwright.foundations.errors import Fault
from compwright.foundations.findings import Finding
from compwright.records.correction import ControlFile

#: An assignment, a numbered block or a row of numbers: whatever the maker, a control could take it.
_DATA = re.compile(
    rb"=|^[ \t]*/?N[ \t]*[0-9]|^[-+0-9.,;Ee \t]*[0-9][-+0-9.,;Ee \t]*\r?$",
    re.MULTILINE | re.IGNORECASE,
)


def holds_no_data(definition: Definition, file: ControlFile) -> bool:
    """Return whether a text contains no statement of the control and no line that looks like data.

    False for a file that is partly damaged or has another character set. False too for any file of
    a control whose lines are all commands, because an unknown line may then be a command.
    """
    if any(_of_commands(kind) for kind in definition.texts.values()):
        return False
    if not file.content.strip() or BINARY.search(file.content) or _DATA.search(file.content):
        return False
    faults: list[Fault] = []
    read = text_reader(definition).read(file, faults)
    return read is not None and not faults and not read.occurrences


def _of_commands(kind: TextKind) -> bool:
    """Return whether lines of this kind of text need not fit a statement, because they are commands
    of a script.
    """
    return not (kind.other_lines_refused or kind.claims_at_start or kind.claims_anywhere)


def _numbered(definition: Definition) -> bool:
    """Return whether every statement of a control begins with a number."""
    return all(each.form.startswith("N") for each in definition.statements.values())


def without_other_files(
    definition: Definition, files: Sequence[ControlFile]
) -> tuple[tuple[ControlFile, ...], tuple[Finding, ...]]:
    """Return ``files`` without those that contain no data of the control, and a finding on these.

    Only files that were found in a folder are left out, not those that the user named. All files
    stay if none would be left. They also stay if the control's statements do not begin with a
    number, because then any line may be a statement.
    """
    if not _numbered(definition):
        return tuple(files), ()
    others = [file for file in files if file.folder and holds_no_data(definition, file)]
    kept = tuple(file for file in files if file not in others)
    if not others or not kept:
        return tuple(files), ()
    names = [file.name for file in others]
    return kept, (Finding.of("CW-S084", "info", files=names, format=definition.id),)
