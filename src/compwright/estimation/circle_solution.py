"""The solution of a circular test: estimated causes, spikes and residuals."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from compwright.estimation.circle_cyclic import axis_of, mean_position
from compwright.estimation.circle_equations import CircleProblem
from compwright.estimation.circle_fit import CircleFit
from compwright.estimation.circle_reversal import CircleDraws
from compwright.estimation.circle_vibration import Vibration
from compwright.records.axis import FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """The causes fitted to a circular test: ``fitted`` for the most probable spike shapes,
    ``draws`` as random samples over all spike shapes.

    ``frequencies``: frequency of the columns of a cyclic error, 1/mm, by name (`wave_names`).
    ``given``: axes of which a frequency was known and not searched. ``hidden``: amplitude, um, of
    a cyclic error that may have been missed, by axis.
    """

    problem: CircleProblem
    fitted: CircleFit
    draws: CircleDraws
    frequencies: Mapping[str, float]
    given: frozenset[str]
    hidden: Mapping[str, float]
    vibration: Vibration

    @property
    def values(self) -> dict[str, float]:
        """Mean size of each cause that is in every model, by name."""
        mean = np.mean(self.draws.values, axis=0)
        return dict(zip(self.problem.names, (float(value) for value in mean), strict=True))

    def cyclic_waves(self, axis: str) -> list[str]:
        """Return the names of the cyclic errors of an axis: that of a given pitch, then the others,
        the largest first.
        """
        values = self.values

        def place(name: str) -> tuple[bool, float]:
            size = math.hypot(values[f"_cyclic_cos_{name}"], values[f"_cyclic_sin_{name}"])
            return name not in self.given, -size

        return sorted((name for name in self.frequencies if axis_of(name) == axis), key=place)

    def cyclic_wave(self, name: str) -> tuple[float, float]:
        """Return the frequency of a cyclic error, 1/mm, and its phase at the centre of the circle,
        deg (-180 to 180).
        """
        values, centre = self.values, mean_position(self.problem.samples, axis_of(name))
        shift = values.get(f"_frequency_{name}", 0.0)
        wave = complex(values[f"_cyclic_cos_{name}"], values[f"_cyclic_sin_{name}"])
        phase = np.angle(wave * np.exp(-2j * np.pi * shift * centre), deg=True)
        return self.frequencies[name] + shift, float(phase)

    @property
    def spikes(self) -> FloatArray:
        """The part of each sample's deviation that the mean reversal spikes explain, mm (n,)."""
        every = self.draws.spikes
        if not every:
            return np.zeros(self.problem.target.size)
        sizes = [[spike.curve[turn % len(spike.curve)] for spike in every] for turn in (0, 1)]
        ccw, cw = self.problem.spike_curves(np.array(sizes))
        found: FloatArray = np.where(self.problem.samples.sense > 0.0, ccw, cw)
        return found

    @property
    def smooth(self) -> FloatArray:
        """The fitted deviation of each sample without the reversal spikes, mm (n,)."""
        fitted: FloatArray = self.problem.slopes @ np.mean(self.draws.values, axis=0)
        return fitted

    @property
    def residual(self) -> FloatArray:
        """The measured minus the fitted deviation of each sample, mm (n,)."""
        rest: FloatArray = self.problem.target - self.smooth - self.spikes
        return rest
