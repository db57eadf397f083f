"""The correction that two independent readers decode from control files. A second process can use
it without loading the readers.

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
    """The corrections of a control by the reader of the definition alone; mm or deg."""

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
        """Return the correction of ``corrected`` with ``base`` at ``positions``. Several tables of
        one pair are added.

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
    """A set of control files as decoded by both readers. Without files no compensation is active
    and there is no virtual control.
    """

    files: tuple[ControlFile, ...]
    state: ControlState
    judge: VirtualControl | SingleReader | None


def judged_values(
    state: DecodedState, address: str, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return the independent second reader's correction at ``positions`` (mm or deg). Zero for an
    axis that is not in the files.
    """
    if state.judge is None or not judge_knows_axis(state.judge, address):
        return np.zeros(np.shape(positions))
    return state.judge.correction(address, positions, direction)


def judge_knows_axis(judge: VirtualControl | SingleReader, address: str) -> bool:
    """Return whether the independent second reader finds an axis in the files, in upper or lower
    case.
    """
    return address.casefold() in {known.casefold() for known in judge.addresses()}
