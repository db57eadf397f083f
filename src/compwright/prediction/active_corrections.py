"""The active corrections of a control: of an axis by its own position, and of an axis by the
position of another axis.

A correction is what the control adds to the command, mm or deg, > 0 towards the positive end.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from compwright.prediction.circular import CirclePath, Displacement
from compwright.records.axis import Direction, FloatArray
from compwright.records.plan import PlannedCross

#: A correction by position (mm or deg, any shape) and approach direction, of the same shape.
Correction = Callable[[FloatArray, Direction], FloatArray]


def no_correction(positions: FloatArray, _direction: Direction) -> FloatArray:
    """Return a correction that is zero everywhere."""
    return np.zeros(np.shape(positions))


def difference(new: Correction, old: Correction) -> Correction:
    """Return the change of the correction when the correction ``new`` replaces the correction
    ``old``.
    """
    return partial(_together, new, old, -1.0)


def sum_of_corrections(one: Correction, other: Correction) -> Correction:
    """Return the sum of two corrections of one axis."""
    return partial(_together, one, other, 1.0)


def _together(
    one: Correction, other: Correction, sign: float, positions: FloatArray, direction: Direction
) -> FloatArray:
    """Return correction ``one`` plus ``sign`` (1 or -1) times correction ``other`` at the
    positions, approached in the given direction.
    """
    return one(positions, direction) + sign * other(positions, direction)


@dataclass(frozen=True, slots=True)
class ActiveCorrections:
    """All active corrections of a control. ``along``: the correction of each axis by the position
    of that axis; ``across``: that of an output axis by the position of an input axis.
    """

    along: Mapping[str, Correction]
    across: Mapping[tuple[str, str], Correction]

    def on(self, axis: str) -> Correction:
        """Return the correction of ``axis`` as a function of the position of that axis."""
        return self.along.get(axis, no_correction)

    def between(self, given: str, bent: str) -> Correction:
        """Return the correction of the axis ``bent`` as a function of the position of the axis
        ``given``.
        """
        return self.across.get((given, bent), no_correction)

    def with_added(self, entries: Iterable[PlannedCross]) -> ActiveCorrections:
        """Return these corrections and planned ones between axes."""
        across = dict(self.across)
        for entry in entries:
            pair = entry.input, entry.output
            across[pair] = sum_of_corrections(across.get(pair, no_correction), entry.added.at)
        return replace(self, across=across)

    def displacement(self, axes: tuple[str, str]) -> Displacement:
        """Return a function that gives the displacement (n, 2) mm of the tool, in the plane of two
        axes (names of the job), that all active corrections cause together.

        An axis outside the plane does not move during a circle, so its effect on the two axes is
        the same at every point and is left out.
        """

        def at(path: CirclePath) -> FloatArray:
            places = {
                axes[0]: (path.first, path.moves_first),
                axes[1]: (path.second, path.moves_second),
            }
            moved = np.zeros((path.first.size, 2))
            for index, name in enumerate(axes):
                moved[:, index] += correction_in_motion(self.on(name), *places[name])
                for other, place in places.items():
                    moved[:, index] += correction_in_motion(self.between(other, name), *place)
            return moved

        return at


#: No correction, or an unknown one.
NO_CORRECTIONS = ActiveCorrections({}, {})


def correction_in_motion(
    correction: Correction, positions: FloatArray, moves: FloatArray
) -> FloatArray:
    """Return the correction of an axis at ``positions`` (n,). ``moves`` (n,): the direction in
    which the axis moves there, above 0 for +, else −.
    """
    either = [correction(positions, direction) for direction in Direction]
    return np.where(moves > 0.0, *either)
