"""Names of one axis in the control's files: its index among the axes (place), the machine's name,
the channel's name.

If the files list the names, all of them are one axis, with the name under which it was requested.
Without the list each name is an axis of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class AxisNames:
    """``places``: name -> place; ``machine``: those of them that are the machine's own names;
    ``requested``: place -> the name under which the axis was requested; ``place``: the form of a
    place, None if the control has no such names.
    """

    places: Mapping[str, str] = field(default_factory=dict)
    machine: Mapping[str, str] = field(default_factory=dict)
    requested: Mapping[str, str] = field(default_factory=dict)
    place: re.Pattern[str] | None = None

    def address(self, name: str) -> str:
        """Return the canonical name of an axis: the requested one, else its place, else ``name``
        unchanged.
        """
        place = self.places.get(name, name)
        return self.requested.get(place, place)

    def known(self, name: str) -> bool:
        """Return whether a name is that of a machine axis; if the files list no names, every one
        is.
        """
        return not self.places or name in self.places or self._is_place(name)

    def forms(self, address: str) -> set[str]:
        """Return every name of an axis."""
        one = self.address(address)
        return {
            address,
            one,
            *(name for name in (*self.places, *self.places.values()) if self.address(name) == one),
        }

    def unplaced(self, address: str, spoken_of: Iterable[str]) -> list[str]:
        """Return the names in the files that may also mean ``address``: the files give one as a
        place without a name, the other as names without a place.
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
        """Return the name of the axis at an address for people; None if the files do not state it.

        The channel's letter if there is one (X), which measurement files have too, else the
        machine's name (X1).
        """
        one = self.address(address)
        names = [
            name for name in self.places if self.address(name) == one and not self._is_place(name)
        ]
        return next((name for name in names if len(name) == 1), names[0] if names else None)

    def written(self, address: str) -> str:
        """Return the name of an axis for writing lines: ``address`` itself if it is its place or
        the machine's name, else its place.
        """
        if address in self.machine or self._is_place(address):
            return address
        return self.places.get(address, address)

    def of_machine(self, address: str) -> str:
        """Return the machine's own name of an axis, ``address`` if it has none."""
        one = self.address(address)
        named = (name for name in self.machine if self.address(name) == one)
        return next((name for name in named if not self._is_place(name)), address)

    def _is_place(self, name: str) -> bool:
        return self.place is not None and self.place.fullmatch(name) is not None
