"""Recognise the control that files belong to, for files given with the wrong format."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from compwright.controls.control import COMMAND_LINE, JOB_PLACE
from compwright.controls.definitions import shipped_definitions
from compwright.formats.definition.schema import Definition
from compwright.formats.text.container import unpacked
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.texts import ReadText, text_reader
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile

#: Bytes at the beginning of a file that show its control.
_LOOKED_AT: Final = 65536
#: Series of one maker read nearly the same statements: up to this part of the most, all are named.
_ALIKE: Final = 0.9
_NAMED: Final = 3


def refuse_other_control(
    session: Session,
    given: Definition,
    files: Sequence[ControlFile],
    place: str = COMMAND_LINE.format_place,
) -> None:
    """Raise InputError if the files belong to another control than the ``given`` one.

    ``place``: the option or key that names the control, for the message. Files belong to the given
    control if they contain at least one of its statements, even a damaged one. Entry sheets are not
    examined, because they have the same form for all controls.
    """
    texts = tuple(text for text in unpacked(files, []) if not is_entry_sheet(text))
    if any(_reads(given, text) for text in texts):
        return
    shipped = shipped_definitions(session).values()
    counts = {one: sum(statements_at_start(text, one) for text in texts) for one in shipped}
    if not any(counts.values()):  # rows of bare numbers
        counts = {one: sum(_reads(one, text) for text in texts) for one in shipped}
    most = max(counts.values(), default=0)
    if not most:
        return
    alike = [one for one, count in counts.items() if count >= _ALIKE * most]
    ids = " or ".join(one.id for one in alike)
    if place == COMMAND_LINE.format_place:
        hint = "give " + " or ".join(f"`--format {one.id}`" for one in alike)
    elif place == JOB_PLACE:
        hint = f"write {ids} as `{place}`, or give files of {given.id}"
    else:
        hint = f"give files of {given.id}, the control of this plan"
    names = ", ".join(file.name for file in files[:_NAMED])
    raise InputError(
        Fault(
            message=f"{'these are files' if len(files) > 1 else 'this is a file'} of "
            f"{alike[0].maker}, not of {given.id}",
            file=f"{names}, ..." if len(files) > _NAMED else names,
            hint=hint,
        )
    )


def statements_at_start(file: ControlFile, definition: Definition) -> int:
    """Return how many statements that are typical of a control are in the first part of a file."""
    begins = file.content[:_LOOKED_AT]
    if len(begins) < len(file.content):
        begins = begins[: begins.rfind(b"\n") + 1]
    read = text_reader(definition).read(ControlFile(file.name, begins), [])
    return 0 if read is None else _typical(read, definition)


def _reads(definition: Definition, file: ControlFile) -> bool:
    """Return whether a control can have written a file: it has a statement typical of the control,
    or only table rows that can all be read.
    """
    faults: list[Fault] = []
    read = text_reader(definition).read(file, faults)
    if read is None:
        return False
    rows = definition.texts[read.kind].other_lines_refused and read.occurrences and not faults
    return bool(rows or _typical(read, definition))


def _typical(read: ReadText, definition: Definition) -> int:
    matchers = text_reader(definition).matchers
    return sum(bool(matchers[one.statement].head) for one in read.occurrences)
