"""Collect the statements of several files as values by axis and measuring system."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from decimal import Decimal, InvalidOperation
from typing import NamedTuple

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Binding, Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.text.addresses import AxisNames, normal_text
from compwright.formats.text.texts import ReadText

#: Address and measuring system (as counted in the text); None: the text has none of it.
Key = tuple[str | None, str | None]
_TRUTH = {"TRUE": "1", "FALSE": "0"}


class FoundValue(NamedTuple):
    """One value as written in a file. ``number``: the index of its file."""

    text: str
    occurrence: Occurrence
    number: int

    @property
    def where(self) -> str:
        """The file and line of the value, as text for messages."""
        return f"{self.occurrence.file}, line {self.occurrence.line}"


@dataclass(slots=True)
class Gathered:
    """All values in the files by axis and measuring system.

    ``singles``: the values of each quantity, ``singles[key][quantity]``. ``rows``: the lines of the
    table, ``rows[key]``. A key is the address and the measuring system. Both are in the order of
    the files.
    """

    definition: Definition
    singles: dict[Key, dict[str, list[FoundValue]]] = field(default_factory=dict)
    rows: dict[Key, list[FoundValue]] = field(default_factory=dict)
    file_rows: dict[int, list[FoundValue]] = field(default_factory=dict)
    file_names: dict[int, str] = field(default_factory=dict)
    sections: list[str] = field(default_factory=list)
    names: AxisNames = field(default_factory=AxisNames)
    #: How the files write each axis where they speak of it, in the order of their first appearance.
    spellings: dict[str, list[str]] = field(default_factory=dict)
    #: The files (by their place among those given) that list the names of the axes.
    naming: set[int] = field(default_factory=set)

    def axis(self, text: str) -> str:
        """Return the address of the axis that has this name in the files."""
        return self.names.address(normal_text(self.definition, text))

    def spelled(self, address: str) -> str:
        """Return the axis name as it is written in the files; the address if they do not name the
        axis.
        """
        return self.spellings.get(address, [address])[0]

    def addresses(self) -> list[str]:
        """Return the axis addresses in the files, in the order of their first appearance.

        If the control numbers measuring systems, an axis is listed only if a line names it with a
        measuring system. Settings of the whole axis, such as its kind, are not enough.
        """
        counted = any(
            "system" in statement.fields for statement in self.definition.statements.values()
        )
        keys = (key for key in (*self.singles, *self.rows) if key[1] is not None or not counted)
        return list(dict.fromkeys(address for address, _ in keys if address is not None))

    def systems(self, address: str) -> list[str]:
        """Return the measuring systems of an address in the files, in order."""
        return sorted(
            {
                system
                for found, system in (*self.singles, *self.rows)
                if found == address and system is not None
            }
        )

    def found(self, quantity: str, address: str, system: str | None) -> list[FoundValue]:
        """Return the values of a quantity for the measuring system; if there are none, for the
        axis; else for the whole machine.
        """
        for key in ((address, system), (address, None), (None, None)):
            places = self.singles.get(key, {}).get(quantity)
            if places:
                return places
        return []


def gather(
    definition: Definition, texts: Iterable[ReadText], names: AxisNames | None = None
) -> Gathered:
    """Return the statements of all files, sorted by axis and measuring system. ``names``: the names
    that the files give to each axis; None: each name is another axis.
    """
    result = Gathered(definition, names=names or AxisNames())
    table_statement = definition.bindings[curves(definition)[0]].statement
    by_statement: dict[str, list[Binding]] = {}
    for binding in definition.bindings.values():
        by_statement.setdefault(binding.statement, []).append(binding)
    for text in texts:
        result.file_names[text.number] = text.file
        result.sections.extend(text.sections)
        for occurrence in text.occurrences:
            key = _key(result, occurrence)
            if occurrence.statement == table_statement:
                row = FoundValue("", occurrence, text.number)
                if key[0] is None:
                    result.file_rows.setdefault(text.number, []).append(row)
                else:
                    result.rows.setdefault(key, []).append(row)
                continue
            for binding in by_statement.get(occurrence.statement, ()):
                found = FoundValue(occurrence.tokens[binding.field].text, occurrence, text.number)
                if binding.quantity == "machine_axis":
                    result.naming.add(text.number)
                result.singles.setdefault(key, {}).setdefault(binding.quantity, []).append(found)
    return result


def _key(gathered: Gathered, occurrence: Occurrence) -> Key:
    axis = occurrence.tokens.get("axis")
    system = occurrence.tokens.get("system")
    address = None if axis is None else gathered.axis(axis.text)
    if axis is not None and address is not None and system is not None:
        forms = gathered.spellings.setdefault(address, [])
        form = normal_text(gathered.definition, axis.text)
        if form not in forms:
            forms.append(form)
    return address, None if system is None else str(int(system.text))


def first_set(places: Sequence[FoundValue]) -> list[FoundValue]:
    """Return the values of the first parameter set (0), and values on lines that name no set."""
    return [
        place
        for place in places
        if "set" not in place.occurrence.tokens or int(place.occurrence.tokens["set"].text) == 0
    ]


def same_value(one: str, other: str) -> bool:
    """Return whether two texts are the same number or the same text."""
    if one == other:
        return True
    one, other = _TRUTH.get(one.upper(), one), _TRUTH.get(other.upper(), other)
    if one == other:
        return True
    try:
        return Decimal(one) == Decimal(other)
    except InvalidOperation:
        return False
