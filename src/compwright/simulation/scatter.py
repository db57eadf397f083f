"""Random differences between readings: noise, heavy tails, outliers, and shifts of whole traverses.

Evaluations usually assume white noise. Real machines and instruments also have the other kinds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from compwright.records.axis import Direction, FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class TraverseShifts:
    """Standard deviations, mm or deg, of shifts of whole traverses (all readings of a run in one
    direction).

    ``offset``, ``slope`` (mm/mm, deg/deg, around the middle of the travel): drawn for each
    traverse. ``walk``: the step of the offset from one traverse to the next in the order of the
    cycle.
    """

    offset: float = 0.0
    slope: float = 0.0
    walk: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulatedScatter:
    """The scatter of simulated readings, mm or deg.

    ``noise``: standard deviation of a reading at the lower end of the travel. ``noise_negative``:
    the same for approaches in -, if it differs. Both increase linearly along the travel, to
    ``growth`` times their value at the upper end. ``tails``: degrees of freedom of Student's t; the
    noise is then its scale. ``outlier_share``: the share of readings that are displaced by
    ``outlier_size`` to either side.
    """

    noise: float = 0.0
    noise_negative: float | None = None
    growth: float = 1.0
    tails: float | None = None
    outlier_share: float = 0.0
    outlier_size: float = 0.0
    traverses: TraverseShifts = field(default_factory=TraverseShifts)

    def drawn(
        self,
        positions: FloatArray,
        runs: Mapping[Direction, int],
        travel: tuple[float, float],
        rng: np.random.Generator,
    ) -> dict[Direction, FloatArray]:
        """Return random scatter of the readings in each direction, (m, runs).

        ``rng`` itself is used for the noise, and generators made from it for everything else.
        Therefore a kind of scatter that is switched off does not change the other random numbers.
        """
        tails, outliers, traverses = rng.spawn(3)
        most = max(runs.values())
        apart = self._apart(positions, runs, travel, traverses)
        ramp = np.interp(positions, travel, (1.0, self.growth))[:, None]
        blocks = {}
        for direction in Direction:
            noise = rng.standard_normal((positions.size, most))
            if self.tails is not None:
                noise /= np.sqrt(tails.chisquare(self.tails, noise.shape) / self.tails)
            scale = self.noise
            if direction is Direction.NEGATIVE and self.noise_negative is not None:
                scale = self.noise_negative
            block = scale * noise
            if self.growth != 1.0:
                block *= ramp
            far = outliers.uniform(size=noise.shape) < self.outlier_share
            block += far * self.outlier_size * outliers.choice([-1.0, 1.0], noise.shape)
            blocks[direction] = block[:, : runs[direction]] + apart[direction]
        return blocks

    def _apart(
        self,
        positions: FloatArray,
        runs: Mapping[Direction, int],
        travel: tuple[float, float],
        rng: np.random.Generator,
    ) -> dict[Direction, FloatArray]:
        """Return the random shift of the readings in each traverse, (m, runs) by direction.
        Traverses are drawn in the order of time: + and − of each run.
        """
        own = self.traverses
        order = [(run, way) for run in range(max(runs.values())) for way in Direction]
        middle = 0.5 * (travel[0] + travel[1])
        blocks = {way: np.zeros((positions.size, count)) for way, count in runs.items()}
        walked = 0.0
        for run, way in order:
            if run >= runs[way]:
                continue
            offset, slope, step = rng.standard_normal(3)
            walked += own.walk * step
            blocks[way][:, run] = (
                own.offset * offset + walked + own.slope * slope * (positions - middle)
            )
        return blocks
