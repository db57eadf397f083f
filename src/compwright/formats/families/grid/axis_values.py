"""The single values that the files hold of one axis."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.values import Values


@dataclass(frozen=True, slots=True)
class GridAxisValues(Values):
    """``system``: the measuring system, as counted in the files ``gathered``."""

    gathered: Gathered
    address: str
    system: str | None

    def places(self, quantity: str) -> list[FoundValue]:
        """Return every place where a quantity stands."""
        return self.gathered.found(quantity, self.address, self.system)

    def single(self, quantity: str, *, quiet: bool = True) -> FoundValue | None:
        """Return the place that counts. Unless ``quiet``, repetitions are told: once, where the
        value is used.
        """
        return self.one(quantity, self.places(quantity), quiet=quiet)

    def stated_word(self, quantity: str) -> str | None:
        """Return the neutral word of a choice that is in the files, else None."""
        return self.word(quantity, self.single(quantity))

    def choice(self, quantity: str) -> str | None:
        """Return the neutral word of a choice, with what counts when it is absent; None where the
        control has no such thing.
        """
        if quantity not in self.definition.bindings:
            return None
        if self.single(quantity, quiet=False) is not None:
            return self.stated_word(quantity)
        return self.absent(quantity, quantity.replace("_", " "))
