"""Change values in the control's own files; everything else keeps its bytes.

Values keep their decimal places, signs and blanks as far as the new values allow. New rows are put
after the last row of the table, as copies of it. Rows that the new table does not use get zero. A
changed line loses its checksum, which would be wrong.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.text.gathering import FoundValue, Gathered, same_value
from compwright.formats.text.patching import Patches, set_field
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class TablePlaces:
    """The lines of a table in the files: its rows by index, and its single values by quantity.

    ``value``: the quantity of the value in a row. ``named``: the fields that every line of the
    table has, with their texts (axis and measuring system, or table).
    """

    rows: Mapping[int, Sequence[FoundValue]]
    singles: Mapping[str, Sequence[FoundValue]]
    value: str
    named: Mapping[str, str]

    @property
    def anywhere(self) -> bool:
        """Whether the files contain any value of the table."""
        return bool(self.rows) or any(self.singles.values())


class OwnFiles(Patches):
    """Records the changes of values in a control's own files.

    ``gathered``: the values in the files.
    """

    def __init__(
        self, definition: Definition, files: Sequence[ControlFile], gathered: Gathered
    ) -> None:
        super().__init__(definition.dialect, files)
        self.definition = definition
        self.gathered = gathered

    def put(self, quantity: str, places: Sequence[FoundValue], text: str) -> bool:
        """Set a single value in the lines from which the control takes it; return False if no line
        states the value.
        """
        binding = self.definition.bindings[quantity]
        by_file: dict[int, list[FoundValue]] = {}
        for place in places:
            by_file.setdefault(place.number, []).append(place)
        for group in by_file.values():
            for place in {"same": group, "first": group[:1], "last": group[-1:]}[binding.repeated]:
                self._set(place.occurrence, place.number, binding.field, text)
        return bool(places)

    def put_table(
        self, places: TablePlaces, rows: Sequence[str], singles: Mapping[str, str]
    ) -> None:
        """Set the values of a table that is already in the files.

        ``rows``: the values by index, as text. ``singles``: the single values by quantity, as text.
        Missing rows and single values are put after the last row, or after the last line of the
        table if it has no rows.
        """
        field = self.definition.bindings[places.value].field
        for index, founds in places.rows.items():
            for found in founds:
                self._set(
                    found.occurrence, found.number, field, rows[index] if index < len(rows) else "0"
                )
        anchor = _last(places)
        missing = [index for index in range(len(rows)) if index not in places.rows]
        added = [self._row(anchor, places, index, rows[index]) for index in missing]
        added += [
            self._single(places, quantity, text)
            for quantity, text in singles.items()
            if not self.put(quantity, places.singles.get(quantity, ()), text)
        ]
        self._add(anchor, added)

    def put_after_table(self, places: TablePlaces, number: int, quantity: str, text: str) -> None:
        """Add a single value on its own line after all lines of a table in one file."""
        lines = [
            found
            for group in (*places.rows.values(), *places.singles.values())
            for found in group
            if found.number == number
        ]
        anchor = max(lines, key=lambda found: found.occurrence.line)
        self._add(anchor, [self._single(places, quantity, text)])

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
        self.replace(number, *set_field(occurrence, field, styled(old, text)))

    def _add(self, anchor: FoundValue, lines: Sequence[str]) -> None:
        self.add_lines(anchor.number, next(iter(anchor.occurrence.tokens.values())).start, lines)

    def _row(self, anchor: FoundValue, places: TablePlaces, index: int, text: str) -> str:
        """Return a line for a new value: a copy of a neighbouring row with the index and the value
        of the new row.

        The copy has no block number and no comment. If the table has no row yet, the line is made
        from the definition.
        """
        binding = self.definition.bindings[places.value]
        if not places.rows:
            return print_form(
                self.definition.statements[binding.statement].form,
                {**places.named, "index": str(index), binding.field: text},
            )
        value = styled(anchor.occurrence.tokens[binding.field].text, text)
        texts = {"index": str(index), binding.field: value}
        copy = self.like(anchor.number, anchor.occurrence, texts, end=binding.field)
        letter = self.definition.dialect.block_number
        if letter is None:
            return copy
        return re.sub(rf"^([ \t]*){letter}[0-9]+[ \t]+", r"\1", copy, count=1, flags=re.IGNORECASE)

    def _single(self, places: TablePlaces, quantity: str, text: str) -> str:
        binding = self.definition.bindings[quantity]
        return print_form(
            self.definition.statements[binding.statement].form,
            {**places.named, binding.field: text},
        )


def styled(old: str, new: str) -> str:
    """Return the new number in the style of the old one: its decimals, and its plus sign.

    If one of the texts is not a number, the new text is returned unchanged.
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


def _last(places: TablePlaces) -> FoundValue:
    """Return the row of a table with the highest index; without rows, the last single value."""
    if places.rows:
        return places.rows[max(places.rows)][-1]
    found = [place for singles in places.singles.values() for place in singles]
    return max(found, key=lambda place: (place.number, place.occurrence.line))


def rows_by_index(places: Sequence[FoundValue]) -> dict[int, list[FoundValue]]:
    """Return the rows of a table by their index."""
    rows: dict[int, list[FoundValue]] = {}
    for place in places:
        rows.setdefault(int(place.occurrence.tokens["index"].text), []).append(place)
    return rows
