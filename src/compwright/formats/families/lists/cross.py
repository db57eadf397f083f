"""Read the cross-axis table in an axis' list, by which the position of another axis corrects it."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal

import numpy as np

from compwright.formats.families.lists.statements import AxisStatements
from compwright.formats.families.lists.table import TENTH
from compwright.formats.text.gathering import same_value
from compwright.formats.text.notes import CORRECT_VALUE, NOT_COUNTED, Notes
from compwright.records.axis import AxisKind
from compwright.records.correction import CrossCompensation
from compwright.words.sentences import control_text

#: The option that says what the values are; no page does.
CROSS_VALUES = "cross_values"
#: Entries of a cross-axis table where the list does not say how many there is room for.
CROSS_ROOM = 1001
#: Every statement of such a table.
CROSS_STATEMENTS = (
    "cross_unit",
    "cross_master",
    "cross_last",
    "cross_max_points",
    "cross_manual",
    "cross_setpoint",
    "cross_correction",
)


def read_cross(
    lists: AxisStatements, kind_of: Callable[[str], AxisKind]
) -> CrossCompensation | None:
    """Return the correction of the axis of ``lists`` by the position of another axis, mm or deg;
    None without an active table, or if the meaning of its values is unknown. ``kind_of``: a
    function that returns the kind (linear, rotary) of an axis.

    If the meaning is unknown (correction or error), the notes say so. Faults are added to the
    notes.
    """
    entries = _entries(lists)
    master = lists.one("cross_master")
    if not entries or master is None or all(value == 0 for _, value in entries):
        return None
    over = str(int(master.text))
    label = control_text("{label}: its table over axis {over}", label=lists.label, over=over)
    sign = {"error": -1, "correction": 1}.get(str(lists.options.get(CROSS_VALUES)))
    if sign is None:
        left_out(
            lists.notes,
            label,
            control_text(
                "the meaning of its values is unknown; give the option {option} after the check on"
                " the card",
                option=CROSS_VALUES,
            ),
        )
        return None
    if not lists.is_active("cross_switch", "cross_manual", zero=False, label=label):
        return None
    unit = lists.one("cross_unit")
    if unit is not None and not same_value(unit.text, "1"):
        message = "a cross-axis table in increments cannot be read"
        lists.notes.refuse(
            lists.label, message, unit, expected="1 (0.1 µm, 0.0001 deg)", hint=NOT_COUNTED
        )
    if str(int(master.text)) == lists.address:
        message = "the axis is its own master"
        lists.notes.refuse(
            lists.label, message, master, expected="another axis", hint=CORRECT_VALUE
        )
    tenth = Decimal(str(TENTH))
    curve = np.array([float(sign * value * tenth) for _, value in entries])
    return CrossCompensation(
        input=str(int(master.text)),
        output=lists.address,
        input_kind=kind_of(str(int(master.text))),
        output_kind=lists.kind,
        positions=np.array([float(place * tenth) for place, _ in entries]),
        positive=curve,
        negative=curve,
    )


def left_out(notes: Notes, label: str, why: str) -> None:
    """Report a cross-axis table that is not read and stays unchanged."""
    notes.find("CW-S050.list", "warning", label=label, why=why)


def _entries(lists: AxisStatements) -> list[tuple[Decimal, Decimal]]:
    """Return positions and values of a table's entries as written; empty without a valid table."""
    given = [
        place for name in CROSS_STATEMENTS for place in lists.lists.places(lists.address, name)
    ]
    before = len(lists.notes.faults)
    setpoints, values = lists.rows("cross_setpoint"), lists.rows("cross_correction")
    needed = [lists.needed(name, given[0]) for name in CROSS_STATEMENTS[:3]] if given else []
    last = lists.one("cross_last")
    if last is None or len(lists.notes.faults) > before or None in needed:
        return []
    count = int(last.text) + 1
    room = lists.room("cross_max_points", CROSS_ROOM)
    if count > room:
        message = f"{lists.lists.name('cross_last')} must be less than the room for entries"
        lists.notes.refuse(
            lists.label, message, last, expected=f"less than {room}", hint=CORRECT_VALUE
        )
        return []
    for column, rows in (("cross_setpoint", setpoints), ("cross_correction", values)):
        lists.complete(rows, count, column, last)
    if len(lists.notes.faults) > before:
        return []
    places = [Decimal(setpoints[index].text) for index in range(count)]
    lists.check_ascending(places, setpoints, last)
    return [(place, Decimal(values[index].text)) for index, place in enumerate(places)]
