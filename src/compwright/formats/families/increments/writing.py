"""Compensation -> whole increments by section (FANUC): into the user's own backup where one was
given, else minimal files.

Only what belongs to the axis under work is written: its groups in lines that axes share, single
bits, its own point numbers. Every other byte of a backup stays.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from compwright.formats.definition.schema import Choice, Definition, WrittenFile
from compwright.formats.definition.statements import print_form
from compwright.formats.families.family import AxisTable, Family
from compwright.formats.families.increments.axis_values import INCH, thousandths
from compwright.formats.families.increments.entries import Entries, all_entries, real_text
from compwright.formats.families.increments.points import POINTS_FROM, point_number, point_rows
from compwright.formats.families.increments.reading import read_texts
from compwright.formats.text.entry_sheet import SheetRow, is_entry_sheet
from compwright.formats.text.gathering import Found, Gathered, gather
from compwright.formats.text.patching import Patches, fresh_file, set_field
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, InputError, raise_all
from compwright.records.axis import AxisKind
from compwright.records.correction import ControlFile


def write_increments(
    family: Family, tables: Sequence[AxisTable], files: Sequence[ControlFile]
) -> tuple[ControlFile, ...]:
    """Return the files that put ``tables`` into the control; ``files``: its own, to be patched.

    Raises CapacityError with everything that the control cannot hold.
    """
    definition = family.definition
    entries = all_entries(family, tables)
    faults: list[Fault] = []
    own = [file for file in files if not is_entry_sheet(file)]
    patched = _OwnFiles(definition, own)
    names = {file.name for file in own}
    fresh = [
        file
        for entry in entries
        for file in _fresh(definition, entry, patched.put(entry, faults), names)
    ]
    raise_all(CapacityError, faults)
    return (*patched.speaking(entries), *fresh)


class _OwnFiles(Patches):
    """Collects the changes to the user's own files."""

    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        super().__init__(definition.dialect, files)
        self.definition = definition
        self.gathered: Gathered | None = None
        self.rows: dict[int, list[Found]] = {}
        if files:
            found: list[Fault] = []
            texts = read_texts(definition, files, found)
            raise_all(InputError, found)
            self.gathered = gather(definition, texts)
            for row in point_rows(definition, self.gathered, self.files):
                self.rows.setdefault(point_number(row), []).append(row)

    def put(self, entry: Entries, faults: list[Fault]) -> Entries:
        """Note the changes for one axis and return what has no place in the user's files."""
        left = {
            name: text
            for name, text in entry.parameters.items()
            if not self._parameter(entry, name, text)
        }
        if left.pop("bidirectional", "0") == "1":
            faults.append(
                Fault(
                    message=(
                        f"axis {entry.name} ({entry.address}): two tables need bit 3605#0, which is"
                        " changed only in content that was read from the control"
                    ),
                    expected=(
                        "the control's own parameter file with 3605 among the files of the state"
                    ),
                )
            )
        missing = {
            number: value
            for number, value in entry.points.items()
            if not self._point(number, value)
        }
        for number in entry.cleared:
            self._point(number, 0)
        if missing and self.rows:
            self._insert(missing)
            missing = {}
        return replace(entry, parameters=left, points=missing, cleared=())

    def _parameter(self, entry: Entries, quantity: str, text: str) -> bool:
        binding = self.definition.bindings.get(quantity)
        if binding is None or self.gathered is None:
            return False
        places = self.gathered.singles.get((entry.address, None), {}).get(quantity, [])
        for place in places:
            value = text
            if quantity in ("table_spacing", "turn"):
                value = self._length_there(place, entry, text)
            if isinstance(binding, Choice) and place.text == value:
                continue
            self._set(place, binding.field, value)
        return bool(places)

    def _length_there(self, place: Found, entry: Entries, text: str) -> str:
        """Return a length as the letter that stands there counts it: M mm, I inch, P the machine's
        unit, deg for rotary axes.
        """
        value = millimetres(text)
        key = place.occurrence.tokens["key"].text.upper()
        inch = entry.kind is AxisKind.LINEAR and (key == "I" or (key == "P" and entry.inch))
        if inch:
            value /= INCH
        if thousandths(self.definition) and "." not in place.text:
            return str(int(value / (Decimal("0.0001") if inch else Decimal("0.001"))))
        return real_text(value)

    def _point(self, number: int, value: int) -> bool:
        rows = self.rows.get(number, [])
        for row in rows:
            self._set(row, "value", str(value))
        return bool(rows)

    def _set(self, place: Found, field: str, text: str) -> None:
        """Change a field, unless it says the same already: a value that stays keeps its bytes."""
        token = place.occurrence.tokens[field]
        if token.text != text and not _equal(token.text, text):
            self.replace(place.number, *set_field(place.occurrence, field, text))

    def _insert(self, missing: Mapping[int, int]) -> None:
        """Put points that the files do not hold behind the nearest lower one, in the style of that
        line.
        """
        known = sorted(self.rows)
        for number, value in sorted(missing.items()):
            below = [one for one in known if one < number]
            neighbour = self.rows[below[-1] if below else known[0]][-1]
            texts = {"number": str(POINTS_FROM + number), "value": str(value)}
            line = self.like(neighbour.number, neighbour.occurrence, texts)
            place = neighbour.occurrence.tokens["number"].start
            self.add_lines(neighbour.number, place, [line], before=not below)

    def speaking(self, entries: Sequence[Entries]) -> tuple[ControlFile, ...]:
        """Return the user's files that say something of the axes or hold point data, with all
        changes made.
        """
        if self.gathered is None:
            return ()
        addresses = {entry.address for entry in entries}
        speaking = {row.number for rows in self.rows.values() for row in rows}
        for (address, _), singles in self.gathered.singles.items():
            if address in addresses:
                speaking |= {place.number for places in singles.values() for place in places}
        return self.patched(speaking)


def _equal(one: str, other: str) -> bool:
    return ("." in one) == ("." in other) and Decimal(one) == Decimal(other)


def _fresh(
    definition: Definition, entry: Entries, left: Entries, taken: Collection[str]
) -> Iterator[ControlFile]:
    """Yield minimal files with what found no place in the user's own; they do not take the names of
    those (``taken``).
    """
    for file in definition.writing:
        if file.optional:
            continue
        lines = (
            list(_point_lines(definition, left))
            if file.rows
            else list(_parameter_lines(definition, left))
        )
        if lines:
            fresh = _file(definition, file, entry, lines)
            name = fresh.name
            while name in taken:
                stem, dot, ending = name.rpartition(".")
                name = f"{stem}_MORE{dot}{ending}"
            yield replace(fresh, name=name)


def _file(
    definition: Definition, file: WrittenFile, entry: Entries, lines: Sequence[str]
) -> ControlFile:
    # Each axis' program has a number of its own: of two with one number the control keeps one.
    named = {"axis": entry.address, "name": entry.name, "program": f"91{int(entry.address):02d}"}
    name = print_form(file.name, named)
    return fresh_file(definition, file, name, named, lines).patched([0])[0]


def _parameter_lines(definition: Definition, entry: Entries) -> Iterator[str]:
    for quantity in (*definition.layout.singles, "table_spacing"):
        if quantity in entry.parameters:
            yield _parameter_line(definition, quantity, entry, entry.parameters[quantity])


def _parameter_line(definition: Definition, quantity: str, entry: Entries, text: str) -> str:
    binding = definition.bindings[quantity]
    # Where the control's own files say its unit, a fresh line has the letter that they have; else M
    # says that it is in mm.
    key = (
        "P"
        if thousandths(definition) or entry.kind is AxisKind.ROTARY or entry.inch is not None
        else "M"
    )
    if quantity in ("table_spacing", "turn") and entry.inch and entry.kind is AxisKind.LINEAR:
        value = millimetres(text) / INCH
        text = str(int(value / Decimal("0.0001"))) if thousandths(definition) else real_text(value)
    return print_form(
        definition.statements[binding.statement].form,
        {"axis": entry.address, "key": key, binding.field: text},
    )


def millimetres(text: str) -> Decimal:
    """Return a length of the entries in mm or deg: without a point it counts thousandths."""
    return Decimal(text) * (Decimal("0.001") if "." not in text else 1)


def _point_lines(definition: Definition, entry: Entries) -> Iterator[str]:
    form = definition.statements[definition.bindings["value"].statement].form
    for number, value in entry.points.items():
        yield print_form(form, {"number": str(POINTS_FROM + number), "value": str(value)})


def write_programs(definition: Definition, entries: Sequence[Entries]) -> tuple[ControlFile, ...]:
    """Return one program per axis that enters the same values while it runs (G10), as the
    definition's optional files say.
    """
    files = []
    for file in definition.writing:
        if not file.optional:
            continue
        for entry in entries:
            lines = [
                f"N{number}P{entry.address}R{text}"
                for quantity, text in entry.parameters.items()
                if quantity != "bidirectional" and (number := name_of(definition, quantity))
            ]
            lines += _program_bit(definition, file, entry)
            lines += [f"N{POINTS_FROM + number}R{value}" for number, value in entry.points.items()]
            files.append(_file(definition, file, entry, lines))
    return tuple(files)


def _program_bit(definition: Definition, file: WrittenFile, entry: Entries) -> list[str]:
    """Return the line that switches to one or two sets: single bits are known under G10 L52 only;
    else the engineer does it.
    """
    if not entry.switches:
        return []
    number, value = name_of(definition, "bidirectional"), entry.parameters["bidirectional"]
    if any("L52" in line for line in file.header):
        return [f"N{number}P{entry.address}Q0R{value}"]
    return [f"(SET BIT 0 OF {number} FOR AXIS {entry.address} TO {value} BY HAND)"]


def sheet_rows(definition: Definition, entry: Entries) -> tuple[SheetRow, ...]:
    """Return what an engineer types in: the parameters, then every point with the position of the
    section's upper end.
    """
    unit = {"table_spacing": entry.kind.unit, "turn": entry.kind.unit}
    rows = []
    for quantity, text in entry.parameters.items():
        number = name_of(definition, quantity)
        value = text
        if quantity in unit and "." not in text:
            value = real_text(Decimal(text) / 1000)
        if quantity == "bidirectional":
            rows.append(SheetRow(f"{number}#0", "", value, ""))
        else:
            rows.append(SheetRow(number, "", value, unit.get(quantity, "pulse")))
    first = entry.place.negative_first
    count = entry.place.last - entry.place.first
    for point, increment in entry.points.items():
        shift = (
            first - entry.place.first
            if first is not None and first <= point <= first + count
            else 0
        )
        step = point - shift - entry.place.reference
        rows.append(
            SheetRow(
                str(POINTS_FROM + point),
                f"{entry.reference + step * entry.interval:.10g}",
                str(increment),
                "pulse",
            )
        )
    return tuple(rows)
