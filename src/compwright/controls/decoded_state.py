"""Records of the corrections that two independent readers decoded from a control's files.

A user's own control has no independent reader (judge): the values of its one reader are used.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState


@dataclass(frozen=True, slots=True)
class SingleReader:
    """The corrections, mm or deg, of a control that has a definition but no independent reader."""

    state: ControlState

    def addresses(self) -> tuple[str, ...]:
        """Return the addresses of the axes in the control's files."""
        return tuple(self.state.axes)

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction of an axis at ``positions``, approached in ``direction``."""
        return self.state.axes[address].at(positions, direction)

    def cross_correction(
        self, base: str, corrected: str, positions: FloatArray, direction: Direction
    ) -> FloatArray:
        """Return the correction of the axis ``corrected`` with the axis ``base`` at ``positions``.

        Arriving in ``direction``.
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
    """Control files as decoded by both readers; without files no compensation is active."""

    files: tuple[ControlFile, ...]
    state: ControlState
    judge: VirtualControl | SingleReader | None


def judged_values(
    state: DecodedState, address: str, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return the independent reader's correction at ``positions``, mm or deg (0: unknown axis)."""
    if state.judge is None or not judge_knows_axis(state.judge, address):
        return np.zeros(np.shape(positions))
    return state.judge.correction(address, positions, direction)


def judge_knows_axis(judge: VirtualControl | SingleReader, address: str) -> bool:
    """Return whether the independent reader finds an axis in the files, in any letter case."""
    return address.casefold() in {known.casefold() for known in judge.addresses()}
