"""A machine axis with a known error, the laser in front of it, and A after ISO 230-2, all in mm.

Nothing here comes from compwright: A is max(mean + 2 s) - min(mean - 2 s) over both directions.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from statistics import fmean, stdev

#: What a control adds to the command at a position and approach direction (+1, -1), mm or deg.
Correction = Callable[[float, int], float]


def nothing(_position: float, _direction: int) -> float:
    return 0.0


@dataclass(frozen=True)
class Axis:
    """Travel, slope (µm over the travel), one bow and one wave (µm), lost motion (µm), scatter (µm)."""

    low: float = 0.0
    high: float = 600.0
    slope: float = 30.0
    bow: float = 6.0
    wave: float = 3.0
    lost: float = 4.0
    scatter: float = 0.3
    full_turn: bool = False

    def error(self, position: float, direction: int) -> float:
        """Give actual minus commanded; lost motion lets the return stop too far back."""
        part = (position - self.low) / (self.high - self.low)
        if self.full_turn:
            shape = self.bow * math.sin(2 * math.pi * part) + self.wave * math.cos(
                6 * math.pi * part
            )
        else:
            shape = (
                self.slope * part
                + self.bow * math.sin(math.pi * part)
                + self.wave * math.sin(2 * math.pi * part)
            )
        return (shape + (self.lost if direction < 0 else 0.0)) / 1000


@dataclass(frozen=True)
class Readings:
    """Deviations by target and direction, mm."""

    targets: Sequence[float]
    values: dict[tuple[int, int], list[float]] = field(default_factory=dict)

    def A(self) -> float:  # noqa: N802 - the letter of the standard
        """Give the accuracy of positioning, in thousandths of the unit."""
        high = max(fmean(row) + 2 * stdev(row) for row in self.values.values())
        low = min(fmean(row) - 2 * stdev(row) for row in self.values.values())
        return 1000 * (high - low)

    def mean(self, target: int) -> float:
        return (fmean(self.values[target, 1]) + fmean(self.values[target, -1])) / 2


def measure(
    axis: Axis, correction: Correction = nothing, *, seed: int = 1, count: int = 13, runs: int = 5
) -> Readings:
    """Measure an axis whose control adds ``correction``; targets stand off the even grid."""
    rng = random.Random(seed)  # noqa: S311 - noise of a laser
    step = (axis.high - axis.low) / count
    places = random.Random(99)  # noqa: S311 - the same targets in every test
    targets = [
        round(axis.low + (i + 0.5) * step + places.uniform(-0.25, 0.25) * step, 3)
        for i in range(count)
    ]
    values = {
        (i, d): [
            axis.error(x, d) + correction(x, d) + rng.gauss(0, axis.scatter / 1000)
            for _ in range(runs)
        ]
        for i, x in enumerate(targets)
        for d in (1, -1)
    }
    return Readings(targets, values)


def write_csv(path: Path, name: str, readings: Readings, *, rotary: bool = False) -> None:
    unit, factor = ("deg", 3600.0) if rotary else ("mm", 1000.0)
    column = "deviation_arcsec" if rotary else "deviation_um"
    rows = [f"# axis: {name}", f"target_{unit},direction,run,{column}"]
    rows += [
        f"{readings.targets[i]},{'+' if d > 0 else '-'},{run},{factor * value:.4f}"
        for (i, d), row in sorted(readings.values.items())
        for run, value in enumerate(row, start=1)
    ]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


def table_value(positions: Sequence[float], values: Sequence[float], at: float) -> float:
    """Interpolate linearly; the end values hold outside."""
    if at <= positions[0]:
        return values[0]
    for left, right, low, high in zip(positions, positions[1:], values, values[1:], strict=False):
        if at <= right:
            return low + (high - low) * (at - left) / (right - left)
    return values[-1]
