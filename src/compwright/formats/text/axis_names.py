"""The names of one machine axis in the control's files: its place (AX1), the machine's name for it
(X1), the channel's (X).

Where the files list the names (SINUMERIK: MD10000, MD20080 with MD20070), all of them are one axis:
the one that the job asks for under any of them. Without the list each name is an axis of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.texts import ReadText
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all

_PLACE = re.compile(r"AX([0-9]{1,2})")


@dataclass(frozen=True, slots=True)
class AxisNames:
    """``places``: name -> place (``X1`` -> ``AX1``); ``asked``: place -> the name under which the
    axis was asked for.
    """

    places: Mapping[str, str] = field(default_factory=dict)
    asked: Mapping[str, str] = field(default_factory=dict)

    def address(self, name: str) -> str:
        """Return the one name of an axis: that it was asked for by, else its place, else ``name``
        as it is.
        """
        place = self.places.get(name, name)
        return self.asked.get(place, place)

    def known(self, name: str) -> bool:
        """Return whether a name is that of a machine axis; where the files list no names, every one
        is.
        """
        return not self.places or name in self.places or _PLACE.fullmatch(name) is not None

    def forms(self, address: str) -> set[str]:
        """Return every name of an axis."""
        one = self.address(address)
        return {
            address,
            one,
            *(name for name in (*self.places, *self.places.values()) if self.address(name) == one),
        }

    def unplaced(self, address: str, spoken_of: Iterable[str]) -> list[str]:
        """Return the names in the files that may be ``address`` too: a place without a name, beside
        names without a place.
        """
        place = self.places.get(address, address)
        named = {one for name, one in self.places.items() if not _PLACE.fullmatch(name)}
        if place in named:
            return []
        if _PLACE.fullmatch(place):
            return [
                name
                for name in spoken_of
                if name != address and not _PLACE.fullmatch(name) and name not in self.places
            ]
        return [name for name in spoken_of if _PLACE.fullmatch(name) and name not in named]

    def machine_name(self, address: str) -> str | None:
        """Return what people call the axis at an address; None where the files do not say it.

        The channel's letter where there is one (X), which measurement files have too, else the
        machine's name (X1).
        """
        one = self.address(address)
        names = [
            name for name in self.places if self.address(name) == one and not _PLACE.fullmatch(name)
        ]
        return next((name for name in names if len(name) == 1), names[0] if names else None)


def axis_names(
    definition: Definition, texts: Iterable[ReadText], asked: Sequence[str] = ()
) -> AxisNames:
    """Return the names that the files list; ``asked``: the addresses that a job or the command line
    names.

    Raises InputError where the files give one name to two axes, UsageError where two addresses are
    one axis.
    """
    if "machine_axis" not in definition.bindings:
        return AxisNames()
    found: dict[str, dict[str, list[Occurrence]]] = {}
    for text in texts:
        for occurrence in text.occurrences:
            for quantity in ("machine_axis", "channel_axis", "channel_machine_axis"):
                binding = definition.bindings.get(quantity)
                if binding is not None and occurrence.statement == binding.statement:
                    index = str(int(occurrence.tokens["table"].text))
                    found.setdefault(quantity, {}).setdefault(index, []).append(occurrence)
    faults: list[Fault] = []
    places = _machine(definition, found.get("machine_axis", {}), faults)
    raise_all(InputError, faults)
    places |= {
        name: place for name, place in _channel(definition, found).items() if name not in places
    }
    mine: dict[str, str] = {}
    for address in dict.fromkeys(asked):
        place = places.get(address, address)
        if place in mine:
            faults.append(
                Fault(
                    message=f"{mine[place]} and {address} are one axis of the control, {place}",
                    place="address",
                    expected="each axis once",
                    found=f"{mine[place]} and {address}",
                )
            )
        mine.setdefault(place, address)
    raise_all(UsageError, faults)
    return AxisNames(places, mine)


def _machine(
    definition: Definition, entries: Mapping[str, Sequence[Occurrence]], faults: list[Fault]
) -> dict[str, str]:
    places: dict[str, str] = {}
    for index, occurrences in entries.items():
        place = f"AX{int(index) + 1}"
        for occurrence in occurrences:
            name = normal_text(definition, occurrence.tokens["value"].text)
            number = _PLACE.fullmatch(name)
            if places.setdefault(name, place) != place or (number is not None and name != place):
                other = places[name] if number is None else name
                faults.append(
                    Fault(
                        message=(
                            f"the name {name} stands for two machine axes (MD10000), {place} and"
                            f" {other}"
                        ),
                        file=occurrence.file,
                        place=occurrence.place,
                        expected="a name for each axis",
                        found=name,
                    )
                )
    return places


def _channel(
    definition: Definition, found: Mapping[str, Mapping[str, Sequence[Occurrence]]]
) -> dict[str, str]:
    """Return the channel's names, as far as they mean the same machine axis wherever they stand."""
    meant: dict[str, set[str]] = {}
    for index, occurrences in found.get("channel_axis", {}).items():
        used = {
            occurrence.tokens["value"].text
            for occurrence in found.get("channel_machine_axis", {}).get(index, ())
        }
        for occurrence in occurrences:
            name = normal_text(definition, occurrence.tokens["value"].text)
            meant.setdefault(name, set()).update(
                f"AX{int(number)}" for number in used if int(number) > 0
            )
    return {name: next(iter(places)) for name, places in meant.items() if len(places) == 1}
