"""Tables between axes (SINUMERIK's CEC): by index, each with its input and output axis and the direction in which it acts.

A pair of tables with one input and output axis, one for each direction, is how such a control holds a reversal that varies. Tables
that act on one pair of axes add up; one that is multiplied by another is not read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal

import numpy as np

from compwright.formats.addresses import normal_text
from compwright.formats.consistency import has_cross
from compwright.formats.gathering import Found, Gathered, same_value, the_one
from compwright.formats.notes import Notes
from compwright.formats.scale import Scale
from compwright.formats.schema import Choice, Definition
from compwright.formats.tables import Table, TableSource, read_table
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, CrossCompensation

#: Quantities of one table, by the names that a table on one axis has.
AS_TABLE = {"cross_value": "value", "cross_start": "table_start", "cross_end": "table_end", "cross_spacing": "table_spacing"}
#: Quantities without which a table is none; those behind them count as a default where they are absent.
_NEEDED = ("cross_input", "cross_output", *AS_TABLE, "cross_direction")
DATA = (*_NEEDED, "cross_multiplier", "cross_repeats")
#: Facts of a state that every axis has, in a form of their own: "index input output, ..." and "index points, ...".
CEC_TABLES, CEC_RESERVED = "cec_tables", "cec_reserved"
#: The indices of an axis' own two tables (+ first), and the limit of the sum of all corrections on it, mm or deg.
CEC_PAIR, CEC_MAX_SUM = "cec_pair", "cec_max_sum"

Pair = tuple[str, str]


@dataclass(frozen=True, slots=True)
class CecTable:
    """One table that a file holds. ``values`` (k,): what it adds to ``output``, weighted, at ``positions`` (k,) of ``input``.

    ``directions``: in which it acts. ``period``: the table repeats. ``active``: no file switches it off.
    """

    index: int
    input: str
    output: str
    directions: tuple[Direction, ...]
    positions: FloatArray
    values: FloatArray
    period: float | None
    active: bool

    @property
    def pair(self) -> Pair:
        """Input and output axis."""
        return self.input, self.output


@dataclass(frozen=True, slots=True)
class Cec:
    """Everything that the files say about such tables. ``reserved``: points by index; ``max_sum``: by output axis, mm or deg.

    ``occupied``: input and output axis by index, of tables that are left out of ``tables`` too.
    """

    tables: tuple[CecTable, ...] = ()
    occupied: Mapping[int, Pair] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
    max_sum: Mapping[str, float] = field(default_factory=dict)

    def own_axes(self) -> list[str]:
        """Return the axes with tables over themselves, switched on or not."""
        return list(dict.fromkeys(table.output for table in self.tables if table.input == table.output))

    def acting(self, pair: Pair) -> list[CecTable]:
        """Return the tables that act on a pair of axes."""
        return [table for table in self.tables if table.pair == pair and table.active]

    def facts(self, address: str) -> dict[str, str | float]:
        """Return what writing has to know, for the facts of a state."""
        facts: dict[str, str | float] = {}
        if self.occupied:
            facts[CEC_TABLES] = ", ".join(f"{index} {base} {corrected}" for index, (base, corrected) in self.occupied.items())
        if self.reserved:
            facts[CEC_RESERVED] = ", ".join(f"{index} {points}" for index, points in self.reserved.items())
        if address in self.max_sum:
            facts[CEC_MAX_SUM] = self.max_sum[address]
        own = {table.directions: table.index for table in self.acting((address, address))}
        if set(own) == {(Direction.POSITIVE,), (Direction.NEGATIVE,)}:
            facts[CEC_PAIR] = f"{own[(Direction.POSITIVE,)]} {own[(Direction.NEGATIVE,)]}"
        return facts


def as_table(definition: Definition) -> Definition:
    """Return the definition as if its tables between axes were tables on one axis: the same file, read by the same code."""
    bindings = {name: replace(definition.bindings[cross], quantity=name) for cross, name in AS_TABLE.items()}
    return replace(definition, bindings={**definition.bindings, **bindings})


def places_of(gathered: Gathered) -> dict[int, dict[str, list[Found]]]:
    """Return every place by table index and quantity."""
    found: dict[int, dict[str, list[Found]]] = {}
    if has_cross(gathered.definition):
        for quantity, places in gathered.singles.get((None, None), {}).items():
            for place in places:
                if quantity.startswith("cross_") and "table" in place.occurrence.tokens:
                    index = int(place.occurrence.tokens["table"].text)
                    found.setdefault(index, {}).setdefault(quantity, []).append(place)
    return found


def is_unused(places: Mapping[str, Sequence[Found]]) -> bool:
    """Return whether a table holds nothing but zeros, values and grid: the control's own default, which means no table."""
    numbers = [place.text for name in AS_TABLE for place in places.get(name, ())]
    return bool(numbers) and all(Decimal(number) == 0 for number in numbers)


def read_cec(gathered: Gathered, options: Mapping[str, object], notes: Notes, wanted: Iterable[str] = ()) -> Cec:
    """Return the tables between axes; what is wrong with them goes to ``notes``.

    ``wanted``: the axes that are asked for (none: all). A table that is multiplied by another is a fault when it acts on one of
    them, and left out with a finding when not.
    """
    if not has_cross(gathered.definition):
        return Cec()
    reader = _CecReader(gathered, options, notes, tuple(wanted))
    places = places_of(gathered)
    tables = [reader.table(index, places[index]) for index in sorted(places)]
    return Cec(
        tables=tuple(table for table in tables if table is not None),
        occupied=reader.occupied,
        reserved={
            index: int(found.text)
            for index in sorted(places)
            if (found := reader.one("cross_max_points", places[index], f"CEC table {index}")) is not None
        },
        max_sum=reader.max_sums(),
    )


class _CecReader:
    def __init__(self, gathered: Gathered, options: Mapping[str, object], notes: Notes, wanted: tuple[str, ...]) -> None:
        self.gathered = gathered
        self.definition = gathered.definition
        self.notes = notes
        self.wanted = wanted
        self.scale = Scale(as_table(self.definition), AxisKind.LINEAR, options, {})
        self.occupied: dict[int, Pair] = {}

    def one(self, quantity: str, places: Mapping[str, Sequence[Found]], label: str) -> Found | None:
        """Return the value that counts."""
        binding = self.definition.bindings[quantity]
        name = self._name(quantity)
        return the_one(binding, places.get(quantity, ()), f"{label}: {name}", self.notes.faults, self.notes.findings)

    def _name(self, quantity: str) -> str:
        return self.definition.statements[self.definition.bindings[quantity].statement].form.split("[", 1)[0]

    def table(self, index: int, places: Mapping[str, Sequence[Found]]) -> CecTable | None:
        """Return one table; None without one, or when something is wrong with it."""
        if not any(name in places for name in DATA) or is_unused(places):
            return None
        label = f"CEC table {index}"
        known = len(self.notes.faults)
        singles = {name: self.one(name, places, label) for name in DATA if name != "cross_value"}
        for name in _NEEDED:
            if name not in places:
                self._fault(label, f"{self._name(name)} is missing", next(iter(places.values()))[0])
        said = {name: found for name, found in singles.items() if found is not None}
        if len(self.notes.faults) > known:
            return None
        source = TableSource(
            label,
            places["cross_value"],
            {AS_TABLE[name]: found for name, found in said.items() if name in AS_TABLE},
            self.notes.faults,
            self.notes.findings,
        )
        table = read_table(self.scale.definition, source, self.scale)
        directions = self._directions(label, said["cross_direction"])
        if table is None or directions is None:
            return None
        given = normal_text(self.definition, said["cross_input"].text), normal_text(self.definition, said["cross_output"].text)
        self.occupied[index] = given
        active = self._active(label, places, given[1])
        if active and not self._simple(label, said.get("cross_multiplier"), given):
            return None
        self._check_reserved(label, places, table)
        weight = self.one("cross_weight", places, label)
        values = table.positive if weight is None else float(weight.text) * table.positive + 0.0
        repeats = self._word(label, "cross_repeats", said.get("cross_repeats"), tell=active) == "yes"
        period = float(table.positions[-1] - table.positions[0]) if repeats else None
        if period is not None and table.positive[0] != table.positive[-1]:
            self._fault(label, "the table repeats, but its two ends differ", said["cross_repeats"])
        return CecTable(index, *given, directions, table.positions, values, period, active)

    def _directions(self, label: str, found: Found) -> tuple[Direction, ...] | None:
        known = {"0": tuple(Direction), "1": (Direction.POSITIVE,), "-1": (Direction.NEGATIVE,)}
        for text, directions in known.items():
            if same_value(text, found.text):
                return directions
        self._fault(label, "a direction that is not known", found, expected="0 (both), 1 or -1")
        return None

    def _active(self, label: str, places: Mapping[str, Sequence[Found]], output: str) -> bool:
        """Return whether no file switches the table off, itself or the sum on its output axis; inch data are not read."""
        on_axis = self.gathered.singles.get((output, None), {})
        metric = self.one("cross_metric", on_axis, f"axis {output}")
        if metric is not None and self._word(f"axis {output}", "cross_metric", metric) == "no":
            self._fault(f"axis {output}", "corrections between axes in inch are not read", metric, expected="1: metric")
        for quantity, where in (("cross_table_enabled", places), ("cross_axis_enabled", on_axis)):
            owner = label if where is places else f"axis {output}"
            if self._word(owner, quantity, self.one(quantity, where, owner)) == "no":
                self.notes.find(
                    "CW-S034", "info", f"{label} is switched off in the files ({self._name(quantity)}); it corrects nothing"
                )
                return False
        return True

    def _simple(self, label: str, multiplier: Found | None, pair: Pair) -> bool:
        """Return whether the table is not multiplied by another one; where it is, that is told."""
        if multiplier is None or int(multiplier.text) == 0:
            return True
        other = f"it is multiplied by table {int(multiplier.text) - 1} (MULT_BY_TABLE), which is not a curve over one axis"
        if not self.wanted or pair[1] in self.wanted:
            self._fault(label, other, multiplier, expected="0: not multiplied")
        else:
            self.notes.find("CW-S011", "warning", f"{label} on axis {pair[1]} is left out: {other}")
        return False

    def _check_reserved(self, label: str, places: Mapping[str, Sequence[Found]], table: Table) -> None:
        reserved = self.one("cross_max_points", places, label)
        if reserved is not None and 0 < int(reserved.text) < table.positions.size:
            self._fault(label, "the control has not reserved so many points", reserved, found=str(table.positions.size))

    def _word(self, label: str, quantity: str, found: Found | None, *, tell: bool = True) -> str | None:
        """Return the neutral word of a choice, or what counts when it is absent, which is listed."""
        binding = self.definition.bindings[quantity]
        if found is None:
            absent = binding.when_absent
            if absent is None:
                return None
            if tell and absent.say != "nothing":
                self.notes.assume(f"{label}: {self._name(quantity)}", absent.value, str(absent.evidence))
            return absent.value
        values: Mapping[str, str] = binding.values if isinstance(binding, Choice) else {}
        word = next((word for text, word in values.items() if same_value(text, found.text)), None)
        if word is None:
            self._fault(label, f"{self._name(quantity)} has a value that is not known", found, expected=" or ".join(values))
        return word

    def max_sums(self) -> dict[str, float]:
        """Return the limit of the sum by output axis."""
        sums: dict[str, float] = {}
        for (address, _), places in self.gathered.singles.items():
            if address is not None and (found := self.one("cross_max_sum", places, f"axis {address}")) is not None:
                sums[address] = float(found.text)
                if not sums[address] >= 0:
                    self._fault(f"axis {address}", "a limit below 0", found, expected="0 or more")
        return sums

    def _fault(self, label: str, message: str, place: Found, *, expected: str = "", found: str | None = None) -> None:
        fault = Fault(
            message=f"{label}: {message}",
            file=place.occurrence.file,
            place=place.occurrence.place,
            expected=expected,
            found=place.text if found is None else found,
        )
        if fault not in self.notes.faults:
            self.notes.faults.append(fault)


def check_sums(cec: Cec, notes: Notes) -> None:
    """A control whose sum of corrections runs into its limit stands in alarm: such a state cannot be read as curves."""
    for output, limit in cec.max_sum.items():
        pairs = dict.fromkeys(table.pair for table in cec.tables if table.output == output and table.active)
        low = high = 0.0
        for pair in pairs:
            curves = [curve for _, _, *both in _merged(cec.acting(pair)) for curve in both]
            low += min(float(np.min(curve)) for curve in curves)
            high += max(float(np.max(curve)) for curve in curves)
        if max(high, -low) > limit * (1 + 1e-9):
            notes.faults.append(
                Fault(
                    message=f"axis {output}: its CEC tables together reach beyond CEC_MAX_SUM, where the control cuts them off",
                    expected=f"at most {limit:g}",
                    found=f"{low:g} .. {high:g}",
                )
            )


def _merged(tables: Sequence[CecTable]) -> list[tuple[float | None, FloatArray, FloatArray, FloatArray]]:
    """Return period, nodes and the sum of all tables by direction, for tables without a period and for each period and start.

    The sum of curves that are straight between their nodes is straight between the nodes of all of them.
    """
    groups: dict[tuple[float | None, float | None], list[CecTable]] = {}
    for table in tables:
        start = None if table.period is None else float(table.positions[0])
        groups.setdefault((table.period, start), []).append(table)
    merged = []
    for (period, _), members in groups.items():
        nodes: FloatArray = np.unique(np.concatenate([table.positions for table in members]))
        curves = []
        for direction in Direction:
            acting = [np.interp(nodes, table.positions, table.values) for table in members if direction in table.directions]
            curves.append(np.sum(acting, axis=0) if acting else np.zeros(nodes.size))
        merged.append((period, nodes, curves[0], curves[1]))
    return merged


def with_own_tables(cec: Cec, compensation: AxisCompensation) -> AxisCompensation:
    """Return what acts on an axis together with its tables over itself: they are its table where it has no other one."""
    own = [
        replace(
            compensation,
            positions=nodes,
            positive=positive,
            negative=negative,
            backlash=0.0,
            period=period,
            below="hold",
            above="hold",
        )
        for period, nodes, positive, negative in _merged(cec.acting((compensation.address, compensation.address)))
    ]
    if not own:
        return compensation
    if compensation.positions.size == 0:
        return replace(own[0], backlash=compensation.backlash, others=tuple(own[1:]))
    return replace(compensation, others=tuple(own))


def cross_tables(cec: Cec, kind: Callable[[str], AxisKind]) -> tuple[CrossCompensation, ...]:
    """Return what one axis does to another, in the order of the indices; tables of one pair that repeat differently stand apart."""
    pairs = dict.fromkeys(table.pair for table in cec.tables if table.input != table.output)
    return tuple(
        CrossCompensation(
            input=pair[0],
            output=pair[1],
            input_kind=kind(pair[0]),
            output_kind=kind(pair[1]),
            positions=nodes,
            positive=positive,
            negative=negative,
            period=period,
        )
        for pair in pairs
        for period, nodes, positive, negative in _merged(cec.acting(pair))
    )


def tables_in(facts: Mapping[str, Mapping[str, object]]) -> dict[int, Pair]:
    """Return input and output axis by table index, from the facts of a state."""
    return {
        int(index): (base, corrected)
        for said in facts.values()
        for entry in str(said.get(CEC_TABLES, "")).split(", ")
        if entry
        for index, base, corrected in (entry.split(" "),)
    }


def reserved_in(facts: Mapping[str, Mapping[str, object]]) -> dict[int, int]:
    """Return the points that are reserved by table index, from the facts of a state."""
    return {
        int(index): int(points)
        for said in facts.values()
        for entry in str(said.get(CEC_RESERVED, "")).split(", ")
        if entry
        for index, points in (entry.split(" "),)
    }


def free_tables(allowed: Sequence[int], in_use: Mapping[int, Pair], address: str) -> list[int]:
    """Return the indices that may hold the tables of an axis over itself: its own ones first, then free ones, as allowed."""
    own = [index for index in allowed if in_use.get(index) == (address, address)]
    return [*own, *(index for index in dict.fromkeys(allowed) if index not in in_use)]


def allowed_tables(options: Mapping[str, object]) -> tuple[int, ...]:
    """Return the option ``cec_tables``. Raises UsageError when it holds something else than indices."""
    given = options.get("cec_tables", ())
    if not isinstance(given, (tuple, list)) or not all(isinstance(index, int) for index in given):
        raise UsageError(Fault(message="the option has a wrong value", place="cec_tables", expected="indices", found=repr(given)))
    return tuple(dict.fromkeys(int(index) for index in given))
