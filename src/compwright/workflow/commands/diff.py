"""``diff``: compare two backups of one machine, value by value, with the control's own names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from compwright.controls.control import open_control
from compwright.controls.control_files import read_control
from compwright.controls.differences import CorrectionChange, Placed, compared_side, differences
from compwright.documents.diff import Changed, EntryDifference, diff_document
from compwright.foundations.session import Session


@dataclass(frozen=True, slots=True)
class DiffOutcome:
    """The result of ``diff``; exit code 0 if both backups contain the same values, else 1."""

    exit_code: int
    document: Mapping[str, Any]


def diff_files(
    session: Session,
    old: Sequence[Path],
    new: Sequence[Path],
    format_id: str,
    options: dict[str, object],
) -> DiffOutcome:
    """Compare two backups of one machine, and return their differences.

    Raises UsageError for an unknown format or option, InputError for files that cannot be read.
    """
    control = open_control(session, format_id, options)
    files = read_control(session, control, old), read_control(session, control, new)
    before = compared_side(control, files[0], "OLD", files[1])
    after = compared_side(control, files[1], "NEW", files[0])
    found = differences(control, before, after)
    names = {
        address: facts.name
        for state in (before.state, after.state)
        if state is not None
        for address, facts in state.facts.items()
        if facts.name
    }
    document = diff_document(
        control.id,
        names,
        [entry_difference(one) for one in found.entries],
        {address: _changed(one) for address, one in found.corrections.items()},
        {pair: _changed(one) for pair, one in found.cross.items()},
        (*control.findings, *found.findings),
        known=found.complete,
        unknown=found.uncompared,
    )
    return DiffOutcome(0 if document["same"] else 1, document)


def entry_difference(placed: Placed) -> EntryDifference:
    """Return a control value that differs between two backups as plain data for JSON."""
    entry, change = placed.entry, placed.change
    return EntryDifference(
        quantity=entry.name,
        group=entry.group,
        addresses=placed.axes,
        old=change.old.text if change.old is not None else None,
        new=change.new.text if change.new is not None else None,
        meaning=entry.meaning,
        compensates=entry.relevant,
        at=placed.at,
    )


def _changed(change: CorrectionChange) -> Changed:
    return Changed(change.kind, change.most, change.at, change.direction)
