"""The steps by which a table gets into the control, with their evidence."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.formats.definition.consistency import has_cross
from compwright.formats.definition.options import axis_options, resolve_options
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import field_names, print_form
from compwright.formats.families.columns.capacity import user_card_values
from compwright.formats.families.grid.axis_reading import Fact
from compwright.formats.families.grid.capacity import scale_for_writing
from compwright.formats.families.pairs.reading import CEC_PAIR
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import Scale
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile, Evidence

UNKNOWN = "(not known)"
#: Among the values of a card: how many curves the table has that is written.
CURVES = "curves"


#: What makes tables act, and while it does protects their values from being written.
_SWITCHES = ("enabled", "cross_table_enabled", "cross_axis_enabled")
#: A field with a longer value is a sentence and keeps its place in the text.
_LONGEST_CELL = 48
#: The heading of the column that names the axis of a row.
AXIS_COLUMN = "axis"


@dataclass(frozen=True, slots=True)
class CardStep:
    """One step for the engineer at the control.

    ``rows``: what differs by axis, under ``heads``; the text names a column as ``‹head›``.
    """

    title: str
    text: str
    evidence: Evidence
    source: str = ""
    heads: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


def card_steps(
    definition: Definition, axis: Axis, values: Mapping[str, str]
) -> tuple[CardStep, ...]:
    """Return the steps for one axis, as `card_steps_of_all`."""
    return card_steps_of_all(definition, [(axis, values)])


def card_steps_of_all(
    definition: Definition, axes: Sequence[tuple[Axis, Mapping[str, str]]]
) -> tuple[CardStep, ...]:
    """Return the steps for these axes, in the order of the definition.

    The values of each axis fill the fields of the text (see `card_values`); a missing one reads
    "(not known)". What is the same for all axes stands once; where short values differ, they stand
    in a table with a row per axis.
    """
    known = [{**_axis_values(definition, axis), **values} for axis, values in axes]
    return tuple(
        CardStep(rule.title, text, rule.evidence.state, rule.evidence.source, heads, rows)
        for rule in definition.card
        for text, heads, rows in (
            _for_all(
                [rule.two_curves if of.get(CURVES) == "2" else rule.text for of in known], known
            ),
        )
    )


def _for_all(
    forms: Sequence[str], known: Sequence[Mapping[str, str]]
) -> tuple[str, tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """Return the text of a step for all axes, with the heads and rows of what differs."""
    filled = [
        {name: of.get(name, UNKNOWN) for name in field_names(form)}
        for form, of in zip(forms, known, strict=True)
    ]
    if len(set(forms)) == 1:
        differing = [
            name
            for name in dict.fromkeys(field_names(forms[0]))
            if len({of[name] for of in filled}) > 1
        ]
        if differing and all(len(of[name]) <= _LONGEST_CELL for of in filled for name in differing):
            heads = [name.rstrip("0123456789").strip("_").replace("_", " ") for name in differing]
            named = {name: f"‹{head}›" for name, head in zip(differing, heads, strict=True)}
            rows = tuple(
                (of["name"], *(values[name] for name in differing))
                for of, values in zip(known, filled, strict=True)
            )
            return print_form(forms[0], {**filled[0], **named}), (AXIS_COLUMN, *heads), rows
    lines = dict.fromkeys(
        print_form(form, values) for form, values in zip(forms, filled, strict=True)
    )
    return "\n".join(lines), (), ()


def card_values(
    definition: Definition,
    axis: Axis,
    compensation: AxisCompensation,
    options: Mapping[str, object],
    facts: Mapping[str, Fact] | None = None,
    check_at: FloatArray | None = None,
) -> dict[str, str]:
    """Return what the card says about a table: points, start, end, spacing, backlash (in the
    control's unit), check of the sign.

    ``facts``: what the files that hold the table say of the axis (`ControlState.facts`), such as
    its point numbers. ``check_at``: positions at which the axis can be measured, mm or deg,
    ascending (default: the nodes).
    """
    resolved = resolve_options(definition, options)
    if definition.layout.shape == "section_increments":
        own = axis_options(definition, resolved, axis)
        where = compensation.positions if check_at is None else check_at
        return _increment_values(axis, compensation, definition, own, facts or {}) | _sign_check(
            compensation, where
        )
    scale = scale_for_writing(definition, axis, resolved)
    node = "table_start" if "table_start" in definition.bindings else "node_position"
    factor = float(scale.factor(node))
    positions = compensation.positions
    values = {
        "points": str(positions.size),
        "unit": scale.unit(node),
        "backlash": _typed(compensation.backlash / factor),
    }
    if has_cross(definition) and not np.array_equal(compensation.positive, compensation.negative):
        values[CURVES] = "2"
    values |= _cross_values(facts or {})
    if positions.size:
        values["start"] = f"{positions[0] / factor:.10g}"
        values["end"] = f"{positions[-1] / factor:.10g}"
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1) / factor:.10g}"
    if definition.layout.shape == "user_tables":
        values.update(user_card_values(definition, axis, compensation, resolved))
    return values


def _typed(value: float) -> str:
    """Return a number as it is typed at a control: digits and a point, never an exponent."""
    return np.format_float_positional(float(f"{value:.10g}"), trim="-")


def file_names(definition: Definition, axis: Axis) -> list[str]:
    """Return how the definition's files are called for an axis, in its order, whether they are
    written or not.
    """
    address, _ = normal_address(definition, axis)
    named = {"axis": address, "system": str(axis.encoder.system - 1)}
    return [print_form(file.name, named) for file in definition.writing]


def loading_order(definition: Definition, files: Sequence[ControlFile]) -> list[str]:
    """Return the names of files in the order in which a control takes them all: values before the
    switches that protect them.
    """

    def holds(file: ControlFile, quantity: str) -> bool:
        binding = definition.bindings.get(quantity)
        if binding is None or binding.statement not in definition.statements:
            return False
        form = definition.statements[binding.statement].form.split("[", 1)[0].encode()
        return re.search(re.escape(form) + rb"\s*\[", file.content) is not None

    def place(file: ControlFile) -> tuple[bool, bool]:
        return any(holds(file, name) for name in _SWITCHES), not any(
            holds(file, name) for name in ("value", "cross_value")
        )

    return [
        file.name
        for file in (sorted(files, key=place) if "enabled" in definition.bindings else files)
    ]


def _axis_values(definition: Definition, axis: Axis) -> dict[str, str]:
    address, _ = normal_address(definition, axis)
    files = {
        f"file_{number}": name for number, name in enumerate(file_names(definition, axis), start=1)
    }
    return {
        "name": axis.name,
        "sheet": axis.name,
        "address": address,
        "system": str(axis.encoder.system),
        "index": str(axis.encoder.system - 1),
        "reference": f"{axis.reference:.10g}",
        "reference_return": axis.reference_return.value,
        "unit": axis.kind.unit,
        "gantry": gantry_words(axis),
        "referencing": _REFERENCING[axis.encoder.type],
        **files,
    }


def gantry_words(axis: Axis) -> str:
    """Return what the card says of the synchronised axis of a gantry."""
    if axis.gantry is None:
        return (
            f"Axis {axis.name} leads no gantry as far as the job says. If it does, stop: a table on"
            " the leading axis alone racks the bridge. Name its synchronised axis in the job"
            " (gantry), so that it gets the same table."
        )
    return (
        f"Axis {axis.name} leads a gantry: do every step for the synchronised axis {axis.gantry}"
        " too, before anything moves. A table on the leading axis alone racks the bridge."
    )


def _cross_values(facts: Mapping[str, Fact]) -> dict[str, str]:
    """Return which tables between axes hold the two directions, as far as the files that were
    written say it.
    """
    pair = str(facts.get(CEC_PAIR, "")).split()
    return {"table_positive": pair[0], "table_negative": pair[1]} if len(pair) == 2 else {}


def _increment_values(
    axis: Axis,
    compensation: AxisCompensation,
    definition: Definition,
    options: Mapping[str, object],
    facts: Mapping[str, Fact],
) -> dict[str, str]:
    scale = Scale(definition, axis.kind, options, {})
    unit = axis.kind.unit
    values = {
        name: str(facts[name])
        for name in ("reference_number", "first_number", "last_number", "magnification")
        if name in facts
    }
    values["unit"] = unit
    values["detection_unit"] = f"{scale.quantum('value'):g} {unit}"
    values["backlash"] = scale.write("backlash", compensation.backlash)
    values["further"] = _further(axis, facts)
    if facts.get("absolute_encoder") == "yes":  # by 1815#5, whatever the job takes it for
        values["referencing"] = _REFERENCING["absolute"]
    values["other_sign"] = "'+'" if options.get("pitch_sign") == "-" else "'-'"
    positions = compensation.positions
    if positions.size > 1:
        values["spacing"] = f"{(positions[-1] - positions[0]) / (positions.size - 1):.10g}"
    return values


def _further(axis: Axis, facts: Mapping[str, Fact]) -> str:
    """Return what has to be set beside the grid and 1851: second set, turn, backlash at rapid
    traverse.
    """
    two = facts.get("bidirectional") == "yes"
    said = [f"3605#0 = {int(two)}"]
    if two:
        said += [
            f"3626 = {facts.get('negative_first', UNKNOWN)}",
            f"3627 = {facts.get('negative_offset', UNKNOWN)}",
        ]
    if axis.modulo is not None:
        said.append(f"3625 = {axis.modulo:g}")
    if facts.get("separate_rapid") == "yes" and "backlash_rapid" in facts:
        said.append(f"1852 = {facts['backlash_rapid']}")
    return ", ".join(said)


#: What has to be done so that the control knows where the axis is, by the kind of encoder.
_REFERENCING = {
    "incremental": (
        "Incremental encoder: reference the axis after the power cycle; nothing acts before that."
    ),
    "absolute": (
        "Absolute encoder: no reference return. Leave its adjustment alone (FANUC 1815): machine"
        " zero would be lost."
    ),
    "distance_coded": (
        "Distance-coded scale: move the axis over two marks after the power cycle; nothing acts"
        " before that."
    ),
}


def _sign_check(compensation: AxisCompensation, where: FloatArray) -> dict[str, str]:
    """Return the two of the positions between which the table changes the distance most: there the
    sign shows best.
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
        "check_change": f"{change:+.1f} {shown_unit(unit)}",
    }
