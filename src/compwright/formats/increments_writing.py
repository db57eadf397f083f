"""Compensation -> whole increments by section (FANUC): into the user's own backup where one was given, else minimal files.

Only what belongs to the axis under work is written: its groups in lines that axes share, single bits, its own point numbers. Every
other byte of a backup stays.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.entry_sheet import SheetRow, is_entry_sheet
from compwright.formats.gathering import Found, Gathered, gather
from compwright.formats.numbering import NoRoom, Place, find_place
from compwright.formats.options import axis_options
from compwright.formats.patching import Change, apply_changes, set_field
from compwright.formats.scale import NotHeld, Scale
from compwright.formats.schema import Choice, Definition, WrittenFile
from compwright.formats.section_increments import POINTS_FROM, increment_limit, read_texts, thousandths, used_numbers
from compwright.formats.statements import print_form
from compwright.foundations.errors import CapacityError, Fault, InputError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

#: How far a node may be from its place on the grid, in spacings: arithmetic dust, not a wrong grid.
_ON_GRID = 1e-6


@dataclass(frozen=True, slots=True)
class Entries:
    """What goes into the control for one axis: parameters by quantity, as text, and increments by point number.

    ``cleared``: numbers that the axis no longer uses. ``kind`` decides the letter of a length.
    """

    address: str
    name: str
    kind: AxisKind
    parameters: Mapping[str, str]
    points: Mapping[int, int]
    cleared: tuple[int, ...]
    interval: float
    reference: float
    place: Place


def write_increments(
    definition: Definition,
    pairs: Sequence[tuple[str, Axis, AxisCompensation]],
    options: Mapping[str, object],
    state: ControlState | None,
    files: Sequence[ControlFile],
) -> tuple[ControlFile, ...]:
    """Return the files that put the compensations (address, axis, table) into the control; ``files``: its own, to be patched.

    Raises CapacityError with everything that the control cannot hold.
    """
    entries = all_entries(definition, pairs, options, state)
    faults: list[Fault] = []
    own = [file for file in files if not is_entry_sheet(file)]
    patched = _Patcher(definition, own)
    fresh = [file for entry in entries for file in _fresh(definition, entry, patched.put(entry, faults))]
    raise_all(CapacityError, faults)
    return (*patched.files(entries), *fresh)


def all_entries(
    definition: Definition,
    pairs: Sequence[tuple[str, Axis, AxisCompensation]],
    options: Mapping[str, object],
    state: ControlState | None,
) -> tuple[Entries, ...]:
    """Return what has to be entered for each axis; the axes get point numbers apart from each other and from all others'."""
    facts = state.facts if state is not None else {}
    used = used_numbers(facts, [address for address, _, _ in pairs])
    faults: list[Fault] = []
    entries: list[Entries] = []
    for address, axis, compensation in pairs:
        try:
            entry = _Axis(definition, address, axis, compensation, axis_options(definition, options, axis), facts).entries(used)
        except NotHeld as error:
            faults.append(Fault(message=f"axis {axis.name} ({address}): {error}"))
            continue
        except CapacityError as error:
            faults.extend(error.faults)
            continue
        used = [*used, *entry.place.ranges]
        entries.append(entry)
    raise_all(CapacityError, faults)
    return tuple(entries)


class _Axis:
    """One axis' table as whole numbers."""

    def __init__(
        self,
        definition: Definition,
        address: str,
        axis: Axis,
        compensation: AxisCompensation,
        options: Mapping[str, object],
        facts: Mapping[str, Mapping[str, object]],
    ) -> None:
        self.definition = definition
        self.address = address
        self.axis = axis
        self.compensation = compensation
        self.options = options
        self.facts = facts.get(address, {})
        self.scale = Scale(definition, axis.kind, options, {})
        self.unit = self.scale.quantum("value")

    def entries(self, used: Sequence[range]) -> Entries:
        steps, interval = self._grid()
        home = self.compensation.reference_return
        own, other = (self._counts(self.compensation.curve(side)) for side in (home, home.opposite))
        two = not np.array_equal(own, other)
        self._check_pair(own, steps, two=two)
        sets = [own, other] if two else [own]
        magnification = self._magnification([np.diff(counts) for counts in sets])
        place = self._place(int(steps[0]), int(steps[-1]), used, two=two)
        # The positive set comes first in the numbers, whichever direction is the zero state's.
        positive, negative = (own, other) if home is Direction.POSITIVE else (other, own)
        points = self._points(positive, steps, place.first, place.reference, magnification)
        if two and place.negative_first is not None:
            shift = place.negative_first - place.first
            points |= {
                number + shift: value
                for number, value in self._points(negative, steps, place.first, place.reference, magnification).items()
            }
        parameters = {
            "reference_number": str(place.reference),
            "first_number": str(place.first),
            "last_number": str(place.last),
            "magnification": str(magnification),
            "table_spacing": self._length(interval),
            "backlash": self.scale.write("backlash", self.compensation.backlash),
            "bidirectional": "1" if two else "0",
        }
        if self.axis.modulo is not None:
            parameters["turn"] = self._length(float(self.axis.modulo))
        if two:
            parameters["negative_first"] = str(place.negative_first)
            parameters["negative_offset"] = self._offset(other[steps == 0][0], magnification)
        return Entries(
            address=self.address,
            name=self.axis.name,
            kind=self.axis.kind,
            parameters=parameters,
            points=dict(sorted(points.items())),
            cleared=self._cleared(points, used),
            interval=interval,
            reference=self.axis.reference,
            place=place,
        )

    def _grid(self) -> tuple[FloatArray, float]:
        """Return the nodes as whole spacings from the reference, and the spacing."""
        positions = self.compensation.positions
        interval = float(positions[-1] - positions[0]) / (positions.size - 1)
        ratio = (positions - self.axis.reference) / interval
        steps: FloatArray = np.round(ratio)
        worst = float(np.max(np.abs(ratio - steps)))
        if worst > _ON_GRID:
            raise NotHeld(
                f"the points must lie at the reference position ({self.axis.reference:g}) plus whole intervals of {interval:.9g}; "
                f"one lies {worst * interval:.6g} {self.axis.kind.unit} away"
            )
        if not steps[0] <= 0 <= steps[-1]:
            raise NotHeld("the table must reach from the reference position, from which the control counts")
        return steps, interval

    def _counts(self, curve: FloatArray) -> FloatArray:
        counts: FloatArray = np.round(curve / self.unit)
        worst = int(np.argmax(np.abs(curve / self.unit - counts)))
        if abs(curve[worst] / self.unit - counts[worst]) > 1e-3:
            raise NotHeld(f"{curve[worst]:.9g} {self.axis.kind.unit} is not a multiple of the detection unit {self.unit:g}")
        return counts

    def _check_pair(self, own: FloatArray, steps: FloatArray, *, two: bool) -> None:
        if own[steps == 0][0] != 0:
            raise NotHeld("the table is not zero at the reference position in the direction of the reference return")
        if two and self.compensation.backlash != 0:
            raise NotHeld("two tables and a backlash value at once would compensate the reversal twice")
        if self.axis.modulo is not None:
            if two:
                raise NotHeld("two tables on an endless axis: nothing confirmed is known about how the control closes them")
            if own[0] != own[-1]:
                raise NotHeld(
                    f"the table of an endless axis must close: it creeps by {own[-1] - own[0]:g} detection units each turn"
                )

    def _magnification(self, differences: Sequence[FloatArray]) -> int:
        """Return the smallest magnification that divides every increment and keeps it within the limit."""
        steps = np.concatenate(differences).astype(np.int64)
        limit = increment_limit(self.options)
        most = self.definition.limit_number("max_magnification") or 1
        divisor = int(np.gcd.reduce(np.abs(steps))) or 1
        largest = int(np.max(np.abs(steps), initial=0))
        for candidate in range(1, most + 1):
            if divisor % candidate == 0 and largest <= limit * candidate:
                return candidate
        raise NotHeld(
            f"an increment of {largest} detection units is more than the control holds: at most {limit} times the magnification, "
            f"which must divide all increments (their greatest common divisor is {divisor}); a smaller spacing would help"
        )

    def _place(self, low: int, high: int, used: Sequence[range], *, two: bool) -> Place:
        own = self.facts.get("reference_number")
        last = self.facts.get("highest_number")
        try:
            return find_place(
                low,
                high,
                highest=self.definition.limit_number("max_number") or 0,
                used=used,
                two=two,
                reference=int(own) if isinstance(own, int) and isinstance(last, int) and last > 0 else None,
                start=int(str(self.options.get("first_point", 0))),
            )
        except NoRoom as error:
            raise NotHeld(str(error)) from error

    def _points(self, counts: FloatArray, steps: FloatArray, first: int, reference: int, magnification: int) -> dict[int, int]:
        sign = -1 if self.options.get("pitch_sign") == "-" else 1
        increments = (np.diff(counts) / magnification).astype(np.int64) * sign
        points = {reference + int(step): int(value) for step, value in zip(steps[1:], increments, strict=True)}
        if self.axis.modulo is not None:
            points[reference] = points[reference + int(steps[-1])]
        elif steps[0] == 0:  # travel that starts at the reference: 3621 must not lie above 3620
            points[first] = 0
        if steps[-1] == 0:  # travel that ends at the reference: 3622 must lie above 3620
            points[reference + 1] = 0
        return points

    def _offset(self, count: float, magnification: int) -> str:
        sign = -1 if self.options.get("offset_sign") == "-" else 1
        if self.options.get("offset_magnified") == "yes":
            if count % magnification:
                raise NotHeld(f"3627 counts in steps of the magnification {magnification}; {count:g} is none")
            count /= magnification
        return str(int(count) * sign)

    def _length(self, value: float) -> str:
        """Return a length in mm or deg exactly, as the control's text wants it."""
        count = Decimal(repr(round(value, 9)))
        digits = Decimal("0.001")
        if count != count.quantize(digits):
            raise NotHeld(f"{value:.9g} {self.axis.kind.unit} has more than three decimal places")
        if thousandths(self.definition):
            return str(int(count / digits))
        return real_text(count)

    def _cleared(self, points: Mapping[int, int], used: Sequence[range]) -> tuple[int, ...]:
        first, last = self.facts.get("first_number"), self.facts.get("highest_number")
        if not (self.facts.get("enabled") and isinstance(first, int) and isinstance(last, int)):
            return ()
        return tuple(
            number for number in range(first, last + 1) if number not in points and not any(number in taken for taken in used)
        )


def real_text(value: Decimal) -> str:
    """Return a number as the control's own files write it: a decimal point and at least one decimal (``50.0``)."""
    text = f"{value.normalize():f}"
    return text if "." in text else f"{text}.0"


class _Patcher:
    """Collects the changes to the user's own files."""

    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        self.definition = definition
        self.own = list(files)
        self.changes: dict[int, list[Change]] = {number: [] for number in range(len(files))}
        self.gathered: Gathered | None = None
        self.rows: dict[int, list[Found]] = {}
        if files:
            found: list[Fault] = []
            texts = read_texts(definition, files, found)
            raise_all(InputError, found)
            self.gathered = gather(definition, texts)
            for rows in self.gathered.file_rows.values():
                for row in rows:
                    self.rows.setdefault(int(row.occurrence.tokens["number"].text) - POINTS_FROM, []).append(row)

    def put(self, entry: Entries, faults: list[Fault]) -> Entries:
        """Note the changes for one axis and return what has no place in the user's files."""
        left = {name: text for name, text in entry.parameters.items() if not self._parameter(entry, name, text)}
        if left.pop("bidirectional", "0") == "1":
            faults.append(
                Fault(
                    message=f"axis {entry.name} ({entry.address}): two tables need bit 3605#0, which is changed only in "
                    "content that was read from the control",
                    expected="the control's own parameter file with 3605 among the files of the state",
                )
            )
        missing = {number: value for number, value in entry.points.items() if not self._point(number, value)}
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
            changes = self.changes[place.number]
            value = text
            if quantity in ("table_spacing", "turn"):
                value, key = self._length_there(place, entry, text)
                changes.extend(_changed(place, "key", key))
            if isinstance(binding, Choice) and place.text == value:
                continue
            changes.extend(_changed(place, binding.field, value))
        return bool(places)

    def _length_there(self, place: Found, entry: Entries, text: str) -> tuple[str, str]:
        """Return text and letter of a length: in thousandths or with a decimal point, as the file has it."""
        value = Decimal(text) * (Decimal("0.001") if "." not in text else 1)
        key = place.occurrence.tokens["key"].text
        if entry.kind is AxisKind.LINEAR:
            inch = any(found.text == "1" for found in self._machine("length_unit"))
            if key.upper() == "I" or (key.upper() == "P" and inch):
                key = "M"  # the control turns metric into its own unit
        if thousandths(self.definition) and "." not in place.text:
            return str(int(value / Decimal("0.001"))), key
        return real_text(value), key

    def _machine(self, quantity: str) -> list[Found]:
        return [] if self.gathered is None else self.gathered.singles.get((None, None), {}).get(quantity, [])

    def _point(self, number: int, value: int) -> bool:
        rows = self.rows.get(number, [])
        for row in rows:
            self.changes[row.number].extend(_changed(row, "value", str(value)))
        return bool(rows)

    def _insert(self, missing: Mapping[int, int]) -> None:
        """Put points that the files do not hold behind the nearest lower one, in the style of that line."""
        known = sorted(self.rows)
        for number, value in sorted(missing.items()):
            below = [one for one in known if one < number]
            neighbour = self.rows[below[-1] if below else known[0]][-1]
            content = self.own[neighbour.number].content
            start, end = _line_of(content, neighbour.occurrence.tokens["number"].start, self.definition.dialect.newlines_read)
            tokens = neighbour.occurrence.tokens
            line = apply_changes(
                content[start:end],
                [
                    Change(tokens["number"].start - start, tokens["number"].end - start, str(POINTS_FROM + number).encode()),
                    Change(tokens["value"].start - start, tokens["value"].end - start, str(value).encode()),
                ],
            )
            where = end if below else start
            self.changes[neighbour.number].append(Change(where, where, line))

    def files(self, entries: Sequence[Entries]) -> tuple[ControlFile, ...]:
        """Return the user's files that say something of the axes or hold point data, with all changes made."""
        if self.gathered is None:
            return ()
        addresses = {entry.address for entry in entries}
        speaking = {row.number for rows in self.rows.values() for row in rows}
        for (address, _), singles in self.gathered.singles.items():
            if address in addresses:
                speaking |= {place.number for places in singles.values() for place in places}
        return tuple(
            ControlFile(file.name, apply_changes(file.content, self.changes[number]))
            for number, file in enumerate(self.own)
            if number in speaking
        )


def _changed(place: Found, field: str, text: str) -> tuple[Change, ...]:
    """Return the change of a field, none where it says the same already: a value that stays keeps its bytes."""
    token = place.occurrence.tokens[field]
    same = token.text == text or (field != "key" and _equal(token.text, text))
    return () if same else set_field(place.occurrence, field, text)


def _equal(one: str, other: str) -> bool:
    return ("." in one) == ("." in other) and Decimal(one) == Decimal(other)


def _line_of(content: bytes, place: int, newlines: Sequence[str]) -> tuple[int, int]:
    """Return start and end (behind the line end) of the line in which ``place`` lies."""
    start = max(content.rfind(b"\n", 0, place), content.rfind(b"\r", 0, place)) + 1
    ends = sorted((newline.encode() for newline in newlines), key=len, reverse=True)
    end = content.find(b"\n", place)
    carriage = content.find(b"\r", place)
    if carriage >= 0 and (end < 0 or carriage < end):
        end = carriage
    if end < 0:
        return start, len(content)
    return start, end + next((len(mark) for mark in ends if content.startswith(mark, end)), 1)


def _fresh(definition: Definition, entry: Entries, left: Entries) -> Iterator[ControlFile]:
    """Yield minimal files with what found no place in the user's own."""
    for file in definition.writing:
        if file.optional:
            continue
        lines = list(_point_lines(definition, left)) if file.rows else list(_parameter_lines(definition, left))
        if lines:
            yield _file(definition, file, entry, lines)


def _file(definition: Definition, file: WrittenFile, entry: Entries, lines: Sequence[str]) -> ControlFile:
    newline = definition.dialect.newline
    named = {"axis": entry.address, "name": entry.name}
    text = "".join(print_form(line, named) + newline for line in (*file.header, *lines, *file.footer))
    return ControlFile(print_form(file.name, named), text.encode("ascii", "replace"))


def _parameter_lines(definition: Definition, entry: Entries) -> Iterator[str]:
    for quantity in (*definition.layout.singles, "table_spacing"):
        if quantity in entry.parameters:
            yield _parameter_line(definition, quantity, entry, entry.parameters[quantity])


def _parameter_line(definition: Definition, quantity: str, entry: Entries, text: str) -> str:
    binding = definition.bindings[quantity]
    key = "P" if thousandths(definition) or entry.kind is AxisKind.ROTARY else "M"
    return print_form(definition.statements[binding.statement].form, {"axis": entry.address, "key": key, binding.field: text})


def _point_lines(definition: Definition, entry: Entries) -> Iterator[str]:
    form = definition.statements[definition.bindings["value"].statement].form
    for number, value in entry.points.items():
        yield print_form(form, {"number": str(POINTS_FROM + number), "value": str(value)})


def write_programs(definition: Definition, entries: Sequence[Entries]) -> tuple[ControlFile, ...]:
    """Return one program per axis that enters the same values while it runs (G10), as the definition's optional files say."""
    files = []
    for file in definition.writing:
        if not file.optional:
            continue
        for entry in entries:
            lines = [
                f"N{number}P{entry.address}R{text}"
                for quantity, text in entry.parameters.items()
                if quantity != "bidirectional" and (number := parameter_number(definition, quantity))
            ]
            lines += [f"N{POINTS_FROM + number}R{value}" for number, value in entry.points.items()]
            files.append(_file(definition, file, entry, lines))
    return tuple(files)


def parameter_number(definition: Definition, quantity: str) -> str:
    """Return the number of a parameter, without leading zeros."""
    form = definition.statements[definition.bindings[quantity].statement].form
    digits = form.split("#", 1)[1]
    return digits[: next((place for place, letter in enumerate(digits) if not letter.isdigit()), len(digits))].lstrip("0")


def sheet_rows(definition: Definition, entry: Entries) -> tuple[SheetRow, ...]:
    """Return what an engineer types in: the parameters, then every point with the position of the section's upper end."""
    unit = {"table_spacing": entry.kind.unit, "turn": entry.kind.unit}
    rows = []
    for quantity, text in entry.parameters.items():
        number = parameter_number(definition, quantity)
        value = text
        if quantity in unit and "." not in text:
            value = real_text(Decimal(text) / 1000)
        rows.append(SheetRow(f"{number}#0" if quantity == "bidirectional" else number, "", value, unit.get(quantity, "pulse")))
    first = entry.place.negative_first
    count = entry.place.last - entry.place.first
    for point, increment in entry.points.items():
        shift = first - entry.place.first if first is not None and first <= point <= first + count else 0
        step = point - shift - entry.place.reference
        rows.append(SheetRow(str(POINTS_FROM + point), f"{entry.reference + step * entry.interval:.10g}", str(increment), "pulse"))
    return tuple(rows)
