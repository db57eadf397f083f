"""The loop that every control must close: known error, measurement, fit, file, virtual control, new
measurement.

The machine and the evaluation of A stand here a second time, apart from the package, so that both
cannot be wrong together.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Machine:
    """A smooth axis error with reversal: mm, positions in machine coordinates. ``lost`` > 0: lost
    motion in mm.
    """

    low: float = 0.0
    high: float = 800.0
    slope: float = 25e-6
    bow: float = 0.006
    lost: float = 0.005
    noise: float = 0.0004
    reference_return: int = 1

    def error(self, x: Floats, sign: int) -> Floats:
        """Deviation without noise, arriving with ``sign`` (+1, -1)."""
        u = (np.asarray(x, dtype=float) - self.low) / (self.high - self.low)
        curve = self.slope * x + self.bow * np.sin(2.3 * np.pi * u + 0.4)
        # Lost motion: the axis stays behind by it when it arrives against the direction in which it
        # was referenced.
        return curve - (sign * self.lost if sign != self.reference_return else 0.0)

    def targets(self, count: int = 17, seed: int = 3) -> Floats:
        """Targets as ISO 230-2 clause 4.2 wants them: equal intervals plus a random part."""
        pitch = (self.high - self.low) / count
        dither = np.random.default_rng(seed).uniform(-0.3, 0.3, count)
        return np.round(self.low + (np.arange(count) + 0.5 + dither) * pitch, 3)

    def measure(
        self,
        targets: Floats,
        seed: int,
        correction: Callable[[Floats, int], Floats] | None = None,
        runs: int = 5,
    ) -> dict[int, Floats]:
        """Readings (m, runs) by direction sign, with fresh noise and an instrument zero of its
        own.
        """
        rng = np.random.default_rng(seed)
        datum = rng.normal(0, 0.02)
        readings = {}
        for sign in (1, -1):
            mean = self.error(targets, sign) + datum
            if correction is not None:
                mean = mean + correction(targets, sign)
            readings[sign] = mean[:, None] + rng.normal(0, self.noise, (targets.size, runs))
        return readings


def accuracy(readings: dict[int, Floats], k: float = 2.0) -> float:
    """A of ISO 230-2, in the unit of the readings, written out from the definition (2006, 2.24)."""
    high, low = [], []
    for block in readings.values():
        mean = block.mean(axis=1)
        s = block.std(axis=1, ddof=1)
        high.append((mean + k * s).max())
        low.append((mean - k * s).min())
    return float(max(high) - min(low))


@cache
def floor_of(noise: float, targets: int, runs: int) -> float:
    """The A (mm) that 99 of 100 tests of a perfectly compensated axis stay below: noise alone."""
    values = []
    for seed in range(300):
        rng = np.random.default_rng(10_000 + seed)
        values.append(accuracy({sign: rng.normal(0, noise, (targets, runs)) for sign in (1, -1)}))
    return float(np.quantile(values, 0.99))


def allowed(machine: Machine, targets: Floats, spacing: float, runs: int = 5) -> float:
    """What A may be after one round: the noise floor, the error of the estimate and what straight
    lines between nodes lose.

    The estimate of a mean of 2 n readings is off by at most 3 noise / sqrt(2 n) at either end of
    the range, with few exceptions; a straight line over ``spacing`` misses a curve by at most its
    second derivative times spacing² / 8.
    """
    estimate = 2 * 3 * machine.noise / np.sqrt(2 * runs)
    curvature = machine.bow * (2.3 * np.pi / (machine.high - machine.low)) ** 2
    return float(
        floor_of(machine.noise, targets.size, runs) + estimate + 2 * curvature * spacing**2 / 8
    )


def csv_of(targets: Floats, readings: dict[int, Floats], axis: str = "X", unit: str = "mm") -> str:
    """The readings as plain CSV, long form, deviations in µm (mm) or arcsec (deg)."""
    factor, name = (1000.0, "um") if unit == "mm" else (3600.0, "arcsec")
    lines = [
        f"# axis: {axis}",
        "# cycle: standard",
        f"target_{unit},direction,run,deviation_{name}",
    ]
    for sign, mark in ((1, "+"), (-1, "-")):
        for target, row in zip(targets, readings[sign], strict=True):
            lines += [
                f"{target:.4f},{mark},{run},{value * factor:.6f}"
                for run, value in enumerate(row, 1)
            ]
    return "\n".join(lines) + "\n"
