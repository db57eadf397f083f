"""What happens if only some of the planned files are loaded, and how the values read back show
which files were loaded.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from compwright.controls.control import Control, decode
from compwright.controls.file_replacement import with_new_tables
from compwright.controls.judged_corrections import judged_correction
from compwright.evaluation.standards import evaluate
from compwright.formats.text.file_values import FileValues, same_text
from compwright.foundations.errors import CompwrightError
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.predicted_gain import judged_parameter
from compwright.planning.wanted_correction import with_change
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from compwright.words.sentences import control_text

#: Of more files than these no parts are tried: each costs a reading of everything.
_MOST_FILES = 6


@dataclass(frozen=True, slots=True)
class PartialLoad:
    """The names of the planned files that were loaded, and of those that were not."""

    loaded: tuple[str, ...]
    missing: tuple[str, ...]


def harmful_parts(
    control: Control,
    own: Sequence[ControlFile],
    tables: Sequence[ControlFile],
    works: Mapping[str, AxisWork],
) -> tuple[str, ...]:
    """Return a text for each of the files ``tables`` that makes an axis worse if only this file is
    loaded. ``own``: the control's files before; ``works``: by axis name, the first test and the new
    table.
    """
    old = {file.name: file.content for file in own}
    changed = [file for file in tables if old.get(file.name) != file.content]
    if not own or not 2 <= len(changed) <= _MOST_FILES:
        return ()
    axes = [work.planned.axis for work in works.values()]
    addresses = [axis.address for axis in axes]
    found = []
    for part in changed:
        try:
            state = decode(control, with_new_tables(control, own, [part], addresses), axes)
        except CompwrightError:
            continue  # the values contradict each other: the effect in the control is unknown
        effects = tuple(
            words
            for work in works.values()
            if (words := _worse(work, judged_correction(state, work.planned.axis)))
        )
        if effects:
            found.append(
                control_text("With {file} alone {effects}.", file=part.name, effects=effects)
            )
    return tuple(found)


def _worse(work: AxisWork, new: Correction) -> str:
    """Return a text on how much worse the result of the first test would be with the correction
    ``new``; empty if it would not be worse.
    """
    first, axis = work.results[0], work.planned.axis
    name = judged_parameter(first)
    if name is None:
        return ""
    values = []
    for active in (work.as_found, new):
        change = difference(active, work.active)
        moved = with_change(first.test, *(change(first.test.targets, side) for side in Direction))
        values.append(abs(evaluate(moved, first.standard, checked=False).parameters[name] or 0.0))
    factor = outside_factor(axis.kind.unit)
    was, becomes = (value * factor for value in values)
    if round(becomes) <= round(was):
        return ""
    unit = shown_unit(axis.kind.unit)
    return control_text(
        "axis {axis} has {name} {becomes} {unit} (now {was} {unit})",
        axis=axis.name,
        name=name,
        becomes=f"{becomes:.0f}",
        was=f"{was:.0f}",
        unit=unit,
    )


def partial_load(before: FileValues, planned: FileValues, back: FileValues) -> PartialLoad | None:
    """Return which planned files were loaded and which were not; None if the values read ``back``
    do not show such a partial load. ``before``: the values in the control's old files.

    The result is None if all files or none were loaded, if a file was loaded only in part, or if
    another value is wrong. It is also None if the file of a changed value is unknown.
    """
    new_in: dict[str, None] = {}
    old_in: dict[str, None] = {}
    for key, entry in planned.items():
        old, found = ((side[key].text if key in side else None) for side in (before, back))
        if old is not None and same_text(old, entry.text):
            continue
        if found is not None and same_text(found, entry.text):
            new_in[entry.file] = None
        elif found == old or (found and old and same_text(found, old)):
            old_in[entry.file] = None
        else:
            return None
    if not (new_in and old_in) or new_in.keys() & old_in.keys() or "" in {**new_in, **old_in}:
        return None
    return PartialLoad(tuple(new_in), tuple(old_in))
