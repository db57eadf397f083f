"""Build cross-axis tables (CEC) from their assignments, with faults and ignored tables."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

import numpy as np

from compwright.controllers.request import Request, by_address
from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.lengths import Lengths, inches_in_mm
from compwright.controllers.sinumerik.sag import Pair, SagTable
from compwright.controllers.sinumerik.tables import (
    Remarks,
    build_table,
    is_default,
    last_value,
    single,
    too_few_points,
)
from compwright.controllers.sinumerik.text import VariableAssignment
from compwright.foundations.errors import Fault
from compwright.records.axis import Direction
from compwright.records.correction import Assumption

_PREFIX = "AN_CEC"
_NEEDED = frozenset(
    f"{_PREFIX}{key}"
    for key in ("", "_INPUT_AXIS", "_OUTPUT_AXIS", "_STEP", "_MIN", "_MAX", "_DIRECTION")
)
#: What makes a table something else than its values say, where it is larger than this: SD41320 and
#: SD41321 are added to points 0 and 1, TYPE 1 is a table of cylinder error compensation (Siemens'
#: texts of these data), an NCU above 1 belongs to another control (manual p. 268).
_ELSE = {
    "SN_CEC_0": (0.0, "SD41320 is added to its point 0"),
    "SN_CEC_1": (0.0, "SD41321 is added to its point 1"),
    "AN_CEC_TYPE": (0.0, "it is a table of cylinder error compensation"),
    "AN_CEC_INPUT_NCU": (1.0, "its input axis belongs to another NCU"),
    "AN_CEC_OUTPUT_NCU": (1.0, "its output axis belongs to another NCU"),
}


class CecTableLoader:
    """Builds the cross-axis tables (CEC) from their assignments.

    - ``odd``: for each axis, the reason why an active table that corrects it by its own position
      cannot be evaluated.
    - ``left_out``: indices of ignored tables.
    - ``uncounted``: axes with a table by their own position that stays unchanged and is not
      included in the correction.
    """

    def __init__(
        self,
        entries: Sequence[VariableAssignment],
        spelling: dict[str, str],
        remarks: Remarks,
        request: Request,
    ) -> None:
        self.request = request
        self.unknown_keys: Mapping[int, str] = {}
        self.screws: frozenset[str] = frozenset()
        self.names = MachineAxisNames({}, {})
        self.lengths = Lengths(inch=False, rotary={})
        self.odd: dict[str, str] = {}
        self.left_out: list[int] = []
        self.uncounted: list[str] = []
        self.spelling = spelling
        self.remarks = remarks
        self.by_table: dict[int, list[VariableAssignment]] = defaultdict(list)
        self.by_axis: dict[str, list[VariableAssignment]] = defaultdict(list)
        for entry in entries:
            if entry.axis:
                self.by_axis[entry.axis.upper()].append(entry)
            else:
                self.by_table[entry.number].append(entry)

    def tables(self) -> dict[int, SagTable]:
        """Return the CEC tables, ascending by table index."""
        found: dict[int, SagTable] = {}
        empty: list[int] = []
        factor_entries: dict[int, VariableAssignment] = {}
        for index, entries in sorted(self.by_table.items()):
            data = [entry for entry in entries if entry.name.startswith(_PREFIX)]
            if not data:
                continue
            if is_default(data, _PREFIX):
                empty.append(index)
                continue
            table = self._curve(index, entries, data)
            if table is None:
                continue
            found[index] = table
            if table.factor is not None:
                factor_entries[table.factor] = next(
                    entry for entry in data if entry.name == f"{_PREFIX}_MULT_BY_TABLE"
                )
        if empty:
            self.remarks.notes.append(
                f"CEC tables {_ranges(empty)}: all zero, the control's own default for no table"
            )
        self._check_factors(found, factor_entries, {*empty, *self.left_out})
        if self.left_out:
            self.remarks.notes.append(
                f"CEC tables {_ranges(self.left_out)} are not curves and are left as they are"
            )
        return found

    def beyond(self, tables: Mapping[int, SagTable], room: tuple[int, int]) -> list[Fault]:
        """Return a fault for each table whose index or number of points the control does not have.
        ``room``: the control's number of tables, and the number of points of each.
        """
        most, points = room
        return [
            self.by_table[index][0].fault(
                f"{label_of(index)} is none of this control, or has too many points",
                expected=f"tables 0 to {most - 1} of at most {points} points",
                found=f"{table.table.values.size} points",
            )
            for index, table in tables.items()
            if index >= most or table.table.values.size > points
        ]

    def without_cut_sums(self, tables: Sequence[SagTable]) -> list[SagTable]:
        """Leave out all tables of an output axis if the sum of its active tables exceeds its limit
        (MD32720) and none of them is to be changed; return the other tables.

        The tables that are left out have the same effect before and after, so they need not be
        evaluated.
        """
        cut = set()
        for output in {table.output for table in tables}:
            mine = [table for table in tables if table.output == output and table.is_active()]
            limit = self.of_axis(output, "MA_CEC_MAX_SUM")
            if limit is None or not mine or not all(table.stays for table in mine):
                continue
            if self.of_axis(output, "MA_CEC_ENABLE") == 0.0:
                continue
            if any(reach > limit * (1 + 1e-9) for reach in _extremes(mine)):
                cut.add(output)
                self.uncounted += [table.output for table in mine if table.input == output]
                self.remarks.notes.append(
                    f"{output}: MD32720 $MA_CEC_MAX_SUM cuts the sum of its CEC tables to"
                    f" {limit:g}; they stay and are not counted"
                )
        return [table for table in tables if table.output not in cut]

    def of_axis(self, axis: str, name: str) -> float | None:
        """Return the last value of an axis' machine data; None if the files do not contain it."""
        return last_value(self.by_axis.get(axis.upper(), []), name)

    def switched_off(self, output: str) -> bool:
        """Return whether the last value of MD32710 deactivates the CEC tables of an output axis; if
        so, add a note.
        """
        enabled = self.of_axis(output, "MA_CEC_ENABLE")
        if enabled is None:
            self.remarks.assumed.append(
                Assumption(
                    f"MD32710 $MA_CEC_ENABLE of {output}",
                    "1",
                    "not in the files: counted as active",
                )
            )
        elif enabled == 0.0:
            self.remarks.notes.append(
                f"{output}: MD32710 $MA_CEC_ENABLE ends as 0: its CEC tables do not act"
            )
        return enabled == 0.0

    def _curve(
        self, index: int, entries: Sequence[VariableAssignment], data: Sequence[VariableAssignment]
    ) -> SagTable | None:
        """Return the table ``index`` as a curve, from its assignments ``data``; None if it is
        invalid, or incomplete (then with a fault). ``entries``: the same with its switches and
        factors.
        """
        names = {
            entry.name.removeprefix(f"{_PREFIX}_"): entry.names
            for entry in data
            if entry.name in {f"{_PREFIX}_INPUT_AXIS", f"{_PREFIX}_OUTPUT_AXIS"}
        }
        base, output = names.get("INPUT_AXIS", ""), names.get("OUTPUT_AXIS", "")
        data = self._in_mm(data, base, output)
        outer, self.remarks = self.remarks, Remarks()
        try:
            table = self._table(index, entries, data)
            inner = self.remarks
        finally:
            self.remarks = outer
        on = self._is_active(entries, output, own=output == base)
        reasons = self._reasons(index, entries, (base, output)) if on else iter(())
        strange = (
            f"{name} is not a machine axis"
            for name in names.values()
            if not self.names.is_machine_axis(name)
        )
        key = self.unknown_keys.get(index)
        why = (
            inner.faults[0].message
            if inner.faults
            else f"${key} is not known"
            if key is not None
            else next(chain(strange, reasons), "")
        )
        if not why:
            outer.notes += inner.notes
            outer.assumed += inner.assumed
            return table
        if inner.faults and _is_damaged(data, names, inner):
            outer.faults += inner.faults
            outer.faults += (
                [] if key is None else [data[0].fault(f"the variable ${key} is unknown")]
            )
            return None
        self._leave_out(index, (base, output), why, data if on else (), inner)
        return None

    def _in_mm(
        self, data: Sequence[VariableAssignment], base: str, output: str
    ) -> Sequence[VariableAssignment]:
        """Return a table's assignments in mm; MD32711 of its output axis states the unit (mm or
        inch).
        """
        if self.of_axis(output, "MA_CEC_SCALING_SYSTEM_METRIC") != 0.0:
            return data
        return inches_in_mm(
            data,
            values=self.lengths.is_linear(output),
            positions=self.lengths.is_linear(base),
        )

    def _reasons(
        self, index: int, entries: Sequence[VariableAssignment], pair: Pair
    ) -> Iterator[str]:
        """Yield the reasons why an active table has a different effect from its values."""
        for name, (most, why) in _ELSE.items():
            value = last_value(entries, name)
            if value is not None and not 0.0 <= value <= most:
                yield f"${name}[{index}] = {value:g}: {why}"
        unit = self.of_axis(pair[1], "MA_CEC_SCALING_SYSTEM_METRIC")
        if self.lengths.inch and unit is None and any(map(self.lengths.is_linear, pair)):
            yield (
                f"the basic system is the inch and MD32711 of {pair[1]}, which says the unit of"
                " CEC tables, is not in the files"
            )

    def _leave_out(
        self,
        index: int,
        pair: Pair,
        why: str,
        entries: Sequence[VariableAssignment],
        inner: Remarks,
    ) -> None:
        """Ignore a complete table whose effect cannot be evaluated, and report the reason ``why``.
        ``inner``: the faults and notes from reading this table.

        ``index``: index of the table. ``pair``: its input and output axis. ``entries``: its
        assignments, empty if it is switched off. An active table that corrects an axis of the job
        by its own position gives a fault instead, unless the job leaves it unchanged.
        """
        base, output = pair
        moved = any(entry.value for entry in entries if entry.name == _PREFIX)
        moved = moved or ("SN_CEC" in why and bool(entries))
        wanted = {name.upper() for name in self.names.called.values()}
        own = base.upper() == output.upper() and (not wanted or output.upper() in wanted)
        if moved and own and not self._stays(index, output):
            self.remarks.faults += inner.faults or [entries[0].fault(f"{label_of(index)}: {why}")]
            return
        self.left_out.append(index)
        if moved and (own or base.upper() != output.upper()):
            self.remarks.notes.append(f"{label_of(index)}: {why}: it stays and is not counted")
            if own:
                self.uncounted.append(self.spelling.setdefault(output.upper(), output))
        elif moved:
            name = self.spelling.setdefault(output.upper(), output)
            self.odd[name] = f"{label_of(index)}: {why}"

    def _stays(self, index: int, output: str) -> bool:
        """Return whether a table stays unchanged because the option ``cec_tables`` does not name
        it.
        """
        if by_address(self.request.axis_options, output) is None:
            return False
        named = self.request.options_of(output).get("cec_tables")
        return not isinstance(named, list | tuple) or index not in named

    def _is_active(self, entries: Sequence[VariableAssignment], output: str, *, own: bool) -> bool:
        """Return whether a table of the axis ``output`` is active: by the files or, if it corrects
        the axis by its own position (``own``), also by the job.

        If the leadscrew table of the axis is on and the CEC table is off, only the files decide.
        The answer ``active`` of the job then refers to the leadscrew table.
        """
        switches = [
            last_value(entries, "SN_CEC_TABLE_ENABLE"),
            self.of_axis(output, "MA_CEC_ENABLE"),
        ]
        if own and not (output.upper() in self.screws and 0.0 in switches):
            return self.request.is_active(switches)
        return all(switch != 0.0 for switch in switches)

    def _table(
        self, index: int, entries: Sequence[VariableAssignment], data: Sequence[VariableAssignment]
    ) -> SagTable | None:
        before = len(self.remarks.faults)
        faults = self.remarks.faults
        label = f"CEC table {index}"
        table = build_table(data, _PREFIX, label, f"table {index}", self.remarks)
        axes = [
            self._axis_of(data, f"{_PREFIX}_{key}", label) for key in ("INPUT_AXIS", "OUTPUT_AXIS")
        ]
        direction = single(data, f"{_PREFIX}_DIRECTION", faults)
        factor = single(data, f"{_PREFIX}_MULT_BY_TABLE", faults)
        if table is not None:
            reserved = [entry for entry in entries if entry.name == "MN_MM_CEC_MAX_POINTS"]
            faults += too_few_points(reserved, table, f"MD18342 of {label}")
        if (
            direction is None
            # the control would keep what its memory holds, and a file cut short would act in both
            # directions
        ):
            faults.append(data[0].fault(f"{label} is incomplete", expected=f"${_PREFIX}_DIRECTION"))
        if table is None or direction is None or len(faults) > before:
            return None
        if factor is None:
            self.remarks.assumed.append(
                Assumption(f"${_PREFIX}_MULT_BY_TABLE of table {index}", "0", "not in the files")
            )
        weight = last_value(entries, "SN_CEC_TABLE_WEIGHT")
        return SagTable(
            input=axes[0],
            output=axes[1],
            table=table,
            direction=int(direction.value),
            weight=1.0 if weight is None else weight,
            enabled=self._enabled(index, entries, axes[1], own=axes[0] == axes[1]),
            factor=int(factor.value) - 1 if factor is not None and factor.value else None,
            stays=self._stays(index, axes[1]),
        )

    def _axis_of(self, data: Sequence[VariableAssignment], name: str, label: str) -> str:
        """Return the name AXn of a table's axis; empty, with a fault, if not stated."""
        entry = single(data, name, self.remarks.faults)
        if entry is None or not entry.names:
            at = entry or data[0]
            self.remarks.faults.append(
                at.fault(f"{label} is incomplete", expected=f"${name} with an axis such as (AX1)")
            )
            return ""
        return self.spelling.setdefault(entry.names.upper(), entry.names)

    def _enabled(
        self, index: int, entries: Sequence[VariableAssignment], output: str, *, own: bool
    ) -> bool:
        enabled = last_value(entries, "SN_CEC_TABLE_ENABLE")
        if enabled is None:
            fact = f"SD41300 $SN_CEC_TABLE_ENABLE of table {index}"
            self.remarks.assumed.append(
                Assumption(fact, "1", "not in the files: counted as active")
            )
        elif enabled == 0.0:
            self.remarks.notes.append(
                f"CEC table {index}: SD41300 $SN_CEC_TABLE_ENABLE ends as 0: the table does not act"
            )
        return self._is_active(entries, output, own=True) if own else enabled != 0.0

    def _check_factors(
        self,
        found: dict[int, SagTable],
        factor_entries: dict[int, VariableAssignment],
        empty: set[int],
    ) -> None:
        """Add a fault for each assignment that multiplies a table by one which no file contains.
        ``factor_entries``: these assignments by index of the multiplying table; ``empty``: tables
        that are 0 or ignored.
        """
        for index, entry in factor_entries.items():
            if index not in found and index not in empty and not self.remarks.faults:
                self.remarks.faults.append(
                    entry.fault(
                        f"{entry.variable} names a table that is not in the files",
                        expected=f"table of index {index}",
                    )
                )


def _is_damaged(
    data: Sequence[VariableAssignment], names: Mapping[str, str], inner: Remarks
) -> bool:
    """Return whether a table is incomplete or contradicts itself, as in a file that was cut short.
    ``names``: its axes; ``inner``: the faults found while it was read.
    """
    points = {entry.point for entry in data if entry.name == _PREFIX}
    incomplete = _NEEDED - {entry.name for entry in data} or not all(names.values())
    gaps = points != set(range(len(points)))
    return bool(incomplete or gaps) or any("contradicts" in f.message for f in inner.faults)


def label_of(index: int) -> str:
    """Return the name of the table with this index in messages, such as ``CEC table 3``."""
    return f"CEC table {index}"


def _ranges(indices: Sequence[int]) -> str:
    """Return ascending numbers as text with ranges: ``0, 3 to 61``."""
    runs: list[list[int]] = []
    for index in indices:
        if runs and runs[-1][-1] == index - 1:
            runs[-1].append(index)
        else:
            runs.append([index])
    return ", ".join(f"{run[0]} to {run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)


def _extremes(tables: Sequence[SagTable]) -> tuple[float, float]:
    """Return the largest sum of ``tables`` that can occur, and minus the smallest sum.

    Both are found for the sum of the tables of each input axis. For several input axes, they are
    added up.
    """
    up = down = 0.0
    for base in {table.input for table in tables}:
        mine = [table for table in tables if table.input == base]
        where = np.unique(np.concatenate([table.table.positions() for table in mine]))
        sums = [
            sum((table.value(where, direction) for table in mine), np.zeros(where.shape))
            for direction in Direction
        ]
        up += float(np.max(sums))
        down -= float(np.min(sums))
    return up, down
