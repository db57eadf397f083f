"""Single values of one axis in the files."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.values import Values


@dataclass(frozen=True, slots=True)
class GridAxisValues(Values):
    """Single values of one axis in the ``gathered`` files. ``system``: its measuring system, as
    numbered there.
    """

    gathered: Gathered
    address: str
    system: str | None

    def places(self, quantity: str) -> list[FoundValue]:
        """Return every place of a quantity."""
        return self.gathered.found(quantity, self.address, self.system)

    def single(self, quantity: str, *, quiet: bool = True) -> FoundValue | None:
        """Return the place that counts. Unless ``quiet``, repetitions are noted: once, where the
        value is used.
        """
        return self.one(quantity, self.places(quantity), quiet=quiet)

    def stated_word(self, quantity: str) -> str | None:
        """Return the neutral word of a choice in the files, else None."""
        return self.word(quantity, self.single(quantity))

    def choice(self, quantity: str) -> str | None:
        """Return the neutral word of a choice, with its default if it is absent; None if the
        control does not have it.
        """
        if quantity not in self.definition.bindings:
            return None
        if self.single(quantity, quiet=False) is not None:
            return self.stated_word(quantity)
        return self.absent(quantity, quantity.replace("_", " "))
