"""Tables between axes (CEC) -> the control's files: pairs of an axis over itself, squareness and
straightness.

Only indices that the option ``cec_tables`` allows are written, and of these only free ones or an
axis' own pair: tables of the machine's builder stay as they are.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.definition.options import resolve_options
from compwright.formats.definition.schema import Choice, Definition, When
from compwright.formats.definition.statements import print_form
from compwright.formats.families.axis_names import gathered_files
from compwright.formats.families.grid.tables import write_table
from compwright.formats.families.pairs.capacity import cec_available, too_few
from compwright.formats.families.pairs.reading import (
    AS_TABLE,
    CEC_MAX_SUM,
    CEC_ODD_SUM,
    DATA,
    SIGN_CHECK,
    Pair,
    allowed_tables,
    as_table,
    free_tables,
    is_unused,
    is_zero,
    places_of,
    reserved_in,
    tables_in,
)
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.gathering import Found, same_value
from compwright.formats.text.own_files import OwnFiles, TablePlaces, rows_by_index
from compwright.formats.text.patching import fresh_file
from compwright.formats.text.scale import Scale
from compwright.formats.text.texts import BY_HAND
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)

_BACK = {name: cross for cross, name in AS_TABLE.items()}
_DIRECTIONS = {None: "0", Direction.POSITIVE: "1", Direction.NEGATIVE: "-1"}


@dataclass(frozen=True, slots=True)
class Entry:
    """What one table will hold, as text: values by point, single values by quantity."""

    index: int
    rows: tuple[str, ...]
    singles: Mapping[str, str]


class CecWriter:
    """Puts tables into the control's own files where they have a place there, and keeps the others
    for new files.
    """

    def __init__(
        self,
        definition: Definition,
        options: Mapping[str, object],
        own: OwnFiles | None,
        state: ControlState | None,
    ) -> None:
        self.definition = definition
        self.options = options
        self.own = own
        self.facts = state.facts if state is not None else {}
        self.cross = state.cross if state is not None else ()
        self.allowed: tuple[int, ...] = ()
        self.allow(options)
        self.places = places_of(own.gathered) if own is not None else {}
        self.in_use: dict[int, Pair] = self._used() if own is not None else tables_in(self.facts)
        self.kept: set[int] = set()

    def allow(self, options: Mapping[str, object]) -> None:
        """Take the indices that may be written from the options, which an axis may have of its
        own.
        """
        self.allowed = allowed_tables(options) if "cec_tables" in self.definition.options else ()

    def _used(self) -> dict[int, Pair]:
        """Return input and output axis of every table that the files hold."""
        used = {}
        for index, places in self.places.items():
            if any(name in places for name in DATA) and not is_unused(places):
                pair = (self._axis_in(places, "cross_input"), self._axis_in(places, "cross_output"))
                used[index] = pair
        return used

    def _axis_in(self, places: Mapping[str, Sequence[Found]], quantity: str) -> str:
        found = places.get(quantity, ())
        return self._axis(found[-1].text) if found else ""

    def _axis(self, name: str) -> str:
        """Return the one name of an axis."""
        return (
            normal_text(self.definition, name) if self.own is None else self.own.gathered.axis(name)
        )

    def _sign_known(self, label: str) -> None:
        """Without the sign nothing is written: one of the two answers doubles the error. Raises
        UsageError.
        """
        if self.options.get("cec_sign") is None and "cec_sign" in self.definition.options:
            raise UsageError(
                Fault(
                    message=(
                        f"{label}: a CEC table is to be written, and no manual says in which"
                        f" direction a positive value moves the axis. {SIGN_CHECK}"
                    ),
                    place="option cec_sign",
                    expected="cec_sign: correction or cec_sign: error",
                    found="not given",
                )
            )

    def own_pair(
        self, address: str, axis: Axis, compensation: AxisCompensation, faults: list[Fault]
    ) -> list[Entry]:
        """Put the two tables of an axis over itself; return those that have no place in the files.

        Raises UsageError where nobody said what a value means.
        """
        indices = [
            index
            for index in free_tables(self.allowed, self.in_use, address)
            if index not in self.kept
        ]
        indices = self._by_direction(indices)[:2]
        if len(indices) < 2:
            faults.append(too_few(axis.name, self.definition.id, 2, len(indices), self.allowed))
            return []
        self._sign_known(f"axis {axis.name}")
        entries = []
        for index, direction in zip(indices, Direction, strict=True):
            curve = compensation.curve(direction)
            one = replace(compensation, positive=curve, negative=curve)
            entries.append(
                self._entry(index, (address, address), direction, one, axis.kind, faults)
            )
        return self._put(entries, (address, address), faults)

    def _by_direction(self, indices: list[int]) -> list[int]:
        """Return the indices so that a table that holds the + direction keeps it, and likewise the
        - direction.
        """

        def holds(index: int, text: str) -> bool:
            return any(
                same_value(place.text, text)
                for place in self.places.get(index, {}).get("cross_direction", ())
            )

        first = next((index for index in indices if holds(index, "1")), None)
        if first is None:
            second = next((index for index in indices if holds(index, "-1")), None)
            rest = [index for index in indices if index != second]
            return indices if second is None or not rest else [rest[0], second, *rest[1:]]
        return [first, *(index for index in indices if index != first)]

    def empty_own(self, address: str, name: str, faults: list[Fault]) -> None:
        """Set the values of an axis' old tables over itself to zero, as far as they act and are not
        used again.
        """
        for index, pair in self.in_use.items():
            if (
                pair != (address, address)
                or index in self.kept
                or self._quiet(index)
                or self._off(index, pair[1])
            ):
                continue
            if self.own is None or index not in self.allowed:
                faults.append(
                    Fault(
                        message=(
                            f"axis {name}: CEC table {index} corrects the axis over itself and"
                            " would act beside the new table"
                        ),
                        place="option cec_tables",
                        expected=(
                            f"{index} among the indices, and the control's own files, so that it"
                            " can be emptied"
                        ),
                        found=", ".join(map(str, self.allowed)) or "no indices",
                    )
                )
                continue
            self._protected(index, address, faults)
            self.own.clear_rows(self._table_places(index))

    def _quiet(self, index: int) -> bool:
        """Whether the files hold nothing but zeros in a table."""
        return index in self.places and is_zero(self.places[index])

    def _off(self, index: int, output: str, *, itself: bool = False) -> bool:
        """Whether the files end with a table switched off: ``itself`` by SD41300, else also by
        MD32710 of its output axis.
        """
        ends = [self.places.get(index, {}).get("cross_table_enabled", ())]
        if not itself and self.own is not None:
            ends.append(
                self.own.gathered.singles.get((output, None), {}).get("cross_axis_enabled", ())
            )
        return any(places and same_value(places[-1].text, "0") for places in ends)

    def between(self, entry: CrossCompensation, faults: list[Fault]) -> list[Entry]:
        """Put the table, or the two tables, by which one axis corrects another; return those
        without a place in the files.
        """
        pair = self._axis(entry.input), self._axis(entry.output)
        both = np.array_equal(entry.positive, entry.negative)
        directions: tuple[Direction | None, ...] = (None,) if both else tuple(Direction)
        free = [
            index for index in self.allowed if index not in self.in_use and index not in self.kept
        ]
        if len(free) < len(directions):
            faults.append(
                too_few(
                    f"{pair[0]} on {pair[1]}",
                    self.definition.id,
                    len(directions),
                    len(free),
                    self.allowed,
                )
            )
            return []
        self._sign_known(f"{entry.output} over {entry.input}")
        entries = []
        for index, direction in zip(free, directions, strict=False):
            curve = entry.positive if direction is not Direction.NEGATIVE else entry.negative
            one = AxisCompensation(
                address=pair[1],
                kind=entry.input_kind,
                positions=entry.positions,
                positive=curve,
                negative=curve,
                period=entry.period,
            )
            entries.append(self._entry(index, pair, direction, one, entry.input_kind, faults))
        return self._put(entries, pair, faults)

    def _entry(
        self,
        index: int,
        pair: Pair,
        direction: Direction | None,
        curve: AxisCompensation,
        kind: AxisKind,
        faults: list[Fault],
    ) -> Entry:
        self.kept.add(index)
        view = as_table(self.definition)
        table = write_table(view, curve, Scale(view, kind, self.options, {}), faults)
        field = self.definition.bindings["cross_value"].field
        singles = {
            "cross_input": self._spelling(pair[0]),
            "cross_output": self._spelling(pair[1]),
            **{_BACK[name]: text for name, text in table.singles.items()},
            "cross_direction": _DIRECTIONS[direction],
            "cross_multiplier": "0",
            "cross_repeats": word_text(
                self.definition, "cross_repeats", "no" if curve.period is None else "yes"
            ),
        }
        self._reserve(index, len(table.rows), faults)
        return Entry(index, tuple(row[field] for row in table.rows), singles)

    def _reserve(self, index: int, count: int, faults: list[Fault]) -> None:
        """Reserve the points of a table where the files say fewer than it has: what the option
        promises, or as many as it has where none were reserved; files that say less would take the
        room away again when they are loaded.
        """
        promised = self.options.get("points")
        reserved = reserved_in(self.facts).get(index, 0)
        if 0 < reserved < count and not (isinstance(promised, int) and promised >= count):
            message = f"CEC table {index} needs more points than MD18342 reserves"
            faults.append(Fault(message=message, expected=f"at most {reserved}", found=str(count)))
            return
        places = self.places.get(index, {}).get("cross_max_points", ())
        if self.own is not None and any(int(place.text) < count for place in places):
            self.own.put(
                "cross_max_points", places, str(promised if isinstance(promised, int) else count)
            )

    def _put(self, entries: Iterable[Entry], pair: Pair, faults: list[Fault]) -> list[Entry]:
        left = []
        for entry in entries:
            places = self._table_places(entry.index)
            held = bool(places.rows) or any(places.singles.get(name) for name in DATA)
            if self.own is None or not held:  # a switch alone is no place for a table
                left.append(entry)
            else:
                self._protected(entry.index, pair[1], faults)
                self.own.put_table(places, entry.rows, self._spelled(entry, places))
            self._switch_on(entry.index)
        self._switch_on_sum(pair[1], faults)
        return left

    def _protected(self, index: int, output: str, faults: list[Fault]) -> None:
        """Refuse a file that has a table switched on before its values: the control would take none
        of them when it is loaded.
        """
        on_axis = self.own.gathered.singles.get((output, None), {}) if self.own is not None else {}
        first: dict[int, int] = {}
        for row in self.places[index].get("cross_value", ()):
            first[row.number] = min(first.get(row.number, row.occurrence.line), row.occurrence.line)
        for switches in (
            self.places[index].get("cross_table_enabled", ()),
            on_axis.get("cross_axis_enabled", ()),
        ):
            for number, line in first.items():
                mine = [switch for switch in switches if switch.number == number]
                before = [switch for switch in mine if switch.occurrence.line < line]
                if not before or (before[-1] is not mine[-1] and same_value(before[-1].text, "0")):
                    continue
                fault = Fault(
                    message=(
                        f"CEC table {index}: its switch (SD41300, MD32710) stands in this file"
                        " before its values; switched on there, they would be protected, and the"
                        " control would take none of them"
                    ),
                    file=before[-1].occurrence.file,
                    place=before[-1].occurrence.place,
                    expected=(
                        "the values before the switch, or in a file of their own, as the control"
                        " exports them (NC_CEC.INI)"
                    ),
                    found=f"the first value in line {line}",
                )
                faults.append(fault)

    def _table_places(self, index: int) -> TablePlaces:
        places = self.places.get(index, {})
        return TablePlaces(
            rows_by_index(places.get("cross_value", ())),
            {name: places[name] for name in DATA if name in places and name != "cross_value"},
            "cross_value",
            {"table": str(index)},
        )

    def _spelled(self, entry: Entry, places: TablePlaces) -> dict[str, str]:
        """Return the single values; an axis that the file names already keeps its spelling."""
        singles = dict(entry.singles)
        for name in ("cross_input", "cross_output"):
            for place in places.singles.get(name, ()):
                if self._axis(place.text) == self._axis(singles[name]):
                    singles[name] = place.text
        return singles

    def _spelling(self, address: str) -> str:
        return address if self.own is None else self.own.gathered.spelled(address)

    def _switch_on(self, index: int) -> None:
        """Make a table act with its own values where the files say otherwise: it is ours."""
        if self.own is not None:
            for quantity in ("cross_table_enabled", "cross_weight"):
                self.own.put(quantity, self.places.get(index, {}).get(quantity, ()), "1")

    def _switch_on_sum(self, output: str, faults: list[Fault]) -> None:
        """Switch the sum on an axis on where the files switch it off, unless that would wake tables
        that are not ours.

        Where no file says whether it is on, somebody will switch it on by hand: the same tables
        must not sleep there either.
        """
        if self.own is None:
            return
        on_axis = self.own.gathered.singles.get((output, None), {})
        self._check_shared(output, on_axis, faults)
        places = on_axis.get("cross_axis_enabled", ())
        if places and not same_value(places[-1].text, "0"):
            return
        others = [index for index in self.places if self._may_wake(index, output)]
        if not places:
            self._check_unsaid(
                output,
                [index for index in others if self.in_use[index] != (output, output)],
                faults,
            )
        elif others:
            faults.append(
                Fault(
                    message=(
                        f"axis {output}: its CEC tables are switched off together (MD32710"
                        " $MA_CEC_ENABLE); switching them on would wake others too:"
                        f" {', '.join(map(str, others))}"
                    ),
                    file=places[-1].occurrence.file,
                    place=places[-1].occurrence.place,
                    expected="1, or SD41300 = 0 for the other tables on this axis",
                    found="0",
                )
            )
        else:
            self.own.put("cross_axis_enabled", places, "1")

    def _check_unsaid(self, output: str, others: Sequence[int], faults: list[Fault]) -> None:
        if not others:
            return
        place = next(found for found in self.places[others[0]]["cross_output"])
        faults.append(
            Fault(
                message=(
                    f"axis {output}: no file says whether its CEC tables are on (MD32710"
                    " $MA_CEC_ENABLE); if they are off, switching ours on would wake others too:"
                    f" {', '.join(map(str, others))}"
                ),
                file=place.occurrence.file,
                place=place.occurrence.place,
                expected=(
                    f"MD32710 of {output} among the files, or SD41300 = 0 for the other tables on"
                    " this axis"
                ),
                found="in no file",
            )
        )

    def _may_wake(self, index: int, output: str) -> bool:
        """Whether a table that is not ours begins to correct ``output`` when MD32710 is switched
        on.
        """
        if (
            index in self.kept
            or index not in self.in_use
            or self._quiet(index)
            or self._off(index, output, itself=True)
        ):
            return False
        corrected = self.in_use[index][1]
        names = self.own.gathered.names if self.own is not None else None
        return corrected == output or (
            names is not None and bool(names.places) and not names.known(corrected)
        )

    def _check_shared(
        self, output: str, on_axis: Mapping[str, Sequence[Found]], faults: list[Fault]
    ) -> None:
        """Other tables must not be multiplied by ours, and the axis must take values in mm."""
        faults.extend(
            Fault(
                message=(
                    f"CEC table {index} is multiplied by table {int(place.text) - 1}"
                    " ($AN_CEC_MULT_BY_TABLE), to be written"
                ),
                file=place.occurrence.file,
                place=place.occurrence.place,
                expected="other indices in the option cec_tables",
                found=place.text,
            )
            for index, places in self.places.items()
            for place in places.get("cross_multiplier", ())[-1:]
            if index not in self.kept
            and int(place.text) - 1 in self.kept
            and not self._quiet(index)
        )
        faults.extend(
            Fault(
                message=(
                    f"axis {output}: its CEC values are in inch (MD32711), which is not written"
                ),
                file=place.occurrence.file,
                place=place.occurrence.place,
                expected="1: metric",
                found=place.text,
            )
            for place in on_axis.get("cross_metric", ())[-1:]
            if same_value(place.text, "0")
        )

    def new_file(self, when: When, address: str, entries: Sequence[Entry]) -> ControlFile:
        """Return the definition's file for tables that no file of the control holds."""
        file = next(
            file for file in self.definition.writing if file.when == when and file.rows is not None
        )
        named = {"axis": address, "system": "0"}
        lines: list[str] = []
        for entry in entries:
            for index, text in enumerate(entry.rows):
                lines.append(self._line("cross_value", entry.index, text, index=str(index)))
            lines += [
                self._line(quantity, entry.index, text) for quantity, text in entry.singles.items()
            ]
        if when == "cross":  # no file of the set holds their switches
            lines += [f"{self._comment()}{BY_HAND}{line}" for line in self.switches(entries)]
        name = print_form(file.name, named)
        return fresh_file(self.definition, file, name, named, lines).patched([0])[0]

    def _comment(self) -> str:
        return next(
            kind.comment_marks[0] for kind in self.definition.texts.values() if kind.comment_marks
        )

    def switches(self, entries: Sequence[Entry]) -> list[str]:
        """Return the lines that switch new tables on where the control's own files say nothing of
        it: they come last.
        """
        on = word_text(self.definition, "cross_table_enabled", "yes")
        unsaid = [
            entry.index
            for entry in entries
            if not self.places.get(entry.index, {}).get("cross_table_enabled")
        ]
        return [self._line("cross_table_enabled", index, on) for index in unsaid]

    def _line(self, quantity: str, table: int, text: str, **more: str) -> str:
        binding = self.definition.bindings[quantity]
        return print_form(
            self.definition.statements[binding.statement].form,
            {"table": str(table), binding.field: text, **more},
        )

    def check_sum(self, entry: CrossCompensation) -> Fault | None:
        """Return the fault of a table with which the sum on its output axis would reach beyond
        CEC_MAX_SUM.
        """
        output = self._axis(entry.output)
        limit = self.facts.get(output, {}).get(CEC_MAX_SUM)
        if not isinstance(limit, (int, float)):
            return None
        acting = [other for other in self.cross if other.output == output]
        odd = self.facts[output].get(CEC_ODD_SUM, 0.0)
        reach = float(odd) if isinstance(odd, (int, float)) else 0.0
        reach += sum(
            float(np.max(np.abs([one.positive, one.negative]))) for one in (entry, *acting)
        )
        if reach <= limit:
            return None
        return Fault(
            message=(
                f"{entry.input} on {output}: all tables together would reach beyond CEC_MAX_SUM"
                " (MD32720)"
            ),
            expected=f"at most {limit:g}",
            found=f"up to {reach:g}",
        )


def word_text(definition: Definition, quantity: str, word: str) -> str:
    """Return how the control writes a word of a choice."""
    binding = definition.bindings[quantity]
    return (
        next(text for text, meant in binding.values.items() if meant == word)
        if isinstance(binding, Choice)
        else word
    )


def write_cross(
    definition: Definition,
    cross: Sequence[CrossCompensation],
    options: Mapping[str, object],
    state: ControlState | None = None,
    files: Sequence[ControlFile] = (),
) -> tuple[ControlFile, ...]:
    """Return the files that add ``cross`` to what the control does: those of ``files`` that change,
    and new ones.

    Each entry goes into free tables of its own (one for both directions, or one for each) beside
    whatever acts already; values are what is added to the output axis, mm or deg. Two points are a
    ramp. With tables of the same run, ``state`` and ``files`` are what `write_tables` returned, so
    that no index is taken twice. Raises UsageError for an axis over itself, CapacityError with
    everything that the control cannot hold, too few free indices in ``cec_tables`` among it.
    """
    resolved = resolve_options(definition, options, state)
    if not cec_available(definition, resolved):
        raise CapacityError(
            Fault(
                message=f"{definition.id} holds tables between axes only as an option",
                place="option cec",
                expected="available",
            )
        )
    raise_all(UsageError, [fault for entry in cross for fault in _wrong(entry)])
    crossed = [address for entry in cross for address in (entry.input, entry.output)]
    asked = list(dict.fromkeys((*(state.axes if state is not None else ()), *crossed)))
    own = OwnFiles(definition, files, gathered_files(definition, files, asked)) if files else None
    writer = CecWriter(definition, resolved, own, state)
    faults: list[Fault] = []
    left: dict[str, list[Entry]] = {}
    for entry in cross:
        unsound = [
            *_unsound(entry),
            *([fault] if (fault := writer.check_sum(entry)) is not None else []),
        ]
        faults.extend(unsound)
        if not unsound:
            left.setdefault(
                entry.output if own is None else own.gathered.axis(entry.output), []
            ).extend(writer.between(entry, faults))
    raise_all(CapacityError, list(dict.fromkeys(faults)))
    fresh = [
        writer.new_file("cross", output, entries) for output, entries in left.items() if entries
    ]
    return (*(own.patched(own.changed()) if own is not None else ()), *fresh)


def _wrong(entry: CrossCompensation) -> list[Fault]:
    if entry.input.casefold() != entry.output.casefold():
        return []
    return [
        Fault(
            message=(
                f"{entry.input}: the correction of an axis over itself is no table between axes"
            ),
            found=entry.output,
        )
    ]


def _unsound(entry: CrossCompensation) -> list[Fault]:
    label = f"{entry.input} on {entry.output}"
    sizes = {entry.positions.shape, entry.positive.shape, entry.negative.shape}
    if len(sizes) != 1 or entry.positions.ndim != 1 or entry.positions.size < 2:
        return [Fault(message=f"{label}: a table needs two points or more, with a value each")]
    numbers = np.concatenate([entry.positions, entry.positive, entry.negative])
    if not np.all(np.isfinite(numbers)) or np.any(np.diff(entry.positions) <= 0):
        return [Fault(message=f"{label}: the positions do not ascend, or a number is not finite")]
    curves = (entry.positive, entry.negative)
    faults = []
    if entry.period is not None:
        closed = abs(float(entry.positions[-1] - entry.positions[0]) - entry.period) <= 1e-6
        if not closed or any(curve[0] != curve[-1] for curve in curves):
            faults.append(
                Fault(
                    message=(
                        f"{label}: a table that repeats spans one period, with the same value at"
                        " both ends"
                    )
                )
            )
    for side, beyond, node in (("below", entry.below, 0), ("above", entry.above, -1)):
        if beyond != "hold" and any(curve[node] != 0 for curve in curves):
            faults.append(
                Fault(
                    message=f"{label}: {side} the table the control holds the end value",
                    expected="hold",
                    found=beyond,
                )
            )
    return faults
