"""Replace the control's own files by new ones, and check that only intended values change."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from compwright.controls.control import Control, decode
from compwright.controls.control_files import holds_archive
from compwright.controls.decoded_state import DecodedState, judged_values
from compwright.controls.reader_comparison import probe_positions
from compwright.formats.families.axis_pairs import merged_files
from compwright.formats.families.control_texts import all_names, under_new_entries
from compwright.formats.text.diff import compare_files
from compwright.formats.text.entry_sheet import EntrySheet, is_entry_sheet, read_sheet
from compwright.foundations.errors import CompwrightError, Fault, UsageError, raise_all
from compwright.foundations.own_faults import SEND_JOB
from compwright.records.axis import Axis, Direction
from compwright.records.correction import ControlFile
from compwright.records.delivery import Delivery
from compwright.records.serial_line import as_on_line
from compwright.verification.read_back import SAME


def changed_neighbours(
    control: Control, old: Sequence[ControlFile], new: Sequence[ControlFile], axes: Sequence[Axis]
) -> list[Fault]:
    """Return a fault for every changed value of an axis other than ``axes`` and their gantry
    slaves.
    """
    addresses = [name for axis in axes for name in (axis.address, axis.gantry) if name is not None]
    mine = all_names(control.definition, old, addresses)
    return [
        Fault(
            message="an internal error of compwright: the new files would change an entry of "
            f"axis {change.address}, which has to stay as it is",
            place=change.entry,
            expected=change.old or "",
            found=change.new or "nothing",
            hint=f"load nothing of this run, and {SEND_JOB}",
        )
        for change in compare_files(control.definition, old, new).changes
        if change.old is not None and change.address is not None and change.address not in mine
    ]


def with_new_tables(
    control: Control,
    own: Sequence[ControlFile],
    tables: Sequence[ControlFile],
    tabled: Collection[str],
) -> tuple[ControlFile, ...]:
    """Return the control's own files with the new ``tables`` in place of the old ones. ``tabled``:
    addresses of the axes that get a new table; their old entry sheets are left out.

    For a control whose files the user changes by hand, the lines that the new tables replace are
    left out too.
    """
    new = {sheet.axis for file in tables if (sheet := _sheet(file)) is not None} | set(tabled)
    kept = [file for file in own if (sheet := _sheet(file)) is None or sheet.axis not in new]
    if control.definition.limit("no_patching") is not None:
        named = {file.name for file in tables}
        kept = [file for file in kept if file.name not in named]
        kept = list(under_new_entries(control.definition, kept, tables))
    return merged_files(kept, tables)


def _sheet(file: ControlFile) -> EntrySheet | None:
    return read_sheet(file, []) if is_entry_sheet(file) else None


def contents_after_loading(
    before: Sequence[ControlFile], back: tuple[ControlFile, ...]
) -> tuple[ControlFile, ...]:
    """Return the control's contents after loading: the files ``back`` that the user read back from
    the control, together with an archive in the files ``before`` if it was not read back.

    Values in the files ``back`` replace those in the archive.
    """
    if holds_archive(before) and not holds_archive(back):
        return merged_files(before, back)
    return back


def loadable_files(
    control: Control,
    files: tuple[ControlFile, ...],
    as_found: DecodedState,
    axes: Sequence[Axis],
    image: DecodedState | None,
) -> Delivery:
    """Return the files that the user has to load into the control: the written ``files`` or smaller
    files made from them. ``image``: the written files, decoded; if given, smaller files must have
    the same effect.

    ``as_found``: the control's files before. ``axes``: the axes of the job. Raises UsageError if
    the files cannot be made in the requested form. Raises CompwrightError (an internal error) if
    the smaller files have another effect.
    """
    try:
        delivery = control.format.delivered(files, as_found.files, axes)
    except UsageError as error:
        raise control.origin.named(error) from error
    delivery = replace(delivery, files=as_on_line(delivery.files, as_found.files))
    if delivery.own or image is None:
        return delivery
    small = decode(control, delivery.files, axes, written=True)
    faults = [
        Fault(
            message="an internal error of compwright: the files of `files: small` do not have the "
            "same effect as the whole archive",
            place=f"axis {axis.address}, direction {direction.value}",
            hint=f"set `files: patched` in the options, and {SEND_JOB}",
        )
        for axis in axes
        for direction in Direction
        if not _same(small, image, axis.address, direction)
    ]
    raise_all(CompwrightError, faults)
    return delivery


def _same(one: DecodedState, other: DecodedState, address: str, direction: Direction) -> bool:
    where = probe_positions(other.state.axes[address].positions)
    mine, theirs = (judged_values(state, address, where, direction) for state in (one, other))
    return bool(np.all(np.abs(mine - theirs) <= SAME))
