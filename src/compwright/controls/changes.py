"""New files in place of the control's own, and the check that they change only what is intended."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from compwright.controls.control import Control, holds_archive
from compwright.formats.families.between import together
from compwright.formats.families.control_texts import all_names
from compwright.formats.text.diff import compare_files
from compwright.formats.text.entry_sheet import EntrySheet, is_entry_sheet, read_sheet
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile


def changed_neighbours(
    control: Control, old: Sequence[ControlFile], new: Sequence[ControlFile], axes: Sequence[Axis]
) -> list[Fault]:
    """Return a fault for every entry of an axis outside ``axes`` (and their gantry partners) that
    the new files change.
    """
    addresses = [name for axis in axes for name in (axis.address, axis.gantry) if name is not None]
    mine = all_names(control.definition, old, addresses)
    return [
        Fault(
            message=f"an entry of axis {change.address} would change; please report this",
            place=change.entry,
            expected=change.old or "",
            found=change.new or "nothing",
            hint=("load nothing of this run, and report this line with the job and its files"),
        )
        for change in compare_files(control.definition, old, new).changes
        if change.old is not None and change.address is not None and change.address not in mine
    ]


def in_place(
    own: Sequence[ControlFile], tables: Sequence[ControlFile], tabled: Collection[str]
) -> tuple[ControlFile, ...]:
    """Return the control's own files with new ``tables`` in their place. Entry sheets that these
    supersede are left out: of an axis (address) that got a table, or of which a new sheet speaks.
    """
    new = {sheet.axis for file in tables if (sheet := _sheet(file)) is not None} | set(tabled)
    kept = [file for file in own if (sheet := _sheet(file)) is None or sheet.axis not in new]
    return together(kept, tables)


def _sheet(file: ControlFile) -> EntrySheet | None:
    return read_sheet(file, []) if is_entry_sheet(file) else None


def in_the_control(
    before: Sequence[ControlFile], back: tuple[ControlFile, ...]
) -> tuple[ControlFile, ...]:
    """Return what is in the control: what was read ``back``, over the archive of ``before`` into
    which it was loaded where that was not read back again.
    """
    if holds_archive(before) and not holds_archive(back):
        return together(before, back)
    return back
