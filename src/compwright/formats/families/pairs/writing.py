"""Write cross-axis tables (CEC) into the control's files.

Only table indices in the option ``cec_tables`` are written. Of these, three kinds are written:
unused ones, tables by which the axis already corrects itself, and tables of the same two axes as a
new correction between axes, which is added to them in place. All other tables stay as they are.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.formats.definition.statements import print_form
from compwright.formats.definition.vocabulary import When
from compwright.formats.families.family import Family
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.families.grid.tables import TableText, WrittenTable
from compwright.formats.families.grid.writing import AxisText, AxisToWrite, GridWriter
from compwright.formats.families.pairs.existing_tables import ExistingTables
from compwright.formats.families.pairs.options import (
    allowed_tables,
    free_tables,
    holds_two_curves,
    scale_of_pairs,
    sign_known,
    sign_question,
    too_few,
)
from compwright.formats.families.pairs.places import AS_TABLE, BETWEEN, Pair
from compwright.formats.families.pairs.switching import Switches
from compwright.formats.text.gathering import same_value
from compwright.formats.text.own_files import OwnFiles, TablePlaces
from compwright.formats.text.texts import BY_HAND
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Direction
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.words.sentences import control_text

_BACK = {name: cross for cross, name in AS_TABLE.items()}
_DIRECTIONS = {None: "0", Direction.POSITIVE: "1", Direction.NEGATIVE: "-1"}


@dataclass(frozen=True, slots=True)
class PairEntry:
    """The contents of one cross-axis table as text: values by point, and single values."""

    index: int
    rows: tuple[str, ...]
    singles: Mapping[str, str]


class CecWriter:
    """Writes tables into existing lines of the control's files, and into new files where none
    exist.
    """

    def __init__(self, control: Family, own: OwnFiles | None) -> None:
        self.control = control
        self.definition = control.definition
        self.own = own
        self.tables = ExistingTables(control, own)
        self.switches = Switches(self.tables)

    def trial(self) -> CecWriter:
        """Return a writer of the same tables, to find its faults; its changes are discarded."""
        own = self.own
        files = None if own is None else OwnFiles(self.definition, own.files, own.gathered)
        writer = CecWriter(self.control, files)
        writer.tables.kept = {*self.tables.kept}
        return writer

    def own_pair(self, work: AxisToWrite) -> list[PairEntry]:
        """Write an axis' two tables, one per direction; return the tables for which no file of the
        control has lines.

        Raises UsageError if it is not stated whether table values are corrections or errors.
        """
        address, name, faults = work.address, work.axis.name, work.faults
        free = free_tables(self.tables.allowed, self.tables.in_use, address)
        indices = self._by_direction([one for one in free if one not in self.tables.kept])[:2]
        if len(indices) < 2:
            faults.append(too_few(name, self.definition.id, 2, len(indices), self.tables.allowed))
            return []
        curves = []
        for direction in Direction:
            curve = work.compensation.curve(direction)
            one = replace(work.compensation, kind=work.axis.kind, positive=curve, negative=curve)
            curves.append((direction, one))
        return self.put(indices, (address, address), curves, f"axis {name}", faults)

    def put(
        self,
        indices: Sequence[int],
        pair: Pair,
        curves: Sequence[tuple[Direction | None, AxisCompensation]],
        label: str,
        faults: list[Fault],
    ) -> list[PairEntry]:
        """Write ``curves`` as the tables ``indices``, one per direction or one for both. ``pair``:
        input axis and output axis. Return the tables for which no file of the control has lines.

        Raises UsageError if it is not stated whether table values are corrections or errors: the
        wrong sign would double the error.
        """
        if not sign_known(self.control):
            raise UsageError(sign_question(f"{label}: a CEC table is to be written"))
        entries = [
            self._entry(index, pair, direction, curve, faults)
            for index, (direction, curve) in zip(indices, curves, strict=False)
        ]
        left = [entry for entry in entries if not self._placed(entry, pair, faults)]
        self.switches.sum_on(pair[1], faults)
        return left

    def _by_direction(self, indices: list[int]) -> list[int]:
        """Return table indices, the index of the table for + first; a table that has a direction in
        the files keeps this direction.
        """

        def holds(index: int, text: str) -> bool:
            places = self.tables.places_of(index, "cross_direction")
            return any(same_value(place.text, text) for place in places)

        first = next((index for index in indices if holds(index, "1")), None)
        if first is not None:
            return [first, *(index for index in indices if index != first)]
        second = next((index for index in indices if holds(index, "-1")), None)
        rest = [index for index in indices if index != second]
        return indices if second is None or not rest else [rest[0], second, *rest[1:]]

    def empty_own(self, work: AxisToWrite) -> None:
        """Set to zero the active tables by which an axis corrects itself, so that they do not add
        to the new table.
        """
        tables, address = self.tables, work.address
        for index, pair in tables.in_use.items():
            if pair != (address, address) or index in tables.kept:
                continue
            if tables.is_empty(index) or tables.off(index, address):
                continue
            if index in tables.stay and index not in tables.allowed:
                continue  # it stays: active in the test and afterwards alike
            if self.own is None or index not in tables.allowed:
                work.faults.append(
                    Fault(
                        message=(
                            f"axis {work.axis.name}: CEC table {index} already corrects "
                            "this axis over its own position, and would be active in "
                            "addition to the new table"
                        ),
                        place="option cec_tables",
                        expected=(
                            f"the index {index} in `cec_tables`, and the control's own "
                            "files, so that this table can be emptied"
                        ),
                        found=", ".join(map(str, tables.allowed)) or "no indices",
                        hint=(
                            f"add {index} to `cec_tables` in the options, and give the control's "
                            "own files (`states` or `--state`)"
                        ),
                    )
                )
                continue
            tables.check_protected(index, address, work.faults)
            work.faults.extend(tables.factors({index}))
            self.own.clear_rows(tables.table_places(index))

    def _entry(
        self,
        index: int,
        pair: Pair,
        direction: Direction | None,
        curve: AxisCompensation,
        faults: list[Fault],
    ) -> PairEntry:
        self.tables.kept.add(index)
        scale = scale_of_pairs(self.control, curve.kind)
        there = {
            name: places[-1].text
            for name, cross in _BACK.items()
            if name != "value" and (places := self.tables.places_of(index, cross))
        }
        table = shape_of(self.definition).write(TableText(curve, scale, faults, there))
        field = self.definition.bindings["cross_value"].field
        repeats = "no" if curve.period is None else "yes"
        singles = {
            "cross_input": self.tables.spelling(pair[0]),
            "cross_output": self.tables.spelling(pair[1]),
            **{_BACK[name]: text for name, text in table.singles.items()},
            "cross_direction": _DIRECTIONS[direction],
            "cross_multiplier": "0",
            "cross_repeats": self.definition.choice("cross_repeats").text(repeats),
        }
        self._reserve(index, len(table.rows), faults)
        return PairEntry(index, tuple(row[field] for row in table.rows), singles)

    def _reserve(self, index: int, count: int, faults: list[Fault]) -> None:
        """Reserve memory for a table's points if the files reserve too little.

        The option ``points`` states how many points to reserve. Without it, memory is reserved only
        if the files reserve none: for ``count`` points. A reservation that is too small is then a
        fault. The files must not keep a smaller number, because loading it would remove the memory
        again.

        An export of all machine data lists also the tables that have no points. A table behind the
        last one of such a list does not exist, and is a fault.
        """
        fixed = self.definition.limit_number("cross_points")
        if fixed is not None:
            if count > fixed:
                faults.append(
                    Fault(
                        message=control_text(
                            "CEC table {index} needs more points than a table can have",
                            index=str(index),
                        ),
                        expected=control_text("at most {value}", value=str(fixed)),
                        found=str(count),
                        hint=control_text("give a larger `spacing` under `table`"),
                    )
                )
            return
        promised, listed = self.control.options.get("points"), self.tables.reserved
        # A table of 0 points in the list: all tables are listed, not only those in use.
        if 0 in listed.values() and index > max(listed):
            faults.append(
                Fault(
                    message=control_text(
                        "the control's files have no MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) of"
                        " CEC table {index}, so the control does not have this table",
                        index=str(index),
                    ),
                    expected=control_text("indices from 0 to {last}", last=str(max(listed))),
                    found=str(index),
                    hint=control_text(
                        "give other indices in `cec_tables`; or, if the control has this table, add"
                        " the file with its MD18342 to the control's files"
                    ),
                )
            )
            return
        reserved = listed.get(index, 0)
        if 0 < reserved < count and not (isinstance(promised, int) and promised >= count):
            faults.append(
                Fault(
                    message=control_text(
                        "CEC table {index} needs more points than MD18342 reserves",
                        index=str(index),
                    ),
                    expected=control_text("at most {value}", value=str(reserved)),
                    found=str(count),
                    hint=control_text(
                        "raise MD18342 of this table in the control (this clears its memory), then"
                        " set `points` to {count} in the options; or give a larger spacing",
                        count=str(count),
                    ),
                )
            )
            return
        places = self.tables.places_of(index, "cross_max_points")
        if self.own is not None and any(int(place.text) < count for place in places):
            needed = promised if isinstance(promised, int) else count
            self.own.put("cross_max_points", places, str(needed))

    def _placed(self, entry: PairEntry, pair: Pair, faults: list[Fault]) -> bool:
        """Write a table into the control's own files; return whether they contain lines for it."""
        places = self.tables.table_places(entry.index)
        # a switch alone is no place for a table
        held = self.own is not None and places.anywhere
        if self.own is not None and held:
            self.tables.check_protected(entry.index, pair[1], faults)
            singles = self._spelled(entry, places)
            for name in BETWEEN:
                axis = self._line(name, entry.index, singles[name]).partition("=")[2]
                for found in self.tables.unnamed(entry.index, name):
                    self.own.put("cross_other", [found], axis)
                    if name not in places.singles:
                        singles.pop(name, None)
            self.own.put_table(places, entry.rows, singles)
        self.switches.table_on(entry.index)
        return held

    def _spelled(self, entry: PairEntry, places: TablePlaces) -> dict[str, str]:
        """Return a table's single values, in which axis names are spelled as in the file."""
        singles, axis = dict(entry.singles), self.tables.axis
        for name in BETWEEN:
            for place in places.singles.get(name, ()):
                if axis(place.text) == axis(singles[name]):
                    singles[name] = place.text
        return singles

    def new_file(self, when: When, address: str, entries: Sequence[PairEntry]) -> ControlFile:
        """Return a new file for tables that no file of the control contains, made from the
        definition's template for ``when``: cross-axis tables, or one table per direction.
        """
        file = next(
            file for file in self.definition.writing if file.when == when and file.rows is not None
        )
        named = {"axis": address, "system": "0"}
        newline = self.definition.dialect.newline
        lines = [print_form(line, named) for line in file.header]
        for entry in entries:
            for index, text in enumerate(entry.rows):
                lines.append(self._line("cross_value", entry.index, text, index=str(index)))
            lines += [
                self._line(quantity, entry.index, text) for quantity, text in entry.singles.items()
            ]
        if when == "cross":  # no file of the set holds their switches
            marks = (kind.comment_marks for kind in self.definition.texts.values())
            comment = next(one[0] for one in marks if one)
            lines += [f"{comment}{BY_HAND}{line}" for line in self.missing_switches(entries)]
        lines += [print_form(line, named) for line in file.footer]
        content = "".join(line + newline for line in lines).encode("ascii")
        return ControlFile(print_form(file.name, named), content)

    def missing_switches(self, entries: Iterable[PairEntry]) -> list[str]:
        """Return lines that activate those new tables whose activation parameter is in none of the
        control's files.
        """
        on = self.definition.choice("cross_table_enabled").text("yes")
        return [
            self._line("cross_table_enabled", entry.index, on)
            for entry in entries
            if not self.tables.places_of(entry.index, "cross_table_enabled")
        ]

    def _line(self, quantity: str, table: int, text: str, **more: str) -> str:
        binding = self.definition.bindings[quantity]
        form = self.definition.statements[binding.statement].form
        return print_form(form, {"table": str(table), binding.field: text, **more})


class PairsWriter(GridWriter):
    """Writes an axis table, or two cross-axis tables if the two directions differ."""

    def __init__(
        self, control: Family, files: Sequence[ControlFile], addresses: Iterable[str]
    ) -> None:
        super().__init__(control, files, addresses)
        self.cec = CecWriter(control, self.own)

    def axis(self, work: AxisToWrite) -> list[ControlFile]:
        """Write the table and backlash of an axis, or one table per direction; see
        `GridWriter.axis`.
        """
        self.cec.tables.allowed = allowed_tables(self.definition, work.options)
        if not holds_two_curves(work.options, work.compensation):
            return super().axis(work)
        text = self.text(work, self.control.scale_of(work.axis), WrittenTable((), {}))
        off = self.definition.choice("enabled").text("no")  # so that no correction is active twice
        text = replace(text, singles={**text.singles, "enabled": off})
        left = self.cec.own_pair(work)
        fresh = [self.cec.new_file("two_curves", work.address, left)] if left else []
        self.make_room(work)
        files = [file for file in self.files_for("two_curves") if file.rows is None]
        made = self.new_files(
            files, text, self._put_pair(text), self.cec.missing_switches(left), work
        )
        return [*fresh, *made]  # what switches tables on is loaded last

    def make_room(self, work: AxisToWrite) -> None:
        """Remove existing corrections that a new table replaces; see `GridWriter.make_room`."""
        self.cec.empty_own(work)

    def _put_pair(self, text: AxisText) -> set[str]:
        """Write single values into the control's files; return the quantities that have a line
        there.
        """
        placed = self.put_backlash(text)
        if self.own is None:
            return placed
        if self.own_values(text, whole=True).get("cross_axis_enabled"):
            placed.add("cross_axis_enabled")
        if self.own.put(
            "enabled", self.own_values(text).get("enabled", ()), text.singles["enabled"]
        ):
            placed.add("enabled")
        return placed

    def files_naming(self, addresses: Collection[str]) -> set[int]:
        """Return the indices of the files that mention the axes; see `GridWriter.files_naming`."""
        tables = self.cec.tables
        pairs = {(address, address) for address in addresses}
        return super().files_naming(addresses) | {
            place.number
            for index, places in tables.places.items()
            if index in tables.kept or tables.in_use.get(index) in pairs
            for found in places.values()
            for place in found
        }
