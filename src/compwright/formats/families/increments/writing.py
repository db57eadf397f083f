"""Write compensations as FANUC pitch error data, into the user's backup or into new small files.

Only values of the axes of the job are changed: their values in lines that axes share, single bits,
and their own point numbers. All other bytes of a backup stay the same.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from compwright.formats.definition.schema import Choice, Definition, WrittenFile
from compwright.formats.definition.statements import print_form
from compwright.formats.families.family import AxisTable, Family, with_partners
from compwright.formats.families.increments.axis_values import length_text, thousandths
from compwright.formats.families.increments.entries import Entries, all_entries
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.parameters import AxisParameters, Parameters
from compwright.formats.families.increments.points import POINTS_FROM, point_number, point_rows
from compwright.formats.families.increments.reading import read_texts
from compwright.formats.text.entry_sheet import SheetRow, is_entry_sheet, write_sheet
from compwright.formats.text.gathering import FoundValue, gather
from compwright.formats.text.patching import BytesChange, Patches, fresh_file, set_field
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, InputError, UsageError, raise_all
from compwright.records.axis import AxisKind
from compwright.records.correction import ControlFile

#: The number in the form of a parameter.
_NUMBER = re.compile(r"[0-9]{5}")


def write_increments(
    family: Family, tables: Sequence[AxisTable], files: Sequence[ControlFile]
) -> tuple[ControlFile, ...]:
    """Return the files that load ``tables`` into the control.

    ``files``: the control's own files, in which values are changed. Raises CapacityError with every
    value that the control cannot hold.
    """
    entries = all_entries(family, tables)
    faults: list[Fault] = []
    own = [file for file in files if not is_entry_sheet(file)]
    patched = _OwnFiles(family.definition, own)
    names = {file.name for file in own}
    left = [patched.put(entry, faults) for entry in entries]
    if family.definition.limit("only_patching") is not None:
        faults.extend(fault for entry in left for fault in _homeless(family.definition, entry))
    fresh = [file for entry in left for file in _fresh(family.definition, entry, names)]
    raise_all(CapacityError, faults)
    return (*patched.changed_files({entry.address for entry in entries}), *fresh)


def _homeless(definition: Definition, left: Entries) -> Iterator[Fault]:
    """Yield a fault for each of the values ``left`` that must be in the control's own files, but
    has no line there.

    A definition requires this (limit ``only_patching``) if nothing else proves that the control has
    such a parameter.
    """
    numbers = [name_of(definition, name) for name in left.parameters]
    numbers += [f"N{POINTS_FROM + number}" for number in left.points]
    if numbers:
        rule = definition.limit("only_patching")
        evidence = "" if rule is None else f": {rule.evidence.source}"
        yield Fault(
            message=(
                f"axis {left.axis.name} ({left.address}): values of {definition.id} can be "
                f"written only into lines of the control's own files{evidence}"
            ),
            expected=f"lines of {', '.join(numbers[:8])}{' ..' if len(numbers) > 8 else ''} of axis"
            f" {left.address} among the control's files",
            found="none",
            hint=(
                "add the control's parameter file with these lines to its files (`states` or"
                " `--state`)"
            ),
        )


class _OwnFiles(Patches):
    """Collects the changes to parameters and points in the user's own files."""

    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        super().__init__(definition.dialect, files)
        self.definition = definition
        faults: list[Fault] = []
        texts = read_texts(definition, files, faults) if files else []
        raise_all(InputError, faults)
        self.gathered = gather(definition, texts)
        self.parameters = Parameters(self.files, definition.parameters)
        self.rows: dict[int, list[FoundValue]] = {}
        for row in point_rows(definition, self.gathered, self.files):
            self.rows.setdefault(point_number(row), []).append(row)

    def put(self, entry: Entries, faults: list[Fault]) -> Entries:
        """Record the changes for one axis; return the values for which the user's files have no
        line.
        """
        left = {
            name: value
            for name, value in entry.parameters.items()
            if not self._parameter(entry, name, value)
        }
        if left.pop("bidirectional", "0") == "1":
            expected = "the control's own parameter file with 3605 among the control's files"
            faults.append(
                Fault(
                    message=(
                        f"axis {entry.axis.name} ({entry.address}): two tables need bit "
                        "3605#0, and compwright changes this bit only in a file that was "
                        "read from the control"
                    ),
                    expected=expected,
                    hint="add the control's own file that contains it to `states` in the job",
                )
            )
        for number, value in {**entry.points, **dict.fromkeys(entry.cleared, 0)}.items():
            for row in self.rows.get(number, ()):
                self._set(row, "value", str(value))
        left_added = {
            number: count
            for number, count in entry.added.items()
            if not self._put_added(entry.address, number, count)
        }
        names = [file.name for file in self.files]
        for point, new in entry.moved:
            if point.file not in names:  # it was typed in: the sheet and a fresh line say it
                left_added |= {int(point.parameter): str(new)} if point.parameter else {}
                continue
            change = BytesChange(point.start, point.start + point.size, str(new).encode("ascii"))
            self.replace(names.index(point.file), change)
        missing = {
            number: value for number, value in entry.points.items() if number not in self.rows
        }
        if missing and self.rows:
            self._insert(missing)
            missing = {}
        return replace(entry, parameters=left, points=missing, added=left_added)

    def _put_added(self, address: str, number: int, text: str) -> bool:
        """Set a parameter of a new inclination or cyclic table; return whether the files contain
        it.
        """
        names = [file.name for file in self.files]
        places = [
            value
            for value in self.parameters.of([number])
            if value.whose == ("A", AxisParameters(self.parameters, address).index)
        ]
        for value in places:
            change = BytesChange(value.start, value.start + len(value.text), text.encode("ascii"))
            self.replace(names.index(value.file), change)
        return bool(places)

    def _parameter(self, entry: Entries, quantity: str, value: str | Decimal) -> bool:
        binding = self.definition.bindings.get(quantity)
        if binding is None:
            return False
        places = self.gathered.singles.get((entry.address, None), {}).get(quantity, [])
        for place in places:
            text = value if isinstance(value, str) else self._existing_length(place, entry, value)
            if not isinstance(binding, Choice) or place.text != text:
                self._set(place, binding.field, text)
        return bool(places)

    def _existing_length(self, place: FoundValue, entry: Entries, value: Decimal) -> str:
        """Return a length as text in the unit that the letter in its line states: M for mm, I for
        inch, P for the machine's unit.
        """
        key = place.occurrence.tokens["key"].text.upper()
        inch = key == "I" or (key == "P" and bool(entry.inch))
        whole = thousandths(self.definition) and "." not in place.text
        return length_text(value, inch=inch and entry.axis.kind is AxisKind.LINEAR, whole=whole)

    def _set(self, place: FoundValue, field: str, text: str) -> None:
        """Change the text of a field, unless it has the same value already."""
        old = place.occurrence.tokens[field].text
        if ("." in old) != ("." in text) or Decimal(old) != Decimal(text):
            self.replace(place.number, *set_field(place.occurrence, field, text))

    def _insert(self, missing: Mapping[int, int]) -> None:
        """Insert lines for missing points, each after the next lower point and in the style of its
        line.
        """
        for number, value in sorted(missing.items()):
            below = [one for one in self.rows if one < number]
            neighbour = self.rows[max(below) if below else min(self.rows)][-1]
            texts = {"number": str(POINTS_FROM + number), "value": str(value)}
            line = self.like(neighbour.number, neighbour.occurrence, texts)
            place = neighbour.occurrence.tokens["number"].start
            self.add_lines(neighbour.number, place, [line], before=not below)

    def changed_files(self, addresses: Collection[str]) -> tuple[ControlFile, ...]:
        """Return, with all changes, the user's files that name the axes or contain point data."""
        numbers = {row.number for rows in self.rows.values() for row in rows} | self.changed()
        for (address, _), singles in self.gathered.singles.items():
            if address in addresses:
                numbers |= {place.number for places in singles.values() for place in places}
        return self.patched(numbers)


def _fresh(definition: Definition, left: Entries, taken: Collection[str]) -> Iterator[ControlFile]:
    """Yield new small files with the values ``left``, which have no line in the user's files.
    ``taken``: file names that must not be used.
    """
    for file in definition.writing:
        lines = list(_point_lines(definition, left) if file.rows else _lines(definition, left))
        if lines and not file.optional:
            fresh = _file(definition, file, left, lines)
            name = fresh.name
            while name in taken:
                stem, dot, ending = name.rpartition(".")
                name = f"{stem}_MORE{dot}{ending}"
            yield replace(fresh, name=name)


def _file(
    definition: Definition, file: WrittenFile, entry: Entries, lines: Sequence[str]
) -> ControlFile:
    # Each axis' program has a number of its own: of two with one number the control keeps one.
    number = f"91{int(entry.address):02d}"
    named = {"axis": entry.address, "name": entry.axis.name, "program": number}
    return fresh_file(definition, file, print_form(file.name, named), named, lines).patched([0])[0]


def _lines(definition: Definition, entry: Entries) -> Iterator[str]:
    """Yield the lines for the parameters of an axis, in the order of the definition."""
    linear, whole = entry.axis.kind is AxisKind.LINEAR, thousandths(definition)
    # Where the control's own files say its unit, a fresh line has the letter that they have; else M
    # says that it is in mm.
    key = "P" if whole or not linear or entry.inch is not None else "M"
    for quantity in (*definition.layout.singles, "table_spacing"):
        value = entry.parameters.get(quantity)
        if value is None:
            continue
        if isinstance(value, Decimal):
            value = length_text(value, inch=linear and bool(entry.inch), whole=whole)
        binding = definition.bindings[quantity]
        form = definition.statements[binding.statement].form
        yield print_form(form, {"axis": entry.address, "key": key, binding.field: value})
    # A parameter of an added function has the form of the other whole numbers.
    form = definition.statements["reference_number"].form
    for number, count in entry.added.items():
        own = _NUMBER.sub(f"{number:05d}", form, count=1)
        yield print_form(own, {"axis": entry.address, "value": count})


def _point_lines(definition: Definition, entry: Entries) -> Iterator[str]:
    form = definition.statements[definition.bindings["value"].statement].form
    for number, value in entry.points.items():
        yield print_form(form, {"number": str(POINTS_FROM + number), "value": str(value)})


def write_programs(definition: Definition, entries: Sequence[Entries]) -> tuple[ControlFile, ...]:
    """Return a G10 program per axis that enters its values, if the definition has programs."""
    return tuple(
        _file(definition, file, entry, list(_program(definition, file, entry)))
        for file in definition.writing
        if file.optional
        for entry in entries
    )


def _program(definition: Definition, file: WrittenFile, entry: Entries) -> Iterator[str]:
    for quantity, value in entry.parameters.items():
        text = (
            value if isinstance(value, str) else length_text(value, whole=thousandths(definition))
        )
        if quantity != "bidirectional":
            yield f"N{name_of(definition, quantity)}P{entry.address}R{text}"
    for moved, new in entry.moved:
        by_hand = f"(SET {moved.label.upper()} TO {new} BY HAND)"
        yield f"N{moved.parameter}P{entry.address}R{new}" if moved.parameter else by_hand
    yield from (f"N{number}P{entry.address}R{count}" for number, count in entry.added.items())
    if entry.switches:  # single bits are known under G10 L52 only; else the engineer does it
        number, value = name_of(definition, "bidirectional"), entry.parameters["bidirectional"]
        known = any("L52" in line for line in file.header)
        by_hand = f"(SET BIT 0 OF {number} FOR AXIS {entry.address} TO {value} BY HAND)"
        yield f"N{number}P{entry.address}Q0R{value}" if known else by_hand
    yield from (f"N{POINTS_FROM + number}R{value}" for number, value in entry.points.items())


def sheet_rows(definition: Definition, entry: Entries) -> Iterator[SheetRow]:
    """Yield the rows that an engineer types in: parameters, then points with their section ends."""
    for quantity, value in entry.parameters.items():
        number = name_of(definition, quantity)
        if isinstance(value, Decimal):
            yield SheetRow(number, "", length_text(value), entry.axis.kind.unit)
        elif quantity == "bidirectional":
            yield SheetRow(f"{number}#0", "", value, "")
        else:
            yield SheetRow(number, "", value, "pulse")
    for moved, new in entry.moved:
        if moved.parameter:
            yield SheetRow(moved.parameter, "", str(new), "")
    for parameter, count in entry.added.items():
        yield SheetRow(str(parameter), "", count, "")
    place = entry.place
    for point, increment in entry.points.items():
        own = next((numbers for numbers in place.ranges if point in numbers), None)
        position = ""
        if own is not None:
            step = point - own.start + place.first - place.reference
            position = f"{entry.axis.reference + step * entry.interval:.10g}"
        yield SheetRow(str(POINTS_FROM + point), position, str(increment), "pulse")


_PULSE = (
    "whole detection units, before the magnification 3623; position: upper end of the point's"
    " section"
)


def increment_sheets(family: Family, own: Sequence[AxisTable]) -> tuple[ControlFile, ...]:
    """Return an entry sheet for each axis and, if an option requires them, the G10 programs that
    enter the values. ``own``: the tables, without those of gantry slaves.

    The sheets of gantry slaves are made from the tables of their masters.
    """
    definition = family.definition
    names = {address: axis.name for address, axis, _ in own}
    names |= {
        axis.gantry: f"{axis.name}_{axis.gantry}" for _, axis, _ in own if axis.gantry is not None
    }
    entries = all_entries(family, with_partners(family.definition, own))
    sheets = [
        write_sheet(
            f"entry_{names[entry.address]}.csv",
            (
                ("axis", entry.axis.name),
                ("address", entry.address),
                ("format", definition.id),
                ("value", "correction"),
                ("unit pulse", _PULSE),
            ),
            tuple(sheet_rows(definition, entry)),
        )
        for entry in entries
    ]
    if family.options.get("program") != "g10":
        return tuple(sheets)
    if any(increments_of(facts).inch for facts in family.state.facts.values()):
        raise UsageError(
            Fault(
                message=(
                    "the program cannot be written for an inch machine (1001#0): a program cannot "
                    "state its unit, and the intervals in mm are not whole numbers in inch"
                ),
                place="program",
                expected="no option `program`",
                found="program: g10",
                hint="leave the option `program` out, and type in the values of the commissioning "
                "card at the control",
            )
        )
    return (*sheets, *write_programs(definition, entries))
