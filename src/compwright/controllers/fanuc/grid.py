"""Grid of one FANUC axis: which point numbers it uses, and for what."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True, slots=True, kw_only=True)
class IncrementGrid:
    """The grid that 3605#0 and 3620 to 3627 define. ``interval``, ``turn``: mm or deg; ``offset``:
    detection units.

    ``negative_from``: 3626 with bidirectional data, else None. ``turn``: of an endless axis, else
    None.
    """

    axis: int
    reference: int
    lowest: int
    highest: int
    magnification: int
    interval: float
    turn: float | None = None
    negative_from: int | None = None
    offset: int = 0

    def starts(self) -> tuple[int, ...]:
        """Return the first number of each set: for travel towards +, then towards - if that has its
        own.
        """
        return (self.lowest,) if self.negative_from is None else (self.lowest, self.negative_from)

    def numbers(self) -> list[int]:
        """Return all point numbers that the axis uses."""
        return [start + i for start in self.starts() for i in range(self.highest - self.lowest + 1)]

    def same_use(self, other: IncrementGrid) -> bool:
        """Return whether two axes use the same numbers in the same way (a gantry pair may)."""
        return replace(self, axis=0) == replace(other, axis=0)
