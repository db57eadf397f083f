"""Axis addresses and names in the control's files, and the key that identifies an entry.

If the files list the names of an axis, all of them count as one axis, under the name by which it
was requested. Without such a list each name counts as an axis of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, field_matches
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis
from compwright.records.correction import Assumption
from compwright.words.sentences import control_text


def normal_text(definition: Definition, address: str) -> str:
    """Return an address in its standard spelling (``ax1`` -> ``AX1``, ``00`` -> ``0``).

    Raises UsageError if the control cannot have an axis with this address.
    """
    rule = definition.addresses
    text = address.strip()
    if not field_matches(rule.type, text):
        expected = (
            "a number" if rule.type == "integer" else "a name of letters, digits and _, such as AX1"
        )
        raise UsageError(
            Fault(
                message=f"an axis of {definition.id} cannot have this address",
                expected=expected,
                found=repr(address)[:40],
                hint=(
                    "set `address` of the axis in the job as the control names the axis; without a "
                    "job give `--option address=...`, with `compwright decode` give `--axis ...`"
                ),
            )
        )
    if rule.type == "integer":
        return str(int(text))
    return text.upper() if rule.case == "ignored" else text


def normal_address(definition: Definition, axis: Axis) -> tuple[str, Assumption | None]:
    """Return the control's address of an axis, with the assumption made if the job gives none.

    If the control numbers its axes and the job gives only an axis letter, the definition's list of
    letters (such as XYZABCUVW) is used. The number is then the index of the letter in this list.
    Raises UsageError if the control cannot have such an axis.
    """
    letters = definition.addresses.letters
    letter = axis.address.strip().upper()
    if letters is not None and len(letter) == 1 and letter in letters:
        number = str(letters.index(letter))
        return number, Assumption(
            fact=control_text("address of axis {name}", name=axis.name),
            value=number,
            evidence=definition.addresses.evidence.text,
        )
    try:
        return normal_text(definition, axis.address), None
    except UsageError as error:
        numbered = definition.addresses.type == "integer"
        what, example = ("number", "1") if numbered else ("address", "AX1")
        raise UsageError(
            Fault(
                message=f"{definition.id} needs the {what} of axis {axis.name}",
                expected=f"the {what} that it has in the control, such as {example}",
                found=error.faults[0].found,
                hint=(
                    f"look it up in the control, then add `address: {example}` to the axis in the "
                    f"job, or give `--option address={example}`, with your own value"
                ),
            )
        ) from error


@dataclass(frozen=True, slots=True)
class AxisNames:
    """The names that a control's files give to each axis, with the index of each axis (such as
    AX1).

    - ``places``: by name, the index of the axis.
    - ``machine``: the same for machine axis names only.
    - ``requested``: by index, the name under which the axis was requested.
    - ``place``: the form of an index; None if the control has none.
    """

    places: Mapping[str, str] = field(default_factory=dict)
    machine: Mapping[str, str] = field(default_factory=dict)
    requested: Mapping[str, str] = field(default_factory=dict)
    place: re.Pattern[str] | None = None

    def address(self, name: str) -> str:
        """Return the address of the axis with this name, or the name itself if the files do not
        list it.
        """
        place = self.places.get(name, name)
        return self.requested.get(place, place)

    def known(self, name: str) -> bool:
        """Return whether a name is that of a machine axis; True for every name if no file lists the
        axes.
        """
        return not self.places or name in self.places or self._is_place(name)

    def forms(self, address: str) -> set[str]:
        """Return the address of an axis and all other names that the files give to that axis."""
        one = self.address(address)
        return {
            address,
            one,
            *(name for name in (*self.places, *self.places.values()) if self.address(name) == one),
        }

    def unplaced(self, address: str, spoken_of: Iterable[str]) -> list[str]:
        """Return those of the names ``spoken_of`` that possibly mean the axis at ``address``,
        because the files assign them to no axis.

        There are two cases. If the address is an index (AX1) without a name in the files, these are
        all names without an index. If it is a name, these are all indices without a name.
        """
        place = self.places.get(address, address)
        named = {one for name, one in self.places.items() if not self._is_place(name)}
        if place in named:
            return []
        if self._is_place(place):
            return [
                name
                for name in spoken_of
                if name != address and not self._is_place(name) and name not in self.places
            ]
        return [name for name in spoken_of if self._is_place(name) and name not in named]

    def machine_name(self, address: str) -> str | None:
        """Return the name of the axis at an address, such as X1; None if the files do not state it.

        A name of one letter has priority (X, the axis name in the channel), because measurement
        files contain it too. Otherwise it is the machine axis name (X1).
        """
        one = self.address(address)
        names = [
            name for name in self.places if self.address(name) == one and not self._is_place(name)
        ]
        return next((name for name in names if len(name) == 1), names[0] if names else None)

    def written(self, address: str) -> str:
        """Return the axis name to write in new lines of the files.

        This is ``address`` itself if it is an index (AX1) or a machine axis name, else the index of
        the axis.
        """
        if address in self.machine or self._is_place(address):
            return address
        return self.places.get(address, address)

    def of_machine(self, address: str) -> str:
        """Return the machine axis name of an axis (such as X1), or ``address`` if the files give
        none.
        """
        one = self.address(address)
        named = (name for name in self.machine if self.address(name) == one)
        return next((name for name in named if not self._is_place(name)), address)

    def _is_place(self, name: str) -> bool:
        return self.place is not None and self.place.fullmatch(name) is not None


#: Statement, axis, and the other fields that say which entry it is.
Key = tuple[str, str, tuple[str, ...]]
#: Fields that say which entry a line is, apart from the axis.
_WHICH = ("system", "table", "set", "index", "key")
#: Quantities that list the names of axes: they must be the same everywhere.
NAMES = ("machine_axis", "channel_axis", "channel_machine_axis")


def entry_key(definition: Definition, occurrence: Occurrence, names: AxisNames) -> Key:
    """Return the key that identifies the variable in a line: statement, axis address and index."""
    tokens = occurrence.tokens
    axis = tokens.get("axis")
    address = "" if axis is None else names.address(normal_text(definition, axis.text))
    texts = (tokens[name].text for name in which_fields(definition, occurrence.statement))
    which = tuple(str(int(text)) if text.isdecimal() else text.upper() for text in texts)
    return occurrence.statement, address, which


def which_fields(definition: Definition, statement: str) -> list[str]:
    """Return the fields, other than the axis, that distinguish lines of the same statement (such as
    an index).
    """
    return [name for name in definition.statements[statement].fields if name in _WHICH]


def value_of(occurrence: Occurrence) -> str:
    """Return the value in a line as text, as written."""
    which = ("axis", *_WHICH)
    return next(token.text for name, token in occurrence.tokens.items() if name not in which)


def quantities_of(definition: Definition, statement: str) -> list[str]:
    """Return the quantities whose values a statement contains."""
    return [name for name, binding in definition.bindings.items() if binding.statement == statement]
