"""Records of the corrections that compwright's two independent file readers decoded from a
control's files.

A control with a definition of the user's own has no independent reader (judge). The values of its
only reader are used instead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState


@dataclass(frozen=True, slots=True)
class SingleReader:
    """The corrections (mm or deg) of a control that only one file reader of compwright can decode,
    by the control's definition.
    """

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

        ``direction``: the direction in which the axis ``base`` approaches the positions.
        """
        added = (
            entry.at(positions, direction)
            for entry in self.state.cross
            if (entry.input, entry.output) == (base, corrected)
        )
        return sum(added, np.zeros(np.shape(positions)))


if TYPE_CHECKING:
    from compwright.controllers.virtual_control import VirtualControl


@dataclass(frozen=True, slots=True)
class DecodedState:
    """A control's files, with the corrections that both file readers of compwright decoded from
    them; no files means no compensation. ``active``: the job's answer whether the tables were
    active.
    """

    files: tuple[ControlFile, ...]
    state: ControlState
    judge: VirtualControl | SingleReader | None
    active: bool | None = None

    @property
    def contradicted(self) -> set[frozenset[str]]:
        """Return the axes of each numbered table (`PairTables`) between two axes that the files
        switch otherwise than ``active`` says. This answer changes no such table.
        """
        if self.active is None:
            return set()
        tables = self.state.tables
        on = {
            (one.input, one.output)
            for one in self.state.cross
            if one.positive.any() or one.negative.any()
        }
        return {
            frozenset(axes)
            for index, axes in tables.used.items()
            if (index in tables.off if self.active else axes in on)
        }


def judged_values(
    state: DecodedState, address: str, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return an axis' correction at ``positions``, mm or deg, as the independent file reader
    decodes it; 0 if it does not find the axis.
    """
    if state.judge is None or not judge_knows_axis(state.judge, address):
        return np.zeros(np.shape(positions))
    return state.judge.correction(address, positions, direction)


def judge_knows_axis(judge: VirtualControl | SingleReader, address: str) -> bool:
    """Return whether the independent file reader ``judge`` found the axis in the files; upper and
    lower case are equal.
    """
    return address.casefold() in {known.casefold() for known in judge.addresses()}
