"""Write an axis' tables into the control's own files, or into new files made from the definition's
templates.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Choice, Definition, WrittenFile
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.definition.vocabulary import When
from compwright.formats.families.control_texts import gathered_files, texts_of
from compwright.formats.families.family import AxisTable, Family
from compwright.formats.families.grid.axis_settings import MODULO_START
from compwright.formats.families.grid.modulo_range import (
    RANGE_QUANTITY,
    in_modulo_range,
    over_travel,
)
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.families.grid.tables import TableText, WrittenTable
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.text.gathering import FoundValue, first_set
from compwright.formats.text.own_files import OwnFiles, TablePlaces, rows_by_index
from compwright.formats.text.patching import fresh_file, set_field
from compwright.formats.text.scale import NotHeld, NumberScale
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile


@dataclass(frozen=True, slots=True)
class AxisText:
    """The text to write for one axis: the table rows, and single values such as the spacing.

    ``named``: the fields that every line of this axis has, with their texts.
    """

    address: str
    named: Mapping[str, str]
    rows: tuple[Mapping[str, str], ...]
    singles: Mapping[str, str]


class NewFile:
    """A new file for one axis, made from the file template in the definition."""

    def __init__(self, definition: Definition, file: WrittenFile, text: AxisText) -> None:
        self.definition = definition
        self.file = file
        self.text = text
        self.name = print_form(file.name, {**text.named, "axis": text.address})

    def made(
        self, placed: Collection[str], switches: Sequence[str], faults: list[Fault]
    ) -> ControlFile | None:
        """Return the new file; None if it would be empty. ``placed``: quantities in the control's
        own files, which the new file leaves out. ``switches``: lines that activate tables, added
        before the last line of a file without table rows.
        """
        rows = self._rows(placed)
        left = rows is not None
        made = fresh_file(self.definition, self.file, self.name, self.text.named, rows or ())
        self._check_lines(rows or (), faults)
        if switches and self.file.rows is None:
            end = len(made.files[0].content) - len(self.definition.dialect.newline)
            made.add_lines(0, end, switches, before=True)
            left = True
        for place in self._occurrences(made.files[0]):
            found = [
                (quantity, binding.field)
                for quantity, binding in self.definition.bindings.items()
                if binding.statement == place.statement
            ]
            if any(quantity in placed for quantity, _ in found):
                made.cut_line(0, next(iter(place.tokens.values())).start)
                continue
            left = True
            for quantity, part in found:
                if quantity in self.text.singles:
                    made.replace(0, *set_field(place, part, self.text.singles[quantity]))
        return made.patched([0])[0] if left or not placed else None

    def _rows(self, placed: Collection[str]) -> list[str] | None:
        """Return the table rows for this file; None if its template has none, or if the control's
        own files already contain the table. ``placed``: quantities in the control's own files.
        """
        if self.file.rows is None or curves(self.definition)[0] in placed:
            return None
        form = self.definition.statements[self.file.rows].form
        return [print_form(form, {**self.text.named, **row}) for row in self.text.rows]

    def _occurrences(self, skeleton: ControlFile) -> tuple[Occurrence, ...]:
        """Return the lines of the new file ``skeleton``, which has its template's header and
        footer, so that single values, such as the spacing, can be written into them.
        """
        faults: list[Fault] = []
        read = text_reader(self.definition).read(skeleton, faults)
        raise_all(InputError, faults)
        return () if read is None else read.occurrences

    def _check_lines(self, rows: Sequence[str], faults: list[Fault]) -> None:
        longest = self.definition.limit_number("line_length")
        worst = max((len(row) for row in rows), default=0)
        if longest is not None and worst > longest:
            fault = Fault(
                message="a line of the new file is too long for the control",
                file=self.name,
                expected=f"at most {longest} characters",
                found=str(worst),
                hint=(
                    "give a wider `table: {spacing: ...}`, or type in the values of the "
                    "commissioning card at the control"
                ),
            )
            faults.append(fault)


@dataclass(frozen=True, slots=True)
class AxisToWrite:
    """One axis whose table is to be written, with its options and the faults found.

    ``options``: the options of the control; the options of the axis override them. ``faults``:
    values that the text cannot represent.
    """

    address: str
    axis: Axis
    compensation: AxisCompensation
    options: Mapping[str, object]
    faults: list[Fault] = field(default_factory=list)


class GridWriter:
    """Writes the tables of one control into its own ``files`` and into new ones."""

    def __init__(
        self, control: Family, files: Sequence[ControlFile], addresses: Iterable[str]
    ) -> None:
        self.control = control
        self.definition = control.definition
        addressed = list(dict.fromkeys((*control.state.axes, *addresses)))
        texts = texts_of(self.definition, files, [])  # they were read before
        patched = bool(texts) and self.definition.limit("no_patching") is None
        self.own = (
            OwnFiles(self.definition, texts, gathered_files(self.definition, texts, addressed))
            if patched
            else None
        )

    def written(self, tables: Sequence[AxisTable], faults: list[Fault]) -> tuple[ControlFile, ...]:
        """Return the files with the tables; numbers that are not exact as text are added to
        ``faults``.
        """
        fresh: list[ControlFile] = []
        for address, axis, compensation in tables:
            work = AxisToWrite(address, axis, compensation, self.control.options_of(axis))
            fresh.extend(self.axis(replace(work, compensation=self._turned(work))))
            faults.extend(_first_few(work.faults, address))
        return (*self._own_files([address for address, _, _ in tables]), *fresh)

    def axis(self, work: AxisToWrite) -> list[ControlFile]:
        """Write one axis into existing lines of the files; return new files for the values that
        have no line there.
        """
        text = self._text(work)
        self.make_room(work)
        return self.new_files(self.files_for("one_curve"), text, self._put(text, work), (), work)

    def make_room(self, work: AxisToWrite) -> None:
        """Remove existing corrections that would be active in addition to the new table."""

    def files_naming(self, addresses: Collection[str]) -> set[int]:
        """Return the indices of the control's own files that contain values of the axes."""
        if self.own is None:
            return set()
        singles, rows = self.own.gathered.singles, self.own.gathered.rows
        own_values = [
            *(
                group
                for (one, _), by in singles.items()
                if one in addresses
                for group in by.values()
            ),
            *(group for (one, _), group in rows.items() if one in addresses),
        ]
        return {place.number for group in own_values for place in group}

    def _own_files(self, addresses: Sequence[str]) -> tuple[ControlFile, ...]:
        """Return the control's own files that contain values of the axes, after all changes."""
        if self.own is None:
            return ()
        gathered, numbers = self.own.gathered, self.files_naming(addresses)
        forms = {form for each in addresses for form in gathered.spellings.get(each, ())}
        if forms - set(addresses):
            # more than one name for an axis: the file that lists them belongs to the set
            numbers |= gathered.naming
        return self.own.patched(numbers)

    def _turned(self, work: AxisToWrite) -> AxisCompensation:
        """Return the table of an endless axis for one turn, which begins where the control's modulo
        range begins.
        """
        compensation, axis = over_travel(work.compensation, work.axis), work.axis
        if compensation.period is None or RANGE_QUANTITY not in self.definition.bindings:
            return compensation
        turn = self.control.state.facts_of(work.address).turn
        ahead = float(np.mod(axis.reference - MODULO_START, compensation.period))
        if turn is None and min(ahead, compensation.period - ahead) > SAME_TURN:
            expected = (
                "the machine data of the axis with MD30310 and MD30340 among the control's files"
            )
            work.faults.append(
                Fault(
                    message=(
                        f"axis {axis.name}: no file states whether the control counts this axis "
                        "modulo one turn (MD30310) and where the turn begins (MD30340). Its "
                        f"reference is at {axis.reference:g} deg, so the part of the table "
                        "that is active there is unknown"
                    ),
                    expected=expected,
                    hint=(
                        "add the file that contains it to the control's files (`states` or"
                        " `--state`)"
                    ),
                )
            )
            return compensation
        start = MODULO_START if turn is None else turn.start
        return in_modulo_range(compensation, start, axis.name, work.faults)

    def _text(self, work: AxisToWrite) -> AxisText:
        scale = self.control.scale_of(work.axis)
        system = str(work.axis.encoder.system - 1)
        own_values = (
            {} if self.own is None else self.own.gathered.singles.get((work.address, system), {})
        )
        shape = shape_of(self.definition)
        there = {name: own_values[name][-1].text for name in shape.rules.grid if name in own_values}
        table = shape.write(TableText(work.compensation, scale, work.faults, there))
        text = self.text(work, scale, table)
        if work.compensation.period is None or "repeats" not in text.singles:
            return text
        repeats = self.definition.choice("repeats").text("yes")
        return replace(text, singles={**text.singles, "repeats": repeats})

    def text(self, work: AxisToWrite, scale: NumberScale, table: WrittenTable) -> AxisText:
        """Return the text of an axis' table and of its single values, such as the spacing."""
        spelled = work.address if self.own is None else self.own.gathered.spelled(work.address)
        named = {"axis": spelled, "system": str(work.axis.encoder.system - 1)}
        definition, singles = self.definition, dict(table.singles)
        for quantity, binding in definition.bindings.items():
            if isinstance(binding, Choice) and quantity in definition.layout.singles:
                singles[quantity] = binding.written(scale.options)
        if "table_file" in definition.bindings:
            singles["table_file"] = next(
                print_form(file.name, named) for file in definition.writing if file.rows is not None
            )
        if (
            "backlash" in definition.bindings
            and definition.limit("no_backlash_beside_table") is None
        ):
            try:
                singles["backlash"] = scale.write("backlash", work.compensation.backlash)
            except NotHeld as error:
                work.faults.append(
                    Fault(
                        message=f"axis {work.compensation.address}: the backlash cannot be "
                        f"written: {error}",
                        hint="set `table: {mode: single}` for this axis, or leave `mode` out",
                    )
                )
        return AxisText(work.address, named, table.rows, singles)

    def files_for(self, when: When) -> list[WrittenFile]:
        """Return the templates of new files that the definition uses always, or only for tables of
        the kind ``when`` (one per axis, one per direction, cross-axis).
        """
        return [
            file
            for file in self.definition.writing
            if file.when in ("always", when) and not file.optional
        ]

    def new_files(
        self,
        files: Iterable[WrittenFile],
        text: AxisText,
        placed: Collection[str],
        switches: Sequence[str],
        work: AxisToWrite,
    ) -> list[ControlFile]:
        """Return new files, made from the templates ``files``, for the values in ``text`` that have
        no line in the control's files. ``placed``: quantities that have one; ``switches``: lines
        that activate tables.
        """
        made = [
            NewFile(self.definition, file, text).made(placed, switches, work.faults)
            for file in files
        ]
        return [file for file in made if file is not None]

    def put_backlash(self, text: AxisText) -> set[str]:
        """Write the backlash, and 1 as its factor, into existing lines; return the quantity
        "backlash" if it has a line, else nothing.
        """
        if self.own is None or "backlash" not in text.singles:
            return set()
        own_values, whole = self.own_values(text), self.own_values(text, whole=True)
        placed = self.own.put("backlash", own_values.get("backlash", ()), text.singles["backlash"])
        factors = own_values.get("backlash_factor", whole.get("backlash_factor", ()))
        if factors:
            self.own.put("backlash_factor", first_set(factors), "1")
        return {"backlash"} if placed else set()

    def own_values(
        self, text: AxisText, *, whole: bool = False
    ) -> Mapping[str, Sequence[FoundValue]]:
        """Return the single values of an axis in the control's files: values of its measuring
        system, or (``whole``) values that apply to the whole axis.
        """
        if self.own is None:
            return {}
        key = (text.address, None if whole else text.named["system"])
        return self.own.gathered.singles.get(key, {})

    def _put(self, text: AxisText, work: AxisToWrite) -> set[str]:
        """Write values into existing lines of the control's files; return the quantities that these
        lines contain.
        """
        if self.own is None:
            return set()
        own_values, placed = self.own_values(text), self.put_backlash(text)
        if placed or own_values.get("enabled"):
            # an existing file holds the backlash: no file is made for the switch alone
            placed.add("enabled")
        value = curves(self.definition)[0]
        names = [
            name
            for name in (*shape_of(self.definition).rules.grid, "repeats")
            if name in text.singles
        ]
        rows = rows_by_index(self.own.gathered.rows.get((text.address, text.named["system"]), ()))
        singles = {name: own_values[name] for name in names if name in own_values}
        spelled = _spelled(rows, singles, text.address)
        places = TablePlaces(rows, singles, value, {**text.named, "axis": spelled})
        self._switch_on(own_values.get("enabled", ()), places)
        self._reserve(own_values.get("max_points", ()), len(text.rows), work.options)
        if not places.anywhere:
            return placed
        column = self.definition.bindings[value].field
        self.own.put_table(
            places, [row[column] for row in text.rows], {name: text.singles[name] for name in names}
        )
        return placed | {value, *names}

    def _switch_on(self, switches: Sequence[FoundValue], table: TablePlaces) -> None:
        """Change the lines of the table's activation parameter so that the table is active once the
        file is loaded.

        The control protects a table while it is active, and would reject its new values. So a file
        that also contains the values switches the table off before them and on after them, as the
        machine maker's programs do.
        """
        if self.own is None or not switches:
            return
        on, off = (self.definition.choice("enabled").text(word) for word in ("yes", "no"))
        first: dict[int, int] = {}
        for found in (found for group in table.rows.values() for found in group):
            line = found.occurrence.line
            first[found.number] = min(first.get(found.number, line), line)
        before = [
            switch for switch in switches if switch.occurrence.line < first.get(switch.number, 0)
        ]
        behind = [switch for switch in switches if switch not in before]
        self.own.put("enabled", behind, on)
        for number in dict.fromkeys(switch.number for switch in before):
            last = [switch for switch in before if switch.number == number][-1:]
            self.own.put("enabled", last, off)
            if number not in {switch.number for switch in behind}:
                self.own.put_after_table(table, number, "enabled", on)

    def _reserve(
        self, places: Sequence[FoundValue], count: int, options: Mapping[str, object]
    ) -> None:
        """Reserve memory for the table's points if the control's files reserve too few.

        The option ``points`` states how many points to reserve. Without it, memory for ``count``
        points is reserved. The files must not keep a smaller number, because loading it would
        remove the memory again.
        """
        promised = options.get("points")
        needed = promised if isinstance(promised, int) else count
        if self.own is not None and any(int(place.text) < count for place in places):
            self.own.put("max_points", places, str(needed))


def _first_few(faults: list[Fault], address: str) -> list[Fault]:
    """Return the first three faults and one fault with the number of all further ones, because a
    wrong rounding causes many.
    """
    rest = len(faults) - 3
    more = Fault(
        message=f"axis {address} has {rest} more values with the fault of the lines above",
        hint="correct them in the same way",
    )
    return faults if rest <= 0 else [*faults[:3], more]


def _spelled(
    rows: Mapping[int, Sequence[FoundValue]],
    singles: Mapping[str, Sequence[FoundValue]],
    address: str,
) -> str:
    """Return the axis name as it is written in the files."""
    found = [place for places in (*rows.values(), *singles.values()) for place in places]
    if found and "axis" in found[0].occurrence.tokens:
        return found[0].occurrence.tokens["axis"].text
    return address
