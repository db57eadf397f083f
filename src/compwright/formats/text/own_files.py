"""The control's own files, changed in place: what differs, and nothing else.

Values keep their decimal places, signs and blanks as far as the new ones allow; rows are added
behind the last one, as a copy of that line; rows that the new table does not use become zero. A
line that changes loses its checksum.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.text.gathering import Found, Gathered, gather, same_value
from compwright.formats.text.patching import Change, apply_changes, set_field
from compwright.formats.text.texts import Line, text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class TablePlaces:
    """Where a table stands: its rows by index, and its single values by quantity.

    ``value``: the quantity of a row's value; ``named``: the fields that every line of the table has
    (axis and system, or table).
    """

    rows: Mapping[int, Sequence[Found]]
    singles: Mapping[str, Sequence[Found]]
    value: str
    named: Mapping[str, str]

    @property
    def anywhere(self) -> bool:
        """Whether the files hold anything of the table."""
        return bool(self.rows) or any(self.singles.values())


class OwnFiles:
    """Collects the changes. ``asked``: the addresses of the axes under work. Raises InputError when
    the files cannot be read.
    """

    def __init__(
        self, definition: Definition, files: Sequence[ControlFile], asked: Sequence[str] = ()
    ) -> None:
        self.definition = definition
        self.files = list(files)
        self.reader = text_reader(definition)
        faults: list[Fault] = []
        texts = [self.reader.read(file, faults, number) for number, file in enumerate(self.files)]
        raise_all(InputError, faults)
        self.gathered: Gathered = gather(
            definition, [text for text in texts if text is not None], asked
        )
        self.lines = [self.reader.lines(file.content.decode("latin-1")) for file in self.files]
        self.changes: dict[int, dict[tuple[int, int], Change]] = {}
        self.inserted: dict[tuple[int, int], list[str]] = {}

    def put(self, quantity: str, places: Sequence[Found], text: str) -> bool:
        """Set a single value where it counts (everywhere, or the first or last of each file); False
        where it stands nowhere.
        """
        binding = self.definition.bindings[quantity]
        by_file: dict[int, list[Found]] = {}
        for place in places:
            by_file.setdefault(place.number, []).append(place)
        for group in by_file.values():
            for place in {"same": group, "first": group[:1], "last": group[-1:]}[binding.repeated]:
                self._set(place.occurrence, place.number, binding.field, text)
        return bool(places)

    def put_table(
        self, places: TablePlaces, rows: Sequence[str], singles: Mapping[str, str]
    ) -> None:
        """Set a table that the files hold already: values by index, single values by quantity, all
        as text.

        What is missing is put behind the last row, or behind the last line of the table where there
        is no row.
        """
        field = self.definition.bindings[places.value].field
        for index, founds in places.rows.items():
            for found in founds:
                self._set(
                    found.occurrence, found.number, field, rows[index] if index < len(rows) else "0"
                )
        anchor = _last(places)
        missing = [index for index in range(len(rows)) if index not in places.rows]
        self.inserted.setdefault((anchor.number, anchor.occurrence.line), []).extend(
            self._row(anchor, places, index, rows[index]) for index in missing
        )
        for quantity, text in singles.items():
            if not self.put(quantity, places.singles.get(quantity, ()), text):
                self.inserted[(anchor.number, anchor.occurrence.line)].append(
                    self._single(places, quantity, text)
                )

    def put_behind(self, places: TablePlaces, number: int, quantity: str, text: str) -> None:
        """Put a single value on a line of its own behind everything of a table in one file."""
        lines = [
            found
            for group in (*places.rows.values(), *places.singles.values())
            for found in group
            if found.number == number
        ]
        anchor = max(lines, key=lambda found: found.occurrence.line)
        self.inserted.setdefault((number, anchor.occurrence.line), []).append(
            self._single(places, quantity, text)
        )

    def clear_rows(self, places: TablePlaces) -> None:
        """Set all values of a table to zero."""
        for founds in places.rows.values():
            for found in founds:
                self._set(
                    found.occurrence,
                    found.number,
                    self.definition.bindings[places.value].field,
                    "0",
                )

    def _set(self, occurrence: Occurrence, number: int, field: str, text: str) -> None:
        old = occurrence.tokens[field].text
        if same_value(old, text):
            return
        for change in set_field(occurrence, field, styled(old, text)):
            self.changes.setdefault(number, {})[(change.start, change.end)] = change

    def _row(self, anchor: Found, places: TablePlaces, index: int, text: str) -> str:
        """Return the line of a new value: the neighbouring row with other index and value, without
        block number and comment.
        """
        binding = self.definition.bindings[places.value]
        if not places.rows:
            return print_form(
                self.definition.statements[binding.statement].form,
                {**places.named, "index": str(index), binding.field: text},
            )
        tokens = anchor.occurrence.tokens
        line = self._line(anchor)
        end = tokens[binding.field].end - line.start
        value = tokens[binding.field]
        changes = [
            Change(
                tokens["index"].start - line.start,
                tokens["index"].end - line.start,
                str(index).encode(),
            ),
            Change(
                value.start - line.start, value.end - line.start, styled(value.text, text).encode()
            ),
        ]
        copy = apply_changes(line.text[:end].encode("latin-1"), changes).decode("latin-1")
        letter = self.definition.dialect.block_number
        return (
            copy
            if letter is None
            else re.sub(
                rf"^([ \t]*){letter}[0-9]+[ \t]+", r"\1", copy, count=1, flags=re.IGNORECASE
            )
        )

    def _single(self, places: TablePlaces, quantity: str, text: str) -> str:
        binding = self.definition.bindings[quantity]
        return print_form(
            self.definition.statements[binding.statement].form,
            {**places.named, binding.field: text},
        )

    def _line(self, place: Found) -> Line:
        return self.lines[place.number][place.occurrence.line - 1]

    def patched(self, speaking: Iterable[int]) -> tuple[ControlFile, ...]:
        """Return the files ``speaking`` (by their place among those given) with all changes
        made.
        """
        return tuple(self._patched(number) for number in sorted(set(speaking)))

    def changed(self) -> tuple[ControlFile, ...]:
        """Return the files that change, with all changes made."""
        numbers = {
            *self.changes,
            *(number for (number, _), lines in self.inserted.items() if lines),
        }
        return self.patched(numbers)

    def _patched(self, number: int) -> ControlFile:
        file = self.files[number]
        changes = list(self.changes.get(number, {}).values())
        for (owner, line_number), added in self.inserted.items():
            if owner == number and added:
                changes.append(self._insertion(number, self.lines[number][line_number - 1], added))
        return ControlFile(file.name, apply_changes(file.content, changes))

    def _insertion(self, number: int, line: Line, added: Sequence[str]) -> Change:
        """Return the change that puts lines behind one, each with that line's own end."""
        text = self.files[number].content.decode("latin-1")
        behind = line.start + len(line.text)
        match = self.reader.newline.match(text, behind)
        newline = match[0] if match is not None else self.definition.dialect.newline
        content = "".join(entry + newline for entry in added)
        if match is None:  # the last line has no end: it gets one, and the new last line none
            return Change(
                behind, behind, (newline + content).removesuffix(newline).encode("latin-1")
            )
        return Change(match.end(), match.end(), content.encode("latin-1"))


def styled(old: str, new: str) -> str:
    """Return a number as the file writes its own: at least as many decimal places as before and as
    it needs, its plus sign.

    Anything else than a number is taken as it stands.
    """
    try:
        value = Decimal(new)
        Decimal(old)
    except InvalidOperation:
        return new
    needed = max(0, -int(value.normalize().as_tuple().exponent)) if value else 0
    had = len(old.partition(".")[2])
    text = f"{value:.{max(needed, had)}f}" if value else f"{Decimal(0):.{had}f}"
    return f"+{text}" if old.startswith("+") and not text.startswith("-") else text


def _last(places: TablePlaces) -> Found:
    """Return the row with the highest index, else the last single value."""
    if places.rows:
        return places.rows[max(places.rows)][-1]
    found = [place for singles in places.singles.values() for place in singles]
    return max(found, key=lambda place: (place.number, place.occurrence.line))


def rows_by_index(places: Sequence[Found]) -> dict[int, list[Found]]:
    """Return the rows of a table by their index."""
    rows: dict[int, list[Found]] = {}
    for place in places:
        rows.setdefault(int(place.occurrence.tokens["index"].text), []).append(place)
    return rows
