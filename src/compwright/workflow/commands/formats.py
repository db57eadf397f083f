"""``formats``: list the known controls, show the facts about one, or check definitions."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from compwright.controls.checked_definitions import checked_definitions
from compwright.controls.definitions import (
    definition_named,
    is_base,
    is_path,
    own_definition,
    shipped_definitions,
)
from compwright.controls.description import description, listing
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.session import Session
from compwright.foundations.storage import definition_files
from compwright.words.sentences import say

NOT_JUDGED = "not independently checked: there is no virtual control for it"


def list_formats(session: Session) -> tuple[str, ...]:
    """Return the installed controls as lines of text, sorted by maker. Raises InputError for an
    unreadable definition.

    A line has the id, the title, the names that compwright understands, and how many facts are
    confirmed.
    """
    return tuple(listing(shipped_definitions(session).values()))


def shipped_ids(session: Session) -> list[str]:
    """Return the ids of the installed controls without reading a definition."""
    return [Path(name).stem for name, _ in definition_files(session) if not is_base(Path(name))]


def show_format(session: Session, name: str) -> tuple[str, ...]:
    """Return facts about a control as lines of text: files, limits, options, and their evidence.

    ``name``: an id of a control that is part of compwright, or the path of a user's own definition.
    Raises UsageError for an unknown id; the error names those that exist. Raises InputError for a
    file that is not a definition.
    """
    definition = (
        own_definition(session, Path(name))
        if is_path(name)
        else definition_named(session, name, Path())
    )
    read_back = definition.judged != "independent"
    return (
        f"{definition.id}: {definition.title}",
        *([str(say("read_back", definition=definition.id))] if read_back else []),
        *description(definition),
    )


def check_formats(session: Session, paths: Sequence[Path]) -> tuple[str, ...]:
    """Check the control definitions in ``paths``, and return a line of text about each definition.

    ``paths``: files or folders; if empty, the definitions that are part of compwright. Raises
    InputError with every fault of every file: wrong keys, corrections worked out by hand that
    differ from those calculated, a sample that is not read back as written.
    """
    lines: list[str] = []
    faults: list[Fault] = []
    for checked in checked_definitions(session, paths):
        faults.extend(checked.faults)
        definition = checked.definition
        if definition is None or checked.faults:
            continue
        positions = sum(len(expectation.at) for expectation in definition.expect)
        says = "by the virtual control too" if checked.judged else NOT_JUDGED
        if definition.worked_for and not checked.judged:
            says += f"; they are those of {definition.worked_for}, none of its own"
        lines.append(
            f"{checked.file}: {definition.id}: {positions} positions worked by hand agree, {says};"
            " the sample is read back as written; every limit is kept"
        )
    raise_all(InputError, faults)
    if not lines:
        raise InputError(
            Fault(
                message="this path contains no definition of a control",
                file=", ".join(str(path) for path in paths),
                expected="a file *.yaml",
                hint="give the path of a definition (*.yaml), or no path for those in compwright",
            )
        )
    return tuple(lines)
