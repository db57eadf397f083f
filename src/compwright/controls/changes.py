"""That new files change nothing in the control but what was asked for."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.controls.control import Control
from compwright.formats.families.control_texts import all_names
from compwright.formats.text.diff import compare_files
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
        )
        for change in compare_files(control.definition, old, new).changes
        if change.old is not None and change.address is not None and change.address not in mine
    ]
