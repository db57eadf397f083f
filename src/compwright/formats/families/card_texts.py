"""Values and texts for the commissioning cards of several families, and the order of loading."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import print_form
from compwright.formats.families.resolved_definition import ResolvedDefinition
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.container import is_container
from compwright.formats.text.scale import NumberScale
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.facts import AxisFacts
from compwright.records.numbering import NumberedSections
from compwright.words.sentences import SentenceText, control_text, say

#: Stands where a card has no value for a field of its text.
UNKNOWN = control_text("(not known)")
#: Among the values of a card: how many curves the table has that is written.
CURVES = "curves"
#: What has to be done so that the control knows where the axis is, by the kind of encoder.
REFERENCING = {
    "incremental": control_text(
        "Incremental encoder: reference the axis after the power cycle; no compensation "
        "is active before that."
    ),
    "absolute": control_text(
        "Absolute encoder: no reference return. Leave its adjustment alone: machine zero would be"
        " lost."
    ),
    "distance_coded": control_text(
        "Distance-coded scale: move the axis over two marks after the power cycle; no "
        "compensation is"
        " active before that."
    ),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class CardRequest:
    """The data from which the commissioning card of one written table is made: the axis, its table,
    and facts about the axis in the control's files.

    ``table``: the table as it was read back. ``facts``: facts of the axis in the written files.
    ``check_at``: positions at which the axis can be measured, mm or deg, ascending. ``files``: all
    written files.
    """

    axis: Axis
    table: AxisCompensation
    facts: AxisFacts
    check_at: FloatArray
    files: Sequence[ControlFile] = ()


@dataclass(frozen=True, slots=True)
class AxisCard:
    """The contents of the commissioning card for one table.

    ``values``: texts by field of the card: points, start, end, spacing and backlash in the
    control's unit, numbers, names of files, the check of the sign. ``numbered``: the number of each
    section, for the drawing; None if the points have no numbers that an engineer sets.
    """

    values: Mapping[str, str]
    numbered: NumberedSections | None = None


def typed_number(value: float) -> str:
    """Return a number in the form typed at a control: digits and a point, never an exponent."""
    return np.format_float_positional(float(f"{value:.10g}"), trim="-")


def table_values(
    definition: Definition,
    scale: NumberScale,
    compensation: AxisCompensation,
    point: str | None = None,
) -> dict[str, str]:
    """Return a table's values for the card as texts by field name, in the control's units: points,
    start, end, spacing, backlash. ``point``: the quantity of the table's positions, needed only for
    a cross-axis table.

    The backlash may have another unit than the positions; both units are returned too.
    """
    point = point or ("table_start" if "table_start" in definition.bindings else "node_position")
    lost = "backlash" if "backlash" in definition.bindings else point
    factor = float(scale.factor(point))
    positions = compensation.positions
    values = {
        "points": str(positions.size),
        "unit": scale.unit(point),
        "backlash": typed_number(compensation.backlash / float(scale.factor(lost))),
        "backlash_unit": scale.unit(lost),
    }
    if positions.size:
        values["start"] = f"{positions[0] / factor:.10g}"
        values["end"] = f"{positions[-1] / factor:.10g}"
    if positions.size > 1:
        step = (positions[-1] - positions[0]) / (positions.size - 1)
        values["spacing"] = f"{step / factor:.10g}"
    return values


def sign_check(compensation: AxisCompensation, where: FloatArray) -> dict[str, str]:
    """Return the card's values for a sign check: those two positions of ``where`` with the smallest
    and the largest correction, and the difference of these corrections; empty for a table with
    fewer than two points.
    """
    if compensation.positions.size < 2:
        return {}
    curve = compensation.at(where, Direction.POSITIVE)
    low, high = sorted((int(np.argmin(curve)), int(np.argmax(curve))))
    unit = compensation.kind.unit
    change = float(curve[high] - curve[low]) * outside_factor(unit)
    return {
        "check_from": f"{where[low]:.10g}",
        "check_to": f"{where[high]:.10g}",
        "check_change": f"{round(change, 1) + 0.0:+.1f} {shown_unit(unit)}",
    }


def named_files(
    control: ResolvedDefinition, axis: Axis, files: Sequence[ControlFile]
) -> dict[str, str]:
    """Return, by card field, the names of the files that were written for an axis, where the
    definition does not give these names.

    ``files``: all written files.
    """
    definition = control.definition
    written = loading_order(definition, files)
    address, _ = control.address(axis)
    partner = [] if axis.gantry is None else [normal_text(definition, axis.gantry)]
    named = [
        numbered_files(definition, replace(axis, address=file_stem(control, one)))
        for one in (address, *partner)
    ]
    fresh = numbered_files(definition, replace(axis, address=address))
    own = ", ".join(name for name in written if name not in _new_names(control, axis))
    patched = control_text("your own patched {files}", files=own) if own else ""
    if not any(name in written for name in named[0].values()):
        return {key: patched for key, name in fresh.items() if name not in written and own}
    return {
        key: and_joined([one for names in named if (one := names[key]) in written])
        or patched
        or name
        for key, name in named[0].items()
    }


def and_joined(names: Sequence[str]) -> str:
    """Join several names to one text, such as "X, Y and Z"."""
    return SentenceText(say("card.and", names=names)) if names else ""


def _new_names(control: ResolvedDefinition, axis: Axis) -> set[str]:
    """Return every file name that the definition gives for this axis or for any axis in the
    control's files.
    """
    return {
        name
        for address in (control.address(axis)[0], *control.state.axes)
        for stem in (address, file_stem(control, address))
        for name in numbered_files(control.definition, replace(axis, address=stem)).values()
    }


def file_stem(control: ResolvedDefinition, address: str) -> str:
    """Return the axis name to use in new file names: the machine axis name if known, else
    ``address``.
    """
    return control.state.facts_of(address).machine_name or address


def numbered_files(definition: Definition, axis: Axis) -> dict[str, str]:
    """Return the definition's file names for an axis by card field (``file_1``, ``file_2``)."""
    address, _ = normal_address(definition, axis)
    named = {"axis": address, "system": str(axis.encoder.system - 1)}
    return {
        f"file_{number}": print_form(file.name, named)
        for number, file in enumerate(definition.writing, start=1)
    }


#: What makes tables act, and while it does protects their values from being written.
_SWITCHES = ("enabled", "cross_table_enabled", "cross_axis_enabled")
_VALUES = ("value", "cross_value")


def loading_order(definition: Definition, files: Sequence[ControlFile]) -> list[str]:
    """Return file names in the order in which a control loads them.

    A whole archive comes before files that replace parts of it. Table values come before the
    activation parameters, because an active table cannot be changed.
    """

    def holds(file: ControlFile, quantity: str) -> bool:
        binding = definition.bindings.get(quantity)
        if binding is None:
            return False
        form = definition.statements[binding.statement].form.split("[", 1)[0].encode()
        return re.search(re.escape(form) + rb"\s*\[", file.content) is not None

    def place(file: ControlFile) -> tuple[bool, bool, bool]:
        return (
            not is_container(file),
            any(holds(file, name) for name in _SWITCHES),
            not any(holds(file, name) for name in _VALUES),
        )

    return [
        file.name
        for file in (sorted(files, key=place) if "enabled" in definition.bindings else files)
    ]
