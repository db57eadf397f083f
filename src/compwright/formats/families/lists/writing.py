"""Write tables into a control's compensation value lists, or into new lists from templates.

A value keeps its line if the table has the same entries. If the number, place or form of the
entries changes, the old entries are removed. The new ones are put in the place of the first old
entry. All other bytes stay the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import print_form
from compwright.formats.families.lists.files import (
    LISTED_AXIS,
    LISTED_COUNT,
    LISTED_FILE,
    ListsByAxis,
    base_name,
    entries,
    read_lists,
    without_remarks,
)
from compwright.formats.families.lists.table import COLUMNS
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import Notes
from compwright.formats.text.patching import BytesChange, Patches, fresh_file, set_field
from compwright.formats.text.scale import NotHeld, NumberScale
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation, ControlFile

#: An entry: its statement and its index.
Entry = tuple[str, int]
_CROSS_COLUMNS = ("cross_setpoint", "cross_correction")


class ListsWriter:
    """Records changes to a control's value lists. Raises InputError if they cannot be read."""

    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        self.definition = definition
        self.patches = Patches(definition.dialect, files)
        self.lists = self._read()

    def _read(self) -> ListsByAxis:
        notes = Notes()
        lists = read_lists(self.definition, self.patches.files, notes)
        raise_all(InputError, notes.faults)
        return lists

    def put_table(
        self, address: str, table: AxisCompensation, scale: NumberScale, faults: list[Fault]
    ) -> None:
        """Write the table of an axis into its list. Numbers that do not fit are added to
        ``faults``.
        """
        label = f"axis {address}"
        positions = _texts(scale, "node_position", table.positions, label, faults)
        curves = {
            name: _texts(scale, f"value_{name}", curve, label, faults)
            for name, curve in (("positive", table.positive), ("negative", table.negative))
        }
        if faults:
            return
        self._home(address)
        step = self._interval(address, [int(text) for text in positions])
        columns = curves if step else {"setpoint": positions, **curves}
        self._entries(
            address,
            {
                **self._words(address),
                "interval": str(step),
                "start": positions[0],
                "count": str(len(positions)),
                "modulo": "0" if table.period is None else "1",
            },
            columns,
            COLUMNS,
        )
        self._activate(address, "table_switch", "manual")
        switch = self.lists.places(address, "backlash_switch")
        if any(not same_value(place.text, "0") for place in switch):
            self._put(self.lists.places(address, "backlash"), "0")

    def _words(self, address: str) -> dict[str, str]:
        """Return the texts that state the unit and whether each direction has a column; an existing
        list keeps its unit.
        """
        bindings = self.definition
        unit = self.lists.places(address, "unit")
        return {
            "unit": unit[0].text if unit else str(bindings.choice("table_form").writes),
            "bilateral": str(bindings.choice("bidirectional").writes),
        }

    def put_cross(
        self, address: str, master: str, positions: Sequence[str], values: Sequence[str]
    ) -> None:
        """Write into the list of an axis the table by which the axis ``master`` corrects it."""
        self._home(address)
        single = {
            "cross_unit": "1",
            "cross_master": master,
            "cross_last": str(len(positions) - 1),
        }
        columns = {"cross_setpoint": positions, "cross_correction": values}
        self._entries(address, single, columns, _CROSS_COLUMNS)
        self._activate(address, "cross_switch", "cross_manual")

    def files_of(self, addresses: Iterable[str]) -> tuple[ControlFile, ...]:
        """Return the start-up list and the lists of the axes, with all changes."""
        numbers = {number for each in addresses for number in self.lists.files.get(each, ())}
        numbers |= {place.number for places in self.lists.start_up.values() for place in places}
        return self.patches.patched(numbers)

    # --- where a table stands

    def _home(self, address: str) -> None:
        """Create a list for an axis that has none, and enter it in the start-up list."""
        if self.lists.value_files(address):
            return
        file = self.definition.writing[0]
        name = self._free_name(print_form(file.name, {"axis": address}))
        made = fresh_file(self.definition, file, name, {"axis": address}, ()).patched([0])[0]
        self._announce(address, name)
        done = self.patches.patched(range(len(self.patches.files)))
        self.patches = Patches(self.definition.dialect, [*done, made])
        self.lists = self._read()

    def _free_name(self, name: str) -> str:
        taken = {file.name.casefold() for file in self.patches.files}
        taken |= {base_name(place.text) for place in self.lists.start_up.get(LISTED_FILE, ())}
        stem, dot, ending = name.rpartition(".")
        number = 2
        while name.casefold() in taken:
            name, number = f"{stem}_{number}{dot}{ending}", number + 1
        return name

    def _announce(self, address: str, name: str) -> None:
        """Enter a new list in the start-up list, if the files contain one."""
        start_up = self.lists.start_up
        listed = [*start_up.get(LISTED_AXIS, ()), *start_up.get(LISTED_FILE, ())]
        if not listed:
            return
        index = str(1 + max(at for at, _ in entries(listed)))
        lines = [
            self._line(LISTED_AXIS, {"index": index, "axis": address}),
            self._line(LISTED_FILE, {"index": index, "value": name}),
        ]
        last = max(listed, key=lambda found: (found.number, found.occurrence.line))
        self.patches.add_lines(last.number, _start(last), lines)
        for place in start_up.get(LISTED_COUNT, ()):
            self._put([place], str(int(place.text) + 1))

    def _interval(self, address: str, counts: Sequence[int]) -> int:
        """Return the interval, in the list's unit, of entries at the equally spaced positions
        ``counts``; 0 if each entry states its own position.
        """
        own = self.lists.places(address, "interval")
        steps = set(np.diff(counts).tolist())
        even = bool(own) and not same_value(own[0].text, "0") and len(steps) == 1
        return int(steps.pop()) if even else 0

    # --- what is written

    def _entries(
        self,
        address: str,
        singles: Mapping[str, str],
        columns: Mapping[str, Sequence[str]],
        known: Sequence[str],
    ) -> None:
        """Write a table: its single values ``singles``, and its entries by column. ``known``: names
        of all columns that the list can contain; existing lines are kept if the new table has the
        same entries.
        """
        places = [f for column in known for f in self.lists.places(address, column)]
        new: dict[Entry, str] = {
            (column, index): texts[index]
            for index in range(len(next(iter(columns.values()))))
            for column, texts in columns.items()
        }
        stays = self._stays(address, singles, new, known)
        added = [
            self._line(name, {"value": text})
            for name, text in singles.items()
            if not self._put(self.lists.places(address, name), text)
        ]
        if stays:
            for column in columns:
                for index, found in entries(self.lists.places(address, column)):
                    self._put([found], new[column, index])
        else:
            added += [
                self._line(column, {"index": str(index), "value": text})
                for (column, index), text in new.items()
            ]
        anchor = self._anchor(address, [*singles, *known], places)
        self.patches.add_lines(anchor.number, _start(anchor), added, before=bool(places))
        if not stays:
            for found in places:
                self._take_out(found)

    def _stays(
        self,
        address: str,
        singles: Mapping[str, str],
        new: Mapping[Entry, str],
        known: Sequence[str],
    ) -> bool:
        """Return whether the ``new`` table has the same entries at the same positions as the list,
        so that only values change. ``known``: names of all columns that the list can contain, that
        of the positions first.
        """
        old = {
            (column, index): found
            for column in known
            for index, found in entries(self.lists.places(address, column))
        }
        places = [
            (found, new.get(entry, "")) for entry, found in old.items() if entry[0] == known[0]
        ]
        places += [
            (found, singles[name])
            for name in ("interval", "start")
            if name in singles
            for found in self.lists.places(address, name)
        ]
        return set(old) == set(new) and all(same_value(found.text, text) for found, text in places)

    def _anchor(
        self, address: str, names: Sequence[str], places: Sequence[FoundValue]
    ) -> FoundValue:
        """Return the line next to which new lines of a table are inserted: the first of the table's
        old lines ``places``, else the last line of the statements ``names`` or of the list.
        """
        if places:
            return min(places, key=lambda found: (found.number, found.occurrence.line))
        statements = self.lists.statements[address]
        around = [found for name in names for found in statements.get(name, ())]
        if not around:
            here = self.lists.value_files(address) or {max(self.lists.files[address])}
            every = [found for places in statements.values() for found in places]
            around = [found for found in every if found.number in here]
        return max(around, key=lambda found: (found.number, found.occurrence.line))

    def _line(self, statement: str, fields: Mapping[str, str]) -> str:
        return print_form(self.definition.statements[statement].form, fields)

    def _put(self, places: Sequence[FoundValue], text: str) -> bool:
        """Set a value in all lines that state it; return False if no line does."""
        for place in places:
            if not same_value(place.text, text):
                self.patches.replace(place.number, *set_field(place.occurrence, "value", text))
        return bool(places)

    def _activate(self, address: str, switch: str, manual: str) -> None:
        """Set the lines that activate a table: its activation parameter ``switch`` to 1, the
        parameter ``manual`` for manual activation to 0.
        """
        self._put(self.lists.places(address, switch), "1")
        self._put(self.lists.places(address, manual), "0")

    def _take_out(self, found: FoundValue) -> None:
        """Remove the line of an old entry, but keep a comment that reaches over several lines."""
        line = self.patches.line(found.number, _start(found))
        content = self.patches.files[found.number].content
        raw = content[line.start : line.end]
        if b"/*" not in raw and b"*/" not in raw:
            self.patches.cut_line(found.number, _start(found))
            return
        code = without_remarks(content)[line.start : line.end]
        start = line.start + len(code) - len(code.lstrip())
        end = found.occurrence.tokens["value"].end
        self.patches.replace(found.number, BytesChange(start, end, b""))


def _start(found: FoundValue) -> int:
    """Return the byte position at which the first value of a statement begins."""
    return next(iter(found.occurrence.tokens.values())).start


def _texts(
    scale: NumberScale, quantity: str, values: FloatArray, label: str, faults: list[Fault]
) -> list[str]:
    """Return numbers as texts of whole counts; numbers that do not fit are added to ``faults``."""
    texts = []
    for value in values:
        try:
            texts.append(scale.write(quantity, float(value)))
        except NotHeld as error:
            faults.append(
                Fault(
                    message=f"{label}: a value cannot be written: {error}",
                    hint="correct `table` of this axis in the job",
                )
            )
    return texts
