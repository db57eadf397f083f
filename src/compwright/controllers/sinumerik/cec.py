"""SINUMERIK sag and angularity compensation (CEC, ``$AN_CEC``): the position of one axis corrects
another, or itself.

Stated from the manuals (Function Manual Extended Functions 03/2013, chapter K3; 802D sl Function
Manual 11/2012):

- The input is the setpoint of INPUT_AXIS, the value acts on OUTPUT_AXIS, which may be the same axis
  (p. 248). Several tables add up (802D sl p. 215). Linear between points (p. 237), outside the end
  values stay (p. 248), a modulo table repeats and its two end values should be equal (p. 249).
- DIRECTION 0: both; 1: only while the input axis moves towards +; -1: only towards - (p. 249).
- MULT_BY_TABLE = n: the product with the table of index n - 1 is added to the total as a further
  value (p. 245, p. 249).
- SD41300 switches a table, MD32710 of the output axis the sum (p. 245); SD41310 is a factor on a
  table, MD32720 limits the sum.
- Sign: not known. 802D sl p. 222 (a sagging arm is raised by positive values) speaks for "towards
  +", a builder's measuring program in a real archive for "towards -", as with the leadscrew table.
  Only the option ``cec_sign`` says it.
- A builder's tables need not be curves (real archive: MIN -850, MAX 0, STEP 100; output ``(X)``,
  STEP 0): such a table is left out where all its values are zero, and nothing is said of its pair
  of axes where they are not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.axes import AxisNames
from compwright.controllers.sinumerik.tables import (
    Remarks,
    Table,
    build_table,
    is_default,
    last_value,
    single,
    too_few_points,
)
from compwright.controllers.sinumerik.text import Assignment
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption

_PREFIX = "AN_CEC"
#: MD32720 where nobody changed it, mm or deg (from memory, no page found).
_USUAL_LIMIT = 1.0
#: Points of two tables that lie closer are one; no control divides a millimetre or a degree
#: further.
_SAME_POINT = 1e-9
_SIGNS = {"correction": 1, "error": -1}

#: Input and output axis.
Pair = tuple[str, str]


@dataclass(frozen=True, slots=True)
class SagTable:
    """One table. ``direction`` 1, -1 or 0 for both; ``factor``: index of the table it is multiplied
    by, None without one.
    """

    input: str
    output: str
    table: Table
    direction: int
    weight: float
    enabled: bool
    factor: int | None

    def value(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the weighted value at ``positions`` (any shape) of the input axis; zero where the
        table does not act.
        """
        if not self.enabled or self.direction == -direction.sign:
            return np.zeros(positions.shape)
        return self.weight * self.table.value(positions)

    def bound(self, direction: Direction) -> float:
        """Return the largest amount of the value in ``direction``."""
        return float(np.max(np.abs(self.value(self.table.positions(), direction))))


@dataclass(frozen=True, slots=True)
class Sag:
    """All tables. ``factors``: those that others are multiplied by, by index; ``sign`` of the
    values, +1 or -1.

    ``off``: output axes that MD32710 switches off; ``limits``: MD32720 by output axis, mm or deg;
    ``sign`` 0: not known. ``odd``: pairs with a table that acts and is no curve, and why.
    """

    by_pair: Mapping[Pair, tuple[SagTable, ...]]
    factors: Mapping[int, SagTable]
    off: frozenset[str]
    limits: Mapping[str, float]
    sign: int
    odd: Mapping[Pair, str] = field(default_factory=dict)

    def pairs(self) -> tuple[Pair, ...]:
        """Return input and output axis of all tables in order of their index, each pair once,
        switched on or not.
        """
        return tuple(self.by_pair)

    def nodes(self, pair: Pair) -> FloatArray:
        """Return the positions (k,) of the points of all tables of a pair, ascending."""
        return union([table.table.positions() for table in self._of(pair)])

    def is_judged(self, pair: Pair) -> bool:
        """Return whether it is known what a pair does."""
        return bool(self.sign) and pair not in self.odd and not self.other_inputs(pair)

    def own_shift(self, axis: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return what an axis' tables over itself add at ``positions``; UsageError where that
        cannot be said.
        """
        pair = (axis, axis)
        if pair in self.odd:
            raise UsageError(
                Fault(
                    message=(
                        f"what the tables of {axis} over itself do is not known: {self.odd[pair]}"
                    )
                )
            )
        if self.sign == 0:
            own = [
                table for table in self._of(pair) if table.enabled and np.any(table.table.values)
            ]
            if not own:
                return np.zeros(positions.shape)
            raise UsageError(
                Fault(
                    message=(
                        f"{axis} is corrected by CEC tables over itself, whose sign is not known"
                    ),
                    place="option cec_sign",
                    expected="correction or error",
                )
            )
        return self.shift(pair, positions, direction)

    def shift(self, pair: Pair, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return how far the output axis moves with the input axis at ``positions`` (any shape),
        moving in ``direction``.

        Raises UsageError when a product needs the position of a further axis.
        """
        if self.sign == 0 and pair[0] != pair[1]:
            raise UsageError(
                Fault(
                    message="the sign of CEC values",
                    place="option cec_sign",
                    expected="correction or error",
                )
            )
        others = self.other_inputs(pair)
        if others:
            raise UsageError(
                Fault(
                    message=(
                        f"what {pair[0]} does to {pair[1]} depends on the position of"
                        f" {', '.join(others)} as well ($AN_CEC_MULT_BY_TABLE)"
                    ),
                    expected="tables multiplied by tables of the same input axis",
                )
            )
        if pair[1] in self.off and pair[0] != pair[1]:
            return np.zeros(positions.shape)
        limit = self.limits.get(pair[1], np.inf)
        return np.asarray(
            self.sign * np.clip(self._total(pair, positions, direction), -limit, limit),
            dtype=np.float64,
        )

    def other_inputs(self, pair: Pair) -> tuple[str, ...]:
        """Return the further axes on whose position the correction of a pair depends."""
        if pair[1] in self.off and pair[0] != pair[1]:
            return ()
        factors = [
            self.factors[table.factor]
            for table in self._of(pair)
            if table.enabled and table.factor is not None
        ]
        return tuple(
            dict.fromkeys(
                factor.input for factor in factors if factor.enabled and factor.input != pair[0]
            )
        )

    def peak(self, pair: Pair) -> float:
        """Return the largest amount of the unlimited sum of a pair without further axes; with
        modulo tables an upper bound.
        """
        return max(self._peak(pair, direction) for direction in Direction)

    def _peak(self, pair: Pair, direction: Direction) -> float:
        own = self._of(pair)
        factors = [None if table.factor is None else self.factors[table.factor] for table in own]
        tables = [*own, *(factor for factor in factors if factor is not None)]
        if any(table.table.modulo for table in tables):
            products = [0.0 if factor is None else factor.bound(direction) for factor in factors]
            return sum(
                table.bound(direction) * (1.0 + more)
                for table, more in zip(own, products, strict=True)
            )
        nodes = union([table.table.positions() for table in tables])
        left, right = nodes[:-1], nodes[1:]
        start, middle, end = (
            self._total(pair, x, direction) for x in (left, (left + right) / 2.0, right)
        )
        bend = 2.0 * (
            start + end - 2.0 * middle
        )  # a product of two straight lines is a parabola: its vertex counts as well
        slope = 4.0 * middle - 3.0 * start - end
        vertex = np.clip(
            np.divide(-slope, 2.0 * bend, out=np.zeros(bend.shape), where=np.abs(bend) > 1e-12),
            0.0,
            1.0,
        )
        reached = [self._total(pair, x, direction) for x in (nodes, left + vertex * (right - left))]
        return float(np.max(np.abs(np.concatenate(reached))))

    def _total(self, pair: Pair, positions: FloatArray, direction: Direction) -> FloatArray:
        total = np.zeros(positions.shape)
        for table in self._of(pair):
            value = table.value(positions, direction)
            total = total + value
            if table.factor is not None:
                total = total + value * self.factors[table.factor].value(positions, direction)
        return total

    def _of(self, pair: Pair) -> tuple[SagTable, ...]:
        return self.by_pair.get(pair, ())


def union(positions: Sequence[FloatArray]) -> FloatArray:
    """Return the points (k,) of several tables, ascending, those nearer than 1e-9 mm or deg
    once.
    """
    filled = [nodes for nodes in positions if nodes.size]
    if len(filled) < 2:
        return filled[0] if filled else np.empty(0)
    every = np.sort(np.concatenate(filled))
    return np.asarray(
        every[np.concatenate([[True], np.diff(every) > _SAME_POINT])], dtype=np.float64
    )


def load_sag(
    entries: Sequence[Assignment],
    request: Request,
    spelling: Mapping[str, str],
    remarks: Remarks,
    unknown_keys: Mapping[int, str],
    names: AxisNames,
    screws: frozenset[str] = frozenset(),
) -> Sag:
    """Return the tables from all assignments in the order of the files; what is wrong goes to
    ``remarks``.

    ``spelling``: upper case -> the name by which an axis is already known; ``unknown_keys``: by
    table a key that is not known; ``names``: which names are those of machine axes; ``screws``:
    axes (upper case) whose leadscrew table is switched on. Raises UsageError for an option
    ``cec_sign`` that is neither ``correction`` nor ``error``.
    """
    sign = _sign(request)
    loader = _Loader(
        [entry for entry in entries if "CEC" in entry.name], dict(spelling), remarks, request
    )
    loader.unknown_keys, loader.names, loader.screws = unknown_keys, names, screws
    tables = loader.tables()
    by_pair: dict[Pair, list[SagTable]] = defaultdict(list)
    for table in tables.values():
        by_pair[table.input, table.output].append(table)
    of_output: dict[str, list[Pair]] = defaultdict(list)
    for pair in by_pair:
        of_output[pair[1]].append(pair)
    if remarks.faults:  # a table may be missing: what follows would be wrong about the others
        return Sag({}, {}, frozenset(), {}, sign)
    evidence = (
        "option" if "cec_sign" in request.options else "not asked for here; no Siemens text says it"
    )
    if tables and sign:
        remarks.assumed.append(
            Assumption(
                "sign of the CEC values (cec_sign)", "correction" if sign > 0 else "error", evidence
            )
        )
    elif tables:
        remarks.notes.append(
            "what the CEC tables do is not said: their sign is not known (option cec_sign)"
        )
    sag = Sag(
        by_pair={pair: tuple(given) for pair, given in by_pair.items()},
        factors={
            table.factor: tables[table.factor]
            for table in tables.values()
            if table.factor is not None
        },
        off=frozenset(output for output in of_output if loader.switched_off(output)),
        odd=loader.odd,
        limits={
            output: limit
            for output in of_output
            if (limit := loader.of_axis(output, "MA_CEC_MAX_SUM")) is not None
        },
        sign=sign,
    )
    for output, pairs in of_output.items():
        if output not in sag.off:
            _remark(sag, output, pairs, remarks)
    return sag


def _sign(request: Request) -> int:
    option = request.options.get(
        "cec_sign", "correction"
    )  # a job's options always hold it: None where nobody said it
    if option is None:
        return 0
    if option not in _SIGNS:
        raise UsageError(
            Fault(message="option cec_sign", expected=" or ".join(_SIGNS), found=repr(option))
        )
    return _SIGNS[str(option)]


def _remark(sag: Sag, output: str, pairs: Sequence[Pair], remarks: Remarks) -> None:
    """Say what the control does unasked to the sum of one output axis, and what cannot be said of
    it.
    """
    reached = 0.0
    for pair in pairs:
        base = pair[0]
        ways = {table.direction for table in sag.by_pair[pair] if table.enabled}
        if ways in ({1}, {-1}):
            way = "+" if 1 in ways else "-"
            remarks.notes.append(
                f"{output}: its tables over {base} act only while {base} moves towards {way}"
            )
        others = sag.other_inputs(pair)
        if others:
            remarks.notes.append(
                f"{output}: its tables over {base} are multiplied by tables over"
                f" {', '.join(others)}: that depends on two positions and is not judged"
            )
        else:
            reached += sag.peak(pair)
    limit = sag.limits.get(output)
    if limit is not None and reached > limit:
        remarks.notes.append(
            f"{output}: MD32720 $MA_CEC_MAX_SUM cuts the sum of its CEC tables to {limit:g}; they"
            f" reach up to {reached:g}"
        )
    if limit is None and reached > _USUAL_LIMIT:
        remarks.assumed.append(
            Assumption(
                f"MD32720 $MA_CEC_MAX_SUM of {output}",
                "no limit",
                f"not in the files; unchanged it would be {_USUAL_LIMIT:g}",
            )
        )


class _Loader:
    """Builds the tables from their assignments."""

    def __init__(
        self,
        entries: Sequence[Assignment],
        spelling: dict[str, str],
        remarks: Remarks,
        request: Request,
    ) -> None:
        self.request = request
        self.unknown_keys: Mapping[int, str] = {}
        self.screws: frozenset[str] = frozenset()
        self.names = AxisNames({}, {})
        self.odd: dict[Pair, str] = {}
        self.left_out: list[int] = []
        self.spelling = spelling
        self.remarks = remarks
        self.by_table: dict[int, list[Assignment]] = defaultdict(list)
        self.by_axis: dict[str, list[Assignment]] = defaultdict(list)
        for entry in entries:
            if entry.axis:
                self.by_axis[entry.axis.upper()].append(entry)
            else:
                self.by_table[entry.number].append(entry)

    def tables(self) -> dict[int, SagTable]:
        """Return the tables by index, ascending."""
        found: dict[int, SagTable] = {}
        empty: list[int] = []
        asked: dict[int, Assignment] = {}
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
                asked[table.factor] = next(
                    entry for entry in data if entry.name == f"{_PREFIX}_MULT_BY_TABLE"
                )
        if empty:
            self.remarks.notes.append(
                f"CEC tables {_ranges(empty)}: all zero, the control's own default for no table"
            )
        self._check_factors(found, asked, {*empty, *self.left_out})
        if self.left_out:
            self.remarks.notes.append(
                f"CEC tables {_ranges(self.left_out)} are no curves and left alone"
            )
        zero = {*empty, *self.left_out}  # a product with one of these adds nothing
        return {
            index: replace(table, factor=None) if table.factor in zero else table
            for index, table in found.items()
        }

    def of_axis(self, axis: str, name: str) -> float | None:
        """Return the last value of a machine data of an axis, None where the files do not hold
        it.
        """
        return last_value(self.by_axis.get(axis.upper(), []), name)

    def switched_off(self, output: str) -> bool:
        """Return whether MD32710 ends as 0, with the remark that belongs to either answer."""
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
        self, index: int, entries: Sequence[Assignment], data: Sequence[Assignment]
    ) -> SagTable | None:
        """Return a table that is a curve. A whole one that is none is left alone; one that was cut
        short is a fault.
        """
        outer, self.remarks = self.remarks, Remarks()
        try:
            table = self._table(index, entries, data)
            inner = self.remarks
        finally:
            self.remarks = outer
        key = self.unknown_keys.get(index)
        why = (
            inner.faults[0].message
            if inner.faults
            else ""
            if key is None
            else f"${key} is not known"
        )
        names = {
            entry.name: entry.names
            for entry in data
            if entry.name in {f"{_PREFIX}_INPUT_AXIS", f"{_PREFIX}_OUTPUT_AXIS"}
        }
        strange = [name for name in names.values() if not self.names.is_machine_axis(name)]
        if not why and strange:
            why = f"{strange[0]} is no machine axis"
        output = names.get(f"{_PREFIX}_OUTPUT_AXIS", "")
        on = self._acts(entries, output, own=output == names.get(f"{_PREFIX}_INPUT_AXIS"))
        metric = last_value(self.by_axis.get(output.upper(), []), "MA_CEC_SCALING_SYSTEM_METRIC")
        if not why and on and metric == 0.0:
            why = "its values are in inch (MD32711)"
        if not why:
            outer.notes += inner.notes
            outer.assumed += inner.assumed
            return table
        values = {
            entry.point: entry.value
            for entry in data
            if entry.name == _PREFIX and entry.point is not None
        }
        needed = {
            f"{_PREFIX}{key}"
            for key in ("", "_INPUT_AXIS", "_OUTPUT_AXIS", "_STEP", "_MIN", "_MAX", "_DIRECTION")
        }
        cut = (
            needed - {entry.name for entry in data}
            or not all(names.values())
            or set(values) != set(range(len(values)))
        )
        if inner.faults and (cut or any("contradicts" in fault.message for fault in inner.faults)):
            outer.faults += inner.faults
            outer.faults += [] if key is None else [data[0].fault(f"variable ${key} is not known")]
            return None
        base = names[f"{_PREFIX}_INPUT_AXIS"]
        asked = {name.upper() for name in self.names.called.values()}
        if (
            any(values.values())
            and on
            and base.upper() == output.upper()
            and (not asked or output.upper() in asked)
        ):
            outer.faults += inner.faults or [data[0].fault(f"{label_of(index)}: {why}")]
            return None
        self.left_out.append(index)
        if any(values.values()) and on:
            pair = tuple(self.spelling.setdefault(name.upper(), name) for name in (base, output))
            self.odd[pair[0], pair[1]] = f"{label_of(index)}: {why}"
        return None

    def _acts(self, entries: Sequence[Assignment], output: str, *, own: bool) -> bool:
        """Return whether a table acts; what the job says of the test counts for tables of an axis
        over itself.

        Not where the leadscrew table of the axis is on: then the job speaks of that one, and what
        is switched off slept.
        """
        switches = [
            last_value(entries, "SN_CEC_TABLE_ENABLE"),
            last_value(self.by_axis.get(output.upper(), []), "MA_CEC_ENABLE"),
        ]
        if own and not (output.upper() in self.screws and 0.0 in switches):
            return self.request.acts(switches)
        return all(switch != 0.0 for switch in switches)

    def _table(
        self, index: int, entries: Sequence[Assignment], data: Sequence[Assignment]
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
        )

    def _axis_of(self, data: Sequence[Assignment], name: str, label: str) -> str:
        """Return an axis of a table by the name that all others use, empty with a fault when the
        files do not say it.
        """
        entry = single(data, name, self.remarks.faults)
        if entry is None or not entry.names:
            at = entry or data[0]
            self.remarks.faults.append(
                at.fault(f"{label} is incomplete", expected=f"${name} with an axis such as (AX1)")
            )
            return ""
        return self.spelling.setdefault(entry.names.upper(), entry.names)

    def _enabled(
        self, index: int, entries: Sequence[Assignment], output: str, *, own: bool
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
        return self._acts(entries, output, own=True) if own else enabled != 0.0

    def _check_factors(
        self, found: dict[int, SagTable], asked: dict[int, Assignment], empty: set[int]
    ) -> None:
        """Refuse a product with a table that no file holds; name how the others are taken."""
        for index, entry in asked.items():
            if index in found:
                how = "added beside the tables' own values, each with its weight"
                source = "inferred from Function Manual 03/2013 p. 249"
                self.remarks.assumed.append(
                    Assumption(f"product with CEC table {index}", how, source)
                )
            elif index not in empty and not self.remarks.faults:
                self.remarks.faults.append(
                    entry.fault(
                        f"{entry.variable} names a table that is not in the files",
                        expected=f"table of index {index}",
                    )
                )


def label_of(index: int) -> str:
    """Return how messages call a table."""
    return f"CEC table {index}"


def _ranges(indices: Sequence[int]) -> str:
    """Return ascending numbers in words, runs shortened: ``0, 3 to 61``."""
    runs: list[list[int]] = []
    for index in indices:
        if runs and runs[-1][-1] == index - 1:
            runs[-1].append(index)
        else:
            runs.append([index])
    return ", ".join(f"{run[0]} to {run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)
