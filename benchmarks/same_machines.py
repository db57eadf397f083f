"""Axes with known errors, their tests and circles as files; nothing here is taken from the package.

mm or deg inside; deviations are measured minus target, corrections are added to the command.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Rng = np.random.Generator
ARCSEC = 1 / 3600


@dataclass
class OldTable:
    """What acts in the control: totals at equal steps, straight lines, held outside; backlash > 0
    moves on against the reference return.
    """

    start: float
    step: float
    values: Floats
    backlash: float = 0.0

    def at(self, x: Floats, sign: int, home: int) -> Floats:
        """The correction at ``x``, arriving with ``sign``."""
        nodes = self.start + self.step * np.arange(self.values.size)
        totals = np.interp(x, nodes, self.values)
        return np.asarray(totals + (sign * self.backlash if sign != home else 0.0))


@dataclass
class MachineAxis:
    """One axis: what the job says of it and what it really does; ``unit`` is 1 µm or 1 arcsec."""

    name: str
    address: str
    number: int
    rotary: bool
    endless: bool
    travel: tuple[float, float]
    home: int
    slope: float
    waves: tuple[tuple[float, float, float], ...]
    lost: float
    varies: float
    noise: float
    old: OldTable | None = None
    words: dict[str, object] = field(default_factory=dict)

    @property
    def unit(self) -> float:
        return ARCSEC if self.rotary else 1e-3

    def error(self, x: Floats, sign: int) -> Floats:
        """Deviation without noise and without any table."""
        low, high = self.travel
        u = (x - low) / (high - low)
        total: Floats = np.asarray(self.slope * u)
        for height, cycles, phase in self.waves:
            total = total + height * np.sin(2 * np.pi * cycles * u + phase)
        lag = self.lost + self.varies * np.sin(2 * np.pi * u)
        return np.asarray(self.unit * (total - (sign * lag if sign != self.home else 0.0)))

    def targets(self, rng: Rng) -> Floats:
        """Equal intervals with a random part."""
        low, high = self.travel
        count = int(rng.integers(9, 26))
        edge = 1.0 if self.rotary else 4.0
        places = low + (np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)) * (
            (high - low) / count
        )
        return np.asarray(np.round(np.clip(places, low + edge, high - edge), 3), dtype=np.float64)

    def measure(
        self, rng: Rng, x: Floats, extra: dict[int, Floats] | None = None
    ) -> dict[int, Floats]:
        """Readings (targets, runs) by direction; ``extra``: corrections that act besides."""
        datum, runs = rng.normal(0, 5) * self.unit, int(rng.choice([5, 5, 5, 3, 2]))
        readings = {}
        for sign in (1, -1):
            mean = self.error(x, sign) + datum
            if extra is not None:
                mean = mean + extra[sign]
            elif self.old is not None:
                mean = mean + self.old.at(x, sign, self.home)
            readings[sign] = mean[:, None] + rng.normal(0, self.noise * self.unit, (x.size, runs))
        return readings


def random_axis(
    rng: Rng, name: str, address: str, number: int, endless_share: float = 0.6
) -> MachineAxis:
    """An axis with 5 to 40 µm (arcsec) of error; X to W linear, A to C rotary, some endless; of the
    others half turn within one turn from zero.
    """
    rotary = name in "ABC"
    endless = bool(rotary and rng.random() < endless_share)
    length = float(rng.choice([150.0, 400.0, 650.0, 800.0, 1200.0]))
    low = float(rng.choice([0.0, -length, -length / 2, -20.0]))
    travel = (low, low + length)
    if rotary:
        travel = (
            (0.0, 360.0) if endless else ((0.0, 300.0) if rng.random() < 0.6 else (-120.0, 120.0))
        )
    turn = endless
    waves = (
        (
            float(rng.uniform(3, 9)),
            float(rng.integers(1, 3)) if turn else float(rng.uniform(0.4, 1.3)),
            float(rng.uniform(0, 6)),
        ),
        (
            float(rng.uniform(0.2, 1.5)),
            float(rng.integers(3, 6)) if turn else float(rng.uniform(1.5, 2.5)),
            float(rng.uniform(0, 6)),
        ),
    )
    return MachineAxis(
        name=name,
        address=address,
        number=number,
        rotary=rotary,
        endless=endless,
        travel=travel,
        home=1 if rng.random() < 0.8 else -1,
        slope=0.0 if turn else float(rng.choice([-1, 1]) * rng.uniform(4, 30)),
        waves=waves,
        lost=float(rng.choice([0.0, rng.uniform(1, 9), rng.uniform(-3, 0)])),
        varies=float(rng.choice([0.0, 0.0, rng.uniform(1, 6)])),
        noise=float(rng.uniform(0.2, 0.8)),
    )


def positioning_csv(
    rng: Rng | None, axis: MachineAxis, x: Floats, readings: dict[int, Floats]
) -> str:
    """A test as plain CSV: long or wide, comma or semicolon with decimal comma, in several units;
    without ``rng`` the plain long form.
    """
    unit = "deg" if axis.rotary else "mm"
    form = "long" if rng is None else str(rng.choice(["long", "long", "wide", "inside", "decimal"]))
    factor, column = (3600.0, "arcsec") if axis.rotary else (1000.0, "um")
    if form == "inside":
        factor, column = 1.0, unit
    head = [f"# axis: {axis.name}", "# cycle: standard"]
    if rng is not None and rng.random() < 0.3:
        head += ["# machine: VMC 850 / 7", "# date: 2024-05-17", "# operator: Müller; night"]
    marks = ((1, "+"), (-1, "-"))
    if form == "wide":
        runs = readings[1].shape[1]
        names = [f"{mark}{run}" for run in range(1, runs + 1) for _, mark in marks]
        rows = [
            ",".join(
                [f"{target:.4f}"]
                + [f"{readings[s][n, run] * factor:.4f}" for run in range(runs) for s, _ in marks]
            )
            for n, target in enumerate(x)
        ]
        return "\n".join(
            [*head, f"# unit: {column}", ",".join([f"target_{unit}", *names]), *rows, ""]
        )
    rows = [
        f"{target:.4f},{mark},{run},{value * factor:.6f}"
        for sign, mark in marks
        for target, row in zip(x, readings[sign], strict=True)
        for run, value in enumerate(row, 1)
    ]
    table = [f"target_{unit},direction,run,deviation_{column}", *rows]
    if form == "decimal":
        table = [row.replace(",", ";").replace(".", ",") for row in table]
    return "\n".join([*head, *table, ""])


def circle_csv(rng: Rng, plane: str, first: MachineAxis, second: MachineAxis) -> str:
    """Both runs of a circle with squareness, scale, lost motion, servo mismatch and noise."""
    radius, feed = float(rng.choice([100.0, 150.0])), 1000.0
    square, scale = rng.uniform(-50, 50) * 1e-6, rng.uniform(-30, 30, 2) * 1e-6
    lost = rng.uniform(0, 4, 2) * 1e-3
    late = rng.uniform(-1e-4, 1e-4) * feed / 60 / radius
    lines = [
        f"# plane: {plane}",
        f"# nominal_radius_mm: {radius:g}",
        f"# feed_mm_min: {feed:g}",
        f"# calibrated: {rng.choice(['yes', 'yes', 'no'])}",
        "direction,run,angle_deg,deviation_um",
    ]
    for name, sense in (("ccw", 1.0), ("cw", -1.0)):
        theta = (np.arange(600) + 0.5) * 2 * np.pi / 600
        x = radius * np.cos(theta - sense * late) * (1 + scale[0])
        y = radius * np.sin(theta + sense * late) * (1 + scale[1])
        x = x - square * y - np.sign(-sense * np.sin(theta)) * lost[0] / 2 + first.unit * 2
        y = y - np.sign(sense * np.cos(theta)) * lost[1] / 2 - second.unit
        deviation = (np.hypot(x, y) - radius) * 1000 + rng.normal(0, 0.2, theta.size)
        lines += [
            f"{name},1,{np.degrees(angle):.4f},{value:.4f}"
            for angle, value in zip(theta, deviation, strict=True)
        ]
    return "\n".join([*lines, ""])
