"""A control of one's own has no judge: what its one reader found answers in the judge's place."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlState


@dataclass(frozen=True, slots=True)
class ReadOnce:
    """What a control does, by the reading of its definition alone; mm or deg."""

    state: ControlState

    def addresses(self) -> tuple[str, ...]:
        """Return the axes that the files speak of."""
        return tuple(self.state.axes)

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return what is added to the command of an axis at ``positions``, arriving in
        ``direction``.
        """
        return self.state.axes[address].at(positions, direction)

    def cross_correction(
        self, base: str, corrected: str, positions: FloatArray, direction: Direction
    ) -> FloatArray:
        """Return what is added to ``corrected`` with ``base`` at ``positions``, arriving in
        ``direction``; several tables of one pair add up.
        """
        added = (
            entry.at(positions, direction)
            for entry in self.state.cross
            if (entry.input, entry.output) == (base, corrected)
        )
        return sum(added, np.zeros(np.shape(positions)))
