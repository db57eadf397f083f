"""Diagnosis of circular tests over random machines: intervals that hold the truth, variance by its
bound, seconds. Judges nothing.

``python benchmarks/bench_circle.py [MACHINES]`` (2000 by default). The bound is that of Cramér and
Rao for white noise, from finite differences of the exact path over every cause, decay length and
pitch, and over the nuisances that the diagnosis allows for (creep of the ball between the
directions, lateral play that changes along the axis).
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from circle_machine import Machine, Setup, distance, measured, random_machine, truth
from compwright.estimation.circle import diagnose

Array = NDArray[np.float64]
SHAPES = ("decay", "pitch", "phase")


def white(_rng: np.random.Generator) -> Setup:
    return Setup(noise=0.3)


def mixed(rng: np.random.Generator) -> Setup:
    """White and correlated noise, radii and feeds as they come."""
    return Setup(
        noise=0.2 * float(rng.uniform(0.2, 1.0)),
        wander=0.3 * float(rng.uniform()),
        length=float(rng.uniform(3.0, 60.0)),
        radius=float(rng.choice([50.0, 100.0, 150.0, 300.0])),
        feed=float(rng.choice([500.0, 1000.0, 2000.0])),
    )


def bound(machine: Machine, setup: Setup) -> dict[str, float]:
    """Return the least standard deviation of each cause under white noise, in its own unit; of a
    cause that the arc does not show a very large one.
    """
    names = [f.name for f in fields(machine) if f.name != "centre"]
    blocks = []
    for sense in (1.0, -1.0):
        steps = (np.arange(setup.samples) + 0.5) * setup.extent / setup.samples
        theta = np.radians(setup.start + steps)
        here = distance(machine, setup, theta, sense)
        columns = []
        for name in names:
            step = 1e-3
            moved = replace(machine, **{name: getattr(machine, name) + step})
            columns.append((distance(moved, setup, theta, sense) - here) / step)
        cos, sin, um = np.cos(theta), np.sin(theta), 1e-3
        columns += [um * cos, um * sin, um * sense * cos, um * sense * sin]
        columns += [um * sense * np.abs(sin) * cos, um * sense * np.abs(cos) * sin]
        blocks.append(np.column_stack(columns))
    rows = np.vstack(blocks) / (1e-3 * setup.noise)
    unit = np.maximum(np.linalg.norm(rows, axis=0), 1e-12)
    shown = (rows / unit).T @ (rows / unit) + 1e-13 * np.eye(unit.size)
    covariance = np.linalg.inv(shown) / np.outer(unit, unit)
    found = dict(zip(names, np.sqrt(np.diag(covariance)), strict=False))
    combined = {
        f"backlash_{axis}": {f"backlash_{axis}_at_{end}": 0.5 for end in ("positive", "negative")}
        for axis in ("first", "second")
    }
    difference = 2e-3 * setup.radius
    combined["scale_mismatch"] = {
        "scale_error_first": difference,
        "scale_error_second": -difference,
    }
    for name, parts in combined.items():
        weights = np.zeros(len(unit))
        for part, weight in parts.items():
            weights[names.index(part)] = weight
        found[name] = float(np.sqrt(weights @ covariance @ weights))
    return {name: float(value) for name, value in found.items() if not name.startswith(SHAPES)}


def table(count: int, setup_of: Callable[[np.random.Generator], Setup], *, bounded: bool) -> None:
    """Print a row per cause: share inside its 95 % interval, rms and mean error in standard errors,
    variance by its bound.
    """
    scores: dict[str, list[float]] = {}
    ratios: dict[str, list[float]] = {}
    wall, cpu = [], []
    for index in range(count):
        rng = np.random.default_rng([2, index])
        setup = setup_of(rng)
        machine = random_machine(rng, setup.radius)
        test = measured(machine, setup, rng)
        started, used = time.perf_counter(), time.process_time()
        effects = diagnose(test).effects
        wall.append(time.perf_counter() - started)
        cpu.append(time.process_time() - used)
        known = truth(machine, setup)
        known |= {
            name: float(getattr(machine, name))
            for name in effects
            if name.startswith(("reversal_spike", "cyclic"))
        }
        least = bound(machine, setup) if bounded else {}
        for name, value in known.items():
            error = effects[name].value - value
            scores.setdefault(name, []).append(error / effects[name].std_error)
            if bounded:
                ratios.setdefault(name, []).append(error / least[name])
    spread = 1.96 * np.sqrt(0.95 * 0.05 / count)
    print(f"{count} machines; 0.95 ± {spread:.3f} is expected of a right interval")
    print(
        f"seconds of 2 x 1500 samples, median and 95 %: wall {np.median(wall):.3f}"
        f" {np.quantile(wall, 0.95):.3f}, processor {np.median(cpu):.3f}"
        f" {np.quantile(cpu, 0.95):.3f}; wanted below 0.050"
    )
    for name, values in scores.items():
        z = np.array(values)
        line = (
            f"  {name:28} inside {np.mean(np.abs(z) < 1.96):.3f}  rms {np.sqrt(np.mean(z**2)):.2f} "
            f" mean {np.mean(z):+.2f}"
        )
        if bounded:
            line += f"  variance / bound {np.mean(np.square(ratios[name])):.2f}"
        print(line)


def main() -> None:
    """Print the tables for white noise, with the bound, and for white and correlated noise."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    print("white noise of 0.3 µm")
    table(count, white, bounded=True)
    print("white and correlated noise")
    table(count, mixed, bounded=False)


if __name__ == "__main__":
    main()
