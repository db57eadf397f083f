"""Write small files that contain only the changed values of the axes of the job.

An archive in a container is never written back. Changed values go into files that the control loads
in addition to it. The same entries with their old values go into files that restore them. Entries
that define or correct the axis but stay the same are in the file as comments (``; as it is:``). So
the files can be understood without the archive.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.definition.vocabulary import When
from compwright.formats.families.axis_names import axis_names
from compwright.formats.families.axis_pairs import merged_files
from compwright.formats.families.family import Family
from compwright.formats.text.addresses import (
    NAMES,
    AxisNames,
    Key,
    entry_key,
    normal_text,
    quantities_of,
    value_of,
    which_fields,
)
from compwright.formats.text.gathering import same_value
from compwright.formats.text.texts import AS_IT_IS, BY_HAND, text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile

#: Stands before the name of a file that brings old values back.
BACK = "BACK_"
#: Quantities of an axis' own table, and those that only somebody at the control may change: what
#: wakes other tables too, and what clears the memory.
_OWN_TABLE = ("value", "table_start", "table_end", "table_spacing", "repeats")
_HANDS = ("cross_axis_enabled", "max_points", "cross_max_points")
_BETWEEN = ("cross_input", "cross_output")
_CHANNEL = re.compile(rb"^[ \t]*CHANDATA\([0-9]+\)", re.MULTILINE | re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class _FilesSide:
    """The values in the old or in the new files: the line that states each variable last, and the
    names of the axes.
    """

    entries: Mapping[Key, Occurrence]
    names: AxisNames


@dataclass(frozen=True, slots=True)
class _Plan:
    """What one small file will contain: name, header, entries and footer.

    ``enters``: the entries that the file sets. ``by_hand``: entries that the user sets at the
    control. ``as_it_is``: entries that stay the same and are shown as comments.
    """

    name: str
    header: tuple[str, ...]
    footer: tuple[str, ...]
    enters: tuple[Key, ...]
    by_hand: tuple[Key, ...] = ()
    as_it_is: tuple[Key, ...] = ()


class SmallFiles:
    """The small files that enter the changed values of some axes.

    ``own``: the control's files, with the contents of containers in their place. ``patched``: the
    changed files among them, and new files.
    """

    def __init__(
        self,
        control: Family,
        own: Sequence[ControlFile],
        patched: Sequence[ControlFile],
        axes: Sequence[Axis],
    ) -> None:
        self.control = control
        self.definition = control.definition
        self.holds = {
            name: frozenset(quantities_of(self.definition, name))
            for name in self.definition.statements
        }
        self.systems: dict[str, str] = {}
        for axis in axes:
            for each in (axis.address, axis.gantry):
                if each is not None:
                    address = normal_text(self.definition, each)
                    self.systems.setdefault(address, str(axis.encoder.system - 1))
        self.own = tuple(own)
        self.old = self._side(own)
        self.new = self._side(merged_files(own, patched))
        self.plans = [plan for plan in self._plans() if plan.enters or plan.by_hand]

    def files(self) -> tuple[ControlFile, ...]:
        """Return the small files that enter the new values into the control."""
        return tuple(self._file(plan, self._new_text) for plan in self.plans)

    def back(self) -> tuple[ControlFile, ...]:
        """Return the small files that restore the control's old values."""
        plans = [replace(plan, name=BACK + plan.name, as_it_is=()) for plan in self.plans]
        return tuple(self._file(plan, self._old_text) for plan in plans)

    # -- reading

    def _side(self, files: Sequence[ControlFile]) -> _FilesSide:
        reader, faults = text_reader(self.definition), list[Fault]()
        read = [reader.read(file, faults, number) for number, file in enumerate(files)]
        raise_all(InputError, faults)
        texts = [text for text in read if text is not None]
        known = list(dict.fromkeys((*self.control.state.axes, *self.systems)))
        names = axis_names(self.definition, texts, known)
        entries: dict[Key, Occurrence] = {}
        for text in texts:
            for occurrence in text.occurrences:
                entries[entry_key(self.definition, occurrence, names)] = occurrence
        return _FilesSide(entries, names)

    def _is(self, key: Key, quantities: Iterable[str]) -> bool:
        return not self.holds[key[0]].isdisjoint(quantities)

    def _has(self, key: Key, field: str) -> bool:
        return field in self.definition.statements[key[0]].fields

    def _system(self, key: Key) -> str | None:
        return self._part(key, "system")

    def _table(self, key: Key) -> str | None:
        return None if self._is(key, NAMES) else self._part(key, "table")

    def _part(self, key: Key, field: str) -> str | None:
        fields = which_fields(self.definition, key[0])
        return key[2][fields.index(field)] if field in fields else None

    def _changed(self, key: Key) -> bool:
        old, new = self.old.entries.get(key), self.new.entries[key]
        return old is None or not same_value(value_of(old), value_of(new))

    # -- which entry goes where

    def _plans(self) -> Iterator[_Plan]:
        tables = self._tables()
        pairs = {table: self._pair(table) for table in tables}
        machine_wide = [key for key in self.new.entries if self._global(key)]
        for address, system in self.systems.items():
            mine = [key for key in self.new.entries if key[1] == address]
            own = [key for key in mine if self._is(key, _OWN_TABLE) and self._system(key) == system]
            remaining = [
                key
                for key in mine
                if not self._is(key, _OWN_TABLE) and self._system(key) in (None, system)
            ]
            itself = [table for table, pair in pairs.items() if pair == (address, address)]
            written = [table for table in itself if self._is_written(tables[table])]
            others = [
                table
                for table, pair in pairs.items()
                if pair[1] == address
                and not self._is_written(tables[table])
                and self._moves(tables[table])
            ]
            others += self._multiplied_by(tables, others, written)
            active = self._switched_on(address, system)
            enters_own = own if active or any(map(self._changed, own)) else []
            yield self._plan("one_curve", address, ordered(enters_own), rows=True)
            data = [key for table in written for key in tables[table] if not self._is_switch(key)]
            yield self._plan("two_curves", address, ordered(data), rows=True)
            switches = [key for table in written for key in tables[table] if self._is_switch(key)]
            hands = [
                key for key in (*remaining, *switches) if self._is_hand(key, pair=bool(written))
            ]
            enters = [
                key for key in (*remaining, *switches) if key not in hands and self._is_entered(key)
            ]
            as_it_is = [
                *machine_wide,
                *self._naming(address, [pairs[table] for table in (*written, *others)]),
                *(key for key in own if key not in enters_own),
                *(key for key in remaining if key not in (*enters, *hands)),
                *(key for table in others for key in tables[table]),
                *(key for key in switches if key not in (*enters, *hands)),
            ]
            yield self._plan(
                "one_curve", address, enters, by_hand=hands, as_it_is=as_it_is, rows=False
            )
        for address in dict.fromkeys(corrected for _, corrected in pairs.values()):
            yield self._cross(address, tables, pairs, machine_wide)

    def _multiplied_by(
        self, tables: Mapping[str, Sequence[Key]], others: Sequence[str], written: Sequence[str]
    ) -> list[str]:
        """Return the tables by which the control multiplies the values of the tables ``others``,
        without these and without the tables ``written`` by compwright.
        """
        numbers = (
            int(value_of(self.new.entries[key])) - 1
            for table in others
            for key in tables[table]
            if self._is(key, ("cross_multiplier",))
        )
        named = dict.fromkeys(str(number) for number in numbers if str(number) in tables)
        return [table for table in named if table not in (*others, *written)]

    def _cross(
        self,
        address: str,
        tables: Mapping[str, Sequence[Key]],
        pairs: Mapping[str, tuple[str, str]],
        machine_wide: Sequence[Key],
    ) -> _Plan:
        """Return the small file with the new cross-axis tables that correct the axis at
        ``address``. ``tables``: the keys of each table's values; ``pairs``: each table's axes;
        ``machine_wide``: parameters that are not of one axis.
        """
        mine = [
            table
            for table, (base, corrected) in pairs.items()
            if corrected == address and base != address and self._is_written(tables[table])
        ]
        written = [key for table in mine for key in tables[table]]
        bases = {pairs[table][0] for table in mine}
        facts = [key for key in self.new.entries if key[1] in {address, *bases}]
        sums = [key for key in facts if key[1] == address and self._is(key, _HANDS[:1])]
        hands = [*sums, *(key for key in written if self._is_switch(key))]
        enters = ordered([key for key in written if key not in hands])
        as_it_is = (
            *machine_wide,
            *self._naming(address, [pairs[table] for table in mine]),
            *(key for key in facts if self._is(key, ("rotary", "cross_metric", "cross_max_sum"))),
        )
        if not mine:
            hands, as_it_is = [], ()
        return self._plan("cross", address, enters, by_hand=hands, as_it_is=as_it_is, rows=True)

    def _plan(
        self,
        when: When,
        address: str,
        enters: Sequence[Key],
        *,
        rows: bool,
        by_hand: Sequence[Key] = (),
        as_it_is: Sequence[Key] = (),
    ) -> _Plan:
        file = next(
            file
            for file in self.definition.writing
            if file.when == when and (file.rows is not None) == rows
        )
        name = print_form(file.name, {"axis": self.new.names.of_machine(address)})
        header = (*file.header[:-1], *self._unit_word(), *file.header[-1:])
        return _Plan(name, header, file.footer[-1:], tuple(enters), tuple(by_hand), tuple(as_it_is))

    def _unit_word(self) -> Iterator[str]:
        """Yield the line that sets the length unit (METRIC or INCH), if the user's own files
        contain one.
        """
        for key, occurrence in self.old.entries.items():
            if self._is(key, ("unit_word",)):
                yield value_of(occurrence)
                return

    def _tables(self) -> dict[str, list[Key]]:
        """Return, by table index, the keys of all variables that belong to the cross-axis table."""
        tables: dict[str, list[Key]] = {}
        for key in self.new.entries:
            table = self._table(key)
            if table is not None:
                tables.setdefault(table, []).append(key)
        filled = {
            table: keys
            for table, keys in tables.items()
            if any(self._is(key, ("cross_value",)) for key in keys)
        }
        return dict(sorted(filled.items(), key=lambda entry: int(entry[0])))

    def _pair(self, table: str) -> tuple[str, str]:
        named = {}
        for key, occurrence in self.new.entries.items():
            for quantity in _BETWEEN:
                if self._table(key) == table and self._is(key, (quantity,)):
                    text = normal_text(self.definition, occurrence.tokens["value"].text)
                    named[quantity] = self.new.names.address(text)
        return named.get("cross_input", ""), named.get("cross_output", "")

    def _moves(self, keys: Sequence[Key]) -> bool:
        """Return whether a table has a value other than zero, so that it moves an axis. ``keys``:
        the table's variables.
        """
        values = [key for key in keys if self._is(key, ("cross_value",))]
        return any(not same_value(value_of(self.new.entries[key]), "0") for key in values)

    def _is_written(self, keys: Sequence[Key]) -> bool:
        return any(self._changed(key) for key in keys if not self._is(key, _HANDS))

    def _is_switch(self, key: Key) -> bool:
        return self._is(key, ("cross_table_enabled", "cross_weight", "cross_max_points"))

    def _is_hand(self, key: Key, *, pair: bool) -> bool:
        """Return whether a parameter has to be set by hand at the control, not by the file.
        ``pair``: the axis gets a cross-axis table.

        These are parameters that change the reserved memory, and the parameter that activates all
        cross-axis tables on an axis.
        """
        return self._is(key, _HANDS) and (
            self._changed(key) or (pair and self._is(key, ("cross_axis_enabled",)))
        )

    def _is_entered(self, key: Key) -> bool:
        always = ("enabled", "backlash", "cross_table_enabled", "cross_weight")
        return self._is(key, always) or self._changed(key)

    def _switched_on(self, address: str, system: str) -> bool:
        return any(
            self._is(key, ("enabled",))
            and key[1] == address
            and self._system(key) == system
            and not same_value(value_of(occurrence), "0")
            for key, occurrence in self.new.entries.items()
        )

    def _global(self, key: Key) -> bool:
        """Return whether a parameter applies to the whole machine and not to one axis."""
        known = not self._is(key, ("unit_word",)) and bool(self.holds[key[0]])
        return known and not (self._has(key, "axis") or self._has(key, "table"))

    def _naming(self, address: str, pairs: Iterable[tuple[str, str]]) -> Iterator[Key]:
        """Yield the parameters in which the control's files state the axis names that the small
        file contains.
        """
        names = self.new.names
        involved = {address, *(axis for pair in pairs for axis in pair if axis)}
        channels = set()
        for key, occurrence in self.new.entries.items():
            if not self._is(key, ("machine_axis", "channel_axis")):
                continue
            text = normal_text(self.definition, value_of(occurrence))
            if self._is(key, ("machine_axis",)) and names.address(text) in involved:
                yield key
            if self._is(key, ("channel_axis",)) and text == address:
                channels.add(key[2])
                yield key
        for key in self.new.entries:
            if self._is(key, ("channel_machine_axis",)) and key[2] in channels:
                yield key

    # -- lines

    def _file(self, plan: _Plan, text: Callable[[Key], str | None]) -> ControlFile:
        comment = next(
            kind.comment_marks[0] for kind in self.definition.texts.values() if kind.comment_marks
        )
        header = [print_form(line, {}) for line in plan.header]
        lines = [
            *self._marked(header),
            *self._lines(plan.as_it_is, text, comment + AS_IT_IS),
            *self._lines(plan.enters, text, ""),
            *self._lines(plan.by_hand, text, comment + BY_HAND),
            *(print_form(line, {}) for line in plan.footer),
        ]
        content = "".join(line + self.definition.dialect.newline for line in lines)
        return ControlFile(plan.name, content.encode("ascii"))

    def _marked(self, header: Sequence[str]) -> Iterator[str]:
        """Yield the lines of a file header; its line that names the channel is replaced by that of
        the control's own files, if they have one.
        """
        found = next((found for file in self.own if (found := _CHANNEL.search(file.content))), None)
        own = None if found is None else found[0].decode().strip()
        for line in header:
            yield own if own is not None and _CHANNEL.match(line.encode()) else line

    def _lines(
        self, keys: Iterable[Key], text: Callable[[Key], str | None], before: str
    ) -> Iterator[str]:
        for key in dict.fromkeys(keys):
            value = text(key)
            if value is not None:
                yield before + self._line(key, value)

    def _line(self, key: Key, text: str) -> str:
        statement = self.definition.statements[key[0]]
        named = dict(zip(which_fields(self.definition, key[0]), key[2], strict=True))
        if key[1]:
            named["axis"] = self.new.names.written(key[1])
        field = next(name for name in statement.fields if name not in named)
        return print_form(statement.form, {**named, field: text})

    def _new_text(self, key: Key) -> str | None:
        return self._text(key, self.new.entries[key])

    def _text(self, key: Key, occurrence: Occurrence) -> str:
        """Return an entry's new value as text; an axis has the same name in all lines."""
        text = value_of(occurrence)
        if not self._is(key, _BETWEEN):
            return text
        names = self.new.names
        return names.written(names.address(normal_text(self.definition, text)))

    def _old_text(self, key: Key) -> str | None:
        """Return the old value of an entry as text.

        A table value or backlash that was in no file becomes 0 again. A table's switch gets the
        state that the table had during the measurement; the job may state it differently from the
        files. None if the entry need not be restored, such as reserved memory.
        """
        found = self.old.entries.get(key)
        enabled = self.control.state.facts_of(key[1]).enabled
        if self._is(key, ("enabled",)) and enabled is not None:
            return self.definition.choice("enabled").text("yes" if enabled else "no")
        if self._is(key, ("max_points", "cross_max_points")) and self._changed(key):
            return None  # unused reserved memory does no harm; reserving less clears the memory
        if found is not None:
            return self._text(key, found)
        if self._is(key, ("value", "cross_value", "backlash", "cross_table_enabled")):
            return "0"
        grid = (*_OWN_TABLE, "cross_start", "cross_end", "cross_spacing", "cross_direction")
        same = self._is(key, (*grid, *_BETWEEN, "cross_multiplier", "cross_repeats"))
        return self._new_text(key) if same else None


def ordered(keys: Sequence[Key]) -> list[Key]:
    """Return the entries grouped by variable, those of each variable ascending by index."""
    rows: dict[str, list[Key]] = {}
    for key in keys:
        rows.setdefault(key[0], []).append(key)

    def place(key: Key) -> tuple[int, ...]:
        return tuple(int(text) for text in key[2] if text.isdigit())

    return [key for group in rows.values() for key in sorted(group, key=place)]
