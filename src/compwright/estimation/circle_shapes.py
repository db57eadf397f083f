"""The choice of shapes in the model of a circular test: decays and take-ups at each reversal point,
and causes that may be absent.

Each choice is a hypothesis with a prior probability (George and McCulloch, Statistica Sinica 7,
1997).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.estimation.circle_equations import CircleProblem
from compwright.estimation.circle_model import RARE, SpikeShape, TakeUp, rare_cause
from compwright.estimation.circle_noise import IndexArray

#: Most decays of one spike, and slots of a reversal point (one for the take-up of lost motion).
#: One decay is the rise. The other two add up to a fall that is not exponential, or that lies
#: between two tried lengths. With one, servo mismatch was wrong by up to seven standard errors.
DECAYS: Final = 3
SLOTS: Final = DECAYS + 1
#: Standard deviations of the amplitudes of a decay or take-up, um, equally probable: a single wide
#: one would make small ones improbable (Bartlett, Biometrika 44, 1957).
SIZES: Final = np.array([0.4, 2.0, 10.0])
PRIOR: Final = (SIZES**-2.0)[:, np.newaxis]
#: Prior probability that a decay is there, and that the two directions differ in it.
THERE: Final = 0.5
UNLIKE: Final = 0.1


class SpikeShapes:
    """The shapes in the model: a sum of up to `SLOTS` shapes at each reversal point, and one shape
    of each rare cause. Each shape has an index (-1: no shape). A shape at a reversal point can
    differ between the two directions.
    """

    def __init__(self, problem: CircleProblem) -> None:
        # A changeover starts absent: without any spike it would take what the reversals leave.
        late = ("master_slave", "_changeover")
        self.present = {name: -1 if name.startswith(late) else 0 for name in RARE}
        self.place = np.full((len(problem.reversals), SLOTS), -1)
        self.unlike = np.zeros((len(problem.reversals), SLOTS), dtype=bool)
        self.size = np.zeros((len(problem.reversals), SLOTS), dtype=np.intp)
        self.adopt(problem)

    def adopt(self, problem: CircleProblem) -> None:
        """Use these shapes in the equations ``problem``, whose columns have other numbers."""
        self.reversals = problem.reversals
        self._kinds = [(r.options(SpikeShape), r.options(TakeUp)) for r in problem.reversals]
        self.precision = problem.widths**-2.0
        self._columns: dict[tuple[int, int], list[int]] = {}
        for slot in self.slots():
            self._find_columns(*slot)
        self.count = len(problem.names)
        self.rare: dict[str, list[int]] = {}
        self.chance: dict[str, float] = {}
        always = []
        for index, name in enumerate(problem.names):
            cause, chance = rare_cause(name, problem.samples)
            if cause is None:
                always.append(index)
            else:
                self.rare.setdefault(cause, []).append(index)
                self.chance[cause] = chance
        self.always = np.array(always)

    def columns(self, reversal: int, slot: int) -> list[int]:
        """Return the model columns (indices) of the shape in ``slot`` at a reversal point."""
        return self._columns[reversal, slot]

    def at(self, place: tuple[int, int] | str) -> tuple[object, ...]:
        """Return columns and size of the shape at ``place``, or the index of a rare cause's."""
        if isinstance(place, str):
            return (self.present[place],)
        return *self._columns[place], self.size[place]

    def put(
        self, reversal: int, slot: int, place: int, *, unlike: bool = False, size: int = 0
    ) -> None:
        """Put the shape with index ``place`` (-1: none) in this ``slot`` of a reversal point;
        ``unlike``: it differs by direction; ``size``: index of its prior standard deviation.
        """
        self.place[reversal, slot] = place
        if place >= 0:
            self.unlike[reversal, slot], self.size[reversal, slot] = unlike, size
        self._find_columns(reversal, slot)

    def _find_columns(self, reversal: int, slot: int) -> None:
        place, here = self.place[reversal, slot], self.reversals[reversal]
        found = [int(here.alike[place])] if place >= 0 else []
        if found and self.unlike[reversal, slot]:
            found.append(int(here.unlike[place]))
        self._columns[reversal, slot] = found
        self.precision[found] = SIZES[self.size[reversal, slot]] ** -2.0

    def chosen(self, but: tuple[int, int] | str | None = None) -> IndexArray:
        """Return the columns of all spikes and rare causes in the model, except that of ``but``."""
        rare = [
            columns[self.present[name]]
            for name, columns in self.rare.items()
            if self.present[name] >= 0 and name != but
        ]
        found = [
            column
            for place, columns in self._columns.items()
            if columns and place != but
            for column in columns
        ]
        return np.array(rare + found, dtype=np.intp)

    def active(self) -> IndexArray:
        """Return all columns (causes of deviation) that are in the model."""
        return np.concatenate([self.always, self.chosen()])

    def options(self, reversal: int, slot: int) -> IndexArray:
        """Return the indices of the shapes that are possible in a ``slot`` of a reversal point."""
        return self._kinds[reversal][slot >= DECAYS]

    @property
    def log_prior(self) -> float:
        """The logarithm of the prior probability of the spikes and rare causes in the model."""
        total = 0.0
        for reversal, slot in self.slots():
            count = self.options(reversal, slot).size * SIZES.size
            if self.place[reversal, slot] < 0:
                total += float(np.log(1.0 - THERE)) if count else 0.0
                continue
            total += float(np.log(THERE / count))
            if self.reversals[reversal].unlike.size:
                unlike = self.unlike[reversal, slot]
                total += float(np.log(UNLIKE if unlike else 1.0 - UNLIKE))
        for name, columns in self.rare.items():
            there = self.present[name] >= 0
            chance = self.chance[name]
            total += float(np.log(chance / len(columns) if there else 1.0 - chance))
        return total

    def slots(self) -> Iterator[tuple[int, int]]:
        """Yield each pair of a reversal point and a shape number (slot), as indices."""
        for slot in range(SLOTS):
            for reversal in range(len(self.reversals)):
                yield reversal, slot


def set_shape(shapes: SpikeShapes, reversal: int, slot: int, option: int) -> None:
    """Replace the shape in ``slot`` at a reversal point by possibility ``option`` (0: no shape)."""
    options = shapes.options(reversal, slot)
    if option == 0:
        shapes.put(reversal, slot, -1)
        return
    # Alike or not, size, place: the order of `_Options.evidence`.
    rest, place = divmod(option - 1, options.size)
    unlike, size = divmod(rest, SIZES.size)
    shapes.put(reversal, slot, int(options[place]), unlike=bool(unlike), size=size)
