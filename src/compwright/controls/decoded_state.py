"""A set of control files as both readers understand it; apart from how it is read, so that a
process which works on an axis need not load the readers.

A control of one's own has no judge: the values that its one reader found are used in its place.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState


@dataclass(frozen=True, slots=True)
class SingleReader:
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


if TYPE_CHECKING:
    from compwright.controllers.virtual import VirtualControl


@dataclass(frozen=True, slots=True)
class DecodedState:
    """A set of control files as both readers understand it; without files (the state ``none``) no
    compensation is active and there is no judge.
    """

    files: tuple[ControlFile, ...]
    state: ControlState
    judge: VirtualControl | SingleReader | None


def judged_values(
    state: DecodedState, address: str, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return the judge's correction at ``positions`` (mm or deg); zero for an axis that the files
    do not hold.
    """
    if state.judge is None or not judge_knows_axis(state.judge, address):
        return np.zeros(np.shape(positions))
    return state.judge.correction(address, positions, direction)


def judge_knows_axis(judge: VirtualControl | SingleReader, address: str) -> bool:
    """Return whether the judge finds an axis in the files, which may spell it in another case."""
    return address.casefold() in {known.casefold() for known in judge.addresses()}
