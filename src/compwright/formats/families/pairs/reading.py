"""Tables between axes (SINUMERIK's CEC): by index, each with its input and output axis and the
direction in which it acts.

A pair of tables with one input and output axis, one for each direction, is how such a control holds
a reversal that varies. Tables that act on one pair of axes add up; one that is multiplied by
another is not read.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal

from compwright.formats.definition.consistency import curves, has_cross
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.families.activity import Activity, Leadscrew
from compwright.formats.families.grid.tables import Table, TableSource, read_table
from compwright.formats.text.gathering import Found, Gathered, same_value
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray

#: Quantities of one table, by the names that a table on one axis has.
AS_TABLE = {
    "cross_value": "value",
    "cross_start": "table_start",
    "cross_end": "table_end",
    "cross_spacing": "table_spacing",
}
#: Quantities without which a table is none; those behind them count as a default where they are
#: absent.
_NEEDED = ("cross_input", "cross_output", *AS_TABLE, "cross_direction")
DATA = (*_NEEDED, "cross_multiplier", "cross_repeats")
#: Facts of a state that every axis has, in a form of their own: "index input output, ..." and
#: "index points, ...".
CEC_TABLES, CEC_RESERVED = "cec_tables", "cec_reserved"
#: The indices of an axis' own two tables (+ first), and the limit of the sum of all corrections on
#: it, mm or deg.
CEC_PAIR, CEC_MAX_SUM = "cec_pair", "cec_max_sum"
#: The tables between axes that act and of which nobody knows what they do (no sign, no curve), each
#: with a print of its values.
CEC_UNTOLD = "cec_untold"
#: What the tables that cannot be read add to an axis at most, mm or deg.
CEC_ODD_SUM = "cec_odd_sum"

#: The check that answers the option cec_sign, in words.
SIGN_CHECK = (
    "Ten minutes show it: with a dial gauge on the axis, MD32710 and SD41300 on, write +0.1 into"
    " every point of one table that is known to be free: an axis that moves by 0.1 in + has"
    " cec_sign: correction, one that moves in - has cec_sign: error; write 0 again"
)

Pair = tuple[str, str]


@dataclass(frozen=True, slots=True)
class CecTable:
    """One table that a file holds. ``values`` (k,): what it adds to ``output``, weighted, at
    ``positions`` (k,) of ``input``.

    ``directions``: in which it acts. ``period``: the table repeats. ``active``: no file switches it
    off.
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
class OddTable:
    """A table that cannot be read as a curve, and why. ``largest``: its largest amount, weighted,
    mm or deg, 0 where it is off.
    """

    index: int
    input: str
    output: str
    why: str
    largest: float


@dataclass(frozen=True, slots=True)
class Cec:
    """Everything that the files say about such tables. ``reserved``: points by index; ``max_sum``:
    by output axis, mm or deg.

    ``occupied``: input and output axis by index, of tables that are left out of ``tables`` too.
    ``odd``: those that act, or may act, and cannot be read. ``prints``: by index eight characters
    that change with what the files say of a table.
    """

    tables: tuple[CecTable, ...] = ()
    odd: tuple[OddTable, ...] = ()
    occupied: Mapping[int, Pair] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
    max_sum: Mapping[str, float] = field(default_factory=dict)
    prints: Mapping[int, str] = field(default_factory=dict)

    def untold(self, address: str, *, sign_known: bool) -> str:
        """Return the tables from other axes that act on one and cannot be counted with, in words
        that change with their values.
        """
        acting: list[CecTable | OddTable] = [table for table in self.odd if table.largest]
        acting += (
            []
            if sign_known
            else [table for table in self.tables if table.active and table.values.any()]
        )
        mine = sorted(
            (table for table in acting if table.output == address != table.input),
            key=lambda table: table.index,
        )
        return ", ".join(
            f"CEC table {table.index} over {table.input} ({self.prints[table.index]})"
            for table in mine
        )

    def own_axes(self) -> list[str]:
        """Return the axes with tables over themselves, switched on or not."""
        return list(
            dict.fromkeys(table.output for table in self.tables if table.input == table.output)
        )

    def acting(self, pair: Pair) -> list[CecTable]:
        """Return the tables that act on a pair of axes."""
        return [table for table in self.tables if table.pair == pair and table.active]

    def facts(self, address: str) -> dict[str, str | float]:
        """Return what writing has to know, for the facts of a state."""
        facts: dict[str, str | float] = {}
        if self.occupied:
            facts[CEC_TABLES] = ", ".join(
                f"{index} {base} {corrected}" for index, (base, corrected) in self.occupied.items()
            )
        if self.reserved:
            facts[CEC_RESERVED] = ", ".join(
                f"{index} {points}" for index, points in self.reserved.items()
            )
        if address in self.max_sum:
            facts[CEC_MAX_SUM] = self.max_sum[address]
        acting = sum(table.largest for table in self.odd if table.output == address)
        if acting:
            facts[CEC_ODD_SUM] = acting
        own = {table.directions: table.index for table in self.acting((address, address))}
        if set(own) == {(Direction.POSITIVE,), (Direction.NEGATIVE,)}:
            facts[CEC_PAIR] = f"{own[(Direction.POSITIVE,)]} {own[(Direction.NEGATIVE,)]}"
        return facts


def as_table(definition: Definition) -> Definition:
    """Return the definition as if its tables between axes were tables on one axis: the same file,
    read by the same code.
    """
    bindings = {
        name: replace(definition.bindings[cross], quantity=name) for cross, name in AS_TABLE.items()
    }
    return replace(definition, bindings={**definition.bindings, **bindings})


def _whole(places: Mapping[str, Sequence[Found]]) -> bool:
    """Return whether a table was not cut short: it has all of its single values, and its points
    without a gap.
    """
    points = {int(row.occurrence.tokens["index"].text) for row in places.get("cross_value", ())}
    return all(name in places for name in _NEEDED) and points == set(range(len(points)))


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
    """Return whether a table holds nothing but zeros, values and grid: the control's own default,
    which means no table.
    """
    numbers = [place.text for name in AS_TABLE for place in places.get(name, ())]
    return bool(numbers) and all(Decimal(number) == 0 for number in numbers)


def is_zero(places: Mapping[str, Sequence[Found]]) -> bool:
    """Return whether every value of a table is zero: whatever its grid and its axes, it corrects
    nothing.
    """
    return all(Decimal(row.text) == 0 for row in places.get("cross_value", ()))


def _print(places: Mapping[str, Sequence[Found]]) -> str:
    """Return eight characters that change with a table's values, grid, axes, direction and
    weight.
    """
    said = [
        f"{name} {found.occurrence.tokens.get('index', found).text} {found.text}"
        for name in (*DATA, "cross_weight")
        for found in places.get(name, ())
    ]
    return hashlib.sha256("\n".join(said).encode("utf-8", "surrogatepass")).hexdigest()[:8]


def read_cec(
    gathered: Gathered,
    options: Mapping[str, object],
    notes: Notes,
    wanted: Mapping[str, Axis | None] | None = None,
    activity: Activity = Activity(),  # noqa: B008 - frozen
) -> Cec:
    """Return the tables between axes; what is wrong with them goes to ``notes``.

    ``wanted``: the axes that are asked for (none: all). A table that cannot be read as a curve (its
    range no multiple of its step, an output that is no machine axis, a key that is not known, a
    product with another table) is a fault where it acts on one of them over itself; elsewhere it is
    left alone and named.
    """
    if not has_cross(gathered.definition):
        return Cec()
    reader = _CecReader(gathered, options, notes, wanted or {}, activity)
    places = places_of(gathered)
    tables = [reader.table(index, places[index]) for index in sorted(places)]
    reader.name_quiet()
    return Cec(
        tables=tuple(table for table in tables if table is not None),
        odd=tuple(reader.odd),
        occupied=reader.occupied,
        reserved={
            index: int(found.text)
            for index in sorted(places)
            if (found := reader.one("cross_max_points", places[index], f"CEC table {index}"))
            is not None
        },
        max_sum=reader.max_sums(),
        prints={index: _print(found) for index, found in places.items()},
    )


class _CecReader:
    def __init__(
        self,
        gathered: Gathered,
        options: Mapping[str, object],
        notes: Notes,
        wanted: Mapping[str, Axis | None],
        activity: Activity,
    ) -> None:
        self.gathered = gathered
        self.definition = gathered.definition
        self.notes = notes
        self.wanted = wanted
        self.activity = activity
        self.scale = Scale(as_table(self.definition), AxisKind.LINEAR, with_some_sign(options), {})
        self.occupied: dict[int, Pair] = {}
        self.odd: list[OddTable] = []
        self.quiet: list[int] = []

    def one(self, quantity: str, places: Mapping[str, Sequence[Found]], label: str) -> Found | None:
        """Return the value that counts."""
        return self._values(label).one(quantity, places.get(quantity, ()))

    def _values(self, label: str) -> Values:
        return Values(self.definition, label, self.notes)

    def table(self, index: int, places: Mapping[str, Sequence[Found]]) -> CecTable | None:
        """Return one table; None without one, when something is wrong with it, and when it is left
        alone.
        """
        if not any(name in places for name in DATA) or is_unused(places):
            return None
        label = f"CEC table {index}"
        outer, self.notes = self.notes, Notes()
        try:
            table = self._curve(index, places, label)
            found = self.notes
        finally:
            self.notes = outer
        if not found.faults:
            outer.take(found)
            return table
        damaged = any("contradicts" in fault.message for fault in found.faults)
        if is_zero(places) and "cross_value" in places and _whole(places) and not damaged:
            self.occupied[index] = self._names(places)
            self.quiet.append(index)
            return None
        self._leave_alone(index, places, label, found.faults)
        return None

    def name_quiet(self) -> None:
        """Name the tables that hold nothing but zeros on a grid that cannot be read."""
        if self.quiet:
            named = ", ".join(map(str, self.quiet))
            message = (
                f"CEC tables {named} are left alone: all their values are 0, on a grid that cannot"
                " be read; they correct nothing"
            )
            self.notes.find("CW-S054", "info", message)

    def _leave_alone(
        self, index: int, places: Mapping[str, Sequence[Found]], label: str, faults: Sequence[Fault]
    ) -> None:
        """Keep a table that cannot be read where the work does not touch it; else its faults are
        those of the files.
        """
        pair = self._names(places)
        self.occupied[index] = pair
        quiet = Notes()
        on = (
            self._word(
                label,
                "cross_table_enabled",
                self._last("cross_table_enabled", places),
                tell=False,
                notes=quiet,
            )
            == "yes"
        )
        axis_on = self._word(
            pair[1],
            "cross_axis_enabled",
            self._of_axis("cross_axis_enabled", pair[1]),
            tell=False,
            notes=quiet,
        )
        acts = on and axis_on == "yes"
        weight = self._last("cross_weight", places)
        factor = abs(float(weight.text)) if weight is not None else 1.0
        amounts = [abs(float(row.text)) for row in places.get("cross_value", ())]
        largest = factor * max(amounts, default=0.0) if acts else 0.0
        product = any("MULT_BY_TABLE" in fault.message for fault in faults)
        damaged = (
            "cross_value" not in places
            or not _whole(places)
            or any("contradicts" in fault.message for fault in faults)
        )
        touched = (
            [address for address in self.wanted if self._touches(pair, address)]
            if self.wanted
            else [pair[1]]
        )
        if damaged or (acts and touched and (product or self._same(pair))):
            self.notes.faults.extend(fault for fault in faults if fault not in self.notes.faults)
            return
        why = faults[0].message.removeprefix(f"{label}: ")
        self.odd.append(OddTable(index, *pair, why, largest))
        state = (
            "it is switched off"
            if not acts
            else f"it acts on {pair[1]} over {pair[0]}, the same before and after"
        )
        severity = "warning" if acts and touched else "info"
        self.notes.find(
            "CW-S011" if product else "CW-S050",
            severity,
            f"{label} ({pair[0]} on {pair[1]}) is left alone: {why}; {state}",
        )

    def _names(self, places: Mapping[str, Sequence[Found]]) -> Pair:
        both = [self._last(name, places) for name in ("cross_input", "cross_output")]
        base, corrected = (
            self.gathered.axis(found.text) if found is not None else "" for found in both
        )
        return base, corrected

    def _last(self, quantity: str, places: Mapping[str, Sequence[Found]]) -> Found | None:
        found = places.get(quantity, ())
        return found[-1] if found else None

    def _of_axis(self, quantity: str, address: str) -> Found | None:
        return self._last(quantity, self.gathered.singles.get((address, None), {}))

    def _same(self, pair: Pair) -> bool:
        return pair[0] == pair[1]

    def _touches(self, pair: Pair, address: str) -> bool:
        """Return whether a table corrects an axis; a name that is no machine axis may be another
        name of the axis of its letter.
        """
        if pair[1] == address:
            return True
        if pair[1] and self.gathered.names.known(pair[1]) and self.gathered.names.places:
            return False
        axis = self.wanted.get(address)
        letters = {
            name.upper().rstrip("0123456789")
            for name in (address, axis.name if axis is not None else address)
        }
        return pair[1].rstrip("0123456789") in letters - {"AX"}

    def _check_axes(self, label: str, said: Mapping[str, Found]) -> None:
        for name in ("cross_input", "cross_output"):
            if not self.gathered.names.known(self.gathered.axis(said[name].text)):
                self._fault(
                    label,
                    f"{self._values(label).name(name)} is no machine axis",
                    said[name],
                    expected="a name of MD10000, or AX1 and so on",
                )

    def _unknown_keys(self, label: str, places: Mapping[str, Sequence[Found]]) -> None:
        for found in places.get("cross_other", ()):
            key = found.occurrence.tokens["key"].text
            self._fault(
                label,
                f"$AN_CEC_{key} cannot be read: no such key is known",
                found,
                expected="a key that is known",
            )

    def _curve(
        self, index: int, places: Mapping[str, Sequence[Found]], label: str
    ) -> CecTable | None:
        """Return one table as a curve; what keeps it from being one goes to the notes."""
        known = len(self.notes.faults)
        singles = {name: self.one(name, places, label) for name in DATA if name != "cross_value"}
        self._unknown_keys(label, places)
        if any(name not in places for name in _NEEDED) or any(
            "contradicts" in fault.message for fault in self.notes.faults
        ):
            known = -1
        for name in _NEEDED:
            if name not in places:
                self._fault(
                    label,
                    f"{self._values(label).name(name)} is missing",
                    next(iter(places.values()))[0],
                )
        said = {name: found for name, found in singles.items() if found is not None}
        if known < 0:
            return None
        self._check_axes(label, said)
        given = self._names(places)
        self.occupied[index] = given
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
        active = self._active(label, places, given)
        if active and not self._simple(label, said.get("cross_multiplier")):
            return None
        self._check_reserved(label, places, table)
        weight = self.one("cross_weight", places, label)
        values = table.positive if weight is None else float(weight.text) * table.positive + 0.0
        repeats = (
            self._word(label, "cross_repeats", said.get("cross_repeats"), tell=active) == "yes"
        )
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

    def _active(self, label: str, places: Mapping[str, Sequence[Found]], pair: Pair) -> bool:
        """Return whether no file switches the table off, itself or the sum on its output axis; inch
        data are not read.
        """
        output = pair[1]
        on_axis = self.gathered.singles.get((output, None), {})
        words, ends = [], []
        for quantity, where in (("cross_table_enabled", places), ("cross_axis_enabled", on_axis)):
            owner = label if where is places else f"axis {output}"
            found = self.one(quantity, where, owner)
            words.append(None if found is None else self._word(owner, quantity, found))
            ends.append(found)
        word = "no" if "no" in words else None if None in words else "yes"
        acts: bool | None = None
        if self._same(pair) and output in self.wanted and not is_zero(places):
            switches = "SD41300 $SN_CEC_TABLE_ENABLE, MD32710 $MA_CEC_ENABLE"
            place = next(
                (
                    found
                    for found, said in zip(ends, words, strict=True)
                    if said == word and found is not None
                ),
                None,
            )
            owner, screw = f"{label} of axis {output}", self._leadscrew(output)
            dumped = place is not None and place.number not in {
                row.number for row in places["cross_value"]
            }
            acts = self.activity.beside_leadscrew(
                owner, switches, screw, word, place, self.notes, dumped=dumped
            )
            if acts is None:
                acts = self.activity.settle(owner, switches, word, place, self.notes)
            else:
                self.notes.find(
                    "CW-S034",
                    "warning",
                    f"{owner} is switched off in the files ({switches}); it corrects nothing",
                )
        if acts is None:
            for quantity, said in zip(
                ("cross_table_enabled", "cross_axis_enabled"), words, strict=True
            ):
                if said == "no":
                    name = self._values(label).name(quantity)
                    message = f"{label} is switched off in the files ({name}); it corrects nothing"
                    self.notes.find("CW-S034", "info", message)
                    return False
            for quantity, said, owner in zip(
                ("cross_table_enabled", "cross_axis_enabled"),
                words,
                (label, f"axis {output}"),
                strict=True,
            ):
                if said is None:
                    self._word(owner, quantity, None)
            acts = True
        metric = self.one("cross_metric", on_axis, f"axis {output}")
        if (
            acts
            and metric is not None
            and self._word(f"axis {output}", "cross_metric", metric) == "no"
        ):
            self._fault(
                f"axis {output}",
                "corrections between axes in inch are not read (MD32711)",
                metric,
                expected="1: metric",
            )
        return acts

    def _leadscrew(self, address: str) -> Leadscrew:
        """Return what the files say of the leadscrew tables of an axis."""
        fields = [self.definition.bindings[quantity].field for quantity in curves(self.definition)]
        tables = {
            system: rows
            for (owner, system), rows in self.gathered.rows.items()
            if owner == address and system
        }
        on = {system: self._switch_of(address, system) for system in tables}
        written = {
            on[system]
            for system, rows in tables.items()
            if any(
                Decimal(row.occurrence.tokens[name].text) != 0 for row in rows for name in fields
            )
        }
        return Leadscrew(
            "yes" in on.values(),
            next((word for word in ("yes", "unsaid", "no") if word in written), ""),
        )

    def _switch_of(self, address: str, system: str) -> str:
        found = self._last("enabled", self.gathered.singles.get((address, system), {}))
        binding = self.definition.bindings.get("enabled")
        if found is None or not isinstance(binding, Choice):
            return "unsaid"
        return "no" if binding.values.get(found.text) == "no" else "yes"

    def _simple(self, label: str, multiplier: Found | None) -> bool:
        """Return whether the table is not multiplied by another one."""
        if multiplier is None or int(multiplier.text) == 0:
            return True
        other = (
            f"it is multiplied by table {int(multiplier.text) - 1} (MULT_BY_TABLE), which is not a"
            " curve over one axis"
        )
        self._fault(label, other, multiplier, expected="0: not multiplied")
        return False

    def _check_reserved(
        self, label: str, places: Mapping[str, Sequence[Found]], table: Table
    ) -> None:
        reserved = self.one("cross_max_points", places, label)
        if reserved is not None and 0 < int(reserved.text) < table.positions.size:
            self._fault(
                label,
                "the control has not reserved so many points",
                reserved,
                found=str(table.positions.size),
            )

    def _word(
        self,
        label: str,
        quantity: str,
        found: Found | None,
        *,
        tell: bool = True,
        notes: Notes | None = None,
    ) -> str | None:
        """Return the neutral word of a choice, or what counts when it is absent, which is
        listed.
        """
        values = self._values(label)
        if found is None:
            return values.absent(quantity, tell=tell)
        binding = self.definition.choice(quantity)
        word = values.known_word(binding, found.text)
        if word is None and notes is None:
            self._fault(
                label,
                f"{values.name(quantity)} has a value that is not known",
                found,
                expected=" or ".join(binding.values),
            )
        return word

    def max_sums(self) -> dict[str, float]:
        """Return the limit of the sum by output axis."""
        sums: dict[str, float] = {}
        for (address, _), places in self.gathered.singles.items():
            if (
                address is not None
                and (found := self.one("cross_max_sum", places, f"axis {address}")) is not None
            ):
                sums[address] = float(found.text)
                if not sums[address] >= 0:
                    self._fault(f"axis {address}", "a limit below 0", found, expected="0 or more")
        return sums

    def _fault(
        self,
        label: str,
        message: str,
        place: Found,
        *,
        expected: str = "",
        found: str | None = None,
    ) -> None:
        fault = Fault(
            message=f"{label}: {message}",
            file=place.occurrence.file,
            place=place.occurrence.place,
            expected=expected,
            found=place.text if found is None else found,
        )
        if fault not in self.notes.faults:
            self.notes.faults.append(fault)


def sign_question(address: str, tables: Sequence[CecTable]) -> Fault:
    """Return what is asked where tables of an axis over itself stand in its readings, and nobody
    said what their values are.
    """
    named = " and ".join(str(table.index) for table in tables)
    return Fault(
        message=(
            f"axis {address}: CEC table {named} corrects the axis over itself, and no manual says"
            f" in which direction a positive value moves it. {SIGN_CHECK}"
        ),
        place="option cec_sign",
        expected="cec_sign: correction or cec_sign: error",
        found="not given",
    )


def with_some_sign(options: Mapping[str, object]) -> Mapping[str, object]:
    """Return options with which the structure of tables can be read where their sign is not
    known.
    """
    return options if options.get("cec_sign") is not None else {**options, "cec_sign": "correction"}


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
    """Return the indices that may hold the tables of an axis over itself: its own ones first, then
    free ones, as allowed.
    """
    own = [index for index in allowed if in_use.get(index) == (address, address)]
    return [*own, *(index for index in dict.fromkeys(allowed) if index not in in_use)]


def allowed_tables(options: Mapping[str, object]) -> tuple[int, ...]:
    """Return the option ``cec_tables``. Raises UsageError when it holds something else than
    indices.
    """
    given = options.get("cec_tables", ())
    if not isinstance(given, (tuple, list)) or not all(isinstance(index, int) for index in given):
        raise UsageError(
            Fault(
                message="the option has a wrong value",
                place="cec_tables",
                expected="indices",
                found=repr(given),
            )
        )
    return tuple(dict.fromkeys(int(index) for index in given))
