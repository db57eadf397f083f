"""What a set of control files says, as both readers understand it; apart from how it is read, so
that a process which works on an axis need not load the readers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState

if TYPE_CHECKING:
    from compwright.controllers.virtual import VirtualControl
    from compwright.controls.read_once import ReadOnce


@dataclass(frozen=True, slots=True)
class DecodedState:
    """A set of control files as both readers understand it; without files (the state ``none``) no
    compensation is active and there is no judge.
    """

    files: tuple[ControlFile, ...]
    state: ControlState
    judge: VirtualControl | ReadOnce | None


def judged(
    state: DecodedState, address: str, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return the judge's correction at ``positions`` (mm or deg); zero for an axis that the files
    do not hold.
    """
    if state.judge is None or not judges(state.judge, address):
        return np.zeros(np.shape(positions))
    return state.judge.correction(address, positions, direction)


def judges(judge: VirtualControl | ReadOnce, address: str) -> bool:
    """Return whether the judge finds an axis in the files, which may spell it in another case."""
    return address.casefold() in {known.casefold() for known in judge.addresses()}
