"""Tables by which one axis corrects another (``kw.crosscomp``), or two axes a third
(``kw.crosscomp2``).

The table is in the list of the corrected axis, the slave. It applies to both directions and is
linear between its entries. The vendor names the values "correction" without a rule for the sign, so
the option ``cross_values`` must state the sign.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.controllers.isg.columns import (
    LARGEST,
    ascending,
    column,
    largest_value,
    table_entries,
    unit_of,
)
from compwright.controllers.isg.leadscrew import SIGNS, switched
from compwright.controllers.isg.lists import AxisLists, ListStatement
from compwright.controllers.request import Request, wrong_choice
from compwright.records.axis import FloatArray
from compwright.records.correction import Assumption

SECTION = "kw.crosscomp."
PLANE = "kw.crosscomp2."
_KEYS = ("unit", "last_index", "max_points", "master_ax_nr", "n_cycles", "manual_activation")
#: Entries that the kernel has room for where ``max_points`` is 0 or not there.
DEFAULT_ROOM = 1001


@dataclass(frozen=True, slots=True)
class CrossTable:
    """A cross-axis table: corrections (k,) of ``slave`` by positions (k,) of ``master``."""

    master: str
    slave: str
    positions: FloatArray
    values: FloatArray

    def at(self, x: FloatArray) -> FloatArray:
        """Return the correction of the slave with the master at ``x`` (any shape)."""
        return np.asarray(np.interp(x, self.positions, self.values), dtype=np.float64)


def read_cross(
    axis: AxisLists, request: Request, assumed: list[Assumption], notes: list[str]
) -> CrossTable | None:
    """Return the table by which the position of another axis corrects this axis; None without a
    table or, with a fault or a note, if it is invalid, not active, or of unknown sign.
    """
    read = _entries(axis, request)
    if read is None:
        return None
    master, positions, values = read
    active = switched(axis, request, "lr_param.crosscomp", SECTION, assumed)
    if not active or not np.any(values):
        why = "is 0 everywhere" if active else "does not act"
        notes.append(f"table by which axis {master} corrects axis {axis.address} {why}")
        return None
    sign = cross_sign(request, axis.address)
    if sign is None:
        notes.append(
            f"what axis {master} does to axis {axis.address} is unknown: the sign of kw.crosscomp"
            " is not known (option cross_values)"
        )
        return None
    units = unit_of(axis, SECTION + "unit", request, [master, axis.address])
    if not units:
        return None
    meaning = "correction" if sign > 0.0 else "error"
    assumed.append(Assumption(f"cross_values of axis {axis.address}", meaning, "option"))
    assumed.append(
        Assumption(
            f"outside the cross table of axis {axis.address}", "the end values hold", "inferred"
        )
    )
    corrections = values * units[1] * sign + 0.0  # no zero with a minus sign
    return CrossTable(master, axis.address, positions * units[0], corrections)


def _entries(axis: AxisLists, request: Request) -> tuple[str, FloatArray, FloatArray] | None:
    """Return the master axis, its positions (k,) and the slave's corrections (k,), both in the unit
    of the list.

    Returns None if the list has no table or, with faults, if the table is invalid.
    """
    if not axis.section(SECTION):
        return None
    entries = table_entries(axis, SECTION, _KEYS, ("setpoint", "correction"))
    filled = any(entries.values())
    last = axis.whole(SECTION + "last_index", 0)
    master = _master(axis, filled=filled)
    if master is None or last is None:
        if filled and SECTION + "last_index" not in axis.statements:
            axis.missing(SECTION + "last_index", "the number of entries is not given")
        return None
    if last >= (axis.whole(SECTION + "max_points", 0) or DEFAULT_ROOM):
        statement = axis.statements[SECTION + "last_index"]
        axis.fault(
            statement, "the table has more entries than there is room for", "less than max_points"
        )
        return None
    if last >= len(entries["correction"]):
        absent = last + 1 - len(entries["correction"])
        axis.missing(f"{SECTION}table[i].correction", f"{absent} of {last + 1} are missing")
        return None
    largest = largest_value(request, axis.address, axis, SECTION)
    name = f"{SECTION}table[i]."
    positions = column(axis, entries["setpoint"], last + 1, name + "setpoint", LARGEST)
    values = column(axis, entries["correction"], last + 1, name + "correction", largest)
    if positions is not None:
        ascending(axis, positions, entries["setpoint"])
    if axis.faults or positions is None or values is None:
        return None
    return master, positions, values


def _master(axis: AxisLists, *, filled: bool) -> str | None:
    """Return the master axis, whose position corrects this axis. None if the list states no master
    axis, with a fault if the table has values (``filled``), or if the axis would correct itself.
    """
    number = axis.whole(SECTION + "master_ax_nr", 0)
    if number is None or number == 0:
        if filled:
            axis.missing(SECTION + "master_ax_nr", "the axis that corrects it is not given")
        return None
    if str(number) == axis.address:
        statement = axis.statements[SECTION + "master_ax_nr"]
        axis.fault(statement, "the axis corrects itself", "an axis different from that of the list")
        return None
    return str(number)


def cross_sign(request: Request, slave: str) -> float | None:
    """Return the sign (1 or -1) of the slave's table values; None if the job does not state the
    sign.

    ``slave``: address of the corrected axis. Raises UsageError if the option ``cross_values`` is
    neither ``error`` nor ``correction``.
    """
    chosen = request.options_of(slave).get("cross_values")
    if chosen is not None and chosen not in SIGNS:
        raise wrong_choice("cross_values", chosen, SIGNS)
    return None if chosen is None else SIGNS[str(chosen)]


def refuse_plane(
    axis: AxisLists, request: Request, assumed: list[Assumption], notes: list[str]
) -> None:
    """Add a fault for an active table that depends on the positions of two axes."""
    section = axis.section(PLANE)
    if not section.keys() - {"max_points", "manual_activation", "n_cycles"}:
        return
    table = [one for name, one in section.items() if name.startswith("table[")]
    harmless = table and all(one.number() == 0.0 for one in table)
    if harmless or not switched(axis, request, "lr_param.crosscomp2", PLANE, assumed):
        notes.append(f"kw.crosscomp2 of axis {axis.address} does not act, or is 0 everywhere")
        return
    filled = (one for one in table if one.number() != 0.0)
    where: ListStatement = next(filled, next(iter(section.values())))
    message = f"kw.crosscomp2 corrects axis {axis.address} over two other axes: not read"
    axis.fault(where, message, "lr_param.crosscomp2 0, or values 0")


def refuse_others(axis: AxisLists) -> None:
    """Add a fault for each value other than 0 of a compensation that is neither leadscrew nor
    cross-axis compensation.
    """
    for name, statement in axis.section("kw.").items():
        known = name.startswith(("ssfk.", "crosscomp.", "crosscomp2."))
        if not known and statement.number() != 0.0:
            message = f"{statement.name} of axis {axis.address}: not known what it does"
            axis.fault(statement, message, "0, or no such line")
