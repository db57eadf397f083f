"""Virtual circles of known squareness, for `bench_examiner.py`: exact geometry."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

Values = npt.NDArray[np.float64]
ARCS = (
    (0.0, 360.0),
    (0.0, 180.0),
    (10.0, 180.0),
    (-20.0, 220.0),
    (70.0, 220.0),
    (0.0, 92.0),
    (45.0, 92.0),
    (-100.0, 200.0),
)
TURNS = (("ccw", 1.0), ("cw", -1.0))


@dataclass
class Circle:
    """A circular test: by direction angles (degrees) and deviations of the radius (mm)."""

    radius: float
    feed: float
    start: float
    extent: float
    squareness: float  # µm/m, above 0 where the angle is larger than 90 degrees
    runs: dict[str, tuple[Values, Values]]
    noise: float

    def write(self, path: Path) -> None:
        """Write the plain CSV form."""
        lines = [
            "# plane: XY",
            f"# nominal_radius_mm: {self.radius:g}",
            f"# feed_mm_min: {self.feed:g}",
            "# calibrated: yes",
        ]
        lines += ["# centre: 400 400", "direction,angle_deg,deviation_um"]
        for direction, (angles, deviations) in self.runs.items():
            lines += [
                f"{direction},{a:.4f},{d * 1000:.3f}"
                for a, d in zip(angles, deviations, strict=True)
            ]
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    def certain(self) -> float:
        """Return the standard error (µm/m) of squareness where noise and causes are known."""
        rows, radius = [], self.radius * 1000
        for direction, (angles, _) in self.runs.items():
            t, sign = np.deg2rad(angles), 1.0 if direction == "ccw" else -1.0
            columns = [
                np.ones_like(t) * (sign > 0),
                np.ones_like(t) * (sign < 0),
                np.cos(t),
                np.sin(t),
                np.cos(2 * t) / 2,
            ]
            columns += [-np.sin(2 * t) / 2 * radius * 1e-6, sign * np.sin(2 * t) / 2]
            columns += [
                sign / 2 * np.sign(np.sin(t)) * np.cos(t),
                -sign / 2 * np.sign(np.cos(t)) * np.sin(t),
            ]
            rows.append(np.array(columns).T)
        design = np.vstack(rows)
        values, vectors = np.linalg.eigh(design.T @ design)
        return float(self.noise * np.sqrt((vectors[5] ** 2 / np.maximum(values, 1e-12)).sum()))

    def determinable(self) -> bool:
        """Say whether both axes reverse inside and the noise leaves twice what is needed."""
        first, last = self.start + 3, self.start + self.extent - 3
        inside = {k % 2 for k in range(-8, 16) if first < 90 * k < last}
        wanted = min(abs(self.squareness) / 2, 30)
        both = inside == {0, 1} and len(self.runs) == 2
        return both and 4 * self.certain() < wanted


def vibration(rng: np.random.Generator, count: int, sigma: float, length: float) -> Values:
    """Return noise that hangs together over `length` samples."""
    kept = np.exp(-1 / length)
    noise = rng.normal(0, sigma * np.sqrt(1 - kept**2), count)
    noise[0] = rng.normal(0, sigma)
    for i in range(1, count):
        noise[i] += kept * noise[i - 1]
    return noise


def circle(rng: np.random.Generator, number: int) -> Circle:
    """Measure one virtual machine of random errors; the arc goes by the number."""
    start, extent = ARCS[number % len(ARCS)]
    start += float(rng.choice([0, 90, 180, 270]))
    radius, feed = float(rng.choice([50, 100, 150])), float(rng.choice([500, 1000, 3000]))
    beta = float(rng.choice([-80, -28, -10, 0, 10, 28, 80]))
    lost, lag = (
        rng.choice([0, 2, 5, 15], 2) * rng.choice([1, 1, -0.3]),
        rng.choice([0, 0.2, 1]) * rng.normal(0, 1, 2),
    )
    spike, decay = rng.choice([0, 3, 8], 4) * rng.uniform(0.3, 1, 4), np.deg2rad(rng.uniform(1, 6))
    scale, straight = rng.normal(0, 20, 2), rng.choice([0, 0, 3], 2)
    centre, sigma = rng.normal(0, 0.02, 2), float(rng.choice([0.2, 0.6, 1.5]))
    length = float(rng.choice([1, 3, 10]))
    runs = {}
    chosen = TURNS if number % 16 < 12 else TURNS[number % 2 : number % 2 + 1]
    count = int(extent * rng.choice([1, 3]))
    for direction, sign in chosen:
        degrees = start + (np.arange(count) + 0.5) * extent / count
        angles = np.deg2rad(degrees)
        speed = sign * feed / 60 / radius  # rad/s
        moving = np.array(
            [-np.sign(speed) * np.sign(np.sin(angles)), np.sign(speed) * np.sign(np.cos(angles))]
        )
        late = np.array([angles - speed * lag[0] / 1000, angles - speed * lag[1] / 1000])
        x, y = radius * np.cos(late[0]), radius * np.sin(late[1])
        actual_x = (
            x * (1 + scale[0] * 1e-6) - beta * 1e-6 * y + straight[0] / 1000 * (y / radius) ** 2
        )
        actual_y = y * (1 + scale[1] * 1e-6) + straight[1] / 1000 * (x / radius) ** 2
        actual_x -= lost[0] / 2000 * moving[0]
        actual_y -= lost[1] / 2000 * moving[1]
        for place, height in enumerate(spike):
            since = np.mod(sign * (angles - place * np.pi / 2), 2 * np.pi)
            size = height / 1000 * np.exp(-since / decay)
            actual_x, actual_y = (
                actual_x + size * np.cos(angles) * (place % 2 == 0),
                actual_y + size * np.sin(angles) * (place % 2 == 1),
            )
        measured = np.hypot(actual_x - centre[0], actual_y - centre[1]) - radius
        runs[direction] = (degrees, measured + vibration(rng, count, sigma / 1000, length))
    effective = sigma * np.sqrt((1 + np.exp(-1 / length)) / (1 - np.exp(-1 / length)))
    return Circle(radius, feed, start, extent, beta, runs, effective)
