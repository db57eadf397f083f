"""Leadscrew error compensation of one axis (``kw.ssfk``) and backlash (``getriebe[0].lose``).

By the vendor's pages, the values are "absolute position errors" in the unit of the list. They are
linear between entries; outside, the value of the nearest end applies. With ``bilateral`` 1 there is
one column for each direction, else the column ``pos`` alone. The sign is an option, because the
vendor's own example contradicts itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.controllers.isg.columns import (
    LARGEST,
    METRIC,
    Entries,
    ascending,
    column,
    largest_value,
    table_entries,
    unit_of,
)
from compwright.controllers.isg.lists import AxisLists
from compwright.controllers.request import Request, by_address, wrong_choice
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption

SECTION = "kw.ssfk."
_KEYS = (
    *("unit", "interval", "kw_startpos", "kw_nr_max", "max_points"),
    *("bilateral", "modulo", "manual_activation"),
)
_COLUMNS = ("setpoint", "pos", "neg")
#: Entries that the kernel has room for where ``max_points`` is 0 or not there.
DEFAULT_ROOM = 1500
SIGNS = {"error": -1.0, "correction": 1.0}


@dataclass(frozen=True, slots=True)
class LeadscrewTable:
    """Corrections by position, one curve for each direction of approach, mm or deg.

    ``positions`` (k,): ascending. ``positive``, ``negative`` (k,): corrections for an approach
    towards + and −. ``period``: travel after which the table repeats; None if it does not repeat.
    ``bilateral``: the list has a column for each direction. ``active``: the compensation is
    switched on.
    """

    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    period: float | None
    bilateral: bool
    active: bool

    def at(self, x: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction added at ``x`` (any shape), mm or deg."""
        if not self.active:
            return np.zeros(x.shape)
        if self.period is not None:
            x = self.positions[0] + np.mod(x - self.positions[0], self.period)
        values = self.positive if direction is Direction.POSITIVE else self.negative
        return np.asarray(np.interp(x, self.positions, values), dtype=np.float64)


def read_table(
    axis: AxisLists, request: Request, assumed: list[Assumption]
) -> LeadscrewTable | None:
    """Return the leadscrew table of an axis; None if the list has no table or, with faults, if the
    table is invalid.
    """
    if not axis.section(SECTION):
        return None
    entries = table_entries(axis, SECTION, _KEYS, _COLUMNS)
    count = _count(axis, entries)
    if not count:
        return None
    largest = largest_value(request, axis.address, axis, SECTION)
    bilateral = _required(axis, "bilateral", "one column or two is not given")
    units = unit_of(axis, SECTION + "unit", request, [axis.address])
    where = _positions(axis, entries, count)
    positive = column(axis, entries["pos"], count, f"{SECTION}table[i].pos", largest)
    negative = _negative(axis, entries, count, largest, bilateral=bilateral)
    wraps = axis.switch(SECTION + "modulo")
    if wraps is None and SECTION + "modulo" not in axis.statements:
        assumed.append(Assumption(f"kw.ssfk.modulo of axis {axis.address}", "0", "the default"))
    if (
        axis.faults
        or not units
        or bilateral is None
        or where is None
        or positive is None
        or negative is None
    ):
        return None
    scale = _sign(request, axis.address, assumed) * units[0]
    table = LeadscrewTable(
        positions=where * units[0],
        positive=positive * scale,
        negative=negative * scale,
        period=_period(axis, request, where, positive, negative, units[0]) if wraps else None,
        bilateral=bilateral,
        active=switched(axis, request, "lr_param.ssfk", SECTION, assumed),
    )
    return None if axis.faults else table


def _required(axis: AxisLists, key: str, why: str) -> bool | None:
    if SECTION + key not in axis.statements:
        axis.missing(SECTION + key, why)
    return axis.switch(SECTION + key)


def _count(axis: AxisLists, entries: Entries) -> int:
    """Return the number of entries of the table; 0 without a table, or with a fault."""
    count = axis.whole(SECTION + "kw_nr_max", 0)
    filled = any(entries.values())
    if count is None:
        if SECTION + "kw_nr_max" not in axis.statements and (
            filled or axis.section(SECTION).keys() - {"max_points"}
        ):
            axis.missing(SECTION + "kw_nr_max", "the number of entries is not given")
        return 0
    statement = axis.statements[SECTION + "kw_nr_max"]
    if count == 0 and filled:
        axis.fault(statement, "the list states no entries but contains some", "their number")
    given = axis.whole(SECTION + "max_points", 0)
    room = given or DEFAULT_ROOM
    if count >= room:
        source = "max_points" if given else "the default of max_points"
        axis.fault(
            statement,
            "the table has more entries than there is room for",
            f"less than {room} ({source})",
        )
        return 0
    # the rest counts to this number: a wrong one must not fill the memory
    if count > len(entries["pos"]):
        name = f"{SECTION}table[i].pos"
        axis.missing(name, f"{count - len(entries['pos'])} of {count} entries are missing")
        return 0
    return count


def _positions(axis: AxisLists, entries: Entries, count: int) -> FloatArray | None:
    """Return the positions (count,) of the table entries in the unit of the list; None, with a
    fault, if invalid.
    """
    interval = _required_number(axis, "interval", "listed or equal spacing is not given", 0.0)
    if interval is None:
        return None
    setpoints = entries["setpoint"]
    listed = None
    if setpoints or interval == 0.0:
        listed = column(axis, setpoints, count, f"{SECTION}table[i].setpoint", LARGEST)
    if interval == 0.0:
        if listed is not None:
            ascending(axis, listed, setpoints)
            _begins(axis, float(listed[0]))
        return listed
    start = _required_number(
        axis, "kw_startpos", "the start of the equal spacing is not given", -LARGEST
    )
    if start is None:
        return None
    even = start + interval * np.arange(count)
    if listed is not None and np.any(listed != even):
        index = int(np.argmax(listed != even))
        axis.fault(
            setpoints[index], "a setpoint is not at its equally spaced place", f"{even[index]:.12g}"
        )
    return np.asarray(even, dtype=np.float64)


def _required_number(axis: AxisLists, key: str, why: str, lowest: float) -> float | None:
    """Return the number of a required statement, at least ``lowest``; None, with a fault, if it is
    invalid or missing. ``why``: the reason in the fault for which it is required.
    """
    name = SECTION + key
    if name not in axis.statements:
        axis.missing(name, why)
        return None
    value = axis.number(name)
    if value is not None and not lowest <= value <= LARGEST:
        axis.fault(axis.statements[name], name, f"{lowest:.0f} to {LARGEST:.0f}")
        return None
    return value


def _begins(axis: AxisLists, first: float) -> None:
    """Check that the listed positions begin at kw_startpos, as in the vendor's example."""
    start = axis.number(SECTION + "kw_startpos")
    if start is not None and start != first:
        statement = axis.statements[SECTION + "kw_startpos"]
        axis.fault(
            statement,
            "two lines state different starts of the table",
            f"{first:.12g} as table[0].setpoint",
        )


def _negative(
    axis: AxisLists, entries: Entries, count: int, largest: float, *, bilateral: bool | None
) -> FloatArray | None:
    """Return the ``count`` corrections (at most ``largest``) for an approach towards −: from the
    column ``neg`` if the table is ``bilateral``, else from the common column ``pos``.

    If the table is not ``bilateral``, values of ``neg`` that differ from ``pos`` are a fault.
    """
    name = f"{SECTION}table[i].neg"
    if bilateral:
        return column(axis, entries["neg"], count, name, largest)
    for index, statement in entries["neg"].items():
        other = entries["pos"].get(index)
        if other is None or other.number() != statement.number():
            message = f"bilateral is 0, and neg of entry {index} differs from pos"
            axis.fault(statement, message, "bilateral 1, or no column neg")
    return column(axis, entries["pos"], count, f"{SECTION}table[i].pos", largest)


def _sign(request: Request, address: str, assumed: list[Assumption]) -> float:
    options = request.options_of(address)
    chosen = options.get("table_values", "error")
    if chosen not in SIGNS:
        raise wrong_choice("table_values", chosen, SIGNS)
    why = (
        "option"
        if "table_values" in options
        else "inferred: the vendor names errors, its example contradicts itself"
    )
    assumed.append(Assumption(f"table_values of axis {address}", str(chosen), why))
    return SIGNS[str(chosen)]


def _period(
    axis: AxisLists,
    request: Request,
    positions: FloatArray,
    positive: FloatArray,
    negative: FloatArray,
    unit: float,
) -> float | None:
    """Return the travel per turn, mm or deg, of a repeating table, and check that its ends agree.
    ``unit``: how many mm or deg one unit of ``positions`` is.
    """
    last = len(positions) - 1
    statement = axis.statements[f"{SECTION}table[{last}].pos"]
    if last == 0:
        axis.fault(
            axis.statements[SECTION + "modulo"], "one entry is not enough for a turn", "two or more"
        )
    elif positive[0] != positive[-1] or negative[0] != negative[-1]:
        axis.fault(statement, "modulo: the last entry differs from the first", "the same values")
    span = float(positions[-1] - positions[0]) * unit
    turn = by_address(request.modulo, axis.address)
    # whole numbers of the list's unit may miss the turn by half a unit at each end
    if turn is not None and abs(span - turn) > 1.001 * unit:
        message = f"modulo: the table of axis {axis.address} spans {span:g}"
        axis.fault(statement, message, f"one turn, {turn:g}")
    return span if span > 0.0 else None


def switched(
    axis: AxisLists, request: Request, parameter: str, section: str, assumed: list[Assumption]
) -> bool:
    """Return whether a compensation is active, by its switch ``parameter`` in the axis parameter
    list, and by ``manual_activation`` in ``section``, the part of the list with its table.

    With ``manual_activation`` 1, the compensation is active only after an NC program has called it.
    It then counts as switched off, unless the job states that it was active.
    """
    on = axis.switch(parameter)
    switches = [None if on is None else float(on)]
    called = axis.switch(section + "manual_activation")
    switches += [0.0] if called else []
    active = request.is_active(switches)
    if request.active is not None:
        why = "as the job says"
    else:
        why = "only where an NC program calls it" if called else "not in the files"
    if called or on is None:
        assumed.append(Assumption(f"{parameter} of axis {axis.address}", str(int(active)), why))
    return active


def read_backlash(
    axis: AxisLists, table: LeadscrewTable | None, assumed: list[Assumption]
) -> float:
    """Return the backlash compensation of an axis, 0 or more, mm or deg. ``table``: the axis'
    leadscrew table, which must not have a column for each direction if backlash is active.

    The vendor does not state the direction of backlash. It is assumed to add nothing in the
    direction of referencing. A negative value (play before the measuring system) is a fault if it
    is active.
    """
    own = "getriebe[0].lose"
    value = axis.whole(own, -(2**15))
    chosen = axis.whole("lr_param.anwahl_losekomp", 0)
    if chosen is not None and chosen > 2:
        statement = axis.statements["lr_param.anwahl_losekomp"]
        axis.fault(statement, "lr_param.anwahl_losekomp", "0, 1 or 2")
    _other_gears(axis, value, chosen)
    if value is None:
        if own not in axis.statements:
            assumed.append(Assumption(f"{own} of axis {axis.address}", "0", "not in the files"))
        if chosen and own not in axis.statements:
            axis.missing(own, "lr_param.anwahl_losekomp switches backlash on")
        return 0.0
    if value == 0 or chosen == 0:
        return 0.0
    statement = axis.statements[own]
    if chosen is None:
        if "lr_param.anwahl_losekomp" not in axis.statements:
            axis.missing(
                "lr_param.anwahl_losekomp",
                f"{own} is not 0, but no line shows whether it is active",
            )
    elif value < 0 or value >= 2**15:
        message = f"{own} of axis {axis.address}: the direction of a negative one is unknown"
        axis.fault(statement, message, "0 to 32767, or lr_param.anwahl_losekomp 0")
    elif table is not None and table.active and table.bilateral:
        message = f"{own} of axis {axis.address} in addition to a table with two columns"
        axis.fault(statement, message, "0: the table holds the reversal")
    fact = f"sense of {own} of axis {axis.address}"
    assumed.append(Assumption(fact, "0 in the referencing direction", "unconfirmed"))
    return value * METRIC


def _other_gears(axis: AxisLists, first: int | None, chosen: int | None) -> None:
    for name, statement in axis.section("getriebe[").items():
        if (
            name.endswith("].lose")
            and not name.startswith("0]")
            and chosen != 0
            and statement.number() not in (0.0, first)
        ):
            message = f"{statement.name} of axis {axis.address}: the active gear is unknown"
            axis.fault(statement, message, "the value of getriebe[0].lose, or 0")
