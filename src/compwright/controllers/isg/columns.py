"""The numbers of a compensation table: entries by index, positions, units and number types."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import numpy as np

from compwright.controllers.isg.lists import AxisLists, ListStatement
from compwright.controllers.request import Request, finite_number, wrong_choice
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import FloatArray

#: mm or deg per unit of a list in metric unit: 0.1 µm, 0.0001 deg.
METRIC = 1e-4
#: Largest number of SGN32; more than that (214 m in 0.1 µm) is not believed of REAL64 either.
LARGEST = 2.0**31 - 1
_LIMITS = {"sgn16": 2.0**15 - 1, "sgn32": LARGEST, "real64": LARGEST}
_ENTRY = re.compile(r"table\[(\d+)\]\.(\w+)")

Entries = dict[str, dict[int, ListStatement]]


def table_entries(
    axis: AxisLists, prefix: str, keys: Sequence[str], columns: Sequence[str]
) -> Entries:
    """Return the entries of a table in an ISG list (the statements ``PREFIX[i].column``), by column
    and index.

    ``keys``: names of the other statements that the table may have. Any further statement whose
    value is not 0 is a fault, because it may be an active compensation.
    """
    entries: Entries = {column: {} for column in columns}
    for name, statement in axis.section(prefix).items():
        match = _ENTRY.fullmatch(name)
        if match is not None and match.group(2) in columns and len(match.group(1)) < 10:
            entries[match.group(2)][int(match.group(1))] = statement
        elif name not in keys and statement.number() != 0.0:
            message = f"{statement.name} of axis {axis.address}: not known what it does"
            axis.fault(statement, message, "0, or no such line")
    return entries


def column(
    axis: AxisLists, entries: Mapping[int, ListStatement], count: int, name: str, largest: float
) -> FloatArray | None:
    """Return the ``count`` values of the table column ``name``, in the unit of the ISG list. A
    value above ``largest``, the most that the control can store, is a fault.

    ``entries``: the statements of the column by index. Returns None, with faults, if an entry is
    missing, invalid, too large, or beyond the last index.
    """
    before = len(axis.faults)
    inside = {index: entries[index] for index in sorted(entries) if index < count}
    for index in sorted(entries.keys() - inside.keys()):
        axis.fault(entries[index], f"entry {index} is beyond the last one", f"0 to {count - 1}")
    if len(inside) < count:
        lost = next(index for index in range(count) if index not in inside)
        wanted = name.replace("[i]", f"[{lost}]")
        axis.missing(wanted, f"{count - len(inside)} of {count} entries are missing")
        return None
    numbers = []
    for statement in inside.values():
        value = axis.number(statement.name)
        numbers.append(value)
        if value is not None and abs(value) > largest:
            axis.fault(
                statement,
                "the value is larger than the control can store",
                f"at most {largest:.0f}",
            )
    return np.array(numbers, dtype=np.float64) if len(axis.faults) == before else None


def largest_value(request: Request, address: str, axis: AxisLists, section: str) -> float:
    """Return the largest value that the table in ``section`` of an axis list can store, by the
    option ``value_type`` (default: SGN32).

    The types SGN16 and SGN32 store whole numbers only, so any other number is a fault. Raises
    UsageError for an unknown type.
    """
    chosen = request.options_of(address).get("value_type")
    if chosen is None:
        return LARGEST
    if chosen not in _LIMITS:
        raise wrong_choice("value_type", chosen, _LIMITS)
    if chosen != "real64":
        for name, statement in axis.section(section).items():
            value = statement.number()
            if name.startswith("table[") and value is not None and value != int(value):
                axis.fault(statement, f"{chosen} holds whole numbers", "a whole number")
    return _LIMITS[str(chosen)]


def unit_of(axis: AxisLists, name: str, request: Request, addresses: Sequence[str]) -> list[float]:
    """Return how many mm or deg one unit of the list is, for each of the axes ``addresses``. The
    statement ``name`` states the unit; if it is missing or invalid, the result is empty, with a
    fault.

    If the list counts encoder increments, the option ``encoder_increment`` of each axis states its
    size. Raises UsageError if it is missing or not a positive number.
    """
    metric = axis.switch(name)
    if metric is None:
        if name not in axis.statements:
            axis.missing(name, "the unit is not given")
        return []
    return [METRIC if metric else _increment(request, address, name) for address in addresses]


def _increment(request: Request, address: str, name: str) -> float:
    given = request.options_of(address).get("encoder_increment")
    increment = finite_number(given)
    if increment is None or increment <= 0.0:
        raise UsageError(
            Fault(
                message=f"the option encoder_increment of axis {address} is missing or wrong; "
                f"the list of the axis is in encoder increments ({name} 0)",
                expected="mm or deg per increment, larger than 0",
                found="none" if given is None else repr(given),
                hint=("give `--option encoder_increment=0.001` with the value of this encoder"),
            )
        )
    return increment


def ascending(axis: AxisLists, positions: FloatArray, entries: Mapping[int, ListStatement]) -> None:
    """Add a fault for the first position that is not above the preceding position."""
    steps = np.diff(positions)
    if steps.size and not np.all(steps > 0.0):
        index = int(np.argmax(~(steps > 0.0))) + 1
        expected = f"more than {positions[index - 1]:.12g}"
        axis.fault(entries[index], f"setpoint {index} does not ascend", expected)
