"""Virtual axes for `bench_examiner.py`; jobs go through the command line alone.

Each axis has a true error, a reversal and a noise of its own structure. `run` makes its table;
fresh tests of the same axis with this table show whether band and accepted limit are honest.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

Values = npt.NDArray[np.float64]
Noise = Callable[
    [np.random.Generator, int, Values], Values
]  # random numbers, runs, targets -> (direction, run, target)

COMMAND = [sys.executable, "-m", "compwright"]
FRESH_TESTS = 400
TRAVEL = 800.0
SIGNS = ("+", "-")


@dataclass
class Axis:
    """A virtual axis and the test that was made on it; everything in mm and µm."""

    name: str
    error: Callable[[Values], Values]
    reversal: Callable[[Values], Values]
    noise: Noise
    targets: Values
    runs: int = 5
    resolution: float = 0.0
    travel: tuple[float, float] = (0.0, TRAVEL)
    readings: Values = field(default_factory=lambda: np.empty(0))

    def means(self, positions: Values) -> Values:
        """Return the true error in both directions."""
        half = self.reversal(positions) / 2
        return np.array([self.error(positions) + half, self.error(positions) - half])

    def test(
        self, rng: np.random.Generator, targets: Values, corrections: Values | float = 0.0
    ) -> Values:
        """Return a fresh test (direction, run, target) of the axis, with a datum of its own."""
        deviations = (
            (self.means(targets) + corrections)[:, None, :]
            + self.noise(rng, self.runs, targets)
            + rng.normal(0, 2)
        )
        return (
            np.round(deviations / self.resolution) * self.resolution
            if self.resolution
            else deviations
        )


def accuracy(deviations: Values) -> float:
    """Return A of ISO 230-2 with k = 2."""
    mean, spread = deviations.mean(axis=1), 2 * deviations.std(axis=1, ddof=1)
    return float((mean + spread).max() - (mean - spread).min())


def smooth(rng: np.random.Generator, size: float, waves: int = 3) -> Callable[[Values], Values]:
    """Return a slope with a few long waves, `size` µm large."""
    slope, weights, phases = (
        rng.normal(0, size),
        rng.normal(0, size / 3, waves),
        rng.uniform(0, 6.28, waves),
    )
    lengths = TRAVEL / rng.uniform(0.5, 2.5, waves)

    def error(x: Values) -> Values:
        return slope * x / TRAVEL + np.sin(6.2832 * x[:, None] / lengths + phases) @ weights

    return error


def constant(value: float) -> Callable[[Values], Values]:
    """Return a curve of one value."""
    return lambda x: np.full(len(x), value)


def wave(amplitude: float, period: float, phase: float) -> Callable[[Values], Values]:
    """Return a periodic error."""
    return lambda x: amplitude * np.sin(6.2832 * x / period + phase)


def together(*parts: Callable[[Values], Values]) -> Callable[[Values], Values]:
    """Return the sum of curves."""
    return lambda x: np.sum([part(x) for part in parts], axis=0)


def jump(place: float, height: float) -> Callable[[Values], Values]:
    """Return a step."""
    return lambda x: np.where(x > place, height, 0.0)


def scatter(sigma: float, shift: float = 0.0, pattern: str = "run") -> Noise:
    """Return normal scatter, with shifts of runs or traverses; both standard deviations."""

    def noise(rng: np.random.Generator, runs: int, targets: Values) -> Values:
        return (
            rng.normal(0, sigma, (2, runs, len(targets)))
            + shift * shifts(rng, runs, pattern)[:, :, None]
        )

    return noise


def shifts(rng: np.random.Generator, runs: int, pattern: str) -> Values:
    """Return shifts (direction, run) whose standard deviation over the runs is about 1."""
    if pattern == "one":
        values = np.zeros(runs)
        values[rng.integers(runs)] = rng.choice([-1, 1]) * np.sqrt(runs)
    elif pattern == "alternating":
        values = rng.choice([-0.9, 0.9]) * (-1.0) ** np.arange(runs)
    else:
        values = rng.normal(0, 1, runs)
    other = (
        rng.normal(0, 1, runs)
        if pattern == "traverse"
        else -values
        if pattern == "opposite"
        else values
    )
    return np.array([values, other])


def dithered(rng: np.random.Generator, count: int, travel: tuple[float, float]) -> Values:
    """Return new targets as the outside contract states them."""
    low, high = travel
    places = (np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)) * (high - low) / count + low
    return np.clip(places, low + 4, high - 4)


def spread_targets(
    count: int, travel: tuple[float, float] = (0.0, TRAVEL), rng: np.random.Generator | None = None
) -> Values:
    """Return targets: equally spaced, or scattered about it with random numbers."""
    margin = 0.01 * (travel[1] - travel[0])
    places = np.linspace(travel[0] + margin, travel[1] - margin, count)
    if rng is not None:
        places[1:-1] += rng.uniform(-0.3, 0.3, count - 2) * (places[1] - places[0])
    return np.round(places, 3)


def write_test(path: Path, axis: str, targets: Values, readings: Values) -> None:
    """Write the long form."""
    lines = [
        f"# axis: {axis}",
        "# cycle: standard",
        "# deviation: measured minus target",
        "target_mm,direction,run,deviation_um",
    ]
    for run in range(readings.shape[1]):
        for direction, sign in enumerate(SIGNS):
            order = range(len(targets)) if direction == 0 else range(len(targets) - 1, -1, -1)
            lines += [
                f"{targets[i]:.3f},{sign},{run + 1},{readings[direction, run, i]:.4f}"
                for i in order
            ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_job(
    folder: Path, axes: list[Axis], limits: dict[str, float], state: str = "none"
) -> Path:
    """Write the tests and one job for all axes, joints of one control."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = [
        "compwright: 1",
        "controller: {format: linuxcnc}",
        f"states: {{as_found: {state}}}",
        "axes:",
    ]
    for number, axis in enumerate(axes):
        write_test(folder / f"{axis.name}.csv", axis.name, axis.targets, axis.readings)
        lines += [
            f"  {axis.name}:",
            f"    travel: [{axis.travel[0]:g}, {axis.travel[1]:g}]",
            f"    address: {number}",
        ]
        lines += [f"    before: {axis.name}.csv"]
        lines += [f"    accept: {{A: {limits[axis.name]:.3f}}}"] if axis.name in limits else []
    path = folder / "job.yaml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def run(*arguments: object) -> tuple[int, str]:
    """Run a command of compwright; return its exit code and what it said."""
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [*COMMAND, *map(str, arguments)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stderr


def corrections_at(table: dict[str, Any], targets: Values) -> Values:
    """Return what the table adds at targets, in both directions: straight lines, held outside."""
    return np.array(
        [
            np.interp(targets, table["positions"], table[f"correction_{sign}"])
            for sign in ("positive", "negative")
        ]
    )


def fresh(
    axis: Axis, table: Values | dict[str, Any] | None, seed: int, *, new_targets: bool
) -> Values:
    """Return A of fresh tests: with a table, the interpolated means of a test, or nothing."""
    values, rng = [], np.random.default_rng(seed)
    for _ in range(FRESH_TESTS):
        targets = dithered(rng, len(axis.targets), axis.travel) if new_targets else axis.targets
        corrections: Values | float = 0.0
        if isinstance(table, dict):
            corrections = corrections_at(table, targets)
        elif table is not None:
            corrections = -np.array([np.interp(targets, axis.targets, one) for one in table])
        values.append(accuracy(axis.test(rng, targets, corrections)))
    return np.array(values)


def judge(axis: Axis, answer: dict[str, Any], limit: float | None) -> dict[str, Any]:
    """Hold what was predicted for an axis against its fresh tests."""
    result: dict[str, Any] = {
        "axis": axis.name,
        "limit": limit,
        "table": bool(answer.get("table")),
        "own": accuracy(axis.readings - axis.readings.mean(axis=1)[:, None]),
    }
    interpolated = axis.readings.mean(axis=1)
    for key, new in (("predicted", False), ("predicted_new_targets", True)):
        band, values = answer[key]["A"], fresh(axis, answer.get("table"), 5, new_targets=new)
        place = "new" if new else "same"
        result[place] = {
            "band": [round(band[name], 2) for name in ("p05", "median", "p95")],
            "fresh": [round(float(v), 2) for v in np.quantile(values, (0.05, 0.5, 0.95))],
            "inside": float(((values >= band["p05"]) & (values <= band["p95"])).mean()),
            "above": float((values > band["p95"]).mean()),
            "broken": float((values > limit).mean()) if limit else None,
            "ratio": float(values.mean() / fresh(axis, interpolated, 5, new_targets=new).mean()),
        }
    result["decision"] = answer.get("accept", {}).get("A", {}).get("decision")
    result["codes"] = [
        f["code"] for f in answer.get("findings", []) if f["code"].startswith("CW-E")
    ]
    result["messages"] = [
        f["message"] for f in answer.get("findings", []) if f["code"].startswith("CW-E")
    ]
    return result


Scenario = Callable[[np.random.Generator, int], Axis]


def shifted(rng: np.random.Generator, number: int) -> Axis:
    """An axis whose runs are shifted by constants, with next to no scatter inside them."""
    pattern = ("run", "traverse", "one", "alternating", "opposite")[number % 5]
    sigma = (0.0, 0.01, 0.1)[(number // 5) % 3]
    resolution = (0.0, 0.1, 0.5, 1.0)[(number // 15 + number) % 4]
    noise = scatter(sigma, float(rng.choice([0.7, 1.5, 3.0])), pattern)
    runs, targets = (
        int(rng.choice([3, 5, 5, 10])),
        spread_targets(int(rng.choice([11, 17, 25])), rng=rng),
    )
    return Axis("", smooth(rng, 6), constant(-rng.uniform(0, 3)), noise, targets, runs, resolution)


def stepped(rng: np.random.Generator, number: int) -> Axis:
    """An otherwise smooth axis with a jump, at times with a reversal and a period."""
    height = (5.0, 20.0, 100.0)[number % 3] * float(rng.choice([-1, 1]))
    count = int(rng.choice([11, 17, 26, 41]))
    parts = [smooth(rng, 5), jump(float(rng.uniform(60, 740)), height)]
    if number % 4 == 3:
        parts.append(wave(1.5, 10.0, rng.uniform(0, 6.28)))
    sigma = float(rng.choice([0.2, 0.5]))
    return Axis(
        "",
        together(*parts),
        constant(-2.0 * (number % 2)),
        scatter(sigma, sigma),
        spread_targets(count, rng=rng),
    )


def hidden(rng: np.random.Generator, number: int) -> Axis:
    """Few targets, or equally spaced ones, that show a periodic error badly."""
    count = (6, 6, 8, 10, 13)[number % 5]
    period = float(rng.choice([5.0, 8.0, 10.0, 16.0, 20.0, 40.0]))
    parts = [smooth(rng, 5), wave(float(rng.choice([1.0, 2.0, 4.0])), period, rng.uniform(0, 6.28))]
    targets = spread_targets(count, rng=rng if number % 2 else None)
    return Axis("", together(*parts), constant(-1.0), scatter(0.3, 0.3), targets)


def aliased(rng: np.random.Generator, number: int) -> Axis:
    """Two periods that look alike at the targets."""
    count = int(rng.choice([11, 17, 21]))
    targets = spread_targets(count, rng=rng if number % 3 == 0 else None)
    spacing = targets[1] - targets[0]
    first = float(rng.choice([10.0, 20.0, 16.0]))
    second = 1 / abs(1 / first - 1 / spacing)
    parts = [smooth(rng, 4), wave(2.5, first if number % 2 else second, rng.uniform(0, 6.28))]
    return Axis("", together(*parts), constant(-1.0), scatter(0.3, 0.3), targets)


def sound(rng: np.random.Generator, number: int) -> Axis:
    """A usual axis, well measured."""
    count = int(rng.choice([21, 25, 31, 41]))
    parts = [smooth(rng, float(rng.choice([3, 8, 15])))]
    if number % 3 == 0:
        parts.append(
            wave(
                float(rng.uniform(0.5, 3)),
                float(rng.choice([5.0, 10.0, 12.0, 20.0])),
                rng.uniform(0, 6.28),
            )
        )
    sigma = float(rng.choice([0.2, 0.5, 1.0]))
    reversal = together(constant(-float(rng.uniform(0, 5))), smooth(rng, 0.5))
    return Axis(
        "",
        together(*parts),
        reversal,
        scatter(sigma, sigma * float(rng.choice([0.0, 0.5, 1.0]))),
        spread_targets(count, rng=rng),
    )


SCENARIOS: dict[str, Scenario] = {
    "shifted": shifted,
    "stepped": stepped,
    "hidden": hidden,
    "aliased": aliased,
    "sound": sound,
}
